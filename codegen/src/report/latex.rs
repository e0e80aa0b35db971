//! Equations in LaTeX: a document of its own, or Markdown around the same mathematics.

use flexure_model_dsl::equations::{Equations, Line};
use flexure_model_dsl::notation::escape_latex;
use flexure_model_dsl::symbolic::{Expr, Graph, Style};

use super::{one_line, sign, width};

/// Columns of plain text beyond which a sum gets a line for each term.
const LINE: usize = 80;

pub(super) fn document(equations: &Equations) -> String {
    let mut out = String::from(PREAMBLE);
    let title = escape_latex(&equations.name);
    out.push_str(&format!("\\section*{{{title}}}\n"));
    out.push_str(&words_in_latex(&equations.doc));
    for section in &equations.report {
        let title = words_in_latex(&section.title);
        out.push_str(&format!("\n\\subsection*{{{}}}\n", title.trim_end()));
        for block in blocks(&section.lines) {
            match block {
                Block::Words(words) => out.push_str(&words_in_latex(words)),
                Block::Mathematics(lines) => {
                    let rows = rows(&equations.graph, lines);
                    out.push_str(&format!("\\begin{{align*}}\n{rows}\n\\end{{align*}}\n"));
                }
            }
        }
    }
    out.push_str("\n\\end{document}\n");
    out
}

const PREAMBLE: &str = r"\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\begin{document}

";

pub(super) fn markdown(equations: &Equations) -> String {
    let mut out = format!("# {}\n", words_in_markdown(&equations.name));
    if !equations.doc.is_empty() {
        out.push_str(&format!("\n{}\n", words_in_markdown(&equations.doc)));
    }
    for section in &equations.report {
        out.push_str(&format!("\n## {}\n", words_in_markdown(&section.title)));
        for block in blocks(&section.lines) {
            match block {
                Block::Words(words) => out.push_str(&format!("\n{}\n", words_in_markdown(words))),
                Block::Mathematics(lines) => {
                    let rows = rows(&equations.graph, lines);
                    out.push_str(&format!(
                        "\n$$\n\\begin{{aligned}}\n{rows}\n\\end{{aligned}}\n$$\n"
                    ));
                }
            }
        }
    }
    out
}

pub(super) enum Block<'a> {
    Words(&'a str),
    Mathematics(&'a [Line]),
}

/// Words, and runs of equations.
pub(super) fn blocks(lines: &[Line]) -> Vec<Block<'_>> {
    lines
        .chunk_by(|a, b| !matches!(a, Line::Text(_)) && !matches!(b, Line::Text(_)))
        .map(|chunk| match chunk {
            [Line::Text(words), ..] => Block::Words(words),
            _ => Block::Mathematics(chunk),
        })
        .collect()
}

/// Whether an equation takes one line: it has one term, or is short in plain text.
pub(super) fn is_short(graph: &Graph, left: &str, right: Expr) -> bool {
    let terms = graph.terms(right, Style::Text);
    terms.len() < 2 || width(left) + 3 + width(&one_line(&terms, Style::Text)) <= LINE
}

/// The rows of an alignment.
fn rows(graph: &Graph, lines: &[Line]) -> String {
    let mut rows: Vec<String> = Vec::new();
    for line in lines {
        match line {
            Line::Text(_) => {}
            Line::Written { latex, .. } => rows.push(format!("& {latex}")),
            Line::Equation {
                text,
                latex,
                right,
                note,
            } => {
                let note = if note.is_empty() {
                    String::new()
                } else {
                    format!(r" && \text{{{}}}", words_in_latex(note).trim_end())
                };
                let terms = graph.terms(*right, Style::Latex);
                if is_short(graph, text, *right) {
                    let right = one_line(&terms, Style::Latex);
                    rows.push(format!("{latex} &= {right}{note}"));
                    continue;
                }
                for (index, term) in terms.iter().enumerate() {
                    let signed = format!("{}{}", sign(term, index == 0, Style::Latex), term.text);
                    rows.push(if index == 0 {
                        format!("{latex} &= {signed}{note}")
                    } else {
                        format!(r"&\quad {{}}{signed}")
                    });
                }
            }
        }
    }
    rows.join(" \\\\\n")
}

/// Words for LaTeX; what stands between backticks is set like typing.
fn words_in_latex(words: &str) -> String {
    let mut out = String::new();
    for (is_code, piece) in code_and_words(words) {
        let escaped = escape_latex(piece);
        if is_code {
            out.push_str(&format!(r"\texttt{{{escaped}}}"));
        } else {
            out.push_str(&escaped);
        }
    }
    out.truncate(out.trim_end().len());
    if !out.is_empty() {
        out.push('\n');
    }
    out
}

/// Words for Markdown; what stands between backticks stays as it is.
fn words_in_markdown(words: &str) -> String {
    let mut out = String::new();
    for (is_code, piece) in code_and_words(words) {
        if is_code {
            out.push_str(&format!("`{piece}`"));
            continue;
        }
        for c in piece.chars() {
            match c {
                '&' => out.push_str("&amp;"),
                '<' => out.push_str("&lt;"),
                '>' => out.push_str("&gt;"),
                '\\' | '`' | '*' | '_' | '[' | ']' | '#' | '|' | '~' | '$' => {
                    out.push('\\');
                    out.push(c);
                }
                c => out.push(c),
            }
        }
    }
    out
}

/// Pieces of words and of code (between two backticks on one line), in turn.
pub(super) fn code_and_words(words: &str) -> Vec<(bool, &str)> {
    let mut pieces = Vec::new();
    let mut rest = words;
    while let Some(open) = rest.find('`') {
        let behind = &rest[open + 1..];
        let close = behind.find(['`', '\n']).filter(|&at| at > 0);
        match close {
            Some(at) if behind[at..].starts_with('`') => {
                pieces.push((false, &rest[..open]));
                pieces.push((true, &behind[..at]));
                rest = &behind[at + 1..];
            }
            _ => {
                pieces.push((false, &rest[..=open]));
                rest = behind;
            }
        }
    }
    pieces.push((false, rest));
    pieces
}
