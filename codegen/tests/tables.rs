//! Tables against the closed forms that they stand for.

mod support;

use flexure_runtime::system::System;

#[test]
fn reports() {
    for equations in support::models::all() {
        let program = flexure_codegen::program(&equations);
        let tape = flexure_codegen::tape(&program);
        let started = std::time::Instant::now();
        let prepared = tape.prepare(&tape.defaults()).unwrap();
        let took = started.elapsed();
        let exact = prepared.clone().exact();
        let started = std::time::Instant::now();
        let _ = tape.prepare(&tape.defaults()).unwrap();
        println!(
            "{}: {:?} {:?} exact {}",
            equations.name,
            took,
            started.elapsed(),
            exact.tables().len()
        );
        for report in prepared.tables() {
            println!("   {report:?}");
        }
    }
}
