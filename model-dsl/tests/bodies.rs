//! Bodies, pins, masses and laws as resolved from small models.

use flexure_model_dsl::model::{Axis, BodyKind, GROUND, Load, Local, Measure, Model, NormalForce};
use flexure_model_dsl::resolve::resolve;
use flexure_model_dsl::source::Source;
use flexure_model_dsl::symbolic::{Evaluator, Expr};

fn model(text: &str) -> Model {
    let files = |path: &str| match path {
        "push.csv" => Ok("t;x\n0;0\n1;2\n3;2\n".to_owned()),
        _ => Err("no such file".to_owned()),
    };
    match resolve(
        Source::new("test.flex", format!("model test\n{text}")),
        &files,
    ) {
        Ok((model, _)) => model,
        Err(diagnostics) => {
            let texts: Vec<String> = diagnostics.iter().map(ToString::to_string).collect();
            panic!("{}", texts.join("\n\n"))
        }
    }
}

fn value(model: &Model, expr: Expr) -> f64 {
    let mut evaluator = Evaluator::new(&model.graph);
    for param in &model.params {
        evaluator.define(param.symbol, param.default);
    }
    for quantity in &model.lets {
        evaluator.define(quantity.symbol, quantity.value);
    }
    evaluator.value(expr)
}

fn values<const N: usize>(model: &Model, exprs: [Expr; N]) -> [f64; N] {
    exprs.map(|expr| value(model, expr))
}

fn body(model: &Model, name: &str) -> usize {
    model
        .bodies
        .iter()
        .position(|body| body.name == name)
        .expect(name)
}

fn names(model: &Model) -> Vec<&str> {
    model
        .lets
        .iter()
        .map(|quantity| quantity.name.as_str())
        .collect()
}

#[test]
fn drawn_links_have_exact_length_and_angle() {
    let model = model(
        "ground O = (1 mm, 2 mm)\npoint B = (4 mm, 6 mm)\nlink crank from O to B { mass = 3 g }\n\
         link rod from B to C { length = 10 mm, angle = 90 deg, mass = 3 g }",
    );
    let BodyKind::Link(crank) = &model.bodies[body(&model, "crank")].kind else {
        panic!("a link");
    };
    assert_eq!(value(&model, crank.length), 0.005);
    let angle = value(&model, crank.angle.value.expect("drawn"));
    assert_eq!(angle, 0.004f64.atan2(0.003));
    assert!(!crank.angle.exact);
    assert_eq!(
        names(&model),
        [
            "l_crank", "l_rod", "m_crank", "r_crank", "I_crank", "m_rod", "r_rod", "I_rod"
        ]
    );
}

#[test]
fn quantities_of_links_are_named_by_their_angles() {
    let model = model(
        "param l1 = 20 mm, m1 = 3 g, I1 = 2, beta = 0 deg\nground O = (0 mm, 0 mm)\n\
         link crank from O to B { length = l1, angle = 3 deg, mass = m1, com = polar(l1/3, beta), symbol = φ1 }\n\
         link rod from B to C { length = 2 * l1, angle = 3 deg, mass = 2 * m1, com = polar(l1/3, 5 deg), \
         section = rect(2 mm, 3 mm), symbol = θ_r }\noutput y = I1",
    );
    assert_eq!(
        names(&model),
        ["l_r", "r1", "I_crank", "m_r", "r_r", "β_r", "I_r"]
    );
    let inertia = model.lets[6].value;
    let expected = 0.006 * (0.04 * 0.04 + 0.003 * 0.003) / 12.0;
    assert!((value(&model, inertia) / expected - 1.0).abs() < 1e-14);
    assert!(model.notes.iter().any(|note| note.subject == "crank"));
    assert!(!model.notes.iter().any(|note| note.subject == "rod"));
}

#[test]
fn sections_and_densities() {
    let model = model(
        "ground O = (0 mm, 0 mm)\n\
         link a from O to B { length = 20 mm, angle = 0 deg, section = rect(2 mm, 3 mm), density = 2000 kg/m^3 }\n\
         link b from B to C { length = 20 mm, angle = 0 deg, section = circle(4 mm), density = 2000 kg/m^3 }\n\
         link c from C to D { length = 20 mm, angle = 0 deg }\n\
         link d from D to E { length = 20 mm, angle = 0 deg, mass = 1 g, inertia = 2 g*mm^2, com = (3 mm, 1 mm), mass at D = 5 g }",
    );
    let a = &model.bodies[body(&model, "a")].masses[0];
    let mass = 2000.0 * 2e-3 * 3e-3 * 20e-3;
    assert!((value(&model, a.mass) / mass - 1.0).abs() < 1e-14);
    let b = &model.bodies[body(&model, "b")].masses[0];
    let mass = 2000.0 * std::f64::consts::PI * 2e-3 * 2e-3 * 20e-3;
    assert!((value(&model, b.mass) / mass - 1.0).abs() < 1e-14);
    let inertia = mass * (0.02f64.powi(2) / 12.0 + 0.004f64.powi(2) / 16.0);
    assert!((value(&model, b.inertia) / inertia - 1.0).abs() < 1e-14);
    assert!(model.bodies[body(&model, "c")].masses.is_empty());
    let d = &model.bodies[body(&model, "d")].masses;
    assert_eq!(d.len(), 2);
    assert_eq!(value(&model, d[0].inertia), 2e-9);
    let Local::Cartesian(x, y) = d[0].center else {
        panic!("as written");
    };
    assert_eq!(values(&model, [x, y]), [3e-3, 1e-3]);
    assert_eq!(value(&model, d[1].mass), 5e-3);
    assert_eq!(value(&model, d[1].inertia), 0.0);
}

#[test]
fn bodies_meet_where_they_name_a_point() {
    let model = model(
        "ground O = (0 mm, 0 mm)\n\
         link a from O to B { length = 20 mm, angle = 0 deg, mass = 1 g }\n\
         link b from P to C { length = 20 mm, angle = 90 deg, mass = 1 g }\n\
         link c from B to D { length = 20 mm, angle = 90 deg, mass = 1 g }\n\
         link d from E to B { length = 20 mm, angle = 90 deg, mass = 1 g }\n\
         point P on a at (5 mm, 1 mm)\nslide s along (0, 2) { mass = 1 g }\npoint E on s at (1 mm, 2 mm)\n\
         hinge at P { stiffness = 1 N*m/rad }\nhinge at B between d, a { stiffness = 2 N*m/rad }\n\
         hinge at B between c, a { damping = 2 N*m*s/rad }\noutput y = B.d.a.torque\noutput z = P.deflection",
    );
    let pins: Vec<(&str, Vec<usize>)> = model
        .pins
        .iter()
        .map(|pin| {
            (
                pin.name.as_str(),
                pin.members.iter().map(|member| member.0).collect(),
            )
        })
        .collect();
    assert_eq!(
        pins,
        [
            ("O", vec![0, 1]),
            ("B", vec![1, 3, 4]),
            ("P", vec![1, 2]),
            ("E", vec![4, 5])
        ]
    );
    let hinges: Vec<(&str, (usize, usize))> = model
        .hinges
        .iter()
        .map(|hinge| (hinge.name.as_str(), hinge.bodies))
        .collect();
    assert_eq!(
        hinges,
        [("P", (1, 2)), ("B.d.a", (4, 1)), ("B.c.a", (3, 1))]
    );
    assert!(matches!(model.measures[0].measure, Measure::HingeTorque(1)));
    assert!(matches!(model.measures[1].measure, Measure::HingeAngle(0)));
}

#[test]
fn guides() {
    let model = model(
        "ground O = (5 mm, 6 mm)\n\
         link a from O to B { length = 20 mm, angle = 0 deg, mass = 1 g }\n\
         slide s along (3, 4) { mass = 1 g }\nslide r on a along (0, -2 mm) from B { mass = 1 g, at = 2 mm exact }\n\
         slide q on s along polar(1, 30 deg) through (1 mm, 2 mm) { mass = 1 g }\n\
         slide p along (1, 0) from O { mass = 1 g }",
    );
    let slide = |name: &str| match &model.bodies[body(&model, name)].kind {
        BodyKind::Slide(slide) => slide.clone(),
        _ => panic!("{name} is a slide"),
    };
    assert_eq!(values(&model, slide("s").direction), [0.6, 0.8]);
    assert!(!slide("s").located);
    assert_eq!(slide("s").carrier, GROUND);
    assert_eq!(values(&model, slide("r").direction), [0.0, -1.0]);
    assert_eq!(slide("r").carrier, body(&model, "a"));
    assert!(slide("r").at.exact);
    let Local::Cartesian(x, y) = slide("r").origin else {
        panic!("the end of a link");
    };
    assert_eq!(values(&model, [x, y]), [0.02, 0.0]);
    let [x, y] = values(&model, slide("q").direction);
    assert!((x - 0.75f64.sqrt()).abs() < 1e-15 && (y - 0.5).abs() < 1e-15);
    let Local::Cartesian(x, y) = slide("p").origin else {
        panic!("a point of ground");
    };
    assert_eq!(values(&model, [x, y]), [0.005, 0.006]);
    assert!(slide("p").located);
}

#[test]
fn springs_act_along_guides_lines_or_directions() {
    let model = model(
        "ground O = (0 mm, 0 mm), P = (0 mm, 50 mm)\n\
         link a from O to B { length = 20 mm, angle = 0 deg, mass = 1 g }\n\
         slide s along (1, 0) { mass = 1 g }\nslide r along (1, 0) { mass = 1 g }\n\
         point F on s at (1 mm, 0 mm)\n\
         spring s1 between ground and s { stiffness = 1 N/m }\n\
         spring s2 between r and s { stiffness = 1 N/m }\n\
         spring s3 between P and B { stiffness = 1 N/m, length = 10 mm }\n\
         spring s4 between s and B along (0, -1) { damping = 1 N*s/m }\n\
         spring s5 between s and B { stiffness = 1 N/m }\n\
         stack s6 between F and B { stiffness = 1 N/m, mass = 2 g, expansion = 3 um }",
    );
    let s = body(&model, "s");
    let axes: Vec<Axis> = model.springs.iter().map(|spring| spring.axis).collect();
    assert_eq!(axes[0], Axis::Guide(s));
    assert_eq!(axes[1], Axis::Guide(s));
    assert_eq!(axes[2], Axis::Line);
    let Axis::Fixed(direction) = axes[3] else {
        panic!("as written");
    };
    assert_eq!(values(&model, direction), [0.0, -1.0]);
    assert_eq!(axes[4], Axis::Line);
    assert_eq!(axes[5], Axis::Line);
    assert!(model.springs[5].stack);
    for name in ["a", "s"] {
        let half = model.bodies[body(&model, name)]
            .masses
            .last()
            .expect("half of the stack");
        assert_eq!(value(&model, half.mass), 1e-3);
    }
}

#[test]
fn contacts_loads_and_inputs() {
    let model = model(
        "param N = 3 N\ninput u: V = 0 \"amplifier\"\n\
         ground O = (0 mm, 0 mm)\nlink a from O to B { length = 20 mm, angle = 0 deg, mass = 1 g }\n\
         slide s along (1, 0) { mass = 1 g }\n\
         contact tip between B and s { normal = (0, -3), preload = N, normal_stiffness = 1e6 N/m, \
         friction = lugre(1e5 N/m, 1 N*s/m, 1 N*s/m, mu_s = 0.3, mu_c = 0.2, v_s = 1 mm/s) }\n\
         contact rail between s and ground { preload = N, \
         friction = lugre(1e5 N/m, 1 N*s/m, 1 N*s/m, 0.3, 0.2, 1 mm/s) }\n\
         force on B = (u * 2 N/V, -15 N * sin(2*pi*200 Hz*t))\ntorque on a = 3 N*m\n\
         torque between a and s = tip.friction * 1 mm\n\
         drive x = table(\"push.csv\", value = 1 um, time = 1 ms)\ndrive z = 2 * x + s.travel\n\
         initial a.rate = 3 rad/s, s.v = 1 mm/s, tip.z = 1 um\nstart = equilibrium\ncoordinate a.angle, s.x\n\
         stop when z > 1 mm \"far enough\"\nstop when abs(tip.slip) >= 3 m/s",
    );
    assert_eq!(model.contacts[0].guide, body(&model, "s"));
    assert_eq!(model.contacts[1].guide, body(&model, "s"));
    assert!(matches!(
        model.contacts[0].normal_force,
        NormalForce::Compliant { .. }
    ));
    assert_eq!(
        values(&model, model.contacts[0].normal.expect("given")),
        [0.0, -1.0]
    );
    assert_eq!(model.inputs[0].dimension.si_unit(), "V");
    let Load::Torque { on, against, .. } = &model.loads[2] else {
        panic!("a torque");
    };
    assert_eq!((*on, *against), (body(&model, "s"), body(&model, "a")));
    assert_eq!(model.drives[0].dimension.si_unit(), "m");
    assert_eq!(
        model.drives[0].written,
        "table(\"push.csv\", value = 1 um, time = 1 ms)"
    );
    assert_eq!(model.files, ["push.csv"]);
    assert_eq!(model.initial.len(), 3);
    assert_eq!(model.coordinates.len(), 2);
    assert_eq!(model.stops[0].reason, "far enough");
    assert_eq!(model.stops[1].reason, "abs(tip.slip) >= 3 m/s");
}
