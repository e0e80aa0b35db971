//! Long functions in blocks.
//!
//! Each `let` opens a scope within the scope of the one before, and the Rust compiler walks scopes
//! recursively when it writes debug information: some four thousand overflow a thread of 2 MB. So
//! long bodies are cut into blocks that give what is used after them:
//!
//! ```text
//! let (cos_θ, x_1_2) = { …; (cos_θ, x_1_2) };
//! ```

use std::collections::{HashMap, HashSet};

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::quote;

use super::expression::ident;

/// Most statements of one scope.
const LONGEST: usize = 500;

/// The statements as they are if they are few, else in blocks, cut where the fewest names go on.
pub(super) fn in_blocks(statements: Vec<TokenStream>) -> Vec<TokenStream> {
    if statements.len() <= LONGEST {
        return statements;
    }
    let last_uses = last_uses(&statements);
    let bound: Vec<Vec<String>> = statements.iter().cloned().map(bound).collect();
    let mut blocks = Vec::new();
    let mut start = 0;
    while start < statements.len() {
        let end = cut(start, &bound, &last_uses);
        let block = &statements[start..end];
        let given: Vec<_> = bound[start..end]
            .iter()
            .flatten()
            .filter(|name| last_uses[name.as_str()] >= end)
            .map(|name| ident(name))
            .collect();
        blocks.push(if given.is_empty() {
            quote!({ #(#block)* })
        } else {
            quote!(let (#(#given),*,) = { #(#block)* (#(#given),*,) };)
        });
        start = end;
    }
    blocks
}

/// Where a block from `start` ends: in its second half, after which the fewest of its names are used.
fn cut(start: usize, bound: &[Vec<String>], last_uses: &HashMap<String, usize>) -> usize {
    if bound.len() - start <= LONGEST {
        return bound.len();
    }
    // By how many the names in use change from one statement to the next.
    let mut changes = vec![0i64; LONGEST + 2];
    for (position, names) in bound[start..start + LONGEST].iter().enumerate() {
        for name in names {
            changes[position + 1] += 1;
            let after = last_uses[name] - start + 1;
            changes[after.min(LONGEST + 1)] -= 1;
        }
    }
    let mut in_use = 0;
    let mut best = (i64::MAX, LONGEST);
    for (position, change) in changes.into_iter().enumerate().take(LONGEST + 1) {
        in_use += change;
        if position > LONGEST / 2 && in_use <= best.0 {
            best = (in_use, position);
        }
    }
    start + best.1
}

/// For each name the last statement with it.
fn last_uses(statements: &[TokenStream]) -> HashMap<String, usize> {
    let mut last = HashMap::new();
    for (position, statement) in statements.iter().enumerate() {
        let mut used = HashSet::new();
        names(statement.clone(), &mut used);
        last.extend(used.into_iter().map(|name| (name, position)));
    }
    last
}

/// The names that a `let` binds.
fn bound(statement: TokenStream) -> Vec<String> {
    let mut trees = statement
        .into_iter()
        .skip_while(|tree| !matches!(tree, TokenTree::Ident(word) if word == "let"))
        .skip(1);
    match trees.next() {
        Some(TokenTree::Ident(name)) => vec![name.to_string()],
        // A tuple or an array of names.
        Some(TokenTree::Group(group)) if group.delimiter() != Delimiter::Brace => {
            let names = group.stream().into_iter().filter_map(|tree| match tree {
                TokenTree::Ident(name) => Some(name.to_string()),
                _ => None,
            });
            names.collect()
        }
        _ => Vec::new(),
    }
}

/// All names in a statement.
fn names(statement: TokenStream, found: &mut HashSet<String>) {
    for tree in statement {
        match tree {
            TokenTree::Ident(name) => {
                found.insert(name.to_string());
            }
            TokenTree::Group(group) => names(group.stream(), found),
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_give_what_is_used_after_them() {
        let mut statements: Vec<TokenStream> = vec![
            quote!(let [a] = p.table.values(x);),
            quote!(let (b, d) = x.sin_cos();),
        ];
        statements.extend((2..LONGEST - 9).map(|_| quote!(let f = d;)));
        statements.push(quote!(let c = 1.0;));
        statements.extend((0..9).map(|_| quote!(let e = c;)));
        statements.push(quote!(dx[0] = a * b * e;));
        let blocks = in_blocks(statements);
        assert_eq!(blocks.len(), 2);
        let [first, second] = [0, 1].map(|block| blocks[block].to_string());
        assert!(first.starts_with("let (a , b ,) = { let [a] = p"));
        assert!(first.ends_with("let f = d ; (a , b ,) } ;"));
        assert!(second.starts_with("{ let c = 1.0 ; let e = c ;"));
    }

    #[test]
    fn short_bodies_stay_as_they_are() {
        let statements = vec![quote!(let a = b;), quote!(dx[0] = a;)];
        assert_eq!(in_blocks(statements).len(), 2);
    }
}
