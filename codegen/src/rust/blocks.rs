//! Long functions in blocks.
//!
//! Each `let` opens a scope within the scope of the one before, and the Rust compiler walks scopes
//! recursively when it writes debug information: some five thousand of them overflow its stack. So
//! long bodies are cut into blocks that give what is used after them:
//!
//! ```text
//! let (cos_θ, x_1_2) = { …; (cos_θ, x_1_2) };
//! ```

use std::collections::HashSet;

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::quote;

use super::expression::ident;

/// Statements of one scope.
const LONGEST: usize = 2000;

/// The statements as they are if they are few, else in blocks.
pub(super) fn in_blocks(statements: Vec<TokenStream>) -> Vec<TokenStream> {
    if statements.len() <= LONGEST {
        return statements;
    }
    let mut blocks = Vec::new();
    let mut used_later = HashSet::new();
    for block in statements.chunks(LONGEST).rev() {
        let given: Vec<_> = block
            .iter()
            .flat_map(|statement| bound(statement.clone()))
            .filter(|name| used_later.contains(name))
            .map(|name| ident(&name))
            .collect();
        for statement in block {
            names(statement.clone(), &mut used_later);
        }
        blocks.push(if given.is_empty() {
            quote!({ #(#block)* })
        } else {
            quote!(let (#(#given),*,) = { #(#block)* (#(#given),*,) };)
        });
    }
    blocks.reverse();
    blocks
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
            quote!(let [e] = p.table.values(x);),
            quote!(let (a, b) = x.sin_cos();),
        ];
        statements.extend((2..LONGEST).map(|_| quote!(let c = a;)));
        statements.push(quote!(dx[0] = b * a + e;));
        let blocks = in_blocks(statements);
        assert_eq!(blocks.len(), 2);
        let first = blocks[0].to_string();
        assert!(first.starts_with("let (e , a , b ,) = { let [e] = p . table . values (x) ; let"));
        assert!(first.ends_with("let c = a ; (e , a , b ,) } ;"));
        assert_eq!(blocks[1].to_string(), "{ dx [0] = b * a + e ; }");
    }

    #[test]
    fn short_bodies_stay_as_they_are() {
        let statements = vec![quote!(let a = b;), quote!(dx[0] = a;)];
        assert_eq!(in_blocks(statements).len(), 2);
    }
}
