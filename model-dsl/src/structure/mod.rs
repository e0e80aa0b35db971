//! Structure: from bodies and joints to coordinates and the order in which loops close.
//!
//! ```text
//! ground is placed ─┬─▶ a body with a known variable on a placed body: place it
//!                   ├─▶ a way from placed to placed over unplaced bodies with two unknown
//!                   │   variables: a loop that closes (an Assur dyad), then both are known
//!                   ├─▶ with fewer: a redundant joint, accepted if it holds by itself
//!                   ├─▶ degrees of freedom left: choose a coordinate
//!                   └─▶ none left: all that remains closes together (Newton's method)
//! ```
//!
//! A link brings one variable, its angle; a slide one, its position on its guide; both turn into
//! two equations for each loop, because a place is a sum of turned vectors. The steps are taken in
//! the order above until every body is placed, so each loop has the fewest bodies that can close it.
//! What is wrong on the way is said by `faults`, with the bodies and joints involved.

mod faults;
mod held;
mod search;

use flexure_runtime::diagnostic::Diagnostic;

use crate::groups::Groups;
use crate::model::{BodyId, BodyKind, GROUND, Local, Model};
pub(crate) use faults::{bodies_named, coordinate_named, joints_named};
pub(crate) use held::held_parallel;
use search::Search;

/// Links and slides that a model may have: equations of more would be longer than anyone reads,
/// and their search for loops slower than anyone waits.
pub const MOST_BODIES: usize = 1000;

/// How the place of a body follows from that of another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Attachment {
    /// Ground itself.
    Root,
    /// Pinned to a body nearer to ground: that body, and the pin in its frame and in this body's.
    Pinned {
        /// The nearer body.
        parent: BodyId,
        /// The pin in the nearer body's frame.
        there: Local,
        /// The pin in this body's frame.
        here: Local,
    },
    /// A slide on its carrier.
    Guided {
        /// The carrier.
        carrier: BodyId,
    },
    /// A body that is carried by the slide on its own guide, because the slide is held.
    Carried {
        /// The slide.
        slide: BodyId,
    },
}

/// A piece of the way around a loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Leg {
    /// From one point of a body to another.
    Across {
        /// The body.
        body: BodyId,
        /// Where the way enters.
        enter: Local,
        /// Where it leaves.
        leave: Local,
    },
    /// Along the guide of a slide, from its origin to the slide or back.
    Along {
        /// The slide.
        slide: BodyId,
        /// From the carrier to the slide.
        outward: bool,
    },
}

/// A loop: from a placed body over others to a placed body.
#[derive(Clone, Debug, PartialEq)]
pub struct Way {
    /// The placed body where it starts, and the point.
    pub start: (BodyId, Local),
    /// The pieces between.
    pub legs: Vec<Leg>,
    /// The placed body where it ends, and the point.
    pub end: (BodyId, Local),
    /// The pin at which it ends, for messages.
    pub pin: Option<usize>,
}

impl Way {
    /// The same loop the other way round.
    fn reversed(self) -> Self {
        let turned = |leg: Leg| match leg {
            Leg::Across { body, enter, leave } => Leg::Across {
                body,
                enter: leave,
                leave: enter,
            },
            Leg::Along { slide, outward } => Leg::Along {
                slide,
                outward: !outward,
            },
        };
        Way {
            start: self.end,
            legs: self.legs.into_iter().rev().map(turned).collect(),
            end: self.start,
            pin: self.pin,
        }
    }
}

/// What is done about a loop.
#[derive(Clone, Debug, PartialEq)]
pub enum Step {
    /// Two variables close one loop.
    Close {
        /// The loop.
        way: Way,
        /// The links or slides whose variables close it, in the order of the way.
        unknowns: [BodyId; 2],
    },
    /// A loop with fewer than two unknown variables: it must hold by itself.
    Redundant {
        /// The loop.
        way: Way,
        /// The variable that it still fixes.
        unknown: Option<BodyId>,
    },
    /// Several loops that only close together.
    Together {
        /// The loops.
        ways: Vec<Way>,
        /// The links or slides whose variables close them, two for each loop.
        unknowns: Vec<BodyId>,
    },
}

impl Step {
    /// The loops of the step.
    pub fn ways(&self) -> &[Way] {
        match self {
            Step::Close { way, .. } | Step::Redundant { way, .. } => std::slice::from_ref(way),
            Step::Together { ways, .. } => ways,
        }
    }

    /// The bodies whose variables the step finds.
    pub fn unknowns(&self) -> Vec<BodyId> {
        match self {
            Step::Close { unknowns, .. } => unknowns.to_vec(),
            Step::Redundant { unknown, .. } => unknown.iter().copied().collect(),
            Step::Together { unknowns, .. } => unknowns.clone(),
        }
    }
}

/// The structure of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct Structure {
    /// How each body is placed, by body.
    pub attachments: Vec<Attachment>,
    /// Independent coordinates, each a link (its angle) or a slide (its position): those that were
    /// asked for in the order in which they were, then the others in the order of the file.
    pub coordinates: Vec<BodyId>,
    /// Whether the user asked for each coordinate.
    pub asked: Vec<bool>,
    /// Loops in the order in which they close.
    pub steps: Vec<Step>,
}

impl Structure {
    /// Whether no loops have to be closed together by Newton's method.
    pub fn is_closed_form(&self) -> bool {
        self.steps
            .iter()
            .all(|step| !matches!(step, Step::Together { .. }))
    }

    /// Whether a body's variable takes part in a loop.
    pub fn in_loop(&self, body: BodyId) -> bool {
        self.steps.iter().any(|step| {
            step.unknowns().contains(&body)
                || step
                    .ways()
                    .iter()
                    .any(|way| self.way_bodies(way).contains(&body))
        })
    }

    /// The bodies of a loop in order from ground to ground, without ground.
    pub fn way_bodies(&self, way: &Way) -> Vec<BodyId> {
        let mut bodies = self.way_out(way.start.0);
        for leg in &way.legs {
            match *leg {
                Leg::Across { body, .. } => bodies.push(body),
                Leg::Along { slide, .. } => bodies.push(slide),
            }
        }
        let mut back = self.way_out(way.end.0);
        // What both ends have in common does not take part.
        let common = bodies.iter().zip(&back).take_while(|(a, b)| a == b).count();
        bodies.drain(..common);
        back.drain(..common);
        back.reverse();
        bodies.extend(back);
        bodies.dedup();
        bodies
    }

    /// The bodies from ground to `body`, without ground.
    pub(crate) fn way_out(&self, body: BodyId) -> Vec<BodyId> {
        let mut way = Vec::new();
        let mut at = body;
        while at != GROUND {
            way.push(at);
            at = match self.attachments[at] {
                Attachment::Root => GROUND,
                Attachment::Pinned { parent, .. } => parent,
                Attachment::Guided { carrier } => carrier,
                Attachment::Carried { slide } => slide,
            };
        }
        way.reverse();
        way
    }
}

/// The link with whose angle a body turns; `None` for what only translates.
pub(crate) fn turning_link(model: &Model, body: BodyId) -> Option<BodyId> {
    let mut body = body;
    // A chain of slides cannot be longer than there are bodies.
    for _ in 0..model.bodies.len() {
        match &model.bodies[body].kind {
            BodyKind::Ground => return None,
            BodyKind::Link(_) => return Some(body),
            BodyKind::Slide(slide) => body = slide.carrier,
        }
    }
    None
}

/// Finds the structure of a model, or says what is wrong with it.
///
/// # Errors
/// Bodies that nothing joins to ground, coordinates that are not independent, parts that cannot
/// move against each other.
pub fn structure(model: &Model) -> Result<Structure, Vec<Diagnostic>> {
    if model.bodies.len() == 1 {
        return Err(vec![
            Diagnostic::error("nothing in this model can move")
                .hint("describe at least one `link` or `slide`"),
        ]);
    }
    if let Some(body) = model.bodies.get(MOST_BODIES + 1) {
        return Err(vec![
            model.source.blame(
                body.span,
                Diagnostic::error(format!(
                    "the model has {} bodies, more than {MOST_BODIES} are not compiled",
                    model.bodies.len() - 1
                ))
                .hint("lump links or slides together, or cut the model into several"),
            ),
        ]);
    }
    let components = components(model)?;
    let twice = faults::pinned_twice(model);
    if !twice.is_empty() {
        return Err(twice);
    }
    let mut search = Search::new(model);
    let asked = asked(model, &components)?;
    for &body in &asked {
        search.learn(body);
    }
    let mut coordinates = asked.clone();
    let mut held: Option<Vec<bool>> = None;
    for component in &components {
        let before = search.steps.len();
        search.look_at(&component.bodies);
        search.proceed();
        while !search.is_placed(&component.bodies) {
            let own = coordinates
                .iter()
                .filter(|body| component.bodies.contains(body))
                .count() as i64;
            // A redundant joint takes away no freedom.
            let freedom = component.freedom + redundancy(&search.steps[before..]);
            let left = freedom.max(i64::from(own == 0)) - own;
            if left <= 0 && own > 0 {
                if let Some(next) = search.equal_legs(&component.bodies) {
                    coordinates.push(next);
                    search.learn(next);
                    search.proceed();
                } else if let Err(error) = search.together(&component.bodies) {
                    let follows = dependent(model, component, &asked, true);
                    return Err(vec![follows.unwrap_or(error)]);
                }
                continue;
            }
            let next = if component.loops == 0 {
                search.first_unknown(&component.bodies)
            } else {
                let held = held.get_or_insert_with(|| held_parallel(model));
                search.best_coordinate(&component.bodies, held, left - 1)
            };
            let Some(next) = next else {
                break;
            };
            coordinates.push(next);
            search.learn(next);
            search.proceed();
        }
    }
    search.leftover_joints();
    if coordinates.is_empty() {
        return Err(vec![faults::rigid(model)]);
    }
    // Those that were asked for lead, in the order in which they were.
    coordinates[asked.len()..].sort_unstable();
    let structure = Structure {
        attachments: search.attachments(),
        asked: coordinates
            .iter()
            .map(|body| asked.contains(body))
            .collect(),
        coordinates,
        steps: search.steps,
    };
    Ok(structure)
}

/// Bodies that hang together without ground.
struct Component {
    bodies: Vec<BodyId>,
    /// Independent loops.
    loops: i64,
    /// Degrees of freedom by counting: variables less two for each loop.
    freedom: i64,
}

/// The components of a model, each joined to ground.
fn components(model: &Model) -> Result<Vec<Component>, Vec<Diagnostic>> {
    let count = model.bodies.len();
    let mut groups = Groups::new(count);
    let mut grounded = vec![false; count];
    let mut join = |a: BodyId, b: BodyId| {
        if a == GROUND || b == GROUND {
            grounded[a.max(b)] = true;
        } else {
            groups.join(a, b);
        }
    };
    for pin in &model.pins {
        for pair in pin.members.windows(2) {
            join(pair[0].0, pair[1].0);
        }
        // A pin on ground grounds every member.
        if pin.members.iter().any(|(body, _)| *body == GROUND) {
            for (body, _) in &pin.members {
                join(GROUND, *body);
            }
        }
    }
    for (id, body) in model.bodies.iter().enumerate() {
        if let BodyKind::Slide(slide) = &body.kind {
            join(id, slide.carrier);
        }
    }
    let mut members: Vec<Vec<BodyId>> = vec![Vec::new(); count];
    for body in 1..count {
        members[groups.lead(body)].push(body);
    }
    // A pin on several bodies belongs to the component of those that are not ground.
    let mut pinned = vec![0; count];
    for pin in &model.pins {
        if let Some((body, _)) = pin.members.iter().find(|(body, _)| *body != GROUND) {
            pinned[groups.lead(*body)] += pin.members.len() - 1;
        }
    }
    let mut errors = Vec::new();
    let mut components = Vec::new();
    for lead in 1..count {
        let bodies = std::mem::take(&mut members[lead]);
        if bodies.is_empty() {
            continue;
        }
        if !bodies.iter().any(|body| grounded[*body]) {
            errors.push(faults::unjoined(model, &bodies));
            continue;
        }
        let pins: usize = pinned[lead];
        let slides = bodies
            .iter()
            .filter(|body| matches!(model.bodies[**body].kind, BodyKind::Slide(_)))
            .count();
        let loops = (pins + slides) as i64 - bodies.len() as i64;
        let freedom = bodies.len() as i64 - 2 * loops;
        components.push(Component {
            bodies,
            loops,
            freedom,
        });
    }
    if errors.is_empty() {
        Ok(components)
    } else {
        Err(errors)
    }
}

/// The coordinates that the user asks for.
fn asked(model: &Model, components: &[Component]) -> Result<Vec<BodyId>, Vec<Diagnostic>> {
    let mut asked: Vec<BodyId> = Vec::new();
    for request in &model.coordinates {
        if asked.contains(&request.body) {
            continue;
        }
        asked.push(request.body);
    }
    let follows: Vec<Diagnostic> = components
        .iter()
        .filter_map(|component| dependent(model, component, &asked, false))
        .collect();
    if follows.is_empty() {
        Ok(asked)
    } else {
        Err(follows)
    }
}

/// Freedom that equations take away which say nothing new: two equations for each loop, less the
/// variables that they fix.
fn redundancy(steps: &[Step]) -> i64 {
    steps
        .iter()
        .filter(|step| matches!(step, Step::Redundant { .. }))
        .map(|step| 2 - step.unknowns().len() as i64)
        .sum()
}

/// The first coordinate asked for in a component that those before it determine. `by_counting`
/// also tells so where loops only close together, which says nothing where joints are redundant.
fn dependent(
    model: &Model,
    component: &Component,
    asked: &[BodyId],
    by_counting: bool,
) -> Option<Diagnostic> {
    let mut own = model.coordinates.iter().filter(|request| {
        asked.contains(&request.body) && component.bodies.contains(&request.body)
    });
    let mut request = own.next()?;
    let mut search = Search::new(model);
    search.look_at(&component.bodies);
    search.proceed();
    let mut leaders: Vec<BodyId> = Vec::new();
    while leaders.contains(&request.body)
        || !search.is_known(request.body)
            && (!by_counting || search.can_spare(&component.bodies, request.body))
    {
        search.learn(request.body);
        search.proceed();
        leaders.push(request.body);
        request = own.next()?;
    }
    if leaders.is_empty() {
        // No coordinate at all is free: that is another fault.
        return None;
    }
    let around = if search.is_known(request.body) {
        search.around(request.body)
    } else {
        component.bodies.clone()
    };
    leaders.dedup();
    if leaders.iter().any(|leader| around.contains(leader)) {
        leaders.retain(|leader| around.contains(leader));
    }
    let asked_for = (request.body, request.span);
    Some(faults::follows(model, asked_for, &around, &leaders))
}

/// `crank–coupler–rocker`.
pub(crate) fn loop_names(model: &Model, bodies: &[BodyId]) -> String {
    let names: Vec<&str> = bodies
        .iter()
        .filter(|body| !model.is_traced(**body))
        .map(|b| model.bodies[*b].name.as_str())
        .collect();
    names.join("–")
}
