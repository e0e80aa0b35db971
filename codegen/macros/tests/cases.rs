//! One mistake in a model is one error, and names cannot break the code.

#[test]
fn mistakes_are_told_once_and_names_are_harmless() {
    let cases = trybuild::TestCases::new();
    cases.pass("tests/cases/pass/*.rs");
    cases.compile_fail("tests/cases/fail/*.rs");
}
