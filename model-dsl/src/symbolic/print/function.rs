//! How functions are written.

use super::{Level, Printer, Term, Written, join, number};
use crate::symbolic::{Expr, Function, Node, Rational};

/// How a function and its arguments are put on paper.
enum Form {
    /// `sin(a)`; in LaTeX by its own command, without parentheses around a symbol, and with powers
    /// behind the name.
    Named(&'static str),
    /// `asin(a)`: a name, then arguments in parentheses.
    Called(&'static str),
    /// `|a|`, `⌊a⌋`.
    Fenced([&'static str; 2], [&'static str; 2]),
    /// `a^b`.
    Raised,
    /// `cos a - cos b`.
    Difference(&'static str),
    /// `if c > 0 then a else b`.
    Choice,
    /// Entry of a table.
    Entry(u32),
}

fn form(function: Function) -> Form {
    use Function::*;
    match function {
        Sin => Form::Named("sin"),
        Cos => Form::Named("cos"),
        Tan => Form::Named("tan"),
        Tanh => Form::Named("tanh"),
        Asin => Form::Called(r"\arcsin"),
        Acos => Form::Called(r"\arccos"),
        Atan => Form::Called(r"\arctan"),
        Exp => Form::Called(r"\exp"),
        Log => Form::Called(r"\ln"),
        Sign => Form::Called(r"\operatorname{sgn}"),
        Atan2 => Form::Called(r"\operatorname{atan2}"),
        Min => Form::Called(r"\min"),
        Max => Form::Called(r"\max"),
        Unwrap => Form::Called(r"\operatorname{unwrap}"),
        Abs => Form::Fenced(["|", "|"], [r"\left|", r"\right|"]),
        Floor => Form::Fenced(["floor(", ")"], [r"\left\lfloor ", r"\right\rfloor"]),
        Power => Form::Raised,
        CosDifference => Form::Difference("cos"),
        SinDifference => Form::Difference("sin"),
        IfPositive => Form::Choice,
        Lookup(table) => Form::Entry(table),
    }
}

impl Printer<'_> {
    pub(super) fn function(&mut self, function: Function, arguments: &[Expr]) -> Written {
        match form(function) {
            Form::Named(name) => {
                let text = self.named(name, "", arguments[0]);
                Written::new(text, Level::Power)
            }
            Form::Called(command) => {
                let arguments: Vec<String> = arguments.iter().map(|&a| self.expr(a).text).collect();
                let comma = if function == Function::Unwrap {
                    "; "
                } else {
                    ", "
                };
                let list = self.parentheses(&arguments.join(comma));
                if self.is_latex() {
                    Written::new(format!("{command}{list}"), Level::Power)
                } else {
                    Written::new(format!("{}{list}", function.name()), Level::Atom)
                }
            }
            Form::Fenced(text, latex) => {
                let [open, close] = if self.is_latex() { latex } else { text };
                let inner = self.expr(arguments[0]).text;
                Written::new(format!("{open}{inner}{close}"), Level::Atom)
            }
            Form::Raised => {
                let base = self.expr(arguments[0]);
                let base = self.at_least(Level::Atom, base);
                let exponent = self.expr(arguments[1]);
                let text = if self.is_latex() {
                    format!("{base}^{{{}}}", exponent.text)
                } else {
                    format!("{base}^{}", self.at_least(Level::Atom, exponent))
                };
                Written::new(text, Level::Power)
            }
            Form::Difference(_) => {
                let [first, second] = self.difference(function, arguments);
                Written::new(format!("{first} - {second}"), Level::Sum)
            }
            Form::Choice => self.choice(arguments),
            Form::Entry(table) => {
                let inner = self.expr(arguments[0]).text;
                let text = if self.is_latex() {
                    format!(r"\mathrm{{table}}_{{{}}}\left[{inner}\right]", table + 1)
                } else {
                    format!("table{}[{inner}]", table + 1)
                };
                Written::new(text, Level::Atom)
            }
        }
    }

    /// `cos²(a)`, for functions whose powers are written behind the name.
    pub(super) fn function_power(
        &mut self,
        function: Function,
        arguments: &[Expr],
        exponent: &Rational,
    ) -> Option<Written> {
        let Form::Named(name) = form(function) else {
            return None;
        };
        let raised = number::exponent(exponent, self.style);
        let text = self.named(name, &raised, arguments[0]);
        Some(Written::new(text, Level::Power))
    }

    /// The negative of an odd function of a sum or of a difference.
    pub(super) fn turned(&mut self, function: Function, arguments: &[Expr]) -> Written {
        if let Form::Named(name) = form(function) {
            let argument = join(&self.opposite_terms(arguments[0])).text;
            let argument = self.parentheses(&argument);
            return Written::new(format!("{}{argument}", self.command(name)), Level::Power);
        }
        let [first, second] = self.difference(function, arguments);
        Written::new(format!("{second} - {first}"), Level::Sum)
    }

    fn command(&self, name: &str) -> String {
        if self.is_latex() {
            format!(r"\{name}")
        } else {
            name.to_owned()
        }
    }

    fn named(&mut self, name: &str, raised: &str, argument: Expr) -> String {
        let inner = self.expr(argument);
        if !self.is_latex() {
            return format!("{name}{raised}({})", inner.text);
        }
        let is_short = matches!(
            self.graph.node(argument),
            Node::Symbol(_) | Node::Pi | Node::Number(_)
        );
        if is_short && inner.level >= Level::Power {
            format!(r"\{name}{raised} {}", inner.text)
        } else {
            format!(r"\{name}{raised}{}", self.parentheses(&inner.text))
        }
    }

    /// The two sides of a difference of cosines or sines.
    pub(super) fn difference(&mut self, function: Function, arguments: &[Expr]) -> [String; 2] {
        let name = match form(function) {
            Form::Difference(name) => name,
            _ => function.name(),
        };
        [
            self.named(name, "", arguments[0]),
            self.named(name, "", arguments[1]),
        ]
    }

    fn choice(&mut self, arguments: &[Expr]) -> Written {
        let condition = self.positive(arguments[0]);
        let [first, second] = [self.expr(arguments[1]), self.expr(arguments[2])];
        if self.is_latex() {
            let text = format!(
                r"\begin{{cases}} {} & \text{{if }} {condition} \\ {} & \text{{otherwise}} \end{{cases}}",
                first.text, second.text
            );
            return Written::new(text, Level::Power);
        }
        // `else if` needs no parentheses.
        let first = self.at_least(Level::Sum, first);
        let text = format!("if {condition} then {first} else {}", second.text);
        Written::new(text, Level::Choice)
    }

    /// `a > b` for a - b > 0.
    fn positive(&mut self, expr: Expr) -> String {
        let is_sum = matches!(self.graph.node(expr), Node::Sum { .. });
        if !is_sum {
            let written = self.expr(expr);
            return format!("{} > 0", self.at_least(Level::Sum, written));
        }
        let (negative, positive): (Vec<Term>, Vec<Term>) =
            self.terms(expr).into_iter().partition(|term| term.negative);
        let side = |terms: Vec<Term>| {
            if terms.is_empty() {
                return "0".to_owned();
            }
            let terms: Vec<Term> = terms
                .into_iter()
                .map(|term| Term {
                    negative: false,
                    ..term
                })
                .collect();
            join(&terms).text
        };
        format!("{} > {}", side(positive), side(negative))
    }
}
