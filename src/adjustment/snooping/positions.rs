//! Data snooping of GNSS positions: which lie too far from where all other observations have their images.

use super::course::Course;
use super::rays::FREE_ROUNDS;
use crate::adjustment::gauss_newton::LEAST_SIGMA_PX;
use crate::adjustment::reliability::{Scale, of_position};
use crate::adjustment::result::PriorStatistics;
use crate::adjustment::statistics::Statistics;
use crate::adjustment::weighted::{Weighted, observed};
use crate::math::{median, normal_median_within};

/// Positions, surveyed points included, that have to be left: fewer do not tell which of them is wrong.
const LEAST_LEFT: usize = 4;
/// A wrong position pulls at its neighbours: of those beyond the limit only the ones with this share of the largest test are refused at a time.
const NEAR_WORST: f64 = 0.7;

/// No more than this share of the positions that agree at the start are refused later, or none.
const MANY_WRONG: f64 = 0.15;

impl Course<'_> {
    /// Refuses GNSS positions that lie too far off and takes back those that no longer do; whether there were any.
    pub fn snoop_positions(&mut self, statistics: &Statistics, weighted_by: f64, calm_rounds: usize) -> bool {
        if self.keeps_agreed {
            return false;
        }
        let (mut gnss, control) = observed(&self.block, self.options.datum, weighted_by);
        self.systematic.left_out.iter().for_each(|image| gnss[*image] = None);
        let scale = Scale::of_tests(self.ray_error().max(LEAST_SIGMA_PX));
        let judge = |(image, prior): (usize, &Option<Weighted>)| {
            let at = self.systematic.antenna(&self.state, image);
            prior.map(|prior| of_position(&prior, &at, Some(statistics.of_position(image)), scale, self.placed[image]))
        };
        let judged: Vec<_> = gnss.iter().enumerate().map(judge).collect();
        let surveyed = control.iter().flatten().count();
        let now = placed_now(&judged, &self.placed, surveyed, self.options.limit(), calm_rounds < FREE_ROUNDS);
        // A block that contradicts many positions is wrong itself, in cameras that it does not determine say.
        let refused = now.iter().zip(&self.agreed).filter(|(now, agreed)| **agreed && !**now).count();
        self.keeps_agreed = refused as f64 > MANY_WRONG * judged.iter().flatten().count() as f64;
        let now = if self.keeps_agreed { self.agreed.clone() } else { now };
        let changed = now != self.placed;
        if changed {
            self.placed = now;
            self.forget();
        }
        changed
    }
}

/// Which positions take part from now on, by what the adjustment says of each image's. `limit` is that of a standardised residual. Receivers
/// state their errors too small as a rule: the limit grows with the median of all. Refused positions that no longer exceed it are taken back
/// where `may_return`.
///
/// # Source
/// Baarda 1968, A testing procedure for use in geodetic networks.
fn placed_now(positions: &[Option<PriorStatistics>], placed: &[bool], surveyed: usize, limit: f64, may_return: bool) -> Vec<bool> {
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
        Some(PriorStatistics {
            accepted: true,
            residual: [0.0; 3],
            redundancy: None,
            w: Some([w, -0.7, 0.6]),
            detectable: [None; 3],
            influence: [None; 3],
            moves: [None; 3],
            left_out: None,
        })
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
                Some(PriorStatistics {
                    accepted: true,
                    residual: [0.0; 3],
                    redundancy: None,
                    w: Some([3.0, -4.0, 2.0 + f64::from(k)]),
                    detectable: [None; 3],
                    influence: [None; 3],
                    moves: [None; 3],
                    left_out: None,
                })
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
