//! What is wrong with a text, and pest's errors in the language's own words.

use pest::error::{ErrorVariant, InputLocation};

use super::grammar::Rule;
use super::parse::KEYWORDS;
use crate::source::Span;
use crate::suggest::closest;

/// Something that is wrong with the text.
#[derive(Clone, Debug)]
pub struct Problem {
    /// What.
    pub message: String,
    /// Where.
    pub span: Span,
    /// What would mend it.
    pub hint: String,
    /// Other places.
    pub related: Vec<(Span, String)>,
}

impl Problem {
    /// A problem at a place.
    pub fn new(message: impl Into<String>, span: Span, hint: impl Into<String>) -> Self {
        Self {
            message: message.into(),
            span,
            hint: hint.into(),
            related: Vec::new(),
        }
    }

    /// The same, with another place.
    pub fn related(mut self, span: Span, label: impl Into<String>) -> Self {
        self.related.push((span, label.into()));
        self
    }
}

/// An item that starts with no known word.
pub(super) fn unknown_item(text: &str, word: &str, span: Span) -> Problem {
    let rest = text[word.len()..].trim_start();
    if word.is_empty() {
        return Problem::new(
            "an item starts with a word that says what it is",
            span,
            format!("the words are {}", listed(&KEYWORDS)),
        );
    }
    let hint = match closest(word, KEYWORDS.iter().copied()) {
        Some(near) => format!("did you mean `{near}`?"),
        None if rest.starts_with('=') => format!(
            "to declare a quantity write `param {word} = …`, or `let {word} = …` if it follows from others"
        ),
        None => format!("an item starts with one of {}", listed(&KEYWORDS)),
    };
    Problem::new(format!("`{word}` starts no item"), span, hint)
}

/// Words in backticks with commas.
pub(crate) fn listed(words: &[impl AsRef<str>]) -> String {
    let quoted: Vec<String> = words
        .iter()
        .map(|word| format!("`{}`", word.as_ref()))
        .collect();
    quoted.join(", ")
}

/// Turns pest's error into one in the language's own words.
pub(super) fn explain(
    error: pest::error::Error<Rule>,
    text: &str,
    base: usize,
    keyword: &str,
    form: &str,
) -> Problem {
    let (start, end) = match error.location {
        InputLocation::Pos(at) => (at, at),
        InputLocation::Span((start, end)) => (start, end),
    };
    let found: String = text[start..]
        .chars()
        .take_while(|c| c.is_alphanumeric() || *c == '_')
        .collect();
    let width = found
        .len()
        .max(text[start..].chars().next().map_or(0, char::len_utf8));
    let span = Span::new(base + start, base + end.max(start + width));
    let next = text[start..].chars().next();
    let after_digit = text[..start].ends_with(|c: char| c.is_ascii_digit());
    let digit_follows = text[start..]
        .chars()
        .nth(1)
        .is_some_and(|c| c.is_ascii_digit());
    if next == Some('.') && after_digit && !digit_follows {
        let message = "a decimal point needs a digit after it";
        return Problem::new(message, span, "write `3` or `3.0`");
    }
    let found = match next {
        None | Some('\n') => "the end of the line".to_owned(),
        Some(c) if found.is_empty() => format!("`{c}`"),
        Some(_) => format!("`{found}`"),
    };
    let mut expected: Vec<&str> = match &error.variant {
        ErrorVariant::ParsingError { positives, .. } => positives
            .iter()
            .filter_map(|&rule| describe(rule))
            .collect(),
        ErrorVariant::CustomError { .. } => Vec::new(),
    };
    expected.sort_unstable();
    expected.dedup();
    let after_value = expected.contains(&"an operator");
    if after_value && next.is_some_and(|c| c.is_alphanumeric() || "_\"({°%".contains(c)) {
        return Problem::new(
            format!("something is missing before {found}"),
            span,
            format!("two values need an operator or a comma between them: `{form}`"),
        );
    }
    if expected.len() > 1 {
        expected.retain(|words| *words != "words in quotation marks");
    }
    if expected.contains(&"a whole number")
        && let Some(digits) = text[start..].strip_prefix(|c: char| c.is_ascii_digit())
        && digits.contains('.')
    {
        let number: String = text[start..]
            .chars()
            .take_while(|c| c.is_ascii_digit() || *c == '.')
            .collect();
        let span = Span::new(base + start, base + start + number.len());
        let message = format!("`{number}` is no whole number");
        return Problem::new(message, span, format!("it is written `{form}`"));
    }
    let message = match expected.as_slice() {
        [] => format!("this `{keyword}` cannot be read from {found} on"),
        [one] => format!("{one} is expected here, not {found}"),
        [first @ .., last] => {
            format!(
                "{} or {last} is expected here, not {found}",
                first.join(", ")
            )
        }
    };
    Problem::new(message, span, format!("it is written `{form}`"))
}

/// What a rule is called in messages; `None` for rules that would not help.
fn describe(rule: Rule) -> Option<&'static str> {
    Some(match rule {
        Rule::name | Rule::label | Rule::dotted | Rule::path | Rule::keyword | Rule::entry_at => {
            "a name"
        }
        Rule::whole | Rule::index => "a whole number",
        Rule::parameter => "a parameter `NAME: KIND`",
        Rule::constant => "`NAME = WHOLE NUMBER`",
        Rule::binding => "`POINT = PLACE`",
        Rule::bindings => "`at`",
        Rule::text | Rule::words => "words in quotation marks",
        Rule::literal
        | Rule::number
        | Rule::expression
        | Rule::conditional
        | Rule::reference
        | Rule::parentheses
        | Rule::argument
        | Rule::sign => "a value",
        Rule::operator => "an operator",
        Rule::unit | Rule::input_unit | Rule::not_a_unit => "a unit",
        Rule::arguments => return None,
        Rule::entries => "`{`",
        Rule::entry => "an entry `NAME = VALUE`",
        Rule::declaration | Rule::initial => "`NAME = VALUE`",
        Rule::on_clause => "`on`",
        Rule::along_clause => "`along`",
        Rule::through_clause => "`through`",
        Rule::from_clause => "`from`",
        Rule::two_paths | Rule::two_names => "two names joined by `and`",
        Rule::EOI => "the end of the item",
        Rule::kw_exact | Rule::kw_and | Rule::kw_or => return None,
        rule => return word_of(rule).filter(|word| !word.is_empty()),
    })
}

/// The word of the grammar that a rule is.
pub(super) fn word_of(rule: Rule) -> Option<&'static str> {
    Some(match rule {
        Rule::kw_on => "`on`",
        Rule::kw_at => "`at`",
        Rule::kw_to => "`to`",
        Rule::kw_from => "`from`",
        Rule::kw_along => "`along`",
        Rule::kw_through => "`through`",
        Rule::kw_between => "`between`",
        Rule::kw_when => "`when`",
        Rule::kw_if => "`if`",
        Rule::kw_then => "`then`",
        Rule::kw_else => "`else`",
        Rule::kw_and | Rule::kw_or | Rule::keyword | Rule::EOI => "",
        _ => return None,
    })
}
