//! Random mechanisms, grown loop by loop: text of model files whose loops close as drawn.
//!
//! Each step adds a coordinate (a link or a slide on any body that is there), or a pair of bodies
//! between two bodies that are there. All numbers are literals: every mechanism is a model of its
//! own. Bodies are placed while they are written, so that each is drawn where its loop closes.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use super::random::Random;

mod forces;
mod loops;

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
}
