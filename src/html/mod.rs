//! What the pages of reports share: head and style, numbers as they are written, drawings, the table of parameters.

mod drawing;
mod figures;
mod numbers;
mod page;
mod settings;
mod words;

pub(crate) use drawing::{dots, strokes};
pub(crate) use figures::{correlations, histogram};
pub(crate) use numbers::{count, digits_of_error, fixed, percent, plus_minus, round_below, rounded, significant, typeset, with_error};
pub(crate) use page::{footer, page};
pub(crate) use settings::settings_table;
pub(crate) use words::{head, in_unit, listed, quantity, said};
