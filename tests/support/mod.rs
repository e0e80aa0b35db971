//! What the integration tests share.
//!
//! What shares what: `multipliers` takes from the compiler the resolved model and nothing after
//! it; `oracle` follows the derived equations; a test that compares the two therefore checks
//! structure, closing of loops, derivation and energies at once, and would not see a mistake in
//! the reading of a model file alone, for which the parser has tests of its own. `by_hand` shares
//! nothing, not even that.
#![allow(
    dead_code,
    reason = "each test binary uses its own part of this module"
)]

pub mod by_hand;
pub mod four_bars;
pub mod grown;
pub mod multipliers;
pub mod oracle;
pub mod probe;
pub mod random;
pub mod twin;
pub mod windows;

use flexure_model_dsl::model::{BodyId, Model};
use flexure_model_dsl::source::Source;
use flexure_runtime::tape::{TapeModel, TapePrepared};

use oracle::Oracle;

/// A model file, resolved and derived.
pub struct Compiled {
    /// As resolved.
    pub model: Model,
    /// As derived.
    pub oracle: Oracle,
}

/// Compiles the text of a model file, which must be without faults.
pub fn compile(name: &str, text: &str) -> Compiled {
    try_compile(name, text).unwrap_or_else(|error| panic!("{name}:\n{error}\n{text}"))
}

/// Compiles the text of a model file, or says what is wrong with it.
pub fn try_compile(name: &str, text: &str) -> Result<Compiled, String> {
    let none = |path: &str| Err(format!("no file `{path}`"));
    let source = Source::new(name, text);
    let fail = |problems: Vec<flexure_runtime::diagnostic::Diagnostic>| {
        let lines: Vec<String> = problems.iter().map(|p| p.to_string()).collect();
        lines.join("\n")
    };
    let (model, _) = flexure_model_dsl::resolve::resolve(source.clone(), &none).map_err(fail)?;
    let (equations, _) = flexure_model_dsl::compile(source, &none).map_err(fail)?;
    Ok(Compiled {
        model,
        oracle: Oracle::new(equations),
    })
}

/// The text of a model of this repository.
pub fn shipped_text(name: &str) -> String {
    let path = format!("{}/models/{name}.flex", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// A model of this repository.
pub fn shipped(name: &str) -> Compiled {
    compile(name, &shipped_text(name))
}

/// Mechanisms made for tests, in `tests/mechanisms`: guides that turn, coupled inertia, slides that
/// carry links and slides, contacts between slides and contacts that lift off, repeated parts,
/// bodies that springs alone hold, coordinates of points.
pub const MECHANISMS: [&str; 7] = [
    "cart_pole",
    "chain",
    "held_by_springs",
    "pressing_arm",
    "slide_on_link",
    "two_link_arm",
    "xy_stage",
];

/// One of [`MECHANISMS`].
pub fn mechanism(name: &str) -> Compiled {
    let folder = env!("CARGO_MANIFEST_DIR");
    let path = format!("{folder}/tests/mechanisms/{name}.flex");
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
    compile(name, &text)
}

/// The names of this repository's models, in order.
pub fn model_names() -> Vec<String> {
    let folder = format!("{}/models", env!("CARGO_MANIFEST_DIR"));
    let entries = std::fs::read_dir(&folder).expect("the folder of models");
    let mut names: Vec<String> = entries
        .filter_map(|entry| {
            let name = entry.expect("an entry").file_name().into_string().ok()?;
            name.strip_suffix(".flex").map(str::to_owned)
        })
        .collect();
    names.sort();
    names
}

/// The model as a tape.
pub fn tape_model(compiled: &Compiled) -> TapeModel {
    let program = flexure_codegen::program(&compiled.oracle.equations);
    flexure_codegen::tape(&program)
}

/// The model as a tape, with default params of which some are changed.
pub fn tape(compiled: &Compiled, changes: &[(&str, f64)]) -> TapePrepared {
    let prepared = tape_model(compiled).prepare(&compiled.params(changes));
    prepared.unwrap_or_else(|problem| panic!("{problem}"))
}

impl Compiled {
    /// Default params with some of them changed.
    pub fn params(&self, changes: &[(&str, f64)]) -> Vec<f64> {
        let mut values = self.oracle.defaults();
        for (name, value) in changes {
            let index = self.model.params.iter().position(|p| p.name == *name);
            values[index.unwrap_or_else(|| panic!("there is a param `{name}`"))] = *value;
        }
        values
    }

    /// The coordinates in the order of the states: each body with the positions of its value and
    /// its rate in the state.
    pub fn coordinates(&self) -> Vec<(BodyId, usize, usize)> {
        let states = &self.oracle.equations.states;
        let find = |name: String| states.iter().position(|state| state.name == name);
        let mut found = Vec::new();
        for body in 1..self.model.bodies.len() {
            if let [Some(value), Some(rate)] = self.model.coordinate_names(body).map(find) {
                found.push((body, value, rate));
            }
        }
        found.sort_by_key(|(_, value, _)| *value);
        found
    }

    /// The positions of contacts' bristle deflections in the state.
    pub fn bristles(&self) -> Vec<usize> {
        let contacts = self.model.contacts.iter();
        contacts
            .map(|contact| self.oracle.state(&format!("{}.z", contact.name)))
            .collect()
    }
}

/// Fails where a value is farther from the expected one than a part of it.
pub fn assert_close(what: &str, value: f64, expected: f64, tolerance: f64) {
    let error = (value - expected).abs() / expected.abs();
    println!("{what}: {value:.17e}, expected {expected:.17e}, relative error {error:.1e}");
    assert!(
        error <= tolerance,
        "{what}: {value:e}, expected {expected:e}, relative error {error:e}"
    );
}
