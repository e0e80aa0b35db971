//! What a person is told of a model: its summary, and the units of its outputs.

use flexure_model_dsl::compile;
use flexure_model_dsl::equations::Equations;
use flexure_model_dsl::source::Source;

fn equations(name: &str) -> Equations {
    let path = format!("{}/../models/{name}.flex", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).expect("the model file is there");
    let source = Source::new(format!("{name}.flex"), text);
    match compile(source, &|_| Err("no files here".to_owned())) {
        Ok((equations, _)) => equations,
        Err(_) => panic!("{name} is a good model"),
    }
}

fn facts(name: &str, subject: &str) -> Vec<String> {
    let facts = equations(name).summary;
    let of_subject = facts.into_iter().filter(|fact| fact.subject == subject);
    of_subject.map(|fact| fact.words).collect()
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
