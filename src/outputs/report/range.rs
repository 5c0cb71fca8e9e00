//! Least, median and largest of many values.

use crate::html::significant;
use maud::{Markup, html};

/// Of the finite ones; absent without any.
pub(super) fn range(values: impl IntoIterator<Item = f64>) -> Option<[f64; 3]> {
    let mut values: Vec<f64> = values.into_iter().filter(|value| value.is_finite()).collect();
    values.sort_by(f64::total_cmp);
    Some([*values.first()?, values[(values.len() - 1) / 2], *values.last()?])
}

/// A table of ranges under a caption; rows of nothing are left out.
pub(super) fn ranges(caption: &str, rows: &[(&str, Option<[f64; 3]>)]) -> Markup {
    html! {
        table tabindex="0" {
            caption { (caption) }
            thead { tr { td {} th { "minimum" } th { "median" } th { "maximum" } } }
            tbody {
                @for (name, range) in rows {
                    @if let Some(range) = range { tr { th { (name) } @for value in range { td { (significant(*value)) } } } }
                }
            }
        }
    }
}

/// The largest first, at most so many; `of` gives what is compared, `None` for what is not listed.
pub(super) fn worst<T>(items: impl Iterator<Item = T>, most: usize, of: impl Fn(&T) -> Option<f64>) -> Vec<T> {
    let mut listed: Vec<(f64, T)> = items.filter_map(|item| Some((of(&item).filter(|value| !value.is_nan())?, item))).collect();
    // Of equal ones the first stays first.
    listed.sort_by(|a, b| b.0.total_cmp(&a.0));
    listed.truncate(most);
    listed.into_iter().map(|(_, item)| item).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_and_lists_leave_out_what_is_no_number() {
        assert_eq!((range([3.0, f64::NAN, 1.0, 2.0]), range([f64::INFINITY])), (Some([1.0, 2.0, 3.0]), None));
        assert_eq!(worst([1.0, f64::NAN, 5.0, 3.0].into_iter(), 2, |value| Some(*value)), [5.0, 3.0]);
        assert_eq!(worst(0..4, 2, |value| (*value != 3).then_some(0.0)), [0, 1]);
    }
}
