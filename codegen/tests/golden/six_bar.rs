/// Simulator of the model `six_bar`, generated from its equations of motion.
///
/// A six-bar flexure linkage (Stephenson III): a four-bar whose coupler moves a rocker on a third
/// pivot through a further link.
#[allow(
    non_snake_case,
    non_upper_case_globals,
    unused,
    clippy::all,
    clippy::pedantic,
    rustdoc::all
)]
pub mod six_bar {
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
        /// crank, coupler, rocker in m; 0.012 by default
        pub l1: f64,
        /// crank, coupler, rocker in m; 0.03 by default
        pub l2: f64,
        /// crank, coupler, rocker in m; 0.022 by default
        pub l3: f64,
        /// C on the coupler in m; 0.014 by default
        pub cx: f64,
        /// C on the coupler in m; 0.011 by default
        pub cy: f64,
        /// connecting link, output rocker in m; 0.021 by default
        pub l5: f64,
        /// connecting link, output rocker in m; 0.017 by default
        pub l6: f64,
        /// second and third pivot in m; 0.032 by default
        pub x2: f64,
        /// second and third pivot in m; -0.003 by default
        pub y2: f64,
        /// second and third pivot in m; 0.038 by default
        pub x3: f64,
        /// second and third pivot in m; 0.022 by default
        pub y3: f64,
        /// masses of the links in kg; 0.0008 by default
        pub m1: f64,
        /// masses of the links in kg; 0.0026 by default
        pub m2: f64,
        /// masses of the links in kg; 0.0015 by default
        pub m3: f64,
        /// masses of the links in kg; 0.0014 by default
        pub m5: f64,
        /// masses of the links in kg; 0.0011 by default
        pub m6: f64,
        /// stiffness of a hinge in N\*m; 1.2 by default
        pub k: f64,
        /// damping of a hinge in N\*m\*s; 2e-6 by default
        pub c: f64,
        /// drive of the crank in N\*m; 0.25 by default
        pub torque: f64,
        /// drive of the crank in 1/s; 60.0 by default
        pub f: f64,
    }
    impl Default for Params {
        fn default() -> Self {
            Self {
                l1: 0.012,
                l2: 0.03,
                l3: 0.022,
                cx: 0.014,
                cy: 0.011,
                l5: 0.021,
                l6: 0.017,
                x2: 0.032,
                y2: -0.003,
                x3: 0.038,
                y3: 0.022,
                m1: 0.0008,
                m2: 0.0026,
                m3: 0.0015,
                m5: 0.0014,
                m6: 0.0011,
                k: 1.2,
                c: 2e-6,
                torque: 0.25,
                f: 60.0,
            }
        }
    }
    impl Params {
        /// The values in the order of [`VARIABLES`].
        pub fn values(&self) -> [f64; 20] {
            [
                self.l1,
                self.l2,
                self.l3,
                self.cx,
                self.cy,
                self.l5,
                self.l6,
                self.x2,
                self.y2,
                self.x3,
                self.y3,
                self.m1,
                self.m2,
                self.m3,
                self.m5,
                self.m6,
                self.k,
                self.c,
                self.torque,
                self.f,
            ]
        }
        /// Params of values in the order of [`VARIABLES`].
        pub fn from_values(values: [f64; 20]) -> Self {
            Self {
                l1: values[0],
                l2: values[1],
                l3: values[2],
                cx: values[3],
                cy: values[4],
                l5: values[5],
                l6: values[6],
                x2: values[7],
                y2: values[8],
                x3: values[9],
                y3: values[10],
                m1: values[11],
                m2: values[12],
                m3: values[13],
                m5: values[14],
                m6: values[15],
                k: values[16],
                c: values[17],
                torque: values[18],
                f: values[19],
            }
        }
        /// Closes the loops and computes everything that depends on params alone.
        ///
        /// # Errors
        /// What is wrong with the parameter set, in the words of `flexure check`.
        pub fn prepare(&self) -> Result<Prepared<f64>, Diagnostic> {
            check_params(PARAMS, &self.values())?;
            let l1 = self.l1;
            let l2 = self.l2;
            let l3 = self.l3;
            let cx = self.cx;
            let cy = self.cy;
            let l5 = self.l5;
            let l6 = self.l6;
            let x2 = self.x2;
            let y2 = self.y2;
            let x3 = self.x3;
            let y3 = self.y3;
            let m1 = self.m1;
            let m2 = self.m2;
            let m3 = self.m3;
            let m5 = self.m5;
            let m6 = self.m6;
            let k = self.k;
            let c = self.c;
            let torque = self.torque;
            let f = self.f;
            let l1_squared = l1 * l1;
            // moment of inertia about the centre of mass of crank
            let I1 = l1_squared * m1 * 0.08333333333333333;
            let l2_squared = l2 * l2;
            let l2_squared_m2 = l2_squared * m2;
            // moment of inertia about the centre of mass of coupler
            let I2 = l2_squared_m2 * 0.08333333333333333;
            let l3_squared = l3 * l3;
            // moment of inertia about the centre of mass of rocker
            let I3 = l3_squared * m3 * 0.08333333333333333;
            let l5_squared = l5 * l5;
            // moment of inertia about the centre of mass of connector
            let I5 = l5_squared * m5 * 0.08333333333333333;
            let l6_squared = l6 * l6;
            // moment of inertia about the centre of mass of output_rocker
            let I6 = l6_squared * m6 * 0.08333333333333333;
            let l2_minus_l3 = l2 - l3;
            let l2_minus_l3_squared = l2_minus_l3 * l2_minus_l3;
            let t1 = l1 * 0.3420201433256688;
            let X1_0 = x2 - t1;
            let t2 = l1 * 0.9396926207859083;
            let Y1_0 = y2 - t2;
            let D1_0 = X1_0 * X1_0 + Y1_0 * Y1_0;
            let l2_plus_l3 = l2 + l3;
            let l2_plus_l3_squared = l2_plus_l3 * l2_plus_l3;
            let t3 = (l2_minus_l3_squared - D1_0) * (l2_plus_l3_squared - D1_0);
            let l2_squared_l3_squared = l2_squared * l3_squared;
            let t4 = t3 * 0.25 / l2_squared_l3_squared;
            let l5_minus_l6 = l5 - l6;
            let l5_minus_l6_squared = l5_minus_l6 * l5_minus_l6;
            let t5 = l2_squared - l3_squared;
            let κ1_0 = (t5 + D1_0) * 0.5 / D1_0;
            let Y1_0_κ1_0 = Y1_0 * κ1_0;
            let t6 = (X1_0 * 0.25881904510252074 - Y1_0 * 0.9659258262890683) / l2
                + (X1_0 * 0.9986295347545738 - Y1_0 * 0.052335956242943966) / l3;
            // which way the loop closes: as drawn
            let ε1 = t6.if_positive(1.0, -1.0);
            let η1_0 = ε1 * (-t3).sqrt() * 0.5 / D1_0;
            let X1_0_η1_0 = X1_0 * η1_0;
            let s2_0 = (Y1_0_κ1_0 + X1_0_η1_0) / l2;
            let X1_0_κ1_0 = X1_0 * κ1_0;
            let Y1_0_η1_0 = Y1_0 * η1_0;
            let c2_0 = (X1_0_κ1_0 - Y1_0_η1_0) / l2;
            // angle of `coupler` as assembled
            let φ2_0 = Real::atan2(s2_0, c2_0).unwrap_to(0.2617993877991494);
            let (sin_φ2_0, cos_φ2_0) = Real::sin_cos(φ2_0);
            let X2_0 = x3 - t1 + cy * sin_φ2_0 - cx * cos_φ2_0;
            let Y2_0 = y3 - t2 - cx * sin_φ2_0 - cy * cos_φ2_0;
            let D2_0 = X2_0 * X2_0 + Y2_0 * Y2_0;
            let l5_plus_l6 = l5 + l6;
            let l5_plus_l6_squared = l5_plus_l6 * l5_plus_l6;
            let t7 = (l5_minus_l6_squared - D2_0) * (l5_plus_l6_squared - D2_0);
            let l5_squared_l6_squared = l5_squared * l6_squared;
            let t8 = t7 * 0.25 / l5_squared_l6_squared;
            // distance of the centre of mass from the first end of crank
            let r1 = l1 * 0.5;
            // constant of the inertia
            let C0 = I1 + m1 * (r1 * r1) + l1_squared * m2;
            // constant of the inertia
            let C1 = l2_squared_m2 * 0.25 + I2 + cy * cy * m2 * 0.1111111111111111;
            let s3_0 = (Y1_0_κ1_0 - Y1_0 + X1_0_η1_0) / l3;
            let c3_0 = -((X1_0 - X1_0_κ1_0 + Y1_0_η1_0) / l3);
            // angle of `rocker` as assembled
            let φ3_0 = Real::atan2(s3_0, c3_0).unwrap_to(1.5184364492350666);
            let sin_φ2_0_minus_φ3_0 = Real::sin(φ2_0 - φ3_0);
            let t9 = l1 * Real::sin(1.2217304763960306 - φ3_0)
                / (l2 * sin_φ2_0_minus_φ3_0);
            // rate as assembled
            let ω2_0 = -t9;
            // distance of the centre of mass from the first end of rocker
            let r3 = l3 * 0.5;
            // constant of the inertia
            let C2 = I3 + m3 * (r3 * r3);
            let t10 = 1.2217304763960306 - φ2_0;
            let (t11, t12) = Real::sin_cos(t10);
            // rate as assembled
            let ω3_0 = -(l1 * t11 / (l3 * sin_φ2_0_minus_φ3_0));
            // distance of the centre of mass from the first end of connector
            let r5 = l5 * 0.5;
            let r5_minus_l5 = r5 - l5;
            // constant of the inertia
            let C3 = I5 + m5 * (r5_minus_l5 * r5_minus_l5);
            let t13 = l5_squared - l6_squared;
            let κ2_0 = (t13 + D2_0) * 0.5 / D2_0;
            let Y2_0_κ2_0 = Y2_0 * κ2_0;
            let t14 = (X2_0 * 0.5877852522924731 - Y2_0 * 0.8090169943749475) / l5
                + (X2_0 * 0.9335804264972017 + Y2_0 * 0.35836794954530027) / l6;
            // which way the loop closes: as drawn
            let ε2 = t14.if_positive(1.0, -1.0);
            let η2_0 = ε2 * (-t7).sqrt() * 0.5 / D2_0;
            let X2_0_η2_0 = X2_0 * η2_0;
            let s6_0 = (Y2_0_κ2_0 - Y2_0 + X2_0_η2_0) / l6;
            let X2_0_κ2_0 = X2_0 * κ2_0;
            let Y2_0_η2_0 = Y2_0 * η2_0;
            let c6_0 = -((X2_0 - X2_0_κ2_0 + Y2_0_η2_0) / l6);
            // angle of `output_rocker` as assembled
            let φ6_0 = Real::atan2(s6_0, c6_0).unwrap_to(1.9373154697137058);
            let cx_ω2_0 = cx * ω2_0;
            let φ2_0_minus_φ6_0 = φ2_0 - φ6_0;
            let (sin_φ2_0_minus_φ6_0, cos_φ2_0_minus_φ6_0) = Real::sin_cos(
                φ2_0_minus_φ6_0,
            );
            let t15 = l1 * Real::sin(1.2217304763960306 - φ6_0)
                + cx_ω2_0 * sin_φ2_0_minus_φ6_0;
            let cy_ω2_0 = cy * ω2_0;
            let s5_0 = (Y2_0_κ2_0 + X2_0_η2_0) / l5;
            let c5_0 = (X2_0_κ2_0 - Y2_0_η2_0) / l5;
            // angle of `connector` as assembled
            let φ5_0 = Real::atan2(s5_0, c5_0).unwrap_to(0.6283185307179586);
            let φ5_0_minus_φ6_0 = φ5_0 - φ6_0;
            let (sin_φ5_0_minus_φ6_0, cos_φ5_0_minus_φ6_0) = Real::sin_cos(
                φ5_0_minus_φ6_0,
            );
            // rate as assembled
            let ω5_0 = -((t15 + cy_ω2_0 * cos_φ2_0_minus_φ6_0)
                / (l5 * sin_φ5_0_minus_φ6_0));
            // distance of the centre of mass from the first end of output_rocker
            let r6 = l6 * 0.5;
            // constant of the inertia
            let C4 = I6 + l6_squared * m5 + m6 * (r6 * r6);
            let φ2_0_minus_φ5_0 = φ2_0 - φ5_0;
            let (sin_φ2_0_minus_φ5_0, cos_φ2_0_minus_φ5_0) = Real::sin_cos(
                φ2_0_minus_φ5_0,
            );
            let t16 = l1 * Real::sin(1.2217304763960306 - φ5_0)
                + cx_ω2_0 * sin_φ2_0_minus_φ5_0;
            // rate as assembled
            let ω6_0 = -((t16 + cy_ω2_0 * cos_φ2_0_minus_φ5_0)
                / (l6 * sin_φ5_0_minus_φ6_0));
            let t17 = C0 + C1 * (ω2_0 * ω2_0) + C2 * (ω3_0 * ω3_0)
                + C3 * (ω5_0 * ω5_0) + C4 * (ω6_0 * ω6_0);
            // constant of the inertia
            let C5 = l1 * l2 * m2;
            // constant of the inertia
            let C6 = l1 * cy * m2 * 0.6666666666666666;
            let l5_minus_r5 = l5 - r5;
            // constant of the inertia
            let C7 = -(l6 * m5 * l5_minus_r5 * 2.0);
            // inertia as assembled
            let A_crank_0 = t17 + C5 * ω2_0 * t12 + C6 * ω2_0 * t11
                + C7 * ω5_0 * ω6_0 * cos_φ5_0_minus_φ6_0;
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
            if !(I2 >= 0.0) {
                return Err(FAILURES[5].diagnostic(&[I2]));
            }
            if !(l3 > 0.0) {
                return Err(FAILURES[6].diagnostic(&[l3]));
            }
            if !(m3 >= 0.0) {
                return Err(FAILURES[7].diagnostic(&[m3]));
            }
            if !(I3 >= 0.0) {
                return Err(FAILURES[8].diagnostic(&[I3]));
            }
            if !(l5 > 0.0) {
                return Err(FAILURES[9].diagnostic(&[l5]));
            }
            if !(m5 >= 0.0) {
                return Err(FAILURES[10].diagnostic(&[m5]));
            }
            if !(I5 >= 0.0) {
                return Err(FAILURES[11].diagnostic(&[I5]));
            }
            if !(l6 > 0.0) {
                return Err(FAILURES[12].diagnostic(&[l6]));
            }
            if !(m6 >= 0.0) {
                return Err(FAILURES[13].diagnostic(&[m6]));
            }
            if !(I6 >= 0.0) {
                return Err(FAILURES[14].diagnostic(&[I6]));
            }
            if !(-t4 >= 0.0) {
                let sqrt_D1_0 = D1_0.sqrt();
                return Err(
                    FAILURES[15]
                        .diagnostic(
                            &[
                                (sqrt_D1_0 - l2 - l3).larger(l2_minus_l3.abs() - sqrt_D1_0),
                                (l3 - sqrt_D1_0).abs(),
                                l3 + sqrt_D1_0,
                                1.2217304763960306,
                            ],
                        ),
                );
            }
            if !(-(t4 + 1e-12) > 0.0) {
                let sqrt_D1_0_2 = D1_0.sqrt();
                return Err(
                    FAILURES[16]
                        .diagnostic(
                            &[
                                (sqrt_D1_0_2 - l2 - l3)
                                    .larger(l2_minus_l3.abs() - sqrt_D1_0_2),
                                (l3 - sqrt_D1_0_2).abs(),
                                l3 + sqrt_D1_0_2,
                                1.2217304763960306,
                            ],
                        ),
                );
            }
            if !(-t8 >= 0.0) {
                let sqrt_D2_0 = D2_0.sqrt();
                return Err(
                    FAILURES[17]
                        .diagnostic(
                            &[
                                (sqrt_D2_0 - l5 - l6).larger(l5_minus_l6.abs() - sqrt_D2_0),
                                (l6 - sqrt_D2_0).abs(),
                                l6 + sqrt_D2_0,
                                1.2217304763960306,
                            ],
                        ),
                );
            }
            if !(-(t8 + 1e-12) > 0.0) {
                let sqrt_D2_0_2 = D2_0.sqrt();
                return Err(
                    FAILURES[18]
                        .diagnostic(
                            &[
                                (sqrt_D2_0_2 - l5 - l6)
                                    .larger(l5_minus_l6.abs() - sqrt_D2_0_2),
                                (l6 - sqrt_D2_0_2).abs(),
                                l6 + sqrt_D2_0_2,
                                1.2217304763960306,
                            ],
                        ),
                );
            }
            if !(A_crank_0 > 0.0) {
                return Err(FAILURES[19].diagnostic(&[]));
            }
            let mut prepared = Prepared {
                start_states: [1.2217304763960306, 0.0],
                start_discretes: [0.0, 0.0, 0.0, 0.0],
                l1,
                l2,
                l3,
                cx,
                cy,
                l5,
                l6,
                x2,
                y2,
                x3,
                y3,
                m2,
                m3,
                m5,
                m6,
                k,
                c,
                torque,
                C0,
                constant1: t5,
                l2_minus_l3_squared,
                l2_plus_l3_squared,
                half_ε1: ε1 * 0.5,
                per_l2: l2.recip(),
                per_l3: l3.recip(),
                l1_per_l2: l1 / l2,
                C1,
                l1_per_l3: l1 / l3,
                r3,
                C2,
                constant2: t13,
                l5_minus_l6_squared,
                l5_plus_l6_squared,
                s2_0,
                c2_0,
                half_ε2: ε2 * 0.5,
                per_l5: l5.recip(),
                per_l6: l6.recip(),
                C3,
                r6,
                C4,
                C5,
                C6,
                l5_minus_r5,
                C7,
                c3_0,
                s3_0,
                c5_0,
                s5_0,
                c6_0,
                s6_0,
                half_l2: l2 * 0.5,
                constant3: cy * 0.3333333333333333,
                m1_r1: m1 * r1,
                m3_r3: m3 * r3,
                m6_r6: m6 * r6,
                constant4: f * 6.283185307179586,
                two_C1: C1 * 2.0,
                two_C2: C2 * 2.0,
                two_C3: C3 * 2.0,
                two_C4: C4 * 2.0,
                two_c: c * 2.0,
                two_cx: cx * 2.0,
                two_cy: cy * 2.0,
                two_C5: C5 * 2.0,
                two_C6: C6 * 2.0,
                two_C7: C7 * 2.0,
                φ6_0,
                half_k: k * 0.5,
                constant5: 0.25 / l2_squared_l3_squared,
                constant6: 0.25 / l5_squared_l6_squared,
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
        pub start_states: [T; 2],
        /// Discrete state at the start.
        pub start_discretes: [T; 4],
        /// `l1`
        pub l1: T,
        /// `l2`
        pub l2: T,
        /// `l3`
        pub l3: T,
        /// `cx`
        pub cx: T,
        /// `cy`
        pub cy: T,
        /// `l5`
        pub l5: T,
        /// `l6`
        pub l6: T,
        /// `x2`
        pub x2: T,
        /// `y2`
        pub y2: T,
        /// `x3`
        pub x3: T,
        /// `y3`
        pub y3: T,
        /// `m2`
        pub m2: T,
        /// `m3`
        pub m3: T,
        /// `m5`
        pub m5: T,
        /// `m6`
        pub m6: T,
        /// `k`
        pub k: T,
        /// `c`
        pub c: T,
        /// `torque`
        pub torque: T,
        /// `C0` constant of the inertia
        pub C0: T,
        /// `l2 * l2 - l3 * l3`
        pub constant1: T,
        /// `(l2 - l3) * (l2 - l3)`
        pub l2_minus_l3_squared: T,
        /// `(l2 + l3) * (l2 + l3)`
        pub l2_plus_l3_squared: T,
        /// `0.5 * ε1`
        pub half_ε1: T,
        /// `1.0 / l2`
        pub per_l2: T,
        /// `1.0 / l3`
        pub per_l3: T,
        /// `l1 / l2`
        pub l1_per_l2: T,
        /// `C1` constant of the inertia
        pub C1: T,
        /// `l1 / l3`
        pub l1_per_l3: T,
        /// `r3` distance of the centre of mass from the first end of rocker
        pub r3: T,
        /// `C2` constant of the inertia
        pub C2: T,
        /// `l5 * l5 - l6 * l6`
        pub constant2: T,
        /// `(l5 - l6) * (l5 - l6)`
        pub l5_minus_l6_squared: T,
        /// `(l5 + l6) * (l5 + l6)`
        pub l5_plus_l6_squared: T,
        /// `s2⁰`
        pub s2_0: T,
        /// `c2⁰`
        pub c2_0: T,
        /// `0.5 * ε2`
        pub half_ε2: T,
        /// `1.0 / l5`
        pub per_l5: T,
        /// `1.0 / l6`
        pub per_l6: T,
        /// `C3` constant of the inertia
        pub C3: T,
        /// `r6` distance of the centre of mass from the first end of output_rocker
        pub r6: T,
        /// `C4` constant of the inertia
        pub C4: T,
        /// `C5` constant of the inertia
        pub C5: T,
        /// `C6` constant of the inertia
        pub C6: T,
        /// `l5 - r5`
        pub l5_minus_r5: T,
        /// `C7` constant of the inertia
        pub C7: T,
        /// `c3⁰`
        pub c3_0: T,
        /// `s3⁰`
        pub s3_0: T,
        /// `c5⁰`
        pub c5_0: T,
        /// `s5⁰`
        pub s5_0: T,
        /// `c6⁰`
        pub c6_0: T,
        /// `s6⁰`
        pub s6_0: T,
        /// `0.5 * l2`
        pub half_l2: T,
        /// `0.3333333333333333 * cy`
        pub constant3: T,
        /// `m1 * r1`
        pub m1_r1: T,
        /// `m3 * r3`
        pub m3_r3: T,
        /// `m6 * r6`
        pub m6_r6: T,
        /// `6.283185307179586 * f`
        pub constant4: T,
        /// `2.0 * C1`
        pub two_C1: T,
        /// `2.0 * C2`
        pub two_C2: T,
        /// `2.0 * C3`
        pub two_C3: T,
        /// `2.0 * C4`
        pub two_C4: T,
        /// `2.0 * c`
        pub two_c: T,
        /// `2.0 * cx`
        pub two_cx: T,
        /// `2.0 * cy`
        pub two_cy: T,
        /// `2.0 * C5`
        pub two_C5: T,
        /// `2.0 * C6`
        pub two_C6: T,
        /// `2.0 * C7`
        pub two_C7: T,
        /// `φ6⁰` angle of \`output_rocker\` as assembled
        pub φ6_0: T,
        /// `0.5 * k`
        pub half_k: T,
        /// `0.25 / (l2 * l2 * l3 * l3)`
        pub constant5: T,
        /// `0.25 / (l5 * l5 * l6 * l6)`
        pub constant6: T,
        /// [`functions_of_φ1`] near the start.
        pub table_of_φ1: Table<T, 10>,
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
                cx: turn(self.cx),
                cy: turn(self.cy),
                l5: turn(self.l5),
                l6: turn(self.l6),
                x2: turn(self.x2),
                y2: turn(self.y2),
                x3: turn(self.x3),
                y3: turn(self.y3),
                m2: turn(self.m2),
                m3: turn(self.m3),
                m5: turn(self.m5),
                m6: turn(self.m6),
                k: turn(self.k),
                c: turn(self.c),
                torque: turn(self.torque),
                C0: turn(self.C0),
                constant1: turn(self.constant1),
                l2_minus_l3_squared: turn(self.l2_minus_l3_squared),
                l2_plus_l3_squared: turn(self.l2_plus_l3_squared),
                half_ε1: turn(self.half_ε1),
                per_l2: turn(self.per_l2),
                per_l3: turn(self.per_l3),
                l1_per_l2: turn(self.l1_per_l2),
                C1: turn(self.C1),
                l1_per_l3: turn(self.l1_per_l3),
                r3: turn(self.r3),
                C2: turn(self.C2),
                constant2: turn(self.constant2),
                l5_minus_l6_squared: turn(self.l5_minus_l6_squared),
                l5_plus_l6_squared: turn(self.l5_plus_l6_squared),
                s2_0: turn(self.s2_0),
                c2_0: turn(self.c2_0),
                half_ε2: turn(self.half_ε2),
                per_l5: turn(self.per_l5),
                per_l6: turn(self.per_l6),
                C3: turn(self.C3),
                r6: turn(self.r6),
                C4: turn(self.C4),
                C5: turn(self.C5),
                C6: turn(self.C6),
                l5_minus_r5: turn(self.l5_minus_r5),
                C7: turn(self.C7),
                c3_0: turn(self.c3_0),
                s3_0: turn(self.s3_0),
                c5_0: turn(self.c5_0),
                s5_0: turn(self.s5_0),
                c6_0: turn(self.c6_0),
                s6_0: turn(self.s6_0),
                half_l2: turn(self.half_l2),
                constant3: turn(self.constant3),
                m1_r1: turn(self.m1_r1),
                m3_r3: turn(self.m3_r3),
                m6_r6: turn(self.m6_r6),
                constant4: turn(self.constant4),
                two_C1: turn(self.two_C1),
                two_C2: turn(self.two_C2),
                two_C3: turn(self.two_C3),
                two_C4: turn(self.two_C4),
                two_c: turn(self.two_c),
                two_cx: turn(self.two_cx),
                two_cy: turn(self.two_cy),
                two_C5: turn(self.two_C5),
                two_C6: turn(self.two_C6),
                two_C7: turn(self.two_C7),
                φ6_0: turn(self.φ6_0),
                half_k: turn(self.half_k),
                constant5: turn(self.constant5),
                constant6: turn(self.constant6),
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
                cx: join(self.cx, other.cx),
                cy: join(self.cy, other.cy),
                l5: join(self.l5, other.l5),
                l6: join(self.l6, other.l6),
                x2: join(self.x2, other.x2),
                y2: join(self.y2, other.y2),
                x3: join(self.x3, other.x3),
                y3: join(self.y3, other.y3),
                m2: join(self.m2, other.m2),
                m3: join(self.m3, other.m3),
                m5: join(self.m5, other.m5),
                m6: join(self.m6, other.m6),
                k: join(self.k, other.k),
                c: join(self.c, other.c),
                torque: join(self.torque, other.torque),
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
                half_ε1: join(self.half_ε1, other.half_ε1),
                per_l2: join(self.per_l2, other.per_l2),
                per_l3: join(self.per_l3, other.per_l3),
                l1_per_l2: join(self.l1_per_l2, other.l1_per_l2),
                C1: join(self.C1, other.C1),
                l1_per_l3: join(self.l1_per_l3, other.l1_per_l3),
                r3: join(self.r3, other.r3),
                C2: join(self.C2, other.C2),
                constant2: join(self.constant2, other.constant2),
                l5_minus_l6_squared: join(
                    self.l5_minus_l6_squared,
                    other.l5_minus_l6_squared,
                ),
                l5_plus_l6_squared: join(
                    self.l5_plus_l6_squared,
                    other.l5_plus_l6_squared,
                ),
                s2_0: join(self.s2_0, other.s2_0),
                c2_0: join(self.c2_0, other.c2_0),
                half_ε2: join(self.half_ε2, other.half_ε2),
                per_l5: join(self.per_l5, other.per_l5),
                per_l6: join(self.per_l6, other.per_l6),
                C3: join(self.C3, other.C3),
                r6: join(self.r6, other.r6),
                C4: join(self.C4, other.C4),
                C5: join(self.C5, other.C5),
                C6: join(self.C6, other.C6),
                l5_minus_r5: join(self.l5_minus_r5, other.l5_minus_r5),
                C7: join(self.C7, other.C7),
                c3_0: join(self.c3_0, other.c3_0),
                s3_0: join(self.s3_0, other.s3_0),
                c5_0: join(self.c5_0, other.c5_0),
                s5_0: join(self.s5_0, other.s5_0),
                c6_0: join(self.c6_0, other.c6_0),
                s6_0: join(self.s6_0, other.s6_0),
                half_l2: join(self.half_l2, other.half_l2),
                constant3: join(self.constant3, other.constant3),
                m1_r1: join(self.m1_r1, other.m1_r1),
                m3_r3: join(self.m3_r3, other.m3_r3),
                m6_r6: join(self.m6_r6, other.m6_r6),
                constant4: join(self.constant4, other.constant4),
                two_C1: join(self.two_C1, other.two_C1),
                two_C2: join(self.two_C2, other.two_C2),
                two_C3: join(self.two_C3, other.two_C3),
                two_C4: join(self.two_C4, other.two_C4),
                two_c: join(self.two_c, other.two_c),
                two_cx: join(self.two_cx, other.two_cx),
                two_cy: join(self.two_cy, other.two_cy),
                two_C5: join(self.two_C5, other.two_C5),
                two_C6: join(self.two_C6, other.two_C6),
                two_C7: join(self.two_C7, other.two_C7),
                φ6_0: join(self.φ6_0, other.φ6_0),
                half_k: join(self.half_k, other.half_k),
                constant5: join(self.constant5, other.constant5),
                constant6: join(self.constant6, other.constant6),
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
    pub fn functions_of_φ1<T: Real>(φ1: T, d: &[T; 4], p: &Prepared<T>) -> [T; 10] {
        let turn_coupler = d[0];
        let turn_rocker = d[1];
        let turn_connector = d[2];
        let turn_output_rocker = d[3];
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let l1_sin_φ1 = p.l1 * sin_φ1;
        let Y1 = p.y2 - l1_sin_φ1;
        let l1_cos_φ1 = p.l1 * cos_φ1;
        // vector that is left to close crank–coupler–rocker
        let X1 = p.x2 - l1_cos_φ1;
        // its length squared
        let D1 = X1 * X1 + Y1 * Y1;
        let per_D1 = D1.recip();
        let κ1 = per_D1 * (p.constant1 + D1) * 0.5;
        let Y1_κ1 = Y1 * κ1;
        let t1 = (D1 - p.l2_minus_l3_squared) * (D1 - p.l2_plus_l3_squared);
        let η1 = p.half_ε1 * (per_D1 * (-t1).sqrt());
        let X1_η1 = X1 * η1;
        let s2 = p.per_l2 * (Y1_κ1 + X1_η1);
        let X1_κ1 = X1 * κ1;
        let Y1_η1 = Y1 * η1;
        let t2 = p.per_l3 * (X1 - X1_κ1 + Y1_η1);
        let c3 = -t2;
        let c2 = p.per_l2 * (X1_κ1 - Y1_η1);
        let s3 = p.per_l3 * (Y1_κ1 - Y1 + X1_η1);
        let sin_φ2_minus_φ3 = s2 * c3 - c2 * s3;
        let per_sin_φ2_minus_φ3 = sin_φ2_minus_φ3.recip();
        let sin_φ1_minus_φ3 = sin_φ1 * c3 - cos_φ1 * s3;
        let t3 = p.l1_per_l2 * (per_sin_φ2_minus_φ3 * sin_φ1_minus_φ3);
        // rate of the angle of `coupler` per unit rate of `crank`
        let ω2 = -t3;
        let sin_φ1_c2 = sin_φ1 * c2;
        let cos_φ1_s2 = cos_φ1 * s2;
        let sin_φ1_minus_φ2 = sin_φ1_c2 - cos_φ1_s2;
        let t4 = p.l1_per_l3 * (per_sin_φ2_minus_φ3 * sin_φ1_minus_φ2);
        // rate of the angle of `rocker` per unit rate of `crank`
        let ω3 = -t4;
        let Y2 = p.y3 - l1_sin_φ1 - p.cx * s2 - p.cy * c2;
        // vector that is left to close crank–coupler–connector–output_rocker
        let X2 = p.x3 - l1_cos_φ1 + p.cy * s2 - p.cx * c2;
        // its length squared
        let D2 = X2 * X2 + Y2 * Y2;
        let per_D2 = D2.recip();
        let κ2 = per_D2 * (p.constant2 + D2) * 0.5;
        let Y2_κ2 = Y2 * κ2;
        let t5 = (D2 - p.l5_minus_l6_squared) * (D2 - p.l5_plus_l6_squared);
        let η2 = p.half_ε2 * (per_D2 * (-t5).sqrt());
        let X2_η2 = X2 * η2;
        let s5 = p.per_l5 * (Y2_κ2 + X2_η2);
        let X2_κ2 = X2 * κ2;
        let Y2_η2 = Y2 * η2;
        let t6 = p.per_l6 * (X2 - X2_κ2 + Y2_η2);
        let c6 = -t6;
        let c5 = p.per_l5 * (X2_κ2 - Y2_η2);
        let s6 = p.per_l6 * (Y2_κ2 - Y2 + X2_η2);
        let sin_φ5_minus_φ6 = s5 * c6 - c5 * s6;
        let per_sin_φ5_minus_φ6 = sin_φ5_minus_φ6.recip();
        let sin_φ1_minus_φ6 = sin_φ1 * c6 - cos_φ1 * s6;
        let sin_φ2_minus_φ6 = s2 * c6 - c2 * s6;
        let ω2_sin_φ2_minus_φ6 = ω2 * sin_φ2_minus_φ6;
        let cos_φ2_minus_φ6 = c2 * c6 + s2 * s6;
        let ω2_cos_φ2_minus_φ6 = ω2 * cos_φ2_minus_φ6;
        let t7 = p.l1 * sin_φ1_minus_φ6 + p.cx * ω2_sin_φ2_minus_φ6
            + p.cy * ω2_cos_φ2_minus_φ6;
        let t8 = p.per_l5 * (per_sin_φ5_minus_φ6 * t7);
        // rate of the angle of `connector` per unit rate of `crank`
        let ω5 = -t8;
        let sin_φ1_minus_φ5 = sin_φ1 * c5 - cos_φ1 * s5;
        let sin_φ2_minus_φ5 = s2 * c5 - c2 * s5;
        let ω2_sin_φ2_minus_φ5 = ω2 * sin_φ2_minus_φ5;
        let cos_φ2_minus_φ5 = c2 * c5 + s2 * s5;
        let ω2_cos_φ2_minus_φ5 = ω2 * cos_φ2_minus_φ5;
        let t9 = p.l1 * sin_φ1_minus_φ5 + p.cx * ω2_sin_φ2_minus_φ5
            + p.cy * ω2_cos_φ2_minus_φ5;
        let t10 = per_sin_φ5_minus_φ6 * t9;
        let t11 = p.per_l6 * t10;
        // rate of the angle of `output_rocker` per unit rate of `crank`
        let ω6 = -t11;
        let t12 = p.C0 + p.C1 * (ω2 * ω2) + p.C2 * (ω3 * ω3) + p.C3 * (ω5 * ω5)
            + p.C4 * (ω6 * ω6);
        let cos_φ1_minus_φ2 = cos_φ1 * c2 + sin_φ1 * s2;
        let ω2_cos_φ1_minus_φ2 = ω2 * cos_φ1_minus_φ2;
        let sin_φ1_minus_φ2_ω2 = sin_φ1_minus_φ2 * ω2;
        let cos_φ5_minus_φ6 = c5 * c6 + s5 * s6;
        // inertia
        let A = t12 + p.C5 * ω2_cos_φ1_minus_φ2 + p.C6 * sin_φ1_minus_φ2_ω2
            + p.C7 * (ω5 * ω6 * cos_φ5_minus_φ6);
        let per_A = A.recip();
        let ω2_minus_one = ω2 - 1.0;
        let t13 = (p.c2_0 * s2 - p.s2_0 * c2).atan2(p.c2_0 * c2 + p.s2_0 * s2);
        // angle of `coupler` from the assembled one
        let φ2_minus_φ2_0 = t13.unwrap_to(turn_coupler);
        let t14 = ω2_minus_one
            * (T::from_f64(1.2217304763960306) - φ1 + φ2_minus_φ2_0);
        let t15 = t4 - t3;
        let t16 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `rocker` from the assembled one
        let φ3_minus_φ3_0 = t16.unwrap_to(turn_rocker);
        let t17 = p.k * (φ1 - 1.2217304763960306) + p.k * t14
            + p.k * (t15 * (φ2_minus_φ2_0 - φ3_minus_φ3_0));
        let t18 = t8 - t3;
        let t19 = (p.c5_0 * s5 - p.s5_0 * c5).atan2(p.c5_0 * c5 + p.s5_0 * s5);
        // angle of `connector` from the assembled one
        let φ5_minus_φ5_0 = t19.unwrap_to(turn_connector);
        let t20 = t17 + p.k * (φ3_minus_φ3_0 * ω3)
            + p.k * (t18 * (φ2_minus_φ2_0 - φ5_minus_φ5_0));
        let t21 = t11 - t8;
        let t22 = (p.c6_0 * s6 - p.s6_0 * c6).atan2(p.c6_0 * c6 + p.s6_0 * s6);
        // angle of `output_rocker` from the assembled one
        let φ6_minus_φ6_0 = t22.unwrap_to(turn_output_rocker);
        // slope of the potential energy of springs
        let dP_s_dφ1 = t20 + p.k * (t21 * (φ5_minus_φ5_0 - φ6_minus_φ6_0))
            + p.k * (φ6_minus_φ6_0 * ω6);
        let t23 = p.m2
            * (l1_cos_φ1 + p.half_l2 * (ω2 * c2) - p.constant3 * (ω2 * s2));
        let t24 = ω6 * t6;
        let t25 = p.m1_r1 * cos_φ1 + t23 - p.m3_r3 * (ω3 * t2)
            - p.m5 * (p.l6 * t24 + p.l5_minus_r5 * (ω5 * c5));
        // slope of the potential energy of gravity
        let dP_g_dφ1 = (t25 - p.m6_r6 * t24) * 9.81;
        // slope of the potential energy
        let dP_dφ1 = dP_s_dφ1 + dP_g_dφ1;
        let t26 = p.c * (ω2_minus_one * (T::from_f64(-1.0) - t3)) + p.c * (t15 * t15);
        let t27 = p.c
            * (ω3
                * (p.l1_per_l3 * (per_sin_φ2_minus_φ3 * (cos_φ1_s2 - sin_φ1_c2))));
        let t28 = -(t26 + t27 + p.c * (t18 * t18) + p.c * (t21 * t21))
            - p.c * (ω6 * (p.per_l6 * -t10));
        let ddφ1_per_dφ1 = per_A * t28;
        let cos_φ1_minus_φ3 = cos_φ1 * c3 + sin_φ1 * s3;
        let cos_φ2_minus_φ3 = c2 * c3 + s2 * s3;
        let t29 = p.l1 * (cos_φ1_minus_φ3 * (ω3 - 1.0))
            - p.l2 * (ω2 * t15 * cos_φ2_minus_φ3);
        let ω2_prime = p.per_l2 * (per_sin_φ2_minus_φ3 * t29);
        let t30 = p.l1 * (cos_φ1_minus_φ2 * ω2_minus_one)
            - p.l3 * (ω3 * t15 * cos_φ2_minus_φ3);
        let ω3_prime = p.per_l3 * (per_sin_φ2_minus_φ3 * t30);
        let cos_φ1_minus_φ6 = cos_φ1 * c6 + sin_φ1 * s6;
        let t31 = p.cx * (ω2_prime * sin_φ2_minus_φ6)
            - p.l1 * (cos_φ1_minus_φ6 * (ω6 - 1.0));
        let t32 = t11 - t3;
        let t33 = t31 + p.cx * (ω2_cos_φ2_minus_φ6 * t32)
            + p.cy * (ω2_prime * cos_φ2_minus_φ6);
        let t34 = t33 - p.cy * (ω2_sin_φ2_minus_φ6 * t32)
            + p.l5 * (ω5 * t21 * cos_φ5_minus_φ6);
        let ω5_prime = -(p.per_l5 * (per_sin_φ5_minus_φ6 * t34));
        let t35 = p.two_C1 * (ω2 * ω2_prime) + p.two_C2 * (ω3 * ω3_prime)
            + p.two_C3 * (ω5 * ω5_prime);
        let cos_φ1_minus_φ5 = cos_φ1 * c5 + sin_φ1 * s5;
        let t36 = p.cx * (ω2_prime * sin_φ2_minus_φ5)
            - p.l1 * (cos_φ1_minus_φ5 * (ω5 - 1.0));
        let t37 = t36 + p.cx * (ω2_cos_φ2_minus_φ5 * t18)
            + p.cy * (ω2_prime * cos_φ2_minus_φ5);
        let t38 = t37 - p.cy * (ω2_sin_φ2_minus_φ5 * t18)
            + p.l6 * (ω6 * t21 * cos_φ5_minus_φ6);
        let ω6_prime = -(p.per_l6 * (per_sin_φ5_minus_φ6 * t38));
        let t39 = t35 + p.two_C4 * (ω6 * ω6_prime)
            + p.C5 * (ω2_prime * cos_φ1_minus_φ2);
        let t40 = t39 + p.C5 * (sin_φ1_minus_φ2_ω2 * ω2_minus_one)
            + p.C6 * (sin_φ1_minus_φ2 * ω2_prime);
        let t41 = t40 - p.C6 * (ω2_cos_φ1_minus_φ2 * ω2_minus_one)
            + p.C7 * (ω6 * cos_φ5_minus_φ6 * ω5_prime);
        let t42 = p.C7 * (sin_φ5_minus_φ6 * ω5 * ω6 * t21)
            - (t41 + p.C7 * (ω5 * cos_φ5_minus_φ6 * ω6_prime));
        let ddφ1_per_dφ1_squared = per_A * (t42 * 0.5);
        [
            per_A,
            per_A * dP_dφ1,
            ddφ1_per_dφ1,
            ddφ1_per_dφ1_squared,
            φ2_minus_φ2_0,
            φ3_minus_φ3_0,
            φ5_minus_φ5_0,
            φ6_minus_φ6_0,
            -(p.constant5 * t1),
            -(p.constant6 * t5),
        ]
    }
    /// dx/dt. Where a loop cannot close, entries are not numbers.
    #[inline(always)]
    pub fn rhs<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 4],
        u: &[T; 0],
        p: &Prepared<T>,
        dx: &mut [T; 2],
    ) {
        let φ1 = x[0];
        let dφ1 = x[1];
        let [per_A, per_A_dP_dφ1, ddφ1_per_dφ1, ddφ1_per_dφ1_squared, ..] = if p
            .table_of_φ1
            .covers(φ1)
        {
            p.table_of_φ1.polynomials(φ1)
        } else {
            p.table_of_φ1.where_covered(φ1, functions_of_φ1(φ1, d, p))
        };
        // ── state ──
        let t1 = (-per_A_dP_dφ1)
            .plus_product(ddφ1_per_dφ1, dφ1)
            .plus_product(ddφ1_per_dφ1_squared, dφ1 * dφ1);
        let ddφ1 = t1
            .plus_product(
                per_A,
                (p.torque * (p.constant4 * t).sin()).minus_product(p.c, dφ1),
            );
        dx[0] = dφ1;
        dx[1] = ddφ1;
    }
    /// ∂(dx/dt)/∂x, row by row; entries that are always zero are left as they are.
    #[inline(always)]
    pub fn jacobian<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 4],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let φ1 = x[0];
        let dφ1 = x[1];
        let turn_coupler = d[0];
        let turn_rocker = d[1];
        let turn_connector = d[2];
        let turn_output_rocker = d[3];
        // ── configuration ──
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let l1_sin_φ1 = p.l1 * sin_φ1;
        let Y1 = p.y2 - l1_sin_φ1;
        let l1_cos_φ1 = p.l1 * cos_φ1;
        // vector that is left to close crank–coupler–rocker
        let X1 = p.x2 - l1_cos_φ1;
        // its length squared
        let D1 = X1 * X1 + Y1 * Y1;
        let per_D1 = D1.recip();
        let κ1 = per_D1 * (p.constant1 + D1) * 0.5;
        let Y1_κ1 = Y1 * κ1;
        let t1 = (-((D1 - p.l2_minus_l3_squared) * (D1 - p.l2_plus_l3_squared))).sqrt();
        let η1 = p.half_ε1 * (per_D1 * t1);
        let X1_η1 = X1 * η1;
        let s2 = p.per_l2 * (Y1_κ1 + X1_η1);
        let X1_κ1 = X1 * κ1;
        let Y1_η1 = Y1 * η1;
        let t2 = p.per_l3 * (X1 - X1_κ1 + Y1_η1);
        let c3 = -t2;
        let c2 = p.per_l2 * (X1_κ1 - Y1_η1);
        let s3 = p.per_l3 * (Y1_κ1 - Y1 + X1_η1);
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
        let Y2 = p.y3 - l1_sin_φ1 - p.cx * s2 - p.cy * c2;
        // vector that is left to close crank–coupler–connector–output_rocker
        let X2 = p.x3 - l1_cos_φ1 + p.cy * s2 - p.cx * c2;
        // its length squared
        let D2 = X2 * X2 + Y2 * Y2;
        let per_D2 = D2.recip();
        let κ2 = per_D2 * (p.constant2 + D2) * 0.5;
        let Y2_κ2 = Y2 * κ2;
        let t5 = (-((D2 - p.l5_minus_l6_squared) * (D2 - p.l5_plus_l6_squared))).sqrt();
        let η2 = p.half_ε2 * (per_D2 * t5);
        let X2_η2 = X2 * η2;
        let s5 = p.per_l5 * (Y2_κ2 + X2_η2);
        let X2_κ2 = X2 * κ2;
        let Y2_η2 = Y2 * η2;
        let t6 = p.per_l6 * (X2 - X2_κ2 + Y2_η2);
        let c6 = -t6;
        let c5 = p.per_l5 * (X2_κ2 - Y2_η2);
        let s6 = p.per_l6 * (Y2_κ2 - Y2 + X2_η2);
        let sin_φ5_minus_φ6 = s5 * c6 - c5 * s6;
        let per_sin_φ5_minus_φ6 = sin_φ5_minus_φ6.recip();
        let sin_φ1_minus_φ6 = sin_φ1 * c6 - cos_φ1 * s6;
        let sin_φ2_minus_φ6 = s2 * c6 - c2 * s6;
        let ω2_sin_φ2_minus_φ6 = ω2 * sin_φ2_minus_φ6;
        let cos_φ2_minus_φ6 = c2 * c6 + s2 * s6;
        let ω2_cos_φ2_minus_φ6 = ω2 * cos_φ2_minus_φ6;
        let t7 = p.l1 * sin_φ1_minus_φ6 + p.cx * ω2_sin_φ2_minus_φ6
            + p.cy * ω2_cos_φ2_minus_φ6;
        let t8 = p.per_l5 * (per_sin_φ5_minus_φ6 * t7);
        // rate of the angle of `connector` per unit rate of `crank`
        let ω5 = -t8;
        let ω5_squared = ω5 * ω5;
        let t9 = p.C0 + p.C1 * ω2_squared + p.C2 * ω3_squared + p.C3 * ω5_squared;
        let sin_φ1_minus_φ5 = sin_φ1 * c5 - cos_φ1 * s5;
        let sin_φ2_minus_φ5 = s2 * c5 - c2 * s5;
        let ω2_sin_φ2_minus_φ5 = ω2 * sin_φ2_minus_φ5;
        let cos_φ2_minus_φ5 = c2 * c5 + s2 * s5;
        let ω2_cos_φ2_minus_φ5 = ω2 * cos_φ2_minus_φ5;
        let t10 = p.l1 * sin_φ1_minus_φ5 + p.cx * ω2_sin_φ2_minus_φ5
            + p.cy * ω2_cos_φ2_minus_φ5;
        let t11 = p.per_l6 * (per_sin_φ5_minus_φ6 * t10);
        // rate of the angle of `output_rocker` per unit rate of `crank`
        let ω6 = -t11;
        let ω6_squared = ω6 * ω6;
        let cos_φ1_minus_φ2 = cos_φ1 * c2 + sin_φ1 * s2;
        let ω2_cos_φ1_minus_φ2 = ω2 * cos_φ1_minus_φ2;
        let sin_φ1_minus_φ2_ω2 = sin_φ1_minus_φ2 * ω2;
        let t12 = t9 + p.C4 * ω6_squared + p.C5 * ω2_cos_φ1_minus_φ2
            + p.C6 * sin_φ1_minus_φ2_ω2;
        let ω5_ω6 = ω5 * ω6;
        let cos_φ5_minus_φ6 = c5 * c6 + s5 * s6;
        // inertia
        let A = t12 + p.C7 * (ω5_ω6 * cos_φ5_minus_φ6);
        let cos_φ1_minus_φ3 = cos_φ1 * c3 + sin_φ1 * s3;
        let ω3_minus_one = ω3 - 1.0;
        let t13 = t4 - t3;
        let cos_φ2_minus_φ3 = c2 * c3 + s2 * s3;
        let t14 = p.l1 * (cos_φ1_minus_φ3 * ω3_minus_one)
            - p.l2 * (ω2 * t13 * cos_φ2_minus_φ3);
        let ω2_prime = p.per_l2 * (per_sin_φ2_minus_φ3 * t14);
        let ω2_ω2_prime = ω2 * ω2_prime;
        let ω2_minus_one = ω2 - 1.0;
        let t15 = p.l1 * (cos_φ1_minus_φ2 * ω2_minus_one)
            - p.l3 * (ω3 * t13 * cos_φ2_minus_φ3);
        let ω3_prime = p.per_l3 * (per_sin_φ2_minus_φ3 * t15);
        let ω3_ω3_prime = ω3 * ω3_prime;
        let ω2_prime_sin_φ2_minus_φ6 = ω2_prime * sin_φ2_minus_φ6;
        let cos_φ1_minus_φ6 = cos_φ1 * c6 + sin_φ1 * s6;
        let ω6_minus_one = ω6 - 1.0;
        let t16 = p.cx * ω2_prime_sin_φ2_minus_φ6
            - p.l1 * (cos_φ1_minus_φ6 * ω6_minus_one);
        let t17 = t11 - t3;
        let ω2_prime_cos_φ2_minus_φ6 = ω2_prime * cos_φ2_minus_φ6;
        let t18 = t16 + p.cx * (ω2_cos_φ2_minus_φ6 * t17)
            + p.cy * ω2_prime_cos_φ2_minus_φ6;
        let t19 = t11 - t8;
        let t20 = t18 - p.cy * (ω2_sin_φ2_minus_φ6 * t17)
            + p.l5 * (ω5 * t19 * cos_φ5_minus_φ6);
        let t21 = p.per_l5 * (per_sin_φ5_minus_φ6 * t20);
        let ω5_prime = -t21;
        let t22 = p.two_C1 * ω2_ω2_prime + p.two_C2 * ω3_ω3_prime
            + p.two_C3 * (ω5 * ω5_prime);
        let ω2_prime_sin_φ2_minus_φ5 = ω2_prime * sin_φ2_minus_φ5;
        let cos_φ1_minus_φ5 = cos_φ1 * c5 + sin_φ1 * s5;
        let ω5_minus_one = ω5 - 1.0;
        let t23 = p.cx * ω2_prime_sin_φ2_minus_φ5
            - p.l1 * (cos_φ1_minus_φ5 * ω5_minus_one);
        let t24 = t8 - t3;
        let ω2_prime_cos_φ2_minus_φ5 = ω2_prime * cos_φ2_minus_φ5;
        let t25 = t23 + p.cx * (ω2_cos_φ2_minus_φ5 * t24)
            + p.cy * ω2_prime_cos_φ2_minus_φ5;
        let t26 = t25 - p.cy * (ω2_sin_φ2_minus_φ5 * t24)
            + p.l6 * (ω6 * t19 * cos_φ5_minus_φ6);
        let t27 = p.per_l6 * (per_sin_φ5_minus_φ6 * t26);
        let ω6_prime = -t27;
        let ω6_ω6_prime = ω6 * ω6_prime;
        let ω2_prime_cos_φ1_minus_φ2 = ω2_prime * cos_φ1_minus_φ2;
        let t28 = t22 + p.two_C4 * ω6_ω6_prime + p.C5 * ω2_prime_cos_φ1_minus_φ2;
        let sin_φ1_minus_φ2_ω2_prime = sin_φ1_minus_φ2 * ω2_prime;
        let t29 = t28 + p.C5 * (sin_φ1_minus_φ2_ω2 * ω2_minus_one)
            + p.C6 * sin_φ1_minus_φ2_ω2_prime;
        let ω6_cos_φ5_minus_φ6 = ω6 * cos_φ5_minus_φ6;
        let t30 = t29 - p.C6 * (ω2_cos_φ1_minus_φ2 * ω2_minus_one)
            + p.C7 * (ω6_cos_φ5_minus_φ6 * ω5_prime);
        let ω5_cos_φ5_minus_φ6 = ω5 * cos_φ5_minus_φ6;
        let sin_φ5_minus_φ6_ω5 = sin_φ5_minus_φ6 * ω5;
        let sin_φ5_minus_φ6_ω5_ω6 = sin_φ5_minus_φ6_ω5 * ω6;
        // slope of the inertia
        let dA_dφ1 = t30 + p.C7 * (ω5_cos_φ5_minus_φ6 * ω6_prime)
            - p.C7 * (sin_φ5_minus_φ6_ω5_ω6 * t19);
        let t31 = (p.c2_0 * s2 - p.s2_0 * c2).atan2(p.c2_0 * c2 + p.s2_0 * s2);
        // angle of `coupler` from the assembled one
        let φ2_minus_φ2_0 = t31.unwrap_to(turn_coupler);
        let t32 = T::from_f64(1.2217304763960306) - φ1 + φ2_minus_φ2_0;
        let t33 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `rocker` from the assembled one
        let φ3_minus_φ3_0 = t33.unwrap_to(turn_rocker);
        let t34 = φ2_minus_φ2_0 - φ3_minus_φ3_0;
        let t35 = p.k * (φ1 - 1.2217304763960306) + p.k * (ω2_minus_one * t32)
            + p.k * (t13 * t34);
        let t36 = (p.c5_0 * s5 - p.s5_0 * c5).atan2(p.c5_0 * c5 + p.s5_0 * s5);
        // angle of `connector` from the assembled one
        let φ5_minus_φ5_0 = t36.unwrap_to(turn_connector);
        let t37 = φ2_minus_φ2_0 - φ5_minus_φ5_0;
        let t38 = (p.c6_0 * s6 - p.s6_0 * c6).atan2(p.c6_0 * c6 + p.s6_0 * s6);
        // angle of `output_rocker` from the assembled one
        let φ6_minus_φ6_0 = t38.unwrap_to(turn_output_rocker);
        let t39 = φ5_minus_φ5_0 - φ6_minus_φ6_0;
        let t40 = t35 + p.k * (φ3_minus_φ3_0 * ω3) + p.k * (t24 * t37)
            + p.k * (t19 * t39);
        // slope of the potential energy of springs
        let dP_s_dφ1 = t40 + p.k * (φ6_minus_φ6_0 * ω6);
        let t41 = p.m2
            * (l1_cos_φ1 + p.half_l2 * (ω2 * c2) - p.constant3 * (ω2 * s2));
        let t42 = ω6 * t6;
        let t43 = p.m1_r1 * cos_φ1 + t41 - p.m3_r3 * (ω3 * t2)
            - p.m5 * (p.l6 * t42 + p.l5_minus_r5 * (ω5 * c5));
        // slope of the potential energy of gravity
        let dP_g_dφ1 = (t43 - p.m6_r6 * t42) * 9.81;
        // slope of the potential energy
        let dP_dφ1 = dP_s_dφ1 + dP_g_dφ1;
        let ω2_minus_one_squared = ω2_minus_one * ω2_minus_one;
        let c_ω2_minus_one_squared = p.c * ω2_minus_one_squared;
        let t44 = t13 * t13;
        let t45 = p.c * t44;
        let c_ω3_squared = p.c * ω3_squared;
        let t46 = t24 * t24;
        let t47 = p.c * t46;
        let t48 = t19 * t19;
        let t49 = p.c * t48;
        let c_ω6_squared = p.c * ω6_squared;
        let per_A = A.recip();
        let ω2_prime_minus_ω3_prime = ω2_prime - ω3_prime;
        let t50 = p.k + p.k * (ω2_prime * t32) + p.k * ω2_minus_one_squared
            + p.k * (t34 * ω2_prime_minus_ω3_prime);
        let t51 = t50 + p.k * t44 + p.k * ω3_squared
            + p.k * (φ3_minus_φ3_0 * ω3_prime);
        let t52 = ω2_prime + t21;
        let t53 = t27 - t21;
        let t54 = t51 + p.k * (t37 * t52) + p.k * t46 + p.k * (t39 * t53) + p.k * t48;
        let ddP_s_dφ1_dφ1 = t54 + p.k * ω6_squared
            + p.k * (φ6_minus_φ6_0 * ω6_prime);
        let t55 = l1_sin_φ1
            - (p.l2 * (ω2_prime * c2) - p.l2 * (ω2_squared * s2)) * 0.5;
        let t56 = (p.cy * (ω2_prime * s2) + p.cy * (ω2_squared * c2))
            * 0.3333333333333333;
        let t57 = p.m1_r1 * sin_φ1 + p.m2 * (t55 + t56) + p.m3_r3 * (ω3_prime * t2);
        let t58 = ω6_prime * t6;
        let ω6_squared_s6 = ω6_squared * s6;
        let t59 = p.l5_minus_r5 * (ω5_squared * s5) - p.l6 * t58
            - p.l6 * ω6_squared_s6;
        let t60 = t57 + p.m3_r3 * (ω3_squared * s3)
            - p.m5 * (t59 - p.l5_minus_r5 * (ω5_prime * c5));
        let ddP_dφ1_dφ1 = ddP_s_dφ1_dφ1
            - (t60 + p.m6_r6 * t58 + p.m6_r6 * ω6_squared_s6) * 9.81;
        let t61 = p.l1 * (sin_φ1_minus_φ3 * (ω3_minus_one * ω3_minus_one))
            + p.l1 * (cos_φ1_minus_φ3 * ω3_prime);
        let t62 = t13 * cos_φ2_minus_φ3;
        let t63 = t61 - p.l2 * (t62 * ω2_prime)
            - p.l2 * (ω2 * cos_φ2_minus_φ3 * ω2_prime_minus_ω3_prime);
        let t64 = p.per_l2
            * (per_sin_φ2_minus_φ3 * (t63 + p.l2 * (sin_φ2_minus_φ3 * ω2 * t44)));
        let t65 = (sin_φ2_minus_φ3 * sin_φ2_minus_φ3).recip() * t13
            * cos_φ2_minus_φ3;
        let dω2_prime_dφ1 = t64 - p.per_l2 * (t65 * t14);
        let t66 = p.l1 * (sin_φ1_minus_φ2 * ω2_minus_one_squared)
            + p.l1 * ω2_prime_cos_φ1_minus_φ2;
        let t67 = t66 - p.l3 * (t62 * ω3_prime)
            - p.l3 * (ω3 * cos_φ2_minus_φ3 * ω2_prime_minus_ω3_prime);
        let t68 = p.per_l3
            * (per_sin_φ2_minus_φ3 * (t67 + p.l3 * (sin_φ2_minus_φ3 * ω3 * t44)));
        let dω3_prime_dφ1 = t68 - p.per_l3 * (t65 * t15);
        let t69 = (p.C1 * (ω2_prime * ω2_prime) + p.C1 * (ω2 * dω2_prime_dφ1)) * 2.0
            + (p.C2 * (ω3_prime * ω3_prime) + p.C2 * (ω3 * dω3_prime_dφ1)) * 2.0;
        let t70 = (sin_φ5_minus_φ6 * sin_φ5_minus_φ6).recip() * t19
            * cos_φ5_minus_φ6;
        let t71 = p.l1 * (sin_φ1_minus_φ6 * (ω6_minus_one * ω6_minus_one))
            + p.l1 * (cos_φ1_minus_φ6 * ω6_prime);
        let t72 = t71 - p.cx * (sin_φ2_minus_φ6 * dω2_prime_dφ1)
            - p.two_cx * (ω2_prime_cos_φ2_minus_φ6 * t17);
        let t73 = ω2_prime + t27;
        let t74 = t17 * t17;
        let t75 = t72 - p.cx * (ω2_cos_φ2_minus_φ6 * t73)
            + p.cx * (ω2_sin_φ2_minus_φ6 * t74);
        let t76 = t75 - p.cy * (cos_φ2_minus_φ6 * dω2_prime_dφ1)
            + p.two_cy * (ω2_prime_sin_φ2_minus_φ6 * t17);
        let t77 = t76 + p.cy * (ω2_cos_φ2_minus_φ6 * t74)
            + p.cy * (ω2_sin_φ2_minus_φ6 * t73);
        let t78 = t19 * cos_φ5_minus_φ6;
        let t79 = t77 - p.l5 * (t78 * ω5_prime) - p.l5 * (ω5_cos_φ5_minus_φ6 * t53);
        let t80 = p.per_l5
            * (per_sin_φ5_minus_φ6 * (t79 + p.l5 * (sin_φ5_minus_φ6_ω5 * t48)));
        let dω5_prime_dφ1 = p.per_l5 * (t70 * t20) + t80;
        let t81 = t69
            + (p.C3 * (ω5_prime * ω5_prime) + p.C3 * (ω5 * dω5_prime_dφ1)) * 2.0;
        let t82 = p.l1 * (sin_φ1_minus_φ5 * (ω5_minus_one * ω5_minus_one))
            + p.l1 * (ω5_prime * cos_φ1_minus_φ5);
        let t83 = t82 - p.cx * (sin_φ2_minus_φ5 * dω2_prime_dφ1)
            - p.two_cx * (ω2_prime_cos_φ2_minus_φ5 * t24);
        let t84 = t83 - p.cx * (ω2_cos_φ2_minus_φ5 * t52)
            + p.cx * (ω2_sin_φ2_minus_φ5 * t46);
        let t85 = t84 - p.cy * (cos_φ2_minus_φ5 * dω2_prime_dφ1)
            + p.two_cy * (ω2_prime_sin_φ2_minus_φ5 * t24);
        let t86 = t85 + p.cy * (ω2_cos_φ2_minus_φ5 * t46)
            + p.cy * (ω2_sin_φ2_minus_φ5 * t52);
        let t87 = t86 - p.l6 * (t78 * ω6_prime) - p.l6 * (ω6_cos_φ5_minus_φ6 * t53);
        let sin_φ5_minus_φ6_ω6 = sin_φ5_minus_φ6 * ω6;
        let t88 = p.per_l6
            * (per_sin_φ5_minus_φ6 * (t87 + p.l6 * (sin_φ5_minus_φ6_ω6 * t48)));
        let dω6_prime_dφ1 = p.per_l6 * (t70 * t26) + t88;
        let t89 = t81
            + (p.C4 * (ω6_prime * ω6_prime) + p.C4 * (ω6 * dω6_prime_dφ1)) * 2.0;
        let t90 = t89 + p.C5 * (cos_φ1_minus_φ2 * dω2_prime_dφ1)
            + p.two_C5 * (sin_φ1_minus_φ2_ω2_prime * ω2_minus_one);
        let t91 = t90 + p.C5 * (sin_φ1_minus_φ2_ω2 * ω2_prime)
            - p.C5 * (ω2_cos_φ1_minus_φ2 * ω2_minus_one_squared);
        let t92 = t91 + p.C6 * (sin_φ1_minus_φ2 * dω2_prime_dφ1)
            - p.two_C6 * (ω2_prime_cos_φ1_minus_φ2 * ω2_minus_one);
        let t93 = t92 - p.C6 * (sin_φ1_minus_φ2_ω2 * ω2_minus_one_squared)
            - p.C6 * (ω2_ω2_prime * cos_φ1_minus_φ2);
        let t94 = t93 + p.two_C7 * (cos_φ5_minus_φ6 * ω5_prime * ω6_prime)
            + p.C7 * (ω6_cos_φ5_minus_φ6 * dω5_prime_dφ1);
        let t95 = t94 - p.two_C7 * (sin_φ5_minus_φ6_ω6 * t19 * ω5_prime)
            + p.C7 * (ω5_cos_φ5_minus_φ6 * dω6_prime_dφ1);
        let t96 = t95 - p.two_C7 * (sin_φ5_minus_φ6_ω5 * t19 * ω6_prime)
            - p.C7 * (ω5_ω6 * t48 * cos_φ5_minus_φ6);
        let ddA_dφ1_dφ1 = t96 - p.C7 * (sin_φ5_minus_φ6_ω5_ω6 * t53);
        let t97 = p.c + c_ω2_minus_one_squared + t45 + c_ω3_squared + t47 + t49
            + c_ω6_squared;
        let dτ_ddφ1 = -t97;
        // ── state ──
        let t98 = p.torque * (p.constant4 * t).sin() - p.c * dφ1
            - c_ω2_minus_one_squared * dφ1;
        // generalized torque of all other forces
        let τ = t98 - t45 * dφ1 - c_ω3_squared * dφ1 - t47 * dφ1 - t49 * dφ1
            - c_ω6_squared * dφ1;
        let dφ1_squared = dφ1 * dφ1;
        let t99 = p.two_c * (ω2_prime * ω2_minus_one) * dφ1
            + p.two_c * (t13 * ω2_prime_minus_ω3_prime) * dφ1;
        let t100 = t99 + p.two_c * ω3_ω3_prime * dφ1 + p.two_c * (t24 * t52) * dφ1;
        let t101 = t100 + p.two_c * (t19 * t53) * dφ1 + p.two_c * ω6_ω6_prime * dφ1;
        let dddφ1_dφ1 = (A * A).recip() * dA_dφ1
            * (dP_dφ1 - τ + dA_dφ1 * 0.5 * dφ1_squared)
            - per_A * (ddP_dφ1_dφ1 + t101 + ddA_dφ1_dφ1 * 0.5 * dφ1_squared);
        let dddφ1_ddφ1 = per_A * (dτ_ddφ1 - dA_dφ1 * dφ1);
        result[1] = T::from_f64(1.0);
        result[2] = dddφ1_dφ1;
        result[3] = dddφ1_ddφ1;
    }
    /// The model's outputs.
    #[inline(always)]
    pub fn outputs<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 4],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 1],
    ) {
        let φ1 = x[0];
        let turn_output_rocker = d[3];
        // ── configuration ──
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let l1_sin_φ1 = p.l1 * sin_φ1;
        let Y1 = p.y2 - l1_sin_φ1;
        let l1_cos_φ1 = p.l1 * cos_φ1;
        // vector that is left to close crank–coupler–rocker
        let X1 = p.x2 - l1_cos_φ1;
        // its length squared
        let D1 = X1 * X1 + Y1 * Y1;
        let per_D1 = D1.recip();
        let κ1 = per_D1 * (p.constant1 + D1) * 0.5;
        let t1 = (-((D1 - p.l2_minus_l3_squared) * (D1 - p.l2_plus_l3_squared))).sqrt();
        let η1 = p.half_ε1 * (per_D1 * t1);
        let s2 = p.per_l2 * (Y1 * κ1 + X1 * η1);
        let c2 = p.per_l2 * (X1 * κ1 - Y1 * η1);
        let Y2 = p.y3 - l1_sin_φ1 - p.cx * s2 - p.cy * c2;
        // vector that is left to close crank–coupler–connector–output_rocker
        let X2 = p.x3 - l1_cos_φ1 + p.cy * s2 - p.cx * c2;
        // its length squared
        let D2 = X2 * X2 + Y2 * Y2;
        let per_D2 = D2.recip();
        let κ2 = per_D2 * (p.constant2 + D2) * 0.5;
        let t2 = (-((D2 - p.l5_minus_l6_squared) * (D2 - p.l5_plus_l6_squared))).sqrt();
        let η2 = p.half_ε2 * (per_D2 * t2);
        let s6 = p.per_l6 * (Y2 * κ2 - Y2 + X2 * η2);
        let c6 = -(p.per_l6 * (X2 - X2 * κ2 + Y2 * η2));
        let t3 = (p.c6_0 * s6 - p.s6_0 * c6).atan2(p.c6_0 * c6 + p.s6_0 * s6);
        // angle of `output_rocker` from the assembled one
        let φ6_minus_φ6_0 = t3.unwrap_to(turn_output_rocker);
        // angle of `output_rocker`
        let φ6 = p.φ6_0 + φ6_minus_φ6_0;
        result[0] = φ6;
    }
    /// Kinetic and potential energy in J, dissipated and supplied power in W.
    #[inline(always)]
    pub fn energy<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 4],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let φ1 = x[0];
        let dφ1 = x[1];
        let turn_coupler = d[0];
        let turn_rocker = d[1];
        let turn_connector = d[2];
        let turn_output_rocker = d[3];
        // ── configuration ──
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let l1_sin_φ1 = p.l1 * sin_φ1;
        let Y1 = p.y2 - l1_sin_φ1;
        let l1_cos_φ1 = p.l1 * cos_φ1;
        // vector that is left to close crank–coupler–rocker
        let X1 = p.x2 - l1_cos_φ1;
        // its length squared
        let D1 = X1 * X1 + Y1 * Y1;
        let per_D1 = D1.recip();
        let κ1 = per_D1 * (p.constant1 + D1) * 0.5;
        let Y1_κ1 = Y1 * κ1;
        let t1 = (-((D1 - p.l2_minus_l3_squared) * (D1 - p.l2_plus_l3_squared))).sqrt();
        let η1 = p.half_ε1 * (per_D1 * t1);
        let X1_η1 = X1 * η1;
        let s2 = p.per_l2 * (Y1_κ1 + X1_η1);
        let X1_κ1 = X1 * κ1;
        let Y1_η1 = Y1 * η1;
        let c3 = -(p.per_l3 * (X1 - X1_κ1 + Y1_η1));
        let c2 = p.per_l2 * (X1_κ1 - Y1_η1);
        let s3 = p.per_l3 * (Y1_κ1 - Y1 + X1_η1);
        let sin_φ2_minus_φ3 = s2 * c3 - c2 * s3;
        let per_sin_φ2_minus_φ3 = sin_φ2_minus_φ3.recip();
        let sin_φ1_minus_φ3 = sin_φ1 * c3 - cos_φ1 * s3;
        let t2 = p.l1_per_l2 * (per_sin_φ2_minus_φ3 * sin_φ1_minus_φ3);
        // rate of the angle of `coupler` per unit rate of `crank`
        let ω2 = -t2;
        let sin_φ1_minus_φ2 = sin_φ1 * c2 - cos_φ1 * s2;
        let t3 = p.l1_per_l3 * (per_sin_φ2_minus_φ3 * sin_φ1_minus_φ2);
        // rate of the angle of `rocker` per unit rate of `crank`
        let ω3 = -t3;
        let ω3_squared = ω3 * ω3;
        let Y2 = p.y3 - l1_sin_φ1 - p.cx * s2 - p.cy * c2;
        // vector that is left to close crank–coupler–connector–output_rocker
        let X2 = p.x3 - l1_cos_φ1 + p.cy * s2 - p.cx * c2;
        // its length squared
        let D2 = X2 * X2 + Y2 * Y2;
        let per_D2 = D2.recip();
        let κ2 = per_D2 * (p.constant2 + D2) * 0.5;
        let Y2_κ2 = Y2 * κ2;
        let t4 = (-((D2 - p.l5_minus_l6_squared) * (D2 - p.l5_plus_l6_squared))).sqrt();
        let η2 = p.half_ε2 * (per_D2 * t4);
        let X2_η2 = X2 * η2;
        let s5 = p.per_l5 * (Y2_κ2 + X2_η2);
        let X2_κ2 = X2 * κ2;
        let Y2_η2 = Y2 * η2;
        let c6 = -(p.per_l6 * (X2 - X2_κ2 + Y2_η2));
        let c5 = p.per_l5 * (X2_κ2 - Y2_η2);
        let s6 = p.per_l6 * (Y2_κ2 - Y2 + X2_η2);
        let sin_φ5_minus_φ6 = s5 * c6 - c5 * s6;
        let per_sin_φ5_minus_φ6 = sin_φ5_minus_φ6.recip();
        let sin_φ1_minus_φ6 = sin_φ1 * c6 - cos_φ1 * s6;
        let sin_φ2_minus_φ6 = s2 * c6 - c2 * s6;
        let cos_φ2_minus_φ6 = c2 * c6 + s2 * s6;
        let t5 = p.l1 * sin_φ1_minus_φ6 + p.cx * (ω2 * sin_φ2_minus_φ6)
            + p.cy * (ω2 * cos_φ2_minus_φ6);
        let t6 = p.per_l5 * (per_sin_φ5_minus_φ6 * t5);
        // rate of the angle of `connector` per unit rate of `crank`
        let ω5 = -t6;
        let t7 = p.C0 + p.C1 * (ω2 * ω2) + p.C2 * ω3_squared + p.C3 * (ω5 * ω5);
        let sin_φ1_minus_φ5 = sin_φ1 * c5 - cos_φ1 * s5;
        let sin_φ2_minus_φ5 = s2 * c5 - c2 * s5;
        let cos_φ2_minus_φ5 = c2 * c5 + s2 * s5;
        let t8 = p.l1 * sin_φ1_minus_φ5 + p.cx * (ω2 * sin_φ2_minus_φ5)
            + p.cy * (ω2 * cos_φ2_minus_φ5);
        let t9 = p.per_l6 * (per_sin_φ5_minus_φ6 * t8);
        // rate of the angle of `output_rocker` per unit rate of `crank`
        let ω6 = -t9;
        let ω6_squared = ω6 * ω6;
        let cos_φ1_minus_φ2 = cos_φ1 * c2 + sin_φ1 * s2;
        let t10 = t7 + p.C4 * ω6_squared + p.C5 * (ω2 * cos_φ1_minus_φ2)
            + p.C6 * (sin_φ1_minus_φ2 * ω2);
        let cos_φ5_minus_φ6 = c5 * c6 + s5 * s6;
        // inertia
        let A = t10 + p.C7 * (ω5 * ω6 * cos_φ5_minus_φ6);
        let t11 = p.m1_r1 * sin_φ1
            + p.m2 * (l1_sin_φ1 + p.constant3 * c2 + p.half_l2 * s2);
        let t12 = t11 + p.m3 * (p.y2 + p.r3 * s3)
            + p.m5 * (p.y3 + p.l6 * s6 - p.l5_minus_r5 * s5);
        let t13 = φ1 - 1.2217304763960306;
        let t14 = (t12 + p.m6 * (p.y3 + p.r6 * s6)) * 9.81 + p.half_k * (t13 * t13);
        let t15 = (p.c2_0 * s2 - p.s2_0 * c2).atan2(p.c2_0 * c2 + p.s2_0 * s2);
        // angle of `coupler` from the assembled one
        let φ2_minus_φ2_0 = t15.unwrap_to(turn_coupler);
        let t16 = T::from_f64(1.2217304763960306) - φ1 + φ2_minus_φ2_0;
        let t17 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `rocker` from the assembled one
        let φ3_minus_φ3_0 = t17.unwrap_to(turn_rocker);
        let t18 = φ3_minus_φ3_0 - φ2_minus_φ2_0;
        let t19 = t14 + p.half_k * (t16 * t16) + p.half_k * (t18 * t18)
            + p.half_k * (φ3_minus_φ3_0 * φ3_minus_φ3_0);
        let t20 = (p.c5_0 * s5 - p.s5_0 * c5).atan2(p.c5_0 * c5 + p.s5_0 * s5);
        // angle of `connector` from the assembled one
        let φ5_minus_φ5_0 = t20.unwrap_to(turn_connector);
        let t21 = φ5_minus_φ5_0 - φ2_minus_φ2_0;
        let t22 = (p.c6_0 * s6 - p.s6_0 * c6).atan2(p.c6_0 * c6 + p.s6_0 * s6);
        // angle of `output_rocker` from the assembled one
        let φ6_minus_φ6_0 = t22.unwrap_to(turn_output_rocker);
        let t23 = φ6_minus_φ6_0 - φ5_minus_φ5_0;
        let t24 = t19 + p.half_k * (t21 * t21) + p.half_k * (t23 * t23)
            + p.half_k * (φ6_minus_φ6_0 * φ6_minus_φ6_0);
        let ω2_minus_one = ω2 - 1.0;
        let t25 = t3 - t2;
        let t26 = t6 - t2;
        let t27 = t9 - t6;
        // ── state ──
        let dφ1_squared = dφ1 * dφ1;
        let t28 = p.c * dφ1_squared
            + p.c * (ω2_minus_one * ω2_minus_one) * dφ1_squared;
        let t29 = t28 + p.c * (t25 * t25) * dφ1_squared
            + p.c * ω3_squared * dφ1_squared;
        let t30 = t29 + p.c * (t26 * t26) * dφ1_squared
            + p.c * (t27 * t27) * dφ1_squared;
        result[0] = A * 0.5 * dφ1_squared;
        result[1] = t24;
        result[2] = t30 + p.c * ω6_squared * dφ1_squared;
        result[3] = p.torque * ((p.constant4 * t).sin() * dφ1);
    }
    /// Event functions: each event happens where its function rises through zero.
    #[inline(always)]
    pub fn events<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 4],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 0],
    ) {}
    /// For each loop a number that is positive where it closes and zero at a dead point.
    #[inline(always)]
    pub fn closures<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 4],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 2],
    ) {
        let φ1 = x[0];
        let [.., t1, t2] = if p.table_of_φ1.covers(φ1) {
            p.table_of_φ1.polynomials(φ1)
        } else {
            p.table_of_φ1.where_covered(φ1, functions_of_φ1(φ1, d, p))
        };
        result[0] = t1;
        result[1] = t2;
    }
    /// The discrete state after an accepted step that ends in `x`; entries that stay are left as they are.
    #[inline(always)]
    pub fn accept<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 4],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let φ1 = x[0];
        let [.., φ2_minus_φ2_0, φ3_minus_φ3_0, φ5_minus_φ5_0, φ6_minus_φ6_0, _, _,
        ] = if p.table_of_φ1.covers(φ1) {
            p.table_of_φ1.polynomials(φ1)
        } else {
            p.table_of_φ1.where_covered(φ1, functions_of_φ1(φ1, d, p))
        };
        result[0] = φ2_minus_φ2_0;
        result[1] = φ3_minus_φ3_0;
        result[2] = φ5_minus_φ5_0;
        result[3] = φ6_minus_φ6_0;
    }
    /// Time in s of each drive's next kink.
    #[inline(always)]
    pub fn next_kinks<T: Real>(d: &[T; 4], p: &Prepared<T>, result: &mut [T; 0]) {}
    /// The discrete state after drive `index` passed its kink; entries that stay are left as they are.
    #[inline(always)]
    pub fn pass_kink<T: Real>(
        index: usize,
        d: &[T; 4],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {}
    /// The state after event `index`; entries that stay are left as they are.
    #[inline(always)]
    pub fn pass_event<T: Real>(
        index: usize,
        t: T,
        x: &[T; 2],
        d: &[T; 4],
        u: &[T; 0],
        p: &Prepared<T>,
        x_after: &mut [T; 2],
        d_after: &mut [T; 4],
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
            2
        }
        fn closures(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], values: &mut [f64]) {
            closures(t, array(x), array(d), array(u), self, array_mut(values));
        }
        fn loop_name(&self, index: usize) -> &str {
            const NAMES: [&str; 2] = [
                "crank–coupler–rocker",
                "crank–coupler–connector–output_rocker",
            ];
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
        type Discretes<L: Lanes> = [L; 4];
        type Loops<L: Lanes> = [L; 2];
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
    pub static VARIABLES: [Variable; 27] = [
        Variable {
            name: Cow::Borrowed("l1"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("crank, coupler, rocker"),
            causality: Causality::Parameter,
            start: Some(0.012),
        },
        Variable {
            name: Cow::Borrowed("l2"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("crank, coupler, rocker"),
            causality: Causality::Parameter,
            start: Some(0.03),
        },
        Variable {
            name: Cow::Borrowed("l3"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("crank, coupler, rocker"),
            causality: Causality::Parameter,
            start: Some(0.022),
        },
        Variable {
            name: Cow::Borrowed("cx"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("C on the coupler"),
            causality: Causality::Parameter,
            start: Some(0.014),
        },
        Variable {
            name: Cow::Borrowed("cy"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("C on the coupler"),
            causality: Causality::Parameter,
            start: Some(0.011),
        },
        Variable {
            name: Cow::Borrowed("l5"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("connecting link, output rocker"),
            causality: Causality::Parameter,
            start: Some(0.021),
        },
        Variable {
            name: Cow::Borrowed("l6"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("connecting link, output rocker"),
            causality: Causality::Parameter,
            start: Some(0.017),
        },
        Variable {
            name: Cow::Borrowed("x2"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("second and third pivot"),
            causality: Causality::Parameter,
            start: Some(0.032),
        },
        Variable {
            name: Cow::Borrowed("y2"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("second and third pivot"),
            causality: Causality::Parameter,
            start: Some(-0.003),
        },
        Variable {
            name: Cow::Borrowed("x3"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("second and third pivot"),
            causality: Causality::Parameter,
            start: Some(0.038),
        },
        Variable {
            name: Cow::Borrowed("y3"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("second and third pivot"),
            causality: Causality::Parameter,
            start: Some(0.022),
        },
        Variable {
            name: Cow::Borrowed("m1"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("masses of the links"),
            causality: Causality::Parameter,
            start: Some(0.0008),
        },
        Variable {
            name: Cow::Borrowed("m2"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("masses of the links"),
            causality: Causality::Parameter,
            start: Some(0.0026),
        },
        Variable {
            name: Cow::Borrowed("m3"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("masses of the links"),
            causality: Causality::Parameter,
            start: Some(0.0015),
        },
        Variable {
            name: Cow::Borrowed("m5"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("masses of the links"),
            causality: Causality::Parameter,
            start: Some(0.0014),
        },
        Variable {
            name: Cow::Borrowed("m6"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("masses of the links"),
            causality: Causality::Parameter,
            start: Some(0.0011),
        },
        Variable {
            name: Cow::Borrowed("k"),
            unit: Cow::Borrowed("N*m"),
            meaning: Cow::Borrowed("stiffness of a hinge"),
            causality: Causality::Parameter,
            start: Some(1.2),
        },
        Variable {
            name: Cow::Borrowed("c"),
            unit: Cow::Borrowed("N*m*s"),
            meaning: Cow::Borrowed("damping of a hinge"),
            causality: Causality::Parameter,
            start: Some(2e-6),
        },
        Variable {
            name: Cow::Borrowed("torque"),
            unit: Cow::Borrowed("N*m"),
            meaning: Cow::Borrowed("drive of the crank"),
            causality: Causality::Parameter,
            start: Some(0.25),
        },
        Variable {
            name: Cow::Borrowed("f"),
            unit: Cow::Borrowed("1/s"),
            meaning: Cow::Borrowed("drive of the crank"),
            causality: Causality::Parameter,
            start: Some(60.0),
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
            name: Cow::Borrowed("connector.turn"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed(
                "angle of `connector` from the assembled one at the last accepted step",
            ),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("output_rocker.turn"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed(
                "angle of `output_rocker` from the assembled one at the last accepted step",
            ),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("swing"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("angle of the output rocker"),
            causality: Causality::Output,
            start: None,
        },
    ];
    static PARAMS: &[Variable] = VARIABLES.split_at(0).1.split_at(20).0;
    static STATES: &[Variable] = VARIABLES.split_at(20).1.split_at(2).0;
    static DISCRETES: &[Variable] = VARIABLES.split_at(22).1.split_at(4).0;
    static INPUTS: &[Variable] = VARIABLES.split_at(26).1.split_at(0).0;
    static OUTPUTS: &[Variable] = VARIABLES.split_at(26).1.split_at(1).0;
    /// Positions of the coordinates and of their rates among the states.
    static COORDINATES: [(usize, usize); 1] = [(0, 1)];
    static TURNING: [usize; 4] = [0, 1, 2, 3];
    static FAILURES: [Failure; 20] = [
        Failure {
            message: Cow::Borrowed("the length of `crank` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("six_bar.flex"),
                line: 18,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link crank   from O1 to A { length = l1, angle = 70 deg exact, mass = m1, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `crank` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("six_bar.flex"),
                line: 18,
                column: 64,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link crank   from O1 to A { length = l1, angle = 70 deg exact, mass = m1, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `crank` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("six_bar.flex"),
                line: 18,
                column: 64,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link crank   from O1 to A { length = l1, angle = 70 deg exact, mass = m1, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `coupler` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("six_bar.flex"),
                line: 19,
                column: 6,
                width: 7,
                excerpt: Cow::Borrowed(
                    "link coupler from A to B  { length = l2, angle = 15 deg,  mass = m2, com = (l2/2, cy/3), symbol = φ2 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `coupler` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("six_bar.flex"),
                line: 19,
                column: 59,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link coupler from A to B  { length = l2, angle = 15 deg,  mass = m2, com = (l2/2, cy/3), symbol = φ2 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `coupler` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("six_bar.flex"),
                line: 19,
                column: 59,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link coupler from A to B  { length = l2, angle = 15 deg,  mass = m2, com = (l2/2, cy/3), symbol = φ2 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `rocker` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("six_bar.flex"),
                line: 20,
                column: 6,
                width: 6,
                excerpt: Cow::Borrowed(
                    "link rocker  from O2 to B { length = l3, angle = 87 deg,  mass = m3, symbol = φ3 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `rocker` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("six_bar.flex"),
                line: 20,
                column: 59,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link rocker  from O2 to B { length = l3, angle = 87 deg,  mass = m3, symbol = φ3 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `rocker` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("six_bar.flex"),
                line: 20,
                column: 59,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link rocker  from O2 to B { length = l3, angle = 87 deg,  mass = m3, symbol = φ3 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `connector` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("six_bar.flex"),
                line: 22,
                column: 6,
                width: 9,
                excerpt: Cow::Borrowed(
                    "link connector from C to D  { length = l5, angle = 36 deg,  mass = m5, symbol = φ5 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `connector` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("six_bar.flex"),
                line: 22,
                column: 61,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link connector from C to D  { length = l5, angle = 36 deg,  mass = m5, symbol = φ5 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `connector` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("six_bar.flex"),
                line: 22,
                column: 61,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link connector from C to D  { length = l5, angle = 36 deg,  mass = m5, symbol = φ5 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `output_rocker` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("six_bar.flex"),
                line: 23,
                column: 6,
                width: 13,
                excerpt: Cow::Borrowed(
                    "link output_rocker from O3 to D { length = l6, angle = 111 deg, mass = m6, symbol = φ6 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `output_rocker` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("six_bar.flex"),
                line: 23,
                column: 65,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link output_rocker from O3 to D { length = l6, angle = 111 deg, mass = m6, symbol = φ6 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `output_rocker` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("six_bar.flex"),
                line: 23,
                column: 65,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link output_rocker from O3 to D { length = l6, angle = 111 deg, mass = m6, symbol = φ6 }",
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
                file: Cow::Borrowed("six_bar.flex"),
                line: 19,
                column: 6,
                width: 7,
                excerpt: Cow::Borrowed(
                    "link coupler from A to B  { length = l2, angle = 15 deg,  mass = m2, com = (l2/2, cy/3), symbol = φ2 }",
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
                file: Cow::Borrowed("six_bar.flex"),
                line: 19,
                column: 6,
                width: 7,
                excerpt: Cow::Borrowed(
                    "link coupler from A to B  { length = l2, angle = 15 deg,  mass = m2, com = (l2/2, cy/3), symbol = φ2 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Metre, Unit::Metre, Unit::Degree]),
        },
        Failure {
            message: Cow::Borrowed(
                "the loop crank–coupler–connector–output_rocker cannot close: at `crank` angle {3} the gap is {0}",
            ),
            hint: Some(
                Cow::Borrowed(
                    "`connector` would need to be {1} to {2} long between its joints, or another link another length or angle",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("six_bar.flex"),
                line: 22,
                column: 6,
                width: 9,
                excerpt: Cow::Borrowed(
                    "link connector from C to D  { length = l5, angle = 36 deg,  mass = m5, symbol = φ5 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Metre, Unit::Metre, Unit::Degree]),
        },
        Failure {
            message: Cow::Borrowed(
                "the loop crank–coupler–connector–output_rocker stands at a dead point: at `crank` angle {3} the joints of `connector` and `output_rocker` lie in one line",
            ),
            hint: Some(
                Cow::Borrowed(
                    "assemble it in another configuration: change an angle or a length; or ask for the coordinate `connector.angle`, if that leads it through",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("six_bar.flex"),
                line: 22,
                column: 6,
                width: 9,
                excerpt: Cow::Borrowed(
                    "link connector from C to D  { length = l5, angle = 36 deg,  mass = m5, symbol = φ5 }",
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
                file: Cow::Borrowed("six_bar.flex"),
                line: 18,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link crank   from O1 to A { length = l1, angle = 70 deg exact, mass = m1, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
    ];
    /// The equations of motion in plain text.
    pub const EQUATIONS: &str = r#"six_bar
═══════

A six-bar flexure linkage (Stephenson III): a four-bar whose coupler moves a rocker on a third
pivot through a further link.

Loop crank–coupler–rocker
─────────────────────────

  l1 e^(i φ1) + l2 e^(i φ2) - l3 e^(i φ3) - i y2 - x2 = 0

  X1 = x2 - l1 cos(φ1)
  Y1 = y2 - l1 sin(φ1)
  D1 = X1² + Y1²
  κ1 = (l2² - l3² + D1) / (2 D1)
  η1 = ε1 sqrt((D1 - (l2 - l3)²) ((l2 + l3)² - D1)) / (2 D1)
  c2 = (X1 κ1 - Y1 η1) / l2
  s2 = (Y1 κ1 + X1 η1) / l2
  c3 = -(X1 - X1 κ1 + Y1 η1) / l3
  s3 = (Y1 κ1 - Y1 + X1 η1) / l3

  φ2 = atan2(s2, c2), φ3 = atan2(s3, c3), continuous over many turns; ⁰: as assembled
  ω2 = dφ2/dφ1, ω3 = dφ3/dφ1, ' = d/dφ1

  ω2  = l1 sin(φ3 - φ1) / (l2 sin(φ2 - φ3))
  ω3  = l1 sin(φ2 - φ1) / (l3 sin(φ2 - φ3))
  ω2' = (l1 (ω3 - 1) cos(φ1 - φ3) + l2 ω2 (ω3 - ω2) cos(φ2 - φ3)) / (l2 sin(φ2 - φ3))
  ω3' = (l1 (ω2 - 1) cos(φ1 - φ2) + l3 ω3 (ω3 - ω2) cos(φ2 - φ3)) / (l3 sin(φ2 - φ3))

Loop crank–coupler–connector–output_rocker
──────────────────────────────────────────

  l1 e^(i φ1) + cx e^(i φ2) + i cy e^(i φ2) + l5 e^(i φ5) - l6 e^(i φ6) - i y3 - x3 = 0

  X2 = x3 - l1 cos(φ1) + cy sin(φ2) - cx cos(φ2)
  Y2 = y3 - l1 sin(φ1) - cx sin(φ2) - cy cos(φ2)
  D2 = X2² + Y2²
  κ2 = (l5² - l6² + D2) / (2 D2)
  η2 = ε2 sqrt((D2 - (l5 - l6)²) ((l5 + l6)² - D2)) / (2 D2)
  c5 = (X2 κ2 - Y2 η2) / l5
  s5 = (Y2 κ2 + X2 η2) / l5
  c6 = -(X2 - X2 κ2 + Y2 η2) / l6
  s6 = (Y2 κ2 - Y2 + X2 η2) / l6

  φ5 = atan2(s5, c5), φ6 = atan2(s6, c6), continuous over many turns; ⁰: as assembled
  ω5 = dφ5/dφ1, ω6 = dφ6/dφ1, ' = d/dφ1

  ω5  = (l1 sin(φ1 - φ6) + cx ω2 sin(φ2 - φ6) + cy ω2 cos(φ2 - φ6)) / (l5 sin(φ6 - φ5))
  ω6  = (l1 sin(φ1 - φ5) + cx ω2 sin(φ2 - φ5) + cy ω2 cos(φ2 - φ5)) / (l6 sin(φ6 - φ5))
  ω5' = (l1 (1 - ω6) cos(φ1 - φ6) + cx ω2' sin(φ2 - φ6) + cx ω2 (ω2 - ω6) cos(φ2 - φ6)
          + cy ω2' cos(φ2 - φ6) + cy ω2 (ω2 - ω6) sin(φ6 - φ2) + l5 ω5 (ω5 - ω6) cos(φ5 - φ6))
          / (l5 sin(φ6 - φ5))
  ω6' = (l1 (1 - ω5) cos(φ1 - φ5) + cx ω2' sin(φ2 - φ5) + cx ω2 (ω2 - ω5) cos(φ2 - φ5)
          + cy ω2' cos(φ2 - φ5) + cy ω2 (ω2 - ω5) sin(φ5 - φ2) + l6 ω6 (ω5 - ω6) cos(φ5 - φ6))
          / (l6 sin(φ6 - φ5))

Constants of the inertia
────────────────────────

  C0 = I1 + m1 r1² + m2 l1²
  C1 = ¼ m2 l2² + I2 + 1/9 m2 cy²
  C2 = I3 + m3 r3²
  C3 = I5 + m5 (r5 - l5)²
  C4 = I6 + m5 l6² + m6 r6²
  C5 = l1 l2 m2
  C6 = ⅔ l1 cy m2
  C7 = 2 l6 m5 (r5 - l5)

Equation of motion of `crank`
─────────────────────────────

Inertia:

  A(φ1)  = C0
         + C1 ω2²
         + C2 ω3²
         + C3 ω5²
         + C4 ω6²
         + C5 ω2 cos(φ1 - φ2)
         + C6 ω2 sin(φ1 - φ2)
         + C7 ω5 ω6 cos(φ5 - φ6)
  ∂A/∂φ1 = 2 C1 ω2 ω2'
         + 2 C2 ω3 ω3'
         + 2 C3 ω5 ω5'
         + 2 C4 ω6 ω6'
         + C5 ω2' cos(φ1 - φ2)
         + C5 ω2 (ω2 - 1) sin(φ1 - φ2)
         + C6 ω2' sin(φ1 - φ2)
         + C6 ω2 (1 - ω2) cos(φ1 - φ2)
         + C7 ω6 ω5' cos(φ5 - φ6)
         + C7 ω5 ω6' cos(φ5 - φ6)
         + C7 ω5 ω6 (ω5 - ω6) sin(φ6 - φ5)

Potential energy:

  ∂P_s/∂φ1 = k (φ1 - φ1⁰)
           + k (ω2 - 1) (φ2 - φ2⁰ - φ1 + φ1⁰)
           + k (ω2 - ω3) (φ2 - φ2⁰ - (φ3 - φ3⁰))
           + k ω3 (φ3 - φ3⁰)
           + k (ω2 - ω5) (φ2 - φ2⁰ - (φ5 - φ5⁰))
           + k (ω5 - ω6) (φ5 - φ5⁰ - (φ6 - φ6⁰))
           + k ω6 (φ6 - φ6⁰)
  ∂P_g/∂φ1 = g (m1 r1 cos(φ1) + m2 (l1 cos(φ1) + ½ l2 ω2 cos(φ2) - ⅓ cy ω2 sin(φ2))
               + m3 r3 ω3 cos(φ3) + m5 (l6 ω6 cos(φ6) + ω5 (r5 - l5) cos(φ5))
               + m6 r6 ω6 cos(φ6))
  ∂P/∂φ1   = ∂P_s/∂φ1 + ∂P_g/∂φ1

Other forces:

  τ = torque sin(2 π f t)
    - c φ̇1
    - c φ̇1 (ω2 - 1)²
    - c φ̇1 (ω2 - ω3)²
    - c φ̇1 ω3²
    - c φ̇1 (ω2 - ω5)²
    - c φ̇1 (ω5 - ω6)²
    - c φ̇1 ω6²

Balance:

  A(φ1) φ̈1 + ½ ∂A/∂φ1 φ̇1² + ∂P/∂φ1 = τ

Constants
─────────

  r1  = ½ l1          distance of the centre of mass from the first end of crank
  I1  = 1/12 m1 l1²   moment of inertia about the centre of mass of crank
  I2  = 1/12 m2 l2²   moment of inertia about the centre of mass of coupler
  r3  = ½ l3          distance of the centre of mass from the first end of rocker
  I3  = 1/12 m3 l3²   moment of inertia about the centre of mass of rocker
  r5  = ½ l5          distance of the centre of mass from the first end of connector
  I5  = 1/12 m5 l5²   moment of inertia about the centre of mass of connector
  r6  = ½ l6          distance of the centre of mass from the first end of output_rocker
  I6  = 1/12 m6 l6²   moment of inertia about the centre of mass of output_rocker
  φ1⁰ = 7/18 π        angle of `crank` as assembled
  ε1  = sign((X1⁰ sin(1/12 π) - Y1⁰ cos(1/12 π)) / l2
          + (X1⁰ sin(29/60 π) - Y1⁰ cos(29/60 π)) / l3)
        which way the loop closes: as drawn
  ε2  = sign((X2⁰ sin(0.2 π) - Y2⁰ cos(0.2 π)) / l5
          + (X2⁰ sin(37/60 π) - Y2⁰ cos(37/60 π)) / l6)
        which way the loop closes: as drawn
  g   = 9.81          acceleration of gravity

  φ2⁰, φ3⁰, X1⁰, Y1⁰, φ5⁰, φ6⁰, X2⁰, Y2⁰: by the formulas of the loops, at φ1 = φ1⁰
"#;
    /// The equations of motion as a LaTeX document.
    pub const EQUATIONS_LATEX: &str = r#"\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\begin{document}

\section*{six\_bar}
A six-bar flexure linkage (Stephenson III): a four-bar whose coupler moves a rocker on a third
pivot through a further link.

\subsection*{Loop crank–coupler–rocker}
\begin{align*}
& l_{1}\, e^{i \varphi_{1}} + l_{2}\, e^{i \varphi_{2}} - l_{3}\, e^{i \varphi_{3}} - i\,y_{2} - x_{2} = 0 \\
X_{1} &= x_{2} - l_{1} \cos \varphi_{1} \\
Y_{1} &= y_{2} - l_{1} \sin \varphi_{1} \\
D_{1} &= X_{1}^{2} + Y_{1}^{2} \\
\kappa_{1} &= \frac{l_{2}^{2} - l_{3}^{2} + D_{1}}{2 \, D_{1}} \\
\eta_{1} &= \frac{\varepsilon_{1}}{2 \, D_{1}} \, \sqrt{\left(D_{1} - \left(l_{2} - l_{3}\right)^{2}\right) \left(\left(l_{2} + l_{3}\right)^{2} - D_{1}\right)} \\
\cos \varphi_{2} &= \frac{X_{1} \, \kappa_{1} - Y_{1} \, \eta_{1}}{l_{2}} \\
\sin \varphi_{2} &= \frac{Y_{1} \, \kappa_{1} + X_{1} \, \eta_{1}}{l_{2}} \\
\cos \varphi_{3} &= -\frac{X_{1} - X_{1} \, \kappa_{1} + Y_{1} \, \eta_{1}}{l_{3}} \\
\sin \varphi_{3} &= \frac{Y_{1} \, \kappa_{1} - Y_{1} + X_{1} \, \eta_{1}}{l_{3}} \\
& \varphi_{2} = \operatorname{atan2}(\sin \varphi_{2}, \cos \varphi_{2}),\quad \varphi_{3} = \operatorname{atan2}(\sin \varphi_{3}, \cos \varphi_{3}) \quad\text{(continuous over many turns; ${}^0$: as assembled)} \\
& \omega_{2} = \frac{\mathrm d\varphi_{2}}{\mathrm d\varphi_{1}},\quad \omega_{3} = \frac{\mathrm d\varphi_{3}}{\mathrm d\varphi_{1}},\quad {}' = \frac{\mathrm d}{\mathrm d\varphi_{1}} \\
\omega_{2} &= \frac{l_{1} \sin\left(\varphi_{3} - \varphi_{1}\right)}{l_{2} \sin\left(\varphi_{2} - \varphi_{3}\right)} \\
\omega_{3} &= \frac{l_{1} \sin\left(\varphi_{2} - \varphi_{1}\right)}{l_{3} \sin\left(\varphi_{2} - \varphi_{3}\right)} \\
\omega'_{2} &= \frac{l_{1} \left(\omega_{3} - 1\right) \cos\left(\varphi_{1} - \varphi_{3}\right) + l_{2} \, \omega_{2} \left(\omega_{3} - \omega_{2}\right) \cos\left(\varphi_{2} - \varphi_{3}\right)}{l_{2} \sin\left(\varphi_{2} - \varphi_{3}\right)} \\
\omega'_{3} &= \frac{l_{1} \left(\omega_{2} - 1\right) \cos\left(\varphi_{1} - \varphi_{2}\right) + l_{3} \, \omega_{3} \left(\omega_{3} - \omega_{2}\right) \cos\left(\varphi_{2} - \varphi_{3}\right)}{l_{3} \sin\left(\varphi_{2} - \varphi_{3}\right)}
\end{align*}

\subsection*{Loop crank–coupler–connector–output\_rocker}
\begin{align*}
& l_{1}\, e^{i \varphi_{1}} + \mathit{cx}\, e^{i \varphi_{2}} + i\,\mathit{cy}\, e^{i \varphi_{2}} + l_{5}\, e^{i \varphi_{5}} - l_{6}\, e^{i \varphi_{6}} - i\,y_{3} - x_{3} = 0 \\
X_{2} &= x_{3} - l_{1} \cos \varphi_{1} + \mathit{cy} \sin \varphi_{2} - \mathit{cx} \cos \varphi_{2} \\
Y_{2} &= y_{3} - l_{1} \sin \varphi_{1} - \mathit{cx} \sin \varphi_{2} - \mathit{cy} \cos \varphi_{2} \\
D_{2} &= X_{2}^{2} + Y_{2}^{2} \\
\kappa_{2} &= \frac{l_{5}^{2} - l_{6}^{2} + D_{2}}{2 \, D_{2}} \\
\eta_{2} &= \frac{\varepsilon_{2}}{2 \, D_{2}} \, \sqrt{\left(D_{2} - \left(l_{5} - l_{6}\right)^{2}\right) \left(\left(l_{5} + l_{6}\right)^{2} - D_{2}\right)} \\
\cos \varphi_{5} &= \frac{X_{2} \, \kappa_{2} - Y_{2} \, \eta_{2}}{l_{5}} \\
\sin \varphi_{5} &= \frac{Y_{2} \, \kappa_{2} + X_{2} \, \eta_{2}}{l_{5}} \\
\cos \varphi_{6} &= -\frac{X_{2} - X_{2} \, \kappa_{2} + Y_{2} \, \eta_{2}}{l_{6}} \\
\sin \varphi_{6} &= \frac{Y_{2} \, \kappa_{2} - Y_{2} + X_{2} \, \eta_{2}}{l_{6}} \\
& \varphi_{5} = \operatorname{atan2}(\sin \varphi_{5}, \cos \varphi_{5}),\quad \varphi_{6} = \operatorname{atan2}(\sin \varphi_{6}, \cos \varphi_{6}) \quad\text{(continuous over many turns; ${}^0$: as assembled)} \\
& \omega_{5} = \frac{\mathrm d\varphi_{5}}{\mathrm d\varphi_{1}},\quad \omega_{6} = \frac{\mathrm d\varphi_{6}}{\mathrm d\varphi_{1}},\quad {}' = \frac{\mathrm d}{\mathrm d\varphi_{1}} \\
\omega_{5} &= \frac{l_{1} \sin\left(\varphi_{1} - \varphi_{6}\right) + \mathit{cx} \, \omega_{2} \sin\left(\varphi_{2} - \varphi_{6}\right) + \mathit{cy} \, \omega_{2} \cos\left(\varphi_{2} - \varphi_{6}\right)}{l_{5} \sin\left(\varphi_{6} - \varphi_{5}\right)} \\
\omega_{6} &= \frac{l_{1} \sin\left(\varphi_{1} - \varphi_{5}\right) + \mathit{cx} \, \omega_{2} \sin\left(\varphi_{2} - \varphi_{5}\right) + \mathit{cy} \, \omega_{2} \cos\left(\varphi_{2} - \varphi_{5}\right)}{l_{6} \sin\left(\varphi_{6} - \varphi_{5}\right)} \\
\omega'_{5} &= \frac{l_{1} \left(1 - \omega_{6}\right) \cos\left(\varphi_{1} - \varphi_{6}\right) + \mathit{cx} \, \omega'_{2} \sin\left(\varphi_{2} - \varphi_{6}\right) + \mathit{cx} \, \omega_{2} \left(\omega_{2} - \omega_{6}\right) \cos\left(\varphi_{2} - \varphi_{6}\right) + \mathit{cy} \, \omega'_{2} \cos\left(\varphi_{2} - \varphi_{6}\right) + \mathit{cy} \, \omega_{2} \left(\omega_{2} - \omega_{6}\right) \sin\left(\varphi_{6} - \varphi_{2}\right) + l_{5} \, \omega_{5} \left(\omega_{5} - \omega_{6}\right) \cos\left(\varphi_{5} - \varphi_{6}\right)}{l_{5} \sin\left(\varphi_{6} - \varphi_{5}\right)} \\
\omega'_{6} &= \frac{l_{1} \left(1 - \omega_{5}\right) \cos\left(\varphi_{1} - \varphi_{5}\right) + \mathit{cx} \, \omega'_{2} \sin\left(\varphi_{2} - \varphi_{5}\right) + \mathit{cx} \, \omega_{2} \left(\omega_{2} - \omega_{5}\right) \cos\left(\varphi_{2} - \varphi_{5}\right) + \mathit{cy} \, \omega'_{2} \cos\left(\varphi_{2} - \varphi_{5}\right) + \mathit{cy} \, \omega_{2} \left(\omega_{2} - \omega_{5}\right) \sin\left(\varphi_{5} - \varphi_{2}\right) + l_{6} \, \omega_{6} \left(\omega_{5} - \omega_{6}\right) \cos\left(\varphi_{5} - \varphi_{6}\right)}{l_{6} \sin\left(\varphi_{6} - \varphi_{5}\right)}
\end{align*}

\subsection*{Constants of the inertia}
\begin{align*}
C_{0} &= I_{1} + m_{1} \, r_{1}^{2} + m_{2} \, l_{1}^{2} \\
C_{1} &= \frac{1}{4} \, m_{2} \, l_{2}^{2} + I_{2} + \frac{1}{9} \, m_{2} \, \mathit{cy}^{2} \\
C_{2} &= I_{3} + m_{3} \, r_{3}^{2} \\
C_{3} &= I_{5} + m_{5} \left(r_{5} - l_{5}\right)^{2} \\
C_{4} &= I_{6} + m_{5} \, l_{6}^{2} + m_{6} \, r_{6}^{2} \\
C_{5} &= l_{1} \, l_{2} \, m_{2} \\
C_{6} &= \frac{2}{3} \, l_{1} \, \mathit{cy} \, m_{2} \\
C_{7} &= 2 \, l_{6} \, m_{5} \left(r_{5} - l_{5}\right)
\end{align*}

\subsection*{Equation of motion of \texttt{crank}}
Inertia:
\begin{align*}
A(\varphi_{1}) &= C_{0} \\
&\quad {}+ C_{1} \, \omega_{2}^{2} \\
&\quad {}+ C_{2} \, \omega_{3}^{2} \\
&\quad {}+ C_{3} \, \omega_{5}^{2} \\
&\quad {}+ C_{4} \, \omega_{6}^{2} \\
&\quad {}+ C_{5} \, \omega_{2} \cos\left(\varphi_{1} - \varphi_{2}\right) \\
&\quad {}+ C_{6} \, \omega_{2} \sin\left(\varphi_{1} - \varphi_{2}\right) \\
&\quad {}+ C_{7} \, \omega_{5} \, \omega_{6} \cos\left(\varphi_{5} - \varphi_{6}\right) \\
\frac{\partial A}{\partial \varphi_{1}} &= 2 \, C_{1} \, \omega_{2} \, \omega'_{2} \\
&\quad {}+ 2 \, C_{2} \, \omega_{3} \, \omega'_{3} \\
&\quad {}+ 2 \, C_{3} \, \omega_{5} \, \omega'_{5} \\
&\quad {}+ 2 \, C_{4} \, \omega_{6} \, \omega'_{6} \\
&\quad {}+ C_{5} \, \omega'_{2} \cos\left(\varphi_{1} - \varphi_{2}\right) \\
&\quad {}+ C_{5} \, \omega_{2} \left(\omega_{2} - 1\right) \sin\left(\varphi_{1} - \varphi_{2}\right) \\
&\quad {}+ C_{6} \, \omega'_{2} \sin\left(\varphi_{1} - \varphi_{2}\right) \\
&\quad {}+ C_{6} \, \omega_{2} \left(1 - \omega_{2}\right) \cos\left(\varphi_{1} - \varphi_{2}\right) \\
&\quad {}+ C_{7} \, \omega_{6} \, \omega'_{5} \cos\left(\varphi_{5} - \varphi_{6}\right) \\
&\quad {}+ C_{7} \, \omega_{5} \, \omega'_{6} \cos\left(\varphi_{5} - \varphi_{6}\right) \\
&\quad {}+ C_{7} \, \omega_{5} \, \omega_{6} \left(\omega_{5} - \omega_{6}\right) \sin\left(\varphi_{6} - \varphi_{5}\right)
\end{align*}
Potential energy:
\begin{align*}
\frac{\partial P_s}{\partial \varphi_{1}} &= k \left(\varphi_{1} - \varphi_{1}^0\right) \\
&\quad {}+ k \left(\omega_{2} - 1\right) \left(\varphi_{2} - \varphi_{2}^0 - \varphi_{1} + \varphi_{1}^0\right) \\
&\quad {}+ k \left(\omega_{2} - \omega_{3}\right) \left(\varphi_{2} - \varphi_{2}^0 - \left(\varphi_{3} - \varphi_{3}^0\right)\right) \\
&\quad {}+ k \, \omega_{3} \left(\varphi_{3} - \varphi_{3}^0\right) \\
&\quad {}+ k \left(\omega_{2} - \omega_{5}\right) \left(\varphi_{2} - \varphi_{2}^0 - \left(\varphi_{5} - \varphi_{5}^0\right)\right) \\
&\quad {}+ k \left(\omega_{5} - \omega_{6}\right) \left(\varphi_{5} - \varphi_{5}^0 - \left(\varphi_{6} - \varphi_{6}^0\right)\right) \\
&\quad {}+ k \, \omega_{6} \left(\varphi_{6} - \varphi_{6}^0\right) \\
\frac{\partial P_g}{\partial \varphi_{1}} &= g \left(m_{1} \, r_{1} \cos \varphi_{1} + m_{2} \left(l_{1} \cos \varphi_{1} + \frac{1}{2} \, l_{2} \, \omega_{2} \cos \varphi_{2} - \frac{1}{3} \, \mathit{cy} \, \omega_{2} \sin \varphi_{2}\right) + m_{3} \, r_{3} \, \omega_{3} \cos \varphi_{3} + m_{5} \left(l_{6} \, \omega_{6} \cos \varphi_{6} + \omega_{5} \left(r_{5} - l_{5}\right) \cos \varphi_{5}\right) + m_{6} \, r_{6} \, \omega_{6} \cos \varphi_{6}\right) \\
\frac{\partial P}{\partial \varphi_{1}} &= \frac{\partial P_s}{\partial \varphi_{1}} + \frac{\partial P_g}{\partial \varphi_{1}}
\end{align*}
Other forces:
\begin{align*}
\tau &= \mathit{torque} \sin\left(2 \, \pi \, f \, t\right) \\
&\quad {}- c \, \dot{\varphi}_{1} \\
&\quad {}- c \, \dot{\varphi}_{1} \left(\omega_{2} - 1\right)^{2} \\
&\quad {}- c \, \dot{\varphi}_{1} \left(\omega_{2} - \omega_{3}\right)^{2} \\
&\quad {}- c \, \dot{\varphi}_{1} \, \omega_{3}^{2} \\
&\quad {}- c \, \dot{\varphi}_{1} \left(\omega_{2} - \omega_{5}\right)^{2} \\
&\quad {}- c \, \dot{\varphi}_{1} \left(\omega_{5} - \omega_{6}\right)^{2} \\
&\quad {}- c \, \dot{\varphi}_{1} \, \omega_{6}^{2}
\end{align*}
Balance:
\begin{align*}
& A(\varphi_{1})\,\ddot{\varphi}_{1} + \tfrac12 \frac{\partial A}{\partial \varphi_{1}}\,\dot{\varphi}_{1}^2 + \frac{\partial P}{\partial \varphi_{1}} = \tau
\end{align*}

\subsection*{Constants}
\begin{align*}
r_{1} &= \frac{1}{2} \, l_{1} && \text{distance of the centre of mass from the first end of crank} \\
I_{1} &= \frac{1}{12} \, m_{1} \, l_{1}^{2} && \text{moment of inertia about the centre of mass of crank} \\
I_{2} &= \frac{1}{12} \, m_{2} \, l_{2}^{2} && \text{moment of inertia about the centre of mass of coupler} \\
r_{3} &= \frac{1}{2} \, l_{3} && \text{distance of the centre of mass from the first end of rocker} \\
I_{3} &= \frac{1}{12} \, m_{3} \, l_{3}^{2} && \text{moment of inertia about the centre of mass of rocker} \\
r_{5} &= \frac{1}{2} \, l_{5} && \text{distance of the centre of mass from the first end of connector} \\
I_{5} &= \frac{1}{12} \, m_{5} \, l_{5}^{2} && \text{moment of inertia about the centre of mass of connector} \\
r_{6} &= \frac{1}{2} \, l_{6} && \text{distance of the centre of mass from the first end of output\_rocker} \\
I_{6} &= \frac{1}{12} \, m_{6} \, l_{6}^{2} && \text{moment of inertia about the centre of mass of output\_rocker} \\
\varphi_{1}^0 &= \frac{7}{18} \, \pi && \text{angle of \texttt{crank} as assembled} \\
\varepsilon_{1} &= \operatorname{sgn}\left(\frac{{X_{1}}^0 \sin\left(\frac{1}{12} \, \pi\right) - {Y_{1}}^0 \cos\left(\frac{1}{12} \, \pi\right)}{l_{2}} + \frac{{X_{1}}^0 \sin\left(\frac{29}{60} \, \pi\right) - {Y_{1}}^0 \cos\left(\frac{29}{60} \, \pi\right)}{l_{3}}\right) && \text{which way the loop closes: as drawn} \\
\varepsilon_{2} &= \operatorname{sgn}\left(\frac{{X_{2}}^0 \sin\left(0.2 \, \pi\right) - {Y_{2}}^0 \cos\left(0.2 \, \pi\right)}{l_{5}} + \frac{{X_{2}}^0 \sin\left(\frac{37}{60} \, \pi\right) - {Y_{2}}^0 \cos\left(\frac{37}{60} \, \pi\right)}{l_{6}}\right) && \text{which way the loop closes: as drawn} \\
g &= 9.81 && \text{acceleration of gravity} \\
& \varphi_{2}^0,\, \varphi_{3}^0,\, {X_{1}}^0,\, {Y_{1}}^0,\, \varphi_{5}^0,\, \varphi_{6}^0,\, {X_{2}}^0,\, {Y_{2}}^0: \text{ by the formulas of the loops, at } \varphi_{1} = \varphi_{1}^0
\end{align*}

\end{document}
"#;
}
