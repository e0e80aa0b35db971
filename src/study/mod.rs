//! Design studies: many design points of one model, a few numbers of each run.
//!
//! ```text
//! Axis, PointsFile, Spread ──▶ Points ─┐
//! Measure, Window ─────────────────────┼─▶ Sweep ──run──▶ blocks of Rows, in order ──▶ Journal, files
//! Design (base values) ────────────────┘
//! ```
//!
//! A row depends on its design point, the settings of the sweep, the model, the build and the
//! instruction path, and on nothing else: not on threads, not on where a sweep was broken off. That
//! is what a [`Journal`] rests on.
//!
//! ```
//! use flexure::study::{Axis, Measure, Points, Sweep, Window};
//!
//! let model = flexure::Model::from_path("models/double_rocker.flex")?;
//! let sweep = Sweep {
//!     points: Points::new(&model)
//!         .axis(Axis::parse(&model, "f=1kHz,2kHz")?)?
//!         .axis(Axis::parse(&model, "Fp=10N..20N:10N")?)?,
//!     measures: vec![Measure::parse(&model, "mean(stage.v)")?],
//!     window: Window::cycles(&model, 1.0, 1)?,
//!     ..Sweep::new(model.design())
//! };
//! sweep.run(0, 2, |rows| {
//!     for row in rows {
//!         println!("{:?} {:?} {}", row.point, row.measures, row.status);
//!     }
//!     std::ops::ControlFlow::Continue(())
//! });
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod axis;
mod fingerprint;
mod journal;
mod limit;
mod measure;
mod points;
mod points_file;
mod spread;
mod sweep;
mod target;
mod window;

pub use axis::Axis;
pub use fingerprint::{build, fingerprint};
pub use journal::{Journal, JournalFailure};
pub use limit::{Limit, share_range};
pub use measure::Measure;
pub use points::Points;
pub use points_file::PointsFile;
pub use spread::{Draws, Spread};
pub use sweep::{Accuracy, Row, Status, Sweep};
pub use target::Target;
pub use window::Window;
