//! Tables of functions of one coordinate, as polynomials on an interval about the start.
//!
//! ```text
//! closed form ──expected motion──▶ interval ──nodes, decay, check──▶ Fit ──▶ Table
//! ```
//!
//! Whatever depends on one coordinate alone (closure of loops, ratios, inertia, slopes of the
//! potential) is analytic, and flexures move it by a few hundredths of a radian. There Chebyshev
//! expansions of low degree give it to rounding. They are made when a parameter set is prepared and
//! never change afterwards, so that a run depends on nothing but its own inputs; outside of the
//! interval the closed form is evaluated.

mod chebyshev;
mod curve;
mod fit;
mod motion;

pub use curve::{Curve, CurveReport};
pub use fit::{Fit, fit};

use crate::real::Real;

/// Largest degree of a table: where more is needed, the interval is made narrower.
pub const LARGEST_DEGREE: usize = 12;
/// Coefficients of so many powers stand together.
const GROUP: usize = 4;
const GROUPS: usize = LARGEST_DEGREE / GROUP + 1;

/// `N` functions of one coordinate.
#[derive(Clone, Copy, Debug)]
pub struct Table<T, const N: usize> {
    center: T,
    /// 0 if there is no interval.
    half_width: T,
    per_half_width: T,
    error: T,
    degree: usize,
    /// Whether an interval was looked for.
    is_fitted: bool,
    /// Of the power 4i + j of (q - center) / half_width at (i, j).
    coefficients: [[[T; N]; GROUP]; GROUPS],
}

/// What a prepared model says of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct TableReport {
    /// Position of the coordinate among the states.
    pub coordinate: usize,
    /// Middle of the interval, in the coordinate's unit.
    pub center: f64,
    /// Half the interval's length; 0 if no interval was found on which the functions can be had
    /// to rounding, and their closed form is evaluated everywhere.
    pub half_width: f64,
    /// Degree of the polynomials.
    pub degree: usize,
    /// Number of functions.
    pub functions: usize,
    /// Largest difference from the closed form that was measured off the nodes, relative to each
    /// function's largest size on the interval.
    pub error: f64,
}

impl<const N: usize> Table<f64, N> {
    /// A table with an empty interval: the closed form everywhere.
    pub fn none() -> Self {
        Self {
            center: 0.0,
            half_width: 0.0,
            per_half_width: 0.0,
            error: 0.0,
            degree: 0,
            is_fitted: false,
            coefficients: [[[0.0; N]; GROUP]; GROUPS],
        }
    }

    /// The functions `first..first + N` of a fit; those that it does not have are zero.
    pub fn new(fit: &Fit, first: usize) -> Self {
        let mut table = Self::none();
        table.is_fitted = true;
        if fit.half_width > 0.0 {
            table.center = fit.center;
            table.half_width = fit.half_width;
            table.per_half_width = 1.0 / fit.half_width;
            table.error = fit.error;
            table.degree = fit.degree;
            for (power, row) in fit.coefficients.iter().enumerate() {
                let to = &mut table.coefficients[power / GROUP][power % GROUP];
                for (to, from) in to.iter_mut().zip(row.iter().skip(first)) {
                    *to = *from;
                }
            }
        }
        table
    }

    /// Whether a value of the coordinate is inside the interval.
    #[inline(always)]
    pub fn holds(&self, coordinate: f64) -> bool {
        self.inside(coordinate) > 0.0
    }

    /// Whether there is an interval to be in, or might have been, and a value of the coordinate is
    /// outside.
    pub fn is_left_by(&self, coordinate: f64) -> bool {
        self.is_fitted && !self.holds(coordinate)
    }

    /// What there is to say of it, if it is in use; `coordinate` is the coordinate's position among
    /// the states.
    pub fn report(&self, coordinate: usize) -> Option<TableReport> {
        self.is_fitted.then_some(TableReport {
            coordinate,
            center: self.center,
            half_width: self.half_width,
            degree: self.degree,
            functions: N,
            error: self.error,
        })
    }
}

impl<T: Copy, const N: usize> Table<T, N> {
    /// The same with every number turned into another.
    pub fn map<U>(&self, turn: impl Fn(T) -> U) -> Table<U, N> {
        Table {
            center: turn(self.center),
            half_width: turn(self.half_width),
            per_half_width: turn(self.per_half_width),
            error: turn(self.error),
            degree: self.degree,
            is_fitted: self.is_fitted,
            coefficients: self
                .coefficients
                .map(|group| group.map(|row| row.map(&turn))),
        }
    }

    /// Every number joined with the one that stands in its place in `other`. A lower degree is
    /// filled up with zeros, which change nothing.
    pub fn zip<U: Copy, V>(&self, other: &Table<U, N>, join: impl Fn(T, U) -> V) -> Table<V, N> {
        Table {
            center: join(self.center, other.center),
            half_width: join(self.half_width, other.half_width),
            per_half_width: join(self.per_half_width, other.per_half_width),
            error: join(self.error, other.error),
            degree: self.degree.max(other.degree),
            is_fitted: self.is_fitted || other.is_fitted,
            coefficients: std::array::from_fn(|i| {
                std::array::from_fn(|j| {
                    std::array::from_fn(|k| {
                        join(self.coefficients[i][j][k], other.coefficients[i][j][k])
                    })
                })
            }),
        }
    }
}

impl<T: Real, const N: usize> Table<T, N> {
    /// Whether a value of the coordinate is inside the interval, in every lane.
    #[inline(always)]
    pub fn covers(&self, coordinate: T) -> bool {
        self.inside(coordinate).all_positive()
    }

    /// The polynomials in lanes that are inside the interval, what `closed_form` gave in the others:
    /// what a lane gets does not depend on its neighbours.
    #[inline(always)]
    pub fn where_covered(&self, coordinate: T, closed_form: [T; N]) -> [T; N] {
        let inside = self.inside(coordinate);
        if !inside.any_positive() {
            return closed_form;
        }
        let mut near = self.polynomials(coordinate);
        for k in 0..N {
            near[k] = inside.if_positive(near[k], closed_form[k]);
        }
        near
    }

    /// Positive in lanes where there is an interval to be in, or might have been, and a value of the
    /// coordinate is outside.
    #[inline(always)]
    pub fn left_by(&self, coordinate: T) -> T {
        let no = T::from_f64(-1.0);
        if self.is_fitted {
            self.inside(coordinate).if_positive(no, T::from_f64(1.0))
        } else {
            no
        }
    }

    /// Positive where the coordinate is inside the interval.
    #[inline(always)]
    pub(crate) fn inside(&self, coordinate: T) -> T {
        self.half_width - (coordinate - self.center).abs()
    }

    /// The polynomials, whether or not the coordinate is inside.
    #[inline(always)]
    pub fn polynomials(&self, coordinate: T) -> [T; N] {
        let s = (coordinate - self.center) * self.per_half_width;
        // Straight code for each degree that is usual: a loop would take the functions out of their
        // vectors and put them back at every turn. Coefficients beyond the degree are zero.
        match self.degree {
            0..=5 => self.up_to::<5>(s),
            6 => self.up_to::<6>(s),
            7 => self.up_to::<7>(s),
            8..=11 => self.up_to::<11>(s),
            _ => self.up_to::<LARGEST_DEGREE>(s),
        }
    }

    /// Groups of powers side by side (Estrin's scheme), which takes half the time of one power after
    /// the other.
    #[inline(always)]
    fn up_to<const DEGREE: usize>(&self, s: T) -> [T; N] {
        let square = s * s;
        let fourth = square * square;
        let last = DEGREE / GROUP;
        let mut sums = self.coefficients[last][0];
        for k in 0..N {
            sums[k] = self.group::<DEGREE>(last, k, s, square);
        }
        for i in (0..last).rev() {
            for k in 0..N {
                sums[k] = sums[k].times_plus(fourth, self.group::<DEGREE>(i, k, s, square));
            }
        }
        sums
    }

    /// One group of powers of one function, without those above the degree.
    #[inline(always)]
    fn group<const DEGREE: usize>(&self, i: usize, k: usize, s: T, square: T) -> T {
        let c = &self.coefficients[i];
        let low = || c[1][k].times_plus(s, c[0][k]);
        match DEGREE - GROUP * i {
            0 => c[0][k],
            1 => low(),
            2 => c[2][k].times_plus(square, low()),
            _ => c[3][k].times_plus(s, c[2][k]).times_plus(square, low()),
        }
    }
}
