//! The report of a pair: one self-contained HTML page with pictures, tables of all strategies, residuals, reliability and parameters.

mod camera;
mod details;
mod figures;
mod input;
mod page;
mod paper;
mod picture;
mod steps;
mod study;
mod tables;
mod unknowns;

pub use input::{ReportEdits, ReportImage, ReportTruth};
pub use paper::{PAPER, Paper, PrintedOrientation};
pub use steps::Report;
