//! What is known of the sample before it is matched.

use std::sync::OnceLock;
use tiepoint::{PairInput, PhotoInput, SAMPLE_SEED, Sample, sample_pair};

/// The sample, rendered once for all tests of a program.
pub fn sample() -> &'static Sample {
    static SAMPLE: OnceLock<Sample> = OnceLock::new();
    SAMPLE.get_or_init(|| sample_pair(SAMPLE_SEED).unwrap())
}

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
