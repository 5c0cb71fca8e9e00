//! The ground under photos, as far as it has to be built.

use super::buckets::Rectangle;
use super::photo::RayField;

/// The flattest ray that is allowed, as height over length.
const FLATTEST: f64 = 0.4;

/// The rectangle of ground that photos of a size in px show, down to the lowest relief; absent where a ray falls too flat.
pub(super) fn seen_ground(photos: impl Iterator<Item = RayField>, [width, height]: [f64; 2], relief_m: f64) -> Option<Rectangle> {
    let mut area = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    for rays in photos {
        for [x, y] in [[0.0, 0.0], [width, 0.0], [0.0, height], [width, height]] {
            let ray = rays.ray(x, y);
            if -ray.direction.z < FLATTEST * ray.direction.norm() {
                return None;
            }
            let foot = ray.at((-0.5 * relief_m - ray.origin.z) / ray.direction.z);
            area = [area[0].min(foot.x), area[1].min(foot.y), area[2].max(foot.x), area[3].max(foot.y)];
        }
    }
    Some(area)
}

/// That ground, and as much around it as a building may lean into the picture or throw its shadow.
pub(super) fn with_surroundings(area: Rectangle, highest_building_m: f64) -> Rectangle {
    let around = 15.0 + 2.5 * highest_building_m;
    [area[0] - around, area[1] - around, area[2] + around, area[3] + around]
}
