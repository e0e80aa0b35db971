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
fn every_model_resolves() {
    for name in [
        "double_rocker",
        "four_bar",
        "lugre_mass",
        "msdm",
        "pendulum",
    ] {
        let model = model(name);
        assert_eq!(model.name, name);
        assert!(!model.doc.is_empty(), "{name} says what it is");
        for param in &model.params {
            assert!(
                !param.doc.is_empty(),
                "{name}: `{}` has its words",
                param.name
            );
        }
    }
}

#[test]
fn params_of_the_actuator_are_those_of_the_article() {
    let model = model("double_rocker");
    let names: Vec<&str> = model
        .params
        .iter()
        .map(|param| param.name.as_str())
        .collect();
    let mut sorted = names.clone();
    sorted.sort_unstable();
    let mut expected: Vec<&str> =
        "E b h e r l1 l2 l3 l4 m1 m2 m3 beta1 beta2 beta3 la ln mp kp cp \
                                   ku ms Fp sigma0 sigma1 sigma2 mu_s mu_c v_s f stroke rise"
            .split_whitespace()
            .collect();
    expected.sort_unstable();
    assert_eq!(sorted, expected);
    assert_eq!(model.sets.len(), 1);
    assert_eq!(model.sets[0].values.len(), 6);
}
