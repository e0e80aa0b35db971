//! How an expression is written down: plain text or LaTeX.

/// How to write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Style {
    /// Plain text, for a terminal.
    Text,
    /// LaTeX mathematics, without dollar signs.
    Latex,
}
