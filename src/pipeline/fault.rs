//! Whether a failure is the fault of one image or pair, or ends the run.

use crate::{Error, Failure, Interruption};

impl Failure {
    /// The fault of an image or a pair, which is left out with it.
    ///
    /// # Errors
    /// [`Error::Interrupted`] for options out of range and kept records that were changed, which no image is to blame for.
    pub(super) fn of_one(self) -> Result<Self, Error> {
        match &self {
            Self::Refused { code, usage, .. } if *usage || code == "unreadable-file" => Err(self.of_all()),
            _ => Ok(self),
        }
    }

    /// A failure that ends the run.
    pub(super) fn of_all(&self) -> Error {
        Error::Interrupted { interruption: Interruption::Job { failure: self.clone() } }
    }
}
