//! How well points would be determined that are measured in a finished block: a map of expected standard errors.
//!
//! A new point is intersected from all images that show it. Its observations have the standard error of an image coordinate, and share the errors
//! of the exterior orientations and cameras, whose covariances are those of the adjustment.

use super::precision::written;
use crate::adjustment::{Part, PartCovariances, Unknown};
use crate::camera::rotation_from_angles;
use crate::catalogue::SIGMA_PX;
use crate::error::refuse;
use crate::math::median;
use crate::orthophoto::{BlockMap, Seen, epsg_of, heights_on_map, write_floats};
use crate::text::{Row, table};
use crate::{BlockRun, Camera, CameraParameter, Error, Georeference, Heights, Pose, Refusal};
use nalgebra::{DMatrix, DVector, Matrix3};
use std::collections::BTreeMap;

/// The covariances between more images would fill the memory of a browser tab.
const MOST_IMAGES: usize = 300;
/// Cells on the longer side, where no cell is given.
const USUAL_CELLS: f64 = 80.0;
/// Cells that a map has at most.
const MOST_CELLS: f64 = 100_000.0;
/// Images from which a point is intersected at most, the nearest: more hardly change it.
const MOST_RAYS: usize = 16;
/// Steps of the differences by which derivatives are taken: of angles, of a length as a share of the distance, in px, and of terms of distortion.
const ANGLE_STEP: f64 = 1e-6;
const LENGTH_STEP: f64 = 1e-6;
const PX_STEP: f64 = 1e-3;
const TERM_STEP: f64 = 1e-6;

/// Expected standard errors over the ground of a block, in the system of its results: its coordinate reference system, where it has one. Standard errors are
/// lengths on the ground, without the scale of a projection.
#[derive(Debug, Clone, PartialEq)]
pub struct AccuracyMap {
    pub georeference: Georeference,
    /// The code of its system, where that is known.
    pub epsg: Option<u16>,
    /// The unit of its coordinates in m, where it has a system.
    pub unit_m: Option<f64>,
    pub width: usize,
    pub height: usize,
    /// Standard error of an image coordinate of the points that would be measured, in px.
    pub sigma_px: f64,
    /// Row by row.
    pub cells: Vec<Expected>,
}

/// What is expected of a point in the middle of a cell, on the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Expected {
    /// The height of the ground; NaN where the tie points give none.
    pub ground: f64,
    /// Images that show it.
    pub images: usize,
    /// Standard errors in plan, of X and Y together, and in height; NaN below two images.
    pub plan: f64,
    pub height: f64,
}

/// Figures of a map.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct AccuracySummary {
    /// Standard error of an image coordinate of the points that would be measured, in px.
    pub sigma_px: f64,
    /// Side of a cell.
    pub cell: f64,
    /// Cells that two or more images show.
    pub cells: usize,
    /// Of these the share that three or more show, 0 to 1.
    pub three_or_more: f64,
    /// Of these the median standard errors, and those that 95 % of the cells do not exceed.
    pub plan: [f64; 2],
    pub height: [f64; 2],
    /// Mean number of images that show a cell.
    pub images: f64,
}

/// The map of the model that is written, on the ground that its tie points give. `cell`: the side of a cell, in units of the block; absent: an
/// eightieth of the longer side. `sigma_px`: the standard error of an image coordinate; absent: σ₀ of the block.
///
/// # Errors
/// [`Error::InvalidInput`] for a block that is not oriented, or whose project does not keep all of its adjustment, for more than 300 images, and for a
/// cell or standard error out of range, and for a coordinate reference system in degrees; [`Error::TooFew`] for less than ten points, and without redundancy; [`Error::Degenerate`] where the normal
/// equations are singular.
pub fn accuracy_map(run: &BlockRun, cell: Option<f64>, sigma_px: Option<f64>) -> Result<AccuracyMap, Error> {
    let Some(model) = written(run) else { return refuse(Refusal::CovariancesNotOriented) };
    if model.lacks_support() {
        return refuse(Refusal::CovariancesUnsupported);
    }
    let adjusted = &model.adjusted.block;
    if adjusted.images.len() > MOST_IMAGES {
        return refuse(Refusal::AccuracyImages { images: adjusted.images.len(), most: MOST_IMAGES });
    }
    let sigma_px = sigma_px.or(model.adjusted.unit_error_px).unwrap_or(f64::NAN);
    if !SIGMA_PX.contains(&sigma_px) {
        return refuse(Refusal::AccuracySigma { sigma_px });
    }
    let map = BlockMap::of(run)?;
    let ground = Heights::Model(heights_on_map(&run.model, map.as_ref())?);
    let (georeference, [width, height]) = grid(&ground, cell)?;
    let parts: Vec<Part> = (0..adjusted.images.len()).map(Part::Image).chain((0..adjusted.cameras.len()).map(Part::Camera)).collect();
    let (block, accepted) = model.with_support();
    let covariances = model.adjusted.covariances(&block, &accepted, &parts)?;
    let images = adjusted.images.iter().map(|image| (&adjusted.cameras[image.camera], &image.pose));
    let views: Vec<View<'_>> = images
        .enumerate()
        .map(|(k, (camera, pose))| View::new(camera, pose, unknowns_of(&covariances, k, adjusted.images.len() + adjusted.images[k].camera)))
        .collect();
    let cells = (0..width * height).map(|k| {
        let place = georeference.ground([(k % width) as f64 + 0.5, (k / width) as f64 + 0.5]);
        let on_map = ground.at(place).map(|z| [place[0], place[1], z]);
        let adjusted = on_map.and_then(|place| map.as_ref().map_or(Some(place), |map| map.to_adjustment(place)));
        match on_map.zip(adjusted) {
            Some(([.., ground], point)) => Expected { ground, ..expected(&views, &covariances, point, sigma_px) },
            None => Expected { ground: f64::NAN, images: 0, plan: f64::NAN, height: f64::NAN },
        }
    });
    let unit_m = map.as_ref().map(|map| map.unit_m);
    Ok(AccuracyMap { georeference, epsg: epsg_of(run, map.as_ref()), unit_m, width, height, sigma_px, cells: cells.collect() })
}

impl AccuracyMap {
    /// The standard errors in plan, in height, and the number of images, as GeoTIFF of floating-point numbers each; NaN stands for nothing.
    ///
    /// # Errors
    /// As [`write_geotiff`](crate::write_geotiff).
    pub fn rasters(&self) -> Result<[Vec<u8>; 3], Error> {
        let raster = |value: fn(&Expected) -> f64| {
            let values: Vec<f32> = self.cells.iter().map(|cell| value(cell) as f32).collect();
            write_floats([self.width, self.height], &values, &self.georeference, self.epsg, self.unit_m)
        };
        Ok([raster(|cell| cell.plan)?, raster(|cell| cell.height)?, raster(|cell| cell.images as f64)?])
    }

    /// `accuracy.csv`: the middles of the cells that an image shows.
    pub fn table(&self) -> String {
        let shown = self.cells.iter().enumerate().filter(|(_, cell)| cell.images > 0);
        let rows = shown.map(|(k, cell)| {
            let [x, y] = self.georeference.ground([(k % self.width) as f64 + 0.5, (k / self.width) as f64 + 0.5]);
            let known = |value: f64| if value.is_nan() { None } else { Some(value) };
            let row = Row::default().number(x).number(y).number(cell.ground).number(cell.images);
            row.known(known(cell.plan)).known(known(cell.height))
        });
        table(&["x", "y", "z", "images", "plan_error", "height_error"], rows)
    }

    pub fn summary(&self) -> AccuracySummary {
        let seen: Vec<&Expected> = self.cells.iter().filter(|cell| cell.plan.is_finite()).collect();
        let share = |number: f64| if seen.is_empty() { 0.0 } else { number / seen.len() as f64 };
        let figures = |value: fn(&Expected) -> f64| {
            let mut values: Vec<f64> = seen.iter().map(|cell| value(cell)).collect();
            values.sort_by(f64::total_cmp);
            let most = values.len().checked_sub(1).map_or(f64::NAN, |last| values[(0.95 * last as f64).ceil() as usize]);
            [median(&mut values).unwrap_or(f64::NAN), most]
        };
        AccuracySummary {
            sigma_px: self.sigma_px,
            cell: self.georeference.gsd(),
            cells: seen.len(),
            three_or_more: share(seen.iter().filter(|cell| cell.images >= 3).count() as f64),
            plan: figures(|cell| cell.plan),
            height: figures(|cell| cell.height),
            images: share(seen.iter().map(|cell| cell.images as f64).sum()),
        }
    }
}

/// The cells over the ground.
fn grid(ground: &Heights, cell: Option<f64>) -> Result<(Georeference, [usize; 2]), Error> {
    let Heights::Model(model) = ground else { unreachable!("the heights are those of the tie points") };
    let [columns, rows] = model.size();
    let of = model.georeference;
    let [wide, high] = [columns, rows].map(|number| number as f64 * of.gsd());
    let cell = cell.unwrap_or(wide.max(high) / USUAL_CELLS);
    let least = (wide * high / MOST_CELLS).sqrt();
    if !(cell >= least && cell <= wide.max(high)) {
        return refuse(Refusal::AccuracyCell { cell, least, most: wide.max(high) });
    }
    Ok((Georeference::north_up(of.origin, cell), [wide, high].map(|length| ((length / cell).ceil() as usize).max(1))))
}

/// An oriented image with the places of its unknowns among the covariances.
struct View<'a> {
    camera: &'a Camera,
    pose: &'a Pose,
    seen: Seen<'a>,
    unknowns: Vec<(usize, Unknown)>,
}

/// The unknowns of an image and of its camera, by the indices of their parts.
fn unknowns_of(covariances: &PartCovariances, image: usize, camera: usize) -> Vec<(usize, Unknown)> {
    let all = covariances.unknowns.iter().enumerate();
    all.filter(|(_, (part, ..))| *part == image || *part == camera).map(|(place, (_, unknown, _))| (place, *unknown)).collect()
}

impl<'a> View<'a> {
    fn new(camera: &'a Camera, pose: &'a Pose, unknowns: Vec<(usize, Unknown)>) -> Self {
        Self { camera, pose, seen: Seen::new(camera, pose), unknowns }
    }

    /// Square of the distance of the projection centre.
    fn distance(&self, [x, y, z]: &[f64; 3]) -> f64 {
        let [a, b, c] = self.pose.position;
        (x - a) * (x - a) + (y - b) * (y - b) + (z - c) * (z - c)
    }

    /// What a change of an unknown by one does to the position of a point in px; none where the image does not show it.
    fn derivative(&self, point: &[f64; 3], unknown: Unknown) -> Option<[f64; 2]> {
        let step = match unknown {
            Unknown::Angle(_) => ANGLE_STEP,
            Unknown::Coordinate(_) => LENGTH_STEP * self.distance(point).sqrt(),
            Unknown::Parameter(CameraParameter::Focal | CameraParameter::PrincipalX | CameraParameter::PrincipalY) => PX_STEP,
            Unknown::Parameter(_) => TERM_STEP,
        };
        let at = |change: f64| match unknown {
            Unknown::Angle(angle) => {
                let mut angles = self.pose.angles();
                angles[angle] += change;
                let pose = Pose::new(&rotation_from_angles(angles[0], angles[1], angles[2]), self.pose.position);
                position(self.camera, &pose, point)
            }
            Unknown::Coordinate(axis) => {
                let mut pose = *self.pose;
                pose.position[axis] += change;
                position(self.camera, &pose, point)
            }
            Unknown::Parameter(parameter) => {
                let mut values = self.camera.values();
                let place = CameraParameter::ALL.iter().position(|other| *other == parameter)?;
                values[place] += change;
                position(&self.camera.with_values(values), self.pose, point)
            }
        };
        let (more, less) = (at(step)?, at(-step)?);
        Some([0, 1].map(|k| (more[k] - less[k]) / (2.0 * step)))
    }
}

/// Where a camera has a point, also beyond its image.
fn position(camera: &Camera, pose: &Pose, point: &[f64; 3]) -> Option<[f64; 2]> {
    let [u, v, w] = pose.to_photo(point);
    (w < 0.0).then(|| camera.project(-u / w, v / w))
}

/// What is expected of a point.
fn expected(views: &[View<'_>], covariances: &PartCovariances, point: [f64; 3], sigma_px: f64) -> Expected {
    let mut showing: Vec<&View<'_>> = views.iter().filter(|view| view.seen.at(&point).is_some()).collect();
    let images = showing.len();
    let none = Expected { ground: point[2], images, plan: f64::NAN, height: f64::NAN };
    showing.sort_by(|a, b| a.distance(&point).total_cmp(&b.distance(&point)));
    showing.truncate(MOST_RAYS);
    if showing.len() < 2 {
        return none;
    }
    match covariance(&showing, covariances, &point, sigma_px) {
        Some(found) => Expected { plan: (found[(0, 0)] + found[(1, 1)]).max(0.0).sqrt(), height: found[(2, 2)].max(0.0).sqrt(), ..none },
        None => none,
    }
}

/// The covariance matrix of a point that is intersected from images, whose orientations share errors.
fn covariance(views: &[&View<'_>], covariances: &PartCovariances, point: &[f64; 3], sigma_px: f64) -> Option<Matrix3<f64>> {
    let size = 2 * views.len();
    let mut by_point = DMatrix::<f64>::zeros(size, 3);
    let mut by_unknown: BTreeMap<usize, Vec<f64>> = BTreeMap::new();
    for (k, view) in views.iter().enumerate() {
        for axis in 0..3 {
            // Moving the point is moving the projection centre the other way.
            let [column, row] = view.derivative(point, Unknown::Coordinate(axis))?;
            (by_point[(2 * k, axis)], by_point[(2 * k + 1, axis)]) = (-column, -row);
        }
        for (place, unknown) in &view.unknowns {
            let [column, row] = view.derivative(point, *unknown)?;
            let effects = by_unknown.entry(*place).or_insert_with(|| vec![0.0; size]);
            (effects[2 * k], effects[2 * k + 1]) = (column, row);
        }
    }
    let places: Vec<usize> = by_unknown.keys().copied().collect();
    let effects = DMatrix::from_columns(&by_unknown.into_values().map(DVector::from_vec).collect::<Vec<_>>());
    let shared = DMatrix::from_fn(places.len(), places.len(), |r, c| covariances.rows[places[r]][places[c]]);
    let observed = DMatrix::identity(size, size) * (sigma_px * sigma_px) + &effects * shared * effects.transpose();
    let weighted = observed.cholesky()?.solve(&by_point);
    let normal = by_point.transpose() * weighted;
    Matrix3::from_fn(|r, c| normal[(r, c)]).try_inverse()
}
