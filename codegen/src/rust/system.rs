//! `System` for prepared models: what integrators ask for.

use proc_macro2::TokenStream;
use quote::quote;

use super::body::Writer;
use super::configuration;
use super::curve;
use super::expression::unsuffixed;

/// The implementation.
pub(super) fn system(writer: &Writer<'_>) -> TokenStream {
    let program = writer.program;
    let kink_count = unsuffixed(program.pass_kink.len());
    let event_count = unsuffixed(program.event_rows.len());
    let loop_count = unsuffixed(program.loop_names.len());
    let event_names: Vec<&str> = program.event_rows.iter().map(|e| e.name.as_str()).collect();
    let loop_names: Vec<&str> = program.loop_names.iter().map(String::as_str).collect();
    let stops = program
        .event_rows
        .iter()
        .enumerate()
        .filter_map(|(index, event)| {
            let index = unsuffixed(index);
            let reason = event.stop.as_deref()?;
            Some(quote!(#index => EventAction::Stop(Cow::Borrowed(#reason)),))
        });
    let tables = configuration::of_system(program);
    let curves = curve::of_system(writer);
    quote! {
        impl System for Prepared<f64> {
            fn states(&self) -> &[Variable] {
                STATES
            }
            fn discretes(&self) -> &[Variable] {
                DISCRETES
            }
            fn inputs(&self) -> &[Variable] {
                INPUTS
            }
            fn output_variables(&self) -> &[Variable] {
                OUTPUTS
            }
            fn start(&self, x: &mut [f64], d: &mut [f64]) {
                x.copy_from_slice(&self.start_states);
                d.copy_from_slice(&self.start_discretes);
            }
            #[inline]
            fn rhs(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], dx: &mut [f64]) {
                rhs(t, array(x), array(d), array(u), self, array_mut(dx));
            }
            fn jacobian(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], result: &mut [f64]) {
                result.fill(0.0);
                jacobian(t, array(x), array(d), array(u), self, array_mut(result));
            }
            fn outputs(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], result: &mut [f64]) {
                outputs(t, array(x), array(d), array(u), self, array_mut(result));
            }
            fn energy(&self, t: f64, x: &[f64], d: &[f64], u: &[f64]) -> Energy {
                let mut result = [0.0; 4];
                energy(t, array(x), array(d), array(u), self, &mut result);
                let [kinetic, potential, dissipated_power, supplied_power] = result;
                Energy { kinetic, potential, dissipated_power, supplied_power }
            }
            fn kink_count(&self) -> usize {
                #kink_count
            }
            fn next_kinks(&self, d: &[f64], times: &mut [f64]) {
                next_kinks(array(d), self, array_mut(times));
            }
            fn pass_kink(&self, index: usize, d: &mut [f64]) {
                let before = *array(d);
                pass_kink(index, &before, self, array_mut(d));
            }
            fn event_count(&self) -> usize {
                #event_count
            }
            fn events(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], values: &mut [f64]) {
                events(t, array(x), array(d), array(u), self, array_mut(values));
            }
            fn event_name(&self, index: usize) -> &str {
                const NAMES: [&str; #event_count] = [#(#event_names),*];
                NAMES[index]
            }
            fn pass_event(
                &self,
                index: usize,
                t: f64,
                x: &mut [f64],
                d: &mut [f64],
                u: &[f64],
            ) -> EventAction {
                let (x_before, d_before) = (*array(x), *array(d));
                let (x, d) = (array_mut(x), array_mut(d));
                pass_event(index, t, &x_before, &d_before, array(u), self, x, d);
                match index {
                    #(#stops)*
                    _ => EventAction::Continue,
                }
            }
            fn accept(&self, t: f64, x: &[f64], u: &[f64], d: &mut [f64]) {
                let before = *array(d);
                accept(t, array(x), &before, array(u), self, array_mut(d));
            }
            fn turning(&self) -> &[usize] {
                &TURNING
            }
            fn loop_count(&self) -> usize {
                #loop_count
            }
            fn closures(&self, t: f64, x: &[f64], d: &[f64], u: &[f64], values: &mut [f64]) {
                closures(t, array(x), array(d), array(u), self, array_mut(values));
            }
            fn loop_name(&self, index: usize) -> &str {
                const NAMES: [&str; #loop_count] = [#(#loop_names),*];
                NAMES[index]
            }
            #tables
            #curves
            fn take_plain_steps(&self, steps: &mut PlainSteps<'_>) {
                steps.on_lanes(self);
            }
        }
    }
}
