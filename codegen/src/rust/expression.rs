//! Values as Rust expressions: infix, with as few parentheses as keep the order of evaluation.

use flexure_runtime::tape::Operation;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

/// How tightly an expression holds together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Level {
    Sum,
    Product,
    Minus,
    Atom,
}

/// An expression with what is needed to build others of it.
#[derive(Clone, Debug)]
pub(super) struct Piece {
    pub(super) tokens: TokenStream,
    pub(super) level: Level,
    /// About how many characters it takes.
    pub(super) length: usize,
    /// The number that it is, if it is one.
    pub(super) constant: Option<f64>,
}

impl Piece {
    pub(super) fn atom(tokens: TokenStream) -> Self {
        let length = tokens.to_string().chars().count();
        Self {
            tokens,
            level: Level::Atom,
            length,
            constant: None,
        }
    }

    pub(super) fn constant(number: f64) -> Self {
        let tokens = literal(number);
        let length = tokens.to_string().chars().count();
        Self {
            tokens,
            level: if number.is_sign_negative() {
                Level::Minus
            } else {
                Level::Atom
            },
            length,
            constant: Some(number),
        }
    }

    fn at_least(&self, level: Level) -> TokenStream {
        let tokens = &self.tokens;
        if self.level >= level {
            quote!(#tokens)
        } else {
            quote!((#tokens))
        }
    }
}

/// The shortest literal that reads back as the same number.
pub(super) fn literal(number: f64) -> TokenStream {
    if number.is_nan() {
        return quote!(f64::NAN);
    }
    if number.is_infinite() {
        return if number > 0.0 {
            quote!(f64::INFINITY)
        } else {
            quote!(f64::NEG_INFINITY)
        };
    }
    let size = number.abs();
    let plain = format!("{size:?}");
    let scientific = format!("{size:e}");
    let shorter = if plain.len() <= scientific.len() + 2 {
        plain
    } else {
        scientific
    };
    // `1e5` is a float literal; so is `1.0`. Either parses.
    let literal: Literal = shorter
        .parse()
        .unwrap_or_else(|_| Literal::f64_unsuffixed(size));
    if number.is_sign_negative() {
        quote!(-#literal)
    } else {
        quote!(#literal)
    }
}

/// The identifier of that name, which a namer made.
pub(super) fn ident(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}

/// A position or a length.
pub(super) fn unsuffixed(number: usize) -> Literal {
    Literal::usize_unsuffixed(number)
}

/// `operation` on pieces, in numbers of type `number`. Where that is not `f64`, a constant needs
/// the type except on the right of an operator.
pub(super) fn apply(
    number: &TokenStream,
    operation: Operation,
    a: &Piece,
    b: &Piece,
    c: &Piece,
) -> Piece {
    let typed = |piece: &Piece| match piece.constant {
        Some(_) => {
            let tokens = &piece.tokens;
            Piece {
                length: piece.length + 13,
                level: Level::Atom,
                tokens: quote!(#number::from_f64(#tokens)),
                constant: None,
            }
        }
        None => piece.clone(),
    };
    let is_plain = number.to_string() == "f64";
    let of_type = |piece: &Piece| {
        if is_plain {
            piece.clone()
        } else {
            typed(piece)
        }
    };
    // Of a plain number, the method of that name would be the platform's.
    let own = if is_plain { of_trait } else { method };
    match operation {
        Operation::Negate => {
            let inner = of_type(a).at_least(Level::Minus);
            Piece {
                tokens: quote!(-#inner),
                level: Level::Minus,
                length: a.length + 1,
                constant: None,
            }
        }
        Operation::Add => {
            let [a, b] = number_last(a, b);
            infix(&of_type(a), quote!(+), b, Level::Sum)
        }
        Operation::Subtract => infix(&of_type(a), quote!(-), b, Level::Sum),
        Operation::Multiply => {
            let [a, b] = number_last(a, b);
            infix(&of_type(a), quote!(*), b, Level::Product)
        }
        Operation::Divide if a.constant == Some(1.0) => method(b, "recip", &[]),
        Operation::Divide => infix(&of_type(a), quote!(/), b, Level::Product),
        Operation::Sqrt => method(a, "sqrt", &[]),
        Operation::Sin => own(a, "sin", &[]),
        Operation::Cos => own(a, "cos", &[]),
        Operation::Tan => own(a, "tan", &[]),
        Operation::Asin => own(a, "asin", &[]),
        Operation::Acos => own(a, "acos", &[]),
        Operation::Atan => own(a, "atan", &[]),
        Operation::Tanh => own(a, "tanh", &[]),
        Operation::Exp => own(a, "exp", &[]),
        Operation::Log => own(a, "ln", &[]),
        Operation::Abs => method(a, "abs", &[]),
        Operation::Sign => method(a, "sign", &[]),
        Operation::Floor => method(a, "floor", &[]),
        Operation::Atan2 => own(&typed(a), "atan2", &[of_type(b)]),
        Operation::Min => method(&typed(a), "smaller", &[of_type(b)]),
        Operation::Max => method(&typed(a), "larger", &[of_type(b)]),
        Operation::Power => method(&typed(a), "power", &[of_type(b)]),
        Operation::Unwrap => method(&typed(a), "unwrap_to", &[of_type(b)]),
        Operation::IfPositive => method(&typed(a), "if_positive", &[of_type(b), of_type(c)]),
        Operation::Lookup => method(&typed(a), "lookup", std::slice::from_ref(b)),
    }
}

/// Operators take a plain number on their right.
fn number_last<'p>(a: &'p Piece, b: &'p Piece) -> [&'p Piece; 2] {
    if a.constant.is_some() { [b, a] } else { [a, b] }
}

fn infix(a: &Piece, sign: TokenStream, b: &Piece, level: Level) -> Piece {
    let left = a.at_least(level);
    // Operators associate to the left; what stands on the right keeps its parentheses.
    let right = match (level, b.level) {
        (Level::Sum, Level::Sum) | (Level::Product, Level::Sum | Level::Product) => {
            let tokens = &b.tokens;
            quote!((#tokens))
        }
        _ => b.at_least(Level::Product),
    };
    Piece {
        tokens: quote!(#left #sign #right),
        level,
        length: a.length + b.length + 3,
        constant: None,
    }
}

pub(super) fn method(receiver: &Piece, name: &str, arguments: &[Piece]) -> Piece {
    let on = receiver.at_least(Level::Atom);
    let name_ident = ident(name);
    let list = arguments.iter().map(|argument| &argument.tokens);
    Piece {
        tokens: quote!(#on.#name_ident(#(#list),*)),
        level: Level::Atom,
        length: receiver.length
            + name.len()
            + 3
            + arguments.iter().map(|a| a.length + 2).sum::<usize>(),
        constant: None,
    }
}

/// `Real::name(receiver, …)`.
fn of_trait(receiver: &Piece, name: &str, arguments: &[Piece]) -> Piece {
    let name_ident = ident(name);
    let all = std::iter::once(receiver).chain(arguments);
    let list = all.clone().map(|argument| &argument.tokens);
    Piece {
        tokens: quote!(Real::#name_ident(#(#list),*)),
        level: Level::Atom,
        length: name.len() + 6 + all.map(|a| a.length + 2).sum::<usize>(),
        constant: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literals_are_exact_and_short() {
        for number in [
            0.0,
            -0.0,
            1.0,
            -2.5,
            0.1,
            1e-7,
            2.568e-4,
            5e300,
            5e-324,
            f64::MAX,
            123_456_789.0,
            std::f64::consts::PI,
        ] {
            let text = literal(number).to_string().replace(' ', "");
            assert_eq!(text.parse::<f64>().map(f64::to_bits), Ok(number.to_bits()));
            assert!(text.len() <= 25, "{text}");
        }
    }

    #[test]
    fn parentheses_keep_the_order_of_evaluation() {
        let [a, b, c] = ["a", "b", "c"].map(|name| {
            Piece::atom({
                let name = ident(name);
                quote!(#name)
            })
        });
        let number = quote!(T);
        let of = |operation, x: &Piece, y: &Piece| apply(&number, operation, x, y, x);
        let sum = of(Operation::Add, &b, &c);
        let product = of(Operation::Multiply, &b, &c);
        let text = |piece: Piece| piece.tokens.to_string();
        assert_eq!(text(of(Operation::Subtract, &a, &sum)), "a - (b + c)");
        assert_eq!(text(of(Operation::Add, &sum, &a)), "b + c + a");
        assert_eq!(text(of(Operation::Multiply, &a, &product)), "a * (b * c)");
        assert_eq!(text(of(Operation::Subtract, &a, &product)), "a - b * c");
        let minus = of(Operation::Negate, &sum, &sum);
        assert_eq!(text(minus.clone()), "- (b + c)");
        assert_eq!(
            text(of(Operation::Sqrt, &minus, &a)),
            "(- (b + c)) . sqrt ()"
        );
        let two = Piece::constant(2.0);
        assert_eq!(text(of(Operation::Multiply, &two, &a)), "a * 2.0");
        assert_eq!(
            text(of(Operation::Subtract, &two, &a)),
            "T :: from_f64 (2.0) - a"
        );
        let less = Piece::constant(-2.0);
        assert_eq!(text(of(Operation::Add, &a, &less)), "a + - 2.0");
    }
}
