//! From equations to the staged program.
//!
//! ```text
//! definitions ──▶ derivatives ──▶ sines from geometry ──▶ values (shared, staged) ──▶ functions
//! ```

use std::collections::HashMap;

use flexure_model_dsl::equations::{self, Definition, Equations, ShownUnit};
use flexure_model_dsl::symbolic::{Expr, Graph, Symbol};
use flexure_runtime::failure::{Failure, Unit};
use flexure_runtime::system::{Causality, Variable};

use crate::directions::{Identities, identities};
use crate::jacobian::{Known, derivatives};
use crate::lower::{Binding, Context, Lowering};
use crate::program::{Check, Event, Function, Message, Program, Set, Solve, Symbols};
use crate::values::{Node, Stage, Value};

/// The staged program of `equations`.
pub fn program(equations: &Equations) -> Program {
    let mut graph = equations.graph.clone();
    let prepared = Symbolic::new(equations, &mut graph);
    let mut builder = Builder::new(equations, &graph, &prepared);
    builder.functions();
    builder.parameter_stage();
    builder.program
}

/// How values in messages are shown, for the runtime.
pub fn unit(unit: ShownUnit) -> Unit {
    match unit {
        ShownUnit::Number => Unit::Number,
        ShownUnit::Degree => Unit::Degree,
        ShownUnit::Metre => Unit::Metre,
        ShownUnit::Other(symbol) => Unit::Other(symbol),
    }
}

/// What is done on the graph before values are made of it.
struct Symbolic {
    /// Every definition, those of derivatives and of sines and cosines included.
    definitions: Vec<(Symbol, Expr)>,
    meanings: HashMap<Symbol, String>,
    replacements: HashMap<Expr, Expr>,
    /// Row, column and value of what is not zero in ∂rates/∂states.
    jacobian: Vec<(usize, usize, Expr)>,
    /// For each Newton block its Jacobian, row by row.
    solve_jacobians: Vec<Vec<Expr>>,
    roots: Vec<Expr>,
}

impl Symbolic {
    fn new(equations: &Equations, graph: &mut Graph) -> Self {
        let mut definitions: Vec<(Symbol, Expr)> = Vec::new();
        let mut meanings = HashMap::new();
        for definition in &equations.definitions {
            match definition {
                Definition::Value {
                    symbol,
                    value,
                    meaning,
                } => {
                    definitions.push((*symbol, *value));
                    meanings.insert(*symbol, meaning.clone());
                }
                Definition::Solve(solve) => definitions.extend(&solve.definitions),
            }
        }
        let mut known = Known::new();
        for partial in &equations.partials {
            let partials = known.entry(partial.symbol).or_default();
            partials.insert(partial.state, partial.value);
        }
        let mut derived = Vec::new();
        let mut jacobian = Vec::new();
        let rates: Vec<Expr> = equations.states.iter().map(|state| state.rate).collect();
        let relevant = relevant(graph, &definitions, &rates);
        for (column, state) in equations.states.iter().enumerate() {
            let column_values =
                derivatives(graph, &relevant, &rates, state.symbol, &known, &mut derived);
            for (row, value) in column_values.into_iter().enumerate() {
                if !graph.is_zero(value) {
                    jacobian.push((row, column, value));
                }
            }
        }
        jacobian.sort_by_key(|(row, column, _)| (*row, *column));
        let mut solve_jacobians = Vec::new();
        for definition in &equations.definitions {
            if let Definition::Solve(solve) = definition {
                solve_jacobians.push(solve_jacobian(graph, solve, &mut derived));
            }
        }
        definitions.extend(derived);

        let mut roots = roots(equations);
        roots.extend(jacobian.iter().map(|(_, _, value)| *value));
        roots.extend(solve_jacobians.iter().flatten());
        roots.extend(definitions.iter().map(|(_, value)| *value));
        let fixed = fixed_symbols(graph, equations, &definitions);
        let Identities {
            replacements,
            definitions: found,
        } = identities(graph, &roots, &equations.directions, &fixed);
        roots.extend(found.iter().map(|(_, value)| *value));
        definitions.extend(found);
        Self {
            definitions,
            meanings,
            replacements,
            jacobian,
            solve_jacobians,
            roots,
        }
    }
}

/// Those of `definitions` that `roots` use, directly or not.
fn relevant(graph: &Graph, definitions: &[(Symbol, Expr)], roots: &[Expr]) -> Vec<(Symbol, Expr)> {
    let mut used = vec![false; graph.symbol_count()];
    for symbol in graph.symbols_in(roots) {
        used[symbol.index()] = true;
    }
    let mut relevant = Vec::new();
    for &(symbol, value) in definitions.iter().rev() {
        if used[symbol.index()] {
            for inner in graph.symbols_in(&[value]) {
                used[inner.index()] = true;
            }
            relevant.push((symbol, value));
        }
    }
    relevant.reverse();
    relevant
}

fn solve_jacobian(
    graph: &mut Graph,
    solve: &equations::Solve,
    derived: &mut Vec<(Symbol, Expr)>,
) -> Vec<Expr> {
    let columns: Vec<Vec<Expr>> = solve
        .unknowns
        .iter()
        .map(|unknown| {
            derivatives(
                graph,
                &solve.definitions,
                &solve.residuals,
                *unknown,
                &Known::new(),
                derived,
            )
        })
        .collect();
    (0..solve.residuals.len())
        .flat_map(|row| columns.iter().map(move |column| column[row]))
        .collect()
}

/// Every expression that the equations compute, definitions apart.
fn roots(equations: &Equations) -> Vec<Expr> {
    let mut roots = Vec::new();
    for definition in &equations.definitions {
        if let Definition::Solve(solve) = definition {
            roots.extend(&solve.guesses);
            roots.extend(&solve.residuals);
            roots.extend(&solve.scales);
            roots.extend(solve.failure.values.iter().map(|shown| shown.value));
        }
    }
    roots.extend(equations.partials.iter().map(|partial| partial.value));
    for direction in &equations.directions {
        roots.extend([direction.cos, direction.sin]);
    }
    for state in &equations.states {
        roots.extend([state.initial, state.rate]);
    }
    for discrete in &equations.discretes {
        roots.push(discrete.initial);
        roots.extend(discrete.accepted);
    }
    for kink in &equations.kinks {
        roots.push(kink.next);
        roots.extend(kink.updates.iter().map(|(_, value)| *value));
    }
    for event in &equations.events {
        roots.push(event.function);
        let updates = event.state_updates.iter().chain(&event.discrete_updates);
        roots.extend(updates.map(|(_, value)| *value));
    }
    roots.extend(equations.outputs.iter().map(|output| output.value));
    let energy = &equations.energy;
    roots.extend([
        energy.kinetic,
        energy.potential,
        energy.dissipated_power,
        energy.supplied_power,
    ]);
    roots.extend(equations.loops.iter().map(|l| l.closure));
    for check in &equations.checks {
        roots.push(check.margin);
        roots.extend(check.failure.values.iter().map(|shown| shown.value));
    }
    roots
}

/// For each symbol of the graph, by its position, whether it depends on params alone.
fn fixed_symbols(
    graph: &Graph,
    equations: &Equations,
    definitions: &[(Symbol, Expr)],
) -> Vec<bool> {
    let mut fixed = vec![false; graph.symbol_count()];
    for param in &equations.params {
        fixed[param.symbol.index()] = true;
    }
    for definition in &equations.definitions {
        if let Definition::Solve(solve) = definition {
            for unknown in &solve.unknowns {
                fixed[unknown.index()] = true;
            }
        }
    }
    for (symbol, value) in definitions {
        fixed[symbol.index()] = graph
            .symbols_in(&[*value])
            .iter()
            .all(|inner| fixed[inner.index()]);
    }
    fixed
}

struct Builder<'e> {
    equations: &'e Equations,
    symbolic: &'e Symbolic,
    context: Context<'e>,
    program: Program,
    bindings: Vec<Binding>,
}

impl<'e> Builder<'e> {
    fn new(equations: &'e Equations, graph: &'e Graph, symbolic: &'e Symbolic) -> Self {
        let context = Context::new(
            graph,
            &symbolic.replacements,
            &symbolic.meanings,
            &symbolic.roots,
        );
        let mut program = Program {
            name: equations.name.clone(),
            doc: equations.doc.clone(),
            tables: graph.tables().to_vec(),
            ..Program::default()
        };
        let bindings = bindings(equations, graph, symbolic, &mut program);
        Self {
            equations,
            symbolic,
            context,
            program,
            bindings,
        }
    }

    fn functions(&mut self) {
        let mut lowering = Lowering::new(&self.context, self.bindings.clone());
        let program = &mut self.program;
        let equations = self.equations;
        let mut lower = |expr: Expr| lowering.value(&mut program.values, &mut program.names, expr);
        let mut function = |exprs: &mut dyn Iterator<Item = (usize, Expr)>| Function {
            results: exprs
                .map(|(position, expr)| (position_of(position), lower(expr)))
                .collect(),
        };
        program.rhs = function(&mut equations.states.iter().map(|s| s.rate).enumerate());
        let count = equations.states.len();
        program.jacobian = function(
            &mut self
                .symbolic
                .jacobian
                .iter()
                .map(|(row, column, value)| (row * count + column, *value)),
        );
        program.output_values =
            function(&mut equations.outputs.iter().map(|o| o.value).enumerate());
        let energy = &equations.energy;
        program.energy = function(
            &mut [
                energy.kinetic,
                energy.potential,
                energy.dissipated_power,
                energy.supplied_power,
            ]
            .into_iter()
            .enumerate(),
        );
        program.next_kinks = function(&mut equations.kinks.iter().map(|k| k.next).enumerate());
        program.pass_kink = equations
            .kinks
            .iter()
            .map(|kink| function(&mut kink.updates.iter().copied()))
            .collect();
        program.events = function(&mut equations.events.iter().map(|e| e.function).enumerate());
        program.event_rows = equations
            .events
            .iter()
            .map(|event| Event {
                name: event.name.clone(),
                stop: event.stop.clone(),
                states: function(&mut event.state_updates.iter().copied()),
                discretes: function(&mut event.discrete_updates.iter().copied()),
            })
            .collect();
        program.accept = function(
            &mut equations
                .discretes
                .iter()
                .enumerate()
                .filter_map(|(index, discrete)| Some((index, discrete.accepted?))),
        );
        program.turning = equations
            .discretes
            .iter()
            .enumerate()
            .filter(|(_, discrete)| discrete.turning)
            .map(|(index, _)| index)
            .collect();
        program.closures = function(&mut equations.loops.iter().map(|l| l.closure).enumerate());
        program.loop_names = equations.loops.iter().map(|l| l.name.clone()).collect();
    }

    fn parameter_stage(&mut self) {
        let mut lowering = Lowering::new(&self.context, self.bindings.clone());
        let program = &mut self.program;
        let equations = self.equations;
        let mut lower = |expr: Expr| lowering.value(&mut program.values, &mut program.names, expr);
        let mut all = |exprs: &[Expr]| exprs.iter().map(|e| lower(*e)).collect::<Vec<Value>>();
        for check in &equations.checks {
            let message = message(&check.failure, &mut all);
            program.checks.push(Check {
                margin: all(&[check.margin])[0],
                zero_is_well: check.zero_is_well,
                message,
            });
        }
        let mut jacobians = self.symbolic.solve_jacobians.iter();
        for definition in &equations.definitions {
            let Definition::Solve(solve) = definition else {
                continue;
            };
            let message = message(&solve.failure, &mut all);
            let unknowns: Vec<Value> = solve
                .unknowns
                .iter()
                .filter_map(|unknown| match self.bindings[unknown.index()] {
                    Binding::Value(value) => Some(value),
                    Binding::Defined(_) | Binding::Missing => None,
                })
                .collect();
            program.solves.push(Solve {
                name: solve.name.clone(),
                unknowns,
                unknown_names: solve
                    .unknowns
                    .iter()
                    .map(|unknown| self.context.graph.symbol_text(*unknown).to_owned())
                    .collect(),
                guesses: all(&solve.guesses),
                scales: all(&solve.scales),
                residuals: all(&solve.residuals),
                jacobian: jacobians.next().map(|j| all(j)).unwrap_or_default(),
                message,
            });
        }
        self.start();
    }

    /// The start: the same expressions with the states at their initial values, at rest in time.
    fn start(&mut self) {
        let program = &mut self.program;
        let equations = self.equations;
        let mut of_params = Lowering::new(&self.context, self.bindings.clone());
        let start_states: Vec<Value> = equations
            .states
            .iter()
            .map(|state| of_params.value(&mut program.values, &mut program.names, state.initial))
            .collect();
        let mut at_start = Lowering::new(&self.context, self.bindings.clone());
        let zero = program.values.constant(0.0);
        at_start.bind(equations.time, zero);
        for (input, row) in equations.inputs.iter().zip(&program.inputs) {
            let value = program.values.constant(row.start.unwrap_or(0.0));
            at_start.bind(input.symbol, value);
        }
        for (state, value) in equations.states.iter().zip(&start_states) {
            at_start.bind(state.symbol, *value);
        }
        let unknown = program.values.constant(f64::NAN);
        for discrete in &equations.discretes {
            at_start.bind(discrete.symbol, unknown);
        }
        // Names belong to what is computed at every step, not to its value at the start.
        let mut unnamed = std::collections::BTreeMap::new();
        program.start_discretes = equations
            .discretes
            .iter()
            .map(|discrete| {
                let value = at_start.value(&mut program.values, &mut unnamed, discrete.initial);
                at_start.bind(discrete.symbol, value);
                value
            })
            .collect();
        program.start_states = start_states;
    }
}

fn message(failure: &equations::Failure, all: &mut dyn FnMut(&[Expr]) -> Vec<Value>) -> Message {
    let exprs: Vec<Expr> = failure.values.iter().map(|shown| shown.value).collect();
    Message {
        failure: Failure {
            message: failure.message.clone().into(),
            hint: failure.hint.clone().map(Into::into),
            site: failure.site.clone(),
            units: failure
                .values
                .iter()
                .map(|shown| unit(shown.unit))
                .collect(),
        },
        values: all(&exprs),
    }
}

/// Enters the given quantities into the program and says what each symbol stands for.
fn bindings(
    equations: &Equations,
    graph: &Graph,
    symbolic: &Symbolic,
    program: &mut Program,
) -> Vec<Binding> {
    let mut bindings = vec![Binding::Missing; graph.symbol_count()];
    let text = |symbol: Symbol| graph.symbol_text(symbol).to_owned();
    let mut evaluator = flexure_model_dsl::symbolic::Evaluator::new(graph);
    let mut symbols = Symbols {
        time: text(equations.time),
        ..Symbols::default()
    };
    let values = &mut program.values;
    let mut leaf =
        |node: Node, stage: Stage, level: u32| Binding::Value(values.leaf(node, stage, level));
    bindings[equations.time.index()] = leaf(Node::Time, Stage::State, 0);
    for (index, param) in equations.params.iter().enumerate() {
        program.params.push(Variable {
            name: param.name.clone().into(),
            unit: param.dimension.si_unit().into(),
            meaning: param.doc.clone().into(),
            causality: Causality::Parameter,
            start: Some(evaluator.value(param.default)),
        });
        symbols.params.push(text(param.symbol));
        let node = Node::Param(position_of(index));
        bindings[param.symbol.index()] = leaf(node, Stage::Parameter, 0);
    }
    for set in &equations.sets {
        program.sets.push(Set {
            name: set.name.clone(),
            doc: set.doc.clone(),
            values: set
                .values
                .iter()
                .map(|(position, value)| (*position, evaluator.value(*value)))
                .collect(),
        });
    }
    for (index, input) in equations.inputs.iter().enumerate() {
        program.inputs.push(Variable {
            name: input.name.clone().into(),
            unit: input.dimension.si_unit().into(),
            meaning: input.doc.clone().into(),
            causality: Causality::Input,
            start: Some(evaluator.value(input.start)),
        });
        symbols.inputs.push(text(input.symbol));
        let node = Node::Input(position_of(index));
        bindings[input.symbol.index()] = leaf(node, Stage::State, 0);
    }
    for (index, state) in equations.states.iter().enumerate() {
        program.states.push(Variable {
            name: state.name.clone().into(),
            unit: state.unit.clone().into(),
            meaning: state.meaning.clone().into(),
            causality: Causality::State,
            start: None,
        });
        symbols.states.push(text(state.symbol));
        let stage = if state.is_coordinate {
            Stage::Configuration
        } else {
            Stage::State
        };
        bindings[state.symbol.index()] = leaf(Node::State(position_of(index)), stage, 0);
    }
    for (index, discrete) in equations.discretes.iter().enumerate() {
        program.discretes.push(Variable {
            name: discrete.name.clone().into(),
            unit: if discrete.turning { "rad" } else { "1" }.into(),
            meaning: discrete.meaning.clone().into(),
            causality: Causality::Discrete,
            start: None,
        });
        symbols.discretes.push(text(discrete.symbol));
        let stage = if discrete.turning {
            Stage::Configuration
        } else {
            Stage::State
        };
        let node = Node::Discrete(position_of(index));
        bindings[discrete.symbol.index()] = leaf(node, stage, 0);
    }
    for output in &equations.outputs {
        program.outputs.push(Variable {
            name: output.name.clone().into(),
            unit: output.unit.clone().into(),
            meaning: output.meaning.clone().into(),
            causality: Causality::Output,
            start: None,
        });
    }
    for (symbol, value) in &symbolic.definitions {
        bindings[symbol.index()] = Binding::Defined(*value);
    }
    let mut unknown_count = 0;
    let mut level = 0;
    for definition in &equations.definitions {
        if let Definition::Solve(solve) = definition {
            level += 1;
            for unknown in &solve.unknowns {
                let node = Node::Unknown(unknown_count);
                bindings[unknown.index()] = leaf(node, Stage::Parameter, level);
                unknown_count += 1;
            }
        }
    }
    program.symbols = symbols;
    bindings
}

/// A position as the back ends count: models have far fewer than 2^32 of anything.
fn position_of(index: usize) -> u32 {
    u32::try_from(index).unwrap_or(u32::MAX)
}
