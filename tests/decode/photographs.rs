//! Real photographs, where they are at hand.

use std::path::{Path, PathBuf};

use serde_json::Value;
use tiepoint::CameraOrigin;

use super::decode;

/// The folder of test images beside the project, if there is one.
fn folder() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data");
    if !folder.is_dir() {
        eprintln!("skipped: no test images in {}", folder.display());
    }
    folder.is_dir().then_some(folder)
}

fn images(folder: &Path) -> Vec<PathBuf> {
    let entries = |folder: &Path| std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect::<Vec<_>>();
    let is_image =
        |path: &PathBuf| path.extension().is_some_and(|e| ["jpg", "png", "tif"].iter().any(|known| e.eq_ignore_ascii_case(known)));
    let mut images: Vec<_> = entries(folder).into_iter().filter(|p| p.is_dir()).flat_map(|p| entries(&p)).filter(is_image).collect();
    images.sort();
    images
}

#[test]
fn luma_agrees_with_that_of_the_decoded_colours() {
    let Some(folder) = folder() else { return };
    for path in images(&folder).into_iter().filter(|path| path.extension().is_some_and(|e| e == "jpg")) {
        let file = std::fs::read(&path).unwrap();
        let grey = decode(&file).unwrap_or_else(|e| panic!("{}: {e}", path.display())).grey;
        let colours = image::load_from_memory(&file).unwrap().into_rgb8();
        let luma = |p: &image::Rgb<u8>| (f64::from(p[0]) * 0.299 + f64::from(p[1]) * 0.587 + f64::from(p[2]) * 0.114).round();
        let differences: Vec<f64> = colours.pixels().zip(grey.data()).map(|(p, &g)| (luma(p) - f64::from(g)).abs()).collect();
        // Colours that RGB cannot hold are clipped, so single pixels may differ by more.
        let mean = differences.iter().sum::<f64>() / differences.len() as f64;
        assert!(mean < 0.5, "{}: mean difference {mean}", path.display());
    }
}

#[test]
fn focal_lengths_agree_with_the_truth() {
    let Some(folder) = folder() else { return };
    let (mut compared, mut calibrated) = (0, 0);
    for path in images(&folder) {
        let Ok(truth) = std::fs::read_to_string(path.with_file_name("truth.json")) else {
            continue;
        };
        let truth: Value = serde_json::from_str(&truth).unwrap();
        let name = path.file_name().unwrap().to_str().unwrap();
        let Some(image) = truth["images"].as_array().and_then(|all| all.iter().find(|image| image["file"] == name)) else {
            continue;
        };
        let Some(expected_px) = image["exif"]["focal_px_from_exif"].as_f64() else {
            continue;
        };
        // The truth of a file that was rewritten without EXIF comes from its original.
        let Some(camera) = decode(&std::fs::read(&path).unwrap()).unwrap().camera else {
            assert!(name.ends_with("_deflate.tif"), "{name} has lost its camera");
            continue;
        };
        if let Some(lens) = camera.lens {
            // XMP calibrates this camera: 1.4 % from what EXIF rounds of the RGB lens, 0.6 % of that of a band.
            assert!((lens.focal_px / expected_px - 1.0).abs() < 0.02, "{name}: {} px, expected {expected_px}", lens.focal_px);
            assert_eq!(camera.origin, CameraOrigin::XmpCalibration, "{name}");
            calibrated += 1;
            continue;
        }
        assert_eq!(Some(camera.focal_mm), image["exif"]["focal_mm"].as_f64(), "{name}");
        assert_eq!(camera.make.as_deref(), image["exif"]["make"].as_str(), "{name}");
        let focal_px = camera.focal_mm / camera.pixel_mm.unwrap_or_else(|| panic!("{name}: no pixel size"));
        assert!((focal_px - expected_px).abs() < 0.01, "{name}: {focal_px} px, expected {expected_px}");
        compared += 1;
    }
    assert!(compared > 0 && calibrated > 0, "{compared} and {calibrated} files were compared");
}
