//! Messages as outputs hold them: typed, with their text beside.

use serde::Serialize;
use std::fmt::Display;

/// A message and its text.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WithText<M> {
    #[serde(flatten)]
    pub message: M,
    pub text: String,
}

impl<M: Display> WithText<M> {
    pub(super) fn of(message: M) -> Self {
        Self { text: message.to_string(), message }
    }
}
