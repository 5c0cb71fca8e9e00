//! A block from nothing but its rays: which images can be oriented, and how.
//!
//! Data flow: [`BlockDescription`](crate::BlockDescription) with multi-ray points → `rays` (who sees what) → `start` (two images) → `growth` (`resection` of images by
//! `p3p`, `intersection` of points, `adjusting` on the way) → `frame` (into the system of observed positions) → `finish` (all points, the
//! choice among them, the bundle adjustment) → [`Reconstruction`].

mod adjusting;
mod choosing;
mod finish;
mod frame;
mod growth;
mod intersection;
mod level;
mod material;
mod model;
mod net;
mod options;
mod p3p;
mod rays;
mod reconstruct;
mod refusal;
mod resection;
mod result;
mod review;
mod single;
mod start;
mod surveyed;
mod units;
mod warning;

pub use options::ReconstructionOptions;
pub use reconstruct::reconstruct_block;
pub use result::{ObservationSource, PointSource, ReconstructedModel, Reconstruction, RejectedObservation, SurveyedPoint, UnorientedImage};
pub(crate) use single::resect_image;
pub use warning::{BlockWarning, LengthUnit, Observed, RejectedPosition, UnorientedReason};
