//! Waveforms against their textbook definitions, walked kink by kink as a run would.

use super::*;
use crate::symbolic::Evaluator;

/// A waveform on its way through time.
struct Walk<'a> {
    waveform: &'a Waveform,
    graph: &'a Graph,
    time: Symbol,
    memory: Vec<f64>,
}

impl<'a> Walk<'a> {
    fn new(graph: &'a Graph, time: Symbol, waveform: &'a Waveform) -> Self {
        let mut evaluator = Evaluator::new(graph);
        let memory = waveform
            .memory
            .iter()
            .map(|memory| evaluator.value(memory.initial))
            .collect();
        Self {
            waveform,
            graph,
            time,
            memory,
        }
    }

    fn evaluator(&self, t: f64) -> Evaluator<'a> {
        let mut evaluator = Evaluator::new(self.graph);
        evaluator.set(self.time, t);
        for (memory, value) in self.waveform.memory.iter().zip(&self.memory) {
            evaluator.set(memory.symbol, *value);
        }
        evaluator
    }

    fn value(&self, t: f64) -> f64 {
        self.evaluator(t).value(self.waveform.value)
    }

    fn next(&self) -> f64 {
        match &self.waveform.kink {
            Some(kink) => self.evaluator(f64::NAN).value(kink.next),
            None => Waveform::NEVER,
        }
    }

    fn cross(&mut self) {
        let kink = self.waveform.kink.as_ref().expect("a kink");
        let mut evaluator = self.evaluator(f64::NAN);
        self.memory = kink.updates.iter().map(|&u| evaluator.value(u)).collect();
    }

    /// Compares with `expected` inside every piece up to `until`; returns the kinks passed.
    fn compare(&mut self, until: f64, expected: impl Fn(f64) -> f64) -> Vec<f64> {
        let mut kinks = Vec::new();
        let mut start = 0.0;
        loop {
            let end = self.next().min(until);
            assert!(end > start, "kink at {end} after {start}");
            for part in [0.001, 0.3, 0.5, 0.9, 0.999] {
                let t = start + part * (end - start);
                let (value, wanted) = (self.value(t), expected(t));
                assert!(
                    (value - wanted).abs() <= 1e-12 * wanted.abs().max(1.0),
                    "at {t}: {value}, not {wanted}"
                );
            }
            if end >= until {
                return kinks;
            }
            kinks.push(end);
            self.cross();
            start = end;
        }
    }
}

fn graph() -> (Graph, Symbol) {
    let mut g = Graph::new();
    let time = g.symbol("t", "t");
    (g, time)
}

fn assert_times(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len(), "{found:?}, not {expected:?}");
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() < 1e-14, "{found:?}, not {expected:?}");
    }
}

#[test]
fn sawtooth_rises_slowly_and_falls_fast() {
    let (mut g, time) = graph();
    let (stroke, frequency, rise) = (g.integer(2), g.integer(4), g.ratio(19, 20));
    let waveform = sawtooth(&mut g, time, "xp", stroke, frequency, rise);
    assert!(!waveform.kink.as_ref().unwrap().jumps);
    let kinks = Walk::new(&g, time, &waveform).compare(0.6, |t| {
        let s = (4.0 * t).fract();
        2.0 * if s < 0.95 { s / 0.95 } else { (1.0 - s) / 0.05 }
    });
    assert_times(&kinks, &[0.2375, 0.25, 0.4875, 0.5]);
}

#[test]
fn sawtooth_with_a_rise_of_a_whole_or_no_period_jumps() {
    for (rise, expected) in [(1, [0.0, 2.0]), (0, [2.0, 0.0])] {
        // Once written as a number and once as a param.
        for symbolic in [false, true] {
            let (mut g, time) = graph();
            let (stroke, frequency) = (g.integer(2), g.integer(4));
            let number = g.integer(rise);
            let param = g.symbol("rise", "rise");
            let rise_expr = if symbolic { g.of(param) } else { number };
            let mut waveform = sawtooth(&mut g, time, "xp", stroke, frequency, rise_expr);
            assert_eq!(waveform.kink.as_ref().unwrap().jumps, !symbolic);
            if symbolic {
                let known = std::collections::HashMap::from([(param, number)]);
                let mut fix = |expr: &mut Expr| *expr = g.substitute(*expr, &known);
                waveform.memory.iter_mut().for_each(|m| fix(&mut m.initial));
                let kink = waveform.kink.as_mut().unwrap();
                fix(&mut kink.next);
                kink.updates.iter_mut().for_each(&mut fix);
                fix(&mut waveform.value);
            }
            let [low, high] = expected;
            let kinks = Walk::new(&g, time, &waveform)
                .compare(0.6, |t| low + (high - low) * (4.0 * t).fract());
            assert_times(&kinks, &[0.25, 0.5]);
        }
    }
}

#[test]
fn the_rate_of_a_sawtooth_is_finite_even_where_the_fall_has_no_extent() {
    let (mut g, time) = graph();
    let (stroke, frequency) = (g.integer(2), g.integer(4));
    let rise = g.symbol("rise", "rise");
    let rise_expr = g.of(rise);
    let waveform = sawtooth(&mut g, time, "xp", stroke, frequency, rise_expr);
    let rates = std::collections::HashMap::from([(time, g.one())]);
    let rate = g.derivative(waveform.value, &rates);
    let mut evaluator = Evaluator::new(&g);
    evaluator.set(time, 0.1);
    for (memory, value) in waveform.memory.iter().zip([0.0, 0.0]) {
        evaluator.set(memory.symbol, value);
    }
    evaluator.set(rise, 1.0);
    assert_eq!(evaluator.value(rate), 8.0);
}

#[test]
fn triangle_is_symmetric() {
    let (mut g, time) = graph();
    let (stroke, frequency) = (g.integer(3), g.integer(2));
    let waveform = triangle(&mut g, time, "x", stroke, frequency);
    let kinks = Walk::new(&g, time, &waveform).compare(1.1, |t| {
        let s = (2.0 * t).fract();
        3.0 * (1.0 - (2.0 * s - 1.0).abs())
    });
    assert_times(&kinks, &[0.25, 0.5, 0.75, 1.0]);
}

#[test]
fn trapezoid_rises_holds_falls_and_rests() {
    let (mut g, time) = graph();
    let (stroke, frequency) = (g.integer(3), g.one());
    let (rise, hold, fall) = (g.ratio(1, 5), g.ratio(3, 10), g.ratio(1, 10));
    let waveform = trapezoid(&mut g, time, "x", stroke, frequency, rise, hold, fall);
    let kinks = Walk::new(&g, time, &waveform).compare(2.1, |t| {
        let s = t.fract();
        3.0 * (s / 0.2).min(1.0).min((0.6 - s) / 0.1).max(0.0)
    });
    assert_times(&kinks, &[0.2, 0.5, 0.6, 1.0, 1.2, 1.5, 1.6, 2.0]);
}

#[test]
fn trapezoid_passes_over_pieces_without_extent() {
    let (mut g, time) = graph();
    let (stroke, frequency) = (g.integer(3), g.one());
    let (zero, half) = (g.zero(), g.ratio(1, 2));
    let waveform = trapezoid(&mut g, time, "x", stroke, frequency, zero, half, zero);
    assert!(waveform.kink.as_ref().unwrap().jumps);
    let square = |t: f64| if t.fract() < 0.5 { 3.0 } else { 0.0 };
    let kinks = Walk::new(&g, time, &waveform).compare(2.1, square);
    assert_times(&kinks, &[0.5, 1.0, 1.5, 2.0]);

    let waveform = trapezoid(&mut g, time, "x", stroke, frequency, half, zero, half);
    let kinks = Walk::new(&g, time, &waveform)
        .compare(1.9, |t| 3.0 * (1.0 - (2.0 * t.fract() - 1.0).abs()));
    assert_times(&kinks, &[0.5, 1.0, 1.5]);
}

#[test]
fn sine_has_no_kink() {
    let (mut g, time) = graph();
    let (amplitude, frequency) = (g.integer(2), g.integer(5));
    let (phase, offset) = (g.ratio(1, 3), g.integer(7));
    let waveform = sine(&mut g, time, amplitude, frequency, phase, offset);
    let kinks = Walk::new(&g, time, &waveform).compare(1.0, |t| {
        7.0 + 2.0 * (2.0 * std::f64::consts::PI * 5.0 * t + 1.0 / 3.0).sin()
    });
    assert!(kinks.is_empty());
}

#[test]
fn step_jumps_once() {
    for at in [3, 0, -1] {
        let (mut g, time) = graph();
        let (height, at_expr) = (g.integer(5), g.integer(at));
        let waveform = step(&mut g, "x", height, at_expr);
        assert!(waveform.kink.as_ref().unwrap().jumps);
        let expected = |t: f64| if t < f64::from(at as i32) { 0.0 } else { 5.0 };
        let kinks = Walk::new(&g, time, &waveform).compare(10.0, expected);
        assert_times(&kinks, if at > 0 { &[3.0] } else { &[] });
    }
}

#[test]
fn ramp_starts_and_ends() {
    let (mut g, time) = graph();
    let (rate, start, duration) = (g.integer(2), g.integer(1), g.integer(3));
    let unbounded = ramp(&mut g, time, "x", rate, start, None);
    let kinks = Walk::new(&g, time, &unbounded).compare(9.0, |t| 2.0 * (t - 1.0).max(0.0));
    assert_times(&kinks, &[1.0]);
    let bounded = ramp(&mut g, time, "x", rate, start, Some(duration));
    let kinks = Walk::new(&g, time, &bounded).compare(9.0, |t| 2.0 * (t - 1.0).clamp(0.0, 3.0));
    assert_times(&kinks, &[1.0, 4.0]);
    let zero = g.zero();
    let empty = ramp(&mut g, time, "x", rate, start, Some(zero));
    let kinks = Walk::new(&g, time, &empty).compare(9.0, |_| 0.0);
    assert_times(&kinks, &[1.0]);
}

#[test]
fn chirp_sweeps_and_stays() {
    let (mut g, time) = graph();
    let (amplitude, from, to, duration) = (g.integer(2), g.one(), g.integer(3), g.integer(4));
    let waveform = chirp(&mut g, time, "x", amplitude, from, to, duration);
    // The phase is the integral of the frequency.
    let frequency = |t: f64| 1.0 + 2.0 * (t / 4.0).min(1.0);
    let turns = |t: f64| {
        let (a, b) = (t.min(4.0), (t - 4.0).max(0.0));
        (frequency(0.0) + frequency(a)) / 2.0 * a + frequency(t) * b
    };
    let kinks = Walk::new(&g, time, &waveform)
        .compare(6.0, |t| 2.0 * (2.0 * std::f64::consts::PI * turns(t)).sin());
    assert_times(&kinks, &[4.0]);
}

#[test]
fn table_is_piecewise_linear_and_held_at_its_ends() {
    let (mut g, time) = graph();
    let samples = [(0.5, 1.0), (1.0, 3.0), (1.0, -1.0), (2.5, 0.1)];
    let waveform = table(&mut g, time, "x", &samples).unwrap();
    assert!(waveform.kink.as_ref().unwrap().jumps);
    let kinks = Walk::new(&g, time, &waveform).compare(4.0, |t| match t {
        t if t < 0.5 => 1.0,
        t if t < 1.0 => 1.0 + 4.0 * (t - 0.5),
        t if t < 2.5 => -1.0 + 1.1 * (t - 1.0) / 1.5,
        _ => 0.1,
    });
    assert_times(&kinks, &[0.5, 1.0, 2.5]);
    assert!(g.symbols_in(&[waveform.value]).len() == 4);
}

#[test]
fn table_may_begin_before_the_run() {
    let (mut g, time) = graph();
    let samples = [(-2.0, 0.0), (-1.0, 7.0), (1.0, 9.0)];
    let waveform = table(&mut g, time, "x", &samples).unwrap();
    let kinks = Walk::new(&g, time, &waveform).compare(3.0, |t| (8.0 + t).min(9.0));
    assert_times(&kinks, &[1.0]);
    let single = table(&mut g, time, "x", &[(0.0, 4.0)]).unwrap();
    assert!(
        Walk::new(&g, time, &single)
            .compare(3.0, |_| 4.0)
            .is_empty()
    );
}

#[test]
fn table_refuses_what_is_no_function_of_time() {
    let (mut g, time) = graph();
    for samples in [
        &[][..],
        &[(1.0, 0.0), (0.0, 0.0)],
        &[(0.0, f64::NAN)],
        &[(f64::INFINITY, 0.0)],
        &[(0.0, 0.0), (1e-300, 1e300)],
    ] {
        assert!(table(&mut g, time, "x", samples).is_none());
    }
}
