//! Inertia: the kinetic energy as a quadratic form in the coordinates' rates.
//!
//! Every body's velocity is a sum of rates times turned vectors, so the kinetic energy is a sum of
//! products of two rates times the cosine between their vectors times a constant. The constants of
//! equal products are collected over all bodies and named C0, C1, …: for a four-bar these are
//! the article's (5) and (6).

use crate::model::BodyId;
use crate::symbolic::Expr;

use super::Derivation;

/// The kinetic energy, and M(q) as it follows from it.
pub(crate) struct Inertia {
    /// M by coordinates.
    pub matrix: Vec<Vec<Expr>>,
    /// Coordinates that are coupled through inertia, each block in ascending order.
    pub blocks: Vec<Vec<usize>>,
}

/// `coefficient · rate(first) · rate(second) · shape`, twice the kinetic energy.
struct Product {
    first: BodyId,
    second: BodyId,
    shape: Expr,
    terms: Vec<Expr>,
}

impl Derivation<'_> {
    /// Collects the kinetic energy of all bodies.
    pub(super) fn inertia(&mut self) -> Inertia {
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
            for (i, row) in parts.iter_mut().enumerate() {
                for (j, entry) in row.iter_mut().enumerate() {
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
                        entry.push(mean);
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
        Inertia { matrix, blocks }
    }

    /// Twice the kinetic energy, product by product: squares of rates first, in body order.
    fn kinetic_products(&mut self) -> Vec<Product> {
        let mut products: Vec<Product> = Vec::new();
        for body in 0..self.model.bodies.len() {
            for mass in &self.model.bodies[body].masses.clone() {
                let place = self.place(body, mass.center);
                let velocity = self.velocity(&place);
                if !self.g.is_zero(mass.inertia)
                    && let Some(link) = self.turned_link(body)
                {
                    let one = self.g.one();
                    add(&mut products, link, link, one, mass.inertia);
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
                        add(&mut products, first, second, shape, coefficient);
                    }
                }
            }
        }
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

fn add(products: &mut Vec<Product>, first: BodyId, second: BodyId, shape: Expr, term: Expr) {
    let same = products
        .iter_mut()
        .find(|p| (p.first, p.second, p.shape) == (first, second, shape));
    match same {
        Some(product) => product.terms.push(term),
        None => products.push(Product {
            first,
            second,
            shape,
            terms: vec![term],
        }),
    }
}
