//! Images resampled to their epipolar system.

use super::geometry::EpipolarGeometry;
use super::view::StereoView;
use crate::error::refuse;
use crate::image::{Neighbours, each_position};
use crate::{Bands, Error, Refusal, StereoPair, write_bands};
use nalgebra::{Matrix3, Vector3};

/// Two epipolar images, each grey or in colours as its photo is.
#[derive(Debug, Clone, PartialEq)]
pub struct EpipolarImages {
    pub left: Bands,
    pub right: Bands,
}

impl EpipolarImages {
    /// Resamples both images of a pair, by bicubic convolution; what an image does not show is black.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for an image of another size than its camera.
    pub fn new(geometry: &EpipolarGeometry, pair: &StereoPair, images: [&Bands; 2]) -> Result<Self, Error> {
        let of = |side: usize| resampled(geometry, side, &pair.views[side], images[side]);
        Ok(Self { left: of(0)?, right: of(1)? })
    }
}

fn resampled(geometry: &EpipolarGeometry, side: usize, view: &StereoView, image: &Bands) -> Result<Bands, Error> {
    let [width_px, height_px] = view.size_px;
    if [image.width(), image.height()] != view.size_px {
        return refuse(Refusal::EpipolarImageSize {
            name: view.name.clone(),
            width: image.width(),
            height: image.height(),
            width_px,
            height_px,
        });
    }
    let at = Position {
        view,
        to_view: geometry.to_view(view),
        principal_point_px: geometry.principal_points_px[side],
        focal_px: geometry.focal_px,
    };
    let (width, height) = (geometry.width_px, geometry.height_px);
    let own = image.views();
    let mut bands: Vec<Vec<u8>> = own.iter().map(|_| Vec::with_capacity(width * height)).collect();
    each_position(
        [width, height],
        |pixel| at.of(pixel),
        |position| {
            // The neighbours of a position are the same in all bands.
            let seen = position.filter(|position| view.sees(*position)).map(|position| Neighbours::about(position, view.size_px));
            bands.iter_mut().zip(&own).for_each(|(band, own)| band.push(seen.as_ref().map_or(0, |seen| seen.mean(*own))));
        },
    );
    Bands::of([width, height], bands)
}

/// Where an image shows the middles of the pixels of its epipolar image.
struct Position<'a> {
    view: &'a StereoView,
    to_view: Matrix3<f64>,
    principal_point_px: [f64; 2],
    focal_px: f64,
}

impl Position<'_> {
    fn of(&self, [column, row]: [usize; 2]) -> Option<[f64; 2]> {
        let [x, y] = [column, row].map(|v| v as f64 + 0.5);
        let [cx, cy] = self.principal_point_px;
        let seen = self.to_view * Vector3::new((x - cx) / self.focal_px, (cy - y) / self.focal_px, -1.0);
        if seen.z < 0.0 { self.view.position([-seen.x / seen.z, -seen.y / seen.z]) } else { None }
    }
}

/// Writes both images in one as a PNG file for red-cyan glasses: red are the grey values of the left one, since colours would differ between the eyes.
///
/// # Panics
/// For images of different sizes.
pub fn write_anaglyph(images: &EpipolarImages) -> Vec<u8> {
    let EpipolarImages { left, right } = images;
    let [left, right] = [left, right].map(Bands::to_grey);
    write_bands(&Bands::colours([left, right.clone(), right]).expect("epipolar images have one size"), None)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::StereoSystem;
    use crate::camera::rotation_from_angles;
    use crate::{Camera, GreyImage, Pose, StereoView};

    /// The grey value of level ground at a height of 0.
    fn ground([x, y]: [f64; 2]) -> f64 {
        128.0 + 50.0 * libm::sin(0.35 * x) + 40.0 * libm::cos(0.31 * y + 0.2 * x)
    }

    /// Where a ray of this direction (x, y, -1) of a photo meets the ground.
    fn met(pose: &Pose, [x, y]: [f64; 2]) -> [f64; 2] {
        let along = pose.matrix().transpose() * Vector3::new(x, y, -1.0);
        [0, 1].map(|k| pose.position[k] - pose.position[2] / along[2] * along[k])
    }

    fn photographed(angles: [f64; 3], position: [f64; 3]) -> (StereoView, GreyImage) {
        let camera = Camera { radial: [-0.06, 0.01, 0.0], tangential: [0.001, 0.0], ..Camera::without_distortion(300, 220, 260.0) };
        let view = StereoView::of_camera("a".into(), &camera, Pose::new(&rotation_from_angles(angles[0], angles[1], angles[2]), position));
        let grey = |c: usize, r: usize| {
            let direction = view.direction([c as f64 + 0.5, r as f64 + 0.5]).unwrap();
            (ground(met(&view.pose, direction)) + 0.5) as u8
        };
        let image = GreyImage::from_fn(300, 220, grey).unwrap();
        (view, image)
    }

    #[test]
    fn epipolar_images_are_what_cameras_of_their_geometry_would_have_seen() {
        let (left, of_left) = photographed([0.02, 0.05, 0.04], [0.0, 0.0, 60.0]);
        let (right, of_right) = photographed([-0.03, -0.04, -0.06], [25.0, 3.0, 62.0]);
        let geometry = EpipolarGeometry::new([&left, &right], &[]).unwrap();
        let system = StereoSystem::Block;
        let pair = StereoPair { views: [left, right], is_swapped: false, contents: [None, None], points_px: Vec::new(), system };
        // The left one in colours: red as it is, green and blue by other values.
        let other = |of: fn(u8) -> u8| GreyImage::from_fn(300, 220, |c, r| of(of_left.view().at(c, r))).unwrap();
        let coloured = Bands::colours([of_left.clone(), other(|grey| 255 - grey), other(|grey| grey / 2)]).unwrap();
        let images = EpipolarImages::new(&geometry, &pair, [&coloured, &of_right.clone().into()]).unwrap();
        assert!(images.left.are_colours() && !images.right.are_colours());
        for (side, image) in [&images.left.images()[0], &images.right.images()[0]].into_iter().enumerate() {
            let pose = Pose { rotation: geometry.rotation, position: geometry.projection_centres[side] };
            let [cx, cy] = geometry.principal_points_px[side];
            let mut compared = 0;
            for (row, column) in (0..geometry.height_px).flat_map(|row| (0..geometry.width_px).map(move |column| (row, column))) {
                let got = f64::from(image.view().at(column, row));
                if got == 0.0 {
                    continue;
                }
                let [x, y] = [(column as f64 + 0.5 - cx) / geometry.focal_px, (cy - row as f64 - 0.5) / geometry.focal_px];
                let seen = ground(met(&pose, [x, y]));
                assert!((got - seen).abs() < 3.0, "{side}: {column} {row}: {got} {seen}");
                compared += 1;
            }
            assert!(compared > geometry.width_px * geometry.height_px / 2, "{compared}");
        }
        let [red, green, blue] = images.left.images() else { panic!("grey") };
        for (column, row) in [(100, 80), (60, 50), (150, 100)] {
            let [red, green, blue] = [red, green, blue].map(|band| i32::from(band.view().at(column, row)));
            assert!(red > 0 && (255 - red - green).abs() <= 1 && (red / 2 - blue).abs() <= 1, "{column} {row}: {red} {green} {blue}");
        }
        let anaglyph = image::load_from_memory(&write_anaglyph(&images)).unwrap().to_rgb8();
        let [grey, other] = [&images.left, &images.right].map(|image| image.to_grey().view().at(100, 80));
        assert_eq!(anaglyph.get_pixel(100, 80).0, [grey, other, other]);
        let small = GreyImage::from_fn(10, 10, |_, _| 0).unwrap();
        let refused = EpipolarImages::new(&geometry, &pair, [&coloured, &small.into()]).unwrap_err();
        assert!(refused.to_string().contains("10 x 10 px for a"), "{refused}");
    }
}
