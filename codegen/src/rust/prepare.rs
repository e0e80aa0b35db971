//! `Params::prepare`: checks, Newton blocks, the start, and the values that the functions use.

use proc_macro2::TokenStream;
use quote::quote;

use super::body::{Body, Writer};
use super::configuration;
use super::curve;
use super::expression::{ident, unsuffixed};
use crate::names::unknown_names;
use crate::program::{Message, Solve};
use crate::schedule::{order, prepared_compiled};
use crate::values::Value;

/// The statements of `prepare`, and the messages that they refer to.
pub(super) fn prepare(writer: &Writer<'_>) -> (Vec<TokenStream>, Vec<Message>) {
    let program = writer.program;
    let values = &program.values;
    let mut body = Body::prepare(writer);
    let mut messages = Vec::new();

    let fields = prepared_compiled(program);
    let roots: Vec<Value> = program.parameter_roots(&fields).collect();
    let everything = order(values, roots.iter().copied(), |_| true);
    for level in 0..=program.solves.len() {
        let code: Vec<Value> = everything
            .iter()
            .copied()
            .filter(|value| values.level(*value) as usize == level)
            .collect();
        // Every use counts, also those at later levels.
        let later: Vec<Value> = everything
            .iter()
            .copied()
            .filter(|value| values.level(*value) as usize > level)
            .flat_map(|value| values.operands(value))
            .filter(|operand| values.level(*operand) as usize == level)
            .chain(
                roots
                    .iter()
                    .copied()
                    .filter(|root| values.level(*root) as usize == level),
            )
            .collect();
        body.compute(&code, &later);
        for check in &program.checks {
            if values.level(check.margin) as usize == level {
                let margin = body.number_tokens(check.margin);
                let condition = if check.zero_is_well {
                    quote!(!(#margin >= 0.0))
                } else {
                    quote!(!(#margin > 0.0))
                };
                let failing = fail(writer, &mut body, &check.message, &mut messages);
                body.push(quote!(if #condition { #(#failing)* }));
            }
        }
        if let Some(solve) = program.solves.get(level) {
            newton(writer, &mut body, solve, level, &mut messages);
        }
    }

    let assignments = fields.iter().map(|value| {
        let field = ident(&writer.fields[value]);
        let tokens = body.number_tokens(*value);
        if field == tokens.to_string() {
            quote!(#field)
        } else {
            quote!(#field: #tokens)
        }
    });
    let states = program.start_states.iter().map(|v| body.number_tokens(*v));
    let discretes = program
        .start_discretes
        .iter()
        .map(|v| body.number_tokens(*v));
    let none = configuration::no_tables(program);
    let wanted = curve::wanted(writer);
    let fits = configuration::fits(writer);
    let mutable = (!program.configurations.is_empty()).then(|| quote!(mut));
    let prepared = quote! {
        let #mutable prepared = Prepared {
            start_states: [#(#states),*],
            start_discretes: [#(#discretes),*],
            #(#assignments,)*
            #none
            #wanted
        };
        check_start(prepared.states(), &prepared.start_states)?;
        check_start(prepared.discretes(), &prepared.start_discretes)?;
        #fits
        Ok(prepared)
    };
    body.push(prepared);
    (body.finish(), messages)
}

/// Statements that return the error with its holes filled.
fn fail(
    writer: &Writer<'_>,
    body: &mut Body<'_, '_>,
    message: &Message,
    messages: &mut Vec<Message>,
) -> Vec<TokenStream> {
    let index = unsuffixed(messages.len());
    messages.push(message.clone());
    body.block(|body| {
        let order = order(
            &writer.program.values,
            message.values.iter().copied(),
            |_| true,
        );
        body.compute(&order, &message.values);
        let list: Vec<TokenStream> = message
            .values
            .iter()
            .map(|value| body.number_tokens(*value))
            .collect();
        body.push(quote!(return Err(FAILURES[#index].diagnostic(&[#(#list),*]));));
    })
}

/// Solves a block of equations and gives its unknowns their names.
fn newton(
    writer: &Writer<'_>,
    body: &mut Body<'_, '_>,
    solve: &Solve,
    level: usize,
    messages: &mut Vec<Message>,
) {
    let values = &writer.program.values;
    let after = |value: Value| values.level(value) as usize > level;
    let roots: Vec<Value> = solve
        .residuals
        .iter()
        .chain(&solve.jacobian)
        .copied()
        .collect();
    // What does not change with the unknowns is computed before.
    let inner = order(values, roots.iter().copied(), after);
    let outer_roots: Vec<Value> = inner
        .iter()
        .flat_map(|value| values.operands(*value))
        .chain(roots.iter().copied())
        .filter(|value| !after(*value))
        .collect();
    let outer = order(values, outer_roots.iter().copied(), |_| true);
    body.compute(&outer, &outer_roots);

    let guesses: Vec<TokenStream> = solve
        .guesses
        .iter()
        .map(|value| body.number_tokens(*value))
        .collect();
    let scales: Vec<TokenStream> = solve
        .scales
        .iter()
        .map(|value| body.number_tokens(*value))
        .collect();
    let all_names = unknown_names(writer.program);
    let first: usize = writer.program.solves[..level]
        .iter()
        .map(|earlier| earlier.unknowns.len())
        .sum();
    let names: Vec<_> = solve
        .unknowns
        .iter()
        .enumerate()
        .map(|(index, value)| {
            let wanted = all_names.get(first + index).map_or("unknown", |n| n);
            ident(&body.name(*value, wanted))
        })
        .collect();
    let evaluation = body.block(|body| {
        body.compute(&inner, &roots);
        for (array, list) in [
            ("residuals", &solve.residuals),
            ("derivatives", &solve.jacobian),
        ] {
            let array = ident(array);
            for (index, value) in list.iter().enumerate() {
                let index = unsuffixed(index);
                let tokens = body.number_tokens(*value);
                body.push(quote!(#array[#index] = #tokens;));
            }
        }
    });
    let positions: Vec<_> = (0..names.len()).map(unsuffixed).collect();
    let failing = fail(writer, body, &solve.message, messages);
    body.push(quote! {
        let mut solution = [#(#guesses),*];
        let solved = newton::solve(
            &mut solution,
            &[#(#scales),*],
            &mut |unknowns, residuals, derivatives| {
                #(let #names = unknowns[#positions];)*
                #(#evaluation)*
            },
        );
        let [#(#names),*] = solution;
        if solved.is_err() { #(#failing)* }
    });
}
