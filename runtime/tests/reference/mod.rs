//! Functions to hundreds of digits, by integer arithmetic and their series alone.

use num_bigint::BigInt;

/// A number `value · 2^-bits`.
#[derive(Clone, Debug)]
pub struct Fixed {
    pub value: BigInt,
    pub bits: i64,
}

fn shifted(value: &BigInt, by: i64) -> BigInt {
    if by >= 0 { value << by } else { value >> -by }
}

impl Fixed {
    /// A finite number, exactly as far as `bits` go.
    pub fn new(x: f64, bits: i64) -> Self {
        let (mantissa, exponent) = parts(x);
        Self {
            value: shifted(&BigInt::from(mantissa), exponent + bits),
            bits,
        }
    }

    fn of(value: i64, bits: i64) -> Self {
        Self {
            value: BigInt::from(value) << bits,
            bits,
        }
    }

    fn times(&self, other: &Self) -> Self {
        Self {
            value: (&self.value * &other.value) >> self.bits,
            bits: self.bits,
        }
    }

    fn per(&self, other: &Self) -> Self {
        Self {
            value: (&self.value << self.bits) / &other.value,
            bits: self.bits,
        }
    }

    fn plus(&self, other: &Self) -> Self {
        Self {
            value: &self.value + &other.value,
            bits: self.bits,
        }
    }

    fn minus(&self, other: &Self) -> Self {
        Self {
            value: &self.value - &other.value,
            bits: self.bits,
        }
    }

    fn over(&self, divisor: i64) -> Self {
        Self {
            value: &self.value / divisor,
            bits: self.bits,
        }
    }

    /// Whether nothing but rounding is left.
    fn is_nothing(&self) -> bool {
        self.value.bits() < 2
    }

    fn root(&self) -> Self {
        Self {
            value: (&self.value << self.bits).sqrt(),
            bits: self.bits,
        }
    }

    /// How many units in the last place of this `result` is away, where units are those of numbers
    /// of this size.
    pub fn ulps(&self, result: f64) -> f64 {
        let (mantissa, exponent) = parts(result);
        // The unit is 2^unit.
        let unit = (self.value.bits() as i64 - 53 - self.bits).max(-1074);
        let finer = 20;
        let exact = shifted(&self.value, -self.bits - unit + finer);
        let given = shifted(&BigInt::from(mantissa), exponent - unit + finer);
        let difference: i64 = (exact - given).try_into().unwrap_or(i64::MAX);
        difference.abs() as f64 / f64::from(1 << finer)
    }
}

/// `x = mantissa · 2^exponent`.
fn parts(x: f64) -> (i64, i64) {
    let bits = x.to_bits();
    let exponent = (bits >> 52 & 0x7ff) as i64;
    assert!(exponent < 0x7ff, "{x} is not finite");
    let fraction = (bits & ((1 << 52) - 1)) as i64;
    let mantissa = if exponent == 0 {
        fraction
    } else {
        fraction | 1 << 52
    };
    let sign = if x < 0.0 { -1 } else { 1 };
    (sign * mantissa, exponent.max(1) - 1075)
}

/// Digits that show an error in the last place of what is as small as `x` or 2⁻¹⁰⁰ of it.
pub fn enough(x: f64) -> i64 {
    240 + (-x.abs().log2()).max(0.0) as i64
}

/// atan of the inverse of a whole number.
fn atan_inverse(n: i64, bits: i64) -> Fixed {
    let mut power = Fixed::of(1, bits).over(n);
    let mut sum = power.clone();
    let mut k = 1;
    while !power.is_nothing() {
        power = power.over(-n * n);
        k += 2;
        sum = sum.plus(&power.over(k));
    }
    sum
}

/// π by Machin's formula.
pub fn pi(bits: i64) -> Fixed {
    let bits = bits + 20;
    let quarter = Fixed {
        value: atan_inverse(5, bits).value * 4 - atan_inverse(239, bits).value,
        bits,
    };
    Fixed {
        value: (quarter.value * 4) >> 20,
        bits: bits - 20,
    }
}

/// ln 2 = 2 artanh 1/3.
fn ln_2(bits: i64) -> Fixed {
    let mut power = Fixed::of(2, bits).over(3);
    let mut sum = power.clone();
    let mut k = 1;
    while !power.is_nothing() {
        power = power.over(9);
        k += 2;
        sum = sum.plus(&power.over(k));
    }
    sum
}

/// The constants, computed once.
pub struct Reference {
    pi: Fixed,
    ln_2: Fixed,
}

impl Reference {
    pub fn new() -> Self {
        Self {
            pi: pi(5000),
            ln_2: ln_2(2600),
        }
    }

    fn cut(constant: &Fixed, bits: i64) -> Fixed {
        Fixed {
            value: &constant.value >> (constant.bits - bits),
            bits,
        }
    }

    /// Sine and cosine.
    pub fn sin_cos(&self, x: f64) -> (Fixed, Fixed) {
        // As many digits again as the number of turns has.
        let bits = enough(x) + x.abs().log2().max(0.0) as i64;
        let half_pi = Self::cut(&self.pi, bits).over(2);
        let x = Fixed::new(x, bits);
        let quarters: BigInt = &x.value / &half_pi.value;
        let angle = x.minus(&Fixed {
            value: &half_pi.value * &quarters,
            bits,
        });
        let quarter: i64 = (&quarters % 4i64).try_into().unwrap();
        let square = angle.times(&angle);
        let series = |mut term: Fixed, mut k: i64| {
            let mut sum = term.clone();
            while !term.is_nothing() {
                term = term.times(&square).over(-(k + 1) * (k + 2));
                k += 2;
                sum = sum.plus(&term);
            }
            sum
        };
        let (sin, cos) = (series(angle.clone(), 1), series(Fixed::of(1, bits), 0));
        let zero = Fixed::of(0, bits);
        match quarter.rem_euclid(4) {
            0 => (sin, cos),
            1 => (cos, zero.minus(&sin)),
            2 => (zero.minus(&sin), zero.minus(&cos)),
            _ => (zero.minus(&cos), sin),
        }
    }

    fn exp_fixed(&self, x: &Fixed) -> Fixed {
        let bits = x.bits;
        let ln_2 = Self::cut(&self.ln_2, bits);
        let n: i64 = (&x.value / &ln_2.value).try_into().unwrap();
        let r = x.minus(&Fixed {
            value: &ln_2.value * n,
            bits,
        });
        let mut term = Fixed::of(1, bits);
        let mut sum = term.clone();
        let mut k = 0;
        while !term.is_nothing() {
            k += 1;
            term = term.times(&r).over(k);
            sum = sum.plus(&term);
        }
        // The digits move with the exponent, so that none is lost.
        Fixed {
            value: sum.value,
            bits: bits - n,
        }
    }

    /// √x of a positive number.
    pub fn sqrt(&self, x: f64) -> Fixed {
        Fixed::new(x, enough(x)).root()
    }

    /// e to the power `x`.
    pub fn exp(&self, x: f64) -> Fixed {
        self.exp_fixed(&Fixed::new(x, enough(x).min(1400)))
    }

    fn atan_fixed(x: &Fixed) -> Fixed {
        // Halved until the series is short: atan x = 2 atan(x / (1 + √(1 + x²))).
        let one = Fixed::of(1, x.bits);
        let mut x = x.clone();
        let halvings = 8;
        for _ in 0..halvings {
            let root = one.plus(&x.times(&x)).root();
            x = x.per(&one.plus(&root));
        }
        let square = x.times(&x);
        let mut power = x.clone();
        let mut sum = x;
        let mut k = 1;
        while !power.is_nothing() {
            power = power.times(&square);
            power.value = -power.value;
            k += 2;
            sum = sum.plus(&power.over(k));
        }
        sum.value <<= halvings;
        sum
    }

    /// Direction of the vector (`x`, `y`).
    pub fn atan2(&self, y: f64, x: f64) -> Fixed {
        // Enough for the quotient, and for what it is of.
        let bits = enough(y) + enough(x) + (y.abs() / x.abs()).log2().abs().min(2100.0) as i64;
        let (y_fixed, x_fixed) = (Fixed::new(y.abs(), bits), Fixed::new(x.abs(), bits));
        let pi = Self::cut(&self.pi, bits);
        let acute = if y.abs() <= x.abs() {
            Self::atan_fixed(&y_fixed.per(&x_fixed))
        } else {
            pi.over(2).minus(&Self::atan_fixed(&x_fixed.per(&y_fixed)))
        };
        let obtuse = if x < 0.0 { pi.minus(&acute) } else { acute };
        Fixed {
            value: if y < 0.0 { -obtuse.value } else { obtuse.value },
            bits,
        }
    }

    fn ln_fixed(&self, x: f64, bits: i64) -> Fixed {
        let n = x.log2().round() as i64;
        let (mantissa, exponent) = parts(x);
        let m = Fixed {
            value: shifted(&BigInt::from(mantissa), exponent - n + bits),
            bits,
        };
        let one = Fixed::of(1, bits);
        let s = m.minus(&one).per(&m.plus(&one));
        let square = s.times(&s);
        let mut power = s.clone();
        let mut sum = s;
        let mut k = 1;
        while !power.is_nothing() {
            power = power.times(&square);
            k += 2;
            sum = sum.plus(&power.over(k));
        }
        Fixed {
            value: sum.value * 2 + Self::cut(&self.ln_2, bits).value * n,
            bits,
        }
    }

    /// Natural logarithm of a positive number.
    pub fn ln(&self, x: f64) -> Fixed {
        self.ln_fixed(x, 400)
    }

    /// `x` to the power `y`, of a positive number.
    pub fn power(&self, x: f64, y: f64) -> Fixed {
        let bits = 1400;
        let exponent = Fixed::new(y, bits).times(&self.ln_fixed(x, bits));
        self.exp_fixed(&exponent)
    }

    /// Hyperbolic tangent.
    pub fn tanh(&self, x: f64) -> Fixed {
        let bits = enough(x) + 150;
        let twice = Fixed::new(2.0 * x, bits);
        let e = self.exp_fixed(&twice);
        let e = Fixed {
            value: shifted(&e.value, bits - e.bits),
            bits,
        };
        let one = Fixed::of(1, bits);
        e.minus(&one).per(&e.plus(&one))
    }

    /// Tangent.
    pub fn tan(&self, x: f64) -> Fixed {
        let (sin, cos) = self.sin_cos(x);
        sin.per(&cos)
    }

    /// Angle whose sine is `x`.
    pub fn asin(&self, x: f64) -> Fixed {
        let bits = 500 + enough(x);
        let one = Fixed::of(1, bits);
        let x_fixed = Fixed::new(x.abs(), bits);
        let leg = one.minus(&x_fixed.times(&x_fixed)).root();
        let pi = Self::cut(&self.pi, bits);
        let acute = if x_fixed.value < leg.value {
            Self::atan_fixed(&x_fixed.per(&leg))
        } else {
            pi.over(2).minus(&Self::atan_fixed(&leg.per(&x_fixed)))
        };
        Fixed {
            value: if x < 0.0 { -acute.value } else { acute.value },
            bits,
        }
    }

    /// Angle whose cosine is `x`.
    pub fn acos(&self, x: f64) -> Fixed {
        let asin = self.asin(x);
        Self::cut(&self.pi, asin.bits).over(2).minus(&asin)
    }
}
