//! The equations of motion: everything that later stages need, as expressions of one graph.
//!
//! Symbols are of four kinds: params; states, discrete states, inputs and time; *defined* symbols,
//! which [`Equations::definitions`] give a meaning, each after what it uses; and the *unknowns* of a
//! [`Solve`] among them. What a definition depends on (only params, or states too) decides when it
//! is computed; nothing here says so twice.
//!
//! [`Equations::report`] is the same content for people: sections of equations in the order and
//! form of a textbook.

use crate::model::{Input, Param, ParamSet};
use crate::symbolic::{Expr, Graph, Symbol};
use flexure_runtime::diagnostic::{Diagnostic, Site};

/// Equations of motion of a model.
#[derive(Clone, Debug)]
pub struct Equations {
    /// Name of the model.
    pub name: String,
    /// The model's own words on itself.
    pub doc: String,
    /// All expressions.
    pub graph: Graph,
    /// Time.
    pub time: Symbol,
    /// Quantities that a user may set.
    pub params: Vec<Param>,
    /// Named alternative values.
    pub sets: Vec<ParamSet>,
    /// Signals from outside.
    pub inputs: Vec<Input>,
    /// What defined symbols stand for, each after what it uses.
    pub definitions: Vec<Definition>,
    /// Derivatives of defined symbols by states that are known otherwise than by differentiating
    /// their definitions (a loop's angles, by its rate equations): to be used instead of those.
    pub partials: Vec<Partial>,
    /// Angles whose cosine and sine are known without evaluating either: by the geometry of a loop.
    pub directions: Vec<Direction>,
    /// Continuous state, with its rates.
    pub states: Vec<State>,
    /// Discrete state.
    pub discretes: Vec<Discrete>,
    /// Drives that repeat.
    pub periodic: Vec<Periodic>,
    /// Kinks of drives.
    pub kinks: Vec<Kink>,
    /// Events.
    pub events: Vec<Event>,
    /// Results: those the user named.
    pub outputs: Vec<Output>,
    /// Energies and powers.
    pub energy: Energy,
    /// Loops of the mechanism.
    pub loops: Vec<Loop>,
    /// Conditions on params.
    pub checks: Vec<Check>,
    /// Warnings found on the way.
    pub warnings: Vec<Diagnostic>,
    /// The equations for people.
    pub report: Vec<Section>,
    /// Facts about the mechanism for people: bodies, joints, degrees of freedom.
    pub summary: Vec<Fact>,
    /// Its shape for pictures.
    pub drawing: Drawing,
    /// Its shape at any state, the same parts in the same order. A slide that has no place in the
    /// model has one here from which only its changes count.
    pub moving: Drawing,
}

/// What a symbol stands for.
#[derive(Clone, Debug)]
pub enum Definition {
    /// An expression of symbols defined before.
    Value {
        /// The symbol.
        symbol: Symbol,
        /// What it stands for.
        value: Expr,
        /// What it is, in words; may be empty.
        meaning: String,
    },
    /// The solution of equations.
    Solve(Box<Solve>),
}

/// Unknowns that make residuals zero: found by Newton's method from a guess.
#[derive(Clone, Debug)]
pub struct Solve {
    /// What is sought, in words, for messages: `the equilibrium`.
    pub name: String,
    /// The unknowns.
    pub unknowns: Vec<Symbol>,
    /// Where to start, of params.
    pub guesses: Vec<Expr>,
    /// Symbols defined in terms of the unknowns that the residuals use, in order.
    pub definitions: Vec<(Symbol, Expr)>,
    /// What must vanish, of the unknowns and `definitions`; as many as unknowns.
    pub residuals: Vec<Expr>,
    /// Size of one unit of each residual, of params: it is zero when below rounding of this.
    pub scales: Vec<Expr>,
    /// What to say if there is no solution.
    pub failure: Failure,
}

/// An error that evaluation may find, with holes for values.
#[derive(Clone, Debug)]
pub struct Failure {
    /// Message; `{0}`, `{1}` stand for `values`.
    pub message: String,
    /// What would mend it; with holes too.
    pub hint: Option<String>,
    /// Where.
    pub site: Option<Site>,
    /// Parts and turns of a `repeat` that bring the place there, each with what it is called.
    pub related: Vec<(Site, String)>,
    /// What fills the holes.
    pub values: Vec<Shown>,
}

/// A value shown in a message, with its unit.
#[derive(Clone, Copy, Debug)]
pub struct Shown {
    /// The value in SI.
    pub value: Expr,
    /// Unit in which it is shown.
    pub unit: ShownUnit,
}

/// Units for values in messages; lengths, masses and forces get a fitting SI prefix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShownUnit {
    /// A plain number.
    Number,
    /// rad, shown in degrees.
    Degree,
    /// m with a prefix.
    Metre,
    /// SI unit by its symbol, such as `kg`, with a prefix if it allows one.
    Other(&'static str),
}

/// A known derivative of a defined symbol.
#[derive(Clone, Copy, Debug)]
pub struct Partial {
    /// The defined symbol. All of its derivatives by states not listed are zero.
    pub symbol: Symbol,
    /// The symbol of the state.
    pub state: Symbol,
    /// ∂symbol/∂state.
    pub value: Expr,
}

/// An angle with its cosine and sine.
#[derive(Clone, Copy, Debug)]
pub struct Direction {
    /// The angle.
    pub angle: Symbol,
    /// Its cosine.
    pub cos: Expr,
    /// Its sine.
    pub sin: Expr,
}

/// A continuous state.
#[derive(Clone, Debug)]
pub struct State {
    /// Name in results: `crank.angle`.
    pub name: String,
    /// SI unit.
    pub unit: String,
    /// What it is.
    pub meaning: String,
    /// Its symbol.
    pub symbol: Symbol,
    /// Value at the start, of params.
    pub initial: Expr,
    /// Its rate.
    pub rate: Expr,
    /// Set if it belongs to the configuration (an independent coordinate), not to the motion.
    pub coordinate: Option<Coordinate>,
}

/// What a state is that is an independent coordinate.
#[derive(Clone, Copy, Debug)]
pub struct Coordinate {
    /// Value in the assembled configuration, of params.
    pub assembled: Expr,
    /// Whether loops follow it.
    pub leads_loops: bool,
}

/// A discrete state.
#[derive(Clone, Debug)]
pub struct Discrete {
    /// Name: `xp.cycle`.
    pub name: String,
    /// What it is.
    pub meaning: String,
    /// Its symbol.
    pub symbol: Symbol,
    /// Value at the start, of params (and states at the start).
    pub initial: Expr,
    /// New value after an accepted step; `None` if only kinks and events change it.
    pub accepted: Option<Expr>,
    /// Whether it is an angle in rad that must not move by more than π/2 in a step.
    pub turning: bool,
}

/// A drive that repeats.
#[derive(Clone, Debug)]
pub struct Periodic {
    /// Name of the drive.
    pub name: String,
    /// How often it does so, in Hz, of params.
    pub frequency: Expr,
}

/// The end of a drive's present segment.
#[derive(Clone, Debug)]
pub struct Kink {
    /// Name of the drive.
    pub name: String,
    /// Time of the next kink, of params and discrete states.
    pub next: Expr,
    /// Positions in [`Equations::discretes`] and their new values.
    pub updates: Vec<(usize, Expr)>,
    /// Whether the drive itself may jump.
    pub jumps: bool,
}

/// Something that happens where `function` rises through zero.
#[derive(Clone, Debug)]
pub struct Event {
    /// Name, for messages: `tip lifts off`.
    pub name: String,
    /// The function.
    pub function: Expr,
    /// Positions in [`Equations::states`] and their new values.
    pub state_updates: Vec<(usize, Expr)>,
    /// Positions in [`Equations::discretes`] and their new values.
    pub discrete_updates: Vec<(usize, Expr)>,
    /// If the run ends there: why.
    pub stop: Option<String>,
}

/// A result.
#[derive(Clone, Debug)]
pub struct Output {
    /// Name.
    pub name: String,
    /// SI unit.
    pub unit: String,
    /// What it is.
    pub meaning: String,
    /// Its value.
    pub value: Expr,
}

/// Energies in J and powers in W.
#[derive(Clone, Copy, Debug)]
pub struct Energy {
    /// Kinetic energy.
    pub kinetic: Expr,
    /// Potential energy.
    pub potential: Expr,
    /// Power turned to heat.
    pub dissipated_power: Expr,
    /// Power brought in from outside.
    pub supplied_power: Expr,
}

/// A loop of the mechanism.
#[derive(Clone, Debug)]
pub struct Loop {
    /// By its bodies: `crank–coupler–rocker`.
    pub name: String,
    /// Positive where the loop closes, zero at a dead point: the squared sine of its transmission
    /// angle. For loops that only close together the square of what the determinant of their
    /// Jacobian is of that as assembled; -1 or not-a-number where they do not close.
    pub closure: Expr,
    /// Whether `closure` is the squared sine of the transmission angle: whether the loop is closed
    /// by a dyad of its own, not together with others by Newton's method.
    pub has_transmission_angle: bool,
}

/// A condition on params: an error or warning where `margin` is not positive (or not a number).
#[derive(Clone, Debug)]
pub struct Check {
    /// Positive where all is well, of params.
    pub margin: Expr,
    /// Whether zero is well too.
    pub zero_is_well: bool,
    /// What to say.
    pub failure: Failure,
}

/// A part of the equations as printed.
#[derive(Clone, Debug)]
pub struct Section {
    /// Title.
    pub title: String,
    /// Its lines.
    pub lines: Vec<Line>,
}

/// A line of a section.
#[derive(Clone, Debug)]
pub enum Line {
    /// Words.
    Text(String),
    /// `left = right`.
    Equation {
        /// Left-hand side in plain text: `A(φ1)`.
        text: String,
        /// Left-hand side in LaTeX: `A(\varphi_1)`.
        latex: String,
        /// Right-hand side: its terms, kept one to a line where there are many.
        right: Expr,
        /// A word on it; may be empty.
        note: String,
    },
    /// An equation that is not an assignment, already written out.
    Written {
        /// In plain text; may be of several lines.
        text: String,
        /// In LaTeX.
        latex: String,
    },
}

/// A line of the summary that `check` prints.
#[derive(Clone, Debug, PartialEq)]
pub struct Fact {
    /// What it is about: `loop`, `coordinate`.
    pub subject: String,
    /// What is said, with holes `{0}` for values.
    pub words: String,
    /// What fills the holes, of params.
    pub values: Vec<(Expr, ShownUnit)>,
}

/// The mechanism's shape as assembled, of params. What has no place in the model (a slide that is
/// not located, ground named without a point) has none here: a picture puts it where it fits.
#[derive(Clone, Debug, Default)]
pub struct Drawing {
    /// Bodies.
    pub shapes: Vec<Shape>,
    /// Named points: pins and points.
    pub marks: Vec<Mark>,
    /// Springs and stacks.
    pub springs: Vec<DrawnSpring>,
    /// Contacts.
    pub contacts: Vec<DrawnContact>,
}

/// A body's outline.
#[derive(Clone, Debug)]
pub enum Shape {
    /// A link: its name and corner points in m (a line for two).
    Link(String, Vec<[Expr; 2]>),
    /// A slide: its name, its place if it has one, and the direction of its guide.
    Slide(String, Option<[Expr; 2]>, [Expr; 2]),
}

/// Where a spring or a contact ends.
#[derive(Clone, Debug)]
pub struct DrawnEnd {
    /// The body: `ground`, a link or a slide.
    pub body: String,
    /// The place in m, if it has one.
    pub at: Option<[Expr; 2]>,
}

/// A spring or a stack.
#[derive(Clone, Debug)]
pub struct DrawnSpring {
    /// Its name.
    pub name: String,
    /// Its two ends.
    pub ends: [DrawnEnd; 2],
    /// Unit vector from the first end to the second of a spring that acts along a direction.
    pub axis: Option<[Expr; 2]>,
    /// Whether it is a ceramic stack.
    pub stack: bool,
}

/// A contact.
#[derive(Clone, Debug)]
pub struct DrawnContact {
    /// Its name.
    pub name: String,
    /// The bodies that touch.
    pub ends: [DrawnEnd; 2],
    /// Direction of sliding.
    pub along: [Expr; 2],
    /// Direction of the normal force on the first, if it has one.
    pub normal: Option<[Expr; 2]>,
}

/// A point in the drawing.
#[derive(Clone, Debug)]
pub struct Mark {
    /// Name.
    pub name: String,
    /// Place in m.
    pub at: [Expr; 2],
    /// Whether it is a pin, and whether that is fixed to ground.
    pub pin: Option<bool>,
}
