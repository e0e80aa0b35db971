//! The search for the next step: what can be placed, which loop closes, what remains.

mod matching;

use std::collections::VecDeque;

use flexure_runtime::diagnostic::Diagnostic;

use super::{Attachment, Leg, Step, Structure, Way, faults, turning_link};
use crate::model::{BodyId, BodyKind, GROUND, Local, Model};

/// What is known so far.
#[derive(Clone)]
pub(super) struct Search<'m> {
    model: &'m Model,
    /// Variables that are known, by body.
    known: Vec<bool>,
    /// How bodies are placed, by body; `None` for those that are not yet.
    placed: Vec<Option<Attachment>>,
    /// Distance from ground in bodies, by placed body.
    depth: Vec<usize>,
    /// The bodies that are looked at, in their order, and the pins on them.
    scope: (Vec<BodyId>, Vec<usize>),
    /// The pins on each body, in their order.
    pins_of: Vec<Vec<usize>>,
    /// The slides that run on each body, and each slide itself, in their order.
    guides_of: Vec<Vec<BodyId>>,
    /// For each pin, which of its members are held together by a step or a placement.
    ties: Vec<Vec<usize>>,
    /// For each slide, whether its guide was used.
    guide_used: Vec<bool>,
    pub(super) steps: Vec<Step>,
}

/// A body that can be placed.
struct Placement {
    body: BodyId,
    attachment: Attachment,
    depth: usize,
    /// The pin and the two members that it ties.
    tie: Option<(usize, usize, usize)>,
}

/// Where a way stands while it is searched: at the end of its legs, on a body, at a point.
#[derive(Clone)]
struct Front {
    start: (BodyId, Local),
    legs: Vec<Leg>,
    /// Body and point in its frame where it was entered.
    body: BodyId,
    enter: Local,
    visited: Vec<BodyId>,
    unknowns: Vec<BodyId>,
    /// Pins passed: pin and the two members.
    ties: Vec<(usize, usize, usize)>,
    guides: Vec<BodyId>,
}

impl<'m> Search<'m> {
    pub(super) fn new(model: &'m Model) -> Self {
        let count = model.bodies.len();
        let mut pins_of = vec![Vec::new(); count];
        for (index, pin) in model.pins.iter().enumerate() {
            for (body, _) in &pin.members {
                if pins_of[*body].last() != Some(&index) {
                    pins_of[*body].push(index);
                }
            }
        }
        let mut guides_of = vec![Vec::new(); count];
        for (id, body) in model.bodies.iter().enumerate() {
            if let BodyKind::Slide(slide) = &body.kind {
                guides_of[slide.carrier].push(id);
                if slide.carrier != id {
                    guides_of[id].push(id);
                }
            }
        }
        guides_of.iter_mut().for_each(|ids| ids.sort_unstable());
        let mut search = Self {
            model,
            scope: ((0..count).collect(), (0..model.pins.len()).collect()),
            pins_of,
            guides_of,
            known: vec![false; count],
            placed: vec![None; count],
            depth: vec![0; count],
            ties: model
                .pins
                .iter()
                .map(|pin| (0..pin.members.len()).collect())
                .collect(),
            guide_used: vec![false; count],
            steps: Vec::new(),
        };
        search.known[GROUND] = true;
        search.placed[GROUND] = Some(Attachment::Root);
        search
    }

    /// Looks only at these bodies, which nothing but ground joins to others.
    pub(super) fn look_at(&mut self, bodies: &[BodyId]) {
        let mut pins: Vec<usize> = bodies
            .iter()
            .flat_map(|body| self.pins_of[*body].iter().copied())
            .collect();
        pins.sort_unstable();
        pins.dedup();
        self.scope = (bodies.to_vec(), pins);
    }

    /// A variable is known from now on.
    pub(super) fn learn(&mut self, body: BodyId) {
        self.known[body] = true;
    }

    pub(super) fn is_known(&self, body: BodyId) -> bool {
        self.known[body]
    }

    /// The bodies of the loop that gives a body's variable.
    pub(super) fn around(&self, body: BodyId) -> Vec<BodyId> {
        let structure = self.so_far();
        let step = self
            .steps
            .iter()
            .find(|step| step.unknowns().contains(&body));
        let mut bodies: Vec<BodyId> = step
            .into_iter()
            .flat_map(|step| step.ways())
            .flat_map(|way| structure.way_bodies(way))
            .collect();
        bodies.sort_unstable();
        bodies.dedup();
        bodies
    }

    /// What is placed so far, without its steps.
    fn so_far(&self) -> Structure {
        Structure {
            attachments: self.attachments(),
            coordinates: Vec::new(),
            asked: Vec::new(),
            steps: Vec::new(),
        }
    }

    pub(super) fn is_placed(&self, bodies: &[BodyId]) -> bool {
        bodies.iter().all(|body| self.placed[*body].is_some())
    }

    /// How all bodies are placed; whatever is not, which the caller has excluded, stays on ground.
    pub(super) fn attachments(&self) -> Vec<Attachment> {
        self.placed
            .iter()
            .map(|a| a.unwrap_or(Attachment::Root))
            .collect()
    }

    /// Places bodies and closes loops as long as that goes on. A redundant joint is judged when its
    /// equations are there.
    pub(super) fn proceed(&mut self) {
        self.place_all();
        while let Some(front) = self.shortest_way(2) {
            self.take(front);
            self.place_all();
        }
    }

    /// Places every body that hangs on a placed one by a known variable, the nearest first.
    fn place_all(&mut self) {
        while let Some(placement) = self.next_placement() {
            let Placement {
                body,
                attachment,
                depth,
                tie,
            } = placement;
            if let Some((pin, a, b)) = tie {
                self.tie(pin, a, b);
            }
            self.placed[body] = Some(attachment);
            self.depth[body] = depth;
            match attachment {
                Attachment::Pinned { .. } | Attachment::Root => {}
                Attachment::Guided { .. } => self.guide_used[body] = true,
                Attachment::Carried { slide } => self.guide_used[slide] = true,
            }
        }
    }

    fn next_placement(&self) -> Option<Placement> {
        let mut offers = Vec::new();
        for &index in &self.scope.1 {
            let pin = &self.model.pins[index];
            for (a, (parent, there)) in pin.members.iter().enumerate() {
                if self.placed[*parent].is_none() {
                    continue;
                }
                for (b, (body, here)) in pin.members.iter().enumerate() {
                    if self.placed[*body].is_some()
                        || !self.angle_known(*body)
                        || self.scope.0.binary_search(body).is_err()
                    {
                        continue;
                    }
                    // A slide is placed by a pin only where its own guide does not do it.
                    if let BodyKind::Slide(slide) = &self.model.bodies[*body].kind
                        && self.placed[slide.carrier].is_some()
                    {
                        continue;
                    }
                    offers.push(Placement {
                        body: *body,
                        attachment: Attachment::Pinned {
                            parent: *parent,
                            there: *there,
                            here: *here,
                        },
                        depth: self.depth[*parent] + 1,
                        tie: Some((index, a, b)),
                    });
                }
            }
        }
        for &id in &self.scope.0 {
            let BodyKind::Slide(slide) = &self.model.bodies[id].kind else {
                continue;
            };
            let carrier = slide.carrier;
            let (on, there) = (self.placed[carrier].is_some(), self.placed[id].is_some());
            if !self.known[id] {
                continue;
            }
            if on && !there {
                offers.push(Placement {
                    body: id,
                    attachment: Attachment::Guided { carrier },
                    depth: self.depth[carrier] + 1,
                    tie: None,
                });
            } else if there && !on && self.angle_known(carrier) {
                offers.push(Placement {
                    body: carrier,
                    attachment: Attachment::Carried { slide: id },
                    depth: self.depth[id] + 1,
                    tie: None,
                });
            }
        }
        offers.into_iter().min_by_key(|offer| offer.depth)
    }

    fn angle_known(&self, body: BodyId) -> bool {
        turning_link(self.model, body).is_none_or(|link| self.known[link])
    }

    fn tie(&mut self, pin: usize, a: usize, b: usize) {
        let ties = &mut self.ties[pin];
        let (keep, drop) = (ties[a].min(ties[b]), ties[a].max(ties[b]));
        ties.iter_mut()
            .filter(|tie| **tie == drop)
            .for_each(|tie| *tie = keep);
    }

    /// The shortest way from placed to placed over unplaced bodies with at most `limit` unknowns.
    fn shortest_way(&self, limit: usize) -> Option<Front> {
        let mut queue: VecDeque<Front> = VecDeque::new();
        for &index in &self.scope.1 {
            let pin = &self.model.pins[index];
            let Some(a) = self.nearest_placed(index) else {
                continue;
            };
            for (b, (body, enter)) in pin.members.iter().enumerate() {
                if self.placed[*body].is_none()
                    && self.ties[index][a] != self.ties[index][b]
                    && self.scope.0.binary_search(body).is_ok()
                {
                    queue.push_back(Front {
                        start: pin.members[a],
                        legs: Vec::new(),
                        body: *body,
                        enter: *enter,
                        visited: vec![*body],
                        unknowns: Vec::new(),
                        ties: vec![(index, a, b)],
                        guides: Vec::new(),
                    });
                }
            }
        }
        for &id in &self.scope.0 {
            let BodyKind::Slide(slide) = &self.model.bodies[id].kind else {
                continue;
            };
            if self.placed[slide.carrier].is_some() && self.placed[id].is_none() {
                let front = Front {
                    start: (slide.carrier, slide.origin),
                    legs: Vec::new(),
                    body: slide.carrier,
                    enter: slide.origin,
                    visited: Vec::new(),
                    unknowns: Vec::new(),
                    ties: Vec::new(),
                    guides: Vec::new(),
                };
                queue.extend(self.along(&front, id, true, limit));
            }
        }
        while let Some(front) = queue.pop_front() {
            for next in self.onward(&front, limit) {
                if self.placed[next.body].is_some() {
                    return Some(next);
                }
                queue.push_back(next);
            }
        }
        None
    }

    /// The placed body on a pin where ways start and end, as all of them stand in the same place:
    /// that nearest to ground, so that loops have few bodies, but a link before a slide, because a
    /// loop of links alone may be a parallelogram.
    fn nearest_placed(&self, pin: usize) -> Option<usize> {
        let members = &self.model.pins[pin].members;
        (0..members.len())
            .filter(|member| self.placed[members[*member].0].is_some())
            .min_by_key(|member| {
                let body = members[*member].0;
                let is_slide = matches!(self.model.bodies[body].kind, BodyKind::Slide(_));
                (is_slide, self.depth[body])
            })
    }

    /// Every way that goes one joint further.
    fn onward(&self, front: &Front, limit: usize) -> Vec<Front> {
        let mut found = Vec::new();
        for &index in &self.pins_of[front.body] {
            let pin = &self.model.pins[index];
            let Some(a) = pin.members.iter().position(|(body, _)| *body == front.body) else {
                continue;
            };
            if front.ties.iter().any(|(passed, ..)| *passed == index) {
                continue;
            }
            let leave = pin.members[a].1;
            let arrival = self.nearest_placed(index);
            for (b, (body, enter)) in pin.members.iter().enumerate() {
                let is_passed = self.placed[*body].is_some() && arrival != Some(b);
                if b == a || front.visited.contains(body) || is_passed {
                    continue;
                }
                let Some(mut next) = self.across(front, leave, limit) else {
                    continue;
                };
                next.ties.push((index, a, b));
                next.body = *body;
                next.enter = *enter;
                next.visited.push(*body);
                found.push(next);
            }
        }
        for &id in &self.guides_of[front.body] {
            let BodyKind::Slide(slide) = &self.model.bodies[id].kind else {
                continue;
            };
            if front.guides.contains(&id) {
                continue;
            }
            if slide.carrier == front.body && !front.visited.contains(&id) {
                if let Some(next) = self.across(front, slide.origin, limit) {
                    found.extend(self.along(&next, id, true, limit));
                }
            } else if id == front.body
                && !front.visited.contains(&slide.carrier)
                && let Some(next) = self.across(front, Local::Origin, limit)
            {
                found.extend(self.along(&next, id, false, limit));
            }
        }
        found
    }

    /// Whether two places of one body are the same.
    fn same_place(&self, a: Local, b: Local) -> bool {
        let is_origin = |local: Local| match local {
            Local::Origin => true,
            Local::Cartesian(x, y) => self.model.graph.is_zero(x) && self.model.graph.is_zero(y),
            Local::Polar(radius, _) => self.model.graph.is_zero(radius),
        };
        a == b || (is_origin(a) && is_origin(b))
    }

    /// Across the body at which the way stands.
    fn across(&self, front: &Front, leave: Local, limit: usize) -> Option<Front> {
        let mut next = front.clone();
        if !self.same_place(leave, front.enter) {
            next.legs.push(Leg::Across {
                body: front.body,
                enter: front.enter,
                leave,
            });
            if let Some(link) = turning_link(self.model, front.body) {
                self.count(&mut next, link);
            }
        }
        (next.unknowns.len() <= limit).then_some(next)
    }

    /// Along a guide, to the slide or from it to its carrier.
    fn along(&self, front: &Front, slide: BodyId, outward: bool, limit: usize) -> Option<Front> {
        let BodyKind::Slide(shape) = &self.model.bodies[slide].kind else {
            return None;
        };
        let mut next = front.clone();
        next.legs.push(Leg::Along { slide, outward });
        self.count(&mut next, slide);
        if let Some(link) = turning_link(self.model, shape.carrier) {
            self.count(&mut next, link);
        }
        next.guides.push(slide);
        next.body = if outward { slide } else { shape.carrier };
        next.enter = if outward { Local::Origin } else { shape.origin };
        next.visited.push(next.body);
        (next.unknowns.len() <= limit).then_some(next)
    }

    fn count(&self, front: &mut Front, variable: BodyId) {
        if !self.known[variable] && !front.unknowns.contains(&variable) {
            front.unknowns.push(variable);
        }
    }

    /// Makes a step of a way that was found.
    fn take(&mut self, front: Front) {
        for (pin, a, b) in &front.ties {
            self.tie(*pin, *a, *b);
        }
        for slide in &front.guides {
            self.guide_used[*slide] = true;
        }
        for unknown in &front.unknowns {
            self.known[*unknown] = true;
        }
        let mut way = Way {
            start: front.start,
            legs: front.legs,
            end: (front.body, front.enter),
            pin: front.ties.last().map(|(pin, ..)| *pin),
        };
        let mut unknowns = front.unknowns;
        // A loop is told in the order of the file.
        if unknowns.first() > unknowns.last() {
            way = way.reversed();
            unknowns.reverse();
        }
        self.steps.push(match unknowns[..] {
            [first, second] => Step::Close {
                way,
                unknowns: [first, second],
            },
            [only] => Step::Redundant {
                way,
                unknown: Some(only),
            },
            _ => Step::Redundant { way, unknown: None },
        });
    }

    /// The first of `bodies` in the file whose variable is not known.
    pub(super) fn first_unknown(&self, bodies: &[BodyId]) -> Option<BodyId> {
        bodies.iter().copied().find(|body| !self.known[*body])
    }

    /// The coordinate among `bodies` after which everything closes in closed form, the first in
    /// the file; else simply the first. `more` further coordinates may be chosen after it. Links
    /// that cannot turn come last.
    pub(super) fn best_coordinate(
        &self,
        bodies: &[BodyId],
        held: &[bool],
        more: i64,
    ) -> Option<BodyId> {
        let (last, mut candidates): (Vec<BodyId>, Vec<BodyId>) = bodies
            .iter()
            .filter(|body| !self.known[**body])
            .partition(|body| held[**body]);
        candidates.extend(last);
        let closes = |candidate: &&BodyId| {
            let mut trial = self.clone();
            trial.learn(**candidate);
            trial.proceed();
            for _ in 0..more.max(0) {
                let next = candidates.iter().find(|body| !trial.known[**body]).copied();
                let Some(next) = next else { break };
                trial.learn(next);
                trial.proceed();
            }
            trial.is_placed(bodies)
        };
        candidates
            .iter()
            .find(closes)
            .or_else(|| {
                candidates
                    .iter()
                    .find(|body| self.can_spare(bodies, **body))
            })
            .or(candidates.first())
            .copied()
    }

    /// A coordinate for what stands on ground alone and has no freedom by counting, if its links
    /// then follow one another and every joint too many is that of a link as long as another of its
    /// loop: a further parallel leg, which takes away no freedom.
    pub(super) fn equal_legs(&self, bodies: &[BodyId]) -> Option<BodyId> {
        let is_apart = self.scope.1.iter().all(|&index| {
            let members = &self.model.pins[index].members;
            let is_open = members.iter().any(|(body, _)| self.placed[*body].is_none());
            !is_open
                || members
                    .iter()
                    .all(|(body, _)| *body == GROUND || self.placed[*body].is_none())
        });
        if !is_apart {
            return None;
        }
        let length = |body: BodyId| match &self.model.bodies[body].kind {
            BodyKind::Link(link) => Some(self.model.named_by(link.length)),
            BodyKind::Slide(_) | BodyKind::Ground => None,
        };
        let closes = |candidate: &BodyId| {
            let mut trial = self.clone();
            trial.learn(*candidate);
            trial.proceed();
            let structure = trial.so_far();
            let is_leg = |step: &Step| match step {
                Step::Redundant { way, unknown } => unknown.is_some_and(|leg| {
                    length(leg).is_some()
                        && structure
                            .way_bodies(way)
                            .into_iter()
                            .any(|other| other != leg && length(other) == length(leg))
                }),
                Step::Close { .. } | Step::Together { .. } => true,
            };
            trial.is_placed(bodies) && trial.steps[self.steps.len()..].iter().all(is_leg)
        };
        let open = |body: &BodyId| !self.known[*body];
        bodies.iter().copied().filter(open).find(closes)
    }

    /// All that is left of `bodies` closes together: a tree over the unplaced bodies, and a loop for
    /// each joint beside it.
    ///
    /// # Errors
    /// If there are not as many unknown variables as equations.
    pub(super) fn together(&mut self, bodies: &[BodyId]) -> Result<(), Diagnostic> {
        let mut trial = self.clone();
        let unknowns: Vec<BodyId> = bodies
            .iter()
            .copied()
            .filter(|body| !self.known[*body])
            .collect();
        let ways = trial.ways_with_all_known(bodies);
        if ways.len() * 2 != unknowns.len() || !trial.is_placed(bodies) {
            return Err(faults::overconstrained(self.model, &unknowns));
        }
        *self = trial;
        self.steps.push(Step::Together { ways, unknowns });
        Ok(())
    }

    /// The loops that are left once all variables of `bodies` are taken as known and the bodies
    /// placed by them: one for each joint beside the tree.
    fn ways_with_all_known(&mut self, bodies: &[BodyId]) -> Vec<Way> {
        let before = self.steps.len();
        for &body in bodies {
            self.known[body] = true;
        }
        self.place_all();
        self.leftover_joints();
        self.steps
            .drain(before..)
            .flat_map(|step| step.ways().to_vec())
            .collect()
    }

    /// Joints between placed bodies that nothing used yet: each is a loop without unknowns.
    pub(super) fn leftover_joints(&mut self) {
        for index in 0..self.model.pins.len() {
            let members = &self.model.pins[index].members;
            for b in 1..members.len() {
                let placed = [0, b].map(|m| self.placed[members[m].0].is_some());
                if placed == [true, true] && self.ties[index][0] != self.ties[index][b] {
                    self.tie(index, 0, b);
                    let way = Way {
                        start: members[0],
                        legs: Vec::new(),
                        end: members[b],
                        pin: Some(index),
                    };
                    self.steps.push(Step::Redundant { way, unknown: None });
                }
            }
        }
        for (id, body) in self.model.bodies.iter().enumerate() {
            let BodyKind::Slide(slide) = &body.kind else {
                continue;
            };
            let both = self.placed[id].is_some() && self.placed[slide.carrier].is_some();
            if both && !self.guide_used[id] {
                self.guide_used[id] = true;
                let way = Way {
                    start: (slide.carrier, slide.origin),
                    legs: vec![Leg::Along {
                        slide: id,
                        outward: true,
                    }],
                    end: (id, Local::Origin),
                    pin: None,
                };
                self.steps.push(Step::Redundant { way, unknown: None });
            }
        }
    }
}
