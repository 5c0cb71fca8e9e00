//! The report of a pair: one self-contained HTML page with pictures, tables of all strategies, residuals, reliability and parameters.

mod camera;
mod details;
mod differences;
mod figures;
mod input;
mod page;
mod paper;
mod picture;
mod step;
mod steps;
mod study;
mod tables;
mod thinned;
mod unknowns;

pub use input::{ReportEdits, ReportImage, ReportTruth};
pub use paper::{PAPER, Paper, PrintedOrientation};
pub use step::ReportStep;
pub use steps::Report;
