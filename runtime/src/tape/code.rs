//! Straight-line code over registers, and the loop that runs it.

use super::operation::Operation;
use crate::real::Real;

/// One step: `registers[destination] = operation(registers[a], registers[b], registers[c])`.
///
/// Operands beyond the operation's arity are 0, except that `b` of [`Operation::Lookup`] is the
/// position of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instruction {
    /// What is done.
    pub operation: Operation,
    /// Register that is written.
    pub destination: u32,
    /// Registers that are read.
    pub operands: [u32; 3],
}

/// Runs `code` over `registers`; every register of every instruction must exist.
pub(super) fn run<T: Real>(code: &[Instruction], registers: &mut [T], tables: &[Vec<f64>]) {
    for instruction in code {
        let [a, b, c] = instruction.operands.map(|operand| operand as usize);
        let table: &[f64] = match instruction.operation {
            Operation::Lookup => &tables[b],
            _ => &[],
        };
        let b = match instruction.operation {
            Operation::Lookup => a,
            _ => b,
        };
        registers[instruction.destination as usize] =
            instruction
                .operation
                .apply(registers[a], registers[b], registers[c], table);
    }
}

/// Where a register's value comes from before the code runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Load {
    /// Time.
    Time,
    /// A continuous state.
    State(u32),
    /// A discrete state.
    Discrete(u32),
    /// An input.
    Input(u32),
}

/// What the first registers hold: fixed when a parameter set is prepared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fixed {
    /// A number.
    Constant(f64),
    /// A register of the preparing code.
    Prepared(u32),
}

/// A function of time, state and inputs as a tape: registers are first the fixed values, then the
/// loads, then what the code writes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tape {
    /// Contents of registers from 0.
    pub fixed: Vec<Fixed>,
    /// What the registers after the fixed ones hold.
    pub loads: Vec<Load>,
    /// The code.
    pub code: Vec<Instruction>,
    /// Number of registers.
    pub registers: u32,
    /// Position in the result and the register that holds it.
    pub results: Vec<(u32, u32)>,
}

/// Arguments of a function.
#[derive(Clone, Copy)]
pub(super) struct Arguments<'a> {
    pub t: f64,
    pub x: &'a [f64],
    pub d: &'a [f64],
    pub u: &'a [f64],
}

/// Registers that fit on the stack without much cost of clearing them.
const SMALL: usize = 96;
const MEDIUM: usize = 512;

impl Tape {
    /// The fixed registers for a prepared parameter set.
    pub(super) fn image(&self, prepared: &[f64]) -> Vec<f64> {
        self.fixed
            .iter()
            .map(|fixed| match fixed {
                Fixed::Constant(value) => *value,
                Fixed::Prepared(register) => prepared[*register as usize],
            })
            .collect()
    }

    /// Evaluates the function and writes its results to their positions in `out`; other entries of
    /// `out` are left as they are.
    pub(super) fn evaluate(
        &self,
        image: &[f64],
        arguments: Arguments<'_>,
        tables: &[Vec<f64>],
        out: &mut [f64],
    ) {
        let count = self.registers as usize;
        if count <= SMALL {
            self.evaluate_in(&mut [0.0; SMALL][..count], image, arguments, tables, out);
        } else if count <= MEDIUM {
            self.evaluate_in(&mut [0.0; MEDIUM][..count], image, arguments, tables, out);
        } else {
            self.evaluate_in(&mut vec![0.0; count], image, arguments, tables, out);
        }
    }

    #[inline(always)]
    fn evaluate_in(
        &self,
        registers: &mut [f64],
        image: &[f64],
        arguments: Arguments<'_>,
        tables: &[Vec<f64>],
        out: &mut [f64],
    ) {
        registers[..image.len()].copy_from_slice(image);
        for (register, load) in registers[image.len()..].iter_mut().zip(&self.loads) {
            *register = match load {
                Load::Time => arguments.t,
                Load::State(index) => arguments.x[*index as usize],
                Load::Discrete(index) => arguments.d[*index as usize],
                Load::Input(index) => arguments.u[*index as usize],
            };
        }
        run(&self.code, registers, tables);
        for (position, register) in &self.results {
            out[*position as usize] = registers[*register as usize];
        }
    }
}
