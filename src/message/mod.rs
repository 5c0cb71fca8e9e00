//! Messages: typed, with their figures; their texts stand in a catalogue for each language.

mod family;
mod texts;

pub use family::Message;
pub(crate) use family::{messages, written};
pub use texts::Texts;

#[cfg(test)]
mod tests;
