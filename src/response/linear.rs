//! The linear regime of a frequency response: the window of frequencies in which speed grows along
//! a line.
//!
//! Nguyen and Nguyen (Machines 2025, 13, 787, table 5) define it as the maximal contiguous window
//! in which speed against frequency fits a line with R² > 0.98. Taken literally that may be a short
//! window, or one at high frequency, by chance; a window that begins at the lowest frequency and has
//! some points is what an engineer means by it. [`DEFINITIONS`] are both, each with two thresholds.
//!
//! R² is the squared correlation of frequency and speed, which is 1 minus the residuals' share of
//! the speed's variance about its mean.

/// What counts as a linear regime.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Definition {
    /// What it is called.
    pub name: &'static str,
    /// Whether the window begins at the lowest frequency.
    pub is_anchored: bool,
    /// R² must be above this.
    pub threshold: f64,
    /// The window has at least so many points. Two lie on a line always, so that fewer than three
    /// say nothing.
    pub least_points: usize,
}

/// The published definition and the anchored one, each with R² above 0.98 and above 0.95.
pub const DEFINITIONS: [Definition; 4] = [
    Definition {
        name: "any window with R² > 0.98",
        is_anchored: false,
        threshold: 0.98,
        least_points: 3,
    },
    Definition {
        name: "any window with R² > 0.95",
        is_anchored: false,
        threshold: 0.95,
        least_points: 3,
    },
    Definition {
        name: "from the lowest with R² > 0.98",
        is_anchored: true,
        threshold: 0.98,
        least_points: 5,
    },
    Definition {
        name: "from the lowest with R² > 0.95",
        is_anchored: true,
        threshold: 0.95,
        least_points: 5,
    },
];

/// A linear regime that was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearRegime {
    /// Its lowest frequency in Hz.
    pub from: f64,
    /// Its highest frequency in Hz: the critical frequency.
    pub to: f64,
    /// Number of points.
    pub points: usize,
    /// Slope of the line, in the speed's unit per Hz: the mean step.
    pub slope: f64,
    /// Speed of the line at 0 Hz.
    pub intercept: f64,
    /// How well the line fits.
    pub r_squared: f64,
    /// Mean of the speeds in the window, v̄_lin.
    pub mean_speed: f64,
}

impl LinearRegime {
    /// Mean of the speeds of another curve in this window; `None` if one of them is missing (not a
    /// number), or if there are none.
    pub fn mean_of(&self, curve: &[(f64, f64)]) -> Option<f64> {
        let inside = curve
            .iter()
            .filter(|p| (self.from..=self.to).contains(&p.0));
        let (count, sum) = inside.fold((0_u32, 0.0), |(n, sum), p| (n + 1, sum + p.1));
        Some(sum / f64::from(count)).filter(|mean| mean.is_finite())
    }
}

/// The linear regime of a curve: its points are frequencies in Hz and speeds, in any order. A point
/// whose speed is not a number has failed: no window goes across it, and none is anchored if it is
/// the lowest. Speeds that are all the same have no R² and make no window.
///
/// Of all windows that fit, the one of the most points; of those the one that fits best.
pub fn linear_regime(curve: &[(f64, f64)], definition: &Definition) -> Option<LinearRegime> {
    let mut points: Vec<(f64, f64)> = curve.to_vec();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let starts = if definition.is_anchored {
        points.len().min(1)
    } else {
        points.len()
    };
    let mut best: Option<LinearRegime> = None;
    for start in 0..starts {
        let mut sums = Sums::default();
        for &(frequency, speed) in &points[start..] {
            if !(frequency.is_finite() && speed.is_finite()) {
                break;
            }
            sums.add(frequency, speed);
            if sums.count < definition.least_points {
                continue;
            }
            let Some(found) = sums.line(points[start].0, frequency) else {
                continue;
            };
            let is_better = best
                .is_none_or(|best| (found.points, found.r_squared) > (best.points, best.r_squared));
            if found.r_squared > definition.threshold && is_better {
                best = Some(found);
            }
        }
    }
    best
}

/// Means and sums of squared deviations of points that come one by one (Welford's recurrence).
#[derive(Default)]
struct Sums {
    count: usize,
    frequency: f64,
    speed: f64,
    greatest: f64,
    ff: f64,
    fv: f64,
    vv: f64,
}

impl Sums {
    fn add(&mut self, frequency: f64, speed: f64) {
        self.count += 1;
        let count = self.count as f64;
        let (df, dv) = (frequency - self.frequency, speed - self.speed);
        self.frequency += df / count;
        self.speed += dv / count;
        self.ff += df * (frequency - self.frequency);
        self.vv += dv * (speed - self.speed);
        self.fv += df * (speed - self.speed);
        self.greatest = self.greatest.max(speed.abs());
    }

    /// The line of least squares, unless frequencies or speeds are all the same up to rounding.
    fn line(&self, from: f64, to: f64) -> Option<LinearRegime> {
        let rounding = 4.0 * f64::EPSILON * self.greatest;
        let is_constant = self.vv <= self.count as f64 * rounding * rounding;
        if is_constant || !(self.ff > 0.0) {
            return None;
        }
        let slope = self.fv / self.ff;
        Some(LinearRegime {
            from,
            to,
            points: self.count,
            slope,
            intercept: self.speed - slope * self.frequency,
            r_squared: slope * (self.fv / self.vv),
            mean_speed: self.speed,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ANY: Definition = DEFINITIONS[0];
    const ANCHORED: Definition = DEFINITIONS[2];

    fn curve(speed: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
        (1..=20)
            .map(|k| 100.0 * f64::from(k))
            .map(|f| (f, speed(f)))
            .collect()
    }

    /// R² by its definition: 1 − residuals / deviations from the mean.
    fn r_squared(points: &[(f64, f64)], regime: &LinearRegime) -> f64 {
        let mean = points.iter().map(|p| p.1).sum::<f64>() / points.len() as f64;
        let square = |value: f64| value * value;
        let residuals: f64 = points
            .iter()
            .map(|p| square(p.1 - regime.intercept - regime.slope * p.0))
            .sum();
        1.0 - residuals / points.iter().map(|p| square(p.1 - mean)).sum::<f64>()
    }

    #[test]
    fn a_line_is_linear_throughout() {
        for definition in &DEFINITIONS {
            let found = linear_regime(&curve(|f| 8e-6 * f - 1e-3), definition).unwrap();
            assert_eq!((found.from, found.to, found.points), (100.0, 2000.0, 20));
            assert!((found.slope - 8e-6).abs() < 1e-18, "{found:?}");
            assert!((found.intercept + 1e-3).abs() < 1e-15, "{found:?}");
            assert!((found.r_squared - 1.0).abs() < 1e-12, "{found:?}");
            assert!((found.mean_speed - 7.4e-3).abs() < 1e-15, "{found:?}");
        }
    }

    /// Rising to 900 Hz, then collapsed, then by chance on a steep line of six points.
    #[test]
    fn the_two_definitions_differ_where_a_line_occurs_by_chance() {
        let speeds = curve(|f| match f {
            f if f <= 500.0 => 1e-5 * f,
            f if f <= 1000.0 => 1e-3 * (f / 1e3 * 7.0).sin(),
            f => 2e-5 * (f - 1e3) - 1e-2,
        });
        let any = linear_regime(&speeds, &ANY).unwrap();
        assert!(any.from >= 1000.0 && any.to == 2000.0, "{any:?}");
        let anchored = linear_regime(&speeds, &ANCHORED).unwrap();
        assert_eq!((anchored.from, anchored.to), (100.0, 500.0));
        assert!((anchored.mean_speed - 3e-3).abs() < 1e-15);
    }

    #[test]
    fn r_squared_is_what_residuals_say_and_the_window_cannot_grow() {
        let speeds = curve(|f| 1e-5 * f + 4e-3 * (f / 300.0).sin());
        for definition in &DEFINITIONS {
            let found = linear_regime(&speeds, definition);
            let Some(found) = found else { continue };
            let inside = |p: &&(f64, f64)| (found.from..=found.to).contains(&p.0);
            let points: Vec<_> = speeds.iter().filter(inside).copied().collect();
            assert_eq!(points.len(), found.points);
            assert!((r_squared(&points, &found) - found.r_squared).abs() < 1e-12);
            assert!(found.r_squared > definition.threshold);
            let mean = points.iter().map(|p| p.1).sum::<f64>() / points.len() as f64;
            assert!((mean - found.mean_speed).abs() < 1e-15);
            // No window with more points fits.
            for size in found.points + 1..=speeds.len() {
                for start in 0..=speeds.len() - size {
                    let window = &speeds[start..start + size];
                    let exact = Definition {
                        least_points: size,
                        ..*definition
                    };
                    let none = linear_regime(window, &exact).is_none();
                    assert!(none || (definition.is_anchored && start > 0));
                }
            }
        }
        assert!(linear_regime(&speeds, &DEFINITIONS[1]).is_some());
    }

    #[test]
    fn the_order_of_points_does_not_matter() {
        let speeds = curve(|f| 1e-5 * f + 4e-3 * (f / 300.0).sin());
        let mut backwards = speeds.clone();
        backwards.reverse();
        for definition in &DEFINITIONS {
            assert_eq!(
                linear_regime(&speeds, definition),
                linear_regime(&backwards, definition)
            );
        }
    }

    #[test]
    fn a_failed_point_ends_a_window() {
        let mut speeds = curve(|f| 1e-5 * f);
        speeds[7].1 = f64::NAN;
        let any = linear_regime(&speeds, &ANY).unwrap();
        assert_eq!((any.from, any.to, any.points), (900.0, 2000.0, 12));
        let anchored = linear_regime(&speeds, &ANCHORED).unwrap();
        assert_eq!((anchored.from, anchored.to), (100.0, 700.0));
        speeds[0].1 = f64::NAN;
        assert_eq!(linear_regime(&speeds, &ANCHORED), None);
        let all_failed: Vec<_> = speeds.iter().map(|p| (p.0, f64::NAN)).collect();
        assert_eq!(linear_regime(&all_failed, &ANY), None);
    }

    #[test]
    fn too_few_points_or_no_variation_are_no_regime() {
        let line = curve(|f| 1e-5 * f);
        assert_eq!(linear_regime(&[], &ANY), None);
        assert_eq!(linear_regime(&line[..2], &ANY), None);
        assert!(linear_regime(&line[..3], &ANY).is_some());
        assert_eq!(linear_regime(&line[..4], &ANCHORED), None);
        assert!(linear_regime(&line[..5], &ANCHORED).is_some());
        for speed in [0.0, 0.1, -3e-9] {
            assert_eq!(linear_regime(&curve(|_| speed), &ANY), None);
        }
        let noisy = curve(|f| 0.1 + f64::EPSILON * 0.1 * (f / 100.0 % 2.0));
        assert_eq!(linear_regime(&noisy, &ANY), None);
        let one_frequency: Vec<_> = (0..9).map(|k| (100.0, f64::from(k))).collect();
        assert_eq!(linear_regime(&one_frequency, &ANY), None);
    }

    #[test]
    fn the_mean_of_another_curve_in_a_window() {
        let found = linear_regime(&curve(|f| 1e-5 * f), &ANCHORED).unwrap();
        let twice = found.mean_of(&curve(|f| 2e-5 * f)).unwrap();
        assert!((twice - 2.0 * found.mean_speed).abs() < 1e-15);
        assert_eq!(found.mean_of(&curve(|_| f64::NAN)), None);
        assert_eq!(found.mean_of(&[]), None);
    }
}
