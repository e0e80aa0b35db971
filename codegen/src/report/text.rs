//! Equations as plain text: equals signs in a column, words on an equation behind it.

use flexure_model_dsl::equations::{Equations, Line};
use flexure_model_dsl::symbolic::{Graph, Style};

use super::{WIDTH, one_line, sign, width};

/// Columns by which equations are moved to the right.
const INDENT: usize = 2;

/// Left-hand sides longer than this are not lined up with others.
const LONGEST_LEFT: usize = 16;

/// Columns between an equation and the words on it, at least.
const GAP: usize = 3;

pub(super) fn write(equations: &Equations) -> String {
    let mut out = String::new();
    heading(&mut out, &equations.name, '═');
    if !equations.doc.is_empty() {
        out.push('\n');
        paragraphs(&mut out, &equations.doc);
    }
    for section in &equations.report {
        out.push('\n');
        heading(&mut out, &section.title, '─');
        out.push('\n');
        let mut lines = &section.lines[..];
        while let Some(first) = lines.first() {
            match first {
                Line::Text(words) => {
                    paragraphs(&mut out, words);
                    lines = &lines[1..];
                }
                Line::Written { text, .. } => {
                    for row in text.lines() {
                        wrapped(&mut out, &" ".repeat(INDENT), row);
                    }
                    lines = &lines[1..];
                }
                Line::Equation { .. } => {
                    let count = lines
                        .iter()
                        .take_while(|line| matches!(line, Line::Equation { .. }))
                        .count();
                    let (group, rest) = lines.split_at(count);
                    equation_group(&mut out, &equations.graph, group);
                    lines = rest;
                }
            }
            let kinds_differ = lines
                .first()
                .is_some_and(|next| std::mem::discriminant(next) != std::mem::discriminant(first));
            if kinds_differ {
                out.push('\n');
            }
        }
    }
    out
}

fn heading(out: &mut String, title: &str, line: char) {
    out.push_str(title);
    out.push('\n');
    out.extend(std::iter::repeat_n(line, width(title)));
    out.push('\n');
}

/// Words, line by line as they are; a paragraph with a line that is too long is filled anew.
fn paragraphs(out: &mut String, words: &str) {
    let lines: Vec<&str> = words.lines().map(str::trim_end).collect();
    let mut filled = Vec::new();
    for paragraph in lines.chunk_by(|a, b| a.is_empty() == b.is_empty()) {
        if paragraph.iter().any(|line| width(line) > WIDTH) {
            filled.push(paragraph.join(" "));
        } else {
            filled.extend(paragraph.iter().map(|line| (*line).to_owned()));
        }
    }
    for line in filled {
        let mut column = 0;
        for word in line.split_whitespace() {
            let taken = width(word);
            if column > 0 && column + 1 + taken > WIDTH {
                out.push('\n');
                column = 0;
            } else if column > 0 {
                out.push(' ');
                column += 1;
            }
            out.push_str(word);
            column += taken;
        }
        out.push('\n');
    }
}

/// An equation of a group, laid out.
struct Laid<'a> {
    left: &'a str,
    /// What stands behind the equals sign, line by line, operators included.
    right: Vec<String>,
    note: &'a str,
}

fn equation_group(out: &mut String, graph: &Graph, lines: &[Line]) {
    let column = lines
        .iter()
        .filter_map(|line| match line {
            Line::Equation { text, .. } => Some(width(text)),
            Line::Text(_) | Line::Written { .. } => None,
        })
        .filter(|&left| left <= LONGEST_LEFT)
        .max()
        .unwrap_or(0);
    let laid: Vec<Laid> = lines
        .iter()
        .filter_map(|line| match line {
            Line::Equation {
                text, right, note, ..
            } => {
                let behind = INDENT + column.max(width(text)) + 3;
                let terms = graph.terms(*right, Style::Text);
                let single = one_line(&terms, Style::Text);
                let right = if terms.len() < 2 || behind + width(&single) <= WIDTH {
                    vec![single]
                } else {
                    let first_of = |index: usize| sign(&terms[index], index == 0, Style::Text);
                    (0..terms.len())
                        .map(|index| format!("{}{}", first_of(index), terms[index].text))
                        .collect()
                };
                Some(Laid {
                    left: text,
                    right,
                    note,
                })
            }
            Line::Text(_) | Line::Written { .. } => None,
        })
        .collect();
    // Words stand in one column behind the equations that leave room for them.
    let longest_note = laid.iter().map(|line| width(line.note)).max().unwrap_or(0);
    let room = WIDTH.saturating_sub(longest_note + GAP);
    let note_column = laid
        .iter()
        .filter(|line| !line.note.is_empty() && line.right.len() == 1)
        .map(|line| INDENT + column.max(width(line.left)) + 3 + width(&line.right[0]))
        .filter(|&end| end <= room)
        .max()
        .unwrap_or(0)
        + GAP;

    for Laid { left, right, note } in laid {
        let pad = column.saturating_sub(width(left));
        let start = format!("{}{left}{}", " ".repeat(INDENT), " ".repeat(pad));
        let behind = width(&start) + 3;
        for (index, term) in right.iter().enumerate() {
            let mut line = if index == 0 {
                format!("{start} = {term}")
            } else {
                format!("{}{term}", " ".repeat(behind - 2))
            };
            let is_last = index + 1 == right.len();
            let end = width(&line);
            if is_last && !note.is_empty() && end + GAP <= note_column {
                line.push_str(&" ".repeat(note_column - end));
                line.push_str(note);
                out.push_str(&line);
                out.push('\n');
                continue;
            }
            wrapped_at(out, &line, behind + 2);
            if is_last && !note.is_empty() {
                out.push_str(&" ".repeat(behind));
                out.push_str(note);
                out.push('\n');
            }
        }
    }
}

/// A line that is broken where it is too long.
fn wrapped(out: &mut String, indent: &str, line: &str) {
    let hanging = width(indent) + 4;
    wrapped_at(out, &format!("{indent}{line}"), hanging);
}

/// Breaks a line before operators, as far outside of parentheses as may be; what follows starts
/// at column `hanging`.
fn wrapped_at(out: &mut String, line: &str, hanging: usize) {
    let hanging = hanging.min(WIDTH / 2);
    let mut rest = line.to_owned();
    while width(&rest) > WIDTH {
        let Some(at) = break_position(&rest, hanging) else {
            break;
        };
        out.push_str(rest[..at].trim_end());
        out.push('\n');
        rest = format!("{}{}", " ".repeat(hanging), rest[at..].trim_start());
    }
    out.push_str(&rest);
    out.push('\n');
}

/// Where to break: a blank before an operator at the least depth, or else the last blank.
fn break_position(line: &str, hanging: usize) -> Option<usize> {
    let mut depth = 0i32;
    let mut column = 0;
    let mut best: Option<(i32, usize)> = None;
    let mut blank = None;
    for (at, c) in line.char_indices() {
        if column > WIDTH {
            break;
        }
        match c {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            ' ' if column > hanging + 8 => {
                let next = &line[at + 1..];
                let operator = ["+ ", "- ", "/ ", "= ", "> ", "then ", "else "];
                // A fraction is held together more than the sum that it stands in.
                let level = 2 * depth + i32::from(next.starts_with("/ "));
                if operator.iter().any(|o| next.starts_with(o))
                    && best.is_none_or(|(known, _)| level <= known)
                {
                    best = Some((level, at));
                }
                blank = Some(at);
            }
            _ => {}
        }
        column += width(c.encode_utf8(&mut [0; 4]));
    }
    best.map(|(_, at)| at).or(blank)
}
