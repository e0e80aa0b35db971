//! Faults of structure in an engineer's words: which bodies and joints are involved, and what
//! would mend it.

use flexure_runtime::diagnostic::Diagnostic;

use crate::model::{BodyId, BodyKind, GROUND, Model};
use crate::source::Span;

/// Names in one message; nobody reads more.
const MOST_NAMES: usize = 8;

/// `` `a`, `b` and `c` ``, cut where it gets long.
fn listed(names: &[String]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    let (shown, last) = match quoted.split_last() {
        None => return String::new(),
        Some((last, [])) => return last.clone(),
        Some((last, rest)) if quoted.len() <= MOST_NAMES => (rest, last.clone()),
        Some(_) => {
            let more = quoted.len() - MOST_NAMES;
            (&quoted[..MOST_NAMES], format!("{more} more"))
        }
    };
    format!("{} and {last}", shown.join(", "))
}

/// The bodies by name.
pub(crate) fn bodies_named(model: &Model, bodies: &[BodyId]) -> String {
    let names: Vec<String> = bodies
        .iter()
        .filter(|body| !model.is_traced(**body))
        .map(|body| model.bodies[*body].name.clone())
        .collect();
    listed(&names)
}

/// The joints among bodies and between them and ground: `` the pins `A` and `B` and the guide of
/// `stage` ``.
pub(crate) fn joints_named(model: &Model, bodies: &[BodyId]) -> String {
    let among = |body: BodyId| body == GROUND || bodies.contains(&body);
    let pins: Vec<String> = model
        .pins
        .iter()
        .filter(|pin| pin.members.iter().filter(|(body, _)| among(*body)).count() > 1)
        .map(|pin| pin.name.clone())
        .collect();
    let guided: Vec<String> = bodies
        .iter()
        .filter(|body| !model.is_traced(**body))
        .map(|body| &model.bodies[*body])
        .filter(|body| matches!(&body.kind, BodyKind::Slide(slide) if among(slide.carrier)))
        .map(|body| body.name.clone())
        .collect();
    let some = |names: &[String], one: &str, many: &str| match names.len() {
        0 => None,
        1 => Some(format!("{one} {}", listed(names))),
        _ => Some(format!("{many} {}", listed(names))),
    };
    let kinds = [
        some(&pins, "the pin", "the pins"),
        some(&guided, "the guide of", "the guides of"),
    ];
    let kinds: Vec<String> = kinds.into_iter().flatten().collect();
    kinds.join(" and ")
}

/// `` `crank.angle` `` or `` `stage.x` ``: the coordinate that a body gives.
pub(crate) fn coordinate_named(model: &Model, body: BodyId) -> String {
    let [name, _] = model.coordinate_names(body);
    format!("`{name}`")
}

/// A rigid truss that is all there is.
pub(super) fn rigid(model: &Model) -> Diagnostic {
    let bodies: Vec<BodyId> = (1..model.bodies.len()).collect();
    let error = Diagnostic::error(format!(
        "nothing in this model can move: {} {} rigid with ground, joined by {}",
        bodies_named(model, &bodies),
        if bodies.len() == 1 { "is" } else { "are" },
        joints_named(model, &bodies)
    ))
    .hint("remove a link, or let one of them end in a point of its own");
    model.source.blame(model.bodies[1].span, error)
}

/// Bodies among which there are more equations than variables.
pub(super) fn overconstrained(model: &Model, bodies: &[BodyId]) -> Diagnostic {
    let error = Diagnostic::error(format!(
        "{} cannot move against each other: {} over-constrain them",
        bodies_named(model, bodies),
        joints_named(model, bodies)
    ))
    .hint("remove a link or a pin between them");
    let body = bodies.first().copied().unwrap_or(GROUND);
    model.source.blame(model.bodies[body].span, error)
}

/// Links that two pins hold together.
pub(super) fn pinned_twice(model: &Model) -> Vec<Diagnostic> {
    let mut errors = Vec::new();
    for (index, pin) in model.pins.iter().enumerate() {
        for other in &model.pins[index + 1..] {
            let both: Vec<BodyId> = pin
                .members
                .iter()
                .map(|(body, _)| *body)
                .filter(|body| other.members.iter().any(|(b, _)| b == body))
                .collect();
            for (at, &a) in both.iter().enumerate() {
                for &b in &both[at + 1..] {
                    let is_link =
                        |body: &BodyId| matches!(model.bodies[*body].kind, BodyKind::Link(_));
                    let Some(link) = [b, a].into_iter().find(is_link) else {
                        continue;
                    };
                    let error = Diagnostic::error(format!(
                        "`{}` is pinned to `{}` twice, at `{}` and at `{}`: the two are one rigid body",
                        model.bodies[link].name,
                        model.bodies[a + b - link].name,
                        pin.name,
                        other.name
                    ))
                    .hint("describe the two as one body, or let one of the ends be a point of its own");
                    errors.push(model.source.blame(model.bodies[link].span, error));
                }
            }
        }
    }
    errors
}

/// Bodies that nothing leads to from ground: no joint, guide, spring or contact.
pub(super) fn unjoined(model: &Model, bodies: &[BodyId]) -> Diagnostic {
    let verb = if bodies.len() == 1 { "is" } else { "are" };
    let names = bodies_named(model, bodies);
    let error = Diagnostic::error(format!("{names} {verb} not joined to ground")).hint(
        "let one of its ends be a `ground` point or a point of a body that is joined to ground, \
         or hold it by a spring",
    );
    model.source.blame(model.bodies[bodies[0]].span, error)
}

/// A coordinate that follows from others that are asked for.
pub(super) fn follows(
    model: &Model,
    request: (BodyId, Span),
    around: &[BodyId],
    leaders: &[BodyId],
) -> Diagnostic {
    let (body, span) = request;
    let leading: Vec<String> = leaders
        .iter()
        .map(|leader| coordinate_named(model, *leader))
        .collect();
    let loop_ = super::loop_names(model, around);
    let from = match leading.len() {
        0 => "what else is asked for".to_owned(),
        _ => leading.join(", "),
    };
    let joints = joints_named(model, around);
    let close = if loop_.contains('–') {
        "close"
    } else {
        "closes"
    };
    let error = Diagnostic::error(format!(
        "{} follows from {from} and cannot be a coordinate beside it: {loop_} {close} a loop by {joints}",
        coordinate_named(model, body)
    ))
    .hint("remove this `coordinate`, or ask for that of another body");
    model.source.blame(span, error)
}
