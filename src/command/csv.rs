//! Results as a table of comma-separated values: one header line of names alone, then SI values
//! with 17 significant digits, so that reading the file gives every number back exactly.

use std::fmt::Write;

/// Appends the header line.
pub fn push_header<'n>(line: &mut String, names: impl Iterator<Item = &'n str>) {
    for (index, name) in names.enumerate() {
        if index > 0 {
            line.push(',');
        }
        push_text(line, name);
    }
    line.push('\n');
}

/// Appends a field of text, quoted where it holds what separates fields.
pub fn push_text(line: &mut String, text: &str) {
    if text.contains([',', '"', '\n', '\r']) {
        let _ = write!(line, "\"{}\"", text.replace('"', "\"\""));
    } else {
        line.push_str(text);
    }
}

/// A number as a field.
pub fn number(value: f64) -> String {
    format!("{value:.16e}")
}

/// Appends a row of fields of any kind.
pub fn push_fields(line: &mut String, fields: &[String]) {
    push_header(line, fields.iter().map(String::as_str));
}

/// Appends a row.
pub fn push_row(line: &mut String, values: &[f64]) {
    push_values(line, values);
    // No field follows the last.
    if line.ends_with(',') {
        line.pop();
    }
    line.push('\n');
}

/// Appends fields of numbers, a comma behind each.
pub fn push_values<'v>(line: &mut String, values: impl IntoIterator<Item = &'v f64>) {
    for value in values {
        let _ = write!(line, "{value:.16e},");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_come_back_exactly() {
        let values = [0.1, -1.0 / 3.0, 5e-324, f64::MAX, 0.0, -0.0, 1e22];
        let mut line = String::new();
        push_row(&mut line, &values);
        let back: Vec<f64> = line.trim().split(',').map(|f| f.parse().unwrap()).collect();
        assert_eq!(back, values);
        assert!(line.starts_with("1.0000000000000001e-1,"), "{line}");
    }

    #[test]
    fn the_header_is_names_alone() {
        let mut line = String::new();
        push_header(&mut line, ["t", "crank.angle", "a,\"b\""].into_iter());
        assert_eq!(line, "t,crank.angle,\"a,\"\"b\"\"\"\n");
    }
}
