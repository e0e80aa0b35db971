//! Whether values have the dimensions that their places want, and that they share.

use super::expression::Scalar;
use super::wanted::Wanted;
use super::{Reported, Resolved, Resolver};
use crate::source::Span;
use crate::units::Mark;

impl Resolver<'_> {
    /// Checks that a value has the wanted dimension.
    pub(super) fn fits(
        &mut self,
        scalar: Scalar,
        wanted: Wanted,
        what: &str,
        span: Span,
    ) -> Resolved<()> {
        if scalar.zero {
            return Ok(());
        }
        let (have, want) = (scalar.dimension, wanted.dimension);
        if !have.same_units(want) {
            let is_number = self.model.graph.as_number(scalar.expr).is_some();
            let (found, hint) = match (have.is_none(), is_number) {
                (true, true) => (
                    "a number without a unit".to_owned(),
                    format!("write it in `{}`", unit_of(wanted)),
                ),
                (false, true) if !want.is_none() => (
                    have.described(),
                    format!("write it in `{}`", unit_of(wanted)),
                ),
                _ => (
                    have.described(),
                    "check the dimensions of what it is made of".to_owned(),
                ),
            };
            let message = format!("{what} wants {}, not {found}", wanted.words);
            return Err(self.error(span, message, hint));
        }
        match (have.mark(), want.mark()) {
            (Mark::Frequency, Mark::AngularRate) => Err(self.error(
                span,
                format!("{what} wants {}, not a frequency in Hz", wanted.words),
                "a frequency f turns at `2*pi*f`; write the rate in rad/s or deg/s",
            )),
            (Mark::AngularRate, Mark::Frequency) => Err(self.error(
                span,
                format!(
                    "{what} wants {}, not an angular rate in rad/s",
                    wanted.words
                ),
                "an angular rate w repeats `w/(2*pi)` times per second; write the frequency in Hz",
            )),
            _ => Ok(()),
        }
    }

    /// The common dimension of two values that are added, compared or chosen from.
    pub(super) fn together(
        &mut self,
        a: Scalar,
        a_span: Span,
        b: Scalar,
        b_span: Span,
    ) -> Resolved<Scalar> {
        if a.zero {
            return Ok(b);
        }
        if b.zero {
            return Ok(a);
        }
        let mismatch = !a.dimension.same_units(b.dimension);
        let marks = (a.dimension.mark(), b.dimension.mark());
        let mixed = matches!(
            marks,
            (Mark::Frequency, Mark::AngularRate) | (Mark::AngularRate, Mark::Frequency)
        );
        if mismatch || mixed {
            let (first, second) = (a.dimension.described(), b.dimension.described());
            let hint = if mixed {
                "a frequency f is an angular rate of `2*pi*f`"
            } else {
                "only quantities of one kind can be added, compared or chosen from"
            };
            let diagnostic = self
                .diagnostic(b_span, format!("this is {second}, beside {first}"))
                .hint(hint)
                .related(self.site(a_span), first);
            self.report(b_span, diagnostic);
            return Err(Reported);
        }
        Ok(if marks.0 == Mark::Plain { b } else { a })
    }
}

/// The unit in the words of what is wanted.
fn unit_of(wanted: Wanted) -> &'static str {
    wanted
        .words
        .rsplit_once('(')
        .map_or("m", |(_, unit)| unit.trim_end_matches(')'))
}
