//! The run of a block, without input and output of its own: hosts do its jobs and keep bytes.
//!
//! Data flow: [`RunInput`] → `images` (`features` of each) → `likeness` where no position says which images are near → `pairs` → `points` →
//! `windows` and `refinement` where observations are refined → orientation → [`BlockRun`]. [`Run`] goes from stage to stage; what a job is for
//! a worker stands in `task`, what it does in `execute`, what is kept of it in `records`.

mod added_control;
mod cameras;
mod carried_edits;
mod carrying;
mod control;
mod control_point;
mod edited;
mod execute;
mod fault;
mod features;
mod focal_change;
#[cfg(not(target_arch = "wasm32"))]
mod folder;
mod geoid;
mod gross_places;
mod ground;
#[cfg(not(target_arch = "wasm32"))]
mod host;
mod images;
mod input;
mod job;
mod like_scans;
mod likeness;
mod linked_places;
mod mask_file;
mod masks;
mod mistakes;
mod named_images;
mod observed;
mod on_orthophoto;
mod pairs;
mod place_factors;
mod place_names;
mod place_slip;
mod places;
mod points;
mod positions;
mod recorded_positions;
mod records;
mod refinement;
mod result;
mod run;
mod stage;
mod state;
mod stated_errors;
mod system;
mod task;
mod windows;

pub(crate) use cameras::contradicted_focal;
pub use cameras::{CameraRules, InitialCamera};
pub use carried_edits::CarriedEdits;
pub use carrying::{CarriedSteps, Carrying, EditNames, carried_steps};
pub use control::ControlTables;
pub(crate) use edited::check_steps;
pub use execute::execute;
#[cfg(not(target_arch = "wasm32"))]
pub use folder::replace_file;
pub(crate) use ground::GroundPoint;
#[cfg(not(target_arch = "wasm32"))]
pub use host::{images_in, run_block};
pub use input::{ControlTexts, RunInput};
pub use job::{FileNeeded, Job, News, ReadImage, StageName, Step, Work};
pub(crate) use mask_file::decode_mask;
pub use masks::masks_of;
pub use named_images::measurements_of_images;
pub(crate) use observed::stated_height_error;
pub use on_orthophoto::{NotLinked, OnOrthophoto};
pub(crate) use place_names::{is_place_of_orthophoto, name_by_hand};
pub(crate) use place_slip::place_slip;
pub use places::{BlockPlaces, PlaceAgain, SeenIn, SeenPlace};
pub use positions::{GivenPosition, PositionTable};
pub use records::digest;
pub use result::{BlockRun, EditedRun, JoinedPoints, RefinedObservation, RefinementTable, RunImage, SkippedImage};
pub use run::Run;
pub(crate) use system::{is_unit, unit_name};
pub use task::Task;
