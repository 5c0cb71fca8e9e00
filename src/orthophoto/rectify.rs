//! An image resampled to the ground.

use super::georeference::Georeference;
use super::heights::Heights;
use crate::adjustment::project;
use crate::image::bicubic;
use crate::{Camera, Error, GreyImage, GreyView, Pose};

/// An image on the ground, with the places that it shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Rectified {
    pub grey: GreyImage,
    /// 255 where the image shows the ground, 0 elsewhere.
    pub mask: GreyImage,
    pub georeference: Georeference,
}

/// Resamples an image to the pixels of a piece of ground: each takes the grey value of where its middle is seen, by bicubic convolution.
/// What hides what is not asked: beside walls and trees their picture stands twice.
///
/// The image should have about as many px as the ground: finer ones leave out detail that then shows as false patterns.
///
/// # Errors
/// [`Error::InvalidInput`] for a piece without pixels.
pub fn rectify(
    image: GreyView<'_>,
    camera: &Camera,
    pose: &Pose,
    heights: &Heights,
    georeference: &Georeference,
    size: [usize; 2],
) -> Result<Rectified, Error> {
    rectify_from(image, camera, pose, heights, georeference, size, Some)
}

/// As [`rectify`], of an image that is oriented in another system than that of the ground: `to_image` leads there.
pub(super) fn rectify_from(
    image: GreyView<'_>,
    camera: &Camera,
    pose: &Pose,
    heights: &Heights,
    georeference: &Georeference,
    [width, height]: [usize; 2],
    to_image: impl Fn([f64; 3]) -> Option<[f64; 3]>,
) -> Result<Rectified, Error> {
    let view = Seen::new(camera, pose);
    let mut grey = vec![0; width.saturating_mul(height)];
    let mut mask = vec![0; grey.len()];
    for (k, (grey, mask)) in grey.iter_mut().zip(&mut mask).enumerate() {
        let place = georeference.ground([(k % width) as f64 + 0.5, (k / width) as f64 + 0.5]);
        let seen = heights.at(place).and_then(|z| view.at(&to_image([place[0], place[1], z])?));
        if let Some(at) = seen {
            (*grey, *mask) = (bicubic(image, at), 255);
        }
    }
    let [grey, mask] = [grey, mask].map(|data| GreyImage::new(width, height, data));
    Ok(Rectified { grey: grey?, mask: mask?, georeference: *georeference })
}

/// Where an oriented image sees places.
pub(crate) struct Seen<'a> {
    camera: &'a Camera,
    pose: &'a Pose,
    /// Square of the longest (x, y) of a direction into the image, some room left: beyond, distortion may fold places back into it.
    widest: f64,
}

/// Room for distortion about the directions of an image without any.
const ROOM: f64 = 1.3;

impl<'a> Seen<'a> {
    pub fn new(camera: &'a Camera, pose: &'a Pose) -> Self {
        let [cx, cy] = camera.principal_point_px;
        let [w, h] = [camera.width_px, camera.height_px].map(f64::from);
        let far = [cx.max(w - cx), cy.max(h - cy)].map(|v| ROOM * v / camera.focal_px);
        Self { camera, pose, widest: far[0] * far[0] + far[1] * far[1] }
    }

    /// The position in px of a place that is in front of the image and within it.
    pub fn at(&self, place: &[f64; 3]) -> Option<[f64; 2]> {
        let [u, v, w] = self.pose.to_photo(place);
        let (x, y) = (u / w, v / w);
        if !(w < 0.0 && x * x + y * y <= self.widest) {
            return None;
        }
        let at = project(&self.camera.values(), self.pose, place);
        self.camera.sees(at[0], at[1]).then_some(at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_image_that_looks_straight_down_is_its_own_picture_of_level_ground() {
        let image = GreyImage::from_fn(60, 40, |c, r| (2 * c + 3 * r) as u8).unwrap();
        let camera = Camera::without_distortion(60, 40, 50.0);
        let pose = Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], position: [30.0, -20.0, 57.0] };
        let ground = Georeference::north_up([0.0, 0.0], 1.0);
        let rectified = rectify(image.view(), &camera, &pose, &Heights::Level(7.0), &ground, [60, 40]).unwrap();
        for (c, r) in [(2, 2), (30, 20), (57, 37)] {
            assert_eq!((rectified.grey.view().at(c, r), rectified.mask.view().at(c, r)), (image.view().at(c, r), 255));
        }
        let beside = Georeference::north_up([-5.0, 5.0], 1.0);
        let wider = rectify(image.view(), &camera, &pose, &Heights::Level(7.0), &beside, [60, 40]).unwrap();
        assert_eq!([wider.mask.view().at(4, 20), wider.mask.view().at(5, 20)], [0, 255]);
        // Half a pixel between is the mean of what changes evenly.
        let between = Georeference::north_up([0.5, -0.5], 1.0);
        let shifted = rectify(image.view(), &camera, &pose, &Heights::Level(7.0), &between, [50, 30]).unwrap();
        assert_eq!(shifted.grey.view().at(10, 10), ((20.0 + 30.0 + 2.5_f64) + 0.5) as u8);
    }

    #[test]
    fn nothing_behind_the_image_is_seen() {
        let camera = Camera::without_distortion(60, 40, 50.0);
        let pose = Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], position: [0.0, 0.0, 50.0] };
        let seen = Seen::new(&camera, &pose);
        assert_eq!(seen.at(&[0.0, 0.0, 0.0]), Some([30.0, 20.0]));
        assert_eq!((seen.at(&[0.0, 0.0, 60.0]), seen.at(&[500.0, 0.0, 0.0])), (None, None));
    }
}
