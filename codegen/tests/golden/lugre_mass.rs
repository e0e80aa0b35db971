/// Simulator of the model `lugre_mass`, generated from its equations of motion.
///
/// Stick–slip of a mass that is pulled over a rough surface through a soft spring.
///
/// The standard example of the LuGre friction law: C. Canudas de Wit, H. Olsson, K. J. Åström,
/// P. Lischinsky, A new model for control of systems with friction, IEEE Transactions on
/// Automatic Control 40 (1995).
#[allow(
    non_snake_case,
    non_upper_case_globals,
    unused,
    clippy::all,
    clippy::pedantic,
    rustdoc::all
)]
pub mod lugre_mass {
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
        /// mass in kg; 1.0 by default
        pub m: f64,
        /// spring stiffness in N/m; 2.0 by default
        pub k: f64,
        /// velocity of the spring's far end in m/s; 0.1 by default
        pub pull: f64,
        /// normal force in N; 1.0 by default
        pub FN: f64,
        /// bristle stiffness in N/m; 1e5 by default
        pub sigma0: f64,
        /// bristle damping in N\*s/m; 316.22776601683796 by default
        pub sigma1: f64,
        /// viscous friction in N\*s/m; 0.4 by default
        pub sigma2: f64,
        /// static friction over normal force; 1.5 by default
        pub mu_s: f64,
        /// sliding friction over normal force; 1.0 by default
        pub mu_c: f64,
        /// Stribeck velocity in m/s; 0.001 by default
        pub v_s: f64,
    }
    impl Default for Params {
        fn default() -> Self {
            Self {
                m: 1.0,
                k: 2.0,
                pull: 0.1,
                FN: 1.0,
                sigma0: 1e5,
                sigma1: 316.22776601683796,
                sigma2: 0.4,
                mu_s: 1.5,
                mu_c: 1.0,
                v_s: 0.001,
            }
        }
    }
    impl Params {
        /// The values in the order of [`VARIABLES`].
        pub fn values(&self) -> [f64; 10] {
            [
                self.m,
                self.k,
                self.pull,
                self.FN,
                self.sigma0,
                self.sigma1,
                self.sigma2,
                self.mu_s,
                self.mu_c,
                self.v_s,
            ]
        }
        /// Params of values in the order of [`VARIABLES`].
        pub fn from_values(values: [f64; 10]) -> Self {
            Self {
                m: values[0],
                k: values[1],
                pull: values[2],
                FN: values[3],
                sigma0: values[4],
                sigma1: values[5],
                sigma2: values[6],
                mu_s: values[7],
                mu_c: values[8],
                v_s: values[9],
            }
        }
        /// Closes the loops and computes everything that depends on params alone.
        ///
        /// # Errors
        /// What is wrong with the parameter set, in the words of `flexure check`.
        pub fn prepare(&self) -> Result<Prepared<f64>, Diagnostic> {
            check_params(PARAMS, &self.values())?;
            let m = self.m;
            let k = self.k;
            let pull = self.pull;
            let FN = self.FN;
            let sigma0 = self.sigma0;
            let sigma1 = self.sigma1;
            let sigma2 = self.sigma2;
            let mu_s = self.mu_s;
            let mu_c = self.mu_c;
            let v_s = self.v_s;
            let F_C = mu_c * FN;
            let v_s_squared = v_s * v_s;
            let F_S = mu_s * FN;
            let F_S_minus_F_C = F_S - F_C;
            let dF_rope_dx_block = -k;
            let dddx_block_dx_block = dF_rope_dx_block / m;
            if !(m >= 0.0) {
                return Err(FAILURES[0].diagnostic(&[m]));
            }
            if !(sigma0 > 0.0) {
                return Err(FAILURES[1].diagnostic(&[sigma0]));
            }
            if !(sigma1 >= 0.0) {
                return Err(FAILURES[2].diagnostic(&[sigma1]));
            }
            if !(sigma2 >= 0.0) {
                return Err(FAILURES[3].diagnostic(&[sigma2]));
            }
            if !(mu_s > 0.0) {
                return Err(FAILURES[4].diagnostic(&[mu_s]));
            }
            if !(mu_c > 0.0) {
                return Err(FAILURES[5].diagnostic(&[mu_c]));
            }
            if !(v_s > 0.0) {
                return Err(FAILURES[6].diagnostic(&[v_s]));
            }
            if !(FN > 0.0) {
                return Err(FAILURES[7].diagnostic(&[FN]));
            }
            if !(m > 0.0) {
                return Err(FAILURES[8].diagnostic(&[]));
            }
            let prepared = Prepared {
                start_states: [0.0, 0.0, 0.0],
                start_discretes: [1.0],
                k,
                pull,
                sigma0,
                sigma1,
                sigma2,
                F_C,
                per_v_s_squared: v_s_squared.recip(),
                F_S_minus_F_C,
                per_sigma0: sigma0.recip(),
                per_m: m.recip(),
                dddx_block_dx_block,
                constant1: F_S_minus_F_C * 2.0 / (sigma0 * v_s_squared),
                half_m: m * 0.5,
                half_k: k * 0.5,
                half_sigma0: sigma0 * 0.5,
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
        pub start_states: [T; 3],
        /// Discrete state at the start.
        pub start_discretes: [T; 1],
        /// `k`
        pub k: T,
        /// `pull`
        pub pull: T,
        /// `sigma0`
        pub sigma0: T,
        /// `sigma1`
        pub sigma1: T,
        /// `sigma2`
        pub sigma2: T,
        /// `F_C`
        pub F_C: T,
        /// `1.0 / (v_s * v_s)`
        pub per_v_s_squared: T,
        /// `F_S - F_C`
        pub F_S_minus_F_C: T,
        /// `1.0 / sigma0`
        pub per_sigma0: T,
        /// `1.0 / m`
        pub per_m: T,
        /// `∂ẍ_block/∂x_block`
        pub dddx_block_dx_block: T,
        /// `2.0 * (F_S - F_C) / (sigma0 * v_s * v_s)`
        pub constant1: T,
        /// `0.5 * m`
        pub half_m: T,
        /// `0.5 * k`
        pub half_k: T,
        /// `0.5 * sigma0`
        pub half_sigma0: T,
        /// [`per_g_v_of_dx_block`] for a trajectory alone; fitted by `LaneSystem::alone`.
        pub curve_of_per_g_v: Curve,
    }
    impl<T: Copy> Prepared<T> {
        /// The same with every number turned into another, without curves: for dual numbers or lanes.
        pub fn map<U>(&self, turn: impl Fn(T) -> U) -> Prepared<U> {
            Prepared {
                start_states: self.start_states.map(&turn),
                start_discretes: self.start_discretes.map(&turn),
                k: turn(self.k),
                pull: turn(self.pull),
                sigma0: turn(self.sigma0),
                sigma1: turn(self.sigma1),
                sigma2: turn(self.sigma2),
                F_C: turn(self.F_C),
                per_v_s_squared: turn(self.per_v_s_squared),
                F_S_minus_F_C: turn(self.F_S_minus_F_C),
                per_sigma0: turn(self.per_sigma0),
                per_m: turn(self.per_m),
                dddx_block_dx_block: turn(self.dddx_block_dx_block),
                constant1: turn(self.constant1),
                half_m: turn(self.half_m),
                half_k: turn(self.half_k),
                half_sigma0: turn(self.half_sigma0),
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
                k: join(self.k, other.k),
                pull: join(self.pull, other.pull),
                sigma0: join(self.sigma0, other.sigma0),
                sigma1: join(self.sigma1, other.sigma1),
                sigma2: join(self.sigma2, other.sigma2),
                F_C: join(self.F_C, other.F_C),
                per_v_s_squared: join(self.per_v_s_squared, other.per_v_s_squared),
                F_S_minus_F_C: join(self.F_S_minus_F_C, other.F_S_minus_F_C),
                per_sigma0: join(self.per_sigma0, other.per_sigma0),
                per_m: join(self.per_m, other.per_m),
                dddx_block_dx_block: join(
                    self.dddx_block_dx_block,
                    other.dddx_block_dx_block,
                ),
                constant1: join(self.constant1, other.constant1),
                half_m: join(self.half_m, other.half_m),
                half_k: join(self.half_k, other.half_k),
                half_sigma0: join(self.half_sigma0, other.half_sigma0),
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
    /// `per_g_v`, which depends on `dx_block` and params alone, in closed form.
    #[inline(always)]
    pub fn per_g_v_of_dx_block<T: Real>(dx_block: T, p: &Prepared<T>) -> T {
        let t1 = p
            .F_C
            .plus_product(
                p.F_S_minus_F_C,
                (-(p.per_v_s_squared * (dx_block * dx_block))).exp(),
            );
        let g_v = p.per_sigma0 * t1;
        g_v.recip()
    }
    /// dx/dt. Where a loop cannot close, entries are not numbers.
    #[inline(always)]
    pub fn rhs<T: Real>(
        t: T,
        x: &[T; 3],
        d: &[T; 1],
        u: &[T; 0],
        p: &Prepared<T>,
        dx: &mut [T; 3],
    ) {
        let x_block = x[0];
        let dx_block = x[1];
        let z = x[2];
        let end_piece = d[0];
        // ── state ──
        // drive `end`
        let end = (end_piece - 0.5).if_positive(p.pull * t, T::from_f64(0.0));
        // force of `rope` on its second end
        let F_rope = p.k * (end - x_block);
        // friction force of `surface` on its second end, without what is known last
        let F_f_so_far = (p.sigma0 * z)
            .plus_product(p.sigma1, dx_block)
            .plus_product(p.sigma2, dx_block);
        // generalized force of all other forces, without what is known last
        let Q_block_so_far = F_rope - F_f_so_far;
        let z_abs_dx_block = z * dx_block.abs();
        let per_g_v = match p.curve_of_per_g_v.at(dx_block) {
            Some(value) => value,
            None => per_g_v_of_dx_block(dx_block, p),
        };
        let ddx_block = (p.per_m * Q_block_so_far)
            .plus_product(p.per_m * (p.sigma1 * z_abs_dx_block), per_g_v);
        let ż = dx_block.minus_product(z_abs_dx_block, per_g_v);
        dx[0] = dx_block;
        dx[1] = ddx_block;
        dx[2] = ż;
    }
    /// ∂(dx/dt)/∂x, row by row; entries that are always zero are left as they are.
    #[inline(always)]
    pub fn jacobian<T: Real>(
        t: T,
        x: &[T; 3],
        d: &[T; 1],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 9],
    ) {
        let dx_block = x[1];
        let z = x[2];
        // ── state ──
        let t1 = (-(p.per_v_s_squared * (dx_block * dx_block))).exp();
        let g_v = p.per_sigma0 * (p.F_C + p.F_S_minus_F_C * t1);
        let per_g_v = g_v.recip();
        let abs_dx_block = dx_block.abs();
        let dg_v_ddx_block = -(p.constant1 * (dx_block * t1));
        let dż_ddx_block = T::from_f64(1.0) - z * per_g_v * dx_block.sign()
            + z * abs_dx_block * (g_v * g_v).recip() * dg_v_ddx_block;
        let dF_f_ddx_block = p.sigma2 + p.sigma1 * dż_ddx_block;
        let dQ_block_ddx_block = -dF_f_ddx_block;
        let dddx_block_ddx_block = p.per_m * dQ_block_ddx_block;
        let dż_dz = -(abs_dx_block * per_g_v);
        let dF_f_dz = p.sigma0 + p.sigma1 * dż_dz;
        let dQ_block_dz = -dF_f_dz;
        let dddx_block_dz = p.per_m * dQ_block_dz;
        result[1] = T::from_f64(1.0);
        result[3] = p.dddx_block_dx_block;
        result[4] = dddx_block_ddx_block;
        result[5] = dddx_block_dz;
        result[7] = dż_ddx_block;
        result[8] = dż_dz;
    }
    /// The model's outputs.
    #[inline(always)]
    pub fn outputs<T: Real>(
        t: T,
        x: &[T; 3],
        d: &[T; 1],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let x_block = x[0];
        let dx_block = x[1];
        let z = x[2];
        // ── state ──
        let t1 = p.F_S_minus_F_C * (-(p.per_v_s_squared * (dx_block * dx_block))).exp();
        let g_v = p.per_sigma0 * (p.F_C + t1);
        let ż = dx_block - z * dx_block.abs() * g_v.recip();
        // friction force of `surface` on its second end
        let F_f = p.sigma0 * z + p.sigma1 * ż + p.sigma2 * dx_block;
        result[0] = x_block;
        result[1] = dx_block;
        result[2] = F_f;
        result[3] = z;
    }
    /// Kinetic and potential energy in J, dissipated and supplied power in W.
    #[inline(always)]
    pub fn energy<T: Real>(
        t: T,
        x: &[T; 3],
        d: &[T; 1],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let x_block = x[0];
        let dx_block = x[1];
        let z = x[2];
        let end_piece = d[0];
        // ── state ──
        let dx_block_squared = dx_block * dx_block;
        let end_piece_minus_half = end_piece - 0.5;
        // drive `end`
        let end = end_piece_minus_half.if_positive(p.pull * t, T::from_f64(0.0));
        let x_block_minus_end = x_block - end;
        let t1 = p.half_k * (x_block_minus_end * x_block_minus_end)
            + p.half_sigma0 * (z * z);
        let t2 = p.F_S_minus_F_C * (-(p.per_v_s_squared * dx_block_squared)).exp();
        let g_v = p.per_sigma0 * (p.F_C + t2);
        let ż = dx_block - z * dx_block.abs() * g_v.recip();
        // friction force of `surface` on its second end
        let F_f = p.sigma0 * z + p.sigma1 * ż + p.sigma2 * dx_block;
        // rate of the drive `end`
        let d_end_dt = end_piece_minus_half.if_positive(p.pull, T::from_f64(0.0));
        // force of `rope` on its second end
        let F_rope = p.k * (end - x_block);
        result[0] = p.half_m * dx_block_squared;
        result[1] = t1;
        result[2] = dx_block * F_f - p.sigma0 * (z * ż);
        result[3] = d_end_dt * F_rope;
    }
    /// Event functions: each event happens where its function rises through zero.
    #[inline(always)]
    pub fn events<T: Real>(
        t: T,
        x: &[T; 3],
        d: &[T; 1],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 0],
    ) {}
    /// For each loop a number that is positive where it closes and zero at a dead point.
    #[inline(always)]
    pub fn closures<T: Real>(
        t: T,
        x: &[T; 3],
        d: &[T; 1],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 0],
    ) {}
    /// The discrete state after an accepted step that ends in `x`; entries that stay are left as they are.
    #[inline(always)]
    pub fn accept<T: Real>(
        t: T,
        x: &[T; 3],
        d: &[T; 1],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 1],
    ) {}
    /// Time in s of each drive's next kink.
    #[inline(always)]
    pub fn next_kinks<T: Real>(d: &[T; 1], p: &Prepared<T>, result: &mut [T; 1]) {
        let end_piece = d[0];
        // ── state ──
        let t1 = (end_piece - 0.5).if_positive(T::from_f64(1e30), T::from_f64(0.0));
        result[0] = t1;
    }
    /// The discrete state after drive `index` passed its kink; entries that stay are left as they are.
    #[inline(always)]
    pub fn pass_kink<T: Real>(
        index: usize,
        d: &[T; 1],
        p: &Prepared<T>,
        result: &mut [T; 1],
    ) {
        match index {
            0 => {
                result[0] = T::from_f64(1.0);
            }
            _ => {}
        }
    }
    /// The state after event `index`; entries that stay are left as they are.
    #[inline(always)]
    pub fn pass_event<T: Real>(
        index: usize,
        t: T,
        x: &[T; 3],
        d: &[T; 1],
        u: &[T; 0],
        p: &Prepared<T>,
        x_after: &mut [T; 3],
        d_after: &mut [T; 1],
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
            let rows = [("dx_block", alone.curve_of_per_g_v.report())].into_iter();
            rows.filter_map(|(name, report)| Some((name, report?))).collect()
        }
        fn take_plain_steps(&self, steps: &mut PlainSteps<'_>) {
            steps.on_lanes(self);
        }
    }
    impl LaneSystem for Prepared<f64> {
        type InLanes<L: Lanes> = Prepared<L>;
        type States<L: Lanes> = [L; 3];
        type Discretes<L: Lanes> = [L; 1];
        type Loops<L: Lanes> = [L; 0];
        type Events<L: Lanes> = [L; 0];
        fn in_every_lane<L: Lanes>(&self) -> Prepared<L> {
            self.map(L::from_f64)
        }
        fn alone<L: Lanes>(&self) -> Prepared<L> {
            Prepared {
                curve_of_per_g_v: self
                    .curve_of_per_g_v
                    .fitted(|argument| per_g_v_of_dx_block(argument, self)),
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
    pub static VARIABLES: [Variable; 18] = [
        Variable {
            name: Cow::Borrowed("m"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass"),
            causality: Causality::Parameter,
            start: Some(1.0),
        },
        Variable {
            name: Cow::Borrowed("k"),
            unit: Cow::Borrowed("N/m"),
            meaning: Cow::Borrowed("spring stiffness"),
            causality: Causality::Parameter,
            start: Some(2.0),
        },
        Variable {
            name: Cow::Borrowed("pull"),
            unit: Cow::Borrowed("m/s"),
            meaning: Cow::Borrowed("velocity of the spring's far end"),
            causality: Causality::Parameter,
            start: Some(0.1),
        },
        Variable {
            name: Cow::Borrowed("FN"),
            unit: Cow::Borrowed("N"),
            meaning: Cow::Borrowed("normal force"),
            causality: Causality::Parameter,
            start: Some(1.0),
        },
        Variable {
            name: Cow::Borrowed("sigma0"),
            unit: Cow::Borrowed("N/m"),
            meaning: Cow::Borrowed("bristle stiffness"),
            causality: Causality::Parameter,
            start: Some(1e5),
        },
        Variable {
            name: Cow::Borrowed("sigma1"),
            unit: Cow::Borrowed("N*s/m"),
            meaning: Cow::Borrowed("bristle damping"),
            causality: Causality::Parameter,
            start: Some(316.22776601683796),
        },
        Variable {
            name: Cow::Borrowed("sigma2"),
            unit: Cow::Borrowed("N*s/m"),
            meaning: Cow::Borrowed("viscous friction"),
            causality: Causality::Parameter,
            start: Some(0.4),
        },
        Variable {
            name: Cow::Borrowed("mu_s"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("static friction over normal force"),
            causality: Causality::Parameter,
            start: Some(1.5),
        },
        Variable {
            name: Cow::Borrowed("mu_c"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("sliding friction over normal force"),
            causality: Causality::Parameter,
            start: Some(1.0),
        },
        Variable {
            name: Cow::Borrowed("v_s"),
            unit: Cow::Borrowed("m/s"),
            meaning: Cow::Borrowed("Stribeck velocity"),
            causality: Causality::Parameter,
            start: Some(0.001),
        },
        Variable {
            name: Cow::Borrowed("block.x"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("position of `block`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("block.v"),
            unit: Cow::Borrowed("m/s"),
            meaning: Cow::Borrowed("velocity of `block`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("surface.z"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("bristle deflection"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("end.piece"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("segment of the drive `end`"),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("position"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("position of the mass"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("velocity"),
            unit: Cow::Borrowed("m/s"),
            meaning: Cow::Borrowed("velocity of the mass"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("friction"),
            unit: Cow::Borrowed("N"),
            meaning: Cow::Borrowed("friction force on the ground"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("deflection"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("bristle deflection"),
            causality: Causality::Output,
            start: None,
        },
    ];
    static PARAMS: &[Variable] = VARIABLES.split_at(0).1.split_at(10).0;
    static STATES: &[Variable] = VARIABLES.split_at(10).1.split_at(3).0;
    static DISCRETES: &[Variable] = VARIABLES.split_at(13).1.split_at(1).0;
    static INPUTS: &[Variable] = VARIABLES.split_at(14).1.split_at(0).0;
    static OUTPUTS: &[Variable] = VARIABLES.split_at(14).1.split_at(4).0;
    static TURNING: [usize; 0] = [];
    static FAILURES: [Failure; 9] = [
        Failure {
            message: Cow::Borrowed("the mass of `block` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("lugre_mass.flex"),
                line: 21,
                column: 28,
                width: 4,
                excerpt: Cow::Borrowed("slide block along (1, 0) { mass = m }"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the bristle stiffness `sigma0` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("lugre_mass.flex"),
                line: 25,
                column: 9,
                width: 7,
                excerpt: Cow::Borrowed("contact surface between block and ground {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("N/m")]),
        },
        Failure {
            message: Cow::Borrowed("the bristle damping `sigma1` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("lugre_mass.flex"),
                line: 25,
                column: 9,
                width: 7,
                excerpt: Cow::Borrowed("contact surface between block and ground {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("N*s/m")]),
        },
        Failure {
            message: Cow::Borrowed("the viscous friction `sigma2` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("lugre_mass.flex"),
                line: 25,
                column: 9,
                width: 7,
                excerpt: Cow::Borrowed("contact surface between block and ground {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("N*s/m")]),
        },
        Failure {
            message: Cow::Borrowed("the static friction coefficient `mu_s` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("lugre_mass.flex"),
                line: 25,
                column: 9,
                width: 7,
                excerpt: Cow::Borrowed("contact surface between block and ground {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Number]),
        },
        Failure {
            message: Cow::Borrowed("the sliding friction coefficient `mu_c` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("lugre_mass.flex"),
                line: 25,
                column: 9,
                width: 7,
                excerpt: Cow::Borrowed("contact surface between block and ground {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Number]),
        },
        Failure {
            message: Cow::Borrowed("the Stribeck velocity `v_s` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("lugre_mass.flex"),
                line: 25,
                column: 9,
                width: 7,
                excerpt: Cow::Borrowed("contact surface between block and ground {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("m/s")]),
        },
        Failure {
            message: Cow::Borrowed("the preload is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("lugre_mass.flex"),
                line: 25,
                column: 9,
                width: 7,
                excerpt: Cow::Borrowed("contact surface between block and ground {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("N")]),
        },
        Failure {
            message: Cow::Borrowed("`block` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("lugre_mass.flex"),
                line: 21,
                column: 7,
                width: 5,
                excerpt: Cow::Borrowed("slide block along (1, 0) { mass = m }"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
    ];
    /// The equations of motion in plain text.
    pub const EQUATIONS: &str = r#"lugre_mass
══════════

Stick–slip of a mass that is pulled over a rough surface through a soft spring.

The standard example of the LuGre friction law: C. Canudas de Wit, H. Olsson, K. J. Åström,
P. Lischinsky, A new model for control of systems with friction, IEEE Transactions on
Automatic Control 40 (1995).

Drives
──────

  end(t) = ramp(pull)

Named forces
────────────

  F_rope = k (end - x_block)
  F_N    = FN
  v      = ẋ_block
  F_S    = mu_s F_N
  F_C    = mu_c F_N
  g(v)   = (F_C + (F_S - F_C) exp(-(v/v_s)²)) / sigma0
  ż      = v - z |v| / g(v)
  F_f    = sigma0 z + sigma1 ż + sigma2 v

Equation of motion of `block`
─────────────────────────────

  Q_block = F_rope - F_f

  m ẍ_block = Q_block
"#;
    /// The equations of motion as a LaTeX document.
    pub const EQUATIONS_LATEX: &str = r#"\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\begin{document}

\section*{lugre\_mass}
Stick–slip of a mass that is pulled over a rough surface through a soft spring.

The standard example of the LuGre friction law: C. Canudas de Wit, H. Olsson, K. J. Åström,
P. Lischinsky, A new model for control of systems with friction, IEEE Transactions on
Automatic Control 40 (1995).

\subsection*{Drives}
\begin{align*}
& \mathit{end}(t) = \text{ramp(pull)}
\end{align*}

\subsection*{Named forces}
\begin{align*}
F_{\mathrm{rope}} &= k \left(\mathit{end} - x_{\mathrm{block}}\right) \\
F_N &= \mathit{FN} \\
v &= \dot{x}_{\mathrm{block}} \\
F_S &= \mu_{s} \, F_N \\
F_C &= \mu_{c} \, F_N \\
g(v) &= \frac{F_C + \left(F_S - F_C\right) \exp\left(-\left(\frac{v}{v_{s}}\right)^{2}\right)}{\sigma_{0}} \\
\dot{z} &= v - \frac{z \left|v\right|}{g(v)} \\
F_{f} &= \sigma_{0} \, z + \sigma_{1} \, \dot{z} + \sigma_{2} \, v
\end{align*}

\subsection*{Equation of motion of \texttt{block}}
\begin{align*}
Q_{\mathrm{block}} &= F_{\mathrm{rope}} - F_{f} \\
& m\,\ddot{x}_{\mathrm{block}} = Q_{\mathrm{block}}
\end{align*}

\end{document}
"#;
}
