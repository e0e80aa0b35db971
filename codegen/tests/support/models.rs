//! The models of the repository.

use std::path::{Path, PathBuf};

use flexure_model_dsl::equations::Equations;
use flexure_model_dsl::source::Source;

/// Models without golden files: their code has more lines than anybody reads, because three
/// coordinates share a full matrix of inertia whose derivatives the Jacobian differentiates again.
pub const TOO_LONG: [&str; 2] = ["three_rrr", "three_rrr_cranks"];

/// Every model in the models folder, in order of file name.
pub fn all() -> Vec<Equations> {
    of("../models")
}

/// The mechanisms that only tests need.
pub fn mechanisms() -> Vec<Equations> {
    of("../tests/mechanisms")
}

fn of(folder: &str) -> Vec<Equations> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut files: Vec<PathBuf> = std::fs::read_dir(&folder)
        .expect("a folder of models")
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.extension().is_some_and(|end| end == "flex"))
        .collect();
    files.sort();
    files.iter().map(|path| one(&folder, path)).collect()
}

fn one(folder: &Path, path: &Path) -> Equations {
    let text = std::fs::read_to_string(path).expect("a model file");
    let name = path.file_name().map(|name| name.to_string_lossy());
    let source = Source::new(name.unwrap_or_default(), text);
    let read = |file: &str| -> Result<String, String> {
        std::fs::read_to_string(folder.join(file)).map_err(|error| error.to_string())
    };
    match flexure_model_dsl::compile(source, &read) {
        Ok((equations, _)) => equations,
        Err(errors) => {
            let texts: Vec<String> = errors.iter().map(ToString::to_string).collect();
            panic!("{}", texts.join("\n\n"))
        }
    }
}
