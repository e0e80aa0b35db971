//! The independent check: the same mechanism in absolute coordinates with Lagrange multipliers.
//!
//! Every body has its own three coordinates (x, y, θ of its frame); joints are constraints. From
//! the compiler this room takes the resolved `Model` alone (and the plain evaluator, to turn
//! expressions of params into numbers). It knows nothing of independent coordinates, loops,
//! dyads, ratios of rates or virtual work on them: accelerations come from the bordered system
//!
//! ```text
//! [ M  Jᵀ ] [ q̈ ]   [ Q ]
//! [ J  0  ] [ λ ] = [ γ ]
//! ```
//!
//! (Haug, Computer Aided Kinematics and Dynamics of Mechanical Systems, 1989, chapter 6). The
//! friction law is written again by hand here, and the rate of an expansion is taken numerically.
#![allow(
    dead_code,
    reason = "each test binary uses its own part of this module"
)]

mod configuration;
mod dynamics;
mod forces;
mod joints;
mod plane;
mod reading;

use flexure_model_dsl::model::{BodyId, Model};
use flexure_model_dsl::symbolic::Expr;

/// A vector in the plane.
pub type Plane = [f64; 2];
/// A body as numbers.
#[derive(Clone, Debug)]
pub struct Body {
    /// Its name.
    pub name: String,
    kind: Kind,
    /// Mass, centre in the body's frame, inertia about the centre.
    masses: Vec<(f64, Plane, f64)>,
}

#[derive(Clone, Debug)]
enum Kind {
    Ground,
    Link {
        angle: Option<f64>,
        exact: bool,
    },
    Slide {
        carrier: BodyId,
        direction: Plane,
        origin: Plane,
        located: bool,
        at: f64,
        exact: bool,
    },
}

#[derive(Clone, Debug)]
struct Hinge {
    first: BodyId,
    second: BodyId,
    stiffness: f64,
    damping: f64,
    rest: Option<f64>,
}

/// A place on a body: fixed in its frame.
#[derive(Clone, Copy, Debug)]
struct Place {
    body: BodyId,
    at: Plane,
}

#[derive(Clone, Debug)]
struct Spring {
    first: Place,
    second: Place,
    direction: Direction,
    stiffness: f64,
    damping: f64,
    length: Option<f64>,
    expansion: Option<Expr>,
}

#[derive(Clone, Copy, Debug)]
enum Direction {
    Line,
    /// A unit vector fixed in a body's frame.
    Fixed(BodyId, Plane),
}

/// The LuGre law's parameters, as numbers.
#[derive(Clone, Copy, Debug)]
pub struct LuGre {
    /// Bristle stiffness in N/m.
    pub sigma0: f64,
    /// Bristle damping in N·s/m.
    pub sigma1: f64,
    /// Viscous friction in N·s/m.
    pub sigma2: f64,
    /// Coefficient of static friction.
    pub mu_s: f64,
    /// Coefficient of Coulomb friction.
    pub mu_c: f64,
    /// Stribeck velocity in m/s.
    pub v_s: f64,
}

#[derive(Clone, Debug)]
struct Contact {
    first: Place,
    second: Place,
    /// Carrier of the guide and the guide's direction in its frame.
    guide: (BodyId, Plane),
    normal: Option<Plane>,
    preload: f64,
    stiffness: f64,
    damping: f64,
    compliant: bool,
    law: LuGre,
}

/// A mechanism with one set of parameters.
pub struct Mechanism<'m> {
    model: &'m Model,
    params: Vec<f64>,
    /// Ground first.
    pub bodies: Vec<Body>,
    /// Pairs of places that coincide.
    pins: Vec<(Place, Place)>,
    hinges: Vec<Hinge>,
    springs: Vec<Spring>,
    contacts: Vec<Contact>,
    gravity: Plane,
}

/// What moves besides the bodies at an instant.
#[derive(Clone, Debug, Default)]
pub struct Surroundings {
    /// Time in s.
    pub time: f64,
    /// Inputs in order.
    pub inputs: Vec<f64>,
    /// What drives remember, by `drive.memory`.
    pub memory: Vec<(String, f64)>,
    /// Bristle deflection of each contact in m.
    pub bristles: Vec<f64>,
}

/// The closed configuration and what springs measure in it.
#[derive(Clone, Debug)]
pub struct Assembly {
    /// x, y, θ of each body, ground included.
    pub positions: Vec<f64>,
    /// The bodies whose angle or position is a coordinate.
    pub coordinates: Vec<BodyId>,
    rest_angles: Vec<f64>,
    rest_lengths: Vec<f64>,
    rest_gaps: Vec<f64>,
}

/// Accelerations at an instant.
#[derive(Clone, Debug)]
pub struct Motion {
    /// Acceleration of each coordinate.
    pub coordinates: Vec<f64>,
    /// For each coordinate the sum of the moduli of all that drives it, over its inertia.
    pub magnitudes: Vec<f64>,
    /// Rate of each contact's bristle deflection.
    pub bristle_rates: Vec<f64>,
    /// Friction force of each contact on its second end.
    pub friction: Vec<f64>,
    /// Condition number of the scaled bordered matrix.
    pub condition: f64,
}

/// Energies of the mechanism in J.
#[derive(Clone, Copy, Debug)]
pub struct Energies {
    /// Of moving masses.
    pub kinetic: f64,
    /// Of springs, bristles and gravity; the zero is arbitrary.
    pub potential: f64,
}
