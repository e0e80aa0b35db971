//! Lines of a picture, in pixels: paths as SVG writes them, and the little geometry they take.

use std::fmt::Write;

use crate::assembled::Point;

use super::svg::pixel;

/// A bar with round ends.
pub fn bar(a: Point, b: Point, width: f64) -> String {
    if length(minus(b, a)) == 0.0 {
        return polygon(&[a, b]);
    }
    let side = normal(unit(minus(b, a)));
    let r = width / 2.0;
    let [p, q] = [shifted(a, side, r), shifted(b, side, r)];
    let [s, t] = [shifted(b, side, -r), shifted(a, side, -r)];
    let r = pixel(r);
    format!(
        "M{} {}L{} {}A{r} {r} 0 0 1 {} {}L{} {}A{r} {r} 0 0 1 {} {}Z",
        pixel(p[0]),
        pixel(p[1]),
        pixel(q[0]),
        pixel(q[1]),
        pixel(s[0]),
        pixel(s[1]),
        pixel(t[0]),
        pixel(t[1]),
        pixel(p[0]),
        pixel(p[1])
    )
}

/// A bar with square ends.
pub fn bar_square(a: Point, b: Point, half: f64) -> String {
    let side = normal(unit(minus(b, a)));
    polygon(&[
        shifted(a, side, half),
        shifted(b, side, half),
        shifted(b, side, -half),
        shifted(a, side, -half),
    ])
}

/// A closed outline through all corners.
pub fn polygon(corners: &[Point]) -> String {
    let mut path = String::new();
    for (k, [x, y]) in corners.iter().enumerate() {
        let pen = if k == 0 { 'M' } else { 'L' };
        let _ = write!(path, "{pen}{} {}", pixel(*x), pixel(*y));
    }
    path + "Z"
}

/// A zigzag of half turns with straight ends, which take what is too long for it.
pub fn coil(a: Point, b: Point, turns: i32) -> String {
    let long = length(minus(b, a));
    let side = normal(unit(minus(b, a)));
    let coiled = (0.7 * long).min(110.0) / long;
    let start = 0.5 - coiled / 2.0;
    let mut path = format!("M{} {}", pixel(a[0]), pixel(a[1]));
    let mut to = |p: Point| {
        let _ = write!(path, "L{} {}", pixel(p[0]), pixel(p[1]));
    };
    to(between(a, b, start));
    for k in 0..turns {
        let share = start + coiled * (f64::from(k) + 0.5) / f64::from(turns);
        let swing = if k % 2 == 0 { 7.0 } else { -7.0 };
        to(shifted(between(a, b, share), side, swing));
    }
    to(between(a, b, start + coiled));
    to(b);
    path
}

/// A straight line.
pub fn line(a: Point, b: Point) -> String {
    format!(
        "M{} {}L{} {}",
        pixel(a[0]),
        pixel(a[1]),
        pixel(b[0]),
        pixel(b[1])
    )
}

/// An arrow head at `tip`.
pub fn head(tail: Point, tip: Point, size: f64) -> String {
    let along = unit(minus(tip, tail));
    let side = normal(along);
    let back = shifted(tip, along, -size);
    let (left, right) = (
        shifted(back, side, 0.6 * size),
        shifted(back, side, -0.6 * size),
    );
    line(left, tip) + &line(tip, right)
}

/// a − b.
pub fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

/// `p` moved along `direction`.
pub fn shifted(p: Point, direction: Point, by: f64) -> Point {
    [p[0] + by * direction[0], p[1] + by * direction[1]]
}

/// The point that divides the way from `a` to `b` by `share`.
pub fn between(a: Point, b: Point, share: f64) -> Point {
    shifted(a, minus(b, a), share)
}

/// The mean of points.
pub fn center(points: &[Point]) -> Point {
    let sum = points
        .iter()
        .fold([0.0; 2], |s, p| [s[0] + p[0], s[1] + p[1]]);
    sum.map(|s| s / points.len() as f64)
}

/// Length of a vector.
pub fn length([x, y]: Point) -> f64 {
    x.hypot(y)
}

/// A vector of length one; along x if there is no direction.
pub fn unit(p: Point) -> Point {
    let long = length(p);
    if long > 0.0 {
        p.map(|c| c / long)
    } else {
        [1.0, 0.0]
    }
}

/// The vector a quarter turn away, to the left as the picture stands.
pub fn normal([x, y]: Point) -> Point {
    [y, -x]
}

/// Whether all coordinates are numbers.
pub fn all_finite(points: &[Point]) -> bool {
    points.iter().flatten().all(|c| c.is_finite())
}
