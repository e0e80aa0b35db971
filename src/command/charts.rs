//! Charts of studies as files: a picture alone, or a page with the numbers behind it, the mechanism
//! and its params.

use std::path::{Path, PathBuf};

use flexure::Design;
use flexure::picture::Graphic;
use flexure::report::{Block, Figure, Report, Section};

use super::Failure;
use super::output::same_file;

/// The path of a picture as it is written in a call.
///
/// # Errors
///
/// If it ends neither in `.svg` nor in `.html`.
pub fn path(text: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(text);
    match path.extension().and_then(|extension| extension.to_str()) {
        Some("svg" | "html") => Ok(path),
        _ => Err("a picture is a file that ends in .svg or .html".to_owned()),
    }
}

/// Whether a picture is to be a page.
pub fn is_page(path: &Path) -> bool {
    path.extension()
        .is_some_and(|extension| extension == "html")
}

/// Keeps a call from writing its table and its picture into one file.
///
/// # Errors
///
/// If both are the same.
pub fn keep_apart(table: Option<&Path>, picture: Option<&Path>) -> Result<(), Failure> {
    match (table, picture) {
        (Some(table), Some(picture)) if same_file(table, picture) => Err(Failure::usage(format!(
            "`{}` cannot be both the table and the picture",
            picture.display()
        ))),
        _ => Ok(()),
    }
}

/// Pictures of a study and what is said of each.
pub struct Charts<'a> {
    /// What the study is, in a few words: the title of a page.
    pub title: String,
    /// The model as it was studied.
    pub design: &'a Design,
    /// How the numbers were made: what each line is about, and what is said.
    pub settings: Vec<(String, String)>,
    /// The pictures with their captions.
    pub figures: Vec<(Graphic, String)>,
}

impl Charts<'_> {
    /// The text of the file: SVG of the first picture, or a page of all.
    ///
    /// # Errors
    ///
    /// If the page's mechanism cannot be assembled.
    pub fn file(self, path: &Path) -> Result<String, Failure> {
        if !is_page(path) {
            let first = self.figures.first();
            return Ok(first.map_or_else(String::new, |(graphic, _)| graphic.file()));
        }
        let mut assembled = self.design.assembled().map_err(Failure::model)?;
        let model = self.design.model();
        let mut report = Report::new(self.title);
        report.words.clone_from(&model.equations().doc);
        let figures = self.figures.into_iter();
        let figures =
            figures.map(|(graphic, caption)| Block::Figure(Figure::new(graphic, caption)));
        report.sections = vec![
            Section::new("Results", figures.collect::<Vec<_>>()),
            Section::new("Mechanism", [Block::mechanism(&mut assembled)]),
            Section::new(
                "Settings",
                [Block::Beside(vec![
                    Section::new("Parameters", [Block::params(self.design)]),
                    Section::new("Study", [Block::Facts(self.settings)]),
                ])],
            ),
        ];
        Ok(report.html())
    }
}
