/// Simulator of the model `n_windows_1`, generated from its equations of motion.
///
/// One window of the N-window chain of four-bars (IFToMM A02): three equal bars that fall and pass
/// through the positions in which all lie in one line.
///
/// There the loop's branch is not determined by geometry; the bars stay parallel because they are
/// of the same length.
#[allow(
    non_snake_case,
    non_upper_case_globals,
    unused,
    clippy::all,
    clippy::pedantic,
    rustdoc::all
)]
pub mod n_windows_1 {
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
            let C0 = l_squared_m + I_upright0 * 2.0
                + m * (r_upright0 * r_upright0) * 2.0;
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
                l_m: l * m,
                two_m_r_upright0: m * r_upright0 * 2.0,
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
        /// `l * m`
        pub l_m: T,
        /// `2.0 * m * r_upright0`
        pub two_m_r_upright0: T,
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
                l_m: turn(self.l_m),
                two_m_r_upright0: turn(self.two_m_r_upright0),
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
                l_m: join(self.l_m, other.l_m),
                two_m_r_upright0: join(self.two_m_r_upright0, other.two_m_r_upright0),
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
        // slope of the potential energy of gravity
        let dP_g_dφ_upright0 = (p.two_m_r_upright0 * cos_φ_upright0
            + p.l_m * cos_φ_upright0) * 9.81;
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
        let t1 = (p.two_m_r_upright0 * sin_φ_upright0 + p.l_m * sin_φ_upright0) * 9.81;
        let t2 = -t1;
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
        let t1 = (p.two_m_r_upright0 * sin_φ_upright0 + p.l_m * sin_φ_upright0) * 9.81;
        result[0] = p.half_C0 * (dφ_upright0 * dφ_upright0);
        result[1] = t1;
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
                file: Cow::Borrowed("n_windows_1.flex"),
                line: 14,
                column: 6,
                width: 8,
                excerpt: Cow::Borrowed(
                    "link upright0 from G0 to B0 { length = l, angle = 90 deg exact, mass = m }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `upright0` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("n_windows_1.flex"),
                line: 14,
                column: 65,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link upright0 from G0 to B0 { length = l, angle = 90 deg exact, mass = m }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `upright0` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("n_windows_1.flex"),
                line: 14,
                column: 65,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link upright0 from G0 to B0 { length = l, angle = 90 deg exact, mass = m }",
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
                file: Cow::Borrowed("n_windows_1.flex"),
                line: 14,
                column: 6,
                width: 8,
                excerpt: Cow::Borrowed(
                    "link upright0 from G0 to B0 { length = l, angle = 90 deg exact, mass = m }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
    ];
    /// The equations of motion in plain text.
    pub const EQUATIONS: &str = r#"n_windows_1
═══════════

One window of the N-window chain of four-bars (IFToMM A02): three equal bars that fall and pass
through the positions in which all lie in one line.

There the loop's branch is not determined by geometry; the bars stay parallel because they are
of the same length.

Parallelogram upright0–bar1–upright1
────────────────────────────────────

  l e^(i φ_upright0) + l e^(i φ_bar1) - l e^(i φ_upright1) - l = 0
  φ_bar1 = 0 (opposite sides are equal)
  φ_upright1 = φ_upright0 (opposite sides are equal)

Constants of the inertia
────────────────────────

  C0 = m l² + I_upright0 + I_upright1 + m r_upright0² + m r_upright1²

Equation of motion of `upright0`
────────────────────────────────

  ∂P_g/∂φ_upright0 = g (m r_upright0 cos(φ_upright0) + l m cos(φ_upright0)
                       + m r_upright1 cos(φ_upright0))

  C0 φ̈_upright0 + ∂P_g/∂φ_upright0 = 0

Constants
─────────

  r_upright0 = ½ l         distance of the centre of mass from the first end of upright0
  I_upright0 = 1/12 m l²   moment of inertia about the centre of mass of upright0
  r_upright1 = ½ l         distance of the centre of mass from the first end of upright1
  I_upright1 = 1/12 m l²   moment of inertia about the centre of mass of upright1
  g          = 9.81        acceleration of gravity
"#;
    /// The equations of motion as a LaTeX document.
    pub const EQUATIONS_LATEX: &str = r#"\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\begin{document}

\section*{n\_windows\_1}
One window of the N-window chain of four-bars (IFToMM A02): three equal bars that fall and pass
through the positions in which all lie in one line.

There the loop's branch is not determined by geometry; the bars stay parallel because they are
of the same length.

\subsection*{Parallelogram upright0–bar1–upright1}
\begin{align*}
& l\, e^{i \varphi_{\mathrm{upright0}}} + l\, e^{i \varphi_{\mathrm{bar1}}} - l\, e^{i \varphi_{\mathrm{upright1}}} - l = 0 \\
& \varphi_{\mathrm{bar1}} = 0 \quad\text{(opposite sides are equal)} \\
& \varphi_{\mathrm{upright1}} = \varphi_{\mathrm{upright0}} \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Constants of the inertia}
\begin{align*}
C_{0} &= m \, l^{2} + I_{\mathrm{upright0}} + I_{\mathrm{upright1}} + m \, r_{\mathrm{upright0}}^{2} + m \, r_{\mathrm{upright1}}^{2}
\end{align*}

\subsection*{Equation of motion of \texttt{upright0}}
\begin{align*}
\frac{\partial P_g}{\partial \varphi_{\mathrm{upright0}}} &= g \left(m \, r_{\mathrm{upright0}} \cos \varphi_{\mathrm{upright0}} + l \, m \cos \varphi_{\mathrm{upright0}} + m \, r_{\mathrm{upright1}} \cos \varphi_{\mathrm{upright0}}\right) \\
& C_{0}\,\ddot{\varphi}_{\mathrm{upright0}} + \frac{\partial P_g}{\partial \varphi_{\mathrm{upright0}}} = 0
\end{align*}

\subsection*{Constants}
\begin{align*}
r_{\mathrm{upright0}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright0} \\
I_{\mathrm{upright0}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright0} \\
r_{\mathrm{upright1}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upright1} \\
I_{\mathrm{upright1}} &= \frac{1}{12} \, m \, l^{2} && \text{moment of inertia about the centre of mass of upright1} \\
g &= 9.81 && \text{acceleration of gravity}
\end{align*}

\end{document}
"#;
}
