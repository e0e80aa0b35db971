//! Names in a picture: each beside what it names, where it covers least.

use std::fmt::Write;

use crate::assembled::Point;

use super::svg::text_width;
use super::svg::{escape, pixel};

/// Names and what they must not cover.
#[derive(Default)]
pub struct Labels {
    wanted: Vec<Wanted>,
    taken: Vec<(Point, f64)>,
}

struct Wanted {
    text: String,
    body: bool,
    anchor: Point,
    preferred: Point,
    distance: f64,
}

impl Labels {
    /// Wants `text` beside `anchor`, rather in the direction `preferred` than elsewhere; the name of
    /// a body is set in italics.
    pub fn add(&mut self, text: &str, body: bool, anchor: Point, preferred: Point, distance: f64) {
        self.wanted.push(Wanted {
            text: text.to_owned(),
            body,
            anchor,
            preferred,
            distance,
        });
    }

    /// Keeps names off a square of half width `radius` around `at`.
    pub fn avoid(&mut self, at: Point, radius: f64) {
        self.taken.push((at, radius));
    }

    /// The names as SVG, each on the side of its anchor where it covers least, within a picture of
    /// this size.
    pub fn place(&self, [width, height]: Point) -> String {
        let mut svg = String::new();
        let mut placed: Vec<[f64; 4]> = Vec::new();
        for wanted in &self.wanted {
            let wide = text_width(&wanted.text) + 4.0;
            let high = 15.0;
            let mut best: Option<(f64, [f64; 4])> = None;
            for further in [0.0, 9.0, 20.0] {
                for turn in 0..12 {
                    let angle = f64::from(turn) * std::f64::consts::TAU / 12.0;
                    let (sin, cos) = angle.sin_cos();
                    let [px, py] = wanted.preferred;
                    let toward = [px * cos - py * sin, px * sin + py * cos];
                    let reach = wanted.distance + further;
                    let x = wanted.anchor[0] + toward[0] * (reach + wide / 2.0 - 8.0);
                    let y = wanted.anchor[1] + toward[1] * reach;
                    let area = [
                        x - wide / 2.0,
                        y - high / 2.0,
                        x + wide / 2.0,
                        y + high / 2.0,
                    ];
                    let away = f64::from(turn.min(12 - turn));
                    let mut cost = 0.6 * away + 0.25 * further;
                    for other in &placed {
                        cost += 2.0 * overlap(area, *other);
                    }
                    for (at, radius) in &self.taken {
                        let box_of = [
                            at[0] - radius,
                            at[1] - radius,
                            at[0] + radius,
                            at[1] + radius,
                        ];
                        cost += 0.5 * overlap(area, box_of);
                    }
                    if area[0] < 2.0
                        || area[1] < 2.0
                        || area[2] > width - 2.0
                        || area[3] > height - 2.0
                    {
                        cost += 1e4;
                    }
                    if best.is_none_or(|(least, _)| cost < least) {
                        best = Some((cost, area));
                    }
                }
            }
            let Some((_, area)) = best else { continue };
            placed.push(area);
            let _ = writeln!(
                svg,
                "<text class=\"name{}\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                if wanted.body { " body-name" } else { "" },
                pixel((area[0] + area[2]) / 2.0),
                pixel(area[3] - 3.5),
                escape(&wanted.text)
            );
        }
        svg
    }
}

fn overlap(a: [f64; 4], b: [f64; 4]) -> f64 {
    let width = (a[2].min(b[2]) - a[0].max(b[0])).max(0.0);
    let height = (a[3].min(b[3]) - a[1].max(b[1])).max(0.0);
    width * height
}
