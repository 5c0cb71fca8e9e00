//! Mosaics and accuracy maps in a coordinate reference system, beside their truth.

use super::super::shown::shown;
use super::flown::{GEOID_M, both, by_gnss, flown, in_utm};
use super::orthophoto::{in_system, with_code};
use std::fs;
use std::io::Cursor;
use tiepoint::{
    BlockRun, DecodeLimits, GreyImage, HeightModel, Heights, Mosaic, Orthophoto, Remark, accuracy_map, decode, heights_of_block,
    write_heights,
};

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

/// A mosaic of one photo, read from its file.
pub fn made(mut mosaic: Mosaic, index: usize, photo: GreyImage) -> Orthophoto {
    let mut file = Cursor::new(Vec::new());
    mosaic.add(index, &photo.into(), &mut file).unwrap();
    mosaic.finish(&mut file).unwrap();
    Orthophoto::read(&file.into_inner(), None, Heights::Level(0.0), &DecodeLimits::default()).unwrap()
}

/// Where a picture shows its spot, in px.
fn spot(picture: &Orthophoto, about: [f64; 2]) -> [f64; 2] {
    let mut sums = [0.0; 3];
    let grey = picture.grey().unwrap();
    for row in 0..grey.height() {
        for column in 0..grey.width() {
            let at = [column as f64 + 0.5, row as f64 + 0.5];
            let near = (0..2).all(|k| (at[k] - about[k]).abs() < 15.0);
            let weight = if near { (f64::from(grey.view().at(column, row)) - 22.0).max(0.0) } else { 0.0 };
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
        let mosaic = Mosaic::of_block(&run, Some(Heights::Level(z)), None).unwrap();
        assert_eq!(mosaic.epsg(), Some(25_832));
        // Whole, not cut by the edge of the photo.
        let (image, at) = *images.iter().find(|(_, [x, y])| (40.0..440.0).contains(x) && (40.0..320.0).contains(y)).unwrap();
        let made = made(mosaic, image, spotted(at));
        let expected = made.georeference.pixel([x, y]);
        let found = spot(&made, expected);
        assert!((0..2).all(|k| (found[k] - expected[k]).abs() < 0.1), "{found:?}, expected {expected:?}");
        seen += 1;
    }
    assert!(seen >= 4, "{seen}");
}

#[test]
fn a_mosaic_of_one_image_is_that_image_on_the_ground_and_unknown_names_are_refused_with_those_there_are() {
    let run = true_block();
    let names: Vec<String> = run.model.images.iter().map(|image| image.name.clone()).collect();
    let (place, images) = shown(&flown().scene, &[0, 3, 6], &[[150.0, 120.0], [330.0, 240.0]]).remove(0);
    let (image, at) = *images.iter().find(|(_, [x, y])| (40.0..440.0).contains(x) && (40.0..320.0).contains(y)).unwrap();
    let [x, y, z] = in_utm(place);
    let of = |names: &[String]| Mosaic::of_images(&run, names, Some(Heights::Level(z)), None).unwrap();
    let (one, all) = (of(&names[image..=image]), of(&[]));
    assert_eq!((one.order(), all.order().len()), (vec![image], names.len()));
    assert!(one.size().iter().product::<usize>() * 2 < all.size().iter().product(), "{:?} of {:?}", one.size(), all.size());
    let made = made(one, image, spotted(at));
    let expected = made.georeference.pixel([x, y]);
    let found = spot(&made, expected);
    assert!((0..2).all(|k| (found[k] - expected[k]).abs() < 0.1), "{found:?}, expected {expected:?}");
    let two = [names[1].clone(), names[0].clone()];
    assert_eq!(of(&two).order().iter().copied().collect::<std::collections::BTreeSet<_>>(), [0, 1].into());
    let told = Mosaic::of_images(&run, &["other.png".to_string()], None, None).err().unwrap().to_string();
    assert!(told.contains("got other.png") && told.contains(&names[0]), "{told}");
}

#[test]
fn a_mosaic_on_the_heights_of_tie_points_covers_what_the_block_shows_and_says_its_system() {
    let run = both();
    let mosaic = Mosaic::of_block(run, None, None).unwrap();
    let epsg = mosaic.epsg();
    let Heights::Model(heights) = mosaic.heights() else { panic!("the tie points give heights") };
    let [x, y, z] = in_utm(flown().scene.surface_at(0, &[[240.0, 180.0]]).unwrap()[0]);
    let ground = heights.at([x, y]).unwrap();
    // The zero of the heights is that of the control points, where nothing says another.
    assert!((ground - z).abs() < 25.0, "{ground} {z}");
    let read = HeightModel::read(&write_heights(heights, epsg).unwrap(), None).unwrap();
    assert_eq!((epsg, read.epsg()), (Some(25_832), Some(25_832)));
    let made = made(mosaic, 0, decode(&fs::read(&flown().photos[0]).unwrap(), &DecodeLimits::default()).unwrap().grey);
    assert!(made.epsg == Some(25_832) && made.shows(made.georeference.pixel([x, y])));
}

#[test]
fn the_tie_points_of_a_block_are_heights_of_an_orthophoto_in_its_system() {
    let heights = heights_of_block(both()).unwrap();
    assert_eq!(heights.epsg(), Some(25_832));
    let mut orthophoto = in_system().clone();
    orthophoto.set_heights(Heights::Model(heights.clone())).unwrap();
    let [x, y, z] = in_utm(flown().scene.surface_at(0, &[[240.0, 180.0]]).unwrap()[0]);
    let own = orthophoto.heights.at([x, y]).unwrap();
    assert!((own - z).abs() < 25.0 && orthophoto.heights_share() > 0.9, "{own} for {z}, {}", orthophoto.heights_share());
    let mut other = with_code(in_system(), 25_833);
    assert!(other.set_heights(Heights::Model(heights)).unwrap_err().to_string().contains("EPSG:25832"));
}

#[test]
fn heights_of_another_system_and_systems_in_degrees_are_refused_for_a_mosaic() {
    let Heights::Model(model) = in_system().heights.clone() else { panic!("the scene has heights") };
    let of = |epsg: u16| Heights::Model(HeightModel::read(&write_heights(&model, Some(epsg)).unwrap(), None).unwrap());
    assert!(Mosaic::of_block(both(), Some(of(25_832)), Some(5.0)).is_ok());
    let told = Mosaic::of_block(both(), Some(of(25_833)), None).err().unwrap().to_string();
    assert!(told.contains("EPSG:25833") && told.contains("EPSG:25832"), "{told}");
    // A system without a code of its own contradicts them as well.
    let mut by_text = both().clone();
    by_text.input.settings.placing.crs = Some("+proj=utm +zone=32 +datum=WGS84".into());
    assert!(Mosaic::of_block(&by_text, Some(of(32_632)), Some(5.0)).is_ok());
    for other in [25_833, 31_467] {
        let told = Mosaic::of_block(&by_text, Some(of(other)), None).err().unwrap().to_string();
        assert!(told.contains(&format!("EPSG:{other}")) && told.contains("+proj=utm +zone=32"), "{told}");
    }
    let mut degrees = by_gnss().clone();
    degrees.input.settings.placing.crs = Some("EPSG:4258".into());
    let told = Mosaic::of_block(&degrees, None, None).err().unwrap().to_string();
    assert!(told.contains("ETRS89") && told.contains("degrees"), "{told}");
    assert_eq!(accuracy_map(&degrees, None, None).err().unwrap().to_string(), told);
}

/// Heights whose file says that they are feet of the US survey.
fn in_feet(model: &HeightModel, epsg: u16) -> Heights {
    with_key(model, epsg, [4099, 9003])
}

/// Heights whose file has one more key of a GeoTIFF, with its value.
fn with_key(model: &HeightModel, epsg: u16, [key, value]: [u16; 2]) -> Heights {
    let mut file = write_heights(model, Some(epsg)).unwrap();
    let [raster_type, own] = [[1025_u16, 0, 1, 1], [key, 0, 1, value]].map(|key| key.map(u16::to_le_bytes).concat());
    let at = file.windows(8).position(|window| window == raster_type).unwrap();
    file[at..at + 8].copy_from_slice(&own);
    Heights::Model(HeightModel::read(&file, None).unwrap())
}

#[test]
fn a_mosaic_on_heights_that_count_from_elsewhere_than_those_of_its_block_says_so() {
    let Heights::Model(model) = in_system().heights.clone() else { panic!("the scene has heights") };
    let said = |run: &BlockRun, code: u16| {
        let mosaic = Mosaic::of_block(run, Some(with_key(&model, 25_832, [4096, code])), Some(5.0)).unwrap();
        mosaic.remark().cloned()
    };
    // Above the ellipsoid, where the block counts from a geoid: so much too high.
    match said(&true_block(), 4979) {
        Some(Remark::MosaicHeights { heights, from_ellipsoid: true, crs, above_m: Some(above_m) }) => {
            assert!(
                (above_m - GEOID_M).abs() < 1e-9 && heights.contains("WGS 84") && crs.contains("UTM zone 32N"),
                "{heights} {crs} {above_m}"
            );
        }
        other => panic!("{other:?}"),
    }
    let mut ellipsoidal = true_block();
    ellipsoidal.input.settings.placing.geoid_m = Some(0.0);
    let above_sea = said(&ellipsoidal, 7837).unwrap();
    assert!(matches!(above_sea, Remark::MosaicHeights { from_ellipsoid: false, above_m: None, .. }), "{above_sea:?}");
    assert!(above_sea.to_string().contains("the ground lies off in height by the height of the geoid"), "{above_sea}");
    // From the same zero, where nobody says what they count from, and of the block's own tie points.
    assert_eq!([said(&true_block(), 7837), said(&ellipsoidal, 4979)], [None, None]);
    assert!(Mosaic::of_block(&true_block(), Some(Heights::Level(50.0)), Some(5.0)).unwrap().remark().is_none());
    assert!(Mosaic::of_block(&true_block(), None, Some(5.0)).unwrap().remark().is_none());
}

#[test]
fn heights_in_feet_are_those_of_the_ground_in_metres() {
    const FOOT_US: f64 = 1200.0 / 3937.0;
    let Heights::Model(model) = in_system().heights.clone() else { panic!("the scene has heights") };
    let read = |epsg: u16| HeightModel::read(&write_heights(&model, Some(epsg)).unwrap(), None).unwrap();
    let [x, y, _] = in_utm(flown().scene.surface_at(0, &[[240.0, 180.0]]).unwrap()[0]);
    let own = model.at([x, y]).unwrap();
    // The model has metres; as feet it is so much lower.
    let lower = own * FOOT_US;
    let mosaic = Mosaic::of_block(both(), Some(in_feet(&model, 25_832)), Some(5.0)).unwrap();
    assert!((mosaic.heights().at([x, y]).unwrap() - lower).abs() < 1e-3, "{:?} {lower}", mosaic.heights().at([x, y]));
    let Heights::Model(converted) = mosaic.heights() else { panic!("a model stays one") };
    // What is written has the converted heights, and no unit of its own.
    let again = HeightModel::read(&write_heights(converted, Some(25_832)).unwrap(), None).unwrap();
    assert!((again.at([x, y]).unwrap() - lower).abs() < 1e-3);
    // In a system that has feet itself, they stay what they are.
    let mut feet = both().clone();
    feet.input.settings.placing.crs = Some("+proj=utm +zone=32 +ellps=GRS80 +towgs84=0,0,0 +vunits=us-ft".into());
    let mosaic = Mosaic::of_block(&feet, Some(in_feet(&model, 25_832)), Some(5.0)).unwrap();
    assert!((mosaic.heights().at([x, y]).unwrap() - own).abs() < 1e-9);
    // Under an orthophoto, too, be they given with it or later.
    let mut orthophoto = in_system().clone();
    orthophoto.epsg = Some(25_832);
    orthophoto.set_heights(in_feet(&model, 25_832)).unwrap();
    assert!((orthophoto.heights.at([x, y]).unwrap() - lower).abs() < 1e-3);
    orthophoto.set_heights(Heights::Model(read(25_832))).unwrap();
    assert_eq!(orthophoto.heights.at([x, y]), Some(own));
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
