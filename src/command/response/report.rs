//! What was found on a frequency response, for people (tables at a terminal) and for programs (a
//! table of comma-separated values).

use flexure::picture::{DisplayUnit, display_unit, number, with_unit};
use flexure::response::{
    DEFINITIONS, Definition, Deviation, Experiment, LinearRegime, Motion, linear_regime,
};

use super::super::actuator::Actuator;
use super::super::columns::columns;
use super::super::csv;
use super::super::terminal::Terminal;
use super::{Arguments, Curve, hertz};

/// What a motion is called.
fn described(motion: Motion) -> String {
    match motion {
        Motion::Measured => "measured".to_owned(),
        Motion::Periodic => "periodic".to_owned(),
        Motion::PeriodN(period) => format!("period-{period}"),
        Motion::Transient => "transient".to_owned(),
        Motion::Chaotic { .. } => "chaotic".to_owned(),
    }
}

/// Everything that was found.
pub struct Study<'a> {
    pub arguments: &'a Arguments,
    pub actuator: &'a Actuator,
    pub family: &'a [String],
    pub frequencies: &'a [f64],
    pub curves: &'a [Curve],
    pub experiment: Option<&'a Experiment>,
}

impl Study<'_> {
    /// Frequencies and speeds of a curve; not numbers where a point failed.
    pub(super) fn curve(&self, curve: &Curve) -> Vec<(f64, f64)> {
        let all = Actuator::curve(self.frequencies, &curve.outcomes);
        // Points of the experiment alone are not the curve's.
        let own = |point: &(f64, f64)| self.actuator.frequencies.contains(&point.0);
        all.into_iter().filter(own).collect()
    }

    /// Speed at a frequency of a curve.
    fn speed(&self, curve: &Curve, frequency: f64) -> Option<f64> {
        let index = self.frequencies.iter().position(|f| *f == frequency)?;
        curve.outcomes[index].as_ref().ok().map(|point| point.speed)
    }

    fn deviation(&self, curve: &Curve) -> Option<Deviation> {
        self.experiment?
            .deviation(|frequency| self.speed(curve, frequency))
    }

    /// The unit in which speeds read best.
    fn unit(&self) -> DisplayUnit {
        let speeds = self.curves.iter().flat_map(|curve| &curve.outcomes);
        let sizes = speeds.filter_map(|outcome| Some(outcome.as_ref().ok()?.speed.abs()));
        display_unit(&self.actuator.speed_unit, sizes.fold(0.0, f64::max))
    }

    /// What a person reads.
    pub fn report(&self) -> String {
        let mut text = format!("{}\n{}\n", self.actuator.speed_words, self.span());
        text.push('\n');
        text.push_str(&self.speeds());
        text.push('\n');
        text.push_str(&self.regimes());
        if self.experiment.is_some() {
            text.push('\n');
            text.push_str(&self.deviations());
        }
        text
    }

    /// Over which cycles speeds are means.
    pub(super) fn span(&self) -> String {
        let arguments = self.arguments;
        match arguments.settle {
            Some(tolerance) => format!(
                "until the state at the start of each cycle repeats to {tolerance:e} of its range, \
                 in at most {} cycles",
                arguments.most_cycles
            ),
            None => {
                let cycles = arguments.actuation.measured();
                let end = u64::from(cycles.warmup) + u64::from(cycles.measured);
                format!("over cycles {} to {end}", cycles.warmup)
            }
        }
    }

    fn speeds(&self) -> String {
        let unit = self.unit();
        let heading = |curve: &Curve| match (curve.label.as_str(), unit.name.as_str()) {
            ("", "") => self.arguments.actuation.speed.clone(),
            ("", unit) => format!("{} ({unit})", self.arguments.actuation.speed),
            (label, "") => label.to_owned(),
            (label, unit) => format!("{label} ({unit})"),
        };
        let mut headings = vec![self.actuator.frequency.clone()];
        headings.extend(self.curves.iter().map(heading));
        let measured = |frequency: f64| {
            let points = self.experiment.map_or(&[][..], |e| &e.points);
            let found = points.iter().find(|point| point.0 == frequency);
            found.map_or(String::new(), |point| digits(point.1 / unit.factor))
        };
        if self.experiment.is_some() {
            headings.push("experiment".to_owned());
        }
        let rows = self
            .frequencies
            .iter()
            .enumerate()
            .map(|(index, &frequency)| {
                let mut row = vec![hertz(frequency)];
                row.extend(
                    self.curves
                        .iter()
                        .map(|curve| match &curve.outcomes[index] {
                            Ok(point) => {
                                let speed = digits(point.speed / unit.factor);
                                match point.motion {
                                    Motion::Measured | Motion::Periodic => speed,
                                    Motion::Chaotic { spread } => {
                                        format!(
                                            "{speed} ± {} chaotic",
                                            digits(spread / unit.factor)
                                        )
                                    }
                                    motion => format!("{speed} {}", described(motion)),
                                }
                            }
                            Err(_) => "failed".to_owned(),
                        }),
                );
                if self.experiment.is_some() {
                    row.push(measured(frequency));
                }
                row
            });
        columns(&headings, &rows.collect::<Vec<_>>())
    }

    fn regimes(&self) -> String {
        let unit = self.unit();
        let headings = [
            "linear regime",
            "window",
            "points",
            "R²",
            "slope",
            "intercept",
            "mean speed",
        ];
        let rows = self.curves.iter().flat_map(|curve| {
            let points = self.curve(curve);
            DEFINITIONS.iter().map(move |definition| {
                let name = match curve.label.as_str() {
                    "" => definition.name.to_owned(),
                    label => format!("{label}: {}", definition.name),
                };
                let mut row = vec![name];
                match linear_regime(&points, definition) {
                    Some(found) => row.extend(self.regime(&found)),
                    None => row.push(too_short(&points, definition)),
                }
                row
            })
        });
        let headings: Vec<String> = headings
            .iter()
            .map(|heading| match (*heading, unit.name.as_str()) {
                ("intercept" | "mean speed", name) if !name.is_empty() => {
                    format!("{heading} ({name})")
                }
                _ => (*heading).to_owned(),
            })
            .collect();
        columns(&headings, &rows.collect::<Vec<_>>())
    }

    fn regime(&self, found: &LinearRegime) -> [String; 6] {
        let unit = self.unit();
        // A speed over a frequency is a step: m/s per Hz is m.
        let step = match self.actuator.speed_unit.strip_suffix("/s") {
            Some(step) => with_unit(found.slope, step, 5),
            None => format!("{} {}/Hz", digits(found.slope), self.actuator.speed_unit),
        };
        [
            format!("{} to {}", hertz(found.from), hertz(found.to)),
            found.points.to_string(),
            format!("{:.4}", found.r_squared),
            step,
            digits(found.intercept / unit.factor),
            digits(found.mean_speed / unit.factor),
        ]
    }

    fn deviations(&self) -> String {
        let headings = ["error against the experiment", "points", "RMSE", "relative"];
        let headings: Vec<String> = headings.iter().map(|h| (*h).to_owned()).collect();
        let rows = self.curves.iter().map(|curve| {
            let mut row = vec![curve.label.clone()];
            match self.deviation(curve) {
                Some(found) => row.extend([
                    found.points.to_string(),
                    with_unit(found.absolute, &self.actuator.speed_unit, 5),
                    found.relative.map_or("–".to_owned(), |relative| {
                        format!("{} %", number(100.0 * relative, 4))
                    }),
                ]),
                None => row.push("none".to_owned()),
            }
            row
        });
        columns(&headings, &rows.collect::<Vec<_>>())
    }

    /// The points as a table of comma-separated values.
    pub fn table(&self) -> String {
        let mut text = String::new();
        let speed = format!("mean({})", self.arguments.actuation.speed);
        let mut names: Vec<&str> = self.family.iter().map(String::as_str).collect();
        names.extend([
            self.actuator.frequency.as_str(),
            &speed,
            "from_cycle",
            "to_cycle",
        ]);
        names.extend(["motion", "spread", "experiment", "status", "message"]);
        csv::push_header(&mut text, names.into_iter());
        for curve in self.curves {
            for (&frequency, outcome) in self.frequencies.iter().zip(&curve.outcomes) {
                let mut fields: Vec<String> = curve
                    .values
                    .iter()
                    .map(|value| csv::number(*value))
                    .collect();
                fields.push(csv::number(frequency));
                let points = self.experiment.map_or(&[][..], |e| &e.points);
                let measured = points.iter().find(|point| point.0 == frequency);
                let measured = measured.map_or(String::new(), |point| csv::number(point.1));
                match outcome {
                    Ok(point) => fields.extend([
                        csv::number(point.speed),
                        point.cycles.start.to_string(),
                        point.cycles.end.to_string(),
                        described(point.motion),
                        match point.motion {
                            Motion::Chaotic { spread } => csv::number(spread),
                            _ => String::new(),
                        },
                        measured,
                        "ok".to_owned(),
                        String::new(),
                    ]),
                    Err(why) => {
                        fields.extend([const { String::new() }; 5]);
                        fields.extend([measured, "failed".to_owned(), why.message.clone()]);
                    }
                }
                csv::push_fields(&mut text, &fields);
            }
        }
        text
    }

    /// Says why points failed: each reason once, with the points that it is the reason for.
    pub fn say_failures(&self, terminal: &Terminal) {
        let mut reasons: Vec<(String, Vec<String>)> = Vec::new();
        for curve in self.curves {
            for (&frequency, outcome) in self.frequencies.iter().zip(&curve.outcomes) {
                let Err(why) = outcome else { continue };
                let place = match curve.label.as_str() {
                    "" => hertz(frequency),
                    label => format!("{label} at {}", hertz(frequency)),
                };
                match reasons
                    .iter_mut()
                    .find(|(reason, _)| *reason == why.message)
                {
                    Some((_, places)) => places.push(place),
                    None => reasons.push((why.message.clone(), vec![place])),
                }
            }
        }
        for (reason, places) in reasons {
            let shown = places
                .iter()
                .take(3)
                .cloned()
                .collect::<Vec<_>>()
                .join("; ");
            let more = match places.len().saturating_sub(3) {
                0 => String::new(),
                more => format!(" and at {more} more points"),
            };
            terminal.note(format_args!("failed: {shown}{more}: {reason}"));
        }
    }
}

/// Where there is no linear regime: whether one fits that has too few points.
fn too_short(points: &[(f64, f64)], definition: &Definition) -> String {
    let shorter = Definition {
        least_points: DEFINITIONS[0].least_points,
        ..*definition
    };
    match linear_regime(points, &shorter) {
        Some(found) => format!("none: {} points to {}", found.points, hertz(found.to)),
        None => "none".to_owned(),
    }
}

/// A number in a table.
fn digits(value: f64) -> String {
    number(value, 6)
}
