//! GNSS positions of a table beside those that the files of the images record: a wrong system shows there before it shows anywhere else.

use super::place_slip::of_coordinates;
use super::result::RunImage;
use super::system::middle_of_places;
use crate::crs::{CoordinateSystem, Definition};
use crate::math::median;
use crate::{BlockWarning, ExifPosition, GeoreferencingOptions, local_from_geographic};

/// Positions that files record are right to some 10 m; by a slow receiver, or seconds without decimals, to some tens.
const USUAL_KM: f64 = 0.1;
/// Fewer files that record other positions may be wrong themselves.
const LEAST_IMAGES: usize = 3;
/// Of longitudes and latitudes.
const GEOGRAPHIC: &str = "EPSG:4326";

/// Says that the positions of a table lie elsewhere than those that the files record, and what would bring them there.
pub(super) fn of_table(images: &[RunImage], placing: &GeoreferencingOptions) -> Option<BlockWarning> {
    let place = |position: &ExifPosition| [position.longitude_deg, position.latitude_deg];
    let given = images.iter().filter(|image| image.given.is_some()).count();
    let both = images.iter().filter_map(|image| Some((image.given.as_ref()?, image.exif.position.as_ref()?)));
    let both: Vec<Both> = both.map(|(given, recorded)| Both { given: place(&given.position), recorded: place(recorded) }).collect();
    let in_crs = images.iter().filter_map(|image| image.given.as_ref()).all(|given| given.in_crs);
    let definition = || if in_crs { placing.definition().ok()? } else { Definition::read(GEOGRAPHIC).ok() };
    elsewhere(&both, given, in_crs, definition)
}

/// Longitude and latitude of an image by the table and by its file.
struct Both {
    given: [f64; 2],
    recorded: [f64; 2],
}

/// `given`: so many images the table has positions of. `definition`: the system in which it has them, which is `in_crs` that of the block.
fn elsewhere(both: &[Both], given: usize, in_crs: bool, definition: impl FnOnce() -> Option<Definition>) -> Option<BlockWarning> {
    if both.len() < LEAST_IMAGES || 2 * both.len() < given {
        return None;
    }
    let apart_km = |Both { given: [x, y], recorded: [longitude, latitude] }: &Both| {
        // Along the chord.
        let [east, north, up] = local_from_geographic([*x, *y, 0.0], [*longitude, *latitude, 0.0]);
        0.001 * libm::hypot(libm::hypot(east, north), up)
    };
    let distance_km = median(&mut both.iter().map(apart_km).collect::<Vec<_>>()).filter(|km| *km > USUAL_KM)?;
    let slip = || {
        let definition = definition()?;
        let middle = middle_of_places(&both.iter().map(|one| one.given).collect::<Vec<_>>())?;
        let system = CoordinateSystem::new(definition.clone(), None, middle).ok()?;
        let [x, y, _] = system.coordinates([middle[0], middle[1], 0.0])?;
        let recorded: Vec<[f64; 2]> = both.iter().map(|one| one.recorded).collect();
        of_coordinates(&definition, [x, y], &recorded, 0.0)
    };
    Some(BlockWarning::PositionsElsewhere { images: both.len(), distance_km, place_slip: slip(), in_crs })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is said of a table in a system that has images about 8° and 50° there.
    fn told(crs: &str, given: impl Fn([f64; 2]) -> [f64; 2]) -> String {
        let recorded = (0..6).map(|k| [8.0 + 0.001 * f64::from(k % 3), 50.0 + 0.001 * f64::from(k / 3)]);
        let both: Vec<Both> = recorded.map(|recorded| Both { given: given(recorded), recorded }).collect();
        elsewhere(&both, both.len(), crs != GEOGRAPHIC, || Definition::read(crs).ok())
            .map_or_else(String::new, |warning| warning.to_string())
    }

    #[test]
    fn positions_of_a_table_lie_where_their_images_record_theirs_or_it_is_said_what_brings_them_there() {
        // Receivers err by metres.
        assert_eq!(told("EPSG:4326", |[x, y]| [x + 0.0003, y - 0.0003]), "");
        // The same eastings and northings in the zone beside theirs.
        let in_zone = |crs: &str, [x, y]: [f64; 2]| {
            let system = |crs: &str| CoordinateSystem::new(Definition::read(crs).unwrap(), None, [8.0, 50.0]).unwrap();
            let plane = system("EPSG:25832").coordinates([x, y, 0.0]).unwrap();
            let there = CoordinateSystem::about(Definition::read(crs).unwrap(), None, [plane[0], plane[1]]).unwrap();
            let [longitude, latitude, _] = there.geographic(plane).unwrap();
            [longitude, latitude]
        };
        let zone = told("EPSG:25833", |place| in_zone("EPSG:25833", place));
        assert!(zone.contains("4") && zone.contains("km from those that the files of 6 images record"), "{zone}");
        assert!(zone.contains("In zone 32 of UTM that would be the place"), "{zone}");
        let exchanged = told("EPSG:4326", |[x, y]| [y, x]);
        assert!(exchanged.contains("With x and y exchanged"), "{exchanged}");
        let sign = told("EPSG:4326", |[x, y]| [-x, y]);
        assert!(sign.contains("With x = 8.001 in the middle that would be the place"), "{sign}");
        let other = told("EPSG:4326", |[x, y]| [x + 0.3, y - 1.1]);
        assert!(other.ends_with("Are they of these images, or are those of the files wrong?"), "{other}");
        let named = told("EPSG:25832", |[x, y]| [x + 0.3, y - 1.1]);
        assert!(named.ends_with("Are they of these images and in the system that is named, or are those of the files wrong?"), "{named}");
    }

    #[test]
    fn positions_of_few_files_say_nothing_and_those_nearby_make_no_block_weak() {
        let warning = |images: usize, given: usize, away_deg: f64| {
            let both: Vec<Both> = (0..images).map(|_| Both { given: [8.0, 50.0 + away_deg], recorded: [8.0, 50.0] }).collect();
            elsewhere(&both, given, false, || Definition::read(GEOGRAPHIC).ok())
        };
        assert!(warning(2, 2, 0.1).is_none() && warning(3, 7, 0.1).is_none());
        let is_weak = |away_deg: f64| warning(3, 6, away_deg).map(|warning| warning.is_weakness());
        // 0.6 km and 11 km.
        assert_eq!([0.0054, 0.1].map(is_weak), [Some(false), Some(true)]);
    }
}
