//! The staged program as text: what is computed when.

use std::collections::HashMap;
use std::fmt::Write;

use flexure_runtime::tape::Operation;

use crate::names::{Described, Namer};
use crate::program::{Function, Program, function_titles};
use crate::schedule::{moving_order, order, prepared};
use crate::values::{Node, Stage, Value};

/// Formulas in documentation are cut off at this many characters.
const LONGEST: usize = 80;

/// The stages of `program`: what `prepare` computes, and what each function does.
pub fn listing(program: &Program) -> String {
    let mut writer = Listing::new(program);
    let mut text = format!("model {}\n", program.name);
    writer.parameter_stage(&mut text);
    let events = program.event_rows.iter().map(|event| event.name.as_str());
    let tabulated = program.configurations.iter();
    let tabulated = tabulated.map(|c| program.coordinate_text(c));
    let titles = function_titles(tabulated, program.pass_kink.len(), events);
    for (name, function) in titles.into_iter().zip(program.functions()) {
        if !function.results.is_empty() {
            writer.function(&mut text, &name, function);
        }
    }
    text
}

struct Listing<'p> {
    program: &'p Program,
    described: Described,
    names: HashMap<Value, String>,
    namer: Namer,
    nameless: usize,
}

impl<'p> Listing<'p> {
    fn new(program: &'p Program) -> Self {
        Self {
            program,
            described: Described::new(program),
            names: HashMap::new(),
            namer: Namer::default(),
            nameless: 0,
        }
    }

    fn parameter_stage(&mut self, text: &mut String) {
        let program = self.program;
        let values = &program.values;
        let kept = prepared(program);
        let roots = program
            .checks
            .iter()
            .map(|check| check.margin)
            .chain(program.start_states.iter().copied())
            .chain(program.start_discretes.iter().copied())
            .chain(program.solves.iter().flat_map(|solve| {
                let lists = [
                    &solve.guesses,
                    &solve.scales,
                    &solve.residuals,
                    &solve.jacobian,
                ];
                lists.into_iter().flatten().copied()
            }))
            .chain(kept.iter().copied());
        let all = order(values, roots, |_| true);
        for level in 0..=program.solves.len() {
            let _ = match level.checked_sub(1).and_then(|l| program.solves.get(l)) {
                None => writeln!(text, "\nparameter stage"),
                Some(solve) => writeln!(text, "\nparameter stage, after {}", solve.name),
            };
            for value in &all {
                if values.level(*value) as usize == level {
                    self.line(text, *value);
                }
            }
        }
        let _ = writeln!(text, "\nstart");
        let starts = program.states.iter().zip(&program.start_states);
        let discretes = program.discretes.iter().zip(&program.start_discretes);
        for (row, value) in starts.chain(discretes) {
            let _ = writeln!(text, "  {} = {}", row.name, self.operand(*value));
        }
        let list: Vec<String> = kept.iter().map(|value| self.operand(*value)).collect();
        let _ = writeln!(text, "\nprepared\n  {}", list.join(", "));
    }

    fn function(&mut self, text: &mut String, name: &str, function: &Function) {
        let program = self.program;
        let order = moving_order(&program.values, function.roots());
        let _ = writeln!(text, "\n{name}");
        let mut stage = None;
        for value in order {
            let next = program.values.stage(value);
            if stage != Some(next) {
                let words = match next {
                    Stage::Constant => "constant",
                    Stage::Parameter => "parameter",
                    Stage::Configuration => "configuration",
                    Stage::State => "state",
                };
                let _ = writeln!(text, "  {words}:");
                stage = Some(next);
            }
            self.line(text, value);
        }
        let _ = writeln!(text, "  results:");
        for (position, value) in &function.results {
            let _ = writeln!(text, "    [{position}] = {}", self.operand(*value));
        }
    }

    fn line(&mut self, text: &mut String, value: Value) {
        let operands: Vec<String> = self
            .program
            .values
            .operands(value)
            .map(|operand| self.operand(operand))
            .collect();
        let right = match self.program.values.node(value) {
            Node::Apply(operation, _) => written(operation, &operands),
            Node::Lookup(table, _) => format!("table {}[{}]", table + 1, operands[0]),
            _ => return,
        };
        let name = self.operand(value);
        let _ = writeln!(text, "    {name} = {right}");
    }

    fn operand(&mut self, value: Value) -> String {
        if let Some(number) = self.program.values.as_constant(value) {
            return format!("{number:?}");
        }
        if let Some(name) = self.names.get(&value) {
            return name.clone();
        }
        let wanted = match self.described.name(value) {
            Some(name) => name.to_owned(),
            None => {
                self.nameless += 1;
                format!("t{}", self.nameless)
            }
        };
        let name = self.namer.name(&wanted);
        self.names.insert(value, name.clone());
        name
    }
}

fn written(operation: Operation, operands: &[String]) -> String {
    let sign = match operation {
        Operation::Add => "+",
        Operation::Subtract => "-",
        Operation::Multiply => "*",
        Operation::Divide => "/",
        Operation::Negate => return format!("-{}", operands[0]),
        _ => return format!("{}({})", operation.name(), operands.join(", ")),
    };
    format!("{} {sign} {}", operands[0], operands[1])
}

/// What `value` is, written in one line for documentation; long ones are cut off.
pub(crate) fn expression(program: &Program, value: Value) -> String {
    let text = formula(program, value, 6, true);
    if text.chars().count() > LONGEST {
        let head: String = text.chars().take(LONGEST).collect();
        format!("{head}…")
    } else {
        text
    }
}

/// The formula down to `depth` operations, named parts by their names.
fn formula(program: &Program, value: Value, depth: usize, is_root: bool) -> String {
    if let Some(name) = program.names.get(&value)
        && !is_root
    {
        return name.text.clone();
    }
    let of = |list: &[String], index: u32| list.get(index as usize).cloned().unwrap_or_default();
    let symbols = &program.symbols;
    let (operation, operands) = match program.values.node(value) {
        Node::Constant(bits) => return format!("{:?}", f64::from_bits(bits)),
        Node::Param(index) => return of(&symbols.params, index),
        Node::Unknown(index) => return of(&crate::names::unknown_names(program), index),
        Node::Time => return symbols.time.clone(),
        Node::State(index) => return of(&symbols.states, index),
        Node::Discrete(index) => return of(&symbols.discretes, index),
        Node::Input(index) => return of(&symbols.inputs, index),
        Node::Tabulated(..) | Node::Lookup(..) | Node::Curve(..) => return "table".to_owned(),
        Node::Apply(operation, operands) => (operation, operands),
    };
    if depth == 0 {
        return "…".to_owned();
    }
    let parts: Vec<String> = operands[..operation.arity()]
        .iter()
        .enumerate()
        .map(|(index, operand)| {
            let inner = formula(program, *operand, depth - 1, false);
            let is_product = matches!(
                operation,
                Operation::Multiply | Operation::Divide | Operation::Negate
            );
            let needs = match program.values.node(*operand) {
                _ if program.names.contains_key(operand) => false,
                Node::Apply(Operation::Add | Operation::Subtract, _) => {
                    is_product || (index == 1 && operation == Operation::Subtract)
                }
                Node::Apply(Operation::Multiply | Operation::Divide, _) => {
                    index == 1 && operation == Operation::Divide
                }
                _ => false,
            };
            if needs { format!("({inner})") } else { inner }
        })
        .collect();
    written(operation, &parts)
}
