//! From described points to matches: expected offset, search window, dissimilarity, rules of consistency.

mod area;
mod blocks;
mod coarse_to_fine;
mod correlation;
mod cross_correlation;
mod filling;
mod fit;
mod gradients;
mod guided;
mod images;
mod index;
mod least_squares;
mod local_map;
mod nearest;
mod neighbours;
mod offset;
mod options;
mod outcome;
mod parallax;
mod parallax_gradient;
mod positions;
mod products;
mod refine;
mod region;
mod rules;
mod scaled;
mod search;
mod search_area;
mod spline;
mod strategy;
mod surface;
#[cfg(test)]
pub(crate) mod texture;
mod warp;
mod window_model;

pub use blocks::DESCRIPTOR_BYTES;
pub use gradients::gradient_candidates;
pub use guided::{Guide, GuidedOptions, Located, guided_matches};
pub use images::{Descriptors, MatchImage};
pub use nearest::{DescriptorMatch, Nearest, NearestOptions, NearestTable, nearest, nearest_matches, nearest_of};
pub use offset::{OffsetField, estimate_offset, estimate_offset_of_reduced};
pub use options::{Denominator, MatchOptions, Refinement, Strategy};
pub use outcome::{Fit, Match, MatchCounts, MatchSet, Rule, Verdict};
pub use parallax::{ParallaxDeviation, parallax_deviation};
pub use region::{EpipolarLines, Expectation};
pub use search::{Candidate, Described, candidates_of, match_points};
pub use strategy::match_images;

pub(crate) use filling::filled_in;
pub(crate) use fit::{Fit as WindowFit, LeastSquaresOptions, Refusal};
pub(crate) use gradients::verified_set;
pub(crate) use guided::square_distance_of;
pub(crate) use least_squares::LeastSquares;
pub(crate) use parallax_gradient::within_parallax_gradient;
pub(crate) use refine::refine;
