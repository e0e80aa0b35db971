/// Simulator of the model `andrews`, generated from its equations of motion.
///
/// Andrews' squeezing mechanism: seven bodies, three loops, one degree of freedom, driven by a
/// constant torque against a stiff spring.
///
/// A published multibody benchmark (IVP test set; IFToMM A03). Angles are named as published; there
/// the coupler and the links at E are measured against the link they are pinned to.
#[allow(
    non_snake_case,
    non_upper_case_globals,
    unused,
    clippy::all,
    clippy::pedantic,
    rustdoc::all
)]
pub mod andrews {
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
        /// crank in m; 0.007 by default
        pub rr: f64,
        /// crank in m; 0.00092 by default
        pub ra: f64,
        /// crank in kg; 0.04325 by default
        pub m1: f64,
        /// crank in kg\*m^2; 2.194e-6 by default
        pub I1: f64,
        /// coupler in m; 0.028 by default
        pub d: f64,
        /// coupler in m; 0.0115 by default
        pub da: f64,
        /// coupler in kg; 0.00365 by default
        pub m2: f64,
        /// coupler in kg\*m^2; 4.41e-7 by default
        pub I2: f64,
        /// lever in m; 0.035 by default
        pub ss: f64,
        /// lever in m; 0.01874 by default
        pub sa: f64,
        /// lever in m; 0.01043 by default
        pub sb: f64,
        /// lever in kg; 0.02373 by default
        pub m3: f64,
        /// lever in kg\*m^2; 5.255e-6 by default
        pub I3: f64,
        /// D on the lever in m; 0.018 by default
        pub sc: f64,
        /// D on the lever in m; 0.02 by default
        pub sd: f64,
        /// upper connecting link in m; 0.02 by default
        pub e: f64,
        /// upper connecting link in m; 0.01421 by default
        pub ea: f64,
        /// upper connecting link in kg; 0.00706 by default
        pub m4: f64,
        /// upper connecting link in kg\*m^2; 5.667e-7 by default
        pub I4: f64,
        /// upper arm in m; 0.04 by default
        pub zt: f64,
        /// upper arm in m; 0.02308 by default
        pub ta: f64,
        /// upper arm in m; 0.00916 by default
        pub tb: f64,
        /// upper arm in kg; 0.0705 by default
        pub m5: f64,
        /// upper arm in kg\*m^2; 1.169e-5 by default
        pub I5: f64,
        /// lower connecting link in m; 0.02 by default
        pub zf: f64,
        /// lower connecting link in m; 0.01421 by default
        pub fa: f64,
        /// lower connecting link in kg; 0.00706 by default
        pub m6: f64,
        /// lower connecting link in kg\*m^2; 5.667e-7 by default
        pub I6: f64,
        /// lower arm in m; 0.04 by default
        pub u: f64,
        /// lower arm in m; 0.01228 by default
        pub ua: f64,
        /// lower arm in m; 0.00449 by default
        pub ub: f64,
        /// lower arm in kg; 0.05498 by default
        pub m7: f64,
        /// lower arm in kg\*m^2; 1.912e-5 by default
        pub I7: f64,
        /// fixed points in m; -0.06934 by default
        pub xa: f64,
        /// fixed points in m; -0.00227 by default
        pub ya: f64,
        /// fixed points in m; -0.03635 by default
        pub xb: f64,
        /// fixed points in m; 0.03273 by default
        pub yb: f64,
        /// fixed points in m; 0.014 by default
        pub xc: f64,
        /// fixed points in m; 0.072 by default
        pub yc: f64,
        /// stiffness of the spring in N/m; 4530.0 by default
        pub c0: f64,
        /// its free length in m; 0.07785 by default
        pub l0: f64,
        /// torque on the crank in N\*m; 0.033 by default
        pub mom: f64,
        /// crank at the start; -0.06171389001427645 by default
        pub beta0: f64,
    }
    impl Default for Params {
        fn default() -> Self {
            Self {
                rr: 0.007,
                ra: 0.00092,
                m1: 0.04325,
                I1: 2.194e-6,
                d: 0.028,
                da: 0.0115,
                m2: 0.00365,
                I2: 4.41e-7,
                ss: 0.035,
                sa: 0.01874,
                sb: 0.01043,
                m3: 0.02373,
                I3: 5.255e-6,
                sc: 0.018,
                sd: 0.02,
                e: 0.02,
                ea: 0.01421,
                m4: 0.00706,
                I4: 5.667e-7,
                zt: 0.04,
                ta: 0.02308,
                tb: 0.00916,
                m5: 0.0705,
                I5: 1.169e-5,
                zf: 0.02,
                fa: 0.01421,
                m6: 0.00706,
                I6: 5.667e-7,
                u: 0.04,
                ua: 0.01228,
                ub: 0.00449,
                m7: 0.05498,
                I7: 1.912e-5,
                xa: -0.06934,
                ya: -0.00227,
                xb: -0.03635,
                yb: 0.03273,
                xc: 0.014,
                yc: 0.072,
                c0: 4530.0,
                l0: 0.07785,
                mom: 0.033,
                beta0: -0.06171389001427645,
            }
        }
    }
    impl Params {
        /// The values in the order of [`VARIABLES`].
        pub fn values(&self) -> [f64; 43] {
            [
                self.rr,
                self.ra,
                self.m1,
                self.I1,
                self.d,
                self.da,
                self.m2,
                self.I2,
                self.ss,
                self.sa,
                self.sb,
                self.m3,
                self.I3,
                self.sc,
                self.sd,
                self.e,
                self.ea,
                self.m4,
                self.I4,
                self.zt,
                self.ta,
                self.tb,
                self.m5,
                self.I5,
                self.zf,
                self.fa,
                self.m6,
                self.I6,
                self.u,
                self.ua,
                self.ub,
                self.m7,
                self.I7,
                self.xa,
                self.ya,
                self.xb,
                self.yb,
                self.xc,
                self.yc,
                self.c0,
                self.l0,
                self.mom,
                self.beta0,
            ]
        }
        /// Params of values in the order of [`VARIABLES`].
        pub fn from_values(values: [f64; 43]) -> Self {
            Self {
                rr: values[0],
                ra: values[1],
                m1: values[2],
                I1: values[3],
                d: values[4],
                da: values[5],
                m2: values[6],
                I2: values[7],
                ss: values[8],
                sa: values[9],
                sb: values[10],
                m3: values[11],
                I3: values[12],
                sc: values[13],
                sd: values[14],
                e: values[15],
                ea: values[16],
                m4: values[17],
                I4: values[18],
                zt: values[19],
                ta: values[20],
                tb: values[21],
                m5: values[22],
                I5: values[23],
                zf: values[24],
                fa: values[25],
                m6: values[26],
                I6: values[27],
                u: values[28],
                ua: values[29],
                ub: values[30],
                m7: values[31],
                I7: values[32],
                xa: values[33],
                ya: values[34],
                xb: values[35],
                yb: values[36],
                xc: values[37],
                yc: values[38],
                c0: values[39],
                l0: values[40],
                mom: values[41],
                beta0: values[42],
            }
        }
        /// Closes the loops and computes everything that depends on params alone.
        ///
        /// # Errors
        /// What is wrong with the parameter set, in the words of `flexure check`.
        pub fn prepare(&self) -> Result<Prepared<f64>, Diagnostic> {
            check_params(PARAMS, &self.values())?;
            let rr = self.rr;
            let ra = self.ra;
            let m1 = self.m1;
            let I1 = self.I1;
            let d_2 = self.d;
            let da = self.da;
            let m2 = self.m2;
            let I2 = self.I2;
            let ss = self.ss;
            let sa = self.sa;
            let sb = self.sb;
            let m3 = self.m3;
            let I3 = self.I3;
            let sc = self.sc;
            let sd = self.sd;
            let e = self.e;
            let ea = self.ea;
            let m4 = self.m4;
            let I4 = self.I4;
            let zt = self.zt;
            let ta = self.ta;
            let tb = self.tb;
            let m5 = self.m5;
            let I5 = self.I5;
            let zf = self.zf;
            let fa = self.fa;
            let m6 = self.m6;
            let I6 = self.I6;
            let u_2 = self.u;
            let ua = self.ua;
            let ub = self.ub;
            let m7 = self.m7;
            let I7 = self.I7;
            let xa = self.xa;
            let ya = self.ya;
            let xb = self.xb;
            let yb = self.yb;
            let xc = self.xc;
            let yc = self.yc;
            let c0 = self.c0;
            let l0 = self.l0;
            let mom = self.mom;
            let beta0 = self.beta0;
            let d_minus_ss = d_2 - ss;
            let d_minus_ss_squared = d_minus_ss * d_minus_ss;
            let (sin_beta0, cos_beta0) = Real::sin_cos(beta0);
            let X1_0 = xb - rr * cos_beta0;
            let Y1_0 = yb - rr * sin_beta0;
            let D1_0 = X1_0 * X1_0 + Y1_0 * Y1_0;
            let d_plus_ss = d_2 + ss;
            let d_plus_ss_squared = d_plus_ss * d_plus_ss;
            let t1 = (d_minus_ss_squared - D1_0) * (d_plus_ss_squared - D1_0);
            let d_squared = d_2 * d_2;
            let ss_squared = ss * ss;
            let d_squared_ss_squared = d_squared * ss_squared;
            let t2 = t1 * 0.25 / d_squared_ss_squared;
            let e_minus_zt = e - zt;
            let e_minus_zt_squared = e_minus_zt * e_minus_zt;
            let xa_minus_xb = xa - xb;
            let t3 = d_squared - ss_squared;
            let κ1_0 = (t3 + D1_0) * 0.5 / D1_0;
            let Y1_0_κ1_0 = Y1_0 * κ1_0;
            let t4 = (Y1_0 * 0.9982005399352042 + X1_0 * 0.059964006479444595) / d_2
                - (Y1_0 * 0.4356824462767121 + X1_0 * 0.9001004421765051) / ss;
            // which way the loop closes: as drawn
            let ε1 = t4.if_positive(1.0, -1.0);
            let η1_0 = ε1 * (-t1).sqrt() * 0.5 / D1_0;
            let X1_0_η1_0 = X1_0 * η1_0;
            let s3_0 = (Y1_0_κ1_0 - Y1_0 + X1_0_η1_0) / ss;
            let X1_0_κ1_0 = X1_0 * κ1_0;
            let Y1_0_η1_0 = Y1_0 * η1_0;
            let c3_0 = -((X1_0 - X1_0_κ1_0 + Y1_0_η1_0) / ss);
            // angle of `lever` as assembled
            let φ3_0 = Real::atan2(s3_0, c3_0).unwrap_to(-1.12);
            let (sin_φ3_0, cos_φ3_0) = Real::sin_cos(φ3_0);
            let X2_0 = xa_minus_xb - ss * cos_φ3_0;
            let ya_minus_yb = ya - yb;
            let Y2_0 = ya_minus_yb - ss * sin_φ3_0;
            let D2_0 = X2_0 * X2_0 + Y2_0 * Y2_0;
            let e_plus_zt = e + zt;
            let e_plus_zt_squared = e_plus_zt * e_plus_zt;
            let t5 = (e_minus_zt_squared - D2_0) * (e_plus_zt_squared - D2_0);
            let e_squared = e * e;
            let zt_squared = zt * zt;
            let e_squared_zt_squared = e_squared * zt_squared;
            let t6 = t5 * 0.25 / e_squared_zt_squared;
            let zf_minus_u = zf - u_2;
            let zf_minus_u_squared = zf_minus_u * zf_minus_u;
            let zf_plus_u = zf + u_2;
            let zf_plus_u_squared = zf_plus_u * zf_plus_u;
            let t7 = (zf_minus_u_squared - D2_0) * (zf_plus_u_squared - D2_0);
            let zf_squared = zf * zf;
            let u_squared = u_2 * u_2;
            let zf_squared_u_squared = zf_squared * u_squared;
            let t8 = t7 * 0.25 / zf_squared_u_squared;
            // constant of the inertia
            let C0 = I1 + m1 * (ra * ra) + rr * rr * m2;
            // constant of the inertia
            let C1 = I2 + m2 * (da * da);
            let s2_0 = -((Y1_0_κ1_0 + X1_0_η1_0) / d_2);
            let c2_0 = -((X1_0_κ1_0 - Y1_0_η1_0) / d_2);
            // angle of `coupler` as assembled
            let φ2_0 = Real::atan2(s2_0, c2_0).unwrap_to(-0.06);
            let sin_φ2_0_minus_φ3_0 = Real::sin(φ2_0 - φ3_0);
            // rate as assembled
            let ω2_0 = rr * Real::sin(beta0 - φ3_0) / (d_2 * sin_φ2_0_minus_φ3_0);
            // constant of the inertia
            let C2 = I3 + m3 * (sa * sa) + m3 * (sb * sb) + ss_squared * m4
                + ss_squared * m6;
            let beta0_minus_φ2_0 = beta0 - φ2_0;
            let (sin_beta0_minus_φ2_0, cos_beta0_minus_φ2_0) = Real::sin_cos(
                beta0_minus_φ2_0,
            );
            // rate as assembled
            let ω3_0 = -(rr * sin_beta0_minus_φ2_0 / (ss * sin_φ2_0_minus_φ3_0));
            // constant of the inertia
            let C3 = I4 + m4 * (ea * ea);
            let ss_ω3_0 = ss * ω3_0;
            let t9 = e_squared - zt_squared;
            let κ2_0 = (t9 + D2_0) * 0.5 / D2_0;
            let Y2_0_κ2_0 = Y2_0 * κ2_0;
            let t10 = (Y2_0 * 0.6524374681640519 + X2_0 * 0.757842562895277) / e
                + (X2_0 * 0.470625888171158 - Y2_0 * 0.8823328586101215) / zt;
            // which way the loop closes: as drawn
            let ε2 = t10.if_positive(1.0, -1.0);
            let η2_0 = ε2 * (-t5).sqrt() * 0.5 / D2_0;
            let X2_0_η2_0 = X2_0 * η2_0;
            let s_δ_0 = (Y2_0_κ2_0 - Y2_0 + X2_0_η2_0) / zt;
            let X2_0_κ2_0 = X2_0 * κ2_0;
            let Y2_0_η2_0 = Y2_0 * η2_0;
            let c_δ_0 = -((X2_0 - X2_0_κ2_0 + Y2_0_η2_0) / zt);
            // angle of `upper_arm` as assembled
            let δ_0 = Real::atan2(s_δ_0, c_δ_0).unwrap_to(0.49);
            let s4_0 = -((Y2_0_κ2_0 + X2_0_η2_0) / e);
            let c4_0 = -((X2_0_κ2_0 - Y2_0_η2_0) / e);
            // angle of `upper` as assembled
            let φ4_0 = Real::atan2(s4_0, c4_0).unwrap_to(-0.86);
            let sin_φ4_0_minus_δ_0 = Real::sin(φ4_0 - δ_0);
            // rate as assembled
            let ω4_0 = ss_ω3_0 * Real::sin(φ3_0 - δ_0) / (e * sin_φ4_0_minus_δ_0);
            // constant of the inertia
            let C4 = I5 + m5 * (ta * ta) + m5 * (tb * tb);
            let φ3_0_minus_φ4_0 = φ3_0 - φ4_0;
            let (sin_φ3_0_minus_φ4_0, cos_φ3_0_minus_φ4_0) = Real::sin_cos(
                φ3_0_minus_φ4_0,
            );
            // rate as assembled
            let ω_δ_0 = -(ss_ω3_0 * sin_φ3_0_minus_φ4_0
                / (zt * sin_φ4_0_minus_δ_0));
            let t11 = C0 + C1 * (ω2_0 * ω2_0) + C2 * (ω3_0 * ω3_0)
                + C3 * (ω4_0 * ω4_0) + C4 * (ω_δ_0 * ω_δ_0);
            // constant of the inertia
            let C5 = I6 + m6 * (fa * fa);
            let t12 = zf_squared - u_squared;
            let κ3_0 = (t12 + D2_0) * 0.5 / D2_0;
            let Y2_0_κ3_0 = Y2_0 * κ3_0;
            let t13 = (Y2_0 * 0.9427546655283462 + X2_0 * 0.3334870921408144) / u_2
                + (X2_0 * 0.8468318446180152 - Y2_0 * 0.5318607213743555) / zf;
            // which way the loop closes: as drawn
            let ε3 = (-t13).if_positive(1.0, -1.0);
            let η3_0 = ε3 * (-t7).sqrt() * 0.5 / D2_0;
            let X2_0_η3_0 = X2_0 * η3_0;
            let s7_0 = (Y2_0_κ3_0 - Y2_0 + X2_0_η3_0) / u_2;
            let X2_0_κ3_0 = X2_0 * κ3_0;
            let Y2_0_η3_0 = Y2_0 * η3_0;
            let c7_0 = -((X2_0 - X2_0_κ3_0 + Y2_0_η3_0) / u_2);
            // angle of `lower_arm` as assembled
            let φ7_0 = Real::atan2(s7_0, c7_0).unwrap_to(-0.34);
            let s6_0 = -((Y2_0_κ3_0 + X2_0_η3_0) / zf);
            let c6_0 = -((X2_0_κ3_0 - Y2_0_η3_0) / zf);
            // angle of `lower` as assembled
            let φ6_0 = Real::atan2(s6_0, c6_0).unwrap_to(1.01);
            let sin_φ6_0_minus_φ7_0 = Real::sin(φ6_0 - φ7_0);
            // rate as assembled
            let ω6_0 = ss_ω3_0 * Real::sin(φ3_0 - φ7_0)
                / (zf * sin_φ6_0_minus_φ7_0);
            // constant of the inertia
            let C6 = I7 + m7 * (ua * ua) + m7 * (ub * ub);
            let φ3_0_minus_φ6_0 = φ3_0 - φ6_0;
            let (sin_φ3_0_minus_φ6_0, cos_φ3_0_minus_φ6_0) = Real::sin_cos(
                φ3_0_minus_φ6_0,
            );
            // rate as assembled
            let ω7_0 = -(ss_ω3_0 * sin_φ3_0_minus_φ6_0
                / (u_2 * sin_φ6_0_minus_φ7_0));
            // constant of the inertia
            let C7 = -(rr * m2 * da * 2.0);
            let t14 = t11 + C5 * (ω6_0 * ω6_0) + C6 * (ω7_0 * ω7_0)
                + C7 * ω2_0 * cos_beta0_minus_φ2_0;
            // constant of the inertia
            let C8 = -(ss * m4 * ea * 2.0);
            // constant of the inertia
            let C9 = -(ss * m6 * fa * 2.0);
            // inertia as assembled
            let A_crank_0 = t14 + C8 * ω3_0 * ω4_0 * cos_φ3_0_minus_φ4_0
                + C9 * ω3_0 * ω6_0 * cos_φ3_0_minus_φ6_0;
            let Δx_pull_0 = xb - xc + sc * cos_φ3_0 - sd * sin_φ3_0;
            let Δy_pull_0 = yb - yc + sc * sin_φ3_0 + sd * cos_φ3_0;
            // length of `pull` as assembled
            let L_pull_0 = (Δx_pull_0 * Δx_pull_0 + Δy_pull_0 * Δy_pull_0).sqrt();
            if !(rr > 0.0) {
                return Err(FAILURES[0].diagnostic(&[rr]));
            }
            if !(m1 >= 0.0) {
                return Err(FAILURES[1].diagnostic(&[m1]));
            }
            if !(I1 >= 0.0) {
                return Err(FAILURES[2].diagnostic(&[I1]));
            }
            if !(d_2 > 0.0) {
                return Err(FAILURES[3].diagnostic(&[d_2]));
            }
            if !(m2 >= 0.0) {
                return Err(FAILURES[4].diagnostic(&[m2]));
            }
            if !(I2 >= 0.0) {
                return Err(FAILURES[5].diagnostic(&[I2]));
            }
            if !(ss > 0.0) {
                return Err(FAILURES[6].diagnostic(&[ss]));
            }
            if !(m3 >= 0.0) {
                return Err(FAILURES[7].diagnostic(&[m3]));
            }
            if !(I3 >= 0.0) {
                return Err(FAILURES[8].diagnostic(&[I3]));
            }
            if !(e > 0.0) {
                return Err(FAILURES[9].diagnostic(&[e]));
            }
            if !(m4 >= 0.0) {
                return Err(FAILURES[10].diagnostic(&[m4]));
            }
            if !(I4 >= 0.0) {
                return Err(FAILURES[11].diagnostic(&[I4]));
            }
            if !(zt > 0.0) {
                return Err(FAILURES[12].diagnostic(&[zt]));
            }
            if !(m5 >= 0.0) {
                return Err(FAILURES[13].diagnostic(&[m5]));
            }
            if !(I5 >= 0.0) {
                return Err(FAILURES[14].diagnostic(&[I5]));
            }
            if !(zf > 0.0) {
                return Err(FAILURES[15].diagnostic(&[zf]));
            }
            if !(m6 >= 0.0) {
                return Err(FAILURES[16].diagnostic(&[m6]));
            }
            if !(I6 >= 0.0) {
                return Err(FAILURES[17].diagnostic(&[I6]));
            }
            if !(u_2 > 0.0) {
                return Err(FAILURES[18].diagnostic(&[u_2]));
            }
            if !(m7 >= 0.0) {
                return Err(FAILURES[19].diagnostic(&[m7]));
            }
            if !(I7 >= 0.0) {
                return Err(FAILURES[20].diagnostic(&[I7]));
            }
            if !(-t2 >= 0.0) {
                let sqrt_D1_0 = D1_0.sqrt();
                return Err(
                    FAILURES[21]
                        .diagnostic(
                            &[
                                (sqrt_D1_0 - d_2 - ss).larger(d_minus_ss.abs() - sqrt_D1_0),
                                (ss - sqrt_D1_0).abs(),
                                ss + sqrt_D1_0,
                                beta0,
                            ],
                        ),
                );
            }
            if !(-(t2 + 1e-12) > 0.0) {
                let sqrt_D1_0_2 = D1_0.sqrt();
                return Err(
                    FAILURES[22]
                        .diagnostic(
                            &[
                                (sqrt_D1_0_2 - d_2 - ss)
                                    .larger(d_minus_ss.abs() - sqrt_D1_0_2),
                                (ss - sqrt_D1_0_2).abs(),
                                ss + sqrt_D1_0_2,
                                beta0,
                            ],
                        ),
                );
            }
            if !(-t6 >= 0.0) {
                let sqrt_D2_0 = D2_0.sqrt();
                return Err(
                    FAILURES[23]
                        .diagnostic(
                            &[
                                (sqrt_D2_0 - e - zt).larger(e_minus_zt.abs() - sqrt_D2_0),
                                (zt - sqrt_D2_0).abs(),
                                zt + sqrt_D2_0,
                            ],
                        ),
                );
            }
            if !(-(t6 + 1e-12) > 0.0) {
                let sqrt_D2_0_2 = D2_0.sqrt();
                return Err(
                    FAILURES[24]
                        .diagnostic(
                            &[
                                (sqrt_D2_0_2 - e - zt)
                                    .larger(e_minus_zt.abs() - sqrt_D2_0_2),
                                (zt - sqrt_D2_0_2).abs(),
                                zt + sqrt_D2_0_2,
                            ],
                        ),
                );
            }
            if !(-t8 >= 0.0) {
                let sqrt_D2_0_3 = D2_0.sqrt();
                return Err(
                    FAILURES[25]
                        .diagnostic(
                            &[
                                (sqrt_D2_0_3 - zf - u_2)
                                    .larger(zf_minus_u.abs() - sqrt_D2_0_3),
                                (u_2 - sqrt_D2_0_3).abs(),
                                u_2 + sqrt_D2_0_3,
                            ],
                        ),
                );
            }
            if !(-(t8 + 1e-12) > 0.0) {
                let sqrt_D2_0_4 = D2_0.sqrt();
                return Err(
                    FAILURES[26]
                        .diagnostic(
                            &[
                                (sqrt_D2_0_4 - zf - u_2)
                                    .larger(zf_minus_u.abs() - sqrt_D2_0_4),
                                (u_2 - sqrt_D2_0_4).abs(),
                                u_2 + sqrt_D2_0_4,
                            ],
                        ),
                );
            }
            if !(A_crank_0 > 0.0) {
                return Err(FAILURES[27].diagnostic(&[]));
            }
            let mut prepared = Prepared {
                start_states: [beta0, 0.0],
                start_discretes: [0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
                rr,
                d: d_2,
                ss,
                sc,
                sd,
                e,
                zt,
                zf,
                u: u_2,
                xb,
                yb,
                c0,
                mom,
                C0,
                constant1: t3,
                d_minus_ss_squared,
                d_plus_ss_squared,
                half_ε1: ε1 * 0.5,
                per_d: d_2.recip(),
                per_ss: ss.recip(),
                rr_per_d: rr / d_2,
                C1,
                rr_per_ss: rr / ss,
                C2,
                ya_minus_yb,
                xa_minus_xb,
                constant2: t9,
                e_minus_zt_squared,
                e_plus_zt_squared,
                s3_0,
                c3_0,
                φ3_0,
                half_ε2: ε2 * 0.5,
                per_e: e.recip(),
                per_zt: zt.recip(),
                ss_per_e: ss / e,
                C3,
                ss_per_zt: ss / zt,
                C4,
                constant3: t12,
                zf_minus_u_squared,
                zf_plus_u_squared,
                half_ε3: ε3 * 0.5,
                per_zf: zf.recip(),
                per_u: u_2.recip(),
                ss_per_zf: ss / zf,
                C5,
                ss_per_u: ss / u_2,
                C6,
                C7,
                C8,
                C9,
                Δx_pull_0,
                Δy_pull_0,
                L_pull_0,
                L_pull_0_minus_l0: L_pull_0 - l0,
                two_C1: C1 * 2.0,
                two_C2: C2 * 2.0,
                two_C3: C3 * 2.0,
                two_C4: C4 * 2.0,
                two_C5: C5 * 2.0,
                two_C6: C6 * 2.0,
                two_ss: ss * 2.0,
                two_C7: C7 * 2.0,
                two_C8: C8 * 2.0,
                two_C9: C9 * 2.0,
                s2_0,
                c2_0,
                φ2_0,
                s4_0,
                c4_0,
                φ4_0,
                s_δ_0,
                c_δ_0,
                δ_0,
                s6_0,
                c6_0,
                φ6_0,
                s7_0,
                c7_0,
                φ7_0,
                half_c0: c0 * 0.5,
                constant4: 0.25 / d_squared_ss_squared,
                constant5: 0.25 / e_squared_zt_squared,
                constant6: 0.25 / zf_squared_u_squared,
                table_of_β: Table::none(),
            };
            check_start(prepared.states(), &prepared.start_states)?;
            check_start(prepared.discretes(), &prepared.start_discretes)?;
            prepared.table_of_β = Table::fit(
                &prepared,
                &COORDINATES,
                0,
                2,
                |β, d| { functions_of_β(β, array(d), &prepared) },
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
        pub start_discretes: [T; 6],
        /// `rr`
        pub rr: T,
        /// `d`
        pub d: T,
        /// `ss`
        pub ss: T,
        /// `sc`
        pub sc: T,
        /// `sd`
        pub sd: T,
        /// `e`
        pub e: T,
        /// `zt`
        pub zt: T,
        /// `zf`
        pub zf: T,
        /// `u`
        pub u: T,
        /// `xb`
        pub xb: T,
        /// `yb`
        pub yb: T,
        /// `c0`
        pub c0: T,
        /// `mom`
        pub mom: T,
        /// `C0` constant of the inertia
        pub C0: T,
        /// `d * d - ss * ss`
        pub constant1: T,
        /// `(d - ss) * (d - ss)`
        pub d_minus_ss_squared: T,
        /// `(d + ss) * (d + ss)`
        pub d_plus_ss_squared: T,
        /// `0.5 * ε1`
        pub half_ε1: T,
        /// `1.0 / d`
        pub per_d: T,
        /// `1.0 / ss`
        pub per_ss: T,
        /// `rr / d`
        pub rr_per_d: T,
        /// `C1` constant of the inertia
        pub C1: T,
        /// `rr / ss`
        pub rr_per_ss: T,
        /// `C2` constant of the inertia
        pub C2: T,
        /// `ya - yb`
        pub ya_minus_yb: T,
        /// `xa - xb`
        pub xa_minus_xb: T,
        /// `e * e - zt * zt`
        pub constant2: T,
        /// `(e - zt) * (e - zt)`
        pub e_minus_zt_squared: T,
        /// `(e + zt) * (e + zt)`
        pub e_plus_zt_squared: T,
        /// `s3⁰`
        pub s3_0: T,
        /// `c3⁰`
        pub c3_0: T,
        /// `φ3⁰` angle of \`lever\` as assembled
        pub φ3_0: T,
        /// `0.5 * ε2`
        pub half_ε2: T,
        /// `1.0 / e`
        pub per_e: T,
        /// `1.0 / zt`
        pub per_zt: T,
        /// `ss / e`
        pub ss_per_e: T,
        /// `C3` constant of the inertia
        pub C3: T,
        /// `ss / zt`
        pub ss_per_zt: T,
        /// `C4` constant of the inertia
        pub C4: T,
        /// `zf * zf - u * u`
        pub constant3: T,
        /// `(zf - u) * (zf - u)`
        pub zf_minus_u_squared: T,
        /// `(zf + u) * (zf + u)`
        pub zf_plus_u_squared: T,
        /// `0.5 * ε3`
        pub half_ε3: T,
        /// `1.0 / zf`
        pub per_zf: T,
        /// `1.0 / u`
        pub per_u: T,
        /// `ss / zf`
        pub ss_per_zf: T,
        /// `C5` constant of the inertia
        pub C5: T,
        /// `ss / u`
        pub ss_per_u: T,
        /// `C6` constant of the inertia
        pub C6: T,
        /// `C7` constant of the inertia
        pub C7: T,
        /// `C8` constant of the inertia
        pub C8: T,
        /// `C9` constant of the inertia
        pub C9: T,
        /// `Δx_pull⁰`
        pub Δx_pull_0: T,
        /// `Δy_pull⁰`
        pub Δy_pull_0: T,
        /// `L_pull⁰` length of \`pull\` as assembled
        pub L_pull_0: T,
        /// `L_pull⁰ - l0`
        pub L_pull_0_minus_l0: T,
        /// `2.0 * C1`
        pub two_C1: T,
        /// `2.0 * C2`
        pub two_C2: T,
        /// `2.0 * C3`
        pub two_C3: T,
        /// `2.0 * C4`
        pub two_C4: T,
        /// `2.0 * C5`
        pub two_C5: T,
        /// `2.0 * C6`
        pub two_C6: T,
        /// `2.0 * ss`
        pub two_ss: T,
        /// `2.0 * C7`
        pub two_C7: T,
        /// `2.0 * C8`
        pub two_C8: T,
        /// `2.0 * C9`
        pub two_C9: T,
        /// `s2⁰`
        pub s2_0: T,
        /// `c2⁰`
        pub c2_0: T,
        /// `φ2⁰` angle of \`coupler\` as assembled
        pub φ2_0: T,
        /// `s4⁰`
        pub s4_0: T,
        /// `c4⁰`
        pub c4_0: T,
        /// `φ4⁰` angle of \`upper\` as assembled
        pub φ4_0: T,
        /// `s_δ⁰`
        pub s_δ_0: T,
        /// `c_δ⁰`
        pub c_δ_0: T,
        /// `δ⁰` angle of \`upper_arm\` as assembled
        pub δ_0: T,
        /// `s6⁰`
        pub s6_0: T,
        /// `c6⁰`
        pub c6_0: T,
        /// `φ6⁰` angle of \`lower\` as assembled
        pub φ6_0: T,
        /// `s7⁰`
        pub s7_0: T,
        /// `c7⁰`
        pub c7_0: T,
        /// `φ7⁰` angle of \`lower_arm\` as assembled
        pub φ7_0: T,
        /// `0.5 * c0`
        pub half_c0: T,
        /// `0.25 / (d * d * ss * ss)`
        pub constant4: T,
        /// `0.25 / (e * e * zt * zt)`
        pub constant5: T,
        /// `0.25 / (zf * zf * u * u)`
        pub constant6: T,
        /// [`functions_of_β`] near the start.
        pub table_of_β: Table<T, 11>,
    }
    impl<T: Copy> Prepared<T> {
        /// The same with every number turned into another, without curves: for dual numbers or lanes.
        pub fn map<U>(&self, turn: impl Fn(T) -> U) -> Prepared<U> {
            Prepared {
                start_states: self.start_states.map(&turn),
                start_discretes: self.start_discretes.map(&turn),
                rr: turn(self.rr),
                d: turn(self.d),
                ss: turn(self.ss),
                sc: turn(self.sc),
                sd: turn(self.sd),
                e: turn(self.e),
                zt: turn(self.zt),
                zf: turn(self.zf),
                u: turn(self.u),
                xb: turn(self.xb),
                yb: turn(self.yb),
                c0: turn(self.c0),
                mom: turn(self.mom),
                C0: turn(self.C0),
                constant1: turn(self.constant1),
                d_minus_ss_squared: turn(self.d_minus_ss_squared),
                d_plus_ss_squared: turn(self.d_plus_ss_squared),
                half_ε1: turn(self.half_ε1),
                per_d: turn(self.per_d),
                per_ss: turn(self.per_ss),
                rr_per_d: turn(self.rr_per_d),
                C1: turn(self.C1),
                rr_per_ss: turn(self.rr_per_ss),
                C2: turn(self.C2),
                ya_minus_yb: turn(self.ya_minus_yb),
                xa_minus_xb: turn(self.xa_minus_xb),
                constant2: turn(self.constant2),
                e_minus_zt_squared: turn(self.e_minus_zt_squared),
                e_plus_zt_squared: turn(self.e_plus_zt_squared),
                s3_0: turn(self.s3_0),
                c3_0: turn(self.c3_0),
                φ3_0: turn(self.φ3_0),
                half_ε2: turn(self.half_ε2),
                per_e: turn(self.per_e),
                per_zt: turn(self.per_zt),
                ss_per_e: turn(self.ss_per_e),
                C3: turn(self.C3),
                ss_per_zt: turn(self.ss_per_zt),
                C4: turn(self.C4),
                constant3: turn(self.constant3),
                zf_minus_u_squared: turn(self.zf_minus_u_squared),
                zf_plus_u_squared: turn(self.zf_plus_u_squared),
                half_ε3: turn(self.half_ε3),
                per_zf: turn(self.per_zf),
                per_u: turn(self.per_u),
                ss_per_zf: turn(self.ss_per_zf),
                C5: turn(self.C5),
                ss_per_u: turn(self.ss_per_u),
                C6: turn(self.C6),
                C7: turn(self.C7),
                C8: turn(self.C8),
                C9: turn(self.C9),
                Δx_pull_0: turn(self.Δx_pull_0),
                Δy_pull_0: turn(self.Δy_pull_0),
                L_pull_0: turn(self.L_pull_0),
                L_pull_0_minus_l0: turn(self.L_pull_0_minus_l0),
                two_C1: turn(self.two_C1),
                two_C2: turn(self.two_C2),
                two_C3: turn(self.two_C3),
                two_C4: turn(self.two_C4),
                two_C5: turn(self.two_C5),
                two_C6: turn(self.two_C6),
                two_ss: turn(self.two_ss),
                two_C7: turn(self.two_C7),
                two_C8: turn(self.two_C8),
                two_C9: turn(self.two_C9),
                s2_0: turn(self.s2_0),
                c2_0: turn(self.c2_0),
                φ2_0: turn(self.φ2_0),
                s4_0: turn(self.s4_0),
                c4_0: turn(self.c4_0),
                φ4_0: turn(self.φ4_0),
                s_δ_0: turn(self.s_δ_0),
                c_δ_0: turn(self.c_δ_0),
                δ_0: turn(self.δ_0),
                s6_0: turn(self.s6_0),
                c6_0: turn(self.c6_0),
                φ6_0: turn(self.φ6_0),
                s7_0: turn(self.s7_0),
                c7_0: turn(self.c7_0),
                φ7_0: turn(self.φ7_0),
                half_c0: turn(self.half_c0),
                constant4: turn(self.constant4),
                constant5: turn(self.constant5),
                constant6: turn(self.constant6),
                table_of_β: self.table_of_β.map(&turn),
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
                rr: join(self.rr, other.rr),
                d: join(self.d, other.d),
                ss: join(self.ss, other.ss),
                sc: join(self.sc, other.sc),
                sd: join(self.sd, other.sd),
                e: join(self.e, other.e),
                zt: join(self.zt, other.zt),
                zf: join(self.zf, other.zf),
                u: join(self.u, other.u),
                xb: join(self.xb, other.xb),
                yb: join(self.yb, other.yb),
                c0: join(self.c0, other.c0),
                mom: join(self.mom, other.mom),
                C0: join(self.C0, other.C0),
                constant1: join(self.constant1, other.constant1),
                d_minus_ss_squared: join(
                    self.d_minus_ss_squared,
                    other.d_minus_ss_squared,
                ),
                d_plus_ss_squared: join(self.d_plus_ss_squared, other.d_plus_ss_squared),
                half_ε1: join(self.half_ε1, other.half_ε1),
                per_d: join(self.per_d, other.per_d),
                per_ss: join(self.per_ss, other.per_ss),
                rr_per_d: join(self.rr_per_d, other.rr_per_d),
                C1: join(self.C1, other.C1),
                rr_per_ss: join(self.rr_per_ss, other.rr_per_ss),
                C2: join(self.C2, other.C2),
                ya_minus_yb: join(self.ya_minus_yb, other.ya_minus_yb),
                xa_minus_xb: join(self.xa_minus_xb, other.xa_minus_xb),
                constant2: join(self.constant2, other.constant2),
                e_minus_zt_squared: join(
                    self.e_minus_zt_squared,
                    other.e_minus_zt_squared,
                ),
                e_plus_zt_squared: join(self.e_plus_zt_squared, other.e_plus_zt_squared),
                s3_0: join(self.s3_0, other.s3_0),
                c3_0: join(self.c3_0, other.c3_0),
                φ3_0: join(self.φ3_0, other.φ3_0),
                half_ε2: join(self.half_ε2, other.half_ε2),
                per_e: join(self.per_e, other.per_e),
                per_zt: join(self.per_zt, other.per_zt),
                ss_per_e: join(self.ss_per_e, other.ss_per_e),
                C3: join(self.C3, other.C3),
                ss_per_zt: join(self.ss_per_zt, other.ss_per_zt),
                C4: join(self.C4, other.C4),
                constant3: join(self.constant3, other.constant3),
                zf_minus_u_squared: join(
                    self.zf_minus_u_squared,
                    other.zf_minus_u_squared,
                ),
                zf_plus_u_squared: join(self.zf_plus_u_squared, other.zf_plus_u_squared),
                half_ε3: join(self.half_ε3, other.half_ε3),
                per_zf: join(self.per_zf, other.per_zf),
                per_u: join(self.per_u, other.per_u),
                ss_per_zf: join(self.ss_per_zf, other.ss_per_zf),
                C5: join(self.C5, other.C5),
                ss_per_u: join(self.ss_per_u, other.ss_per_u),
                C6: join(self.C6, other.C6),
                C7: join(self.C7, other.C7),
                C8: join(self.C8, other.C8),
                C9: join(self.C9, other.C9),
                Δx_pull_0: join(self.Δx_pull_0, other.Δx_pull_0),
                Δy_pull_0: join(self.Δy_pull_0, other.Δy_pull_0),
                L_pull_0: join(self.L_pull_0, other.L_pull_0),
                L_pull_0_minus_l0: join(self.L_pull_0_minus_l0, other.L_pull_0_minus_l0),
                two_C1: join(self.two_C1, other.two_C1),
                two_C2: join(self.two_C2, other.two_C2),
                two_C3: join(self.two_C3, other.two_C3),
                two_C4: join(self.two_C4, other.two_C4),
                two_C5: join(self.two_C5, other.two_C5),
                two_C6: join(self.two_C6, other.two_C6),
                two_ss: join(self.two_ss, other.two_ss),
                two_C7: join(self.two_C7, other.two_C7),
                two_C8: join(self.two_C8, other.two_C8),
                two_C9: join(self.two_C9, other.two_C9),
                s2_0: join(self.s2_0, other.s2_0),
                c2_0: join(self.c2_0, other.c2_0),
                φ2_0: join(self.φ2_0, other.φ2_0),
                s4_0: join(self.s4_0, other.s4_0),
                c4_0: join(self.c4_0, other.c4_0),
                φ4_0: join(self.φ4_0, other.φ4_0),
                s_δ_0: join(self.s_δ_0, other.s_δ_0),
                c_δ_0: join(self.c_δ_0, other.c_δ_0),
                δ_0: join(self.δ_0, other.δ_0),
                s6_0: join(self.s6_0, other.s6_0),
                c6_0: join(self.c6_0, other.c6_0),
                φ6_0: join(self.φ6_0, other.φ6_0),
                s7_0: join(self.s7_0, other.s7_0),
                c7_0: join(self.c7_0, other.c7_0),
                φ7_0: join(self.φ7_0, other.φ7_0),
                half_c0: join(self.half_c0, other.half_c0),
                constant4: join(self.constant4, other.constant4),
                constant5: join(self.constant5, other.constant5),
                constant6: join(self.constant6, other.constant6),
                table_of_β: self.table_of_β.zip(&other.table_of_β, &join),
            }
        }
    }
    impl Prepared<f64> {
        /// The same without tables and curves: closed forms everywhere.
        pub fn exact(self) -> Self {
            Self {
                table_of_β: Table::none(),
                ..self
            }
        }
    }
    /// What [`rhs`], [`accept`] and [`closures`] need that depends on `β` and params alone, in closed form.
    #[inline(always)]
    pub fn functions_of_β<T: Real>(β: T, d: &[T; 6], p: &Prepared<T>) -> [T; 11] {
        let turn_coupler = d[0];
        let turn_lever = d[1];
        let turn_upper = d[2];
        let turn_upper_arm = d[3];
        let turn_lower = d[4];
        let turn_lower_arm = d[5];
        let (sin_β, cos_β) = β.sin_cos();
        let Y1 = p.yb - p.rr * sin_β;
        // vector that is left to close crank–coupler–lever
        let X1 = p.xb - p.rr * cos_β;
        // its length squared
        let D1 = X1 * X1 + Y1 * Y1;
        let per_D1 = D1.recip();
        let κ1 = per_D1 * (p.constant1 + D1) * 0.5;
        let Y1_κ1 = Y1 * κ1;
        let t1 = (D1 - p.d_minus_ss_squared) * (D1 - p.d_plus_ss_squared);
        let η1 = p.half_ε1 * (per_D1 * (-t1).sqrt());
        let X1_η1 = X1 * η1;
        let s2 = -(p.per_d * (Y1_κ1 + X1_η1));
        let X1_κ1 = X1 * κ1;
        let Y1_η1 = Y1 * η1;
        let t2 = p.per_ss * (X1 - X1_κ1 + Y1_η1);
        let c3 = -t2;
        let c2 = -(p.per_d * (X1_κ1 - Y1_η1));
        let s3 = p.per_ss * (Y1_κ1 - Y1 + X1_η1);
        let sin_φ2_minus_φ3 = s2 * c3 - c2 * s3;
        let per_sin_φ2_minus_φ3 = sin_φ2_minus_φ3.recip();
        let sin_β_minus_φ3 = sin_β * c3 - cos_β * s3;
        // rate of the angle of `coupler` per unit rate of `crank`
        let ω2 = p.rr_per_d * (per_sin_φ2_minus_φ3 * sin_β_minus_φ3);
        let sin_β_minus_φ2 = sin_β * c2 - cos_β * s2;
        let t3 = p.rr_per_ss * (per_sin_φ2_minus_φ3 * sin_β_minus_φ2);
        // rate of the angle of `lever` per unit rate of `crank`
        let ω3 = -t3;
        let Y2 = p.ya_minus_yb - p.ss * s3;
        // vector that is left to close lever–upper–upper_arm
        let X2 = p.xa_minus_xb + p.ss * t2;
        // its length squared
        let D2 = X2 * X2 + Y2 * Y2;
        let per_D2 = D2.recip();
        let κ2 = per_D2 * (p.constant2 + D2) * 0.5;
        let Y2_κ2 = Y2 * κ2;
        let t4 = (D2 - p.e_minus_zt_squared) * (D2 - p.e_plus_zt_squared);
        let η2 = p.half_ε2 * (per_D2 * (-t4).sqrt());
        let X2_η2 = X2 * η2;
        let s4 = -(p.per_e * (Y2_κ2 + X2_η2));
        let X2_κ2 = X2 * κ2;
        let Y2_η2 = Y2 * η2;
        let c_δ = -(p.per_zt * (X2 - X2_κ2 + Y2_η2));
        let c4 = -(p.per_e * (X2_κ2 - Y2_η2));
        let s_δ = p.per_zt * (Y2_κ2 - Y2 + X2_η2);
        let sin_φ4_minus_δ = s4 * c_δ - c4 * s_δ;
        let per_sin_φ4_minus_δ = sin_φ4_minus_δ.recip();
        let ω3_per_sin_φ4_minus_δ = ω3 * per_sin_φ4_minus_δ;
        let sin_φ3_minus_δ = s3 * c_δ - c3 * s_δ;
        // rate of the angle of `upper` per unit rate of `crank`
        let ω4 = p.ss_per_e * (ω3_per_sin_φ4_minus_δ * sin_φ3_minus_δ);
        let sin_φ3_minus_φ4 = s3 * c4 - c3 * s4;
        let t5 = p.ss_per_zt * (ω3_per_sin_φ4_minus_δ * sin_φ3_minus_φ4);
        // rate of the angle of `upper_arm` per unit rate of `crank`
        let ω_δ = -t5;
        let t6 = p.C0 + p.C1 * (ω2 * ω2) + p.C2 * (ω3 * ω3) + p.C3 * (ω4 * ω4)
            + p.C4 * (ω_δ * ω_δ);
        let κ3 = per_D2 * (p.constant3 + D2) * 0.5;
        let Y2_κ3 = Y2 * κ3;
        let t7 = (D2 - p.zf_minus_u_squared) * (D2 - p.zf_plus_u_squared);
        let η3 = p.half_ε3 * (per_D2 * (-t7).sqrt());
        let X2_η3 = X2 * η3;
        let s6 = -(p.per_zf * (Y2_κ3 + X2_η3));
        let X2_κ3 = X2 * κ3;
        let Y2_η3 = Y2 * η3;
        let c7 = -(p.per_u * (X2 - X2_κ3 + Y2_η3));
        let c6 = -(p.per_zf * (X2_κ3 - Y2_η3));
        let s7 = p.per_u * (Y2_κ3 - Y2 + X2_η3);
        let sin_φ6_minus_φ7 = s6 * c7 - c6 * s7;
        let per_sin_φ6_minus_φ7 = sin_φ6_minus_φ7.recip();
        let ω3_per_sin_φ6_minus_φ7 = ω3 * per_sin_φ6_minus_φ7;
        let sin_φ3_minus_φ7 = s3 * c7 - c3 * s7;
        // rate of the angle of `lower` per unit rate of `crank`
        let ω6 = p.ss_per_zf * (ω3_per_sin_φ6_minus_φ7 * sin_φ3_minus_φ7);
        let sin_φ3_minus_φ6 = s3 * c6 - c3 * s6;
        let t8 = p.ss_per_u * (ω3_per_sin_φ6_minus_φ7 * sin_φ3_minus_φ6);
        // rate of the angle of `lower_arm` per unit rate of `crank`
        let ω7 = -t8;
        let cos_β_minus_φ2 = cos_β * c2 + sin_β * s2;
        let t9 = t6 + p.C5 * (ω6 * ω6) + p.C6 * (ω7 * ω7)
            + p.C7 * (ω2 * cos_β_minus_φ2);
        let cos_φ3_minus_φ4 = c3 * c4 + s3 * s4;
        let cos_φ3_minus_φ6 = c3 * c6 + s3 * s6;
        // inertia
        let A = t9 + p.C8 * (ω3 * ω4 * cos_φ3_minus_φ4)
            + p.C9 * (ω3 * ω6 * cos_φ3_minus_φ6);
        let per_A = A.recip();
        let t10 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `lever` from the assembled one
        let φ3_minus_φ3_0 = t10.unwrap_to(turn_lever);
        // angle of `lever`
        let φ3 = p.φ3_0 + φ3_minus_φ3_0;
        let half_φ3_plus_φ3_0 = (φ3 + p.φ3_0) * 0.5;
        let (sin_half_φ3_plus_φ3_0, cos_half_φ3_plus_φ3_0) = half_φ3_plus_φ3_0
            .sin_cos();
        let sin_half_φ3_0_minus_φ3 = ((p.φ3_0 - φ3) * 0.5).sin();
        let t11 = sin_half_φ3_plus_φ3_0 * sin_half_φ3_0_minus_φ3 * 2.0;
        // change of Δx_pull
        let δx_pull = p.sc * t11
            + p.sd * (cos_half_φ3_plus_φ3_0 * sin_half_φ3_0_minus_φ3 * 2.0);
        // from end to end of `pull`
        let Δx_pull = p.Δx_pull_0 + δx_pull;
        // change of Δy_pull
        let δy_pull = p.sc
            * (cos_half_φ3_plus_φ3_0 * ((φ3 - p.φ3_0) * 0.5).sin() * 2.0)
            + p.sd * t11;
        // from end to end of `pull`
        let Δy_pull = p.Δy_pull_0 + δy_pull;
        let t12 = δx_pull * (p.Δx_pull_0 + Δx_pull)
            + δy_pull * (p.Δy_pull_0 + Δy_pull);
        // length of `pull`
        let L_pull = (Δx_pull * Δx_pull + Δy_pull * Δy_pull).sqrt();
        // extension of `pull`
        let e_pull = p.L_pull_0_minus_l0 + t12 * (p.L_pull_0 + L_pull).recip();
        let t13 = ω3 * t2;
        let ω3_s3 = ω3 * s3;
        let t14 = Δy_pull * (p.sc * t13 + p.sd * ω3_s3)
            + Δx_pull * (p.sc * ω3_s3 - p.sd * t13);
        // lever of `pull`: change of its length
        let dL_pull_dβ = -(L_pull.recip() * t14);
        // slope of the potential energy of springs
        let dP_s_dβ = p.c0 * (e_pull * dL_pull_dβ);
        // what β̈ is by `β` alone
        let ddβ_of_β = per_A * (p.mom - dP_s_dβ);
        let ω3_minus_ω6 = ω3 - ω6;
        let cos_β_minus_φ3 = cos_β * c3 + sin_β * s3;
        let t15 = ω2 + t3;
        let cos_φ2_minus_φ3 = c2 * c3 + s2 * s3;
        let t16 = p.rr * (cos_β_minus_φ3 * (ω3 - 1.0))
            + p.d * (ω2 * t15 * cos_φ2_minus_φ3);
        let ω2_prime = -(p.per_d * (per_sin_φ2_minus_φ3 * t16));
        let ω2_minus_one = ω2 - 1.0;
        let t17 = p.rr * (cos_β_minus_φ2 * ω2_minus_one)
            - p.ss * (ω3 * t15 * cos_φ2_minus_φ3);
        let ω3_prime = p.per_ss * (per_sin_φ2_minus_φ3 * t17);
        let cos_φ3_minus_δ = c3 * c_δ + s3 * s_δ;
        let t18 = p.ss * (ω3_prime * sin_φ3_minus_δ)
            + p.ss * (ω3 * (t5 - t3) * cos_φ3_minus_δ);
        let t19 = ω4 + t5;
        let cos_φ4_minus_δ = c4 * c_δ + s4 * s_δ;
        let ω4_prime = p.per_e
            * (per_sin_φ4_minus_δ * (t18 - p.e * (ω4 * t19 * cos_φ4_minus_δ)));
        let t20 = p.two_C1 * (ω2 * ω2_prime) + p.two_C2 * (ω3 * ω3_prime)
            + p.two_C3 * (ω4 * ω4_prime);
        let ω3_minus_ω4 = ω3 - ω4;
        let t21 = p.ss * (ω3_prime * sin_φ3_minus_φ4)
            + p.ss * (ω3 * ω3_minus_ω4 * cos_φ3_minus_φ4);
        let t22 = p.per_zt
            * (per_sin_φ4_minus_δ * (t21 + p.zt * (ω_δ * t19 * cos_φ4_minus_δ)));
        let ω_δ_prime = -t22;
        let cos_φ3_minus_φ7 = c3 * c7 + s3 * s7;
        let t23 = p.ss * (ω3_prime * sin_φ3_minus_φ7)
            + p.ss * (ω3 * (t8 - t3) * cos_φ3_minus_φ7);
        let t24 = ω6 + t8;
        let cos_φ6_minus_φ7 = c6 * c7 + s6 * s7;
        let ω6_prime = p.per_zf
            * (per_sin_φ6_minus_φ7 * (t23 - p.zf * (ω6 * t24 * cos_φ6_minus_φ7)));
        let t25 = p.ss * (ω3_prime * sin_φ3_minus_φ6)
            + p.ss * (ω3 * ω3_minus_ω6 * cos_φ3_minus_φ6);
        let t26 = p.per_u
            * (per_sin_φ6_minus_φ7 * (t25 + p.u * (ω7 * t24 * cos_φ6_minus_φ7)));
        let ω7_prime = -t26;
        let t27 = t20 + p.two_C4 * (ω_δ * ω_δ_prime) + p.two_C5 * (ω6 * ω6_prime)
            + p.two_C6 * (ω7 * ω7_prime);
        let t28 = t27 + p.C7 * (ω2_prime * cos_β_minus_φ2)
            + p.C7 * (sin_β_minus_φ2 * ω2 * ω2_minus_one);
        let t29 = t28 + p.C8 * (ω3_prime * ω4 * cos_φ3_minus_φ4)
            + p.C8 * (ω3 * ω4_prime * cos_φ3_minus_φ4);
        let t30 = t29 - p.C8 * (ω3 * sin_φ3_minus_φ4 * ω4 * ω3_minus_ω4)
            + p.C9 * (ω3_prime * ω6 * cos_φ3_minus_φ6);
        let t31 = p.C9 * (ω3 * sin_φ3_minus_φ6 * ω6 * ω3_minus_ω6)
            - (t30 + p.C9 * (ω3 * ω6_prime * cos_φ3_minus_φ6));
        let ddβ_per_dβ_squared = per_A * (t31 * 0.5);
        let t32 = (p.c2_0 * s2 - p.s2_0 * c2).atan2(p.c2_0 * c2 + p.s2_0 * s2);
        // angle of `coupler` from the assembled one
        let φ2_minus_φ2_0 = t32.unwrap_to(turn_coupler);
        let t33 = (p.c4_0 * s4 - p.s4_0 * c4).atan2(p.c4_0 * c4 + p.s4_0 * s4);
        // angle of `upper` from the assembled one
        let φ4_minus_φ4_0 = t33.unwrap_to(turn_upper);
        let t34 = (p.c_δ_0 * s_δ - p.s_δ_0 * c_δ)
            .atan2(p.c_δ_0 * c_δ + p.s_δ_0 * s_δ);
        // angle of `upper_arm` from the assembled one
        let δ_minus_δ_0 = t34.unwrap_to(turn_upper_arm);
        let t35 = (p.c6_0 * s6 - p.s6_0 * c6).atan2(p.c6_0 * c6 + p.s6_0 * s6);
        // angle of `lower` from the assembled one
        let φ6_minus_φ6_0 = t35.unwrap_to(turn_lower);
        let t36 = (p.c7_0 * s7 - p.s7_0 * c7).atan2(p.c7_0 * c7 + p.s7_0 * s7);
        // angle of `lower_arm` from the assembled one
        let φ7_minus_φ7_0 = t36.unwrap_to(turn_lower_arm);
        [
            ddβ_of_β,
            ddβ_per_dβ_squared,
            φ3_minus_φ3_0,
            φ2_minus_φ2_0,
            φ4_minus_φ4_0,
            δ_minus_δ_0,
            φ6_minus_φ6_0,
            φ7_minus_φ7_0,
            -(p.constant4 * t1),
            -(p.constant5 * t4),
            -(p.constant6 * t7),
        ]
    }
    /// dx/dt. Where a loop cannot close, entries are not numbers.
    #[inline(always)]
    pub fn rhs<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 6],
        u: &[T; 0],
        p: &Prepared<T>,
        dx: &mut [T; 2],
    ) {
        let β = x[0];
        let dβ = x[1];
        let [ddβ_of_β, ddβ_per_dβ_squared, ..] = if p.table_of_β.covers(β) {
            p.table_of_β.polynomials(β)
        } else {
            p.table_of_β.where_covered(β, functions_of_β(β, d, p))
        };
        // ── state ──
        let ddβ = ddβ_of_β.plus_product(ddβ_per_dβ_squared, dβ * dβ);
        dx[0] = dβ;
        dx[1] = ddβ;
    }
    /// ∂(dx/dt)/∂x, row by row; entries that are always zero are left as they are.
    #[inline(always)]
    pub fn jacobian<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 6],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let β = x[0];
        let dβ = x[1];
        let turn_lever = d[1];
        // ── configuration ──
        let (sin_β, cos_β) = β.sin_cos();
        let Y1 = p.yb - p.rr * sin_β;
        // vector that is left to close crank–coupler–lever
        let X1 = p.xb - p.rr * cos_β;
        // its length squared
        let D1 = X1 * X1 + Y1 * Y1;
        let per_D1 = D1.recip();
        let κ1 = per_D1 * (p.constant1 + D1) * 0.5;
        let Y1_κ1 = Y1 * κ1;
        let t1 = per_D1
            * (-((D1 - p.d_minus_ss_squared) * (D1 - p.d_plus_ss_squared))).sqrt();
        let η1 = p.half_ε1 * t1;
        let X1_η1 = X1 * η1;
        let s2 = -(p.per_d * (Y1_κ1 + X1_η1));
        let X1_κ1 = X1 * κ1;
        let Y1_η1 = Y1 * η1;
        let t2 = p.per_ss * (X1 - X1_κ1 + Y1_η1);
        let c3 = -t2;
        let c2 = -(p.per_d * (X1_κ1 - Y1_η1));
        let s3 = p.per_ss * (Y1_κ1 - Y1 + X1_η1);
        let sin_φ2_minus_φ3 = s2 * c3 - c2 * s3;
        let per_sin_φ2_minus_φ3 = sin_φ2_minus_φ3.recip();
        let sin_β_minus_φ3 = sin_β * c3 - cos_β * s3;
        // rate of the angle of `coupler` per unit rate of `crank`
        let ω2 = p.rr_per_d * (per_sin_φ2_minus_φ3 * sin_β_minus_φ3);
        let sin_β_minus_φ2 = sin_β * c2 - cos_β * s2;
        let t3 = p.rr_per_ss * (per_sin_φ2_minus_φ3 * sin_β_minus_φ2);
        // rate of the angle of `lever` per unit rate of `crank`
        let ω3 = -t3;
        let ω3_squared = ω3 * ω3;
        let Y2 = p.ya_minus_yb - p.ss * s3;
        // vector that is left to close lever–upper–upper_arm
        let X2 = p.xa_minus_xb + p.ss * t2;
        // its length squared
        let D2 = X2 * X2 + Y2 * Y2;
        let per_D2 = D2.recip();
        let κ2 = per_D2 * (p.constant2 + D2) * 0.5;
        let Y2_κ2 = Y2 * κ2;
        let t4 = per_D2
            * (-((D2 - p.e_minus_zt_squared) * (D2 - p.e_plus_zt_squared))).sqrt();
        let η2 = p.half_ε2 * t4;
        let X2_η2 = X2 * η2;
        let s4 = -(p.per_e * (Y2_κ2 + X2_η2));
        let X2_κ2 = X2 * κ2;
        let Y2_η2 = Y2 * η2;
        let c_δ = -(p.per_zt * (X2 - X2_κ2 + Y2_η2));
        let c4 = -(p.per_e * (X2_κ2 - Y2_η2));
        let s_δ = p.per_zt * (Y2_κ2 - Y2 + X2_η2);
        let sin_φ4_minus_δ = s4 * c_δ - c4 * s_δ;
        let per_sin_φ4_minus_δ = sin_φ4_minus_δ.recip();
        let ω3_per_sin_φ4_minus_δ = ω3 * per_sin_φ4_minus_δ;
        let sin_φ3_minus_δ = s3 * c_δ - c3 * s_δ;
        // rate of the angle of `upper` per unit rate of `crank`
        let ω4 = p.ss_per_e * (ω3_per_sin_φ4_minus_δ * sin_φ3_minus_δ);
        let t5 = p.C0 + p.C1 * (ω2 * ω2) + p.C2 * ω3_squared + p.C3 * (ω4 * ω4);
        let sin_φ3_minus_φ4 = s3 * c4 - c3 * s4;
        let t6 = p.ss_per_zt * (ω3_per_sin_φ4_minus_δ * sin_φ3_minus_φ4);
        // rate of the angle of `upper_arm` per unit rate of `crank`
        let ω_δ = -t6;
        let κ3 = per_D2 * (p.constant3 + D2) * 0.5;
        let Y2_κ3 = Y2 * κ3;
        let t7 = per_D2
            * (-((D2 - p.zf_minus_u_squared) * (D2 - p.zf_plus_u_squared))).sqrt();
        let η3 = p.half_ε3 * t7;
        let X2_η3 = X2 * η3;
        let s6 = -(p.per_zf * (Y2_κ3 + X2_η3));
        let X2_κ3 = X2 * κ3;
        let Y2_η3 = Y2 * η3;
        let c7 = -(p.per_u * (X2 - X2_κ3 + Y2_η3));
        let c6 = -(p.per_zf * (X2_κ3 - Y2_η3));
        let s7 = p.per_u * (Y2_κ3 - Y2 + X2_η3);
        let sin_φ6_minus_φ7 = s6 * c7 - c6 * s7;
        let per_sin_φ6_minus_φ7 = sin_φ6_minus_φ7.recip();
        let ω3_per_sin_φ6_minus_φ7 = ω3 * per_sin_φ6_minus_φ7;
        let sin_φ3_minus_φ7 = s3 * c7 - c3 * s7;
        // rate of the angle of `lower` per unit rate of `crank`
        let ω6 = p.ss_per_zf * (ω3_per_sin_φ6_minus_φ7 * sin_φ3_minus_φ7);
        let sin_φ3_minus_φ6 = s3 * c6 - c3 * s6;
        let t8 = p.ss_per_u * (ω3_per_sin_φ6_minus_φ7 * sin_φ3_minus_φ6);
        // rate of the angle of `lower_arm` per unit rate of `crank`
        let ω7 = -t8;
        let cos_β_minus_φ2 = cos_β * c2 + sin_β * s2;
        let ω2_cos_β_minus_φ2 = ω2 * cos_β_minus_φ2;
        let t9 = t5 + p.C4 * (ω_δ * ω_δ) + p.C5 * (ω6 * ω6) + p.C6 * (ω7 * ω7)
            + p.C7 * ω2_cos_β_minus_φ2;
        let ω3_ω4 = ω3 * ω4;
        let cos_φ3_minus_φ4 = c3 * c4 + s3 * s4;
        let ω3_ω6 = ω3 * ω6;
        let cos_φ3_minus_φ6 = c3 * c6 + s3 * s6;
        // inertia
        let A = t9 + p.C8 * (ω3_ω4 * cos_φ3_minus_φ4)
            + p.C9 * (ω3_ω6 * cos_φ3_minus_φ6);
        let cos_β_minus_φ3 = cos_β * c3 + sin_β * s3;
        let ω3_minus_one = ω3 - 1.0;
        let t10 = ω2 + t3;
        let cos_φ2_minus_φ3 = c2 * c3 + s2 * s3;
        let t11 = p.rr * (cos_β_minus_φ3 * ω3_minus_one)
            + p.d * (ω2 * t10 * cos_φ2_minus_φ3);
        let ω2_prime = -(p.per_d * (per_sin_φ2_minus_φ3 * t11));
        let ω2_minus_one = ω2 - 1.0;
        let t12 = p.rr * (cos_β_minus_φ2 * ω2_minus_one)
            - p.ss * (ω3 * t10 * cos_φ2_minus_φ3);
        let ω3_prime = p.per_ss * (per_sin_φ2_minus_φ3 * t12);
        let t13 = t6 - t3;
        let cos_φ3_minus_δ = c3 * c_δ + s3 * s_δ;
        let t14 = p.ss * (ω3_prime * sin_φ3_minus_δ)
            + p.ss * (ω3 * t13 * cos_φ3_minus_δ);
        let t15 = ω4 + t6;
        let cos_φ4_minus_δ = c4 * c_δ + s4 * s_δ;
        let t16 = t14 - p.e * (ω4 * t15 * cos_φ4_minus_δ);
        let ω4_prime = p.per_e * (per_sin_φ4_minus_δ * t16);
        let t17 = p.two_C1 * (ω2 * ω2_prime) + p.two_C2 * (ω3 * ω3_prime)
            + p.two_C3 * (ω4 * ω4_prime);
        let ω3_prime_sin_φ3_minus_φ4 = ω3_prime * sin_φ3_minus_φ4;
        let ω3_minus_ω4 = ω3 - ω4;
        let t18 = p.ss * ω3_prime_sin_φ3_minus_φ4
            + p.ss * (ω3 * ω3_minus_ω4 * cos_φ3_minus_φ4);
        let t19 = t18 + p.zt * (ω_δ * t15 * cos_φ4_minus_δ);
        let t20 = p.per_zt * (per_sin_φ4_minus_δ * t19);
        let ω_δ_prime = -t20;
        let t21 = t8 - t3;
        let cos_φ3_minus_φ7 = c3 * c7 + s3 * s7;
        let t22 = p.ss * (ω3_prime * sin_φ3_minus_φ7)
            + p.ss * (ω3 * t21 * cos_φ3_minus_φ7);
        let t23 = ω6 + t8;
        let cos_φ6_minus_φ7 = c6 * c7 + s6 * s7;
        let t24 = t22 - p.zf * (ω6 * t23 * cos_φ6_minus_φ7);
        let ω6_prime = p.per_zf * (per_sin_φ6_minus_φ7 * t24);
        let ω3_prime_sin_φ3_minus_φ6 = ω3_prime * sin_φ3_minus_φ6;
        let ω3_minus_ω6 = ω3 - ω6;
        let t25 = p.ss * ω3_prime_sin_φ3_minus_φ6
            + p.ss * (ω3 * ω3_minus_ω6 * cos_φ3_minus_φ6);
        let t26 = t25 + p.u * (ω7 * t23 * cos_φ6_minus_φ7);
        let t27 = p.per_u * (per_sin_φ6_minus_φ7 * t26);
        let ω7_prime = -t27;
        let t28 = t17 + p.two_C4 * (ω_δ * ω_δ_prime) + p.two_C5 * (ω6 * ω6_prime)
            + p.two_C6 * (ω7 * ω7_prime);
        let ω2_prime_cos_β_minus_φ2 = ω2_prime * cos_β_minus_φ2;
        let sin_β_minus_φ2_ω2 = sin_β_minus_φ2 * ω2;
        let t29 = t28 + p.C7 * ω2_prime_cos_β_minus_φ2
            + p.C7 * (sin_β_minus_φ2_ω2 * ω2_minus_one);
        let t30 = t29 + p.C8 * (ω3_prime * ω4 * cos_φ3_minus_φ4)
            + p.C8 * (ω3 * ω4_prime * cos_φ3_minus_φ4);
        let ω3_sin_φ3_minus_φ4 = ω3 * sin_φ3_minus_φ4;
        let ω3_sin_φ3_minus_φ4_ω4 = ω3_sin_φ3_minus_φ4 * ω4;
        let t31 = t30 - p.C8 * (ω3_sin_φ3_minus_φ4_ω4 * ω3_minus_ω4)
            + p.C9 * (ω3_prime * ω6 * cos_φ3_minus_φ6);
        let ω3_sin_φ3_minus_φ6 = ω3 * sin_φ3_minus_φ6;
        let ω3_sin_φ3_minus_φ6_ω6 = ω3_sin_φ3_minus_φ6 * ω6;
        // slope of the inertia
        let dA_dβ = t31 + p.C9 * (ω3 * ω6_prime * cos_φ3_minus_φ6)
            - p.C9 * (ω3_sin_φ3_minus_φ6_ω6 * ω3_minus_ω6);
        let t32 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `lever` from the assembled one
        let φ3_minus_φ3_0 = t32.unwrap_to(turn_lever);
        // angle of `lever`
        let φ3 = p.φ3_0 + φ3_minus_φ3_0;
        let half_φ3_plus_φ3_0 = (φ3 + p.φ3_0) * 0.5;
        let (sin_half_φ3_plus_φ3_0, cos_half_φ3_plus_φ3_0) = half_φ3_plus_φ3_0
            .sin_cos();
        let sin_half_φ3_0_minus_φ3 = ((p.φ3_0 - φ3) * 0.5).sin();
        let t33 = sin_half_φ3_plus_φ3_0 * sin_half_φ3_0_minus_φ3 * 2.0;
        // change of Δx_pull
        let δx_pull = p.sc * t33
            + p.sd * (cos_half_φ3_plus_φ3_0 * sin_half_φ3_0_minus_φ3 * 2.0);
        // from end to end of `pull`
        let Δx_pull = p.Δx_pull_0 + δx_pull;
        let Δx_pull_0_plus_Δx_pull = p.Δx_pull_0 + Δx_pull;
        // change of Δy_pull
        let δy_pull = p.sc
            * (cos_half_φ3_plus_φ3_0 * ((φ3 - p.φ3_0) * 0.5).sin() * 2.0)
            + p.sd * t33;
        // from end to end of `pull`
        let Δy_pull = p.Δy_pull_0 + δy_pull;
        let Δy_pull_0_plus_Δy_pull = p.Δy_pull_0 + Δy_pull;
        let t34 = δx_pull * Δx_pull_0_plus_Δx_pull
            + δy_pull * Δy_pull_0_plus_Δy_pull;
        // length of `pull`
        let L_pull = (Δx_pull * Δx_pull + Δy_pull * Δy_pull).sqrt();
        let L_pull_0_plus_L_pull = p.L_pull_0 + L_pull;
        let per_L_pull_0_plus_L_pull = L_pull_0_plus_L_pull.recip();
        // extension of `pull`
        let e_pull = p.L_pull_0_minus_l0 + t34 * per_L_pull_0_plus_L_pull;
        let per_L_pull = L_pull.recip();
        let t35 = ω3 * t2;
        let ω3_s3 = ω3 * s3;
        let t36 = p.sc * t35 + p.sd * ω3_s3;
        let sc_ω3_s3 = p.sc * ω3_s3;
        let t37 = p.sd * t35;
        let t38 = sc_ω3_s3 - t37;
        let t39 = Δy_pull * t36 + Δx_pull * t38;
        // lever of `pull`: change of its length
        let dL_pull_dβ = -(per_L_pull * t39);
        // slope of the potential energy of springs
        let dP_s_dβ = p.c0 * (e_pull * dL_pull_dβ);
        let per_A = A.recip();
        let dδx_pull_dβ = t37 - sc_ω3_s3;
        let dδy_pull_dβ = -t36;
        let t40 = Δx_pull_0_plus_Δx_pull * dδx_pull_dβ + δx_pull * dδx_pull_dβ
            + Δy_pull_0_plus_Δy_pull * dδy_pull_dβ;
        let dL_pull_dβ_2 = (Δx_pull * dδx_pull_dβ * 2.0
            + Δy_pull * dδy_pull_dβ * 2.0) * 0.5 / L_pull;
        let t41 = t34 * (L_pull_0_plus_L_pull * L_pull_0_plus_L_pull).recip()
            * dL_pull_dβ_2;
        let de_pull_dβ = per_L_pull_0_plus_L_pull * (t40 + δy_pull * dδy_pull_dβ)
            - t41;
        let t42 = ω3_prime * t2;
        let ω3_squared_s3 = ω3_squared * s3;
        let ω3_prime_s3 = ω3_prime * s3;
        let t43 = ω3_squared * t2;
        let t44 = p.sc * t42 + p.sc * ω3_squared_s3 + p.sd * ω3_prime_s3 - p.sd * t43;
        let t45 = p.sc * ω3_prime_s3 - p.sc * t43 - p.sd * t42 - p.sd * ω3_squared_s3;
        let t46 = t36 * dδy_pull_dβ + Δy_pull * t44 + t38 * dδx_pull_dβ
            + Δx_pull * t45;
        let ddL_pull_dβ_dβ = (L_pull * L_pull).recip() * t39 * dL_pull_dβ_2
            - per_L_pull * t46;
        let ddP_s_dβ_dβ = p.c0 * (dL_pull_dβ * de_pull_dβ)
            + p.c0 * (e_pull * ddL_pull_dβ_dβ);
        let t47 = (sin_φ2_minus_φ3 * sin_φ2_minus_φ3).recip() * t10
            * cos_φ2_minus_φ3;
        let t48 = p.rr * (sin_β_minus_φ3 * (ω3_minus_one * ω3_minus_one))
            + p.rr * (cos_β_minus_φ3 * ω3_prime);
        let t49 = t10 * cos_φ2_minus_φ3;
        let ω2_prime_minus_ω3_prime = ω2_prime - ω3_prime;
        let t50 = t48 + p.d * (t49 * ω2_prime)
            + p.d * (ω2 * cos_φ2_minus_φ3 * ω2_prime_minus_ω3_prime);
        let t51 = t10 * t10;
        let t52 = p.per_d
            * (per_sin_φ2_minus_φ3 * (t50 - p.d * (sin_φ2_minus_φ3 * ω2 * t51)));
        let dω2_prime_dβ = p.per_d * (t47 * t11) - t52;
        let ω2_minus_one_squared = ω2_minus_one * ω2_minus_one;
        let t53 = p.rr * (sin_β_minus_φ2 * ω2_minus_one_squared)
            + p.rr * ω2_prime_cos_β_minus_φ2;
        let t54 = t53 - p.ss * (t49 * ω3_prime)
            - p.ss * (ω3 * cos_φ2_minus_φ3 * ω2_prime_minus_ω3_prime);
        let t55 = p.per_ss
            * (per_sin_φ2_minus_φ3 * (t54 + p.ss * (sin_φ2_minus_φ3 * ω3 * t51)));
        let dω3_prime_dβ = t55 - p.per_ss * (t47 * t12);
        let t56 = (p.C1 * (ω2_prime * ω2_prime) + p.C1 * (ω2 * dω2_prime_dβ)) * 2.0
            + (p.C2 * (ω3_prime * ω3_prime) + p.C2 * (ω3 * dω3_prime_dβ)) * 2.0;
        let t57 = p.ss * (sin_φ3_minus_δ * dω3_prime_dβ)
            + p.two_ss * (ω3_prime * t13 * cos_φ3_minus_δ);
        let t58 = t57 + p.ss * (ω3 * cos_φ3_minus_δ * (ω3_prime + t20))
            - p.ss * (ω3 * sin_φ3_minus_δ * (t13 * t13));
        let t59 = t15 * cos_φ4_minus_δ;
        let t60 = ω4_prime + t20;
        let t61 = t15 * t15;
        let t62 = t58 - p.e * (t59 * ω4_prime) - p.e * (ω4 * cos_φ4_minus_δ * t60)
            + p.e * (sin_φ4_minus_δ * ω4 * t61);
        let t63 = (sin_φ4_minus_δ * sin_φ4_minus_δ).recip() * t15 * cos_φ4_minus_δ;
        let dω4_prime_dβ = p.per_e * (per_sin_φ4_minus_δ * t62)
            - p.per_e * (t63 * t16);
        let t64 = t56
            + (p.C3 * (ω4_prime * ω4_prime) + p.C3 * (ω4 * dω4_prime_dβ)) * 2.0;
        let t65 = p.ss * (sin_φ3_minus_φ4 * dω3_prime_dβ)
            + p.two_ss * (ω3_prime * ω3_minus_ω4 * cos_φ3_minus_φ4);
        let ω3_cos_φ3_minus_φ4 = ω3 * cos_φ3_minus_φ4;
        let ω3_prime_minus_ω4_prime = ω3_prime - ω4_prime;
        let ω3_minus_ω4_squared = ω3_minus_ω4 * ω3_minus_ω4;
        let t66 = t65 + p.ss * (ω3_cos_φ3_minus_φ4 * ω3_prime_minus_ω4_prime)
            - p.ss * (ω3_sin_φ3_minus_φ4 * ω3_minus_ω4_squared);
        let t67 = t66 + p.zt * (t59 * ω_δ_prime)
            + p.zt * (ω_δ * cos_φ4_minus_δ * t60);
        let t68 = p.per_zt
            * (per_sin_φ4_minus_δ * (t67 - p.zt * (sin_φ4_minus_δ * ω_δ * t61)));
        let dω_δ_prime_dβ = p.per_zt * (t63 * t19) - t68;
        let t69 = (p.C4 * (ω_δ_prime * ω_δ_prime)
            + p.C4 * (ω_δ * dω_δ_prime_dβ)) * 2.0;
        let t70 = p.ss * (sin_φ3_minus_φ7 * dω3_prime_dβ)
            + p.two_ss * (ω3_prime * t21 * cos_φ3_minus_φ7);
        let t71 = t70 + p.ss * (ω3 * cos_φ3_minus_φ7 * (ω3_prime + t27))
            - p.ss * (ω3 * sin_φ3_minus_φ7 * (t21 * t21));
        let t72 = t23 * cos_φ6_minus_φ7;
        let t73 = ω6_prime + t27;
        let t74 = t71 - p.zf * (t72 * ω6_prime)
            - p.zf * (ω6 * cos_φ6_minus_φ7 * t73);
        let t75 = t23 * t23;
        let t76 = p.per_zf
            * (per_sin_φ6_minus_φ7 * (t74 + p.zf * (sin_φ6_minus_φ7 * ω6 * t75)));
        let t77 = (sin_φ6_minus_φ7 * sin_φ6_minus_φ7).recip() * t23
            * cos_φ6_minus_φ7;
        let dω6_prime_dβ = t76 - p.per_zf * (t77 * t24);
        let t78 = t64 + t69
            + (p.C5 * (ω6_prime * ω6_prime) + p.C5 * (ω6 * dω6_prime_dβ)) * 2.0;
        let t79 = p.ss * (sin_φ3_minus_φ6 * dω3_prime_dβ)
            + p.two_ss * (ω3_prime * ω3_minus_ω6 * cos_φ3_minus_φ6);
        let ω3_cos_φ3_minus_φ6 = ω3 * cos_φ3_minus_φ6;
        let ω3_prime_minus_ω6_prime = ω3_prime - ω6_prime;
        let ω3_minus_ω6_squared = ω3_minus_ω6 * ω3_minus_ω6;
        let t80 = t79 + p.ss * (ω3_cos_φ3_minus_φ6 * ω3_prime_minus_ω6_prime)
            - p.ss * (ω3_sin_φ3_minus_φ6 * ω3_minus_ω6_squared);
        let t81 = t80 + p.u * (t72 * ω7_prime) + p.u * (ω7 * cos_φ6_minus_φ7 * t73);
        let t82 = p.per_u
            * (per_sin_φ6_minus_φ7 * (t81 - p.u * (sin_φ6_minus_φ7 * ω7 * t75)));
        let dω7_prime_dβ = p.per_u * (t77 * t26) - t82;
        let t83 = t78
            + (p.C6 * (ω7_prime * ω7_prime) + p.C6 * (ω7 * dω7_prime_dβ)) * 2.0;
        let t84 = t83 + p.C7 * (cos_β_minus_φ2 * dω2_prime_dβ)
            + p.two_C7 * (sin_β_minus_φ2 * ω2_prime * ω2_minus_one);
        let t85 = t84 + p.C7 * (sin_β_minus_φ2_ω2 * ω2_prime)
            - p.C7 * (ω2_cos_β_minus_φ2 * ω2_minus_one_squared);
        let t86 = t85 + p.C8 * (ω4 * cos_φ3_minus_φ4 * dω3_prime_dβ)
            + p.two_C8 * (ω3_prime * ω4_prime * cos_φ3_minus_φ4);
        let t87 = t86 - p.two_C8 * (ω3_prime_sin_φ3_minus_φ4 * ω4 * ω3_minus_ω4)
            + p.C8 * (ω3_cos_φ3_minus_φ4 * dω4_prime_dβ);
        let t88 = t87 - p.two_C8 * (ω3_sin_φ3_minus_φ4 * ω4_prime * ω3_minus_ω4)
            - p.C8 * (ω3_ω4 * ω3_minus_ω4_squared * cos_φ3_minus_φ4);
        let t89 = t88 - p.C8 * (ω3_sin_φ3_minus_φ4_ω4 * ω3_prime_minus_ω4_prime)
            + p.C9 * (ω6 * cos_φ3_minus_φ6 * dω3_prime_dβ);
        let t90 = t89 + p.two_C9 * (ω3_prime * ω6_prime * cos_φ3_minus_φ6)
            - p.two_C9 * (ω3_prime_sin_φ3_minus_φ6 * ω6 * ω3_minus_ω6);
        let t91 = t90 + p.C9 * (ω3_cos_φ3_minus_φ6 * dω6_prime_dβ)
            - p.two_C9 * (ω3_sin_φ3_minus_φ6 * ω6_prime * ω3_minus_ω6);
        let ddA_dβ_dβ = t91
            - p.C9 * (ω3_ω6 * ω3_minus_ω6_squared * cos_φ3_minus_φ6)
            - p.C9 * (ω3_sin_φ3_minus_φ6_ω6 * ω3_prime_minus_ω6_prime);
        // ── state ──
        let dβ_squared = dβ * dβ;
        let t92 = (A * A).recip() * dA_dβ
            * (dP_s_dβ - p.mom + dA_dβ * 0.5 * dβ_squared);
        let dddβ_dβ = t92 - per_A * (ddP_s_dβ_dβ + ddA_dβ_dβ * 0.5 * dβ_squared);
        let dddβ_ddβ = -(per_A * dA_dβ * dβ);
        result[1] = T::from_f64(1.0);
        result[2] = dddβ_dβ;
        result[3] = dddβ_ddβ;
    }
    /// The model's outputs.
    #[inline(always)]
    pub fn outputs<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 6],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 14],
    ) {
        let β = x[0];
        let dβ = x[1];
        let turn_coupler = d[0];
        let turn_lever = d[1];
        let turn_upper = d[2];
        let turn_upper_arm = d[3];
        let turn_lower = d[4];
        let turn_lower_arm = d[5];
        // ── configuration ──
        let (sin_β, cos_β) = β.sin_cos();
        let Y1 = p.yb - p.rr * sin_β;
        // vector that is left to close crank–coupler–lever
        let X1 = p.xb - p.rr * cos_β;
        // its length squared
        let D1 = X1 * X1 + Y1 * Y1;
        let per_D1 = D1.recip();
        let κ1 = per_D1 * (p.constant1 + D1) * 0.5;
        let Y1_κ1 = Y1 * κ1;
        let t1 = per_D1
            * (-((D1 - p.d_minus_ss_squared) * (D1 - p.d_plus_ss_squared))).sqrt();
        let η1 = p.half_ε1 * t1;
        let X1_η1 = X1 * η1;
        let s2 = -(p.per_d * (Y1_κ1 + X1_η1));
        let X1_κ1 = X1 * κ1;
        let Y1_η1 = Y1 * η1;
        let c2 = -(p.per_d * (X1_κ1 - Y1_η1));
        let t2 = (p.c2_0 * s2 - p.s2_0 * c2).atan2(p.c2_0 * c2 + p.s2_0 * s2);
        // angle of `coupler` from the assembled one
        let φ2_minus_φ2_0 = t2.unwrap_to(turn_coupler);
        // angle of `coupler`
        let φ2 = p.φ2_0 + φ2_minus_φ2_0;
        let s3 = p.per_ss * (Y1_κ1 - Y1 + X1_η1);
        let t3 = p.per_ss * (X1 - X1_κ1 + Y1_η1);
        let c3 = -t3;
        let t4 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `lever` from the assembled one
        let φ3_minus_φ3_0 = t4.unwrap_to(turn_lever);
        // angle of `lever`
        let φ3 = p.φ3_0 + φ3_minus_φ3_0;
        let Y2 = p.ya_minus_yb - p.ss * s3;
        // vector that is left to close lever–upper–upper_arm
        let X2 = p.xa_minus_xb + p.ss * t3;
        // its length squared
        let D2 = X2 * X2 + Y2 * Y2;
        let per_D2 = D2.recip();
        let κ2 = per_D2 * (p.constant2 + D2) * 0.5;
        let Y2_κ2 = Y2 * κ2;
        let t5 = per_D2
            * (-((D2 - p.e_minus_zt_squared) * (D2 - p.e_plus_zt_squared))).sqrt();
        let η2 = p.half_ε2 * t5;
        let X2_η2 = X2 * η2;
        let s4 = -(p.per_e * (Y2_κ2 + X2_η2));
        let X2_κ2 = X2 * κ2;
        let Y2_η2 = Y2 * η2;
        let c4 = -(p.per_e * (X2_κ2 - Y2_η2));
        let t6 = (p.c4_0 * s4 - p.s4_0 * c4).atan2(p.c4_0 * c4 + p.s4_0 * s4);
        // angle of `upper` from the assembled one
        let φ4_minus_φ4_0 = t6.unwrap_to(turn_upper);
        // angle of `upper`
        let φ4 = p.φ4_0 + φ4_minus_φ4_0;
        let s_δ = p.per_zt * (Y2_κ2 - Y2 + X2_η2);
        let c_δ = -(p.per_zt * (X2 - X2_κ2 + Y2_η2));
        let t7 = (p.c_δ_0 * s_δ - p.s_δ_0 * c_δ)
            .atan2(p.c_δ_0 * c_δ + p.s_δ_0 * s_δ);
        // angle of `upper_arm` from the assembled one
        let δ_minus_δ_0 = t7.unwrap_to(turn_upper_arm);
        // angle of `upper_arm`
        let δ = p.δ_0 + δ_minus_δ_0;
        let κ3 = per_D2 * (p.constant3 + D2) * 0.5;
        let Y2_κ3 = Y2 * κ3;
        let t8 = per_D2
            * (-((D2 - p.zf_minus_u_squared) * (D2 - p.zf_plus_u_squared))).sqrt();
        let η3 = p.half_ε3 * t8;
        let X2_η3 = X2 * η3;
        let s6 = -(p.per_zf * (Y2_κ3 + X2_η3));
        let X2_κ3 = X2 * κ3;
        let Y2_η3 = Y2 * η3;
        let c6 = -(p.per_zf * (X2_κ3 - Y2_η3));
        let t9 = (p.c6_0 * s6 - p.s6_0 * c6).atan2(p.c6_0 * c6 + p.s6_0 * s6);
        // angle of `lower` from the assembled one
        let φ6_minus_φ6_0 = t9.unwrap_to(turn_lower);
        // angle of `lower`
        let φ6 = p.φ6_0 + φ6_minus_φ6_0;
        let s7 = p.per_u * (Y2_κ3 - Y2 + X2_η3);
        let c7 = -(p.per_u * (X2 - X2_κ3 + Y2_η3));
        let t10 = (p.c7_0 * s7 - p.s7_0 * c7).atan2(p.c7_0 * c7 + p.s7_0 * s7);
        // angle of `lower_arm` from the assembled one
        let φ7_minus_φ7_0 = t10.unwrap_to(turn_lower_arm);
        // angle of `lower_arm`
        let φ7 = p.φ7_0 + φ7_minus_φ7_0;
        let sin_φ2_minus_φ3 = s2 * c3 - c2 * s3;
        let per_sin_φ2_minus_φ3 = sin_φ2_minus_φ3.recip();
        let sin_β_minus_φ3 = sin_β * c3 - cos_β * s3;
        // rate of the angle of `coupler` per unit rate of `crank`
        let ω2 = p.rr_per_d * (per_sin_φ2_minus_φ3 * sin_β_minus_φ3);
        let sin_β_minus_φ2 = sin_β * c2 - cos_β * s2;
        // rate of the angle of `lever` per unit rate of `crank`
        let ω3 = -(p.rr_per_ss * (per_sin_φ2_minus_φ3 * sin_β_minus_φ2));
        let sin_φ4_minus_δ = s4 * c_δ - c4 * s_δ;
        let ω3_per_sin_φ4_minus_δ = ω3 * sin_φ4_minus_δ.recip();
        let sin_φ3_minus_δ = s3 * c_δ - c3 * s_δ;
        // rate of the angle of `upper` per unit rate of `crank`
        let ω4 = p.ss_per_e * (ω3_per_sin_φ4_minus_δ * sin_φ3_minus_δ);
        let sin_φ3_minus_φ4 = s3 * c4 - c3 * s4;
        // rate of the angle of `upper_arm` per unit rate of `crank`
        let ω_δ = -(p.ss_per_zt * (ω3_per_sin_φ4_minus_δ * sin_φ3_minus_φ4));
        let sin_φ6_minus_φ7 = s6 * c7 - c6 * s7;
        let ω3_per_sin_φ6_minus_φ7 = ω3 * sin_φ6_minus_φ7.recip();
        let sin_φ3_minus_φ7 = s3 * c7 - c3 * s7;
        // rate of the angle of `lower` per unit rate of `crank`
        let ω6 = p.ss_per_zf * (ω3_per_sin_φ6_minus_φ7 * sin_φ3_minus_φ7);
        let sin_φ3_minus_φ6 = s3 * c6 - c3 * s6;
        // rate of the angle of `lower_arm` per unit rate of `crank`
        let ω7 = -(p.ss_per_u * (ω3_per_sin_φ6_minus_φ7 * sin_φ3_minus_φ6));
        // ── state ──
        let coupler_rate = ω2 * dβ;
        let lever_rate = ω3 * dβ;
        let upper_rate = ω4 * dβ;
        let upper_arm_rate = ω_δ * dβ;
        let lower_rate = ω6 * dβ;
        let lower_arm_rate = ω7 * dβ;
        result[0] = β;
        result[1] = φ2 - β;
        result[2] = φ3 + 1.5707963267948966;
        result[3] = φ4 + 1.5707963267948966 - δ;
        result[4] = δ;
        result[5] = φ6 - 1.5707963267948966 - φ7;
        result[6] = φ7 + 1.5707963267948966;
        result[7] = dβ;
        result[8] = coupler_rate - dβ;
        result[9] = lever_rate;
        result[10] = upper_rate - upper_arm_rate;
        result[11] = upper_arm_rate;
        result[12] = lower_rate - lower_arm_rate;
        result[13] = lower_arm_rate;
    }
    /// Kinetic and potential energy in J, dissipated and supplied power in W.
    #[inline(always)]
    pub fn energy<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 6],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let β = x[0];
        let dβ = x[1];
        let turn_lever = d[1];
        // ── configuration ──
        let (sin_β, cos_β) = β.sin_cos();
        let Y1 = p.yb - p.rr * sin_β;
        // vector that is left to close crank–coupler–lever
        let X1 = p.xb - p.rr * cos_β;
        // its length squared
        let D1 = X1 * X1 + Y1 * Y1;
        let per_D1 = D1.recip();
        let κ1 = per_D1 * (p.constant1 + D1) * 0.5;
        let Y1_κ1 = Y1 * κ1;
        let t1 = per_D1
            * (-((D1 - p.d_minus_ss_squared) * (D1 - p.d_plus_ss_squared))).sqrt();
        let η1 = p.half_ε1 * t1;
        let X1_η1 = X1 * η1;
        let s2 = -(p.per_d * (Y1_κ1 + X1_η1));
        let X1_κ1 = X1 * κ1;
        let Y1_η1 = Y1 * η1;
        let t2 = p.per_ss * (X1 - X1_κ1 + Y1_η1);
        let c3 = -t2;
        let c2 = -(p.per_d * (X1_κ1 - Y1_η1));
        let s3 = p.per_ss * (Y1_κ1 - Y1 + X1_η1);
        let sin_φ2_minus_φ3 = s2 * c3 - c2 * s3;
        let per_sin_φ2_minus_φ3 = sin_φ2_minus_φ3.recip();
        let sin_β_minus_φ3 = sin_β * c3 - cos_β * s3;
        // rate of the angle of `coupler` per unit rate of `crank`
        let ω2 = p.rr_per_d * (per_sin_φ2_minus_φ3 * sin_β_minus_φ3);
        let sin_β_minus_φ2 = sin_β * c2 - cos_β * s2;
        // rate of the angle of `lever` per unit rate of `crank`
        let ω3 = -(p.rr_per_ss * (per_sin_φ2_minus_φ3 * sin_β_minus_φ2));
        let Y2 = p.ya_minus_yb - p.ss * s3;
        // vector that is left to close lever–upper–upper_arm
        let X2 = p.xa_minus_xb + p.ss * t2;
        // its length squared
        let D2 = X2 * X2 + Y2 * Y2;
        let per_D2 = D2.recip();
        let κ2 = per_D2 * (p.constant2 + D2) * 0.5;
        let Y2_κ2 = Y2 * κ2;
        let t3 = per_D2
            * (-((D2 - p.e_minus_zt_squared) * (D2 - p.e_plus_zt_squared))).sqrt();
        let η2 = p.half_ε2 * t3;
        let X2_η2 = X2 * η2;
        let s4 = -(p.per_e * (Y2_κ2 + X2_η2));
        let X2_κ2 = X2 * κ2;
        let Y2_η2 = Y2 * η2;
        let c_δ = -(p.per_zt * (X2 - X2_κ2 + Y2_η2));
        let c4 = -(p.per_e * (X2_κ2 - Y2_η2));
        let s_δ = p.per_zt * (Y2_κ2 - Y2 + X2_η2);
        let sin_φ4_minus_δ = s4 * c_δ - c4 * s_δ;
        let ω3_per_sin_φ4_minus_δ = ω3 * sin_φ4_minus_δ.recip();
        let sin_φ3_minus_δ = s3 * c_δ - c3 * s_δ;
        // rate of the angle of `upper` per unit rate of `crank`
        let ω4 = p.ss_per_e * (ω3_per_sin_φ4_minus_δ * sin_φ3_minus_δ);
        let sin_φ3_minus_φ4 = s3 * c4 - c3 * s4;
        // rate of the angle of `upper_arm` per unit rate of `crank`
        let ω_δ = -(p.ss_per_zt * (ω3_per_sin_φ4_minus_δ * sin_φ3_minus_φ4));
        let t4 = p.C0 + p.C1 * (ω2 * ω2) + p.C2 * (ω3 * ω3) + p.C3 * (ω4 * ω4)
            + p.C4 * (ω_δ * ω_δ);
        let κ3 = per_D2 * (p.constant3 + D2) * 0.5;
        let Y2_κ3 = Y2 * κ3;
        let t5 = per_D2
            * (-((D2 - p.zf_minus_u_squared) * (D2 - p.zf_plus_u_squared))).sqrt();
        let η3 = p.half_ε3 * t5;
        let X2_η3 = X2 * η3;
        let s6 = -(p.per_zf * (Y2_κ3 + X2_η3));
        let X2_κ3 = X2 * κ3;
        let Y2_η3 = Y2 * η3;
        let c7 = -(p.per_u * (X2 - X2_κ3 + Y2_η3));
        let c6 = -(p.per_zf * (X2_κ3 - Y2_η3));
        let s7 = p.per_u * (Y2_κ3 - Y2 + X2_η3);
        let sin_φ6_minus_φ7 = s6 * c7 - c6 * s7;
        let ω3_per_sin_φ6_minus_φ7 = ω3 * sin_φ6_minus_φ7.recip();
        let sin_φ3_minus_φ7 = s3 * c7 - c3 * s7;
        // rate of the angle of `lower` per unit rate of `crank`
        let ω6 = p.ss_per_zf * (ω3_per_sin_φ6_minus_φ7 * sin_φ3_minus_φ7);
        let sin_φ3_minus_φ6 = s3 * c6 - c3 * s6;
        // rate of the angle of `lower_arm` per unit rate of `crank`
        let ω7 = -(p.ss_per_u * (ω3_per_sin_φ6_minus_φ7 * sin_φ3_minus_φ6));
        let cos_β_minus_φ2 = cos_β * c2 + sin_β * s2;
        let t6 = t4 + p.C5 * (ω6 * ω6) + p.C6 * (ω7 * ω7)
            + p.C7 * (ω2 * cos_β_minus_φ2);
        let cos_φ3_minus_φ4 = c3 * c4 + s3 * s4;
        let cos_φ3_minus_φ6 = c3 * c6 + s3 * s6;
        // inertia
        let A = t6 + p.C8 * (ω3 * ω4 * cos_φ3_minus_φ4)
            + p.C9 * (ω3 * ω6 * cos_φ3_minus_φ6);
        let t7 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `lever` from the assembled one
        let φ3_minus_φ3_0 = t7.unwrap_to(turn_lever);
        // angle of `lever`
        let φ3 = p.φ3_0 + φ3_minus_φ3_0;
        let half_φ3_plus_φ3_0 = (φ3 + p.φ3_0) * 0.5;
        let (sin_half_φ3_plus_φ3_0, cos_half_φ3_plus_φ3_0) = half_φ3_plus_φ3_0
            .sin_cos();
        let sin_half_φ3_0_minus_φ3 = ((p.φ3_0 - φ3) * 0.5).sin();
        let t8 = sin_half_φ3_plus_φ3_0 * sin_half_φ3_0_minus_φ3 * 2.0;
        // change of Δx_pull
        let δx_pull = p.sc * t8
            + p.sd * (cos_half_φ3_plus_φ3_0 * sin_half_φ3_0_minus_φ3 * 2.0);
        // from end to end of `pull`
        let Δx_pull = p.Δx_pull_0 + δx_pull;
        // change of Δy_pull
        let δy_pull = p.sc
            * (cos_half_φ3_plus_φ3_0 * ((φ3 - p.φ3_0) * 0.5).sin() * 2.0)
            + p.sd * t8;
        // from end to end of `pull`
        let Δy_pull = p.Δy_pull_0 + δy_pull;
        let t9 = δx_pull * (p.Δx_pull_0 + Δx_pull)
            + δy_pull * (p.Δy_pull_0 + Δy_pull);
        // length of `pull`
        let L_pull = (Δx_pull * Δx_pull + Δy_pull * Δy_pull).sqrt();
        // extension of `pull`
        let e_pull = p.L_pull_0_minus_l0 + t9 * (p.L_pull_0 + L_pull).recip();
        result[0] = A * 0.5 * (dβ * dβ);
        result[1] = p.half_c0 * (e_pull * e_pull);
        result[2] = T::from_f64(0.0);
        result[3] = p.mom * dβ;
    }
    /// Event functions: each event happens where its function rises through zero.
    #[inline(always)]
    pub fn events<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 6],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 0],
    ) {}
    /// For each loop a number that is positive where it closes and zero at a dead point.
    #[inline(always)]
    pub fn closures<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 6],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 3],
    ) {
        let β = x[0];
        let [.., t1, t2, t3] = if p.table_of_β.covers(β) {
            p.table_of_β.polynomials(β)
        } else {
            p.table_of_β.where_covered(β, functions_of_β(β, d, p))
        };
        result[0] = t1;
        result[1] = t2;
        result[2] = t3;
    }
    /// The discrete state after an accepted step that ends in `x`; entries that stay are left as they are.
    #[inline(always)]
    pub fn accept<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 6],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 6],
    ) {
        let β = x[0];
        let [.., φ3_minus_φ3_0, φ2_minus_φ2_0, φ4_minus_φ4_0, δ_minus_δ_0,
        φ6_minus_φ6_0, φ7_minus_φ7_0, _, _, _] = if p.table_of_β.covers(β) {
            p.table_of_β.polynomials(β)
        } else {
            p.table_of_β.where_covered(β, functions_of_β(β, d, p))
        };
        result[0] = φ2_minus_φ2_0;
        result[1] = φ3_minus_φ3_0;
        result[2] = φ4_minus_φ4_0;
        result[3] = δ_minus_δ_0;
        result[4] = φ6_minus_φ6_0;
        result[5] = φ7_minus_φ7_0;
    }
    /// Time in s of each drive's next kink.
    #[inline(always)]
    pub fn next_kinks<T: Real>(d: &[T; 6], p: &Prepared<T>, result: &mut [T; 0]) {}
    /// The discrete state after drive `index` passed its kink; entries that stay are left as they are.
    #[inline(always)]
    pub fn pass_kink<T: Real>(
        index: usize,
        d: &[T; 6],
        p: &Prepared<T>,
        result: &mut [T; 6],
    ) {}
    /// The state after event `index`; entries that stay are left as they are.
    #[inline(always)]
    pub fn pass_event<T: Real>(
        index: usize,
        t: T,
        x: &[T; 2],
        d: &[T; 6],
        u: &[T; 0],
        p: &Prepared<T>,
        x_after: &mut [T; 2],
        d_after: &mut [T; 6],
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
            3
        }
        fn closures(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], values: &mut [f64]) {
            closures(t, array(x), array(d), array(u), self, array_mut(values));
        }
        fn loop_name(&self, index: usize) -> &str {
            const NAMES: [&str; 3] = [
                "crank–coupler–lever",
                "lever–upper–upper_arm",
                "lever–lower–lower_arm",
            ];
            NAMES[index]
        }
        fn tables(&self) -> Vec<TableReport> {
            [self.table_of_β.report(0)].into_iter().flatten().collect()
        }
        fn is_outside_tables(&self, x: &[f64]) -> bool {
            self.table_of_β.is_left_by(x[0])
        }
        fn take_plain_steps(&self, steps: &mut PlainSteps<'_>) {
            steps.on_lanes(self);
        }
    }
    impl LaneSystem for Prepared<f64> {
        type InLanes<L: Lanes> = Prepared<L>;
        type States<L: Lanes> = [L; 2];
        type Discretes<L: Lanes> = [L; 6];
        type Loops<L: Lanes> = [L; 3];
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
            L::from_f64(-1.0).larger(lanes.table_of_β.left_by(x[0]))
        }
    }
    /// Every quantity with a name: params, states, discrete states, inputs, outputs.
    pub static VARIABLES: [Variable; 65] = [
        Variable {
            name: Cow::Borrowed("rr"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("crank"),
            causality: Causality::Parameter,
            start: Some(0.007),
        },
        Variable {
            name: Cow::Borrowed("ra"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("crank"),
            causality: Causality::Parameter,
            start: Some(0.00092),
        },
        Variable {
            name: Cow::Borrowed("m1"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("crank"),
            causality: Causality::Parameter,
            start: Some(0.04325),
        },
        Variable {
            name: Cow::Borrowed("I1"),
            unit: Cow::Borrowed("kg*m^2"),
            meaning: Cow::Borrowed("crank"),
            causality: Causality::Parameter,
            start: Some(2.194e-6),
        },
        Variable {
            name: Cow::Borrowed("d"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("coupler"),
            causality: Causality::Parameter,
            start: Some(0.028),
        },
        Variable {
            name: Cow::Borrowed("da"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("coupler"),
            causality: Causality::Parameter,
            start: Some(0.0115),
        },
        Variable {
            name: Cow::Borrowed("m2"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("coupler"),
            causality: Causality::Parameter,
            start: Some(0.00365),
        },
        Variable {
            name: Cow::Borrowed("I2"),
            unit: Cow::Borrowed("kg*m^2"),
            meaning: Cow::Borrowed("coupler"),
            causality: Causality::Parameter,
            start: Some(4.41e-7),
        },
        Variable {
            name: Cow::Borrowed("ss"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("lever"),
            causality: Causality::Parameter,
            start: Some(0.035),
        },
        Variable {
            name: Cow::Borrowed("sa"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("lever"),
            causality: Causality::Parameter,
            start: Some(0.01874),
        },
        Variable {
            name: Cow::Borrowed("sb"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("lever"),
            causality: Causality::Parameter,
            start: Some(0.01043),
        },
        Variable {
            name: Cow::Borrowed("m3"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("lever"),
            causality: Causality::Parameter,
            start: Some(0.02373),
        },
        Variable {
            name: Cow::Borrowed("I3"),
            unit: Cow::Borrowed("kg*m^2"),
            meaning: Cow::Borrowed("lever"),
            causality: Causality::Parameter,
            start: Some(5.255e-6),
        },
        Variable {
            name: Cow::Borrowed("sc"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("D on the lever"),
            causality: Causality::Parameter,
            start: Some(0.018),
        },
        Variable {
            name: Cow::Borrowed("sd"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("D on the lever"),
            causality: Causality::Parameter,
            start: Some(0.02),
        },
        Variable {
            name: Cow::Borrowed("e"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("upper connecting link"),
            causality: Causality::Parameter,
            start: Some(0.02),
        },
        Variable {
            name: Cow::Borrowed("ea"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("upper connecting link"),
            causality: Causality::Parameter,
            start: Some(0.01421),
        },
        Variable {
            name: Cow::Borrowed("m4"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("upper connecting link"),
            causality: Causality::Parameter,
            start: Some(0.00706),
        },
        Variable {
            name: Cow::Borrowed("I4"),
            unit: Cow::Borrowed("kg*m^2"),
            meaning: Cow::Borrowed("upper connecting link"),
            causality: Causality::Parameter,
            start: Some(5.667e-7),
        },
        Variable {
            name: Cow::Borrowed("zt"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("upper arm"),
            causality: Causality::Parameter,
            start: Some(0.04),
        },
        Variable {
            name: Cow::Borrowed("ta"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("upper arm"),
            causality: Causality::Parameter,
            start: Some(0.02308),
        },
        Variable {
            name: Cow::Borrowed("tb"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("upper arm"),
            causality: Causality::Parameter,
            start: Some(0.00916),
        },
        Variable {
            name: Cow::Borrowed("m5"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("upper arm"),
            causality: Causality::Parameter,
            start: Some(0.0705),
        },
        Variable {
            name: Cow::Borrowed("I5"),
            unit: Cow::Borrowed("kg*m^2"),
            meaning: Cow::Borrowed("upper arm"),
            causality: Causality::Parameter,
            start: Some(1.169e-5),
        },
        Variable {
            name: Cow::Borrowed("zf"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("lower connecting link"),
            causality: Causality::Parameter,
            start: Some(0.02),
        },
        Variable {
            name: Cow::Borrowed("fa"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("lower connecting link"),
            causality: Causality::Parameter,
            start: Some(0.01421),
        },
        Variable {
            name: Cow::Borrowed("m6"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("lower connecting link"),
            causality: Causality::Parameter,
            start: Some(0.00706),
        },
        Variable {
            name: Cow::Borrowed("I6"),
            unit: Cow::Borrowed("kg*m^2"),
            meaning: Cow::Borrowed("lower connecting link"),
            causality: Causality::Parameter,
            start: Some(5.667e-7),
        },
        Variable {
            name: Cow::Borrowed("u"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("lower arm"),
            causality: Causality::Parameter,
            start: Some(0.04),
        },
        Variable {
            name: Cow::Borrowed("ua"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("lower arm"),
            causality: Causality::Parameter,
            start: Some(0.01228),
        },
        Variable {
            name: Cow::Borrowed("ub"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("lower arm"),
            causality: Causality::Parameter,
            start: Some(0.00449),
        },
        Variable {
            name: Cow::Borrowed("m7"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("lower arm"),
            causality: Causality::Parameter,
            start: Some(0.05498),
        },
        Variable {
            name: Cow::Borrowed("I7"),
            unit: Cow::Borrowed("kg*m^2"),
            meaning: Cow::Borrowed("lower arm"),
            causality: Causality::Parameter,
            start: Some(1.912e-5),
        },
        Variable {
            name: Cow::Borrowed("xa"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("fixed points"),
            causality: Causality::Parameter,
            start: Some(-0.06934),
        },
        Variable {
            name: Cow::Borrowed("ya"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("fixed points"),
            causality: Causality::Parameter,
            start: Some(-0.00227),
        },
        Variable {
            name: Cow::Borrowed("xb"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("fixed points"),
            causality: Causality::Parameter,
            start: Some(-0.03635),
        },
        Variable {
            name: Cow::Borrowed("yb"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("fixed points"),
            causality: Causality::Parameter,
            start: Some(0.03273),
        },
        Variable {
            name: Cow::Borrowed("xc"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("fixed points"),
            causality: Causality::Parameter,
            start: Some(0.014),
        },
        Variable {
            name: Cow::Borrowed("yc"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("fixed points"),
            causality: Causality::Parameter,
            start: Some(0.072),
        },
        Variable {
            name: Cow::Borrowed("c0"),
            unit: Cow::Borrowed("N/m"),
            meaning: Cow::Borrowed("stiffness of the spring"),
            causality: Causality::Parameter,
            start: Some(4530.0),
        },
        Variable {
            name: Cow::Borrowed("l0"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("its free length"),
            causality: Causality::Parameter,
            start: Some(0.07785),
        },
        Variable {
            name: Cow::Borrowed("mom"),
            unit: Cow::Borrowed("N*m"),
            meaning: Cow::Borrowed("torque on the crank"),
            causality: Causality::Parameter,
            start: Some(0.033),
        },
        Variable {
            name: Cow::Borrowed("beta0"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("crank at the start"),
            causality: Causality::Parameter,
            start: Some(-0.06171389001427645),
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
            name: Cow::Borrowed("lever.turn"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed(
                "angle of `lever` from the assembled one at the last accepted step",
            ),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("upper.turn"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed(
                "angle of `upper` from the assembled one at the last accepted step",
            ),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("upper_arm.turn"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed(
                "angle of `upper_arm` from the assembled one at the last accepted step",
            ),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("lower.turn"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed(
                "angle of `lower` from the assembled one at the last accepted step",
            ),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("lower_arm.turn"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed(
                "angle of `lower_arm` from the assembled one at the last accepted step",
            ),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("beta"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("angle of the crank"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("theta"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("of the coupler, from the crank"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("gamma"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("of the lever"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("phi"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("of the upper connecting link, from its arm"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("delta"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("of the upper arm"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("Omega"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("of the lower connecting link, from its arm"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("epsilon"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("of the lower arm"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("dbeta"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("dtheta"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("dgamma"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("dphi"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("ddelta"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("dOmega"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("depsilon"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
    ];
    static PARAMS: &[Variable] = VARIABLES.split_at(0).1.split_at(43).0;
    static STATES: &[Variable] = VARIABLES.split_at(43).1.split_at(2).0;
    static DISCRETES: &[Variable] = VARIABLES.split_at(45).1.split_at(6).0;
    static INPUTS: &[Variable] = VARIABLES.split_at(51).1.split_at(0).0;
    static OUTPUTS: &[Variable] = VARIABLES.split_at(51).1.split_at(14).0;
    /// Positions of the coordinates and of their rates among the states.
    static COORDINATES: [(usize, usize); 1] = [(0, 1)];
    static TURNING: [usize; 6] = [0, 1, 2, 3, 4, 5];
    static FAILURES: [Failure; 28] = [
        Failure {
            message: Cow::Borrowed("the length of `crank` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 27,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link crank      from O to F { length = rr, angle = beta0 exact, mass = m1, com = (ra, 0 mm), inertia = I1, symbol = β }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `crank` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 27,
                column: 65,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link crank      from O to F { length = rr, angle = beta0 exact, mass = m1, com = (ra, 0 mm), inertia = I1, symbol = β }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `crank` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 27,
                column: 65,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link crank      from O to F { length = rr, angle = beta0 exact, mass = m1, com = (ra, 0 mm), inertia = I1, symbol = β }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `coupler` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 28,
                column: 6,
                width: 7,
                excerpt: Cow::Borrowed(
                    "link coupler    from E to F { length = d,  angle = -0.06, mass = m2, com = (d - da, 0 mm), inertia = I2, symbol = φ2 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `coupler` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 28,
                column: 59,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link coupler    from E to F { length = d,  angle = -0.06, mass = m2, com = (d - da, 0 mm), inertia = I2, symbol = φ2 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `coupler` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 28,
                column: 59,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link coupler    from E to F { length = d,  angle = -0.06, mass = m2, com = (d - da, 0 mm), inertia = I2, symbol = φ2 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `lever` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 29,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link lever      from B to E { length = ss, angle = -1.12, mass = m3, com = (sa, sb), inertia = I3, symbol = φ3 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `lever` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 29,
                column: 59,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link lever      from B to E { length = ss, angle = -1.12, mass = m3, com = (sa, sb), inertia = I3, symbol = φ3 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `lever` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 29,
                column: 59,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link lever      from B to E { length = ss, angle = -1.12, mass = m3, com = (sa, sb), inertia = I3, symbol = φ3 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `upper` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 30,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link upper      from G to E { length = e,  angle = -0.86, mass = m4, com = (e - ea, 0 mm), inertia = I4, symbol = φ4 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `upper` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 30,
                column: 59,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link upper      from G to E { length = e,  angle = -0.86, mass = m4, com = (e - ea, 0 mm), inertia = I4, symbol = φ4 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `upper` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 30,
                column: 59,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link upper      from G to E { length = e,  angle = -0.86, mass = m4, com = (e - ea, 0 mm), inertia = I4, symbol = φ4 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `upper_arm` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 31,
                column: 6,
                width: 9,
                excerpt: Cow::Borrowed(
                    "link upper_arm  from A to G { length = zt, angle = 0.49,  mass = m5, com = (ta, tb), inertia = I5, symbol = δ }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `upper_arm` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 31,
                column: 59,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link upper_arm  from A to G { length = zt, angle = 0.49,  mass = m5, com = (ta, tb), inertia = I5, symbol = δ }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `upper_arm` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 31,
                column: 59,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link upper_arm  from A to G { length = zt, angle = 0.49,  mass = m5, com = (ta, tb), inertia = I5, symbol = δ }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `lower` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 32,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link lower      from H to E { length = zf, angle = 1.01,  mass = m6, com = (zf - fa, 0 mm), inertia = I6, symbol = φ6 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `lower` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 32,
                column: 59,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link lower      from H to E { length = zf, angle = 1.01,  mass = m6, com = (zf - fa, 0 mm), inertia = I6, symbol = φ6 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `lower` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 32,
                column: 59,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link lower      from H to E { length = zf, angle = 1.01,  mass = m6, com = (zf - fa, 0 mm), inertia = I6, symbol = φ6 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `lower_arm` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 33,
                column: 6,
                width: 9,
                excerpt: Cow::Borrowed(
                    "link lower_arm  from A to H { length = u,  angle = -0.34, mass = m7, com = (ua, ub), inertia = I7, symbol = φ7 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `lower_arm` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 33,
                column: 59,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link lower_arm  from A to H { length = u,  angle = -0.34, mass = m7, com = (ua, ub), inertia = I7, symbol = φ7 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `lower_arm` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 33,
                column: 59,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link lower_arm  from A to H { length = u,  angle = -0.34, mass = m7, com = (ua, ub), inertia = I7, symbol = φ7 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed(
                "the loop crank–coupler–lever cannot close: at `crank` angle {3} the gap is {0}",
            ),
            hint: Some(
                Cow::Borrowed(
                    "`coupler` would need to be {1} to {2} long between its joints, or another link another length or angle",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 28,
                column: 6,
                width: 7,
                excerpt: Cow::Borrowed(
                    "link coupler    from E to F { length = d,  angle = -0.06, mass = m2, com = (d - da, 0 mm), inertia = I2, symbol = φ2 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Metre, Unit::Metre, Unit::Degree]),
        },
        Failure {
            message: Cow::Borrowed(
                "the loop crank–coupler–lever stands at a dead point: at `crank` angle {3} the joints of `coupler` and `lever` lie in one line",
            ),
            hint: Some(
                Cow::Borrowed(
                    "assemble it in another configuration: change an angle or a length; or ask for the coordinate `coupler.angle`, if that leads it through",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 28,
                column: 6,
                width: 7,
                excerpt: Cow::Borrowed(
                    "link coupler    from E to F { length = d,  angle = -0.06, mass = m2, com = (d - da, 0 mm), inertia = I2, symbol = φ2 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Metre, Unit::Metre, Unit::Degree]),
        },
        Failure {
            message: Cow::Borrowed(
                "the loop lever–upper–upper_arm cannot close: the gap is {0}",
            ),
            hint: Some(
                Cow::Borrowed(
                    "`upper` would need to be {1} to {2} long between its joints, or another link another length or angle",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 30,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link upper      from G to E { length = e,  angle = -0.86, mass = m4, com = (e - ea, 0 mm), inertia = I4, symbol = φ4 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Metre, Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed(
                "the loop lever–upper–upper_arm stands at a dead point: the joints of `upper` and `upper_arm` lie in one line",
            ),
            hint: Some(
                Cow::Borrowed(
                    "assemble it in another configuration: change an angle or a length; or ask for the coordinate `upper.angle`, if that leads it through",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 30,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link upper      from G to E { length = e,  angle = -0.86, mass = m4, com = (e - ea, 0 mm), inertia = I4, symbol = φ4 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Metre, Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed(
                "the loop lever–lower–lower_arm cannot close: the gap is {0}",
            ),
            hint: Some(
                Cow::Borrowed(
                    "`lower` would need to be {1} to {2} long between its joints, or another link another length or angle",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 32,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link lower      from H to E { length = zf, angle = 1.01,  mass = m6, com = (zf - fa, 0 mm), inertia = I6, symbol = φ6 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Metre, Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed(
                "the loop lever–lower–lower_arm stands at a dead point: the joints of `lower` and `lower_arm` lie in one line",
            ),
            hint: Some(
                Cow::Borrowed(
                    "assemble it in another configuration: change an angle or a length; or ask for the coordinate `lower.angle`, if that leads it through",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 32,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link lower      from H to E { length = zf, angle = 1.01,  mass = m6, com = (zf - fa, 0 mm), inertia = I6, symbol = φ6 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Metre, Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("`crank` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("andrews.flex"),
                line: 27,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link crank      from O to F { length = rr, angle = beta0 exact, mass = m1, com = (ra, 0 mm), inertia = I1, symbol = β }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
    ];
    /// The equations of motion in plain text.
    pub const EQUATIONS: &str = r#"andrews
═══════

Andrews' squeezing mechanism: seven bodies, three loops, one degree of freedom, driven by a
constant torque against a stiff spring.

A published multibody benchmark (IVP test set; IFToMM A03). Angles are named as published; there
the coupler and the links at E are measured against the link they are pinned to.

Loop crank–coupler–lever
────────────────────────

  rr e^(i β) - d e^(i φ2) - ss e^(i φ3) - i yb - xb = 0

  X1 = xb - rr cos(β)
  Y1 = yb - rr sin(β)
  D1 = X1² + Y1²
  κ1 = (D1 + d² - ss²) / (2 D1)
  η1 = ε1 sqrt((D1 - (d - ss)²) ((d + ss)² - D1)) / (2 D1)
  c2 = (Y1 η1 - X1 κ1) / d
  s2 = -(Y1 κ1 + X1 η1) / d
  c3 = -(X1 - X1 κ1 + Y1 η1) / ss
  s3 = (Y1 κ1 - Y1 + X1 η1) / ss

  φ2 = atan2(s2, c2), φ3 = atan2(s3, c3), continuous over many turns; ⁰: as assembled
  ω2 = dφ2/dβ, ω3 = dφ3/dβ, ' = d/dβ

  ω2  = rr sin(β - φ3) / (d sin(φ2 - φ3))
  ω3  = rr sin(φ2 - β) / (ss sin(φ2 - φ3))
  ω2' = (rr (ω3 - 1) cos(β - φ3) + d ω2 (ω2 - ω3) cos(φ2 - φ3)) / (d sin(φ3 - φ2))
  ω3' = (rr (ω2 - 1) cos(β - φ2) + ss ω3 (ω3 - ω2) cos(φ2 - φ3)) / (ss sin(φ2 - φ3))

Loop lever–upper–upper_arm
──────────────────────────

  ss e^(i φ3) - e e^(i φ4) - zt e^(i δ) - (xa - xb) - i (ya - yb) = 0

  X2  = xa - xb - ss cos(φ3)
  Y2  = ya - yb - ss sin(φ3)
  D2  = X2² + Y2²
  κ2  = (D2 + e² - zt²) / (2 D2)
  η2  = ε2 sqrt((D2 - (e - zt)²) ((e + zt)² - D2)) / (2 D2)
  c4  = (Y2 η2 - X2 κ2) / e
  s4  = -(Y2 κ2 + X2 η2) / e
  c_δ = -(X2 - X2 κ2 + Y2 η2) / zt
  s_δ = (Y2 κ2 - Y2 + X2 η2) / zt

  φ4 = atan2(s4, c4), δ = atan2(s_δ, c_δ), continuous over many turns; ⁰: as assembled
  ω4 = dφ4/dβ, ω_δ = dδ/dβ, ' = d/dβ

  ω4   = ss ω3 sin(φ3 - δ) / (e sin(φ4 - δ))
  ω_δ  = ss ω3 sin(φ4 - φ3) / (zt sin(φ4 - δ))
  ω4'  = (ss ω3' sin(φ3 - δ) + ss ω3 (ω3 - ω_δ) cos(φ3 - δ) + e ω4 (ω_δ - ω4) cos(φ4 - δ))
           / (e sin(φ4 - δ))
  ω_δ' = (ss ω3' sin(φ3 - φ4) + ss ω3 (ω3 - ω4) cos(φ3 - φ4) + zt ω_δ (ω4 - ω_δ) cos(φ4 - δ))
           / (zt sin(δ - φ4))

Loop lever–lower–lower_arm
──────────────────────────

  ss e^(i φ3) - zf e^(i φ6) - u e^(i φ7) - (xa - xb) - i (ya - yb) = 0

  X3 = xa - xb - ss cos(φ3)
  Y3 = ya - yb - ss sin(φ3)
  D3 = X3² + Y3²
  κ3 = (D3 + zf² - u²) / (2 D3)
  η3 = ε3 sqrt((D3 - (zf - u)²) ((zf + u)² - D3)) / (2 D3)
  c6 = (Y3 η3 - X3 κ3) / zf
  s6 = -(Y3 κ3 + X3 η3) / zf
  c7 = -(X3 - X3 κ3 + Y3 η3) / u
  s7 = (Y3 κ3 - Y3 + X3 η3) / u

  φ6 = atan2(s6, c6), φ7 = atan2(s7, c7), continuous over many turns; ⁰: as assembled
  ω6 = dφ6/dβ, ω7 = dφ7/dβ, ' = d/dβ

  ω6  = ss ω3 sin(φ3 - φ7) / (zf sin(φ6 - φ7))
  ω7  = ss ω3 sin(φ6 - φ3) / (u sin(φ6 - φ7))
  ω6' = (ss ω3' sin(φ3 - φ7) + ss ω3 (ω3 - ω7) cos(φ3 - φ7) + zf ω6 (ω7 - ω6) cos(φ6 - φ7))
          / (zf sin(φ6 - φ7))
  ω7' = (ss ω3' sin(φ3 - φ6) + ss ω3 (ω3 - ω6) cos(φ3 - φ6) + u ω7 (ω6 - ω7) cos(φ6 - φ7))
          / (u sin(φ7 - φ6))

Constants of the inertia
────────────────────────

  C0 = I1 + m1 ra² + m2 rr²
  C1 = I2 + m2 da²
  C2 = I3 + m3 sa² + m3 sb² + m4 ss² + m6 ss²
  C3 = I4 + m4 ea²
  C4 = I5 + m5 ta² + m5 tb²
  C5 = I6 + m6 fa²
  C6 = I7 + m7 ua² + m7 ub²
  C7 = -2 rr m2 da
  C8 = -2 ss m4 ea
  C9 = -2 ss m6 fa

Named forces
────────────

  δx_pull    = sc (cos(φ3) - cos(φ3⁰)) + sd (sin(φ3⁰) - sin(φ3))
  Δx_pull    = δx_pull + Δx_pull⁰
  δy_pull    = sc (sin(φ3) - sin(φ3⁰)) + sd (cos(φ3) - cos(φ3⁰))
  Δy_pull    = δy_pull + Δy_pull⁰
  L_pull     = sqrt(Δx_pull² + Δy_pull²)
  e_pull     = L_pull⁰
             - l0
             + (δx_pull (Δx_pull + Δx_pull⁰) + δy_pull (Δy_pull + Δy_pull⁰))
                 / (L_pull + L_pull⁰)
               extension: the length less the free one, without cancellation
  ∂L_pull/∂β = (Δy_pull (sc ω3 cos(φ3) - sd ω3 sin(φ3))
                 - Δx_pull (sc ω3 sin(φ3) + sd ω3 cos(φ3))) / L_pull

Equation of motion of `crank`
─────────────────────────────

  A(β)    = C0
          + C1 ω2²
          + C2 ω3²
          + C3 ω4²
          + C4 ω_δ²
          + C5 ω6²
          + C6 ω7²
          + C7 ω2 cos(β - φ2)
          + C8 ω3 ω4 cos(φ3 - φ4)
          + C9 ω3 ω6 cos(φ3 - φ6)
  ∂A/∂β   = 2 C1 ω2 ω2'
          + 2 C2 ω3 ω3'
          + 2 C3 ω4 ω4'
          + 2 C4 ω_δ ω_δ'
          + 2 C5 ω6 ω6'
          + 2 C6 ω7 ω7'
          + C7 ω2' cos(β - φ2)
          + C7 ω2 (ω2 - 1) sin(β - φ2)
          + C8 ω3' ω4 cos(φ3 - φ4)
          + C8 ω3 ω4' cos(φ3 - φ4)
          + C8 ω3 ω4 (ω3 - ω4) sin(φ4 - φ3)
          + C9 ω3' ω6 cos(φ3 - φ6)
          + C9 ω3 ω6' cos(φ3 - φ6)
          + C9 ω3 ω6 (ω3 - ω6) sin(φ6 - φ3)
  ∂P_s/∂β = c0 e_pull ∂L_pull/∂β

  A(β) β̈ + ½ ∂A/∂β β̇² + ∂P_s/∂β = mom

Constants
─────────

  β⁰       = beta0                             angle of `crank` as assembled
  ε1       = sign((Y1⁰ cos(0.06) + X1⁰ sin(0.06)) / d - (Y1⁰ cos(1.12) + X1⁰ sin(1.12)) / ss)
             which way the loop closes: as drawn
  ε2       = sign((Y2⁰ cos(0.86) + X2⁰ sin(0.86)) / e + (X2⁰ sin(0.49) - Y2⁰ cos(0.49)) / zt)
             which way the loop closes: as drawn
  ε3       = sign((Y3⁰ cos(1.01) - X3⁰ sin(1.01)) / zf - (Y3⁰ cos(0.34) + X3⁰ sin(0.34)) / u)
             which way the loop closes: as drawn
  Δx_pull⁰ = xb - xc + sc cos(φ3⁰) - sd sin(φ3⁰)
  Δy_pull⁰ = yb - yc + sc sin(φ3⁰) + sd cos(φ3⁰)
  L_pull⁰  = sqrt((Δx_pull⁰)² + (Δy_pull⁰)²)   length of `pull` as assembled

  φ3⁰, X1⁰, Y1⁰, X2⁰, Y2⁰, X3⁰, Y3⁰: by the formulas of the loops, at β = β⁰
"#;
    /// The equations of motion as a LaTeX document.
    pub const EQUATIONS_LATEX: &str = r#"\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\begin{document}

\section*{andrews}
Andrews' squeezing mechanism: seven bodies, three loops, one degree of freedom, driven by a
constant torque against a stiff spring.

A published multibody benchmark (IVP test set; IFToMM A03). Angles are named as published; there
the coupler and the links at E are measured against the link they are pinned to.

\subsection*{Loop crank–coupler–lever}
\begin{align*}
& \mathit{rr}\, e^{i \beta} - d\, e^{i \varphi_{2}} - \mathit{ss}\, e^{i \varphi_{3}} - i\,\mathit{yb} - \mathit{xb} = 0 \\
X_{1} &= \mathit{xb} - \mathit{rr} \cos \beta \\
Y_{1} &= \mathit{yb} - \mathit{rr} \sin \beta \\
D_{1} &= X_{1}^{2} + Y_{1}^{2} \\
\kappa_{1} &= \frac{D_{1} + d^{2} - \mathit{ss}^{2}}{2 \, D_{1}} \\
\eta_{1} &= \frac{\varepsilon_{1}}{2 \, D_{1}} \, \sqrt{\left(D_{1} - \left(d - \mathit{ss}\right)^{2}\right) \left(\left(d + \mathit{ss}\right)^{2} - D_{1}\right)} \\
\cos \varphi_{2} &= \frac{Y_{1} \, \eta_{1} - X_{1} \, \kappa_{1}}{d} \\
\sin \varphi_{2} &= -\frac{Y_{1} \, \kappa_{1} + X_{1} \, \eta_{1}}{d} \\
\cos \varphi_{3} &= -\frac{X_{1} - X_{1} \, \kappa_{1} + Y_{1} \, \eta_{1}}{\mathit{ss}} \\
\sin \varphi_{3} &= \frac{Y_{1} \, \kappa_{1} - Y_{1} + X_{1} \, \eta_{1}}{\mathit{ss}} \\
& \varphi_{2} = \operatorname{atan2}(\sin \varphi_{2}, \cos \varphi_{2}),\quad \varphi_{3} = \operatorname{atan2}(\sin \varphi_{3}, \cos \varphi_{3}) \quad\text{(continuous over many turns; ${}^0$: as assembled)} \\
& \omega_{2} = \frac{\mathrm d\varphi_{2}}{\mathrm d\beta},\quad \omega_{3} = \frac{\mathrm d\varphi_{3}}{\mathrm d\beta},\quad {}' = \frac{\mathrm d}{\mathrm d\beta} \\
\omega_{2} &= \frac{\mathit{rr} \sin\left(\beta - \varphi_{3}\right)}{d \sin\left(\varphi_{2} - \varphi_{3}\right)} \\
\omega_{3} &= \frac{\mathit{rr} \sin\left(\varphi_{2} - \beta\right)}{\mathit{ss} \sin\left(\varphi_{2} - \varphi_{3}\right)} \\
\omega'_{2} &= \frac{\mathit{rr} \left(\omega_{3} - 1\right) \cos\left(\beta - \varphi_{3}\right) + d \, \omega_{2} \left(\omega_{2} - \omega_{3}\right) \cos\left(\varphi_{2} - \varphi_{3}\right)}{d \sin\left(\varphi_{3} - \varphi_{2}\right)} \\
\omega'_{3} &= \frac{\mathit{rr} \left(\omega_{2} - 1\right) \cos\left(\beta - \varphi_{2}\right) + \mathit{ss} \, \omega_{3} \left(\omega_{3} - \omega_{2}\right) \cos\left(\varphi_{2} - \varphi_{3}\right)}{\mathit{ss} \sin\left(\varphi_{2} - \varphi_{3}\right)}
\end{align*}

\subsection*{Loop lever–upper–upper\_arm}
\begin{align*}
& \mathit{ss}\, e^{i \varphi_{3}} - e\, e^{i \varphi_{4}} - \mathit{zt}\, e^{i \delta} - \left(\mathit{xa} - \mathit{xb}\right) - i\,\left(\mathit{ya} - \mathit{yb}\right) = 0 \\
X_{2} &= \mathit{xa} - \mathit{xb} - \mathit{ss} \cos \varphi_{3} \\
Y_{2} &= \mathit{ya} - \mathit{yb} - \mathit{ss} \sin \varphi_{3} \\
D_{2} &= X_{2}^{2} + Y_{2}^{2} \\
\kappa_{2} &= \frac{D_{2} + e^{2} - \mathit{zt}^{2}}{2 \, D_{2}} \\
\eta_{2} &= \frac{\varepsilon_{2}}{2 \, D_{2}} \, \sqrt{\left(D_{2} - \left(e - \mathit{zt}\right)^{2}\right) \left(\left(e + \mathit{zt}\right)^{2} - D_{2}\right)} \\
\cos \varphi_{4} &= \frac{Y_{2} \, \eta_{2} - X_{2} \, \kappa_{2}}{e} \\
\sin \varphi_{4} &= -\frac{Y_{2} \, \kappa_{2} + X_{2} \, \eta_{2}}{e} \\
\cos \delta &= -\frac{X_{2} - X_{2} \, \kappa_{2} + Y_{2} \, \eta_{2}}{\mathit{zt}} \\
\sin \delta &= \frac{Y_{2} \, \kappa_{2} - Y_{2} + X_{2} \, \eta_{2}}{\mathit{zt}} \\
& \varphi_{4} = \operatorname{atan2}(\sin \varphi_{4}, \cos \varphi_{4}),\quad \delta = \operatorname{atan2}(\sin \delta, \cos \delta) \quad\text{(continuous over many turns; ${}^0$: as assembled)} \\
& \omega_{4} = \frac{\mathrm d\varphi_{4}}{\mathrm d\beta},\quad \omega_{\delta} = \frac{\mathrm d\delta}{\mathrm d\beta},\quad {}' = \frac{\mathrm d}{\mathrm d\beta} \\
\omega_{4} &= \frac{\mathit{ss} \, \omega_{3} \sin\left(\varphi_{3} - \delta\right)}{e \sin\left(\varphi_{4} - \delta\right)} \\
\omega_{\delta} &= \frac{\mathit{ss} \, \omega_{3} \sin\left(\varphi_{4} - \varphi_{3}\right)}{\mathit{zt} \sin\left(\varphi_{4} - \delta\right)} \\
\omega'_{4} &= \frac{\mathit{ss} \, \omega'_{3} \sin\left(\varphi_{3} - \delta\right) + \mathit{ss} \, \omega_{3} \left(\omega_{3} - \omega_{\delta}\right) \cos\left(\varphi_{3} - \delta\right) + e \, \omega_{4} \left(\omega_{\delta} - \omega_{4}\right) \cos\left(\varphi_{4} - \delta\right)}{e \sin\left(\varphi_{4} - \delta\right)} \\
\omega'_{\delta} &= \frac{\mathit{ss} \, \omega'_{3} \sin\left(\varphi_{3} - \varphi_{4}\right) + \mathit{ss} \, \omega_{3} \left(\omega_{3} - \omega_{4}\right) \cos\left(\varphi_{3} - \varphi_{4}\right) + \mathit{zt} \, \omega_{\delta} \left(\omega_{4} - \omega_{\delta}\right) \cos\left(\varphi_{4} - \delta\right)}{\mathit{zt} \sin\left(\delta - \varphi_{4}\right)}
\end{align*}

\subsection*{Loop lever–lower–lower\_arm}
\begin{align*}
& \mathit{ss}\, e^{i \varphi_{3}} - \mathit{zf}\, e^{i \varphi_{6}} - u\, e^{i \varphi_{7}} - \left(\mathit{xa} - \mathit{xb}\right) - i\,\left(\mathit{ya} - \mathit{yb}\right) = 0 \\
X_{3} &= \mathit{xa} - \mathit{xb} - \mathit{ss} \cos \varphi_{3} \\
Y_{3} &= \mathit{ya} - \mathit{yb} - \mathit{ss} \sin \varphi_{3} \\
D_{3} &= X_{3}^{2} + Y_{3}^{2} \\
\kappa_{3} &= \frac{D_{3} + \mathit{zf}^{2} - u^{2}}{2 \, D_{3}} \\
\eta_{3} &= \frac{\varepsilon_{3}}{2 \, D_{3}} \, \sqrt{\left(D_{3} - \left(\mathit{zf} - u\right)^{2}\right) \left(\left(\mathit{zf} + u\right)^{2} - D_{3}\right)} \\
\cos \varphi_{6} &= \frac{Y_{3} \, \eta_{3} - X_{3} \, \kappa_{3}}{\mathit{zf}} \\
\sin \varphi_{6} &= -\frac{Y_{3} \, \kappa_{3} + X_{3} \, \eta_{3}}{\mathit{zf}} \\
\cos \varphi_{7} &= -\frac{X_{3} - X_{3} \, \kappa_{3} + Y_{3} \, \eta_{3}}{u} \\
\sin \varphi_{7} &= \frac{Y_{3} \, \kappa_{3} - Y_{3} + X_{3} \, \eta_{3}}{u} \\
& \varphi_{6} = \operatorname{atan2}(\sin \varphi_{6}, \cos \varphi_{6}),\quad \varphi_{7} = \operatorname{atan2}(\sin \varphi_{7}, \cos \varphi_{7}) \quad\text{(continuous over many turns; ${}^0$: as assembled)} \\
& \omega_{6} = \frac{\mathrm d\varphi_{6}}{\mathrm d\beta},\quad \omega_{7} = \frac{\mathrm d\varphi_{7}}{\mathrm d\beta},\quad {}' = \frac{\mathrm d}{\mathrm d\beta} \\
\omega_{6} &= \frac{\mathit{ss} \, \omega_{3} \sin\left(\varphi_{3} - \varphi_{7}\right)}{\mathit{zf} \sin\left(\varphi_{6} - \varphi_{7}\right)} \\
\omega_{7} &= \frac{\mathit{ss} \, \omega_{3} \sin\left(\varphi_{6} - \varphi_{3}\right)}{u \sin\left(\varphi_{6} - \varphi_{7}\right)} \\
\omega'_{6} &= \frac{\mathit{ss} \, \omega'_{3} \sin\left(\varphi_{3} - \varphi_{7}\right) + \mathit{ss} \, \omega_{3} \left(\omega_{3} - \omega_{7}\right) \cos\left(\varphi_{3} - \varphi_{7}\right) + \mathit{zf} \, \omega_{6} \left(\omega_{7} - \omega_{6}\right) \cos\left(\varphi_{6} - \varphi_{7}\right)}{\mathit{zf} \sin\left(\varphi_{6} - \varphi_{7}\right)} \\
\omega'_{7} &= \frac{\mathit{ss} \, \omega'_{3} \sin\left(\varphi_{3} - \varphi_{6}\right) + \mathit{ss} \, \omega_{3} \left(\omega_{3} - \omega_{6}\right) \cos\left(\varphi_{3} - \varphi_{6}\right) + u \, \omega_{7} \left(\omega_{6} - \omega_{7}\right) \cos\left(\varphi_{6} - \varphi_{7}\right)}{u \sin\left(\varphi_{7} - \varphi_{6}\right)}
\end{align*}

\subsection*{Constants of the inertia}
\begin{align*}
C_{0} &= I_{1} + m_{1} \, \mathit{ra}^{2} + m_{2} \, \mathit{rr}^{2} \\
C_{1} &= I_{2} + m_{2} \, \mathit{da}^{2} \\
C_{2} &= I_{3} + m_{3} \, \mathit{sa}^{2} + m_{3} \, \mathit{sb}^{2} + m_{4} \, \mathit{ss}^{2} + m_{6} \, \mathit{ss}^{2} \\
C_{3} &= I_{4} + m_{4} \, \mathit{ea}^{2} \\
C_{4} &= I_{5} + m_{5} \, \mathit{ta}^{2} + m_{5} \, \mathit{tb}^{2} \\
C_{5} &= I_{6} + m_{6} \, \mathit{fa}^{2} \\
C_{6} &= I_{7} + m_{7} \, \mathit{ua}^{2} + m_{7} \, \mathit{ub}^{2} \\
C_{7} &= -2 \, \mathit{rr} \, m_{2} \, \mathit{da} \\
C_{8} &= -2 \, \mathit{ss} \, m_{4} \, \mathit{ea} \\
C_{9} &= -2 \, \mathit{ss} \, m_{6} \, \mathit{fa}
\end{align*}

\subsection*{Named forces}
\begin{align*}
\delta x_{\mathrm{pull}} &= \mathit{sc} \left(\cos \varphi_{3} - \cos \varphi_{3}^0\right) + \mathit{sd} \left(\sin \varphi_{3}^0 - \sin \varphi_{3}\right) \\
\Delta x_{\mathrm{pull}} &= \delta x_{\mathrm{pull}} + \Delta x_{\mathrm{pull}}^{0} \\
\delta y_{\mathrm{pull}} &= \mathit{sc} \left(\sin \varphi_{3} - \sin \varphi_{3}^0\right) + \mathit{sd} \left(\cos \varphi_{3} - \cos \varphi_{3}^0\right) \\
\Delta y_{\mathrm{pull}} &= \delta y_{\mathrm{pull}} + \Delta y_{\mathrm{pull}}^{0} \\
L_{\mathrm{pull}} &= \sqrt{\Delta x_{\mathrm{pull}}^{2} + \Delta y_{\mathrm{pull}}^{2}} \\
e_{\mathrm{pull}} &= L_{\mathrm{pull}}^{0} && \text{extension: the length less the free one, without cancellation} \\
&\quad {}- l_{0} \\
&\quad {}+ \frac{\delta x_{\mathrm{pull}} \left(\Delta x_{\mathrm{pull}} + \Delta x_{\mathrm{pull}}^{0}\right) + \delta y_{\mathrm{pull}} \left(\Delta y_{\mathrm{pull}} + \Delta y_{\mathrm{pull}}^{0}\right)}{L_{\mathrm{pull}} + L_{\mathrm{pull}}^{0}} \\
\frac{\partial L_{\mathrm{pull}}}{\partial \beta} &= \frac{\Delta y_{\mathrm{pull}} \left(\mathit{sc} \, \omega_{3} \cos \varphi_{3} - \mathit{sd} \, \omega_{3} \sin \varphi_{3}\right) - \Delta x_{\mathrm{pull}} \left(\mathit{sc} \, \omega_{3} \sin \varphi_{3} + \mathit{sd} \, \omega_{3} \cos \varphi_{3}\right)}{L_{\mathrm{pull}}}
\end{align*}

\subsection*{Equation of motion of \texttt{crank}}
\begin{align*}
A(\beta) &= C_{0} \\
&\quad {}+ C_{1} \, \omega_{2}^{2} \\
&\quad {}+ C_{2} \, \omega_{3}^{2} \\
&\quad {}+ C_{3} \, \omega_{4}^{2} \\
&\quad {}+ C_{4} \, \omega_{\delta}^{2} \\
&\quad {}+ C_{5} \, \omega_{6}^{2} \\
&\quad {}+ C_{6} \, \omega_{7}^{2} \\
&\quad {}+ C_{7} \, \omega_{2} \cos\left(\beta - \varphi_{2}\right) \\
&\quad {}+ C_{8} \, \omega_{3} \, \omega_{4} \cos\left(\varphi_{3} - \varphi_{4}\right) \\
&\quad {}+ C_{9} \, \omega_{3} \, \omega_{6} \cos\left(\varphi_{3} - \varphi_{6}\right) \\
\frac{\partial A}{\partial \beta} &= 2 \, C_{1} \, \omega_{2} \, \omega'_{2} \\
&\quad {}+ 2 \, C_{2} \, \omega_{3} \, \omega'_{3} \\
&\quad {}+ 2 \, C_{3} \, \omega_{4} \, \omega'_{4} \\
&\quad {}+ 2 \, C_{4} \, \omega_{\delta} \, \omega'_{\delta} \\
&\quad {}+ 2 \, C_{5} \, \omega_{6} \, \omega'_{6} \\
&\quad {}+ 2 \, C_{6} \, \omega_{7} \, \omega'_{7} \\
&\quad {}+ C_{7} \, \omega'_{2} \cos\left(\beta - \varphi_{2}\right) \\
&\quad {}+ C_{7} \, \omega_{2} \left(\omega_{2} - 1\right) \sin\left(\beta - \varphi_{2}\right) \\
&\quad {}+ C_{8} \, \omega'_{3} \, \omega_{4} \cos\left(\varphi_{3} - \varphi_{4}\right) \\
&\quad {}+ C_{8} \, \omega_{3} \, \omega'_{4} \cos\left(\varphi_{3} - \varphi_{4}\right) \\
&\quad {}+ C_{8} \, \omega_{3} \, \omega_{4} \left(\omega_{3} - \omega_{4}\right) \sin\left(\varphi_{4} - \varphi_{3}\right) \\
&\quad {}+ C_{9} \, \omega'_{3} \, \omega_{6} \cos\left(\varphi_{3} - \varphi_{6}\right) \\
&\quad {}+ C_{9} \, \omega_{3} \, \omega'_{6} \cos\left(\varphi_{3} - \varphi_{6}\right) \\
&\quad {}+ C_{9} \, \omega_{3} \, \omega_{6} \left(\omega_{3} - \omega_{6}\right) \sin\left(\varphi_{6} - \varphi_{3}\right) \\
\frac{\partial P_s}{\partial \beta} &= c_{0} \, e_{\mathrm{pull}} \, \frac{\partial L_{\mathrm{pull}}}{\partial \beta} \\
& A(\beta)\,\ddot{\beta} + \tfrac12 \frac{\partial A}{\partial \beta}\,\dot{\beta}^2 + \frac{\partial P_s}{\partial \beta} = \mathit{mom}
\end{align*}

\subsection*{Constants}
\begin{align*}
\beta^0 &= \beta_{0} && \text{angle of \texttt{crank} as assembled} \\
\varepsilon_{1} &= \operatorname{sgn}\left(\frac{{Y_{1}}^0 \cos 0.06 + {X_{1}}^0 \sin 0.06}{d} - \frac{{Y_{1}}^0 \cos 1.12 + {X_{1}}^0 \sin 1.12}{\mathit{ss}}\right) && \text{which way the loop closes: as drawn} \\
\varepsilon_{2} &= \operatorname{sgn}\left(\frac{{Y_{2}}^0 \cos 0.86 + {X_{2}}^0 \sin 0.86}{e} + \frac{{X_{2}}^0 \sin 0.49 - {Y_{2}}^0 \cos 0.49}{\mathit{zt}}\right) && \text{which way the loop closes: as drawn} \\
\varepsilon_{3} &= \operatorname{sgn}\left(\frac{{Y_{3}}^0 \cos 1.01 - {X_{3}}^0 \sin 1.01}{\mathit{zf}} - \frac{{Y_{3}}^0 \cos 0.34 + {X_{3}}^0 \sin 0.34}{u}\right) && \text{which way the loop closes: as drawn} \\
\Delta x_{\mathrm{pull}}^{0} &= \mathit{xb} - \mathit{xc} + \mathit{sc} \cos \varphi_{3}^0 - \mathit{sd} \sin \varphi_{3}^0 \\
\Delta y_{\mathrm{pull}}^{0} &= \mathit{yb} - \mathit{yc} + \mathit{sc} \sin \varphi_{3}^0 + \mathit{sd} \cos \varphi_{3}^0 \\
L_{\mathrm{pull}}^{0} &= \sqrt{\left(\Delta x_{\mathrm{pull}}^{0}\right)^{2} + \left(\Delta y_{\mathrm{pull}}^{0}\right)^{2}} && \text{length of \texttt{pull} as assembled} \\
& \varphi_{3}^0,\, {X_{1}}^0,\, {Y_{1}}^0,\, {X_{2}}^0,\, {Y_{2}}^0,\, {X_{3}}^0,\, {Y_{3}}^0: \text{ by the formulas of the loops, at } \beta = \beta^0
\end{align*}

\end{document}
"#;
}
