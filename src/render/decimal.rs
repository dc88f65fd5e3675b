/// Characters of two commands: a letter, a space and at most twelve for each number.
const LONGEST: usize = 2 * (1 + 1 + 2 * 12);

/// Writes a command of a path, a letter with a point in hundredths of a pixel, as `M1.5 -0.25`.
pub(super) fn push_point(out: &mut String, letter: u8, [x, y]: [i32; 2]) {
    let mut text = Backward::new();
    text.command(letter, x, y);
    out.push_str(text.as_str());
}

/// Writes a line of a path between two points in hundredths of a pixel, as `M1.5 -0.25L7 8`.
pub(super) fn push_line(out: &mut String, [ax, ay, bx, by]: [i32; 4]) {
    let mut text = Backward::new();
    text.command(b'L', bx, by);
    text.command(b'M', ax, ay);
    out.push_str(text.as_str());
}

/// Text that is written from its end.
struct Backward {
    bytes: [u8; LONGEST],
    start: usize,
}

impl Backward {
    fn new() -> Self {
        Self { bytes: [0; LONGEST], start: LONGEST }
    }

    fn as_str(&self) -> &str {
        std::str::from_utf8(&self.bytes[self.start..]).unwrap_or_default()
    }

    fn command(&mut self, letter: u8, x: i32, y: i32) {
        self.number(y);
        self.put(b' ');
        self.number(x);
        self.put(letter);
    }

    fn put(&mut self, byte: u8) {
        self.start -= 1;
        self.bytes[self.start] = byte;
    }

    fn digit(&mut self, number: u32) {
        #[allow(clippy::cast_possible_truncation, reason = "a digit")]
        self.put(b'0' + (number % 10) as u8);
    }

    /// A number of hundredths without trailing zeros.
    fn number(&mut self, hundredths: i32) {
        let size = hundredths.unsigned_abs();
        let (mut whole, part) = (size / 100, size % 100);
        if part != 0 {
            if part % 10 != 0 {
                self.digit(part);
            }
            self.digit(part / 10);
            self.put(b'.');
        }
        self.digit(whole);
        while whole >= 10 {
            whole /= 10;
            self.digit(whole);
        }
        if hundredths < 0 {
            self.put(b'-');
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_as_the_standard_library_does() {
        for k in (-20_000..20_000).chain([i32::MIN, -100_000_000, -99_999_999, 12_345_678, 100_000_000, i32::MAX]) {
            let (mut point, mut line) = (String::new(), String::new());
            push_point(&mut point, b'A', [k, 7]);
            push_line(&mut line, [k, 7, -50, k]);
            let number = f64::from(k) / 100.0;
            assert_eq!((point, line), (format!("A{number} 0.07"), format!("M{number} 0.07L-0.5 {number}")));
        }
    }
}
