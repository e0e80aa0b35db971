//! The mechanism as assembled with a parameter set, for people: facts in words, places in numbers.
//!
//! What simulates has its own, faster `prepare`; this evaluates the equations plainly. How far the
//! mechanism can be led is asked of what simulates.

use flexure_model_dsl::equations::{
    Definition, Drawing, DrawnEnd, Equations, Shape, ShownUnit, Solve,
};
use flexure_model_dsl::symbolic::{Evaluator, Expr};
use flexure_runtime::diagnostic::Diagnostic;
use flexure_runtime::failure::{Unit, quantity, render};
use flexure_runtime::newton;
use flexure_runtime::system::System;
use flexure_runtime::table::TableReport;

use crate::reach::{self, Reach};

/// Values of whatever depends on params alone.
pub struct Assembled<'m> {
    equations: &'m Equations,
    params: Vec<f64>,
    evaluator: Evaluator<'m>,
    system: Box<dyn System>,
}

/// A point or direction in the plane.
pub type Point = [f64; 2];

/// The mechanism's shape in numbers, in m; see
/// [`Drawing`](flexure_model_dsl::equations::Drawing) for the meaning of the parts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Places {
    /// Links: name and corners.
    pub links: Vec<(String, Vec<Point>)>,
    /// Slides: name, place if the model gives one, direction of the guide.
    pub slides: Vec<(String, Option<Point>, Point)>,
    /// Named points; whether each is a pin, and whether that pin is fixed to ground.
    pub marks: Vec<(String, Point, Option<bool>)>,
    /// Springs and stacks.
    pub springs: Vec<PlacedSpring>,
    /// Contacts.
    pub contacts: Vec<PlacedContact>,
}

/// Where a spring or a contact ends: the body, and the place if the model gives one.
pub type PlacedEnd = (String, Option<Point>);

/// A spring or a stack in numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedSpring {
    /// Its name.
    pub name: String,
    /// Its two ends.
    pub ends: [PlacedEnd; 2],
    /// Unit vector from the first end to the second, of a spring that acts along a direction.
    pub axis: Option<Point>,
    /// Whether it is a ceramic stack.
    pub stack: bool,
}

/// A contact in numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedContact {
    /// Its name.
    pub name: String,
    /// The bodies that touch.
    pub ends: [PlacedEnd; 2],
    /// Direction of sliding.
    pub along: Point,
    /// Direction of the normal force on the first, if it has one.
    pub normal: Option<Point>,
}

impl<'m> Assembled<'m> {
    /// Evaluates `equations` with these values of its params, in SI; `system` is what simulates
    /// them with the same values.
    ///
    /// # Errors
    ///
    /// If equations that fix the assembled configuration have no solution.
    pub fn new(
        equations: &'m Equations,
        params: &[f64],
        system: Box<dyn System>,
    ) -> Result<Self, Diagnostic> {
        let evaluator = evaluator(equations, params, &[])?;
        Ok(Self {
            equations,
            params: params.to_vec(),
            evaluator,
            system,
        })
    }

    /// The value of an expression of params; not a number if it depends on anything else.
    pub fn value(&mut self, expr: Expr) -> f64 {
        self.evaluator.value(expr)
    }

    /// The period of the drives in s: of the slowest one that repeats.
    pub fn period(&mut self) -> Option<f64> {
        let equations = self.equations;
        let frequencies = equations.periodic.iter();
        let periods = frequencies.map(|drive| 1.0 / self.value(drive.frequency));
        periods.filter(|period| period.is_finite()).reduce(f64::max)
    }

    /// How far each coordinate that loops follow can be led from its assembled value, the other
    /// coordinates held at theirs, until a loop reaches a dead point.
    pub fn reach(&mut self) -> Vec<Reach> {
        let equations = self.equations;
        let assembled: Vec<Option<f64>> = equations
            .states
            .iter()
            .map(|state| Some(self.value(state.coordinate?.assembled)))
            .collect();
        let size = size(&self.places());
        reach::reaches(&*self.system, equations, &assembled, size)
    }

    /// Bodies, joints, loops, degrees of freedom, coordinates and angles, ranges over which loops
    /// close and transmission angles: what each line is about and what is to be said.
    pub fn facts(&mut self) -> Vec<(String, String)> {
        let equations = self.equations;
        let facts = equations.summary.iter();
        let mut facts: Vec<(String, String)> = facts
            .map(|fact| {
                let (values, units): (Vec<f64>, Vec<Unit>) = fact
                    .values
                    .iter()
                    .map(|&(expr, unit)| (without_rounding(self.value(expr)), shown(unit)))
                    .unzip();
                (fact.subject.clone(), render(&fact.words, &values, &units))
            })
            .collect();
        let reach = self.reach();
        facts.extend(reach::facts(equations, &reach));
        let tables = self.system.tables();
        let tables = tables.iter().map(|table| table_fact(equations, table));
        facts.extend(tables.map(|words| ("table".to_owned(), words)));
        facts
    }

    /// The shape of the mechanism.
    pub fn places(&mut self) -> Places {
        places(&mut self.evaluator, &self.equations.drawing)
    }

    /// The shape of the mechanism at a state, given by the values of the equations' states in SI.
    /// Slides without a place in the model count from an arbitrary one.
    ///
    /// # Errors
    ///
    /// If a loop does not close there.
    pub fn places_at(&self, states: &[f64]) -> Result<Places, Diagnostic> {
        let mut evaluator = evaluator(self.equations, &self.params, states)?;
        Ok(places(&mut evaluator, &self.equations.moving))
    }
}

/// What is known of params and, if given, of states.
fn evaluator<'m>(
    equations: &'m Equations,
    params: &[f64],
    states: &[f64],
) -> Result<Evaluator<'m>, Diagnostic> {
    let mut evaluator = Evaluator::new(&equations.graph);
    for (param, value) in equations.params.iter().zip(params) {
        evaluator.set(param.symbol, *value);
    }
    for (state, value) in equations.states.iter().zip(states) {
        evaluator.set(state.symbol, *value);
    }
    for definition in &equations.definitions {
        match definition {
            Definition::Value { symbol, value, .. } => evaluator.define(*symbol, *value),
            Definition::Solve(solve) => close(&mut evaluator, solve)?,
        }
    }
    if !states.is_empty() {
        // Memory decides between turns of an angle, which leave places as they are.
        for discrete in &equations.discretes {
            let initial = evaluator.value(discrete.initial);
            evaluator.set(discrete.symbol, initial);
        }
    }
    Ok(evaluator)
}

/// A drawing in numbers.
fn places(evaluator: &mut Evaluator, drawing: &Drawing) -> Places {
    let mut places = Places::default();
    for shape in &drawing.shapes {
        match shape {
            Shape::Link(name, corners) => {
                let corners = corners
                    .iter()
                    .map(|&corner| point(evaluator, corner))
                    .collect();
                places.links.push((name.clone(), corners));
            }
            Shape::Slide(name, at, along) => {
                let at = at.map(|at| point(evaluator, at));
                places
                    .slides
                    .push((name.clone(), at, point(evaluator, *along)));
            }
        }
    }
    for mark in &drawing.marks {
        let at = point(evaluator, mark.at);
        places.marks.push((mark.name.clone(), at, mark.pin));
    }
    for spring in &drawing.springs {
        places.springs.push(PlacedSpring {
            name: spring.name.clone(),
            ends: ends(evaluator, &spring.ends),
            axis: spring.axis.map(|axis| point(evaluator, axis)),
            stack: spring.stack,
        });
    }
    for contact in &drawing.contacts {
        places.contacts.push(PlacedContact {
            name: contact.name.clone(),
            ends: ends(evaluator, &contact.ends),
            along: point(evaluator, contact.along),
            normal: contact.normal.map(|normal| point(evaluator, normal)),
        });
    }
    places
}

fn ends(evaluator: &mut Evaluator, ends: &[DrawnEnd; 2]) -> [PlacedEnd; 2] {
    [0, 1].map(|index| {
        let end = &ends[index];
        let at = end.at.map(|at| point(evaluator, at));
        (end.body.clone(), at)
    })
}

fn point(evaluator: &mut Evaluator, point: [Expr; 2]) -> Point {
    point.map(|coordinate| evaluator.value(coordinate))
}

/// The longer side of the box around all links and points, in m; 1 m where there are none.
fn size(places: &Places) -> f64 {
    let corners = places.links.iter().flat_map(|(_, corners)| corners);
    let marks = places.marks.iter().map(|(_, at, _)| at);
    let points: Vec<&Point> = corners.chain(marks).collect();
    let extents = [0, 1].map(|axis| {
        let coordinates = points.iter().map(|point| point[axis]);
        let greatest = coordinates.clone().fold(f64::NEG_INFINITY, f64::max);
        greatest - coordinates.fold(f64::INFINITY, f64::min)
    });
    let longest = extents[0].max(extents[1]);
    if longest > 0.0 && longest.is_finite() {
        longest
    } else {
        1.0
    }
}

/// What there is to say of a table: its interval, and how good it is there.
fn table_fact(equations: &Equations, table: &TableReport) -> String {
    let state = &equations.states[table.coordinate];
    if table.half_width == 0.0 {
        return format!(
            "{}: none, its {} functions are evaluated in closed form",
            state.name, table.functions
        );
    }
    let unit = if state.unit == "rad" {
        Unit::Degree
    } else {
        Unit::Metre
    };
    let [from, to] = [-1.0, 1.0].map(|side| {
        let end = table.center + side * table.half_width;
        quantity(end, unit)
    });
    format!(
        "{} from {from} to {to}: {} functions of degree {}, off by {:.0e} at most",
        state.name, table.functions, table.degree, table.error
    )
}

/// What is zero but for rounding is shown as zero: angles in rad and lengths in m alike.
fn without_rounding(value: f64) -> f64 {
    if value.abs() < 1e-13 { 0.0 } else { value }
}

fn shown(unit: ShownUnit) -> Unit {
    match unit {
        ShownUnit::Number => Unit::Number,
        ShownUnit::Degree => Unit::Degree,
        ShownUnit::Metre => Unit::Metre,
        ShownUnit::Other(symbol) => Unit::Other(symbol),
    }
}

/// Sets the unknowns of `solve`. The Jacobian is taken by differences: it only steers the steps.
fn close(evaluator: &mut Evaluator, solve: &Solve) -> Result<(), Diagnostic> {
    let values = |evaluator: &mut Evaluator, exprs: &[Expr]| -> Vec<f64> {
        exprs.iter().map(|&expr| evaluator.value(expr)).collect()
    };
    let mut unknowns = values(evaluator, &solve.guesses);
    let scales = values(evaluator, &solve.scales);
    for &(symbol, value) in &solve.definitions {
        evaluator.define(symbol, value);
    }
    let count = unknowns.len();
    let found = newton::solve(&mut unknowns, &scales, &mut |at, residuals, jacobian| {
        let mut residuals_at = |at: &[f64]| {
            for (symbol, value) in solve.unknowns.iter().zip(at) {
                evaluator.set(*symbol, *value);
            }
            values(evaluator, &solve.residuals)
        };
        residuals.copy_from_slice(&residuals_at(at));
        for column in 0..count {
            let step = 1e-6 * at[column].abs().max(1e-3);
            let mut moved = at.to_vec();
            moved[column] = at[column] + step;
            let above = residuals_at(&moved);
            moved[column] = at[column] - step;
            let below = residuals_at(&moved);
            for row in 0..count {
                jacobian[row * count + column] = (above[row] - below[row]) / (2.0 * step);
            }
        }
    });
    found.map_err(|why| Diagnostic::error(format!("{} cannot be found: {why}", solve.name)))?;
    for (symbol, value) in solve.unknowns.iter().zip(unknowns) {
        evaluator.set(*symbol, value);
    }
    Ok(())
}
