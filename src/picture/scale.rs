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
        let thousands = ((magnitude * (1.0 + 1e-9)).log10() / 3.0).floor();
        let thousands = thousands.clamp(-5.0, 5.0) as i32;
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

/// An axis as drawn: its range and the values that get a tick, all in display units.
#[derive(Clone, Debug, PartialEq)]
pub struct Scale {
    /// Lower end; its decimal logarithm on a logarithmic scale.
    pub low: f64,
    /// Upper end, likewise.
    pub high: f64,
    /// Ticks, ascending, within the range, and how each is labelled; some have no label.
    pub ticks: Vec<(f64, String)>,
    /// Whether equal ratios take equal lengths.
    pub logarithmic: bool,
}

/// Larger numbers are not told apart in pictures, and sums of them stay numbers.
const LARGEST: f64 = 1e300;
/// Ranges that are smaller are none.
const SMALLEST: f64 = 1e-300;

impl Scale {
    /// A scale for values from `low` to `high` with about `count` ticks; `margin` is the share of
    /// the range left free at each end.
    pub fn linear(low: f64, high: f64, count: usize, margin: f64) -> Self {
        let (mut low, mut high) = if low.is_finite() && high.is_finite() && low <= high {
            (low.max(-LARGEST), high.min(LARGEST))
        } else {
            (0.0, 1.0)
        };
        let size = low.abs().max(high.abs());
        if high - low <= f64::max(1e-9 * size, SMALLEST) {
            let half = if size > 0.0 { 0.1 * size } else { 1.0 };
            let half = if half < SMALLEST { 1.0 } else { half };
            (low, high) = (low - half, high + half);
        }
        let spare = margin * (high - low);
        (low, high) = (low - spare, high + spare);
        let step = round_step((high - low) / count.max(1) as f64);
        let first = (low / step - 1e-9).ceil();
        let last = (high / step + 1e-9).floor();
        let steps = (last - first).clamp(0.0, 100.0) as usize;
        let largest = low.abs().max(high.abs());
        let ticks = (0..=steps)
            .map(|k| {
                let tick = (first + k as f64) * step;
                (tick, tick_label(tick, step, largest))
            })
            .collect();
        Self {
            low,
            high,
            ticks,
            logarithmic: false,
        }
    }

    /// A scale of equal ratios for values from `low` to `high`, both above zero, with at most
    /// about `count` labels.
    pub fn logarithmic(low: f64, high: f64, count: usize) -> Self {
        let well = low > 0.0 && high.is_finite() && low <= high;
        let (low, high) = if well { (low, high) } else { (1.0, 10.0) };
        let (mut from, mut to) = (low.log10(), high.log10());
        if to - from < 0.3 {
            (from, to) = (from - 0.15, to + 0.15);
        }
        let decades = to - from;
        let (first, last) = ((from - 1e-9).ceil() as i32, (to + 1e-9).floor() as i32);
        let every = (decades / count.max(1) as f64).ceil().max(1.0) as i32;
        // Which multiples of powers of ten have a label, for want of whole powers.
        let labelled: &[i32] = match decades {
            d if d < 1.3 => &[1, 2, 3, 5, 7],
            d if d < 2.6 => &[1, 2, 5],
            _ => &[1],
        };
        let mut ticks = Vec::new();
        for power in first - 1..=last {
            for multiple in 1..10 {
                let value = f64::from(multiple) * 10f64.powi(power);
                let at = value.log10();
                let is_inside = at >= from - 1e-9 && at <= to + 1e-9;
                if !is_inside || (decades > 6.0 && multiple > 1) {
                    continue;
                }
                let has_label = labelled.contains(&multiple) && power.rem_euclid(every) == 0;
                let label = if has_label {
                    engineering(value)
                } else {
                    String::new()
                };
                ticks.push((value, label));
            }
        }
        Self {
            low: from,
            high: to,
            ticks,
            logarithmic: true,
        }
    }

    /// Where a value lies between the ends: 0 at the lower, 1 at the upper; not a number where it
    /// has no place.
    pub fn share(&self, value: f64) -> f64 {
        let at = match self.logarithmic {
            true if value > 0.0 => value.log10(),
            true => return f64::NAN,
            false => value,
        };
        (at - self.low) / (self.high - self.low)
    }
}

/// The label of a tick among others that are `step` apart and up to `largest` in size.
fn tick_label(tick: f64, step: f64, largest: f64) -> String {
    if tick.abs() < 1e-6 * step {
        return "0".to_owned();
    }
    if largest >= 1e7 || step < 1e-6 {
        let digits = (largest / step).log10().ceil().clamp(0.0, 14.0) as usize + 1;
        return number(tick, digits);
    }
    let decimals = (-(step.log10() + 1e-9).floor()).clamp(0.0, 12.0) as usize;
    format!("{tick:.decimals$}").replace('-', "−")
}

/// A power of ten, or a small multiple of one, with the SI prefix as a letter: `20k`, `5µ`.
fn engineering(value: f64) -> String {
    let thousands = (value.log10() / 3.0 + 1e-9).floor() as i32 * 3;
    match PREFIXES.iter().find(|(power, _)| *power == thousands) {
        Some((power, prefix)) => format!("{}{prefix}", number(value / 10f64.powi(*power), 3)),
        None => number(value, 3),
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
        let axis = Scale::linear(0.0, 175.0, 5, 0.05);
        let labels: Vec<_> = axis.ticks.iter().map(|(_, label)| label.as_str()).collect();
        assert_eq!(labels, ["0", "50", "100", "150"]);
        let axis = Scale::linear(0.0, 1.0, 5, 0.0);
        assert_eq!(axis.ticks.len(), 6);
        assert_eq!(axis.ticks[1].1, "0.2");
        let axis = Scale::linear(-1e9, 1e9, 4, 0.0);
        assert_eq!(axis.ticks[0].1, "−1e9");
    }

    #[test]
    fn degenerate_ranges_still_give_an_axis() {
        for (low, high) in [
            (3.0, 3.0),
            (0.0, 0.0),
            (f64::NAN, 1.0),
            (f64::NEG_INFINITY, 0.0),
            (1e300, 1e300),
            (f64::MIN, f64::MAX),
            (0.0, f64::MAX),
            (5e-324, 5e-324),
            (0.0, 5e-324),
            (2.0, 1.0),
        ] {
            let axis = Scale::linear(low, high, 5, 0.05);
            assert!(axis.low < axis.high, "{low} {high}");
            assert!((2..20).contains(&axis.ticks.len()), "{axis:?}");
        }
    }

    #[test]
    fn ratios_get_decades_with_prefixes() {
        let labels = |low, high| -> Vec<String> {
            let scale = Scale::logarithmic(low, high, 8);
            let labels = scale.ticks.into_iter().map(|(_, label)| label);
            labels.filter(|label| !label.is_empty()).collect()
        };
        assert_eq!(labels(10.0, 100e3), ["10", "100", "1k", "10k", "100k"]);
        assert_eq!(
            labels(100.0, 2000.0),
            ["100", "200", "300", "500", "700", "1k", "2k"][..]
                .iter()
                .filter(|l| !["300", "700"].contains(l))
                .copied()
                .collect::<Vec<_>>()
        );
        assert_eq!(labels(1e-6, 1e-3), ["1µ", "10µ", "100µ", "1m"]);
        for (low, high) in [
            (0.0, 1.0),
            (-1.0, 1.0),
            (f64::NAN, 1.0),
            (1.0, f64::INFINITY),
        ] {
            assert!(!labels(low, high).is_empty(), "{low} {high}");
        }
        for (low, high) in [(5e-324, f64::MAX), (3.0, 3.0), (1e-300, 1e300)] {
            let count = labels(low, high).len();
            assert!((1..12).contains(&count), "{low} {high} {count}");
        }
        assert!(Scale::logarithmic(1.0, 10.0, 8).share(0.0).is_nan());
    }
}
