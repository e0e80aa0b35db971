//! Coupled: a block of several coordinates, M q̈ + h + ∂P/∂q = τ entry by entry, and solved.

use std::collections::BTreeMap;

use crate::equations::Line;
use crate::symbolic::{Expr, Symbol};

use super::Derivation;
use super::inertia::Inertia;
use super::motion::Loads;

/// Derivatives of the entries of M that have names, by entry and coordinate.
#[derive(Default)]
struct Slopes {
    known: BTreeMap<(usize, usize, usize), Expr>,
}

impl Derivation<'_> {
    /// h_i = Σ_jk (∂M_ij/∂q_k - ½ ∂M_jk/∂q_i) q̇_j q̇_k.
    pub(super) fn velocity_terms(&mut self, index: usize, inertia: &Inertia) -> Expr {
        self.christoffel(index, inertia, |this, (j, k), by| {
            this.gradient(inertia.matrix[j][k])[by]
        })
    }

    /// The same by derivatives of M's entries as `slope` gives them: each pair of rates once.
    fn christoffel<F>(&mut self, index: usize, inertia: &Inertia, mut slope: F) -> Expr
    where
        F: FnMut(&mut Self, (usize, usize), usize) -> Expr,
    {
        let mut pairs: Vec<(usize, usize)> = inertia
            .concerning(index)
            .into_iter()
            .map(|(j, k)| (j.min(k), j.max(k)))
            .collect();
        pairs.sort_unstable();
        pairs.dedup();
        let half = self.g.ratio(1, 2);
        let mut terms = Vec::new();
        for (j, k) in pairs {
            let own = slope(self, (j, k), index);
            let factor = if j == k {
                let by_other = slope(self, (index, j), j);
                let own = self.g.mul(half, own);
                self.g.sub(by_other, own)
            } else {
                let first = slope(self, (index, j), k);
                let second = slope(self, (index, k), j);
                let own = self.g.neg(own);
                self.g.sum(&[first, second, own])
            };
            let rates = [j, k].map(|other| self.g.of(self.coordinates[other].rate));
            terms.push(self.g.product(&[factor, rates[0], rates[1]]));
        }
        self.g.sum(&terms)
    }

    /// A derivative of an entry of M by its name.
    fn named_slope(
        &mut self,
        slopes: &mut Slopes,
        inertia: &Inertia,
        (j, k): (usize, usize),
        by: usize,
    ) -> Expr {
        let (j, k) = (j.min(k), j.max(k));
        if let Some(&known) = slopes.known.get(&(j, k, by)) {
            return known;
        }
        let value = self.gradient(inertia.matrix[j][k])[by];
        let is_plain = self.g.as_symbol(value).is_some() || self.g.as_number(value).is_some();
        let slope = if is_plain {
            value
        } else {
            let q = self.coordinates[by].symbol;
            let entry = self.entry_name(j, k);
            let text = format!("∂{entry}/∂{}", self.g.symbol_text(q));
            let latex = format!(
                "\\frac{{\\partial {}}}{{\\partial {}}}",
                crate::notation::latex_of(&entry),
                self.g.symbol_latex(q)
            );
            let symbol = self.names.symbol_with_latex(&mut self.g, &text, &latex);
            self.define(symbol, value, "slope of the inertia");
            self.g.of(symbol)
        };
        slopes.known.insert((j, k, by), slope);
        slope
    }

    /// `M12`, by the digits of the coordinates if each has one, else by their positions.
    fn entry_name(&self, j: usize, k: usize) -> String {
        let [j, k] = [j, k].map(|index| self.digits(index));
        if j.len() == 1 && k.len() == 1 {
            format!("M{j}{k}")
        } else {
            format!("M_{j}_{k}")
        }
    }

    fn digits(&self, index: usize) -> String {
        let mut labels: Vec<String> = (0..self.coordinates.len())
            .map(|index| self.coordinate_label(index))
            .collect();
        let is_digit = |label: &String| label.len() == 1 && label.as_bytes()[0].is_ascii_digit();
        let mut distinct = labels.clone();
        distinct.sort_unstable();
        distinct.dedup();
        if distinct.len() == labels.len() && labels.iter().all(is_digit) {
            labels.swap_remove(index)
        } else {
            (index + 1).to_string()
        }
    }

    /// A block of several: M and h by entries, M q̈ = τ - ∂P/∂q - h by L D Lᵀ, unrolled.
    pub(super) fn coupled(&mut self, block: &[usize], inertia: &Inertia, loads: Loads) {
        let mut lines = Vec::new();
        let matrix = self.named_matrix(block, inertia, &mut lines);
        let mut slopes = Slopes::default();
        let terms: Vec<Expr> = block
            .iter()
            .map(|&index| {
                self.christoffel(index, inertia, |this, (j, k), by| {
                    if block.contains(&j) && block.contains(&k) {
                        this.named_slope(&mut slopes, inertia, (j, k), by)
                    } else {
                        this.gradient(inertia.matrix[j][k])[by]
                    }
                })
            })
            .collect();
        for slope in slopes.known.into_values() {
            if let Some(symbol) = self.g.as_symbol(slope)
                && let Some(&value) = self.values.get(&symbol)
            {
                self.equation_line(&mut lines, symbol, value, "");
            }
        }
        let (mut right, mut left) = (Vec::new(), Vec::new());
        for ((&index, h), &(potential, force)) in block.iter().zip(terms).zip(&loads.values) {
            let h = if self.g.is_zero(h) {
                h
            } else {
                let name = format!("h{}", self.digits(index));
                let words = "centrifugal and Coriolis terms";
                let named = self.named(&name, h, words);
                if let Some(symbol) = self.g.as_symbol(named) {
                    self.equation_line(&mut lines, symbol, h, "");
                }
                named
            };
            let balance = [force, self.g.neg(potential), self.g.neg(h)];
            right.push(self.g.sum(&balance));
            left.push([h, potential, force]);
        }
        let balance = self.matrix_line(block, &matrix, &left);
        let subs: Vec<String> = block
            .iter()
            .map(|&i| self.model.bodies[self.coordinates[i].body].name.clone())
            .collect();
        let accelerations = self.solve_block(&matrix, &right, &subs);
        for (&index, value) in block.iter().zip(accelerations) {
            let symbol = self.coordinates[index].acceleration;
            self.define(symbol, value, "");
        }
        let names: Vec<String> = subs.iter().map(|name| format!("`{name}`")).collect();
        let title = format!("Equations of motion of {}", names.join(", "));
        self.section(
            &title,
            loads.grouped(vec![self.coordinates_line(block)], lines, balance),
        );
    }

    /// The entries of M, named where they are more than a symbol.
    fn named_matrix(
        &mut self,
        block: &[usize],
        inertia: &Inertia,
        lines: &mut Vec<Line>,
    ) -> Vec<Vec<Expr>> {
        let size = block.len();
        let mut matrix = vec![vec![self.g.zero(); size]; size];
        for i in 0..size {
            for j in i..size {
                let entry = inertia.matrix[block[i]][block[j]];
                let value = if self.g.as_symbol(entry).is_some() || self.g.is_zero(entry) {
                    entry
                } else {
                    let value = self.named(&self.entry_name(block[i], block[j]), entry, "inertia");
                    if let Some(symbol) = self.g.as_symbol(value) {
                        self.equation_line(lines, symbol, entry, "");
                    }
                    value
                };
                matrix[i][j] = value;
                matrix[j][i] = value;
            }
        }
        matrix
    }

    /// `q = (φ1, φ2)`: the order of the coordinates.
    fn coordinates_line(&self, block: &[usize]) -> Line {
        let symbols: Vec<Symbol> = block.iter().map(|&i| self.coordinates[i].symbol).collect();
        let text: Vec<&str> = symbols.iter().map(|s| self.g.symbol_text(*s)).collect();
        let latex: Vec<&str> = symbols.iter().map(|s| self.g.symbol_latex(*s)).collect();
        Line::Written {
            text: format!("q = ({})", text.join(", ")),
            latex: format!("q = \\left({}\\right)", latex.join(",\\, ")),
        }
    }

    /// M q̈ + h + ∂P/∂q = τ: row by row in text, as matrices in LaTeX.
    fn matrix_line(&self, block: &[usize], matrix: &[Vec<Expr>], columns: &[[Expr; 3]]) -> Line {
        let accelerations: Vec<Symbol> = block
            .iter()
            .map(|&i| self.coordinates[i].acceleration)
            .collect();
        let mut text = Vec::new();
        for (row, [h, potential, force]) in matrix.iter().zip(columns) {
            let mut terms: Vec<String> = row
                .iter()
                .zip(&accelerations)
                .filter(|(entry, _)| !self.g.is_zero(**entry))
                .map(|(entry, q)| format!("{} {}", self.g.text(*entry), self.g.symbol_text(*q)))
                .collect();
            for part in [h, potential] {
                if !self.g.is_zero(*part) {
                    terms.push(self.g.text(*part));
                }
            }
            text.push(format!("{} = {}", terms.join(" + "), self.g.text(*force)));
        }
        let rows: Vec<String> = matrix
            .iter()
            .map(|row| {
                let row: Vec<String> = row.iter().map(|entry| self.g.latex(*entry)).collect();
                row.join(" & ")
            })
            .collect();
        let column = |part: usize| {
            let entries: Vec<String> = columns.iter().map(|row| self.g.latex(row[part])).collect();
            bracketed(&entries)
        };
        let q: Vec<String> = accelerations
            .iter()
            .map(|q| self.g.symbol_latex(*q).to_owned())
            .collect();
        let mut latex = format!("{} {}", bracketed(&rows), bracketed(&q));
        for part in [0, 1] {
            if columns.iter().any(|row| !self.g.is_zero(row[part])) {
                latex.push_str(" + ");
                latex.push_str(&column(part));
            }
        }
        Line::Written {
            text: text.join("\n"),
            latex: format!("{latex} = {}", column(2)),
        }
    }

    /// Solves a symmetric positive definite system: by its determinant for two, else by L D Lᵀ.
    fn solve_block(&mut self, matrix: &[Vec<Expr>], right: &[Expr], subs: &[String]) -> Vec<Expr> {
        let size = matrix.len();
        if size == 2 {
            let products = [(0, 0, 1, 1), (0, 1, 1, 0)]
                .map(|(a, b, c, d)| self.g.mul(matrix[a][b], matrix[c][d]));
            let determinant = self.g.sub(products[0], products[1]);
            let determinant = self.named("det_M", determinant, "determinant of the inertia");
            return [(0, 1), (1, 0)]
                .map(|(i, j)| {
                    let own = self.g.mul(matrix[j][j], right[i]);
                    let other = self.g.mul(matrix[i][j], right[j]);
                    let numerator = self.g.sub(own, other);
                    self.g.div(numerator, determinant)
                })
                .to_vec();
        }
        let mut lower = vec![vec![self.g.zero(); size]; size];
        let mut pivots: Vec<Expr> = Vec::new();
        for j in 0..size {
            let mut terms = vec![matrix[j][j]];
            for k in 0..j {
                let square = self.g.powi(lower[j][k], 2);
                let product = self.g.mul(square, pivots[k]);
                terms.push(self.g.neg(product));
            }
            let pivot = self.g.sum(&terms);
            let pivot = self.named(&format!("D_{}", subs[j]), pivot, "pivot of the inertia");
            pivots.push(pivot);
            for i in j + 1..size {
                let mut terms = vec![matrix[i][j]];
                for k in 0..j {
                    let product = self.g.product(&[lower[i][k], lower[j][k], pivots[k]]);
                    terms.push(self.g.neg(product));
                }
                let sum = self.g.sum(&terms);
                let value = self.g.div(sum, pivot);
                lower[i][j] = if self.g.is_zero(value) {
                    value
                } else {
                    self.named(
                        &format!("L_{}_{}", subs[i], subs[j]),
                        value,
                        "factor of the inertia",
                    )
                };
            }
        }
        let mut solution: Vec<Expr> = Vec::new();
        for i in 0..size {
            let mut terms = vec![right[i]];
            for k in 0..i {
                let product = self.g.mul(lower[i][k], solution[k]);
                terms.push(self.g.neg(product));
            }
            let value = self.g.sum(&terms);
            solution.push(value);
        }
        for i in (0..size).rev() {
            let mut terms = vec![self.g.div(solution[i], pivots[i])];
            for k in i + 1..size {
                let product = self.g.mul(lower[k][i], solution[k]);
                terms.push(self.g.neg(product));
            }
            solution[i] = self.g.sum(&terms);
        }
        solution
    }
}

fn bracketed(rows: &[String]) -> String {
    format!(
        "\\begin{{bmatrix}} {} \\end{{bmatrix}}",
        rows.join(" \\\\[1ex] ")
    )
}
