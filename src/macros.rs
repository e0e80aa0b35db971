//! The macros that make a module of a model: thin shims that tell the procedural macros where the
//! runtime is, whatever name this crate has where they are used.

/// A module named after the model of a file, with `Params`, `prepare()` and a simulator.
///
/// The path is relative to the root of the crate in which the macro stands; cargo rebuilds that
/// crate when the file changes. A model that is wrong is a compile error in the words of
/// `flexure check`.
///
/// ```
/// flexure::include_model!("models/pendulum.flex");
///
/// let design = pendulum::Params { length: 0.25, ..Default::default() };
/// let model = design.prepare()?;
/// let run = flexure::simulate(&model).until(0.1).rtol(1e-9).run()?;
/// assert!(run.column("bar.angle").last() < -0.5);
/// println!("{}", pendulum::EQUATIONS);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[macro_export]
macro_rules! include_model {
    ($path:literal $(,)?) => {
        $crate::__macros::include_model! { $crate::runtime, $path }
    };
}

/// The same as [`include_model!`] for a model that is written in place.
///
/// ```
/// flexure::model! {
///     r#"
///     model spring_mass
///     param k = 1 kN/m, m = 1 kg
///     slide mass along (1, 0) { mass = m }
///     spring wall between ground and mass { stiffness = k }
///     initial mass.x = 1 mm
///     "#
/// }
///
/// let model = spring_mass::Params::default().prepare()?;
/// let run = flexure::simulate(&model).until(0.1).rtol(1e-9).run()?;
/// let expected = 1e-3 * (0.1 * 1000f64.sqrt()).cos();
/// assert!((run.column("mass.x").last() - expected).abs() < 1e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[macro_export]
macro_rules! model {
    ($model:literal $(,)?) => {
        $crate::__macros::model! { $crate::runtime, $model }
    };
}
