//! Hand-written C, built by the C compiler of the machine and run as programs of their own.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;

use crate::study::{End, Method, Outcome, Study};

/// As the hand-written programs are built.
const FLAGS: [&str; 8] = [
    "-O3",
    "-march=native",
    "-fno-math-errno",
    "-fno-trapping-math",
    "-pthread",
    "-Wall",
    "-Wextra",
    "-Wno-psabi",
];

/// The programs, built.
#[derive(Clone, Debug)]
pub struct Baseline {
    /// The actuator with functions of libm.
    pub libm: Program,
    /// With short series about the closed configuration.
    pub series: Program,
    /// With series, over several trajectories at once: how many, and the program.
    pub lanes: Vec<(usize, Program)>,
    /// Andrews' mechanism in absolute coordinates.
    pub andrews: Program,
}

/// A program.
#[derive(Clone, Debug)]
pub struct Program(PathBuf);

impl Baseline {
    /// Builds all.
    pub fn build() -> Result<Self, String> {
        let libm = Program::build("double_rocker", "libm", &[])?;
        let lanes = [4, 8, 16]
            .into_iter()
            .map(|lanes| {
                let flag = format!("-DLANES={lanes}");
                let name = format!("lanes{lanes}");
                Program::build("double_rocker", &name, &["-DSERIES", &flag])
                    .map(|program| (lanes, program))
            })
            .collect::<Result<_, _>>()?;
        Ok(Self {
            libm,
            series: Program::build("double_rocker", "series", &["-DSERIES"])?,
            lanes,
            andrews: Program::build("andrews", "andrews", &[])?,
        })
    }

    /// What compiling the actuator takes, in s: the least of some rounds.
    pub fn compile_seconds(&self, rounds: usize) -> Option<f64> {
        (0..rounds)
            .filter_map(|_| {
                let start = Instant::now();
                let built = Program::build("double_rocker", "libm", &[]);
                built.ok().map(|_| start.elapsed().as_secs_f64())
            })
            .reduce(f64::min)
    }
}

impl Program {
    fn build(source: &str, name: &str, defines: &[&str]) -> Result<Self, String> {
        let compiler = std::env::var("CC").unwrap_or_else(|_| "gcc".to_owned());
        let folder = crate::table::target().join("baseline");
        std::fs::create_dir_all(&folder).map_err(|why| why.to_string())?;
        let program = folder.join(name);
        let source = Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("benches/baseline")
            .join(format!("{source}.c"));
        let output = Command::new(&compiler)
            .args(FLAGS)
            .args(defines)
            .arg(source)
            .arg("-o")
            .arg(&program)
            .arg("-lm")
            .output()
            .map_err(|why| format!("there is no C compiler `{compiler}`: {why}"))?;
        if output.status.success() {
            Ok(Self(program))
        } else {
            Err(format!(
                "`{compiler}` fails:\n{}",
                String::from_utf8_lossy(&output.stderr)
            ))
        }
    }

    /// Runs a study. `perturbation` in rad is added to the crank's angle at the start.
    pub fn study(&self, study: &Study, perturbation: f64) -> Result<Outcome, String> {
        let method = match study.method {
            Method::Equal(_) => "rk4",
            Method::Adaptive(_) => "dop853",
        };
        let arguments = [
            method.to_owned(),
            format!("{:e}", study.method.setting()),
            format!("{:e}", study.from),
            format!("{:e}", study.until),
            if study.in_cycles { "cycles" } else { "s" }.to_owned(),
            study.threads.to_string(),
            format!("{perturbation:e}"),
        ];
        let mut input = String::new();
        for design in &study.designs {
            let values = design.values().map(|value| format!("{value:e}"));
            input.push_str(&values.join(" "));
            input.push('\n');
        }
        let (head, lines) = self.numbers(&arguments, &input)?;
        let ends = lines
            .iter()
            .map(|line| {
                let [from, state @ ..]: [f64; 8] = line.as_slice().try_into().ok()?;
                Some(End { from, state })
            })
            .collect::<Option<Vec<_>>>();
        match (&head[..], ends) {
            (&[seconds, evaluations, memory], Some(ends)) => Ok(Outcome {
                seconds,
                evaluations: evaluations as u64,
                memory: Some(memory as u64),
                ends,
            }),
            _ => Err("the program of C printed something else".to_owned()),
        }
    }

    /// Runs the program: the numbers of the first line of its output, and of all others.
    pub fn numbers(
        &self,
        arguments: &[String],
        input: &str,
    ) -> Result<(Vec<f64>, Vec<Vec<f64>>), String> {
        let mut child = Command::new(&self.0)
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(|why| why.to_string())?;
        if let Some(mut pipe) = child.stdin.take() {
            pipe.write_all(input.as_bytes())
                .map_err(|why| why.to_string())?;
        }
        let output = child.wait_with_output().map_err(|why| why.to_string())?;
        if !output.status.success() {
            return Err(String::from_utf8_lossy(&output.stderr).trim().to_owned());
        }
        let text = String::from_utf8_lossy(&output.stdout);
        let mut lines = text.lines().map(|line| {
            line.split_whitespace()
                .map(|word| word.parse::<f64>().map_err(|why| why.to_string()))
                .collect::<Result<Vec<f64>, String>>()
        });
        let head = lines.next().ok_or("the program of C printed nothing")??;
        Ok((head, lines.collect::<Result<_, _>>()?))
    }
}
