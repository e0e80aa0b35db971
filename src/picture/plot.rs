//! Draws a [`Chart`]: panels with grid, ticks, series, bands and reference lines.

use std::fmt::Write;

use super::chart::{Axis, Chart, Panel, Series, Which};
use super::legend::{self, Legend};
use super::scale::{DisplayUnit, Scale, display_unit, pretty_unit, with_unit};
use super::svg::{CURVE_COLOURS, LEVEL_COLOURS, escape, pixel, text_width, thinned};

/// How much room a picture has: pictures for wide pages and for narrow ones differ in more than
/// their size, as text keeps its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Width {
    /// A page on a desk, or on paper.
    Wide,
    /// A telephone, or one of several charts side by side.
    Narrow,
}

impl Width {
    /// In pixels.
    pub fn pixels(self) -> f64 {
        match self {
            Width::Wide => 960.0,
            Width::Narrow => 400.0,
        }
    }
}

/// Room above a panel for its title.
const HEAD: f64 = 30.0;
/// Room below the last for ticks and their unit.
const FOOT: f64 = 50.0;
/// Height of the bars that mark windows of single series.
const WINDOW: f64 = 13.0;
/// Points beyond which markers get smaller.
const MANY_POINTS: usize = 120;

/// A picture with its size.
pub struct Drawn {
    /// What stands in the `svg` element.
    pub content: String,
    /// Width and height in pixels.
    pub size: [f64; 2],
}

/// The chart, drawn for this width.
pub fn chart(chart: &Chart, width: Width) -> Drawn {
    let wide = width.pixels();
    let mut content = String::new();
    if chart.panels.is_empty() {
        let _ = writeln!(
            content,
            "<text class=\"soft\" x=\"16\" y=\"40\">nothing to draw</text>"
        );
        return Drawn {
            content,
            size: [wide, 64.0],
        };
    }
    let legends: Vec<Legend> = chart
        .panels
        .iter()
        .map(|panel| legend::choose(panel, width, panel_height(chart, width)))
        .collect();
    let across = across(chart, width);
    let axes: Vec<Vertical> = chart
        .panels
        .iter()
        .map(|panel| Vertical::of(chart, panel, width))
        .collect();
    let ticks = axes.iter().flat_map(|axis| &axis.scale.ticks);
    let labels = ticks
        .map(|(_, label)| text_width(label))
        .fold(18.0, f64::max);
    let beside = legends.iter().map(Legend::beside).fold(0.0, f64::max);
    let frame = Frame {
        left: labels + 20.0,
        right: wide - beside.max(16.0),
        chart,
        across: &across,
        width,
    };
    let mut y = 0.0;
    for ((panel, axis), legend) in chart.panels.iter().zip(&axes).zip(&legends) {
        y += HEAD + legend.above(frame.right - frame.left);
        y = frame.panel(&mut content, panel, axis, legend, y);
    }
    let middle = (frame.left + frame.right) / 2.0;
    let mut free_from = f64::NEG_INFINITY;
    for (tick, label) in &across.scale.ticks {
        let x = frame.x(*tick * across.unit.factor);
        let half = text_width(label) / 2.0;
        if label.is_empty() || x - half < free_from {
            continue;
        }
        free_from = x + half + 6.0;
        let _ = writeln!(
            content,
            "<text class=\"soft\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{label}</text>",
            pixel(x),
            pixel(y + 18.0),
        );
    }
    let _ = writeln!(
        content,
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
        pixel(middle),
        pixel(y + 38.0),
        escape(&heading(&chart.x.label, &across.unit))
    );
    Drawn {
        content,
        size: [wide, y + FOOT],
    }
}

fn panel_height(chart: &Chart, width: Width) -> f64 {
    match (chart.panels.len(), width) {
        (1, Width::Wide) => 350.0,
        (1, Width::Narrow) => 240.0,
        (2, Width::Wide) => 210.0,
        (_, _) => 165.0,
    }
}

/// A label with its unit: `mean speed (mm/s)`.
pub fn heading(label: &str, unit: &DisplayUnit) -> String {
    match unit.name.as_str() {
        "" => label.to_owned(),
        unit if label.is_empty() => unit.to_owned(),
        unit => format!("{label} ({unit})"),
    }
}

/// The horizontal axis as drawn.
struct Horizontal {
    scale: Scale,
    unit: DisplayUnit,
}

fn across(chart: &Chart, width: Width) -> Horizontal {
    let count = match width {
        Width::Wide => 10,
        Width::Narrow => 5,
    };
    let values = chart.panels.iter().flat_map(|panel| {
        let series = panel
            .series
            .iter()
            .flat_map(|series| series.x.iter().copied());
        let bands = panel.bands.iter().flat_map(|band| [band.from, band.to]);
        let marks = panel.references.iter().filter(|r| r.axis == Which::X);
        series.chain(bands).chain(marks.map(|r| r.at))
    });
    let points = chart
        .panels
        .iter()
        .flat_map(|panel| &panel.series)
        .any(|series| series.look.has_points());
    let (scale, unit) = scale(
        &chart.x,
        values,
        count,
        if points { 0.02 } else { 0.0 },
        false,
    );
    Horizontal { scale, unit }
}

/// A panel's axis as drawn.
struct Vertical {
    scale: Scale,
    unit: DisplayUnit,
}

impl Vertical {
    fn of(chart: &Chart, panel: &Panel, width: Width) -> Self {
        let values = panel.series.iter().flat_map(|series| {
            let logarithmic = chart.x.logarithmic;
            let visible = series
                .points()
                .filter(move |[x, _]| !logarithmic || *x > 0.0);
            let visible = visible.filter(|[x, _]| match chart.x.range {
                Some([low, high]) => (low..=high).contains(x),
                None => true,
            });
            visible.map(|[_, y]| y)
        });
        let marks = panel.references.iter().filter(|r| r.axis == Which::Y);
        let count = (panel_height(chart, width) / 42.0).round() as usize;
        let (scale, unit) = scale(
            &panel.y,
            values.chain(marks.map(|r| r.at)),
            count,
            0.06,
            true,
        );
        Self { scale, unit }
    }
}

/// A scale for values of an axis; zero is taken in where it is near, if asked for.
fn scale(
    axis: &Axis,
    values: impl Iterator<Item = f64>,
    count: usize,
    margin: f64,
    near_zero: bool,
) -> (Scale, DisplayUnit) {
    let (low, high) = match axis.range {
        Some([low, high]) => (low, high),
        None => values
            .filter(|v| v.is_finite() && (!axis.logarithmic || *v > 0.0))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
                (low.min(v), high.max(v))
            }),
    };
    if axis.logarithmic {
        // Labels carry their own prefixes.
        let unit = DisplayUnit {
            name: pretty_unit(&axis.unit),
            factor: 1.0,
        };
        return (Scale::logarithmic(low, high, count), unit);
    }
    let (low, high) = match axis.range {
        None if near_zero && low > 0.0 && low < 0.4 * high => (0.0, high),
        None if near_zero && high < 0.0 && high > 0.4 * low => (low, 0.0),
        _ => (low, high),
    };
    let unit = display_unit(&axis.unit, low.abs().max(high.abs()));
    let margin = if axis.range.is_some() { 0.0 } else { margin };
    let scale = Scale::linear(low / unit.factor, high / unit.factor, count, margin);
    (scale, unit)
}

/// Where the panels stand.
struct Frame<'c> {
    left: f64,
    right: f64,
    chart: &'c Chart,
    across: &'c Horizontal,
    width: Width,
}

impl Frame<'_> {
    /// The place of a horizontal value in SI.
    fn x(&self, value: f64) -> f64 {
        let share = self.across.scale.share(value / self.across.unit.factor);
        self.left + share.clamp(-1e4, 1e4) * (self.right - self.left)
    }

    /// Draws a panel below `top` and returns where it ends.
    fn panel(
        &self,
        svg: &mut String,
        panel: &Panel,
        axis: &Vertical,
        legend: &Legend,
        top: f64,
    ) -> f64 {
        let windows = panel
            .bands
            .iter()
            .filter(|band| band.series.is_some())
            .count();
        let plot_top = top + windows as f64 * WINDOW;
        let height = panel_height(self.chart, self.width);
        let bottom = plot_top + height;
        let y = |value: f64| {
            let share = axis.scale.share(value / axis.unit.factor);
            plot_top + (1.0 - share.clamp(-1e4, 1e4)) * height
        };
        self.grid(svg, axis, plot_top, bottom, &y);
        self.bands(svg, panel, top, plot_top, bottom);
        let _ = writeln!(
            svg,
            "<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>",
            pixel(self.left),
            pixel(plot_top),
            pixel(self.right - self.left),
            pixel(height)
        );
        let title_at = top - 9.0 - legend.above(self.right - self.left);
        let _ = writeln!(
            svg,
            "<text class=\"title\" x=\"{}\" y=\"{}\">{}</text>",
            pixel(self.left),
            pixel(title_at),
            escape(&heading(&panel.y.label, &axis.unit))
        );
        legend.draw_above(svg, self.chart, panel, [self.left, self.right], title_at);
        // An `svg` in the `svg` cuts off what lies outside of a range that was asked for.
        let _ = writeln!(
            svg,
            "<svg x=\"{0}\" y=\"{1}\" width=\"{2}\" height=\"{3}\" viewBox=\"{0} {1} {2} {3}\">",
            pixel(self.left - 5.0),
            pixel(plot_top - 5.0),
            pixel(self.right - self.left + 10.0),
            pixel(height + 10.0)
        );
        for (index, series) in panel.series.iter().enumerate() {
            let colour = colour(self.chart, panel, index);
            self.curve(svg, series, &colour, &y);
        }
        for (index, series) in panel.series.iter().enumerate() {
            if series.look.has_points() {
                self.markers(svg, panel, index, axis, bottom, &y);
            }
        }
        svg.push_str("</svg>\n");
        self.references(svg, panel, [plot_top, bottom], &y);
        let ends: Vec<Option<[f64; 2]>> = panel
            .series
            .iter()
            .map(|series| {
                let finite = series.points().filter(|[_, v]| v.is_finite());
                let seen = finite.map(|[u, v]| [self.x(u), y(v)]);
                let seen = seen.filter(|[u, v]| {
                    (self.left - 1.0..=self.right + 1.0).contains(u)
                        && (plot_top - 1.0..=bottom + 1.0).contains(v)
                });
                // Farthest to the right, whatever the order of the points.
                seen.fold(None, |last: Option<[f64; 2]>, p| match last {
                    Some(l) if l[0] > p[0] => Some(l),
                    _ => Some(p),
                })
            })
            .collect();
        legend.draw_beside(
            svg,
            self.chart,
            panel,
            self.right,
            [plot_top, bottom],
            &ends,
        );
        bottom
    }

    fn grid(
        &self,
        svg: &mut String,
        axis: &Vertical,
        top: f64,
        bottom: f64,
        y: &impl Fn(f64) -> f64,
    ) {
        let [mut major, mut minor] = [String::new(), String::new()];
        for (tick, label) in &self.across.scale.ticks {
            let x = pixel(self.x(tick * self.across.unit.factor));
            let into = if label.is_empty() {
                &mut minor
            } else {
                &mut major
            };
            let _ = write!(into, "M{x} {}V{}", pixel(top), pixel(bottom));
        }
        for (tick, label) in &axis.scale.ticks {
            let at = y(tick * axis.unit.factor);
            let into = if label.is_empty() {
                &mut minor
            } else {
                &mut major
            };
            let _ = write!(
                into,
                "M{} {}H{}",
                pixel(self.left),
                pixel(at),
                pixel(self.right)
            );
            if !label.is_empty() {
                let _ = writeln!(
                    svg,
                    "<text class=\"soft\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{label}</text>",
                    pixel(self.left - 8.0),
                    pixel(at + 4.0)
                );
            }
        }
        if !minor.is_empty() {
            let _ = writeln!(svg, "<path class=\"minor\" d=\"{minor}\"/>");
        }
        let _ = writeln!(svg, "<path class=\"grid\" d=\"{major}\"/>");
    }

    fn bands(&self, svg: &mut String, panel: &Panel, top: f64, plot_top: f64, bottom: f64) {
        let mut row = top;
        for band in &panel.bands {
            let inside = |value: f64| self.x(value).clamp(self.left, self.right);
            let [from, to] = [inside(band.from), inside(band.to)];
            if !from.is_finite() || !to.is_finite() {
                continue;
            }
            let label = escape(&band.label);
            match band.series {
                None => {
                    let _ = writeln!(
                        svg,
                        "<rect class=\"band\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\
                         <text class=\"soft halo\" x=\"{}\" y=\"{}\">{label}</text>",
                        pixel(from.min(to)),
                        pixel(plot_top),
                        pixel((to - from).abs()),
                        pixel(bottom - plot_top),
                        pixel(from.min(to) + 5.0),
                        pixel(plot_top + 15.0),
                    );
                }
                Some(series) => {
                    let middle = row + WINDOW / 2.0;
                    let _ = writeln!(
                        svg,
                        "<path class=\"window\" style=\"stroke:{}\" d=\"M{} {}H{}\"/>\
                         <text class=\"soft\" x=\"{}\" y=\"{}\" style=\"font-size:11px\">{label}</text>",
                        colour(self.chart, panel, series),
                        pixel(from),
                        pixel(middle),
                        pixel(to),
                        pixel(from.max(to) + 6.0),
                        pixel(middle + 4.0),
                    );
                    row += WINDOW;
                }
            }
        }
    }

    fn references(
        &self,
        svg: &mut String,
        panel: &Panel,
        [top, bottom]: [f64; 2],
        y: &impl Fn(f64) -> f64,
    ) {
        for reference in &panel.references {
            let label = escape(&reference.label);
            match reference.axis {
                Which::X => {
                    let x = self.x(reference.at);
                    if !(self.left..=self.right).contains(&x) {
                        continue;
                    }
                    // The label stands on the side that has room.
                    let (anchor, gap) = if x + text_width(&reference.label) + 8.0 > self.right {
                        ("end", -5.0)
                    } else {
                        ("start", 5.0)
                    };
                    let _ = writeln!(
                        svg,
                        "<path class=\"reference\" d=\"M{} {}V{}\"/>\
                         <text class=\"soft halo\" x=\"{}\" y=\"{}\" text-anchor=\"{anchor}\">{label}</text>",
                        pixel(x),
                        pixel(top),
                        pixel(bottom),
                        pixel(x + gap),
                        pixel(bottom - 8.0)
                    );
                }
                Which::Y => {
                    let at = y(reference.at);
                    if !(top..=bottom).contains(&at) {
                        continue;
                    }
                    let _ = writeln!(
                        svg,
                        "<path class=\"reference\" d=\"M{} {}H{}\"/>\
                         <text class=\"soft halo\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{label}</text>",
                        pixel(self.left),
                        pixel(at),
                        pixel(self.right),
                        pixel(self.right - 6.0),
                        pixel(at - 5.0)
                    );
                }
            }
        }
    }

    fn curve(&self, svg: &mut String, series: &Series, colour: &str, y: &impl Fn(f64) -> f64) {
        if !series.look.has_line() {
            return;
        }
        let count = series.x.len().min(series.y.len());
        let (across, values) = (&series.x[..count], &series.y[..count]);
        let kept = if across.is_sorted() {
            let columns = (self.right - self.left) as usize;
            thinned(values, columns, |k| self.x(across[k]))
        } else {
            (0..count).collect()
        };
        let mut path = String::new();
        let mut broken = true;
        for k in kept {
            let [u, v] = [self.x(across[k]), y(values[k])];
            if !u.is_finite() || !v.is_finite() || !values[k].is_finite() {
                broken = true;
                continue;
            }
            let pen = if broken { 'M' } else { 'L' };
            let _ = write!(path, "{pen}{} {}", pixel(u), pixel(v));
            broken = false;
        }
        let dashed = match series.look {
            super::chart::Look::Dashed => " dashed",
            _ => "",
        };
        let _ = writeln!(
            svg,
            "<path class=\"curve{dashed}\" style=\"stroke:{colour}\" d=\"{path}\"/>"
        );
    }

    /// Markers, each with its values for those who point at it; what failed has a cross at the
    /// foot of the panel.
    fn markers(
        &self,
        svg: &mut String,
        panel: &Panel,
        index: usize,
        axis: &Vertical,
        bottom: f64,
        y: &impl Fn(f64) -> f64,
    ) {
        let series = &panel.series[index];
        let colour = colour(self.chart, panel, index);
        let many = series.y.len() > MANY_POINTS;
        let shape = series.colour.unwrap_or(index);
        for [u, v] in series.points() {
            let x = self.x(u);
            if !x.is_finite() {
                continue;
            }
            let across = with_unit(u, &self.chart.x.unit, 5);
            let at = if v.is_finite() { y(v) } else { f64::NAN };
            let said = if at.is_finite() {
                let unit = &axis.unit.name;
                let value = super::scale::number(v / axis.unit.factor, 5);
                format!("{}: {across}, {value} {unit}", series.name)
            } else {
                format!("{}: {across}, failed", series.name)
            };
            let said = escape(&said);
            let path = if at.is_finite() {
                marker(shape, [x, at], if many { 2.0 } else { 3.8 })
            } else {
                let (x, y) = (x, bottom - 7.0);
                format!(
                    "M{} {1}L{2} {3}M{0} {3}L{2} {1}",
                    pixel(x - 4.0),
                    pixel(y - 4.0),
                    pixel(x + 4.0),
                    pixel(y + 4.0)
                )
            };
            let look = if at.is_finite() {
                format!("class=\"mark\" style=\"fill:{colour}\"")
            } else {
                format!("class=\"failed\" style=\"stroke:{colour}\"")
            };
            let _ = writeln!(
                svg,
                "<path {look} d=\"{path}\"><title>{said}</title></path>"
            );
        }
    }
}

/// The colour of a series, for a style.
pub fn colour(chart: &Chart, panel: &Panel, index: usize) -> String {
    let number = panel.series.get(index).and_then(|series| series.colour);
    let number = number.unwrap_or(index);
    if !chart.ordered {
        return format!("var(--curve{})", number % CURVE_COLOURS);
    }
    let levels = panel
        .series
        .iter()
        .enumerate()
        .map(|(index, series)| series.colour.unwrap_or(index))
        .max()
        .unwrap_or(0);
    let level = (number * (LEVEL_COLOURS - 1))
        .checked_div(levels)
        .unwrap_or(LEVEL_COLOURS - 1);
    format!("var(--level{level})")
}

/// The outline of a marker: circle, square, triangle, diamond, the other triangle, cross.
pub fn marker(shape: usize, [x, y]: [f64; 2], r: f64) -> String {
    let corners: &[[f64; 2]] = match shape % CURVE_COLOURS {
        0 => {
            let (left, d, r) = (pixel(x - r), pixel(2.0 * r), pixel(r));
            return format!(
                "M{left} {}a{r} {r} 0 1 0 {d} 0a{r} {r} 0 1 0 -{d} 0Z",
                pixel(y)
            );
        }
        1 => &[[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]],
        2 => &[[0.0, -1.2], [1.15, 0.85], [-1.15, 0.85]],
        3 => &[[0.0, -1.3], [1.15, 0.0], [0.0, 1.3], [-1.15, 0.0]],
        4 => &[[0.0, 1.2], [1.15, -0.85], [-1.15, -0.85]],
        _ => &[
            [-0.4, -1.2],
            [0.4, -1.2],
            [0.4, -0.4],
            [1.2, -0.4],
            [1.2, 0.4],
            [0.4, 0.4],
            [0.4, 1.2],
            [-0.4, 1.2],
            [-0.4, 0.4],
            [-1.2, 0.4],
            [-1.2, -0.4],
            [-0.4, -0.4],
        ],
    };
    let mut path = String::new();
    for (index, [u, v]) in corners.iter().enumerate() {
        let pen = if index == 0 { 'M' } else { 'L' };
        let _ = write!(path, "{pen}{} {}", pixel(x + r * u), pixel(y + r * v));
    }
    path + "Z"
}
