//! Blocks with GNSS positions on orthophotos in a coordinate reference system, beside their truth.

use super::flown::{GEOID_M, UTM, both, by_gnss, control, files, flown, in_utm, in_zone, numbers, on_earth, run};
use super::mosaic::made;
use std::fs;
use std::sync::OnceLock;
use tiepoint::{
    BlockEdit, BlockLinks, BlockRun, CameraUncertainty, ControlRole, ControlTexts, Datum, DecodeLimits, ExifImage, ExifPosition, Failure,
    Georeference, HeightModel, Heights, Mosaic, NotLinked, OnOrthophoto, Orthophoto, PlaceSearch, PlacingCamera, PlacingOptions,
    PlacingVerdict, PlacingWeakness, PointSource, Project, RecordedPosition, Remark, SearchArea, StereoPair, StereoSystem, decode,
    place_recorded,
};

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

pub fn with_code(orthophoto: &Orthophoto, epsg: u16) -> Orthophoto {
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
pub fn in_system() -> &'static Orthophoto {
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
    let plain = all_linked(links(), &run(None, None, None).unwrap(), &orthophoto(UTM, 1.0));
    assert!(plain.model.origin.is_none());
    let [map, with_system] = [centres(&plain), centres(on_orthophoto())];
    // The length of 1 m of the ground in the map.
    let [from, to] = [-500.0, 500.0].map(|x| in_utm([x, 0.0, 0.0]));
    let scale = 1e-3 * (to[0] - from[0]).hypot(to[1] - from[1]);
    assert!((scale - 0.99966).abs() < 3e-5, "{scale}");
    for (map, own) in map.iter().zip(&with_system) {
        let above_ground = own[2] - in_utm([0.0; 3])[2];
        let by_scale = (scale - 1.0) * above_ground;
        // Within a pixel of the orthophoto: the decentring, which level ground tells from the tilt by little, is another by a part of its standard error.
        assert!((map[0] - own[0]).hypot(map[1] - own[1]) < 0.8, "{map:?} {own:?}");
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

#[test]
fn a_block_on_an_orthophoto_keeps_the_code_of_its_system() {
    let run = run(None, None, None).unwrap();
    let found = links().linked(&run, in_system(), &placing()).unwrap();
    assert!(matches!(found.orthophoto, Some(OnOrthophoto::Linked { epsg: Some(25_832), in_crs: false, .. })), "{:?}", found.orthophoto);
    // Epipolar images are in its system, those of the block without it where its GNSS positions have them.
    let system = |run: &BlockRun| StereoPair::of_project(&Project::Block(Box::new(run.clone())), None).unwrap().system;
    assert_eq!(system(&found), StereoSystem::Orthophoto { epsg: Some(25_832) });
    let of_gnss = system(by_gnss());
    assert!(matches!(of_gnss, StereoSystem::Tangent { origin } if Some(origin) == by_gnss().model.origin), "{of_gnss:?}");
    let mosaic = Mosaic::of_block(&found, None, Some(4.0)).unwrap();
    assert_eq!(mosaic.epsg(), Some(25_832));
    let photo = decode(&fs::read(&flown().photos[0]).unwrap(), &DecodeLimits::default()).unwrap().grey;
    let made = made(mosaic, 0, photo);
    let [x, y, _] = in_utm(flown().scene.surface_at(0, &[[240.0, 180.0]]).unwrap()[0]);
    assert!(made.shows(made.georeference.pixel([x, y])));
}

#[test]
fn an_image_is_sought_about_its_gnss_position_first_and_then_anywhere() {
    let file = fs::read(&flown().photos[0]).unwrap();
    let grey = decode(&file, &DecodeLimits::default()).unwrap().grey;
    let recorded = ExifImage::read(&file, 480, 360).position.unwrap();
    let truth = flown().scene.truth();
    let known = PlacingCamera { camera: truth.cameras[0], uncertainty: CameraUncertainty::NONE, decentring: None };
    let options = PlacingOptions { within_m: 300.0, ..placing() };
    let place = |reference: &Orthophoto, position: Option<&ExifPosition>, options: &PlacingOptions| {
        let area = SearchArea::new(reference, options).unwrap();
        let found =
            place_recorded(grey.view(), &known, position.copied().map(RecordedPosition::from).as_ref(), reference, &area, options).unwrap();
        let placement = found.placement.unwrap_or_else(|| panic!("{}", found.verdict));
        let known = in_utm(truth.images[0].pose.unwrap().position);
        let off = (placement.pose.position[0] - known[0]).hypot(placement.pose.position[1] - known[1]);
        assert!(off < 2.0, "{off} m");
        if !matches!(found.verdict, PlacingVerdict::Placed { .. }) {
            assert!(
                matches!(found.verdict, PlacingVerdict::Weak { placing_weakness: PlacingWeakness::Gnss { .. }, .. }),
                "{}",
                found.verdict
            );
        }
        (found.verdict, found.search)
    };
    let search = |reference: &Orthophoto, position: Option<&ExifPosition>, options: &PlacingOptions| {
        let (verdict, search) = place(reference, position, options);
        assert!(matches!(verdict, PlacingVerdict::Placed { .. }), "{verdict}");
        search
    };
    let near = search(in_system(), Some(&recorded), &options);
    assert!(matches!(near, Some(PlaceSearch::Gnss { within_m: 300.0, plan_m }) if plan_m < 20.0), "{near:?}");
    // More than a kilometre east, and on the orthophoto, where another photo was taken.
    let east = ExifPosition { longitude_deg: recorded.longitude_deg + 0.02, ..recorded };
    let other = ExifImage::read(&fs::read(&flown().photos[7]).unwrap(), 480, 360).position.unwrap();
    let little = PlacingOptions { within_m: 60.0, ..placing() };
    for (wrong, options) in [(east, &options), (other, &little)] {
        let (verdict, sought) = place(in_system(), Some(&wrong), options);
        let PlacingVerdict::Weak { placing_weakness: PlacingWeakness::Gnss { plan_m, usual_m }, .. } = verdict else { panic!("{verdict}") };
        assert!(plan_m > options.within_m && (30.0..33.0).contains(&usual_m), "{plan_m} {usual_m}");
        assert_eq!(sought, Some(PlaceSearch::BeyondGnss { within_m: options.within_m }));
    }
    // Without a position, without a system of the orthophoto, and where another place is given.
    assert_eq!(search(in_system(), None, &options), None);
    assert_eq!(search(&orthophoto(UTM, 1.0), Some(&recorded), &options), None);
    let [x, y, _] = in_utm(truth.images[0].pose.unwrap().position);
    let near = PlacingOptions { near_x: Some(x), near_y: Some(y), ..options };
    assert_eq!(search(in_system(), Some(&recorded), &near), None);
}
