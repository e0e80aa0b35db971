//! Modes: eigenvalues of the state matrix, in coordinates in which the inertia is the unit matrix.

use nalgebra::{Cholesky, Complex, DMatrix, DVector};

use super::linear::Linear;

/// Damping of a free direction, as a share of all damping, that is rounding.
const UNDAMPED: f64 = 1e-12;

/// A motion e^{st} of the linear model.
#[derive(Clone, Debug, PartialEq)]
pub struct Mode {
    /// s in rad/s; of a pair the one with a positive imaginary part. Zero for a free motion.
    pub eigenvalue: Complex<f64>,
    /// Deviation of each coordinate, the largest share of the kinetic energy with phase zero;
    /// scaled so that the amplitudes of all sum up to a kinetic energy of 1 J per (rad/s)².
    pub shape: Vec<Complex<f64>>,
    /// Share of each coordinate in the kinetic energy; they sum up to 1.
    pub shares: Vec<f64>,
    /// Whether nothing elastic brings it back: its frequency is zero.
    pub is_free: bool,
}

impl Mode {
    /// Natural frequency |s|/2π in Hz.
    pub fn frequency(&self) -> f64 {
        self.eigenvalue.norm() / std::f64::consts::TAU
    }

    /// Damping ratio -Re s/|s|: 1 where it creeps back without swinging, negative where it grows.
    pub fn damping(&self) -> f64 {
        if self.is_free {
            return 0.0;
        }
        -self.eigenvalue.re / self.eigenvalue.norm()
    }
}

pub(super) fn modes(linear: &Linear) -> Vec<Mode> {
    let n = linear.inertia.nrows();
    let Some(basis) = Basis::new(linear) else {
        return Vec::new();
    };
    let k = linear.free.ncols();
    let slopes = DMatrix::from_fn(n, n, |i, j| linear.a[(2 * i + 1, 2 * j + 1)]);
    let damping = basis.reduced(&-(&linear.inertia * slopes));
    let stiffness = basis.reduced(&linear.stiffness);
    let unit = stiffness.norm().sqrt().max(damping.norm());
    let mut modes: Vec<Mode> = (n - k..n)
        .map(|j| basis.mode_of(linear, None, unit_vector(n, j)))
        .collect();
    if unit == 0.0 {
        return modes;
    }
    // Positions along free directions act on nothing, nor do rates that nothing damps.
    let loose = (n - k..n).filter(|&j| damping.column(j).norm() <= UNDAMPED * damping.norm());
    let loose: Vec<usize> = loose.collect();
    let kept: Vec<usize> = (0..n - k)
        .chain((n..2 * n).filter(|j| !loose.contains(&(j - n))))
        .collect();
    let entry = |i: usize, j: usize| match (i < n, j < n) {
        (true, true) => 0.0,
        (true, false) => f64::from(i + n == j),
        (false, true) => -stiffness[(i - n, j)] / (unit * unit),
        (false, false) => -damping[(i - n, j - n)] / unit,
    };
    let m = kept.len();
    let matrix = DMatrix::from_fn(m, m, |i, j| entry(kept[i], kept[j]));
    let mut values: Vec<Complex<f64>> = matrix.complex_eigenvalues().iter().copied().collect();
    values.retain(|value| value.im >= 0.0);
    values.sort_by(|a, b| a.norm().total_cmp(&b.norm()).then(a.re.total_cmp(&b.re)));
    let mut repeated = 0;
    for (index, &value) in values.iter().enumerate() {
        let is_same = index > 0 && (value - values[index - 1]).norm() < 1e-9 * value.norm();
        repeated = if is_same { repeated + 1 } else { 0 };
        let vector = null_vector(&matrix, value, repeated);
        let mut shape = DVector::from_element(n, Complex::from(0.0));
        for (position, &state) in kept.iter().enumerate() {
            // A free direction moves by its rate over s.
            if state < n {
                shape[state] = vector[position];
            } else if state - n >= n - k {
                shape[state - n] = vector[position] / value;
            }
        }
        modes.push(basis.mode_of(linear, Some(value * unit), shape));
    }
    modes
}

fn unit_vector(n: usize, index: usize) -> DVector<Complex<f64>> {
    DVector::from_fn(n, |i, _| Complex::from(f64::from(i == index)))
}

/// The vector that A - s shortens most, or the next but `repeated`.
fn null_vector(a: &DMatrix<f64>, s: Complex<f64>, repeated: usize) -> DVector<Complex<f64>> {
    let m = a.nrows();
    let shifted = DMatrix::from_fn(m, m, |i, j| {
        let own = if i == j { s } else { Complex::from(0.0) };
        Complex::from(a[(i, j)]) - own
    });
    let svd = shifted.svd(false, true);
    let mut order: Vec<usize> = (0..m).collect();
    order.sort_by(|&i, &j| svd.singular_values[i].total_cmp(&svd.singular_values[j]));
    match svd.v_t {
        Some(v) => v.row(order[repeated.min(m - 1)]).adjoint(),
        None => DVector::from_element(m, Complex::from(0.0)),
    }
}

/// Coordinates in which the inertia is the unit matrix and free directions come last.
struct Basis {
    /// Columns: the new coordinates in terms of the old.
    columns: DMatrix<f64>,
}

impl Basis {
    fn new(linear: &Linear) -> Option<Self> {
        let n = linear.inertia.nrows();
        let symmetric = 0.5 * (&linear.inertia + linear.inertia.transpose());
        let l = Cholesky::new(symmetric)?.l();
        let free = l.transpose() * &linear.free;
        // Free directions first, then what is across to them: Gram–Schmidt twice over.
        let mut all: Vec<DVector<f64>> = Vec::new();
        let candidates = free.column_iter().map(|c| c / c.norm());
        let axes = (0..n).map(|i| DVector::from_fn(n, |j, _| f64::from(i == j)));
        for candidate in candidates.chain(axes) {
            let mut across = candidate.clone_owned();
            for _ in 0..2 {
                for known in &all {
                    across -= known.dot(&across) * known;
                }
            }
            let length = across.norm();
            let is_free = all.len() < free.ncols();
            if all.len() < n && (is_free || length > 1e-3) {
                all.push(across / length);
            }
        }
        if all.len() < n {
            return None;
        }
        all.rotate_left(free.ncols());
        let columns = l
            .transpose()
            .solve_upper_triangular(&DMatrix::from_columns(&all))?;
        Some(Self { columns })
    }

    fn reduced(&self, matrix: &DMatrix<f64>) -> DMatrix<f64> {
        self.columns.transpose() * matrix * &self.columns
    }

    fn mode_of(
        &self,
        linear: &Linear,
        eigenvalue: Option<Complex<f64>>,
        shape: DVector<Complex<f64>>,
    ) -> Mode {
        let shape = self.columns.map(Complex::from) * shape;
        let pushed = linear.inertia.map(Complex::from) * &shape;
        let energies = shape.zip_map(&pushed, |q, p| (q.conj() * p).re);
        let total = energies.sum();
        let most = energies.iamax();
        let turn = shape[most].conj() / shape[most].norm();
        let scale = turn * (2.0 / total).sqrt();
        Mode {
            eigenvalue: eigenvalue.unwrap_or_default(),
            shape: shape.iter().map(|q| q * scale).collect(),
            shares: energies.iter().map(|energy| energy / total).collect(),
            is_free: eigenvalue.is_none(),
        }
    }
}
