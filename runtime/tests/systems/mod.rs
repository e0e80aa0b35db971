//! Systems written by hand, for tests of the integrators that need no compiler.

#![allow(dead_code)] // Each test binary uses a part.

use std::borrow::Cow;

use flexure_runtime::system::{Causality, Energy, EventAction, System, Variable};

type Rates = dyn Fn(f64, &[f64], &[f64], &mut [f64]) + Send + Sync;
type Power = dyn Fn(f64, &[f64], &[f64]) -> Energy + Send + Sync;
type Kink = (
    Box<dyn Fn(&[f64]) -> f64 + Send + Sync>,
    Box<dyn Fn(&mut [f64]) + Send + Sync>,
);
type Function = dyn Fn(f64, &[f64], &[f64]) -> f64 + Send + Sync;
type Action = dyn Fn(f64, &mut [f64], &mut [f64]) -> EventAction + Send + Sync;
type Closure = dyn Fn(&[f64]) -> f64 + Send + Sync;
type Accept = dyn Fn(&[f64], &mut [f64]) + Send + Sync;

/// A system made of closures.
pub struct FnSystem {
    states: Vec<Variable>,
    discretes: Vec<Variable>,
    start: (Vec<f64>, Vec<f64>),
    rates: Box<Rates>,
    energy: Box<Power>,
    kinks: Vec<Kink>,
    events: Vec<(Box<Function>, Box<Action>)>,
    accept: Box<Accept>,
    turning: Vec<usize>,
    closures: Vec<Box<Closure>>,
}

fn variables(names: &[(&str, &str)], causality: Causality) -> Vec<Variable> {
    names
        .iter()
        .map(|&(name, unit)| Variable {
            name: Cow::Owned(name.to_owned()),
            unit: Cow::Owned(unit.to_owned()),
            meaning: Cow::Borrowed(""),
            causality,
            start: None,
        })
        .collect()
}

impl FnSystem {
    /// States with units, their start, and their rates.
    pub fn new(
        states: &[(&str, &str)],
        start: &[f64],
        rates: impl Fn(f64, &[f64], &[f64], &mut [f64]) + Send + Sync + 'static,
    ) -> Self {
        Self {
            states: variables(states, Causality::State),
            discretes: Vec::new(),
            start: (start.to_vec(), Vec::new()),
            rates: Box::new(rates),
            energy: Box::new(|_, _, _| Energy::default()),
            kinks: Vec::new(),
            events: Vec::new(),
            accept: Box::new(|_, _| ()),
            turning: Vec::new(),
            closures: Vec::new(),
        }
    }

    pub fn discrete(mut self, name: &str, start: f64) -> Self {
        self.discretes
            .extend(variables(&[(name, "1")], Causality::Discrete));
        self.start.1.push(start);
        self
    }

    pub fn energy(
        mut self,
        energy: impl Fn(f64, &[f64], &[f64]) -> Energy + Send + Sync + 'static,
    ) -> Self {
        self.energy = Box::new(energy);
        self
    }

    pub fn kink(
        mut self,
        next: impl Fn(&[f64]) -> f64 + Send + Sync + 'static,
        pass: impl Fn(&mut [f64]) + Send + Sync + 'static,
    ) -> Self {
        self.kinks.push((Box::new(next), Box::new(pass)));
        self
    }

    pub fn event(
        mut self,
        function: impl Fn(f64, &[f64], &[f64]) -> f64 + Send + Sync + 'static,
        action: impl Fn(f64, &mut [f64], &mut [f64]) -> EventAction + Send + Sync + 'static,
    ) -> Self {
        self.events.push((Box::new(function), Box::new(action)));
        self
    }

    pub fn accept(mut self, accept: impl Fn(&[f64], &mut [f64]) + Send + Sync + 'static) -> Self {
        self.accept = Box::new(accept);
        self
    }

    pub fn turning(mut self, index: usize) -> Self {
        self.turning.push(index);
        self
    }

    pub fn closure(mut self, closure: impl Fn(&[f64]) -> f64 + Send + Sync + 'static) -> Self {
        self.closures.push(Box::new(closure));
        self
    }
}

impl System for FnSystem {
    fn states(&self) -> &[Variable] {
        &self.states
    }
    fn discretes(&self) -> &[Variable] {
        &self.discretes
    }
    fn inputs(&self) -> &[Variable] {
        &[]
    }
    fn output_variables(&self) -> &[Variable] {
        &[]
    }
    fn start(&self, x: &mut [f64], d: &mut [f64]) {
        x.copy_from_slice(&self.start.0);
        d.copy_from_slice(&self.start.1);
    }
    fn rhs(&self, t: f64, x: &[f64], d: &[f64], _: &[f64], dx: &mut [f64]) {
        (self.rates)(t, x, d, dx);
    }
    /// By differences of fourth order.
    fn jacobian(&self, t: f64, x: &[f64], d: &[f64], _: &[f64], jacobian: &mut [f64]) {
        let n = x.len();
        jacobian.fill(0.0);
        for column in 0..n {
            let distance = 1e-3 * x[column].abs().max(1e-3);
            for (steps, weight) in [(-2.0, 1.0), (-1.0, -8.0), (1.0, 8.0), (2.0, -1.0)] {
                let mut moved = x.to_vec();
                moved[column] += steps * distance;
                let mut rates = vec![0.0; n];
                (self.rates)(t, &moved, d, &mut rates);
                for row in 0..n {
                    jacobian[row * n + column] += weight * rates[row] / (12.0 * distance);
                }
            }
        }
    }
    fn outputs(&self, _: f64, _: &[f64], _: &[f64], _: &[f64], _: &mut [f64]) {}
    fn energy(&self, t: f64, x: &[f64], d: &[f64], _: &[f64]) -> Energy {
        (self.energy)(t, x, d)
    }
    fn kink_count(&self) -> usize {
        self.kinks.len()
    }
    fn next_kinks(&self, d: &[f64], times: &mut [f64]) {
        for (time, (next, _)) in times.iter_mut().zip(&self.kinks) {
            *time = next(d);
        }
    }
    fn pass_kink(&self, index: usize, d: &mut [f64]) {
        (self.kinks[index].1)(d);
    }
    fn event_count(&self) -> usize {
        self.events.len()
    }
    fn events(&self, t: f64, x: &[f64], d: &[f64], _: &[f64], values: &mut [f64]) {
        for (value, (function, _)) in values.iter_mut().zip(&self.events) {
            *value = function(t, x, d);
        }
    }
    fn event_name(&self, _: usize) -> &str {
        "it happens"
    }
    fn pass_event(
        &self,
        index: usize,
        t: f64,
        x: &mut [f64],
        d: &mut [f64],
        _: &[f64],
    ) -> EventAction {
        (self.events[index].1)(t, x, d)
    }
    fn accept(&self, _: f64, x: &[f64], _: &[f64], d: &mut [f64]) {
        (self.accept)(x, d);
    }
    fn turning(&self) -> &[usize] {
        &self.turning
    }
    fn loop_count(&self) -> usize {
        self.closures.len()
    }
    fn closures(&self, _: f64, x: &[f64], _: &[f64], _: &[f64], values: &mut [f64]) {
        for (value, closure) in values.iter_mut().zip(&self.closures) {
            *value = closure(x);
        }
    }
    fn loop_name(&self, _: usize) -> &str {
        "crank–coupler–rocker"
    }
}
