/// Simulator of the model `slider_crank`, generated from its equations of motion.
///
/// A flexure slider–crank: a crank moves a slide through a connecting rod, against a return spring.
#[allow(
    non_snake_case,
    non_upper_case_globals,
    unused,
    clippy::all,
    clippy::pedantic,
    rustdoc::all
)]
pub mod slider_crank {
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
        /// length of the crank in m; 0.015 by default
        pub r: f64,
        /// length of the connecting rod in m; 0.05 by default
        pub l: f64,
        /// of the guide from the crank's pivot in m; 0.004 by default
        pub offset: f64,
        /// masses of crank, rod and slide in kg; 0.004 by default
        pub mc: f64,
        /// masses of crank, rod and slide in kg; 0.009 by default
        pub mr: f64,
        /// masses of crank, rod and slide in kg; 0.02 by default
        pub ms: f64,
        /// stiffness of a hinge in N\*m; 0.3 by default
        pub k: f64,
        /// damping of a hinge in N\*m\*s; 1e-5 by default
        pub c: f64,
        /// stiffness of the return spring in N/m; 400.0 by default
        pub kr: f64,
        /// drive of the crank in N\*m; 0.1 by default
        pub torque: f64,
        /// drive of the crank in 1/s; 12.0 by default
        pub f: f64,
    }
    impl Default for Params {
        fn default() -> Self {
            Self {
                r: 0.015,
                l: 0.05,
                offset: 0.004,
                mc: 0.004,
                mr: 0.009,
                ms: 0.02,
                k: 0.3,
                c: 1e-5,
                kr: 400.0,
                torque: 0.1,
                f: 12.0,
            }
        }
    }
    impl Params {
        /// The values in the order of [`VARIABLES`].
        pub fn values(&self) -> [f64; 11] {
            [
                self.r,
                self.l,
                self.offset,
                self.mc,
                self.mr,
                self.ms,
                self.k,
                self.c,
                self.kr,
                self.torque,
                self.f,
            ]
        }
        /// Params of values in the order of [`VARIABLES`].
        pub fn from_values(values: [f64; 11]) -> Self {
            Self {
                r: values[0],
                l: values[1],
                offset: values[2],
                mc: values[3],
                mr: values[4],
                ms: values[5],
                k: values[6],
                c: values[7],
                kr: values[8],
                torque: values[9],
                f: values[10],
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
            let offset = self.offset;
            let mc = self.mc;
            let mr = self.mr;
            let ms = self.ms;
            let k = self.k;
            let c = self.c;
            let kr = self.kr;
            let torque = self.torque;
            let f = self.f;
            let r_squared = r * r;
            // moment of inertia about the centre of mass of crank
            let I_crank = r_squared * mc * 0.08333333333333333;
            let l_squared = l * l;
            // moment of inertia about the centre of mass of rod
            let I_rod = l_squared * mr * 0.08333333333333333;
            let Y_0 = offset - r * 0.9659258262890683;
            let t1 = l_squared - Y_0 * Y_0;
            let t2 = t1 / l_squared;
            // distance of the centre of mass from the first end of crank
            let r_crank = r * 0.5;
            // constant of the inertia
            let C0 = I_crank + mc * (r_crank * r_crank) + r_squared * mr;
            // distance of the centre of mass from the first end of rod
            let r_rod = l * 0.5;
            // constant of the inertia
            let C1 = I_rod + mr * (r_rod * r_rod);
            let t3 = r * 0.25881904510252074;
            let s_ψ_0 = Y_0 / l;
            // which way the loop closes: as drawn
            let ε = (l * 0.9659258262890683 + 0.052 - t3).if_positive(1.0, -1.0);
            // position of `piston` as assembled
            let x_piston_0 = ε * t1.sqrt() + t3;
            let c_ψ_0 = (x_piston_0 - t3) / l;
            // angle of `rod` as assembled
            let ψ_0 = Real::atan2(s_ψ_0, c_ψ_0).unwrap_to(-0.2617993877991494);
            let cos_ψ_0 = Real::cos(ψ_0);
            // rate as assembled
            let ω_ψ_0 = -(t3 / (l * cos_ψ_0));
            let t4 = 1.3089969389957472 - ψ_0;
            let (t5, t6) = Real::sin_cos(t4);
            // rate as assembled
            let ν_piston_0 = -(r * t5 / cos_ψ_0);
            // constant of the inertia
            let C2 = r * mr * r_rod * 2.0;
            // inertia as assembled
            let A_crank_0 = C0 + C1 * (ω_ψ_0 * ω_ψ_0)
                + ms * (ν_piston_0 * ν_piston_0) + C2 * ω_ψ_0 * t6;
            if !(r > 0.0) {
                return Err(FAILURES[0].diagnostic(&[r]));
            }
            if !(mc >= 0.0) {
                return Err(FAILURES[1].diagnostic(&[mc]));
            }
            if !(I_crank >= 0.0) {
                return Err(FAILURES[2].diagnostic(&[I_crank]));
            }
            if !(l > 0.0) {
                return Err(FAILURES[3].diagnostic(&[l]));
            }
            if !(mr >= 0.0) {
                return Err(FAILURES[4].diagnostic(&[mr]));
            }
            if !(I_rod >= 0.0) {
                return Err(FAILURES[5].diagnostic(&[I_rod]));
            }
            if !(ms >= 0.0) {
                return Err(FAILURES[6].diagnostic(&[ms]));
            }
            if !(t2 >= 0.0) {
                return Err(FAILURES[7].diagnostic(&[Y_0.abs() - l, 1.3089969389957472]));
            }
            if !(t2 - 1e-12 > 0.0) {
                return Err(FAILURES[8].diagnostic(&[Y_0.abs() - l, 1.3089969389957472]));
            }
            if !(A_crank_0 > 0.0) {
                return Err(FAILURES[9].diagnostic(&[]));
            }
            let mut prepared = Prepared {
                start_states: [1.3089969389957472, 0.0],
                start_discretes: [0.0],
                r,
                l,
                offset,
                mr,
                ms,
                k,
                c,
                kr,
                torque,
                C0,
                l_squared,
                ε,
                per_l: l.recip(),
                r_per_l: r / l,
                r_rod,
                C1,
                C2,
                x_piston_0,
                c_ψ_0,
                s_ψ_0,
                mc_r_crank: mc * r_crank,
                constant1: f * 6.283185307179586,
                two_C1: C1 * 2.0,
                two_ms: ms * 2.0,
                two_c: c * 2.0,
                two_l: l * 2.0,
                two_C2: C2 * 2.0,
                offset_ms: offset * ms,
                half_k: k * 0.5,
                half_kr: kr * 0.5,
                per_l_squared: l_squared.recip(),
                table_of_φ: Table::none(),
            };
            check_start(prepared.states(), &prepared.start_states)?;
            check_start(prepared.discretes(), &prepared.start_discretes)?;
            prepared.table_of_φ = Table::fit(
                &prepared,
                &COORDINATES,
                0,
                4,
                |φ, d| { functions_of_φ(φ, array(d), &prepared) },
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
        pub start_discretes: [T; 1],
        /// `r`
        pub r: T,
        /// `l`
        pub l: T,
        /// `offset`
        pub offset: T,
        /// `mr`
        pub mr: T,
        /// `ms`
        pub ms: T,
        /// `k`
        pub k: T,
        /// `c`
        pub c: T,
        /// `kr`
        pub kr: T,
        /// `torque`
        pub torque: T,
        /// `C0` constant of the inertia
        pub C0: T,
        /// `l * l`
        pub l_squared: T,
        /// `ε` which way the loop closes: as drawn
        pub ε: T,
        /// `1.0 / l`
        pub per_l: T,
        /// `r / l`
        pub r_per_l: T,
        /// `r_rod` distance of the centre of mass from the first end of rod
        pub r_rod: T,
        /// `C1` constant of the inertia
        pub C1: T,
        /// `C2` constant of the inertia
        pub C2: T,
        /// `x_piston⁰` position of \`piston\` as assembled
        pub x_piston_0: T,
        /// `c_ψ⁰`
        pub c_ψ_0: T,
        /// `s_ψ⁰`
        pub s_ψ_0: T,
        /// `mc * r_crank`
        pub mc_r_crank: T,
        /// `6.283185307179586 * f`
        pub constant1: T,
        /// `2.0 * C1`
        pub two_C1: T,
        /// `2.0 * ms`
        pub two_ms: T,
        /// `2.0 * c`
        pub two_c: T,
        /// `2.0 * l`
        pub two_l: T,
        /// `2.0 * C2`
        pub two_C2: T,
        /// `offset * ms`
        pub offset_ms: T,
        /// `0.5 * k`
        pub half_k: T,
        /// `0.5 * kr`
        pub half_kr: T,
        /// `1.0 / (l * l)`
        pub per_l_squared: T,
        /// [`functions_of_φ`] near the start.
        pub table_of_φ: Table<T, 6>,
    }
    impl<T: Copy> Prepared<T> {
        /// The same with every number turned into another, without curves: for dual numbers or lanes.
        pub fn map<U>(&self, turn: impl Fn(T) -> U) -> Prepared<U> {
            Prepared {
                start_states: self.start_states.map(&turn),
                start_discretes: self.start_discretes.map(&turn),
                r: turn(self.r),
                l: turn(self.l),
                offset: turn(self.offset),
                mr: turn(self.mr),
                ms: turn(self.ms),
                k: turn(self.k),
                c: turn(self.c),
                kr: turn(self.kr),
                torque: turn(self.torque),
                C0: turn(self.C0),
                l_squared: turn(self.l_squared),
                ε: turn(self.ε),
                per_l: turn(self.per_l),
                r_per_l: turn(self.r_per_l),
                r_rod: turn(self.r_rod),
                C1: turn(self.C1),
                C2: turn(self.C2),
                x_piston_0: turn(self.x_piston_0),
                c_ψ_0: turn(self.c_ψ_0),
                s_ψ_0: turn(self.s_ψ_0),
                mc_r_crank: turn(self.mc_r_crank),
                constant1: turn(self.constant1),
                two_C1: turn(self.two_C1),
                two_ms: turn(self.two_ms),
                two_c: turn(self.two_c),
                two_l: turn(self.two_l),
                two_C2: turn(self.two_C2),
                offset_ms: turn(self.offset_ms),
                half_k: turn(self.half_k),
                half_kr: turn(self.half_kr),
                per_l_squared: turn(self.per_l_squared),
                table_of_φ: self.table_of_φ.map(&turn),
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
                offset: join(self.offset, other.offset),
                mr: join(self.mr, other.mr),
                ms: join(self.ms, other.ms),
                k: join(self.k, other.k),
                c: join(self.c, other.c),
                kr: join(self.kr, other.kr),
                torque: join(self.torque, other.torque),
                C0: join(self.C0, other.C0),
                l_squared: join(self.l_squared, other.l_squared),
                ε: join(self.ε, other.ε),
                per_l: join(self.per_l, other.per_l),
                r_per_l: join(self.r_per_l, other.r_per_l),
                r_rod: join(self.r_rod, other.r_rod),
                C1: join(self.C1, other.C1),
                C2: join(self.C2, other.C2),
                x_piston_0: join(self.x_piston_0, other.x_piston_0),
                c_ψ_0: join(self.c_ψ_0, other.c_ψ_0),
                s_ψ_0: join(self.s_ψ_0, other.s_ψ_0),
                mc_r_crank: join(self.mc_r_crank, other.mc_r_crank),
                constant1: join(self.constant1, other.constant1),
                two_C1: join(self.two_C1, other.two_C1),
                two_ms: join(self.two_ms, other.two_ms),
                two_c: join(self.two_c, other.two_c),
                two_l: join(self.two_l, other.two_l),
                two_C2: join(self.two_C2, other.two_C2),
                offset_ms: join(self.offset_ms, other.offset_ms),
                half_k: join(self.half_k, other.half_k),
                half_kr: join(self.half_kr, other.half_kr),
                per_l_squared: join(self.per_l_squared, other.per_l_squared),
                table_of_φ: self.table_of_φ.zip(&other.table_of_φ, &join),
            }
        }
    }
    impl Prepared<f64> {
        /// The same without tables and curves: closed forms everywhere.
        pub fn exact(self) -> Self {
            Self {
                table_of_φ: Table::none(),
                ..self
            }
        }
    }
    /// What [`rhs`], [`accept`] and [`closures`] need that depends on `φ` and params alone, in closed form.
    #[inline(always)]
    pub fn functions_of_φ<T: Real>(φ: T, d: &[T; 1], p: &Prepared<T>) -> [T; 6] {
        let turn_rod = d[0];
        let (sin_φ, cos_φ) = φ.sin_cos();
        let r_sin_φ = p.r * sin_φ;
        let Y = p.offset - r_sin_φ;
        let t1 = p.l_squared - Y * Y;
        let r_cos_φ = p.r * cos_φ;
        let x_piston = p.ε * t1.sqrt() + r_cos_φ;
        let c_ψ = p.per_l * (x_piston - r_cos_φ);
        let per_c_ψ = c_ψ.recip();
        let cos_φ_per_c_ψ = cos_φ * per_c_ψ;
        let r_per_l_cos_φ_per_c_ψ = p.r_per_l * cos_φ_per_c_ψ;
        // rate of the angle of `rod` per unit rate of `crank`
        let ω_ψ = -r_per_l_cos_φ_per_c_ψ;
        let ω_ψ_squared = ω_ψ * ω_ψ;
        let s_ψ = p.per_l * Y;
        let sin_φ_minus_ψ = sin_φ * c_ψ - cos_φ * s_ψ;
        // rate of the position of `piston` per unit rate of `crank`
        let ν_piston = -(p.r * (per_c_ψ * sin_φ_minus_ψ));
        let cos_φ_minus_ψ = cos_φ * c_ψ + sin_φ * s_ψ;
        // inertia
        let A = p.C0 + p.C1 * ω_ψ_squared + p.ms * (ν_piston * ν_piston)
            + p.C2 * (ω_ψ * cos_φ_minus_ψ);
        let per_A = A.recip();
        let ω_ψ_minus_one = ω_ψ - 1.0;
        let t2 = (p.c_ψ_0 * s_ψ - p.s_ψ_0 * c_ψ)
            .atan2(p.c_ψ_0 * c_ψ + p.s_ψ_0 * s_ψ);
        // angle of `rod` from the assembled one
        let ψ_minus_ψ_0 = t2.unwrap_to(turn_rod);
        let t3 = ω_ψ_minus_one
            * (T::from_f64(1.3089969389957472) - φ + ψ_minus_ψ_0);
        let t4 = p.k * (φ - 1.3089969389957472) + p.k * t3
            + p.k * (ψ_minus_ψ_0 * ω_ψ);
        // position of `piston` from the assembled one
        let t5 = x_piston - p.x_piston_0;
        // slope of the potential energy of springs
        let dP_s_dφ = t4 + p.kr * (t5 * ν_piston);
        let t6 = p.mc_r_crank * cos_φ + p.mr * (r_cos_φ + p.r_rod * (c_ψ * ω_ψ));
        // slope of the potential energy of gravity
        let dP_g_dφ = t6 * 9.81;
        // slope of the potential energy
        let dP_dφ = dP_s_dφ + dP_g_dφ;
        let t7 = p.c * (ω_ψ_minus_one * (r_per_l_cos_φ_per_c_ψ - -1.0))
            - p.c * (ω_ψ * (p.r_per_l * -cos_φ_per_c_ψ));
        let ddφ_per_dφ = per_A * t7;
        let ω_ψ_prime = p.per_l
            * (per_c_ψ * (r_sin_φ + p.l * (ω_ψ_squared * s_ψ)));
        let ν_piston_prime = per_c_ψ
            * (p.r * (cos_φ_minus_ψ * ω_ψ_minus_one) + ω_ψ * ν_piston * s_ψ);
        let t8 = p.two_C1 * (ω_ψ * ω_ψ_prime)
            + p.two_ms * (ν_piston * ν_piston_prime);
        // slope of the inertia
        let dA_dφ = t8 + p.C2 * (ω_ψ_prime * cos_φ_minus_ψ)
            + p.C2 * (sin_φ_minus_ψ * ω_ψ * ω_ψ_minus_one);
        let ddφ_per_dφ_squared = per_A * -(dA_dφ * 0.5);
        [
            per_A,
            per_A * dP_dφ,
            ddφ_per_dφ,
            ddφ_per_dφ_squared,
            ψ_minus_ψ_0,
            p.per_l_squared * t1,
        ]
    }
    /// dx/dt. Where a loop cannot close, entries are not numbers.
    #[inline(always)]
    pub fn rhs<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 1],
        u: &[T; 0],
        p: &Prepared<T>,
        dx: &mut [T; 2],
    ) {
        let φ = x[0];
        let dφ = x[1];
        let [per_A, per_A_dP_dφ, ddφ_per_dφ, ddφ_per_dφ_squared, ..] = if p
            .table_of_φ
            .covers(φ)
        {
            p.table_of_φ.polynomials(φ)
        } else {
            p.table_of_φ.where_covered(φ, functions_of_φ(φ, d, p))
        };
        // ── state ──
        let t1 = (-per_A_dP_dφ)
            .plus_product(ddφ_per_dφ, dφ)
            .plus_product(ddφ_per_dφ_squared, dφ * dφ);
        let ddφ = t1
            .plus_product(
                per_A,
                (p.torque * (p.constant1 * t).sin()).minus_product(p.c, dφ),
            );
        dx[0] = dφ;
        dx[1] = ddφ;
    }
    /// ∂(dx/dt)/∂x, row by row; entries that are always zero are left as they are.
    #[inline(always)]
    pub fn jacobian<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 1],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let φ = x[0];
        let dφ = x[1];
        let turn_rod = d[0];
        // ── configuration ──
        let (sin_φ, cos_φ) = φ.sin_cos();
        let r_sin_φ = p.r * sin_φ;
        let Y = p.offset - r_sin_φ;
        let r_cos_φ = p.r * cos_φ;
        let x_piston = p.ε * (p.l_squared - Y * Y).sqrt() + r_cos_φ;
        let c_ψ = p.per_l * (x_piston - r_cos_φ);
        let per_c_ψ = c_ψ.recip();
        // rate of the angle of `rod` per unit rate of `crank`
        let ω_ψ = -(p.r_per_l * (cos_φ * per_c_ψ));
        let ω_ψ_squared = ω_ψ * ω_ψ;
        let s_ψ = p.per_l * Y;
        let sin_φ_minus_ψ = sin_φ * c_ψ - cos_φ * s_ψ;
        // rate of the position of `piston` per unit rate of `crank`
        let ν_piston = -(p.r * (per_c_ψ * sin_φ_minus_ψ));
        let ν_piston_squared = ν_piston * ν_piston;
        let cos_φ_minus_ψ = cos_φ * c_ψ + sin_φ * s_ψ;
        let ω_ψ_cos_φ_minus_ψ = ω_ψ * cos_φ_minus_ψ;
        // inertia
        let A = p.C0 + p.C1 * ω_ψ_squared + p.ms * ν_piston_squared
            + p.C2 * ω_ψ_cos_φ_minus_ψ;
        let ω_ψ_squared_s_ψ = ω_ψ_squared * s_ψ;
        let t1 = r_sin_φ + p.l * ω_ψ_squared_s_ψ;
        let ω_ψ_prime = p.per_l * (per_c_ψ * t1);
        let ω_ψ_ω_ψ_prime = ω_ψ * ω_ψ_prime;
        let ω_ψ_minus_one = ω_ψ - 1.0;
        let t2 = p.r * (cos_φ_minus_ψ * ω_ψ_minus_one) + ω_ψ * ν_piston * s_ψ;
        let ν_piston_prime = per_c_ψ * t2;
        let t3 = p.two_C1 * ω_ψ_ω_ψ_prime + p.two_ms * (ν_piston * ν_piston_prime);
        let ω_ψ_prime_cos_φ_minus_ψ = ω_ψ_prime * cos_φ_minus_ψ;
        let sin_φ_minus_ψ_ω_ψ = sin_φ_minus_ψ * ω_ψ;
        // slope of the inertia
        let dA_dφ = t3 + p.C2 * ω_ψ_prime_cos_φ_minus_ψ
            + p.C2 * (sin_φ_minus_ψ_ω_ψ * ω_ψ_minus_one);
        let t4 = (p.c_ψ_0 * s_ψ - p.s_ψ_0 * c_ψ)
            .atan2(p.c_ψ_0 * c_ψ + p.s_ψ_0 * s_ψ);
        // angle of `rod` from the assembled one
        let ψ_minus_ψ_0 = t4.unwrap_to(turn_rod);
        let t5 = T::from_f64(1.3089969389957472) - φ + ψ_minus_ψ_0;
        let t6 = p.k * (φ - 1.3089969389957472) + p.k * (ω_ψ_minus_one * t5)
            + p.k * (ψ_minus_ψ_0 * ω_ψ);
        // position of `piston` from the assembled one
        let t7 = x_piston - p.x_piston_0;
        // slope of the potential energy of springs
        let dP_s_dφ = t6 + p.kr * (t7 * ν_piston);
        let t8 = p.mc_r_crank * cos_φ + p.mr * (r_cos_φ + p.r_rod * (c_ψ * ω_ψ));
        // slope of the potential energy of gravity
        let dP_g_dφ = t8 * 9.81;
        // slope of the potential energy
        let dP_dφ = dP_s_dφ + dP_g_dφ;
        let ω_ψ_minus_one_squared = ω_ψ_minus_one * ω_ψ_minus_one;
        let c_ω_ψ_minus_one_squared = p.c * ω_ψ_minus_one_squared;
        let c_ω_ψ_squared = p.c * ω_ψ_squared;
        let per_A = A.recip();
        let t9 = p.k + p.k * (ω_ψ_prime * t5) + p.k * ω_ψ_minus_one_squared
            + p.k * ω_ψ_squared;
        let ddP_s_dφ_dφ = t9 + p.k * (ψ_minus_ψ_0 * ω_ψ_prime)
            + p.kr * ν_piston_squared + p.kr * (t7 * ν_piston_prime);
        let t10 = r_sin_φ - p.r_rod * (c_ψ * ω_ψ_prime)
            + p.r_rod * ω_ψ_squared_s_ψ;
        let ddP_dφ_dφ = ddP_s_dφ_dφ - (p.mc_r_crank * sin_φ + p.mr * t10) * 9.81;
        let per_c_ψ_squared_ω_ψ_s_ψ = (c_ψ * c_ψ).recip() * ω_ψ * s_ψ;
        let ω_ψ_s_ψ = ω_ψ * s_ψ;
        let t11 = r_cos_φ + p.l * (c_ψ * (ω_ψ * ω_ψ_squared))
            + p.two_l * (ω_ψ_s_ψ * ω_ψ_prime);
        let dω_ψ_prime_dφ = p.per_l * (per_c_ψ_squared_ω_ψ_s_ψ * t1)
            + p.per_l * (per_c_ψ * t11);
        let t12 = (p.C1 * (ω_ψ_prime * ω_ψ_prime)
            + p.C1 * (ω_ψ * dω_ψ_prime_dφ)) * 2.0;
        let t13 = p.r * (sin_φ_minus_ψ * ω_ψ_minus_one_squared)
            + p.r * ω_ψ_prime_cos_φ_minus_ψ;
        let t14 = t13 + ν_piston * s_ψ * ω_ψ_prime + ω_ψ_s_ψ * ν_piston_prime
            + c_ψ * ω_ψ_squared * ν_piston;
        let dν_piston_prime_dφ = per_c_ψ_squared_ω_ψ_s_ψ * t2 + per_c_ψ * t14;
        let t15 = p.ms * (ν_piston_prime * ν_piston_prime)
            + p.ms * (ν_piston * dν_piston_prime_dφ);
        let t16 = t12 + t15 * 2.0 + p.C2 * (cos_φ_minus_ψ * dω_ψ_prime_dφ)
            + p.two_C2 * (sin_φ_minus_ψ * ω_ψ_prime * ω_ψ_minus_one);
        let ddA_dφ_dφ = t16 + p.C2 * (sin_φ_minus_ψ_ω_ψ * ω_ψ_prime)
            - p.C2 * (ω_ψ_cos_φ_minus_ψ * ω_ψ_minus_one_squared);
        let dτ_ddφ = -(p.c + c_ω_ψ_minus_one_squared + c_ω_ψ_squared);
        // ── state ──
        let t17 = p.torque * (p.constant1 * t).sin() - p.c * dφ
            - c_ω_ψ_minus_one_squared * dφ;
        // generalized torque of all other forces
        let τ = t17 - c_ω_ψ_squared * dφ;
        let dφ_squared = dφ * dφ;
        let t18 = p.two_c * (ω_ψ_prime * ω_ψ_minus_one) * dφ
            + p.two_c * ω_ψ_ω_ψ_prime * dφ;
        let dddφ_dφ = (A * A).recip() * dA_dφ
            * (dP_dφ - τ + dA_dφ * 0.5 * dφ_squared)
            - per_A * (ddP_dφ_dφ + t18 + ddA_dφ_dφ * 0.5 * dφ_squared);
        let dddφ_ddφ = per_A * (dτ_ddφ - dA_dφ * dφ);
        result[1] = T::from_f64(1.0);
        result[2] = dddφ_dφ;
        result[3] = dddφ_ddφ;
    }
    /// The model's outputs.
    #[inline(always)]
    pub fn outputs<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 1],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 2],
    ) {
        let φ = x[0];
        let dφ = x[1];
        // ── configuration ──
        let (sin_φ, cos_φ) = φ.sin_cos();
        let Y = p.offset - p.r * sin_φ;
        let r_cos_φ = p.r * cos_φ;
        let x_piston = p.ε * (p.l_squared - Y * Y).sqrt() + r_cos_φ;
        let c_ψ = p.per_l * (x_piston - r_cos_φ);
        let s_ψ = p.per_l * Y;
        let sin_φ_minus_ψ = sin_φ * c_ψ - cos_φ * s_ψ;
        // rate of the position of `piston` per unit rate of `crank`
        let ν_piston = -(p.r * (c_ψ.recip() * sin_φ_minus_ψ));
        // ── state ──
        let piston_v = ν_piston * dφ;
        result[0] = x_piston;
        result[1] = piston_v;
    }
    /// Kinetic and potential energy in J, dissipated and supplied power in W.
    #[inline(always)]
    pub fn energy<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 1],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 4],
    ) {
        let φ = x[0];
        let dφ = x[1];
        let turn_rod = d[0];
        // ── configuration ──
        let (sin_φ, cos_φ) = φ.sin_cos();
        let r_sin_φ = p.r * sin_φ;
        let Y = p.offset - r_sin_φ;
        let r_cos_φ = p.r * cos_φ;
        let x_piston = p.ε * (p.l_squared - Y * Y).sqrt() + r_cos_φ;
        let c_ψ = p.per_l * (x_piston - r_cos_φ);
        let per_c_ψ = c_ψ.recip();
        // rate of the angle of `rod` per unit rate of `crank`
        let ω_ψ = -(p.r_per_l * (cos_φ * per_c_ψ));
        let ω_ψ_squared = ω_ψ * ω_ψ;
        let s_ψ = p.per_l * Y;
        let sin_φ_minus_ψ = sin_φ * c_ψ - cos_φ * s_ψ;
        // rate of the position of `piston` per unit rate of `crank`
        let ν_piston = -(p.r * (per_c_ψ * sin_φ_minus_ψ));
        let cos_φ_minus_ψ = cos_φ * c_ψ + sin_φ * s_ψ;
        // inertia
        let A = p.C0 + p.C1 * ω_ψ_squared + p.ms * (ν_piston * ν_piston)
            + p.C2 * (ω_ψ * cos_φ_minus_ψ);
        let t1 = p.offset_ms + p.mc_r_crank * sin_φ
            + p.mr * (r_sin_φ + p.r_rod * s_ψ);
        let t2 = φ - 1.3089969389957472;
        let t3 = (p.c_ψ_0 * s_ψ - p.s_ψ_0 * c_ψ)
            .atan2(p.c_ψ_0 * c_ψ + p.s_ψ_0 * s_ψ);
        // angle of `rod` from the assembled one
        let ψ_minus_ψ_0 = t3.unwrap_to(turn_rod);
        let t4 = T::from_f64(1.3089969389957472) - φ + ψ_minus_ψ_0;
        let t5 = t1 * 9.81 + p.half_k * (t2 * t2) + p.half_k * (t4 * t4)
            + p.half_k * (ψ_minus_ψ_0 * ψ_minus_ψ_0);
        // position of `piston` from the assembled one
        let t6 = x_piston - p.x_piston_0;
        let ω_ψ_minus_one = ω_ψ - 1.0;
        // ── state ──
        let dφ_squared = dφ * dφ;
        let t7 = p.c * dφ_squared
            + p.c * (ω_ψ_minus_one * ω_ψ_minus_one) * dφ_squared;
        result[0] = A * 0.5 * dφ_squared;
        result[1] = t5 + p.half_kr * (t6 * t6);
        result[2] = t7 + p.c * ω_ψ_squared * dφ_squared;
        result[3] = p.torque * ((p.constant1 * t).sin() * dφ);
    }
    /// Event functions: each event happens where its function rises through zero.
    #[inline(always)]
    pub fn events<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 1],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 0],
    ) {}
    /// For each loop a number that is positive where it closes and zero at a dead point.
    #[inline(always)]
    pub fn closures<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 1],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 1],
    ) {
        let φ = x[0];
        let [.., t1] = if p.table_of_φ.covers(φ) {
            p.table_of_φ.polynomials(φ)
        } else {
            p.table_of_φ.where_covered(φ, functions_of_φ(φ, d, p))
        };
        result[0] = t1;
    }
    /// The discrete state after an accepted step that ends in `x`; entries that stay are left as they are.
    #[inline(always)]
    pub fn accept<T: Real>(
        t: T,
        x: &[T; 2],
        d: &[T; 1],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 1],
    ) {
        let φ = x[0];
        let [.., ψ_minus_ψ_0, _] = if p.table_of_φ.covers(φ) {
            p.table_of_φ.polynomials(φ)
        } else {
            p.table_of_φ.where_covered(φ, functions_of_φ(φ, d, p))
        };
        result[0] = ψ_minus_ψ_0;
    }
    /// Time in s of each drive's next kink.
    #[inline(always)]
    pub fn next_kinks<T: Real>(d: &[T; 1], p: &Prepared<T>, result: &mut [T; 0]) {}
    /// The discrete state after drive `index` passed its kink; entries that stay are left as they are.
    #[inline(always)]
    pub fn pass_kink<T: Real>(
        index: usize,
        d: &[T; 1],
        p: &Prepared<T>,
        result: &mut [T; 1],
    ) {}
    /// The state after event `index`; entries that stay are left as they are.
    #[inline(always)]
    pub fn pass_event<T: Real>(
        index: usize,
        t: T,
        x: &[T; 2],
        d: &[T; 1],
        u: &[T; 0],
        p: &Prepared<T>,
        x_after: &mut [T; 2],
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
            1
        }
        fn closures(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], values: &mut [f64]) {
            closures(t, array(x), array(d), array(u), self, array_mut(values));
        }
        fn loop_name(&self, index: usize) -> &str {
            const NAMES: [&str; 1] = ["crank–rod–piston"];
            NAMES[index]
        }
        fn tables(&self) -> Vec<TableReport> {
            [self.table_of_φ.report(0)].into_iter().flatten().collect()
        }
        fn is_outside_tables(&self, x: &[f64]) -> bool {
            self.table_of_φ.is_left_by(x[0])
        }
        fn take_plain_steps(&self, steps: &mut PlainSteps<'_>) {
            steps.on_lanes(self);
        }
    }
    impl LaneSystem for Prepared<f64> {
        type InLanes<L: Lanes> = Prepared<L>;
        type States<L: Lanes> = [L; 2];
        type Discretes<L: Lanes> = [L; 1];
        type Loops<L: Lanes> = [L; 1];
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
            L::from_f64(-1.0).larger(lanes.table_of_φ.left_by(x[0]))
        }
    }
    /// Every quantity with a name: params, states, discrete states, inputs, outputs.
    pub static VARIABLES: [Variable; 16] = [
        Variable {
            name: Cow::Borrowed("r"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length of the crank"),
            causality: Causality::Parameter,
            start: Some(0.015),
        },
        Variable {
            name: Cow::Borrowed("l"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length of the connecting rod"),
            causality: Causality::Parameter,
            start: Some(0.05),
        },
        Variable {
            name: Cow::Borrowed("offset"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("of the guide from the crank's pivot"),
            causality: Causality::Parameter,
            start: Some(0.004),
        },
        Variable {
            name: Cow::Borrowed("mc"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("masses of crank, rod and slide"),
            causality: Causality::Parameter,
            start: Some(0.004),
        },
        Variable {
            name: Cow::Borrowed("mr"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("masses of crank, rod and slide"),
            causality: Causality::Parameter,
            start: Some(0.009),
        },
        Variable {
            name: Cow::Borrowed("ms"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("masses of crank, rod and slide"),
            causality: Causality::Parameter,
            start: Some(0.02),
        },
        Variable {
            name: Cow::Borrowed("k"),
            unit: Cow::Borrowed("N*m"),
            meaning: Cow::Borrowed("stiffness of a hinge"),
            causality: Causality::Parameter,
            start: Some(0.3),
        },
        Variable {
            name: Cow::Borrowed("c"),
            unit: Cow::Borrowed("N*m*s"),
            meaning: Cow::Borrowed("damping of a hinge"),
            causality: Causality::Parameter,
            start: Some(1e-5),
        },
        Variable {
            name: Cow::Borrowed("kr"),
            unit: Cow::Borrowed("N/m"),
            meaning: Cow::Borrowed("stiffness of the return spring"),
            causality: Causality::Parameter,
            start: Some(400.0),
        },
        Variable {
            name: Cow::Borrowed("torque"),
            unit: Cow::Borrowed("N*m"),
            meaning: Cow::Borrowed("drive of the crank"),
            causality: Causality::Parameter,
            start: Some(0.1),
        },
        Variable {
            name: Cow::Borrowed("f"),
            unit: Cow::Borrowed("1/s"),
            meaning: Cow::Borrowed("drive of the crank"),
            causality: Causality::Parameter,
            start: Some(12.0),
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
            name: Cow::Borrowed("rod.turn"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed(
                "angle of `rod` from the assembled one at the last accepted step",
            ),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("position"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("position of the slide"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("velocity"),
            unit: Cow::Borrowed("m/s"),
            meaning: Cow::Borrowed("velocity of the slide"),
            causality: Causality::Output,
            start: None,
        },
    ];
    static PARAMS: &[Variable] = VARIABLES.split_at(0).1.split_at(11).0;
    static STATES: &[Variable] = VARIABLES.split_at(11).1.split_at(2).0;
    static DISCRETES: &[Variable] = VARIABLES.split_at(13).1.split_at(1).0;
    static INPUTS: &[Variable] = VARIABLES.split_at(14).1.split_at(0).0;
    static OUTPUTS: &[Variable] = VARIABLES.split_at(14).1.split_at(2).0;
    /// Positions of the coordinates and of their rates among the states.
    static COORDINATES: [(usize, usize); 1] = [(0, 1)];
    static TURNING: [usize; 1] = [0];
    static FAILURES: [Failure; 10] = [
        Failure {
            message: Cow::Borrowed("the length of `crank` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("slider_crank.flex"),
                line: 15,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link crank from O to A { length = r, angle = 75 deg exact, mass = mc, symbol = φ }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `crank` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("slider_crank.flex"),
                line: 15,
                column: 60,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link crank from O to A { length = r, angle = 75 deg exact, mass = mc, symbol = φ }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `crank` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("slider_crank.flex"),
                line: 15,
                column: 60,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link crank from O to A { length = r, angle = 75 deg exact, mass = mc, symbol = φ }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the length of `rod` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("slider_crank.flex"),
                line: 16,
                column: 6,
                width: 3,
                excerpt: Cow::Borrowed(
                    "link rod   from A to P { length = l, angle = -15 deg,      mass = mr, symbol = ψ }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `rod` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("slider_crank.flex"),
                line: 16,
                column: 60,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link rod   from A to P { length = l, angle = -15 deg,      mass = mr, symbol = ψ }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `rod` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("slider_crank.flex"),
                line: 16,
                column: 60,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link rod   from A to P { length = l, angle = -15 deg,      mass = mr, symbol = ψ }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `piston` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("slider_crank.flex"),
                line: 18,
                column: 52,
                width: 4,
                excerpt: Cow::Borrowed(
                    "slide piston along (1, 0) through (0 mm, offset) { mass = ms, at = 52 mm }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed(
                "the loop crank–rod–piston cannot close: at `crank` angle {1} the gap is {0}",
            ),
            hint: Some(
                Cow::Borrowed("change a length, an angle or the place of a guide"),
            ),
            site: Some(Site {
                file: Cow::Borrowed("slider_crank.flex"),
                line: 16,
                column: 6,
                width: 3,
                excerpt: Cow::Borrowed(
                    "link rod   from A to P { length = l, angle = -15 deg,      mass = mr, symbol = ψ }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Degree]),
        },
        Failure {
            message: Cow::Borrowed(
                "the loop crank–rod–piston stands at a dead point: at `crank` angle {1} `rod` stands square to the guide of `piston`",
            ),
            hint: Some(
                Cow::Borrowed(
                    "assemble it in another configuration: change an angle or a length; or ask for the coordinate `rod.angle`, if that leads it through",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("slider_crank.flex"),
                line: 16,
                column: 6,
                width: 3,
                excerpt: Cow::Borrowed(
                    "link rod   from A to P { length = l, angle = -15 deg,      mass = mr, symbol = ψ }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Degree]),
        },
        Failure {
            message: Cow::Borrowed("`crank` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("slider_crank.flex"),
                line: 15,
                column: 6,
                width: 5,
                excerpt: Cow::Borrowed(
                    "link crank from O to A { length = r, angle = 75 deg exact, mass = mc, symbol = φ }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
    ];
    /// The equations of motion in plain text.
    pub const EQUATIONS: &str = r#"slider_crank
════════════

A flexure slider–crank: a crank moves a slide through a connecting rod, against a return spring.

Loop crank–rod–piston
─────────────────────

  r e^(i φ) + l e^(i ψ) - x_piston - i offset = 0

  X        = -r cos(φ)
  Y        = offset - r sin(φ)
  x_piston = ε sqrt(l² - Y²) - X
  c_ψ      = (x_piston + X) / l
  s_ψ      = Y/l

  ψ = atan2(s_ψ, c_ψ), continuous over many turns; ⁰: as assembled
  ω_ψ = dψ/dφ, ν_piston = dx_piston/dφ, ' = d/dφ

  ω_ψ       = -r cos(φ) / (l cos(ψ))
  ν_piston  = r sin(ψ - φ) / cos(ψ)
  ω_ψ'      = (r sin(φ) + l ω_ψ² sin(ψ)) / (l cos(ψ))
  ν_piston' = (r (ω_ψ - 1) cos(φ - ψ) + ω_ψ ν_piston sin(ψ)) / cos(ψ)

Constants of the inertia
────────────────────────

  C0 = I_crank + mc r_crank² + mr r²
  C1 = I_rod + mr r_rod²
  C2 = 2 r mr r_rod

Equation of motion of `crank`
─────────────────────────────

Inertia:

  A(φ)  = C0 + C1 ω_ψ² + ms ν_piston² + C2 ω_ψ cos(φ - ψ)
  ∂A/∂φ = 2 C1 ω_ψ ω_ψ'
        + 2 ms ν_piston ν_piston'
        + C2 ω_ψ' cos(φ - ψ)
        + C2 ω_ψ (ω_ψ - 1) sin(φ - ψ)

Potential energy:

  ∂P_s/∂φ = k (φ - φ⁰)
          + k (ω_ψ - 1) (ψ - ψ⁰ - φ + φ⁰)
          + k ω_ψ (ψ - ψ⁰)
          + kr ν_piston (x_piston - x_piston⁰)
  ∂P_g/∂φ = g (mc r_crank cos(φ) + mr (r cos(φ) + r_rod ω_ψ cos(ψ)))
  ∂P/∂φ   = ∂P_s/∂φ + ∂P_g/∂φ

Other forces:

  τ = torque sin(2 π f t) - c φ̇ - c φ̇ (ω_ψ - 1)² - c φ̇ ω_ψ²

Balance:

  A(φ) φ̈ + ½ ∂A/∂φ φ̇² + ∂P/∂φ = τ

Constants
─────────

  r_crank = ½ r          distance of the centre of mass from the first end of crank
  I_crank = 1/12 mc r²   moment of inertia about the centre of mass of crank
  r_rod   = ½ l          distance of the centre of mass from the first end of rod
  I_rod   = 1/12 mr l²   moment of inertia about the centre of mass of rod
  φ⁰      = 5/12 π       angle of `crank` as assembled
  ε       = sign(l cos(1/12 π) + X⁰ + 0.052)
            which way the loop closes: as drawn
  g       = 9.81         acceleration of gravity

  ψ⁰, x_piston⁰, X⁰: by the formulas of the loops, at φ = φ⁰
"#;
    /// The equations of motion as a LaTeX document.
    pub const EQUATIONS_LATEX: &str = r#"\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\begin{document}

\section*{slider\_crank}
A flexure slider–crank: a crank moves a slide through a connecting rod, against a return spring.

\subsection*{Loop crank–rod–piston}
\begin{align*}
& r\, e^{i \varphi} + l\, e^{i \psi} - x_{\mathrm{piston}} - i\,\mathit{offset} = 0 \\
X &= -r \cos \varphi \\
Y &= \mathit{offset} - r \sin \varphi \\
x_{\mathrm{piston}} &= \varepsilon \, \sqrt{l^{2} - Y^{2}} - X \\
\cos \psi &= \frac{x_{\mathrm{piston}} + X}{l} \\
\sin \psi &= \frac{Y}{l} \\
& \psi = \operatorname{atan2}(\sin \psi, \cos \psi) \quad\text{(continuous over many turns; ${}^0$: as assembled)} \\
& \omega_{\psi} = \frac{\mathrm d\psi}{\mathrm d\varphi},\quad \nu_{\mathrm{piston}} = \frac{\mathrm dx_{\mathrm{piston}}}{\mathrm d\varphi},\quad {}' = \frac{\mathrm d}{\mathrm d\varphi} \\
\omega_{\psi} &= -\frac{r \cos \varphi}{l \cos \psi} \\
\nu_{\mathrm{piston}} &= \frac{r \sin\left(\psi - \varphi\right)}{\cos \psi} \\
\omega'_{\psi} &= \frac{r \sin \varphi + l \, \omega_{\psi}^{2} \sin \psi}{l \cos \psi} \\
\nu'_{\mathrm{piston}} &= \frac{r \left(\omega_{\psi} - 1\right) \cos\left(\varphi - \psi\right) + \omega_{\psi} \, \nu_{\mathrm{piston}} \sin \psi}{\cos \psi}
\end{align*}

\subsection*{Constants of the inertia}
\begin{align*}
C_{0} &= I_{\mathrm{crank}} + \mathit{mc} \, r_{\mathrm{crank}}^{2} + \mathit{mr} \, r^{2} \\
C_{1} &= I_{\mathrm{rod}} + \mathit{mr} \, r_{\mathrm{rod}}^{2} \\
C_{2} &= 2 \, r \, \mathit{mr} \, r_{\mathrm{rod}}
\end{align*}

\subsection*{Equation of motion of \texttt{crank}}
Inertia:
\begin{align*}
A(\varphi) &= C_{0} + C_{1} \, \omega_{\psi}^{2} + \mathit{ms} \, \nu_{\mathrm{piston}}^{2} + C_{2} \, \omega_{\psi} \cos\left(\varphi - \psi\right) \\
\frac{\partial A}{\partial \varphi} &= 2 \, C_{1} \, \omega_{\psi} \, \omega'_{\psi} \\
&\quad {}+ 2 \, \mathit{ms} \, \nu_{\mathrm{piston}} \, \nu'_{\mathrm{piston}} \\
&\quad {}+ C_{2} \, \omega'_{\psi} \cos\left(\varphi - \psi\right) \\
&\quad {}+ C_{2} \, \omega_{\psi} \left(\omega_{\psi} - 1\right) \sin\left(\varphi - \psi\right)
\end{align*}
Potential energy:
\begin{align*}
\frac{\partial P_s}{\partial \varphi} &= k \left(\varphi - \varphi^0\right) \\
&\quad {}+ k \left(\omega_{\psi} - 1\right) \left(\psi - \psi^0 - \varphi + \varphi^0\right) \\
&\quad {}+ k \, \omega_{\psi} \left(\psi - \psi^0\right) \\
&\quad {}+ \mathit{kr} \, \nu_{\mathrm{piston}} \left(x_{\mathrm{piston}} - x_{\mathrm{piston}}^0\right) \\
\frac{\partial P_g}{\partial \varphi} &= g \left(\mathit{mc} \, r_{\mathrm{crank}} \cos \varphi + \mathit{mr} \left(r \cos \varphi + r_{\mathrm{rod}} \, \omega_{\psi} \cos \psi\right)\right) \\
\frac{\partial P}{\partial \varphi} &= \frac{\partial P_s}{\partial \varphi} + \frac{\partial P_g}{\partial \varphi}
\end{align*}
Other forces:
\begin{align*}
\tau &= \mathit{torque} \sin\left(2 \, \pi \, f \, t\right) - c \, \dot{\varphi} - c \, \dot{\varphi} \left(\omega_{\psi} - 1\right)^{2} - c \, \dot{\varphi} \, \omega_{\psi}^{2}
\end{align*}
Balance:
\begin{align*}
& A(\varphi)\,\ddot{\varphi} + \tfrac12 \frac{\partial A}{\partial \varphi}\,\dot{\varphi}^2 + \frac{\partial P}{\partial \varphi} = \tau
\end{align*}

\subsection*{Constants}
\begin{align*}
r_{\mathrm{crank}} &= \frac{1}{2} \, r && \text{distance of the centre of mass from the first end of crank} \\
I_{\mathrm{crank}} &= \frac{1}{12} \, \mathit{mc} \, r^{2} && \text{moment of inertia about the centre of mass of crank} \\
r_{\mathrm{rod}} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of rod} \\
I_{\mathrm{rod}} &= \frac{1}{12} \, \mathit{mr} \, l^{2} && \text{moment of inertia about the centre of mass of rod} \\
\varphi^0 &= \frac{5}{12} \, \pi && \text{angle of \texttt{crank} as assembled} \\
\varepsilon &= \operatorname{sgn}\left(l \cos\left(\frac{1}{12} \, \pi\right) + {X}^0 + 0.052\right) && \text{which way the loop closes: as drawn} \\
g &= 9.81 && \text{acceleration of gravity} \\
& \psi^0,\, x_{\mathrm{piston}}^0,\, {X}^0: \text{ by the formulas of the loops, at } \varphi = \varphi^0
\end{align*}

\end{document}
"#;
}
