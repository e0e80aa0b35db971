//! Drives: waveforms, tables of samples, written-out functions of time.

use super::calls::{Given, Signature, Takes, optional, required};
use super::expression::{Scalar, Scope};
use super::names::Varies;
use super::{Reported, Resolved, Resolver, wanted};
use crate::model::{Drive, Waveform};
use crate::parts::waveforms;
use crate::symbolic::Expr;
use crate::syntax::tree::{Call, Declaration, ExpressionKind, File, ItemKind};
use crate::units::Dimension;

const FREQUENCY: Takes = Takes::Quantity(wanted::FREQUENCY);
const FRACTION: Takes = Takes::Quantity(wanted::NUMBER);
const TIME: Takes = Takes::Quantity(wanted::TIME);

/// All waveforms.
const WAVEFORMS: [Signature; 9] = [
    Signature {
        name: "sawtooth",
        parameters: &[
            required("stroke", Takes::Any),
            required("frequency", FREQUENCY),
            required("rise", FRACTION),
        ],
    },
    Signature {
        name: "triangle",
        parameters: &[
            required("stroke", Takes::Any),
            required("frequency", FREQUENCY),
        ],
    },
    Signature {
        name: "trapezoid",
        parameters: &[
            required("stroke", Takes::Any),
            required("frequency", FREQUENCY),
            required("rise", FRACTION),
            required("hold", FRACTION),
            required("fall", FRACTION),
        ],
    },
    Signature {
        name: "sine",
        parameters: &[
            required("amplitude", Takes::Any),
            required("frequency", FREQUENCY),
            optional("phase", Takes::Quantity(wanted::ANGLE)),
            optional("offset", Takes::LikeFirst),
        ],
    },
    Signature {
        name: "step",
        parameters: &[required("height", Takes::Any), required("at", TIME)],
    },
    Signature {
        name: "ramp",
        parameters: &[
            required("rate", Takes::Any),
            optional("start", TIME),
            optional("duration", TIME),
        ],
    },
    Signature {
        name: "chirp",
        parameters: &[
            required("amplitude", Takes::Any),
            required("from", FREQUENCY),
            required("to", FREQUENCY),
            required("duration", TIME),
        ],
    },
    Signature {
        name: "constant",
        parameters: &[required("value", Takes::Any)],
    },
    Signature {
        name: "table",
        parameters: &[
            required("file", Takes::Text),
            optional("value", Takes::Any),
            optional("time", TIME),
        ],
    },
];

/// Whether a name is that of a waveform.
pub(super) fn is_waveform(name: &str) -> bool {
    WAVEFORMS.iter().any(|signature| signature.name == name)
}

/// Most samples of a table.
const MOST_SAMPLES: usize = 1_000_000;

impl Resolver<'_> {
    pub(super) fn drives(&mut self, file: &File) {
        let mut declarations: Vec<&Declaration> = Vec::new();
        for item in &file.items {
            if let ItemKind::Drives(list) = &item.kind {
                declarations.extend(list);
            }
        }
        let Ok(order) = self.ordered(&declarations) else {
            return;
        };
        for index in order {
            let declaration = declarations[index];
            let Ok((waveform, dimension)) = self.waveform(declaration) else {
                continue;
            };
            let value = Scalar {
                expr: waveform.value,
                dimension,
                zero: false,
            };
            let Some(symbol) = self.quantity_symbol(declaration, value, Varies::Motion) else {
                continue;
            };
            self.model.drives.push(Drive {
                name: declaration.name.text.clone(),
                symbol,
                dimension,
                written: self.written(declaration.value.span),
                waveform,
                span: declaration.name.span,
            });
        }
    }

    fn waveform(&mut self, declaration: &Declaration) -> Resolved<(Waveform, Dimension)> {
        if let ExpressionKind::Call(call) = &declaration.value.kind
            && let Some(signature) = WAVEFORMS.iter().find(|s| s.name == call.name.text)
        {
            return self.named_waveform(&declaration.name.text, call, signature);
        }
        let scalar = self.scalar(&declaration.value, Scope::Motion)?;
        Ok((waveforms::constant(scalar.expr), scalar.dimension))
    }

    fn named_waveform(
        &mut self,
        name: &str,
        call: &Call,
        signature: &Signature,
    ) -> Resolved<(Waveform, Dimension)> {
        let given = self.arguments(call, signature, Scope::Params)?;
        if signature.name == "table" {
            return self.table(name, call, &given);
        }
        for (parameter, value) in signature.parameters.iter().zip(&given) {
            self.sensible(call, parameter.name, value)?;
        }
        let zero = self.model.graph.zero();
        let dimension = given
            .first()
            .and_then(Given::scalar)
            .map(|scalar| scalar.dimension)
            .ok_or(Reported)?;
        let optional = |index: usize| given.get(index).and_then(Given::scalar).map(|s| s.expr);
        let value = |index: usize| -> Expr { optional(index).unwrap_or(zero) };
        let (time, g) = (self.model.time, &mut self.model.graph);
        let waveform = match signature.name {
            "sawtooth" => waveforms::sawtooth(g, time, name, value(0), value(1), value(2)),
            "triangle" => waveforms::triangle(g, time, name, value(0), value(1)),
            "trapezoid" => {
                let shares = (value(2), value(3), value(4));
                waveforms::trapezoid(
                    g,
                    time,
                    name,
                    value(0),
                    value(1),
                    shares.0,
                    shares.1,
                    shares.2,
                )
            }
            "sine" => waveforms::sine(g, time, value(0), value(1), value(2), value(3)),
            "step" => waveforms::step(g, name, value(0), value(1)),
            "ramp" => waveforms::ramp(g, time, name, value(0), value(1), optional(2)),
            "chirp" => waveforms::chirp(g, time, name, value(0), value(1), value(2), value(3)),
            _ => waveforms::constant(value(0)),
        };
        let dimension = if signature.name == "ramp" {
            dimension.times(Dimension::TIME).ok_or(Reported)?
        } else {
            dimension
        };
        Ok((waveform, dimension))
    }

    /// Refuses written numbers that no waveform can have.
    fn sensible(&mut self, call: &Call, parameter: &str, value: &Given) -> Resolved<()> {
        let Some(scalar) = value.scalar() else {
            return Ok(());
        };
        let Some(number) = self.model.graph.as_number(scalar.expr).cloned() else {
            return Ok(());
        };
        let zero = crate::symbolic::Rational::from_integer(0.into());
        let one = crate::symbolic::Rational::from_integer(1.into());
        let (wrong, hint) = match parameter {
            "frequency" | "duration" if number <= zero => (
                "must be positive",
                "write a value above zero, or `constant(…)` for a drive that stands still",
            ),
            "from" | "to" | "start" if number < zero => {
                ("cannot be negative", "write zero or a value above it")
            }
            "rise" | "hold" | "fall" if number < zero || number > one => (
                "is a share of the period, between 0 and 1",
                "divide the time that it takes by the period, as in `rise = 0.95`",
            ),
            _ => return Ok(()),
        };
        let argument = call.arguments.iter().find(|argument| {
            argument
                .name
                .as_ref()
                .is_some_and(|name| name.text == parameter)
        });
        let span = argument.map_or(call.name.span, |argument| argument.value.span);
        let message = format!("`{parameter}` of `{}` {wrong}", call.name.text);
        Err(self.error(span, message, hint))
    }

    /// A table of samples in a file: two columns, time and value, times the units that were given.
    fn table(
        &mut self,
        name: &str,
        call: &Call,
        given: &[Given],
    ) -> Resolved<(Waveform, Dimension)> {
        let Some(Given::Text(path)) = given.first() else {
            return Err(Reported);
        };
        let span = call
            .arguments
            .first()
            .map_or(call.name.span, |a| a.value.span);
        let text = match (self.files)(path) {
            Ok(text) => text,
            Err(reason) => {
                let message = format!("`{path}` cannot be read: {reason}");
                let hint = "the path is relative to the model file";
                return Err(self.error(span, message, hint));
            }
        };
        if !self.model.files.contains(path) {
            self.model.files.push(path.clone());
        }
        let samples = match samples(&text) {
            Ok(samples) => samples,
            Err(message) => {
                let hint = "a table has two columns, time and value, separated by a comma, \
                            with times that grow; a first line of words is skipped";
                return Err(self.error(span, format!("`{path}`, {message}"), hint));
            }
        };
        let scale = |index: usize| given.get(index).and_then(Given::scalar);
        let time_scale = match scale(2) {
            None => 1.0,
            Some(scalar) => self.constant(scalar.expr).ok_or(Reported).map_err(|_| {
                let hint = "write `time = 1 ms` for times in milliseconds";
                self.error(
                    call.name.span,
                    "the unit of `time` is written in numbers",
                    hint,
                )
            })?,
        };
        let samples: Vec<(f64, f64)> = samples
            .into_iter()
            .map(|(time, value)| (time * time_scale, value))
            .collect();
        let (g, time) = (&mut self.model.graph, self.model.time);
        let Some(mut waveform) = waveforms::table(g, time, name, &samples) else {
            let hint = "a table has at least one sample, with finite values and times that grow";
            return Err(self.error(span, format!("`{path}` is no usable table"), hint));
        };
        let dimension = match scale(1) {
            None => Dimension::NONE,
            Some(scalar) => {
                waveform.value = self.model.graph.mul(waveform.value, scalar.expr);
                scalar.dimension
            }
        };
        Ok((waveform, dimension))
    }

    fn constant(&self, expr: Expr) -> Option<f64> {
        use num_traits::ToPrimitive;
        self.model.graph.as_number(expr)?.to_f64()
    }
}

/// Reads two columns of numbers; the error names the line.
fn samples(text: &str) -> Result<Vec<(f64, f64)>, String> {
    let mut samples = Vec::new();
    for (index, line) in text.trim_start_matches('\u{FEFF}').lines().enumerate() {
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let mut columns = line
            .split([',', ';', '\t'])
            .map(|column| column.trim().parse::<f64>());
        match (columns.next(), columns.next()) {
            (Some(Ok(time)), Some(Ok(value))) if time.is_finite() && value.is_finite() => {
                if samples.last().is_some_and(|&(last, _)| time <= last) {
                    return Err(format!("line {}: times must grow", index + 1));
                }
                samples.push((time, value));
            }
            _ if samples.is_empty() && index == 0 => {}
            _ => return Err(format!("line {}: two numbers are expected", index + 1)),
        }
        if samples.len() > MOST_SAMPLES {
            return Err(format!("more than {MOST_SAMPLES} samples"));
        }
    }
    if samples.is_empty() {
        return Err("it holds no samples".to_owned());
    }
    Ok(samples)
}
