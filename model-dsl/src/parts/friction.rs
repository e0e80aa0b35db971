//! Friction laws as data: internal states with rates, named quantities, force and stored energy.

use crate::model::{Condition, Friction, FrictionState, NormalForce};
use crate::notation::latex_of;
use crate::symbolic::{Expr, Function, Graph, Symbol};
use crate::units::Dimension;

/// Parameters of the LuGre law, of params.
#[derive(Clone, Copy, Debug)]
pub struct LugreParameters {
    /// Bristle stiffness σ0 in N/m.
    pub sigma0: Expr,
    /// Bristle damping σ1 in N·s/m.
    pub sigma1: Expr,
    /// Viscous friction σ2 in N·s/m.
    pub sigma2: Expr,
    /// Coefficient of static friction μ_S.
    pub mu_s: Expr,
    /// Coefficient of sliding (Coulomb) friction μ_C.
    pub mu_c: Expr,
    /// Stribeck velocity v_S in m/s.
    pub v_s: Expr,
}

/// The LuGre law (Canudas de Wit et al. 1995) for a contact under a given normal force:
///
/// ```text
/// F_S = μ_S F_N     F_C = μ_C F_N     g(v) = (F_C + (F_S - F_C) exp(-(v/v_S)²)) / σ0
/// ż = v - |v| z / g(v)                F = σ0 z + σ1 ż + σ2 v
/// ```
///
/// Where the normal force varies, g is taken at a reference force F_ref (the preload, or
/// `reference` where one is given) and the force scales with the load,
/// F = (F_N/F_ref)(σ0 z + σ1 ż + σ2 v): equal to the former at F_N = F_ref, and finite when the
/// contact lifts off.
///
/// `name` qualifies the symbols (`z_tip`); leave it empty where a model has only one contact.
pub fn lugre(
    g: &mut Graph,
    name: &str,
    parameters: LugreParameters,
    normal_force: &NormalForce,
    reference: Option<Expr>,
) -> Friction {
    let LugreParameters {
        sigma0,
        sigma1,
        sigma2,
        mu_s,
        mu_c,
        v_s,
    } = parameters;
    let slip = named(g, "v", "v", name);
    let normal = named(g, "F_N", "F_N", name);
    let (v, f_n) = (g.of(slip), g.of(normal));
    let (load, scale, load_name) = match normal_force {
        NormalForce::Constant(_) => (f_n, None, "preload"),
        NormalForce::Compliant { preload, .. } => {
            let reference_force = reference.unwrap_or(*preload);
            let words = if reference.is_some() {
                "reference force"
            } else {
                "preload"
            };
            (reference_force, Some(g.div(f_n, reference_force)), words)
        }
    };

    let static_friction = named(g, "F_S", "F_S", name);
    let static_value = g.mul(mu_s, load);
    let sliding_friction = named(g, "F_C", "F_C", name);
    let sliding_value = g.mul(mu_c, load);
    let (f_s, f_c) = (g.of(static_friction), g.of(sliding_friction));
    let deflection_limit = if name.is_empty() {
        g.symbol("g(v)", "g(v)")
    } else {
        let subscript = subscript(name);
        g.symbol(
            format!("g_{name}(v_{name})"),
            format!("g_{{{subscript}}}(v_{{{subscript}}})"),
        )
    };
    let limit_value = {
        let ratio = g.div(v, v_s);
        let square = g.powi(ratio, 2);
        let exponent = g.neg(square);
        let decay = g.function(Function::Exp, &[exponent]);
        let excess = g.sub(f_s, f_c);
        let stribeck = g.mul(excess, decay);
        let level = g.add(f_c, stribeck);
        g.div(level, sigma0)
    };
    let bristle = named(g, "z", "z", name);
    let bristle_rate = named(g, "ż", r"\dot{z}", name);
    let z = g.of(bristle);
    let rate_value = {
        let speed = g.function(Function::Abs, &[v]);
        let limit = g.of(deflection_limit);
        let pulled = g.product(&[speed, z]);
        let relaxation = g.div(pulled, limit);
        g.sub(v, relaxation)
    };

    let z_rate = g.of(bristle_rate);
    let force = {
        let terms = [g.mul(sigma0, z), g.mul(sigma1, z_rate), g.mul(sigma2, v)];
        let force = g.sum(&terms);
        scale.map_or(force, |scale| g.mul(scale, force))
    };
    let energy = {
        let half = g.ratio(1, 2);
        let square = g.powi(z, 2);
        let energy = g.product(&[half, sigma0, square]);
        scale.map_or(energy, |scale| g.mul(scale, energy))
    };

    let mut conditions = vec![
        Condition::above_zero(sigma0, "the bristle stiffness `sigma0`").in_unit("N/m"),
        Condition::not_below_zero(sigma1, "the bristle damping `sigma1`").in_unit("N*s/m"),
        Condition::not_below_zero(sigma2, "the viscous friction `sigma2`").in_unit("N*s/m"),
        Condition::above_zero(mu_s, "the static friction coefficient `mu_s`"),
        Condition::above_zero(mu_c, "the sliding friction coefficient `mu_c`"),
        Condition::above_zero(v_s, "the Stribeck velocity `v_s`").in_unit("m/s"),
    ];
    let load = match normal_force {
        NormalForce::Constant(preload) => *preload,
        NormalForce::Compliant { .. } => load,
    };
    conditions.push(Condition::above_zero(load, &format!("the {load_name}")).in_unit("N"));

    Friction {
        law: "lugre".to_owned(),
        slip,
        normal,
        states: vec![FrictionState {
            name: "z".to_owned(),
            symbol: bristle,
            rate: z_rate,
            dimension: Dimension::LENGTH,
            meaning: "bristle deflection".to_owned(),
        }],
        definitions: vec![
            (static_friction, static_value),
            (sliding_friction, sliding_value),
            (deflection_limit, limit_value),
            (bristle_rate, rate_value),
        ],
        force,
        energy,
        holds: g.mul(mu_s, f_n),
        conditions,
    }
}

/// A symbol of a contact: `F_N`, or `F_N,tip` where a name is given.
fn named(g: &mut Graph, text: &str, latex: &str, name: &str) -> Symbol {
    if name.is_empty() {
        return g.symbol(text, latex);
    }
    let subscript = subscript(name);
    match (text.split_once('_'), latex.split_once('_')) {
        (Some((base, index)), Some((latex_base, latex_index))) => g.symbol(
            format!("{base}_{index},{name}"),
            format!("{latex_base}_{{{latex_index},{subscript}}}"),
        ),
        _ => g.symbol(format!("{text}_{name}"), format!("{latex}_{{{subscript}}}")),
    }
}

/// A contact's name as an upright subscript.
fn subscript(name: &str) -> String {
    latex_of(name).replace(r"\mathit", r"\mathrm")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::symbolic::Evaluator;

    struct Values {
        rate: f64,
        force: f64,
        energy: f64,
    }

    fn number(g: &mut Graph, tenths: i64) -> Expr {
        g.ratio(tenths, 10)
    }

    /// σ0 = 5e6, σ1 = 5, σ2 = 0.5, μ_S = 0.3, μ_C = 0.2, v_S = 1e-3.
    fn parameters(g: &mut Graph) -> LugreParameters {
        LugreParameters {
            sigma0: g.integer(5_000_000),
            sigma1: g.integer(5),
            sigma2: number(g, 5),
            mu_s: number(g, 3),
            mu_c: number(g, 2),
            v_s: g.ratio(1, 1000),
        }
    }

    fn evaluate(g: &Graph, law: &Friction, v: f64, z: f64, normal: f64) -> Values {
        let mut evaluator = Evaluator::new(g);
        evaluator.set(law.slip, v);
        evaluator.set(law.normal, normal);
        evaluator.set(law.states[0].symbol, z);
        for (symbol, value) in &law.definitions {
            evaluator.define(*symbol, *value);
        }
        Values {
            rate: evaluator.value(law.states[0].rate),
            force: evaluator.value(law.force),
            energy: evaluator.value(law.energy),
        }
    }

    fn close(a: f64, b: f64) {
        assert!((a - b).abs() <= 1e-13 * a.abs().max(b.abs()), "{a} and {b}");
    }

    #[test]
    fn agrees_with_the_formula_by_hand() {
        let mut g = Graph::new();
        let p = parameters(&mut g);
        let preload = g.integer(20);
        let law = lugre(&mut g, "tip", p, &NormalForce::Constant(preload), None);
        for (v, z) in [(0.0, 0.0), (2e-4, 3e-7), (-3e-3, 5e-7), (0.1, -8e-7)] {
            let values = evaluate(&g, &law, v, z, 20.0);
            let (fs, fc) = (0.3 * 20.0, 0.2 * 20.0);
            let limit = (fc + (fs - fc) * f64::exp(-(v / 1e-3) * (v / 1e-3))) / 5e6;
            let rate = v - v.abs() * z / limit;
            close(values.rate, rate);
            close(values.force, 5e6 * z + 5.0 * rate + 0.5 * v);
            close(values.energy, 0.5 * 5e6 * z * z);
        }
    }

    #[test]
    fn steady_sliding_gives_the_stribeck_curve() {
        let mut g = Graph::new();
        let p = parameters(&mut g);
        let preload = g.integer(20);
        let law = lugre(&mut g, "", p, &NormalForce::Constant(preload), None);
        for v in [1e-5f64, 1e-3, -1e-2] {
            let stribeck = 4.0 + 2.0 * f64::exp(-(v / 1e-3).powi(2));
            let z = stribeck / 5e6 * v.signum();
            let values = evaluate(&g, &law, v, z, 20.0);
            assert!(values.rate.abs() <= 1e-14 * v.abs().max(1e-3));
            assert!((values.force - (stribeck * v.signum() + 0.5 * v)).abs() < 1e-9);
        }
    }

    #[test]
    fn a_varying_normal_force_scales_the_law() {
        let mut g = Graph::new();
        let p = parameters(&mut g);
        let (preload, stiffness, damping) = (g.integer(20), g.integer(1000), g.zero());
        let constant = lugre(&mut g, "a", p, &NormalForce::Constant(preload), None);
        let compliant = NormalForce::Compliant {
            preload,
            stiffness,
            damping,
        };
        let varying = lugre(&mut g, "b", p, &compliant, None);
        let (v, z) = (2e-3, 4e-7);
        let reference = evaluate(&g, &constant, v, z, 20.0);
        for load in [20.0, 10.0, 0.0, 45.0] {
            let values = evaluate(&g, &varying, v, z, load);
            close(values.rate, reference.rate);
            close(values.force, reference.force * load / 20.0);
            close(values.energy, reference.energy * load / 20.0);
        }
    }

    #[test]
    fn a_reference_force_serves_where_the_preload_is_zero() {
        let mut g = Graph::new();
        let p = parameters(&mut g);
        let (preload, reference) = (g.zero(), g.integer(20));
        let (stiffness, damping) = (g.integer(1000), g.zero());
        let compliant = NormalForce::Compliant {
            preload,
            stiffness,
            damping,
        };
        let law = lugre(&mut g, "tip", p, &compliant, Some(reference));
        let values = evaluate(&g, &law, 2e-3, 4e-7, 0.0);
        assert!(values.rate.is_finite());
        close(values.force, 0.0);
    }
}
