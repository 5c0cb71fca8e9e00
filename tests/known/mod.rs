//! What is known of the sample before it is matched.

use tiepoint::{PairInput, PhotoInput, Sample};

/// The camera of the sample, whose images are patches of a larger scan: their principal points lie far outside.
pub fn input(sample: &Sample) -> PairInput {
    let photo = |fiducials: &Vec<_>, origin| PhotoInput { fiducials: fiducials.clone(), origin: Some(origin), ..PhotoInput::default() };
    PairInput {
        camera: Some(sample.camera),
        left: photo(&sample.left_fiducials, sample.left_origin),
        right: photo(&sample.right_fiducials, sample.right_origin),
        offset: None,
    }
}
