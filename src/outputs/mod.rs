//! What a finished run writes and shows: tables, summary, overview, files for other programs; and the project file, which keeps all of it.
//!
//! Data flow: [`BlockRun`](crate::BlockRun) → rows of images and pairs → tables, [`Summary`], [`BlockOverview`] → [`block_files`].

mod accuracy;
mod check_summary;
mod covariances;
mod coverage;
mod files;
mod given_points;
mod images;
mod in_system;
mod inspection;
mod meeting;
mod orientation_summary;
mod overview;
mod pair;
mod pairs;
mod place_group;
mod precision;
mod project;
mod refined;
mod report;
mod summary;
mod tables;
mod verdict;
mod warning;
mod with_text;

pub use accuracy::{AccuracyMap, AccuracySummary, Expected, accuracy_map};
pub use check_summary::CheckSummary;
pub use covariances::{CovarianceUnknown, Covariances, block_covariances, covariance_table};
pub use coverage::{Coverage, coverage};
pub use files::{BlockFiles, block_files, export_run, planned_files};
pub use images::{ImageReason, ImageRow};
pub use in_system::ResultSystem;
pub use inspection::{
    ImagePlace, ImagePoint, ObservationDetail, ObservationPart, PointDetail, block_epipolar_line, image_points, point_detail, point_ids,
};
pub use meeting::meeting_place;
pub use orientation_summary::SystematicSummary;
pub use overview::{BlockOverview, CameraRow, FoundPoints, PointColumns, RayCount};
pub use pair::{PairEdits, PairPhoto, PairRun, PairTruth};
pub use pairs::PairRow;
#[cfg(test)]
pub(crate) use place_group::PlaceGroup;
pub use project::{PROJECT_VERSION, Project, ProjectKind, project_kind, read_project, write_block_project, write_pair_project};
pub use summary::{ExportOutcome, Summary};
pub use verdict::BlockVerdict;
pub use warning::OverviewWarning;
pub use with_text::WithText;
