//! The equations of the models of this repository, as people read them.

use flexure_codegen::report;
use flexure_model_dsl::compile;
use flexure_model_dsl::equations::Equations;
use flexure_model_dsl::source::Source;

/// The models whose equations are kept as text and as LaTeX.
const MODELS: [&str; 18] = [
    "andrews",
    "bridge_amplifier",
    "double_parallelogram_stage",
    "double_rocker",
    "five_bar",
    "four_bar",
    "lugre_mass",
    "msdm",
    "n_windows_1",
    "n_windows_2",
    "n_windows_40",
    "parallelogram_stage",
    "pendulum",
    "six_bar",
    "slider_crank",
    "three_rrr",
    "three_rrr_cranks",
    "xy_stage",
];

fn model(name: &str) -> Equations {
    let path = format!("{}/../models/{name}.flex", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).expect("the model file is there");
    let source = Source::new(format!("models/{name}.flex"), text);
    match compile(source, &|file| Err(format!("{file} is not there"))) {
        Ok((equations, _)) => equations,
        Err(errors) => panic!("{name}: {errors:#?}"),
    }
}

#[test]
fn as_text() {
    for name in MODELS {
        insta::assert_snapshot!(format!("{name}_text"), report::text(&model(name)));
    }
}

#[test]
fn as_latex() {
    for name in MODELS {
        insta::assert_snapshot!(format!("{name}_latex"), report::latex(&model(name)));
    }
}

#[test]
fn as_markdown() {
    let equations = model("double_rocker");
    insta::assert_snapshot!("double_rocker_markdown", report::markdown(&equations));
}
