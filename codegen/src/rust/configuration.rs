//! Functions of one coordinate: their closed forms, and the tables that give them near the start.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;
use quote::quote;

use super::blocks::in_blocks;
use super::body::{Body, Writer};
use super::expression::{ident, unsuffixed};
use crate::names::identifier;
use crate::program::{Configuration, Function, Program};
use crate::schedule::moving_order;
use crate::values::{Node, Value};

/// Name of the function that has the closed forms: `functions_of_φ1`.
pub(super) fn function_name(program: &Program, configuration: &Configuration) -> String {
    let coordinate = program.coordinate_text(configuration);
    format!("functions_of_{}", identifier(coordinate))
}

/// Name of the field of `Prepared` that has the table: `table_of_φ1`.
pub(super) fn table_field(program: &Program, configuration: &Configuration) -> String {
    let coordinate = program.coordinate_text(configuration);
    format!("table_of_{}", identifier(coordinate))
}

/// The closed forms.
pub(super) fn functions(writer: &Writer<'_>) -> TokenStream {
    let program = writer.program;
    let d = unsuffixed(program.discretes.len());
    program
        .configurations
        .iter()
        .map(|configuration| {
            let name = ident(&function_name(program, configuration));
            let count = unsuffixed(configuration.leaves.len());
            let text = program.coordinate_text(configuration);
            let who = if configuration.rates < configuration.leaves.len() {
                "[`rhs`], [`accept`] and [`closures`] need"
            } else {
                "[`rhs`] needs"
            };
            let doc =
                format!(" What {who} that depends on `{text}` and params alone, in closed form.");
            let mut body = Body::of_configuration(writer);
            let argument = coordinate(program, configuration).map(|value| {
                let wanted = body.wanted_name(value);
                ident(&body.name(value, &wanted))
            });
            let roots: Vec<Value> = configuration.functions.roots().collect();
            let order = moving_order(&program.values, roots.iter().copied());
            body.compute(&order, &roots);
            let results: Vec<TokenStream> =
                roots.iter().map(|root| body.number_tokens(*root)).collect();
            body.push(quote!([#(#results),*]));
            let body = in_blocks(body.finish());
            quote! {
                #[doc = #doc]
                #[inline(always)]
                pub fn #name<T: Real>(#argument: T, d: &[T; #d], p: &Prepared<T>) -> [T; #count] {
                    #(#body)*
                }
            }
        })
        .collect()
}

/// Names for the functions that `function` needs, from table or closed form.
pub(super) fn tabulated(writer: &Writer<'_>, body: &mut Body<'_, '_>, function: &Function) {
    let program = writer.program;
    let order = moving_order(&program.values, function.roots());
    let operands = order
        .iter()
        .flat_map(|value| program.values.operands(*value));
    let used: BTreeSet<Value> = operands.chain(function.roots()).collect();
    for configuration in &program.configurations {
        let leaves = &configuration.leaves;
        let is_used = |leaf: &Value| used.contains(leaf);
        let (Some(coordinate), Some(first), Some(last)) = (
            coordinate(program, configuration),
            leaves.iter().position(is_used),
            leaves.iter().rposition(is_used),
        ) else {
            continue;
        };
        body.load(coordinate);
        let coordinate = body.piece(coordinate).tokens;
        let mut names: Vec<TokenStream> = Vec::with_capacity(leaves.len());
        if first > 0 {
            names.push(quote!(..));
        }
        for (index, leaf) in (first..).zip(&leaves[first..=last]) {
            if is_used(leaf) {
                let wanted = body.wanted_name(*leaf);
                let name = ident(&body.name(*leaf, &wanted));
                names.push(quote!(#name));
            } else {
                names.push(quote!(_));
            }
            if index == last && last + 1 < leaves.len() {
                // Only one `..` is allowed.
                names.extend(if first > 0 {
                    vec![quote!(_); leaves.len() - 1 - last]
                } else {
                    vec![quote!(..)]
                });
            }
        }
        let table = ident(&table_field(program, configuration));
        let function = ident(&function_name(program, configuration));
        body.push(quote! {
            let [#(#names),*] = if p.#table.covers(#coordinate) {
                p.#table.polynomials(#coordinate)
            } else {
                p.#table.where_covered(#coordinate, #function(#coordinate, d, p))
            };
        });
    }
}

/// The value of the coordinate.
fn coordinate(program: &Program, configuration: &Configuration) -> Option<Value> {
    let mut all = (0..program.values.len()).map(|index| program.values.at(index));
    all.find(|value| program.values.node(*value) == Node::State(configuration.coordinate))
}

/// Fields of `Prepared`.
pub(super) fn fields(program: &Program) -> TokenStream {
    each(program, |field, configuration| {
        let count = unsuffixed(configuration.leaves.len());
        let function = function_name(program, configuration);
        let doc = format!(" [`{function}`] near the start.");
        quote!(#[doc = #doc] pub #field: Table<T, #count>,)
    })
}

/// The fields with every number turned into another.
pub(super) fn mapped(program: &Program) -> TokenStream {
    each(program, |field, _| quote!(#field: self.#field.map(&turn),))
}

/// The fields with every number joined with its counterpart.
pub(super) fn zipped(program: &Program) -> TokenStream {
    each(
        program,
        |field, _| quote!(#field: self.#field.zip(&other.#field, &join),),
    )
}

/// The fields with closed forms everywhere.
pub(super) fn no_tables(program: &Program) -> TokenStream {
    each(program, |field, _| quote!(#field: Table::none(),))
}

/// Statements of `prepare` that make the tables.
pub(super) fn fits(writer: &Writer<'_>) -> TokenStream {
    let program = writer.program;
    let coordinates = program.coordinates();
    each(program, |field, configuration| {
        let is_own = |pair: &(usize, usize)| pair.0 == configuration.coordinate as usize;
        let which = unsuffixed(coordinates.iter().position(is_own).unwrap_or(0));
        let function = ident(&function_name(program, configuration));
        let argument = ident(&identifier(program.coordinate_text(configuration)));
        let rates = unsuffixed(configuration.rates);
        quote! {
            prepared.#field = Table::fit(&prepared, &COORDINATES, #which, #rates, |#argument, d| {
                #function(#argument, array(d), &prepared)
            });
        }
    })
}

/// Functions of `System` on tables; nothing where there are none.
pub(super) fn of_system(program: &Program) -> TokenStream {
    if program.configurations.is_empty() {
        return quote!();
    }
    let reports = each(program, |field, configuration| {
        let coordinate = unsuffixed(configuration.coordinate as usize);
        quote!(self.#field.report(#coordinate),)
    });
    let outside = program.configurations.iter().map(|configuration| {
        let field = ident(&table_field(program, configuration));
        let coordinate = unsuffixed(configuration.coordinate as usize);
        quote!(self.#field.is_left_by(x[#coordinate]))
    });
    quote! {
        fn tables(&self) -> Vec<TableReport> {
            [#reports].into_iter().flatten().collect()
        }
        fn is_outside_tables(&self, x: &[f64]) -> bool {
            #(#outside)||*
        }
    }
}

/// Functions of `LaneSystem` on tables; nothing where there are none.
pub(super) fn of_lane_system(program: &Program) -> TokenStream {
    if program.configurations.is_empty() {
        return quote!();
    }
    let outside = program.configurations.iter().map(|configuration| {
        let field = ident(&table_field(program, configuration));
        let coordinate = unsuffixed(configuration.coordinate as usize);
        quote!(.larger(lanes.#field.left_by(x[#coordinate])))
    });
    quote! {
        #[inline(always)]
        fn outside_tables_in_lanes<L: Lanes>(lanes: &Prepared<L>, x: &[L]) -> L {
            L::from_f64(-1.0)#(#outside)*
        }
    }
}

fn each(
    program: &Program,
    write: impl Fn(&proc_macro2::Ident, &Configuration) -> TokenStream,
) -> TokenStream {
    let configurations = program.configurations.iter();
    configurations
        .map(|configuration| {
            let field = ident(&table_field(program, configuration));
            write(&field, configuration)
        })
        .collect()
}
