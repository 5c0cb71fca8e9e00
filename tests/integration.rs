//! The crate as its users see it. Its tests stand in the program of the unit tests (`src/lib.rs`): another one would need the crate compiled
//! without these, too, which takes as long. Lints compile them as a program of their own, which sees what the crate exports and nothing else; so
//! they name their helpers by `super`.
//!
//! What one file tests is run alone by its name: `cargo test --lib integration::adjustment::`.
// Files that run as wasm, too, bring their helpers with them (`src/wasm/everywhere.rs`).
#![allow(clippy::duplicate_mod)]

mod known;
mod read;
mod sampling;
mod scene;

#[path = "scene/flown.rs"]
mod flown;
#[path = "scene/normal.rs"]
mod normal;
#[path = "scene/shown.rs"]
mod shown;
#[path = "scene/stated.rs"]
mod stated;
#[path = "scene/surveyed.rs"]
mod surveyed;

#[path = "adjustment.rs"]
mod adjustment;
#[path = "adjustment_everywhere.rs"]
mod adjustment_everywhere;
#[path = "block_report.rs"]
mod block_report;
#[path = "build_digest.rs"]
mod build_digest;
#[path = "catalogue.rs"]
mod catalogue;
#[path = "check_points.rs"]
mod check_points;
#[path = "common_offsets.rs"]
mod common_offsets;
#[path = "confidence.rs"]
mod confidence;
#[path = "control_errors.rs"]
mod control_errors;
#[path = "control_measurements.rs"]
mod control_measurements;
#[path = "coordinate_system.rs"]
mod coordinate_system;
#[path = "decode.rs"]
mod decode;
#[path = "decode_everywhere.rs"]
mod decode_everywhere;
#[path = "file_cameras.rs"]
mod file_cameras;
#[path = "geometry.rs"]
mod geometry;
#[path = "gnss_errors.rs"]
mod gnss_errors;
#[path = "gradient_pair.rs"]
mod gradient_pair;
#[path = "layers.rs"]
mod layers;
#[path = "long_histories.rs"]
mod long_histories;
#[path = "on_orthophoto.rs"]
mod on_orthophoto;
#[path = "orientation.rs"]
mod orientation;
#[path = "outputs.rs"]
mod outputs;
#[path = "pair_project.rs"]
mod pair_project;
#[path = "photographs.rs"]
mod photographs;
#[path = "pipeline.rs"]
mod pipeline;
#[path = "reconstruction.rs"]
mod reconstruction;
#[path = "reconstruction_faults.rs"]
mod reconstruction_faults;
#[path = "repeated.rs"]
mod repeated;
#[path = "report.rs"]
mod report;
#[path = "same_as_command.rs"]
mod same_as_command;
#[path = "sample.rs"]
mod sample;
#[path = "scaled_pair.rs"]
mod scaled_pair;
#[path = "simulate.rs"]
mod simulate;
#[path = "tracks.rs"]
mod tracks;
#[path = "variance_components.rs"]
mod variance_components;
#[path = "verdict.rs"]
mod verdict;
#[path = "words.rs"]
mod words;

#[test]
fn no_file_of_tests_stands_outside() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    let own = include_str!("integration.rs");
    let files = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let outside: Vec<String> = files
        .filter(|name| name.ends_with(".rs") && !["integration.rs", "decode_memory.rs"].contains(&name.as_str()))
        .filter(|name| !own.contains(&format!("#[path = \"{name}\"]")))
        .collect();
    assert!(outside.is_empty(), "no program runs {outside:?}");
}
