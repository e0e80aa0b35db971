//! Charts as data: what is drawn, not how. All values are in SI; drawing picks prefixes and ticks.

use std::sync::Arc;

/// Panels one above the other that share their horizontal axis.
///
/// One panel is a plain chart; magnitude above phase makes a Bode chart.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Chart {
    /// What it shows, in a few words.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The panels, from top to bottom.
    pub panels: Vec<Panel>,
    /// Whether the series are levels of one quantity in ascending order: their colours then are.
    pub ordered: bool,
}

/// An axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Axis {
    /// What it counts: `drive frequency`.
    pub label: String,
    /// SI unit (`m/s`), or one that takes no prefix (`dB`, `%`, `°`); `1` or empty for a plain number.
    pub unit: String,
    /// Whether equal ratios take equal lengths. Values that are not above zero are then left out.
    pub logarithmic: bool,
    /// The range to show, in the axis' unit; all values if not given.
    pub range: Option<[f64; 2]>,
}

/// Series over one vertical axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Panel {
    /// The vertical axis.
    pub y: Axis,
    /// What is drawn, the last on top.
    pub series: Vec<Series>,
    /// Windows of the horizontal axis.
    pub bands: Vec<Band>,
    /// Single values that matter.
    pub references: Vec<Reference>,
}

/// Values over others.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Its name in the legend; none if empty.
    pub name: String,
    /// Horizontal values.
    pub x: Arc<[f64]>,
    /// Vertical values, as many; one that is not a number is a gap, and where points are drawn it
    /// is marked as failed.
    pub y: Vec<f64>,
    /// How it is drawn.
    pub look: Look,
    /// Number of its colour and marker; its position among the series if not given.
    pub colour: Option<usize>,
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Look {
    /// A line.
    #[default]
    Line,
    /// A broken line: a fit, a bound.
    Dashed,
    /// Markers.
    Points,
    /// Markers joined by a line.
    LineAndPoints,
}

/// A window of the horizontal axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// Where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// What it is; may be empty.
    pub label: String,
    /// Whose window it is, by position among the panel's series: drawn as a bar of its colour above
    /// the curves. Shaded over the whole height if it is nobody's.
    pub series: Option<usize>,
}

/// A value that matters.
#[derive(Clone, Debug, PartialEq)]
pub struct Reference {
    /// The value.
    pub at: f64,
    /// On which axis.
    pub axis: Which,
    /// What it is; may be empty.
    pub label: String,
}

/// One of the two axes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// The horizontal one.
    X,
    /// The vertical one.
    Y,
}

/// Values of named things as bars from zero: sensitivities, times, errors.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bars {
    /// What they show.
    pub title: String,
    /// The axis of the values.
    pub value: Axis,
    /// Names of the things, from top to bottom.
    pub names: Vec<String>,
    /// Kinds of values: name (may be empty) and one value for each thing; one that is not a number
    /// has no bar and is said to be missing.
    pub groups: Vec<(String, Vec<f64>)>,
}

impl Axis {
    /// An axis with equal steps.
    pub fn linear(label: impl Into<String>, unit: impl Into<String>) -> Self {
        Self {
            label: label.into(),
            unit: unit.into(),
            logarithmic: false,
            range: None,
        }
    }

    /// An axis with equal ratios.
    pub fn logarithmic(label: impl Into<String>, unit: impl Into<String>) -> Self {
        Self {
            logarithmic: true,
            ..Self::linear(label, unit)
        }
    }
}

impl Series {
    /// A series drawn as `look`.
    pub fn new(
        name: impl Into<String>,
        x: impl Into<Arc<[f64]>>,
        y: impl Into<Vec<f64>>,
        look: Look,
    ) -> Self {
        Self {
            name: name.into(),
            x: x.into(),
            y: y.into(),
            look,
            colour: None,
        }
    }

    /// The pairs of values.
    pub(crate) fn points(&self) -> impl Iterator<Item = [f64; 2]> {
        self.x.iter().zip(&self.y).map(|(&x, &y)| [x, y])
    }
}

impl Look {
    pub(crate) fn has_line(self) -> bool {
        self != Look::Points
    }

    pub(crate) fn has_points(self) -> bool {
        matches!(self, Look::Points | Look::LineAndPoints)
    }
}
