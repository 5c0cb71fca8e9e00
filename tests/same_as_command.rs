//! A native program runs a block by the crate alone: it writes what the command writes, and takes up what the command has kept.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;

#[path = "../examples/run_block.rs"]
#[allow(dead_code)]
mod run_block;

/// Small photos that are soon rendered: two strips of three.
const SMALL: [&str; 10] = ["--strips", "2", "--exposures", "3", "--width-px", "480", "--height-px", "360", "--pixel-mm", "0.12"];

/// Calls the command under the Node that runs the tests.
fn command(arguments: &[&str]) {
    let program = Path::new(env!("CARGO_MANIFEST_DIR")).join("pkg/bin/tiepoint.js");
    let ended = Command::new(std::env::var_os("NODE").unwrap_or("node".into()))
        .arg(program)
        .args(arguments)
        .args(["--workers", "2"])
        .output()
        .unwrap();
    assert!([0, 3, 4].map(Some).contains(&ended.status.code()), "{}", String::from_utf8_lossy(&ended.stderr));
}

/// The files below a folder by their paths in it.
fn files(at: &Path) -> BTreeMap<PathBuf, PathBuf> {
    let mut files = BTreeMap::new();
    let mut folders = vec![at.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else {
                files.insert(path.strip_prefix(at).unwrap().to_path_buf(), path);
            }
        }
    }
    files
}

/// What is kept of each job of a run, and when it was written.
fn records(out: &Path) -> BTreeMap<PathBuf, SystemTime> {
    let kept = files(&out.join("work")).into_iter().filter(|(name, _)| name.extension().is_some_and(|end| end == "record"));
    kept.map(|(name, path)| (name, fs::metadata(path).unwrap().modified().unwrap())).collect()
}

#[test]
fn a_native_program_writes_the_same_bytes_as_the_command_and_takes_up_what_it_has_kept() {
    // While one works on the crate the command's module is older: only `npm test` asks for it.
    if std::env::var_os("TIEPOINT_MODULE").is_none() {
        return println!("skipped: the command beside a native program (TIEPOINT_MODULE names no module of these sources)");
    }
    let folder = std::env::temp_dir().join(format!("tiepoint-same-as-command-{}", std::process::id()));
    let [simulated, of_command, own] = ["simulated", "of-command", "own"].map(|name| folder.join(name));
    command(&[["simulate", "--block", "--out", simulated.to_str().unwrap()].as_slice(), &SMALL].concat());
    let photos = files(&simulated).values().find(|path| path.ends_with("photo_00000.png")).unwrap().parent().unwrap().to_path_buf();
    command(&["block", photos.to_str().unwrap(), "--out", of_command.to_str().unwrap()]);
    run_block::run(&photos, &own).unwrap();

    let written = files(&of_command);
    let same = |name: &Path| assert!(fs::read(own.join(name)).unwrap() == fs::read(&written[name]).unwrap(), "{} differs", name.display());
    same(Path::new("project.tiepoint"));
    let results = files(&own).into_keys().filter(|name| !name.starts_with("work"));
    assert!(results.inspect(|name| same(name)).count() > 1);

    // Keys and records are the same: built of the same sources, what one host has kept is done for the other.
    let kept = records(&of_command);
    assert_eq!(kept.keys().collect::<Vec<_>>(), records(&own).keys().collect::<Vec<_>>());
    let of = |part: &str| kept.keys().filter(|name| name.starts_with(part)).count();
    assert_eq!((of("features"), of("pairs")), (6, 15));
    run_block::run(&photos, &of_command).unwrap();
    assert_eq!(records(&of_command), kept);
    fs::remove_dir_all(folder).unwrap();
}
