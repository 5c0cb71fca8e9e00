//! Columns of standard errors that say no unit, so that what stands in them is taken as m.

use super::column_units::named;
use crate::text::shorten;
use csv::StringRecord;

/// Standard errors from here on, in m, may be something else in columns without a name: angles, dilutions of precision, numbers of satellites, codes.
const CERTAIN_BELOW_M: f64 = 1.0;

/// Whether the numbers of a column without a name can be standard errors in m: above 0 and up to `most_m`, and the same in all rows, as programs state them
/// that know no better, or all of them small.
pub(super) fn can_be_errors(numbers: &[f64], most_m: f64) -> bool {
    let is_one = numbers.windows(2).all(|pair| pair[0] == pair[1]);
    numbers.iter().all(|number| *number > 0.0 && *number <= most_m && (is_one || *number < CERTAIN_BELOW_M))
}

/// The names of these columns, or `#5` for the fifth of a table that names none.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct ErrorColumns {
    /// Of the place: one, or those of x and y.
    pub across: Vec<String>,
    pub up: Vec<String>,
}

impl ErrorColumns {
    /// Of the columns that are read. `head`: the line of names, where there is one.
    pub(super) fn of(head: Option<&StringRecord>, across: Option<[usize; 2]>, up: Option<usize>) -> Self {
        let name = |column: usize| match head.and_then(|head| head.get(column)) {
            Some(name) => named(name).1.is_none().then(|| shorten(name)),
            None => Some(format!("#{}", column + 1)),
        };
        let mut across: Vec<usize> = across.into_iter().flatten().collect();
        across.dedup();
        // Where one of two says its unit, so does the line.
        let across: Option<Vec<String>> = across.into_iter().map(name).collect();
        Self { across: across.unwrap_or_default(), up: up.and_then(name).into_iter().collect() }
    }

    /// The columns of a table that names none, where their numbers may be something else. `errors`: those of its rows, of place and height.
    pub fn unnamed(&self, head: Option<&StringRecord>, errors: impl IntoIterator<Item = [Option<f64>; 2]>) -> Vec<String> {
        let is_large = errors.into_iter().flatten().flatten().any(|error| error >= CERTAIN_BELOW_M);
        if head.is_none() && is_large { self.names() } else { Vec::new() }
    }

    /// Each once.
    pub fn names(&self) -> Vec<String> {
        let mut names = [self.across.as_slice(), self.up.as_slice()].concat();
        names.dedup();
        names
    }

    /// Of a point's or an image's standard errors of place and height those that stand in them, coordinate by coordinate.
    pub fn stated(&self, errors: [Option<f64>; 2]) -> [Option<f64>; 3] {
        let [across, up] = errors;
        let [across, up] = [across.filter(|_| !self.across.is_empty()), up.filter(|_| !self.up.is_empty())];
        [across, across, up]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_without_a_unit_are_named_once() {
        let columns = |head: &[&str], across, up| {
            let head: StringRecord = head.iter().collect();
            ErrorColumns::of(Some(&head).filter(|head| !head.is_empty()), across, Some(up)).names()
        };
        assert_eq!(columns(&["name", "std_x", "std_y", "std_z"], Some([1, 2]), 3), ["std_x", "std_y", "std_z"]);
        assert_eq!(columns(&["accuracy"], Some([0, 0]), 0), ["accuracy"]);
        assert_eq!(columns(&["sigma_xy (mm)", "sigma_z"], Some([0, 0]), 1), ["sigma_z"]);
        assert!(columns(&["sx (m)", "sigma_y", "sigma_z [m]"], Some([0, 1]), 2).is_empty());
        assert_eq!(columns(&[], Some([4, 4]), 5), ["#5", "#6"]);
        let of_height = ErrorColumns { across: Vec::new(), up: vec!["z".into()] };
        assert_eq!(of_height.stated([Some(1.0), Some(2.0)]), [None, None, Some(2.0)]);
    }
}
