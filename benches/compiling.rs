//! W6: from a model file to equations and to Rust, and what compiling that takes.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use flexure::Model;
use flexure::codegen::{self, Texts, report};
use quote::quote;

use crate::baseline::Baseline;
use crate::table::{Row, Table, target};

/// Rounds of measurements; the fastest counts.
const ROUNDS: usize = 3;
/// Longest chain of four-bars.
const MOST_WINDOWS: usize = 40;

/// A model's text, and the name of its row.
struct Case {
    name: String,
    text: String,
}

/// Times of a case in s: to equations and tape, and on to Rust.
#[derive(Clone, Copy)]
struct Times {
    equations: f64,
    all: f64,
}

fn root(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path)
}

/// Every model of the folder but the chains, then the chain with 1 to 40 windows.
fn cases() -> std::io::Result<Vec<Case>> {
    let mut paths = Vec::new();
    for entry in std::fs::read_dir(root("models"))? {
        let path = entry?.path();
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        if path.extension().is_some_and(|ending| ending == "flex") && !name.starts_with("n_windows")
        {
            paths.push(path);
        }
    }
    paths.sort();
    let mut cases = Vec::new();
    for path in paths {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        cases.push(Case {
            name: name.into_owned(),
            text: std::fs::read_to_string(&path)?,
        });
    }
    let chain = std::fs::read_to_string(root("models/n_windows_40.flex"))?;
    for count in 1..=MOST_WINDOWS {
        cases.push(Case {
            name: format!("{count} windows"),
            text: chain.replace("const N = 40", &format!("const N = {count}")),
        });
    }
    Ok(cases)
}

/// Emits Rust of a model for a crate that has the runtime by `runtime`.
fn emitted(model: &Model) -> String {
    let texts = Texts {
        equations: &report::text(model.equations()),
        latex: &report::latex(model.equations()),
    };
    codegen::rust_source(model.program(), texts, &quote!(::flexure_runtime))
}

fn timed(case: &Case) -> Result<Times, String> {
    let start = Instant::now();
    let model = Model::from_source(&case.name, &case.text).map_err(|why| why.to_string())?;
    let equations = start.elapsed().as_secs_f64();
    let source = emitted(&model);
    let all = start.elapsed().as_secs_f64();
    if source.contains("fn rhs") {
        Ok(Times { equations, all })
    } else {
        Err("there is no right-hand side in what it emits".to_owned())
    }
}

/// The runtime that cargo built beside this program: the newest there is.
fn runtime() -> Option<PathBuf> {
    let program = std::env::current_exe().ok()?;
    let entries = std::fs::read_dir(program.parent()?).ok()?;
    entries
        .flatten()
        .map(|entry| entry.path())
        .filter(|path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with("libflexure_runtime-") && name.ends_with(".rlib")
        })
        .max_by_key(|path| path.metadata().and_then(|data| data.modified()).ok())
}

/// Time in s that the Rust compiler takes, optimizing, for a model's emitted code.
fn compiled(case: &Case) -> Result<f64, String> {
    let runtime = runtime().ok_or("the runtime is not beside this program")?;
    let model = Model::from_source(&case.name, &case.text).map_err(|why| why.to_string())?;
    let folder = target().join("emitted");
    std::fs::create_dir_all(&folder).map_err(|why| why.to_string())?;
    let source = folder.join("model.rs");
    std::fs::write(&source, emitted(&model)).map_err(|why| why.to_string())?;
    let mut found = std::ffi::OsString::from("flexure_runtime=");
    found.push(&runtime);
    let mut dependencies = std::ffi::OsString::from("dependency=");
    dependencies.push(runtime.parent().unwrap_or(Path::new("")));
    let start = Instant::now();
    let output = Command::new("rustc")
        .args([
            "--edition",
            "2024",
            "--crate-type",
            "rlib",
            "-O",
            "--extern",
        ])
        .arg(found)
        .arg("-L")
        .arg(dependencies)
        .arg("--out-dir")
        .arg(&folder)
        .arg(&source)
        .output()
        .map_err(|why| why.to_string())?;
    let seconds = start.elapsed().as_secs_f64();
    if output.status.success() {
        Ok(seconds)
    } else {
        Err(String::from_utf8_lossy(&output.stderr).trim().to_owned())
    }
}

/// W6.
pub fn models(c: Option<&Baseline>, table: &mut Table, _full: bool) {
    let cases = match cases() {
        Ok(cases) => cases,
        Err(why) => return table.remark(format!("W6: cannot read the models: {why}")),
    };
    let base = c.and_then(|c| c.compile_seconds(ROUNDS));
    let mut row = |workload: String, implementation: &str, seconds: f64, note: String| {
        table.row(Row {
            workload,
            implementation: implementation.to_owned(),
            cores: 1,
            seconds,
            ratio: base.map(|base| base / seconds),
            note,
        });
    };
    if let Some(seconds) = base {
        let note = "compiling the hand-written actuator, gcc -O3".to_owned();
        row("W6".to_owned(), "C libm, compiled", seconds, note);
    }
    let mut least: Vec<Option<Times>> = vec![None; cases.len()];
    for _ in 0..ROUNDS {
        for (case, least) in cases.iter().zip(&mut least) {
            if let Ok(times) = timed(case) {
                let before = least.unwrap_or(times);
                *least = Some(Times {
                    equations: before.equations.min(times.equations),
                    all: before.all.min(times.all),
                });
            }
        }
    }
    for (case, times) in cases.iter().zip(least) {
        if let Some(times) = times {
            let note = format!(
                "{:.1} ms to the tape, {:.1} ms to Rust",
                times.equations * 1e3,
                times.all * 1e3
            );
            let workload = format!("W6 {}", case.name);
            row(
                workload,
                "flexure compiled, model file to Rust",
                times.all,
                note,
            );
        }
    }
    let mut remarks = Vec::new();
    for case in &cases {
        let compiled_too = ["double_rocker", "andrews", "40 windows"];
        if !compiled_too.contains(&case.name.as_str()) {
            continue;
        }
        match compiled(case) {
            Ok(seconds) => row(
                format!("W6 {}", case.name),
                "flexure compiled, Rust to machine code",
                seconds,
                "rustc -O".to_owned(),
            ),
            Err(why) => remarks.push(format!("W6 {}: no row; rustc: {why}", case.name)),
        }
    }
    for remark in remarks {
        table.remark(remark);
    }
}
