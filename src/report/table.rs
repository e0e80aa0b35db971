//! Tables: for people with a few digits, and as comma-separated values with all of them.

use std::collections::BTreeMap;
use std::fmt::Write;

use crate::picture::svg::escape;
use crate::picture::{Bars, Chart, Graphic, display_unit, number};

/// Columns of one length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// The columns.
    pub columns: Vec<Column>,
}

/// A column of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// What stands above it.
    pub name: String,
    /// SI unit of its numbers; empty if they have none.
    pub unit: String,
    /// What stands in it.
    pub cells: Cells,
}

/// What stands in a column.
#[derive(Clone, Debug, PartialEq)]
pub enum Cells {
    /// Numbers in SI; one that is none is shown as missing.
    Numbers(Vec<f64>),
    /// Words.
    Words(Vec<String>),
}

/// Rows that a page shows; a longer table is there as comma-separated values alone.
const SHOWN: usize = 300;
/// Digits of numbers for people.
const DIGITS: usize = 6;

impl Column {
    /// A column of numbers in SI.
    pub fn numbers(
        name: impl Into<String>,
        unit: impl Into<String>,
        values: impl Into<Vec<f64>>,
    ) -> Self {
        Self {
            name: name.into(),
            unit: unit.into(),
            cells: Cells::Numbers(values.into()),
        }
    }

    /// A column of words.
    pub fn words(name: impl Into<String>, words: impl Into<Vec<String>>) -> Self {
        Self {
            name: name.into(),
            unit: String::new(),
            cells: Cells::Words(words.into()),
        }
    }

    fn len(&self) -> usize {
        match &self.cells {
            Cells::Numbers(values) => values.len(),
            Cells::Words(words) => words.len(),
        }
    }
}

impl Table {
    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.columns.iter().map(Column::len).max().unwrap_or(0)
    }

    /// Comma-separated values: a line of names with units, then SI values that read back exactly.
    pub fn csv(&self) -> String {
        let mut csv = String::new();
        let quoted = |text: &str| match text.contains([',', '"', '\n', '\r']) {
            true => format!("\"{}\"", text.replace('"', "\"\"")),
            false => text.to_owned(),
        };
        let heads = self
            .columns
            .iter()
            .map(|column| match column.unit.as_str() {
                "" | "1" => quoted(&column.name),
                unit => quoted(&format!("{} [{unit}]", column.name)),
            });
        csv += &heads.collect::<Vec<_>>().join(",");
        csv.push('\n');
        for row in 0..self.rows() {
            for (index, column) in self.columns.iter().enumerate() {
                if index > 0 {
                    csv.push(',');
                }
                match &column.cells {
                    Cells::Numbers(values) => match values.get(row) {
                        Some(value) if value.is_nan() => {}
                        Some(value) => {
                            let _ = write!(csv, "{value:e}");
                        }
                        None => {}
                    },
                    Cells::Words(words) => {
                        csv += &words.get(row).map_or(String::new(), |w| quoted(w))
                    }
                }
            }
            csv.push('\n');
        }
        csv
    }

    /// The table as HTML, with units in its head.
    pub(super) fn html(&self) -> String {
        let mut html = String::from("<div class=\"scroll\"><table class=\"numbers\">\n<thead><tr>");
        let mut units = Vec::new();
        for column in &self.columns {
            let unit = match &column.cells {
                Cells::Numbers(values) => {
                    let finite = values.iter().filter(|value| value.is_finite());
                    display_unit(
                        &column.unit,
                        finite.fold(0.0, |most, v| f64::max(most, v.abs())),
                    )
                }
                Cells::Words(_) => display_unit("1", 0.0),
            };
            let _ = write!(html, "<th{}>{}", align(column), escape(&column.name));
            if !unit.name.is_empty() {
                let _ = write!(
                    html,
                    "<br><span class=\"unit\">{}</span>",
                    escape(&unit.name)
                );
            }
            html.push_str("</th>");
            units.push(unit);
        }
        html.push_str("</tr></thead>\n<tbody>\n");
        for row in 0..self.rows().min(SHOWN) {
            html.push_str("<tr>");
            for (column, unit) in self.columns.iter().zip(&units) {
                let _ = write!(html, "<td{}>", align(column));
                match &column.cells {
                    Cells::Numbers(values) => match values.get(row) {
                        Some(value) if !value.is_nan() => {
                            html += &number(value / unit.factor, DIGITS)
                        }
                        _ => html.push('–'),
                    },
                    Cells::Words(words) => {
                        html += &escape(words.get(row).map_or("", String::as_str));
                    }
                }
                html.push_str("</td>");
            }
            html.push_str("</tr>\n");
        }
        html.push_str("</tbody>\n</table></div>\n");
        let rows = self.rows();
        if rows > SHOWN {
            let _ = writeln!(
                html,
                "<p class=\"remark\">The first {SHOWN} of {rows} rows; the values below hold all.</p>"
            );
        }
        html
    }

    /// The numbers that a picture shows: series over the same values share a column of them.
    pub fn behind(graphic: &Graphic) -> Self {
        match graphic {
            Graphic::Chart(chart) => behind_chart(chart),
            Graphic::Bars(bars) => behind_bars(bars),
            Graphic::Grid(charts) => Self {
                columns: charts
                    .iter()
                    .flat_map(|chart| {
                        let columns = behind_chart(chart).columns.into_iter();
                        columns.map(|column| Column {
                            name: format!("{}: {}", chart.title, column.name),
                            ..column
                        })
                    })
                    .collect(),
            },
        }
    }
}

fn align(column: &Column) -> &'static str {
    match column.cells {
        Cells::Numbers(_) => "",
        Cells::Words(_) => " class=\"words\"",
    }
}

fn behind_bars(bars: &Bars) -> Table {
    let mut columns = vec![Column::words("", bars.names.clone())];
    for (name, values) in &bars.groups {
        let name = if name.is_empty() {
            &bars.value.label
        } else {
            name
        };
        columns.push(Column::numbers(name, &bars.value.unit, values.clone()));
    }
    Table { columns }
}

fn behind_chart(chart: &Chart) -> Table {
    let series: Vec<_> = chart
        .panels
        .iter()
        .flat_map(|panel| panel.series.iter().map(move |series| (panel, series)))
        .collect();
    // Each horizontal value once, in order; bits of floats above zero and below are told apart so
    // that they sort as numbers do.
    let key = |value: f64| {
        let bits = value.to_bits();
        if bits >> 63 == 1 {
            !bits
        } else {
            bits | 1 << 63
        }
    };
    let is_one_grid = series.windows(2).all(|pair| pair[0].1.x == pair[1].1.x);
    let mut columns = Vec::new();
    if is_one_grid {
        if let Some((_, first)) = series.first() {
            columns.push(Column::numbers(
                &chart.x.label,
                &chart.x.unit,
                first.x.to_vec(),
            ));
        }
        columns.extend(series.iter().map(|(panel, of)| {
            Column::numbers(name(&panel.y.label, &of.name), &panel.y.unit, of.y.clone())
        }));
        return Table { columns };
    }
    let across: BTreeMap<u64, f64> = series
        .iter()
        .flat_map(|(_, of)| of.x.iter().map(|&x| (key(x), x)))
        .collect();
    columns.push(Column::numbers(
        &chart.x.label,
        &chart.x.unit,
        across.values().copied().collect::<Vec<_>>(),
    ));
    for (panel, of) in series {
        let values: BTreeMap<u64, f64> = of.points().map(|[x, y]| (key(x), y)).collect();
        let cells = across
            .keys()
            .map(|key| values.get(key).copied().unwrap_or(f64::NAN));
        columns.push(Column::numbers(
            name(&panel.y.label, &of.name),
            &panel.y.unit,
            cells.collect::<Vec<_>>(),
        ));
    }
    Table { columns }
}

fn name(label: &str, series: &str) -> String {
    match (label, series) {
        (label, "") => label.to_owned(),
        ("", series) => series.to_owned(),
        (label, series) => format!("{label}, {series}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::{Axis, Look, Panel, Series};

    #[test]
    fn series_over_other_values_share_one_column_of_them() {
        let chart = Chart {
            x: Axis::linear("f", "Hz"),
            panels: vec![Panel {
                y: Axis::linear("v", "m/s"),
                series: vec![
                    Series::new("a", [-1.0, 2.0], [0.1, 0.2], Look::Line),
                    Series::new("b", [2.0, -3.0], [0.3, f64::NAN], Look::Line),
                ],
                ..Panel::default()
            }],
            ..Chart::default()
        };
        let table = Table::behind(&Graphic::Chart(chart));
        assert_eq!(
            table.csv(),
            "f [Hz],\"v, a [m/s]\",\"v, b [m/s]\"\n-3e0,,\n-1e0,1e-1,\n2e0,2e-1,3e-1\n"
        );
        assert!(
            table.html().contains("<td>200</td><td>300</td>"),
            "{}",
            table.html()
        );
    }
}
