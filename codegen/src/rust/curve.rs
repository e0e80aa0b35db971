//! Curves: closed forms of functions of one quantity, and the curves that stand for them where one
//! trajectory runs alone.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::body::{Body, Writer};
use super::expression::ident;
use crate::program::Curve;
use crate::schedule::order;
use crate::values::Stage;

/// What curve `index` is called, by what it gives and what it is a function of.
struct Names {
    given: String,
    pivot: String,
}

fn names(writer: &Writer<'_>, index: usize, curve: &Curve) -> Names {
    let of = |value, otherwise: String| {
        let name = writer.described.name(value);
        name.map_or(otherwise, str::to_owned)
    };
    Names {
        given: of(curve.closed_form, format!("function{}", index + 1)),
        pivot: of(curve.pivot, format!("argument{}", index + 1)),
    }
}

/// Name of the function that has the closed form: `per_g_v_of_v`.
pub(super) fn function_name(writer: &Writer<'_>, index: usize, curve: &Curve) -> String {
    let Names { given, pivot } = names(writer, index, curve);
    format!("{given}_of_{pivot}")
}

/// Name of the field of `Prepared` that has the curve: `curve_of_per_g_v`.
pub(super) fn field_name(writer: &Writer<'_>, index: usize) -> String {
    let curve = &writer.program.compiled.curves[index];
    format!("curve_of_{}", names(writer, index, curve).given)
}

/// The closed forms.
pub(super) fn functions(writer: &Writer<'_>) -> TokenStream {
    let program = writer.program;
    each(writer, |index, curve| {
        let name = ident(&function_name(writer, index, curve));
        let Names { given, pivot } = names(writer, index, curve);
        let doc =
            format!(" `{given}`, which depends on `{pivot}` and params alone, in closed form.");
        let mut body = Body::of_state(writer);
        let argument = ident(&body.name(curve.pivot, &pivot));
        let order = order(&program.values, [curve.closed_form], |value| {
            program.values.stage(value) >= Stage::State && value != curve.pivot
        });
        body.compute(&order, &[curve.closed_form]);
        let result = body.number_tokens(curve.closed_form);
        let statements = body.finish();
        quote! {
            #[doc = #doc]
            #[inline(always)]
            pub fn #name<T: Real>(#argument: T, p: &Prepared<T>) -> T {
                #(#statements)*
                #result
            }
        }
    })
}

/// In `rhs`: the value of curve `index`, by the curve or in closed form.
pub(super) fn value(writer: &Writer<'_>, index: usize, argument: &TokenStream) -> TokenStream {
    let curve = &writer.program.compiled.curves[index];
    let field = ident(&field_name(writer, index));
    let function = ident(&function_name(writer, index, curve));
    quote! {
        match p.#field.at(#argument) {
            Some(value) => value,
            None => #function(#argument, p),
        }
    }
}

/// Fields of `Prepared`.
pub(super) fn fields(writer: &Writer<'_>) -> TokenStream {
    each_field(writer, |field, function| {
        let doc = format!(" [`{function}`] for a trajectory alone; fitted by `LaneSystem::alone`.");
        quote!(#[doc = #doc] pub #field: Curve,)
    })
}

/// The fields in lanes or without curves.
pub(super) fn none(writer: &Writer<'_>) -> TokenStream {
    each_field(writer, |field, _| quote!(#field: Curve::none(),))
}

/// The fields as `prepare` makes them.
pub(super) fn wanted(writer: &Writer<'_>) -> TokenStream {
    each_field(writer, |field, _| quote!(#field: Curve::wanted(),))
}

/// The fields for one trajectory alone.
pub(super) fn fitted(writer: &Writer<'_>) -> TokenStream {
    each_field(writer, |field, function| {
        let function = ident(function);
        quote!(#field: self.#field.fitted(|argument| #function(argument, self)),)
    })
}

/// The function of `System` on curves; nothing where there are none.
pub(super) fn of_system(writer: &Writer<'_>) -> TokenStream {
    if writer.program.compiled.curves.is_empty() {
        return quote!();
    }
    let rows = each(writer, |index, curve| {
        let pivot = names(writer, index, curve).pivot;
        let field = ident(&field_name(writer, index));
        quote!((#pivot, alone.#field.report()),)
    });
    quote! {
        fn curves(&self) -> Vec<(&str, CurveReport)> {
            let alone: Prepared<f64> = self.alone();
            let rows = [#rows].into_iter();
            rows.filter_map(|(name, report)| Some((name, report?))).collect()
        }
    }
}

fn each(writer: &Writer<'_>, write: impl Fn(usize, &Curve) -> TokenStream) -> TokenStream {
    let curves = writer.program.compiled.curves.iter().enumerate();
    curves.map(|(index, curve)| write(index, curve)).collect()
}

fn each_field(writer: &Writer<'_>, write: impl Fn(&Ident, &str) -> TokenStream) -> TokenStream {
    each(writer, |index, curve| {
        let field = ident(&field_name(writer, index));
        write(&field, &function_name(writer, index, curve))
    })
}
