/// Simulator of the model `five_bar`, generated from its equations of motion.
///
/// A five-bar: two cranks on ground move the pin where their couplers meet, in both directions.
#[allow(
    non_snake_case,
    non_upper_case_globals,
    unused,
    clippy::all,
    clippy::pedantic,
    rustdoc::all
)]
pub mod five_bar {
    use std::borrow::Cow;
    use ::flexure_runtime::checks::{check_params, check_start};
    use ::flexure_runtime::diagnostic::{Diagnostic, Site};
    use ::flexure_runtime::failure::{Failure, Unit};
    use ::flexure_runtime::generated::{array, array_mut};
    use ::flexure_runtime::newton;
    use ::flexure_runtime::real::Real;
    use ::flexure_runtime::system::{Causality, Energy, EventAction, System, Variable};
    /// What may be set: all in SI units, angles in rad.
    #[derive(Clone, Debug, PartialEq)]
    pub struct Params {
        /// between the cranks' pivots in m; 0.04 by default
        pub base: f64,
        /// length of a crank, of a coupler in m; 0.025 by default
        pub l1: f64,
        /// length of a crank, of a coupler in m; 0.035 by default
        pub l2: f64,
        /// mass of a crank, of a coupler, of the tool in kg; 0.005 by default
        pub m1: f64,
        /// mass of a crank, of a coupler, of the tool in kg; 0.006 by default
        pub m2: f64,
        /// mass of a crank, of a coupler, of the tool in kg; 0.008 by default
        pub mt: f64,
        /// stiffness of a hinge in N\*m; 0.4 by default
        pub k: f64,
        /// damping of a hinge in N\*m\*s; 2e-5 by default
        pub c: f64,
        /// drives in N\*m; 0.08 by default
        pub left_torque: f64,
        /// drives in N\*m; 0.05 by default
        pub right_torque: f64,
        /// their frequency in 1/s; 12.0 by default
        pub f: f64,
    }
    impl Default for Params {
        fn default() -> Self {
            Self {
                base: 0.04,
                l1: 0.025,
                l2: 0.035,
                m1: 0.005,
                m2: 0.006,
                mt: 0.008,
                k: 0.4,
                c: 2e-5,
                left_torque: 0.08,
                right_torque: 0.05,
                f: 12.0,
            }
        }
    }
    impl Params {
        /// The values in the order of [`VARIABLES`].
        pub fn values(&self) -> [f64; 11] {
            [
                self.base,
                self.l1,
                self.l2,
                self.m1,
                self.m2,
                self.mt,
                self.k,
                self.c,
                self.left_torque,
                self.right_torque,
                self.f,
            ]
        }
        /// Params of values in the order of [`VARIABLES`].
        pub fn from_values(values: [f64; 11]) -> Self {
            Self {
                base: values[0],
                l1: values[1],
                l2: values[2],
                m1: values[3],
                m2: values[4],
                mt: values[5],
                k: values[6],
                c: values[7],
                left_torque: values[8],
                right_torque: values[9],
                f: values[10],
            }
        }
        /// Closes the loops and computes everything that depends on params alone.
        ///
        /// # Errors
        /// What is wrong with the parameter set, in the words of `flexure check`.
        pub fn prepare(&self) -> Result<Prepared<f64>, Diagnostic> {
            check_params(PARAMS, &self.values())?;
            let base = self.base;
            let l1 = self.l1;
            let l2 = self.l2;
            let m1 = self.m1;
            let m2 = self.m2;
            let mt = self.mt;
            let k = self.k;
            let c = self.c;
            let left_torque = self.left_torque;
            let right_torque = self.right_torque;
            let f = self.f;
            let l1_squared = l1 * l1;
            // moment of inertia about the centre of mass of left_crank
            let I1 = l1_squared * m1 * 0.08333333333333333;
            let l2_squared = l2 * l2;
            // moment of inertia about the centre of mass of left_coupler
            let I3 = l2_squared * m2 * 0.08333333333333333;
            let X_0 = base + l1 * 0.5000000000000001 + l1 * 0.4999999999999998;
            let Y_0 = l1 * 0.8660254037844386 - l1 * 0.8660254037844387;
            let D_0 = X_0 * X_0 + Y_0 * Y_0;
            let _4_l2_squared = l2_squared * 4.0;
            let t1 = D_0 * (_4_l2_squared - D_0);
            let l2_squared_squared = l2_squared * l2_squared;
            let t2 = t1 * 0.25 / l2_squared_squared;
            // distance of the centre of mass from the first end of left_crank
            let r1 = l1 * 0.5;
            // constant of the inertia
            let C1 = I1 + m1 * (r1 * r1) + l1_squared * m2;
            // constant of the inertia
            let C0 = C1 + l1_squared * mt;
            // distance of the centre of mass from the first end of left_coupler
            let r3 = l2 * 0.5;
            // constant of the inertia
            let C3 = I3 + m2 * (r3 * r3);
            // constant of the inertia
            let C2 = C3 + l2_squared * mt;
            let half_Y_0 = Y_0 * 0.5;
            let l2_X_0 = l2 * X_0;
            let t3 = l2 * Y_0 * 0.9063077870366499;
            let t4 = (l2_X_0 * 0.42261826174069944 - t3) / l2_squared
                + (l2_X_0 * 0.4226182617406995 + t3) / l2_squared;
            // which way the loop closes: as drawn
            let s = t4.if_positive(1.0, -1.0);
            let η_0 = s * t1.sqrt() * 0.5 / D_0;
            let X_0_η_0 = X_0 * η_0;
            let s4_0 = (half_Y_0 - Y_0 + X_0_η_0) / l2;
            let half_X_0 = X_0 * 0.5;
            let Y_0_η_0 = Y_0 * η_0;
            let c4_0 = -((X_0 - half_X_0 + Y_0_η_0) / l2);
            // angle of `right_coupler` as assembled
            let φ4_0 = s4_0.atan2(c4_0).unwrap_to(2.705260340591211);
            let s3_0 = (half_Y_0 + X_0_η_0) / l2;
            let c3_0 = (half_X_0 - Y_0_η_0) / l2;
            // angle of `left_coupler` as assembled
            let φ3_0 = s3_0.atan2(c3_0).unwrap_to(0.4363323129985824);
            let l2_sin_φ3_0_minus_φ4_0 = l2 * (φ3_0 - φ4_0).sin();
            // rate as assembled
            let ω3_left_crank_0 = -(l1 * (2.0943951023931953 - φ4_0).sin()
                / l2_sin_φ3_0_minus_φ4_0);
            let t5 = 2.0943951023931953 - φ3_0;
            let (t6, t7) = t5.sin_cos();
            // rate as assembled
            let ω4_left_crank_0 = -(l1 * t6 / l2_sin_φ3_0_minus_φ4_0);
            let t8 = C0 + C2 * (ω3_left_crank_0 * ω3_left_crank_0)
                + C3 * (ω4_left_crank_0 * ω4_left_crank_0);
            let l1_m2_r3 = l1 * m2 * r3;
            // constant of the inertia
            let C5 = l1_m2_r3 * 2.0;
            // constant of the inertia
            let C4 = C5 + l1 * l2 * mt * 2.0;
            // inertia as assembled
            let A_left_crank_0 = t8 + C4 * ω3_left_crank_0 * t7;
            let t9 = 1.0471975511965976 - φ4_0;
            let (t10, t11) = t9.sin_cos();
            // rate as assembled
            let ω3_right_crank_0 = l1 * t10 / l2_sin_φ3_0_minus_φ4_0;
            // rate as assembled
            let ω4_right_crank_0 = l1 * (1.0471975511965976 - φ3_0).sin()
                / l2_sin_φ3_0_minus_φ4_0;
            let t12 = C1 + C2 * (ω3_right_crank_0 * ω3_right_crank_0)
                + C3 * (ω4_right_crank_0 * ω4_right_crank_0);
            // inertia as assembled
            let A_right_crank_0 = t12 + l1_m2_r3 * ω4_right_crank_0 * t11 * 2.0;
            if !(l1 > 0.0) {
                return Err(FAILURES[0].diagnostic(&[l1]));
            }
            if !(m1 >= 0.0) {
                return Err(FAILURES[1].diagnostic(&[m1]));
            }
            if !(I1 >= 0.0) {
                return Err(FAILURES[2].diagnostic(&[I1]));
            }
            if !(l2 > 0.0) {
                return Err(FAILURES[3].diagnostic(&[l2]));
            }
            if !(m2 >= 0.0) {
                return Err(FAILURES[4].diagnostic(&[m2]));
            }
            if !(I3 >= 0.0) {
                return Err(FAILURES[5].diagnostic(&[I3]));
            }
            if !(mt >= 0.0) {
                return Err(FAILURES[6].diagnostic(&[mt]));
            }
            if !(t2 >= 0.0) {
                let sqrt_D_0 = D_0.sqrt();
                return Err(
                    FAILURES[7]
                        .diagnostic(
                            &[
                                (sqrt_D_0 - l2 * 2.0).larger(-sqrt_D_0),
                                (l2 - sqrt_D_0).abs(),
                                l2 + sqrt_D_0,
                                2.0943951023931953,
                            ],
                        ),
                );
            }
            if !(t2 - 1e-12 > 0.0) {
                let sqrt_D_0_2 = D_0.sqrt();
                return Err(
                    FAILURES[8]
                        .diagnostic(
                            &[
                                (sqrt_D_0_2 - l2 * 2.0).larger(-sqrt_D_0_2),
                                (l2 - sqrt_D_0_2).abs(),
                                l2 + sqrt_D_0_2,
                                2.0943951023931953,
                            ],
                        ),
                );
            }
            if !(A_left_crank_0 > 0.0) {
                return Err(FAILURES[9].diagnostic(&[]));
            }
            if !(A_right_crank_0 > 0.0) {
                return Err(FAILURES[10].diagnostic(&[]));
            }
            let prepared = Prepared {
                start_states: [2.0943951023931953, 0.0, 1.0471975511965976, 0.0],
                start_discretes: [0.0, 0.0],
                base,
                l1,
                l2,
                k,
                c,
                left_torque,
                right_torque,
                C1,
                C0,
                _4_l2_squared,
                half_s: s * 0.5,
                per_l2: l2.recip(),
                l1_per_l2: l1 / l2,
                C3,
                C2,
                C5,
                C4,
                half_C4: C4 * 0.5,
                half_C5: C5 * 0.5,
                c3_0,
                s3_0,
                c4_0,
                s4_0,
                constant1: f * 6.283185307179586,
                two_C2: C2 * 2.0,
                two_C3: C3 * 2.0,
                two_C4: C4 * 2.0,
                _3_C5: C5 * 3.0,
                two_C5: C5 * 2.0,
                _3_C4: C4 * 3.0,
                half_k: k * 0.5,
                constant2: 0.25 / l2_squared_squared,
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
        pub start_discretes: [T; 2],
        /// `base`
        pub base: T,
        /// `l1`
        pub l1: T,
        /// `l2`
        pub l2: T,
        /// `k`
        pub k: T,
        /// `c`
        pub c: T,
        /// `left_torque`
        pub left_torque: T,
        /// `right_torque`
        pub right_torque: T,
        /// `C1` constant of the inertia
        pub C1: T,
        /// `C0` constant of the inertia
        pub C0: T,
        /// `4.0 * l2 * l2`
        pub _4_l2_squared: T,
        /// `0.5 * s`
        pub half_s: T,
        /// `1.0 / l2`
        pub per_l2: T,
        /// `l1 / l2`
        pub l1_per_l2: T,
        /// `C3` constant of the inertia
        pub C3: T,
        /// `C2` constant of the inertia
        pub C2: T,
        /// `C5` constant of the inertia
        pub C5: T,
        /// `C4` constant of the inertia
        pub C4: T,
        /// `0.5 * C4`
        pub half_C4: T,
        /// `0.5 * C5`
        pub half_C5: T,
        /// `c3⁰`
        pub c3_0: T,
        /// `s3⁰`
        pub s3_0: T,
        /// `c4⁰`
        pub c4_0: T,
        /// `s4⁰`
        pub s4_0: T,
        /// `6.283185307179586 * f`
        pub constant1: T,
        /// `2.0 * C2`
        pub two_C2: T,
        /// `2.0 * C3`
        pub two_C3: T,
        /// `2.0 * C4`
        pub two_C4: T,
        /// `3.0 * C5`
        pub _3_C5: T,
        /// `2.0 * C5`
        pub two_C5: T,
        /// `3.0 * C4`
        pub _3_C4: T,
        /// `0.5 * k`
        pub half_k: T,
        /// `0.25 / (l2 * l2 * l2 * l2)`
        pub constant2: T,
    }
    impl<T: Copy> Prepared<T> {
        /// The same with every number turned into another: for dual numbers or lanes.
        pub fn map<U>(&self, turn: impl Fn(T) -> U) -> Prepared<U> {
            Prepared {
                start_states: self.start_states.map(&turn),
                start_discretes: self.start_discretes.map(&turn),
                base: turn(self.base),
                l1: turn(self.l1),
                l2: turn(self.l2),
                k: turn(self.k),
                c: turn(self.c),
                left_torque: turn(self.left_torque),
                right_torque: turn(self.right_torque),
                C1: turn(self.C1),
                C0: turn(self.C0),
                _4_l2_squared: turn(self._4_l2_squared),
                half_s: turn(self.half_s),
                per_l2: turn(self.per_l2),
                l1_per_l2: turn(self.l1_per_l2),
                C3: turn(self.C3),
                C2: turn(self.C2),
                C5: turn(self.C5),
                C4: turn(self.C4),
                half_C4: turn(self.half_C4),
                half_C5: turn(self.half_C5),
                c3_0: turn(self.c3_0),
                s3_0: turn(self.s3_0),
                c4_0: turn(self.c4_0),
                s4_0: turn(self.s4_0),
                constant1: turn(self.constant1),
                two_C2: turn(self.two_C2),
                two_C3: turn(self.two_C3),
                two_C4: turn(self.two_C4),
                _3_C5: turn(self._3_C5),
                two_C5: turn(self.two_C5),
                _3_C4: turn(self._3_C4),
                half_k: turn(self.half_k),
                constant2: turn(self.constant2),
            }
        }
    }
    /// dx/dt. Where a loop cannot close, entries are not numbers.
    #[inline(always)]
    pub fn rhs<T: Real>(
        t: T,
        x: &[T; 4],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        dx: &mut [T; 4],
    ) {
        let φ1 = x[0];
        let dφ1 = x[1];
        let φ2 = x[2];
        let dφ2 = x[3];
        let turn_left_coupler = d[0];
        let turn_right_coupler = d[1];
        // ── configuration ──
        let (sin_φ2, cos_φ2) = φ2.sin_cos();
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let Y = p.l1 * sin_φ2 - p.l1 * sin_φ1;
        let half_Y = Y * 0.5;
        // vector that is left to close left_crank–left_coupler–right_coupler–right_crank
        let X = p.base + p.l1 * cos_φ2 - p.l1 * cos_φ1;
        // its length squared
        let D = X * X + Y * Y;
        let η = p.half_s * (D.recip() * (D * (p._4_l2_squared - D)).sqrt());
        let X_η = X * η;
        let s3 = p.per_l2 * (half_Y + X_η);
        let half_X = X * 0.5;
        let Y_η = Y * η;
        let c4 = -(p.per_l2 * (X - half_X + Y_η));
        let c3 = p.per_l2 * (half_X - Y_η);
        let s4 = p.per_l2 * (half_Y - Y + X_η);
        let sin_φ3_minus_φ4 = s3 * c4 - c3 * s4;
        let per_sin_φ3_minus_φ4 = sin_φ3_minus_φ4.recip();
        let sin_φ1_minus_φ4 = sin_φ1 * c4 - cos_φ1 * s4;
        let t1 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ1_minus_φ4);
        // rate of the angle of `left_coupler` per unit rate of `left_crank`
        let ω3_left_crank = -t1;
        let sin_φ1_minus_φ3 = sin_φ1 * c3 - cos_φ1 * s3;
        let t2 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ1_minus_φ3);
        // rate of the angle of `right_coupler` per unit rate of `left_crank`
        let ω4_left_crank = -t2;
        let ω4_left_crank_squared = ω4_left_crank * ω4_left_crank;
        let t3 = p.C0 + p.C2 * (ω3_left_crank * ω3_left_crank)
            + p.C3 * ω4_left_crank_squared;
        let cos_φ1_minus_φ3 = cos_φ1 * c3 + sin_φ1 * s3;
        // inertia
        let M_left_crank = t3 + p.C4 * (ω3_left_crank * cos_φ1_minus_φ3);
        let sin_φ2_minus_φ4 = sin_φ2 * c4 - cos_φ2 * s4;
        // rate of the angle of `left_coupler` per unit rate of `right_crank`
        let ω3_right_crank = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ2_minus_φ4);
        let ω3_right_crank_squared = ω3_right_crank * ω3_right_crank;
        let sin_φ2_minus_φ3 = sin_φ2 * c3 - cos_φ2 * s3;
        // rate of the angle of `right_coupler` per unit rate of `right_crank`
        let ω4_right_crank = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ2_minus_φ3);
        let t4 = p.C1 + p.C2 * ω3_right_crank_squared
            + p.C3 * (ω4_right_crank * ω4_right_crank);
        let cos_φ2_minus_φ4 = cos_φ2 * c4 + sin_φ2 * s4;
        // inertia
        let M_right_crank = t4 + p.C5 * (ω4_right_crank * cos_φ2_minus_φ4);
        let t5 = p.C2 * (ω3_left_crank * ω3_right_crank)
            + p.C3 * (ω4_left_crank * ω4_right_crank);
        let t6 = ω3_right_crank * cos_φ1_minus_φ3;
        let t7 = ω4_left_crank * cos_φ2_minus_φ4;
        // inertia
        let M_left_crank_right_crank = t5 + p.half_C4 * t6 + p.half_C5 * t7;
        // determinant of the inertia
        let t8 = M_left_crank * M_right_crank
            - M_left_crank_right_crank * M_left_crank_right_crank;
        let t9 = t8.recip();
        let ω3_left_crank_minus_one = ω3_left_crank - 1.0;
        let t10 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `left_coupler` from the assembled one
        let φ3_minus_φ3_0 = t10.unwrap_to(turn_left_coupler);
        let t11 = T::from_f64(2.0943951023931953) - φ1 + φ3_minus_φ3_0;
        let t12 = p.k * (φ1 - 2.0943951023931953)
            + p.k * (ω3_left_crank_minus_one * t11);
        let t13 = (p.c4_0 * s4 - p.s4_0 * c4).atan2(p.c4_0 * c4 + p.s4_0 * s4);
        // angle of `right_coupler` from the assembled one
        let φ4_minus_φ4_0 = t13.unwrap_to(turn_right_coupler);
        let t14 = T::from_f64(1.0471975511965976) - φ2 + φ4_minus_φ4_0;
        let t15 = t2 - t1;
        let t16 = φ3_minus_φ3_0 - φ4_minus_φ4_0;
        // springs
        let dP_s_dφ1 = t12 + p.k * (ω4_left_crank * t14) + p.k * (t15 * t16);
        let ω4_right_crank_minus_one = ω4_right_crank - 1.0;
        let t17 = ω3_right_crank - ω4_right_crank;
        let cos_φ1_minus_φ4 = cos_φ1 * c4 + sin_φ1 * s4;
        let cos_φ3_minus_φ4 = c3 * c4 + s3 * s4;
        let t18 = p.l1 * (ω4_right_crank * cos_φ1_minus_φ4)
            - p.l2 * (ω3_left_crank * cos_φ3_minus_φ4 * t17);
        let dω3_left_crank_dφ2 = p.per_l2 * (per_sin_φ3_minus_φ4 * t18);
        let t19 = per_sin_φ3_minus_φ4
            * (p.l1 * t6 - p.l2 * (ω4_left_crank * cos_φ3_minus_φ4 * t17));
        let dω4_left_crank_dφ2 = p.per_l2 * t19;
        let t20 = p.two_C2 * (ω3_left_crank * dω3_left_crank_dφ2)
            + p.two_C3 * (ω4_left_crank * dω4_left_crank_dφ2);
        let t21 = sin_φ1_minus_φ3 * ω3_left_crank;
        let dM_left_crank_dφ2 = t20 + p.C4 * (dω3_left_crank_dφ2 * cos_φ1_minus_φ3)
            + p.C4 * (t21 * ω3_right_crank);
        let t22 = p.l1 * (cos_φ1_minus_φ4 * (ω4_left_crank - 1.0))
            - p.l2 * (ω3_left_crank * t15 * cos_φ3_minus_φ4);
        let dω3_left_crank_dφ1 = p.per_l2 * (per_sin_φ3_minus_φ4 * t22);
        let t23 = p.C2 * (ω3_right_crank * dω3_left_crank_dφ1);
        let t24 = per_sin_φ3_minus_φ4
            * (p.l1 * t7 + p.l2 * (ω3_right_crank * t15 * cos_φ3_minus_φ4));
        let dω3_right_crank_dφ1 = -(p.per_l2 * t24);
        let t25 = p.C2 * (ω3_left_crank * dω3_right_crank_dφ1);
        let t26 = p.l1 * (cos_φ1_minus_φ3 * ω3_left_crank_minus_one)
            - p.l2 * (ω4_left_crank * t15 * cos_φ3_minus_φ4);
        let dω4_left_crank_dφ1 = p.per_l2 * (per_sin_φ3_minus_φ4 * t26);
        let t27 = p.C3 * (ω4_right_crank * dω4_left_crank_dφ1);
        let cos_φ2_minus_φ3 = cos_φ2 * c3 + sin_φ2 * s3;
        let t28 = p.l1 * (ω3_left_crank * cos_φ2_minus_φ3)
            + p.l2 * (ω4_right_crank * t15 * cos_φ3_minus_φ4);
        let dω4_right_crank_dφ1 = -(p.per_l2 * (per_sin_φ3_minus_φ4 * t28));
        let t29 = p.C3 * (ω4_left_crank * dω4_right_crank_dφ1);
        let t30 = p.C4
            * (sin_φ1_minus_φ3 * ω3_right_crank * ω3_left_crank_minus_one);
        let t31 = (p.C4 * (cos_φ1_minus_φ3 * dω3_right_crank_dφ1) + t30) * 0.5;
        let t32 = p.C5 * (dω4_left_crank_dφ1 * cos_φ2_minus_φ4)
            + p.C5 * (ω4_left_crank_squared * sin_φ2_minus_φ4);
        let t33 = t32 * 0.5;
        let t34 = t23 + t25 + t27 + t29 + t31 + t33;
        let t35 = t34 * 0.5;
        let t36 = p.l1 * (cos_φ2_minus_φ4 * ω4_right_crank_minus_one)
            + p.l2 * (ω3_right_crank * cos_φ3_minus_φ4 * t17);
        let dω3_right_crank_dφ2 = -(p.per_l2 * (per_sin_φ3_minus_φ4 * t36));
        let t37 = p.C2 * (ω3_right_crank * dω3_left_crank_dφ2)
            + p.C2 * (ω3_left_crank * dω3_right_crank_dφ2);
        let t38 = p.l1 * (cos_φ2_minus_φ3 * (ω3_right_crank - 1.0))
            + p.l2 * (ω4_right_crank * cos_φ3_minus_φ4 * t17);
        let dω4_right_crank_dφ2 = -(p.per_l2 * (per_sin_φ3_minus_φ4 * t38));
        let t39 = t37 + p.C3 * (ω4_right_crank * dω4_left_crank_dφ2)
            + p.C3 * (ω4_left_crank * dω4_right_crank_dφ2);
        let t40 = p.C4 * (cos_φ1_minus_φ3 * dω3_right_crank_dφ2)
            + p.C4 * (sin_φ1_minus_φ3 * ω3_right_crank_squared);
        let t41 = ω4_left_crank * sin_φ2_minus_φ4;
        let t42 = p.C5 * (dω4_left_crank_dφ2 * cos_φ2_minus_φ4)
            + p.C5 * (t41 * ω4_right_crank_minus_one);
        let t43 = t39 + t40 * 0.5 + t42 * 0.5;
        let t44 = p.two_C2 * (ω3_right_crank * dω3_right_crank_dφ1);
        let t45 = p.two_C3 * (ω4_right_crank * dω4_right_crank_dφ1);
        let t46 = p.C5 * (cos_φ2_minus_φ4 * dω4_right_crank_dφ1);
        let t47 = p.C5 * (t41 * ω4_right_crank);
        let dM_right_crank_dφ1 = t44 + t45 + t46 + t47;
        let t48 = p.two_C2 * (ω3_left_crank * dω3_left_crank_dφ1)
            + p.two_C3 * (ω4_left_crank * dω4_left_crank_dφ1);
        let dM_left_crank_dφ1 = t48 + p.C4 * (dω3_left_crank_dφ1 * cos_φ1_minus_φ3)
            + p.C4 * (t21 * ω3_left_crank_minus_one);
        let t49 = p.k * (φ2 - 1.0471975511965976) + p.k * (ω3_right_crank * t11)
            + p.k * (ω4_right_crank_minus_one * t14);
        // springs
        let dP_s_dφ2 = t49 + p.k * (t17 * t16);
        let t50 = t43 * 0.5;
        let t51 = p.two_C2 * (ω3_right_crank * dω3_right_crank_dφ2)
            + p.two_C3 * (ω4_right_crank * dω4_right_crank_dφ2);
        let t52 = p.C5
            * (sin_φ2_minus_φ4 * ω4_right_crank * ω4_right_crank_minus_one);
        let dM_right_crank_dφ2 = t51
            + p.C5 * (cos_φ2_minus_φ4 * dω4_right_crank_dφ2) + t52;
        // ── state ──
        let t53 = p.constant1 * t;
        let (t54, t55) = t53.sin_cos();
        let t56 = ω3_left_crank_minus_one * dφ1 + ω3_right_crank * dφ2;
        let t57 = p.left_torque * t54 - p.c * dφ1
            - p.c * ω3_left_crank_minus_one * t56;
        let t58 = ω4_left_crank * dφ1 + ω4_right_crank_minus_one * dφ2;
        let t59 = t15 * dφ1 + t17 * dφ2;
        // generalized torque of all other forces
        let τ_1 = t57 - p.c * ω4_left_crank * t58 - p.c * t15 * t59;
        let dφ1_dφ2 = dφ1 * dφ2;
        let dφ2_squared = dφ2 * dφ2;
        let t60 = (dM_left_crank_dφ2 - t35) * dφ1_dφ2
            + (t43 - dM_right_crank_dφ1 * 0.5) * dφ2_squared;
        let dφ1_squared = dφ1 * dφ1;
        // centrifugal and Coriolis terms
        let h_left_crank = t60 + dM_left_crank_dφ1 * 0.5 * dφ1_squared
            + t35 * dφ1_dφ2;
        let t61 = dP_s_dφ1 - τ_1 + h_left_crank;
        let t62 = p.right_torque * t55 - p.c * dφ2 - p.c * ω3_right_crank * t56;
        // generalized torque of all other forces
        let τ_2 = t62 - p.c * ω4_right_crank_minus_one * t58 - p.c * t17 * t59;
        let t63 = (t23 - dM_left_crank_dφ2 * 0.5 + t25 + t27 + t29 + t31 + t33)
            * dφ1_squared;
        // centrifugal and Coriolis terms
        let h_right_crank = t63 + (t44 - t50 + t45 + t46 + t47) * dφ1_dφ2
            + t50 * dφ1_dφ2 + dM_right_crank_dφ2 * 0.5 * dφ2_squared;
        let t64 = dP_s_dφ2 - τ_2 + h_right_crank;
        let ddφ1 = -(t9 * (M_right_crank * t61 - M_left_crank_right_crank * t64));
        let ddφ2 = -(t9 * (M_left_crank * t64 - M_left_crank_right_crank * t61));
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
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 16],
    ) {
        let φ1 = x[0];
        let dφ1 = x[1];
        let φ2 = x[2];
        let dφ2 = x[3];
        let turn_left_coupler = d[0];
        let turn_right_coupler = d[1];
        // ── configuration ──
        let (sin_φ2, cos_φ2) = φ2.sin_cos();
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let Y = p.l1 * sin_φ2 - p.l1 * sin_φ1;
        let half_Y = Y * 0.5;
        // vector that is left to close left_crank–left_coupler–right_coupler–right_crank
        let X = p.base + p.l1 * cos_φ2 - p.l1 * cos_φ1;
        // its length squared
        let D = X * X + Y * Y;
        let η = p.half_s * (D.recip() * (D * (p._4_l2_squared - D)).sqrt());
        let X_η = X * η;
        let s3 = p.per_l2 * (half_Y + X_η);
        let half_X = X * 0.5;
        let Y_η = Y * η;
        let c4 = -(p.per_l2 * (X - half_X + Y_η));
        let c3 = p.per_l2 * (half_X - Y_η);
        let s4 = p.per_l2 * (half_Y - Y + X_η);
        let sin_φ3_minus_φ4 = s3 * c4 - c3 * s4;
        let per_sin_φ3_minus_φ4 = sin_φ3_minus_φ4.recip();
        let sin_φ1_minus_φ4 = sin_φ1 * c4 - cos_φ1 * s4;
        let t1 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ1_minus_φ4);
        // rate of the angle of `left_coupler` per unit rate of `left_crank`
        let ω3_left_crank = -t1;
        let ω3_left_crank_squared = ω3_left_crank * ω3_left_crank;
        let sin_φ1_minus_φ3 = sin_φ1 * c3 - cos_φ1 * s3;
        let t2 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ1_minus_φ3);
        // rate of the angle of `right_coupler` per unit rate of `left_crank`
        let ω4_left_crank = -t2;
        let ω4_left_crank_squared = ω4_left_crank * ω4_left_crank;
        let t3 = p.C0 + p.C2 * ω3_left_crank_squared + p.C3 * ω4_left_crank_squared;
        let cos_φ1_minus_φ3 = cos_φ1 * c3 + sin_φ1 * s3;
        let t4 = ω3_left_crank * cos_φ1_minus_φ3;
        // inertia
        let M_left_crank = t3 + p.C4 * t4;
        let sin_φ2_minus_φ4 = sin_φ2 * c4 - cos_φ2 * s4;
        // rate of the angle of `left_coupler` per unit rate of `right_crank`
        let ω3_right_crank = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ2_minus_φ4);
        let ω3_right_crank_squared = ω3_right_crank * ω3_right_crank;
        let sin_φ2_minus_φ3 = sin_φ2 * c3 - cos_φ2 * s3;
        // rate of the angle of `right_coupler` per unit rate of `right_crank`
        let ω4_right_crank = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ2_minus_φ3);
        let ω4_right_crank_squared = ω4_right_crank * ω4_right_crank;
        let t5 = p.C1 + p.C2 * ω3_right_crank_squared + p.C3 * ω4_right_crank_squared;
        let cos_φ2_minus_φ4 = cos_φ2 * c4 + sin_φ2 * s4;
        let t6 = ω4_right_crank * cos_φ2_minus_φ4;
        // inertia
        let M_right_crank = t5 + p.C5 * t6;
        let t7 = ω3_left_crank * ω3_right_crank;
        let t8 = ω4_left_crank * ω4_right_crank;
        let t9 = ω3_right_crank * cos_φ1_minus_φ3;
        let t10 = ω4_left_crank * cos_φ2_minus_φ4;
        // inertia
        let M_left_crank_right_crank = p.C2 * t7 + p.C3 * t8 + p.half_C4 * t9
            + p.half_C5 * t10;
        // determinant of the inertia
        let t11 = M_left_crank * M_right_crank
            - M_left_crank_right_crank * M_left_crank_right_crank;
        let t12 = (t11 * t11).recip();
        let cos_φ1_minus_φ4 = cos_φ1 * c4 + sin_φ1 * s4;
        let ω4_left_crank_minus_one = ω4_left_crank - 1.0;
        let t13 = t2 - t1;
        let cos_φ3_minus_φ4 = c3 * c4 + s3 * s4;
        let t14 = p.l1 * (cos_φ1_minus_φ4 * ω4_left_crank_minus_one)
            - p.l2 * (ω3_left_crank * t13 * cos_φ3_minus_φ4);
        let dω3_left_crank_dφ1 = p.per_l2 * (per_sin_φ3_minus_φ4 * t14);
        let ω3_left_crank_minus_one = ω3_left_crank - 1.0;
        let t15 = p.l1 * (cos_φ1_minus_φ3 * ω3_left_crank_minus_one)
            - p.l2 * (ω4_left_crank * t13 * cos_φ3_minus_φ4);
        let dω4_left_crank_dφ1 = p.per_l2 * (per_sin_φ3_minus_φ4 * t15);
        let t16 = p.two_C2 * (ω3_left_crank * dω3_left_crank_dφ1)
            + p.two_C3 * (ω4_left_crank * dω4_left_crank_dφ1);
        let t17 = dω3_left_crank_dφ1 * cos_φ1_minus_φ3;
        let t18 = sin_φ1_minus_φ3 * ω3_left_crank;
        let dM_left_crank_dφ1 = t16 + p.C4 * t17
            + p.C4 * (t18 * ω3_left_crank_minus_one);
        let t19 = p.l1 * t10 + p.l2 * (ω3_right_crank * t13 * cos_φ3_minus_φ4);
        let t20 = p.per_l2 * (per_sin_φ3_minus_φ4 * t19);
        let dω3_right_crank_dφ1 = -t20;
        let t21 = p.two_C2 * (ω3_right_crank * dω3_right_crank_dφ1);
        let cos_φ2_minus_φ3 = cos_φ2 * c3 + sin_φ2 * s3;
        let t22 = p.l1 * (ω3_left_crank * cos_φ2_minus_φ3)
            + p.l2 * (ω4_right_crank * t13 * cos_φ3_minus_φ4);
        let t23 = p.per_l2 * (per_sin_φ3_minus_φ4 * t22);
        let dω4_right_crank_dφ1 = -t23;
        let t24 = p.two_C3 * (ω4_right_crank * dω4_right_crank_dφ1);
        let t25 = cos_φ2_minus_φ4 * dω4_right_crank_dφ1;
        let t26 = p.C5 * t25;
        let t27 = ω4_left_crank * sin_φ2_minus_φ4;
        let t28 = p.C5 * (t27 * ω4_right_crank);
        let dM_right_crank_dφ1 = t21 + t24 + t26 + t28;
        let t29 = M_right_crank * dM_left_crank_dφ1
            + M_left_crank * dM_right_crank_dφ1;
        let t30 = p.C2 * (ω3_right_crank * dω3_left_crank_dφ1);
        let t31 = p.C2 * (ω3_left_crank * dω3_right_crank_dφ1);
        let t32 = p.C3 * (ω4_right_crank * dω4_left_crank_dφ1);
        let t33 = p.C3 * (ω4_left_crank * dω4_right_crank_dφ1);
        let t34 = cos_φ1_minus_φ3 * dω3_right_crank_dφ1;
        let t35 = sin_φ1_minus_φ3 * ω3_right_crank;
        let t36 = t35 * ω3_left_crank_minus_one;
        let t37 = (p.C4 * t34 + p.C4 * t36) * 0.5;
        let t38 = dω4_left_crank_dφ1 * cos_φ2_minus_φ4;
        let t39 = ω4_left_crank_squared * sin_φ2_minus_φ4;
        let t40 = (p.C5 * t38 + p.C5 * t39) * 0.5;
        let t41 = t30 + t31 + t32 + t33 + t37 + t40;
        let t42 = t29 - M_left_crank_right_crank * t41 * 2.0;
        let t43 = t12 * t42;
        let t44 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `left_coupler` from the assembled one
        let φ3_minus_φ3_0 = t44.unwrap_to(turn_left_coupler);
        let t45 = T::from_f64(2.0943951023931953) - φ1 + φ3_minus_φ3_0;
        let t46 = p.k * (φ1 - 2.0943951023931953)
            + p.k * (ω3_left_crank_minus_one * t45);
        let t47 = (p.c4_0 * s4 - p.s4_0 * c4).atan2(p.c4_0 * c4 + p.s4_0 * s4);
        // angle of `right_coupler` from the assembled one
        let φ4_minus_φ4_0 = t47.unwrap_to(turn_right_coupler);
        let t48 = T::from_f64(1.0471975511965976) - φ2 + φ4_minus_φ4_0;
        let t49 = φ3_minus_φ3_0 - φ4_minus_φ4_0;
        // springs
        let dP_s_dφ1 = t46 + p.k * (ω4_left_crank * t48) + p.k * (t13 * t49);
        let t50 = p.c * ω3_left_crank_minus_one;
        let c_ω4_left_crank = p.c * ω4_left_crank;
        let ω4_right_crank_minus_one = ω4_right_crank - 1.0;
        let t51 = p.c * t13;
        let t52 = ω3_right_crank - ω4_right_crank;
        let t53 = ω3_left_crank * cos_φ3_minus_φ4;
        let t54 = p.l1 * (ω4_right_crank * cos_φ1_minus_φ4) - p.l2 * (t53 * t52);
        let dω3_left_crank_dφ2 = p.per_l2 * (per_sin_φ3_minus_φ4 * t54);
        let t55 = ω4_left_crank * cos_φ3_minus_φ4;
        let t56 = p.l1 * t9 - p.l2 * (t55 * t52);
        let dω4_left_crank_dφ2 = p.per_l2 * (per_sin_φ3_minus_φ4 * t56);
        let t57 = p.two_C2 * (ω3_left_crank * dω3_left_crank_dφ2)
            + p.two_C3 * (ω4_left_crank * dω4_left_crank_dφ2);
        let t58 = dω3_left_crank_dφ2 * cos_φ1_minus_φ3;
        let dM_left_crank_dφ2 = t57 + p.C4 * t58 + p.C4 * (t18 * ω3_right_crank);
        let t59 = t41 * 0.5;
        let t60 = dM_left_crank_dφ2 - t59;
        let t61 = ω3_right_crank * cos_φ3_minus_φ4;
        let t62 = p.l1 * (cos_φ2_minus_φ4 * ω4_right_crank_minus_one)
            + p.l2 * (t61 * t52);
        let t63 = p.per_l2 * (per_sin_φ3_minus_φ4 * t62);
        let dω3_right_crank_dφ2 = -t63;
        let t64 = p.C2 * (ω3_right_crank * dω3_left_crank_dφ2)
            + p.C2 * (ω3_left_crank * dω3_right_crank_dφ2);
        let ω3_right_crank_minus_one = ω3_right_crank - 1.0;
        let t65 = ω4_right_crank * cos_φ3_minus_φ4;
        let t66 = p.l1 * (cos_φ2_minus_φ3 * ω3_right_crank_minus_one)
            + p.l2 * (t65 * t52);
        let t67 = p.per_l2 * (per_sin_φ3_minus_φ4 * t66);
        let dω4_right_crank_dφ2 = -t67;
        let t68 = t64 + p.C3 * (ω4_right_crank * dω4_left_crank_dφ2)
            + p.C3 * (ω4_left_crank * dω4_right_crank_dφ2);
        let t69 = cos_φ1_minus_φ3 * dω3_right_crank_dφ2;
        let t70 = sin_φ1_minus_φ3 * ω3_right_crank_squared;
        let t71 = dω4_left_crank_dφ2 * cos_φ2_minus_φ4;
        let t72 = t27 * ω4_right_crank_minus_one;
        let t73 = t68 + (p.C4 * t69 + p.C4 * t70) * 0.5
            + (p.C5 * t71 + p.C5 * t72) * 0.5;
        let t74 = t73 - dM_right_crank_dφ1 * 0.5;
        let t75 = p.k * (φ2 - 1.0471975511965976) + p.k * (ω3_right_crank * t45)
            + p.k * (ω4_right_crank_minus_one * t48);
        // springs
        let dP_s_dφ2 = t75 + p.k * (t52 * t49);
        let c_ω3_right_crank = p.c * ω3_right_crank;
        let t76 = p.c * ω4_right_crank_minus_one;
        let t77 = p.c * t52;
        let t78 = t30 - dM_left_crank_dφ2 * 0.5 + t31 + t32 + t33 + t37 + t40;
        let t79 = t73 * 0.5;
        let t80 = t21 - t79 + t24 + t26 + t28;
        let t81 = p.two_C2 * (ω3_right_crank * dω3_right_crank_dφ2)
            + p.two_C3 * (ω4_right_crank * dω4_right_crank_dφ2);
        let t82 = cos_φ2_minus_φ4 * dω4_right_crank_dφ2;
        let t83 = sin_φ2_minus_φ4 * ω4_right_crank;
        let dM_right_crank_dφ2 = t81 + p.C5 * t82
            + p.C5 * (t83 * ω4_right_crank_minus_one);
        let t84 = t11.recip();
        let t85 = ω3_left_crank_minus_one * ω3_left_crank_minus_one;
        let t86 = p.k + p.k * (dω3_left_crank_dφ1 * t45) + p.k * t85
            + p.k * (dω4_left_crank_dφ1 * t48);
        let t87 = dω3_left_crank_dφ1 - dω4_left_crank_dφ1;
        let t88 = t13 * t13;
        let ddP_s_dφ1_dφ1 = t86 + p.k * ω4_left_crank_squared + p.k * (t49 * t87)
            + p.k * t88;
        let t89 = t23 - t20;
        let t90 = p.C2 * (dω3_left_crank_dφ1 * dω3_left_crank_dφ2);
        let t91 = p.l1
            * (sin_φ1_minus_φ4 * ω4_right_crank * ω4_left_crank_minus_one);
        let t92 = p.l1 * (cos_φ1_minus_φ4 * dω4_right_crank_dφ1) + t91
            - p.l2 * (cos_φ3_minus_φ4 * dω3_left_crank_dφ1 * t52);
        let t93 = sin_φ3_minus_φ4 * ω3_left_crank;
        let t94 = p.l2 * (t93 * t13 * t52);
        let t95 = p.per_l2 * (per_sin_φ3_minus_φ4 * (t92 - p.l2 * (t53 * t89) + t94));
        let t96 = (sin_φ3_minus_φ4 * sin_φ3_minus_φ4).recip();
        let t97 = t96 * t13 * cos_φ3_minus_φ4;
        let ddω3_left_crank_dφ2_dφ1 = t95 - p.per_l2 * (t97 * t54);
        let t98 = p.C3 * (dω4_left_crank_dφ1 * dω4_left_crank_dφ2);
        let t99 = p.l1 * t36;
        let t100 = cos_φ3_minus_φ4 * t52;
        let t101 = p.l1 * t34 + t99 - p.l2 * (t100 * dω4_left_crank_dφ1)
            - p.l2 * (t55 * t89);
        let t102 = sin_φ3_minus_φ4 * ω4_left_crank;
        let t103 = p.l2 * (t102 * t13 * t52);
        let ddω4_left_crank_dφ2_dφ1 = p.per_l2
            * (per_sin_φ3_minus_φ4 * (t101 + t103)) - p.per_l2 * (t97 * t56);
        let t104 = (t90 + p.C2 * (ω3_left_crank * ddω3_left_crank_dφ2_dφ1)) * 2.0
            + (t98 + p.C3 * (ω4_left_crank * ddω4_left_crank_dφ2_dφ1)) * 2.0;
        let t105 = p.C4
            * (sin_φ1_minus_φ3 * dω3_left_crank_dφ2 * ω3_left_crank_minus_one);
        let t106 = p.C4 * (t35 * dω3_left_crank_dφ1);
        let t107 = t104 + p.C4 * (cos_φ1_minus_φ3 * ddω3_left_crank_dφ2_dφ1) + t105
            + t106;
        let t108 = p.C4 * (t7 * cos_φ1_minus_φ3 * ω3_left_crank_minus_one);
        let t109 = t107 + p.C4 * (t18 * dω3_right_crank_dφ1) - t108;
        let t110 = sin_φ1_minus_φ4
            * (ω4_left_crank_minus_one * ω4_left_crank_minus_one);
        let t111 = t13 * cos_φ3_minus_φ4;
        let t112 = p.l1 * t110 + p.l1 * (cos_φ1_minus_φ4 * dω4_left_crank_dφ1)
            - p.l2 * (t111 * dω3_left_crank_dφ1);
        let t113 = per_sin_φ3_minus_φ4
            * (t112 - p.l2 * (t53 * t87) + p.l2 * (t93 * t88));
        let ddω3_left_crank_dφ1_dφ1 = p.per_l2 * t113 - p.per_l2 * (t97 * t14);
        let t114 = p.two_C2 * (dω3_left_crank_dφ1 * dω3_right_crank_dφ1)
            + p.C2 * (ω3_right_crank * ddω3_left_crank_dφ1_dφ1);
        let t115 = p.l1 * t38 + p.l1 * t39 + p.l2 * (t111 * dω3_right_crank_dφ1);
        let t116 = sin_φ3_minus_φ4 * ω3_right_crank;
        let t117 = per_sin_φ3_minus_φ4
            * (t115 + p.l2 * (t61 * t87) - p.l2 * (t116 * t88));
        let ddω3_right_crank_dφ1_dφ1 = p.per_l2 * (t97 * t19) - p.per_l2 * t117;
        let t118 = t114 + p.C2 * (ω3_left_crank * ddω3_right_crank_dφ1_dφ1)
            + p.two_C3 * (dω4_left_crank_dφ1 * dω4_right_crank_dφ1);
        let t119 = p.l1 * (sin_φ1_minus_φ3 * t85) + p.l1 * t17
            - p.l2 * (t111 * dω4_left_crank_dφ1);
        let t120 = per_sin_φ3_minus_φ4
            * (t119 - p.l2 * (t55 * t87) + p.l2 * (t102 * t88));
        let ddω4_left_crank_dφ1_dφ1 = p.per_l2 * t120 - p.per_l2 * (t97 * t15);
        let t121 = p.l1 * (dω3_left_crank_dφ1 * cos_φ2_minus_φ3)
            + p.l1 * (ω3_left_crank_squared * sin_φ2_minus_φ3);
        let t122 = sin_φ3_minus_φ4 * ω4_right_crank;
        let t123 = t121 + p.l2 * (t111 * dω4_right_crank_dφ1) + p.l2 * (t65 * t87)
            - p.l2 * (t122 * t88);
        let ddω4_right_crank_dφ1_dφ1 = p.per_l2 * (t97 * t22)
            - p.per_l2 * (per_sin_φ3_minus_φ4 * t123);
        let t124 = t118 + p.C3 * (ω4_right_crank * ddω4_left_crank_dφ1_dφ1)
            + p.C3 * (ω4_left_crank * ddω4_right_crank_dφ1_dφ1);
        let t125 = sin_φ1_minus_φ3 * ω3_left_crank_minus_one;
        let t126 = t106 + p.two_C4 * (t125 * dω3_right_crank_dφ1)
            + p.C4 * (cos_φ1_minus_φ3 * ddω3_right_crank_dφ1_dφ1);
        let t127 = p.C5 * (cos_φ2_minus_φ4 * ddω4_left_crank_dφ1_dφ1)
            + p._3_C5 * (t27 * dω4_left_crank_dφ1);
        let t128 = t127
            - p.C5 * (ω4_left_crank * ω4_left_crank_squared * cos_φ2_minus_φ4);
        let t129 = t124 + (t126 - p.C4 * (t9 * t85)) * 0.5 + t128 * 0.5;
        let t130 = t129 * 0.5;
        let t131 = p.C2 * (dω3_left_crank_dφ2 * dω3_right_crank_dφ1);
        let t132 = p.C2 * (dω3_left_crank_dφ1 * dω3_right_crank_dφ2);
        let t133 = p.l1 * t72;
        let t134 = t133 + p.l1 * t25 + p.l2 * (t100 * dω3_right_crank_dφ1)
            + p.l2 * (t61 * t89);
        let t135 = p.l2 * (t116 * t13 * t52);
        let ddω3_right_crank_dφ2_dφ1 = p.per_l2 * (t97 * t62)
            - p.per_l2 * (per_sin_φ3_minus_φ4 * (t134 - t135));
        let t136 = t131 + p.C2 * (ω3_right_crank * ddω3_left_crank_dφ2_dφ1) + t132
            + p.C2 * (ω3_left_crank * ddω3_right_crank_dφ2_dφ1);
        let t137 = p.C3 * (dω4_left_crank_dφ2 * dω4_right_crank_dφ1);
        let t138 = p.C3 * (dω4_left_crank_dφ1 * dω4_right_crank_dφ2);
        let t139 = t136 + t137 + p.C3 * (ω4_right_crank * ddω4_left_crank_dφ2_dφ1)
            + t138;
        let t140 = p.l1
            * (ω3_left_crank * sin_φ2_minus_φ3 * ω3_right_crank_minus_one);
        let t141 = t140 + p.l1 * (dω3_right_crank_dφ1 * cos_φ2_minus_φ3)
            + p.l2 * (t100 * dω4_right_crank_dφ1);
        let t142 = p.l2 * (t122 * t13 * t52);
        let t143 = p.per_l2
            * (per_sin_φ3_minus_φ4 * (t141 + p.l2 * (t65 * t89) - t142));
        let ddω4_right_crank_dφ2_dφ1 = p.per_l2 * (t97 * t66) - t143;
        let t144 = p.C4 * (t125 * dω3_right_crank_dφ2);
        let t145 = ω3_right_crank_squared * cos_φ1_minus_φ3
            * ω3_left_crank_minus_one;
        let t146 = p.C4 * t145;
        let t147 = t144 + p.C4 * (cos_φ1_minus_φ3 * ddω3_right_crank_dφ2_dφ1)
            - t146;
        let t148 = t35 * dω3_right_crank_dφ1;
        let t149 = t139 + p.C3 * (ω4_left_crank * ddω4_right_crank_dφ2_dφ1)
            + (t147 + p.two_C4 * t148) * 0.5;
        let t150 = t27 * dω4_left_crank_dφ2;
        let t151 = p.C5 * (cos_φ2_minus_φ4 * ddω4_left_crank_dφ2_dφ1) + p.C5 * t150;
        let t152 = p.C5
            * (sin_φ2_minus_φ4 * dω4_left_crank_dφ1 * ω4_right_crank_minus_one);
        let t153 = t27 * dω4_right_crank_dφ1;
        let t154 = ω4_left_crank_squared * cos_φ2_minus_φ4
            * ω4_right_crank_minus_one;
        let t155 = p.C5 * t154;
        let t156 = t149 + (t151 + t152 + p.C5 * t153 - t155) * 0.5;
        let t157 = p.C2 * (dω3_right_crank_dφ1 * dω3_right_crank_dφ1)
            + p.C2 * (ω3_right_crank * ddω3_right_crank_dφ1_dφ1);
        let t158 = p.C3 * (dω4_right_crank_dφ1 * dω4_right_crank_dφ1)
            + p.C3 * (ω4_right_crank * ddω4_right_crank_dφ1_dφ1);
        let t159 = p.two_C5 * t153 + t157 * 2.0 + t158 * 2.0
            + p.C5 * (cos_φ2_minus_φ4 * ddω4_right_crank_dφ1_dφ1);
        let t160 = p.C5 * (ω4_left_crank_squared * ω4_right_crank * cos_φ2_minus_φ4);
        let t161 = t159 + p.C5 * (t83 * dω4_left_crank_dφ1) - t160;
        let t162 = p.C2 * (dω3_left_crank_dφ1 * dω3_left_crank_dφ1)
            + p.C2 * (ω3_left_crank * ddω3_left_crank_dφ1_dφ1);
        let t163 = p.C3 * (dω4_left_crank_dφ1 * dω4_left_crank_dφ1)
            + p.C3 * (ω4_left_crank * ddω4_left_crank_dφ1_dφ1);
        let t164 = t162 * 2.0 + t163 * 2.0
            + p.C4 * (cos_φ1_minus_φ3 * ddω3_left_crank_dφ1_dφ1);
        let t165 = p.two_C4
            * (sin_φ1_minus_φ3 * dω3_left_crank_dφ1 * ω3_left_crank_minus_one);
        let t166 = t164 + t165 + p.C4 * (t18 * dω3_left_crank_dφ1) - p.C4 * (t4 * t85);
        let t167 = ω3_right_crank * ω3_left_crank_minus_one;
        let t168 = p.k * t167;
        let t169 = p.k * (dω3_right_crank_dφ1 * t45) + t168
            + p.k * (dω4_right_crank_dφ1 * t48);
        let t170 = ω4_left_crank * ω4_right_crank_minus_one;
        let t171 = p.k * t170;
        let t172 = t13 * t52;
        let t173 = p.k * t172;
        let ddP_s_dφ2_dφ1 = t169 + t171 + p.k * (t49 * t89) + t173;
        let t174 = t156 * 0.5;
        let t175 = p.C2 * (dω3_right_crank_dφ1 * dω3_right_crank_dφ2);
        let t176 = p.C3 * (dω4_right_crank_dφ1 * dω4_right_crank_dφ2);
        let t177 = (t175 + p.C2 * (ω3_right_crank * ddω3_right_crank_dφ2_dφ1)) * 2.0
            + (t176 + p.C3 * (ω4_right_crank * ddω4_right_crank_dφ2_dφ1)) * 2.0;
        let t178 = p.C5 * (t27 * dω4_right_crank_dφ2);
        let t179 = t177 + t178
            + p.C5 * (cos_φ2_minus_φ4 * ddω4_right_crank_dφ2_dφ1);
        let t180 = sin_φ2_minus_φ4 * ω4_right_crank_minus_one;
        let t181 = p.C5 * (t180 * dω4_right_crank_dφ1);
        let t182 = p.C5 * (t8 * cos_φ2_minus_φ4 * ω4_right_crank_minus_one);
        let t183 = p.c + p.c * t85 + p.c * ω4_left_crank_squared + p.c * t88;
        let dτ_1_ddφ1 = -t183;
        let dτ_2_ddφ1 = -(p.c * t167 + p.c * t170 + p.c * t172);
        let t184 = M_right_crank * dM_left_crank_dφ2
            + M_left_crank * dM_right_crank_dφ2;
        let t185 = t184 - M_left_crank_right_crank * t73 * 2.0;
        let t186 = t12 * t185;
        let t187 = t168 + t171 + t173 + p.k * (dω3_left_crank_dφ2 * t45)
            + p.k * (dω4_left_crank_dφ2 * t48);
        let t188 = dω3_left_crank_dφ2 - dω4_left_crank_dφ2;
        let ddP_s_dφ1_dφ2 = t187 + p.k * (t49 * t188);
        let t189 = t67 - t63;
        let t190 = p.l1 * (cos_φ1_minus_φ4 * dω4_right_crank_dφ2)
            + p.l1 * (sin_φ1_minus_φ4 * ω4_right_crank_squared);
        let t191 = t52 * t52;
        let t192 = t190 - p.l2 * (t100 * dω3_left_crank_dφ2) - p.l2 * (t53 * t189)
            + p.l2 * (t93 * t191);
        let t193 = t96 * cos_φ3_minus_φ4;
        let t194 = t193 * t52;
        let ddω3_left_crank_dφ2_dφ2 = p.per_l2 * (per_sin_φ3_minus_φ4 * t192)
            - p.per_l2 * (t194 * t54);
        let t195 = p.C2 * (dω3_left_crank_dφ2 * dω3_left_crank_dφ2)
            + p.C2 * (ω3_left_crank * ddω3_left_crank_dφ2_dφ2);
        let t196 = p.l1 * t69 + p.l1 * t70 - p.l2 * (t100 * dω4_left_crank_dφ2)
            - p.l2 * (t55 * t189);
        let ddω4_left_crank_dφ2_dφ2 = p.per_l2
            * (per_sin_φ3_minus_φ4 * (t196 + p.l2 * (t102 * t191)))
            - p.per_l2 * (t194 * t56);
        let t197 = p.C3 * (dω4_left_crank_dφ2 * dω4_left_crank_dφ2)
            + p.C3 * (ω4_left_crank * ddω4_left_crank_dφ2_dφ2);
        let t198 = t195 * 2.0 + t197 * 2.0
            + p.C4 * (cos_φ1_minus_φ3 * ddω3_left_crank_dφ2_dφ2);
        let t199 = t35 * dω3_left_crank_dφ2;
        let t200 = p.C4 * (ω3_left_crank * ω3_right_crank_squared * cos_φ1_minus_φ3);
        let t201 = t198 + p.two_C4 * t199 + p.C4 * (t18 * dω3_right_crank_dφ2) - t200;
        let t202 = t91 + t94 + p.l1 * (cos_φ1_minus_φ4 * dω4_left_crank_dφ2)
            - p.l2 * (t111 * dω3_left_crank_dφ2);
        let ddω3_left_crank_dφ1_dφ2 = p.per_l2
            * (per_sin_φ3_minus_φ4 * (t202 - p.l2 * (t53 * t188)))
            - p.per_l2 * (t193 * t14 * t52);
        let t203 = t131 + t132 + t137 + t138
            + p.C2 * (ω3_right_crank * ddω3_left_crank_dφ1_dφ2);
        let t204 = t133 - t135 + p.l1 * t71 + p.l2 * (t111 * dω3_right_crank_dφ2)
            + p.l2 * (t61 * t188);
        let ddω3_right_crank_dφ1_dφ2 = p.per_l2 * (t194 * t19)
            - p.per_l2 * (per_sin_φ3_minus_φ4 * t204);
        let t205 = t99 + t103 + p.l1 * t58 - p.l2 * (t111 * dω4_left_crank_dφ2)
            - p.l2 * (t55 * t188);
        let ddω4_left_crank_dφ1_dφ2 = p.per_l2 * (per_sin_φ3_minus_φ4 * t205)
            - p.per_l2 * (t194 * t15);
        let t206 = t203 + p.C2 * (ω3_left_crank * ddω3_right_crank_dφ1_dφ2)
            + p.C3 * (ω4_right_crank * ddω4_left_crank_dφ1_dφ2);
        let t207 = t140 - t142 + p.l1 * (dω3_left_crank_dφ2 * cos_φ2_minus_φ3)
            + p.l2 * (t111 * dω4_right_crank_dφ2);
        let ddω4_right_crank_dφ1_dφ2 = p.per_l2 * (t194 * t22)
            - p.per_l2 * (per_sin_φ3_minus_φ4 * (t207 + p.l2 * (t65 * t188)));
        let t208 = t144 - t146 + p.C4 * t148 + p.C4 * t199
            + p.C4 * (cos_φ1_minus_φ3 * ddω3_right_crank_dφ1_dφ2);
        let t209 = t206 + p.C3 * (ω4_left_crank * ddω4_right_crank_dφ1_dφ2)
            + t208 * 0.5;
        let t210 = p.two_C5 * t150 + t152 - t155
            + p.C5 * (cos_φ2_minus_φ4 * ddω4_left_crank_dφ1_dφ2);
        let t211 = t209 + t210 * 0.5;
        let t212 = t211 * 0.5;
        let t213 = p.two_C2 * (dω3_left_crank_dφ2 * dω3_right_crank_dφ2)
            + p.C2 * (ω3_right_crank * ddω3_left_crank_dφ2_dφ2);
        let t214 = ω4_right_crank_minus_one * ω4_right_crank_minus_one;
        let t215 = p.l1 * (sin_φ2_minus_φ4 * t214) + p.l1 * t82
            + p.l2 * (t100 * dω3_right_crank_dφ2);
        let t216 = per_sin_φ3_minus_φ4
            * (t215 + p.l2 * (t61 * t189) - p.l2 * (t116 * t191));
        let ddω3_right_crank_dφ2_dφ2 = p.per_l2 * (t194 * t62) - p.per_l2 * t216;
        let t217 = t213 + p.C2 * (ω3_left_crank * ddω3_right_crank_dφ2_dφ2)
            + p.two_C3 * (dω4_left_crank_dφ2 * dω4_right_crank_dφ2);
        let t218 = sin_φ2_minus_φ3
            * (ω3_right_crank_minus_one * ω3_right_crank_minus_one);
        let t219 = p.l1 * t218 + p.l1 * (dω3_right_crank_dφ2 * cos_φ2_minus_φ3)
            + p.l2 * (t100 * dω4_right_crank_dφ2);
        let t220 = per_sin_φ3_minus_φ4
            * (t219 + p.l2 * (t65 * t189) - p.l2 * (t122 * t191));
        let ddω4_right_crank_dφ2_dφ2 = p.per_l2 * (t194 * t66) - p.per_l2 * t220;
        let t221 = t217 + p.C3 * (ω4_right_crank * ddω4_left_crank_dφ2_dφ2)
            + p.C3 * (ω4_left_crank * ddω4_right_crank_dφ2_dφ2);
        let t222 = p._3_C4 * (t35 * dω3_right_crank_dφ2)
            + p.C4 * (cos_φ1_minus_φ3 * ddω3_right_crank_dφ2_dφ2);
        let t223 = p.C4
            * (ω3_right_crank * ω3_right_crank_squared * cos_φ1_minus_φ3);
        let t224 = p.two_C5
            * (sin_φ2_minus_φ4 * dω4_left_crank_dφ2 * ω4_right_crank_minus_one);
        let t225 = t178 + p.C5 * (cos_φ2_minus_φ4 * ddω4_left_crank_dφ2_dφ2) + t224
            - p.C5 * (t10 * t214);
        let t226 = t221 + (t222 - t223) * 0.5 + t225 * 0.5;
        let t227 = t178 + t181 - t182
            + (t175 + p.C2 * (ω3_right_crank * ddω3_right_crank_dφ1_dφ2)) * 2.0;
        let t228 = t227
            + (t176 + p.C3 * (ω4_right_crank * ddω4_right_crank_dφ1_dφ2)) * 2.0;
        let t229 = t228 + p.C5 * (cos_φ2_minus_φ4 * ddω4_right_crank_dφ1_dφ2)
            + p.C5 * (t83 * dω4_left_crank_dφ2);
        let t230 = t105 + t106 - t108
            + (t90 + p.C2 * (ω3_left_crank * ddω3_left_crank_dφ1_dφ2)) * 2.0;
        let t231 = t230
            + (t98 + p.C3 * (ω4_left_crank * ddω4_left_crank_dφ1_dφ2)) * 2.0;
        let t232 = t231 + p.C4 * (cos_φ1_minus_φ3 * ddω3_left_crank_dφ1_dφ2)
            + p.C4 * (t18 * dω3_left_crank_dφ2);
        let t233 = p.k + p.k * (dω3_right_crank_dφ2 * t45)
            + p.k * ω3_right_crank_squared;
        let t234 = t233 + p.k * (dω4_right_crank_dφ2 * t48) + p.k * t214
            + p.k * (t49 * t189);
        let ddP_s_dφ2_dφ2 = t234 + p.k * t191;
        let t235 = t226 * 0.5;
        let t236 = p.C2 * (dω3_right_crank_dφ2 * dω3_right_crank_dφ2)
            + p.C2 * (ω3_right_crank * ddω3_right_crank_dφ2_dφ2);
        let t237 = p.C3 * (dω4_right_crank_dφ2 * dω4_right_crank_dφ2)
            + p.C3 * (ω4_right_crank * ddω4_right_crank_dφ2_dφ2);
        let t238 = t236 * 2.0 + t237 * 2.0 + p.two_C5 * (t180 * dω4_right_crank_dφ2);
        let t239 = t238 + p.C5 * (cos_φ2_minus_φ4 * ddω4_right_crank_dφ2_dφ2)
            + p.C5 * (t83 * dω4_right_crank_dφ2);
        let t240 = p.c + p.c * ω3_right_crank_squared + p.c * t214 + p.c * t191;
        let dτ_2_ddφ2 = -t240;
        // ── state ──
        let t241 = p.constant1 * t;
        let (t242, t243) = t241.sin_cos();
        let t244 = ω3_left_crank_minus_one * dφ1 + ω3_right_crank * dφ2;
        let t245 = ω4_left_crank * dφ1 + ω4_right_crank_minus_one * dφ2;
        let t246 = p.left_torque * t242 - p.c * dφ1 - t50 * t244
            - c_ω4_left_crank * t245;
        let t247 = t13 * dφ1 + t52 * dφ2;
        // generalized torque of all other forces
        let τ_1 = t246 - t51 * t247;
        let dφ1_dφ2 = dφ1 * dφ2;
        let dφ2_squared = dφ2 * dφ2;
        let dφ1_squared = dφ1 * dφ1;
        let t248 = t60 * dφ1_dφ2 + t74 * dφ2_squared
            + dM_left_crank_dφ1 * 0.5 * dφ1_squared;
        // centrifugal and Coriolis terms
        let h_left_crank = t248 + t59 * dφ1_dφ2;
        let t249 = dP_s_dφ1 - τ_1 + h_left_crank;
        let t250 = p.right_torque * t243 - p.c * dφ2 - c_ω3_right_crank * t244
            - t76 * t245;
        // generalized torque of all other forces
        let τ_2 = t250 - t77 * t247;
        // centrifugal and Coriolis terms
        let h_right_crank = t78 * dφ1_squared + t80 * dφ1_dφ2 + t79 * dφ1_dφ2
            + dM_right_crank_dφ2 * 0.5 * dφ2_squared;
        let t251 = dP_s_dφ2 - τ_2 + h_right_crank;
        let t252 = M_right_crank * t249 - M_left_crank_right_crank * t251;
        let t253 = dω3_left_crank_dφ1 * dφ1 + dω3_right_crank_dφ1 * dφ2;
        let t254 = p.c * dω3_left_crank_dφ1 * t244 + t50 * t253
            + p.c * dω4_left_crank_dφ1 * t245;
        let t255 = dω4_left_crank_dφ1 * dφ1 + dω4_right_crank_dφ1 * dφ2;
        let t256 = t87 * dφ1 + t89 * dφ2;
        let t257 = ddP_s_dφ1_dφ1
            + (t254 + c_ω4_left_crank * t255 + p.c * t87 * t247 + t51 * t256);
        let t258 = (t109 - t130) * dφ1_dφ2 + (t156 - t161 * 0.5) * dφ2_squared
            + t166 * 0.5 * dφ1_squared;
        let dh_left_crank_dφ1 = t258 + t130 * dφ1_dφ2;
        let t259 = t257 + dh_left_crank_dφ1;
        let t260 = p.c * dω3_right_crank_dφ1 * t244 + c_ω3_right_crank * t253
            + p.c * dω4_right_crank_dφ1 * t245;
        let t261 = ddP_s_dφ2_dφ1 + (t260 + t76 * t255 + p.c * t89 * t247 + t77 * t256);
        let t262 = (t129 - t109 * 0.5) * dφ1_squared + (t161 - t174) * dφ1_dφ2
            + t174 * dφ1_dφ2;
        let t263 = (t179 + t181 + p.C5 * (t83 * dω4_right_crank_dφ1) - t182) * 0.5
            * dφ2_squared;
        let dh_right_crank_dφ1 = t262 + t263;
        let t264 = t261 + dh_right_crank_dφ1;
        let t265 = dM_right_crank_dφ1 * t249 + M_right_crank * t259 - t41 * t251
            - M_left_crank_right_crank * t264;
        let dddφ1_dφ1 = t43 * t252 - t84 * t265;
        let dh_left_crank_ddφ1 = t60 * dφ2 + dM_left_crank_dφ1 * dφ1 + t59 * dφ2;
        let t266 = dτ_1_ddφ1 - dh_left_crank_ddφ1;
        let dh_right_crank_ddφ1 = t78 * 2.0 * dφ1 + t80 * dφ2 + t79 * dφ2;
        let t267 = dτ_2_ddφ1 - dh_right_crank_ddφ1;
        let dddφ1_ddφ1 = t84
            * (M_right_crank * t266 - M_left_crank_right_crank * t267);
        let t268 = dω3_left_crank_dφ2 * dφ1 + dω3_right_crank_dφ2 * dφ2;
        let t269 = p.c * dω3_left_crank_dφ2 * t244 + t50 * t268
            + p.c * dω4_left_crank_dφ2 * t245;
        let t270 = dω4_left_crank_dφ2 * dφ1 + dω4_right_crank_dφ2 * dφ2;
        let t271 = t188 * dφ1 + t189 * dφ2;
        let t272 = ddP_s_dφ1_dφ2
            + (t269 + c_ω4_left_crank * t270 + p.c * t188 * t247 + t51 * t271);
        let t273 = (t201 - t212) * dφ1_dφ2 + (t226 - t229 * 0.5) * dφ2_squared
            + t232 * 0.5 * dφ1_squared;
        let dh_left_crank_dφ2 = t273 + t212 * dφ1_dφ2;
        let t274 = t272 + dh_left_crank_dφ2;
        let t275 = p.c * dω3_right_crank_dφ2 * t244 + c_ω3_right_crank * t268
            + p.c * dω4_right_crank_dφ2 * t245;
        let t276 = ddP_s_dφ2_dφ2
            + (t275 + t76 * t270 + p.c * t189 * t247 + t77 * t271);
        let t277 = (t211 - t201 * 0.5) * dφ1_squared + (t229 - t235) * dφ1_dφ2
            + t235 * dφ1_dφ2;
        let dh_right_crank_dφ2 = t277
            + (t239 - p.C5 * (t6 * t214)) * 0.5 * dφ2_squared;
        let t278 = t276 + dh_right_crank_dφ2;
        let t279 = dM_right_crank_dφ2 * t249 + M_right_crank * t274 - t73 * t251
            - M_left_crank_right_crank * t278;
        let dddφ1_dφ2 = t186 * t252 - t84 * t279;
        let dh_left_crank_ddφ2 = t60 * dφ1 + t74 * 2.0 * dφ2 + t59 * dφ1;
        let t280 = dτ_2_ddφ1 - dh_left_crank_ddφ2;
        let dh_right_crank_ddφ2 = t80 * dφ1 + t79 * dφ1 + dM_right_crank_dφ2 * dφ2;
        let t281 = dτ_2_ddφ2 - dh_right_crank_ddφ2;
        let dddφ1_ddφ2 = t84
            * (M_right_crank * t280 - M_left_crank_right_crank * t281);
        let t282 = M_left_crank * t251 - M_left_crank_right_crank * t249;
        let t283 = dM_left_crank_dφ1 * t251 + M_left_crank * t264 - t41 * t249
            - M_left_crank_right_crank * t259;
        let dddφ2_dφ1 = t43 * t282 - t84 * t283;
        let dddφ2_ddφ1 = t84 * (M_left_crank * t267 - M_left_crank_right_crank * t266);
        let t284 = dM_left_crank_dφ2 * t251 + M_left_crank * t278 - t73 * t249
            - M_left_crank_right_crank * t274;
        let dddφ2_dφ2 = t186 * t282 - t84 * t284;
        let dddφ2_ddφ2 = t84 * (M_left_crank * t281 - M_left_crank_right_crank * t280);
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
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 2],
    ) {
        let φ1 = x[0];
        let φ2 = x[2];
        // ── configuration ──
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let l1_cos_φ1 = p.l1 * cos_φ1;
        let (sin_φ2, cos_φ2) = φ2.sin_cos();
        // vector that is left to close left_crank–left_coupler–right_coupler–right_crank
        let X = p.base + p.l1 * cos_φ2 - l1_cos_φ1;
        let l1_sin_φ1 = p.l1 * sin_φ1;
        let Y = p.l1 * sin_φ2 - l1_sin_φ1;
        // its length squared
        let D = X * X + Y * Y;
        let η = p.half_s * (D.recip() * (D * (p._4_l2_squared - D)).sqrt());
        let c3 = p.per_l2 * (X * 0.5 - Y * η);
        let P_x = l1_cos_φ1 + p.l2 * c3;
        let s3 = p.per_l2 * (Y * 0.5 + X * η);
        let P_y = l1_sin_φ1 + p.l2 * s3;
        result[0] = P_x;
        result[1] = P_y;
    }
    /// Kinetic and potential energy in J, dissipated and supplied power in W.
    #[inline(always)]
    pub fn energy<T: Real>(
        t: T,
        x: &[T; 4],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let φ1 = x[0];
        let dφ1 = x[1];
        let φ2 = x[2];
        let dφ2 = x[3];
        let turn_left_coupler = d[0];
        let turn_right_coupler = d[1];
        // ── configuration ──
        let (sin_φ2, cos_φ2) = φ2.sin_cos();
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let Y = p.l1 * sin_φ2 - p.l1 * sin_φ1;
        let half_Y = Y * 0.5;
        // vector that is left to close left_crank–left_coupler–right_coupler–right_crank
        let X = p.base + p.l1 * cos_φ2 - p.l1 * cos_φ1;
        // its length squared
        let D = X * X + Y * Y;
        let η = p.half_s * (D.recip() * (D * (p._4_l2_squared - D)).sqrt());
        let X_η = X * η;
        let s3 = p.per_l2 * (half_Y + X_η);
        let half_X = X * 0.5;
        let Y_η = Y * η;
        let c4 = -(p.per_l2 * (X - half_X + Y_η));
        let c3 = p.per_l2 * (half_X - Y_η);
        let s4 = p.per_l2 * (half_Y - Y + X_η);
        let sin_φ3_minus_φ4 = s3 * c4 - c3 * s4;
        let per_sin_φ3_minus_φ4 = sin_φ3_minus_φ4.recip();
        let sin_φ1_minus_φ4 = sin_φ1 * c4 - cos_φ1 * s4;
        let t1 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ1_minus_φ4);
        // rate of the angle of `left_coupler` per unit rate of `left_crank`
        let ω3_left_crank = -t1;
        let sin_φ1_minus_φ3 = sin_φ1 * c3 - cos_φ1 * s3;
        let t2 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ1_minus_φ3);
        // rate of the angle of `right_coupler` per unit rate of `left_crank`
        let ω4_left_crank = -t2;
        let t3 = p.C0 + p.C2 * (ω3_left_crank * ω3_left_crank)
            + p.C3 * (ω4_left_crank * ω4_left_crank);
        let cos_φ1_minus_φ3 = cos_φ1 * c3 + sin_φ1 * s3;
        // inertia
        let M_left_crank = t3 + p.C4 * (ω3_left_crank * cos_φ1_minus_φ3);
        let sin_φ2_minus_φ4 = sin_φ2 * c4 - cos_φ2 * s4;
        // rate of the angle of `left_coupler` per unit rate of `right_crank`
        let ω3_right_crank = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ2_minus_φ4);
        let sin_φ2_minus_φ3 = sin_φ2 * c3 - cos_φ2 * s3;
        // rate of the angle of `right_coupler` per unit rate of `right_crank`
        let ω4_right_crank = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ2_minus_φ3);
        let t4 = p.C2 * (ω3_left_crank * ω3_right_crank)
            + p.C3 * (ω4_left_crank * ω4_right_crank);
        let cos_φ2_minus_φ4 = cos_φ2 * c4 + sin_φ2 * s4;
        // inertia
        let M_left_crank_right_crank = t4
            + p.half_C4 * (ω3_right_crank * cos_φ1_minus_φ3)
            + p.half_C5 * (ω4_left_crank * cos_φ2_minus_φ4);
        let t5 = p.C1 + p.C2 * (ω3_right_crank * ω3_right_crank)
            + p.C3 * (ω4_right_crank * ω4_right_crank);
        // inertia
        let M_right_crank = t5 + p.C5 * (ω4_right_crank * cos_φ2_minus_φ4);
        let t6 = φ1 - 2.0943951023931953;
        let t7 = φ2 - 1.0471975511965976;
        let t8 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `left_coupler` from the assembled one
        let φ3_minus_φ3_0 = t8.unwrap_to(turn_left_coupler);
        let t9 = T::from_f64(2.0943951023931953) - φ1 + φ3_minus_φ3_0;
        let t10 = p.half_k * (t6 * t6) + p.half_k * (t7 * t7) + p.half_k * (t9 * t9);
        let t11 = (p.c4_0 * s4 - p.s4_0 * c4).atan2(p.c4_0 * c4 + p.s4_0 * s4);
        // angle of `right_coupler` from the assembled one
        let φ4_minus_φ4_0 = t11.unwrap_to(turn_right_coupler);
        let t12 = T::from_f64(1.0471975511965976) - φ2 + φ4_minus_φ4_0;
        let t13 = φ4_minus_φ4_0 - φ3_minus_φ3_0;
        // ── state ──
        let dφ1_squared = dφ1 * dφ1;
        let t14 = M_left_crank * 0.5 * dφ1_squared
            + M_left_crank_right_crank * (dφ1 * dφ2);
        let dφ2_squared = dφ2 * dφ2;
        let t15 = (ω3_left_crank - 1.0) * dφ1 + ω3_right_crank * dφ2;
        let t16 = ω4_left_crank * dφ1 + (ω4_right_crank - 1.0) * dφ2;
        let t17 = p.c * dφ1_squared + p.c * dφ2_squared + p.c * (t15 * t15)
            + p.c * (t16 * t16);
        let t18 = (t2 - t1) * dφ1 + (ω3_right_crank - ω4_right_crank) * dφ2;
        let t19 = p.constant1 * t;
        let (t20, t21) = t19.sin_cos();
        result[0] = t14 + M_right_crank * 0.5 * dφ2_squared;
        result[1] = t10 + p.half_k * (t12 * t12) + p.half_k * (t13 * t13);
        result[2] = t17 + p.c * (t18 * t18);
        result[3] = p.left_torque * (t20 * dφ1) + p.right_torque * (t21 * dφ2);
    }
    /// Event functions: each event happens where its function rises through zero.
    #[inline(always)]
    pub fn events<T: Real>(
        t: T,
        x: &[T; 4],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 0],
    ) {}
    /// For each loop a number that is positive where it closes and zero at a dead point.
    #[inline(always)]
    pub fn closures<T: Real>(
        t: T,
        x: &[T; 4],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 1],
    ) {
        let φ1 = x[0];
        let φ2 = x[2];
        // ── configuration ──
        let (sin_φ2, cos_φ2) = φ2.sin_cos();
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        // vector that is left to close left_crank–left_coupler–right_coupler–right_crank
        let X = p.base + p.l1 * cos_φ2 - p.l1 * cos_φ1;
        let Y = p.l1 * sin_φ2 - p.l1 * sin_φ1;
        // its length squared
        let D = X * X + Y * Y;
        result[0] = p.constant2 * (D * (p._4_l2_squared - D));
    }
    /// The discrete state after an accepted step that ends in `x`; entries that stay are left as they are.
    #[inline(always)]
    pub fn accept<T: Real>(
        t: T,
        x: &[T; 4],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 2],
    ) {
        let φ1 = x[0];
        let φ2 = x[2];
        let turn_left_coupler = d[0];
        let turn_right_coupler = d[1];
        // ── configuration ──
        let (sin_φ2, cos_φ2) = φ2.sin_cos();
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let Y = p.l1 * sin_φ2 - p.l1 * sin_φ1;
        let half_Y = Y * 0.5;
        // vector that is left to close left_crank–left_coupler–right_coupler–right_crank
        let X = p.base + p.l1 * cos_φ2 - p.l1 * cos_φ1;
        // its length squared
        let D = X * X + Y * Y;
        let η = p.half_s * (D.recip() * (D * (p._4_l2_squared - D)).sqrt());
        let X_η = X * η;
        let s3 = p.per_l2 * (half_Y + X_η);
        let half_X = X * 0.5;
        let Y_η = Y * η;
        let c3 = p.per_l2 * (half_X - Y_η);
        let t1 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `left_coupler` from the assembled one
        let φ3_minus_φ3_0 = t1.unwrap_to(turn_left_coupler);
        let s4 = p.per_l2 * (half_Y - Y + X_η);
        let c4 = -(p.per_l2 * (X - half_X + Y_η));
        let t2 = (p.c4_0 * s4 - p.s4_0 * c4).atan2(p.c4_0 * c4 + p.s4_0 * s4);
        // angle of `right_coupler` from the assembled one
        let φ4_minus_φ4_0 = t2.unwrap_to(turn_right_coupler);
        result[0] = φ3_minus_φ3_0;
        result[1] = φ4_minus_φ4_0;
    }
    /// Time in s of each drive's next kink.
    #[inline(always)]
    pub fn next_kinks<T: Real>(d: &[T; 2], p: &Prepared<T>, result: &mut [T; 0]) {}
    /// The discrete state after drive `index` passed its kink; entries that stay are left as they are.
    #[inline(always)]
    pub fn pass_kink<T: Real>(
        index: usize,
        d: &[T; 2],
        p: &Prepared<T>,
        result: &mut [T; 2],
    ) {}
    /// The state after event `index`; entries that stay are left as they are.
    #[inline(always)]
    pub fn pass_event<T: Real>(
        index: usize,
        t: T,
        x: &[T; 4],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        x_after: &mut [T; 4],
        d_after: &mut [T; 2],
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
            1
        }
        fn closures(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], values: &mut [f64]) {
            closures(t, array(x), array(d), array(u), self, array_mut(values));
        }
        fn loop_name(&self, index: usize) -> &str {
            const NAMES: [&str; 1] = [
                "left_crank–left_coupler–right_coupler–right_crank",
            ];
            NAMES[index]
        }
    }
    /// Every quantity with a name: params, states, discrete states, inputs, outputs.
    pub static VARIABLES: [Variable; 19] = [
        Variable {
            name: Cow::Borrowed("base"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("between the cranks' pivots"),
            causality: Causality::Parameter,
            start: Some(0.04),
        },
        Variable {
            name: Cow::Borrowed("l1"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length of a crank, of a coupler"),
            causality: Causality::Parameter,
            start: Some(0.025),
        },
        Variable {
            name: Cow::Borrowed("l2"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length of a crank, of a coupler"),
            causality: Causality::Parameter,
            start: Some(0.035),
        },
        Variable {
            name: Cow::Borrowed("m1"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of a crank, of a coupler, of the tool"),
            causality: Causality::Parameter,
            start: Some(0.005),
        },
        Variable {
            name: Cow::Borrowed("m2"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of a crank, of a coupler, of the tool"),
            causality: Causality::Parameter,
            start: Some(0.006),
        },
        Variable {
            name: Cow::Borrowed("mt"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of a crank, of a coupler, of the tool"),
            causality: Causality::Parameter,
            start: Some(0.008),
        },
        Variable {
            name: Cow::Borrowed("k"),
            unit: Cow::Borrowed("N*m"),
            meaning: Cow::Borrowed("stiffness of a hinge"),
            causality: Causality::Parameter,
            start: Some(0.4),
        },
        Variable {
            name: Cow::Borrowed("c"),
            unit: Cow::Borrowed("N*m*s"),
            meaning: Cow::Borrowed("damping of a hinge"),
            causality: Causality::Parameter,
            start: Some(2e-5),
        },
        Variable {
            name: Cow::Borrowed("left_torque"),
            unit: Cow::Borrowed("N*m"),
            meaning: Cow::Borrowed("drives"),
            causality: Causality::Parameter,
            start: Some(0.08),
        },
        Variable {
            name: Cow::Borrowed("right_torque"),
            unit: Cow::Borrowed("N*m"),
            meaning: Cow::Borrowed("drives"),
            causality: Causality::Parameter,
            start: Some(0.05),
        },
        Variable {
            name: Cow::Borrowed("f"),
            unit: Cow::Borrowed("1/s"),
            meaning: Cow::Borrowed("their frequency"),
            causality: Causality::Parameter,
            start: Some(12.0),
        },
        Variable {
            name: Cow::Borrowed("left_crank.angle"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("angle of `left_crank`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("left_crank.rate"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed("angular rate of `left_crank`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("right_crank.angle"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("angle of `right_crank`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("right_crank.rate"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed("angular rate of `right_crank`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("left_coupler.turn"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed(
                "angle of `left_coupler` from the assembled one at the last accepted step",
            ),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("right_coupler.turn"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed(
                "angle of `right_coupler` from the assembled one at the last accepted step",
            ),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("x"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("position of the tool"),
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
    static DISCRETES: &[Variable] = VARIABLES.split_at(15).1.split_at(2).0;
    static INPUTS: &[Variable] = VARIABLES.split_at(17).1.split_at(0).0;
    static OUTPUTS: &[Variable] = VARIABLES.split_at(17).1.split_at(2).0;
    static TURNING: [usize; 2] = [0, 1];
    static FAILURES: [Failure; 11] = [
        Failure {
            message: Cow::Borrowed("the length of `left_crank` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("five_bar.flex"),
                line: 15,
                column: 6,
                width: 10,
                excerpt: Cow::Borrowed(
                    "link left_crank    from O1 to A { length = l1, angle = 120 deg exact, mass = m1, symbol = φ1 }",
                ),
            }),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `left_crank` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("five_bar.flex"),
                line: 15,
                column: 71,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link left_crank    from O1 to A { length = l1, angle = 120 deg exact, mass = m1, symbol = φ1 }",
                ),
            }),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `left_crank` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("five_bar.flex"),
                line: 15,
                column: 71,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link left_crank    from O1 to A { length = l1, angle = 120 deg exact, mass = m1, symbol = φ1 }",
                ),
            }),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `left_coupler` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("five_bar.flex"),
                line: 17,
                column: 6,
                width: 12,
                excerpt: Cow::Borrowed(
                    "link left_coupler  from A to P  { length = l2, angle =  25 deg, mass = m2, mass at P = mt, symbol = φ3 }",
                ),
            }),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `left_coupler` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("five_bar.flex"),
                line: 17,
                column: 65,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link left_coupler  from A to P  { length = l2, angle =  25 deg, mass = m2, mass at P = mt, symbol = φ3 }",
                ),
            }),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `left_coupler` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("five_bar.flex"),
                line: 17,
                column: 65,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link left_coupler  from A to P  { length = l2, angle =  25 deg, mass = m2, mass at P = mt, symbol = φ3 }",
                ),
            }),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `left_coupler` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("five_bar.flex"),
                line: 17,
                column: 76,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link left_coupler  from A to P  { length = l2, angle =  25 deg, mass = m2, mass at P = mt, symbol = φ3 }",
                ),
            }),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed(
                "the loop left_crank–left_coupler–right_coupler–right_crank cannot close: at `left_crank` angle {3} the gap is {0}",
            ),
            hint: Some(
                Cow::Borrowed(
                    "`left_coupler` would need to be {1} to {2} long between its joints, or another link another length or angle",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("five_bar.flex"),
                line: 17,
                column: 6,
                width: 12,
                excerpt: Cow::Borrowed(
                    "link left_coupler  from A to P  { length = l2, angle =  25 deg, mass = m2, mass at P = mt, symbol = φ3 }",
                ),
            }),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Metre, Unit::Metre, Unit::Degree]),
        },
        Failure {
            message: Cow::Borrowed(
                "the loop left_crank–left_coupler–right_coupler–right_crank stands at a dead point: at `left_crank` angle {3} two of its links lie in one line",
            ),
            hint: Some(
                Cow::Borrowed(
                    "assemble it in another configuration: change an angle or a length",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("five_bar.flex"),
                line: 17,
                column: 6,
                width: 12,
                excerpt: Cow::Borrowed(
                    "link left_coupler  from A to P  { length = l2, angle =  25 deg, mass = m2, mass at P = mt, symbol = φ3 }",
                ),
            }),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Metre, Unit::Metre, Unit::Degree]),
        },
        Failure {
            message: Cow::Borrowed("`left_crank` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("five_bar.flex"),
                line: 15,
                column: 6,
                width: 10,
                excerpt: Cow::Borrowed(
                    "link left_crank    from O1 to A { length = l1, angle = 120 deg exact, mass = m1, symbol = φ1 }",
                ),
            }),
            units: Cow::Borrowed(&[]),
        },
        Failure {
            message: Cow::Borrowed("`right_crank` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("five_bar.flex"),
                line: 16,
                column: 6,
                width: 11,
                excerpt: Cow::Borrowed(
                    "link right_crank   from O2 to B { length = l1, angle =  60 deg exact, mass = m1, symbol = φ2 }",
                ),
            }),
            units: Cow::Borrowed(&[]),
        },
    ];
    /// The equations of motion in plain text.
    pub const EQUATIONS: &str = r#"five_bar
════════

A five-bar: two cranks on ground move the pin where their couplers meet, in both directions.

Loop left_crank–left_coupler–right_coupler–right_crank
──────────────────────────────────────────────────────

  l1 e^(i φ1) + l2 e^(i φ3) - l2 e^(i φ4) - l1 e^(i φ2) - base = 0

  X  = base + l1 cos(φ2) - l1 cos(φ1)
  Y  = l1 sin(φ2) - l1 sin(φ1)
  D  = X² + Y²
  κ  = ½
  η  = s sqrt(D (4 l2² - D)) / (2 D)
  c3 = (X κ - Y η) / l2
  s3 = (Y κ + X η) / l2
  c4 = -(X - X κ + Y η) / l2
  s4 = (Y κ - Y + X η) / l2

  φ3 = atan2(s3, c3), φ4 = atan2(s4, c4), continuous over many turns; ⁰: as assembled

  ω3_left_crank  = l1 sin(φ4 - φ1) / (l2 sin(φ3 - φ4))
  ω4_left_crank  = l1 sin(φ3 - φ1) / (l2 sin(φ3 - φ4))
  ω3_right_crank = l1 sin(φ2 - φ4) / (l2 sin(φ3 - φ4))
  ω4_right_crank = l1 sin(φ2 - φ3) / (l2 sin(φ3 - φ4))
  ∂ω3_left_crank/∂φ1 = (l1 (ω4_left_crank - 1) cos(φ1 - φ4)
                         + l2 ω3_left_crank (ω4_left_crank - ω3_left_crank) cos(φ3 - φ4))
                         / (l2 sin(φ3 - φ4))
  ∂ω3_left_crank/∂φ2 = (l1 ω4_right_crank cos(φ1 - φ4)
                         + l2 ω3_left_crank (ω4_right_crank - ω3_right_crank) cos(φ3 - φ4))
                         / (l2 sin(φ3 - φ4))
  ∂ω4_left_crank/∂φ1 = (l1 (ω3_left_crank - 1) cos(φ1 - φ3)
                         + l2 ω4_left_crank (ω4_left_crank - ω3_left_crank) cos(φ3 - φ4))
                         / (l2 sin(φ3 - φ4))
  ∂ω4_left_crank/∂φ2 = (l1 ω3_right_crank cos(φ1 - φ3)
                         + l2 ω4_left_crank (ω4_right_crank - ω3_right_crank) cos(φ3 - φ4))
                         / (l2 sin(φ3 - φ4))
  ∂ω3_right_crank/∂φ1 = (l1 ω4_left_crank cos(φ2 - φ4)
                          + l2 ω3_right_crank (ω3_left_crank - ω4_left_crank) cos(φ3 - φ4))
                          / (l2 sin(φ4 - φ3))
  ∂ω3_right_crank/∂φ2 = (l1 (ω4_right_crank - 1) cos(φ2 - φ4)
                          + l2 ω3_right_crank (ω3_right_crank - ω4_right_crank) cos(φ3 - φ4))
                          / (l2 sin(φ4 - φ3))
  ∂ω4_right_crank/∂φ1 = (l1 ω3_left_crank cos(φ2 - φ3)
                          + l2 ω4_right_crank (ω3_left_crank - ω4_left_crank) cos(φ3 - φ4))
                          / (l2 sin(φ4 - φ3))
  ∂ω4_right_crank/∂φ2 = (l1 (ω3_right_crank - 1) cos(φ2 - φ3)
                          + l2 ω4_right_crank (ω3_right_crank - ω4_right_crank) cos(φ3 - φ4))
                          / (l2 sin(φ4 - φ3))

Constants of the inertia
────────────────────────

  C0 = I1 + m1 r1² + m2 l1² + mt l1²
  C1 = I2 + m1 r2² + m2 l1²
  C2 = I3 + m2 r3² + mt l2²
  C3 = I4 + m2 r4²
  C4 = 2 l1 m2 r3 + 2 l1 l2 mt
  C5 = 2 l1 m2 r4

Equations of motion of `left_crank`, `right_crank`
──────────────────────────────────────────────────

  M_left_crank  = C0 + C2 ω3_left_crank² + C3 ω4_left_crank² + C4 ω3_left_crank cos(φ1 - φ3)
  M_left_crank_right_crank = C2 ω3_left_crank ω3_right_crank
                           + C3 ω4_left_crank ω4_right_crank
                           + ½ C4 ω3_right_crank cos(φ1 - φ3)
                           + ½ C5 ω4_left_crank cos(φ2 - φ4)
  M_right_crank = C1 + C2 ω3_right_crank² + C3 ω4_right_crank² + C5 ω4_right_crank cos(φ2 - φ4)
  h_left_crank  = φ̇1 φ̇2 (2 C2 ω3_left_crank ∂ω3_left_crank/∂φ2
                    + 2 C3 ω4_left_crank ∂ω4_left_crank/∂φ2 + C4 ∂ω3_left_crank/∂φ2 cos(φ1 - φ3)
                    + C4 ω3_left_crank ω3_right_crank sin(φ1 - φ3)
                    - ½ (C2 ω3_right_crank ∂ω3_left_crank/∂φ1
                    + C2 ω3_left_crank ∂ω3_right_crank/∂φ1
                    + C3 ω4_right_crank ∂ω4_left_crank/∂φ1
                    + C3 ω4_left_crank ∂ω4_right_crank/∂φ1
                    + ½ (C4 ∂ω3_right_crank/∂φ1 cos(φ1 - φ3)
                    + C4 ω3_right_crank (ω3_left_crank - 1) sin(φ1 - φ3))
                    + ½ (C5 ∂ω4_left_crank/∂φ1 cos(φ2 - φ4) + C5 ω4_left_crank² sin(φ2 - φ4))))
                + φ̇2² (C2 ω3_right_crank ∂ω3_left_crank/∂φ2
                    + C2 ω3_left_crank ∂ω3_right_crank/∂φ2
                    + C3 ω4_right_crank ∂ω4_left_crank/∂φ2
                    + C3 ω4_left_crank ∂ω4_right_crank/∂φ2
                    + ½ (C4 ∂ω3_right_crank/∂φ2 cos(φ1 - φ3) + C4 ω3_right_crank² sin(φ1 - φ3))
                    + ½ (C5 ∂ω4_left_crank/∂φ2 cos(φ2 - φ4)
                    + C5 ω4_left_crank (ω4_right_crank - 1) sin(φ2 - φ4))
                    - ½ (2 C2 ω3_right_crank ∂ω3_right_crank/∂φ1
                    + 2 C3 ω4_right_crank ∂ω4_right_crank/∂φ1
                    + C5 ∂ω4_right_crank/∂φ1 cos(φ2 - φ4)
                    + C5 ω4_left_crank ω4_right_crank sin(φ2 - φ4)))
                + ½ φ̇1² (2 C2 ω3_left_crank ∂ω3_left_crank/∂φ1
                    + 2 C3 ω4_left_crank ∂ω4_left_crank/∂φ1 + C4 ∂ω3_left_crank/∂φ1 cos(φ1 - φ3)
                    + C4 ω3_left_crank (ω3_left_crank - 1) sin(φ1 - φ3))
                + ½ φ̇1 φ̇2 (C2 ω3_right_crank ∂ω3_left_crank/∂φ1
                    + C2 ω3_left_crank ∂ω3_right_crank/∂φ1
                    + C3 ω4_right_crank ∂ω4_left_crank/∂φ1
                    + C3 ω4_left_crank ∂ω4_right_crank/∂φ1
                    + ½ (C4 ∂ω3_right_crank/∂φ1 cos(φ1 - φ3)
                    + C4 ω3_right_crank (ω3_left_crank - 1) sin(φ1 - φ3))
                    + ½ (C5 ∂ω4_left_crank/∂φ1 cos(φ2 - φ4) + C5 ω4_left_crank² sin(φ2 - φ4)))
  h_right_crank = φ̇1² (C2 ω3_right_crank ∂ω3_left_crank/∂φ1
                    - ½ (2 C2 ω3_left_crank ∂ω3_left_crank/∂φ2
                    + 2 C3 ω4_left_crank ∂ω4_left_crank/∂φ2 + C4 ∂ω3_left_crank/∂φ2 cos(φ1 - φ3)
                    + C4 ω3_left_crank ω3_right_crank sin(φ1 - φ3))
                    + C2 ω3_left_crank ∂ω3_right_crank/∂φ1
                    + C3 ω4_right_crank ∂ω4_left_crank/∂φ1
                    + C3 ω4_left_crank ∂ω4_right_crank/∂φ1
                    + ½ (C4 ∂ω3_right_crank/∂φ1 cos(φ1 - φ3)
                    + C4 ω3_right_crank (ω3_left_crank - 1) sin(φ1 - φ3))
                    + ½ (C5 ∂ω4_left_crank/∂φ1 cos(φ2 - φ4) + C5 ω4_left_crank² sin(φ2 - φ4)))
                + φ̇1 φ̇2 (2 C2 ω3_right_crank ∂ω3_right_crank/∂φ1
                    - ½ (C2 ω3_right_crank ∂ω3_left_crank/∂φ2
                    + C2 ω3_left_crank ∂ω3_right_crank/∂φ2
                    + C3 ω4_right_crank ∂ω4_left_crank/∂φ2
                    + C3 ω4_left_crank ∂ω4_right_crank/∂φ2
                    + ½ (C4 ∂ω3_right_crank/∂φ2 cos(φ1 - φ3) + C4 ω3_right_crank² sin(φ1 - φ3))
                    + ½ (C5 ∂ω4_left_crank/∂φ2 cos(φ2 - φ4)
                    + C5 ω4_left_crank (ω4_right_crank - 1) sin(φ2 - φ4)))
                    + 2 C3 ω4_right_crank ∂ω4_right_crank/∂φ1
                    + C5 ∂ω4_right_crank/∂φ1 cos(φ2 - φ4)
                    + C5 ω4_left_crank ω4_right_crank sin(φ2 - φ4))
                + ½ φ̇1 φ̇2 (C2 ω3_right_crank ∂ω3_left_crank/∂φ2
                    + C2 ω3_left_crank ∂ω3_right_crank/∂φ2
                    + C3 ω4_right_crank ∂ω4_left_crank/∂φ2
                    + C3 ω4_left_crank ∂ω4_right_crank/∂φ2
                    + ½ (C4 ∂ω3_right_crank/∂φ2 cos(φ1 - φ3) + C4 ω3_right_crank² sin(φ1 - φ3))
                    + ½ (C5 ∂ω4_left_crank/∂φ2 cos(φ2 - φ4)
                    + C5 ω4_left_crank (ω4_right_crank - 1) sin(φ2 - φ4)))
                + ½ φ̇2² (2 C2 ω3_right_crank ∂ω3_right_crank/∂φ2
                    + 2 C3 ω4_right_crank ∂ω4_right_crank/∂φ2
                    + C5 ∂ω4_right_crank/∂φ2 cos(φ2 - φ4)
                    + C5 ω4_right_crank (ω4_right_crank - 1) sin(φ2 - φ4))
  ∂P_s/∂φ1      = k (φ1 - φ1⁰)
                + k (ω3_left_crank - 1) (φ3 - φ3⁰ - φ1 + φ1⁰)
                + k ω4_left_crank (φ4 - φ4⁰ - φ2 + φ2⁰)
                + k (ω3_left_crank - ω4_left_crank) (φ3 - φ3⁰ - (φ4 - φ4⁰))
  τ_1           = left_torque sin(2 π f t)
                - c φ̇1
                + c (1 - ω3_left_crank) (φ̇1 (ω3_left_crank - 1) + ω3_right_crank φ̇2)
                - c ω4_left_crank (ω4_left_crank φ̇1 + φ̇2 (ω4_right_crank - 1))
                + c (ω4_left_crank - ω3_left_crank) (φ̇1 (ω3_left_crank - ω4_left_crank)
                    + φ̇2 (ω3_right_crank - ω4_right_crank))
  ∂P_s/∂φ2      = k (φ2 - φ2⁰)
                + k ω3_right_crank (φ3 - φ3⁰ - φ1 + φ1⁰)
                + k (ω4_right_crank - 1) (φ4 - φ4⁰ - φ2 + φ2⁰)
                + k (ω3_right_crank - ω4_right_crank) (φ3 - φ3⁰ - (φ4 - φ4⁰))
  τ_2           = right_torque cos(2 π f t)
                - c φ̇2
                - c ω3_right_crank (φ̇1 (ω3_left_crank - 1) + ω3_right_crank φ̇2)
                + c (1 - ω4_right_crank) (ω4_left_crank φ̇1 + φ̇2 (ω4_right_crank - 1))
                + c (ω4_right_crank - ω3_right_crank) (φ̇1 (ω3_left_crank - ω4_left_crank)
                    + φ̇2 (ω3_right_crank - ω4_right_crank))

  M_left_crank φ̈1 + M_left_crank_right_crank φ̈2 + h_left_crank + ∂P_s/∂φ1 = τ_1
  M_left_crank_right_crank φ̈1 + M_right_crank φ̈2 + h_right_crank + ∂P_s/∂φ2 = τ_2

Constants
─────────

  r1  = ½ l1          distance of the centre of mass from the first end of left_crank
  I1  = 1/12 m1 l1²   moment of inertia about the centre of mass of left_crank
  r2  = ½ l1          distance of the centre of mass from the first end of right_crank
  I2  = 1/12 m1 l1²   moment of inertia about the centre of mass of right_crank
  r3  = ½ l2          distance of the centre of mass from the first end of left_coupler
  I3  = 1/12 m2 l2²   moment of inertia about the centre of mass of left_coupler
  r4  = ½ l2          distance of the centre of mass from the first end of right_coupler
  I4  = 1/12 m2 l2²   moment of inertia about the centre of mass of right_coupler
  φ1⁰ = ⅔ π           angle of `left_crank` as assembled
  φ2⁰ = ⅓ π           angle of `right_crank` as assembled
  s   = if (l2 X⁰ sin(5/36 π) - l2 Y⁰ cos(5/36 π)) / l2²
          + (l2 X⁰ sin(31/36 π) - l2 Y⁰ cos(31/36 π)) / l2² > 0 then 1 else -1
        which way the loop closes: as drawn
  X⁰  = base + l1 cos(φ2⁰) - l1 cos(φ1⁰)
  Y⁰  = l1 sin(φ2⁰) - l1 sin(φ1⁰)
"#;
    /// The equations of motion as a LaTeX document.
    pub const EQUATIONS_LATEX: &str = r#"\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\begin{document}

\section*{five\_bar}
A five-bar: two cranks on ground move the pin where their couplers meet, in both directions.

\subsection*{Loop left\_crank–left\_coupler–right\_coupler–right\_crank}
\begin{align*}
& l_{1}\, e^{i \varphi_{1}} + l_{2}\, e^{i \varphi_{3}} - l_{2}\, e^{i \varphi_{4}} - l_{1}\, e^{i \varphi_{2}} - \mathit{base} = 0 \\
X &= \mathit{base} + l_{1} \cos \varphi_{2} - l_{1} \cos \varphi_{1} \\
Y &= l_{1} \sin \varphi_{2} - l_{1} \sin \varphi_{1} \\
D &= X^{2} + Y^{2} \\
\kappa &= \frac{1}{2} \\
\eta &= \frac{s}{2 \, D} \, \sqrt{D \left(4 \, l_{2}^{2} - D\right)} \\
\cos \varphi_{3} &= \frac{X \, \kappa - Y \, \eta}{l_{2}} \\
\sin \varphi_{3} &= \frac{Y \, \kappa + X \, \eta}{l_{2}} \\
\cos \varphi_{4} &= -\frac{X - X \, \kappa + Y \, \eta}{l_{2}} \\
\sin \varphi_{4} &= \frac{Y \, \kappa - Y + X \, \eta}{l_{2}} \\
& \varphi_{3} = \operatorname{atan2}(\sin \varphi_{3}, \cos \varphi_{3}),\quad \varphi_{4} = \operatorname{atan2}(\sin \varphi_{4}, \cos \varphi_{4}) \quad\text{(continuous over many turns; ${}^0$: as assembled)} \\
\omega_{3,\mathrm{left},\mathrm{crank}} &= \frac{l_{1} \sin\left(\varphi_{4} - \varphi_{1}\right)}{l_{2} \sin\left(\varphi_{3} - \varphi_{4}\right)} \\
\omega_{4,\mathrm{left},\mathrm{crank}} &= \frac{l_{1} \sin\left(\varphi_{3} - \varphi_{1}\right)}{l_{2} \sin\left(\varphi_{3} - \varphi_{4}\right)} \\
\omega_{3,\mathrm{right},\mathrm{crank}} &= \frac{l_{1} \sin\left(\varphi_{2} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{3} - \varphi_{4}\right)} \\
\omega_{4,\mathrm{right},\mathrm{crank}} &= \frac{l_{1} \sin\left(\varphi_{2} - \varphi_{3}\right)}{l_{2} \sin\left(\varphi_{3} - \varphi_{4}\right)} \\
\frac{\partial \omega_{3,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{1}} &= \frac{l_{1} \left(\omega_{4,\mathrm{left},\mathrm{crank}} - 1\right) \cos\left(\varphi_{1} - \varphi_{4}\right) + l_{2} \, \omega_{3,\mathrm{left},\mathrm{crank}} \left(\omega_{4,\mathrm{left},\mathrm{crank}} - \omega_{3,\mathrm{left},\mathrm{crank}}\right) \cos\left(\varphi_{3} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{3} - \varphi_{4}\right)} \\
\frac{\partial \omega_{3,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{2}} &= \frac{l_{1} \, \omega_{4,\mathrm{right},\mathrm{crank}} \cos\left(\varphi_{1} - \varphi_{4}\right) + l_{2} \, \omega_{3,\mathrm{left},\mathrm{crank}} \left(\omega_{4,\mathrm{right},\mathrm{crank}} - \omega_{3,\mathrm{right},\mathrm{crank}}\right) \cos\left(\varphi_{3} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{3} - \varphi_{4}\right)} \\
\frac{\partial \omega_{4,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{1}} &= \frac{l_{1} \left(\omega_{3,\mathrm{left},\mathrm{crank}} - 1\right) \cos\left(\varphi_{1} - \varphi_{3}\right) + l_{2} \, \omega_{4,\mathrm{left},\mathrm{crank}} \left(\omega_{4,\mathrm{left},\mathrm{crank}} - \omega_{3,\mathrm{left},\mathrm{crank}}\right) \cos\left(\varphi_{3} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{3} - \varphi_{4}\right)} \\
\frac{\partial \omega_{4,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{2}} &= \frac{l_{1} \, \omega_{3,\mathrm{right},\mathrm{crank}} \cos\left(\varphi_{1} - \varphi_{3}\right) + l_{2} \, \omega_{4,\mathrm{left},\mathrm{crank}} \left(\omega_{4,\mathrm{right},\mathrm{crank}} - \omega_{3,\mathrm{right},\mathrm{crank}}\right) \cos\left(\varphi_{3} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{3} - \varphi_{4}\right)} \\
\frac{\partial \omega_{3,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{1}} &= \frac{l_{1} \, \omega_{4,\mathrm{left},\mathrm{crank}} \cos\left(\varphi_{2} - \varphi_{4}\right) + l_{2} \, \omega_{3,\mathrm{right},\mathrm{crank}} \left(\omega_{3,\mathrm{left},\mathrm{crank}} - \omega_{4,\mathrm{left},\mathrm{crank}}\right) \cos\left(\varphi_{3} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{4} - \varphi_{3}\right)} \\
\frac{\partial \omega_{3,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{2}} &= \frac{l_{1} \left(\omega_{4,\mathrm{right},\mathrm{crank}} - 1\right) \cos\left(\varphi_{2} - \varphi_{4}\right) + l_{2} \, \omega_{3,\mathrm{right},\mathrm{crank}} \left(\omega_{3,\mathrm{right},\mathrm{crank}} - \omega_{4,\mathrm{right},\mathrm{crank}}\right) \cos\left(\varphi_{3} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{4} - \varphi_{3}\right)} \\
\frac{\partial \omega_{4,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{1}} &= \frac{l_{1} \, \omega_{3,\mathrm{left},\mathrm{crank}} \cos\left(\varphi_{2} - \varphi_{3}\right) + l_{2} \, \omega_{4,\mathrm{right},\mathrm{crank}} \left(\omega_{3,\mathrm{left},\mathrm{crank}} - \omega_{4,\mathrm{left},\mathrm{crank}}\right) \cos\left(\varphi_{3} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{4} - \varphi_{3}\right)} \\
\frac{\partial \omega_{4,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{2}} &= \frac{l_{1} \left(\omega_{3,\mathrm{right},\mathrm{crank}} - 1\right) \cos\left(\varphi_{2} - \varphi_{3}\right) + l_{2} \, \omega_{4,\mathrm{right},\mathrm{crank}} \left(\omega_{3,\mathrm{right},\mathrm{crank}} - \omega_{4,\mathrm{right},\mathrm{crank}}\right) \cos\left(\varphi_{3} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{4} - \varphi_{3}\right)}
\end{align*}

\subsection*{Constants of the inertia}
\begin{align*}
C_{0} &= I_{1} + m_{1} \, r_{1}^{2} + m_{2} \, l_{1}^{2} + \mathit{mt} \, l_{1}^{2} \\
C_{1} &= I_{2} + m_{1} \, r_{2}^{2} + m_{2} \, l_{1}^{2} \\
C_{2} &= I_{3} + m_{2} \, r_{3}^{2} + \mathit{mt} \, l_{2}^{2} \\
C_{3} &= I_{4} + m_{2} \, r_{4}^{2} \\
C_{4} &= 2 \, l_{1} \, m_{2} \, r_{3} + 2 \, l_{1} \, l_{2} \, \mathit{mt} \\
C_{5} &= 2 \, l_{1} \, m_{2} \, r_{4}
\end{align*}

\subsection*{Equations of motion of \texttt{left\_crank}, \texttt{right\_crank}}
\begin{align*}
M_{\mathrm{left},\mathrm{crank}} &= C_{0} \\
&\quad {}+ C_{2} \, \omega_{3,\mathrm{left},\mathrm{crank}}^{2} \\
&\quad {}+ C_{3} \, \omega_{4,\mathrm{left},\mathrm{crank}}^{2} \\
&\quad {}+ C_{4} \, \omega_{3,\mathrm{left},\mathrm{crank}} \cos\left(\varphi_{1} - \varphi_{3}\right) \\
M_{\mathrm{left},\mathrm{crank},\mathrm{right},\mathrm{crank}} &= C_{2} \, \omega_{3,\mathrm{left},\mathrm{crank}} \, \omega_{3,\mathrm{right},\mathrm{crank}} \\
&\quad {}+ C_{3} \, \omega_{4,\mathrm{left},\mathrm{crank}} \, \omega_{4,\mathrm{right},\mathrm{crank}} \\
&\quad {}+ \frac{1}{2} \, C_{4} \, \omega_{3,\mathrm{right},\mathrm{crank}} \cos\left(\varphi_{1} - \varphi_{3}\right) \\
&\quad {}+ \frac{1}{2} \, C_{5} \, \omega_{4,\mathrm{left},\mathrm{crank}} \cos\left(\varphi_{2} - \varphi_{4}\right) \\
M_{\mathrm{right},\mathrm{crank}} &= C_{1} \\
&\quad {}+ C_{2} \, \omega_{3,\mathrm{right},\mathrm{crank}}^{2} \\
&\quad {}+ C_{3} \, \omega_{4,\mathrm{right},\mathrm{crank}}^{2} \\
&\quad {}+ C_{5} \, \omega_{4,\mathrm{right},\mathrm{crank}} \cos\left(\varphi_{2} - \varphi_{4}\right) \\
h_{\mathrm{left},\mathrm{crank}} &= \dot{\varphi}_{1} \, \dot{\varphi}_{2} \left(2 \, C_{2} \, \omega_{3,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{2}} + 2 \, C_{3} \, \omega_{4,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{2}} + C_{4} \, \frac{\partial \omega_{3,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{2}} \cos\left(\varphi_{1} - \varphi_{3}\right) + C_{4} \, \omega_{3,\mathrm{left},\mathrm{crank}} \, \omega_{3,\mathrm{right},\mathrm{crank}} \sin\left(\varphi_{1} - \varphi_{3}\right) - \frac{1}{2} \left(C_{2} \, \omega_{3,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{1}} + C_{2} \, \omega_{3,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{1}} + C_{3} \, \omega_{4,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{1}} + C_{3} \, \omega_{4,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{1}} + \frac{1}{2} \left(C_{4} \, \frac{\partial \omega_{3,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{1}} \cos\left(\varphi_{1} - \varphi_{3}\right) + C_{4} \, \omega_{3,\mathrm{right},\mathrm{crank}} \left(\omega_{3,\mathrm{left},\mathrm{crank}} - 1\right) \sin\left(\varphi_{1} - \varphi_{3}\right)\right) + \frac{1}{2} \left(C_{5} \, \frac{\partial \omega_{4,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{1}} \cos\left(\varphi_{2} - \varphi_{4}\right) + C_{5} \, \omega_{4,\mathrm{left},\mathrm{crank}}^{2} \sin\left(\varphi_{2} - \varphi_{4}\right)\right)\right)\right) \\
&\quad {}+ \dot{\varphi}_{2}^{2} \left(C_{2} \, \omega_{3,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{2}} + C_{2} \, \omega_{3,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{2}} + C_{3} \, \omega_{4,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{2}} + C_{3} \, \omega_{4,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{2}} + \frac{1}{2} \left(C_{4} \, \frac{\partial \omega_{3,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{2}} \cos\left(\varphi_{1} - \varphi_{3}\right) + C_{4} \, \omega_{3,\mathrm{right},\mathrm{crank}}^{2} \sin\left(\varphi_{1} - \varphi_{3}\right)\right) + \frac{1}{2} \left(C_{5} \, \frac{\partial \omega_{4,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{2}} \cos\left(\varphi_{2} - \varphi_{4}\right) + C_{5} \, \omega_{4,\mathrm{left},\mathrm{crank}} \left(\omega_{4,\mathrm{right},\mathrm{crank}} - 1\right) \sin\left(\varphi_{2} - \varphi_{4}\right)\right) - \frac{1}{2} \left(2 \, C_{2} \, \omega_{3,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{1}} + 2 \, C_{3} \, \omega_{4,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{1}} + C_{5} \, \frac{\partial \omega_{4,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{1}} \cos\left(\varphi_{2} - \varphi_{4}\right) + C_{5} \, \omega_{4,\mathrm{left},\mathrm{crank}} \, \omega_{4,\mathrm{right},\mathrm{crank}} \sin\left(\varphi_{2} - \varphi_{4}\right)\right)\right) \\
&\quad {}+ \frac{1}{2} \, \dot{\varphi}_{1}^{2} \left(2 \, C_{2} \, \omega_{3,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{1}} + 2 \, C_{3} \, \omega_{4,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{1}} + C_{4} \, \frac{\partial \omega_{3,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{1}} \cos\left(\varphi_{1} - \varphi_{3}\right) + C_{4} \, \omega_{3,\mathrm{left},\mathrm{crank}} \left(\omega_{3,\mathrm{left},\mathrm{crank}} - 1\right) \sin\left(\varphi_{1} - \varphi_{3}\right)\right) \\
&\quad {}+ \frac{1}{2} \, \dot{\varphi}_{1} \, \dot{\varphi}_{2} \left(C_{2} \, \omega_{3,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{1}} + C_{2} \, \omega_{3,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{1}} + C_{3} \, \omega_{4,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{1}} + C_{3} \, \omega_{4,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{1}} + \frac{1}{2} \left(C_{4} \, \frac{\partial \omega_{3,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{1}} \cos\left(\varphi_{1} - \varphi_{3}\right) + C_{4} \, \omega_{3,\mathrm{right},\mathrm{crank}} \left(\omega_{3,\mathrm{left},\mathrm{crank}} - 1\right) \sin\left(\varphi_{1} - \varphi_{3}\right)\right) + \frac{1}{2} \left(C_{5} \, \frac{\partial \omega_{4,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{1}} \cos\left(\varphi_{2} - \varphi_{4}\right) + C_{5} \, \omega_{4,\mathrm{left},\mathrm{crank}}^{2} \sin\left(\varphi_{2} - \varphi_{4}\right)\right)\right) \\
h_{\mathrm{right},\mathrm{crank}} &= \dot{\varphi}_{1}^{2} \left(C_{2} \, \omega_{3,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{1}} - \frac{1}{2} \left(2 \, C_{2} \, \omega_{3,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{2}} + 2 \, C_{3} \, \omega_{4,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{2}} + C_{4} \, \frac{\partial \omega_{3,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{2}} \cos\left(\varphi_{1} - \varphi_{3}\right) + C_{4} \, \omega_{3,\mathrm{left},\mathrm{crank}} \, \omega_{3,\mathrm{right},\mathrm{crank}} \sin\left(\varphi_{1} - \varphi_{3}\right)\right) + C_{2} \, \omega_{3,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{1}} + C_{3} \, \omega_{4,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{1}} + C_{3} \, \omega_{4,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{1}} + \frac{1}{2} \left(C_{4} \, \frac{\partial \omega_{3,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{1}} \cos\left(\varphi_{1} - \varphi_{3}\right) + C_{4} \, \omega_{3,\mathrm{right},\mathrm{crank}} \left(\omega_{3,\mathrm{left},\mathrm{crank}} - 1\right) \sin\left(\varphi_{1} - \varphi_{3}\right)\right) + \frac{1}{2} \left(C_{5} \, \frac{\partial \omega_{4,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{1}} \cos\left(\varphi_{2} - \varphi_{4}\right) + C_{5} \, \omega_{4,\mathrm{left},\mathrm{crank}}^{2} \sin\left(\varphi_{2} - \varphi_{4}\right)\right)\right) \\
&\quad {}+ \dot{\varphi}_{1} \, \dot{\varphi}_{2} \left(2 \, C_{2} \, \omega_{3,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{1}} - \frac{1}{2} \left(C_{2} \, \omega_{3,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{2}} + C_{2} \, \omega_{3,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{2}} + C_{3} \, \omega_{4,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{2}} + C_{3} \, \omega_{4,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{2}} + \frac{1}{2} \left(C_{4} \, \frac{\partial \omega_{3,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{2}} \cos\left(\varphi_{1} - \varphi_{3}\right) + C_{4} \, \omega_{3,\mathrm{right},\mathrm{crank}}^{2} \sin\left(\varphi_{1} - \varphi_{3}\right)\right) + \frac{1}{2} \left(C_{5} \, \frac{\partial \omega_{4,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{2}} \cos\left(\varphi_{2} - \varphi_{4}\right) + C_{5} \, \omega_{4,\mathrm{left},\mathrm{crank}} \left(\omega_{4,\mathrm{right},\mathrm{crank}} - 1\right) \sin\left(\varphi_{2} - \varphi_{4}\right)\right)\right) + 2 \, C_{3} \, \omega_{4,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{1}} + C_{5} \, \frac{\partial \omega_{4,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{1}} \cos\left(\varphi_{2} - \varphi_{4}\right) + C_{5} \, \omega_{4,\mathrm{left},\mathrm{crank}} \, \omega_{4,\mathrm{right},\mathrm{crank}} \sin\left(\varphi_{2} - \varphi_{4}\right)\right) \\
&\quad {}+ \frac{1}{2} \, \dot{\varphi}_{1} \, \dot{\varphi}_{2} \left(C_{2} \, \omega_{3,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{2}} + C_{2} \, \omega_{3,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{2}} + C_{3} \, \omega_{4,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{2}} + C_{3} \, \omega_{4,\mathrm{left},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{2}} + \frac{1}{2} \left(C_{4} \, \frac{\partial \omega_{3,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{2}} \cos\left(\varphi_{1} - \varphi_{3}\right) + C_{4} \, \omega_{3,\mathrm{right},\mathrm{crank}}^{2} \sin\left(\varphi_{1} - \varphi_{3}\right)\right) + \frac{1}{2} \left(C_{5} \, \frac{\partial \omega_{4,\mathrm{left},\mathrm{crank}}}{\partial \varphi_{2}} \cos\left(\varphi_{2} - \varphi_{4}\right) + C_{5} \, \omega_{4,\mathrm{left},\mathrm{crank}} \left(\omega_{4,\mathrm{right},\mathrm{crank}} - 1\right) \sin\left(\varphi_{2} - \varphi_{4}\right)\right)\right) \\
&\quad {}+ \frac{1}{2} \, \dot{\varphi}_{2}^{2} \left(2 \, C_{2} \, \omega_{3,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{3,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{2}} + 2 \, C_{3} \, \omega_{4,\mathrm{right},\mathrm{crank}} \, \frac{\partial \omega_{4,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{2}} + C_{5} \, \frac{\partial \omega_{4,\mathrm{right},\mathrm{crank}}}{\partial \varphi_{2}} \cos\left(\varphi_{2} - \varphi_{4}\right) + C_{5} \, \omega_{4,\mathrm{right},\mathrm{crank}} \left(\omega_{4,\mathrm{right},\mathrm{crank}} - 1\right) \sin\left(\varphi_{2} - \varphi_{4}\right)\right) \\
\frac{\partial P_s}{\partial \varphi_{1}} &= k \left(\varphi_{1} - \varphi_{1}^0\right) \\
&\quad {}+ k \left(\omega_{3,\mathrm{left},\mathrm{crank}} - 1\right) \left(\varphi_{3} - \varphi_{3}^0 - \varphi_{1} + \varphi_{1}^0\right) \\
&\quad {}+ k \, \omega_{4,\mathrm{left},\mathrm{crank}} \left(\varphi_{4} - \varphi_{4}^0 - \varphi_{2} + \varphi_{2}^0\right) \\
&\quad {}+ k \left(\omega_{3,\mathrm{left},\mathrm{crank}} - \omega_{4,\mathrm{left},\mathrm{crank}}\right) \left(\varphi_{3} - \varphi_{3}^0 - \left(\varphi_{4} - \varphi_{4}^0\right)\right) \\
\tau_{1} &= \mathit{left}_{\mathrm{torque}} \sin\left(2 \, \pi \, f \, t\right) \\
&\quad {}- c \, \dot{\varphi}_{1} \\
&\quad {}+ c \left(1 - \omega_{3,\mathrm{left},\mathrm{crank}}\right) \left(\dot{\varphi}_{1} \left(\omega_{3,\mathrm{left},\mathrm{crank}} - 1\right) + \omega_{3,\mathrm{right},\mathrm{crank}} \, \dot{\varphi}_{2}\right) \\
&\quad {}- c \, \omega_{4,\mathrm{left},\mathrm{crank}} \left(\omega_{4,\mathrm{left},\mathrm{crank}} \, \dot{\varphi}_{1} + \dot{\varphi}_{2} \left(\omega_{4,\mathrm{right},\mathrm{crank}} - 1\right)\right) \\
&\quad {}+ c \left(\omega_{4,\mathrm{left},\mathrm{crank}} - \omega_{3,\mathrm{left},\mathrm{crank}}\right) \left(\dot{\varphi}_{1} \left(\omega_{3,\mathrm{left},\mathrm{crank}} - \omega_{4,\mathrm{left},\mathrm{crank}}\right) + \dot{\varphi}_{2} \left(\omega_{3,\mathrm{right},\mathrm{crank}} - \omega_{4,\mathrm{right},\mathrm{crank}}\right)\right) \\
\frac{\partial P_s}{\partial \varphi_{2}} &= k \left(\varphi_{2} - \varphi_{2}^0\right) \\
&\quad {}+ k \, \omega_{3,\mathrm{right},\mathrm{crank}} \left(\varphi_{3} - \varphi_{3}^0 - \varphi_{1} + \varphi_{1}^0\right) \\
&\quad {}+ k \left(\omega_{4,\mathrm{right},\mathrm{crank}} - 1\right) \left(\varphi_{4} - \varphi_{4}^0 - \varphi_{2} + \varphi_{2}^0\right) \\
&\quad {}+ k \left(\omega_{3,\mathrm{right},\mathrm{crank}} - \omega_{4,\mathrm{right},\mathrm{crank}}\right) \left(\varphi_{3} - \varphi_{3}^0 - \left(\varphi_{4} - \varphi_{4}^0\right)\right) \\
\tau_{2} &= \mathit{right}_{\mathrm{torque}} \cos\left(2 \, \pi \, f \, t\right) \\
&\quad {}- c \, \dot{\varphi}_{2} \\
&\quad {}- c \, \omega_{3,\mathrm{right},\mathrm{crank}} \left(\dot{\varphi}_{1} \left(\omega_{3,\mathrm{left},\mathrm{crank}} - 1\right) + \omega_{3,\mathrm{right},\mathrm{crank}} \, \dot{\varphi}_{2}\right) \\
&\quad {}+ c \left(1 - \omega_{4,\mathrm{right},\mathrm{crank}}\right) \left(\omega_{4,\mathrm{left},\mathrm{crank}} \, \dot{\varphi}_{1} + \dot{\varphi}_{2} \left(\omega_{4,\mathrm{right},\mathrm{crank}} - 1\right)\right) \\
&\quad {}+ c \left(\omega_{4,\mathrm{right},\mathrm{crank}} - \omega_{3,\mathrm{right},\mathrm{crank}}\right) \left(\dot{\varphi}_{1} \left(\omega_{3,\mathrm{left},\mathrm{crank}} - \omega_{4,\mathrm{left},\mathrm{crank}}\right) + \dot{\varphi}_{2} \left(\omega_{3,\mathrm{right},\mathrm{crank}} - \omega_{4,\mathrm{right},\mathrm{crank}}\right)\right) \\
& M_{\mathrm{left},\mathrm{crank}}\,\ddot{\varphi}_{1} + M_{\mathrm{left},\mathrm{crank},\mathrm{right},\mathrm{crank}}\,\ddot{\varphi}_{2} + h_{\mathrm{left},\mathrm{crank}} + \frac{\partial P_s}{\partial \varphi_{1}} = \tau_{1} \\
& M_{\mathrm{left},\mathrm{crank},\mathrm{right},\mathrm{crank}}\,\ddot{\varphi}_{1} + M_{\mathrm{right},\mathrm{crank}}\,\ddot{\varphi}_{2} + h_{\mathrm{right},\mathrm{crank}} + \frac{\partial P_s}{\partial \varphi_{2}} = \tau_{2}
\end{align*}

\subsection*{Constants}
\begin{align*}
r_{1} &= \frac{1}{2} \, l_{1} && \text{distance of the centre of mass from the first end of left\_crank} \\
I_{1} &= \frac{1}{12} \, m_{1} \, l_{1}^{2} && \text{moment of inertia about the centre of mass of left\_crank} \\
r_{2} &= \frac{1}{2} \, l_{1} && \text{distance of the centre of mass from the first end of right\_crank} \\
I_{2} &= \frac{1}{12} \, m_{1} \, l_{1}^{2} && \text{moment of inertia about the centre of mass of right\_crank} \\
r_{3} &= \frac{1}{2} \, l_{2} && \text{distance of the centre of mass from the first end of left\_coupler} \\
I_{3} &= \frac{1}{12} \, m_{2} \, l_{2}^{2} && \text{moment of inertia about the centre of mass of left\_coupler} \\
r_{4} &= \frac{1}{2} \, l_{2} && \text{distance of the centre of mass from the first end of right\_coupler} \\
I_{4} &= \frac{1}{12} \, m_{2} \, l_{2}^{2} && \text{moment of inertia about the centre of mass of right\_coupler} \\
\varphi_{1}^0 &= \frac{2}{3} \, \pi && \text{angle of \texttt{left\_crank} as assembled} \\
\varphi_{2}^0 &= \frac{1}{3} \, \pi && \text{angle of \texttt{right\_crank} as assembled} \\
s &= \begin{cases} 1 & \text{if } \frac{l_{2} \, {X}^0 \sin\left(\frac{5}{36} \, \pi\right) - l_{2} \, {Y}^0 \cos\left(\frac{5}{36} \, \pi\right)}{l_{2}^{2}} + \frac{l_{2} \, {X}^0 \sin\left(\frac{31}{36} \, \pi\right) - l_{2} \, {Y}^0 \cos\left(\frac{31}{36} \, \pi\right)}{l_{2}^{2}} > 0 \\ -1 & \text{otherwise} \end{cases} && \text{which way the loop closes: as drawn} \\
{X}^0 &= \mathit{base} + l_{1} \cos \varphi_{2}^0 - l_{1} \cos \varphi_{1}^0 \\
{Y}^0 &= l_{1} \sin \varphi_{2}^0 - l_{1} \sin \varphi_{1}^0
\end{align*}

\end{document}
"#;
}
