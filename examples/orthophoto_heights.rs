//! Simulated blocks with precise GNSS positions in the system of an orthophoto whose heights are off: whether the block says so where it is moved by them,
//! and stays silent where they are right. Arguments: first seed, number of seeds, strips, exposures per strip.

use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::ExitCode;
use tiepoint::{
    BlockFlight, BlockLinks, BlockRun, BlockScene, BlockVerdict, BlockWarning, DecodeLimits, HeightModel, Heights, Orthophoto,
    PlacingOptions, RunInput, SearchArea, Sidecars, decode, geographic_from_local, run_block,
};

/// Side of a pixel of the orthophoto, and by how much heights are off, in m.
const GSD_M: f64 = 0.5;
const OFF_M: f64 = 5.0;
/// Standard errors of the positions in m: of a receiver with corrections (RTK).
const PLAN_M: f64 = 0.03;
const HEIGHT_M: f64 = 0.05;
/// A block whose images are no higher or lower than this, in the median, is not moved by heights that are off.
const MOVED_M: f64 = 0.2 * OFF_M;

/// How heights are wrong.
#[derive(Clone, Copy, PartialEq)]
enum Fault {
    None,
    /// All of them, by so many m: as heights that count from elsewhere.
    Whole(f64),
    /// In the eastern half alone.
    Half,
}

const FAULTS: [(Fault, &str); 4] = [
    (Fault::None, "heights right"),
    (Fault::Whole(OFF_M), "5 m too high"),
    (Fault::Whole(-OFF_M), "5 m too low"),
    (Fault::Half, "5 m too high in the eastern half"),
];

/// The system of a flight: a transverse Mercator about the origin of its axes.
fn system(longitude_deg: f64, latitude_deg: f64) -> String {
    format!(
        r#"PROJCS["about",GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],PARAMETER["latitude_of_origin",{latitude_deg}],PARAMETER["central_meridian",{longitude_deg}],PARAMETER["scale_factor",1],PARAMETER["false_easting",0],PARAMETER["false_northing",0],UNIT["metre",1]]"#
    )
}

/// A block with its scene, and where that is on the earth.
struct Flown {
    scene: BlockScene,
    photos: Vec<Vec<u8>>,
    run: BlockRun,
    origin: [f64; 3],
}

impl Flown {
    fn new(flight: &BlockFlight, folder: &Path) -> Self {
        let scene = BlockScene::new(flight).expect("a flight that can be flown");
        let truth = scene.truth();
        let place = truth.origin.expect("a flight on the earth");
        let origin = [place.longitude_deg, place.latitude_deg, place.height_m];
        let mut positions = String::from("image,longitude,latitude,height,accuracy horizontal,accuracy vertical\n");
        let mut files = Vec::new();
        fs::create_dir_all(folder).expect("a folder for the photos");
        for (index, image) in truth.images.iter().enumerate() {
            let name = format!("photo_{index:05}.png");
            let [longitude, latitude, height] = geographic_from_local(image.pose.expect("a pose").position, origin);
            writeln!(positions, "{name},{longitude:.10},{latitude:.10},{height:.4},{PLAN_M},{HEIGHT_M}").expect("room for a line");
            files.push(folder.join(name));
            fs::write(&files[index], scene.photo_file(index).expect("a photo of the flight")).expect("room for the photos");
        }
        let input = RunInput { positions: Some(positions), ..RunInput::default() };
        let run = run_block(&files, &[], input, &folder.join("work"), 2, drop).expect("a block that can be oriented");
        let photos = files.iter().map(|path| fs::read(path).expect("the photo that was written")).collect();
        Self { scene, photos, run, origin }
    }

    /// Its orthophoto, which names its system; its heights count from the origin of the axes.
    fn orthophoto(&self, fault: Fault) -> Orthophoto {
        let own = self.scene.orthophoto(GSD_M).expect("an orthophoto of less than 100 MP");
        let [width, height] = own.size();
        let wrong = |k: usize| {
            let (column, row) = (k % width, k / width);
            let right = own.heights.at(own.georeference.ground([column as f64 + 0.5, row as f64 + 0.5])).unwrap_or(f64::NAN);
            (right + if fault == Fault::Half && 2 * column > width { OFF_M } else { 0.0 }) as f32
        };
        let model = HeightModel::new(width, height, (0..width * height).map(wrong).collect(), own.georeference);
        let [picture, _] = own.files().expect("an orthophoto of less than 100 MP");
        let sidecars = Sidecars { world_file: None, projection: Some(system(self.origin[0], self.origin[1])) };
        let heights = Heights::Model(model.expect("heights of the earth"));
        Orthophoto::read(&picture, sidecars, heights, &DecodeLimits::default()).expect("a GeoTIFF")
    }

    /// The block on it.
    fn placed(&self, fault: Fault) -> BlockRun {
        let reference = self.orthophoto(fault);
        let off = if let Fault::Whole(off) = fault { off } else { 0.0 };
        let options = PlacingOptions { heights_geoid_m: Some(self.origin[2] + off), ..PlacingOptions::default() };
        let area = SearchArea::new(&reference, &options).expect("a place on the orthophoto");
        let mut links = BlockLinks::default();
        for (index, bytes) in self.photos.iter().enumerate() {
            let grey = decode(bytes, &DecodeLimits::default()).expect("a PNG").grey;
            links.place(&self.run, index, grey.view(), &reference, &area, &options).expect("an image of the block");
        }
        links.linked(&self.run, &reference, &options).expect("a block without ground control points")
    }

    /// How much higher the images of a block are than they were, in m, in the median.
    fn height_error_m(&self, run: &BlockRun) -> f64 {
        let truth = self.scene.truth();
        let pairs = run.model.images.iter().zip(&truth.images);
        let mut errors: Vec<f64> = pairs.filter_map(|(own, known)| Some(own.pose?.position[2] - known.pose?.position[2])).collect();
        errors.sort_by(f64::total_cmp);
        errors[errors.len() / 2]
    }

    /// Whether a block does as it should.
    fn is_right(&self, run: &BlockRun, fault: Fault) -> bool {
        let model = &run.reconstruction.as_ref().expect("a block that is oriented").models[0];
        let says = model.warnings.iter().any(|warning| matches!(warning, BlockWarning::OrthophotoHeightsApart { .. }));
        let (outcome, error_m) = (run.orthophoto.as_ref().expect("an orthophoto was given"), self.height_error_m(run));
        println!("    {outcome} Images are {error_m:.2} m too high in the median. {:?}", model.warnings);
        let is_oriented = matches!(BlockVerdict::of(run), BlockVerdict::Oriented { .. });
        match fault {
            Fault::None => is_oriented && error_m.abs() < MOVED_M,
            Fault::Whole(_) => says,
            Fault::Half => !is_oriented || error_m.abs() < MOVED_M,
        }
    }
}

fn main() -> ExitCode {
    let numbers: Vec<u32> = std::env::args().skip(1).filter_map(|word| word.parse().ok()).collect();
    let given = |k: usize, standard: u32| numbers.get(k).copied().unwrap_or(standard);
    let (first, seeds, strips, exposures) = (given(0, 1), given(1, 1), given(2, 5), given(3, 6));
    let mut right = FAULTS.map(|_| 0);
    for seed in first..first + seeds {
        let (strips, exposures) = (strips as usize, exposures as usize);
        let flight = BlockFlight { strips, exposures, width_px: 800, height_px: 600, pixel_mm: 0.045, seed, ..BlockFlight::default() };
        let folder = std::env::temp_dir().join(format!("tiepoint-orthophoto-heights-{}-{seed}", std::process::id()));
        let flown = Flown::new(&flight, &folder);
        for ((fault, name), right) in FAULTS.iter().zip(&mut right) {
            println!("  seed {seed}, {name}");
            *right += u32::from(flown.is_right(&flown.placed(*fault), *fault));
        }
        fs::remove_dir_all(&folder).expect("the folder that was made");
    }
    for ((_, name), right) in FAULTS.iter().zip(right) {
        println!("  {name}: as it should be in {right} of {seeds} blocks");
    }
    if right.iter().all(|right| *right == seeds) { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}
