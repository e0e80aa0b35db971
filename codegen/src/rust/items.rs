//! Types, tables and texts of a generated module.

use flexure_runtime::diagnostic::Site;
use flexure_runtime::failure::Unit;
use flexure_runtime::system::{Causality, Variable};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::body::{Writer, table_name};
use super::configuration;
use super::curve;
use super::expression::{ident, literal, unsuffixed};
use crate::names::Namer;
use crate::program::{Message, Program};
use crate::schedule::prepared_compiled;

/// Functions of `Params` that a set's name must leave alone.
pub(super) const METHODS: [&str; 4] = ["default", "from_values", "prepare", "values"];

/// `Params` with its defaults and sets; `prepare` comes from elsewhere.
pub(super) fn params(writer: &Writer<'_>, prepare: &[TokenStream]) -> TokenStream {
    let program = writer.program;
    let fields: Vec<_> = writer.params.iter().map(|name| ident(name)).collect();
    let docs = program.params.iter().map(|param| {
        let unit = in_unit(&param.unit);
        let default = literal(param.start.unwrap_or(f64::NAN)).to_string();
        let words = match plain(&param.meaning) {
            words if words.is_empty() => format!("`{}`", code(&param.name)),
            words => words,
        };
        format!(" {words}{unit}; {} by default", default.replace(' ', ""))
    });
    let defaults = program
        .params
        .iter()
        .map(|param| literal(param.start.unwrap_or(f64::NAN)));
    let mut namer = Namer::without(&METHODS);
    let sets = program.sets.iter().map(|set| {
        let name = ident(&namer.name(&set.name));
        let doc = format!(
            " The set `{}`: its values, all others by default.{}",
            code(&set.name),
            sentence(&set.doc)
        );
        let assigned = set.values.iter().map(|(position, value)| {
            let field = &fields[*position];
            let value = literal(*value);
            quote!(#field: #value)
        });
        // A set may name every param, and then nothing is left to its default.
        let rest = (set.values.len() < fields.len()).then(|| quote!(..Self::default()));
        quote! {
            #[doc = #doc]
            pub fn #name() -> Self {
                Self { #(#assigned,)* #rest }
            }
        }
    });
    let count = unsuffixed(fields.len());
    let positions = (0..fields.len()).map(unsuffixed);
    quote! {
        /// What may be set: all in SI units, angles in rad.
        #[derive(Clone, Debug, PartialEq)]
        pub struct Params {
            #(#[doc = #docs] pub #fields: f64,)*
        }

        impl Default for Params {
            fn default() -> Self {
                Self { #(#fields: #defaults,)* }
            }
        }

        impl Params {
            #(#sets)*

            /// The values in the order of [`VARIABLES`].
            pub fn values(&self) -> [f64; #count] {
                [#(self.#fields),*]
            }

            /// Params of values in the order of [`VARIABLES`].
            pub fn from_values(values: [f64; #count]) -> Self {

                Self { #(#fields: values[#positions]),* }
            }

            /// Closes the loops and computes everything that depends on params alone.
            ///
            /// # Errors
            /// What is wrong with the parameter set, in the words of `flexure check`.
            pub fn prepare(&self) -> Result<Prepared<f64>, Diagnostic> {
                check_params(PARAMS, &self.values())?;
                #(#prepare)*
            }
        }
    }
}

/// `Prepared<T>`.
pub(super) fn prepared_type(writer: &Writer<'_>) -> TokenStream {
    let program = writer.program;
    let [n, d] = [program.states.len(), program.discretes.len()].map(unsuffixed);
    let values = prepared_compiled(program);
    let fields: Vec<_> = values
        .iter()
        .map(|value| ident(&writer.fields[value]))
        .collect();
    let docs = values.iter().map(|value| {
        let name = program.names.get(value);
        let meaning = name.map_or("", |name| &name.meaning);
        let text = name.map_or_else(
            || crate::listing::expression(program, *value),
            |name| name.text.clone(),
        );
        format!(" `{}`{}", code(&text), sentence(meaning))
    });
    let tables = configuration::fields(program);
    let mapped = configuration::mapped(program);
    let zipped = configuration::zipped(program);
    let (curves, no_curves) = (curve::fields(writer), curve::none(writer));
    let exact = if program.configurations.is_empty() && no_curves.is_empty() {
        quote!(self)
    } else {
        let none = configuration::no_tables(program);
        quote!(Self { #none #no_curves ..self })
    };
    quote! {
        /// Everything that depends on params alone, as the functions of this module need it.
        #[derive(Clone, Debug)]
        pub struct Prepared<T> {
            /// Continuous state at the start.
            pub start_states: [T; #n],
            /// Discrete state at the start.
            pub start_discretes: [T; #d],
            #(#[doc = #docs] pub #fields: T,)*
            #tables
            #curves
        }

        impl<T: Copy> Prepared<T> {
            /// The same with every number turned into another, without curves: for dual numbers or lanes.
            pub fn map<U>(&self, turn: impl Fn(T) -> U) -> Prepared<U> {
                Prepared {
                    start_states: self.start_states.map(&turn),
                    start_discretes: self.start_discretes.map(&turn),
                    #(#fields: turn(self.#fields),)*
                    #mapped
                    #no_curves
                }
            }

            /// Every number joined with the one that stands in its place in `other`.
            pub fn zip<U: Copy, V>(
                &self,
                other: &Prepared<U>,
                join: impl Fn(T, U) -> V,
            ) -> Prepared<V> {
                Prepared {
                    start_states: std::array::from_fn(|i| {
                        join(self.start_states[i], other.start_states[i])
                    }),
                    start_discretes: std::array::from_fn(|i| {
                        join(self.start_discretes[i], other.start_discretes[i])
                    }),
                    #(#fields: join(self.#fields, other.#fields),)*
                    #zipped
                    #no_curves
                }
            }
        }

        impl Prepared<f64> {
            /// The same without tables and curves: closed forms everywhere.
            pub fn exact(self) -> Self {
                #exact
            }
        }
    }
}

/// Tables and texts.
pub(super) fn tables(
    program: &Program,
    messages: &[Message],
    equations: &str,
    latex: &str,
) -> TokenStream {
    let groups = [
        &program.params,
        &program.states,
        &program.discretes,
        &program.inputs,
        &program.outputs,
    ];
    let rows: Vec<TokenStream> = groups
        .iter()
        .flat_map(|rows| rows.iter())
        .map(row)
        .collect();
    let count = unsuffixed(rows.len());
    let statics = ["PARAMS", "STATES", "DISCRETES", "INPUTS", "OUTPUTS"]
        .into_iter()
        .zip(groups)
        .scan(0, |start, (name, rows)| {
            let name = ident(name);
            let from = unsuffixed(*start);
            *start += rows.len();
            let length = unsuffixed(rows.len());
            Some(quote! {
                static #name: &[Variable] = VARIABLES.split_at(#from).1.split_at(#length).0;
            })
        });
    let tables = program.tables.iter().enumerate().map(|(index, table)| {
        let name = ident(&table_name(index));
        let entries = table.iter().map(|entry| literal(*entry));
        let length = unsuffixed(table.len());
        quote!(static #name: [f64; #length] = [#(#entries),*];)
    });
    let failures = messages.iter().map(failure);
    let failure_count = unsuffixed(messages.len());
    let turning = program.turning.iter().map(|index| unsuffixed(*index));
    let coordinates = program.coordinates().into_iter().map(|(coordinate, rate)| {
        let [coordinate, rate] = [coordinate, rate].map(unsuffixed);
        quote!((#coordinate, #rate))
    });
    let coordinate_count = unsuffixed(coordinates.len());
    let coordinates = (!program.configurations.is_empty()).then(|| {
        quote! {
            /// Positions of the coordinates and of their rates among the states.
            static COORDINATES: [(usize, usize); #coordinate_count] = [#(#coordinates),*];
        }
    });
    let turning_count = unsuffixed(program.turning.len());
    let equations = text(equations);
    let latex = text(latex);
    quote! {
        /// Every quantity with a name: params, states, discrete states, inputs, outputs.
        pub static VARIABLES: [Variable; #count] = [#(#rows),*];
        #(#statics)*
        #coordinates
        static TURNING: [usize; #turning_count] = [#(#turning),*];
        static FAILURES: [Failure; #failure_count] = [#(#failures),*];
        #(#tables)*

        /// The equations of motion in plain text.
        pub const EQUATIONS: &str = #equations;
        /// The equations of motion as a LaTeX document.
        pub const EQUATIONS_LATEX: &str = #latex;
    }
}

fn row(variable: &Variable) -> TokenStream {
    let [name, unit, meaning] =
        [&variable.name, &variable.unit, &variable.meaning].map(|text| text.as_ref());
    let causality = match variable.causality {
        Causality::Parameter => quote!(Parameter),
        Causality::Input => quote!(Input),
        Causality::State => quote!(State),
        Causality::Discrete => quote!(Discrete),
        Causality::Output => quote!(Output),
    };
    let start = match variable.start {
        Some(start) => {
            let start = literal(start);
            quote!(Some(#start))
        }
        None => quote!(None),
    };
    quote! {
        Variable {
            name: Cow::Borrowed(#name),
            unit: Cow::Borrowed(#unit),
            meaning: Cow::Borrowed(#meaning),
            causality: Causality::#causality,
            start: #start,
        }
    }
}

fn failure(message: &Message) -> TokenStream {
    let failure = &message.failure;
    let text = failure.message.as_ref();
    let hint = match &failure.hint {
        Some(hint) => {
            let hint = hint.as_ref();
            quote!(Some(Cow::Borrowed(#hint)))
        }
        None => quote!(None),
    };
    let site = match &failure.site {
        Some(place) => {
            let place = place_of(place);
            quote!(Some(#place))
        }
        None => quote!(None),
    };
    let related = failure.related.iter().map(|(place, label)| {
        let (place, label) = (place_of(place), label.as_ref());
        quote!((#place, Cow::Borrowed(#label)))
    });
    let units = failure.units.iter().map(|unit| match unit {
        Unit::Number => quote!(Unit::Number),
        Unit::Degree => quote!(Unit::Degree),
        Unit::Metre => quote!(Unit::Metre),
        Unit::Other(symbol) => quote!(Unit::Other(#symbol)),
    });
    quote! {
        Failure {
            message: Cow::Borrowed(#text),
            hint: #hint,
            site: #site,
            related: Cow::Borrowed(&[#(#related),*]),
            units: Cow::Borrowed(&[#(#units),*]),
        }
    }
}

fn place_of(site: &Site) -> TokenStream {
    let (file, excerpt) = (site.file.as_ref(), site.excerpt.as_ref());
    let [line, column, width] = [site.line, site.column, site.width].map(unsuffixed);
    quote! {
        Site {
            file: Cow::Borrowed(#file),
            line: #line,
            column: #column,
            width: #width,
            excerpt: Cow::Borrowed(#excerpt),
        }
    }
}

/// A text of several lines, as a raw string where that is possible.
pub(super) fn text(text: &str) -> TokenStream {
    let mut hashes = "#".to_owned();
    while text.contains(&format!("\"{hashes}")) {
        hashes.push('#');
    }
    let is_simple = text
        .chars()
        .all(|character| character == '\n' || !character.is_control());
    let raw: Option<Literal> = (is_simple && hashes.len() < 200)
        .then(|| format!("r{hashes}\"{text}\"{hashes}").parse().ok())
        .flatten();
    match raw {
        Some(raw) => quote!(#raw),
        None => quote!(#text),
    }
}

/// Words of a user's in documentation: one line, with nothing that rustdoc would interpret.
pub(super) fn plain(words: &str) -> String {
    let mut text = String::with_capacity(words.len());
    for word in words.split_whitespace() {
        if !text.is_empty() {
            text.push(' ');
        }
        for character in word.chars().filter(|c| !c.is_control()) {
            if "\\`*[]<>#&|".contains(character) {
                text.push('\\');
            }
            text.push(character);
        }
    }
    text
}

/// A name or formula between backticks.
fn code(words: &str) -> String {
    let words: String = words
        .chars()
        .filter(|c| !c.is_control())
        .map(|c| if c == '`' { '\'' } else { c })
        .collect();
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn sentence(words: &str) -> String {
    let words = plain(words);
    if words.is_empty() {
        String::new()
    } else {
        format!(" {words}")
    }
}

fn in_unit(unit: &str) -> String {
    if unit.is_empty() || unit == "1" {
        String::new()
    } else {
        format!(" in {}", plain(unit))
    }
}
