//! Exact angles on links that are no coordinates.

use crate::equations::{Shown, ShownUnit, Solve};
use crate::model::{BodyId, BodyKind};
use crate::symbolic::{Expr, Function};

use super::super::{Definition, Derivation};

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
        let dependents: Vec<BodyId> = self
            .structure
            .steps
            .iter()
            .flat_map(|step| step.unknowns())
            .collect();
        let (mut unknowns, mut guesses, mut residuals, mut last) =
            (Vec::new(), Vec::new(), Vec::new(), None);
        let mut remaining = Vec::new();
        for body in dependents {
            let guess = self.guess(body);
            let (true, Some(target)) = (guess.exact, guess.value) else {
                continue;
            };
            let variable = self.variable(body).clone();
            let residual = self.g.sub(variable.assembled, target);
            let residual = self.g.sin(residual);
            let moves = |i: &usize| !self.g.is_zero(variable.rates[*i]);
            match free.iter().position(moves) {
                Some(at) => {
                    let index = free.remove(at);
                    let coordinate = self.coordinates[index].body;
                    let assembled = self.variable(coordinate).assembled;
                    if let Some(symbol) = self.g.as_symbol(assembled) {
                        unknowns.push(symbol);
                        guesses.push(self.guess(coordinate).value.unwrap_or(target));
                        residuals.push(residual);
                        last = Some((guess, body));
                    }
                }
                None => remaining.push((residual, guess, body, variable.assembled, target)),
            }
        }
        if let Some((guess, body)) = last {
            // The unknowns take the place of the guesses that stood for them.
            self.values.retain(|symbol, _| !unknowns.contains(symbol));
            self.definitions.retain(|definition| match definition {
                Definition::Value { symbol, .. } => !unknowns.contains(symbol),
                Definition::Solve(_) => true,
            });
            let residuals: Vec<Expr> = residuals
                .into_iter()
                .map(|residual| self.expand(residual, &unknowns))
                .collect();
            let one = self.g.one();
            let failure = self.failure(
                format!(
                    "`{}` cannot have exactly the angle that is asked for",
                    self.model.bodies[body].name
                ),
                "the loop does not reach it near the drawn configuration: remove `exact`, or change a length",
                guess.span,
                Vec::new(),
            );
            let scales = vec![one; unknowns.len()];
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
        for (residual, guess, body, assembled, target) in remaining {
            let tolerance = self.g.ratio(1, 1_000_000_000);
            let off = self.g.function(Function::Abs, &[residual]);
            let margin = self.g.sub(tolerance, off);
            let degree = |value| Shown {
                value,
                unit: ShownUnit::Degree,
            };
            let failure = self.failure(
                format!(
                    "`{}` cannot have the exact angle {{0}}: with what else is exact the loop closes at {{1}}",
                    self.model.bodies[body].name
                ),
                "more angles are exact than the mechanism has degrees of freedom: remove `exact` from one of them",
                guess.span,
                vec![degree(target), degree(assembled)],
            );
            self.check(margin, true, failure);
        }
    }
}
