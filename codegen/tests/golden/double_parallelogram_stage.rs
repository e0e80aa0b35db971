/// Simulator of the model `double_parallelogram_stage`, generated from its equations of motion.
///
/// A stage that hangs by two leaf springs from a frame that stands on two others: the stage's travel
/// is straight to second order, because what the frame sinks the stage rises.
///
/// Leaves are pseudo-rigid links with a torsion spring at either end.
#[allow(
    non_snake_case,
    non_upper_case_globals,
    unused,
    clippy::all,
    clippy::pedantic,
    rustdoc::all
)]
pub mod double_parallelogram_stage {
    use std::borrow::Cow;
    use ::flexure_runtime::checks::{check_params, check_start};
    use ::flexure_runtime::diagnostic::{Diagnostic, Site};
    use ::flexure_runtime::failure::{Failure, Unit};
    use ::flexure_runtime::generated::{array, array_mut};
    use ::flexure_runtime::lanes::{LaneSystem, Lanes};
    use ::flexure_runtime::newton;
    use ::flexure_runtime::real::Real;
    use ::flexure_runtime::simulate::PlainSteps;
    use ::flexure_runtime::system::{Causality, Energy, EventAction, System, Variable};
    use ::flexure_runtime::table::{Curve, CurveReport, Table, TableReport};
    /// What may be set: all in SI units, angles in rad.
    #[derive(Clone, Debug, PartialEq)]
    pub struct Params {
        /// elastic modulus in Pa; 7.2e10 by default
        pub E: f64,
        /// length, width and thickness of a leaf in m; 0.04 by default
        pub L: f64,
        /// length, width and thickness of a leaf in m; 0.01 by default
        pub b: f64,
        /// length, width and thickness of a leaf in m; 0.0005 by default
        pub h: f64,
        /// between the outer leaves, between the inner ones in m; 0.07 by default
        pub outer: f64,
        /// between the outer leaves, between the inner ones in m; 0.04 by default
        pub inner: f64,
        /// mass of a leaf, of the frame, of the stage in kg; 0.00054 by default
        pub ml: f64,
        /// mass of a leaf, of the frame, of the stage in kg; 0.025 by default
        pub mf: f64,
        /// mass of a leaf, of the frame, of the stage in kg; 0.06 by default
        pub ms: f64,
        /// force on the stage in N; 1.0 by default
        pub push: f64,
        /// force on the stage in 1/s; 8.0 by default
        pub f: f64,
    }
    impl Default for Params {
        fn default() -> Self {
            Self {
                E: 7.2e10,
                L: 0.04,
                b: 0.01,
                h: 0.0005,
                outer: 0.07,
                inner: 0.04,
                ml: 0.00054,
                mf: 0.025,
                ms: 0.06,
                push: 1.0,
                f: 8.0,
            }
        }
    }
    impl Params {
        /// The values in the order of [`VARIABLES`].
        pub fn values(&self) -> [f64; 11] {
            [
                self.E,
                self.L,
                self.b,
                self.h,
                self.outer,
                self.inner,
                self.ml,
                self.mf,
                self.ms,
                self.push,
                self.f,
            ]
        }
        /// Params of values in the order of [`VARIABLES`].
        pub fn from_values(values: [f64; 11]) -> Self {
            Self {
                E: values[0],
                L: values[1],
                b: values[2],
                h: values[3],
                outer: values[4],
                inner: values[5],
                ml: values[6],
                mf: values[7],
                ms: values[8],
                push: values[9],
                f: values[10],
            }
        }
        /// Closes the loops and computes everything that depends on params alone.
        ///
        /// # Errors
        /// What is wrong with the parameter set, in the words of `flexure check`.
        pub fn prepare(&self) -> Result<Prepared<f64>, Diagnostic> {
            check_params(PARAMS, &self.values())?;
            let E = self.E;
            let L = self.L;
            let b = self.b;
            let h = self.h;
            let outer = self.outer;
            let inner = self.inner;
            let ml = self.ml;
            let mf = self.mf;
            let ms = self.ms;
            let push = self.push;
            let f = self.f;
            // length of a pseudo-rigid link
            let l = L * 0.8517;
            let l_squared = l * l;
            let l_squared_ml = l_squared * ml;
            // moment of inertia about the centre of mass of left
            let I1 = l_squared_ml * 0.08333333333333333;
            // moment of inertia about the centre of mass of frame
            let I_frame = outer * outer * mf * 0.08333333333333333;
            // moment of inertia about the centre of mass of stage
            let I_stage = inner * inner * ms * 0.08333333333333333;
            let two_I1 = I1 * 2.0;
            // distance of the centre of mass from the first end of left
            let r1 = l * 0.5;
            let two_ml_r1_squared = ml * (r1 * r1) * 2.0;
            let l_squared_ms = l_squared * ms;
            // constant of the inertia
            let C0 = l_squared_ml * 2.0 + two_I1 + two_ml_r1_squared + l_squared * mf
                + l_squared_ms;
            // inertia as assembled
            let A_inner_left_0 = l_squared_ml * 0.6666666666666666 + l_squared_ms;
            // constant of the inertia
            let C1 = two_I1 + two_ml_r1_squared + l_squared_ms;
            // constant of the inertia
            let C2 = l * ml * r1 * 4.0 + l_squared_ms * 2.0;
            // second moment of area
            let I = b * (h * (h * h)) * 0.08333333333333333;
            // stiffness at either end of a leaf
            let k = E * I * 4.51401 / L;
            let ddP_s_dφ1_dφ1 = k * 4.0;
            let margin = (outer - inner) * 0.5;
            if !(l > 0.0) {
                return Err(FAILURES[0].diagnostic(&[l]));
            }
            if !(ml >= 0.0) {
                return Err(FAILURES[1].diagnostic(&[ml]));
            }
            if !(I1 >= 0.0) {
                return Err(FAILURES[2].diagnostic(&[I1]));
            }
            if !(outer > 0.0) {
                return Err(FAILURES[3].diagnostic(&[outer]));
            }
            if !(mf >= 0.0) {
                return Err(FAILURES[4].diagnostic(&[mf]));
            }
            if !(I_frame >= 0.0) {
                return Err(FAILURES[5].diagnostic(&[I_frame]));
            }
            if !(inner > 0.0) {
                return Err(FAILURES[6].diagnostic(&[inner]));
            }
            if !(ms >= 0.0) {
                return Err(FAILURES[7].diagnostic(&[ms]));
            }
            if !(I_stage >= 0.0) {
                return Err(FAILURES[8].diagnostic(&[I_stage]));
            }
            if !(C0 > 0.0) {
                return Err(FAILURES[9].diagnostic(&[]));
            }
            if !(A_inner_left_0 > 0.0) {
                return Err(FAILURES[10].diagnostic(&[]));
            }
            let prepared = Prepared {
                start_states: [1.5707963267948966, 0.0, -1.5707963267948966, 0.0],
                start_discretes: [],
                push,
                l,
                C0,
                C1,
                half_C2: C2 * 0.5,
                C0_C1: C0 * C1,
                k,
                ddP_s_dφ1_dφ1,
                constant1: f * 6.283185307179586,
                l_push: l * push,
                margin,
                half_C0: C0 * 0.5,
                half_C1: C1 * 0.5,
                two_k: k * 2.0,
            };
            check_start(prepared.states(), &prepared.start_states)?;
            check_start(prepared.discretes(), &prepared.start_discretes)?;
            Ok(prepared)
        }
    }
    /// Everything that depends on params alone, as the functions of this module need it.
    #[derive(Clone, Debug)]
    pub struct Prepared<T> {
        /// Continuous state at the start.
        pub start_states: [T; 4],
        /// Discrete state at the start.
        pub start_discretes: [T; 0],
        /// `push`
        pub push: T,
        /// `l` length of a pseudo-rigid link
        pub l: T,
        /// `C0` constant of the inertia
        pub C0: T,
        /// `C1` constant of the inertia
        pub C1: T,
        /// `0.5 * C2`
        pub half_C2: T,
        /// `C0 * C1`
        pub C0_C1: T,
        /// `k` stiffness at either end of a leaf
        pub k: T,
        /// `∂∂P_s/∂φ1/∂φ1`
        pub ddP_s_dφ1_dφ1: T,
        /// `6.283185307179586 * f`
        pub constant1: T,
        /// `l * push`
        pub l_push: T,
        /// `margin`
        pub margin: T,
        /// `0.5 * C0`
        pub half_C0: T,
        /// `0.5 * C1`
        pub half_C1: T,
        /// `2.0 * k`
        pub two_k: T,
    }
    impl<T: Copy> Prepared<T> {
        /// The same with every number turned into another, without curves: for dual numbers or lanes.
        pub fn map<U>(&self, turn: impl Fn(T) -> U) -> Prepared<U> {
            Prepared {
                start_states: self.start_states.map(&turn),
                start_discretes: self.start_discretes.map(&turn),
                push: turn(self.push),
                l: turn(self.l),
                C0: turn(self.C0),
                C1: turn(self.C1),
                half_C2: turn(self.half_C2),
                C0_C1: turn(self.C0_C1),
                k: turn(self.k),
                ddP_s_dφ1_dφ1: turn(self.ddP_s_dφ1_dφ1),
                constant1: turn(self.constant1),
                l_push: turn(self.l_push),
                margin: turn(self.margin),
                half_C0: turn(self.half_C0),
                half_C1: turn(self.half_C1),
                two_k: turn(self.two_k),
            }
        }
        /// Every number joined with the one that stands in its place in `other`.
        pub fn zip<U: Copy, V>(
            &self,
            other: &Prepared<U>,
            join: impl Fn(T, U) -> V,
        ) -> Prepared<V> {
            Prepared {
                start_states: std::array::from_fn(|i| {
                    join(self.start_states[i], other.start_states[i])
                }),
                start_discretes: std::array::from_fn(|i| {
                    join(self.start_discretes[i], other.start_discretes[i])
                }),
                push: join(self.push, other.push),
                l: join(self.l, other.l),
                C0: join(self.C0, other.C0),
                C1: join(self.C1, other.C1),
                half_C2: join(self.half_C2, other.half_C2),
                C0_C1: join(self.C0_C1, other.C0_C1),
                k: join(self.k, other.k),
                ddP_s_dφ1_dφ1: join(self.ddP_s_dφ1_dφ1, other.ddP_s_dφ1_dφ1),
                constant1: join(self.constant1, other.constant1),
                l_push: join(self.l_push, other.l_push),
                margin: join(self.margin, other.margin),
                half_C0: join(self.half_C0, other.half_C0),
                half_C1: join(self.half_C1, other.half_C1),
                two_k: join(self.two_k, other.two_k),
            }
        }
    }
    impl Prepared<f64> {
        /// The same without tables and curves: closed forms everywhere.
        pub fn exact(self) -> Self {
            self
        }
    }
    /// dx/dt. Where a loop cannot close, entries are not numbers.
    #[inline(always)]
    pub fn rhs<T: Real>(
        t: T,
        x: &[T; 4],
        d: &[T; 0],
        u: &[T; 0],
        p: &Prepared<T>,
        dx: &mut [T; 4],
    ) {
        let φ1 = x[0];
        let dφ1 = x[1];
        let φ2 = x[2];
        let dφ2 = x[3];
        // ── configuration ──
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let (sin_φ2, cos_φ2) = φ2.sin_cos();
        let cos_φ1_minus_φ2 = cos_φ1 * cos_φ2 + sin_φ1 * sin_φ2;
        // inertia
        let M12 = p.half_C2 * cos_φ1_minus_φ2;
        // determinant of the inertia
        let det_M = p.C0_C1 - M12 * M12;
        let per_det_M = det_M.recip();
        // slope of the potential energy of springs
        let dP_s_dφ1 = p.ddP_s_dφ1_dφ1 * (φ1 - 1.5707963267948966);
        let sin_φ1_minus_φ2 = sin_φ1 * cos_φ2 - cos_φ1 * sin_φ2;
        // slope of the inertia
        let dM12_dφ2 = p.half_C2 * sin_φ1_minus_φ2;
        // slope of the potential energy of springs
        let dP_s_dφ2 = p.ddP_s_dφ1_dφ1 * (φ2 + 1.5707963267948966);
        // slope of the inertia
        let dM12_dφ1 = -dM12_dφ2;
        // ── state ──
        let t1 = (p.constant1 * t).sin();
        // centrifugal and Coriolis terms
        let h1 = dM12_dφ2 * (dφ2 * dφ2);
        let t2 = dP_s_dφ1.plus_product(p.l_push * sin_φ1, t1) + h1;
        // centrifugal and Coriolis terms
        let h2 = dM12_dφ1 * (dφ1 * dφ1);
        let t3 = dP_s_dφ2.plus_product(p.l_push * sin_φ2, t1) + h2;
        let ddφ1 = -(per_det_M * (p.C1 * t2).minus_product(M12, t3));
        let ddφ2 = -(per_det_M * (p.C0 * t3).minus_product(M12, t2));
        dx[0] = dφ1;
        dx[1] = ddφ1;
        dx[2] = dφ2;
        dx[3] = ddφ2;
    }
    /// ∂(dx/dt)/∂x, row by row; entries that are always zero are left as they are.
    #[inline(always)]
    pub fn jacobian<T: Real>(
        t: T,
        x: &[T; 4],
        d: &[T; 0],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 16],
    ) {
        let φ1 = x[0];
        let dφ1 = x[1];
        let φ2 = x[2];
        let dφ2 = x[3];
        // ── configuration ──
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let (sin_φ2, cos_φ2) = φ2.sin_cos();
        let cos_φ1_minus_φ2 = cos_φ1 * cos_φ2 + sin_φ1 * sin_φ2;
        // inertia
        let M12 = p.half_C2 * cos_φ1_minus_φ2;
        // determinant of the inertia
        let det_M = p.C0_C1 - M12 * M12;
        let per_det_M_squared = (det_M * det_M).recip();
        let sin_φ1_minus_φ2 = sin_φ1 * cos_φ2 - cos_φ1 * sin_φ2;
        // slope of the inertia
        let dM12_dφ2 = p.half_C2 * sin_φ1_minus_φ2;
        // slope of the inertia
        let dM12_dφ1 = -dM12_dφ2;
        let ddet_M_dφ1 = -(M12 * dM12_dφ1 * 2.0);
        let t1 = per_det_M_squared * ddet_M_dφ1;
        // slope of the potential energy of springs
        let dP_s_dφ1 = p.ddP_s_dφ1_dφ1 * (φ1 - 1.5707963267948966);
        // slope of the potential energy of springs
        let dP_s_dφ2 = p.ddP_s_dφ1_dφ1 * (φ2 + 1.5707963267948966);
        let per_det_M = det_M.recip();
        let ddM12_dφ1_dφ1 = -M12;
        let M12_per_det_M = M12 * per_det_M;
        let ddet_M_dφ2 = -(M12 * dM12_dφ2 * 2.0);
        let t2 = per_det_M_squared * ddet_M_dφ2;
        // ── state ──
        let t3 = (p.constant1 * t).sin();
        let dφ2_squared = dφ2 * dφ2;
        // centrifugal and Coriolis terms
        let h1 = dM12_dφ2 * dφ2_squared;
        let t4 = dP_s_dφ1 + p.l_push * sin_φ1 * t3 + h1;
        let dφ1_squared = dφ1 * dφ1;
        // centrifugal and Coriolis terms
        let h2 = dM12_dφ1 * dφ1_squared;
        let t5 = dP_s_dφ2 + p.l_push * sin_φ2 * t3 + h2;
        let t6 = p.C1 * t4 - M12 * t5;
        let dh1_dφ1 = M12 * dφ2_squared;
        let t7 = p.ddP_s_dφ1_dφ1 + p.l_push * cos_φ1 * t3 + dh1_dφ1;
        let dh2_dφ1 = ddM12_dφ1_dφ1 * dφ1_squared;
        let dddφ1_dφ1 = t1 * t6
            + per_det_M * (dM12_dφ1 * t5 - p.C1 * t7 + M12 * dh2_dφ1);
        let dh2_ddφ1 = dM12_dφ1 * 2.0 * dφ1;
        let dddφ1_ddφ1 = M12_per_det_M * dh2_ddφ1;
        let dh1_dφ2 = ddM12_dφ1_dφ1 * dφ2_squared;
        let dh2_dφ2 = M12 * dφ1_squared;
        let t8 = p.ddP_s_dφ1_dφ1 + p.l_push * cos_φ2 * t3 + dh2_dφ2;
        let dddφ1_dφ2 = t2 * t6
            + per_det_M * (dM12_dφ2 * t5 - p.C1 * dh1_dφ2 + M12 * t8);
        let dh1_ddφ2 = dM12_dφ2 * 2.0 * dφ2;
        let dddφ1_ddφ2 = -(p.C1 * per_det_M * dh1_ddφ2);
        let t9 = p.C0 * t5 - M12 * t4;
        let dddφ2_dφ1 = t1 * t9
            + per_det_M * (dM12_dφ1 * t4 - p.C0 * dh2_dφ1 + M12 * t7);
        let dddφ2_ddφ1 = -(p.C0 * per_det_M * dh2_ddφ1);
        let dddφ2_dφ2 = t2 * t9
            + per_det_M * (dM12_dφ2 * t4 - p.C0 * t8 + M12 * dh1_dφ2);
        let dddφ2_ddφ2 = M12_per_det_M * dh1_ddφ2;
        result[1] = T::from_f64(1.0);
        result[4] = dddφ1_dφ1;
        result[5] = dddφ1_ddφ1;
        result[6] = dddφ1_dφ2;
        result[7] = dddφ1_ddφ2;
        result[11] = T::from_f64(1.0);
        result[12] = dddφ2_dφ1;
        result[13] = dddφ2_ddφ1;
        result[14] = dddφ2_dφ2;
        result[15] = dddφ2_ddφ2;
    }
    /// The model's outputs.
    #[inline(always)]
    pub fn outputs<T: Real>(
        t: T,
        x: &[T; 4],
        d: &[T; 0],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 2],
    ) {
        let φ1 = x[0];
        let φ2 = x[2];
        // ── configuration ──
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let (sin_φ2, cos_φ2) = φ2.sin_cos();
        let P1_x = p.margin + p.l * cos_φ1 + p.l * cos_φ2;
        let P1_y = p.l * sin_φ1 + p.l * sin_φ2;
        result[0] = P1_x;
        result[1] = P1_y;
    }
    /// Kinetic and potential energy in J, dissipated and supplied power in W.
    #[inline(always)]
    pub fn energy<T: Real>(
        t: T,
        x: &[T; 4],
        d: &[T; 0],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let φ1 = x[0];
        let dφ1 = x[1];
        let φ2 = x[2];
        let dφ2 = x[3];
        // ── configuration ──
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let (sin_φ2, cos_φ2) = φ2.sin_cos();
        let cos_φ1_minus_φ2 = cos_φ1 * cos_φ2 + sin_φ1 * sin_φ2;
        // inertia
        let M12 = p.half_C2 * cos_φ1_minus_φ2;
        let t1 = φ1 - 1.5707963267948966;
        let t2 = T::from_f64(1.5707963267948966) - φ1;
        let t3 = φ2 + 1.5707963267948966;
        // ── state ──
        let t4 = p.half_C0 * (dφ1 * dφ1) + p.half_C1 * (dφ2 * dφ2)
            + M12 * (dφ1 * dφ2);
        let t5 = (p.constant1 * t).sin() * (p.l * sin_φ1 * dφ1 + p.l * sin_φ2 * dφ2);
        result[0] = t4;
        result[1] = p.k * (t1 * t1) + p.k * (t2 * t2) + p.two_k * (t3 * t3);
        result[2] = T::from_f64(0.0);
        result[3] = -(p.push * t5);
    }
    /// Event functions: each event happens where its function rises through zero.
    #[inline(always)]
    pub fn events<T: Real>(
        t: T,
        x: &[T; 4],
        d: &[T; 0],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 0],
    ) {}
    /// For each loop a number that is positive where it closes and zero at a dead point.
    #[inline(always)]
    pub fn closures<T: Real>(
        t: T,
        x: &[T; 4],
        d: &[T; 0],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 0],
    ) {}
    /// The discrete state after an accepted step that ends in `x`; entries that stay are left as they are.
    #[inline(always)]
    pub fn accept<T: Real>(
        t: T,
        x: &[T; 4],
        d: &[T; 0],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 0],
    ) {}
    /// Time in s of each drive's next kink.
    #[inline(always)]
    pub fn next_kinks<T: Real>(d: &[T; 0], p: &Prepared<T>, result: &mut [T; 0]) {}
    /// The discrete state after drive `index` passed its kink; entries that stay are left as they are.
    #[inline(always)]
    pub fn pass_kink<T: Real>(
        index: usize,
        d: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 0],
    ) {}
    /// The state after event `index`; entries that stay are left as they are.
    #[inline(always)]
    pub fn pass_event<T: Real>(
        index: usize,
        t: T,
        x: &[T; 4],
        d: &[T; 0],
        u: &[T; 0],
        p: &Prepared<T>,
        x_after: &mut [T; 4],
        d_after: &mut [T; 0],
    ) {}
    impl System for Prepared<f64> {
        fn states(&self) -> &[Variable] {
            STATES
        }
        fn discretes(&self) -> &[Variable] {
            DISCRETES
        }
        fn inputs(&self) -> &[Variable] {
            INPUTS
        }
        fn output_variables(&self) -> &[Variable] {
            OUTPUTS
        }
        fn start(&self, x: &mut [f64], d: &mut [f64]) {
            x.copy_from_slice(&self.start_states);
            d.copy_from_slice(&self.start_discretes);
        }
        #[inline]
        fn rhs(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], dx: &mut [f64]) {
            rhs(t, array(x), array(d), array(u), self, array_mut(dx));
        }
        fn jacobian(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], result: &mut [f64]) {
            result.fill(0.0);
            jacobian(t, array(x), array(d), array(u), self, array_mut(result));
        }
        fn outputs(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], result: &mut [f64]) {
            outputs(t, array(x), array(d), array(u), self, array_mut(result));
        }
        fn energy(&self, t: f64, x: &[f64], d: &[f64], u: &[f64]) -> Energy {
            let mut result = [0.0; 4];
            energy(t, array(x), array(d), array(u), self, &mut result);
            let [kinetic, potential, dissipated_power, supplied_power] = result;
            Energy {
                kinetic,
                potential,
                dissipated_power,
                supplied_power,
            }
        }
        fn kink_count(&self) -> usize {
            0
        }
        fn next_kinks(&self, d: &[f64], times: &mut [f64]) {
            next_kinks(array(d), self, array_mut(times));
        }
        fn pass_kink(&self, index: usize, d: &mut [f64]) {
            let before = *array(d);
            pass_kink(index, &before, self, array_mut(d));
        }
        fn event_count(&self) -> usize {
            0
        }
        fn events(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], values: &mut [f64]) {
            events(t, array(x), array(d), array(u), self, array_mut(values));
        }
        fn event_name(&self, index: usize) -> &str {
            const NAMES: [&str; 0] = [];
            NAMES[index]
        }
        fn pass_event(
            &self,
            index: usize,
            t: f64,
            x: &mut [f64],
            d: &mut [f64],
            u: &[f64],
        ) -> EventAction {
            let (x_before, d_before) = (*array(x), *array(d));
            let (x, d) = (array_mut(x), array_mut(d));
            pass_event(index, t, &x_before, &d_before, array(u), self, x, d);
            match index {
                _ => EventAction::Continue,
            }
        }
        fn accept(&self, t: f64, x: &[f64], u: &[f64], d: &mut [f64]) {
            let before = *array(d);
            accept(t, array(x), &before, array(u), self, array_mut(d));
        }
        fn turning(&self) -> &[usize] {
            &TURNING
        }
        fn loop_count(&self) -> usize {
            0
        }
        fn closures(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], values: &mut [f64]) {
            closures(t, array(x), array(d), array(u), self, array_mut(values));
        }
        fn loop_name(&self, index: usize) -> &str {
            const NAMES: [&str; 0] = [];
            NAMES[index]
        }
        fn take_plain_steps(&self, steps: &mut PlainSteps<'_>) {
            steps.on_lanes(self);
        }
    }
    impl LaneSystem for Prepared<f64> {
        type InLanes<L: Lanes> = Prepared<L>;
        type States<L: Lanes> = [L; 4];
        type Discretes<L: Lanes> = [L; 0];
        type Loops<L: Lanes> = [L; 0];
        type Events<L: Lanes> = [L; 0];
        fn in_every_lane<L: Lanes>(&self) -> Prepared<L> {
            self.map(L::from_f64)
        }
        fn put_in_lane<L: Lanes>(&self, lane: usize, lanes: &mut Prepared<L>) {
            *lanes = lanes
                .zip(
                    self,
                    |mut number: L, value: f64| {
                        number.set_entry(lane, value);
                        number
                    },
                );
        }
        #[inline(always)]
        fn accept_in_lanes<L: Lanes>(
            lanes: &Prepared<L>,
            t: L,
            x: &[L],
            u: &[L],
            d: &mut [L],
        ) {
            let before = *array(d);
            accept(t, array(x), &before, array(u), lanes, array_mut(d));
        }
        #[inline(always)]
        fn rhs_in_lanes<L: Lanes>(
            lanes: &Prepared<L>,
            t: L,
            x: &[L],
            d: &[L],
            u: &[L],
            result: &mut [L],
        ) {
            rhs(t, array(x), array(d), array(u), lanes, array_mut(result));
        }
        #[inline(always)]
        fn events_in_lanes<L: Lanes>(
            lanes: &Prepared<L>,
            t: L,
            x: &[L],
            d: &[L],
            u: &[L],
            result: &mut [L],
        ) {
            events(t, array(x), array(d), array(u), lanes, array_mut(result));
        }
        #[inline(always)]
        fn closures_in_lanes<L: Lanes>(
            lanes: &Prepared<L>,
            t: L,
            x: &[L],
            d: &[L],
            u: &[L],
            result: &mut [L],
        ) {
            closures(t, array(x), array(d), array(u), lanes, array_mut(result));
        }
    }
    /// Every quantity with a name: params, states, discrete states, inputs, outputs.
    pub static VARIABLES: [Variable; 17] = [
        Variable {
            name: Cow::Borrowed("E"),
            unit: Cow::Borrowed("Pa"),
            meaning: Cow::Borrowed("elastic modulus"),
            causality: Causality::Parameter,
            start: Some(7.2e10),
        },
        Variable {
            name: Cow::Borrowed("L"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length, width and thickness of a leaf"),
            causality: Causality::Parameter,
            start: Some(0.04),
        },
        Variable {
            name: Cow::Borrowed("b"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length, width and thickness of a leaf"),
            causality: Causality::Parameter,
            start: Some(0.01),
        },
        Variable {
            name: Cow::Borrowed("h"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length, width and thickness of a leaf"),
            causality: Causality::Parameter,
            start: Some(0.0005),
        },
        Variable {
            name: Cow::Borrowed("outer"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("between the outer leaves, between the inner ones"),
            causality: Causality::Parameter,
            start: Some(0.07),
        },
        Variable {
            name: Cow::Borrowed("inner"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("between the outer leaves, between the inner ones"),
            causality: Causality::Parameter,
            start: Some(0.04),
        },
        Variable {
            name: Cow::Borrowed("ml"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of a leaf, of the frame, of the stage"),
            causality: Causality::Parameter,
            start: Some(0.00054),
        },
        Variable {
            name: Cow::Borrowed("mf"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of a leaf, of the frame, of the stage"),
            causality: Causality::Parameter,
            start: Some(0.025),
        },
        Variable {
            name: Cow::Borrowed("ms"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of a leaf, of the frame, of the stage"),
            causality: Causality::Parameter,
            start: Some(0.06),
        },
        Variable {
            name: Cow::Borrowed("push"),
            unit: Cow::Borrowed("N"),
            meaning: Cow::Borrowed("force on the stage"),
            causality: Causality::Parameter,
            start: Some(1.0),
        },
        Variable {
            name: Cow::Borrowed("f"),
            unit: Cow::Borrowed("1/s"),
            meaning: Cow::Borrowed("force on the stage"),
            causality: Causality::Parameter,
            start: Some(8.0),
        },
        Variable {
            name: Cow::Borrowed("left.angle"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("angle of `left`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("left.rate"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed("angular rate of `left`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("inner_left.angle"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("angle of `inner_left`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("inner_left.rate"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed("angular rate of `inner_left`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("x"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("position of the stage along its travel"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("y"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("its height"),
            causality: Causality::Output,
            start: None,
        },
    ];
    static PARAMS: &[Variable] = VARIABLES.split_at(0).1.split_at(11).0;
    static STATES: &[Variable] = VARIABLES.split_at(11).1.split_at(4).0;
    static DISCRETES: &[Variable] = VARIABLES.split_at(15).1.split_at(0).0;
    static INPUTS: &[Variable] = VARIABLES.split_at(15).1.split_at(0).0;
    static OUTPUTS: &[Variable] = VARIABLES.split_at(15).1.split_at(2).0;
    static TURNING: [usize; 0] = [];
    static FAILURES: [Failure; 11] = [
        Failure {
            message: Cow::Borrowed("the length of `left` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_parallelogram_stage.flex"),
                line: 20,
                column: 6,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link left  from G1 to F1 { length = l,     angle = 90 deg exact, mass = ml, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `left` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_parallelogram_stage.flex"),
                line: 20,
                column: 66,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link left  from G1 to F1 { length = l,     angle = 90 deg exact, mass = ml, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `left` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_parallelogram_stage.flex"),
                line: 20,
                column: 66,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link left  from G1 to F1 { length = l,     angle = 90 deg exact, mass = ml, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `frame` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_parallelogram_stage.flex"),
                line: 22,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link frame from F1 to F2 { length = outer, angle =  0 deg,       mass = mf }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `frame` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_parallelogram_stage.flex"),
                line: 22,
                column: 66,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link frame from F1 to F2 { length = outer, angle =  0 deg,       mass = mf }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `frame` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_parallelogram_stage.flex"),
                line: 22,
                column: 66,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link frame from F1 to F2 { length = outer, angle =  0 deg,       mass = mf }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `stage` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_parallelogram_stage.flex"),
                line: 28,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link stage       from P1 to P2 { length = inner, angle =   0 deg,       mass = ms }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `stage` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_parallelogram_stage.flex"),
                line: 28,
                column: 73,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link stage       from P1 to P2 { length = inner, angle =   0 deg,       mass = ms }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `stage` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_parallelogram_stage.flex"),
                line: 28,
                column: 73,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link stage       from P1 to P2 { length = inner, angle =   0 deg,       mass = ms }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("`left` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("double_parallelogram_stage.flex"),
                line: 20,
                column: 6,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link left  from G1 to F1 { length = l,     angle = 90 deg exact, mass = ml, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
        Failure {
            message: Cow::Borrowed("`inner_left` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("double_parallelogram_stage.flex"),
                line: 26,
                column: 6,
                width: 10,
                excerpt: Cow::Borrowed(
                    "link inner_left  from H1 to P1 { length = l,     angle = -90 deg exact, mass = ml, symbol = φ2 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
    ];
    /// The equations of motion in plain text.
    pub const EQUATIONS: &str = r#"double_parallelogram_stage
══════════════════════════

A stage that hangs by two leaf springs from a frame that stands on two others: the stage's
travel is straight to second order, because what the frame sinks the stage rises.

Leaves are pseudo-rigid links with a torsion spring at either end.

Parallelogram right–frame–left
──────────────────────────────

  l e^(i φ_right) - outer e^(i φ_frame) - l e^(i φ1) + outer = 0
  φ_right = φ1 (opposite sides are equal)
  φ_frame = 0 (opposite sides are equal)

Parallelogram inner_right–stage–inner_left
──────────────────────────────────────────

  l e^(i φ_inner_right) - inner e^(i φ_stage) - l e^(i φ2) + inner = 0
  φ_inner_right = φ2 (opposite sides are equal)
  φ_stage = 0 (opposite sides are equal)

Constants of the inertia
────────────────────────

  C0 = 2 ml l² + I1 + I_right + ml r1² + ml r_right² + mf l² + ms l²
  C1 = I2 + I_inner_right + ml r2² + ml r_inner_right² + ms l²
  C2 = 2 l ml r2 + 2 l ml r_inner_right + 2 ms l²

Equations of motion of `left`, `inner_left`
───────────────────────────────────────────

Coordinates:

  q = (φ1, φ2)

Inertia:

  M12      = ½ C2 cos(φ1 - φ2)
  ∂M12/∂φ1 = ½ C2 sin(φ2 - φ1)
  ∂M12/∂φ2 = ½ C2 sin(φ1 - φ2)
  h1       = ∂M12/∂φ2 φ̇2²
  h2       = ∂M12/∂φ1 φ̇1²

Potential energy:

  ∂P_s/∂φ1 = 4 k (φ1 - φ1⁰)
  ∂P_s/∂φ2 = 4 k (φ2 - φ2⁰)

Other forces:

  τ1 = -l push sin(2 π f t) sin(φ1)
  τ2 = -l push sin(2 π f t) sin(φ2)

Balance:

  C0 φ̈1 + M12 φ̈2 + h1 + ∂P_s/∂φ1 = τ1
  M12 φ̈1 + C1 φ̈2 + h2 + ∂P_s/∂φ2 = τ2

Constants
─────────

  I             = 1/12 b h³    second moment of area
  l             = 0.8517 L     length of a pseudo-rigid link
  k             = 4.51401 E I / L
                  stiffness at either end of a leaf
  r1            = ½ l          distance of the centre of mass from the first end of left
  I1            = 1/12 ml l²   moment of inertia about the centre of mass of left
  r_right       = ½ l          distance of the centre of mass from the first end of right
  I_right       = 1/12 ml l²   moment of inertia about the centre of mass of right
  r2            = ½ l          distance of the centre of mass from the first end of inner_left
  I2            = 1/12 ml l²   moment of inertia about the centre of mass of inner_left
  r_inner_right = ½ l          distance of the centre of mass from the first end of inner_right
  I_inner_right = 1/12 ml l²   moment of inertia about the centre of mass of inner_right
  φ1⁰           = ½ π          angle of `left` as assembled
  φ2⁰           = -½ π         angle of `inner_left` as assembled
"#;
    /// The equations of motion as a LaTeX document.
    pub const EQUATIONS_LATEX: &str = r#"\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\begin{document}

\section*{double\_parallelogram\_stage}
A stage that hangs by two leaf springs from a frame that stands on two others: the stage's travel
is straight to second order, because what the frame sinks the stage rises.

Leaves are pseudo-rigid links with a torsion spring at either end.

\subsection*{Parallelogram right–frame–left}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{right}}} - \mathit{outer}\, e^{i \varphi_{\mathrm{frame}}} - l\, e^{i \varphi_{1}} + \mathit{outer} = 0 \\
& \varphi_{\mathrm{right}} = \varphi_{1} \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{frame}} = 0 \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram inner\_right–stage–inner\_left}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{inner},\mathrm{right}}} - \mathit{inner}\, e^{i \varphi_{\mathrm{stage}}} - l\, e^{i \varphi_{2}} + \mathit{inner} = 0 \\
& \varphi_{\mathrm{inner},\mathrm{right}} = \varphi_{2} \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{stage}} = 0 \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Constants of the inertia}
\begin{align*}
C_{0} &= 2 \, \mathit{ml} \, l^{2} + I_{1} + I_{\mathrm{right}} + \mathit{ml} \, r_{1}^{2} + \mathit{ml} \, r_{\mathrm{right}}^{2} + \mathit{mf} \, l^{2} + \mathit{ms} \, l^{2} \\
C_{1} &= I_{2} + I_{\mathrm{inner},\mathrm{right}} + \mathit{ml} \, r_{2}^{2} + \mathit{ml} \, r_{\mathrm{inner},\mathrm{right}}^{2} + \mathit{ms} \, l^{2} \\
C_{2} &= 2 \, l \, \mathit{ml} \, r_{2} + 2 \, l \, \mathit{ml} \, r_{\mathrm{inner},\mathrm{right}} + 2 \, \mathit{ms} \, l^{2}
\end{align*}

\subsection*{Equations of motion of \texttt{left}, \texttt{inner\_left}}
Coordinates:
\begin{align*}
& q = \left(\varphi_{1},\, \varphi_{2}\right)
\end{align*}
Inertia:
\begin{align*}
M_{12} &= \frac{1}{2} \, C_{2} \cos\left(\varphi_{1} - \varphi_{2}\right) \\
\frac{\partial M_{12}}{\partial \varphi_{1}} &= \frac{1}{2} \, C_{2} \sin\left(\varphi_{2} - \varphi_{1}\right) \\
\frac{\partial M_{12}}{\partial \varphi_{2}} &= \frac{1}{2} \, C_{2} \sin\left(\varphi_{1} - \varphi_{2}\right) \\
h_{1} &= \frac{\partial M_{12}}{\partial \varphi_{2}} \, \dot{\varphi}_{2}^{2} \\
h_{2} &= \frac{\partial M_{12}}{\partial \varphi_{1}} \, \dot{\varphi}_{1}^{2}
\end{align*}
Potential energy:
\begin{align*}
\frac{\partial P_s}{\partial \varphi_{1}} &= 4 \, k \left(\varphi_{1} - \varphi_{1}^0\right) \\
\frac{\partial P_s}{\partial \varphi_{2}} &= 4 \, k \left(\varphi_{2} - \varphi_{2}^0\right)
\end{align*}
Other forces:
\begin{align*}
\tau_{1} &= -l \, \mathit{push} \sin\left(2 \, \pi \, f \, t\right) \sin \varphi_{1} \\
\tau_{2} &= -l \, \mathit{push} \sin\left(2 \, \pi \, f \, t\right) \sin \varphi_{2}
\end{align*}
Balance:
\begin{align*}
& \begin{bmatrix} C_{0} & M_{12} \\[1ex] M_{12} & C_{1} \end{bmatrix} \begin{bmatrix} \ddot{\varphi}_{1} \\[1ex] \ddot{\varphi}_{2} \end{bmatrix} + \begin{bmatrix} h_{1} \\[1ex] h_{2} \end{bmatrix} + \begin{bmatrix} \frac{\partial P_s}{\partial \varphi_{1}} \\[1ex] \frac{\partial P_s}{\partial \varphi_{2}} \end{bmatrix} = \begin{bmatrix} \tau_{1} \\[1ex] \tau_{2} \end{bmatrix}
\end{align*}

\subsection*{Constants}
\begin{align*}
I &= \frac{1}{12} \, b \, h^{3} && \text{second moment of area} \\
l &= 0.8517 \, L && \text{length of a pseudo-rigid link} \\
k &= \frac{4.51401 \, E \, I}{L} && \text{stiffness at either end of a leaf} \\
r_{1} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of left} \\
I_{1} &= \frac{1}{12} \, \mathit{ml} \, l^{2} && \text{moment of inertia about the centre of mass of left} \\
r_{\mathrm{right}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of right} \\
I_{\mathrm{right}} &= \frac{1}{12} \, \mathit{ml} \, l^{2} && \text{moment of inertia about the centre of mass of right} \\
r_{2} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of inner\_left} \\
I_{2} &= \frac{1}{12} \, \mathit{ml} \, l^{2} && \text{moment of inertia about the centre of mass of inner\_left} \\
r_{\mathrm{inner},\mathrm{right}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of inner\_right} \\
I_{\mathrm{inner},\mathrm{right}} &= \frac{1}{12} \, \mathit{ml} \, l^{2} && \text{moment of inertia about the centre of mass of inner\_right} \\
\varphi_{1}^0 &= \frac{1}{2} \, \pi && \text{angle of \texttt{left} as assembled} \\
\varphi_{2}^0 &= -\frac{1}{2} \, \pi && \text{angle of \texttt{inner\_left} as assembled}
\end{align*}

\end{document}
"#;
}
