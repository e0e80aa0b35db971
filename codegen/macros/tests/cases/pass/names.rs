//! Names that mean something in Rust, that differ in case alone, or that are Greek.

#![deny(warnings)]
#![forbid(unsafe_code)]

flexure_macros::model! {
    ::flexure_runtime,
    r#"
//! `code`, [link], <b>bold</b>, "quoted" \ and */ */.
model loop
param type = 1 kN/m "<script>alert('x')</script> \\ $x_1$ */ [`std`]"
param E = 2 kg, e = 3 mm
param λ0 = 1 N*s/m
param Self = 1 m/s, None = 1 m, t_ = 2, x = 1, d = 1, u = 1, p = 1, dx = 1, T = 1
param rhs = 1, Params = 1, Real = 1, f64 = 1, VARIABLES = 1
slide fn along (1, 0) { mass = E * x * d * u * p * dx * T * rhs * Params * Real * f64 * VARIABLES }
spring match between ground and fn { stiffness = type, damping = λ0 }
initial fn.x = e
initial fn.v = Self * None / None * t_ / t_
    "#
}

fn main() {
    let design = loop_::Params {
        type_: 500.0,
        E: 1.0,
        e: 2e-3,
        λ0: 0.0,
        ..Default::default()
    };
    let model = design.prepare().expect("a model");
    let mut x = [0.0; 2];
    flexure_runtime::system::System::start(&model, &mut x, &mut []);
    assert_eq!(x, [2e-3, 1.0]);
    let mut dx = [0.0; 2];
    loop_::rhs(0.0, &x, &[], &[], &model, &mut dx);
    assert_eq!(dx, [1.0, -1.0]);
}
