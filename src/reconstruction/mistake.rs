//! How the coordinates of a surveyed point may have come to be wrong: slips of writing that explain where the other observations have it.

use crate::message::messages;
use serde::{Deserialize, Serialize};

messages! {
    /// A coordinate axis.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum Axis as "axis" {
        X,
        Y,
        Z,
    }
}

impl Axis {
    pub(crate) const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// 0, 1 or 2.
    pub(crate) fn index(self) -> usize {
        self as usize
    }
}

messages! {
    /// A slip of writing that explains wrong coordinates. Numbers are as they were written.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum Mistake as "mistake" {
        /// x stands where y belongs, and y where x does.
        Exchanged,
        Sign { axis: Axis, given: String },
        /// The decimal point is elsewhere, or zeros are missing or too many.
        DecimalPoint { axis: Axis, given: String, likely: String },
        /// A height that is in feet where metres are needed.
        Feet { given: String, likely: String },
        /// A height that is in metres where the system has feet.
        Metres { given: String, likely: String },
        /// One digit is another.
        Digit { axis: Axis, given: String, likely: String },
        /// Two digits beside each other stand in each other's place.
        Transposed { axis: Axis, given: String, likely: String },
        /// The coordinates are those of another zone of the same system.
        Zone { zone: u32 },
        /// The point was measured where this other one was surveyed.
        Name { other: String },
    }
}

/// Coordinates that are explained beside where the other observations have the point.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Doubted {
    /// As they were written, in the units of their system.
    pub given: [f64; 3],
    pub likely: [f64; 3],
    /// The unit of heights in m.
    pub height_unit_m: f64,
    /// How far what explains them may lie from `likely`, coordinate by coordinate: a limit of chance times standard errors.
    pub within: [f64; 3],
}

/// An error that is not so many times as large as what may be left of it is explained by anything.
const LEAST_TIMES: f64 = 10.0;
/// Powers of ten by which a decimal point is misplaced.
const POWERS: [i32; 6] = [1, -1, 2, -2, 3, -3];
/// An international foot in m; that of the US survey differs by two millionths.
const FOOT_M: f64 = 0.3048;
/// A unit is a foot, or a metre, where it differs by less than this share.
const SAME_UNIT: f64 = 1e-5;
/// Decimals of a coordinate that may be mistyped.
const DECIMALS: i32 = 3;

impl Doubted {
    /// The slip that explains them, where one does.
    pub fn mistake(&self) -> Option<Mistake> {
        let Self { given: [x, y, z], .. } = *self;
        if self.explains([y, x, z]) && self.is_large(0) && self.is_large(1) {
            return Some(Mistake::Exchanged);
        }
        // More than one coordinate wrong is no slip of one.
        let wrong: Vec<Axis> = Axis::ALL.into_iter().filter(|axis| !self.fits(axis.index(), self.given[axis.index()])).collect();
        let [axis] = wrong[..] else { return None };
        let (k, given) = (axis.index(), self.given[axis.index()]);
        if !self.is_large(k) {
            return None;
        }
        if self.fits(k, -given) {
            return Some(Mistake::Sign { axis, given: written(given) });
        }
        let moved = |power: &i32| given * libm::exp10(f64::from(*power));
        if let Some(likely) = POWERS.iter().map(moved).find(|moved| self.fits(k, *moved)) {
            return Some(Mistake::DecimalPoint { axis, given: written(given), likely: written(likely) });
        }
        if let Some(mistake) = Some(axis).filter(|axis| *axis == Axis::Z).and_then(|_| self.other_unit()) {
            return Some(mistake);
        }
        let digit = self.digit(k).map(|likely| Mistake::Digit { axis, given: written(given), likely });
        digit.or_else(|| self.transposed(k).map(|likely| Mistake::Transposed { axis, given: written(given), likely }))
    }

    /// A height in feet of a system in metres, or the other way around.
    fn other_unit(&self) -> Option<Mistake> {
        let is = |unit_m: f64| (self.height_unit_m / unit_m - 1.0).abs() < SAME_UNIT;
        let (k, given) = (Axis::Z.index(), self.given[Axis::Z.index()]);
        let converted = if is(1.0) { given * FOOT_M } else { given / self.height_unit_m };
        if !(is(1.0) || is(FOOT_M)) || !self.fits(k, converted) {
            return None;
        }
        let (given, likely) = (written(given), format!("{converted:.3}"));
        Some(if is(1.0) { Mistake::Feet { given, likely } } else { Mistake::Metres { given, likely } })
    }

    /// The coordinate that is farthest off, in what it may be off.
    pub fn axis(&self) -> Axis {
        let off = |axis: &Axis| (self.given[axis.index()] - self.likely[axis.index()]).abs() / self.within[axis.index()];
        Axis::ALL.into_iter().max_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(Axis::X)
    }

    /// Whether the other observations have the point where another one was surveyed, far from its own coordinates.
    pub fn is_of_another(&self, other: [f64; 3]) -> bool {
        self.explains(other) && (0..3).any(|k| self.is_large(k))
    }

    /// Whether coordinates are where the other observations have the point.
    pub fn explains(&self, at: [f64; 3]) -> bool {
        (0..3).all(|k| self.fits(k, at[k]))
    }

    fn fits(&self, k: usize, value: f64) -> bool {
        (value - self.likely[k]).abs() <= self.within[k]
    }

    fn is_large(&self, k: usize) -> bool {
        (self.given[k] - self.likely[k]).abs() >= LEAST_TIMES * self.within[k]
    }

    /// The number with two digits beside each other exchanged that lies where the other observations have it.
    fn transposed(&self, k: usize) -> Option<String> {
        let given = written(self.given[k]);
        let digits: Vec<usize> = given.char_indices().filter(|(_, letter)| letter.is_ascii_digit()).map(|(at, _)| at).collect();
        let point = given.find('.').unwrap_or(given.len());
        // As of one digit: tenths of a place that is as small as what may be left are any.
        let unit = |at: usize| libm::exp10(if at < point { (point - at) as f64 - 1.0 } else { point as f64 - at as f64 });
        let certain = digits.windows(2).filter(|pair| unit(pair[1]) >= LEAST_TIMES * self.within[k]);
        let exchanged = certain.map(|pair| {
            let mut letters: Vec<char> = given.chars().collect();
            letters.swap(pair[0], pair[1]);
            letters.into_iter().collect::<String>()
        });
        exchanged.into_iter().find(|number| number.parse().is_ok_and(|value| self.fits(k, value)))
    }

    /// The number with one other digit that lies where the other observations have it.
    fn digit(&self, k: usize) -> Option<String> {
        let (given, likely) = (self.given[k], self.likely[k]);
        if given == 0.0 || likely * given < 0.0 {
            return None;
        }
        let off = likely.abs() - given.abs();
        let place = libm::floor(libm::log10(off.abs())) as i32;
        (place..=place + 1).find_map(|place| {
            let unit = libm::exp10(f64::from(place));
            let (steps, digit) = (libm::round(off / unit), libm::fmod(libm::floor(given.abs() / unit + ROUNDING), 10.0));
            // Tenths of a place that is as small as what may be left are any.
            let is_certain = unit >= LEAST_TIMES * self.within[k] && place >= -DECIMALS;
            let is_digit = steps != 0.0 && (0.0..=9.0).contains(&(digit + steps));
            let value = libm::copysign(given.abs() + steps * unit, given);
            (is_certain && is_digit && self.fits(k, value)).then(|| with_decimals(value, decimals(given).max((-place).max(0) as usize)))
        })
    }
}

/// What a quotient may fall short of the digit that it is.
const ROUNDING: f64 = 1e-6;

/// A number as it was written, or the shortest that is the same to a ten-thousandth.
fn written(value: f64) -> String {
    with_decimals(value, decimals(value))
}

fn with_decimals(value: f64, decimals: usize) -> String {
    format!("{value:.decimals$}")
}

/// Decimals that a number needs, four at most.
fn decimals(value: f64) -> usize {
    let is_enough = |power: i32| {
        let unit = libm::exp10(f64::from(power));
        (value - libm::round(value * unit) / unit).abs() < 5e-5
    };
    (0..4).find(|power| is_enough(*power)).unwrap_or(4) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where the block has them: what was surveyed, but for 3 cm.
    fn mistake(given: [f64; 3], truth: [f64; 3]) -> Option<Mistake> {
        mistake_in(1.0, given, truth)
    }

    fn mistake_in(height_unit_m: f64, given: [f64; 3], truth: [f64; 3]) -> Option<Mistake> {
        Doubted { given, likely: [truth[0] + 0.03, truth[1] - 0.02, truth[2] + 0.03], height_unit_m, within: [0.1; 3] }.mistake()
    }

    const TRUE: [f64; 3] = [412_630.42, 5_316_020.17, 431.25];

    fn with(k: usize, value: f64) -> [f64; 3] {
        let mut given = TRUE;
        given[k] = value;
        given
    }

    fn digit(axis: Axis, given: &str, likely: &str) -> Option<Mistake> {
        Some(Mistake::Digit { axis, given: given.into(), likely: likely.into() })
    }

    #[test]
    fn one_other_digit_is_found_with_the_number_that_was_meant() {
        assert_eq!(mistake(with(0, 412_670.42), TRUE), digit(Axis::X, "412670.42", "412630.42"));
        assert_eq!(mistake(with(1, 5_316_023.17), TRUE), digit(Axis::Y, "5316023.17", "5316020.17"));
        assert_eq!(mistake(with(2, 931.25), TRUE), digit(Axis::Z, "931.25", "431.25"));
        // 9 in place of 0: the difference is all but the next place.
        assert_eq!(mistake(with(1, 5_396_020.17), [TRUE[0], 5_306_020.17, TRUE[2]]), digit(Axis::Y, "5396020.17", "5306020.17"));
        // Of a negative number the digits count from zero.
        assert_eq!(mistake([-1234.5, 7.0, 3.0], [-1294.5, 7.0, 3.0]), digit(Axis::X, "-1234.5", "-1294.5"));
    }

    #[test]
    fn two_exchanged_digits_are_found_with_the_number_that_was_meant() {
        let transposed = |axis, given: &str, likely: &str| Some(Mistake::Transposed { axis, given: given.into(), likely: likely.into() });
        assert_eq!(mistake(with(0, 416_230.42), TRUE), transposed(Axis::X, "416230.42", "412630.42"));
        assert_eq!(mistake(with(1, 5_316_002.17), TRUE), transposed(Axis::Y, "5316002.17", "5316020.17"));
        assert_eq!(mistake(with(2, 341.25), TRUE), transposed(Axis::Z, "341.25", "431.25"));
        assert_eq!(mistake([-1324.5, 7.0, 3.0], [-1234.5, 7.0, 3.0]), transposed(Axis::X, "-1324.5", "-1234.5"));
        // Of places that are as small as what may be left any two explain.
        let doubted = Doubted { given: [122.83, 7.0, 3.0], likely: [127.9, 7.0, 3.0], height_unit_m: 1.0, within: [0.5; 3] };
        assert_eq!(doubted.mistake(), None);
    }

    #[test]
    fn what_no_single_digit_explains_is_left_open() {
        // 9 + 4 has no digit, 4.7 m is no step, and 0.3 m is no more than what may be left of it.
        for (given, truth) in [(412_690.42, 412_730.42), (412_635.12, 412_630.42), (412_630.72, 412_630.42)] {
            assert_eq!(mistake(with(0, given), [truth, TRUE[1], TRUE[2]]), None, "{given}");
        }
        // Two coordinates that are both wrong.
        assert_eq!(mistake([412_670.42, 5_316_024.17, 431.25], TRUE), None);
        assert_eq!(mistake(TRUE, TRUE), None);
    }

    #[test]
    fn a_decimal_point_a_sign_feet_and_exchanged_axes_are_told_apart() {
        let decimal_point =
            |axis, given: &str, likely: &str| Some(Mistake::DecimalPoint { axis, given: given.into(), likely: likely.into() });
        assert_eq!(mistake(with(2, 4312.5), TRUE), decimal_point(Axis::Z, "4312.5", "431.25"));
        assert_eq!(mistake(with(0, 412.63042), TRUE), decimal_point(Axis::X, "412.6304", "412630.42"));
        assert_eq!(mistake([-35.5, 20.0, 4.0], [35.5, 20.0, 4.0]), Some(Mistake::Sign { axis: Axis::X, given: "-35.5".into() }));
        let feet = mistake(with(2, 1414.862), TRUE);
        assert_eq!(feet, Some(Mistake::Feet { given: "1414.862".into(), likely: "431.250".into() }));
        assert_eq!(mistake([TRUE[1], TRUE[0], TRUE[2]], TRUE), Some(Mistake::Exchanged));
        // Equal to what may be left, x and y tell nothing by their exchange.
        assert_eq!(mistake([10.0, 10.2, 4.0], [10.2, 10.0, 4.0]), None);
    }

    #[test]
    fn heights_in_the_other_unit_are_found_in_metres_and_in_feet() {
        const FOOT_US: f64 = 1200.0 / 3937.0;
        let metres = |given: &str, likely: &str| Some(Mistake::Metres { given: given.into(), likely: likely.into() });
        assert_eq!(mistake_in(FOOT_M, with(2, 131.445), TRUE), metres("131.445", "431.250"));
        assert_eq!(mistake_in(FOOT_US, with(2, 131.445), TRUE), metres("131.445", "431.249"));
        // Feet of a system in feet are no slip, and a rod is neither.
        assert_eq!(mistake_in(FOOT_M, with(2, 1414.862), TRUE), None);
        assert_eq!(mistake_in(5.0292, with(2, 131.445), TRUE), None);
    }

    #[test]
    fn numbers_are_written_with_the_decimals_that_they_have() {
        for (value, text) in [(412_630.42, "412630.42"), (5.0, "5"), (-0.5, "-0.5"), (0.123_456, "0.1235"), (5_316_020.125, "5316020.125")]
        {
            assert_eq!(written(value), text);
        }
    }
}
