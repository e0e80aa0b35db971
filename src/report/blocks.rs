//! The pieces of a page as HTML.

use std::fmt::Write;

use flexure_codegen::report;
use flexure_model_dsl::units::Mark;

use super::{Block, Figure, Finding, Motion, Table, Verdict};
use crate::Design;
use crate::picture::svg::escape;
use crate::picture::{mechanism, moving, with_unit};

/// Appends a piece.
pub fn block(html: &mut String, block: &Block) {
    match block {
        Block::Words(words) => paragraphs(html, words),
        Block::Finding(of) => finding(html, of),
        Block::Figure(of) => figure(html, of),
        Block::Table(table, words) => {
            paragraphs(html, words);
            html.push_str(&table.html());
        }
        Block::Facts(of) => facts(html, of),
        Block::Notice(words) => {
            let _ = writeln!(html, "<p class=\"notice\">{}</p>", with_code(words));
        }
        Block::Code(text) => {
            let _ = writeln!(html, "<pre>{}</pre>", escape(text));
        }
        Block::Mechanism(places, of) => {
            html.push_str("<div class=\"mechanism\">\n");
            if let Some((picture, caption)) = mechanism(places) {
                let _ = writeln!(
                    html,
                    "<figure>\n{picture}<figcaption>{caption}</figcaption>\n</figure>"
                );
            }
            facts(html, of);
            html.push_str("</div>\n");
        }
        Block::Motion(motion) => self::motion(html, motion),
        Block::Params(design) => params(html, design),
        Block::Equations(model) => {
            html.push_str("<div class=\"equations\">\n");
            html.push_str(&report::mathml(model.equations()));
            html.push_str("</div>\n");
        }
        Block::Beside(sections) => {
            html.push_str("<div class=\"columns\">\n");
            for section in sections {
                let _ = writeln!(html, "<div>\n<h3>{}</h3>", escape(&section.title));
                for of in &section.blocks {
                    self::block(html, of);
                }
                html.push_str("</div>\n");
            }
            html.push_str("</div>\n");
        }
    }
}

/// Appends paragraphs that are set apart by empty lines.
pub fn paragraphs(html: &mut String, words: &str) {
    for paragraph in words.split("\n\n").filter(|text| !text.trim().is_empty()) {
        let _ = writeln!(html, "<p>{}</p>", with_code(paragraph.trim()));
    }
}

/// A verdict in a word or two.
pub fn chip(verdict: Verdict) -> String {
    let (class, sign, words) = match verdict {
        Verdict::Holds => ("holds", "✓", "holds"),
        Verdict::InPart => ("partly", "◐", "holds in part"),
        Verdict::Fails => ("fails", "✗", "does not hold"),
        Verdict::Open => ("open", "?", "not judged"),
    };
    format!("<span class=\"chip {class}\">{sign} {words}</span>")
}

fn finding(html: &mut String, finding: &Finding) {
    let class = match finding.verdict {
        Verdict::Holds => "holds",
        Verdict::InPart => "partly",
        Verdict::Fails => "fails",
        Verdict::Open => "open",
    };
    let _ = writeln!(
        html,
        "<div class=\"finding {class}\">\n<p class=\"claim\">{} {}</p>",
        chip(finding.verdict),
        with_code(&finding.claim)
    );
    paragraphs(html, &finding.reason);
    html.push_str("</div>\n");
}

fn figure(html: &mut String, figure: &Figure) {
    let _ = writeln!(
        html,
        "<figure>\n<div class=\"picture\">\n{}</div>",
        figure.graphic.inline()
    );
    if !figure.caption.is_empty() {
        let _ = writeln!(
            html,
            "<figcaption>{}</figcaption>",
            with_code(&figure.caption)
        );
    }
    html.push_str("</figure>\n");
    if let Some(table) = &figure.table {
        behind(html, table);
    }
}

/// The table behind a figure, folded, and its values for copying.
fn behind(html: &mut String, table: &Table) {
    let _ = writeln!(
        html,
        "<details class=\"behind\">\n<summary>Table ({} rows)</summary>\n{}\
         <details>\n<summary>As comma-separated values, in SI</summary>\n\
         <button class=\"copy\" type=\"button\" hidden>Copy</button>\n\
         <pre class=\"values\">{}</pre>\n</details>\n</details>",
        table.rows(),
        table.html(),
        escape(&table.csv())
    );
}

/// The mechanism with a slider for time; without a script it stands still.
fn motion(html: &mut String, motion: &Motion) {
    let Some((picture, caption)) = moving(&motion.places, &motion.frames) else {
        return;
    };
    let [from, to] = [motion.times.first(), motion.times.last()]
        .map(|time| with_unit(time.copied().unwrap_or(0.0), "s", 6));
    let times: Vec<String> = motion.times.iter().map(|&t| with_unit(t, "s", 5)).collect();
    let _ = writeln!(
        html,
        "<figure class=\"motion\" data-times=\"{}\">\n{picture}\
         <div class=\"controls\" hidden><button type=\"button\">Play</button>\
         <input type=\"range\" min=\"0\" max=\"{}\" value=\"0\" aria-label=\"time\"/>\
         <output></output></div>\n\
         <figcaption>From {from} to {to}. {caption}</figcaption>\n</figure>",
        times.join("|"),
        motion.frames.len().saturating_sub(1)
    );
}

fn facts(html: &mut String, facts: &[(String, String)]) {
    if facts.is_empty() {
        return;
    }
    html.push_str("<table class=\"facts\">\n<tbody>\n");
    let mut last = "";
    for (subject, words) in facts {
        let shown = if subject == last { "" } else { subject };
        let _ = writeln!(
            html,
            "<tr><th class=\"plain\">{}</th><td>{}</td></tr>",
            escape(shown),
            with_code(words)
        );
        last = subject;
    }
    html.push_str("</tbody>\n</table>\n");
}

fn params(html: &mut String, design: &Design) {
    let model = design.model();
    let declared = model.params().iter().zip(&model.equations().params);
    let mut any_changed = false;
    html.push_str("<table class=\"params\">\n<tbody>\n");
    for ((param, declared), &value) in declared.zip(design.values()) {
        let is_changed = param.start != Some(value);
        any_changed |= is_changed;
        let written = match declared.dimension.mark() {
            Mark::Frequency => with_unit(value, "Hz", 10),
            Mark::AngularRate => with_unit(value, "rad/s", 10),
            Mark::Plain => with_unit(value, &param.unit, 10),
        };
        let _ = writeln!(
            html,
            "<tr{}><th>{}</th><td class=\"value\">{}</td><td class=\"meaning\">{}</td></tr>",
            if is_changed { " class=\"changed\"" } else { "" },
            escape(&param.name),
            escape(&written),
            escape(&param.meaning)
        );
    }
    html.push_str("</tbody>\n</table>\n");
    if any_changed {
        html.push_str(
            "<p class=\"remark\">Marked: set for this study, not the model's default.</p>\n",
        );
    }
}

/// Words with what stands between backticks set as code.
fn with_code(words: &str) -> String {
    let parts: Vec<&str> = words.split('`').collect();
    let mut html = String::new();
    for (index, part) in parts.iter().enumerate() {
        let part = escape(part);
        // Every second part stands between two backticks, except behind a last single one.
        let code = index % 2 == 1 && index + 1 < parts.len();
        if code {
            let _ = write!(html, "<code>{part}</code>");
        } else if index % 2 == 1 {
            let _ = write!(html, "`{part}");
        } else {
            html.push_str(&part);
        }
    }
    html
}
