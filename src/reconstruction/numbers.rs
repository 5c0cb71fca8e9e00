//! By which numbers files and views call the points of a block.

use super::result::PointSource;

/// Tie points count from 1 as they were found; those that were surveyed and those that were measured by hand count from a power of ten above all of them, so
/// that none changes when others are rejected or added.
pub(crate) struct PointNumbers {
    above: u32,
}

impl PointNumbers {
    /// `points`: of a model; `tie_points`: how many there were to choose its own from, as far as that is known.
    pub fn new(points: &[PointSource], tie_points: usize) -> Self {
        let known = points.iter().map(|point| match point {
            PointSource::TiePoint(index) => *index as usize + 1,
            PointSource::GroundControl(index) => *index + 1,
            PointSource::Manual(_) => 0,
        });
        let most = known.max().unwrap_or(0).max(tie_points);
        Self { above: (3..9).map(|digits| 10_u32.pow(digits)).find(|above| *above as usize > most).unwrap_or(1_000_000_000) }
    }

    /// Of a point that no block has, as a refusal may name it, the largest number.
    pub fn of(&self, point: PointSource) -> u32 {
        let (before, index) = match point {
            PointSource::TiePoint(index) => (0, index),
            PointSource::GroundControl(index) => (self.above, u32::try_from(index).unwrap_or(u32::MAX)),
            PointSource::Manual(index) => (2 * self.above, index),
        };
        index.saturating_add(before).saturating_add(1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_surveyed_points_and_of_those_by_hand_lie_above_those_of_all_tie_points() {
        let points = [PointSource::TiePoint(41), PointSource::TiePoint(7), PointSource::GroundControl(2), PointSource::Manual(0)];
        let of = |tie_points| points.map(|point| PointNumbers::new(&points, tie_points).of(point));
        assert_eq!(of(900), [42, 8, 1003, 2001]);
        assert_eq!(of(1000), [42, 8, 10_003, 20_001]);
        // The file of a block of former versions does not say how many there were.
        assert_eq!(of(0), [42, 8, 1003, 2001]);
        assert_eq!(PointNumbers::new(&points, 0).of(PointSource::TiePoint(u32::MAX)), u32::MAX);
    }
}
