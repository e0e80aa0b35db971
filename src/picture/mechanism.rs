//! The mechanism as assembled, drawn to scale in the signs that engineers use: links with their
//! pins, ground hatched, slides on their guides, springs, stacks and contacts, names, a scale bar.
//! Places and lengths of links are to scale; the signs for pins, slides and contacts are not.

use std::fmt::Write;

use super::labels::Labels;
use super::layout::{Layout, SlideAt, extent, layout};
use super::plot::marker;
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
pub fn mechanism(places: &Places) -> Option<(String, String)> {
    let rest = layout(places);
    let view = View::around(&[&rest])?;
    let picture = Picture::of(&rest, &rest, &view);
    let mut paths = String::new();
    for (look, line) in &picture.paths {
        let _ = writeln!(paths, "<path {look} d=\"{line}\"/>");
    }
    let svg = element(&picture, &paths, &rest, &view, "the mechanism as assembled");
    Some((svg, said(&rest).to_owned()))
}

/// The picture in motion: places at instants, of which the first is drawn as assembled. What
/// moves has its line at every instant in `data-d`, separated by bars, for a script to show.
/// Displacements are magnified; with the magnification in words.
pub fn moving(places: &Places, frames: &[Places]) -> Option<(String, String)> {
    let rest = layout(places);
    let (size, _) = extent(&all_points(&rest));
    let largest = largest_displacement(frames);
    let wanted = VISIBLE * size / largest;
    let magnification = match wanted {
        wanted if !rest.to_scale || !wanted.is_finite() || wanted < 2.0 => 1.0,
        wanted => round_down(wanted),
    };
    let layouts: Vec<Layout> = frames
        .iter()
        .map(|frame| moved(&rest, &frames[0], frame, magnification))
        .collect();
    let view = View::around(&layouts.iter().chain([&rest]).collect::<Vec<_>>())?;
    let pictures: Vec<Picture> = layouts
        .iter()
        .map(|layout| Picture::of(layout, &rest, &view))
        .collect();
    let still = Picture::of(&rest, &rest, &view);
    let mut paths = String::new();
    for (index, (look, line)) in still.paths.iter().enumerate() {
        let lines: Vec<&str> = pictures
            .iter()
            .filter_map(|picture| picture.paths.get(index))
            .map(|(_, line)| line.as_str())
            .collect();
        let is_moving = lines.len() == frames.len() && lines.iter().any(|other| other != line);
        let _ = if is_moving {
            let lines = lines.join("|");
            writeln!(paths, "<path {look} d=\"{line}\" data-d=\"{lines}\"/>")
        } else {
            writeln!(paths, "<path {look} d=\"{line}\"/>")
        };
    }
    let svg = element(&still, &paths, &rest, &view, "the mechanism in motion");
    let magnified = match magnification {
        1.0 => "Displacements are to scale.".to_owned(),
        times => format!(
            "Displacements are magnified {} times.",
            scale::number(times, 6)
        ),
    };
    Some((svg, format!("{} {magnified}", said(&rest))))
}

const LINK: &str = "class=\"link\"";
const INK: &str = "class=\"ink\"";
const THIN: &str = "class=\"thin\"";
/// How far things move in a picture, as a share of its size.
const VISIBLE: f64 = 0.09;

/// The next of 1, 2, 5 times a power of ten that is at most `value`.
fn round_down(value: f64) -> f64 {
    1.0 / scale::round_step(1.0 / value)
}

/// The largest displacement of anything from the first frame.
fn largest_displacement(frames: &[Places]) -> f64 {
    let points = |places: &Places| -> Vec<Point> {
        let links = places.links.iter().flat_map(|(_, corners)| corners.clone());
        let slides = places.slides.iter().filter_map(|(_, at, _)| *at);
        links.chain(slides).collect()
    };
    let Some(first) = frames.first().map(&points) else {
        return 0.0;
    };
    frames
        .iter()
        .flat_map(|frame| points(frame).into_iter().zip(&first))
        .map(|(p, q)| length(minus(p, *q)))
        .filter(|long| long.is_finite())
        .fold(0.0, f64::max)
}

/// The layout with magnified displacements from the `first` places to `now`.
fn moved(rest: &Layout, first: &Places, now: &Places, times: f64) -> Layout {
    let by = |p: Point, from: Point, to: Point| shifted(p, minus(to, from), times);
    let mut layout = rest.clone();
    for (index, (_, corners)) in layout.links.iter_mut().enumerate() {
        let ends = first.links[index].1.iter().zip(&now.links[index].1);
        for (corner, (from, to)) in corners.iter_mut().zip(ends) {
            *corner = by(*corner, *from, *to);
        }
    }
    let slide = |index: usize, p: Point| match (first.slides[index].1, now.slides[index].1) {
        (Some(from), Some(to)) => by(p, from, to),
        _ => p,
    };
    for (index, at) in layout.slides.iter_mut().enumerate() {
        at.at = slide(index, at.at);
    }
    for (index, (_, at, _)) in layout.marks.iter_mut().enumerate() {
        *at = by(*at, first.marks[index].1, now.marks[index].1);
    }
    for (index, spring) in layout.springs.iter_mut().enumerate() {
        for end in 0..2 {
            let known = (
                first.springs[index].ends[end].1,
                now.springs[index].ends[end].1,
            );
            spring.ends[end] = match (spring.slides[end], known) {
                (_, (Some(from), Some(to))) => by(spring.ends[end], from, to),
                (Some(of), _) => slide(of, spring.ends[end]),
                _ => spring.ends[end],
            };
        }
    }
    for (index, contact) in layout.contacts.iter_mut().enumerate() {
        let ends = first.contacts[index]
            .ends
            .iter()
            .zip(&now.contacts[index].ends);
        let known = ends.filter_map(|(from, to)| Some((from.1?, to.1?))).next();
        if let (Some((from, to)), None) = (known, contact.rail_of) {
            contact.at = by(contact.at, from, to);
        }
    }
    layout
}

fn element(picture: &Picture, paths: &str, rest: &Layout, view: &View, label: &str) -> String {
    let names = picture.labels.place(view.size);
    let [width, height] = view.size;
    let bar = if rest.to_scale {
        scale_bar(view)
    } else {
        String::new()
    };
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" style=\"max-width:{0}px\" \
         role=\"img\" aria-label=\"{label}\">\n{paths}{names}{bar}</svg>\n",
        pixel(width),
        pixel(height),
    )
}

fn said(layout: &Layout) -> &'static str {
    match (layout.to_scale, layout.fitted) {
        (true, false) => "As assembled, to scale; signs for pins, slides and springs are not.",
        (true, true) => {
            "As assembled, to scale; slides without a place in the model stand beside what they act on."
        }
        (false, _) => "Nothing has a place in this model: arranged by what acts on what.",
    }
}

/// How metres become pixels.
struct View {
    scale: f64,
    low: Point,
    size: Point,
}

impl View {
    fn around(layouts: &[&Layout]) -> Option<View> {
        let layout = layouts.last()?;
        let points: Vec<Point> = layouts
            .iter()
            .flat_map(|layout| all_points(layout))
            .collect();
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
    /// What a path looks like (its attributes), and its line.
    paths: Vec<(&'static str, String)>,
    labels: Labels,
}

impl Picture {
    /// The whole mechanism; hatched ground and guides stand where they are at `rest`.
    fn of(layout: &Layout, rest: &Layout, view: &View) -> Self {
        let mut picture = Picture {
            paths: Vec::new(),
            labels: Labels::default(),
        };
        picture.slides(layout, rest, view);
        picture.links(layout, view);
        picture.springs(layout, rest, view);
        picture.contacts(layout, view);
        picture.marks(layout, view);
        picture
    }

    fn path(&mut self, look: &'static str, line: String) {
        self.paths.push((look, line));
    }

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
            self.path(LINK, outline);
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

    fn slides(&mut self, layout: &Layout, rest: &Layout, view: &View) {
        for (slide, at_rest) in layout.slides.iter().zip(&rest.slides) {
            let at = view.at(at_rest.at);
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
            self.path(THIN, hatching);
            self.path(INK, line(place(-rail, rail_at), place(rail, rail_at)));
            let moved = minus(view.at(slide.at), at);
            let place = |u: f64, v: f64| shifted(place(u, v), moved, 1.0);
            let block = [
                place(-half, -depth),
                place(half, -depth),
                place(half, depth),
                place(-half, depth),
            ];
            self.path("class=\"slide\"", polygon(&block));
            let (tail, tip) = (place(-half * 0.45, 0.0), place(half * 0.55, 0.0));
            self.path(THIN, line(tail, tip) + &head(tail, tip, 5.0));
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

    fn springs(&mut self, layout: &Layout, rest: &Layout, view: &View) {
        for (spring, at_rest) in layout.springs.iter().zip(&rest.springs) {
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
            // As many layers and turns in motion as at rest.
            let long = length(minus(view.at(at_rest.ends[1]), view.at(at_rest.ends[0])));
            let layers = ((long / 7.0).round() as usize).clamp(2, 40);
            let turns = ((0.7 * long).min(110.0) / 8.0).round().clamp(4.0, 12.0) as i32;
            let toward = minus(b, a);
            if toward[0] * along[0] + toward[1] * along[1] > 14.0 {
                if spring.stack {
                    self.stack(a, b, layers);
                } else {
                    self.path("class=\"spring\"", coil(a, b, turns));
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
        self.path(THIN, hatching);
        self.path(
            INK,
            line(shifted(at, across, -half), shifted(at, across, half)),
        );
        self.labels.avoid(shifted(at, outward, 3.0), half);
    }

    /// A ceramic: a block of layers between its ends.
    fn stack(&mut self, a: Point, b: Point, layers: usize) {
        let outline = bar_square(a, b, 9.0);
        self.path("class=\"piezo\"", outline);
        let across = normal(unit(minus(b, a)));
        let mut strokes = String::new();
        for k in 1..layers {
            let p = between(a, b, k as f64 / layers as f64);
            strokes += &line(shifted(p, across, -9.0), shifted(p, across, 9.0));
        }
        self.path("class=\"piezo\" style=\"stroke-width:0.8\"", strokes);
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
            let heads = head(back, front, 6.0) + &head(front, back, 6.0);
            self.path("class=\"contact\"", line(back, front) + &heads);
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
                let foot = [[x, y], [x - 9.0, base], [x + 9.0, base]];
                self.path("class=\"ink\" style=\"fill:var(--paper)\"", polygon(&foot));
                let ends = [x - half - 3.0, x + half + 3.0].map(|x| [x, base]);
                self.path(INK, line(ends[0], ends[1]));
                self.path(THIN, hatching);
                self.labels.avoid([x, base], 12.0);
            }
            match pin {
                Some(_) => self.path("class=\"pin\"", marker(0, at, 4.6)),
                None => self.path("style=\"fill:var(--ink)\"", marker(0, at, 2.8)),
            }
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
        let view = View::around(&[&layout(&places)]).unwrap();
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

    #[test]
    fn displacements_are_magnified_by_a_round_number() {
        let frame = |by: f64| Places {
            links: vec![("arm".to_owned(), vec![[0.0, 0.0], [by, 0.02]])],
            marks: vec![("O".to_owned(), [0.0, 0.0], Some(true))],
            slides: vec![("stage".to_owned(), Some([0.01 + by, 0.03]), [1.0, 0.0])],
            ..Places::default()
        };
        let frames = [frame(0.0), frame(7e-6), frame(-7e-6)];
        let (svg, caption) = moving(&frame(0.0), &frames).unwrap();
        // 9 % of 30 mm are 386 times 7 µm.
        assert!(caption.contains("magnified 200 times"), "{caption}");
        // The arm, the slide's block and its arrow move; pin, ground and guide stand still.
        assert_eq!(svg.matches("data-d=").count(), 3, "{svg}");
        let arm = svg
            .lines()
            .find(|line| line.contains("class=\"link\""))
            .unwrap();
        let frames = arm.split("data-d=\"").nth(1).unwrap();
        assert_eq!(frames.split('|').count(), 3, "{arm}");
        let still = [frame(0.0), frame(0.0)];
        let (svg, caption) = moving(&frame(0.0), &still).unwrap();
        assert!(
            !svg.contains("data-d") && caption.contains("to scale"),
            "{caption}"
        );
    }
}
