//! The figure of a run: panels one above the other that share the time axis, as SVG.

use std::fmt::Write;

use super::panels::Panel;
use super::scale::{self, Axis, DisplayUnit};
use super::svg::{PAPER, RULES, escape, pixel, thinned};

const WIDTH: f64 = 960.0;
const LEFT: f64 = 78.0;
const RIGHT: f64 = 18.0;
const PANEL: f64 = 170.0;
const HEAD: f64 = 30.0;
const FOOT: f64 = 52.0;

/// The figure as an `svg` element that takes its colours from the page it stands in.
pub fn figure(time: &[f64], panels: &[Panel]) -> String {
    let height = figure_height(panels.len());
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {}\" role=\"img\" \
         aria-label=\"curves over time\">\n",
        pixel(height)
    );
    draw(&mut svg, time, panels, 0.0);
    svg.push_str("</svg>\n");
    svg
}

/// The figure as a file of its own, under a title.
pub fn standalone(title: &str, time: &[f64], panels: &[Panel]) -> String {
    const TITLE: f64 = 34.0;
    let height = figure_height(panels.len()) + TITLE;
    let mut svg = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{0}\" \
         viewBox=\"0 0 {WIDTH} {0}\">\n<title>{1}</title>\n<style>svg{{{PAPER}}}{RULES}</style>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"var(--paper)\"/>\n\
         <text class=\"title\" x=\"{LEFT}\" y=\"26\" style=\"font-size:15px\">{1}</text>\n",
        pixel(height),
        escape(title)
    );
    draw(&mut svg, time, panels, TITLE);
    svg.push_str("</svg>\n");
    svg
}

fn figure_height(panels: usize) -> f64 {
    (PANEL + HEAD) * panels.max(1) as f64 + FOOT
}

fn draw(svg: &mut String, time: &[f64], panels: &[Panel], top: f64) {
    let end = time.last().copied().unwrap_or(1.0);
    let begin = time.first().copied().unwrap_or(0.0);
    let unit = scale::display_unit("s", end.abs().max(begin.abs()));
    let axis = Axis::new(begin / unit.factor, end / unit.factor, 10, 0.0);
    if panels.is_empty() {
        let _ = writeln!(
            svg,
            "<text class=\"soft\" x=\"{LEFT}\" y=\"{}\">nothing to draw</text>",
            pixel(top + 40.0)
        );
        return;
    }
    for (index, panel) in panels.iter().enumerate() {
        let y = top + HEAD + index as f64 * (PANEL + HEAD);
        draw_panel(svg, time, &unit, &axis, panel, y);
    }
    let bottom = top + panels.len() as f64 * (PANEL + HEAD);
    for &tick in &axis.ticks {
        let _ = writeln!(
            svg,
            "<text class=\"soft\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
            pixel(across(&axis, tick)),
            pixel(bottom + 18.0),
            axis.label(tick)
        );
    }
    let _ = writeln!(
        svg,
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">time ({})</text>",
        pixel(LEFT + (WIDTH - LEFT - RIGHT) / 2.0),
        pixel(bottom + 40.0),
        unit.name
    );
}

fn across(axis: &Axis, value: f64) -> f64 {
    LEFT + axis.share(value) * (WIDTH - LEFT - RIGHT)
}

fn draw_panel(
    svg: &mut String,
    time: &[f64],
    time_unit: &DisplayUnit,
    time_axis: &Axis,
    panel: &Panel,
    top: f64,
) {
    let (low, high) = range(panel);
    let axis = Axis::new(low, high, 5, 0.06);
    let down = |value: f64| top + (1.0 - axis.share(value)) * PANEL;
    let (left, right, bottom) = (LEFT, WIDTH - RIGHT, top + PANEL);
    let mut grid = String::new();
    for &tick in &time_axis.ticks {
        let x = pixel(across(time_axis, tick));
        let _ = write!(grid, "M{x} {}V{}", pixel(top), pixel(bottom));
    }
    for &tick in &axis.ticks {
        let y = down(tick);
        let _ = write!(grid, "M{} {}H{}", pixel(left), pixel(y), pixel(right));
        let _ = writeln!(
            svg,
            "<text class=\"soft\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>",
            pixel(left - 8.0),
            pixel(y + 4.0),
            axis.label(tick)
        );
    }
    let _ = writeln!(svg, "<path class=\"grid\" d=\"{grid}\"/>");
    let _ = writeln!(
        svg,
        "<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
        pixel(left),
        pixel(top),
        pixel(right - left),
        pixel(PANEL)
    );
    let heading = match panel.unit.name.as_str() {
        "" => panel.title.clone(),
        unit => format!("{} ({unit})", panel.title),
    };
    let _ = writeln!(
        svg,
        "<text class=\"title\" x=\"{}\" y=\"{}\">{}</text>",
        pixel(left),
        pixel(top - 9.0),
        escape(&heading)
    );
    draw_legend(svg, panel, right, top - 9.0);
    for curve in &panel.curves {
        let x = |k: usize| across(time_axis, time[k] / time_unit.factor);
        let mut path = String::new();
        let mut broken = true;
        for k in thinned(&curve.values, (right - left) as usize, x) {
            let value = curve.values[k];
            if !value.is_finite() {
                broken = true;
                continue;
            }
            let pen = if broken { 'M' } else { 'L' };
            let _ = write!(path, "{pen}{} {}", pixel(x(k)), pixel(down(value)));
            broken = false;
        }
        let _ = writeln!(
            svg,
            "<path class=\"curve\" style=\"stroke:var(--curve{})\" d=\"{path}\"/>",
            curve.colour
        );
    }
}

/// Names with their colours, right-aligned in the line of the title.
fn draw_legend(svg: &mut String, panel: &Panel, right: f64, baseline: f64) {
    let mut end = right;
    for curve in panel.curves.iter().rev() {
        let width = text_width(&curve.name);
        let x = end - width;
        let _ = writeln!(
            svg,
            "<text x=\"{}\" y=\"{}\">{}</text>\
             <path d=\"M{} {}h16\" style=\"stroke:var(--curve{});stroke-width:3\"/>",
            pixel(x),
            pixel(baseline),
            escape(&curve.name),
            pixel(x - 22.0),
            pixel(baseline - 4.0),
            curve.colour
        );
        end = x - 38.0;
    }
}

/// About how wide a text in the pictures' size is, in pixels.
pub fn text_width(text: &str) -> f64 {
    text.chars()
        .map(|c| match c {
            'i' | 'l' | 'j' | 't' | 'f' | 'r' | '.' | ',' | ' ' | '\'' => 3.9,
            'm' | 'w' | 'M' | 'W' => 10.0,
            'A'..='Z' => 8.4,
            c if (c as u32) >= 0x1100 => 12.5,
            _ => 6.9,
        })
        .sum()
}

/// The range of a panel; zero is taken in where it is near.
fn range(panel: &Panel) -> (f64, f64) {
    let values = panel.curves.iter().flat_map(|curve| &curve.values);
    let (low, high) = values
        .filter(|value| value.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &v| {
            (low.min(v), high.max(v))
        });
    if low > 0.0 && low < 0.4 * high {
        (0.0, high)
    } else if high < 0.0 && high > 0.4 * low {
        (low, 0.0)
    } else {
        (low, high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::plot::panels::{Column, choose};

    #[test]
    fn names_are_escaped_and_gaps_break_the_curve() {
        let time: Vec<f64> = (0..5).map(|k| k as f64 * 1e-3).collect();
        let panels = choose(&[Column {
            name: "<b>&".to_owned(),
            unit: "1".to_owned(),
            output: true,
            values: vec![0.0, 1.0, f64::NAN, 2.0, 1.5],
        }]);
        let svg = standalone("a < b", &time, &panels);
        assert!(!svg.contains("<b>"), "{svg}");
        assert!(svg.contains("a &lt; b") && svg.contains("&lt;b&gt;&amp;"));
        let path = svg
            .lines()
            .find(|line| line.contains("class=\"curve\""))
            .unwrap();
        assert_eq!(path.matches('M').count(), 2, "{path}");
        assert!(!svg.contains("NaN"));
    }

    #[test]
    fn an_empty_run_still_draws() {
        assert!(figure(&[], &[]).contains("nothing to draw"));
    }
}
