//! What comes of placing an image: its orientation in the system of the orthophoto, and what that is worth.

use super::relief::Relief;
use crate::message::messages;
use crate::{Camera, CameraParameter, Failure, FilmScan, PlaceSlip, Pose};
use serde::{Deserialize, Serialize};

messages! {
    /// Why an image has no place on an orthophoto.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum NotPlaced as "not_placed" {
        /// Of the matches too few agree on any place: chance alone would do as well.
        NoCommonPlace { matches: usize, agreeing: usize },
        /// Points agree on a place, and no orientation of the image sees them where they are.
        NoOrientation { points: usize },
        /// With the orientation that was found, links that should lie where it says lie anywhere.
        NotConfirmed { links: usize, agreeing: usize },
        /// The adjustment has no result.
        Failed { failure: Failure },
    }
}

messages! {
    /// What speaks against the orientation of an image on an orthophoto.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum PlacingWeakness as "placing_weakness" {
        FewLinks { links: usize, needed: usize },
        /// Links lie in too small a part of the image.
        Coverage { share: f64, needed: f64 },
        /// The links that took no part contradict the orientation.
        Checks { beyond: usize, checks: usize },
        /// Of the links that took part, most were rejected.
        Rejected { rejected: usize, links: usize },
        /// The height above ground is hardly known, for want of a camera.
        Height { height_m: f64, half_width_m: f64 },
        /// The place of the projection centre in plan is hardly known beside its height above ground.
        Plan { height_m: f64, half_width_m: f64 },
        /// The camera that the links ask for is not the one that was known: so many standard deviations of what was known apart.
        Camera { camera_parameter: CameraParameter, estimated_px: f64, prior_px: f64, apart: f64 },
        /// The focal length that was given is far from that which the file of the image says.
        ContradictedFocal { given_px: f64, file_px: f64 },
        /// The heights would have to be so many times what they are about their mean.
        HeightFactor { factor: f64, standard_error: f64 },
        /// In this share of the image points lie together elsewhere than the heights put them.
        Relief { displaced: f64 },
        /// It lies farther from its GNSS position, in plan, than receivers err and the place itself may be off.
        Gnss { plan_m: f64, usual_m: f64 },
        /// It lies so far from its GNSS position that one of them is of elsewhere, and what would bring one to the other.
        FarFromGnss { distance_km: f64, place_slip: PlaceSlip },
        /// It lies higher than its GNSS position, or lower (below 0), than that, the place itself and the heights of the ground may be off.
        GnssHeight { height_m: f64, usual_m: f64 },
        /// Links disagree far more than those of good pictures do.
        Noise { rmse_px: f64, usual_px: f64 },
    }
}

messages! {
    /// What the place of an image on an orthophoto is worth.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum PlacingVerdict as "placing_verdict" {
        /// `half_width_m`: of the 95 % interval of the projection centre, the largest of the three.
        Placed { links: usize, sigma0_px: f64, half_width_m: f64 },
        Weak { links: usize, placing_weakness: PlacingWeakness },
        NotPlaced { not_placed: NotPlaced },
    }
}

impl PlacingVerdict {
    /// Whether nothing speaks against the place of an image but the width of its intervals.
    pub(super) fn is_wide(&self) -> bool {
        matches!(self, Self::Weak { placing_weakness: PlacingWeakness::Height { .. } | PlacingWeakness::Plan { .. }, .. })
    }
}

messages! {
    /// How an image with a GNSS position was sought on an orthophoto whose system is known.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum PlaceSearch as "place_search" {
        /// It was found about its position, so far from it in plan.
        Gnss {
            within_m: f64,
            #[serde(default)]
            plan_m: f64,
        },
        /// It was found farther from its position, in plan, than receivers of cameras err, and is doubted for another reason.
        ApartFromGnss { plan_m: f64, usual_m: f64 },
        /// It was found so far from its position that one of them is of elsewhere, and is doubted for another reason.
        FarFromGnss { distance_km: f64, place_slip: PlaceSlip },
        /// It was found higher than its position, or lower (below 0), than both may err, and is doubted for another reason.
        HeightApartFromGnss { height_m: f64, usual_m: f64 },
        /// It was not: all that may be searched was.
        BeyondGnss { within_m: f64 },
    }
}

/// What a link is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum LinkUse {
    /// It took part.
    Used,
    /// Its residual is a gross error.
    Rejected,
    /// It took no part, and checks the orientation.
    Check,
}

/// A point of the image and the place that the orthophoto has for it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Link {
    /// Column and row in px; the centre of the top-left pixel is (0.5, 0.5).
    pub at: [f64; 2],
    /// In the system of the orthophoto; the height that of the height model.
    pub place: [f64; 3],
    /// Observed minus computed column and row in px; absent where the image does not see the place.
    pub residual_px: Option<[f64; 2]>,
    /// Standard error of each of its coordinates in the image, in px, in which that of its place has its part; absent without redundancy.
    #[serde(default)]
    pub sigma_px: Option<f64>,
    pub role: LinkUse,
    /// Whether it was measured by eye.
    #[serde(default)]
    pub by_hand: bool,
}

/// What the links say that took no part.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct LinkChecks {
    pub number: usize,
    /// So many are as far off as gross errors are.
    pub beyond: usize,
    /// Root mean square length of the residuals of the others, in px of the image.
    pub rmse_px: f64,
    /// The same on the ground.
    pub rmse_m: f64,
}

/// The orientation of an image in the system of an orthophoto.
///
/// Standard errors count what the links, the height model and the camera do not tell; an error that all places of the orthophoto share is in
/// none of them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Placement {
    /// Of the image; of a scan of film that of its frame.
    pub camera: Camera,
    /// Of f, c_x, c_y in px, k₁, k₂, k₃, p₁, p₂; absent for what was not estimated.
    pub camera_errors: [Option<f64>; 8],
    pub pose: Pose,
    /// ω, φ, κ.
    pub angles_deg: [f64; 3],
    pub angle_errors_deg: Option<[f64; 3]>,
    pub position_errors_m: Option<[f64; 3]>,
    pub above_ground_m: f64,
    /// Side of a pixel on the ground, in the mean of the image.
    pub gsd_m: f64,
    /// Where the border of the image meets level ground, from its top-left corner on to the right.
    pub footprint: Vec<[f64; 2]>,
    /// Standard error of a coordinate of the image whose place is known as well as those of all links in the mean.
    pub sigma0_px: Option<f64>,
    pub rmse_px: f64,
    pub degrees_of_freedom: usize,
    /// Share of the cells of the image that hold a link.
    pub coverage: f64,
    pub links: Vec<Link>,
    pub checks: Option<LinkChecks>,
    /// What the image says of the heights.
    #[serde(default)]
    pub relief: Relief,
    /// How a scan of film lies to its frame: positions and residuals of links are those of the scan. Absent where the image is of a camera without film.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub film: Option<FilmScan>,
}

/// An image with its verdict.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PlacedImage {
    pub verdict: PlacingVerdict,
    /// Absent where there is none.
    pub placement: Option<Placement>,
    /// Absent where it was not sought by a GNSS position.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub search: Option<PlaceSearch>,
}
