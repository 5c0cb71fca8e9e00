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

use crate::catalogue::{choices, options};
use crate::{BlockMatches, Error, FeatureMatch, ImageFeatures};

choices! {
    /// How the photos of a block look at the ground.
    pub enum BlockView {
        /// Straight down.
        Nadir = "nadir",
        /// Five cameras per exposure: one down with 85 mm, four tilted by 45° forwards, backwards, left and right with 65 mm.
        Oblique = "oblique",
        /// Straight down, every other strip at 1.5 times the height.
        TwoHeights = "two-heights",
    }
}

options! {
    /// What is flown, seen and matched.
    pub struct BlockFlight in "block_flight" {
        section "Flight";

        /// Straight down; one camera down and four tilted by 45°; or straight down with every other strip at 1.5 times the height.
        view: BlockView = BlockView::Nadir, "View";

        /// The number of strips that are flown side by side.
        strips: usize = 5, "Strips", 1..=1000;

        /// The number of exposures per strip, each by one camera, or by five in an oblique block.
        exposures: usize = 6, "Exposures per strip", 1..=1000;

        /// The overlap of photos that follow one another in a strip.
        forward_overlap: f64 = 0.75, "Forward overlap", 0..=0.95;

        /// The overlap of neighbouring strips.
        side_overlap: f64 = 0.5, "Side overlap", 0..=0.95;

        /// The columns of a photo, across the flight.
        width_px: u32 = 4000, "Columns", in "px", 16..=100000;

        /// The rows of a photo, along the flight.
        height_px: u32 = 3000, "Rows", in "px", 16..=100000;

        /// The side of a pixel, with principal distances of 85 mm and 65 mm: larger pixels show more ground.
        pixel_mm: f64 = 0.009, "Pixel", in "mm", 0.0005..=1;

        /// The height above the mean ground: a larger one makes the scale smaller.
        flying_height_m: f64 = 800.0, "Flying height", in "m", 10..=10000;

        /// The range of the ground's heights.
        relief_m: f64 = 60.0, "Relief", in "m", 0..=1000;

        /// The standard deviation of a coordinate of a GNSS position.
        receiver_m: f64 = 1.0, "GNSS noise", in "m", 0..=100;

        /// The buildings of a photographed scene; fewer stand where there are fewer lots.
        buildings: f64 = 2000.0, "Buildings", in "km⁻²", 0..=20000;

        /// The trees of a photographed scene, where gardens are left for them.
        trees: f64 = 2500.0, "Trees", in "km⁻²", 0..=20000;

        /// Everything random follows from it: the same seed gives the same block.
        seed: u32 = 1, "Seed", 0..=4294967295.0;

        section "Features without photos";

        /// The number of features per image, on average.
        features: usize = 2000, "Features per image", 1..=100000;

        /// The share of the features that no other image shows.
        clutter: f64 = 0.3, "Lone features", 0..=0.9;

        /// The probability that a feature which two images show is matched between them.
        matched: f64 = 0.8, "Matched", 0..=1;

        /// The share of the matches that join different places.
        wrong: f64 = 0.05, "Wrong matches", 0..=1;

        /// The share of the wrong matches that join the same two places in every pair of images.
        repeated: f64 = 0.05, "Repeated structures", 0..=1;

        /// The standard deviation of a feature's coordinate.
        noise_px: f64 = 0.3, "Noise", in "px", 0..=10;
    }
}

impl BlockFlight {
    /// The parameters on which photos depend.
    pub fn photo_parameters() -> impl Iterator<Item = &'static crate::Parameter> {
        Self::PARAMETERS.iter().filter(|p| p.section == "Flight")
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
    flight.check_ranges()?;
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
