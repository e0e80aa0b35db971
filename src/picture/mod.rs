//! Pictures as SVG, the same text for the same data: charts, bars, charts side by side, mechanisms
//! at rest and in motion.
//!
//! A picture is data first; all values are in SI:
//!
//! ```
//! use flexure::picture::{Axis, Chart, Graphic, Look, Panel, Series};
//!
//! let frequency = vec![100.0, 200.0, 300.0];
//! let chart = Chart {
//!     title: "Mean speed against drive frequency".into(),
//!     x: Axis::linear("drive frequency", "Hz"),
//!     panels: vec![Panel {
//!         y: Axis::linear("mean speed", "m/s"),
//!         series: vec![
//!             Series::new("Fp = 5 N", frequency.clone(), [1e-3, 2e-3, f64::NAN], Look::LineAndPoints),
//!             Series::new("Fp = 10 N", frequency, [1.1e-3, 2.2e-3, 3.3e-3], Look::LineAndPoints),
//!         ],
//!         ..Panel::default()
//!     }],
//!     ordered: true,
//! };
//! let svg = Graphic::Chart(chart).file();
//! assert!(svg.contains("mean speed (mm/s)"));
//! ```
//!
//! Two panels of one [`Chart`] make a Bode chart, [`Bars`] show sensitivities, [`Graphic::Grid`]
//! puts small charts side by side, [`Band`] and [`Reference`] mark windows and single values. A
//! point whose value is not a number is a gap, marked as failed where points are drawn.
//! [`Report`](crate::report::Report) puts pictures onto a page.

mod bars;
mod chart;
mod graphic;
mod labels;
mod layout;
mod legend;
mod mechanism;
mod plot;
mod scale;
mod strokes;
pub(crate) mod svg;

pub use chart::{Axis, Band, Bars, Chart, Look, Panel, Reference, Series, Which};
pub use graphic::Graphic;
pub(crate) use mechanism::{mechanism, moving};
pub use scale::{DisplayUnit, degrees, display_unit, number, pretty_unit, with_unit};
