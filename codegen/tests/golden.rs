//! Generated Rust, the staged program and the tape of every model, as files that a person can read
//! and that `tests/compiled.rs` compiles.
//!
//! `UPDATE_GOLDEN=1 cargo test -p flexure-codegen --test golden` writes them anew.

mod support;

use std::path::{Path, PathBuf};

use flexure_codegen::Texts;
use flexure_model_dsl::equations::Equations;
use quote::quote;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden")
}

fn compare(path: &Path, text: &str) -> Result<(), String> {
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        std::fs::create_dir_all(path.parent().expect("a folder")).expect("a folder to write to");
        std::fs::write(path, text).expect("a file to write to");
        return Ok(());
    }
    let golden = std::fs::read_to_string(path).unwrap_or_default();
    if golden == text {
        return Ok(());
    }
    let line = golden
        .lines()
        .zip(text.lines())
        .position(|(a, b)| a != b)
        .unwrap_or_else(|| golden.lines().count().min(text.lines().count()));
    let of = |text: &str| text.lines().nth(line).unwrap_or("").to_owned();
    Err(format!(
        "{} differs in line {}\n  golden: {}\n  now:    {}",
        path.display(),
        line + 1,
        of(&golden),
        of(text)
    ))
}

fn check(equations: &Equations) -> Vec<String> {
    let program = flexure_codegen::program(equations);
    let text = flexure_codegen::report::text(equations);
    let latex = flexure_codegen::report::latex(equations);
    let texts = Texts {
        equations: &text,
        latex: &latex,
    };
    let source = flexure_codegen::rust_source(&program, texts, &quote!(::flexure_runtime));
    let listing = flexure_codegen::listing(&program);
    let name = &equations.name;
    [
        compare(&folder().join(format!("{name}.rs")), &source),
        compare(&folder().join(format!("{name}.stages.txt")), &listing),
    ]
    .into_iter()
    .filter_map(Result::err)
    .collect()
}

#[test]
fn generated_code_is_as_it_was_read() {
    let mut differences = check(&support::handmade::slider_crank());
    for equations in support::models::all() {
        if support::models::TOO_LONG.contains(&equations.name.as_str()) {
            continue;
        }
        differences.extend(check(&equations));
    }
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}
