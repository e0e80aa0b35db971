//! Derivatives through definitions.
//!
//! Each definition that changes with the variable gets a definition of its derivative, so that the
//! graph grows by about its own size per variable instead of being written out.

use std::collections::{BTreeSet, HashMap};

use flexure_model_dsl::symbolic::{Expr, Graph, Node, Rates, Symbol};

/// Derivatives that are known without differentiating a definition: by defined symbol, for each
/// variable of which it depends.
pub(crate) type Known = HashMap<Symbol, HashMap<Symbol, Expr>>;

/// Definitions, each after what it uses, and roots, with who uses what: most depend on few
/// variables.
pub(crate) struct Uses<'d> {
    definitions: &'d [(Symbol, Expr)],
    roots: &'d [Expr],
    /// By symbol, the positions of the definitions that change at once when it does.
    definitions_of: HashMap<Symbol, Vec<usize>>,
    /// By symbol, the positions of the roots with it.
    roots_of: HashMap<Symbol, Vec<usize>>,
}

impl<'d> Uses<'d> {
    pub(crate) fn new(
        graph: &Graph,
        definitions: &'d [(Symbol, Expr)],
        roots: &'d [Expr],
        known: &Known,
    ) -> Self {
        let mut definitions_of: HashMap<Symbol, Vec<usize>> = HashMap::new();
        for (position, (symbol, value)) in definitions.iter().enumerate() {
            let uses: Vec<Symbol> = match known.get(symbol) {
                Some(partials) => partials.keys().copied().collect(),
                None => graph.symbols_in(&[*value]),
            };
            for used in uses {
                definitions_of.entry(used).or_default().push(position);
            }
        }
        let mut roots_of: HashMap<Symbol, Vec<usize>> = HashMap::new();
        for (position, root) in roots.iter().enumerate() {
            for used in graph.symbols_in(&[*root]) {
                roots_of.entry(used).or_default().push(position);
            }
        }
        Self {
            definitions,
            roots,
            definitions_of,
            roots_of,
        }
    }
}

/// Derivatives of the roots by `variable`, with all other given quantities held: those that may
/// not be zero, by the root's position. Definitions of derivatives are appended to `derived`.
pub(crate) fn derivatives(
    graph: &mut Graph,
    uses: &Uses<'_>,
    variable: Symbol,
    known: &Known,
    derived: &mut Vec<(Symbol, Expr)>,
) -> Vec<(usize, Expr)> {
    let one = graph.one();
    let mut rates = Rates::from([(variable, one)]);
    let users = |symbol: Symbol| uses.definitions_of.get(&symbol).into_iter().flatten();
    let roots_with = |symbol: Symbol| uses.roots_of.get(&symbol).into_iter().flatten();
    let mut waiting: BTreeSet<usize> = users(variable).copied().collect();
    let mut moved: BTreeSet<usize> = roots_with(variable).copied().collect();
    // A definition comes after what it uses, so the first one waiting is ready.
    while let Some(position) = waiting.pop_first() {
        let (symbol, value) = uses.definitions[position];
        if let Some(partials) = known.get(&symbol) {
            if let Some(&partial) = partials.get(&variable) {
                rates.insert(symbol, partial);
                waiting.extend(users(symbol));
                moved.extend(roots_with(symbol));
            }
            continue;
        }
        let derivative = graph.derivative(value, &rates);
        if graph.is_zero(derivative) {
            continue;
        }
        let rate = match graph.node(derivative) {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => derivative,
            Node::Sum { .. } | Node::Product { .. } | Node::Function(..) => {
                let text = format!(
                    "∂{}/∂{}",
                    graph.symbol_text(symbol),
                    graph.symbol_text(variable)
                );
                let latex = format!(
                    "\\partial {}/\\partial {}",
                    graph.symbol_latex(symbol),
                    graph.symbol_latex(variable)
                );
                let named = graph.symbol(text, latex);
                derived.push((named, derivative));
                graph.of(named)
            }
        };
        rates.insert(symbol, rate);
        waiting.extend(users(symbol));
        moved.extend(roots_with(symbol));
    }
    let roots: Vec<Expr> = moved.iter().map(|&position| uses.roots[position]).collect();
    let values = graph.derivatives(&roots, &rates);
    moved.into_iter().zip(values).collect()
}
