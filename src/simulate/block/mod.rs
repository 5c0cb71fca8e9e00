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
mod ground;
mod matches;
mod photos;
mod score;

pub use exposures::Exposure;
pub use photos::BlockScene;
pub use score::{BlockScore, check_truth, score_block};

use crate::parameters::{BLOCK_FLIGHT_PARAMETERS, check_by};
use crate::{BlockMatches, Error, FeatureMatch, ImageFeatures};
use serde::{Deserialize, Serialize};

/// How the photos of a block look at the ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum BlockView {
    /// Straight down.
    Nadir,
    /// Five cameras an exposure: one down with 85 mm, four tilted by 45° forwards, backwards, left and right with 65 mm.
    Oblique,
    /// Straight down, every other strip at 1.5 times the height.
    TwoHeights,
}

/// What is flown, seen and matched. Units are in the names.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct BlockFlight {
    pub view: BlockView,
    pub strips: usize,
    /// Exposures of a strip.
    pub exposures: usize,
    pub forward_overlap: f64,
    pub side_overlap: f64,
    pub width_px: u32,
    pub height_px: u32,
    pub pixel_mm: f64,
    pub flying_height_m: f64,
    pub relief_m: f64,
    /// Features an image has on average, of which `clutter` show no point that another image shows.
    pub features: usize,
    pub clutter: f64,
    /// Probability that a feature that two images have is matched between them.
    pub matched: f64,
    /// Share of wrong matches, and the share of these that join the same two places again and again, as repeated structures do.
    pub wrong: f64,
    pub repeated: f64,
    /// Standard deviation of a feature's coordinate.
    pub noise_px: f64,
    /// Standard deviation of each coordinate of a position that the receiver records.
    pub receiver_m: f64,
    /// Houses and trees on a km² of a photographed scene, where lots and gardens are left for them.
    pub buildings: f64,
    pub trees: f64,
    pub seed: u32,
}

impl Default for BlockFlight {
    fn default() -> Self {
        Self {
            view: BlockView::Nadir,
            strips: 5,
            exposures: 6,
            forward_overlap: 0.75,
            side_overlap: 0.5,
            width_px: 4000,
            height_px: 3000,
            pixel_mm: 0.009,
            flying_height_m: 800.0,
            relief_m: 60.0,
            features: 2000,
            clutter: 0.3,
            matched: 0.8,
            wrong: 0.05,
            repeated: 0.05,
            noise_px: 0.3,
            receiver_m: 1.0,
            buildings: 2000.0,
            trees: 2500.0,
            seed: 1,
        }
    }
}

impl BlockFlight {
    fn check(&self) -> Result<(), Error> {
        let values = serde_json::to_value(self).unwrap_or_default();
        for parameter in BLOCK_FLIGHT_PARAMETERS.iter().filter(|p| p.key != "block_flight.view") {
            // A number that is none has no JSON form.
            check_by(parameter, values[parameter.key.trim_start_matches("block_flight.")].as_f64().unwrap_or(f64::NAN))?;
        }
        Ok(())
    }
}

/// A block of which everything is known.
#[derive(Debug, Clone, PartialEq)]
pub struct SimulatedBlock {
    pub exposures: Vec<Exposure>,
    /// Positions of each image's features in px, the centre of the top-left pixel at (0.5, 0.5).
    pub features: Vec<Vec<[f32; 2]>>,
    /// The ground point that each feature shows; absent where no other image shows it.
    pub owners: Vec<Vec<Option<u32>>>,
    /// Ground points `[x, y, z]` in m.
    pub ground: Vec<[f64; 3]>,
    /// Pairs of images with their matches.
    pub pairs: Vec<([u32; 2], Vec<FeatureMatch>)>,
    pub width_px: u32,
    pub height_px: u32,
}

impl SimulatedBlock {
    /// All matches, ready to be joined.
    ///
    /// # Errors
    /// As [`BlockMatches::add_pair`].
    pub fn matches(&self) -> Result<BlockMatches, Error> {
        let counts: Vec<u32> = self.features.iter().map(|list| list.len() as u32).collect();
        let mut matches = BlockMatches::new(&counts)?;
        self.pairs.iter().try_for_each(|(images, list)| matches.add_pair(*images, list))?;
        Ok(matches)
    }

    /// The features, as a selection asks for them.
    pub fn image_features(&self) -> Vec<ImageFeatures<'_>> {
        self.features.iter().map(|positions| ImageFeatures { width_px: self.width_px, height_px: self.height_px, positions }).collect()
    }

    /// Whether two features show the same ground.
    pub fn is_right(&self, a: (u32, u32), b: (u32, u32)) -> bool {
        let owner = |(image, feature): (u32, u32)| self.owners[image as usize][feature as usize];
        owner(a).is_some() && owner(a) == owner(b)
    }
}

/// Flies a block.
///
/// # Errors
/// [`Error::InvalidOption`] for a value outside its range.
pub fn simulate_block(flight: &BlockFlight) -> Result<SimulatedBlock, Error> {
    flight.check()?;
    let exposures = exposures::exposures(flight);
    let seen = features::features(flight, &exposures);
    let pairs = matches::matches(flight, &seen);
    let features::Seen { features, owners, ground } = seen;
    Ok(SimulatedBlock { exposures, features, owners, ground, pairs, width_px: flight.width_px, height_px: flight.height_px })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_field_is_described_once() {
        let values = serde_json::to_value(BlockFlight::default()).unwrap();
        let mut described: Vec<&str> = BLOCK_FLIGHT_PARAMETERS.iter().map(|p| p.key.trim_start_matches("block_flight.")).collect();
        described.sort_unstable();
        let mut fields: Vec<&str> = values.as_object().unwrap().keys().map(String::as_str).collect();
        fields.sort_unstable();
        assert_eq!(described, fields);
        BlockFlight::default().check().unwrap();
    }

    #[test]
    fn features_lie_where_their_ground_is_seen() {
        let block = simulate_block(&BlockFlight { strips: 2, exposures: 2, view: BlockView::Oblique, ..BlockFlight::default() }).unwrap();
        assert_eq!(block.exposures.len(), 20);
        let mut squares = 0.0;
        let mut count = 0;
        for (image, exposure) in block.exposures.iter().enumerate() {
            for (at, owner) in block.features[image].iter().zip(&block.owners[image]) {
                let Some(owner) = owner else { continue };
                let [x, y] = exposure.project(block.ground[*owner as usize], block.width_px, block.height_px).unwrap();
                squares += (f64::from(at[0]) - x) * (f64::from(at[0]) - x) + (f64::from(at[1]) - y) * (f64::from(at[1]) - y);
                count += 2;
            }
        }
        let scatter = (squares / f64::from(count)).sqrt();
        assert!((scatter - 0.3).abs() < 0.01, "{scatter} px of {count} coordinates");
    }
}
