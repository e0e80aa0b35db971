//! One self-contained HTML page on a run: the mechanism, the curves, the numbers, the equations
//! and the settings, so that a reader can judge and repeat it. It loads nothing from anywhere.

use std::fmt::Write;

use super::figure;
use super::mechanism;
use super::panels::Panel;
use super::svg::{NIGHT, PAPER, RULES, escape};
use flexure::Places;

/// What the page shows. All text is plain and gets escaped here.
#[derive(Debug, Default)]
pub struct Page<'a> {
    /// Name of the model.
    pub title: &'a str,
    /// The model's own words on itself.
    pub doc: &'a str,
    /// The mechanism as assembled.
    pub places: Places,
    /// What was found on assembling it: what each line is about, and what is said.
    pub facts: Vec<(String, String)>,
    /// Time in s.
    pub time: &'a [f64],
    /// The curves.
    pub panels: &'a [Panel],
    /// Parameters.
    pub params: Vec<Row>,
    /// Columns of the result with start, end, least, greatest and mean value.
    pub results: Vec<[String; 6]>,
    /// The equations of motion as text.
    pub equations: &'a str,
    /// How it was simulated: name and value.
    pub settings: Vec<(String, String)>,
    /// Warnings as they were reported.
    pub warnings: Vec<String>,
    /// Why the run ended early, if it did.
    pub ended_early: Option<String>,
}

/// A parameter in the table.
#[derive(Debug)]
pub struct Row {
    /// Name.
    pub name: String,
    /// Value with its unit.
    pub value: String,
    /// The user's words on it.
    pub meaning: String,
    /// Whether it differs from the model's default.
    pub changed: bool,
}

/// The page as HTML.
pub fn page(page: &Page) -> String {
    let mut html = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>{}</title>\n<style>\n:root{{{PAPER}}}\n\
         @media (prefers-color-scheme: dark){{:root{{{NIGHT}}}}}\n\
         @media print{{:root{{{PAPER}}}}}\n{RULES}\n{LAYOUT}\n</style>\n</head>\n<body>\n<main>\n",
        escape(page.title)
    );
    head(&mut html, page);
    if let Some(why) = &page.ended_early {
        let _ = writeln!(html, "<p class=\"ended\">{}</p>", escape(why));
    }
    if let Some((picture, caption)) = mechanism::mechanism(&page.places) {
        html.push_str("<section>\n<h2>Mechanism</h2>\n<div class=\"mechanism\">\n<figure>\n");
        html.push_str(&picture);
        let _ = writeln!(html, "<figcaption>{caption}</figcaption>\n</figure>");
        list(&mut html, &page.facts);
        html.push_str("</div>\n</section>\n");
    }
    html.push_str("<section>\n<h2>Motion</h2>\n<figure class=\"curves\">\n");
    html.push_str(&figure::figure(page.time, page.panels));
    html.push_str("</figure>\n</section>\n");
    results(&mut html, page);
    html.push_str("<div class=\"columns\">\n");
    params(&mut html, page);
    settings(&mut html, page);
    html.push_str("</div>\n");
    if !page.warnings.is_empty() {
        html.push_str("<section>\n<h2>Warnings</h2>\n");
        for warning in &page.warnings {
            let _ = writeln!(html, "<pre>{}</pre>", escape(warning));
        }
        html.push_str("</section>\n");
    }
    let _ = writeln!(
        html,
        "<section>\n<h2>Equations of motion</h2>\n<pre class=\"equations\">{}</pre>\n</section>",
        escape(page.equations.trim_end())
    );
    let _ = writeln!(
        html,
        "<footer>flexure {}</footer>\n</main>\n</body>\n</html>",
        env!("CARGO_PKG_VERSION")
    );
    html
}

fn head(html: &mut String, page: &Page) {
    let _ = writeln!(
        html,
        "<header>\n<h1>{}</h1>",
        escape(&page.title.replace('_', " "))
    );
    for paragraph in page
        .doc
        .split("\n\n")
        .filter(|text| !text.trim().is_empty())
    {
        let _ = writeln!(html, "<p>{}</p>", with_code(paragraph.trim()));
    }
    html.push_str("</header>\n");
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

fn list(html: &mut String, facts: &[(String, String)]) {
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

fn results(html: &mut String, page: &Page) {
    html.push_str(
        "<section>\n<h2>Numbers</h2>\n<div class=\"wide\"><table class=\"numbers\">\n<thead><tr><th></th>\
         <th>start</th><th>end</th><th>least</th><th>greatest</th><th>mean</th></tr></thead>\n<tbody>\n",
    );
    for [name, rest @ ..] in &page.results {
        let _ = write!(html, "<tr><th>{}</th>", escape(name));
        for cell in rest {
            let _ = write!(html, "<td>{}</td>", escape(cell));
        }
        html.push_str("</tr>\n");
    }
    html.push_str("</tbody>\n</table></div>\n</section>\n");
}

fn params(html: &mut String, page: &Page) {
    if page.params.is_empty() {
        return;
    }
    html.push_str("<section>\n<h2>Parameters</h2>\n<table>\n<tbody>\n");
    for row in &page.params {
        let _ = writeln!(
            html,
            "<tr{}><th>{}</th><td class=\"value\">{}</td><td class=\"meaning\">{}</td></tr>",
            if row.changed {
                " class=\"changed\""
            } else {
                ""
            },
            escape(&row.name),
            escape(&row.value),
            escape(&row.meaning)
        );
    }
    html.push_str("</tbody>\n</table>\n");
    if page.params.iter().any(|row| row.changed) {
        html.push_str(
            "<p class=\"remark\">Marked: set for this run, not the model's default.</p>\n",
        );
    }
    html.push_str("</section>\n");
}

fn settings(html: &mut String, page: &Page) {
    html.push_str("<section>\n<h2>Run</h2>\n<table>\n<tbody>\n");
    for (name, value) in &page.settings {
        let _ = writeln!(
            html,
            "<tr><th class=\"plain\">{}</th><td>{}</td></tr>",
            escape(name),
            escape(value)
        );
    }
    html.push_str("</tbody>\n</table>\n</section>\n");
}

const LAYOUT: &str = "\
*{box-sizing:border-box}\
body{margin:0;background:var(--paper);color:var(--ink);font:15px/1.5 Inter,'Segoe UI',Helvetica,Arial,sans-serif}\
main{max-width:1020px;margin:0 auto;padding:32px 28px 48px}\
h1{font-size:27px;line-height:1.2;margin:0 0 6px;letter-spacing:-.01em}\
h2{font-size:13px;text-transform:uppercase;letter-spacing:.07em;color:var(--soft);margin:38px 0 10px;padding-bottom:5px;border-bottom:1px solid var(--grid)}\
code{font:.92em 'JetBrains Mono','SF Mono',Consolas,'DejaVu Sans Mono',monospace}\
header p{margin:4px 0;color:var(--soft);max-width:76ch}\
figure{margin:0}figure svg{width:100%;height:auto;display:block}\
figcaption,.remark{color:var(--soft);font-size:12.5px;margin:4px 0 0}\
.mechanism{display:flex;flex-wrap:wrap;gap:20px 34px;align-items:center}\
.mechanism figure{flex:1 1 540px}.facts{flex:1 1 300px;width:auto}.facts th{white-space:normal}\
table{border-collapse:collapse;width:100%;font-size:13.5px}\
th,td{text-align:left;padding:3.5px 14px 3.5px 0;border-bottom:1px solid var(--grid);vertical-align:baseline}\
tbody th{font-weight:600;white-space:nowrap}th.plain{font-weight:400;color:var(--soft)}\
thead th{font-weight:400;color:var(--soft)}\
td{font-variant-numeric:tabular-nums}.value{white-space:nowrap}.meaning{color:var(--soft)}\
.numbers td,.numbers thead th{text-align:right}.wide{overflow-x:auto}\
.changed th{color:var(--curve1)}.changed .value{color:var(--curve1);font-weight:600}\
.columns{display:grid;grid-template-columns:3fr 2fr;gap:0 44px}\
@media (max-width:760px){.columns{grid-template-columns:1fr}}\
pre{font:13px/1.55 'JetBrains Mono','SF Mono',Consolas,'DejaVu Sans Mono',monospace;overflow-x:auto;margin:0;padding:14px 16px;background:color-mix(in srgb,var(--grid) 38%,transparent);border-radius:6px}\
.ended{border-left:4px solid var(--contact);padding:8px 14px;margin:18px 0;background:color-mix(in srgb,var(--contact) 9%,transparent)}\
footer{margin-top:40px;color:var(--soft);font-size:12.5px}\
@media print{main{padding:0;max-width:none}section,tr{break-inside:avoid}.equations{break-inside:auto;white-space:pre-wrap}}";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn user_words_are_never_markup() {
        let evil = "<script>alert(1)</script>";
        let html = page(&Page {
            title: evil,
            doc: evil,
            facts: vec![(evil.to_owned(), evil.to_owned())],
            params: vec![Row {
                name: evil.to_owned(),
                value: evil.to_owned(),
                meaning: evil.to_owned(),
                changed: true,
            }],
            results: vec![std::array::from_fn(|_| evil.to_owned())],
            equations: evil,
            settings: vec![(evil.to_owned(), evil.to_owned())],
            warnings: vec![evil.to_owned()],
            ended_early: Some(evil.to_owned()),
            ..Page::default()
        });
        assert!(!html.contains("<script"));
        assert!(!html.contains("http://www.") || !html.contains("src="));
    }
}
