//! Blocks with GNSS positions on WGS 84, and control points and orthophotos in a coordinate reference system, beside their truth.

use crate::shown::shown;
use proj_core::Transform;
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::sync::{Mutex, OnceLock, PoisonError};
use tiepoint::{
    Axis, BlockEdit, BlockFlight, BlockLinks, BlockRun, BlockScene, BlockSettings, BlockVerdict, BlockWarning, CameraUncertainty,
    ControlRole, ControlTexts, Datum, DecodeLimits, Error, ExifImage, ExifPosition, Failure, Georeference, GreyImage, HeightModel, Heights,
    Mistake, Mosaic, MultiscaleOptions, NotLinked, OnOrthophoto, Orthophoto, OverviewWarning, PlaceSearch, PlacingCamera, PlacingOptions,
    PointSource, Rectified, Remark, RunInput, SearchArea, accuracy_map, block_files, decode, geographic_from_local, place_recorded,
    run_block, write_geotiff, write_heights,
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

/// A place of the scene as longitude, latitude and height above the ellipsoid.
fn on_earth(place: [f64; 3]) -> [f64; 3] {
    let origin = flown().scene.truth().origin.unwrap();
    geographic_from_local(place, [origin.longitude_deg, origin.latitude_deg, origin.height_m])
}

/// A place of the scene in UTM, with its height above the geoid.
fn in_utm(place: [f64; 3]) -> [f64; 3] {
    in_zone(UTM, place)
}

fn in_zone(utm: &str, place: [f64; 3]) -> [f64; 3] {
    let [longitude, latitude, height] = on_earth(place);
    let (x, y) = Transform::new("EPSG:4258", utm).unwrap().convert((longitude, latitude)).unwrap();
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

fn run<'a>(crs: impl Into<Option<&'a str>>, geoid_m: Option<f64>, control: Option<ControlTexts>) -> Result<BlockRun, Error> {
    let Flown { photos, folder, scene } = flown();
    // Over ground that is nearly flat a focal length that is estimated takes the height with it.
    let focal_px = scene.truth().cameras[0].focal_px;
    let cameras = Some(format!(r#"{{"cameras": [{{"focal_px": {focal_px}, "fixed": true}}]}}"#));
    let mut settings = BlockSettings::default();
    settings.features.multiscale = MultiscaleOptions { number: 2500, ..settings.features.multiscale };
    (settings.placing.crs, settings.placing.geoid_m) = (crs.into().map(String::from), geoid_m);
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
    assert!(wrong_zone.contains("km from the GNSS positions") && wrong_zone.contains("In zone 32 it lies near them"), "{wrong_zone}");
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
fn a_mistyped_control_point_is_explained_by_the_numbers_that_were_written() {
    let mut texts = control(|place| place);
    let row = texts.points.lines().find(|line| line.starts_with("G4,")).unwrap().to_string();
    let written = row.split(',').nth(1).unwrap();
    let right: f64 = written.parse().unwrap();
    let step = if (right / 10.0).floor() % 10.0 < 5.0 { 30.0 } else { -30.0 };
    texts.points = texts.points.replace(&format!("G4,{written},"), &format!("G4,{},", right + step));
    let run = run(UTM, None, Some(texts)).unwrap();
    let model = &run.reconstruction.as_ref().unwrap().models[0];
    let told: Vec<&BlockWarning> = model.warnings.iter().filter(|w| matches!(w, BlockWarning::ControlRefused { .. })).collect();
    let [BlockWarning::ControlRefused { point, axis: Axis::X, difference_m, used: false, mistake: Some(mistake), .. }] = told[..] else {
        panic!("{:?}", model.warnings)
    };
    let Mistake::Digit { axis: Axis::X, likely, .. } = mistake else { panic!("{mistake:?}") };
    assert!(point == "G4" && (difference_m + step).abs() < 1.0 && (likely.parse::<f64>().unwrap() - right).abs() < 1e-3, "{told:?}");
    let BlockVerdict::Weak { overview_warning: OverviewWarning::Model { block_warning }, .. } = BlockVerdict::of(&run) else {
        panic!("{}", BlockVerdict::of(&run))
    };
    assert_eq!(&block_warning, told[0]);
    let files = files(&run);
    let state = |name: &str| files["surveyed.csv"].lines().find(|line| line.starts_with(name)).unwrap().rsplit(',').next().unwrap();
    assert_eq!([state("G4,"), state("G1,"), state("G3,")], ["refused", "used", "check"]);
    assert!(files["summary.json"].contains("control_refused") && files["report.html"].contains("<td>refused</td>"));
}

/// The block without control points, in UTM by its GNSS positions.
fn by_gnss() -> &'static BlockRun {
    static BY_GNSS: OnceLock<BlockRun> = OnceLock::new();
    BY_GNSS.get_or_init(|| run(UTM, None, None).unwrap())
}

/// The orthophoto of the scene in a zone of UTM, in a unit of so many m, with heights above the geoid in m.
fn orthophoto(utm: &str, unit_m: f64) -> Orthophoto {
    const GSD: f64 = 0.8;
    /// Over which the projection is taken as linear, in m.
    const STEP: f64 = 300.0;
    let made = flown().scene.orthophoto(GSD).unwrap();
    let [width, height] = made.size();
    let middle = made.georeference.ground([0.5 * width as f64, 0.5 * height as f64]);
    let at = |x: f64, y: f64| in_zone(utm, [middle[0] + x, middle[1] + y, 0.0]);
    let slope = |ahead: [f64; 3], behind: [f64; 3]| [0, 1].map(|k| (ahead[k] - behind[k]) / (2.0 * STEP));
    let (east, north) = (slope(at(STEP, 0.0), at(-STEP, 0.0)), slope(at(0.0, STEP), at(0.0, -STEP)));
    let along = |[x, y]: [f64; 2]| [0, 1].map(|k| (x * east[k] + y * north[k]) / unit_m);
    let Georeference { origin, by_column, by_row } = made.georeference;
    let from_middle = along([origin[0] - middle[0], origin[1] - middle[1]]);
    let origin = [0, 1].map(|k| at(0.0, 0.0)[k] / unit_m + from_middle[k]);
    let georeference = Georeference { origin, by_column: along(by_column), by_row: along(by_row) };
    let above_geoid = |pixel: usize| {
        let [x, y] = made.georeference.ground([(pixel % width) as f64 + 0.5, (pixel / width) as f64 + 0.5]);
        made.heights.at([x, y]).map_or(f32::NAN, |z| (on_earth([x, y, z])[2] - GEOID_M) as f32)
    };
    let heights = HeightModel::new(width, height, (0..width * height).map(above_geoid).collect(), georeference).unwrap();
    Orthophoto::new(made.grey().unwrap(), georeference, Heights::Model(heights)).unwrap()
}

fn with_code(orthophoto: &Orthophoto, epsg: u16) -> Orthophoto {
    let mut orthophoto = orthophoto.clone();
    orthophoto.epsg = Some(epsg);
    orthophoto
}

fn placing() -> PlacingOptions {
    PlacingOptions { points: 3000, ..PlacingOptions::default() }
}

fn placed(block: &BlockRun, reference: &Orthophoto) -> BlockLinks {
    let area = SearchArea::new(reference, &placing()).unwrap();
    let mut links = BlockLinks::default();
    for (index, path) in flown().photos.iter().enumerate() {
        let grey = decode(&fs::read(path).unwrap(), &DecodeLimits::default()).unwrap().grey;
        links.place(block, index, grey.view(), reference, &area, &placing()).unwrap();
    }
    links
}

fn linked(block: &BlockRun, reference: &Orthophoto) -> BlockRun {
    all_linked(&placed(block, reference), block, reference)
}

fn all_linked(links: &BlockLinks, block: &BlockRun, reference: &Orthophoto) -> BlockRun {
    let found = links.linked(block, reference, &placing()).unwrap();
    assert!(matches!(found.orthophoto, Some(OnOrthophoto::Linked { linked: 8, .. })), "{:?}", found.orthophoto);
    found
}

fn not_linked(run: &BlockRun) -> &NotLinked {
    match &run.orthophoto {
        Some(OnOrthophoto::NotLinked { not_linked }) => not_linked,
        other => panic!("{other:?}"),
    }
}

/// X, Y and Z of the projection centres.
fn centres(run: &BlockRun) -> Vec<[f64; 3]> {
    numbers(&files(run)["images.csv"], &["x", "y", "z"]).into_iter().map(|row| [row[0], row[1], row[2]]).collect()
}

/// The largest differences of projection centres along each axis.
fn largest(own: &[[f64; 3]], others: &[[f64; 3]]) -> [f64; 3] {
    [0, 1, 2].map(|k| own.iter().zip(others).map(|(a, b)| (a[k] - b[k]).abs()).fold(0.0, f64::max))
}

fn of_truth() -> Vec<[f64; 3]> {
    flown().scene.truth().images.iter().map(|image| in_utm(image.pose.unwrap().position)).collect()
}

/// An orthophoto in the system of the block.
fn in_system() -> &'static Orthophoto {
    static MADE: OnceLock<Orthophoto> = OnceLock::new();
    MADE.get_or_init(|| with_code(&orthophoto(UTM, 1.0), 25832))
}

/// The photos on that orthophoto: where they lie follows from cameras and photos, whatever else is known of the block.
fn links() -> &'static BlockLinks {
    static LINKS: OnceLock<BlockLinks> = OnceLock::new();
    LINKS.get_or_init(|| placed(by_gnss(), in_system()))
}

/// The block on an orthophoto in its system, beside its GNSS positions.
fn on_orthophoto() -> &'static BlockRun {
    static LINKED: OnceLock<BlockRun> = OnceLock::new();
    LINKED.get_or_init(|| all_linked(links(), by_gnss(), in_system()))
}

#[test]
fn an_orthophoto_places_a_block_in_its_system_beside_gnss_positions() {
    let found = on_orthophoto();
    let model = &found.reconstruction.as_ref().unwrap().models[0];
    assert!(model.in_system && model.adjusted.datum == Datum::GnssAndControl, "{:?}", model.adjusted.datum);
    assert!(found.model.origin.is_some() && files(found)["summary.json"].contains("ETRS89 / UTM zone 32N"));
    let accepted = model.adjusted.images.iter().filter(|image| image.gnss.is_some_and(|gnss| gnss.accepted)).count();
    assert!(accepted >= 7, "{accepted} GNSS positions took part");
    let apart = largest(&centres(found), &of_truth());
    println!("{} {apart:.3?}", found.orthophoto.as_ref().unwrap());
    assert!(apart.iter().all(|off| *off < 1.6), "{apart:?} m, two px of the orthophoto, from 785 m above it");
    // GNSS positions alone are metres off, and their heights those of another zero.
    let before = largest(&centres(by_gnss()), &of_truth());
    assert!((before[2] - GEOID_M).abs() < 30.0 && before[2] > 10.0 * apart[2], "{before:?}");
    assert!(!found.remarks.iter().any(|remark| matches!(remark, Remark::OrthophotoSystemAssumed { .. } | Remark::OrthophotoUnits { .. })));
    let checks: Vec<_> = model.surveyed.iter().filter(|point| point.role == ControlRole::Check).collect();
    assert!(checks.len() >= 8, "{}", checks.len());
    // Edits keep the system.
    let edited = found.with_edits(&[BlockEdit::RejectPoints { points: vec![PointSource::GroundControl(0)] }]).unwrap();
    let apart = largest(&centres(&edited), &centres(found));
    assert!(edited.model != found.model && apart.iter().all(|off| *off < 0.2), "{apart:?}");
}

#[test]
fn without_a_system_the_map_is_taken_as_level_and_differs_by_its_scale() {
    let plain = linked(&run(None, None, None).unwrap(), &orthophoto(UTM, 1.0));
    assert!(plain.model.origin.is_none());
    let [map, with_system] = [centres(&plain), centres(on_orthophoto())];
    // The length of 1 m of the ground in the map.
    let [from, to] = [-500.0, 500.0].map(|x| in_utm([x, 0.0, 0.0]));
    let scale = 1e-3 * (to[0] - from[0]).hypot(to[1] - from[1]);
    assert!((scale - 0.99966).abs() < 3e-5, "{scale}");
    for (map, own) in map.iter().zip(&with_system) {
        let above_ground = own[2] - in_utm([0.0; 3])[2];
        let by_scale = (scale - 1.0) * above_ground;
        assert!((map[0] - own[0]).hypot(map[1] - own[1]) < 0.15, "{map:?} {own:?}");
        assert!(by_scale < -0.2 && (map[2] - own[2] - by_scale).abs() < 0.1, "{} m, of which {by_scale} by the scale", map[2] - own[2]);
    }
}

#[test]
fn an_orthophoto_of_another_zone_is_converted_and_one_without_a_system_is_taken_to_be_in_that_of_the_block() {
    let other = linked(by_gnss(), &with_code(&orthophoto("EPSG:25833", 1.0), 25833));
    let apart = largest(&centres(&other), &centres(on_orthophoto()));
    assert!(apart.iter().all(|off| *off < 0.8), "{apart:?} m, a px of the orthophoto, which zone 33 stretches there by a 400th");
    let is_said = |remark: &Remark| {
        matches!(remark, Remark::OrthophotoConverted { orthophoto, crs, accuracy_m: None }
        if orthophoto.contains("zone 33N") && crs.contains("zone 32N"))
    };
    assert!(other.remarks.iter().any(is_said), "{:?}", other.remarks);
    // In feet, which only the system of the block says; heights stay metres.
    const FEET: &str = "+proj=utm +zone=32 +ellps=GRS80 +towgs84=0,0,0 +units=us-ft";
    const FOOT_M: f64 = 1200.0 / 3937.0;
    let in_feet = linked(&run(FEET, None, None).unwrap(), &orthophoto(UTM, FOOT_M));
    let metres: Vec<[f64; 3]> = centres(&in_feet).into_iter().map(|[x, y, z]| [x * FOOT_M, y * FOOT_M, z]).collect();
    let apart = largest(&metres, &centres(on_orthophoto()));
    assert!(apart.iter().all(|off| *off < 0.1), "{apart:?}");
    let [assumed, units] = [
        |remark: &Remark| matches!(remark, Remark::OrthophotoSystemAssumed { .. }),
        |remark: &Remark| matches!(remark, Remark::OrthophotoUnits { unit_m, height_unit_m: 1.0 } if (unit_m - FOOT_M).abs() < 1e-12),
    ];
    assert!(in_feet.remarks.iter().any(assumed) && in_feet.remarks.iter().any(units), "{:?}", in_feet.remarks);
}

#[test]
fn control_points_take_part_beside_an_orthophoto_in_one_system_or_contradict_it() {
    let found = all_linked(links(), both(), in_system());
    let model = &found.reconstruction.as_ref().unwrap().models[0];
    let control = |begins: &str| model.surveyed.iter().filter(|point| point.name.starts_with(begins)).count();
    assert!(control("G") >= 9 && control("orthophoto_") >= 40, "{} {}", control("G"), control("orthophoto_"));
    let apart = largest(&centres(&found), &of_truth());
    assert!(apart.iter().all(|off| *off < 1.6), "{apart:?}");
    let low = run(UTM, None, Some(control_raised(5.0))).unwrap();
    let contradicted = links().linked(&low, in_system(), &placing()).unwrap();
    let NotLinked::Contradiction { x_m, y_m, z_m } = not_linked(&contradicted) else { panic!("{}", not_linked(&contradicted)) };
    assert!(x_m.abs() < 0.5 && y_m.abs() < 0.5 && (z_m + 5.0).abs() < 0.5, "{x_m} {y_m} {z_m}");
    assert_eq!(contradicted.model, low.model);
}

fn control_raised(by_m: f64) -> ControlTexts {
    control(|[x, y, z]| [x, y, z + by_m])
}

#[test]
fn an_orthophoto_that_cannot_be_in_the_system_is_refused_with_both_systems() {
    let refused = |epsg: u16| links().linked(by_gnss(), &with_code(in_system(), epsg), &placing()).unwrap();
    // New Zealand; a code that is none.
    for (epsg, code) in [(2193, "crs-area"), (9999, "unknown-crs")] {
        let found = refused(epsg);
        let NotLinked::OtherSystem { orthophoto, crs, failure } = not_linked(&found) else { panic!("{}", not_linked(&found)) };
        assert!(orthophoto.as_deref() == Some(&*format!("EPSG:{epsg}")) && crs == UTM, "{orthophoto:?} {crs}");
        let Failure::Refused { .. } = failure else { panic!("{failure:?}") };
        let told = found.orthophoto.as_ref().unwrap().to_string();
        assert!(told.contains(UTM) && told.contains(&format!("EPSG:{epsg}")), "{code}: {told}");
        assert_eq!(found.model, by_gnss().model);
    }
    // No image is placed on it in vain.
    let mut none = BlockLinks::default();
    let area = SearchArea::new(in_system(), &placing()).unwrap();
    let grey = decode(&fs::read(&flown().photos[0]).unwrap(), &DecodeLimits::default()).unwrap().grey;
    assert!(none.place(by_gnss(), 0, grey.view(), &with_code(in_system(), 2193), &area, &placing()).unwrap().is_none());
    // The wrong zone: far from the GNSS positions.
    let found = refused(25833);
    let told = not_linked(&found).to_string();
    assert!(matches!(not_linked(&found), NotLinked::Failed { .. }) && told.contains("km from the GNSS positions"), "{told}");
}

/// The block in UTM with the true orientations of its photos, whose heights are those above the geoid.
fn true_block() -> BlockRun {
    let mut run = both().clone();
    let truth = flown().scene.truth();
    run.input.settings.placing.geoid_m = Some(GEOID_M);
    (run.model.origin, run.model.cameras) = (truth.origin, truth.cameras);
    for (own, image) in run.model.images.iter_mut().zip(truth.images) {
        (own.camera, own.pose) = (image.camera, image.pose);
    }
    run
}

/// A photo that shows a single spot.
fn spotted([x, y]: [f64; 2]) -> GreyImage {
    let grey = |column: usize, row: usize| {
        let [dx, dy] = [column as f64 + 0.5 - x, row as f64 + 0.5 - y];
        (20.0 + 200.0 * (-(dx * dx + dy * dy) / (2.0 * 9.0)).exp()).round() as u8
    };
    GreyImage::from_fn(480, 360, grey).unwrap()
}

/// Where a picture shows its spot, in px.
fn spot(picture: &Rectified, about: [f64; 2]) -> [f64; 2] {
    let mut sums = [0.0; 3];
    for row in 0..picture.grey.height() {
        for column in 0..picture.grey.width() {
            let at = [column as f64 + 0.5, row as f64 + 0.5];
            let near = (0..2).all(|k| (at[k] - about[k]).abs() < 15.0);
            let weight = if near { (f64::from(picture.grey.view().at(column, row)) - 22.0).max(0.0) } else { 0.0 };
            sums = [sums[0] + weight, sums[1] + weight * at[0], sums[2] + weight * at[1]];
        }
    }
    [sums[1] / sums[0], sums[2] / sums[0]]
}

#[test]
fn a_mosaic_has_known_ground_at_its_pixels_in_the_coordinate_reference_system() {
    let run = true_block();
    let mut seen = 0;
    for (place, images) in shown(&flown().scene, &[0, 3, 6], &[[150.0, 120.0], [330.0, 240.0]]) {
        let [x, y, z] = in_utm(place);
        let mut mosaic = Mosaic::of_block(&run, Some(Heights::Level(z)), None).unwrap();
        assert_eq!(mosaic.epsg(), Some(25_832));
        // Whole, not cut by the edge of the photo.
        let (image, at) = *images.iter().find(|(_, [x, y])| (40.0..440.0).contains(x) && (40.0..320.0).contains(y)).unwrap();
        mosaic.add(image, spotted(at).view()).unwrap();
        let made = mosaic.finish().unwrap();
        let expected = made.georeference.pixel([x, y]);
        let found = spot(&made, expected);
        assert!((0..2).all(|k| (found[k] - expected[k]).abs() < 0.1), "{found:?}, expected {expected:?}");
        seen += 1;
    }
    assert!(seen >= 4, "{seen}");
}

#[test]
fn a_mosaic_on_the_heights_of_tie_points_covers_what_the_block_shows_and_says_its_system() {
    let run = both();
    let mut mosaic = Mosaic::of_block(run, None, None).unwrap();
    let photo = decode(&fs::read(&flown().photos[0]).unwrap(), &DecodeLimits::default()).unwrap().grey;
    mosaic.add(0, photo.view()).unwrap();
    let epsg = mosaic.epsg();
    let Heights::Model(heights) = mosaic.heights() else { panic!("the tie points give heights") };
    let [x, y, z] = in_utm(flown().scene.surface_at(0, &[[240.0, 180.0]]).unwrap()[0]);
    let ground = heights.at([x, y]).unwrap();
    // The zero of the heights is that of the control points, where nothing says another.
    assert!((ground - z).abs() < 25.0, "{ground} {z}");
    let read = HeightModel::read(&write_heights(heights, epsg).unwrap(), None).unwrap();
    assert_eq!(read.epsg(), Some(25_832));
    let made = mosaic.finish().unwrap();
    let at = made.georeference.pixel([x, y]);
    assert_eq!(made.mask.view().at(at[0] as usize, at[1] as usize), 255);
    let file = write_geotiff(&made, epsg).unwrap();
    let read = Orthophoto::read(&file, None, Heights::Level(0.0), &DecodeLimits::default()).unwrap();
    assert_eq!((read.epsg, read.georeference), (Some(25_832), made.georeference));
}

#[test]
fn heights_of_another_system_and_systems_in_degrees_are_refused_for_a_mosaic() {
    let Heights::Model(model) = in_system().heights.clone() else { panic!("the scene has heights") };
    let of = |epsg: u16| Heights::Model(HeightModel::read(&write_heights(&model, Some(epsg)).unwrap(), None).unwrap());
    assert!(Mosaic::of_block(both(), Some(of(25_832)), Some(5.0)).is_ok());
    let told = Mosaic::of_block(both(), Some(of(25_833)), None).err().unwrap().to_string();
    assert!(told.contains("EPSG:25833") && told.contains("EPSG:25832"), "{told}");
    let mut degrees = by_gnss().clone();
    degrees.input.settings.placing.crs = Some("EPSG:4258".into());
    let told = Mosaic::of_block(&degrees, None, None).err().unwrap().to_string();
    assert!(told.contains("ETRS89") && told.contains("degrees"), "{told}");
    assert_eq!(accuracy_map(&degrees, None, None).err().unwrap().to_string(), told);
}

#[test]
fn accuracy_maps_are_in_the_coordinate_reference_system() {
    let map = accuracy_map(both(), None, None).unwrap();
    let [x, y, z] = in_utm(flown().scene.surface_at(0, &[[240.0, 180.0]]).unwrap()[0]);
    let at = map.georeference.pixel([x, y]);
    assert!(at[0] >= 0.0 && at[1] >= 0.0 && at[0] < map.width as f64 && at[1] < map.height as f64, "{at:?}");
    let cell = map.cells[at[1] as usize * map.width + at[0] as usize];
    assert!(cell.images >= 2 && (cell.ground - z).abs() < 25.0 && cell.plan > 0.0 && cell.height > cell.plan, "{cell:?}");
    let [plan, ..] = map.rasters().unwrap();
    assert_eq!(HeightModel::read(&plan, None).unwrap().epsg(), Some(25_832));
}

#[test]
fn a_block_on_an_orthophoto_keeps_the_code_of_its_system() {
    let run = run(None, None, None).unwrap();
    let found = links().linked(&run, in_system(), &placing()).unwrap();
    assert!(matches!(found.orthophoto, Some(OnOrthophoto::Linked { epsg: Some(25_832), in_crs: false, .. })), "{:?}", found.orthophoto);
    let mut mosaic = Mosaic::of_block(&found, None, Some(4.0)).unwrap();
    assert_eq!(mosaic.epsg(), Some(25_832));
    let photo = decode(&fs::read(&flown().photos[0]).unwrap(), &DecodeLimits::default()).unwrap().grey;
    mosaic.add(0, photo.view()).unwrap();
    let made = mosaic.finish().unwrap();
    let [x, y, _] = in_utm(flown().scene.surface_at(0, &[[240.0, 180.0]]).unwrap()[0]);
    let at = made.georeference.pixel([x, y]);
    assert_eq!(made.mask.view().at(at[0] as usize, at[1] as usize), 255);
}

#[test]
fn an_image_is_sought_about_its_gnss_position_first_and_then_anywhere() {
    let file = fs::read(&flown().photos[0]).unwrap();
    let grey = decode(&file, &DecodeLimits::default()).unwrap().grey;
    let recorded = ExifImage::read(&file, 480, 360).position.unwrap();
    let truth = flown().scene.truth();
    let known = PlacingCamera { camera: truth.cameras[0], uncertainty: CameraUncertainty::NONE };
    let options = PlacingOptions { within_m: 300.0, ..placing() };
    let place = |reference: &Orthophoto, position: Option<&ExifPosition>, options: &PlacingOptions| {
        let area = SearchArea::new(reference, options).unwrap();
        let found = place_recorded(grey.view(), &known, position, reference, &area, options).unwrap();
        let placement = found.placement.unwrap_or_else(|| panic!("{}", found.verdict));
        let known = in_utm(truth.images[0].pose.unwrap().position);
        let off = (placement.pose.position[0] - known[0]).hypot(placement.pose.position[1] - known[1]);
        assert!(off < 2.0, "{off} m");
        found.search
    };
    assert_eq!(place(in_system(), Some(&recorded), &options), Some(PlaceSearch::Gnss { within_m: 300.0 }));
    // More than a kilometre east, and on the orthophoto, where another photo was taken.
    let east = ExifPosition { longitude_deg: recorded.longitude_deg + 0.02, ..recorded };
    let other = ExifImage::read(&fs::read(&flown().photos[7]).unwrap(), 480, 360).position.unwrap();
    let little = PlacingOptions { within_m: 60.0, ..placing() };
    for (wrong, options) in [(east, &options), (other, &little)] {
        let within_m = options.within_m;
        assert_eq!(place(in_system(), Some(&wrong), options), Some(PlaceSearch::BeyondGnss { within_m }));
    }
    // Without a position, without a system of the orthophoto, and where another place is given.
    assert_eq!(place(in_system(), None, &options), None);
    assert_eq!(place(&orthophoto(UTM, 1.0), Some(&recorded), &options), None);
    let [x, y, _] = in_utm(truth.images[0].pose.unwrap().position);
    let near = PlacingOptions { near_x: Some(x), near_y: Some(y), ..options };
    assert_eq!(place(in_system(), Some(&recorded), &near), None);
}
