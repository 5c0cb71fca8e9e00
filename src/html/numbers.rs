//! Numbers as reports write them.

/// A number of so many digits, its minus as typography has it; a dash where there is none.
pub(crate) fn fixed(value: impl Into<Option<f64>>, digits: usize) -> String {
    match value.into() {
        Some(value) if value.is_finite() => {
            let text = format!("{value:.digits$}");
            // What rounds to zero has no sign.
            if text.bytes().any(|b| (b'1'..=b'9').contains(&b)) { text.replace('-', "−") } else { text.replace('-', "") }
        }
        _ => "–".into(),
    }
}

/// Digits after the point that a number needs for so many significant ones: 12 at most.
fn digits_of(value: f64, wanted: i32) -> usize {
    if value == 0.0 || !value.is_finite() {
        return 0;
    }
    (wanted - 1 - libm::floor(libm::log10(value.abs())) as i32).clamp(0, 12) as usize
}

/// Numbers below this are written with a power of ten.
const LEAST_PLAIN: f64 = 1e-4;

/// A number of three significant digits.
pub(crate) fn significant(value: impl Into<Option<f64>>) -> String {
    match value.into() {
        Some(value) if value != 0.0 && value.abs() < LEAST_PLAIN => format!("{value:.1e}").replace('-', "−"),
        value => fixed(value, value.map_or(0, |value| digits_of(value, 3))),
    }
}

/// A number of one significant digit.
pub(crate) fn rounded(value: f64) -> String {
    fixed(value, digits_of(value, 1))
}

/// Digits after the point that show two significant ones of a standard error, 9 at most: those of the value that it belongs to. Where there is no error,
/// `otherwise` so many.
pub(crate) fn digits_of_error(error: impl Into<Option<f64>>, otherwise: usize) -> usize {
    error.into().filter(|error| error.is_finite() && *error > 0.0).map_or(otherwise, |error| digits_of(error, 2).min(9))
}

/// A number with its standard error, both with two significant digits of it; without one as [`with_error`].
pub(crate) fn plus_minus(value: f64, error: Option<f64>) -> String {
    match error.filter(|error| error.is_finite() && *error > 0.0) {
        None => with_error(value, None),
        Some(error) => {
            let digits = digits_of_error(error, 0);
            format!("{} ± {}", fixed(value, digits), fixed(error, digits))
        }
    }
}

/// A number with the digits that its standard error is written with; without one with six significant digits at most.
pub(crate) fn with_error(value: f64, error: Option<f64>) -> String {
    if let Some(error) = error.filter(|error| *error > 0.0) {
        return fixed(value, digits_of(error, 3));
    }
    let written = fixed(value, digits_of(value, 6));
    if written.contains('.') { written.trim_end_matches('0').trim_end_matches('.').to_string() } else { written }
}

/// The largest of 1, 2 and 5 times a power of ten that is not above a length; 1 for what is none.
pub(crate) fn round_below(length: f64) -> f64 {
    if !(length.is_finite() && length > 0.0) {
        return 1.0;
    }
    let power = libm::pow(10.0, libm::floor(libm::log10(length)));
    [5.0, 2.0].into_iter().find(|times| times * power <= length).unwrap_or(1.0) * power
}

/// A count in groups of three.
pub(crate) fn count(value: usize) -> String {
    let digits = value.to_string();
    let first = digits.len() % 3;
    let groups = digits.as_bytes()[first..].chunks(3).map(|group| String::from_utf8_lossy(group).into_owned());
    let head = (first > 0).then(|| digits[..first].to_string());
    head.into_iter().chain(groups).collect::<Vec<_>>().join("\u{202f}")
}

/// A sentence as reports write its numbers: in groups of three, with their minus, and σ₀ with its index.
pub(crate) fn typeset(text: &str) -> String {
    let word = |word: &str| {
        // A figure may be set apart by marks of direction.
        let begun = word.trim_start_matches('\u{2068}');
        let core = begun.trim_end_matches(['.', ',', ';', ':', ')', '،', '؛', '\u{2069}']);
        match core.parse::<usize>() {
            Ok(number) if core.len() > 3 => word.replacen(core, &count(number), 1),
            _ if begun.starts_with('-') && begun[1..].starts_with(|c: char| c.is_ascii_digit()) => word.replacen('-', "−", 1),
            _ => word.replace("σ0", "σ₀"),
        }
    };
    text.split(' ').map(word).collect::<Vec<_>>().join(" ")
}

pub(crate) fn percent(part: usize, whole: usize) -> String {
    if whole == 0 { "–".into() } else { format!("{} %", fixed(100.0 * part as f64 / whole as f64, 1)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sentence_has_its_numbers_as_the_figures_beside_it() {
        assert_eq!(
            typeset("Oriented from 5131 points, σ0 0.09 px; by -0.147° ± 0.018° (95 %), of 12345, not IMG-2024."),
            "Oriented from 5\u{202f}131 points, σ₀ 0.09 px; by −0.147° ± 0.018° (95 %), of 12\u{202f}345, not IMG-2024."
        );
        assert_eq!(
            typeset("من \u{2068}5131\u{2069}، بمقدار \u{2068}-0.1°\u{2069}"),
            "من \u{2068}5\u{202f}131\u{2069}، بمقدار \u{2068}−0.1°\u{2069}"
        );
    }

    #[test]
    fn numbers_are_written_with_their_minus_and_in_groups() {
        assert_eq!([fixed(-0.004, 2), fixed(-0.0, 0)], ["0.00", "0"]);
        assert_eq!((fixed(-0.126, 2), fixed(f64::NAN, 2), fixed(None, 2)), ("−0.13".into(), "–".into(), "–".into()));
        assert_eq!(
            (count(7), count(325), count(46_695), count(1_000_000)),
            ("7".into(), "325".into(), "46\u{202f}695".into(), "1\u{202f}000\u{202f}000".into())
        );
        assert_eq!((percent(1, 8), percent(0, 0)), ("12.5 %".into(), "–".into()));
    }

    #[test]
    fn digits_are_those_that_mean_something() {
        assert_eq!(significant(-0.000_012_3), "−1.2e−5");
        assert_eq!([0.001_234_5, 12.345, 123_456.0, 0.0].map(significant), ["0.00123", "12.3", "123456", "0"]);
        assert_eq!(
            [(3512.3456, Some(0.123)), (-0.012_345_6, None), (800.0, None)].map(|(v, e)| with_error(v, e)),
            ["3512.346", "−0.0123456", "800"]
        );
        assert_eq!([4.3e-6, 0.0995, 12.0, 1e-12].map(|error| digits_of_error(error, 4)), [7, 3, 0, 9]);
        assert_eq!([None, Some(0.0), Some(f64::NAN)].map(|error| digits_of_error(error, 4)), [4; 3]);
        assert_eq!(
            [(-1.46e-5, Some(4.3e-6)), (5678.94, Some(12.3)), (153.024, None), (0.0, Some(0.0))].map(|(v, e)| plus_minus(v, e)),
            ["−0.0000146 ± 0.0000043", "5679 ± 12", "153.024", "0"]
        );
        assert_eq!([0.05, 2.0, 500.0].map(rounded), ["0.05", "2", "500"]);
        assert_eq!([0.7, 1.0, 34.0, 99.0].map(round_below), [0.5, 1.0, 20.0, 50.0]);
        assert_eq!((round_below(0.0), round_below(f64::NAN)), (1.0, 1.0));
    }
}
