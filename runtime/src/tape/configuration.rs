//! Functions of one coordinate: by table near the start, by their own tape elsewhere.

use super::code::{Arguments, Tape};
use super::{TapePrepared, TapeProgram};
use crate::lanes::Lanes;
use crate::real::Real;
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
pub(super) struct Configurations<T> {
    /// For each configuration the fixed registers of its tape.
    images: Vec<Vec<T>>,
    /// For each configuration its functions in tables of [`WIDTH`].
    tables: Vec<Vec<Table<T, WIDTH>>>,
    /// Number of functions of all configurations.
    count: usize,
}

impl Configurations<f64> {
    /// Closed forms everywhere.
    pub fn closed(program: &TapeProgram, image: impl Fn(&Tape) -> Vec<f64>) -> Self {
        let configurations = &program.configurations;
        Self {
            images: configurations
                .iter()
                .map(|configuration| image(&configuration.functions))
                .collect(),
            tables: no_tables(program),
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
                let count = configuration.functions.results.len();
                let Some(which) = program.coordinates.iter().position(place) else {
                    return without_tables(configuration);
                };
                let mut x = system.start_x.clone();
                let functions = &mut |q: f64, d: &[f64], out: &mut [f64]| {
                    x[configuration.coordinate] = q;
                    let arguments = Arguments::new(0.0, &x, d, &[]);
                    let tape = &configuration.functions;
                    tape.evaluate(image, arguments, &program.tables, out);
                };
                let least = vec![0.0; count];
                let fit = fit(system, &program.coordinates, which, &least, functions);
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
        self.tables = no_tables(program);
    }

    /// The same in every lane.
    pub fn in_every_lane<L: Lanes>(&self) -> Configurations<L> {
        let images = self.images.iter();
        let tables = self.tables.iter().map(|tables| tables.iter());
        Configurations {
            images: images
                .map(|image| image.iter().copied().map(L::from_f64).collect())
                .collect(),
            tables: tables
                .map(|tables| tables.map(|table| table.map(L::from_f64)).collect())
                .collect(),
            count: self.count,
        }
    }

    /// Puts this parameter set into one lane.
    pub fn put_in_lane<L: Lanes>(&self, lane: usize, lanes: &mut Configurations<L>) {
        let put = |mut number: L, value: f64| {
            number.set_entry(lane, value);
            number
        };
        for (image, own) in lanes.images.iter_mut().zip(&self.images) {
            for (number, value) in image.iter_mut().zip(own) {
                *number = put(*number, *value);
            }
        }
        for (tables, own) in lanes.tables.iter_mut().zip(&self.tables) {
            for (table, own) in tables.iter_mut().zip(own) {
                *table = table.zip(own, put);
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

impl<L: Lanes> Configurations<L> {
    /// Positive in lanes where a coordinate is outside of its table's interval.
    #[inline(always)]
    pub fn outside_in_lanes(&self, program: &TapeProgram, x: &[L]) -> L {
        let mut outside = L::from_f64(-1.0);
        for (configuration, tables) in program.configurations.iter().zip(&self.tables) {
            if let Some(table) = tables.first() {
                outside = outside.larger(table.left_by(x[configuration.coordinate]));
            }
        }
        outside
    }
}

/// Closed forms everywhere.
fn no_tables(program: &TapeProgram) -> Vec<Vec<Table<f64, WIDTH>>> {
    program.configurations.iter().map(without_tables).collect()
}

fn without_tables(configuration: &TapeConfiguration) -> Vec<Table<f64, WIDTH>> {
    let groups = configuration.functions.results.len().div_ceil(WIDTH);
    vec![Table::none(); groups]
}

impl<T: Real> Configurations<T> {
    /// Calls `then` with the values of all functions.
    #[inline(always)]
    pub fn with_values(
        &self,
        program: &TapeProgram,
        arguments: Arguments<'_, T>,
        then: impl FnOnce(&[T]),
    ) {
        let zero = T::from_f64(0.0);
        if self.count <= FEW {
            let mut values = [zero; FEW];
            self.evaluate(program, arguments, &mut values[..self.count]);
            then(&values[..self.count]);
        } else {
            let mut values = vec![zero; self.count];
            self.evaluate(program, arguments, &mut values);
            then(&values);
        }
    }

    #[inline(always)]
    fn evaluate(&self, program: &TapeProgram, arguments: Arguments<'_, T>, values: &mut [T]) {
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
            let Some(first) = tables.first() else {
                continue;
            };
            let inside = first.inside(q);
            if !inside.all_positive() {
                tape.evaluate(image, arguments, &program.tables, own);
            }
            if inside.any_positive() {
                for (table, to) in tables.iter().zip(own.chunks_mut(WIDTH)) {
                    for (to, near) in to.iter_mut().zip(table.polynomials(q)) {
                        *to = inside.if_positive(near, *to);
                    }
                }
            }
        }
    }
}
