//! The closed list of units, their SI prefixes, and chains such as `N*s/m`.

use num_bigint::BigInt;
use num_traits::{One, Pow};

use super::{Dimension, Mark};
use crate::symbolic::Rational;

/// A unit: an exact factor to SI, times a power of π, and a dimension.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    /// Rational part of the factor to SI.
    pub factor: Rational,
    /// Power of π in the factor to SI: 1 for degrees.
    pub pi_power: i32,
    /// Dimension.
    pub dimension: Dimension,
}

/// One symbol of the list: spelling, whether it takes prefixes, power of ten, dimension as
/// exponents of m, kg, s, A, K.
struct Symbol {
    text: &'static str,
    prefixed: bool,
    ten: i32,
    exponents: [i8; 5],
}

const fn symbol(text: &'static str, prefixed: bool, ten: i32, exponents: [i8; 5]) -> Symbol {
    Symbol {
        text,
        prefixed,
        ten,
        exponents,
    }
}

const SYMBOLS: &[Symbol] = &[
    symbol("m", true, 0, [1, 0, 0, 0, 0]),
    symbol("g", true, -3, [0, 1, 0, 0, 0]),
    symbol("s", true, 0, [0, 0, 1, 0, 0]),
    symbol("A", true, 0, [0, 0, 0, 1, 0]),
    symbol("K", true, 0, [0, 0, 0, 0, 1]),
    symbol("rad", true, 0, [0, 0, 0, 0, 0]),
    symbol("deg", false, 0, [0, 0, 0, 0, 0]),
    symbol("°", false, 0, [0, 0, 0, 0, 0]),
    symbol("%", false, -2, [0, 0, 0, 0, 0]),
    symbol("Hz", true, 0, [0, 0, -1, 0, 0]),
    symbol("N", true, 0, [1, 1, -2, 0, 0]),
    symbol("Pa", true, 0, [-1, 1, -2, 0, 0]),
    symbol("J", true, 0, [2, 1, -2, 0, 0]),
    symbol("W", true, 0, [2, 1, -3, 0, 0]),
    symbol("V", true, 0, [2, 1, -3, -1, 0]),
    symbol("C", true, 0, [0, 0, 1, 1, 0]),
    symbol("F", true, 0, [-2, -1, 4, 2, 0]),
    symbol("ohm", true, 0, [2, 1, -3, -2, 0]),
    symbol("Ω", true, 0, [2, 1, -3, -2, 0]),
    symbol("H", true, 0, [2, 1, -2, -2, 0]),
    symbol("T", true, 0, [0, 1, -2, -1, 0]),
    symbol("Wb", true, 0, [2, 1, -2, -1, 0]),
];

const PREFIXES: &[(&str, i32)] = &[
    ("f", -15),
    ("p", -12),
    ("n", -9),
    ("u", -6),
    ("µ", -6),
    ("μ", -6),
    ("m", -3),
    ("c", -2),
    ("d", -1),
    ("h", 2),
    ("k", 3),
    ("M", 6),
    ("G", 9),
    ("T", 12),
];

impl Unit {
    /// The unit of plain numbers.
    pub fn one() -> Self {
        Self {
            factor: Rational::one(),
            pi_power: 0,
            dimension: Dimension::NONE,
        }
    }

    /// Reads a chain without blanks: `N*s/m`, `mm/s^2`, `kg·m²`. The error is the part that is no
    /// unit.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut unit = Self::one();
        let mut rest = text;
        let mut divide = false;
        let mut angle = false;
        let mut symbols = 0;
        loop {
            let end = rest.find(['*', '/', '·']).unwrap_or(rest.len());
            let (symbol, power) =
                split_power(&rest[..end]).ok_or_else(|| rest[..end].to_owned())?;
            let single = Self::symbol(symbol).ok_or_else(|| symbol.to_owned())?;
            let exponent = if divide { -power } else { power };
            unit = unit
                .times_power(&single, exponent)
                .ok_or_else(|| text.to_owned())?;
            angle |= matches!(base_of(symbol), Some((base, _)) if ["rad", "deg", "°"].contains(&base.text))
                && exponent == 1;
            symbols += 1;
            if end == rest.len() {
                break;
            }
            divide = rest[end..].starts_with('/');
            let sign = rest[end..].chars().next().map_or(0, char::len_utf8);
            rest = &rest[end + sign..];
        }
        if unit.dimension.same_units(Dimension::RATE) {
            if angle {
                unit.dimension = unit.dimension.marked(Mark::AngularRate);
            } else if symbols == 1 && text.ends_with("Hz") {
                unit.dimension = unit.dimension.marked(Mark::Frequency);
            }
        }
        Ok(unit)
    }

    /// One symbol with its prefix.
    fn symbol(text: &str) -> Option<Self> {
        let (base, prefix) = base_of(text)?;
        let degrees = ["deg", "°"].contains(&base.text);
        let mut unit = Self {
            factor: power_of_ten(base.ten + prefix),
            pi_power: i32::from(degrees),
            dimension: Dimension::NONE,
        };
        if degrees {
            unit.factor /= Rational::from_integer(180.into());
        }
        let bases = [
            Dimension::LENGTH,
            Dimension::MASS,
            Dimension::TIME,
            Dimension::CURRENT,
            Dimension::TEMPERATURE,
        ];
        for (dimension, &exponent) in bases.into_iter().zip(&base.exponents) {
            let power = dimension.power(&Rational::from_integer(exponent.into()))?;
            unit.dimension = unit.dimension.times(power)?;
        }
        Some(unit)
    }

    fn times_power(&self, other: &Self, exponent: i32) -> Option<Self> {
        let whole = Rational::from_integer(exponent.into());
        Some(Self {
            factor: &self.factor * Pow::pow(&other.factor, exponent),
            pi_power: self.pi_power + other.pi_power * exponent,
            dimension: self.dimension.times(other.dimension.power(&whole)?)?,
        })
    }

    /// Units whose spelling is close to `text`, for suggestions.
    pub(crate) fn spellings() -> impl Iterator<Item = String> {
        SYMBOLS.iter().flat_map(|symbol| {
            let bare = std::iter::once(symbol.text.to_owned());
            let prefixed = PREFIXES
                .iter()
                .filter(|_| symbol.prefixed)
                .map(|(prefix, _)| format!("{prefix}{}", symbol.text));
            bare.chain(prefixed)
        })
    }
}

fn base_of(text: &str) -> Option<(&'static Symbol, i32)> {
    if let Some(bare) = SYMBOLS.iter().find(|symbol| symbol.text == text) {
        return Some((bare, 0));
    }
    PREFIXES.iter().find_map(|&(prefix, ten)| {
        let rest = text.strip_prefix(prefix)?;
        let base = SYMBOLS
            .iter()
            .find(|symbol| symbol.prefixed && symbol.text == rest)?;
        Some((base, ten))
    })
}

/// `mm^2` or `mm²` as symbol and power.
fn split_power(text: &str) -> Option<(&str, i32)> {
    for (mark, power) in [("²", 2), ("³", 3)] {
        if let Some(symbol) = text.strip_suffix(mark) {
            return Some((symbol, power));
        }
    }
    match text.split_once('^') {
        None => Some((text, 1)),
        Some((symbol, power)) => {
            let power: i32 = power.parse().ok()?;
            (power.abs() <= 12).then_some((symbol, power))
        }
    }
}

pub(super) fn power_of_ten(exponent: i32) -> Rational {
    let magnitude = Pow::pow(BigInt::from(10), exponent.unsigned_abs());
    if exponent < 0 {
        Rational::new(BigInt::one(), magnitude)
    } else {
        Rational::from_integer(magnitude)
    }
}
