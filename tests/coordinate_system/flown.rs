//! A scene with its photos, GNSS positions and control points, and its blocks.

use super::super::shown::shown;
use proj_core::Transform;
use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::sync::{Mutex, OnceLock, PoisonError};
use tiepoint::{
    BlockFlight, BlockRun, BlockScene, BlockSettings, ControlTexts, Error, MultiscaleOptions, RunInput, block_files, geographic_from_local,
    run_block,
};

/// West of the central meridian of its zone.
pub const UTM: &str = "EPSG:25832";
/// Of the ellipsoid below the zero of the heights of control points.
pub const GEOID_M: f64 = 47.3;

pub struct Flown {
    pub scene: BlockScene,
    pub photos: Vec<PathBuf>,
    pub folder: PathBuf,
}

/// A scene with its photos on disk, which record GNSS positions.
pub fn flown() -> &'static Flown {
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
pub fn on_earth(place: [f64; 3]) -> [f64; 3] {
    let origin = flown().scene.truth().origin.unwrap();
    geographic_from_local(place, [origin.longitude_deg, origin.latitude_deg, origin.height_m])
}

/// A place of the scene in UTM, with its height above the geoid.
pub fn in_utm(place: [f64; 3]) -> [f64; 3] {
    in_zone(UTM, place)
}

pub fn in_zone(utm: &str, place: [f64; 3]) -> [f64; 3] {
    let [longitude, latitude, height] = on_earth(place);
    let (x, y) = Transform::new("EPSG:4258", utm).unwrap().convert((longitude, latitude)).unwrap();
    [x, y, height - GEOID_M]
}

/// Points of the ground, every third of them a check point, as `write` writes their coordinates.
pub fn control(write: impl Fn([f64; 3]) -> [f64; 3]) -> ControlTexts {
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

pub static FOLDER: Mutex<()> = Mutex::new(());

pub fn run<'a>(crs: impl Into<Option<&'a str>>, geoid_m: Option<f64>, control: Option<ControlTexts>) -> Result<BlockRun, Error> {
    run_of(crs, geoid_m, RunInput { control, ..RunInput::default() })
}

/// The same of other input.
pub fn run_of<'a>(crs: impl Into<Option<&'a str>>, geoid_m: Option<f64>, input: RunInput) -> Result<BlockRun, Error> {
    let Flown { photos, folder, scene } = flown();
    // Over ground that is nearly flat a focal length that is estimated takes the height with it.
    let focal_px = scene.truth().cameras[0].focal_px;
    let cameras = Some(format!(r#"{{"cameras": [{{"focal_px": {focal_px}, "fixed": true}}]}}"#));
    let mut settings = BlockSettings::default();
    settings.features.multiscale = MultiscaleOptions { number: 2500, ..settings.features.multiscale };
    (settings.placing.crs, settings.placing.geoid_m) = (crs.into().map(String::from), geoid_m);
    // One run at a time has the folder.
    let _folder = FOLDER.lock().unwrap_or_else(PoisonError::into_inner);
    run_block(photos, &[], RunInput { settings, cameras, ..input }, &folder.join("work"), 2, drop)
}

/// The block with control points in UTM.
pub fn both() -> &'static BlockRun {
    static BOTH: OnceLock<BlockRun> = OnceLock::new();
    BOTH.get_or_init(|| run(UTM, None, Some(control(|place| place))).unwrap())
}

pub fn files(run: &BlockRun) -> BTreeMap<String, String> {
    let mut files = BTreeMap::new();
    block_files(run, &[], None, &mut |path, text| {
        files.insert(path.to_string(), text.to_string());
        Ok(())
    })
    .unwrap();
    files
}

/// The numbers in these columns of a table, row by row.
pub fn numbers(table: &str, columns: &[&str]) -> Vec<Vec<f64>> {
    let mut lines = table.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let places: Vec<usize> = columns.iter().map(|column| names.iter().position(|name| name == column).unwrap()).collect();
    lines
        .map(|line| line.split(',').collect::<Vec<_>>())
        .map(|cells| places.iter().map(|at| cells[*at].parse().unwrap()).collect())
        .collect()
}

/// The block without control points, in UTM by its GNSS positions.
pub fn by_gnss() -> &'static BlockRun {
    static BY_GNSS: OnceLock<BlockRun> = OnceLock::new();
    BY_GNSS.get_or_init(|| run(UTM, None, None).unwrap())
}
