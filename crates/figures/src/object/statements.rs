//! The statements of an OBJ text: lines without their comments, those that end in `\` joined to the next.

use std::borrow::Cow;

/// The statements with the number of the line that each begins on, from 1 on. Lines end in LF, CR LF or CR.
pub(super) fn statements(text: &str) -> impl Iterator<Item = (usize, Cow<'_, str>)> {
    let mut lines = (1..).zip(Lines(text));
    core::iter::from_fn(move || {
        let (number, line) = lines.next()?;
        let line = without_comment(line);
        let Some(begun) = line.strip_suffix('\\') else {
            return Some((number, Cow::Borrowed(line)));
        };
        let mut whole = begun.to_owned();
        for (_, line) in lines.by_ref() {
            let line = without_comment(line);
            let more = line.strip_suffix('\\');
            whole.push(' ');
            whole.push_str(more.unwrap_or(line));
            if more.is_none() {
                break;
            }
        }
        Some((number, Cow::Owned(whole)))
    })
}

fn without_comment(line: &str) -> &str {
    line.split('#').next().unwrap_or_default().trim_end()
}

/// The lines of a text, without their ends.
struct Lines<'a>(&'a str);

impl<'a> Iterator for Lines<'a> {
    type Item = &'a str;

    fn next(&mut self) -> Option<&'a str> {
        if self.0.is_empty() {
            return None;
        }
        let (line, rest) = self.0.split_once(['\n', '\r']).unwrap_or((self.0, ""));
        let ends_in_cr = self.0.as_bytes().get(line.len()) == Some(&b'\r');
        let after_both = rest.strip_prefix('\n').filter(|_| ends_in_cr);
        self.0 = after_both.unwrap_or(rest);
        Some(line)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Vec<(usize, String)> {
        statements(text).map(|(n, s)| (n, s.into_owned())).collect()
    }

    fn lines(texts: &[(usize, &str)]) -> Vec<(usize, String)> {
        texts.iter().map(|&(n, s)| (n, s.to_owned())).collect()
    }

    #[test]
    fn every_kind_of_line_end_counts_once() {
        let expected = lines(&[(1, "a"), (2, ""), (3, "b"), (4, "c")]);
        for text in [
            "a\n\nb\nc\n",
            "a\r\n\r\nb\r\nc",
            "a\r\rb\rc\r",
            "a\n\r\nb\rc",
        ] {
            assert_eq!(read(text), expected, "{text:?}");
        }
        assert!(read("").is_empty());
        assert_eq!(read("\n"), lines(&[(1, "")]));
    }

    #[test]
    fn a_backslash_joins_lines_and_a_comment_ends_before_it() {
        let text = "f 1 \\\r\n2\\ \t\n 3 # three\\\nv 1 # \\\ng \\ # name\n x\nl \\";
        let expected = lines(&[(1, "f 1  2  3"), (4, "v 1"), (5, "g   x"), (7, "l ")]);
        assert_eq!(read(text), expected);
    }
}
