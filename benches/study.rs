//! What is asked of an implementation of the article's actuator, and what it answers.

use flexure_models::double_rocker::Params;

/// How time is stepped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Method {
    /// The classical Runge–Kutta method in equal steps no longer than this, in s.
    Equal(f64),
    /// Steps of the implementation's own choice with this tolerance.
    Adaptive(f64),
}

impl Method {
    /// The step or the tolerance.
    pub fn setting(self) -> f64 {
        match self {
            Method::Equal(setting) | Method::Adaptive(setting) => setting,
        }
    }
}

/// A set of runs of the actuator.
#[derive(Clone, Debug)]
pub struct Study {
    /// A parameter set for each run.
    pub designs: Vec<Params>,
    /// How time is stepped.
    pub method: Method,
    /// When the stage's position is noted, in s or periods.
    pub from: f64,
    /// When runs end.
    pub until: f64,
    /// Whether these are periods of the drive.
    pub in_cycles: bool,
    /// How many threads may share the runs.
    pub threads: usize,
}

impl Study {
    /// Times in s for a design.
    pub fn times(&self, design: &Params) -> (f64, f64) {
        let unit = if self.in_cycles { 1.0 / design.f } else { 1.0 };
        (self.from * unit, self.until * unit)
    }

    /// The same, stepped differently.
    pub fn with(&self, method: Method) -> Self {
        Self {
            method,
            ..self.clone()
        }
    }
}

/// The state at the start of every run: the crank at 80°, all else zero.
pub const START: [f64; 7] = [
    80.0 / 180.0 * std::f64::consts::PI,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
    0.0,
];

/// What a run ends with.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct End {
    /// The stage's position when it was noted, in m.
    pub from: f64,
    /// The state at the end, in the order of the model's states.
    pub state: [f64; 7],
}

/// Position of `stage.x` among the states.
pub const STAGE_X: usize = 4;

impl End {
    /// The way of the stage from when it was noted to the end, in m.
    pub fn way(&self) -> f64 {
        self.state[STAGE_X] - self.from
    }
}

/// What came out of a study.
#[derive(Clone, Debug, Default)]
pub struct Outcome {
    /// Time for all runs, preparing the parameter sets included.
    pub seconds: f64,
    /// Evaluations of the right-hand side in all runs; zero where nobody counted.
    pub evaluations: u64,
    /// Memory taken at most, in bytes, where it is known.
    pub memory: Option<u64>,
    /// The end of each run.
    pub ends: Vec<End>,
}

/// The largest difference of any state at the end of any run, of the largest that this state is at the
/// end of any run: rates of single runs may be next to zero where they end. Angles are counted
/// from `start`.
pub fn difference(found: &[End], expected: &[End], start: [f64; 7]) -> f64 {
    if found.len() != expected.len() {
        return f64::INFINITY;
    }
    let mut worst = 0.0;
    for (i, start) in start.into_iter().enumerate() {
        let size = expected
            .iter()
            .map(|end| (end.state[i] - start).abs())
            .fold(0.0, larger);
        for (found, expected) in found.iter().zip(expected) {
            worst = larger(worst, (found.state[i] - expected.state[i]).abs() / size);
        }
    }
    worst
}

/// |a - b| over the larger of both; zero if both are.
pub fn relative(a: f64, b: f64) -> f64 {
    if a == b {
        return 0.0;
    }
    (a - b).abs() / a.abs().max(b.abs())
}

/// The larger; not a number if one is not.
pub fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::NAN
    } else {
        a.max(b)
    }
}
