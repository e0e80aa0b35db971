//! The staged program: what every back end reads.
//!
//! One arena of values ([`Values`]) serves all functions of a model; a [`Function`] is a list of
//! results. What a function computes is what its results need of the configuration and state
//! stages; what they need of the parameter stage is computed once by `prepare`.

use std::collections::BTreeMap;

use flexure_runtime::failure::Failure;
use flexure_runtime::system::Variable;

use crate::values::{Node, Stage, Value, Values};

/// A model as functions over one arena of values.
#[derive(Clone, Debug, Default)]
pub struct Program {
    /// Name of the model.
    pub name: String,
    /// The model's own words on itself.
    pub doc: String,
    /// Params, each with its default.
    pub params: Vec<Variable>,
    /// Named alternative values.
    pub sets: Vec<Set>,
    /// Rows for inputs, each with its start value.
    pub inputs: Vec<Variable>,
    /// Rows for continuous states.
    pub states: Vec<Variable>,
    /// Rows for discrete states.
    pub discretes: Vec<Variable>,
    /// Rows for outputs.
    pub outputs: Vec<Variable>,
    /// Names of params, inputs, states and discrete states as the equations write them.
    pub symbols: Symbols,
    /// Tables of numbers.
    pub tables: Vec<Vec<f64>>,
    /// All values.
    pub values: Values,
    /// What the equations call computed values, and what they say about them.
    pub names: BTreeMap<Value, Name>,
    /// Conditions on params.
    pub checks: Vec<Check>,
    /// Newton blocks, in order.
    pub solves: Vec<Solve>,
    /// Continuous states at the start.
    pub start_states: Vec<Value>,
    /// Discrete states at the start.
    pub start_discretes: Vec<Value>,
    /// For each coordinate with a table its functions.
    pub configurations: Vec<Configuration>,
    /// Rates of the continuous states.
    pub rhs: Function,
    /// Entries of ∂rates/∂states, row by row, that are not zero.
    pub jacobian: Function,
    /// Outputs.
    pub output_values: Function,
    /// Kinetic and potential energy, dissipated and supplied power.
    pub energy: Function,
    /// Times of the next kinks.
    pub next_kinks: Function,
    /// For each kink the new discrete states.
    pub pass_kink: Vec<Function>,
    /// Event functions.
    pub events: Function,
    /// What events are and do.
    pub event_rows: Vec<Event>,
    /// Discrete states after an accepted step.
    pub accept: Function,
    /// Discrete states that are angles.
    pub turning: Vec<usize>,
    /// Closures of the loops.
    pub closures: Function,
    /// Functions in the form that compiled code computes them in.
    pub compiled: Compiled,
    /// Names of the loops.
    pub loop_names: Vec<String>,
}

/// What listings call the functions of a model with these kinks and events.
pub(crate) fn function_titles<'e>(
    tabulated: impl Iterator<Item = &'e str>,
    kinks: usize,
    events: impl Iterator<Item = &'e str>,
) -> Vec<String> {
    let mut titles: Vec<String> = tabulated.map(|q| format!("functions of {q}")).collect();
    let always = [
        "rhs",
        "jacobian",
        "outputs",
        "energy",
        "next kinks",
        "events",
        "accept",
        "closures",
    ];
    titles.extend(always.map(str::to_owned));
    titles.extend((0..kinks).map(|index| format!("pass kink {index}")));
    for event in events {
        titles.push(format!("pass event `{event}`, states"));
        titles.push(format!("pass event `{event}`, discrete states"));
    }
    titles
}

/// Names as the equations write them: `φ1` for the state `crank.angle`.
#[derive(Clone, Debug, Default)]
pub struct Symbols {
    /// Time.
    pub time: String,
    /// Params.
    pub params: Vec<String>,
    /// Inputs.
    pub inputs: Vec<String>,
    /// Continuous states.
    pub states: Vec<String>,
    /// Discrete states.
    pub discretes: Vec<String>,
}

/// A named set of parameter values.
#[derive(Clone, Debug, PartialEq)]
pub struct Set {
    /// Name.
    pub name: String,
    /// The user's words on it.
    pub doc: String,
    /// Position among the params, and value in SI.
    pub values: Vec<(usize, f64)>,
}

/// What a value is called.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// As the equations write it.
    pub text: String,
    /// In words; may be empty.
    pub meaning: String,
}

/// A function: positions in its result, and their values.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Function {
    /// What is computed.
    pub results: Vec<(u32, Value)>,
}

impl Function {
    /// Values of the results.
    pub fn roots(&self) -> impl Iterator<Item = Value> + '_ {
        self.results.iter().map(|(_, value)| *value)
    }
}

/// Functions of one coordinate alone: a table gives them near the start, else they are evaluated.
#[derive(Clone, Debug)]
pub struct Configuration {
    /// Position of the coordinate among the states.
    pub coordinate: u32,
    /// Number of those that rates are computed of. They come first; the others are angles and
    /// closures, for the end of a step.
    pub rates: usize,
    /// Their closed forms.
    pub functions: Function,
    /// What stands for each of them.
    pub leaves: Vec<Value>,
}

/// Functions as compiled code computes them: with the values of tables and curves, and so that what
/// is known last is used last.
#[derive(Clone, Debug, Default)]
pub struct Compiled {
    /// Rates of the continuous states.
    pub rhs: Function,
    /// Discrete states after an accepted step.
    pub accept: Function,
    /// Closures of the loops.
    pub closures: Function,
    /// Curves that `rhs` is computed of.
    pub curves: Vec<Curve>,
}

/// A function of one quantity of the state stage and of params.
#[derive(Clone, Copy, Debug)]
pub struct Curve {
    /// The quantity.
    pub pivot: Value,
    /// Its closed form.
    pub closed_form: Value,
}

/// A condition on params.
#[derive(Clone, Debug)]
pub struct Check {
    /// Positive where all is well.
    pub margin: Value,
    /// Whether zero is well too.
    pub zero_is_well: bool,
    /// What to say.
    pub message: Message,
}

/// Something to say, with holes.
#[derive(Clone, Debug)]
pub struct Message {
    /// The text.
    pub failure: Failure,
    /// What fills its holes.
    pub values: Vec<Value>,
}

/// A Newton block.
#[derive(Clone, Debug)]
pub struct Solve {
    /// What is sought.
    pub name: String,
    /// The unknowns.
    pub unknowns: Vec<Value>,
    /// Their names.
    pub unknown_names: Vec<String>,
    /// Where to start.
    pub guesses: Vec<Value>,
    /// Sizes of one unit of the residuals.
    pub scales: Vec<Value>,
    /// What must vanish.
    pub residuals: Vec<Value>,
    /// Its derivatives by the unknowns, row by row.
    pub jacobian: Vec<Value>,
    /// What to say if there is no solution.
    pub message: Message,
}

/// An event.
#[derive(Clone, Debug)]
pub struct Event {
    /// Its name.
    pub name: String,
    /// Why the run ends there, if it does.
    pub stop: Option<String>,
    /// New continuous states.
    pub states: Function,
    /// New discrete states.
    pub discretes: Function,
}

impl Program {
    /// What `prepare` computes, but for what Newton blocks compute inside: the margins of checks,
    /// where Newton starts and by what it measures, the start, and what the functions use.
    pub fn parameter_roots<'p>(
        &'p self,
        prepared: &'p [Value],
    ) -> impl Iterator<Item = Value> + 'p {
        let margins = self.checks.iter().map(|check| check.margin);
        let solves = self.solves.iter();
        margins
            .chain(solves.flat_map(|solve| solve.guesses.iter().chain(&solve.scales).copied()))
            .chain(self.start_states.iter().copied())
            .chain(self.start_discretes.iter().copied())
            .chain(prepared.iter().copied())
    }

    /// Positions of the coordinates and of their rates among the states.
    pub fn coordinates(&self) -> Vec<(usize, usize)> {
        let mut pairs = Vec::new();
        for index in 0..self.values.len() {
            let value = self.values.at(index);
            if let Node::State(position) = self.values.node(value)
                && self.values.stage(value) == Stage::Configuration
                && let Some((_, rate)) = self.rhs.results.iter().find(|(to, _)| *to == position)
                && let Node::State(rate) = self.values.node(*rate)
            {
                pairs.push((position as usize, rate as usize));
            }
        }
        pairs.sort_unstable();
        pairs
    }

    /// What the equations call the coordinate of a table.
    pub(crate) fn coordinate_text(&self, configuration: &Configuration) -> &str {
        let position = configuration.coordinate as usize;
        self.symbols.states.get(position).map_or("", |text| text)
    }

    /// The functions that compiled code is written of.
    pub(crate) fn compiled_functions(&self) -> Vec<Function> {
        let replaced = [&self.rhs, &self.accept, &self.closures];
        let compiled = [
            &self.compiled.rhs,
            &self.compiled.accept,
            &self.compiled.closures,
        ];
        let all = self.functions().into_iter();
        let others = all.filter(|function| !replaced.iter().any(|r| std::ptr::eq(*r, *function)));
        let curves = Function {
            results: (0..)
                .zip(self.compiled.curves.iter().map(|curve| curve.closed_form))
                .collect(),
        };
        let functions = others.chain(compiled).cloned();
        functions.chain([curves]).collect()
    }

    /// Every function of time, state and inputs, in the order in which listings have them.
    pub fn functions(&self) -> Vec<&Function> {
        let tabulated = self.configurations.iter();
        let mut functions: Vec<&Function> = tabulated.map(|c| &c.functions).collect();
        functions.extend([
            &self.rhs,
            &self.jacobian,
            &self.output_values,
            &self.energy,
            &self.next_kinks,
            &self.events,
            &self.accept,
            &self.closures,
        ]);
        functions.extend(&self.pass_kink);
        for event in &self.event_rows {
            functions.extend([&event.states, &event.discretes]);
        }
        functions
    }
}
