//! The equations for people: the sections of [`Equations::report`] as plain text, as a LaTeX
//! document, as Markdown with LaTeX mathematics, and in MathML for pages.
//!
//! Long sums stand one term to a line, with the operators in front and in one column.

mod latex;
mod mathml;
mod text;

use flexure_model_dsl::equations::Equations;
use flexure_model_dsl::symbolic::{Style, Term};

/// The equations as plain text, for a terminal.
pub fn text(equations: &Equations) -> String {
    text::write(equations)
}

/// The equations as a LaTeX document.
pub fn latex(equations: &Equations) -> String {
    latex::document(equations)
}

/// The equations as Markdown, with mathematics between double dollar signs.
pub fn markdown(equations: &Equations) -> String {
    latex::markdown(equations)
}

/// The equations as a piece of an HTML page, with mathematics in MathML: a heading of level three
/// for each section, tables of equations with the classes `left` and `note`.
pub fn mathml(equations: &Equations) -> String {
    mathml::fragment(equations)
}

/// Columns that a line of plain text should not exceed.
const WIDTH: usize = 96;

/// Columns that text takes: dots above letters take none.
fn width(text: &str) -> usize {
    text.chars()
        .filter(|c| !('\u{300}'..='\u{36f}').contains(c))
        .count()
}

/// The sign that stands before a term; `first` is the one behind the equals sign.
fn sign(term: &Term, first: bool, style: Style) -> &'static str {
    match (first, term.negative, style) {
        (true, false, _) => "",
        (true, true, _) => "-",
        (false, false, Style::Text) => "+ ",
        (false, true, Style::Text) => "- ",
        (false, false, Style::Latex) => "+ ",
        (false, true, Style::Latex) => "- ",
    }
}

/// All terms on one line.
fn one_line(terms: &[Term], style: Style) -> String {
    let mut line = String::new();
    for (index, term) in terms.iter().enumerate() {
        if index > 0 {
            line.push(' ');
        }
        line.push_str(sign(term, index == 0, style));
        line.push_str(&term.text);
    }
    line
}

#[cfg(test)]
mod tests;
