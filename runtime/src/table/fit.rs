//! Fitting: values at Chebyshev nodes, degree by the decay of the coefficients, powers, and a check
//! off the nodes.
//!
//! Expansions are found as Chebfun does (Battles and Trefethen, SIAM J. Sci. Comput. 25, 2004, 1743):
//! more nodes than coefficients are kept, and what is left out must be as small as rounding. In
//! powers of the distance from the middle they cost half as much as in Chebyshev polynomials, and
//! lose nothing: coefficients that fall by 1e-13 within twelve degrees outweigh the growth of the
//! powers' own ((1 + √2)ᵏ).

use super::motion::{expected, inputs};
use super::{LARGEST_DEGREE, Table};
use crate::system::System;

/// Nodes: enough to see the decay behind the largest degree.
const NODES: usize = 17;
/// Points of the check: the ends, and others that are no nodes.
const CHECKED: [f64; 8] = [-1.0, -0.97, -0.61, -0.27, 0.13, 0.45, 0.77, 1.0];
/// Largest errors off the nodes, relative to each function's size: the second where none is found
/// with the first, because closed forms have more rounding of their own.
const ALLOWED: [f64; 2] = [1e-13, 3e-12];
/// The share of it that is left out of an expansion.
const LEFT_OUT: f64 = 0.3;
/// The interval is at least this many times as long as the expected deflection, if degree 12
/// suffices: a suddenly applied force deflects an undamped spring twice as far as a resting one,
/// and a drive that pushes it at the right moments twice as far again.
const MARGIN: f64 = 4.0;
/// Intervals are made wider up to this degree: two powers more cost a multiplication and an addition
/// side by side, a step outside costs the closed form.
const CHEAP_DEGREE: usize = 7;
/// Coefficients above this, relative to the function's size, belong to the function; smaller ones
/// may be the rounding of its closed form, of which wider intervals have less in proportion.
const NOISE: f64 = 1e-9;
/// Half width to begin with, in the coordinate's unit, where nothing holds the coordinate.
const UNKNOWN: f64 = 1.0;
/// An interval is halved or doubled no more often than this.
const MOST_CHANGES: usize = 16;

/// Polynomials for functions of one coordinate.
#[derive(Clone, Debug)]
pub struct Fit {
    /// Middle of the interval: the coordinate at the start.
    pub center: f64,
    /// Half the interval's length; 0 if there is none.
    pub half_width: f64,
    /// Degree of all polynomials.
    pub degree: usize,
    /// Largest error off the nodes, relative to each function's size.
    pub error: f64,
    /// Coefficients of each power of (q - center) / half_width, one for each function.
    pub coefficients: Vec<Vec<f64>>,
}

/// Functions of a coordinate: its value, the discrete state there, and where they go.
type Functions<'f> = &'f mut dyn FnMut(f64, &[f64], &mut [f64]);

impl<const N: usize> Table<f64, N> {
    /// A table of `closed_form`, functions of coordinate `which` of a system and its discrete state.
    /// `coordinates` are the positions of all coordinates and of their rates among the states.
    pub fn fit(
        system: &dyn System,
        coordinates: &[(usize, usize)],
        which: usize,
        closed_form: impl Fn(f64, &[f64]) -> [f64; N],
    ) -> Self {
        let functions =
            &mut |q: f64, d: &[f64], out: &mut [f64]| out.copy_from_slice(&closed_form(q, d));
        Self::new(&fit(system, coordinates, which, N, functions), 0)
    }
}

/// Fits `count` functions of coordinate `which`, on an interval as wide as its expected motion with
/// a margin: wider while degree 7 suffices, narrower where degree 12 does not. The interval is empty
/// if the functions cannot be had to rounding on any.
pub fn fit(
    system: &dyn System,
    coordinates: &[(usize, usize)],
    which: usize,
    count: usize,
    functions: Functions<'_>,
) -> Fit {
    let place = Place::new(system, coordinates[which].0);
    let reach = expected(system, coordinates, which).filter(|reach| *reach > 0.0);
    let first = reach.map_or(UNKNOWN, |reach| MARGIN * reach);
    let mut fits = ALLOWED
        .iter()
        .filter_map(|&allowed| place.widest(first, allowed, count, functions));
    fits.next().unwrap_or(Fit {
        center: place.center,
        half_width: 0.0,
        degree: 0,
        error: 0.0,
        coefficients: Vec::new(),
    })
}

/// Chebyshev coefficients of functions on an interval.
struct Expansion {
    half_width: f64,
    /// Largest absolute values of the functions.
    sizes: Vec<f64>,
    /// For each degree one for each function.
    coefficients: Vec<Vec<f64>>,
}

impl Expansion {
    /// The lowest degree behind which every function's coefficients add up to no more than
    /// `left_out` times its size.
    fn degree(&self, left_out: f64) -> usize {
        let of_one = |(function, size): (usize, &f64)| {
            let mut rest = 0.0;
            let is_beyond = |k: &usize| {
                rest += self.coefficients[*k][function].abs();
                !(rest <= left_out * size)
            };
            (1..self.coefficients.len()).rev().find(is_beyond)
        };
        let degrees = self.sizes.iter().enumerate().filter_map(of_one);
        degrees.max().unwrap_or(0)
    }
}

/// Where functions are fitted: about the start.
struct Place<'s> {
    system: &'s dyn System,
    coordinate: usize,
    center: f64,
    x: Vec<f64>,
    d: Vec<f64>,
    u: Vec<f64>,
}

impl<'s> Place<'s> {
    fn new(system: &'s dyn System, coordinate: usize) -> Self {
        let mut x = vec![0.0; system.states().len()];
        let mut d = vec![0.0; system.discretes().len()];
        system.start(&mut x, &mut d);
        Self {
            system,
            coordinate,
            center: x[coordinate],
            x,
            d,
            u: inputs(system),
        }
    }

    /// Values of the functions at `points`, in units of the half width: from the middle outward on
    /// either side, so that the discrete state follows.
    fn sample(
        &self,
        half_width: f64,
        points: &[f64],
        count: usize,
        functions: Functions<'_>,
    ) -> Option<Vec<Vec<f64>>> {
        let mut values = vec![vec![0.0; count]; points.len()];
        let mut outward: Vec<usize> = (0..points.len()).collect();
        outward.sort_by(|&i, &j| points[i].abs().total_cmp(&points[j].abs()));
        for side in [false, true] {
            let mut d = self.d.clone();
            let mut x = self.x.clone();
            for &index in outward.iter().filter(|&&i| (points[i] < 0.0) == side) {
                let q = self.center + half_width * points[index];
                functions(q, &d, &mut values[index]);
                if values[index].iter().any(|value| !value.is_finite()) {
                    return None;
                }
                x[self.coordinate] = q;
                self.system.accept(0.0, &x, &self.u, &mut d);
            }
        }
        Some(values)
    }

    /// The functions on the widest interval that is worth it, beginning with half width `first`.
    fn widest(
        &self,
        first: f64,
        allowed: f64,
        count: usize,
        functions: Functions<'_>,
    ) -> Option<Fit> {
        let mut widest: Option<Fit> = None;
        let mut half_width = first;
        for _ in 0..MOST_CHANGES {
            let expansion = self.expansion(half_width, count, functions);
            let Some(expansion) = expansion.filter(|e| e.degree(NOISE) <= CHEAP_DEGREE) else {
                break;
            };
            if let Some(fit) = self.checked(&expansion, allowed, functions)
                && (widest.is_none() || fit.degree <= CHEAP_DEGREE)
            {
                widest = Some(fit);
            }
            half_width *= 2.0;
        }
        half_width = first;
        for _ in 0..MOST_CHANGES {
            if widest.is_some() {
                break;
            }
            let expansion = self.expansion(half_width, count, functions);
            widest = expansion.and_then(|e| self.checked(&e, allowed, functions));
            half_width *= 0.5;
        }
        widest
    }

    /// The functions' expansions on an interval; `None` where they are no numbers.
    fn expansion(
        &self,
        half_width: f64,
        count: usize,
        functions: Functions<'_>,
    ) -> Option<Expansion> {
        let angle = std::f64::consts::PI / (2 * NODES) as f64;
        // A quarter turn is NODES steps, so that every cosine that is needed is one of these.
        let cosines: Vec<f64> = (0..4 * NODES).map(|k| (k as f64 * angle).cos()).collect();
        let nodes: Vec<f64> = (0..NODES)
            .map(|j| self.stands_at(half_width, cosines[2 * j + 1]))
            .collect();
        let values = self.sample(half_width, &nodes, count, functions)?;
        let sizes = (0..count)
            .map(|f| values.iter().map(|row| row[f].abs()).fold(0.0, f64::max))
            .collect();
        Some(Expansion {
            half_width,
            sizes,
            coefficients: corrected(&values, &nodes, &cosines, count),
        })
    }

    /// Where the coordinate stands for a point, both in units of the half width: its own rounding is
    /// not the functions' error.
    fn stands_at(&self, half_width: f64, point: f64) -> f64 {
        (self.center + half_width * point - self.center) / half_width
    }

    /// The polynomials of an expansion, if degree 12 gives the functions to rounding.
    fn checked(
        &self,
        expansion: &Expansion,
        allowed: f64,
        functions: Functions<'_>,
    ) -> Option<Fit> {
        let (half_width, count) = (expansion.half_width, expansion.sizes.len());
        let degree = expansion.degree(LEFT_OUT * allowed);
        if degree > LARGEST_DEGREE {
            return None;
        }
        let coefficients = powers(&expansion.coefficients[..=degree], count);
        let exact = self.sample(half_width, &CHECKED, count, functions)?;
        let mut error: f64 = 0.0;
        for (point, exact) in CHECKED.iter().zip(&exact) {
            let s = self.stands_at(half_width, *point);
            for (f, size) in expansion.sizes.iter().enumerate() {
                let value = coefficients
                    .iter()
                    .rev()
                    .fold(0.0, |sum, row| sum * s + row[f]);
                let off = (value - exact[f]).abs();
                if off > 0.0 {
                    error = error.max(off / size);
                }
            }
        }
        (error <= allowed).then_some(Fit {
            center: self.center,
            half_width,
            degree,
            error,
            coefficients,
        })
    }
}

/// Chebyshev coefficients of the polynomials through values that were taken at `nodes`, next to the
/// nodes themselves: the slopes of a first expansion move them there.
fn corrected(values: &[Vec<f64>], nodes: &[f64], cosines: &[f64], count: usize) -> Vec<Vec<f64>> {
    let slopes = derivative(&expand(values, cosines, count), count);
    let moved: Vec<Vec<f64>> = (0..NODES)
        .map(|j| {
            let step = cosines[2 * j + 1] - nodes[j];
            (0..count)
                .map(|f| {
                    let slope: f64 = (0..NODES)
                        .map(|k| slopes[k][f] * cosines[k * (2 * j + 1) % (4 * NODES)])
                        .sum();
                    values[j][f] + slope * step
                })
                .collect()
        })
        .collect();
    expand(&moved, cosines, count)
}

/// Chebyshev coefficients of the polynomials through values at the nodes.
fn expand(values: &[Vec<f64>], cosines: &[f64], count: usize) -> Vec<Vec<f64>> {
    (0..NODES)
        .map(|k| {
            let share = if k == 0 { 1.0 } else { 2.0 } / NODES as f64;
            (0..count)
                .map(|f| {
                    let sum: f64 = (0..NODES)
                        .map(|j| values[j][f] * cosines[k * (2 * j + 1) % (4 * NODES)])
                        .sum();
                    share * sum
                })
                .collect()
        })
        .collect()
}

/// Chebyshev coefficients of the derivatives: c'ₖ₋₁ = c'ₖ₊₁ + 2k cₖ.
fn derivative(expansion: &[Vec<f64>], count: usize) -> Vec<Vec<f64>> {
    let n = expansion.len();
    let mut slopes = vec![vec![0.0; count]; n + 1];
    for k in (1..n).rev() {
        for f in 0..count {
            slopes[k - 1][f] = slopes[k + 1][f] + 2.0 * k as f64 * expansion[k][f];
        }
    }
    slopes[0].iter_mut().for_each(|slope| *slope *= 0.5);
    slopes
}

/// Coefficients of powers, by Tₖ₊₁ = 2 s Tₖ - Tₖ₋₁.
fn powers(expansion: &[Vec<f64>], count: usize) -> Vec<Vec<f64>> {
    let n = expansion.len();
    let mut coefficients = vec![vec![0.0; count]; n];
    let mut before = vec![0.0; n];
    let mut now = vec![0.0; n];
    now[0] = 1.0;
    for (k, row) in expansion.iter().enumerate() {
        for (power, weight) in now.iter().enumerate() {
            for f in 0..count {
                coefficients[power][f] += weight * row[f];
            }
        }
        let factor = if k == 0 { 1.0 } else { 2.0 };
        let next: Vec<f64> = (0..n)
            .map(|power| {
                let raised = if power == 0 { 0.0 } else { now[power - 1] };
                factor * raised - before[power]
            })
            .collect();
        before = now;
        now = next;
    }
    coefficients
}
