//! From identifiers to mathematical notation: `sigma0` is written `\sigma_0` and `φ1⁰` is
//! `\varphi_1^0`.
//!
//! Trailing digits and whatever follows an underscore become subscripts, superscript digits become
//! superscripts, Greek letters may be spelled out or typed. Nothing is guessed: `Fp` stays one word.

/// Names of Greek letters, the letter, and its LaTeX command (empty where the letter looks Latin).
const GREEK: [(&str, char, &str); 51] = [
    ("alpha", 'α', r"\alpha"),
    ("beta", 'β', r"\beta"),
    ("gamma", 'γ', r"\gamma"),
    ("delta", 'δ', r"\delta"),
    ("epsilon", 'ε', r"\varepsilon"),
    ("zeta", 'ζ', r"\zeta"),
    ("eta", 'η', r"\eta"),
    ("theta", 'θ', r"\theta"),
    ("iota", 'ι', r"\iota"),
    ("kappa", 'κ', r"\kappa"),
    ("lambda", 'λ', r"\lambda"),
    ("mu", 'μ', r"\mu"),
    ("nu", 'ν', r"\nu"),
    ("xi", 'ξ', r"\xi"),
    ("omicron", 'ο', "o"),
    ("pi", 'π', r"\pi"),
    ("rho", 'ρ', r"\rho"),
    ("sigma", 'σ', r"\sigma"),
    ("tau", 'τ', r"\tau"),
    ("upsilon", 'υ', r"\upsilon"),
    ("phi", 'φ', r"\varphi"),
    ("chi", 'χ', r"\chi"),
    ("psi", 'ψ', r"\psi"),
    ("omega", 'ω', r"\omega"),
    ("Alpha", 'Α', r"\mathrm{A}"),
    ("Beta", 'Β', r"\mathrm{B}"),
    ("Gamma", 'Γ', r"\Gamma"),
    ("Delta", 'Δ', r"\Delta"),
    ("Epsilon", 'Ε', r"\mathrm{E}"),
    ("Zeta", 'Ζ', r"\mathrm{Z}"),
    ("Eta", 'Η', r"\mathrm{H}"),
    ("Theta", 'Θ', r"\Theta"),
    ("Iota", 'Ι', r"\mathrm{I}"),
    ("Kappa", 'Κ', r"\mathrm{K}"),
    ("Lambda", 'Λ', r"\Lambda"),
    ("Mu", 'Μ', r"\mathrm{M}"),
    ("Nu", 'Ν', r"\mathrm{N}"),
    ("Xi", 'Ξ', r"\Xi"),
    ("Omicron", 'Ο', r"\mathrm{O}"),
    ("Pi", 'Π', r"\Pi"),
    ("Rho", 'Ρ', r"\mathrm{P}"),
    ("Sigma", 'Σ', r"\Sigma"),
    ("Tau", 'Τ', r"\mathrm{T}"),
    ("Upsilon", 'Υ', r"\Upsilon"),
    ("Phi", 'Φ', r"\Phi"),
    ("Chi", 'Χ', r"\mathrm{X}"),
    ("Psi", 'Ψ', r"\Psi"),
    ("Omega", 'Ω', r"\Omega"),
    ("vartheta", 'ϑ', r"\vartheta"),
    ("varphi", 'ϕ', r"\phi"),
    ("varsigma", 'ς', r"\varsigma"),
];

/// The LaTeX of an identifier, for use in mathematics.
///
/// ```
/// use flexure_model_dsl::notation::latex_of;
/// assert_eq!(latex_of("φ1"), r"\varphi_{1}");
/// assert_eq!(latex_of("mu_s"), r"\mu_{s}");
/// assert_eq!(latex_of("Fp"), r"\mathit{Fp}");
/// ```
pub fn latex_of(identifier: &str) -> String {
    let parts: Vec<String> = identifier.split('.').map(latex_of_part).collect();
    parts.join("{.}")
}

/// One part of a name between dots.
fn latex_of_part(name: &str) -> String {
    let superscripts: Vec<char> = name.chars().rev().map_while(superscript_digit).collect();
    let name: String = {
        let count = name.chars().count() - superscripts.len();
        name.chars().take(count).map(plain_digit).collect()
    };
    let mut pieces = name.split('_').filter(|piece| !piece.is_empty());
    let first = pieces.next().unwrap_or_default();
    let letters = first.trim_end_matches(|c: char| c.is_ascii_digit());
    let mut subscripts: Vec<String> = Vec::new();
    if letters.len() < first.len() && !letters.is_empty() {
        subscripts.push(first[letters.len()..].to_owned());
    }
    subscripts.extend(pieces.map(|piece| word(piece, "mathrm")));
    let mut latex = if letters.is_empty() {
        word(first, "mathrm")
    } else {
        word(letters, "mathit")
    };
    if !subscripts.is_empty() {
        latex = format!("{latex}_{{{}}}", subscripts.join(","));
    }
    if !superscripts.is_empty() {
        let digits: String = superscripts.iter().rev().collect();
        latex = format!("{latex}^{{{digits}}}");
    }
    latex
}

/// A word without underscores: a letter, a Greek letter, or an upright or slanted word.
fn word(text: &str, face: &str) -> String {
    let mut latex = String::new();
    let mut run = String::new();
    if let Some(command) = greek_word(text) {
        return command;
    }
    for c in text.chars() {
        match GREEK.iter().find(|(_, letter, _)| *letter == c) {
            Some((_, _, command)) => {
                push_run(&mut latex, &mut run, face);
                push_spaced(&mut latex, command);
            }
            None => run.push(c),
        }
    }
    push_run(&mut latex, &mut run, face);
    latex
}

/// A spelled-out Greek letter, perhaps with digits behind it (`sigma0` as a subscript).
fn greek_word(text: &str) -> Option<String> {
    let letters = text.trim_end_matches(|c: char| c.is_ascii_digit());
    let (_, _, command) = GREEK.iter().find(|(name, _, _)| *name == letters)?;
    let digits = &text[letters.len()..];
    Some(if digits.is_empty() {
        (*command).to_owned()
    } else {
        format!("{command} {digits}")
    })
}

fn push_run(latex: &mut String, run: &mut String, face: &str) {
    if run.is_empty() {
        return;
    }
    let run = std::mem::take(run);
    if run.chars().all(|c| c.is_ascii_alphanumeric()) {
        let bare = run.chars().count() == 1 || run.chars().all(|c| c.is_ascii_digit());
        if bare {
            push_spaced(latex, &run);
        } else {
            push_spaced(latex, &format!(r"\{face}{{{run}}}"));
        }
    } else {
        push_spaced(latex, &format!(r"\text{{{}}}", escape_latex(&run)));
    }
}

/// Appends so that a command before does not swallow a letter behind it.
fn push_spaced(latex: &mut String, next: &str) {
    let command_ends = latex
        .rsplit('\\')
        .next()
        .is_some_and(|tail| tail.len() < latex.len() && tail.chars().all(char::is_alphabetic));
    if command_ends && next.starts_with(|c: char| c.is_ascii_alphabetic()) {
        latex.push(' ');
    }
    latex.push_str(next);
}

fn superscript_digit(c: char) -> Option<char> {
    "⁰¹²³⁴⁵⁶⁷⁸⁹"
        .chars()
        .zip('0'..='9')
        .find_map(|(raised, digit)| (raised == c).then_some(digit))
}

/// Subscript digits as plain ones.
fn plain_digit(c: char) -> char {
    "₀₁₂₃₄₅₆₇₈₉"
        .chars()
        .zip('0'..='9')
        .find_map(|(lowered, digit)| (lowered == c).then_some(digit))
        .unwrap_or(c)
}

/// Words for LaTeX text mode: special characters are escaped.
pub fn escape_latex(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '#' | '$' | '%' | '&' | '_' | '{' | '}' => {
                escaped.push('\\');
                escaped.push(c);
            }
            '~' => escaped.push_str(r"\textasciitilde{}"),
            '^' => escaped.push_str(r"\textasciicircum{}"),
            '\\' => escaped.push_str(r"\textbackslash{}"),
            '<' => escaped.push_str(r"\textless{}"),
            '>' => escaped.push_str(r"\textgreater{}"),
            '|' => escaped.push_str(r"\textbar{}"),
            '"' => escaped.push_str(r"\textquotedbl{}"),
            c => match GREEK.iter().find(|(_, letter, _)| *letter == c) {
                Some((_, _, command)) => escaped.push_str(&format!(r"\ensuremath{{{command}}}")),
                None => escaped.push(c),
            },
        }
    }
    escaped
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identifiers_become_notation() {
        for (identifier, latex) in [
            ("l1", r"l_{1}"),
            ("φ1", r"\varphi_{1}"),
            ("phi1", r"\varphi_{1}"),
            ("φ1⁰", r"\varphi_{1}^{0}"),
            ("φ₁₂", r"\varphi_{12}"),
            ("sigma0", r"\sigma_{0}"),
            ("mu_s", r"\mu_{s}"),
            ("F_p", r"F_{p}"),
            ("Fp", r"\mathit{Fp}"),
            ("v_max", r"v_{\mathrm{max}}"),
            ("l1_x", r"l_{1,x}"),
            ("k_theta", r"k_{\theta}"),
            ("k_sigma0", r"k_{\sigma 0}"),
            ("Δφ", r"\Delta\varphi"),
            ("Δx", r"\Delta x"),
            ("E", "E"),
            ("_", ""),
            ("_1", "1"),
            ("é", r"\text{é}"),
            ("stage.v", r"\mathit{stage}{.}v"),
            ("Alpha", r"\mathrm{A}"),
        ] {
            assert_eq!(latex_of(identifier), latex, "{identifier}");
        }
    }

    #[test]
    fn greek_letters_are_distinct() {
        for (index, (name, letter, command)) in GREEK.iter().enumerate() {
            assert!(!command.is_empty());
            for (other, other_letter, _) in &GREEK[..index] {
                assert!(name != other && letter != other_letter);
            }
        }
    }

    #[test]
    fn specials_are_escaped() {
        assert_eq!(escape_latex("angle φ"), r"angle \ensuremath{\varphi}");
        assert_eq!(
            escape_latex(r"50 % & #1_{a}^2 \n"),
            r"50 \% \& \#1\_\{a\}\textasciicircum{}2 \textbackslash{}n"
        );
    }
}
