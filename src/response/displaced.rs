//! A system that starts a little beside its start: its trajectory tells whether small differences
//! grow. At no offset it is the system itself.

use flexure_runtime::lanes::{LaneSystem, Lanes};
use flexure_runtime::system::{Energy, EventAction, System, Variable};
use flexure_runtime::table::TableReport;

/// A system whose first state starts elsewhere.
#[derive(Clone, Debug)]
pub(super) struct Displaced<S> {
    pub system: S,
    /// By how much the first state differs at the start.
    pub offset: f64,
}

impl<S: System> System for Displaced<S> {
    fn start(&self, x: &mut [f64], d: &mut [f64]) {
        self.system.start(x, d);
        if let Some(first) = x.first_mut()
            && self.offset != 0.0
        {
            *first += self.offset;
        }
    }

    fn states(&self) -> &[Variable] {
        self.system.states()
    }

    fn discretes(&self) -> &[Variable] {
        self.system.discretes()
    }

    fn inputs(&self) -> &[Variable] {
        self.system.inputs()
    }

    fn output_variables(&self) -> &[Variable] {
        self.system.output_variables()
    }

    fn rhs(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], dx: &mut [f64]) {
        self.system.rhs(t, x, d, u, dx);
    }

    fn jacobian(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], jacobian: &mut [f64]) {
        self.system.jacobian(t, x, d, u, jacobian);
    }

    fn outputs(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], out: &mut [f64]) {
        self.system.outputs(t, x, d, u, out);
    }

    fn energy(&self, t: f64, x: &[f64], d: &[f64], u: &[f64]) -> Energy {
        self.system.energy(t, x, d, u)
    }

    fn kink_count(&self) -> usize {
        self.system.kink_count()
    }

    fn next_kinks(&self, d: &[f64], times: &mut [f64]) {
        self.system.next_kinks(d, times);
    }

    fn pass_kink(&self, index: usize, d: &mut [f64]) {
        self.system.pass_kink(index, d);
    }

    fn event_count(&self) -> usize {
        self.system.event_count()
    }

    fn events(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], values: &mut [f64]) {
        self.system.events(t, x, d, u, values);
    }

    fn event_name(&self, index: usize) -> &str {
        self.system.event_name(index)
    }

    fn pass_event(
        &self,
        index: usize,
        t: f64,
        x: &mut [f64],
        d: &mut [f64],
        u: &[f64],
    ) -> EventAction {
        self.system.pass_event(index, t, x, d, u)
    }

    fn accept(&self, t: f64, x: &[f64], u: &[f64], d: &mut [f64]) {
        self.system.accept(t, x, u, d);
    }

    fn turning(&self) -> &[usize] {
        self.system.turning()
    }

    fn loop_count(&self) -> usize {
        self.system.loop_count()
    }

    fn closures(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], values: &mut [f64]) {
        self.system.closures(t, x, d, u, values);
    }

    fn loop_name(&self, index: usize) -> &str {
        self.system.loop_name(index)
    }

    fn tables(&self) -> Vec<TableReport> {
        self.system.tables()
    }

    fn is_outside_tables(&self, x: &[f64]) -> bool {
        self.system.is_outside_tables(x)
    }
}

impl<S: LaneSystem> LaneSystem for Displaced<S> {
    type InLanes<L: Lanes> = S::InLanes<L>;

    fn in_every_lane<L: Lanes>(&self) -> Self::InLanes<L> {
        self.system.in_every_lane()
    }

    fn put_in_lane<L: Lanes>(&self, lane: usize, lanes: &mut Self::InLanes<L>) {
        self.system.put_in_lane(lane, lanes);
    }

    #[inline(always)]
    fn rhs_in_lanes<L: Lanes>(
        lanes: &Self::InLanes<L>,
        t: L,
        x: &[L],
        d: &[L],
        u: &[L],
        dx: &mut [L],
    ) {
        S::rhs_in_lanes(lanes, t, x, d, u, dx);
    }

    #[inline(always)]
    fn accept_in_lanes<L: Lanes>(lanes: &Self::InLanes<L>, t: L, x: &[L], u: &[L], d: &mut [L]) {
        S::accept_in_lanes(lanes, t, x, u, d);
    }

    #[inline(always)]
    fn events_in_lanes<L: Lanes>(
        lanes: &Self::InLanes<L>,
        t: L,
        x: &[L],
        d: &[L],
        u: &[L],
        values: &mut [L],
    ) {
        S::events_in_lanes(lanes, t, x, d, u, values);
    }

    #[inline(always)]
    fn closures_in_lanes<L: Lanes>(
        lanes: &Self::InLanes<L>,
        t: L,
        x: &[L],
        d: &[L],
        u: &[L],
        values: &mut [L],
    ) {
        S::closures_in_lanes(lanes, t, x, d, u, values);
    }
}
