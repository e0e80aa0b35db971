//! Params, inputs, `let`s and sets.

use std::collections::BTreeMap;

use super::expression::{Scalar, Scope};
use super::names::{Named, Varies};
use super::order::by_use;
use super::wanted::Wanted;
use super::{Reported, Resolved, Resolver};
use crate::model::{Input, Let, Param, ParamSet};
use crate::notation::latex_of;
use crate::source::Span;
use crate::symbolic::{Expr, Symbol};
use crate::syntax::tree::{self, Declaration, Entry, File, ItemKind};

impl Resolver<'_> {
    pub(super) fn params(&mut self, file: &File) {
        for item in &file.items {
            let ItemKind::Params(list) = &item.kind else {
                continue;
            };
            for declaration in list {
                let Ok(value) = self.scalar(&declaration.value, Scope::Constants) else {
                    continue;
                };
                let Some(symbol) = self.quantity_symbol(declaration, value, Varies::Params) else {
                    continue;
                };
                self.model.params.push(Param {
                    name: declaration.name.text.clone(),
                    symbol,
                    default: value.expr,
                    dimension: value.dimension,
                    doc: declaration.doc.clone(),
                    span: declaration.name.span,
                });
            }
        }
    }

    pub(super) fn inputs(&mut self, file: &File) {
        for item in &file.items {
            if let ItemKind::Input(input) = &item.kind {
                let _ = self.input(input);
            }
        }
    }

    fn input(&mut self, input: &tree::Input) -> Resolved<()> {
        let value = self.scalar(&input.value, Scope::Constants)?;
        let mut dimension = value.dimension;
        if let Some(unit) = &input.unit {
            if unit.text != "1" {
                dimension = self.unit(unit)?.dimension;
            }
            let words = dimension.described();
            if !value.zero && !value.dimension.same_units(dimension) {
                let message = format!(
                    "`{}` is {words}, but starts with {}",
                    input.name.text,
                    value.dimension.described()
                );
                let hint = format!("write the start value in {}", unit.text);
                return Err(self.error(input.value.span, message, hint));
            }
        }
        let declaration = Declaration {
            name: input.name.clone(),
            value: input.value.clone(),
            doc: input.doc.clone(),
        };
        let value = Scalar { dimension, ..value };
        if let Some(symbol) = self.quantity_symbol(&declaration, value, Varies::Motion) {
            self.model.inputs.push(Input {
                name: declaration.name.text,
                symbol,
                start: value.expr,
                rate: None,
                dimension,
                doc: declaration.doc,
            });
        }
        Ok(())
    }

    pub(super) fn lets(&mut self, file: &File) {
        let mut declarations: Vec<&Declaration> = Vec::new();
        for item in &file.items {
            if let ItemKind::Lets(list) = &item.kind {
                declarations.extend(list);
            }
        }
        let Ok(order) = self.ordered(&declarations) else {
            return;
        };
        for index in order {
            let declaration = declarations[index];
            let Ok(value) = self.scalar(&declaration.value, Scope::Params) else {
                continue;
            };
            let Some(symbol) = self.quantity_symbol(declaration, value, Varies::Params) else {
                continue;
            };
            self.model.lets.push(Let {
                name: declaration.name.text.clone(),
                symbol,
                value: value.expr,
                dimension: value.dimension,
                doc: declaration.doc.clone(),
                span: declaration.name.span,
            });
        }
    }

    /// The order in which declarations can be resolved; a circle is reported.
    pub(super) fn ordered(&mut self, declarations: &[&Declaration]) -> Resolved<Vec<usize>> {
        by_use(declarations).map_err(|circle| {
            let name = |index: usize| declarations[index].name.text.as_str();
            let mut words: Vec<&str> = circle.iter().take(8).map(|&index| name(index)).collect();
            if circle.len() > words.len() {
                words.push("…");
            }
            words.push(name(circle[0]));
            let message = match circle.as_slice() {
                [one] => format!("`{}` is made of itself", name(*one)),
                _ => format!("these are made of each other: {}", words.join(" → ")),
            };
            let span = declarations[circle[0]].name.span;
            self.error(span, message, "give one of them a value of its own")
        })
    }

    /// Makes the symbol of a declared quantity, unless its name was refused.
    pub(super) fn quantity_symbol(
        &mut self,
        declaration: &Declaration,
        value: Scalar,
        varies: Varies,
    ) -> Option<Symbol> {
        let name = &declaration.name;
        let Some(Named::Pending(kind)) = self.names.get(&name.text) else {
            return None;
        };
        let symbol = self
            .model
            .graph
            .symbol(name.text.as_str(), latex_of(&name.text));
        let named = Named::Quantity(symbol, value.dimension, varies, kind);
        self.names.set(&name.text, named, name.span);
        Some(symbol)
    }

    pub(super) fn sets(&mut self, file: &File) {
        let mut seen: BTreeMap<&str, Span> = BTreeMap::new();
        for item in &file.items {
            let ItemKind::Set(set) = &item.kind else {
                continue;
            };
            if let Some(&earlier) = seen.get(set.name.text.as_str()) {
                let message = format!("there are two sets `{}`", set.name.text);
                let diagnostic = self
                    .diagnostic(set.name.span, message)
                    .hint("give one of the two another name")
                    .related(self.site(earlier), "declared here");
                self.report(set.name.span, diagnostic);
            }
            seen.insert(&set.name.text, set.name.span);
            let mut values: Vec<(usize, Expr)> = Vec::with_capacity(set.entries.len());
            for entry in &set.entries {
                let Ok((index, value)) = self.set_entry(entry) else {
                    continue;
                };
                if values.iter().any(|&(known, _)| known == index) {
                    let message = format!("`{}` is given twice", entry.name.text);
                    self.error(entry.name.span, message, "remove one of the two");
                }
                values.push((index, value));
            }
            self.model.sets.push(ParamSet {
                name: set.name.text.clone(),
                doc: set.doc.clone(),
                values,
            });
        }
    }

    fn set_entry(&mut self, entry: &Entry) -> Resolved<(usize, Expr)> {
        self.no_place(entry)?;
        let name = &entry.name;
        let index = self
            .model
            .params
            .iter()
            .position(|param| param.name == name.text);
        let Some(index) = index else {
            return Err(match self.names.get(&name.text) {
                Some(Named::Pending(_)) => Reported,
                Some(named) => {
                    let message = format!("`{}` is {}, not a param", name.text, named.kind());
                    self.error(name.span, message, "a set gives other values to params")
                }
                None => {
                    let params: Vec<String> =
                        self.model.params.iter().map(|p| p.name.clone()).collect();
                    let hint = "a set gives other values to params";
                    self.unknown(name.span, &name.text, "param", &params, hint)
                }
            });
        };
        let value = self.scalar(&entry.value, Scope::Constants)?;
        let dimension = self.model.params[index].dimension;
        let described = dimension.described();
        let what = format!("`{}`", name.text);
        if !value.zero && !value.dimension.same_units(dimension) {
            let message = format!("{what} is {described}, not {}", value.dimension.described());
            let hint = "a set keeps the kind of quantity that the param has";
            return Err(self.error(entry.value.span, message, hint));
        }
        let wanted = Wanted {
            dimension,
            words: match dimension.mark() {
                crate::units::Mark::Frequency => "a frequency (Hz)",
                crate::units::Mark::AngularRate => "an angular rate (rad/s)",
                crate::units::Mark::Plain => "another quantity",
            },
        };
        self.fits(value, wanted, &what, entry.value.span)?;
        Ok((index, value.expr))
    }
}
