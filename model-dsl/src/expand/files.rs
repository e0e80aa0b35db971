//! Components and constants of a file and of the files that it uses.

use std::collections::BTreeMap;

use super::whole::whole;
use crate::source::{Source, Span};
use crate::syntax::tree::{Component, File, Item, ItemKind, UsedFile};
use crate::syntax::{Problem, parse};

/// Most files that one model uses.
const MOST_FILES: usize = 100;

/// Longest text of all used files, in bytes.
const LONGEST_TEXT: usize = 16 << 20;

/// What parts and repeats are made of.
#[derive(Default)]
pub(super) struct Library {
    /// Components by name, each with its whole place.
    pub components: BTreeMap<String, (Component, Span)>,
    /// Constants by name, each with where it is declared.
    pub constants: BTreeMap<String, (i64, Span)>,
    /// Paths of used files, in order.
    pub paths: Vec<String>,
    /// What is wrong.
    pub problems: Vec<Problem>,
}

/// A file to be read: its path, where it is used, and which used file uses it.
struct Wanted {
    path: String,
    span: Span,
    user: Option<usize>,
}

/// Reads all files that `file` uses.
pub(super) fn library(
    file: &File,
    source: &mut Source,
    read: &dyn Fn(&str) -> Result<String, String>,
) -> Library {
    let mut library = Library::default();
    let mut wanted: Vec<Wanted> = Vec::new();
    library.take(&file.items, None, &mut wanted);
    // For each used file: where it is used, and which used file uses it.
    let mut users: Vec<(Span, Option<usize>)> = Vec::new();
    let mut length = 0;
    let mut next = 0;
    while next < wanted.len() {
        let Wanted { path, span, user } = &wanted[next];
        let (path, span, user) = (path.clone(), *span, *user);
        next += 1;
        if let Some(known) = library.paths.iter().position(|known| *known == path) {
            let mut above = user;
            while let Some(index) = above {
                if index == known {
                    let message = format!("`{path}` uses itself");
                    let hint = "move what both files need to a third one";
                    let problem = Problem::new(message, span, hint);
                    let problem = problem.related(users[known].0, "it is used here");
                    library.problems.push(problem);
                    break;
                }
                above = users[index].1;
            }
            continue;
        }
        let text = match read(&path) {
            Ok(text) => text,
            Err(reason) => {
                let message = format!("`{path}` cannot be read: {reason}");
                let hint = "the path is relative to the file that uses it";
                library.problems.push(Problem::new(message, span, hint));
                continue;
            }
        };
        length += text.len();
        if library.paths.len() == MOST_FILES || length > LONGEST_TEXT {
            let message = "this model uses too many or too large files";
            let hint = format!(
                "at most {MOST_FILES} files and {} MiB of text can be used",
                LONGEST_TEXT >> 20
            );
            library.problems.push(Problem::new(message, span, hint));
            break;
        }
        let base = source.add_file(&path, &text);
        let (used, problems) = parse(&text, base);
        library.problems.extend(problems);
        library.paths.push(path);
        users.push((span, user));
        library.take(&used.items, Some(users.len() - 1), &mut wanted);
        library.refuse_others(&used.items, span);
    }
    library
}

impl Library {
    /// Takes components, constants and uses of one file; `user` says which used file it is.
    fn take(&mut self, items: &[Item], user: Option<usize>, wanted: &mut Vec<Wanted>) {
        for item in items {
            match &item.kind {
                ItemKind::Component(component) => {
                    let name = &component.name;
                    if let Some((earlier, _)) = self.components.get(&name.text) {
                        let earlier = earlier.name.span;
                        self.twice(&name.text, name.span, earlier);
                        continue;
                    }
                    let known = (component.clone(), item.span);
                    self.components.insert(name.text.clone(), known);
                }
                ItemKind::Constants(list) => {
                    for (name, value) in list {
                        if let Some(&(_, earlier)) = self.constants.get(&name.text) {
                            self.twice(&name.text, name.span, earlier);
                            continue;
                        }
                        let known = |name: &str| self.constants.get(name).map(|&(value, _)| value);
                        match whole(&value.text, &known) {
                            Ok(number) => {
                                self.constants
                                    .insert(name.text.clone(), (number, name.span));
                            }
                            Err(message) => {
                                let hint = "a constant is made of whole numbers and of constants \
                                            declared before it";
                                self.problems.push(Problem::new(message, value.span, hint));
                            }
                        }
                    }
                }
                ItemKind::Use(UsedFile { path }) => {
                    let folder = user
                        .and_then(|index| self.paths[index].rsplit_once('/'))
                        .map_or(String::new(), |(folder, _)| format!("{folder}/"));
                    wanted.push(Wanted {
                        path: format!("{folder}{path}"),
                        span: item.span,
                        user,
                    });
                }
                _ => {}
            }
        }
    }

    fn twice(&mut self, name: &str, span: Span, earlier: Span) {
        let problem = Problem::new(
            format!("`{name}` is declared twice"),
            span,
            "give one of the two another name: components and constants of all used files share \
             one list of names",
        );
        self.problems
            .push(problem.related(earlier, "declared here first"));
    }

    /// Refuses what cannot be used from another file.
    fn refuse_others(&mut self, items: &[Item], user: Span) {
        let other = items.iter().find(|item| {
            !matches!(
                item.kind,
                ItemKind::Component(_) | ItemKind::Constants(_) | ItemKind::Use(_)
            )
        });
        if let Some(item) = other {
            let problem = Problem::new(
                "a file that is used holds components and constants only",
                item.span,
                "move this item into a component, or into the model file",
            );
            self.problems
                .push(problem.related(user, "the file is used here"));
        }
    }
}
