//! The right-hand side as methods step over it: rates of the states, and of two more quantities
//! where energy is accounted for.
//!
//! The energies dissipated and supplied are integrated as two states behind the system's own, by
//! the same stages and weights. So they are as accurate as the motion, samples between steps have
//! them too, and the balance shrinks with the step as the method's order says. Step control does
//! not see them.

use crate::system::{Energy, System};

/// The rates of a system's states, counted.
pub(super) struct Flow<'s, S: System + ?Sized> {
    pub system: &'s S,
    /// Inputs.
    pub u: Vec<f64>,
    /// Number of the system's own states.
    pub states: usize,
    accounts: bool,
    /// Evaluations of the right-hand side.
    pub evaluations: u64,
}

/// Position of the energy dissipated, behind the system's own states.
const DISSIPATED: usize = 0;
/// Position of the energy supplied.
const SUPPLIED: usize = 1;

impl<'s, S: System + ?Sized> Flow<'s, S> {
    pub fn new(system: &'s S, u: Vec<f64>, accounts: bool) -> Self {
        Self {
            system,
            u,
            states: system.states().len(),
            accounts,
            evaluations: 0,
        }
    }

    /// Number of quantities that are integrated.
    pub fn width(&self) -> usize {
        self.states + if self.accounts { 2 } else { 0 }
    }

    pub fn accounts(&self) -> bool {
        self.accounts
    }

    /// Rates at a time and state.
    #[inline]
    pub fn rates(&mut self, t: f64, x: &[f64], d: &[f64], rates: &mut [f64]) {
        self.evaluations += 1;
        let (own, accounts) = rates.split_at_mut(self.states);
        let x = &x[..self.states];
        self.system.rhs(t, x, d, &self.u, own);
        if self.accounts {
            let energy = self.system.energy(t, x, d, &self.u);
            accounts[DISSIPATED] = energy.dissipated_power;
            accounts[SUPPLIED] = energy.supplied_power;
        }
    }

    /// Derivatives of the rates, row by row. Those of powers are taken by differences: they have no
    /// influence on the motion, and none on the accuracy of what they add up to that would show.
    pub fn jacobian(&self, t: f64, x: &[f64], d: &[f64], jacobian: &mut [f64]) {
        let (states, width) = (self.states, self.width());
        let own = &mut jacobian[..states * states];
        self.system.jacobian(t, self.own(x), d, &self.u, own);
        if !self.accounts {
            return;
        }
        for row in (0..states).rev() {
            jacobian.copy_within(row * states..(row + 1) * states, row * width);
            jacobian[row * width + states..(row + 1) * width].fill(0.0);
        }
        jacobian[states * width..].fill(0.0);
        let mut moved = self.own(x).to_vec();
        for column in 0..states {
            let distance = 1e-6 * x[column].abs().max(1e-6);
            moved[column] = x[column] + distance;
            let above = self.system.energy(t, &moved, d, &self.u);
            moved[column] = x[column] - distance;
            let below = self.system.energy(t, &moved, d, &self.u);
            moved[column] = x[column];
            let mut put = |place: usize, above: f64, below: f64| {
                jacobian[(states + place) * width + column] = (above - below) / (2.0 * distance);
            };
            put(DISSIPATED, above.dissipated_power, below.dissipated_power);
            put(SUPPLIED, above.supplied_power, below.supplied_power);
        }
    }

    /// The system's own part of what is integrated.
    pub fn own<'x>(&self, x: &'x [f64]) -> &'x [f64] {
        &x[..self.states]
    }

    pub fn energy(&self, t: f64, x: &[f64], d: &[f64]) -> Energy {
        self.system.energy(t, self.own(x), d, &self.u)
    }

    /// Energy stored in the system, where it is accounted for.
    pub fn stored(&self, t: f64, x: &[f64], d: &[f64]) -> f64 {
        if !self.accounts {
            return 0.0;
        }
        let energy = self.energy(t, x, d);
        energy.kinetic + energy.potential
    }

    /// Books energy that a drive's jump brought in (or, if negative, took away).
    pub fn book_supplied(&self, x: &mut [f64], energy: f64) {
        if self.accounts {
            x[self.states + SUPPLIED] += energy;
        }
    }

    /// Books a jump of the stored energy at an event: a loss has become heat.
    pub fn book_event(&self, x: &mut [f64], gain: f64) {
        if gain < 0.0 && self.accounts {
            x[self.states + DISSIPATED] -= gain;
        } else {
            self.book_supplied(x, gain);
        }
    }

    /// Energies dissipated and supplied since the start.
    pub fn accounted(&self, x: &[f64]) -> (f64, f64) {
        (x[self.states + DISSIPATED], x[self.states + SUPPLIED])
    }
}
