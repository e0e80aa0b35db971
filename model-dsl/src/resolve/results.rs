//! How a run starts and ends, and what it gives: coordinates, initial values, outputs, stops.

use std::collections::BTreeMap;

use super::expression::Scope;
use super::names::Named;
use super::wanted::{self, Wanted};
use super::{Reported, Resolved, Resolver};
use crate::model::{CoordinateRequest, Initial, Measure, Output, Start, Stop};
use crate::source::Span;
use crate::syntax::tree::{Declaration, Expression, ExpressionKind, File, ItemKind, Path};
use crate::units::Dimension;

impl Resolver<'_> {
    pub(super) fn results(&mut self, file: &File) {
        let mut outputs: BTreeMap<&str, Span> = BTreeMap::new();
        let mut start: Option<Span> = None;
        for item in &file.items {
            if let ItemKind::Coordinates(paths) = &item.kind {
                for path in paths {
                    let _ = self.coordinate(path);
                }
            }
        }
        for item in &file.items {
            match &item.kind {
                ItemKind::Initials(initials) => {
                    for (path, value) in initials {
                        let _ = self.initial(path, value);
                    }
                }
                ItemKind::Start(value) => {
                    if let Some(earlier) = start.replace(item.span) {
                        let diagnostic = self
                            .diagnostic(item.span, "the start is given twice")
                            .hint("remove one of the two")
                            .related(self.site(earlier), "given here first");
                        self.report(item.span, diagnostic);
                    } else {
                        let _ = self.start(value);
                    }
                }
                ItemKind::Outputs(list) => {
                    for declaration in list {
                        let name = &declaration.name;
                        match outputs.get(name.text.as_str()) {
                            Some(&earlier) => {
                                let message = format!("there are two outputs `{}`", name.text);
                                let diagnostic = self
                                    .diagnostic(name.span, message)
                                    .hint("give one of the two another name")
                                    .related(self.site(earlier), "declared here");
                                self.report(name.span, diagnostic);
                            }
                            None => {
                                outputs.insert(&name.text, name.span);
                                let _ = self.output(declaration);
                            }
                        }
                    }
                }
                ItemKind::Stop(condition, reason) => {
                    let _ = self.stop(condition, reason.as_deref(), item.span);
                }
                _ => {}
            }
        }
    }

    fn coordinate(&mut self, path: &Path) -> Resolved<()> {
        let (measure, _) = self.measure_of(path, "`crank.angle`")?;
        let body = match (measure, self.coordinate_body(measure)) {
            (Measure::PointPosition(point, axis), _) => self.traced(point, axis, path)?,
            (_, Some(body)) => body,
            (_, None) => {
                let message = format!("`{}` cannot be a coordinate", path.text());
                let hint = "a coordinate is the angle of a link, the travel of a slide, \
                            or x or y of a point";
                return Err(self.error(path.span, message, hint));
            }
        };
        if self
            .model
            .coordinates
            .iter()
            .any(|known| known.body == body)
        {
            let message = format!("`{}` is asked for twice", path.text());
            return Err(self.error(path.span, message, "remove one of the two"));
        }
        self.model.coordinates.push(CoordinateRequest {
            body,
            span: path.span,
        });
        Ok(())
    }

    /// The measure that a path names, with an error where a plain name stands.
    fn measure_of(&mut self, path: &Path, example: &str) -> Resolved<(Measure, Dimension)> {
        let Some(name) = path.single() else {
            return self.measure(path);
        };
        match self.names.get(&name.text) {
            Some(Named::Pending(_)) => Err(Reported),
            Some(named) => {
                let message = format!("`{}` is {}, not a quantity of it", name.text, named.kind());
                Err(self.error(path.span, message, format!("write it as in {example}")))
            }
            None => {
                let candidates = self.names_where(|named| {
                    matches!(named, Named::Link(_) | Named::Slide(_) | Named::Contact(_))
                });
                let hint = format!("write it as in {example}");
                Err(self.unknown(name.span, &name.text, "body or contact", &candidates, &hint))
            }
        }
    }

    fn initial(&mut self, path: &Path, value: &Expression) -> Resolved<()> {
        let (mut measure, dimension) = self.measure_of(path, "`initial crank.rate = 20 rad/s`")?;
        if let Measure::PointVelocity(point, axis) = measure
            && let Some(body) = self.tracing(point, axis)
        {
            measure = Measure::Velocity(body);
        }
        let wanted = match measure {
            Measure::AngleRate(_) => wanted::ANGULAR_RATE,
            Measure::Velocity(_) => wanted::VELOCITY,
            Measure::Travel(_) | Measure::Position(_) => wanted::LENGTH,
            Measure::ContactState(..) => Wanted {
                dimension,
                words: "a deflection (m)",
            },
            Measure::Angle(body) => {
                let message = format!("`{}` starts as the link is assembled", path.text());
                let name = self.model.bodies[body].name.clone();
                let hint = format!("give the angle at the link `{name}`: `angle = … exact`");
                return Err(self.error(path.span, message, hint));
            }
            _ => {
                let message = format!("`{}` has no initial value of its own", path.text());
                let hint = "initial values are rates of links, velocities and travels of slides, \
                            and internal states of contacts";
                return Err(self.error(path.span, message, hint));
            }
        };
        let what = format!("`{}`", path.text());
        let value = self.fixed(value, wanted, &what)?;
        if self
            .model
            .initial
            .iter()
            .any(|known| known.measure == measure)
        {
            let message = format!("`{}` is given twice", path.text());
            return Err(self.error(path.span, message, "remove one of the two"));
        }
        self.model.initial.push(Initial {
            measure,
            value,
            span: path.span,
        });
        Ok(())
    }

    fn start(&mut self, value: &Expression) -> Resolved<()> {
        let word = match &value.kind {
            ExpressionKind::Reference(path) => path.text(),
            _ => String::new(),
        };
        self.model.start = match word.as_str() {
            "assembled" => Start::Assembled,
            "equilibrium" => Start::Equilibrium,
            _ => {
                let hint = "write `start = assembled` or `start = equilibrium`";
                return Err(self.error(value.span, "a run cannot start there", hint));
            }
        };
        Ok(())
    }

    fn output(&mut self, declaration: &Declaration) -> Resolved<()> {
        let name = &declaration.name;
        self.check_reserved(name)?;
        let value = self.scalar(&declaration.value, Scope::Results)?;
        self.model.outputs.push(Output {
            name: name.text.clone(),
            value: value.expr,
            dimension: value.dimension,
            doc: declaration.doc.clone(),
            span: name.span,
        });
        Ok(())
    }

    fn stop(&mut self, condition: &Expression, reason: Option<&str>, span: Span) -> Resolved<()> {
        let value = self.condition(condition, Scope::Results)?;
        if self.model.graph.as_number(value.margin).is_some() {
            let message = "this condition never changes";
            let hint = "compare something that moves, as in `stop when stage.x > 1 mm`";
            return Err(self.error(condition.span, message, hint));
        }
        let reason = match reason {
            Some(reason) => reason.to_owned(),
            None => self.written(condition.span),
        };
        self.model.stops.push(Stop {
            margin: value.margin,
            reason,
            span,
        });
        Ok(())
    }

    /// Warns of params and drives that nothing uses.
    pub(super) fn unused(&mut self, file: &File) {
        if self.failed() {
            return;
        }
        let mut used: std::collections::BTreeSet<&str> = std::collections::BTreeSet::new();
        for item in &file.items {
            super::order::names_in_item(&item.kind, &mut |name| {
                used.insert(name);
            });
        }
        for item in &file.items {
            let (list, kind) = match &item.kind {
                ItemKind::Params(list) => (list, "param"),
                ItemKind::Lets(list) => (list, "let"),
                ItemKind::Drives(list) => (list, "drive"),
                _ => continue,
            };
            for declaration in list {
                let name = &declaration.name;
                if !used.contains(name.text.as_str()) {
                    let message = format!("`{}` is used nowhere", name.text);
                    self.warning(
                        name.span,
                        message,
                        format!("remove this `{kind}`, or use it"),
                    );
                }
            }
        }
    }
}
