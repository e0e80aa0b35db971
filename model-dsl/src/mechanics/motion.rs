//! Motion: the equations of motion of each block, solved for the accelerations.
//!
//! M q̈ + h(q, q̇) + ∂P/∂q = τ, with h_i = Σ_jk (∂M_ij/∂q_k - ½ ∂M_jk/∂q_i) q̇_j q̇_k. For a block of
//! one whose inertia depends on its own coordinate alone this is the article's (15).

use crate::equations::{self, Energy, Line, State};
use crate::model::{BodyKind, EnergyKind, Measure};
use crate::symbolic::Expr;

use super::Derivation;
use super::inertia::Inertia;
use super::laws::Laws;

/// What results: states and energies.
pub(crate) struct Motion {
    /// States in order: position and rate of each coordinate, then internal states.
    pub states: Vec<State>,
    /// Energies and powers.
    pub energy: Energy,
    /// Static generalized force ∂P/∂q - τ of each coordinate.
    pub imbalance: Vec<Expr>,
}

/// What acts on the coordinates of a block.
#[derive(Default)]
pub(super) struct Loads {
    /// ∂P/∂q and τ of each coordinate.
    pub values: Vec<(Expr, Expr)>,
    /// How the former are made up.
    potential: Vec<Line>,
    /// How the latter are made up.
    forces: Vec<Line>,
}

/// Lines of a section from which on its groups have headings.
const HEADED: usize = 6;

impl Loads {
    /// The lines of an equation of motion: coordinates, inertia, ∂P/∂q, τ, and the balance of them.
    pub fn grouped(self, coordinates: Vec<Line>, inertia: Vec<Line>, balance: Line) -> Vec<Line> {
        let groups = [
            ("Coordinates:", coordinates),
            ("Inertia:", inertia),
            ("Potential energy:", self.potential),
            ("Other forces:", self.forces),
            ("Balance:", vec![balance]),
        ];
        let is_headed = groups.iter().map(|(_, lines)| lines.len()).sum::<usize>() >= HEADED;
        let mut all = Vec::new();
        for (heading, lines) in groups {
            if is_headed && !lines.is_empty() {
                all.push(Line::Text(heading.to_owned()));
            }
            all.extend(lines);
        }
        all
    }
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
            let mut loads = Loads::default();
            for &index in block {
                let (potential, force) = self.generalized_forces(index, laws, &mut loads);
                imbalance[index] = self.g.sub(potential, force);
                loads.values.push((potential, force));
            }
            if let [index] = block[..] {
                self.single(index, inertia, loads);
            } else {
                self.coupled(block, inertia, loads);
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
            let label = self.coordinate_label(index);
            if label.chars().all(|c| c.is_ascii_digit()) {
                label
            } else {
                format!("_{label}")
            }
        }
    }

    /// ∂P/∂q and τ of a coordinate, named.
    fn generalized_forces(&mut self, index: usize, laws: &Laws, loads: &mut Loads) -> (Expr, Expr) {
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
                "slope of the potential energy of springs"
            } else {
                "slope of the potential energy of gravity"
            };
            let symbol = self.names.symbol_with_latex(
                &mut self.g,
                &format!("∂{letter}/∂{text}"),
                &format!("\\frac{{\\partial {letter}}}{{\\partial {latex}}}"),
            );
            self.define(symbol, sum, words);
            self.equation_line(&mut loads.potential, symbol, sum, "");
            parts.push(self.g.of(symbol));
        }
        let mut potential = self.g.sum(&parts);
        if parts.len() > 1 {
            let symbol = self.names.symbol_with_latex(
                &mut self.g,
                &format!("∂P/∂{text}"),
                &format!("\\frac{{\\partial P}}{{\\partial {latex}}}"),
            );
            self.define(symbol, potential, "slope of the potential energy");
            self.equation_line(&mut loads.potential, symbol, potential, "");
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
            self.equation_line(&mut loads.forces, symbol, force, "");
            force = self.g.of(symbol);
        }
        (potential, force)
    }

    /// A block of one: A(q) q̈ + ½ ∂A/∂q q̇² + ∂P/∂q = τ, or with the full h where other coordinates
    /// take part.
    fn single(&mut self, index: usize, inertia: &Inertia, loads: Loads) {
        let (potential, force) = loads.values[0];
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
                self.define(symbol, slope, "slope of the inertia");
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
        let (left_text, left_latex): (Vec<String>, Vec<String>) = left.into_iter().unzip();
        let balance = Line::Written {
            text: format!("{} = {}", left_text.join(" + "), self.g.text(force)),
            latex: format!("{} = {}", left_latex.join(" + "), self.g.latex(force)),
        };
        let body = &self.model.bodies[coordinate.body];
        let title = format!("Equation of motion of `{}`", body.name);
        self.section(&title, loads.grouped(Vec::new(), lines, balance));
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
            let names = self.model.coordinate_names(coordinate.body);
            let (units, words) = match &body.kind {
                BodyKind::Link(_) => (["rad", "rad/s"], ["angle of", "angular rate of"]),
                BodyKind::Slide(_) | BodyKind::Ground if self.model.is_traced(coordinate.body) => {
                    (["m", "m/s"], ["coordinate", "rate of coordinate"])
                }
                BodyKind::Slide(_) | BodyKind::Ground => {
                    (["m", "m/s"], ["position of", "velocity of"])
                }
            };
            let start = self.variable(coordinate.body).assembled;
            let configuration = equations::Coordinate {
                assembled: start,
                leads_loops: self.structure.in_loop(coordinate.body),
            };
            let rates = [coordinate.rate, coordinate.acceleration].map(|s| self.g.of(s));
            for i in [0, 1] {
                states.push(State {
                    name: names[i].clone(),
                    unit: units[i].to_owned(),
                    meaning: format!("{} `{}`", words[i], body.name),
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
        None if suffix.is_empty() => String::new(),
        None => format!("_{{{suffix}}}"),
    }
}
