//! Names of values, in one pass that makes them safe.
//!
//! The equations' own names come first (`φ2`, `ω2`, `A`); what they do not name is named after
//! what it is (`sin_φ1`, `k_per_m`), and only what has no short such name is numbered. Whatever a
//! user wrote becomes an identifier here: nothing else of it reaches generated code except inside
//! string literals.

use std::collections::{HashMap, HashSet};

use flexure_runtime::tape::Operation;

use crate::program::Program;
use crate::values::{Node, Value};

/// Longest name made up from operands.
const LONGEST: usize = 24;

/// Words that are no identifiers in Rust, now or reserved.
const KEYWORDS: [&str; 53] = [
    "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate",
    "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl",
    "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub", "ref",
    "return", "self", "Self", "static", "struct", "super", "trait", "true", "try", "type",
    "typeof", "unsafe", "unsized", "use", "virtual", "where", "while", "yield", "_",
];

/// An identifier made of `text`: letters and digits stay, Greek included; signs become words.
pub(crate) fn identifier(text: &str) -> String {
    let mut name = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            // A dot over a letter is a rate: φ̇1 becomes dφ1.
            '\u{307}' => insert_before_last(&mut name, "d"),
            '\u{308}' => insert_before_last(&mut name, "dd"),
            '∂' => name.push('d'),
            '⁰'..='⁹' | '¹' | '²' | '³' => {
                name.push('_');
                name.push(superscript_digit(character));
            }
            '₀'..='₉' => {
                let digit = u32::from(character) - u32::from('₀');
                name.push(char::from_digit(digit, 10).unwrap_or('_'));
            }
            '+' => name.push_str("_plus_"),
            '-' | '−' => name.push_str("_minus_"),
            '′' | '\'' => name.push_str("_prime"),
            _ if character == '_' || character.is_alphanumeric() && is_plain(character) => {
                name.push(character);
            }
            _ => name.push('_'),
        }
    }
    let mut tidy = String::with_capacity(name.len());
    for character in name.chars() {
        if character != '_' || !tidy.ends_with('_') {
            tidy.push(character);
        }
    }
    let tidy = tidy.trim_end_matches('_');
    match tidy.chars().next() {
        None => "unnamed".to_owned(),
        Some(first) if first.is_alphabetic() || first == '_' => tidy.to_owned(),
        Some(_) => format!("_{tidy}"),
    }
}

/// Letters and digits that stand in an identifier as they are: those without a second spelling.
fn is_plain(character: char) -> bool {
    character.is_ascii_alphanumeric()
        || matches!(character, 'α'..='ω' | 'Α'..='Ρ' | 'Σ'..='Ω' | 'ϑ' | 'ϕ' | 'ϵ')
        || (character.is_alphabetic()
            && syn::parse_str::<proc_macro2::Ident>(&character.to_string()).is_ok())
}

fn insert_before_last(name: &mut String, what: &str) {
    let at = name.char_indices().next_back().map_or(0, |(at, _)| at);
    name.insert_str(at, what);
}

fn superscript_digit(character: char) -> char {
    match character {
        '¹' => '1',
        '²' => '2',
        '³' => '3',
        _ => {
            let digit = u32::from(character).wrapping_sub(u32::from('⁰'));
            char::from_digit(digit, 10).unwrap_or('_')
        }
    }
}

/// Hands out names, each once.
#[derive(Clone, Debug, Default)]
pub(crate) struct Namer {
    taken: HashSet<String>,
}

impl Namer {
    /// A namer that leaves the given names alone.
    pub(crate) fn without(reserved: &[&str]) -> Self {
        Self {
            taken: reserved.iter().map(|name| (*name).to_owned()).collect(),
        }
    }

    /// A name like `wanted` that nobody else has: an identifier, with a number if it must be.
    pub(crate) fn name(&mut self, wanted: &str) -> String {
        let mut base = identifier(wanted);
        if KEYWORDS.contains(&base.as_str()) {
            base.push('_');
        }
        let mut name = base.clone();
        let mut number = 2;
        while !self.taken.insert(name.clone()) {
            name = format!("{base}_{number}");
            number += 1;
        }
        name
    }
}

/// What each value of a program could be called, as far as there is a short way to say it.
pub(crate) struct Described {
    names: HashMap<Value, String>,
}

impl Described {
    /// Describes every value.
    pub(crate) fn new(program: &Program) -> Self {
        let mut described = Self {
            names: HashMap::new(),
        };
        for index in 0..program.values.len() {
            let value = program.values.at(index);
            let name = match program.names.get(&value) {
                Some(name) => Some(identifier(&name.text)),
                None => described.describe(program, value),
            };
            if let Some(name) = name.filter(|name| name.chars().count() <= LONGEST) {
                described.names.insert(value, name);
            }
        }
        described
    }

    /// A short name for `value`.
    pub(crate) fn name(&self, value: Value) -> Option<&str> {
        self.names.get(&value).map(String::as_str)
    }

    fn describe(&self, program: &Program, value: Value) -> Option<String> {
        let symbols = &program.symbols;
        let of = |list: &[String], index: u32| list.get(index as usize).map(|n| identifier(n));
        match program.values.node(value) {
            Node::Constant(_) => self.number(program, value),
            Node::Param(index) => of(&symbols.params, index),
            Node::Unknown(index) => of(&unknown_names(program), index),
            Node::Time => Some(identifier(&symbols.time)),
            Node::State(index) => of(&symbols.states, index),
            Node::Discrete(index) => of(&symbols.discretes, index),
            Node::Input(index) => of(&symbols.inputs, index),
            Node::Lookup(..) => None,
            Node::Curve(index, _) => {
                let curve = program.compiled.curves.get(index as usize)?;
                self.name(curve.closed_form).map(str::to_owned)
            }
            Node::Tabulated(_) => {
                let mut tabulated = program.configurations.iter().flat_map(|configuration| {
                    let closed_forms = configuration.functions.roots();
                    configuration.leaves.iter().zip(closed_forms)
                });
                let (_, closed_form) = tabulated.find(|(leaf, _)| **leaf == value)?;
                self.name(closed_form).map(str::to_owned)
            }
            Node::Apply(operation, [a, b, _]) => self.apply(program, operation, a, b),
        }
    }

    fn number(&self, program: &Program, value: Value) -> Option<String> {
        let number = program.values.as_constant(value)?;
        match number {
            0.5 => Some("half".to_owned()),
            1.0 => Some("one".to_owned()),
            2.0 => Some("two".to_owned()),
            _ if number.fract() == 0.0 && (0.0..100.0).contains(&number) => {
                Some(format!("{number}"))
            }
            _ => None,
        }
    }

    fn apply(&self, program: &Program, operation: Operation, a: Value, b: Value) -> Option<String> {
        let first = self.name(a)?;
        if operation.arity() == 1 {
            return Some(match operation {
                Operation::Negate => format!("minus_{first}"),
                Operation::Lookup => return None,
                _ => format!("{}_{first}", operation.name()),
            });
        }
        let second = self.name(b)?;
        match operation {
            Operation::Add => Some(format!("{first}_plus_{second}")),
            Operation::Subtract => Some(format!("{first}_minus_{second}")),
            Operation::Multiply if a == b => Some(format!("{first}_squared")),
            Operation::Multiply => Some(format!("{first}_{second}")),
            Operation::Divide if program.values.as_constant(a) == Some(1.0) => {
                Some(format!("per_{second}"))
            }
            Operation::Divide => Some(format!("{first}_per_{second}")),
            _ => None,
        }
    }
}

/// Names of the unknowns of all Newton blocks, as the equations write them.
pub(crate) fn unknown_names(program: &Program) -> Vec<String> {
    program
        .solves
        .iter()
        .flat_map(|solve| solve.unknown_names.iter().cloned())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identifiers_are_identifiers() {
        let cases = [
            ("φ\u{307}1", "dφ1"),
            ("φ\u{308}1", "ddφ1"),
            ("φ2⁰", "φ2_0"),
            ("φ2 - φ2⁰", "φ2_minus_φ2_0"),
            ("cos(φ2 - φ1)", "cos_φ2_minus_φ1"),
            ("∂A/∂φ1", "dA_dφ1"),
            ("d(extension)/dt", "d_extension_dt"),
            ("C0", "C0"),
            ("2nd", "_2nd"),
            ("\"); panic!(\"", "_panic"),
            ("", "unnamed"),
            ("😀", "unnamed"),
            ("F_S", "F_S"),
        ];
        for (text, expected) in cases {
            assert_eq!(identifier(text), expected, "{text}");
            assert!(syn::parse_str::<proc_macro2::Ident>(&identifier(text)).is_ok());
        }
    }

    #[test]
    fn names_are_given_once_and_are_no_keywords() {
        let mut namer = Namer::without(&["t"]);
        let names: Vec<String> = ["a", "a", "t", "type", "Self", "a_2", "gen"]
            .iter()
            .map(|name| namer.name(name))
            .collect();
        let expected = ["a", "a_2", "t_2", "type_", "Self_", "a_2_2", "gen_"];
        assert_eq!(names, expected);
    }
}
