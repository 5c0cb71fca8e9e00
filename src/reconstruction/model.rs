//! One of the reconstructed models as the model of the whole block.

use super::numbers::PointNumbers;
use super::result::{PointSource, Reconstruction};
use crate::adjustment::ObservationVerdict;
use crate::error::refuse;
use crate::{BlockDescription, BlockModel, Error, ImageObservation, ObjectPoint, Refusal, TiePoints};

impl Reconstruction {
    /// One of the models with its accepted observations and with all cameras and images of the block, those of other models not oriented:
    /// indices are those of the block. Points without any observation are left out.
    ///
    /// `points` are those that were reconstructed: they give the confidence of each point.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a model that does not exist.
    pub fn block_model(&self, model: usize, description: &BlockDescription, points: &TiePoints) -> Result<BlockModel, Error> {
        self.block_model_with(model, description, points.len(), |point| f64::from(points.confidence(point as usize)))
    }

    /// The same; `tie_points`: how many there were to choose from; `confidence` gives that of one by its index.
    pub(crate) fn block_model_with(
        &self,
        model: usize,
        description: &BlockDescription,
        tie_points: usize,
        confidence: impl Fn(u32) -> f64,
    ) -> Result<BlockModel, Error> {
        let Some(own) = self.models.get(model) else {
            return refuse(Refusal::NoModel { model, models: self.models.len() });
        };
        let mut whole = BlockModel { origin: self.origin.filter(|_| own.in_system), ..description.to_model() };
        let block = &own.adjusted.block;
        own.cameras.iter().zip(&block.cameras).for_each(|(camera, calibrated)| whole.cameras[*camera] = *calibrated);
        own.images.iter().zip(&block.images).for_each(|(image, oriented)| whole.images[*image].pose = Some(oriented.pose));
        let (mut rays, mut by_hand) = (vec![Vec::new(); block.points.len()], vec![0; block.points.len()]);
        for ((ray, statistics), source) in block.rays.iter().zip(&own.adjusted.rays).zip(&own.rays) {
            if statistics.verdict == ObservationVerdict::Accepted {
                by_hand[ray.point] += usize::from(source.by_hand);
                rays[ray.point].push(ImageObservation { image: own.images[ray.image], x_px: ray.x_px, y_px: ray.y_px, confidence: 1.0 });
            }
        }
        let numbers = PointNumbers::new(&own.points, tie_points);
        for (point, rays) in rays.into_iter().enumerate() {
            let Some(statistics) = &own.adjusted.points[point] else { continue };
            let (confidence, name) = match own.points[point] {
                PointSource::TiePoint(index) => (confidence(index), None),
                PointSource::GroundControl(index) => (1.0, description.control.get(index).map(|known| known.name.clone())),
                PointSource::Manual(_) => (1.0, None),
            };
            let number = Some(numbers.of(own.points[point]));
            let (position, rmse_px) = (Some(block.points[point]), Some(statistics.rmse_px));
            whole.points.push(ObjectPoint { number, position, colour: [128; 3], rmse_px, confidence, name, rays, by_hand: by_hand[point] });
        }
        Ok(whole)
    }
}
