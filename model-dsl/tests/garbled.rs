//! Any text is an error or a model: never a panic, never a hang, never unbounded memory.

use flexure_model_dsl::compile;
use flexure_model_dsl::resolve::resolve;
use flexure_model_dsl::source::Source;
use proptest::prelude::*;

/// Compiles `text` with a slide added, so that something can move.
fn survives(text: String) -> Result<usize, usize> {
    let text = text + "\nslide reserve along (1, 0) { mass = 1 g }\n";
    let result = compile(Source::new("garbled.flex", text), &|_| {
        Err("no file".to_owned())
    });
    match result {
        Ok((equations, _)) => Ok(equations.states.len()),
        Err(diagnostics) => {
            assert!(!diagnostics.is_empty());
            for diagnostic in &diagnostics {
                assert!(diagnostic.to_string().len() < 1 << 23);
            }
            Err(diagnostics.len())
        }
    }
}

/// Reads `text` without deriving anything.
fn reads(text: String) {
    let result = resolve(Source::new("long.flex", text), &|_| {
        Err("no file".to_owned())
    });
    if let Err(diagnostics) = result {
        assert!(!diagnostics.is_empty() && diagnostics.len() < 100);
    }
}

fn models() -> Vec<String> {
    [
        "double_rocker",
        "four_bar",
        "lugre_mass",
        "msdm",
        "pendulum",
    ]
    .iter()
    .map(|name| format!("{}/../models/{name}.flex", env!("CARGO_MANIFEST_DIR")))
    .chain([format!(
        "{}/../tests/mechanisms/chain.flex",
        env!("CARGO_MANIFEST_DIR")
    )])
    .map(|path| std::fs::read_to_string(path).expect("the model file is there"))
    .collect()
}

/// What a hand may put into a file.
const SNIPPETS: &[&str] = &[
    "(",
    ")",
    "{",
    "}",
    "\"",
    "//",
    "\n",
    ",",
    "=",
    "==",
    "^",
    "-",
    "1e308",
    "1e-320",
    "1e999",
    "0",
    "/0",
    "°",
    "φ1",
    "µm",
    "N*m",
    " exact",
    " and ",
    "if ",
    " then ",
    " else ",
    "stage.v",
    "polar(",
    "lugre(",
    "\u{0}",
    "\u{FEFF}",
    "\r",
    "🦀",
    "t",
    "^(1/3)",
    "^999999",
    "energy.total",
    "link ",
    "slide ",
    "on stage",
    "param x = ",
    "C",
    "ground",
    "[",
    "]",
    "[i]",
    "[i+1]",
    "[99999999999999999999]",
    "repeat i from 1 to 3 {",
    "repeat k from 0 to N {\n",
    "component weight {",
    "part p = weight(lever = arm, load = bob) at Top = B1",
    "const N = ",
    "use \"a.flex\"",
    "bob1.Tip",
    "bar",
];

fn garbled() -> impl Strategy<Value = String> {
    let edit = (any::<prop::sample::Index>(), 0usize..12, 0..SNIPPETS.len());
    (0usize..6, prop::collection::vec(edit, 1..6)).prop_map(|(which, edits)| {
        let mut text: Vec<char> = models()[which].chars().collect();
        for (at, removed, snippet) in edits {
            let start = at.index(text.len());
            let end = (start + removed).min(text.len());
            text.splice(start..end, SNIPPETS[snippet].chars());
        }
        text.into_iter().collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn garbled_models(text in garbled()) {
        let _ = survives(text);
    }

    #[test]
    fn shuffled_lines(which in 0usize..6, seed in prop::collection::vec(any::<prop::sample::Index>(), 40)) {
        let text = models()[which].clone();
        let mut lines: Vec<&str> = text.lines().collect();
        for index in seed {
            let line = lines.remove(index.index(lines.len()));
            lines.push(line);
        }
        let _ = survives(lines.join("\n"));
    }

    #[test]
    fn random_characters(text in any::<String>()) {
        let _ = survives(text);
    }

    #[test]
    fn random_bytes(bytes in prop::collection::vec(any::<u8>(), 0..600)) {
        let _ = survives(String::from_utf8_lossy(&bytes).into_owned());
    }

    #[test]
    fn random_words(words in prop::collection::vec(0..SNIPPETS.len(), 0..60)) {
        let text: String = words.iter().map(|&index| SNIPPETS[index]).collect();
        let _ = survives(format!("model m\nparam a = {text}"));
    }
}

#[test]
fn nesting() {
    for (open, close) in [
        ("(", ")"),
        ("sin(", ")"),
        ("-(", ")"),
        ("(0, ", ")"),
        ("if ", ""),
        ("{", "}"),
    ] {
        for depth in [10, 60, 64, 65, 1000, 100_000] {
            let text = format!(
                "model m\nlet a = {}1{}\n",
                open.repeat(depth),
                close.repeat(depth)
            );
            let result = survives(text);
            assert!(depth <= 64 || result.is_err(), "{open} {depth}");
        }
    }
    assert!(
        survives(format!(
            "model m\nparam a = {}1\noutput b = a",
            "(".repeat(60)
        ))
        .is_err()
    );
    assert!(
        survives(format!(
            "model m\nparam a = {}1{}\noutput b = a",
            "(".repeat(60),
            ")".repeat(60)
        ))
        .is_ok()
    );
    let _ = survives(format!("model m\nparam a = {}1\n", "-".repeat(100_000)));
    let _ = survives(format!("model m\nparam a = 1{}\n", "^1".repeat(100_000)));
    let _ = survives(format!(
        "model m\nlet a = {}1 else 0\n",
        "if 1 > 0 then 1 else ".repeat(10_000)
    ));
}

#[test]
fn long_rows() {
    for operator in ["+", "-", "*", "/", "^", " and ", " or ", ">", ","] {
        let _ = survives(format!(
            "model m\nparam a = 1{}\n",
            format!("{operator}1.5").repeat(50_000)
        ));
    }
    let terms: Vec<String> = (1..900)
        .map(|index| format!("1/{}", 2 * index + 1))
        .collect();
    let _ = survives(format!(
        "model m\nlet a = {}\noutput b = a\n",
        terms.join(" + ")
    ));
    let factors: Vec<String> = (1..900)
        .map(|index| format!("1e-{}", index % 300))
        .collect();
    let _ = survives(format!(
        "model m\nlet a = {}\noutput b = a\n",
        factors.join(" * ")
    ));
    let _ = survives(format!(
        "model m\nlet a = {}\n",
        "f(".repeat(60) + &"9".repeat(100_000)
    ));
    let _ = survives(format!("model m\nparam a = 1.{}\n", "9".repeat(2_000_000)));
}

#[test]
fn towers() {
    let mut text = "model m\nlet x0 = 1.1\n".to_owned();
    for index in 0..2000 {
        text += &format!("let x{} = x{index}*x{index} + x{index}^2\n", index + 1);
    }
    text += "output y = x2000\n";
    assert!(survives(text).is_ok());
    let _ = survives("model m\nlet a = 10^(10^(10^10))\noutput b = a".to_owned());
    let _ = survives("model m\nlet a = 2^1000000000\noutput b = a".to_owned());
    let _ = survives("model m\nparam x = 2\nlet a = x^1000000000\noutput b = a".to_owned());
    let _ = survives("model m\nlet a = 1.0000001^0.0000001\noutput b = a".to_owned());
}

#[test]
fn many_items() {
    let many = |line: &dyn Fn(usize) -> String| {
        let mut text = "model m\nground O = (0 mm, 0 mm)\n".to_owned();
        (0..20_000).for_each(|index| text += &line(index));
        text
    };
    reads(many(&|index| format!("param p{index} = {index} mm\n")));
    reads(many(&|index| format!("let p{index} = p{}\n", index + 1)));
    reads(many(&|index| format!("let p{index} = 1 / (q{index})\n")));
    reads(many(&|index| {
        format!(
            "link l{index} from P{index} to P{} {{ length = 1 mm, angle = 0 deg }}\n",
            index + 1
        )
    }));
    reads(many(&|index| {
        format!("slide s{index} along (1, 0) {{ mass = 1 g }}\n")
    }));
    reads(many(&|_| "hinge at O { stiffness = 1 N }\n".to_owned()));
    reads("\n".repeat(4_000_000));
    reads(format!(
        "model m\nslide s along (1, 0) {{\n{}}}\n",
        "//\n".repeat(1_000_000)
    ));
    reads(format!(
        "model m\nparam a = (\n{}\n",
        "\n".repeat(1_000_000)
    ));
    reads("model m\n".to_owned() + &"}".repeat(1_000_000));
    reads("\"\n".repeat(1_000_000));
    reads("x".repeat(5_000_000));
}
