//! Models far larger than a person draws compile in bounded time, or are refused in words.

use std::fmt::Write;

use flexure_model_dsl::compile;
use flexure_model_dsl::source::Source;

/// Compiles to the number of states or the first message. What is not bounded takes minutes here.
fn outcome(text: &str) -> Result<usize, String> {
    let source = Source::new("large.flex", format!("model large\n{text}"));
    let result = compile(source, &|_| Err("no such file".to_owned()));
    match result {
        Ok((equations, _)) => Ok(equations.states.len()),
        Err(diagnostics) => Err(diagnostics[0].message.clone()),
    }
}

fn slides(count: usize) -> String {
    (0..count).fold(String::new(), |mut text, i| {
        let _ = writeln!(text, "slide s{i} along (1, 0) {{ mass = 1 kg }}");
        text
    })
}

/// Slides in a row, each on a spring from the one before.
fn springs(count: usize) -> String {
    let mut text = slides(count);
    for i in 0..count {
        let before = match i.checked_sub(1) {
            Some(before) => format!("s{before}"),
            None => "ground".to_owned(),
        };
        let _ = writeln!(
            text,
            "spring k{i} between {before} and s{i} {{ stiffness = 10 N/m, damping = 1 N*s/m }}"
        );
    }
    text
}

/// Links that hang on each other.
fn chain(count: usize) -> String {
    let mut text = "ground P0 = (0 mm, 0 mm)\n".to_owned();
    for i in 0..count {
        let _ = writeln!(
            text,
            "link l{i} from P{i} to P{} {{ length = 10 mm, angle = 10 deg, mass = 1 g }}",
            i + 1
        );
    }
    text
}

/// Four-bars in a row that share their ground pivots.
fn four_bars(count: usize) -> String {
    let mut text = "ground G0 = (0 mm, 0 mm)\n".to_owned();
    for i in 0..count {
        let next = i + 1;
        let _ = writeln!(text, "ground G{next} = ({} mm, 0 mm)", 25 * next);
        let links = [
            format!("a{i} from G{i} to A{i} {{ length = 10 mm, angle = 80 deg"),
            format!("b{i} from A{i} to B{i} {{ length = 23 mm, angle = 0 deg"),
            format!("c{i} from B{i} to G{next} {{ length = 10 mm, angle = 270 deg"),
        ];
        for link in links {
            let _ = writeln!(text, "link {link}, mass = 1 g }}");
        }
    }
    text
}

#[test]
fn many_bodies_on_their_own_compile() {
    assert_eq!(outcome(&slides(300)), Ok(600));
    assert_eq!(outcome(&springs(200)), Ok(400));
    assert_eq!(outcome(&four_bars(30)), Ok(60));
    assert_eq!(outcome(&chain(8)), Ok(16));
}

#[test]
fn what_is_too_large_is_refused_in_words() {
    let refused = |text: &str| outcome(text).expect_err("too large");
    assert_eq!(
        refused(&slides(5000)),
        "the model has 5000 bodies, more than 1000 are not compiled"
    );
    assert_eq!(
        refused(&chain(300)),
        "`l100` hangs on ground by more than 100 bodies, longer chains are not compiled"
    );
    assert_eq!(
        refused(&chain(40)),
        "40 coordinates are coupled by inertia, more than 24 are not compiled"
    );
}

#[test]
fn a_sum_of_many_params_compiles() {
    let names: Vec<String> = (0..300).map(|i| format!("p{i}")).collect();
    let mut text: String = names
        .iter()
        .map(|name| format!("param {name} = 1 g\n"))
        .collect();
    let _ = writeln!(
        text,
        "slide s along (1, 0) {{ mass = {} }}",
        names.join(" + ")
    );
    assert_eq!(outcome(&text), Ok(2));
}
