//! An image resampled to the ground.

use super::heights::Heights;
use crate::Georeference;
use crate::adjustment::project;
use crate::image::Neighbours;
use crate::{Bands, Camera, Error, GreyImage, GreyView, Pose};

/// An image on the ground, with the places that it shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Rectified {
    pub bands: Bands,
    /// 255 where the image shows the ground, 0 elsewhere.
    pub mask: GreyImage,
    pub georeference: Georeference,
}

/// Resamples an image to the pixels of a piece of ground: each takes the grey value or colour of where its middle is seen, by bicubic convolution.
/// What hides what is not asked: beside walls and trees their picture stands twice.
///
/// The image should have about as many px as the ground: finer ones leave out detail that then shows as false patterns.
///
/// # Errors
/// [`Error::InvalidInput`] for a piece without pixels.
pub fn rectify(
    image: &Bands,
    camera: &Camera,
    pose: &Pose,
    heights: &Heights,
    georeference: &Georeference,
    size: [usize; 2],
) -> Result<Rectified, Error> {
    rectify_from(&image.views(), camera, pose, heights, georeference, size, Some)
}

/// As [`rectify`], of the bands of an image that is oriented in another system than that of the ground: `to_image` leads there.
pub(super) fn rectify_from(
    image: &[GreyView<'_>],
    camera: &Camera,
    pose: &Pose,
    heights: &Heights,
    georeference: &Georeference,
    [width, height]: [usize; 2],
    to_image: impl Fn([f64; 3]) -> Option<[f64; 3]>,
) -> Result<Rectified, Error> {
    let view = Seen::new(camera, pose);
    let mut mask = vec![0; width.saturating_mul(height)];
    let mut bands = vec![vec![0; mask.len()]; image.len()];
    for (k, mask) in mask.iter_mut().enumerate() {
        let place = georeference.ground([(k % width) as f64 + 0.5, (k / width) as f64 + 0.5]);
        if let Some(at) = view.ground(place, heights, &to_image) {
            let neighbours = Neighbours::about(at, [image[0].width(), image[0].height()]);
            bands.iter_mut().zip(image).for_each(|(band, own)| band[k] = neighbours.mean(*own));
            *mask = 255;
        }
    }
    let bands = Bands::of([width, height], bands)?;
    Ok(Rectified { bands, mask: GreyImage::new(width, height, mask)?, georeference: *georeference })
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

    /// The position in px of the ground at a place in plan; `to_image` leads to the system in which the image is oriented.
    pub fn ground(&self, place: [f64; 2], heights: &Heights, to_image: &impl Fn([f64; 3]) -> Option<[f64; 3]>) -> Option<[f64; 2]> {
        heights.at(place).and_then(|z| self.at(&to_image([place[0], place[1], z])?))
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
        let sought = Bands::colours([image.clone(), GreyImage::from_fn(60, 40, |c, _| c as u8).unwrap(), image.clone()]).unwrap();
        let rectified = rectify(&sought, &camera, &pose, &Heights::Level(7.0), &ground, [60, 40]).unwrap();
        let grey = |rectified: &Rectified, c: usize, r: usize| rectified.bands.images()[0].view().at(c, r);
        for (c, r) in [(2, 2), (30, 20), (57, 37)] {
            assert_eq!((grey(&rectified, c, r), rectified.mask.view().at(c, r)), (image.view().at(c, r), 255));
            assert_eq!(rectified.bands.images()[1].view().at(c, r), c as u8);
        }
        let beside = Georeference::north_up([-5.0, 5.0], 1.0);
        let wider = rectify(&sought, &camera, &pose, &Heights::Level(7.0), &beside, [60, 40]).unwrap();
        assert_eq!([wider.mask.view().at(4, 20), wider.mask.view().at(5, 20)], [0, 255]);
        // Half a pixel between is the mean of what changes evenly.
        let between = Georeference::north_up([0.5, -0.5], 1.0);
        let shifted = rectify(&sought, &camera, &pose, &Heights::Level(7.0), &between, [50, 30]).unwrap();
        assert_eq!(grey(&shifted, 10, 10), ((20.0 + 30.0 + 2.5_f64) + 0.5) as u8);
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
