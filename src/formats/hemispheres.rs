//! Coordinates whose side is written beside them: `49.99` and `S`, `49 deg 59' 24.00" S`, `12 m Below Sea Level`.

/// What a coordinate is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Axis {
    Longitude,
    Latitude,
    Height,
}

impl Axis {
    /// The words of both sides, the positive one first, in small letters.
    fn sides(self) -> [&'static [&'static str]; 2] {
        match self {
            Self::Longitude => [&["east", "e"], &["west", "w"]],
            Self::Latitude => [&["north", "n"], &["south", "s"]],
            // EXIF has numbers for them, and ExifTool words.
            Self::Height => [
                &["above sea level", "positive sea level (sea-level ref)", "positive sea level", "positive", "0", "2"],
                &["below sea level", "negative sea level (sea-level ref)", "negative sea level", "negative", "1", "3"],
            ],
        }
    }

    /// The side that a column of its own says: whether it is the negative one; `None` for any other word.
    pub fn is_negative(self, word: &str) -> Option<bool> {
        let word = word.to_lowercase();
        self.sides().iter().position(|words| words.contains(&word.as_str())).map(|side| side == 1)
    }

    /// A number on the side that a column of its own says; `None` for any other word, and where the sign of the number says the other side.
    pub fn on_side(self, number: f64, word: &str) -> Option<f64> {
        on_side(number, self.is_negative(word)?)
    }

    /// A coordinate with its side, if any, in the field itself. `number` reads one without. `None` where it is none, and where its sign contradicts its side.
    pub fn read(self, field: &str, number: impl Fn(&str) -> Option<f64>) -> Option<f64> {
        if let Some(plain) = number(field) {
            return Some(plain);
        }
        let small = field.to_lowercase();
        let strip = |word: &str| small.strip_suffix(word).or_else(|| small.strip_prefix(word).filter(|_| self != Self::Height));
        // The numbers of EXIF stand in columns of their own alone.
        let words =
            |side: usize| self.sides()[side].iter().copied().filter(|word| !word.starts_with(|letter: char| letter.is_ascii_digit()));
        let found = (0..2).find_map(|side| words(side).find_map(strip).map(|bare| (bare.trim(), side == 1)));
        let (bare, is_negative) = found.map_or((small.as_str(), None), |(bare, is_negative)| (bare, Some(is_negative)));
        let value = match self {
            Self::Height => number(bare.strip_suffix('m').map_or(bare, str::trim_end)),
            Self::Longitude | Self::Latitude => number(bare).or_else(|| degrees(bare, number)),
        }?;
        is_negative.map_or(Some(value), |is_negative| on_side(value, is_negative))
    }
}

/// A number on a side; `None` where its sign says the other one.
fn on_side(number: f64, is_negative: bool) -> Option<f64> {
    match is_negative {
        true => Some(-number.abs()),
        false => Some(number).filter(|number| *number >= 0.0),
    }
}

/// Degrees with a sign for them, perhaps with minutes, perhaps with seconds.
fn degrees(text: &str, number: impl Fn(&str) -> Option<f64>) -> Option<f64> {
    let (is_negative, text) = text.strip_prefix('-').map_or((false, text), |rest| (true, rest));
    let cut = |text: &'_ str, signs: &[&str]| {
        signs.iter().find_map(|sign| text.split_once(sign)).map(|(part, rest)| (part.trim().to_string(), rest.trim().to_string()))
    };
    let part = |text: &str, below: f64| number(text).filter(|part| (0.0..below).contains(part) && !text.starts_with(['+', '-']));
    let (whole, rest) = cut(text, &["deg", "°", "º"])?;
    let mut sum = part(&whole, 361.0)?;
    if !rest.is_empty() {
        let (minutes, rest) = cut(&rest, &["'", "′", "’"])?;
        let minutes = part(&minutes, 60.0).filter(|_| sum.fract() == 0.0)?;
        let seconds = match rest.as_str() {
            "" => 0.0,
            rest => {
                let (seconds, behind) = cut(rest, &["''", "\"", "″", "”"])?;
                part(&seconds, 60.0).filter(|_| behind.is_empty() && minutes.fract() == 0.0)?
            }
        };
        sum += minutes / 60.0 + seconds / 3600.0;
    }
    Some(if is_negative { -sum } else { sum })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_make_numbers_negative_or_are_refused() {
        let number = |text: &str| text.parse().ok();
        for (axis, field, wanted) in [
            (Axis::Latitude, "49.99", Some(49.99)),
            (Axis::Latitude, "49.99 S", Some(-49.99)),
            (Axis::Latitude, "-49.99 S", Some(-49.99)),
            (Axis::Latitude, "N49.99", Some(49.99)),
            (Axis::Latitude, "-49.99 N", None),
            (Axis::Latitude, "49.99 E", None),
            (Axis::Longitude, "8.25west", Some(-8.25)),
            (Axis::Longitude, "8.25 S", None),
            (Axis::Latitude, "49 deg 59' 24.00\" S", Some(-49.99)),
            (Axis::Longitude, "8°15′E", Some(8.25)),
            (Axis::Longitude, "8° 15' 0''", Some(8.25)),
            (Axis::Longitude, "-8°15'", Some(-8.25)),
            (Axis::Longitude, "8.5°", Some(8.5)),
            (Axis::Longitude, "8.5°15'", None),
            (Axis::Longitude, "8°61'", None),
            (Axis::Longitude, "8°15' 0\" 5", None),
            (Axis::Longitude, "8 15 0", None),
            (Axis::Height, "171.5 m Above Sea Level", Some(171.5)),
            (Axis::Height, "12 m Below Sea Level", Some(-12.0)),
            (Axis::Height, "12 m Negative Sea Level (sea-level ref)", Some(-12.0)),
            (Axis::Height, "171.5 m", Some(171.5)),
            (Axis::Height, "171.5 ft", None),
            (Axis::Height, "-3 m Above Sea Level", None),
            (Axis::Height, "", None),
        ] {
            let read = axis.read(field, number);
            assert!(read.zip(wanted).map_or(read == wanted, |(read, wanted)| (read - wanted).abs() < 1e-12), "{field}: {read:?}");
        }
        assert_eq!(
            ["S", "south", "N", "E", ""].map(|word| Axis::Latitude.is_negative(word)),
            [Some(true), Some(true), Some(false), None, None]
        );
        assert_eq!(
            ["0", "1", "Below Sea Level", "2", "3", "Positive Sea Level (sea-level ref)", "4"].map(|word| Axis::Height.is_negative(word)),
            [Some(false), Some(true), Some(true), Some(false), Some(true), Some(false), None]
        );
    }
}
