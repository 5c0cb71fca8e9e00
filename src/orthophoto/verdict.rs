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
/// Half of the 95 % interval of the height above ground, as a share of it, above which the height is not known.
const MOST_HEIGHT: f64 = 0.05;
/// σ₀ above which links are no good ones, in px.
const USUAL_SIGMA0_PX: f64 = 2.0;

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
    let (height_m, half_width_m) = (placement.above_ground_m, half_widths(placement)[2]);
    if !(half_width_m <= MOST_HEIGHT * height_m) {
        return Some(PlacingWeakness::Height { height_m, half_width_m });
    }
    let sigma0_px = placement.sigma0_px.unwrap_or(0.0);
    (sigma0_px > USUAL_SIGMA0_PX).then_some(PlacingWeakness::Noise { sigma0_px, usual_px: USUAL_SIGMA0_PX })
}
