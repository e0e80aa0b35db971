//! The figure of a frequency response: speeds over the drive's frequency, with the lines of linear
//! regimes and what was measured, as SVG.

use std::fmt::Write;

use super::scale::{self, Axis, DisplayUnit};
use super::svg::{CURVE_COLOURS, PAPER, RULES, escape, pixel};

const WIDTH: f64 = 960.0;
const HEIGHT: f64 = 480.0;
const LEFT: f64 = 78.0;
const RIGHT: f64 = 730.0;
const TOP: f64 = 50.0;
const BOTTOM: f64 = 418.0;
/// Where the legend begins, and the distance of its lines.
const LEGEND: f64 = 752.0;
const LEGEND_LINE: f64 = 21.0;

/// What is drawn; all values in SI.
pub struct FrequencyFigure<'a> {
    /// Name of the model.
    pub title: &'a str,
    /// Name of the speed.
    pub speed: &'a str,
    /// Its SI unit.
    pub unit: &'a str,
    /// The curves.
    pub curves: Vec<FrequencyCurve>,
    /// Measured points: frequency and speed.
    pub measured: &'a [(f64, f64)],
}

/// A curve of the figure.
pub struct FrequencyCurve {
    /// Its name; may be empty if it is the only one.
    pub name: String,
    /// Frequencies, rising, and speeds; not a number where there is none.
    pub points: Vec<(f64, f64)>,
    /// Both ends of the line of its linear regime.
    pub line: Option<[(f64, f64); 2]>,
}

/// Axes and units.
struct Frame {
    across: Axis,
    down: Axis,
    hertz: DisplayUnit,
    speed: DisplayUnit,
}

impl Frame {
    fn new(figure: &FrequencyFigure<'_>) -> Self {
        let of_curves = figure.curves.iter().flat_map(|curve| &curve.points);
        let points = || {
            of_curves
                .clone()
                .chain(figure.measured)
                .filter(|p| p.1.is_finite())
        };
        let range = |values: &mut dyn Iterator<Item = f64>| {
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
                (low.min(v), high.max(v))
            })
        };
        let all = of_curves.clone().chain(figure.measured);
        let (_, fastest) = range(&mut all.map(|p| p.0));
        let (low, high) = range(&mut points().map(|p| p.1));
        let hertz = scale::display_unit("Hz", fastest);
        let speed = scale::display_unit(figure.unit, low.abs().max(high.abs()));
        Self {
            across: Axis::new(0.0, fastest / hertz.factor, 10, 0.0),
            // Speeds are read from zero.
            down: Axis::new(
                low.min(0.0) / speed.factor,
                high.max(0.0) / speed.factor,
                8,
                0.04,
            ),
            hertz,
            speed,
        }
    }

    fn x(&self, frequency: f64) -> f64 {
        LEFT + self.across.share(frequency / self.hertz.factor) * (RIGHT - LEFT)
    }

    fn y(&self, speed: f64) -> f64 {
        BOTTOM - self.down.share(speed / self.speed.factor) * (BOTTOM - TOP)
    }
}

/// The figure as a file of its own.
pub fn standalone(figure: &FrequencyFigure<'_>) -> String {
    let lines = figure.curves.len() + usize::from(!figure.measured.is_empty());
    let height = HEIGHT.max(TOP + lines as f64 * LEGEND_LINE + 10.0);
    let title = escape(figure.title);
    let mut svg = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{0}\" \
         viewBox=\"0 0 {WIDTH} {0}\">\n<title>{title}</title>\n<style>svg{{{PAPER}}}{RULES}</style>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"var(--paper)\"/>\n\
         <text class=\"title\" x=\"{LEFT}\" y=\"28\" style=\"font-size:15px\">{title}</text>\n",
        pixel(height)
    );
    let frame = Frame::new(figure);
    draw_axes(&mut svg, figure, &frame);
    for (index, curve) in figure.curves.iter().enumerate() {
        draw_curve(&mut svg, &frame, curve, index);
    }
    for &(frequency, speed) in figure.measured {
        draw_measured(&mut svg, frame.x(frequency), frame.y(speed));
    }
    draw_legend(&mut svg, figure);
    svg.push_str("</svg>\n");
    svg
}

fn draw_axes(svg: &mut String, figure: &FrequencyFigure<'_>, frame: &Frame) {
    let mut grid = String::new();
    for &tick in &frame.across.ticks {
        let x = pixel(LEFT + frame.across.share(tick) * (RIGHT - LEFT));
        let _ = write!(grid, "M{x} {}V{}", pixel(TOP), pixel(BOTTOM));
        let _ = writeln!(
            svg,
            "<text class=\"soft\" x=\"{x}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
            pixel(BOTTOM + 18.0),
            frame.across.label(tick)
        );
    }
    for &tick in &frame.down.ticks {
        let y = BOTTOM - frame.down.share(tick) * (BOTTOM - TOP);
        let _ = write!(grid, "M{} {}H{}", pixel(LEFT), pixel(y), pixel(RIGHT));
        let _ = writeln!(
            svg,
            "<text class=\"soft\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>",
            pixel(LEFT - 8.0),
            pixel(y + 4.0),
            frame.down.label(tick)
        );
    }
    let _ = writeln!(svg, "<path class=\"grid\" d=\"{grid}\"/>");
    let zero = pixel(frame.y(0.0));
    let _ = writeln!(svg, "<path class=\"frame\" d=\"M{LEFT} {zero}H{RIGHT}\"/>");
    let _ = writeln!(
        svg,
        "<rect class=\"frame\" x=\"{LEFT}\" y=\"{TOP}\" width=\"{}\" height=\"{}\"/>",
        pixel(RIGHT - LEFT),
        pixel(BOTTOM - TOP)
    );
    let _ = writeln!(
        svg,
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">drive frequency ({})</text>",
        pixel(0.5 * (LEFT + RIGHT)),
        pixel(BOTTOM + 40.0),
        frame.hertz.name
    );
    let unit = match frame.speed.name.as_str() {
        "" => String::new(),
        name => format!(" ({name})"),
    };
    let _ = writeln!(
        svg,
        "<text class=\"title\" x=\"{LEFT}\" y=\"{}\">mean {}{unit}</text>",
        pixel(TOP - 7.0),
        escape(figure.speed)
    );
}

/// Colour and dashes of a curve: dashes begin where colours are used up.
fn pen(index: usize) -> String {
    let dashes = match index / CURVE_COLOURS {
        0 => String::new(),
        round => format!(";stroke-dasharray:{} 4", 4 * round),
    };
    format!("stroke:var(--curve{}){dashes}", index % CURVE_COLOURS)
}

fn draw_curve(svg: &mut String, frame: &Frame, curve: &FrequencyCurve, index: usize) {
    let colour = index % CURVE_COLOURS;
    let mut path = String::new();
    let mut dots = String::new();
    let mut is_broken = true;
    for &(frequency, speed) in &curve.points {
        if !speed.is_finite() {
            is_broken = true;
            continue;
        }
        let (x, y) = (pixel(frame.x(frequency)), pixel(frame.y(speed)));
        let _ = write!(path, "{}{x} {y}", if is_broken { 'M' } else { 'L' });
        let _ = write!(dots, "<circle cx=\"{x}\" cy=\"{y}\" r=\"2.6\"/>");
        is_broken = false;
    }
    let _ = writeln!(
        svg,
        "<path class=\"curve\" style=\"{}\" d=\"{path}\"/>",
        pen(index)
    );
    let _ = writeln!(svg, "<g style=\"fill:var(--curve{colour})\">{dots}</g>");
    if let Some([(f1, v1), (f2, v2)]) = curve.line {
        let _ = writeln!(
            svg,
            "<path class=\"curve\" style=\"stroke:var(--curve{colour});stroke-width:1;\
             stroke-dasharray:2 5\" d=\"M{} {}L{} {}\"/>",
            pixel(frame.x(f1)),
            pixel(frame.y(v1)),
            pixel(frame.x(f2)),
            pixel(frame.y(v2))
        );
    }
}

fn draw_measured(svg: &mut String, x: f64, y: f64) {
    let _ = writeln!(
        svg,
        "<rect class=\"ink\" x=\"{}\" y=\"{}\" width=\"7\" height=\"7\"/>",
        pixel(x - 3.5),
        pixel(y - 3.5)
    );
}

fn draw_legend(svg: &mut String, figure: &FrequencyFigure<'_>) {
    let mut y = TOP + 10.0;
    for (index, curve) in figure.curves.iter().enumerate() {
        if !curve.name.is_empty() {
            let _ = writeln!(
                svg,
                "<path class=\"curve\" style=\"{};stroke-width:3\" d=\"M{LEGEND} {}h22\"/>",
                pen(index),
                pixel(y - 4.0)
            );
            legend_text(svg, y, &curve.name);
            y += LEGEND_LINE;
        }
    }
    if !figure.measured.is_empty() {
        draw_measured(svg, LEGEND + 11.0, y - 4.0);
        legend_text(svg, y, "experiment");
        y += LEGEND_LINE;
    }
    if figure.curves.iter().any(|curve| curve.line.is_some()) {
        let _ = writeln!(
            svg,
            "<path class=\"curve\" style=\"stroke:var(--ink);stroke-width:1;stroke-dasharray:2 5\" \
             d=\"M{LEGEND} {}h22\"/>",
            pixel(y - 4.0)
        );
        legend_text(svg, y, "linear regime");
    }
}

fn legend_text(svg: &mut String, y: f64, text: &str) {
    let (x, y) = (pixel(LEGEND + 30.0), pixel(y));
    let _ = writeln!(svg, "<text x=\"{x}\" y=\"{y}\">{}</text>", escape(text));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_break_where_points_failed_and_names_are_escaped() {
        let curve = |name: &str| FrequencyCurve {
            name: name.to_owned(),
            points: vec![
                (100.0, 1e-3),
                (200.0, f64::NAN),
                (300.0, 2e-3),
                (400.0, 3e-3),
            ],
            line: Some([(100.0, 1e-3), (400.0, 3e-3)]),
        };
        let svg = standalone(&FrequencyFigure {
            title: "a < b",
            speed: "<v>",
            unit: "m/s",
            curves: (0..8).map(|k| curve(&format!("k < {k}"))).collect(),
            measured: &[(150.0, 1.5e-3)],
        });
        assert!(!svg.contains("<v>") && svg.contains("k &lt; 7") && svg.contains("a &lt; b"));
        assert!(!svg.contains("NaN") && svg.contains("experiment") && svg.contains("mm/s"));
        let path = svg
            .lines()
            .find(|line| line.contains("class=\"curve\""))
            .unwrap();
        assert_eq!(path.matches('M').count(), 2, "{path}");
        assert_eq!(svg.matches("<circle").count(), 8 * 3);
    }

    #[test]
    fn nothing_still_draws() {
        let svg = standalone(&FrequencyFigure {
            title: "",
            speed: "v",
            unit: "m/s",
            curves: Vec::new(),
            measured: &[],
        });
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    }
}
