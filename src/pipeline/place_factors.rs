//! By how much the errors of the places of an orthophoto exceed what is stated, and what neighbouring places share of them, by the residuals of an
//! adjustment.
//!
//! Heights of one slope, or of one strip of a height model, are wrong together: many such places are worth as much as few that err alone. In an
//! adjustment each place errs alone. It comes to the same for whatever varies slowly over the ground when the variance of a place is the sum of
//! its covariances with itself and with all around it. Residuals give these: their products, summed up by distance. Beyond where errors agree,
//! the sum falls again, since the adjustment has fitted the block to all places, so that its largest value counts.
//!
//! # Source
//! Cressie 1993, Statistics for spatial data, 1.3 (effective number of correlated observations).

/// A place with its residuals by their stated standard errors: X, Y and height.
#[derive(Debug, Clone, Copy)]
pub(super) struct PlaceResidual {
    pub at: [f64; 2],
    pub residual: [f64; 3],
    /// Those standard errors, in m.
    pub sigma: [f64; 3],
    /// Redundancy numbers of the three.
    pub redundancy: [f64; 3],
}

/// Standard errors of places in plan and height, in stated ones.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PlaceFactors {
    /// Of one by itself.
    pub own: [f64; 2],
    /// Of one in an adjustment with all others, of which each stands for what it shares with those around it.
    pub among_others: [f64; 2],
}

/// Fewer places do not show what neighbours share: a circle about each would hold too many of all.
const LEAST_PLACES: usize = 40;
/// Circles about a place hold no more than this share of all, where these lie all over a rectangle along the axes.
const MOST_SHARE: f64 = 1.0 / 3.0;
/// Radii of circles, in mean distances between neighbours.
const STEP: f64 = 0.5;
const MOST_RADIUS: f64 = 12.0;
/// Residuals that the adjustment has hardly left say nothing.
const LEAST_REDUNDANCY: f64 = 0.2;
/// The sums are uncertain themselves, and residuals are smaller where the block has followed the places. Set on 60 adjustments of 20 simulated blocks: with
/// heights right, wrong together, fields of another season, other houses.
const MARGIN: f64 = 1.3;

/// `None` of too few places.
pub(super) fn place_factors(places: &[PlaceResidual]) -> Option<PlaceFactors> {
    let number = places.len() as f64;
    let mut sorted = places.to_vec();
    sorted.sort_by(|a, b| a.at[0].total_cmp(&b.at[0]).then(a.at[1].total_cmp(&b.at[1])));
    let extent = [0, 1].map(|k| {
        let values = || places.iter().map(|place| place.at[k]);
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    });
    let between = (extent[0] * extent[1] / number).sqrt();
    let is_known = places.iter().all(|place| place.residual.iter().chain(&place.redundancy).all(|value| value.is_finite()));
    if places.len() < LEAST_PLACES || !is_known || between.is_nan() || between <= 0.0 {
        return None;
    }
    let radius = (MOST_SHARE * number / std::f64::consts::PI).sqrt().min(MOST_RADIUS);
    let rings = (radius / STEP) as usize;
    // Of each ring the sums of products in plan and height; those of places with themselves are the first.
    let mut sums = vec![[0.0; 2]; rings + 1];
    for (index, a) in sorted.iter().enumerate() {
        for (k, other) in sorted[index..].iter().enumerate() {
            let [dx, dy] = [0, 1].map(|axis| (other.at[axis] - a.at[axis]) / (STEP * between));
            if dx > rings as f64 {
                break;
            }
            let ring = if k == 0 { 0 } else { libm::hypot(dx, dy).ceil().max(1.0) as usize };
            let Some(sum) = sums.get_mut(ring) else { continue };
            let times = if k == 0 { 1.0 } else { 2.0 };
            let [x, y, z] = [0, 1, 2].map(|axis| a.residual[axis] * other.residual[axis]);
            *sum = [sum[0] + times * 0.5 * (x + y), sum[1] + times * z];
        }
    }
    let mean = |k: usize| places.iter().map(|place| place.redundancy[k]).sum::<f64>() / number;
    let left = [0.5 * (mean(0) + mean(1)), mean(2)].map(|redundancy| redundancy.max(LEAST_REDUNDANCY));
    let own = [0, 1].map(|k| (sums[0][k] / number / left[k]).sqrt());
    let among_others = [0, 1].map(|k| {
        let mut within = 0.0;
        let largest = sums.iter().map(|sum| {
            within += sum[k];
            within
        });
        MARGIN * (largest.fold(0.0, f64::max) / number / left[k]).sqrt()
    });
    Some(PlaceFactors { own, among_others })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;

    const REDUNDANCY: f64 = 0.5;

    /// A grid of places 10 m apart, of which squares of so many share the error of their height.
    fn places(side: usize, together: usize, seed: u32) -> Vec<PlaceResidual> {
        let mut random = Random::new(seed);
        // Uniformly distributed, of variance 1.
        let mut error = || 12.0_f64.sqrt() * (random.below(1 << 20) as f64 / f64::from(1 << 20) - 0.5);
        let patches: Vec<f64> = (0..side * side).map(|_| error()).collect();
        let place = |k: usize| {
            let (column, row) = (k % side, k / side);
            let patch = patches[column / together + side * (row / together)];
            let residual = [error(), error(), patch].map(|error| REDUNDANCY.sqrt() * error);
            PlaceResidual { at: [10.0 * column as f64, 10.0 * row as f64], residual, sigma: [0.3; 3], redundancy: [REDUNDANCY; 3] }
        };
        (0..side * side).map(place).collect()
    }

    /// The middle one of several sets.
    fn middle(mut factors: Vec<f64>) -> f64 {
        crate::math::median(&mut factors).unwrap()
    }

    #[test]
    fn places_that_err_alone_stand_for_themselves() {
        let sets: Vec<PlaceFactors> = (1..20).map(|seed| place_factors(&places(20, 1, seed)).unwrap()).collect();
        for k in 0..2 {
            let own = middle(sets.iter().map(|found| found.own[k]).collect());
            let among_others = middle(sets.iter().map(|found| found.among_others[k]).collect());
            assert!((own - 1.0).abs() < 0.03, "{own}");
            assert!((1.0..1.2).contains(&(among_others / MARGIN)), "{among_others}");
        }
    }

    #[test]
    fn a_place_stands_for_those_that_share_its_error() {
        // Sixteen that err together are worth one: each has four times its error.
        let sets: Vec<PlaceFactors> = (1..20).map(|seed| place_factors(&places(20, 4, seed)).unwrap()).collect();
        let [plan, height] = [0, 1].map(|k| middle(sets.iter().map(|found| found.among_others[k]).collect()) / MARGIN);
        assert!((3.5..4.5).contains(&height), "{height}");
        assert!((1.0..1.2).contains(&plan), "{plan}");
    }

    #[test]
    fn few_places_those_of_one_line_and_no_numbers_say_nothing() {
        assert!(place_factors(&places(7, 1, 1)[..40]).is_some());
        assert_eq!(place_factors(&places(7, 1, 1)[..39]), None);
        let line: Vec<_> = places(10, 1, 1).into_iter().map(|place| PlaceResidual { at: [place.at[0], 0.0], ..place }).collect();
        assert_eq!(place_factors(&line), None);
        let mut unknown = places(10, 1, 1);
        unknown[5].residual[2] = f64::NAN;
        assert_eq!(place_factors(&unknown), None);
    }
}
