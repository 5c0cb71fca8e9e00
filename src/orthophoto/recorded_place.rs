//! The place of an image that records its position: near that first, then anywhere.

use super::adjusting::PlacingCamera;
use super::into_system::{RecordedPlace, recorded_place};
use super::options::PlacingOptions;
use super::outcome::{PlaceSearch, PlacedImage, Placement, PlacingVerdict, PlacingWeakness};
use super::place::place_image;
use super::recorded_height::{HeightApart, RecordedHeight};
use super::recorded_position::RecordedPosition;
use super::reference::Orthophoto;
use super::search_area::SearchArea;
use crate::{Error, ExifPosition, GreyView};

/// Places an image that records a GNSS position: about that first, within `within_m`, where the orthophoto says its system and no other place is
/// given by the options, then anywhere. The result says which.
///
/// # Errors
/// As [`place_image`].
pub fn place_recorded(
    image: GreyView<'_>,
    known: &PlacingCamera,
    position: Option<&RecordedPosition>,
    reference: &Orthophoto,
    area: &SearchArea,
    options: &PlacingOptions,
) -> Result<PlacedImage, Error> {
    sought(position, reference, area, options, |area| place_image(image, known, reference, area, options))
}

/// Has an image that may record a position placed in one area after the other, as [`place_recorded`] does.
pub(super) fn sought(
    position: Option<&RecordedPosition>,
    reference: &Orthophoto,
    area: &SearchArea,
    options: &PlacingOptions,
    mut place: impl FnMut(&SearchArea) -> Result<PlacedImage, Error>,
) -> Result<PlacedImage, Error> {
    let Some(recorded) = Recorded::of(position, reference, options) else { return place(area) };
    let within_m = options.within_m;
    let Some(RecordedPlace { place: at, unit_m, .. }) = recorded.on_map else {
        let placed = PlacedImage { search: Some(PlaceSearch::BeyondGnss { within_m }), ..place(area)? };
        return Ok(recorded.beside(placed));
    };
    let within = within_m / unit_m;
    let about = PlacingOptions { near_x: Some(at[0]), near_y: Some(at[1]), within_m: within, ..options.clone() };
    let areas = Areas {
        all: area,
        near: area.within(reference, at, within),
        // A position beside the orthophoto has no surroundings on it.
        dense: || area.is_sparse.then(|| SearchArea::new(reference, &about).ok()).flatten(),
    };
    let placed = areas.searched(within_m, place)?;
    Ok(recorded.beside(placed))
}

/// The position of an image beside an orthophoto whose system is known.
pub(super) struct Recorded<'a> {
    position: &'a ExifPosition,
    reference: &'a Orthophoto,
    /// Absent where it lies outside of that system.
    on_map: Option<RecordedPlace>,
    height: Option<RecordedHeight>,
}

impl<'a> Recorded<'a> {
    /// Absent where another place is given by the options, which goes before it.
    pub fn of(position: Option<&'a RecordedPosition>, reference: &'a Orthophoto, options: &PlacingOptions) -> Option<Self> {
        let is_free = options.near_x.is_none() && options.near_y.is_none();
        let recorded = position.filter(|_| is_free && reference.is_on_earth())?;
        let on_map = recorded_place(&recorded.position, reference);
        let height = on_map.as_ref().and_then(|on_map| RecordedHeight::of(recorded, reference, options, on_map.unit_m));
        Some(Self { position: &recorded.position, reference, on_map, height })
    }

    /// An image that was placed, with how far that is from its position in plan: heights of another ground and another system of the orthophoto show there
    /// alone. Where it is farther than both may err, it is placed with doubt.
    fn beside(&self, placed: PlacedImage) -> PlacedImage {
        let of_placement = |placement: &Placement| self.apart(placement.pose.position, placement.position_errors_m);
        let Some((plan_m, usual_m, place)) = placed.placement.as_ref().and_then(of_placement) else { return placed };
        let search = match placed.search {
            Some(PlaceSearch::Gnss { within_m, .. }) => Some(PlaceSearch::Gnss { within_m, plan_m }),
            other => other,
        };
        if !(plan_m > usual_m) {
            return self.beside_height(PlacedImage { search, ..placed });
        }
        let far = (plan_m > FAR_M).then(|| (0.001 * plan_m, self.reference.slip(place, std::slice::from_ref(self.position), 0.0)));
        match (placed.verdict, far) {
            (PlacingVerdict::Placed { links, .. }, far) => {
                let placing_weakness = match far {
                    Some((distance_km, place_slip)) => PlacingWeakness::FarFromGnss { distance_km, place_slip },
                    None => PlacingWeakness::Gnss { plan_m, usual_m },
                };
                PlacedImage { verdict: PlacingVerdict::Weak { links, placing_weakness }, search, ..placed }
            }
            // What is doubted already says its own reason first.
            (verdict, Some((distance_km, place_slip))) => {
                PlacedImage { verdict, search: Some(PlaceSearch::FarFromGnss { distance_km, place_slip }), ..placed }
            }
            (verdict, None) => PlacedImage { verdict, search: Some(PlaceSearch::ApartFromGnss { plan_m, usual_m }), ..placed },
        }
    }

    /// An image that lies near its position in plan: where it is higher or lower than that, it is placed with doubt.
    fn beside_height(&self, placed: PlacedImage) -> PlacedImage {
        let of_placement = |placement: &Placement| self.height_apart(placement.pose.position, placement.position_errors_m);
        let Some(HeightApart { height_m, usual_m }) = placed.placement.as_ref().and_then(of_placement) else { return placed };
        match placed.verdict {
            PlacingVerdict::Placed { links, .. } => {
                let verdict = PlacingVerdict::Weak { links, placing_weakness: PlacingWeakness::GnssHeight { height_m, usual_m } };
                PlacedImage { verdict, ..placed }
            }
            // What is doubted already says its own reason first.
            verdict => PlacedImage { verdict, search: Some(PlaceSearch::HeightApartFromGnss { height_m, usual_m }), ..placed },
        }
    }

    /// How far an image at this place lies from its position in plan and how far it may lie from it, in m, and where it is. Absent where nothing says the first:
    /// the orthophoto is nowhere on the earth in its own system. `errors`: standard errors of the place.
    pub fn apart(&self, [x, y, _]: [f64; 3], errors: Option<[f64; 3]>) -> Option<(f64, f64, [f64; 2])> {
        let (plan_m, unit_m) = match &self.on_map {
            Some(RecordedPlace { place, unit_m }) => (unit_m * libm::hypot(x - place[0], y - place[1]), *unit_m),
            None => (self.reference.distance_on_earth_m([x, y], self.position)?, self.reference.unit_m()?),
        };
        Some((plan_m, usual_m(self.position, errors.map(|errors| errors.map(|error| unit_m * error))), [x, y]))
    }

    /// How far an image at this place lies above its position, where that is beyond what both may be off. Absent where nothing says it.
    pub fn height_apart(&self, [_, _, height]: [f64; 3], errors: Option<[f64; 3]>) -> Option<HeightApart> {
        self.height.as_ref()?.apart(height, errors?[2], self.on_map.as_ref()?.unit_m)
    }
}

/// How far from its position an image may lie in plan. `errors_m`: standard errors of its place.
pub(super) fn usual_m(position: &ExifPosition, errors_m: Option<[f64; 3]>) -> f64 {
    let own_m = errors_m.map_or(0.0, |[x, y, _]| libm::hypot(x, y));
    libm::hypot(USUAL_M.max(STATED * position.error_m.unwrap_or(0.0)), STATED * own_m)
}

/// An image that was placed without a search, judged beside its position as one that was sought.
pub(super) fn judged(
    placed: PlacedImage,
    position: Option<&RecordedPosition>,
    reference: &Orthophoto,
    options: &PlacingOptions,
) -> PlacedImage {
    match Recorded::of(position, reference, options) {
        Some(recorded) => recorded.beside(placed),
        None => placed,
    }
}

/// Receivers of cameras are right to some 10 m: three times that, or what they state themselves, are no usual error.
const USUAL_M: f64 = 30.0;
const STATED: f64 = 3.0;
/// Beyond this, and what it states, no receiver is wrong by itself: one of the two is of elsewhere.
const FAR_M: f64 = 5_000.0;

/// Where an image that records its position is sought.
struct Areas<'a, D: FnOnce() -> Option<SearchArea>> {
    all: &'a SearchArea,
    /// The surroundings of the position; absent where they are all.
    near: Option<SearchArea>,
    /// The same with more features, where there may be more.
    dense: D,
}

impl<D: FnOnce() -> Option<SearchArea>> Areas<'_, D> {
    /// One after the other until the image is found, each once.
    fn searched(self, within_m: f64, mut search: impl FnMut(&SearchArea) -> Result<PlacedImage, Error>) -> Result<PlacedImage, Error> {
        let Self { all, near, dense } = self;
        let found = |placed: &PlacedImage| placed.placement.is_some();
        let of = |placed: PlacedImage, search: PlaceSearch| Ok(PlacedImage { search: Some(search), ..placed });
        // Where the surroundings are all, the search of them is that of all.
        let mut of_all = None;
        if near.as_ref().is_none_or(|near| !near.features.is_empty()) {
            let placed = search(near.as_ref().unwrap_or(all))?;
            if found(&placed) {
                return of(placed, PlaceSearch::Gnss { within_m, plan_m: 0.0 });
            }
            of_all = near.is_none().then_some(placed);
        }
        if let Some(dense) = dense() {
            let placed = search(&dense)?;
            if found(&placed) {
                return of(placed, PlaceSearch::Gnss { within_m, plan_m: 0.0 });
            }
        }
        let placed = of_all.map_or_else(|| search(all), Ok)?;
        of(placed, PlaceSearch::BeyondGnss { within_m })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::orthophoto::outcome::{NotPlaced, Placement};
    use crate::orthophoto::relief::Relief;
    use crate::{Camera, Feature, Georeference, GreyImage, Heights, PlaceSlip, Pose, ScalePoint};

    /// An image with that position and standard errors in m, judged as given.
    fn placed_at(position: [f64; 3], errors: Option<[f64; 3]>, verdict: PlacingVerdict) -> PlacedImage {
        let placement = Placement {
            camera: Camera::without_distortion(800, 600, 1000.0),
            camera_errors: [None; 8],
            pose: Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], position },
            angles_deg: [0.0; 3],
            angle_errors_deg: None,
            position_errors_m: errors,
            above_ground_m: 500.0,
            gsd_m: 0.5,
            footprint: Vec::new(),
            sigma0_px: None,
            rmse_px: 0.2,
            degrees_of_freedom: 100,
            coverage: 1.0,
            links: Vec::new(),
            checks: None,
            relief: Relief::default(),
            film: None,
        };
        PlacedImage { verdict, placement: Some(placement), search: Some(PlaceSearch::Gnss { within_m: 500.0, plan_m: 0.0 }) }
    }

    /// An orthophoto in zone 32 of UTM, whose images are about 8° and 50°.
    fn reference(epsg: u16) -> Orthophoto {
        let grey = GreyImage::from_fn(64, 64, |_, _| 90).unwrap();
        let mut reference = Orthophoto::new(grey, Georeference::north_up(AT, 1.0), Heights::Level(0.0)).unwrap();
        reference.epsg = Some(epsg);
        reference
    }

    /// 8° and 50° in EPSG:25832 and in EPSG:32632.
    const AT: [f64; 2] = [428_333.552_5, 5_539_109.814_8];

    fn recorded(longitude_deg: f64, latitude_deg: f64, error_m: Option<f64>) -> ExifPosition {
        ExifPosition { longitude_deg, latitude_deg, height_m: Some(600.0), error_m }
    }

    #[test]
    fn an_image_far_from_its_gnss_position_is_placed_with_doubt_unless_either_may_be_as_far_off() {
        let sure = || PlacingVerdict::Placed { links: 400, sigma0_px: 0.3, half_width_m: 0.2 };
        let reference = reference(25_832);
        let at = |plan_m: f64, unit_m: f64| [1000.0 + 0.6 * plan_m / unit_m, 2000.0 - 0.8 * plan_m / unit_m, 600.0];
        let beside = |placed: PlacedImage, unit_m: f64, error_m: Option<f64>| {
            let on_map = Some(RecordedPlace { place: [1000.0, 2000.0], unit_m });
            Recorded { position: &recorded(8.0, 50.0, error_m), reference: &reference, on_map, height: None }.beside(placed)
        };
        let of = |plan_m: f64, errors: Option<[f64; 3]>, unit_m: f64, error_m: Option<f64>| {
            beside(placed_at(at(plan_m, unit_m), errors, sure()), unit_m, error_m)
        };
        let near = of(29.0, Some([0.1; 3]), 1.0, None);
        assert_eq!(near.verdict, sure());
        assert!(matches!(near.search, Some(PlaceSearch::Gnss { plan_m, .. }) if (plan_m - 29.0).abs() < 1e-9), "{:?}", near.search);
        for unit_m in [1.0, 0.3048] {
            let far = of(31.0, Some([0.1; 3]), unit_m, None);
            let PlacingVerdict::Weak { links: 400, placing_weakness: PlacingWeakness::Gnss { plan_m, usual_m } } = far.verdict else {
                panic!("{}", far.verdict)
            };
            assert!((plan_m - 31.0).abs() < 1e-9 && (30.0..30.1).contains(&usual_m), "{plan_m} {usual_m}");
            // How it was sought is said beside it.
            assert!(matches!(far.search, Some(PlaceSearch::Gnss { within_m: 500.0, .. })), "{:?}", far.search);
        }
        // A receiver that states more, and a place that is hardly known: 3 · hypot(12, 12) m beside 30 m.
        for (placed, limit_m) in [
            (of(59.0, Some([0.1; 3]), 1.0, Some(20.0)), 60.0),
            (of(5900.0, Some([0.1; 3]), 1.0, Some(2000.0)), 6000.0),
            (of(58.0, Some([12.0; 3]), 1.0, None), libm::hypot(30.0, 36.0 * std::f64::consts::SQRT_2)),
        ] {
            assert_eq!(placed.verdict, sure(), "{limit_m}");
        }
        for placed in [of(61.0, Some([0.1; 3]), 1.0, Some(20.0)), of(60.0, Some([12.0; 3]), 1.0, None)] {
            assert!(matches!(placed.verdict, PlacingVerdict::Weak { .. }), "{}", placed.verdict);
        }
        // Another doubt stays, and the distance is said beside it.
        let weak = PlacingVerdict::Weak { links: 20, placing_weakness: PlacingWeakness::FewLinks { links: 20, needed: 30 } };
        for (plan_m, is_far) in [(400.0, false), (8000.0, true)] {
            let doubted = beside(placed_at(at(plan_m, 1.0), Some([0.1; 3]), weak.clone()), 1.0, None);
            assert_eq!(doubted.verdict, weak);
            let is_said = match doubted.search {
                Some(PlaceSearch::ApartFromGnss { plan_m: apart_m, .. }) => !is_far && (apart_m - plan_m).abs() < 1e-6,
                Some(PlaceSearch::FarFromGnss { distance_km, .. }) => is_far && (1000.0 * distance_km - plan_m).abs() < 1e-6,
                _ => false,
            };
            assert!(is_said, "{:?}", doubted.search);
        }
    }

    #[test]
    fn an_image_of_elsewhere_is_doubted_with_the_slip_also_where_its_position_lies_outside_the_system() {
        // Placed where it was taken, as the orthophoto has it: ETRS89 has no operation outside of Europe, WGS 84 everywhere.
        let judged = |epsg: u16, at: [f64; 2], position: ExifPosition| {
            let sure = PlacingVerdict::Placed { links: 400, sigma0_px: 0.3, half_width_m: 0.2 };
            let placed = PlacedImage { search: None, ..placed_at([at[0], at[1], 600.0], Some([0.1; 3]), sure) };
            judged(placed, Some(&position.into()), &reference(epsg), &PlacingOptions::default()).verdict
        };
        let far = |epsg: u16, at: [f64; 2], position: ExifPosition| match judged(epsg, at, position) {
            PlacingVerdict::Weak { placing_weakness: PlacingWeakness::FarFromGnss { distance_km, place_slip }, .. } => {
                (distance_km, place_slip)
            }
            other => panic!("{other}"),
        };
        for epsg in [25_832, 32_632] {
            assert!(matches!(judged(epsg, AT, recorded(8.0, 50.0, None)), PlacingVerdict::Placed { .. }), "{epsg}");
            for (position, slip) in [
                (recorded(50.0, 8.0, None), PlaceSlip::ExchangedPositions),
                (recorded(8.0, -50.0, None), PlaceSlip::LatitudeSign),
                (recorded(-8.0, 50.0, None), PlaceSlip::LongitudeSign),
                (recorded(-120.0, -40.0, None), PlaceSlip::Unknown),
            ] {
                let (distance_km, place_slip) = far(epsg, AT, position);
                assert!(place_slip == slip && distance_km > 500.0, "{epsg}: {distance_km} {place_slip:?}");
            }
        }
        let here = || recorded(8.0, 50.0, None);
        assert_eq!(far(25_832, [AT[1], AT[0]], here()).1, PlaceSlip::Exchanged);
        assert_eq!(far(32_732, AT, here()).1, PlaceSlip::OtherHalf);
        let (distance_km, place_slip) = far(25_833, AT, here());
        assert!(place_slip == PlaceSlip::Zone { zone: 32 } && (400.0..450.0).contains(&distance_km), "{distance_km}");
    }

    #[test]
    fn each_part_of_an_orthophoto_is_searched_once_for_an_image() {
        let empty = || SearchArea { features: Vec::new(), area_px2: 1.0, is_sparse: true };
        let all = SearchArea { area_px2: 9.0, ..empty() };
        let dense = || Some(SearchArea { area_px2: 2.0, ..empty() });
        let nowhere = || PlacedImage {
            verdict: PlacingVerdict::NotPlaced { not_placed: NotPlaced::NoOrientation { points: 0 } },
            placement: None,
            search: None,
        };
        let searched = |near: Option<SearchArea>, dense: Option<SearchArea>| {
            let mut areas = Vec::new();
            let search = |area: &SearchArea| {
                areas.push(area.area_px2);
                Ok(nowhere())
            };
            let placed = Areas { all: &all, near, dense: || dense }.searched(50.0, search).unwrap();
            assert_eq!(placed.search, Some(PlaceSearch::BeyondGnss { within_m: 50.0 }));
            areas
        };
        // All are the surroundings; they are a part; nothing is there.
        assert_eq!((searched(None, dense()), searched(None, None)), (vec![9.0, 2.0], vec![9.0]));
        let point = ScalePoint { x: 1.0, y: 1.0, scale_px: 2.0, weight: 1.0 };
        let feature = Feature { point, orientation_rad: 0.0, descriptor: [0; 128] };
        let some = SearchArea { features: vec![feature], area_px2: 3.0, ..empty() };
        assert_eq!((searched(Some(some.clone()), dense()), searched(Some(some), None)), (vec![3.0, 2.0, 9.0], vec![3.0, 9.0]));
        assert_eq!(searched(Some(empty()), dense()), [2.0, 9.0]);
    }
}
