//! The golden modules, and those of models that are too long for one, compile without a warning and
//! compute what the oracle computes; their Jacobians are those of dual numbers.

#![deny(warnings)]
#![forbid(unsafe_code)]
#![allow(mixed_script_confusables, uncommon_codepoints, confusable_idents)]

mod support;

use flexure_model_dsl::equations::Equations;
use flexure_runtime::dual::Dual;
use flexure_runtime::lanes::LaneSystem;
use flexure_runtime::real::Real;
use flexure_runtime::system::System;
use support::agreement::{Place, compare, compare_rates, places};

/// Compares the Jacobian with one dual evaluation of the right-hand side for each state.
fn compare_jacobian(name: &str, system: &dyn System, rhs: &dyn Fn(&Place, usize) -> Vec<Dual>) {
    let count = system.states().len();
    let mut compared = 0;
    for place in places(system, 100, 11) {
        let mut jacobian = vec![f64::NAN; count * count];
        system.jacobian(place.t, &place.x, &place.d, &place.u, &mut jacobian);
        for column in 0..count {
            let rates = rhs(&place, column);
            // A rate is a sum of terms; where they cancel, the largest entry of its row gives the scale.
            for (row, rate) in rates.iter().enumerate() {
                if !rate.value.is_finite() {
                    continue;
                }
                let entry = jacobian[row * count + column];
                let scale = rate.rate.abs().max(entry.abs());
                let error = (entry - rate.rate).abs();
                assert!(
                    error <= 1e-8 * scale,
                    "{name}: entry ({row}, {column}) is {entry:e}, by dual numbers {:e}",
                    rate.rate
                );
                compared += 1;
            }
        }
    }
    println!("{name}: {compared} entries of the Jacobian compared");
    assert!(compared > 0);
}

/// Continuous and discrete state.
type Start = (Vec<f64>, Vec<f64>);

/// Compares what the tape and the compiled model make of a parameter set with one value changed.
fn compare_refusals(
    name: &str,
    defaults: &[f64],
    prepare: &dyn Fn(&[f64]) -> Result<Start, String>,
) {
    let tape = flexure_codegen::tape(&flexure_codegen::program(&equations(name)));
    let mut refused = 0;
    for position in 0..defaults.len() {
        let default = defaults[position];
        let changes = [
            0.0,
            -default,
            2.0 * default,
            1e3 * default,
            1e300,
            f64::INFINITY,
            f64::NAN,
        ];
        for value in changes {
            let mut params = defaults.to_vec();
            params[position] = value;
            let by_tape = tape
                .prepare(&params)
                .map(|prepared| start(&prepared))
                .map_err(|diagnostic| diagnostic.to_string());
            refused += usize::from(by_tape.is_err());
            assert_eq!(
                by_tape,
                prepare(&params),
                "{name} with {value} at {position}"
            );
        }
    }
    println!("{name}: {refused} parameter sets refused");
    assert!(refused > defaults.len());
}

fn start(system: &dyn System) -> Start {
    let (mut x, mut d) = (
        vec![0.0; system.states().len()],
        vec![0.0; system.discretes().len()],
    );
    system.start(&mut x, &mut d);
    (x, d)
}

fn equations(name: &str) -> Equations {
    support::models::all()
        .into_iter()
        .chain([support::handmade::slider_crank()])
        .find(|equations| equations.name == name)
        .expect("a model of that name")
}

/// A test of a compiled module against the model that it was made of.
macro_rules! compiled {
    ($test:ident: $name:ident in $($module:ident)::+) => {
        #[test]
        fn $test() {
            use $($module)::+::$name::{Params, Prepared, VARIABLES, rhs};
            let params = Params::default();
            let prepared = match params.prepare() {
                Ok(prepared) => prepared,
                Err(diagnostic) => panic!("{diagnostic}"),
            };
            let name = stringify!($name);
            assert!(VARIABLES.len() >= prepared.states().len());
            compare(&equations(name), &params.values(), &prepared, 200);
            compare_refusals(name, &params.values(), &|values| {
                let values = values.try_into().expect("as many values as params");
                match Params::from_values(values).prepare() {
                    Ok(prepared) => Ok(start(&prepared)),
                    Err(diagnostic) => Err(diagnostic.to_string()),
                }
            });
            let alone: Prepared<f64> = prepared.alone();
            compare_rates(&equations(name), &params.values(), &prepared, &|place| {
                let mut result = vec![0.0; place.x.len()];
                alone.rhs(place.t, &place.x, &place.d, &place.u, &mut result);
                result
            });
            let dual: Prepared<Dual> = prepared.map(Dual::from_f64);
            compare_jacobian(name, &prepared, &|place, column| {
                let constant = |list: &[f64]| -> Vec<Dual> {
                    list.iter().copied().map(Dual::from_f64).collect()
                };
                let mut x = constant(&place.x);
                x[column].rate = 1.0;
                let mut result = vec![Dual::default(); x.len()];
                rhs(
                    Dual::from_f64(place.t),
                    x.as_slice().try_into().expect("states"),
                    constant(&place.d).as_slice().try_into().expect("discrete states"),
                    constant(&place.u).as_slice().try_into().expect("inputs"),
                    &dual,
                    result.as_mut_slice().try_into().expect("rates"),
                );
                result
            });
        }
    };
}

macro_rules! golden {
    ($($test:ident: $name:ident in $file:ident at $path:literal,)*) => {
        $(
            #[path = $path]
            mod $file;

            compiled!($test: $name in $file);
        )*

        #[test]
        fn every_model_is_here() {
            let mut names: Vec<String> =
                support::models::all().into_iter().map(|e| e.name).collect();
            names.retain(|name| !support::models::TOO_LONG.contains(&name.as_str()));
            names.push("slider_crank_by_hand".to_owned());
            names.sort();
            assert_eq!([$(stringify!($name)),*].as_slice(), names.as_slice());
        }
    };
}

golden! {
    andrews: andrews in andrews_golden at "golden/andrews.rs",
    bridge_amplifier: bridge_amplifier in bridge_amplifier_golden at "golden/bridge_amplifier.rs",
    double_parallelogram_stage: double_parallelogram_stage in double_parallelogram_stage_golden at "golden/double_parallelogram_stage.rs",
    double_rocker: double_rocker in double_rocker_golden at "golden/double_rocker.rs",
    five_bar: five_bar in five_bar_golden at "golden/five_bar.rs",
    four_bar: four_bar in four_bar_golden at "golden/four_bar.rs",
    lugre_mass: lugre_mass in lugre_mass_golden at "golden/lugre_mass.rs",
    msdm: msdm in msdm_golden at "golden/msdm.rs",
    n_windows_1: n_windows_1 in n_windows_1_golden at "golden/n_windows_1.rs",
    n_windows_2: n_windows_2 in n_windows_2_golden at "golden/n_windows_2.rs",
    n_windows_40: n_windows_40 in n_windows_40_golden at "golden/n_windows_40.rs",
    parallelogram_stage: parallelogram_stage in parallelogram_stage_golden at "golden/parallelogram_stage.rs",
    pendulum: pendulum in pendulum_golden at "golden/pendulum.rs",
    six_bar: six_bar in six_bar_golden at "golden/six_bar.rs",
    slider_crank: slider_crank in slider_crank_golden at "golden/slider_crank.rs",
    slider_crank_by_hand: slider_crank_by_hand in slider_crank_by_hand_golden at "golden/slider_crank_by_hand.rs",
    xy_stage: xy_stage in xy_stage_golden at "golden/xy_stage.rs",
}

compiled!(three_rrr: three_rrr in flexure_models);
compiled!(three_rrr_cranks: three_rrr_cranks in flexure_models);
