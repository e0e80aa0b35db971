//! Inertia: the kinetic energy as a quadratic form in the coordinates' rates.
//!
//! Every body's velocity is a sum of rates times turned vectors, so the kinetic energy is a sum of
//! products of two rates times the cosine between their vectors times a constant. The constants of
//! equal products are collected over all bodies and named C0, C1, …: for a four-bar these are
//! the article's (5) and (6).

use std::collections::HashMap;

use flexure_runtime::diagnostic::Diagnostic;

use crate::model::BodyId;
use crate::structure::Attachment;
use crate::symbolic::Expr;

use super::Derivation;

/// Coordinates that one block of the inertia may have: its entries and their derivatives grow with
/// the cube of their number.
const MOST_COUPLED: usize = 24;

/// Bodies between a body and ground.
const MOST_IN_CHAIN: usize = 100;

/// The kinetic energy, and M(q) as it follows from it.
pub(crate) struct Inertia {
    /// M by coordinates.
    pub matrix: Vec<Vec<Expr>>,
    /// Coordinates that are coupled through inertia, each block in ascending order.
    pub blocks: Vec<Vec<usize>>,
    /// For each coordinate, the entries of M that change with it, row by row.
    moved: Vec<Vec<(usize, usize)>>,
    /// For each entry of M that changes, the coordinates that it changes with.
    movers: HashMap<(usize, usize), Vec<usize>>,
}

impl Inertia {
    /// The pairs j, k for which M_jk changes with coordinate i, or M_ij with coordinate k; row by
    /// row, each once.
    pub fn concerning(&self, index: usize) -> Vec<(usize, usize)> {
        let mut entries = self.moved[index].clone();
        let own = self.blocks.iter().find(|block| block.contains(&index));
        for &j in own.into_iter().flatten() {
            let movers = self.movers.get(&(index, j));
            entries.extend(movers.into_iter().flatten().map(|&k| (j, k)));
        }
        entries.sort_unstable();
        entries.dedup();
        entries
    }
}

/// `coefficient · rate(first) · rate(second) · shape`, twice the kinetic energy.
struct Product {
    first: BodyId,
    second: BodyId,
    shape: Expr,
    terms: Vec<Expr>,
}

/// Products in the order in which they first came up, each once.
#[derive(Default)]
struct Products {
    list: Vec<Product>,
    position: HashMap<(BodyId, BodyId, Expr), usize>,
}

impl Products {
    fn add(&mut self, first: BodyId, second: BodyId, shape: Expr, term: Expr) {
        let new = self.list.len();
        let at = *self.position.entry((first, second, shape)).or_insert(new);
        if at == new {
            self.list.push(Product {
                first,
                second,
                shape,
                terms: Vec::new(),
            });
        }
        self.list[at].terms.push(term);
    }
}

impl Derivation<'_> {
    /// Collects the kinetic energy of all bodies.
    ///
    /// # Errors
    /// More links in one chain, or coordinates in one block, than equations are written out for.
    pub(super) fn inertia(&mut self) -> Result<Inertia, Vec<Diagnostic>> {
        self.refuse_long_chains()?;
        let products = self.kinetic_products();
        let n = self.coordinates.len();
        let mut lines = Vec::new();
        let mut constants = 0;
        let mut parts: Vec<Vec<Vec<Expr>>> = vec![vec![Vec::new(); n]; n];
        for product in products {
            let constant = self.g.sum(&product.terms);
            let dependent = self.variable(product.first).coordinate.is_none()
                || self.variable(product.second).coordinate.is_none();
            let plain = self.g.as_symbol(constant).is_some()
                || self.g.as_number(constant).is_some()
                || (product.terms.len() == 1 && !dependent);
            let constant = if plain {
                constant
            } else {
                let name = format!("C{constants}");
                constants += 1;
                let named = self.named(&name, constant, "constant of the inertia");
                if let Some(symbol) = self.g.as_symbol(named) {
                    self.equation_line(&mut lines, symbol, constant, "");
                }
                named
            };
            let (first, second) = (
                self.variable(product.first).clone(),
                self.variable(product.second).clone(),
            );
            let concerned: Vec<usize> = (0..n)
                .filter(|&i| !self.g.is_zero(first.rates[i]) || !self.g.is_zero(second.rates[i]))
                .collect();
            for &i in &concerned {
                for &j in &concerned {
                    let one = [constant, first.rates[i], second.rates[j], product.shape];
                    let other = [constant, first.rates[j], second.rates[i], product.shape];
                    let (one, other) = (self.g.product(&one), self.g.product(&other));
                    let half = self.g.ratio(1, 2);
                    let sum = self.g.add(one, other);
                    // Opens 2·x/2 but leaves (x + y)/2 together.
                    let mean = if one == other {
                        one
                    } else {
                        self.g.mul(half, sum)
                    };
                    if !self.g.is_zero(mean) {
                        parts[i][j].push(mean);
                    }
                }
            }
        }
        let matrix: Vec<Vec<Expr>> = parts
            .iter()
            .map(|row| row.iter().map(|terms| self.g.sum(terms)).collect())
            .collect();
        self.section("Constants of the inertia", lines);
        let blocks = self.blocks(&matrix);
        if let Some(block) = blocks.iter().find(|block| block.len() > MOST_COUPLED) {
            let body = self.coordinates[block[MOST_COUPLED]].body;
            return Err(vec![self.too_long(
                format!(
                    "{} coordinates are coupled by inertia, more than {MOST_COUPLED} are not compiled",
                    block.len()
                ),
                body,
            )]);
        }
        let mut moved = vec![Vec::new(); n];
        let mut movers = HashMap::new();
        for (j, row) in matrix.iter().enumerate() {
            for (k, &entry) in row.iter().enumerate() {
                if self.g.as_number(entry).is_some() {
                    continue;
                }
                let by = self.moved_by_coordinates(entry);
                let by: Vec<usize> = (0..n).filter(|&i| by[i]).collect();
                by.iter().for_each(|&i| moved[i].push((j, k)));
                if !by.is_empty() {
                    movers.insert((j, k), by);
                }
            }
        }
        Ok(Inertia {
            matrix,
            blocks,
            moved,
            movers,
        })
    }

    /// A body that hangs on many others by links moves with the angles of all of them, and each
    /// pair of them makes a product.
    fn refuse_long_chains(&self) -> Result<(), Vec<Diagnostic>> {
        for body in 0..self.model.bodies.len() {
            let (mut at, mut length) = (body, 0);
            loop {
                at = match self.structure.attachments[at] {
                    Attachment::Root => break,
                    Attachment::Pinned { parent, .. } => parent,
                    Attachment::Guided { carrier } => carrier,
                    Attachment::Carried { slide } => slide,
                };
                length += 1;
            }
            if length > MOST_IN_CHAIN {
                return Err(vec![self.too_long(
                    format!(
                        "`{}` hangs on ground by more than {MOST_IN_CHAIN} bodies, longer chains are not compiled",
                        self.model.bodies[body].name
                    ),
                    body,
                )]);
            }
        }
        Ok(())
    }

    fn too_long(&self, message: String, body: BodyId) -> Diagnostic {
        let error = Diagnostic::error(message)
            .hint("lump links or slides together, or join the chain to ground in between");
        let span = self.model.bodies[body].span;
        self.model.source.blame(span, error)
    }

    /// Twice the kinetic energy, product by product: squares of rates first, in body order.
    fn kinetic_products(&mut self) -> Vec<Product> {
        let mut products = Products::default();
        for body in 0..self.model.bodies.len() {
            for mass in &self.model.bodies[body].masses.clone() {
                let place = self.place(body, mass.center);
                let velocity = self.velocity(&place);
                if !self.g.is_zero(mass.inertia)
                    && let Some(link) = self.turned_link(body)
                {
                    let one = self.g.one();
                    products.add(link, link, one, mass.inertia);
                }
                for (i, a) in velocity.iter().enumerate() {
                    for (j, b) in velocity.iter().enumerate().skip(i) {
                        let magnitudes = [mass.mass, a.vector.magnitude, b.vector.magnitude];
                        let mut coefficient = self.g.product(&magnitudes);
                        if i != j {
                            let two = self.g.integer(2);
                            coefficient = self.g.mul(two, coefficient);
                        }
                        let mut shape = if i == j {
                            self.g.one()
                        } else {
                            self.cos_between(&b.vector, &a.vector)
                        };
                        for slide in [a.vector.slide, b.vector.slide].into_iter().flatten() {
                            let position = self.variable(slide).value;
                            shape = self.g.mul(shape, position);
                        }
                        if self.g.is_written_negative(shape) {
                            shape = self.g.neg(shape);
                            coefficient = self.g.neg(coefficient);
                        }
                        if self.g.is_zero(shape) || self.g.is_zero(coefficient) {
                            continue;
                        }
                        if let Some(number) = self.g.as_number(shape).cloned() {
                            coefficient = self.g.scale(coefficient, number);
                            shape = self.g.one();
                        }
                        let (first, second) = if a.variable <= b.variable {
                            (a.variable, b.variable)
                        } else {
                            (b.variable, a.variable)
                        };
                        products.add(first, second, shape, coefficient);
                    }
                }
            }
        }
        let mut products = products.list;
        for product in &mut products {
            product.terms.retain(|term| !self.g.is_zero(*term));
        }
        products.retain(|product| !product.terms.is_empty());
        products.sort_by_key(|product| (product.first != product.second, product.first));
        products
    }

    /// Coordinates that share an entry of M belong to one block.
    fn blocks(&self, matrix: &[Vec<Expr>]) -> Vec<Vec<usize>> {
        let n = matrix.len();
        let mut block: Vec<usize> = (0..n).collect();
        for i in 0..n {
            for j in 0..n {
                if i != j && !self.g.is_zero(matrix[i][j]) {
                    let (keep, drop) = (block[i].min(block[j]), block[i].max(block[j]));
                    block
                        .iter_mut()
                        .filter(|b| **b == drop)
                        .for_each(|b| *b = keep);
                }
            }
        }
        let mut blocks: Vec<Vec<usize>> = Vec::new();
        for lead in 0..n {
            let members: Vec<usize> = (0..n).filter(|i| block[*i] == lead).collect();
            if !members.is_empty() {
                blocks.push(members);
            }
        }
        blocks
    }

    /// ½ Σ M q̇ q̇.
    pub(super) fn kinetic_energy(&mut self, matrix: &[Vec<Expr>]) -> Expr {
        let mut terms = Vec::new();
        for i in 0..matrix.len() {
            for j in i..matrix.len() {
                if self.g.is_zero(matrix[i][j]) {
                    continue;
                }
                let [a, b] = [i, j].map(|k| {
                    let rate = self.coordinates[k].rate;
                    self.g.of(rate)
                });
                let product = self.g.product(&[matrix[i][j], a, b]);
                let half = self.g.ratio(1, 2);
                terms.push(if i == j {
                    self.g.mul(half, product)
                } else {
                    product
                });
            }
        }
        self.g.sum(&terms)
    }
}
