//! The models of this repository, each compiled by the macro to a module of its own.
//!
//! ```
//! use flexure_models::pendulum::Params;
//!
//! let design = Params { length: 0.25, ..Params::default() };
//! let model = design.prepare()?;
//! let run = flexure_runtime::simulate::simulate(&model).until(0.1).rtol(1e-9).run()?;
//! assert!(run.column("bar.angle").last() < run.column("bar.angle").max());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![deny(warnings)]
#![forbid(unsafe_code)]

flexure_macros::include_model!(::flexure_runtime, "andrews.flex");
flexure_macros::include_model!(::flexure_runtime, "bridge_amplifier.flex");
flexure_macros::include_model!(::flexure_runtime, "double_parallelogram_stage.flex");
flexure_macros::include_model!(::flexure_runtime, "double_rocker.flex");
flexure_macros::include_model!(::flexure_runtime, "five_bar.flex");
flexure_macros::include_model!(::flexure_runtime, "four_bar.flex");
flexure_macros::include_model!(::flexure_runtime, "lugre_mass.flex");
flexure_macros::include_model!(::flexure_runtime, "msdm.flex");
flexure_macros::include_model!(::flexure_runtime, "n_windows_1.flex");
flexure_macros::include_model!(::flexure_runtime, "n_windows_2.flex");
flexure_macros::include_model!(::flexure_runtime, "n_windows_40.flex");
flexure_macros::include_model!(::flexure_runtime, "parallelogram_stage.flex");
flexure_macros::include_model!(::flexure_runtime, "pendulum.flex");
flexure_macros::include_model!(::flexure_runtime, "six_bar.flex");
flexure_macros::include_model!(::flexure_runtime, "slider_crank.flex");
flexure_macros::include_model!(::flexure_runtime, "three_rrr.flex");
flexure_macros::include_model!(::flexure_runtime, "three_rrr_cranks.flex");
flexure_macros::include_model!(::flexure_runtime, "xy_stage.flex");
