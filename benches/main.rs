//! `cargo bench`: one table of times, each as a ratio to hand-written C measured in the same run.
//! What is measured, and how: benches/README.md.

mod andrews;
mod baseline;
mod compiling;
mod implementation;
mod measure;
mod recorded;
mod simulating;
mod study;
mod table;
mod workloads;

use std::process::ExitCode;

use baseline::Baseline;
use table::Table;

/// What the command line asks for.
struct Wanted {
    /// Names of workloads; all if none is given.
    names: Vec<String>,
    /// All 10 000 designs of W5 rather than a share of them.
    full: bool,
}

impl Wanted {
    fn has(&self, name: &str) -> bool {
        self.names.is_empty() || self.names.iter().any(|wanted| wanted == name)
    }
}

fn main() -> ExitCode {
    let mut wanted = Wanted {
        names: Vec::new(),
        full: false,
    };
    for argument in std::env::args().skip(1) {
        match argument.as_str() {
            "--bench" => {}
            "--full" => wanted.full = true,
            name if NAMES.contains(&name) => wanted.names.push(name.to_owned()),
            other => {
                eprintln!(
                    "`{other}` is no workload; there are {}, and `--full`",
                    NAMES.join(", ")
                );
                return ExitCode::from(2);
            }
        }
    }
    let c = match Baseline::build() {
        Ok(c) => Some(c),
        Err(why) => {
            println!("rows of C are left out, and with them all ratios: {why}");
            None
        }
    };
    let mut table = Table::default();
    let c = c.as_ref();
    for (name, run) in [
        ("W1", workloads::one_trajectory as fn(_, &mut _, _)),
        ("W2", workloads::to_an_accuracy),
        ("W3", workloads::many_trajectories),
        ("W4", workloads::preloads_and_frequencies),
        ("W5", workloads::designs),
        ("W6", compiling::models),
        ("W7", andrews::to_an_accuracy),
        ("program", simulating::start_to_exit),
    ] {
        if wanted.has(name) {
            eprintln!("{name} …");
            run(c, &mut table, wanted.full);
        }
    }
    print!("\n{table}");
    match table.write() {
        Ok(path) => {
            println!("\nin {}", path.display());
            ExitCode::SUCCESS
        }
        Err(why) => {
            eprintln!("cannot write the table: {why}");
            ExitCode::FAILURE
        }
    }
}

/// All workloads.
const NAMES: [&str; 8] = ["W1", "W2", "W3", "W4", "W5", "W6", "W7", "program"];
