//! From a model file of a planar flexure mechanism to its equations of motion in closed form and
//! a fast simulator.
//!
//! A model known when a program is compiled becomes a module of its own:
//!
//! ```
//! flexure::include_model!("models/double_rocker.flex");
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let design = double_rocker::Params { Fp: 15.0, ..Default::default() };
//! let model = design.prepare()?;
//! let run = flexure::simulate(&model).until(1e-3).rtol(1e-8).every(1e-5).run()?;
//! println!("{} m/s", run.column("stage.v").mean());
//! # Ok(())
//! # }
//! ```
//!
//! A model file that is only known at run time is a [`Model`], which runs on a tape:
//!
//! ```
//! let model = flexure::Model::from_path("models/double_rocker.flex")?;
//! let mut design = model.design();
//! design.set_written("Fp = 15 N")?;
//! let run = flexure::simulate(&design.prepare()?).until(1e-3).rtol(1e-8).run()?;
//! # assert!(run.column("stage.x").last() > 0.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Many designs at once, with measures of each run, are a [`study::Sweep`] (feature `study`, which
//! `cli` brings along).
//!
//! The compiler itself is in [`model_dsl`] and [`codegen`], what simulators run on in [`runtime`];
//! the `flexure` command stands behind the default feature `cli`.

mod assembled;
mod macros;
mod model;
mod reach;
pub mod response;
pub mod statics;
#[cfg(feature = "study")]
pub mod study;

pub mod picture;
pub mod report;

pub use assembled::{Assembled, PlacedContact, PlacedEnd, PlacedSpring, Places, Point};
pub use flexure_codegen as codegen;
pub use flexure_model_dsl as model_dsl;
pub use flexure_runtime as runtime;
pub use flexure_runtime::simulate::{Run, ensemble, simulate};
pub use model::{Design, Diagnostics, Model, quantity, split_assignment};
pub use reach::{Approach, Limit, Reach};

/// What [`include_model!`] and [`model!`] expand to; not for use by name.
#[doc(hidden)]
pub mod __macros {
    pub use flexure_macros::{include_model, model};
}

/// The Rust of the README, compiled and run as a documentation test.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct ReadmeExamples;
