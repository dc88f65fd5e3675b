//! Explanations as plain text, Markdown and LaTeX.

use std::io::{self, Write};

use super::document::{Block, Item, Part, Piece, document};
use super::math::{Letter, Notation};
use super::step::Explanation;
use crate::report::in_memory;

/// Explanations of rays of one scene as plain text, formulas in Unicode.
#[must_use]
pub fn text(explanations: &[Explanation], part: Part) -> String {
    in_memory(|out| write_text(out, explanations, part))
}

/// Writes what [`text`] returns.
///
/// # Errors
/// When `out` cannot be written.
pub fn write_text(out: &mut impl Write, explanations: &[Explanation], part: Part) -> io::Result<()> {
    blocks(out, explanations, part, |block| match block {
        Block::Title(title) => format!("{title}\n{}\n", "=".repeat(title.chars().count())),
        Block::Ray(ray) => format!("{ray}\n{}\n", "-".repeat(ray.chars().count())),
        Block::Hit(hit) => format!("{hit}\n"),
        Block::Say(pieces) => said(pieces, Notation::Plain, str::to_owned, |math| math) + "\n",
        Block::Items(items) => items.iter().map(text_item).collect(),
    })
}

fn text_item(item: &Item) -> String {
    format!("  {:5} {}\n", item.number, with_remark(item.math(Notation::Plain), &item.remark()))
}

/// Explanations of rays of one scene as Markdown, formulas in LaTeX between dollar signs.
#[must_use]
pub fn markdown(explanations: &[Explanation], part: Part) -> String {
    in_memory(|out| write_markdown(out, explanations, part))
}

/// Writes what [`markdown`] returns.
///
/// # Errors
/// When `out` cannot be written.
pub fn write_markdown(out: &mut impl Write, explanations: &[Explanation], part: Part) -> io::Result<()> {
    blocks(out, explanations, part, |block| match block {
        Block::Title(title) => format!("# {}\n", markdown_words(title)),
        Block::Ray(ray) => format!("## {}\n", markdown_words(ray)),
        Block::Hit(hit) => format!("### {}\n", markdown_words(hit)),
        Block::Say(pieces) => said(pieces, Notation::Latex, markdown_words, dollars) + "\n",
        Block::Items(items) => items.iter().map(markdown_item).collect(),
    })
}

fn markdown_item(item: &Item) -> String {
    let (math, remark) = (dollars(item.math(Notation::Latex)), markdown_words(&item.remark()));
    format!("- **{}** {}\n", item.number, with_remark(math, &remark))
}

/// Explanations of rays of one scene as a LaTeX document that needs nothing but `amsmath`. A character that its usual fonts
/// lack is written as its code, such as `[U+5149]`.
#[must_use]
pub fn latex(explanations: &[Explanation], part: Part) -> String {
    in_memory(|out| write_latex(out, explanations, part))
}

/// Writes what [`latex`] returns.
///
/// # Errors
/// When `out` cannot be written.
pub fn write_latex(out: &mut impl Write, explanations: &[Explanation], part: Part) -> io::Result<()> {
    writeln!(out, "{PREAMBLE}")?;
    blocks(out, explanations, part, |block| match block {
        Block::Title(title) => format!("\\section*{{{}}}\n", latex_words(title)),
        Block::Ray(ray) => format!("\\subsection*{{{}}}\n", latex_words(ray)),
        Block::Hit(hit) => format!("\\subsubsection*{{{}}}\n", latex_words(hit)),
        Block::Say(pieces) => said(pieces, Notation::Latex, latex_words, dollars) + "\n",
        Block::Items(items) => {
            let items: String = items.iter().map(latex_item).collect();
            format!("\\begin{{description}}\n{items}\\end{{description}}\n")
        }
    })?;
    writeln!(out, "\n\\end{{document}}")
}

const PREAMBLE: &str = r"\documentclass[a4paper]{article}
\usepackage[utf8]{inputenc}
\usepackage[T1]{fontenc}
\usepackage{textcomp}
\usepackage{amsmath}
\usepackage[margin=22mm]{geometry}
\setlength{\parindent}{0pt}
\sloppy
\begin{document}
";

fn latex_item(item: &Item) -> String {
    let (math, remark) = (dollars(item.math(Notation::Latex)), latex_words(&item.remark()));
    format!("\\item[{}] {}\n", item.number, with_remark(math, &remark))
}

/// Writes everything, an empty line between the blocks.
fn blocks(
    out: &mut impl Write,
    explanations: &[Explanation],
    part: Part,
    written: impl Fn(&Block) -> String,
) -> io::Result<()> {
    for (k, block) in document(explanations, part).enumerate() {
        let gap = if k == 0 { "" } else { "\n" };
        write!(out, "{gap}{}", written(&block))?;
    }
    Ok(())
}

fn dollars(math: String) -> String {
    format!("${math}$")
}

fn with_remark(math: String, remark: &str) -> String {
    if remark.is_empty() { math } else { format!("{math}, {remark}") }
}

/// A sentence, its words and its formulas each written in their way.
fn said(
    pieces: &[Piece],
    notation: Notation,
    words: impl Fn(&str) -> String,
    math: impl Fn(String) -> String,
) -> String {
    let given = |letter: &Letter| {
        let value = letter.value.as_ref().map(|value| value.write(notation)).unwrap_or_default();
        math(format!("{} = {value}", letter.write(notation)))
    };
    let piece = |piece: &Piece| match piece {
        Piece::Words(said) => words(said),
        Piece::Given(letter) => given(letter),
    };
    pieces.iter().map(piece).collect()
}

/// Words in which Markdown finds no markup.
fn markdown_words(words: &str) -> String {
    let mut before = ' ';
    let mut escaped = String::with_capacity(words.len());
    for c in words.chars() {
        // Some make links of `https://…`, `www.…` and addresses without being asked.
        let is_link = (before, c) == (':', '/') || c == '.' && ends_in_www(&escaped);
        if is_link || r"\`*_{}[]<>#|$~&@^".contains(c) {
            escaped.push('\\');
        }
        escaped.push(c);
        before = c;
    }
    escaped
}

fn ends_in_www(words: &str) -> bool {
    let end = words.len().checked_sub(3).and_then(|start| words.get(start..));
    end.is_some_and(|end| end.eq_ignore_ascii_case("www"))
}

/// Words in which LaTeX finds no command, in characters that its usual fonts have.
fn latex_words(words: &str) -> String {
    let mut written = String::new();
    let mut before = ' ';
    for c in words.chars() {
        // Two of these would become one other sign.
        if c == before && "-',".contains(c) {
            written.push_str("{}");
        }
        written.push_str(&latex_character(c));
        before = c;
    }
    written
}

fn latex_character(c: char) -> String {
    match c {
        '\\' => r"\textbackslash{}".into(),
        '~' => r"\textasciitilde{}".into(),
        '^' => r"\textasciicircum{}".into(),
        '{' | '}' | '#' | '$' | '%' | '&' | '_' => format!(r"\{c}"),
        '<' => r"\textless{}".into(),
        '>' => r"\textgreater{}".into(),
        '"' => r"\textquotedbl{}".into(),
        '`' => r"\textasciigrave{}".into(),
        '°' => r"\textdegree{}".into(),
        _ => match MATH.iter().find(|(known, _)| *known == c) {
            Some((_, command)) => format!("${command}$"),
            None if is_in_t1(c) => c.into(),
            None => format!("[U+{:04X}]", u32::from(c)),
        },
    }
}

/// Whether LaTeX's usual fonts have a character, in the encoding T1 with `textcomp`.
fn is_in_t1(c: char) -> bool {
    let is_latin = ('\u{a0}'..'\u{180}').contains(&c) && !"ĦħĸĿŀŉŦŧſ".contains(c);
    c.is_ascii() || is_latin || "–—‘’“”…".contains(c)
}

/// Characters of titles and names that LaTeX's text fonts lack.
const MATH: [(char, &str); 40] = [
    ('α', r"\alpha"),
    ('β', r"\beta"),
    ('γ', r"\gamma"),
    ('δ', r"\delta"),
    ('ε', r"\varepsilon"),
    ('η', r"\eta"),
    ('θ', r"\theta"),
    ('λ', r"\lambda"),
    ('μ', r"\mu"),
    ('ν', r"\nu"),
    ('π', r"\pi"),
    ('ρ', r"\rho"),
    ('σ', r"\sigma"),
    ('τ', r"\tau"),
    ('φ', r"\varphi"),
    ('χ', r"\chi"),
    ('ψ', r"\psi"),
    ('ω', r"\omega"),
    ('Δ', r"\Delta"),
    ('Σ', r"\Sigma"),
    ('Ω', r"\Omega"),
    ('∞', r"\infty"),
    ('→', r"\to"),
    ('←', r"\leftarrow"),
    ('≤', r"\le"),
    ('≥', r"\ge"),
    ('≈', r"\approx"),
    ('≠', r"\ne"),
    ('−', "-"),
    ('√', r"\surd"),
    ('′', "'"),
    ('₀', "_0"),
    ('₁', "_1"),
    ('₂', "_2"),
    ('₃', "_3"),
    ('₄', "_4"),
    ('∠', r"\angle"),
    ('∙', r"\cdot"),
    ('⊥', r"\perp"),
    ('∥', r"\parallel"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_no_markup() {
        assert_eq!(markdown_words("a*b_c [x](y) <i> $1 #2"), r"a\*b\_c \[x\](y) \<i\> \$1 \#2");
        assert_eq!(markdown_words("n. w. www.a https://a a@b ^1 &lt;"), r"n. w. www\.a https:\//a a\@b \^1 \&lt;");
        assert_eq!(
            latex_words(r"50% of #1_a & {b} \x^~$"),
            concat!(r"50\% of \#1\_a \& \{b\} ", r"\textbackslash{}x\textasciicircum{}\textasciitilde{}\$")
        );
    }

    #[test]
    fn characters_that_latex_lacks_are_written_otherwise() {
        assert_eq!(latex_words("θ → 45°, Größe"), r"$\theta$ $\to$ 45\textdegree{}, Größe");
        assert_eq!(latex_words("光ħ"), "[U+5149][U+0127]");
        assert_eq!(
            latex_words(r#"<"a"> -- '' ?` ,,"#),
            r"\textless{}\textquotedbl{}a\textquotedbl{}\textgreater{} -{}- '{}' ?\textasciigrave{} ,{},"
        );
    }
}
