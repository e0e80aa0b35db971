//! What depends on params alone: checks, Newton blocks, the start, and the values that the other
//! functions use.
//!
//! One register file, each register written once; steps run in order. A Newton block writes its
//! unknowns' registers and runs the code of its residuals again and again; the steps after it see
//! the solution.

use super::code::{Instruction, run};
use crate::checks::check_params;
use crate::diagnostic::Diagnostic;
use crate::failure::Failure;
use crate::newton;
use crate::system::Variable;

/// A stretch of straight-line code.
pub type Block = Vec<Instruction>;

/// The code of `prepare`.
#[derive(Clone, Debug, Default)]
pub struct PrepareTape {
    /// Number of registers. The first hold the params.
    pub registers: u32,
    /// Registers that hold numbers.
    pub constants: Vec<(u32, f64)>,
    /// What is done, in order.
    pub steps: Vec<Step>,
    /// Registers of the continuous states at the start.
    pub start_states: Vec<u32>,
    /// Registers of the discrete states at the start.
    pub start_discretes: Vec<u32>,
}

/// A step of `prepare`.
#[derive(Clone, Debug)]
pub enum Step {
    /// Run code.
    Run(Block),
    /// Refuse the parameter set if a margin is not positive.
    Check(Check),
    /// Solve equations.
    Solve(Solve),
}

/// A condition on params.
#[derive(Clone, Debug)]
pub struct Check {
    /// Register that must be positive.
    pub margin: u32,
    /// Whether zero is well too.
    pub zero_is_well: bool,
    /// What to say.
    pub failure: Failure,
    /// Code for the values in the message.
    pub code: Block,
    /// Registers of these values.
    pub values: Vec<u32>,
}

/// Equations to solve by Newton's method.
#[derive(Clone, Debug)]
pub struct Solve {
    /// What is sought.
    pub name: String,
    /// Registers of the unknowns.
    pub unknowns: Vec<u32>,
    /// Registers of the guesses.
    pub guesses: Vec<u32>,
    /// Registers of the residuals' scales.
    pub scales: Vec<u32>,
    /// Code that computes residuals and Jacobian.
    pub code: Block,
    /// Registers of the residuals.
    pub residuals: Vec<u32>,
    /// Registers of the Jacobian, row by row.
    pub jacobian: Vec<u32>,
    /// What to say if there is no solution.
    pub failure: Failure,
    /// Code for the values in the message.
    pub failure_code: Block,
    /// Registers of these values.
    pub values: Vec<u32>,
}

impl PrepareTape {
    /// All registers for a parameter set.
    pub(super) fn run(
        &self,
        rows: &[Variable],
        params: &[f64],
        tables: &[Vec<f64>],
    ) -> Result<Vec<f64>, Diagnostic> {
        check_params(rows, params)?;
        let mut registers = vec![0.0; (self.registers as usize).max(params.len())];
        registers[..params.len()].copy_from_slice(params);
        for (register, value) in &self.constants {
            registers[*register as usize] = *value;
        }
        for step in &self.steps {
            match step {
                Step::Run(code) => run(code, &mut registers, tables),
                Step::Check(check) => check.run(&mut registers, tables)?,
                Step::Solve(solve) => solve.run(&mut registers, tables)?,
            }
        }
        Ok(registers)
    }
}

fn read(registers: &[f64], positions: &[u32]) -> Vec<f64> {
    positions.iter().map(|r| registers[*r as usize]).collect()
}

impl Check {
    fn run(&self, registers: &mut [f64], tables: &[Vec<f64>]) -> Result<(), Diagnostic> {
        let margin = registers[self.margin as usize];
        if margin > 0.0 || (self.zero_is_well && margin == 0.0) {
            return Ok(());
        }
        run(&self.code, registers, tables);
        Err(self.failure.diagnostic(&read(registers, &self.values)))
    }
}

impl Solve {
    fn run(&self, registers: &mut [f64], tables: &[Vec<f64>]) -> Result<(), Diagnostic> {
        let mut unknowns = read(registers, &self.guesses);
        let scales = read(registers, &self.scales);
        let solved = newton::solve(&mut unknowns, &scales, &mut |at, residuals, jacobian| {
            for (register, value) in self.unknowns.iter().zip(at) {
                registers[*register as usize] = *value;
            }
            run(&self.code, registers, tables);
            for (value, register) in residuals.iter_mut().zip(&self.residuals) {
                *value = registers[*register as usize];
            }
            for (value, register) in jacobian.iter_mut().zip(&self.jacobian) {
                *value = registers[*register as usize];
            }
        });
        for (register, value) in self.unknowns.iter().zip(&unknowns) {
            registers[*register as usize] = *value;
        }
        if solved.is_err() {
            run(&self.failure_code, registers, tables);
            return Err(self.failure.diagnostic(&read(registers, &self.values)));
        }
        Ok(())
    }
}
