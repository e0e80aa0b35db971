//! From a tree with components, parts and repeats to one in which everything is written out, so
//! that nothing after it knows of them.
//!
//! ```text
//! files (`use`) ─▶ components, constants ─▶ plan: parts, turns of repeats, their scopes
//!   ─▶ write: every item once per scope, with names made whole and counters made numbers
//! ```
//!
//! A thing `web` of the part `left` is named `left.web`; `up[3]` is `up3`, and after a digit an
//! underscore keeps the two apart, as in `x1_3`. A component sees its own names and the constants
//! of the files, nothing else. Places are those of [`Source`]'s copies, so that a message shows
//! what is written and which part or turn it is about.

mod files;
mod plan;
mod scope;
mod whole;
mod write;

use crate::source::Source;
use crate::syntax::Problem;
use crate::syntax::tree::{File, ItemKind, Name};

/// What [`expand`] gives.
pub struct Expanded {
    /// The file with everything written out.
    pub file: File,
    /// What is wrong.
    pub problems: Vec<Problem>,
    /// Paths of the files that were used.
    pub files: Vec<String>,
    /// Components of the file itself of which there is no part.
    pub unused: Vec<Name>,
}

/// Writes out components, parts and repeats of `file`; `source` learns of used files and copies.
/// `read` gives the text of a file by its path.
pub fn expand(
    file: File,
    source: &mut Source,
    read: &dyn Fn(&str) -> Result<String, String>,
) -> Expanded {
    let mut library = files::library(&file, source, read);
    let problems = std::mem::take(&mut library.problems);
    let plan = plan::plan(&file, &library, source, problems);
    let unused = file.items.iter().filter_map(|item| match &item.kind {
        ItemKind::Component(component) if !plan.made.contains(component.name.text.as_str()) => {
            Some(component.name.clone())
        }
        _ => None,
    });
    let unused = unused.collect();
    let (items, mut problems) = write::write(plan);
    problems.sort_by_key(|problem| problem.span);
    Expanded {
        file: File {
            doc: file.doc.clone(),
            items,
        },
        problems,
        files: library.paths,
        unused,
    }
}
