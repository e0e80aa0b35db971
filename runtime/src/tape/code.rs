//! Straight-line code over registers, and the loop that runs it.

use super::operation::Operation;
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
struct Few<T, const N: usize>([T; N]);

impl<T: Copy, const N: usize> Bank<T> for Few<T, N> {
    #[inline(always)]
    fn read(&self, register: u32) -> T {
        const { assert!(N.is_power_of_two()) };
        self.0[register as usize & (N - 1)]
    }
    #[inline(always)]
    fn write(&mut self, register: u32, value: T) {
        const { assert!(N.is_power_of_two()) };
        self.0[register as usize & (N - 1)] = value;
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
        let [first, second, third] = instruction.operands;
        let value = instruction.operation.apply(
            bank.read(first),
            || bank.read(second),
            || bank.read(third),
            || &tables[second as usize],
        );
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

/// Registers that are cheap to clear, on the stack.
const FEW: usize = 128;
/// Registers that still fit on the stack.
const SEVERAL: usize = 1024;

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
        let zero = T::from_f64(0.0);
        let count = self.registers as usize;
        if count <= FEW {
            let mut few = Few([zero; FEW]);
            self.fill(&mut few.0, image, arguments);
            run_in(&self.code, &mut few, tables);
            self.collect(&few.0, out);
        } else if count <= SEVERAL {
            let mut several = Few([zero; SEVERAL]);
            self.fill(&mut several.0, image, arguments);
            run_in(&self.code, &mut several, tables);
            self.collect(&several.0, out);
        } else {
            let mut many = vec![zero; count];
            self.fill(&mut many, image, arguments);
            run_in(&self.code, many.as_mut_slice(), tables);
            self.collect(&many, out);
        }
    }

    #[inline(always)]
    fn fill<T: Real>(&self, registers: &mut [T], image: &[T], arguments: Arguments<'_, T>) {
        registers[..image.len()].copy_from_slice(image);
        for (register, load) in registers[image.len()..].iter_mut().zip(&self.loads) {
            *register = match load {
                Load::Time => arguments.t,
                Load::State(index) => arguments.x[*index as usize],
                Load::Discrete(index) => arguments.d[*index as usize],
                Load::Input(index) => arguments.u[*index as usize],
                Load::Tabulated(index) => arguments.tabulated[*index as usize],
            };
        }
    }

    #[inline(always)]
    fn collect<T: Real>(&self, registers: &[T], out: &mut [T]) {
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
