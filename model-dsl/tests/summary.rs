//! What a person is told of a model: its summary, and the units of its outputs.

use flexure_model_dsl::compile;
use flexure_model_dsl::equations::Equations;
use flexure_model_dsl::source::Source;

fn text(name: &str) -> String {
    let path = format!("{}/../models/{name}.flex", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).expect("the model file is there")
}

fn equations_of(text: &str) -> Equations {
    let source = Source::new("model.flex", text);
    match compile(source, &|_| Err("no files here".to_owned())) {
        Ok((equations, _)) => equations,
        Err(errors) => panic!("{}\n{text}", errors[0]),
    }
}

fn equations(name: &str) -> Equations {
    equations_of(&text(name))
}

fn facts_of(text: &str, subject: &str) -> Vec<String> {
    let facts = equations_of(text).summary;
    let of_subject = facts.into_iter().filter(|fact| fact.subject == subject);
    of_subject.map(|fact| fact.words).collect()
}

fn facts(name: &str, subject: &str) -> Vec<String> {
    facts_of(&text(name), subject)
}

/// The same without what it asks for as coordinates.
fn unasked(text: &str) -> String {
    let lines = text.lines().filter(|line| !line.starts_with("coordinate "));
    lines.collect::<Vec<&str>>().join("\n")
}

#[test]
fn units_tell_angles_and_energies_from_numbers_and_torques() {
    let units = |name: &str| -> Vec<(String, String)> {
        let outputs = equations(name).outputs;
        outputs.into_iter().map(|o| (o.name, o.unit)).collect()
    };
    let pair = |name: &str, unit: &str| (name.to_owned(), unit.to_owned());
    assert_eq!(
        units("four_bar"),
        [
            pair("rate", "rad/s"),
            pair("torque", "N*m"),
            pair("energy_total", "J"),
        ]
    );
    assert_eq!(units("pendulum")[0], pair("swing", "rad"));
}

#[test]
fn parallelograms_are_loops() {
    assert_eq!(facts("n_windows_1", "loops").len(), 1);
    assert!(facts("n_windows_1", "loops")[0].starts_with("1: "));
}

#[test]
fn slides_of_loops_have_a_place() {
    let places = facts("slider_crank", "closed position");
    assert_eq!(places.len(), 1);
    assert!(
        places[0].starts_with("piston.x closes at {0}"),
        "{places:?}"
    );
}

#[test]
fn coordinates_that_are_guesses_say_so() {
    let coordinates = facts("bridge_amplifier", "coordinate");
    assert!(
        coordinates[0].contains("not exact, so held as guessed"),
        "{coordinates:?}"
    );
    let coordinates = facts("double_rocker", "coordinate");
    assert!(coordinates[0].ends_with("exact at {0}"), "{coordinates:?}");
}

/// A stage on two leaves, of which the stage comes first in the file.
fn leaves(left: &str, right: &str, width: &str) -> String {
    format!(
        "model leaves
param l = 20 mm, w = 30 mm, m = 10 g
ground A = (0 mm, 0 mm), B = (w, 0 mm)
link block from C to D {{ length = {width}, angle = 0 deg, mass = m }}
link left from A to C {{ length = l, angle = {left}, mass = m }}
link right {right}, mass = m }}
"
    )
}

const HELD: &str =
    "the first in the file that is not held parallel and with which every loop closes";
const FIRST: &str = "the first in the file with which every loop closes";

#[test]
fn a_stage_that_leaves_hold_parallel_is_no_coordinate() {
    let rights = [
        "from B to D { length = l, angle = 90 deg",
        "from D to B { length = l, angle = 270 deg",
        "from D to B { length = l, angle = -90 deg",
    ];
    for right in rights {
        let coordinates = facts_of(&leaves("90 deg", right, "w"), "coordinate");
        assert_eq!(coordinates.len(), 1);
        let start = format!("left.angle ({HELD}");
        assert!(
            coordinates[0].starts_with(&start),
            "{right}: {coordinates:?}"
        );
    }
}

#[test]
fn stages_on_stages_are_no_coordinates() {
    for (name, expected) in [
        ("double_parallelogram_stage", ["left", "inner_left"]),
        ("xy_stage", ["left", "lower"]),
    ] {
        let coordinates = facts_of(&unasked(&text(name)), "coordinate");
        let asked = facts(name, "coordinate");
        for (found, body) in [coordinates, asked]
            .iter()
            .flat_map(|f| f.iter().zip(expected))
        {
            assert!(
                found.starts_with(&format!("{body}.angle (")),
                "{name}: {found}"
            );
        }
    }
}

#[test]
fn a_stage_that_turns_may_be_a_coordinate() {
    let crossed = leaves("60 deg", "from B to D { length = l, angle = 120 deg", "w");
    let unequal = leaves(
        "90 deg",
        "from B to D { length = l, angle = 90 deg",
        "0.9 * w",
    );
    let longer = leaves(
        "90 deg",
        "from B to D { length = 1.1 * l, angle = 90 deg",
        "w",
    );
    for text in [crossed, unequal, longer] {
        let coordinates = facts_of(&text, "coordinate");
        assert!(
            coordinates[0].starts_with(&format!("block.angle ({FIRST}")),
            "{coordinates:?}\n{text}"
        );
    }
}
