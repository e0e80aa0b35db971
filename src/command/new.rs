//! `flexure new`: a commented model file to start from.

use std::path::{Path, PathBuf};

use clap::Args;

use super::Failure;
use super::output::OutputFile;
use super::terminal::Terminal;

/// Write a commented model file to start from
#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  flexure new my_stage                                     writes my_stage.flex
  flexure simulate my_stage.flex --until 20ms --plot my_stage.html")]
pub struct Arguments {
    /// Name of the model; the file is NAME.flex
    name: PathBuf,
}

const TEMPLATE: &str = include_str!("new_model.flex");
const TEMPLATE_NAME: &str = "model my_stage\n";

/// Does it.
///
/// # Errors
///
/// If the file exists already, cannot be written, or the name is none that a model can have.
pub fn run(arguments: &Arguments, terminal: &Terminal) -> Result<(), Failure> {
    let path = file_of(&arguments.name);
    let name = model_name(&path)?;
    if path.exists() {
        return Err(Failure::run(format!(
            "`{}` is there already and stays as it is",
            path.display()
        )));
    }
    let text = TEMPLATE.replace(TEMPLATE_NAME, &format!("model {name}\n"));
    OutputFile::create(&path)?.finish_with(&text)?;
    terminal.note(format_args!("wrote {}", path.display()));
    terminal.note(format_args!(
        "try: flexure simulate {0} --until 20ms --plot {1}",
        path.display(),
        path.with_extension("html").display()
    ));
    Ok(())
}

/// `NAME.flex`, whether or not the user wrote the extension.
fn file_of(name: &Path) -> PathBuf {
    match name.extension() {
        Some(extension) if extension == "flex" => name.to_owned(),
        _ => {
            let mut file = name.as_os_str().to_owned();
            file.push(".flex");
            PathBuf::from(file)
        }
    }
}

/// The model's name from its file's: blanks, hyphens and dots become underscores.
fn model_name(path: &Path) -> Result<String, Failure> {
    let stem = path.file_stem().map(|stem| stem.to_string_lossy());
    let name = stem.unwrap_or_default().replace([' ', '-', '.'], "_");
    let starts_well = name.starts_with(|c: char| c.is_alphabetic());
    let goes_on_well = name.chars().all(|c| c.is_alphanumeric() || c == '_');
    if starts_well && goes_on_well {
        Ok(name)
    } else {
        Err(Failure::usage(format!(
            "`{name}` cannot be a model's name: it takes letters, digits and underscores, a letter first"
        )))
    }
}
