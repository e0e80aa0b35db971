//! Values and dimensions of expressions, against numbers worked out by hand.

use flexure_model_dsl::model::Model;
use flexure_model_dsl::resolve::resolve;
use flexure_model_dsl::source::Source;
use flexure_model_dsl::symbolic::Evaluator;

fn model(text: &str) -> Model {
    match resolve(Source::new("test.flex", text), &|_| {
        Err("no file".to_owned())
    }) {
        Ok((model, _)) => model,
        Err(diagnostics) => {
            let texts: Vec<String> = diagnostics.iter().map(ToString::to_string).collect();
            panic!("{}", texts.join("\n\n"))
        }
    }
}

/// Value in SI and unit of the let `x`.
fn evaluated(declarations: &str) -> (f64, String) {
    let model = model(&format!("model test\n{declarations}\noutput y = x\n"));
    let mut evaluator = Evaluator::new(&model.graph);
    for param in &model.params {
        evaluator.define(param.symbol, param.default);
    }
    for quantity in &model.lets {
        evaluator.define(quantity.symbol, quantity.value);
    }
    let quantity = model
        .lets
        .iter()
        .find(|quantity| quantity.name == "x")
        .expect("x is a let");
    (
        evaluator.value(quantity.value),
        quantity.dimension.si_unit(),
    )
}

#[track_caller]
fn check(expression: &str, value: f64, unit: &str) {
    let context = "param a = 2, b = 3, m = 5 m, n = 7 N, w = 1 rad/s";
    let (found, found_unit) = evaluated(&format!("{context}\nlet x = {expression}"));
    let error = (found - value).abs();
    assert!(
        error <= 4.0 * f64::EPSILON * value.abs(),
        "{expression} is {found}, not {value}"
    );
    assert_eq!(found_unit, unit, "{expression}");
}

#[test]
fn precedence() {
    check("1 + 2 * 3", 7.0, "1");
    check("(1 + 2) * 3", 9.0, "1");
    check("2 * 3 ^ 2", 18.0, "1");
    check("-2 ^ 2", -4.0, "1");
    check("(-2) ^ 2", 4.0, "1");
    check("2 ^ -1", 0.5, "1");
    check("2 ^ 3 ^ 2", 512.0, "1");
    check("2 ^ -2 ^ 2", 0.0625, "1");
    check("12 / 3 / 2", 2.0, "1");
    check("12 / 3 * 2", 8.0, "1");
    check("7 - 3 - 2", 2.0, "1");
    check("7 - -3", 10.0, "1");
    check("- - 3", 3.0, "1");
    check("-a + b", 1.0, "1");
    check("a * -b", -6.0, "1");
    check("a - b * a", -4.0, "1");
    check("if a > b then 1 else 2", 2.0, "1");
    check("if a + 1 >= b then 1 else 2", 1.0, "1");
    check("if a + 1 > b then 1 else 2", 2.0, "1");
    check("if a < b and b < a or a <= 2 then 1 else 2", 1.0, "1");
    check("if a > b then 1 else if a > 1 then 2 else 3", 2.0, "1");
    check("1 + (if a > b then 1 else 2)", 3.0, "1");
}

#[test]
fn units_win_next_to_numbers_and_products_elsewhere() {
    check("3 N*m", 3.0, "N*m");
    check("3 N * m", 15.0, "N*m");
    check("3 N*b", 9.0, "N");
    check("3 m", 3.0, "m");
    check("3*m", 15.0, "m");
    check("3mm", 0.003, "m");
    check("3 kN/mm", 3e6, "N/m");
    check("2 m/m", 2.0, "1");
    check("2 mm^2", 2e-6, "m^2");
    check("(2 mm)^2", 4e-6, "m^2");
    check("90 deg", std::f64::consts::FRAC_PI_2, "1");
    check("50 % * a", 1.0, "1");
    check("2*pi*200 Hz*a", 800.0 * std::f64::consts::PI, "1/s");
    check("6 N*s/m * m / (2 s)", 15.0, "N");
}

#[test]
fn dimensions_follow_powers_and_functions() {
    check("sqrt(m * m)", 5.0, "m");
    check("m^2", 25.0, "m^2");
    check("m^(5/2) / sqrt(m)", 25.0, "m^2");
    check("m^0.5 * m^0.5", 5.0, "m");
    check("abs(-m)", 5.0, "m");
    check("min(m, 3 m, 4 m)", 3.0, "m");
    check("max(m, 0)", 5.0, "m");
    check("sign(-n)", -1.0, "1");
    check("atan2(m, m)", std::f64::consts::FRAC_PI_4, "1");
    check("sin(30 deg)", 0.5, "1");
    check("floor(2.7)", 2.0, "1");
    check("exp(log(a))", 2.0, "1");
    check("a ^ b", 8.0, "1");
    check("0 + m", 5.0, "m");
    check("n / m", 1.4, "N/m");
    check("1 / m", 0.2, "1/m");
}

#[test]
fn the_hinge_of_the_article() {
    let text = "let x = circular_hinge(72 GPa, width = 3 mm, web = 1.5 mm, radius = 1 mm, formula = thin_web)";
    let (value, unit) = evaluated(text);
    assert!((value / 42.10362726661852 - 1.0).abs() < 1e-14);
    assert_eq!(unit, "N*m");
}

#[test]
fn lets_in_any_order() {
    assert_eq!(evaluated("let x = 2 * y\nlet y = z + 1\nlet z = 3").0, 8.0);
}

#[test]
fn lines_go_on_where_they_must() {
    let long = "let x = 1 +\n  2 * // two\n\n  3\n  + 4 * max(1,\n 2)";
    assert_eq!(evaluated(long).0, 15.0);
}

#[test]
fn decimals_are_exact_until_evaluated() {
    assert_eq!(evaluated("let x = 0.1 + 0.2").0, 0.3);
    assert_eq!(evaluated("let x = 0.2568 g").0, 0.2568e-3);
    assert_eq!(evaluated("let x = 1e-320").0, 1e-320);
    assert_eq!(evaluated("let x = 1.7976931348623157e308").0, f64::MAX);
}

#[test]
fn every_unit_of_the_list_can_be_written() {
    let bases = [
        "m", "g", "s", "A", "K", "N", "Pa", "J", "W", "V", "C", "F", "ohm", "Ω", "H", "T", "Wb",
        "Hz", "rad",
    ];
    let prefixes = [
        "", "f", "p", "n", "u", "µ", "μ", "m", "c", "d", "h", "k", "M", "G", "T",
    ];
    let mut units: Vec<String> = ["deg", "°", "%"].map(str::to_owned).to_vec();
    for base in bases {
        units.extend(prefixes.iter().map(|prefix| format!("{prefix}{base}")));
    }
    for unit in units {
        for chain in [
            unit.clone(),
            format!("N*{unit}"),
            format!("N/{unit}^2"),
            format!("{unit}²·s"),
        ] {
            let (value, written) = evaluated(&format!("let x = 1 {chain}"));
            let known = flexure_model_dsl::units::Unit::parse(&chain).expect(&chain);
            assert_eq!(written, known.dimension.si_unit(), "{chain}");
            assert!(value > 0.0);
        }
    }
}

#[test]
fn signs_and_blanks_of_word_processors() {
    assert_eq!(
        evaluated("let x =\u{A0}7 \u{2212}\u{202F}2\u{A0}×\u{2009}3\r\n").0,
        1.0
    );
    assert_eq!(
        model("\u{FEFF}model test\r\nparam a = 1\r\noutput b = a\r\n").name,
        "test"
    );
}
