//! From a folder of images to an oriented block, with its figures:
//! `cargo run --release --example reconstruct -- FOLDER [POINTS_AN_IMAGE [RAYS_ADJUSTED]]`.
//!
//! Beside a `truth.json` with reference orientations, tells how far the positions and rotations are from these after a similarity.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;
use tiepoint::{
    BlockDescription, BlockMatches, BlockOptions, DecodeLimits, ExifImage, ExifPosition, FeatureMatch, FeatureMatchOptions, FeatureOptions,
    ImageFeatures, KnownCamera, KnownImage, Located, ObservedPosition, Pinhole, Reconstruction, ReconstructionOptions, SelectOptions,
    Similarity, TwoViewOptions, all_pairs, decode, features, match_features, reconstruct_block, tie_points,
};

/// Standard errors of a position by a hand-held receiver, to the east, to the north and up.
const GNSS_SIGMA_M: [f64; 3] = [4.0, 4.0, 6.0];

struct Photo {
    name: String,
    size: [u32; 2],
    focal_px: Option<f64>,
    position: Option<ExifPosition>,
    positions: Vec<[f64; 2]>,
    descriptors: Vec<u8>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let folder = PathBuf::from(arguments.next().ok_or("usage: reconstruct FOLDER [POINTS_AN_IMAGE [RAYS_ADJUSTED]]")?);
    let per_image = arguments.next().map(|word| word.parse()).transpose()?;
    let growing_rays = arguments.next().map(|word| word.parse()).transpose()?.unwrap_or(ReconstructionOptions::default().growing_rays);
    let start = Instant::now();
    let mut names: Vec<PathBuf> = fs::read_dir(&folder)?.map(|entry| entry.map(|entry| entry.path())).collect::<Result<_, _>>()?;
    names.retain(|name| {
        name.extension().is_some_and(|end| ["jpg", "jpeg", "png", "tif", "tiff"].iter().any(|e| end.eq_ignore_ascii_case(e)))
    });
    names.sort();
    let photos = names.iter().map(|name| read(name)).collect::<Result<Vec<_>, _>>()?;
    println!(
        "{} images, {} features, {:.1} s",
        photos.len(),
        photos.iter().map(|p| p.positions.len()).sum::<usize>(),
        start.elapsed().as_secs_f64()
    );
    let matches = match_all(&photos)?;
    println!("{} matches, {:.1} s", matches.len(), start.elapsed().as_secs_f64());
    let (points, _) = tie_points(&matches, &BlockOptions::default())?;
    let positions: Vec<Vec<[f32; 2]>> =
        photos.iter().map(|photo| photo.positions.iter().map(|at| at.map(|v| v as f32)).collect()).collect();
    let located: Vec<ImageFeatures<'_>> = (photos.iter().zip(&positions))
        .map(|(photo, positions)| ImageFeatures { width_px: photo.size[0], height_px: photo.size[1], positions })
        .collect();
    let description = description(&photos);
    let selection = per_image.map(|per_image| SelectOptions { per_image, ..SelectOptions::default() });
    let options = ReconstructionOptions { selection, growing_rays, ..ReconstructionOptions::default() };
    let before = start.elapsed().as_secs_f64();
    let reconstruction = reconstruct_block(&description, &points, &located, &options)?;
    println!("{} points of {} rays, reconstructed in {:.1} s", points.len(), points.ray_count(), start.elapsed().as_secs_f64() - before);
    report(&reconstruction, &description);
    if let Ok(text) = fs::read_to_string(folder.join("truth.json")) {
        compare(&reconstruction, &description, &serde_json::from_str(&text)?);
    }
    Ok(())
}

fn read(path: &Path) -> Result<Photo, Box<dyn Error>> {
    let bytes = fs::read(path)?;
    let decoded = decode(&bytes, &DecodeLimits::default())?;
    let found = features(decoded.grey.view(), None, &FeatureOptions::default())?;
    let (width, height) = (decoded.grey.width() as u32, decoded.grey.height() as u32);
    Ok(Photo {
        name: path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        size: [width, height],
        focal_px: decoded.camera.and_then(|camera| Some(camera.focal_mm / camera.pixel_mm?)),
        position: ExifImage::read(&bytes, u64::from(width), u64::from(height)).position,
        positions: found.iter().map(|f| [f.point.x, f.point.y]).collect(),
        descriptors: found.iter().flat_map(|f| f.descriptor).collect(),
    })
}

fn match_all(photos: &[Photo]) -> Result<BlockMatches, tiepoint::Error> {
    let counts: Vec<u32> = photos.iter().map(|photo| photo.positions.len() as u32).collect();
    let mut matches = BlockMatches::new(&counts)?;
    for pair in all_pairs(photos.len() as u32) {
        let [left, right] = pair.images.map(|image| &photos[image as usize]);
        let pinhole =
            |photo: &Photo| Some(Pinhole { focal_px: photo.focal_px, principal_px: photo.size.map(|side| 0.5 * f64::from(side)) });
        let geometry = TwoViewOptions { left: pinhole(left), right: pinhole(right), ..TwoViewOptions::default() };
        let options = FeatureMatchOptions { geometry, ..FeatureMatchOptions::default() };
        let [a, b] = [left, right].map(|photo| Located { positions: &photo.positions, descriptors: &photo.descriptors });
        let found = match_features(a, b, &options)?;
        let list: Vec<FeatureMatch> = (found.matches.iter())
            .map(|m| FeatureMatch { features: [m.left as u32, m.right as u32], strength: -(f64::from(m.square)).sqrt() as f32 })
            .collect();
        if !list.is_empty() {
            matches.add_pair(pair.images, &list)?;
        }
    }
    Ok(matches)
}

/// Images of one size and focal length are taken to be of one camera.
fn description(photos: &[Photo]) -> BlockDescription {
    let mut description = BlockDescription::default();
    for photo in photos {
        let [width_px, height_px] = photo.size;
        let own = KnownCamera::of_size(width_px, height_px, photo.focal_px);
        let camera = description.cameras.iter().position(|camera| *camera == own).unwrap_or_else(|| {
            description.cameras.push(own);
            description.cameras.len() - 1
        });
        let position = photo.position.as_ref().map(|position| ObservedPosition::Geographic {
            longitude_deg: position.longitude_deg,
            latitude_deg: position.latitude_deg,
            height_m: position.height_m,
            sigma_m: GNSS_SIGMA_M,
        });
        description.images.push(KnownImage { name: photo.name.clone(), camera, position });
    }
    description
}

fn report(reconstruction: &Reconstruction, description: &BlockDescription) {
    for (number, model) in reconstruction.models.iter().enumerate() {
        let adjusted = &model.adjusted;
        let rays: usize = adjusted.images.iter().map(|image| image.rays).sum();
        let points = adjusted.points.iter().flatten().count();
        println!(
            "model {number}: {} of {} images, {points} points, {rays} rays, RMSE {:.3} px, sigma0 {:.3} px",
            model.images.len(),
            description.images.len(),
            adjusted.rmse_px,
            adjusted.sigma0_px.unwrap_or(f64::NAN)
        );
        for (camera, statistics) in adjusted.block.cameras.iter().zip(&adjusted.cameras) {
            println!("  {camera:?}\n  standard errors {:?}", statistics.standard_errors);
        }
        adjusted.rmse_by_rays.iter().for_each(|g| println!("  {} rays: {} points, RMSE {:.3} px", g.rays, g.points, g.rmse_px));
        for (image, statistics) in model.images.iter().zip(&adjusted.images) {
            let gnss = statistics.gnss.map(|gnss| gnss.residual.map(|v| (v * 10.0).round() / 10.0));
            println!(
                "  {}: {} rays, RMSE {:.3} px, GNSS off {gnss:?} m",
                description.images[*image].name, statistics.rays, statistics.rmse_px
            );
        }
        model.warnings.iter().for_each(|warning| println!("  {warning}"));
    }
    reconstruction.unoriented.iter().for_each(|image| println!("not oriented: {}: {}", description.images[image.image].name, image.reason));
}

/// Positions and rotations beside those of another solution, by a similarity between the positions.
fn compare(reconstruction: &Reconstruction, description: &BlockDescription, truth: &serde_json::Value) {
    let Some(model) = reconstruction.models.first() else { return };
    let numbers =
        |value: &serde_json::Value| value.as_array().map(|list| list.iter().filter_map(serde_json::Value::as_f64).collect::<Vec<_>>());
    let mut pairs = Vec::new();
    let mut rotations = Vec::new();
    for (image, oriented) in model.images.iter().zip(&model.adjusted.block.images) {
        let of_image =
            truth["images"].as_array().and_then(|list| list.iter().find(|i| i["file"] == description.images[*image].name.as_str()));
        let Some(reference) = of_image.map(|i| &i["reference"]) else { continue };
        let Some(centre) = numbers(&reference["C"]).and_then(|c| <[f64; 3]>::try_from(c).ok()) else { continue };
        let rows: Vec<Vec<f64>> = reference["R_cw"].as_array().map(|rows| rows.iter().filter_map(numbers).collect()).unwrap_or_default();
        pairs.push((oriented.pose.position, centre));
        rotations.push((oriented.pose.rotation, rows));
    }
    let Some(onto) = Similarity::between(&pairs) else { return };
    let base = |k: usize| (0..3).map(|i| (pairs[k].1[i] - pairs[0].1[i]) * (pairs[k].1[i] - pairs[0].1[i])).sum::<f64>().sqrt();
    let extent = (1..pairs.len()).map(base).fold(0.0, f64::max);
    let square: f64 = pairs
        .iter()
        .map(|(from, to)| {
            let at = onto.point(from);
            (0..3).map(|i| (at[i] - to[i]) * (at[i] - to[i])).sum::<f64>()
        })
        .sum();
    let angles: f64 = (rotations.iter())
        .map(|(m, rows)| {
            // The photo's axes are x right, y up, z back; those of the reference x right, y down, z forward.
            let sign = [1.0, -1.0, -1.0];
            let turned = |r: usize, c: usize| sign[r] * (0..3).map(|k| m[r][k] * onto.rotation[c][k]).sum::<f64>();
            let trace: f64 = (0..3).flat_map(|r| (0..3).map(move |c| (r, c))).map(|(r, c)| turned(r, c) * rows[r][c]).sum();
            (0.5 * (trace - 1.0)).clamp(-1.0, 1.0).acos().to_degrees().powi(2)
        })
        .sum();
    let n = pairs.len() as f64;
    println!(
        "beside the reference: {} images, positions {:.5} of the block's extent {extent:.3} ({:.3} m), rotations {:.3} deg",
        pairs.len(),
        (square / n).sqrt() / extent,
        (square / n).sqrt() / onto.scale,
        (angles / n).sqrt()
    );
}
