//! The few means that all pictures share: escaping, colours, and thinning of long curves.

use std::borrow::Cow;

/// Number of colours for curves; `var(--curve0)` and so on in the style sheets. They differ also to
/// eyes that take red for green, and in lightness.
pub const CURVE_COLOURS: usize = 6;
/// Number of colours of levels that have an order: `var(--level0)` is the lowest and faintest.
pub const LEVEL_COLOURS: usize = 7;

/// Colours and text of a picture that stands alone, on white paper.
pub const PAPER: &str = "\
--curve0:#1a5fd0;--curve1:#8a3a0c;--curve2:#1da56b;--curve3:#d9359b;--curve4:#ab890e;--curve5:#2b3139;\
--level0:#e3a11f;--level1:#e07b2a;--level2:#cf4f4a;--level3:#a92f74;--level4:#7a1f8f;--level5:#4a1b8c;--level6:#1f1769;\
--holds:#1b7f4f;--partly:#9a6a00;--fails:#b3261e;\
--paper:#ffffff;--ink:#1c2530;--soft:#5b6774;--grid:#e4e8ec;--frame:#aab4be;\
--body:#dbe7f3;--body-edge:#2d5f8f;--piezo:#f3d9c4;--piezo-edge:#a8571f;--spring:#2b8a57;--contact:#c0392b;";

/// The same in the dark.
pub const NIGHT: &str = "\
--curve0:#3f9df5;--curve1:#d9693f;--curve2:#3fe09a;--curve3:#f75f9f;--curve4:#e8b23a;--curve5:#d3d7dd;\
--level0:#6a5be0;--level1:#8a52d8;--level2:#b95ac6;--level3:#e06aa0;--level4:#f28a72;--level5:#f7b14f;--level6:#f6dc5a;\
--holds:#58c98f;--partly:#e0b040;--fails:#f28b82;\
--paper:#14191f;--ink:#e6ebf0;--soft:#9aa7b4;--grid:#28313a;--frame:#4a5662;\
--body:#21364a;--body-edge:#7db3e3;--piezo:#47311f;--piezo-edge:#f2a56b;--spring:#5fc48d;--contact:#f07264;";

/// Rules for the classes that pictures use.
pub const RULES: &str = "\
svg .mark{stroke:var(--paper);stroke-width:.8}svg .dashed{stroke-dasharray:6 4}\
svg .band{fill:var(--soft);opacity:.13}svg .window{stroke-width:5;opacity:.55;fill:none}\
svg .reference{stroke:var(--soft);stroke-width:1.2;stroke-dasharray:2 3;fill:none}\
svg .leader{stroke:var(--frame);stroke-width:1;fill:none}svg .minor{stroke:var(--grid);stroke-width:.5;fill:none}\
svg .failed{stroke-width:1.8;fill:none}svg .halo{paint-order:stroke;stroke:var(--paper);stroke-width:3.5px;stroke-linejoin:round}\
svg text{font-family:Inter,'Segoe UI',Helvetica,Arial,sans-serif;font-size:12px;fill:var(--ink)}\
svg .soft{fill:var(--soft)}svg .title{font-weight:600}svg .name{font-size:12.5px;paint-order:stroke;stroke:var(--paper);stroke-width:4px;stroke-linejoin:round}\
svg .body-name{font-style:italic}\
svg .grid{stroke:var(--grid);stroke-width:1;fill:none}svg .frame{stroke:var(--frame);stroke-width:1;fill:none}\
svg .curve{fill:none;stroke-width:1.5;stroke-linejoin:round;stroke-linecap:round}\
svg .ink{stroke:var(--ink);stroke-width:1.4;fill:none;stroke-linecap:round;stroke-linejoin:round}\
svg .thin{stroke:var(--soft);stroke-width:1;fill:none;stroke-linecap:round}\
svg .link{fill:var(--body);stroke:var(--body-edge);stroke-width:1.6;stroke-linejoin:round}\
svg .pin{fill:var(--paper);stroke:var(--body-edge);stroke-width:1.8}\
svg .slide{fill:var(--body);stroke:var(--body-edge);stroke-width:1.6;stroke-linejoin:round}\
svg .spring{fill:none;stroke:var(--spring);stroke-width:1.6;stroke-linejoin:round;stroke-linecap:round}\
svg .piezo{fill:var(--piezo);stroke:var(--piezo-edge);stroke-width:1.4;stroke-linejoin:round}\
svg .contact{fill:none;stroke:var(--contact);stroke-width:2;stroke-linecap:round;stroke-linejoin:round}";

/// Text with what HTML and XML would take for markup written out; characters that XML cannot hold
/// at all become the replacement character.
pub fn escape(text: &str) -> Cow<'_, str> {
    let special = |c: char| {
        matches!(c, '&' | '<' | '>' | '"' | '\'')
            || (c.is_control() && !matches!(c, '\n' | '\t' | '\r'))
            || matches!(c, '\u{fffe}' | '\u{ffff}')
    };
    if !text.contains(special) {
        return Cow::Borrowed(text);
    }
    let mut escaped = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            c if special(c) => escaped.push('\u{fffd}'),
            c => escaped.push(c),
        }
    }
    Cow::Owned(escaped)
}

/// A coordinate in pixels: a tenth is finer than anyone sees.
pub fn pixel(value: f64) -> String {
    let text = format!("{value:.1}");
    match text.strip_suffix(".0") {
        Some("-0") => "0".to_owned(),
        Some(whole) => whole.to_owned(),
        None => text,
    }
}

/// Indices of the samples that draw a curve over `columns` columns of pixels as all of them would:
/// the first, lowest, highest and last of each column. `position` is the column of a sample.
pub fn thinned(values: &[f64], columns: usize, position: impl Fn(usize) -> f64) -> Vec<usize> {
    if values.len() <= 4 * columns {
        return (0..values.len()).collect();
    }
    let mut kept = Vec::with_capacity(4 * columns);
    let mut start = 0;
    while start < values.len() {
        let column = position(start).floor();
        let mut end = start + 1;
        while end < values.len() && position(end).floor() == column {
            end += 1;
        }
        let by = |better: fn(f64, f64) -> bool| {
            (start..end).fold(start, |best, k| {
                if values[best].is_nan() || better(values[k], values[best]) {
                    k
                } else {
                    best
                }
            })
        };
        let mut of_column = [start, by(|a, b| a < b), by(|a, b| a > b), end - 1];
        of_column.sort_unstable();
        for index in of_column {
            if kept.last() != Some(&index) {
                kept.push(index);
            }
        }
        start = end;
    }
    kept
}

/// About how wide a text in the pictures' size is, in pixels.
pub fn text_width(text: &str) -> f64 {
    text.chars()
        .map(|c| match c {
            'i' | 'l' | 'j' | 't' | 'f' | 'r' | '.' | ',' | ' ' | '\'' => 3.9,
            'm' | 'w' | 'M' | 'W' => 10.0,
            'A'..='Z' => 8.4,
            c if (c as u32) >= 0x1100 => 12.5,
            _ => 6.9,
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_is_written_out() {
        assert_eq!(
            escape("a<b & \"c\" 'd'\u{7}"),
            "a&lt;b &amp; &quot;c&quot; &#39;d&#39;\u{fffd}"
        );
        assert!(matches!(escape("φ1 plain"), Cow::Borrowed(_)));
    }

    #[test]
    fn thinning_keeps_every_peak() {
        let mut values = vec![0.0; 100_000];
        values[54_321] = 7.0;
        values[12_345] = -3.0;
        let kept = thinned(&values, 100, |k| k as f64 / 1000.0);
        assert!(kept.len() <= 400, "{}", kept.len());
        assert!(kept.contains(&54_321) && kept.contains(&12_345));
        assert!(kept.is_sorted());
        assert_eq!((kept[0], kept[kept.len() - 1]), (0, 99_999));
    }
}
