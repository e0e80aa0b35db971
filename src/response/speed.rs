//! A speed as a quantity of a model, and how its mean over cycles of the drive is taken.
//!
//! Where the speed is the rate of a state or of an output its mean is exact: what that quantity
//! advances by, over the time. Whether it is the rate of one is found by evaluation: at several
//! configurations and motions near the start the speed must be what the quantity changes by per
//! time along the motion. Otherwise the speed is sampled.

use flexure_runtime::diagnostic::Diagnostic;
use flexure_runtime::simulate::Sample;
use flexure_runtime::system::{System, Variable};

use flexure_model_dsl::suggest::closest;

/// A quantity that samples of a trajectory have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// A state, by its position.
    State(usize),
    /// An output, by its position.
    Output(usize),
}

impl Quantity {
    /// The quantity of that name: an output, or else a state.
    ///
    /// # Errors
    ///
    /// If the model has no such output or state; the hint names the one that may be meant.
    pub fn named<S: System>(name: &str, system: &S) -> Result<Self, Diagnostic> {
        let position = |rows: &[Variable]| rows.iter().position(|row| row.name == name);
        let (outputs, states) = (system.output_variables(), system.states());
        if let Some(index) = position(outputs) {
            return Ok(Self::Output(index));
        }
        if let Some(index) = position(states) {
            return Ok(Self::State(index));
        }
        let names: Vec<&str> = outputs.iter().chain(states).map(|row| &*row.name).collect();
        let error = Diagnostic::error(format!("the model has no output or state `{name}`"));
        Err(error.hint(match closest(name, names.iter().copied()) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!(
                "it has {}; any measure is one by a line `output {} = …`",
                names.join(", "),
                name.replace('.', "_")
            ),
        }))
    }

    /// Name and unit of the quantity.
    pub fn variable<S: System>(self, system: &S) -> &Variable {
        match self {
            Self::State(index) => &system.states()[index],
            Self::Output(index) => &system.output_variables()[index],
        }
    }

    pub(super) fn of(self, sample: &Sample) -> f64 {
        let value = match self {
            Self::State(index) => sample.state.get(index),
            Self::Output(index) => sample.outputs.get(index),
        };
        value.copied().unwrap_or(f64::NAN)
    }
}

/// How the mean of a speed is taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Speed {
    /// The speed is the rate of this quantity: its mean is exact.
    RateOf(Quantity),
    /// The speed is sampled: its mean is that of [`SAMPLES`] values a cycle, by the trapezoidal
    /// rule. What changes between two samples is missed.
    Sampled(Quantity),
}

/// Samples a cycle of a speed that is not known as a rate.
pub const SAMPLES: u32 = 100;

impl Speed {
    /// How the mean of `quantity` is taken.
    pub fn of<S: System>(quantity: Quantity, system: &S) -> Self {
        let states = (0..system.states().len()).map(Quantity::State);
        let outputs = (0..system.output_variables().len()).map(Quantity::Output);
        let probes = probes(system);
        let is_rate = |&candidate: &Quantity| {
            candidate != quantity
                && probes
                    .iter()
                    .all(|probe| probe.is_rate(system, quantity, candidate))
        };
        let found = states.chain(outputs).find(is_rate);
        match found.filter(|_| probes.iter().any(|p| p.value(system, quantity) != 0.0)) {
            Some(integral) => Self::RateOf(integral),
            None => Self::Sampled(quantity),
        }
    }

    /// How the mean is taken, in words, for the name of the speed.
    pub fn described<S: System>(self, name: &str, system: &S) -> String {
        match self {
            Self::RateOf(quantity) => format!(
                "mean of `{name}`: what `{}` advances by, whose rate it is",
                quantity.variable(system).name
            ),
            Self::Sampled(_) => format!(
                "mean of `{name}`: by {SAMPLES} samples a cycle, as it is the rate of no state or output"
            ),
        }
    }
}

/// States whose value no rate of a state depends on, such as the position of a slider on a rail:
/// their columns of the Jacobian vanish at several states near the start.
pub(super) fn advancing<S: System>(system: &S) -> Vec<bool> {
    let size = system.states().len();
    let mut advancing = vec![true; size];
    let mut jacobian = vec![0.0; size * size];
    for probe in probes(system) {
        system.jacobian(probe.time, &probe.x, &probe.d, &probe.u, &mut jacobian);
        for (index, entry) in jacobian.iter().enumerate() {
            advancing[index % size] &= *entry == 0.0;
        }
    }
    advancing
}

/// States near the start at which functions are compared.
const PROBES: usize = 6;

/// Half of the time in s over which rates of outputs are taken.
const INSTANT: f64 = 1e-6;

/// Rates that differ by less than this, as a share, are the same.
const SAME: f64 = 1e-6;

struct Probe {
    time: f64,
    x: Vec<f64>,
    d: Vec<f64>,
    u: Vec<f64>,
    dx: Vec<f64>,
}

/// States scattered about the start, always the same ones.
fn probes<S: System>(system: &S) -> Vec<Probe> {
    let (states, discretes) = (system.states(), system.discretes());
    let u: Vec<f64> = system
        .inputs()
        .iter()
        .map(|u| u.start.unwrap_or(0.0))
        .collect();
    let mut x = vec![0.0; states.len()];
    let mut d = vec![0.0; discretes.len()];
    system.start(&mut x, &mut d);
    (1..=PROBES)
        .map(|probe| {
            let mut x = x.clone();
            for (index, (value, state)) in x.iter_mut().zip(states).enumerate() {
                // Multiples of the golden ratio scatter evenly.
                let turns = (probe * states.len() + index) as f64 * 0.618_033_988_749_895;
                *value += (2.0 * turns.fract() - 1.0) * excursion(&state.unit);
            }
            let mut dx = vec![0.0; states.len()];
            let time = probe as f64 * 3.0 * INSTANT;
            system.rhs(time, &x, &d, &u, &mut dx);
            Probe {
                time,
                x,
                d: d.clone(),
                u: u.clone(),
                dx,
            }
        })
        .collect()
}

/// How far states are led from the start, by their unit: so little that loops stay closed.
fn excursion(unit: &str) -> f64 {
    match unit {
        "rad" => 1e-4,
        "m" => 1e-6,
        "rad/s" => 1.0,
        "m/s" => 1e-2,
        _ => 1e-3,
    }
}

impl Probe {
    fn value<S: System>(&self, system: &S, quantity: Quantity) -> f64 {
        self.value_at(system, quantity, self.time, &self.x)
    }

    fn value_at<S: System>(&self, system: &S, quantity: Quantity, t: f64, x: &[f64]) -> f64 {
        match quantity {
            Quantity::State(index) => x[index],
            Quantity::Output(index) => {
                let mut out = vec![0.0; system.output_variables().len()];
                system.outputs(t, x, &self.d, &self.u, &mut out);
                out[index]
            }
        }
    }

    /// Whether `candidate` changes by `speed` per time along the motion.
    fn is_rate<S: System>(&self, system: &S, speed: Quantity, candidate: Quantity) -> bool {
        let speed = self.value(system, speed);
        let rate = match candidate {
            Quantity::State(index) => self.dx[index],
            Quantity::Output(_) => {
                let at = |dt: f64| {
                    let moved = self.x.iter().zip(&self.dx).map(|(x, dx)| x + dt * dx);
                    let moved: Vec<f64> = moved.collect();
                    self.value_at(system, candidate, self.time + dt, &moved)
                };
                (at(INSTANT) - at(-INSTANT)) / (2.0 * INSTANT)
            }
        };
        (rate - speed).abs() <= SAME * speed.abs()
    }
}
