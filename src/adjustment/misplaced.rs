//! Data snooping of GPS positions: which lie too far from where all other observations have their images.

use super::result::PriorStatistics;
use crate::math::{median, normal_median_within};

/// Positions, surveyed points included, that have to be left: fewer do not tell which of them is wrong.
const LEAST_LEFT: usize = 4;
/// A wrong position pulls at its neighbours: of those beyond the limit only the ones with this share of the largest test are refused at a time.
const NEAR_WORST: f64 = 0.7;

/// Which positions take part from now on, by what the adjustment says of each image's. `limit` is that of a standardised residual. Receivers
/// state their errors too small as a rule: the limit grows with the median of all. Refused positions that no longer exceed it are taken back
/// where `may_return`.
///
/// # Source
/// Baarda 1968, A testing procedure for use in geodetic networks.
pub(super) fn placed_now(
    positions: &[Option<PriorStatistics>],
    placed: &[bool],
    surveyed: usize,
    limit: f64,
    may_return: bool,
) -> Vec<bool> {
    let tests = |image: usize| positions[image].and_then(|p| p.w).unwrap_or_default().map(f64::abs);
    let size = |image: usize| tests(image).into_iter().fold(0.0, f64::max);
    let known = || (0..positions.len()).filter(|image| positions[*image].is_some());
    let mut all: Vec<f64> = known().filter(|image| placed[*image]).flat_map(tests).filter(|w| *w > 0.0).collect();
    let scale = median(&mut all).map_or(1.0, |middle| (middle / normal_median_within(limit)).max(1.0));
    let limit = limit * scale;
    let worst = known().filter(|image| placed[*image]).map(size).fold(0.0, f64::max);
    let mut now = placed.to_vec();
    let mut left = known().filter(|image| placed[*image]).count() + surveyed;
    let mut by_size: Vec<usize> = known().collect();
    by_size.sort_by(|a, b| size(*b).total_cmp(&size(*a)).then(a.cmp(b)));
    for image in by_size {
        if placed[image] && size(image) > limit && size(image) >= NEAR_WORST * worst && left > LEAST_LEFT {
            now[image] = false;
            left -= 1;
        } else if !placed[image] && may_return && size(image) <= limit {
            now[image] = true;
        }
    }
    now
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tested(w: f64) -> Option<PriorStatistics> {
        Some(PriorStatistics { accepted: true, residual: [0.0; 3], redundancy: None, w: Some([w, -0.7, 0.6]) })
    }

    #[test]
    fn the_worst_positions_are_refused_and_good_ones_come_back() {
        let mut positions = vec![tested(0.5); 12];
        (positions[3], positions[4], positions[7]) = (tested(-20.0), tested(8.0), None);
        let mut placed = vec![true; 12];
        placed[0] = false;
        let now = placed_now(&positions, &placed, 0, 3.3, true);
        // The one beside the worst waits until that is gone.
        assert_eq!((0..12).filter(|image| !now[*image]).collect::<Vec<_>>(), [3]);
        assert!(!placed_now(&positions, &placed, 0, 3.3, false)[0]);
    }

    #[test]
    fn errors_stated_too_small_refuse_nothing() {
        let positions: Vec<_> = (0..12)
            .map(|k| {
                Some(PriorStatistics { accepted: true, residual: [0.0; 3], redundancy: None, w: Some([3.0, -4.0, 2.0 + f64::from(k)]) })
            })
            .collect();
        assert_eq!(placed_now(&positions, &[true; 12], 0, 3.3, true), [true; 12]);
    }

    #[test]
    fn four_positions_are_all_kept() {
        let positions = [tested(30.0), tested(10.0), tested(1.0), tested(1.0)];
        assert_eq!(placed_now(&positions, &[true; 4], 0, 3.3, true), [true; 4]);
        assert_eq!(placed_now(&positions, &[true; 4], 1, 3.3, true), [false, true, true, true]);
    }

    #[test]
    fn where_not_all_wrong_ones_may_go_the_worst_goes() {
        let positions = [tested(8.0), tested(0.5), tested(0.5), tested(10.0), tested(0.5)];
        assert_eq!(placed_now(&positions, &[true; 5], 0, 3.3, true), [true, true, true, false, true]);
    }
}
