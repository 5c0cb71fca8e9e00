//! The two macros that declare messages.

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
