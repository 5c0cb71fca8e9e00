//! Whether images are of elsewhere than an orthophoto, by the GNSS positions that they record: said before anything is matched.

use super::into_system::recorded_place;
use super::options::PlacingOptions;
use super::reference::Orthophoto;
use crate::crs::CoordinateSystem;
use crate::math::dot3;
use crate::pipeline::place_slip;
use crate::{ExifPosition, PlaceSlip, Remark, local_from_geographic};

impl Orthophoto {
    /// Whether it says a system that is known here, so that places on the earth are led into it.
    pub fn is_on_earth(&self) -> bool {
        self.units_m().is_some()
    }

    /// What is to be said where the orthophoto says its system and none of these GNSS positions lies within `within_m` of it: how far off the nearest is, and
    /// what would bring the orthophoto to them. `None` where one lies there, where a place near the images is given by the options, and where nothing says
    /// where both are. It is a doubt: images are sought on all of the orthophoto in any case.
    pub fn elsewhere(&self, positions: &[ExifPosition], options: &PlacingOptions) -> Option<Remark> {
        if options.near_x.is_some() || options.near_y.is_some() {
            return None;
        }
        let within_m = options.within_m;
        let mut nearest_m = None;
        for position in positions {
            let away_m = self.away_m(position)?;
            if away_m <= within_m {
                return None;
            }
            nearest_m = Some(nearest_m.map_or(away_m, |nearest: f64| nearest.min(away_m)));
        }
        let distance_km = 0.001 * nearest_m?;
        let definition = self.said().definition()?;
        let place_slip = self.slip(self.middle(), positions, 0.5 * self.diagonal_m()?);
        let (images, crs) = (positions.len(), self.said().name().unwrap_or_else(|| definition.name()));
        Some(Remark::OrthophotoElsewhere { images, within_m, distance_km, crs, place_slip })
    }

    /// What would bring a place of it, and what lies about that within `extent_m`, to these positions.
    pub(super) fn slip(&self, place: [f64; 2], positions: &[ExifPosition], extent_m: f64) -> PlaceSlip {
        let gnss: Vec<[f64; 2]> = positions.iter().map(|position| [position.longitude_deg, position.latitude_deg]).collect();
        let known = self.said().definition().zip(self.in_system(place));
        known.and_then(|(definition, place)| place_slip(&definition, place, &gnss, extent_m)).unwrap_or(PlaceSlip::Unknown)
    }

    /// The distance of a position from the picture in plan; on it 0. Absent where nothing says it.
    fn away_m(&self, position: &ExifPosition) -> Option<f64> {
        let Some(recorded) = recorded_place(position, self) else { return self.distance_on_earth_m(self.middle(), position) };
        let at = self.georeference.pixel(recorded.place);
        let size = self.size().map(|side| side as f64);
        let off = [0, 1].map(|k| at[k] - at[k].clamp(0.0, size[k]));
        Some(recorded.unit_m * self.georeference.gsd() * libm::hypot(off[0], off[1]))
    }

    /// The distance of a position outside of its system from a place of it, along the chord.
    pub(super) fn distance_on_earth_m(&self, place: [f64; 2], position: &ExifPosition) -> Option<f64> {
        let [x, y] = self.in_system(place)?;
        let system = CoordinateSystem::about(self.said().definition()?, None, [x, y]).ok()?;
        let [longitude, latitude, _] = system.geographic([x, y, 0.0])?;
        let off = local_from_geographic([position.longitude_deg, position.latitude_deg, 0.0], [longitude, latitude, 0.0]);
        Some(dot3(&off, &off).sqrt())
    }

    fn middle(&self) -> [f64; 2] {
        self.georeference.ground(self.size().map(|side| 0.5 * side as f64))
    }

    /// A place in the unit of its system, which may not be that of the picture.
    fn in_system(&self, place: [f64; 2]) -> Option<[f64; 2]> {
        let [unit_m, own_m] = self.units_m()?;
        Some(place.map(|v| v * unit_m / own_m))
    }

    fn diagonal_m(&self) -> Option<f64> {
        let unit_m = self.unit_m()?;
        let [width, height] = self.size().map(|side| side as f64);
        Some(unit_m * self.georeference.gsd() * libm::hypot(width, height))
    }

    /// The unit of the picture in m.
    pub(super) fn unit_m(&self) -> Option<f64> {
        Some(self.units_m()?[0])
    }

    /// The units of the picture and of its system in m.
    fn units_m(&self) -> Option<[f64; 2]> {
        let said = self.said();
        let own_m = said.definition()?.unit_m()?;
        Some([said.unit_m.unwrap_or(own_m), own_m])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::crs::Definition;
    use crate::{Georeference, GreyImage, Heights};

    /// Places on the earth about which images were taken.
    const AT: [f64; 2] = [8.0, 50.0];

    fn position([longitude_deg, latitude_deg]: [f64; 2]) -> ExifPosition {
        ExifPosition { longitude_deg, latitude_deg, height_m: Some(600.0), error_m: None }
    }

    fn coordinates(epsg: u16, place: [f64; 2]) -> [f64; 2] {
        let definition = Definition::read(&format!("EPSG:{epsg}")).unwrap();
        let [x, y, _] = CoordinateSystem::new(definition, None, place).unwrap().coordinates([place[0], place[1], 0.0]).unwrap();
        [x, y]
    }

    /// An orthophoto of 400 m a side with that middle, which says that code.
    fn orthophoto(epsg: u16, [x, y]: [f64; 2]) -> Orthophoto {
        let grey = GreyImage::from_fn(200, 200, |c, _| 100 + (c % 100) as u8).unwrap();
        let georeference = Georeference::north_up([x - 200.0, y + 200.0], 2.0);
        let mut orthophoto = Orthophoto::new(grey, georeference, Heights::Level(0.0)).unwrap();
        orthophoto.epsg = Some(epsg);
        orthophoto
    }

    /// What is said of images 200 m about the place.
    fn said(orthophoto: &Orthophoto) -> Option<Remark> {
        let positions = [[0.0, 0.0], [0.002, 0.0], [0.0, 0.002]].map(|[east, north]| position([AT[0] + east, AT[1] + north]));
        orthophoto.elsewhere(&positions, &PlacingOptions::default())
    }

    fn slip(orthophoto: &Orthophoto) -> PlaceSlip {
        match said(orthophoto) {
            Some(Remark::OrthophotoElsewhere { place_slip, .. }) => place_slip,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn images_on_an_orthophoto_or_near_it_are_not_doubted() {
        let [x, y] = coordinates(25_832, AT);
        // On it; 400 m beside it; its system is unknown; a place near the images is given.
        assert_eq!([said(&orthophoto(25_832, [x, y])), said(&orthophoto(25_832, [x - 700.0, y]))], [None, None]);
        let mut unknown = orthophoto(25_832, [x - 1e5, y]);
        assert!(said(&unknown).is_some());
        let near = PlacingOptions { near_x: Some(0.0), near_y: Some(0.0), ..PlacingOptions::default() };
        assert_eq!(unknown.elsewhere(&[position(AT)], &near), None);
        assert!(unknown.is_on_earth());
        unknown.epsg = None;
        assert!(!unknown.is_on_earth());
        assert_eq!((said(&unknown), orthophoto(25_832, [0.0; 2]).elsewhere(&[], &PlacingOptions::default())), (None, None));
        // One that is near is enough.
        let one = [position([AT[0] + 1.0, AT[1]]), position(AT)];
        assert_eq!(orthophoto(25_832, [x, y]).elsewhere(&one, &PlacingOptions::default()), None);
    }

    #[test]
    fn how_far_an_orthophoto_is_from_its_images_is_said_from_its_border() {
        let [x, y] = coordinates(25_832, AT);
        let Some(Remark::OrthophotoElsewhere { images: 3, within_m: 500.0, distance_km, crs, place_slip }) =
            said(&orthophoto(25_832, [x - 3200.0, y]))
        else {
            panic!("nothing is said")
        };
        assert!((distance_km - 3.0).abs() < 1e-6 && crs.contains("25832"), "{distance_km} {crs}");
        assert_eq!(place_slip, PlaceSlip::Unknown);
        // In feet of the US survey the distance is in km, too: California zone 3.
        let place = [-122.0, 37.5];
        let [x, y] = coordinates(2227, place);
        let feet = orthophoto(2227, [x - 200.0 - 10_000.0, y]);
        let Some(Remark::OrthophotoElsewhere { distance_km, .. }) = feet.elsewhere(&[position(place)], &PlacingOptions::default()) else {
            panic!("nothing is said")
        };
        assert!((distance_km - 10.0 * 1200.0 / 3937.0).abs() < 1e-6, "{distance_km}");
    }

    #[test]
    fn what_would_bring_an_orthophoto_to_its_images_is_named_and_nothing_that_does_not() {
        let [x, y] = coordinates(25_832, AT);
        for (code, zone) in [(25_833, 32), (25_831, 32)] {
            assert_eq!(slip(&orthophoto(code, [x, y])), PlaceSlip::Zone { zone });
        }
        assert_eq!(slip(&orthophoto(25_832, [y, x])), PlaceSlip::Exchanged);
        assert_eq!(slip(&orthophoto(32_732, [x, y])), PlaceSlip::OtherHalf);
        let coordinate = |likely: String| PlaceSlip::Coordinate { likely };
        assert_eq!(slip(&orthophoto(25_832, [32_000_000.0 + x.round(), y])), coordinate(format!("x = {}", x.round())));
        assert_eq!(slip(&orthophoto(25_832, [x, 0.1 * y])), coordinate(format!("y = {y}")));
        assert_eq!(slip(&orthophoto(25_832, [x / 0.3048, y / 0.3048])), PlaceSlip::Unit { given_in: "ft".into() });
        // 60 km off in every zone, and elsewhere on the earth.
        for elsewhere in [[x + 60_000.0, y], [x + 60_000.0, y + 60_000.0]] {
            assert_eq!(slip(&orthophoto(25_833, elsewhere)), PlaceSlip::Unknown);
        }
        let told = said(&orthophoto(25_833, [x, y])).unwrap().to_string();
        assert!(told.contains("500 m") && told.contains("EPSG:25833") && told.contains("zone 32"), "{told}");
    }

    #[test]
    fn images_outside_of_the_system_of_an_orthophoto_are_elsewhere_too() {
        let [x, y] = coordinates(25_832, AT);
        let there = [position([-120.0, -40.0])];
        let Some(Remark::OrthophotoElsewhere { distance_km, .. }) =
            orthophoto(25_832, [x, y]).elsewhere(&there, &PlacingOptions::default())
        else {
            panic!("nothing is said")
        };
        assert!((10_000.0..13_000.0).contains(&distance_km), "{distance_km}");
        // Latitude and longitude of the images stand in each other's place.
        let exchanged = orthophoto(25_832, [x, y]).elsewhere(&[position([AT[1], AT[0]])], &PlacingOptions::default());
        let Some(Remark::OrthophotoElsewhere { place_slip: PlaceSlip::ExchangedPositions, .. }) = exchanged else {
            panic!("{exchanged:?}")
        };
    }
}
