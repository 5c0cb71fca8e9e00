//! GNSS positions of images from a table.

use super::flown::{FOLDER, GEOID_M, UTM, by_gnss, control, files, flown, numbers, run_of};
use std::fs;
use std::path::PathBuf;
use std::sync::{OnceLock, PoisonError};
use tiepoint::{
    BlockRun, BlockSettings, Error, ExifPosition, MultiscaleOptions, Pose, Project, Remark, RunInput, read_project, run_block,
    write_block_project,
};

/// The photos of the scene as files that record nothing.
fn silent() -> &'static [PathBuf] {
    static SILENT: OnceLock<Vec<PathBuf>> = OnceLock::new();
    SILENT.get_or_init(|| {
        let folder = flown().folder.join("silent");
        fs::create_dir_all(&folder).unwrap();
        let file = |index: usize| {
            let photo = flown().scene.photo(index).unwrap();
            let bytes = [format!("P5 {} {} 255\n", photo.width(), photo.height()).as_bytes(), photo.data()].concat();
            let path = folder.join(format!("photo_{index:05}.pgm"));
            fs::write(&path, bytes).unwrap();
            path
        };
        (0..flown().scene.photos()).map(file).collect()
    })
}

/// A block of photos that record no position, with this table.
fn by_table(crs: Option<&str>, geoid_m: Option<f64>, input: RunInput) -> Result<BlockRun, Error> {
    let focal_px = flown().scene.truth().cameras[0].focal_px;
    let cameras = Some(format!(r#"{{"cameras": [{{"focal_px": {focal_px}, "fixed": true}}]}}"#));
    let mut settings = BlockSettings::default();
    settings.features.multiscale = MultiscaleOptions { number: 2500, ..settings.features.multiscale };
    (settings.placing.crs, settings.placing.geoid_m) = (crs.map(String::from), geoid_m);
    let _folder = FOLDER.lock().unwrap_or_else(PoisonError::into_inner);
    run_block(silent(), &[], RunInput { settings, cameras, ..input }, &flown().folder.join("work"), 2, drop)
}

fn recorded() -> Vec<(String, ExifPosition)> {
    by_gnss().images.iter().map(|image| (image.name.clone(), image.exif.position.unwrap())).collect()
}

fn stem(name: &str) -> &str {
    name.split('.').next().unwrap()
}

fn table() -> String {
    let rows = recorded().into_iter().map(|(name, ExifPosition { longitude_deg, latitude_deg, height_m, .. })| {
        format!("{},{latitude_deg},{longitude_deg},{}\n", stem(&name), height_m.unwrap())
    });
    format!("image,latitude,longitude,altitude\n{}", rows.collect::<String>())
}

fn poses(run: &BlockRun) -> Vec<Option<Pose>> {
    run.model.images.iter().map(|image| image.pose).collect()
}

#[test]
fn a_table_georeferences_a_block_exactly_as_the_files_of_its_images_do() {
    let run = by_table(Some(UTM), None, RunInput { positions: Some(table()), ..RunInput::default() }).unwrap();
    assert!(run.images.iter().all(|image| image.exif.position.is_none() && image.given.is_some()));
    assert_eq!(poses(&run), poses(by_gnss()));
    assert_eq!(run.model.origin, by_gnss().model.origin);
    assert!(run.model.images.iter().all(|image| image.pose.is_some()));
    let of = |run: &BlockRun| numbers(&files(run)["images.csv"], &["x", "y", "z", "omega_deg", "sigma_x"]);
    assert_eq!(of(&run), of(by_gnss()));
    assert_eq!(run.connections, by_gnss().connections);
    assert_eq!(run.remarks, by_gnss().remarks);
    // Without the table nothing says where the block is.
    assert_eq!(by_table(Some(UTM), None, RunInput::default()).unwrap().model.origin, None);
    // Neither does it where positions are not used.
    let ignored = by_table(Some(UTM), None, RunInput { positions: Some(table()), use_gnss: false, ..RunInput::default() }).unwrap();
    assert_eq!(ignored.model.origin, None);
    assert!(ignored.images.iter().all(|image| image.given.is_none()));
}

#[test]
fn a_table_in_the_system_of_the_block_has_its_heights() {
    let georeferenced = by_table(Some(UTM), Some(GEOID_M), RunInput { positions: Some(table()), ..RunInput::default() }).unwrap();
    let given = recorded();
    let system = |[longitude, latitude, height]: [f64; 3]| {
        let system = proj_core::Transform::new("EPSG:4258", UTM).unwrap();
        let (x, y) = system.convert((longitude, latitude)).unwrap();
        [x, y, height - GEOID_M]
    };
    let rows = given.iter().map(|(name, at)| {
        let [x, y, z] = system([at.longitude_deg, at.latitude_deg, at.height_m.unwrap()]);
        format!(
            "{name};{};{};{}\n",
            format!("{x:.6}").replace('.', ","),
            format!("{y:.6}").replace('.', ","),
            format!("{z:.6}").replace('.', ",")
        )
    });
    let table = format!("Bild;Rechtswert;Hochwert;Höhe\n{}", rows.collect::<String>()).replace(".png", ".pgm");
    let run = by_table(Some(UTM), Some(GEOID_M), RunInput { positions: Some(table.clone()), ..RunInput::default() }).unwrap();
    let of = |run: &BlockRun| numbers(&files(run)["images.csv"], &["x", "y", "z"]).concat();
    let apart = of(&run).iter().zip(of(&georeferenced)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart < 2e-3 && run.images.iter().all(|image| image.given.unwrap().in_crs), "{apart}");
    // Heights above an unknown zero are those of the table all the same.
    let unknown = by_table(Some(UTM), None, RunInput { positions: Some(table), ..RunInput::default() }).unwrap();
    let apart = of(&unknown).iter().zip(of(&georeferenced)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(apart < 0.02, "{apart}");
}

#[test]
fn positions_of_a_table_stand_in_place_of_those_of_files() {
    let (name, at) = recorded()[2].clone();
    let moved = format!(
        "image,lon,lat,height,acc horz,acc vert,yaw\n{name},{},{},{},0.03,0.05,1\nother.jpg,8,50,100,,,\n",
        at.longitude_deg + 1e-5,
        at.latitude_deg,
        at.height_m.unwrap() + 1.0
    );
    let run = run_of(UTM, None, RunInput { positions: Some(moved.clone()), ..RunInput::default() }).unwrap();
    let own = |image: &tiepoint::RunImage| *image.gnss().unwrap();
    for (image, (name_of, recorded)) in run.images.iter().zip(recorded()) {
        let is_given = name_of == name;
        assert_eq!(image.given.is_some(), is_given);
        let wanted = if is_given {
            ExifPosition { longitude_deg: at.longitude_deg + 1e-5, height_m: Some(at.height_m.unwrap() + 1.0), error_m: None, ..at }
        } else {
            recorded
        };
        assert_eq!(own(image), wanted);
        assert_eq!(image.exif.position, Some(recorded), "what the file records stays");
    }
    let unread = Remark::UnknownPositionColumns { columns: vec!["yaw".into()] };
    let other = Remark::PositionsOfOtherImages { images: vec!["other.jpg".into()], all: false };
    assert!(run.remarks.contains(&unread) && run.remarks.contains(&other), "{:?}", run.remarks);
    // A project says what was given.
    assert_eq!(run.input.positions, Some(moved));
    let text = write_block_project(&run).unwrap();
    let Project::Block(read) = read_project(text.as_bytes()).unwrap() else { panic!("a block was written") };
    assert_eq!(*read, run);
}

#[test]
fn one_control_point_is_enough_beside_positions_that_count_heights_from_its_zero() {
    let texts = control(|place| place);
    let mut lines = texts.points.lines();
    let points = format!("{}\n{}\n", lines.next().unwrap(), lines.next().unwrap());
    let marks: String =
        texts.marks.lines().filter(|line| line.starts_with("image") || line.contains(",G1,")).map(|line| format!("{line}\n")).collect();
    let one = || Some(tiepoint::ControlTexts { points: points.clone(), marks: marks.clone() });
    let rows = recorded().into_iter().map(|(name, at)| {
        let system = proj_core::Transform::new("EPSG:4258", UTM).unwrap();
        let (x, y) = system.convert((at.longitude_deg, at.latitude_deg)).unwrap();
        format!("{name},{x},{y},{}\n", at.height_m.unwrap() - GEOID_M)
    });
    let positions = Some(rows.collect::<String>());
    let refused = run_of(UTM, None, RunInput { control: one(), ..RunInput::default() }).unwrap_err().to_string();
    assert!(refused.contains("1 of 1 measured in two images or more"), "{refused}");
    let run = run_of(UTM, None, RunInput { control: one(), positions, ..RunInput::default() }).unwrap();
    assert!(run.model.images.iter().all(|image| image.pose.is_some()));
    let surveyed = &run.reconstruction.as_ref().unwrap().models[0].surveyed;
    assert_eq!(surveyed.len(), 1, "{surveyed:?}");
}
