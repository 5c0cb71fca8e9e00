//! Families of messages.

use serde::Serialize;

/// What a user reads: a reason, a warning, a rejection, an error.
///
/// Its text is the entry `family-kind` of a catalogue, by its `kind` and its other fields as JSON has them; `Display` writes it in English.
pub trait Message: Serialize {
    /// What the identifiers of its texts begin with.
    const FAMILY: &'static str;
    /// Each kind with the names of its figures; a message of one kind has no name for it.
    #[cfg(test)]
    const KINDS: &'static [(&'static str, &'static [&'static str])];
}
