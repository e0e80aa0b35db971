//! Bodies of functions: a `let` for what is shared or named, everything else nested.

use std::collections::{BTreeMap, HashMap, HashSet};

use flexure_runtime::tape::Operation;
use proc_macro2::TokenStream;
use quote::quote;

use super::configuration::function_name;
use super::curve;
use super::expression::{Level, Piece, apply, ident, method, unsuffixed};
use crate::names::{Described, Namer};
use crate::program::Program;
use crate::values::{Node, Stage, Value};

/// Expressions longer than this get a name.
const LINE: usize = 64;

/// Names that generated functions use themselves, or that would be patterns instead of names.
pub(super) const RESERVED: [&str; 42] = [
    "t",
    "x",
    "d",
    "u",
    "p",
    "dx",
    "T",
    "result",
    "index",
    "Some",
    "None",
    "Ok",
    "Err",
    "Params",
    "Prepared",
    "VARIABLES",
    "EQUATIONS",
    "EQUATIONS_LATEX",
    "FAILURES",
    "TURNING",
    "COORDINATES",
    "Table",
    "TableReport",
    "Curve",
    "CurveReport",
    "prepared",
    "Self",
    "Real",
    "System",
    "LaneSystem",
    "Lanes",
    "Variable",
    "Energy",
    "EventAction",
    "Causality",
    "Diagnostic",
    "Failure",
    "Site",
    "Unit",
    "Cow",
    "Box",
    "f64",
];

/// What is the same for all functions of a program.
pub(super) struct Writer<'p> {
    pub(super) program: &'p Program,
    pub(super) described: Described,
    /// Fields of `Prepared`.
    pub(super) fields: HashMap<Value, String>,
    /// Fields of `Params`.
    pub(super) params: Vec<String>,
    /// Whether comments are written, as attributes that the printer knows.
    pub(super) comments: bool,
}

/// A function's statements so far.
pub(super) struct Body<'w, 'p> {
    writer: &'w Writer<'p>,
    /// Type of numbers: `T`, or `f64` in `prepare`.
    number: TokenStream,
    is_prepare: bool,
    /// Whether products are fused with the sums that they are terms of.
    is_fused: bool,
    namer: Namer,
    pieces: HashMap<Value, Piece>,
    /// The values of `pieces` in the order in which they came.
    made: Vec<Value>,
    stage: Option<Stage>,
    /// Names for given quantities, by what is read.
    loads: BTreeMap<(u8, u32), TokenStream>,
    /// Number of names without a meaning so far.
    nameless: usize,
    statements: Vec<TokenStream>,
}

impl<'w, 'p> Body<'w, 'p> {
    /// An empty body of a function of prepared values, generic over `T`.
    pub(super) fn generic(writer: &'w Writer<'p>) -> Self {
        Self::new(writer, false)
    }

    /// An empty body of a function of the configuration alone, which no comment needs to say.
    pub(super) fn of_configuration(writer: &'w Writer<'p>) -> Self {
        Self {
            stage: Some(Stage::Configuration),
            ..Self::new(writer, false)
        }
    }

    /// An empty body of a function whose state stage counts: products there are fused with sums.
    pub(super) fn fused(writer: &'w Writer<'p>) -> Self {
        Self {
            is_fused: true,
            ..Self::new(writer, false)
        }
    }

    /// The same of the state stage alone, which no comment needs to say.
    pub(super) fn of_state(writer: &'w Writer<'p>) -> Self {
        Self {
            stage: Some(Stage::State),
            ..Self::fused(writer)
        }
    }

    /// An empty body of `prepare`, in plain numbers.
    pub(super) fn prepare(writer: &'w Writer<'p>) -> Self {
        Self::new(writer, true)
    }

    fn new(writer: &'w Writer<'p>, is_prepare: bool) -> Self {
        let tables = (0..writer.program.tables.len()).map(table_name);
        let mut namer = Namer::without(&RESERVED);
        for table in tables {
            namer.name(&table);
        }
        for configuration in &writer.program.configurations {
            namer.name(&function_name(writer.program, configuration));
        }
        for (index, curve) in writer.program.compiled.curves.iter().enumerate() {
            namer.name(&curve::function_name(writer, index, curve));
        }
        Self {
            writer,
            number: if is_prepare { quote!(f64) } else { quote!(T) },
            is_prepare,
            is_fused: false,
            namer,
            pieces: HashMap::new(),
            made: Vec::new(),
            stage: None,
            loads: BTreeMap::new(),
            nameless: 0,
            statements: Vec::new(),
        }
    }

    /// The statements: given quantities first.
    pub(super) fn finish(self) -> Vec<TokenStream> {
        self.loads.into_values().chain(self.statements).collect()
    }

    /// Statements that `write` adds, for a block of their own; what they name is unknown after it.
    pub(super) fn block(&mut self, write: impl FnOnce(&mut Self)) -> Vec<TokenStream> {
        let outside = std::mem::take(&mut self.statements);
        let known = self.made.len();
        write(self);
        let values = &self.writer.program.values;
        for value in self.made.split_off(known) {
            // What is given stays loaded: loads stand outside of all blocks.
            if values.is_computed(value) {
                self.pieces.remove(&value);
            }
        }
        std::mem::replace(&mut self.statements, outside)
    }

    /// Adds a statement.
    pub(super) fn push(&mut self, statement: TokenStream) {
        self.statements.push(statement);
    }

    /// Gives a value that is computed elsewhere a name, without a statement.
    pub(super) fn name(&mut self, value: Value, wanted: &str) -> String {
        let name = self.namer.name(wanted);
        let name_ident = ident(&name);
        self.keep(value, Piece::atom(quote!(#name_ident)));
        name
    }

    fn keep(&mut self, value: Value, piece: Piece) {
        if self.pieces.insert(value, piece).is_none() {
            self.made.push(value);
        }
    }

    /// Writes `order`, whose values are used as often as they occur among each other's operands
    /// and in `roots`.
    pub(super) fn compute(&mut self, order: &[Value], roots: &[Value]) {
        let values = &self.writer.program.values;
        let mut uses: HashMap<Value, usize> = HashMap::new();
        for value in order
            .iter()
            .flat_map(|value| values.operands(*value))
            .chain(roots.iter().copied())
        {
            *uses.entry(value).or_insert(0) += 1;
        }
        let angles = self.shared_angles(order);
        let pivots: Vec<Value> = order
            .iter()
            .filter_map(|value| match values.node(*value) {
                Node::Curve(_, pivot) => Some(pivot),
                _ => None,
            })
            .collect();
        let is_product =
            |value: Value| matches!(values.node(value), Node::Apply(Operation::Multiply, _));
        let is_sum = |value: Value| {
            values.stage(value) == Stage::State
                && matches!(
                    values.node(value),
                    Node::Apply(Operation::Add | Operation::Subtract, _)
                )
        };
        let sums = order
            .iter()
            .filter(|value| self.is_fused && is_sum(**value));
        let summed: HashSet<Value> = sums
            .flat_map(|value| values.operands(*value))
            .filter(|value| is_product(*value))
            .collect();
        for &value in order {
            if self.pieces.contains_key(&value) {
                continue;
            }
            self.load_operands(value);
            if let Node::Curve(index, pivot) = values.node(value) {
                let argument = self.piece(pivot).tokens;
                let tokens = curve::value(self.writer, index as usize, &argument);
                self.bind(value, &tokens);
                continue;
            }
            let (operation, operands) = match values.node(value) {
                Node::Apply(operation, operands) => (operation, operands),
                Node::Lookup(_, position) => (Operation::Lookup, [position; 3]),
                _ => continue,
            };
            if matches!(operation, Operation::Sin | Operation::Cos)
                && let Some(&pair) = angles.get(&operands[0])
            {
                self.sine_and_cosine(pair, operands[0], value);
                continue;
            }
            let is_inner = |operand: Value| {
                uses.get(&operand) == Some(&1) && !self.writer.program.names.contains_key(&operand)
            };
            let piece = if self.is_fused && values.stage(value) == Stage::State {
                self.fused_sum(operation, operands, is_inner)
            } else {
                None
            };
            let piece = piece.unwrap_or_else(|| self.expression(value, operation, operands));
            // A product that will be fused stays one.
            let is_kept = is_inner(value) && summed.contains(&value);
            let is_named = self.writer.program.names.contains_key(&value);
            let is_shared = uses.get(&value).is_some_and(|count| *count > 1);
            let is_trivial = operation == Operation::Negate && piece.length <= 20;
            if is_named
                || pivots.contains(&value)
                || (is_shared && !is_trivial)
                || (piece.length > LINE && !is_kept)
            {
                self.bind(value, &piece.tokens);
            } else {
                self.keep(value, piece);
            }
        }
        for &root in roots {
            self.load(root);
        }
    }

    /// The expression for a value that was computed or loaded.
    pub(super) fn piece(&self, value: Value) -> Piece {
        self.pieces
            .get(&value)
            .cloned()
            .unwrap_or_else(|| self.writer.given(value))
    }

    /// The same, as a number of the body's type wherever it stands.
    pub(super) fn number_tokens(&self, value: Value) -> TokenStream {
        let piece = self.piece(value);
        let tokens = &piece.tokens;
        let number = &self.number;
        match piece.constant {
            Some(_) if !self.is_prepare => quote!(#number::from_f64(#tokens)),
            _ => quote!(#tokens),
        }
    }

    fn expression(&self, value: Value, operation: Operation, operands: [Value; 3]) -> Piece {
        let [a, b, c] = operands.map(|operand| self.piece(operand));
        let b = match self.writer.program.values.node(value) {
            Node::Lookup(table, _) => {
                let table = ident(&table_name(table as usize));
                Piece::atom(quote!(&#table))
            }
            _ => b,
        };
        apply(&self.number, operation, &a, &b, &c)
    }

    /// A sum with a product as one operation, if one of its terms is a product that nothing else uses.
    fn fused_sum(
        &self,
        operation: Operation,
        [a, b, _]: [Value; 3],
        is_inner: impl Fn(Value) -> bool,
    ) -> Option<Piece> {
        let product = |value: Value| match self.writer.program.values.node(value) {
            Node::Apply(Operation::Multiply, [x, y, _])
                if is_inner(value) && self.piece(value).level == Level::Product =>
            {
                Some([x, y].map(|factor| self.piece(factor)))
            }
            _ => None,
        };
        let (sum, factors, name) = match (operation, product(a), product(b)) {
            (Operation::Add, _, Some(factors)) => (self.piece(a), factors, "plus_product"),
            (Operation::Add, Some(factors), None) => (self.piece(b), factors, "plus_product"),
            (Operation::Subtract, _, Some(factors)) => (self.piece(a), factors, "minus_product"),
            (Operation::Subtract, Some(factors), None) => {
                let b = self.piece(b);
                let minus = apply(&self.number, Operation::Negate, &b, &b, &b);
                (minus, factors, "plus_product")
            }
            _ => return None,
        };
        // A plain number would be longer than what is saved.
        let has_number = factors.iter().any(|factor| factor.constant.is_some());
        (!has_number && sum.constant.is_none()).then(|| method(&sum, name, &factors))
    }

    /// Angles of which both sine and cosine are computed, and these.
    fn shared_angles(&self, order: &[Value]) -> HashMap<Value, [Value; 2]> {
        let values = &self.writer.program.values;
        let mut of = [HashMap::new(), HashMap::new()];
        for &value in order {
            match values.node(value) {
                Node::Apply(Operation::Sin, [angle, ..]) => of[0].insert(angle, value),
                Node::Apply(Operation::Cos, [angle, ..]) => of[1].insert(angle, value),
                _ => continue,
            };
        }
        let [sines, cosines] = of;
        sines
            .into_iter()
            .filter_map(|(angle, sine)| Some((angle, [sine, *cosines.get(&angle)?])))
            .collect()
    }

    /// Names sine and cosine of an angle, of which `first` is met first.
    fn sine_and_cosine(&mut self, pair: [Value; 2], angle: Value, first: Value) {
        let mut name = |value: Value| {
            let wanted = self.wanted_name(value);
            ident(&self.name(value, &wanted))
        };
        let [sin, cos] = if pair[0] == first {
            pair.map(name)
        } else {
            let cos = name(pair[1]);
            [name(pair[0]), cos]
        };
        let piece = self.piece(angle);
        let of = apply(&self.number, Operation::Sin, &piece, &piece, &piece).tokens;
        // `angle.sin()` with another method's name: the receiver is the same.
        let of = replace_method(of, "sin_cos");
        let comment = self.stage_comment(first);
        self.statements
            .push(quote!(#comment let (#sin, #cos) = #of;));
    }

    fn bind(&mut self, value: Value, tokens: &TokenStream) {
        let wanted = self.wanted_name(value);
        let stage = self.stage_comment(value);
        let name = ident(&self.name(value, &wanted));
        let comment = self
            .writer
            .program
            .names
            .get(&value)
            .filter(|name| self.writer.comments && !name.meaning.is_empty())
            .map(|name| {
                let text = format!(" {}", name.meaning.replace('\n', " "));
                quote!(#[comment = #text])
            });
        self.statements
            .push(quote!(#stage #comment let #name = #tokens;));
    }

    pub(super) fn wanted_name(&mut self, value: Value) -> String {
        match self.writer.described.name(value) {
            Some(name) => name.to_owned(),
            None => {
                self.nameless += 1;
                format!("t{}", self.nameless)
            }
        }
    }

    /// Says which stage begins, where it does.
    fn stage_comment(&mut self, value: Value) -> Option<TokenStream> {
        let stage = self.writer.program.values.stage(value);
        if !self.writer.comments || self.stage == Some(stage) {
            return None;
        }
        self.stage = Some(stage);
        let text = match stage {
            Stage::Configuration => " ── configuration ──",
            Stage::State => " ── state ──",
            Stage::Constant | Stage::Parameter => return None,
        };
        Some(quote!(#[comment = #text]))
    }

    fn load_operands(&mut self, value: Value) {
        let operands: Vec<Value> = self.writer.program.values.operands(value).collect();
        for operand in operands {
            self.load(operand);
        }
    }

    /// Names a given quantity on its first use: `let φ1 = x[0];`.
    pub(super) fn load(&mut self, value: Value) {
        if self.pieces.contains_key(&value) {
            return;
        }
        let from = |array: &str, index: u32| {
            let array = ident(array);
            let index = unsuffixed(index as usize);
            quote!(#array[#index])
        };
        let (key, tokens) = match self.writer.program.values.node(value) {
            Node::State(index) => ((0, index), from("x", index)),
            Node::Discrete(index) => ((1, index), from("d", index)),
            Node::Input(index) => ((2, index), from("u", index)),
            Node::Param(index) if self.is_prepare => {
                let field = ident(&self.writer.params[index as usize]);
                ((3, index), quote!(self.#field))
            }
            _ => return,
        };
        let wanted = self.wanted_name(value);
        let name = ident(&self.name(value, &wanted));
        self.loads.insert(key, quote!(let #name = #tokens;));
    }
}

impl Writer<'_> {
    /// The expression of what no statement computes.
    fn given(&self, value: Value) -> Piece {
        if let Some(field) = self.fields.get(&value) {
            let field = ident(field);
            return Piece::atom(quote!(p.#field));
        }
        match self.program.values.node(value) {
            Node::Constant(bits) => Piece::constant(f64::from_bits(bits)),
            Node::Time => Piece::atom(quote!(t)),
            _ => Piece::constant(f64::NAN),
        }
    }
}

/// Name of the static that holds a table.
pub(super) fn table_name(index: usize) -> String {
    format!("TABLE_{}", index + 1)
}

fn replace_method(tokens: TokenStream, name: &str) -> TokenStream {
    let mut trees: Vec<proc_macro2::TokenTree> = tokens.into_iter().collect();
    if let Some(position) = trees.len().checked_sub(2) {
        trees[position] = ident(name).into();
    }
    trees.into_iter().collect()
}
