//! Plain steps: those that ask for nothing but the right-hand side and a look at what they came to.
//!
//! They are taken on lanes, several trajectories together or one alone, by code that is compiled
//! for the instructions at hand. The first step that is not a plain one (an event, a dead point, a
//! failure, a row to be recorded) is left to the trajectory's walk.

mod block;
mod lockstep;
mod own_steps;
mod steps;

pub(super) use block::Block;
pub(super) use lockstep::Lockstep;
pub(super) use own_steps::OwnSteps;
pub(super) use steps::{Steps, Verdict, Way};

use std::any::Any;

use super::pace::Pace;
use super::stand::Stand;
use crate::lanes::{self, LaneSystem, Lanes, Task};

/// Steps after which a walk is to hear how far its trajectory is.
const MOST: u64 = 4096;

/// Plain steps that a run asks its system to take, from where it stands.
///
/// A system whose right-hand side runs on lanes takes them by [`PlainSteps::on_lanes`]; any other
/// leaves them.
pub struct PlainSteps<'w> {
    pub(super) stand: &'w mut Stand,
    pub(super) inputs: &'w [f64],
    /// The system in its lane, kept from one call to the next.
    pub(super) in_lanes: &'w mut Option<Box<dyn Any>>,
    pub(super) way: Way<'w>,
    /// Where they led, if there were any.
    pub(super) verdict: Option<Verdict>,
}

impl PlainSteps<'_> {
    /// Takes them on one lane, by the widest instructions that the machine has.
    pub fn on_lanes<S: LaneSystem>(&mut self, system: &S) {
        lanes::on_path_alone(lanes::Path::chosen(), Alone(self, system));
    }

    #[inline(always)]
    fn take<S: LaneSystem, L: Lanes, P: Steps<S, L>>(&mut self, system: &S) {
        if !P::can_take(self.stand, self.way.to) {
            return;
        }
        let kept = self.in_lanes.take().and_then(|any| any.downcast().ok());
        let in_lanes = kept.unwrap_or_else(|| Box::new(system.alone::<L>()));
        let mut block = Block::<S, L>::new(system, in_lanes, self.inputs);
        let mut steps = P::new(self.stand.x.len());
        block.load(0, self.stand);
        steps.load(0, self.stand, &self.way);
        steps.advance(&mut block, MOST);
        self.verdict = Some(steps.verdict(0));
        let way = Way {
            watch: self.way.watch.take(),
            ..self.way
        };
        steps.store(0, self.stand, way, &mut block);
        *self.in_lanes = Some(block.system);
    }
}

/// Steps of one trajectory alone.
struct Alone<'t, 'w, S>(&'t mut PlainSteps<'w>, &'t S);

impl<S: LaneSystem> Task for Alone<'_, '_, S> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let Self(steps, system) = self;
        match steps.stand.pace {
            Pace::Fixed(_) => steps.take::<S, L, Lockstep<L>>(system),
            Pace::Adaptive(_) => steps.take::<S, L, OwnSteps<S, L>>(system),
        }
    }
}
