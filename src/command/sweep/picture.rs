//! A sweep over one or two axes as a chart: the first axis to the right, a series for each value of
//! the second, a panel for each measure.

use flexure::Model;
use flexure::picture::{Axis, Chart, Graphic, Look, Panel, Series, with_unit};
use flexure::study::{Measure, Row, Sweep};

use super::super::Failure;
use super::super::charts::Charts;
use super::Arguments;

/// Digits of values in the legend.
const DIGITS: usize = 6;

/// The chart of a sweep, which collects its rows.
pub struct Picture<'a> {
    measures: &'a [Measure],
    /// Name and SI unit of the first axis.
    across: (String, String),
    /// The same of the second, if there is one.
    family: Option<(String, String)>,
    /// In the order in which their values come.
    curves: Vec<Curve>,
}

/// The points at one value of the second axis.
struct Curve {
    level: f64,
    /// Value of the first axis, and measures.
    points: Vec<(f64, Vec<f64>)>,
}

impl<'a> Picture<'a> {
    /// An empty one.
    ///
    /// # Errors
    ///
    /// If the sweep has no axis, or more than two.
    pub fn new(sweep: &'a Sweep, model: &Model) -> Result<Self, Failure> {
        let names = sweep.points.varied().into_iter().map(str::to_owned);
        let mut axes = names.zip(sweep.points.units(model));
        let (across, family, more) = (axes.next(), axes.next(), axes.next());
        match (across, more) {
            (Some(across), None) => Ok(Self {
                measures: &sweep.measures,
                across,
                family,
                curves: Vec::new(),
            }),
            _ => Err(Failure::usage(
                "--plot shows one or two varied params: the first to the right, a curve for each \
                 value of the second",
            )),
        }
    }

    /// Adds a row. A design without measures is a gap.
    pub fn add(&mut self, row: &Row) {
        let Some((&x, rest)) = row.point.split_first() else {
            return;
        };
        let level = rest.first().copied().unwrap_or(0.0);
        let mut measures = row.measures.clone();
        measures.resize(self.measures.len(), f64::NAN);
        let point = (x, measures);
        match self.curves.iter_mut().find(|curve| curve.level == level) {
            Some(curve) => curve.points.push(point),
            None => self.curves.push(Curve {
                level,
                points: vec![point],
            }),
        }
    }

    /// The chart with what is said of it.
    pub fn charts(mut self, arguments: &Arguments, sweep: &'a Sweep) -> Charts<'a> {
        for curve in &mut self.curves {
            curve.points.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        let model = sweep.design.model().name().replace('_', " ");
        let title = match &self.family {
            Some((name, _)) => format!("{model} against {} and {name}", self.across.0),
            None => format!("{model} against {}", self.across.0),
        };
        let panels = self.measures.iter().enumerate();
        let chart = Chart {
            title: title.clone(),
            x: Axis::linear(&self.across.0, &self.across.1),
            panels: panels.map(|(index, of)| self.panel(index, of)).collect(),
            ordered: self.curves.len() > 1 && self.curves.is_sorted_by(|a, b| a.level < b.level),
        };
        let file = arguments.settings.file.display().to_string();
        let mut settings = vec![
            ("model file".to_owned(), file),
            ("measured".to_owned(), span(arguments)),
        ];
        settings.push(("designs".to_owned(), sweep.points.len().to_string()));
        Charts {
            title,
            design: &sweep.design,
            settings,
            figures: vec![(
                Graphic::Chart(chart),
                format!("Measured {}.", span(arguments)),
            )],
        }
    }

    fn panel(&self, index: usize, measure: &Measure) -> Panel {
        let series = self.curves.iter().map(|curve| {
            let name = match &self.family {
                Some((name, unit)) => format!("{name} = {}", with_unit(curve.level, unit, DIGITS)),
                None => String::new(),
            };
            let x: Vec<f64> = curve.points.iter().map(|point| point.0).collect();
            let y: Vec<f64> = curve.points.iter().map(|point| point.1[index]).collect();
            Series::new(name, x, y, Look::LineAndPoints)
        });
        Panel {
            y: Axis::linear(measure.name(), measure.unit()),
            series: series.collect(),
            ..Panel::default()
        }
    }
}

/// When measures are taken, in words.
fn span(arguments: &Arguments) -> String {
    match arguments.until {
        Some(until) => {
            let from = arguments.warmup.as_deref().unwrap_or("0 s");
            format!("from {from} to {}", with_unit(until, "s", DIGITS))
        }
        None => {
            let warmup = arguments.warmup.as_deref();
            let warmup = warmup.map_or_else(|| super::DEFAULT_WARMUP.to_string(), str::to_owned);
            let cycles = arguments.cycles.unwrap_or(super::DEFAULT_CYCLES);
            format!("over {cycles} cycles of the drive, after {warmup}")
        }
    }
}
