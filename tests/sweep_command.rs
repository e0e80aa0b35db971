//! `flexure sweep` as a person calls it: grids and files of points, measures, rows of what fails,
//! spreads and limits, and that neither threads nor a kill at any moment change a byte.
#![cfg(feature = "cli")]

#[allow(dead_code)]
#[path = "support/random.rs"]
mod random;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use flexure_runtime::lanes::Path as Instructions;
use random::Random;

const STAGE: &str = "\
//! A damped mass on a spring whose other end a sawtooth moves.
model stage
param f = 1 kHz
param k = 1e6 N/m
param c = 200 N*s/m
param m = 20 g

drive xp = sawtooth(20 um, frequency = f, rise = 0.9)
slide stage along (1, 0) { mass = m }
spring push between ground and stage { stiffness = k, damping = c, expansion = xp }
output speed = stage.v
output doubled = 2 * stage.v
";

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("sweep_{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    fs::write(folder.join("stage.flex"), STAGE).unwrap();
    folder
}

fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_flexure"));
    command
        .current_dir(folder)
        .arg("sweep")
        .args(arguments)
        .stdin(Stdio::null());
    command
}

#[track_caller]
fn sweep(folder: &Path, status: i32, arguments: &[&str]) -> [String; 2] {
    let output = command(folder, arguments).output().unwrap();
    let [out, err] = [output.stdout, output.stderr].map(|b| String::from_utf8(b).unwrap());
    assert_eq!(output.status.code(), Some(status), "{out}\n{err}");
    assert!(!err.contains("panicked"), "{err}");
    [out, err]
}

fn rows(table: &str) -> Vec<Vec<&str>> {
    table
        .lines()
        .map(|line| line.split(',').collect())
        .collect()
}

fn number(field: &str) -> f64 {
    field.parse().unwrap()
}

#[test]
fn a_picture_has_a_curve_for_each_value_of_the_second_axis() {
    let here = folder("picture");
    let grid = ["--vary", "f=2kHz,1kHz", "--vary", "m=10g,20g,0g"];
    let measures = ["--measure", "mean(stage.v)", "--measure", "step(stage.x)"];
    let mut arguments = vec!["stage.flex", "--warmup", "2", "--cycles", "3"];
    arguments.extend(grid.iter().chain(&measures));
    let plain = sweep(&here, 0, &arguments);
    for picture in ["s.svg", "s.html"] {
        let [table, _] = sweep(&here, 0, &[&arguments[..], &["--plot", picture]].concat());
        assert_eq!(table, plain[0]);
        let text = fs::read_to_string(here.join(picture)).unwrap();
        for words in [
            "m = 10 g",
            "m = 20 g",
            "f (kHz)",
            "mean(stage.v)",
            "step(stage.x)",
        ] {
            assert!(text.contains(words), "{words}: {text}");
        }
    }
    // Values behind the picture are those of the table, in the order of the first axis.
    let page = fs::read_to_string(here.join("s.html")).unwrap();
    let values = page.split_once("<pre class=\"values\">").unwrap().1;
    let values: Vec<&str> = values.lines().take(3).collect();
    assert!(values[0].starts_with("f [Hz],"), "{values:?}");
    let table = rows(&plain[0]);
    for (line, speeds) in [(1, &table[4..6]), (2, &table[1..3])] {
        let shown: Vec<f64> = values[line].split(',').take(3).map(number).collect();
        let expected = [
            number(speeds[0][0]),
            number(speeds[0][2]),
            number(speeds[1][2]),
        ];
        assert_eq!(shown, expected);
    }
    for (more, words) in [
        (["--vary", "k=1e6 N/m,2e6 N/m"], "one or two varied params"),
        (["-o", "p.svg"], "both the table and the picture"),
    ] {
        let call = [&arguments[..], &more, &["--plot", "p.svg"]].concat();
        let [_, said] = sweep(&here, 2, &call);
        assert!(said.contains(words), "{said}");
    }
}

#[test]
fn a_grid_has_a_row_for_each_point_in_order() {
    let here = folder("grid");
    let vary = ["--vary", "f=1kHz..2kHz:500Hz", "--vary", "m=10g,20g"];
    let measures = ["--measure", "mean(stage.v)", "--measure", "step(stage.x)"];
    let mut arguments = vec!["stage.flex", "--warmup", "2", "--cycles", "3"];
    arguments.extend(vary.iter().chain(&measures));
    let [table, _] = sweep(&here, 0, &arguments);
    let rows = rows(&table);
    let header = [
        "f",
        "m",
        "mean(stage.v)",
        "step(stage.x)",
        "status",
        "message",
    ];
    assert_eq!(rows[0], header);
    let points: Vec<[f64; 2]> = rows[1..]
        .iter()
        .map(|r| [number(r[0]), number(r[1])])
        .collect();
    let expected = [1000.0, 1500.0, 2000.0].map(|f| [[f, 0.01], [f, 0.02]]);
    assert_eq!(points, expected.concat());
    for row in &rows[1..] {
        assert_eq!(&row[4..], ["ok", ""]);
        // Both are of the same advance.
        let (speed, step) = (number(row[2]), number(row[3]));
        assert!((speed - step * number(row[0])).abs() <= 1e-12 * speed.abs().max(1e-9));
    }
}

#[test]
fn the_actuator_has_its_known_mean_speed() {
    let here = folder("actuator");
    let model = concat!(env!("CARGO_MANIFEST_DIR"), "/models/double_rocker.flex");
    let [table, _] = sweep(&here, 0, &[model, "--measure", "mean(stage.v)"]);
    // 20 N, 1 kHz, cycles 10 to 30, by an independent program: five digits.
    let speed = number(rows(&table)[1][0]);
    assert!((speed - 8.74628e-3).abs() < 0.5e-8, "{speed}");
}

#[test]
fn measures_are_those_of_the_motion_that_simulate_gives() {
    let here = folder("measures");
    let names = [
        "mean(doubled)",
        "rms(stage.v)",
        "max(stage.x)",
        "min(stage.v)",
        "peak_to_peak(stage.v)",
    ];
    let mut arguments = vec![
        "stage.flex",
        "--warmup",
        "1",
        "--cycles",
        "2",
        "--samples",
        "1000",
    ];
    for name in names {
        arguments.extend(["--measure", name]);
    }
    let [table, _] = sweep(&here, 0, &arguments);
    let table = rows(&table);
    let model = flexure::Model::from_path(here.join("stage.flex")).unwrap();
    let system = model.design().prepare().unwrap();
    let run = flexure::simulate(&system)
        .until(3e-3)
        .rtol(1e-10)
        .every(1e-6);
    let run = run.run().unwrap();
    let of = |name: &str| run.column(name).between(1e-3 - 1e-9, 3e-3 + 1e-9);
    let expected = [
        of("doubled").mean(),
        of("stage.v").rms(),
        of("stage.x").max(),
        of("stage.v").min(),
        of("stage.v").max() - of("stage.v").min(),
    ];
    for ((name, value), expected) in names.iter().zip(&table[1]).zip(expected) {
        let value = number(value);
        // The mean of a velocity over whole cycles is all but zero beside the velocity itself.
        let size = expected
            .abs()
            .max(if name.contains("doubled") { 0.1 } else { 0.0 });
        assert!(
            (value - expected).abs() < 1e-5 * size,
            "{name}: {value} {expected}"
        );
    }
}

#[test]
fn points_come_from_a_file_and_what_fails_is_a_row() {
    let here = folder("file");
    fs::write(
        here.join("points.csv"),
        "f [kHz],m [g]\n1,20\n# none\n2,-1\n1.5,10\n",
    )
    .unwrap();
    let arguments = [
        "stage.flex",
        "--points",
        "points.csv",
        "--measure",
        "last(stage.x)",
        "--cycles",
        "1",
    ];
    let [table, err] = sweep(&here, 0, &arguments);
    assert!(
        err.contains("1 of 3 designs could not be assembled"),
        "{err}"
    );
    let rows = rows(&table);
    assert_eq!((number(rows[1][0]), number(rows[1][1])), (1000.0, 0.02));
    assert_eq!((rows[1][3], rows[3][3]), ("ok", "ok"));
    assert_eq!((rows[2][2], rows[2][3]), ("", "refused"));
    assert!(rows[2][4].contains("mass"), "{table}");

    fs::write(here.join("points.csv"), "f [kHz],m [g]\n1,x\n").unwrap();
    let [_, err] = sweep(&here, 2, &arguments);
    assert!(err.contains("points.csv:2:3"), "{err}");
}

#[test]
fn spreads_are_drawn_by_their_seed_and_summed_up() {
    let here = folder("spread");
    let draw = |seed: &str, out: &str| {
        let limit = "peak(stage.v) > 1mm/s";
        let spread = [
            "--spread",
            "k=normal(5%)",
            "--spread",
            "m=uniform(±1g)",
            "--draws",
            "30",
        ];
        let mut arguments = vec![
            "stage.flex",
            "--vary",
            "f=1kHz,2kHz",
            "--warmup",
            "1",
            "--cycles",
            "1",
        ];
        arguments.extend(spread);
        arguments.extend([
            "--seed",
            seed,
            "--limit",
            limit,
            "--limit",
            "last(stage.x) < -1 m",
            "-o",
            out,
        ]);
        let [said, _] = sweep(&here, 0, &arguments);
        (said, fs::read_to_string(here.join(out)).unwrap())
    };
    let (said, table) = draw("1", "a.csv");
    assert_eq!(draw("1", "b.csv"), (said.clone(), table.clone()));
    assert_ne!(draw("2", "c.csv").1, table);
    for words in [
        "f = 1 kHz",
        "f = 2 kHz",
        "30 of 30 pass: 100 %",
        "0 of 30 pass: 0 %",
        "all limits",
    ] {
        assert!(said.contains(words), "{said}");
    }
    let rows = rows(&table);
    assert_eq!(rows.len(), 61);
    assert_eq!(rows[0][..3], ["f", "k", "m"]);
    assert!(
        rows[1..]
            .iter()
            .all(|row| (number(row[2]) - 0.02).abs() <= 0.001)
    );
    // Each point of the grid gets the same draws.
    assert_eq!(rows[1][1..3], rows[31][1..3]);
}

#[test]
fn wrong_calls_are_refused_before_anything_runs() {
    let here = folder("wrong");
    fs::write(
        here.join("still.flex"),
        "model still\nslide s along (1, 0) { mass = 1 kg }\ninitial s.v = 1 m/s\n",
    )
    .unwrap();
    let mean = ["--measure", "mean(stage.v)"];
    let cases: [(&[&str], &str); 13] = [
        (&["stage.flex"], "nothing is measured"),
        (
            &["stage.flex", "--measure", "mean(stage.w)"],
            "no state or output `stage.w`",
        ),
        (
            &["stage.flex", "--measure", "maen(stage.v)"],
            "did you mean `mean(stage.v)`",
        ),
        (
            &["stage.flex", "--vary", "g=1kHz", mean[0], mean[1]],
            "no param `g`",
        ),
        (
            &["stage.flex", "--vary", "f=1N", mean[0], mean[1]],
            "a frequency",
        ),
        (
            &["stage.flex", "--vary", "f=2kHz..1kHz:1Hz", mean[0], mean[1]],
            "is empty",
        ),
        (
            &[
                "stage.flex",
                "--vary",
                "f=1kHz",
                "--vary",
                "f=2kHz",
                mean[0],
                mean[1],
            ],
            "varied twice",
        ),
        (
            &[
                "stage.flex",
                "--vary",
                "f=1kHz..2kHz:lin1000",
                "--vary",
                "m=1g..2g:lin1000",
                mean[0],
                mean[1],
            ],
            "1000000 designs; add --yes",
        ),
        (
            &["stage.flex", "--until", "1ms", "--measure", "step(stage.x)"],
            "a measure of cycles",
        ),
        (
            &[
                "stage.flex",
                "--until",
                "1ms",
                "--warmup",
                "2ms",
                mean[0],
                mean[1],
            ],
            "nothing is measured",
        ),
        (
            &["stage.flex", mean[0], mean[1], "-o", "no/such/out.csv"],
            "no folder",
        ),
        (
            &["stage.flex", mean[0], mean[1], "-o", "stage.flex"],
            "overwrite the model",
        ),
        (
            &["still.flex", "--measure", "mean(s.v)"],
            "no drive that repeats",
        ),
    ];
    for (arguments, words) in cases {
        let output = command(&here, arguments).output().unwrap();
        let err = String::from_utf8(output.stderr).unwrap();
        assert!(matches!(output.status.code(), Some(1 | 2)), "{err}");
        assert!(
            output.stdout.is_empty() && err.contains(words),
            "{arguments:?}: {err}"
        );
    }
    sweep(
        &here,
        0,
        &["still.flex", "--measure", "mean(s.v)", "--until", "1ms"],
    );
    assert!(!here.join("no").exists());
}

/// A sweep of many short runs, some of them of designs that are refused.
fn long(out: &str) -> Vec<&str> {
    let vary = ["--vary", "f=1kHz..3kHz:lin20", "--vary", "m=-1g..20g:lin8"];
    let measures = ["--measure", "mean(stage.v)", "--measure", "rms(stage.v)"];
    let window = ["--warmup", "1", "--cycles", "1", "--samples", "50"];
    let mut arguments = vec!["stage.flex"];
    arguments.extend(vary.iter().chain(&measures).chain(&window));
    arguments.extend(["-o", out]);
    arguments
}

/// Starts it, and waits until its journal has grown by so many bytes, or it is done.
fn until_grown(mut command: Command, journal: &Path, by: u64) -> Child {
    let length = || fs::metadata(journal).map_or(0, |data| data.len());
    let wanted = length() + by;
    let mut child = command.stderr(Stdio::null()).spawn().unwrap();
    while length() < wanted && child.try_wait().unwrap().is_none() {
        std::thread::sleep(Duration::from_millis(1));
    }
    child
}

#[test]
fn threads_change_no_byte() {
    let here = folder("threads");
    let tables = ["1", "2"].map(|threads| {
        let out = format!("{threads}.csv");
        let mut arguments = long(&out);
        arguments.extend(["--threads", threads]);
        sweep(&here, 0, &arguments);
        fs::read(here.join(&out)).unwrap()
    });
    assert!(tables[0] == tables[1]);
    let text = String::from_utf8(tables[0].clone()).unwrap();
    assert_eq!(text.lines().count(), 161);
    assert!(text.contains(",refused,") && text.contains(",ok,"));
}

#[test]
fn killed_twenty_times_it_ends_in_the_same_file() {
    let here = folder("killed");
    sweep(&here, 0, &long("whole.csv"));
    let journal = here.join("out.csv.journal");
    let mut random = Random::new(3);
    let mut kills = 0;
    for _ in 0..20 {
        let by = (random.between(0.0, 1.0) * 900.0) as u64;
        let mut child = until_grown(command(&here, &long("out.csv")), &journal, by);
        std::thread::sleep(Duration::from_micros(
            (random.between(0.0, 1.0) * 2e4) as u64,
        ));
        let _ = child.kill();
        let status = child.wait().unwrap();
        kills += u32::from(status.code().is_none());
        if status.success() {
            assert!(!journal.exists());
            let same = fs::read(here.join("out.csv")).unwrap()
                == fs::read(here.join("whole.csv")).unwrap();
            assert!(same);
        }
    }
    assert!(kills > 0);
    sweep(&here, 0, &long("out.csv"));
    let tables = ["out.csv", "whole.csv"].map(|name| fs::read(here.join(name)).unwrap());
    assert!(tables[0] == tables[1]);
    let left: Vec<_> = fs::read_dir(&here)
        .unwrap()
        .map(|e| e.unwrap().file_name())
        .collect();
    assert!(!journal.exists(), "{left:?}");
}

#[test]
fn the_journal_of_another_sweep_is_refused() {
    let here = folder("other");
    let journal = here.join("out.csv.journal");
    let mut child = until_grown(command(&here, &long("out.csv")), &journal, 400);
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(journal.exists());
    let before = fs::read(&journal).unwrap();
    let refused = |mut command: Command, what: &str| {
        let output = command.output().unwrap();
        let err = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(1), "{err}");
        assert!(err.contains(what) && err.contains("--restart"), "{err}");
        assert!(fs::read(&journal).unwrap() == before && !here.join("out.csv").exists());
    };
    let with = |more: &[&'static str]| {
        let mut arguments = long("out.csv");
        arguments.extend(more);
        command(&here, &arguments)
    };
    refused(with(&["--rtol", "1e-6"]), "its settings");
    refused(with(&["--set", "c=100"]), "its params");
    refused(with(&["--vary", "c=100"]), "its design points");
    refused(with(&["--measure", "max(stage.x)"]), "its measures");
    if Instructions::available() != Instructions::Portable {
        let mut portable = with(&[]);
        portable.env("FLEXURE_PATH", "portable");
        refused(portable, "its instruction path is `");
    }
    fs::write(here.join("stage.flex"), STAGE.replace("20 um", "21 um")).unwrap();
    refused(with(&[]), "its model");
    let mut again = long("out.csv");
    again.push("--restart");
    sweep(&here, 0, &again);
    assert!(!journal.exists() && here.join("out.csv").exists());
}
