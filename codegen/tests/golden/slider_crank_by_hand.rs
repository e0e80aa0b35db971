/// Simulator of the model `slider_crank_by_hand`, generated from its equations of motion.
///
/// A crank with a rod.
#[allow(
    non_snake_case,
    non_upper_case_globals,
    unused,
    clippy::all,
    clippy::pedantic,
    rustdoc::all
)]
pub mod slider_crank_by_hand {
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
        /// the "r" of the crank; 0.1 by default
        pub r: f64,
        /// the "l" of the crank; 0.3 by default
        pub l: f64,
        /// the "type" of the crank; 0.5 by default
        pub type_: f64,
        /// the "E" of the crank; 5.0 by default
        pub E: f64,
        /// the "e" of the crank; 20.0 by default
        pub e: f64,
        /// the "β" of the crank; 0.2 by default
        pub β: f64,
    }
    impl Default for Params {
        fn default() -> Self {
            Self {
                r: 0.1,
                l: 0.3,
                type_: 0.5,
                E: 5.0,
                e: 20.0,
                β: 0.2,
            }
        }
    }
    impl Params {
        /// The set `long`: its values, all others by default. a longer rod
        pub fn long() -> Self {
            Self { l: 1.0, ..Self::default() }
        }
        /// The values in the order of [`VARIABLES`].
        pub fn values(&self) -> [f64; 6] {
            [self.r, self.l, self.type_, self.E, self.e, self.β]
        }
        /// Params of values in the order of [`VARIABLES`].
        pub fn from_values(values: [f64; 6]) -> Self {
            Self {
                r: values[0],
                l: values[1],
                type_: values[2],
                E: values[3],
                e: values[4],
                β: values[5],
            }
        }
        /// Closes the loops and computes everything that depends on params alone.
        ///
        /// # Errors
        /// What is wrong with the parameter set, in the words of `flexure check`.
        pub fn prepare(&self) -> Result<Prepared<f64>, Diagnostic> {
            check_params(PARAMS, &self.values())?;
            let r = self.r;
            let l = self.l;
            let type_ = self.type_;
            let E = self.E;
            let e = self.e;
            let β = self.β;
            let r_squared = r * r;
            let l_squared = l * l;
            let (sin_β, cos_β) = Real::sin_cos(β);
            // inertia
            let J = r_squared * type_;
            if !(l - r > 0.0) {
                return Err(FAILURES[0].diagnostic(&[l, r]));
            }
            let mut solution = [β];
            let solved = newton::solve(
                &mut solution,
                &[1.0],
                &mut |unknowns, residuals, derivatives| {
                    let θ = unknowns[0];
                    let (sin_θ, cos_θ) = Real::sin_cos(θ);
                    let lifted = θ + sin_θ * 0.5;
                    let dlifted_dθ = cos_θ * 0.5 + 1.0;
                    residuals[0] = lifted - β;
                    derivatives[0] = dlifted_dθ;
                },
            );
            let [θ] = solution;
            if solved.is_err() {
                return Err(FAILURES[1].diagnostic(&[β]));
            }
            let sin_θ_2 = Real::sin(θ);
            let t1 = Real::atan2(
                -(r * sin_θ_2 / l),
                (1.0 - r_squared * (sin_θ_2 * sin_θ_2) / l_squared).sqrt(),
            );
            let mut prepared = Prepared {
                start_states: [θ, 0.0],
                start_discretes: [0.0, 0.5, t1],
                r,
                l,
                type_,
                E,
                e,
                θ,
                r_squared_per_l_squared: r_squared / l_squared,
                r_per_l: r / l,
                cos_β,
                sin_β,
                r_type: r * type_,
                per_J: J.recip(),
                constant1: 0.25 - E,
                half_J: J * 0.5,
                half_E: E * 0.5,
                per_e: e.recip(),
                table_of_φ1: Table::none(),
                curve_of_half_plus_half_tanh_ω: Curve::wanted(),
            };
            check_start(prepared.states(), &prepared.start_states)?;
            check_start(prepared.discretes(), &prepared.start_discretes)?;
            prepared.table_of_φ1 = Table::fit(
                &prepared,
                &COORDINATES,
                0,
                1,
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
        pub start_discretes: [T; 3],
        /// `r`
        pub r: T,
        /// `l`
        pub l: T,
        /// `type`
        pub type_: T,
        /// `E`
        pub E: T,
        /// `e`
        pub e: T,
        /// `θ`
        pub θ: T,
        /// `r * r / (l * l)`
        pub r_squared_per_l_squared: T,
        /// `r / l`
        pub r_per_l: T,
        /// `cos(β)`
        pub cos_β: T,
        /// `sin(β)`
        pub sin_β: T,
        /// `r * type`
        pub r_type: T,
        /// `1.0 / J`
        pub per_J: T,
        /// `0.25 - E`
        pub constant1: T,
        /// `0.5 * J`
        pub half_J: T,
        /// `0.5 * E`
        pub half_E: T,
        /// `1.0 / e`
        pub per_e: T,
        /// [`functions_of_φ1`] near the start.
        pub table_of_φ1: Table<T, 3>,
        /// [`half_plus_half_tanh_ω_of_ω`] for a trajectory alone; fitted by `LaneSystem::alone`.
        pub curve_of_half_plus_half_tanh_ω: Curve,
    }
    impl<T: Copy> Prepared<T> {
        /// The same with every number turned into another, without curves: for dual numbers or lanes.
        pub fn map<U>(&self, turn: impl Fn(T) -> U) -> Prepared<U> {
            Prepared {
                start_states: self.start_states.map(&turn),
                start_discretes: self.start_discretes.map(&turn),
                r: turn(self.r),
                l: turn(self.l),
                type_: turn(self.type_),
                E: turn(self.E),
                e: turn(self.e),
                θ: turn(self.θ),
                r_squared_per_l_squared: turn(self.r_squared_per_l_squared),
                r_per_l: turn(self.r_per_l),
                cos_β: turn(self.cos_β),
                sin_β: turn(self.sin_β),
                r_type: turn(self.r_type),
                per_J: turn(self.per_J),
                constant1: turn(self.constant1),
                half_J: turn(self.half_J),
                half_E: turn(self.half_E),
                per_e: turn(self.per_e),
                table_of_φ1: self.table_of_φ1.map(&turn),
                curve_of_half_plus_half_tanh_ω: Curve::none(),
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
                r: join(self.r, other.r),
                l: join(self.l, other.l),
                type_: join(self.type_, other.type_),
                E: join(self.E, other.E),
                e: join(self.e, other.e),
                θ: join(self.θ, other.θ),
                r_squared_per_l_squared: join(
                    self.r_squared_per_l_squared,
                    other.r_squared_per_l_squared,
                ),
                r_per_l: join(self.r_per_l, other.r_per_l),
                cos_β: join(self.cos_β, other.cos_β),
                sin_β: join(self.sin_β, other.sin_β),
                r_type: join(self.r_type, other.r_type),
                per_J: join(self.per_J, other.per_J),
                constant1: join(self.constant1, other.constant1),
                half_J: join(self.half_J, other.half_J),
                half_E: join(self.half_E, other.half_E),
                per_e: join(self.per_e, other.per_e),
                table_of_φ1: self.table_of_φ1.zip(&other.table_of_φ1, &join),
                curve_of_half_plus_half_tanh_ω: Curve::none(),
            }
        }
    }
    impl Prepared<f64> {
        /// The same without tables and curves: closed forms everywhere.
        pub fn exact(self) -> Self {
            Self {
                table_of_φ1: Table::none(),
                curve_of_half_plus_half_tanh_ω: Curve::none(),
                ..self
            }
        }
    }
    /// What [`rhs`], [`accept`] and [`closures`] need that depends on `φ1` and params alone, in closed form.
    #[inline(always)]
    pub fn functions_of_φ1<T: Real>(φ1: T, d: &[T; 3], p: &Prepared<T>) -> [T; 3] {
        let φ2_reference = d[2];
        let t1 = p.type_
            * (((φ1 + p.θ) * 0.5).sin() * ((p.θ - φ1) * 0.5).sin() * 2.0);
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let t2 = T::from_f64(1.0) - p.r_squared_per_l_squared * (sin_φ1 * sin_φ1);
        let cos_φ2 = t2.sqrt();
        let sin_φ2 = -(p.r_per_l * sin_φ1);
        let cos_φ1_minus_φ2 = cos_φ1 * cos_φ2 + sin_φ1 * sin_φ2;
        let sin_φ1_minus_φ2 = sin_φ1 * cos_φ2 - cos_φ1 * sin_φ2;
        let t3 = p.r_type
            * (p.cos_β * cos_φ1_minus_φ2 + p.sin_β * sin_φ1_minus_φ2);
        let t4 = φ1 * 0.25 + 0.5;
        let (t5, t6) = t4.sin_cos();
        let t7 = t1 - t3 - p.E * (φ1 - p.θ) + t5 + t6 + t4.tan() + t4.asin()
            + t4.acos();
        let t8 = t7 + t4.atan() + t4.tanh() + t4.exp() + t4.ln() + t4.abs() + t4.sign();
        // angle of the rod
        let φ2 = sin_φ2.atan2(cos_φ2).unwrap_to(φ2_reference);
        [t8 + t4.floor(), φ2, t2]
    }
    /// `half_plus_half_tanh_ω`, which depends on `ω` and params alone, in closed form.
    #[inline(always)]
    pub fn half_plus_half_tanh_ω_of_ω<T: Real>(ω: T, p: &Prepared<T>) -> T {
        ω.tanh() * 0.5 + 0.5
    }
    /// dx/dt. Where a loop cannot close, entries are not numbers.
    #[inline(always)]
    pub fn rhs<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 3],
        u: &[T; 1],
        p: &Prepared<T>,
        dx: &mut [T; 2],
    ) {
        let φ1 = x[0];
        let ω = x[1];
        let n = d[0];
        let level = d[1];
        let u_2 = u[0];
        let [t1, ..] = if p.table_of_φ1.covers(φ1) {
            p.table_of_φ1.polynomials(φ1)
        } else {
            p.table_of_φ1.where_covered(φ1, functions_of_φ1(φ1, d, p))
        };
        // ── configuration ──
        let t2 = φ1 * 0.25 + 0.5;
        // ── state ──
        let t3 = (t1 + u_2 + level).minus_product(p.E, n.minus_product(p.e, t));
        let half_plus_half_tanh_ω = match p.curve_of_half_plus_half_tanh_ω.at(ω) {
            Some(value) => value,
            None => half_plus_half_tanh_ω_of_ω(ω, p),
        };
        let t4 = t3 + t2.smaller(half_plus_half_tanh_ω)
            + t2.larger(half_plus_half_tanh_ω);
        let t5 = t4 + (u_2 * 0.25).if_positive(t2, half_plus_half_tanh_ω)
            + t2.unwrap_to(half_plus_half_tanh_ω);
        let t6 = t5 + t2.atan2(half_plus_half_tanh_ω)
            + t2.power(half_plus_half_tanh_ω);
        let t7 = (t2 + half_plus_half_tanh_ω) * 0.5;
        let (t9, t8) = t7.sin_cos();
        let t10 = (p.per_J
            * (t6 + t8 * ((t2 - half_plus_half_tanh_ω) * 0.5).sin() * 2.0))
            .plus_product(
                p.per_J * (((half_plus_half_tanh_ω - t2) * 0.5).sin() * 2.0),
                t9,
            );
        dx[0] = ω;
        dx[1] = t10;
    }
    /// ∂(dx/dt)/∂x, row by row; entries that are always zero are left as they are.
    #[inline(always)]
    pub fn jacobian<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 3],
        u: &[T; 1],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let φ1 = x[0];
        let ω = x[1];
        let u_2 = u[0];
        // ── configuration ──
        let t1 = φ1 * 0.25;
        let t2 = t1 + 0.5;
        let (t3, t4) = t2.sin_cos();
        let t5 = p.constant1 - t3 * 0.5 + t4 * 0.5 + t2.exp() * 0.25 + t2.sign() * 0.25;
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let cos_φ2 = (T::from_f64(1.0)
            - p.r_squared_per_l_squared * (sin_φ1 * sin_φ1))
            .sqrt();
        let sin_φ2 = -(p.r_per_l * sin_φ1);
        let cos_φ1_minus_φ2 = cos_φ1 * cos_φ2 + sin_φ1 * sin_φ2;
        let sin_φ1_minus_φ2 = sin_φ1 * cos_φ2 - cos_φ1 * sin_φ2;
        let t6 = (p.sin_β * cos_φ1_minus_φ2 - p.cos_β * sin_φ1_minus_φ2)
            * (p.r_per_l * (cos_φ2.recip() * cos_φ1) + 1.0);
        let t7 = t2.tan();
        let t8 = t2 * t2;
        let t9 = t5 - p.r_type * t6 - p.type_ * sin_φ1 + (t7 * t7 + 1.0) * 0.25
            + T::from_f64(0.25) / (t8 + 1.0);
        let t10 = t2.tanh();
        // ── state ──
        let tanh_ω = ω.tanh();
        let half_tanh_ω = tanh_ω * 0.5;
        let half_plus_half_tanh_ω = half_tanh_ω + 0.5;
        let t11 = (t8 + half_plus_half_tanh_ω * half_plus_half_tanh_ω).recip();
        let t12 = t9 - (t10 * t10 - 1.0) * 0.25 + T::from_f64(0.25) / t2
            + half_plus_half_tanh_ω * t11 * 0.25;
        let t13 = half_tanh_ω - t1;
        let t14 = t1 - half_tanh_ω;
        let t15 = t12 + t13.if_positive(T::from_f64(0.25), T::from_f64(0.0))
            + t14.if_positive(T::from_f64(0.25), T::from_f64(0.0));
        let t16 = t15 + half_plus_half_tanh_ω * t2.power(half_tanh_ω - 0.5) * 0.25;
        let t17 = u_2 * 0.25;
        let t18 = p.per_J * (t16 + t17.if_positive(T::from_f64(0.25), T::from_f64(0.0)));
        let tanh_ω_squared_minus_one = tanh_ω * tanh_ω - 1.0;
        let t19 = -(tanh_ω_squared_minus_one * 0.5);
        let t20 = t2 * 0.5 * (t11 * tanh_ω_squared_minus_one)
            + t13.if_positive(T::from_f64(0.0), t19);
        let t21 = t2.ln() * 0.5
            * (t2.power(half_plus_half_tanh_ω) * tanh_ω_squared_minus_one);
        let (t22, t23) = half_plus_half_tanh_ω.sin_cos();
        let t24 = t20 + t14.if_positive(T::from_f64(0.0), t19) - t21
            - tanh_ω_squared_minus_one * t22 * 0.5;
        let t25 = t24 + tanh_ω_squared_minus_one * t23 * 0.5
            + t17.if_positive(T::from_f64(0.0), t19);
        result[1] = T::from_f64(1.0);
        result[2] = t18;
        result[3] = p.per_J * t25;
    }
    /// The model's outputs.
    #[inline(always)]
    pub fn outputs<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 3],
        u: &[T; 1],
        p: &Prepared<T>,
        result: &mut [T; 21],
    ) {
        let φ1 = x[0];
        let ω = x[1];
        let u_2 = u[0];
        // ── configuration ──
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let cos_φ2 = (T::from_f64(1.0)
            - p.r_squared_per_l_squared * (sin_φ1 * sin_φ1))
            .sqrt();
        let t1 = φ1 * 0.25 + 0.5;
        let (t2, t3) = t1.sin_cos();
        // ── state ──
        let half_plus_half_tanh_ω = ω.tanh() * 0.5 + 0.5;
        let t4 = (t1 + half_plus_half_tanh_ω) * 0.5;
        let (t5, t6) = t4.sin_cos();
        result[0] = p.r * cos_φ1 + p.l * cos_φ2;
        result[1] = t2;
        result[2] = t3;
        result[3] = t1.tan();
        result[4] = t1.asin();
        result[5] = t1.acos();
        result[6] = t1.atan();
        result[7] = t1.tanh();
        result[8] = t1.exp();
        result[9] = t1.ln();
        result[10] = t1.abs();
        result[11] = t1.sign();
        result[12] = t1.floor();
        result[13] = t1.atan2(half_plus_half_tanh_ω);
        result[14] = t1.smaller(half_plus_half_tanh_ω);
        result[15] = t1.larger(half_plus_half_tanh_ω);
        result[16] = t1.power(half_plus_half_tanh_ω);
        result[17] = t5 * ((half_plus_half_tanh_ω - t1) * 0.5).sin() * 2.0;
        result[18] = t6 * ((t1 - half_plus_half_tanh_ω) * 0.5).sin() * 2.0;
        result[19] = t1.unwrap_to(half_plus_half_tanh_ω);
        result[20] = (u_2 * 0.25).if_positive(t1, half_plus_half_tanh_ω);
    }
    /// Kinetic and potential energy in J, dissipated and supplied power in W.
    #[inline(always)]
    pub fn energy<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 3],
        u: &[T; 1],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let φ1 = x[0];
        let ω = x[1];
        let u_2 = u[0];
        // ── configuration ──
        let φ1_minus_θ = φ1 - p.θ;
        result[0] = p.half_J * (ω * ω);
        result[1] = p.half_E * (φ1_minus_θ * φ1_minus_θ);
        result[2] = T::from_f64(0.0);
        result[3] = u_2 * ω;
    }
    /// Event functions: each event happens where its function rises through zero.
    #[inline(always)]
    pub fn events<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 3],
        u: &[T; 1],
        p: &Prepared<T>,
        result: &mut [T; 1],
    ) {
        let φ1 = x[0];
        result[0] = φ1 - 3.0;
    }
    /// For each loop a number that is positive where it closes and zero at a dead point.
    #[inline(always)]
    pub fn closures<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 3],
        u: &[T; 1],
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
        d: &[T; 3],
        u: &[T; 1],
        p: &Prepared<T>,
        result: &mut [T; 3],
    ) {
        let φ1 = x[0];
        let [.., φ2, _] = if p.table_of_φ1.covers(φ1) {
            p.table_of_φ1.polynomials(φ1)
        } else {
            p.table_of_φ1.where_covered(φ1, functions_of_φ1(φ1, d, p))
        };
        result[2] = φ2;
    }
    /// Time in s of each drive's next kink.
    #[inline(always)]
    pub fn next_kinks<T: Real>(d: &[T; 3], p: &Prepared<T>, result: &mut [T; 1]) {
        let n = d[0];
        result[0] = p.per_e * (n + 1.0);
    }
    /// The discrete state after drive `index` passed its kink; entries that stay are left as they are.
    #[inline(always)]
    pub fn pass_kink<T: Real>(
        index: usize,
        d: &[T; 3],
        p: &Prepared<T>,
        result: &mut [T; 3],
    ) {
        match index {
            0 => {
                let n = d[0];
                result[0] = n + 1.0;
                result[1] = n.lookup(&TABLE_1);
            }
            _ => {}
        }
    }
    /// The state after event `index`; entries that stay are left as they are.
    #[inline(always)]
    pub fn pass_event<T: Real>(
        index: usize,
        t: T,
        x: &[T; 2],
        d: &[T; 3],
        u: &[T; 1],
        p: &Prepared<T>,
        x_after: &mut [T; 2],
        d_after: &mut [T; 3],
    ) {
        match index {
            0 => {
                let ω = x[1];
                x_after[1] = -ω;
            }
            _ => {}
        }
    }
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
            1
        }
        fn events(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], values: &mut [f64]) {
            events(t, array(x), array(d), array(u), self, array_mut(values));
        }
        fn event_name(&self, index: usize) -> &str {
            const NAMES: [&str; 1] = ["crank too far"];
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
                0 => EventAction::Stop(Cow::Borrowed("the crank left its range")),
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
            const NAMES: [&str; 1] = ["crank–rod"];
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
            let rows = [("ω", alone.curve_of_half_plus_half_tanh_ω.report())]
                .into_iter();
            rows.filter_map(|(name, report)| Some((name, report?))).collect()
        }
        fn take_plain_steps(&self, steps: &mut PlainSteps<'_>) {
            steps.on_lanes(self);
        }
    }
    impl LaneSystem for Prepared<f64> {
        type InLanes<L: Lanes> = Prepared<L>;
        type States<L: Lanes> = [L; 2];
        type Discretes<L: Lanes> = [L; 3];
        type Loops<L: Lanes> = [L; 1];
        type Events<L: Lanes> = [L; 1];
        fn in_every_lane<L: Lanes>(&self) -> Prepared<L> {
            self.map(L::from_f64)
        }
        fn alone<L: Lanes>(&self) -> Prepared<L> {
            Prepared {
                curve_of_half_plus_half_tanh_ω: self
                    .curve_of_half_plus_half_tanh_ω
                    .fitted(|argument| half_plus_half_tanh_ω_of_ω(argument, self)),
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
    pub static VARIABLES: [Variable; 33] = [
        Variable {
            name: Cow::Borrowed("r"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("the \"r\" of the crank"),
            causality: Causality::Parameter,
            start: Some(0.1),
        },
        Variable {
            name: Cow::Borrowed("l"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("the \"l\" of the crank"),
            causality: Causality::Parameter,
            start: Some(0.3),
        },
        Variable {
            name: Cow::Borrowed("type"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("the \"type\" of the crank"),
            causality: Causality::Parameter,
            start: Some(0.5),
        },
        Variable {
            name: Cow::Borrowed("E"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("the \"E\" of the crank"),
            causality: Causality::Parameter,
            start: Some(5.0),
        },
        Variable {
            name: Cow::Borrowed("e"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("the \"e\" of the crank"),
            causality: Causality::Parameter,
            start: Some(20.0),
        },
        Variable {
            name: Cow::Borrowed("β"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("the \"β\" of the crank"),
            causality: Causality::Parameter,
            start: Some(0.2),
        },
        Variable {
            name: Cow::Borrowed("crank.angle"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("angle of the crank"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("crank.rate"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed("its rate"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("drive.cycle"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("periods completed"),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("drive.level"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("torque of the present period"),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("rod.reference"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("angle of the rod after the last step"),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("motor"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("torque on the crank"),
            causality: Causality::Input,
            start: Some(0.0),
        },
        Variable {
            name: Cow::Borrowed("slider.x"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("where the rod ends"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("sin"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("cos"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("tan"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("asin"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("acos"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("atan"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("tanh"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("exp"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("log"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("abs"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("sign"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("floor"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("atan2"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("min"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("max"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("power"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("cos_difference"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("sin_difference"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("unwrap"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("if_positive"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
    ];
    static PARAMS: &[Variable] = VARIABLES.split_at(0).1.split_at(6).0;
    static STATES: &[Variable] = VARIABLES.split_at(6).1.split_at(2).0;
    static DISCRETES: &[Variable] = VARIABLES.split_at(8).1.split_at(3).0;
    static INPUTS: &[Variable] = VARIABLES.split_at(11).1.split_at(1).0;
    static OUTPUTS: &[Variable] = VARIABLES.split_at(12).1.split_at(21).0;
    /// Positions of the coordinates and of their rates among the states.
    static COORDINATES: [(usize, usize); 1] = [(0, 1)];
    static TURNING: [usize; 1] = [2];
    static FAILURES: [Failure; 2] = [
        Failure {
            message: Cow::Borrowed("the rod of {0} is shorter than the crank"),
            hint: Some(Cow::Borrowed("make it longer than {1}")),
            site: None,
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("no relaxed angle for {0}"),
            hint: None,
            site: None,
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Degree]),
        },
    ];
    static TABLE_1: [f64; 3] = [0.25, -1.5, 2.0];
    /// The equations of motion in plain text.
    pub const EQUATIONS: &str = r#"slider_crank_by_hand
════════════════════

A crank with a rod.
"#;
    /// The equations of motion as a LaTeX document.
    pub const EQUATIONS_LATEX: &str = r#"\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\begin{document}

\section*{slider\_crank\_by\_hand}
A crank with a rod.

\end{document}
"#;
}
