//! Damped Newton's method for small square systems: closing loops and finding equilibria when a
//! parameter set is prepared.
//!
//! A step is halved until it brings the residuals down, so that a guess as a person draws it stays
//! on the branch that was drawn. Where no Newton step helps (the Jacobian is singular, or there is
//! no solution) Levenberg–Marquardt steps walk on to the nearest approach, which either turns out
//! to be a solution or is what the failure reports.

// `!(a > b)` is meant where it stands: what is not a number is then on the safe side.
#![allow(clippy::neg_cmp_op_on_partial_ord)]

use std::fmt;

/// Scaled residuals below this are zero but for rounding.
const CLOSED: f64 = 1e-14;
/// What still counts as a solution where rounding in the residuals allows no better.
const CLOSED_TO_ROUNDING: f64 = 1e-11;
/// A pivot this small, relative to its column, is none.
const SINGULAR_PIVOT: f64 = 1e-13;
const LARGEST_ITERATION_COUNT: usize = 200;
const LARGEST_HALVING_COUNT: usize = 30;

/// How a solution was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NewtonReport {
    /// Steps taken.
    pub iterations: usize,
    /// The largest residual left, in units of its scale.
    pub residual: f64,
}

/// Why there is no solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NewtonFailureReason {
    /// Some residual or derivative is not a finite number at the guess.
    NotFinite,
    /// The residuals have a least value that is not zero: there is no solution near the guess.
    NoSolution,
    /// As [`NoSolution`](Self::NoSolution), and no residual moves with this unknown that others do
    /// not move with already.
    Singular {
        /// Position of the unknown.
        unknown: usize,
    },
}

/// A search that ended without a solution.
#[derive(Clone, Debug, PartialEq)]
pub struct NewtonFailure {
    /// Why.
    pub reason: NewtonFailureReason,
    /// The unknowns at the nearest approach; the guess itself if nothing finite was found.
    pub unknowns: Vec<f64>,
    /// The residuals there, in their own units.
    pub residuals: Vec<f64>,
    /// The largest of them, in units of its scale.
    pub residual: f64,
    /// Steps taken.
    pub iterations: usize,
}

impl fmt::Display for NewtonFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.reason {
            NewtonFailureReason::NotFinite => {
                write!(f, "the equations have no finite value at the guess")
            }
            NewtonFailureReason::NoSolution | NewtonFailureReason::Singular { .. } => write!(
                f,
                "the equations have no solution near the guess: the nearest approach leaves {:.3e} of their scale",
                self.residual
            ),
        }
    }
}

impl std::error::Error for NewtonFailure {}

/// Residuals and their Jacobian at given unknowns.
pub type Evaluate<'e> = dyn FnMut(&[f64], &mut [f64], &mut [f64]) + 'e;

/// Finds the zero of as many residuals as unknowns, from `guess`, which becomes the solution (or,
/// on failure, the nearest approach).
///
/// `scales` is the size of one unit of each residual (a link's length for a gap): a residual is
/// zero when it is rounding error of that. A scale that is not positive and finite counts as 1.
/// `evaluate` is given unknowns and writes residuals and their Jacobian, row by row: ∂rᵢ/∂uⱼ at
/// `i * unknowns + j`. It may write NaN where the equations have no value: such steps are halved.
///
/// # Errors
///
/// If no unknowns near the guess make the residuals zero.
///
/// # Panics
///
/// If `scales` and `guess` differ in length.
pub fn solve(
    guess: &mut [f64],
    scales: &[f64],
    evaluate: &mut Evaluate<'_>,
) -> Result<NewtonReport, NewtonFailure> {
    let n = guess.len();
    assert_eq!(scales.len(), n, "as many scales as unknowns");
    let mut search = Search {
        scales: scales
            .iter()
            .map(|&scale| {
                if scale > 0.0 && scale.is_finite() {
                    scale
                } else {
                    1.0
                }
            })
            .collect(),
        evaluate,
        here: Point::new(guess),
        trial: Point::new(guess),
        iterations: 0,
    };
    search.here = search.evaluated(Point::new(guess));
    if !search.here.is_finite() {
        return Err(search.failure(NewtonFailureReason::NotFinite));
    }
    let outcome = search.run();
    guess.copy_from_slice(&search.here.unknowns);
    outcome
}

/// Unknowns with what was evaluated there; residuals and Jacobian in units of their scales.
#[derive(Clone)]
struct Point {
    unknowns: Vec<f64>,
    residuals: Vec<f64>,
    jacobian: Vec<f64>,
    /// Sum of squares of the residuals.
    merit: f64,
}

impl Point {
    fn new(unknowns: &[f64]) -> Self {
        let n = unknowns.len();
        Self {
            unknowns: unknowns.to_vec(),
            residuals: vec![0.0; n],
            jacobian: vec![0.0; n * n],
            merit: 0.0,
        }
    }

    fn is_finite(&self) -> bool {
        self.merit.is_finite() && self.jacobian.iter().all(|entry| entry.is_finite())
    }

    fn largest_residual(&self) -> f64 {
        self.residuals.iter().fold(0.0, |a, r| f64::max(a, r.abs()))
    }
}

struct Search<'e> {
    scales: Vec<f64>,
    evaluate: &'e mut Evaluate<'e>,
    here: Point,
    trial: Point,
    iterations: usize,
}

impl Search<'_> {
    fn evaluated(&mut self, mut point: Point) -> Point {
        let n = point.unknowns.len();
        (self.evaluate)(&point.unknowns, &mut point.residuals, &mut point.jacobian);
        for (i, &scale) in self.scales.iter().enumerate() {
            point.residuals[i] /= scale;
            for entry in &mut point.jacobian[i * n..(i + 1) * n] {
                *entry /= scale;
            }
        }
        point.merit = point.residuals.iter().map(|r| r * r).sum();
        point
    }

    fn run(&mut self) -> Result<NewtonReport, NewtonFailure> {
        let mut singular = None;
        while self.iterations < LARGEST_ITERATION_COUNT && self.here.merit > 0.0 {
            self.iterations += 1;
            let improved = match self.newton_step() {
                Ok(step) => self.advance(&step, LARGEST_HALVING_COUNT, 1e-4),
                Err(unknown) => {
                    singular = Some(unknown);
                    None
                }
            };
            let closed = self.here.largest_residual() <= CLOSED;
            let improved = match improved {
                None if !closed => self.damped_step(),
                other => other,
            };
            match improved {
                // At rounding level a step is worth taking as long as it still halves the residuals.
                Some(factor) if self.here.largest_residual() > CLOSED || factor < 0.25 => {}
                _ => break,
            }
        }
        let residual = self.here.largest_residual();
        if residual <= CLOSED_TO_ROUNDING {
            return Ok(NewtonReport {
                iterations: self.iterations,
                residual,
            });
        }
        // Whether it is singular where the search ended, not where it passed.
        if singular.is_some() {
            singular = self.newton_step().err();
        }
        Err(self.failure(match singular {
            Some(unknown) => NewtonFailureReason::Singular { unknown },
            None => NewtonFailureReason::NoSolution,
        }))
    }

    /// The full Newton step, or the unknown for which there is no pivot.
    fn newton_step(&self) -> Result<Vec<f64>, usize> {
        let mut matrix = self.here.jacobian.clone();
        let mut step: Vec<f64> = self.here.residuals.iter().map(|r| -r).collect();
        eliminate(&mut matrix, &mut step)?;
        Ok(step)
    }

    /// Goes along `step`, halving it until the sum of the residuals' squares comes down by at least
    /// the share `promise` of the fraction of the step taken; by which factor it did.
    fn advance(&mut self, step: &[f64], halvings: usize, promise: f64) -> Option<f64> {
        let mut fraction = 1.0;
        for _ in 0..=halvings {
            let mut trial = std::mem::replace(&mut self.trial, Point::new(&[]));
            let mut moved = false;
            for ((to, from), s) in trial.unknowns.iter_mut().zip(&self.here.unknowns).zip(step) {
                *to = from + fraction * s;
                moved |= to != from;
            }
            self.trial = self.evaluated(trial);
            if !moved {
                return None;
            }
            let needed = (1.0 - promise * fraction) * self.here.merit;
            if self.trial.is_finite() && self.trial.merit < needed {
                let factor = self.trial.merit / self.here.merit;
                std::mem::swap(&mut self.here, &mut self.trial);
                return Some(factor);
            }
            fraction *= 0.5;
        }
        None
    }

    /// A Levenberg–Marquardt step with as little damping as brings the residuals down.
    fn damped_step(&mut self) -> Option<f64> {
        let n = self.here.unknowns.len();
        let jacobian = self.here.jacobian.clone();
        let mut normal = vec![0.0; n * n];
        let mut gradient = vec![0.0; n];
        for (row, &residual) in jacobian.chunks_exact(n).zip(&self.here.residuals) {
            for i in 0..n {
                gradient[i] -= row[i] * residual;
                for j in 0..n {
                    normal[i * n + j] += row[i] * row[j];
                }
            }
        }
        let largest = (0..n).fold(0.0, |a, i| f64::max(a, normal[i * n + i]));
        let mut damping = 1e-9;
        while damping < 1e9 && largest > 0.0 {
            let mut matrix = normal.clone();
            for i in 0..n {
                let own = normal[i * n + i];
                matrix[i * n + i] += damping * own.max(1e-6 * largest);
            }
            let mut step = gradient.clone();
            if eliminate(&mut matrix, &mut step).is_ok() {
                let before = self.here.merit;
                if let Some(factor) = self.advance(&step, 0, 0.0) {
                    // No progress to speak of: this is the nearest approach.
                    return (before - self.here.merit > 1e-12 * before).then_some(factor);
                }
            }
            damping *= 10.0;
        }
        None
    }

    fn failure(&self, reason: NewtonFailureReason) -> NewtonFailure {
        NewtonFailure {
            reason,
            unknowns: self.here.unknowns.clone(),
            residuals: self
                .here
                .residuals
                .iter()
                .zip(&self.scales)
                .map(|(r, scale)| r * scale)
                .collect(),
            residual: self.here.largest_residual(),
            iterations: self.iterations,
        }
    }
}

/// Solves `matrix · x = right` by Gaussian elimination with partial pivoting; `right` becomes x.
/// The error is the first column that depends on those before it.
fn eliminate(matrix: &mut [f64], right: &mut [f64]) -> Result<(), usize> {
    let n = right.len();
    let sizes: Vec<f64> = (0..n)
        .map(|column| (0..n).fold(0.0, |a, row| f64::max(a, matrix[row * n + column].abs())))
        .collect();
    for column in 0..n {
        let mut pivot = column;
        for row in column + 1..n {
            if matrix[row * n + column].abs() > matrix[pivot * n + column].abs() {
                pivot = row;
            }
        }
        let size = matrix[pivot * n + column].abs();
        if !(size > SINGULAR_PIVOT * sizes[column]) {
            return Err(column);
        }
        if pivot != column {
            for k in 0..n {
                matrix.swap(pivot * n + k, column * n + k);
            }
            right.swap(pivot, column);
        }
        for row in column + 1..n {
            let factor = matrix[row * n + column] / matrix[column * n + column];
            if factor != 0.0 {
                for k in column..n {
                    matrix[row * n + k] -= factor * matrix[column * n + k];
                }
                right[row] -= factor * right[column];
            }
        }
    }
    for column in (0..n).rev() {
        let mut sum = right[column];
        for k in column + 1..n {
            sum -= matrix[column * n + k] * right[k];
        }
        right[column] = sum / matrix[column * n + column];
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The loop of a four-bar with given crank angle: unknown coupler and rocker angles.
    fn four_bar(
        l: [f64; 4],
        crank: f64,
        guess: &mut [f64; 2],
    ) -> Result<NewtonReport, NewtonFailure> {
        solve(guess, &[l[3], l[3]], &mut |u, r, j| {
            let (coupler, rocker) = (u[0], u[1]);
            r[0] = l[0] * crank.cos() + l[1] * coupler.cos() - l[2] * rocker.cos() - l[3];
            r[1] = l[0] * crank.sin() + l[1] * coupler.sin() - l[2] * rocker.sin();
            j[0] = -l[1] * coupler.sin();
            j[1] = l[2] * rocker.sin();
            j[2] = l[1] * coupler.cos();
            j[3] = -l[2] * rocker.cos();
        })
    }

    #[test]
    fn closes_the_double_rocker_as_drawn() {
        let mut angles = [0.0, 90f64.to_radians()];
        let report = four_bar(
            [10.2e-3, 23.2e-3, 10e-3, 25e-3],
            80f64.to_radians(),
            &mut angles,
        )
        .unwrap();
        assert!(report.residual <= 1e-15, "{report:?}");
        assert!((angles[0].to_degrees() - -0.11133329253407).abs() < 1e-12);
        assert!((angles[1].to_degrees() - (-89.83480236430641 + 180.0)).abs() < 1e-12);
    }

    #[test]
    fn reports_the_nearest_approach_of_a_loop_that_cannot_close() {
        // Coupler and rocker span at most 3; O2 is 5.5 from B at least: 2.5 is missing.
        let mut angles = [0.3, 2.0];
        let failure = four_bar([1.0, 1.0, 2.0, 6.5], 0.0, &mut angles).unwrap_err();
        let gap = failure.residuals[0].hypot(failure.residuals[1]);
        assert!((gap - 2.5).abs() < 1e-6, "{failure:?}");
        assert!(!matches!(failure.reason, NewtonFailureReason::NotFinite));
        assert_eq!(failure.unknowns, angles);
    }

    #[test]
    fn halves_steps_that_leave_the_domain() {
        let mut unknown = [3.0];
        let report = solve(&mut unknown, &[1.0], &mut |u, r, j| {
            r[0] = u[0].ln();
            j[0] = 1.0 / u[0];
        })
        .unwrap();
        assert!((unknown[0] - 1.0).abs() < 1e-15, "{report:?}");
    }

    #[test]
    fn names_the_unknown_that_moves_nothing() {
        let mut unknowns = [0.0, 0.0];
        let failure = solve(&mut unknowns, &[1.0, 1.0], &mut |u, r, j| {
            r.copy_from_slice(&[u[0] - 1.0, u[0] + 1.0]);
            j.copy_from_slice(&[1.0, 0.0, 1.0, 0.0]);
        })
        .unwrap_err();
        assert_eq!(failure.reason, NewtonFailureReason::Singular { unknown: 1 });
        assert!((unknowns[0]).abs() < 1e-6);
        assert!((failure.residual - 1.0).abs() < 1e-6);
    }

    #[test]
    fn finds_a_double_root_and_accepts_what_is_already_solved() {
        let mut unknown = [2.0];
        solve(&mut unknown, &[1.0], &mut |u, r, j| {
            r[0] = (u[0] - 1.0).powi(2);
            j[0] = 2.0 * (u[0] - 1.0);
        })
        .unwrap();
        assert!((unknown[0] - 1.0).abs() < 1e-5);
        let report = solve(&mut [1.0], &[1.0], &mut |_, r, j| {
            r[0] = 0.0;
            j[0] = 0.0;
        })
        .unwrap();
        assert_eq!(report.iterations, 0);
        assert!(solve(&mut [], &[], &mut |_, _, _| ()).is_ok());
    }

    #[test]
    fn what_is_not_finite_is_an_error_value() {
        for bad in [f64::NAN, f64::INFINITY] {
            let failure = solve(&mut [bad], &[bad], &mut |u, r, j| {
                r[0] = u[0];
                j[0] = 1.0;
            })
            .unwrap_err();
            assert_eq!(failure.reason, NewtonFailureReason::NotFinite);
        }
    }
}
