//! The geometry of two views from matches with gross errors: calibrated or not, over relief, over a plane, from one place.
//!
//! Data flow: `search` chooses among `models` by what is known of the cameras → a model searches its matrix (`fundamental`, `homography`,
//! `rotation`, `focal`: minimal samples, then `refine`) → `matches` say which of them agree (`scale`, `chance`) and whether a simpler
//! model explains them (`support`) → [`TwoView`].

mod chance;
mod direct;
mod focal;
mod frame;
mod fundamental;
mod homography;
mod least_direction;
mod matches;
mod models;
mod options;
mod parallax;
mod refine;
mod result;
mod rotation;
mod scale;
mod search;
mod support;
mod transfer;

pub(crate) use chance::Support;
pub use direct::{fundamental_eight_point, fundamental_seven_point, homography_direct};
pub use options::{Pinhole, TwoViewOptions};
pub use result::{Degeneracy, FocalEstimate, NoGeometry, TwoView, TwoViewModel};
pub use search::two_view;
pub(crate) use search::two_view_from;
