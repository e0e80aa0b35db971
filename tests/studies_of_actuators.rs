//! `flexure response` and `flexure sensitivity` as a person calls them: tables, pictures, messages,
//! exit statuses.
#![cfg(feature = "cli")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A block that is pushed by F (1 + sin ωt) + L (ω / 2π) against viscous friction: once settled its
/// mean speed is (F + L f) / c, a line over the frequency.
const PUSHED: &str = "\
//! A block that is pushed.
model pushed
param f = 10 Hz, F = 2 N, L = 0.1 N*s, c = 4 N*s/m, m = 10 g, zero = 0, longest = 1 km
slide block along (1, 0) { mass = m }
force on block = (F * (1 + sin(2*pi*f*t)) + L * f - c * block.v, 0 N)
stop when block.x > longest * (1 + zero)
output speed = block.v
set quick { F = 4 N }
";

struct Answer {
    status: i32,
    out: String,
    err: String,
}

/// A folder of its own for a test, with the model in it.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("pushed.flex"), PUSHED).unwrap();
    folder
}

fn flexure(folder: &Path, subcommand: &str, more: &[&str]) -> Answer {
    let output = Command::new(env!("CARGO_BIN_EXE_flexure"))
        .current_dir(folder)
        .args([subcommand, "pushed.flex"])
        .args(more)
        .stdin(Stdio::null())
        .output()
        .unwrap();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    let answer = Answer {
        status: output.status.code().expect("ended by itself"),
        out: text(&output.stdout),
        err: text(&output.stderr),
    };
    assert!(!answer.err.contains("panicked"), "{}", answer.err);
    answer
}

#[track_caller]
fn done(folder: &Path, subcommand: &str, more: &[&str]) -> Answer {
    let answer = flexure(folder, subcommand, more);
    assert_eq!(answer.status, 0, "{}\n{}", answer.out, answer.err);
    answer
}

const RESPONSE: [&str; 4] = ["--frequency", "f=10Hz..80Hz:10Hz", "--speed", "speed"];

fn with(more: &[&'static str]) -> Vec<&'static str> {
    [&RESPONSE[..], more].concat()
}

/// Rows of a table as fields by the names of its columns.
fn rows(folder: &Path, file: &str) -> (Vec<String>, Vec<Vec<String>>) {
    let text = fs::read_to_string(folder.join(file)).unwrap();
    let mut lines = text
        .lines()
        .map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    (lines.next().unwrap(), lines.collect())
}

#[test]
fn a_family_of_curves_with_its_linear_regimes() {
    let here = folder("family");
    let family = with(&["--for", "F=2N,4N", "-o", "r.csv", "--plot", "r.svg"]);
    let answer = done(&here, "response", &family);
    assert!(answer.out.contains("whose rate it is") && answer.out.contains("`block.x`"));
    assert!(
        answer.out.contains("over cycles 10 to 30"),
        "{}",
        answer.out
    );
    // Slope L / c = 25 mm a cycle, intercept F / c.
    for words in [
        "F = 2 N: from the lowest with R² > 0.98",
        "10 Hz to 80 Hz",
        "25 mm",
    ] {
        assert!(answer.out.contains(words), "{words}: {}", answer.out);
    }
    let (names, rows) = rows(&here, "r.csv");
    assert_eq!(names[..3], ["F", "f", "mean(speed)"]);
    assert_eq!(rows.len(), 16);
    for row in &rows {
        let number = |column: usize| row[column].parse::<f64>().unwrap();
        let expected = (number(0) + 0.1 * number(1)) / 4.0;
        // The start fades within 2.5 ms, a fiftieth of ten cycles at 80 Hz.
        assert!((number(2) - expected).abs() < 1e-6, "{row:?}");
        assert_eq!(row[3..6], ["10", "30", "measured"]);
        assert_eq!(row[8..], ["ok", ""]);
    }
    let picture = fs::read_to_string(here.join("r.svg")).unwrap();
    assert!(picture.starts_with("<?xml") && picture.contains("F = 4 N"));
    let regimes = |picture: &str, class: &str| picture.matches(class).count();
    assert_eq!(regimes(&picture, "class=\"window\""), 2, "{picture}");
    done(&here, "response", &with(&["--plot", "r.html"]));
    let page = fs::read_to_string(here.join("r.html")).unwrap();
    assert!(page.starts_with("<!DOCTYPE html>") && page.contains("Parameters"));
    assert!(page.contains("over cycles 10 to 30") && page.contains("mean speed [m/s]"));
    // A single curve has its regime shaded; pages hold a wide and a narrow picture.
    assert_eq!(regimes(&page, "class=\"band\""), 2);
}

#[test]
fn files_do_not_depend_on_threads() {
    let here = folder("threads");
    let mut tables = Vec::new();
    for threads in ["1", "2", "3"] {
        let call = with(&[
            "--for",
            "F=1N..3N:1N",
            "--settle",
            "-o",
            "r.csv",
            "--threads",
        ]);
        let out = done(&here, "response", &[&call[..], &[threads]].concat()).out;
        tables.push((out, fs::read(here.join("r.csv")).unwrap()));
    }
    assert_eq!(tables[0], tables[1]);
    assert_eq!(tables[0], tables[2]);
}

#[test]
fn motions_are_followed_until_they_settle() {
    let here = folder("settle");
    let answer = done(&here, "response", &with(&["--settle=1e-5", "-o", "r.csv"]));
    assert!(
        answer.out.contains("repeats to 1e-5 of its range"),
        "{}",
        answer.out
    );
    let (_, rows) = rows(&here, "r.csv");
    assert!(rows.iter().all(|row| row[4] == "periodic"), "{rows:?}");
    let wrong = flexure(&here, "response", &with(&["--settle", "--warmup", "5"]));
    assert_eq!(wrong.status, 2, "{}", wrong.err);
    let wrong = flexure(&here, "response", &with(&["--most-cycles", "100"]));
    assert_eq!(wrong.status, 2, "{}", wrong.err);
}

#[test]
fn points_that_fail_are_rows() {
    let here = folder("failures");
    let answer = done(
        &here,
        "response",
        &with(&["--for", "longest=1km,1m", "-o", "r.csv"]),
    );
    assert!(
        answer.err.contains("failed: longest = 1 m at 10 Hz"),
        "{}",
        answer.err
    );
    let (_, rows) = rows(&here, "r.csv");
    let failed: Vec<_> = rows.iter().filter(|row| row[8] == "failed").collect();
    assert!(!failed.is_empty() && rows.len() == 16);
    for row in failed {
        assert_eq!(
            (row[0].as_str(), row[2].as_str()),
            ("1.0000000000000000e0", "")
        );
        assert!(row[9].contains("the run ended at t = "), "{row:?}");
    }
    let answer = done(&here, "response", &with(&["--for", "m=10g,-1g"]));
    assert!(answer.out.contains("failed") && answer.err.contains("mass"));
}

#[test]
fn an_experiment_is_compared_at_its_own_frequencies() {
    let here = folder("experiment");
    // Half of the speed at 15 and 20 Hz: both are off by the whole measured speed.
    let table = "frequency (Hz), speed (mm/s)\n15, 437.5\n20, 500\n200, 1\n";
    fs::write(here.join("e.csv"), table).unwrap();
    let call = with(&["--experiment", "e.csv", "-o", "r.csv"]);
    let answer = done(&here, "response", &call);
    assert!(
        answer
            .err
            .contains("1 points of the experiment are outside"),
        "{}",
        answer.err
    );
    let last = answer.out.lines().last().unwrap().trim();
    // √((437.5² + 500²) / 2) mm/s
    assert_eq!(
        last.split_whitespace().collect::<Vec<_>>(),
        ["2", "469.79", "mm/s", "100", "%"]
    );
    let (_, rows) = rows(&here, "r.csv");
    assert_eq!(rows.len(), 9);
    let both: Vec<_> = rows.iter().filter(|row| !row[6].is_empty()).collect();
    assert_eq!(both.len(), 2);
    // The point of the experiment is none of the curve.
    assert!(
        answer.out.contains("10 Hz to 80 Hz       8"),
        "{}",
        answer.out
    );

    fs::write(here.join("e.csv"), "frequency (Hz), speed (mm/s)\n15, 4o\n").unwrap();
    let answer = flexure(&here, "response", &call);
    assert_eq!(answer.status, 1);
    assert!(answer.err.contains("e.csv:2:5") && answer.err.contains("`4o` is no number"));
    let answer = flexure(&here, "response", &with(&["--experiment", "none.csv"]));
    assert_eq!(answer.status, 1);
    assert!(
        answer.err.contains("cannot read `none.csv`"),
        "{}",
        answer.err
    );
}

#[test]
fn sensitivities_are_those_of_the_formula() {
    let here = folder("sensitivity");
    // v = (F + L f) / c, at 45 Hz on the mean: F has 2 parts in 6.5, L the others.
    let call = with(&[
        "--param", "F", "--param", "F+L:20%", "--param", "zero:0.5", "-o", "s.csv",
    ]);
    let answer = done(&here, "sensitivity", &call);
    for words in ["its own window", "+10 %", "+20 %", "+0.5"] {
        assert!(answer.out.contains(words), "{words}: {}", answer.out);
    }
    let (names, rows) = rows(&here, "s.csv");
    let column = |name: &str| names.iter().position(|n| n == name).unwrap();
    assert_eq!(rows.len(), 3 * 4);
    for row in &rows {
        for name in ["sensitivity", "sensitivity_in_nominal_window"] {
            let field = &row[column(name)];
            let expected = match row[0].as_str() {
                "F" => 2.0 / 6.5,
                "F+L" => 1.0,
                _ => {
                    assert_eq!(field, "");
                    continue;
                }
            };
            let found: f64 = field.parse().unwrap();
            assert!((found - expected).abs() < 1e-5, "{row:?}");
        }
    }
}

#[test]
fn calls_that_make_no_sense_are_refused() {
    let here = folder("refused");
    let cases: [(&str, &[&str], &str); 12] = [
        ("response", &["--speed", "speed"], "--frequency"),
        (
            "response",
            &["--frequency", "f", "--speed", "sped"],
            "did you mean `speed`",
        ),
        (
            "response",
            &["--frequency", "g", "--speed", "speed"],
            "no param `g`",
        ),
        (
            "response",
            &["--frequency", "m", "--speed", "speed"],
            "no frequency",
        ),
        (
            "response",
            &["--frequency", "f=0Hz,5Hz", "--speed", "speed"],
            "no cycles at 0 Hz",
        ),
        (
            "response",
            &["--frequency", "f=10Hz..5Hz:1Hz", "--speed", "speed"],
            "is empty",
        ),
        (
            "response",
            &["--frequency", "f=1mm", "--speed", "speed"],
            "is a frequency",
        ),
        (
            "response",
            &["--frequency", "f", "--speed", "speed", "--for", "f=1Hz"],
            "is the drive's frequency",
        ),
        (
            "response",
            &["--frequency", "f", "--speed", "speed", "--plot", "r.png"],
            ".svg or .html",
        ),
        (
            "response",
            &["--frequency", "f", "--speed", "speed", "-o", "pushed.flex"],
            "overwrite the model",
        ),
        (
            "sensitivity",
            &["--frequency", "f", "--speed", "speed", "--param", "zero"],
            "`zero` is zero, and 10 % of zero is no change",
        ),
        (
            "sensitivity",
            &["--frequency", "f", "--speed", "speed", "--param", "f"],
            "is the drive's frequency",
        ),
    ];
    for (subcommand, call, words) in cases {
        let answer = flexure(&here, subcommand, call);
        assert_eq!(answer.status, 2, "{call:?}: {}", answer.err);
        assert!(answer.err.contains(words), "{call:?}: {}", answer.err);
    }
    assert_eq!(
        fs::read_to_string(here.join("pushed.flex")).unwrap(),
        PUSHED
    );
    let answer = flexure(&here, "response", &with(&["-o", "none/r.csv"]));
    assert_eq!(answer.status, 1);
    assert!(answer.err.contains("no folder `none`"), "{}", answer.err);
}
