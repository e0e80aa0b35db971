//! `flexure emit`: what the compiler makes of a model.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use flexure::codegen::{self, Texts, report};
use quote::quote;

use super::output::{self, OutputFile};
use super::settings::load;
use super::terminal::Terminal;
use super::{Failure, print};

/// Write what the compiler makes of a model: Rust source, the tape, or the graph of its stages
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  flexure emit models/double_rocker.flex -o double_rocker.rs
  flexure emit models/pendulum.flex --as dot | dot -Tsvg > pendulum.svg")]
pub struct Arguments {
    /// Model file (.flex)
    file: PathBuf,
    /// What to write
    #[arg(long = "as", value_enum, default_value_t = Form::Rust)]
    form: Form,
    /// File to write; standard output without it
    #[arg(short, long, value_name = "OUT")]
    output: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Form {
    /// Rust source, as the macro `include_model!` expands to
    Rust,
    /// The instructions that `simulate` runs
    Tape,
    /// The right-hand side as a graph for Graphviz, stage by stage
    Dot,
}

/// Does it.
///
/// # Errors
///
/// If the model is wrong, or the file cannot be written.
pub fn run(arguments: &Arguments, terminal: &Terminal) -> Result<(), Failure> {
    if let Some(output) = &arguments.output {
        output::spare_model(output, &arguments.file)?;
    }
    let file = arguments.output.as_deref().map(OutputFile::create);
    let file = file.transpose()?;
    let model = load(&arguments.file, terminal)?;
    let text = match arguments.form {
        Form::Rust => {
            let texts = Texts {
                equations: &report::text(model.equations()),
                latex: &report::latex(model.equations()),
            };
            codegen::rust_source(model.program(), texts, &quote!(::flexure::runtime))
        }
        Form::Tape => codegen::tape_listing(model.tape()),
        Form::Dot => codegen::dot(model.program()),
    };
    match file {
        Some(file) => file.finish_with(&text),
        None => print(|out| out.write_all(text.as_bytes())),
    }
}
