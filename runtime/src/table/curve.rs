//! Curves: a function of one quantity that changes in every evaluation, as polynomials on equal
//! intervals.
//!
//! ```text
//! closed form ──sampling octaves──▶ range ──nodes, check──▶ intervals ──▶ Curve
//! ```
//!
//! A friction law such as 1/g(v) has an exponential between the slip velocity and every rate that
//! depends on it. For one trajectory, time is the length of that chain: to find the interval and to
//! evaluate its polynomial there takes a third of it. In lanes it would cost more than the
//! exponential, as each lane reads an interval of its own; there is no curve there.
//!
//! Zero is the end of two intervals, so that a kink there is no obstacle. Beyond the range the
//! function is constant to rounding, as those of friction laws are; if it is not, or is too rough for
//! [`MOST`] intervals on either side, there is no curve either.

// `!(a <= b)` is meant where it stands: what is not a number is not small.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

use std::sync::Arc;

use super::chebyshev::polynomials;
use crate::real::Real;

/// Coefficients of an interval: polynomials of degree 7.
const ORDER: usize = 8;
/// Numbers of intervals on either side of zero that are tried.
const TRIED: [u16; 4] = [32, 64, 128, MOST];
/// Most intervals on either side: with 64 bytes each they fit into a cache of 48 kB.
const MOST: u16 = 256;
/// Largest error that is allowed, relative to the function's size.
const ALLOWED: f64 = 1e-14;
/// What is closer than this to the limit, relative to the function's size, is constant.
const CONSTANT: f64 = 4e-16;
/// Powers of two between which the range is sought.
const OCTAVES: std::ops::Range<i32> = -40..40;
/// Points of the check in an interval, from -1 to 1: its ends, and others that are no nodes.
const CHECKED: [f64; 5] = [-1.0, -0.6, 0.06, 0.7, 1.0];
/// Added to a number below 2^51 this leaves the nearest whole number in the last bits.
const WHOLE: f64 = 6_755_399_441_055_744.0;

/// Coefficients of the powers of an interval's argument, in one line of a cache.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Row([f64; ORDER]);

/// A function of one quantity.
#[derive(Clone, Debug)]
pub struct Curve {
    is_wanted: bool,
    intervals: Option<Intervals>,
}

#[derive(Clone, Debug)]
struct Intervals {
    /// Beyond this on either side the function is constant.
    reach: f64,
    /// Intervals per unit.
    scale: f64,
    /// Number of the row for the interval from 0 upwards. This one and the one before it are half as
    /// long as the others are.
    origin: i64,
    /// What the function is below and above the range.
    beyond: [f64; 2],
    rows: Arc<[Row]>,
    error: f64,
}

/// What a prepared model says of a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveReport {
    /// Beyond this on either side of zero the function is constant; in the unit of its argument.
    pub reach: f64,
    /// Number of intervals, all together.
    pub intervals: usize,
    /// Largest difference from the closed form that was measured off the nodes, relative to the
    /// function's largest size.
    pub error: f64,
}

impl Curve {
    /// No curve, now or later: the closed form everywhere.
    pub fn none() -> Self {
        Self {
            is_wanted: false,
            intervals: None,
        }
    }

    /// No curve yet.
    pub fn wanted() -> Self {
        Self {
            is_wanted: true,
            intervals: None,
        }
    }

    /// The curve of `closed_form`, if one is wanted and there is one.
    pub fn fitted(&self, closed_form: impl Fn(f64) -> f64) -> Self {
        Self {
            is_wanted: self.is_wanted,
            intervals: self.is_wanted.then(|| fit(&closed_form)).flatten(),
        }
    }

    /// What there is to say of it, if there is one.
    pub fn report(&self) -> Option<CurveReport> {
        self.intervals.as_ref().map(|intervals| CurveReport {
            reach: intervals.reach,
            intervals: intervals.rows.len(),
            error: intervals.error,
        })
    }

    /// The function at `argument`; `None` if there is no curve, in lanes, and for what is not a
    /// number.
    #[inline(always)]
    pub fn at<T: Real>(&self, argument: T) -> Option<T> {
        let number = argument.plain()?;
        self.intervals.as_ref()?.at(argument, number)
    }
}

impl Intervals {
    #[inline(always)]
    fn at<T: Real>(&self, argument: T, number: f64) -> Option<T> {
        if number.abs() < self.reach {
            let scale = T::from_f64(self.scale);
            let whole = argument.times_plus(scale, T::from_f64(WHOLE));
            let s = argument.times_plus(scale, T::from_f64(WHOLE) - whole);
            // The last bits of `whole` are those of the interval. Of the two about zero, a minus
            // sign means the lower one.
            let interval = whole.plain()?.to_bits() as i64 - WHOLE.to_bits() as i64;
            let sign = number.to_bits() as i64 >> 63;
            let row = usize::try_from(interval + sign + self.origin).ok()?;
            let c = self.rows.get(row)?.0.map(T::from_f64);
            let square = s * s;
            let low = c[3]
                .times_plus(s, c[2])
                .times_plus(square, c[1].times_plus(s, c[0]));
            let high = c[7]
                .times_plus(s, c[6])
                .times_plus(square, c[5].times_plus(s, c[4]));
            Some(high.times_plus(square * square, low))
        } else if number > 0.0 {
            Some(T::from_f64(self.beyond[1]))
        } else if number < 0.0 {
            Some(T::from_f64(self.beyond[0]))
        } else {
            None
        }
    }
}

/// Intervals on which polynomials give a function to rounding, as few as suffice.
fn fit(closed_form: &dyn Fn(f64) -> f64) -> Option<Intervals> {
    let beyond = [-1.0, 1.0].map(|side| closed_form(side * f64::from(OCTAVES.end).exp2()));
    let size = size(closed_form, &beyond)?;
    let reach = reach(closed_form, &beyond, CONSTANT * size)?;
    let nodes = nodes();
    let to_powers = to_powers(&nodes);
    TRIED.iter().find_map(|&count| {
        let mut fitting = Fitting {
            closed_form,
            nodes,
            to_powers: &to_powers,
            // The outermost interval ends at the reach, or by rounding behind it.
            scale: (f64::from(count) - 0.5) / reach * (1.0 - 1e-15),
            allowed: ALLOWED * size,
            error: 0.0,
        };
        let side = |fitting: &mut Fitting<'_>, sign: f64| -> Option<Vec<Row>> {
            (0..count)
                .map(|index| fitting.row(f64::from(index) * sign, sign))
                .collect()
        };
        // What is too rough is so near zero, as a rule: it is found there first.
        let above = side(&mut fitting, 1.0)?;
        let mut rows = side(&mut fitting, -1.0)?;
        rows.reverse();
        rows.extend(above);
        Some(Intervals {
            reach,
            scale: fitting.scale,
            origin: i64::from(count),
            beyond,
            rows: rows.into(),
            error: fitting.error / size,
        })
    })
}

/// The function's largest absolute value where it is sampled; `None` if it is not a number there,
/// or nothing but zero.
fn size(closed_form: &dyn Fn(f64) -> f64, beyond: &[f64; 2]) -> Option<f64> {
    let octaves = OCTAVES.map(|octave| f64::from(octave).exp2());
    let sampled = octaves
        .flat_map(|distance| [-distance, distance])
        .chain([0.0]);
    let mut values = sampled.map(closed_form).chain(*beyond);
    let size = values.try_fold(0.0, |size: f64, value| {
        value.is_finite().then(|| size.max(value.abs()))
    })?;
    (size > 0.0).then_some(size)
}

/// The least distance from zero, to an eighth of an octave, beyond which the function is constant;
/// `None` if it is everywhere or nowhere.
fn reach(closed_form: &dyn Fn(f64) -> f64, beyond: &[f64; 2], constant: f64) -> Option<f64> {
    let is_constant = |distance: f64| {
        let off = |side: usize, sign: f64| (closed_form(sign * distance) - beyond[side]).abs();
        off(0, -1.0) <= constant && off(1, 1.0) <= constant
    };
    let octave = OCTAVES
        .rev()
        .find(|octave| !is_constant(f64::from(*octave).exp2()))?;
    let eighths = (1..=8).map(|eighth| f64::from(octave).exp2() * (1.0 + f64::from(eighth) / 8.0));
    let reach = eighths
        .rev()
        .take_while(|distance| is_constant(*distance))
        .last()?;
    (octave + 1 < OCTAVES.end).then_some(reach)
}

/// One number of intervals that is tried.
struct Fitting<'f> {
    closed_form: &'f dyn Fn(f64) -> f64,
    nodes: [f64; ORDER],
    /// What the values at the nodes weigh in each power.
    to_powers: &'f [[f64; ORDER]; ORDER],
    scale: f64,
    allowed: f64,
    /// Largest so far.
    error: f64,
}

impl Fitting<'_> {
    /// Coefficients for the interval about `center`, in intervals; `sign` says on which side of zero
    /// it is. `None` if they are not good enough.
    fn row(&mut self, center: f64, sign: f64) -> Option<Row> {
        // The interval about zero is a half.
        let (middle, half) = if center == 0.0 {
            (0.25 * sign, 0.25)
        } else {
            (0.0, 0.5)
        };
        let at = |x: f64| {
            let s = middle + half * x;
            // No point is beyond zero.
            let argument = (center + s) / self.scale;
            (s, (self.closed_form)(argument))
        };
        // What is constant on the interval has no rounding in the powers.
        let constant = at(0.0).1;
        let values = self.nodes.map(|node| at(node).1 - constant);
        let mut row = self.to_powers.map(|weights| -> f64 {
            let terms = weights.iter().zip(&values);
            terms.map(|(weight, value)| weight * value).sum()
        });
        row[0] += constant;
        move_to(&mut row, middle, half);
        for x in CHECKED {
            let (s, exact) = at(x);
            let off = (row.iter().rev().fold(0.0, |sum, c| sum * s + c) - exact).abs();
            if !(off <= self.allowed) {
                return None;
            }
            self.error = self.error.max(off);
        }
        Some(Row(row))
    }
}

/// Zeros of the Chebyshev polynomial of degree [`ORDER`].
fn nodes() -> [f64; ORDER] {
    const STEP: f64 = std::f64::consts::PI / (2 * ORDER) as f64;
    std::array::from_fn(|j| Real::cos((2 * j + 1) as f64 * STEP))
}

/// For each power the weights of values at the nodes, by way of Chebyshev polynomials.
fn to_powers(nodes: &[f64; ORDER]) -> [[f64; ORDER]; ORDER] {
    let polynomials = polynomials();
    std::array::from_fn(|power| {
        nodes.map(|node| {
            // Tₖ at the node, by Tₖ₊₁ = 2 x Tₖ - Tₖ₋₁.
            let (mut value, mut next) = (1.0, node);
            let mut weight = 0.0;
            for (k, polynomial) in polynomials.iter().enumerate().take(ORDER) {
                let share = if k == 0 { 1.0 } else { 2.0 } / ORDER as f64;
                weight += share * value * polynomial[power];
                (value, next) = (next, 2.0 * node * next - value);
            }
            weight
        })
    })
}

/// From powers of x to powers of s = middle + half x.
fn move_to(coefficients: &mut [f64; ORDER], middle: f64, half: f64) {
    let mut factor = 1.0;
    for coefficient in coefficients.iter_mut() {
        *coefficient *= factor;
        factor /= half;
    }
    for first in 0..ORDER - 1 {
        for k in (first..ORDER - 1).rev() {
            coefficients[k] -= middle * coefficients[k + 1];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lanes::{Lanes, Portable};
    use proptest::prelude::*;

    /// Arguments that stand for all: ends of intervals, zero from both sides, beyond, and random ones.
    fn arguments(report: &CurveReport, shares: &[f64]) -> Vec<f64> {
        let interval = 2.0 * report.reach / (report.intervals - 1) as f64;
        let ends = (0..report.intervals).flat_map(|index| {
            let end = (index as f64 + 0.5) * interval;
            [
                end,
                end.next_up(),
                end.next_down(),
                -end,
                (-end).next_up(),
                (-end).next_down(),
            ]
        });
        let edges = [
            0.0,
            -0.0,
            5e-324,
            -5e-324,
            1e-30,
            -1e-30,
            1e300,
            -1e300,
            f64::INFINITY,
        ];
        let inside = shares
            .iter()
            .flat_map(|share| [share * report.reach, share * share * report.reach]);
        ends.chain(edges)
            .chain([report.reach, -report.reach])
            .chain(inside)
            .collect()
    }

    /// Compares a curve with the closed form; `size` is the function's.
    fn compare(closed_form: impl Fn(f64) -> f64, size: f64, shares: &[f64]) -> CurveReport {
        let curve = Curve::wanted().fitted(&closed_form);
        let report = curve.report().expect("a curve");
        assert!(report.error <= ALLOWED && report.intervals <= 2 * usize::from(MOST));
        for argument in arguments(&report, shares) {
            let (found, exact) = (curve.at(argument), closed_form(argument));
            let error = found.map(|found| (found - exact).abs() / size);
            assert!(
                error.is_some_and(|error| error <= 2.0 * ALLOWED),
                "{argument:e}: {error:?}"
            );
        }
        assert_eq!(curve.at(f64::NAN), None);
        assert!(curve.at(Portable::<4>::from_entries(|_| 0.1)).is_none());
        report
    }

    proptest! {
        #[test]
        fn one_over_the_curve_of_stribeck(
            excess in 0.01..4.0,
            velocity in -9.0..3.0,
            level in -9.0..9.0,
            shares in prop::collection::vec(-1.2..1.2, 200),
        ) {
            let [velocity, level] = [velocity, level].map(|power: f64| 10_f64.powf(power));
            let of = |v: f64| -> f64 {
                let share = v / velocity;
                1.0 / (level * (1.0 + excess * Real::exp(-(share * share))))
            };
            let size = of(0.0).abs().max(of(f64::MAX).abs());
            let report = compare(of, size, &shares);
            prop_assert!(report.reach < 10.0 * velocity, "{report:?}");
        }

        #[test]
        fn tanh_and_a_peak_with_a_kink(
            velocity in -9.0..3.0,
            shares in prop::collection::vec(-1.2..1.2, 200),
        ) {
            let velocity = 10_f64.powf(velocity);
            compare(|v| 3.0 * Real::tanh(v / velocity), 3.0, &shares);
            compare(|v| 2.0 + Real::exp(-Real::abs(v / velocity)), 3.0, &shares);
        }
    }

    #[test]
    fn what_has_no_curve() {
        type Named = (&'static str, fn(f64) -> f64);
        let functions: [Named; 7] = [
            ("grows", |v| v * v),
            ("turns", |v| Real::sin(v)),
            ("steep", |v| 1.0 / (1.0 + Real::sqrt(Real::abs(v)))),
            ("step", |v| Real::sign(v) * (1.0 + Real::exp(-v * v))),
            ("constant", |_| 3.0),
            ("zero", |_| 0.0),
            ("no number", |v| Real::ln(v)),
        ];
        for (name, function) in functions {
            assert_eq!(Curve::wanted().fitted(function).report(), None, "{name}");
        }
        let bell = |v: f64| Real::exp(-v * v);
        assert_eq!(Curve::none().fitted(bell).report(), None);
        assert_eq!(Curve::wanted().at(0.0), None);
        assert!(Curve::wanted().fitted(bell).report().is_some());
    }
}
