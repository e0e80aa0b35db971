//! Structure: from bodies and joints to loops, coordinates and the order in which loops close.
//!
//! ```text
//! joints ──▶ spanning tree from ground ──▶ loops ──▶ degrees of freedom ──▶ coordinates
//!            (shortest way of each body)   (one for    (variables less        (as asked, else
//!                                           each joint   two for each loop)    first in the file)
//!                                           off the tree)
//! ```
//!
//! A link brings one variable, its angle; a slide one, its position on its guide. Every position is
//! a sum of vectors turned by link angles, so a loop is two equations in the angles of its links. A
//! loop with two unknown angles left closes in closed form; the loops are put in an order in which
//! each has two.

use flexure_runtime::diagnostic::Diagnostic;

use crate::model::{BodyId, BodyKind, GROUND, Model};

/// How a body hangs on the tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Attachment {
    /// Ground itself.
    Root,
    /// Pinned to a body nearer to ground: that body, the pin, and the members of the pin that are
    /// the nearer body and this one.
    Pinned {
        /// The nearer body.
        parent: BodyId,
        /// Position in [`Model::pins`].
        pin: usize,
        /// Position of the nearer body among the pin's members.
        parent_member: usize,
        /// Position of this body among the pin's members.
        member: usize,
    },
    /// A slide on its carrier.
    Guided {
        /// The carrier.
        carrier: BodyId,
    },
}

/// A pin that closes a loop: the way to its first member and the way to its second end in the same
/// place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ClosedLoop {
    /// Position in [`Model::pins`].
    pub pin: usize,
    /// The two members of the pin (positions among its members) whose ways meet here: the longer
    /// way first.
    pub members: (usize, usize),
    /// Links whose angles take part, in the order in which one passes them from ground to ground.
    pub links: Vec<BodyId>,
    /// The two links whose angles close it, in that order.
    pub unknowns: (BodyId, BodyId),
}

/// The structure of a model.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Structure {
    /// How each body hangs on the tree, by body.
    pub attachments: Vec<Attachment>,
    /// Independent coordinates, each a link (its angle) or a slide (its position), in the order of
    /// the file.
    pub coordinates: Vec<BodyId>,
    /// Whether the user asked for each coordinate.
    pub asked: Vec<bool>,
    /// Loops in the order in which they close.
    pub loops: Vec<ClosedLoop>,
}

impl Structure {
    /// The link with whose angle a body turns; `None` for what only translates.
    pub fn turning_link(&self, model: &Model, body: BodyId) -> Option<BodyId> {
        let mut body = body;
        loop {
            match &model.bodies[body].kind {
                BodyKind::Ground => return None,
                BodyKind::Link(_) => return Some(body),
                BodyKind::Slide(slide) => body = slide.carrier,
            }
        }
    }

    /// The bodies from `body` towards ground, without ground.
    pub fn way_to_ground(&self, body: BodyId) -> Vec<BodyId> {
        let mut way = Vec::new();
        let mut at = body;
        while at != GROUND {
            way.push(at);
            at = match self.attachments[at] {
                Attachment::Root => GROUND,
                Attachment::Pinned { parent, .. } => parent,
                Attachment::Guided { carrier } => carrier,
            };
        }
        way
    }
}

/// Finds the structure of a model, or says what is wrong with it.
///
/// # Errors
/// Bodies that nothing joins to ground, more joints than the bodies can follow, coordinates that
/// are not independent, loops that need more than one closed step.
pub fn structure(model: &Model) -> Result<Structure, Vec<Diagnostic>> {
    let (attachments, joints) = spanning_tree(model);
    let mut errors = Vec::new();
    for (id, body) in model.bodies.iter().enumerate().skip(1) {
        if attachments[id].is_none() {
            errors.push(
                Diagnostic::error(format!("`{}` is not joined to ground", body.name))
                    .at(model.source.site(body.span))
                    .hint("let one of its ends be a `ground` point, or a point of a body that is joined to ground"),
            );
        }
    }
    if model.bodies.len() == 1 {
        errors.push(
            Diagnostic::error("nothing in this model can move")
                .hint("describe at least one `link` or `slide`"),
        );
    }
    if !errors.is_empty() {
        return Err(errors);
    }
    let attachments: Vec<Attachment> = attachments.into_iter().flatten().collect();
    let mut structure = Structure {
        attachments,
        coordinates: Vec::new(),
        asked: Vec::new(),
        loops: Vec::new(),
    };

    let mut open: Vec<OpenLoop> = Vec::new();
    for (pin, first, second) in joints {
        match open_loop(model, &structure, pin, first, second) {
            Ok(found) => open.push(found),
            Err(error) => errors.push(error),
        }
    }
    if !errors.is_empty() {
        return Err(errors);
    }
    choose(model, &mut structure, open)?;
    Ok(structure)
}

/// A pin off the tree with the two of its members that it joins.
type OffTree = (usize, usize, usize);

/// Breadth-first from ground, so that every body gets its shortest way; joints in file order.
fn spanning_tree(model: &Model) -> (Vec<Option<Attachment>>, Vec<OffTree>) {
    let mut attachments: Vec<Option<Attachment>> = vec![None; model.bodies.len()];
    let mut off_tree = Vec::new();
    let mut pin_done = vec![false; model.pins.len()];
    attachments[GROUND] = Some(Attachment::Root);
    let mut queue = std::collections::VecDeque::from([GROUND]);
    while let Some(body) = queue.pop_front() {
        for (pin_id, pin) in model.pins.iter().enumerate() {
            if pin_done[pin_id] {
                continue;
            }
            let Some(host) = pin.members.iter().position(|(member, _)| *member == body) else {
                continue;
            };
            pin_done[pin_id] = true;
            for (member, (other, _)) in pin.members.iter().enumerate() {
                if member == host {
                    continue;
                }
                if attachments[*other].is_none() && !is_slide(model, *other) {
                    attachments[*other] = Some(Attachment::Pinned {
                        parent: body,
                        pin: pin_id,
                        parent_member: host,
                        member,
                    });
                    queue.push_back(*other);
                } else {
                    off_tree.push((pin_id, member, host));
                }
            }
        }
        for (id, other) in model.bodies.iter().enumerate() {
            if let BodyKind::Slide(slide) = &other.kind
                && slide.carrier == body
                && attachments[id].is_none()
            {
                attachments[id] = Some(Attachment::Guided { carrier: body });
                queue.push_back(id);
            }
        }
    }
    (attachments, off_tree)
}

fn is_slide(model: &Model, body: BodyId) -> bool {
    matches!(model.bodies[body].kind, BodyKind::Slide(_))
}

/// A loop before it is known what closes it.
struct OpenLoop {
    pin: usize,
    members: (usize, usize),
    links: Vec<BodyId>,
}

fn open_loop(
    model: &Model,
    structure: &Structure,
    pin: usize,
    first: usize,
    second: usize,
) -> Result<OpenLoop, Diagnostic> {
    let place = &model.pins[pin];
    let ways = [first, second].map(|m| structure.way_to_ground(place.members[m].0));
    let names = |bodies: &[BodyId]| {
        let names: Vec<String> = bodies
            .iter()
            .map(|b| format!("`{}`", model.bodies[*b].name))
            .collect();
        names.join(", ")
    };
    let mut members = (first, second);
    let [mut one, mut other] = ways;
    // What both ways have in common does not take part.
    while let (Some(a), Some(b)) = (one.last(), other.last()) {
        if a != b {
            break;
        }
        // Two different points of one body: it takes part with the vector between them, unless
        // the ways leave it at the same pin.
        let shared = one.pop().unwrap_or(GROUND);
        other.pop();
        if !one.is_empty() && !other.is_empty() {
            continue;
        }
        if one.is_empty() && other.is_empty() {
            return Err(Diagnostic::error(format!(
                "`{}` is pinned to itself at `{}`",
                model.bodies[shared].name, place.name
            ))
            .at(model.source.site(place.span))
            .hint("a pin joins different bodies"));
        }
        one.push(shared);
        break;
    }
    if one.len() < other.len() {
        std::mem::swap(&mut one, &mut other);
        members = (second, first);
    }
    let all: Vec<BodyId> = one.iter().rev().chain(other.iter()).copied().collect();
    if let Some(slide) = all.iter().find(|body| is_slide(model, **body)) {
        return Err(Diagnostic::error(format!(
            "the loop {} runs through the slide `{}`, which is not supported yet",
            names(&all),
            model.bodies[*slide].name
        ))
        .at(model.source.site(place.span))
        .hint("connect links and slides by a `spring` or a `contact`, or describe the loop by pinned links"));
    }
    Ok(OpenLoop {
        pin,
        members,
        links: all,
    })
}

/// Chooses coordinates and the order of loops.
fn choose(
    model: &Model,
    structure: &mut Structure,
    mut open: Vec<OpenLoop>,
) -> Result<(), Vec<Diagnostic>> {
    let variables: Vec<BodyId> = (1..model.bodies.len()).collect();
    let freedom = variables.len() as i64 - 2 * open.len() as i64;
    if freedom < 0 {
        return Err(vec![over_constrained(model, &open, freedom)]);
    }
    let mut known = vec![false; model.bodies.len()];
    known[GROUND] = true;
    let mut errors = Vec::new();
    let mut asked: Vec<BodyId> = Vec::new();
    for request in &model.coordinates {
        if asked.contains(&request.body) {
            continue;
        }
        if asked.len() as i64 == freedom {
            errors.push(
                Diagnostic::error(format!(
                    "more coordinates are asked for than the mechanism has degrees of freedom ({freedom})"
                ))
                .at(model.source.site(request.span))
                .hint("remove this `coordinate`"),
            );
            break;
        }
        asked.push(request.body);
        known[request.body] = true;
    }
    if !errors.is_empty() {
        return Err(errors);
    }
    let mut coordinates = asked.clone();
    // Bodies in no loop move on their own.
    for &body in &variables {
        if !known[body] && !open.iter().any(|l| l.links.contains(&body)) {
            known[body] = true;
            coordinates.push(body);
        }
    }
    while !open.is_empty() {
        let unknowns = |l: &OpenLoop, known: &[bool]| -> Vec<BodyId> {
            l.links.iter().copied().filter(|b| !known[*b]).collect()
        };
        if let Some(at) = open.iter().position(|l| unknowns(l, &known).len() == 2) {
            let found = open.remove(at);
            let pair = unknowns(&found, &known);
            known[pair[0]] = true;
            known[pair[1]] = true;
            structure.loops.push(ClosedLoop {
                pin: found.pin,
                members: found.members,
                links: found.links,
                unknowns: (pair[0], pair[1]),
            });
            continue;
        }
        if let Some(stiff) = open.iter().find(|l| unknowns(l, &known).len() < 2) {
            return Err(vec![dependent_coordinates(model, stiff, &asked)]);
        }
        // The loop that lacks least gets the first of its links in the file as a coordinate.
        let fewest = open.iter().min_by_key(|l| unknowns(l, &known).len());
        let next = fewest.and_then(|l| unknowns(l, &known).into_iter().min());
        let Some(next) = next else { break };
        if coordinates.len() as i64 >= freedom {
            return Err(vec![dependent_coordinates(model, &open[0], &asked)]);
        }
        known[next] = true;
        coordinates.push(next);
    }
    coordinates.sort_unstable();
    structure.asked = coordinates
        .iter()
        .map(|body| asked.contains(body))
        .collect();
    structure.coordinates = coordinates;
    if structure.coordinates.is_empty() {
        return Err(vec![
            Diagnostic::error("nothing in this model can move: its links form a rigid truss")
                .at(model.source.site(model.bodies[1].span))
                .hint("remove a link, or let one of them end in a point of its own"),
        ]);
    }
    Ok(())
}

fn loop_names(model: &Model, links: &[BodyId]) -> String {
    let names: Vec<&str> = links
        .iter()
        .map(|b| model.bodies[*b].name.as_str())
        .collect();
    names.join("–")
}

fn over_constrained(model: &Model, open: &[OpenLoop], freedom: i64) -> Diagnostic {
    let loops: Vec<String> = open.iter().map(|l| loop_names(model, &l.links)).collect();
    let last = &model.pins[open[open.len() - 1].pin];
    Diagnostic::error(format!(
        "the mechanism is over-constrained: its joints take away {} degree{} of freedom more than its bodies have (loops {})",
        -freedom,
        if freedom == -1 { "" } else { "s" },
        loops.join(", ")
    ))
    .at(model.source.site(last.span))
    .hint("remove a link or a pin of these loops")
}

fn dependent_coordinates(model: &Model, stiff: &OpenLoop, asked: &[BodyId]) -> Diagnostic {
    let names = loop_names(model, &stiff.links);
    let request = model
        .coordinates
        .iter()
        .rev()
        .find(|r| asked.contains(&r.body) && stiff.links.contains(&r.body));
    match request {
        Some(request) => Diagnostic::error(format!(
            "`{}` cannot be a coordinate beside the others: the loop {names} already fixes it",
            model.bodies[request.body].name
        ))
        .at(model.source.site(request.span))
        .hint("ask for one coordinate of this loop less"),
        None => Diagnostic::error(format!(
            "the loop {names} is over-constrained: its links cannot move against each other"
        ))
        .at(model.source.site(model.pins[stiff.pin].span))
        .hint("remove a link or a pin of this loop"),
    }
}
