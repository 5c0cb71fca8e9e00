//! A block of features and matches, of which everything is known.

use super::exposures::{Exposure, exposures};
use super::features::{Seen, features};
use super::flight::BlockFlight;
use super::matches::matches;
use super::truth::true_block;
use crate::{BlockDescription, BlockMatches, BlockModel, Camera, Error, FeatureMatch, ImageFeatures, KnownCamera, KnownImage, ModelImage};

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
    /// The true cameras and exterior orientations; no points.
    pub truth: BlockModel,
}

impl SimulatedBlock {
    /// What is known of it before its orientation: true focal lengths times a factor, or none; no positions.
    pub fn description(&self, focal_factor: Option<f64>) -> BlockDescription {
        let camera = |camera: &Camera| KnownCamera::of_size(self.width_px, self.height_px, focal_factor.map(|k| k * camera.focal_px));
        let image = |image: &ModelImage| KnownImage { name: image.name.clone(), camera: image.camera, position: None, view: None };
        BlockDescription {
            cameras: self.truth.cameras.iter().map(camera).collect(),
            images: self.truth.images.iter().map(image).collect(),
            control: Vec::new(),
        }
    }

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
    let exposures = exposures(flight);
    let seen = features(flight, &exposures);
    let pairs = matches(flight, &seen);
    let truth = true_block(flight, &exposures);
    let Seen { features, owners, ground } = seen;
    Ok(SimulatedBlock { exposures, features, owners, ground, pairs, width_px: flight.width_px, height_px: flight.height_px, truth })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::BlockView;

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
