//! Numbers as exact decimals, and numbers with units as they stand on a command line.

use std::fmt;

use num_bigint::BigInt;
use num_traits::{ToPrimitive, Zero};

use super::unit::power_of_ten;
use super::{Dimension, Unit};
use crate::symbolic::Rational;

/// Longest number that is read, in characters.
const LONGEST_NUMBER: usize = 800;

/// Why a number cannot be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NumberError {
    /// It is no decimal number.
    Malformed,
    /// Its magnitude is above the largest double.
    TooLarge,
    /// It is not zero, yet below the smallest double.
    TooSmall,
    /// It has too many digits.
    TooLong,
}

impl fmt::Display for NumberError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            NumberError::Malformed => "this is no decimal number",
            NumberError::TooLarge => "this number is too large: its magnitude may reach 1.79e308",
            NumberError::TooSmall => {
                "this number is too small: its magnitude may go down to 5e-324"
            }
            NumberError::TooLong => "this number has more digits than any measurement",
        })
    }
}

/// The exact value of a decimal number without a sign: `3.6e6`.
pub(crate) fn exact_decimal(text: &str) -> Result<Rational, NumberError> {
    if text.len() > LONGEST_NUMBER {
        return Err(NumberError::TooLong);
    }
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent),
        None => (text, "0"),
    };
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let all_digits = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
    let exponent_digits = exponent.trim_start_matches(['+', '-']);
    let well_formed = !whole.is_empty()
        && all_digits(whole)
        && all_digits(fraction)
        && (fraction.is_empty() != mantissa.contains('.'))
        && !exponent_digits.is_empty()
        && exponent.len() - exponent_digits.len() <= 1
        && all_digits(exponent_digits);
    if !well_formed {
        return Err(NumberError::Malformed);
    }
    let digits: BigInt = format!("{whole}{fraction}")
        .parse()
        .map_err(|_| NumberError::Malformed)?;
    if digits.is_zero() {
        return Ok(Rational::zero());
    }
    let double: f64 = text.parse().map_err(|_| NumberError::Malformed)?;
    if double.is_infinite() {
        return Err(NumberError::TooLarge);
    }
    if double == 0.0 {
        return Err(NumberError::TooSmall);
    }
    let exponent: i32 = exponent.parse().map_err(|_| NumberError::TooLarge)?;
    let fraction_digits = i32::try_from(fraction.len()).map_err(|_| NumberError::TooLong)?;
    Ok(Rational::from_integer(digits) * power_of_ten(exponent - fraction_digits))
}

/// Reads a quantity such as `15N`, `20 ms`, `-5 um` or `0.3`: its value in SI, and its dimension if
/// it has a unit. A bare number is taken to be in SI.
///
/// The value is exact for units with rational factors; with degrees it is the nearest double.
pub fn parse_quantity(text: &str) -> Result<(Rational, Option<Dimension>), String> {
    let trimmed = text.trim();
    let (negative, unsigned) = match trimmed.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, trimmed.strip_prefix('+').unwrap_or(trimmed)),
    };
    let number_end = end_of_number(unsigned);
    let (number, unit) = (&unsigned[..number_end], unsigned[number_end..].trim_start());
    if number.is_empty() {
        return Err(format!(
            "`{text}` is no quantity: write a number and, if it has one, its unit, as in `15N` or `20 ms`"
        ));
    }
    let mut value = exact_decimal(number).map_err(|error| format!("`{text}`: {error}"))?;
    if negative {
        value = -value;
    }
    if unit.is_empty() {
        return Ok((value, None));
    }
    let unit = Unit::parse(unit).map_err(|part| format!("`{part}` in `{text}` is no unit"))?;
    value *= &unit.factor;
    if unit.pi_power != 0 {
        let double = value.to_f64().unwrap_or(f64::NAN) * std::f64::consts::PI.powi(unit.pi_power);
        value = Rational::from_float(double)
            .ok_or_else(|| format!("`{text}`: {}", NumberError::TooLarge))?;
    }
    match value.to_f64() {
        Some(double) if double.is_finite() => Ok((value, Some(unit.dimension))),
        _ => Err(format!("`{text}`: {}", NumberError::TooLarge)),
    }
}

/// Where the number at the start of `text` ends: an `e` belongs to it only if digits follow.
fn end_of_number(text: &str) -> usize {
    let bytes = text.as_bytes();
    let digits_from = |start: usize| {
        start
            + bytes[start.min(bytes.len())..]
                .iter()
                .take_while(|byte| byte.is_ascii_digit())
                .count()
    };
    let mut end = digits_from(0);
    if bytes.get(end) == Some(&b'.') {
        end = digits_from(end + 1);
    }
    if matches!(bytes.get(end), Some(b'e' | b'E')) {
        let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
        let exponent_end = digits_from(end + 1 + sign);
        if exponent_end > end + 1 + sign {
            end = exponent_end;
        }
    }
    end
}
