//! Matches of features from one image to the other, verified by the geometry that relates the two views and by their neighbours, and
//! completed by that geometry.

use super::frames::CommonFrame;
use super::geometry::PairInterior;
use crate::error::refuse;
use crate::matching::{square_distance_of, within_parallax_gradient};
use crate::two_view::two_view_from;
use crate::{
    DESCRIPTOR_BYTES, DescriptorMatch, Error, Group, Guide, GuidedOptions, Input, Interior, Located, NearestOptions, NoGeometry,
    PartlyGiven, Pinhole, Refusal, TwoView, TwoViewModel, TwoViewOptions, guided_matches, nearest_matches, two_view,
};
use serde::{Deserialize, Serialize};

/// Candidates lie within this many thresholds of the geometry: those beyond one tell how many wrong ones are within.
const REACH: f64 = 3.0;

/// Standard errors of a coordinate within which a match is kept, from a line and from a place: all but one good match in eighty. Distances
/// are normal in their middle only, and beyond this poor positions are as many as good ones (Rousseeuw & Leroy 1987, Robust Regression and
/// Outlier Detection).
const TRUSTED: [f64; 2] = [2.5, 2.96];

/// The geometry of fewer first matches may be off by more than guided ones can mend: it is searched for again among these.
const FEW: usize = 100;

/// Share of the first matches that agree whose descriptors tell how far apart those of right matches are.
const ALIKE: f64 = 0.99;

/// Options of [`match_features`].
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FeatureMatchOptions {
    pub nearest: NearestOptions,
    /// Width and height of both images in px: what lies at the same place of both frames is left out then, as film borders are. Absent:
    /// nothing is.
    pub sizes: Option<[[usize; 2]; 2]>,
    /// What is known of the cameras, and the search for what relates the views.
    pub geometry: TwoViewOptions,
}

impl PartlyGiven for FeatureMatchOptions {
    const GROUPS: &'static [Group] = &[
        Group { path: "nearest", parameters: NearestOptions::PARAMETERS },
        Group { path: "geometry", parameters: TwoViewOptions::PARAMETERS },
    ];
}

/// What is left of the matches of two images once their geometry is known, with those it added.
#[derive(Debug, Clone, PartialEq)]
pub struct VerifiedMatches {
    /// Those that agree with the geometry, in ascending order of the left features; none without one.
    pub matches: Vec<DescriptorMatch>,
    /// Its inliers are indices of `matches`: all of them. Or why there is none.
    pub geometry: Result<TwoView, NoGeometry>,
    /// Whether both images have a frame in common, as scans of film have.
    pub has_frame: bool,
}

/// Matches the features of two images: nearest descriptors, the geometry of the two views, then more matches along its epipolar lines (or
/// at the places that the map of a plane gives), and the geometry of all.
///
/// Positions are in px of cameras without distortion where `options.geometry` names cameras: see [`Interior::undistorted_px`].
///
/// # Errors
/// [`Error::InvalidOption`]; [`Error::InvalidInput`] where positions and descriptors do not fit together.
pub fn match_features(left: Located<'_>, right: Located<'_>, options: &FeatureMatchOptions) -> Result<VerifiedMatches, Error> {
    check_located(Input::LeftFeatures, left)?;
    check_located(Input::RightFeatures, right)?;
    let first = nearest_matches(left.descriptors, right.descriptors, &options.nearest)?;
    let place = |m: &DescriptorMatch| {
        let ([xl, yl], [xr, yr]) = (left.positions[m.left], right.positions[m.right]);
        [xl, yl, xr, yr]
    };
    let frame = options.sizes.and_then(|sizes| {
        CommonFrame::find(&first.iter().map(place).collect::<Vec<_>>(), sizes.map(|[width, height]| (width, height)), options.geometry.seed)
    });
    let found = verify(left, right, &first, |m| frame.is_some_and(|frame| frame.holds(&place(m))), &options.geometry)?;
    Ok(VerifiedMatches { has_frame: frame.is_some(), ..found })
}

/// Refuses features with positions and descriptors of different number.
fn check_located(input: Input, features: Located<'_>) -> Result<(), Error> {
    let (positions, bytes) = (features.positions.len(), features.descriptors.len());
    if positions * DESCRIPTOR_BYTES == bytes {
        return Ok(());
    }
    refuse(Refusal::DescribedBytes { input, positions, bytes, each: DESCRIPTOR_BYTES })
}

/// Finds the geometry of two views by matches of which many may be wrong, and all matches that agree with it but those that are
/// not wanted.
pub(super) fn verify(
    left: Located<'_>,
    right: Located<'_>,
    first: &[DescriptorMatch],
    unwanted: impl Fn(&DescriptorMatch) -> bool,
    options: &TwoViewOptions,
) -> Result<VerifiedMatches, Error> {
    let positions = |matches: &[DescriptorMatch]| -> Vec<[f64; 4]> {
        let both = |m: &DescriptorMatch| (left.positions[m.left], right.positions[m.right]);
        matches.iter().map(both).map(|([xl, yl], [xr, yr])| [xl, yl, xr, yr]).collect()
    };
    let first: Vec<DescriptorMatch> = first.iter().filter(|m| !unwanted(m)).copied().collect();
    let start = match two_view(&positions(&first), options) {
        Ok(start) => start,
        Err(error) => return Ok(VerifiedMatches { matches: Vec::new(), geometry: Err(NoGeometry::of(error)?), has_frame: false }),
    };
    let agreeing: Vec<DescriptorMatch> = start.inliers.iter().map(|k| first[*k]).collect();
    let largest_distance = Some(farthest_alike(left, right, &agreeing));
    let guided = GuidedOptions { radius_px: REACH * start.threshold_px, largest_distance, ..GuidedOptions::default() };
    let mut second = guided_matches(left, right, &guide(&start), &guided)?;
    second.retain(|m| !unwanted(m));
    let moving_together = |matches: &[DescriptorMatch]| -> Vec<DescriptorMatch> {
        matches.iter().zip(within_parallax_gradient(&positions(matches))).filter(|(_, stands)| *stands).map(|(m, _)| *m).collect()
    };
    let (agreeing, second) = (moving_together(&agreeing), moving_together(&second));
    // Along epipolar lines alone, more wrong matches may agree than right ones are added.
    let known = TwoViewOptions { threshold_px: Some(start.threshold_px), ..options.clone() };
    let better =
        if agreeing.len() < FEW { two_view(&positions(&second), &known) } else { two_view_from(&positions(&second), &known, &start) };
    let (found, matches) = match better {
        Ok(better) if better.inliers.len() >= agreeing.len() => {
            let matches = better.inliers.iter().map(|k| second[*k]).collect();
            (as_degenerate(better, &start), matches)
        }
        _ => (start, agreeing),
    };
    let (found, matches) = trusted(found, matches, positions, options);
    let geometry = Ok(TwoView { inliers: (0..matches.len()).collect(), ..found });
    Ok(VerifiedMatches { matches, geometry, has_frame: false })
}

/// How far apart descriptors of one place are at most, by matches that agree: few candidates near a line make any of them the nearest, and
/// these hardly resemble the point.
fn farthest_alike(left: Located<'_>, right: Located<'_>, agreeing: &[DescriptorMatch]) -> f64 {
    let mut squares: Vec<u32> = agreeing.iter().map(|m| square_distance_of(left, m.left, right, m.right)).collect();
    squares.sort_unstable();
    let rank = (ALIKE * squares.len() as f64) as usize;
    squares.get(rank.min(squares.len().saturating_sub(1))).map_or(0.0, |square| f64::from(*square).sqrt())
}

/// The matches within [`TRUSTED`] standard errors, and their geometry: strangers do not raise these any more.
fn trusted(
    found: TwoView,
    matches: Vec<DescriptorMatch>,
    positions: impl Fn(&[DescriptorMatch]) -> Vec<[f64; 4]>,
    options: &TwoViewOptions,
) -> (TwoView, Vec<DescriptorMatch>) {
    let trusted = match guide(&found) {
        Guide::Lines(_) => TRUSTED[0],
        Guide::Places(_) => TRUSTED[1],
    };
    let within = trusted * found.sigma_px;
    if within >= found.threshold_px || options.threshold_px.is_some() {
        return (found, matches);
    }
    let nearer = TwoViewOptions { threshold_px: Some(within), ..options.clone() };
    match two_view_from(&positions(&matches), &nearer, &found) {
        Ok(better) => {
            let matches = better.inliers.iter().map(|k| matches[*k]).collect();
            // Beyond the threshold there is nothing left by which strangers could be told from poor positions.
            (TwoView { sigma_px: found.sigma_px, ..better }, matches)
        }
        Err(_) => (found, matches),
    }
}

/// Whether calibrated views see a plane is told by the first matches: those found along epipolar lines agree with any geometry of these lines.
fn as_degenerate(found: TwoView, first: &TwoView) -> TwoView {
    match (&found.model, &first.model) {
        (TwoViewModel::Calibrated { .. }, TwoViewModel::Calibrated { .. }) => {
            TwoView { degenerate: first.degenerate, homography: first.homography, ..found }
        }
        _ => found,
    }
}

pub(super) fn guide(found: &TwoView) -> Guide {
    match found.model {
        TwoViewModel::Calibrated { fundamental, .. } | TwoViewModel::Fundamental { fundamental } => Guide::Lines(fundamental),
        TwoViewModel::Homography { homography } | TwoViewModel::Rotation { homography, .. } => Guide::Places(homography),
    }
}

/// The camera without distortion to which [`Interior::undistorted_px`] leads.
fn pinhole(interior: &Interior, focal_mm: f64) -> Pinhole {
    Pinhole { focal_px: Some(focal_mm / interior.pixel_mm()), principal_px: interior.principal_point_px() }
}

/// What is known of the cameras of a pair, as the geometry of two views takes it, with positions of its images in such cameras.
pub(super) struct IdealCameras<'a> {
    interior: Option<&'a PairInterior>,
    /// Middles of the images, for cameras that are not known.
    middles: [[f64; 2]; 2],
}

impl<'a> IdealCameras<'a> {
    pub(super) fn new(interior: Option<&'a PairInterior>, sizes: [(usize, usize); 2]) -> Self {
        Self { interior, middles: sizes.map(|(width, height)| [0.5 * width as f64, 0.5 * height as f64]) }
    }

    /// Options with these cameras.
    pub(super) fn options(&self, options: &TwoViewOptions) -> TwoViewOptions {
        let [left, right] = match self.interior {
            Some(interior) => [&interior.left, &interior.right].map(|side| pinhole(side, interior.focal_mm)),
            None => self.middles.map(|principal_px| Pinhole { focal_px: None, principal_px }),
        };
        TwoViewOptions { left: Some(left), right: Some(right), ..options.clone() }
    }

    /// Positions in the left (0) or the right (1) camera.
    pub(super) fn ideal(&self, side: usize, positions: impl Iterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
        match self.interior.map(|interior| [&interior.left, &interior.right][side]) {
            Some(own) => positions.map(|[x, y]| own.undistorted_px(x, y)).collect(),
            None => positions.collect(),
        }
    }
}
