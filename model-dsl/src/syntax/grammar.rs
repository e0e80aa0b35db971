//! The parser that pest makes of `grammar.pest`.

// The derive macro writes a public enum of rules that cannot be documented from outside.
#![allow(missing_docs)]

#[derive(pest_derive::Parser)]
#[grammar = "syntax/grammar.pest"]
pub struct Grammar;
