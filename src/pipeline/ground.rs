//! A finished block in the system of an orthophoto: places of its ground that images show become ground control points.

use super::focal_change::tell_by_ground;
use super::gross_places::{GROSS, beside_neighbours, beyond};
use super::linked_places::linked_places;
use super::mistakes::{explain_control, tell_elsewhere};
use super::place_factors::{PlaceFactors, PlaceResidual, place_factors};
use super::place_names::{PLACE_NAME, is_place_of_orthophoto, own_control};
use super::points::reconstruction_options;
use super::state::describe;
use super::stated_errors::tell_stated_errors;
use super::system::system_of;
use super::{BlockRun, ControlTexts, NotLinked, OnOrthophoto, RunInput};
use crate::crs::HeightZero;
use crate::error::refuse;
use crate::formats::{ground_control_table, image_measurement_table};
use crate::math::{dot3, median, scatter};
use crate::reconstruction::{CommonShift, SHARED, origin_of, with_further_control};
use crate::{
    BlockDescription, ControlPoint, ControlRole, Error, Failure, GroundControlRow, ImageMeasurementRow, ObservationVerdict, PointSource,
    PriorStatistics, ReconstructedModel, ReconstructionOptions, Refusal, Remark, parse_ground_control_points, parse_image_measurements,
};
use std::collections::{BTreeMap, BTreeSet};

/// Points that take part, at least: fewer do not tell which of them are wrong.
const LEAST_POINTS: usize = 10;
/// Adjustments until no point is rejected and no weight changes any more, at most.
const MOST_ADJUSTMENTS: usize = 24;
/// The change of a standard error, as a share of it, that is none.
const SAME: f64 = 0.05;

/// A place of the ground of an orthophoto, and where images show it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct GroundPoint {
    pub place: [f64; 3],
    /// Standard errors in plan and of the height, of this point alone.
    pub sigma: [f64; 2],
    /// Standard error of a coordinate in an image, in px.
    pub sigma_px: f64,
    pub role: ControlRole,
    /// Index of the image, column and row in px.
    pub seen: Vec<(usize, [f64; 2])>,
}

impl BlockRun {
    /// The block as it was found, adjusted anew in the system of these points, beside ground control points that were given, and GNSS positions
    /// where this is its coordinate reference system; edits by hand are not kept then. `epsg`: the code of the orthophoto's system. `remarks`: what is to be said of it. Points that contradict the others are rejected and stay in its table of ground control points. Where most do, or where the
    /// ground control points contradict them, the block is not changed and keeps its edits.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for ground control points of the same names; as [`not_linked`](Self::not_linked).
    pub(crate) fn on_ground(&self, points: &[GroundPoint], epsg: Option<u16>, remarks: &[Remark]) -> Result<Self, Error> {
        let mut found = self.found();
        found.remarks.retain(|remark| !remark.is_of_orthophoto());
        found.remarks.extend_from_slice(remarks);
        match Ground::new(&found, points, epsg)?.adjusted()? {
            Ok(run) => Ok(run),
            Err(not_linked) => found.not_linked(not_linked)?.with_edits_of(self),
        }
    }

    /// The block with the edits that it has, and why places that are found on the orthophoto do not bring it into its system: where places by hand hold it
    /// there, that is said of it as it was found.
    ///
    /// # Errors
    /// As [`with_edits`](Self::with_edits).
    pub(crate) fn not_linked(&self, not_linked: NotLinked) -> Result<Self, Error> {
        Self { orthophoto: Some(OnOrthophoto::NotLinked { not_linked }), ..self.found() }.with_edits_of(self)
    }
}

/// The points of an orthophoto beside the ground control points of a block.
struct Ground<'a> {
    found: &'a BlockRun,
    /// Those that were given.
    own: Vec<GroundControlRow>,
    /// Those of the orthophoto; one that was rejected has no role.
    added: Vec<GroundControlRow>,
    /// Of these what is stated: standard errors in plan and height, and whether one is to check the others.
    stated: Vec<([f64; 2], ControlRole)>,
    /// By how much the standard errors are enlarged.
    factors: PlaceFactors,
    measurements: Vec<ImageMeasurementRow>,
    /// The code of the orthophoto's system.
    epsg: Option<u16>,
}

/// An adjustment by them.
struct Attempt {
    input: RunInput,
    description: BlockDescription,
    model: ReconstructedModel,
}

impl<'a> Ground<'a> {
    fn new(found: &'a BlockRun, points: &[GroundPoint], epsg: Option<u16>) -> Result<Self, Error> {
        let given = found.input.control.as_ref();
        let own = given.map(|texts| parse_ground_control_points(&texts.points)).transpose()?.unwrap_or_default();
        let mut measurements = given.map(|texts| parse_image_measurements(&texts.marks)).transpose()?.unwrap_or_default();
        if let Some(same) = own.iter().find(|row| is_place_of_orthophoto(&row.name)) {
            return refuse(Refusal::ReservedName { name: same.name.clone(), begins: PLACE_NAME.into() });
        }
        let mut added = Vec::new();
        for (number, point) in (1..).zip(points) {
            let name = format!("{PLACE_NAME}{number}");
            let seen = point.seen.iter().filter_map(|(image, at)| Some((found.images.get(*image)?, at)));
            measurements.extend(seen.map(|(image, [x_px, y_px])| ImageMeasurementRow {
                image: image.name.clone(),
                point: name.clone(),
                x_px: *x_px,
                y_px: *y_px,
            }));
            added.push(GroundControlRow {
                name,
                position: point.place,
                standard_errors: Some(point.sigma),
                role: Some(point.role),
                sigma_px: Some(point.sigma_px),
            });
        }
        let stated = points.iter().map(|point| (point.sigma, point.role)).collect();
        let factors = PlaceFactors { own: [1.0; 2], among_others: [1.0; 2] };
        let mut ground = Self { found, own, added, stated, factors, measurements, epsg };
        // At first the points are weighted as if they shared what they may share, which residuals do not show: the block hardly follows them, so
        // that residuals show their errors.
        let shared = SHARED * SHARED * ground.used(ControlRole::Control) as f64;
        ground.enlarge(PlaceFactors { among_others: [(1.0 + shared).sqrt(); 2], ..factors });
        Ok(ground)
    }

    /// Gives the points standard errors so many times as large as stated.
    fn enlarge(&mut self, factors: PlaceFactors) {
        self.factors = factors;
        for (row, (stated, role)) in self.added.iter_mut().zip(&self.stated) {
            let factors = if *role == ControlRole::Check { factors.own } else { factors.among_others };
            row.standard_errors = Some([0, 1].map(|k| factors[k] * stated[k]));
        }
    }

    /// By how much residuals enlarge the standard errors, where that differs from what was used. No point is more precise than stated.
    fn other_factors(&self, attempt: &Attempt) -> Option<PlaceFactors> {
        let residuals: Vec<PlaceResidual> = self.residuals(attempt).into_iter().map(|(_, residual)| residual).collect();
        let found = place_factors(&residuals)?;
        let at_least_as_stated = |factors: [f64; 2]| factors.map(|factor| factor.max(1.0));
        let factors = PlaceFactors { own: at_least_as_stated(found.own), among_others: at_least_as_stated(found.among_others) };
        let is_same = |now: [f64; 2], before: [f64; 2]| (0..2).all(|k| (now[k] / before[k] - 1.0).abs() < SAME);
        let is_settled = is_same(factors.among_others, self.factors.among_others) && is_same(factors.own, self.factors.own);
        (!is_settled).then_some(factors)
    }

    /// The residuals of the points that take part by what was stated of them, each with its row.
    fn residuals(&self, attempt: &Attempt) -> Vec<(usize, PlaceResidual)> {
        let Attempt { description, model, .. } = attempt;
        let rows = self.added.iter().enumerate().filter(|(_, row)| row.role == Some(ControlRole::Control));
        let used: BTreeMap<&str, usize> = rows.map(|(index, row)| (row.name.as_str(), index)).collect();
        let [plan, height] = self.factors.among_others;
        let control = model.adjusted.block.control.iter().zip(&model.adjusted.control);
        let residual = |(control, statistics): (&ControlPoint, &Option<PriorStatistics>)| {
            let PointSource::GroundControl(index) = model.points[control.point] else { return None };
            let statistics = statistics.as_ref().filter(|statistics| statistics.accepted)?;
            // What was used is what was stated times its factor.
            let sigma = [0, 1, 2].map(|k| control.sigma[k] / [plan, plan, height][k]);
            let row = *used.get(description.control[index].name.as_str())?;
            let at = [control.position[0], control.position[1]];
            let residual = [0, 1, 2].map(|k| statistics.residual[k] / sigma[k]);
            Some((row, PlaceResidual { at, residual, sigma, redundancy: statistics.redundancy? }))
        };
        control.filter_map(residual).collect()
    }

    fn used(&self, role: ControlRole) -> usize {
        self.added.iter().filter(|row| row.role == Some(role)).count()
    }

    /// The adjusted block, or why there is none.
    fn adjusted(mut self) -> Result<Result<BlockRun, NotLinked>, Error> {
        let points = self.used(ControlRole::Control);
        if points < LEAST_POINTS {
            return Ok(Err(NotLinked::FewPoints { points, needed: LEAST_POINTS }));
        }
        let places = self.own.iter().any(|row| row.role == Some(ControlRole::Control));
        // Alone first, so that what was given says whether it agrees.
        let checking: Vec<GroundControlRow> =
            self.own.iter().map(|row| GroundControlRow { role: row.role.and(Some(ControlRole::Check)), ..row.clone() }).collect();
        let others = if places { checking } else { self.own.clone() };
        let attempt = match self.settled(&others, points)? {
            Ok(attempt) if places => match contradiction(&attempt, self.shared_errors())? {
                Some(contradiction) => return Ok(Err(contradiction)),
                None => self.attempt(&self.own)?,
            },
            other => other,
        };
        attempt.map_or_else(|not_linked| Ok(Err(not_linked)), |attempt| self.run(attempt).map(Ok))
    }

    /// Adjusts until no point of so many is rejected, and residuals weight the points as they were weighted.
    fn settled(&mut self, own: &[GroundControlRow], points: usize) -> Result<Result<Attempt, NotLinked>, Error> {
        let mut last = self.attempt(own)?;
        // The latest without a point to reject, with what it was made of: a weighting that leads nowhere is not taken.
        let mut whole = None;
        for _ in 1..MOST_ADJUSTMENTS {
            let Ok(attempt) = last else { break };
            let rejected = self.gross(&attempt);
            if rejected.is_empty() {
                let Some(factors) = self.other_factors(&attempt) else { return Ok(Ok(attempt)) };
                whole = Some((attempt, self.added.clone(), self.factors));
                self.enlarge(factors);
            }
            rejected.iter().for_each(|row| self.added[*row].role = None);
            let left = self.used(ControlRole::Control);
            last = if left < LEAST_POINTS || 2 * left < points {
                Err(NotLinked::Disagreement { rejected: points - left, points })
            } else {
                self.attempt(own)?
            };
        }
        let Some((attempt, added, factors)) = whole.filter(|_| last.is_err()) else { return Ok(last) };
        (self.added, self.factors) = (added, factors);
        Ok(Ok(attempt))
    }

    /// What all points may share along the axes, in m.
    fn shared_errors(&self) -> [f64; 3] {
        let middle = |k: usize| median(&mut self.stated.iter().map(|(sigma, _)| sigma[k]).collect::<Vec<_>>()).unwrap_or(0.0);
        [middle(0), middle(0), middle(1)].map(|sigma| SHARED * sigma)
    }

    /// Adjusts by the points of the orthophoto and what was given, in these roles.
    fn attempt(&self, own: &[GroundControlRow]) -> Result<Result<Attempt, NotLinked>, Error> {
        let found = self.found;
        let Some(model) = found.reconstruction.as_ref().ok().and_then(|assembly| assembly.models.first()) else {
            return Ok(Err(NotLinked::NotOriented));
        };
        let points = ground_control_table(&[own, &self.added].concat());
        let texts = ControlTexts { points, marks: image_measurement_table(&self.measurements) };
        let input = RunInput { control: Some(texts), ..found.input.clone() };
        let described = input.clone().checked(found.geoid.as_ref()).and_then(|checked| {
            let (description, _) = describe(&checked, &found.images, &found.cameras)?;
            Ok((checked.settings, description))
        });
        let (settings, description) = match described {
            Ok(described) => described,
            // What was given could be in the system: the places of the orthophoto cannot.
            Err(error) if has_crs(&input) => return Ok(Err(NotLinked::Failed { failure: Failure::from(&error) })),
            Err(error) => return Err(error),
        };
        // Points of an orthophoto are judged below, many at a time.
        let options = ReconstructionOptions { tested_control: Some(own_control(&description)), ..reconstruction_options(&settings) };
        Ok(match with_further_control(model, &description, &options) {
            Ok(model) if model.in_system => Ok(Attempt { input, description, model }),
            Ok(_) => Err(NotLinked::Disagreement { rejected: self.added.len(), points: self.added.len() }),
            Err(error) if error.is_usage() => return Err(error),
            Err(error) => Err(NotLinked::Failed { failure: Failure::from(&error) }),
        })
    }

    /// The points that are rejected after an adjustment: those that images do not show alike, and of the others those that lie farthest from
    /// where the block has them, or from where their neighbours would. Differences of check points reject none of them.
    fn gross(&self, attempt: &Attempt) -> Vec<usize> {
        let Attempt { description, model, .. } = attempt;
        let row_of: BTreeMap<&str, usize> = self.added.iter().enumerate().map(|(row, point)| (point.name.as_str(), row)).collect();
        let row = |source: &PointSource| match source {
            PointSource::GroundControl(control) => row_of.get(description.control[*control].name.as_str()).copied(),
            PointSource::TiePoint(_) | PointSource::Manual(_) => None,
        };
        let mut whole: BTreeSet<usize> = model.points.iter().filter_map(row).collect();
        for (ray, statistics) in model.adjusted.block.rays.iter().zip(&model.adjusted.rays) {
            if statistics.verdict != ObservationVerdict::Accepted
                && let Some(row) = row(&model.points[ray.point])
            {
                whole.remove(&row);
            }
        }
        let apart = (0..self.added.len()).filter(|row| self.added[*row].role.is_some() && !whole.contains(row));
        let control = model.adjusted.block.control.iter().zip(&model.adjusted.control);
        let tests = control.filter_map(|(control, statistics)| Some((row(&model.points[control.point])?, statistics.as_ref()?.w?)));
        let tests: Vec<(usize, [f64; 3])> = tests.filter(|(row, _)| whole.contains(row)).collect();
        let largest = |w: &[f64; 3]| w.iter().fold(0.0, |most: f64, w| most.max(w.abs()));
        // Standard errors that were stated too small make no point wrong.
        let mut sizes: Vec<f64> = tests.iter().flat_map(|(_, w)| w.map(f64::abs)).collect();
        let scatter = scatter(&mut sizes).map_or(1.0, |found| found.max(1.0));
        let far = beyond(tests.iter().map(|(row, w)| (*row, largest(w) / scatter)).collect());
        let (rows, residuals): (Vec<usize>, Vec<PlaceResidual>) = self.residuals(attempt).into_iter().unzip();
        let unlike = beyond(rows.into_iter().zip(beside_neighbours(&residuals)).collect());
        apart.chain(far).chain(unlike).collect::<BTreeSet<usize>>().into_iter().collect()
    }

    /// The block of an adjustment.
    fn run(&self, attempt: Attempt) -> Result<BlockRun, Error> {
        let Attempt { input, description, mut model } = attempt;
        let found = self.found;
        let origin = origin_of(&description)?;
        let checked = input.clone().checked(found.geoid.as_ref())?;
        explain_control(&mut model, origin, &checked, reconstruction_options(&checked.settings).adjustment.limit());
        tell_elsewhere(&mut model, &description, &found.unknown_images, &found.images, &checked);
        tell_stated_errors(&mut model, &description, &found.images, &checked);
        if let Some(before) = found.reconstruction.as_ref().ok().and_then(|assembly| assembly.models.first()) {
            tell_by_ground(&mut model, before, &description);
        }
        let outcome = linked_places(&model, &description, &checked, self.epsg);
        let confidence = found.confidences();
        let mut reconstruction = found.reconstruction.clone().unwrap_or_default();
        reconstruction.models[0] = model;
        // Other models lie in the system that the block had.
        for other in &mut reconstruction.models[1..] {
            (other.in_system, other.surveyed) = (false, Vec::new());
        }
        reconstruction.origin = origin;
        let model = reconstruction
            .block_model_with(0, &description, found.found_points(), |point| confidence.get(&point).copied().unwrap_or(1.0))?;
        Ok(BlockRun { input, reconstruction: Ok(reconstruction), model, orthophoto: Some(outcome), ..found.clone() })
    }
}

fn has_crs(input: &RunInput) -> bool {
    input.settings.placing.crs.is_some()
}

/// Whether the ground control points of a block that lies where the orthophoto has it, and has them as check points, are all elsewhere. They are
/// given along the axes of the coordinate reference system, where the block has one. `shared`: standard errors of the orthophoto as a whole, which those of
/// the block do not hold.
fn contradiction(attempt: &Attempt, shared: [f64; 3]) -> Result<Option<NotLinked>, Error> {
    let own = own_control(&attempt.description);
    let Some(shift) = CommonShift::of_checks(&attempt.model, &attempt.description, own) else { return Ok(None) };
    let apart = shift.difference_m;
    if (0..3).all(|k| apart[k].abs() <= GROSS * libm::hypot(shift.errors_m[k], shared[k])) {
        return Ok(None);
    }
    let [x_m, y_m, z_m] = match attempt.axes()? {
        Some(axes) => axes.map(|axis| dot3(&axis, &apart)),
        None => apart,
    };
    Ok(Some(NotLinked::Contradiction { x_m, y_m, z_m }))
}

impl Attempt {
    /// The directions of the axes of the coordinate reference system in the middle of the block; absent without one.
    fn axes(&self) -> Result<Option<[[f64; 3]; 3]>, Error> {
        let Some(origin) = origin_of(&self.description)?.map(|origin| [origin.longitude_deg, origin.latitude_deg, origin.height_m]) else {
            return Ok(None);
        };
        let system = system_of(&self.input.settings.placing, &HeightZero::Unknown, &[], &[[origin[0], origin[1]]]).ok().flatten();
        Ok(system.and_then(|system| system.axes(origin, origin)))
    }
}
