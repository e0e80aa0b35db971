//! Measures: a state or an output over the window of a run, in one number.
//!
//! With samples at evenly spaced times t₀ … tₙ, both ends of the window included, and a position x
//! at the starts c₀ … c_N of its cycles:
//!
//! | measure | meaning |
//! |---|---|
//! | `mean(q)` | mean over time. Where q is the rate of a state x, (x(tₙ) − x(t₀)) / (tₙ − t₀) exactly; else by the trapezoidal rule |
//! | `rms(q)` | root of the mean square over time, of the line through the samples |
//! | `min(q)`, `max(q)` | least and greatest sample |
//! | `peak(q)` | greatest magnitude of a sample |
//! | `peak_to_peak(q)` | greatest sample less the least |
//! | `first(q)`, `last(q)` | value at the start and at the end of the window |
//! | `step(x)` | advance per cycle: (c_N − c₀) / N |
//! | `back_slip(x)` | within a cycle, the largest retreat from a sample to a later one, against the direction of c_N − c₀; mean over cycles |
//! | `overshoot(x)` | within a cycle, how far x goes beyond the cycle's end in that direction; mean over cycles |
//! | `settling(x)` | within a cycle, the time from its start until x stays within 5 % of that cycle's step from its end; mean over cycles, in s |

use flexure_model_dsl::suggest::closest;
use flexure_runtime::diagnostic::Diagnostic;
use flexure_runtime::simulate::Sample;

use crate::Model;

/// A state or an output, reduced to one number.
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    name: String,
    unit: String,
    reduction: Reduction,
    quantity: Quantity,
    /// The state whose rate the quantity is, if it is one.
    integral: Option<usize>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Reduction {
    Mean,
    Rms,
    Min,
    Max,
    Peak,
    PeakToPeak,
    First,
    Last,
    Step,
    BackSlip,
    Overshoot,
    Settling,
}

const REDUCTIONS: [(&str, Reduction); 12] = [
    ("mean", Reduction::Mean),
    ("rms", Reduction::Rms),
    ("min", Reduction::Min),
    ("max", Reduction::Max),
    ("peak", Reduction::Peak),
    ("peak_to_peak", Reduction::PeakToPeak),
    ("first", Reduction::First),
    ("last", Reduction::Last),
    ("step", Reduction::Step),
    ("back_slip", Reduction::BackSlip),
    ("overshoot", Reduction::Overshoot),
    ("settling", Reduction::Settling),
];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Quantity {
    State(usize),
    Output(usize),
}

/// Share of a cycle's step within which it counts as settled.
const SETTLED: f64 = 0.05;

impl Measure {
    /// Reads `mean(stage.v)`: a reduction, and a state or an output of the model.
    ///
    /// # Errors
    ///
    /// If there is no such reduction or quantity; hints name what may be meant.
    pub fn parse(model: &Model, written: &str) -> Result<Self, Diagnostic> {
        let inner = written.trim().strip_suffix(')');
        let Some((word, name)) = inner.and_then(|inner| inner.split_once('(')) else {
            return Err(Diagnostic::error(format!("`{written}` is no measure"))
                .hint("write a reduction of a state or an output: `mean(stage.v)`"));
        };
        let (word, name) = (word.trim(), name.trim());
        let known = REDUCTIONS.iter().find(|(known, _)| *known == word);
        let Some(&(word, reduction)) = known else {
            let names = REDUCTIONS.iter().map(|(known, _)| *known);
            let error = Diagnostic::error(format!("there is no reduction `{word}`"));
            return Err(error.hint(match closest(word, names.clone()) {
                Some(near) => format!("did you mean `{near}({name})`?"),
                None => format!("there are {}", names.collect::<Vec<_>>().join(", ")),
            }));
        };
        let (quantity, unit) = find(model, name)?;
        Ok(Self {
            name: format!("{word}({name})"),
            unit: match reduction {
                Reduction::Settling => "s".to_owned(),
                _ => unit,
            },
            reduction,
            quantity,
            integral: integral(model, quantity),
        })
    }

    /// Its name, which heads a column: `mean(stage.v)`.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its SI unit.
    pub fn unit(&self) -> &str {
        &self.unit
    }

    /// Whether it is one of cycles.
    pub fn needs_cycles(&self) -> bool {
        matches!(
            self.reduction,
            Reduction::Step | Reduction::BackSlip | Reduction::Overshoot | Reduction::Settling
        )
    }

    /// Whether it needs samples between the ends of the window.
    pub(super) fn needs_samples(&self) -> bool {
        match self.reduction {
            Reduction::Mean => self.integral.is_none(),
            Reduction::First | Reduction::Last | Reduction::Step => false,
            _ => true,
        }
    }

    /// Its value of samples over a window of so many cycles, as many samples in each; not a number
    /// where there is none.
    pub(super) fn of(&self, samples: &[Sample], cycles: usize) -> f64 {
        let (Some(first), Some(last)) = (samples.first(), samples.last()) else {
            return f64::NAN;
        };
        let span = last.time - first.time;
        let value = |sample: &Sample| match self.quantity {
            Quantity::State(index) => sample.state[index],
            Quantity::Output(index) => sample.outputs[index],
        };
        if let (Reduction::Mean, Some(index)) = (self.reduction, self.integral) {
            return if span > 0.0 {
                (last.state[index] - first.state[index]) / span
            } else {
                value(last)
            };
        }
        let values: Vec<f64> = samples.iter().map(value).collect();
        let mean_of = |of: fn(f64, f64) -> f64| {
            let pairs = samples.windows(2).zip(values.windows(2));
            let parts = pairs.map(|(s, v)| (s[1].time - s[0].time) * of(v[0], v[1]));
            if span > 0.0 {
                parts.sum::<f64>() / span
            } else {
                of(values[0], values[0])
            }
        };
        let least = || values.iter().copied().fold(f64::INFINITY, f64::min);
        let greatest = || values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        match self.reduction {
            Reduction::Mean => mean_of(|a, b| 0.5 * (a + b)),
            Reduction::Rms => mean_of(|a, b| (a * a + a * b + b * b) / 3.0).sqrt(),
            Reduction::Min => least(),
            Reduction::Max => greatest(),
            Reduction::Peak => greatest().max(-least()),
            Reduction::PeakToPeak => greatest() - least(),
            Reduction::First => value(first),
            Reduction::Last => value(last),
            Reduction::Step => (value(last) - value(first)) / cycles as f64,
            Reduction::BackSlip => cycle_mean(&values, cycles, back_slip),
            Reduction::Overshoot => cycle_mean(&values, cycles, overshoot),
            Reduction::Settling => {
                let period = span / cycles as f64;
                period * cycle_mean(&values, cycles, |cycle, _| settling(cycle))
            }
        }
    }
}

/// Mean over cycles of what `of` makes of each, given the direction of the whole motion.
fn cycle_mean(values: &[f64], cycles: usize, of: impl Fn(&[f64], f64) -> f64) -> f64 {
    let per_cycle = (values.len() - 1).checked_div(cycles).unwrap_or(0);
    if per_cycle == 0 {
        return f64::NAN;
    }
    let forward = if values[values.len() - 1] < values[0] {
        -1.0
    } else {
        1.0
    };
    let each = (0..cycles).map(|k| of(&values[k * per_cycle..=(k + 1) * per_cycle], forward));
    each.sum::<f64>() / cycles as f64
}

fn back_slip(cycle: &[f64], forward: f64) -> f64 {
    let mut foremost = f64::NEG_INFINITY;
    let mut largest = 0.0_f64;
    for value in cycle {
        foremost = foremost.max(forward * value);
        largest = largest.max(foremost - forward * value);
    }
    largest
}

fn overshoot(cycle: &[f64], forward: f64) -> f64 {
    let end = forward * cycle[cycle.len() - 1];
    cycle
        .iter()
        .fold(0.0, |most, value| most.max(forward * value - end))
}

/// Share of the cycle that is over when it settles.
fn settling(cycle: &[f64]) -> f64 {
    let end = cycle[cycle.len() - 1];
    let band = SETTLED * (end - cycle[0]).abs();
    let outside = cycle.iter().rposition(|value| (value - end).abs() > band);
    outside.map_or(0, |last| last + 1) as f64 / (cycle.len() - 1) as f64
}

fn find(model: &Model, name: &str) -> Result<(Quantity, String), Diagnostic> {
    let equations = model.equations();
    let (states, outputs) = (&equations.states, &equations.outputs);
    if let Some(index) = outputs.iter().position(|output| output.name == name) {
        return Ok((Quantity::Output(index), outputs[index].unit.clone()));
    }
    if let Some(index) = states.iter().position(|state| state.name == name) {
        return Ok((Quantity::State(index), states[index].unit.clone()));
    }
    let names = states.iter().map(|state| state.name.as_str());
    let names: Vec<&str> = names
        .chain(outputs.iter().map(|o| o.name.as_str()))
        .collect();
    let error = Diagnostic::error(format!(
        "model `{}` has no state or output `{name}`",
        model.name()
    ));
    Err(error.hint(match closest(name, names.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None => format!("it has {}", names.join(", ")),
    }))
}

/// The state whose rate a quantity is.
fn integral(model: &Model, quantity: Quantity) -> Option<usize> {
    let equations = model.equations();
    let symbol = match quantity {
        Quantity::State(index) => equations.states[index].symbol,
        Quantity::Output(index) => equations.graph.as_symbol(equations.outputs[index].value)?,
    };
    let rates = equations.states.iter().map(|state| state.rate);
    rates
        .map(|rate| equations.graph.as_symbol(rate))
        .position(|rate| rate == Some(symbol))
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODEL: &str = "model m\nparam f = 1 kHz\n\
        drive xp = sawtooth(1 um, frequency = f, rise = 0.9)\n\
        slide s along (1, 0) { mass = 1 kg }\n\
        spring k between ground and s { stiffness = 1 N/m, expansion = xp }\n\
        output speed = s.v\noutput double = 2 * s.v\n";

    fn measure(written: &str) -> Measure {
        Measure::parse(&Model::from_source("m.flex", MODEL).unwrap(), written).unwrap()
    }

    /// Samples of a position, four a cycle of 1 s; the velocity is a ramp.
    fn samples(positions: &[f64]) -> Vec<Sample> {
        let each = positions.iter().enumerate();
        each.map(|(k, &x)| Sample {
            time: 0.25 * k as f64,
            state: vec![x, k as f64],
            outputs: vec![k as f64, 2.0 * k as f64],
        })
        .collect()
    }

    #[test]
    fn values_are_those_of_their_definitions() {
        let samples = samples(&[0.0, 2.0, 6.0, 5.0, 4.0, 5.0, 9.0, 7.0, 8.0]);
        for (written, expected) in [
            ("mean(s.v)", 8.0 / 2.0),
            ("mean(speed)", 8.0 / 2.0),
            ("mean(double)", 8.0),
            ("mean(s.x)", (0.0 + 8.0 + 2.0 * 38.0) / 16.0),
            ("min(s.x)", 0.0),
            ("max(s.x)", 9.0),
            ("peak_to_peak(s.x)", 9.0),
            ("first(s.v)", 0.0),
            ("last(s.x)", 8.0),
            ("step(s.x)", 4.0),
            ("back_slip(s.x)", 2.0),
            ("overshoot(s.x)", 1.5),
            ("settling(s.x)", 1.0),
            ("rms(speed)", (64.0_f64 / 3.0).sqrt()),
        ] {
            let value = measure(written).of(&samples, 2);
            assert!((value - expected).abs() < 1e-12, "{written}: {value}");
        }
        let backwards: Vec<Sample> = samples
            .iter()
            .map(|sample| Sample {
                state: sample.state.iter().map(|x| -x).collect(),
                ..sample.clone()
            })
            .collect();
        for (written, expected) in [
            ("peak(s.x)", 9.0),
            ("step(s.x)", -4.0),
            ("back_slip(s.x)", 2.0),
            ("overshoot(s.x)", 1.5),
        ] {
            assert_eq!(measure(written).of(&backwards, 2), expected, "{written}");
        }
    }

    #[test]
    fn a_cycle_is_settled_when_it_stays_near_its_end() {
        assert_eq!(settling(&[0.0, 1.0, 0.9, 0.98, 1.0]), 0.75);
        assert_eq!(settling(&[1.0, 1.0, 1.0]), 0.0);
        assert!(measure("settling(s.x)").unit() == "s");
    }

    #[test]
    fn what_is_no_measure_is_refused() {
        let model = Model::from_source("m.flex", MODEL).unwrap();
        for (written, word) in [
            ("s.v", "no measure"),
            ("maen(s.v)", "did you mean `mean(s.v)`"),
            ("mean(s.w)", "has no state or output `s.w`"),
            ("mean(sped)", "did you mean `speed`"),
        ] {
            let error = Measure::parse(&model, written).unwrap_err().to_string();
            assert!(error.contains(word), "{error}");
        }
    }
}
