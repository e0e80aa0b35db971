//! Equations in MathML, as a piece of an HTML page: headings, words, and tables of equations whose
//! equals signs stand in one column.
//!
//! Formulas are those of the LaTeX document, translated.

use std::fmt::Write;

use flexure_model_dsl::equations::{Equations, Line};
use flexure_model_dsl::symbolic::{Graph, Style};
use pulldown_latex::config::{DisplayMode, RenderConfig};
use pulldown_latex::{Parser, Storage, push_mathml};

use super::latex::{Block, blocks, code_and_words, is_short};
use super::{one_line, sign};

pub(super) fn fragment(equations: &Equations) -> String {
    let mut out = String::new();
    for section in &equations.report {
        let _ = writeln!(out, "<h3>{}</h3>", words_in_html(&section.title));
        for block in blocks(&section.lines) {
            match block {
                Block::Words(words) => {
                    let _ = writeln!(out, "<p>{}</p>", words_in_html(words));
                }
                Block::Mathematics(lines) => {
                    out.push_str("<table>\n");
                    rows(&mut out, &equations.graph, lines);
                    out.push_str("</table>\n");
                }
            }
        }
    }
    out
}

fn rows(out: &mut String, graph: &Graph, lines: &[Line]) {
    for line in lines {
        match line {
            Line::Text(_) => {}
            Line::Written { latex, .. } => {
                let _ = writeln!(out, "<tr><td colspan=\"3\">{}</td></tr>", formula(latex));
            }
            Line::Equation {
                text,
                latex,
                right,
                note,
            } => {
                let left = formula(latex);
                let note = words_in_html(note);
                let terms = graph.terms(*right, Style::Latex);
                if is_short(graph, text, *right) {
                    let right = formula(&format!("{{}}= {}", one_line(&terms, Style::Latex)));
                    row(out, &left, &right, &note);
                    continue;
                }
                for (index, term) in terms.iter().enumerate() {
                    let signed = format!("{}{}", sign(term, index == 0, Style::Latex), term.text);
                    if index == 0 {
                        row(out, &left, &formula(&format!("{{}}= {signed}")), &note);
                    } else {
                        row(out, "", &formula(&format!(r"\quad {{}}{signed}")), "");
                    }
                }
            }
        }
    }
}

fn row(out: &mut String, left: &str, right: &str, note: &str) {
    let _ = writeln!(
        out,
        "<tr><td class=\"left\">{left}</td><td>{right}</td><td class=\"note\">{note}</td></tr>"
    );
}

/// A formula in MathML. What cannot be translated is shown as the LaTeX that it is.
fn formula(latex: &str) -> String {
    let latex = without_dollars(latex);
    let storage = Storage::new();
    let config = RenderConfig {
        display_mode: DisplayMode::Block,
        ..RenderConfig::default()
    };
    let mut parsed = Vec::new();
    for event in Parser::new(&latex, &storage) {
        match event {
            Ok(event) => parsed.push(Ok::<_, std::convert::Infallible>(event)),
            Err(_) => return format!("<code>{}</code>", escaped(&latex)),
        }
    }
    let mut mathml = String::new();
    match push_mathml(&mut mathml, parsed.into_iter(), config) {
        // A name that HTML knows and XML does not.
        Ok(()) => mathml.replace("&nbsp;", "\u{a0}"),
        Err(_) => format!("<code>{}</code>", escaped(&latex)),
    }
}

/// Mathematics inside of `\text{…}`, between dollar signs, stands beside it instead.
fn without_dollars(latex: &str) -> String {
    let mut out = String::with_capacity(latex.len() + 8);
    let (mut is_inside, mut is_escaped) = (false, false);
    for c in latex.chars() {
        match c {
            '$' if !is_escaped => {
                out.push_str(if is_inside { r"\text{" } else { "}" });
                is_inside = !is_inside;
            }
            c => out.push(c),
        }
        is_escaped = c == '\\' && !is_escaped;
    }
    out
}

/// Words for HTML; what stands between backticks is set as code.
fn words_in_html(words: &str) -> String {
    let mut out = String::new();
    for (is_code, piece) in code_and_words(words) {
        let piece = escaped(piece);
        if is_code {
            let _ = write!(out, "<code>{piece}</code>");
        } else {
            out.push_str(&piece);
        }
    }
    out
}

fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            c if c.is_control() && !c.is_whitespace() => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}
