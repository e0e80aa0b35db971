//! Motion: the equations of motion of each block, solved for the accelerations.
//!
//! M q̈ + h(q, q̇) + ∂P/∂q = τ, with h_i = Σ_jk (∂M_ij/∂q_k - ½ ∂M_jk/∂q_i) q̇_j q̇_k. For a block of
//! one whose inertia depends on its own coordinate alone this is the article's (15).

use flexure_runtime::diagnostic::Diagnostic;

use crate::equations::{self, Energy, Line, State};
use crate::model::{BodyKind, EnergyKind, Measure};
use crate::symbolic::Expr;

use super::Derivation;
use super::inertia::Inertia;
use super::laws::Laws;
use super::names::subscript;

/// What results: states and energies.
pub(crate) struct Motion {
    /// States in order: position and rate of each coordinate, then internal states.
    pub states: Vec<State>,
    /// Energies and powers.
    pub energy: Energy,
    /// Static generalized force ∂P/∂q - τ of each coordinate.
    pub imbalance: Vec<Expr>,
}

impl Derivation<'_> {
    /// Solves each block for its accelerations.
    pub(super) fn motion(&mut self, inertia: &Inertia, laws: &Laws) -> Motion {
        self.section("Named forces", laws.lines.clone());
        let n = self.coordinates.len();
        let mut imbalance = vec![self.g.zero(); n];
        for block in &inertia.blocks {
            let massless = block
                .iter()
                .find(|&&i| self.g.is_zero(inertia.matrix[i][i]))
                .copied();
            if let Some(index) = massless {
                self.massless(index);
                continue;
            }
            let mut loads = Vec::new();
            let mut lines = Vec::new();
            for &index in block {
                let (potential, force) = self.generalized_forces(index, laws, &mut lines);
                imbalance[index] = self.g.sub(potential, force);
                loads.push((potential, force));
            }
            if let [index] = block[..] {
                self.single(index, inertia, loads[0], lines);
            } else {
                self.coupled(block, inertia, &loads, lines);
            }
        }
        let kinetic = self.kinetic_energy(&inertia.matrix);
        let energy = Energy {
            kinetic,
            potential: self.g.sum(&laws.potential),
            dissipated_power: self.g.sum(&laws.dissipated),
            supplied_power: self.g.sum(&laws.supplied),
        };
        let states = self.states(laws, &energy);
        self.book_events(&states, energy.potential);
        Motion {
            states,
            energy,
            imbalance,
        }
    }

    fn massless(&mut self, index: usize) {
        let body = &self.model.bodies[self.coordinates[index].body];
        let error = Diagnostic::error(format!("`{}` can move but has no mass", body.name))
            .at(self.model.source.site(body.span))
            .hint("give it a `mass` (or a `section` and a `density`), or join it to a body that has one");
        self.errors.push(error);
    }

    /// Names of quantities of a coordinate: bare where only one block needs them.
    fn suffix(&self, index: usize) -> String {
        let link = |i: usize| {
            matches!(
                self.model.bodies[self.coordinates[i].body].kind,
                BodyKind::Link(_)
            )
        };
        let links = (0..self.coordinates.len()).filter(|i| link(*i)).count();
        if link(index) && links == 1 {
            String::new()
        } else {
            let name = self.g.symbol_text(self.coordinates[index].symbol);
            format!("_{}", subscript(name))
        }
    }

    /// ∂P/∂q and τ of a coordinate, named.
    fn generalized_forces(
        &mut self,
        index: usize,
        laws: &Laws,
        lines: &mut Vec<Line>,
    ) -> (Expr, Expr) {
        let q = self.coordinates[index].symbol;
        let (text, latex) = (
            self.g.symbol_text(q).to_owned(),
            self.g.symbol_latex(q).to_owned(),
        );
        let mut parts = Vec::new();
        for (letter, terms) in [("P_s", &laws.elastic[index]), ("P_g", &laws.gravity[index])] {
            let sum = self.g.sum(terms);
            if self.g.is_zero(sum) {
                continue;
            }
            let words = if letter == "P_s" {
                "springs"
            } else {
                "gravity"
            };
            let symbol = self.names.symbol_with_latex(
                &mut self.g,
                &format!("∂{letter}/∂{text}"),
                &format!("\\frac{{\\partial {letter}}}{{\\partial {latex}}}"),
            );
            self.define(symbol, sum, words);
            self.equation_line(lines, symbol, sum, "");
            parts.push(self.g.of(symbol));
        }
        let mut potential = self.g.sum(&parts);
        if parts.len() > 1 {
            let symbol = self.names.symbol_with_latex(
                &mut self.g,
                &format!("∂P/∂{text}"),
                &format!("\\frac{{\\partial P}}{{\\partial {latex}}}"),
            );
            self.define(symbol, potential, "potential energy");
            self.equation_line(lines, symbol, potential, "");
            potential = self.g.of(symbol);
        }
        let mut force = self.g.sum(&laws.forces[index]);
        if !self.g.is_zero(force) && self.g.as_symbol(force).is_none() {
            let body = self.coordinates[index].body;
            let is_link = matches!(self.model.bodies[body].kind, BodyKind::Link(_));
            let suffix = self.suffix(index);
            let (name, words) = if is_link {
                (
                    format!("τ{suffix}"),
                    "generalized torque of all other forces",
                )
            } else {
                (
                    format!("Q{suffix}"),
                    "generalized force of all other forces",
                )
            };
            let symbol = self.names.symbol(&mut self.g, &name);
            self.define(symbol, force, words);
            self.equation_line(lines, symbol, force, "");
            force = self.g.of(symbol);
        }
        (potential, force)
    }

    /// A block of one: A(q) q̈ + ½ ∂A/∂q q̇² + ∂P/∂q = τ, or with the full h where other coordinates
    /// take part.
    fn single(
        &mut self,
        index: usize,
        inertia: &Inertia,
        (potential, force): (Expr, Expr),
        force_lines: Vec<Line>,
    ) {
        let coordinate = self.coordinates[index].clone();
        let names = [coordinate.symbol, coordinate.rate, coordinate.acceleration].map(|s| {
            (
                self.g.symbol_text(s).to_owned(),
                self.g.symbol_latex(s).to_owned(),
            )
        });
        let [
            (q, q_latex),
            (rate, rate_latex),
            (acceleration, acceleration_latex),
        ] = names;
        let suffix = self.suffix(index);
        let entry = inertia.matrix[index][index];
        let mut lines = Vec::new();
        let plain = self.g.as_symbol(entry).is_some()
            || (self.is_of_params(entry) && !self.suffix(index).is_empty());
        let (inertia_value, inertia_text) = if plain {
            (entry, (self.g.text(entry), self.g.latex(entry)))
        } else {
            let name = self.names.free(&format!("A{suffix}"));
            let latex = crate::notation::latex_of(&name);
            let symbol = self.g.symbol(name.clone(), latex.clone());
            self.define(symbol, entry, "inertia");
            lines.push(Line::Equation {
                text: format!("{name}({q})"),
                latex: format!("{latex}({q_latex})"),
                right: entry,
                note: String::new(),
            });
            (
                self.g.of(symbol),
                (format!("{name}({q})"), format!("{latex}({q_latex})")),
            )
        };
        let velocity_terms = self.velocity_terms(index, inertia);
        let slope = self.gradient(entry)[index];
        let is_own = self.depends_on_itself_alone(index, inertia);
        let mut balance = vec![force];
        let mut left = vec![(
            format!("{} {acceleration}", inertia_text.0),
            format!("{}\\,{acceleration_latex}", inertia_text.1),
        )];
        if !self.g.is_zero(velocity_terms) {
            let value = if is_own {
                let name = format!("∂A{suffix}/∂{q}");
                let latex = format!(
                    "\\frac{{\\partial A{}}}{{\\partial {q_latex}}}",
                    latex_suffix(&suffix)
                );
                let symbol = self.names.symbol_with_latex(&mut self.g, &name, &latex);
                self.define(symbol, slope, "its derivative");
                self.equation_line(&mut lines, symbol, slope, "");
                left.push((
                    format!("½ {name} {rate}²"),
                    format!("\\tfrac12 {latex}\\,{rate_latex}^2"),
                ));
                let slope = self.g.of(symbol);
                let q_rate = self.g.of(coordinate.rate);
                let half = self.g.ratio(1, 2);
                let square = self.g.powi(q_rate, 2);
                self.g.product(&[half, slope, square])
            } else {
                let symbol = self.names.symbol(&mut self.g, &format!("h{suffix}"));
                self.define(symbol, velocity_terms, "centrifugal and Coriolis terms");
                self.equation_line(&mut lines, symbol, velocity_terms, "");
                left.push((
                    self.g.symbol_text(symbol).to_owned(),
                    self.g.symbol_latex(symbol).to_owned(),
                ));
                self.g.of(symbol)
            };
            balance.push(self.g.neg(value));
        }
        if !self.g.is_zero(potential) {
            left.push((self.g.text(potential), self.g.latex(potential)));
            balance.push(self.g.neg(potential));
        }
        let total = self.g.sum(&balance);
        let value = self.g.div(total, inertia_value);
        self.define(coordinate.acceleration, value, "");
        lines.extend(force_lines);
        let (left_text, left_latex): (Vec<String>, Vec<String>) = left.into_iter().unzip();
        lines.push(Line::Written {
            text: format!("{} = {}", left_text.join(" + "), self.g.text(force)),
            latex: format!("{} = {}", left_latex.join(" + "), self.g.latex(force)),
        });
        let body = &self.model.bodies[coordinate.body];
        let title = format!("Equation of motion of `{}`", body.name);
        self.section(&title, lines);
    }

    /// Whether the velocity terms of a coordinate are ½ ∂A/∂q q̇²: nothing else moves its inertia
    /// and it moves no other's.
    fn depends_on_itself_alone(&mut self, index: usize, inertia: &Inertia) -> bool {
        let mut entries = inertia.concerning(index);
        entries.extend([(index, index)]);
        for (j, k) in entries {
            let slopes = self.gradient(inertia.matrix[j][k]);
            for (by, slope) in slopes.into_iter().enumerate() {
                let own = (j, k, by) == (index, index, index);
                let concerned = (j == index && k == index) || by == index;
                if concerned && !own && !self.g.is_zero(slope) {
                    return false;
                }
            }
        }
        true
    }

    /// h_i = Σ_jk (∂M_ij/∂q_k - ½ ∂M_jk/∂q_i) q̇_j q̇_k.
    fn velocity_terms(&mut self, index: usize, inertia: &Inertia) -> Expr {
        let half = self.g.ratio(1, 2);
        let mut terms = Vec::new();
        for (j, k) in inertia.concerning(index) {
            let by_other = self.gradient(inertia.matrix[index][j])[k];
            let slope = self.gradient(inertia.matrix[j][k])[index];
            let slope = self.g.mul(half, slope);
            let slope = self.g.neg(slope);
            let factor = self.g.sum(&[by_other, slope]);
            let rates = [j, k].map(|other| self.g.of(self.coordinates[other].rate));
            terms.push(self.g.product(&[factor, rates[0], rates[1]]));
        }
        self.g.sum(&terms)
    }

    /// A block of several: M and h by entries, M q̈ = τ - ∂P/∂q - h by L D Lᵀ, unrolled.
    fn coupled(
        &mut self,
        block: &[usize],
        inertia: &Inertia,
        loads: &[(Expr, Expr)],
        force_lines: Vec<Line>,
    ) {
        let size = block.len();
        let mut lines = Vec::new();
        let subs: Vec<String> = block
            .iter()
            .map(|&i| {
                let body = self.coordinates[i].body;
                self.model.bodies[body].name.clone()
            })
            .collect();
        let mut matrix = vec![vec![self.g.zero(); size]; size];
        for i in 0..size {
            for j in 0..=i {
                let entry = inertia.matrix[block[i]][block[j]];
                let name = format!("M_{}_{}", subs[j], subs[i]);
                let name = if i == j {
                    format!("M_{}", subs[i])
                } else {
                    name
                };
                let value = if self.g.as_symbol(entry).is_some() || self.g.is_zero(entry) {
                    entry
                } else {
                    let value = self.named(&name, entry, "inertia");
                    if let Some(symbol) = self.g.as_symbol(value) {
                        self.equation_line(&mut lines, symbol, entry, "");
                    }
                    value
                };
                matrix[i][j] = value;
                matrix[j][i] = value;
            }
        }
        let mut right = Vec::new();
        let mut written = Vec::new();
        for (i, &index) in block.iter().enumerate() {
            let (potential, force) = loads[i];
            let mut balance = vec![force, self.g.neg(potential)];
            let h = self.velocity_terms(index, inertia);
            let mut left: Vec<(String, String)> = Vec::new();
            for (j, &other) in block.iter().enumerate() {
                if self.g.is_zero(matrix[i][j]) {
                    continue;
                }
                let acceleration = self.coordinates[other].acceleration;
                left.push((
                    format!(
                        "{} {}",
                        self.g.text(matrix[i][j]),
                        self.g.symbol_text(acceleration)
                    ),
                    format!(
                        "{}\\,{}",
                        self.g.latex(matrix[i][j]),
                        self.g.symbol_latex(acceleration)
                    ),
                ));
            }
            if !self.g.is_zero(h) {
                let value = self.named(
                    &format!("h_{}", subs[i]),
                    h,
                    "centrifugal and Coriolis terms",
                );
                if let Some(symbol) = self.g.as_symbol(value) {
                    self.equation_line(&mut lines, symbol, h, "");
                }
                left.push((self.g.text(value), self.g.latex(value)));
                balance.push(self.g.neg(value));
            }
            if !self.g.is_zero(potential) {
                left.push((self.g.text(potential), self.g.latex(potential)));
            }
            let (text, latex): (Vec<String>, Vec<String>) = left.into_iter().unzip();
            written.push(Line::Written {
                text: format!("{} = {}", text.join(" + "), self.g.text(force)),
                latex: format!("{} = {}", latex.join(" + "), self.g.latex(force)),
            });
            right.push(self.g.sum(&balance));
        }
        let accelerations = self.solve_block(&matrix, &right, &subs);
        for (&index, value) in block.iter().zip(accelerations) {
            let symbol = self.coordinates[index].acceleration;
            self.define(symbol, value, "");
        }
        lines.extend(force_lines);
        lines.extend(written);
        let names: Vec<String> = subs.iter().map(|name| format!("`{name}`")).collect();
        self.section(
            &format!("Equations of motion of {}", names.join(", ")),
            lines,
        );
    }

    /// Solves a symmetric positive definite system: by its determinant for two, else by L D Lᵀ.
    fn solve_block(&mut self, matrix: &[Vec<Expr>], right: &[Expr], subs: &[String]) -> Vec<Expr> {
        let size = matrix.len();
        if size == 2 {
            let products = [(0, 0, 1, 1), (0, 1, 1, 0)]
                .map(|(a, b, c, d)| self.g.mul(matrix[a][b], matrix[c][d]));
            let determinant = self.g.sub(products[0], products[1]);
            let name = format!("det_{}_{}", subs[0], subs[1]);
            let determinant = self.named(&name, determinant, "determinant of the inertia");
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

    /// Energy that an event takes out of springs and bristles is heat, for models that ask for
    /// `energy.dissipated`.
    fn book_events(&mut self, states: &[State], potential: Expr) {
        let heat = self
            .model
            .measures
            .iter()
            .find(|used| used.measure == Measure::Energy(EnergyKind::Dissipated));
        let Some(heat) = heat.map(|used| used.symbol) else {
            return;
        };
        let Some(index) = states.iter().position(|state| state.symbol == heat) else {
            return;
        };
        for event in 0..self.events.len() {
            let updates = self.events[event].clone();
            let mut map = std::collections::HashMap::new();
            for (state, value) in updates.state_updates {
                map.insert(states[state].symbol, value);
            }
            for (discrete, value) in updates.discrete_updates {
                map.insert(self.discretes[discrete].symbol, value);
            }
            let after = self.expand_with(potential, &mut map);
            let lost = self.g.sub(potential, after);
            if !self.g.is_zero(lost) {
                let so_far = self.g.of(heat);
                let value = self.g.add(so_far, lost);
                self.events[event].state_updates.push((index, value));
            }
        }
    }

    /// States with rates: positions and rates of coordinates, internal states, energies asked for.
    fn states(&mut self, laws: &Laws, energy: &Energy) -> Vec<State> {
        let zero = self.g.zero();
        let mut states = Vec::new();
        for coordinate in self.coordinates.clone() {
            let body = &self.model.bodies[coordinate.body];
            let is_link = matches!(body.kind, BodyKind::Link(_));
            let (names, units) = if is_link {
                (["angle", "rate"], ["rad", "rad/s"])
            } else {
                (["x", "v"], ["m", "m/s"])
            };
            let meanings = if is_link {
                ["angle", "angular rate"]
            } else {
                ["position", "velocity"]
            };
            let start = self.variable(coordinate.body).assembled;
            let configuration = equations::Coordinate {
                assembled: start,
                leads_loops: self.structure.in_loop(coordinate.body),
            };
            let rates = [coordinate.rate, coordinate.acceleration].map(|s| self.g.of(s));
            for i in [0, 1] {
                states.push(State {
                    name: format!("{}.{}", body.name, names[i]),
                    unit: units[i].to_owned(),
                    meaning: format!("{} of `{}`", meanings[i], body.name),
                    symbol: [coordinate.symbol, coordinate.rate][i],
                    initial: [start, zero][i],
                    rate: rates[i],
                    coordinate: [Some(configuration), None][i],
                });
            }
        }
        for state in &laws.states {
            states.push(State {
                name: state.name.clone(),
                unit: state.unit.clone(),
                meaning: state.meaning.clone(),
                symbol: state.symbol,
                initial: zero,
                rate: state.rate,
                coordinate: None,
            });
        }
        for used in &self.model.measures {
            let (meaning, rate) = match used.measure {
                Measure::Energy(EnergyKind::Dissipated) => (
                    "energy turned to heat since the start",
                    energy.dissipated_power,
                ),
                Measure::Energy(EnergyKind::Supplied) => {
                    ("energy brought in since the start", energy.supplied_power)
                }
                _ => continue,
            };
            states.push(State {
                name: used.name.clone(),
                unit: "J".to_owned(),
                meaning: meaning.to_owned(),
                symbol: used.symbol,
                initial: zero,
                rate,
                coordinate: None,
            });
        }
        states
    }
}

fn latex_suffix(suffix: &str) -> String {
    match suffix.strip_prefix('_') {
        Some(name) => format!("_{{{}}}", crate::notation::latex_of(name)),
        None => String::new(),
    }
}
