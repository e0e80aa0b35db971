//! The `flexure` command: its subcommands and options, and how a call ends.
//!
//! Each subcommand is a file: [`new`], [`check`], [`derive`], [`emit`], [`simulate`],
//! [`statics`], [`modes`], [`sweep`], [`response`], [`sensitivity`]. They report failures as
//! [`Failure`], which knows its exit status: 1 where the model or the run failed or a file could
//! not be read or written, 2 where the call itself is wrong (an unknown option, an unknown
//! parameter, a value in the wrong unit). A reader that closes the pipe early is no failure.

mod actuator;
mod axis;
mod charts;
mod check;
mod columns;
mod csv;
mod derive;
mod emit;
mod held;
mod modes;
mod new;
mod output;
mod panels;
mod portrait;
mod recording;
mod response;
mod sensitivity;
mod settings;
mod simulate;
mod statics;
mod sweep;
mod terminal;
mod yields;

use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::{Parser, Subcommand};
use flexure::runtime::diagnostic::Diagnostic;

use terminal::Terminal;

/// From a model file of a planar flexure mechanism to its equations of motion and its motion.
#[derive(Debug, Parser)]
#[command(
    name = "flexure",
    version,
    propagate_version = true,
    max_term_width = 100
)]
#[command(after_help = "\
Examples:
  flexure new my_stage                                     start a model
  flexure check my_stage.flex                              what the model says, and what is wrong
  flexure derive my_stage.flex                             its equations of motion
  flexure simulate my_stage.flex --until 20ms --plot my_stage.html
  flexure sweep my_stage.flex --vary f=100Hz..2kHz:100Hz --measure 'mean(stage.v)' -o speed.csv

Exit status: 0 done, 1 the model or the run failed, 2 the call is wrong.")]
struct Arguments {
    /// Say nothing but errors
    #[arg(short, long, global = true)]
    quiet: bool,
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    New(new::Arguments),
    Check(check::Arguments),
    Derive(derive::Arguments),
    Emit(emit::Arguments),
    Simulate(simulate::Arguments),
    Static(statics::Arguments),
    Modes(modes::Arguments),
    Sweep(sweep::Arguments),
    Response(response::Arguments),
    Sensitivity(sensitivity::Arguments),
}

/// Why a call did not do what it was asked.
#[derive(Debug)]
pub enum Failure {
    /// The model is wrong: every error that was found.
    Model(Vec<Diagnostic>),
    /// Something else failed: one line.
    Run(String),
    /// The call is wrong: one line.
    Usage(String),
    /// The same, said as a diagnostic with a hint.
    Setting(Vec<Diagnostic>),
    /// Whoever read standard output has stopped reading.
    ReaderGone,
}

impl Failure {
    /// A failure in words.
    pub fn run(words: impl Into<String>) -> Self {
        Self::Run(words.into())
    }

    /// An error of the model.
    pub fn model(error: Diagnostic) -> Self {
        Self::Model(vec![error])
    }

    /// A setting that does not fit the model.
    pub fn setting(error: Diagnostic) -> Self {
        Self::Setting(vec![error])
    }

    /// A wrong call in words.
    pub fn usage(words: impl Into<String>) -> Self {
        Self::Usage(words.into())
    }
}

/// Runs the command as called and tells how it ended.
pub fn run() -> ExitCode {
    // clap answers `--help` and wrong calls by itself, the latter with status 2.
    let Arguments { quiet, command } = Arguments::parse();
    let terminal = Terminal::new(quiet);
    let outcome = match command {
        Command::New(arguments) => new::run(&arguments, &terminal),
        Command::Check(arguments) => check::run(&arguments, &terminal),
        Command::Derive(arguments) => derive::run(&arguments, &terminal),
        Command::Emit(arguments) => emit::run(&arguments, &terminal),
        Command::Simulate(arguments) => simulate::run(&arguments, &terminal),
        Command::Static(arguments) => statics::run(&arguments, &terminal),
        Command::Modes(arguments) => modes::run(&arguments, &terminal),
        Command::Sweep(arguments) => sweep::run(&arguments, &terminal),
        Command::Response(arguments) => response::run(&arguments, &terminal),
        Command::Sensitivity(arguments) => sensitivity::run(&arguments, &terminal),
    };
    match outcome {
        Ok(()) | Err(Failure::ReaderGone) => ExitCode::SUCCESS,
        Err(Failure::Model(diagnostics)) => {
            terminal.diagnostics(&diagnostics);
            ExitCode::from(1)
        }
        Err(Failure::Run(message)) => {
            terminal.error(&message);
            ExitCode::from(1)
        }
        Err(Failure::Usage(message)) => {
            terminal.error(&message);
            ExitCode::from(2)
        }
        Err(Failure::Setting(diagnostics)) => {
            terminal.diagnostics(&diagnostics);
            ExitCode::from(2)
        }
    }
}

/// Writes to standard output; a reader that has gone is [`Failure::ReaderGone`].
///
/// # Errors
///
/// If standard output cannot be written to.
pub fn print(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
    let mut out = io::BufWriter::with_capacity(1 << 16, io::stdout().lock());
    write(&mut out)
        .and_then(|()| out.flush())
        .map_err(|why| match why.kind() {
            io::ErrorKind::BrokenPipe => Failure::ReaderGone,
            _ => output::cannot_write(&PathBuf::from("standard output"), &why),
        })
}
