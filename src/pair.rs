//! The whole way of one pair: points, descriptors, offset, matches, photo coordinates, relative orientation.

use crate::{
    Camera, Error, ExifCamera, Fiducial, FiducialModel, GreyView, Interior, MatchOptions, MatchSet, Observation, OffsetField,
    OrientationOptions, PointOptions, PointSet, RelativeOrientation, WindowOptions, describe, detect, estimate_offset, match_points,
    orient_fiducials, orient_relative,
};
use serde::{Deserialize, Serialize};

/// The options of all stages.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PairSettings {
    pub points: PointOptions,
    pub window: WindowOptions,
    pub matching: MatchOptions,
    pub orientation: OrientationOptions,
}

/// What is known of one image of a pair.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PhotoInput {
    /// Measured fiducial marks; none for a digital camera.
    pub fiducials: Vec<Fiducial>,
    pub model: FiducialModel,
    /// Place `[col, row]` of the image's top-left pixel in the scan whose fiducials were measured.
    pub origin: Option<[f64; 2]>,
}

/// What is known of a pair beside its grey values.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PairInput {
    /// The camera of both images; absent: that of their EXIF.
    pub camera: Option<Camera>,
    pub left: PhotoInput,
    pub right: PhotoInput,
    /// Right minus left position `[dx, dy]` in px; absent: estimated.
    pub offset: Option<[f64; 2]>,
}

/// The interior orientations of a pair, of one focal length.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct PairInterior {
    pub left: Interior,
    pub right: Interior,
    pub focal_mm: f64,
}

/// The outcome of one pair.
#[derive(Debug, Clone, PartialEq)]
pub struct PairResult {
    pub left: PointSet,
    pub right: PointSet,
    pub offset: OffsetField,
    pub matching: MatchSet,
    pub interior: Option<PairInterior>,
    /// The orientation; or, in words, why there is none.
    pub orientation: Result<RelativeOrientation, String>,
}

/// An image with the camera that its file names.
#[derive(Clone, Copy)]
pub struct PairImage<'a> {
    pub grey: GreyView<'a>,
    pub exif: Option<&'a ExifCamera>,
}

/// Matches and orients a pair.
///
/// Where no camera is known, or the matches do not determine an orientation, the matches are given all the same.
///
/// # Errors
/// As the stages: [`Error::InvalidOption`], [`Error::ImageTooSmall`]; [`Error::InvalidInput`] for a camera or fiducials that do not fit.
pub fn match_pair(left: PairImage<'_>, right: PairImage<'_>, input: &PairInput, settings: &PairSettings) -> Result<PairResult, Error> {
    // What is wrong with the camera is told before the images are searched.
    let interior = pair_interior(left, right, input)?;
    let [left_points, right_points] = [detect(left.grey, &settings.points)?, detect(right.grey, &settings.points)?];
    let measure = settings.matching.measure;
    let left_descriptors = describe(left.grey, &left_points.points, &settings.window, measure)?;
    let right_descriptors = describe(right.grey, &right_points.points, &settings.window, measure)?;
    let offset = match input.offset {
        Some([dx, dy]) => OffsetField::constant(dx, dy),
        None => estimate_offset(left.grey, right.grey),
    };
    let described = ((&left_points.points[..], &left_descriptors[..]), (&right_points.points[..], &right_descriptors[..]));
    let matching = match_points(described.0, described.1, &offset, &settings.matching)?;
    let orientation = match &interior {
        Err(reason) => Err(reason.clone()),
        Ok(interior) => {
            let pairs = matching.matches.iter().map(|m| (left_points.points[m.left], right_points.points[m.right]));
            let positions: Vec<[f64; 4]> = pairs.map(|(l, r)| [l.x, l.y, r.x, r.y]).collect();
            match orient_relative(&observations(&positions, &interior.left, &interior.right), interior.focal_mm, &settings.orientation) {
                Err(error) if error.is_usage() => return Err(error),
                outcome => outcome.map_err(|error| error.to_string()),
            }
        }
    };
    Ok(PairResult { left: left_points, right: right_points, offset, matching, interior: interior.ok(), orientation })
}

/// Photo coordinates of matches, given as `[x_left, y_left, x_right, y_right]` in px.
pub fn observations(matches: &[[f64; 4]], left: &Interior, right: &Interior) -> Vec<Observation> {
    matches.iter().map(|[xl, yl, xr, yr]| Observation { left: left.photo_mm(*xl, *yl), right: right.photo_mm(*xr, *yr) }).collect()
}

/// The interior orientations; or, in words, what is missing.
fn pair_interior(left: PairImage<'_>, right: PairImage<'_>, input: &PairInput) -> Result<Result<PairInterior, String>, Error> {
    let of = |side: &'static str, image: PairImage<'_>, photo: &PhotoInput| {
        let camera = match (&input.camera, image.exif) {
            (Some(camera), _) => *camera,
            (None, Some(exif)) => Camera::from_exif(exif)?,
            (None, None) if photo.fiducials.is_empty() => {
                return Ok(Err(format!("no camera is given and the {side} image names no focal length")));
            }
            (None, None) => return Ok(Err("fiducials are given, but no focal length".to_string())),
        };
        if photo.fiducials.is_empty() && camera.pixel_mm.is_none() {
            return Ok(Err(format!("the {side} image has neither fiducials nor a pixel size")));
        }
        Ok(Ok((photo_interior(&camera, image.grey.width(), image.grey.height(), photo)?, camera.focal_mm)))
    };
    Ok(match (of("left", left, &input.left)?, of("right", right, &input.right)?) {
        (Ok((left, focal_mm)), Ok((right, right_focal))) => {
            // Only directions matter: the right photo is taken to the focal length of the left one.
            Ok(PairInterior { left, right: right.scaled(focal_mm / right_focal), focal_mm })
        }
        (Err(reason), _) | (_, Err(reason)) => Err(reason),
    })
}

/// The interior orientation of one image: from its fiducials, or from the camera's pixel size.
///
/// # Errors
/// [`Error::InvalidOption`] for the camera; as [`orient_fiducials`]; [`Error::InvalidInput`] for an origin without fiducials.
pub fn photo_interior(camera: &Camera, width: usize, height: usize, photo: &PhotoInput) -> Result<Interior, Error> {
    if !photo.fiducials.is_empty() {
        let marks = orient_fiducials(&photo.fiducials, photo.model)?;
        return Interior::from_fiducials(camera, &marks, photo.origin.unwrap_or([0.0; 2]));
    }
    match photo.origin {
        Some(origin) => Err(Error::InvalidInput {
            what: "origin in the scan",
            got: format!("{origin:?} without fiducials"),
            allowed: "an origin together with the fiducials measured in that scan".into(),
        }),
        None => Interior::from_pixel_size(camera, width, height),
    }
}
