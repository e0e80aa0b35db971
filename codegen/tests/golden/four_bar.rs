/// Simulator of the model `four_bar`, generated from its equations of motion.
///
/// The flexure mechanism of the double-rocker actuator alone: a four-bar of slender bars with
/// flexure hinges, released with the crank turning.
///
/// A check case: its energy is constant, and its motion is known to ten digits from an independent
/// integration in absolute coordinates.
#[allow(
    non_snake_case,
    non_upper_case_globals,
    unused,
    clippy::all,
    clippy::pedantic,
    rustdoc::all
)]
pub mod four_bar {
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
        /// width, out of plane in m; 0.003 by default
        pub b: f64,
        /// hinge web thickness in m; 0.0015 by default
        pub e: f64,
        /// hinge radius in m; 0.001 by default
        pub r: f64,
        /// length of a link in m; 0.0102 by default
        pub l1: f64,
        /// length of a link in m; 0.0232 by default
        pub l2: f64,
        /// length of a link in m; 0.01 by default
        pub l3: f64,
        /// length of a link in m; 0.025 by default
        pub l4: f64,
        /// mass of a link in kg; 0.0002568 by default
        pub m1: f64,
        /// mass of a link in kg; 0.0005877 by default
        pub m2: f64,
        /// mass of a link in kg; 0.0002529 by default
        pub m3: f64,
    }
    impl Default for Params {
        fn default() -> Self {
            Self {
                E: 7.2e10,
                b: 0.003,
                e: 0.0015,
                r: 0.001,
                l1: 0.0102,
                l2: 0.0232,
                l3: 0.01,
                l4: 0.025,
                m1: 0.0002568,
                m2: 0.0005877,
                m3: 0.0002529,
            }
        }
    }
    impl Params {
        /// The values in the order of [`VARIABLES`].
        pub fn values(&self) -> [f64; 11] {
            [
                self.E,
                self.b,
                self.e,
                self.r,
                self.l1,
                self.l2,
                self.l3,
                self.l4,
                self.m1,
                self.m2,
                self.m3,
            ]
        }
        /// Params of values in the order of [`VARIABLES`].
        pub fn from_values(values: [f64; 11]) -> Self {
            Self {
                E: values[0],
                b: values[1],
                e: values[2],
                r: values[3],
                l1: values[4],
                l2: values[5],
                l3: values[6],
                l4: values[7],
                m1: values[8],
                m2: values[9],
                m3: values[10],
            }
        }
        /// Closes the loops and computes everything that depends on params alone.
        ///
        /// # Errors
        /// What is wrong with the parameter set, in the words of `flexure check`.
        pub fn prepare(&self) -> Result<Prepared<f64>, Diagnostic> {
            check_params(PARAMS, &self.values())?;
            let E = self.E;
            let b = self.b;
            let e = self.e;
            let r = self.r;
            let l1 = self.l1;
            let l2 = self.l2;
            let l3 = self.l3;
            let l4 = self.l4;
            let m1 = self.m1;
            let m2 = self.m2;
            let m3 = self.m3;
            let l1_squared = l1 * l1;
            // moment of inertia about the centre of mass of crank
            let I1 = l1_squared * m1 * 0.08333333333333333;
            let l2_squared = l2 * l2;
            // moment of inertia about the centre of mass of coupler
            let I2 = l2_squared * m2 * 0.08333333333333333;
            let l3_squared = l3 * l3;
            // moment of inertia about the centre of mass of rocker
            let I3 = l3_squared * m3 * 0.08333333333333333;
            let l2_minus_l3 = l2 - l3;
            let l2_minus_l3_squared = l2_minus_l3 * l2_minus_l3;
            let X_0 = l4 - l1 * 0.17364817766693041;
            let t1 = l1 * 0.984807753012208;
            let Y_0 = -t1;
            let D_0 = X_0 * X_0 + Y_0 * Y_0;
            let l2_plus_l3 = l2 + l3;
            let l2_plus_l3_squared = l2_plus_l3 * l2_plus_l3;
            let t2 = (l2_minus_l3_squared - D_0) * (l2_plus_l3_squared - D_0);
            let l2_squared_l3_squared = l2_squared * l3_squared;
            let t3 = t2 * 0.25 / l2_squared_l3_squared;
            // distance of the centre of mass from the first end of crank
            let r1 = l1 * 0.5;
            // constant of the inertia
            let C0 = I1 + m1 * (r1 * r1) + l1_squared * m2;
            // distance of the centre of mass from the first end of coupler
            let r2 = l2 * 0.5;
            // constant of the inertia
            let C1 = I2 + m2 * (r2 * r2);
            let t4 = l2_squared - l3_squared;
            let κ_0 = (t4 + D_0) * 0.5 / D_0;
            let Y_0_κ_0 = Y_0 * κ_0;
            // which way the loop closes: as drawn
            let ε = (X_0 / l3 - Y_0 / l2).if_positive(1.0, -1.0);
            let η_0 = ε * (-t2).sqrt() * 0.5 / D_0;
            let X_0_η_0 = X_0 * η_0;
            let s3_0 = (Y_0_κ_0 + t1 + X_0_η_0) / l3;
            let X_0_κ_0 = X_0 * κ_0;
            let Y_0_η_0 = Y_0 * η_0;
            let c3_0 = -((X_0 - X_0_κ_0 + Y_0_η_0) / l3);
            // angle of `rocker` as assembled
            let φ3_0 = Real::atan2(s3_0, c3_0).unwrap_to(1.5707963267948966);
            let s2_0 = (Y_0_κ_0 + X_0_η_0) / l2;
            let c2_0 = (X_0_κ_0 - Y_0_η_0) / l2;
            // angle of `coupler` as assembled
            let φ2_0 = Real::atan2(s2_0, c2_0).unwrap_to(0.0);
            let sin_φ2_0_minus_φ3_0 = Real::sin(φ2_0 - φ3_0);
            let t5 = l1 * Real::sin(1.3962634015954636 - φ3_0)
                / (l2 * sin_φ2_0_minus_φ3_0);
            // rate as assembled
            let ω2_0 = -t5;
            // distance of the centre of mass from the first end of rocker
            let r3 = l3 * 0.5;
            // constant of the inertia
            let C2 = I3 + m3 * (r3 * r3);
            let t6 = 1.3962634015954636 - φ2_0;
            let (t7, t8) = Real::sin_cos(t6);
            // rate as assembled
            let ω3_0 = -(l1 * t7 / (l3 * sin_φ2_0_minus_φ3_0));
            // constant of the inertia
            let C3 = l1 * m2 * r2 * 2.0;
            // inertia as assembled
            let A_crank_0 = C0 + C1 * (ω2_0 * ω2_0) + C2 * (ω3_0 * ω3_0)
                + C3 * ω2_0 * t8;
            let sqrt_e = e.sqrt();
            let sqrt_e_squared = sqrt_e * sqrt_e;
            let t9 = E * b * (sqrt_e * (sqrt_e_squared * sqrt_e_squared))
                * 0.07073553026306459;
            // stiffness of a hinge
            let k = t9 / r.sqrt();
            if !(E > 0.0) {
                return Err(FAILURES[0].diagnostic(&[E]));
            }
            if !(b > 0.0) {
                return Err(FAILURES[1].diagnostic(&[b]));
            }
            if !(e > 0.0) {
                return Err(FAILURES[2].diagnostic(&[e]));
            }
            if !(r > 0.0) {
                return Err(FAILURES[3].diagnostic(&[r]));
            }
            if !(l1 > 0.0) {
                return Err(FAILURES[4].diagnostic(&[l1]));
            }
            if !(m1 >= 0.0) {
                return Err(FAILURES[5].diagnostic(&[m1]));
            }
            if !(I1 >= 0.0) {
                return Err(FAILURES[6].diagnostic(&[I1]));
            }
            if !(l2 > 0.0) {
                return Err(FAILURES[7].diagnostic(&[l2]));
            }
            if !(m2 >= 0.0) {
                return Err(FAILURES[8].diagnostic(&[m2]));
            }
            if !(I2 >= 0.0) {
                return Err(FAILURES[9].diagnostic(&[I2]));
            }
            if !(l3 > 0.0) {
                return Err(FAILURES[10].diagnostic(&[l3]));
            }
            if !(m3 >= 0.0) {
                return Err(FAILURES[11].diagnostic(&[m3]));
            }
            if !(I3 >= 0.0) {
                return Err(FAILURES[12].diagnostic(&[I3]));
            }
            if !(-t3 >= 0.0) {
                let sqrt_D_0 = D_0.sqrt();
                return Err(
                    FAILURES[13]
                        .diagnostic(
                            &[
                                (sqrt_D_0 - l2 - l3).larger(l2_minus_l3.abs() - sqrt_D_0),
                                (l3 - sqrt_D_0).abs(),
                                l3 + sqrt_D_0,
                                1.3962634015954636,
                            ],
                        ),
                );
            }
            if !(-(t3 + 1e-12) > 0.0) {
                let sqrt_D_0_2 = D_0.sqrt();
                return Err(
                    FAILURES[14]
                        .diagnostic(
                            &[
                                (sqrt_D_0_2 - l2 - l3)
                                    .larger(l2_minus_l3.abs() - sqrt_D_0_2),
                                (l3 - sqrt_D_0_2).abs(),
                                l3 + sqrt_D_0_2,
                                1.3962634015954636,
                            ],
                        ),
                );
            }
            if !(A_crank_0 > 0.0) {
                return Err(FAILURES[15].diagnostic(&[]));
            }
            let mut prepared = Prepared {
                start_states: [1.3962634015954636, 20.0],
                start_discretes: [0.0, 0.0],
                l1,
                l2,
                l3,
                l4,
                m2,
                C0,
                constant1: t4,
                l2_minus_l3_squared,
                l2_plus_l3_squared,
                half_ε: ε * 0.5,
                per_l2: l2.recip(),
                per_l3: l3.recip(),
                l1_per_l2: l1 / l2,
                r2,
                C1,
                l1_per_l3: l1 / l3,
                C2,
                C3,
                k,
                c2_0,
                s2_0,
                c3_0,
                s3_0,
                m1_r1: m1 * r1,
                m3_r3: m3 * r3,
                two_C1: C1 * 2.0,
                two_C2: C2 * 2.0,
                two_C3: C3 * 2.0,
                half_k: k * 0.5,
                constant2: 0.25 / l2_squared_l3_squared,
                table_of_φ1: Table::none(),
            };
            check_start(prepared.states(), &prepared.start_states)?;
            check_start(prepared.discretes(), &prepared.start_discretes)?;
            prepared.table_of_φ1 = Table::fit(
                &prepared,
                &COORDINATES,
                0,
                2,
                |φ1, d| { functions_of_φ1(φ1, array(d), &prepared) },
            );
            Ok(prepared)
        }
    }
    /// Everything that depends on params alone, as the functions of this module need it.
    #[derive(Clone, Debug)]
    pub struct Prepared<T> {
        /// Continuous state at the start.
        pub start_states: [T; 2],
        /// Discrete state at the start.
        pub start_discretes: [T; 2],
        /// `l1`
        pub l1: T,
        /// `l2`
        pub l2: T,
        /// `l3`
        pub l3: T,
        /// `l4`
        pub l4: T,
        /// `m2`
        pub m2: T,
        /// `C0` constant of the inertia
        pub C0: T,
        /// `l2 * l2 - l3 * l3`
        pub constant1: T,
        /// `(l2 - l3) * (l2 - l3)`
        pub l2_minus_l3_squared: T,
        /// `(l2 + l3) * (l2 + l3)`
        pub l2_plus_l3_squared: T,
        /// `0.5 * ε`
        pub half_ε: T,
        /// `1.0 / l2`
        pub per_l2: T,
        /// `1.0 / l3`
        pub per_l3: T,
        /// `l1 / l2`
        pub l1_per_l2: T,
        /// `r2` distance of the centre of mass from the first end of coupler
        pub r2: T,
        /// `C1` constant of the inertia
        pub C1: T,
        /// `l1 / l3`
        pub l1_per_l3: T,
        /// `C2` constant of the inertia
        pub C2: T,
        /// `C3` constant of the inertia
        pub C3: T,
        /// `k` stiffness of a hinge
        pub k: T,
        /// `c2⁰`
        pub c2_0: T,
        /// `s2⁰`
        pub s2_0: T,
        /// `c3⁰`
        pub c3_0: T,
        /// `s3⁰`
        pub s3_0: T,
        /// `m1 * r1`
        pub m1_r1: T,
        /// `m3 * r3`
        pub m3_r3: T,
        /// `2.0 * C1`
        pub two_C1: T,
        /// `2.0 * C2`
        pub two_C2: T,
        /// `2.0 * C3`
        pub two_C3: T,
        /// `0.5 * k`
        pub half_k: T,
        /// `0.25 / (l2 * l2 * l3 * l3)`
        pub constant2: T,
        /// [`functions_of_φ1`] near the start.
        pub table_of_φ1: Table<T, 5>,
    }
    impl<T: Copy> Prepared<T> {
        /// The same with every number turned into another, without curves: for dual numbers or lanes.
        pub fn map<U>(&self, turn: impl Fn(T) -> U) -> Prepared<U> {
            Prepared {
                start_states: self.start_states.map(&turn),
                start_discretes: self.start_discretes.map(&turn),
                l1: turn(self.l1),
                l2: turn(self.l2),
                l3: turn(self.l3),
                l4: turn(self.l4),
                m2: turn(self.m2),
                C0: turn(self.C0),
                constant1: turn(self.constant1),
                l2_minus_l3_squared: turn(self.l2_minus_l3_squared),
                l2_plus_l3_squared: turn(self.l2_plus_l3_squared),
                half_ε: turn(self.half_ε),
                per_l2: turn(self.per_l2),
                per_l3: turn(self.per_l3),
                l1_per_l2: turn(self.l1_per_l2),
                r2: turn(self.r2),
                C1: turn(self.C1),
                l1_per_l3: turn(self.l1_per_l3),
                C2: turn(self.C2),
                C3: turn(self.C3),
                k: turn(self.k),
                c2_0: turn(self.c2_0),
                s2_0: turn(self.s2_0),
                c3_0: turn(self.c3_0),
                s3_0: turn(self.s3_0),
                m1_r1: turn(self.m1_r1),
                m3_r3: turn(self.m3_r3),
                two_C1: turn(self.two_C1),
                two_C2: turn(self.two_C2),
                two_C3: turn(self.two_C3),
                half_k: turn(self.half_k),
                constant2: turn(self.constant2),
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
                l1: join(self.l1, other.l1),
                l2: join(self.l2, other.l2),
                l3: join(self.l3, other.l3),
                l4: join(self.l4, other.l4),
                m2: join(self.m2, other.m2),
                C0: join(self.C0, other.C0),
                constant1: join(self.constant1, other.constant1),
                l2_minus_l3_squared: join(
                    self.l2_minus_l3_squared,
                    other.l2_minus_l3_squared,
                ),
                l2_plus_l3_squared: join(
                    self.l2_plus_l3_squared,
                    other.l2_plus_l3_squared,
                ),
                half_ε: join(self.half_ε, other.half_ε),
                per_l2: join(self.per_l2, other.per_l2),
                per_l3: join(self.per_l3, other.per_l3),
                l1_per_l2: join(self.l1_per_l2, other.l1_per_l2),
                r2: join(self.r2, other.r2),
                C1: join(self.C1, other.C1),
                l1_per_l3: join(self.l1_per_l3, other.l1_per_l3),
                C2: join(self.C2, other.C2),
                C3: join(self.C3, other.C3),
                k: join(self.k, other.k),
                c2_0: join(self.c2_0, other.c2_0),
                s2_0: join(self.s2_0, other.s2_0),
                c3_0: join(self.c3_0, other.c3_0),
                s3_0: join(self.s3_0, other.s3_0),
                m1_r1: join(self.m1_r1, other.m1_r1),
                m3_r3: join(self.m3_r3, other.m3_r3),
                two_C1: join(self.two_C1, other.two_C1),
                two_C2: join(self.two_C2, other.two_C2),
                two_C3: join(self.two_C3, other.two_C3),
                half_k: join(self.half_k, other.half_k),
                constant2: join(self.constant2, other.constant2),
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
    /// What [`rhs`], [`accept`] and [`closures`] need that depends on `φ1` and params alone, in closed form.
    #[inline(always)]
    pub fn functions_of_φ1<T: Real>(φ1: T, d: &[T; 2], p: &Prepared<T>) -> [T; 5] {
        let turn_coupler = d[0];
        let turn_rocker = d[1];
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let l1_sin_φ1 = p.l1 * sin_φ1;
        let Y = -l1_sin_φ1;
        let l1_cos_φ1 = p.l1 * cos_φ1;
        // vector that is left to close crank–coupler–rocker
        let X = p.l4 - l1_cos_φ1;
        // its length squared
        let D = X * X + Y * Y;
        let per_D = D.recip();
        let κ = per_D * (p.constant1 + D) * 0.5;
        let Y_κ = Y * κ;
        let t1 = (D - p.l2_minus_l3_squared) * (D - p.l2_plus_l3_squared);
        let η = p.half_ε * (per_D * (-t1).sqrt());
        let X_η = X * η;
        let s2 = p.per_l2 * (Y_κ + X_η);
        let X_κ = X * κ;
        let Y_η = Y * η;
        let t2 = p.per_l3 * (X - X_κ + Y_η);
        let c3 = -t2;
        let c2 = p.per_l2 * (X_κ - Y_η);
        let s3 = p.per_l3 * (Y_κ + l1_sin_φ1 + X_η);
        let sin_φ2_minus_φ3 = s2 * c3 - c2 * s3;
        let per_sin_φ2_minus_φ3 = sin_φ2_minus_φ3.recip();
        let sin_φ1_minus_φ3 = sin_φ1 * c3 - cos_φ1 * s3;
        let t3 = p.l1_per_l2 * (per_sin_φ2_minus_φ3 * sin_φ1_minus_φ3);
        // rate of the angle of `coupler` per unit rate of `crank`
        let ω2 = -t3;
        let sin_φ1_minus_φ2 = sin_φ1 * c2 - cos_φ1 * s2;
        let t4 = p.l1_per_l3 * (per_sin_φ2_minus_φ3 * sin_φ1_minus_φ2);
        // rate of the angle of `rocker` per unit rate of `crank`
        let ω3 = -t4;
        let cos_φ1_minus_φ2 = cos_φ1 * c2 + sin_φ1 * s2;
        // inertia
        let A = p.C0 + p.C1 * (ω2 * ω2) + p.C2 * (ω3 * ω3)
            + p.C3 * (ω2 * cos_φ1_minus_φ2);
        let per_A = A.recip();
        let ω2_minus_one = ω2 - 1.0;
        let t5 = (p.c2_0 * s2 - p.s2_0 * c2).atan2(p.c2_0 * c2 + p.s2_0 * s2);
        // angle of `coupler` from the assembled one
        let φ2_minus_φ2_0 = t5.unwrap_to(turn_coupler);
        let t6 = ω2_minus_one
            * (T::from_f64(1.3962634015954636) - φ1 + φ2_minus_φ2_0);
        let t7 = t4 - t3;
        let t8 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `rocker` from the assembled one
        let φ3_minus_φ3_0 = t8.unwrap_to(turn_rocker);
        let t9 = p.k * (φ1 - 1.3962634015954636) + p.k * t6
            + p.k * (t7 * (φ2_minus_φ2_0 - φ3_minus_φ3_0));
        // slope of the potential energy of springs
        let dP_s_dφ1 = t9 + p.k * (φ3_minus_φ3_0 * ω3);
        let t10 = p.m1_r1 * cos_φ1 + p.m2 * (l1_cos_φ1 + p.r2 * (ω2 * c2))
            - p.m3_r3 * (ω3 * t2);
        // slope of the potential energy of gravity
        let dP_g_dφ1 = t10 * 9.81;
        // slope of the potential energy
        let dP_dφ1 = dP_s_dφ1 + dP_g_dφ1;
        let cos_φ1_minus_φ3 = cos_φ1 * c3 + sin_φ1 * s3;
        let cos_φ2_minus_φ3 = c2 * c3 + s2 * s3;
        let t11 = p.l1 * (cos_φ1_minus_φ3 * (ω3 - 1.0))
            - p.l2 * (ω2 * t7 * cos_φ2_minus_φ3);
        let ω2_prime = p.per_l2 * (per_sin_φ2_minus_φ3 * t11);
        let t12 = p.l1 * (cos_φ1_minus_φ2 * ω2_minus_one)
            - p.l3 * (ω3 * t7 * cos_φ2_minus_φ3);
        let ω3_prime = p.per_l3 * (per_sin_φ2_minus_φ3 * t12);
        let t13 = p.two_C1 * (ω2 * ω2_prime) + p.two_C2 * (ω3 * ω3_prime)
            + p.C3 * (ω2_prime * cos_φ1_minus_φ2);
        // slope of the inertia
        let dA_dφ1 = t13 + p.C3 * (sin_φ1_minus_φ2 * ω2 * ω2_minus_one);
        let ddφ1_per_dφ1_squared = per_A * -(dA_dφ1 * 0.5);
        [
            per_A * dP_dφ1,
            ddφ1_per_dφ1_squared,
            φ2_minus_φ2_0,
            φ3_minus_φ3_0,
            -(p.constant2 * t1),
        ]
    }
    /// dx/dt. Where a loop cannot close, entries are not numbers.
    #[inline(always)]
    pub fn rhs<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        dx: &mut [T; 2],
    ) {
        let φ1 = x[0];
        let dφ1 = x[1];
        let [per_A_dP_dφ1, ddφ1_per_dφ1_squared, ..] = if p.table_of_φ1.covers(φ1) {
            p.table_of_φ1.polynomials(φ1)
        } else {
            p.table_of_φ1.where_covered(φ1, functions_of_φ1(φ1, d, p))
        };
        // ── state ──
        let ddφ1 = (-per_A_dP_dφ1).plus_product(ddφ1_per_dφ1_squared, dφ1 * dφ1);
        dx[0] = dφ1;
        dx[1] = ddφ1;
    }
    /// ∂(dx/dt)/∂x, row by row; entries that are always zero are left as they are.
    #[inline(always)]
    pub fn jacobian<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let φ1 = x[0];
        let dφ1 = x[1];
        let turn_coupler = d[0];
        let turn_rocker = d[1];
        // ── configuration ──
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let l1_sin_φ1 = p.l1 * sin_φ1;
        let Y = -l1_sin_φ1;
        let l1_cos_φ1 = p.l1 * cos_φ1;
        // vector that is left to close crank–coupler–rocker
        let X = p.l4 - l1_cos_φ1;
        // its length squared
        let D = X * X + Y * Y;
        let per_D = D.recip();
        let κ = per_D * (p.constant1 + D) * 0.5;
        let Y_κ = Y * κ;
        let t1 = per_D
            * (-((D - p.l2_minus_l3_squared) * (D - p.l2_plus_l3_squared))).sqrt();
        let η = p.half_ε * t1;
        let X_η = X * η;
        let s2 = p.per_l2 * (Y_κ + X_η);
        let X_κ = X * κ;
        let Y_η = Y * η;
        let t2 = p.per_l3 * (X - X_κ + Y_η);
        let c3 = -t2;
        let c2 = p.per_l2 * (X_κ - Y_η);
        let s3 = p.per_l3 * (Y_κ + l1_sin_φ1 + X_η);
        let sin_φ2_minus_φ3 = s2 * c3 - c2 * s3;
        let per_sin_φ2_minus_φ3 = sin_φ2_minus_φ3.recip();
        let sin_φ1_minus_φ3 = sin_φ1 * c3 - cos_φ1 * s3;
        let t3 = p.l1_per_l2 * (per_sin_φ2_minus_φ3 * sin_φ1_minus_φ3);
        // rate of the angle of `coupler` per unit rate of `crank`
        let ω2 = -t3;
        let ω2_squared = ω2 * ω2;
        let sin_φ1_minus_φ2 = sin_φ1 * c2 - cos_φ1 * s2;
        let t4 = p.l1_per_l3 * (per_sin_φ2_minus_φ3 * sin_φ1_minus_φ2);
        // rate of the angle of `rocker` per unit rate of `crank`
        let ω3 = -t4;
        let ω3_squared = ω3 * ω3;
        let cos_φ1_minus_φ2 = cos_φ1 * c2 + sin_φ1 * s2;
        let ω2_cos_φ1_minus_φ2 = ω2 * cos_φ1_minus_φ2;
        // inertia
        let A = p.C0 + p.C1 * ω2_squared + p.C2 * ω3_squared
            + p.C3 * ω2_cos_φ1_minus_φ2;
        let cos_φ1_minus_φ3 = cos_φ1 * c3 + sin_φ1 * s3;
        let ω3_minus_one = ω3 - 1.0;
        let t5 = t4 - t3;
        let cos_φ2_minus_φ3 = c2 * c3 + s2 * s3;
        let t6 = p.l1 * (cos_φ1_minus_φ3 * ω3_minus_one)
            - p.l2 * (ω2 * t5 * cos_φ2_minus_φ3);
        let ω2_prime = p.per_l2 * (per_sin_φ2_minus_φ3 * t6);
        let ω2_minus_one = ω2 - 1.0;
        let t7 = p.l1 * (cos_φ1_minus_φ2 * ω2_minus_one)
            - p.l3 * (ω3 * t5 * cos_φ2_minus_φ3);
        let ω3_prime = p.per_l3 * (per_sin_φ2_minus_φ3 * t7);
        let ω2_prime_cos_φ1_minus_φ2 = ω2_prime * cos_φ1_minus_φ2;
        let t8 = p.two_C1 * (ω2 * ω2_prime) + p.two_C2 * (ω3 * ω3_prime)
            + p.C3 * ω2_prime_cos_φ1_minus_φ2;
        let sin_φ1_minus_φ2_ω2 = sin_φ1_minus_φ2 * ω2;
        // slope of the inertia
        let dA_dφ1 = t8 + p.C3 * (sin_φ1_minus_φ2_ω2 * ω2_minus_one);
        let t9 = (p.c2_0 * s2 - p.s2_0 * c2).atan2(p.c2_0 * c2 + p.s2_0 * s2);
        // angle of `coupler` from the assembled one
        let φ2_minus_φ2_0 = t9.unwrap_to(turn_coupler);
        let t10 = T::from_f64(1.3962634015954636) - φ1 + φ2_minus_φ2_0;
        let t11 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `rocker` from the assembled one
        let φ3_minus_φ3_0 = t11.unwrap_to(turn_rocker);
        let t12 = φ2_minus_φ2_0 - φ3_minus_φ3_0;
        let t13 = p.k * (φ1 - 1.3962634015954636) + p.k * (ω2_minus_one * t10)
            + p.k * (t5 * t12);
        // slope of the potential energy of springs
        let dP_s_dφ1 = t13 + p.k * (φ3_minus_φ3_0 * ω3);
        let t14 = p.m1_r1 * cos_φ1 + p.m2 * (l1_cos_φ1 + p.r2 * (ω2 * c2))
            - p.m3_r3 * (ω3 * t2);
        // slope of the potential energy of gravity
        let dP_g_dφ1 = t14 * 9.81;
        // slope of the potential energy
        let dP_dφ1 = dP_s_dφ1 + dP_g_dφ1;
        let per_A = A.recip();
        let ω2_minus_one_squared = ω2_minus_one * ω2_minus_one;
        let ω2_prime_minus_ω3_prime = ω2_prime - ω3_prime;
        let t15 = p.k + p.k * (ω2_prime * t10) + p.k * ω2_minus_one_squared
            + p.k * (t12 * ω2_prime_minus_ω3_prime);
        let t16 = t5 * t5;
        let ddP_s_dφ1_dφ1 = t15 + p.k * t16 + p.k * ω3_squared
            + p.k * (φ3_minus_φ3_0 * ω3_prime);
        let t17 = p.m2
            * (l1_sin_φ1 - p.r2 * (ω2_prime * c2) + p.r2 * (ω2_squared * s2));
        let t18 = p.m1_r1 * sin_φ1 + t17 + p.m3_r3 * (ω3_prime * t2)
            + p.m3_r3 * (ω3_squared * s3);
        let ddP_dφ1_dφ1 = ddP_s_dφ1_dφ1 - t18 * 9.81;
        let t19 = p.l1 * (sin_φ1_minus_φ3 * (ω3_minus_one * ω3_minus_one))
            + p.l1 * (cos_φ1_minus_φ3 * ω3_prime);
        let t20 = t5 * cos_φ2_minus_φ3;
        let t21 = t19 - p.l2 * (t20 * ω2_prime)
            - p.l2 * (ω2 * cos_φ2_minus_φ3 * ω2_prime_minus_ω3_prime);
        let t22 = p.per_l2
            * (per_sin_φ2_minus_φ3 * (t21 + p.l2 * (sin_φ2_minus_φ3 * ω2 * t16)));
        let t23 = (sin_φ2_minus_φ3 * sin_φ2_minus_φ3).recip() * t5
            * cos_φ2_minus_φ3;
        let dω2_prime_dφ1 = t22 - p.per_l2 * (t23 * t6);
        let t24 = p.l1 * (sin_φ1_minus_φ2 * ω2_minus_one_squared)
            + p.l1 * ω2_prime_cos_φ1_minus_φ2;
        let t25 = t24 - p.l3 * (t20 * ω3_prime)
            - p.l3 * (ω3 * cos_φ2_minus_φ3 * ω2_prime_minus_ω3_prime);
        let t26 = p.per_l3
            * (per_sin_φ2_minus_φ3 * (t25 + p.l3 * (sin_φ2_minus_φ3 * ω3 * t16)));
        let dω3_prime_dφ1 = t26 - p.per_l3 * (t23 * t7);
        let t27 = (p.C1 * (ω2_prime * ω2_prime) + p.C1 * (ω2 * dω2_prime_dφ1)) * 2.0
            + (p.C2 * (ω3_prime * ω3_prime) + p.C2 * (ω3 * dω3_prime_dφ1)) * 2.0;
        let t28 = t27 + p.C3 * (cos_φ1_minus_φ2 * dω2_prime_dφ1)
            + p.two_C3 * (sin_φ1_minus_φ2 * ω2_prime * ω2_minus_one);
        let ddA_dφ1_dφ1 = t28 + p.C3 * (sin_φ1_minus_φ2_ω2 * ω2_prime)
            - p.C3 * (ω2_cos_φ1_minus_φ2 * ω2_minus_one_squared);
        // ── state ──
        let dφ1_squared = dφ1 * dφ1;
        let dddφ1_dφ1 = (A * A).recip() * dA_dφ1
            * (dP_dφ1 + dA_dφ1 * 0.5 * dφ1_squared)
            - per_A * (ddP_dφ1_dφ1 + ddA_dφ1_dφ1 * 0.5 * dφ1_squared);
        let dddφ1_ddφ1 = -(per_A * dA_dφ1 * dφ1);
        result[1] = T::from_f64(1.0);
        result[2] = dddφ1_dφ1;
        result[3] = dddφ1_ddφ1;
    }
    /// The model's outputs.
    #[inline(always)]
    pub fn outputs<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 3],
    ) {
        let φ1 = x[0];
        let dφ1 = x[1];
        let turn_coupler = d[0];
        let turn_rocker = d[1];
        // ── configuration ──
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let l1_sin_φ1 = p.l1 * sin_φ1;
        let Y = -l1_sin_φ1;
        // vector that is left to close crank–coupler–rocker
        let X = p.l4 - p.l1 * cos_φ1;
        // its length squared
        let D = X * X + Y * Y;
        let per_D = D.recip();
        let κ = per_D * (p.constant1 + D) * 0.5;
        let Y_κ = Y * κ;
        let t1 = per_D
            * (-((D - p.l2_minus_l3_squared) * (D - p.l2_plus_l3_squared))).sqrt();
        let η = p.half_ε * t1;
        let X_η = X * η;
        let s2 = p.per_l2 * (Y_κ + X_η);
        let X_κ = X * κ;
        let Y_η = Y * η;
        let c2 = p.per_l2 * (X_κ - Y_η);
        let t2 = (p.c2_0 * s2 - p.s2_0 * c2).atan2(p.c2_0 * c2 + p.s2_0 * s2);
        // angle of `coupler` from the assembled one
        let φ2_minus_φ2_0 = t2.unwrap_to(turn_coupler);
        let t3 = T::from_f64(1.3962634015954636) - φ1 + φ2_minus_φ2_0;
        let B_torque = -(p.k * t3);
        let s3 = p.per_l3 * (Y_κ + l1_sin_φ1 + X_η);
        let t4 = p.m1_r1 * sin_φ1 + p.m2 * (l1_sin_φ1 + p.r2 * s2) + p.m3_r3 * s3;
        let t5 = φ1 - 1.3962634015954636;
        let c3 = -(p.per_l3 * (X - X_κ + Y_η));
        let t6 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `rocker` from the assembled one
        let φ3_minus_φ3_0 = t6.unwrap_to(turn_rocker);
        let t7 = φ3_minus_φ3_0 - φ2_minus_φ2_0;
        let t8 = t4 * 9.81 + p.half_k * (t5 * t5) + p.half_k * (t3 * t3)
            + p.half_k * (t7 * t7);
        let sin_φ2_minus_φ3 = s2 * c3 - c2 * s3;
        let per_sin_φ2_minus_φ3 = sin_φ2_minus_φ3.recip();
        let sin_φ1_minus_φ3 = sin_φ1 * c3 - cos_φ1 * s3;
        // rate of the angle of `coupler` per unit rate of `crank`
        let ω2 = -(p.l1_per_l2 * (per_sin_φ2_minus_φ3 * sin_φ1_minus_φ3));
        let sin_φ1_minus_φ2 = sin_φ1 * c2 - cos_φ1 * s2;
        // rate of the angle of `rocker` per unit rate of `crank`
        let ω3 = -(p.l1_per_l3 * (per_sin_φ2_minus_φ3 * sin_φ1_minus_φ2));
        let cos_φ1_minus_φ2 = cos_φ1 * c2 + sin_φ1 * s2;
        // inertia
        let A = p.C0 + p.C1 * (ω2 * ω2) + p.C2 * (ω3 * ω3)
            + p.C3 * (ω2 * cos_φ1_minus_φ2);
        // ── state ──
        let energy_total = t8 + p.half_k * (φ3_minus_φ3_0 * φ3_minus_φ3_0)
            + A * 0.5 * (dφ1 * dφ1);
        result[0] = dφ1;
        result[1] = B_torque;
        result[2] = energy_total;
    }
    /// Kinetic and potential energy in J, dissipated and supplied power in W.
    #[inline(always)]
    pub fn energy<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let φ1 = x[0];
        let dφ1 = x[1];
        let turn_coupler = d[0];
        let turn_rocker = d[1];
        // ── configuration ──
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let l1_sin_φ1 = p.l1 * sin_φ1;
        let Y = -l1_sin_φ1;
        // vector that is left to close crank–coupler–rocker
        let X = p.l4 - p.l1 * cos_φ1;
        // its length squared
        let D = X * X + Y * Y;
        let per_D = D.recip();
        let κ = per_D * (p.constant1 + D) * 0.5;
        let Y_κ = Y * κ;
        let t1 = per_D
            * (-((D - p.l2_minus_l3_squared) * (D - p.l2_plus_l3_squared))).sqrt();
        let η = p.half_ε * t1;
        let X_η = X * η;
        let s2 = p.per_l2 * (Y_κ + X_η);
        let X_κ = X * κ;
        let Y_η = Y * η;
        let c3 = -(p.per_l3 * (X - X_κ + Y_η));
        let c2 = p.per_l2 * (X_κ - Y_η);
        let s3 = p.per_l3 * (Y_κ + l1_sin_φ1 + X_η);
        let sin_φ2_minus_φ3 = s2 * c3 - c2 * s3;
        let per_sin_φ2_minus_φ3 = sin_φ2_minus_φ3.recip();
        let sin_φ1_minus_φ3 = sin_φ1 * c3 - cos_φ1 * s3;
        // rate of the angle of `coupler` per unit rate of `crank`
        let ω2 = -(p.l1_per_l2 * (per_sin_φ2_minus_φ3 * sin_φ1_minus_φ3));
        let sin_φ1_minus_φ2 = sin_φ1 * c2 - cos_φ1 * s2;
        // rate of the angle of `rocker` per unit rate of `crank`
        let ω3 = -(p.l1_per_l3 * (per_sin_φ2_minus_φ3 * sin_φ1_minus_φ2));
        let cos_φ1_minus_φ2 = cos_φ1 * c2 + sin_φ1 * s2;
        // inertia
        let A = p.C0 + p.C1 * (ω2 * ω2) + p.C2 * (ω3 * ω3)
            + p.C3 * (ω2 * cos_φ1_minus_φ2);
        let t2 = p.m1_r1 * sin_φ1 + p.m2 * (l1_sin_φ1 + p.r2 * s2) + p.m3_r3 * s3;
        let t3 = φ1 - 1.3962634015954636;
        let t4 = (p.c2_0 * s2 - p.s2_0 * c2).atan2(p.c2_0 * c2 + p.s2_0 * s2);
        // angle of `coupler` from the assembled one
        let φ2_minus_φ2_0 = t4.unwrap_to(turn_coupler);
        let t5 = T::from_f64(1.3962634015954636) - φ1 + φ2_minus_φ2_0;
        let t6 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `rocker` from the assembled one
        let φ3_minus_φ3_0 = t6.unwrap_to(turn_rocker);
        let t7 = φ3_minus_φ3_0 - φ2_minus_φ2_0;
        let t8 = t2 * 9.81 + p.half_k * (t3 * t3) + p.half_k * (t5 * t5)
            + p.half_k * (t7 * t7);
        result[0] = A * 0.5 * (dφ1 * dφ1);
        result[1] = t8 + p.half_k * (φ3_minus_φ3_0 * φ3_minus_φ3_0);
        result[2] = T::from_f64(0.0);
        result[3] = T::from_f64(0.0);
    }
    /// Event functions: each event happens where its function rises through zero.
    #[inline(always)]
    pub fn events<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 0],
    ) {}
    /// For each loop a number that is positive where it closes and zero at a dead point.
    #[inline(always)]
    pub fn closures<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 1],
    ) {
        let φ1 = x[0];
        let [.., t1] = if p.table_of_φ1.covers(φ1) {
            p.table_of_φ1.polynomials(φ1)
        } else {
            p.table_of_φ1.where_covered(φ1, functions_of_φ1(φ1, d, p))
        };
        result[0] = t1;
    }
    /// The discrete state after an accepted step that ends in `x`; entries that stay are left as they are.
    #[inline(always)]
    pub fn accept<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 2],
    ) {
        let φ1 = x[0];
        let [.., φ2_minus_φ2_0, φ3_minus_φ3_0, _] = if p.table_of_φ1.covers(φ1) {
            p.table_of_φ1.polynomials(φ1)
        } else {
            p.table_of_φ1.where_covered(φ1, functions_of_φ1(φ1, d, p))
        };
        result[0] = φ2_minus_φ2_0;
        result[1] = φ3_minus_φ3_0;
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
        x: &[T; 2],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        x_after: &mut [T; 2],
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
            const NAMES: [&str; 1] = ["crank–coupler–rocker"];
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
        type States<L: Lanes> = [L; 2];
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
        #[inline(always)]
        fn outside_tables_in_lanes<L: Lanes>(lanes: &Prepared<L>, x: &[L]) -> L {
            L::from_f64(-1.0).larger(lanes.table_of_φ1.left_by(x[0]))
        }
    }
    /// Every quantity with a name: params, states, discrete states, inputs, outputs.
    pub static VARIABLES: [Variable; 18] = [
        Variable {
            name: Cow::Borrowed("E"),
            unit: Cow::Borrowed("Pa"),
            meaning: Cow::Borrowed("elastic modulus"),
            causality: Causality::Parameter,
            start: Some(7.2e10),
        },
        Variable {
            name: Cow::Borrowed("b"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("width, out of plane"),
            causality: Causality::Parameter,
            start: Some(0.003),
        },
        Variable {
            name: Cow::Borrowed("e"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("hinge web thickness"),
            causality: Causality::Parameter,
            start: Some(0.0015),
        },
        Variable {
            name: Cow::Borrowed("r"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("hinge radius"),
            causality: Causality::Parameter,
            start: Some(0.001),
        },
        Variable {
            name: Cow::Borrowed("l1"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length of a link"),
            causality: Causality::Parameter,
            start: Some(0.0102),
        },
        Variable {
            name: Cow::Borrowed("l2"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length of a link"),
            causality: Causality::Parameter,
            start: Some(0.0232),
        },
        Variable {
            name: Cow::Borrowed("l3"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length of a link"),
            causality: Causality::Parameter,
            start: Some(0.01),
        },
        Variable {
            name: Cow::Borrowed("l4"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length of a link"),
            causality: Causality::Parameter,
            start: Some(0.025),
        },
        Variable {
            name: Cow::Borrowed("m1"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of a link"),
            causality: Causality::Parameter,
            start: Some(0.0002568),
        },
        Variable {
            name: Cow::Borrowed("m2"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of a link"),
            causality: Causality::Parameter,
            start: Some(0.0005877),
        },
        Variable {
            name: Cow::Borrowed("m3"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of a link"),
            causality: Causality::Parameter,
            start: Some(0.0002529),
        },
        Variable {
            name: Cow::Borrowed("crank.angle"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("angle of `crank`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("crank.rate"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed("angular rate of `crank`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("coupler.turn"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed(
                "angle of `coupler` from the assembled one at the last accepted step",
            ),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("rocker.turn"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed(
                "angle of `rocker` from the assembled one at the last accepted step",
            ),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("rate"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed("rate of the crank"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("torque"),
            unit: Cow::Borrowed("N*m"),
            meaning: Cow::Borrowed("torque of the hinge between crank and coupler"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("energy_total"),
            unit: Cow::Borrowed("J"),
            meaning: Cow::Borrowed("kinetic and potential energy: constant"),
            causality: Causality::Output,
            start: None,
        },
    ];
    static PARAMS: &[Variable] = VARIABLES.split_at(0).1.split_at(11).0;
    static STATES: &[Variable] = VARIABLES.split_at(11).1.split_at(2).0;
    static DISCRETES: &[Variable] = VARIABLES.split_at(13).1.split_at(2).0;
    static INPUTS: &[Variable] = VARIABLES.split_at(15).1.split_at(0).0;
    static OUTPUTS: &[Variable] = VARIABLES.split_at(15).1.split_at(3).0;
    /// Positions of the coordinates and of their rates among the states.
    static COORDINATES: [(usize, usize); 1] = [(0, 1)];
    static TURNING: [usize; 2] = [0, 1];
    static FAILURES: [Failure; 16] = [
        Failure {
            message: Cow::Borrowed("the elastic modulus of a circular hinge is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("four_bar.flex"),
                line: 14,
                column: 12,
                width: 14,
                excerpt: Cow::Borrowed(
                    "let   k  = circular_hinge(E, width = b, web = e, radius = r, formula = thin_web)  \"stiffness of a hinge\"",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("Pa")]),
        },
        Failure {
            message: Cow::Borrowed("the width of a circular hinge is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("four_bar.flex"),
                line: 14,
                column: 12,
                width: 14,
                excerpt: Cow::Borrowed(
                    "let   k  = circular_hinge(E, width = b, web = e, radius = r, formula = thin_web)  \"stiffness of a hinge\"",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("m")]),
        },
        Failure {
            message: Cow::Borrowed("the web thickness of a circular hinge is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("four_bar.flex"),
                line: 14,
                column: 12,
                width: 14,
                excerpt: Cow::Borrowed(
                    "let   k  = circular_hinge(E, width = b, web = e, radius = r, formula = thin_web)  \"stiffness of a hinge\"",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("m")]),
        },
        Failure {
            message: Cow::Borrowed("the radius of a circular hinge is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("four_bar.flex"),
                line: 14,
                column: 12,
                width: 14,
                excerpt: Cow::Borrowed(
                    "let   k  = circular_hinge(E, width = b, web = e, radius = r, formula = thin_web)  \"stiffness of a hinge\"",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("m")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `crank` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("four_bar.flex"),
                line: 19,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link crank   from O1 to B { length = l1, angle = 80 deg exact, mass = m1, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `crank` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("four_bar.flex"),
                line: 19,
                column: 64,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link crank   from O1 to B { length = l1, angle = 80 deg exact, mass = m1, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `crank` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("four_bar.flex"),
                line: 19,
                column: 64,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link crank   from O1 to B { length = l1, angle = 80 deg exact, mass = m1, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `coupler` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("four_bar.flex"),
                line: 20,
                column: 6,
                width: 7,
                excerpt: Cow::Borrowed(
                    "link coupler from B  to D { length = l2, angle =  0 deg,       mass = m2, symbol = φ2 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `coupler` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("four_bar.flex"),
                line: 20,
                column: 64,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link coupler from B  to D { length = l2, angle =  0 deg,       mass = m2, symbol = φ2 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `coupler` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("four_bar.flex"),
                line: 20,
                column: 64,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link coupler from B  to D { length = l2, angle =  0 deg,       mass = m2, symbol = φ2 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `rocker` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("four_bar.flex"),
                line: 21,
                column: 6,
                width: 6,
                excerpt: Cow::Borrowed(
                    "link rocker  from O2 to D { length = l3, angle = 90 deg,       mass = m3, symbol = φ3 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `rocker` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("four_bar.flex"),
                line: 21,
                column: 64,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link rocker  from O2 to D { length = l3, angle = 90 deg,       mass = m3, symbol = φ3 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `rocker` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("four_bar.flex"),
                line: 21,
                column: 64,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link rocker  from O2 to D { length = l3, angle = 90 deg,       mass = m3, symbol = φ3 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed(
                "the loop crank–coupler–rocker cannot close: at `crank` angle {3} the gap is {0}",
            ),
            hint: Some(
                Cow::Borrowed(
                    "`coupler` would need to be {1} to {2} long between its joints, or another link another length or angle",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("four_bar.flex"),
                line: 20,
                column: 6,
                width: 7,
                excerpt: Cow::Borrowed(
                    "link coupler from B  to D { length = l2, angle =  0 deg,       mass = m2, symbol = φ2 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Metre, Unit::Metre, Unit::Degree]),
        },
        Failure {
            message: Cow::Borrowed(
                "the loop crank–coupler–rocker stands at a dead point: at `crank` angle {3} the joints of `coupler` and `rocker` lie in one line",
            ),
            hint: Some(
                Cow::Borrowed(
                    "assemble it in another configuration: change an angle or a length; or ask for the coordinate `coupler.angle`, if that leads it through",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("four_bar.flex"),
                line: 20,
                column: 6,
                width: 7,
                excerpt: Cow::Borrowed(
                    "link coupler from B  to D { length = l2, angle =  0 deg,       mass = m2, symbol = φ2 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Metre, Unit::Metre, Unit::Degree]),
        },
        Failure {
            message: Cow::Borrowed("`crank` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("four_bar.flex"),
                line: 19,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link crank   from O1 to B { length = l1, angle = 80 deg exact, mass = m1, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
    ];
    /// The equations of motion in plain text.
    pub const EQUATIONS: &str = r#"four_bar
════════

The flexure mechanism of the double-rocker actuator alone: a four-bar of slender bars with
flexure hinges, released with the crank turning.

A check case: its energy is constant, and its motion is known to ten digits from an independent
integration in absolute coordinates.

Loop crank–coupler–rocker
─────────────────────────

  l1 e^(i φ1) + l2 e^(i φ2) - l3 e^(i φ3) - l4 = 0

  X  = l4 - l1 cos(φ1)
  Y  = -l1 sin(φ1)
  D  = X² + Y²
  κ  = (l2² - l3² + D) / (2 D)
  η  = ε sqrt((D - (l2 - l3)²) ((l2 + l3)² - D)) / (2 D)
  c2 = (X κ - Y η) / l2
  s2 = (Y κ + X η) / l2
  c3 = -(X - X κ + Y η) / l3
  s3 = (Y κ - Y + X η) / l3

  φ2 = atan2(s2, c2), φ3 = atan2(s3, c3), continuous over many turns; ⁰: as assembled
  ω2 = dφ2/dφ1, ω3 = dφ3/dφ1, ' = d/dφ1

  ω2  = l1 sin(φ3 - φ1) / (l2 sin(φ2 - φ3))
  ω3  = l1 sin(φ2 - φ1) / (l3 sin(φ2 - φ3))
  ω2' = (l1 (ω3 - 1) cos(φ1 - φ3) + l2 ω2 (ω3 - ω2) cos(φ2 - φ3)) / (l2 sin(φ2 - φ3))
  ω3' = (l1 (ω2 - 1) cos(φ1 - φ2) + l3 ω3 (ω3 - ω2) cos(φ2 - φ3)) / (l3 sin(φ2 - φ3))

Constants of the inertia
────────────────────────

  C0 = I1 + m1 r1² + m2 l1²
  C1 = I2 + m2 r2²
  C2 = I3 + m3 r3²
  C3 = 2 l1 m2 r2

Equation of motion of `crank`
─────────────────────────────

Inertia:

  A(φ1)  = C0 + C1 ω2² + C2 ω3² + C3 ω2 cos(φ1 - φ2)
  ∂A/∂φ1 = 2 C1 ω2 ω2' + 2 C2 ω3 ω3' + C3 ω2' cos(φ1 - φ2) + C3 ω2 (ω2 - 1) sin(φ1 - φ2)

Potential energy:

  ∂P_s/∂φ1 = k (φ1 - φ1⁰)
           + k (ω2 - 1) (φ2 - φ2⁰ - φ1 + φ1⁰)
           + k (ω2 - ω3) (φ2 - φ2⁰ - (φ3 - φ3⁰))
           + k ω3 (φ3 - φ3⁰)
  ∂P_g/∂φ1 = g (m1 r1 cos(φ1) + m2 (l1 cos(φ1) + r2 ω2 cos(φ2)) + m3 r3 ω3 cos(φ3))
  ∂P/∂φ1   = ∂P_s/∂φ1 + ∂P_g/∂φ1

Balance:

  A(φ1) φ̈1 + ½ ∂A/∂φ1 φ̇1² + ∂P/∂φ1 = 0

Constants
─────────

  k   = 2 E b e^(5/2) / (9 π sqrt(r))
        stiffness of a hinge
  r1  = ½ l1                  distance of the centre of mass from the first end of crank
  I1  = 1/12 m1 l1²           moment of inertia about the centre of mass of crank
  r2  = ½ l2                  distance of the centre of mass from the first end of coupler
  I2  = 1/12 m2 l2²           moment of inertia about the centre of mass of coupler
  r3  = ½ l3                  distance of the centre of mass from the first end of rocker
  I3  = 1/12 m3 l3²           moment of inertia about the centre of mass of rocker
  φ1⁰ = 4/9 π                 angle of `crank` as assembled
  ε   = sign(X⁰/l3 - Y⁰/l2)   which way the loop closes: as drawn
  g   = 9.81                  acceleration of gravity

  φ2⁰, φ3⁰, X⁰, Y⁰: by the formulas of the loops, at φ1 = φ1⁰
"#;
    /// The equations of motion as a LaTeX document.
    pub const EQUATIONS_LATEX: &str = r#"\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\begin{document}

\section*{four\_bar}
The flexure mechanism of the double-rocker actuator alone: a four-bar of slender bars with
flexure hinges, released with the crank turning.

A check case: its energy is constant, and its motion is known to ten digits from an independent
integration in absolute coordinates.

\subsection*{Loop crank–coupler–rocker}
\begin{align*}
& l_{1}\, e^{i \varphi_{1}} + l_{2}\, e^{i \varphi_{2}} - l_{3}\, e^{i \varphi_{3}} - l_{4} = 0 \\
X &= l_{4} - l_{1} \cos \varphi_{1} \\
Y &= -l_{1} \sin \varphi_{1} \\
D &= X^{2} + Y^{2} \\
\kappa &= \frac{l_{2}^{2} - l_{3}^{2} + D}{2 \, D} \\
\eta &= \frac{\varepsilon}{2 \, D} \, \sqrt{\left(D - \left(l_{2} - l_{3}\right)^{2}\right) \left(\left(l_{2} + l_{3}\right)^{2} - D\right)} \\
\cos \varphi_{2} &= \frac{X \, \kappa - Y \, \eta}{l_{2}} \\
\sin \varphi_{2} &= \frac{Y \, \kappa + X \, \eta}{l_{2}} \\
\cos \varphi_{3} &= -\frac{X - X \, \kappa + Y \, \eta}{l_{3}} \\
\sin \varphi_{3} &= \frac{Y \, \kappa - Y + X \, \eta}{l_{3}} \\
& \varphi_{2} = \operatorname{atan2}(\sin \varphi_{2}, \cos \varphi_{2}),\quad \varphi_{3} = \operatorname{atan2}(\sin \varphi_{3}, \cos \varphi_{3}) \quad\text{(continuous over many turns; ${}^0$: as assembled)} \\
& \omega_{2} = \frac{\mathrm d\varphi_{2}}{\mathrm d\varphi_{1}},\quad \omega_{3} = \frac{\mathrm d\varphi_{3}}{\mathrm d\varphi_{1}},\quad {}' = \frac{\mathrm d}{\mathrm d\varphi_{1}} \\
\omega_{2} &= \frac{l_{1} \sin\left(\varphi_{3} - \varphi_{1}\right)}{l_{2} \sin\left(\varphi_{2} - \varphi_{3}\right)} \\
\omega_{3} &= \frac{l_{1} \sin\left(\varphi_{2} - \varphi_{1}\right)}{l_{3} \sin\left(\varphi_{2} - \varphi_{3}\right)} \\
\omega'_{2} &= \frac{l_{1} \left(\omega_{3} - 1\right) \cos\left(\varphi_{1} - \varphi_{3}\right) + l_{2} \, \omega_{2} \left(\omega_{3} - \omega_{2}\right) \cos\left(\varphi_{2} - \varphi_{3}\right)}{l_{2} \sin\left(\varphi_{2} - \varphi_{3}\right)} \\
\omega'_{3} &= \frac{l_{1} \left(\omega_{2} - 1\right) \cos\left(\varphi_{1} - \varphi_{2}\right) + l_{3} \, \omega_{3} \left(\omega_{3} - \omega_{2}\right) \cos\left(\varphi_{2} - \varphi_{3}\right)}{l_{3} \sin\left(\varphi_{2} - \varphi_{3}\right)}
\end{align*}

\subsection*{Constants of the inertia}
\begin{align*}
C_{0} &= I_{1} + m_{1} \, r_{1}^{2} + m_{2} \, l_{1}^{2} \\
C_{1} &= I_{2} + m_{2} \, r_{2}^{2} \\
C_{2} &= I_{3} + m_{3} \, r_{3}^{2} \\
C_{3} &= 2 \, l_{1} \, m_{2} \, r_{2}
\end{align*}

\subsection*{Equation of motion of \texttt{crank}}
Inertia:
\begin{align*}
A(\varphi_{1}) &= C_{0} + C_{1} \, \omega_{2}^{2} + C_{2} \, \omega_{3}^{2} + C_{3} \, \omega_{2} \cos\left(\varphi_{1} - \varphi_{2}\right) \\
\frac{\partial A}{\partial \varphi_{1}} &= 2 \, C_{1} \, \omega_{2} \, \omega'_{2} \\
&\quad {}+ 2 \, C_{2} \, \omega_{3} \, \omega'_{3} \\
&\quad {}+ C_{3} \, \omega'_{2} \cos\left(\varphi_{1} - \varphi_{2}\right) \\
&\quad {}+ C_{3} \, \omega_{2} \left(\omega_{2} - 1\right) \sin\left(\varphi_{1} - \varphi_{2}\right)
\end{align*}
Potential energy:
\begin{align*}
\frac{\partial P_s}{\partial \varphi_{1}} &= k \left(\varphi_{1} - \varphi_{1}^0\right) \\
&\quad {}+ k \left(\omega_{2} - 1\right) \left(\varphi_{2} - \varphi_{2}^0 - \varphi_{1} + \varphi_{1}^0\right) \\
&\quad {}+ k \left(\omega_{2} - \omega_{3}\right) \left(\varphi_{2} - \varphi_{2}^0 - \left(\varphi_{3} - \varphi_{3}^0\right)\right) \\
&\quad {}+ k \, \omega_{3} \left(\varphi_{3} - \varphi_{3}^0\right) \\
\frac{\partial P_g}{\partial \varphi_{1}} &= g \left(m_{1} \, r_{1} \cos \varphi_{1} + m_{2} \left(l_{1} \cos \varphi_{1} + r_{2} \, \omega_{2} \cos \varphi_{2}\right) + m_{3} \, r_{3} \, \omega_{3} \cos \varphi_{3}\right) \\
\frac{\partial P}{\partial \varphi_{1}} &= \frac{\partial P_s}{\partial \varphi_{1}} + \frac{\partial P_g}{\partial \varphi_{1}}
\end{align*}
Balance:
\begin{align*}
& A(\varphi_{1})\,\ddot{\varphi}_{1} + \tfrac12 \frac{\partial A}{\partial \varphi_{1}}\,\dot{\varphi}_{1}^2 + \frac{\partial P}{\partial \varphi_{1}} = 0
\end{align*}

\subsection*{Constants}
\begin{align*}
k &= \frac{2 \, E \, b \, e^{5/2}}{9 \, \pi \, \sqrt{r}} && \text{stiffness of a hinge} \\
r_{1} &= \frac{1}{2} \, l_{1} && \text{distance of the centre of mass from the first end of crank} \\
I_{1} &= \frac{1}{12} \, m_{1} \, l_{1}^{2} && \text{moment of inertia about the centre of mass of crank} \\
r_{2} &= \frac{1}{2} \, l_{2} && \text{distance of the centre of mass from the first end of coupler} \\
I_{2} &= \frac{1}{12} \, m_{2} \, l_{2}^{2} && \text{moment of inertia about the centre of mass of coupler} \\
r_{3} &= \frac{1}{2} \, l_{3} && \text{distance of the centre of mass from the first end of rocker} \\
I_{3} &= \frac{1}{12} \, m_{3} \, l_{3}^{2} && \text{moment of inertia about the centre of mass of rocker} \\
\varphi_{1}^0 &= \frac{4}{9} \, \pi && \text{angle of \texttt{crank} as assembled} \\
\varepsilon &= \operatorname{sgn}\left(\frac{{X}^0}{l_{3}} - \frac{{Y}^0}{l_{2}}\right) && \text{which way the loop closes: as drawn} \\
g &= 9.81 && \text{acceleration of gravity} \\
& \varphi_{2}^0,\, \varphi_{3}^0,\, {X}^0,\, {Y}^0: \text{ by the formulas of the loops, at } \varphi_{1} = \varphi_{1}^0
\end{align*}

\end{document}
"#;
}
