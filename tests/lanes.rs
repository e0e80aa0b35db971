//! Right-hand sides on lanes: every path, in any company and alone, computes what plain numbers do.

use flexure_models::double_rocker::{Params, Prepared, rhs};
use flexure_runtime::lanes::{
    LaneSystem, Lanes, Path, Task, on_path, on_path_alone, on_path_in_one_register,
};
use flexure_runtime::system::System;
use proptest::prelude::*;

/// Rates of the states of one trajectory each.
struct Rates<'a> {
    designs: &'a [Prepared<f64>],
    states: &'a [[f64; 7]],
    /// Whether each trajectory is one alone; for one lane.
    alone: bool,
}

impl Task for Rates<'_> {
    type Output = Vec<[f64; 7]>;

    #[inline(always)]
    fn run<T: Lanes>(self) -> Vec<[f64; 7]> {
        let mut results = Vec::new();
        for first in (0..self.states.len()).step_by(T::COUNT) {
            let index = |lane: usize| (first + lane).min(self.states.len() - 1);
            let mut prepared = self.designs[first].in_every_lane::<T>();
            for lane in 0..T::COUNT {
                self.designs[index(lane)].put_in_lane(lane, &mut prepared);
            }
            if self.alone {
                prepared = self.designs[first].alone::<T>();
            }
            let x = std::array::from_fn(|i| T::from_entries(|lane| self.states[index(lane)][i]));
            let mut dx = [T::from_f64(0.0); 7];
            let t = T::from_f64(1e-4);
            rhs(t, &x, &prepared.start_discretes, &[], &prepared, &mut dx);
            let count = T::COUNT.min(self.states.len() - first);
            results.extend((0..count).map(|lane| dx.map(|rate| rate.entry(lane))));
        }
        results
    }
}

prop_compose! {
    /// A design near that of the model, and a state that it may pass.
    fn trajectory()(
        l1 in 0.97..1.03,
        l2 in 0.97..1.03,
        preload in 0.1..3.0,
        states in prop::array::uniform7(-1.0..1.0),
    ) -> (Params, [f64; 7]) {
        let nominal = Params::default();
        let design = Params {
            l1: l1 * nominal.l1,
            l2: l2 * nominal.l2,
            Fp: preload * nominal.Fp,
            ..nominal
        };
        let sizes = [0.03, 30.0, 1e-5, 0.1, 1e-3, 0.1, 1e-6];
        let mut x: [f64; 7] = std::array::from_fn(|i| states[i] * sizes[i]);
        x[0] += 80f64.to_radians();
        (design, x)
    }
}

#[test]
fn curves_are_for_trajectories_alone() {
    let design = Params::default().prepare().unwrap();
    let [(quantity, report)] = &design.curves()[..] else {
        panic!("{:?}", design.curves());
    };
    assert_eq!(*quantity, "v");
    // Six times the Stribeck velocity: exp(-36) is rounding.
    assert!((5e-3..8e-3).contains(&report.reach), "{report:?}");
    assert!(
        report.intervals <= 256 && report.error <= 1e-14,
        "{report:?}"
    );
    let at = 1e-4;
    assert!(design.curve_of_per_g_v.at(at).is_none());
    assert!(
        design
            .in_every_lane::<f64>()
            .curve_of_per_g_v
            .at(at)
            .is_none()
    );
    assert!(design.alone::<f64>().curve_of_per_g_v.at(at).is_some());
    let exact = design.exact();
    assert!(exact.curves().is_empty());
    assert!(exact.alone::<f64>().curve_of_per_g_v.at(at).is_none());
}

proptest! {
    #[test]
    fn every_path_agrees_with_plain_numbers(
        trajectories in prop::collection::vec(trajectory(), 1..20),
    ) {
        let designs: Vec<_> =
            trajectories.iter().map(|(design, _)| design.prepare().unwrap()).collect();
        let states: Vec<_> = trajectories.iter().map(|(_, x)| *x).collect();
        let rates = || Rates { designs: &designs, states: &states, alone: false };
        let plain = rates().run::<f64>();
        prop_assert!(plain.iter().flatten().all(|rate| rate.is_finite()));
        prop_assert_eq!(&on_path(Path::Portable, rates()), &plain);
        for path in Path::ALL {
            let lanes = on_path(path, rates());
            prop_assert_eq!(&lanes, &on_path_alone(path, rates()), "{:?}", path);
            let alone = on_path_alone(path, Rates { alone: true, ..rates() });
            prop_assert_eq!(&lanes, &on_path_in_one_register(path, rates()), "{:?}", path);
            // An acceleration is a difference of forces: errors are in proportion to the largest.
            for (ours, plain) in lanes.iter().chain(&alone).zip(plain.iter().chain(&plain)) {
                for (i, scale) in [1.0, 1e7, 1.0, 1e5, 1.0, 1e4, 1.0].into_iter().enumerate() {
                    let difference = (ours[i] - plain[i]).abs();
                    prop_assert!(
                        difference <= 1e-12 * (scale + plain[i].abs()),
                        "rate {} is {} on {:?}, not {}", i, ours[i], path, plain[i]
                    );
                }
            }
        }
    }
}
