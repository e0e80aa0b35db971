//! A run as a picture or a page.

use flexure::codegen::report;
use flexure::model_dsl::units::Mark;
use flexure::runtime::simulate::{Breakdown, Ending, Summary};

use super::Failure;
use super::plot::page::{Page, Row, page};
use super::plot::panels::{Column, Panel, choose};
use super::plot::{figure, scale};
use super::recording::Recorded;
use super::settings::Chosen;
use super::simulate::{Arguments, Method};

/// Angles above this, in rad, are read in degrees.
const LARGE_ANGLE: f64 = 0.1;

/// Everything that a picture shows.
pub struct Portrait<'a> {
    /// How the run was asked for.
    pub arguments: &'a Arguments,
    /// Model, params, inputs.
    pub chosen: &'a Chosen,
    /// What was recorded.
    pub recorded: &'a Recorded,
    /// How the run ended.
    pub outcome: &'a Result<Summary, Breakdown>,
}

impl Portrait<'_> {
    /// The curves as SVG.
    pub fn figure(&self) -> String {
        figure::standalone(
            self.chosen.design.model().name(),
            self.time(),
            &self.panels(),
        )
    }

    /// The whole study as HTML.
    ///
    /// # Errors
    ///
    /// If the mechanism cannot be assembled.
    pub fn page(&self) -> Result<String, Failure> {
        let model = self.chosen.design.model();
        let mut assembled = self.chosen.design.assembled().map_err(Failure::model)?;
        Ok(page(&Page {
            title: model.name(),
            doc: &model.equations().doc,
            places: assembled.places(),
            facts: assembled.facts(),
            time: self.time(),
            panels: &self.panels(),
            params: params(self.chosen),
            results: results(self.recorded),
            equations: &report::text(model.equations()),
            settings: self.settings(),
            warnings: model.warnings().iter().map(ToString::to_string).collect(),
            ended_early: self.ended_early(),
        }))
    }

    fn time(&self) -> &[f64] {
        self.recorded.columns.first().map_or(&[], Vec::as_slice)
    }

    fn panels(&self) -> Vec<Panel> {
        // First comes time, then states, then outputs.
        let states = self.chosen.design.model().equations().states.len();
        let headings = self.recorded.headings.iter();
        let columns: Vec<Column> = headings
            .zip(&self.recorded.columns)
            .enumerate()
            .skip(1)
            .map(|(index, (heading, values))| Column {
                name: heading.name.to_string(),
                unit: heading.unit.to_string(),
                output: index > states,
                values: values.clone(),
            })
            .collect();
        choose(&columns)
    }

    fn ended_early(&self) -> Option<String> {
        match self.outcome {
            Ok(summary) => match &summary.ending {
                Ending::Stopped(why) => Some(format!(
                    "Ended at {}: {why}",
                    scale::with_unit(summary.end, "s", 6)
                )),
                Ending::Complete | Ending::Interrupted | Ending::Failed => None,
            },
            Err(breakdown) => Some(format!(
                "The run failed at {}: {}",
                scale::with_unit(breakdown.time, "s", 6),
                breakdown.message
            )),
        }
    }

    fn adaptive_method(&self) -> &'static str {
        let stiff = match self.outcome {
            Ok(summary) => summary.statistics.stiff,
            Err(_) => 0,
        };
        match self.arguments.method {
            Method::Stiff => "Rodas5P",
            Method::Auto if stiff > 0 => "Dormand–Prince 8(5,3) and Rodas5P",
            Method::Auto | Method::Explicit => "Dormand–Prince 8(5,3)",
        }
    }

    /// How the run was made.
    fn settings(&self) -> Vec<(String, String)> {
        let seconds = |value| scale::with_unit(value, "s", 6);
        let arguments = self.arguments;
        let method = match arguments.dt {
            Some(step) => format!("Runge–Kutta of order 4, steps of {}", seconds(step)),
            None => format!(
                "{}, relative tolerance {}",
                self.adaptive_method(),
                scale::number(arguments.rtol, 6)
            ),
        };
        let rows = match arguments.row_interval() {
            Some(interval) => format!("{}, every {}", self.recorded.rows, seconds(interval)),
            None => format!("{}, one per step", self.recorded.rows),
        };
        let file = arguments.settings.file.display().to_string();
        let mut settings = vec![
            ("model file".to_owned(), file),
            ("until".to_owned(), seconds(arguments.until)),
            ("method".to_owned(), method),
            ("rows".to_owned(), rows),
        ];
        for set in &arguments.settings.use_sets {
            settings.push(("parameter set".to_owned(), set.clone()));
        }
        for (index, value) in &self.chosen.inputs {
            let input = &self.chosen.design.model().inputs()[*index];
            let held = scale::with_unit(*value, &input.unit, 8);
            settings.push((format!("input {}", input.name), held));
        }
        if let Ok(summary) = self.outcome {
            let statistics = summary.statistics;
            let counts = [
                ("steps", statistics.accepted),
                ("steps outside tables", statistics.outside_tables),
                ("steps rejected", statistics.rejected),
                ("evaluations", statistics.evaluations),
                ("kinks of drives", statistics.kinks),
                ("events", statistics.events),
            ];
            settings.extend(counts.map(|(what, count)| (what.to_owned(), count.to_string())));
        }
        settings
    }
}

fn params(chosen: &Chosen) -> Vec<Row> {
    let model = chosen.design.model();
    let dimensions = model.equations().params.iter().map(|param| param.dimension);
    model
        .params()
        .iter()
        .zip(dimensions)
        .zip(chosen.design.values())
        .map(|((param, dimension), &value)| Row {
            name: param.name.to_string(),
            value: match dimension.mark() {
                Mark::Frequency => scale::with_unit(value, "Hz", 10),
                Mark::AngularRate => scale::with_unit(value, "rad/s", 10),
                Mark::Plain => scale::with_unit(value, &param.unit, 10),
            },
            meaning: param.meaning.to_string(),
            changed: param.start != Some(value),
        })
        .collect()
}

fn results(recorded: &Recorded) -> Vec<[String; 6]> {
    let span = recorded.span();
    let columns = recorded.headings.iter().zip(&recorded.sums).skip(1);
    columns
        .map(|(heading, sum)| {
            let size = sum.least.abs().max(sum.greatest.abs());
            let unit = if heading.unit == "rad" && size > LARGE_ANGLE {
                scale::degrees()
            } else {
                scale::display_unit(&heading.unit, size)
            };
            let cell = |value: f64| {
                let number = scale::number(value / unit.factor, 6);
                match unit.name.as_str() {
                    "" | "°" => number + &unit.name,
                    name => format!("{number} {name}"),
                }
            };
            [
                heading.name.to_string(),
                cell(sum.first),
                cell(sum.last),
                cell(sum.least),
                cell(sum.greatest),
                cell(sum.mean(span)),
            ]
        })
        .collect()
}
