//! What a person at a terminal sees: coloured diagnostics, progress, exit status.

use std::fmt::Display;
use std::io::{self, IsTerminal, Write};
use std::time::Duration;

use flexure::runtime::diagnostic::{Diagnostic, Severity};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Messages to stderr.
#[derive(Clone, Copy, Debug)]
pub struct Terminal {
    quiet: bool,
    colours: bool,
}

const BOLD: &str = "\x1b[1m";
const RED: &str = "\x1b[1;31m";
const YELLOW: &str = "\x1b[1;33m";
const BLUE: &str = "\x1b[1;34m";
const CYAN: &str = "\x1b[36m";
const PLAIN: &str = "\x1b[0m";

impl Terminal {
    /// Messages as the user wants them; colours only on a terminal and unless `NO_COLOR` is set.
    pub fn new(quiet: bool) -> Self {
        let unwanted = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty())
            || std::env::var_os("TERM").is_some_and(|value| value == "dumb");
        Self {
            quiet,
            colours: io::stderr().is_terminal() && !unwanted,
        }
    }

    /// Says something that a quiet user does not want to hear.
    pub fn note(&self, words: impl Display) {
        if !self.quiet {
            say(&words);
        }
    }

    /// Reports warnings, unless the user is quiet.
    pub fn warnings(&self, warnings: &[Diagnostic]) {
        if !self.quiet {
            self.diagnostics(warnings);
        }
    }

    /// Reports errors and warnings.
    pub fn diagnostics(&self, diagnostics: &[Diagnostic]) {
        for diagnostic in diagnostics {
            say(&if self.colours {
                coloured(diagnostic)
            } else {
                diagnostic.to_string()
            });
            say(&"");
        }
    }

    /// Reports an error that is no diagnostic of a model.
    pub fn error(&self, message: &str) {
        say(&if self.colours {
            format!("{RED}error{PLAIN}{BOLD}: {message}{PLAIN}")
        } else {
            format!("error: {message}")
        });
    }

    /// A bar for long work; nothing is drawn unless a person sits before a terminal.
    pub fn progress(&self) -> ProgressBar {
        let target = if self.quiet {
            ProgressDrawTarget::hidden()
        } else {
            // Hidden by itself where stderr is no terminal.
            ProgressDrawTarget::stderr_with_hz(10)
        };
        let bar = ProgressBar::with_draw_target(Some(PROGRESS_STEPS), target);
        if let Ok(style) =
            ProgressStyle::with_template("{msg} [{bar:32}] {percent:>3} %  {eta} left")
        {
            bar.set_style(style.progress_chars("━╸ "));
        }
        bar.set_message("simulating");
        bar.enable_steady_tick(Duration::from_millis(200));
        bar
    }
}

/// Length of a progress bar.
pub const PROGRESS_STEPS: u64 = 1000;

fn say(words: &dyn Display) {
    // Nothing can be said when stderr is gone.
    let _ = writeln!(io::stderr(), "{words}");
}

/// A diagnostic in rustc's colours: the same text, line by line.
fn coloured(diagnostic: &Diagnostic) -> String {
    let severity = match diagnostic.severity {
        Severity::Error => RED,
        Severity::Warning => YELLOW,
    };
    let text = diagnostic.to_string();
    let message_lines = diagnostic.message.lines().count().max(1);
    let mut lines = Vec::new();
    for (index, line) in text.lines().enumerate() {
        lines.push(if index == 0 {
            match line.split_once(':') {
                Some((word, message)) => format!("{severity}{word}{PLAIN}{BOLD}:{message}{PLAIN}"),
                None => format!("{BOLD}{line}{PLAIN}"),
            }
        } else if index < message_lines {
            format!("{BOLD}{line}{PLAIN}")
        } else {
            coloured_line(line, severity)
        });
    }
    lines.join("\n")
}

fn coloured_line(line: &str, severity: &str) -> String {
    let bare = line.trim_start();
    let indent = &line[..line.len() - bare.len()];
    if let Some(place) = bare.strip_prefix("-->").or(bare.strip_prefix(":::")) {
        let arrow = &bare[..3];
        return format!("{indent}{BLUE}{arrow}{PLAIN}{place}");
    }
    if let Some(hint) = bare.strip_prefix("= hint:") {
        return format!("{indent}{BLUE}= {CYAN}hint:{PLAIN}{hint}");
    }
    let Some((gutter, rest)) = line.split_once('|') else {
        return line.to_owned();
    };
    let rest = if gutter.trim().is_empty() && rest.trim_start().starts_with(['^', '-']) {
        format!("{severity}{rest}{PLAIN}")
    } else {
        rest.to_owned()
    };
    format!("{BLUE}{gutter}|{PLAIN}{rest}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use flexure::runtime::diagnostic::Site;

    #[test]
    fn colours_change_no_character() {
        let site = Site {
            file: "a.flex".into(),
            line: 12,
            column: 3,
            width: 4,
            excerpt: "param | x = 3 mm -- \"b\"".into(),
        };
        let diagnostic = Diagnostic::error("no: such `thing`")
            .at(site.clone())
            .related(site, "first here")
            .hint("name it");
        let mut text = coloured(&diagnostic);
        assert!(text.contains(RED));
        for code in [BOLD, RED, YELLOW, BLUE, CYAN, PLAIN] {
            text = text.replace(code, "");
        }
        assert_eq!(text, diagnostic.to_string());
    }
}
