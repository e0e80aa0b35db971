//! Straight-line code over registers, and the loop that runs it.

use super::operation::{Operands, Operation};
use crate::real::{Real, Work};

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

/// Registers by number.
trait Bank<T> {
    fn read(&self, register: u32) -> T;
    fn write(&mut self, register: u32, value: T);
}

/// Any number of registers; one that does not exist is a panic.
impl<T: Copy> Bank<T> for [T] {
    #[inline(always)]
    fn read(&self, register: u32) -> T {
        self[register as usize]
    }
    #[inline(always)]
    fn write(&mut self, register: u32, value: T) {
        self[register as usize] = value;
    }
}

/// A power of two of registers, of which none needs to be checked.
impl<T: Copy, const N: usize> Bank<T> for [T; N] {
    #[inline(always)]
    fn read(&self, register: u32) -> T {
        const { assert!(N.is_power_of_two()) };
        self[register as usize & (N - 1)]
    }
    #[inline(always)]
    fn write(&mut self, register: u32, value: T) {
        self[register as usize & (N - 1)] = value;
    }
}

/// What an instruction works on.
struct Read<'a, B: ?Sized> {
    bank: &'a B,
    registers: [u32; 3],
    tables: &'a [Vec<f64>],
}

impl<T, B: Bank<T> + ?Sized> Operands<T> for Read<'_, B> {
    #[inline(always)]
    fn first(&self) -> T {
        self.bank.read(self.registers[0])
    }
    #[inline(always)]
    fn second(&self) -> T {
        self.bank.read(self.registers[1])
    }
    #[inline(always)]
    fn third(&self) -> T {
        self.bank.read(self.registers[2])
    }
    #[inline(always)]
    fn table(&self) -> &[f64] {
        &self.tables[self.registers[1] as usize]
    }
}

/// Runs `code` over all `registers`.
pub(super) fn run<T: Real>(code: &[Instruction], registers: &mut [T], tables: &[Vec<f64>]) {
    run_in(code, registers, tables);
}

/// Runs `code`; every register of every instruction must exist.
#[inline(always)]
fn run_in<T: Real, B: Bank<T> + ?Sized>(code: &[Instruction], bank: &mut B, tables: &[Vec<f64>]) {
    for instruction in code {
        let value = instruction.operation.apply(&Read {
            bank: &*bank,
            registers: instruction.operands,
            tables,
        });
        bank.write(instruction.destination, value);
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
    /// A function of one coordinate, counted over all configurations.
    Tabulated(u32),
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
pub(super) struct Arguments<'a, T> {
    pub t: T,
    pub x: &'a [T],
    pub d: &'a [T],
    pub u: &'a [T],
    /// Values of the functions of one coordinate.
    pub tabulated: &'a [T],
}

impl<'a, T> Arguments<'a, T> {
    /// Without functions of one coordinate, which only right-hand sides use.
    pub fn new(t: T, x: &'a [T], d: &'a [T], u: &'a [T]) -> Self {
        let tabulated = &[];
        Self {
            t,
            x,
            d,
            u,
            tabulated,
        }
    }
}

/// Registers that find room on the stack.
const FEW: usize = 256;

impl Tape {
    /// All registers for a prepared parameter set: the fixed ones, and room for the others.
    pub(super) fn image(&self, prepared: &[f64]) -> Vec<f64> {
        let fixed = self.fixed.iter().map(|fixed| match fixed {
            Fixed::Constant(value) => *value,
            Fixed::Prepared(register) => prepared[*register as usize],
        });
        let mut image: Vec<f64> = fixed.collect();
        image.resize(self.registers as usize, 0.0);
        image
    }

    /// Evaluates the function and writes its results to their positions in `out`; other entries of
    /// `out` are left as they are.
    #[inline(always)]
    pub(super) fn evaluate<T: Real>(
        &self,
        image: &[T],
        arguments: Arguments<'_, T>,
        tables: &[Vec<f64>],
        out: &mut [T],
    ) {
        T::out_of_line(Evaluation {
            tape: self,
            image,
            arguments,
            tables,
            out,
        });
    }

    #[inline(always)]
    fn evaluate_here<T: Real>(
        &self,
        image: &[T],
        arguments: Arguments<'_, T>,
        tables: &[Vec<f64>],
        out: &mut [T],
    ) {
        if image.len() <= FEW {
            let mut registers = [T::from_f64(0.0); FEW];
            registers[..image.len()].copy_from_slice(image);
            self.fill(&mut registers, arguments);
            run_in(&self.code, &mut registers, tables);
            self.collect(&registers, out);
        } else {
            self.evaluate_in(&mut image.to_vec(), arguments, tables, out);
        }
    }

    /// The same in registers that hold the fixed values already, and that no other tape uses.
    #[inline(always)]
    pub(super) fn evaluate_in<T: Real>(
        &self,
        registers: &mut [T],
        arguments: Arguments<'_, T>,
        tables: &[Vec<f64>],
        out: &mut [T],
    ) {
        self.update(registers, arguments, tables);
        self.collect(registers, out);
    }

    /// Computes the results in registers that hold the fixed values already.
    #[inline(always)]
    pub(super) fn update<T: Real>(
        &self,
        registers: &mut [T],
        arguments: Arguments<'_, T>,
        tables: &[Vec<f64>],
    ) {
        T::out_of_line(Update {
            tape: self,
            registers,
            arguments,
            tables,
        });
    }

    #[inline(always)]
    fn fill<T: Real>(&self, registers: &mut [T], arguments: Arguments<'_, T>) {
        let first = self.fixed.len();
        for (register, load) in registers[first..].iter_mut().zip(&self.loads) {
            *register = match load {
                Load::Time => arguments.t,
                Load::State(index) => arguments.x[*index as usize],
                Load::Discrete(index) => arguments.d[*index as usize],
                Load::Input(index) => arguments.u[*index as usize],
                Load::Tabulated(index) => arguments.tabulated[*index as usize],
            };
        }
    }

    /// Writes the results to their positions in `out`.
    #[inline(always)]
    pub(super) fn collect<T: Real>(&self, registers: &[T], out: &mut [T]) {
        for (position, register) in &self.results {
            out[*position as usize] = registers[*register as usize];
        }
    }
}

/// A function to be evaluated.
struct Evaluation<'a, T> {
    tape: &'a Tape,
    image: &'a [T],
    arguments: Arguments<'a, T>,
    tables: &'a [Vec<f64>],
    out: &'a mut [T],
}

impl<T: Real> Work for Evaluation<'_, T> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let (image, arguments) = (self.image, self.arguments);
        self.tape
            .evaluate_here(image, arguments, self.tables, self.out);
    }
}

/// Registers to be brought up to date.
struct Update<'a, T> {
    tape: &'a Tape,
    registers: &'a mut [T],
    arguments: Arguments<'a, T>,
    tables: &'a [Vec<f64>],
}

impl<T: Real> Work for Update<'_, T> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        self.tape.fill(self.registers, self.arguments);
        run_in(&self.tape.code, self.registers, self.tables);
    }
}
