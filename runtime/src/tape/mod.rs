//! The tape: a model as flat arrays of a fixed set of operations, interpreted.
//!
//! ```text
//! TapeModel (immutable, made by the compiler) ──prepare(params)──▶ TapePrepared: System
//! ```
//!
//! Everything that depends on params alone is computed by [`TapeModel::prepare`] in one register
//! file; every other function starts from an image of the values of it that it needs. No compiler
//! is needed at run time, nothing allocates in a right-hand side of ordinary size, and the arrays
//! hold nothing but numbers, so that they can be handed to other machines.

mod code;
mod configuration;
mod lanes;
mod operation;
mod prepare;

pub use code::{Fixed, Instruction, Load, Tape};
pub use configuration::TapeConfiguration;
pub use lanes::TapeLanes;
pub use operation::Operation;
pub use prepare::{Block, Check, PrepareTape, Solve, Step};

use std::borrow::Cow;
use std::sync::Arc;

use crate::diagnostic::Diagnostic;
use crate::simulate::PlainSteps;
use crate::system::{Energy, EventAction, System, Variable};
use crate::table::TableReport;
use code::Arguments;
use configuration::Configurations;

/// A model as tapes: what the command runs. Cheap to clone.
#[derive(Clone, Debug)]
pub struct TapeModel {
    program: Arc<TapeProgram>,
}

/// Everything that a [`TapeModel`] is made of.
#[derive(Clone, Debug, Default)]
pub struct TapeProgram {
    /// Name of the model.
    pub name: String,
    /// Params, in the order in which [`TapeModel::prepare`] takes them; each with its default.
    pub params: Vec<Variable>,
    /// Named alternative values: position among the params, and value.
    pub sets: Vec<(String, Vec<(usize, f64)>)>,
    /// Rows for continuous states.
    pub states: Vec<Variable>,
    /// Rows for discrete states.
    pub discretes: Vec<Variable>,
    /// Rows for inputs.
    pub inputs: Vec<Variable>,
    /// Rows for outputs.
    pub outputs: Vec<Variable>,
    /// Tables of numbers that the code looks up.
    pub tables: Vec<Vec<f64>>,
    /// What depends on params alone.
    pub prepare: PrepareTape,
    /// Positions of the coordinates and of their rates among the states.
    pub coordinates: Vec<(usize, usize)>,
    /// Functions of one coordinate that the right-hand side is computed of.
    pub configurations: Vec<TapeConfiguration>,
    /// Rates of the continuous states.
    pub rhs: Tape,
    /// Entries of the Jacobian that are not zero.
    pub jacobian: Tape,
    /// Outputs.
    pub output_values: Tape,
    /// Kinetic and potential energy, dissipated and supplied power.
    pub energy: Tape,
    /// Times of the next kinks.
    pub next_kinks: Tape,
    /// For each kink the new discrete state.
    pub pass_kink: Vec<Tape>,
    /// Event functions.
    pub events: Tape,
    /// Events in words, and what they do.
    pub event_rows: Vec<TapeEvent>,
    /// Discrete state after an accepted step.
    pub accept: Tape,
    /// Entries of the discrete state that are angles.
    pub turning: Vec<usize>,
    /// Closure of each loop.
    pub closures: Tape,
    /// Names of the loops.
    pub loop_names: Vec<String>,
}

/// What an event is and does.
#[derive(Clone, Debug, Default)]
pub struct TapeEvent {
    /// Its name.
    pub name: String,
    /// Why the run ends there, if it does.
    pub stop: Option<String>,
    /// New continuous states.
    pub states: Tape,
    /// New discrete states.
    pub discretes: Tape,
}

impl TapeModel {
    /// A model of that program.
    pub fn new(program: TapeProgram) -> Self {
        Self {
            program: Arc::new(program),
        }
    }

    /// What it is made of.
    pub fn program(&self) -> &TapeProgram {
        &self.program
    }

    /// Name of the model.
    pub fn name(&self) -> &str {
        &self.program.name
    }

    /// Params in order, each with its default.
    pub fn params(&self) -> &[Variable] {
        &self.program.params
    }

    /// Defaults of all params.
    pub fn defaults(&self) -> Vec<f64> {
        self.program
            .params
            .iter()
            .map(|param| param.start.unwrap_or(f64::NAN))
            .collect()
    }

    /// Closes the loops and computes all that depends on params alone.
    ///
    /// # Errors
    /// What is wrong with the parameter set, in the words of `check`.
    pub fn prepare(&self, params: &[f64]) -> Result<TapePrepared, Diagnostic> {
        let program = &self.program;
        let registers = program
            .prepare
            .run(&program.params, params, &program.tables)?;
        let read = |positions: &[u32]| -> Vec<f64> {
            positions
                .iter()
                .map(|register| registers[*register as usize])
                .collect()
        };
        let start_x = read(&program.prepare.start_states);
        let start_d = read(&program.prepare.start_discretes);
        crate::checks::check_start(&program.states, &start_x)?;
        crate::checks::check_start(&program.discretes, &start_d)?;
        let image = |tape: &Tape| tape.image(&registers);
        let mut prepared = TapePrepared {
            configurations: Configurations::closed(program, image),
            start_x,
            start_d,
            rhs: image(&program.rhs),
            jacobian: image(&program.jacobian),
            outputs: image(&program.output_values),
            energy: image(&program.energy),
            next_kinks: image(&program.next_kinks),
            pass_kink: program.pass_kink.iter().map(image).collect(),
            events: image(&program.events),
            event_states: program
                .event_rows
                .iter()
                .map(|e| image(&e.states))
                .collect(),
            event_discretes: program
                .event_rows
                .iter()
                .map(|e| image(&e.discretes))
                .collect(),
            accept: image(&program.accept),
            closures: image(&program.closures),
            program: Arc::clone(&self.program),
        };
        prepared.configurations = prepared.configurations.fitted(program, &prepared);
        Ok(prepared)
    }
}

/// A model with a parameter set, ready to run.
#[derive(Clone, Debug)]
pub struct TapePrepared {
    program: Arc<TapeProgram>,
    configurations: Configurations<f64>,
    start_x: Vec<f64>,
    start_d: Vec<f64>,
    rhs: Vec<f64>,
    jacobian: Vec<f64>,
    outputs: Vec<f64>,
    energy: Vec<f64>,
    next_kinks: Vec<f64>,
    pass_kink: Vec<Vec<f64>>,
    events: Vec<f64>,
    event_states: Vec<Vec<f64>>,
    event_discretes: Vec<Vec<f64>>,
    accept: Vec<f64>,
    closures: Vec<f64>,
}

impl TapePrepared {
    /// The same without tables: functions of one coordinate in closed form everywhere.
    pub fn exact(mut self) -> Self {
        let program = Arc::clone(&self.program);
        self.configurations.forget_tables(&program);
        self
    }

    fn evaluate(&self, tape: &Tape, image: &[f64], arguments: Arguments<'_, f64>, out: &mut [f64]) {
        tape.evaluate(image, arguments, &self.program.tables, out);
    }
}

impl System for TapePrepared {
    fn states(&self) -> &[Variable] {
        &self.program.states
    }

    fn discretes(&self) -> &[Variable] {
        &self.program.discretes
    }

    fn inputs(&self) -> &[Variable] {
        &self.program.inputs
    }

    fn output_variables(&self) -> &[Variable] {
        &self.program.outputs
    }

    fn start(&self, x: &mut [f64], d: &mut [f64]) {
        x.copy_from_slice(&self.start_x);
        d.copy_from_slice(&self.start_d);
    }

    fn rhs(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], dx: &mut [f64]) {
        let arguments = Arguments::new(t, x, d, u);
        self.configurations
            .with_values(&self.program, arguments, |tabulated| {
                let arguments = Arguments {
                    tabulated,
                    ..arguments
                };
                self.evaluate(&self.program.rhs, &self.rhs, arguments, dx);
            });
    }

    fn jacobian(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], jacobian: &mut [f64]) {
        jacobian.fill(0.0);
        let arguments = Arguments::new(t, x, d, u);
        self.evaluate(&self.program.jacobian, &self.jacobian, arguments, jacobian);
    }

    fn outputs(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], out: &mut [f64]) {
        let arguments = Arguments::new(t, x, d, u);
        self.evaluate(&self.program.output_values, &self.outputs, arguments, out);
    }

    fn energy(&self, t: f64, x: &[f64], d: &[f64], u: &[f64]) -> Energy {
        let mut values = [0.0; 4];
        let arguments = Arguments::new(t, x, d, u);
        self.evaluate(&self.program.energy, &self.energy, arguments, &mut values);
        let [kinetic, potential, dissipated_power, supplied_power] = values;
        Energy {
            kinetic,
            potential,
            dissipated_power,
            supplied_power,
        }
    }

    fn kink_count(&self) -> usize {
        self.program.pass_kink.len()
    }

    fn next_kinks(&self, d: &[f64], times: &mut [f64]) {
        let arguments = Arguments::new(0.0, &[], d, &[]);
        self.evaluate(&self.program.next_kinks, &self.next_kinks, arguments, times);
    }

    fn pass_kink(&self, index: usize, d: &mut [f64]) {
        let before = d.to_vec();
        let arguments = Arguments::new(0.0, &[], &before, &[]);
        self.evaluate(
            &self.program.pass_kink[index],
            &self.pass_kink[index],
            arguments,
            d,
        );
    }

    fn event_count(&self) -> usize {
        self.program.event_rows.len()
    }

    fn events(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], values: &mut [f64]) {
        let arguments = Arguments::new(t, x, d, u);
        self.evaluate(&self.program.events, &self.events, arguments, values);
    }

    fn event_name(&self, index: usize) -> &str {
        &self.program.event_rows[index].name
    }

    fn pass_event(
        &self,
        index: usize,
        t: f64,
        x: &mut [f64],
        d: &mut [f64],
        u: &[f64],
    ) -> EventAction {
        let event = &self.program.event_rows[index];
        let (x_before, d_before) = (x.to_vec(), d.to_vec());
        let arguments = Arguments::new(t, &x_before, &d_before, u);
        self.evaluate(&event.states, &self.event_states[index], arguments, x);
        self.evaluate(&event.discretes, &self.event_discretes[index], arguments, d);
        match &event.stop {
            Some(reason) => EventAction::Stop(Cow::Owned(reason.clone())),
            None => EventAction::Continue,
        }
    }

    fn accept(&self, t: f64, x: &[f64], u: &[f64], d: &mut [f64]) {
        if self.program.accept.results.is_empty() {
            return;
        }
        let before = d.to_vec();
        let arguments = Arguments::new(t, x, &before, u);
        self.evaluate(&self.program.accept, &self.accept, arguments, d);
    }

    fn turning(&self) -> &[usize] {
        &self.program.turning
    }

    fn loop_count(&self) -> usize {
        self.program.loop_names.len()
    }

    fn closures(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], values: &mut [f64]) {
        let arguments = Arguments::new(t, x, d, u);
        self.evaluate(&self.program.closures, &self.closures, arguments, values);
    }

    fn loop_name(&self, index: usize) -> &str {
        &self.program.loop_names[index]
    }

    fn tables(&self) -> Vec<TableReport> {
        self.configurations.reports(&self.program)
    }

    fn is_outside_tables(&self, x: &[f64]) -> bool {
        self.configurations.is_outside(&self.program, x)
    }

    fn take_plain_steps(&self, steps: &mut PlainSteps<'_>) {
        steps.on_lanes(self);
    }
}
