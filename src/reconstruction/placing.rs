//! How a model came to lie where it does.

use crate::Cause;

/// How a model came to lie where it does.
pub(super) enum Placing {
    /// By what was observed.
    Observed,
    /// By that and a level; `error_deg`: how uncertain its rotation was without, where it could be adjusted so.
    Levelled { recorded: bool, error_deg: Option<f64> },
    /// By nothing; `cause`: why what was observed does not.
    Free { cause: Option<Cause> },
}
