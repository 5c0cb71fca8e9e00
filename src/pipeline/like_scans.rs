//! Which images look like scans of film from which no images of an ideal camera were made.

use std::collections::BTreeSet;

/// Scans of one film differ by up to this share of their sides.
const MOST_APART: f64 = 0.05;

/// Whether another image has nearly the size of each, but not just so, as scans have that were cut by hand; of images whose camera is not known. Those of
/// one digital camera are of one size.
pub(super) fn cut_by_hand(sizes_px: &[Option<[u32; 2]>]) -> Vec<bool> {
    let different: BTreeSet<[u32; 2]> = sizes_px.iter().flatten().copied().collect();
    let is_near = |one: [u32; 2], other: [u32; 2]| {
        let apart = |k: usize| f64::from(one[k].abs_diff(other[k])) / f64::from(one[k].max(other[k]));
        one != other && apart(0).max(apart(1)) <= MOST_APART
    };
    sizes_px.iter().map(|own| own.is_some_and(|own| different.iter().any(|other| is_near(own, *other)))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_that_differ_a_little_are_of_scans_and_those_of_digital_cameras_are_not() {
        let scans = [Some([1963, 1899]), Some([1968, 1892]), Some([4000, 3000]), None];
        assert_eq!(cut_by_hand(&scans), [true, true, false, false]);
        let digital = [Some([4000, 3000]), Some([4000, 3000]), Some([3000, 4000]), Some([2000, 1500])];
        assert_eq!(cut_by_hand(&digital), [false; 4]);
        // A camera that is known takes no images of other sizes.
        assert_eq!(cut_by_hand(&[Some([1963, 1899]), None, None]), [false; 3]);
    }
}
