//! Independent causes of what the observations of a pair share.

use crate::SharedErrors;

/// Independent causes of unit variance, three to a group; `of` is what each does to each observation.
pub fn in_threes(observations: usize, causes: usize, of: impl Fn(usize, usize) -> [f64; 4]) -> Vec<SharedErrors> {
    let effect = |index: usize, cause: usize| if cause < causes { of(index, cause) } else { [0.0; 4] };
    let group = |first: usize| SharedErrors {
        effects: (0..observations).map(|index| std::array::from_fn(|k| effect(index, first + k))).collect(),
        covariance: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        degrees_of_freedom: None,
    };
    (0..causes).step_by(3).map(group).collect()
}
