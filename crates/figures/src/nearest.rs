//! Which of several names was probably meant.

/// The name that takes the fewest letters put in, left out or changed to come from `typed`; none if all take more than
/// a third of its letters.
pub(crate) fn nearest<'a>(typed: &str, names: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let letters: Vec<char> = typed.chars().collect();
    let distances = names.map(|name| (distance(&letters, name), name));
    let (least, name) = distances.min_by_key(|(distance, _)| *distance)?;
    (3 * least <= letters.len()).then_some(name)
}

/// Wagner and Fischer's: a row a letter of `name`, with the distances from it to the beginnings of `typed`.
fn distance(typed: &[char], name: &str) -> usize {
    let mut row: Vec<usize> = (0..=typed.len()).collect();
    for (i, letter) in name.chars().enumerate() {
        let (mut diagonal, mut left) = (i, i + 1);
        if let Some(first) = row.first_mut() {
            *first = left;
        }
        for (&other, above) in typed.iter().zip(row.iter_mut().skip(1)) {
            let changed = diagonal + usize::from(other != letter);
            diagonal = *above;
            left = changed.min(left + 1).min(*above + 1);
            *above = left;
        }
    }
    row.last().copied().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn between(a: &str, b: &str) -> usize {
        distance(&a.chars().collect::<Vec<_>>(), b)
    }

    #[test]
    fn distances_by_hand() {
        for (a, b, expected) in [
            ("", "", 0),
            ("", "abc", 3),
            ("kitten", "sitting", 3),
            ("flaw", "lawn", 2),
            ("zbufer", "zbuffer", 1),
            ("ab", "ba", 2),
            ("šum", "sum", 1),
        ] {
            assert_eq!(between(a, b), expected, "{a} {b}");
            assert_eq!(between(b, a), expected, "{b} {a}");
        }
    }

    #[test]
    fn what_is_far_from_all_has_no_nearest() {
        let names = || ["raster", "clip/outcodes", "hsr/back-face"].into_iter();
        assert_eq!(nearest("rastr", names()), Some("raster"));
        assert_eq!(nearest("hsr/backface", names()), Some("hsr/back-face"));
        assert_eq!(nearest("radiosity", names()), None);
        assert_eq!(nearest("", names()), None);
        assert_eq!(nearest("raster", [].into_iter()), None);
    }
}
