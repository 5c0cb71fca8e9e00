//! From two images to their matches and relative orientation.

use super::cameras::{KnownPhoto, are_scans};
use super::described::{DescribedImage, describe_image};
use super::geometry::{PairInterior, known_photos, pair_interior};
use super::input::{PairImage, PairInput};
use super::no_orientation::NoOrientation;
use super::one_image::OneImage;
use super::orienting::orient_matches;
use super::rounds::{PairMatching, match_in_rounds};
use super::settings::PairSettings;
use super::weakness::judged;
use crate::{
    Degeneracy, Error, Expectation, MatchSet, NearestTable, NoGeometry, OffsetField, PointSet, RelativeOrientation, TwoView, Warning,
    estimate_offset,
};
use serde::{Deserialize, Serialize};

/// The outcome of one pair.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PairResult {
    pub left: PointSet,
    pub right: PointSet,
    /// Absent where the strategy needs none and none was given.
    pub offset: Option<OffsetField>,
    pub matching: MatchSet,
    /// As in [`PairMatching`].
    pub geometry: Option<Result<TwoView, NoGeometry>>,
    pub interior: Option<PairInterior>,
    /// The orientation; or why there is none.
    pub orientation: Result<RelativeOrientation, NoOrientation>,
}

/// Matches and orients a pair.
///
/// Where no camera is known, or the matches do not determine an orientation, the matches are given all the same.
///
/// # Errors
/// As the stages: [`Error::InvalidOption`], [`Error::ImageTooSmall`]; [`Error::InvalidInput`] for a camera or fiducials that do not fit.
pub fn match_pair(left: PairImage<'_>, right: PairImage<'_>, input: &PairInput, settings: &PairSettings) -> Result<PairResult, Error> {
    // What is wrong with the camera is told before the images are searched.
    pair_interior(left, right, input)?.ok();
    let described = [describe_image(left.grey, left.mask, settings)?, describe_image(right.grey, right.mask, settings)?];
    match_described_pair(left, right, described, None, input, settings)
}

/// The rest of [`match_pair`], once both images are described: for callers that do so at the same time, and that may also have searched for
/// the nearest right descriptors of all left ones. Masks have had their effect.
///
/// # Errors
/// As [`match_pair`].
pub fn match_described_pair(
    left: PairImage<'_>,
    right: PairImage<'_>,
    described: [DescribedImage; 2],
    nearest: Option<&NearestTable>,
    input: &PairInput,
    settings: &PairSettings,
) -> Result<PairResult, Error> {
    let settings = &settings.resolved();
    let interior = pair_interior(left, right, input)?;
    let strategy = settings.matching.strategy;
    let offset = match input.offset {
        Some([dx, dy]) => Some(OffsetField::constant(dx, dy)),
        None => strategy.needs_offset().then(|| estimate_offset(left.grey, right.grey)),
    };
    let images = [described[0].match_image(left.grey, strategy), described[1].match_image(right.grey, strategy)];
    let expected = offset.clone().unwrap_or(OffsetField::constant(0.0, 0.0));
    let PairMatching { set: matching, geometry } =
        match_in_rounds(images, Expectation { nearest, ..Expectation::from(&expected) }, interior.as_ref().ok(), settings)?;
    let found = geometry.as_ref().and_then(|geometry| geometry.as_ref().ok());
    let known = known_photos(left, right, input);
    let interior = match (interior, found) {
        // None takes the place of the camera that was given.
        (Err(reason), Some(found)) if input.camera.is_none() => assumed(reason, found, known),
        (interior, _) => interior,
    };
    let is_rotation = found.is_some_and(|found| found.degenerate == Some(Degeneracy::PureRotation));
    // Images of one have no base: that is said, not that the camera only turned, or that it is not known. Scans with fiducial
    // marks on both sides are of two photographs.
    let positions: Vec<[f64; 4]> = matching.matches.iter().map(|m| [m.left_px[0], m.left_px[1], m.right_px[0], m.right_px[1]]).collect();
    let one_image = if are_scans(&known) { None } else { OneImage::of(&positions, known.map(|photo| photo.size)) };
    let few = NoOrientation::of_few(matching.matches.len());
    let orientation = match (&interior, &geometry, one_image, few) {
        (Err(reason @ NoOrientation::Panorama { .. }), ..) => Err(reason.clone()),
        // No camera helps photos that have no geometry.
        (_, Some(Err(no_geometry)), ..) => Err(NoOrientation::NoGeometry { no_geometry: *no_geometry }),
        (_, _, Some(one_image), _) => Err(one_image.reason()),
        // Nor photos that hardly have matches.
        (.., Some(few)) => Err(few),
        (Err(reason), ..) => Err(reason.clone()),
        _ if is_rotation => Err(NoOrientation::PureRotation),
        (Ok(interior), ..) => match orient_matches(&matching.matches, interior, &settings.orientation) {
            Err(error) if error.is_usage() => return Err(error),
            Ok(found) => Ok(judged(found, &matching.matches, interior, Some(described.each_ref().map(|image| image.set.points.len())))),
            Err(error) => Err(NoOrientation::Refused { error }),
        },
    };
    let orientation = orientation.map_err(|reason| by_camera(reason, interior.as_ref().ok()));
    let [left, right] = described.map(|image| image.set);
    Ok(PairResult { left, right, offset, matching, geometry, interior: interior.ok(), orientation })
}

/// The interior orientations where no camera is known, for this reason; or why none can be assumed.
fn assumed(reason: NoOrientation, found: &TwoView, known: [KnownPhoto<'_>; 2]) -> Result<PairInterior, NoOrientation> {
    match reason {
        // No camera that may be assumed sees it.
        NoOrientation::Panorama { .. } => Err(reason),
        // Of other pairs an unknown camera is assumed: what stands in the way is the plane.
        _ => PairInterior::assumed(found, known).ok_or(NoOrientation::PlaneWithoutCamera),
    }
}

/// So many times as long a focal length as the file says, or as short, explains that nothing fits.
const FAR_OFF: f64 = 2.0;

/// Why there is no orientation: by a given focal length that is far from that of the file, or a principal point far from the middle of the image, where
/// nothing fits.
fn by_camera(reason: NoOrientation, interior: Option<&PairInterior>) -> NoOrientation {
    let fits_nothing = matches!(reason, NoOrientation::Refused { .. } | NoOrientation::NoGeometry { .. });
    match interior.and_then(|interior| interior.doubt) {
        // From a camera that looks aside photos seem to differ by a rotation.
        Some(Warning::FarPrincipalPoint { side, sides, most }) if fits_nothing || reason == NoOrientation::PureRotation => {
            NoOrientation::FarPrincipalPoint { side, sides, most }
        }
        _ if !fits_nothing => reason,
        Some(Warning::ContradictedFocal { side, given_px, file_px }) if !(1.0 / FAR_OFF..=FAR_OFF).contains(&(given_px / file_px)) => {
            NoOrientation::ContradictedFocal { side, given_px, file_px }
        }
        _ => reason,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{CameraMm, Interior, Side, TwoViewModel};

    #[test]
    fn without_a_camera_a_plane_is_the_reason_and_not_the_missing_camera_with_which_other_pairs_are_oriented() {
        let of = |model, reason| {
            let found =
                TwoView { model, inliers: vec![], threshold_px: 1.0, sigma_px: 0.3, degenerate: None, homography: None, focal: None };
            assumed(reason, &found, [KnownPhoto { size: (640, 480), exif: None, has_marks: false }; 2]).err()
        };
        let plane = || TwoViewModel::Homography { homography: [[1.0, 0.0, 9.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] };
        let general = || TwoViewModel::Fundamental { fundamental: [[0.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]] };
        let side = Side::Left;
        for reason in [NoOrientation::NoCamera { side }, NoOrientation::NoPixelSize { side }] {
            assert_eq!(of(general(), reason.clone()), None);
            assert_eq!(of(plane(), reason), Some(NoOrientation::PlaneWithoutCamera));
        }
        assert_eq!(of(general(), NoOrientation::Panorama { side }), Some(NoOrientation::Panorama { side }));
    }

    #[test]
    fn a_focal_length_far_from_that_of_the_file_explains_that_nothing_fits() {
        let own = Interior::from_pixel_size(&CameraMm::without_distortion(6.0, Some(0.01)), 640, 480).unwrap();
        let told = |reason: NoOrientation, given_px| {
            let doubt = Some(Warning::ContradictedFocal { side: Side::Left, given_px, file_px: 600.0 });
            let interior = PairInterior { left: own, right: own, focal_mm: 6.0, doubt, one_lens: true, are_scans: false };
            by_camera(reason, Some(&interior))
        };
        let refused = || NoOrientation::Refused {
            error: Error::Degenerate { cause: crate::Cause::NoPosition, computation: crate::Computation::RelativeOrientation },
        };
        for given_px in [60.0, 60_000.0] {
            assert_eq!(told(refused(), given_px), NoOrientation::ContradictedFocal { side: Side::Left, given_px, file_px: 600.0 });
        }
        assert_eq!(told(refused(), 800.0), refused());
        let doubt = Some(Warning::FarPrincipalPoint { side: Side::Right, sides: 0.7, most: 0.5 });
        let interior = PairInterior { left: own, right: own, focal_mm: 6.0, doubt, one_lens: true, are_scans: false };
        let far = NoOrientation::FarPrincipalPoint { side: Side::Right, sides: 0.7, most: 0.5 };
        for reason in [refused(), NoOrientation::PureRotation] {
            assert_eq!(by_camera(reason, Some(&interior)), far);
        }
        assert_eq!(by_camera(NoOrientation::OnePhoto, Some(&interior)), NoOrientation::OnePhoto);
        assert_eq!(told(NoOrientation::OnePhoto, 60.0), NoOrientation::OnePhoto);
    }
}
