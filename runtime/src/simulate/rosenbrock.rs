//! Rodas5P, a Rosenbrock method of order 5 with an estimate of order 4 and dense output of order 4:
//! eight stages, each a linear system with the same matrix 1/(γh) - J, where J is the exact
//! Jacobian of the rates. For systems whose fastest decay is much faster than their motion: a
//! bristle that slides under a low preload decays in less than a microsecond.
//!
//! From G. Steinebach: Construction of Rosenbrock–Wanner method Rodas5P and numerical benchmarks
//! within the Julia Differential Equations package, BIT Numerical Mathematics 63, 27 (2023), in the
//! form without products of J and a vector (E. Hairer, G. Wanner: Solving Ordinary Differential
//! Equations II, section IV.7).

use super::accounting::Flow;
use super::method::{Method, Step};
use crate::system::System;

const GAMMA: f64 = 0.21193756319429014;
/// Times of the stages, in steps.
const TIMES: [f64; 8] = [
    0.0,
    0.6358126895828704,
    0.4095798393397535,
    0.9769306725060716,
    0.4288403609558664,
    1.0,
    1.0,
    1.0,
];
/// What each stage adds up to its state. The last two add the stage before to its state.
const STATE: [&[f64]; 6] = [
    &[],
    &[3.0],
    &[2.849394379747939, 0.45842242204463923],
    &[-6.954028509809101, 2.489845061869568, -10.358996098473584],
    &[
        2.8029986275628964,
        0.5072464736228206,
        -0.3988312541770524,
        -0.04721187230404641,
    ],
    &[
        -7.502846399306121,
        2.561846144803919,
        -11.627539656261098,
        -0.18268767659942256,
        0.030198172008377946,
    ],
];
/// What each stage adds up on its right-hand side, divided by the step.
const SIDE: [&[f64]; 8] = [
    &[],
    &[-14.155112264123755],
    &[-17.97296035885952, -2.859693295451294],
    &[147.12150275711716, -1.41221402718213, 71.68940251302358],
    &[
        165.43517024871676,
        -0.4592823456491126,
        42.90938336958603,
        -5.961986721573306,
    ],
    &[
        24.854864614690072,
        -3.0009227002832186,
        47.4931110020768,
        5.5814197821558125,
        -0.6610691825249471,
    ],
    &[
        30.91273214028599,
        -3.1208243349937974,
        77.79954646070892,
        34.28646028294783,
        -19.097331116725623,
        -28.087943162872662,
    ],
    &[
        37.80277123390563,
        -3.2571969029072276,
        112.26918849496327,
        66.9347231244047,
        -40.06618937091002,
        -54.66780262877968,
        -9.48861652309627,
    ],
];
/// Share of each stage in the slope of the rates in time.
const SLOPE: [f64; 8] = [
    0.21193756319429014,
    -0.42387512638858027,
    -0.3384627126235924,
    1.8046452872882734,
    2.325825639765069,
    0.0,
    0.0,
    0.0,
];
/// Dense output: what each power of the fraction is made of.
const DENSE: [[f64; 8]; 3] = [
    [
        25.948786856663858,
        -2.5579724845846235,
        10.433815404888879,
        -2.3679251022685204,
        0.524948541321073,
        1.1241088310450404,
        0.4272876194431874,
        -0.17202221070155493,
    ],
    [
        -9.91568850695171,
        -0.9689944594115154,
        3.0438037242978453,
        -24.495224566215796,
        20.176138334709044,
        15.98066361424651,
        -6.789040303419874,
        -6.710236069923372,
    ],
    [
        11.419903575922262,
        2.8879645146136994,
        72.92137995996029,
        80.12511834622643,
        -52.072871366152654,
        -59.78993625266729,
        -0.15582684282751913,
        4.883087185713722,
    ],
];
/// The slope in time is taken by central differences over this share of the step on both sides:
/// exact for drives that are straight lines, and far below the method's error for others.
const SLOPE_SHARE: f64 = 1e-3;

/// Errors of steps of order 5 add up to more than those of Dormand and Prince's for the same
/// estimate: on the article's actuator, with this factor, a tolerance means about the same error at
/// the end with both.
const CAUTION: f64 = 10.0;

pub(super) struct Rosenbrock {
    /// The stages' changes of the state.
    k: [Vec<f64>; 8],
    stage: Vec<f64>,
    rates: Vec<f64>,
    /// Where the Jacobian and the slope were taken: time, state and rates.
    taken: (f64, Vec<f64>, Vec<f64>),
    jacobian: Vec<f64>,
    slope: Vec<f64>,
    /// 1/(γh) - J, as triangles.
    matrix: Vec<f64>,
    pivots: Vec<usize>,
    dense: [Vec<f64>; 3],
}

impl Rosenbrock {
    pub fn new(width: usize) -> Self {
        let zeros = || vec![0.0; width];
        Self {
            k: std::array::from_fn(|_| zeros()),
            stage: zeros(),
            rates: zeros(),
            taken: (f64::NAN, zeros(), zeros()),
            jacobian: vec![0.0; width * width],
            slope: zeros(),
            matrix: vec![0.0; width * width],
            pivots: vec![0; width],
            dense: std::array::from_fn(|_| zeros()),
        }
    }

    /// The Jacobian and the slope in time at the start of a step, unless they are there from a
    /// longer step that was rejected.
    fn linearize<S: System + ?Sized>(
        &mut self,
        flow: &mut Flow<'_, S>,
        t: f64,
        h: f64,
        x: &[f64],
        f: &[f64],
        d: &[f64],
    ) {
        if self.taken.0 == t && self.taken.1 == x && self.taken.2 == f {
            return;
        }
        flow.jacobian(t, x, d, &mut self.jacobian);
        let ahead = SLOPE_SHARE * h;
        flow.rates(t + ahead, x, d, &mut self.slope);
        flow.rates(t - ahead, x, d, &mut self.rates);
        for (slope, before) in self.slope.iter_mut().zip(&self.rates) {
            *slope = (*slope - before) / (2.0 * ahead);
        }
        self.taken.0 = t;
        self.taken.1.copy_from_slice(x);
        self.taken.2.copy_from_slice(f);
    }

    /// 1/(γh) - J, as triangles.
    fn factor(&mut self, h: f64) {
        let n = self.pivots.len();
        for (entry, jacobian) in self.matrix.iter_mut().zip(&self.jacobian) {
            *entry = -jacobian;
        }
        for i in 0..n {
            self.matrix[i * n + i] += 1.0 / (GAMMA * h);
        }
        factor(&mut self.matrix, &mut self.pivots);
    }
}

/// Turns a matrix into triangles, rows exchanged. What is singular becomes not a number.
fn factor(matrix: &mut [f64], pivots: &mut [usize]) {
    let n = pivots.len();
    for i in 0..n {
        let mut pivot = i;
        for row in i + 1..n {
            if matrix[row * n + i].abs() > matrix[pivot * n + i].abs() {
                pivot = row;
            }
        }
        pivots[i] = pivot;
        if pivot != i {
            for column in 0..n {
                matrix.swap(i * n + column, pivot * n + column);
            }
        }
        let (above, below) = matrix.split_at_mut((i + 1) * n);
        let above = &above[i * n..];
        for row in below.chunks_exact_mut(n) {
            if row[i] == 0.0 {
                continue;
            }
            let share = row[i] / above[i];
            row[i] = share;
            for column in i + 1..n {
                row[column] -= share * above[column];
            }
        }
    }
}

/// Solves with the triangles of [`factor`].
fn solve(matrix: &[f64], pivots: &[usize], x: &mut [f64]) {
    let n = pivots.len();
    for (i, &pivot) in pivots.iter().enumerate() {
        x.swap(i, pivot);
    }
    for i in 0..n {
        let row = &matrix[i * n..][..n];
        let sum: f64 = (0..i).map(|column| row[column] * x[column]).sum();
        x[i] -= sum;
    }
    for i in (0..n).rev() {
        let row = &matrix[i * n..][..n];
        let sum: f64 = (i + 1..n).map(|column| row[column] * x[column]).sum();
        x[i] = (x[i] - sum) / row[i];
    }
}

impl Method for Rosenbrock {
    const LOOKS: &'static [f64] = &[0.25, 0.5, 0.75, 1.0];

    fn order(&self) -> f64 {
        5.0
    }

    fn is_stiff(&self) -> bool {
        true
    }

    fn step<S: System + ?Sized>(
        &mut self,
        flow: &mut Flow<'_, S>,
        t: f64,
        h: f64,
        x: &[f64],
        f: &[f64],
        d: &[f64],
        x_end: &mut [f64],
    ) {
        self.linearize(flow, t, h, x, f, d);
        self.factor(h);
        let Self {
            k,
            stage,
            rates,
            slope,
            matrix,
            pivots,
            ..
        } = self;
        stage.copy_from_slice(x);
        for index in 0..8 {
            let (before, rest) = k.split_at_mut(index);
            let side = &mut rest[0];
            if index == 0 {
                side.copy_from_slice(f);
            } else {
                match STATE.get(index) {
                    Some(row) => {
                        stage.copy_from_slice(x);
                        add(row, 1.0, before, stage);
                    }
                    None => add(&[1.0], 1.0, &before[index - 1..], stage),
                }
                flow.rates(t + TIMES[index] * h, stage, d, rates);
                side.copy_from_slice(rates);
            }
            for (side, slope) in side.iter_mut().zip(slope.iter()) {
                *side += h * SLOPE[index] * slope;
            }
            add(SIDE[index], 1.0 / h, before, side);
            solve(matrix, pivots, side);
        }
        for (i, x_end) in x_end.iter_mut().enumerate() {
            *x_end = stage[i] + k[7][i];
        }
    }

    /// The last stage is the difference to the method of order 4, times [`CAUTION`].
    fn error_squared(&self, _h: f64, allowed: &[f64]) -> f64 {
        let sum: f64 = (self.k[7].iter().zip(allowed))
            .map(|(error, allowed)| (error / allowed).powi(2))
            .sum();
        CAUTION * CAUTION * (sum / allowed.len() as f64)
    }

    fn prepare<S: System + ?Sized>(&mut self, _flow: &mut Flow<'_, S>, _step: &Step<'_>) {
        for (dense, row) in self.dense.iter_mut().zip(&DENSE) {
            dense.fill(0.0);
            add(row, 1.0, &self.k, dense);
        }
    }

    fn interpolate(&self, step: &Step<'_>, fraction: f64, x: &mut [f64]) {
        let left = 1.0 - fraction;
        let [first, second, third] = &self.dense;
        for (i, x) in x.iter_mut().enumerate() {
            let bend = first[i] + fraction * (second[i] + fraction * third[i]);
            *x = left * step.x[i] + fraction * (step.x_end[i] + left * bend);
        }
    }
}

/// to += factor · Σ row · stages.
fn add(row: &[f64], factor: f64, stages: &[Vec<f64>], to: &mut [f64]) {
    for (coefficient, stage) in row.iter().zip(stages) {
        let share = factor * coefficient;
        for (to, stage) in to.iter_mut().zip(stage) {
            *to += share * stage;
        }
    }
}
