/// Simulator of the model `double_rocker`, generated from its equations of motion.
///
/// Double-rocker flexure stick–slip actuator.
///
/// A piezo stack pushes a four-bar of flexure hinges at \`A\`. The coupler's tip \`C\` presses on a
/// slider and carries it along by friction: slowly forward, sticking; quickly back, slipping.
///
/// Sun et al., Micromachines 2023, 14, 1117; modelled by Nguyen \& Nguyen, Machines 2025, 13, 787.
///
/// Where the equations of the latter differ: its third bar points from \`D\` to \`O2\`, the rocker here
/// from \`O2\` to \`D\`, so its angle φ3 is 180° more; ω3 is the same. The contact's torque is by
/// virtual work, so both terms with \`ln\` have the factor ω2 that its equation (24) lacks. Its
/// equation (12) puts the third bar's centre of mass beyond \`O2\`; here it is on the bar.
#[allow(
    non_snake_case,
    non_upper_case_globals,
    unused,
    clippy::all,
    clippy::pedantic,
    rustdoc::all
)]
pub mod double_rocker {
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
        /// link height in m; 0.003 by default
        pub h: f64,
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
        /// direction of a centre of mass off its link's line; 0.0 by default
        pub beta1: f64,
        /// direction of a centre of mass off its link's line; 0.0 by default
        pub beta2: f64,
        /// direction of a centre of mass off its link's line; 0.0 by default
        pub beta3: f64,
        /// mass of the stack in kg; 0.015 by default
        pub mp: f64,
        /// stiffness of the stack in N/m; 3.6e6 by default
        pub kp: f64,
        /// damping of the stack in N\*s/m; 0.294 by default
        pub cp: f64,
        /// stiffness of the joint between stack and crank in N/m; 3e7 by default
        pub ku: f64,
        /// A from O1 in m; 0.0051 by default
        pub la: f64,
        /// drive frequency in 1/s; 1e3 by default
        pub f: f64,
        /// drive stroke in m; 2e-5 by default
        pub stroke: f64,
        /// share of the period in which the stack extends; 0.95 by default
        pub rise: f64,
        /// C from B in m; 0.005 by default
        pub ln: f64,
        /// mass of the slider in kg; 0.05 by default
        pub ms: f64,
        /// preload in N; 20.0 by default
        pub Fp: f64,
        /// bristle stiffness in N/m; 5e6 by default
        pub sigma0: f64,
        /// bristle damping in N\*s/m; 5.0 by default
        pub sigma1: f64,
        /// viscous friction in N\*s/m; 0.5 by default
        pub sigma2: f64,
        /// coefficient of static friction; 0.3 by default
        pub mu_s: f64,
        /// coefficient of sliding friction; 0.2 by default
        pub mu_c: f64,
        /// Stribeck velocity in m/s; 0.001 by default
        pub v_s: f64,
    }
    impl Default for Params {
        fn default() -> Self {
            Self {
                E: 7.2e10,
                b: 0.003,
                h: 0.003,
                e: 0.0015,
                r: 0.001,
                l1: 0.0102,
                l2: 0.0232,
                l3: 0.01,
                l4: 0.025,
                m1: 0.0002568,
                m2: 0.0005877,
                m3: 0.0002529,
                beta1: 0.0,
                beta2: 0.0,
                beta3: 0.0,
                mp: 0.015,
                kp: 3.6e6,
                cp: 0.294,
                ku: 3e7,
                la: 0.0051,
                f: 1e3,
                stroke: 2e-5,
                rise: 0.95,
                ln: 0.005,
                ms: 0.05,
                Fp: 20.0,
                sigma0: 5e6,
                sigma1: 5.0,
                sigma2: 0.5,
                mu_s: 0.3,
                mu_c: 0.2,
                v_s: 0.001,
            }
        }
    }
    impl Params {
        /// The set `table2`: its values, all others by default. tables 2 and 3 of the article
        pub fn table2() -> Self {
            Self {
                sigma0: 2e6,
                mu_s: 0.15,
                mu_c: 0.1,
                ku: 3e6,
                ms: 0.1,
                ln: 0.0,
                ..Self::default()
            }
        }
        /// The values in the order of [`VARIABLES`].
        pub fn values(&self) -> [f64; 32] {
            [
                self.E,
                self.b,
                self.h,
                self.e,
                self.r,
                self.l1,
                self.l2,
                self.l3,
                self.l4,
                self.m1,
                self.m2,
                self.m3,
                self.beta1,
                self.beta2,
                self.beta3,
                self.mp,
                self.kp,
                self.cp,
                self.ku,
                self.la,
                self.f,
                self.stroke,
                self.rise,
                self.ln,
                self.ms,
                self.Fp,
                self.sigma0,
                self.sigma1,
                self.sigma2,
                self.mu_s,
                self.mu_c,
                self.v_s,
            ]
        }
        /// Params of values in the order of [`VARIABLES`].
        pub fn from_values(values: [f64; 32]) -> Self {
            Self {
                E: values[0],
                b: values[1],
                h: values[2],
                e: values[3],
                r: values[4],
                l1: values[5],
                l2: values[6],
                l3: values[7],
                l4: values[8],
                m1: values[9],
                m2: values[10],
                m3: values[11],
                beta1: values[12],
                beta2: values[13],
                beta3: values[14],
                mp: values[15],
                kp: values[16],
                cp: values[17],
                ku: values[18],
                la: values[19],
                f: values[20],
                stroke: values[21],
                rise: values[22],
                ln: values[23],
                ms: values[24],
                Fp: values[25],
                sigma0: values[26],
                sigma1: values[27],
                sigma2: values[28],
                mu_s: values[29],
                mu_c: values[30],
                v_s: values[31],
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
            let h = self.h;
            let e = self.e;
            let r = self.r;
            let l1 = self.l1;
            let l2 = self.l2;
            let l3 = self.l3;
            let l4 = self.l4;
            let m1 = self.m1;
            let m2 = self.m2;
            let m3 = self.m3;
            let beta1 = self.beta1;
            let beta2 = self.beta2;
            let beta3 = self.beta3;
            let mp = self.mp;
            let kp = self.kp;
            let cp = self.cp;
            let ku = self.ku;
            let la = self.la;
            let f = self.f;
            let stroke = self.stroke;
            let rise = self.rise;
            let ln = self.ln;
            let ms = self.ms;
            let Fp = self.Fp;
            let sigma0 = self.sigma0;
            let sigma1 = self.sigma1;
            let sigma2 = self.sigma2;
            let mu_s = self.mu_s;
            let mu_c = self.mu_c;
            let v_s = self.v_s;
            let l1_squared = l1 * l1;
            let h_squared = h * h;
            // moment of inertia about the centre of mass of crank
            let I1 = m1 * (l1_squared + h_squared) * 0.08333333333333333;
            let l2_squared = l2 * l2;
            // moment of inertia about the centre of mass of coupler
            let I2 = m2 * (h_squared + l2_squared) * 0.08333333333333333;
            let l3_squared = l3 * l3;
            // moment of inertia about the centre of mass of rocker
            let I3 = m3 * (h_squared + l3_squared) * 0.08333333333333333;
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
            let one_minus_rise = 1.0 - rise;
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
            let t6 = l1 * Real::sin(1.3962634015954636 - φ2_0)
                / (l3 * sin_φ2_0_minus_φ3_0);
            // rate as assembled
            let ω3_0 = -t6;
            // constant of the inertia
            let C3 = l1 * m2 * r2 * 2.0;
            // inertia as assembled
            let A_crank_0 = C0 + C1 * (ω2_0 * ω2_0) + C2 * (ω3_0 * ω3_0)
                + C3 * ω2_0 * Real::cos(beta2 - 1.3962634015954636 + φ2_0);
            let t7 = rise.if_positive(0.0, one_minus_rise.if_positive(1.0, 0.0));
            let (sin_beta2, cos_beta2) = Real::sin_cos(beta2);
            let sqrt_e = e.sqrt();
            let sqrt_e_squared = sqrt_e * sqrt_e;
            let t8 = E * b * (sqrt_e * (sqrt_e_squared * sqrt_e_squared))
                * 0.07073553026306459;
            // stiffness of a hinge
            let k = t8 / r.sqrt();
            let (sin_beta1, cos_beta1) = Real::sin_cos(beta1);
            let (sin_beta3, cos_beta3) = Real::sin_cos(beta3);
            let F_C = mu_c * Fp;
            let v_s_squared = v_s * v_s;
            let F_S = mu_s * Fp;
            let F_S_minus_F_C = F_S - F_C;
            let rise_minus_one = rise - 1.0;
            let stroke_f = stroke * f;
            let dF_ceramic_dx_stack = -kp;
            let dQ_stack_dx_stack = dF_ceramic_dx_stack - ku;
            let dddx_stack_dx_stack = dQ_stack_dx_stack / mp;
            let dF_ceramic_ddx_stack = -cp;
            let dddx_stack_ddx_stack = dF_ceramic_ddx_stack / mp;
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
            if !(mp >= 0.0) {
                return Err(FAILURES[13].diagnostic(&[mp]));
            }
            if !(ms >= 0.0) {
                return Err(FAILURES[14].diagnostic(&[ms]));
            }
            if !(-t3 >= 0.0) {
                let sqrt_D_0 = D_0.sqrt();
                return Err(
                    FAILURES[15]
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
                    FAILURES[16]
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
            if !(f > 0.0) {
                return Err(FAILURES[17].diagnostic(&[f]));
            }
            if !(rise >= 0.0) {
                return Err(FAILURES[18].diagnostic(&[rise]));
            }
            if !(one_minus_rise >= 0.0) {
                return Err(FAILURES[19].diagnostic(&[rise]));
            }
            if !(sigma0 > 0.0) {
                return Err(FAILURES[20].diagnostic(&[sigma0]));
            }
            if !(sigma1 >= 0.0) {
                return Err(FAILURES[21].diagnostic(&[sigma1]));
            }
            if !(sigma2 >= 0.0) {
                return Err(FAILURES[22].diagnostic(&[sigma2]));
            }
            if !(mu_s > 0.0) {
                return Err(FAILURES[23].diagnostic(&[mu_s]));
            }
            if !(mu_c > 0.0) {
                return Err(FAILURES[24].diagnostic(&[mu_c]));
            }
            if !(v_s > 0.0) {
                return Err(FAILURES[25].diagnostic(&[v_s]));
            }
            if !(Fp > 0.0) {
                return Err(FAILURES[26].diagnostic(&[Fp]));
            }
            if !(A_crank_0 > 0.0) {
                return Err(FAILURES[27].diagnostic(&[]));
            }
            if !(mp > 0.0) {
                return Err(FAILURES[28].diagnostic(&[]));
            }
            if !(ms > 0.0) {
                return Err(FAILURES[29].diagnostic(&[]));
            }
            let mut prepared = Prepared {
                start_states: [1.3962634015954636, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
                start_discretes: [0.0, 0.0, 0.0, t7],
                l1,
                l2,
                l3,
                l4,
                m2,
                kp,
                cp,
                ku,
                la,
                f,
                rise,
                ln,
                Fp,
                sigma0,
                sigma1,
                sigma2,
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
                cos_beta2,
                sin_beta2,
                C3,
                k,
                c2_0,
                s2_0,
                c3_0,
                s3_0,
                cos_beta1,
                sin_beta1,
                cos_beta3,
                sin_beta3,
                m1_r1: m1 * r1,
                m3_r3: m3 * r3,
                F_C,
                per_v_s_squared: v_s_squared.recip(),
                F_S_minus_F_C,
                per_sigma0: sigma0.recip(),
                two_C1: C1 * 2.0,
                two_C2: C2 * 2.0,
                constant2: stroke / rise_minus_one,
                stroke_per_rise: stroke / rise,
                constant3: stroke_f / rise_minus_one,
                stroke_f_per_rise: stroke_f / rise,
                per_mp: mp.recip(),
                per_ms: ms.recip(),
                constant4: F_S_minus_F_C * 2.0 / (sigma0 * v_s_squared),
                two_C3: C3 * 2.0,
                la_ku: la * ku,
                dddx_stack_dx_stack,
                dddx_stack_ddx_stack,
                half_mp: mp * 0.5,
                half_ms: ms * 0.5,
                half_k: k * 0.5,
                half_kp: kp * 0.5,
                half_ku: ku * 0.5,
                half_sigma0: sigma0 * 0.5,
                per_f: f.recip(),
                one_minus_rise,
                constant5: t7,
                constant6: one_minus_rise.if_positive(1.0, t7),
                constant7: 0.25 / l2_squared_l3_squared,
                table_of_φ1: Table::none(),
                curve_of_per_g_v: Curve::wanted(),
            };
            check_start(prepared.states(), &prepared.start_states)?;
            check_start(prepared.discretes(), &prepared.start_discretes)?;
            prepared.table_of_φ1 = Table::fit(
                &prepared,
                &COORDINATES,
                0,
                6,
                |φ1, d| { functions_of_φ1(φ1, array(d), &prepared) },
            );
            Ok(prepared)
        }
    }
    /// Everything that depends on params alone, as the functions of this module need it.
    #[derive(Clone, Debug)]
    pub struct Prepared<T> {
        /// Continuous state at the start.
        pub start_states: [T; 7],
        /// Discrete state at the start.
        pub start_discretes: [T; 4],
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
        /// `kp`
        pub kp: T,
        /// `cp`
        pub cp: T,
        /// `ku`
        pub ku: T,
        /// `la`
        pub la: T,
        /// `f`
        pub f: T,
        /// `rise`
        pub rise: T,
        /// `ln`
        pub ln: T,
        /// `Fp`
        pub Fp: T,
        /// `sigma0`
        pub sigma0: T,
        /// `sigma1`
        pub sigma1: T,
        /// `sigma2`
        pub sigma2: T,
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
        /// `cos(beta2)`
        pub cos_beta2: T,
        /// `sin(beta2)`
        pub sin_beta2: T,
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
        /// `cos(beta1)`
        pub cos_beta1: T,
        /// `sin(beta1)`
        pub sin_beta1: T,
        /// `cos(beta3)`
        pub cos_beta3: T,
        /// `sin(beta3)`
        pub sin_beta3: T,
        /// `m1 * r1`
        pub m1_r1: T,
        /// `m3 * r3`
        pub m3_r3: T,
        /// `F_C`
        pub F_C: T,
        /// `1.0 / (v_s * v_s)`
        pub per_v_s_squared: T,
        /// `F_S - F_C`
        pub F_S_minus_F_C: T,
        /// `1.0 / sigma0`
        pub per_sigma0: T,
        /// `2.0 * C1`
        pub two_C1: T,
        /// `2.0 * C2`
        pub two_C2: T,
        /// `stroke / (rise - 1.0)`
        pub constant2: T,
        /// `stroke / rise`
        pub stroke_per_rise: T,
        /// `stroke * f / (rise - 1.0)`
        pub constant3: T,
        /// `stroke * f / rise`
        pub stroke_f_per_rise: T,
        /// `1.0 / mp`
        pub per_mp: T,
        /// `1.0 / ms`
        pub per_ms: T,
        /// `2.0 * (F_S - F_C) / (sigma0 * v_s * v_s)`
        pub constant4: T,
        /// `2.0 * C3`
        pub two_C3: T,
        /// `la * ku`
        pub la_ku: T,
        /// `∂ẍ_stack/∂x_stack`
        pub dddx_stack_dx_stack: T,
        /// `∂ẍ_stack/∂ẋ_stack`
        pub dddx_stack_ddx_stack: T,
        /// `0.5 * mp`
        pub half_mp: T,
        /// `0.5 * ms`
        pub half_ms: T,
        /// `0.5 * k`
        pub half_k: T,
        /// `0.5 * kp`
        pub half_kp: T,
        /// `0.5 * ku`
        pub half_ku: T,
        /// `0.5 * sigma0`
        pub half_sigma0: T,
        /// `1.0 / f`
        pub per_f: T,
        /// `1.0 - rise`
        pub one_minus_rise: T,
        /// `if_positive(rise, 0.0, if_positive(1.0 - rise, 1.0, 0.0))`
        pub constant5: T,
        /// `if_positive(1.0 - rise, 1.0, if_positive(rise, 0.0, if_positive(1.0 - rise, 1.0,…`
        pub constant6: T,
        /// `0.25 / (l2 * l2 * l3 * l3)`
        pub constant7: T,
        /// [`functions_of_φ1`] near the start.
        pub table_of_φ1: Table<T, 9>,
        /// [`per_g_v_of_v`] for a trajectory alone; fitted by `LaneSystem::alone`.
        pub curve_of_per_g_v: Curve,
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
                kp: turn(self.kp),
                cp: turn(self.cp),
                ku: turn(self.ku),
                la: turn(self.la),
                f: turn(self.f),
                rise: turn(self.rise),
                ln: turn(self.ln),
                Fp: turn(self.Fp),
                sigma0: turn(self.sigma0),
                sigma1: turn(self.sigma1),
                sigma2: turn(self.sigma2),
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
                cos_beta2: turn(self.cos_beta2),
                sin_beta2: turn(self.sin_beta2),
                C3: turn(self.C3),
                k: turn(self.k),
                c2_0: turn(self.c2_0),
                s2_0: turn(self.s2_0),
                c3_0: turn(self.c3_0),
                s3_0: turn(self.s3_0),
                cos_beta1: turn(self.cos_beta1),
                sin_beta1: turn(self.sin_beta1),
                cos_beta3: turn(self.cos_beta3),
                sin_beta3: turn(self.sin_beta3),
                m1_r1: turn(self.m1_r1),
                m3_r3: turn(self.m3_r3),
                F_C: turn(self.F_C),
                per_v_s_squared: turn(self.per_v_s_squared),
                F_S_minus_F_C: turn(self.F_S_minus_F_C),
                per_sigma0: turn(self.per_sigma0),
                two_C1: turn(self.two_C1),
                two_C2: turn(self.two_C2),
                constant2: turn(self.constant2),
                stroke_per_rise: turn(self.stroke_per_rise),
                constant3: turn(self.constant3),
                stroke_f_per_rise: turn(self.stroke_f_per_rise),
                per_mp: turn(self.per_mp),
                per_ms: turn(self.per_ms),
                constant4: turn(self.constant4),
                two_C3: turn(self.two_C3),
                la_ku: turn(self.la_ku),
                dddx_stack_dx_stack: turn(self.dddx_stack_dx_stack),
                dddx_stack_ddx_stack: turn(self.dddx_stack_ddx_stack),
                half_mp: turn(self.half_mp),
                half_ms: turn(self.half_ms),
                half_k: turn(self.half_k),
                half_kp: turn(self.half_kp),
                half_ku: turn(self.half_ku),
                half_sigma0: turn(self.half_sigma0),
                per_f: turn(self.per_f),
                one_minus_rise: turn(self.one_minus_rise),
                constant5: turn(self.constant5),
                constant6: turn(self.constant6),
                constant7: turn(self.constant7),
                table_of_φ1: self.table_of_φ1.map(&turn),
                curve_of_per_g_v: Curve::none(),
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
                kp: join(self.kp, other.kp),
                cp: join(self.cp, other.cp),
                ku: join(self.ku, other.ku),
                la: join(self.la, other.la),
                f: join(self.f, other.f),
                rise: join(self.rise, other.rise),
                ln: join(self.ln, other.ln),
                Fp: join(self.Fp, other.Fp),
                sigma0: join(self.sigma0, other.sigma0),
                sigma1: join(self.sigma1, other.sigma1),
                sigma2: join(self.sigma2, other.sigma2),
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
                cos_beta2: join(self.cos_beta2, other.cos_beta2),
                sin_beta2: join(self.sin_beta2, other.sin_beta2),
                C3: join(self.C3, other.C3),
                k: join(self.k, other.k),
                c2_0: join(self.c2_0, other.c2_0),
                s2_0: join(self.s2_0, other.s2_0),
                c3_0: join(self.c3_0, other.c3_0),
                s3_0: join(self.s3_0, other.s3_0),
                cos_beta1: join(self.cos_beta1, other.cos_beta1),
                sin_beta1: join(self.sin_beta1, other.sin_beta1),
                cos_beta3: join(self.cos_beta3, other.cos_beta3),
                sin_beta3: join(self.sin_beta3, other.sin_beta3),
                m1_r1: join(self.m1_r1, other.m1_r1),
                m3_r3: join(self.m3_r3, other.m3_r3),
                F_C: join(self.F_C, other.F_C),
                per_v_s_squared: join(self.per_v_s_squared, other.per_v_s_squared),
                F_S_minus_F_C: join(self.F_S_minus_F_C, other.F_S_minus_F_C),
                per_sigma0: join(self.per_sigma0, other.per_sigma0),
                two_C1: join(self.two_C1, other.two_C1),
                two_C2: join(self.two_C2, other.two_C2),
                constant2: join(self.constant2, other.constant2),
                stroke_per_rise: join(self.stroke_per_rise, other.stroke_per_rise),
                constant3: join(self.constant3, other.constant3),
                stroke_f_per_rise: join(self.stroke_f_per_rise, other.stroke_f_per_rise),
                per_mp: join(self.per_mp, other.per_mp),
                per_ms: join(self.per_ms, other.per_ms),
                constant4: join(self.constant4, other.constant4),
                two_C3: join(self.two_C3, other.two_C3),
                la_ku: join(self.la_ku, other.la_ku),
                dddx_stack_dx_stack: join(
                    self.dddx_stack_dx_stack,
                    other.dddx_stack_dx_stack,
                ),
                dddx_stack_ddx_stack: join(
                    self.dddx_stack_ddx_stack,
                    other.dddx_stack_ddx_stack,
                ),
                half_mp: join(self.half_mp, other.half_mp),
                half_ms: join(self.half_ms, other.half_ms),
                half_k: join(self.half_k, other.half_k),
                half_kp: join(self.half_kp, other.half_kp),
                half_ku: join(self.half_ku, other.half_ku),
                half_sigma0: join(self.half_sigma0, other.half_sigma0),
                per_f: join(self.per_f, other.per_f),
                one_minus_rise: join(self.one_minus_rise, other.one_minus_rise),
                constant5: join(self.constant5, other.constant5),
                constant6: join(self.constant6, other.constant6),
                constant7: join(self.constant7, other.constant7),
                table_of_φ1: self.table_of_φ1.zip(&other.table_of_φ1, &join),
                curve_of_per_g_v: Curve::none(),
            }
        }
    }
    impl Prepared<f64> {
        /// The same without tables and curves: closed forms everywhere.
        pub fn exact(self) -> Self {
            Self {
                table_of_φ1: Table::none(),
                curve_of_per_g_v: Curve::none(),
                ..self
            }
        }
    }
    /// What [`rhs`], [`accept`] and [`closures`] need that depends on `φ1` and params alone, in closed form.
    #[inline(always)]
    pub fn functions_of_φ1<T: Real>(φ1: T, d: &[T; 4], p: &Prepared<T>) -> [T; 9] {
        let turn_coupler = d[0];
        let turn_rocker = d[1];
        let t1 = φ1 - 1.3962634015954636;
        // displacement of `A`
        let x_A = p.la
            * (((φ1 + 1.3962634015954636) * 0.5).sin() * (t1 * 0.5).sin() * 2.0);
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
        let t2 = (D - p.l2_minus_l3_squared) * (D - p.l2_plus_l3_squared);
        let η = p.half_ε * (per_D * (-t2).sqrt());
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
        let t3 = p.l1_per_l2 * (per_sin_φ2_minus_φ3 * sin_φ1_minus_φ3);
        // rate of the angle of `coupler` per unit rate of `crank`
        let ω2 = -t3;
        let dv_ddφ1 = l1_sin_φ1 + p.ln * (ω2 * s2);
        let sin_φ1_minus_φ2 = sin_φ1 * c2 - cos_φ1 * s2;
        let t4 = p.l1_per_l3 * (per_sin_φ2_minus_φ3 * sin_φ1_minus_φ2);
        // rate of the angle of `rocker` per unit rate of `crank`
        let ω3 = -t4;
        let cos_φ1_minus_φ2 = cos_φ1 * c2 + sin_φ1 * s2;
        let t5 = p.cos_beta2 * cos_φ1_minus_φ2 + p.sin_beta2 * sin_φ1_minus_φ2;
        // inertia
        let A = p.C0 + p.C1 * (ω2 * ω2) + p.C2 * (ω3 * ω3) + p.C3 * (ω2 * t5);
        let per_A = A.recip();
        let ω2_minus_one = ω2 - 1.0;
        let t6 = (p.c2_0 * s2 - p.s2_0 * c2).atan2(p.c2_0 * c2 + p.s2_0 * s2);
        // angle of `coupler` from the assembled one
        let φ2_minus_φ2_0 = t6.unwrap_to(turn_coupler);
        let t7 = ω2_minus_one
            * (T::from_f64(1.3962634015954636) - φ1 + φ2_minus_φ2_0);
        let t8 = t4 - t3;
        let t9 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `rocker` from the assembled one
        let φ3_minus_φ3_0 = t9.unwrap_to(turn_rocker);
        let t10 = p.k * t1 + p.k * t7 + p.k * (t8 * (φ2_minus_φ2_0 - φ3_minus_φ3_0));
        // slope of the potential energy of springs
        let dP_s_dφ1 = t10 + p.k * (φ3_minus_φ3_0 * ω3);
        let t11 = l1_cos_φ1 + p.r2 * (ω2 * (p.cos_beta2 * c2 - p.sin_beta2 * s2));
        let t12 = p.m1_r1 * (p.cos_beta1 * cos_φ1 - p.sin_beta1 * sin_φ1) + p.m2 * t11;
        // slope of the potential energy of gravity
        let dP_g_dφ1 = (t12 + p.m3_r3 * (ω3 * (p.cos_beta3 * c3 - p.sin_beta3 * s3)))
            * 9.81;
        // slope of the potential energy
        let dP_dφ1 = dP_s_dφ1 + dP_g_dφ1;
        // what φ̈1 is by `φ1` alone
        let ddφ1_of_φ1 = per_A * (-dP_dφ1 - p.Fp * (l1_cos_φ1 + p.ln * (ω2 * c2)));
        let dx_A_dφ1 = p.la * sin_φ1;
        let ddφ1_per_F_joint = per_A * dx_A_dφ1;
        let ddφ1_per_F_f = -(per_A * dv_ddφ1);
        let t13 = p.sin_beta2 * cos_φ1_minus_φ2 - p.cos_beta2 * sin_φ1_minus_φ2;
        let cos_φ1_minus_φ3 = cos_φ1 * c3 + sin_φ1 * s3;
        let cos_φ2_minus_φ3 = c2 * c3 + s2 * s3;
        let t14 = p.l1 * (cos_φ1_minus_φ3 * (ω3 - 1.0))
            - p.l2 * (ω2 * t8 * cos_φ2_minus_φ3);
        let ω2_prime = p.per_l2 * (per_sin_φ2_minus_φ3 * t14);
        let t15 = p.l1 * (cos_φ1_minus_φ2 * ω2_minus_one)
            - p.l3 * (ω3 * t8 * cos_φ2_minus_φ3);
        let ω3_prime = p.per_l3 * (per_sin_φ2_minus_φ3 * t15);
        let t16 = p.two_C1 * (ω2 * ω2_prime) + p.two_C2 * (ω3 * ω3_prime)
            + p.C3 * (ω2_prime * t5);
        let ddφ1_per_dφ1_squared = per_A
            * ((p.C3 * (ω2 * ω2_minus_one * t13) - t16) * 0.5);
        [
            x_A,
            dv_ddφ1,
            ddφ1_of_φ1,
            ddφ1_per_F_joint,
            ddφ1_per_F_f,
            ddφ1_per_dφ1_squared,
            φ2_minus_φ2_0,
            φ3_minus_φ3_0,
            -(p.constant7 * t2),
        ]
    }
    /// `per_g_v`, which depends on `v` and params alone, in closed form.
    #[inline(always)]
    pub fn per_g_v_of_v<T: Real>(v: T, p: &Prepared<T>) -> T {
        let t1 = p
            .F_C
            .plus_product(p.F_S_minus_F_C, (-(p.per_v_s_squared * (v * v))).exp());
        let g_v = p.per_sigma0 * t1;
        g_v.recip()
    }
    /// dx/dt. Where a loop cannot close, entries are not numbers.
    #[inline(always)]
    pub fn rhs<T: Real>(
        t: T,
        x: &[T; 7],
        d: &[T; 4],
        u: &[T; 0],
        p: &Prepared<T>,
        dx: &mut [T; 7],
    ) {
        let φ1 = x[0];
        let dφ1 = x[1];
        let x_stack = x[2];
        let dx_stack = x[3];
        let dx_stage = x[5];
        let z = x[6];
        let xp_cycle = d[2];
        let xp_falling = d[3];
        let [x_A, dv_ddφ1, ddφ1_of_φ1, ddφ1_per_F_joint, ddφ1_per_F_f,
        ddφ1_per_dφ1_squared, ..] = if p.table_of_φ1.covers(φ1) {
            p.table_of_φ1.polynomials(φ1)
        } else {
            p.table_of_φ1.where_covered(φ1, functions_of_φ1(φ1, d, p))
        };
        // ── configuration ──
        // force of `joint` on its second end
        let F_joint = p.ku * (x_stack - x_A);
        // ── state ──
        let t1 = (ddφ1_of_φ1 + ddφ1_per_F_joint * F_joint)
            .plus_product(ddφ1_per_dφ1_squared, dφ1 * dφ1);
        // slip velocity of `tip`
        let v = (-dx_stage).plus_product(dv_ddφ1, dφ1);
        // friction force of `tip` on its second end, without what is known last
        let F_f_so_far = (p.sigma0 * z)
            .plus_product(p.sigma1, v)
            .plus_product(p.sigma2, v);
        let z_abs_v = z * v.abs();
        let sigma1_z_abs_v = p.sigma1 * z_abs_v;
        let xp_falling_minus_half = xp_falling - 0.5;
        let f_t = p.f * t;
        // drive `xp`
        let xp = xp_falling_minus_half
            .if_positive(
                -(p.constant2 * (xp_cycle + 1.0 - f_t)),
                -(p.stroke_per_rise * (xp_cycle - f_t)),
            );
        // rate of the drive `xp`
        let dxp = xp_falling_minus_half.if_positive(p.constant3, p.stroke_f_per_rise);
        // force of `ceramic` on its second end
        let F_ceramic = (p.kp * (xp - x_stack)).minus_product(p.cp, dx_stack - dxp);
        // generalized force of all other forces
        let Q_stack = F_ceramic - F_joint;
        let ddx_stack = p.per_mp * Q_stack;
        let per_g_v = match p.curve_of_per_g_v.at(v) {
            Some(value) => value,
            None => per_g_v_of_v(v, p),
        };
        let ddφ1 = t1
            .plus_product(ddφ1_per_F_f, F_f_so_far)
            .minus_product(ddφ1_per_F_f * sigma1_z_abs_v, per_g_v);
        let ddx_stage = (p.per_ms * F_f_so_far)
            .minus_product(p.per_ms * sigma1_z_abs_v, per_g_v);
        let ż = v.minus_product(z_abs_v, per_g_v);
        dx[0] = dφ1;
        dx[1] = ddφ1;
        dx[2] = dx_stack;
        dx[3] = ddx_stack;
        dx[4] = dx_stage;
        dx[5] = ddx_stage;
        dx[6] = ż;
    }
    /// ∂(dx/dt)/∂x, row by row; entries that are always zero are left as they are.
    #[inline(always)]
    pub fn jacobian<T: Real>(
        t: T,
        x: &[T; 7],
        d: &[T; 4],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 49],
    ) {
        let φ1 = x[0];
        let dφ1 = x[1];
        let x_stack = x[2];
        let dx_stage = x[5];
        let z = x[6];
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
        let c3 = -(p.per_l3 * (X - X_κ + Y_η));
        let c2 = p.per_l2 * (X_κ - Y_η);
        let s3 = p.per_l3 * (Y_κ + l1_sin_φ1 + X_η);
        let sin_φ2_minus_φ3 = s2 * c3 - c2 * s3;
        let per_sin_φ2_minus_φ3 = sin_φ2_minus_φ3.recip();
        let sin_φ1_minus_φ3 = sin_φ1 * c3 - cos_φ1 * s3;
        let t2 = p.l1_per_l2 * (per_sin_φ2_minus_φ3 * sin_φ1_minus_φ3);
        // rate of the angle of `coupler` per unit rate of `crank`
        let ω2 = -t2;
        let ω2_squared = ω2 * ω2;
        let sin_φ1_minus_φ2 = sin_φ1 * c2 - cos_φ1 * s2;
        let t3 = p.l1_per_l3 * (per_sin_φ2_minus_φ3 * sin_φ1_minus_φ2);
        // rate of the angle of `rocker` per unit rate of `crank`
        let ω3 = -t3;
        let ω3_squared = ω3 * ω3;
        let cos_φ1_minus_φ2 = cos_φ1 * c2 + sin_φ1 * s2;
        let t4 = p.cos_beta2 * cos_φ1_minus_φ2 + p.sin_beta2 * sin_φ1_minus_φ2;
        // inertia
        let A = p.C0 + p.C1 * ω2_squared + p.C2 * ω3_squared + p.C3 * (ω2 * t4);
        let cos_φ1_minus_φ3 = cos_φ1 * c3 + sin_φ1 * s3;
        let ω3_minus_one = ω3 - 1.0;
        let t5 = t3 - t2;
        let cos_φ2_minus_φ3 = c2 * c3 + s2 * s3;
        let t6 = p.l1 * (cos_φ1_minus_φ3 * ω3_minus_one)
            - p.l2 * (ω2 * t5 * cos_φ2_minus_φ3);
        let ω2_prime = p.per_l2 * (per_sin_φ2_minus_φ3 * t6);
        let ω2_ω2_prime = ω2 * ω2_prime;
        let ω2_minus_one = ω2 - 1.0;
        let t7 = p.l1 * (cos_φ1_minus_φ2 * ω2_minus_one)
            - p.l3 * (ω3 * t5 * cos_φ2_minus_φ3);
        let ω3_prime = p.per_l3 * (per_sin_φ2_minus_φ3 * t7);
        let t8 = p.two_C1 * ω2_ω2_prime + p.two_C2 * (ω3 * ω3_prime)
            + p.C3 * (ω2_prime * t4);
        let t9 = p.sin_beta2 * cos_φ1_minus_φ2 - p.cos_beta2 * sin_φ1_minus_φ2;
        // slope of the inertia
        let dA_dφ1 = t8 - p.C3 * (ω2 * ω2_minus_one * t9);
        let t10 = φ1 - 1.3962634015954636;
        let t11 = (p.c2_0 * s2 - p.s2_0 * c2).atan2(p.c2_0 * c2 + p.s2_0 * s2);
        // angle of `coupler` from the assembled one
        let φ2_minus_φ2_0 = t11.unwrap_to(turn_coupler);
        let t12 = T::from_f64(1.3962634015954636) - φ1 + φ2_minus_φ2_0;
        let t13 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `rocker` from the assembled one
        let φ3_minus_φ3_0 = t13.unwrap_to(turn_rocker);
        let t14 = φ2_minus_φ2_0 - φ3_minus_φ3_0;
        // slope of the potential energy of springs
        let dP_s_dφ1 = p.k * t10 + p.k * (ω2_minus_one * t12) + p.k * (t5 * t14)
            + p.k * (φ3_minus_φ3_0 * ω3);
        let t15 = p.cos_beta2 * c2 - p.sin_beta2 * s2;
        let t16 = p.m1_r1 * (p.cos_beta1 * cos_φ1 - p.sin_beta1 * sin_φ1)
            + p.m2 * (l1_cos_φ1 + p.r2 * (ω2 * t15));
        let t17 = p.cos_beta3 * c3 - p.sin_beta3 * s3;
        // slope of the potential energy of gravity
        let dP_g_dφ1 = (t16 + p.m3_r3 * (ω3 * t17)) * 9.81;
        // slope of the potential energy
        let dP_dφ1 = dP_s_dφ1 + dP_g_dφ1;
        // displacement of `A`
        let x_A = p.la
            * (((φ1 + 1.3962634015954636) * 0.5).sin() * (t10 * 0.5).sin() * 2.0);
        // force of `joint` on its second end
        let F_joint = p.ku * (x_stack - x_A);
        let t18 = p.la * (sin_φ1 * F_joint) - p.Fp * (l1_cos_φ1 + p.ln * (ω2 * c2));
        let dv_ddφ1 = l1_sin_φ1 + p.ln * (ω2 * s2);
        let per_A = A.recip();
        let ω2_minus_one_squared = ω2_minus_one * ω2_minus_one;
        let ω2_prime_minus_ω3_prime = ω2_prime - ω3_prime;
        let t19 = p.k + p.k * (ω2_prime * t12) + p.k * ω2_minus_one_squared
            + p.k * (t14 * ω2_prime_minus_ω3_prime);
        let t20 = t5 * t5;
        let ddP_s_dφ1_dφ1 = t19 + p.k * t20 + p.k * ω3_squared
            + p.k * (φ3_minus_φ3_0 * ω3_prime);
        let t21 = l1_sin_φ1 - p.r2 * (ω2_prime * t15)
            + p.r2 * (ω2_squared * (p.cos_beta2 * s2 + p.sin_beta2 * c2));
        let t22 = p.m1_r1 * (p.cos_beta1 * sin_φ1 + p.sin_beta1 * cos_φ1) + p.m2 * t21;
        let t23 = t22 - p.m3_r3 * (ω3_prime * t17)
            + p.m3_r3 * (ω3_squared * (p.cos_beta3 * s3 + p.sin_beta3 * c3));
        let ddP_dφ1_dφ1 = ddP_s_dφ1_dφ1 - t23 * 9.81;
        let dx_A_dφ1 = p.la * sin_φ1;
        let dQ_stack_dφ1 = p.ku * dx_A_dφ1;
        let dF_joint_dφ1 = -dQ_stack_dφ1;
        let t24 = p.Fp
            * (l1_sin_φ1 - p.ln * (ω2_prime * c2) + p.ln * (ω2_squared * s2));
        let t25 = l1_cos_φ1 + p.ln * (ω2_prime * s2) + p.ln * (ω2_squared * c2);
        let t26 = p.l1 * (sin_φ1_minus_φ3 * (ω3_minus_one * ω3_minus_one))
            + p.l1 * (cos_φ1_minus_φ3 * ω3_prime);
        let t27 = t5 * cos_φ2_minus_φ3;
        let t28 = t26 - p.l2 * (t27 * ω2_prime)
            - p.l2 * (ω2 * cos_φ2_minus_φ3 * ω2_prime_minus_ω3_prime);
        let t29 = p.per_l2
            * (per_sin_φ2_minus_φ3 * (t28 + p.l2 * (sin_φ2_minus_φ3 * ω2 * t20)));
        let t30 = (sin_φ2_minus_φ3 * sin_φ2_minus_φ3).recip() * t5
            * cos_φ2_minus_φ3;
        let dω2_prime_dφ1 = t29 - p.per_l2 * (t30 * t6);
        let t31 = p.l1 * (sin_φ1_minus_φ2 * ω2_minus_one_squared)
            + p.l1 * (ω2_prime * cos_φ1_minus_φ2);
        let t32 = t31 - p.l3 * (t27 * ω3_prime)
            - p.l3 * (ω3 * cos_φ2_minus_φ3 * ω2_prime_minus_ω3_prime);
        let t33 = p.per_l3
            * (per_sin_φ2_minus_φ3 * (t32 + p.l3 * (sin_φ2_minus_φ3 * ω3 * t20)));
        let dω3_prime_dφ1 = t33 - p.per_l3 * (t30 * t7);
        let t34 = (p.C1 * (ω2_prime * ω2_prime) + p.C1 * (ω2 * dω2_prime_dφ1)) * 2.0
            + (p.C2 * (ω3_prime * ω3_prime) + p.C2 * (ω3 * dω3_prime_dφ1)) * 2.0;
        let t35 = t34 + p.C3 * (t4 * dω2_prime_dφ1)
            - p.two_C3 * (ω2_prime * ω2_minus_one * t9);
        let ddA_dφ1_dφ1 = t35 - p.C3 * (ω2_ω2_prime * t9)
            - p.C3 * (ω2 * ω2_minus_one_squared * t4);
        let dτ_dx_stack = p.la_ku * sin_φ1;
        let dddφ1_dx_stack = per_A * dτ_dx_stack;
        let dddx_stack_dφ1 = p.per_mp * dQ_stack_dφ1;
        // ── state ──
        // slip velocity of `tip`
        let v = dv_ddφ1 * dφ1 - dx_stage;
        let abs_v = v.abs();
        let z_abs_v = z * abs_v;
        let t36 = (-(p.per_v_s_squared * (v * v))).exp();
        let g_v = p.per_sigma0 * (p.F_C + p.F_S_minus_F_C * t36);
        let per_g_v = g_v.recip();
        let ż = v - z_abs_v * per_g_v;
        // friction force of `tip` on its second end
        let F_f = p.sigma0 * z + p.sigma1 * ż + p.sigma2 * v;
        // generalized torque of all other forces
        let τ = t18 - dv_ddφ1 * F_f;
        let dφ1_squared = dφ1 * dφ1;
        let t37 = p.la * (cos_φ1 * F_joint) + p.la * (sin_φ1 * dF_joint_dφ1) + t24
            - t25 * F_f;
        let dv_dφ1 = t25 * dφ1;
        let z_per_g_v = z * per_g_v;
        let sign_v = v.sign();
        let z_abs_v_per_g_v_squared = z_abs_v * (g_v * g_v).recip();
        let t38 = v * t36;
        let dg_v_dφ1 = -(p.constant4 * (t38 * dv_dφ1));
        let dż_dφ1 = dv_dφ1 - z_per_g_v * dv_dφ1 * sign_v
            + z_abs_v_per_g_v_squared * dg_v_dφ1;
        let dF_f_dφ1 = p.sigma1 * dż_dφ1 + p.sigma2 * dv_dφ1;
        let dτ_dφ1 = t37 - dv_ddφ1 * dF_f_dφ1;
        let dddφ1_dφ1 = (A * A).recip() * dA_dφ1
            * (dP_dφ1 - τ + dA_dφ1 * 0.5 * dφ1_squared)
            - per_A * (ddP_dφ1_dφ1 - dτ_dφ1 + ddA_dφ1_dφ1 * 0.5 * dφ1_squared);
        let z_per_g_v_sign_v = z_per_g_v * sign_v;
        let dg_v_ddφ1 = -(p.constant4 * dv_ddφ1 * t38);
        let dż_ddφ1 = dv_ddφ1 - dv_ddφ1 * z_per_g_v_sign_v
            + z_abs_v_per_g_v_squared * dg_v_ddφ1;
        let dF_f_ddφ1 = p.sigma2 * dv_ddφ1 + p.sigma1 * dż_ddφ1;
        let dτ_ddφ1 = -(dv_ddφ1 * dF_f_ddφ1);
        let dddφ1_ddφ1 = per_A * (dτ_ddφ1 - dA_dφ1 * dφ1);
        let dg_v_ddx_stage = p.constant4 * t38;
        let dż_ddx_stage = z_per_g_v_sign_v - 1.0
            + z_abs_v_per_g_v_squared * dg_v_ddx_stage;
        let dF_f_ddx_stage = p.sigma1 * dż_ddx_stage - p.sigma2;
        let dτ_ddx_stage = -(dv_ddφ1 * dF_f_ddx_stage);
        let dddφ1_ddx_stage = per_A * dτ_ddx_stage;
        let dż_dz = -(abs_v * per_g_v);
        let dF_f_dz = p.sigma0 + p.sigma1 * dż_dz;
        let dτ_dz = -(dv_ddφ1 * dF_f_dz);
        let dddφ1_dz = per_A * dτ_dz;
        let dddx_stage_dφ1 = p.per_ms * dF_f_dφ1;
        let dddx_stage_ddφ1 = p.per_ms * dF_f_ddφ1;
        let dddx_stage_ddx_stage = p.per_ms * dF_f_ddx_stage;
        let dddx_stage_dz = p.per_ms * dF_f_dz;
        result[1] = T::from_f64(1.0);
        result[7] = dddφ1_dφ1;
        result[8] = dddφ1_ddφ1;
        result[9] = dddφ1_dx_stack;
        result[12] = dddφ1_ddx_stage;
        result[13] = dddφ1_dz;
        result[17] = T::from_f64(1.0);
        result[21] = dddx_stack_dφ1;
        result[23] = p.dddx_stack_dx_stack;
        result[24] = p.dddx_stack_ddx_stack;
        result[33] = T::from_f64(1.0);
        result[35] = dddx_stage_dφ1;
        result[36] = dddx_stage_ddφ1;
        result[40] = dddx_stage_ddx_stage;
        result[41] = dddx_stage_dz;
        result[42] = dż_dφ1;
        result[43] = dż_ddφ1;
        result[47] = dż_ddx_stage;
        result[48] = dż_dz;
    }
    /// The model's outputs.
    #[inline(always)]
    pub fn outputs<T: Real>(
        t: T,
        x: &[T; 7],
        d: &[T; 4],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let φ1 = x[0];
        let dφ1 = x[1];
        let x_stack = x[2];
        let x_stage = x[4];
        let dx_stage = x[5];
        let z = x[6];
        let xp_cycle = d[2];
        let xp_falling = d[3];
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
        let sin_φ1_minus_φ3 = sin_φ1 * c3 - cos_φ1 * s3;
        // rate of the angle of `coupler` per unit rate of `crank`
        let ω2 = -(p.l1_per_l2 * (sin_φ2_minus_φ3.recip() * sin_φ1_minus_φ3));
        let dv_ddφ1 = l1_sin_φ1 + p.ln * (ω2 * s2);
        // ── state ──
        let f_t = p.f * t;
        // drive `xp`
        let xp = (xp_falling - 0.5)
            .if_positive(
                -(p.constant2 * (xp_cycle + 1.0 - f_t)),
                -(p.stroke_per_rise * (xp_cycle - f_t)),
            );
        // slip velocity of `tip`
        let v = dv_ddφ1 * dφ1 - dx_stage;
        let g_v = p.per_sigma0
            * (p.F_C + p.F_S_minus_F_C * (-(p.per_v_s_squared * (v * v))).exp());
        let ż = v - z * v.abs() * g_v.recip();
        // friction force of `tip` on its second end
        let F_f = p.sigma0 * z + p.sigma1 * ż + p.sigma2 * v;
        result[0] = dx_stage;
        result[1] = x_stage;
        result[2] = xp - x_stack;
        result[3] = F_f;
    }
    /// Kinetic and potential energy in J, dissipated and supplied power in W.
    #[inline(always)]
    pub fn energy<T: Real>(
        t: T,
        x: &[T; 7],
        d: &[T; 4],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let φ1 = x[0];
        let dφ1 = x[1];
        let x_stack = x[2];
        let dx_stack = x[3];
        let dx_stage = x[5];
        let z = x[6];
        let turn_coupler = d[0];
        let turn_rocker = d[1];
        let xp_cycle = d[2];
        let xp_falling = d[3];
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
        let t2 = p.cos_beta2 * cos_φ1_minus_φ2 + p.sin_beta2 * sin_φ1_minus_φ2;
        // inertia
        let A = p.C0 + p.C1 * (ω2 * ω2) + p.C2 * (ω3 * ω3) + p.C3 * (ω2 * t2);
        let t3 = p.m2 * (l1_sin_φ1 + p.r2 * (p.cos_beta2 * s2 + p.sin_beta2 * c2));
        let t4 = p.m1_r1 * (p.cos_beta1 * sin_φ1 + p.sin_beta1 * cos_φ1) + t3
            + p.m3_r3 * (p.cos_beta3 * s3 + p.sin_beta3 * c3);
        let t5 = φ1 - 1.3962634015954636;
        let t6 = (p.c2_0 * s2 - p.s2_0 * c2).atan2(p.c2_0 * c2 + p.s2_0 * s2);
        // angle of `coupler` from the assembled one
        let φ2_minus_φ2_0 = t6.unwrap_to(turn_coupler);
        let t7 = T::from_f64(1.3962634015954636) - φ1 + φ2_minus_φ2_0;
        let t8 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `rocker` from the assembled one
        let φ3_minus_φ3_0 = t8.unwrap_to(turn_rocker);
        let t9 = φ3_minus_φ3_0 - φ2_minus_φ2_0;
        let t10 = t4 * 9.81 + p.half_k * (t5 * t5) + p.half_k * (t7 * t7)
            + p.half_k * (t9 * t9);
        // displacement of `A`
        let x_A = p.la
            * (((φ1 + 1.3962634015954636) * 0.5).sin() * (t5 * 0.5).sin() * 2.0);
        let x_A_minus_x_stack = x_A - x_stack;
        let t11 = t10 + p.half_k * (φ3_minus_φ3_0 * φ3_minus_φ3_0)
            + p.half_ku * (x_A_minus_x_stack * x_A_minus_x_stack);
        let dv_ddφ1 = l1_sin_φ1 + p.ln * (ω2 * s2);
        // ── state ──
        let t12 = A * 0.5 * (dφ1 * dφ1) + p.half_mp * (dx_stack * dx_stack)
            + p.half_ms * (dx_stage * dx_stage);
        let xp_falling_minus_half = xp_falling - 0.5;
        let f_t = p.f * t;
        // drive `xp`
        let xp = xp_falling_minus_half
            .if_positive(
                -(p.constant2 * (xp_cycle + 1.0 - f_t)),
                -(p.stroke_per_rise * (xp_cycle - f_t)),
            );
        let x_stack_minus_xp = x_stack - xp;
        let t13 = t11 + p.half_kp * (x_stack_minus_xp * x_stack_minus_xp)
            + p.half_sigma0 * (z * z);
        // rate of the drive `xp`
        let dxp = xp_falling_minus_half.if_positive(p.constant3, p.stroke_f_per_rise);
        let dx_stack_minus_dxp = dx_stack - dxp;
        // slip velocity of `tip`
        let v = dv_ddφ1 * dφ1 - dx_stage;
        let g_v = p.per_sigma0
            * (p.F_C + p.F_S_minus_F_C * (-(p.per_v_s_squared * (v * v))).exp());
        let ż = v - z * v.abs() * g_v.recip();
        let t14 = p.cp * (dx_stack_minus_dxp * dx_stack_minus_dxp) - p.sigma0 * (z * ż);
        // friction force of `tip` on its second end
        let F_f = p.sigma0 * z + p.sigma1 * ż + p.sigma2 * v;
        // force of `ceramic` on its second end
        let F_ceramic = p.kp * (xp - x_stack) - p.cp * dx_stack_minus_dxp;
        result[0] = t12;
        result[1] = t13;
        result[2] = t14 + v * F_f;
        result[3] = dxp * F_ceramic - p.Fp * (l1_cos_φ1 + p.ln * (ω2 * c2)) * dφ1;
    }
    /// Event functions: each event happens where its function rises through zero.
    #[inline(always)]
    pub fn events<T: Real>(
        t: T,
        x: &[T; 7],
        d: &[T; 4],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 0],
    ) {}
    /// For each loop a number that is positive where it closes and zero at a dead point.
    #[inline(always)]
    pub fn closures<T: Real>(
        t: T,
        x: &[T; 7],
        d: &[T; 4],
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
        x: &[T; 7],
        d: &[T; 4],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
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
    pub fn next_kinks<T: Real>(d: &[T; 4], p: &Prepared<T>, result: &mut [T; 1]) {
        let xp_cycle = d[2];
        let xp_falling = d[3];
        // ── state ──
        let t1 = (xp_falling - 0.5)
            .if_positive(p.per_f * (xp_cycle + 1.0), p.per_f * (p.rise + xp_cycle));
        result[0] = t1;
    }
    /// The discrete state after drive `index` passed its kink; entries that stay are left as they are.
    #[inline(always)]
    pub fn pass_kink<T: Real>(
        index: usize,
        d: &[T; 4],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        match index {
            0 => {
                let xp_cycle = d[2];
                let xp_falling = d[3];
                // ── state ──
                let xp_falling_minus_half = xp_falling - 0.5;
                let one_plus_xp_cycle = xp_cycle + 1.0;
                let t1 = xp_falling_minus_half
                    .if_positive(
                        one_plus_xp_cycle,
                        p.one_minus_rise.if_positive(xp_cycle, one_plus_xp_cycle),
                    );
                let t2 = xp_falling_minus_half.if_positive(p.constant5, p.constant6);
                result[2] = t1;
                result[3] = t2;
            }
            _ => {}
        }
    }
    /// The state after event `index`; entries that stay are left as they are.
    #[inline(always)]
    pub fn pass_event<T: Real>(
        index: usize,
        t: T,
        x: &[T; 7],
        d: &[T; 4],
        u: &[T; 0],
        p: &Prepared<T>,
        x_after: &mut [T; 7],
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
            1
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
        fn curves(&self) -> Vec<(&str, CurveReport)> {
            let alone: Prepared<f64> = self.alone();
            let rows = [("v", alone.curve_of_per_g_v.report())].into_iter();
            rows.filter_map(|(name, report)| Some((name, report?))).collect()
        }
        fn take_plain_steps(&self, steps: &mut PlainSteps<'_>) {
            steps.on_lanes(self);
        }
    }
    impl LaneSystem for Prepared<f64> {
        type InLanes<L: Lanes> = Prepared<L>;
        type States<L: Lanes> = [L; 7];
        type Discretes<L: Lanes> = [L; 4];
        type Loops<L: Lanes> = [L; 1];
        type Events<L: Lanes> = [L; 0];
        fn in_every_lane<L: Lanes>(&self) -> Prepared<L> {
            self.map(L::from_f64)
        }
        fn alone<L: Lanes>(&self) -> Prepared<L> {
            Prepared {
                curve_of_per_g_v: self
                    .curve_of_per_g_v
                    .fitted(|argument| per_g_v_of_v(argument, self)),
                ..self.map(L::from_f64)
            }
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
    pub static VARIABLES: [Variable; 47] = [
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
            name: Cow::Borrowed("h"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("link height"),
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
            name: Cow::Borrowed("beta1"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("direction of a centre of mass off its link's line"),
            causality: Causality::Parameter,
            start: Some(0.0),
        },
        Variable {
            name: Cow::Borrowed("beta2"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("direction of a centre of mass off its link's line"),
            causality: Causality::Parameter,
            start: Some(0.0),
        },
        Variable {
            name: Cow::Borrowed("beta3"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("direction of a centre of mass off its link's line"),
            causality: Causality::Parameter,
            start: Some(0.0),
        },
        Variable {
            name: Cow::Borrowed("mp"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of the stack"),
            causality: Causality::Parameter,
            start: Some(0.015),
        },
        Variable {
            name: Cow::Borrowed("kp"),
            unit: Cow::Borrowed("N/m"),
            meaning: Cow::Borrowed("stiffness of the stack"),
            causality: Causality::Parameter,
            start: Some(3.6e6),
        },
        Variable {
            name: Cow::Borrowed("cp"),
            unit: Cow::Borrowed("N*s/m"),
            meaning: Cow::Borrowed("damping of the stack"),
            causality: Causality::Parameter,
            start: Some(0.294),
        },
        Variable {
            name: Cow::Borrowed("ku"),
            unit: Cow::Borrowed("N/m"),
            meaning: Cow::Borrowed("stiffness of the joint between stack and crank"),
            causality: Causality::Parameter,
            start: Some(3e7),
        },
        Variable {
            name: Cow::Borrowed("la"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("A from O1"),
            causality: Causality::Parameter,
            start: Some(0.0051),
        },
        Variable {
            name: Cow::Borrowed("f"),
            unit: Cow::Borrowed("1/s"),
            meaning: Cow::Borrowed("drive frequency"),
            causality: Causality::Parameter,
            start: Some(1e3),
        },
        Variable {
            name: Cow::Borrowed("stroke"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("drive stroke"),
            causality: Causality::Parameter,
            start: Some(2e-5),
        },
        Variable {
            name: Cow::Borrowed("rise"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("share of the period in which the stack extends"),
            causality: Causality::Parameter,
            start: Some(0.95),
        },
        Variable {
            name: Cow::Borrowed("ln"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("C from B"),
            causality: Causality::Parameter,
            start: Some(0.005),
        },
        Variable {
            name: Cow::Borrowed("ms"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of the slider"),
            causality: Causality::Parameter,
            start: Some(0.05),
        },
        Variable {
            name: Cow::Borrowed("Fp"),
            unit: Cow::Borrowed("N"),
            meaning: Cow::Borrowed("preload"),
            causality: Causality::Parameter,
            start: Some(20.0),
        },
        Variable {
            name: Cow::Borrowed("sigma0"),
            unit: Cow::Borrowed("N/m"),
            meaning: Cow::Borrowed("bristle stiffness"),
            causality: Causality::Parameter,
            start: Some(5e6),
        },
        Variable {
            name: Cow::Borrowed("sigma1"),
            unit: Cow::Borrowed("N*s/m"),
            meaning: Cow::Borrowed("bristle damping"),
            causality: Causality::Parameter,
            start: Some(5.0),
        },
        Variable {
            name: Cow::Borrowed("sigma2"),
            unit: Cow::Borrowed("N*s/m"),
            meaning: Cow::Borrowed("viscous friction"),
            causality: Causality::Parameter,
            start: Some(0.5),
        },
        Variable {
            name: Cow::Borrowed("mu_s"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("coefficient of static friction"),
            causality: Causality::Parameter,
            start: Some(0.3),
        },
        Variable {
            name: Cow::Borrowed("mu_c"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("coefficient of sliding friction"),
            causality: Causality::Parameter,
            start: Some(0.2),
        },
        Variable {
            name: Cow::Borrowed("v_s"),
            unit: Cow::Borrowed("m/s"),
            meaning: Cow::Borrowed("Stribeck velocity"),
            causality: Causality::Parameter,
            start: Some(0.001),
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
            name: Cow::Borrowed("stack.x"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("position of `stack`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("stack.v"),
            unit: Cow::Borrowed("m/s"),
            meaning: Cow::Borrowed("velocity of `stack`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("stage.x"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("position of `stage`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("stage.v"),
            unit: Cow::Borrowed("m/s"),
            meaning: Cow::Borrowed("velocity of `stage`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("tip.z"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("bristle deflection"),
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
            name: Cow::Borrowed("xp.cycle"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("segment of the drive `xp`"),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("xp.falling"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("segment of the drive `xp`"),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("speed"),
            unit: Cow::Borrowed("m/s"),
            meaning: Cow::Borrowed("velocity of the slider"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("position"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("position of the slider"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("lag"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("stroke that the stack's stiffness takes up"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("friction"),
            unit: Cow::Borrowed("N"),
            meaning: Cow::Borrowed("friction force on the slider"),
            causality: Causality::Output,
            start: None,
        },
    ];
    static PARAMS: &[Variable] = VARIABLES.split_at(0).1.split_at(32).0;
    static STATES: &[Variable] = VARIABLES.split_at(32).1.split_at(7).0;
    static DISCRETES: &[Variable] = VARIABLES.split_at(39).1.split_at(4).0;
    static INPUTS: &[Variable] = VARIABLES.split_at(43).1.split_at(0).0;
    static OUTPUTS: &[Variable] = VARIABLES.split_at(43).1.split_at(4).0;
    /// Positions of the coordinates and of their rates among the states.
    static COORDINATES: [(usize, usize); 3] = [(0, 1), (2, 3), (4, 5)];
    static TURNING: [usize; 2] = [0, 1];
    static FAILURES: [Failure; 30] = [
        Failure {
            message: Cow::Borrowed("the elastic modulus of a circular hinge is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 24,
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
                file: Cow::Borrowed("double_rocker.flex"),
                line: 24,
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
                file: Cow::Borrowed("double_rocker.flex"),
                line: 24,
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
                file: Cow::Borrowed("double_rocker.flex"),
                line: 24,
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
                file: Cow::Borrowed("double_rocker.flex"),
                line: 29,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed("link crank from O1 to B {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `crank` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 32,
                column: 3,
                width: 4,
                excerpt: Cow::Borrowed("  mass    = m1"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `crank` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 32,
                column: 3,
                width: 4,
                excerpt: Cow::Borrowed("  mass    = m1"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `coupler` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 37,
                column: 6,
                width: 7,
                excerpt: Cow::Borrowed("link coupler from B to D {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `coupler` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 40,
                column: 3,
                width: 4,
                excerpt: Cow::Borrowed("  mass    = m2"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `coupler` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 40,
                column: 3,
                width: 4,
                excerpt: Cow::Borrowed("  mass    = m2"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `rocker` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 45,
                column: 6,
                width: 6,
                excerpt: Cow::Borrowed("link rocker from O2 to D {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `rocker` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 48,
                column: 3,
                width: 4,
                excerpt: Cow::Borrowed("  mass    = m3"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `rocker` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 48,
                column: 3,
                width: 4,
                excerpt: Cow::Borrowed("  mass    = m3"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `stack` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 77,
                column: 32,
                width: 4,
                excerpt: Cow::Borrowed("slide  stack   along (-1, 0) { mass = mp }"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `stage` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 95,
                column: 29,
                width: 4,
                excerpt: Cow::Borrowed("slide stage along (-1, 0) { mass = ms }"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
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
                file: Cow::Borrowed("double_rocker.flex"),
                line: 37,
                column: 6,
                width: 7,
                excerpt: Cow::Borrowed("link coupler from B to D {"),
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
                file: Cow::Borrowed("double_rocker.flex"),
                line: 37,
                column: 6,
                width: 7,
                excerpt: Cow::Borrowed("link coupler from B to D {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Metre, Unit::Metre, Unit::Degree]),
        },
        Failure {
            message: Cow::Borrowed("the frequency is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 75,
                column: 7,
                width: 2,
                excerpt: Cow::Borrowed(
                    "drive xp = sawtooth(stroke, frequency = f, rise = rise)",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("Hz")]),
        },
        Failure {
            message: Cow::Borrowed("the `rise` of the sawtooth is {0}"),
            hint: Some(Cow::Borrowed("it is a fraction of the period, from 0 to 1")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 75,
                column: 7,
                width: 2,
                excerpt: Cow::Borrowed(
                    "drive xp = sawtooth(stroke, frequency = f, rise = rise)",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Number]),
        },
        Failure {
            message: Cow::Borrowed("the `rise` of the sawtooth is {0}"),
            hint: Some(Cow::Borrowed("it is a fraction of the period, from 0 to 1")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 75,
                column: 7,
                width: 2,
                excerpt: Cow::Borrowed(
                    "drive xp = sawtooth(stroke, frequency = f, rise = rise)",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Number]),
        },
        Failure {
            message: Cow::Borrowed("the bristle stiffness `sigma0` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 97,
                column: 9,
                width: 3,
                excerpt: Cow::Borrowed("contact tip between C and stage {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("N/m")]),
        },
        Failure {
            message: Cow::Borrowed("the bristle damping `sigma1` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 97,
                column: 9,
                width: 3,
                excerpt: Cow::Borrowed("contact tip between C and stage {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("N*s/m")]),
        },
        Failure {
            message: Cow::Borrowed("the viscous friction `sigma2` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 97,
                column: 9,
                width: 3,
                excerpt: Cow::Borrowed("contact tip between C and stage {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("N*s/m")]),
        },
        Failure {
            message: Cow::Borrowed("the static friction coefficient `mu_s` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 97,
                column: 9,
                width: 3,
                excerpt: Cow::Borrowed("contact tip between C and stage {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Number]),
        },
        Failure {
            message: Cow::Borrowed("the sliding friction coefficient `mu_c` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 97,
                column: 9,
                width: 3,
                excerpt: Cow::Borrowed("contact tip between C and stage {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Number]),
        },
        Failure {
            message: Cow::Borrowed("the Stribeck velocity `v_s` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 97,
                column: 9,
                width: 3,
                excerpt: Cow::Borrowed("contact tip between C and stage {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("m/s")]),
        },
        Failure {
            message: Cow::Borrowed("the preload is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 97,
                column: 9,
                width: 3,
                excerpt: Cow::Borrowed("contact tip between C and stage {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("N")]),
        },
        Failure {
            message: Cow::Borrowed("`crank` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 29,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed("link crank from O1 to B {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
        Failure {
            message: Cow::Borrowed("`stack` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 77,
                column: 8,
                width: 5,
                excerpt: Cow::Borrowed("slide  stack   along (-1, 0) { mass = mp }"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
        Failure {
            message: Cow::Borrowed("`stage` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("double_rocker.flex"),
                line: 95,
                column: 7,
                width: 5,
                excerpt: Cow::Borrowed("slide stage along (-1, 0) { mass = ms }"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
    ];
    /// The equations of motion in plain text.
    pub const EQUATIONS: &str = r#"double_rocker
═════════════

Double-rocker flexure stick–slip actuator.

A piezo stack pushes a four-bar of flexure hinges at `A`. The coupler's tip `C` presses on a
slider and carries it along by friction: slowly forward, sticking; quickly back, slipping.

Sun et al., Micromachines 2023, 14, 1117; modelled by Nguyen & Nguyen, Machines 2025, 13, 787.

Where the equations of the latter differ: its third bar points from `D` to `O2`, the rocker here
from `O2` to `D`, so its angle φ3 is 180° more; ω3 is the same. The contact's torque is by
virtual work, so both terms with `ln` have the factor ω2 that its equation (24) lacks. Its
equation (12) puts the third bar's centre of mass beyond `O2`; here it is on the bar.

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

Drives
──────

  xp(t) = sawtooth(stroke, frequency = f, rise = rise)

Constants of the inertia
────────────────────────

  C0 = I1 + m1 r1² + m2 l1²
  C1 = I2 + m2 r2²
  C2 = I3 + m3 r3²
  C3 = 2 l1 m2 r2

Named forces
────────────

  F_ceramic = kp (xp - x_stack) + cp (ẋp - ẋ_stack)
  x_A       = la (cos(φ1⁰) - cos(φ1))
  F_joint   = ku (x_stack - x_A)
  F_N       = Fp
  v         = φ̇1 (l1 sin(φ1) + ln ω2 sin(φ2)) - ẋ_stage
  F_S       = mu_s F_N
  F_C       = mu_c F_N
  g(v)      = (F_C + (F_S - F_C) exp(-(v/v_s)²)) / sigma0
  ż         = v - z |v| / g(v)
  F_f       = sigma0 z + sigma1 ż + sigma2 v

Equation of motion of `crank`
─────────────────────────────

Inertia:

  A(φ1)  = C0 + C1 ω2² + C2 ω3² + C3 ω2 cos(φ2 - φ1 + beta2)
  ∂A/∂φ1 = 2 C1 ω2 ω2'
         + 2 C2 ω3 ω3'
         + C3 ω2' cos(φ2 - φ1 + beta2)
         + C3 ω2 (1 - ω2) sin(φ2 - φ1 + beta2)

Potential energy:

  ∂P_s/∂φ1 = k (φ1 - φ1⁰)
           + k (ω2 - 1) (φ2 - φ2⁰ - φ1 + φ1⁰)
           + k (ω2 - ω3) (φ2 - φ2⁰ - (φ3 - φ3⁰))
           + k ω3 (φ3 - φ3⁰)
  ∂P_g/∂φ1 = g (m1 r1 cos(φ1 + beta1) + m2 (l1 cos(φ1) + r2 ω2 cos(φ2 + beta2))
               + m3 r3 ω3 cos(φ3 + beta3))
  ∂P/∂φ1   = ∂P_s/∂φ1 + ∂P_g/∂φ1

Other forces:

  τ = la F_joint sin(φ1) - F_N (l1 cos(φ1) + ln ω2 cos(φ2)) - F_f (l1 sin(φ1) + ln ω2 sin(φ2))

Balance:

  A(φ1) φ̈1 + ½ ∂A/∂φ1 φ̇1² + ∂P/∂φ1 = τ

Equation of motion of `stack`
─────────────────────────────

  Q_stack = F_ceramic - F_joint

  mp ẍ_stack = Q_stack

Equation of motion of `stage`
─────────────────────────────

  ms ẍ_stage = F_f

Constants
─────────

  k   = 2 E b e^(5/2) / (9 π sqrt(r))
        stiffness of a hinge
  r1  = ½ l1                  distance of the centre of mass from the first end of crank
  I1  = 1/12 m1 (l1² + h²)    moment of inertia about the centre of mass of crank
  r2  = ½ l2                  distance of the centre of mass from the first end of coupler
  I2  = 1/12 m2 (h² + l2²)    moment of inertia about the centre of mass of coupler
  r3  = ½ l3                  distance of the centre of mass from the first end of rocker
  I3  = 1/12 m3 (h² + l3²)    moment of inertia about the centre of mass of rocker
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

\section*{double\_rocker}
Double-rocker flexure stick–slip actuator.

A piezo stack pushes a four-bar of flexure hinges at \texttt{A}. The coupler's tip \texttt{C} presses on a
slider and carries it along by friction: slowly forward, sticking; quickly back, slipping.

Sun et al., Micromachines 2023, 14, 1117; modelled by Nguyen \& Nguyen, Machines 2025, 13, 787.

Where the equations of the latter differ: its third bar points from \texttt{D} to \texttt{O2}, the rocker here
from \texttt{O2} to \texttt{D}, so its angle \ensuremath{\varphi}3 is 180° more; \ensuremath{\omega}3 is the same. The contact's torque is by
virtual work, so both terms with \texttt{ln} have the factor \ensuremath{\omega}2 that its equation (24) lacks. Its
equation (12) puts the third bar's centre of mass beyond \texttt{O2}; here it is on the bar.

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

\subsection*{Drives}
\begin{align*}
& \mathit{xp}(t) = \text{sawtooth(stroke, frequency = f, rise = rise)}
\end{align*}

\subsection*{Constants of the inertia}
\begin{align*}
C_{0} &= I_{1} + m_{1} \, r_{1}^{2} + m_{2} \, l_{1}^{2} \\
C_{1} &= I_{2} + m_{2} \, r_{2}^{2} \\
C_{2} &= I_{3} + m_{3} \, r_{3}^{2} \\
C_{3} &= 2 \, l_{1} \, m_{2} \, r_{2}
\end{align*}

\subsection*{Named forces}
\begin{align*}
F_{\mathrm{ceramic}} &= \mathit{kp} \left(\mathit{xp} - x_{\mathrm{stack}}\right) + \mathit{cp} \left(\dot{\mathit{xp}} - \dot{x}_{\mathrm{stack}}\right) \\
x_{A} &= \mathit{la} \left(\cos \varphi_{1}^0 - \cos \varphi_{1}\right) \\
F_{\mathrm{joint}} &= \mathit{ku} \left(x_{\mathrm{stack}} - x_{A}\right) \\
F_N &= \mathit{Fp} \\
v &= \dot{\varphi}_{1} \left(l_{1} \sin \varphi_{1} + \mathit{ln} \, \omega_{2} \sin \varphi_{2}\right) - \dot{x}_{\mathrm{stage}} \\
F_S &= \mu_{s} \, F_N \\
F_C &= \mu_{c} \, F_N \\
g(v) &= \frac{F_C + \left(F_S - F_C\right) \exp\left(-\left(\frac{v}{v_{s}}\right)^{2}\right)}{\sigma_{0}} \\
\dot{z} &= v - \frac{z \left|v\right|}{g(v)} \\
F_{f} &= \sigma_{0} \, z + \sigma_{1} \, \dot{z} + \sigma_{2} \, v
\end{align*}

\subsection*{Equation of motion of \texttt{crank}}
Inertia:
\begin{align*}
A(\varphi_{1}) &= C_{0} + C_{1} \, \omega_{2}^{2} + C_{2} \, \omega_{3}^{2} + C_{3} \, \omega_{2} \cos\left(\varphi_{2} - \varphi_{1} + \beta_{2}\right) \\
\frac{\partial A}{\partial \varphi_{1}} &= 2 \, C_{1} \, \omega_{2} \, \omega'_{2} \\
&\quad {}+ 2 \, C_{2} \, \omega_{3} \, \omega'_{3} \\
&\quad {}+ C_{3} \, \omega'_{2} \cos\left(\varphi_{2} - \varphi_{1} + \beta_{2}\right) \\
&\quad {}+ C_{3} \, \omega_{2} \left(1 - \omega_{2}\right) \sin\left(\varphi_{2} - \varphi_{1} + \beta_{2}\right)
\end{align*}
Potential energy:
\begin{align*}
\frac{\partial P_s}{\partial \varphi_{1}} &= k \left(\varphi_{1} - \varphi_{1}^0\right) \\
&\quad {}+ k \left(\omega_{2} - 1\right) \left(\varphi_{2} - \varphi_{2}^0 - \varphi_{1} + \varphi_{1}^0\right) \\
&\quad {}+ k \left(\omega_{2} - \omega_{3}\right) \left(\varphi_{2} - \varphi_{2}^0 - \left(\varphi_{3} - \varphi_{3}^0\right)\right) \\
&\quad {}+ k \, \omega_{3} \left(\varphi_{3} - \varphi_{3}^0\right) \\
\frac{\partial P_g}{\partial \varphi_{1}} &= g \left(m_{1} \, r_{1} \cos\left(\varphi_{1} + \beta_{1}\right) + m_{2} \left(l_{1} \cos \varphi_{1} + r_{2} \, \omega_{2} \cos\left(\varphi_{2} + \beta_{2}\right)\right) + m_{3} \, r_{3} \, \omega_{3} \cos\left(\varphi_{3} + \beta_{3}\right)\right) \\
\frac{\partial P}{\partial \varphi_{1}} &= \frac{\partial P_s}{\partial \varphi_{1}} + \frac{\partial P_g}{\partial \varphi_{1}}
\end{align*}
Other forces:
\begin{align*}
\tau &= \mathit{la} \, F_{\mathrm{joint}} \sin \varphi_{1} \\
&\quad {}- F_N \left(l_{1} \cos \varphi_{1} + \mathit{ln} \, \omega_{2} \cos \varphi_{2}\right) \\
&\quad {}- F_{f} \left(l_{1} \sin \varphi_{1} + \mathit{ln} \, \omega_{2} \sin \varphi_{2}\right)
\end{align*}
Balance:
\begin{align*}
& A(\varphi_{1})\,\ddot{\varphi}_{1} + \tfrac12 \frac{\partial A}{\partial \varphi_{1}}\,\dot{\varphi}_{1}^2 + \frac{\partial P}{\partial \varphi_{1}} = \tau
\end{align*}

\subsection*{Equation of motion of \texttt{stack}}
\begin{align*}
Q_{\mathrm{stack}} &= F_{\mathrm{ceramic}} - F_{\mathrm{joint}} \\
& \mathit{mp}\,\ddot{x}_{\mathrm{stack}} = Q_{\mathrm{stack}}
\end{align*}

\subsection*{Equation of motion of \texttt{stage}}
\begin{align*}
& \mathit{ms}\,\ddot{x}_{\mathrm{stage}} = F_{f}
\end{align*}

\subsection*{Constants}
\begin{align*}
k &= \frac{2 \, E \, b \, e^{5/2}}{9 \, \pi \, \sqrt{r}} && \text{stiffness of a hinge} \\
r_{1} &= \frac{1}{2} \, l_{1} && \text{distance of the centre of mass from the first end of crank} \\
I_{1} &= \frac{1}{12} \, m_{1} \left(l_{1}^{2} + h^{2}\right) && \text{moment of inertia about the centre of mass of crank} \\
r_{2} &= \frac{1}{2} \, l_{2} && \text{distance of the centre of mass from the first end of coupler} \\
I_{2} &= \frac{1}{12} \, m_{2} \left(h^{2} + l_{2}^{2}\right) && \text{moment of inertia about the centre of mass of coupler} \\
r_{3} &= \frac{1}{2} \, l_{3} && \text{distance of the centre of mass from the first end of rocker} \\
I_{3} &= \frac{1}{12} \, m_{3} \left(h^{2} + l_{3}^{2}\right) && \text{moment of inertia about the centre of mass of rocker} \\
\varphi_{1}^0 &= \frac{4}{9} \, \pi && \text{angle of \texttt{crank} as assembled} \\
\varepsilon &= \operatorname{sgn}\left(\frac{{X}^0}{l_{3}} - \frac{{Y}^0}{l_{2}}\right) && \text{which way the loop closes: as drawn} \\
g &= 9.81 && \text{acceleration of gravity} \\
& \varphi_{2}^0,\, \varphi_{3}^0,\, {X}^0,\, {Y}^0: \text{ by the formulas of the loops, at } \varphi_{1} = \varphi_{1}^0
\end{align*}

\end{document}
"#;
}
