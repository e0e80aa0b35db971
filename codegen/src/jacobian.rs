//! Derivatives through definitions.
//!
//! Each definition that changes with the variable gets a definition of its derivative, so that the
//! graph grows by about its own size per variable instead of being written out.

use std::collections::HashMap;

use flexure_model_dsl::symbolic::{Expr, Graph, Node, Rates, Symbol};

/// Derivatives that are known without differentiating a definition: by defined symbol, for each
/// variable of which it depends.
pub(crate) type Known = HashMap<Symbol, HashMap<Symbol, Expr>>;

/// Derivatives of `roots` by `variable`, with all other given quantities held. `definitions` come
/// each after what it uses; definitions of derivatives are appended to `derived`.
pub(crate) fn derivatives(
    graph: &mut Graph,
    definitions: &[(Symbol, Expr)],
    roots: &[Expr],
    variable: Symbol,
    known: &Known,
    derived: &mut Vec<(Symbol, Expr)>,
) -> Vec<Expr> {
    let one = graph.one();
    let mut rates = Rates::from([(variable, one)]);
    for &(symbol, value) in definitions {
        if let Some(partials) = known.get(&symbol) {
            if let Some(&partial) = partials.get(&variable) {
                rates.insert(symbol, partial);
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
    }
    graph.derivatives(roots, &rates)
}
