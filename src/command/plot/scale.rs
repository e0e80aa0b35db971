//! Numbers as engineers read them: SI prefixes, round ticks, values with units.

/// A unit for display: divide an SI value by `factor` to count in it.
#[derive(Clone, Debug, PartialEq)]
pub struct DisplayUnit {
    /// What it is called: `µm`, `mm/s`, `°`; empty for a plain number.
    pub name: String,
    /// Size of one of it in SI.
    pub factor: f64,
}

const PREFIXES: [(i32, &str); 9] = [
    (-12, "p"),
    (-9, "n"),
    (-6, "µ"),
    (-3, "m"),
    (0, ""),
    (3, "k"),
    (6, "M"),
    (9, "G"),
    (12, "T"),
];

/// Units that take a prefix when they stand first and to the first power.
const PREFIXED: [&str; 13] = [
    "m", "g", "s", "N", "rad", "Pa", "J", "W", "V", "A", "Hz", "C", "F",
];

/// The unit in which values up to `magnitude` (in SI) read best.
pub fn display_unit(si_unit: &str, magnitude: f64) -> DisplayUnit {
    let pretty = pretty_unit(si_unit);
    if pretty.is_empty() {
        return DisplayUnit {
            name: pretty,
            factor: 1.0,
        };
    }
    let (rest, base) = match pretty.strip_prefix("kg") {
        // Prefixes go with the gram; a compound unit keeps its kilogram.
        Some("") => ("g".to_owned(), 1e-3),
        Some(_) => {
            return DisplayUnit {
                name: pretty,
                factor: 1.0,
            };
        }
        None => (pretty, 1.0),
    };
    let first_end = rest.find(['·', '/']).unwrap_or(rest.len());
    let plain = PREFIXED.contains(&&rest[..first_end]);
    let magnitude = magnitude.abs() / base;
    let exponent = if plain && magnitude > 0.0 && magnitude.is_finite() {
        // A hair above a power of ten still counts as that power: 0.9999999 mm is 1 mm.
        let thousands = ((magnitude * (1.0 + 1e-9)).log10() / 3.0).floor() as i32;
        // 0.294 N·s/m reads better than 294 mN·s/m; velocities are at home in mm/s.
        let compound = first_end < rest.len() && rest != "m/s";
        match 3 * thousands {
            -3 if compound => 0,
            exponent => exponent.clamp(-12, 12),
        }
    } else if base != 1.0 {
        3
    } else {
        0
    };
    let largest = if rest.starts_with("rad") || rest.starts_with('s') {
        0
    } else {
        12
    };
    let exponent = exponent.min(largest);
    let prefix = PREFIXES
        .iter()
        .find(|(power, _)| *power == exponent)
        .map_or("", |(_, prefix)| prefix);
    DisplayUnit {
        name: format!("{prefix}{rest}"),
        factor: base * 10f64.powi(exponent),
    }
}

/// Degrees, for angles in rad.
pub fn degrees() -> DisplayUnit {
    DisplayUnit {
        name: "°".to_owned(),
        factor: std::f64::consts::PI / 180.0,
    }
}

/// A unit as it is typeset: `N*m/rad` is `N·m/rad`, `1` is nothing, `m^2` is `m²`.
pub fn pretty_unit(si_unit: &str) -> String {
    if si_unit == "1" {
        return String::new();
    }
    let mut pretty = String::new();
    let mut raised = false;
    for c in si_unit.chars() {
        match c {
            '*' => pretty.push('·'),
            '^' => {
                raised = true;
                continue;
            }
            '-' if raised => {
                pretty.push('⁻');
                continue;
            }
            digit @ '0'..='9' if raised => {
                let superscripts = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
                pretty.push(superscripts[digit as usize - '0' as usize]);
                continue;
            }
            other => pretty.push(other),
        }
        raised = false;
    }
    pretty
}

/// `20 µm`, `72 GPa`, `0.3`: with at most `digits` significant digits, without trailing zeros.
pub fn with_unit(value: f64, si_unit: &str, digits: usize) -> String {
    let unit = display_unit(si_unit, value);
    let number = number(value / unit.factor, digits);
    match unit.name.as_str() {
        "" => number,
        name => format!("{number} {name}"),
    }
}

/// A number with at most `digits` significant digits, without trailing zeros; a true minus sign.
pub fn number(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return value.to_string().replace('-', "−");
    }
    let scientific = format!("{:.*e}", digits.max(1) - 1, value);
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let text = if (-4..digits.max(6) as i32).contains(&exponent) {
        let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
        without_trailing_zeros(&format!("{value:.decimals$}")).to_owned()
    } else {
        format!("{}e{exponent}", without_trailing_zeros(mantissa))
    };
    text.replace('-', "−")
}

fn without_trailing_zeros(text: &str) -> &str {
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        text
    }
}

/// An axis: its range and the values that get a tick, all in display units.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// Lower end.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// Ticks, ascending, within the range.
    pub ticks: Vec<f64>,
    /// Decimals that tell the ticks apart.
    pub decimals: usize,
}

impl Axis {
    /// An axis for values from `low` to `high` with about `count` ticks; `margin` is the share of
    /// the range left free at each end.
    pub fn new(low: f64, high: f64, count: usize, margin: f64) -> Self {
        let (mut low, mut high) = if low.is_finite() && high.is_finite() && low <= high {
            (low, high)
        } else {
            (0.0, 1.0)
        };
        let size = low.abs().max(high.abs());
        if high - low <= 1e-9 * size || high == low {
            let half = if size > 0.0 { 0.1 * size } else { 1.0 };
            (low, high) = (low - half, high + half);
        }
        let spare = margin * (high - low);
        (low, high) = (low - spare, high + spare);
        let step = round_step((high - low) / count.max(1) as f64);
        let first = (low / step - 1e-9).ceil();
        let last = (high / step + 1e-9).floor();
        let steps = (last - first).clamp(0.0, 100.0) as usize;
        let ticks = (0..=steps).map(|k| (first + k as f64) * step).collect();
        let decimals = (-(step.log10() + 1e-9).floor()).clamp(0.0, 12.0) as usize;
        Self {
            low,
            high,
            ticks,
            decimals,
        }
    }

    /// The label of a tick.
    pub fn label(&self, tick: f64) -> String {
        let text = format!("{:.*}", self.decimals, tick);
        let zero = text.chars().all(|c| matches!(c, '-' | '0' | '.'));
        if zero { "0".to_owned() } else { text }.replace('-', "−")
    }

    /// Where a value lies between the ends: 0 at the lower, 1 at the upper.
    pub fn share(&self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }
}

/// The next of 1, 2, 5 times a power of ten that is at least `raw`.
pub fn round_step(raw: f64) -> f64 {
    let power = 10f64.powf(raw.log10().floor());
    let mantissa = raw / power;
    let round = [1.0, 2.0, 5.0]
        .into_iter()
        .find(|candidate| mantissa <= candidate * (1.0 + 1e-9))
        .unwrap_or(10.0);
    round * power
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prefixes_fit_the_magnitude() {
        assert_eq!(with_unit(20e-6, "m", 6), "20 µm");
        assert_eq!(with_unit(72e9, "Pa", 6), "72 GPa");
        assert_eq!(with_unit(0.2568e-3, "kg", 6), "256.8 mg");
        assert_eq!(with_unit(0.05, "kg", 6), "50 g");
        assert_eq!(with_unit(0.0, "kg", 6), "0 kg");
        assert_eq!(with_unit(3.6e6, "N/m", 6), "3.6 MN/m");
        assert_eq!(with_unit(-9.81, "m/s^2", 6), "−9.81 m/s²");
        assert_eq!(with_unit(8.0e-8, "kg*m^2", 6), "8e−8 kg·m²");
        assert_eq!(with_unit(0.3, "1", 6), "0.3");
        assert_eq!(with_unit(0.294, "N*s/m", 6), "0.294 N·s/m");
        assert_eq!(with_unit(0.009, "m/s", 6), "9 mm/s");
        assert_eq!(with_unit(2000.0, "rad/s", 6), "2000 rad/s");
        assert_eq!(with_unit(1e-3 * (1.0 - 1e-12), "m", 6), "1 mm");
        assert_eq!(with_unit(f64::INFINITY, "m", 6), "inf m");
    }

    #[test]
    fn ticks_are_round_and_few() {
        let axis = Axis::new(0.0, 175.0, 5, 0.05);
        assert_eq!(axis.ticks, [0.0, 50.0, 100.0, 150.0]);
        assert_eq!(axis.label(50.0), "50");
        let axis = Axis::new(0.0, 1.0, 5, 0.0);
        assert_eq!(axis.ticks.len(), 6);
        assert_eq!(axis.label(axis.ticks[1]), "0.2");
        assert_eq!(axis.label(-0.0), "0");
    }

    #[test]
    fn degenerate_ranges_still_give_an_axis() {
        for (low, high) in [
            (3.0, 3.0),
            (0.0, 0.0),
            (f64::NAN, 1.0),
            (f64::NEG_INFINITY, 0.0),
            (1e300, 1e300),
            (2.0, 1.0),
        ] {
            let axis = Axis::new(low, high, 5, 0.05);
            assert!(axis.low < axis.high, "{low} {high}");
            assert!((2..20).contains(&axis.ticks.len()), "{axis:?}");
        }
    }
}
