//! Fitting: values at Chebyshev nodes, degree by the decay of the coefficients, powers, and a check
//! off the nodes.
//!
//! Expansions are found as Chebfun does (Battles and Trefethen, SIAM J. Sci. Comput. 25, 2004, 1743):
//! more nodes than coefficients are kept, and what is left out must be as small as rounding. In
//! powers of the distance from the middle they cost half as much as in Chebyshev polynomials, and
//! lose nothing: coefficients that fall by 1e-13 within twelve degrees outweigh the growth of the
//! powers' own ((1 + √2)ᵏ).

// `!(a <= b)` is meant where it stands: what is not a number is not small.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

use super::chebyshev::{Grid, NODES, polynomials};
use super::motion::{expected, inputs};
use super::{LARGEST_DEGREE, Table};
use crate::system::System;

/// Points of the check: the ends, and others that are no nodes.
const CHECKED: [f64; 8] = [1.0, 0.77, 0.45, 0.13, -0.27, -0.61, -0.97, -1.0];
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
    /// `coordinates` are the positions of all coordinates and of their rates among the states. The
    /// first `rates` functions are fitted relative to their own size, the others, angles in rad and
    /// squares of sines, to one at least.
    pub fn fit(
        system: &dyn System,
        coordinates: &[(usize, usize)],
        which: usize,
        rates: usize,
        closed_form: impl Fn(f64, &[f64]) -> [f64; N],
    ) -> Self {
        let functions =
            &mut |q: f64, d: &[f64], out: &mut [f64]| out.copy_from_slice(&closed_form(q, d));
        let least: [f64; N] = std::array::from_fn(|k| if k < rates { 0.0 } else { 1.0 });
        Self::new(&fit(system, coordinates, which, &least, functions), 0)
    }
}

/// Fits functions of coordinate `which` whose sizes are taken to be `least` at least, on an interval as wide as its expected motion with
/// a margin: wider while degree 7 suffices, narrower where degree 12 does not. The interval is empty
/// if the functions cannot be had to rounding on any.
pub fn fit(
    system: &dyn System,
    coordinates: &[(usize, usize)],
    which: usize,
    least: &[f64],
    functions: Functions<'_>,
) -> Fit {
    let place = Place::new(system, coordinates[which].0);
    let reach = expected(system, coordinates, which).filter(|reach| *reach > 0.0);
    let first = reach.map_or(UNKNOWN, |reach| MARGIN * reach);
    let mut fits = ALLOWED
        .iter()
        .filter_map(|&allowed| place.widest(first, allowed, least, functions));
    fits.next().unwrap_or(Fit {
        center: place.center,
        half_width: 0.0,
        degree: 0,
        error: 0.0,
        coefficients: Vec::new(),
    })
}

/// Expansions of functions on an interval.
struct Expansion {
    half_width: f64,
    /// Largest absolute values of the functions, or what they are taken to be at least.
    sizes: Vec<f64>,
    /// Of each function.
    coefficients: Vec<[f64; NODES]>,
}

impl Expansion {
    /// The lowest degree behind which every function's coefficients add up to no more than
    /// `left_out` times its size.
    fn degree(&self, left_out: f64) -> usize {
        let functions = self.coefficients.iter().zip(&self.sizes);
        let degrees = functions.map(|(coefficients, size)| {
            let mut rest = 0.0;
            let mut from_above = (1..NODES).rev();
            let is_beyond = |k: &usize| {
                rest += coefficients[*k].abs();
                !(rest <= left_out * size)
            };
            from_above.find(is_beyond).unwrap_or(0)
        });
        degrees.max().unwrap_or(0)
    }

    /// Coefficients of powers up to `degree`, a row for each.
    fn powers(&self, degree: usize) -> Vec<Vec<f64>> {
        let polynomials = polynomials();
        let row = |power: usize| {
            let of_one = |coefficients: &[f64; NODES]| {
                let terms = (power..=degree).map(|k| coefficients[k] * polynomials[k][power]);
                terms.sum()
            };
            self.coefficients.iter().map(of_one).collect()
        };
        (0..=degree).map(row).collect()
    }
}

/// Where functions are fitted: about the start.
struct Place<'s> {
    system: &'s dyn System,
    grid: Grid,
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
            grid: Grid::new(),
            coordinate,
            center: x[coordinate],
            x,
            d,
            u: inputs(system),
        }
    }

    /// Values of the functions at `points`, in units of the half width and in falling order: from
    /// the middle outward on either side, so that the discrete state follows. `None` where they are
    /// no numbers.
    fn sample(
        &self,
        half_width: f64,
        points: &[f64],
        count: usize,
        functions: Functions<'_>,
    ) -> Option<Vec<f64>> {
        let mut values = vec![0.0; points.len() * count];
        let (mut x, mut d) = (self.x.clone(), self.d.clone());
        let middle = points.partition_point(|point| *point >= 0.0);
        for side in [0..middle, middle..points.len()] {
            let is_above = side.start == 0;
            d.copy_from_slice(&self.d);
            for step in 0..side.len() {
                let index = if is_above {
                    side.end - 1 - step
                } else {
                    side.start + step
                };
                let q = self.center + half_width * points[index];
                let row = &mut values[index * count..][..count];
                functions(q, &d, row);
                if !row.iter().all(|value| value.is_finite()) {
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
        least: &[f64],
        functions: Functions<'_>,
    ) -> Option<Fit> {
        let mut widest: Option<Fit> = None;
        let mut half_width = first;
        for _ in 0..MOST_CHANGES {
            let expansion = self.expansion(half_width, least, functions);
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
            let expansion = self.expansion(half_width, least, functions);
            widest = expansion.and_then(|e| self.checked(&e, allowed, functions));
            half_width *= 0.5;
        }
        widest
    }

    /// The functions' expansions on an interval; `None` where they are no numbers.
    fn expansion(
        &self,
        half_width: f64,
        least: &[f64],
        functions: Functions<'_>,
    ) -> Option<Expansion> {
        let (grid, count) = (&self.grid, least.len());
        let rows = self.sample(half_width, &grid.nodes, count, functions)?;
        let below = grid
            .nodes
            .map(|node| node - self.stands_at(half_width, node));
        let (mut sizes, mut coefficients) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for (f, least) in least.iter().enumerate() {
            let values: [f64; NODES] = std::array::from_fn(|j| rows[j * count + f]);
            sizes.push(
                values
                    .iter()
                    .fold(*least, |size, value| size.max(value.abs())),
            );
            coefficients.push(grid.expand_moved(&values, &below));
        }
        Some(Expansion {
            half_width,
            sizes,
            coefficients,
        })
    }

    /// Where the coordinate stands for a point, both in units of the half width: its own rounding is
    /// not the functions' error.
    fn stands_at(&self, half_width: f64, point: f64) -> f64 {
        (self.center + half_width * point - self.center) / half_width
    }

    /// The polynomials of an expansion, if degree 12 gives the functions well enough.
    fn checked(
        &self,
        expansion: &Expansion,
        allowed: f64,
        functions: Functions<'_>,
    ) -> Option<Fit> {
        let degree = expansion.degree(LEFT_OUT * allowed);
        if degree > LARGEST_DEGREE {
            return None;
        }
        let (half_width, count) = (expansion.half_width, expansion.sizes.len());
        let coefficients = expansion.powers(degree);
        let exact = self.sample(half_width, &CHECKED, count, functions)?;
        let mut error: f64 = 0.0;
        for (point, exact) in CHECKED.iter().zip(exact.chunks_exact(count)) {
            let s = self.stands_at(half_width, *point);
            for (f, size) in expansion.sizes.iter().enumerate() {
                let rows = coefficients.iter().rev();
                let off = (rows.fold(0.0, |sum, row| sum * s + row[f]) - exact[f]).abs();
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
