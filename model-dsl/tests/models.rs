//! The models of this repository, resolved.

use flexure_model_dsl::model::Model;
use flexure_model_dsl::resolve::resolve;
use flexure_model_dsl::source::Source;

fn model(name: &str) -> Model {
    let path = format!("{}/../models/{name}.flex", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).expect("the model file is there");
    let source = Source::new(format!("models/{name}.flex"), text);
    match resolve(source, &|_| Err("no files here".to_owned())) {
        Ok((model, warnings)) => {
            assert!(warnings.is_empty(), "{name}: {}", shown(&warnings));
            model
        }
        Err(diagnostics) => panic!("{name}:\n{}", shown(&diagnostics)),
    }
}

fn shown(diagnostics: &[impl ToString]) -> String {
    let texts: Vec<String> = diagnostics.iter().map(ToString::to_string).collect();
    texts.join("\n\n")
}

#[test]
fn double_rocker_resolves() {
    let model = model("double_rocker");
    println!("{model:#?}");
}
