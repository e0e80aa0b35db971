//! A mechanism as derived and in absolute coordinates with Lagrange multipliers, brought to the same
//! states, and a count of how they compare.

use super::Compiled;
use super::multipliers::{Assembly, Mechanism, Surroundings};
use super::oracle::Prepared;
use super::random::Random;

/// How a comparison of many states went.
#[derive(Debug, Default)]
pub struct Tally {
    /// States that were reached.
    pub states: usize,
    /// The accelerations' terms cancel, or the bordered system is ill-conditioned.
    pub rejected: usize,
    /// The path to the state meets a dead point.
    pub unreachable: usize,
    /// Worst relative error.
    pub worst: f64,
    /// Greatest condition number of those compared.
    pub condition: f64,
}

impl Tally {
    /// Counts what another has compared as well.
    pub fn join(&mut self, other: &Tally) {
        self.states += other.states;
        self.rejected += other.rejected;
        self.unreachable += other.unreachable;
        self.worst = self.worst.max(other.worst);
        self.condition = self.condition.max(other.condition);
    }
}

/// A random state, by the states' names and units.
pub fn random_state(
    compiled: &Compiled,
    start: &[f64],
    random: &mut Random,
    turn: f64,
) -> Vec<f64> {
    let states = &compiled.oracle.equations.states;
    states
        .iter()
        .zip(start)
        .map(|(state, start)| match state.unit.as_str() {
            "rad" => start + random.between(-turn, turn),
            "rad/s" => random.between(-100.0, 100.0),
            "m" if state.name.ends_with(".z") => random.between(-1e-6, 1e-6),
            "m" => start + random.between(-1e-4, 1e-4),
            "m/s" => random.between(-0.5, 0.5),
            unit => panic!("a state in `{unit}`"),
        })
        .collect()
}

/// One mechanism in both formulations, to be brought to one state.
pub struct Twin<'a> {
    compiled: &'a Compiled,
    /// In absolute coordinates.
    pub mechanism: Mechanism<'a>,
    /// Where that is assembled.
    pub assembly: Assembly,
    /// As derived.
    pub prepared: Prepared<'a>,
}

impl<'a> Twin<'a> {
    /// With params for the derived equations, and the same with all guesses as they are where the
    /// mechanism closes, for the independent formulation, which then cannot go to another branch.
    pub fn new(compiled: &'a Compiled, params: &[f64], closed: &[f64]) -> Result<Self, String> {
        let mechanism = Mechanism::new(&compiled.model, closed);
        let bodies: Vec<usize> = compiled.coordinates().iter().map(|c| c.0).collect();
        let assembly = mechanism.assemble(&bodies)?;
        let prepared = compiled.oracle.prepare(params)?;
        let twin = Self {
            compiled,
            mechanism,
            assembly,
            prepared,
        };
        let closed = twin.mechanism.assembled_values(&twin.assembly);
        for ((_, value, _), closed) in compiled.coordinates().iter().zip(closed) {
            let start = twin.prepared.start[*value];
            let turns = (start - closed) / std::f64::consts::TAU;
            let off = if compiled.oracle.equations.states[*value].unit == "rad" {
                (turns - turns.round()).abs()
            } else {
                (start - closed).abs()
            };
            if off > 1e-9 {
                return Err(format!("assembled at {start}, independently at {closed}"));
            }
        }
        Ok(twin)
    }

    /// Positions and velocities in absolute coordinates; an error where the path there meets a dead
    /// point.
    pub fn absolute(&self, state: &[f64]) -> Result<(Vec<f64>, Vec<f64>), String> {
        let coordinates = self.compiled.coordinates();
        let closed = self.mechanism.assembled_values(&self.assembly);
        // Both count angles from the assembled configuration: a difference of whole turns is none.
        let values: Vec<f64> = coordinates
            .iter()
            .zip(&closed)
            .map(|((_, value, _), closed)| closed + state[*value] - self.prepared.start[*value])
            .collect();
        let rates: Vec<f64> = coordinates
            .iter()
            .map(|(_, _, rate)| state[*rate])
            .collect();
        let q = self.mechanism.configuration(&self.assembly, &values)?;
        let v = self.mechanism.velocities(&self.assembly, &q, &rates)?;
        Ok((q, v))
    }

    /// What the absolute formulation needs to know besides.
    pub fn surroundings(&self, time: f64, state: &[f64]) -> Surroundings {
        let equations = &self.compiled.oracle.equations;
        let memory = equations.discretes.iter().zip(&self.prepared.discretes);
        Surroundings {
            time,
            inputs: Vec::new(),
            memory: memory.map(|(d, value)| (d.name.clone(), *value)).collect(),
            bristles: self.compiled.bristles().iter().map(|&z| state[z]).collect(),
        }
    }

    /// Compares all accelerations at one state; states with a greater condition number than
    /// `most_condition` are counted and left out, because the reference loses digits there.
    pub fn compare(
        &mut self,
        time: f64,
        state: &[f64],
        most_condition: f64,
        tally: &mut Tally,
    ) -> Result<(), String> {
        let Ok((q, v)) = self.absolute(state) else {
            tally.unreachable += 1;
            return Ok(());
        };
        self.prepared.follow(time, state);
        self.prepared.settle();
        let surroundings = self.surroundings(time, state);
        let motion = self
            .mechanism
            .accelerations(&self.assembly, &surroundings, &q, &v)?;
        let rates = self.prepared.rates();
        tally.states += 1;
        if motion.condition > most_condition {
            tally.rejected += 1;
            return Ok(());
        }
        let mut rejected = false;
        let mut worst: f64 = 0.0;
        for (index, (_, _, rate)) in self.compiled.coordinates().iter().enumerate() {
            let (derived, reference) = (rates[*rate], motion.coordinates[index]);
            if reference.abs() < 1e-3 * motion.magnitudes[index] {
                rejected = true;
                continue;
            }
            worst = worst.max((derived - reference).abs() / reference.abs());
            if !derived.is_finite() {
                return Err(format!("acceleration {derived}, independently {reference}"));
            }
        }
        for (z, reference) in self.compiled.bristles().iter().zip(&motion.bristle_rates) {
            let slip = rates[*z];
            // The bristle's rate is a difference of two terms: compare on the larger one's scale.
            let scale = reference.abs().max(1e-3);
            worst = worst.max((slip - reference).abs() / scale);
        }
        if rejected {
            tally.rejected += 1;
        } else {
            tally.worst = tally.worst.max(worst);
            tally.condition = tally.condition.max(motion.condition);
            if worst > 1e-9 {
                return Err(format!(
                    "differ by {worst:e} (condition {:e}): derived {:?}, independently {:?}",
                    motion.condition,
                    self.compiled
                        .coordinates()
                        .iter()
                        .map(|c| rates[c.2])
                        .collect::<Vec<f64>>(),
                    motion.coordinates
                ));
            }
        }
        Ok(())
    }
}

/// Compares accelerations at random states of one parameter set.
pub fn compare(
    compiled: &Compiled,
    changes: &[(&str, f64)],
    closed: &[(&str, f64)],
    states: usize,
    turn: f64,
    seed: u64,
) -> Result<Tally, String> {
    let params = compiled.params(changes);
    let mut twin = Twin::new(compiled, &params, &compiled.params(closed))?;
    let mut tally = Tally::default();
    let mut random = Random::new(seed);
    let start = twin.prepared.start.clone();
    for _ in 0..states {
        let state = random_state(compiled, &start, &mut random, turn);
        let time = random.between(0.0, 0.9e-3);
        twin.compare(time, &state, 1e7, &mut tally)
            .map_err(|error| format!("at t = {time}, state {state:?}: {error}"))?;
    }
    Ok(tally)
}
