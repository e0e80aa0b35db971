//! Functions of one coordinate: by table near the start, by their own tape elsewhere.

use super::code::{Arguments, Tape};
use super::{TapePrepared, TapeProgram};
use crate::table::{Table, TableReport, fit};

/// Functions of one coordinate.
#[derive(Clone, Debug, Default)]
pub struct TapeConfiguration {
    /// Position of the coordinate among the states.
    pub coordinate: usize,
    /// Their closed forms.
    pub functions: Tape,
}

/// Functions of a table: as many as a vector of the machine holds, or a multiple.
const WIDTH: usize = 4;
/// Values of functions that are kept on the stack.
const FEW: usize = 32;

/// The functions of all coordinates with a parameter set.
#[derive(Clone, Debug, Default)]
pub(super) struct Configurations {
    /// For each configuration the fixed registers of its tape.
    images: Vec<Vec<f64>>,
    /// For each configuration its functions in tables of [`WIDTH`]; none where closed forms are
    /// evaluated everywhere.
    tables: Vec<Vec<Table<f64, WIDTH>>>,
    /// Number of functions of all configurations.
    count: usize,
}

impl Configurations {
    /// Closed forms everywhere.
    pub fn closed(program: &TapeProgram, image: impl Fn(&Tape) -> Vec<f64>) -> Self {
        let configurations = &program.configurations;
        Self {
            images: configurations
                .iter()
                .map(|configuration| image(&configuration.functions))
                .collect(),
            tables: vec![Vec::new(); configurations.len()],
            count: configurations
                .iter()
                .map(|configuration| configuration.functions.results.len())
                .sum(),
        }
    }

    /// The same with tables, fitted to `system`, whose own closed forms these are.
    pub fn fitted(&self, program: &TapeProgram, system: &TapePrepared) -> Self {
        let tables = program
            .configurations
            .iter()
            .zip(&self.images)
            .map(|(configuration, image)| {
                let place = |pair: &(usize, usize)| pair.0 == configuration.coordinate;
                let Some(which) = program.coordinates.iter().position(place) else {
                    return Vec::new();
                };
                let mut x = system.start_x.clone();
                let count = configuration.functions.results.len();
                let functions = &mut |q: f64, d: &[f64], out: &mut [f64]| {
                    x[configuration.coordinate] = q;
                    let arguments = Arguments::new(0.0, &x, d, &[]);
                    let tape = &configuration.functions;
                    tape.evaluate(image, arguments, &program.tables, out);
                };
                let fit = fit(system, &program.coordinates, which, count, functions);
                let groups = (0..count).step_by(WIDTH);
                groups.map(|first| Table::new(&fit, first)).collect()
            })
            .collect();
        Self {
            tables,
            ..self.clone()
        }
    }

    /// Closed forms everywhere from now on.
    pub fn forget_tables(&mut self, program: &TapeProgram) {
        self.tables = vec![Vec::new(); program.configurations.len()];
    }

    /// Calls `then` with the values of all functions.
    #[inline(always)]
    pub fn with_values(
        &self,
        program: &TapeProgram,
        arguments: Arguments<'_>,
        then: impl FnOnce(&[f64]),
    ) {
        if self.count <= FEW {
            let mut values = [0.0; FEW];
            self.evaluate(program, arguments, &mut values[..self.count]);
            then(&values[..self.count]);
        } else {
            let mut values = vec![0.0; self.count];
            self.evaluate(program, arguments, &mut values);
            then(&values);
        }
    }

    fn evaluate(&self, program: &TapeProgram, arguments: Arguments<'_>, values: &mut [f64]) {
        let mut rest = values;
        for ((configuration, image), tables) in program
            .configurations
            .iter()
            .zip(&self.images)
            .zip(&self.tables)
        {
            let tape = &configuration.functions;
            let (own, others) = rest.split_at_mut(tape.results.len());
            rest = others;
            let q = arguments.x[configuration.coordinate];
            if tables.first().is_some_and(|table| table.holds(q)) {
                for (table, to) in tables.iter().zip(own.chunks_mut(WIDTH)) {
                    to.copy_from_slice(&table.polynomials(q)[..to.len()]);
                }
            } else {
                tape.evaluate(image, arguments, &program.tables, own);
            }
        }
    }

    /// What there is to say of the tables.
    pub fn reports(&self, program: &TapeProgram) -> Vec<TableReport> {
        let pairs = program.configurations.iter().zip(&self.tables);
        pairs
            .filter_map(|(configuration, tables)| {
                Some(TableReport {
                    functions: configuration.functions.results.len(),
                    ..tables.first()?.report(configuration.coordinate)?
                })
            })
            .collect()
    }

    /// Whether a coordinate is outside of its table's interval.
    pub fn is_outside(&self, program: &TapeProgram, x: &[f64]) -> bool {
        let mut pairs = program.configurations.iter().zip(&self.tables);
        pairs.any(|(configuration, tables)| {
            let table = tables.first();
            table.is_some_and(|table| table.is_left_by(x[configuration.coordinate]))
        })
    }
}
