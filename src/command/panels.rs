//! Which curves a person would look at, and which of them share a panel.
//!
//! Drawn are the outputs that the model names, the positions and velocities of slides, and the
//! angles of links as deflections from the start; rates of links where there is no slide; internal
//! states (a bristle's deflection) last. Curves share a panel when they have the same kind and unit
//! and a similar size: a curve that a larger one would flatten gets a panel of its own.

use std::sync::Arc;

use flexure::picture::{self, Axis, Chart, Look, Series, number};

/// A column of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name: `stage.x`.
    pub name: String,
    /// SI unit.
    pub unit: String,
    /// Whether it is an output; else it is a state.
    pub output: bool,
    /// Values, one per row.
    pub values: Vec<f64>,
}

const MOST_PANELS: usize = 6;
/// Colours of pictures.
const COLOURS: usize = 6;
/// Fewer than there are colours.
const MOST_CURVES: usize = 4;
/// A curve this much smaller than the largest of its panel could not be read there.
const READABLE: f64 = 1.0 / 5.0;
/// Angles that move more than this, in rad, are shown as they are, in degrees.
const LARGE_ANGLE: f64 = 0.5;

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Position,
    Velocity,
    Angle,
    AngularRate,
    Other,
    Internal,
}

struct Candidate {
    kind: Kind,
    title: String,
    unit: String,
    name: String,
    output: bool,
    values: Vec<f64>,
}

/// The chart of a run, its panels in the order from top to bottom.
pub fn chart(title: &str, time: &[f64], columns: &[Column]) -> Chart {
    let time: Arc<[f64]> = time.into();
    Chart {
        title: title.to_owned(),
        x: Axis::linear("time", "s"),
        panels: choose(&time, columns),
        ordered: false,
    }
}

fn choose(time: &Arc<[f64]>, columns: &[Column]) -> Vec<picture::Panel> {
    let candidates = candidates(columns);
    let mut groups: Vec<(Kind, bool, Vec<Candidate>)> = Vec::new();
    for candidate in candidates {
        let fits = groups.iter_mut().find(|(_, _, group)| {
            group[0].title == candidate.title && group[0].unit == candidate.unit
        });
        match fits {
            Some((_, output, group)) => {
                *output |= candidate.output;
                group.push(candidate);
            }
            None => groups.push((candidate.kind, candidate.output, vec![candidate])),
        }
    }
    groups.sort_by_key(|(kind, _, _)| *kind);
    let mut panels: Vec<(bool, Kind, picture::Panel)> = Vec::new();
    for (kind, _, group) in groups {
        for cluster in clusters(group) {
            let output = cluster.iter().any(|candidate| candidate.output);
            panels.push((output, kind, panel(time, cluster)));
        }
    }
    while panels.len() > MOST_PANELS {
        // What nobody asked for goes first, from the least important kind.
        let least = (0..panels.len())
            .max_by_key(|&k| (!panels[k].0, panels[k].1, k))
            .unwrap_or(0);
        panels.remove(least);
    }
    let mut panels: Vec<picture::Panel> = panels.into_iter().map(|(_, _, panel)| panel).collect();
    colour(&mut panels);
    panels
}

/// Gives each owner (`stage` of `stage.x`) a colour of its own, as far as colours go; within a
/// panel no two curves share one.
fn colour(panels: &mut [picture::Panel]) {
    let mut owners: Vec<String> = Vec::new();
    for panel in panels {
        let mut taken = Vec::new();
        for curve in &mut panel.series {
            let measure = curve.name.rsplit(" = ").next().unwrap_or("");
            let owner = measure.split(['.', ' ']).next().unwrap_or("");
            let known = owners.iter().position(|known| known == owner);
            let mut colour = known.unwrap_or_else(|| {
                owners.push(owner.to_owned());
                owners.len() - 1
            }) % COLOURS;
            while taken.contains(&colour) {
                colour = (colour + 1) % COLOURS;
            }
            taken.push(colour);
            curve.colour = Some(colour);
        }
    }
}

fn candidates(columns: &[Column]) -> Vec<Candidate> {
    let has_slides = columns
        .iter()
        .any(|column| !column.output && kind_of(column) == Kind::Position);
    let mut candidates: Vec<Candidate> = Vec::new();
    for column in columns.iter().filter(|column| !column.output) {
        let kind = kind_of(column);
        if kind == Kind::AngularRate && has_slides {
            continue;
        }
        candidates.push(candidate(column, kind));
    }
    for column in columns.iter().filter(|column| column.output) {
        let same = columns
            .iter()
            .filter(|other| !other.output)
            .find(|state| state.unit == column.unit && same_values(&state.values, &column.values));
        // An output that repeats a state is one curve under both names.
        if let Some(state) = same {
            let drawn = candidates
                .iter_mut()
                .find(|candidate| candidate.name == state.name && !candidate.output);
            if let Some(drawn) = drawn {
                if column.name != state.name {
                    drawn.name = format!("{} = {}", column.name, state.name);
                }
                drawn.output = true;
                continue;
            }
        }
        candidates.push(candidate(column, kind_of(column)));
    }
    candidates.retain(|candidate| candidate.values.iter().any(|value| value.is_finite()));
    candidates
}

fn candidate(column: &Column, kind: Kind) -> Candidate {
    let (title, unit, values) = match kind {
        Kind::Angle => angle(column),
        _ => (
            title_of(column, kind),
            column.unit.clone(),
            column.values.clone(),
        ),
    };
    let start = column.values.first().copied().unwrap_or(0.0);
    let name = if title == DEFLECTION && start != 0.0 {
        let from = number(start.to_degrees(), 6);
        format!("{} from {from}°", column.name)
    } else {
        column.name.clone()
    };
    Candidate {
        kind,
        title,
        unit,
        name,
        output: column.output,
        values,
    }
}

const DEFLECTION: &str = "Deflection";
const DEGREES: &str = "°";

fn angle(column: &Column) -> (String, String, Vec<f64>) {
    let start = column.values.first().copied().unwrap_or(0.0);
    let farthest = largest(column.values.iter().map(|value| value - start));
    if farthest > LARGE_ANGLE {
        let degrees = column.values.iter().map(|v| v.to_degrees()).collect();
        ("Angle".to_owned(), DEGREES.to_owned(), degrees)
    } else {
        let deflections = column.values.iter().map(|v| v - start).collect();
        (DEFLECTION.to_owned(), "rad".to_owned(), deflections)
    }
}

fn kind_of(column: &Column) -> Kind {
    let measure = column.name.rsplit('.').next().unwrap_or("");
    match (column.output, column.unit.as_str(), measure) {
        (true, "m", _) | (false, "m", "x" | "y" | "travel") => Kind::Position,
        (true, "m/s", _) | (false, _, "v") => Kind::Velocity,
        (true, "rad", _) | (false, _, "angle") => Kind::Angle,
        (true, "rad/s", _) | (false, _, "rate") => Kind::AngularRate,
        (true, _, _) => Kind::Other,
        (false, _, _) => Kind::Internal,
    }
}

fn title_of(column: &Column, kind: Kind) -> String {
    let title = match (kind, column.unit.as_str()) {
        (Kind::Internal, _) => "Internal state",
        (_, "m") => "Position",
        (_, "m/s") => "Velocity",
        (_, "m/s^2") => "Acceleration",
        (_, "rad") => "Angle",
        (_, "rad/s") => "Angular rate",
        (_, "N") => "Force",
        (_, "N*m") => "Torque",
        (_, "J") => "Energy",
        (_, "W") => "Power",
        (_, "V") => "Voltage",
        (_, "Pa") => "Stress",
        (_, "s") => "Time",
        (_, "Hz") => "Frequency",
        _ => return column.name.clone(),
    };
    title.to_owned()
}

fn same_values(a: &[f64], b: &[f64]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.to_bits() == b.to_bits())
}

/// Splits curves of one kind by size; within a part they keep their order.
fn clusters(group: Vec<Candidate>) -> Vec<Vec<Candidate>> {
    let size = |candidate: &Candidate| largest(candidate.values.iter().copied());
    let mut by_size: Vec<(usize, f64)> = group.iter().map(size).enumerate().collect();
    by_size.sort_by(|a, b| b.1.total_cmp(&a.1));
    let mut parts: Vec<(f64, Vec<usize>)> = Vec::new();
    for (index, size) in by_size {
        match parts.last_mut() {
            // A curve that stays at zero is as well read with any other.
            Some((top, part))
                if part.len() < MOST_CURVES && (size == 0.0 || size >= READABLE * *top) =>
            {
                part.push(index);
            }
            _ => parts.push((size, vec![index])),
        }
    }
    let mut slots: Vec<Option<Candidate>> = group.into_iter().map(Some).collect();
    parts
        .into_iter()
        .map(|(_, mut part)| {
            part.sort_unstable();
            part.into_iter().filter_map(|k| slots[k].take()).collect()
        })
        .collect()
}

fn panel(time: &Arc<[f64]>, cluster: Vec<Candidate>) -> picture::Panel {
    let y = Axis::linear(cluster[0].title.clone(), cluster[0].unit.clone());
    let series = cluster
        .into_iter()
        .map(|candidate| Series::new(candidate.name, time.clone(), candidate.values, Look::Line));
    picture::Panel {
        y,
        series: series.collect(),
        ..picture::Panel::default()
    }
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values
        .filter(|value| value.is_finite())
        .fold(0.0, |largest, value| f64::max(largest, value.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn column(name: &str, unit: &str, output: bool, values: &[f64]) -> Column {
        Column {
            name: name.to_owned(),
            unit: unit.to_owned(),
            output,
            values: values.to_vec(),
        }
    }

    fn choose(columns: &[Column]) -> Vec<picture::Panel> {
        chart("", &[0.0, 1.0], columns).panels
    }

    fn names(panel: &picture::Panel) -> Vec<&str> {
        panel.series.iter().map(|c| c.name.as_str()).collect()
    }

    #[test]
    fn an_actuator_gets_positions_velocities_and_deflections() {
        let panels = choose(&[
            column("crank.angle", "rad", false, &[1.396, 1.397]),
            column("crank.rate", "rad/s", false, &[0.0, 20.0]),
            column("stack.x", "m", false, &[0.0, 19e-6]),
            column("stack.v", "m/s", false, &[0.0, 0.4]),
            column("stage.x", "m", false, &[0.0, 80e-6]),
            column("stage.v", "m/s", false, &[0.0, 9e-3]),
            column("tip.z", "m", false, &[0.0, 3e-7]),
            column("speed", "m/s", true, &[0.0, 9e-3]),
        ]);
        let titles: Vec<_> = panels
            .iter()
            .map(|p| format!("{} {}", p.y.label, p.y.unit))
            .collect();
        assert_eq!(
            titles,
            [
                "Position m",
                "Velocity m/s",
                "Velocity m/s",
                "Deflection rad",
                "Internal state m"
            ]
        );
        assert_eq!(names(&panels[0]), ["stack.x", "stage.x"]);
        assert_eq!(names(&panels[2]), ["speed = stage.v"]);
        assert_eq!(panels[3].series[0].y[0], 0.0);
    }

    #[test]
    fn a_crank_that_turns_is_shown_in_degrees() {
        let panels = choose(&[
            column("arm.angle", "rad", false, &[0.0, 30.0]),
            column("arm.rate", "rad/s", false, &[0.0, 3.0]),
        ]);
        assert_eq!(panels[0].y.unit, "°");
        assert_eq!(panels[1].y.label, "Angular rate");
    }

    #[test]
    fn never_many_lines_in_one_panel_nor_many_panels() {
        let columns: Vec<_> = (0..40)
            .map(|k| column(&format!("s{k}.x"), "m", false, &[0.0, 1.0]))
            .chain((0..40).map(|k| column(&format!("o{k}"), "N", true, &[0.0, 2.0])))
            .collect();
        let panels = choose(&columns);
        assert_eq!(panels.len(), MOST_PANELS);
        assert!(panels.iter().all(|p| p.series.len() <= MOST_CURVES));
        assert!(panels.iter().all(|p| p.y.label == "Force"));
    }

    #[test]
    fn columns_without_a_number_are_left_out() {
        assert!(choose(&[column("a.x", "m", false, &[f64::NAN])]).is_empty());
        assert!(choose(&[column("a.x", "m", false, &[])]).is_empty());
    }
}
