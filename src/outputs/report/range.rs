//! Least, median and largest of many values.

use crate::Texts;
use crate::html::significant;
use maud::{Markup, html};

/// Of the finite ones; absent without any.
pub(super) fn range(values: impl IntoIterator<Item = f64>) -> Option<[f64; 3]> {
    let mut values: Vec<f64> = values.into_iter().filter(|value| value.is_finite()).collect();
    values.sort_by(f64::total_cmp);
    Some([*values.first()?, values[(values.len() - 1) / 2], *values.last()?])
}

/// A quantity in words, and its range.
pub(super) type Named = (String, Option<[f64; 3]>);

/// The head of a table of ranges.
pub(super) fn range_head(texts: &Texts) -> Markup {
    html! { thead { tr { td {} @for name in ["report-minimum", "report-median", "report-maximum"] { th { (texts.say(name)) } } } } }
}

/// A table of ranges under the caption of this name; rows of nothing are left out.
pub(super) fn ranges(texts: &Texts, caption: &str, rows: &[Named]) -> Markup {
    html! {
        table tabindex="0" {
            caption { (texts.say(caption)) }
            (range_head(texts))
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
