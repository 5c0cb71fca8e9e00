//! Messages: typed, with their figures; their texts stand in a catalogue for each language.

mod texts;

pub use texts::Texts;

use serde::Serialize;

/// What a user reads: a reason, a warning, a rejection, an error.
///
/// Its text is the entry `family-kind` of a catalogue, by its `kind` and its other fields as JSON has them.
pub trait Message: Serialize {
    /// What the identifiers of its texts begin with.
    const FAMILY: &'static str;
    /// Each kind with the names of its figures.
    #[cfg(test)]
    const KINDS: &'static [(&'static str, &'static [&'static str])];

    /// The text in English.
    fn text(&self) -> String {
        Texts::english().text(self)
    }
}

/// Declares a family of messages: an enum whose `Display` is the English text.
macro_rules! messages {
    ($(#[$meta:meta])* pub enum $name:ident as $family:literal {
        $($(#[$kind_meta:meta])* $kind:ident $({ $($(#[$field_meta:meta])* $field:ident: $type:ty),* $(,)? })?),* $(,)?
    }) => {
        $(#[$meta])*
        pub enum $name {
            $($(#[$kind_meta])* $kind $({ $($(#[$field_meta])* $field: $type),* })?),*
        }

        impl $crate::message::Message for $name {
            const FAMILY: &'static str = $family;
            #[cfg(test)]
            const KINDS: &'static [(&'static str, &'static [&'static str])] =
                &[$((stringify!($kind), &[$($(stringify!($field)),*)?])),*];
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str(&$crate::message::Message::text(self))
            }
        }
    };
}

pub(crate) use messages;

#[cfg(test)]
mod tests;
