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

/// Writes messages in English.
macro_rules! written {
    ($name:ident) => {
        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str(&$crate::message::Texts::english().text(self))
            }
        }
    };
}

/// Declares a family of messages.
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

        $crate::message::written!($name);
    };
}

pub(crate) use {messages, written};
