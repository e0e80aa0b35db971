//! The Rust back end: a module that reads as if written by hand.
//!
//! ```text
//! Program ─▶ names ─▶ Params, prepare() ─▶ Prepared<T> ─▶ rhs, jacobian, … ─▶ System
//!                     (f64)                              (generic over T: Real)
//! ```
//!
//! The same tokens serve the macro and, printed, `flexure emit`; printing adds comments, which are
//! carried as attributes that only the printer knows. A `let` is written for what the equations
//! name and for what is used more than once; the rest is nested.

mod blocks;
mod body;
mod configuration;
mod curve;
mod expression;
mod function;
mod items;
mod lane_system;
mod prepare;
mod skeleton;
mod system;

use std::collections::HashMap;

use proc_macro2::TokenStream;
use quote::quote;

use crate::names::{Described, Namer};
use crate::program::Program;
use crate::schedule::prepared_compiled;
use crate::values::Value;
use body::Writer;
use expression::ident;

pub use skeleton::skeleton;

/// The equations as texts, for constants of the generated module.
#[derive(Clone, Copy, Debug, Default)]
pub struct Texts<'t> {
    /// In plain text.
    pub equations: &'t str,
    /// In LaTeX.
    pub latex: &'t str,
}

/// A module named after the model. `runtime` is the path of the runtime crate there, such as
/// `::flexure_runtime`.
pub fn rust(program: &Program, texts: Texts<'_>, runtime: &TokenStream) -> TokenStream {
    module(program, texts, runtime, false)
}

/// The same as source text with comments, for people to read and compilers to compile.
pub fn rust_source(program: &Program, texts: Texts<'_>, runtime: &TokenStream) -> String {
    let tokens = module(program, texts, runtime, true);
    match syn::parse2::<syn::File>(tokens.clone()) {
        Ok(file) => prettyplease::unparse(&file),
        // Not reached for a program of this crate; the tokens say more than a message would.
        Err(_) => tokens.to_string(),
    }
}

/// The module's name for a model's.
pub fn module_name(model: &str) -> String {
    Namer::default().name(model)
}

fn module(
    program: &Program,
    texts: Texts<'_>,
    runtime: &TokenStream,
    comments: bool,
) -> TokenStream {
    let writer = Writer {
        program,
        described: Described::new(program),
        fields: HashMap::new(),
        params: param_names(program),
        comments,
    };
    let writer = Writer {
        fields: field_names(&writer),
        ..writer
    };
    let (prepare, messages) = prepare::prepare(&writer);
    let params = items::params(&writer, &prepare);
    let prepared = items::prepared_type(&writer);
    let configurations = configuration::functions(&writer);
    let curves = curve::functions(&writer);
    let functions = function::functions(&writer);
    let system = system::system(&writer);
    let lane_system = lane_system::lane_system(&writer);
    let tables = items::tables(program, &messages, texts.equations, texts.latex);
    let name = ident(&module_name(&program.name));
    let doc = documentation(program);
    let allowed = allowed();
    quote! {
        #(#[doc = #doc])*
        #allowed
        pub mod #name {
            use std::borrow::Cow;
            use #runtime::checks::{check_params, check_start};
            use #runtime::diagnostic::{Diagnostic, Site};
            use #runtime::failure::{Failure, Unit};
            use #runtime::generated::{array, array_mut};
            use #runtime::lanes::{LaneSystem, Lanes};
            use #runtime::newton;
            use #runtime::real::Real;
            use #runtime::simulate::PlainSteps;
            use #runtime::system::{Causality, Energy, EventAction, System, Variable};
            use #runtime::table::{Curve, CurveReport, Table, TableReport};

            #params
            #prepared
            #configurations
            #curves
            #functions
            #system
            #lane_system
            #tables
        }
    }
}

/// What a generated module may do that hand-written code would be told off for: names as in the
/// equations, and imports that this model may not need.
fn allowed() -> TokenStream {
    quote! {
        #[allow(
            non_snake_case,
            non_upper_case_globals,
            unused,
            clippy::all,
            clippy::pedantic,
            rustdoc::all
        )]
    }
}

/// Lines of the module's documentation.
fn documentation(program: &Program) -> Vec<String> {
    let mut lines = vec![format!(
        " Simulator of the model `{}`, generated from its equations of motion.",
        program.name
    )];
    let words: Vec<String> = program.doc.trim().lines().map(items::plain).collect();
    if !words.is_empty() {
        lines.push(String::new());
    }
    for line in words {
        if !line.is_empty() {
            lines.push(format!(" {line}"));
        } else if lines.last().is_some_and(|last| !last.is_empty()) {
            lines.push(line);
        }
    }
    lines
}

fn param_names(program: &Program) -> Vec<String> {
    let mut namer = Namer::default();
    program
        .params
        .iter()
        .map(|param| namer.name(&param.name))
        .collect()
}

/// Names of the fields of `Prepared`: the equations' own first, so that they stay as they are.
fn field_names(writer: &Writer<'_>) -> HashMap<Value, String> {
    let (program, described) = (writer.program, &writer.described);
    let mut namer = Namer::without(&["start_states", "start_discretes"]);
    for configuration in &program.configurations {
        namer.name(&configuration::table_field(program, configuration));
    }
    for index in 0..program.compiled.curves.len() {
        namer.name(&curve::field_name(writer, index));
    }
    let mut fields = HashMap::new();
    let values = prepared_compiled(program);
    let is_named =
        |value: &Value| program.names.contains_key(value) || !program.values.is_computed(*value);
    let (own, others): (Vec<Value>, Vec<Value>) = values.into_iter().partition(is_named);
    let mut nameless = 0;
    for value in own.into_iter().chain(others) {
        let name = match described.name(value) {
            Some(name) => namer.name(name),
            None => {
                nameless += 1;
                namer.name(&format!("constant{nameless}"))
            }
        };
        fields.insert(value, name);
    }
    fields
}
