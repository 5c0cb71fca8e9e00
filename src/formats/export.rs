//! All formats by name, and the files that each gives.

use super::colmap_features::{ColmapFeature, colmap_features, colmap_matches};
use super::sight::Sights;
use super::text::{file_name, one_word};
use super::{agisoft, bingo, bundler, colmap_write, csv_tables, geojson, isat, micmac, nvm, opensfm, patb};
use crate::{BlockModel, Document, Error};
use serde::{Deserialize, Serialize};

/// A format that blocks are written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum ExportFormat {
    /// `features/*.txt`, `matches.txt`, and `sparse/*.txt` where images are oriented.
    Colmap,
    /// `Homol/Pastis*/*.txt`.
    Micmac,
    /// `bundle.out`, `list.txt`.
    Bundler,
    /// `block.nvm`.
    Nvm,
    /// `tracks.csv`.
    Opensfm,
    /// `bingo.dat`.
    Bingo,
    /// `isat_photo`.
    Isat,
    /// `markers.xml`.
    Agisoft,
    /// `patb.im`, `patb_photos.txt`: experimental.
    Patb,
    /// `images.csv`, `points.csv`, `rays.csv`.
    Csv,
    /// `block.json`: all of [`BlockModel`].
    Json,
    /// `block.geojson`.
    Geojson,
}

impl ExportFormat {
    /// All of them.
    pub const ALL: [Self; 12] = [
        Self::Colmap,
        Self::Micmac,
        Self::Bundler,
        Self::Nvm,
        Self::Opensfm,
        Self::Bingo,
        Self::Isat,
        Self::Agisoft,
        Self::Patb,
        Self::Csv,
        Self::Json,
        Self::Geojson,
    ];
}

/// Writes a block in one format: `emit` is called with the path, relative to a folder, and the text of each file in turn, so that only one
/// file is in memory at a time.
///
/// # Errors
/// As [`BlockModel::check`]; [`Error::InvalidInput`] for names that the format cannot hold; what the format needs beside: a pixel size
/// ([`Error::InvalidOption`]), an origin on the earth ([`Error::InvalidInput`]); [`Error::NotConverged`] for a distortion without inverse
/// where a format takes corrected positions; the errors of `emit`.
pub fn export_block(model: &BlockModel, format: ExportFormat, emit: &mut dyn FnMut(&str, &str) -> Result<(), Error>) -> Result<(), Error> {
    model.check()?;
    let sights = Sights::new(model);
    match format {
        ExportFormat::Colmap => export_colmap(model, &sights, emit),
        ExportFormat::Micmac => micmac::write_homol(model, &sights, emit),
        ExportFormat::Bundler => {
            let [bundle, list] = bundler::write_bundle(model, &sights)?;
            emit("bundle.out", &bundle)?;
            emit("list.txt", &list)
        }
        ExportFormat::Nvm => emit("block.nvm", &nvm::write_nvm(model, &sights)?),
        ExportFormat::Opensfm => emit("tracks.csv", &opensfm::write_tracks(model, &sights)?),
        ExportFormat::Bingo => emit("bingo.dat", &bingo::write_image_coordinates(model, &sights)?),
        ExportFormat::Isat => emit("isat_photo", &isat::write_photos(model, &sights)?),
        ExportFormat::Agisoft => emit("markers.xml", &agisoft::write_markers(model)?),
        ExportFormat::Patb => {
            let [coordinates, photos] = patb::write_image_coordinates(model, &sights)?;
            emit("patb.im", &coordinates)?;
            emit("patb_photos.txt", &photos)
        }
        ExportFormat::Csv => {
            emit("images.csv", &csv_tables::images_table(model, &[], |_, row| row))?;
            emit("points.csv", &csv_tables::points_table(model, &[], |_, row| row))?;
            emit("rays.csv", &csv_tables::rays_table(model, &[], |_, _, row| row))
        }
        ExportFormat::Json => emit("block.json", &json(model)?),
        ExportFormat::Geojson => emit("block.geojson", &geojson::write_geojson(model)?),
    }
}

fn export_colmap(model: &BlockModel, sights: &Sights, emit: &mut dyn FnMut(&str, &str) -> Result<(), Error>) -> Result<(), Error> {
    for (image, sightings) in model.images.iter().zip(&sights.of_images) {
        let of = |s: &super::sight::Sighting| ColmapFeature {
            x_px: s.ray.x_px,
            y_px: s.ray.y_px,
            scale: 1.0,
            orientation_rad: 0.0,
            descriptor: None,
        };
        let features: Vec<ColmapFeature<'_>> = sightings.iter().map(of).collect();
        let mut text = String::new();
        colmap_features(&features, &mut text)?;
        let name = one_word("COLMAP features", file_name("COLMAP features", &image.name)?)?;
        emit(&format!("features/{name}.txt"), &text)?;
    }
    let mut text = String::new();
    for ([a, b], matches) in sights.pairs(model) {
        colmap_matches([&model.images[a].name, &model.images[b].name], &matches, &mut text)?;
    }
    emit("matches.txt", &text)?;
    if model.images.iter().all(|image| image.pose.is_none()) {
        return Ok(());
    }
    let files = colmap_write::write_model(model, sights)?;
    ["cameras", "images", "points3D"].iter().zip(&files).try_for_each(|(name, text)| emit(&format!("sparse/{name}.txt"), text))
}

fn json(model: &BlockModel) -> Result<String, Error> {
    let text = serde_json::to_string(model).map_err(|e| Error::InvalidJson { document: Document::Block, json_fault: e.into() })?;
    Ok(text + "\n")
}
