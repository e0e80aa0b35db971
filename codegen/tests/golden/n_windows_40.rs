/// Simulator of the model `n_windows_40`, generated from its equations of motion.
///
/// Forty windows of the N-window chain of four-bars (IFToMM A02): 81 equal bars that fall and pass
/// through the positions in which all lie in one line. Another N makes another chain.
#[allow(
    non_snake_case,
    non_upper_case_globals,
    unused,
    clippy::all,
    clippy::pedantic,
    rustdoc::all
)]
pub mod n_windows_40 {
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
        /// length of a bar in m; 1.0 by default
        pub l: f64,
        /// mass of a bar in kg; 1.0 by default
        pub m: f64,
    }
    impl Default for Params {
        fn default() -> Self {
            Self { l: 1.0, m: 1.0 }
        }
    }
    impl Params {
        /// The values in the order of [`VARIABLES`].
        pub fn values(&self) -> [f64; 2] {
            [self.l, self.m]
        }
        /// Params of values in the order of [`VARIABLES`].
        pub fn from_values(values: [f64; 2]) -> Self {
            Self { l: values[0], m: values[1] }
        }
        /// Closes the loops and computes everything that depends on params alone.
        ///
        /// # Errors
        /// What is wrong with the parameter set, in the words of `flexure check`.
        pub fn prepare(&self) -> Result<Prepared<f64>, Diagnostic> {
            check_params(PARAMS, &self.values())?;
            let l = self.l;
            let m = self.m;
            let l_squared_m = l * l * m;
            // moment of inertia about the centre of mass of upright0
            let I_upright0 = l_squared_m * 0.08333333333333333;
            // distance of the centre of mass from the first end of upright0
            let r_upright0 = l * 0.5;
            // constant of the inertia
            let C0 = l_squared_m * 40.0 + I_upright0 * 41.0
                + m * (r_upright0 * r_upright0) * 41.0;
            if !(l > 0.0) {
                return Err(FAILURES[0].diagnostic(&[l]));
            }
            if !(m >= 0.0) {
                return Err(FAILURES[1].diagnostic(&[m]));
            }
            if !(I_upright0 >= 0.0) {
                return Err(FAILURES[2].diagnostic(&[I_upright0]));
            }
            if !(C0 > 0.0) {
                return Err(FAILURES[3].diagnostic(&[]));
            }
            let prepared = Prepared {
                start_states: [1.5707963267948966, -1.0],
                start_discretes: [],
                l,
                _40_l_m: l * m * 40.0,
                _41_m_r_upright0: m * r_upright0 * 41.0,
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
        /// `l`
        pub l: T,
        /// `40.0 * l * m`
        pub _40_l_m: T,
        /// `41.0 * m * r_upright0`
        pub _41_m_r_upright0: T,
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
                _40_l_m: turn(self._40_l_m),
                _41_m_r_upright0: turn(self._41_m_r_upright0),
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
                _40_l_m: join(self._40_l_m, other._40_l_m),
                _41_m_r_upright0: join(self._41_m_r_upright0, other._41_m_r_upright0),
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
        let φ_upright0 = x[0];
        let dφ_upright0 = x[1];
        // ── configuration ──
        let cos_φ_upright0 = φ_upright0.cos();
        let t1 = p._41_m_r_upright0 * cos_φ_upright0 + p._40_l_m * cos_φ_upright0;
        // slope of the potential energy of gravity
        let dP_g_dφ_upright0 = t1 * 9.81;
        let ddφ_upright0 = -(p.per_C0 * dP_g_dφ_upright0);
        dx[0] = dφ_upright0;
        dx[1] = ddφ_upright0;
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
        let φ_upright0 = x[0];
        // ── configuration ──
        let sin_φ_upright0 = φ_upright0.sin();
        let t1 = p._41_m_r_upright0 * sin_φ_upright0 + p._40_l_m * sin_φ_upright0;
        let t2 = -(t1 * 9.81);
        let t3 = -(p.per_C0 * t2);
        result[1] = T::from_f64(1.0);
        result[2] = t3;
    }
    /// The model's outputs.
    #[inline(always)]
    pub fn outputs<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 0],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let φ_upright0 = x[0];
        let dφ_upright0 = x[1];
        // ── configuration ──
        let (sin_φ_upright0, cos_φ_upright0) = φ_upright0.sin_cos();
        let B0_x = p.l * cos_φ_upright0;
        let B0_y = p.l * sin_φ_upright0;
        // ── state ──
        let B0_vx = -(B0_y * dφ_upright0);
        let B0_vy = B0_x * dφ_upright0;
        result[0] = B0_x;
        result[1] = B0_y;
        result[2] = B0_vx;
        result[3] = B0_vy;
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
        let φ_upright0 = x[0];
        let dφ_upright0 = x[1];
        // ── configuration ──
        let sin_φ_upright0 = φ_upright0.sin();
        let t1 = p._41_m_r_upright0 * sin_φ_upright0 + p._40_l_m * sin_φ_upright0;
        result[0] = p.half_C0 * (dφ_upright0 * dφ_upright0);
        result[1] = t1 * 9.81;
        result[2] = T::from_f64(0.0);
        result[3] = T::from_f64(0.0);
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
    pub static VARIABLES: [Variable; 8] = [
        Variable {
            name: Cow::Borrowed("l"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length of a bar"),
            causality: Causality::Parameter,
            start: Some(1.0),
        },
        Variable {
            name: Cow::Borrowed("m"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of a bar"),
            causality: Causality::Parameter,
            start: Some(1.0),
        },
        Variable {
            name: Cow::Borrowed("upright0.angle"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("angle of `upright0`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("upright0.rate"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed("angular rate of `upright0`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("x0"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("horizontal position of the first upright's top"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("y0"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("its height"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("v_x0"),
            unit: Cow::Borrowed("m/s"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("v_y0"),
            unit: Cow::Borrowed("m/s"),
            meaning: Cow::Borrowed(""),
            causality: Causality::Output,
            start: None,
        },
    ];
    static PARAMS: &[Variable] = VARIABLES.split_at(0).1.split_at(2).0;
    static STATES: &[Variable] = VARIABLES.split_at(2).1.split_at(2).0;
    static DISCRETES: &[Variable] = VARIABLES.split_at(4).1.split_at(0).0;
    static INPUTS: &[Variable] = VARIABLES.split_at(4).1.split_at(0).0;
    static OUTPUTS: &[Variable] = VARIABLES.split_at(4).1.split_at(4).0;
    static TURNING: [usize; 0] = [];
    static FAILURES: [Failure; 4] = [
        Failure {
            message: Cow::Borrowed("the length of `upright0` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("n_windows_40.flex"),
                line: 14,
                column: 6,
                width: 10,
                excerpt: Cow::Borrowed(
                    "link upright[0] from G[0] to B[0] { length = l, angle = 90 deg exact, mass = m }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `upright0` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("n_windows_40.flex"),
                line: 14,
                column: 71,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link upright[0] from G[0] to B[0] { length = l, angle = 90 deg exact, mass = m }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `upright0` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("n_windows_40.flex"),
                line: 14,
                column: 71,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link upright[0] from G[0] to B[0] { length = l, angle = 90 deg exact, mass = m }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("`upright0` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("n_windows_40.flex"),
                line: 14,
                column: 6,
                width: 10,
                excerpt: Cow::Borrowed(
                    "link upright[0] from G[0] to B[0] { length = l, angle = 90 deg exact, mass = m }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
    ];
    /// The equations of motion in plain text.
    pub const EQUATIONS: &str = r#"n_windows_40
════════════

Forty windows of the N-window chain of four-bars (IFToMM A02): 81 equal bars that fall and pass
through the positions in which all lie in one line. Another N makes another chain.

Parallelogram upright0–bar1–upright1
────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar1) - l e^(i φ_upright1) - l = 0
  φ_bar1 = 0 (opposite sides are equal)
  φ_upright1 = φ_upright0 (opposite sides are equal)

Parallelogram upright1–bar2–upright2
────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar2) - l e^(i φ_upright2) - l = 0
  φ_bar2 = 0 (opposite sides are equal)
  φ_upright2 = φ_upright0 (opposite sides are equal)

Parallelogram upright2–bar3–upright3
────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar3) - l e^(i φ_upright3) - l = 0
  φ_bar3 = 0 (opposite sides are equal)
  φ_upright3 = φ_upright0 (opposite sides are equal)

Parallelogram upright3–bar4–upright4
────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar4) - l e^(i φ_upright4) - l = 0
  φ_bar4 = 0 (opposite sides are equal)
  φ_upright4 = φ_upright0 (opposite sides are equal)

Parallelogram upright4–bar5–upright5
────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar5) - l e^(i φ_upright5) - l = 0
  φ_bar5 = 0 (opposite sides are equal)
  φ_upright5 = φ_upright0 (opposite sides are equal)

Parallelogram upright5–bar6–upright6
────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar6) - l e^(i φ_upright6) - l = 0
  φ_bar6 = 0 (opposite sides are equal)
  φ_upright6 = φ_upright0 (opposite sides are equal)

Parallelogram upright6–bar7–upright7
────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar7) - l e^(i φ_upright7) - l = 0
  φ_bar7 = 0 (opposite sides are equal)
  φ_upright7 = φ_upright0 (opposite sides are equal)

Parallelogram upright7–bar8–upright8
────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar8) - l e^(i φ_upright8) - l = 0
  φ_bar8 = 0 (opposite sides are equal)
  φ_upright8 = φ_upright0 (opposite sides are equal)

Parallelogram upright8–bar9–upright9
────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar9) - l e^(i φ_upright9) - l = 0
  φ_bar9 = 0 (opposite sides are equal)
  φ_upright9 = φ_upright0 (opposite sides are equal)

Parallelogram upright9–bar10–upright10
──────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar10) - l e^(i φ_upright10) - l = 0
  φ_bar10 = 0 (opposite sides are equal)
  φ_upright10 = φ_upright0 (opposite sides are equal)

Parallelogram upright10–bar11–upright11
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar11) - l e^(i φ_upright11) - l = 0
  φ_bar11 = 0 (opposite sides are equal)
  φ_upright11 = φ_upright0 (opposite sides are equal)

Parallelogram upright11–bar12–upright12
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar12) - l e^(i φ_upright12) - l = 0
  φ_bar12 = 0 (opposite sides are equal)
  φ_upright12 = φ_upright0 (opposite sides are equal)

Parallelogram upright12–bar13–upright13
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar13) - l e^(i φ_upright13) - l = 0
  φ_bar13 = 0 (opposite sides are equal)
  φ_upright13 = φ_upright0 (opposite sides are equal)

Parallelogram upright13–bar14–upright14
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar14) - l e^(i φ_upright14) - l = 0
  φ_bar14 = 0 (opposite sides are equal)
  φ_upright14 = φ_upright0 (opposite sides are equal)

Parallelogram upright14–bar15–upright15
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar15) - l e^(i φ_upright15) - l = 0
  φ_bar15 = 0 (opposite sides are equal)
  φ_upright15 = φ_upright0 (opposite sides are equal)

Parallelogram upright15–bar16–upright16
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar16) - l e^(i φ_upright16) - l = 0
  φ_bar16 = 0 (opposite sides are equal)
  φ_upright16 = φ_upright0 (opposite sides are equal)

Parallelogram upright16–bar17–upright17
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar17) - l e^(i φ_upright17) - l = 0
  φ_bar17 = 0 (opposite sides are equal)
  φ_upright17 = φ_upright0 (opposite sides are equal)

Parallelogram upright17–bar18–upright18
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar18) - l e^(i φ_upright18) - l = 0
  φ_bar18 = 0 (opposite sides are equal)
  φ_upright18 = φ_upright0 (opposite sides are equal)

Parallelogram upright18–bar19–upright19
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar19) - l e^(i φ_upright19) - l = 0
  φ_bar19 = 0 (opposite sides are equal)
  φ_upright19 = φ_upright0 (opposite sides are equal)

Parallelogram upright19–bar20–upright20
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar20) - l e^(i φ_upright20) - l = 0
  φ_bar20 = 0 (opposite sides are equal)
  φ_upright20 = φ_upright0 (opposite sides are equal)

Parallelogram upright20–bar21–upright21
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar21) - l e^(i φ_upright21) - l = 0
  φ_bar21 = 0 (opposite sides are equal)
  φ_upright21 = φ_upright0 (opposite sides are equal)

Parallelogram upright21–bar22–upright22
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar22) - l e^(i φ_upright22) - l = 0
  φ_bar22 = 0 (opposite sides are equal)
  φ_upright22 = φ_upright0 (opposite sides are equal)

Parallelogram upright22–bar23–upright23
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar23) - l e^(i φ_upright23) - l = 0
  φ_bar23 = 0 (opposite sides are equal)
  φ_upright23 = φ_upright0 (opposite sides are equal)

Parallelogram upright23–bar24–upright24
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar24) - l e^(i φ_upright24) - l = 0
  φ_bar24 = 0 (opposite sides are equal)
  φ_upright24 = φ_upright0 (opposite sides are equal)

Parallelogram upright24–bar25–upright25
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar25) - l e^(i φ_upright25) - l = 0
  φ_bar25 = 0 (opposite sides are equal)
  φ_upright25 = φ_upright0 (opposite sides are equal)

Parallelogram upright25–bar26–upright26
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar26) - l e^(i φ_upright26) - l = 0
  φ_bar26 = 0 (opposite sides are equal)
  φ_upright26 = φ_upright0 (opposite sides are equal)

Parallelogram upright26–bar27–upright27
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar27) - l e^(i φ_upright27) - l = 0
  φ_bar27 = 0 (opposite sides are equal)
  φ_upright27 = φ_upright0 (opposite sides are equal)

Parallelogram upright27–bar28–upright28
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar28) - l e^(i φ_upright28) - l = 0
  φ_bar28 = 0 (opposite sides are equal)
  φ_upright28 = φ_upright0 (opposite sides are equal)

Parallelogram upright28–bar29–upright29
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar29) - l e^(i φ_upright29) - l = 0
  φ_bar29 = 0 (opposite sides are equal)
  φ_upright29 = φ_upright0 (opposite sides are equal)

Parallelogram upright29–bar30–upright30
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar30) - l e^(i φ_upright30) - l = 0
  φ_bar30 = 0 (opposite sides are equal)
  φ_upright30 = φ_upright0 (opposite sides are equal)

Parallelogram upright30–bar31–upright31
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar31) - l e^(i φ_upright31) - l = 0
  φ_bar31 = 0 (opposite sides are equal)
  φ_upright31 = φ_upright0 (opposite sides are equal)

Parallelogram upright31–bar32–upright32
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar32) - l e^(i φ_upright32) - l = 0
  φ_bar32 = 0 (opposite sides are equal)
  φ_upright32 = φ_upright0 (opposite sides are equal)

Parallelogram upright32–bar33–upright33
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar33) - l e^(i φ_upright33) - l = 0
  φ_bar33 = 0 (opposite sides are equal)
  φ_upright33 = φ_upright0 (opposite sides are equal)

Parallelogram upright33–bar34–upright34
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar34) - l e^(i φ_upright34) - l = 0
  φ_bar34 = 0 (opposite sides are equal)
  φ_upright34 = φ_upright0 (opposite sides are equal)

Parallelogram upright34–bar35–upright35
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar35) - l e^(i φ_upright35) - l = 0
  φ_bar35 = 0 (opposite sides are equal)
  φ_upright35 = φ_upright0 (opposite sides are equal)

Parallelogram upright35–bar36–upright36
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar36) - l e^(i φ_upright36) - l = 0
  φ_bar36 = 0 (opposite sides are equal)
  φ_upright36 = φ_upright0 (opposite sides are equal)

Parallelogram upright36–bar37–upright37
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar37) - l e^(i φ_upright37) - l = 0
  φ_bar37 = 0 (opposite sides are equal)
  φ_upright37 = φ_upright0 (opposite sides are equal)

Parallelogram upright37–bar38–upright38
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar38) - l e^(i φ_upright38) - l = 0
  φ_bar38 = 0 (opposite sides are equal)
  φ_upright38 = φ_upright0 (opposite sides are equal)

Parallelogram upright38–bar39–upright39
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar39) - l e^(i φ_upright39) - l = 0
  φ_bar39 = 0 (opposite sides are equal)
  φ_upright39 = φ_upright0 (opposite sides are equal)

Parallelogram upright39–bar40–upright40
───────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar40) - l e^(i φ_upright40) - l = 0
  φ_bar40 = 0 (opposite sides are equal)
  φ_upright40 = φ_upright0 (opposite sides are equal)

Constants of the inertia
────────────────────────

  C0 = 40 m l²
     + I_upright0
     + I_upright1
     + I_upright2
     + I_upright3
     + I_upright4
     + I_upright5
     + I_upright6
     + I_upright7
     + I_upright8
     + I_upright9
     + I_upright10
     + I_upright11
     + I_upright12
     + I_upright13
     + I_upright14
     + I_upright15
     + I_upright16
     + I_upright17
     + I_upright18
     + I_upright19
     + I_upright20
     + I_upright21
     + I_upright22
     + I_upright23
     + I_upright24
     + I_upright25
     + I_upright26
     + I_upright27
     + I_upright28
     + I_upright29
     + I_upright30
     + I_upright31
     + I_upright32
     + I_upright33
     + I_upright34
     + I_upright35
     + I_upright36
     + I_upright37
     + I_upright38
     + I_upright39
     + I_upright40
     + m r_upright0²
     + m r_upright1²
     + m r_upright2²
     + m r_upright3²
     + m r_upright4²
     + m r_upright5²
     + m r_upright6²
     + m r_upright7²
     + m r_upright8²
     + m r_upright9²
     + m r_upright10²
     + m r_upright11²
     + m r_upright12²
     + m r_upright13²
     + m r_upright14²
     + m r_upright15²
     + m r_upright16²
     + m r_upright17²
     + m r_upright18²
     + m r_upright19²
     + m r_upright20²
     + m r_upright21²
     + m r_upright22²
     + m r_upright23²
     + m r_upright24²
     + m r_upright25²
     + m r_upright26²
     + m r_upright27²
     + m r_upright28²
     + m r_upright29²
     + m r_upright30²
     + m r_upright31²
     + m r_upright32²
     + m r_upright33²
     + m r_upright34²
     + m r_upright35²
     + m r_upright36²
     + m r_upright37²
     + m r_upright38²
     + m r_upright39²
     + m r_upright40²

Equation of motion of `upright0`
────────────────────────────────

  ∂P_g/∂φ_upright0 = g (m r_upright0 cos(φ_upright0) + 40 l m cos(φ_upright0)
                       + m r_upright1 cos(φ_upright0) + m r_upright2 cos(φ_upright0)
                       + m r_upright3 cos(φ_upright0) + m r_upright4 cos(φ_upright0)
                       + m r_upright5 cos(φ_upright0) + m r_upright6 cos(φ_upright0)
                       + m r_upright7 cos(φ_upright0) + m r_upright8 cos(φ_upright0)
                       + m r_upright9 cos(φ_upright0) + m r_upright10 cos(φ_upright0)
                       + m r_upright11 cos(φ_upright0) + m r_upright12 cos(φ_upright0)
                       + m r_upright13 cos(φ_upright0) + m r_upright14 cos(φ_upright0)
                       + m r_upright15 cos(φ_upright0) + m r_upright16 cos(φ_upright0)
                       + m r_upright17 cos(φ_upright0) + m r_upright18 cos(φ_upright0)
                       + m r_upright19 cos(φ_upright0) + m r_upright20 cos(φ_upright0)
                       + m r_upright21 cos(φ_upright0) + m r_upright22 cos(φ_upright0)
                       + m r_upright23 cos(φ_upright0) + m r_upright24 cos(φ_upright0)
                       + m r_upright25 cos(φ_upright0) + m r_upright26 cos(φ_upright0)
                       + m r_upright27 cos(φ_upright0) + m r_upright28 cos(φ_upright0)
                       + m r_upright29 cos(φ_upright0) + m r_upright30 cos(φ_upright0)
                       + m r_upright31 cos(φ_upright0) + m r_upright32 cos(φ_upright0)
                       + m r_upright33 cos(φ_upright0) + m r_upright34 cos(φ_upright0)
                       + m r_upright35 cos(φ_upright0) + m r_upright36 cos(φ_upright0)
                       + m r_upright37 cos(φ_upright0) + m r_upright38 cos(φ_upright0)
                       + m r_upright39 cos(φ_upright0) + m r_upright40 cos(φ_upright0))

  C0 φ̈_upright0 + ∂P_g/∂φ_upright0 = 0

Constants
─────────

  r_upright0  = ½ l         distance of the centre of mass from the first end of upright0
  I_upright0  = 1/12 m l²   moment of inertia about the centre of mass of upright0
  r_upright1  = ½ l         distance of the centre of mass from the first end of upright1
  I_upright1  = 1/12 m l²   moment of inertia about the centre of mass of upright1
  r_upright2  = ½ l         distance of the centre of mass from the first end of upright2
  I_upright2  = 1/12 m l²   moment of inertia about the centre of mass of upright2
  r_upright3  = ½ l         distance of the centre of mass from the first end of upright3
  I_upright3  = 1/12 m l²   moment of inertia about the centre of mass of upright3
  r_upright4  = ½ l         distance of the centre of mass from the first end of upright4
  I_upright4  = 1/12 m l²   moment of inertia about the centre of mass of upright4
  r_upright5  = ½ l         distance of the centre of mass from the first end of upright5
  I_upright5  = 1/12 m l²   moment of inertia about the centre of mass of upright5
  r_upright6  = ½ l         distance of the centre of mass from the first end of upright6
  I_upright6  = 1/12 m l²   moment of inertia about the centre of mass of upright6
  r_upright7  = ½ l         distance of the centre of mass from the first end of upright7
  I_upright7  = 1/12 m l²   moment of inertia about the centre of mass of upright7
  r_upright8  = ½ l         distance of the centre of mass from the first end of upright8
  I_upright8  = 1/12 m l²   moment of inertia about the centre of mass of upright8
  r_upright9  = ½ l         distance of the centre of mass from the first end of upright9
  I_upright9  = 1/12 m l²   moment of inertia about the centre of mass of upright9
  r_upright10 = ½ l         distance of the centre of mass from the first end of upright10
  I_upright10 = 1/12 m l²   moment of inertia about the centre of mass of upright10
  r_upright11 = ½ l         distance of the centre of mass from the first end of upright11
  I_upright11 = 1/12 m l²   moment of inertia about the centre of mass of upright11
  r_upright12 = ½ l         distance of the centre of mass from the first end of upright12
  I_upright12 = 1/12 m l²   moment of inertia about the centre of mass of upright12
  r_upright13 = ½ l         distance of the centre of mass from the first end of upright13
  I_upright13 = 1/12 m l²   moment of inertia about the centre of mass of upright13
  r_upright14 = ½ l         distance of the centre of mass from the first end of upright14
  I_upright14 = 1/12 m l²   moment of inertia about the centre of mass of upright14
  r_upright15 = ½ l         distance of the centre of mass from the first end of upright15
  I_upright15 = 1/12 m l²   moment of inertia about the centre of mass of upright15
  r_upright16 = ½ l         distance of the centre of mass from the first end of upright16
  I_upright16 = 1/12 m l²   moment of inertia about the centre of mass of upright16
  r_upright17 = ½ l         distance of the centre of mass from the first end of upright17
  I_upright17 = 1/12 m l²   moment of inertia about the centre of mass of upright17
  r_upright18 = ½ l         distance of the centre of mass from the first end of upright18
  I_upright18 = 1/12 m l²   moment of inertia about the centre of mass of upright18
  r_upright19 = ½ l         distance of the centre of mass from the first end of upright19
  I_upright19 = 1/12 m l²   moment of inertia about the centre of mass of upright19
  r_upright20 = ½ l         distance of the centre of mass from the first end of upright20
  I_upright20 = 1/12 m l²   moment of inertia about the centre of mass of upright20
  r_upright21 = ½ l         distance of the centre of mass from the first end of upright21
  I_upright21 = 1/12 m l²   moment of inertia about the centre of mass of upright21
  r_upright22 = ½ l         distance of the centre of mass from the first end of upright22
  I_upright22 = 1/12 m l²   moment of inertia about the centre of mass of upright22
  r_upright23 = ½ l         distance of the centre of mass from the first end of upright23
  I_upright23 = 1/12 m l²   moment of inertia about the centre of mass of upright23
  r_upright24 = ½ l         distance of the centre of mass from the first end of upright24
  I_upright24 = 1/12 m l²   moment of inertia about the centre of mass of upright24
  r_upright25 = ½ l         distance of the centre of mass from the first end of upright25
  I_upright25 = 1/12 m l²   moment of inertia about the centre of mass of upright25
  r_upright26 = ½ l         distance of the centre of mass from the first end of upright26
  I_upright26 = 1/12 m l²   moment of inertia about the centre of mass of upright26
  r_upright27 = ½ l         distance of the centre of mass from the first end of upright27
  I_upright27 = 1/12 m l²   moment of inertia about the centre of mass of upright27
  r_upright28 = ½ l         distance of the centre of mass from the first end of upright28
  I_upright28 = 1/12 m l²   moment of inertia about the centre of mass of upright28
  r_upright29 = ½ l         distance of the centre of mass from the first end of upright29
  I_upright29 = 1/12 m l²   moment of inertia about the centre of mass of upright29
  r_upright30 = ½ l         distance of the centre of mass from the first end of upright30
  I_upright30 = 1/12 m l²   moment of inertia about the centre of mass of upright30
  r_upright31 = ½ l         distance of the centre of mass from the first end of upright31
  I_upright31 = 1/12 m l²   moment of inertia about the centre of mass of upright31
  r_upright32 = ½ l         distance of the centre of mass from the first end of upright32
  I_upright32 = 1/12 m l²   moment of inertia about the centre of mass of upright32
  r_upright33 = ½ l         distance of the centre of mass from the first end of upright33
  I_upright33 = 1/12 m l²   moment of inertia about the centre of mass of upright33
  r_upright34 = ½ l         distance of the centre of mass from the first end of upright34
  I_upright34 = 1/12 m l²   moment of inertia about the centre of mass of upright34
  r_upright35 = ½ l         distance of the centre of mass from the first end of upright35
  I_upright35 = 1/12 m l²   moment of inertia about the centre of mass of upright35
  r_upright36 = ½ l         distance of the centre of mass from the first end of upright36
  I_upright36 = 1/12 m l²   moment of inertia about the centre of mass of upright36
  r_upright37 = ½ l         distance of the centre of mass from the first end of upright37
  I_upright37 = 1/12 m l²   moment of inertia about the centre of mass of upright37
  r_upright38 = ½ l         distance of the centre of mass from the first end of upright38
  I_upright38 = 1/12 m l²   moment of inertia about the centre of mass of upright38
  r_upright39 = ½ l         distance of the centre of mass from the first end of upright39
  I_upright39 = 1/12 m l²   moment of inertia about the centre of mass of upright39
  r_upright40 = ½ l         distance of the centre of mass from the first end of upright40
  I_upright40 = 1/12 m l²   moment of inertia about the centre of mass of upright40
  g           = 9.81        acceleration of gravity
"#;
    /// The equations of motion as a LaTeX document.
    pub const EQUATIONS_LATEX: &str = r#"\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\begin{document}

\section*{n\_windows\_40}
Forty windows of the N-window chain of four-bars (IFToMM A02): 81 equal bars that fall and pass
through the positions in which all lie in one line. Another N makes another chain.

\subsection*{Parallelogram upright0–bar1–upright1}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar1}}} - l\, e^{i \varphi_{\mathrm{upright1}}} - l = 0 \\
& \varphi_{\mathrm{bar1}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright1}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright1–bar2–upright2}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar2}}} - l\, e^{i \varphi_{\mathrm{upright2}}} - l = 0 \\
& \varphi_{\mathrm{bar2}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright2}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright2–bar3–upright3}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar3}}} - l\, e^{i \varphi_{\mathrm{upright3}}} - l = 0 \\
& \varphi_{\mathrm{bar3}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright3}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright3–bar4–upright4}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar4}}} - l\, e^{i \varphi_{\mathrm{upright4}}} - l = 0 \\
& \varphi_{\mathrm{bar4}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright4}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright4–bar5–upright5}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar5}}} - l\, e^{i \varphi_{\mathrm{upright5}}} - l = 0 \\
& \varphi_{\mathrm{bar5}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright5}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright5–bar6–upright6}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar6}}} - l\, e^{i \varphi_{\mathrm{upright6}}} - l = 0 \\
& \varphi_{\mathrm{bar6}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright6}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright6–bar7–upright7}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar7}}} - l\, e^{i \varphi_{\mathrm{upright7}}} - l = 0 \\
& \varphi_{\mathrm{bar7}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright7}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright7–bar8–upright8}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar8}}} - l\, e^{i \varphi_{\mathrm{upright8}}} - l = 0 \\
& \varphi_{\mathrm{bar8}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright8}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright8–bar9–upright9}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar9}}} - l\, e^{i \varphi_{\mathrm{upright9}}} - l = 0 \\
& \varphi_{\mathrm{bar9}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright9}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright9–bar10–upright10}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar10}}} - l\, e^{i \varphi_{\mathrm{upright10}}} - l = 0 \\
& \varphi_{\mathrm{bar10}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright10}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright10–bar11–upright11}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar11}}} - l\, e^{i \varphi_{\mathrm{upright11}}} - l = 0 \\
& \varphi_{\mathrm{bar11}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright11}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright11–bar12–upright12}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar12}}} - l\, e^{i \varphi_{\mathrm{upright12}}} - l = 0 \\
& \varphi_{\mathrm{bar12}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright12}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright12–bar13–upright13}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar13}}} - l\, e^{i \varphi_{\mathrm{upright13}}} - l = 0 \\
& \varphi_{\mathrm{bar13}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright13}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright13–bar14–upright14}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar14}}} - l\, e^{i \varphi_{\mathrm{upright14}}} - l = 0 \\
& \varphi_{\mathrm{bar14}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright14}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright14–bar15–upright15}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar15}}} - l\, e^{i \varphi_{\mathrm{upright15}}} - l = 0 \\
& \varphi_{\mathrm{bar15}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright15}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright15–bar16–upright16}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar16}}} - l\, e^{i \varphi_{\mathrm{upright16}}} - l = 0 \\
& \varphi_{\mathrm{bar16}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright16}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright16–bar17–upright17}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar17}}} - l\, e^{i \varphi_{\mathrm{upright17}}} - l = 0 \\
& \varphi_{\mathrm{bar17}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright17}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright17–bar18–upright18}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar18}}} - l\, e^{i \varphi_{\mathrm{upright18}}} - l = 0 \\
& \varphi_{\mathrm{bar18}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright18}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright18–bar19–upright19}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar19}}} - l\, e^{i \varphi_{\mathrm{upright19}}} - l = 0 \\
& \varphi_{\mathrm{bar19}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright19}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright19–bar20–upright20}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar20}}} - l\, e^{i \varphi_{\mathrm{upright20}}} - l = 0 \\
& \varphi_{\mathrm{bar20}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright20}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright20–bar21–upright21}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar21}}} - l\, e^{i \varphi_{\mathrm{upright21}}} - l = 0 \\
& \varphi_{\mathrm{bar21}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright21}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright21–bar22–upright22}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar22}}} - l\, e^{i \varphi_{\mathrm{upright22}}} - l = 0 \\
& \varphi_{\mathrm{bar22}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright22}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright22–bar23–upright23}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar23}}} - l\, e^{i \varphi_{\mathrm{upright23}}} - l = 0 \\
& \varphi_{\mathrm{bar23}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright23}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright23–bar24–upright24}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar24}}} - l\, e^{i \varphi_{\mathrm{upright24}}} - l = 0 \\
& \varphi_{\mathrm{bar24}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright24}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright24–bar25–upright25}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar25}}} - l\, e^{i \varphi_{\mathrm{upright25}}} - l = 0 \\
& \varphi_{\mathrm{bar25}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright25}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright25–bar26–upright26}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar26}}} - l\, e^{i \varphi_{\mathrm{upright26}}} - l = 0 \\
& \varphi_{\mathrm{bar26}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright26}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright26–bar27–upright27}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar27}}} - l\, e^{i \varphi_{\mathrm{upright27}}} - l = 0 \\
& \varphi_{\mathrm{bar27}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright27}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright27–bar28–upright28}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar28}}} - l\, e^{i \varphi_{\mathrm{upright28}}} - l = 0 \\
& \varphi_{\mathrm{bar28}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright28}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright28–bar29–upright29}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar29}}} - l\, e^{i \varphi_{\mathrm{upright29}}} - l = 0 \\
& \varphi_{\mathrm{bar29}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright29}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright29–bar30–upright30}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar30}}} - l\, e^{i \varphi_{\mathrm{upright30}}} - l = 0 \\
& \varphi_{\mathrm{bar30}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright30}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright30–bar31–upright31}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar31}}} - l\, e^{i \varphi_{\mathrm{upright31}}} - l = 0 \\
& \varphi_{\mathrm{bar31}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright31}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright31–bar32–upright32}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar32}}} - l\, e^{i \varphi_{\mathrm{upright32}}} - l = 0 \\
& \varphi_{\mathrm{bar32}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright32}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright32–bar33–upright33}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar33}}} - l\, e^{i \varphi_{\mathrm{upright33}}} - l = 0 \\
& \varphi_{\mathrm{bar33}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright33}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright33–bar34–upright34}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar34}}} - l\, e^{i \varphi_{\mathrm{upright34}}} - l = 0 \\
& \varphi_{\mathrm{bar34}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright34}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright34–bar35–upright35}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar35}}} - l\, e^{i \varphi_{\mathrm{upright35}}} - l = 0 \\
& \varphi_{\mathrm{bar35}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright35}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright35–bar36–upright36}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar36}}} - l\, e^{i \varphi_{\mathrm{upright36}}} - l = 0 \\
& \varphi_{\mathrm{bar36}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright36}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright36–bar37–upright37}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar37}}} - l\, e^{i \varphi_{\mathrm{upright37}}} - l = 0 \\
& \varphi_{\mathrm{bar37}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright37}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright37–bar38–upright38}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar38}}} - l\, e^{i \varphi_{\mathrm{upright38}}} - l = 0 \\
& \varphi_{\mathrm{bar38}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright38}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright38–bar39–upright39}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar39}}} - l\, e^{i \varphi_{\mathrm{upright39}}} - l = 0 \\
& \varphi_{\mathrm{bar39}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright39}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Parallelogram upright39–bar40–upright40}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar40}}} - l\, e^{i \varphi_{\mathrm{upright40}}} - l = 0 \\
& \varphi_{\mathrm{bar40}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright40}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Constants of the inertia}
\begin{align*}
C_{0} &= 40 \, m \, l^{2} \\
&\quad {}+ I_{\mathrm{upright0}} \\
&\quad {}+ I_{\mathrm{upright1}} \\
&\quad {}+ I_{\mathrm{upright2}} \\
&\quad {}+ I_{\mathrm{upright3}} \\
&\quad {}+ I_{\mathrm{upright4}} \\
&\quad {}+ I_{\mathrm{upright5}} \\
&\quad {}+ I_{\mathrm{upright6}} \\
&\quad {}+ I_{\mathrm{upright7}} \\
&\quad {}+ I_{\mathrm{upright8}} \\
&\quad {}+ I_{\mathrm{upright9}} \\
&\quad {}+ I_{\mathrm{upright10}} \\
&\quad {}+ I_{\mathrm{upright11}} \\
&\quad {}+ I_{\mathrm{upright12}} \\
&\quad {}+ I_{\mathrm{upright13}} \\
&\quad {}+ I_{\mathrm{upright14}} \\
&\quad {}+ I_{\mathrm{upright15}} \\
&\quad {}+ I_{\mathrm{upright16}} \\
&\quad {}+ I_{\mathrm{upright17}} \\
&\quad {}+ I_{\mathrm{upright18}} \\
&\quad {}+ I_{\mathrm{upright19}} \\
&\quad {}+ I_{\mathrm{upright20}} \\
&\quad {}+ I_{\mathrm{upright21}} \\
&\quad {}+ I_{\mathrm{upright22}} \\
&\quad {}+ I_{\mathrm{upright23}} \\
&\quad {}+ I_{\mathrm{upright24}} \\
&\quad {}+ I_{\mathrm{upright25}} \\
&\quad {}+ I_{\mathrm{upright26}} \\
&\quad {}+ I_{\mathrm{upright27}} \\
&\quad {}+ I_{\mathrm{upright28}} \\
&\quad {}+ I_{\mathrm{upright29}} \\
&\quad {}+ I_{\mathrm{upright30}} \\
&\quad {}+ I_{\mathrm{upright31}} \\
&\quad {}+ I_{\mathrm{upright32}} \\
&\quad {}+ I_{\mathrm{upright33}} \\
&\quad {}+ I_{\mathrm{upright34}} \\
&\quad {}+ I_{\mathrm{upright35}} \\
&\quad {}+ I_{\mathrm{upright36}} \\
&\quad {}+ I_{\mathrm{upright37}} \\
&\quad {}+ I_{\mathrm{upright38}} \\
&\quad {}+ I_{\mathrm{upright39}} \\
&\quad {}+ I_{\mathrm{upright40}} \\
&\quad {}+ m \, r_{\mathrm{upright0}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright1}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright2}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright3}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright4}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright5}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright6}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright7}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright8}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright9}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright10}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright11}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright12}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright13}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright14}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright15}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright16}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright17}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright18}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright19}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright20}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright21}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright22}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright23}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright24}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright25}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright26}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright27}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright28}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright29}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright30}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright31}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright32}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright33}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright34}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright35}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright36}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright37}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright38}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright39}}^{2} \\
&\quad {}+ m \, r_{\mathrm{upright40}}^{2}
\end{align*}

\subsection*{Equation of motion of \texttt{upright0}}
\begin{align*}
\frac{\partial P_g}{\partial \varphi_{\mathrm{upright0}}} &= g \left(m \, r_{\mathrm{upright0}} \cos \varphi_{\mathrm{upright0}} + 40 \, l \, m \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright1}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright2}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright3}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright4}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright5}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright6}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright7}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright8}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright9}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright10}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright11}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright12}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright13}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright14}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright15}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright16}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright17}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright18}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright19}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright20}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright21}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright22}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright23}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright24}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright25}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright26}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright27}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright28}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright29}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright30}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright31}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright32}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright33}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright34}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright35}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright36}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright37}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright38}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright39}} \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright40}} \cos \varphi_{\mathrm{upright0}}\right) \\
& C_{0}\,\ddot{\varphi}_{\mathrm{upright0}} + \frac{\partial P_g}{\partial \varphi_{\mathrm{upright0}}} = 0
\end{align*}

\subsection*{Constants}
\begin{align*}
r_{\mathrm{upright0}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright0} \\
I_{\mathrm{upright0}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright0} \\
r_{\mathrm{upright1}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright1} \\
I_{\mathrm{upright1}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright1} \\
r_{\mathrm{upright2}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright2} \\
I_{\mathrm{upright2}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright2} \\
r_{\mathrm{upright3}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright3} \\
I_{\mathrm{upright3}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright3} \\
r_{\mathrm{upright4}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright4} \\
I_{\mathrm{upright4}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright4} \\
r_{\mathrm{upright5}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright5} \\
I_{\mathrm{upright5}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright5} \\
r_{\mathrm{upright6}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright6} \\
I_{\mathrm{upright6}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright6} \\
r_{\mathrm{upright7}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright7} \\
I_{\mathrm{upright7}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright7} \\
r_{\mathrm{upright8}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright8} \\
I_{\mathrm{upright8}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright8} \\
r_{\mathrm{upright9}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright9} \\
I_{\mathrm{upright9}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright9} \\
r_{\mathrm{upright10}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright10} \\
I_{\mathrm{upright10}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright10} \\
r_{\mathrm{upright11}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright11} \\
I_{\mathrm{upright11}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright11} \\
r_{\mathrm{upright12}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright12} \\
I_{\mathrm{upright12}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright12} \\
r_{\mathrm{upright13}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright13} \\
I_{\mathrm{upright13}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright13} \\
r_{\mathrm{upright14}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright14} \\
I_{\mathrm{upright14}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright14} \\
r_{\mathrm{upright15}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright15} \\
I_{\mathrm{upright15}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright15} \\
r_{\mathrm{upright16}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright16} \\
I_{\mathrm{upright16}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright16} \\
r_{\mathrm{upright17}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright17} \\
I_{\mathrm{upright17}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright17} \\
r_{\mathrm{upright18}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright18} \\
I_{\mathrm{upright18}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright18} \\
r_{\mathrm{upright19}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright19} \\
I_{\mathrm{upright19}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright19} \\
r_{\mathrm{upright20}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright20} \\
I_{\mathrm{upright20}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright20} \\
r_{\mathrm{upright21}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright21} \\
I_{\mathrm{upright21}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright21} \\
r_{\mathrm{upright22}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright22} \\
I_{\mathrm{upright22}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright22} \\
r_{\mathrm{upright23}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright23} \\
I_{\mathrm{upright23}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright23} \\
r_{\mathrm{upright24}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright24} \\
I_{\mathrm{upright24}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright24} \\
r_{\mathrm{upright25}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright25} \\
I_{\mathrm{upright25}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright25} \\
r_{\mathrm{upright26}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright26} \\
I_{\mathrm{upright26}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright26} \\
r_{\mathrm{upright27}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright27} \\
I_{\mathrm{upright27}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright27} \\
r_{\mathrm{upright28}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright28} \\
I_{\mathrm{upright28}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright28} \\
r_{\mathrm{upright29}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright29} \\
I_{\mathrm{upright29}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright29} \\
r_{\mathrm{upright30}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright30} \\
I_{\mathrm{upright30}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright30} \\
r_{\mathrm{upright31}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright31} \\
I_{\mathrm{upright31}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright31} \\
r_{\mathrm{upright32}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright32} \\
I_{\mathrm{upright32}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright32} \\
r_{\mathrm{upright33}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright33} \\
I_{\mathrm{upright33}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright33} \\
r_{\mathrm{upright34}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright34} \\
I_{\mathrm{upright34}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright34} \\
r_{\mathrm{upright35}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright35} \\
I_{\mathrm{upright35}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright35} \\
r_{\mathrm{upright36}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright36} \\
I_{\mathrm{upright36}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright36} \\
r_{\mathrm{upright37}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright37} \\
I_{\mathrm{upright37}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright37} \\
r_{\mathrm{upright38}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright38} \\
I_{\mathrm{upright38}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright38} \\
r_{\mathrm{upright39}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright39} \\
I_{\mathrm{upright39}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright39} \\
r_{\mathrm{upright40}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright40} \\
I_{\mathrm{upright40}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright40} \\
g &= 9.81 && \text{acceleration of gravity}
\end{align*}

\end{document}
"#;
}
