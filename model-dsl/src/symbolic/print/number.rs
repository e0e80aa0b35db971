//! How exact numbers are written: whole numbers, short decimals, fractions.

use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::{Level, Style};
use crate::symbolic::Rational;

/// A number's sign and its magnitude as written.
pub(super) struct Fraction {
    pub(super) negative: bool,
    pub(super) written: Written,
}

/// A magnitude as written.
pub(super) struct Written {
    pub(super) text: String,
    pub(super) level: Level,
}

/// Digits that a decimal may have; longer ones are written as fractions.
const DECIMAL_DIGITS: usize = 17;

/// Digits that a fraction may have; longer ones are rounded.
const FRACTION_DIGITS: u64 = 24;

/// Bits of numbers whose digits are looked at one by one.
const EXACT_BITS: u64 = 8192;

/// The number with its sign apart.
pub(super) fn write(value: &Rational, style: Style) -> Fraction {
    let magnitude = value.abs();
    let (text, level) = if is_fraction(&magnitude) {
        fraction(&magnitude, style)
    } else {
        decimal(&magnitude, style)
    };
    Fraction {
        negative: value.is_negative(),
        written: Written { text, level },
    }
}

/// Whether the number is written with a fraction bar: one half, two ninths, not 0.95.
pub(super) fn is_fraction(value: &Rational) -> bool {
    if value.is_integer() {
        return false;
    }
    let (numerator, denominator) = (value.numer().abs(), value.denom());
    let is_small = numerator < BigInt::from(10) && *denominator < BigInt::from(10);
    if is_small && *denominator != BigInt::from(5) {
        return true;
    }
    let is_power_of_two = denominator.trailing_zeros() == Some(denominator.bits() - 1);
    if is_power_of_two && *denominator <= BigInt::from(64) && numerator < BigInt::from(100) {
        return true;
    }
    let digits = (numerator.bits() + denominator.bits()) * 3 / 10;
    digits <= FRACTION_DIGITS && short_decimal(value).is_none()
}

fn fraction(value: &Rational, style: Style) -> (String, Level) {
    let (numerator, denominator) = (value.numer(), value.denom());
    if style == Style::Latex {
        return (
            format!(r"\frac{{{numerator}}}{{{denominator}}}"),
            Level::Product,
        );
    }
    let glyph = match (numerator.to_u8(), denominator.to_u8()) {
        (Some(1), Some(2)) => Some("½"),
        (Some(1), Some(3)) => Some("⅓"),
        (Some(2), Some(3)) => Some("⅔"),
        (Some(1), Some(4)) => Some("¼"),
        (Some(3), Some(4)) => Some("¾"),
        _ => None,
    };
    match glyph {
        Some(glyph) => (glyph.to_owned(), Level::Power),
        None => (format!("{numerator}/{denominator}"), Level::Product),
    }
}

/// A decimal, rounded to 17 digits where it is longer.
fn decimal(value: &Rational, style: Style) -> (String, Level) {
    if value.is_zero() {
        return ("0".to_owned(), Level::Atom);
    }
    let (digits, exponent) = short_decimal(value).unwrap_or_else(|| rounded(value));
    // `exponent` is that of the first digit.
    let count = digits.len() as i64;
    if (-4..7).contains(&exponent) {
        let text = if exponent < 0 {
            let zeros = "0".repeat((-exponent - 1) as usize);
            format!("0.{zeros}{digits}")
        } else if count <= exponent + 1 {
            let zeros = "0".repeat((exponent + 1 - count) as usize);
            format!("{digits}{zeros}")
        } else {
            let (whole, rest) = digits.split_at((exponent + 1) as usize);
            format!("{whole}.{rest}")
        };
        return (text, Level::Atom);
    }
    let (first, rest) = digits.split_at(1);
    let mantissa = if rest.is_empty() {
        first.to_owned()
    } else {
        format!("{first}.{rest}")
    };
    match style {
        Style::Text => (format!("{mantissa}e{exponent}"), Level::Power),
        Style::Latex if mantissa == "1" => (format!("10^{{{exponent}}}"), Level::Power),
        Style::Latex => (
            format!(r"{mantissa} \cdot 10^{{{exponent}}}"),
            Level::Product,
        ),
    }
}

/// Digits without trailing zeros and the exponent of the first, if there are few and they end.
fn short_decimal(value: &Rational) -> Option<(String, i64)> {
    if value.numer().bits() + value.denom().bits() > EXACT_BITS {
        return None;
    }
    let mut rest = value.denom().clone();
    let twos = strip(&mut rest, 2);
    let fives = strip(&mut rest, 5);
    if !rest.is_one() {
        return None;
    }
    let places = twos.max(fives);
    let scaled = value.numer() * num_traits::pow(BigInt::from(10), places) / value.denom();
    let all = scaled.to_string();
    let digits = all.trim_end_matches('0');
    (digits.len() <= DECIMAL_DIGITS)
        .then(|| (digits.to_owned(), all.len() as i64 - 1 - places as i64))
}

/// Divides `value` by `factor` as often as it goes; how often.
fn strip(value: &mut BigInt, factor: u32) -> usize {
    let mut count = 0;
    while (&*value % factor).is_zero() {
        *value /= factor;
        count += 1;
    }
    count
}

/// The first 17 digits of any positive number and the exponent of the first.
fn rounded(value: &Rational) -> (String, i64) {
    // By bits first, then exactly to the digit.
    let bits = value.numer().bits() as i64 - value.denom().bits() as i64;
    let estimate = (bits as f64 * std::f64::consts::LOG10_2).floor() as i64 - 2;
    let shift = DECIMAL_DIGITS as i64 - estimate;
    let power = num_traits::pow(BigInt::from(10), shift.unsigned_abs() as usize);
    let scaled = if shift >= 0 {
        value.numer() * power / value.denom()
    } else {
        value.numer() / (value.denom() * power)
    };
    let all = scaled.to_string();
    let exponent = all.len() as i64 - 1 - shift;
    let kept = all[..DECIMAL_DIGITS.min(all.len())].trim_end_matches('0');
    (kept.to_owned(), exponent)
}

/// A positive exponent as it stands behind its base; nothing for 1.
pub(super) fn exponent(value: &Rational, style: Style) -> String {
    if value.is_one() {
        return String::new();
    }
    let plain = if value.is_integer() {
        value.numer().to_string()
    } else {
        match short_decimal(value) {
            Some(_) if *value.denom() > BigInt::from(10) => decimal(value, style).0,
            _ => format!("{}/{}", value.numer(), value.denom()),
        }
    };
    match style {
        Style::Latex => format!("^{{{plain}}}"),
        Style::Text if value.is_integer() && plain.len() <= 3 => {
            plain.chars().filter_map(superscript).collect()
        }
        Style::Text if value.is_integer() => format!("^{plain}"),
        Style::Text => format!("^({plain})"),
    }
}

fn superscript(digit: char) -> Option<char> {
    "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(digit.to_digit(10)? as usize)
}
