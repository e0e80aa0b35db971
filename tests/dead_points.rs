//! Dead points: where they are and when a motion comes to one, against closed forms and against
//! the same mechanism led by another coordinate, which passes the place without trouble.

use flexure::runtime::simulate::BreakdownKind;
use flexure::{Limit, Model, Reach, simulate};

fn model(text: &str) -> Model {
    Model::from_source("test.flex", text).unwrap_or_else(|why| panic!("{why}\n{text}"))
}

fn four_bar(lengths: [f64; 4], coupler: f64, rocker: f64) -> String {
    let [l1, l2, l3, l4] = lengths;
    format!(
        "model test
ground O1 = (0 mm, 0 mm)
ground O2 = ({l4} mm, 0 mm)
link crank from O1 to B {{ length = {l1} mm, angle = 50 deg exact, mass = 5 g }}
link coupler from B to D {{ length = {l2} mm, angle = {coupler} deg, mass = 5 g }}
link rocker from O2 to D {{ length = {l3} mm, angle = {rocker} deg, mass = 5 g }}
coordinate crank.angle
"
    )
}

fn reach(text: &str) -> Vec<Reach> {
    let model = model(text);
    model.design().assembled().unwrap().reach()
}

/// Values and loops of both ends.
fn ends(reach: &Reach) -> [(f64, &[usize]); 2] {
    [&reach.lower, &reach.upper].map(|limit| match limit {
        Limit::DeadPoint(at, loops) => (*at, loops.as_slice()),
        Limit::None => panic!("no dead point: {reach:?}"),
    })
}

#[track_caller]
fn near(value: f64, expected: f64, tolerance: f64) {
    assert!(
        (value - expected).abs() <= tolerance,
        "{value} is not {expected}"
    );
}

#[test]
fn a_double_rocker_reaches_the_angles_of_the_cosine_theorem() {
    // Stretched only; stretched and folded.
    for lengths in [[30.0, 20.0, 20.0, 40.0], [30.0, 30.0, 12.0, 40.0]] {
        let [l1, l2, l3, l4] = lengths;
        let angle = |d: f64| ((l1 * l1 + l4 * l4 - d * d) / (2.0 * l1 * l4)).acos();
        let folded = angle(l2 - l3);
        let reaches = reach(&four_bar(lengths, 60.0, 80.0));
        let [lower, upper] = ends(&reaches[0]);
        near(upper.0, angle(l2 + l3), 1e-12);
        near(
            lower.0,
            if folded.is_nan() {
                -angle(l2 + l3)
            } else {
                folded
            },
            1e-12,
        );
        assert_eq!((lower.1, upper.1), (&[0][..], &[0][..]));
        assert_eq!(reaches[0].approaches[0].least, 0.0);
    }
}

#[test]
fn a_grashof_crank_turns_all_round() {
    let [l1, l2, l3, l4]: [f64; 4] = [10.0, 30.0, 25.0, 30.0];
    let reaches = reach(&four_bar([l1, l2, l3, l4], 30.0, 80.0));
    assert_eq!(reaches[0].lower, Limit::None);
    assert_eq!(reaches[0].upper, Limit::None);
    let transmission = |d: f64| ((l2 * l2 + l3 * l3 - d * d) / (2.0 * l2 * l3)).acos();
    let acute = |angle: f64| angle.min(std::f64::consts::PI - angle);
    let approach = reaches[0].approaches[0];
    let least = acute(transmission(l4 - l1)).min(acute(transmission(l4 + l1)));
    near(approach.least_angle(), least, 1e-9);
    near(approach.at.sin(), 0.0, 1e-6);
    let d = (l1 * l1 + l4 * l4 - 2.0 * l1 * l4 * 50f64.to_radians().cos()).sqrt();
    near(approach.assembled_angle(), acute(transmission(d)), 1e-9);
}

#[test]
fn the_transmission_angle_of_a_slider_crank_is_from_the_normal_of_its_guide() {
    let model = Model::from_path("models/slider_crank.flex").unwrap();
    let reaches = model.design().assembled().unwrap().reach();
    assert_eq!(reaches[0].upper, Limit::None);
    let angle = |turn: f64| ((15.0 * turn.sin() - 4.0) / 50.0f64).abs().acos();
    let approach = reaches[0].approaches[0];
    near(approach.assembled_angle(), angle(75f64.to_radians()), 1e-12);
    near(approach.least_angle(), angle(-90f64.to_radians()), 1e-12);
}

#[test]
fn a_parallelogram_closes_through_its_singular_positions() {
    let model = Model::from_path("models/parallelogram_stage.flex").unwrap();
    let reaches = model.design().assembled().unwrap().reach();
    assert_eq!(reaches.len(), 1);
    assert_eq!(
        (&reaches[0].lower, &reaches[0].upper),
        (&Limit::None, &Limit::None)
    );
}

#[test]
fn the_second_of_two_loops_limits_the_first() {
    // The first turns all round; the second drives a rocker that the first's end cannot always
    // reach: it stretches where B is 20 mm from O3.
    let first: [f64; 4] = [10.0, 30.0, 25.0, 30.0];
    let text = four_bar(first, 30.0, 80.0)
        + "ground O3 = (50 mm, 25 mm)
link rod from D to E { length = 9 mm, angle = 60 deg, mass = 5 g }
link output from O3 to E { length = 11 mm, angle = 140 deg, mass = 5 g }
";
    let reaches = reach(&text);
    let [l1, l2, l3, l4] = first;
    let distance = |turn: f64| {
        let b = [l1 * turn.cos(), l1 * turn.sin()];
        let (dx, dy) = (l4 - b[0], -b[1]);
        let span = dx.hypot(dy);
        let along = (span * span + l2 * l2 - l3 * l3) / (2.0 * span);
        let aside = (l2 * l2 - along * along).sqrt();
        let d = [
            b[0] + (along * dx - aside * dy) / span,
            b[1] + (along * dy + aside * dx) / span,
        ];
        (d[0] - 50.0).hypot(d[1] - 25.0)
    };
    for (at, loops) in ends(&reaches[0]) {
        assert_eq!(loops, [1]);
        let gap = distance(at);
        let is_end = (gap - 20.0).abs() < 1e-9 || (gap - 2.0).abs() < 1e-9;
        assert!(is_end, "{gap}");
    }
}

/// Bodies of a mechanism, the coordinate that comes to a dead point, its rate, and a coordinate
/// that does not.
struct Case {
    bodies: String,
    leader: &'static str,
    rate: f64,
    other: &'static str,
    /// Until when the other is followed, in s.
    until: f64,
    name: &'static str,
}

fn cases() -> Vec<Case> {
    let slider = |r: f64, l: f64, crank: f64, rod: f64, at: f64| {
        format!(
            "model test
ground O = (0 mm, 0 mm)
link crank from O to A {{ length = {r} mm, angle = {crank} deg EXACT_crank, mass = 4 g }}
link rod from A to P {{ length = {l} mm, angle = {rod} deg, mass = 9 g }}
slide piston along (1, 0) {{ mass = 20 g, at = {at:?} mm EXACT_piston }}
point P on piston at (0 mm, 0 mm)
"
        )
    };
    let position = |r: f64, l: f64, crank: f64| {
        let turn = crank.to_radians();
        r * turn.cos() + (l * l - (r * turn.sin()).powi(2)).sqrt()
    };
    let linkage = four_bar([30.0, 20.0, 20.0, 40.0], -15.0, 93.0)
        .replace("coordinate crank.angle\n", "")
        .replace("exact", "EXACT_crank");
    vec![
        Case {
            bodies: linkage,
            leader: "crank.angle",
            rate: 5.0,
            other: "rocker.angle",
            until: 0.3,
            name: "crank–coupler–rocker",
        },
        Case {
            bodies: slider(15.0, 50.0, 75.0, -15.0, position(15.0, 50.0, 75.0)),
            leader: "piston.x",
            rate: 1.0,
            other: "crank.angle",
            until: 0.03,
            name: "crank–rod–piston",
        },
        Case {
            bodies: slider(30.0, 20.0, 20.0, -30.0, position(30.0, 20.0, 20.0)),
            leader: "crank.angle",
            rate: 10.0,
            other: "piston.x",
            until: 0.1,
            name: "crank–rod–piston",
        },
    ]
}

impl Case {
    fn led_by(&self, coordinate: &str, rate: f64) -> Model {
        let mut bodies = self.bodies.clone();
        for body in ["crank", "piston"] {
            let is_leader = coordinate.starts_with(body);
            bodies = bodies.replace(
                &format!("EXACT_{body}"),
                if is_leader { "exact" } else { "" },
            );
        }
        if coordinate.starts_with("rocker") {
            // As the crank at 50° closes it.
            let (dx, dy) = (
                40.0 - 30.0 * 50f64.to_radians().cos(),
                -30.0 * 50f64.to_radians().sin(),
            );
            let aside = (20.0f64.powi(2) - 0.25 * (dx * dx + dy * dy)).sqrt();
            let span = dx.hypot(dy);
            let end = [-0.5 * dx - aside * dy / span, -0.5 * dy + aside * dx / span];
            let angle = end[1].atan2(end[0]).to_degrees();
            bodies = bodies.replace("angle = 93 deg", &format!("angle = {angle:?} deg exact"));
        }
        let speed = |name: &str| name.replace(".angle", ".rate").replace(".x", ".v");
        model(&format!(
            "{bodies}coordinate {coordinate}
initial {} = {rate:?} {}
output followed = {}
",
            speed(coordinate),
            if coordinate.ends_with(".x") {
                "m/s"
            } else {
                "rad/s"
            },
            speed(self.leader),
        ))
    }

    /// When the leader comes to rest, by the other coordinate.
    fn time(&self) -> f64 {
        let column = |rate: f64, until: f64, every: f64| {
            let model = self.led_by(self.other, rate);
            let system = model.design().prepare().unwrap();
            let run = simulate(&system).until(until).rtol(1e-11).every(every);
            let run = run.run().unwrap_or_else(|why| panic!("{why}"));
            let values: Vec<f64> = run.column("followed").values().to_vec();
            (run.times().to_vec(), values)
        };
        let per_rate = column(1.0, 1e-6, 1e-6).1[0];
        let (times, values) = column(self.rate / per_rate, self.until, 2e-6);
        let end = values.iter().position(|value| *value <= 0.0).unwrap();
        let share = values[end - 1] / (values[end - 1] - values[end]);
        times[end - 1] + share * (times[end] - times[end - 1])
    }
}

#[test]
fn a_run_ends_at_the_time_at_which_the_other_coordinate_passes() {
    for case in cases() {
        let expected = case.time();
        let model = case.led_by(case.leader, case.rate);
        let system = model.design().prepare().unwrap();
        let ends = model.design().assembled().unwrap().reach();
        let Limit::DeadPoint(place, _) = ends[0].upper else {
            panic!("{ends:?}");
        };
        let runs = [
            (simulate(&system).rtol(1e-9), 1e-7),
            (simulate(&system).rtol(1e-4), 1e-3),
            (simulate(&system).dt(2e-5), 1e-3),
            (simulate(&system).dt(1e-3), 2e-2),
        ];
        for (run, tolerance) in runs {
            let failure = run.until(0.5).run().unwrap_err();
            let breakdown = &failure.breakdown;
            assert_eq!(breakdown.kind, BreakdownKind::DeadPoint(0), "{failure}");
            near(breakdown.time, expected, tolerance * expected);
            // The run ends where the squared sine is below 1e-8.
            near(breakdown.state[0], place, 1e-8 * place.abs());
            let words = failure.to_string();
            assert!(words.contains(case.name), "{words}");
            assert!(words.contains(case.leader), "{words}");
            assert!(failure.run.times().len() > 3);
        }
    }
}

#[test]
fn loops_that_close_together_come_to_one_dead_point_at_any_accuracy() {
    let text = std::fs::read_to_string("models/three_rrr_cranks.flex").unwrap();
    let model = model(&(text + "initial crank1.rate = 20 rad/s\n"));
    let mut design = model.design();
    for (name, value) in [("k", 1e-9), ("c", 1e-12), ("torque", 0.0)] {
        design.set(name, value).unwrap();
    }
    let system = design.prepare().unwrap();
    let times = [1e-6, 1e-8].map(|tolerance| {
        let run = simulate(&system).until(0.5).rtol(tolerance);
        let failure = run.run().unwrap_err();
        let breakdown = failure.breakdown;
        assert_eq!(breakdown.kind, BreakdownKind::DeadPoint(0), "{breakdown}");
        breakdown.time
    });
    near(times[0], times[1], 1e-4 * times[1]);
}
