//! The independent formulation by itself: the article's free four-bar written out by hand, without
//! parser or resolution, against the article's check values and against the conservation of energy.

#[path = "support/multipliers/mod.rs"]
mod multipliers;

use flexure_model_dsl::model::{
    Body, BodyKind, GROUND, Guess, Hinge, Link, Local, Mass, Model, Param, Pin, Start,
};
use flexure_model_dsl::source::{Source, Span};
use flexure_model_dsl::symbolic::{Expr, Graph};
use multipliers::{Mechanism, Surroundings};

/// Numbers of the model become params, so that no value is rounded on the way.
struct Writer {
    graph: Graph,
    params: Vec<Param>,
    values: Vec<f64>,
}

impl Writer {
    fn number(&mut self, value: f64) -> Expr {
        let name = format!("p{}", self.values.len());
        let symbol = self.graph.symbol(name.clone(), name.clone());
        self.params.push(Param {
            name,
            symbol,
            default: self.graph.zero(),
            dimension: Default::default(),
            doc: String::new(),
            span: Span::default(),
        });
        self.values.push(value);
        self.graph.of(symbol)
    }

    fn link(&mut self, name: &str, length: f64, angle: f64, exact: bool, mass: f64) -> Body {
        let center = Local::Cartesian(self.number(0.5 * length), self.number(0.0));
        Body {
            name: name.to_owned(),
            kind: BodyKind::Link(Link {
                symbol: None,
                length: self.number(length),
                angle: Guess {
                    value: Some(self.number(angle)),
                    exact,
                    span: Span::default(),
                },
                first: String::new(),
                second: String::new(),
            }),
            masses: vec![Mass {
                mass: self.number(mass),
                center,
                inertia: self.number(mass * length * length / 12.0),
                span: Span::default(),
            }],
            span: Span::default(),
        }
    }

    fn pin(&mut self, name: &str, members: [(usize, f64); 2]) -> Pin {
        Pin {
            name: name.to_owned(),
            members: members
                .iter()
                .map(|&(body, x)| (body, Local::Cartesian(self.number(x), self.number(0.0))))
                .collect(),
            span: Span::default(),
        }
    }
}

/// The free four-bar of the article: slender bars, hinges relaxed as assembled, gravity.
fn four_bar() -> (Model, Vec<f64>) {
    let mut writer = Writer {
        graph: Graph::new(),
        params: Vec::new(),
        values: Vec::new(),
    };
    let time = writer.graph.symbol("t", "t");
    let (l1, l2, l3, l4) = (10.2e-3, 23.2e-3, 10e-3, 25e-3);
    let crank = writer.link("crank", l1, 80f64.to_radians(), true, 0.2568e-3);
    let coupler = writer.link("coupler", l2, 0.0, false, 0.5877e-3);
    let rocker = writer.link("rocker", l3, 90f64.to_radians(), false, 0.2529e-3);
    let ground = Body {
        name: "ground".to_owned(),
        kind: BodyKind::Ground,
        masses: Vec::new(),
        span: Span::default(),
    };
    let pins = vec![
        writer.pin("O1", [(GROUND, 0.0), (1, 0.0)]),
        writer.pin("B", [(1, l1), (2, 0.0)]),
        writer.pin("D", [(2, l2), (3, l3)]),
        writer.pin("O2", [(GROUND, l4), (3, 0.0)]),
    ];
    let hinges = [(GROUND, 1), (1, 2), (2, 3), (GROUND, 3)]
        .iter()
        .enumerate()
        .map(|(pin, &bodies)| Hinge {
            name: pins[pin].name.clone(),
            pin,
            bodies,
            stiffness: Some(writer.number(42.10362726661852)),
            damping: None,
            rest: None,
            span: Span::default(),
        })
        .collect();
    let gravity = [writer.number(0.0), writer.number(-9.81)];
    let model = Model {
        name: "four_bar".to_owned(),
        doc: String::new(),
        source: Source::default(),
        graph: writer.graph,
        time,
        params: writer.params,
        lets: Vec::new(),
        sets: Vec::new(),
        inputs: Vec::new(),
        drives: Vec::new(),
        bodies: vec![ground, crank, coupler, rocker],
        pins,
        points: Vec::new(),
        hinges,
        springs: Vec::new(),
        contacts: Vec::new(),
        loads: Vec::new(),
        conditions: Vec::new(),
        gravity: Some(gravity),
        coordinates: Vec::new(),
        initial: Vec::new(),
        start: Start::Assembled,
        outputs: Vec::new(),
        stops: Vec::new(),
        measures: Vec::new(),
        files: Vec::new(),
        notes: Vec::new(),
    };
    (model, writer.values)
}

#[test]
fn the_article_s_four_bar() {
    let (model, params) = four_bar();
    let mechanism = Mechanism::new(&model, &params);
    let assembly = mechanism.assemble(&[1]).unwrap();
    let q = assembly.positions.clone();
    let v = mechanism.velocities(&assembly, &q, &[1.0]).unwrap();
    // x, y, θ of ground, crank, coupler and rocker.
    let close = |what: &str, value: f64, expected: f64, tolerance: f64| {
        let error = (value - expected).abs() / expected.abs();
        assert!(
            error < tolerance,
            "{what}: {value:e}, expected {expected:e}"
        );
    };
    close("φ1", q[5].to_degrees(), 80.0, 1e-14);
    close("φ2", q[8].to_degrees(), -0.11133329253407, 1e-11);
    close("φ3", q[11].to_degrees(), 180.0 - 89.83480236430641, 1e-13);
    close("ω2", v[8], -0.07759427852596, 1e-11);
    close("ω3", v[11], 1.00485788482694, 1e-13);
    let energies = mechanism.energies(&assembly, &Surroundings::default(), &q, &v);
    close("A", 2.0 * energies.kinetic, 7.7343848191656e-8, 1e-12);
}

/// Along φ1(t) with the acceleration found, the energy's rate vanishes.
#[test]
fn accelerations_conserve_energy() {
    let (model, params) = four_bar();
    let mechanism = Mechanism::new(&model, &params);
    let assembly = mechanism.assemble(&[1]).unwrap();
    let at = Surroundings::default();
    for (angle, rate) in [(1.39, 20.0), (1.5, -300.0), (1.2, 700.0)] {
        let q = mechanism.configuration(&assembly, &[angle]).unwrap();
        let v = mechanism.velocities(&assembly, &q, &[rate]).unwrap();
        let motion = mechanism.accelerations(&assembly, &at, &q, &v).unwrap();
        let acceleration = motion.coordinates[0];
        let energy = |h: f64| {
            let moved = angle + rate * h + 0.5 * acceleration * h * h;
            let q = mechanism.beside(&assembly, &q, &[moved]).unwrap();
            let v = mechanism
                .velocities(&assembly, &q, &[rate + acceleration * h])
                .unwrap();
            let energies = mechanism.energies(&assembly, &at, &q, &v);
            energies.kinetic + energies.potential
        };
        let h = 1e-7;
        let (wide, narrow) = (
            (energy(2.0 * h) - energy(-2.0 * h)) / (4.0 * h),
            (energy(h) - energy(-h)) / (2.0 * h),
        );
        let slope = (4.0 * narrow - wide) / 3.0;
        // Against the power of one of the two halves that cancel.
        let inertia = 2.0 * mechanism.energies(&assembly, &at, &q, &v).kinetic / (rate * rate);
        let power = (inertia * acceleration * rate).abs();
        assert!(slope.abs() < 1e-7 * power, "{slope:e} of {power:e}");
        assert!(motion.condition < 1e6, "condition {:e}", motion.condition);
    }
}
