//! The linear model about an equilibrium: ẋ = A x + B u, y = C x + D u, for small deviations.

use nalgebra::{Complex, DMatrix};

use super::equilibrium::Equilibrium;
use super::modes::{self, Mode};

/// A, B, C and D with the names of what they stand for. Each drive is two inputs, its value and
/// its rate in time, because dampers beside a stack see the latter.
#[derive(Clone, Debug, PartialEq)]
pub struct Linear {
    /// ∂ẋ/∂x.
    pub a: DMatrix<f64>,
    /// ∂ẋ/∂u.
    pub b: DMatrix<f64>,
    /// ∂y/∂x.
    pub c: DMatrix<f64>,
    /// ∂y/∂u.
    pub d: DMatrix<f64>,
    /// Name and SI unit of each state: coordinates and their rates.
    pub states: Vec<(String, String)>,
    /// Name and SI unit of each input.
    pub inputs: Vec<(String, String)>,
    /// Name and SI unit of each output.
    pub outputs: Vec<(String, String)>,
    /// Positions among the inputs of each drive's or input's value, and of its rate.
    signals: Vec<(usize, Option<usize>)>,
    /// Inertia of the coordinates in kg and kg·m².
    pub(super) inertia: DMatrix<f64>,
    /// Stiffness of the coordinates.
    pub(super) stiffness: DMatrix<f64>,
    /// Free directions as columns.
    pub(super) free: DMatrix<f64>,
}

impl Linear {
    pub(super) fn new(at: &Equilibrium) -> Self {
        let statics = at.rest.statics;
        let all = &statics.tape.program().states;
        let mut columns = Vec::new();
        let mut signals = Vec::new();
        for held in &statics.model.held {
            let value = columns.len();
            columns.push(held.state);
            signals.push((value, held.rate.map(|_| value + 1)));
            columns.extend(held.rate);
        }
        let names = |positions: &[usize]| -> Vec<(String, String)> {
            let rows = positions.iter().map(|&position| &all[position]);
            rows.map(|row| (row.name.to_string(), row.unit.to_string()))
                .collect()
        };
        let states: Vec<usize> = (0..2 * statics.model.coordinates).collect();
        let results: Vec<usize> = (statics.model.first_result..all.len()).collect();
        let part = |rows: &[usize], columns: &[usize]| {
            DMatrix::from_fn(rows.len(), columns.len(), |i, j| {
                at.slope(rows[i], columns[j])
            })
        };
        Self {
            a: part(&states, &states),
            b: part(&states, &columns),
            c: part(&results, &states),
            d: part(&results, &columns),
            states: names(&states),
            inputs: names(&columns),
            outputs: names(&results),
            signals,
            inertia: at.here.inertia.clone(),
            stiffness: at.here.stiffness.clone(),
            free: at.free.clone(),
        }
    }

    /// The modes, slowest first; free ones before them.
    pub fn modes(&self) -> Vec<Mode> {
        modes::modes(self)
    }

    /// Response of an output to the drive or input `held` at a frequency in Hz: the ratio of their
    /// complex amplitudes, in the output's SI unit over the drive's. `None` at an undamped
    /// resonance.
    pub fn response(&self, held: usize, output: usize, frequency: f64) -> Option<Complex<f64>> {
        let s = Complex::new(0.0, std::f64::consts::TAU * frequency);
        let (value, rate) = self.signals[held];
        let with_rate = |matrix: &DMatrix<f64>, row: usize| {
            let direct = Complex::from(matrix[(row, value)]);
            rate.map_or(direct, |rate| direct + s * matrix[(row, rate)])
        };
        let n = self.a.nrows();
        let resolvent = DMatrix::from_fn(n, n, |i, j| {
            let own = if i == j { s } else { Complex::from(0.0) };
            own - self.a[(i, j)]
        });
        let driven = DMatrix::from_fn(n, 1, |i, _| with_rate(&self.b, i));
        let moved = resolvent.lu().solve(&driven)?;
        let seen = (0..n).map(|j| moved[j] * self.c[(output, j)]);
        let response = with_rate(&self.d, output) + seen.sum::<Complex<f64>>();
        (response.re.is_finite() && response.im.is_finite()).then_some(response)
    }
}
