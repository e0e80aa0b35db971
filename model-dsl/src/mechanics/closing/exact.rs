//! Exact angles on links that are no coordinates.
//!
//! A coordinate that holds only a guess gives way: it is solved for, together with all that the
//! loops before determine, from the drawn configuration. Were the loops closed in between, a guess
//! from which they do not close would be refused although an assembly exists.

use std::collections::HashMap;

use crate::equations::{Shown, ShownUnit, Solve};
use crate::model::{BodyId, BodyKind, Guess};
use crate::structure::Step;
use crate::symbolic::{Expr, Function, Symbol};

use super::super::{Definition, Derivation};

/// An angle that is asked for.
struct Wanted {
    body: BodyId,
    guess: Guess,
    target: Expr,
}

impl Derivation<'_> {
    /// Angles that were asked for exactly on links that are no coordinates: solved for coordinates
    /// that hold only a guess, in order; if none is left they must come out by themselves.
    pub(super) fn exact_angles(&mut self) {
        let mut free: Vec<usize> = (0..self.coordinates.len())
            .filter(|&i| {
                let body = self.coordinates[i].body;
                matches!(self.model.bodies[body].kind, BodyKind::Link(_)) && !self.guess(body).exact
            })
            .collect();
        let steps = self.structure.steps.clone();
        let (mut freed, mut solved, mut remaining) = (Vec::new(), Vec::new(), Vec::new());
        let mut last_step = 0;
        for (position, step) in steps.iter().enumerate() {
            for body in step.unknowns() {
                let guess = self.guess(body);
                let (true, Some(target)) = (guess.exact, guess.value) else {
                    continue;
                };
                let wanted = Wanted {
                    body,
                    guess,
                    target,
                };
                let rates = self.variable(body).rates.clone();
                match free.iter().position(|i| !self.g.is_zero(rates[*i])) {
                    Some(at) => {
                        freed.push(self.coordinates[free.remove(at)].body);
                        solved.push(wanted);
                        last_step = position;
                    }
                    None => remaining.push(wanted),
                }
            }
        }
        if !solved.is_empty() {
            self.solve_exact(&freed, &solved, &steps[..=last_step]);
        }
        for wanted in solved {
            self.comes_out(
                &wanted,
                "its loop closes at {1}, the other way than drawn",
                "draw the angles of the loop's other links nearer to where they are",
            );
        }
        for wanted in remaining {
            self.comes_out(
                &wanted,
                "with what else is exact the loop closes at {1}",
                "more angles are exact than the mechanism has degrees of freedom: remove `exact` from one of them",
            );
        }
    }

    /// Solves for the coordinates of the bodies that are freed, with the loops of `steps`.
    fn solve_exact(&mut self, freed: &[BodyId], solved: &[Wanted], steps: &[Step]) {
        let mut unknowns: Vec<Symbol> = Vec::new();
        let mut guesses = Vec::new();
        let mut map: HashMap<Symbol, Expr> = HashMap::new();
        for &body in freed {
            let assembled = self.variable(body).assembled;
            if let Some(symbol) = self.g.as_symbol(assembled) {
                unknowns.push(symbol);
                guesses.push(self.guess(body).value.unwrap_or_else(|| self.g.zero()));
                map.insert(symbol, assembled);
            }
        }
        // The unknowns take the place of the guesses that stood for them.
        self.values.retain(|symbol, _| !unknowns.contains(symbol));
        self.definitions.retain(|definition| match definition {
            Definition::Value { symbol, .. } => !unknowns.contains(symbol),
            Definition::Solve(_) => true,
        });
        let mut sums = Vec::new();
        let closing = steps
            .iter()
            .filter(|step| !matches!(step, Step::Redundant { .. }));
        for step in closing {
            let mut closes = false;
            for body in step.unknowns() {
                let assembled = self.variable(body).assembled;
                // What a parallelogram gives follows from the others.
                let (Some(assembled), None) = (self.g.as_symbol(assembled), self.aliases[body])
                else {
                    continue;
                };
                closes = true;
                let value = match solved.iter().find(|wanted| wanted.body == body) {
                    Some(wanted) => wanted.target,
                    None => {
                        let name = self.variable_name(body);
                        let symbol = self.assembled_symbol(&name);
                        unknowns.push(symbol);
                        guesses.push(self.guess(body).value.unwrap_or_else(|| self.g.zero()));
                        self.g.of(symbol)
                    }
                };
                map.insert(assembled, value);
            }
            if closes {
                sums.extend(step.ways().iter().map(|way| self.around(way)));
            }
        }
        let size = self.loop_size(&sums);
        let assembled = self.assembled_map();
        let mut residuals = Vec::new();
        for sum in &sums {
            for component in self.position(sum) {
                let component = self.g.substitute(component, &assembled);
                residuals.push(self.expand_with(component, &mut map));
            }
        }
        let mut scales = vec![size; residuals.len()];
        for wanted in solved {
            if self.aliases[wanted.body].is_some() {
                let assembled = self.variable(wanted.body).assembled;
                let off = self.g.sub(assembled, wanted.target);
                let off = self.g.sin(off);
                residuals.push(self.expand_with(off, &mut map));
                scales.push(self.g.one());
            }
        }
        let Some(Wanted { body, guess, .. }) = solved.last() else {
            return;
        };
        let failure = self.failure(
            format!(
                "`{}` cannot have exactly the angle that is asked for",
                self.model.bodies[*body].name
            ),
            "the loop does not reach it near the drawn configuration: remove `exact`, or change a length",
            guess.span,
            Vec::new(),
        );
        self.definitions.push(Definition::Solve(Box::new(Solve {
            name: "the assembled configuration".to_owned(),
            unknowns,
            guesses,
            definitions: Vec::new(),
            residuals,
            scales,
            failure,
        })));
    }

    /// Refuses params with which an exact angle does not come out.
    fn comes_out(&mut self, wanted: &Wanted, why: &str, hint: &str) {
        let assembled = self.variable(wanted.body).assembled;
        let off = self.g.sub(assembled, wanted.target);
        let off = self.g.sin(off);
        let off = self.g.function(Function::Abs, &[off]);
        let tolerance = self.g.ratio(1, 1_000_000_000);
        let margin = self.g.sub(tolerance, off);
        let degree = |value| Shown {
            value,
            unit: ShownUnit::Degree,
        };
        let failure = self.failure(
            format!(
                "`{}` cannot have the exact angle {{0}}: {why}",
                self.model.bodies[wanted.body].name
            ),
            hint,
            wanted.guess.span,
            vec![degree(wanted.target), degree(assembled)],
        );
        self.check(margin, true, failure);
    }
}
