//! The equations of every model of this repository, as people read them.

use flexure_codegen::report;
use flexure_model_dsl::compile;
use flexure_model_dsl::equations::Equations;
use flexure_model_dsl::source::Source;

fn model(name: &str) -> Equations {
    let path = format!("{}/../models/{name}.flex", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).expect("the model file is there");
    let source = Source::new(format!("models/{name}.flex"), text);
    match compile(source, &|file| Err(format!("{file} is not there"))) {
        Ok((equations, _)) => equations,
        Err(errors) => panic!("{name}: {errors:#?}"),
    }
}

fn snapshot(name: &str) {
    let equations = model(name);
    insta::assert_snapshot!(format!("{name}_text"), report::text(&equations));
    insta::assert_snapshot!(format!("{name}_latex"), report::latex(&equations));
}

#[test]
fn double_rocker() {
    snapshot("double_rocker");
    let equations = model("double_rocker");
    insta::assert_snapshot!("double_rocker_markdown", report::markdown(&equations));
}

#[test]
fn four_bar() {
    snapshot("four_bar");
}

#[test]
fn lugre_mass() {
    snapshot("lugre_mass");
}

#[test]
fn msdm() {
    snapshot("msdm");
}

#[test]
fn pendulum() {
    snapshot("pendulum");
}
