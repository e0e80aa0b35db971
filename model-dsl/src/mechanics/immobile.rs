//! Links that no coordinate moves: trusses that ground holds.

use flexure_runtime::diagnostic::Diagnostic;

use crate::model::BodyId;
use crate::structure::{Step, Way, bodies_named, joints_named};

use super::Derivation;

impl Derivation<'_> {
    /// Whether a coordinate moves the loops that `unknowns` close.
    pub(crate) fn is_led(&self, ways: &[Way], unknowns: &[BodyId]) -> bool {
        let moves = |body: BodyId| {
            self.variables[body].as_ref().is_some_and(|variable| {
                variable.coordinate.is_some()
                    || variable.rates.iter().any(|rate| !self.g.is_zero(*rate))
            })
        };
        ways.iter().any(|way| {
            let ends = [way.start.0, way.end.0];
            let carried = ends.into_iter().flat_map(|end| self.structure.way_out(end));
            let around = self.structure.way_bodies(way);
            carried
                .chain(around)
                .any(|body| !unknowns.contains(&body) && moves(body))
        })
    }

    /// Links that ground holds so that they cannot move are as good as ground: accepted, but hardly
    /// what was meant.
    pub(super) fn warn_of_trusses(&mut self) {
        for step in &self.structure.steps {
            let unknowns = step.unknowns();
            if matches!(step, Step::Redundant { .. }) || self.is_led(step.ways(), &unknowns) {
                continue;
            }
            let warning = Diagnostic::warning(format!(
                "{} cannot move: with ground they form a rigid truss, joined by {}",
                bodies_named(self.model, &unknowns),
                joints_named(self.model, &unknowns)
            ))
            .hint("remove a link or a pin if they should move; if not, points of `ground` say the same");
            let span = self.model.bodies[unknowns[0]].span;
            self.warnings.push(self.model.source.blame(span, warning));
        }
    }
}
