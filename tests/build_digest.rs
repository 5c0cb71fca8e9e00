//! Records of another build are never mixed in: their keys hold a digest of the sources.

use std::fs;
use std::path::{Path, PathBuf};

#[path = "../build.rs"]
#[allow(dead_code)]
mod build;

/// A tree of sources with this text of a detector.
fn sources(name: &str, detector: &str) -> PathBuf {
    let root = std::env::temp_dir().join(format!("tiepoint-build-{}-{name}", std::process::id()));
    fs::create_dir_all(root.join("src/points")).unwrap();
    fs::write(root.join("src/lib.rs"), "mod points;").unwrap();
    fs::write(root.join("src/points/mod.rs"), detector).unwrap();
    fs::write(root.join("Cargo.lock"), "version = 4").unwrap();
    root
}

#[test]
fn builds_that_differ_in_the_detector_alone_have_different_digests() {
    let trees = [("one", "const LEAST: f64 = 1.0;"), ("two", "const LEAST: f64 = 2.0;"), ("three", "const LEAST: f64 = 1.0;")]
        .map(|(name, detector)| sources(name, detector));
    let [one, other, again] = [0, 1, 2].map(|k| build::digest_of(&trees[k]).unwrap());
    assert_ne!(one, other);
    // Where the sources lie does not matter.
    assert_eq!(one, again);
    fs::write(trees[0].join("Cargo.lock"), "version = 5").unwrap();
    assert_ne!(build::digest_of(&trees[0]).unwrap(), one);
    trees.iter().for_each(|tree| fs::remove_dir_all(tree).unwrap());
}

#[test]
fn the_tracked_module_is_built_from_these_sources() {
    // While one works on the crate the module is older: only `npm test` asks for it.
    let Some(module) = std::env::var_os("TIEPOINT_MODULE") else {
        return println!("skipped: sources of the tracked module (TIEPOINT_MODULE names none)");
    };
    let digest = build::digest_of(Path::new(env!("CARGO_MANIFEST_DIR"))).unwrap();
    let bytes = fs::read(module).unwrap();
    assert!(bytes.windows(digest.len()).any(|window| window == digest.as_bytes()), "npm run build makes it anew");
}
