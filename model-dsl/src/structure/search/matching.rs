//! Which variables are free: equations of loops matched with variables.
//!
//! Where no choice of a coordinate lets all loops close one after the other, a coordinate must
//! still not be a variable that its loops determine. Each equation is given a variable of its own
//! (a matching in the graph of equations and variables); a variable that can be spared is free.

use std::collections::VecDeque;

use super::{BodyId, Search};
use crate::structure::turning_link;

impl Search<'_> {
    /// Whether the loops that are left can do without a variable.
    pub(in crate::structure) fn can_spare(&self, bodies: &[BodyId], spared: BodyId) -> bool {
        let equations = self.equations(bodies, spared);
        let mut matching = Matching {
            taken: vec![None; self.known.len()],
            held: vec![None; equations.len()],
        };
        (0..equations.len()).all(|equation| matching.place(equation, &equations))
    }

    /// For each equation of the loops that are left, the unknown variables in it but one.
    fn equations(&self, bodies: &[BodyId], spared: BodyId) -> Vec<Vec<BodyId>> {
        let mut trial = self.clone();
        let ways = trial.ways_with_all_known(bodies);
        let structure = trial.so_far();
        let mut equations = Vec::new();
        for way in ways {
            let passed = structure.way_bodies(&way);
            let turns = passed
                .iter()
                .filter_map(|body| turning_link(self.model, *body));
            let mut variables: Vec<BodyId> = passed.iter().copied().chain(turns).collect();
            variables.retain(|body| !self.known[*body] && *body != spared);
            variables.sort_unstable();
            variables.dedup();
            // Both components of the loop's sum.
            equations.push(variables.clone());
            equations.push(variables);
        }
        equations
    }
}

/// Equations with the variables they were given.
struct Matching {
    /// The equation of each variable.
    taken: Vec<Option<usize>>,
    /// The variable of each equation.
    held: Vec<Option<BodyId>>,
}

impl Matching {
    /// Gives an equation a variable, others giving way where they can: a shortest augmenting path.
    fn place(&mut self, equation: usize, equations: &[Vec<BodyId>]) -> bool {
        let mut reached: Vec<Option<usize>> = vec![None; self.taken.len()];
        let mut queue = VecDeque::from([equation]);
        while let Some(from) = queue.pop_front() {
            for &variable in &equations[from] {
                if reached[variable].is_some() {
                    continue;
                }
                reached[variable] = Some(from);
                match self.taken[variable] {
                    Some(other) => queue.push_back(other),
                    None => {
                        self.give(variable, &reached);
                        return true;
                    }
                }
            }
        }
        false
    }

    /// Along a path to a variable that is free, each equation takes the next variable.
    fn give(&mut self, variable: BodyId, reached: &[Option<usize>]) {
        let mut next = Some(variable);
        while let Some(variable) = next {
            let Some(equation) = reached[variable] else {
                return;
            };
            next = self.held[equation].replace(variable);
            self.taken[variable] = Some(equation);
        }
    }
}
