//! Oracle and tape give the same numbers, to rounding, at random states of every model: by tables
//! where it has some, and in closed form.

mod support;

use flexure_model_dsl::equations::Equations;
use flexure_runtime::system::System;
use support::agreement::compare;

fn check(equations: &Equations, states: usize) {
    let program = flexure_codegen::program(equations);
    let tape = flexure_codegen::tape(&program);
    let params = tape.defaults();
    match tape.prepare(&params) {
        Ok(prepared) => {
            compare(equations, &params, &prepared, states);
            if !prepared.tables().is_empty() {
                compare(equations, &params, &prepared.exact(), states);
            }
        }
        Err(diagnostic) => panic!("{}: {diagnostic}", equations.name),
    }
}

#[test]
fn equations_made_by_hand() {
    check(&support::handmade::slider_crank(), 300);
}

#[test]
fn every_model() {
    for equations in support::models::all() {
        check(&equations, 200);
    }
}

#[test]
fn every_mechanism_of_the_tests() {
    for equations in support::models::mechanisms() {
        check(&equations, 100);
    }
}
