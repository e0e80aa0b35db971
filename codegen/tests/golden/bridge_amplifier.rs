/// Simulator of the model `bridge_amplifier`, generated from its equations of motion.
///
/// A bridge-type amplifier: a piezo stack spreads two blocks, and four inclined arms turn their
/// motion into a larger one of the output across it.
#[allow(
    non_snake_case,
    non_upper_case_globals,
    unused,
    clippy::all,
    clippy::pedantic,
    rustdoc::all
)]
pub mod bridge_amplifier {
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
        /// length of an arm between its hinges in m; 0.02 by default
        pub l: f64,
        /// inclination of the arms; 0.13962634015954636 by default
        pub rise: f64,
        /// mass of an arm, of a block, of the output in kg; 0.0008 by default
        pub ma: f64,
        /// mass of an arm, of a block, of the output in kg; 0.004 by default
        pub mb: f64,
        /// mass of an arm, of a block, of the output in kg; 0.012 by default
        pub mo: f64,
        /// stiffness of a hinge in N\*m; 1.5 by default
        pub k: f64,
        /// damping of a hinge in N\*m\*s; 2e-5 by default
        pub c: f64,
        /// piezo stack in N/m; 2e7 by default
        pub ks: f64,
        /// piezo stack in N\*s/m; 60.0 by default
        pub cs: f64,
        /// its free extension in m; 1e-5 by default
        pub stroke: f64,
        /// its free extension in 1/s; 200.0 by default
        pub f: f64,
    }
    impl Default for Params {
        fn default() -> Self {
            Self {
                l: 0.02,
                rise: 0.13962634015954636,
                ma: 0.0008,
                mb: 0.004,
                mo: 0.012,
                k: 1.5,
                c: 2e-5,
                ks: 2e7,
                cs: 60.0,
                stroke: 1e-5,
                f: 200.0,
            }
        }
    }
    impl Params {
        /// The values in the order of [`VARIABLES`].
        pub fn values(&self) -> [f64; 11] {
            [
                self.l,
                self.rise,
                self.ma,
                self.mb,
                self.mo,
                self.k,
                self.c,
                self.ks,
                self.cs,
                self.stroke,
                self.f,
            ]
        }
        /// Params of values in the order of [`VARIABLES`].
        pub fn from_values(values: [f64; 11]) -> Self {
            Self {
                l: values[0],
                rise: values[1],
                ma: values[2],
                mb: values[3],
                mo: values[4],
                k: values[5],
                c: values[6],
                ks: values[7],
                cs: values[8],
                stroke: values[9],
                f: values[10],
            }
        }
        /// Closes the loops and computes everything that depends on params alone.
        ///
        /// # Errors
        /// What is wrong with the parameter set, in the words of `flexure check`.
        pub fn prepare(&self) -> Result<Prepared<f64>, Diagnostic> {
            check_params(PARAMS, &self.values())?;
            let l = self.l;
            let rise = self.rise;
            let ma = self.ma;
            let mb = self.mb;
            let mo = self.mo;
            let k = self.k;
            let c = self.c;
            let ks = self.ks;
            let cs = self.cs;
            let stroke = self.stroke;
            let f = self.f;
            let l_squared = l * l;
            let l_squared_ma = l_squared * ma;
            // moment of inertia about the centre of mass of lower_left
            let I1 = l_squared_ma * 0.08333333333333333;
            // angle of `lower_left` as assembled
            let φ1_0 = 3.141592653589793 - rise;
            let (sin_φ1_0, cos_φ1_0) = Real::sin_cos(φ1_0);
            let l_cos_φ1_0 = l * cos_φ1_0;
            let X1_0 = -l_cos_φ1_0;
            let t1 = l_squared - X1_0 * X1_0;
            let t2 = t1 / l_squared;
            let l_squared_ma_plus_two_I1 = l_squared_ma + I1 * 2.0;
            // distance of the centre of mass from the first end of lower_left
            let r1 = l * 0.5;
            let ma_r1_squared = ma * (r1 * r1);
            let l_squared_mb = l_squared * mb;
            let r1_minus_l = r1 - l;
            let ma_r1_minus_l_squared = ma * (r1_minus_l * r1_minus_l);
            // constant of the inertia
            let C0 = l_squared_ma_plus_two_I1 + ma_r1_squared + l_squared_mb
                + ma_r1_minus_l_squared;
            // constant of the inertia
            let C1 = l_squared_ma_plus_two_I1 + l_squared_mb + ma_r1_squared
                + ma_r1_minus_l_squared;
            let height = l * Real::sin(rise);
            let t3 = rise + 3.141592653589793;
            let l_sin_φ1_0 = l * sin_φ1_0;
            // which way the loop closes: as drawn
            let ε1 = (height * 2.0 - l * Real::sin(t3) - l_sin_φ1_0)
                .if_positive(1.0, -1.0);
            // position of `table` as assembled
            let x_table_0 = ε1 * t1.sqrt() + l_sin_φ1_0;
            let s3_0 = -((x_table_0 - l_sin_φ1_0) / l);
            let c3_0 = -(X1_0 / l);
            // angle of `upper_left` as assembled
            let φ3_0 = Real::atan2(s3_0, c3_0).unwrap_to(t3);
            let (sin_φ3_0, cos_φ3_0) = Real::sin_cos(φ3_0);
            // rate as assembled
            let ω3_0 = sin_φ1_0 / sin_φ3_0;
            let φ1_0_minus_φ3_0 = φ1_0 - φ3_0;
            let (sin_φ1_0_minus_φ3_0, cos_φ1_0_minus_φ3_0) = Real::sin_cos(
                φ1_0_minus_φ3_0,
            );
            // rate as assembled
            let ν_table_0 = -(l * sin_φ1_0_minus_φ3_0 / sin_φ3_0);
            // constant of the inertia
            let C2 = -(l * ma * (l - r1) * 4.0);
            // inertia as assembled
            let A_lower_left_0 = C0 + C1 * (ω3_0 * ω3_0)
                + mo * (ν_table_0 * ν_table_0) + C2 * ω3_0 * cos_φ1_0_minus_φ3_0;
            let t4 = l_cos_φ1_0 + l * cos_φ3_0;
            let t5 = l_sin_φ1_0 + l * sin_φ3_0;
            let Δx_piezo_0 = -t4;
            let Δy_piezo_0 = -t5;
            // length of `piezo` as assembled
            let L_piezo_0 = (Δx_piezo_0 * Δx_piezo_0 + Δy_piezo_0 * Δy_piezo_0)
                .sqrt();
            if !(l > 0.0) {
                return Err(FAILURES[0].diagnostic(&[l]));
            }
            if !(ma >= 0.0) {
                return Err(FAILURES[1].diagnostic(&[ma]));
            }
            if !(I1 >= 0.0) {
                return Err(FAILURES[2].diagnostic(&[I1]));
            }
            if !(mb >= 0.0) {
                return Err(FAILURES[3].diagnostic(&[mb]));
            }
            if !(mo >= 0.0) {
                return Err(FAILURES[4].diagnostic(&[mo]));
            }
            if !(t2 >= 0.0) {
                return Err(FAILURES[5].diagnostic(&[X1_0.abs() - l, φ1_0]));
            }
            if !(t2 - 1e-12 > 0.0) {
                return Err(FAILURES[6].diagnostic(&[X1_0.abs() - l, φ1_0]));
            }
            if !(f >= 0.0) {
                return Err(FAILURES[7].diagnostic(&[f]));
            }
            if !(A_lower_left_0 > 0.0) {
                return Err(FAILURES[8].diagnostic(&[]));
            }
            let mut prepared = Prepared {
                start_states: [φ1_0, 0.0],
                start_discretes: [0.0],
                l,
                mo,
                k,
                ks,
                cs,
                stroke,
                l_squared,
                C0,
                φ1_0,
                ε1,
                per_l: l.recip(),
                C1,
                C2,
                c3_0,
                s3_0,
                two_k: k * 2.0,
                φ3_0,
                constant1: t4,
                constant2: t5,
                constant3: f * 6.283185307179586,
                L_piezo_0,
                constant4: stroke * f * 6.283185307179586,
                two_c: c * 2.0,
                two_C1: C1 * 2.0,
                two_mo: mo * 2.0,
                _4_c: c * 4.0,
                two_l: l * 2.0,
                two_C2: C2 * 2.0,
                half_k: k * 0.5,
                half_ks: ks * 0.5,
                per_l_squared: l_squared.recip(),
                table_of_φ1: Table::none(),
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
        pub start_states: [T; 2],
        /// Discrete state at the start.
        pub start_discretes: [T; 1],
        /// `l`
        pub l: T,
        /// `mo`
        pub mo: T,
        /// `k`
        pub k: T,
        /// `ks`
        pub ks: T,
        /// `cs`
        pub cs: T,
        /// `stroke`
        pub stroke: T,
        /// `l * l`
        pub l_squared: T,
        /// `C0` constant of the inertia
        pub C0: T,
        /// `φ1⁰` angle of \`lower_left\` as assembled
        pub φ1_0: T,
        /// `ε1` which way the loop closes: as drawn
        pub ε1: T,
        /// `1.0 / l`
        pub per_l: T,
        /// `C1` constant of the inertia
        pub C1: T,
        /// `C2` constant of the inertia
        pub C2: T,
        /// `c3⁰`
        pub c3_0: T,
        /// `s3⁰`
        pub s3_0: T,
        /// `2.0 * k`
        pub two_k: T,
        /// `φ3⁰` angle of \`upper_left\` as assembled
        pub φ3_0: T,
        /// `l * cos(φ1⁰) + l * cos(φ3⁰)`
        pub constant1: T,
        /// `l * sin(φ1⁰) + l * sin(φ3⁰)`
        pub constant2: T,
        /// `6.283185307179586 * f`
        pub constant3: T,
        /// `L_piezo⁰` length of \`piezo\` as assembled
        pub L_piezo_0: T,
        /// `6.283185307179586 * stroke * f`
        pub constant4: T,
        /// `2.0 * c`
        pub two_c: T,
        /// `2.0 * C1`
        pub two_C1: T,
        /// `2.0 * mo`
        pub two_mo: T,
        /// `4.0 * c`
        pub _4_c: T,
        /// `2.0 * l`
        pub two_l: T,
        /// `2.0 * C2`
        pub two_C2: T,
        /// `0.5 * k`
        pub half_k: T,
        /// `0.5 * ks`
        pub half_ks: T,
        /// `1.0 / (l * l)`
        pub per_l_squared: T,
        /// [`functions_of_φ1`] near the start.
        pub table_of_φ1: Table<T, 8>,
    }
    impl<T: Copy> Prepared<T> {
        /// The same with every number turned into another, without curves: for dual numbers or lanes.
        pub fn map<U>(&self, turn: impl Fn(T) -> U) -> Prepared<U> {
            Prepared {
                start_states: self.start_states.map(&turn),
                start_discretes: self.start_discretes.map(&turn),
                l: turn(self.l),
                mo: turn(self.mo),
                k: turn(self.k),
                ks: turn(self.ks),
                cs: turn(self.cs),
                stroke: turn(self.stroke),
                l_squared: turn(self.l_squared),
                C0: turn(self.C0),
                φ1_0: turn(self.φ1_0),
                ε1: turn(self.ε1),
                per_l: turn(self.per_l),
                C1: turn(self.C1),
                C2: turn(self.C2),
                c3_0: turn(self.c3_0),
                s3_0: turn(self.s3_0),
                two_k: turn(self.two_k),
                φ3_0: turn(self.φ3_0),
                constant1: turn(self.constant1),
                constant2: turn(self.constant2),
                constant3: turn(self.constant3),
                L_piezo_0: turn(self.L_piezo_0),
                constant4: turn(self.constant4),
                two_c: turn(self.two_c),
                two_C1: turn(self.two_C1),
                two_mo: turn(self.two_mo),
                _4_c: turn(self._4_c),
                two_l: turn(self.two_l),
                two_C2: turn(self.two_C2),
                half_k: turn(self.half_k),
                half_ks: turn(self.half_ks),
                per_l_squared: turn(self.per_l_squared),
                table_of_φ1: self.table_of_φ1.map(&turn),
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
                mo: join(self.mo, other.mo),
                k: join(self.k, other.k),
                ks: join(self.ks, other.ks),
                cs: join(self.cs, other.cs),
                stroke: join(self.stroke, other.stroke),
                l_squared: join(self.l_squared, other.l_squared),
                C0: join(self.C0, other.C0),
                φ1_0: join(self.φ1_0, other.φ1_0),
                ε1: join(self.ε1, other.ε1),
                per_l: join(self.per_l, other.per_l),
                C1: join(self.C1, other.C1),
                C2: join(self.C2, other.C2),
                c3_0: join(self.c3_0, other.c3_0),
                s3_0: join(self.s3_0, other.s3_0),
                two_k: join(self.two_k, other.two_k),
                φ3_0: join(self.φ3_0, other.φ3_0),
                constant1: join(self.constant1, other.constant1),
                constant2: join(self.constant2, other.constant2),
                constant3: join(self.constant3, other.constant3),
                L_piezo_0: join(self.L_piezo_0, other.L_piezo_0),
                constant4: join(self.constant4, other.constant4),
                two_c: join(self.two_c, other.two_c),
                two_C1: join(self.two_C1, other.two_C1),
                two_mo: join(self.two_mo, other.two_mo),
                _4_c: join(self._4_c, other._4_c),
                two_l: join(self.two_l, other.two_l),
                two_C2: join(self.two_C2, other.two_C2),
                half_k: join(self.half_k, other.half_k),
                half_ks: join(self.half_ks, other.half_ks),
                per_l_squared: join(self.per_l_squared, other.per_l_squared),
                table_of_φ1: self.table_of_φ1.zip(&other.table_of_φ1, &join),
            }
        }
    }
    impl Prepared<f64> {
        /// The same without tables and curves: closed forms everywhere.
        pub fn exact(self) -> Self {
            Self {
                table_of_φ1: Table::none(),
                ..self
            }
        }
    }
    /// What [`rhs`], [`accept`] and [`closures`] need that depends on `φ1` and params alone, in closed form.
    #[inline(always)]
    pub fn functions_of_φ1<T: Real>(φ1: T, d: &[T; 1], p: &Prepared<T>) -> [T; 8] {
        let turn_upper_left = d[0];
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let A_x = p.l * cos_φ1;
        // vector that is left to close lower_left–upper_left–table
        let X1 = -A_x;
        let t1 = p.l_squared - X1 * X1;
        let l_sin_φ1 = p.l * sin_φ1;
        let x_table = p.ε1 * t1.sqrt() + l_sin_φ1;
        let t2 = p.per_l * (x_table - l_sin_φ1);
        let s3 = -t2;
        let per_l_X1 = p.per_l * X1;
        let c3 = -per_l_X1;
        let t3 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `upper_left` from the assembled one
        let φ3_minus_φ3_0 = t3.unwrap_to(turn_upper_left);
        // angle of `upper_left`
        let φ3 = p.φ3_0 + φ3_minus_φ3_0;
        let half_φ3_0_plus_φ3 = (p.φ3_0 + φ3) * 0.5;
        let (sin_half_φ3_0_plus_φ3, cos_half_φ3_0_plus_φ3) = half_φ3_0_plus_φ3
            .sin_cos();
        let half_φ1_plus_φ1_0 = (φ1 + p.φ1_0) * 0.5;
        let (sin_half_φ1_plus_φ1_0, cos_half_φ1_plus_φ1_0) = half_φ1_plus_φ1_0
            .sin_cos();
        let φ1_0_minus_φ1 = p.φ1_0 - φ1;
        // change of Δx_piezo
        let δx_piezo = p.l
            * (sin_half_φ3_0_plus_φ3 * ((φ3 - p.φ3_0) * 0.5).sin() * 2.0)
            - p.l * (sin_half_φ1_plus_φ1_0 * (φ1_0_minus_φ1 * 0.5).sin() * 2.0);
        // from end to end of `piezo`
        let Δx_piezo = δx_piezo - p.constant1;
        let φ1_minus_φ1_0 = φ1 - p.φ1_0;
        // change of Δy_piezo
        let δy_piezo = p.l
            * (cos_half_φ3_0_plus_φ3 * ((p.φ3_0 - φ3) * 0.5).sin() * 2.0)
            - p.l * (cos_half_φ1_plus_φ1_0 * (φ1_minus_φ1_0 * 0.5).sin() * 2.0);
        // from end to end of `piezo`
        let Δy_piezo = δy_piezo - p.constant2;
        // length of `piezo`
        let L_piezo = (Δx_piezo * Δx_piezo + Δy_piezo * Δy_piezo).sqrt();
        let t4 = t2.recip();
        let t5 = sin_φ1 * t4;
        // rate of the angle of `upper_left` per unit rate of `lower_left`
        let ω3 = -t5;
        let dδx_piezo_dφ1 = l_sin_φ1 - p.l * (t2 * ω3);
        let t6 = Δx_piezo * dδx_piezo_dφ1
            - Δy_piezo * (A_x - p.l * (ω3 * per_l_X1));
        // lever of `piezo`: change of its length
        let dL_piezo_dφ1 = L_piezo.recip() * t6;
        let t7 = δx_piezo * (Δx_piezo - p.constant1)
            + δy_piezo * (Δy_piezo - p.constant2);
        // extension of `piezo`
        let e_piezo = t7 * (p.L_piezo_0 + L_piezo).recip();
        let ω3_squared = ω3 * ω3;
        let sin_φ1_minus_φ3 = sin_φ1 * c3 - cos_φ1 * s3;
        // rate of the position of `table` per unit rate of `lower_left`
        let ν_table = p.l * (t4 * sin_φ1_minus_φ3);
        let cos_φ1_minus_φ3 = cos_φ1 * c3 + sin_φ1 * s3;
        // inertia
        let A = p.C0 + p.C1 * ω3_squared + p.mo * (ν_table * ν_table)
            + p.C2 * (ω3 * cos_φ1_minus_φ3);
        let per_A = A.recip();
        let ω3_minus_one = ω3 - 1.0;
        // slope of the potential energy of springs
        let dP_s_dφ1 = p.two_k * φ1_minus_φ1_0 + p.two_k * (φ3_minus_φ3_0 * ω3)
            + p.two_k * (ω3_minus_one * (φ1_0_minus_φ1 + φ3_minus_φ3_0));
        let ddφ1_per_F_piezo = per_A * dL_piezo_dφ1;
        let t8 = -(p.two_c + p.two_c * ω3_squared)
            - p.two_c * (ω3_minus_one * (T::from_f64(-1.0) - t5));
        let ddφ1_per_dφ1 = per_A * t8;
        let ω3_prime = -(p.per_l * (t4 * (A_x + p.l * (ω3_squared * per_l_X1))));
        let t9 = t4
            * (p.l * (cos_φ1_minus_φ3 * ω3_minus_one) + ω3 * ν_table * per_l_X1);
        let ν_table_prime = -t9;
        let t10 = p.two_C1 * (ω3 * ω3_prime) + p.two_mo * (ν_table * ν_table_prime);
        // slope of the inertia
        let dA_dφ1 = t10 + p.C2 * (ω3_prime * cos_φ1_minus_φ3)
            + p.C2 * (sin_φ1_minus_φ3 * ω3 * ω3_minus_one);
        let ddφ1_per_dφ1_squared = per_A * -(dA_dφ1 * 0.5);
        [
            dL_piezo_dφ1,
            e_piezo,
            per_A * dP_s_dφ1,
            ddφ1_per_F_piezo,
            ddφ1_per_dφ1,
            ddφ1_per_dφ1_squared,
            φ3_minus_φ3_0,
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
        let φ1 = x[0];
        let dφ1 = x[1];
        let [dL_piezo_dφ1, e_piezo, per_A_dP_s_dφ1, ddφ1_per_F_piezo, ddφ1_per_dφ1,
        ddφ1_per_dφ1_squared, ..] = if p.table_of_φ1.covers(φ1) {
            p.table_of_φ1.polynomials(φ1)
        } else {
            p.table_of_φ1.where_covered(φ1, functions_of_φ1(φ1, d, p))
        };
        // ── state ──
        let t1 = (-per_A_dP_s_dφ1)
            .plus_product(ddφ1_per_dφ1, dφ1)
            .plus_product(ddφ1_per_dφ1_squared, dφ1 * dφ1);
        let t2 = p.constant3 * t;
        let (t3, t4) = t2.sin_cos();
        // drive `extension`
        let extension = p.stroke * t3;
        // rate of the drive `extension`
        let d_extension_dt = p.constant4 * t4;
        // force of `piezo` on its second end
        let F_piezo = (p.ks * (extension - e_piezo))
            .plus_product(p.cs, d_extension_dt.minus_product(dL_piezo_dφ1, dφ1));
        let ddφ1 = t1.plus_product(ddφ1_per_F_piezo, F_piezo);
        dx[0] = dφ1;
        dx[1] = ddφ1;
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
        let φ1 = x[0];
        let dφ1 = x[1];
        let turn_upper_left = d[0];
        // ── configuration ──
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let A_x = p.l * cos_φ1;
        // vector that is left to close lower_left–upper_left–table
        let X1 = -A_x;
        let l_sin_φ1 = p.l * sin_φ1;
        let x_table = p.ε1 * (p.l_squared - X1 * X1).sqrt() + l_sin_φ1;
        let t1 = p.per_l * (x_table - l_sin_φ1);
        let t2 = t1.recip();
        // rate of the angle of `upper_left` per unit rate of `lower_left`
        let ω3 = -(sin_φ1 * t2);
        let ω3_squared = ω3 * ω3;
        let per_l_X1 = p.per_l * X1;
        let c3 = -per_l_X1;
        let s3 = -t1;
        let sin_φ1_minus_φ3 = sin_φ1 * c3 - cos_φ1 * s3;
        // rate of the position of `table` per unit rate of `lower_left`
        let ν_table = p.l * (t2 * sin_φ1_minus_φ3);
        let cos_φ1_minus_φ3 = cos_φ1 * c3 + sin_φ1 * s3;
        let ω3_cos_φ1_minus_φ3 = ω3 * cos_φ1_minus_φ3;
        // inertia
        let A = p.C0 + p.C1 * ω3_squared + p.mo * (ν_table * ν_table)
            + p.C2 * ω3_cos_φ1_minus_φ3;
        let l_ω3_squared_per_l_X1 = p.l * (ω3_squared * per_l_X1);
        let t3 = A_x + l_ω3_squared_per_l_X1;
        let ω3_prime = -(p.per_l * (t2 * t3));
        let ω3_ω3_prime = ω3 * ω3_prime;
        let ω3_minus_one = ω3 - 1.0;
        let t4 = p.l * (cos_φ1_minus_φ3 * ω3_minus_one) + ω3 * ν_table * per_l_X1;
        let ν_table_prime = -(t2 * t4);
        let ω3_prime_cos_φ1_minus_φ3 = ω3_prime * cos_φ1_minus_φ3;
        let t5 = p.two_C1 * ω3_ω3_prime + p.two_mo * (ν_table * ν_table_prime)
            + p.C2 * ω3_prime_cos_φ1_minus_φ3;
        let sin_φ1_minus_φ3_ω3 = sin_φ1_minus_φ3 * ω3;
        // slope of the inertia
        let dA_dφ1 = t5 + p.C2 * (sin_φ1_minus_φ3_ω3 * ω3_minus_one);
        let φ1_minus_φ1_0 = φ1 - p.φ1_0;
        let t6 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `upper_left` from the assembled one
        let φ3_minus_φ3_0 = t6.unwrap_to(turn_upper_left);
        let φ1_0_minus_φ1 = p.φ1_0 - φ1;
        let t7 = φ1_0_minus_φ1 + φ3_minus_φ3_0;
        // slope of the potential energy of springs
        let dP_s_dφ1 = p.two_k * φ1_minus_φ1_0 + p.two_k * (φ3_minus_φ3_0 * ω3)
            + p.two_k * (ω3_minus_one * t7);
        // angle of `upper_left`
        let φ3 = p.φ3_0 + φ3_minus_φ3_0;
        let half_φ3_0_plus_φ3 = (p.φ3_0 + φ3) * 0.5;
        let (sin_half_φ3_0_plus_φ3, cos_half_φ3_0_plus_φ3) = half_φ3_0_plus_φ3
            .sin_cos();
        let half_φ1_plus_φ1_0 = (φ1 + p.φ1_0) * 0.5;
        let (sin_half_φ1_plus_φ1_0, cos_half_φ1_plus_φ1_0) = half_φ1_plus_φ1_0
            .sin_cos();
        // change of Δx_piezo
        let δx_piezo = p.l
            * (sin_half_φ3_0_plus_φ3 * ((φ3 - p.φ3_0) * 0.5).sin() * 2.0)
            - p.l * (sin_half_φ1_plus_φ1_0 * (φ1_0_minus_φ1 * 0.5).sin() * 2.0);
        // from end to end of `piezo`
        let Δx_piezo = δx_piezo - p.constant1;
        // change of Δy_piezo
        let δy_piezo = p.l
            * (cos_half_φ3_0_plus_φ3 * ((p.φ3_0 - φ3) * 0.5).sin() * 2.0)
            - p.l * (cos_half_φ1_plus_φ1_0 * (φ1_minus_φ1_0 * 0.5).sin() * 2.0);
        // from end to end of `piezo`
        let Δy_piezo = δy_piezo - p.constant2;
        // length of `piezo`
        let L_piezo = (Δx_piezo * Δx_piezo + Δy_piezo * Δy_piezo).sqrt();
        let per_L_piezo = L_piezo.recip();
        let dδx_piezo_dφ1 = l_sin_φ1 - p.l * (t1 * ω3);
        let Δx_piezo_dδx_piezo_dφ1 = Δx_piezo * dδx_piezo_dφ1;
        let ω3_per_l_X1 = ω3 * per_l_X1;
        let l_ω3_per_l_X1 = p.l * ω3_per_l_X1;
        let A_x_minus_l_ω3_per_l_X1 = A_x - l_ω3_per_l_X1;
        let t8 = Δx_piezo_dδx_piezo_dφ1 - Δy_piezo * A_x_minus_l_ω3_per_l_X1;
        // lever of `piezo`: change of its length
        let dL_piezo_dφ1 = per_L_piezo * t8;
        let t9 = Δx_piezo - p.constant1;
        let t10 = Δy_piezo - p.constant2;
        let t11 = δx_piezo * t9 + δy_piezo * t10;
        let L_piezo_0_plus_L_piezo = p.L_piezo_0 + L_piezo;
        let t12 = L_piezo_0_plus_L_piezo.recip();
        // extension of `piezo`
        let e_piezo = t11 * t12;
        let two_c_ω3_squared = p.two_c * ω3_squared;
        let ω3_minus_one_squared = ω3_minus_one * ω3_minus_one;
        let t13 = p.two_c * ω3_minus_one_squared;
        let per_A = A.recip();
        let t14 = p.two_k
            + (p.k * ω3_squared + p.k * (φ3_minus_φ3_0 * ω3_prime)) * 2.0;
        let ddP_s_dφ1_dφ1 = t14
            + (p.k * (ω3_prime * t7) + p.k * ω3_minus_one_squared) * 2.0;
        let t15 = dδx_piezo_dφ1 * dδx_piezo_dφ1
            + Δx_piezo * (A_x - l_ω3_squared_per_l_X1 - p.l * (t1 * ω3_prime));
        let dδy_piezo_dφ1 = l_ω3_per_l_X1 - A_x;
        let t16 = t1 * ω3_squared;
        let t17 = t15 - A_x_minus_l_ω3_per_l_X1 * dδy_piezo_dφ1
            + Δy_piezo * (l_sin_φ1 + p.l * (per_l_X1 * ω3_prime) - p.l * t16);
        let t18 = (Δx_piezo_dδx_piezo_dφ1 * 2.0 + Δy_piezo * dδy_piezo_dφ1 * 2.0)
            * 0.5;
        let dL_piezo_dφ1_2 = t18 / L_piezo;
        let ddL_piezo_dφ1_dφ1 = per_L_piezo * t17
            - (L_piezo * L_piezo).recip() * t8 * dL_piezo_dφ1_2;
        let t19 = t9 * dδx_piezo_dφ1 + δx_piezo * dδx_piezo_dφ1
            + t10 * dδy_piezo_dφ1;
        let t20 = t11 * (L_piezo_0_plus_L_piezo * L_piezo_0_plus_L_piezo).recip()
            * dL_piezo_dφ1_2;
        let de_piezo_dφ1 = t12 * (t19 + δy_piezo * dδy_piezo_dφ1) - t20;
        let t21 = (t1 * t1).recip() * ω3 * per_l_X1;
        let t22 = l_sin_φ1 - p.two_l * (ω3_per_l_X1 * ω3_prime)
            + p.l * (t1 * (ω3 * ω3_squared));
        let dω3_prime_dφ1 = p.per_l * (t21 * t3) + p.per_l * (t2 * t22);
        let t23 = p.l * (sin_φ1_minus_φ3 * ω3_minus_one_squared)
            + p.l * ω3_prime_cos_φ1_minus_φ3;
        let t24 = t23 + ν_table * per_l_X1 * ω3_prime + ω3_per_l_X1 * ν_table_prime;
        let dν_table_prime_dφ1 = t21 * t4 - t2 * (t24 - t16 * ν_table);
        let t25 = p.mo * (ν_table_prime * ν_table_prime)
            + p.mo * (ν_table * dν_table_prime_dφ1);
        let t26 = (p.C1 * (ω3_prime * ω3_prime) + p.C1 * (ω3 * dω3_prime_dφ1)) * 2.0
            + t25 * 2.0;
        let t27 = t26 + p.C2 * (cos_φ1_minus_φ3 * dω3_prime_dφ1)
            + p.two_C2 * (sin_φ1_minus_φ3 * ω3_prime * ω3_minus_one);
        let ddA_dφ1_dφ1 = t27 + p.C2 * (sin_φ1_minus_φ3_ω3 * ω3_prime)
            - p.C2 * (ω3_cos_φ1_minus_φ3 * ω3_minus_one_squared);
        let dF_piezo_ddφ1 = -(p.cs * dL_piezo_dφ1);
        let dτ_ddφ1 = dL_piezo_dφ1 * dF_piezo_ddφ1 - p.two_c - two_c_ω3_squared
            - t13;
        // ── state ──
        let t28 = p.constant3 * t;
        let (t29, t30) = t28.sin_cos();
        // drive `extension`
        let extension = p.stroke * t29;
        // rate of the drive `extension`
        let d_extension_dt = p.constant4 * t30;
        // force of `piezo` on its second end
        let F_piezo = p.ks * (extension - e_piezo)
            + p.cs * (d_extension_dt - dL_piezo_dφ1 * dφ1);
        let t31 = dL_piezo_dφ1 * F_piezo - p.two_c * dφ1 - two_c_ω3_squared * dφ1;
        // generalized torque of all other forces
        let τ = t31 - t13 * dφ1;
        let dφ1_squared = dφ1 * dφ1;
        let t32 = (A * A).recip() * dA_dφ1
            * (dP_s_dφ1 - τ + dA_dφ1 * 0.5 * dφ1_squared);
        let dF_piezo_dφ1 = -(p.ks * de_piezo_dφ1 + p.cs * ddL_piezo_dφ1_dφ1 * dφ1);
        let t33 = ddL_piezo_dφ1_dφ1 * F_piezo + dL_piezo_dφ1 * dF_piezo_dφ1
            - p._4_c * ω3_ω3_prime * dφ1;
        let dτ_dφ1 = t33 - p._4_c * (ω3_prime * ω3_minus_one) * dφ1;
        let dddφ1_dφ1 = t32
            - per_A * (ddP_s_dφ1_dφ1 - dτ_dφ1 + ddA_dφ1_dφ1 * 0.5 * dφ1_squared);
        let dddφ1_ddφ1 = per_A * (dτ_ddφ1 - dA_dφ1 * dφ1);
        result[1] = T::from_f64(1.0);
        result[2] = dddφ1_dφ1;
        result[3] = dddφ1_ddφ1;
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
        let φ1 = x[0];
        // ── configuration ──
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let A_x = p.l * cos_φ1;
        // vector that is left to close lower_left–upper_left–table
        let X1 = -A_x;
        let B_x = p.l * (p.per_l * X1);
        let x_table = p.ε1 * (p.l_squared - X1 * X1).sqrt() + p.l * sin_φ1;
        result[0] = B_x - A_x;
        result[1] = x_table;
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
        let φ1 = x[0];
        let dφ1 = x[1];
        let turn_upper_left = d[0];
        // ── configuration ──
        let (sin_φ1, cos_φ1) = φ1.sin_cos();
        let A_x = p.l * cos_φ1;
        // vector that is left to close lower_left–upper_left–table
        let X1 = -A_x;
        let l_sin_φ1 = p.l * sin_φ1;
        let x_table = p.ε1 * (p.l_squared - X1 * X1).sqrt() + l_sin_φ1;
        let t1 = p.per_l * (x_table - l_sin_φ1);
        let t2 = t1.recip();
        // rate of the angle of `upper_left` per unit rate of `lower_left`
        let ω3 = -(sin_φ1 * t2);
        let ω3_squared = ω3 * ω3;
        let per_l_X1 = p.per_l * X1;
        let c3 = -per_l_X1;
        let s3 = -t1;
        let sin_φ1_minus_φ3 = sin_φ1 * c3 - cos_φ1 * s3;
        // rate of the position of `table` per unit rate of `lower_left`
        let ν_table = p.l * (t2 * sin_φ1_minus_φ3);
        let cos_φ1_minus_φ3 = cos_φ1 * c3 + sin_φ1 * s3;
        // inertia
        let A = p.C0 + p.C1 * ω3_squared + p.mo * (ν_table * ν_table)
            + p.C2 * (ω3 * cos_φ1_minus_φ3);
        let φ1_minus_φ1_0 = φ1 - p.φ1_0;
        let t3 = (p.c3_0 * s3 - p.s3_0 * c3).atan2(p.c3_0 * c3 + p.s3_0 * s3);
        // angle of `upper_left` from the assembled one
        let φ3_minus_φ3_0 = t3.unwrap_to(turn_upper_left);
        let t4 = p.k * (φ1_minus_φ1_0 * φ1_minus_φ1_0)
            + p.k * (φ3_minus_φ3_0 * φ3_minus_φ3_0);
        let φ1_0_minus_φ1 = p.φ1_0 - φ1;
        let t5 = φ1_0_minus_φ1 + φ3_minus_φ3_0;
        let t6 = φ1_minus_φ1_0 - φ3_minus_φ3_0;
        // angle of `upper_left`
        let φ3 = p.φ3_0 + φ3_minus_φ3_0;
        let half_φ3_0_plus_φ3 = (p.φ3_0 + φ3) * 0.5;
        let (sin_half_φ3_0_plus_φ3, cos_half_φ3_0_plus_φ3) = half_φ3_0_plus_φ3
            .sin_cos();
        let half_φ1_plus_φ1_0 = (φ1 + p.φ1_0) * 0.5;
        let (sin_half_φ1_plus_φ1_0, cos_half_φ1_plus_φ1_0) = half_φ1_plus_φ1_0
            .sin_cos();
        // change of Δx_piezo
        let δx_piezo = p.l
            * (sin_half_φ3_0_plus_φ3 * ((φ3 - p.φ3_0) * 0.5).sin() * 2.0)
            - p.l * (sin_half_φ1_plus_φ1_0 * (φ1_0_minus_φ1 * 0.5).sin() * 2.0);
        // from end to end of `piezo`
        let Δx_piezo = δx_piezo - p.constant1;
        // change of Δy_piezo
        let δy_piezo = p.l
            * (cos_half_φ3_0_plus_φ3 * ((p.φ3_0 - φ3) * 0.5).sin() * 2.0)
            - p.l * (cos_half_φ1_plus_φ1_0 * (φ1_minus_φ1_0 * 0.5).sin() * 2.0);
        // from end to end of `piezo`
        let Δy_piezo = δy_piezo - p.constant2;
        let t7 = δx_piezo * (Δx_piezo - p.constant1)
            + δy_piezo * (Δy_piezo - p.constant2);
        // length of `piezo`
        let L_piezo = (Δx_piezo * Δx_piezo + Δy_piezo * Δy_piezo).sqrt();
        // extension of `piezo`
        let e_piezo = t7 * (p.L_piezo_0 + L_piezo).recip();
        let ω3_minus_one = ω3 - 1.0;
        let dδx_piezo_dφ1 = l_sin_φ1 - p.l * (t1 * ω3);
        let t8 = Δx_piezo * dδx_piezo_dφ1
            - Δy_piezo * (A_x - p.l * (ω3 * per_l_X1));
        // lever of `piezo`: change of its length
        let dL_piezo_dφ1 = L_piezo.recip() * t8;
        // ── state ──
        let dφ1_squared = dφ1 * dφ1;
        let t9 = p.constant3 * t;
        let (t10, t11) = t9.sin_cos();
        // drive `extension`
        let extension = p.stroke * t10;
        let e_piezo_minus_extension = e_piezo - extension;
        let t12 = t4 + p.half_k * (t5 * t5) + p.half_k * (t6 * t6)
            + p.half_ks * (e_piezo_minus_extension * e_piezo_minus_extension);
        let t13 = p.two_c * dφ1_squared + p.two_c * ω3_squared * dφ1_squared
            + p.two_c * (ω3_minus_one * ω3_minus_one) * dφ1_squared;
        let dL_piezo_dφ1_dφ1 = dL_piezo_dφ1 * dφ1;
        // rate of the drive `extension`
        let d_extension_dt = p.constant4 * t11;
        let t14 = dL_piezo_dφ1_dφ1 - d_extension_dt;
        // force of `piezo` on its second end
        let F_piezo = p.ks * (extension - e_piezo)
            + p.cs * (d_extension_dt - dL_piezo_dφ1_dφ1);
        result[0] = A * 0.5 * dφ1_squared;
        result[1] = t12;
        result[2] = t13 + p.cs * (t14 * t14);
        result[3] = d_extension_dt * F_piezo;
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
        d: &[T; 1],
        u: &[T; 0],
        p: &Prepared<T>,
        result: &mut [T; 1],
    ) {
        let φ1 = x[0];
        let [.., φ3_minus_φ3_0, _] = if p.table_of_φ1.covers(φ1) {
            p.table_of_φ1.polynomials(φ1)
        } else {
            p.table_of_φ1.where_covered(φ1, functions_of_φ1(φ1, d, p))
        };
        result[0] = φ3_minus_φ3_0;
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
            const NAMES: [&str; 1] = ["lower_left–upper_left–table"];
            NAMES[index]
        }
        fn tables(&self) -> Vec<TableReport> {
            [self.table_of_φ1.report(0)].into_iter().flatten().collect()
        }
        fn is_outside_tables(&self, x: &[f64]) -> bool {
            self.table_of_φ1.is_left_by(x[0])
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
            L::from_f64(-1.0).larger(lanes.table_of_φ1.left_by(x[0]))
        }
    }
    /// Every quantity with a name: params, states, discrete states, inputs, outputs.
    pub static VARIABLES: [Variable; 16] = [
        Variable {
            name: Cow::Borrowed("l"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("length of an arm between its hinges"),
            causality: Causality::Parameter,
            start: Some(0.02),
        },
        Variable {
            name: Cow::Borrowed("rise"),
            unit: Cow::Borrowed("1"),
            meaning: Cow::Borrowed("inclination of the arms"),
            causality: Causality::Parameter,
            start: Some(0.13962634015954636),
        },
        Variable {
            name: Cow::Borrowed("ma"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of an arm, of a block, of the output"),
            causality: Causality::Parameter,
            start: Some(0.0008),
        },
        Variable {
            name: Cow::Borrowed("mb"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of an arm, of a block, of the output"),
            causality: Causality::Parameter,
            start: Some(0.004),
        },
        Variable {
            name: Cow::Borrowed("mo"),
            unit: Cow::Borrowed("kg"),
            meaning: Cow::Borrowed("mass of an arm, of a block, of the output"),
            causality: Causality::Parameter,
            start: Some(0.012),
        },
        Variable {
            name: Cow::Borrowed("k"),
            unit: Cow::Borrowed("N*m"),
            meaning: Cow::Borrowed("stiffness of a hinge"),
            causality: Causality::Parameter,
            start: Some(1.5),
        },
        Variable {
            name: Cow::Borrowed("c"),
            unit: Cow::Borrowed("N*m*s"),
            meaning: Cow::Borrowed("damping of a hinge"),
            causality: Causality::Parameter,
            start: Some(2e-5),
        },
        Variable {
            name: Cow::Borrowed("ks"),
            unit: Cow::Borrowed("N/m"),
            meaning: Cow::Borrowed("piezo stack"),
            causality: Causality::Parameter,
            start: Some(2e7),
        },
        Variable {
            name: Cow::Borrowed("cs"),
            unit: Cow::Borrowed("N*s/m"),
            meaning: Cow::Borrowed("piezo stack"),
            causality: Causality::Parameter,
            start: Some(60.0),
        },
        Variable {
            name: Cow::Borrowed("stroke"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("its free extension"),
            causality: Causality::Parameter,
            start: Some(1e-5),
        },
        Variable {
            name: Cow::Borrowed("f"),
            unit: Cow::Borrowed("1/s"),
            meaning: Cow::Borrowed("its free extension"),
            causality: Causality::Parameter,
            start: Some(200.0),
        },
        Variable {
            name: Cow::Borrowed("lower_left.angle"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed("angle of `lower_left`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("lower_left.rate"),
            unit: Cow::Borrowed("rad/s"),
            meaning: Cow::Borrowed("angular rate of `lower_left`"),
            causality: Causality::State,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("upper_left.turn"),
            unit: Cow::Borrowed("rad"),
            meaning: Cow::Borrowed(
                "angle of `upper_left` from the assembled one at the last accepted step",
            ),
            causality: Causality::Discrete,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("stretch"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("distance of the blocks"),
            causality: Causality::Output,
            start: None,
        },
        Variable {
            name: Cow::Borrowed("position"),
            unit: Cow::Borrowed("m"),
            meaning: Cow::Borrowed("position of the output"),
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
    static FAILURES: [Failure; 9] = [
        Failure {
            message: Cow::Borrowed("the length of `lower_left` is {0}"),
            hint: Some(Cow::Borrowed("it must be above zero")),
            site: Some(Site {
                file: Cow::Borrowed("bridge_amplifier.flex"),
                line: 18,
                column: 6,
                width: 10,
                excerpt: Cow::Borrowed(
                    "link lower_left  from O to A { length = l, angle = 180 deg - rise, mass = ma, mass at A = mb, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `lower_left` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("bridge_amplifier.flex"),
                line: 18,
                column: 68,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link lower_left  from O to A { length = l, angle = 180 deg - rise, mass = ma, mass at A = mb, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the moment of inertia of `lower_left` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("bridge_amplifier.flex"),
                line: 18,
                column: 68,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link lower_left  from O to A { length = l, angle = 180 deg - rise, mass = ma, mass at A = mb, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg*m^2")]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `lower_left` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("bridge_amplifier.flex"),
                line: 18,
                column: 79,
                width: 4,
                excerpt: Cow::Borrowed(
                    "link lower_left  from O to A { length = l, angle = 180 deg - rise, mass = ma, mass at A = mb, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed("the mass of `table` is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("bridge_amplifier.flex"),
                line: 23,
                column: 49,
                width: 4,
                excerpt: Cow::Borrowed(
                    "slide table along (0, 1) through (0 mm, 0 mm) { mass = mo, at = 2 * height }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("kg")]),
        },
        Failure {
            message: Cow::Borrowed(
                "the loop lower_left–upper_left–table cannot close: at `lower_left` angle {1} the gap is {0}",
            ),
            hint: Some(
                Cow::Borrowed("change a length, an angle or the place of a guide"),
            ),
            site: Some(Site {
                file: Cow::Borrowed("bridge_amplifier.flex"),
                line: 20,
                column: 6,
                width: 10,
                excerpt: Cow::Borrowed(
                    "link upper_left  from P to A { length = l, angle = 180 deg + rise, mass = ma, symbol = φ3 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Degree]),
        },
        Failure {
            message: Cow::Borrowed(
                "the loop lower_left–upper_left–table stands at a dead point: at `lower_left` angle {1} `upper_left` stands square to the guide of `table`",
            ),
            hint: Some(
                Cow::Borrowed(
                    "assemble it in another configuration: change an angle or a length; or ask for the coordinate `upper_left.angle`, if that leads it through",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("bridge_amplifier.flex"),
                line: 20,
                column: 6,
                width: 10,
                excerpt: Cow::Borrowed(
                    "link upper_left  from P to A { length = l, angle = 180 deg + rise, mass = ma, symbol = φ3 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Metre, Unit::Degree]),
        },
        Failure {
            message: Cow::Borrowed("the frequency is {0}"),
            hint: Some(Cow::Borrowed("it must not be below zero")),
            site: Some(Site {
                file: Cow::Borrowed("bridge_amplifier.flex"),
                line: 14,
                column: 7,
                width: 9,
                excerpt: Cow::Borrowed("drive extension = sine(stroke, frequency = f)"),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[Unit::Other("Hz")]),
        },
        Failure {
            message: Cow::Borrowed("`lower_left` can move but has no mass"),
            hint: Some(
                Cow::Borrowed(
                    "give it a mass above zero, or join it to a body that has one",
                ),
            ),
            site: Some(Site {
                file: Cow::Borrowed("bridge_amplifier.flex"),
                line: 18,
                column: 6,
                width: 10,
                excerpt: Cow::Borrowed(
                    "link lower_left  from O to A { length = l, angle = 180 deg - rise, mass = ma, mass at A = mb, symbol = φ1 }",
                ),
            }),
            related: Cow::Borrowed(&[]),
            units: Cow::Borrowed(&[]),
        },
    ];
    /// The equations of motion in plain text.
    pub const EQUATIONS: &str = r#"bridge_amplifier
════════════════

A bridge-type amplifier: a piezo stack spreads two blocks, and four inclined arms turn their
motion into a larger one of the output across it.

Loop lower_left–upper_left–table
────────────────────────────────

  l e^(i φ1) - l e^(i φ3) - i x_table = 0

  X1      = -l cos(φ1)
  Y1      = -l sin(φ1)
  x_table = ε1 sqrt(l² - X1²) - Y1
  c3      = -X1/l
  s3      = -(x_table + Y1) / l

  φ3 = atan2(s3, c3), continuous over many turns; ⁰: as assembled
  ω3 = dφ3/dφ1, ν_table = dx_table/dφ1, ' = d/dφ1

  ω3       = sin(φ1)/sin(φ3)
  ν_table  = l sin(φ3 - φ1) / sin(φ3)
  ω3'      = (l cos(φ1) - l ω3² cos(φ3)) / (l sin(φ3))
  ν_table' = (l (ω3 - 1) cos(φ1 - φ3) - ω3 ν_table cos(φ3)) / sin(φ3)

Parallelogram lower_right–upper_right–upper_left–lower_left
───────────────────────────────────────────────────────────

  l e^(i φ2) - l e^(i φ4) + l e^(i φ3) - l e^(i φ1) = 0
  φ2 = φ3 + π (opposite sides are equal)
  φ4 = φ1 + π (opposite sides are equal)

Drives
──────

  extension(t) = sine(stroke, frequency = f)

Constants of the inertia
────────────────────────

  C0 = ma l² + I1 + I4 + ma r1² + mb l² + ma (r4 - l)²
  C1 = ma l² + I2 + I3 + mb l² + ma r2² + ma (r3 - l)²
  C2 = 2 l ma (r3 - l) + 2 l ma (r4 - l)

Named forces
────────────

  δx_piezo     = l (cos(φ1⁰) - cos(φ1)) + l (cos(φ3⁰) - cos(φ3))
  Δx_piezo     = δx_piezo + Δx_piezo⁰
  δy_piezo     = l (sin(φ1⁰) - sin(φ1)) + l (sin(φ3⁰) - sin(φ3))
  Δy_piezo     = δy_piezo + Δy_piezo⁰
  L_piezo      = sqrt(Δx_piezo² + Δy_piezo²)
  e_piezo      = (δx_piezo (Δx_piezo + Δx_piezo⁰) + δy_piezo (Δy_piezo + Δy_piezo⁰))
                   / (L_piezo + L_piezo⁰)
                 extension: the length less that as assembled, without cancellation
  ∂L_piezo/∂φ1 = (Δx_piezo (l sin(φ1) + l ω3 sin(φ3)) - Δy_piezo (l cos(φ1) + l ω3 cos(φ3)))
                   / L_piezo
  F_piezo      = ks (extension - e_piezo) + cs (d(extension)/dt - φ̇1 ∂L_piezo/∂φ1)

Equation of motion of `lower_left`
──────────────────────────────────

  A(φ1)    = C0 + C1 ω3² + mo ν_table² + C2 ω3 cos(φ1 - φ3)
  ∂A/∂φ1   = 2 C1 ω3 ω3'
           + 2 mo ν_table ν_table'
           + C2 ω3' cos(φ1 - φ3)
           + C2 ω3 (ω3 - 1) sin(φ1 - φ3)
  ∂P_s/∂φ1 = 2 k (φ1 - φ1⁰) + 2 k ω3 (φ3 - φ3⁰) + 2 k (ω3 - 1) (φ3 - φ3⁰ - φ1 + φ1⁰)
  τ        = ∂L_piezo/∂φ1 F_piezo - 2 c φ̇1 - 2 c φ̇1 ω3² - 2 c φ̇1 (ω3 - 1)²

  A(φ1) φ̈1 + ½ ∂A/∂φ1 φ̇1² + ∂P_s/∂φ1 = τ

Constants
─────────

  height    = l sin(rise)
  r1        = ½ l          distance of the centre of mass from the first end of lower_left
  I1        = 1/12 ma l²   moment of inertia about the centre of mass of lower_left
  r2        = ½ l          distance of the centre of mass from the first end of lower_right
  I2        = 1/12 ma l²   moment of inertia about the centre of mass of lower_right
  r3        = ½ l          distance of the centre of mass from the first end of upper_left
  I3        = 1/12 ma l²   moment of inertia about the centre of mass of upper_left
  r4        = ½ l          distance of the centre of mass from the first end of upper_right
  I4        = 1/12 ma l²   moment of inertia about the centre of mass of upper_right
  φ1⁰       = π - rise     angle of `lower_left` as assembled
  ε1        = sign(2 height - l sin(π + rise) + Y1⁰)
              which way the loop closes: as drawn
  Δx_piezo⁰ = -l cos(φ1⁰) - l cos(φ3⁰)
  Δy_piezo⁰ = -l sin(φ1⁰) - l sin(φ3⁰)
  L_piezo⁰  = sqrt((Δx_piezo⁰)² + (Δy_piezo⁰)²)
              length of `piezo` as assembled

  φ3⁰, Y1⁰: by the formulas of the loops, at φ1 = φ1⁰
"#;
    /// The equations of motion as a LaTeX document.
    pub const EQUATIONS_LATEX: &str = r#"\documentclass[a4paper]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{amsmath}
\usepackage[margin=2cm]{geometry}
\allowdisplaybreaks
\begin{document}

\section*{bridge\_amplifier}
A bridge-type amplifier: a piezo stack spreads two blocks, and four inclined arms turn their
motion into a larger one of the output across it.

\subsection*{Loop lower\_left–upper\_left–table}
\begin{align*}
& l\, e^{i \varphi_{1}} - l\, e^{i \varphi_{3}} - i\,x_{\mathrm{table}} = 0 \\
X_{1} &= -l \cos \varphi_{1} \\
Y_{1} &= -l \sin \varphi_{1} \\
x_{\mathrm{table}} &= \varepsilon_{1} \, \sqrt{l^{2} - X_{1}^{2}} - Y_{1} \\
\cos \varphi_{3} &= -\frac{X_{1}}{l} \\
\sin \varphi_{3} &= -\frac{x_{\mathrm{table}} + Y_{1}}{l} \\
& \varphi_{3} = \operatorname{atan2}(\sin \varphi_{3}, \cos \varphi_{3}) \quad\text{(continuous over many turns; ${}^0$: as assembled)} \\
& \omega_{3} = \frac{\mathrm d\varphi_{3}}{\mathrm d\varphi_{1}},\quad \nu_{\mathrm{table}} = \frac{\mathrm dx_{\mathrm{table}}}{\mathrm d\varphi_{1}},\quad {}' = \frac{\mathrm d}{\mathrm d\varphi_{1}} \\
\omega_{3} &= \frac{\sin \varphi_{1}}{\sin \varphi_{3}} \\
\nu_{\mathrm{table}} &= \frac{l \sin\left(\varphi_{3} - \varphi_{1}\right)}{\sin \varphi_{3}} \\
\omega'_{3} &= \frac{l \cos \varphi_{1} - l \, \omega_{3}^{2} \cos \varphi_{3}}{l \sin \varphi_{3}} \\
\nu'_{\mathrm{table}} &= \frac{l \left(\omega_{3} - 1\right) \cos\left(\varphi_{1} - \varphi_{3}\right) - \omega_{3} \, \nu_{\mathrm{table}} \cos \varphi_{3}}{\sin \varphi_{3}}
\end{align*}

\subsection*{Parallelogram lower\_right–upper\_right–upper\_left–lower\_left}
\begin{align*}
& l\, e^{i \varphi_{2}} - l\, e^{i \varphi_{4}} + l\, e^{i \varphi_{3}} - l\, e^{i \varphi_{1}} = 0 \\
& \varphi_{2} = \varphi_{3} + \pi \quad\text{(opposite sides are equal)} \\
& \varphi_{4} = \varphi_{1} + \pi \quad\text{(opposite sides are equal)}
\end{align*}

\subsection*{Drives}
\begin{align*}
& \mathit{extension}(t) = \text{sine(stroke, frequency = f)}
\end{align*}

\subsection*{Constants of the inertia}
\begin{align*}
C_{0} &= \mathit{ma} \, l^{2} + I_{1} + I_{4} + \mathit{ma} \, r_{1}^{2} + \mathit{mb} \, l^{2} + \mathit{ma} \left(r_{4} - l\right)^{2} \\
C_{1} &= \mathit{ma} \, l^{2} + I_{2} + I_{3} + \mathit{mb} \, l^{2} + \mathit{ma} \, r_{2}^{2} + \mathit{ma} \left(r_{3} - l\right)^{2} \\
C_{2} &= 2 \, l \, \mathit{ma} \left(r_{3} - l\right) + 2 \, l \, \mathit{ma} \left(r_{4} - l\right)
\end{align*}

\subsection*{Named forces}
\begin{align*}
\delta x_{\mathrm{piezo}} &= l \left(\cos \varphi_{1}^0 - \cos \varphi_{1}\right) + l \left(\cos \varphi_{3}^0 - \cos \varphi_{3}\right) \\
\Delta x_{\mathrm{piezo}} &= \delta x_{\mathrm{piezo}} + \Delta x_{\mathrm{piezo}}^{0} \\
\delta y_{\mathrm{piezo}} &= l \left(\sin \varphi_{1}^0 - \sin \varphi_{1}\right) + l \left(\sin \varphi_{3}^0 - \sin \varphi_{3}\right) \\
\Delta y_{\mathrm{piezo}} &= \delta y_{\mathrm{piezo}} + \Delta y_{\mathrm{piezo}}^{0} \\
L_{\mathrm{piezo}} &= \sqrt{\Delta x_{\mathrm{piezo}}^{2} + \Delta y_{\mathrm{piezo}}^{2}} \\
e_{\mathrm{piezo}} &= \frac{\delta x_{\mathrm{piezo}} \left(\Delta x_{\mathrm{piezo}} + \Delta x_{\mathrm{piezo}}^{0}\right) + \delta y_{\mathrm{piezo}} \left(\Delta y_{\mathrm{piezo}} + \Delta y_{\mathrm{piezo}}^{0}\right)}{L_{\mathrm{piezo}} + L_{\mathrm{piezo}}^{0}} && \text{extension: the length less that as assembled, without cancellation} \\
\frac{\partial L_{\mathrm{piezo}}}{\partial \varphi_{1}} &= \frac{\Delta x_{\mathrm{piezo}} \left(l \sin \varphi_{1} + l \, \omega_{3} \sin \varphi_{3}\right) - \Delta y_{\mathrm{piezo}} \left(l \cos \varphi_{1} + l \, \omega_{3} \cos \varphi_{3}\right)}{L_{\mathrm{piezo}}} \\
F_{\mathrm{piezo}} &= \mathit{ks} \left(\mathit{extension} - e_{\mathrm{piezo}}\right) + \mathit{cs} \left(\dot{\mathit{extension}} - \dot{\varphi}_{1} \, \frac{\partial L_{\mathrm{piezo}}}{\partial \varphi_{1}}\right)
\end{align*}

\subsection*{Equation of motion of \texttt{lower\_left}}
\begin{align*}
A(\varphi_{1}) &= C_{0} + C_{1} \, \omega_{3}^{2} + \mathit{mo} \, \nu_{\mathrm{table}}^{2} + C_{2} \, \omega_{3} \cos\left(\varphi_{1} - \varphi_{3}\right) \\
\frac{\partial A}{\partial \varphi_{1}} &= 2 \, C_{1} \, \omega_{3} \, \omega'_{3} \\
&\quad {}+ 2 \, \mathit{mo} \, \nu_{\mathrm{table}} \, \nu'_{\mathrm{table}} \\
&\quad {}+ C_{2} \, \omega'_{3} \cos\left(\varphi_{1} - \varphi_{3}\right) \\
&\quad {}+ C_{2} \, \omega_{3} \left(\omega_{3} - 1\right) \sin\left(\varphi_{1} - \varphi_{3}\right) \\
\frac{\partial P_s}{\partial \varphi_{1}} &= 2 \, k \left(\varphi_{1} - \varphi_{1}^0\right) \\
&\quad {}+ 2 \, k \, \omega_{3} \left(\varphi_{3} - \varphi_{3}^0\right) \\
&\quad {}+ 2 \, k \left(\omega_{3} - 1\right) \left(\varphi_{3} - \varphi_{3}^0 - \varphi_{1} + \varphi_{1}^0\right) \\
\tau &= \frac{\partial L_{\mathrm{piezo}}}{\partial \varphi_{1}} \, F_{\mathrm{piezo}} - 2 \, c \, \dot{\varphi}_{1} - 2 \, c \, \dot{\varphi}_{1} \, \omega_{3}^{2} - 2 \, c \, \dot{\varphi}_{1} \left(\omega_{3} - 1\right)^{2} \\
& A(\varphi_{1})\,\ddot{\varphi}_{1} + \tfrac12 \frac{\partial A}{\partial \varphi_{1}}\,\dot{\varphi}_{1}^2 + \frac{\partial P_s}{\partial \varphi_{1}} = \tau
\end{align*}

\subsection*{Constants}
\begin{align*}
\mathit{height} &= l \sin \mathit{rise} \\
r_{1} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of lower\_left} \\
I_{1} &= \frac{1}{12} \, \mathit{ma} \, l^{2} && \text{moment of inertia about the centre of mass of lower\_left} \\
r_{2} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of lower\_right} \\
I_{2} &= \frac{1}{12} \, \mathit{ma} \, l^{2} && \text{moment of inertia about the centre of mass of lower\_right} \\
r_{3} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upper\_left} \\
I_{3} &= \frac{1}{12} \, \mathit{ma} \, l^{2} && \text{moment of inertia about the centre of mass of upper\_left} \\
r_{4} &= \frac{1}{2} \, l && \text{distance of the centre of mass from the first end of upper\_right} \\
I_{4} &= \frac{1}{12} \, \mathit{ma} \, l^{2} && \text{moment of inertia about the centre of mass of upper\_right} \\
\varphi_{1}^0 &= \pi - \mathit{rise} && \text{angle of \texttt{lower\_left} as assembled} \\
\varepsilon_{1} &= \operatorname{sgn}\left(2 \, \mathit{height} - l \sin\left(\pi + \mathit{rise}\right) + {Y_{1}}^0\right) && \text{which way the loop closes: as drawn} \\
\Delta x_{\mathrm{piezo}}^{0} &= -l \cos \varphi_{1}^0 - l \cos \varphi_{3}^0 \\
\Delta y_{\mathrm{piezo}}^{0} &= -l \sin \varphi_{1}^0 - l \sin \varphi_{3}^0 \\
L_{\mathrm{piezo}}^{0} &= \sqrt{\left(\Delta x_{\mathrm{piezo}}^{0}\right)^{2} + \left(\Delta y_{\mathrm{piezo}}^{0}\right)^{2}} && \text{length of \texttt{piezo} as assembled} \\
& \varphi_{3}^0,\, {Y_{1}}^0: \text{ by the formulas of the loops, at } \varphi_{1} = \varphi_{1}^0
\end{align*}

\end{document}
"#;
}
