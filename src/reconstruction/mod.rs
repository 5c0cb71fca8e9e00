//! A block from nothing but its rays: which images can be oriented, and how.
//!
//! Data flow: [`BlockDescription`](crate::BlockDescription) with multi-ray points → `rays` (who sees what) → `start` (two images) → `growth` (`resection` of images by
//! `p3p`, `intersection` of points, `adjusting` on the way) → `frame` (into the system of observed positions) → `finish` (all points, the
//! choice among them, the bundle adjustment) → [`Reconstruction`].

mod adjusting;
mod check_refused;
mod choosing;
mod common_shift;
mod control_course;
mod control_kind;
mod control_lost;
mod control_shape;
mod control_spread;
mod control_telling;
mod control_test;
mod control_tests;
mod draft;
mod exchanged_names;
mod finish;
mod frame;
mod growth;
mod intersection;
mod level;
mod material;
mod mistake;
mod model;
mod net;
mod numbers;
mod options;
mod p3p;
mod placing;
mod positions_apart;
mod rays;
mod readjust;
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

pub(crate) use common_shift::{CommonShift, SHARED};
pub use control_kind::ControlKind;
pub(crate) use frame::{PLACING, origin_of};
pub(crate) use mistake::Doubted;
pub use mistake::{Axis, Mistake};
pub(crate) use numbers::PointNumbers;
pub use options::ReconstructionOptions;
pub(crate) use readjust::{Changed, ObservedPoint, ObservedRay, RayPart, RayWeight, brought, readjust, with_further_control};
pub use reconstruct::reconstruct_block;
pub use result::{
    ObservationSource, PointSource, ReconstructedModel, Reconstruction, RefusedControl, RejectedObservation, SupportingPoint,
    SupportingRay, SurveyedPoint, UnorientedImage,
};
pub(crate) use single::resect_image;
pub use warning::{BlockWarning, ControlApart, LengthUnit, Observed, RejectedPosition, UnorientedReason};
