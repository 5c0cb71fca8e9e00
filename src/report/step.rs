//! What a step of a report does.

use crate::message::messages;
use serde::Serialize;

messages! {
    /// What a step of a report does, or a column of it is of.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
    #[serde(rename_all = "snake_case")]
    pub enum ReportStep as "report_step" {
        /// The run by the settings that were given.
        ThisRun,
        /// The same of matches that were edited by hand.
        ThisRunEdited,
        Moments,
        Invariants,
        Correlation,
        LeastSquares,
        Gradients,
    }
}
