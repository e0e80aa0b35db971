//! The `flexure` command as a person calls it: every subcommand, exit statuses, units, messages,
//! the shape of tables and pictures, and what happens to files.
#![cfg(feature = "cli")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A folder of its own for a test, empty.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn model(name: &str) -> String {
    format!("{}/models/{name}.flex", env!("CARGO_MANIFEST_DIR"))
}

struct Answer {
    status: i32,
    out: String,
    err: String,
}

fn flexure(folder: &Path, arguments: &[&str]) -> Answer {
    let output = Command::new(env!("CARGO_BIN_EXE_flexure"))
        .current_dir(folder)
        .args(arguments)
        .stdin(Stdio::null())
        .output()
        .unwrap();
    answer(&output)
}

fn answer(output: &Output) -> Answer {
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    Answer {
        status: output.status.code().expect("ended by itself"),
        out: text(&output.stdout),
        err: text(&output.stderr),
    }
}

impl Answer {
    #[track_caller]
    fn is(self, status: i32) -> Self {
        assert_eq!(self.status, status, "{}\n{}", self.out, self.err);
        assert!(!self.err.contains("panicked"), "{}", self.err);
        self
    }

    #[track_caller]
    fn says(self, words: &[&str]) -> Self {
        for word in words {
            assert!(self.err.contains(word), "no `{word}` in: {}", self.err);
        }
        self
    }
}

/// A table: names of its columns, and its rows.
fn table(text: &str) -> (Vec<String>, Vec<Vec<f64>>) {
    let mut lines = text.lines();
    let names = lines.next().unwrap().split(',').map(str::to_owned);
    let rows = lines.map(|line| line.split(',').map(|f| f.parse().unwrap()).collect());
    (names.collect(), rows.collect())
}

const OSCILLATOR: &str = "\
//! A mass on a spring.
model oscillator
param k = 400 N/m \"stiffness\"
param m = 1 kg
input push: N = 0 N
slide mass along (1, 0) { mass = m }
spring k1 between ground and mass { stiffness = k }
force on mass = (push, 0 N)
initial mass.v = 20 mm/s
output power_of_two = 2 * mass.x
set soft { k = 100 N/m }
";

fn with_oscillator(name: &str) -> PathBuf {
    let folder = folder(name);
    fs::write(folder.join("oscillator.flex"), OSCILLATOR).unwrap();
    folder
}

#[test]
fn help_has_examples_everywhere() {
    let here = folder("help");
    for subcommand in [
        "new",
        "check",
        "derive",
        "emit",
        "simulate",
        "static",
        "modes",
        "sweep",
        "response",
        "sensitivity",
    ] {
        let answer = flexure(&here, &[subcommand, "--help"]).is(0);
        assert!(answer.out.contains("Examples:"), "{}", answer.out);
        assert!(answer.out.contains(&format!("flexure {subcommand}")));
    }
    assert!(
        flexure(&here, &["--help"])
            .is(0)
            .out
            .contains("Exit status")
    );
    flexure(&here, &[]).is(2);
    flexure(&here, &["simulte"]).is(2).says(&["simulate"]);
    flexure(&here, &["simulate", "a.flex", "--until", "1s", "--color"]).is(2);
}

#[test]
fn every_model_checks_derives_and_emits() {
    let here = folder("every_model");
    for name in [
        "double_rocker",
        "four_bar",
        "msdm",
        "pendulum",
        "lugre_mass",
    ] {
        let file = model(name);
        let checked = flexure(&here, &["check", &file]).is(0);
        assert!(
            checked.out.contains(&format!("model {name}")),
            "{}",
            checked.out
        );
        for format in ["text", "latex", "markdown"] {
            let derived = flexure(&here, &["derive", &file, "--format", format]).is(0);
            assert!(derived.out.len() > 200, "{}", derived.out);
        }
        for form in ["rust", "tape", "dot"] {
            let emitted = flexure(&here, &["emit", &file, "--as", form]).is(0);
            assert!(emitted.out.len() > 200, "{}", emitted.out);
            let out = format!("{name}.{form}");
            flexure(&here, &["emit", &file, "--as", form, "-o", &out]).is(0);
            assert_eq!(fs::read_to_string(here.join(out)).unwrap(), emitted.out);
        }
    }
}

#[test]
fn tables_are_reported_and_can_be_turned_off() {
    let here = folder("tables");
    let file = model("double_rocker");
    let checked = flexure(&here, &["check", &file]).is(0).out;
    assert!(checked.contains("6 functions of degree"), "{checked}");
    let rows = |more: &[&str]| {
        let mut words = vec!["simulate", &file, "--until", "20us", "--dt", "1us"];
        words.extend(more);
        flexure(&here, &words).is(0).out
    };
    let (tabulated, exact) = (rows(&[]), rows(&["--exact"]));
    assert_eq!(tabulated.lines().count(), exact.lines().count());
    // They differ by rounding, and not by nothing: the switch does something.
    assert_ne!(tabulated, exact);
    // Andrews' mechanism turns all round.
    let file = model("andrews");
    flexure(&here, &["simulate", &file, "--until", "20ms"])
        .is(0)
        .says(&["steps were outside of the tables' intervals"]);
}

#[test]
fn derive_shows_the_article_its_own_equations() {
    let here = folder("derive");
    let text = flexure(&here, &["derive", &model("double_rocker")])
        .is(0)
        .out;
    for expected in ["A(φ1)", "C0", "C3", "ω2", "ω3", "cos(φ2 - φ1", "τ"] {
        assert!(text.contains(expected), "no `{expected}` in\n{text}");
    }
}

#[test]
fn a_new_model_checks_and_runs_and_is_never_overwritten() {
    let here = folder("new");
    flexure(&here, &["new", "my-stage"])
        .is(0)
        .says(&["my-stage.flex"]);
    let text = fs::read_to_string(here.join("my-stage.flex")).unwrap();
    assert!(text.contains("\nmodel my_stage\n"), "{text}");
    let checked = flexure(&here, &["check", "my-stage.flex"]).is(0);
    assert!(!checked.err.contains("warning"), "{}", checked.err);
    flexure(
        &here,
        &[
            "simulate",
            "my-stage.flex",
            "--until",
            "5ms",
            "--plot",
            "a.html",
        ],
    )
    .is(0);
    assert!(fs::metadata(here.join("a.html")).unwrap().len() > 5000);
    flexure(&here, &["new", "my-stage"])
        .is(1)
        .says(&["is there already"]);
    flexure(&here, &["new", "my-stage.flex"]).is(1);
    assert_eq!(
        fs::read_to_string(here.join("my-stage.flex")).unwrap(),
        text
    );
    flexure(&here, &["new", "3rd"])
        .is(2)
        .says(&["a letter first"]);
    flexure(&here, &["new", "nowhere/a"])
        .is(1)
        .says(&["no folder `nowhere`"]);
}

#[test]
fn a_run_gives_a_table_of_all_states_and_outputs() {
    let here = with_oscillator("table");
    let call = [
        "simulate",
        "oscillator.flex",
        "--until",
        "0.5s",
        "--every",
        "10ms",
    ];
    let (names, rows) = table(&flexure(&here, &call).is(0).out);
    assert_eq!(names, ["t", "mass.x", "mass.v", "power_of_two"]);
    assert_eq!(rows.len(), 51);
    for (k, row) in rows.iter().enumerate() {
        assert!((row[0] - 0.01 * k as f64).abs() < 1e-15);
        let exact = 1e-3 * (20.0 * row[0]).sin();
        assert!((row[1] - exact).abs() < 1e-9, "{row:?}");
        assert_eq!(row[3], 2.0 * row[1]);
    }
    let file = flexure(&here, &[&call[..], &["-o", "a.csv", "-q"]].concat()).is(0);
    assert_eq!((file.out.as_str(), file.err.as_str()), ("", ""));
    let text = fs::read_to_string(here.join("a.csv")).unwrap();
    assert_eq!(table(&text).1, rows);
    // 17 significant digits.
    let field = text.lines().nth(2).unwrap().split(',').nth(1).unwrap();
    let digits = field.split('e').next().unwrap().replace(['.', '-'], "");
    assert_eq!(digits.len(), 17, "{field}");
    assert_eq!(leftovers(&here), Vec::<String>::new());
}

#[test]
fn fixed_steps_rows_per_step_and_energies() {
    let here = with_oscillator("steps");
    let call = [
        "simulate",
        "oscillator.flex",
        "--until",
        "0.1",
        "--dt",
        "1ms",
    ];
    let (_, rows) = table(
        &flexure(&here, &[&call[..], &["--every", "0"]].concat())
            .is(0)
            .out,
    );
    assert_eq!(rows.len(), 101);
    let (names, rows) = table(
        &flexure(&here, &[&call[..], &["--energy"]].concat())
            .is(0)
            .out,
    );
    let balance = names.iter().position(|n| n == "energy.balance").unwrap();
    assert!(rows.iter().all(|row| row[balance].abs() < 1e-11));
    assert!(names.contains(&"energy.kinetic".to_owned()));
}

#[test]
fn methods_agree_and_the_choice_is_told() {
    let here = folder("methods");
    let actuator = model("double_rocker");
    let run = |method: &str| {
        let call = ["simulate", &actuator, "--until", "2ms"];
        let low = ["--set", "Fp=0.2N", "--rtol", "1e-9", "--method", method];
        flexure(&here, &[&call[..], &low].concat()).is(0)
    };
    let position = |answer: &Answer| {
        let (names, rows) = table(&answer.out);
        let column = names.iter().position(|n| n == "stage.x").unwrap();
        rows.last().unwrap()[column]
    };
    let [explicit, stiff] = ["explicit", "stiff"].map(|method| position(&run(method)));
    let told = "of them stiff: stability would have limited explicit ones";
    let chosen = position(&run("auto").says(&[told]));
    assert!((explicit - stiff).abs() < 1e-6 * explicit.abs());
    assert!((explicit - chosen).abs() < 1e-6 * explicit.abs());
    let checked = |more: &[&str]| {
        let call = ["check", &actuator];
        flexure(&here, &[&call[..], more].concat()).is(0).out
    };
    assert!(checked(&["--set", "Fp=0.2N"]).contains(told));
    assert!(checked(&[]).contains("explicit: stability did not limit them"));
}

#[test]
fn params_sets_and_inputs_carry_units() {
    let here = with_oscillator("settings");
    let last_x = |arguments: &[&str]| {
        let call = ["simulate", "oscillator.flex", "--until", "50 ms"];
        let answer = flexure(&here, &[&call[..], arguments].concat()).is(0);
        table(&answer.out).1.last().unwrap()[1]
    };
    let free = |omega: f64| 0.02 / omega * (omega * 0.05).sin();
    let near = |a: f64, b: f64| assert!((a - b).abs() < 1e-9, "{a} {b}");
    near(last_x(&[]), free(20.0));
    near(last_x(&["--use", "soft"]), free(10.0));
    near(last_x(&["--use", "soft", "--set", "k=0.9kN/m"]), free(30.0));
    near(
        last_x(&["--set", "k = 900", "--set", "m=1000g"]),
        free(30.0),
    );
    let pushed = free(20.0) + 0.1 * (1.0 - 1f64.cos());
    near(last_x(&["--set", "push=40N"]), pushed);
}

#[test]
fn wrong_settings_are_wrong_calls() {
    let here = with_oscillator("wrong");
    let wrong = |arguments: &[&str], words: &[&str]| {
        let call = ["simulate", "oscillator.flex", "--until", "1ms"];
        let answer = flexure(&here, &[&call[..], arguments].concat())
            .is(2)
            .says(words);
        assert_eq!(answer.out, "");
    };
    wrong(&["--set", "K=3"], &["no param `K`", "did you mean `k`"]);
    wrong(
        &["--set", "temperature=3"],
        &["no param `temperature`", "k, m"],
    );
    wrong(&["--set", "k=3mm"], &["a stiffness (N/m)", "a length"]);
    wrong(&["--set", "push=3mm"], &["a force (N)", "a length"]);
    wrong(&["--set", "k=3 furlong"], &["furlong"]);
    wrong(&["--set", "k"], &["sets nothing"]);
    wrong(&["--set", "k=1e999"], &["too large"]);
    wrong(&["--use", "hard"], &["no parameter set `hard`", "`soft`"]);
    wrong(&["--rtol", "2"], &["1e-13 to 0.1"]);
    wrong(&["--rtol", "1e-6", "--dt", "1us"], &["cannot be used with"]);
    wrong(
        &["--method", "stiff", "--dt", "1us"],
        &["cannot be used with"],
    );
    wrong(&["--method", "implicit"], &["auto, explicit, stiff"]);
    wrong(&["--dt", "0s"], &["above zero"]);
    wrong(&["--every", "-1s"], &["above zero"]);
    wrong(&["--every", "1e-15s"], &["rows"]);
    wrong(
        &["--every", "1e-12"],
        &["rows, more than 1e7 are not allowed"],
    );
    wrong(&["--rtol", "0"], &["1e-13 to 0.1"]);
    wrong(&["--rtol", "NaN"], &["1e-13 to 0.1"]);
    wrong(&["--rtol", "-1"], &["1e-13 to 0.1"]);
    wrong(&["--dt", "1e-300"], &["steps, more than"]);
    wrong(&["--dt", "1e-15 s"], &["steps"]);
    wrong(&["--plot", "a.png"], &[".svg or .html"]);
    wrong(&["-o", "oscillator.flex"], &["overwrite the model"]);
    wrong(&["-o", "a.svg", "--plot", "a.svg"], &["both"]);
    flexure(&here, &["simulate", "oscillator.flex"])
        .is(2)
        .says(&["--until"]);
    flexure(&here, &["simulate", "oscillator.flex", "--until", "3 kg"])
        .is(2)
        .says(&["a time (s)", "a mass"]);
    flexure(&here, &["simulate", "oscillator.flex", "--until", "-1s"]).is(2);
    flexure(
        &here,
        &["emit", "oscillator.flex", "-o", "./oscillator.flex"],
    )
    .is(2);
    assert_eq!(
        fs::read_to_string(here.join("oscillator.flex")).unwrap(),
        OSCILLATOR
    );
}

#[test]
fn models_that_fail_say_where() {
    let here = with_oscillator("failing");
    flexure(&here, &["check", "nothing.flex"])
        .is(1)
        .says(&["no such file"]);
    flexure(&here, &["check", "."])
        .is(1)
        .says(&["it is a folder"]);
    fs::write(here.join("binary.flex"), [0xff, 0xfe, 0]).unwrap();
    flexure(&here, &["check", "binary.flex"])
        .is(1)
        .says(&["UTF-8"]);
    let broken = OSCILLATOR.replace("= 400 N/m", "= 400 N");
    fs::write(here.join("broken.flex"), broken).unwrap();
    let answer = flexure(&here, &["derive", "broken.flex"]).is(1);
    assert_eq!(answer.out, "");
    answer.says(&["error: ", "broken.flex:", "^"]);
    flexure(&here, &["check", "oscillator.flex", "--set", "m=-1kg"])
        .is(1)
        .says(&["error: "]);
}

#[test]
fn files_that_cannot_be_written_are_found_before_the_run() {
    let here = with_oscillator("unwritable");
    fs::create_dir(here.join("folder.csv")).unwrap();
    let long = [
        "simulate",
        "oscillator.flex",
        "--until",
        "1e9s",
        "--dt",
        "100s",
    ];
    let fails = |arguments: &[&str], words: &[&str]| {
        flexure(&here, &[&long[..], arguments].concat())
            .is(1)
            .says(words);
    };
    fails(&["-o", "nowhere/a.csv"], &["no folder `nowhere`"]);
    fails(&["-o", "folder.csv"], &["it is a folder"]);
    fails(&["--plot", "nowhere/a.svg"], &["no folder `nowhere`"]);
    flexure(&here, &["emit", "oscillator.flex", "-o", "nowhere/a.rs"]).is(1);
    assert_eq!(leftovers(&here), Vec::<String>::new());
}

/// Files that a call should have cleared away.
fn leftovers(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.contains("partial"))
        .collect()
}

#[test]
fn a_run_that_fails_keeps_its_rows() {
    let here = folder("failed_run");
    // Pulled apart by a spring of negative stiffness, until numbers end.
    let unstable = OSCILLATOR.replace("stiffness = k }", "stiffness = 1 N/m }")
        + "force on mass = (1e6 N/m * mass.x, 0 N)\n";
    fs::write(here.join("unstable.flex"), unstable).unwrap();
    let call = ["simulate", "unstable.flex", "--until", "10s", "--dt", "1ms"];
    let files = ["-o", "a.csv", "--plot", "a.html"];
    flexure(&here, &[&call[..], &files].concat())
        .is(1)
        .says(&["error: ", "rows until then are kept"]);
    let (names, rows) = table(&fs::read_to_string(here.join("a.csv")).unwrap());
    assert_eq!(names.len(), 4);
    assert!(rows.len() > 10 && rows.last().unwrap()[0] < 10.0);
    assert!(
        fs::read_to_string(here.join("a.html"))
            .unwrap()
            .contains("The run failed")
    );
}

#[test]
fn a_stop_ends_a_run_well() {
    let here = folder("stop");
    let model = OSCILLATOR.to_owned() + "stop when mass.x > 0.5 mm \"it hits the wall\"\n";
    fs::write(here.join("wall.flex"), model).unwrap();
    let call = ["simulate", "wall.flex", "--until", "1s", "-o", "a.csv"];
    flexure(&here, &call).is(0).says(&["it hits the wall"]);
    let (_, rows) = table(&fs::read_to_string(here.join("a.csv")).unwrap());
    let end = rows.last().unwrap();
    assert!((end[0] - 0.5f64.asin() / 20.0).abs() < 1e-9 && (end[1] - 0.5e-3).abs() < 1e-9);
}

#[test]
fn pictures_are_whole_and_load_nothing() {
    let here = folder("pictures");
    let file = model("double_rocker");
    for plot in ["a.svg", "a.html"] {
        let call = [
            "simulate", &file, "--until", "2ms", "--set", "Fp=15N", "--plot", plot,
        ];
        let answer = flexure(&here, &call).is(0);
        assert_eq!(answer.out, "");
        let text = fs::read_to_string(here.join(plot)).unwrap();
        for expected in ["Position (µm)", "stage.x", "time (ms)"] {
            assert!(text.contains(expected), "{plot}: {expected}");
        }
        for external in ["src=", "href=", "@import", "url("] {
            assert!(!text.contains(external), "{plot}: {external}");
        }
        assert!(!text.contains("NaN"), "{plot}");
        let scripts = usize::from(plot == "a.html");
        assert_eq!(text.matches("<script").count(), scripts, "{plot}");
    }
    let page = fs::read_to_string(here.join("a.html")).unwrap();
    for expected in [
        "crank",
        "coupler",
        "rocker",
        "15 N",
        "<mi>φ</mi>",
        "From 1 ms to 2 ms",
        "Displacements are magnified",
        "prefers-color-scheme",
    ] {
        assert!(page.contains(expected), "{expected}");
    }
}

#[test]
fn a_reader_that_leaves_is_no_failure() {
    let here = with_oscillator("pipe");
    let call = [
        "simulate",
        "oscillator.flex",
        "--until",
        "100s",
        "--every",
        "1ms",
    ];
    let mut child = Command::new(env!("CARGO_BIN_EXE_flexure"))
        .current_dir(&here)
        .args(call)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let answer = answer(&child.wait_with_output().unwrap());
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
}

#[test]
fn the_first_column_is_time_and_states_come_before_outputs() {
    let here = folder("columns");
    let call = ["simulate", &model("double_rocker"), "--until", "0.1ms"];
    let (names, rows) = table(&flexure(&here, &call).is(0).out);
    assert_eq!(names[0], "t");
    for state in [
        "crank.angle",
        "crank.rate",
        "stack.x",
        "stack.v",
        "stage.x",
        "stage.v",
        "tip.z",
    ] {
        assert!(names[1..8].contains(&state.to_owned()), "{names:?}");
    }
    assert!((rows[0][1] - 80f64.to_radians()).abs() < 1e-15);
    assert!(rows.iter().all(|row| row.len() == names.len()));
}

/// A mass of 1 kg on 400 N/m, pushed by 2 N.
#[test]
fn statics_and_modes_of_an_oscillator() {
    let here = with_oscillator("statics");
    let file = "oscillator.flex";
    let said = flexure(&here, &["static", file, "--set", "push=2N"])
        .is(0)
        .out;
    // 2 N over 400 N/m, twice.
    assert!(said.contains("power_of_two     10 mm"), "{said}");
    assert!(said.contains("at power_of_two  100 N/m"), "{said}");
    // sqrt(400)/2π Hz.
    let said = flexure(&here, &["modes", file]).is(0).out;
    assert!(
        said.contains("3.1831 Hz") && said.contains("mass.x 100.0 %"),
        "{said}"
    );
    let words = [
        "modes",
        file,
        "--response",
        "push:mass.x",
        "--from",
        "1Hz",
        "--to",
        "2Hz",
    ];
    let (names, rows) = table(
        &flexure(&here, &[&words[..], &["--points", "3"]].concat())
            .is(0)
            .out,
    );
    assert_eq!(names, ["frequency", "magnitude", "phase"]);
    assert_eq!(rows.len(), 3);
    for row in rows {
        let w = std::f64::consts::TAU * row[0];
        assert!((row[1] * (400.0 - w * w) - 1.0).abs() < 1e-12, "{row:?}");
    }
    for picture in ["bode.svg", "bode.html"] {
        flexure(&here, &[&words[..], &["--plot", picture]].concat()).is(0);
        let text = fs::read_to_string(here.join(picture)).unwrap();
        for words in ["Response of mass.x to push", "magnitude (m per N)", "phase"] {
            assert!(text.contains(words), "{words}: {text}");
        }
    }
    flexure(&here, &["modes", file, "--matrices", "linear"]).is(0);
    let part = |name: &str| fs::read_to_string(here.join(format!("linear_{name}.csv"))).unwrap();
    let matrix = |name: &str| -> Vec<Vec<f64>> {
        let text = part(name);
        let rows = text.lines();
        rows.map(|row| row.split(',').map(|v| v.parse().unwrap()).collect())
            .collect()
    };
    assert_eq!(matrix("A"), [[0.0, 1.0], [-400.0, 0.0]]);
    assert_eq!(matrix("B"), [[0.0], [1.0]]);
    assert_eq!(matrix("C")[0], [2.0, 0.0]);
    assert_eq!(matrix("D")[0], [0.0]);
    let names = part("names");
    for line in [
        "kind,number,name,unit",
        "state,1,mass.x,m",
        "state,2,mass.v,m/s",
        "input,1,push,N",
    ] {
        assert!(names.lines().any(|known| known == line), "{names}");
    }
}

#[test]
fn wrong_studies_at_rest_are_refused() {
    let here = with_oscillator("statics_refused");
    let file = "oscillator.flex";
    let refused = |words: &[&str], says: &[&str]| {
        flexure(&here, words).is(2).says(says);
    };
    refused(
        &["static", file, "--without", "tip"],
        &["no contact `tip`", "no contacts at all"],
    );
    refused(
        &["static", file, "--drive", "pusch=1N"],
        &["did you mean `push`?"],
    );
    refused(&["static", file, "--drive", "push=1m"], &["force"]);
    refused(
        &["static", file, "--output", "mas.x"],
        &["did you mean `mass.x`?"],
    );
    refused(&["modes", file, "--response", "push"], &["xp:stage.x"]);
    refused(
        &[
            "modes",
            file,
            "--response",
            "push:mass.x",
            "--from",
            "2Hz",
            "--to",
            "1Hz",
        ],
        &["below"],
    );
    refused(
        &["modes", file, "--response", "push:mass.x", "--from", "2s"],
        &["frequency"],
    );
}
