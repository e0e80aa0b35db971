//! What is done on the graph before values are made of it: derivatives, and sines from geometry.

use std::collections::HashMap;

use flexure_model_dsl::equations::{self, Definition, Equations};
use flexure_model_dsl::symbolic::{Expr, Graph, Symbol};

use crate::directions::{Identities, identities};
use crate::jacobian::{Known, Uses, derivatives};

/// What is done on the graph before values are made of it.
pub(crate) struct Symbolic {
    /// Every definition, those of derivatives and of sines and cosines included.
    pub(crate) definitions: Vec<(Symbol, Expr)>,
    /// The equations' words on defined symbols.
    pub(crate) meanings: HashMap<Symbol, String>,
    /// Sines and cosines to compute otherwise.
    pub(crate) replacements: HashMap<Expr, Expr>,
    /// Row, column and value of what is not zero in ∂rates/∂states.
    pub(crate) jacobian: Vec<(usize, usize, Expr)>,
    /// For each Newton block its Jacobian, row by row.
    pub(crate) solve_jacobians: Vec<Vec<Expr>>,
    /// Everything that is computed.
    pub(crate) roots: Vec<Expr>,
}

impl Symbolic {
    pub(crate) fn new(equations: &Equations, graph: &mut Graph) -> Self {
        let mut definitions: Vec<(Symbol, Expr)> = Vec::new();
        let mut meanings = HashMap::new();
        for definition in &equations.definitions {
            match definition {
                Definition::Value {
                    symbol,
                    value,
                    meaning,
                } => {
                    definitions.push((*symbol, *value));
                    meanings.insert(*symbol, meaning.clone());
                }
                Definition::Solve(solve) => definitions.extend(&solve.definitions),
            }
        }
        let mut known = Known::new();
        for partial in &equations.partials {
            let partials = known.entry(partial.symbol).or_default();
            partials.insert(partial.state, partial.value);
        }
        let mut derived = Vec::new();
        let mut jacobian = Vec::new();
        let rates: Vec<Expr> = equations.states.iter().map(|state| state.rate).collect();
        let relevant = relevant(graph, &definitions, &rates);
        let uses = Uses::new(graph, &relevant, &rates, &known);
        for (column, state) in equations.states.iter().enumerate() {
            for (row, value) in derivatives(graph, &uses, state.symbol, &known, &mut derived) {
                if !graph.is_zero(value) {
                    jacobian.push((row, column, value));
                }
            }
        }
        jacobian.sort_by_key(|(row, column, _)| (*row, *column));
        let mut solve_jacobians = Vec::new();
        for definition in &equations.definitions {
            if let Definition::Solve(solve) = definition {
                solve_jacobians.push(solve_jacobian(graph, solve, &mut derived));
            }
        }
        definitions.extend(derived);

        let mut roots = roots(equations);
        roots.extend(jacobian.iter().map(|(_, _, value)| *value));
        roots.extend(solve_jacobians.iter().flatten());
        roots.extend(definitions.iter().map(|(_, value)| *value));
        let fixed = fixed_symbols(graph, equations, &definitions);
        let Identities {
            replacements,
            definitions: found,
        } = identities(graph, &roots, &equations.directions, &fixed);
        roots.extend(found.iter().map(|(_, value)| *value));
        definitions.extend(found);
        Self {
            definitions,
            meanings,
            replacements,
            jacobian,
            solve_jacobians,
            roots,
        }
    }
}

/// Those of `definitions` that `roots` use, directly or not.
fn relevant(graph: &Graph, definitions: &[(Symbol, Expr)], roots: &[Expr]) -> Vec<(Symbol, Expr)> {
    let mut used = vec![false; graph.symbol_count()];
    for symbol in graph.symbols_in(roots) {
        used[symbol.index()] = true;
    }
    let mut relevant = Vec::new();
    for &(symbol, value) in definitions.iter().rev() {
        if used[symbol.index()] {
            for inner in graph.symbols_in(&[value]) {
                used[inner.index()] = true;
            }
            relevant.push((symbol, value));
        }
    }
    relevant.reverse();
    relevant
}

fn solve_jacobian(
    graph: &mut Graph,
    solve: &equations::Solve,
    derived: &mut Vec<(Symbol, Expr)>,
) -> Vec<Expr> {
    let known = Known::new();
    let uses = Uses::new(graph, &solve.definitions, &solve.residuals, &known);
    let zero = graph.zero();
    let columns: Vec<Vec<Expr>> = solve
        .unknowns
        .iter()
        .map(|unknown| {
            let mut column = vec![zero; solve.residuals.len()];
            for (row, value) in derivatives(graph, &uses, *unknown, &known, derived) {
                column[row] = value;
            }
            column
        })
        .collect();
    (0..solve.residuals.len())
        .flat_map(|row| columns.iter().map(move |column| column[row]))
        .collect()
}

/// Every expression that the equations compute, definitions apart.
fn roots(equations: &Equations) -> Vec<Expr> {
    let mut roots = Vec::new();
    for definition in &equations.definitions {
        if let Definition::Solve(solve) = definition {
            roots.extend(&solve.guesses);
            roots.extend(&solve.residuals);
            roots.extend(&solve.scales);
            roots.extend(solve.failure.values.iter().map(|shown| shown.value));
        }
    }
    roots.extend(equations.partials.iter().map(|partial| partial.value));
    for direction in &equations.directions {
        roots.extend([direction.cos, direction.sin]);
    }
    for state in &equations.states {
        roots.extend([state.initial, state.rate]);
    }
    for discrete in &equations.discretes {
        roots.push(discrete.initial);
        roots.extend(discrete.accepted);
    }
    for kink in &equations.kinks {
        roots.push(kink.next);
        roots.extend(kink.updates.iter().map(|(_, value)| *value));
    }
    for event in &equations.events {
        roots.push(event.function);
        let updates = event.state_updates.iter().chain(&event.discrete_updates);
        roots.extend(updates.map(|(_, value)| *value));
    }
    roots.extend(equations.outputs.iter().map(|output| output.value));
    let energy = &equations.energy;
    roots.extend([
        energy.kinetic,
        energy.potential,
        energy.dissipated_power,
        energy.supplied_power,
    ]);
    roots.extend(equations.loops.iter().map(|l| l.closure));
    for check in &equations.checks {
        roots.push(check.margin);
        roots.extend(check.failure.values.iter().map(|shown| shown.value));
    }
    roots
}

/// For each symbol of the graph, by its position, whether it depends on params alone.
fn fixed_symbols(
    graph: &Graph,
    equations: &Equations,
    definitions: &[(Symbol, Expr)],
) -> Vec<bool> {
    let mut fixed = vec![false; graph.symbol_count()];
    for param in &equations.params {
        fixed[param.symbol.index()] = true;
    }
    for definition in &equations.definitions {
        if let Definition::Solve(solve) = definition {
            for unknown in &solve.unknowns {
                fixed[unknown.index()] = true;
            }
        }
    }
    for (symbol, value) in definitions {
        fixed[symbol.index()] = graph
            .symbols_in(&[*value])
            .iter()
            .all(|inner| fixed[inner.index()]);
    }
    fixed
}
