//! Order: definitions each after what it uses, and nothing that depends on itself.

use std::collections::HashMap;

use crate::equations::Definition;
use crate::symbolic::{Graph, Symbol};

/// Sorts definitions; the given order is kept where dependencies allow.
///
/// # Errors
/// The symbols of a cycle, in order.
pub(crate) fn sorted(
    graph: &Graph,
    definitions: Vec<Definition>,
) -> Result<Vec<Definition>, Vec<Symbol>> {
    let mut owner: HashMap<Symbol, usize> = HashMap::new();
    for (index, definition) in definitions.iter().enumerate() {
        match definition {
            Definition::Value { symbol, .. } => {
                owner.insert(*symbol, index);
            }
            Definition::Solve(solve) => {
                for symbol in &solve.unknowns {
                    owner.insert(*symbol, index);
                }
            }
        }
    }
    let needs: Vec<Vec<usize>> = definitions
        .iter()
        .enumerate()
        .map(|(index, definition)| {
            let roots = match definition {
                Definition::Value { value, .. } => vec![*value],
                Definition::Solve(solve) => {
                    let mut roots = solve.residuals.clone();
                    roots.extend(&solve.guesses);
                    roots.extend(&solve.scales);
                    roots.extend(solve.definitions.iter().map(|(_, value)| *value));
                    roots
                }
            };
            let inner = matches!(definition, Definition::Solve(_));
            graph
                .symbols_in(&roots)
                .into_iter()
                .filter_map(|symbol| owner.get(&symbol).copied())
                .filter(|&needed| !(inner && needed == index))
                .collect()
        })
        .collect();

    const NEW: u8 = 0;
    const OPEN: u8 = 1;
    const DONE: u8 = 2;
    let mut state = vec![NEW; definitions.len()];
    let mut order = Vec::with_capacity(definitions.len());
    for root in 0..definitions.len() {
        let mut stack = vec![(root, 0)];
        while let Some((at, next)) = stack.pop() {
            if next == 0 {
                if state[at] == DONE {
                    continue;
                }
                if state[at] == OPEN {
                    let from = stack
                        .iter()
                        .position(|(index, _)| *index == at)
                        .unwrap_or(0);
                    let cycle = stack[from..]
                        .iter()
                        .map(|(index, _)| *index)
                        .collect::<Vec<_>>();
                    return Err(cycle
                        .into_iter()
                        .map(|index| symbol_of(&definitions[index]))
                        .collect());
                }
                state[at] = OPEN;
            }
            if let Some(&needed) = needs[at].get(next) {
                stack.push((at, next + 1));
                stack.push((needed, 0));
            } else if state[at] != DONE {
                state[at] = DONE;
                order.push(at);
            }
        }
    }
    let mut slots: Vec<Option<Definition>> = definitions.into_iter().map(Some).collect();
    Ok(order
        .into_iter()
        .filter_map(|index| slots[index].take())
        .collect())
}

fn symbol_of(definition: &Definition) -> Symbol {
    match definition {
        Definition::Value { symbol, .. } => *symbol,
        Definition::Solve(solve) => solve.unknowns[0],
    }
}
