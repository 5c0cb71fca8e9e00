//! Places of the ground of a simulated block, and where its photos show them.

use tiepoint::{BlockScene, Camera, Pose};

/// A place in the system of the scene, with the indices of the photos that show it and where, in px.
pub type Shown = ([f64; 3], Vec<(usize, [f64; 2])>);

/// What these photos show at these places, where two photos or more do. Cameras are without distortion.
pub fn shown(scene: &BlockScene, photos: &[usize], at_px: &[[f64; 2]]) -> Vec<Shown> {
    let truth = scene.truth();
    assert!(truth.cameras[0].radial.iter().all(|k| *k == 0.0));
    let mut all = Vec::new();
    for first in photos {
        for place in scene.surface_at(*first, at_px).unwrap() {
            let of_image = |image: usize| Some((image, seen(&truth.cameras[0], truth.images[image].pose.as_ref()?, place)?));
            // What stands before it hides the place.
            let is_it = |(image, at): &(usize, [f64; 2])| {
                let shown = scene.surface_at(*image, &[*at]).unwrap()[0];
                (0..3).all(|k| (shown[k] - place[k]).abs() < 0.2)
            };
            let images: Vec<(usize, [f64; 2])> = (0..scene.photos()).filter_map(of_image).filter(is_it).collect();
            if images.len() >= 2 {
                all.push((place, images));
            }
        }
    }
    all
}

fn seen(camera: &Camera, pose: &Pose, place: [f64; 3]) -> Option<[f64; 2]> {
    let off = [0, 1, 2].map(|k| place[k] - pose.position[k]);
    let [x, y, z] = pose.rotation.map(|row| row[0] * off[0] + row[1] * off[1] + row[2] * off[2]);
    let at = [camera.principal_point_px[0] - camera.focal_px * x / z, camera.principal_point_px[1] + camera.focal_px * y / z];
    (z < 0.0 && camera.sees(at[0], at[1])).then_some(at)
}
