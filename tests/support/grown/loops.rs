//! Loops by kind: pairs of bodies between two bodies that are there, a platform on three links, a
//! trammel.

use std::f64::consts::PI;
use std::fmt::Write;

use super::{Anchor, Grower, Plane, add, cross, dot, length, metres, sub, turned};

impl Grower<'_> {
    /// RRR: two links that meet in a pin.
    pub(super) fn two_links(&mut self) -> Option<()> {
        let (first, second) = self.pair();
        let (p, q) = (self.anchor(first), self.anchor(second));
        let middle = [0.5 * (p.at[0] + q.at[0]), 0.5 * (p.at[1] + q.at[1])];
        let at = self.near(middle);
        let (u, v) = (sub(at, p.at), sub(at, q.at));
        let sizes = length(u) * length(v);
        if length(u).min(length(v)) < 8e-3 || (cross(u, v) / sizes).abs() < 0.3 {
            return None;
        }
        let meet = self.name('M');
        let one = self.link((&p.name, p.at), (&meet, at), false);
        let other = self.link((&q.name, q.at), (&meet, at), false);
        self.pin(&p.name, &[first, one]);
        self.pin(&q.name, &[second, other]);
        self.pin(&meet, &[one, other]);
        self.anchors.push(Anchor {
            name: meet,
            body: one,
            at,
        });
        Some(())
    }

    /// RRP: a link pinned to a slide.
    pub(super) fn link_and_slide(&mut self) -> Option<()> {
        let (first, second) = self.pair();
        let p = self.anchor(first);
        let at = self.near(p.at);
        let u = sub(at, p.at);
        let along = self.direction();
        if (dot(u, along) / length(u)).abs() < 0.3 {
            return None;
        }
        let travel = self.random.between(-0.02, 0.02);
        let local = [
            self.random.between(-5e-3, 5e-3),
            self.random.between(-5e-3, 5e-3),
        ];
        let offset = turned(self.frames[second].angle, local);
        let origin = sub(sub(at, offset), [travel * along[0], travel * along[1]]);
        let slide = self.slide(second, along, travel, origin, false);
        let meet = self.name('M');
        let name = self.frames[slide].name.clone();
        let _ = writeln!(self.text, "point {meet} on {name} at {}", metres(local));
        let link = self.link((&p.name, p.at), (&meet, at), false);
        self.pin(&p.name, &[first, link]);
        self.pin(&meet, &[slide, link]);
        Some(())
    }

    /// A link whose free end another body may be pinned to.
    fn take_free_end(&mut self, but: Option<usize>) -> Option<(usize, String, Plane)> {
        let free: Vec<usize> = (0..self.frames.len())
            .filter(|body| Some(*body) != but && self.frames[*body].free_end.is_some())
            .collect();
        if free.is_empty() {
            return None;
        }
        let body = free[self.random.below(free.len())];
        let (name, at) = self.frames[body].free_end.take()?;
        Some((body, name, at))
    }

    /// RPR: a link, and a slide on it that is pinned to the free end of another.
    pub(super) fn slide_on_link(&mut self) -> Option<()> {
        let (body, end, at) = self.take_free_end(None)?;
        let mut first = self.body();
        while first == body {
            first = self.body();
        }
        let p = self.anchor(first);
        let far = self.near(p.at);
        let tip = self.name('E');
        let link = self.link((&p.name, p.at), (&tip, far), false);
        self.frames[link].free_end = Some((tip, far));
        let along = self.direction();
        let way = sub(at, p.at);
        if length(way) < 8e-3 || (dot(way, along) / length(way)).abs() < 0.3 {
            return None;
        }
        let travel = self.random.between(-0.02, 0.02);
        let local = [
            self.random.between(-5e-3, 5e-3),
            self.random.between(-5e-3, 5e-3),
        ];
        let offset = turned(self.frames[link].angle, local);
        let origin = sub(sub(at, offset), [travel * along[0], travel * along[1]]);
        let slide = self.slide(link, along, travel, origin, false);
        let name = self.frames[slide].name.clone();
        let _ = writeln!(self.text, "point {end} on {name} at {}", metres(local));
        self.pin(&p.name, &[first, link]);
        self.pin(&end, &[slide, body]);
        Some(())
    }

    /// RPP: a slide on a slide, pinned to the free end of a link.
    pub(super) fn two_slides(&mut self) -> Option<()> {
        let (body, end, at) = self.take_free_end(None)?;
        let mut first = self.body();
        while first == body {
            first = self.body();
        }
        let (one, other) = (self.direction(), self.direction());
        if cross(one, other).abs() < 0.3 {
            return None;
        }
        let travels = [0; 2].map(|_| self.random.between(-0.02, 0.02));
        let local = [
            self.random.between(-5e-3, 5e-3),
            self.random.between(-5e-3, 5e-3),
        ];
        let offset = turned(self.frames[first].angle, local);
        let second_origin = sub(
            sub(at, offset),
            [travels[1] * other[0], travels[1] * other[1]],
        );
        let origin = sub(
            second_origin,
            [travels[0] * one[0] + 2e-3, travels[0] * one[1] - 1e-3],
        );
        let lower = self.slide(first, one, travels[0], origin, false);
        let upper = self.slide(lower, other, travels[1], second_origin, false);
        let name = self.frames[upper].name.clone();
        let _ = writeln!(self.text, "point {end} on {name} at {}", metres(local));
        self.pin(&end, &[upper, body]);
        Some(())
    }

    /// A triad: a body on three links to three bodies, which closes two loops together.
    pub(super) fn platform(&mut self) -> Option<()> {
        let first = self.random.below(self.frames.len());
        let carriers = [0, 1, 2].map(|k| (first + k) % self.frames.len());
        let feet = carriers.map(|carrier| self.anchor(carrier));
        let middle = [0, 1].map(|axis| feet.iter().map(|f| f.at[axis]).sum::<f64>() / 3.0);
        let center = self.near(middle);
        let angle = self.random.between(-PI, PI);
        let corners = [0.0, 2.1, 4.2].map(|turn| add(center, turned(angle + turn, [0.02, 0.0])));
        let ways = [0, 1, 2].map(|k| sub(corners[k], feet[k].at));
        // Forces along three links that hold a body: their lines must not meet in one point.
        let lines = ways.map(|way| {
            let size = length(way);
            [way[0] / size, way[1] / size]
        });
        let moments = [0, 1, 2].map(|k| cross(sub(corners[k], center), lines[k]) / 0.02);
        let determinant = moments[0] * cross(lines[1], lines[2])
            + moments[1] * cross(lines[2], lines[0])
            + moments[2] * cross(lines[0], lines[1]);
        if determinant.abs() < 0.4 || ways.iter().any(|way| length(*way) < 8e-3) {
            return None;
        }
        let names = [0; 3].map(|_| self.name('C'));
        let body = self.link((&names[0], corners[0]), (&names[1], corners[1]), false);
        let frame = &self.frames[body];
        let local = turned(-frame.angle, sub(corners[2], frame.origin));
        let _ = writeln!(
            self.text,
            "point {} on {} at {}",
            names[2],
            frame.name,
            metres(local)
        );
        for (k, foot) in feet.iter().enumerate() {
            let leg = self.link((&foot.name, foot.at), (&names[k], corners[k]), false);
            self.pin(&foot.name, &[carriers[k], leg]);
            self.pin(&names[k], &[body, leg]);
        }
        Some(())
    }

    /// PRP after a coordinate: a link between two slides, whose angle is the coordinate.
    pub(super) fn trammel(&mut self) -> Option<()> {
        let carriers = [self.body(), self.body()];
        let directions = [self.direction(), self.direction()];
        if cross(directions[0], directions[1]).abs() < 0.3 {
            return None;
        }
        let start = add(self.frames[carriers[0]].origin, [0.01, 0.005]);
        let end = self.near(start);
        let mut ends = Vec::new();
        for ((carrier, along), at) in carriers.into_iter().zip(directions).zip([start, end]) {
            let travel = self.random.between(-0.02, 0.02);
            let origin = sub(at, [travel * along[0], travel * along[1]]);
            let slide = self.slide(carrier, along, travel, origin, false);
            let name = self.name('M');
            let on = self.frames[slide].name.clone();
            let _ = writeln!(self.text, "point {name} on {on} at (0 m, 0 m)");
            ends.push((name, at, slide));
        }
        let link = self.link((&ends[0].0, ends[0].1), (&ends[1].0, ends[1].1), true);
        for (name, _, slide) in &ends {
            self.pin(name, &[*slide, link]);
        }
        let name = self.frames[link].name.clone();
        self.asked.push(format!("{name}.angle"));
        Some(())
    }
}
