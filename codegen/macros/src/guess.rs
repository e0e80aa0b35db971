//! What can be told of a model that does not compile: its name, and those of its params and sets.
//!
//! They go into the skeleton that stands beside the error, so that code that uses the model does
//! not fail as well.

/// The name after `model`, if a line has one.
pub(crate) fn name(text: &str) -> Option<String> {
    text.lines().find_map(|line| {
        let name = word(line.trim_start().strip_prefix("model")?)?;
        Some(name.to_owned())
    })
}

/// Names of params: what stands before each `=` on lines that start with `param`.
pub(crate) fn params(text: &str) -> Vec<String> {
    text.lines()
        .filter_map(|line| line.trim_start().strip_prefix("param "))
        .flat_map(|line| line.split(','))
        .filter_map(|part| {
            let (before, _) = part.split_once('=')?;
            let before = before.trim();
            let is_name = !before.is_empty()
                && before
                    .chars()
                    .all(|character| character.is_alphanumeric() || character == '_');
            is_name.then(|| before.to_owned())
        })
        .collect()
}

/// Names of sets.
pub(crate) fn sets(text: &str) -> Vec<String> {
    text.lines()
        .filter_map(|line| word(line.trim_start().strip_prefix("set")?))
        .map(str::to_owned)
        .collect()
}

/// The word after blanks.
fn word(text: &str) -> Option<&str> {
    if !text.starts_with(char::is_whitespace) {
        return None;
    }
    let text = text.trim_start();
    let end = text
        .find(|character: char| !character.is_alphanumeric() && character != '_')
        .unwrap_or(text.len());
    (end > 0).then(|| &text[..end])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_found_in_what_does_not_compile() {
        let text = "//! words\n  model rocker # no\nparam a = 1 m, b = 2 furlong \"x = y\"\nmodels x\nset soft { a = 2 m }";
        assert_eq!(name(text).as_deref(), Some("rocker"));
        assert_eq!(params(text), ["a", "b"]);
        assert_eq!(sets(text), ["soft"]);
        assert_eq!(name("modelling x"), None);
    }
}
