//! Where the rows of a run go.

use std::borrow::Cow;
use std::ops::ControlFlow;

/// What stands at the head of a column.
#[derive(Clone, Debug, PartialEq)]
pub struct Heading {
    /// Name: `t`, `crank.angle`, `energy.balance`.
    pub name: Cow<'static, str>,
    /// SI unit, `1` if it has none.
    pub unit: Cow<'static, str>,
    /// What it is.
    pub meaning: Cow<'static, str>,
}

/// Takes the rows of a run as they come, and is told how far it is.
///
/// Either function may break the run off; it then ends as
/// [`Ending::Interrupted`](super::Ending::Interrupted). A recorder that can fail keeps its own error.
pub trait Recorder {
    /// The columns of the rows to come: time, every state, every output, energies if asked for.
    fn begin(&mut self, _columns: &[Heading]) {}

    /// One row. Times never fall; two rows of one time stand before and after an event.
    fn row(&mut self, values: &[f64]) -> ControlFlow<()>;

    /// The run has come to this time. Called every few thousand steps at the least, whether rows
    /// come or not.
    fn progress(&mut self, _time: f64) -> ControlFlow<()> {
        ControlFlow::Continue(())
    }
}
