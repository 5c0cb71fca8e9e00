//! What makes the orientation of matches weak that the adjustment of their photo coordinates does not see.

use super::geometry::PairInterior;
use super::one_image::may_be_one;
use super::self_calibration;
use crate::{EstimatedCamera, Match, Observation, RelativeOrientation, Side, Warning};
use std::collections::BTreeSet;

/// Windows of points nearer than this overlap, or see the same edges and roofs.
pub(super) const NEIGHBOURHOOD_PX: f64 = 64.0;

/// The least number of places, each as large as a neighbourhood, whose matches agree.
const LEAST_PLACES: usize = 16;
/// Patterns that repeat, as roofs, facades and waves, gave up to 104 matches that agree on a wrong geometry.
const LEAST_MATCHES: usize = 120;
/// The least share of the matches that agree with a right orientation: of moments, three quarters are right where it is hard.
const LEAST_SHARE: f64 = 0.6;
/// The least share of the points of the image with fewer that is matched where photos show the same ground, without matches that confirmed ones
/// contradict; repeated patterns reach 4 %.
const LEAST_MATCHED: f64 = 0.03;
/// Half the widths of the intervals of an angle and of the direction of the base within which an orientation is of use.
const LARGEST_ANGLE_DEG: f64 = 5.0;
const LARGEST_BASE_DEG: f64 = 20.0;
/// σ₀ that matching reaches where the camera is right, and that it never reaches but within one image, in px.
pub const LARGEST_SIGMA0_PX: f64 = 1.0;
const LEAST_SIGMA0_PX: f64 = 0.02;
/// σ₀ of what somebody measured, as a share of the focal length: half a millimetre in an aerial photo, and ten pixels of a camera.
const LARGEST_MEASURED_SIGMA0: f64 = 1.0 / 300.0;
/// Standard error of a focal length that the pair itself determines, as a share of it. The rotation takes part in its errors, which matches
/// tell worse than they say where the ground is flat or the lens is not what k1 describes: wrong poses had 3.6 % and more, and errors of
/// 1.5° 2.1 %.
const LARGEST_FOCAL_ERROR: f64 = 0.02;
/// Root mean square distance of points from their middle, in focal lengths, of an image that is twice as long as the focal length.
const LARGEST_COVERAGE: f64 = 0.72;

/// The orientation of matches with what speaks against it among its warnings; `points`: how many each image has, of which they were matched.
pub fn judged(found: RelativeOrientation, matches: &[Match], interior: &PairInterior, points: Option<[usize; 2]>) -> RelativeOrientation {
    let positions: Vec<[f64; 4]> = matches.iter().map(|m| [m.left_px[0], m.left_px[1], m.right_px[0], m.right_px[1]]).collect();
    let accepted = accepted(&positions, &found.rejected);
    let evidence = evidence(matches, &found.rejected);
    let least_matches = points.map_or(LEAST_MATCHES, least_matches);
    let places = places_of(&evidence);
    // Without redundancy nothing tells the precision: there are too few matches.
    let sigma0_px = found.sigma0_mm.unwrap_or(f64::NAN) / interior.left.pixel_mm();
    let is_calibrated = self_calibration::is_calibrated(interior);
    let told = [
        (is_mirrored(&accepted), Warning::Mirrored),
        (interior.left.is_mirrored(), Warning::MirroredMarks { side: Side::Left }),
        (interior.right.is_mirrored(), Warning::MirroredMarks { side: Side::Right }),
        (self_calibration::tells_more(interior) && !is_determined(&found), Warning::UnknownCamera),
        few_agree(accepted.len(), positions.len()),
        (evidence.len() < least_matches, Warning::FewMatches { matches: evidence.len(), least: least_matches }),
        (places < LEAST_PLACES, Warning::FewPlaces { places, least: LEAST_PLACES }),
        (sigma0_px < LEAST_SIGMA0_PX, Warning::Exact { sigma0_px, least_px: LEAST_SIGMA0_PX }),
        (sigma0_px > LARGEST_SIGMA0_PX, Warning::Imprecise { sigma0_px, most_px: LARGEST_SIGMA0_PX }),
        (is_calibrated && reaches_far(&found), Warning::WideAngle { coverage: found.spread, most: LARGEST_COVERAGE }),
        uncertain(&found),
        uncertain_base(&found),
    ];
    // Whether there are two photographs comes before all else. Scans with fiducial marks are.
    let similarity_alone = (!interior.are_scans && may_be_one(&positions)).then_some(Warning::SimilarityAlone);
    // What was known before stands before the figures that follow from it.
    let warnings = similarity_alone
        .into_iter()
        .chain(interior.doubt)
        .chain(found.warnings.iter().copied())
        .chain(told.into_iter().filter(|(holds, _)| *holds).map(|(_, warning)| warning));
    RelativeOrientation { warnings: warnings.collect(), ..found }
}

/// The orientation of observations that somebody measured, with what speaks against it among its warnings. What tells matches of a repeated pattern
/// from others, as their number, does not count: nobody measures these. Nor does their precision in px, whose size is not known, but that by the focal
/// length does: of few observations most may be wrong, and none is worse than the others. What seems to be no parallax follows from it.
pub fn judged_observations(found: RelativeOrientation, observations: &[Observation]) -> RelativeOrientation {
    let positions: Vec<[f64; 4]> = observations.iter().map(|o| [o.left[0], o.left[1], o.right[0], o.right[1]]).collect();
    let accepted = accepted(&positions, &found.rejected);
    let [sigma0_um, most_um] = [found.sigma0_mm.unwrap_or(f64::NAN), LARGEST_MEASURED_SIGMA0 * found.focal_mm].map(|mm| 1000.0 * mm);
    let coarse = (sigma0_um > most_um).then_some(Warning::Coarse { sigma0_um, most_um });
    let told = [
        (is_mirrored(&accepted), Warning::Mirrored),
        few_agree(accepted.len(), positions.len()),
        (reaches_far(&found), Warning::WideAngle { coverage: found.spread, most: LARGEST_COVERAGE }),
        uncertain(&found),
        uncertain_base(&found),
    ];
    let told = told.into_iter().filter(|(holds, _)| *holds).map(|(_, warning)| warning);
    RelativeOrientation { warnings: coarse.into_iter().chain(found.warnings.iter().copied()).chain(told).collect(), ..found }
}

/// Each warning with whether it holds.
type Told = (bool, Warning);

fn few_agree(accepted: usize, matches: usize) -> Told {
    ((accepted as f64) < LEAST_SHARE * matches as f64, Warning::FewAgree { accepted, matches })
}

fn reaches_far(found: &RelativeOrientation) -> bool {
    found.spread > LARGEST_COVERAGE
}

fn uncertain(found: &RelativeOrientation) -> Told {
    let half_width_deg = found.half_widths_95.map_or(f64::NAN, |half| half.omega_deg.max(half.phi_deg).max(half.kappa_deg));
    (half_width_deg > LARGEST_ANGLE_DEG, Warning::Uncertain { half_width_deg, most_deg: LARGEST_ANGLE_DEG })
}

fn uncertain_base(found: &RelativeOrientation) -> Told {
    let half_width_deg = base_half_width_deg(found);
    (half_width_deg > LARGEST_BASE_DEG, Warning::UncertainBase { half_width_deg, most_deg: LARGEST_BASE_DEG })
}

/// The least number of matches by which a pair with so many points is oriented.
pub(crate) fn least_matches([left, right]: [usize; 2]) -> usize {
    LEAST_MATCHES.max((LEAST_MATCHED * left.min(right) as f64).ceil() as usize)
}

/// Whether the matches tell the focal lengths of both cameras that nobody knew.
fn is_determined(found: &RelativeOrientation) -> bool {
    let is_known = |camera: &EstimatedCamera| camera.focal_standard_error_mm <= LARGEST_FOCAL_ERROR * camera.focal_mm;
    found.cameras.is_some_and(|cameras| cameras.iter().all(is_known))
}

/// Half the width of the interval of the direction of the base; no number where there is none.
pub(super) fn base_half_width_deg(found: &RelativeOrientation) -> f64 {
    let across = found.half_widths_95.map_or(f64::NAN, |half| libm::hypot(half.by_mm, half.bz_mm));
    libm::atan2(across, found.base_mm.abs()).to_degrees()
}

fn accepted(positions: &[[f64; 4]], rejected: &[usize]) -> Vec<[f64; 4]> {
    let mut is_accepted = vec![true; positions.len()];
    rejected.iter().for_each(|k| is_accepted[*k] = false);
    positions.iter().zip(is_accepted).filter(|(_, accepted)| *accepted).map(|(at, _)| *at).collect()
}

/// The positions of the matches that agree and that none of the others foretold: where interest points were matched, those of two points.
fn evidence(matches: &[Match], rejected: &[usize]) -> Vec<[f64; 4]> {
    let of_points = matches.iter().any(|m| m.right.is_some());
    let mut counts: Vec<bool> = matches.iter().map(|m| m.right.is_some() || !of_points).collect();
    rejected.iter().for_each(|k| counts[*k] = false);
    let counted = matches.iter().zip(counts).filter(|(_, counts)| *counts);
    counted.map(|(m, _)| [m.left_px[0], m.left_px[1], m.right_px[0], m.right_px[1]]).collect()
}

/// How many neighbourhoods of the photo where they are fewer hold matches: those of one share errors, and count as one.
fn places_of(matches: &[[f64; 4]]) -> usize {
    let cell = |v: f64| libm::floor(v / NEIGHBOURHOOD_PX) as i64;
    let count = |side: usize| matches.iter().map(|at| [cell(at[side]), cell(at[side + 1])]).collect::<BTreeSet<_>>().len();
    count(0).min(count(2))
}

/// Whether the best affine map from left to right positions changes their sense of rotation. Two views of one side of the ground keep it.
fn is_mirrored(matches: &[[f64; 4]]) -> bool {
    let mean = |k: usize| matches.iter().map(|at| at[k]).sum::<f64>() / matches.len().max(1) as f64;
    let middle = [mean(0), mean(1), mean(2), mean(3)];
    let sum = |i: usize, j: usize| matches.iter().map(|at| (at[i] - middle[i]) * (at[j] - middle[j])).sum::<f64>();
    // The determinant of the map is that of this matrix by the positive one of the left positions.
    sum(2, 0) * sum(3, 1) - sum(2, 1) * sum(3, 0) < 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matches_of_one_neighbourhood_count_as_one() {
        let at = |k: usize, step: f64| [step * k as f64, 10.0, 5.0 + step * k as f64, 10.0];
        let near: Vec<_> = (0..50).map(|k| at(k, 1.0)).collect();
        let far: Vec<_> = (0..50).map(|k| at(k, 64.0)).collect();
        assert_eq!((places_of(&near), places_of(&far)), (1, 50));
        assert_eq!(places_of(&accepted(&far, &(0..20).collect::<Vec<_>>())), 30);
        // Many places of one photo, a single one of the other.
        let onto_one: Vec<_> = far.iter().map(|p| [p[0], p[1], 3.0, 3.0]).collect();
        assert_eq!(places_of(&onto_one), 1);
    }

    #[test]
    fn a_mirrored_photo_is_told_from_a_turned_one() {
        let at = |k: usize| [(37 * k % 101) as f64, (53 * k % 97) as f64];
        let onto = |map: fn([f64; 2]) -> [f64; 2]| -> Vec<[f64; 4]> {
            (0..40).map(|k| (at(k), map(at(k)))).map(|([a, b], [c, d])| [a, b, c, d]).collect()
        };
        assert!(is_mirrored(&onto(|[x, y]| [500.0 - x, y])) && is_mirrored(&onto(|[x, y]| [x, 500.0 - 2.0 * y])));
        assert!(!is_mirrored(&onto(|[x, y]| [500.0 - x, 400.0 - y])) && !is_mirrored(&onto(|[x, y]| [y, 300.0 - x])));
        assert!(!is_mirrored(&[]));
    }
}
