//! Whether a driven motion has settled: what the states at the starts of the drive's cycles say.
//!
//! A motion has settled when the state at the start of each cycle repeats: every cycle (periodic) or
//! every n-th (period-n). A state that nothing depends on, such as the position of a slider that is
//! carried along, need not repeat: of it only the change per cycle counts.

/// Settling of a motion, and when to give it up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settle {
    /// States repeat if they differ by less than this times their range within a cycle.
    pub tolerance: f64,
    /// Cycles after which a motion that has not settled is given up.
    pub most_cycles: u32,
}

impl Default for Settle {
    /// A millionth, in 500 cycles.
    fn default() -> Self {
        Self {
            tolerance: 1e-6,
            most_cycles: 500,
        }
    }
}

/// The longest period that is looked for, in cycles of the drive.
pub const LONGEST_PERIOD: u32 = 16;

/// Repetitions in a row that count as settled.
const REPETITIONS: usize = 8;

/// Ranges below this, in SI units, are those of a state at rest.
const REST: f64 = 1e-12;

/// Whether the trajectories of two nearby starts have drifted apart: by more than this share of the
/// range within a cycle.
pub(super) const APART: f64 = 0.1;

/// How a motion repeats.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Repetition {
    /// Number of cycles after which the state is the same again.
    pub period: u32,
    /// The cycle, counted from 0, from whose start on it repeats.
    pub from: u32,
}

/// States at the starts of cycles 0, 1, 2, …, and what is to be known about them.
#[derive(Clone, Debug)]
pub struct Strobes<'a> {
    /// The states, one entry a cycle.
    pub states: Vec<&'a [f64]>,
    /// For each state its range within a cycle.
    pub ranges: &'a [f64],
    /// For each state whether nothing depends on it, so that only its change per cycle counts.
    pub advancing: &'a [bool],
}

impl Strobes<'_> {
    /// How the motion repeats, if it does: with the shortest period, from the earliest cycle from
    /// which on it does so to the end, at least eight times (and twice the period).
    pub fn repetition(&self, tolerance: f64) -> Option<Repetition> {
        (1..=LONGEST_PERIOD as usize).find_map(|period| {
            let count = self.states.len();
            let first = 2 * period;
            let repeats = |&cycle: &usize| self.difference(cycle, period) <= tolerance;
            let times = (first..count).rev().take_while(repeats).count();
            (times >= REPETITIONS.max(first)).then(|| Repetition {
                period: period as u32,
                from: (count - times - period) as u32,
            })
        })
    }

    /// The largest difference of a state at the start of `cycle` from that `period` cycles before.
    fn difference(&self, cycle: usize, period: usize) -> f64 {
        let now = self.states[cycle];
        let before = self.states[cycle - period];
        let earlier = self.states[cycle - 2 * period];
        self.largest(|i| {
            let change = now[i] - before[i];
            if self.advancing[i] {
                change - (before[i] - earlier[i])
            } else {
                change
            }
        })
    }

    /// The largest distance from the trajectory of a nearby start in the last half of the cycles.
    /// Positions that nothing depends on do not count.
    pub fn distance(&self, twin: &[&[f64]]) -> f64 {
        let pairs = self.states.iter().zip(twin).skip(self.states.len() / 2);
        pairs.fold(0.0, |greatest, (a, b)| {
            let here = self.largest(|i| if self.advancing[i] { 0.0 } else { a[i] - b[i] });
            larger(greatest, here)
        })
    }

    /// The largest of the states' `differences` as shares of their ranges.
    fn largest(&self, difference: impl Fn(usize) -> f64) -> f64 {
        let shares = self.ranges.iter().enumerate();
        shares.fold(0.0, |greatest, (i, range)| {
            larger(greatest, difference(i).abs() / range.max(REST))
        })
    }
}

/// The larger of both; not a number if one of them is not.
fn larger(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn judge(states: &[Vec<f64>], advancing: &[bool]) -> Option<Repetition> {
        let ranges = vec![1.0; advancing.len()];
        let strobes = Strobes {
            states: states.iter().map(Vec::as_slice).collect(),
            ranges: &ranges,
            advancing,
        };
        strobes.repetition(1e-6)
    }

    fn cycles(count: u32, state: impl Fn(f64) -> Vec<f64>) -> Vec<Vec<f64>> {
        (0..=count).map(|k| state(f64::from(k))).collect()
    }

    #[test]
    fn a_decaying_transient_is_periodic_from_where_it_no_longer_changes() {
        let found = judge(&cycles(60, |k| vec![2.0 + 0.5_f64.powf(k)]), &[false]).unwrap();
        // 0.5^k − 0.5^(k+1) ≤ 1e-6 from k = 19 on.
        assert_eq!((found.period, found.from), (1, 19));
        let slow = judge(&cycles(60, |k| vec![0.9_f64.powf(k)]), &[false]);
        assert_eq!(slow, None);
    }

    #[test]
    fn a_position_may_advance_if_nothing_depends_on_it() {
        let moving = cycles(40, |k| vec![3e-5 * k, 0.1]);
        assert_eq!(judge(&moving, &[false, false]), None);
        let found = judge(&moving, &[true, false]).unwrap();
        assert_eq!((found.period, found.from), (1, 1));
        let accelerating = cycles(40, |k| vec![3e-5 * k * k, 0.1]);
        assert_eq!(judge(&accelerating, &[true, false]), None);
    }

    #[test]
    fn the_shortest_period_is_found() {
        let found = judge(&cycles(50, |k| vec![(k % 3.0).sqrt()]), &[false]).unwrap();
        assert_eq!((found.period, found.from), (3, 3));
        // Steps of the position that take turns: period 2, though the position never repeats.
        let turns = cycles(50, |k| vec![2.0 * k + k % 2.0]);
        assert_eq!(judge(&turns, &[true]).unwrap().period, 2);
    }

    #[test]
    fn a_few_repetitions_are_not_enough_and_neither_are_lost_numbers() {
        let late = cycles(20, |k| vec![if k < 14.0 { k } else { 14.0 }]);
        assert_eq!(judge(&late, &[false]), None);
        assert_eq!(judge(&cycles(40, |_| vec![f64::NAN]), &[false]), None);
        assert_eq!(judge(&[], &[false]), None);
        assert_eq!(
            judge(&cycles(40, |k| vec![(1.3 * k).sin()]), &[false]),
            None
        );
    }

    #[test]
    fn distance_is_relative_and_leaves_positions_out() {
        let states = cycles(10, |k| vec![k, 0.0]);
        let strobes = Strobes {
            states: states.iter().map(Vec::as_slice).collect(),
            ranges: &[1.0, 2.0],
            advancing: &[true, false],
        };
        let others = cycles(10, |k| vec![2.0 * k, 0.1 * k]);
        let twin: Vec<&[f64]> = others.iter().map(Vec::as_slice).collect();
        assert_eq!(strobes.distance(&twin), 0.5);
        let lost = vec![f64::NAN; 2];
        assert!(strobes.distance(&[lost.as_slice(); 11]).is_nan());
    }
}
