/// Simulator of the model `msdm`, generated from its equations of motion.
///
/// Mass–spring–damper model of the double-rocker actuator: the baseline of the article.
///
/// The flexure mechanism is one equivalent mass on one equivalent spring and damper between the
/// piezo stack and the contact. Nguyen \& Nguyen, Machines 2025, 13, 787, equations 25 and 26.
#[allow(
    non_snake_case,
    non_upper_case_globals,
    unused,
    clippy::all,
    clippy::pedantic,
    rustdoc::all
)]
pub mod msdm {
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
        /// mass of the stack in kg; 0.015 by default
        pub mp: f64,
        /// stiffness of the stack in N/m; 3.6e6 by default
        pub kp: f64,
        /// damping of the stack in N\*s/m; 0.294 by default
        pub cp: f64,
        /// equivalent mass of the mechanism in kg; 0.000589 by default
        pub me: f64,
        /// equivalent stiffness of the mechanism in N/m; 2.88e6 by default
        pub ke: f64,
        /// equivalent damping of the mechanism in N\*s/m; 218.0 by default
        pub ce: f64,
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
        /// drive frequency in 1/s; 1e3 by default
        pub f: f64,
        /// drive stroke in m; 2e-5 by default
        pub stroke: f64,
        /// share of the period in which the stack extends; 0.95 by default
        pub rise: f64,
    }
    impl Default for Params {
        fn default() -> Self {
            Self {
                mp: 0.015,
                kp: 3.6e6,
                cp: 0.294,
                me: 0.000589,
                ke: 2.88e6,
                ce: 218.0,
                ms: 0.05,
                Fp: 20.0,
                sigma0: 5e6,
                sigma1: 5.0,
                sigma2: 0.5,
                mu_s: 0.3,
                mu_c: 0.2,
                v_s: 0.001,
                f: 1e3,
                stroke: 2e-5,
                rise: 0.95,
            }
        }
    }
    impl Params {
        /// The values in the order of [`VARIABLES`].
        pub fn values(&self) -> [f64; 17] {
            [
                self.mp,
                self.kp,
                self.cp,
                self.me,
                self.ke,
                self.ce,
                self.ms,
                self.Fp,
                self.sigma0,
                self.sigma1,
                self.sigma2,
                self.mu_s,
                self.mu_c,
                self.v_s,
                self.f,
                self.stroke,
                self.rise,
            ]
        }
        /// Params of values in the order of [`VARIABLES`].
        pub fn from_values(values: [f64; 17]) -> Self {
            Self {
                mp: values[0],
                kp: values[1],
                cp: values[2],
                me: values[3],
                ke: values[4],
                ce: values[5],
                ms: values[6],
                Fp: values[7],
                sigma0: values[8],
                sigma1: values[9],
                sigma2: values[10],
                mu_s: values[11],
                mu_c: values[12],
                v_s: values[13],
                f: values[14],
                stroke: values[15],
                rise: values[16],
            }
        }
        /// Closes the loops and computes everything that depends on params alone.
        ///
        /// # Errors
        /// What is wrong with the parameter set, in the words of `flexure check`.
        pub fn prepare(&self) -> Result<Prepared<f64>, Diagnostic> {
            check_params(PARAMS, &self.values())?;
            let mp = self.mp;
            let kp = self.kp;
            let cp = self.cp;
            let me = self.me;
            let ke = self.ke;
            let ce = self.ce;
            let ms = self.ms;
            let Fp = self.Fp;
            let sigma0 = self.sigma0;
            let sigma1 = self.sigma1;
            let sigma2 = self.sigma2;
            let mu_s = self.mu_s;
            let mu_c = self.mu_c;
            let v_s = self.v_s;
            let f = self.f;
            let stroke = self.stroke;
            let rise = self.rise;
            let one_minus_rise = 1.0 - rise;
            let t1 = rise.if_positive(0.0, one_minus_rise.if_positive(1.0, 0.0));
            let rise_minus_one = rise - 1.0;
            let stroke_f = stroke * f;
            let F_C = mu_c * Fp;
            let v_s_squared = v_s * v_s;
            let F_S = mu_s * Fp;
            let F_S_minus_F_C = F_S - F_C;
            let dF_ceramic_dx_stack = -kp;
            let dQ_stack_dx_stack = dF_ceramic_dx_stack - ke;
            let dddx_stack_dx_stack = dQ_stack_dx_stack / mp;
            let dF_ceramic_ddx_stack = -cp;
            let dQ_stack_ddx_stack = dF_ceramic_ddx_stack - ce;
            let dddx_stack_ddx_stack = dQ_stack_ddx_stack / mp;
            let dddx_stack_dx_flexure = ke / mp;
            let dF_mechanism_ddx_flexure = -ce;
            let dddx_stack_ddx_flexure = ce / mp;
            let dddx_flexure_dx_stack = ke / me;
            let dddx_flexure_ddx_stack = ce / me;
            let dF_mechanism_dx_flexure = -ke;
            let dddx_flexure_dx_flexure = dF_mechanism_dx_flexure / me;
            if !(mp >= 0.0) {
                return Err(FAILURES[0].diagnostic(&[mp]));
            }
            if !(me >= 0.0) {
                return Err(FAILURES[1].diagnostic(&[me]));
            }
            if !(ms >= 0.0) {
                return Err(FAILURES[2].diagnostic(&[ms]));
            }
            if !(f > 0.0) {
                return Err(FAILURES[3].diagnostic(&[f]));
            }
            if !(rise >= 0.0) {
                return Err(FAILURES[4].diagnostic(&[rise]));
            }
            if !(one_minus_rise >= 0.0) {
                return Err(FAILURES[5].diagnostic(&[rise]));
            }
            if !(sigma0 > 0.0) {
                return Err(FAILURES[6].diagnostic(&[sigma0]));
            }
            if !(sigma1 >= 0.0) {
                return Err(FAILURES[7].diagnostic(&[sigma1]));
            }
            if !(sigma2 >= 0.0) {
                return Err(FAILURES[8].diagnostic(&[sigma2]));
            }
            if !(mu_s > 0.0) {
                return Err(FAILURES[9].diagnostic(&[mu_s]));
            }
            if !(mu_c > 0.0) {
                return Err(FAILURES[10].diagnostic(&[mu_c]));
            }
            if !(v_s > 0.0) {
                return Err(FAILURES[11].diagnostic(&[v_s]));
            }
            if !(Fp > 0.0) {
                return Err(FAILURES[12].diagnostic(&[Fp]));
            }
            if !(mp > 0.0) {
                return Err(FAILURES[13].diagnostic(&[]));
            }
            if !(me > 0.0) {
                return Err(FAILURES[14].diagnostic(&[]));
            }
            if !(ms > 0.0) {
                return Err(FAILURES[15].diagnostic(&[]));
            }
            let prepared = Prepared {
                start_states: [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
                start_discretes: [0.0, t1],
                kp,
                cp,
                ke,
                ce,
                sigma0,
                sigma1,
                sigma2,
                f,
                rise,
                constant1: stroke / rise_minus_one,
                stroke_per_rise: stroke / rise,
                constant2: stroke_f / rise_minus_one,
                stroke_f_per_rise: stroke_f / rise,
                per_mp: mp.recip(),
                F_C,
                per_v_s_squared: v_s_squared.recip(),
                F_S_minus_F_C,
                per_sigma0: sigma0.recip(),
                per_me: me.recip(),
                per_ms: ms.recip(),
                dddx_stack_dx_stack,
                dddx_stack_ddx_stack,
                dddx_stack_dx_flexure,
                dF_mechanism_ddx_flexure,
                dddx_stack_ddx_flexure,
                dddx_flexure_dx_stack,
                dddx_flexure_ddx_stack,
                dddx_flexure_dx_flexure,
                constant3: F_S_minus_F_C * 2.0 / (sigma0 * v_s_squared),
                half_mp: mp * 0.5,
                half_me: me * 0.5,
                half_ms: ms * 0.5,
                half_kp: kp * 0.5,
                half_ke: ke * 0.5,
                half_sigma0: sigma0 * 0.5,
                per_f: f.recip(),
                one_minus_rise,
                constant4: t1,
                constant5: one_minus_rise.if_positive(1.0, t1),
                curve_of_per_g_v: Curve::wanted(),
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
        pub start_states: [T; 7],
        /// Discrete state at the start.
        pub start_discretes: [T; 2],
        /// `kp`
        pub kp: T,
        /// `cp`
        pub cp: T,
        /// `ke`
        pub ke: T,
        /// `ce`
        pub ce: T,
        /// `sigma0`
        pub sigma0: T,
        /// `sigma1`
        pub sigma1: T,
        /// `sigma2`
        pub sigma2: T,
        /// `f`
        pub f: T,
        /// `rise`
        pub rise: T,
        /// `stroke / (rise - 1.0)`
        pub constant1: T,
        /// `stroke / rise`
        pub stroke_per_rise: T,
        /// `stroke * f / (rise - 1.0)`
        pub constant2: T,
        /// `stroke * f / rise`
        pub stroke_f_per_rise: T,
        /// `1.0 / mp`
        pub per_mp: T,
        /// `F_C`
        pub F_C: T,
        /// `1.0 / (v_s * v_s)`
        pub per_v_s_squared: T,
        /// `F_S - F_C`
        pub F_S_minus_F_C: T,
        /// `1.0 / sigma0`
        pub per_sigma0: T,
        /// `1.0 / me`
        pub per_me: T,
        /// `1.0 / ms`
        pub per_ms: T,
        /// `∂ẍ_stack/∂x_stack`
        pub dddx_stack_dx_stack: T,
        /// `∂ẍ_stack/∂ẋ_stack`
        pub dddx_stack_ddx_stack: T,
        /// `∂ẍ_stack/∂x_flexure`
        pub dddx_stack_dx_flexure: T,
        /// `∂F_mechanism/∂ẋ_flexure`
        pub dF_mechanism_ddx_flexure: T,
        /// `∂ẍ_stack/∂ẋ_flexure`
        pub dddx_stack_ddx_flexure: T,
        /// `∂ẍ_flexure/∂x_stack`
        pub dddx_flexure_dx_stack: T,
        /// `∂ẍ_flexure/∂ẋ_stack`
        pub dddx_flexure_ddx_stack: T,
        /// `∂ẍ_flexure/∂x_flexure`
        pub dddx_flexure_dx_flexure: T,
        /// `2.0 * (F_S - F_C) / (sigma0 * v_s * v_s)`
        pub constant3: T,
        /// `0.5 * mp`
        pub half_mp: T,
        /// `0.5 * me`
        pub half_me: T,
        /// `0.5 * ms`
        pub half_ms: T,
        /// `0.5 * kp`
        pub half_kp: T,
        /// `0.5 * ke`
        pub half_ke: T,
        /// `0.5 * sigma0`
        pub half_sigma0: T,
        /// `1.0 / f`
        pub per_f: T,
        /// `1.0 - rise`
        pub one_minus_rise: T,
        /// `if_positive(rise, 0.0, if_positive(1.0 - rise, 1.0, 0.0))`
        pub constant4: T,
        /// `if_positive(1.0 - rise, 1.0, if_positive(rise, 0.0, if_positive(1.0 - rise, 1.0,…`
        pub constant5: T,
        /// [`per_g_v_of_v`] for a trajectory alone; fitted by `LaneSystem::alone`.
        pub curve_of_per_g_v: Curve,
    }
    impl<T: Copy> Prepared<T> {
        /// The same with every number turned into another, without curves: for dual numbers or lanes.
        pub fn map<U>(&self, turn: impl Fn(T) -> U) -> Prepared<U> {
            Prepared {
                start_states: self.start_states.map(&turn),
                start_discretes: self.start_discretes.map(&turn),
                kp: turn(self.kp),
                cp: turn(self.cp),
                ke: turn(self.ke),
                ce: turn(self.ce),
                sigma0: turn(self.sigma0),
                sigma1: turn(self.sigma1),
                sigma2: turn(self.sigma2),
                f: turn(self.f),
                rise: turn(self.rise),
                constant1: turn(self.constant1),
                stroke_per_rise: turn(self.stroke_per_rise),
                constant2: turn(self.constant2),
                stroke_f_per_rise: turn(self.stroke_f_per_rise),
                per_mp: turn(self.per_mp),
                F_C: turn(self.F_C),
                per_v_s_squared: turn(self.per_v_s_squared),
                F_S_minus_F_C: turn(self.F_S_minus_F_C),
                per_sigma0: turn(self.per_sigma0),
                per_me: turn(self.per_me),
                per_ms: turn(self.per_ms),
                dddx_stack_dx_stack: turn(self.dddx_stack_dx_stack),
                dddx_stack_ddx_stack: turn(self.dddx_stack_ddx_stack),
                dddx_stack_dx_flexure: turn(self.dddx_stack_dx_flexure),
                dF_mechanism_ddx_flexure: turn(self.dF_mechanism_ddx_flexure),
                dddx_stack_ddx_flexure: turn(self.dddx_stack_ddx_flexure),
                dddx_flexure_dx_stack: turn(self.dddx_flexure_dx_stack),
                dddx_flexure_ddx_stack: turn(self.dddx_flexure_ddx_stack),
                dddx_flexure_dx_flexure: turn(self.dddx_flexure_dx_flexure),
                constant3: turn(self.constant3),
                half_mp: turn(self.half_mp),
                half_me: turn(self.half_me),
                half_ms: turn(self.half_ms),
                half_kp: turn(self.half_kp),
                half_ke: turn(self.half_ke),
                half_sigma0: turn(self.half_sigma0),
                per_f: turn(self.per_f),
                one_minus_rise: turn(self.one_minus_rise),
                constant4: turn(self.constant4),
                constant5: turn(self.constant5),
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
                kp: join(self.kp, other.kp),
                cp: join(self.cp, other.cp),
                ke: join(self.ke, other.ke),
                ce: join(self.ce, other.ce),
                sigma0: join(self.sigma0, other.sigma0),
                sigma1: join(self.sigma1, other.sigma1),
                sigma2: join(self.sigma2, other.sigma2),
                f: join(self.f, other.f),
                rise: join(self.rise, other.rise),
                constant1: join(self.constant1, other.constant1),
                stroke_per_rise: join(self.stroke_per_rise, other.stroke_per_rise),
                constant2: join(self.constant2, other.constant2),
                stroke_f_per_rise: join(self.stroke_f_per_rise, other.stroke_f_per_rise),
                per_mp: join(self.per_mp, other.per_mp),
                F_C: join(self.F_C, other.F_C),
                per_v_s_squared: join(self.per_v_s_squared, other.per_v_s_squared),
                F_S_minus_F_C: join(self.F_S_minus_F_C, other.F_S_minus_F_C),
                per_sigma0: join(self.per_sigma0, other.per_sigma0),
                per_me: join(self.per_me, other.per_me),
                per_ms: join(self.per_ms, other.per_ms),
                dddx_stack_dx_stack: join(
                    self.dddx_stack_dx_stack,
                    other.dddx_stack_dx_stack,
                ),
                dddx_stack_ddx_stack: join(
                    self.dddx_stack_ddx_stack,
                    other.dddx_stack_ddx_stack,
                ),
                dddx_stack_dx_flexure: join(
                    self.dddx_stack_dx_flexure,
                    other.dddx_stack_dx_flexure,
                ),
                dF_mechanism_ddx_flexure: join(
                    self.dF_mechanism_ddx_flexure,
                    other.dF_mechanism_ddx_flexure,
                ),
                dddx_stack_ddx_flexure: join(
                    self.dddx_stack_ddx_flexure,
                    other.dddx_stack_ddx_flexure,
                ),
                dddx_flexure_dx_stack: join(
                    self.dddx_flexure_dx_stack,
                    other.dddx_flexure_dx_stack,
                ),
                dddx_flexure_ddx_stack: join(
                    self.dddx_flexure_ddx_stack,
                    other.dddx_flexure_ddx_stack,
                ),
                dddx_flexure_dx_flexure: join(
                    self.dddx_flexure_dx_flexure,
                    other.dddx_flexure_dx_flexure,
                ),
                constant3: join(self.constant3, other.constant3),
                half_mp: join(self.half_mp, other.half_mp),
                half_me: join(self.half_me, other.half_me),
                half_ms: join(self.half_ms, other.half_ms),
                half_kp: join(self.half_kp, other.half_kp),
                half_ke: join(self.half_ke, other.half_ke),
                half_sigma0: join(self.half_sigma0, other.half_sigma0),
                per_f: join(self.per_f, other.per_f),
                one_minus_rise: join(self.one_minus_rise, other.one_minus_rise),
                constant4: join(self.constant4, other.constant4),
                constant5: join(self.constant5, other.constant5),
                curve_of_per_g_v: Curve::none(),
            }
        }
    }
    impl Prepared<f64> {
        /// The same without tables and curves: closed forms everywhere.
        pub fn exact(self) -> Self {
            Self {
                curve_of_per_g_v: Curve::none(),
                ..self
            }
        }
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
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        dx: &mut [T; 7],
    ) {
        let x_stack = x[0];
        let dx_stack = x[1];
        let x_flexure = x[2];
        let dx_flexure = x[3];
        let dx_stage = x[5];
        let z = x[6];
        let xp_cycle = d[0];
        let xp_falling = d[1];
        // ── state ──
        let xp_falling_minus_half = xp_falling - 0.5;
        let f_t = p.f * t;
        // drive `xp`
        let xp = xp_falling_minus_half
            .if_positive(
                -(p.constant1 * (xp_cycle + 1.0 - f_t)),
                -(p.stroke_per_rise * (xp_cycle - f_t)),
            );
        // rate of the drive `xp`
        let dxp = xp_falling_minus_half.if_positive(p.constant2, p.stroke_f_per_rise);
        // force of `ceramic` on its second end
        let F_ceramic = (p.kp * (xp - x_stack)).minus_product(p.cp, dx_stack - dxp);
        // force of `mechanism` on its second end
        let F_mechanism = (p.ke * (x_stack - x_flexure))
            .plus_product(p.ce, dx_stack - dx_flexure);
        // generalized force of all other forces
        let Q_stack = F_ceramic - F_mechanism;
        let ddx_stack = p.per_mp * Q_stack;
        // slip velocity of `tip`
        let v = dx_flexure - dx_stage;
        // friction force of `tip` on its second end, without what is known last
        let F_f_so_far = (p.sigma0 * z)
            .plus_product(p.sigma1, v)
            .plus_product(p.sigma2, v);
        // generalized force of all other forces, without what is known last
        let Q_flexure_so_far = F_mechanism - F_f_so_far;
        let z_abs_v = z * v.abs();
        let sigma1_z_abs_v = p.sigma1 * z_abs_v;
        let per_g_v = match p.curve_of_per_g_v.at(v) {
            Some(value) => value,
            None => per_g_v_of_v(v, p),
        };
        let ddx_flexure = (p.per_me * Q_flexure_so_far)
            .plus_product(p.per_me * sigma1_z_abs_v, per_g_v);
        let ddx_stage = (p.per_ms * F_f_so_far)
            .minus_product(p.per_ms * sigma1_z_abs_v, per_g_v);
        let ż = v.minus_product(z_abs_v, per_g_v);
        dx[0] = dx_stack;
        dx[1] = ddx_stack;
        dx[2] = dx_flexure;
        dx[3] = ddx_flexure;
        dx[4] = dx_stage;
        dx[5] = ddx_stage;
        dx[6] = ż;
    }
    /// ∂(dx/dt)/∂x, row by row; entries that are always zero are left as they are.
    #[inline(always)]
    pub fn jacobian<T: Real>(
        t: T,
        x: &[T; 7],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 49],
    ) {
        let dx_flexure = x[3];
        let dx_stage = x[5];
        let z = x[6];
        // ── state ──
        // slip velocity of `tip`
        let v = dx_flexure - dx_stage;
        let t1 = (-(p.per_v_s_squared * (v * v))).exp();
        let g_v = p.per_sigma0 * (p.F_C + p.F_S_minus_F_C * t1);
        let per_g_v = g_v.recip();
        let z_per_g_v_sign_v = z * per_g_v * v.sign();
        let abs_v = v.abs();
        let z_abs_v_per_g_v_squared = z * abs_v * (g_v * g_v).recip();
        let dg_v_ddx_stage = p.constant3 * (v * t1);
        let dg_v_ddx_flexure = -dg_v_ddx_stage;
        let dż_ddx_flexure = T::from_f64(1.0) - z_per_g_v_sign_v
            + z_abs_v_per_g_v_squared * dg_v_ddx_flexure;
        let dF_f_ddx_flexure = p.sigma2 + p.sigma1 * dż_ddx_flexure;
        let dQ_flexure_ddx_flexure = p.dF_mechanism_ddx_flexure - dF_f_ddx_flexure;
        let dddx_flexure_ddx_flexure = p.per_me * dQ_flexure_ddx_flexure;
        let dż_ddx_stage = z_per_g_v_sign_v - 1.0
            + z_abs_v_per_g_v_squared * dg_v_ddx_stage;
        let sigma1_dż_ddx_stage = p.sigma1 * dż_ddx_stage;
        let dQ_flexure_ddx_stage = p.sigma2 - sigma1_dż_ddx_stage;
        let dddx_flexure_ddx_stage = p.per_me * dQ_flexure_ddx_stage;
        let dż_dz = -(abs_v * per_g_v);
        let dF_f_dz = p.sigma0 + p.sigma1 * dż_dz;
        let dQ_flexure_dz = -dF_f_dz;
        let dddx_flexure_dz = p.per_me * dQ_flexure_dz;
        let dddx_stage_ddx_flexure = p.per_ms * dF_f_ddx_flexure;
        let dF_f_ddx_stage = sigma1_dż_ddx_stage - p.sigma2;
        let dddx_stage_ddx_stage = p.per_ms * dF_f_ddx_stage;
        let dddx_stage_dz = p.per_ms * dF_f_dz;
        result[1] = T::from_f64(1.0);
        result[7] = p.dddx_stack_dx_stack;
        result[8] = p.dddx_stack_ddx_stack;
        result[9] = p.dddx_stack_dx_flexure;
        result[10] = p.dddx_stack_ddx_flexure;
        result[17] = T::from_f64(1.0);
        result[21] = p.dddx_flexure_dx_stack;
        result[22] = p.dddx_flexure_ddx_stack;
        result[23] = p.dddx_flexure_dx_flexure;
        result[24] = dddx_flexure_ddx_flexure;
        result[26] = dddx_flexure_ddx_stage;
        result[27] = dddx_flexure_dz;
        result[33] = T::from_f64(1.0);
        result[38] = dddx_stage_ddx_flexure;
        result[40] = dddx_stage_ddx_stage;
        result[41] = dddx_stage_dz;
        result[45] = dż_ddx_flexure;
        result[47] = dż_ddx_stage;
        result[48] = dż_dz;
    }
    /// The model's outputs.
    #[inline(always)]
    pub fn outputs<T: Real>(
        t: T,
        x: &[T; 7],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 3],
    ) {
        let dx_flexure = x[3];
        let x_stage = x[4];
        let dx_stage = x[5];
        let z = x[6];
        // ── state ──
        // slip velocity of `tip`
        let v = dx_flexure - dx_stage;
        let g_v = p.per_sigma0
            * (p.F_C + p.F_S_minus_F_C * (-(p.per_v_s_squared * (v * v))).exp());
        let ż = v - z * v.abs() * g_v.recip();
        // friction force of `tip` on its second end
        let F_f = p.sigma0 * z + p.sigma1 * ż + p.sigma2 * v;
        result[0] = dx_stage;
        result[1] = x_stage;
        result[2] = F_f;
    }
    /// Kinetic and potential energy in J, dissipated and supplied power in W.
    #[inline(always)]
    pub fn energy<T: Real>(
        t: T,
        x: &[T; 7],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let x_stack = x[0];
        let dx_stack = x[1];
        let x_flexure = x[2];
        let dx_flexure = x[3];
        let dx_stage = x[5];
        let z = x[6];
        let xp_cycle = d[0];
        let xp_falling = d[1];
        // ── configuration ──
        let x_flexure_minus_x_stack = x_flexure - x_stack;
        // ── state ──
        let t1 = p.half_mp * (dx_stack * dx_stack)
            + p.half_me * (dx_flexure * dx_flexure);
        let xp_falling_minus_half = xp_falling - 0.5;
        let f_t = p.f * t;
        // drive `xp`
        let xp = xp_falling_minus_half
            .if_positive(
                -(p.constant1 * (xp_cycle + 1.0 - f_t)),
                -(p.stroke_per_rise * (xp_cycle - f_t)),
            );
        let x_stack_minus_xp = x_stack - xp;
        let t2 = p.half_ke * (x_flexure_minus_x_stack * x_flexure_minus_x_stack)
            + p.half_kp * (x_stack_minus_xp * x_stack_minus_xp);
        // rate of the drive `xp`
        let dxp = xp_falling_minus_half.if_positive(p.constant2, p.stroke_f_per_rise);
        let dx_stack_minus_dxp = dx_stack - dxp;
        let t3 = dx_flexure - dx_stack;
        let t4 = p.cp * (dx_stack_minus_dxp * dx_stack_minus_dxp) + p.ce * (t3 * t3);
        // slip velocity of `tip`
        let v = dx_flexure - dx_stage;
        let g_v = p.per_sigma0
            * (p.F_C + p.F_S_minus_F_C * (-(p.per_v_s_squared * (v * v))).exp());
        let ż = v - z * v.abs() * g_v.recip();
        // friction force of `tip` on its second end
        let F_f = p.sigma0 * z + p.sigma1 * ż + p.sigma2 * v;
        // force of `ceramic` on its second end
        let F_ceramic = p.kp * (xp - x_stack) - p.cp * dx_stack_minus_dxp;
        result[0] = t1 + p.half_ms * (dx_stage * dx_stage);
        result[1] = t2 + p.half_sigma0 * (z * z);
        result[2] = t4 - p.sigma0 * (z * ż) + v * F_f;
        result[3] = dxp * F_ceramic;
    }
    /// Event functions: each event happens where its function rises through zero.
    #[inline(always)]
    pub fn events<T: Real>(
        t: T,
        x: &[T; 7],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 0],
    ) {}
    /// For each loop a number that is positive where it closes and zero at a dead point.
    #[inline(always)]
    pub fn closures<T: Real>(
        t: T,
        x: &[T; 7],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 0],
    ) {}
    /// The discrete state after an accepted step that ends in `x`; entries that stay are left as they are.
    #[inline(always)]
    pub fn accept<T: Real>(
        t: T,
        x: &[T; 7],
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 2],
    ) {}
    /// Time in s of each drive's next kink.
    #[inline(always)]
    pub fn next_kinks<T: Real>(d: &[T; 2], p: &Prepared<T>, result: &mut [T; 1]) {
        let xp_cycle = d[0];
        let xp_falling = d[1];
        // ── state ──
        let t1 = (xp_falling - 0.5)
            .if_positive(p.per_f * (xp_cycle + 1.0), p.per_f * (p.rise + xp_cycle));
        result[0] = t1;
    }
    /// The discrete state after drive `index` passed its kink; entries that stay are left as they are.
    #[inline(always)]
    pub fn pass_kink<T: Real>(
        index: usize,
        d: &[T; 2],
        p: &Prepared<T>,
        result: &mut [T; 2],
    ) {
        match index {
            0 => {
                let xp_cycle = d[0];
                let xp_falling = d[1];
                // ── state ──
                let xp_falling_minus_half = xp_falling - 0.5;
                let one_plus_xp_cycle = xp_cycle + 1.0;
                let t1 = xp_falling_minus_half
                    .if_positive(
                        one_plus_xp_cycle,
                        p.one_minus_rise.if_positive(xp_cycle, one_plus_xp_cycle),
                    );
                let t2 = xp_falling_minus_half.if_positive(p.constant4, p.constant5);
                result[0] = t1;
                result[1] = t2;
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
        d: &[T; 2],
        u: &[T; 0],
        p: &Prepared<T>,
        x_after: &mut [T; 7],
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
            0
        }
        fn closures(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], values: &mut [f64]) {
            closures(t, array(x), array(d), array(u), self, array_mut(values));
        }
        fn loop_name(&self, index: usize) -> &str {
            const NAMES: [&str; 0] = [];
            NAMES[index]
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
        type Discretes<L: Lanes> = [L; 2];
        type Loops<L: Lanes> = [L; 0];
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
    }
    /// Every quantity with a name: params, states, discrete states, inputs, outputs.
    pub static VARIABLES: [Variable; 29] = [
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
            name: Cow::Borrowed("me"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("equivalent mass of the mechanism"),
            causality: Causality::Parameter,
            start: Some(0.000589),
        },
        Variable {
            name: Cow::Borrowed("ke"),
            unit: Cow::Borrowed("N/m"),
            meaning: Cow::Borrowed("equivalent stiffness of the mechanism"),
            causality: Causality::Parameter,
            start: Some(2.88e6),
        },
        Variable {
            name: Cow::Borrowed("ce"),
            unit: Cow::Borrowed("N*s/m"),
            meaning: Cow::Borrowed("equivalent damping of the mechanism"),
            causality: Causality::Parameter,
            start: Some(218.0),
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
            name: Cow::Borrowed("flexure.x"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("position of `flexure`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("flexure.v"),
            unit: Cow::Borrowed("m/s"),
            meaning: Cow::Borrowed("velocity of `flexure`"),
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
            name: Cow::Borrowed("friction"),
            unit: Cow::Borrowed("N"),
            meaning: Cow::Borrowed("friction force on the slider"),
            causality: Causality::Output,
            start: None,
        },
    ];
    static PARAMS: &[Variable] = VARIABLES.split_at(0).1.split_at(17).0;
    static STATES: &[Variable] = VARIABLES.split_at(17).1.split_at(7).0;
    static DISCRETES: &[Variable] = VARIABLES.split_at(24).1.split_at(2).0;
    static INPUTS: &[Variable] = VARIABLES.split_at(26).1.split_at(0).0;
    static OUTPUTS: &[Variable] = VARIABLES.split_at(26).1.split_at(3).0;
    static TURNING: [usize; 0] = [];
    static FAILURES: [Failure; 16] = [
        Failure {
            message: Cow::Borrowed("the mass of `stack` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("msdm.flex"),
                line: 27,
                column: 30,
                width: 4,
                excerpt: Cow::Borrowed("slide stack   along (1, 0) { mass = mp }"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `flexure` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("msdm.flex"),
                line: 28,
                column: 30,
                width: 4,
                excerpt: Cow::Borrowed("slide flexure along (1, 0) { mass = me }"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `stage` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("msdm.flex"),
                line: 29,
                column: 30,
                width: 4,
                excerpt: Cow::Borrowed("slide stage   along (1, 0) { mass = ms }"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the frequency is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("msdm.flex"),
                line: 25,
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
                file: Cow::Borrowed("msdm.flex"),
                line: 25,
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
                file: Cow::Borrowed("msdm.flex"),
                line: 25,
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
                file: Cow::Borrowed("msdm.flex"),
                line: 34,
                column: 9,
                width: 3,
                excerpt: Cow::Borrowed("contact tip between flexure and stage {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("N/m")]),
        },
        Failure {
            message: Cow::Borrowed("the bristle damping `sigma1` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("msdm.flex"),
                line: 34,
                column: 9,
                width: 3,
                excerpt: Cow::Borrowed("contact tip between flexure and stage {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("N*s/m")]),
        },
        Failure {
            message: Cow::Borrowed("the viscous friction `sigma2` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("msdm.flex"),
                line: 34,
                column: 9,
                width: 3,
                excerpt: Cow::Borrowed("contact tip between flexure and stage {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("N*s/m")]),
        },
        Failure {
            message: Cow::Borrowed("the static friction coefficient `mu_s` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("msdm.flex"),
                line: 34,
                column: 9,
                width: 3,
                excerpt: Cow::Borrowed("contact tip between flexure and stage {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Number]),
        },
        Failure {
            message: Cow::Borrowed("the sliding friction coefficient `mu_c` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("msdm.flex"),
                line: 34,
                column: 9,
                width: 3,
                excerpt: Cow::Borrowed("contact tip between flexure and stage {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Number]),
        },
        Failure {
            message: Cow::Borrowed("the Stribeck velocity `v_s` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("msdm.flex"),
                line: 34,
                column: 9,
                width: 3,
                excerpt: Cow::Borrowed("contact tip between flexure and stage {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("m/s")]),
        },
        Failure {
            message: Cow::Borrowed("the preload is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("msdm.flex"),
                line: 34,
                column: 9,
                width: 3,
                excerpt: Cow::Borrowed("contact tip between flexure and stage {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("N")]),
        },
        Failure {
            message: Cow::Borrowed("`stack` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("msdm.flex"),
                line: 27,
                column: 7,
                width: 5,
                excerpt: Cow::Borrowed("slide stack   along (1, 0) { mass = mp }"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
        Failure {
            message: Cow::Borrowed("`flexure` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("msdm.flex"),
                line: 28,
                column: 7,
                width: 7,
                excerpt: Cow::Borrowed("slide flexure along (1, 0) { mass = me }"),
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
                file: Cow::Borrowed("msdm.flex"),
                line: 29,
                column: 7,
                width: 5,
                excerpt: Cow::Borrowed("slide stage   along (1, 0) { mass = ms }"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
    ];
    /// The equations of motion in plain text.
    pub const EQUATIONS: &str = r#"msdm
════

Mass–spring–damper model of the double-rocker actuator: the baseline of the article.

The flexure mechanism is one equivalent mass on one equivalent spring and damper between the
piezo stack and the contact. Nguyen & Nguyen, Machines 2025, 13, 787, equations 25 and 26.

Drives
──────

  xp(t) = sawtooth(stroke, frequency = f, rise = rise)

Named forces
────────────

  F_ceramic   = kp (xp - x_stack) + cp (ẋp - ẋ_stack)
  F_mechanism = ke (x_stack - x_flexure) + ce (ẋ_stack - ẋ_flexure)
  F_N         = Fp
  v           = ẋ_flexure - ẋ_stage
  F_S         = mu_s F_N
  F_C         = mu_c F_N
  g(v)        = (F_C + (F_S - F_C) exp(-(v/v_s)²)) / sigma0
  ż           = v - z |v| / g(v)
  F_f         = sigma0 z + sigma1 ż + sigma2 v

Equation of motion of `stack`
─────────────────────────────

  Q_stack = F_ceramic - F_mechanism

  mp ẍ_stack = Q_stack

Equation of motion of `flexure`
───────────────────────────────

  Q_flexure = F_mechanism - F_f

  me ẍ_flexure = Q_flexure

Equation of motion of `stage`
─────────────────────────────

  ms ẍ_stage = F_f
"#;
    /// The equations of motion as a LaTeX document.
    pub const EQUATIONS_LATEX: &str = r#"\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\begin{document}

\section*{msdm}
Mass–spring–damper model of the double-rocker actuator: the baseline of the article.

The flexure mechanism is one equivalent mass on one equivalent spring and damper between the
piezo stack and the contact. Nguyen \& Nguyen, Machines 2025, 13, 787, equations 25 and 26.

\subsection*{Drives}
\begin{align*}
& \mathit{xp}(t) = \text{sawtooth(stroke, frequency = f, rise = rise)}
\end{align*}

\subsection*{Named forces}
\begin{align*}
F_{\mathrm{ceramic}} &= \mathit{kp} \left(\mathit{xp} - x_{\mathrm{stack}}\right) + \mathit{cp} \left(\dot{\mathit{xp}} - \dot{x}_{\mathrm{stack}}\right) \\
F_{\mathrm{mechanism}} &= \mathit{ke} \left(x_{\mathrm{stack}} - x_{\mathrm{flexure}}\right) + \mathit{ce} \left(\dot{x}_{\mathrm{stack}} - \dot{x}_{\mathrm{flexure}}\right) \\
F_N &= \mathit{Fp} \\
v &= \dot{x}_{\mathrm{flexure}} - \dot{x}_{\mathrm{stage}} \\
F_S &= \mu_{s} \, F_N \\
F_C &= \mu_{c} \, F_N \\
g(v) &= \frac{F_C + \left(F_S - F_C\right) \exp\left(-\left(\frac{v}{v_{s}}\right)^{2}\right)}{\sigma_{0}} \\
\dot{z} &= v - \frac{z \left|v\right|}{g(v)} \\
F_{f} &= \sigma_{0} \, z + \sigma_{1} \, \dot{z} + \sigma_{2} \, v
\end{align*}

\subsection*{Equation of motion of \texttt{stack}}
\begin{align*}
Q_{\mathrm{stack}} &= F_{\mathrm{ceramic}} - F_{\mathrm{mechanism}} \\
& \mathit{mp}\,\ddot{x}_{\mathrm{stack}} = Q_{\mathrm{stack}}
\end{align*}

\subsection*{Equation of motion of \texttt{flexure}}
\begin{align*}
Q_{\mathrm{flexure}} &= F_{\mathrm{mechanism}} - F_{f} \\
& \mathit{me}\,\ddot{x}_{\mathrm{flexure}} = Q_{\mathrm{flexure}}
\end{align*}

\subsection*{Equation of motion of \texttt{stage}}
\begin{align*}
& \mathit{ms}\,\ddot{x}_{\mathrm{stage}} = F_{f}
\end{align*}

\end{document}
"#;
}
