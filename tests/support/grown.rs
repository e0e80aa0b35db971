//! Random mechanisms, grown loop by loop: text of model files whose loops close as drawn.
//!
//! Each step adds a coordinate (a link or a slide on any body that is there), or a pair of bodies
//! between two bodies that are there. All numbers are literals: every mechanism is a model of its
//! own. Bodies are placed while they are written, so that each is drawn where its loop closes.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use super::random::Random;

type Plane = [f64; 2];

/// A mechanism as text.
pub struct Grown {
    /// The model file.
    pub text: String,
    /// Loops that were added.
    pub loops: usize,
    /// Coordinates that were added.
    pub coordinates: usize,
    /// What it has besides dyads, by name.
    pub features: Vec<&'static str>,
}

/// A body that is there.
struct Frame {
    name: String,
    origin: Plane,
    angle: f64,
    /// The end of a link that nothing is pinned to yet, and where it is.
    free_end: Option<(String, Plane)>,
    /// For a slide on ground, its guide.
    guide: Option<Plane>,
    /// Joints on it.
    joints: usize,
    is_link: bool,
}

/// A named place.
#[derive(Clone)]
struct Anchor {
    name: String,
    body: usize,
    at: Plane,
}

struct Grower<'r> {
    random: &'r mut Random,
    text: String,
    frames: Vec<Frame>,
    anchors: Vec<Anchor>,
    /// Pins with the bodies that meet there.
    pins: Vec<(String, Vec<usize>)>,
    names: usize,
    features: Vec<&'static str>,
    asked: Vec<String>,
    ask: bool,
}

fn add(a: Plane, b: Plane) -> Plane {
    [a[0] + b[0], a[1] + b[1]]
}

fn sub(a: Plane, b: Plane) -> Plane {
    [a[0] - b[0], a[1] - b[1]]
}

fn turned(angle: f64, a: Plane) -> Plane {
    let (sin, cos) = angle.sin_cos();
    [cos * a[0] - sin * a[1], sin * a[0] + cos * a[1]]
}

fn length(a: Plane) -> f64 {
    a[0].hypot(a[1])
}

fn cross(a: Plane, b: Plane) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn dot(a: Plane, b: Plane) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn metres([x, y]: Plane) -> String {
    format!("({x:e} m, {y:e} m)")
}

/// A random mechanism; `None` where a step found no place for its bodies.
pub fn grown(random: &mut Random, loops: usize, coordinates: usize) -> Option<Grown> {
    let ask = random.below(3) > 0;
    let mut grower = Grower {
        random,
        text: "model grown\n".to_owned(),
        frames: vec![Frame {
            name: "ground".to_owned(),
            origin: [0.0; 2],
            angle: 0.0,
            free_end: None,
            guide: None,
            joints: 0,
            is_link: false,
        }],
        anchors: Vec::new(),
        pins: Vec::new(),
        names: 0,
        features: Vec::new(),
        asked: Vec::new(),
        ask,
    };
    let (mut loops_left, mut coordinates_left) = (loops, coordinates);
    while loops_left > 0 || coordinates_left > 0 {
        let first = grower.frames.len() == 1;
        let coordinate = coordinates_left > 0
            && (first || loops_left == 0 || grower.random.below(loops_left + 1) == 0);
        if coordinate && loops_left > 0 && grower.random.below(4) == 0 {
            grower.trammel()?;
            loops_left -= 1;
            coordinates_left -= 1;
        } else if coordinate {
            grower.coordinate();
            coordinates_left -= 1;
        } else {
            if loops_left >= 2 && grower.frames.len() >= 3 && grower.random.below(5) == 0 {
                grower.platform()?;
                loops_left -= 1;
            } else {
                match grower.random.below(6) {
                    0 => grower.two_links()?,
                    1 => grower.link_and_slide()?,
                    2 | 3 => grower.slide_on_link()?,
                    _ => grower.two_slides()?,
                }
            }
            loops_left -= 1;
        }
    }
    grower.forces();
    if grower.frames.iter().any(|f| f.is_link && f.joints >= 3) {
        grower.features.push("ternary body");
    }
    if grower.pins.iter().any(|(_, bodies)| bodies.len() >= 3) {
        grower.features.push("several bodies in one pin");
    }
    if ask {
        for name in grower.asked.clone() {
            let _ = writeln!(grower.text, "coordinate {name}");
        }
    } else {
        grower.features.push("coordinates chosen");
    }
    Some(Grown {
        text: grower.text,
        loops,
        coordinates,
        features: grower.features,
    })
}

impl Grower<'_> {
    fn name(&mut self, letter: char) -> String {
        self.names += 1;
        format!("{letter}{}", self.names)
    }

    fn body(&mut self) -> usize {
        self.random.below(self.frames.len())
    }

    /// A place on a body: one that is there, or a new one.
    fn anchor(&mut self, body: usize) -> Anchor {
        let known: Vec<Anchor> = self
            .anchors
            .iter()
            .filter(|anchor| anchor.body == body)
            .cloned()
            .collect();
        if !known.is_empty() && self.random.below(3) == 0 {
            return known[self.random.below(known.len())].clone();
        }
        let name = self.name('P');
        let local = [
            self.random.between(-0.01, 0.04),
            self.random.between(-0.02, 0.02),
        ];
        let frame = &self.frames[body];
        let at = add(frame.origin, turned(frame.angle, local));
        let _ = if body == 0 {
            writeln!(self.text, "ground {name} = {}", metres(local))
        } else {
            writeln!(
                self.text,
                "point {name} on {} at {}",
                frame.name,
                metres(local)
            )
        };
        let anchor = Anchor { name, body, at };
        self.anchors.push(anchor.clone());
        anchor
    }

    /// A named place joins bodies.
    fn pin(&mut self, name: &str, bodies: &[usize]) {
        for &body in bodies {
            match self.pins.iter_mut().find(|(known, _)| known == name) {
                Some((_, members)) if members.contains(&body) => continue,
                Some((_, members)) => members.push(body),
                None => self.pins.push((name.to_owned(), vec![body])),
            }
            self.frames[body].joints += 1;
        }
    }

    fn mass(&mut self, size: f64) -> String {
        let mass = self.random.scale(1e-3, 1e-2);
        let mut text = format!("mass = {mass:e} kg");
        if self.random.below(3) > 0 {
            self.features.push("off-axis mass");
            let center = [
                size * self.random.between(0.0, 1.0),
                size * self.random.between(-0.5, 0.5),
            ];
            let inertia = mass * size * size * self.random.between(0.05, 0.3);
            let _ = write!(
                text,
                ", com = {}, inertia = {inertia:e} kg*m^2",
                metres(center)
            );
        }
        text
    }

    fn angle_text(&mut self, angle: f64, exact: bool) -> String {
        let exact = if exact && self.ask { " exact" } else { "" };
        format!("{angle:e} rad{exact}")
    }

    /// Writes a link between two named places.
    fn link(&mut self, from: (&str, Plane), to: (&str, Plane), exact: bool) -> usize {
        let name = self.name('b');
        let way = sub(to.1, from.1);
        let (size, angle) = (length(way), way[1].atan2(way[0]));
        let mass = self.mass(size);
        let angle_text = self.angle_text(angle, exact);
        let _ = writeln!(
            self.text,
            "link {name} from {} to {} {{ length = {size:e} m, angle = {angle_text}, {mass} }}",
            from.0, to.0
        );
        self.frames.push(Frame {
            name,
            origin: from.1,
            angle,
            free_end: None,
            guide: None,
            joints: 0,
            is_link: true,
        });
        self.frames.len() - 1
    }

    /// Writes a slide on a body along a direction of the fixed frame, `at` along it.
    fn slide(
        &mut self,
        carrier: usize,
        along: Plane,
        at: f64,
        origin: Plane,
        exact: bool,
    ) -> usize {
        let name = self.name('s');
        let frame = &self.frames[carrier];
        let (angle, from) = (frame.angle, frame.origin);
        let (on, guide) = if carrier == 0 {
            (String::new(), Some(along))
        } else {
            (format!(" on {}", frame.name), None)
        };
        if carrier != 0 {
            self.features.push("moving guide");
        }
        let direction = turned(-angle, along);
        let through = turned(-angle, sub(origin, from));
        let mass = self.mass(0.01);
        let exact = if exact && self.ask { " exact" } else { "" };
        let _ = writeln!(
            self.text,
            "slide {name}{on} along ({:e}, {:e}) through {} {{ at = {at:e} m{exact}, {mass} }}",
            direction[0],
            direction[1],
            metres(through),
        );
        self.frames[carrier].joints += 1;
        self.features.push("prismatic joint");
        self.frames.push(Frame {
            name,
            origin: add(origin, [at * along[0], at * along[1]]),
            angle,
            free_end: None,
            guide,
            joints: 1,
            is_link: false,
        });
        self.frames.len() - 1
    }

    fn direction(&mut self) -> Plane {
        turned(self.random.between(-PI, PI), [1.0, 0.0])
    }

    /// A link or a slide that moves by itself.
    fn coordinate(&mut self) {
        let carrier = self.body();
        if self.random.below(4) == 0 {
            let (along, at) = (self.direction(), self.random.between(-0.02, 0.02));
            let origin = add(self.frames[carrier].origin, [0.005, 0.002]);
            let slide = self.slide(carrier, along, at, origin, true);
            let name = self.frames[slide].name.clone();
            self.asked.push(format!("{name}.travel"));
            return;
        }
        let from = self.anchor(carrier);
        let size = self.random.between(0.015, 0.05);
        let to = add(from.at, turned(self.random.between(-PI, PI), [size, 0.0]));
        let end = self.name('E');
        let link = self.link((&from.name, from.at), (&end, to), true);
        self.pin(&from.name, &[carrier, link]);
        self.frames[link].free_end = Some((end, to));
        let name = self.frames[link].name.clone();
        self.asked.push(format!("{name}.angle"));
    }

    /// Two different bodies.
    fn pair(&mut self) -> (usize, usize) {
        let first = self.body();
        let mut second = self.body();
        while second == first {
            second = self.body();
        }
        (first, second)
    }

    /// A point about a place.
    fn near(&mut self, at: Plane) -> Plane {
        let radius = self.random.between(0.01, 0.05);
        add(at, turned(self.random.between(0.0, TAU), [radius, 0.0]))
    }

    /// RRR: two links that meet in a pin.
    fn two_links(&mut self) -> Option<()> {
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
    fn link_and_slide(&mut self) -> Option<()> {
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
    fn slide_on_link(&mut self) -> Option<()> {
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
    fn two_slides(&mut self) -> Option<()> {
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
    fn platform(&mut self) -> Option<()> {
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
    fn trammel(&mut self) -> Option<()> {
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

    fn forces(&mut self) {
        let [x, y] = [0; 2].map(|_| self.random.between(-10.0, 10.0));
        let _ = writeln!(self.text, "gravity = ({x:e} m/s^2, {y:e} m/s^2)");
        for (pin, bodies) in self.pins.clone() {
            if bodies.len() < 2 || self.random.coin() {
                continue;
            }
            let names = [0, 1].map(|k| self.frames[bodies[k]].name.clone());
            let (k, c) = (self.random.scale(0.1, 5.0), self.random.scale(1e-5, 1e-3));
            let _ = writeln!(
                self.text,
                "hinge at {pin} between {}, {} {{ stiffness = {k:e} N*m/rad, damping = {c:e} N*m*s/rad }}",
                names[0], names[1]
            );
        }
        for keyword in ["spring", "stack"] {
            if self.random.coin() {
                continue;
            }
            let (first, second) = self.pair();
            let ends = [self.anchor(first), self.anchor(second)];
            if length(sub(ends[0].at, ends[1].at)) < 5e-3 {
                continue;
            }
            let name = self.name('k');
            let (k, c) = (self.random.scale(1e2, 1e4), self.random.scale(1e-2, 1.0));
            let _ = writeln!(
                self.text,
                "{keyword} {name} between {} and {} {{ stiffness = {k:e} N/m, damping = {c:e} N*s/m }}",
                ends[0].name, ends[1].name
            );
            self.features.push(keyword);
        }
        let body = 1 + self.random.below(self.frames.len() - 1);
        let place = self.anchor(body);
        let [x, y] = [0; 2].map(|_| self.random.between(-5.0, 5.0));
        let _ = writeln!(self.text, "force on {} = ({x:e} N, {y:e} N)", place.name);
        let slides: Vec<usize> = (0..self.frames.len())
            .filter(|body| self.frames[*body].guide.is_some())
            .collect();
        let links: Vec<usize> = (0..self.frames.len())
            .filter(|body| self.frames[*body].is_link)
            .collect();
        if slides.is_empty() || links.is_empty() {
            return;
        }
        let slide = slides[self.random.below(slides.len())];
        let link = links[self.random.below(links.len())];
        let place = self.anchor(link);
        let along = self.frames[slide].guide.unwrap_or([1.0, 0.0]);
        let on = self.frames[slide].name.clone();
        let _ = writeln!(
            self.text,
            "param sigma0 = 1e4 N/m, sigma1 = 5 N*s/m, sigma2 = 0.5 N*s/m, mu_s = 0.3, mu_c = 0.2, v_s = 10 mm/s\n\
             contact tip between {} and {on} {{\n  normal = ({:e}, {:e})\n  preload = 2 N\n  \
             friction = lugre(sigma0, sigma1, sigma2, mu_s, mu_c, v_s)\n}}",
            place.name, -along[1], along[0],
        );
        self.features.push("contact");
    }
}
