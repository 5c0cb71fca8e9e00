//! What an adjustment by links says of the place of an image.

use super::adjusting::{PlaceErrors, mean_weight, variance_px2};
use super::links::{Found, Over};
use super::outcome::{Link, LinkChecks, LinkUse, Placement};
use super::precision::TotalErrors;
use super::rectify::Seen;
use super::relief::Relief;
use crate::{AdjustmentResult, Camera, ObservationVerdict};

/// Residuals of check links beyond so many standard errors are gross errors.
const GROSS: f64 = 3.29;
/// Cells of the image in which links are counted, on its longer side.
const CELLS: f64 = 8.0;

/// How a link takes part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    Used,
    Check,
    Rejected,
}

/// What comes of an adjustment, whose rays are the links that take part in their order.
pub(super) fn placement(
    over: &Over<'_>,
    links: &[Found],
    parts: &[Part],
    result: &AdjustmentResult,
    (errors, of_places): (&TotalErrors, PlaceErrors),
    relief: Relief,
) -> Placement {
    let (camera, pose) = (over.camera, over.pose);
    let seen = Seen::new(&camera, &pose);
    let variances: Vec<f64> = links.iter().map(|link| variance_px2(link, &camera, &pose, of_places)).collect();
    let used: Vec<f64> = variances.iter().zip(parts).filter(|(_, part)| **part == Part::Used).map(|(variance, _)| *variance).collect();
    let mean = mean_weight(&used);
    let mut rays = result.rays.iter();
    let linked = links.iter().zip(parts).zip(&variances).map(|((link, part), variance)| {
        let sigma_px = result.sigma0_px.map(|sigma0| sigma0 * (variance * mean).sqrt());
        let residual_px = seen.at(&link.place).map(|at| [link.at[0] - at[0], link.at[1] - at[1]]);
        let role = match part {
            Part::Check => LinkUse::Check,
            Part::Rejected => LinkUse::Rejected,
            Part::Used => match rays.next().map(|ray| ray.verdict) {
                Some(ObservationVerdict::Accepted) => LinkUse::Used,
                _ => LinkUse::Rejected,
            },
        };
        Link { at: link.at, place: link.place, residual_px, sigma_px, role, by_hand: false }
    });
    let links: Vec<Link> = linked.collect();
    let gsd_m = over.footprint().gsd();
    Placement {
        camera,
        camera_errors: errors.camera,
        pose,
        angles_deg: pose.angles().map(f64::to_degrees),
        angle_errors_deg: errors.angles_deg,
        position_errors_m: errors.position,
        above_ground_m: over.footprint().above_ground(),
        gsd_m,
        footprint: over.footprint().border(),
        sigma0_px: result.sigma0_px,
        rmse_px: rms(links.iter().filter(|link| link.role == LinkUse::Used)),
        degrees_of_freedom: result.degrees_of_freedom,
        coverage: coverage(&camera, &links),
        checks: check_links(&links, gsd_m),
        links,
        relief,
        film: None,
    }
}

/// Root mean square length of residuals, where there are any.
fn rms<'a>(links: impl Iterator<Item = &'a Link>) -> f64 {
    let residuals = links.filter_map(|link| link.residual_px);
    let (sum, number) = residuals.fold((0.0, 0_usize), |(sum, n), [x, y]| (sum + x * x + y * y, n + 1));
    if number == 0 { 0.0 } else { (sum / number as f64).sqrt() }
}

/// What the links say that took no part, those as far off as the used ones never are left apart.
fn check_links(links: &[Link], gsd_m: f64) -> Option<LinkChecks> {
    let checks = || links.iter().filter(|link| link.role == LinkUse::Check && link.residual_px.is_some());
    let number = checks().count();
    let limit = GROSS * rms(links.iter().filter(|link| link.role == LinkUse::Used));
    let within = |link: &&Link| link.residual_px.is_some_and(|[x, y]| libm::hypot(x, y) <= limit);
    let rmse_px = rms(checks().filter(within));
    let beyond = number - checks().filter(within).count();
    (number > 0).then_some(LinkChecks { number, beyond, rmse_px, rmse_m: rmse_px * gsd_m })
}

/// Share of the cells of the image that hold a used link.
fn coverage(camera: &Camera, links: &[Link]) -> f64 {
    let [width, height] = [camera.width_px, camera.height_px].map(f64::from);
    let side = width.max(height) / CELLS;
    let [columns, rows] = [width, height].map(|length| (length / side).ceil().max(1.0) as usize);
    let mut held = vec![false; columns * rows];
    for link in links.iter().filter(|link| link.role == LinkUse::Used) {
        let [column, row] = link.at.map(|v| (v / side) as usize);
        held[row.min(rows - 1) * columns + column.min(columns - 1)] = true;
    }
    held.iter().filter(|held| **held).count() as f64 / held.len() as f64
}

/// The placement in the system of the orthophoto itself.
pub(super) fn moved(mut placement: Placement, by: [f64; 2]) -> Placement {
    let plan = |place: &mut [f64]| (0..2).for_each(|k| place[k] += by[k]);
    plan(&mut placement.pose.position);
    placement.footprint.iter_mut().for_each(|corner| plan(corner));
    placement.links.iter_mut().for_each(|link| plan(&mut link.place));
    placement
}
