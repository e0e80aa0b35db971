//! Names of series: beside the ends of their curves where there is room, else in rows above.

use std::fmt::Write;

use super::chart::{Chart, Look, Panel};
use super::plot::{Width, colour, marker};
use super::svg::{escape, pixel, text_width};

/// Distance of two names beside curves.
const LINE: f64 = 17.0;
/// Widest name beside a curve.
const WIDEST: f64 = 190.0;
/// A sample of a series with the space behind it.
const SAMPLE: f64 = 30.0;

/// Where a panel's names stand.
#[derive(Debug, PartialEq)]
pub enum Legend {
    /// There is but one series, which the panel's title names.
    None,
    /// Beside the curves' ends, in room of this width.
    Beside(f64),
    /// In rows above: the widths of the names with their samples.
    Above(Vec<f64>),
}

/// Chooses for a panel of this height.
pub fn choose(panel: &Panel, width: Width, height: f64) -> Legend {
    let named = || panel.series.iter().filter(|series| !series.name.is_empty());
    let widths = named().map(|series| text_width(&series.name) + SAMPLE);
    let widest = widths.clone().fold(0.0, f64::max);
    if widest == 0.0 {
        Legend::None
    } else if width == Width::Wide && widest <= WIDEST && named().count() as f64 * LINE <= height {
        Legend::Beside(widest + 24.0)
    } else {
        Legend::Above(widths.collect())
    }
}

impl Legend {
    /// Room beside the panel.
    pub fn beside(&self) -> f64 {
        match self {
            Legend::Beside(room) => *room,
            Legend::None | Legend::Above(_) => 0.0,
        }
    }

    /// Room above the panel, of this width.
    pub fn above(&self, room: f64) -> f64 {
        match self {
            Legend::Above(widths) => rows(widths, room)
                .last()
                .map_or(0.0, |(row, _)| (row + 1.0) * LINE),
            Legend::None | Legend::Beside(_) => 0.0,
        }
    }

    /// Draws rows of names below `title`.
    pub fn draw_above(
        &self,
        svg: &mut String,
        chart: &Chart,
        panel: &Panel,
        [left, right]: [f64; 2],
        title: f64,
    ) {
        let Legend::Above(widths) = self else { return };
        let named = (0..panel.series.len()).filter(|&k| !panel.series[k].name.is_empty());
        for (index, (row, across)) in named.zip(rows(widths, right - left)) {
            name(
                svg,
                chart,
                panel,
                index,
                [left + across, title + (row + 1.0) * LINE],
            );
        }
    }

    /// Draws names beside the curves' `ends`, within `top` and `bottom`.
    pub fn draw_beside(
        &self,
        svg: &mut String,
        chart: &Chart,
        panel: &Panel,
        right: f64,
        [top, bottom]: [f64; 2],
        ends: &[Option<[f64; 2]>],
    ) {
        if !matches!(self, Legend::Beside(_)) {
            return;
        }
        let mut wanted: Vec<(usize, f64)> = (0..panel.series.len())
            .filter(|&k| !panel.series[k].name.is_empty())
            .map(|k| (k, ends[k].map_or(bottom, |[_, y]| y)))
            .collect();
        wanted.sort_by(|a, b| a.1.total_cmp(&b.1));
        let places = apart(
            &wanted.iter().map(|(_, y)| *y).collect::<Vec<_>>(),
            top,
            bottom,
        );
        for ((index, _), at) in wanted.into_iter().zip(places) {
            if let Some([x, y]) = ends[index] {
                let _ = writeln!(
                    svg,
                    "<path class=\"leader\" d=\"M{} {}L{} {}\"/>",
                    pixel(x.max(right - 2.0) + 4.0),
                    pixel(y),
                    pixel(right + 14.0),
                    pixel(at)
                );
            }
            name(svg, chart, panel, index, [right + 16.0, at + 4.0]);
        }
    }
}

/// Row and distance from the left for names of these widths.
fn rows(widths: &[f64], room: f64) -> Vec<(f64, f64)> {
    let (mut row, mut across) = (0.0, 0.0);
    let place = |width: &f64| {
        if across > 0.0 && across + width > room {
            row += 1.0;
            across = 0.0;
        }
        let at = (row, across);
        across += width + 16.0;
        at
    };
    widths.iter().map(place).collect()
}

/// Places near those wanted (ascending), a line apart, between `top` and `bottom` if they fit.
fn apart(wanted: &[f64], top: f64, bottom: f64) -> Vec<f64> {
    let mut places: Vec<f64> = wanted.to_vec();
    // Names that are too close form a group around the mean of what they want.
    let mut groups: Vec<(usize, usize)> = (0..places.len()).map(|k| (k, k + 1)).collect();
    loop {
        for &(from, to) in &groups {
            let count = (to - from) as f64;
            let mean = wanted[from..to].iter().sum::<f64>() / count;
            let half = (count - 1.0) * LINE / 2.0;
            let mean = mean.min(bottom - half).max(top + half + 4.0);
            for k in from..to {
                places[k] = mean + (k - from) as f64 * LINE - half;
            }
        }
        let touch = (1..groups.len()).find(|&k| {
            let (from, _) = groups[k];
            places[from] - places[from - 1] < LINE - 1e-9
        });
        let Some(k) = touch else { return places };
        let (_, to) = groups.remove(k);
        groups[k - 1].1 = to;
    }
}

/// A name behind a sample of how its series is drawn.
fn name(svg: &mut String, chart: &Chart, panel: &Panel, index: usize, [x, baseline]: [f64; 2]) {
    let series = &panel.series[index];
    let colour = colour(chart, panel, index);
    let middle = baseline - 4.0;
    if series.look.has_line() {
        let dashed = if series.look == Look::Dashed {
            " dashed"
        } else {
            ""
        };
        let _ = write!(
            svg,
            "<path class=\"curve{dashed}\" style=\"stroke:{colour};stroke-width:2.2\" d=\"M{} {}h20\"/>",
            pixel(x),
            pixel(middle)
        );
    }
    if series.look.has_points() {
        let shape = marker(series.colour.unwrap_or(index), [x + 10.0, middle], 3.8);
        let _ = write!(
            svg,
            "<path class=\"mark\" style=\"fill:{colour}\" d=\"{shape}\"/>"
        );
    }
    let _ = writeln!(
        svg,
        "<text x=\"{}\" y=\"{}\">{}</text>",
        pixel(x + 26.0),
        pixel(baseline),
        escape(&series.name)
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stand_apart_near_their_curves() {
        let places = apart(&[10.0, 12.0, 100.0], 0.0, 200.0);
        assert!(places[1] - places[0] >= LINE - 1e-9);
        assert_eq!(places[2], 100.0);
        let crowded = apart(&[200.0; 6], 0.0, 200.0);
        assert!(crowded[5] <= 200.0 && crowded[0] > 0.0);
        assert!(apart(&[], 0.0, 1.0).is_empty());
    }
}
