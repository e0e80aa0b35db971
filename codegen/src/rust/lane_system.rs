//! `LaneSystem` for prepared models: several parameter sets side by side.

use proc_macro2::TokenStream;
use quote::quote;

use super::body::Writer;
use super::expression::unsuffixed;
use super::{configuration, curve};

/// The implementation, by the functions that are generic over numbers anyway.
pub(super) fn lane_system(writer: &Writer<'_>) -> TokenStream {
    let program = writer.program;
    let states = unsuffixed(program.states.len());
    let discretes = unsuffixed(program.discretes.len());
    let loops = unsuffixed(program.loop_names.len());
    let events = unsuffixed(program.event_rows.len());
    let tables = configuration::of_lane_system(program);
    let fitted = curve::fitted(writer);
    let alone = (!fitted.is_empty()).then(|| {
        quote! {
            fn alone<L: Lanes>(&self) -> Prepared<L> {
                Prepared { #fitted ..self.map(L::from_f64) }
            }
        }
    });
    let functions = [quote!(rhs), quote!(events), quote!(closures)];
    let in_lanes = [
        quote!(rhs_in_lanes),
        quote!(events_in_lanes),
        quote!(closures_in_lanes),
    ];
    quote! {
        impl LaneSystem for Prepared<f64> {
            type InLanes<L: Lanes> = Prepared<L>;
            type States<L: Lanes> = [L; #states];
            type Discretes<L: Lanes> = [L; #discretes];
            type Loops<L: Lanes> = [L; #loops];
            type Events<L: Lanes> = [L; #events];

            fn in_every_lane<L: Lanes>(&self) -> Prepared<L> {
                self.map(L::from_f64)
            }
            #alone
            fn put_in_lane<L: Lanes>(&self, lane: usize, lanes: &mut Prepared<L>) {
                *lanes = lanes.zip(self, |mut number: L, value: f64| {
                    number.set_entry(lane, value);
                    number
                });
            }
            #[inline(always)]
            fn accept_in_lanes<L: Lanes>(
                lanes: &Prepared<L>,
                t: L,
                x: &[L],
                u: &[L],
                d: &mut [L],
            ) {
                let before = *array(d);
                accept(t, array(x), &before, array(u), lanes, array_mut(d));
            }
            #(
                #[inline(always)]
                fn #in_lanes<L: Lanes>(
                    lanes: &Prepared<L>,
                    t: L,
                    x: &[L],
                    d: &[L],
                    u: &[L],
                    result: &mut [L],
                ) {
                    #functions(t, array(x), array(d), array(u), lanes, array_mut(result));
                }
            )*
            #tables
        }
    }
}
