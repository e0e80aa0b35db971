//! What the macros are given: a path, a comma, a string.

use proc_macro2::{TokenStream, TokenTree};
use syn::parse::{Parse, ParseStream};
use syn::{LitStr, Token};

/// Arguments of either macro.
pub(crate) struct Input {
    /// Path of the runtime crate.
    pub(crate) runtime: TokenStream,
    /// A file's path, or a model.
    pub(crate) text: LitStr,
}

impl Parse for Input {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let mut runtime = TokenStream::new();
        // `$crate` is no path to a parser, so that its tokens are taken as they come.
        while !input.peek(Token![,]) && !input.is_empty() {
            runtime.extend([input.parse::<TokenTree>()?]);
        }
        input.parse::<Token![,]>()?;
        let text = input.parse()?;
        input.parse::<Option<Token![,]>>()?;
        if !input.is_empty() {
            return Err(input.error("one string is expected: a model file's path, or a model"));
        }
        Ok(Self { runtime, text })
    }
}
