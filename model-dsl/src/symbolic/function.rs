//! The functions an expression may contain: one table of rules for each.
//!
//! Value, derivative and names of a function stand side by side and are matched exhaustively, so
//! that a new function is added by following the compiler's errors.

use super::{Expr, Graph};

/// A function of one, two or three arguments.
///
/// `CosDifference` and `SinDifference` exist because `cos a - cos b` loses all digits for close
/// angles; they print as the difference and evaluate without cancellation. `Unwrap` brings an
/// angle to within half a turn of a reference. `IfPositive(c, a, b)` is `a` where `c > 0`, else `b`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Function {
    /// sin a
    Sin,
    /// cos a
    Cos,
    /// tan a
    Tan,
    /// arcsin a
    Asin,
    /// arccos a
    Acos,
    /// arctan a
    Atan,
    /// hyperbolic tangent
    Tanh,
    /// e to the power a
    Exp,
    /// natural logarithm
    Log,
    /// absolute value
    Abs,
    /// -1, 0 or 1
    Sign,
    /// largest whole number not above a
    Floor,
    /// direction of the vector (b, a)
    Atan2,
    /// smaller of two
    Min,
    /// larger of two
    Max,
    /// a to the power b, a > 0
    Power,
    /// cos a - cos b
    CosDifference,
    /// sin a - sin b
    SinDifference,
    /// a - 2π round((a - b)/2π)
    Unwrap,
    /// a if c > 0, else b; arguments in the order c, a, b
    IfPositive,
    /// entry a of a table of the graph ([`Graph::table`]), the nearest one outside its range
    Lookup(u32),
}

impl Function {
    /// Every function that needs no table, in declaration order.
    pub const ALL: [Function; 20] = [
        Function::Sin,
        Function::Cos,
        Function::Tan,
        Function::Asin,
        Function::Acos,
        Function::Atan,
        Function::Tanh,
        Function::Exp,
        Function::Log,
        Function::Abs,
        Function::Sign,
        Function::Floor,
        Function::Atan2,
        Function::Min,
        Function::Max,
        Function::Power,
        Function::CosDifference,
        Function::SinDifference,
        Function::Unwrap,
        Function::IfPositive,
    ];

    /// Number of arguments.
    pub fn arity(self) -> usize {
        use Function::*;
        match self {
            Sin | Cos | Tan | Asin | Acos | Atan | Tanh | Exp | Log | Abs | Sign | Floor
            | Lookup(_) => 1,
            Atan2 | Min | Max | Power | CosDifference | SinDifference | Unwrap => 2,
            IfPositive => 3,
        }
    }

    /// Name in plain text, and in the model language where the language offers the function.
    pub fn name(self) -> &'static str {
        use Function::*;
        match self {
            Sin => "sin",
            Cos => "cos",
            Tan => "tan",
            Asin => "asin",
            Acos => "acos",
            Atan => "atan",
            Tanh => "tanh",
            Exp => "exp",
            Log => "log",
            Abs => "abs",
            Sign => "sign",
            Floor => "floor",
            Atan2 => "atan2",
            Min => "min",
            Max => "max",
            Power => "power",
            CosDifference => "cos_difference",
            SinDifference => "sin_difference",
            Unwrap => "unwrap",
            IfPositive => "if_positive",
            Lookup(_) => "lookup",
        }
    }

    /// The canonical value of the function: every evaluator agrees with this definition. `tables`
    /// are those of the graph.
    pub fn value(self, x: &[f64], tables: &[Vec<f64>]) -> f64 {
        use Function::*;
        match self {
            Sin => x[0].sin(),
            Cos => x[0].cos(),
            Tan => x[0].tan(),
            Asin => x[0].asin(),
            Acos => x[0].acos(),
            Atan => x[0].atan(),
            Tanh => x[0].tanh(),
            Exp => x[0].exp(),
            Log => x[0].ln(),
            Abs => x[0].abs(),
            Sign => {
                if x[0] > 0.0 {
                    1.0
                } else if x[0] < 0.0 {
                    -1.0
                } else {
                    0.0 * x[0]
                }
            }
            Floor => x[0].floor(),
            Atan2 => x[0].atan2(x[1]),
            Min => {
                if x[0] < x[1] {
                    x[0]
                } else {
                    x[1]
                }
            }
            Max => {
                if x[0] > x[1] {
                    x[0]
                } else {
                    x[1]
                }
            }
            Power => x[0].powf(x[1]),
            CosDifference => -2.0 * (0.5 * (x[0] + x[1])).sin() * (0.5 * (x[0] - x[1])).sin(),
            SinDifference => 2.0 * (0.5 * (x[0] + x[1])).cos() * (0.5 * (x[0] - x[1])).sin(),
            Unwrap => {
                let turn = 2.0 * std::f64::consts::PI;
                x[0] - turn * ((x[0] - x[1]) / turn).round()
            }
            IfPositive => {
                if x[0] > 0.0 {
                    x[1]
                } else {
                    x[2]
                }
            }
            Lookup(table) => {
                let entries = &tables[table as usize];
                entries[(x[0].max(0.0) as usize).min(entries.len() - 1)]
            }
        }
    }

    /// ∂/∂(argument `index`) as an expression; `None` where it is zero almost everywhere.
    pub(super) fn partial(self, g: &mut Graph, x: &[Expr], index: usize) -> Option<Expr> {
        use Function::*;
        let one = g.one();
        match (self, index) {
            (Sin, 0) => Some(g.cos(x[0])),
            (Cos, 0) => {
                let s = g.sin(x[0]);
                Some(g.neg(s))
            }
            (Tan, 0) => {
                let tan = g.function(Tan, &[x[0]]);
                let square = g.powi(tan, 2);
                Some(g.add(one, square))
            }
            (Asin | Acos, 0) => {
                let square = g.powi(x[0], 2);
                let rest = g.sub(one, square);
                let root = g.sqrt(rest);
                let value = g.div(one, root);
                Some(if self == Asin { value } else { g.neg(value) })
            }
            (Atan, 0) => {
                let square = g.powi(x[0], 2);
                let sum = g.add(one, square);
                Some(g.div(one, sum))
            }
            (Tanh, 0) => {
                let tanh = g.function(Tanh, &[x[0]]);
                let square = g.powi(tanh, 2);
                Some(g.sub(one, square))
            }
            (Exp, 0) => Some(g.function(Exp, &[x[0]])),
            (Log, 0) => Some(g.div(one, x[0])),
            (Abs, 0) => Some(g.function(Sign, &[x[0]])),
            (Atan2, 0 | 1) => {
                let (y2, x2) = (g.powi(x[0], 2), g.powi(x[1], 2));
                let norm = g.add(x2, y2);
                Some(if index == 0 {
                    g.div(x[1], norm)
                } else {
                    let quotient = g.div(x[0], norm);
                    g.neg(quotient)
                })
            }
            (Min | Max, 0 | 1) => {
                let zero = g.zero();
                let difference = if (self == Max) == (index == 0) {
                    g.sub(x[0], x[1])
                } else {
                    g.sub(x[1], x[0])
                };
                Some(g.function(IfPositive, &[difference, one, zero]))
            }
            (Power, 0) => {
                let exponent = g.sub(x[1], one);
                let power = g.function(Power, &[x[0], exponent]);
                Some(g.mul(x[1], power))
            }
            (Power, 1) => {
                let power = g.function(Power, &[x[0], x[1]]);
                let log = g.function(Log, &[x[0]]);
                Some(g.mul(power, log))
            }
            (CosDifference, 0) => {
                let s = g.sin(x[0]);
                Some(g.neg(s))
            }
            (CosDifference, 1) => Some(g.sin(x[1])),
            (SinDifference, 0) => Some(g.cos(x[0])),
            (SinDifference, 1) => {
                let c = g.cos(x[1]);
                Some(g.neg(c))
            }
            (Unwrap, 0) => Some(one),
            (IfPositive, 1) => {
                let zero = g.zero();
                Some(g.function(IfPositive, &[x[0], one, zero]))
            }
            (IfPositive, 2) => {
                let zero = g.zero();
                Some(g.function(IfPositive, &[x[0], zero, one]))
            }
            (Sign | Floor | Lookup(_), _) | (Unwrap, _) | (IfPositive, _) => None,
            (
                Sin | Cos | Tan | Asin | Acos | Atan | Tanh | Exp | Log | Abs | Atan2 | Min | Max
                | Power | CosDifference | SinDifference,
                _,
            ) => None,
        }
    }
}
