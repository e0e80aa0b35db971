//! A compiled mechanism, asked at single states: outputs, accelerations, equilibrium, modes.

use flexure_runtime::system::{Energy, System};
use flexure_runtime::tape::TapePrepared;
use nalgebra::{DMatrix, DVector};

use super::by_hand::ByHand;
use super::random::Random;
use super::{Compiled, tape};

/// A mechanism whose states are the values and rates of its coordinates.
pub struct Probe {
    name: String,
    system: TapePrepared,
    values: Vec<usize>,
    rates: Vec<usize>,
}

impl Probe {
    /// The compiled model with some of its params changed.
    pub fn new(compiled: &Compiled, changes: &[(&str, f64)]) -> Self {
        let coordinates = compiled.coordinates();
        let probe = Self {
            name: compiled.oracle.equations.name.clone(),
            system: tape(compiled, changes),
            values: coordinates.iter().map(|c| c.1).collect(),
            rates: coordinates.iter().map(|c| c.2).collect(),
        };
        assert_eq!(probe.system.states().len(), 2 * coordinates.len());
        probe
    }

    /// Values of the coordinates as assembled.
    pub fn start(&self) -> Vec<f64> {
        let (mut x, mut d) = self.empty();
        self.system.start(&mut x, &mut d);
        self.values.iter().map(|value| x[*value]).collect()
    }

    fn empty(&self) -> (Vec<f64>, Vec<f64>) {
        let (states, discretes) = (self.system.states(), self.system.discretes());
        (vec![0.0; states.len()], vec![0.0; discretes.len()])
    }

    /// State and discrete state at a place less than half a turn from the assembled one.
    fn state(&self, q: &[f64], rates: &[f64], t: f64) -> (Vec<f64>, Vec<f64>) {
        let (mut x, mut d) = self.empty();
        self.system.start(&mut x, &mut d);
        for (index, (value, rate)) in q.iter().zip(rates).enumerate() {
            x[self.values[index]] = *value;
            x[self.rates[index]] = *rate;
        }
        self.system.accept(t, &x, &[], &mut d);
        (x, d)
    }

    /// An output by name.
    pub fn output(&self, name: &str, q: &[f64], rates: &[f64], t: f64) -> f64 {
        let (x, d) = self.state(q, rates, t);
        let names = self.system.output_variables();
        let mut out = vec![0.0; names.len()];
        self.system.outputs(t, &x, &d, &[], &mut out);
        let found = names.iter().position(|output| output.name == name);
        out[found.unwrap_or_else(|| panic!("there is an output `{name}`"))]
    }

    /// Energies and powers.
    pub fn energy(&self, q: &[f64], rates: &[f64], t: f64) -> Energy {
        let (x, d) = self.state(q, rates, t);
        self.system.energy(t, &x, &d, &[])
    }

    /// Accelerations of the coordinates.
    pub fn accelerations(&self, q: &[f64], rates: &[f64], t: f64) -> Vec<f64> {
        let (x, d) = self.state(q, rates, t);
        let mut dx = vec![0.0; x.len()];
        self.system.rhs(t, &x, &d, &[], &mut dx);
        self.rates.iter().map(|rate| dx[*rate]).collect()
    }

    /// Accelerations by the coordinates, at rest.
    fn slopes(&self, q: &[f64], t: f64) -> DMatrix<f64> {
        let (x, d) = self.state(q, &vec![0.0; q.len()], t);
        let mut all = vec![0.0; x.len() * x.len()];
        self.system.jacobian(t, &x, &d, &[], &mut all);
        DMatrix::from_fn(q.len(), q.len(), |i, j| {
            all[self.rates[i] * x.len() + self.values[j]]
        })
    }

    /// Where it stays at rest, from a configuration nearby, the time standing still.
    pub fn equilibrium(&self, near: &[f64], t: f64) -> Vec<f64> {
        let rest = vec![0.0; near.len()];
        let mut q = DVector::from_column_slice(near);
        for _ in 0..20 {
            let pull = DVector::from_vec(self.accelerations(q.as_slice(), &rest, t));
            let slopes = self.slopes(q.as_slice(), t);
            q -= slopes.lu().solve(&pull).expect("a stiff mechanism");
        }
        q.as_slice().to_vec()
    }

    /// Natural frequencies in rad/s, undamped, about an equilibrium, lowest first.
    pub fn frequencies(&self, q: &[f64], t: f64) -> Vec<f64> {
        let values = (-self.slopes(q, t)).complex_eigenvalues();
        let mut found: Vec<f64> = values.iter().map(|value| value.re.sqrt()).collect();
        found.sort_by(f64::total_cmp);
        found
    }

    /// Compares energies and accelerations with the mechanism written down by hand, at states
    /// away from rest: coordinates up to `turn` rad from `about`, rates up to `rate`.
    pub fn compare(&self, hand: &ByHand<'_>, about: &[f64], turn: f64, rate: f64) {
        let mut random = Random::new(41);
        let start = self.start();
        let still = vec![0.0; start.len()];
        let zero = hand.potential(&start, 0.0) - self.energy(&start, &still, 0.0).potential;
        let (mut worst, mut worst_energy): (f64, f64) = (0.0, 0.0);
        for _ in 0..30 {
            let moved = about.iter().map(|q| q + random.between(-turn, turn));
            let q: Vec<f64> = moved.collect();
            let rates: Vec<f64> = start.iter().map(|_| random.between(-rate, rate)).collect();
            let t = random.between(0.0, 0.05);
            let found = self.accelerations(&q, &rates, t);
            let error = hand.imbalance(&q, &rates, t, &found);
            assert!(
                error < 1e-10,
                "{}: {q:?}, {rates:?}: off by {error:e}",
                self.name
            );
            worst = worst.max(error);
            let energy = self.energy(&q, &rates, 0.0);
            let v = DVector::from_column_slice(&rates);
            let kinetic = 0.5 * v.dot(&(hand.inertia(&q, t) * &v));
            let potential = hand.potential(&q, 0.0) - zero;
            let scale = energy.potential.abs() + zero.abs();
            let error = (energy.kinetic - kinetic).abs() / kinetic
                + (energy.potential - potential).abs() / scale;
            assert!(
                error < 1e-11,
                "{}: {q:?}, {rates:?}: off by {error:e}",
                self.name
            );
            worst_energy = worst_energy.max(error);
        }
        println!(
            "{}: balance of forces off by {worst:.1e}, energies by {worst_energy:.1e}",
            self.name
        );
    }
}
