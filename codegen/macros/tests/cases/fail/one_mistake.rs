//! One mistake in a model is one error, though the model is used all over.

flexure_macros::model! {
    ::flexure_runtime,
    r#"
model resonator
param k = 1 kN/m, m = 1 kg
slide mass along (1, 0) { mass = m }
spring wall between ground and mass { stiffness = 3 N*m }
set soft { k = 1 N/m }
    "#
}

fn main() {
    let design = resonator::Params { k: 2e3, ..Default::default() };
    assert_ne!(design.values(), resonator::Params::soft().values());
    let model = design.prepare().expect("a model");
    let run = flexure_runtime::simulate::simulate(&model).until(1.0).run().expect("a run");
    println!("{} {}", resonator::EQUATIONS, run.column("mass.x").last());
}
