//! The simulated pair of known orientation beside the project; skipped in a plain checkout.

use super::scene::{Dice, FOCAL_MM, NADIR, spoil, standard_errors};
use std::path::{Path, PathBuf};
use tiepoint::{CameraMm, Fiducial, FiducialModel, Interior, Observation, orient_fiducials, orient_relative};

const WIDTH: usize = 450;

fn folder() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data/simulated-a");
    if folder.is_dir() {
        return Some(folder);
    }
    println!("skipped: {} is absent", folder.display());
    None
}

fn numbers(value: &serde_json::Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
}

/// The interior orientation from the measured fiducials; these and the origins count from the centre of the first pixel.
fn interior(photo: &serde_json::Value) -> Interior {
    let pairs = photo["fiducials_scan_px_measured"].as_array().unwrap().iter().zip(photo["fiducials_mm"].as_array().unwrap());
    let marks: Vec<Fiducial> = pairs
        .map(|(px, mm)| (numbers(px), numbers(mm)))
        .map(|(px, mm)| Fiducial { col: px[0] + 0.5, row: px[1] + 0.5, x_mm: mm[0], y_mm: mm[1] })
        .collect();
    let found = orient_fiducials(&marks, FiducialModel::Affine).unwrap();
    assert!((0.01..0.1).contains(&found.sigma0_mm.unwrap()) && found.degrees_of_freedom == 10);
    let truth = &photo["affine_scan_to_mm"];
    for (row, errors) in found.standard_errors.unwrap().iter().enumerate() {
        let wanted = numbers(&truth[row]);
        for column in 0..2 {
            assert!((found.parameters[row][column] - wanted[column]).abs() < 4.0 * errors[column]);
        }
    }
    let origin = numbers(&photo["patch_origin_col_row"]);
    let camera = CameraMm::without_distortion(FOCAL_MM, None);
    Interior::from_fiducials(&camera, &found, [origin[0], origin[1]]).unwrap()
}

/// Every 50th pixel of the left image, by the dense map of where the right image shows it, with noise of `sigma_px`.
fn observations(folder: &Path, truth: &serde_json::Value, sigma_px: f64) -> Vec<Observation> {
    let (left, right) = (interior(&truth["left"]), interior(&truth["right"]));
    let map: Vec<f64> = std::fs::read(folder.join("map_row_col.f32"))
        .unwrap()
        .chunks_exact(4)
        .map(|bytes| f64::from(f32::from_le_bytes(bytes.try_into().unwrap())))
        .collect();
    let mut dice = Dice::new(5);
    let mut noise = || sigma_px * dice.normal();
    let within = |row_col: &[f64]| (0.0..700.0).contains(&row_col[0]) && (0.0..450.0).contains(&row_col[1]);
    map.chunks_exact(2)
        .enumerate()
        .step_by(53)
        .filter(|(_, row_col)| within(row_col))
        .map(|(index, row_col)| {
            let (col, row) = ((index % WIDTH) as f64 + 0.5, (index / WIDTH) as f64 + 0.5);
            Observation::new(
                left.photo_mm(col + noise(), row + noise()),
                right.photo_mm(row_col[1] + 0.5 + noise(), row_col[0] + 0.5 + noise()),
            )
        })
        .collect()
}

#[test]
fn the_known_orientation_is_found_also_among_gross_errors() {
    let Some(folder) = folder() else { return };
    let truth: serde_json::Value = serde_json::from_slice(&std::fs::read(folder.join("truth.json")).unwrap()).unwrap();
    for share in [0.0, 0.15, 0.3] {
        let mut observations = observations(&folder, &truth, 0.3);
        spoil(&mut observations, share, 6);
        let found = orient_relative(&observations, FOCAL_MM, &NADIR.options()).unwrap();
        let errors = NADIR.errors(&found);
        println!("{share}: {} observations, {errors:?}, standard errors {:?}", observations.len(), standard_errors(&found));
        // The fiducials were measured with errors of 0.12 px, which the observations do not show.
        let bounds = [0.03, 0.03, 0.03, 0.05, 0.08];
        assert!(errors.iter().zip(bounds).all(|(e, bound)| e.abs() <= bound), "{share}: {errors:?}");
        let sigma0_px = found.sigma0_mm.unwrap() / 0.254;
        assert!((0.27..0.33).contains(&sigma0_px), "{share}: σ0 {sigma0_px} px");
    }
}
