//! `flexure derive`: the equations of motion, for people.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use flexure::codegen::report;

use super::settings::load;
use super::terminal::Terminal;
use super::{Failure, print};

/// Derive the equations of motion in closed form and print them
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  flexure derive models/double_rocker.flex
  flexure derive models/double_rocker.flex --format latex > equations.tex")]
pub struct Arguments {
    /// Model file (.flex)
    file: PathBuf,
    /// How to write them
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    /// Plain text
    Text,
    /// A LaTeX document
    Latex,
    /// Markdown with formulas in LaTeX
    Markdown,
}

/// Does it.
///
/// # Errors
///
/// If the model is wrong.
pub fn run(arguments: &Arguments, terminal: &Terminal) -> Result<(), Failure> {
    let model = load(&arguments.file, terminal)?;
    let equations = match arguments.format {
        Format::Text => report::text(model.equations()),
        Format::Latex => report::latex(model.equations()),
        Format::Markdown => report::markdown(model.equations()),
    };
    print(|out| writeln!(out, "{}", equations.trim_end()))
}
