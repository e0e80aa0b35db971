//! Every faulty model of `tests/faulty` with all the messages it gets, as a person sees them.

use std::path::{Path, PathBuf};

use flexure_model_dsl::compile;
use flexure_model_dsl::source::Source;

fn faulty() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/faulty")
}

/// Files that the faulty models name.
fn files(path: &str) -> Result<String, String> {
    match path {
        "backwards.csv" => Ok("time,x\n0,1\n2,3\n1,2\n".to_owned()),
        "words.csv" => Ok("time,x\n0,1\n1,two\n".to_owned()),
        "first.flex" => Ok("use \"second.flex\"\n".to_owned()),
        "second.flex" => Ok("const N = 3\nuse \"first.flex\"\n".to_owned()),
        "model.flex" => Ok("model n\nconst N = 3\n".to_owned()),
        "faulty.flex" => Ok("component bar(l: length) {\n  \
             link web from P to Q { length = l, angle = 0 deg, mass = 1 mm }\n}\n"
            .to_owned()),
        _ => Err("no such file".to_owned()),
    }
}

fn messages(name: &str, text: String) -> String {
    let diagnostics = match compile(Source::new(name, text), &files) {
        Ok((_, warnings)) => warnings,
        Err(diagnostics) => diagnostics,
    };
    let texts: Vec<String> = diagnostics.iter().map(ToString::to_string).collect();
    texts.join("\n\n")
}

#[test]
fn every_mistake_has_its_message() {
    let mut paths: Vec<PathBuf> = std::fs::read_dir(faulty())
        .expect("the folder is there")
        .map(|entry| entry.expect("it can be read").path())
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == "flex")
        })
        .collect();
    paths.sort();
    assert!(paths.len() >= 40);
    let mut settings = insta::Settings::new();
    settings.set_snapshot_path(faulty());
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let mut silent = Vec::new();
    for path in paths {
        let stem = path
            .file_stem()
            .expect("a file has a name")
            .to_string_lossy();
        let text = std::fs::read_to_string(&path).expect("it can be read");
        let messages = messages(&format!("{stem}.flex"), text);
        if messages.is_empty() {
            silent.push(stem.to_string());
        }
        settings.bind(|| insta::assert_snapshot!(stem.to_string(), messages));
    }
    assert!(silent.is_empty(), "these get no message: {silent:?}");
}
