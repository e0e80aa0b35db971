//! Waveforms of drives: functions of time in smooth pieces that end at exactly known times.
//!
//! Which piece holds is remembered, not computed from time, so that a step that ends at a kink
//! sees one piece alone. Two builders carry all of them: `periodic` for pieces that repeat and
//! `once` for pieces that do not.
//!
//! Arguments are expressions of params. What must hold of them (a frequency above zero, fractions
//! within a period) is handed on as the waveform's conditions. A quantity is in the unit of the
//! drive, times are in s, frequencies in Hz, phases in rad, fractions of a period in 0..1.

use num_traits::One;

use crate::model::{Condition, Memory, Waveform, WaveformKink};
use crate::notation::latex_of;
use crate::symbolic::{Expr, Function, Graph, Rational, Symbol};

// ── Periodic waveforms ─────────────────────────────────────────────────────────────────────────

/// A slow rise from 0 to `stroke` over the fraction `rise` of each period, then a fast return; it
/// starts at 0 at t = 0. With a `rise` of exactly 0 or 1 it jumps once a period.
pub fn sawtooth(
    g: &mut Graph,
    time: Symbol,
    name: &str,
    stroke: Expr,
    frequency: Expr,
    rise: Expr,
) -> Waveform {
    let (zero, one) = (g.zero(), g.one());
    let fall = g.sub(one, rise);
    let pieces = [
        Piece::new(rise, zero, stroke),
        Piece::new(fall, stroke, zero),
    ];
    let mut waveform = periodic(g, time, name, "falling", frequency, &pieces);
    waveform.conditions.extend([
        fraction(rise, "the `rise` of the sawtooth"),
        Condition {
            margin: fall,
            ..fraction(rise, "the `rise` of the sawtooth")
        },
    ]);
    waveform
}

/// From 0 to `stroke` and back in equal times; it starts at 0 at t = 0.
pub fn triangle(
    g: &mut Graph,
    time: Symbol,
    name: &str,
    stroke: Expr,
    frequency: Expr,
) -> Waveform {
    let (zero, half) = (g.zero(), g.ratio(1, 2));
    let pieces = [
        Piece::new(half, zero, stroke),
        Piece::new(half, stroke, zero),
    ];
    periodic(g, time, name, "falling", frequency, &pieces)
}

/// Up from 0 to `stroke` in the fraction `rise` of a period, held there for `hold`, down within
/// `fall`, and at 0 for the rest of the period. Fractions of exactly 0 make it jump.
#[allow(clippy::too_many_arguments, reason = "the waveform has as many")]
pub fn trapezoid(
    g: &mut Graph,
    time: Symbol,
    name: &str,
    stroke: Expr,
    frequency: Expr,
    rise: Expr,
    hold: Expr,
    fall: Expr,
) -> Waveform {
    let (zero, one) = (g.zero(), g.one());
    let moving = g.sum(&[rise, hold, fall]);
    let rest = g.sub(one, moving);
    let pieces = [
        Piece::new(rise, zero, stroke),
        Piece::new(hold, stroke, stroke),
        Piece::new(fall, stroke, zero),
        Piece::new(rest, zero, zero),
    ];
    let mut waveform = periodic(g, time, name, "phase", frequency, &pieces);
    waveform.conditions.extend([
        fraction(rise, "the `rise` of the trapezoid"),
        fraction(hold, "the `hold` of the trapezoid"),
        fraction(fall, "the `fall` of the trapezoid"),
        Condition {
            margin: rest,
            hint: "together they must not exceed 1, a whole period".to_owned(),
            ..fraction(moving, "the sum of `rise`, `hold` and `fall`")
        },
    ]);
    waveform
}

/// A line from one level to another over a fraction of a period.
struct Piece {
    span: Expr,
    from: Expr,
    to: Expr,
}

impl Piece {
    fn new(span: Expr, from: Expr, to: Expr) -> Self {
        Self { span, from, to }
    }
}

/// Lines that repeat with `frequency`; their spans add up to 1. Pieces without extent are passed
/// over, so that no two kinks coincide.
fn periodic(
    g: &mut Graph,
    time: Symbol,
    name: &str,
    place: &str,
    frequency: Expr,
    pieces: &[Piece],
) -> Waveform {
    let (zero, one) = (g.zero(), g.one());
    let cycle = symbol(g, name, "cycle");
    let piece = symbol(g, name, place);
    let (n, at) = (g.of(cycle), g.of(piece));
    let phase = {
        let t = g.of(time);
        let turns = g.mul(t, frequency);
        g.sub(turns, n)
    };

    let mut values = Vec::new();
    let mut ends = Vec::new();
    let mut start = zero;
    for (index, Piece { span, from, to }) in pieces.iter().enumerate() {
        let end = if index + 1 == pieces.len() {
            one
        } else {
            g.add(start, *span)
        };
        // Counted from the end where the piece comes down to zero, from its start otherwise.
        let value = if g.is_zero(*to) && !g.is_zero(*from) {
            let left = g.sub(end, phase);
            line(g, *from, left, *span)
        } else if from == to {
            *from
        } else {
            let gone = g.sub(phase, start);
            let rise = g.sub(*to, *from);
            let climbed = line(g, rise, gone, *span);
            g.add(*from, climbed)
        };
        values.push(value);
        let turns = g.add(n, end);
        ends.push(g.div(turns, frequency));
        start = end;
    }

    let spans: Vec<Expr> = pieces.iter().map(|piece| piece.span).collect();
    let first = first_with_extent(g, &spans, 0, zero);
    let next_cycle = g.add(n, one);
    let mut next_pieces = Vec::new();
    let mut next_cycles = Vec::new();
    for index in 0..pieces.len() {
        next_pieces.push(first_with_extent(g, &spans, index + 1, first));
        let mut cycle = next_cycle;
        for &span in spans[index + 1..].iter().rev() {
            cycle = g.function(Function::IfPositive, &[span, n, cycle]);
        }
        next_cycles.push(cycle);
    }

    // A jump is one that is written: where a level changes within no time at all.
    let jumps = pieces
        .iter()
        .any(|piece| g.is_zero(piece.span) && piece.from != piece.to);
    Waveform {
        value: choose(g, at, &values),
        kink: Some(WaveformKink {
            next: choose(g, at, &ends),
            updates: vec![choose(g, at, &next_cycles), choose(g, at, &next_pieces)],
            jumps,
        }),
        memory: vec![memory("cycle", cycle, zero), memory(place, piece, first)],
        full: pieces
            .iter()
            .map(|piece| piece.to)
            .find(|to| !g.is_zero(*to)),
        conditions: vec![Condition::above_zero(frequency, "the frequency").in_unit("Hz")],
        frequency: Some(frequency),
    }
}

/// The number of the first piece from `start` on that has an extent, or `otherwise`.
fn first_with_extent(g: &mut Graph, spans: &[Expr], start: usize, otherwise: Expr) -> Expr {
    let mut found = otherwise;
    for (index, &span) in spans.iter().enumerate().skip(start).rev() {
        let number = whole(g, index);
        found = g.function(Function::IfPositive, &[span, number, found]);
    }
    found
}

/// `rise · gone / span`; a piece without extent is never reached and counts as zero.
fn line(g: &mut Graph, rise: Expr, gone: Expr, span: Expr) -> Expr {
    if g.is_zero(span) {
        return g.zero();
    }
    let height = g.mul(rise, gone);
    g.div(height, span)
}

/// The entry of `values` whose number is `at`, by halves: no number is compared for equality.
fn choose(g: &mut Graph, at: Expr, values: &[Expr]) -> Expr {
    let mut chosen = values[0];
    for (index, &value) in values.iter().enumerate().skip(1) {
        let threshold = g.ratio(2 * index as i64 - 1, 2);
        let beyond = g.sub(at, threshold);
        chosen = g.function(Function::IfPositive, &[beyond, value, chosen]);
    }
    chosen
}

// ── Smooth waveforms ───────────────────────────────────────────────────────────────────────────

/// A constant.
pub fn constant(value: Expr) -> Waveform {
    smooth(value)
}

/// `offset + amplitude sin(2π frequency t + phase)`.
pub fn sine(
    g: &mut Graph,
    time: Symbol,
    amplitude: Expr,
    frequency: Expr,
    phase: Expr,
    offset: Expr,
) -> Waveform {
    let (t, two, pi) = (g.of(time), g.integer(2), g.pi());
    let turned = g.product(&[two, pi, frequency, t]);
    let angle = g.add(turned, phase);
    let sine = g.sin(angle);
    let swing = g.mul(amplitude, sine);
    Waveform {
        full: Some(g.add(offset, amplitude)),
        conditions: vec![Condition::not_below_zero(frequency, "the frequency").in_unit("Hz")],
        frequency: Some(frequency),
        ..smooth(g.add(offset, swing))
    }
}

fn smooth(value: Expr) -> Waveform {
    Waveform {
        memory: Vec::new(),
        value,
        kink: None,
        full: None,
        conditions: Vec::new(),
        frequency: None,
    }
}

// ── Waveforms that happen once ─────────────────────────────────────────────────────────────────

/// 0 before the time `at`, `height` from then on.
pub fn step(g: &mut Graph, name: &str, height: Expr, at: Expr) -> Waveform {
    let zero = g.zero();
    Waveform {
        full: Some(height),
        ..once(g, name, &[zero, height], &[at], true)
    }
}

/// 0 before the time `start`, then growing by `rate` per second: for `duration` seconds, after
/// which it holds, or for ever.
pub fn ramp(
    g: &mut Graph,
    time: Symbol,
    name: &str,
    rate: Expr,
    start: Expr,
    duration: Option<Expr>,
) -> Waveform {
    let (zero, t) = (g.zero(), g.of(time));
    let gone = g.sub(t, start);
    let rising = g.mul(rate, gone);
    let Some(duration) = duration else {
        return once(g, name, &[zero, rising], &[start], false);
    };
    let end = g.add(start, duration);
    let top = g.mul(rate, duration);
    let mut waveform = once(g, name, &[zero, rising, top], &[start, end], false);
    waveform.full = Some(top);
    waveform.conditions.push(Condition::not_below_zero(
        duration,
        "the `duration` of the ramp",
    ));
    waveform
}

/// A sine whose frequency grows linearly from `from` to `to` within `duration` seconds and stays
/// there. It starts at 0 at t = 0; value and rate are continuous.
#[allow(clippy::too_many_arguments, reason = "the waveform has as many")]
pub fn chirp(
    g: &mut Graph,
    time: Symbol,
    name: &str,
    amplitude: Expr,
    from: Expr,
    to: Expr,
    duration: Expr,
) -> Waveform {
    let (t, two, pi) = (g.of(time), g.integer(2), g.pi());
    let sweeping = {
        let growth = g.sub(to, from);
        let square = g.powi(t, 2);
        let gained = g.mul(growth, square);
        let double = g.mul(two, duration);
        let curved = g.div(gained, double);
        let straight = g.mul(from, t);
        g.add(straight, curved)
    };
    let steady = {
        let sum = g.add(from, to);
        let swept = g.mul(sum, duration);
        let swept = g.div(swept, two);
        let left = g.sub(t, duration);
        let gone = g.mul(to, left);
        g.add(swept, gone)
    };
    let [sweeping, steady] = [sweeping, steady].map(|turns| {
        let angle = g.product(&[two, pi, turns]);
        let sine = g.sin(angle);
        g.mul(amplitude, sine)
    });
    let mut waveform = once(g, name, &[sweeping, steady], &[duration], false);
    waveform.conditions.extend([
        Condition::above_zero(duration, "the `duration` of the chirp").in_unit("s"),
        Condition::not_below_zero(from, "the frequency `from` of the chirp").in_unit("Hz"),
        Condition::not_below_zero(to, "the frequency `to` of the chirp").in_unit("Hz"),
    ]);
    waveform
}

/// Pieces that do not repeat: `values[k]` holds until `ends[k]`, the last for ever. Pieces without
/// extent, or that end before t = 0, are passed over.
fn once(g: &mut Graph, name: &str, values: &[Expr], ends: &[Expr], jumps: bool) -> Waveform {
    let piece = symbol(g, name, "piece");
    let at = g.of(piece);
    let last = whole(g, ends.len());
    let mut initial = last;
    for (index, &end) in ends.iter().enumerate().rev() {
        let number = whole(g, index);
        initial = g.function(Function::IfPositive, &[end, number, initial]);
    }
    let mut following = Vec::new();
    let mut times = ends.to_vec();
    for (index, &end) in ends.iter().enumerate() {
        let mut next = last;
        for (later, &later_end) in ends.iter().enumerate().skip(index + 1).rev() {
            let (number, left) = (whole(g, later), g.sub(later_end, end));
            next = g.function(Function::IfPositive, &[left, number, next]);
        }
        following.push(next);
    }
    following.push(last);
    times.push(never(g));
    Waveform {
        value: choose(g, at, values),
        kink: Some(WaveformKink {
            next: choose(g, at, &times),
            updates: vec![choose(g, at, &following)],
            jumps,
        }),
        memory: vec![memory("piece", piece, initial)],
        full: None,
        conditions: Vec::new(),
        frequency: None,
    }
}

/// Straight lines through samples (time in s, value), held before the first and after the last.
/// Two samples at one time make a jump.
///
/// `None` if there is no sample, if times decrease, or if a number or a slope is not finite.
pub fn table(g: &mut Graph, time: Symbol, name: &str, samples: &[(f64, f64)]) -> Option<Waveform> {
    let pieces = table_pieces(samples)?;
    let start = pieces.iter().position(|piece| piece.end > 0.0)?;

    let [place, from, level, slope] =
        ["piece", "from", "level", "slope"].map(|what| symbol(g, name, what));
    let index = {
        let at = g.of(place);
        let one = g.one();
        g.add(at, one)
    };
    let column = |g: &mut Graph, read: fn(&TablePiece) -> f64, at: Expr| {
        let lookup = g.table(pieces.iter().map(read).collect());
        g.function(lookup, &[at])
    };
    let updates = vec![
        index,
        column(g, |piece| piece.from, index),
        column(g, |piece| piece.level, index),
        column(g, |piece| piece.slope, index),
    ];
    let at = g.of(place);
    let next = column(g, |piece| piece.end, at);

    let value = {
        let (t, from, level, slope) = (g.of(time), g.of(from), g.of(level), g.of(slope));
        let gone = g.sub(t, from);
        let climbed = g.mul(slope, gone);
        g.add(level, climbed)
    };
    let first = pieces[start];
    let memory = vec![
        memory("piece", place, whole(g, start)),
        memory("from", from, g.decimal(first.from)?),
        memory("level", level, g.decimal(first.level)?),
        memory("slope", slope, g.decimal(first.slope)?),
    ];
    let jumps = samples
        .windows(2)
        .any(|pair| pair[0].0 == pair[1].0 && pair[0].1 != pair[1].1);
    Some(Waveform {
        memory,
        value,
        kink: Some(WaveformKink {
            next,
            updates,
            jumps,
        }),
        full: None,
        conditions: Vec::new(),
        frequency: None,
    })
}

/// A line from (`from`, `level`) on, until `end`.
#[derive(Clone, Copy)]
struct TablePiece {
    from: f64,
    level: f64,
    slope: f64,
    end: f64,
}

fn table_pieces(samples: &[(f64, f64)]) -> Option<Vec<TablePiece>> {
    let flat = |(time, value): (f64, f64), end| TablePiece {
        from: time,
        level: value,
        slope: 0.0,
        end,
    };
    let (first, last) = (*samples.first()?, *samples.last()?);
    let mut pieces = vec![flat(first, first.0)];
    for pair in samples.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        if b.0 < a.0 {
            return None;
        }
        if b.0 > a.0 {
            pieces.push(TablePiece {
                slope: (b.1 - a.1) / (b.0 - a.0),
                ..flat(a, b.0)
            });
        }
    }
    pieces.push(flat(last, Waveform::NEVER));
    let finite = |piece: &TablePiece| {
        [piece.from, piece.level, piece.slope, piece.end]
            .iter()
            .all(|number| number.is_finite())
    };
    pieces.iter().all(finite).then_some(pieces)
}

// ── Small helpers ──────────────────────────────────────────────────────────────────────────────

fn symbol(g: &mut Graph, name: &str, what: &str) -> Symbol {
    let latex = format!(r"\mathrm{{{what}}}_{{{}}}", latex_of(name));
    g.symbol(format!("{name}.{what}"), latex)
}

fn memory(name: &str, symbol: Symbol, initial: Expr) -> Memory {
    Memory {
        name: name.to_owned(),
        symbol,
        initial,
    }
}

fn whole(g: &mut Graph, index: usize) -> Expr {
    g.number(Rational::from_integer(index.into()))
}

/// A time that no run reaches.
fn never(g: &mut Graph) -> Expr {
    let mut time = Rational::one();
    for _ in 0..30 {
        time *= Rational::from_integer(10.into());
    }
    g.number(time)
}

fn fraction(value: Expr, name: &str) -> Condition {
    Condition {
        hint: "it is a fraction of the period, from 0 to 1".to_owned(),
        ..Condition::not_below_zero(value, name)
    }
}

#[cfg(test)]
#[path = "waveforms_tests.rs"]
mod tests;
