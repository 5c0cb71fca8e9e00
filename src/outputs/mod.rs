//! What a finished run writes and shows: tables, summary, overview, files for other programs; and the project file, which keeps all of it.
//!
//! Data flow: [`BlockRun`](crate::BlockRun) → rows of images and pairs → tables, [`Summary`], [`BlockOverview`] → [`block_files`].

mod coverage;
mod files;
mod images;
mod overview;
mod pair;
mod pairs;
mod project;
mod refined;
mod summary;
mod tables;
mod verdict;
mod warning;
mod with_text;

pub use coverage::{Coverage, coverage};
pub use files::{BlockFiles, block_files, planned_files};
pub use images::{ImageReason, ImageRow};
pub use overview::{BlockOverview, CameraRow, FoundPoints, PointColumns, RayCount};
pub use pair::{PairPhoto, PairRun, PairTruth};
pub use pairs::PairRow;
pub use project::{PROJECT_VERSION, Project, ProjectKind, project_kind, read_project, write_block_project, write_pair_project};
pub use summary::{CheckSummary, ExportOutcome, Summary};
pub use verdict::BlockVerdict;
pub use warning::OverviewWarning;
pub use with_text::WithText;
