//! Bodies in groups that joints or forces hold together.

use crate::model::BodyId;

/// Bodies in groups, each led by its first in the file.
#[derive(Clone)]
pub(crate) struct Groups(Vec<BodyId>);

impl Groups {
    /// Every body by itself.
    pub fn new(bodies: usize) -> Self {
        Self((0..bodies).collect())
    }

    /// The first body of the group that `body` is in.
    pub fn lead(&self, body: BodyId) -> BodyId {
        let mut lead = body;
        while self.0[lead] != lead {
            lead = self.0[lead];
        }
        lead
    }

    /// Makes one group of those of two bodies.
    pub fn join(&mut self, a: BodyId, b: BodyId) {
        let (a, b) = (self.lead(a), self.lead(b));
        self.0[a.max(b)] = a.min(b);
    }
}
