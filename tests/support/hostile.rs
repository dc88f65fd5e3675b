//! Scenes whose words try to be more than words.

/// A scene with these words wherever a scene has words.
pub fn scene(words: &str) -> String {
    // All as codes: RON's own signs are not what is tried here.
    let words: String = words.chars().map(|c| format!("\\u{{{:x}}}", u32::from(c))).collect();
    format!(
        r#"(
            title: "{words}",
            caption: "{words}",
            bodies: [
                (name: "{words}", shape: Rectangle(20, 20), medium: Index(1.5)),
                (label: "{words}", shape: Rectangle(10, 30), at: (40, 0), medium: Index(1.3)),
                (name: "{words}2", label: "{words}", shape: Flat(from: (70, -20), to: (70, 20)), surface: Screen),
                (shape: Flat(from: (55, -20), to: (55, 20)), surface: ThinLens(focal_length: 30)),
            ],
            sources: [
                (name: "{words}", light: Beam(center: (-30, 0), direction: Angle(1), width: 8, rays: 20), spectrum: Line(550)),
                (name: "{words}2", light: Object(from: (-40, 0), to: (-40, 6)), spectrum: Line(550)),
            ],
            notes: [(at: (0, -30), text: "{words}")],
        )"#
    )
}

/// Whether a body can have this name.
pub fn is_name(words: &str) -> bool {
    !words.trim().is_empty() && !words.starts_with('#')
}

/// Words that are markup, a command, a formula or a sign for a terminal somewhere.
pub const PIECES: [&str; 44] = [
    "<script>alert(1)</script>",
    "<script>top.document.documentElement.id='RUN'</script>",
    "<img src=x onerror=\"top.document.documentElement.id='RUN'\">",
    "\" onload=\"top.document.documentElement.id='RUN'\" x=\"",
    "' onload='top.document.documentElement.id=\"RUN\"' x='",
    "</text></svg><script>top.document.documentElement.id='RUN'</script>",
    "]]>",
    "<![CDATA[",
    "<!-- -->",
    "--",
    "&lt;b&gt; &#60;",
    "&",
    "<?xml?>",
    "<!DOCTYPE x [<!ENTITY a \"b\">]>",
    "\u{0}\u{1}\u{b}\u{1f}\u{7f}\u{80}\u{9b}\u{9f}",
    "\u{fffe}\u{ffff}",
    "\u{1b}]0;title\u{7}\u{1b}[2J",
    "\\",
    "\\input{/etc/passwd}",
    "\\write18{true}",
    "^^5cinput",
    "%",
    "$x$ $$",
    "{}}{",
    "#1 ~ _a_ ^2",
    "?` !` `` '' ,, << >>",
    "=1+1",
    "+1",
    "-1",
    "@SUM(1)",
    ";=1+1;\"=2\"",
    "=HYPERLINK(\"http://example.org\";\"x\")",
    "'=1",
    "[link](http://example.org) ![image](x.png)",
    "https://example.org www.example.org mailto:a@example.org",
    "*a* **b** ~~c~~ `d` | e |",
    "\n# heading\n- item\n1. item\n> quote\n---\n",
    "\r\n\t",
    "\u{202e}desrever\u{202c} \u{2067}\u{2069}\u{200f}",
    "\u{5e9}\u{5dc}\u{5d5}\u{5dd} 12",
    "\u{636}\u{648}\u{621} \u{633}\u{644}\u{627}\u{645}",
    "\u{200b}\u{200d}\u{feff}\u{2028}",
    "e\u{301} \u{1f642}\u{200d}\u{1f308} \u{5149}",
    "Donaudampfschifffahrtsgesellschaftskapit\u{e4}nsm\u{fc}tzenabzeichenfabrikationsunternehmensgr\u{fc}ndungsfest",
];

/// All of them.
pub fn all() -> String {
    PIECES.join(" ")
}
