//! A simulated flight: two overlapping photographs of a made scene, of which everything is known.
//!
//! Data flow: [`Flight`] → `scene` (relief, streets, river, buildings, trees, paint) → `photo` (central projection and scan) → `view`
//! (which surface a pixel sees) → `render` (samples, point spread) → `sensor` (haze, gain, offset, grain, noise) → [`Sample`].
//!
//! Whole blocks are simulated for what is tested with them: in `block` as features or photos, which must be matched before they are oriented;
//! in `network` as the rays and approximate values that a bundle adjustment takes.
//!
//! Ground coordinates are metres, x to the right in the left photo (along the base, but for the left photo's tilts), y up in
//! it, z up; the left photo's perspective centre is above the origin. The same flight gives the same bytes on every machine.

mod block;
mod buckets;
mod flight;
mod ground_area;
mod lattice;
mod limits;
mod mounting;
mod network;
mod photo;
mod random;
mod render;
mod sample;
mod scene;
mod score;
mod sensor;
mod truth;
mod view;

pub use block::{
    BlockFlight, BlockPreset, BlockScene, BlockScore, BlockView, Exposure, SimulatedBlock, check_truth, score_block, simulate_block,
};
pub use flight::{Flight, Preset};
pub use network::{SimulatedNetwork, simulate_network};
pub use random::SAMPLE_SEED;
pub use sample::{Sample, check_flight, sample_pair, simulate};
pub use score::{DenseTruth, MatchScore, RIGHT_WITHIN_PX, Rightness, score_matches};
