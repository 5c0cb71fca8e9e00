//! The two macros that declare options and their words.

/// Declares a struct of options: the struct, its defaults, its [`Parameter`](crate::Parameter)s and the check of their ranges.
///
/// A field reads `/// help` and `field: Type = default, "Label", in "unit", 1..=9, absent "words", acts "condition", named "name";`.
/// The type says the kind: `f64`, `usize`, `u32`, `bool`, `String` or an enum of [`choices!`], any of them in an `Option`. All after the label
/// may be left out where it does not apply; `odd 1..=9` allows odd numbers alone. The help is the field's documentation.
/// Fields after `beside` belong to the struct and are no parameters.
macro_rules! options {
    (@range) => { (0.0, 0.0, false) };
    (@range $min:literal $max:literal) => { ($min as f64, $max as f64, false) };
    (@range odd $min:literal $max:literal) => { ($min as f64, $max as f64, true) };
    (@or) => { "" };
    (@or $text:literal) => { $text };
    (
        $(#[doc = $doc:literal])*
        pub struct $name:ident in $group:literal {
            $(
                section $section:literal;
                $(
                    $(#[doc = $help:literal])+
                    $field:ident: $ty:ty = $default:expr, $label:literal
                        $(, in $unit:literal)? $(, $min:literal..=$max:literal)? $(, odd $odd_min:literal..=$odd_max:literal)?
                        $(, absent $absent:literal)? $(, acts $acts:literal)? $(, named $named:literal)?;
                )+
            )+
            $(
                beside;
                $(
                    $(#[doc = $beside_doc:literal])*
                    $beside:ident: $beside_ty:ty = $beside_default:expr;
                )+
            )?
        }
    ) => {
        $(#[doc = $doc])*
        #[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
        #[serde(deny_unknown_fields)]
        #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
        pub struct $name {
            $($($(#[doc = $help])+ pub $field: $ty,)+)+
            $($($(#[doc = $beside_doc])* pub $beside: $beside_ty,)+)?
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $($($field: $default,)+)+ $($($beside: $beside_default,)+)? }
            }
        }

        impl $name {
            /// The parameters, in the order of the fields.
            pub const PARAMETERS: &'static [$crate::Parameter] = &[$($($crate::Parameter {
                key: concat!($group, ".", stringify!($field)),
                section: $section,
                label: $label,
                unit: options!(@or $($unit)?),
                kind: $crate::catalogue::kind(
                    <$ty as $crate::catalogue::OptionValue>::FORM,
                    options!(@range $($min $max)? $(odd $odd_min $odd_max)?),
                ),
                help: concat!($($help),+).trim_ascii(),
                absent: options!(@or $($absent)?),
                acts: options!(@or $($acts)?),
                named: options!(@or $($named)?),
            },)+)+];

            /// Rejects values outside their ranges.
            pub(crate) fn check_ranges(&self) -> Result<(), $crate::Error> {
                let numbers = [$($($crate::catalogue::OptionValue::number(&self.$field),)+)+];
                Self::PARAMETERS.iter().zip(numbers).try_for_each(|(p, number)| number.map_or(Ok(()), |number| p.check(number)))
            }
        }

        impl $crate::catalogue::PartlyGiven for $name {
            const GROUPS: &'static [$crate::Group] = &[$crate::Group { path: "", parameters: Self::PARAMETERS }];
        }
    };
}

/// Declares the words among which an option chooses: `Variant = "word"`, with its name on a page in brackets where that is another.
macro_rules! choices {
    (@label $value:literal) => { $value };
    (@label $value:literal $label:literal) => { $label };
    (
        $(#[doc = $doc:literal])*
        pub enum $name:ident {
            $($(#[doc = $variant_doc:literal])* $variant:ident = $value:literal $(($label:literal))?,)+
        }
    ) => {
        $(#[doc = $doc])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
        #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
        pub enum $name {
            $($(#[doc = $variant_doc])* #[serde(rename = $value)] $variant,)+
        }

        impl $crate::catalogue::OptionValue for $name {
            const FORM: $crate::catalogue::Form = $crate::catalogue::Form::Choice {
                values: &[$($value),+],
                labels: &[$(choices!(@label $value $($label)?)),+],
            };
        }
    };
}

pub(crate) use {choices, options};
