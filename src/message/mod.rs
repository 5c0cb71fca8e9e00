//! Messages: typed, with their figures; their texts stand in a catalogue for each language.

mod declare;
mod family;
mod said;
mod texts;

pub(crate) use declare::{messages, written};
pub use family::Message;
pub use texts::Texts;

#[cfg(test)]
mod tests;
