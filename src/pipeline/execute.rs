//! What workers do: a pure function from bytes to bytes, on any machine.

use super::task::Task;
use super::{features, geoid, likeness, pairs, refinement, windows};
use crate::error::refuse;
use crate::{Error, Refusal};

/// Does a job: the same inputs give the same bytes, on every machine.
///
/// `inputs`: the bytes of the files, of the records and of the input of the [`Work`](super::Work), in this order.
///
/// # Errors
/// What is wrong with the image or the pair; [`Error::InvalidInput`] for another number of inputs.
pub fn execute(task: &Task, inputs: &[&[u8]]) -> Result<Vec<u8>, Error> {
    match (task, inputs) {
        (Task::Features(task), [image]) if task.mask.is_none() => features::execute(task, image, None),
        (Task::Features(task), [image, mask]) => features::execute(task, image, Some(mask)),
        (Task::Likeness(task), [descriptors]) => likeness::execute(task, descriptors),
        (Task::Pair(task), [left, right]) => pairs::execute(task, [left, right]),
        (Task::Windows(task), [image, features]) => windows::execute(task, image, features),
        (Task::Refine(task), [grey]) => refinement::execute(task, grey.to_vec()),
        (Task::Geoid(task), [file]) => geoid::execute(task, file),
        _ => refuse(Refusal::JobInputs { inputs: inputs.len() }),
    }
}
