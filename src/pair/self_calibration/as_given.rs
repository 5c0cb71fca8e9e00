//! Cameras that stay as they were given: what is not known of them does to the observations what their priors say.

use super::causes::in_threes;
use super::constants::{CAMERA, cameras_of, effects, is_uncertain, priors_of_constants, shared_constants};
use super::decentring::decentring_errors;
use super::result::cameras_with;
use crate::pair::geometry::PairInterior;
use crate::{EstimatedCamera, SharedErrors};
use nalgebra::DVector;

/// What the errors of the cameras do to the observations; nothing of cameras that are known without error.
pub fn errors_as_given(given: &PairInterior, positions: &[[f64; 4]]) -> Vec<SharedErrors> {
    if !is_uncertain(given) {
        return Vec::new();
    }
    let cameras = cameras_of(given);
    let priors = priors_of_constants(given, cameras);
    let by_constants = effects(positions, given, &DVector::zeros(cameras * CAMERA), cameras);
    // A constant of both photos has one error.
    let shared = shared_constants(given, cameras);
    let partner = |k: usize| shared.iter().find(|([left, _], _)| *left == k).map(|([_, right], _)| *right);
    let causes: Vec<(usize, Option<usize>)> =
        (0..priors.len()).filter(|k| shared.iter().all(|([_, right], _)| right != k)).map(|k| (k, partner(k))).collect();
    let mut errors = in_threes(positions.len(), causes.len(), |index, cause| {
        let (k, partner) = causes[cause];
        let effect = |c: usize| by_constants[k][index][c] + partner.map_or(0.0, |other| by_constants[other][index][c]);
        std::array::from_fn(|c| given.focal_mm * effect(c) * priors[k])
    });
    errors.extend(decentring_errors(given, positions, cameras));
    errors
}

/// What is known of the left and the right camera; `None` where they are known without error.
pub fn cameras_as_given(given: &PairInterior) -> Option<[EstimatedCamera; 2]> {
    let cameras = cameras_of(given);
    is_uncertain(given).then(|| cameras_with(given, given, &vec![0.0; cameras * CAMERA], &priors_of_constants(given, cameras)))
}
