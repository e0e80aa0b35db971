//! Equilibrium: where all accelerations vanish at rest, by Newton's method with the model's own
//! Jacobian.
//!
//! Forces are M q̈ and the stiffness is K = -M ∂q̈/∂q, with the inertia M from the kinetic energy.
//! What is out of balance at first is taken away little by little, (1 - λ) f(q⁰) being left at the
//! load λ, so that the mechanism follows its loads on the branch on which it was assembled.
//! Directions in which nothing elastic holds it stay as they are.

use flexure_runtime::diagnostic::Diagnostic;
use flexure_runtime::failure::{Unit, quantity};
use flexure_runtime::system::System;
use nalgebra::{DMatrix, DVector};

use super::Rest;
use super::linear::Linear;

/// A direction whose stiffness is this small against what surrounds it is free.
const FREE: f64 = 1e-12;
/// Forces along free directions, as a share of all forces, that are rounding.
const BALANCED: f64 = 1e-9;
/// The most that an angle turns in one step, in rad.
const LARGEST_TURN: f64 = 0.3;
const MOST_STEPS: usize = 60;
const SMALLEST_LOAD_STEP: f64 = 1.0 / 1024.0;

/// A state of rest under held drives.
#[derive(Clone, Debug)]
pub struct Equilibrium<'r> {
    pub(super) rest: &'r Rest<'r>,
    pub(super) x: Vec<f64>,
    pub(super) d: Vec<f64>,
    pub(super) here: Balance,
    /// Directions of the coordinates that nothing elastic holds, as columns.
    pub(super) free: DMatrix<f64>,
}

/// Forces and their slopes at a configuration.
#[derive(Clone, Debug)]
pub(super) struct Balance {
    /// M q̈ in N and N·m.
    force: DVector<f64>,
    pub inertia: DMatrix<f64>,
    pub stiffness: DMatrix<f64>,
    /// Of all states, row by row.
    pub jacobian: Vec<f64>,
    pub rates: Vec<f64>,
}

impl Rest<'_> {
    /// The equilibrium with drives and inputs held at `held` (in SI, in the order of
    /// [`Statics::held`](super::Statics::held)), near another equilibrium or near the start.
    ///
    /// # Errors
    ///
    /// If there is none: nothing holds a coordinate against a constant force, a contact would
    /// slide, or the loads lead to where the mechanism gives way.
    pub fn equilibrium(
        &self,
        near: Option<&Equilibrium>,
        held: &[f64],
    ) -> Result<Equilibrium<'_>, Diagnostic> {
        let (mut x, d) = match near {
            Some(near) => (near.x.clone(), near.d.clone()),
            None => (self.x.clone(), self.d.clone()),
        };
        for (signal, value) in self.statics.model.held.iter().zip(held) {
            x[signal.state] = *value;
        }
        for rate in 0..self.statics.model.coordinates {
            x[2 * rate + 1] = 0.0;
        }
        let mut search = Search {
            rest: self,
            here: self.balance(&x, &d),
            x,
            d,
        };
        if !search.here.is_finite() {
            return Err(Diagnostic::error(
                "the forces have no finite value where the equilibrium is sought",
            )
            .hint("look at what `check` says of the model, and at the values of the drives"));
        }
        search.run()?;
        let found = Equilibrium {
            rest: self,
            free: Scaled::new(&search.here.stiffness).free(),
            x: search.x,
            d: search.d,
            here: search.here,
        };
        found.check_contacts()?;
        Ok(found)
    }

    fn balance(&self, x: &[f64], d: &[f64]) -> Balance {
        let (n, all) = (self.statics.model.coordinates, x.len());
        let mut rates = vec![0.0; all];
        let mut jacobian = vec![0.0; all * all];
        self.system.rhs(0.0, x, d, &[], &mut rates);
        self.system.jacobian(0.0, x, d, &[], &mut jacobian);
        let inertia = self.inertia(x, d);
        let accelerations = DVector::from_fn(n, |i, _| rates[2 * i + 1]);
        let slopes = DMatrix::from_fn(n, n, |i, j| jacobian[(2 * i + 1) * all + 2 * j]);
        Balance {
            force: &inertia * accelerations,
            stiffness: -(&inertia * slopes),
            inertia,
            jacobian,
            rates,
        }
    }

    /// M of T = ½ q̇ᵀ M q̇: the energy is exactly quadratic in the rates.
    fn inertia(&self, x: &[f64], d: &[f64]) -> DMatrix<f64> {
        let n = self.statics.model.coordinates;
        let mut moving = x.to_vec();
        let mut kinetic = |rates: &[(usize, f64)]| {
            for &(index, rate) in rates {
                moving[2 * index + 1] += rate;
            }
            let energy = self.system.energy(0.0, &moving, d, &[]).kinetic;
            for index in 0..n {
                moving[2 * index + 1] = 0.0;
            }
            energy
        };
        let own: Vec<f64> = (0..n).map(|i| 2.0 * kinetic(&[(i, 1.0)])).collect();
        DMatrix::from_fn(n, n, |i, j| {
            if i == j {
                return own[i];
            }
            // At rates of equal energy, so that neither drowns the other.
            let rates = [i, j].map(|k| own[k].sqrt().recip());
            let (a, b) = (rates[0], rates[1]);
            let both = kinetic(&[(i, a), (j, b)]) - kinetic(&[(i, a), (j, -b)]);
            both / (2.0 * a * b)
        })
    }
}

impl Balance {
    fn is_finite(&self) -> bool {
        let matrices = self.stiffness.iter().chain(self.inertia.iter());
        self.force.iter().chain(matrices).all(|v| v.is_finite())
    }
}

/// The stiffness in units in which its rows and columns are of size 1.
struct Scaled {
    units: DVector<f64>,
    svd: nalgebra::SVD<f64, nalgebra::Dyn, nalgebra::Dyn>,
}

impl Scaled {
    fn new(stiffness: &DMatrix<f64>) -> Self {
        let n = stiffness.nrows();
        let mut units = DVector::from_element(n, 1.0);
        let mut scaled = stiffness.clone();
        // Equilibration after Ruiz (2001).
        for _ in 0..20 {
            let factors = DVector::from_fn(n, |i, _| {
                let largest = scaled.row(i).amax().max(scaled.column(i).amax());
                if largest > 0.0 {
                    largest.sqrt().recip()
                } else {
                    1.0
                }
            });
            units.component_mul_assign(&factors);
            scaled = DMatrix::from_fn(n, n, |i, j| stiffness[(i, j)] * units[i] * units[j]);
        }
        Self {
            units,
            svd: scaled.svd(true, true),
        }
    }

    fn is_free(&self, index: usize) -> bool {
        self.svd.singular_values[index] <= FREE
    }

    /// The step that `force` causes; free directions stay.
    fn step(&self, force: &DVector<f64>) -> DVector<f64> {
        let mut step = DVector::zeros(force.len());
        let (Some(u), Some(v)) = (&self.svd.u, &self.svd.v_t) else {
            return step;
        };
        let force = force.component_mul(&self.units);
        for k in (0..step.len()).filter(|k| !self.is_free(*k)) {
            let part = u.column(k).dot(&force) / self.svd.singular_values[k];
            step += part * v.row(k).transpose();
        }
        step.component_mul(&self.units)
    }

    /// Free directions as columns.
    fn free(&self) -> DMatrix<f64> {
        let n = self.units.len();
        let columns: Vec<DVector<f64>> = (0..n)
            .filter(|k| self.is_free(*k))
            .filter_map(|k| Some(self.svd.v_t.as_ref()?.row(k).transpose()))
            .map(|direction| direction.component_mul(&self.units))
            .collect();
        match columns.is_empty() {
            true => DMatrix::zeros(n, 0),
            false => DMatrix::from_columns(&columns),
        }
    }

    /// The force in the direction of a coordinate that nothing holds: which, and how much.
    fn unheld(&self, force: &DVector<f64>, size: f64) -> Option<(usize, f64)> {
        let scaled = force.component_mul(&self.units);
        let u = self.svd.u.as_ref()?;
        let loose = (0..scaled.len()).filter(|k| self.is_free(*k));
        let (index, pull) = loose
            .map(|k| (k, u.column(k).dot(&scaled)))
            .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
        let most = u.column(index).iamax();
        (pull.abs() > BALANCED * size).then(|| (most, pull / self.units[most]))
    }
}

struct Search<'r> {
    rest: &'r Rest<'r>,
    x: Vec<f64>,
    d: Vec<f64>,
    here: Balance,
}

impl Search<'_> {
    fn run(&mut self) -> Result<(), Diagnostic> {
        let first = self.here.force.clone();
        let (mut load, mut step) = (0.0, 1.0);
        while load < 1.0 {
            let target = f64::min(load + step, 1.0);
            let before = (self.x.clone(), self.d.clone(), self.here.clone());
            if self.balance_at(&((1.0 - target) * &first))? {
                load = target;
                step *= 2.0;
                continue;
            }
            (self.x, self.d, self.here) = before;
            step *= 0.5;
            if step < SMALLEST_LOAD_STEP {
                return Err(self.gives_way(load));
            }
        }
        Ok(())
    }

    /// Newton steps until the force is `left`; whether that was reached.
    fn balance_at(&mut self, left: &DVector<f64>) -> Result<bool, Diagnostic> {
        let (mut moved, mut last) = (0.0, f64::INFINITY);
        let mut size = 0.0;
        for _ in 0..MOST_STEPS {
            let scaled = Scaled::new(&self.here.stiffness);
            let imbalance = &self.here.force - left;
            let total = self.here.force.component_mul(&scaled.units).amax();
            size = f64::max(size, total);
            let step = scaled.step(&imbalance);
            let length = step.component_div(&scaled.units).amax();
            moved = f64::max(moved, length);
            let settled = length <= 1e-15 * moved || self.is_rounding(&step);
            if settled || (length <= 1e-9 * moved && length >= 0.25 * last) {
                if let Some((index, force)) = scaled.unheld(&imbalance, size) {
                    return Err(self.unheld(index, force));
                }
                return Ok(!self.pass_events());
            }
            last = length;
            if !self.advance(&step, left, &scaled, length <= 1e-6 * moved) {
                return Ok(false);
            }
        }
        Ok(false)
    }

    /// Whether a step is no more than the rounding of the coordinates.
    fn is_rounding(&self, step: &DVector<f64>) -> bool {
        let states = self.rest.statics.states();
        step.iter().enumerate().all(|(index, moved)| {
            let least = f64::from(states[2 * index].unit == "rad");
            moved.abs() <= 32.0 * f64::EPSILON * self.x[2 * index].abs().max(least)
        })
    }

    /// Takes as much of a step as brings the forces down.
    fn advance(
        &mut self,
        step: &DVector<f64>,
        left: &DVector<f64>,
        scaled: &Scaled,
        is_near: bool,
    ) -> bool {
        let states = self.rest.statics.states();
        let turns = (0..step.len()).filter(|i| states[2 * i].unit == "rad");
        let turn = turns.map(|i| step[i].abs()).fold(0.0, f64::max);
        let mut share = f64::min(1.0, LARGEST_TURN / turn);
        let measure = |force: &DVector<f64>| (force - left).component_mul(&scaled.units).norm();
        let now = measure(&self.here.force);
        for _ in 0..30 {
            let mut x = self.x.clone();
            for index in 0..step.len() {
                x[2 * index] += share * step[index];
            }
            let mut d = self.d.clone();
            self.rest.system.accept(0.0, &x, &[], &mut d);
            let there = self.rest.balance(&x, &d);
            // Near the end forces are rounding, and a step is as good as none.
            let tiny = share == 1.0 && is_near;
            if there.is_finite() && (tiny || measure(&there.force) <= now) {
                (self.x, self.d, self.here) = (x, d, there);
                return true;
            }
            share *= 0.5;
        }
        false
    }

    /// Contacts that open or close where the search has come to, and switches: whether any did.
    fn pass_events(&mut self) -> bool {
        let system = &self.rest.system;
        let mut values = vec![0.0; system.event_count()];
        system.events(0.0, &self.x, &self.d, &[], &mut values);
        let mut changed = false;
        for index in (0..values.len()).filter(|k| values[*k] > 0.0) {
            let before = self.d.clone();
            system.pass_event(index, 0.0, &mut self.x, &mut self.d, &[]);
            changed |= before != self.d;
        }
        if changed {
            self.here = self.rest.balance(&self.x, &self.d);
        }
        changed
    }

    fn unheld(&self, index: usize, force: f64) -> Diagnostic {
        let state = &self.rest.statics.states()[2 * index];
        let unit = if state.unit == "rad" { "N*m" } else { "N" };
        Diagnostic::error(format!(
            "there is no equilibrium: nothing elastic holds `{}` against {}",
            state.name,
            quantity(force.abs(), Unit::Other(unit))
        ))
        .hint("hold it by a `spring` or a `hinge` with stiffness, or let a contact stick")
    }

    fn gives_way(&self, load: f64) -> Diagnostic {
        let states = self.rest.statics.states();
        let at: Vec<String> = (0..self.here.force.len())
            .map(|index| {
                let (state, value) = (&states[2 * index], self.x[2 * index]);
                let unit = if state.unit == "rad" {
                    Unit::Degree
                } else {
                    Unit::Metre
                };
                format!("{} = {}", state.name, quantity(value, unit))
            })
            .collect();
        Diagnostic::error(format!(
            "there is no equilibrium near the start: with {:.1} % of what was out of balance taken \
             up, at {}, the mechanism gives way",
            100.0 * load,
            at.join(", ")
        ))
        .hint("reduce the loads or the drive until springs and hinges can hold them")
    }
}

impl<'r> Equilibrium<'r> {
    /// Values of the states of the mechanism, in SI; rates are zero.
    pub fn states(&self) -> &[f64] {
        &self.x[..2 * self.rest.statics.model.coordinates]
    }

    /// Values of the results in SI, in the order of [`Statics::results`](super::Statics::results).
    pub fn results(&self) -> &[f64] {
        &self.here.rates[self.rest.statics.model.first_result..]
    }

    /// Names of the coordinates that take part in motions which nothing elastic holds: they stay
    /// where they were.
    pub fn free(&self) -> Vec<&str> {
        let states = self.rest.statics.states();
        let largest = self.free.column_iter().map(|column| column / column.amax());
        let largest: Vec<DVector<f64>> = largest.collect();
        (0..states.len() / 2)
            .filter(|&i| largest.iter().any(|column| column[i].abs() > 1e-6))
            .map(|i| &*states[2 * i].name)
            .collect()
    }

    /// How the result `output` changes with the drive or input `held`, both by position, the
    /// mechanism following: a dimensionless amplification ratio of two lengths.
    pub fn ratio(&self, output: usize, held: usize) -> f64 {
        let signal = self.rest.statics.model.held[held].state;
        let n = self.here.inertia.nrows();
        let driven = DVector::from_fn(n, |i, _| self.slope(2 * i + 1, signal));
        let moved = Scaled::new(&self.here.stiffness).step(&(&self.here.inertia * driven));
        self.direct(output, held) + self.gradient(output).dot(&moved)
    }

    /// The same with the mechanism held where it is.
    pub fn direct(&self, output: usize, held: usize) -> f64 {
        let signal = self.rest.statics.model.held[held].state;
        self.slope(self.rest.statics.model.first_result + output, signal)
    }

    /// Stiffness at a result that tells a place or an angle: the force in its direction that moves
    /// it by one unit, drives held, in N/m or N·m/rad. Infinite where it cannot move, zero where
    /// nothing elastic holds it.
    pub fn stiffness(&self, output: usize) -> f64 {
        let lever = self.gradient(output);
        let loose = self.free.transpose() * &lever;
        let size = self.free.map(f64::abs).transpose() * lever.map(f64::abs);
        if loose
            .iter()
            .zip(size.iter())
            .any(|(l, s)| l.abs() > 1e-9 * s)
        {
            return 0.0;
        }
        let moved = Scaled::new(&self.here.stiffness).step(&lever);
        lever.dot(&moved).recip()
    }

    /// ∂(result)/∂q.
    fn gradient(&self, output: usize) -> DVector<f64> {
        let row = self.rest.statics.model.first_result + output;
        DVector::from_fn(self.here.inertia.nrows(), |i, _| self.slope(row, 2 * i))
    }

    pub(super) fn slope(&self, row: usize, column: usize) -> f64 {
        self.here.jacobian[row * self.x.len() + column]
    }

    /// The linear model about this equilibrium.
    pub fn linear(&self) -> Linear {
        Linear::new(self)
    }

    fn check_contacts(&self) -> Result<(), Diagnostic> {
        for (name, friction, holds) in &self.rest.statics.model.contacts {
            let (friction, holds) = (self.results()[*friction], self.results()[*holds]);
            if friction.abs() > holds * (1.0 + 1e-9) {
                return Err(Diagnostic::error(format!(
                    "there is no equilibrium with contact `{name}` as it is: it would take {} of \
                     friction, and {} holds",
                    quantity(friction.abs(), Unit::Other("N")),
                    quantity(holds, Unit::Other("N"))
                ))
                .hint(format!(
                    "let it stick whatever it takes, `--stick {name}`, or leave it out, `--without {name}`"
                )));
            }
        }
        Ok(())
    }
}
