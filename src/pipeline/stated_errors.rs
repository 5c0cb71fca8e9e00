//! Standard errors of a table that cannot be metres: what the residuals say of them, and the unit in which they would fit.
//!
//! Residuals v beside standard errors σ have (v/σ)² of r in the mean, their redundancy: where millimetres were taken for metres, a millionth of that.
//! Observations that are stated so hardly count, and whatever checks them passes.

use super::input::Checked;
use super::result::RunImage;
use crate::math::{chi_square_quantile, median};
use crate::{
    BlockDescription, BlockWarning, ControlPoint, ControlRole, LengthUnit, Observed, PointSource, PriorStatistics, ReconstructedModel,
};

/// Standard errors so many times as large as the residuals have them are not in m: nobody is so careful.
const FAR: f64 = 20.0;
/// Probability that residuals of right standard errors say more.
const CHANCE: f64 = 0.001;
/// Points are not surveyed so badly, in m, unless the residuals say that they are: these are no smaller then than by this factor.
const IMPLAUSIBLE_M: f64 = 10.0;
const CONFIRMED: f64 = 3.0;
/// Errors that the positions of a flight share do not show in residuals: of receivers without corrections they are metres, and what residuals show is
/// some decimetres. So near, in m, are those of receivers with corrections.
const CORRECTED_M: f64 = 0.1;
/// Of positions that lie closer together, in residuals, nothing is told: a receiver indoors may repeat one.
const SPAN: f64 = 20.0;

/// Residuals are so large beside the standard errors of a unit, at least, unless they are of a smaller one.
const LEAST_OF_UNIT: f64 = 2.0 / 3.0;

/// A coordinate whose standard error stands in a column without a unit.
struct Stated {
    sigma: f64,
    residual: f64,
    redundancy: f64,
}

/// Says where standard errors of points or of GNSS positions are hardly in m.
pub(super) fn tell_stated_errors(model: &mut ReconstructedModel, description: &BlockDescription, images: &[RunImage], input: &Checked) {
    if !model.in_system {
        return;
    }
    let of_points = input.control.as_ref().and_then(|tables| {
        let stated = |name: &str| tables.error_columns.stated(tables.standard_errors(name).map_or([None; 2], |errors| errors.map(Some)));
        let doubt = doubt_of_points(&of_points(model, description, stated))?;
        Some(doubt.warning(Observed::Points, tables.error_columns.names()))
    });
    let of_positions = input.positions.as_ref().filter(|_| input.use_gnss).and_then(|table| {
        let columns = table.error_columns();
        let stated = |image: usize| columns.stated(images[image].given.map_or([None; 2], |given| given.standard_errors_m));
        let doubt = doubt_of_positions(&of_positions(model, stated), span(model))?;
        Some(doubt.warning(Observed::Positions, columns.names()))
    });
    model.warnings.extend([of_points, of_positions].into_iter().flatten());
}

/// The coordinates of control points that take part, and of check points, whose differences are what residuals are without redundancy lost.
fn of_points(model: &ReconstructedModel, description: &BlockDescription, stated: impl Fn(&str) -> [Option<f64>; 3]) -> Vec<Stated> {
    let control = |(control, statistics): (&ControlPoint, &Option<PriorStatistics>)| {
        let PointSource::GroundControl(index) = model.points[control.point] else { return None };
        let statistics = statistics.filter(|statistics| statistics.accepted)?;
        Some((stated(&description.control[index].name), statistics.residual, statistics.redundancy.unwrap_or_default()))
    };
    let used = model.adjusted.block.control.iter().zip(&model.adjusted.control).filter_map(control);
    let checks = model.surveyed.iter().filter(|point| point.role == ControlRole::Check);
    let checks = checks.map(|point| (stated(&point.name), point.difference_m, [1.0; 3]));
    used.chain(checks).flat_map(coordinates).collect()
}

fn of_positions(model: &ReconstructedModel, stated: impl Fn(usize) -> [Option<f64>; 3]) -> Vec<Stated> {
    let observed = model.images.iter().zip(&model.adjusted.images).filter_map(|(image, statistics)| {
        let statistics = statistics.gnss.filter(|statistics| statistics.accepted)?;
        Some((stated(*image), statistics.residual, statistics.redundancy?))
    });
    observed.flat_map(coordinates).collect()
}

fn coordinates((sigma, residual, redundancy): ([Option<f64>; 3], [f64; 3], [f64; 3])) -> impl Iterator<Item = Stated> {
    let of = move |k: usize| Some(Stated { sigma: sigma[k]?, residual: residual[k], redundancy: redundancy[k] });
    (0..3).filter_map(of)
}

/// Root mean square distance of the images from their middle, in m.
fn span(model: &ReconstructedModel) -> f64 {
    let positions: Vec<[f64; 3]> = model.adjusted.block.images.iter().map(|image| image.pose.position).collect();
    let count = positions.len().max(1) as f64;
    let variance = |k: usize| {
        let middle = positions.iter().map(|at| at[k]).sum::<f64>() / count;
        positions.iter().map(|at| (at[k] - middle) * (at[k] - middle)).sum::<f64>() / count
    };
    (0..3).map(variance).sum::<f64>().sqrt()
}

/// Standard errors that are hardly in m.
#[derive(Debug, PartialEq)]
struct Doubt {
    /// In the median.
    stated: f64,
    /// As the residuals have it; absent where nothing checks them.
    residual_m: Option<f64>,
}

impl Doubt {
    fn warning(self, observed: Observed, columns: Vec<String>) -> BlockWarning {
        let Self { stated, residual_m } = self;
        // Residuals hold errors of image measurements, too, so that they may be larger than those of millimetres; than those of centimetres they are no
        // smaller but by chance.
        let in_centimetres = residual_m.is_some_and(|residual| residual * FAR < stated && residual > LEAST_OF_UNIT * 0.01 * stated);
        let unit = if in_centimetres { LengthUnit::Centimetres } else { LengthUnit::Millimetres };
        BlockWarning::StatedErrors { observed, columns, stated, residual_m, unit }
    }
}

/// What residuals make of standard errors.
struct Found {
    /// In the median.
    stated: f64,
    /// The right ones by those that were stated, and the largest that this may be but for chance; absent where nothing checks them.
    factor: Option<[f64; 2]>,
}

fn found(coordinates: &[Stated]) -> Option<Found> {
    let stated = median(&mut coordinates.iter().map(|one| one.sigma).collect::<Vec<_>>())?;
    let redundancy: f64 = coordinates.iter().map(|one| one.redundancy).sum();
    let squares: f64 = coordinates.iter().map(|one| (one.residual / one.sigma) * (one.residual / one.sigma)).sum();
    let factor = (redundancy >= 1.0).then(|| [redundancy, chi_square_quantile(CHANCE, redundancy)].map(|by| (squares / by).sqrt()));
    Some(Found { stated, factor })
}

fn doubt_of_points(coordinates: &[Stated]) -> Option<Doubt> {
    let Found { stated, factor } = found(coordinates)?;
    let is_far = factor.is_some_and(|[_, most]| most * FAR < 1.0);
    let is_implausible = stated > IMPLAUSIBLE_M && factor.is_none_or(|[factor, _]| factor * CONFIRMED < 1.0);
    (is_far || is_implausible).then(|| Doubt { stated, residual_m: factor.map(|[factor, _]| factor * stated) })
}

/// Of GNSS positions residuals alone tell: those of a telephone may be wrong by tens of metres. `span`: of the images, in m.
fn doubt_of_positions(coordinates: &[Stated], span: f64) -> Option<Doubt> {
    let Found { stated, factor } = found(coordinates)?;
    let [factor, most] = factor?;
    let residual_m = factor * stated;
    (most * FAR < 1.0 && residual_m < CORRECTED_M && residual_m * SPAN < span).then_some(Doubt { stated, residual_m: Some(residual_m) })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Coordinates of so many points with these standard errors, whose residuals are those of `true_m`.
    fn coordinates(points: usize, sigma: f64, true_m: f64) -> Vec<Stated> {
        // Quantiles of a normal distribution stand for chance.
        let count = 3 * points;
        let redundancy = (count as f64 - 7.0) / count as f64;
        let residual = |k: usize| true_m * redundancy.sqrt() * crate::math::normal_quantile((k as f64 + 0.5) / count as f64);
        (0..count).map(|k| Stated { sigma, residual: residual(k), redundancy }).collect()
    }

    fn unit(doubt: Option<Doubt>) -> Option<LengthUnit> {
        match doubt?.warning(Observed::Points, Vec::new()) {
            BlockWarning::StatedErrors { unit, .. } => Some(unit),
            _ => None,
        }
    }

    #[test]
    fn points_in_millimetres_or_centimetres_are_told_by_their_residuals() {
        let of = |points, sigma, true_m| unit(doubt_of_points(&coordinates(points, sigma, true_m)));
        for points in [4, 6, 12] {
            assert_eq!(of(points, 20.0, 0.02), Some(LengthUnit::Millimetres), "{points}");
            // Residuals hold errors of image measurements, too.
            assert_eq!(of(points, 8.0, 0.02), Some(LengthUnit::Millimetres), "{points}");
        }
        assert_eq!(of(8, 2.0, 0.02), Some(LengthUnit::Centimetres));
        // Few points may fit by chance.
        assert_eq!(of(3, 2.0, 0.02), None);
        // Errors that are stated too large are no other unit.
        for (sigma, true_m) in [(0.02, 0.02), (0.05, 0.01), (0.3, 0.03), (5.0, 4.0), (20.0, 15.0), (8.0, 1.0)] {
            assert_eq!(of(8, sigma, true_m), None, "{sigma} {true_m}");
        }
    }

    #[test]
    fn points_that_nobody_surveys_so_badly_are_told_where_residuals_do_not_confirm_it() {
        let alone = [Stated { sigma: 25.0, residual: 0.0, redundancy: 0.0 }];
        assert_eq!(doubt_of_points(&alone), Some(Doubt { stated: 25.0, residual_m: None }));
        assert_eq!(doubt_of_points(&[Stated { sigma: 5.0, ..alone[0] }]), None);
        // Beside positions of a receiver without corrections residuals are those of the positions.
        assert_eq!(unit(doubt_of_points(&coordinates(8, 20.0, 3.0))), Some(LengthUnit::Millimetres));
        assert_eq!(doubt_of_points(&[]), None);
    }

    #[test]
    fn positions_of_telephones_are_right_and_those_with_corrections_are_not_in_metres() {
        let of = |sigma, true_m, span| unit(doubt_of_positions(&coordinates(20, sigma, true_m), span));
        assert_eq!(of(20.0, 0.03, 100.0), Some(LengthUnit::Millimetres));
        assert_eq!(of(2.0, 0.03, 100.0), Some(LengthUnit::Centimetres));
        // What a flight shares does not show.
        for (sigma, true_m) in [(30.0, 0.5), (10.0, 0.3), (5.0, 0.2), (5.0, 4.0), (3.0, 1.0), (0.5, 0.03)] {
            assert_eq!(of(sigma, true_m, 100.0), None, "{sigma} {true_m}");
        }
        // A receiver indoors, which repeats itself.
        assert_eq!(of(10.0, 0.05, 0.8), None);
        assert_eq!(doubt_of_positions(&[Stated { sigma: 25.0, residual: 0.0, redundancy: 0.0 }], 100.0), None);
    }
}
