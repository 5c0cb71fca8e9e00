//! Every option with its label, unit, range and help, declared once: checks, command, page and documents read them from here.
//!
//! A module declares its own options with `options!` and their words with `choices!`.

mod acting;
mod call;
mod check;
mod declare;
mod given;
mod parameter;
mod value;

pub use acting::acting;
pub use call::CALL_PARAMETERS;
pub use given::{PartlyGiven, with_defaults};
pub use parameter::{Group, Parameter, ParameterKind};

pub(crate) use call::{FOCAL_PX, LENGTH, SIGMA_PX, check_call};
#[cfg_attr(not(target_arch = "wasm32"), allow(unused_imports))]
pub(crate) use check::shown;
pub(crate) use check::{check_values, refuse, refuse_absent};
pub(crate) use declare::{choices, options};
pub(crate) use given::{check_groups, read_options};
pub(crate) use parameter::check;
pub(crate) use value::{Form, OptionValue, kind};
