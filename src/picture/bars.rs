//! Draws [`Bars`]: one row for each thing, its groups below each other, values at the bars' ends.

use std::fmt::Write;

use super::chart::Bars;
use super::plot::{Drawn, Width, heading};
use super::scale::{Scale, display_unit, number};
use super::svg::{CURVE_COLOURS, escape, pixel, text_width};

const BAR: f64 = 15.0;
const GAP: f64 = 11.0;
const HEAD: f64 = 34.0;
const FOOT: f64 = 50.0;
/// Widest share of the picture that names may take.
const NAMES: f64 = 0.4;

/// The bars, drawn for this width.
pub fn bars(bars: &Bars, width: Width) -> Drawn {
    let wide = width.pixels();
    let values = || {
        bars.groups
            .iter()
            .flat_map(|(_, values)| values.iter().copied())
    };
    let finite = || values().filter(|value| value.is_finite());
    let [least, greatest] = [finite().fold(0.0, f64::min), finite().fold(0.0, f64::max)];
    let [least, greatest] = bars.value.range.unwrap_or([least, greatest]);
    let unit = display_unit(&bars.value.unit, least.abs().max(greatest.abs()));
    let count = if width == Width::Wide { 8 } else { 4 };
    let scale = Scale::linear(least / unit.factor, greatest / unit.factor, count, 0.0);
    let names = bars
        .names
        .iter()
        .map(|name| text_width(name))
        .fold(20.0, f64::max);
    // Room for the numbers at the ends of the longest bars.
    let spare = 62.0;
    let left = names.min(NAMES * wide) + 20.0 + if least < 0.0 { spare } else { 0.0 };
    let right = wide - 16.0 - spare;
    let x = |value: f64| left + scale.share(value / unit.factor).clamp(0.0, 1.0) * (right - left);
    let row = bars.groups.len().max(1) as f64 * BAR + GAP;
    let bottom = HEAD + bars.names.len() as f64 * row + 4.0;
    let mut content = String::new();
    let mut grid = String::new();
    for (tick, label) in &scale.ticks {
        let at = pixel(x(tick * unit.factor));
        let _ = write!(grid, "M{at} {}V{}", pixel(HEAD), pixel(bottom));
        let _ = writeln!(
            content,
            "<text class=\"soft\" x=\"{at}\" y=\"{}\" text-anchor=\"middle\">{label}</text>",
            pixel(bottom + 18.0)
        );
    }
    let _ = writeln!(content, "<path class=\"grid\" d=\"{grid}\"/>");
    let mut across = left;
    for (index, (group, _)) in bars.groups.iter().enumerate() {
        if group.is_empty() {
            continue;
        }
        let _ = writeln!(
            content,
            "<rect x=\"{}\" y=\"8\" width=\"12\" height=\"12\" style=\"fill:{}\"/>\
             <text x=\"{}\" y=\"19\">{}</text>",
            pixel(across),
            colour(index),
            pixel(across + 18.0),
            escape(group)
        );
        across += text_width(group) + 44.0;
    }
    for (thing, name) in bars.names.iter().enumerate() {
        let top = HEAD + thing as f64 * row + GAP / 2.0;
        let middle = top + (row - GAP) / 2.0;
        let _ = writeln!(
            content,
            "<text x=\"{}\" y=\"{}\">{}</text>",
            pixel(8.0),
            pixel(middle + 4.0),
            escape(name)
        );
        for (index, (_, values)) in bars.groups.iter().enumerate() {
            let value = values.get(thing).copied().unwrap_or(f64::NAN);
            let y = top + index as f64 * BAR;
            let (end, said) = if value.is_finite() {
                (x(value), number(value / unit.factor, 4))
            } else {
                (x(0.0), "failed".to_owned())
            };
            let zero = x(0.0);
            let (anchor, beside) = if end < zero {
                ("end", -6.0)
            } else {
                ("start", 6.0)
            };
            let _ = writeln!(
                content,
                "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" style=\"fill:{}\"/>\
                 <text class=\"soft\" x=\"{}\" y=\"{}\" text-anchor=\"{anchor}\">{said}</text>",
                pixel(zero.min(end)),
                pixel(y + 1.0),
                pixel((end - zero).abs()),
                pixel(BAR - 2.0),
                colour(index),
                pixel(end + beside),
                pixel(y + BAR - 3.5),
            );
        }
    }
    let _ = writeln!(
        content,
        "<path class=\"ink\" d=\"M{} {}V{}\"/>\
         <text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
        pixel(x(0.0)),
        pixel(HEAD),
        pixel(bottom),
        pixel((left + right) / 2.0),
        pixel(bottom + 38.0),
        escape(&heading(&bars.value.label, &unit))
    );
    Drawn {
        content,
        size: [wide, bottom + FOOT],
    }
}

fn colour(group: usize) -> String {
    format!("var(--curve{})", group % CURVE_COLOURS)
}
