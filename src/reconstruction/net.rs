//! A block on its way: what is oriented and intersected so far.

use super::options::ReconstructionOptions;
use super::rays::Rays;
use crate::adjustment::project;
use crate::camera::{Camera, Pose};
use crate::math::{MEDIAN_LENGTH, median};

/// The present values of a block.
#[derive(Clone)]
pub(super) struct Net<'a> {
    pub rays: &'a Rays,
    /// The camera of each image.
    pub camera_of: &'a [usize],
    /// The longer side of the images of each camera in px.
    pub longer_side_px: &'a [f64],
    pub cameras: Vec<Camera>,
    pub poses: Vec<Option<Pose>>,
    pub points: Vec<Option<[f64; 3]>>,
    /// Rays that fit to their points; only oriented images and intersected points have such.
    pub accepted: Vec<bool>,
    /// Longest residual of a ray that fits, in px.
    pub limit_px: f64,
    /// The same of a mark.
    pub mark_limit_px: f64,
}

/// A line of sight in the object space.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sight {
    pub ray: usize,
    pub from: [f64; 3],
    /// Of length 1.
    pub along: [f64; 3],
}

/// The limit follows the residuals down, to no less than this, in px.
pub(super) const LEAST_LIMIT_PX: f64 = 1.0;
/// A ray fits within so many standard errors of a coordinate.
const LIMIT_SIGMAS: f64 = 5.0;

impl<'a> Net<'a> {
    /// Nothing oriented yet.
    pub fn new(
        rays: &'a Rays,
        camera_of: &'a [usize],
        longer_side_px: &'a [f64],
        cameras: Vec<Camera>,
        options: &ReconstructionOptions,
    ) -> Self {
        let (poses, points, accepted) = (vec![None; rays.images()], vec![None; rays.points()], vec![false; rays.len()]);
        let (limit_px, mark_limit_px) = (options.largest_residual_px, LIMIT_SIGMAS * options.mark_sigma_px);
        Self { rays, camera_of, longer_side_px, cameras, poses, points, accepted, limit_px, mark_limit_px }
    }

    /// Longest residual with which a ray fits, in px.
    pub fn limit_of(&self, ray: usize) -> f64 {
        if self.rays.is_mark(ray) { self.mark_limit_px } else { self.limit_px }
    }

    /// Whether a ray fits to a place of its point.
    pub fn fits(&self, ray: usize, place: &[f64; 3]) -> bool {
        self.residual_to(ray, place).is_some_and(|r| r <= self.limit_of(ray))
    }

    pub fn oriented(&self) -> usize {
        self.poses.iter().flatten().count()
    }

    pub fn camera(&self, image: usize) -> &Camera {
        &self.cameras[self.camera_of[image]]
    }

    /// The direction of a ray in its photo's system, of length 1. `None` where the distortion has no inverse.
    pub fn in_photo(&self, ray: usize) -> Option<[f64; 3]> {
        let [x, y] = self.camera(self.rays.image[ray] as usize).direction(self.rays.at[ray]).ok()?;
        let length = (x * x + y * y + 1.0).sqrt();
        Some([x / length, -y / length, -1.0 / length])
    }

    /// The line of sight of a ray whose image is oriented.
    pub fn sight(&self, ray: usize) -> Option<Sight> {
        let pose = self.poses[self.rays.image[ray] as usize].as_ref()?;
        let d = self.in_photo(ray)?;
        let m = &pose.rotation;
        let along = [0, 1, 2].map(|k| m[0][k] * d[0] + m[1][k] * d[1] + m[2][k] * d[2]);
        Some(Sight { ray, from: pose.position, along })
    }

    /// Length of the residual of a ray for a place of its point, in px; `None` behind the image, or where it is not oriented.
    pub fn residual_to(&self, ray: usize, place: &[f64; 3]) -> Option<f64> {
        let image = self.rays.image[ray] as usize;
        let pose = self.poses[image].as_ref()?;
        residual(self.camera(image), pose, place, &self.rays.at[ray])
    }

    /// As [`Self::residual_to`], for the present place of the point.
    pub fn residual(&self, ray: usize) -> Option<f64> {
        self.residual_to(ray, self.points[self.rays.point[ray] as usize].as_ref()?)
    }

    /// Rays of an image that fit.
    pub fn accepted_of(&self, image: usize) -> usize {
        self.rays.of_image(image).iter().filter(|ray| self.accepted[**ray as usize]).count()
    }

    /// Rays of an image whose points are intersected.
    pub fn known_of(&self, image: usize) -> usize {
        self.rays.of_image(image).iter().filter(|ray| self.points[self.rays.point[**ray as usize] as usize].is_some()).count()
    }

    /// Takes an image out again, and the points that are left with less than two rays.
    pub fn lose(&mut self, image: usize) {
        let rays = self.rays;
        self.poses[image] = None;
        rays.of_image(image).iter().for_each(|ray| self.accepted[*ray as usize] = false);
        for ray in rays.of_image(image) {
            let point = rays.point[*ray as usize] as usize;
            if rays.of_point(point).filter(|ray| self.accepted[*ray]).count() < 2 {
                self.points[point] = None;
                rays.of_point(point).for_each(|ray| self.accepted[ray] = false);
            }
        }
    }

    /// Standard error of a coordinate of a ray that is no mark, in px, by the residuals of those that fit; 0 without any.
    pub fn sigma_px(&self) -> f64 {
        let fit = || (0..self.rays.len()).filter(|ray| self.accepted[*ray] && !self.rays.is_mark(*ray));
        let mut lengths: Vec<f64> = fit().filter_map(|ray| self.residual(ray)).collect();
        let mut points: Vec<u32> = fit().map(|ray| self.rays.point[ray]).collect();
        points.dedup();
        // Points follow their rays: residuals are as much shorter.
        let (observed, unknown) = (2.0 * lengths.len() as f64, 3.0 * points.len() as f64);
        let share = (observed - unknown) / observed;
        median(&mut lengths).filter(|_| share > 0.0).map_or(0.0, |middle| middle / MEDIAN_LENGTH / share.sqrt())
    }

    /// The limit of the finished block, whose adjustment tests each ray: residuals are shorter than errors, and the longest ones of good rays, which
    /// the growth cuts, would be missed in its estimate of the standard error.
    pub fn limit_of_finish(&self, largest_px: f64) -> f64 {
        (LIMIT_SIGMAS * self.sigma_px()).min(largest_px).max(self.limit_px)
    }

    /// Lets the limit follow the residuals of the rays that fit.
    pub fn tighten(&mut self, largest_px: f64) {
        let mut lengths: Vec<f64> = (0..self.rays.len()).filter(|ray| self.accepted[*ray]).filter_map(|ray| self.residual(ray)).collect();
        if let Some(middle) = median(&mut lengths) {
            self.limit_px = (LIMIT_SIGMAS * middle / MEDIAN_LENGTH).clamp(LEAST_LIMIT_PX.min(largest_px), largest_px);
        }
    }
}

/// Length of a residual in px; `None` for a point behind the image.
pub(super) fn residual(camera: &Camera, pose: &Pose, place: &[f64; 3], at: &[f64; 2]) -> Option<f64> {
    if pose.to_photo(place)[2] >= 0.0 {
        return None;
    }
    let [x, y] = project(&camera.values(), pose, place);
    let (dx, dy) = (at[0] - x, at[1] - y);
    let length = (dx * dx + dy * dy).sqrt();
    length.is_finite().then_some(length)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_that_an_image_leaves_with_one_ray_is_lost_with_it() {
        let seen_by: [&[u32]; 3] = [&[0, 1], &[0, 1, 2], &[1, 2]];
        let rays = Rays::new(seen_by.iter().map(|images| images.iter().map(|image| (*image, [1.0, 1.0]))), 3);
        let mut net = Net::new(&rays, &[0, 0, 0], &[100.0], Vec::new(), &ReconstructionOptions::default());
        net.points.iter_mut().for_each(|point| *point = Some([0.0; 3]));
        net.accepted.iter_mut().for_each(|accepted| *accepted = true);
        net.lose(0);
        assert_eq!(net.points, [None, Some([0.0; 3]), Some([0.0; 3])]);
        assert_eq!(net.accepted, [false, false, false, true, true, true, true]);
    }

    #[test]
    fn marks_have_a_limit_of_their_own() {
        let rays = Rays::new([0, 1].into_iter().map(|_| [(0, [1.0, 1.0])]), 1).with_surveyed(1);
        let options = ReconstructionOptions { mark_sigma_px: 0.5, ..ReconstructionOptions::default() };
        let net = Net::new(&rays, &[0], &[100.0], Vec::new(), &options);
        assert_eq!([0, 1].map(|ray| net.limit_of(ray)), [8.0, 2.5]);
    }
}
