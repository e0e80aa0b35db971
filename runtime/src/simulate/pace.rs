//! How steps are chosen: equal ones, or as long as accuracy allows.

use super::tolerance::StepControl;

/// How steps are chosen.
pub(super) enum Pace {
    /// Equal ones.
    Fixed(Equal),
    /// As accuracy asks for.
    Adaptive(StepControl),
}

/// The fewest equal steps to each break that are no longer than a given one.
pub(super) struct Equal {
    longest: f64,
    stretch: Option<Stretch>,
}

/// The way to the next break.
pub(super) struct Stretch {
    pub from: f64,
    pub to: f64,
    pub h: f64,
    /// Number of steps.
    pub steps: f64,
    /// How many of them were tried.
    pub taken: f64,
}

/// A step to be tried.
#[derive(Clone, Copy)]
pub(super) struct Trial {
    /// Its length.
    pub h: f64,
    /// The time at its end, exactly.
    pub end: f64,
}

impl Trial {
    /// A step that would come this near to a break goes there, by its share of the way.
    pub const NEARLY: f64 = 0.999_999;
}

impl Pace {
    pub fn fixed(longest: f64) -> Self {
        Pace::Fixed(Equal {
            longest,
            stretch: None,
        })
    }

    /// The step to try next from `t`, no longer than `longest`; it ends exactly at the break `to`,
    /// or before.
    pub fn next(&mut self, t: f64, to: f64, longest: f64) -> Trial {
        let trial = self.wanted(t, to);
        if trial.h <= longest {
            return trial;
        }
        if let Pace::Fixed(equal) = self {
            equal.stretch = None;
        }
        Trial {
            h: longest,
            end: t + longest,
        }
    }

    fn wanted(&mut self, t: f64, to: f64) -> Trial {
        match self {
            Pace::Fixed(equal) => equal.next(t, to),
            Pace::Adaptive(control) => {
                let left = to - t;
                if control.wanted >= Trial::NEARLY * left {
                    return Trial { h: left, end: to };
                }
                // Two equal steps to the break rather than a long and a short one.
                let h = control.wanted.min(if control.wanted > 0.5 * left {
                    0.5 * left
                } else {
                    f64::INFINITY
                });
                Trial { h, end: t + h }
            }
        }
    }

    /// A break was reached behind which the motion goes on as before.
    pub fn stop_over(&mut self) {
        if let Pace::Fixed(equal) = self {
            equal.stretch = None;
        }
    }

    /// The motion goes on differently, behind a kink or an event; the next step is no longer than
    /// `longest`.
    pub fn restart(&mut self, longest: f64) {
        match self {
            Pace::Fixed(equal) => equal.stretch = None,
            Pace::Adaptive(control) => control.restart(longest),
        }
    }
}

impl Stretch {
    /// Where so many steps end.
    fn end(&self, steps: f64) -> f64 {
        if steps < self.steps {
            self.from + steps * self.h
        } else {
            self.to
        }
    }

    /// Number of steps with the first one yet to be tried that reaches `time`.
    pub fn steps_to(&self, time: f64) -> f64 {
        let mut steps = ((time - self.from) / self.h).ceil();
        if self.end(steps - 1.0) >= time {
            steps -= 1.0;
        } else if self.end(steps) < time {
            steps += 1.0;
        }
        steps.max(self.taken + 1.0)
    }
}

impl Equal {
    /// The way from `t` to the break `to`, or what is left of it.
    pub fn stretch(&mut self, t: f64, to: f64) -> &mut Stretch {
        self.stretch.get_or_insert_with(|| {
            // What exceeds a whole number by rounding takes no step of its own.
            let steps = ((to - t) / self.longest * (1.0 - 1e-9)).ceil().max(1.0);
            Stretch {
                from: t,
                to,
                h: (to - t) / steps,
                steps,
                taken: 0.0,
            }
        })
    }

    fn next(&mut self, t: f64, to: f64) -> Trial {
        let stretch = self.stretch(t, to);
        stretch.taken += 1.0;
        Trial {
            h: stretch.h,
            end: stretch.end(stretch.taken),
        }
    }
}
