//! The procedural macros behind `flexure::include_model!` and `flexure::model!`.
//!
//! ```text
//! runtime path, model file ──▶ Equations ──▶ Program ──▶ a module named after the model
//!                                   └──▶ compile_error! with the compiler's own text, and a skeleton
//! ```
//!
//! Both take the path of the runtime crate first, because only the crate that hands them on knows
//! under which name it is known: `flexure` passes `$crate::runtime`. The expansion mentions every
//! file that it was made of, so that cargo rebuilds when one changes.

mod expand;
mod guess;
mod input;

use proc_macro::TokenStream;

/// A module that simulates the model of a file: `include_model!(runtime::path, "model.flex")`, with
/// the file's path relative to the root of the crate in which it stands.
#[proc_macro]
pub fn include_model(tokens: TokenStream) -> TokenStream {
    expand::include_model(tokens.into()).into()
}

/// A module that simulates a model written in place: `model!(runtime::path, r#"model …"#)`.
#[proc_macro]
pub fn model(tokens: TokenStream) -> TokenStream {
    expand::model(tokens.into()).into()
}
