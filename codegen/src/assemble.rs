//! From equations to the staged program.
//!
//! ```text
//! definitions ──▶ derivatives ──▶ sines from geometry ──▶ values (shared, staged) ──▶ functions ──▶ cut
//! ```

use std::collections::HashSet;

use flexure_model_dsl::equations::{self, Definition, Equations, ShownUnit};
use flexure_model_dsl::symbolic::{Expr, Graph, Symbol};
use flexure_runtime::failure::{Failure, Unit};
use flexure_runtime::system::{Causality, Variable};

use crate::curves;
use crate::cut::cut;
use crate::late;
use crate::lower::{Binding, Context, Lowering};
use crate::program::{Check, Event, Function, Message, Program, Set, Solve, Symbols};
use crate::symbolic::Symbolic;
use crate::values::{Node, Stage, Value};

/// The staged program of `equations`.
pub fn program(equations: &Equations) -> Program {
    let mut graph = equations.graph.clone();
    let prepared = Symbolic::new(equations, &mut graph);
    let mut builder = Builder::new(equations, &graph, &prepared);
    builder.functions();
    builder.parameter_stage();
    cut(&mut builder.program);
    curves::take_out(&mut builder.program);
    late::arrange(&mut builder.program);
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
        let mut asked = HashSet::new();
        for check in &equations.checks {
            let message = message(&check.failure, &mut all);
            let margin = all(&[check.margin])[0];
            // What was asked of one body need not be asked of others that share its params.
            if asked.insert((margin, check.zero_is_well)) {
                program.checks.push(Check {
                    margin,
                    zero_is_well: check.zero_is_well,
                    message,
                });
            }
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
            related: failure
                .related
                .iter()
                .map(|(site, label)| (site.clone(), label.clone().into()))
                .collect(),
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
        let stage = if state.coordinate.is_some() {
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
