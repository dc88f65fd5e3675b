//! Which bracket is open where parsing stopped.

use super::node::skip_blank;

/// A bracket that was opened and not closed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Open {
    pub(super) bracket: char,
    pub(super) at: usize,
}

/// The innermost bracket open at byte `end`; brackets in comments and in quotes do not count.
pub(super) fn innermost_open(text: &str, end: usize) -> Option<Open> {
    let mut open = Vec::new();
    let mut at = 0;
    while at < end {
        let rest = &text[at..];
        match rest.chars().next()? {
            '"' => at += quoted(rest),
            '/' => at += (rest.len() - skip_blank(rest).len()).max(1),
            bracket @ ('(' | '[' | '{') => {
                open.push(Open { bracket, at });
                at += 1;
            }
            ')' | ']' | '}' => {
                open.pop();
                at += 1;
            }
            c => at += c.len_utf8(),
        }
    }
    open.pop()
}

/// Bytes of the text in quotes that `rest` begins with.
fn quoted(rest: &str) -> usize {
    let mut escaped = false;
    let ends = |(_, c): &(usize, char)| {
        let end = *c == '"' && !escaped;
        escaped = *c == '\\' && !escaped;
        end
    };
    rest.char_indices().skip(1).find(ends).map_or(rest.len(), |(at, _)| at + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn brackets_in_quotes_and_comments_do_not_count() {
        let text = r#"(title: "a [ \" (", /* [ */ bodies: [(), // {
            "#;
        assert_eq!(innermost_open(text, text.len()), Some(Open { bracket: '[', at: 36 }));
        assert_eq!(innermost_open("([])", 4), None);
    }
}
