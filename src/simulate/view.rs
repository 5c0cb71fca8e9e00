//! What a photo's patch sees: the first surface on each ray, and whether a ground point is visible.

use super::buckets::{Buckets, Rectangle};
use super::photo::{Photo, RayField};
use super::scene::{Hit, Moment, Scene};
use nalgebra::Vector3;

/// Side of the cells in which solids are looked up, in px: whole, so that no pixel lies in two.
const CELL_PX: f64 = 4.0;

/// Rays are asked for up to this far outside the patch, in px: whole too.
const BORDER_PX: f64 = 2.0;

/// A point is visible if nothing lies nearer on its ray, to this share of the depth (millimetres).
const SAME_DEPTH: f64 = 2e-6;

/// A photo over a scene.
pub(super) struct View<'a> {
    scene: &'a Scene,
    photo: &'a Photo,
    moment: Moment,
    rays: RayField,
    size_px: [f64; 2],
    /// The solids whose picture touches each cell of the patch.
    pictures: Buckets,
}

impl<'a> View<'a> {
    pub(super) fn new(scene: &'a Scene, photo: &'a Photo, moment: Moment, width: usize, height: usize) -> Self {
        let size_px = [width as f64, height as f64];
        let area = [-BORDER_PX, -BORDER_PX, size_px[0] + BORDER_PX, size_px[1] + BORDER_PX];
        let extents: Vec<Rectangle> = scene.bounds().map(|bounds| picture(photo, &bounds.corners())).collect();
        Self { scene, photo, moment, rays: photo.rays(), size_px, pictures: Buckets::new(area, CELL_PX, &extents) }
    }

    /// What is seen at a position in px of the patch.
    pub(super) fn hit(&self, x: f64, y: f64) -> Hit {
        let ray = self.rays.ray(x, y);
        self.scene.first_hit(&ray, &self.scene.ground(&ray), self.pictures.at(x, y))
    }

    /// The grey values of an ideal camera at the given places inside the pixel of a column and row, which may lie one px
    /// outside the patch. Within the pixel the ground is a plane: it deviates by less than a thousandth of the pixel's side.
    pub(super) fn greys<const N: usize>(&self, col: f64, row: f64, places: &[[f64; 2]; N]) -> [f64; N] {
        let (x, y) = (col + 0.5, row + 0.5);
        let ground = self.scene.ground(&self.rays.ray(x, y));
        let candidates = self.pictures.at(x, y);
        places.map(|[dx, dy]| self.scene.grey(&self.scene.first_hit(&self.rays.ray(col + dx, row + dy), &ground, candidates), self.moment))
    }

    /// Whether a moving car hides the ground at a hit in either exposure.
    pub(super) fn is_unsteady(&self, hit: &Hit) -> bool {
        self.scene.is_unsteady(hit)
    }

    /// Where a ground point is seen in px of the patch; absent where it is hidden or outside.
    pub(super) fn find(&self, point: Vector3<f64>) -> Option<[f64; 2]> {
        let [x, y] = self.photo.project(point);
        if !(x >= 0.0 && y >= 0.0 && x < self.size_px[0] && y < self.size_px[1]) {
            return None;
        }
        let first = self.hit(x, y);
        let depth = (point - self.photo.centre).norm();
        ((first.point - point).norm() < SAME_DEPTH * depth).then_some([x, y])
    }
}

/// The rectangle of the patch around a box's picture: that of its corners, since the picture of a convex body is convex.
fn picture(photo: &Photo, corners: &[Vector3<f64>]) -> Rectangle {
    // Distortion bends straight edges by less than this.
    let bend = if photo.distortion == 0.0 { 0.0 } else { 0.5 };
    let nothing = [f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY];
    // A tilted camera has most of a block behind it; what stands beside it on both sides may be anywhere.
    match corners.iter().filter(|&&corner| photo.faces(corner)).count() {
        0 => return nothing,
        facing if facing < corners.len() => return [f64::NEG_INFINITY, f64::NEG_INFINITY, f64::INFINITY, f64::INFINITY],
        _ => {}
    }
    corners
        .iter()
        .map(|&corner| photo.project(corner))
        .fold(nothing, |[x0, y0, x1, y1], [x, y]| [x0.min(x - bend), y0.min(y - bend), x1.max(x + bend), y1.max(y + bend)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulate::flight::Flight;
    use crate::simulate::sample::Stage;

    fn stage() -> Stage {
        let flight =
            Flight { width_px: 120, height_px: 90, lowest_building_m: 4.0, highest_building_m: 40.0, relief_m: 20.0, ..Flight::default() };
        Stage::new(&flight).unwrap()
    }

    /// Positions of the patch and its border that fall on no regular place of a pixel.
    fn positions() -> impl Iterator<Item = (f64, f64)> {
        (0..6000).map(|k| (f64::from(k % 122) - 0.9 + 0.13 * f64::from(k % 7), f64::from(k / 66) - 0.9 + 0.17 * f64::from(k % 5)))
    }

    #[test]
    fn the_lists_of_the_cells_leave_no_solid_out() {
        let stage = stage();
        let all: Vec<u32> = (0..stage.scene.bounds().count() as u32).collect();
        for photo in &stage.photos {
            let view = View::new(&stage.scene, photo, Moment::First, 120, 90);
            for (x, y) in positions() {
                let ray = photo.rays().ray(x, y);
                let wanted = stage.scene.first_hit(&ray, &stage.scene.ground(&ray), &all);
                assert_eq!(view.hit(x, y).point, wanted.point, "at {x} {y}");
            }
        }
    }

    #[test]
    fn a_hit_is_seen_where_its_ray_started() {
        let stage = stage();
        for photo in &stage.photos {
            let view = View::new(&stage.scene, photo, Moment::First, 120, 90);
            for (x, y) in positions().filter(|&(x, y)| x >= 0.0 && y >= 0.0 && x < 120.0 && y < 90.0) {
                let [u, v] = view.find(view.hit(x, y).point).expect("a point that was hit is visible");
                assert!((u - x).abs() < 1e-8 && (v - y).abs() < 1e-8, "{u} {v} for {x} {y}");
            }
        }
    }

    #[test]
    fn nothing_is_entered_before_the_hit() {
        let stage = stage();
        let view = View::new(&stage.scene, &stage.photos[1], Moment::Second, 120, 90);
        let mut hits_above_ground = 0;
        for (x, y) in positions() {
            let (centre, end) = (stage.photos[1].centre, view.hit(x, y).point);
            hits_above_ground += usize::from(stage.scene.height_above_ground(end) > 1.0);
            // The last 100 m of the ray in steps, by the plain question whether a point lies inside something.
            let step = (end - centre).normalize() * 0.5;
            let blocked = (1..200).map(|k| end - step * f64::from(k)).find(|&point| stage.scene.is_inside(point));
            assert_eq!(blocked, None, "on the ray of {x} {y} to {end}");
        }
        assert!(hits_above_ground > 500, "{hits_above_ground} rays meet a roof or a tree");
    }
}
