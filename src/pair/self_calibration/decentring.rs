//! What the decentring of lenses does to the observations of a pair, which does not estimate it. Its linear part along the base is that of κ, which no
//! other constant of a camera shares: it grows with the base, so that κ drifts along a strip.

use super::causes::in_threes;
use super::constants::{differences, is_uncertain};
use crate::camera::CameraUncertainty;
use crate::pair::geometry::PairInterior;
use crate::{Interior, SharedErrors};

/// What errors of the terms p1 and p2 of the lenses do to the observations: one lens where `cameras` is 1, else one to a side. Nothing of lenses that
/// are known without error.
pub fn decentring_errors(given: &PairInterior, positions: &[[f64; 4]], cameras: usize) -> Vec<SharedErrors> {
    if !is_uncertain(given) {
        return Vec::new();
    }
    let sides: &[[bool; 2]] = if cameras == 1 { &[[true, true]] } else { &[[true, false], [false, true]] };
    let causes: Vec<Vec<[f64; 4]>> =
        sides.iter().flat_map(|on| [0, 1].map(|term| differences(positions, |step| decentred(given, *on, term, step)))).collect();
    in_threes(positions.len(), causes.len(), |index, cause| causes[cause][index].map(|effect| given.focal_mm * effect))
}

/// The cameras with a term of the decentring of some sides changed by `step` of its prior standard deviations.
fn decentred(given: &PairInterior, on: [bool; 2], term: usize, step: f64) -> PairInterior {
    let changed = |side: &Interior, is_on: bool| {
        let mut own = *side;
        let prior = side.uncertainty.unwrap_or(CameraUncertainty::NONE).decentring_beside(side.tangential_distortion);
        own.tangential_distortion[term] += if is_on { step * prior / given.focal_mm } else { 0.0 };
        own
    };
    PairInterior { left: changed(&given.left, on[0]), right: changed(&given.right, on[1]), ..*given }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::CameraMm;

    fn pair(uncertainty: CameraUncertainty) -> PairInterior {
        let camera = CameraMm { uncertainty: Some(uncertainty), ..CameraMm::without_distortion(5.0, Some(0.005)) };
        let side = Interior::from_pixel_size(&camera, 1200, 800).unwrap();
        PairInterior { left: side, right: side, focal_mm: 5.0, doubt: None, one_lens: false, are_scans: false }
    }

    #[test]
    fn decentring_moves_a_point_by_the_square_of_its_distance() {
        // 500 px right of the middle, half a focal length: p1 moves it along x by 3 r², p2 along y by r².
        let errors = decentring_errors(&pair(CameraUncertainty::GIVEN), &[[1100.0, 400.0, 600.0, 400.0]], 1);
        let [by_p1, by_p2, nothing] = errors[0].effects[0];
        let prior = CameraUncertainty::GIVEN.decentring();
        let near = |found: [f64; 4], wanted: [f64; 4]| found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-9);
        assert!(near(by_p1.map(f64::abs), [5.0 * prior * 0.75, 0.0, 0.0, 0.0]), "{by_p1:?}");
        assert!(near(by_p2.map(f64::abs), [0.0, 5.0 * prior * 0.25, 0.0, 0.0]), "{by_p2:?}");
        assert_eq!((errors.len(), nothing), (1, [0.0; 4]));
    }

    #[test]
    fn two_lenses_are_decentred_each_by_itself_and_a_lens_without_error_is_not() {
        let at = [[1100.0, 400.0, 100.0, 400.0]];
        let errors = decentring_errors(&pair(CameraUncertainty::GIVEN), &at, 2);
        // Two terms of either lens, three to a group.
        assert_eq!(errors.len(), 2);
        let [first, _, third] = errors[0].effects[0];
        assert!(first[0] != 0.0 && first[2] == 0.0 && third[0] == 0.0 && third[2] != 0.0, "{first:?} {third:?}");
        assert!(decentring_errors(&pair(CameraUncertainty::NONE), &at, 1).is_empty());
    }

    #[test]
    fn a_camera_that_states_its_decentring_knows_it() {
        let at = [[1100.0, 400.0, 600.0, 400.0]];
        let by_p1 = |tangential| {
            let mut pair = pair(CameraUncertainty::GIVEN);
            [&mut pair.left, &mut pair.right].into_iter().for_each(|side| side.tangential_distortion = tangential);
            decentring_errors(&pair, &at, 1)[0].effects[0][0][0]
        };
        let share = by_p1([1e-6, -1e-6]) / by_p1([0.0; 2]);
        assert!((share - 0.1).abs() < 1e-6, "{share}");
    }
}
