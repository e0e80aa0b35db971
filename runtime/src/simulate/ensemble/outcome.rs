//! What an ensemble gives for each of its trajectories.

use std::error::Error;
use std::fmt;

use crate::diagnostic::Diagnostic;
use crate::simulate::breakdown::Breakdown;
use crate::simulate::run::Summary;
use crate::simulate::stops::Sample;

/// A trajectory that came to its end.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trajectory {
    /// How it ended, its state there, and what it cost.
    pub summary: Summary,
    /// What it was like at the times asked for.
    pub samples: Vec<Sample>,
}

/// Why there is no trajectory, or only the beginning of one.
#[derive(Clone, Debug)]
pub enum TrajectoryFailure {
    /// The parameter set was refused.
    Preparation(Diagnostic),
    /// A setting makes no sense, or the motion could not be followed to the end.
    Run {
        /// Why, when and where.
        breakdown: Box<Breakdown>,
        /// The trajectory until then.
        trajectory: Box<Trajectory>,
    },
}

impl TrajectoryFailure {
    pub(super) fn run(breakdown: Breakdown, trajectory: Trajectory) -> Self {
        Self::Run {
            breakdown: Box::new(breakdown),
            trajectory: Box::new(trajectory),
        }
    }

    /// As any other error of a model.
    pub fn diagnostic(&self) -> Diagnostic {
        match self {
            Self::Preparation(diagnostic) => diagnostic.clone(),
            Self::Run { breakdown, .. } => breakdown.diagnostic(),
        }
    }
}

impl fmt::Display for TrajectoryFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.diagnostic().fmt(f)
    }
}

impl Error for TrajectoryFailure {}
