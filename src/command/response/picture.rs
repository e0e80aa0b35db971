//! What was found on a frequency response as a chart.

use flexure::picture::{Axis, Band, Chart, Graphic, Look, Panel, Series};
use flexure::response::{DEFINITIONS, LinearRegime, linear_regime};

use super::super::charts::Charts;
use super::report::Study;

/// The linear regime that is drawn: the one from the lowest frequency, in its wider sense.
const SHOWN: usize = 3;

impl Study<'_> {
    /// The curves with their linear regimes and what was measured.
    pub fn charts(&self) -> Charts<'_> {
        let model = self.actuator.model().name().replace('_', " ");
        let title = format!("Mean speed of {model}");
        let mut caption = format!("Mean speed, {}.", self.span());
        if !self.regime_bands().is_empty() {
            caption += &format!(
                " Marked are the linear regimes: {}.",
                DEFINITIONS[SHOWN].name
            );
        }
        let settings = &self.arguments.actuation.settings;
        Charts {
            title: title.clone(),
            design: &self.actuator.chosen.design,
            settings: vec![
                ("model file".to_owned(), settings.file.display().to_string()),
                ("speed".to_owned(), self.actuator.speed_words.clone()),
                ("mean".to_owned(), self.span()),
            ],
            figures: vec![(Graphic::Chart(self.chart(title)), caption)],
        }
    }

    fn chart(&self, title: String) -> Chart {
        let mut series: Vec<Series> = self
            .curves
            .iter()
            .map(|curve| {
                let (x, y): (Vec<f64>, Vec<f64>) = self.curve(curve).into_iter().unzip();
                Series::new(&curve.label, x, y, Look::LineAndPoints)
            })
            .collect();
        if let Some(experiment) = self.experiment {
            let (x, y): (Vec<f64>, Vec<f64>) = experiment.points.iter().copied().unzip();
            series.push(Series::new("experiment", x, y, Look::Points));
        }
        // Levels are those of one param alone.
        let values = self.curves.iter().map(|curve| curve.values.as_slice());
        let ordered = self.experiment.is_none()
            && self.curves.len() > 1
            && self.family.len() == 1
            && values.is_sorted_by(|low, high| low[0] < high[0]);
        Chart {
            title,
            x: Axis::linear("drive frequency", "Hz"),
            panels: vec![Panel {
                y: Axis::linear(
                    format!("mean {}", self.arguments.actuation.speed),
                    &self.actuator.speed_unit,
                ),
                series,
                bands: self.regime_bands(),
                references: Vec::new(),
            }],
            ordered,
        }
    }

    /// The linear regimes: shaded for a single curve, else a bar for each curve.
    fn regime_bands(&self) -> Vec<Band> {
        let is_single = self.curves.len() == 1;
        let curves = self.curves.iter().enumerate();
        let found = curves.filter_map(|(index, curve)| {
            let LinearRegime { from, to, .. } =
                linear_regime(&self.curve(curve), &DEFINITIONS[SHOWN])?;
            Some(Band {
                from,
                to,
                label: "linear regime".to_owned(),
                series: (!is_single).then_some(index),
            })
        });
        found.collect()
    }
}
