//! What a place in the language wants: a dimension and what engineers call it there.

use crate::units::Dimension;

/// A wanted dimension with its words.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wanted {
    pub dimension: Dimension,
    /// With article and unit: `a torsional stiffness (N*m/rad)`.
    pub words: &'static str,
}

const fn wanted(dimension: Dimension, words: &'static str) -> Wanted {
    Wanted { dimension, words }
}

pub(super) const NUMBER: Wanted = wanted(Dimension::NONE, "a number");
pub(super) const ANGLE: Wanted = wanted(Dimension::NONE, "an angle (deg or rad)");
pub(super) const LENGTH: Wanted = wanted(Dimension::LENGTH, "a length (m)");
pub(super) const MASS: Wanted = wanted(Dimension::MASS, "a mass (kg)");
pub(super) const TIME: Wanted = wanted(Dimension::TIME, "a time (s)");
pub(super) const INERTIA: Wanted = wanted(Dimension::INERTIA, "a moment of inertia (kg*m^2)");
pub(super) const DENSITY: Wanted = wanted(Dimension::DENSITY, "a density (kg/m^3)");
pub(super) const FORCE: Wanted = wanted(Dimension::FORCE, "a force (N)");
pub(super) const TORQUE: Wanted = wanted(Dimension::TORQUE, "a torque (N*m)");
pub(super) const STIFFNESS: Wanted = wanted(Dimension::STIFFNESS, "a stiffness (N/m)");
pub(super) const DAMPING: Wanted = wanted(Dimension::DAMPING, "a damping (N*s/m)");
pub(super) const TORSIONAL_STIFFNESS: Wanted =
    wanted(Dimension::TORQUE, "a torsional stiffness (N*m/rad)");
pub(super) const TORSIONAL_DAMPING: Wanted = wanted(
    Dimension::ANGULAR_DAMPING,
    "a torsional damping (N*m*s/rad)",
);
pub(super) const VELOCITY: Wanted = wanted(Dimension::VELOCITY, "a velocity (m/s)");
pub(super) const ACCELERATION: Wanted = wanted(Dimension::ACCELERATION, "an acceleration (m/s^2)");
pub(super) const FREQUENCY: Wanted = wanted(Dimension::FREQUENCY, "a frequency (Hz)");
pub(super) const ANGULAR_RATE: Wanted = wanted(Dimension::ANGULAR_RATE, "an angular rate (rad/s)");
pub(super) const MODULUS: Wanted = wanted(Dimension::PRESSURE, "an elastic modulus (Pa)");
