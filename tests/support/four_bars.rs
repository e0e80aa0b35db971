//! Model files of four-bars with everything on them, and random dimensions for them.

use std::f64::consts::PI;

use super::random::Random;

/// What is drawn how, in a model file.
#[derive(Clone, Copy, Debug)]
pub struct Layout {
    /// Which link's angle is the coordinate: 0 crank, 1 coupler, 2 rocker.
    pub coordinate: usize,
    /// Which link's angle is exact.
    pub exact: usize,
    /// Whether each link is drawn against its usual direction.
    pub reversed: [bool; 3],
    /// Whether a stack, a stage and a friction contact are attached.
    pub attached: bool,
}

/// The links' names.
pub const LINKS: [&str; 3] = ["crank", "coupler", "rocker"];

impl Layout {
    /// All of them, with or without what is attached: every coordinate, every direction of each
    /// link, the exact angle on each link in turn.
    pub fn all() -> Vec<Layout> {
        let mut layouts = Vec::new();
        for coordinate in 0..3 {
            for directions in 0..8 {
                layouts.push(Layout {
                    coordinate,
                    exact: (coordinate + [0, 0, 0, 0, 0, 0, 1, 2][directions]) % 3,
                    reversed: [0, 1, 2].map(|k| directions >> k & 1 == 1),
                    attached: directions % 3 == 0,
                });
            }
        }
        layouts
    }

    /// The model file.
    pub fn text(&self) -> String {
        let mut text = String::from("//! A four-bar with everything on it.\nmodel four_bar\n\n");
        for (name, value) in NAMES {
            text += &format!("param {name} = {value}\n");
        }
        text += "\nground O1 = (0 mm, 0 mm)\nground O2 = (gx, gy)\nground G = (hx, hy)\n\n";
        let ends = [("O1", "B"), ("B", "D"), ("O2", "D")];
        for (index, link) in LINKS.iter().enumerate() {
            let k = index + 1;
            let (mut from, mut to) = ends[index];
            if self.reversed[index] {
                (from, to) = (to, from);
            }
            let exact = if self.exact == index { " exact" } else { "" };
            text += &format!(
                "link {link} from {from} to {to} {{ length = l{k}, angle = a{k}{exact}, mass = m{k}, \
                 com = polar(r{k}, b{k}), inertia = i{k}, mass at P{k} = q{k} }}\n"
            );
        }
        for (pin, k) in [("O1", 1), ("B", 2), ("D", 3), ("O2", 4)] {
            text += &format!("hinge at {pin} {{ stiffness = k{k}, damping = c{k} }}\n");
        }
        for (index, link) in LINKS.iter().enumerate() {
            let k = index + 1;
            text += &format!("point P{k} on {link} at (x{k}, y{k})\n");
        }
        text += "\ngravity = (wx, wy)\n";
        text += &format!("coordinate {}.angle\n", LINKS[self.coordinate]);
        text += "
spring line between G and P2 { stiffness = s1, damping = d1 }
spring strut between P1 and P3 { stiffness = s2, damping = d2, length = free }
spring guided between G and P3 along (0.6, 0.8) { stiffness = s3, damping = d3, expansion = push }
drive push = sine(stroke, frequency = f)
force on P2 = (fx, fy * cos(2*pi*f*t))
torque on rocker = torque1
torque between crank and coupler = torque2
";
        if self.attached {
            text += "
param sigma0 = 5e6 N/m, sigma1 = 5 N*s/m, sigma2 = 0.5 N*s/m
param mu_s = 0.3, mu_c = 0.2, v_s = 1 mm/s
param Fp = 20 N, ku = 3e7 N/m, kp = 3e6 N/m, cp = 0.3 N*s/m, ms = 50 g, mp = 15 g
slide stack along (-1, 0) { mass = mp }
slide stage along (0.8, -0.6) { mass = ms }
spring ceramic between ground and stack { stiffness = kp, damping = cp, expansion = push }
spring joint between stack and P1 along (-1, 0) { stiffness = ku }
contact tip between P2 and stage {
  normal = (0.6, 0.8)
  preload = Fp
  friction = lugre(sigma0, sigma1, sigma2, mu_s, mu_c, v_s)
}
";
        }
        text
    }

    /// Random dimensions that close, by the names of params; with the number of the Grashof type
    /// (0 shortest link is ground, 1 crank or rocker, 2 coupler, 3 triple rocker) and the sign of
    /// the branch. `None` where the linkage stands too near a dead point for any comparison.
    pub fn dimensions(&self, random: &mut Random) -> Option<Dimensions> {
        let mut angles: [f64; 3] = [0; 3].map(|_| random.between(-PI, PI));
        let mut lengths: [f64; 3] = [0; 3].map(|_| random.scale(5e-3, 50e-3));
        if random.below(3) == 0 {
            // A short ground: the rocker follows from it.
            let (short, direction) = (random.scale(2e-3, 10e-3), random.between(-PI, PI));
            let component = |along: fn(f64) -> f64| {
                lengths[0] * along(angles[0]) + lengths[1] * along(angles[1])
                    - short * along(direction)
            };
            let (x, y) = (component(f64::cos), component(f64::sin));
            lengths[2] = x.hypot(y);
            angles[2] = y.atan2(x);
        }
        // Vectors in the usual direction: O1→B, B→D, O2→D.
        let vector = |k: usize| [lengths[k] * angles[k].cos(), lengths[k] * angles[k].sin()];
        let (crank, coupler, rocker) = (vector(0), vector(1), vector(2));
        let ground = [
            crank[0] + coupler[0] - rocker[0],
            crank[1] + coupler[1] - rocker[1],
        ];
        // The two links that are no coordinate must not lie in a line.
        let others: Vec<usize> = (0..3).filter(|k| *k != self.coordinate).collect();
        let closing = (angles[others[0]] - angles[others[1]]).sin();
        let others: Vec<usize> = (0..3).filter(|k| *k != self.exact).collect();
        let assembling = (angles[others[0]] - angles[others[1]]).sin();
        if closing.abs() < 0.15 || assembling.abs() < 0.15 {
            return None;
        }
        let mut closed = Vec::new();
        let mut values = vec![("gx", ground[0]), ("gy", ground[1])];
        let mut set = |name: &'static str, value: f64| values.push((name, value));
        const LENGTH: [&str; 3] = ["l1", "l2", "l3"];
        const ANGLE: [&str; 3] = ["a1", "a2", "a3"];
        const MASS: [&str; 3] = ["m1", "m2", "m3"];
        const CENTER: [&str; 3] = ["r1", "r2", "r3"];
        const OFFSET: [&str; 3] = ["b1", "b2", "b3"];
        const INERTIA: [&str; 3] = ["i1", "i2", "i3"];
        const POINT: [[&str; 2]; 3] = [["x1", "y1"], ["x2", "y2"], ["x3", "y3"]];
        const ADDED: [&str; 3] = ["q1", "q2", "q3"];
        for k in 0..3 {
            let mut drawn = angles[k];
            if self.reversed[k] {
                drawn += PI;
            }
            closed.push((ANGLE[k], drawn));
            if k != self.exact {
                // A guess is off, yet on the same side of the dead points.
                let room = (0.4 * assembling.abs().min(closing.abs())).min(0.15);
                drawn += random.between(-room, room);
            }
            let mass = random.scale(1e-4, 1e-3);
            set(LENGTH[k], lengths[k]);
            set(ANGLE[k], drawn);
            set(MASS[k], mass);
            set(CENTER[k], lengths[k] * random.between(0.0, 1.0));
            set(OFFSET[k], random.between(-PI, PI));
            set(
                INERTIA[k],
                mass * lengths[k].powi(2) * random.between(0.02, 0.3),
            );
            set(POINT[k][0], lengths[k] * random.between(-0.5, 1.5));
            set(POINT[k][1], lengths[k] * random.between(-1.0, 1.0));
            set(ADDED[k], random.scale(1e-5, 1e-3));
        }
        for name in ["k1", "k2", "k3", "k4"] {
            set(name, random.scale(0.1, 100.0));
        }
        for name in ["c1", "c2", "c3", "c4"] {
            set(name, random.scale(1e-6, 1e-3));
        }
        for name in ["s1", "s2", "s3"] {
            set(name, random.scale(1e2, 1e5));
        }
        for name in ["d1", "d2", "d3"] {
            set(name, random.scale(1e-3, 1.0));
        }
        set("free", random.between(5e-3, 50e-3));
        for name in ["hx", "hy"] {
            set(name, random.between(-0.1, 0.1));
        }
        for name in ["wx", "wy"] {
            set(name, random.between(-10.0, 10.0));
        }
        for name in ["fx", "fy"] {
            set(name, random.between(-10.0, 10.0));
        }
        for name in ["torque1", "torque2"] {
            set(name, random.between(-0.1, 0.1));
        }
        let ground = ground[0].hypot(ground[1]);
        let all = [ground, lengths[0], lengths[1], lengths[2]];
        let shortest = all.iter().copied().fold(f64::INFINITY, f64::min);
        let longest = all.iter().copied().fold(0.0, f64::max);
        let sum: f64 = all.iter().sum();
        let grashof = if shortest + longest > sum - shortest - longest {
            3
        } else if shortest == ground {
            0
        } else if shortest == lengths[1] {
            2
        } else {
            1
        };
        let mut exactly = values.clone();
        exactly.extend(closed);
        Some(Dimensions {
            values,
            closed: exactly,
            grashof,
            branch: closing > 0.0,
        })
    }
}

/// Random dimensions, by the names of params.
pub struct Dimensions {
    /// Names and values in SI; angles that are not exact are off, as a user's guesses are.
    pub values: Vec<(&'static str, f64)>,
    /// The same with all angles as they are where the linkage closes.
    pub closed: Vec<(&'static str, f64)>,
    /// 0 shortest link is ground, 1 crank or rocker, 2 coupler, 3 none turns fully.
    pub grashof: usize,
    /// On which side of the dead point.
    pub branch: bool,
}

/// Params of the model file with defaults that close.
const NAMES: [(&str, &str); 54] = [
    ("gx", "25 mm"),
    ("gy", "0 mm"),
    ("hx", "10 mm"),
    ("hy", "30 mm"),
    ("l1", "10 mm"),
    ("l2", "23 mm"),
    ("l3", "12 mm"),
    ("a1", "80 deg"),
    ("a2", "0 deg"),
    ("a3", "90 deg"),
    ("m1", "0.3 g"),
    ("m2", "0.6 g"),
    ("m3", "0.3 g"),
    ("r1", "5 mm"),
    ("r2", "11 mm"),
    ("r3", "6 mm"),
    ("b1", "10 deg"),
    ("b2", "20 deg"),
    ("b3", "30 deg"),
    ("i1", "1e-9 kg*m^2"),
    ("i2", "5e-9 kg*m^2"),
    ("i3", "1e-9 kg*m^2"),
    ("x1", "3 mm"),
    ("y1", "1 mm"),
    ("x2", "3 mm"),
    ("y2", "2 mm"),
    ("x3", "3 mm"),
    ("y3", "-1 mm"),
    ("q1", "0.1 g"),
    ("q2", "0.1 g"),
    ("q3", "0.1 g"),
    ("k1", "40 N*m/rad"),
    ("k2", "40 N*m/rad"),
    ("k3", "40 N*m/rad"),
    ("k4", "40 N*m/rad"),
    ("c1", "1e-5 N*m*s/rad"),
    ("c2", "1e-5 N*m*s/rad"),
    ("c3", "1e-5 N*m*s/rad"),
    ("c4", "1e-5 N*m*s/rad"),
    ("wx", "1 m/s^2"),
    ("wy", "-9.81 m/s^2"),
    ("s1", "1e3 N/m"),
    ("s2", "1e3 N/m"),
    ("s3", "1e3 N/m"),
    ("d1", "0.1 N*s/m"),
    ("d2", "0.1 N*s/m"),
    ("d3", "0.1 N*s/m"),
    ("free", "20 mm"),
    ("stroke", "20 um"),
    ("f", "1 kHz"),
    ("fx", "1 N"),
    ("fy", "2 N"),
    ("torque1", "0.01 N*m"),
    ("torque2", "0.02 N*m"),
];
