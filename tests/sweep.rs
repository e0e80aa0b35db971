//! Lengths are params: a thousand random four-bars from one compiled model, each closed anew by
//! `prepare`, and those that cannot close refused with the gap in words.
//!
//! Which close is decided here by the triangle of coupler, rocker and the distance of the pins
//! between which they stand, and how by intersecting two circles. Both back ends are asked: the
//! module that the macro made, and the tape.

mod support;

use flexure_models::four_bar::Params;
use flexure_runtime::diagnostic::Diagnostic;
use flexure_runtime::system::System;
use flexure_runtime::tape::TapeModel;
use support::random::Random;
use support::{Compiled, compile, shipped_text, tape_model};

type Plane = [f64; 2];

/// As drawn in the model file: the crank exactly, the others about.
const CRANK: f64 = 80.0;
const COUPLER: Plane = [1.0, 0.0];
const ROCKER: Plane = [0.0, 1.0];

/// Lengths of crank, coupler and rocker, and of the ground between the pivots.
type Lengths = [f64; 4];

fn crank_end(l1: f64) -> Plane {
    let (sin, cos) = CRANK.to_radians().sin_cos();
    [l1 * cos, l1 * sin]
}

/// By how much coupler and rocker are too short, or one of them too long, to meet; none or less
/// where they do.
fn gap([l1, l2, l3, l4]: Lengths) -> f64 {
    let [x, y] = crank_end(l1);
    let distance = (l4 - x).hypot(y);
    (distance - l2 - l3).max((l2 - l3).abs() - distance)
}

/// Directions of coupler and rocker of the two ways to close, the one nearer to the drawing first.
fn ways([l1, l2, l3, l4]: Lengths) -> [[Plane; 2]; 2] {
    let b = crank_end(l1);
    let way = [l4 - b[0], -b[1]];
    let distance = way[0].hypot(way[1]);
    let foot = (l2 * l2 - l3 * l3 + distance * distance) / (2.0 * distance);
    let height = (l2 * l2 - foot * foot).max(0.0).sqrt();
    let [ex, ey] = way.map(|c| c / distance);
    let close = |side: f64| {
        let d = [
            foot * ex - side * height * ey,
            foot * ey + side * height * ex,
        ];
        let coupler = d.map(|c| c / l2);
        let rocker = [(b[0] + d[0] - l4) / l3, (b[1] + d[1]) / l3];
        [coupler, rocker]
    };
    let off = |[coupler, rocker]: [Plane; 2]| {
        let part = |a: Plane, b: Plane| (a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2);
        part(coupler, COUPLER) + part(rocker, ROCKER)
    };
    let (left, right) = (close(1.0), close(-1.0));
    if off(left) < off(right) {
        [left, right]
    } else {
        [right, left]
    }
}

/// Directions of coupler and rocker as a back end closes them.
type Closed = Result<[Plane; 2], Diagnostic>;

fn by_module([l1, l2, l3, l4]: Lengths) -> Closed {
    let design = Params {
        l1,
        l2,
        l3,
        l4,
        ..Params::default()
    };
    let prepared = design.prepare()?;
    Ok([
        [prepared.c2_0, prepared.s2_0],
        [prepared.c3_0, prepared.s3_0],
    ])
}

/// The model as a tape, with the closed angles among its outputs.
struct Taped {
    compiled: Compiled,
    tape: TapeModel,
}

impl Taped {
    fn new() -> Self {
        let angles = "\noutput coupled = coupler.angle\noutput rocked = rocker.angle\n";
        let compiled = compile("four_bar.flex", &(shipped_text("four_bar") + angles));
        let tape = tape_model(&compiled);
        Self { compiled, tape }
    }
}

fn by_tape(taped: &Taped, [l1, l2, l3, l4]: Lengths) -> Closed {
    let changes = [("l1", l1), ("l2", l2), ("l3", l3), ("l4", l4)];
    let prepared = taped.tape.prepare(&taped.compiled.params(&changes))?;
    let (mut x, mut d) = (vec![0.0; 2], vec![0.0; prepared.discretes().len()]);
    prepared.start(&mut x, &mut d);
    let rows = prepared.output_variables();
    let mut out = vec![0.0; rows.len()];
    prepared.outputs(0.0, &x, &d, &[], &mut out);
    let angle = |name: &str| {
        let found = rows.iter().position(|row| row.name == name);
        out[found.expect("an output of that name")]
    };
    let direction = |angle: f64| [angle.cos(), angle.sin()];
    Ok([direction(angle("coupled")), direction(angle("rocked"))])
}

/// A length as messages write it, in m.
fn length(text: &str) -> f64 {
    let mut words = text.split(' ');
    let number: f64 = words.next().and_then(|n| n.parse().ok()).expect("a number");
    let unit = match words.next() {
        Some("m") => 1.0,
        Some("mm") => 1e-3,
        Some("um" | "µm") => 1e-6,
        Some("nm") => 1e-9,
        Some("pm") => 1e-12,
        other => panic!("{other:?} in `{text}` is a unit of length"),
    };
    number * unit
}

/// Compares what a back end makes of one four-bar; whether it closes.
fn check(lengths: Lengths, closed: &Closed) -> bool {
    let gap = gap(lengths);
    let [l1, l2, l3, l4] = lengths;
    match closed {
        Ok([coupler, rocker]) => {
            assert!(gap < 0.0, "{lengths:?} closes with a gap of {gap:e} m");
            let b = crank_end(l1);
            let rounding = 4.0 * f64::EPSILON * (l1 + l2 + l3 + l4);
            for axis in 0..2 {
                let pivot = [l4, 0.0][axis];
                let open = b[axis] + l2 * coupler[axis] - pivot - l3 * rocker[axis];
                assert!(open.abs() < rounding, "{lengths:?}: {open:e} m open");
            }
            for (l, [x, y]) in [(l2, coupler), (l3, rocker)] {
                let stretch = l * (x.hypot(*y) - 1.0);
                assert!(
                    stretch.abs() < rounding,
                    "{lengths:?}: {stretch:e} m longer"
                );
            }
            let [drawn, other] = ways(lengths);
            let off = |way: [Plane; 2]| (coupler[0] - way[0][0]).hypot(coupler[1] - way[0][1]);
            assert!(
                off(drawn) < off(other),
                "{lengths:?} is on the other branch"
            );
            true
        }
        Err(problem) => {
            assert!(
                gap > 0.0,
                "{lengths:?} would close by {:e} m: {problem}",
                -gap
            );
            let said = problem.message.strip_prefix(
                "the loop crank–coupler–rocker cannot close: at `crank` angle 80° the gap is ",
            );
            let said = length(said.unwrap_or_else(|| panic!("{lengths:?}: {problem}")));
            assert!(
                (said - gap).abs() <= 5.1e-4 * gap,
                "{lengths:?}: {gap:e} m, {problem}"
            );
            assert!(
                problem.hint.is_some() && problem.site.is_some(),
                "{problem}"
            );
            false
        }
    }
}

/// The same of both back ends; whether they close.
fn check_both(taped: &Taped, lengths: Lengths) -> bool {
    let (module, tape) = (by_module(lengths), by_tape(taped, lengths));
    let closes = check(lengths, &module);
    assert_eq!(closes, check(lengths, &tape), "{lengths:?}");
    if let (Err(module), Err(tape)) = (&module, &tape) {
        assert_eq!(module.message, tape.message);
        assert_eq!(module.hint, tape.hint);
    }
    closes
}

#[test]
fn a_thousand_random_four_bars() {
    let taped = Taped::new();
    let mut random = Random::new(23);
    let (mut closed, mut refused) = (0, 0);
    for _ in 0..1000 {
        let lengths = [(); 4].map(|()| random.scale(5e-3, 50e-3));
        let count = if check_both(&taped, lengths) {
            &mut closed
        } else {
            &mut refused
        };
        *count += 1;
    }
    println!("{closed} four-bars close, {refused} cannot");
    assert!(closed > 100 && refused > 100);
}

/// Couplers a millionth longer or shorter than what just reaches, or just fits between.
#[test]
fn by_a_hair() {
    let taped = Taped::new();
    let mut random = Random::new(29);
    let mut seen = [0; 2];
    for _ in 0..200 {
        let [l1, l3, l4] = [(); 3].map(|()| random.scale(5e-3, 50e-3));
        let [x, y] = crank_end(l1);
        let distance = (l4 - x).hypot(y);
        for limit in [(distance - l3).abs(), distance + l3] {
            for hair in [-1e-6, 1e-6] {
                let l2 = limit * (1.0 + hair);
                seen[usize::from(check_both(&taped, [l1, l2, l3, l4]))] += 1;
            }
        }
    }
    assert_eq!(seen, [400, 400]);
}
