//! Stick–slip of a mass pulled through a spring under LuGre friction (Canudas de Wit et al. 1995),
//! against figures recomputed in high precision.

mod systems;

use flexure_runtime::simulate::{Integrator, simulate};
use flexure_runtime::system::EventAction;
use systems::FnSystem;

fn pulled_mass() -> FnSystem {
    let (sigma0, sigma2) = (1e5f64, 0.4);
    let sigma1 = sigma0.sqrt();
    FnSystem::new(
        &[("mass.x", "m"), ("mass.v", "m/s"), ("tip.z", "m")],
        &[0.0; 3],
        move |t, x, _, dx| {
            let v = x[1];
            let g = 1.0 + 0.5 * (-(v / 1e-3).powi(2)).exp();
            let dz = v - sigma0 * v.abs() * x[2] / g;
            dx[0] = v;
            dx[1] = 2.0 * (0.1 * t - x[0]) - (sigma0 * x[2] + sigma1 * dz + sigma2 * v);
            dx[2] = dz;
        },
    )
    .event(|_, x, _| x[1] - 1e-3, |_, _, _| EventAction::Continue)
}

#[test]
fn slips_where_and_when_published() {
    let run = simulate(&pulled_mass())
        .until(25.0)
        .rtol(1e-11)
        .every(1.0)
        .integrator(Integrator::Explicit)
        .run()
        .unwrap();
    let summary = run.summary();
    let [x, v, z] = summary.state[..] else {
        panic!("three states")
    };
    assert!((x - 1.908_839_199_225_48).abs() < 1e-10, "{x:.15}");
    assert!((v - 9.424_154_590_73e-6).abs() < 1e-15, "{v:e}");
    assert!((z - 1.181_679_545_59e-5).abs() < 1e-15, "{z:e}");
    let slips = [7.437_606_657, 13.800_326_478, 20.163_046_299];
    assert_eq!(summary.events.len(), slips.len());
    for (event, slip) in summary.events.iter().zip(slips) {
        assert!((event.time - slip).abs() < 1e-9, "{}", event.time);
    }
    // Statistics of the stiff case: bound by stability, hardly by accuracy.
    assert!(summary.statistics.accepted < 40_000, "{summary:?}");
}

/// Steps that stability does not bind are as accurate as they are asked to be.
#[test]
fn stiff_steps_keep_to_the_tolerance() {
    let run = simulate(&pulled_mass())
        .until(25.0)
        .rtol(1e-11)
        .every(1.0)
        .run()
        .unwrap();
    let summary = run.summary();
    assert!(summary.statistics.stiff > 0, "{summary:?}");
    let largest = [1.91, 0.37, 1.5e-5];
    let expected = [
        1.908_839_199_225_48,
        9.424_154_590_73e-6,
        1.181_679_545_59e-5,
    ];
    for ((value, expected), largest) in summary.state.iter().zip(expected).zip(largest) {
        assert!((value - expected).abs() < 1e-10 * largest, "{value:e}");
    }
}
