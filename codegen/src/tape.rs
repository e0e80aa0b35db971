//! The tape back end: registers for values, instructions for operations.

use std::collections::HashMap;

use flexure_runtime::tape::{
    Block, Check, Fixed, Instruction, Load, Operation, PrepareTape, Solve, Step, Tape,
    TapeConfiguration, TapeEvent, TapeModel, TapeProgram,
};

use crate::program::{Function, Program};
use crate::schedule::{moving_order, order, prepared, prepared_operands};
use crate::values::{Node, Stage, Value, Values};

/// The program as a tape, ready to be prepared and run.
pub fn tape(program: &Program) -> TapeModel {
    let mut registers = PrepareRegisters::default();
    let prepare = prepare(program, &mut registers);
    let mut function = |f: &Function| function_tape(&program.values, f, &mut registers);
    let configurations = program
        .configurations
        .iter()
        .map(|configuration| TapeConfiguration {
            coordinate: configuration.coordinate as usize,
            functions: function(&Function {
                results: configuration.functions.results[..configuration.rates].to_vec(),
            }),
        })
        .collect();
    let rhs = function(&program.rhs);
    let jacobian = function(&program.jacobian);
    let output_values = function(&program.output_values);
    let energy = function(&program.energy);
    let next_kinks = function(&program.next_kinks);
    let pass_kink = program.pass_kink.iter().map(&mut function).collect();
    let events = function(&program.events);
    let event_rows = program
        .event_rows
        .iter()
        .map(|event| TapeEvent {
            name: event.name.clone(),
            stop: event.stop.clone(),
            states: function(&event.states),
            discretes: function(&event.discretes),
        })
        .collect();
    let accept = function(&program.accept);
    let closures = function(&program.closures);
    TapeModel::new(TapeProgram {
        name: program.name.clone(),
        params: program.params.clone(),
        sets: program
            .sets
            .iter()
            .map(|set| (set.name.clone(), set.values.clone()))
            .collect(),
        states: program.states.clone(),
        discretes: program.discretes.clone(),
        inputs: program.inputs.clone(),
        outputs: program.outputs.clone(),
        tables: program.tables.clone(),
        prepare,
        coordinates: program.coordinates(),
        configurations,
        rhs,
        jacobian,
        output_values,
        energy,
        next_kinks,
        pass_kink,
        events,
        event_rows,
        accept,
        turning: program.turning.clone(),
        closures,
        loop_names: program.loop_names.clone(),
    })
}

/// Registers of `prepare`: each value of the parameter stage has its own.
#[derive(Default)]
struct PrepareRegisters {
    of: HashMap<Value, u32>,
    constants: Vec<(u32, f64)>,
    count: u32,
}

impl PrepareRegisters {
    fn register(&mut self, values: &Values, value: Value) -> u32 {
        if let Some(&register) = self.of.get(&value) {
            return register;
        }
        let register = self.count;
        self.count += 1;
        self.of.insert(value, register);
        if let Some(number) = values.as_constant(value) {
            self.constants.push((register, number));
        }
        register
    }

    fn registers(&mut self, values: &Values, list: &[Value]) -> Vec<u32> {
        list.iter().map(|v| self.register(values, *v)).collect()
    }

    fn block(&mut self, values: &Values, order: &[Value]) -> Block {
        order
            .iter()
            .filter_map(|value| {
                let operands = match values.node(*value) {
                    Node::Apply(operation, operands) => (operation, operands),
                    Node::Lookup(_, position) => (Operation::Lookup, [position; 3]),
                    _ => return None,
                };
                let registers = operands.1.map(|operand| self.register(values, operand));
                Some(instruction(
                    values,
                    *value,
                    operands.0,
                    registers,
                    self.register(values, *value),
                ))
            })
            .collect()
    }
}

fn instruction(
    values: &Values,
    value: Value,
    operation: Operation,
    registers: [u32; 3],
    destination: u32,
) -> Instruction {
    let [a, b, c] = registers;
    let operands = match (values.node(value), operation.arity()) {
        (Node::Lookup(table, _), _) => [a, table, 0],
        (_, 1) => [a, 0, 0],
        (_, 2) => [a, b, 0],
        _ => [a, b, c],
    };
    Instruction {
        operation,
        destination,
        operands,
    }
}

fn prepare(program: &Program, registers: &mut PrepareRegisters) -> PrepareTape {
    let values = &program.values;
    // Params come first, in order, so that a parameter set is copied in one piece.
    registers.count = u32::try_from(program.params.len()).unwrap_or(u32::MAX);
    let mut constant_free: Vec<(Value, u32)> = Vec::new();
    for index in 0..values.len() {
        let value = values.at(index);
        if let Node::Param(position) = values.node(value) {
            constant_free.push((value, position));
        }
    }
    registers.of.extend(constant_free);

    let kept = prepared(program);
    let wanted: Vec<Value> = program.parameter_roots(&kept).collect();
    let everything = order(values, wanted.iter().copied(), |_| true);
    let mut steps = Vec::new();
    for level in 0..=program.solves.len() {
        let code: Vec<Value> = everything
            .iter()
            .copied()
            .filter(|value| values.level(*value) as usize == level)
            .collect();
        steps.push(Step::Run(registers.block(values, &code)));
        for check in &program.checks {
            if values.level(check.margin) as usize == level {
                steps.push(Step::Check(Check {
                    margin: registers.register(values, check.margin),
                    zero_is_well: check.zero_is_well,
                    failure: check.message.failure.clone(),
                    code: {
                        let order = order(values, check.message.values.iter().copied(), |_| true);
                        registers.block(values, &order)
                    },
                    values: registers.registers(values, &check.message.values),
                }));
            }
        }
        if let Some(solve) = program.solves.get(level) {
            let after = |value: Value| values.level(value) as usize > level;
            let roots = solve.residuals.iter().chain(&solve.jacobian).copied();
            // What does not change with the unknowns may not have been needed before.
            let before = order(values, roots.clone(), |value| !after(value));
            let before_inner = order(values, roots.clone(), after);
            let mut still: Vec<Value> = before;
            for value in &before_inner {
                still.extend(order(values, values.operands(*value), |v| !after(v)));
            }
            steps.push(Step::Run(registers.block(values, &still)));
            let messages = order(values, solve.message.values.iter().copied(), |_| true);
            steps.push(Step::Solve(Solve {
                name: solve.name.clone(),
                unknowns: registers.registers(values, &solve.unknowns),
                guesses: registers.registers(values, &solve.guesses),
                scales: registers.registers(values, &solve.scales),
                code: registers.block(values, &before_inner),
                residuals: registers.registers(values, &solve.residuals),
                jacobian: registers.registers(values, &solve.jacobian),
                failure: solve.message.failure.clone(),
                failure_code: registers.block(values, &messages),
                values: registers.registers(values, &solve.message.values),
            }));
        }
    }
    let start_states = registers.registers(values, &program.start_states);
    let start_discretes = registers.registers(values, &program.start_discretes);
    PrepareTape {
        registers: registers.count,
        constants: registers.constants.clone(),
        steps,
        start_states,
        start_discretes,
    }
}

/// A function with as few registers as its values allow: one is free again after its last use.
fn function_tape(values: &Values, function: &Function, prepare: &mut PrepareRegisters) -> Tape {
    let order = moving_order(values, function.roots());
    let mut tape = Tape::default();
    let mut register: HashMap<Value, u32> = HashMap::new();
    let mut next = 0;
    let operands = || order.iter().flat_map(|value| values.operands(*value));

    for value in operands().chain(function.roots()) {
        if let Some(number) = values.as_constant(value) {
            register.entry(value).or_insert_with(|| {
                tape.fixed.push(Fixed::Constant(number));
                next += 1;
                next - 1
            });
        }
    }
    for value in prepared_operands(values, &order, function.roots()) {
        tape.fixed
            .push(Fixed::Prepared(prepare.register(values, value)));
        register.insert(value, next);
        next += 1;
    }
    for value in operands().chain(function.roots()) {
        let load = match values.node(value) {
            Node::Time => Load::Time,
            Node::State(index) => Load::State(index),
            Node::Discrete(index) => Load::Discrete(index),
            Node::Input(index) => Load::Input(index),
            Node::Tabulated(index) => Load::Tabulated(index),
            Node::Constant(_)
            | Node::Param(_)
            | Node::Unknown(_)
            | Node::Apply(..)
            | Node::Lookup(..)
            | Node::Curve(..) => continue,
        };
        register.entry(value).or_insert_with(|| {
            tape.loads.push(load);
            next += 1;
            next - 1
        });
    }

    let mut last_use: HashMap<Value, usize> = HashMap::new();
    for (at, value) in order.iter().enumerate() {
        for operand in values.operands(*value) {
            last_use.insert(operand, at);
        }
    }
    for root in function.roots() {
        last_use.insert(root, usize::MAX);
    }
    let mut free: Vec<u32> = Vec::new();
    for (at, value) in order.iter().enumerate() {
        let (operation, operands) = match values.node(*value) {
            Node::Apply(operation, operands) => (operation, operands),
            Node::Lookup(_, position) => (Operation::Lookup, [position; 3]),
            _ => continue,
        };
        let read = operands.map(|operand| register[&operand]);
        let mut freed: Vec<Value> = values
            .operands(*value)
            .filter(|operand| last_use[operand] == at && values.is_computed(*operand))
            .filter(|operand| values.stage(*operand) >= Stage::Configuration)
            .collect();
        freed.sort();
        freed.dedup();
        free.extend(freed.iter().map(|operand| register[operand]));
        let destination = free.pop().unwrap_or_else(|| {
            next += 1;
            next - 1
        });
        register.insert(*value, destination);
        tape.code
            .push(instruction(values, *value, operation, read, destination));
    }
    tape.registers = next;
    tape.results = function
        .results
        .iter()
        .map(|(position, value)| (*position, register[value]))
        .collect();
    tape
}
