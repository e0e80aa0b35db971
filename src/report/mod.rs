//! Reports: one self-contained HTML page with words, findings, figures with the tables behind
//! them, the mechanism, its equations and its settings. It loads nothing from anywhere, follows the
//! reader's choice of light or dark, prints, and is the same text whenever it is made of the same
//! data: what differs from run to run (timings) belongs into a file of its own.
//!
//! ```
//! use flexure::picture::{Axis, Chart, Graphic, Look, Panel, Series};
//! use flexure::report::{Block, Figure, Finding, Report, Section, Verdict};
//!
//! let chart = Chart {
//!     x: Axis::linear("preload", "N"),
//!     panels: vec![Panel {
//!         y: Axis::linear("mean speed", "m/s"),
//!         series: vec![Series::new("speed", [5.0, 10.0], [4e-3, 7e-3], Look::LineAndPoints)],
//!         ..Panel::default()
//!     }],
//!     ..Chart::default()
//! };
//! let mut report = Report::new("Preload");
//! report.sections.push(Section::new("Mean speed", [
//!     Block::Words("More preload, more speed: see `Fp`.".into()),
//!     Block::Finding(Finding {
//!         claim: "Speed grows with preload".into(),
//!         verdict: Verdict::Holds,
//!         reason: "7 mm/s at 10 N against 4 mm/s at 5 N".into(),
//!     }),
//!     Block::Figure(Figure::new(Graphic::Chart(chart), "Mean speed over cycles 10 to 30.")),
//! ]));
//! assert!(report.html().starts_with("<!DOCTYPE html>"));
//! ```
//!
//! [`Block::mechanism`], [`Block::params`] and [`Block::equations`] are made of a model's
//! [`Design`].
//! Words from outside are never markup; what stands in them between backticks is set as code.

mod blocks;
mod page;
mod style;
mod table;

use crate::picture::Graphic;
use crate::runtime::diagnostic::Diagnostic;
use crate::{Assembled, Design, Model, Places};

pub use table::{Cells, Column, Table};

/// A page.
#[derive(Clone, Debug)]
pub struct Report {
    /// Title.
    pub title: String,
    /// What it is about: paragraphs with an empty line between.
    pub words: String,
    /// Its parts.
    pub sections: Vec<Section>,
}

/// A part of a page.
#[derive(Clone, Debug)]
pub struct Section {
    /// Title.
    pub title: String,
    /// What it says, in order.
    pub blocks: Vec<Block>,
}

/// A piece of a section.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Block {
    /// Paragraphs, with an empty line between.
    Words(String),
    /// A claim and what became of it.
    Finding(Finding),
    /// A figure.
    Figure(Figure),
    /// A table, shown whole, under words that may be empty.
    Table(Table, String),
    /// What each line is about, and what is said: settings, facts.
    Facts(Vec<(String, String)>),
    /// Something the reader must know.
    Notice(String),
    /// Text as it is typed.
    Code(String),
    /// The mechanism as assembled, with facts on it.
    Mechanism(Box<Places>, Vec<(String, String)>),
    /// The mechanism in motion.
    Motion(Box<Motion>),
    /// Values of a model's params.
    Params(Design),
    /// A model's equations of motion.
    Equations(Model),
    /// Sections side by side where the page is wide.
    Beside(Vec<Section>),
}

/// A mechanism over a span of time.
#[derive(Clone, Debug)]
pub struct Motion {
    places: Places,
    times: Vec<f64>,
    frames: Vec<Places>,
}

/// Pictures of a motion, at equal intervals.
const FRAMES: usize = 60;

impl Motion {
    /// The motion from time `from` to `to` in s, best one cycle of the drive, out of a run's
    /// `times` and the columns of its states in the order of the model's equations, all in SI.
    /// Between rows places are interpolated. Nothing if the run has fewer than a dozen rows there.
    ///
    /// # Errors
    ///
    /// If a loop does not close at a state.
    pub fn new(
        assembled: &mut Assembled,
        times: &[f64],
        states: &[&[f64]],
        [from, to]: [f64; 2],
    ) -> Result<Option<Self>, Diagnostic> {
        let within = times.iter().filter(|t| (from..=to).contains(*t)).count();
        let is_whole = states.iter().all(|column| column.len() == times.len());
        if within < 12 || !is_whole || states.is_empty() {
            return Ok(None);
        }
        let times_shown: Vec<f64> = (0..=FRAMES)
            .map(|k| from + (to - from) * k as f64 / FRAMES as f64)
            .collect();
        let frames = times_shown.iter().map(|&time| {
            let state: Vec<f64> = states
                .iter()
                .map(|column| interpolated(times, column, time))
                .collect();
            assembled.places_at(&state)
        });
        Ok(Some(Self {
            frames: frames.collect::<Result<_, _>>()?,
            times: times_shown,
            places: assembled.places(),
        }))
    }
}

/// The value at a time between rows, times in ascending order.
fn interpolated(times: &[f64], values: &[f64], time: f64) -> f64 {
    let above = times.partition_point(|&t| t < time).min(times.len() - 1);
    let below = above.saturating_sub(1);
    let span = times[above] - times[below];
    if span <= 0.0 {
        return values[above];
    }
    let share = ((time - times[below]) / span).clamp(0.0, 1.0);
    values[below] + share * (values[above] - values[below])
}

/// What became of a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Finding {
    /// The claim, in its author's terms.
    pub claim: String,
    /// Whether it holds.
    pub verdict: Verdict,
    /// Why, with numbers.
    pub reason: String,
}

/// Whether a claim holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It does.
    Holds,
    /// Some of it does.
    InPart,
    /// It does not.
    Fails,
    /// It could not be judged: data are missing.
    Open,
}

/// A picture with words below it and the numbers behind it.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// The picture.
    pub graphic: Graphic,
    /// What it shows, and how it was made.
    pub caption: String,
    /// The numbers behind it.
    pub table: Option<Table>,
}

impl Report {
    /// A page without sections.
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            words: String::new(),
            sections: Vec::new(),
        }
    }

    /// The page as HTML.
    pub fn html(&self) -> String {
        page::page(self)
    }
}

impl Section {
    /// A section of blocks.
    pub fn new(title: impl Into<String>, blocks: impl Into<Vec<Block>>) -> Self {
        Self {
            title: title.into(),
            blocks: blocks.into(),
        }
    }
}

impl Figure {
    /// A figure with the table of what its picture shows.
    pub fn new(graphic: Graphic, caption: impl Into<String>) -> Self {
        let table = Table::behind(&graphic);
        Self {
            graphic,
            caption: caption.into(),
            table: Some(table),
        }
    }
}

impl Block {
    /// The mechanism as assembled, with what was found on assembling it.
    pub fn mechanism(assembled: &mut Assembled) -> Self {
        Self::Mechanism(Box::new(assembled.places()), assembled.facts())
    }

    /// The params with their values; those that are not the model's defaults are marked.
    pub fn params(design: &Design) -> Self {
        Self::Params(design.clone())
    }

    /// The equations of motion, typeset.
    pub fn equations(model: &Model) -> Self {
        Self::Equations(model.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulate;

    /// Where a part is at a state, against what the run itself says of it.
    #[test]
    fn a_motion_follows_the_run() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/models/double_rocker.flex");
        let model = Model::from_path(file).unwrap();
        let design = model.design();
        let system = design.prepare().unwrap();
        let run = simulate(&system).until(2e-3).every(1e-5).run().unwrap();
        let columns: Vec<_> = model
            .equations()
            .states
            .iter()
            .map(|state| run.column(&state.name))
            .collect();
        let states: Vec<&[f64]> = columns.iter().map(|column| column.values()).collect();
        let mut assembled = design.assembled().unwrap();
        let period = assembled.period().unwrap();
        assert!((period - 1e-3).abs() < 1e-18);
        let motion = Motion::new(&mut assembled, run.times(), &states, [1e-3, 2e-3]);
        let motion = motion.unwrap().unwrap();
        let place = |frame: &Places, name: &str| {
            let slide = frame.slides.iter().find(|(slide, _, _)| slide == name);
            slide.unwrap().1.unwrap()
        };
        let [first, last] = [&motion.frames[0], motion.frames.last().unwrap()];
        for slide in ["stack", "stage"] {
            let [from, to] = [first, last].map(|frame| place(frame, slide)[0]);
            let column = run.column(&format!("{slide}.x"));
            let begun = column.values()[run.times().partition_point(|&t| t < 1e-3 - 1e-9)];
            // Slides go to the left.
            assert!(
                (to - from + (column.last() - begun)).abs() < 1e-12,
                "{slide}"
            );
        }
        // A link keeps its length, and its angle is that of the run.
        let angle = run.column("crank.angle");
        let [[x, y], [u, v]] = [last.links[0].1[0], last.links[0].1[1]];
        assert!(((u - x).hypot(v - y) - 10.2e-3).abs() < 1e-15);
        assert!(((v - y).atan2(u - x) - angle.last()).abs() < 1e-12);
        let rows = Motion::new(&mut assembled, run.times(), &states, [1e-3, 1.05e-3]);
        assert!(rows.unwrap().is_none(), "too few rows");
    }
}
