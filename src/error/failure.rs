//! Why a job failed.

use crate::message::messages;
use serde::{Deserialize, Serialize};

messages! {
    /// Why a job of a run, or the reading of a file that it needs, failed.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum Failure as "failure" {
        /// The host could not read the file, in its words.
        Unreadable { message: String },
        /// The job refused its input: [`crate::Error::code`], its text, and [`crate::Error::is_usage`].
        Refused { code: String, message: String, usage: bool },
        /// The worker broke down at a fault of the program.
        BrokeOff { message: String },
        /// The host or the module has not the memory that the job needs.
        OutOfMemory { message: String },
    }
}
