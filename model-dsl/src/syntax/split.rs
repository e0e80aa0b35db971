//! Cuts a file into items and sorts out comments, line ends and nesting.
//!
//! An item starts a line outside all brackets and ends before the next one. A line end separates
//! entries in braces and ends items, except inside parentheses, after a comma or an operator, and
//! before one. The text of an item has the same bytes as the file, only comments and line ends that
//! separate nothing are blanked, so places stay true.

use crate::source::Span;

use super::parse::KEYWORDS;
use super::problem::Problem;

/// Deepest nesting of brackets and conditionals.
pub(super) const DEEPEST: usize = 64;

/// Deepest nesting of items in items.
pub(super) const DEEPEST_BLOCK: usize = 16;

/// Words whose braces hold items.
const BLOCKS: [&str; 2] = ["component", "repeat"];

/// One item's text.
pub(super) struct Piece {
    /// Its place.
    pub span: Span,
    /// Its text, of the same length: comments are blanks, idle line ends are form feeds.
    pub text: String,
    /// What it does to the items that follow.
    pub role: Role,
}

/// What a piece does to the items that follow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// Nothing.
    Item,
    /// It starts an item that holds them.
    Opens,
    /// It ends that item; it has no text.
    Closes,
}

/// The pieces of a file.
pub(super) struct Split {
    /// Text of the `//!` comment.
    pub doc: String,
    /// Items in order.
    pub pieces: Vec<Piece>,
    /// What is wrong.
    pub problems: Vec<Problem>,
}

/// Cuts `text` into items.
pub(super) fn split(text: &str) -> Split {
    let mut splitter = Splitter {
        text,
        doc: Vec::new(),
        start: None,
        clean: String::new(),
        open: Vec::new(),
        blocks: Vec::new(),
        last: None,
        conditionals: 0,
        refused: false,
        pieces: Vec::new(),
        problems: Vec::new(),
    };
    splitter.run();
    Split {
        doc: splitter.doc.join("\n").trim().to_owned(),
        pieces: splitter.pieces,
        problems: splitter.problems,
    }
}

struct Splitter<'a> {
    text: &'a str,
    doc: Vec<&'a str>,
    /// Start of the present item.
    start: Option<usize>,
    /// Its text so far.
    clean: String,
    /// Open brackets with their places.
    open: Vec<(char, usize)>,
    /// Places of the braces of items that hold items.
    blocks: Vec<usize>,
    /// Last character that means something; a line end if that separates.
    last: Option<char>,
    /// Number of `if` in the present item.
    conditionals: usize,
    /// Whether the present item was refused already.
    refused: bool,
    pieces: Vec<Piece>,
    problems: Vec<Problem>,
}

impl<'a> Splitter<'a> {
    fn run(&mut self) {
        let mut at = 0;
        while let Some(c) = self.text[at..].chars().next() {
            let rest = &self.text[at..];
            at += match c {
                '\n' => self.line_end(at),
                '/' if rest.starts_with("//") => self.comment(rest),
                '"' => self.string(at, rest),
                '(' | '{' => self.opening(at, c),
                ')' | '}' => self.closing(at, c),
                // Signs and blanks that word processors put in place of plain ones.
                '\u{2212}' => self.keep_as(at, '-', c),
                '×' => self.keep_as(at, '*', c),
                '\u{FEFF}' => self.keep_as_blank(c),
                c if c.is_whitespace() && !c.is_ascii() => self.keep_as_blank(c),
                c if c.is_whitespace() => self.keep(at, c, false),
                c if is_word(c) => self.word(at, rest),
                c => self.keep(at, c, true),
            };
        }
        self.finish(Role::Item);
        if let Some(&at) = self.blocks.first() {
            self.problems.push(Problem::new(
                "`{` is never closed",
                Span::new(at, at + 1),
                "add the missing `}` after the last item that belongs here",
            ));
        }
        for _ in std::mem::take(&mut self.blocks) {
            self.close_block(self.text.len());
        }
    }

    fn close_block(&mut self, at: usize) {
        self.pieces.push(Piece {
            span: Span::new(at, at),
            text: String::new(),
            role: Role::Closes,
        });
    }

    /// Whether a brace after the present text holds items.
    fn holds_items(&self) -> bool {
        let end = self.clean.find(|c| !is_word(c)).unwrap_or(self.clean.len());
        self.start.is_some() && self.open.is_empty() && BLOCKS.contains(&&self.clean[..end])
    }

    fn keep(&mut self, at: usize, c: char, matters: bool) -> usize {
        if matters {
            self.begin(at);
            self.last = Some(c);
        }
        if self.start.is_some() {
            self.clean.push(c);
        }
        c.len_utf8()
    }

    /// Keeps `plain` instead of `c`, filled up with blanks so that places stay true.
    fn keep_as(&mut self, at: usize, plain: char, c: char) -> usize {
        self.keep(at, plain, true);
        let rest = c.len_utf8() - plain.len_utf8();
        self.clean.extend(std::iter::repeat_n(' ', rest));
        c.len_utf8()
    }

    fn keep_as_blank(&mut self, c: char) -> usize {
        if self.start.is_some() {
            self.clean.extend(std::iter::repeat_n(' ', c.len_utf8()));
        }
        c.len_utf8()
    }

    fn begin(&mut self, at: usize) {
        if self.start.is_none() {
            self.start = Some(at);
            self.clean.clear();
            self.refused = false;
            self.conditionals = 0;
        }
    }

    fn word(&mut self, at: usize, rest: &str) -> usize {
        let end = rest.find(|c| !is_word(c)).unwrap_or(rest.len());
        let word = &rest[..end];
        if self.start.is_some() && self.starts_item(at, rest, word) {
            self.finish(Role::Item);
        }
        self.begin(at);
        if word == "if" {
            self.conditionals += 1;
            self.check_depth(at, at + end);
        }
        self.clean.push_str(word);
        self.last = word.chars().next_back();
        if matches!(word, "and" | "or" | "then" | "else" | "if") {
            self.last = Some('+');
        }
        end
    }

    /// Whether an item seems to start here, although a bracket is open: a keyword at the very start
    /// of a line, with a name after it.
    fn starts_item(&self, at: usize, rest: &str, word: &str) -> bool {
        let at_line_start = at == 0 || self.text.as_bytes()[at - 1] == b'\n';
        let follower = rest[word.len()..].trim_start_matches([' ', '\t']);
        at_line_start
            && KEYWORDS.contains(&word)
            && follower.len() < rest.len() - word.len()
            && follower.chars().next().is_some_and(is_word)
    }

    fn comment(&mut self, rest: &'a str) -> usize {
        let end = rest.find('\n').unwrap_or(rest.len());
        let comment = &rest[..end];
        if let Some(doc) = comment.strip_prefix("//!")
            && self.start.is_none()
        {
            self.doc
                .push(doc.strip_prefix(' ').unwrap_or(doc).trim_end());
        }
        if self.start.is_some() {
            self.clean.extend(std::iter::repeat_n(' ', end));
        }
        end
    }

    fn string(&mut self, at: usize, rest: &str) -> usize {
        self.begin(at);
        let mut escaped = false;
        for (offset, c) in rest.char_indices().skip(1) {
            match c {
                '\n' => {
                    self.problems.push(Problem::new(
                        "these words have no closing quotation mark",
                        Span::new(at, at + offset),
                        "words stand between `\"` and `\"` on one line",
                    ));
                    // Blanked rather than kept, so that the item still has a chance to be read.
                    self.clean.extend(std::iter::repeat_n(' ', offset));
                    return offset;
                }
                '"' if !escaped => {
                    self.clean.push_str(&rest[..=offset]);
                    self.last = Some('"');
                    return offset + 1;
                }
                _ => escaped = c == '\\' && !escaped,
            }
        }
        self.problems.push(Problem::new(
            "these words have no closing quotation mark",
            Span::new(at, self.text.len()),
            "words stand between `\"` and `\"` on one line",
        ));
        self.clean.extend(std::iter::repeat_n(' ', rest.len()));
        rest.len()
    }

    fn opening(&mut self, at: usize, c: char) -> usize {
        if c == '{' && self.holds_items() {
            if self.blocks.len() == DEEPEST_BLOCK {
                self.problems.push(Problem::new(
                    format!("items stand in items more than {DEEPEST_BLOCK} levels deep"),
                    Span::new(at, at + 1),
                    "make a component of the inner ones",
                ));
            }
            self.blocks.push(at);
            self.finish(Role::Opens);
            return 1;
        }
        self.begin(at);
        self.open.push((c, at));
        self.check_depth(at, at + 1);
        self.keep(at, c, true)
    }

    fn closing(&mut self, at: usize, c: char) -> usize {
        if c == '}' && self.open.is_empty() && self.blocks.pop().is_some() {
            self.finish(Role::Item);
            self.close_block(at + 1);
            return 1;
        }
        let opening = if c == ')' { '(' } else { '{' };
        match self.open.last() {
            Some(&(open, _)) if open == opening => {
                self.open.pop();
                self.keep(at, c, true)
            }
            Some(&(open, place)) => {
                // A brace closes parentheses that were forgotten, so that the rest is readable.
                let hint = "close what was opened last first";
                let problem = Problem::new(
                    format!("`{open}` is closed by `{c}`"),
                    Span::new(at, at + 1),
                    hint,
                );
                self.refuse(problem.related(
                    Span::new(place, place + open.len_utf8()),
                    format!("`{open}` opens here"),
                ));
                while let Some((popped, _)) = self.open.pop() {
                    if popped == opening {
                        break;
                    }
                }
                self.keep(at, c, true)
            }
            None => {
                self.begin(at);
                self.refuse(Problem::new(
                    format!("`{c}` closes nothing"),
                    Span::new(at, at + 1),
                    "remove it, or open it first",
                ));
                self.keep(at, ' ', false)
            }
        }
    }

    fn line_end(&mut self, at: usize) -> usize {
        if self.start.is_none() {
            return 1;
        }
        let in_parentheses = matches!(self.open.last(), Some(('(', _)));
        let after_operator = matches!(
            self.last,
            Some(',' | '=' | '+' | '-' | '*' | '/' | '^' | '<' | '>' | '{' | ':' | '\n')
        );
        let idle = in_parentheses
            || after_operator
            || match next_character(&self.text[at..]) {
                Some('+' | '-' | '*' | '/' | '^' | '<' | '>' | ',' | '=') => true,
                Some('{') => self.open.is_empty(),
                Some('}' | ')') => !self.open.is_empty(),
                _ => false,
            };
        if idle {
            self.clean.push('\u{C}');
            self.last = Some('\n');
        } else if self.open.is_empty() {
            self.finish(Role::Item);
        } else {
            self.clean.push('\n');
            self.last = Some('\n');
        }
        1
    }

    fn check_depth(&mut self, start: usize, end: usize) {
        if self.open.len() + self.conditionals > DEEPEST {
            self.refuse(Problem::new(
                format!("this is nested more than {DEEPEST} levels deep"),
                Span::new(start, end),
                "name parts of it with `let` or `drive`",
            ));
        }
    }

    /// Reports the first problem of the present item and keeps the parser from seeing the item.
    fn refuse(&mut self, problem: Problem) {
        if !self.refused {
            self.problems.push(problem);
        }
        self.refused = true;
    }

    fn finish(&mut self, role: Role) {
        if let Some(&(c, at)) = self.open.first() {
            let closing = if c == '(' { ')' } else { '}' };
            self.refuse(Problem::new(
                format!("`{c}` is never closed"),
                Span::new(at, at + 1),
                format!("add the missing `{closing}`"),
            ));
        }
        self.open.clear();
        if let Some(start) = self.start.take() {
            let text = std::mem::take(&mut self.clean);
            let kept = text.trim_end().len();
            // What opens is kept, so that what closes it has its partner.
            if !self.refused || role == Role::Opens {
                self.pieces.push(Piece {
                    span: Span::new(start, start + kept),
                    text: text[..kept].to_owned(),
                    role,
                });
            }
        }
        self.last = None;
    }
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_' || c == '.'
}

/// The next character that is neither blank, nor a line end, nor in a comment.
fn next_character(mut rest: &str) -> Option<char> {
    loop {
        rest = rest.trim_start();
        if !rest.starts_with("//") {
            return rest.chars().next();
        }
        rest = &rest[rest.find('\n').unwrap_or(rest.len())..];
    }
}
