//! Dual numbers: a value and its rate of change along one direction.
//!
//! Generated code evaluated with [`Dual`] gives exact derivatives by the chain rule, without the
//! symbolic Jacobian: one is the check of the other.

use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::real::Real;

/// `value + rate·ε` with `ε² = 0`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dual {
    /// The value.
    pub value: f64,
    /// How fast it changes along the chosen direction.
    pub rate: f64,
}

impl Dual {
    /// A number that changes at unit rate: the one that is differentiated by.
    pub fn variable(value: f64) -> Self {
        Self { value, rate: 1.0 }
    }

    fn through(self, value: f64, slope: f64) -> Self {
        // A constant stays one, even where the slope is infinite.
        let rate = if self.rate == 0.0 {
            0.0
        } else {
            slope * self.rate
        };
        Self { value, rate }
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            rate: -self.rate,
        }
    }
}

impl Add for Dual {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            rate: self.rate + other.rate,
        }
    }
}

impl Sub for Dual {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self {
            value: self.value - other.value,
            rate: self.rate - other.rate,
        }
    }
}

impl Mul for Dual {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self {
            value: self.value * other.value,
            rate: self.rate * other.value + self.value * other.rate,
        }
    }
}

impl Div for Dual {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self {
            value,
            rate: (self.rate - value * other.rate) / other.value,
        }
    }
}

impl Add<f64> for Dual {
    type Output = Self;
    fn add(self, other: f64) -> Self {
        self + Self::from_f64(other)
    }
}

impl Sub<f64> for Dual {
    type Output = Self;
    fn sub(self, other: f64) -> Self {
        self - Self::from_f64(other)
    }
}

impl Mul<f64> for Dual {
    type Output = Self;
    fn mul(self, other: f64) -> Self {
        self * Self::from_f64(other)
    }
}

impl Div<f64> for Dual {
    type Output = Self;
    fn div(self, other: f64) -> Self {
        self / Self::from_f64(other)
    }
}

impl Real for Dual {
    fn from_f64(value: f64) -> Self {
        Self { value, rate: 0.0 }
    }
    fn recip(self) -> Self {
        Self::from_f64(1.0) / self
    }
    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.through(root, 0.5 / root)
    }
    fn sin(self) -> Self {
        self.through(Real::sin(self.value), Real::cos(self.value))
    }
    fn cos(self) -> Self {
        self.through(Real::cos(self.value), -Real::sin(self.value))
    }
    fn sin_cos(self) -> (Self, Self) {
        (Real::sin(self), Real::cos(self))
    }
    fn tan(self) -> Self {
        let tan = Real::tan(self.value);
        self.through(tan, 1.0 + tan * tan)
    }
    fn asin(self) -> Self {
        let slope = 1.0 / (1.0 - self.value * self.value).sqrt();
        self.through(Real::asin(self.value), slope)
    }
    fn acos(self) -> Self {
        let slope = -1.0 / (1.0 - self.value * self.value).sqrt();
        self.through(Real::acos(self.value), slope)
    }
    fn atan(self) -> Self {
        self.through(
            Real::atan(self.value),
            1.0 / (1.0 + self.value * self.value),
        )
    }
    fn tanh(self) -> Self {
        let tanh = Real::tanh(self.value);
        self.through(tanh, 1.0 - tanh * tanh)
    }
    fn exp(self) -> Self {
        let exp = Real::exp(self.value);
        self.through(exp, exp)
    }
    fn ln(self) -> Self {
        self.through(Real::ln(self.value), 1.0 / self.value)
    }
    fn abs(self) -> Self {
        self.through(Real::abs(self.value), Real::sign(self.value))
    }
    fn sign(self) -> Self {
        self.through(Real::sign(self.value), 0.0)
    }
    fn floor(self) -> Self {
        self.through(Real::floor(self.value), 0.0)
    }
    fn atan2(self, x: Self) -> Self {
        let norm = self.value * self.value + x.value * x.value;
        Self {
            value: Real::atan2(self.value, x.value),
            rate: (x.value * self.rate - self.value * x.rate) / norm,
        }
    }
    fn smaller(self, other: Self) -> Self {
        if self.value < other.value {
            self
        } else {
            other
        }
    }
    fn larger(self, other: Self) -> Self {
        if self.value > other.value {
            self
        } else {
            other
        }
    }
    fn power(self, exponent: Self) -> Self {
        let value = self.value.power(exponent.value);
        let mut rate = 0.0;
        if self.rate != 0.0 {
            rate += exponent.value * self.value.power(exponent.value - 1.0) * self.rate;
        }
        if exponent.rate != 0.0 {
            rate += value * Real::ln(self.value) * exponent.rate;
        }
        Self { value, rate }
    }
    fn unwrap_to(self, reference: Self) -> Self {
        Self {
            value: self.value.unwrap_to(reference.value),
            rate: self.rate,
        }
    }
    fn if_positive(self, yes: Self, no: Self) -> Self {
        if self.value > 0.0 { yes } else { no }
    }
    fn lookup(self, table: &[f64]) -> Self {
        Self {
            value: self.value.lookup(table),
            rate: 0.0,
        }
    }
    fn times_plus(self, factor: Self, addend: Self) -> Self {
        self * factor + addend
    }
    fn all_positive(self) -> bool {
        self.value > 0.0
    }
    fn any_positive(self) -> bool {
        self.value > 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each function's rate against a central difference of its value.
    #[test]
    fn rates_are_slopes() {
        type Function = fn(Dual) -> Dual;
        let functions: [(&str, Function); 16] = [
            ("sqrt", Real::sqrt),
            ("sin", Real::sin),
            ("cos", Real::cos),
            ("tan", Real::tan),
            ("asin", Real::asin),
            ("acos", Real::acos),
            ("atan", Real::atan),
            ("tanh", Real::tanh),
            ("exp", Real::exp),
            ("ln", Real::ln),
            ("abs", |x| Real::abs(-x)),
            ("atan2", |x| x.atan2(x * x + Dual::from_f64(0.3))),
            ("power", |x| x.power(x + Dual::from_f64(1.5))),
            ("quotient", |x| (x + Dual::from_f64(2.0)) / (x * x)),
            ("unwrap", |x| x.unwrap_to(Dual::from_f64(20.0))),
            ("choice", |x| {
                (x - Dual::from_f64(0.5)).if_positive(x * x, x * x * x)
            }),
        ];
        for (name, function) in functions {
            for at in [0.21, 0.47, 0.83] {
                let step = 1e-5;
                let slope = (function(Dual::from_f64(at + step)).value
                    - function(Dual::from_f64(at - step)).value)
                    / (2.0 * step);
                let rate = function(Dual::variable(at)).rate;
                assert!(
                    (rate - slope).abs() <= 1e-8 * (1.0 + slope.abs()),
                    "{name} at {at}: {rate} is not {slope}"
                );
            }
        }
    }
}
