//! An oriented image: the way between its pixels and directions in space.

use crate::{Camera, Interior, Pose};

/// Positions on each side of an image by which its border is given.
const ON_A_SIDE: usize = 32;

/// What is seen beyond the border of an image, as a share of its widest direction: farther out, distortion may fold places back into it.
const ROOM: f64 = 1.05;

/// An oriented image of a stereo pair.
#[derive(Debug, Clone, PartialEq)]
pub struct StereoView {
    /// File name.
    pub name: String,
    /// Width and height.
    pub size_px: [usize; 2],
    pub pose: Pose,
    lens: Lens,
    /// Length of the longest (x, y) of a direction into the image.
    widest: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Lens {
    Camera(Camera),
    Interior { interior: Interior, focal_mm: f64 },
}

impl StereoView {
    /// An image of a block.
    pub fn of_camera(name: String, camera: &Camera, pose: Pose) -> Self {
        Self::new(name, [camera.width_px as usize, camera.height_px as usize], Lens::Camera(*camera), pose)
    }

    /// A photo of a pair.
    pub fn of_interior(name: String, size_px: [usize; 2], (interior, focal_mm): (Interior, f64), pose: Pose) -> Self {
        Self::new(name, size_px, Lens::Interior { interior, focal_mm }, pose)
    }

    fn new(name: String, size_px: [usize; 2], lens: Lens, pose: Pose) -> Self {
        let mut view = Self { name, size_px, pose, lens, widest: 0.0 };
        view.widest = view.border().map(|[x, y]| (x * x + y * y).sqrt()).fold(0.0, f64::max);
        view
    }

    /// The direction (x, y, -1) of the photo's system, x right, y up, that is seen at a position in px; `None` where distortion folds.
    pub fn direction(&self, [x_px, y_px]: [f64; 2]) -> Option<[f64; 2]> {
        match &self.lens {
            Lens::Camera(camera) => camera.direction([x_px, y_px]).ok().map(|[x, y]| [x, -y]),
            Lens::Interior { interior, focal_mm } => Some(interior.photo_mm(x_px, y_px).map(|v| v / focal_mm)),
        }
    }

    /// The position in px at which a direction (x, y, -1) is seen; `None` well beyond the image.
    pub fn position(&self, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
        if !((x * x + y * y).sqrt() <= ROOM * self.widest) {
            return None;
        }
        match &self.lens {
            Lens::Camera(camera) => Some(camera.project(x, -y)),
            Lens::Interior { interior, focal_mm } => {
                let (pixel_mm, [x0, y0]) = (interior.pixel_mm(), interior.principal_point_px());
                interior.image_px(x0 + x * focal_mm / pixel_mm, y0 - y * focal_mm / pixel_mm)
            }
        }
    }

    /// The focal length in px.
    pub fn focal_px(&self) -> f64 {
        match &self.lens {
            Lens::Camera(camera) => camera.focal_px,
            Lens::Interior { interior, focal_mm } => focal_mm / interior.pixel_mm(),
        }
    }

    /// Directions along the border of the image.
    pub fn border(&self) -> impl Iterator<Item = [f64; 2]> + '_ {
        let [width, height] = self.size_px.map(|side| side as f64);
        let at = move |k: usize| {
            let along = (k % ON_A_SIDE) as f64 / ON_A_SIDE as f64;
            match k / ON_A_SIDE {
                0 => [along * width, 0.0],
                1 => [width, along * height],
                2 => [(1.0 - along) * width, height],
                _ => [0.0, (1.0 - along) * height],
            }
        };
        (0..4 * ON_A_SIDE).filter_map(move |k| self.direction(at(k)))
    }

    /// Whether a position in px lies in the image.
    pub fn sees(&self, at: [f64; 2]) -> bool {
        (0..2).all(|k| (0.0..=self.size_px[k] as f64).contains(&at[k]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::CameraMm;

    const POSE: Pose = Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], position: [0.0; 3] };

    #[test]
    fn directions_and_positions_are_each_others_inverse_for_both_kinds_of_camera() {
        let camera = Camera { radial: [-0.08, 0.02, 0.0], tangential: [0.0007, -0.0004], ..Camera::without_distortion(4000, 3000, 3500.0) };
        let film = CameraMm {
            principal_point_mm: [0.1, -0.2],
            radial_distortion: [2e-5, -1e-8, 0.0],
            ..CameraMm::without_distortion(20.0, Some(0.004))
        };
        let interior = Interior::from_pixel_size(&film, 4000, 3000).unwrap();
        let views =
            [StereoView::of_camera("a".into(), &camera, POSE), StereoView::of_interior("b".into(), [4000, 3000], (interior, 20.0), POSE)];
        assert_eq!(views.each_ref().map(|view| view.focal_px().round()), [3500.0, 5000.0]);
        for view in views {
            for at in [[5.0, 7.0], [2500.0, 1700.0], [3990.0, 200.0]] {
                let [x, y] = view.direction(at).unwrap();
                // To the right of the middle is right, above it is up.
                assert_eq!([x > 0.0, y > 0.0], [at[0] > 2050.0, at[1] < 1450.0], "{at:?}: {x} {y}");
                let back = view.position([x, y]).unwrap();
                assert!((back[0] - at[0]).abs() < 1e-6 && (back[1] - at[1]).abs() < 1e-6, "{at:?} {back:?}");
            }
            assert_eq!(view.position([5.0, 0.0]), None, "far beyond the image");
            assert!(view.sees([0.0, 3000.0]) && !view.sees([-0.1, 5.0]));
        }
    }
}
