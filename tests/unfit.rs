//! Params that are no mechanism: what a person reads who sets them.

use std::fmt::Write as _;

use flexure::Model;

/// Sets params of a shipped model one at a time, and tells what is said of each.
fn told(model: &str, assignments: &[&str]) -> String {
    let path = format!("{}/models/{model}.flex", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).expect("a shipped model");
    let model = Model::from_source(&format!("{model}.flex"), &text).expect("a good model");
    let mut listing = String::new();
    for assignment in assignments {
        let mut design = model.design();
        let said = match design.set_written(assignment) {
            Ok(design) => match design.prepare() {
                Ok(_) => panic!("`{assignment}` is a good value"),
                Err(diagnostic) => diagnostic,
            },
            Err(diagnostic) => diagnostic,
        };
        writeln!(listing, "{assignment}\n\n{said}\n").expect("text has no end");
    }
    listing
}

#[test]
fn of_an_actuator() {
    insta::assert_snapshot!(told(
        "double_rocker",
        &[
            "l1 = 0 mm",
            "l2 = -1 mm",
            "l2 = 60 mm",
            "l4 = 60 mm",
            "m2 = -1 g",
            "ms = 0 g",
            "f = 0 Hz",
            "rise = 1.5",
            "Fp = 0 N",
            "sigma0 = 0 N/m",
            "sigma1 = -1 N*s/m",
            "sigma2 = -1 N*s/m",
            "mu_s = 0",
            "mu_c = -0.1",
            "v_s = 0 mm/s",
        ],
    ));
}

#[test]
fn of_wrong_names_and_units() {
    insta::assert_snapshot!(told(
        "pendulum",
        &["lenght = 1 mm", "length = 3 N", "length = long", "length"],
    ));
}

/// Models of `tests/unfit`: well written, but with the values that they hold no mechanism.
#[test]
fn of_drawings() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/unfit");
    let mut paths: Vec<_> = std::fs::read_dir(&folder)
        .expect("the folder is there")
        .map(|entry| entry.expect("it can be read").path())
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == "flex")
        })
        .collect();
    paths.sort();
    let mut listing = String::new();
    for path in paths {
        let text = std::fs::read_to_string(&path).expect("it can be read");
        let name = path
            .file_name()
            .expect("a file has a name")
            .to_string_lossy();
        let model = Model::from_source(&name, &text).expect("a well written model");
        let said = match model.design().prepare() {
            Ok(_) => panic!("`{name}` is a good drawing"),
            Err(diagnostic) => diagnostic,
        };
        writeln!(listing, "{}\n{said}\n", text.lines().next().unwrap_or(""))
            .expect("text has no end");
    }
    insta::assert_snapshot!(listing);
}
