//! The page around the sections: head, contents, verdicts, foot, and the script that copies tables
//! and moves the mechanism; without it the page shows all but that.

use std::fmt::Write;

use super::blocks;
use super::style::LAYOUT;
use super::{Block, Report, Section, Verdict};
use crate::picture::svg::{NIGHT, PAPER, RULES, escape};

/// Sections from which on a page has a table of contents.
const CONTENTS: usize = 6;

/// The page as HTML.
pub fn page(report: &Report) -> String {
    let title = escape(&report.title);
    let mut html = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>{title}</title>\n<style>\n:root{{{PAPER}}}\n\
         @media screen and (prefers-color-scheme: dark){{:root{{{NIGHT}}}}}\n\
         {RULES}\n{LAYOUT}\n</style>\n</head>\n<body>\n<main>\n<header>\n<h1>{title}</h1>\n"
    );
    blocks::paragraphs(&mut html, &report.words);
    html.push_str("</header>\n");
    if report.sections.len() >= CONTENTS {
        contents(&mut html, &report.sections);
    }
    for (index, section) in report.sections.iter().enumerate() {
        let _ = writeln!(
            html,
            "<section id=\"part-{}\">\n<h2>{}</h2>",
            index + 1,
            escape(&section.title)
        );
        for block in &section.blocks {
            blocks::block(&mut html, block);
        }
        html.push_str("</section>\n");
    }
    let _ = writeln!(
        html,
        "<footer>Made by flexure {}.</footer>\n</main>\n<script>\n{SCRIPT}</script>\n</body>\n</html>",
        env!("CARGO_PKG_VERSION")
    );
    html
}

/// Links to the sections, each with what became of its claims.
fn contents(html: &mut String, sections: &[Section]) {
    html.push_str("<nav>\n<ol>\n");
    for (index, section) in sections.iter().enumerate() {
        let _ = write!(
            html,
            "<li><a href=\"#part-{}\">{}</a>",
            index + 1,
            escape(&section.title)
        );
        for block in &section.blocks {
            if let Block::Finding(finding) = block {
                let _ = write!(html, " {}", blocks::chip(finding.verdict));
            }
        }
        html.push_str("</li>\n");
    }
    html.push_str("</ol>\n");
    let count = |verdict: Verdict| {
        let blocks = sections.iter().flat_map(|section| &section.blocks);
        blocks
            .filter(|block| matches!(block, Block::Finding(finding) if finding.verdict == verdict))
            .count()
    };
    let verdicts = [
        Verdict::Holds,
        Verdict::InPart,
        Verdict::Fails,
        Verdict::Open,
    ];
    let counted: Vec<String> = verdicts
        .into_iter()
        .filter(|&verdict| count(verdict) > 0)
        .map(|verdict| format!("{} {}", count(verdict), blocks::chip(verdict)))
        .collect();
    if !counted.is_empty() {
        let _ = writeln!(
            html,
            "<p class=\"remark\">Findings: {}</p>",
            counted.join(", ")
        );
    }
    html.push_str("</nav>\n");
}

/// Copies the values behind a figure; shows the mechanism at the time that a slider says, and plays
/// a cycle in four seconds, unless the reader wants no motion.
const SCRIPT: &str = "\
for (const button of document.querySelectorAll('button.copy')) {
  button.hidden = !navigator.clipboard;
  button.onclick = () => {
    const values = button.parentElement.querySelector('pre').textContent;
    navigator.clipboard.writeText(values).then(() => { button.textContent = 'Copied'; });
  };
}
for (const figure of document.querySelectorAll('figure.motion')) {
  const [button, slider, output] = figure.querySelector('.controls').children;
  const times = figure.dataset.times.split('|');
  const parts = [...figure.querySelectorAll('path[data-d]')];
  const lines = parts.map(part => part.dataset.d.split('|'));
  const last = times.length - 1;
  let timer = 0;
  const show = frame => {
    slider.value = frame;
    output.textContent = times[frame];
    parts.forEach((part, index) => part.setAttribute('d', lines[index][frame]));
  };
  const stop = () => { clearInterval(timer); timer = 0; button.textContent = 'Play'; };
  const play = () => {
    timer = setInterval(() => show((+slider.value + 1) % last), 4000 / last);
    button.textContent = 'Pause';
  };
  button.onclick = () => timer ? stop() : play();
  slider.oninput = () => { stop(); show(+slider.value); };
  figure.querySelector('.controls').hidden = false;
  show(0);
  if (!matchMedia('(prefers-reduced-motion: reduce)').matches) play();
}
";

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::{Axis, Bars, Chart, Graphic, Look, Panel, Series};
    use crate::report::{Column, Figure, Finding, Table};
    use crate::{Model, Places};

    const EVIL: &str = "<script>alert(1)</script>`<b>`";

    /// A page with a piece of every kind, all words hostile.
    fn page() -> Report {
        let evil = || EVIL.to_owned();
        let model = Model::from_source(
            "a.flex",
            "//! <b>\nmodel a\nparam k = 1 N/m \"<script>\"\nslide s along (1, 0) { mass = 1 kg }\n\
             spring c between ground and s { stiffness = k }\n",
        )
        .unwrap();
        let mut design = model.design();
        design.set("k", 2.0).unwrap();
        let places = Places {
            marks: vec![(evil(), [0.0; 2], Some(true))],
            ..Places::default()
        };
        let finding = |verdict| {
            Block::Finding(Finding {
                claim: evil(),
                verdict,
                reason: evil(),
            })
        };
        let series = Series::new(EVIL, [1.0, 2.0], [f64::NAN, 1.0], Look::LineAndPoints);
        let chart = Chart {
            title: evil(),
            x: Axis::linear(EVIL, EVIL),
            panels: vec![Panel {
                series: vec![series],
                ..Panel::default()
            }],
            ordered: true,
        };
        let bars = Bars {
            title: evil(),
            names: vec![evil()],
            groups: vec![(evil(), vec![1.0])],
            ..Bars::default()
        };
        let blocks = vec![
            Block::Words(evil()),
            finding(Verdict::Holds),
            finding(Verdict::InPart),
            finding(Verdict::Fails),
            finding(Verdict::Open),
            Block::Figure(Figure::new(Graphic::Chart(chart.clone()), EVIL)),
            Block::Figure(Figure::new(Graphic::Bars(bars), EVIL)),
            Block::Figure(Figure::new(Graphic::Grid(vec![chart.clone(), chart]), EVIL)),
            Block::Table(
                Table {
                    columns: vec![
                        Column::words(EVIL, [evil()]),
                        Column::numbers(EVIL, EVIL, [1.0]),
                    ],
                },
                evil(),
            ),
            Block::Facts(vec![(evil(), evil())]),
            Block::Notice(evil()),
            Block::Code(evil()),
            Block::Mechanism(Box::new(places), vec![(evil(), evil())]),
            Block::params(&design),
            Block::mechanism(&mut design.assembled().unwrap()),
            Block::equations(&model),
        ];
        let beside = Block::Beside(vec![Section::new(EVIL, blocks.clone())]);
        let mut report = Report::new(EVIL);
        report.words = evil();
        report.sections = vec![Section::new(EVIL, blocks), Section::new(EVIL, [beside])];
        while report.sections.len() < CONTENTS {
            report.sections.push(Section::new(EVIL, []));
        }
        report
    }

    #[test]
    fn a_page_is_well_formed_whatever_the_words() {
        let html = page().html();
        // Written so that it reads as XML, but for what HTML has no end of.
        let xml = html
            .replace("<!DOCTYPE html>", "")
            .replace("<br>", "<br/>")
            .replace(" hidden>", " hidden=\"\">");
        let mut closed = String::new();
        for line in xml.lines() {
            closed.push_str(&match line.starts_with("<meta") {
                true => line.replace('>', "/>"),
                false => line.to_owned(),
            });
            closed.push('\n');
        }
        let start = closed.find("<script>").unwrap();
        assert_eq!(closed.matches("<script>").count(), 1, "the page's own");
        assert!(!closed.contains("<b>"));
        let end = closed.find("</script>").unwrap();
        closed.replace_range(start..end, "<script>");
        if let Err(why) = roxmltree::Document::parse(&closed) {
            let row = why.pos().row as usize;
            panic!("{why}: {}", closed.lines().nth(row - 1).unwrap_or(""));
        }
        let mine = html.replace("http://www.w3.org/", "");
        for outside in ["http", " src=", "url(", "@import"] {
            assert!(!mine.contains(outside), "{outside}");
        }
    }

    #[test]
    fn a_page_made_twice_is_the_same() {
        assert_eq!(page().html(), page().html());
    }

    #[test]
    fn contents_count_the_verdicts() {
        let html = page().html();
        assert!(html.contains("<nav>") && html.contains("href=\"#part-6\""));
        let finding = html.matches("1 <span class=\"chip partly\">◐ holds in part</span>");
        assert_eq!(finding.count(), 1);
    }
}
