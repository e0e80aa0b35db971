//! Reports of what is unusual: long equations, words with special characters.

use flexure_model_dsl::compile;
use flexure_model_dsl::equations::{Equations, Line, Section};
use flexure_model_dsl::notation::latex_of;
use flexure_model_dsl::source::Source;
use flexure_model_dsl::symbolic::Expr;

use super::*;

/// The equations of a small model, with nothing in their report.
fn equations() -> Equations {
    let text = "//! 50 % of `E_1` & <b>$x$</b> \\input{a} #1 * two *\n\
                model a_b\n\
                slide s along (1, 0) { mass = 1 kg }\n";
    match compile(Source::new("a.flex", text), &|_| Err(String::new())) {
        Ok((mut equations, _)) => {
            equations.report.clear();
            equations
        }
        Err(errors) => panic!("{errors:#?}"),
    }
}

fn symbol(equations: &mut Equations, name: &str) -> Expr {
    let symbol = equations.graph.symbol(name, latex_of(name));
    equations.graph.of(symbol)
}

fn equation(left: &str, right: Expr, note: &str) -> Line {
    Line::Equation {
        text: left.to_owned(),
        latex: latex_of(left),
        right,
        note: note.to_owned(),
    }
}

/// Equations of all lengths, words, and equations already written.
fn unusual() -> Equations {
    let mut e = equations();
    let [a, b] = ["a", "b"].map(|name| symbol(&mut e, name));
    let long: Vec<Expr> = (0..7)
        .map(|index| symbol(&mut e, &format!("a_long_name_{index}")))
        .collect();
    let g = &mut e.graph;
    let short = g.sub(b, a);
    let sum = g.sum(&long);
    let first = g.neg(long[0]);
    let difference = g.sum(&[first, long[1], long[2], long[3], long[4], long[5], long[6]]);
    let product = g.product(&[a, sum, difference]);
    let quotient = g.div(product, b);
    let square = g.powi(sum, 2);
    let deep = g.add(quotient, square);
    let negative = g.neg(a);
    let text = "every_thing = a + b + c + d + e + f + g + h + i + j + k + l + m + n + o + p + q + r \
                + s + t + u + v";
    e.report = vec![Section {
        title: "Forces of `crank` <1>".to_owned(),
        lines: vec![
            Line::Text("Words come first, & may be many: ".to_owned() + &"word ".repeat(30)),
            equation("x", short, "a short one"),
            equation("φ̈1", negative, "with dots & <signs>"),
            equation("sum", sum, ""),
            equation("sum2", difference, "what the difference is"),
            equation("deep", deep, ""),
            equation("a_left_side_that_is_long", a, "lined up with nothing"),
            Line::Written {
                text: text.to_owned(),
                latex: "x = y".to_owned(),
            },
            Line::Text("Last words".to_owned()),
        ],
    }];
    e
}

#[test]
fn plain_text() {
    let text = text(&unusual());
    assert!(text.lines().all(|line| width(line) <= WIDTH), "{text}");
    insta::assert_snapshot!(text);
}

#[test]
fn latex_document() {
    let latex = latex(&unusual());
    for (open, close) in [("{", "}"), (r"\left", r"\right"), (r"\begin", r"\end")] {
        let escaped = latex.matches(&format!(r"\{open}")).count();
        let count = |text: &str| latex.matches(text).count();
        let escaped = if open == "{" { escaped } else { 0 };
        let escaped_close = if open == "{" { count(r"\}") } else { 0 };
        assert_eq!(
            count(open) - escaped,
            count(close) - escaped_close,
            "{latex}"
        );
    }
    insta::assert_snapshot!(latex);
}

#[test]
fn markdown_text() {
    let markdown = markdown(&unusual());
    assert!(!markdown.contains("<b>"));
    insta::assert_snapshot!(markdown);
}

/// Reads as XML, with nothing left of LaTeX and no word taken for markup.
fn well_formed(mathml: &str) {
    let page = format!("<div>{mathml}</div>");
    let document = match roxmltree::Document::parse(&page) {
        Ok(document) => document,
        Err(why) => {
            let line = page.lines().nth(why.pos().row as usize - 1).unwrap_or("");
            panic!("{why}: {line}");
        }
    };
    for node in document.descendants() {
        assert!(
            !["merror", "b", "input"].contains(&node.tag_name().name()),
            "{mathml}"
        );
        if let Some(text) = node.text()
            && node.ancestors().any(|n| n.tag_name().name() == "math")
        {
            assert!(!text.contains(['\\', '$', '^', '_']), "{text}");
        }
        // A formula that could not be translated stands as code in a cell.
        let is_cell = node.tag_name().name() == "td" && node.attribute("class") != Some("note");
        let has_code = node
            .children()
            .any(|child| child.tag_name().name() == "code");
        assert!(
            !(is_cell && has_code),
            "{:?}",
            node.descendants().find_map(|n| n.text())
        );
    }
}

#[test]
fn mathml_fragment() {
    let mathml = mathml(&unusual());
    well_formed(&mathml);
    insta::assert_snapshot!(mathml);
}

#[test]
fn mathml_of_all_models() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../models");
    let mut files: Vec<_> = std::fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == "flex")
        })
        .collect();
    files.sort();
    assert!(files.len() > 10);
    for path in files {
        let text = std::fs::read_to_string(&path).unwrap();
        let file = path.display().to_string();
        let beside = |name: &str| {
            std::fs::read_to_string(path.with_file_name(name)).map_err(|why| why.to_string())
        };
        let (equations, _) = compile(Source::new(file, text), &beside).unwrap();
        let mathml = mathml(&equations);
        assert!(mathml.contains("<math"));
        well_formed(&mathml);
    }
}
