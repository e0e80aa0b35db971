/// Simulator of the model `parallelogram_stage`, generated from its equations of motion.
///
/// A stage on two leaf springs, each as a pseudo-rigid link with a torsion spring at either end.
///
/// A leaf whose ends stay parallel: a link of 0.8517 of its length and stiffness 2 γ K_Θ E I / L at
/// either end, K_Θ = 2.65 (Howell, Compliant Mechanisms, 2001). The stage moves in translation.
#[allow(
    non_snake_case,
    non_upper_case_globals,
    unused,
    clippy::all,
    clippy::pedantic,
    rustdoc::all
)]
pub mod parallelogram_stage {
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
        /// length, width and thickness of a leaf in m; 0.04 by default
        pub L: f64,
        /// length, width and thickness of a leaf in m; 0.01 by default
        pub b: f64,
        /// length, width and thickness of a leaf in m; 0.0005 by default
        pub h: f64,
        /// between the leaves in m; 0.05 by default
        pub gap: f64,
        /// mass of a leaf, of the stage in kg; 0.00054 by default
        pub ml: f64,
        /// mass of a leaf, of the stage in kg; 0.06 by default
        pub ms: f64,
        /// force on the stage in N; 2.0 by default
        pub push: f64,
        /// force on the stage in 1/s; 15.0 by default
        pub f: f64,
    }
    impl Default for Params {
        fn default() -> Self {
            Self {
                E: 7.2e10,
                L: 0.04,
                b: 0.01,
                h: 0.0005,
                gap: 0.05,
                ml: 0.00054,
                ms: 0.06,
                push: 2.0,
                f: 15.0,
            }
        }
    }
    impl Params {
        /// The values in the order of [`VARIABLES`].
        pub fn values(&self) -> [f64; 9] {
            [
                self.E,
                self.L,
                self.b,
                self.h,
                self.gap,
                self.ml,
                self.ms,
                self.push,
                self.f,
            ]
        }
        /// Params of values in the order of [`VARIABLES`].
        pub fn from_values(values: [f64; 9]) -> Self {
            Self {
                E: values[0],
                L: values[1],
                b: values[2],
                h: values[3],
                gap: values[4],
                ml: values[5],
                ms: values[6],
                push: values[7],
                f: values[8],
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
            let gap = self.gap;
            let ml = self.ml;
            let ms = self.ms;
            let push = self.push;
            let f = self.f;
            // length of the pseudo-rigid link
            let l = L * 0.8517;
            let l_squared = l * l;
            // moment of inertia about the centre of mass of left
            let I_left = l_squared * ml * 0.08333333333333333;
            // moment of inertia about the centre of mass of stage
            let I_stage = gap * gap * ms * 0.08333333333333333;
            // distance of the centre of mass from the first end of left
            let r_left = l * 0.5;
            // constant of the inertia
            let C0 = I_left * 2.0 + ml * (r_left * r_left) * 2.0 + l_squared * ms;
            // second moment of area
            let I = b * (h * (h * h)) * 0.08333333333333333;
            // stiffness at either end of a leaf
            let k = E * I * 4.51401 / L;
            let ddP_s_dφ_dφ = k * 4.0;
            if !(l > 0.0) {
                return Err(FAILURES[0].diagnostic(&[l]));
            }
            if !(ml >= 0.0) {
                return Err(FAILURES[1].diagnostic(&[ml]));
            }
            if !(I_left >= 0.0) {
                return Err(FAILURES[2].diagnostic(&[I_left]));
            }
            if !(gap > 0.0) {
                return Err(FAILURES[3].diagnostic(&[gap]));
            }
            if !(ms >= 0.0) {
                return Err(FAILURES[4].diagnostic(&[ms]));
            }
            if !(I_stage >= 0.0) {
                return Err(FAILURES[5].diagnostic(&[I_stage]));
            }
            if !(C0 > 0.0) {
                return Err(FAILURES[6].diagnostic(&[]));
            }
            let prepared = Prepared {
                start_states: [1.5707963267948966, 0.0],
                start_discretes: [],
                l,
                k,
                ddP_s_dφ_dφ,
                constant1: f * 6.283185307179586,
                l_push: l * push,
                per_C0: C0.recip(),
                half_C0: C0 * 0.5,
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
        pub start_states: [T; 2],
        /// Discrete state at the start.
        pub start_discretes: [T; 0],
        /// `l` length of the pseudo-rigid link
        pub l: T,
        /// `k` stiffness at either end of a leaf
        pub k: T,
        /// `∂∂P_s/∂φ/∂φ`
        pub ddP_s_dφ_dφ: T,
        /// `6.283185307179586 * f`
        pub constant1: T,
        /// `l * push`
        pub l_push: T,
        /// `1.0 / C0`
        pub per_C0: T,
        /// `0.5 * C0`
        pub half_C0: T,
    }
    impl<T: Copy> Prepared<T> {
        /// The same with every number turned into another, without curves: for dual numbers or lanes.
        pub fn map<U>(&self, turn: impl Fn(T) -> U) -> Prepared<U> {
            Prepared {
                start_states: self.start_states.map(&turn),
                start_discretes: self.start_discretes.map(&turn),
                l: turn(self.l),
                k: turn(self.k),
                ddP_s_dφ_dφ: turn(self.ddP_s_dφ_dφ),
                constant1: turn(self.constant1),
                l_push: turn(self.l_push),
                per_C0: turn(self.per_C0),
                half_C0: turn(self.half_C0),
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
                l: join(self.l, other.l),
                k: join(self.k, other.k),
                ddP_s_dφ_dφ: join(self.ddP_s_dφ_dφ, other.ddP_s_dφ_dφ),
                constant1: join(self.constant1, other.constant1),
                l_push: join(self.l_push, other.l_push),
                per_C0: join(self.per_C0, other.per_C0),
                half_C0: join(self.half_C0, other.half_C0),
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
        x: &[T; 2],
        d: &[T; 0],
        u: &[T; 0],
        p: &Prepared<T>,
        dx: &mut [T; 2],
    ) {
        let φ = x[0];
        let dφ = x[1];
        // ── configuration ──
        // slope of the potential energy of springs
        let dP_s_dφ = p.ddP_s_dφ_dφ * (φ - 1.5707963267948966);
        // ── state ──
        let t1 = dP_s_dφ.plus_product(p.l_push * φ.sin(), (p.constant1 * t).sin());
        let ddφ = -(p.per_C0 * t1);
        dx[0] = dφ;
        dx[1] = ddφ;
    }
    /// ∂(dx/dt)/∂x, row by row; entries that are always zero are left as they are.
    #[inline(always)]
    pub fn jacobian<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 0],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let φ = x[0];
        // ── state ──
        let t1 = p.per_C0
            * (p.ddP_s_dφ_dφ + p.l_push * φ.cos() * (p.constant1 * t).sin());
        let dddφ_dφ = -t1;
        result[1] = T::from_f64(1.0);
        result[2] = dddφ_dφ;
    }
    /// The model's outputs.
    #[inline(always)]
    pub fn outputs<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 0],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 2],
    ) {
        let φ = x[0];
        // ── configuration ──
        let (sin_φ, cos_φ) = φ.sin_cos();
        let P1_x = p.l * cos_φ;
        let P1_y = p.l * sin_φ;
        result[0] = P1_x;
        result[1] = P1_y;
    }
    /// Kinetic and potential energy in J, dissipated and supplied power in W.
    #[inline(always)]
    pub fn energy<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 0],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let φ = x[0];
        let dφ = x[1];
        // ── configuration ──
        let t1 = φ - 1.5707963267948966;
        let t2 = T::from_f64(1.5707963267948966) - φ;
        result[0] = p.half_C0 * (dφ * dφ);
        result[1] = p.k * (t1 * t1) + p.k * (t2 * t2);
        result[2] = T::from_f64(0.0);
        result[3] = -(p.l_push * φ.sin() * ((p.constant1 * t).sin() * dφ));
    }
    /// Event functions: each event happens where its function rises through zero.
    #[inline(always)]
    pub fn events<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 0],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 0],
    ) {}
    /// For each loop a number that is positive where it closes and zero at a dead point.
    #[inline(always)]
    pub fn closures<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 0],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 0],
    ) {}
    /// The discrete state after an accepted step that ends in `x`; entries that stay are left as they are.
    #[inline(always)]
    pub fn accept<T: Real>(
        t: T,
        x: &[T; 2],
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
        x: &[T; 2],
        d: &[T; 0],
        u: &[T; 0],
        p: &Prepared<T>,
        x_after: &mut [T; 2],
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
        fn take_plain_steps(&self, steps: &mut PlainSteps<'_>) {
            steps.on_lanes(self);
        }
    }
    impl LaneSystem for Prepared<f64> {
        type InLanes<L: Lanes> = Prepared<L>;
        type States<L: Lanes> = [L; 2];
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
    }
    /// Every quantity with a name: params, states, discrete states, inputs, outputs.
    pub static VARIABLES: [Variable; 13] = [
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
            start: Some(0.04),
        },
        Variable {
            name: Cow::Borrowed("b"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length, width and thickness of a leaf"),
            causality: Causality::Parameter,
            start: Some(0.01),
        },
        Variable {
            name: Cow::Borrowed("h"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length, width and thickness of a leaf"),
            causality: Causality::Parameter,
            start: Some(0.0005),
        },
        Variable {
            name: Cow::Borrowed("gap"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("between the leaves"),
            causality: Causality::Parameter,
            start: Some(0.05),
        },
        Variable {
            name: Cow::Borrowed("ml"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of a leaf, of the stage"),
            causality: Causality::Parameter,
            start: Some(0.00054),
        },
        Variable {
            name: Cow::Borrowed("ms"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of a leaf, of the stage"),
            causality: Causality::Parameter,
            start: Some(0.06),
        },
        Variable {
            name: Cow::Borrowed("push"),
            unit: Cow::Borrowed("N"),
            meaning: Cow::Borrowed("force on the stage"),
            causality: Causality::Parameter,
            start: Some(2.0),
        },
        Variable {
            name: Cow::Borrowed("f"),
            unit: Cow::Borrowed("1/s"),
            meaning: Cow::Borrowed("force on the stage"),
            causality: Causality::Parameter,
            start: Some(15.0),
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
            name: Cow::Borrowed("x"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("position of the stage along its travel"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("y"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("its height, which falls as it travels"),
            causality: Causality::Output,
            start: None,
        },
    ];
    static PARAMS: &[Variable] = VARIABLES.split_at(0).1.split_at(9).0;
    static STATES: &[Variable] = VARIABLES.split_at(9).1.split_at(2).0;
    static DISCRETES: &[Variable] = VARIABLES.split_at(11).1.split_at(0).0;
    static INPUTS: &[Variable] = VARIABLES.split_at(11).1.split_at(0).0;
    static OUTPUTS: &[Variable] = VARIABLES.split_at(11).1.split_at(2).0;
    static TURNING: [usize; 0] = [];
    static FAILURES: [Failure; 7] = [
        Failure {
            message: Cow::Borrowed("the length of `left` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("parallelogram_stage.flex"),
                line: 19,
                column: 6,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link left  from G1 to P1 { length = l,   angle = 90 deg exact, mass = ml, symbol = φ }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `left` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("parallelogram_stage.flex"),
                line: 19,
                column: 64,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link left  from G1 to P1 { length = l,   angle = 90 deg exact, mass = ml, symbol = φ }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `left` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("parallelogram_stage.flex"),
                line: 19,
                column: 64,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link left  from G1 to P1 { length = l,   angle = 90 deg exact, mass = ml, symbol = φ }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `stage` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("parallelogram_stage.flex"),
                line: 21,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link stage from P1 to P2 { length = gap, angle =  0 deg,       mass = ms }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `stage` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("parallelogram_stage.flex"),
                line: 21,
                column: 64,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link stage from P1 to P2 { length = gap, angle =  0 deg,       mass = ms }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `stage` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("parallelogram_stage.flex"),
                line: 21,
                column: 64,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link stage from P1 to P2 { length = gap, angle =  0 deg,       mass = ms }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("`left` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("parallelogram_stage.flex"),
                line: 19,
                column: 6,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link left  from G1 to P1 { length = l,   angle = 90 deg exact, mass = ml, symbol = φ }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
    ];
    /// The equations of motion in plain text.
    pub const EQUATIONS: &str = r#"parallelogram_stage
═══════════════════

A stage on two leaf springs, each as a pseudo-rigid link with a torsion spring at either end.

A leaf whose ends stay parallel: a link of 0.8517 of its length and stiffness 2 γ K_Θ E I / L at
either end, K_Θ = 2.65 (Howell, Compliant Mechanisms, 2001). The stage moves in translation.

Parallelogram right–stage–left
──────────────────────────────

  l e^(i φ_right) - gap e^(i φ_stage) - l e^(i φ) + gap = 0
  φ_right = φ (opposite sides are equal)
  φ_stage = 0 (opposite sides are equal)

Constants of the inertia
────────────────────────

  C0 = I_left + I_right + ml r_left² + ml r_right² + ms l²

Equation of motion of `left`
────────────────────────────

  ∂P_s/∂φ = 4 k (φ - φ⁰)
  τ       = -l push sin(2 π f t) sin(φ)

  C0 φ̈ + ∂P_s/∂φ = τ

Constants
─────────

  I       = 1/12 b h³         second moment of area
  l       = 0.8517 L          length of the pseudo-rigid link
  k       = 4.51401 E I / L   stiffness at either end of a leaf
  r_left  = ½ l               distance of the centre of mass from the first end of left
  I_left  = 1/12 ml l²        moment of inertia about the centre of mass of left
  r_right = ½ l               distance of the centre of mass from the first end of right
  I_right = 1/12 ml l²        moment of inertia about the centre of mass of right
  φ⁰      = ½ π               angle of `left` as assembled
"#;
    /// The equations of motion as a LaTeX document.
    pub const EQUATIONS_LATEX: &str = r#"\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\begin{document}

\section*{parallelogram\_stage}
A stage on two leaf springs, each as a pseudo-rigid link with a torsion spring at either end.

A leaf whose ends stay parallel: a link of 0.8517 of its length and stiffness 2 \ensuremath{\gamma} K\_\ensuremath{\Theta} E I / L at
either end, K\_\ensuremath{\Theta} = 2.65 (Howell, Compliant Mechanisms, 2001). The stage moves in translation.

\subsection*{Parallelogram right–stage–left}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{right}}} - \mathit{gap}\, e^{i \varphi_{\mathrm{stage}}} - l\, e^{i \varphi} + \mathit{gap} = 0 \\
& \varphi_{\mathrm{right}} = \varphi \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{stage}} = 0 \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Constants of the inertia}
\begin{align*}
C_{0} &= I_{\mathrm{left}} + I_{\mathrm{right}} + \mathit{ml} \, r_{\mathrm{left}}^{2} + \mathit{ml} \, r_{\mathrm{right}}^{2} + \mathit{ms} \, l^{2}
\end{align*}

\subsection*{Equation of motion of \texttt{left}}
\begin{align*}
\frac{\partial P_s}{\partial \varphi} &= 4 \, k \left(\varphi - \varphi^0\right) \\
\tau &= -l \, \mathit{push} \sin\left(2 \, \pi \, f \, t\right) \sin \varphi \\
& C_{0}\,\ddot{\varphi} + \frac{\partial P_s}{\partial \varphi} = \tau
\end{align*}

\subsection*{Constants}
\begin{align*}
I &= \frac{1}{12} \, b \, h^{3} && \text{second moment of area} \\
l &= 0.8517 \, L && \text{length of the pseudo-rigid link} \\
k &= \frac{4.51401 \, E \, I}{L} && \text{stiffness at either end of a leaf} \\
r_{\mathrm{left}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of left} \\
I_{\mathrm{left}} &= \frac{1}{12} \, \mathit{ml} \, l^{2} && \text{moment of inertia about the centre of mass of left} \\
r_{\mathrm{right}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of right} \\
I_{\mathrm{right}} &= \frac{1}{12} \, \mathit{ml} \, l^{2} && \text{moment of inertia about the centre of mass of right} \\
\varphi^0 &= \frac{1}{2} \, \pi && \text{angle of \texttt{left} as assembled}
\end{align*}

\end{document}
"#;
}
