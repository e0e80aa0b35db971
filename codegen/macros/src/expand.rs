//! Expansions: the module and the files that it depends on, or one error and a skeleton.

use std::cell::RefCell;
use std::path::{Path, PathBuf};

use flexure_codegen::{Texts, program, report, rust, skeleton};
use flexure_model_dsl::compile;
use flexure_model_dsl::source::Source;
use proc_macro2::{Span, TokenStream};
use quote::{quote, quote_spanned};

use crate::guess;
use crate::input::Input;

/// `include_model!`
pub(crate) fn include_model(tokens: TokenStream) -> TokenStream {
    let input: Input = match syn::parse2(tokens) {
        Ok(input) => input,
        Err(error) => return error.into_compile_error(),
    };
    let root = root();
    let written = input.text.value();
    let path = root.join(&written);
    match std::fs::read_to_string(&path) {
        Ok(text) => {
            let folder = path.parent().unwrap_or(&root).to_owned();
            let stem = path.file_stem().map(|stem| stem.to_string_lossy());
            let fallback = stem.unwrap_or_default().into_owned();
            let source = Source::new(written, text);
            expand(source, &input, &fallback, &folder, vec![path])
        }
        Err(error) => {
            let stem = Path::new(&written).file_stem();
            let name = stem.map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
            let message = format!(
                "model file `{written}` cannot be read: {error}\n = hint: the path is relative to \
                 the root of the crate, where its Cargo.toml is"
            );
            let error = compile_error(&message, input.text.span());
            let skeleton = skeleton(&name, &[], &[], &input.runtime);
            quote!(#error #skeleton)
        }
    }
}

/// `model!`
pub(crate) fn model(tokens: TokenStream) -> TokenStream {
    let input: Input = match syn::parse2(tokens) {
        Ok(input) => input,
        Err(error) => return error.into_compile_error(),
    };
    let source = inline_source(&input);
    expand(source, &input, "model", &root(), Vec::new())
}

/// The root of the crate in which the macro stands.
fn root() -> PathBuf {
    std::env::var_os("CARGO_MANIFEST_DIR")
        .map(PathBuf::from)
        .unwrap_or_default()
}

/// A model in a string literal, placed so that its lines count as those of the Rust file.
fn inline_source(input: &Input) -> Source {
    let text = input.text.value();
    let is_raw = input.text.token().to_string().starts_with('r');
    let span = input.text.span().unwrap();
    if is_raw {
        // Lines before the literal are left blank.
        let before = "\n".repeat(span.line().saturating_sub(1));
        Source::new(span.file(), before + &text)
    } else {
        Source::new("the model in `model!`", text)
    }
}

fn expand(
    source: Source,
    input: &Input,
    fallback: &str,
    folder: &Path,
    used: Vec<PathBuf>,
) -> TokenStream {
    let used = RefCell::new(used);
    let read = |file: &str| -> Result<String, String> {
        let path = folder.join(file);
        let text = std::fs::read_to_string(&path).map_err(|error| error.to_string())?;
        used.borrow_mut().push(path);
        Ok(text)
    };
    let name = guess::name(&source.text).unwrap_or_else(|| fallback.to_owned());
    let params = guess::params(&source.text);
    let sets = guess::sets(&source.text);
    let module = match compile(source, &read) {
        Ok((equations, _)) => {
            let texts = Texts {
                equations: &report::text(&equations),
                latex: &report::latex(&equations),
            };
            rust(&program(&equations), texts, &input.runtime)
        }
        Err(diagnostics) => {
            let texts: Vec<String> = diagnostics.iter().map(ToString::to_string).collect();
            let message = texts.join("\n\n");
            // The compiler writes the first `error:` itself.
            let message = message.strip_prefix("error: ").unwrap_or(&message);
            let error = compile_error(message, input.text.span());
            let skeleton = skeleton(&name, &params, &sets, &input.runtime);
            quote!(#error #skeleton)
        }
    };
    let files = used.into_inner();
    let files = files.iter().map(|path| path.to_string_lossy());
    quote! {
        #module
        #(const _: &[u8] = ::core::include_bytes!(#files);)*
    }
}

fn compile_error(message: &str, span: Span) -> TokenStream {
    quote_spanned!(span=> ::core::compile_error!(#message);)
}
