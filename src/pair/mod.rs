//! The whole way of one pair: points, descriptors, offset, matches, photo coordinates, relative orientation.

mod cameras;
mod described;
mod epipolar;
mod frames;
mod geometry;
mod hint;
mod input;
mod match_pair;
mod no_orientation;
mod one_image;
mod orienting;
mod preset;
mod rounds;
mod self_calibration;
mod settings;
mod verdict;
mod verification;
mod weakness;

pub use cameras::{KnownPhoto, PairCameras};
pub use described::{DescribedImage, describe_image};
pub use epipolar::epipolar_line;
pub use geometry::{PairInterior, photo_interior};
pub use hint::PairHint;
pub use input::{PairImage, PairInput, PhotoInput};
pub use match_pair::{PairResult, match_described_pair, match_pair};
pub use no_orientation::NoOrientation;
pub use one_image::OneImage;
pub(crate) use orienting::sigma0_of_all_mm;
pub use orienting::{match_weights, observations, orient_matches};
pub use preset::PairPreset;
pub use rounds::{PairMatching, match_in_rounds};
pub use settings::PairSettings;
pub use verdict::{KnownWorst, PairVerdict};
pub use verification::{FeatureMatchOptions, VerifiedMatches, match_features};
pub(crate) use weakness::LARGEST_SIGMA0_PX;
pub use weakness::judged;
