//! Points: on ground, drawn, on bodies, as ends of links; and the pins where bodies share one.

use super::calls::Given;
use super::expression::Scope;
use super::functions::{POLAR, POLAR_VECTOR};
use super::names::Named;
use super::wanted::{self, Wanted};
use super::{Member, Place, Reported, Resolved, Resolver};
use crate::model::{BodyId, Condition, End, GROUND, Local, NamedPoint, Pin};
use crate::source::Span;
use crate::symbolic::{Expr, Rational};
use crate::syntax::tree::{Declaration, Expression, ExpressionKind, File, ItemKind, Name, Path};

impl Resolver<'_> {
    /// Points of ground and drawn points.
    pub(super) fn locate(&mut self, file: &File) {
        for item in &file.items {
            let (list, on_ground) = match &item.kind {
                ItemKind::Grounds(list) => (list, true),
                ItemKind::DrawnPoints(list) => (list, false),
                _ => continue,
            };
            for declaration in list {
                let _ = self.located(declaration, on_ground);
            }
        }
    }

    fn located(&mut self, declaration: &Declaration, on_ground: bool) -> Resolved<()> {
        let name = &declaration.name;
        let what = format!("`{}`", name.text);
        let at = self.pair(&declaration.value, wanted::LENGTH, &what, Scope::Params);
        let known = self.place(name)?;
        if self.places[known].span != name.span {
            let earlier = self.places[known].span;
            return Err(self.taken(name, earlier));
        }
        let at = at?;
        self.places[known].drawn = Some(at);
        if on_ground {
            self.places[known].members.push(Member {
                body: GROUND,
                at: Local::Cartesian(at[0], at[1]),
                span: name.span,
                is_end: false,
            });
        }
        Ok(())
    }

    /// The place of that name, made if there is none.
    pub(super) fn place(&mut self, name: &Name) -> Resolved<usize> {
        match self.names.get(&name.text) {
            Some(Named::Point) => self.place_index.get(&name.text).copied().ok_or(Reported),
            Some(other) => {
                let hint = match other {
                    Named::Link(_) | Named::Slide(_) => {
                        format!(
                            "name a point on it: `point NAME on {} at (X, Y)`",
                            name.text
                        )
                    }
                    _ => "choose another name for the point".to_owned(),
                };
                let message = format!("`{}` is {}, not a point", name.text, other.kind());
                Err(self.error(name.span, message, hint))
            }
            None => {
                self.check_reserved(name)?;
                self.names.set(&name.text, Named::Point, name.span);
                self.places.push(Place {
                    name: name.text.clone(),
                    span: name.span,
                    members: Vec::new(),
                    drawn: None,
                });
                let index = self.places.len() - 1;
                self.place_index.insert(name.text.clone(), index);
                Ok(index)
            }
        }
    }

    /// Points placed on bodies.
    pub(super) fn points(&mut self, file: &File) {
        for item in &file.items {
            if let ItemKind::Point(point) = &item.kind {
                let what = format!("`{}`", point.name.text);
                let at = self.local(&point.at, &what);
                let body = self.body(&point.on);
                let place = self.place(&point.name);
                let (Ok(at), Ok(body), Ok(place)) = (at, body, place) else {
                    continue;
                };
                self.join(place, body, at, point.name.span, false);
            }
        }
    }

    /// Adds a body to those that have a point.
    pub(super) fn join(&mut self, place: usize, body: BodyId, at: Local, span: Span, is_end: bool) {
        let known = &self.places[place];
        let twice = known.members.iter().find(|member| member.body == body);
        let apart = known
            .members
            .iter()
            .find(|member| !member.is_end && !is_end);
        let clash = twice.or(apart).map(|member| member.span);
        if let Some(earlier) = clash {
            let name = known.name.clone();
            let (message, hint) = if twice.is_some() {
                let message = format!("`{}` has two points `{name}`", self.body_name(body));
                (message, "give one of the two another name")
            } else {
                let message = format!("`{name}` is placed on two bodies");
                let hint = "bodies meet in a pin where the end of a link is a point of another body; \
                            if they do not meet there, give the points two names";
                (message, hint)
            };
            let diagnostic = self
                .diagnostic(span, message)
                .hint(hint)
                .related(self.site(earlier), "placed here first");
            self.report(span, diagnostic);
            return;
        }
        self.places[place].members.push(Member {
            body,
            at,
            span,
            is_end,
        });
    }

    /// Named points and pins, from what the bodies said.
    pub(super) fn pins(&mut self) {
        let mut floating: Vec<(Span, String)> = Vec::new();
        for place in &mut self.places {
            place.members.sort_by_key(|member| member.body);
            let Some(first) = place.members.first() else {
                floating.push((place.span, place.name.clone()));
                continue;
            };
            self.point_index
                .insert(place.name.clone(), self.model.points.len());
            self.model.points.push(NamedPoint {
                name: place.name.clone(),
                body: first.body,
                at: first.at,
                span: place.span,
            });
            if place.members.len() > 1 {
                self.pin_index
                    .insert(place.name.clone(), self.model.pins.len());
                self.model.pins.push(Pin {
                    name: place.name.clone(),
                    members: place.members.iter().map(|m| (m.body, m.at)).collect(),
                    span: place.span,
                });
            }
        }
        if self.failed() {
            return;
        }
        for (span, name) in floating {
            let message = format!("`{name}` is drawn, but no body has it");
            let hint = "name it as the end of a link, or place it on a body with `point … on …`";
            self.error(span, message, hint);
        }
    }

    /// Position of a named point in the model, with an error for what is none.
    pub(super) fn point(&mut self, name: &Name) -> Resolved<usize> {
        if let Some(&position) = self.point_index.get(&name.text) {
            return Ok(position);
        }
        match self.names.get(&name.text) {
            Some(Named::Point) => Err(Reported),
            Some(other) => {
                let message = format!("`{}` is {}, not a point", name.text, other.kind());
                Err(self.error(name.span, message, "name a point"))
            }
            None => {
                let candidates = self.names_where(|named| matches!(named, Named::Point));
                let hint = "declare it with `point NAME on BODY at (X, Y)`";
                Err(self.unknown(name.span, &name.text, "point", &candidates, hint))
            }
        }
    }

    /// Where a body has a point, if it has it.
    pub(super) fn on_body(&self, name: &str, body: BodyId) -> Option<Local> {
        let place = &self.places[*self.place_index.get(name)?];
        let member = place.members.iter().find(|member| member.body == body)?;
        Some(member.at)
    }

    /// One end of a spring, contact or force: a point, `body.point`, a slide, or ground.
    pub(super) fn end(&mut self, path: &Path) -> Resolved<End> {
        let span = path.span;
        let named = |body, at| End {
            name: path.text(),
            body,
            at,
            span,
        };
        match path.parts.as_slice() {
            [name] => {
                if name.text == "ground" {
                    return Ok(named(GROUND, None));
                }
                match self.names.get(&name.text) {
                    Some(Named::Slide(body)) => {
                        let zero = self.model.graph.zero();
                        Ok(named(body, Some(Local::Cartesian(zero, zero))))
                    }
                    Some(Named::Link(_)) => {
                        let message = format!("`{}` is a link: which point of it?", name.text);
                        let hint = format!(
                            "name one of its ends, or a point declared with `point NAME on {} at (X, Y)`",
                            name.text
                        );
                        Err(self.error(span, message, hint))
                    }
                    Some(Named::Point) => {
                        let point = self.point(name)?;
                        let point = &self.model.points[point];
                        Ok(named(point.body, Some(point.at)))
                    }
                    Some(other) => {
                        let message = format!("`{}` is {}, not a place", name.text, other.kind());
                        Err(self.error(span, message, "name a point, a slide or `ground`"))
                    }
                    None => {
                        let candidates = self
                            .names_where(|named| matches!(named, Named::Point | Named::Slide(_)));
                        let hint = "name a point, a slide or `ground`";
                        Err(self.unknown(span, &name.text, "point or slide", &candidates, hint))
                    }
                }
            }
            [body_name, point] => {
                let body = self.body(body_name)?;
                match self.on_body(&point.text, body) {
                    Some(at) => Ok(named(body, Some(at))),
                    None => {
                        let message = format!("`{}` has no point `{}`", body_name.text, point.text);
                        let hint = format!(
                            "place it with `point {} on {} at (X, Y)`",
                            point.text, body_name.text
                        );
                        Err(self.error(point.span, message, hint))
                    }
                }
            }
            _ => Err(self.error(
                span,
                format!("`{}` is no place", path.text()),
                "name a point, a slide or `ground`",
            )),
        }
    }

    // ── Pairs ──────────────────────────────────────────────────────────────────────────────────

    /// A place in a body's frame: `(x, y)` or `polar(r, angle)`.
    pub(super) fn local(&mut self, expression: &Expression, what: &str) -> Resolved<Local> {
        if let ExpressionKind::Call(call) = &expression.kind
            && call.name.text == POLAR.name
        {
            let given = self.arguments(call, &POLAR, Scope::Params)?;
            let [Given::Scalar(distance), Given::Scalar(angle)] = given.as_slice() else {
                return Err(Reported);
            };
            return Ok(Local::Polar(distance.expr, angle.expr));
        }
        let [x, y] = self.pair(expression, wanted::LENGTH, what, Scope::Params)?;
        Ok(Local::Cartesian(x, y))
    }

    /// Two components of one dimension: `(x, y)` or `polar(magnitude, angle)`.
    pub(super) fn pair(
        &mut self,
        expression: &Expression,
        wanted: Wanted,
        what: &str,
        scope: Scope,
    ) -> Resolved<[Expr; 2]> {
        match &expression.kind {
            ExpressionKind::Pair(pair) => {
                let x = self.quantity(&pair.0, wanted, what, scope);
                let y = self.quantity(&pair.1, wanted, what, scope);
                Ok([x?, y?])
            }
            ExpressionKind::Call(call) if call.name.text == POLAR_VECTOR.name => {
                let given = self.arguments(call, &POLAR_VECTOR, scope)?;
                let [Given::Scalar(magnitude), Given::Scalar(angle)] = given.as_slice() else {
                    return Err(Reported);
                };
                self.fits(*magnitude, wanted, what, expression.span)?;
                let g = &mut self.model.graph;
                let (cos, sin) = (g.cos(angle.expr), g.sin(angle.expr));
                Ok([g.mul(magnitude.expr, cos), g.mul(magnitude.expr, sin)])
            }
            _ => Err(self.error(
                expression.span,
                format!("{what} has two components"),
                "write `(x, y)`",
            )),
        }
    }

    /// A direction as a unit vector: `(x, y)` of any length, or `polar(1, angle)`.
    pub(super) fn direction(&mut self, expression: &Expression, what: &str) -> Resolved<[Expr; 2]> {
        match &expression.kind {
            ExpressionKind::Pair(pair) => {
                let x = self.scalar(&pair.0, Scope::Params)?;
                let y = self.scalar(&pair.1, Scope::Params)?;
                self.together(x, pair.0.span, y, pair.1.span)?;
                self.unit_vector([x.expr, y.expr], expression.span)
            }
            ExpressionKind::Call(call) if call.name.text == POLAR_VECTOR.name => {
                let given = self.arguments(call, &POLAR_VECTOR, Scope::Params)?;
                let angle = given.get(1).and_then(Given::scalar).ok_or(Reported)?;
                let g = &mut self.model.graph;
                Ok([g.cos(angle.expr), g.sin(angle.expr)])
            }
            _ => Err(self.error(
                expression.span,
                format!("{what} is a direction"),
                "write `(1, 0)` for along x, or `polar(1, 30 deg)`",
            )),
        }
    }

    fn unit_vector(&mut self, [x, y]: [Expr; 2], span: Span) -> Resolved<[Expr; 2]> {
        let g = &mut self.model.graph;
        if g.is_zero(x) && g.is_zero(y) {
            return Err(self.error(
                span,
                "this direction has no length",
                "write `(1, 0)` for along x, `(0, 1)` for along y",
            ));
        }
        let squares = [g.powi(x, 2), g.powi(y, 2)];
        let square = g.sum(&squares);
        let condition = Condition {
            message: "this direction has no length".to_owned(),
            hint: "let one of its components differ from zero".to_owned(),
            ..Condition::above_zero(square, "")
        };
        self.model.conditions.push((condition, span));
        let g = &mut self.model.graph;
        // Along an axis only the sign counts.
        let sign = |g: &mut crate::symbolic::Graph, value: Expr| {
            g.function(crate::symbolic::Function::Sign, &[value])
        };
        if g.is_zero(y) {
            return Ok([sign(g, x), y]);
        }
        if g.is_zero(x) {
            return Ok([x, sign(g, y)]);
        }
        let (x2, y2) = (g.powi(x, 2), g.powi(y, 2));
        let square = g.add(x2, y2);
        let inverse = g.powr(square, Rational::new((-1).into(), 2.into()));
        Ok([g.mul(x, inverse), g.mul(y, inverse)])
    }
}
