//! Chosen multi-ray points as points of a block that is exchanged.

use crate::error::refuse;
use crate::{BlockModel, Error, FeatureObservation, ImageFeatures, ImageObservation, Input, ObjectPoint, Refusal, TiePoints};

impl BlockModel {
    /// Adds points, not intersected yet, in the order of `chosen`; `features` are those of the block's images, in their order.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for points, images or features that do not exist. Nothing is added then.
    pub fn add_points(&mut self, points: &TiePoints, chosen: &[u32], features: &[ImageFeatures<'_>]) -> Result<(), Error> {
        if features.len() != self.images.len() {
            let (images, wanted) = (features.len(), self.images.len());
            return refuse(Refusal::FeaturesOfImages { input: Input::PointsOfBlock, images, wanted });
        }
        let ray = |ray: &FeatureObservation| {
            let place = features.get(ray.image as usize).and_then(|image| image.positions.get(ray.feature as usize));
            let Some([x, y]) = place else {
                return refuse(Refusal::NoFeature { feature: ray.feature, image: ray.image });
            };
            Ok(ImageObservation {
                image: ray.image as usize,
                x_px: f64::from(*x),
                y_px: f64::from(*y),
                confidence: f64::from(ray.confidence),
            })
        };
        let point = |index: &u32| {
            let index = *index as usize;
            if index >= points.len() {
                return refuse(Refusal::NoTiePoint { point: index, points: points.len() });
            }
            let rays = points.rays(index).iter().map(ray).collect::<Result<_, _>>()?;
            Ok(ObjectPoint {
                number: Some(index as u32 + 1),
                position: None,
                colour: [128; 3],
                rmse_px: None,
                confidence: f64::from(points.confidence(index)),
                name: None,
                rays,
                by_hand: 0,
            })
        };
        let added = chosen.iter().map(point).collect::<Result<Vec<_>, _>>()?;
        self.points.extend(added);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::tiny_block;
    use crate::{BlockMatches, BlockOptions, FeatureMatch, tie_points};

    #[test]
    fn chosen_points_get_the_places_of_their_features() {
        let mut matches = BlockMatches::new(&[2, 2, 0]).unwrap();
        let of = |a, b| FeatureMatch { features: [a, b], strength: 1.0 };
        matches.add_pair([0, 1], &[of(0, 1), of(1, 0)]).unwrap();
        let positions = [[[1.5, 2.5], [3.5, 4.5]], [[5.5, 6.5], [7.5, 8.5]]];
        let image = |positions| ImageFeatures { width_px: 400, height_px: 300, positions };
        let features = [image(&positions[0][..]), image(&positions[1][..]), image(&[])];
        let (points, _) = tie_points(&matches, &features, &BlockOptions::default()).unwrap();
        let mut model = tiny_block();
        model.add_points(&points, &[1], &features).unwrap();
        let places: Vec<_> = model.points[3].rays.iter().map(|ray| (ray.image, ray.x_px, ray.y_px)).collect();
        assert_eq!(places, [(0, 3.5, 4.5), (1, 5.5, 6.5)]);
        model.check().unwrap();
        assert!(model.add_points(&points, &[2], &features).unwrap_err().to_string().contains("point 2"));
        assert!(model.add_points(&points, &[0], &features[..2]).unwrap_err().to_string().contains("features of 2 images"));
        let short = [image(&positions[0][..1]), features[1], features[2]];
        assert!(model.add_points(&points, &[0, 1], &short).unwrap_err().to_string().contains("feature 1 of image 0"));
        assert_eq!(model.points.len(), 4);
    }
}
