//! The resolved model: what a model file says, with names looked up, units checked and every
//! quantity an expression in SI units. Nothing is assembled or derived yet.
//!
//! Expressions may use the symbols of params, `let`s, inputs, drives and time, and the symbols of
//! [`Model::measures`], which stand for quantities of the moving mechanism (`stage.v`, `tip.z`)
//! and get their meaning when the equations are derived. Fields that are said to be *of params*
//! use only params and `let`s.

use crate::source::{Source, Span};
use crate::symbolic::{Expr, Graph, Symbol};
use crate::units::Dimension;

/// Position in [`Model::bodies`]; 0 is ground.
pub type BodyId = usize;

/// Ground, the body that never moves: `Model::bodies[GROUND]`.
pub const GROUND: BodyId = 0;

/// A whole model.
#[derive(Clone, Debug)]
pub struct Model {
    /// Name after `model`.
    pub name: String,
    /// Text of the `//!` comment.
    pub doc: String,
    /// The file itself.
    pub source: Source,
    /// All expressions of the model.
    pub graph: Graph,
    /// Time `t`.
    pub time: Symbol,
    /// Quantities that a user may set, in order of declaration.
    pub params: Vec<Param>,
    /// Quantities that follow from params, each after what it uses.
    pub lets: Vec<Let>,
    /// Named alternative values.
    pub sets: Vec<ParamSet>,
    /// Signals from outside.
    pub inputs: Vec<Input>,
    /// Prescribed motions or voltages over time.
    pub drives: Vec<Drive>,
    /// Ground first, then links and slides in order of declaration.
    pub bodies: Vec<Body>,
    /// Pin joints: where two or more bodies meet.
    pub pins: Vec<Pin>,
    /// Named points, for outputs and pictures.
    pub points: Vec<NamedPoint>,
    /// Compliance and damping of pins.
    pub hinges: Vec<Hinge>,
    /// Springs, dampers and piezo stacks between two ends.
    pub springs: Vec<Spring>,
    /// Friction contacts.
    pub contacts: Vec<Contact>,
    /// Written-out forces and torques.
    pub loads: Vec<Load>,
    /// What must hold of quantities of params, each with where it was given.
    pub conditions: Vec<(Condition, Span)>,
    /// Acceleration of gravity in m/s², of params.
    pub gravity: Option<[Expr; 2]>,
    /// Coordinates that the user asked for.
    pub coordinates: Vec<CoordinateRequest>,
    /// Given initial values.
    pub initial: Vec<Initial>,
    /// Whether the run starts as assembled or in equilibrium.
    pub start: Start,
    /// Named results.
    pub outputs: Vec<Output>,
    /// Conditions that end a run.
    pub stops: Vec<Stop>,
    /// What the symbols for mechanical quantities in expressions stand for, in order of first use.
    pub measures: Vec<MeasureUse>,
    /// Assumptions that the model file leaves to the reader, for `check` to state.
    pub notes: Vec<Note>,
    /// Paths of files that were read on the way, as written in the model.
    pub files: Vec<String>,
}

impl Model {
    /// A model of that source with ground alone.
    pub fn empty(source: Source) -> Self {
        let mut graph = Graph::new();
        let time = graph.symbol("t", "t");
        Self {
            name: String::new(),
            doc: String::new(),
            source,
            graph,
            time,
            params: Vec::new(),
            lets: Vec::new(),
            sets: Vec::new(),
            inputs: Vec::new(),
            drives: Vec::new(),
            bodies: vec![Body {
                name: "ground".to_owned(),
                kind: BodyKind::Ground,
                masses: Vec::new(),
                span: Span::default(),
            }],
            pins: Vec::new(),
            points: Vec::new(),
            hinges: Vec::new(),
            springs: Vec::new(),
            contacts: Vec::new(),
            loads: Vec::new(),
            conditions: Vec::new(),
            gravity: None,
            coordinates: Vec::new(),
            initial: Vec::new(),
            start: Start::default(),
            outputs: Vec::new(),
            stops: Vec::new(),
            measures: Vec::new(),
            notes: Vec::new(),
            files: Vec::new(),
        }
    }
}

impl Model {
    /// Names of a body's coordinate and of its rate: `crank.angle` and `crank.rate`, `stage.x` and
    /// `stage.v`, `platform.P.x` and `platform.P.vx`.
    pub fn coordinate_names(&self, body: BodyId) -> [String; 2] {
        let name = &self.bodies[body].name;
        match &self.bodies[body].kind {
            BodyKind::Link(_) => [format!("{name}.angle"), format!("{name}.rate")],
            BodyKind::Slide(Slide {
                traces: Some(_), ..
            }) => {
                let (point, axis) = name.rsplit_once('.').unwrap_or((name, ""));
                [name.clone(), format!("{point}.v{axis}")]
            }
            BodyKind::Slide(_) | BodyKind::Ground => [format!("{name}.x"), format!("{name}.v")],
        }
    }

    /// Whether a body stands for the coordinate of a point instead of a part of the mechanism.
    pub fn is_traced(&self, body: BodyId) -> bool {
        matches!(&self.bodies[body].kind, BodyKind::Slide(slide) if slide.traces.is_some())
    }

    /// What a bare name of a `let` stands for; any other expression is itself.
    pub(crate) fn named_by(&self, expr: Expr) -> Expr {
        let mut expr = expr;
        // A `let` uses only what is before it.
        for known in self.lets.iter().rev() {
            if self.graph.as_symbol(expr) == Some(known.symbol) {
                expr = known.value;
            }
        }
        expr
    }
}

/// Something that was assumed: `crank` `has the inertia of a slender bar`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// Name of what it is about.
    pub subject: String,
    /// What was assumed.
    pub words: String,
}

/// A quantity that a user may set.
#[derive(Clone, Debug)]
pub struct Param {
    /// Name.
    pub name: String,
    /// Its symbol.
    pub symbol: Symbol,
    /// Default in SI, a constant expression.
    pub default: Expr,
    /// Dimension.
    pub dimension: Dimension,
    /// The user's words on it.
    pub doc: String,
    /// Its name in the file.
    pub span: Span,
}

/// A quantity that follows from params.
#[derive(Clone, Debug)]
pub struct Let {
    /// Name.
    pub name: String,
    /// Its symbol.
    pub symbol: Symbol,
    /// What it is: of params.
    pub value: Expr,
    /// Dimension.
    pub dimension: Dimension,
    /// The user's words on it.
    pub doc: String,
    /// Its name in the file.
    pub span: Span,
}

/// A named set of parameter values.
#[derive(Clone, Debug)]
pub struct ParamSet {
    /// Name.
    pub name: String,
    /// The user's words on it.
    pub doc: String,
    /// Position in [`Model::params`] and the constant value in SI.
    pub values: Vec<(usize, Expr)>,
}

/// A signal from outside.
#[derive(Clone, Debug)]
pub struct Input {
    /// Name.
    pub name: String,
    /// Its symbol.
    pub symbol: Symbol,
    /// Value until somebody sets it: a constant expression.
    pub start: Expr,
    /// The input that is its rate in time, where there is one; else it stands still.
    pub rate: Option<Symbol>,
    /// Dimension.
    pub dimension: Dimension,
    /// The user's words on it.
    pub doc: String,
}

/// A function of time, smooth between kinks.
#[derive(Clone, Debug)]
pub struct Drive {
    /// Name.
    pub name: String,
    /// Its symbol.
    pub symbol: Symbol,
    /// Dimension.
    pub dimension: Dimension,
    /// How it was written: `sawtooth(stroke, frequency = f, rise = rise)`.
    pub written: String,
    /// What it is.
    pub waveform: Waveform,
    /// Its name in the file.
    pub span: Span,
}

/// A function of time in pieces. Within a piece `value` is smooth; which piece holds is told by
/// `memory`, which changes only at kinks, so that a step that ends at a kink sees one piece alone.
#[derive(Clone, Debug)]
pub struct Waveform {
    /// Discrete state of the waveform.
    pub memory: Vec<Memory>,
    /// Value, of params, time and memory (and inputs or measures in a written-out drive).
    pub value: Expr,
    /// Where the piece ends.
    pub kink: Option<WaveformKink>,
    /// Value at full stroke, of params; `None` where the form has none.
    pub full: Option<Expr>,
    /// What must hold of its arguments.
    pub conditions: Vec<Condition>,
    /// How often it repeats, in Hz, of params; `None` if it does not.
    pub frequency: Option<Expr>,
}

/// A condition on a quantity of params that a waveform or law needs to make sense.
#[derive(Clone, Debug)]
pub struct Condition {
    /// Positive where all is well, of params.
    pub margin: Expr,
    /// Whether zero is well too.
    pub zero_is_well: bool,
    /// The quantity, for the message: its value in SI fills the hole `{0}`.
    pub value: Expr,
    /// Its SI unit; `None` for a plain number.
    pub unit: Option<&'static str>,
    /// What to say where it fails.
    pub message: String,
    /// What would mend it.
    pub hint: String,
}

impl Condition {
    /// `value`, called `name` in messages, must be above zero.
    pub fn above_zero(value: Expr, name: &str) -> Self {
        Self {
            margin: value,
            zero_is_well: false,
            value,
            unit: None,
            message: format!("{name} is {{0}}"),
            hint: "it must be above zero".to_owned(),
        }
    }

    /// `value`, called `name` in messages, must not be below zero.
    pub fn not_below_zero(value: Expr, name: &str) -> Self {
        Self {
            zero_is_well: true,
            hint: "it must not be below zero".to_owned(),
            ..Self::above_zero(value, name)
        }
    }

    /// The same of a quantity with this SI unit.
    pub fn in_unit(self, unit: &'static str) -> Self {
        Self {
            unit: Some(unit),
            ..self
        }
    }
}

/// One number that a waveform or law remembers between steps.
#[derive(Clone, Debug)]
pub struct Memory {
    /// Name, to be qualified by its owner's.
    pub name: String,
    /// Its symbol.
    pub symbol: Symbol,
    /// Value at t = 0: of params.
    pub initial: Expr,
}

/// The end of a waveform's present piece.
#[derive(Clone, Debug)]
pub struct WaveformKink {
    /// Time at which it ends, of params and memory; infinity is written as 1/0 nowhere: a waveform
    /// without a further kink gives a time beyond [`Waveform::NEVER`].
    pub next: Expr,
    /// New values of the memory, entry by entry.
    pub updates: Vec<Expr>,
    /// Whether the value itself may jump there (a step), not only its rate.
    pub jumps: bool,
}

impl Waveform {
    /// A time in s that no run reaches: kinks at or beyond it do not happen.
    pub const NEVER: f64 = 1e30;
}

/// A place in a body's frame: x along the link from its first end; for ground the fixed frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Local {
    /// The origin.
    Origin,
    /// Two lengths in m, of params.
    Cartesian(Expr, Expr),
    /// A length in m and an angle in rad, of params.
    Polar(Expr, Expr),
}

/// A body: ground, a link, or a slide.
#[derive(Clone, Debug)]
pub struct Body {
    /// Name; `ground` for ground.
    pub name: String,
    /// What kind.
    pub kind: BodyKind,
    /// Inertia: the body itself first, then added point masses. Empty for ground and massless bodies.
    pub masses: Vec<Mass>,
    /// Its name in the file.
    pub span: Span,
}

/// What a body can do.
#[derive(Clone, Debug)]
pub enum BodyKind {
    /// Stands still.
    Ground,
    /// Turns and translates as its pins allow.
    Link(Link),
    /// Translates along a guide and turns with the body that carries the guide.
    Slide(Slide),
}

/// A rigid link. Its frame has the origin at its first end and the x axis towards its second.
#[derive(Clone, Debug)]
pub struct Link {
    /// Name of its angle as the user wants it printed (`φ1`).
    pub symbol: Option<String>,
    /// Distance of its ends, of params.
    pub length: Expr,
    /// Direction of its x axis in the fixed frame, of params: a guess or exact.
    pub angle: Guess,
    /// First end, for messages and pictures.
    pub first: String,
    /// Second end.
    pub second: String,
}

/// A slide on a straight guide.
#[derive(Clone, Debug)]
pub struct Slide {
    /// Body that carries the guide.
    pub carrier: BodyId,
    /// Unit vector of the guide in the carrier's frame, of params.
    pub direction: [Expr; 2],
    /// A point of the guide in the carrier's frame: where the slide's frame stands at x = 0.
    pub origin: Local,
    /// Whether the user gave `origin` (`through`, `from`): then `.x` counts from it.
    pub located: bool,
    /// Position along the guide from `origin` as assembled, of params.
    pub at: Guess,
    /// The point (position in [`Model::points`]) whose coordinate 0 (x) or 1 (y) in the fixed frame
    /// the slide stands for, because the user wants it as a coordinate: without mass, never drawn.
    pub traces: Option<(usize, usize)>,
}

/// A value of params that is exact or only picks the branch.
#[derive(Clone, Copy, Debug)]
pub struct Guess {
    /// The value; `None` if the user gave none.
    pub value: Option<Expr>,
    /// Whether it must hold exactly.
    pub exact: bool,
    /// Where it was given.
    pub span: Span,
}

/// Mass at a place of a body.
#[derive(Clone, Debug)]
pub struct Mass {
    /// Mass in kg, of params.
    pub mass: Expr,
    /// Centre of mass in the body's frame.
    pub center: Local,
    /// Moment of inertia about the centre of mass in kg·m², of params; zero for a point mass.
    pub inertia: Expr,
    /// Where it was given.
    pub span: Span,
}

/// A pin joint.
#[derive(Clone, Debug)]
pub struct Pin {
    /// Name of the point in which the bodies meet.
    pub name: String,
    /// Each body with the point in its frame, in order of declaration; at least two.
    pub members: Vec<(BodyId, Local)>,
    /// Where the point is first named.
    pub span: Span,
}

/// A point fixed to a body.
#[derive(Clone, Debug)]
pub struct NamedPoint {
    /// Name, without the body's.
    pub name: String,
    /// The body.
    pub body: BodyId,
    /// Place in its frame.
    pub at: Local,
    /// Its name in the file.
    pub span: Span,
}

/// Torsional compliance and damping of a pin between two of its bodies.
#[derive(Clone, Debug)]
pub struct Hinge {
    /// Name of the pin (qualified by the bodies where more than two meet).
    pub name: String,
    /// Position in [`Model::pins`].
    pub pin: usize,
    /// First and second body: the deflection is the second's angle minus the first's.
    pub bodies: (BodyId, BodyId),
    /// Stiffness in N·m/rad, of params.
    pub stiffness: Option<Expr>,
    /// Damping in N·m·s/rad, of params.
    pub damping: Option<Expr>,
    /// Relative angle at which the spring is relaxed, of params; as assembled if not given.
    pub rest: Option<Expr>,
    /// The item.
    pub span: Span,
}

/// One end of a spring or contact.
#[derive(Clone, Debug)]
pub struct End {
    /// As the user wrote it: `A`, `stack`, `ground`.
    pub name: String,
    /// The body.
    pub body: BodyId,
    /// The point in its frame; `None` for ground named without a point.
    pub at: Option<Local>,
    /// Where it is named.
    pub span: Span,
}

/// How a spring measures its length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Axis {
    /// Along the line between its ends.
    Line,
    /// Along a fixed unit vector, of params.
    Fixed([Expr; 2]),
    /// Along the guide of a slide.
    Guide(BodyId),
}

/// A spring and damper, or a piezo stack: F = -k ε - c ε̇ on the second end, with
/// ε = (second - first)·axis - expansion, both counted from the assembled configuration unless a
/// free length is given.
#[derive(Clone, Debug)]
pub struct Spring {
    /// Name.
    pub name: String,
    /// First end.
    pub first: End,
    /// Second end.
    pub second: End,
    /// How its length is measured.
    pub axis: Axis,
    /// Stiffness in N/m, of params.
    pub stiffness: Option<Expr>,
    /// Damping in N·s/m, of params.
    pub damping: Option<Expr>,
    /// Free length in m, of params; as assembled if not given.
    pub length: Option<Expr>,
    /// Expansion in m: any expression.
    pub expansion: Option<Expr>,
    /// Whether it is a ceramic stack, which should not go into tension.
    pub stack: bool,
    /// Its name in the file.
    pub span: Span,
}

/// A friction contact: the friction force acts on the second end along the guide, its opposite on
/// the first; the slip velocity is the first end's velocity less the second's.
#[derive(Clone, Debug)]
pub struct Contact {
    /// Name.
    pub name: String,
    /// First end.
    pub first: End,
    /// Second end.
    pub second: End,
    /// The slide whose guide is the sliding direction.
    pub guide: BodyId,
    /// Unit vector of the normal force on the first end in the fixed frame, of params.
    pub normal: Option<[Expr; 2]>,
    /// Normal force.
    pub normal_force: NormalForce,
    /// Friction law.
    pub friction: Friction,
    /// How it takes part.
    pub role: ContactRole,
    /// Its name in the file.
    pub span: Span,
}

/// How a contact takes part in the motion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ContactRole {
    /// By its laws.
    #[default]
    Slides,
    /// Its sides never slide: friction by its law, with the displacement of one side against the
    /// other as the law's internal state, so that a bristle is a spring and a damper.
    Sticks,
    /// Not at all: neither friction nor a normal force.
    LeftOut,
}

/// How the normal force of a contact arises.
#[derive(Clone, Copy, Debug)]
pub enum NormalForce {
    /// A constant preload in N, of params.
    Constant(Expr),
    /// max(0, preload + stiffness·approach + damping·approach rate); lifts off at zero.
    Compliant {
        /// Force in N in the assembled configuration, of params.
        preload: Expr,
        /// Contact stiffness in N/m, of params.
        stiffness: Expr,
        /// Contact damping in N·s/m, of params.
        damping: Expr,
    },
}

/// A friction law as data: how its states change and what force it gives, in terms of two symbols
/// that the contact fills in.
#[derive(Clone, Debug)]
pub struct Friction {
    /// Name of the law: `lugre`.
    pub law: String,
    /// Stands for the slip velocity in m/s.
    pub slip: Symbol,
    /// Stands for the normal force in N.
    pub normal: Symbol,
    /// Internal states.
    pub states: Vec<FrictionState>,
    /// Named intermediate quantities in order of use: F_S, F_C, g(v).
    pub definitions: Vec<(Symbol, Expr)>,
    /// Friction force in N.
    pub force: Expr,
    /// Stored energy in J.
    pub energy: Expr,
    /// The greatest friction force that holds at rest, in N.
    pub holds: Expr,
    /// What must hold of its parameters and the force it is referred to.
    pub conditions: Vec<Condition>,
}

/// An internal state of a friction law; zero at the start and while the contact is lifted.
#[derive(Clone, Debug)]
pub struct FrictionState {
    /// Name within the contact: `z`.
    pub name: String,
    /// Its symbol.
    pub symbol: Symbol,
    /// Its rate.
    pub rate: Expr,
    /// Dimension.
    pub dimension: Dimension,
    /// What it is, in words.
    pub meaning: String,
}

/// A written-out force or torque: any expression.
#[derive(Clone, Debug)]
pub enum Load {
    /// A force in N in the fixed frame on a point.
    Force {
        /// Where it acts.
        on: End,
        /// Components in N.
        value: [Expr; 2],
        /// The item.
        span: Span,
    },
    /// A torque in N·m on a body, and its opposite on another.
    Torque {
        /// Body on which it acts.
        on: BodyId,
        /// Body on which the opposite acts; ground if none was named.
        against: BodyId,
        /// Torque in N·m, counter-clockwise positive.
        value: Expr,
        /// The item.
        span: Span,
    },
}

/// A coordinate that the user asked for.
#[derive(Clone, Copy, Debug)]
pub struct CoordinateRequest {
    /// A link (its angle) or a slide (its travel).
    pub body: BodyId,
    /// Where it was asked.
    pub span: Span,
}

/// An initial value for a rate, a travel or an internal state.
#[derive(Clone, Debug)]
pub struct Initial {
    /// What is given.
    pub measure: Measure,
    /// Its value in SI, of params.
    pub value: Expr,
    /// Where it is given.
    pub span: Span,
}

/// Where a run starts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Start {
    /// In the assembled configuration.
    #[default]
    Assembled,
    /// In static equilibrium under preload and constant loads.
    Equilibrium,
}

/// A named result.
#[derive(Clone, Debug)]
pub struct Output {
    /// Name.
    pub name: String,
    /// Value: any expression.
    pub value: Expr,
    /// Dimension.
    pub dimension: Dimension,
    /// The user's words on it.
    pub doc: String,
    /// Its name in the file.
    pub span: Span,
}

/// A condition that ends a run: `margin` rises through zero.
#[derive(Clone, Debug)]
pub struct Stop {
    /// Positive where the condition holds: any expression.
    pub margin: Expr,
    /// What to tell the user.
    pub reason: String,
    /// The item.
    pub span: Span,
}

/// A symbol in an expression that stands for a quantity of the moving mechanism.
#[derive(Clone, Debug)]
pub struct MeasureUse {
    /// The symbol.
    pub symbol: Symbol,
    /// What it stands for.
    pub measure: Measure,
    /// Name as users write it: `stage.v`.
    pub name: String,
    /// Where it is first used.
    pub span: Span,
}

/// A quantity of the moving mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Measure {
    /// Angle of a link in rad, continuous over many turns.
    Angle(BodyId),
    /// Its rate in rad/s.
    AngleRate(BodyId),
    /// Travel of a slide from its assembled position, in m.
    Travel(BodyId),
    /// Position of a slide from its guide's origin if that was given, else its travel, in m.
    Position(BodyId),
    /// Its rate in m/s.
    Velocity(BodyId),
    /// Coordinate 0 (x) or 1 (y) in the fixed frame of a point (position in [`Model::points`]).
    PointPosition(usize, usize),
    /// Velocity component of a point, in m/s.
    PointVelocity(usize, usize),
    /// Deflection of a hinge (position in [`Model::hinges`]) from its rest angle, in rad.
    HingeAngle(usize),
    /// Torque of a hinge on its second body, in N·m.
    HingeTorque(usize),
    /// ε of a spring (position in [`Model::springs`]) in m.
    SpringExtension(usize),
    /// Force of a spring on its second end along its axis, in N.
    SpringForce(usize),
    /// Internal state (second number) of a contact's friction law.
    ContactState(usize, usize),
    /// Friction force of a contact on its second end, in N.
    ContactFriction(usize),
    /// Normal force of a contact, in N.
    ContactNormal(usize),
    /// Slip velocity of a contact, in m/s.
    ContactSlip(usize),
    /// An energy or a power of the whole system.
    Energy(EnergyKind),
}

/// Energies in J and powers in W of the whole system.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum EnergyKind {
    /// `energy.kinetic`
    Kinetic,
    /// `energy.potential`
    Potential,
    /// `energy.total`: kinetic and potential.
    Total,
    /// `power.dissipated`
    DissipatedPower,
    /// `power.supplied`
    SuppliedPower,
    /// `energy.dissipated`: since the start
    Dissipated,
    /// `energy.supplied`: since the start
    Supplied,
}
