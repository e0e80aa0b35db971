//! What can run a study of the actuator: the list that every workload goes through. Another way to
//! run the model is another entry in [`all`].

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use flexure::runtime::diagnostic::Diagnostic;
use flexure::runtime::lanes::{LaneSystem, Path};
use flexure::runtime::system::System;
use flexure::simulate;
use flexure_models::double_rocker::{self, Params, Prepared};

use crate::baseline::Baseline;
use crate::recorded::peak_memory;
use crate::study::{End, Method, Outcome, STAGE_X, Study};

const MODEL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/models/double_rocker.flex");

/// The methods that an implementation has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Has {
    /// Equal steps alone.
    Equal,
    /// Steps of its own choice alone.
    Adaptive,
    /// Both.
    Both,
}

/// Something that runs studies.
pub struct Implementation {
    /// Its name in the table.
    pub name: String,
    /// The methods it has.
    pub has: Has,
    /// Trajectories that it steps side by side.
    pub lanes: usize,
    /// Runs a study.
    pub run: Box<Runner>,
}

/// Runs a study.
pub type Runner = dyn Fn(&Study) -> Result<Outcome, String>;

impl Implementation {
    fn new(
        name: &str,
        has: Has,
        run: impl Fn(&Study) -> Result<Outcome, String> + 'static,
    ) -> Self {
        Self {
            name: name.to_owned(),
            has,
            lanes: 1,
            run: Box::new(run),
        }
    }

    /// Whose steps it takes: those of one family differ in how fast they are alone.
    pub fn family(&self) -> &str {
        self.name.split(' ').next().unwrap_or_default()
    }

    /// Whether it has the method.
    pub fn can(&self, method: Method) -> bool {
        match method {
            Method::Equal(_) => self.has != Has::Adaptive,
            Method::Adaptive(_) => self.has != Has::Equal,
        }
    }
}

/// Everything there is, C first.
pub fn all(c: Option<&Baseline>) -> Vec<Implementation> {
    let mut all = Vec::new();
    if let Some(c) = c.cloned() {
        let (libm, series) = (c.libm, c.series);
        all.push(Implementation::new("C libm", Has::Both, move |study| {
            libm.study(study, 0.0)
        }));
        all.push(Implementation::new("C series", Has::Both, move |study| {
            series.study(study, 0.0)
        }));
        for (lanes, program) in c.lanes {
            let name = format!("C series {lanes} lanes");
            let run = move |study: &Study| program.study(study, 0.0);
            let mut implementation = Implementation::new(&name, Has::Equal, run);
            implementation.lanes = lanes;
            all.push(implementation);
        }
    }
    all.push(Implementation::new(
        "flexure compiled simulate",
        Has::Both,
        |study| {
            shared_out(study, &|design| {
                let model = design.prepare().map_err(|why| why.message)?;
                simulated(&model, study, design)
            })
        },
    ));
    all.push(Implementation::new(
        "flexure compiled rhs",
        Has::Equal,
        |study| {
            shared_out(study, &|design| {
                let model = design.prepare().map_err(|why| why.message)?;
                Ok(bare(&model, study, design))
            })
        },
    ));
    let mut ensemble = Implementation::new("flexure compiled ensemble", Has::Both, |study| {
        ensembled(study, &Params::prepare)
    });
    ensemble.lanes = Path::chosen().lanes();
    all.push(ensemble);
    let mut ensemble = Implementation::new("flexure tape ensemble", Has::Both, |study| {
        let model = flexure::Model::from_path(MODEL).map_err(|why| why.to_string())?;
        let prepare = |design: &Params| model.tape().prepare(&design.values());
        ensembled(study, &prepare)
    });
    ensemble.lanes = Path::chosen().lanes();
    all.push(ensemble);
    all.push(Implementation::new(
        "flexure tape simulate",
        Has::Both,
        |study| {
            let model = flexure::Model::from_path(MODEL).map_err(|why| why.to_string())?;
            shared_out(study, &|design| {
                let system = model
                    .tape()
                    .prepare(&design.values())
                    .map_err(|why| why.message)?;
                simulated(&system, study, design)
            })
        },
    ));
    all
}

/// What one run gives: its end, and evaluations of the right-hand side.
type Done = (End, u64);

/// Runs a study on as many threads as it asks for, each taking the next design.
fn shared_out(
    study: &Study,
    run: &(dyn Fn(&Params) -> Result<Done, String> + Sync),
) -> Result<Outcome, String> {
    let next = AtomicUsize::new(0);
    let results = Mutex::new(vec![None; study.designs.len()]);
    let work = || {
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(design) = study.designs.get(index) else {
                break;
            };
            let result = run(design);
            if let Ok(mut results) = results.lock() {
                results[index] = Some(result);
            }
        }
    };
    let before = peak_memory();
    let start = Instant::now();
    std::thread::scope(|scope| {
        for _ in 1..study.threads {
            scope.spawn(work);
        }
        work();
    });
    let seconds = start.elapsed().as_secs_f64();
    let memory = before.and_then(|peak| peak.grown());
    let mut outcome = Outcome {
        seconds,
        memory,
        ..Outcome::default()
    };
    let results = results.into_inner().map_err(|why| why.to_string())?;
    for result in results {
        let (end, evaluations) = result.ok_or("a run is missing")??;
        outcome.ends.push(end);
        outcome.evaluations += evaluations;
    }
    Ok(outcome)
}

/// All runs by `flexure::ensemble`.
fn ensembled<S: LaneSystem>(
    study: &Study,
    prepare: &dyn Fn(&Params) -> Result<S, Diagnostic>,
) -> Result<Outcome, String> {
    let times: Vec<(f64, f64)> = study.designs.iter().map(|d| study.times(d)).collect();
    let ensemble = flexure::ensemble(study.designs.iter().map(prepare))
        .until_each(|index| times[index].1)
        .samples_each(|index| vec![times[index].0])
        .threads(study.threads);
    let ensemble = match study.method {
        Method::Equal(step) => ensemble.dt(step),
        Method::Adaptive(tolerance) => ensemble.rtol(tolerance),
    };
    let (mut outcome, mut failure) = (Outcome::default(), None);
    let before = peak_memory();
    let start = Instant::now();
    ensemble.run(|_, done| match done {
        Ok(done) => {
            let mut end = End::default();
            if let Some(sample) = done.samples.first() {
                end.from = sample.state[STAGE_X];
            }
            end.state.copy_from_slice(&done.summary.state);
            outcome.evaluations += done.summary.statistics.evaluations;
            outcome.ends.push(end);
        }
        Err(why) => failure = Some(why.diagnostic().message),
    });
    outcome.seconds = start.elapsed().as_secs_f64();
    outcome.memory = before.and_then(|peak| peak.grown());
    failure.map_or(Ok(outcome), Err)
}

/// A run by `flexure::simulate`.
fn simulated<S: System + ?Sized>(
    model: &S,
    study: &Study,
    design: &Params,
) -> Result<Done, String> {
    let (from, until) = study.times(design);
    let run = simulate(model).until(until);
    let run = match study.method {
        Method::Equal(step) => run.dt(step),
        Method::Adaptive(tolerance) => run.rtol(tolerance),
    };
    let every = if from > 0.0 { from } else { until };
    let run = run
        .every(every)
        .run()
        .map_err(|failure| failure.breakdown.message.to_string())?;
    let position = run.column("stage.x");
    let summary = run.summary();
    let end = End {
        from: if from > 0.0 {
            position.values()[1]
        } else {
            0.0
        },
        state: summary.state[..]
            .try_into()
            .map_err(|_| "the model has other states")?,
    };
    Ok((end, summary.statistics.evaluations))
}

/// A run by the compiled right-hand side alone, stepped here by the classical Runge–Kutta method between
/// the drive's kinks.
fn bare(model: &Prepared<f64>, study: &Study, design: &Params) -> Done {
    let (from, until) = study.times(design);
    let step = study.method.setting();
    let (mut x, mut d) = ([0.0; 7], [0.0; 4]);
    model.start(&mut x, &mut d);
    let (mut t, mut evaluations) = (0.0, 0);
    let mut end = End::default();
    let mut noted = from <= 0.0;
    while t < until {
        let mut kink = [0.0];
        double_rocker::next_kinks(&d, model, &mut kink);
        let kink = kink[0];
        if kink <= t {
            model.pass_kink(0, &mut d);
            continue;
        }
        let mut to = kink.min(until);
        if !noted {
            to = to.min(from);
        }
        let steps = ((to - t) / step * (1.0 - 1e-9)).ceil().max(1.0);
        let h = (to - t) / steps;
        for n in 0..steps as u64 {
            runge_kutta(model, t + n as f64 * h, h, &mut x, &d);
        }
        evaluations += 4 * steps as u64;
        t = to;
        if !noted && t >= from {
            noted = true;
            end.from = x[STAGE_X];
        }
    }
    end.state = x;
    (end, evaluations)
}

/// One step of the classical Runge–Kutta method.
#[inline(always)]
fn runge_kutta(model: &Prepared<f64>, t: f64, h: f64, x: &mut [f64; 7], d: &[f64; 4]) {
    let rates = |t: f64, x: &[f64; 7]| {
        let mut dx = [0.0; 7];
        double_rocker::rhs(t, x, d, &[], model, &mut dx);
        dx
    };
    let moved = |h: f64, k: &[f64; 7]| std::array::from_fn(|i| x[i] + h * k[i]);
    let k1 = rates(t, x);
    let k2 = rates(t + 0.5 * h, &moved(0.5 * h, &k1));
    let k3 = rates(t + 0.5 * h, &moved(0.5 * h, &k2));
    let k4 = rates(t + h, &moved(h, &k3));
    for i in 0..7 {
        x[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
    }
}
