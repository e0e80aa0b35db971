//! The functions of time, state and inputs.

use std::collections::HashSet;

use proc_macro2::TokenStream;
use quote::quote;

use super::blocks::in_blocks;
use super::body::{Body, Writer};
use super::configuration;
use super::expression::{ident, unsuffixed};
use crate::program::Function;
use crate::schedule::moving_order;
use crate::values::{Node, Value};

/// What a function takes besides the prepared values.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Takes {
    Everything,
    Discretes,
}

/// All functions.
pub(super) fn functions(writer: &Writer<'_>) -> TokenStream {
    let program = writer.program;
    let [n, k, e, m, l] = [
        program.states.len(),
        program.next_kinks.results.len(),
        program.events.results.len(),
        program.outputs.len(),
        program.loop_names.len(),
    ];
    let entries = n * n;
    let rhs = {
        let doc = "dx/dt. Where a loop cannot close, entries are not numbers.";
        let body = assignments_in(Body::fused(writer), writer, &program.compiled.rhs, "dx");
        signature(writer, "rhs", Takes::Everything, "dx", n, doc, &body)
    };
    let simple = [
        (
            "jacobian",
            &program.jacobian,
            entries,
            "result",
            "∂(dx/dt)/∂x, row by row; entries that are always zero are left as they are.",
        ),
        (
            "outputs",
            &program.output_values,
            m,
            "result",
            "The model's outputs.",
        ),
        (
            "energy",
            &program.energy,
            4,
            "result",
            "Kinetic and potential energy in J, dissipated and supplied power in W.",
        ),
        (
            "events",
            &program.events,
            e,
            "result",
            "Event functions: each event happens where its function rises through zero.",
        ),
        (
            "closures",
            &program.compiled.closures,
            l,
            "result",
            "For each loop a number that is positive where it closes and zero at a dead point.",
        ),
    ]
    .map(|(name, function, length, out, doc)| {
        let body = assignments(writer, function, out);
        signature(writer, name, Takes::Everything, out, length, doc, &body)
    });
    let accepted = {
        let body = assignments(writer, &program.compiled.accept, "result");
        signature(
            writer,
            "accept",
            Takes::Everything,
            "result",
            program.discretes.len(),
            "The discrete state after an accepted step that ends in `x`; entries that stay are left as they are.",
            &body,
        )
    };
    let kinks = {
        let body = assignments(writer, &program.next_kinks, "result");
        signature(
            writer,
            "next_kinks",
            Takes::Discretes,
            "result",
            k,
            "Time in s of each drive's next kink.",
            &body,
        )
    };
    let passing = pass_kink(writer);
    let event = pass_event(writer);
    quote!(#rhs #(#simple)* #accepted #kinks #passing #event)
}

fn signature(
    writer: &Writer<'_>,
    name: &str,
    takes: Takes,
    out: &str,
    length: usize,
    doc: &str,
    body: &[TokenStream],
) -> TokenStream {
    let (name, out, length) = (ident(name), ident(out), unsuffixed(length));
    let doc = format!(" {doc}");
    let arguments = arguments(writer, takes);
    quote! {
        #[doc = #doc]
        #[inline(always)]
        pub fn #name<T: Real>(#arguments p: &Prepared<T>, #out: &mut [T; #length]) {
            #(#body)*
        }
    }
}

fn arguments(writer: &Writer<'_>, takes: Takes) -> TokenStream {
    let program = writer.program;
    let [n, d, u] = [
        program.states.len(),
        program.discretes.len(),
        program.inputs.len(),
    ]
    .map(unsuffixed);
    match takes {
        Takes::Everything => quote!(t: T, x: &[T; #n], d: &[T; #d], u: &[T; #u],),
        Takes::Discretes => quote!(d: &[T; #d],),
    }
}

/// Statements that compute a function's results and assign them to entries of `out`.
fn assignments(writer: &Writer<'_>, function: &Function, out: &str) -> Vec<TokenStream> {
    assignments_in(Body::generic(writer), writer, function, out)
}

/// The same after what `body` has.
fn assignments_in(
    mut body: Body<'_, '_>,
    writer: &Writer<'_>,
    function: &Function,
    out: &str,
) -> Vec<TokenStream> {
    configuration::tabulated(writer, &mut body, function);
    assign(writer, &mut body, function, out);
    in_blocks(body.finish())
}

fn assign(writer: &Writer<'_>, body: &mut Body<'_, '_>, function: &Function, out: &str) {
    let roots: Vec<_> = function.roots().collect();
    let values = &writer.program.values;
    let mut order = moving_order(values, roots.iter().copied());
    // What needs no curve first: numbers stay in registers over fewer branches.
    let mut behind: HashSet<Value> = HashSet::new();
    for &value in &order {
        let is_curve = matches!(values.node(value), Node::Curve(..));
        if is_curve
            || values
                .operands(value)
                .any(|operand| behind.contains(&operand))
        {
            behind.insert(value);
        }
    }
    order.sort_by_key(|value| behind.contains(value));
    body.compute(&order, &roots);
    let out = ident(out);
    for (position, value) in &function.results {
        let position = unsuffixed(*position as usize);
        let tokens = body.number_tokens(*value);
        body.push(quote!(#out[#position] = #tokens;));
    }
}

fn pass_kink(writer: &Writer<'_>) -> TokenStream {
    let arms = writer
        .program
        .pass_kink
        .iter()
        .enumerate()
        .map(|(index, function)| {
            let body = assignments(writer, function, "result");
            let index = unsuffixed(index);
            quote!(#index => { #(#body)* })
        });
    let d = unsuffixed(writer.program.discretes.len());
    let body = if writer.program.pass_kink.is_empty() {
        quote!()
    } else {
        quote!(match index { #(#arms)* _ => {} })
    };
    quote! {
        #[doc = " The discrete state after drive `index` passed its kink; entries that stay are left as they are."]
        #[inline(always)]
        pub fn pass_kink<T: Real>(index: usize, d: &[T; #d], p: &Prepared<T>, result: &mut [T; #d]) {
            #body
        }
    }
}

fn pass_event(writer: &Writer<'_>) -> TokenStream {
    let program = writer.program;
    let arms = program.event_rows.iter().enumerate().map(|(index, event)| {
        let mut body = Body::generic(writer);
        assign(writer, &mut body, &event.states, "x_after");
        assign(writer, &mut body, &event.discretes, "d_after");
        let body = body.finish();
        let index = unsuffixed(index);
        quote!(#index => { #(#body)* })
    });
    let body = if program.event_rows.is_empty() {
        quote!()
    } else {
        quote!(match index { #(#arms)* _ => {} })
    };
    let [n, d] = [program.states.len(), program.discretes.len()].map(unsuffixed);
    let arguments = arguments(writer, Takes::Everything);
    quote! {
        #[doc = " The state after event `index`; entries that stay are left as they are."]
        #[inline(always)]
        pub fn pass_event<T: Real>(
            index: usize,
            #arguments
            p: &Prepared<T>,
            x_after: &mut [T; #n],
            d_after: &mut [T; #d],
        ) {
            #body
        }
    }
}
