//! A run as a picture or a page.

use flexure::Assembled;
use flexure::picture::{Graphic, degrees, display_unit, number, with_unit};
use flexure::report::{Block, Column as TableColumn, Figure, Motion, Report, Section, Table};
use flexure::runtime::simulate::{Breakdown, Ending, Summary};

use super::Failure;
use super::panels::{Column, chart};
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
        self.graphic().file()
    }

    /// The whole study as HTML.
    ///
    /// # Errors
    ///
    /// If the mechanism cannot be assembled.
    pub fn page(&self) -> Result<String, Failure> {
        let model = self.chosen.design.model();
        let mut assembled = self.chosen.design.assembled().map_err(Failure::model)?;
        let mut report = Report::new(model.name().replace('_', " "));
        report.words.clone_from(&model.equations().doc);
        let mut mechanism: Vec<Block> = self.ended_early().map(Block::Notice).into_iter().collect();
        mechanism.push(Block::mechanism(&mut assembled));
        let mut motion: Vec<Block> = self.cycle(&mut assembled).into_iter().collect();
        motion.push(Block::Figure(Figure {
            graphic: self.graphic(),
            caption: String::new(),
            table: None,
        }));
        report.sections = vec![
            Section::new("Mechanism", mechanism),
            Section::new("Motion", motion),
            Section::new(
                "Numbers",
                [Block::Table(results(self.recorded), String::new())],
            ),
            Section::new(
                "Settings",
                [Block::Beside(vec![
                    Section::new("Parameters", [Block::params(&self.chosen.design)]),
                    Section::new("Run", [Block::Facts(self.settings())]),
                ])],
            ),
        ];
        let warnings = model.warnings().iter();
        let warnings: Vec<Block> = warnings.map(|w| Block::Code(w.to_string())).collect();
        if !warnings.is_empty() {
            report.sections.push(Section::new("Warnings", warnings));
        }
        report.sections.push(Section::new(
            "Equations of motion",
            [Block::equations(model)],
        ));
        Ok(report.html())
    }

    /// The mechanism over the last cycle of its drive, over the whole run if nothing repeats.
    /// A run that ends where a loop no longer closes has a page without it.
    fn cycle(&self, assembled: &mut Assembled) -> Option<Block> {
        let states = self.chosen.design.model().equations().states.len();
        let (times, rest) = self.recorded.columns.split_first()?;
        let (begin, end) = (*times.first()?, *times.last()?);
        let from = match assembled.period() {
            Some(period) => begin.max(end - period),
            None => begin,
        };
        let columns: Vec<&[f64]> = rest.iter().take(states).map(Vec::as_slice).collect();
        let motion = Motion::new(assembled, times, &columns, [from, end]);
        Some(Block::Motion(Box::new(motion.ok()??)))
    }

    fn graphic(&self) -> Graphic {
        // First comes time, then states, then outputs.
        let model = self.chosen.design.model();
        let states = model.equations().states.len();
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
        let time = self.recorded.columns.first().map_or(&[][..], Vec::as_slice);
        Graphic::Chart(chart(model.name(), time, &columns))
    }

    fn ended_early(&self) -> Option<String> {
        match self.outcome {
            Ok(summary) => match &summary.ending {
                Ending::Stopped(why) => Some(format!(
                    "Ended at {}: {why}",
                    with_unit(summary.end, "s", 6)
                )),
                Ending::Complete | Ending::Interrupted | Ending::Failed => None,
            },
            Err(breakdown) => Some(format!(
                "The run failed at {}: {}",
                with_unit(breakdown.time, "s", 6),
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
        let seconds = |value| with_unit(value, "s", 6);
        let arguments = self.arguments;
        let method = match arguments.dt {
            Some(step) => format!("Runge–Kutta of order 4, steps of {}", seconds(step)),
            None => format!(
                "{}, relative tolerance {}",
                self.adaptive_method(),
                number(arguments.rtol, 6)
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
            let held = with_unit(*value, &input.unit, 8);
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

fn results(recorded: &Recorded) -> Table {
    let span = recorded.span();
    let heads = ["", "start", "end", "least", "greatest", "mean"];
    let mut columns: [Vec<String>; 6] = Default::default();
    for (heading, sum) in recorded.headings.iter().zip(&recorded.sums).skip(1) {
        let size = sum.least.abs().max(sum.greatest.abs());
        let unit = if heading.unit == "rad" && size > LARGE_ANGLE {
            degrees()
        } else {
            display_unit(&heading.unit, size)
        };
        let cell = |value: f64| {
            let number = number(value / unit.factor, 6);
            match unit.name.as_str() {
                "" | "°" => number + &unit.name,
                name => format!("{number}\u{a0}{name}"),
            }
        };
        let values = [sum.first, sum.last, sum.least, sum.greatest, sum.mean(span)];
        columns[0].push(heading.name.to_string());
        for (column, value) in columns[1..].iter_mut().zip(values) {
            column.push(cell(value));
        }
    }
    Table {
        columns: heads
            .into_iter()
            .zip(columns)
            .map(|(head, words)| TableColumn::words(head, words))
            .collect(),
    }
}
