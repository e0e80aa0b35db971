//! A module with nothing in it: what stands beside an error, so that one mistake is one error.

use proc_macro2::TokenStream;
use quote::quote;

use super::expression::{ident, unsuffixed};
use super::items::METHODS;
use super::{allowed, module_name};

/// A module of that name with the items that every generated module has, so that code that uses
/// them does not fail as well. `params` and `sets` are the names that could be read.
pub fn skeleton(
    model: &str,
    params: &[String],
    sets: &[String],
    runtime: &TokenStream,
) -> TokenStream {
    let name = ident(&module_name(model));
    let allowed = allowed();
    let mut namer = crate::names::Namer::default();
    let fields: Vec<_> = params
        .iter()
        .map(|param| ident(&namer.name(param)))
        .collect();
    let mut namer = crate::names::Namer::without(&METHODS);
    let sets: Vec<_> = sets.iter().map(|set| ident(&namer.name(set))).collect();
    let count = unsuffixed(fields.len());
    let positions = (0..fields.len()).map(unsuffixed);
    quote! {
        #allowed
        #[doc = " Stands in for a model that has an error."]
        pub mod #name {
            use #runtime::diagnostic::Diagnostic;
            use #runtime::lanes::{LaneSystem, Lanes};
            use #runtime::system::{Energy, EventAction, System, Variable};

            /// What may be set.
            #[derive(Clone, Debug, Default, PartialEq)]
            pub struct Params {
                #(#[doc = ""] pub #fields: f64,)*
            }

            impl Params {
                #(#[doc = ""] pub fn #sets() -> Self { Self::default() })*

                /// The values.
                pub fn values(&self) -> [f64; #count] {
                    [#(self.#fields),*]
                }

                /// Params of values.
                pub fn from_values(values: [f64; #count]) -> Self {

                    Self { #(#fields: values[#positions]),* }
                }

                /// Nothing can be prepared.
                pub fn prepare(&self) -> Result<Prepared<f64>, Diagnostic> {
                    Err(Diagnostic::error("the model has an error"))
                }
            }

            /// What would be prepared.
            #[derive(Clone, Debug)]
            pub struct Prepared<T> {
                number: T,
            }

            impl Prepared<f64> {
                /// The same.
                pub fn exact(self) -> Self { self }
            }

            /// Every quantity with a name.
            pub static VARIABLES: [Variable; 0] = [];
            /// The equations of motion in plain text.
            pub const EQUATIONS: &str = "";
            /// The equations of motion in LaTeX.
            pub const EQUATIONS_LATEX: &str = "";

            impl System for Prepared<f64> {
                fn states(&self) -> &[Variable] { &[] }
                fn discretes(&self) -> &[Variable] { &[] }
                fn inputs(&self) -> &[Variable] { &[] }
                fn output_variables(&self) -> &[Variable] { &[] }
                fn start(&self, _: &mut [f64], _: &mut [f64]) {}
                fn rhs(&self, _: f64, _: &[f64], _: &[f64], _: &[f64], _: &mut [f64]) {}
                fn jacobian(&self, _: f64, _: &[f64], _: &[f64], _: &[f64], _: &mut [f64]) {}
                fn outputs(&self, _: f64, _: &[f64], _: &[f64], _: &[f64], _: &mut [f64]) {}
                fn energy(&self, _: f64, _: &[f64], _: &[f64], _: &[f64]) -> Energy {
                    Energy::default()
                }
                fn kink_count(&self) -> usize { 0 }
                fn next_kinks(&self, _: &[f64], _: &mut [f64]) {}
                fn pass_kink(&self, _: usize, _: &mut [f64]) {}
                fn event_count(&self) -> usize { 0 }
                fn events(&self, _: f64, _: &[f64], _: &[f64], _: &[f64], _: &mut [f64]) {}
                fn event_name(&self, _: usize) -> &str { "" }
                fn pass_event(
                    &self,
                    _: usize,
                    _: f64,
                    _: &mut [f64],
                    _: &mut [f64],
                    _: &[f64],
                ) -> EventAction {
                    EventAction::Continue
                }
                fn accept(&self, _: f64, _: &[f64], _: &[f64], _: &mut [f64]) {}
                fn turning(&self) -> &[usize] { &[] }
                fn loop_count(&self) -> usize { 0 }
                fn closures(&self, _: f64, _: &[f64], _: &[f64], _: &[f64], _: &mut [f64]) {}
                fn loop_name(&self, _: usize) -> &str { "" }
            }

            impl LaneSystem for Prepared<f64> {
                type InLanes<L: Lanes> = ();
                type States<L: Lanes> = [L; 0];
                type Discretes<L: Lanes> = [L; 0];
                type Loops<L: Lanes> = [L; 0];
                type Events<L: Lanes> = [L; 0];
                fn in_every_lane<L: Lanes>(&self) {}
                fn put_in_lane<L: Lanes>(&self, _: usize, _: &mut ()) {}
                fn rhs_in_lanes<L: Lanes>(_: &(), _: L, _: &[L], _: &[L], _: &[L], _: &mut [L]) {}
                fn accept_in_lanes<L: Lanes>(_: &(), _: L, _: &[L], _: &[L], _: &mut [L]) {}
                fn events_in_lanes<L: Lanes>(
                    _: &(), _: L, _: &[L], _: &[L], _: &[L], _: &mut [L],
                ) {}
                fn closures_in_lanes<L: Lanes>(
                    _: &(), _: L, _: &[L], _: &[L], _: &[L], _: &mut [L],
                ) {}
            }
        }
    }
}
