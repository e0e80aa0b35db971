/// Simulator of the model `pendulum`, generated from its equations of motion.
///
/// A pendulum on a flexure hinge: one pivoted bar that swings under gravity against the stiffness
/// and damping of its hinge.
#[allow(
    non_snake_case,
    non_upper_case_globals,
    unused,
    clippy::all,
    clippy::pedantic,
    rustdoc::all
)]
pub mod pendulum {
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
        /// length of the bar in m; 0.2 by default
        pub length: f64,
        /// width of the bar, out of plane in m; 0.02 by default
        pub width: f64,
        /// height of the bar, in the plane of motion in m; 0.005 by default
        pub height: f64,
        /// density of the bar in kg/m^3; 2700.0 by default
        pub density: f64,
        /// stiffness of the hinge in N\*m; 0.02 by default
        pub k: f64,
        /// damping of the hinge in N\*m\*s; 5e-5 by default
        pub c: f64,
    }
    impl Default for Params {
        fn default() -> Self {
            Self {
                length: 0.2,
                width: 0.02,
                height: 0.005,
                density: 2700.0,
                k: 0.02,
                c: 5e-5,
            }
        }
    }
    impl Params {
        /// The values in the order of [`VARIABLES`].
        pub fn values(&self) -> [f64; 6] {
            [self.length, self.width, self.height, self.density, self.k, self.c]
        }
        /// Params of values in the order of [`VARIABLES`].
        pub fn from_values(values: [f64; 6]) -> Self {
            Self {
                length: values[0],
                width: values[1],
                height: values[2],
                density: values[3],
                k: values[4],
                c: values[5],
            }
        }
        /// Closes the loops and computes everything that depends on params alone.
        ///
        /// # Errors
        /// What is wrong with the parameter set, in the words of `flexure check`.
        pub fn prepare(&self) -> Result<Prepared<f64>, Diagnostic> {
            check_params(PARAMS, &self.values())?;
            let length = self.length;
            let width = self.width;
            let height = self.height;
            let density = self.density;
            let k = self.k;
            let c = self.c;
            // mass of bar
            let m_bar = length * width * height * density;
            // moment of inertia about the centre of mass of bar
            let I_bar = m_bar * (length * length + height * height)
                * 0.08333333333333333;
            // distance of the centre of mass from the first end of bar
            let r_bar = length * 0.5;
            // constant of the inertia
            let C0 = I_bar + m_bar * (r_bar * r_bar);
            let dτ_ddφ = -c;
            let dddφ_ddφ = dτ_ddφ / C0;
            if !(length > 0.0) {
                return Err(FAILURES[0].diagnostic(&[length]));
            }
            if !(m_bar >= 0.0) {
                return Err(FAILURES[1].diagnostic(&[m_bar]));
            }
            if !(I_bar >= 0.0) {
                return Err(FAILURES[2].diagnostic(&[I_bar]));
            }
            if !(C0 > 0.0) {
                return Err(FAILURES[3].diagnostic(&[]));
            }
            let prepared = Prepared {
                start_states: [-0.5235987755982988, 0.0],
                start_discretes: [],
                length,
                k,
                c,
                constant1: m_bar * r_bar * 9.81,
                per_C0: C0.recip(),
                dddφ_ddφ,
                half_C0: C0 * 0.5,
                half_k: k * 0.5,
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
        /// `length`
        pub length: T,
        /// `k`
        pub k: T,
        /// `c`
        pub c: T,
        /// `9.81 * m_bar * r_bar`
        pub constant1: T,
        /// `1.0 / C0`
        pub per_C0: T,
        /// `∂φ̈/∂φ̇`
        pub dddφ_ddφ: T,
        /// `0.5 * C0`
        pub half_C0: T,
        /// `0.5 * k`
        pub half_k: T,
    }
    impl<T: Copy> Prepared<T> {
        /// The same with every number turned into another, without curves: for dual numbers or lanes.
        pub fn map<U>(&self, turn: impl Fn(T) -> U) -> Prepared<U> {
            Prepared {
                start_states: self.start_states.map(&turn),
                start_discretes: self.start_discretes.map(&turn),
                length: turn(self.length),
                k: turn(self.k),
                c: turn(self.c),
                constant1: turn(self.constant1),
                per_C0: turn(self.per_C0),
                dddφ_ddφ: turn(self.dddφ_ddφ),
                half_C0: turn(self.half_C0),
                half_k: turn(self.half_k),
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
                length: join(self.length, other.length),
                k: join(self.k, other.k),
                c: join(self.c, other.c),
                constant1: join(self.constant1, other.constant1),
                per_C0: join(self.per_C0, other.per_C0),
                dddφ_ddφ: join(self.dddφ_ddφ, other.dddφ_ddφ),
                half_C0: join(self.half_C0, other.half_C0),
                half_k: join(self.half_k, other.half_k),
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
        let dP_s_dφ = p.k * (φ + 1.5707963267948966);
        // slope of the potential energy of gravity
        let dP_g_dφ = p.constant1 * φ.cos();
        // slope of the potential energy
        let dP_dφ = dP_s_dφ + dP_g_dφ;
        // ── state ──
        let ddφ = -(p.per_C0 * dP_dφ.plus_product(p.c, dφ));
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
        // ── configuration ──
        let ddP_dφ_dφ = p.k - p.constant1 * φ.sin();
        let dddφ_dφ = -(p.per_C0 * ddP_dφ_dφ);
        result[1] = T::from_f64(1.0);
        result[2] = dddφ_dφ;
        result[3] = p.dddφ_ddφ;
    }
    /// The model's outputs.
    #[inline(always)]
    pub fn outputs<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 0],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 3],
    ) {
        let φ = x[0];
        // ── configuration ──
        let (sin_φ, cos_φ) = φ.sin_cos();
        let tip_x = p.length * cos_φ;
        let tip_y = p.length * sin_φ;
        result[0] = φ + 1.5707963267948966;
        result[1] = tip_x;
        result[2] = tip_y;
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
        let t1 = φ + 1.5707963267948966;
        // ── state ──
        let dφ_squared = dφ * dφ;
        result[0] = p.half_C0 * dφ_squared;
        result[1] = p.constant1 * φ.sin() + p.half_k * (t1 * t1);
        result[2] = p.c * dφ_squared;
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
    pub static VARIABLES: [Variable; 11] = [
        Variable {
            name: Cow::Borrowed("length"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length of the bar"),
            causality: Causality::Parameter,
            start: Some(0.2),
        },
        Variable {
            name: Cow::Borrowed("width"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("width of the bar, out of plane"),
            causality: Causality::Parameter,
            start: Some(0.02),
        },
        Variable {
            name: Cow::Borrowed("height"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("height of the bar, in the plane of motion"),
            causality: Causality::Parameter,
            start: Some(0.005),
        },
        Variable {
            name: Cow::Borrowed("density"),
            unit: Cow::Borrowed("kg/m^3"),
            meaning: Cow::Borrowed("density of the bar"),
            causality: Causality::Parameter,
            start: Some(2700.0),
        },
        Variable {
            name: Cow::Borrowed("k"),
            unit: Cow::Borrowed("N*m"),
            meaning: Cow::Borrowed("stiffness of the hinge"),
            causality: Causality::Parameter,
            start: Some(0.02),
        },
        Variable {
            name: Cow::Borrowed("c"),
            unit: Cow::Borrowed("N*m*s"),
            meaning: Cow::Borrowed("damping of the hinge"),
            causality: Causality::Parameter,
            start: Some(5e-5),
        },
        Variable {
            name: Cow::Borrowed("bar.angle"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("angle of `bar`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("bar.rate"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed("angular rate of `bar`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("swing"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("angle from hanging straight down"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("x"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("horizontal position of the tip"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("y"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("vertical position of the tip"),
            causality: Causality::Output,
            start: None,
        },
    ];
    static PARAMS: &[Variable] = VARIABLES.split_at(0).1.split_at(6).0;
    static STATES: &[Variable] = VARIABLES.split_at(6).1.split_at(2).0;
    static DISCRETES: &[Variable] = VARIABLES.split_at(8).1.split_at(0).0;
    static INPUTS: &[Variable] = VARIABLES.split_at(8).1.split_at(0).0;
    static OUTPUTS: &[Variable] = VARIABLES.split_at(8).1.split_at(3).0;
    static TURNING: [usize; 0] = [];
    static FAILURES: [Failure; 4] = [
        Failure {
            message: Cow::Borrowed("the length of `bar` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("pendulum.flex"),
                line: 14,
                column: 6,
                width: 3,
                excerpt: Cow::Borrowed("link bar from pivot to tip {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `bar` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("pendulum.flex"),
                line: 18,
                column: 3,
                width: 7,
                excerpt: Cow::Borrowed("  density = density"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `bar` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("pendulum.flex"),
                line: 18,
                column: 3,
                width: 7,
                excerpt: Cow::Borrowed("  density = density"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("`bar` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("pendulum.flex"),
                line: 14,
                column: 6,
                width: 3,
                excerpt: Cow::Borrowed("link bar from pivot to tip {"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
    ];
    /// The equations of motion in plain text.
    pub const EQUATIONS: &str = r#"pendulum
════════

A pendulum on a flexure hinge: one pivoted bar that swings under gravity against the stiffness
and damping of its hinge.

Constants of the inertia
────────────────────────

  C0 = I_bar + m_bar r_bar²

Equation of motion of `bar`
───────────────────────────

  ∂P_s/∂φ = k (φ - φ⁰ + θ_pivot⁰)
  ∂P_g/∂φ = m_bar r_bar g cos(φ)
  ∂P/∂φ   = ∂P_s/∂φ + ∂P_g/∂φ
  τ       = -c φ̇

  C0 φ̈ + ∂P/∂φ = τ

Constants
─────────

  m_bar    = length width height density
             mass of bar
  r_bar    = ½ length              distance of the centre of mass from the first end of bar
  I_bar    = 1/12 m_bar (length² + height²)
             moment of inertia about the centre of mass of bar
  φ⁰       = -1/6 π                angle of `bar` as assembled
  θ_pivot⁰ = unwrap(½ π + φ⁰; 0)   deflection of the hinge at `pivot` as assembled
  g        = 9.81                  acceleration of gravity
"#;
    /// The equations of motion as a LaTeX document.
    pub const EQUATIONS_LATEX: &str = r#"\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\begin{document}

\section*{pendulum}
A pendulum on a flexure hinge: one pivoted bar that swings under gravity against the stiffness
and damping of its hinge.

\subsection*{Constants of the inertia}
\begin{align*}
C_{0} &= I_{\mathrm{bar}} + m_{\mathrm{bar}} \, r_{\mathrm{bar}}^{2}
\end{align*}

\subsection*{Equation of motion of \texttt{bar}}
\begin{align*}
\frac{\partial P_s}{\partial \varphi} &= k \left(\varphi - \varphi^0 + \theta_{\mathrm{pivot}}^{0}\right) \\
\frac{\partial P_g}{\partial \varphi} &= m_{\mathrm{bar}} \, r_{\mathrm{bar}} \, g \cos \varphi \\
\frac{\partial P}{\partial \varphi} &= \frac{\partial P_s}{\partial \varphi} + \frac{\partial P_g}{\partial \varphi} \\
\tau &= -c \, \dot{\varphi} \\
& C_{0}\,\ddot{\varphi} + \frac{\partial P}{\partial \varphi} = \tau
\end{align*}

\subsection*{Constants}
\begin{align*}
m_{\mathrm{bar}} &= \mathit{length} \, \mathit{width} \, \mathit{height} \, \mathit{density} && \text{mass of bar} \\
r_{\mathrm{bar}} &= \frac{1}{2} \, \mathit{length} && \text{distance of the centre of mass from the first end of bar} \\
I_{\mathrm{bar}} &= \frac{1}{12} \, m_{\mathrm{bar}} \left(\mathit{length}^{2} + \mathit{height}^{2}\right) && \text{moment of inertia about the centre of mass of bar} \\
\varphi^0 &= -\frac{1}{6} \, \pi && \text{angle of \texttt{bar} as assembled} \\
\theta_{\mathrm{pivot}}^{0} &= \operatorname{unwrap}\left(\frac{1}{2} \, \pi + \varphi^0; 0\right) && \text{deflection of the hinge at \texttt{pivot} as assembled} \\
g &= 9.81 && \text{acceleration of gravity}
\end{align*}

\end{document}
"#;
}
