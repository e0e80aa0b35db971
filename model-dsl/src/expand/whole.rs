//! Whole numbers as they are written in `const`, `repeat` and indices: sums of products of digits,
//! constants and counters.

/// The value of `text`; `known` gives constants and counters.
///
/// # Errors
/// What is wrong, as a message.
pub(super) fn whole(text: &str, known: &dyn Fn(&str) -> Option<i64>) -> Result<i64, String> {
    let mut sum: i64 = 0;
    let mut product: i64 = 1;
    let mut factor = String::new();
    let too_large = || format!("`{}` is too large", text.trim());
    let close = |factor: &mut String, product: &mut i64| -> Result<(), String> {
        let word = std::mem::take(factor);
        let value = match word.parse::<i64>() {
            Ok(value) => value,
            Err(_) if word.chars().all(|c| c.is_ascii_digit()) => return Err(too_large()),
            Err(_) => known(&word)
                .ok_or_else(|| format!("`{word}` is neither a constant nor a counter"))?,
        };
        *product = product.checked_mul(value).ok_or_else(too_large)?;
        Ok(())
    };
    for c in text.chars() {
        match c {
            ' ' | '\t' => {}
            '-' if factor.is_empty() => product = product.checked_neg().ok_or_else(too_large)?,
            '*' => close(&mut factor, &mut product)?,
            '+' | '-' => {
                close(&mut factor, &mut product)?;
                sum = sum.checked_add(product).ok_or_else(too_large)?;
                product = if c == '-' { -1 } else { 1 };
            }
            c => factor.push(c),
        }
    }
    close(&mut factor, &mut product)?;
    sum.checked_add(product).ok_or_else(too_large)
}

/// `up[i+1]` as one word, `up3`; after a digit an underscore comes first.
///
/// # Errors
/// What is wrong with an index, as a message.
pub(super) fn indexed(label: &str, known: &dyn Fn(&str) -> Option<i64>) -> Result<String, String> {
    let mut parts = label.split('[');
    let mut word = parts.next().unwrap_or_default().to_owned();
    for index in parts {
        let index = index.trim_end_matches([']', ' ', '\t']);
        let value = whole(index, known)?;
        if value < 0 {
            return Err(format!(
                "the index `{}` is {value}, which is negative",
                index.trim()
            ));
        }
        if word.ends_with(|c: char| c.is_ascii_digit()) {
            word.push('_');
        }
        word += &value.to_string();
    }
    Ok(word)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn known(name: &str) -> Option<i64> {
        (name == "i").then_some(3)
    }

    #[test]
    fn sums_of_products() {
        assert_eq!(whole("2*i - 1 + 4", &known), Ok(9));
        assert_eq!(whole("-i*2", &known), Ok(-6));
        assert!(whole("99999999999999999999", &known).is_err());
        assert!(whole("9223372036854775807 + i", &known).is_err());
        assert!(whole("k", &known).is_err());
    }

    #[test]
    fn indices_become_part_of_the_word() {
        assert_eq!(indexed("up[i+1]", &known), Ok("up4".to_owned()));
        assert_eq!(indexed("x1[ i ]", &known), Ok("x1_3".to_owned()));
        assert_eq!(indexed("B[i][2]", &known), Ok("B3_2".to_owned()));
        assert_eq!(indexed("plain", &known), Ok("plain".to_owned()));
        assert!(indexed("B[i-4]", &known).is_err());
    }
}
