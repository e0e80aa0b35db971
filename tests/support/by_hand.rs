//! Mechanisms written down by hand: places of masses and stretches of springs as plain functions of
//! the coordinates, from which Lagrange's equations follow by finite differences.
//!
//! Shares nothing with the compiler, not even the reading of the model file.

use nalgebra::{DMatrix, DVector};

/// What a mechanism is at one configuration and time, in SI.
#[derive(Default)]
pub struct Drawing {
    /// Masses and where they are.
    pub masses: Vec<Mass>,
    /// Springs, hinges and stacks.
    pub springs: Vec<Spring>,
    /// Work of the loads, counted from anywhere; its slopes are the generalised forces.
    pub work: f64,
}

/// A mass, its moment of inertia about its centre, and where these are.
pub struct Mass {
    /// In kg.
    pub mass: f64,
    /// In kg m².
    pub inertia: f64,
    /// Centre in m and angle in rad.
    pub pose: [f64; 3],
}

impl Mass {
    /// A slender bar of that length about a centre.
    pub fn bar(mass: f64, length: f64, [x, y]: [f64; 2], angle: f64) -> Self {
        Self {
            mass,
            inertia: mass * length * length / 12.0,
            pose: [x, y, angle],
        }
    }

    /// A mass that does not turn, or whose turning has no inertia.
    pub fn point(mass: f64, [x, y]: [f64; 2]) -> Self {
        Self {
            mass,
            inertia: 0.0,
            pose: [x, y, 0.0],
        }
    }
}

/// A spring with a damper beside it.
#[derive(Default)]
pub struct Spring {
    /// In N/m or N m/rad.
    pub stiffness: f64,
    /// In N s/m or N m s/rad.
    pub damping: f64,
    /// Length or angle, counted from where it is at rest.
    pub stretch: f64,
    /// Free extension of a stack, which counts against the stretch.
    pub free: f64,
    /// Rate of the free extension.
    pub free_rate: f64,
}

impl Spring {
    /// Without free extension.
    pub fn new(stiffness: f64, damping: f64, stretch: f64) -> Self {
        Self {
            stiffness,
            damping,
            stretch,
            ..Self::default()
        }
    }
}

/// A mechanism as a function of its coordinates (angles in rad) and time.
pub struct ByHand<'f> {
    /// Where everything is.
    pub draw: &'f dyn Fn(&[f64], f64) -> Drawing,
    /// Acceleration of gravity, downwards, in m/s².
    pub gravity: f64,
}

/// First and second derivatives of all poses, stretches and the work along a line.
struct Slopes {
    first: Vec<f64>,
    second: Vec<f64>,
}

/// First step of finite differences in rad; the last is an eighth of it, 7.5 mrad, over which second
/// differences keep eleven digits.
const STEP: f64 = 0.06;

/// Richardson's extrapolation of values of second order, each with half the step of the one before.
fn extrapolate(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    for column in 1..rows.len() {
        let factor = 4f64.powi(column as i32) - 1.0;
        for row in (column..rows.len()).rev() {
            for i in 0..rows[row].len() {
                rows[row][i] += (rows[row][i] - rows[row - 1][i]) / factor;
            }
        }
    }
    rows.pop().expect("rows")
}

fn unit(count: usize, index: usize) -> Vec<f64> {
    (0..count)
        .map(|i| if i == index { 1.0 } else { 0.0 })
        .collect()
}

impl ByHand<'_> {
    fn slopes(&self, q: &[f64], direction: &[f64], t: f64) -> Slopes {
        let at = |step: f64| {
            let pairs = q.iter().zip(direction);
            let moved: Vec<f64> = pairs.map(|(q, d)| q + step * d).collect();
            let drawing = (self.draw)(&moved, t);
            let poses = drawing.masses.iter().flat_map(|mass| mass.pose);
            let stretches = drawing.springs.iter().map(|spring| spring.stretch);
            poses
                .chain(stretches)
                .chain([drawing.work])
                .collect::<Vec<f64>>()
        };
        let here = at(0.0);
        let (mut first, mut second) = (Vec::new(), Vec::new());
        for row in 0..4 {
            let h = STEP / f64::from(1 << row);
            let (ahead, behind) = (at(h), at(-h));
            let of = |f: &dyn Fn(usize) -> f64| (0..here.len()).map(f).collect::<Vec<f64>>();
            first.push(of(&|i| (ahead[i] - behind[i]) / (2.0 * h)));
            second.push(of(&|i| {
                ((ahead[i] - here[i]) - (here[i] - behind[i])) / (h * h)
            }));
        }
        Slopes {
            first: extrapolate(first),
            second: extrapolate(second),
        }
    }

    /// Slopes of all numbers by each coordinate.
    fn columns(&self, q: &[f64], t: f64) -> Vec<Vec<f64>> {
        let along = |index| self.slopes(q, &unit(q.len(), index), t).first;
        (0..q.len()).map(along).collect()
    }

    /// Accelerations of all numbers where the coordinates have constant rates.
    fn bend(&self, q: &[f64], rates: &[f64], t: f64) -> Vec<f64> {
        let speed = rates.iter().fold(0.0f64, |m, rate| m.max(rate.abs()));
        let per = if speed > 0.0 { 1.0 / speed } else { 0.0 };
        let direction: Vec<f64> = rates.iter().map(|rate| rate * per).collect();
        let second = self.slopes(q, &direction, t).second;
        second.into_iter().map(|s| s * speed * speed).collect()
    }

    fn weights(&self, q: &[f64], t: f64) -> Vec<f64> {
        let masses = (self.draw)(q, t).masses;
        masses
            .iter()
            .flat_map(|m| [m.mass, m.mass, m.inertia])
            .collect()
    }

    /// Matrix of inertia.
    pub fn inertia(&self, q: &[f64], t: f64) -> DMatrix<f64> {
        let (columns, weights) = (self.columns(q, t), self.weights(q, t));
        DMatrix::from_fn(q.len(), q.len(), |i, j| {
            let each = weights.iter().enumerate();
            each.map(|(n, w)| w * columns[i][n] * columns[j][n]).sum()
        })
    }

    /// Potential energy of springs, stacks and gravity.
    pub fn potential(&self, q: &[f64], t: f64) -> f64 {
        let drawing = (self.draw)(q, t);
        let springs = drawing.springs.iter();
        let stored: f64 = springs
            .map(|s| 0.5 * s.stiffness * (s.stretch - s.free).powi(2))
            .sum();
        let masses = drawing.masses.iter();
        let height: f64 = masses.map(|m| m.mass * self.gravity * m.pose[1]).sum();
        stored + height
    }

    /// Generalised forces of springs, dampers, gravity, loads, and of inertia at these rates; with
    /// each the sum of its terms' magnitudes.
    pub fn forces(&self, q: &[f64], rates: &[f64], t: f64) -> (DVector<f64>, DVector<f64>) {
        let (columns, weights) = (self.columns(q, t), self.weights(q, t));
        let drawing = (self.draw)(q, t);
        let bend = self.bend(q, rates, t);
        let springs = drawing.springs.len();
        let push = |n: usize| -> f64 {
            if n < weights.len() {
                let fall = if n % 3 == 1 { self.gravity } else { 0.0 };
                return -weights[n] * (bend[n] + fall);
            }
            let Some(spring) = drawing.springs.get(n - weights.len()) else {
                return 1.0; // the work
            };
            let rate: f64 = columns.iter().zip(rates).map(|(c, v)| c[n] * v).sum();
            -spring.stiffness * (spring.stretch - spring.free)
                - spring.damping * (rate - spring.free_rate)
        };
        let pushes: Vec<f64> = (0..weights.len() + springs + 1).map(push).collect();
        let terms = |i: usize| columns[i].iter().zip(&pushes).map(|(c, p)| c * p);
        (
            DVector::from_fn(q.len(), |i, _| terms(i).sum()),
            DVector::from_fn(q.len(), |i, _| terms(i).map(f64::abs).sum()),
        )
    }

    /// By how much accelerations miss the balance of inertia and forces, as a part of its terms.
    pub fn imbalance(&self, q: &[f64], rates: &[f64], t: f64, accelerations: &[f64]) -> f64 {
        let (forces, magnitudes) = self.forces(q, rates, t);
        let inertia = self.inertia(q, t) * DVector::from_column_slice(accelerations);
        let each = (inertia - forces).component_div(&magnitudes);
        each.amax()
    }

    /// Matrix of the potential's second derivatives.
    fn stiffness(&self, q: &[f64], t: f64) -> DMatrix<f64> {
        let count = q.len();
        let rest = vec![0.0; count];
        let mut rows: Vec<Vec<f64>> = Vec::new();
        for row in 0..4 {
            let h = STEP / f64::from(1 << row);
            let force = |index: usize, step: f64| {
                let mut moved = q.to_vec();
                moved[index] += step;
                self.forces(&moved, &rest, t).0
            };
            let column = |j: usize| (force(j, -h) - force(j, h)) / (2.0 * h);
            rows.push(
                (0..count)
                    .flat_map(|j| column(j).as_slice().to_vec())
                    .collect(),
            );
        }
        let slopes = DMatrix::from_vec(count, count, extrapolate(rows));
        0.5 * (&slopes + slopes.transpose())
    }

    /// Where all forces balance, from a configuration nearby.
    pub fn equilibrium(&self, near: &[f64], t: f64) -> Vec<f64> {
        let rest = vec![0.0; near.len()];
        let mut q = DVector::from_column_slice(near);
        for _ in 0..20 {
            let stiffness = self.stiffness(q.as_slice(), t);
            let (forces, _) = self.forces(q.as_slice(), &rest, t);
            q += stiffness.lu().solve(&forces).expect("a stiff mechanism");
        }
        q.as_slice().to_vec()
    }

    /// Natural frequencies in rad/s, undamped, about an equilibrium, lowest first.
    pub fn frequencies(&self, q: &[f64], t: f64) -> Vec<f64> {
        let lower = self
            .inertia(q, t)
            .cholesky()
            .expect("inertia is positive")
            .l();
        let inverse = lower.try_inverse().expect("inertia is positive");
        let scaled = &inverse * self.stiffness(q, t) * inverse.transpose();
        let mut found: Vec<f64> = scaled.symmetric_eigenvalues().iter().copied().collect();
        found.sort_by(f64::total_cmp);
        found.into_iter().map(f64::sqrt).collect()
    }
}
