//! Reports of the models of this repository, and of what is unusual.

use flexure_model_dsl::compile;
use flexure_model_dsl::equations::{Equations, Line, Section};
use flexure_model_dsl::source::Source;

use super::*;

fn compiled(path: &str, text: String) -> Equations {
    match compile(
        Source::new(path, text),
        &|_| Err("no files here".to_owned()),
    ) {
        Ok((equations, _)) => equations,
        Err(errors) => panic!("{path}: {errors:#?}"),
    }
}

fn model(name: &str) -> Equations {
    let path = format!("{}/../models/{name}.flex", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).expect("the model file is there");
    compiled(&format!("models/{name}.flex"), text)
}

#[test]
fn double_rocker() {
    let equations = model("double_rocker");
    insta::assert_snapshot!("double_rocker_text", text(&equations));
    insta::assert_snapshot!("double_rocker_latex", latex(&equations));
    insta::assert_snapshot!("double_rocker_markdown", markdown(&equations));
}
