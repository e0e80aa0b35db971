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
    use ::flexure_runtime::lanes::{LaneSystem, Lanes};
    use ::flexure_runtime::newton;
    use ::flexure_runtime::real::Real;
    use ::flexure_runtime::simulate::PlainSteps;
    use ::flexure_runtime::system::{Causality, Energy, EventAction, System, Variable};
    use ::flexure_runtime::table::{Curve, CurveReport, Table, TableReport};
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
            let t3 = Y_0 * 0.9063077870366499;
            let t4 = (X_0 * 0.42261826174069944 - t3) / l2
                + (X_0 * 0.4226182617406995 + t3) / l2;
            // which way the loop closes: as drawn
            let ε = t4.if_positive(1.0, -1.0);
            let η_0 = ε * t1.sqrt() * 0.5 / D_0;
            let X_0_η_0 = X_0 * η_0;
            let s4_0 = -((half_Y_0 - X_0_η_0) / l2);
            let half_X_0 = X_0 * 0.5;
            let Y_0_η_0 = Y_0 * η_0;
            let c4_0 = -((half_X_0 + Y_0_η_0) / l2);
            // angle of `right_coupler` as assembled
            let φ4_0 = Real::atan2(s4_0, c4_0).unwrap_to(2.705260340591211);
            let s3_0 = (half_Y_0 + X_0_η_0) / l2;
            let c3_0 = (half_X_0 - Y_0_η_0) / l2;
            // angle of `left_coupler` as assembled
            let φ3_0 = Real::atan2(s3_0, c3_0).unwrap_to(0.4363323129985824);
            let l2_sin_φ3_0_minus_φ4_0 = l2 * Real::sin(φ3_0 - φ4_0);
            let t5 = l1 * Real::sin(2.0943951023931953 - φ4_0)
                / l2_sin_φ3_0_minus_φ4_0;
            // rate as assembled
            let ω3_1_0 = -t5;
            let t6 = 2.0943951023931953 - φ3_0;
            let (t7, t8) = Real::sin_cos(t6);
            // rate as assembled
            let ω4_1_0 = -(l1 * t7 / l2_sin_φ3_0_minus_φ4_0);
            let l1_m2_r3 = l1 * m2 * r3;
            // constant of the inertia
            let C5 = l1_m2_r3 * 2.0;
            // constant of the inertia
            let C4 = C5 + l1 * l2 * mt * 2.0;
            // inertia as assembled
            let A_left_crank_0 = C0 + C2 * (ω3_1_0 * ω3_1_0) + C3 * (ω4_1_0 * ω4_1_0)
                + C4 * ω3_1_0 * t8;
            let t9 = 1.0471975511965976 - φ4_0;
            let (t10, t11) = Real::sin_cos(t9);
            // rate as assembled
            let ω3_2_0 = l1 * t10 / l2_sin_φ3_0_minus_φ4_0;
            // rate as assembled
            let ω4_2_0 = l1 * Real::sin(1.0471975511965976 - φ3_0)
                / l2_sin_φ3_0_minus_φ4_0;
            // inertia as assembled
            let A_right_crank_0 = C1 + C2 * (ω3_2_0 * ω3_2_0)
                + C3 * (ω4_2_0 * ω4_2_0) + l1_m2_r3 * ω4_2_0 * t11 * 2.0;
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
                half_ε: ε * 0.5,
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
                two_C5: C5 * 2.0,
                _3_C5: C5 * 3.0,
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
        /// `0.5 * ε`
        pub half_ε: T,
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
        /// `2.0 * C5`
        pub two_C5: T,
        /// `3.0 * C5`
        pub _3_C5: T,
        /// `3.0 * C4`
        pub _3_C4: T,
        /// `0.5 * k`
        pub half_k: T,
        /// `0.25 / (l2 * l2 * l2 * l2)`
        pub constant2: T,
    }
    impl<T: Copy> Prepared<T> {
        /// The same with every number turned into another, without curves: for dual numbers or lanes.
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
                half_ε: turn(self.half_ε),
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
                two_C5: turn(self.two_C5),
                _3_C5: turn(self._3_C5),
                _3_C4: turn(self._3_C4),
                half_k: turn(self.half_k),
                constant2: turn(self.constant2),
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
                base: join(self.base, other.base),
                l1: join(self.l1, other.l1),
                l2: join(self.l2, other.l2),
                k: join(self.k, other.k),
                c: join(self.c, other.c),
                left_torque: join(self.left_torque, other.left_torque),
                right_torque: join(self.right_torque, other.right_torque),
                C1: join(self.C1, other.C1),
                C0: join(self.C0, other.C0),
                _4_l2_squared: join(self._4_l2_squared, other._4_l2_squared),
                half_ε: join(self.half_ε, other.half_ε),
                per_l2: join(self.per_l2, other.per_l2),
                l1_per_l2: join(self.l1_per_l2, other.l1_per_l2),
                C3: join(self.C3, other.C3),
                C2: join(self.C2, other.C2),
                C5: join(self.C5, other.C5),
                C4: join(self.C4, other.C4),
                half_C4: join(self.half_C4, other.half_C4),
                half_C5: join(self.half_C5, other.half_C5),
                c3_0: join(self.c3_0, other.c3_0),
                s3_0: join(self.s3_0, other.s3_0),
                c4_0: join(self.c4_0, other.c4_0),
                s4_0: join(self.s4_0, other.s4_0),
                constant1: join(self.constant1, other.constant1),
                two_C2: join(self.two_C2, other.two_C2),
                two_C3: join(self.two_C3, other.two_C3),
                two_C4: join(self.two_C4, other.two_C4),
                two_C5: join(self.two_C5, other.two_C5),
                _3_C5: join(self._3_C5, other._3_C5),
                _3_C4: join(self._3_C4, other._3_C4),
                half_k: join(self.half_k, other.half_k),
                constant2: join(self.constant2, other.constant2),
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
        let η = p.half_ε * (D.recip() * (D * (p._4_l2_squared - D)).sqrt());
        let X_η = X * η;
        let s3 = p.per_l2 * (half_Y + X_η);
        let half_X = X * 0.5;
        let Y_η = Y * η;
        let c4 = -(p.per_l2 * (half_X + Y_η));
        let c3 = p.per_l2 * (half_X - Y_η);
        let s4 = -(p.per_l2 * (half_Y - X_η));
        let sin_φ3_minus_φ4 = s3 * c4 - c3 * s4;
        let per_sin_φ3_minus_φ4 = sin_φ3_minus_φ4.recip();
        let sin_φ1_minus_φ4 = sin_φ1 * c4 - cos_φ1 * s4;
        let t1 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ1_minus_φ4);
        // rate of the angle of `left_coupler` per unit rate of `left_crank`
        let ω3_1 = -t1;
        let sin_φ1_minus_φ3 = sin_φ1 * c3 - cos_φ1 * s3;
        let t2 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ1_minus_φ3);
        // rate of the angle of `right_coupler` per unit rate of `left_crank`
        let ω4_1 = -t2;
        let ω4_1_squared = ω4_1 * ω4_1;
        let cos_φ1_minus_φ3 = cos_φ1 * c3 + sin_φ1 * s3;
        // inertia
        let M11 = p.C0 + p.C2 * (ω3_1 * ω3_1) + p.C3 * ω4_1_squared
            + p.C4 * (ω3_1 * cos_φ1_minus_φ3);
        let sin_φ2_minus_φ4 = sin_φ2 * c4 - cos_φ2 * s4;
        // rate of the angle of `left_coupler` per unit rate of `right_crank`
        let ω3_2 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ2_minus_φ4);
        let ω3_2_squared = ω3_2 * ω3_2;
        let sin_φ2_minus_φ3 = sin_φ2 * c3 - cos_φ2 * s3;
        // rate of the angle of `right_coupler` per unit rate of `right_crank`
        let ω4_2 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ2_minus_φ3);
        let cos_φ2_minus_φ4 = cos_φ2 * c4 + sin_φ2 * s4;
        // inertia
        let M22 = p.C1 + p.C2 * ω3_2_squared + p.C3 * (ω4_2 * ω4_2)
            + p.C5 * (ω4_2 * cos_φ2_minus_φ4);
        let ω3_2_cos_φ1_minus_φ3 = ω3_2 * cos_φ1_minus_φ3;
        let t3 = p.C2 * (ω3_1 * ω3_2) + p.C3 * (ω4_1 * ω4_2)
            + p.half_C4 * ω3_2_cos_φ1_minus_φ3;
        let ω4_1_cos_φ2_minus_φ4 = ω4_1 * cos_φ2_minus_φ4;
        // inertia
        let M12 = t3 + p.half_C5 * ω4_1_cos_φ2_minus_φ4;
        // determinant of the inertia
        let det_M = M11 * M22 - M12 * M12;
        let per_det_M = det_M.recip();
        let ω3_1_minus_one = ω3_1 - 1.0;
        let t4 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `left_coupler` from the assembled one
        let φ3_minus_φ3_0 = t4.unwrap_to(turn_left_coupler);
        let t5 = T::from_f64(2.0943951023931953) - φ1 + φ3_minus_φ3_0;
        let t6 = (p.c4_0 * s4 - p.s4_0 * c4).atan2(p.c4_0 * c4 + p.s4_0 * s4);
        // angle of `right_coupler` from the assembled one
        let φ4_minus_φ4_0 = t6.unwrap_to(turn_right_coupler);
        let t7 = T::from_f64(1.0471975511965976) - φ2 + φ4_minus_φ4_0;
        let t8 = p.k * (φ1 - 2.0943951023931953) + p.k * (ω3_1_minus_one * t5)
            + p.k * (ω4_1 * t7);
        let t9 = t2 - t1;
        let t10 = φ3_minus_φ3_0 - φ4_minus_φ4_0;
        // slope of the potential energy of springs
        let dP_s_dφ1 = t8 + p.k * (t9 * t10);
        let cos_φ1_minus_φ4 = cos_φ1 * c4 + sin_φ1 * s4;
        let cos_φ3_minus_φ4 = c3 * c4 + s3 * s4;
        let ω3_2_minus_ω4_2 = ω3_2 - ω4_2;
        let t11 = p.l1 * (ω4_2 * cos_φ1_minus_φ4)
            - p.l2 * (ω3_1 * cos_φ3_minus_φ4 * ω3_2_minus_ω4_2);
        let dω3_1_dφ2 = p.per_l2 * (per_sin_φ3_minus_φ4 * t11);
        let t12 = p.l1 * ω3_2_cos_φ1_minus_φ3
            - p.l2 * (ω4_1 * cos_φ3_minus_φ4 * ω3_2_minus_ω4_2);
        let dω4_1_dφ2 = p.per_l2 * (per_sin_φ3_minus_φ4 * t12);
        let t13 = p.two_C2 * (ω3_1 * dω3_1_dφ2) + p.two_C3 * (ω4_1 * dω4_1_dφ2)
            + p.C4 * (dω3_1_dφ2 * cos_φ1_minus_φ3);
        let sin_φ1_minus_φ3_ω3_1 = sin_φ1_minus_φ3 * ω3_1;
        // slope of the inertia
        let dM11_dφ2 = t13 + p.C4 * (sin_φ1_minus_φ3_ω3_1 * ω3_2);
        let t14 = p.l1 * (cos_φ1_minus_φ4 * (ω4_1 - 1.0))
            - p.l2 * (ω3_1 * t9 * cos_φ3_minus_φ4);
        let dω3_1_dφ1 = p.per_l2 * (per_sin_φ3_minus_φ4 * t14);
        let t15 = p.l1 * (cos_φ1_minus_φ3 * ω3_1_minus_one)
            - p.l2 * (ω4_1 * t9 * cos_φ3_minus_φ4);
        let dω4_1_dφ1 = p.per_l2 * (per_sin_φ3_minus_φ4 * t15);
        let t16 = p.two_C2 * (ω3_1 * dω3_1_dφ1) + p.two_C3 * (ω4_1 * dω4_1_dφ1)
            + p.C4 * (dω3_1_dφ1 * cos_φ1_minus_φ3);
        // slope of the inertia
        let dM11_dφ1 = t16 + p.C4 * (sin_φ1_minus_φ3_ω3_1 * ω3_1_minus_one);
        let t17 = p.l1 * ω4_1_cos_φ2_minus_φ4
            + p.l2 * (ω3_2 * t9 * cos_φ3_minus_φ4);
        let dω3_2_dφ1 = -(p.per_l2 * (per_sin_φ3_minus_φ4 * t17));
        let cos_φ2_minus_φ3 = cos_φ2 * c3 + sin_φ2 * s3;
        let t18 = p.l1 * (ω3_1 * cos_φ2_minus_φ3)
            + p.l2 * (ω4_2 * t9 * cos_φ3_minus_φ4);
        let dω4_2_dφ1 = -(p.per_l2 * (per_sin_φ3_minus_φ4 * t18));
        let t19 = p.two_C2 * (ω3_2 * dω3_2_dφ1) + p.two_C3 * (ω4_2 * dω4_2_dφ1)
            + p.C5 * (cos_φ2_minus_φ4 * dω4_2_dφ1);
        let ω4_1_sin_φ2_minus_φ4 = ω4_1 * sin_φ2_minus_φ4;
        // slope of the inertia
        let dM22_dφ1 = t19 + p.C5 * (ω4_1_sin_φ2_minus_φ4 * ω4_2);
        let ω4_2_minus_one = ω4_2 - 1.0;
        let t20 = p.l1 * (cos_φ2_minus_φ4 * ω4_2_minus_one)
            + p.l2 * (ω3_2 * cos_φ3_minus_φ4 * ω3_2_minus_ω4_2);
        let dω3_2_dφ2 = -(p.per_l2 * (per_sin_φ3_minus_φ4 * t20));
        let t21 = p.C2 * (ω3_2 * dω3_1_dφ2) + p.C2 * (ω3_1 * dω3_2_dφ2)
            + p.C3 * (ω4_2 * dω4_1_dφ2);
        let t22 = p.l1 * (cos_φ2_minus_φ3 * (ω3_2 - 1.0))
            + p.l2 * (ω4_2 * cos_φ3_minus_φ4 * ω3_2_minus_ω4_2);
        let dω4_2_dφ2 = -(p.per_l2 * (per_sin_φ3_minus_φ4 * t22));
        let t23 = p.C4 * (cos_φ1_minus_φ3 * dω3_2_dφ2)
            + p.C4 * (sin_φ1_minus_φ3 * ω3_2_squared);
        let t24 = p.C5 * (dω4_1_dφ2 * cos_φ2_minus_φ4)
            + p.C5 * (ω4_1_sin_φ2_minus_φ4 * ω4_2_minus_one);
        // slope of the inertia
        let dM12_dφ2 = t21 + p.C3 * (ω4_1 * dω4_2_dφ2) + t23 * 0.5 + t24 * 0.5;
        let t25 = p.k * (φ2 - 1.0471975511965976) + p.k * (ω3_2 * t5)
            + p.k * (ω4_2_minus_one * t7);
        // slope of the potential energy of springs
        let dP_s_dφ2 = t25 + p.k * (ω3_2_minus_ω4_2 * t10);
        let t26 = p.C2 * (ω3_2 * dω3_1_dφ1) + p.C2 * (ω3_1 * dω3_2_dφ1)
            + p.C3 * (ω4_2 * dω4_1_dφ1);
        let t27 = p.C4 * (cos_φ1_minus_φ3 * dω3_2_dφ1)
            + p.C4 * (sin_φ1_minus_φ3 * ω3_2 * ω3_1_minus_one);
        let t28 = p.C5 * (dω4_1_dφ1 * cos_φ2_minus_φ4)
            + p.C5 * (ω4_1_squared * sin_φ2_minus_φ4);
        // slope of the inertia
        let dM12_dφ1 = t26 + p.C3 * (ω4_1 * dω4_2_dφ1) + t27 * 0.5 + t28 * 0.5;
        let t29 = p.two_C2 * (ω3_2 * dω3_2_dφ2) + p.two_C3 * (ω4_2 * dω4_2_dφ2)
            + p.C5 * (cos_φ2_minus_φ4 * dω4_2_dφ2);
        // slope of the inertia
        let dM22_dφ2 = t29 + p.C5 * (sin_φ2_minus_φ4 * ω4_2 * ω4_2_minus_one);
        // ── state ──
        let dφ1_dφ2 = dφ1 * dφ2;
        let dφ1_squared = dφ1 * dφ1;
        let dφ2_squared = dφ2 * dφ2;
        // centrifugal and Coriolis terms
        let h1 = (dM11_dφ2 * dφ1_dφ2)
            .plus_product(dM11_dφ1 * 0.5, dφ1_squared)
            .minus_product(dM22_dφ1 * 0.5 - dM12_dφ2, dφ2_squared);
        let t30 = p.constant1 * t;
        let (t31, t32) = t30.sin_cos();
        let t33 = (ω3_1_minus_one * dφ1).plus_product(ω3_2, dφ2);
        let t34 = (p.left_torque * t31)
            .minus_product(p.c, dφ1)
            .minus_product(p.c * ω3_1_minus_one, t33);
        let t35 = (ω4_1 * dφ1).plus_product(ω4_2_minus_one, dφ2);
        let t36 = (t9 * dφ1).plus_product(ω3_2_minus_ω4_2, dφ2);
        // generalized torque of all other forces
        let τ1 = t34.minus_product(p.c * ω4_1, t35).minus_product(p.c * t9, t36);
        let t37 = dP_s_dφ1 + h1 - τ1;
        let t38 = ((dM12_dφ1 - dM11_dφ2 * 0.5) * dφ1_squared)
            .plus_product(dM22_dφ1, dφ1_dφ2);
        // centrifugal and Coriolis terms
        let h2 = t38.plus_product(dM22_dφ2 * 0.5, dφ2_squared);
        let t39 = (p.right_torque * t32)
            .minus_product(p.c, dφ2)
            .minus_product(p.c * ω3_2, t33);
        // generalized torque of all other forces
        let τ2 = t39
            .minus_product(p.c * ω4_2_minus_one, t35)
            .minus_product(p.c * ω3_2_minus_ω4_2, t36);
        let t40 = dP_s_dφ2 + h2 - τ2;
        let ddφ1 = -(per_det_M * (M22 * t37).minus_product(M12, t40));
        let ddφ2 = -(per_det_M * (M11 * t40).minus_product(M12, t37));
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
        let η = p.half_ε * (D.recip() * (D * (p._4_l2_squared - D)).sqrt());
        let X_η = X * η;
        let s3 = p.per_l2 * (half_Y + X_η);
        let half_X = X * 0.5;
        let Y_η = Y * η;
        let c4 = -(p.per_l2 * (half_X + Y_η));
        let c3 = p.per_l2 * (half_X - Y_η);
        let s4 = -(p.per_l2 * (half_Y - X_η));
        let sin_φ3_minus_φ4 = s3 * c4 - c3 * s4;
        let per_sin_φ3_minus_φ4 = sin_φ3_minus_φ4.recip();
        let sin_φ1_minus_φ4 = sin_φ1 * c4 - cos_φ1 * s4;
        let t1 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ1_minus_φ4);
        // rate of the angle of `left_coupler` per unit rate of `left_crank`
        let ω3_1 = -t1;
        let ω3_1_squared = ω3_1 * ω3_1;
        let sin_φ1_minus_φ3 = sin_φ1 * c3 - cos_φ1 * s3;
        let t2 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ1_minus_φ3);
        // rate of the angle of `right_coupler` per unit rate of `left_crank`
        let ω4_1 = -t2;
        let ω4_1_squared = ω4_1 * ω4_1;
        let cos_φ1_minus_φ3 = cos_φ1 * c3 + sin_φ1 * s3;
        let ω3_1_cos_φ1_minus_φ3 = ω3_1 * cos_φ1_minus_φ3;
        // inertia
        let M11 = p.C0 + p.C2 * ω3_1_squared + p.C3 * ω4_1_squared
            + p.C4 * ω3_1_cos_φ1_minus_φ3;
        let sin_φ2_minus_φ4 = sin_φ2 * c4 - cos_φ2 * s4;
        // rate of the angle of `left_coupler` per unit rate of `right_crank`
        let ω3_2 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ2_minus_φ4);
        let ω3_2_squared = ω3_2 * ω3_2;
        let sin_φ2_minus_φ3 = sin_φ2 * c3 - cos_φ2 * s3;
        // rate of the angle of `right_coupler` per unit rate of `right_crank`
        let ω4_2 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ2_minus_φ3);
        let ω4_2_squared = ω4_2 * ω4_2;
        let cos_φ2_minus_φ4 = cos_φ2 * c4 + sin_φ2 * s4;
        let ω4_2_cos_φ2_minus_φ4 = ω4_2 * cos_φ2_minus_φ4;
        // inertia
        let M22 = p.C1 + p.C2 * ω3_2_squared + p.C3 * ω4_2_squared
            + p.C5 * ω4_2_cos_φ2_minus_φ4;
        let ω3_1_ω3_2 = ω3_1 * ω3_2;
        let ω4_1_ω4_2 = ω4_1 * ω4_2;
        let ω3_2_cos_φ1_minus_φ3 = ω3_2 * cos_φ1_minus_φ3;
        let t3 = p.C2 * ω3_1_ω3_2 + p.C3 * ω4_1_ω4_2
            + p.half_C4 * ω3_2_cos_φ1_minus_φ3;
        let ω4_1_cos_φ2_minus_φ4 = ω4_1 * cos_φ2_minus_φ4;
        // inertia
        let M12 = t3 + p.half_C5 * ω4_1_cos_φ2_minus_φ4;
        // determinant of the inertia
        let det_M = M11 * M22 - M12 * M12;
        let per_det_M_squared = (det_M * det_M).recip();
        let cos_φ1_minus_φ4 = cos_φ1 * c4 + sin_φ1 * s4;
        let ω4_1_minus_one = ω4_1 - 1.0;
        let t4 = t2 - t1;
        let cos_φ3_minus_φ4 = c3 * c4 + s3 * s4;
        let t5 = p.l1 * (cos_φ1_minus_φ4 * ω4_1_minus_one)
            - p.l2 * (ω3_1 * t4 * cos_φ3_minus_φ4);
        let dω3_1_dφ1 = p.per_l2 * (per_sin_φ3_minus_φ4 * t5);
        let ω3_1_minus_one = ω3_1 - 1.0;
        let t6 = p.l1 * (cos_φ1_minus_φ3 * ω3_1_minus_one)
            - p.l2 * (ω4_1 * t4 * cos_φ3_minus_φ4);
        let dω4_1_dφ1 = p.per_l2 * (per_sin_φ3_minus_φ4 * t6);
        let t7 = dω3_1_dφ1 * cos_φ1_minus_φ3;
        let t8 = p.two_C2 * (ω3_1 * dω3_1_dφ1) + p.two_C3 * (ω4_1 * dω4_1_dφ1)
            + p.C4 * t7;
        let sin_φ1_minus_φ3_ω3_1 = sin_φ1_minus_φ3 * ω3_1;
        // slope of the inertia
        let dM11_dφ1 = t8 + p.C4 * (sin_φ1_minus_φ3_ω3_1 * ω3_1_minus_one);
        let t9 = p.l1 * ω4_1_cos_φ2_minus_φ4
            + p.l2 * (ω3_2 * t4 * cos_φ3_minus_φ4);
        let t10 = p.per_l2 * (per_sin_φ3_minus_φ4 * t9);
        let dω3_2_dφ1 = -t10;
        let cos_φ2_minus_φ3 = cos_φ2 * c3 + sin_φ2 * s3;
        let t11 = p.l1 * (ω3_1 * cos_φ2_minus_φ3)
            + p.l2 * (ω4_2 * t4 * cos_φ3_minus_φ4);
        let t12 = p.per_l2 * (per_sin_φ3_minus_φ4 * t11);
        let dω4_2_dφ1 = -t12;
        let t13 = cos_φ2_minus_φ4 * dω4_2_dφ1;
        let t14 = p.two_C2 * (ω3_2 * dω3_2_dφ1) + p.two_C3 * (ω4_2 * dω4_2_dφ1)
            + p.C5 * t13;
        let ω4_1_sin_φ2_minus_φ4 = ω4_1 * sin_φ2_minus_φ4;
        // slope of the inertia
        let dM22_dφ1 = t14 + p.C5 * (ω4_1_sin_φ2_minus_φ4 * ω4_2);
        let t15 = p.C2 * (ω3_2 * dω3_1_dφ1) + p.C2 * (ω3_1 * dω3_2_dφ1)
            + p.C3 * (ω4_2 * dω4_1_dφ1);
        let t16 = cos_φ1_minus_φ3 * dω3_2_dφ1;
        let sin_φ1_minus_φ3_ω3_2 = sin_φ1_minus_φ3 * ω3_2;
        let t17 = sin_φ1_minus_φ3_ω3_2 * ω3_1_minus_one;
        let t18 = t15 + p.C3 * (ω4_1 * dω4_2_dφ1) + (p.C4 * t16 + p.C4 * t17) * 0.5;
        let t19 = dω4_1_dφ1 * cos_φ2_minus_φ4;
        let t20 = ω4_1_squared * sin_φ2_minus_φ4;
        // slope of the inertia
        let dM12_dφ1 = t18 + (p.C5 * t19 + p.C5 * t20) * 0.5;
        let ddet_M_dφ1 = M22 * dM11_dφ1 + M11 * dM22_dφ1 - M12 * dM12_dφ1 * 2.0;
        let t21 = per_det_M_squared * ddet_M_dφ1;
        let t22 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `left_coupler` from the assembled one
        let φ3_minus_φ3_0 = t22.unwrap_to(turn_left_coupler);
        let t23 = T::from_f64(2.0943951023931953) - φ1 + φ3_minus_φ3_0;
        let t24 = (p.c4_0 * s4 - p.s4_0 * c4).atan2(p.c4_0 * c4 + p.s4_0 * s4);
        // angle of `right_coupler` from the assembled one
        let φ4_minus_φ4_0 = t24.unwrap_to(turn_right_coupler);
        let t25 = T::from_f64(1.0471975511965976) - φ2 + φ4_minus_φ4_0;
        let t26 = p.k * (φ1 - 2.0943951023931953) + p.k * (ω3_1_minus_one * t23)
            + p.k * (ω4_1 * t25);
        let t27 = φ3_minus_φ3_0 - φ4_minus_φ4_0;
        // slope of the potential energy of springs
        let dP_s_dφ1 = t26 + p.k * (t4 * t27);
        let c_ω3_1_minus_one = p.c * ω3_1_minus_one;
        let c_ω4_1 = p.c * ω4_1;
        let ω4_2_minus_one = ω4_2 - 1.0;
        let t28 = p.c * t4;
        let ω3_2_minus_ω4_2 = ω3_2 - ω4_2;
        let ω3_1_cos_φ3_minus_φ4 = ω3_1 * cos_φ3_minus_φ4;
        let t29 = p.l1 * (ω4_2 * cos_φ1_minus_φ4)
            - p.l2 * (ω3_1_cos_φ3_minus_φ4 * ω3_2_minus_ω4_2);
        let dω3_1_dφ2 = p.per_l2 * (per_sin_φ3_minus_φ4 * t29);
        let ω4_1_cos_φ3_minus_φ4 = ω4_1 * cos_φ3_minus_φ4;
        let t30 = p.l1 * ω3_2_cos_φ1_minus_φ3
            - p.l2 * (ω4_1_cos_φ3_minus_φ4 * ω3_2_minus_ω4_2);
        let dω4_1_dφ2 = p.per_l2 * (per_sin_φ3_minus_φ4 * t30);
        let t31 = dω3_1_dφ2 * cos_φ1_minus_φ3;
        let t32 = p.two_C2 * (ω3_1 * dω3_1_dφ2) + p.two_C3 * (ω4_1 * dω4_1_dφ2)
            + p.C4 * t31;
        // slope of the inertia
        let dM11_dφ2 = t32 + p.C4 * (sin_φ1_minus_φ3_ω3_1 * ω3_2);
        let ω3_2_cos_φ3_minus_φ4 = ω3_2 * cos_φ3_minus_φ4;
        let t33 = p.l1 * (cos_φ2_minus_φ4 * ω4_2_minus_one)
            + p.l2 * (ω3_2_cos_φ3_minus_φ4 * ω3_2_minus_ω4_2);
        let t34 = p.per_l2 * (per_sin_φ3_minus_φ4 * t33);
        let dω3_2_dφ2 = -t34;
        let t35 = p.C2 * (ω3_2 * dω3_1_dφ2) + p.C2 * (ω3_1 * dω3_2_dφ2)
            + p.C3 * (ω4_2 * dω4_1_dφ2);
        let ω3_2_minus_one = ω3_2 - 1.0;
        let ω4_2_cos_φ3_minus_φ4 = ω4_2 * cos_φ3_minus_φ4;
        let t36 = p.l1 * (cos_φ2_minus_φ3 * ω3_2_minus_one)
            + p.l2 * (ω4_2_cos_φ3_minus_φ4 * ω3_2_minus_ω4_2);
        let t37 = p.per_l2 * (per_sin_φ3_minus_φ4 * t36);
        let dω4_2_dφ2 = -t37;
        let t38 = cos_φ1_minus_φ3 * dω3_2_dφ2;
        let t39 = sin_φ1_minus_φ3 * ω3_2_squared;
        let t40 = t35 + p.C3 * (ω4_1 * dω4_2_dφ2) + (p.C4 * t38 + p.C4 * t39) * 0.5;
        let t41 = dω4_1_dφ2 * cos_φ2_minus_φ4;
        let t42 = ω4_1_sin_φ2_minus_φ4 * ω4_2_minus_one;
        // slope of the inertia
        let dM12_dφ2 = t40 + (p.C5 * t41 + p.C5 * t42) * 0.5;
        let t43 = dM22_dφ1 * 0.5 - dM12_dφ2;
        let t44 = p.k * (φ2 - 1.0471975511965976) + p.k * (ω3_2 * t23)
            + p.k * (ω4_2_minus_one * t25);
        // slope of the potential energy of springs
        let dP_s_dφ2 = t44 + p.k * (ω3_2_minus_ω4_2 * t27);
        let c_ω3_2 = p.c * ω3_2;
        let c_ω4_2_minus_one = p.c * ω4_2_minus_one;
        let c_ω3_2_minus_ω4_2 = p.c * ω3_2_minus_ω4_2;
        let t45 = dM12_dφ1 - dM11_dφ2 * 0.5;
        let t46 = cos_φ2_minus_φ4 * dω4_2_dφ2;
        let t47 = p.two_C2 * (ω3_2 * dω3_2_dφ2) + p.two_C3 * (ω4_2 * dω4_2_dφ2)
            + p.C5 * t46;
        let sin_φ2_minus_φ4_ω4_2 = sin_φ2_minus_φ4 * ω4_2;
        // slope of the inertia
        let dM22_dφ2 = t47 + p.C5 * (sin_φ2_minus_φ4_ω4_2 * ω4_2_minus_one);
        let per_det_M = det_M.recip();
        let ω3_1_minus_one_squared = ω3_1_minus_one * ω3_1_minus_one;
        let t48 = p.k + p.k * (dω3_1_dφ1 * t23) + p.k * ω3_1_minus_one_squared
            + p.k * (dω4_1_dφ1 * t25);
        let t49 = dω3_1_dφ1 - dω4_1_dφ1;
        let t50 = t4 * t4;
        let ddP_s_dφ1_dφ1 = t48 + p.k * ω4_1_squared + p.k * (t27 * t49) + p.k * t50;
        let t51 = t12 - t10;
        let t52 = p.C4 * (sin_φ1_minus_φ3_ω3_2 * dω3_1_dφ1);
        let C2_dω3_1_dφ1_dω3_1_dφ2 = p.C2 * (dω3_1_dφ1 * dω3_1_dφ2);
        let t53 = p.l1 * (sin_φ1_minus_φ4 * ω4_2 * ω4_1_minus_one);
        let t54 = p.l1 * (cos_φ1_minus_φ4 * dω4_2_dφ1) + t53
            - p.l2 * (cos_φ3_minus_φ4 * dω3_1_dφ1 * ω3_2_minus_ω4_2);
        let sin_φ3_minus_φ4_ω3_1 = sin_φ3_minus_φ4 * ω3_1;
        let t55 = p.l2 * (sin_φ3_minus_φ4_ω3_1 * t4 * ω3_2_minus_ω4_2);
        let t56 = per_sin_φ3_minus_φ4
            * (t54 - p.l2 * (ω3_1_cos_φ3_minus_φ4 * t51) + t55);
        let t57 = (sin_φ3_minus_φ4 * sin_φ3_minus_φ4).recip();
        let t58 = t57 * t4 * cos_φ3_minus_φ4;
        let ddω3_1_dφ2_dφ1 = p.per_l2 * t56 - p.per_l2 * (t58 * t29);
        let t59 = t52
            + (C2_dω3_1_dφ1_dω3_1_dφ2 + p.C2 * (ω3_1 * ddω3_1_dφ2_dφ1)) * 2.0;
        let C3_dω4_1_dφ1_dω4_1_dφ2 = p.C3 * (dω4_1_dφ1 * dω4_1_dφ2);
        let t60 = p.l1 * t17;
        let t61 = cos_φ3_minus_φ4 * ω3_2_minus_ω4_2;
        let t62 = p.l1 * t16 + t60 - p.l2 * (t61 * dω4_1_dφ1)
            - p.l2 * (ω4_1_cos_φ3_minus_φ4 * t51);
        let sin_φ3_minus_φ4_ω4_1 = sin_φ3_minus_φ4 * ω4_1;
        let t63 = p.l2 * (sin_φ3_minus_φ4_ω4_1 * t4 * ω3_2_minus_ω4_2);
        let ddω4_1_dφ2_dφ1 = p.per_l2 * (per_sin_φ3_minus_φ4 * (t62 + t63))
            - p.per_l2 * (t58 * t30);
        let t64 = t59
            + (C3_dω4_1_dφ1_dω4_1_dφ2 + p.C3 * (ω4_1 * ddω4_1_dφ2_dφ1)) * 2.0;
        let t65 = p.C4 * (sin_φ1_minus_φ3 * dω3_1_dφ2 * ω3_1_minus_one);
        let t66 = t64 + p.C4 * (cos_φ1_minus_φ3 * ddω3_1_dφ2_dφ1) + t65
            + p.C4 * (sin_φ1_minus_φ3_ω3_1 * dω3_2_dφ1);
        let t67 = p.C4 * (ω3_1_ω3_2 * cos_φ1_minus_φ3 * ω3_1_minus_one);
        let ddM11_dφ2_dφ1 = t66 - t67;
        let t68 = p.l1 * (sin_φ1_minus_φ4 * (ω4_1_minus_one * ω4_1_minus_one))
            + p.l1 * (cos_φ1_minus_φ4 * dω4_1_dφ1);
        let t69 = t4 * cos_φ3_minus_φ4;
        let t70 = t68 - p.l2 * (t69 * dω3_1_dφ1)
            - p.l2 * (ω3_1_cos_φ3_minus_φ4 * t49);
        let t71 = p.per_l2
            * (per_sin_φ3_minus_φ4 * (t70 + p.l2 * (sin_φ3_minus_φ4_ω3_1 * t50)));
        let ddω3_1_dφ1_dφ1 = t71 - p.per_l2 * (t58 * t5);
        let t72 = (p.C2 * (dω3_1_dφ1 * dω3_1_dφ1)
            + p.C2 * (ω3_1 * ddω3_1_dφ1_dφ1)) * 2.0;
        let t73 = p.l1 * (sin_φ1_minus_φ3 * ω3_1_minus_one_squared) + p.l1 * t7
            - p.l2 * (t69 * dω4_1_dφ1);
        let t74 = t73 - p.l2 * (ω4_1_cos_φ3_minus_φ4 * t49)
            + p.l2 * (sin_φ3_minus_φ4_ω4_1 * t50);
        let ddω4_1_dφ1_dφ1 = p.per_l2 * (per_sin_φ3_minus_φ4 * t74)
            - p.per_l2 * (t58 * t6);
        let t75 = (p.C3 * (dω4_1_dφ1 * dω4_1_dφ1)
            + p.C3 * (ω4_1 * ddω4_1_dφ1_dφ1)) * 2.0;
        let t76 = t72 + t75 + p.C4 * (cos_φ1_minus_φ3 * ddω3_1_dφ1_dφ1)
            + p.two_C4 * (sin_φ1_minus_φ3 * dω3_1_dφ1 * ω3_1_minus_one);
        let ddM11_dφ1_dφ1 = t76 + p.C4 * (sin_φ1_minus_φ3_ω3_1 * dω3_1_dφ1)
            - p.C4 * (ω3_1_cos_φ1_minus_φ3 * ω3_1_minus_one_squared);
        let t77 = p.l1 * t19 + p.l1 * t20 + p.l2 * (t69 * dω3_2_dφ1)
            + p.l2 * (ω3_2_cos_φ3_minus_φ4 * t49);
        let sin_φ3_minus_φ4_ω3_2 = sin_φ3_minus_φ4 * ω3_2;
        let t78 = p.per_l2
            * (per_sin_φ3_minus_φ4 * (t77 - p.l2 * (sin_φ3_minus_φ4_ω3_2 * t50)));
        let ddω3_2_dφ1_dφ1 = p.per_l2 * (t58 * t9) - t78;
        let t79 = (p.C2 * (dω3_2_dφ1 * dω3_2_dφ1)
            + p.C2 * (ω3_2 * ddω3_2_dφ1_dφ1)) * 2.0;
        let t80 = p.l1 * (dω3_1_dφ1 * cos_φ2_minus_φ3)
            + p.l1 * (ω3_1_squared * sin_φ2_minus_φ3);
        let t81 = t80 + p.l2 * (t69 * dω4_2_dφ1)
            + p.l2 * (ω4_2_cos_φ3_minus_φ4 * t49);
        let sin_φ3_minus_φ4_ω4_2 = sin_φ3_minus_φ4 * ω4_2;
        let t82 = p.per_l2
            * (per_sin_φ3_minus_φ4 * (t81 - p.l2 * (sin_φ3_minus_φ4_ω4_2 * t50)));
        let ddω4_2_dφ1_dφ1 = p.per_l2 * (t58 * t11) - t82;
        let t83 = (p.C3 * (dω4_2_dφ1 * dω4_2_dφ1)
            + p.C3 * (ω4_2 * ddω4_2_dφ1_dφ1)) * 2.0;
        let t84 = ω4_1_sin_φ2_minus_φ4 * dω4_2_dφ1;
        let t85 = t79 + t83 + p.two_C5 * t84
            + p.C5 * (cos_φ2_minus_φ4 * ddω4_2_dφ1_dφ1);
        let ddM22_dφ1_dφ1 = t85 + p.C5 * (sin_φ2_minus_φ4_ω4_2 * dω4_1_dφ1)
            - p.C5 * (ω4_1_squared * ω4_2 * cos_φ2_minus_φ4);
        let C2_dω3_1_dφ2_dω3_2_dφ1 = p.C2 * (dω3_1_dφ2 * dω3_2_dφ1);
        let C2_dω3_1_dφ1_dω3_2_dφ2 = p.C2 * (dω3_1_dφ1 * dω3_2_dφ2);
        let t86 = C2_dω3_1_dφ2_dω3_2_dφ1 + p.C2 * (ω3_2 * ddω3_1_dφ2_dφ1)
            + C2_dω3_1_dφ1_dω3_2_dφ2;
        let t87 = p.l1 * t42;
        let t88 = t87 + p.l1 * t13 + p.l2 * (t61 * dω3_2_dφ1)
            + p.l2 * (ω3_2_cos_φ3_minus_φ4 * t51);
        let t89 = p.l2 * (sin_φ3_minus_φ4_ω3_2 * t4 * ω3_2_minus_ω4_2);
        let ddω3_2_dφ2_dφ1 = p.per_l2 * (t58 * t33)
            - p.per_l2 * (per_sin_φ3_minus_φ4 * (t88 - t89));
        let C3_dω4_1_dφ2_dω4_2_dφ1 = p.C3 * (dω4_1_dφ2 * dω4_2_dφ1);
        let t90 = t86 + p.C2 * (ω3_1 * ddω3_2_dφ2_dφ1) + C3_dω4_1_dφ2_dω4_2_dφ1
            + p.C3 * (ω4_2 * ddω4_1_dφ2_dφ1);
        let C3_dω4_1_dφ1_dω4_2_dφ2 = p.C3 * (dω4_1_dφ1 * dω4_2_dφ2);
        let t91 = p.l1 * (ω3_1 * sin_φ2_minus_φ3 * ω3_2_minus_one);
        let t92 = t91 + p.l1 * (dω3_2_dφ1 * cos_φ2_minus_φ3)
            + p.l2 * (t61 * dω4_2_dφ1);
        let t93 = p.l2 * (sin_φ3_minus_φ4_ω4_2 * t4 * ω3_2_minus_ω4_2);
        let t94 = per_sin_φ3_minus_φ4
            * (t92 + p.l2 * (ω4_2_cos_φ3_minus_φ4 * t51) - t93);
        let ddω4_2_dφ2_dφ1 = p.per_l2 * (t58 * t36) - p.per_l2 * t94;
        let t95 = sin_φ1_minus_φ3 * ω3_1_minus_one;
        let t96 = p.C4 * (t95 * dω3_2_dφ2);
        let t97 = p.C4 * (ω3_2_squared * cos_φ1_minus_φ3 * ω3_1_minus_one);
        let t98 = sin_φ1_minus_φ3_ω3_2 * dω3_2_dφ1;
        let t99 = t96 + p.C4 * (cos_φ1_minus_φ3 * ddω3_2_dφ2_dφ1) - t97
            + p.two_C4 * t98;
        let t100 = t90 + C3_dω4_1_dφ1_dω4_2_dφ2 + p.C3 * (ω4_1 * ddω4_2_dφ2_dφ1)
            + t99 * 0.5;
        let t101 = ω4_1_sin_φ2_minus_φ4 * dω4_1_dφ2;
        let t102 = p.C5 * t84 + p.C5 * (cos_φ2_minus_φ4 * ddω4_1_dφ2_dφ1)
            + p.C5 * t101;
        let t103 = p.C5 * (sin_φ2_minus_φ4 * dω4_1_dφ1 * ω4_2_minus_one);
        let t104 = p.C5 * (ω4_1_squared * cos_φ2_minus_φ4 * ω4_2_minus_one);
        let ddM12_dφ2_dφ1 = t100 + (t102 + t103 - t104) * 0.5;
        let ω3_2_ω3_1_minus_one = ω3_2 * ω3_1_minus_one;
        let k_ω3_2_ω3_1_minus_one = p.k * ω3_2_ω3_1_minus_one;
        let t105 = p.k * (dω3_2_dφ1 * t23) + k_ω3_2_ω3_1_minus_one
            + p.k * (dω4_2_dφ1 * t25);
        let ω4_1_ω4_2_minus_one = ω4_1 * ω4_2_minus_one;
        let k_ω4_1_ω4_2_minus_one = p.k * ω4_1_ω4_2_minus_one;
        let t106 = t4 * ω3_2_minus_ω4_2;
        let t107 = p.k * t106;
        let ddP_s_dφ2_dφ1 = t105 + k_ω4_1_ω4_2_minus_one + p.k * (t27 * t51) + t107;
        let t108 = p.two_C2 * (dω3_1_dφ1 * dω3_2_dφ1)
            + p.C2 * (ω3_2 * ddω3_1_dφ1_dφ1);
        let t109 = t108 + p.C2 * (ω3_1 * ddω3_2_dφ1_dφ1)
            + p.two_C3 * (dω4_1_dφ1 * dω4_2_dφ1);
        let t110 = t109 + p.C3 * (ω4_2 * ddω4_1_dφ1_dφ1)
            + p.C3 * (ω4_1 * ddω4_2_dφ1_dφ1);
        let t111 = p.two_C4 * (t95 * dω3_2_dφ1)
            + p.C4 * (cos_φ1_minus_φ3 * ddω3_2_dφ1_dφ1);
        let t112 = t111 + t52
            - p.C4 * (ω3_2_cos_φ1_minus_φ3 * ω3_1_minus_one_squared);
        let t113 = p.C5 * (cos_φ2_minus_φ4 * ddω4_1_dφ1_dφ1)
            + p._3_C5 * (ω4_1_sin_φ2_minus_φ4 * dω4_1_dφ1);
        let ddM12_dφ1_dφ1 = t110 + t112 * 0.5
            + (t113 - p.C5 * (ω4_1 * ω4_1_squared * cos_φ2_minus_φ4)) * 0.5;
        let C2_dω3_2_dφ1_dω3_2_dφ2 = p.C2 * (dω3_2_dφ1 * dω3_2_dφ2);
        let C3_dω4_2_dφ1_dω4_2_dφ2 = p.C3 * (dω4_2_dφ1 * dω4_2_dφ2);
        let t114 = (C2_dω3_2_dφ1_dω3_2_dφ2 + p.C2 * (ω3_2 * ddω3_2_dφ2_dφ1))
            * 2.0
            + (C3_dω4_2_dφ1_dω4_2_dφ2 + p.C3 * (ω4_2 * ddω4_2_dφ2_dφ1)) * 2.0;
        let t115 = p.C5 * (ω4_1_sin_φ2_minus_φ4 * dω4_2_dφ2);
        let t116 = sin_φ2_minus_φ4 * ω4_2_minus_one;
        let t117 = p.C5 * (t116 * dω4_2_dφ1);
        let t118 = t114 + t115 + p.C5 * (cos_φ2_minus_φ4 * ddω4_2_dφ2_dφ1) + t117
            + p.C5 * (sin_φ2_minus_φ4_ω4_2 * dω4_2_dφ1);
        let t119 = p.C5 * (ω4_1_ω4_2 * cos_φ2_minus_φ4 * ω4_2_minus_one);
        let ddM22_dφ2_dφ1 = t118 - t119;
        let t120 = p.c + p.c * ω3_1_minus_one_squared + p.c * ω4_1_squared + p.c * t50;
        let dτ1_ddφ1 = -t120;
        let t121 = p.c * ω3_2_ω3_1_minus_one + p.c * ω4_1_ω4_2_minus_one
            + p.c * t106;
        let dτ2_ddφ1 = -t121;
        let ddet_M_dφ2 = M22 * dM11_dφ2 + M11 * dM22_dφ2 - M12 * dM12_dφ2 * 2.0;
        let t122 = per_det_M_squared * ddet_M_dφ2;
        let t123 = k_ω3_2_ω3_1_minus_one + k_ω4_1_ω4_2_minus_one + t107
            + p.k * (dω3_1_dφ2 * t23);
        let t124 = dω3_1_dφ2 - dω4_1_dφ2;
        let ddP_s_dφ1_dφ2 = t123 + p.k * (dω4_1_dφ2 * t25) + p.k * (t27 * t124);
        let t125 = t37 - t34;
        let t126 = sin_φ1_minus_φ3_ω3_2 * dω3_1_dφ2;
        let t127 = p.l1 * (cos_φ1_minus_φ4 * dω4_2_dφ2)
            + p.l1 * (sin_φ1_minus_φ4 * ω4_2_squared);
        let t128 = t127 - p.l2 * (t61 * dω3_1_dφ2)
            - p.l2 * (ω3_1_cos_φ3_minus_φ4 * t125);
        let ω3_2_minus_ω4_2_squared = ω3_2_minus_ω4_2 * ω3_2_minus_ω4_2;
        let t129 = per_sin_φ3_minus_φ4
            * (t128 + p.l2 * (sin_φ3_minus_φ4_ω3_1 * ω3_2_minus_ω4_2_squared));
        let t130 = t57 * cos_φ3_minus_φ4;
        let t131 = t130 * ω3_2_minus_ω4_2;
        let ddω3_1_dφ2_dφ2 = p.per_l2 * t129 - p.per_l2 * (t131 * t29);
        let t132 = (p.C2 * (dω3_1_dφ2 * dω3_1_dφ2)
            + p.C2 * (ω3_1 * ddω3_1_dφ2_dφ2)) * 2.0;
        let t133 = p.l1 * t38 + p.l1 * t39 - p.l2 * (t61 * dω4_1_dφ2)
            - p.l2 * (ω4_1_cos_φ3_minus_φ4 * t125);
        let t134 = per_sin_φ3_minus_φ4
            * (t133 + p.l2 * (sin_φ3_minus_φ4_ω4_1 * ω3_2_minus_ω4_2_squared));
        let ddω4_1_dφ2_dφ2 = p.per_l2 * t134 - p.per_l2 * (t131 * t30);
        let t135 = (p.C3 * (dω4_1_dφ2 * dω4_1_dφ2)
            + p.C3 * (ω4_1 * ddω4_1_dφ2_dφ2)) * 2.0;
        let t136 = p.two_C4 * t126 + t132 + t135
            + p.C4 * (cos_φ1_minus_φ3 * ddω3_1_dφ2_dφ2);
        let ddM11_dφ2_dφ2 = t136 + p.C4 * (sin_φ1_minus_φ3_ω3_1 * dω3_2_dφ2)
            - p.C4 * (ω3_1 * ω3_2_squared * cos_φ1_minus_φ3);
        let t137 = t53 + t55 + p.l1 * (cos_φ1_minus_φ4 * dω4_1_dφ2)
            - p.l2 * (t69 * dω3_1_dφ2);
        let t138 = per_sin_φ3_minus_φ4
            * (t137 - p.l2 * (ω3_1_cos_φ3_minus_φ4 * t124));
        let ddω3_1_dφ1_dφ2 = p.per_l2 * t138
            - p.per_l2 * (t130 * t5 * ω3_2_minus_ω4_2);
        let t139 = t52 + t65 - t67
            + (C2_dω3_1_dφ1_dω3_1_dφ2 + p.C2 * (ω3_1 * ddω3_1_dφ1_dφ2)) * 2.0;
        let t140 = t60 + t63 + p.l1 * t31 - p.l2 * (t69 * dω4_1_dφ2)
            - p.l2 * (ω4_1_cos_φ3_minus_φ4 * t124);
        let ddω4_1_dφ1_dφ2 = p.per_l2 * (per_sin_φ3_minus_φ4 * t140)
            - p.per_l2 * (t131 * t6);
        let t141 = t139
            + (C3_dω4_1_dφ1_dω4_1_dφ2 + p.C3 * (ω4_1 * ddω4_1_dφ1_dφ2)) * 2.0;
        let ddM11_dφ1_dφ2 = t141 + p.C4 * (cos_φ1_minus_φ3 * ddω3_1_dφ1_dφ2)
            + p.C4 * (sin_φ1_minus_φ3_ω3_1 * dω3_1_dφ2);
        let t142 = t87 - t89 + p.l1 * t41 + p.l2 * (t69 * dω3_2_dφ2)
            + p.l2 * (ω3_2_cos_φ3_minus_φ4 * t124);
        let ddω3_2_dφ1_dφ2 = p.per_l2 * (t131 * t9)
            - p.per_l2 * (per_sin_φ3_minus_φ4 * t142);
        let t143 = t115 + t117 - t119
            + (C2_dω3_2_dφ1_dω3_2_dφ2 + p.C2 * (ω3_2 * ddω3_2_dφ1_dφ2)) * 2.0;
        let t144 = t91 - t93 + p.l1 * (dω3_1_dφ2 * cos_φ2_minus_φ3)
            + p.l2 * (t69 * dω4_2_dφ2);
        let t145 = per_sin_φ3_minus_φ4
            * (t144 + p.l2 * (ω4_2_cos_φ3_minus_φ4 * t124));
        let ddω4_2_dφ1_dφ2 = p.per_l2 * (t131 * t11) - p.per_l2 * t145;
        let t146 = t143
            + (C3_dω4_2_dφ1_dω4_2_dφ2 + p.C3 * (ω4_2 * ddω4_2_dφ1_dφ2)) * 2.0;
        let ddM22_dφ1_dφ2 = t146 + p.C5 * (cos_φ2_minus_φ4 * ddω4_2_dφ1_dφ2)
            + p.C5 * (sin_φ2_minus_φ4_ω4_2 * dω4_1_dφ2);
        let t147 = p.two_C2 * (dω3_1_dφ2 * dω3_2_dφ2)
            + p.C2 * (ω3_2 * ddω3_1_dφ2_dφ2);
        let ω4_2_minus_one_squared = ω4_2_minus_one * ω4_2_minus_one;
        let t148 = p.l1 * (sin_φ2_minus_φ4 * ω4_2_minus_one_squared) + p.l1 * t46
            + p.l2 * (t61 * dω3_2_dφ2);
        let t149 = t148 + p.l2 * (ω3_2_cos_φ3_minus_φ4 * t125)
            - p.l2 * (sin_φ3_minus_φ4_ω3_2 * ω3_2_minus_ω4_2_squared);
        let ddω3_2_dφ2_dφ2 = p.per_l2 * (t131 * t33)
            - p.per_l2 * (per_sin_φ3_minus_φ4 * t149);
        let t150 = t147 + p.C2 * (ω3_1 * ddω3_2_dφ2_dφ2)
            + p.two_C3 * (dω4_1_dφ2 * dω4_2_dφ2);
        let t151 = p.l1 * (sin_φ2_minus_φ3 * (ω3_2_minus_one * ω3_2_minus_one))
            + p.l1 * (dω3_2_dφ2 * cos_φ2_minus_φ3);
        let t152 = t151 + p.l2 * (t61 * dω4_2_dφ2)
            + p.l2 * (ω4_2_cos_φ3_minus_φ4 * t125);
        let t153 = per_sin_φ3_minus_φ4
            * (t152 - p.l2 * (sin_φ3_minus_φ4_ω4_2 * ω3_2_minus_ω4_2_squared));
        let ddω4_2_dφ2_dφ2 = p.per_l2 * (t131 * t36) - p.per_l2 * t153;
        let t154 = t150 + p.C3 * (ω4_2 * ddω4_1_dφ2_dφ2)
            + p.C3 * (ω4_1 * ddω4_2_dφ2_dφ2);
        let t155 = p._3_C4 * (sin_φ1_minus_φ3_ω3_2 * dω3_2_dφ2)
            + p.C4 * (cos_φ1_minus_φ3 * ddω3_2_dφ2_dφ2);
        let t156 = t154
            + (t155 - p.C4 * (ω3_2 * ω3_2_squared * cos_φ1_minus_φ3)) * 0.5;
        let t157 = t115 + p.C5 * (cos_φ2_minus_φ4 * ddω4_1_dφ2_dφ2)
            + p.two_C5 * (sin_φ2_minus_φ4 * dω4_1_dφ2 * ω4_2_minus_one);
        let t158 = (t157 - p.C5 * (ω4_1_cos_φ2_minus_φ4 * ω4_2_minus_one_squared))
            * 0.5;
        let ddM12_dφ2_dφ2 = t156 + t158;
        let t159 = p.k + p.k * (dω3_2_dφ2 * t23) + p.k * ω3_2_squared
            + p.k * (dω4_2_dφ2 * t25);
        let ddP_s_dφ2_dφ2 = t159 + p.k * ω4_2_minus_one_squared + p.k * (t27 * t125)
            + p.k * ω3_2_minus_ω4_2_squared;
        let t160 = C2_dω3_1_dφ2_dω3_2_dφ1 + C2_dω3_1_dφ1_dω3_2_dφ2
            + C3_dω4_1_dφ2_dω4_2_dφ1;
        let t161 = t160 + C3_dω4_1_dφ1_dω4_2_dφ2 + p.C2 * (ω3_2 * ddω3_1_dφ1_dφ2)
            + p.C2 * (ω3_1 * ddω3_2_dφ1_dφ2);
        let t162 = t161 + p.C3 * (ω4_2 * ddω4_1_dφ1_dφ2)
            + p.C3 * (ω4_1 * ddω4_2_dφ1_dφ2);
        let t163 = t96 - t97 + p.C4 * t98
            + p.C4 * (cos_φ1_minus_φ3 * ddω3_2_dφ1_dφ2);
        let t164 = p.two_C5 * t101 + t103 - t104
            + p.C5 * (cos_φ2_minus_φ4 * ddω4_1_dφ1_dφ2);
        let ddM12_dφ1_dφ2 = t162 + (t163 + p.C4 * t126) * 0.5 + t164 * 0.5;
        let t165 = (p.C2 * (dω3_2_dφ2 * dω3_2_dφ2)
            + p.C2 * (ω3_2 * ddω3_2_dφ2_dφ2)) * 2.0;
        let t166 = (p.C3 * (dω4_2_dφ2 * dω4_2_dφ2)
            + p.C3 * (ω4_2 * ddω4_2_dφ2_dφ2)) * 2.0;
        let t167 = t165 + t166 + p.two_C5 * (t116 * dω4_2_dφ2)
            + p.C5 * (cos_φ2_minus_φ4 * ddω4_2_dφ2_dφ2);
        let ddM22_dφ2_dφ2 = t167 + p.C5 * (sin_φ2_minus_φ4_ω4_2 * dω4_2_dφ2)
            - p.C5 * (ω4_2_cos_φ2_minus_φ4 * ω4_2_minus_one_squared);
        let t168 = p.c + p.c * ω3_2_squared + p.c * ω4_2_minus_one_squared
            + p.c * ω3_2_minus_ω4_2_squared;
        let dτ2_ddφ2 = -t168;
        // ── state ──
        let t169 = p.constant1 * t;
        let (t170, t171) = t169.sin_cos();
        let t172 = ω3_1_minus_one * dφ1 + ω3_2 * dφ2;
        let t173 = ω4_1 * dφ1 + ω4_2_minus_one * dφ2;
        let t174 = p.left_torque * t170 - p.c * dφ1 - c_ω3_1_minus_one * t172
            - c_ω4_1 * t173;
        let t175 = t4 * dφ1 + ω3_2_minus_ω4_2 * dφ2;
        // generalized torque of all other forces
        let τ1 = t174 - t28 * t175;
        let dφ1_dφ2 = dφ1 * dφ2;
        let dφ1_squared = dφ1 * dφ1;
        let dφ2_squared = dφ2 * dφ2;
        // centrifugal and Coriolis terms
        let h1 = dM11_dφ2 * dφ1_dφ2 + dM11_dφ1 * 0.5 * dφ1_squared
            - t43 * dφ2_squared;
        let t176 = dP_s_dφ1 - τ1 + h1;
        let t177 = p.right_torque * t171 - p.c * dφ2 - c_ω3_2 * t172
            - c_ω4_2_minus_one * t173;
        // generalized torque of all other forces
        let τ2 = t177 - c_ω3_2_minus_ω4_2 * t175;
        // centrifugal and Coriolis terms
        let h2 = t45 * dφ1_squared + dM22_dφ1 * dφ1_dφ2
            + dM22_dφ2 * 0.5 * dφ2_squared;
        let t178 = dP_s_dφ2 - τ2 + h2;
        let t179 = M22 * t176 - M12 * t178;
        let t180 = dω3_1_dφ1 * dφ1 + dω3_2_dφ1 * dφ2;
        let t181 = p.c * dω3_1_dφ1 * t172 + c_ω3_1_minus_one * t180
            + p.c * dω4_1_dφ1 * t173;
        let t182 = dω4_1_dφ1 * dφ1 + dω4_2_dφ1 * dφ2;
        let t183 = t49 * dφ1 + t51 * dφ2;
        let t184 = ddP_s_dφ1_dφ1
            + (t181 + c_ω4_1 * t182 + p.c * t49 * t175 + t28 * t183);
        let dh1_dφ1 = ddM11_dφ2_dφ1 * dφ1_dφ2 + ddM11_dφ1_dφ1 * 0.5 * dφ1_squared
            - (ddM22_dφ1_dφ1 * 0.5 - ddM12_dφ2_dφ1) * dφ2_squared;
        let t185 = t184 + dh1_dφ1;
        let t186 = p.c * dω3_2_dφ1 * t172 + c_ω3_2 * t180 + p.c * dω4_2_dφ1 * t173;
        let t187 = t186 + c_ω4_2_minus_one * t182 + p.c * t51 * t175
            + c_ω3_2_minus_ω4_2 * t183;
        let t188 = (ddM12_dφ1_dφ1 - ddM11_dφ2_dφ1 * 0.5) * dφ1_squared
            + ddM22_dφ1_dφ1 * dφ1_dφ2;
        let dh2_dφ1 = t188 + ddM22_dφ2_dφ1 * 0.5 * dφ2_squared;
        let t189 = ddP_s_dφ2_dφ1 + t187 + dh2_dφ1;
        let t190 = per_det_M
            * (dM22_dφ1 * t176 + M22 * t185 - dM12_dφ1 * t178 - M12 * t189);
        let dddφ1_dφ1 = t21 * t179 - t190;
        let dh1_ddφ1 = dM11_dφ2 * dφ2 + dM11_dφ1 * dφ1;
        let dτ1_ddφ1_minus_dh1_ddφ1 = dτ1_ddφ1 - dh1_ddφ1;
        let dh2_ddφ1 = t45 * 2.0 * dφ1 + dM22_dφ1 * dφ2;
        let dτ2_ddφ1_minus_dh2_ddφ1 = dτ2_ddφ1 - dh2_ddφ1;
        let dddφ1_ddφ1 = per_det_M
            * (M22 * dτ1_ddφ1_minus_dh1_ddφ1 - M12 * dτ2_ddφ1_minus_dh2_ddφ1);
        let t191 = dω3_1_dφ2 * dφ1 + dω3_2_dφ2 * dφ2;
        let t192 = p.c * dω3_1_dφ2 * t172 + c_ω3_1_minus_one * t191
            + p.c * dω4_1_dφ2 * t173;
        let t193 = dω4_1_dφ2 * dφ1 + dω4_2_dφ2 * dφ2;
        let t194 = t124 * dφ1 + t125 * dφ2;
        let t195 = ddP_s_dφ1_dφ2
            + (t192 + c_ω4_1 * t193 + p.c * t124 * t175 + t28 * t194);
        let dh1_dφ2 = ddM11_dφ2_dφ2 * dφ1_dφ2 + ddM11_dφ1_dφ2 * 0.5 * dφ1_squared
            - (ddM22_dφ1_dφ2 * 0.5 - ddM12_dφ2_dφ2) * dφ2_squared;
        let t196 = t195 + dh1_dφ2;
        let t197 = p.c * dω3_2_dφ2 * t172 + c_ω3_2 * t191 + p.c * dω4_2_dφ2 * t173;
        let t198 = t197 + c_ω4_2_minus_one * t193 + p.c * t125 * t175
            + c_ω3_2_minus_ω4_2 * t194;
        let t199 = (ddM12_dφ1_dφ2 - ddM11_dφ2_dφ2 * 0.5) * dφ1_squared
            + ddM22_dφ1_dφ2 * dφ1_dφ2;
        let dh2_dφ2 = t199 + ddM22_dφ2_dφ2 * 0.5 * dφ2_squared;
        let t200 = ddP_s_dφ2_dφ2 + t198 + dh2_dφ2;
        let t201 = per_det_M
            * (dM22_dφ2 * t176 + M22 * t196 - dM12_dφ2 * t178 - M12 * t200);
        let dddφ1_dφ2 = t122 * t179 - t201;
        let dh1_ddφ2 = dM11_dφ2 * dφ1 - t43 * 2.0 * dφ2;
        let dτ2_ddφ1_minus_dh1_ddφ2 = dτ2_ddφ1 - dh1_ddφ2;
        let dh2_ddφ2 = dM22_dφ1 * dφ1 + dM22_dφ2 * dφ2;
        let dτ2_ddφ2_minus_dh2_ddφ2 = dτ2_ddφ2 - dh2_ddφ2;
        let dddφ1_ddφ2 = per_det_M
            * (M22 * dτ2_ddφ1_minus_dh1_ddφ2 - M12 * dτ2_ddφ2_minus_dh2_ddφ2);
        let t202 = M11 * t178 - M12 * t176;
        let t203 = per_det_M
            * (dM11_dφ1 * t178 + M11 * t189 - dM12_dφ1 * t176 - M12 * t185);
        let dddφ2_dφ1 = t21 * t202 - t203;
        let dddφ2_ddφ1 = per_det_M
            * (M11 * dτ2_ddφ1_minus_dh2_ddφ1 - M12 * dτ1_ddφ1_minus_dh1_ddφ1);
        let t204 = per_det_M
            * (dM11_dφ2 * t178 + M11 * t200 - dM12_dφ2 * t176 - M12 * t196);
        let dddφ2_dφ2 = t122 * t202 - t204;
        let dddφ2_ddφ2 = per_det_M
            * (M11 * dτ2_ddφ2_minus_dh2_ddφ2 - M12 * dτ2_ddφ1_minus_dh1_ddφ2);
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
        let η = p.half_ε * (D.recip() * (D * (p._4_l2_squared - D)).sqrt());
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
        let η = p.half_ε * (D.recip() * (D * (p._4_l2_squared - D)).sqrt());
        let X_η = X * η;
        let s3 = p.per_l2 * (half_Y + X_η);
        let half_X = X * 0.5;
        let Y_η = Y * η;
        let c4 = -(p.per_l2 * (half_X + Y_η));
        let c3 = p.per_l2 * (half_X - Y_η);
        let s4 = -(p.per_l2 * (half_Y - X_η));
        let sin_φ3_minus_φ4 = s3 * c4 - c3 * s4;
        let per_sin_φ3_minus_φ4 = sin_φ3_minus_φ4.recip();
        let sin_φ1_minus_φ4 = sin_φ1 * c4 - cos_φ1 * s4;
        let t1 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ1_minus_φ4);
        // rate of the angle of `left_coupler` per unit rate of `left_crank`
        let ω3_1 = -t1;
        let sin_φ1_minus_φ3 = sin_φ1 * c3 - cos_φ1 * s3;
        let t2 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ1_minus_φ3);
        // rate of the angle of `right_coupler` per unit rate of `left_crank`
        let ω4_1 = -t2;
        let cos_φ1_minus_φ3 = cos_φ1 * c3 + sin_φ1 * s3;
        // inertia
        let M11 = p.C0 + p.C2 * (ω3_1 * ω3_1) + p.C3 * (ω4_1 * ω4_1)
            + p.C4 * (ω3_1 * cos_φ1_minus_φ3);
        let sin_φ2_minus_φ4 = sin_φ2 * c4 - cos_φ2 * s4;
        // rate of the angle of `left_coupler` per unit rate of `right_crank`
        let ω3_2 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ2_minus_φ4);
        let sin_φ2_minus_φ3 = sin_φ2 * c3 - cos_φ2 * s3;
        // rate of the angle of `right_coupler` per unit rate of `right_crank`
        let ω4_2 = p.l1_per_l2 * (per_sin_φ3_minus_φ4 * sin_φ2_minus_φ3);
        let t3 = p.C2 * (ω3_1 * ω3_2) + p.C3 * (ω4_1 * ω4_2)
            + p.half_C4 * (ω3_2 * cos_φ1_minus_φ3);
        let cos_φ2_minus_φ4 = cos_φ2 * c4 + sin_φ2 * s4;
        // inertia
        let M12 = t3 + p.half_C5 * (ω4_1 * cos_φ2_minus_φ4);
        // inertia
        let M22 = p.C1 + p.C2 * (ω3_2 * ω3_2) + p.C3 * (ω4_2 * ω4_2)
            + p.C5 * (ω4_2 * cos_φ2_minus_φ4);
        let t4 = φ1 - 2.0943951023931953;
        let t5 = φ2 - 1.0471975511965976;
        let t6 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `left_coupler` from the assembled one
        let φ3_minus_φ3_0 = t6.unwrap_to(turn_left_coupler);
        let t7 = T::from_f64(2.0943951023931953) - φ1 + φ3_minus_φ3_0;
        let t8 = p.half_k * (t4 * t4) + p.half_k * (t5 * t5) + p.half_k * (t7 * t7);
        let t9 = (p.c4_0 * s4 - p.s4_0 * c4).atan2(p.c4_0 * c4 + p.s4_0 * s4);
        // angle of `right_coupler` from the assembled one
        let φ4_minus_φ4_0 = t9.unwrap_to(turn_right_coupler);
        let t10 = T::from_f64(1.0471975511965976) - φ2 + φ4_minus_φ4_0;
        let t11 = φ4_minus_φ4_0 - φ3_minus_φ3_0;
        // ── state ──
        let dφ1_squared = dφ1 * dφ1;
        let dφ2_squared = dφ2 * dφ2;
        let t12 = M11 * 0.5 * dφ1_squared + M12 * (dφ1 * dφ2)
            + M22 * 0.5 * dφ2_squared;
        let t13 = (ω3_1 - 1.0) * dφ1 + ω3_2 * dφ2;
        let t14 = ω4_1 * dφ1 + (ω4_2 - 1.0) * dφ2;
        let t15 = p.c * dφ1_squared + p.c * dφ2_squared + p.c * (t13 * t13)
            + p.c * (t14 * t14);
        let t16 = (t2 - t1) * dφ1 + (ω3_2 - ω4_2) * dφ2;
        let t17 = p.constant1 * t;
        let (t18, t19) = t17.sin_cos();
        result[0] = t12;
        result[1] = t8 + p.half_k * (t10 * t10) + p.half_k * (t11 * t11);
        result[2] = t15 + p.c * (t16 * t16);
        result[3] = p.left_torque * (t18 * dφ1) + p.right_torque * (t19 * dφ2);
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
        let η = p.half_ε * (D.recip() * (D * (p._4_l2_squared - D)).sqrt());
        let X_η = X * η;
        let s3 = p.per_l2 * (half_Y + X_η);
        let half_X = X * 0.5;
        let Y_η = Y * η;
        let c3 = p.per_l2 * (half_X - Y_η);
        let t1 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `left_coupler` from the assembled one
        let φ3_minus_φ3_0 = t1.unwrap_to(turn_left_coupler);
        let s4 = -(p.per_l2 * (half_Y - X_η));
        let c4 = -(p.per_l2 * (half_X + Y_η));
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
        fn take_plain_steps(&self, steps: &mut PlainSteps<'_>) {
            steps.on_lanes(self);
        }
    }
    impl LaneSystem for Prepared<f64> {
        type InLanes<L: Lanes> = Prepared<L>;
        type States<L: Lanes> = [L; 4];
        type Discretes<L: Lanes> = [L; 2];
        type Loops<L: Lanes> = [L; 1];
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
            related: Cow::Borrowed(&[]),
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
            related: Cow::Borrowed(&[]),
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
            related: Cow::Borrowed(&[]),
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
            related: Cow::Borrowed(&[]),
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
            related: Cow::Borrowed(&[]),
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
            related: Cow::Borrowed(&[]),
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
            related: Cow::Borrowed(&[]),
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
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Metre, Unit::Metre, Unit::Degree]),
        },
        Failure {
            message: Cow::Borrowed(
                "the loop left_crank–left_coupler–right_coupler–right_crank stands at a dead point: at `left_crank` angle {3} the joints of `left_coupler` and `right_coupler` lie in one line",
            ),
            hint: Some(
                Cow::Borrowed(
                    "assemble it in another configuration: change an angle or a length; or ask for the coordinate `left_coupler.angle`, if that leads it through",
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
            related: Cow::Borrowed(&[]),
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
            related: Cow::Borrowed(&[]),
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
            related: Cow::Borrowed(&[]),
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
  η  = ε sqrt(D (4 l2² - D)) / (2 D)
  c3 = (½ X - Y η) / l2
  s3 = (½ Y + X η) / l2
  c4 = -(½ X + Y η) / l2
  s4 = (X η - ½ Y) / l2

  φ3 = atan2(s3, c3), φ4 = atan2(s4, c4), continuous over many turns; ⁰: as assembled
  ω3_1 = ∂φ3/∂φ1, ω4_1 = ∂φ4/∂φ1, ω3_2 = ∂φ3/∂φ2, ω4_2 = ∂φ4/∂φ2

  ω3_1      = l1 sin(φ4 - φ1) / (l2 sin(φ3 - φ4))
  ω4_1      = l1 sin(φ3 - φ1) / (l2 sin(φ3 - φ4))
  ω3_2      = l1 sin(φ2 - φ4) / (l2 sin(φ3 - φ4))
  ω4_2      = l1 sin(φ2 - φ3) / (l2 sin(φ3 - φ4))
  ∂ω3_1/∂φ1 = (l1 (ω4_1 - 1) cos(φ1 - φ4) + l2 ω3_1 (ω4_1 - ω3_1) cos(φ3 - φ4))
                / (l2 sin(φ3 - φ4))
  ∂ω3_1/∂φ2 = (l1 ω4_2 cos(φ1 - φ4) + l2 ω3_1 (ω4_2 - ω3_2) cos(φ3 - φ4)) / (l2 sin(φ3 - φ4))
  ∂ω4_1/∂φ1 = (l1 (ω3_1 - 1) cos(φ1 - φ3) + l2 ω4_1 (ω4_1 - ω3_1) cos(φ3 - φ4))
                / (l2 sin(φ3 - φ4))
  ∂ω4_1/∂φ2 = (l1 ω3_2 cos(φ1 - φ3) + l2 ω4_1 (ω4_2 - ω3_2) cos(φ3 - φ4)) / (l2 sin(φ3 - φ4))
  ∂ω3_2/∂φ1 = (l1 ω4_1 cos(φ2 - φ4) + l2 ω3_2 (ω3_1 - ω4_1) cos(φ3 - φ4)) / (l2 sin(φ4 - φ3))
  ∂ω3_2/∂φ2 = (l1 (ω4_2 - 1) cos(φ2 - φ4) + l2 ω3_2 (ω3_2 - ω4_2) cos(φ3 - φ4))
                / (l2 sin(φ4 - φ3))
  ∂ω4_2/∂φ1 = (l1 ω3_1 cos(φ2 - φ3) + l2 ω4_2 (ω3_1 - ω4_1) cos(φ3 - φ4)) / (l2 sin(φ4 - φ3))
  ∂ω4_2/∂φ2 = (l1 (ω3_2 - 1) cos(φ2 - φ3) + l2 ω4_2 (ω3_2 - ω4_2) cos(φ3 - φ4))
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

Coordinates:

  q = (φ1, φ2)

Inertia:

  M11      = C0 + C2 ω3_1² + C3 ω4_1² + C4 ω3_1 cos(φ1 - φ3)
  M12      = C2 ω3_1 ω3_2 + C3 ω4_1 ω4_2 + ½ C4 ω3_2 cos(φ1 - φ3) + ½ C5 ω4_1 cos(φ2 - φ4)
  M22      = C1 + C2 ω3_2² + C3 ω4_2² + C5 ω4_2 cos(φ2 - φ4)
  ∂M11/∂φ1 = 2 C2 ω3_1 ∂ω3_1/∂φ1
           + 2 C3 ω4_1 ∂ω4_1/∂φ1
           + C4 ∂ω3_1/∂φ1 cos(φ1 - φ3)
           + C4 ω3_1 (ω3_1 - 1) sin(φ1 - φ3)
  ∂M11/∂φ2 = 2 C2 ω3_1 ∂ω3_1/∂φ2
           + 2 C3 ω4_1 ∂ω4_1/∂φ2
           + C4 ∂ω3_1/∂φ2 cos(φ1 - φ3)
           + C4 ω3_1 ω3_2 sin(φ1 - φ3)
  ∂M12/∂φ1 = C2 ω3_2 ∂ω3_1/∂φ1
           + C2 ω3_1 ∂ω3_2/∂φ1
           + C3 ω4_2 ∂ω4_1/∂φ1
           + C3 ω4_1 ∂ω4_2/∂φ1
           + ½ (C4 ∂ω3_2/∂φ1 cos(φ1 - φ3) + C4 ω3_2 (ω3_1 - 1) sin(φ1 - φ3))
           + ½ (C5 ∂ω4_1/∂φ1 cos(φ2 - φ4) + C5 ω4_1² sin(φ2 - φ4))
  ∂M12/∂φ2 = C2 ω3_2 ∂ω3_1/∂φ2
           + C2 ω3_1 ∂ω3_2/∂φ2
           + C3 ω4_2 ∂ω4_1/∂φ2
           + C3 ω4_1 ∂ω4_2/∂φ2
           + ½ (C4 ∂ω3_2/∂φ2 cos(φ1 - φ3) + C4 ω3_2² sin(φ1 - φ3))
           + ½ (C5 ∂ω4_1/∂φ2 cos(φ2 - φ4) + C5 ω4_1 (ω4_2 - 1) sin(φ2 - φ4))
  ∂M22/∂φ1 = 2 C2 ω3_2 ∂ω3_2/∂φ1
           + 2 C3 ω4_2 ∂ω4_2/∂φ1
           + C5 ∂ω4_2/∂φ1 cos(φ2 - φ4)
           + C5 ω4_1 ω4_2 sin(φ2 - φ4)
  ∂M22/∂φ2 = 2 C2 ω3_2 ∂ω3_2/∂φ2
           + 2 C3 ω4_2 ∂ω4_2/∂φ2
           + C5 ∂ω4_2/∂φ2 cos(φ2 - φ4)
           + C5 ω4_2 (ω4_2 - 1) sin(φ2 - φ4)
  h1       = φ̇1 φ̇2 ∂M11/∂φ2 + ½ ∂M11/∂φ1 φ̇1² + φ̇2² (∂M12/∂φ2 - ½ ∂M22/∂φ1)
  h2       = φ̇1² (∂M12/∂φ1 - ½ ∂M11/∂φ2) + φ̇1 φ̇2 ∂M22/∂φ1 + ½ ∂M22/∂φ2 φ̇2²

Potential energy:

  ∂P_s/∂φ1 = k (φ1 - φ1⁰)
           + k (ω3_1 - 1) (φ3 - φ3⁰ - φ1 + φ1⁰)
           + k ω4_1 (φ4 - φ4⁰ - φ2 + φ2⁰)
           + k (ω3_1 - ω4_1) (φ3 - φ3⁰ - (φ4 - φ4⁰))
  ∂P_s/∂φ2 = k (φ2 - φ2⁰)
           + k ω3_2 (φ3 - φ3⁰ - φ1 + φ1⁰)
           + k (ω4_2 - 1) (φ4 - φ4⁰ - φ2 + φ2⁰)
           + k (ω3_2 - ω4_2) (φ3 - φ3⁰ - (φ4 - φ4⁰))

Other forces:

  τ1 = left_torque sin(2 π f t)
     - c φ̇1
     + c (1 - ω3_1) (φ̇1 (ω3_1 - 1) + ω3_2 φ̇2)
     - c ω4_1 (ω4_1 φ̇1 + φ̇2 (ω4_2 - 1))
     + c (ω4_1 - ω3_1) (φ̇1 (ω3_1 - ω4_1) + φ̇2 (ω3_2 - ω4_2))
  τ2 = right_torque cos(2 π f t)
     - c φ̇2
     - c ω3_2 (φ̇1 (ω3_1 - 1) + ω3_2 φ̇2)
     + c (1 - ω4_2) (ω4_1 φ̇1 + φ̇2 (ω4_2 - 1))
     + c (ω4_2 - ω3_2) (φ̇1 (ω3_1 - ω4_1) + φ̇2 (ω3_2 - ω4_2))

Balance:

  M11 φ̈1 + M12 φ̈2 + h1 + ∂P_s/∂φ1 = τ1
  M12 φ̈1 + M22 φ̈2 + h2 + ∂P_s/∂φ2 = τ2

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
  ε   = sign((X⁰ sin(5/36 π) - Y⁰ cos(5/36 π)) / l2 + (X⁰ sin(31/36 π) - Y⁰ cos(31/36 π)) / l2)
        which way the loop closes: as drawn

  φ3⁰, φ4⁰, X⁰, Y⁰: by the formulas of the loops, at φ1 = φ1⁰, φ2 = φ2⁰
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
\eta &= \frac{\varepsilon}{2 \, D} \, \sqrt{D \left(4 \, l_{2}^{2} - D\right)} \\
\cos \varphi_{3} &= \frac{\frac{1}{2} \, X - Y \, \eta}{l_{2}} \\
\sin \varphi_{3} &= \frac{\frac{1}{2} \, Y + X \, \eta}{l_{2}} \\
\cos \varphi_{4} &= -\frac{\frac{1}{2} \, X + Y \, \eta}{l_{2}} \\
\sin \varphi_{4} &= \frac{X \, \eta - \frac{1}{2} \, Y}{l_{2}} \\
& \varphi_{3} = \operatorname{atan2}(\sin \varphi_{3}, \cos \varphi_{3}),\quad \varphi_{4} = \operatorname{atan2}(\sin \varphi_{4}, \cos \varphi_{4}) \quad\text{(continuous over many turns; ${}^0$: as assembled)} \\
& \omega_{3,1} = \frac{\partial \varphi_{3}}{\partial \varphi_{1}},\quad \omega_{4,1} = \frac{\partial \varphi_{4}}{\partial \varphi_{1}},\quad \omega_{3,2} = \frac{\partial \varphi_{3}}{\partial \varphi_{2}},\quad \omega_{4,2} = \frac{\partial \varphi_{4}}{\partial \varphi_{2}} \\
\omega_{3,1} &= \frac{l_{1} \sin\left(\varphi_{4} - \varphi_{1}\right)}{l_{2} \sin\left(\varphi_{3} - \varphi_{4}\right)} \\
\omega_{4,1} &= \frac{l_{1} \sin\left(\varphi_{3} - \varphi_{1}\right)}{l_{2} \sin\left(\varphi_{3} - \varphi_{4}\right)} \\
\omega_{3,2} &= \frac{l_{1} \sin\left(\varphi_{2} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{3} - \varphi_{4}\right)} \\
\omega_{4,2} &= \frac{l_{1} \sin\left(\varphi_{2} - \varphi_{3}\right)}{l_{2} \sin\left(\varphi_{3} - \varphi_{4}\right)} \\
\frac{\partial \omega_{3,1}}{\partial \varphi_{1}} &= \frac{l_{1} \left(\omega_{4,1} - 1\right) \cos\left(\varphi_{1} - \varphi_{4}\right) + l_{2} \, \omega_{3,1} \left(\omega_{4,1} - \omega_{3,1}\right) \cos\left(\varphi_{3} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{3} - \varphi_{4}\right)} \\
\frac{\partial \omega_{3,1}}{\partial \varphi_{2}} &= \frac{l_{1} \, \omega_{4,2} \cos\left(\varphi_{1} - \varphi_{4}\right) + l_{2} \, \omega_{3,1} \left(\omega_{4,2} - \omega_{3,2}\right) \cos\left(\varphi_{3} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{3} - \varphi_{4}\right)} \\
\frac{\partial \omega_{4,1}}{\partial \varphi_{1}} &= \frac{l_{1} \left(\omega_{3,1} - 1\right) \cos\left(\varphi_{1} - \varphi_{3}\right) + l_{2} \, \omega_{4,1} \left(\omega_{4,1} - \omega_{3,1}\right) \cos\left(\varphi_{3} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{3} - \varphi_{4}\right)} \\
\frac{\partial \omega_{4,1}}{\partial \varphi_{2}} &= \frac{l_{1} \, \omega_{3,2} \cos\left(\varphi_{1} - \varphi_{3}\right) + l_{2} \, \omega_{4,1} \left(\omega_{4,2} - \omega_{3,2}\right) \cos\left(\varphi_{3} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{3} - \varphi_{4}\right)} \\
\frac{\partial \omega_{3,2}}{\partial \varphi_{1}} &= \frac{l_{1} \, \omega_{4,1} \cos\left(\varphi_{2} - \varphi_{4}\right) + l_{2} \, \omega_{3,2} \left(\omega_{3,1} - \omega_{4,1}\right) \cos\left(\varphi_{3} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{4} - \varphi_{3}\right)} \\
\frac{\partial \omega_{3,2}}{\partial \varphi_{2}} &= \frac{l_{1} \left(\omega_{4,2} - 1\right) \cos\left(\varphi_{2} - \varphi_{4}\right) + l_{2} \, \omega_{3,2} \left(\omega_{3,2} - \omega_{4,2}\right) \cos\left(\varphi_{3} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{4} - \varphi_{3}\right)} \\
\frac{\partial \omega_{4,2}}{\partial \varphi_{1}} &= \frac{l_{1} \, \omega_{3,1} \cos\left(\varphi_{2} - \varphi_{3}\right) + l_{2} \, \omega_{4,2} \left(\omega_{3,1} - \omega_{4,1}\right) \cos\left(\varphi_{3} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{4} - \varphi_{3}\right)} \\
\frac{\partial \omega_{4,2}}{\partial \varphi_{2}} &= \frac{l_{1} \left(\omega_{3,2} - 1\right) \cos\left(\varphi_{2} - \varphi_{3}\right) + l_{2} \, \omega_{4,2} \left(\omega_{3,2} - \omega_{4,2}\right) \cos\left(\varphi_{3} - \varphi_{4}\right)}{l_{2} \sin\left(\varphi_{4} - \varphi_{3}\right)}
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
Coordinates:
\begin{align*}
& q = \left(\varphi_{1},\, \varphi_{2}\right)
\end{align*}
Inertia:
\begin{align*}
M_{11} &= C_{0} + C_{2} \, \omega_{3,1}^{2} + C_{3} \, \omega_{4,1}^{2} + C_{4} \, \omega_{3,1} \cos\left(\varphi_{1} - \varphi_{3}\right) \\
M_{12} &= C_{2} \, \omega_{3,1} \, \omega_{3,2} \\
&\quad {}+ C_{3} \, \omega_{4,1} \, \omega_{4,2} \\
&\quad {}+ \frac{1}{2} \, C_{4} \, \omega_{3,2} \cos\left(\varphi_{1} - \varphi_{3}\right) \\
&\quad {}+ \frac{1}{2} \, C_{5} \, \omega_{4,1} \cos\left(\varphi_{2} - \varphi_{4}\right) \\
M_{22} &= C_{1} + C_{2} \, \omega_{3,2}^{2} + C_{3} \, \omega_{4,2}^{2} + C_{5} \, \omega_{4,2} \cos\left(\varphi_{2} - \varphi_{4}\right) \\
\frac{\partial M_{11}}{\partial \varphi_{1}} &= 2 \, C_{2} \, \omega_{3,1} \, \frac{\partial \omega_{3,1}}{\partial \varphi_{1}} \\
&\quad {}+ 2 \, C_{3} \, \omega_{4,1} \, \frac{\partial \omega_{4,1}}{\partial \varphi_{1}} \\
&\quad {}+ C_{4} \, \frac{\partial \omega_{3,1}}{\partial \varphi_{1}} \cos\left(\varphi_{1} - \varphi_{3}\right) \\
&\quad {}+ C_{4} \, \omega_{3,1} \left(\omega_{3,1} - 1\right) \sin\left(\varphi_{1} - \varphi_{3}\right) \\
\frac{\partial M_{11}}{\partial \varphi_{2}} &= 2 \, C_{2} \, \omega_{3,1} \, \frac{\partial \omega_{3,1}}{\partial \varphi_{2}} \\
&\quad {}+ 2 \, C_{3} \, \omega_{4,1} \, \frac{\partial \omega_{4,1}}{\partial \varphi_{2}} \\
&\quad {}+ C_{4} \, \frac{\partial \omega_{3,1}}{\partial \varphi_{2}} \cos\left(\varphi_{1} - \varphi_{3}\right) \\
&\quad {}+ C_{4} \, \omega_{3,1} \, \omega_{3,2} \sin\left(\varphi_{1} - \varphi_{3}\right) \\
\frac{\partial M_{12}}{\partial \varphi_{1}} &= C_{2} \, \omega_{3,2} \, \frac{\partial \omega_{3,1}}{\partial \varphi_{1}} \\
&\quad {}+ C_{2} \, \omega_{3,1} \, \frac{\partial \omega_{3,2}}{\partial \varphi_{1}} \\
&\quad {}+ C_{3} \, \omega_{4,2} \, \frac{\partial \omega_{4,1}}{\partial \varphi_{1}} \\
&\quad {}+ C_{3} \, \omega_{4,1} \, \frac{\partial \omega_{4,2}}{\partial \varphi_{1}} \\
&\quad {}+ \frac{1}{2} \left(C_{4} \, \frac{\partial \omega_{3,2}}{\partial \varphi_{1}} \cos\left(\varphi_{1} - \varphi_{3}\right) + C_{4} \, \omega_{3,2} \left(\omega_{3,1} - 1\right) \sin\left(\varphi_{1} - \varphi_{3}\right)\right) \\
&\quad {}+ \frac{1}{2} \left(C_{5} \, \frac{\partial \omega_{4,1}}{\partial \varphi_{1}} \cos\left(\varphi_{2} - \varphi_{4}\right) + C_{5} \, \omega_{4,1}^{2} \sin\left(\varphi_{2} - \varphi_{4}\right)\right) \\
\frac{\partial M_{12}}{\partial \varphi_{2}} &= C_{2} \, \omega_{3,2} \, \frac{\partial \omega_{3,1}}{\partial \varphi_{2}} \\
&\quad {}+ C_{2} \, \omega_{3,1} \, \frac{\partial \omega_{3,2}}{\partial \varphi_{2}} \\
&\quad {}+ C_{3} \, \omega_{4,2} \, \frac{\partial \omega_{4,1}}{\partial \varphi_{2}} \\
&\quad {}+ C_{3} \, \omega_{4,1} \, \frac{\partial \omega_{4,2}}{\partial \varphi_{2}} \\
&\quad {}+ \frac{1}{2} \left(C_{4} \, \frac{\partial \omega_{3,2}}{\partial \varphi_{2}} \cos\left(\varphi_{1} - \varphi_{3}\right) + C_{4} \, \omega_{3,2}^{2} \sin\left(\varphi_{1} - \varphi_{3}\right)\right) \\
&\quad {}+ \frac{1}{2} \left(C_{5} \, \frac{\partial \omega_{4,1}}{\partial \varphi_{2}} \cos\left(\varphi_{2} - \varphi_{4}\right) + C_{5} \, \omega_{4,1} \left(\omega_{4,2} - 1\right) \sin\left(\varphi_{2} - \varphi_{4}\right)\right) \\
\frac{\partial M_{22}}{\partial \varphi_{1}} &= 2 \, C_{2} \, \omega_{3,2} \, \frac{\partial \omega_{3,2}}{\partial \varphi_{1}} \\
&\quad {}+ 2 \, C_{3} \, \omega_{4,2} \, \frac{\partial \omega_{4,2}}{\partial \varphi_{1}} \\
&\quad {}+ C_{5} \, \frac{\partial \omega_{4,2}}{\partial \varphi_{1}} \cos\left(\varphi_{2} - \varphi_{4}\right) \\
&\quad {}+ C_{5} \, \omega_{4,1} \, \omega_{4,2} \sin\left(\varphi_{2} - \varphi_{4}\right) \\
\frac{\partial M_{22}}{\partial \varphi_{2}} &= 2 \, C_{2} \, \omega_{3,2} \, \frac{\partial \omega_{3,2}}{\partial \varphi_{2}} \\
&\quad {}+ 2 \, C_{3} \, \omega_{4,2} \, \frac{\partial \omega_{4,2}}{\partial \varphi_{2}} \\
&\quad {}+ C_{5} \, \frac{\partial \omega_{4,2}}{\partial \varphi_{2}} \cos\left(\varphi_{2} - \varphi_{4}\right) \\
&\quad {}+ C_{5} \, \omega_{4,2} \left(\omega_{4,2} - 1\right) \sin\left(\varphi_{2} - \varphi_{4}\right) \\
h_{1} &= \dot{\varphi}_{1} \, \dot{\varphi}_{2} \, \frac{\partial M_{11}}{\partial \varphi_{2}} + \frac{1}{2} \, \frac{\partial M_{11}}{\partial \varphi_{1}} \, \dot{\varphi}_{1}^{2} + \dot{\varphi}_{2}^{2} \left(\frac{\partial M_{12}}{\partial \varphi_{2}} - \frac{1}{2} \, \frac{\partial M_{22}}{\partial \varphi_{1}}\right) \\
h_{2} &= \dot{\varphi}_{1}^{2} \left(\frac{\partial M_{12}}{\partial \varphi_{1}} - \frac{1}{2} \, \frac{\partial M_{11}}{\partial \varphi_{2}}\right) + \dot{\varphi}_{1} \, \dot{\varphi}_{2} \, \frac{\partial M_{22}}{\partial \varphi_{1}} + \frac{1}{2} \, \frac{\partial M_{22}}{\partial \varphi_{2}} \, \dot{\varphi}_{2}^{2}
\end{align*}
Potential energy:
\begin{align*}
\frac{\partial P_s}{\partial \varphi_{1}} &= k \left(\varphi_{1} - \varphi_{1}^0\right) \\
&\quad {}+ k \left(\omega_{3,1} - 1\right) \left(\varphi_{3} - \varphi_{3}^0 - \varphi_{1} + \varphi_{1}^0\right) \\
&\quad {}+ k \, \omega_{4,1} \left(\varphi_{4} - \varphi_{4}^0 - \varphi_{2} + \varphi_{2}^0\right) \\
&\quad {}+ k \left(\omega_{3,1} - \omega_{4,1}\right) \left(\varphi_{3} - \varphi_{3}^0 - \left(\varphi_{4} - \varphi_{4}^0\right)\right) \\
\frac{\partial P_s}{\partial \varphi_{2}} &= k \left(\varphi_{2} - \varphi_{2}^0\right) \\
&\quad {}+ k \, \omega_{3,2} \left(\varphi_{3} - \varphi_{3}^0 - \varphi_{1} + \varphi_{1}^0\right) \\
&\quad {}+ k \left(\omega_{4,2} - 1\right) \left(\varphi_{4} - \varphi_{4}^0 - \varphi_{2} + \varphi_{2}^0\right) \\
&\quad {}+ k \left(\omega_{3,2} - \omega_{4,2}\right) \left(\varphi_{3} - \varphi_{3}^0 - \left(\varphi_{4} - \varphi_{4}^0\right)\right)
\end{align*}
Other forces:
\begin{align*}
\tau_{1} &= \mathit{left}_{\mathrm{torque}} \sin\left(2 \, \pi \, f \, t\right) \\
&\quad {}- c \, \dot{\varphi}_{1} \\
&\quad {}+ c \left(1 - \omega_{3,1}\right) \left(\dot{\varphi}_{1} \left(\omega_{3,1} - 1\right) + \omega_{3,2} \, \dot{\varphi}_{2}\right) \\
&\quad {}- c \, \omega_{4,1} \left(\omega_{4,1} \, \dot{\varphi}_{1} + \dot{\varphi}_{2} \left(\omega_{4,2} - 1\right)\right) \\
&\quad {}+ c \left(\omega_{4,1} - \omega_{3,1}\right) \left(\dot{\varphi}_{1} \left(\omega_{3,1} - \omega_{4,1}\right) + \dot{\varphi}_{2} \left(\omega_{3,2} - \omega_{4,2}\right)\right) \\
\tau_{2} &= \mathit{right}_{\mathrm{torque}} \cos\left(2 \, \pi \, f \, t\right) \\
&\quad {}- c \, \dot{\varphi}_{2} \\
&\quad {}- c \, \omega_{3,2} \left(\dot{\varphi}_{1} \left(\omega_{3,1} - 1\right) + \omega_{3,2} \, \dot{\varphi}_{2}\right) \\
&\quad {}+ c \left(1 - \omega_{4,2}\right) \left(\omega_{4,1} \, \dot{\varphi}_{1} + \dot{\varphi}_{2} \left(\omega_{4,2} - 1\right)\right) \\
&\quad {}+ c \left(\omega_{4,2} - \omega_{3,2}\right) \left(\dot{\varphi}_{1} \left(\omega_{3,1} - \omega_{4,1}\right) + \dot{\varphi}_{2} \left(\omega_{3,2} - \omega_{4,2}\right)\right)
\end{align*}
Balance:
\begin{align*}
& \begin{bmatrix} M_{11} & M_{12} \\[1ex] M_{12} & M_{22} \end{bmatrix} \begin{bmatrix} \ddot{\varphi}_{1} \\[1ex] \ddot{\varphi}_{2} \end{bmatrix} + \begin{bmatrix} h_{1} \\[1ex] h_{2} \end{bmatrix} + \begin{bmatrix} \frac{\partial P_s}{\partial \varphi_{1}} \\[1ex] \frac{\partial P_s}{\partial \varphi_{2}} \end{bmatrix} = \begin{bmatrix} \tau_{1} \\[1ex] \tau_{2} \end{bmatrix}
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
\varepsilon &= \operatorname{sgn}\left(\frac{{X}^0 \sin\left(\frac{5}{36} \, \pi\right) - {Y}^0 \cos\left(\frac{5}{36} \, \pi\right)}{l_{2}} + \frac{{X}^0 \sin\left(\frac{31}{36} \, \pi\right) - {Y}^0 \cos\left(\frac{31}{36} \, \pi\right)}{l_{2}}\right) && \text{which way the loop closes: as drawn} \\
& \varphi_{3}^0,\, \varphi_{4}^0,\, {X}^0,\, {Y}^0: \text{ by the formulas of the loops, at } \varphi_{1} = \varphi_{1}^0,\, \varphi_{2} = \varphi_{2}^0
\end{align*}

\end{document}
"#;
}
