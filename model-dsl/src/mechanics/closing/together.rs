//! Loops that only close together: Newton's method, unrolled.
//!
//! The unknowns of the running configuration follow from those at the last accepted step, which
//! the discrete state holds, by a fixed number of Newton steps. Each step is written out with the
//! symbolic Jacobian, factored without pivoting in an order that was chosen at the drawn
//! configuration. So the right-hand side stays a pure, straight-line function: it runs on lanes and
//! dual numbers as it stands. Where the last step leaves a residual above rounding the unknowns
//! become not-a-number, and the integrator takes a smaller step.

use std::collections::HashMap;

use crate::equations::{Line, Loop, Solve};
use crate::model::BodyId;
use crate::structure::{Way, bodies_named, joints_named};
use crate::symbolic::{Expr, Function, Symbol};

use super::super::Derivation;
use super::super::turned::Turned;
use super::variables::{Dependent, Kind};

/// Newton steps: from 0.1 rad off, each squares the error, so five end below rounding.
const STEPS: usize = 5;

/// Residual in parts of the loops' size that counts as closed.
const TOLERANCE: (i64, i64) = (1, 1_000_000_000_000);

/// Intermediate values that got names, in order.
type Made = Vec<(Symbol, Expr)>;

/// Factors L and U of a matrix with rows and columns in a chosen order.
struct Factors {
    rows: Vec<usize>,
    columns: Vec<usize>,
    lower: Vec<Vec<Expr>>,
    upper: Vec<Vec<Expr>>,
}

impl Derivation<'_> {
    /// Closes several loops for all their unknowns at once.
    pub(super) fn together(&mut self, ways: &[Way], bodies: &[BodyId], number: Option<usize>) {
        let unknowns: Vec<Dependent> = bodies.iter().map(|body| self.dependent(*body)).collect();
        let index = number.map_or_else(String::new, |n| n.to_string());
        let sums: Vec<Vec<Turned>> = ways.iter().map(|way| self.around(way)).collect();
        let names: Vec<String> = ways.iter().map(|way| self.way_name(way)).collect();
        let name = names.join(", ");
        let mut lines: Vec<Line> = sums.iter().map(|sum| self.loop_line(sum)).collect();
        let residuals: Vec<Expr> = sums.iter().flat_map(|sum| self.position(sum)).collect();
        let size = self.loop_size(&sums);

        self.assemble_together(ways, &unknowns, &residuals, size, &name);
        let order = self.pivot_order(&residuals, &unknowns);
        let Some((rows, columns)) = order else {
            let span = self.way_span(&ways[0], bodies);
            let joints = joints_named(self.model, bodies);
            if self.is_led(ways, bodies) {
                self.fault(
                    span,
                    format!(
                        "the loops {name} stand at a dead point as drawn: {joints} do not hold {}",
                        bodies_named(self.model, bodies)
                    ),
                    "assemble them in another configuration: change an angle or a length",
                );
            } else {
                self.fault(
                    span,
                    format!("{} are over-constrained by {joints}: they have no freedom, and as drawn do not hold one another either", bodies_named(self.model, bodies)),
                    "remove a link or a pin between them; a further parallel leg shares its params with the others",
                );
            }
            return;
        };
        let order = (rows.as_slice(), columns.as_slice());
        let closed = self.run_together(&unknowns, &residuals, size, order, &index);
        let listed: Vec<&str> = unknowns
            .iter()
            .map(|unknown| self.g.symbol_text(unknown.symbol))
            .collect();
        lines.push(Line::Text(format!(
            "{} close these loops together: {STEPS} Newton steps from the last accepted step, to a residual of 1e-12 of their size",
            listed.join(", ")
        )));
        let (jacobian, factors) = self.rates_together(&sums, &unknowns, order, &index, &mut lines);
        self.loops_together(&names, &jacobian, &factors, closed, &index);
        let title = if names.len() == 1 { "Loop" } else { "Loops" };
        self.section(&format!("{title} {name}"), lines);
    }

    /// Sum of the sizes of all vectors, of params.
    pub(super) fn loop_size(&mut self, sums: &[Vec<Turned>]) -> Expr {
        let mut sizes = Vec::new();
        for part in sums.iter().flatten().filter(|part| part.slide.is_none()) {
            sizes.push(self.g.function(Function::Abs, &[part.magnitude]));
        }
        sizes.sort_unstable();
        sizes.dedup();
        self.g.sum(&sizes)
    }

    /// The assembled values: solved from the drawn ones when a parameter set is prepared.
    fn assemble_together(
        &mut self,
        ways: &[Way],
        unknowns: &[Dependent],
        residuals: &[Expr],
        size: Expr,
        name: &str,
    ) {
        let mut guesses = Vec::new();
        for unknown in unknowns {
            let guess = self.guess(unknown.body);
            let value = match (guess.value, unknown.kind) {
                (Some(value), _) => value,
                (None, Kind::Position) => self.g.zero(),
                (None, Kind::Angle) => {
                    let body = &self.model.bodies[unknown.body];
                    self.fault(
                        body.span,
                        format!(
                            "`{}` needs an angle: its loops close in several ways",
                            body.name
                        ),
                        "add `angle = …` as you see it in the drawing; it need not be exact",
                    );
                    self.g.zero()
                }
            };
            guesses.push(value);
        }
        let map = self.assembled_map();
        let residuals: Vec<Expr> = residuals
            .iter()
            .map(|residual| self.g.substitute(*residual, &map))
            .collect();
        let bodies: Vec<BodyId> = unknowns.iter().map(|unknown| unknown.body).collect();
        let span = self.way_span(&ways[0], &bodies);
        let failure = self.failure(
            format!("the loops {name} cannot be closed near the drawn configuration"),
            "change a length, or draw the angles nearer to where the loops close",
            span,
            Vec::new(),
        );
        let scales = vec![size; residuals.len()];
        self.definitions
            .push(crate::equations::Definition::Solve(Box::new(Solve {
                name: format!("the loops {name}"),
                unknowns: unknowns.iter().map(|unknown| unknown.assembled).collect(),
                guesses,
                definitions: Vec::new(),
                residuals,
                scales,
                failure,
            })));
    }

    fn jacobian(&mut self, residuals: &[Expr], unknowns: &[Symbol]) -> Vec<Vec<Expr>> {
        let columns: Vec<Vec<Expr>> = unknowns
            .iter()
            .map(|unknown| {
                let rates = HashMap::from([(*unknown, self.g.one())]);
                self.g.derivatives(residuals, &rates)
            })
            .collect();
        (0..residuals.len())
            .map(|row| columns.iter().map(|column| column[row]).collect())
            .collect()
    }

    /// Rows and columns in the order of complete pivoting at the drawn configuration.
    fn pivot_order(
        &mut self,
        residuals: &[Expr],
        unknowns: &[Dependent],
    ) -> Option<(Vec<usize>, Vec<usize>)> {
        let symbols: Vec<Symbol> = unknowns.iter().map(|unknown| unknown.symbol).collect();
        let jacobian = self.jacobian(residuals, &symbols);
        let mut map = self.assembled_map();
        for unknown in unknowns {
            let guess = self
                .guess(unknown.body)
                .value
                .unwrap_or_else(|| self.g.zero());
            map.insert(unknown.symbol, guess);
        }
        let size = residuals.len();
        let mut values = vec![vec![0.0; size]; size];
        for (row, entries) in jacobian.iter().enumerate() {
            for (column, entry) in entries.iter().enumerate() {
                let entry = self.g.substitute(*entry, &map);
                values[row][column] = self.by_default(entry);
            }
        }
        let (mut rows, mut columns): (Vec<usize>, Vec<usize>) =
            ((0..size).collect(), (0..size).collect());
        for step in 0..size {
            let mut best = (0.0, step, step);
            for (i, row) in rows.iter().enumerate().skip(step) {
                for (j, column) in columns.iter().enumerate().skip(step) {
                    let value = values[*row][*column].abs();
                    if value > best.0 {
                        best = (value, i, j);
                    }
                }
            }
            if best.0 < 1e-12 {
                return None;
            }
            rows.swap(step, best.1);
            columns.swap(step, best.2);
            for i in step + 1..size {
                let factor = values[rows[i]][columns[step]] / values[rows[step]][columns[step]];
                for j in step..size {
                    values[rows[i]][columns[j]] -= factor * values[rows[step]][columns[j]];
                }
            }
        }
        Some((rows, columns))
    }

    /// The running values by unrolled Newton steps.
    fn run_together(
        &mut self,
        unknowns: &[Dependent],
        residuals: &[Expr],
        size: Expr,
        order: (&[usize], &[usize]),
        index: &str,
    ) -> Expr {
        let symbols: Vec<Symbol> = unknowns.iter().map(|unknown| unknown.symbol).collect();
        let jacobian = self.jacobian(residuals, &symbols);
        let mut shifts: Vec<Expr> = unknowns
            .iter()
            .map(|unknown| self.turn_reference(unknown))
            .collect();
        let mut made = Made::new();
        for step in 1..=STEPS {
            let map = self.trial_map(unknowns, &shifts);
            let entries: Vec<Vec<Expr>> = jacobian
                .iter()
                .map(|row| {
                    row.iter()
                        .map(|entry| self.g.substitute(*entry, &map))
                        .collect()
                })
                .collect();
            let right: Vec<Expr> = residuals
                .iter()
                .map(|residual| self.g.substitute(*residual, &map))
                .collect();
            let prefix = format!("{index}_{step}");
            let factors = self.factor(&entries, order, &prefix, &mut made);
            let change = self.solve(&factors, &right, &prefix, &mut made);
            shifts = shifts
                .iter()
                .zip(change)
                .zip(unknowns)
                .map(|((shift, change), unknown)| {
                    let value = self.g.sub(*shift, change);
                    let name = format!("Δ{}_{step}", unknown.name);
                    self.named_varying(&name, value, &mut made)
                })
                .collect();
        }
        let map = self.trial_map(unknowns, &shifts);
        let mut worst = self.g.zero();
        for residual in residuals {
            let left = self.g.substitute(*residual, &map);
            let left = self.g.function(Function::Abs, &[left]);
            worst = self.g.function(Function::Max, &[worst, left]);
        }
        let tolerance = self.g.ratio(TOLERANCE.0, TOLERANCE.1);
        let allowed = self.g.mul(tolerance, size);
        let margin = self.g.sub(allowed, worst);
        let closed = self.named_varying(&format!("closed{index}"), margin, &mut made);
        let minus = self.g.integer(-1);
        let invalid = self.g.sqrt(minus);
        for (unknown, shift) in unknowns.iter().zip(shifts) {
            let value = self
                .g
                .function(Function::IfPositive, &[closed, shift, invalid]);
            let body = self.model.bodies[unknown.body].name.clone();
            self.define(
                unknown.shift,
                value,
                format!("`{body}` from its assembled place"),
            );
            let [start, shift] = [unknown.assembled, unknown.shift].map(|s| self.g.of(s));
            let value = self.g.add(start, shift);
            self.define(unknown.symbol, value, String::new());
        }
        closed
    }

    /// The loops, each with the square of what the determinant of their Jacobian is of that as
    /// assembled: zero at a dead point, as the squared sine of a transmission angle is.
    fn loops_together(
        &mut self,
        names: &[String],
        jacobian: &[Vec<Expr>],
        running: &Factors,
        closed: Expr,
        index: &str,
    ) {
        let map = self.assembled_map();
        let entries: Vec<Vec<Expr>> = jacobian
            .iter()
            .map(|row| row.iter().map(|e| self.g.substitute(*e, &map)).collect())
            .collect();
        let order = (running.rows.as_slice(), running.columns.as_slice());
        let assembled = self.factor(&entries, order, &format!("{index}_0"), &mut Made::new());
        let mut ratio = self.g.one();
        for pivot in 0..entries.len() {
            let of = self
                .g
                .div(running.upper[pivot][pivot], assembled.upper[pivot][pivot]);
            ratio = self.g.mul(ratio, of);
        }
        let square = self.g.powi(ratio, 2);
        let minus = self.g.integer(-1);
        let closure = self
            .g
            .function(Function::IfPositive, &[closed, square, minus]);
        for name in names {
            self.loops.push(Loop {
                name: name.clone(),
                closure,
                has_transmission_angle: false,
            });
        }
    }

    fn trial_map(&mut self, unknowns: &[Dependent], shifts: &[Expr]) -> HashMap<Symbol, Expr> {
        unknowns
            .iter()
            .zip(shifts)
            .map(|(unknown, shift)| {
                let start = self.g.of(unknown.assembled);
                (unknown.symbol, self.g.add(start, *shift))
            })
            .collect()
    }

    fn named_varying(&mut self, name: &str, value: Expr, made: &mut Made) -> Expr {
        if self.g.as_symbol(value).is_some() || self.g.as_number(value).is_some() {
            return value;
        }
        let symbol = self.names.symbol(&mut self.g, name);
        self.define(symbol, value, "");
        made.push((symbol, value));
        self.g.of(symbol)
    }

    /// Lines for what was named since the last call.
    fn made_lines(&mut self, made: &mut Made, lines: &mut Vec<Line>) {
        for (symbol, value) in made.drain(..) {
            self.equation_line(lines, symbol, value, "");
        }
    }

    /// What tells the names that belong to one coordinate from those of others.
    fn coordinate_name(&self, coordinate: usize) -> String {
        self.model.bodies[self.coordinates[coordinate].body]
            .name
            .clone()
    }

    /// L U without pivoting, in the given order of rows and columns.
    fn factor(
        &mut self,
        matrix: &[Vec<Expr>],
        order: (&[usize], &[usize]),
        prefix: &str,
        made: &mut Made,
    ) -> Factors {
        let (rows, columns) = (order.0.to_vec(), order.1.to_vec());
        let size = rows.len();
        let zero = self.g.zero();
        let mut lower = vec![vec![zero; size]; size];
        let mut upper = vec![vec![zero; size]; size];
        for i in 0..size {
            for j in 0..size {
                let mut terms = vec![matrix[rows[i]][columns[j]]];
                for k in 0..i.min(j) {
                    let product = self.g.mul(lower[i][k], upper[k][j]);
                    terms.push(self.g.neg(product));
                }
                let value = self.g.sum(&terms);
                if j < i {
                    let value = self.g.div(value, upper[j][j]);
                    let name = format!("L{prefix}_{}_{}", i + 1, j + 1);
                    lower[i][j] = self.named_varying(&name, value, made);
                } else {
                    let name = format!("U{prefix}_{}_{}", i + 1, j + 1);
                    upper[i][j] = self.named_varying(&name, value, made);
                }
            }
        }
        Factors {
            rows,
            columns,
            lower,
            upper,
        }
    }

    /// Solves L U x = right; values on the way are named, so that each is written once.
    fn solve(
        &mut self,
        factors: &Factors,
        right: &[Expr],
        prefix: &str,
        made: &mut Made,
    ) -> Vec<Expr> {
        let size = right.len();
        let mut solution: Vec<Expr> = Vec::with_capacity(size);
        for i in 0..size {
            let mut terms = vec![right[factors.rows[i]]];
            for (lower, known) in factors.lower[i].iter().zip(&solution) {
                let product = self.g.mul(*lower, *known);
                terms.push(self.g.neg(product));
            }
            let value = self.g.sum(&terms);
            let name = format!("y{prefix}_{}", i + 1);
            solution.push(self.named_varying(&name, value, made));
        }
        for i in (0..size).rev() {
            let mut terms = vec![solution[i]];
            for k in i + 1..size {
                let product = self.g.mul(factors.upper[i][k], solution[k]);
                terms.push(self.g.neg(product));
            }
            let value = self.g.sum(&terms);
            let value = self.g.div(value, factors.upper[i][i]);
            // The last one found, the first unknown, is used nowhere else here.
            let name = format!("x{prefix}_{}", i + 1);
            solution[i] = if i == 0 {
                value
            } else {
                self.named_varying(&name, value, made)
            };
        }
        let mut ordered = vec![self.g.zero(); size];
        for (value, column) in solution.into_iter().zip(&factors.columns) {
            ordered[*column] = value;
        }
        ordered
    }

    /// Rates and their rates: linear systems with the Jacobian of the loops.
    fn rates_together(
        &mut self,
        sums: &[Vec<Turned>],
        unknowns: &[Dependent],
        order: (&[usize], &[usize]),
        index: &str,
        lines: &mut Vec<Line>,
    ) -> (Vec<Vec<Expr>>, Factors) {
        let residuals: Vec<Expr> = sums.iter().flat_map(|sum| self.position(sum)).collect();
        let symbols: Vec<Symbol> = unknowns.iter().map(|unknown| unknown.symbol).collect();
        let jacobian = self.jacobian(&residuals, &symbols);
        let mut named = Made::new();
        let factors = self.factor(&jacobian, order, index, &mut named);
        self.made_lines(&mut named, lines);
        let mut right = Vec::new();
        let mut made: Vec<Vec<Option<Symbol>>> = Vec::new();
        for coordinate in 0..self.coordinates.len() {
            // Unknowns have no rates yet: this is the part that the known ones move.
            let moved = self.along(&residuals, coordinate);
            let values: Vec<Expr> = moved.iter().map(|value| self.g.neg(*value)).collect();
            let prefix = format!("{index}_{}", self.coordinate_name(coordinate));
            let rates = self.solve(&factors, &values, &prefix, &mut named);
            self.made_lines(&mut named, lines);
            right.push(values);
            let mut symbols = Vec::new();
            for (unknown, rate) in unknowns.iter().zip(rates) {
                if self.g.is_zero(rate) {
                    symbols.push(None);
                    continue;
                }
                symbols.push(Some(self.dependent_rate(
                    unknown.body,
                    coordinate,
                    rate,
                    lines,
                )));
            }
            made.push(symbols);
        }
        for coordinate in 0..self.coordinates.len() {
            for unknown in unknowns {
                self.attach_rate(unknown.body, coordinate);
            }
        }
        // J ω = b, so J ω' = b' - J' ω.
        let flat: Vec<Expr> = jacobian.iter().flatten().copied().collect();
        for (coordinate, symbols) in made.iter().enumerate() {
            for other in 0..self.coordinates.len() {
                let slopes = self.along(&flat, other);
                let changes = self.along(&right[coordinate].clone(), other);
                let mut values = Vec::new();
                for (row, change) in changes.into_iter().enumerate() {
                    let mut terms = vec![change];
                    for (column, symbol) in symbols.iter().enumerate() {
                        if let Some(symbol) = symbol {
                            let rate = self.g.of(*symbol);
                            let product = self.g.mul(slopes[row * unknowns.len() + column], rate);
                            terms.push(self.g.neg(product));
                        }
                    }
                    values.push(self.g.sum(&terms));
                }
                let [one, two] = [coordinate, other].map(|c| self.coordinate_name(c));
                let prefix = format!("{index}_{one}_{two}");
                let seconds = self.solve(&factors, &values, &prefix, &mut named);
                self.made_lines(&mut named, lines);
                for (symbol, second) in symbols.iter().zip(seconds) {
                    if let Some(symbol) = symbol {
                        self.second_rate(*symbol, other, second, lines);
                    }
                }
            }
        }
        (jacobian, factors)
    }
}
