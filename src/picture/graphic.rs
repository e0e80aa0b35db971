//! Pictures that go onto a page or into a file of their own.

use std::fmt::Write;

use super::chart::{Bars, Chart};
use super::plot::{Drawn, Width};
use super::svg::{PAPER, RULES, escape, pixel};
use super::{bars, plot};

/// A picture of numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum Graphic {
    /// A chart.
    Chart(Chart),
    /// Bars.
    Bars(Bars),
    /// Small charts side by side.
    Grid(Vec<Chart>),
}

/// Distance of charts side by side, and height of their titles.
const GUTTER: f64 = 20.0;
const TITLE: f64 = 34.0;

impl Graphic {
    /// What it shows.
    pub fn title(&self) -> &str {
        match self {
            Graphic::Chart(chart) => &chart.title,
            Graphic::Bars(bars) => &bars.title,
            Graphic::Grid(charts) => charts.first().map_or("", |chart| &chart.title),
        }
    }

    /// A file of its own, on white paper.
    pub fn file(&self) -> String {
        let drawn = match self {
            Graphic::Chart(chart) => plot::chart(chart, Width::Wide),
            Graphic::Bars(of) => bars::bars(of, Width::Wide),
            Graphic::Grid(charts) => side_by_side(charts),
        };
        let title = match self {
            Graphic::Grid(_) => "",
            Graphic::Chart(_) | Graphic::Bars(_) => self.title(),
        };
        let top = if title.is_empty() { 0.0 } else { TITLE };
        let [width, height] = drawn.size;
        let title = escape(title);
        format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
             <svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" \
             viewBox=\"0 0 {0} {1}\">\n<title>{title}</title>\n<style>svg{{{PAPER}}}{RULES}</style>\n\
             <rect width=\"100%\" height=\"100%\" style=\"fill:var(--paper)\"/>\n\
             <text class=\"title\" x=\"16\" y=\"26\" style=\"font-size:15px\">{title}</text>\n\
             <g transform=\"translate(0 {2})\">\n{3}</g>\n</svg>\n",
            pixel(width),
            pixel(height + top),
            pixel(top),
            drawn.content
        )
    }

    /// For a page: drawn for wide pages and for narrow ones, of which the page shows one. Colours
    /// are the page's.
    pub(crate) fn inline(&self) -> String {
        match self {
            Graphic::Chart(chart) => both(&chart.title, |width| plot::chart(chart, width)),
            Graphic::Bars(of) => both(&of.title, |width| bars::bars(of, width)),
            Graphic::Grid(charts) => {
                let mut html = String::from("<div class=\"grid-of-charts\">\n");
                for chart in charts {
                    let _ = write!(
                        html,
                        "<div>\n<h4>{}</h4>\n{}</div>\n",
                        escape(&chart.title),
                        element(&chart.title, "", &plot::chart(chart, Width::Narrow))
                    );
                }
                html + "</div>\n"
            }
        }
    }
}

fn both(title: &str, draw: impl Fn(Width) -> Drawn) -> String {
    element(title, "wide-only", &draw(Width::Wide))
        + &element(title, "narrow-only", &draw(Width::Narrow))
}

fn element(title: &str, class: &str, drawn: &Drawn) -> String {
    let [width, height] = drawn.size;
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"{class}\" viewBox=\"0 0 {} {}\" role=\"img\" \
         aria-label=\"{}\">\n{}</svg>\n",
        pixel(width),
        pixel(height),
        escape(title),
        drawn.content
    )
}

/// Charts in rows of two.
fn side_by_side(charts: &[Chart]) -> Drawn {
    let mut content = String::new();
    let (mut top, wide) = (0.0, Width::Narrow.pixels());
    for pair in charts.chunks(2) {
        let mut tallest: f64 = 0.0;
        for (index, chart) in pair.iter().enumerate() {
            let drawn = plot::chart(chart, Width::Narrow);
            let _ = writeln!(
                content,
                "<g transform=\"translate({} {})\"><text class=\"title\" x=\"16\" y=\"22\">{}</text>\
                 <g transform=\"translate(0 {TITLE})\">\n{}</g></g>",
                pixel(index as f64 * (wide + GUTTER)),
                pixel(top),
                escape(&chart.title),
                drawn.content
            );
            tallest = tallest.max(drawn.size[1] + TITLE);
        }
        top += tallest + GUTTER;
    }
    let columns = charts.len().clamp(1, 2) as f64;
    Drawn {
        content,
        size: [columns * wide + (columns - 1.0) * GUTTER, top.max(TITLE)],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::{Axis, Band, Look, Panel, Reference, Series, Which};

    fn chart(series: Vec<Series>, axes: [Axis; 2]) -> Chart {
        let [x, y] = axes;
        Chart {
            title: "a < b & <script>".to_owned(),
            x,
            panels: vec![Panel {
                y,
                series,
                bands: vec![Band {
                    from: 1.0,
                    to: 2.0,
                    label: "<i>".to_owned(),
                    series: Some(0),
                }],
                references: vec![Reference {
                    at: 1.5,
                    axis: Which::X,
                    label: "<u>".to_owned(),
                }],
            }],
            ordered: false,
        }
    }

    /// What is drawn must be XML without a word of the user's taken for markup, and no number that
    /// is none.
    fn well_drawn(graphic: &Graphic) -> String {
        let svg = graphic.file();
        let document =
            roxmltree::Document::parse(&svg).unwrap_or_else(|why| panic!("{why}\n{svg}"));
        assert!(
            document
                .descendants()
                .all(|node| !["script", "i", "u"].contains(&node.tag_name().name()))
        );
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        let page = format!("<div>{}</div>", graphic.inline());
        roxmltree::Document::parse(&page).unwrap();
        assert_eq!(svg, graphic.file());
        svg
    }

    #[test]
    fn any_numbers_are_drawn() {
        let none: [f64; 0] = [];
        let many: Vec<f64> = (0..300).map(f64::from).collect();
        let cases: [(&[f64], &[f64]); 10] = [
            (&none, &none),
            (&[1.0], &[2.0]),
            (&[1.0, 2.0], &[f64::NAN, f64::NAN]),
            (&[0.0, -1.0], &[0.0, -2.0]),
            (&[1.0, 2.0, 3.0], &[1.0, f64::NAN, f64::INFINITY]),
            (&[f64::MIN, f64::MAX], &[f64::MAX, f64::MIN]),
            (&[1e-300, 1e300], &[5e-324, 1e300]),
            (&[f64::NAN, 1.0], &[1.0, 1.0]),
            (&[1.0, 2.0, 3.0], &[1.0]),
            (&many, &many),
        ];
        for (x, y) in cases {
            for look in [Look::Line, Look::Dashed, Look::Points, Look::LineAndPoints] {
                for logarithmic in [false, true] {
                    let axes = [("<x>", "Hz"), ("<y>", "m/s")].map(|(label, unit)| Axis {
                        logarithmic,
                        ..Axis::linear(label, unit)
                    });
                    let series = vec![Series::new("<b>&", x, y, look), Series::new("", x, y, look)];
                    let chart = chart(series, axes);
                    well_drawn(&Graphic::Chart(chart.clone()));
                    well_drawn(&Graphic::Grid(vec![chart.clone(), chart.clone(), chart]));
                }
            }
        }
        well_drawn(&Graphic::Chart(Chart::default()));
        well_drawn(&Graphic::Grid(Vec::new()));
        well_drawn(&Graphic::Bars(Bars::default()));
    }

    #[test]
    fn numbers_stand_where_the_ticks_say() {
        let axes = [Axis::linear("f", "Hz"), Axis::linear("speed", "m/s")];
        let series = Series::new("", [0.0, 900.0], [0.0, 8e-3], Look::Points);
        let svg = well_drawn(&Graphic::Chart(chart(vec![series], axes)));
        let document = roxmltree::Document::parse(&svg).unwrap();
        let text = |wanted: &str, coordinate: &str| -> f64 {
            let found = document
                .descendants()
                .find(|node| node.text() == Some(wanted));
            found
                .and_then(|node| node.attribute(coordinate))
                .unwrap()
                .parse()
                .unwrap()
        };
        assert!(svg.contains("speed (mm/s)") && svg.contains("f (Hz)"));
        let marks: Vec<[f64; 2]> = document
            .descendants()
            .filter(|node| node.attribute("class") == Some("mark"))
            .map(|node| {
                // A circle begins at its left end.
                let path = node.attribute("d").unwrap();
                let (x, rest) = path[1..].split_once(' ').unwrap();
                let y = rest.split('a').next().unwrap();
                [x.parse::<f64>().unwrap() + 3.8, y.parse().unwrap()]
            })
            .collect();
        assert!((marks[1][0] - text("900", "x")).abs() < 0.2, "{svg}");
        // A label stands 4 pixels below its line.
        assert!((marks[1][1] + 4.0 - text("8", "y")).abs() < 0.2, "{svg}");
        assert!((marks[0][1] - marks[1][1]) > 250.0);
    }

    #[test]
    fn what_failed_is_a_gap_with_a_cross() {
        let axes = [Axis::linear("f", "Hz"), Axis::linear("v", "m/s")];
        let series = Series::new(
            "s",
            [1.0, 2.0, 3.0, 4.0],
            [1.0, f64::NAN, 2.0, 3.0],
            Look::LineAndPoints,
        );
        let svg = well_drawn(&Graphic::Chart(chart(vec![series], axes)));
        let curve = svg
            .lines()
            .find(|line| line.contains("class=\"curve\""))
            .unwrap();
        assert_eq!(curve.matches('M').count(), 2, "{curve}");
        assert_eq!(svg.matches("class=\"failed\"").count(), 1);
        assert!(svg.contains("s: 2 Hz, failed"));
    }

    #[test]
    fn bars_say_their_values() {
        let bars = Bars {
            title: "Sensitivity".to_owned(),
            value: Axis::linear("S", "1"),
            names: vec!["Fp".to_owned(), "<b>".to_owned()],
            groups: vec![
                ("up".to_owned(), vec![1.5, f64::NAN]),
                ("down".to_owned(), vec![-0.5]),
            ],
        };
        let svg = well_drawn(&Graphic::Bars(bars));
        assert!(svg.contains(">1.5<") && svg.contains(">−0.5<") && svg.contains("failed"));
    }
}
