//! What the place of an image is worth, by its figures.

use super::outcome::{LinkUse, Placement, PlacingVerdict, PlacingWeakness};
use crate::math::student_limit;

/// Links below which an orientation is weak.
const LEAST_LINKS: usize = 30;
/// Cells of the image with a link, as a share, below which it is weak: a third of the image may lie beside the orthophoto.
const LEAST_COVERAGE: f64 = 0.25;
/// Check links as far off as gross errors, as a share, above which it is weak; and how many of them chance may bring.
const MOST_BEYOND: f64 = 0.3;
const BEYOND_BY_CHANCE: f64 = 3.0;
/// Half of the 95 % interval of a coordinate of the projection centre, as a share of the height above ground, above which it is not known.
const MOST_WIDTH: f64 = 0.05;
/// Root mean square length of the residuals above which links are no good ones, in px.
const USUAL_RMSE_PX: f64 = 3.0;

pub(super) fn verdict(placement: &Placement) -> PlacingVerdict {
    let links = placement.links.iter().filter(|link| link.role == LinkUse::Used).count();
    match weakness(placement, links) {
        Some(placing_weakness) => PlacingVerdict::Weak { links, placing_weakness },
        None => {
            let half_width_m = half_widths(placement).into_iter().fold(0.0, f64::max);
            PlacingVerdict::Placed { links, sigma0_px: placement.sigma0_px.unwrap_or(0.0), half_width_m }
        }
    }
}

/// Of the 95 % intervals of X₀, Y₀, Z₀.
fn half_widths(placement: &Placement) -> [f64; 3] {
    let limit = student_limit(0.05, placement.degrees_of_freedom);
    placement.position_errors_m.map_or([f64::INFINITY; 3], |errors| errors.map(|error| limit * error))
}

fn weakness(placement: &Placement, links: usize) -> Option<PlacingWeakness> {
    if links < LEAST_LINKS {
        return Some(PlacingWeakness::FewLinks { links, needed: LEAST_LINKS });
    }
    if placement.coverage < LEAST_COVERAGE {
        return Some(PlacingWeakness::Coverage { share: placement.coverage, needed: LEAST_COVERAGE });
    }
    if let Some(checks) = placement.checks.filter(|c| c.beyond as f64 > BEYOND_BY_CHANCE + MOST_BEYOND * c.number as f64) {
        return Some(PlacingWeakness::Checks { beyond: checks.beyond, checks: checks.number });
    }
    let rejected = placement.links.iter().filter(|link| link.role == LinkUse::Rejected).count();
    if rejected > links {
        return Some(PlacingWeakness::Rejected { rejected, links: rejected + links });
    }
    let (height_m, [x, y, z]) = (placement.above_ground_m, half_widths(placement));
    if !(z <= MOST_WIDTH * height_m) {
        return Some(PlacingWeakness::Height { height_m, half_width_m: z });
    }
    if !(x.max(y) <= MOST_WIDTH * height_m) {
        return Some(PlacingWeakness::Plan { height_m, half_width_m: x.max(y) });
    }
    let rmse_px = placement.rmse_px;
    (rmse_px > USUAL_RMSE_PX).then_some(PlacingWeakness::Noise { rmse_px, usual_px: USUAL_RMSE_PX })
}
