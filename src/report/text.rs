//! Numbers as the report writes them.

use crate::FiveParameters;

/// A number of so many digits, its minus as typography has it; a dash where there is none.
pub fn fixed(value: impl Into<Option<f64>>, digits: usize) -> String {
    match value.into() {
        Some(value) if value.is_finite() => format!("{value:.digits$}").replace('-', "−"),
        _ => "–".into(),
    }
}

/// A count in groups of three.
pub fn count(value: usize) -> String {
    let digits = value.to_string();
    let first = digits.len() % 3;
    let groups = digits.as_bytes()[first..].chunks(3).map(|group| String::from_utf8_lossy(group).into_owned());
    let head = (first > 0).then(|| digits[..first].to_string());
    head.into_iter().chain(groups).collect::<Vec<_>>().join("\u{202f}")
}

pub fn percent(part: usize, whole: usize) -> String {
    if whole == 0 { "–".into() } else { format!("{} %", fixed(100.0 * part as f64 / whole as f64, 1)) }
}

/// The five unknowns: symbol, unit, digits.
pub const UNKNOWNS: [(&str, &str, usize); 5] = [("ω", "°", 4), ("φ", "°", 4), ("κ", "°", 4), ("by", "mm", 4), ("bz", "mm", 4)];

pub fn five(p: &FiveParameters) -> [f64; 5] {
    [p.omega_deg, p.phi_deg, p.kappa_deg, p.by_mm, p.bz_mm]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_with_their_minus_and_in_groups() {
        assert_eq!((fixed(-0.126, 2), fixed(f64::NAN, 2), fixed(None, 2)), ("−0.13".into(), "–".into(), "–".into()));
        assert_eq!(
            (count(7), count(325), count(46_695), count(1_000_000)),
            ("7".into(), "325".into(), "46\u{202f}695".into(), "1\u{202f}000\u{202f}000".into())
        );
        assert_eq!((percent(1, 8), percent(0, 0)), ("12.5 %".into(), "–".into()));
    }
}
