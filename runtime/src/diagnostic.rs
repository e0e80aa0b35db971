//! What is wrong with a model or a parameter set, and how it is said.
//!
//! The command, the macro and `prepare` of generated code all report a [`Diagnostic`] and all print
//! it with the same [`Display`](std::fmt::Display), so that one mistake reads the same wherever it
//! is made. This lives in the runtime because compiled `prepare` reports errors without the
//! compiler at hand; a [`Site`] can therefore be a constant.

use std::borrow::Cow;
use std::fmt;

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Severity {
    /// Nothing can be made of the model or the parameter set.
    Error,
    /// It can be used; the reader should know.
    Warning,
}

/// A place in a model file, with the line that stands there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Site {
    /// The file, as the user named it.
    pub file: Cow<'static, str>,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// Number of characters to underline, at least 1.
    pub width: usize,
    /// The text of the line.
    pub excerpt: Cow<'static, str>,
}

/// One error or warning.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// How bad it is.
    pub severity: Severity,
    /// What is wrong: one line, lower case, names in backticks, no full stop.
    pub message: String,
    /// Where; `None` for what no line of a model file causes.
    pub site: Option<Site>,
    /// What would mend it.
    pub hint: Option<String>,
    /// Other places involved, each with a word on its part.
    pub related: Vec<(Site, String)>,
}

impl Diagnostic {
    /// An error.
    pub fn error(message: impl Into<String>) -> Self {
        Self::new(Severity::Error, message.into())
    }

    /// A warning.
    pub fn warning(message: impl Into<String>) -> Self {
        Self::new(Severity::Warning, message.into())
    }

    fn new(severity: Severity, message: String) -> Self {
        Self {
            severity,
            message,
            site: None,
            hint: None,
            related: Vec::new(),
        }
    }

    /// The same, at a place.
    pub fn at(mut self, site: Site) -> Self {
        self.site = Some(site);
        self
    }

    /// The same, with what would mend it.
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }

    /// The same, with another place involved.
    pub fn related(mut self, site: Site, label: impl Into<String>) -> Self {
        self.related.push((site, label.into()));
        self
    }
}

impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let severity = match self.severity {
            Severity::Error => "error",
            Severity::Warning => "warning",
        };
        write!(f, "{severity}: {}", self.message)?;
        let lines = self
            .site
            .iter()
            .chain(self.related.iter().map(|(site, _)| site));
        let gutter = lines
            .map(|site| site.line.to_string().len())
            .max()
            .unwrap_or(1);
        if let Some(site) = &self.site {
            write_site(f, site, gutter, "-->", "")?;
        }
        for (site, label) in &self.related {
            write_site(f, site, gutter, ":::", label)?;
        }
        if let Some(hint) = &self.hint {
            write!(f, "\n{:gutter$} = hint: {hint}", "")?;
        }
        Ok(())
    }
}

fn write_site(
    f: &mut fmt::Formatter<'_>,
    site: &Site,
    gutter: usize,
    arrow: &str,
    label: &str,
) -> fmt::Result {
    write!(
        f,
        "\n{:gutter$}{arrow} {}:{}:{}",
        "", site.file, site.line, site.column
    )?;
    write!(f, "\n{:gutter$} |", "")?;
    write!(f, "\n{:>gutter$} | {}", site.line, site.excerpt)?;
    // Tabs are kept so that the marks stand under what they mark.
    let indent: String = site
        .excerpt
        .chars()
        .take(site.column.saturating_sub(1))
        .map(|c| if c == '\t' { '\t' } else { ' ' })
        .collect();
    let marks = if arrow == "-->" { "^" } else { "-" }.repeat(site.width.max(1));
    write!(f, "\n{:gutter$} | {indent}{marks}", "")?;
    if !label.is_empty() {
        write!(f, " {label}")?;
    }
    Ok(())
}

impl std::error::Error for Diagnostic {}
