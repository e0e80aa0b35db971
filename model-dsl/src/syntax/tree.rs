//! The syntax tree: what stands in a model file, in its words and with its places.

use crate::source::Span;

/// A whole file.
#[derive(Clone, Debug, Default)]
pub struct File {
    /// Text of the `//!` comment.
    pub doc: String,
    /// Items in order.
    pub items: Vec<Item>,
}

/// A word with its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// The word; with indices and dots as written (`up[i+1].web`) until [`expand`](crate::expand)
    /// has made one word of it.
    pub text: String,
    /// Where.
    pub span: Span,
}

/// Words joined by dots: `stage.v`; at least one.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Path {
    /// The words.
    pub parts: Vec<Name>,
    /// Where.
    pub span: Span,
}

impl Path {
    /// The only word, if there is just one.
    pub fn single(&self) -> Option<&Name> {
        match self.parts.as_slice() {
            [name] => Some(name),
            _ => None,
        }
    }

    /// As written.
    pub fn text(&self) -> String {
        let words: Vec<&str> = self.parts.iter().map(|part| part.text.as_str()).collect();
        words.join(".")
    }
}

/// An item of the file.
#[derive(Clone, Debug)]
pub struct Item {
    /// What it says.
    pub kind: ItemKind,
    /// Where it stands.
    pub span: Span,
}

/// What an item says.
#[derive(Clone, Debug)]
pub enum ItemKind {
    /// `model name`
    Model(Name),
    /// `param name = value "doc"`
    Params(Vec<Declaration>),
    /// `let name = value "doc"`
    Lets(Vec<Declaration>),
    /// `drive name = value "doc"`
    Drives(Vec<Declaration>),
    /// `output name = value "doc"`
    Outputs(Vec<Declaration>),
    /// `ground O1 = (x, y)`
    Grounds(Vec<Declaration>),
    /// `point B = (x, y)`
    DrawnPoints(Vec<Declaration>),
    /// `point A on crank at (x, y)`
    Point(Point),
    /// `input u: V = 0 V "doc"`
    Input(Input),
    /// `set name "doc" { … }`
    Set(Set),
    /// `link name from P to Q { … }`
    Link(Link),
    /// `slide name on body along (x, y) … { … }`
    Slide(Slide),
    /// `hinge at P between a, b { … }`
    Hinge(Hinge),
    /// `spring name between P and Q along (x, y) { … }`, and `stack`
    Spring(Spring),
    /// `contact name between P and Q { … }`
    Contact(Contact),
    /// `gravity = (x, y)`
    Gravity(Expression),
    /// `force on P = (x, y)`
    Force(Path, Expression),
    /// `torque on body = …`, `torque between a and b = …`
    Torque(Torque),
    /// `initial crank.rate = …`
    Initials(Vec<(Path, Expression)>),
    /// `start = equilibrium`
    Start(Expression),
    /// `coordinate crank.angle`
    Coordinates(Vec<Path>),
    /// `stop when condition "reason"`
    Stop(Expression, Option<String>),
    /// `component name(parameters) { items }`
    Component(Component),
    /// `repeat i from 1 to N { items }`
    Repeat(Repeat),
    /// `part name = component(arguments) at P = place`
    Part(Part),
    /// `use "file.flex"`
    Use(UsedFile),
    /// `const N = 40`
    Constants(Vec<(Name, Name)>),
    /// What a part's parameter was given has to be of its kind; made by
    /// [`expand`](crate::expand).
    Given(Given),
}

/// `component name(parameters) { items }`
#[derive(Clone, Debug)]
pub struct Component {
    /// Name.
    pub name: Name,
    /// Quantities that a part has to give.
    pub parameters: Vec<Parameter>,
    /// What stands in braces.
    pub items: Vec<Item>,
}

/// `thickness: length = 0.3 mm`
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Name.
    pub name: Name,
    /// Kind of quantity, or a unit.
    pub kind: Name,
    /// Value where a part gives none.
    pub default: Option<Expression>,
}

/// `repeat i from 1 to N { items }`
#[derive(Clone, Debug)]
pub struct Repeat {
    /// The counter.
    pub counter: Name,
    /// First value, a whole number as written.
    pub from: Name,
    /// Last value, a whole number as written.
    pub to: Name,
    /// What stands in braces.
    pub items: Vec<Item>,
}

/// `part name = component(arguments) at P = place`
#[derive(Clone, Debug)]
pub struct Part {
    /// Name.
    pub name: Name,
    /// Name of the component.
    pub component: Name,
    /// Values of parameters.
    pub arguments: Vec<Argument>,
    /// Points of the component that are points outside.
    pub bindings: Vec<(Name, Path)>,
}

/// `use "file.flex"`
#[derive(Clone, Debug)]
pub struct UsedFile {
    /// Path as written.
    pub path: String,
}

/// What a part's parameter was given.
#[derive(Clone, Debug)]
pub struct Given {
    /// The part.
    pub part: String,
    /// The parameter.
    pub parameter: Name,
    /// Its kind of quantity, or a unit.
    pub kind: Name,
    /// What it was given.
    pub value: Expression,
}

/// `name = value "doc"`
#[derive(Clone, Debug)]
pub struct Declaration {
    /// Name.
    pub name: Name,
    /// Value.
    pub value: Expression,
    /// The user's words; those at the end of a line of several hold for all without their own.
    pub doc: String,
}

/// `point A on crank at (x, y)`
#[derive(Clone, Debug)]
pub struct Point {
    /// Name.
    pub name: Name,
    /// Body.
    pub on: Name,
    /// Place.
    pub at: Expression,
}

/// `input u: V = 0 V "doc"`
#[derive(Clone, Debug)]
pub struct Input {
    /// Name.
    pub name: Name,
    /// Unit as written.
    pub unit: Option<Name>,
    /// Start value.
    pub value: Expression,
    /// The user's words.
    pub doc: String,
}

/// `set name "doc" { … }`
#[derive(Clone, Debug)]
pub struct Set {
    /// Name.
    pub name: Name,
    /// The user's words.
    pub doc: String,
    /// Values.
    pub entries: Vec<Entry>,
}

/// `link name from P to Q { … }`
#[derive(Clone, Debug)]
pub struct Link {
    /// Name.
    pub name: Name,
    /// First end.
    pub from: Name,
    /// Second end.
    pub to: Name,
    /// What stands in braces.
    pub entries: Vec<Entry>,
}

/// `slide name on body along (x, y) through (x, y) { … }`
#[derive(Clone, Debug)]
pub struct Slide {
    /// Name.
    pub name: Name,
    /// Carrier of the guide; ground if not said.
    pub on: Option<Name>,
    /// Direction of the guide.
    pub along: Option<Expression>,
    /// Place of the guide.
    pub through: Option<Expression>,
    /// Place of the guide, by a point.
    pub from: Option<Path>,
    /// What stands in braces.
    pub entries: Vec<Entry>,
}

/// `hinge at P between a, b { … }`
#[derive(Clone, Debug)]
pub struct Hinge {
    /// The pin.
    pub at: Name,
    /// Which two bodies.
    pub between: Option<(Name, Name)>,
    /// What stands in braces.
    pub entries: Vec<Entry>,
}

/// `spring name between P and Q along (x, y) { … }`
#[derive(Clone, Debug)]
pub struct Spring {
    /// Name.
    pub name: Name,
    /// First end.
    pub first: Path,
    /// Second end.
    pub second: Path,
    /// Fixed direction.
    pub along: Option<Expression>,
    /// What stands in braces.
    pub entries: Vec<Entry>,
    /// Whether it is a `stack`.
    pub stack: bool,
}

/// `contact name between P and Q { … }`
#[derive(Clone, Debug)]
pub struct Contact {
    /// Name.
    pub name: Name,
    /// First end.
    pub first: Path,
    /// Second end.
    pub second: Path,
    /// What stands in braces.
    pub entries: Vec<Entry>,
}

/// `torque on body = …`, `torque between a and b = …`
#[derive(Clone, Debug)]
pub struct Torque {
    /// Body on which it acts.
    pub on: Name,
    /// Body on which its opposite acts; ground if not said.
    pub against: Option<Name>,
    /// Value.
    pub value: Expression,
}

/// One line in braces: `name at P = value exact`.
#[derive(Clone, Debug)]
pub struct Entry {
    /// What is given.
    pub name: Name,
    /// Place, of `mass at P`.
    pub at: Option<Name>,
    /// Value.
    pub value: Expression,
    /// Where it says `exact`, if it does.
    pub exact: Option<Span>,
}

/// An expression.
#[derive(Clone, Debug)]
pub struct Expression {
    /// What it is.
    pub kind: ExpressionKind,
    /// Where it stands.
    pub span: Span,
}

/// What an expression is.
#[derive(Clone, Debug)]
pub enum ExpressionKind {
    /// `3.6e6 N/m`
    Literal {
        /// The number as written.
        number: String,
        /// The unit as written.
        unit: Option<Name>,
    },
    /// `"words"`
    Text(String),
    /// `stage.v`
    Reference(Path),
    /// `sawtooth(stroke, frequency = f)`
    Call(Call),
    /// Terms, each with whether it is subtracted; at least two.
    Sum(Vec<(bool, Expression)>),
    /// Factors, each with whether it divides; at least two.
    Product(Vec<(bool, Expression)>),
    /// `-a`
    Negative(Box<Expression>),
    /// `a^b`
    Power(Box<(Expression, Expression)>),
    /// `a > b`
    Comparison(Comparison, Box<(Expression, Expression)>),
    /// `a and b`; at least two.
    And(Vec<Expression>),
    /// `a or b`; at least two.
    Or(Vec<Expression>),
    /// `if a then b else c`
    Conditional(Box<(Expression, Expression, Expression)>),
    /// `(x, y)`
    Pair(Box<(Expression, Expression)>),
}

/// `sawtooth(stroke, frequency = f)`
#[derive(Clone, Debug)]
pub struct Call {
    /// What is called.
    pub name: Name,
    /// What it is given.
    pub arguments: Vec<Argument>,
}

/// One argument of a call.
#[derive(Clone, Debug)]
pub struct Argument {
    /// Its name, if it is given by name.
    pub name: Option<Name>,
    /// Its value.
    pub value: Expression,
}

/// How two values are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// `<`
    Less,
    /// `<=`
    LessOrEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterOrEqual,
    /// `==`
    Equal,
    /// `!=`
    NotEqual,
}
