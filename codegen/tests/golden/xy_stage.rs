/// Simulator of the model `xy_stage`, generated from its equations of motion.
///
/// A serial xy stage: a platform on two leaf springs on a frame, which stands on two others; a piezo
/// stack moves each.
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
pub mod xy_stage {
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
        /// length, width and thickness of a leaf in m; 0.03 by default
        pub L: f64,
        /// length, width and thickness of a leaf in m; 0.012 by default
        pub b: f64,
        /// length, width and thickness of a leaf in m; 0.0008 by default
        pub h: f64,
        /// between the leaves in m; 0.06 by default
        pub w: f64,
        /// mass of a leaf, of the frame, of the platform in kg; 0.0008 by default
        pub ml: f64,
        /// mass of a leaf, of the frame, of the platform in kg; 0.12 by default
        pub mf: f64,
        /// mass of a leaf, of the frame, of the platform in kg; 0.045 by default
        pub mp: f64,
        /// damping at either end of a leaf in N\*m\*s; 0.0001 by default
        pub c: f64,
        /// piezo stacks in N/m; 2e6 by default
        pub ks: f64,
        /// piezo stacks in N\*s/m; 40.0 by default
        pub cs: f64,
        /// their free extensions in m; 2e-5 by default
        pub stroke: f64,
        /// their free extensions in 1/s; 80.0 by default
        pub fx: f64,
        /// their free extensions in 1/s; 110.0 by default
        pub fy: f64,
    }
    impl Default for Params {
        fn default() -> Self {
            Self {
                E: 7.2e10,
                L: 0.03,
                b: 0.012,
                h: 0.0008,
                w: 0.06,
                ml: 0.0008,
                mf: 0.12,
                mp: 0.045,
                c: 0.0001,
                ks: 2e6,
                cs: 40.0,
                stroke: 2e-5,
                fx: 80.0,
                fy: 110.0,
            }
        }
    }
    impl Params {
        /// The values in the order of [`VARIABLES`].
        pub fn values(&self) -> [f64; 14] {
            [
                self.E,
                self.L,
                self.b,
                self.h,
                self.w,
                self.ml,
                self.mf,
                self.mp,
                self.c,
                self.ks,
                self.cs,
                self.stroke,
                self.fx,
                self.fy,
            ]
        }
        /// Params of values in the order of [`VARIABLES`].
        pub fn from_values(values: [f64; 14]) -> Self {
            Self {
                E: values[0],
                L: values[1],
                b: values[2],
                h: values[3],
                w: values[4],
                ml: values[5],
                mf: values[6],
                mp: values[7],
                c: values[8],
                ks: values[9],
                cs: values[10],
                stroke: values[11],
                fx: values[12],
                fy: values[13],
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
            let w = self.w;
            let ml = self.ml;
            let mf = self.mf;
            let mp = self.mp;
            let c = self.c;
            let ks = self.ks;
            let cs = self.cs;
            let stroke = self.stroke;
            let fx = self.fx;
            let fy = self.fy;
            // length of a pseudo-rigid link
            let l = L * 0.8517;
            let l_squared = l * l;
            let l_squared_ml = l_squared * ml;
            // moment of inertia about the centre of mass of left
            let I1 = l_squared_ml * 0.08333333333333333;
            let w_squared = w * w;
            // moment of inertia about the centre of mass of frame
            let I_frame = w_squared * mf * 0.08333333333333333;
            // moment of inertia about the centre of mass of platform
            let I_platform = w_squared * mp * 0.08333333333333333;
            let two_I1 = I1 * 2.0;
            // distance of the centre of mass from the first end of left
            let r1 = l * 0.5;
            let two_ml_r1_squared = ml * (r1 * r1) * 2.0;
            let l_squared_mp = l_squared * mp;
            // constant of the inertia
            let C0 = l_squared_ml * 2.0 + two_I1 + two_ml_r1_squared + l_squared * mf
                + l_squared_mp;
            // inertia as assembled
            let A_lower_0 = l_squared_ml * 0.6666666666666666 + l_squared_mp;
            // constant of the inertia
            let C1 = two_I1 + two_ml_r1_squared + l_squared_mp;
            // constant of the inertia
            let C2 = l * ml * r1 * 4.0 + l_squared_mp * 2.0;
            // second moment of area
            let I = b * (h * (h * h)) * 0.08333333333333333;
            // stiffness at either end of a leaf
            let k = E * I * 4.51401 / L;
            let ddP_s_dφ1_dφ1 = k * 4.0;
            let dF_y_stack_dφ1 = ks * 0.0;
            if !(l > 0.0) {
                return Err(FAILURES[0].diagnostic(&[l]));
            }
            if !(ml >= 0.0) {
                return Err(FAILURES[1].diagnostic(&[ml]));
            }
            if !(I1 >= 0.0) {
                return Err(FAILURES[2].diagnostic(&[I1]));
            }
            if !(w > 0.0) {
                return Err(FAILURES[3].diagnostic(&[w]));
            }
            if !(mf >= 0.0) {
                return Err(FAILURES[4].diagnostic(&[mf]));
            }
            if !(I_frame >= 0.0) {
                return Err(FAILURES[5].diagnostic(&[I_frame]));
            }
            if !(mp >= 0.0) {
                return Err(FAILURES[6].diagnostic(&[mp]));
            }
            if !(I_platform >= 0.0) {
                return Err(FAILURES[7].diagnostic(&[I_platform]));
            }
            if !(fx >= 0.0) {
                return Err(FAILURES[8].diagnostic(&[fx]));
            }
            if !(fy >= 0.0) {
                return Err(FAILURES[9].diagnostic(&[fy]));
            }
            if !(C0 > 0.0) {
                return Err(FAILURES[10].diagnostic(&[]));
            }
            if !(A_lower_0 > 0.0) {
                return Err(FAILURES[11].diagnostic(&[]));
            }
            let mut prepared = Prepared {
                start_states: [1.5707963267948966, 0.0, 0.0, 0.0],
                start_discretes: [],
                ks,
                cs,
                stroke,
                l,
                C0,
                C1,
                half_C2: C2 * 0.5,
                C0_C1: C0 * C1,
                k,
                ddP_s_dφ1_dφ1,
                constant1: fx * 6.283185307179586,
                constant2: stroke * fx * 6.283185307179586,
                _4_c: c * 4.0,
                constant3: fy * 6.283185307179586,
                constant4: stroke * fy * 6.283185307179586,
                l_cs: l * cs,
                l_dF_y_stack_dφ1: l * dF_y_stack_dφ1,
                half_C0: C0 * 0.5,
                half_C1: C1 * 0.5,
                half_ks: ks * 0.5,
                two_k: k * 2.0,
                table_of_φ1: Table::none(),
            };
            check_start(prepared.states(), &prepared.start_states)?;
            check_start(prepared.discretes(), &prepared.start_discretes)?;
            prepared.table_of_φ1 = Table::fit(
                &prepared,
                &COORDINATES,
                0,
                4,
                |φ1, d| { functions_of_φ1(φ1, array(d), &prepared) },
            );
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
        /// `ks`
        pub ks: T,
        /// `cs`
        pub cs: T,
        /// `stroke`
        pub stroke: T,
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
        /// `6.283185307179586 * fx`
        pub constant1: T,
        /// `6.283185307179586 * stroke * fx`
        pub constant2: T,
        /// `4.0 * c`
        pub _4_c: T,
        /// `6.283185307179586 * fy`
        pub constant3: T,
        /// `6.283185307179586 * stroke * fy`
        pub constant4: T,
        /// `l * cs`
        pub l_cs: T,
        /// `l * ∂F_y_stack/∂φ1`
        pub l_dF_y_stack_dφ1: T,
        /// `0.5 * C0`
        pub half_C0: T,
        /// `0.5 * C1`
        pub half_C1: T,
        /// `0.5 * ks`
        pub half_ks: T,
        /// `2.0 * k`
        pub two_k: T,
        /// [`functions_of_φ1`] near the start.
        pub table_of_φ1: Table<T, 4>,
    }
    impl<T: Copy> Prepared<T> {
        /// The same with every number turned into another, without curves: for dual numbers or lanes.
        pub fn map<U>(&self, turn: impl Fn(T) -> U) -> Prepared<U> {
            Prepared {
                start_states: self.start_states.map(&turn),
                start_discretes: self.start_discretes.map(&turn),
                ks: turn(self.ks),
                cs: turn(self.cs),
                stroke: turn(self.stroke),
                l: turn(self.l),
                C0: turn(self.C0),
                C1: turn(self.C1),
                half_C2: turn(self.half_C2),
                C0_C1: turn(self.C0_C1),
                k: turn(self.k),
                ddP_s_dφ1_dφ1: turn(self.ddP_s_dφ1_dφ1),
                constant1: turn(self.constant1),
                constant2: turn(self.constant2),
                _4_c: turn(self._4_c),
                constant3: turn(self.constant3),
                constant4: turn(self.constant4),
                l_cs: turn(self.l_cs),
                l_dF_y_stack_dφ1: turn(self.l_dF_y_stack_dφ1),
                half_C0: turn(self.half_C0),
                half_C1: turn(self.half_C1),
                half_ks: turn(self.half_ks),
                two_k: turn(self.two_k),
                table_of_φ1: self.table_of_φ1.map(&turn),
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
                ks: join(self.ks, other.ks),
                cs: join(self.cs, other.cs),
                stroke: join(self.stroke, other.stroke),
                l: join(self.l, other.l),
                C0: join(self.C0, other.C0),
                C1: join(self.C1, other.C1),
                half_C2: join(self.half_C2, other.half_C2),
                C0_C1: join(self.C0_C1, other.C0_C1),
                k: join(self.k, other.k),
                ddP_s_dφ1_dφ1: join(self.ddP_s_dφ1_dφ1, other.ddP_s_dφ1_dφ1),
                constant1: join(self.constant1, other.constant1),
                constant2: join(self.constant2, other.constant2),
                _4_c: join(self._4_c, other._4_c),
                constant3: join(self.constant3, other.constant3),
                constant4: join(self.constant4, other.constant4),
                l_cs: join(self.l_cs, other.l_cs),
                l_dF_y_stack_dφ1: join(self.l_dF_y_stack_dφ1, other.l_dF_y_stack_dφ1),
                half_C0: join(self.half_C0, other.half_C0),
                half_C1: join(self.half_C1, other.half_C1),
                half_ks: join(self.half_ks, other.half_ks),
                two_k: join(self.two_k, other.two_k),
                table_of_φ1: self.table_of_φ1.zip(&other.table_of_φ1, &join),
            }
        }
    }
    impl Prepared<f64> {
        /// The same without tables and curves: closed forms everywhere.
        pub fn exact(self) -> Self {
            Self {
                table_of_φ1: Table::none(),
                ..self
            }
        }
    }
    /// What [`rhs`] needs that depends on `φ1` and params alone, in closed form.
    #[inline(always)]
    pub fn functions_of_φ1<T: Real>(φ1: T, d: &[T; 0], p: &Prepared<T>) -> [T; 4] {
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let t1 = (φ1 + 1.5707963267948966) * 0.5;
        let (t2, t3) = t1.sin_cos();
        // displacement of `F1`
        let x_F1 = p.l
            * (t2 * ((T::from_f64(1.5707963267948966) - φ1) * 0.5).sin() * 2.0);
        // displacement of `T`
        let y_T = p.l * (t3 * ((φ1 - 1.5707963267948966) * 0.5).sin() * 2.0);
        [cos_φ1, sin_φ1, x_F1, y_T]
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
        let [cos_φ1, sin_φ1, x_F1, y_T] = if p.table_of_φ1.covers(φ1) {
            p.table_of_φ1.polynomials(φ1)
        } else {
            p.table_of_φ1.where_covered(φ1, functions_of_φ1(φ1, d, p))
        };
        // ── configuration ──
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
        let l_sin_φ1 = p.l * sin_φ1;
        // slope of the potential energy of springs
        let dP_s_dφ2 = p.ddP_s_dφ1_dφ1 * φ2;
        // slope of the inertia
        let dM12_dφ1 = -dM12_dφ2;
        let dy_P1_dφ2 = p.l * cos_φ2;
        let half_φ2 = φ2 * 0.5;
        let (sin_half_φ2, cos_half_φ2) = half_φ2.sin_cos();
        // displacement of `P1`
        let y_P1 = y_T + p.l * (cos_half_φ2 * sin_half_φ2 * 2.0);
        // ── state ──
        // centrifugal and Coriolis terms
        let h1 = dM12_dφ2 * (dφ2 * dφ2);
        let t1 = p.constant1 * t;
        let (t2, t3) = t1.sin_cos();
        // drive `ux`
        let ux = p.stroke * t2;
        // rate of the drive `ux`
        let dux = p.constant2 * t3;
        // force of `x_stack` on its second end
        let F_x_stack = (p.ks * (ux - x_F1))
            .plus_product(p.cs, dux.plus_product(l_sin_φ1, dφ1));
        let t4 = (dP_s_dφ1.plus_product(p._4_c, dφ1) + h1)
            .plus_product(l_sin_φ1, F_x_stack);
        // centrifugal and Coriolis terms
        let h2 = dM12_dφ1 * (dφ1 * dφ1);
        let t5 = p.constant3 * t;
        let (t6, t7) = t5.sin_cos();
        // drive `uy`
        let uy = p.stroke * t6;
        // rate of the drive `uy`
        let duy = p.constant4 * t7;
        // force of `y_stack` on its second end
        let F_y_stack = (p.ks * (y_T - y_P1 + uy))
            .minus_product(p.cs, (-duy).plus_product(dy_P1_dφ2, dφ2));
        // generalized torque of all other forces
        let τ2 = (dy_P1_dφ2 * F_y_stack).minus_product(p._4_c, dφ2);
        let t8 = dP_s_dφ2 + h2 - τ2;
        let ddφ1 = -(per_det_M * (p.C1 * t4).minus_product(M12, t8));
        let ddφ2 = -(per_det_M * (p.C0 * t8).minus_product(M12, t4));
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
        let t2 = φ1 - 1.5707963267948966;
        // slope of the potential energy of springs
        let dP_s_dφ1 = p.ddP_s_dφ1_dφ1 * t2;
        let l_sin_φ1 = p.l * sin_φ1;
        let t3 = (φ1 + 1.5707963267948966) * 0.5;
        let (t4, t5) = t3.sin_cos();
        // displacement of `F1`
        let x_F1 = p.l
            * (t4 * ((T::from_f64(1.5707963267948966) - φ1) * 0.5).sin() * 2.0);
        // slope of the potential energy of springs
        let dP_s_dφ2 = p.ddP_s_dφ1_dφ1 * φ2;
        let dy_P1_dφ2 = p.l * cos_φ2;
        // displacement of `T`
        let y_T = p.l * (t5 * (t2 * 0.5).sin() * 2.0);
        let half_φ2 = φ2 * 0.5;
        let (sin_half_φ2, cos_half_φ2) = half_φ2.sin_cos();
        // displacement of `P1`
        let y_P1 = y_T + p.l * (cos_half_φ2 * sin_half_φ2 * 2.0);
        let per_det_M = det_M.recip();
        let dy_T_dφ1 = p.l * cos_φ1;
        let dx_F1_dφ1 = -l_sin_φ1;
        let dτ2_dφ1 = p.l_dF_y_stack_dφ1 * cos_φ2;
        let ddM12_dφ1_dφ1 = -M12;
        let dF_x_stack_ddφ1 = p.l_cs * sin_φ1;
        let dτ1_ddφ1 = -(p._4_c + p.l * (sin_φ1 * dF_x_stack_ddφ1));
        let ddet_M_dφ2 = -(M12 * dM12_dφ2 * 2.0);
        let t6 = per_det_M_squared * ddet_M_dφ2;
        let dF_y_stack_ddφ2 = -(p.l_cs * cos_φ2);
        let dτ2_ddφ2 = p.l * (cos_φ2 * dF_y_stack_ddφ2) - p._4_c;
        // ── state ──
        let t7 = p.constant1 * t;
        let (t8, t9) = t7.sin_cos();
        // drive `ux`
        let ux = p.stroke * t8;
        // rate of the drive `ux`
        let dux = p.constant2 * t9;
        // force of `x_stack` on its second end
        let F_x_stack = p.ks * (ux - x_F1) + p.cs * (l_sin_φ1 * dφ1 + dux);
        let dφ2_squared = dφ2 * dφ2;
        // centrifugal and Coriolis terms
        let h1 = dM12_dφ2 * dφ2_squared;
        let t10 = dP_s_dφ1 + (p._4_c * dφ1 + l_sin_φ1 * F_x_stack) + h1;
        let t11 = p.constant3 * t;
        let (t12, t13) = t11.sin_cos();
        // drive `uy`
        let uy = p.stroke * t12;
        // rate of the drive `uy`
        let duy = p.constant4 * t13;
        // force of `y_stack` on its second end
        let F_y_stack = p.ks * (y_T - y_P1 + uy) - p.cs * (dy_P1_dφ2 * dφ2 - duy);
        // generalized torque of all other forces
        let τ2 = dy_P1_dφ2 * F_y_stack - p._4_c * dφ2;
        let dφ1_squared = dφ1 * dφ1;
        // centrifugal and Coriolis terms
        let h2 = dM12_dφ1 * dφ1_squared;
        let t14 = dP_s_dφ2 - τ2 + h2;
        let t15 = p.C1 * t10 - M12 * t14;
        let dF_x_stack_dφ1 = p.l_cs * cos_φ1 * dφ1 - p.ks * dx_F1_dφ1;
        let t16 = p.ddP_s_dφ1_dφ1
            + (dy_T_dφ1 * F_x_stack + l_sin_φ1 * dF_x_stack_dφ1);
        let dh1_dφ1 = M12 * dφ2_squared;
        let t17 = t16 + dh1_dφ1;
        let dh2_dφ1 = ddM12_dφ1_dφ1 * dφ1_squared;
        let dτ2_dφ1_minus_dh2_dφ1 = dτ2_dφ1 - dh2_dφ1;
        let t18 = per_det_M
            * (p.C1 * t17 - dM12_dφ1 * t14 + M12 * dτ2_dφ1_minus_dh2_dφ1);
        let dddφ1_dφ1 = t1 * t15 - t18;
        let dh2_ddφ1 = dM12_dφ1 * 2.0 * dφ1;
        let dddφ1_ddφ1 = per_det_M * (p.C1 * dτ1_ddφ1 + M12 * dh2_ddφ1);
        let dh1_dφ2 = ddM12_dφ1_dφ1 * dφ2_squared;
        let dF_y_stack_dφ2 = p.l_cs * sin_φ2 * dφ2 - p.ks * dy_P1_dφ2;
        let dτ2_dφ2 = dy_P1_dφ2 * dF_y_stack_dφ2 - p.l * sin_φ2 * F_y_stack;
        let dh2_dφ2 = M12 * dφ1_squared;
        let t19 = p.ddP_s_dφ1_dφ1 - dτ2_dφ2 + dh2_dφ2;
        let dddφ1_dφ2 = t6 * t15
            + per_det_M * (dM12_dφ2 * t14 - p.C1 * dh1_dφ2 + M12 * t19);
        let dh1_ddφ2 = dM12_dφ2 * 2.0 * dφ2;
        let dddφ1_ddφ2 = -(per_det_M * (M12 * dτ2_ddφ2 + p.C1 * dh1_ddφ2));
        let t20 = p.C0 * t14 - M12 * t10;
        let t21 = per_det_M
            * (p.C0 * dτ2_dφ1_minus_dh2_dφ1 + dM12_dφ1 * t10 + M12 * t17);
        let dddφ2_dφ1 = t1 * t20 + t21;
        let dddφ2_ddφ1 = -(per_det_M * (M12 * dτ1_ddφ1 + p.C0 * dh2_ddφ1));
        let dddφ2_dφ2 = t6 * t20
            + per_det_M * (dM12_dφ2 * t10 - p.C0 * t19 + M12 * dh1_dφ2);
        let dddφ2_ddφ2 = per_det_M * (p.C0 * dτ2_ddφ2 + M12 * dh1_ddφ2);
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
        let dy_T_dφ1 = p.l * cos_φ1;
        let (sin_φ2, cos_φ2) = φ2.sin_cos();
        let dy_P1_dφ2 = p.l * cos_φ2;
        let P1_x = dy_T_dφ1 + dy_P1_dφ2;
        let P1_y = p.l * sin_φ1 + 0.01 + p.l * sin_φ2;
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
        let t3 = (φ1 + 1.5707963267948966) * 0.5;
        let (t4, t5) = t3.sin_cos();
        // displacement of `F1`
        let x_F1 = p.l * (t4 * (t2 * 0.5).sin() * 2.0);
        // displacement of `T`
        let y_T = p.l * (t5 * (t1 * 0.5).sin() * 2.0);
        let half_φ2 = φ2 * 0.5;
        let (sin_half_φ2, cos_half_φ2) = half_φ2.sin_cos();
        // displacement of `P1`
        let y_P1 = y_T + p.l * (cos_half_φ2 * sin_half_φ2 * 2.0);
        let dy_P1_dφ2 = p.l * cos_φ2;
        // ── state ──
        let dφ1_squared = dφ1 * dφ1;
        let dφ2_squared = dφ2 * dφ2;
        let t6 = p.half_C0 * dφ1_squared + p.half_C1 * dφ2_squared
            + M12 * (dφ1 * dφ2);
        let t7 = p.constant1 * t;
        let (t8, t9) = t7.sin_cos();
        // drive `ux`
        let ux = p.stroke * t8;
        let x_F1_minus_ux = x_F1 - ux;
        let t10 = p.k * (t1 * t1) + p.k * (t2 * t2) + p.two_k * (φ2 * φ2)
            + p.half_ks * (x_F1_minus_ux * x_F1_minus_ux);
        let t11 = p.constant3 * t;
        let (t12, t13) = t11.sin_cos();
        // drive `uy`
        let uy = p.stroke * t12;
        let y_P1_minus_y_T_minus_uy = y_P1 - y_T - uy;
        let t14 = t10 + p.half_ks * (y_P1_minus_y_T_minus_uy * y_P1_minus_y_T_minus_uy);
        // rate of the drive `ux`
        let dux = p.constant2 * t9;
        let l_sin_φ1_dφ1_plus_dux = p.l * sin_φ1 * dφ1 + dux;
        let t15 = p._4_c * dφ1_squared + p._4_c * dφ2_squared
            + p.cs * (l_sin_φ1_dφ1_plus_dux * l_sin_φ1_dφ1_plus_dux);
        // rate of the drive `uy`
        let duy = p.constant4 * t13;
        let dy_P1_dφ2_dφ2_minus_duy = dy_P1_dφ2 * dφ2 - duy;
        // force of `x_stack` on its second end
        let F_x_stack = p.ks * (ux - x_F1) + p.cs * l_sin_φ1_dφ1_plus_dux;
        // force of `y_stack` on its second end
        let F_y_stack = p.ks * (y_T - y_P1 + uy) - p.cs * dy_P1_dφ2_dφ2_minus_duy;
        result[0] = t6;
        result[1] = t14;
        result[2] = t15 + p.cs * (dy_P1_dφ2_dφ2_minus_duy * dy_P1_dφ2_dφ2_minus_duy);
        result[3] = dux * F_x_stack + duy * F_y_stack;
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
        fn tables(&self) -> Vec<TableReport> {
            [self.table_of_φ1.report(0)].into_iter().flatten().collect()
        }
        fn is_outside_tables(&self, x: &[f64]) -> bool {
            self.table_of_φ1.is_left_by(x[0])
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
        #[inline(always)]
        fn outside_tables_in_lanes<L: Lanes>(lanes: &Prepared<L>, x: &[L]) -> L {
            L::from_f64(-1.0).larger(lanes.table_of_φ1.left_by(x[0]))
        }
    }
    /// Every quantity with a name: params, states, discrete states, inputs, outputs.
    pub static VARIABLES: [Variable; 20] = [
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
            start: Some(0.03),
        },
        Variable {
            name: Cow::Borrowed("b"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length, width and thickness of a leaf"),
            causality: Causality::Parameter,
            start: Some(0.012),
        },
        Variable {
            name: Cow::Borrowed("h"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length, width and thickness of a leaf"),
            causality: Causality::Parameter,
            start: Some(0.0008),
        },
        Variable {
            name: Cow::Borrowed("w"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("between the leaves"),
            causality: Causality::Parameter,
            start: Some(0.06),
        },
        Variable {
            name: Cow::Borrowed("ml"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of a leaf, of the frame, of the platform"),
            causality: Causality::Parameter,
            start: Some(0.0008),
        },
        Variable {
            name: Cow::Borrowed("mf"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of a leaf, of the frame, of the platform"),
            causality: Causality::Parameter,
            start: Some(0.12),
        },
        Variable {
            name: Cow::Borrowed("mp"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of a leaf, of the frame, of the platform"),
            causality: Causality::Parameter,
            start: Some(0.045),
        },
        Variable {
            name: Cow::Borrowed("c"),
            unit: Cow::Borrowed("N*m*s"),
            meaning: Cow::Borrowed("damping at either end of a leaf"),
            causality: Causality::Parameter,
            start: Some(0.0001),
        },
        Variable {
            name: Cow::Borrowed("ks"),
            unit: Cow::Borrowed("N/m"),
            meaning: Cow::Borrowed("piezo stacks"),
            causality: Causality::Parameter,
            start: Some(2e6),
        },
        Variable {
            name: Cow::Borrowed("cs"),
            unit: Cow::Borrowed("N*s/m"),
            meaning: Cow::Borrowed("piezo stacks"),
            causality: Causality::Parameter,
            start: Some(40.0),
        },
        Variable {
            name: Cow::Borrowed("stroke"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("their free extensions"),
            causality: Causality::Parameter,
            start: Some(2e-5),
        },
        Variable {
            name: Cow::Borrowed("fx"),
            unit: Cow::Borrowed("1/s"),
            meaning: Cow::Borrowed("their free extensions"),
            causality: Causality::Parameter,
            start: Some(80.0),
        },
        Variable {
            name: Cow::Borrowed("fy"),
            unit: Cow::Borrowed("1/s"),
            meaning: Cow::Borrowed("their free extensions"),
            causality: Causality::Parameter,
            start: Some(110.0),
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
            name: Cow::Borrowed("lower.angle"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("angle of `lower`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("lower.rate"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed("angular rate of `lower`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("x"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("position of the platform"),
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
    static PARAMS: &[Variable] = VARIABLES.split_at(0).1.split_at(14).0;
    static STATES: &[Variable] = VARIABLES.split_at(14).1.split_at(4).0;
    static DISCRETES: &[Variable] = VARIABLES.split_at(18).1.split_at(0).0;
    static INPUTS: &[Variable] = VARIABLES.split_at(18).1.split_at(0).0;
    static OUTPUTS: &[Variable] = VARIABLES.split_at(18).1.split_at(2).0;
    /// Positions of the coordinates and of their rates among the states.
    static COORDINATES: [(usize, usize); 2] = [(0, 1), (2, 3)];
    static TURNING: [usize; 0] = [];
    static FAILURES: [Failure; 12] = [
        Failure {
            message: Cow::Borrowed("the length of `left` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("xy_stage.flex"),
                line: 25,
                column: 6,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link left  from G1 to F1 { length = l, angle = 90 deg exact, mass = ml, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `left` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("xy_stage.flex"),
                line: 25,
                column: 62,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link left  from G1 to F1 { length = l, angle = 90 deg exact, mass = ml, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `left` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("xy_stage.flex"),
                line: 25,
                column: 62,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link left  from G1 to F1 { length = l, angle = 90 deg exact, mass = ml, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `frame` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("xy_stage.flex"),
                line: 27,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link frame from F1 to F2 { length = w, angle =  0 deg,       mass = mf }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `frame` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("xy_stage.flex"),
                line: 27,
                column: 62,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link frame from F1 to F2 { length = w, angle =  0 deg,       mass = mf }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `frame` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("xy_stage.flex"),
                line: 27,
                column: 62,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link frame from F1 to F2 { length = w, angle =  0 deg,       mass = mf }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `platform` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("xy_stage.flex"),
                line: 35,
                column: 65,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link platform from P1 to P2 { length = w, angle = 90 deg,       mass = mp }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `platform` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("xy_stage.flex"),
                line: 35,
                column: 65,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link platform from P1 to P2 { length = w, angle = 90 deg,       mass = mp }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the frequency is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("xy_stage.flex"),
                line: 18,
                column: 7,
                width: 2,
                excerpt: Cow::Borrowed("drive ux = sine(stroke, frequency = fx)"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("Hz")]),
        },
        Failure {
            message: Cow::Borrowed("the frequency is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("xy_stage.flex"),
                line: 19,
                column: 7,
                width: 2,
                excerpt: Cow::Borrowed("drive uy = sine(stroke, frequency = fy)"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("Hz")]),
        },
        Failure {
            message: Cow::Borrowed("`left` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("xy_stage.flex"),
                line: 25,
                column: 6,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link left  from G1 to F1 { length = l, angle = 90 deg exact, mass = ml, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
        Failure {
            message: Cow::Borrowed("`lower` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("xy_stage.flex"),
                line: 33,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link lower    from H1 to P1 { length = l, angle =  0 deg exact, mass = ml, symbol = φ2 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
    ];
    /// The equations of motion in plain text.
    pub const EQUATIONS: &str = r#"xy_stage
════════

A serial xy stage: a platform on two leaf springs on a frame, which stands on two others; a
piezo stack moves each.

Leaves are pseudo-rigid links with a torsion spring at either end.

Parallelogram right–frame–left
──────────────────────────────

  l e^(i φ_right) - w e^(i φ_frame) - l e^(i φ1) + w = 0
  φ_right = φ1 (opposite sides are equal)
  φ_frame = 0 (opposite sides are equal)

Parallelogram upper–platform–lower
──────────────────────────────────

  l e^(i φ_upper) - w e^(i φ_platform) - l e^(i φ2) + i w = 0
  φ_upper = φ2 (opposite sides are equal)
  φ_platform = π/2 (opposite sides are equal)

Drives
──────

  ux(t) = sine(stroke, frequency = fx)
  uy(t) = sine(stroke, frequency = fy)

Constants of the inertia
────────────────────────

  C0 = 2 ml l² + I1 + I_right + ml r1² + ml r_right² + mf l² + mp l²
  C1 = I2 + I_upper + ml r2² + ml r_upper² + mp l²
  C2 = 2 l ml r2 + 2 l ml r_upper + 2 mp l²

Named forces
────────────

  x_F1      = l (cos(φ1) - cos(φ1⁰))
  F_x_stack = ks (ux - x_F1) + cs (l φ̇1 sin(φ1) + u̇x)
  y_T       = l (sin(φ1) - sin(φ1⁰))
  y_P1      = l (sin(φ1) - sin(φ1⁰)) + l (sin(φ2) - sin(φ2⁰))
  F_y_stack = ks (uy + y_T - y_P1) + cs (u̇y - l φ̇2 cos(φ2))

Equations of motion of `left`, `lower`
──────────────────────────────────────

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

  τ1 = -4 c φ̇1 - l F_x_stack sin(φ1)
  τ2 = l F_y_stack cos(φ2) - 4 c φ̇2

Balance:

  C0 φ̈1 + M12 φ̈2 + h1 + ∂P_s/∂φ1 = τ1
  M12 φ̈1 + C1 φ̈2 + h2 + ∂P_s/∂φ2 = τ2

Constants
─────────

  I       = 1/12 b h³         second moment of area
  l       = 0.8517 L          length of a pseudo-rigid link
  k       = 4.51401 E I / L   stiffness at either end of a leaf
  r1      = ½ l               distance of the centre of mass from the first end of left
  I1      = 1/12 ml l²        moment of inertia about the centre of mass of left
  r_right = ½ l               distance of the centre of mass from the first end of right
  I_right = 1/12 ml l²        moment of inertia about the centre of mass of right
  r2      = ½ l               distance of the centre of mass from the first end of lower
  I2      = 1/12 ml l²        moment of inertia about the centre of mass of lower
  r_upper = ½ l               distance of the centre of mass from the first end of upper
  I_upper = 1/12 ml l²        moment of inertia about the centre of mass of upper
  φ1⁰     = ½ π               angle of `left` as assembled
  φ2⁰     = 0                 angle of `lower` as assembled
"#;
    /// The equations of motion as a LaTeX document.
    pub const EQUATIONS_LATEX: &str = r#"\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\begin{document}

\section*{xy\_stage}
A serial xy stage: a platform on two leaf springs on a frame, which stands on two others; a piezo
stack moves each.

Leaves are pseudo-rigid links with a torsion spring at either end.

\subsection*{Parallelogram right–frame–left}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{right}}} - w\, e^{i \varphi_{\mathrm{frame}}} - l\, e^{i \varphi_{1}} + w = 0 \\
& \varphi_{\mathrm{right}} = \varphi_{1} \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{frame}} = 0 \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upper–platform–lower}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upper}}} - w\, e^{i \varphi_{\mathrm{platform}}} - l\, e^{i \varphi_{2}} + i\,w = 0 \\
& \varphi_{\mathrm{upper}} = \varphi_{2} \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{platform}} = \pi/2 \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Drives}
\begin{align*}
& \mathit{ux}(t) = \text{sine(stroke, frequency = fx)} \\
& \mathit{uy}(t) = \text{sine(stroke, frequency = fy)}
\end{align*}

\subsection*{Constants of the inertia}
\begin{align*}
C_{0} &= 2 \, \mathit{ml} \, l^{2} + I_{1} + I_{\mathrm{right}} + \mathit{ml} \, r_{1}^{2} + \mathit{ml} \, r_{\mathrm{right}}^{2} + \mathit{mf} \, l^{2} + \mathit{mp} \, l^{2} \\
C_{1} &= I_{2} + I_{\mathrm{upper}} + \mathit{ml} \, r_{2}^{2} + \mathit{ml} \, r_{\mathrm{upper}}^{2} + \mathit{mp} \, l^{2} \\
C_{2} &= 2 \, l \, \mathit{ml} \, r_{2} + 2 \, l \, \mathit{ml} \, r_{\mathrm{upper}} + 2 \, \mathit{mp} \, l^{2}
\end{align*}

\subsection*{Named forces}
\begin{align*}
x_{\mathrm{F1}} &= l \left(\cos \varphi_{1} - \cos \varphi_{1}^0\right) \\
F_{x,\mathrm{stack}} &= \mathit{ks} \left(\mathit{ux} - x_{\mathrm{F1}}\right) + \mathit{cs} \left(l \, \dot{\varphi}_{1} \sin \varphi_{1} + \dot{\mathit{ux}}\right) \\
y_{T} &= l \left(\sin \varphi_{1} - \sin \varphi_{1}^0\right) \\
y_{\mathrm{P1}} &= l \left(\sin \varphi_{1} - \sin \varphi_{1}^0\right) + l \left(\sin \varphi_{2} - \sin \varphi_{2}^0\right) \\
F_{y,\mathrm{stack}} &= \mathit{ks} \left(\mathit{uy} + y_{T} - y_{\mathrm{P1}}\right) + \mathit{cs} \left(\dot{\mathit{uy}} - l \, \dot{\varphi}_{2} \cos \varphi_{2}\right)
\end{align*}

\subsection*{Equations of motion of \texttt{left}, \texttt{lower}}
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
\tau_{1} &= -4 \, c \, \dot{\varphi}_{1} - l \, F_{x,\mathrm{stack}} \sin \varphi_{1} \\
\tau_{2} &= l \, F_{y,\mathrm{stack}} \cos \varphi_{2} - 4 \, c \, \dot{\varphi}_{2}
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
r_{2} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of lower} \\
I_{2} &= \frac{1}{12} \, \mathit{ml} \, l^{2} && \text{moment of inertia about the centre of mass of lower} \\
r_{\mathrm{upper}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upper} \\
I_{\mathrm{upper}} &= \frac{1}{12} \, \mathit{ml} \, l^{2} && \text{moment of inertia about the centre of mass of upper} \\
\varphi_{1}^0 &= \frac{1}{2} \, \pi && \text{angle of \texttt{left} as assembled} \\
\varphi_{2}^0 &= 0 && \text{angle of \texttt{lower} as assembled}
\end{align*}

\end{document}
"#;
}
