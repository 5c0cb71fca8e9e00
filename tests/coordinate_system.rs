//! Blocks with GNSS positions on WGS 84 and control points in a coordinate reference system, beside their truth.

use crate::shown::shown;
use proj_core::Transform;
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::sync::{Mutex, OnceLock, PoisonError};
use tiepoint::{
    BlockFlight, BlockRun, BlockScene, BlockSettings, ControlRole, ControlTexts, Datum, Error, MultiscaleOptions, NotLinked, OnOrthophoto,
    RunInput, block_files, geographic_from_local, run_block,
};

/// West of the central meridian of its zone.
const UTM: &str = "EPSG:25832";
/// Of the ellipsoid below the zero of the heights of control points.
const GEOID_M: f64 = 47.3;

struct Flown {
    scene: BlockScene,
    photos: Vec<PathBuf>,
    folder: PathBuf,
}

/// A scene with its photos on disk, which record GNSS positions.
fn flown() -> &'static Flown {
    static FLOWN: OnceLock<Flown> = OnceLock::new();
    FLOWN.get_or_init(|| {
        let flight = BlockFlight {
            strips: 2,
            exposures: 4,
            width_px: 480,
            height_px: 360,
            pixel_mm: 0.075,
            relief_m: 40.0,
            seed: 5,
            ..BlockFlight::default()
        };
        let scene = BlockScene::new(&flight).unwrap();
        let folder = std::env::temp_dir().join(format!("tiepoint-coordinate-system-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let photo = |index: usize| {
            let path = folder.join(format!("photo_{index:05}.png"));
            fs::write(&path, scene.photo_file(index).unwrap()).unwrap();
            path
        };
        let photos = (0..scene.photos()).map(photo).collect();
        Flown { scene, photos, folder }
    })
}

/// A place of the scene in UTM, with its height above the geoid.
fn in_utm(place: [f64; 3]) -> [f64; 3] {
    let origin = flown().scene.truth().origin.unwrap();
    let [longitude, latitude, height] = geographic_from_local(place, [origin.longitude_deg, origin.latitude_deg, origin.height_m]);
    let (x, y) = Transform::new("EPSG:4258", UTM).unwrap().convert((longitude, latitude)).unwrap();
    [x, y, height - GEOID_M]
}

/// Points of the ground, every third of them a check point, as `write` writes their coordinates.
fn control(write: impl Fn([f64; 3]) -> [f64; 3]) -> ControlTexts {
    let places = shown(&flown().scene, &[0, 1, 2, 3, 5, 6], &[[150.0, 120.0], [330.0, 240.0], [240.0, 60.0]]);
    assert!(places.len() >= 9, "{}", places.len());
    let (mut points, mut marks) = ("name,x,y,z,sigma_xy,sigma_z,sigma_px,use\n".to_string(), "image,point,x,y\n".to_string());
    for (number, (place, images)) in (1..).zip(&places) {
        let [x, y, z] = write(in_utm(*place));
        points += &format!("G{number},{x},{y},{z},0.02,0.03,0.1,{}\n", if number % 3 == 0 { "check" } else { "control" });
        marks += &images.iter().map(|(image, [x, y])| format!("photo_{image:05}.png,G{number},{x},{y}\n")).collect::<String>();
    }
    ControlTexts { points, marks }
}

static FOLDER: Mutex<()> = Mutex::new(());

fn run(crs: &str, geoid_m: Option<f64>, control: Option<ControlTexts>) -> Result<BlockRun, Error> {
    let Flown { photos, folder, scene } = flown();
    // Over ground that is nearly flat a focal length that is estimated takes the height with it.
    let focal_px = scene.truth().cameras[0].focal_px;
    let cameras = Some(format!(r#"{{"cameras": [{{"focal_px": {focal_px}, "fixed": true}}]}}"#));
    let mut settings = BlockSettings::default();
    settings.features.multiscale = MultiscaleOptions { number: 2500, ..settings.features.multiscale };
    (settings.placing.crs, settings.placing.geoid_m) = (Some(crs.into()), geoid_m);
    // One run at a time has the folder.
    let _folder = FOLDER.lock().unwrap_or_else(PoisonError::into_inner);
    run_block(photos, &[], RunInput { settings, cameras, control, ..RunInput::default() }, &folder.join("work"), 2, drop)
}

/// The block with control points in UTM.
fn both() -> &'static BlockRun {
    static BOTH: OnceLock<BlockRun> = OnceLock::new();
    BOTH.get_or_init(|| run(UTM, None, Some(control(|place| place))).unwrap())
}

fn files(run: &BlockRun) -> BTreeMap<String, String> {
    let mut files = BTreeMap::new();
    block_files(run, &[], None, &mut |path, text| {
        files.insert(path.to_string(), text.to_string());
        Ok(())
    })
    .unwrap();
    files
}

/// The numbers in these columns of a table, row by row.
fn numbers(table: &str, columns: &[&str]) -> Vec<Vec<f64>> {
    let mut lines = table.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let places: Vec<usize> = columns.iter().map(|column| names.iter().position(|name| name == column).unwrap()).collect();
    lines
        .map(|line| line.split(',').collect::<Vec<_>>())
        .map(|cells| places.iter().map(|at| cells[*at].parse().unwrap()).collect())
        .collect()
}

#[test]
fn gnss_positions_and_control_points_of_a_map_georeference_one_block() {
    let run = both();
    let model = &run.reconstruction.as_ref().unwrap().models[0];
    assert!(model.in_system && model.adjusted.datum == Datum::GnssAndControl, "{:?}", model.adjusted.datum);
    let accepted = model.adjusted.images.iter().filter(|image| image.gnss.is_some_and(|gnss| gnss.accepted)).count();
    assert!(accepted >= 7, "{accepted} GNSS positions took part");
    let checks: Vec<_> = model.surveyed.iter().filter(|point| point.role == ControlRole::Check).collect();
    assert!(checks.len() >= 3, "{}", checks.len());
    for point in &checks {
        println!("{} {:.3?} {:.3?}", point.name, point.difference_m, point.standard_errors_m);
        for k in 0..3 {
            assert!(
                point.difference_m[k].abs() < (4.0 * point.standard_errors_m[k].unwrap()).max(0.05),
                "{} {:?}",
                point.name,
                point.difference_m
            );
        }
    }
}

#[test]
fn tables_are_in_the_system_of_the_control_points() {
    let (run, truth) = (both(), flown().scene.truth());
    let files = files(run);
    let images = numbers(&files["images.csv"], &["x", "y", "z", "sigma_x", "sigma_y", "sigma_z", "kappa_deg"]);
    for (row, image) in images.iter().zip(&truth.images) {
        let pose = image.pose.unwrap();
        let known = in_utm(pose.position);
        for k in 0..3 {
            assert!((row[k] - known[k]).abs() < (4.0 * row[3 + k]).max(0.1), "{}: {row:?} {known:?}", image.name);
        }
        // Grid north is the convergence away from the meridian, by which the truth counts: tan γ is nearly tan Δλ sin φ.
        let convergence_deg = libm::atan(libm::tan((-1f64).to_radians()) * libm::sin(50f64.to_radians())).to_degrees();
        let apart = (row[6] - pose.angles()[2].to_degrees() - convergence_deg).rem_euclid(360.0);
        assert!(apart.min(360.0 - apart) < 0.1, "{}: κ is off by {apart}", image.name);
    }
    // As they were given, to 0.1 mm.
    let given = control(|place| place).points;
    let surveyed = numbers(&files["surveyed.csv"], &["x", "y", "z", "dx", "dy", "dz"]);
    let wanted = numbers(&given, &["x", "y", "z"]);
    assert_eq!(surveyed.len(), wanted.len());
    for row in &surveyed {
        assert!(wanted.iter().any(|point| (0..3).all(|k| (point[k] - row[k]).abs() < 2e-4)), "{row:?}");
        assert!((3..6).all(|k| row[k].abs() < 0.5), "{row:?}");
    }
    let points = numbers(&files["points.csv"], &["x", "y"]);
    assert!(
        points.iter().all(|at| (428_000.0..429_500.0).contains(&at[0]) && (5_538_000.0..5_540_500.0).contains(&at[1])),
        "{:?}",
        points[0]
    );
    for file in ["summary.json", "orientation.json", "report.html"] {
        assert!(files[file].contains("ETRS89 / UTM zone 32N"), "{file}");
    }
}

#[test]
fn heights_of_another_zero_are_told_apart_and_joined_by_the_geoid() {
    let above = |run: &BlockRun| {
        let summary: serde_json::Value = serde_json::from_str(&files(run)["summary.json"]).unwrap();
        summary["crs"]["gnss_above_m"].as_f64()
    };
    let found = above(both()).unwrap();
    // The median of eight heights of some metres each.
    assert!((found - GEOID_M).abs() < 5.0, "{found}");
    let with_geoid = run(UTM, Some(GEOID_M), Some(control(|place| place))).unwrap();
    assert_eq!(above(&with_geoid), None);
    let residuals = |run: &BlockRun| {
        let images = &run.reconstruction.as_ref().unwrap().models[0].adjusted.images;
        images.iter().filter_map(|image| image.gnss.map(|gnss| gnss.residual[2])).collect::<Vec<_>>()
    };
    assert!(residuals(both()).iter().all(|residual| *residual == 0.0));
    assert!(residuals(&with_geoid).iter().all(|residual| *residual != 0.0 && residual.abs() < 20.0), "{:?}", residuals(&with_geoid));
    // Tables have heights above the same zero.
    let heights = |run: &BlockRun| numbers(&files(run)["images.csv"], &["z"])[0][0];
    assert!((heights(&with_geoid) - heights(both())).abs() < 0.5);
}

#[test]
fn control_points_in_degrees_are_the_same_points() {
    let back = Transform::new(UTM, "EPSG:4258").unwrap();
    let run = run(
        "EPSG:4258",
        None,
        Some(control(|[x, y, z]| {
            let (longitude, latitude) = back.convert((x, y)).unwrap();
            [longitude, latitude, z]
        })),
    )
    .unwrap();
    let own = |run: &BlockRun| run.model.images.iter().map(|image| image.pose.unwrap().position).collect::<Vec<_>>();
    for (a, b) in own(&run).iter().zip(own(both())) {
        assert!((0..3).all(|k| (a[k] - b[k]).abs() < 2e-3), "{a:?} {b:?}");
    }
    let [longitude, latitude] = numbers(&files(&run)["images.csv"], &["x", "y"])[0][..] else { panic!("two columns") };
    assert!((longitude - 8.0).abs() < 0.02 && (latitude - 50.0).abs() < 0.02, "{longitude} {latitude}");
}

#[test]
fn results_without_control_points_are_in_the_system_too() {
    let run = run(UTM, None, None).unwrap();
    let known = in_utm(flown().scene.truth().images[0].pose.unwrap().position);
    let row = &numbers(&files(&run)["images.csv"], &["x", "y", "z"])[0];
    // Heights are those of GNSS, above the ellipsoid.
    assert!(
        (row[0] - known[0]).abs() < 15.0 && (row[1] - known[1]).abs() < 15.0 && (row[2] - known[2] - GEOID_M).abs() < 30.0,
        "{row:?} {known:?}"
    );
}

#[test]
fn control_points_that_cannot_be_in_the_system_are_refused_with_figures() {
    let told = |crs: &str, write: fn([f64; 3]) -> [f64; 3]| run(crs, None, Some(control(write))).unwrap_err().to_string();
    let wrong_zone = told("EPSG:25833", |place| place);
    assert!(wrong_zone.contains("km from the GNSS positions") && wrong_zone.contains("Is the zone right"), "{wrong_zone}");
    let exchanged = told(UTM, |[x, y, z]| [y, x, z]);
    assert!(
        exchanged.contains("exchanged") || exchanged.contains("outside") || exchanged.contains("order of the coordinates"),
        "{exchanged}"
    );
    let degrees = told(UTM, |_| [8.0, 50.0, 100.0]);
    assert!(degrees.contains("look like degrees") && degrees.contains("G1"), "{degrees}");
    let metres = told("EPSG:4326", |place| place);
    assert!(metres.contains("longitude as x"), "{metres}");
    let lambert = told("EPSG:2154", |place| place);
    assert!(lambert.contains("RGF93") || lambert.contains("EPSG:2154"), "{lambert}");
}

#[test]
fn a_block_of_a_system_is_not_taken_into_that_of_an_orthophoto() {
    let scene = &flown().scene;
    let linked =
        tiepoint::BlockLinks::default().linked(both(), &scene.orthophoto(0.8).unwrap(), &tiepoint::PlacingOptions::default()).unwrap();
    // No image was placed, which is said first; a block of a system stays in it in any case.
    assert!(matches!(
        linked.orthophoto,
        Some(OnOrthophoto::NotLinked { not_linked: NotLinked::OwnSystem { .. } | NotLinked::FewImages { .. } })
    ));
    assert_eq!(linked.model, both().model);
}
