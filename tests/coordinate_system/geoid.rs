//! Heights that count from the geoid of a file.

use super::flown::{GEOID_M, UTM, control, files, flown, numbers, on_earth, run, run_of};
use proj_core::Transform;
use std::fs;
use std::path::PathBuf;
use tiepoint::{BlockEdit, BlockRun, Error, Project, RunInput, read_project, write_block_project};

/// The geoid bends where its grid has a node: no turn of the block takes that for its own, and interpolation between the nodes is exact.
const STEP_DEG: f64 = 0.0005;
const RISE_M: f64 = 4000.0;

/// Of the geoid below the middle of the scene, and on either side of it.
fn geoid_m(longitude: f64) -> f64 {
    GEOID_M + RISE_M * (longitude - bend()).abs()
}

/// The longitude at which it bends.
fn bend() -> f64 {
    let images = flown().scene.truth().images;
    let mean: f64 = images.iter().map(|image| on_earth(image.pose.unwrap().position)[0]).sum::<f64>() / images.len() as f64;
    STEP_DEG * (mean / STEP_DEG).round()
}

/// A GTX of so many columns, rising from the bend or to its edge.
fn gtx(name: &str, west: f64, columns: i32) -> PathBuf {
    let south = on_earth([0.0; 3])[1] - 0.05;
    let rows = 201_i32;
    let mut file: Vec<u8> = [south, west, STEP_DEG, STEP_DEG].iter().flat_map(|v| v.to_be_bytes()).collect();
    file.extend([rows, columns].iter().flat_map(|v| v.to_be_bytes()));
    for _ in 0..rows {
        file.extend((0..columns).flat_map(|column| (geoid_m(west + STEP_DEG * f64::from(column)) as f32).to_be_bytes()));
    }
    let path = flown().folder.join(name);
    fs::write(&path, file).unwrap();
    path
}

/// Coordinates of a point in UTM with its height above the geoid.
fn above_geoid([x, y, z]: [f64; 3]) -> [f64; 3] {
    let (longitude, _) = Transform::new(UTM, "EPSG:4258").unwrap().convert((x, y)).unwrap();
    [x, y, z + GEOID_M - geoid_m(longitude)]
}

fn of_geoid(name: &str, west: f64, columns: i32) -> Result<BlockRun, Error> {
    let geoid = Some(gtx(name, west, columns).to_string_lossy().into_owned());
    run_of(UTM, None, RunInput { control: Some(control(above_geoid)), geoid, ..RunInput::default() })
}

/// The largest difference of a check point in height, in m.
fn worst_check(run: &BlockRun) -> f64 {
    let table = &files(run)["surveyed.csv"];
    let checks: String =
        table.lines().filter(|line| line.starts_with("name,") || line.contains(",check,")).map(|line| format!("{line}\n")).collect();
    numbers(&checks, &["dz"]).iter().fold(0.0, |worst: f64, row| worst.max(row[0].abs()))
}

#[test]
fn heights_count_from_the_geoid_of_a_file() {
    let found = of_geoid("bent.gtx", bend() - 100.0 * STEP_DEG, 201).unwrap();
    let level = run(UTM, Some(GEOID_M), Some(control(above_geoid))).unwrap();
    let [found_m, level_m] = [&found, &level].map(worst_check);
    assert!(found_m < 0.5 && level_m > 3.0 * found_m, "{found_m} {level_m}");
    let summary: serde_json::Value = serde_json::from_str(&files(&found)["summary.json"]).unwrap();
    assert_eq!(summary["crs"]["geoid"], "bent.gtx");
    let remark = summary["remarks"].to_string() + &files(&found)["report.html"];
    assert!(remark.contains("bent.gtx"), "{remark}");
    // Heights of GNSS positions take part, and tables count from the geoid.
    let images = &found.reconstruction.as_ref().unwrap().models[0].adjusted.images;
    assert!(images.iter().filter_map(|image| image.gnss).all(|gnss| gnss.residual[2] != 0.0 && gnss.residual[2].abs() < 20.0));
    let truth = flown().scene.truth();
    for (image, row) in truth.images.iter().zip(numbers(&files(&found)["images.csv"], &["z"])) {
        let [longitude, _, height] = on_earth(image.pose.unwrap().position);
        assert!((row[0] - (height - geoid_m(longitude))).abs() < 0.5, "{}: {} of {height}", image.name, row[0]);
    }
    // So it does in its project, and after edits.
    let Project::Block(opened) = read_project(write_block_project(&found).unwrap().as_bytes()).unwrap() else { panic!("a block") };
    assert_eq!(*opened, found);
    let edited = opened.with_edits(&[BlockEdit::SetUse { point: 0, role: None }]).unwrap();
    assert!(worst_check(&edited) < 0.5, "{}", worst_check(&edited));
}

#[test]
fn a_geoid_that_nothing_counts_from_is_refused() {
    let refused = |crs: Option<&str>, geoid_m: Option<f64>| {
        let geoid = Some("some.gtx".to_string());
        run_of(crs, geoid_m, RunInput { geoid, ..RunInput::default() }).unwrap_err().to_string()
    };
    assert!(refused(None, None).contains("some.gtx without a coordinate system"), "{}", refused(None, None));
    assert!(refused(Some(UTM), Some(47.3)).contains("47.3 m and the file some.gtx"), "{}", refused(Some(UTM), Some(47.3)));
    // No file of this name.
    assert!(
        refused(Some(UTM), None).contains("os error 2") || refused(Some(UTM), None).contains("No such file"),
        "{}",
        refused(Some(UTM), None)
    );
    let elsewhere = of_geoid("elsewhere.gtx", bend() + 1.0, 201).unwrap_err().to_string();
    assert!(elsewhere.contains("elsewhere.gtx, which covers longitudes"), "{elsewhere}");
}
