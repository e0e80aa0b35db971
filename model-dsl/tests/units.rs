//! Units and quantities: factors, dimensions, what is refused.

use flexure_model_dsl::symbolic::Rational;
use flexure_model_dsl::units::{Dimension, Mark, Unit, parse_quantity};
use num_traits::ToPrimitive;

fn value(text: &str) -> f64 {
    parse_quantity(text).expect(text).0.to_f64().expect(text)
}

fn dimension(text: &str) -> Dimension {
    parse_quantity(text).expect(text).1.expect(text)
}

#[test]
fn quantities_of_the_command_line() {
    assert_eq!(value("15N"), 15.0);
    assert_eq!(value("15 N"), 15.0);
    assert_eq!(value(" 20 ms "), 0.02);
    assert_eq!(value("-5um"), -5e-6);
    assert_eq!(value("5µm"), 5e-6);
    assert_eq!(value("5μm"), 5e-6);
    assert_eq!(value("+3.6e6N/m"), 3.6e6);
    assert_eq!(value("1e-3"), 1e-3);
    assert_eq!(value("95%"), 0.95);
    assert_eq!(value("0.2568 g"), 0.0002568);
    assert_eq!(value("72 GPa"), 72e9);
    assert_eq!(value("2810 kg/m^3"), 2810.0);
    assert_eq!(value("2.81 g/cm³"), 2810.0);
    assert_eq!(value("180 deg"), std::f64::consts::PI);
    assert_eq!(value("80°"), 80.0f64.to_radians());
    assert!(parse_quantity("0.3").expect("a number").1.is_none());
}

#[test]
fn what_is_no_quantity() {
    for text in [
        "",
        "N",
        "3 min",
        "3 h",
        "3 d",
        "3 t",
        "3 lbf",
        "3 N m",
        "3 N*",
        "3 N**m",
        "1e999",
        "1e-400",
        "3..4",
        "3.",
        "--3",
        "3 N^",
        "3 m^99",
        "3 m^9999999999",
        "NaN",
        "inf",
        "1e308 km",
        "3 /s",
    ] {
        assert!(parse_quantity(text).is_err(), "`{text}` is refused");
    }
}

#[test]
fn dimensions_of_chains() {
    assert!(dimension("1 N*s/m").same_units(Dimension::DAMPING));
    assert!(dimension("1 N*m/rad").same_units(Dimension::TORQUE));
    assert!(dimension("1 kg·m²").same_units(Dimension::INERTIA));
    assert!(dimension("1 V").same_units(Dimension::VOLTAGE));
    assert!(dimension("1 C*V").same_units(Dimension::ENERGY));
    assert!(dimension("1 F*V^2").same_units(Dimension::ENERGY));
    assert!(dimension("1 ohm*A").same_units(Dimension::VOLTAGE));
    assert!(dimension("1 H*A/s").same_units(Dimension::VOLTAGE));
    assert!(dimension("1 Wb/s").same_units(Dimension::VOLTAGE));
    assert!(dimension("1 T*m^2/s").same_units(Dimension::VOLTAGE));
    assert!(dimension("1 W").same_units(Dimension::POWER));
}

#[test]
fn frequencies_and_angular_rates_are_told_apart() {
    assert_eq!(dimension("1 kHz").mark(), Mark::Frequency);
    assert_eq!(dimension("1 rad/s").mark(), Mark::AngularRate);
    assert_eq!(dimension("1 deg/ms").mark(), Mark::AngularRate);
    assert_eq!(dimension("1 m/s").mark(), Mark::Plain);
    assert_eq!(dimension("1 s^-1").mark(), Mark::Plain);
    assert_eq!(dimension("1 N*m*s/rad").mark(), Mark::Plain);
}

#[test]
fn units_print_in_their_own_spelling() {
    for text in [
        "m", "kg", "s", "N", "N*m", "N/m", "N*s/m", "kg*m^2", "m/s", "m/s^2", "Pa", "W", "V",
        "ohm", "F", "kg/m^3", "N*s", "m^2", "1/m", "m/V",
    ] {
        let dimension = match text.strip_prefix("1/") {
            Some(below) => Dimension::NONE
                .over(Unit::parse(below).expect(text).dimension)
                .expect(text),
            None => Unit::parse(text).expect(text).dimension,
        };
        assert_eq!(dimension.si_unit(), text);
    }
    assert_eq!(Dimension::NONE.si_unit(), "1");
}

#[test]
fn roots_and_powers_of_dimensions() {
    let half = Rational::new(1.into(), 2.into());
    let root = Dimension::LENGTH.power(&half).expect("a root");
    assert_eq!(root.si_unit(), "m^(1/2)");
    assert_eq!(root.times(root), Some(Dimension::LENGTH));
    let seventh = Rational::new(1.into(), 7.into());
    assert_eq!(Dimension::LENGTH.power(&seventh), None);
    let huge = Rational::from_integer(1_000_000.into());
    assert_eq!(Dimension::LENGTH.power(&huge), None);
    let rate = Dimension::FREQUENCY;
    assert_eq!(
        rate.times(Dimension::NONE).expect("in range").mark(),
        Mark::Plain
    );
}
