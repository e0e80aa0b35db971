//! Dimensions: exponents of the SI base units, and what engineers call them.

use num_traits::ToPrimitive;

use crate::symbolic::Rational;

/// Dimension of a quantity: exponents of m, kg, s, A and K. Angles are dimensionless.
///
/// A quantity per second also carries a [`Mark`] if it was written as a frequency or as an angular
/// rate, which SI alone cannot tell apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Dimension {
    /// Exponents of m, kg, s, A, K in twelfths, so that common roots have a place.
    twelfths: [i16; 5],
    /// How a quantity per second was written.
    mark: Mark,
}

/// How a quantity per second was written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Mark {
    /// Neither of the others: fits both.
    #[default]
    Plain,
    /// In Hz: full cycles per second.
    Frequency,
    /// In rad/s or deg/s.
    AngularRate,
}

impl Dimension {
    /// A number or an angle.
    pub const NONE: Self = Self::of(0, 0, 0);
    /// m
    pub const LENGTH: Self = Self::of(1, 0, 0);
    /// kg
    pub const MASS: Self = Self::of(0, 1, 0);
    /// s
    pub const TIME: Self = Self::of(0, 0, 1);
    /// A
    pub const CURRENT: Self = Self {
        twelfths: [0, 0, 0, 12, 0],
        mark: Mark::Plain,
    };
    /// K
    pub const TEMPERATURE: Self = Self {
        twelfths: [0, 0, 0, 0, 12],
        mark: Mark::Plain,
    };
    /// m²
    pub const AREA: Self = Self::of(2, 0, 0);
    /// m/s
    pub const VELOCITY: Self = Self::of(1, 0, -1);
    /// m/s²
    pub const ACCELERATION: Self = Self::of(1, 0, -2);
    /// 1/s
    pub const RATE: Self = Self::of(0, 0, -1);
    /// 1/s, written in Hz
    pub const FREQUENCY: Self = Self::of(0, 0, -1).marked(Mark::Frequency);
    /// 1/s, written in rad/s
    pub const ANGULAR_RATE: Self = Self::of(0, 0, -1).marked(Mark::AngularRate);
    /// N
    pub const FORCE: Self = Self::of(1, 1, -2);
    /// N·m, and N·m/rad
    pub const TORQUE: Self = Self::of(2, 1, -2);
    /// J
    pub const ENERGY: Self = Self::TORQUE;
    /// W
    pub const POWER: Self = Self::of(2, 1, -3);
    /// Pa
    pub const PRESSURE: Self = Self::of(-1, 1, -2);
    /// N/m
    pub const STIFFNESS: Self = Self::of(0, 1, -2);
    /// N·s/m
    pub const DAMPING: Self = Self::of(0, 1, -1);
    /// N·m·s/rad
    pub const ANGULAR_DAMPING: Self = Self::of(2, 1, -1);
    /// kg·m²
    pub const INERTIA: Self = Self::of(2, 1, 0);
    /// kg/m³
    pub const DENSITY: Self = Self::of(-3, 1, 0);
    /// V
    pub const VOLTAGE: Self = Self {
        twelfths: [24, 12, -36, -12, 0],
        mark: Mark::Plain,
    };

    const fn of(metre: i16, kilogram: i16, second: i16) -> Self {
        Self {
            twelfths: [12 * metre, 12 * kilogram, 12 * second, 0, 0],
            mark: Mark::Plain,
        }
    }

    /// The same with a mark.
    pub const fn marked(self, mark: Mark) -> Self {
        Self { mark, ..self }
    }

    /// How a quantity per second was written.
    pub fn mark(self) -> Mark {
        self.mark
    }

    /// Whether both are powers of the same units, whatever their marks.
    pub fn same_units(self, other: Self) -> bool {
        self.twelfths == other.twelfths
    }

    /// Whether it is that of a number or an angle.
    pub fn is_none(self) -> bool {
        self.same_units(Self::NONE)
    }

    /// Dimension of a product, without a mark; `None` beyond all reason.
    pub fn times(self, other: Self) -> Option<Self> {
        self.combined(other, i16::checked_add)
    }

    /// Dimension of a quotient, without a mark; `None` beyond all reason.
    pub fn over(self, other: Self) -> Option<Self> {
        self.combined(other, i16::checked_sub)
    }

    /// Dimension of a power; the first power keeps the mark. `None` for what has no place.
    pub fn power(self, exponent: &Rational) -> Option<Self> {
        if *exponent == Rational::from_integer(1.into()) {
            return Some(self);
        }
        let mut twelfths = [0; 5];
        for (new, old) in twelfths.iter_mut().zip(self.twelfths) {
            if old != 0 {
                let scaled = exponent * Rational::from_integer(old.into());
                if !scaled.is_integer() {
                    return None;
                }
                *new = scaled.to_i16().filter(|&e| within_reason(e))?;
            }
        }
        Some(Self {
            twelfths,
            mark: Mark::Plain,
        })
    }

    fn combined(self, other: Self, operation: fn(i16, i16) -> Option<i16>) -> Option<Self> {
        let mut twelfths = [0; 5];
        for (index, new) in twelfths.iter_mut().enumerate() {
            *new = operation(self.twelfths[index], other.twelfths[index])
                .filter(|&e| within_reason(e))?;
        }
        Some(Self {
            twelfths,
            mark: Mark::Plain,
        })
    }

    /// The coherent SI unit in the language's own spelling, `1` for a number or an angle: `N/m`.
    pub fn si_unit(self) -> String {
        match self.known() {
            Some((_, _, unit)) => (*unit).to_owned(),
            None => self.base_units(),
        }
    }

    /// What it is called, with its unit: `a force (N)`.
    pub fn described(self) -> String {
        match (self.mark, self.known()) {
            (Mark::Frequency, _) if self.same_units(Self::RATE) => "a frequency (Hz)".to_owned(),
            (Mark::AngularRate, _) if self.same_units(Self::RATE) => {
                "an angular rate (rad/s)".to_owned()
            }
            (_, Some((_, "", unit))) => format!("a quantity in {unit}"),
            (_, Some((_, words, "1"))) => (*words).to_owned(),
            (_, Some((_, words, unit))) => format!("{words} ({unit})"),
            (_, None) => format!("a quantity in {}", self.base_units()),
        }
    }

    fn known(self) -> Option<&'static (Dimension, &'static str, &'static str)> {
        KNOWN.iter().find(|(known, _, _)| known.same_units(self))
    }

    fn base_units(self) -> String {
        const BASES: [&str; 5] = ["m", "kg", "s", "A", "K"];
        const ORDER: [usize; 5] = [1, 0, 2, 3, 4];
        let part = |wanted_sign: i16| {
            ORDER
                .iter()
                .filter(|&&base| self.twelfths[base].signum() == wanted_sign)
                .map(|&base| power_of(BASES[base], self.twelfths[base].unsigned_abs()))
                .collect::<Vec<_>>()
        };
        let (above, below) = (part(1), part(-1));
        let mut text = if above.is_empty() {
            "1".to_owned()
        } else {
            above.join("*")
        };
        for factor in below {
            text.push('/');
            text.push_str(&factor);
        }
        text
    }
}

fn within_reason(twelfths: i16) -> bool {
    twelfths.unsigned_abs() <= 12 * 100
}

fn power_of(base: &str, twelfths: u16) -> String {
    let divisor = num_integer::gcd(twelfths, 12);
    match (twelfths / divisor, 12 / divisor) {
        (1, 1) => base.to_owned(),
        (n, 1) => format!("{base}^{n}"),
        (n, d) => format!("{base}^({n}/{d})"),
    }
}

/// Dimensions with a name of their own: words with their article, coherent unit.
const KNOWN: &[(Dimension, &str, &str)] = &[
    (Dimension::NONE, "a number or an angle", "1"),
    (Dimension::LENGTH, "a length", "m"),
    (Dimension::MASS, "a mass", "kg"),
    (Dimension::TIME, "a time", "s"),
    (Dimension::CURRENT, "a current", "A"),
    (Dimension::TEMPERATURE, "a temperature", "K"),
    (Dimension::AREA, "an area", "m^2"),
    (Dimension::of(3, 0, 0), "a volume", "m^3"),
    (Dimension::VELOCITY, "a velocity", "m/s"),
    (Dimension::ACCELERATION, "an acceleration", "m/s^2"),
    (Dimension::RATE, "a quantity per second", "1/s"),
    (
        Dimension::of(0, 0, -2),
        "an angular acceleration",
        "rad/s^2",
    ),
    (Dimension::FORCE, "a force", "N"),
    (
        Dimension::TORQUE,
        "a torque, an energy or a torsional stiffness",
        "N*m",
    ),
    (Dimension::POWER, "a power", "W"),
    (Dimension::PRESSURE, "a stress or an elastic modulus", "Pa"),
    (Dimension::STIFFNESS, "a stiffness", "N/m"),
    (Dimension::DAMPING, "a damping", "N*s/m"),
    (Dimension::ANGULAR_DAMPING, "a torsional damping", "N*m*s"),
    (Dimension::INERTIA, "a moment of inertia", "kg*m^2"),
    (Dimension::DENSITY, "a density", "kg/m^3"),
    (Dimension::of(1, 1, -1), "a momentum", "N*s"),
    (Dimension::of(-1, 0, 0), "a quantity per length", "1/m"),
    (Dimension::of(0, 1, -3), "", "N/m/s"),
    (Dimension::of(1, 1, -3), "a force per time", "N/s"),
    (Dimension::VOLTAGE, "a voltage", "V"),
    (
        Dimension {
            twelfths: [-12, -12, 36, 12, 0],
            mark: Mark::Plain,
        },
        "a piezoelectric constant",
        "m/V",
    ),
    (
        Dimension {
            twelfths: [0, 0, 12, 12, 0],
            mark: Mark::Plain,
        },
        "a charge",
        "C",
    ),
    (
        Dimension {
            twelfths: [-24, -12, 48, 24, 0],
            mark: Mark::Plain,
        },
        "a capacitance",
        "F",
    ),
    (
        Dimension {
            twelfths: [24, 12, -36, -24, 0],
            mark: Mark::Plain,
        },
        "a resistance",
        "ohm",
    ),
];
