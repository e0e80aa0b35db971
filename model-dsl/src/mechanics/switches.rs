//! Switches: `abs`, `min`, `max`, `sign` and `if` in expressions of forces and drives.
//!
//! Within a step the right-hand side must be smooth, so a switch that depends on time or motion
//! becomes a mode in the discrete state that an event flips where its condition changes sign.

use std::collections::HashMap;

use crate::equations::{Discrete, Event};
use crate::symbolic::{Expr, Function, Node};

use super::Derivation;
use super::start::Mode;

impl Derivation<'_> {
    /// `expr` with its switches turned into modes; `owner` names them.
    pub(super) fn switched(&mut self, expr: Expr, owner: &str) -> Expr {
        let mut done: HashMap<Expr, Expr> = HashMap::new();
        for node in self.g.reachable(&[expr]) {
            let rebuilt = self.rebuilt(node, &done);
            let value = match self.g.node(rebuilt).clone() {
                Node::Function(function, arguments) => {
                    let one = self.g.one();
                    let minus = self.g.integer(-1);
                    let parts = match function {
                        Function::Abs => {
                            let negative = self.g.neg(arguments[0]);
                            Some((arguments[0], arguments[0], negative))
                        }
                        Function::Sign => Some((arguments[0], one, minus)),
                        Function::Max => {
                            let ahead = self.g.sub(arguments[0], arguments[1]);
                            Some((ahead, arguments[0], arguments[1]))
                        }
                        Function::Min => {
                            let ahead = self.g.sub(arguments[1], arguments[0]);
                            Some((ahead, arguments[0], arguments[1]))
                        }
                        Function::IfPositive => Some((arguments[0], arguments[1], arguments[2])),
                        Function::Sin
                        | Function::Cos
                        | Function::Tan
                        | Function::Asin
                        | Function::Acos
                        | Function::Atan
                        | Function::Tanh
                        | Function::Exp
                        | Function::Log
                        | Function::Floor
                        | Function::Atan2
                        | Function::Power
                        | Function::CosDifference
                        | Function::SinDifference
                        | Function::Unwrap
                        | Function::Lookup(_) => None,
                    };
                    match parts {
                        Some((condition, then, otherwise)) if !self.is_of_params(condition) => {
                            self.mode(condition, then, otherwise, owner)
                        }
                        _ => rebuilt,
                    }
                }
                _ => rebuilt,
            };
            done.insert(node, value);
        }
        done[&expr]
    }

    fn rebuilt(&mut self, expr: Expr, done: &HashMap<Expr, Expr>) -> Expr {
        match self.g.node(expr).clone() {
            Node::Sum { constant, terms } => {
                let terms: Vec<_> = terms.into_iter().map(|(t, k)| (done[&t], k)).collect();
                self.g.linear(constant, &terms)
            }
            Node::Product {
                coefficient,
                factors,
            } => {
                let factors: Vec<_> = factors.into_iter().map(|(f, k)| (done[&f], k)).collect();
                self.g.powers(coefficient, &factors)
            }
            Node::Function(function, arguments) => {
                let arguments: Vec<_> = arguments.into_iter().map(|a| done[&a]).collect();
                self.g.function(function, &arguments)
            }
            Node::Number(_) | Node::Pi | Node::Symbol(_) => expr,
        }
    }

    /// `then` where `condition` is positive, else `otherwise`, by a mode and an event.
    fn mode(&mut self, condition: Expr, then: Expr, otherwise: Expr, owner: &str) -> Expr {
        let number = self.discretes.len();
        let mode = self.names.symbol(&mut self.g, &format!("mode{number}"));
        self.g.mark_varying(mode);
        let value = self.g.of(mode);
        let (zero, one) = (self.g.zero(), self.g.one());
        let rates = self.time_rates();
        let rate = self.g.derivative(condition, &rates);
        self.modes.push(Mode {
            discrete: number,
            condition,
            rate: Some(rate),
        });
        self.discretes.push(Discrete {
            name: format!("{owner}.mode{number}"),
            meaning: format!("which branch of a switch in {owner} holds"),
            symbol: mode,
            initial: zero,
            accepted: None,
            turning: false,
        });
        let half = self.g.ratio(1, 2);
        let margin = self.g.sub(value, half);
        let falling = self.g.neg(condition);
        let function = self
            .g
            .function(Function::IfPositive, &[margin, falling, condition]);
        let flipped = self.g.sub(one, value);
        self.events.push(Event {
            name: format!("a switch in {owner}"),
            function,
            state_updates: Vec::new(),
            discrete_updates: vec![(number, flipped)],
            stop: None,
        });
        self.g
            .function(Function::IfPositive, &[margin, then, otherwise])
    }
}
