//! Which camera parameters a block determines: the others are fixed, the weakest first.

use super::network::Network;
use super::sparse::DenseFactor;
use super::state::State;
use crate::CameraParameter;
use crate::camera::CAMERA_PARAMETERS;

/// Of each camera that has any the column of the parameter that is determined worst, and by how much in px its standard error moves a ray at
/// the edge. `of_camera` are the parameters of each camera with their columns; those that `is_held` names do not count.
pub(super) fn weakest_of_each(
    cameras: &DenseFactor,
    of_camera: &[Vec<(usize, usize)>],
    effects: &[[f64; CAMERA_PARAMETERS]],
    sigma: f64,
    is_held: impl Fn(usize) -> bool,
) -> Vec<(usize, f64)> {
    let (q, cofactors) = (cameras.side(), cameras.inverse());
    let effect = |camera: usize, (parameter, column): (usize, usize)| {
        (column, sigma * cofactors[column * q + column].max(0.0).sqrt() * effects[camera][parameter])
    };
    let worst = |(camera, own): (usize, &Vec<(usize, usize)>)| {
        own.iter().filter(|(_, column)| !is_held(*column)).map(|parameter| effect(camera, *parameter)).max_by(|a, b| a.1.total_cmp(&b.1))
    };
    of_camera.iter().enumerate().filter_map(worst).collect()
}

/// For each camera the pixels by which a unit of each parameter moves the ray that is farthest from its principal point.
pub(super) fn effects(network: &Network, state: &State) -> Vec<[f64; CAMERA_PARAMETERS]> {
    let mut farthest = vec![0.0_f64; state.cameras.len()];
    for sight in &network.sights {
        let [f, cx, cy, ..] = state.cameras[sight.camera as usize];
        let (x, y) = ((sight.at[0] - cx) / f, (sight.at[1] - cy) / f);
        let far = &mut farthest[sight.camera as usize];
        *far = far.max(x * x + y * y);
    }
    let of_camera = |(values, r2): (&[f64; CAMERA_PARAMETERS], f64)| {
        let (f, r) = (values[0], r2.sqrt());
        [r, 1.0, 1.0, f * r * r2, f * r * r2 * r2, f * r * r2 * r2 * r2, 3.0 * f * r2, 3.0 * f * r2]
    };
    state.cameras.iter().zip(farthest).map(of_camera).collect()
}

impl CameraParameter {
    /// In the order of the unknowns of a camera.
    pub(crate) const ALL: [Self; CAMERA_PARAMETERS] =
        [Self::Focal, Self::PrincipalX, Self::PrincipalY, Self::K1, Self::K2, Self::K3, Self::P1, Self::P2];

    /// Its place among the unknowns of a camera.
    pub(crate) fn place(self) -> usize {
        Self::ALL.iter().position(|parameter| *parameter == self).unwrap_or(0)
    }
}
