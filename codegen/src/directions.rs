//! Sines and cosines that geometry already knows.
//!
//! A loop that closes gives the cosine and sine of its links' angles without evaluating either. So
//! `cos(φ2 - φ1 + β2)` becomes products of the cosines and sines of φ2, φ1 and β2: φ2's from the
//! loop, φ1's once by the library, β2's when a parameter set is prepared. The right-hand side
//! evaluates no sine of a sum.

use std::collections::HashMap;

use flexure_model_dsl::equations::Direction;
use flexure_model_dsl::symbolic::{Expr, Function, Graph, Node, Rational, Symbol};
use num_traits::{One, Signed, Zero};

/// What the product formulas give for a model.
pub(crate) struct Identities {
    /// For a sine or cosine what to compute instead.
    pub(crate) replacements: HashMap<Expr, Expr>,
    /// What the symbols in the replacements stand for.
    pub(crate) definitions: Vec<(Symbol, Expr)>,
}

/// Finds the product formulas for every sine and cosine in `roots` (which include all
/// definitions). `fixed` tells which symbols depend on params alone.
pub(crate) fn identities(
    graph: &mut Graph,
    roots: &[Expr],
    directions: &[Direction],
    fixed: &[bool],
) -> Identities {
    let known: HashMap<Symbol, Direction> = directions.iter().map(|d| (d.angle, *d)).collect();
    let mut finder = Finder {
        pairs: HashMap::new(),
        definitions: Vec::new(),
        known,
    };
    let reachable = graph.reachable(roots);
    let still = still(graph, &reachable, fixed);
    let mut replacements = HashMap::new();
    for expr in reachable {
        let (is_cos, argument) = match graph.node(expr) {
            Node::Function(Function::Cos, arguments) => (true, arguments[0]),
            Node::Function(Function::Sin, arguments) => (false, arguments[0]),
            _ => continue,
        };
        let Some(angle) = angle_sum(graph, argument, &still) else {
            continue;
        };
        let single = angle.parts.len() == 1 && angle.fixed.is_none();
        if single && !finder.known.contains_key(&angle.parts[0].0) {
            continue;
        }
        let (cos, sin) = finder.pair(graph, &angle);
        replacements.insert(expr, if is_cos { cos } else { sin });
    }
    Identities {
        replacements,
        definitions: finder.definitions,
    }
}

/// For each expression by its index whether it depends on params alone.
fn still(graph: &Graph, reachable: &[Expr], fixed: &[bool]) -> Vec<bool> {
    let mut still = vec![true; graph.len()];
    for &expr in reachable {
        let mut all = match graph.as_symbol(expr) {
            Some(symbol) => fixed[symbol.index()],
            None => true,
        };
        graph.operands(expr, |operand| all &= still[operand.index()]);
        still[expr.index()] = all;
    }
    still
}

/// `Σ ±part + fixed`, with at least one part.
struct AngleSum {
    parts: Vec<(Symbol, bool)>,
    fixed: Option<Expr>,
}

/// `argument` as a sum of angles that move and a rest that does not.
fn angle_sum(graph: &mut Graph, argument: Expr, still: &[bool]) -> Option<AngleSum> {
    let (constant, terms) = match graph.node(argument) {
        Node::Sum { constant, terms } => (constant.clone(), terms.clone()),
        _ => (Rational::zero(), vec![(argument, Rational::one())]),
    };
    let mut parts = Vec::new();
    let mut rest = Vec::new();
    for (term, coefficient) in terms {
        if still[term.index()] {
            rest.push((term, coefficient));
        } else {
            let symbol = graph.as_symbol(term)?;
            if !coefficient.abs().is_one() {
                return None;
            }
            parts.push((symbol, coefficient.is_negative()));
        }
    }
    if parts.is_empty() {
        return None;
    }
    let has_rest = !rest.is_empty() || !constant.is_zero();
    let fixed = has_rest.then(|| graph.linear(constant, &rest));
    Some(AngleSum { parts, fixed })
}

struct Finder {
    known: HashMap<Symbol, Direction>,
    /// Cosine and sine of sums of moving angles, the first of them with a plus sign.
    pairs: HashMap<Vec<(Symbol, bool)>, (Expr, Expr)>,
    definitions: Vec<(Symbol, Expr)>,
}

impl Finder {
    fn pair(&mut self, graph: &mut Graph, angle: &AngleSum) -> (Expr, Expr) {
        // The sum is turned so that its first angle counts positively: -A + θ = -(A - θ).
        let turned = angle.parts[0].1;
        let parts: Vec<(Symbol, bool)> = angle
            .parts
            .iter()
            .map(|(symbol, negative)| (*symbol, negative ^ turned))
            .collect();
        let (mut cos, mut sin) = self.moving_pair(graph, &parts);
        if let Some(fixed) = angle.fixed {
            let other = (graph.cos(fixed), graph.sin(fixed));
            (cos, sin) = combine(graph, (cos, sin), other, turned);
        }
        if turned {
            sin = graph.neg(sin);
        }
        (cos, sin)
    }

    fn moving_pair(&mut self, graph: &mut Graph, parts: &[(Symbol, bool)]) -> (Expr, Expr) {
        if let Some(&pair) = self.pairs.get(parts) {
            return pair;
        }
        let mut text = String::new();
        let mut latex = String::new();
        let mut pair = None;
        for (index, (symbol, negative)) in parts.iter().enumerate() {
            let name = (graph.symbol_text(*symbol), graph.symbol_latex(*symbol));
            let sign = match (index, *negative) {
                (0, _) => "",
                (_, true) => " - ",
                (_, false) => " + ",
            };
            text = format!("{text}{sign}{}", name.0);
            latex = format!("{latex}{sign}{}", name.1);
            let one = self.single(graph, *symbol);
            pair = Some(match pair {
                None => one,
                Some(sum) => {
                    let next = parts[..=index].to_vec();
                    match self.pairs.get(&next) {
                        Some(&known) => known,
                        None => {
                            let (cos, sin) = combine(graph, sum, one, *negative);
                            let named = (
                                self.named(graph, "cos", &text, &latex, cos),
                                self.named(graph, "sin", &text, &latex, sin),
                            );
                            self.pairs.insert(next, named);
                            named
                        }
                    }
                }
            });
        }
        pair.expect("an angle sum has a part")
    }

    /// Cosine and sine of one angle.
    fn single(&mut self, graph: &mut Graph, symbol: Symbol) -> (Expr, Expr) {
        let key = vec![(symbol, false)];
        if let Some(&pair) = self.pairs.get(&key) {
            return pair;
        }
        let pair = match self.known.get(&symbol).copied() {
            Some(direction) => {
                let text = graph.symbol_text(symbol).to_owned();
                let latex = graph.symbol_latex(symbol).to_owned();
                (
                    self.named(graph, "cos", &text, &latex, direction.cos),
                    self.named(graph, "sin", &text, &latex, direction.sin),
                )
            }
            None => {
                let angle = graph.of(symbol);
                (graph.cos(angle), graph.sin(angle))
            }
        };
        self.pairs.insert(key, pair);
        pair
    }

    fn named(
        &mut self,
        graph: &mut Graph,
        function: &str,
        text: &str,
        latex: &str,
        value: Expr,
    ) -> Expr {
        let symbol = graph.symbol(
            format!("{function}({text})"),
            format!("\\{function}({latex})"),
        );
        self.definitions.push((symbol, value));
        graph.of(symbol)
    }
}

/// Cosine and sine of a ± b from those of a and b.
fn combine(graph: &mut Graph, a: (Expr, Expr), b: (Expr, Expr), minus: bool) -> (Expr, Expr) {
    let cos_cos = graph.mul(a.0, b.0);
    let sin_sin = graph.mul(a.1, b.1);
    let sin_cos = graph.mul(a.1, b.0);
    let cos_sin = graph.mul(a.0, b.1);
    if minus {
        (graph.add(cos_cos, sin_sin), graph.sub(sin_cos, cos_sin))
    } else {
        (graph.sub(cos_cos, sin_sin), graph.add(sin_cos, cos_sin))
    }
}
