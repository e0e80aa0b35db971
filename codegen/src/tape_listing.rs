//! A tape as text: its registers, and its instructions in order.

use std::fmt::Write;

use flexure_runtime::tape::{
    Block, Fixed, Instruction, Load, Operation, Step, Tape, TapeModel, TapeProgram,
};

use crate::program::function_titles;

/// Every function of a tape, instruction by instruction: `r7 = multiply r2 r5`.
pub fn tape_listing(model: &TapeModel) -> String {
    let program = model.program();
    let mut text = format!("tape of {}\n", program.name);
    prepare(&mut text, program);
    let tabulated = program.configurations.iter();
    let mut tapes: Vec<&Tape> = tabulated.map(|c| &c.functions).collect();
    tapes.extend([
        &program.rhs,
        &program.jacobian,
        &program.output_values,
        &program.energy,
        &program.next_kinks,
        &program.events,
        &program.accept,
        &program.closures,
    ]);
    tapes.extend(&program.pass_kink);
    for event in &program.event_rows {
        tapes.extend([&event.states, &event.discretes]);
    }
    let events = program.event_rows.iter().map(|event| event.name.as_ref());
    let tabulated = program.configurations.iter();
    let tabulated = tabulated.map(|c| program.states[c.coordinate].name.as_ref());
    let titles = function_titles(tabulated, program.pass_kink.len(), events);
    for (name, tape) in titles.iter().zip(tapes) {
        function(&mut text, name, tape, program);
    }
    text
}

fn prepare(text: &mut String, program: &TapeProgram) {
    let tape = &program.prepare;
    let _ = writeln!(text, "\nprepare: {} registers", tape.registers);
    for (register, param) in program.params.iter().enumerate() {
        let _ = writeln!(text, "  r{register} = param {}", param.name);
    }
    for (register, number) in &tape.constants {
        let _ = writeln!(text, "  r{register} = {number:?}");
    }
    for step in &tape.steps {
        match step {
            Step::Run(code) => block(text, "  ", code),
            Step::Check(check) => {
                let sign = if check.zero_is_well { ">=" } else { ">" };
                let _ = writeln!(text, "  check r{} {sign} 0", check.margin);
            }
            Step::Solve(solve) => {
                let _ = writeln!(
                    text,
                    "  solve {}: {} from {} until {} vanish",
                    solve.name,
                    list(&solve.unknowns),
                    list(&solve.guesses),
                    list(&solve.residuals)
                );
                block(text, "    ", &solve.code);
            }
        }
    }
}

fn function(text: &mut String, name: &str, tape: &Tape, program: &TapeProgram) {
    if tape.results.is_empty() {
        return;
    }
    let _ = writeln!(
        text,
        "\n{name}: {} instructions, {} registers",
        tape.code.len(),
        tape.registers
    );
    let mut register = 0;
    for fixed in &tape.fixed {
        let _ = match fixed {
            Fixed::Constant(number) => writeln!(text, "  r{register} = {number:?}"),
            Fixed::Prepared(from) => writeln!(text, "  r{register} = prepared r{from}"),
        };
        register += 1;
    }
    for load in &tape.loads {
        let name = match load {
            Load::Time => "t".to_owned(),
            Load::State(index) => program.states[*index as usize].name.to_string(),
            Load::Discrete(index) => program.discretes[*index as usize].name.to_string(),
            Load::Input(index) => program.inputs[*index as usize].name.to_string(),
            Load::Tabulated(index) => format!("tabulated {index}"),
        };
        let _ = writeln!(text, "  r{register} = {name}");
        register += 1;
    }
    block(text, "  ", &tape.code);
    for (position, register) in &tape.results {
        let _ = writeln!(text, "  result {position} = r{register}");
    }
}

fn block(text: &mut String, indent: &str, code: &Block) {
    for instruction in code {
        let Instruction {
            operation,
            destination,
            operands,
        } = instruction;
        let _ = write!(text, "{indent}r{destination} = {}", operation.name());
        for operand in &operands[..operation.arity()] {
            let _ = write!(text, " r{operand}");
        }
        if *operation == Operation::Lookup {
            let _ = write!(text, " table {}", operands[1] + 1);
        }
        text.push('\n');
    }
}

fn list(registers: &[u32]) -> String {
    let names: Vec<String> = registers.iter().map(|r| format!("r{r}")).collect();
    names.join(", ")
}
