//! `flexure sensitivity`: what params do to an actuator's mean speed in its linear regime.

use std::fmt::Write as _;
use std::path::PathBuf;

use clap::Args;
use flexure::Design;
use flexure::picture::{number, with_unit};
use flexure::response::{
    DEFINITIONS, Definition, Effect, LinearRegime, Outcome, Step, Variation, linear_regime,
    sensitivity, share,
};
use flexure::runtime::diagnostic::Diagnostic;

use super::actuator::{Actuation, Actuator};
use super::columns::columns;
use super::terminal::Terminal;
use super::{Failure, csv, print};

/// What params do to the mean speed in the linear regime
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  flexure sensitivity models/double_rocker.flex --frequency f=100Hz..2000Hz:100Hz --speed stage.v --param Fp --param mu_s+mu_c
  flexure sensitivity models/double_rocker.flex --frequency f --speed stage.v --param ku:-20% --param beta1+beta2+beta3:5deg -o s.csv

Each param, or params joined by `+`, is changed by --step of its value, or by its own step behind a
colon; a param that is zero needs a step in its unit. S_p is the relative change of the mean speed in
the linear regime over the relative change of the param: of 1 if the speed grows by 10 % with 10 %
more of the param. It is given with each design in its own linear regime, and with both in that of
the nominal design.")]
pub struct Arguments {
    #[command(flatten)]
    actuation: Actuation,
    /// Param to change, or params to change together: `Fp`, `mu_s+mu_c:5%`, `beta1+beta2:5deg`
    #[arg(long, value_name = "PARAM[:STEP]", required = true)]
    param: Vec<String>,
    /// Change of params that have no step of their own
    #[arg(
        long,
        value_name = "SHARE",
        allow_hyphen_values = true,
        default_value = "10%"
    )]
    step: String,
    /// File for the table of results
    #[arg(short, long, value_name = "OUT.csv")]
    output: Option<PathBuf>,
}

/// Does it.
///
/// # Errors
///
/// If the call does not fit the model, the model or a changed one is wrong, or a file cannot be
/// written. Points that fail are left out of linear regimes and said.
pub fn run(arguments: &Arguments, terminal: &Terminal) -> Result<(), Failure> {
    let actuation = &arguments.actuation;
    let actuator = actuation.choose(terminal)?;
    let (variations, designs) = varied(arguments, &actuator).map_err(Failure::setting)?;
    let table = actuation.open(arguments.output.as_deref())?;
    let bar = terminal.progress();
    let all = actuation.drive(&actuator, &designs, &actuator.frequencies, &bar, None);
    bar.finish_and_clear();
    let study = Study {
        arguments,
        actuator: &actuator,
        variations: &variations,
        outcomes: &all,
    };
    print(|out| out.write_all(study.report().as_bytes()))?;
    study.say_failures(terminal);
    if let Some(table) = table {
        table.finish_with(&study.table(), terminal)?;
    }
    Ok(())
}

/// What is changed, and the designs: the nominal one, then one for each change.
fn varied(
    arguments: &Arguments,
    actuator: &Actuator,
) -> Result<(Vec<Variation>, Vec<Design>), Diagnostic> {
    let usual = share(&arguments.step)?;
    let mut variations = Vec::new();
    let mut designs = vec![actuator.chosen.design.clone()];
    for written in &arguments.param {
        let variation = Variation::parse(written, usual, actuator.model())?;
        if variation.params.contains(&actuator.frequency) {
            return Err(Diagnostic::error(format!(
                "`{}` is the drive's frequency, against which speeds are taken",
                actuator.frequency
            )));
        }
        designs.push(variation.apply(&actuator.chosen.design)?);
        variations.push(variation);
    }
    Ok((variations, designs))
}

/// Everything that was found.
struct Study<'a> {
    arguments: &'a Arguments,
    actuator: &'a Actuator,
    variations: &'a [Variation],
    /// Of the nominal design first.
    outcomes: &'a [Vec<Outcome>],
}

impl Study<'_> {
    fn curve(&self, design: usize) -> Vec<(f64, f64)> {
        Actuator::curve(&self.actuator.frequencies, &self.outcomes[design])
    }

    /// What a change does, by a definition of the linear regime.
    fn effect(&self, variation: usize, definition: &Definition) -> Option<Effect> {
        Effect::of(&self.curve(0), &self.curve(variation + 1), definition)
    }

    /// The step of a change: a share, or as it was written.
    fn step(&self, index: usize) -> String {
        let signed = |text: &str| match text.starts_with(['−', '-', '+']) {
            true => text.to_owned(),
            false => format!("+{text}"),
        };
        let written = self.arguments.param[index].split_once(':');
        match (self.variations[index].step, written) {
            (Step::Absolute(_), Some((_, step))) => signed(step.trim()),
            (Step::Share(step) | Step::Absolute(step), _) => {
                format!("{} %", signed(&number(100.0 * step, 6)))
            }
        }
    }

    /// What a person reads.
    fn report(&self) -> String {
        let cycles = self.arguments.actuation.measured();
        let end = u64::from(cycles.warmup) + u64::from(cycles.measured);
        let frequencies = &self.actuator.frequencies;
        let hertz = |f: Option<&f64>| with_unit(f.copied().unwrap_or(f64::NAN), "Hz", 6);
        let mut text = format!(
            "{}\nover cycles {} to {end}, at {} frequencies from {} to {}\n",
            self.actuator.speed_words,
            cycles.warmup,
            frequencies.len(),
            hertz(frequencies.first()),
            hertz(frequencies.last()),
        );
        for definition in &DEFINITIONS {
            let nominal = linear_regime(&self.curve(0), definition);
            let _ = match &nominal {
                Some(found) => writeln!(
                    text,
                    "\nlinear regime: {}; nominal {}, mean speed {}",
                    definition.name,
                    window(found),
                    self.speed(found.mean_speed)
                ),
                None => writeln!(
                    text,
                    "\nlinear regime: {}; the nominal design has none",
                    definition.name
                ),
            };
            if nominal.is_some() {
                text.push_str(&self.effects(definition));
            }
        }
        text
    }

    fn effects(&self, definition: &Definition) -> String {
        let headings = [
            "param",
            "step",
            "its own window",
            "mean speed",
            "change",
            "S_p",
            "in the nominal window",
            "change",
            "S_p",
        ];
        let headings: Vec<String> = headings.iter().map(|h| (*h).to_owned()).collect();
        let none = || "–".to_owned();
        let percent = |change: Option<f64>| {
            change.map_or_else(none, |change| format!("{} %", number(100.0 * change, 4)))
        };
        let rows = self
            .variations
            .iter()
            .enumerate()
            .map(|(index, variation)| {
                let mut row = vec![variation.name(), self.step(index)];
                let Some(effect) = self.effect(index, definition) else {
                    return row;
                };
                let s = |change: Option<f64>| {
                    let found = change.and_then(|change| sensitivity(change, variation.step));
                    found.map_or_else(none, |s| number(s, 4))
                };
                row.extend([
                    effect.changed.as_ref().map_or("none".to_owned(), window),
                    effect
                        .changed
                        .map_or_else(none, |found| self.speed(found.mean_speed)),
                    percent(effect.change()),
                    s(effect.change()),
                    effect
                        .speed_in_nominal_window
                        .map_or_else(none, |speed| self.speed(speed)),
                    percent(effect.change_in_nominal_window()),
                    s(effect.change_in_nominal_window()),
                ]);
                row
            });
        columns(&headings, &rows.collect::<Vec<_>>())
    }

    fn speed(&self, value: f64) -> String {
        with_unit(value, &self.actuator.speed_unit, 5)
    }

    /// The results as a table of comma-separated values: a row for each change and definition.
    fn table(&self) -> String {
        let mut text = String::new();
        let names = [
            "param",
            "step",
            "relative",
            "linear_regime",
            "nominal_from",
            "nominal_to",
            "nominal_speed",
            "from",
            "to",
            "speed",
            "change",
            "sensitivity",
            "speed_in_nominal_window",
            "change_in_nominal_window",
            "sensitivity_in_nominal_window",
        ];
        csv::push_header(&mut text, names.into_iter());
        for (index, variation) in self.variations.iter().enumerate() {
            let (step, is_relative) = match variation.step {
                Step::Share(share) => (share, "yes"),
                Step::Absolute(step) => (step, "no"),
            };
            for definition in &DEFINITIONS {
                let effect = self.effect(index, definition);
                let cell = |value: Option<f64>| value.map_or(String::new(), csv::number);
                let nominal = effect.map(|effect| effect.nominal);
                let changed = effect.and_then(|effect| effect.changed);
                let own = effect.and_then(|effect| effect.change());
                let fixed = effect.and_then(|effect| effect.change_in_nominal_window());
                let s =
                    |change: Option<f64>| cell(change.and_then(|c| sensitivity(c, variation.step)));
                let mut fields = vec![
                    variation.name(),
                    csv::number(step),
                    is_relative.to_owned(),
                    definition.name.to_owned(),
                ];
                fields.extend([
                    cell(nominal.map(|found| found.from)),
                    cell(nominal.map(|found| found.to)),
                    cell(nominal.map(|found| found.mean_speed)),
                    cell(changed.map(|found| found.from)),
                    cell(changed.map(|found| found.to)),
                    cell(changed.map(|found| found.mean_speed)),
                    cell(own),
                    s(own),
                    cell(effect.and_then(|effect| effect.speed_in_nominal_window)),
                    cell(fixed),
                    s(fixed),
                ]);
                csv::push_fields(&mut text, &fields);
            }
        }
        text
    }

    fn say_failures(&self, terminal: &Terminal) {
        let nominal = std::iter::once("the nominal design".to_owned());
        let changed = self
            .variations
            .iter()
            .enumerate()
            .map(|(index, v)| format!("{} {}", v.name(), self.step(index)));
        for (name, outcomes) in nominal.chain(changed).zip(self.outcomes) {
            let mut failed = outcomes.iter().filter_map(|outcome| outcome.as_ref().err());
            if let Some(why) = failed.next() {
                terminal.note(format_args!(
                    "{} of {} points of {name} failed: {}",
                    1 + failed.count(),
                    outcomes.len(),
                    why.message
                ));
            }
        }
    }
}

fn window(found: &LinearRegime) -> String {
    let hertz = |f| with_unit(f, "Hz", 6);
    format!("{} to {}", hertz(found.from), hertz(found.to))
}
