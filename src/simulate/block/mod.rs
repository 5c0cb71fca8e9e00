//! A simulated block: exposures over made ground, the features they see and matches of which it is known which are right, or photos.
//!
//! It is for what finds matches, joins them and reconstructs a block: it gives what stands before an orientation, wrong matches and features of
//! no common point among it, and its cameras have no distortion. What a bundle adjustment takes is simulated in `network`.
//!
//! Data flow: [`BlockFlight`] → `exposures` (where each photo is taken, and how it is turned) → `features` (which ground each sees) →
//! `matches` (right ones, wrong ones) → [`SimulatedBlock`]; or `exposures` → `photos` ([`BlockScene`], one photo at a time);
//! what is made of either is compared with the truth in `score`.

mod exposures;
mod features;
mod flight;
mod ground;
mod matches;
mod orthophoto;
mod photos;
mod score;
mod simulated;
mod truth;

pub use exposures::Exposure;
pub use flight::{BlockFlight, BlockPreset, BlockView};
pub use photos::BlockScene;
pub use score::{BlockScore, check_truth, score_block};
pub use simulated::{SimulatedBlock, simulate_block};
