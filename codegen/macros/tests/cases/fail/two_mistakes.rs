//! Every mistake is told at once.

flexure_macros::model! {
    ::flexure_runtime,
    r#"
model resonator
param k = 1 kN/m, m = 1 furlong
slide mass along (1, 0) { mass = m }
spring wall between ground and mas { stiffness = k }
    "#
}

fn main() {}
