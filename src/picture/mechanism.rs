//! The mechanism as assembled, drawn to scale in the signs that engineers use: links with their
//! pins, ground hatched, slides on their guides, springs, stacks and contacts, names, a scale bar.
//! Places and lengths of links are to scale; the signs for pins, slides and contacts are not.

use std::fmt::Write;

use super::labels::Labels;
use super::layout::{Layout, SlideAt, layout};
use super::scale;
use super::strokes::{
    all_finite, bar, bar_square, between, center, coil, head, length, line, minus, normal, polygon,
    shifted, unit,
};
use super::svg::pixel;
use crate::assembled::{Places, Point};

const WIDEST: f64 = 760.0;
const HIGHEST: f64 = 420.0;
const MARGIN: f64 = 58.0;
/// Room for the scale bar.
const FOOT: f64 = 30.0;
/// Pixels for one unit of size where there is no scale.
const ARRANGED: f64 = 560.0;
const BAR: f64 = 9.0;
const SLIDE: Point = [54.0, 26.0];

/// The picture as an `svg` element with what is to be said about it, or `None` if there is nothing
/// to show.
pub fn mechanism(places: &Places) -> Option<(String, &'static str)> {
    let layout = layout(places);
    let view = View::around(&layout)?;
    let mut picture = Picture {
        svg: String::new(),
        labels: Labels::default(),
    };
    picture.slides(&layout, &view);
    picture.links(&layout, &view);
    picture.springs(&layout, &view);
    picture.contacts(&layout, &view);
    picture.marks(&layout, &view);
    let names = picture.labels.place(view.size);
    let [width, height] = view.size;
    let bar = if layout.to_scale {
        scale_bar(&view)
    } else {
        String::new()
    };
    let svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" style=\"max-width:{0}px\" \
         role=\"img\" aria-label=\"the mechanism as assembled\">\n{2}{names}{bar}</svg>\n",
        pixel(width),
        pixel(height),
        picture.svg,
    );
    let caption = match (layout.to_scale, layout.fitted) {
        (true, false) => "As assembled, to scale; signs for pins, slides and springs are not.",
        (true, true) => {
            "As assembled, to scale; slides without a place in the model stand beside what they act on."
        }
        (false, _) => "Nothing has a place in this model: arranged by what acts on what.",
    };
    Some((svg, caption))
}

/// How metres become pixels.
struct View {
    scale: f64,
    low: Point,
    size: Point,
}

impl View {
    fn around(layout: &Layout) -> Option<View> {
        let points = all_points(layout);
        let (low, high) = points.iter().filter(|p| all_finite(&[**p])).fold(
            ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]),
            |(low, high), p| {
                (
                    [low[0].min(p[0]), low[1].min(p[1])],
                    [high[0].max(p[0]), high[1].max(p[1])],
                )
            },
        );
        if low[0] > high[0] {
            return None;
        }
        let span = [high[0] - low[0], high[1] - low[1]];
        let room = [WIDEST - 2.0 * MARGIN, HIGHEST - 2.0 * MARGIN];
        let fitting = (room[0] / span[0]).min(room[1] / span[1]);
        let scale = match fitting {
            fitting if !fitting.is_finite() => 1.0,
            fitting if !layout.to_scale => fitting.min(ARRANGED),
            fitting => fitting,
        };
        let width = (span[0] * scale + 2.0 * MARGIN).max(380.0);
        let height = span[1] * scale + 2.0 * MARGIN + FOOT;
        let spare = (width - 2.0 * MARGIN - span[0] * scale) / 2.0;
        Some(View {
            scale,
            low: [low[0] - spare / scale, low[1]],
            size: [width, height],
        })
    }

    fn at(&self, p: Point) -> Point {
        [
            MARGIN + (p[0] - self.low[0]) * self.scale,
            self.size[1] - FOOT - MARGIN - (p[1] - self.low[1]) * self.scale,
        ]
    }

    fn direction(&self, direction: Point) -> Point {
        unit([direction[0], -direction[1]])
    }
}

fn all_points(layout: &Layout) -> Vec<Point> {
    let links = layout.links.iter().flat_map(|(_, corners)| corners.clone());
    let slides = layout.slides.iter().map(|slide| slide.at);
    let marks = layout.marks.iter().map(|(_, at, _)| *at);
    let springs = layout.springs.iter().flat_map(|spring| spring.ends);
    let contacts = layout.contacts.iter().map(|contact| contact.at);
    links
        .chain(slides)
        .chain(marks)
        .chain(springs)
        .chain(contacts)
        .collect()
}

struct Picture {
    svg: String,
    labels: Labels,
}

impl Picture {
    fn links(&mut self, layout: &Layout, view: &View) {
        for (name, corners) in &layout.links {
            let corners: Vec<Point> = corners.iter().map(|&p| view.at(p)).collect();
            if !all_finite(&corners) || corners.is_empty() {
                continue;
            }
            let outline = match corners[..] {
                [a, b] => bar(a, b, BAR),
                _ => polygon(&corners),
            };
            let _ = writeln!(self.svg, "<path class=\"link\" d=\"{outline}\"/>");
            let (first, last) = (corners[0], corners[corners.len() - 1]);
            let across = normal(unit(minus(last, first)));
            let middle = center(&corners);
            self.labels.add(name, true, middle, across, BAR + 9.0);
            for &corner in &corners {
                self.labels.avoid(corner, 8.0);
            }
            for step in 1..8 {
                self.labels
                    .avoid(between(first, last, f64::from(step) / 8.0), BAR);
            }
        }
    }

    fn slides(&mut self, layout: &Layout, view: &View) {
        for slide in &layout.slides {
            let at = view.at(slide.at);
            let along = view.direction(slide.along);
            if !all_finite(&[at, along]) {
                continue;
            }
            let (across, side) = rail(slide, view);
            let place = |u: f64, v: f64| {
                [
                    at[0] + u * along[0] + v * across[0],
                    at[1] + u * along[1] + v * across[1],
                ]
            };
            let (half, depth) = (SLIDE[0] / 2.0, SLIDE[1] / 2.0);
            let rail = 1.55 * half;
            let rail_at = side * (depth + 3.0);
            let mut hatching = String::new();
            let strokes = 9;
            for k in 0..strokes {
                let u = -rail + 2.0 * rail * (f64::from(k) + 0.5) / f64::from(strokes);
                hatching += &line(
                    place(u + 3.0, rail_at),
                    place(u - 3.0, rail_at + side * 7.0),
                );
            }
            let _ = writeln!(self.svg, "<path class=\"thin\" d=\"{hatching}\"/>");
            let _ = writeln!(
                self.svg,
                "<path class=\"ink\" d=\"{}\"/>",
                line(place(-rail, rail_at), place(rail, rail_at))
            );
            let block = [
                place(-half, -depth),
                place(half, -depth),
                place(half, depth),
                place(-half, depth),
            ];
            let _ = writeln!(
                self.svg,
                "<path class=\"slide\" d=\"{}\"/>",
                polygon(&block)
            );
            let (tail, tip) = (place(-half * 0.45, 0.0), place(half * 0.55, 0.0));
            let _ = writeln!(
                self.svg,
                "<path class=\"thin\" d=\"{}\"/>",
                line(tail, tip) + &head(tail, tip, 5.0)
            );
            // The name stands opposite the rail, unless the slide touches something there.
            let (toward, reach) = match slide.touches {
                Some(_) => (side, depth + 22.0),
                None => (-side, depth + 12.0),
            };
            let toward = across.map(|c| toward * c);
            self.labels.add(&slide.name, true, at, toward, reach);
            for k in -3..=3 {
                self.labels
                    .avoid(place(f64::from(k) * half / 3.0, 0.0), depth);
                self.labels
                    .avoid(place(f64::from(k) * rail / 3.0, rail_at + 4.0 * side), 6.0);
            }
        }
    }

    fn springs(&mut self, layout: &Layout, view: &View) {
        for spring in &layout.springs {
            let mut ends = spring.ends.map(|end| view.at(end));
            if !all_finite(&ends) {
                continue;
            }
            let along = unit(minus(ends[1], ends[0]));
            for (index, inward) in [(0, 1.0), (1, -1.0)] {
                if let Some(slide) = spring.slides[index] {
                    let guide = view.direction(layout.slides[slide].along);
                    let parallel = (guide[0] * along[0] + guide[1] * along[1]).abs();
                    let reach = (SLIDE[0] * parallel).max(SLIDE[1]) / 2.0;
                    ends[index] = shifted(ends[index], along, inward * reach);
                }
                if spring.walls[index] {
                    self.wall(ends[index], along.map(|c| -inward * c));
                }
            }
            let [a, b] = ends;
            let toward = minus(b, a);
            if toward[0] * along[0] + toward[1] * along[1] > 14.0 {
                if spring.stack {
                    self.stack(a, b);
                } else {
                    let _ = writeln!(self.svg, "<path class=\"spring\" d=\"{}\"/>", coil(a, b));
                }
                for k in 1..8 {
                    self.labels.avoid(between(a, b, f64::from(k) / 8.0), 8.0);
                }
            }
            let across = normal(along);
            let up = if across[1] > 0.0 {
                across.map(|c| -c)
            } else {
                across
            };
            self.labels
                .add(&spring.name, false, between(a, b, 0.5), up, 18.0);
        }
    }

    /// Ground as a wall, hatched on the side of `outward`.
    fn wall(&mut self, at: Point, outward: Point) {
        let across = normal(outward);
        let half = 15.0;
        let mut hatching = String::new();
        for k in 0..6 {
            let p = shifted(at, across, -half + 2.0 * half * (f64::from(k) + 0.5) / 6.0);
            let q = shifted(shifted(p, outward, 7.0), across, -5.0);
            hatching += &line(p, q);
        }
        let _ = writeln!(
            self.svg,
            "<path class=\"thin\" d=\"{hatching}\"/><path class=\"ink\" d=\"{}\"/>",
            line(shifted(at, across, -half), shifted(at, across, half))
        );
        self.labels.avoid(shifted(at, outward, 3.0), half);
    }

    /// A ceramic: a block of layers between its ends.
    fn stack(&mut self, a: Point, b: Point) {
        let long = length(minus(b, a));
        let outline = bar_square(a, b, 9.0);
        let _ = writeln!(self.svg, "<path class=\"piezo\" d=\"{outline}\"/>");
        let layers = ((long / 7.0).round() as usize).clamp(2, 40);
        let across = normal(unit(minus(b, a)));
        let mut strokes = String::new();
        for k in 1..layers {
            let p = between(a, b, k as f64 / layers as f64);
            strokes += &line(shifted(p, across, -9.0), shifted(p, across, 9.0));
        }
        let _ = writeln!(
            self.svg,
            "<path class=\"piezo\" style=\"stroke-width:0.8\" d=\"{strokes}\"/>"
        );
    }

    fn contacts(&mut self, layout: &Layout, view: &View) {
        for contact in &layout.contacts {
            let mut at = view.at(contact.at);
            let along = view.direction(contact.along);
            if !all_finite(&[at, along]) {
                continue;
            }
            if let Some(slide) = contact.rail_of {
                let (across, side) = rail(&layout.slides[slide], view);
                at = shifted(at, across, side * (SLIDE[1] / 2.0 + 17.0));
            }
            let (back, front) = (shifted(at, along, -17.0), shifted(at, along, 17.0));
            let _ = writeln!(
                self.svg,
                "<path class=\"contact\" d=\"{}{}{}\"/>",
                line(back, front),
                head(back, front, 6.0),
                head(front, back, 6.0)
            );
            self.labels.avoid(at, 7.0);
            self.labels.avoid(back, 5.0);
            self.labels.avoid(front, 5.0);
            self.labels.add(&contact.name, false, at, [0.0, 1.0], 16.0);
        }
    }

    fn marks(&mut self, layout: &Layout, view: &View) {
        for (name, at, pin) in &layout.marks {
            let at = view.at(*at);
            if !all_finite(&[at]) {
                continue;
            }
            let [x, y] = at;
            if *pin == Some(true) {
                let (base, half) = (y + 17.0, 13.0);
                let mut hatching = String::new();
                for k in 0..6 {
                    let u = x - half - 1.0 + f64::from(k) * (2.0 * half + 2.0) / 5.0;
                    hatching += &line([u + 2.5, base], [u - 3.5, base + 7.0]);
                }
                let _ = writeln!(
                    self.svg,
                    "<path class=\"ink\" style=\"fill:var(--paper)\" d=\"M{0} {1}L{2} {3}H{4}Z\"/>\
                     <path class=\"ink\" d=\"M{5} {3}H{6}\"/><path class=\"thin\" d=\"{hatching}\"/>",
                    pixel(x),
                    pixel(y),
                    pixel(x - 9.0),
                    pixel(base),
                    pixel(x + 9.0),
                    pixel(x - half - 3.0),
                    pixel(x + half + 3.0),
                );
                self.labels.avoid([x, base], 12.0);
            }
            let _ = match pin {
                Some(_) => writeln!(
                    self.svg,
                    "<circle class=\"pin\" cx=\"{}\" cy=\"{}\" r=\"4.6\"/>",
                    pixel(x),
                    pixel(y)
                ),
                None => writeln!(
                    self.svg,
                    "<circle cx=\"{}\" cy=\"{}\" r=\"2.8\" style=\"fill:var(--ink)\"/>",
                    pixel(x),
                    pixel(y)
                ),
            };
            self.labels.avoid(at, 5.0);
            self.labels.add(name, false, at, [0.7, -0.7], 13.0);
        }
    }
}

/// The direction across a slide's guide, and the sign of the side on which its rail lies: away
/// from what the slide touches, else on the picture's lower side.
fn rail(slide: &SlideAt, view: &View) -> (Point, f64) {
    let across = normal(view.direction(slide.along));
    let away = match slide.touches {
        Some(touches) => view.direction(touches).map(|c| -c),
        None => [1e-6, 1.0],
    };
    let inside = across[0] * away[0] + across[1] * away[1] < 0.0;
    (across, if inside { -1.0 } else { 1.0 })
}

fn scale_bar(view: &View) -> String {
    let y = view.size[1] - 18.0;
    let long = scale::round_step(0.5 * 150.0 / view.scale);
    let wide = long * view.scale;
    let (left, right) = (16.0, 16.0 + wide);
    format!(
        "<path class=\"thin\" d=\"M{0} {2}v8m0 -4H{1}m0 -4v8\"/>\
         <text class=\"soft\" x=\"{3}\" y=\"{4}\">{5}</text>\n",
        pixel(left),
        pixel(right),
        pixel(y - 4.0),
        pixel(right + 8.0),
        pixel(y + 4.0),
        scale::with_unit(long, "m", 3)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_four_bar_is_drawn_to_scale() {
        let places = Places {
            links: vec![
                ("crank".to_owned(), vec![[0.0, 0.0], [0.0, 0.01]]),
                ("coupler".to_owned(), vec![[0.0, 0.01], [0.03, 0.01]]),
            ],
            marks: vec![("<O1>".to_owned(), [0.0, 0.0], Some(true))],
            ..Places::default()
        };
        let view = View::around(&layout(&places)).unwrap();
        let [a, b] = [view.at([0.0, 0.0]), view.at([0.03, 0.01])];
        assert!(((b[0] - a[0]) / (a[1] - b[1]) - 3.0).abs() < 1e-9);
        let (svg, caption) = mechanism(&places).unwrap();
        assert!(svg.contains("&lt;O1&gt;") && !svg.contains("<O1>"));
        assert!(svg.contains("mm</text>") && caption.contains("to scale"));
    }

    #[test]
    fn nothing_one_thing_and_what_is_no_number() {
        assert_eq!(mechanism(&Places::default()), None);
        let slide = |at| ("mass".to_owned(), at, [1.0, 0.0]);
        let one = Places {
            slides: vec![slide(None)],
            ..Places::default()
        };
        let (svg, _) = mechanism(&one).unwrap();
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
        let broken = Places {
            links: vec![("a".to_owned(), vec![[f64::NAN, 0.0], [1.0, 0.0]])],
            slides: vec![slide(Some([0.0, 1.0]))],
            ..Places::default()
        };
        let (svg, _) = mechanism(&broken).unwrap();
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }
}
