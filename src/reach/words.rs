//! Ranges and transmission angles in words.

use flexure_model_dsl::equations::{Equations, State};
use flexure_runtime::failure::{Unit, quantity};

use super::{Approach, FARTHEST, Limit, Reach};

/// A loop whose closure varies by less than this does not follow the coordinate.
const STANDS: f64 = 1e-9;

/// A dead point that is touched, not passed, is known to this, in rad.
const TOUCH_WIDTH: f64 = 1e-6;

/// What is to be said of each reach, and of each loop that has a transmission angle.
pub fn facts(equations: &Equations, reaches: &[Reach]) -> Vec<(String, String)> {
    let ranges = reaches
        .iter()
        .map(|reach| ("range".to_owned(), range(equations, reach)));
    let angles = (0..equations.loops.len()).filter_map(|index| {
        let words = transmission(equations, reaches, index)?;
        Some(("transmission angle".to_owned(), words))
    });
    ranges.chain(angles).collect()
}

fn range(equations: &Equations, reach: &Reach) -> String {
    let state = &equations.states[reach.state];
    let name = &state.name;
    let dead = |loops: &[usize]| {
        let names: Vec<&str> = loops
            .iter()
            .map(|&index| equations.loops[index].name.as_str())
            .collect();
        let plural = if names.len() > 1 { "s" } else { "" };
        let together = if names.len() > 1 { " together" } else { "" };
        format!(
            "dead point of the loop{plural} {}{together}",
            names.join(", ")
        )
    };
    match (&reach.lower, &reach.upper) {
        (Limit::None, Limit::None) if state.unit == "rad" => format!("{name} turns all round"),
        (Limit::None, Limit::None) => {
            format!("{name} has no dead point within {FARTHEST} times the mechanism's size")
        }
        (Limit::DeadPoint(from, one), Limit::DeadPoint(to, other)) if one == other => format!(
            "{name} from {} to {}, each a {}",
            shown(state, *from),
            shown(state, *to),
            dead(one)
        ),
        (Limit::DeadPoint(from, one), Limit::DeadPoint(to, other)) => format!(
            "{name} from {}, a {}, to {}, a {}",
            shown(state, *from),
            dead(one),
            shown(state, *to),
            dead(other)
        ),
        (Limit::DeadPoint(from, loops), Limit::None) => {
            format!("{name} from {}, a {}", shown(state, *from), dead(loops))
        }
        (Limit::None, Limit::DeadPoint(to, loops)) => {
            format!("{name} to {}, a {}", shown(state, *to), dead(loops))
        }
    }
}

/// As assembled, and where it is least along each coordinate that moves the loop.
fn transmission(equations: &Equations, reaches: &[Reach], index: usize) -> Option<String> {
    let closed = &equations.loops[index];
    if !closed.has_transmission_angle {
        return None;
    }
    let approaches: Vec<(&Reach, &Approach)> = reaches
        .iter()
        .filter_map(|reach| Some((reach, reach.approaches.get(index)?)))
        .collect();
    let (_, first) = approaches.first()?;
    let mut words = format!(
        "{} {} as assembled",
        closed.name,
        quantity(first.assembled_angle(), Unit::Degree)
    );
    let moving = approaches
        .iter()
        .filter(|(_, approach)| approach.greatest - approach.least > STANDS);
    for (reach, approach) in moving {
        let state = &equations.states[reach.state];
        if approach.least > 0.0 {
            words.push_str(&format!(
                ", least {} at {} = {}",
                quantity(approach.least_angle(), Unit::Degree),
                state.name,
                shown(state, approach.at)
            ));
        } else {
            words.push_str(&format!(", 0° at the dead points of {}", state.name));
        }
    }
    Some(words)
}

fn shown(state: &State, value: f64) -> String {
    let unit = if state.unit == "rad" {
        Unit::Degree
    } else {
        Unit::Metre
    };
    let is_rounding = unit == Unit::Degree && value.abs() < TOUCH_WIDTH;
    quantity(if is_rounding { 0.0 } else { value }, unit)
}
