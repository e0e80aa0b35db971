//! Equations made by hand: a crank with a rod whose end slides, driven by a sawtooth and held by a
//! spring that is relaxed where a Newton block says.
//!
//! Small, and yet it has one of everything that equations may have: a direction that the geometry
//! knows, a turn reference, a kink, an event that stops the run, an input, a Newton block, checks.

use flexure_model_dsl::equations::*;
use flexure_model_dsl::model::{Input, Param, ParamSet};
use flexure_model_dsl::source::Span;
use flexure_model_dsl::symbolic::{Expr, Function, Graph, Symbol};
use flexure_model_dsl::units::Dimension;

fn param(g: &mut Graph, name: &str, numerator: i64, denominator: i64) -> (Param, Expr) {
    let symbol = g.symbol(name, name);
    let default = g.ratio(numerator, denominator);
    let param = Param {
        name: name.to_owned(),
        symbol,
        default,
        dimension: Dimension::default(),
        doc: format!("the \"{name}\" of the crank"),
        span: Span::default(),
    };
    (param, g.of(symbol))
}

fn value(symbol: Symbol, value: Expr, meaning: &str) -> Definition {
    Definition::Value {
        symbol,
        value,
        meaning: meaning.to_owned(),
    }
}

/// The equations.
pub fn slider_crank() -> Equations {
    let mut graph = Graph::new();
    let g = &mut graph;
    let time = g.symbol("t", "t");
    let (r_param, r) = param(g, "r", 1, 10);
    let (l_param, l) = param(g, "l", 3, 10);
    let (m_param, m) = param(g, "type", 1, 2);
    let (k_param, k) = param(g, "E", 5, 1);
    let (f_param, f) = param(g, "e", 20, 1);
    let (beta_param, beta) = param(g, "β", 1, 5);
    let torque = g.symbol("u", "u");
    let torque_value = g.of(torque);
    let cycle = g.symbol("n", "n");
    let n = g.of(cycle);
    let reference = g.symbol("φ2 reference", "r_2");
    let angle = g.symbol("φ1", "\\varphi_1");
    let rate = g.symbol("ω", "\\omega");
    let (phi, omega) = (g.of(angle), g.of(rate));

    // Rod: r sin φ1 + l sin φ2 = 0.
    let sin_phi = g.sin(phi);
    let ratio = g.div(r, l);
    let sin_2 = g.mul(ratio, sin_phi);
    let sin_2 = g.neg(sin_2);
    let square = g.powi(sin_2, 2);
    let one = g.one();
    let under = g.sub(one, square);
    let cos_2 = g.sqrt(under);
    let phi_2 = g.symbol("φ2", "\\varphi_2");
    let direction = g.atan2(sin_2, cos_2);
    let reference_value = g.of(reference);
    let unwrapped = g.function(Function::Unwrap, &[direction, reference_value]);
    let phi_2_value = g.of(phi_2);

    let cos_phi = g.cos(phi);
    let rod_rate = g.mul(ratio, cos_phi);
    let rod_rate = g.div(rod_rate, cos_2);
    let rod_rate = g.neg(rod_rate);

    // Where the spring is relaxed: θ + sin θ / 2 = β.
    let relaxed = g.symbol("θ", "\\theta");
    let theta = g.of(relaxed);
    let sin_theta = g.sin(theta);
    let half = g.ratio(1, 2);
    let half_sin = g.mul(half, sin_theta);
    let lifted = g.symbol("lifted", "lifted");
    let lifted_value = g.of(lifted);
    let residual = g.sub(lifted_value, beta);
    let lifted_definition = g.add(theta, half_sin);

    let inertia = g.symbol("J", "J");
    let r2 = g.powi(r, 2);
    let inertia_value = g.mul(m, r2);
    let inertia_of = g.of(inertia);
    let now = g.of(time);
    let phase = g.mul(now, f);
    let phase = g.sub(phase, n);
    let drive = g.mul(phase, k);

    let relative = g.sub(phi_2_value, phi);
    let relative = g.add(relative, beta);
    let cos_relative = g.cos(relative);
    let gravity = g.mul(m, r);
    let gravity = g.mul(gravity, cos_relative);
    let stretch = g.sub(phi, theta);
    let spring = g.mul(k, stretch);
    let lever = g.function(Function::CosDifference, &[phi, theta]);
    let lever = g.mul(lever, m);
    let every = every_function(g, phi, omega, torque_value);
    let everything = g.sum(&every);
    let level = g.symbol("level", "level");
    let level_value = g.of(level);
    let table = g.table(vec![0.25, -1.5, 2.0]);
    let next_level = g.function(table, &[n]);
    let sum = g.sum(&[drive, torque_value, lever, level_value, everything]);
    let force = g.sub(sum, gravity);
    let force = g.sub(force, spring);
    let acceleration = g.div(force, inertia_of);

    let next = g.add(n, one);
    let next_time = g.div(next, f);
    let limit = g.integer(3);
    let beyond = g.sub(phi, limit);
    let omega2 = g.powi(omega, 2);
    let kinetic = g.product(&[half, inertia_of, omega2]);
    let stretch2 = g.powi(stretch, 2);
    let potential = g.product(&[half, k, stretch2]);
    let zero = g.zero();
    let supplied = g.mul(torque_value, omega);
    let rod_margin = g.sub(l, r);
    let back = g.neg(omega);
    let x_end = {
        let cos_phi = g.cos(phi);
        let a = g.mul(r, cos_phi);
        let cos = g.cos(phi_2_value);
        let b = g.mul(l, cos);
        g.add(a, b)
    };
    let start = g.integer(0);

    Equations {
        name: "slider_crank_by_hand".to_owned(),
        doc: "A crank with a rod.".to_owned(),
        time,
        params: vec![r_param, l_param, m_param, k_param, f_param, beta_param],
        sets: vec![ParamSet {
            name: "long".to_owned(),
            doc: "a longer rod".to_owned(),
            values: vec![(1, one)],
        }],
        inputs: vec![Input {
            name: "motor".to_owned(),
            symbol: torque,
            start: zero,
            rate: None,
            dimension: Dimension::default(),
            doc: "torque on the crank".to_owned(),
        }],
        definitions: vec![
            value(inertia, inertia_value, "inertia"),
            Definition::Solve(Box::new(Solve {
                name: "the relaxed angle".to_owned(),
                unknowns: vec![relaxed],
                guesses: vec![beta],
                definitions: vec![(lifted, lifted_definition)],
                residuals: vec![residual],
                scales: vec![one],
                failure: Failure {
                    message: "no relaxed angle for {0}".to_owned(),
                    hint: None,
                    site: None,
                    related: Vec::new(),
                    values: vec![Shown {
                        value: beta,
                        unit: ShownUnit::Degree,
                    }],
                },
            })),
            value(phi_2, unwrapped, "angle of the rod"),
        ],
        partials: vec![Partial {
            symbol: phi_2,
            state: angle,
            value: rod_rate,
        }],
        directions: vec![Direction {
            angle: phi_2,
            cos: cos_2,
            sin: sin_2,
        }],
        states: vec![
            State {
                name: "crank.angle".to_owned(),
                unit: "rad".to_owned(),
                meaning: "angle of the crank".to_owned(),
                symbol: angle,
                initial: theta,
                rate: omega,
                coordinate: Some(Coordinate {
                    assembled: theta,
                    leads_loops: true,
                }),
            },
            State {
                name: "crank.rate".to_owned(),
                unit: "rad/s".to_owned(),
                meaning: "its rate".to_owned(),
                symbol: rate,
                initial: start,
                rate: acceleration,
                coordinate: None,
            },
        ],
        discretes: vec![
            Discrete {
                name: "drive.cycle".to_owned(),
                meaning: "periods completed".to_owned(),
                symbol: cycle,
                initial: zero,
                accepted: None,
                turning: false,
            },
            Discrete {
                name: "drive.level".to_owned(),
                meaning: "torque of the present period".to_owned(),
                symbol: level,
                initial: half,
                accepted: None,
                turning: false,
            },
            Discrete {
                name: "rod.reference".to_owned(),
                meaning: "angle of the rod after the last step".to_owned(),
                symbol: reference,
                initial: direction,
                accepted: Some(phi_2_value),
                turning: true,
            },
        ],
        periodic: Vec::new(),
        kinks: vec![Kink {
            name: "drive".to_owned(),
            next: next_time,
            updates: vec![(0, next), (1, next_level)],
            jumps: true,
        }],
        events: vec![Event {
            name: "crank too far".to_owned(),
            function: beyond,
            state_updates: vec![(1, back)],
            discrete_updates: vec![],
            stop: Some("the crank left its range".to_owned()),
        }],
        outputs: std::iter::once(Output {
            name: "slider.x".to_owned(),
            unit: "m".to_owned(),
            meaning: "where the rod ends".to_owned(),
            value: x_end,
        })
        .chain(
            Function::ALL
                .iter()
                .zip(every)
                .map(|(function, value)| Output {
                    name: function.name().to_owned(),
                    unit: "1".to_owned(),
                    meaning: String::new(),
                    value,
                }),
        )
        .collect(),
        energy: Energy {
            kinetic,
            potential,
            dissipated_power: zero,
            supplied_power: supplied,
        },
        loops: vec![Loop {
            name: "crank–rod".to_owned(),
            closure: under,
            has_transmission_angle: false,
        }],
        checks: vec![Check {
            margin: rod_margin,
            zero_is_well: false,
            failure: Failure {
                message: "the rod of {0} is shorter than the crank".to_owned(),
                hint: Some("make it longer than {1}".to_owned()),
                site: None,
                related: Vec::new(),
                values: vec![
                    Shown {
                        value: l,
                        unit: ShownUnit::Metre,
                    },
                    Shown {
                        value: r,
                        unit: ShownUnit::Metre,
                    },
                ],
            },
        }],
        warnings: vec![],
        report: vec![],
        summary: vec![],
        drawing: Drawing::default(),
        moving: Drawing::default(),
        graph,
    }
}

/// Each function once, of arguments for which all of them have a value and a derivative.
fn every_function(g: &mut Graph, phi: Expr, omega: Expr, torque: Expr) -> Vec<Expr> {
    let half = g.ratio(1, 2);
    let quarter = g.ratio(1, 4);
    let small = g.mul(quarter, phi);
    let a = g.add(half, small);
    let bounded = g.function(Function::Tanh, &[omega]);
    let b = g.mul(half, bounded);
    let b = g.add(b, half);
    let c = g.mul(quarter, torque);
    Function::ALL
        .iter()
        .map(|function| {
            let arguments = match function {
                Function::IfPositive => [c, a, b],
                _ => [a, b, c],
            };
            g.function(*function, &arguments[..function.arity()])
        })
        .collect()
}
