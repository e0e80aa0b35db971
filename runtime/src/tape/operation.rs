//! The fixed set of operations that every program is made of.

use crate::real::Real;

macro_rules! operations {
    ($($(#[doc = $doc:literal])* $name:ident $arity:literal $text:literal,)*) => {
        /// An operation on one, two or three numbers.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[repr(u8)]
        pub enum Operation {
            $($(#[doc = $doc])* $name,)*
        }

        impl Operation {
            /// Every operation, in declaration order.
            pub const ALL: &[Operation] = &[$(Operation::$name,)*];

            /// Number of operands.
            pub fn arity(self) -> usize {
                match self {
                    $(Operation::$name => $arity,)*
                }
            }

            /// Name in listings.
            pub fn name(self) -> &'static str {
                match self {
                    $(Operation::$name => $text,)*
                }
            }
        }
    };
}

operations! {
    /// -a
    Negate 1 "negate",
    /// a + b
    Add 2 "add",
    /// a - b
    Subtract 2 "subtract",
    /// a · b
    Multiply 2 "multiply",
    /// a · b + c
    MultiplyAdd 3 "multiply_add",
    /// a · b - c
    MultiplySubtract 3 "multiply_subtract",
    /// c - a · b
    SubtractProduct 3 "subtract_product",
    /// a / b
    Divide 2 "divide",
    /// √a
    Sqrt 1 "sqrt",
    /// sin a
    Sin 1 "sin",
    /// cos a
    Cos 1 "cos",
    /// tan a
    Tan 1 "tan",
    /// arcsin a
    Asin 1 "asin",
    /// arccos a
    Acos 1 "acos",
    /// arctan a
    Atan 1 "atan",
    /// tanh a
    Tanh 1 "tanh",
    /// e to the power a
    Exp 1 "exp",
    /// ln a
    Log 1 "log",
    /// |a|
    Abs 1 "abs",
    /// -1, 0 or 1
    Sign 1 "sign",
    /// largest whole number not above a
    Floor 1 "floor",
    /// direction of the vector (b, a)
    Atan2 2 "atan2",
    /// the smaller
    Min 2 "min",
    /// the larger
    Max 2 "max",
    /// a to the power b
    Power 2 "power",
    /// a, moved by whole turns to within half a turn of b
    Unwrap 2 "unwrap",
    /// b if a is positive, else c
    IfPositive 3 "if_positive",
    /// entry a of the table whose position stands in the second operand's place
    Lookup 1 "lookup",
}

/// Where an operation finds what it works on; only what it takes is fetched.
pub trait Operands<T> {
    /// The first operand.
    fn first(&self) -> T;
    /// The second operand.
    fn second(&self) -> T;
    /// The third operand.
    fn third(&self) -> T;
    /// The table that [`Operation::Lookup`] reads.
    fn table(&self) -> &[f64];
}

/// Numbers at hand, without tables.
impl<T: Copy> Operands<T> for [T; 3] {
    fn first(&self) -> T {
        self[0]
    }
    fn second(&self) -> T {
        self[1]
    }
    fn third(&self) -> T {
        self[2]
    }
    fn table(&self) -> &[f64] {
        &[]
    }
}

impl Operation {
    /// The result for these operands.
    #[inline(always)]
    pub fn apply<T: Real>(self, operands: &impl Operands<T>) -> T {
        let a = operands.first();
        match self {
            Operation::Negate => -a,
            Operation::Add => a + operands.second(),
            Operation::Subtract => a - operands.second(),
            Operation::Multiply => a * operands.second(),
            Operation::MultiplyAdd => a.times_plus(operands.second(), operands.third()),
            Operation::MultiplySubtract => a.times_plus(operands.second(), -operands.third()),
            Operation::SubtractProduct => operands.third().minus_product(a, operands.second()),
            Operation::Divide => a / operands.second(),
            Operation::Sqrt => a.sqrt(),
            Operation::Sin => a.sin(),
            Operation::Cos => a.cos(),
            Operation::Tan => a.tan(),
            Operation::Asin => a.asin(),
            Operation::Acos => a.acos(),
            Operation::Atan => a.atan(),
            Operation::Tanh => a.tanh(),
            Operation::Exp => a.exp(),
            Operation::Log => a.ln(),
            Operation::Abs => a.abs(),
            Operation::Sign => a.sign(),
            Operation::Floor => a.floor(),
            Operation::Atan2 => a.atan2(operands.second()),
            Operation::Min => a.smaller(operands.second()),
            Operation::Max => a.larger(operands.second()),
            Operation::Power => a.power(operands.second()),
            Operation::Unwrap => a.unwrap_to(operands.second()),
            Operation::IfPositive => a.if_positive(operands.second(), operands.third()),
            Operation::Lookup => a.lookup(operands.table()),
        }
    }
}
