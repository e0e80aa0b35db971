//! The shape of a simulator: what integrators ask of a prepared model.
//!
//! A [`System`] is immutable. Its functions are pure: everything that they depend on is an
//! argument. `t` is time, `x` the continuous state, `d` the discrete state (segments of drives,
//! turn references, contact modes), `u` the inputs. `d` changes only when a step is accepted
//! ([`System::accept`]), at a kink of a drive ([`System::pass_kink`]) or at an event
//! ([`System::pass_event`]), never inside a step; that is what makes rejected steps, restarts and
//! any order of work safe. Between such changes the right-hand side is smooth in `t`.

use std::borrow::Cow;

use crate::simulate::PlainSteps;
use crate::table::{CurveReport, TableReport};

/// What a variable is to the system.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Causality {
    /// Fixed for a run, set by the user.
    Parameter,
    /// A signal from outside, constant between calls.
    Input,
    /// Integrated in time.
    State,
    /// Changes only between steps.
    Discrete,
    /// Computed from the others.
    Output,
}

/// One row of the table of variables: it feeds CSV headers, docs and every other reader.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Name as in the model file and in results: `crank.angle`, `Fp`.
    pub name: Cow<'static, str>,
    /// SI unit, `1` if it has none: `rad`, `N/m`.
    pub unit: Cow<'static, str>,
    /// The user's or the compiler's words on it.
    pub meaning: Cow<'static, str>,
    /// What it is to the system.
    pub causality: Causality,
    /// Value at the start where the compiler knows it: a parameter's default, an input's start.
    pub start: Option<f64>,
}

/// An event that was located: what follows from it.
#[derive(Clone, Debug, PartialEq)]
pub enum EventAction {
    /// The state was updated; the run goes on.
    Continue,
    /// The run ends here, for this reason.
    Stop(Cow<'static, str>),
}

/// Energies in J and powers in W of the whole system.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Kinetic energy.
    pub kinetic: f64,
    /// Potential energy: springs, gravity, bristles.
    pub potential: f64,
    /// Power turned to heat by dampers and friction.
    pub dissipated_power: f64,
    /// Power brought in by drives, inputs, preloads and written-out forces.
    pub supplied_power: f64,
}

/// A model with its parameter set: pure functions over plain slices.
///
/// Slices have the lengths that the `*_count` functions state; implementations may panic on others.
pub trait System: Send + Sync {
    /// Rows for states, in the order of `x`.
    fn states(&self) -> &[Variable];
    /// Rows for the discrete state, in the order of `d`.
    fn discretes(&self) -> &[Variable];
    /// Rows for inputs, in the order of `u`, each with its start value.
    fn inputs(&self) -> &[Variable];
    /// Rows for outputs.
    fn output_variables(&self) -> &[Variable];

    /// Continuous and discrete state at the start.
    fn start(&self, x: &mut [f64], d: &mut [f64]);

    /// dx/dt. Where a loop of the mechanism cannot close, entries are NaN.
    fn rhs(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], dx: &mut [f64]);

    /// ∂(dx/dt)/∂x, row by row: entry (i, j) at `i * x.len() + j`.
    fn jacobian(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], jacobian: &mut [f64]);

    /// The model's outputs.
    fn outputs(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], out: &mut [f64]);

    /// Energies and powers.
    fn energy(&self, t: f64, x: &[f64], d: &[f64], u: &[f64]) -> Energy;

    /// Number of drives with kinks.
    fn kink_count(&self) -> usize;
    /// The time of each drive's next kink, given its present segment; infinity for none.
    fn next_kinks(&self, d: &[f64], times: &mut [f64]);
    /// Puts drive `index` into its next segment. The caller stands exactly at its kink.
    fn pass_kink(&self, index: usize, d: &mut [f64]);

    /// Number of event functions.
    fn event_count(&self) -> usize;
    /// Values of the event functions: each event happens where its function rises through zero.
    fn events(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], values: &mut [f64]);
    /// Name of an event, for messages.
    fn event_name(&self, index: usize) -> &str;
    /// Applies event `index` to the state.
    fn pass_event(
        &self,
        index: usize,
        t: f64,
        x: &mut [f64],
        d: &mut [f64],
        u: &[f64],
    ) -> EventAction;

    /// The discrete state after an accepted step that ends in `x` (turn references follow).
    fn accept(&self, t: f64, x: &[f64], u: &[f64], d: &mut [f64]);
    /// Entries of `d` that are angles in rad: a step that moves one by more than π/2 is rejected.
    fn turning(&self) -> &[usize];

    /// Number of loops of the mechanism.
    fn loop_count(&self) -> usize;
    /// For each loop a number that is positive where it closes and zero at a dead point: the squared
    /// sine of its transmission angle. For loops that only close together the square of what
    /// the determinant of their Jacobian is of that as assembled.
    fn closures(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], values: &mut [f64]);
    /// Name of a loop by its bodies: `crank–coupler–rocker`.
    fn loop_name(&self, index: usize) -> &str;

    /// The tables by which the right-hand side has its functions of one coordinate; none if it
    /// evaluates closed forms everywhere.
    fn tables(&self) -> Vec<TableReport> {
        Vec::new()
    }
    /// The curves by which the right-hand side of one trajectory alone has functions of one quantity,
    /// each with the quantity's name; none if it evaluates closed forms everywhere.
    fn curves(&self) -> Vec<(&str, CurveReport)> {
        Vec::new()
    }
    /// Whether a coordinate of `x` is outside of its table's interval, so that the right-hand side
    /// evaluates the closed form there.
    fn is_outside_tables(&self, _x: &[f64]) -> bool {
        false
    }

    /// Takes steps that ask for nothing but the right-hand side by a way of its own, if it has one:
    /// [`PlainSteps::on_lanes`] where the system is a [`LaneSystem`](crate::lanes::LaneSystem).
    fn take_plain_steps(&self, _steps: &mut PlainSteps<'_>) {}
}
