//! What is known of each image of a finished block.

use super::coverage::{Coverage, coverage};
use super::with_text::WithText;
use crate::message::messages;
use crate::{BlockRun, ExifPosition, Failure, UnorientedReason};
use serde::Serialize;

/// An image of a finished block.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ImageRow {
    pub name: String,
    pub width_px: u32,
    pub height_px: u32,
    /// Index of its camera.
    pub camera: usize,
    /// Index of the model that it is in; absent where it is not oriented.
    pub model: Option<usize>,
    /// Whether it is oriented in the model that is written.
    pub is_oriented: bool,
    /// Its projection centre there.
    pub position: Option<[f64; 3]>,
    /// Why it is not; absent where it is.
    pub reason: Option<WithText<ImageReason>>,
    /// Points found and described; absent where an older project file does not say.
    pub features: Option<u32>,
    /// In the model that is written.
    pub observations: usize,
    /// Of the nine von Gruber positions, those that hold one of these.
    pub positions: usize,
    /// Root mean square length of the residuals of its observations in px; absent where it has none that are adjusted.
    pub rmse_px: Option<f64>,
    /// As the image's EXIF says, 1..8.
    pub exif_orientation: Option<u8>,
    pub gnss: Option<ExifPosition>,
}

/// One row for each image.
pub(super) fn image_rows(run: &BlockRun) -> Vec<ImageRow> {
    let covered = coverage(&run.model);
    let models = run.reconstruction.as_ref().map_or(&[][..], |assembly| &assembly.models);
    let mut model_of = vec![None; run.images.len()];
    // The first model is the one that is written.
    for (index, model) in models.iter().enumerate().rev() {
        model.images.iter().for_each(|image| model_of[*image] = Some(index));
    }
    let mut rmse_px = vec![None; run.images.len()];
    if let Some(model) = models.first() {
        let statistics = model.images.iter().zip(&model.adjusted.images).filter(|(_, statistics)| statistics.rays > 0);
        statistics.for_each(|(image, statistics)| rmse_px[*image] = Some(statistics.rmse_px));
    }
    let rows = run.images.iter().zip(&run.model.images).zip(covered).enumerate();
    let rows = rows.map(|(index, ((image, modelled), Coverage { observations, positions }))| ImageRow {
        name: image.name.clone(),
        width_px: image.width_px,
        height_px: image.height_px,
        camera: image.camera,
        model: model_of[index],
        is_oriented: modelled.pose.is_some(),
        position: modelled.pose.map(|pose| pose.position),
        reason: modelled.pose.is_none().then(|| WithText::of(reason(run, index, model_of[index]))),
        features: image.features,
        observations,
        positions,
        rmse_px: rmse_px[index],
        exif_orientation: image.exif.orientation,
        gnss: image.gnss().copied(),
    });
    rows.collect()
}

messages! {
    /// Why an image is not oriented in the model that is written.
    #[derive(Debug, Clone, PartialEq, Serialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum ImageReason as "image_reason" {
        /// It is in another model, of so many images.
        Apart { images: usize },
        Unoriented { unoriented: UnorientedReason },
        /// The orientation of the whole block failed.
        Failed { failure: Failure },
        /// A project file of version 1 does not say.
        Unknown,
    }
}

fn reason(run: &BlockRun, image: usize, model: Option<usize>) -> ImageReason {
    let assembly = match &run.reconstruction {
        Ok(assembly) => assembly,
        Err(failure) => return ImageReason::Failed { failure: failure.clone() },
    };
    match model.and_then(|model| assembly.models.get(model)) {
        Some(model) => ImageReason::Apart { images: model.images.len() },
        None => {
            let known = assembly.unoriented.iter().find(|unoriented| unoriented.image == image);
            known.map_or(ImageReason::Unknown, |unoriented| ImageReason::Unoriented { unoriented: unoriented.reason })
        }
    }
}
