//! A finished block in the coordinate reference system that was chosen: the adjustment has a Cartesian one, that touches the earth at the block.
//!
//! Positions are converted one by one. Angles, differences and standard errors turn into the axes of the system at their place, so that κ holds the
//! convergence of the meridians; lengths stay those on the ground, without the scale of the projection. A difference as large as a gross error is one
//! of coordinates: its two places have other axes.

use super::precision::{ImageErrors, image_errors, point_errors, written};
use crate::crs::{CoordinateSystem, HeightReference, HeightZero};
use crate::math::{dot3, median};
use crate::pipeline::is_place_of_orthophoto;
use crate::text::shorten;
use crate::{
    BlockImage, BlockModel, BlockRun, LeftOut, Pose, ReconstructedModel, Remark, SurveyedPoint, geographic_from_local,
    parse_ground_control_points,
};
use serde::Serialize;
use std::borrow::Cow;

/// Larger differences are gross errors, in m.
const GROSS_M: f64 = 10.0;

/// Rows of directions in another system.
type Axes = [[f64; 3]; 3];

/// A finished block in the system of its results.
pub(super) struct InSystem<'a> {
    run: &'a BlockRun,
    /// With the longitude, latitude and height where the system of the adjustment touches the earth; absent where results are in that.
    chosen: Option<(CoordinateSystem, [f64; 3])>,
}

impl<'a> InSystem<'a> {
    pub fn of(run: &'a BlockRun) -> Self {
        let origin = run.model.origin.map(|origin| [origin.longitude_deg, origin.latitude_deg, origin.height_m]);
        Self { run, chosen: run.system().zip(origin) }
    }

    /// The model that is written.
    pub fn model(&self) -> Cow<'a, BlockModel> {
        if self.chosen.is_none() {
            return Cow::Borrowed(&self.run.model);
        }
        let mut model = self.run.model.clone();
        for pose in model.images.iter_mut().filter_map(|image| image.pose.as_mut()) {
            let axes = self.axes(pose.position);
            *pose = Pose { rotation: pose.rotation.map(|row| turned(&axes, row)), position: self.place(pose.position) };
        }
        model.points.iter_mut().filter_map(|point| point.position.as_mut()).for_each(|position| *position = self.place(*position));
        Cow::Owned(model)
    }

    /// Of each image of the block; those of angles are about the axes of the adjustment, and so are the correlations of positions.
    pub fn image_errors(&self) -> Vec<ImageErrors> {
        let mut errors = image_errors(self.run);
        if self.chosen.is_some() {
            for (image, errors) in self.run.model.images.iter().zip(&mut errors) {
                let Some((pose, position)) = image.pose.zip(errors.position.as_mut()) else { continue };
                position.errors = turned_errors(&self.axes(pose.position), position.errors, position.correlations.unwrap_or_default());
            }
        }
        errors
    }

    /// Standard errors of each point of the model that is written; older projects lack correlations.
    pub fn point_errors(&self) -> Vec<Option<[f64; 3]>> {
        let mut errors = point_errors(self.run);
        if self.chosen.is_some() {
            for (point, errors) in self.run.model.points.iter().zip(&mut errors) {
                let Some((place, known)) = point.position.zip(errors.as_mut()) else { continue };
                known.errors = turned_errors(&self.axes(place), known.errors, known.correlations.unwrap_or_default());
            }
        }
        errors.into_iter().map(|known| known.map(|known| known.errors)).collect()
    }

    /// The surveyed points of the model that is written.
    pub fn surveyed(&self) -> Cow<'a, [SurveyedPoint]> {
        written(self.run).map_or(Cow::Borrowed(&[]), |model| self.points_of(model))
    }

    /// The surveyed points of a model of the block.
    pub fn points_of<'m>(&self, ReconstructedModel { surveyed, .. }: &'m ReconstructedModel) -> Cow<'m, [SurveyedPoint]> {
        if self.chosen.is_none() { Cow::Borrowed(surveyed) } else { surveyed.iter().map(|point| self.surveyed_point(point)).collect() }
    }

    fn surveyed_point(&self, point: &SurveyedPoint) -> SurveyedPoint {
        // What is adjusted has the standard errors, wherever the point was surveyed.
        let axes = self.axes(sum(point.position, point.difference_m));
        let errors = |sigma: [f64; 3]| turned_errors(&axes, sigma, [0.0; 3]);
        let known = |errors: [Option<f64>; 3]| Some([errors[0]?, errors[1]?, errors[2]?]);
        let left_out = point.left_out.map(|left| LeftOut {
            difference: self.difference(point.position, left.difference),
            standard_errors: errors(left.standard_errors),
        });
        SurveyedPoint {
            position: self.place(point.position),
            difference_m: self.difference(point.position, point.difference_m),
            // One that is absent is part of no other.
            standard_errors_m: known(point.standard_errors_m).map_or(point.standard_errors_m, |sigma| errors(sigma).map(Some)),
            left_out,
            detectable_m: known(point.detectable_m).map_or(point.detectable_m, |detectable| errors(detectable).map(Some)),
            ..point.clone()
        }
    }

    /// What leads from a place to another one along the axes there, or of gross errors by its coordinates; in m.
    fn difference(&self, from: [f64; 3], apart: [f64; 3]) -> [f64; 3] {
        let to = sum(from, apart);
        let of_coordinates = self.chosen.as_ref().filter(|_| dot3(&apart, &apart).sqrt() > GROSS_M).and_then(|(system, origin)| {
            let [to, from] = [to, from].map(|place| system.coordinates(geographic_from_local(place, *origin)));
            Some(system.difference_m(to?, from?))
        });
        of_coordinates.unwrap_or_else(|| turned(&self.axes(to), apart))
    }

    /// What is said of the system; absent where none was chosen.
    pub fn system(&self) -> Option<ResultSystem> {
        let (system, origin) = self.chosen.as_ref()?;
        Some(ResultSystem {
            name: system.definition().name(),
            definition: system.definition().text().to_string(),
            operation: system.operation().map(String::from),
            accuracy_m: system.accuracy_m(),
            geoid_m: system.zero().above_m([origin[0], origin[1]]),
            geoid: self.run.geoid.as_ref().map(|geoid| geoid.name.clone()),
            gnss_above_m: self.gnss_above_m(),
        })
    }

    /// The remarks of the run, and what is to be said of the system.
    pub fn remarks(&self) -> Vec<Remark> {
        let mut remarks = self.run.remarks.clone();
        let crs = || self.run.input.settings.placing.crs.clone();
        remarks.extend(match self.system() {
            Some(ResultSystem { name: crs, operation, accuracy_m, gnss_above_m, .. }) => {
                Some(Remark::ResultSystem { crs, operation, accuracy_m, gnss_above_m })
            }
            None => crs().map(|crs| Remark::NoResultSystem { crs: shorten(&crs) }).or_else(|| self.gnss_without_system()),
        });
        remarks.extend(self.geoid().or_else(|| self.ellipsoidal()));
        remarks
    }

    /// How high the geoid of heights lies where the images are.
    fn geoid(&self) -> Option<Remark> {
        let (system, origin) = self.chosen.as_ref()?;
        let HeightZero::Geoid(geoid) = system.zero() else { return None };
        let poses = self.run.model.images.iter().filter_map(|image| image.pose);
        let heights = poses.map(|pose| {
            let [longitude, latitude, _] = geographic_from_local(pose.position, *origin);
            geoid.above_m([longitude, latitude])
        });
        let [low_m, high_m] = heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(v), high.max(v)]);
        (low_m <= high_m).then(|| Remark::Geoid { name: geoid.name.clone(), low_m, high_m })
    }

    /// Heights that are above the ellipsoid although the system has heights of its own: those of GNSS positions, which nothing leads to these.
    fn ellipsoidal(&self) -> Option<Remark> {
        let (system, _) = self.chosen.as_ref()?;
        let has_own = system.definition().heights() == HeightReference::Other;
        let name = || system.definition().name();
        (has_own && !system.zero().is_known() && self.uses_gnss_heights()).then(|| Remark::EllipsoidalHeights { crs: name() })
    }

    /// Whether heights of GNSS positions take part.
    fn uses_gnss_heights(&self) -> bool {
        let has_height = |image: &BlockImage| image.gnss.is_some_and(|gnss| gnss.sigma[2].is_some());
        written(self.run).is_some_and(|model| model.adjusted.block.images.iter().any(has_height))
    }

    /// GNSS positions that take no part, since nothing leads from the earth to the control points.
    fn gnss_without_system(&self) -> Option<Remark> {
        let BlockRun { input, model, images, .. } = self.run;
        let positions = images.iter().filter(|image| image.gnss().is_some()).count();
        let mut rows = input.control.iter().flat_map(|texts| parse_ground_control_points(&texts.points).unwrap_or_default());
        // Places of an orthophoto are in its system.
        let has_control = rows.any(|row| row.role.is_some() && !is_place_of_orthophoto(&row.name));
        (input.use_gnss && has_control && model.origin.is_none() && positions > 0).then_some(Remark::GnssWithoutSystem { positions })
    }

    /// How much higher the GNSS positions are than where the block has them, where their heights take no part: the median.
    fn gnss_above_m(&self) -> Option<f64> {
        let (system, origin) = self.chosen.as_ref()?;
        if system.zero().is_known() || self.run.input.control.is_none() || !self.run.input.use_gnss {
            return None;
        }
        // Without control points they take part.
        if self.uses_gnss_heights() {
            return None;
        }
        let images = self.run.images.iter().zip(&self.run.model.images);
        let mut above: Vec<f64> = images
            .filter_map(|(image, modelled)| {
                let [_, _, height] = geographic_from_local(modelled.pose?.position, *origin);
                Some(image.gnss()?.height_m? - height)
            })
            .collect();
        median(&mut above)
    }

    /// What lies outside the system has no place in it.
    fn place(&self, position: [f64; 3]) -> [f64; 3] {
        let Some((system, origin)) = &self.chosen else { return position };
        system.coordinates(geographic_from_local(position, *origin)).unwrap_or([f64::NAN; 3])
    }

    fn axes(&self, position: [f64; 3]) -> Axes {
        let chosen = self.chosen.as_ref();
        let axes = chosen.and_then(|(system, origin)| system.axes(geographic_from_local(position, *origin), *origin));
        axes.unwrap_or([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    }
}

fn sum(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| a[k] + b[k])
}

/// A vector in the axes.
fn turned(axes: &Axes, vector: [f64; 3]) -> [f64; 3] {
    axes.map(|axis| dot3(&axis, &vector))
}

/// Standard errors along the axes; `correlations` of x with y, of x with z, of y with z.
fn turned_errors(axes: &Axes, [x, y, z]: [f64; 3], [xy, xz, yz]: [f64; 3]) -> [f64; 3] {
    axes.map(|[a, b, c]| {
        let (p, q, r) = (a * x, b * y, c * z);
        (p * p + q * q + r * r + 2.0 * (p * q * xy + p * r * xz + q * r * yz)).max(0.0).sqrt()
    })
}

/// The coordinate reference system of the results of a block.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ResultSystem {
    /// As the EPSG registry has it, or the text.
    pub name: String,
    /// As it was given.
    pub definition: String,
    /// What the registry calls the operation to WGS 84; absent for what the text states, and where none is needed.
    pub operation: Option<String>,
    /// Accuracy of this operation, as the registry states it.
    pub accuracy_m: Option<f64>,
    /// The height of the zero of its heights above the ellipsoid of WGS 84, in the middle of the block; absent where it is not known.
    pub geoid_m: Option<f64>,
    /// Name of the file of the geoid from which they count; absent where none was given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub geoid: Option<String>,
    /// How much higher the GNSS positions are than where the block has them, where their heights took no part.
    pub gnss_above_m: Option<f64>,
}
