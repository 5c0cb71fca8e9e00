//! The place of an image that records its position: near that first, then anywhere.

use super::adjusting::PlacingCamera;
use super::into_system::{RecordedPlace, recorded_place};
use super::options::PlacingOptions;
use super::outcome::{PlaceSearch, PlacedImage, PlacingVerdict, PlacingWeakness};
use super::place::place_image;
use super::recorded_height::{HeightApart, RecordedHeight};
use super::recorded_position::RecordedPosition;
use super::reference::Orthophoto;
use super::search_area::SearchArea;
use crate::{Error, GreyView};

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
    let Some(on_map) = on_map(position, reference, options) else { return place(area) };
    let RecordedPlace { place: at, unit_m, .. } = on_map.place;
    let within_m = options.within_m;
    let within = within_m / unit_m;
    let about = PlacingOptions { near_x: Some(at[0]), near_y: Some(at[1]), within_m: within, ..options.clone() };
    let areas = Areas {
        all: area,
        near: area.within(reference, at, within),
        // A position beside the orthophoto has no surroundings on it.
        dense: || area.is_sparse.then(|| SearchArea::new(reference, &about).ok()).flatten(),
    };
    let placed = areas.searched(within_m, place)?;
    Ok(beside_position(placed, &on_map))
}

/// A GNSS position on an orthophoto, with its height where that is precise.
struct OnMap {
    place: RecordedPlace,
    height: Option<RecordedHeight>,
}

/// Where an orthophoto has the position of an image, unless another place is given by the options, which goes before it.
fn on_map(position: Option<&RecordedPosition>, reference: &Orthophoto, options: &PlacingOptions) -> Option<OnMap> {
    let is_free = options.near_x.is_none() && options.near_y.is_none();
    let position = position.filter(|_| is_free)?;
    let place = recorded_place(&position.position, reference)?;
    let height = RecordedHeight::of(position, reference, options, place.unit_m);
    Some(OnMap { place, height })
}

/// An image that was placed without a search, judged beside its position as one that was sought.
pub(super) fn judged(
    placed: PlacedImage,
    position: Option<&RecordedPosition>,
    reference: &Orthophoto,
    options: &PlacingOptions,
) -> PlacedImage {
    match on_map(position, reference, options) {
        Some(on_map) => beside_position(placed, &on_map),
        None => placed,
    }
}

/// Receivers of cameras are right to some 10 m: three times that, or what they state themselves, are no usual error.
const USUAL_M: f64 = 30.0;
const STATED: f64 = 3.0;

/// With how far the image was placed from its position in plan: heights of another ground and another system of the orthophoto show there alone. Where it is
/// farther than both may err, or higher or lower than a precise position, it is placed with doubt.
fn beside_position(placed: PlacedImage, OnMap { place, height }: &OnMap) -> PlacedImage {
    let Some(placement) = &placed.placement else { return placed };
    let [x, y] = [0, 1].map(|k| placement.pose.position[k] - place.place[k]);
    let plan_m = place.unit_m * libm::hypot(x, y);
    let own_m = placement.position_errors_m.map_or(0.0, |[x, y, _]| place.unit_m * libm::hypot(x, y));
    let usual_m = libm::hypot(USUAL_M.max(STATED * place.stated_m.unwrap_or(0.0)), STATED * own_m);
    let apart = height.as_ref().and_then(|height| height.apart(placement, place.unit_m));
    let search = match placed.search {
        Some(PlaceSearch::Gnss { within_m, .. }) => Some(PlaceSearch::Gnss { within_m, plan_m }),
        other => other,
    };
    match placed.verdict {
        PlacingVerdict::Placed { links, .. } if plan_m > usual_m => {
            let verdict = PlacingVerdict::Weak { links, placing_weakness: PlacingWeakness::Gnss { plan_m, usual_m } };
            PlacedImage { verdict, search, ..placed }
        }
        // What is doubted already says its own reason first.
        _ if plan_m > usual_m => PlacedImage { search: Some(PlaceSearch::ApartFromGnss { plan_m, usual_m }), ..placed },
        verdict => match (verdict, apart) {
            (PlacingVerdict::Placed { links, .. }, Some(HeightApart { height_m, usual_m })) => {
                let verdict = PlacingVerdict::Weak { links, placing_weakness: PlacingWeakness::GnssHeight { height_m, usual_m } };
                PlacedImage { verdict, search, ..placed }
            }
            (verdict, Some(HeightApart { height_m, usual_m })) => {
                PlacedImage { verdict, search: Some(PlaceSearch::HeightApartFromGnss { height_m, usual_m }), ..placed }
            }
            (verdict, None) => PlacedImage { verdict, search, ..placed },
        },
    }
}

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
    use crate::{Camera, Feature, Pose, ScalePoint};

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

    #[test]
    fn an_image_far_from_its_gnss_position_is_placed_with_doubt_unless_either_may_be_as_far_off() {
        let sure = || PlacingVerdict::Placed { links: 400, sigma0_px: 0.3, half_width_m: 0.2 };
        let of = |plan_m: f64, errors: Option<[f64; 3]>, unit_m: f64, stated_m: Option<f64>| {
            let on_map = RecordedPlace { place: [1000.0, 2000.0], unit_m, stated_m };
            let placed = placed_at([1000.0 + 0.6 * plan_m / unit_m, 2000.0 - 0.8 * plan_m / unit_m, 600.0], errors, sure());
            beside_position(placed, &OnMap { place: on_map, height: None })
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
            (of(58.0, Some([12.0; 3]), 1.0, None), libm::hypot(30.0, 36.0 * std::f64::consts::SQRT_2)),
        ] {
            assert_eq!(placed.verdict, sure(), "{limit_m}");
        }
        for placed in [of(61.0, Some([0.1; 3]), 1.0, Some(20.0)), of(60.0, Some([12.0; 3]), 1.0, None)] {
            assert!(matches!(placed.verdict, PlacingVerdict::Weak { .. }), "{}", placed.verdict);
        }
        // Another doubt stays, and the distance is said beside it.
        let weak = PlacingVerdict::Weak { links: 20, placing_weakness: PlacingWeakness::FewLinks { links: 20, needed: 30 } };
        let on_map = RecordedPlace { place: [0.0, 0.0], unit_m: 1.0, stated_m: None };
        let doubted = beside_position(placed_at([400.0, 0.0, 600.0], Some([0.1; 3]), weak.clone()), &OnMap { place: on_map, height: None });
        assert_eq!(doubted.verdict, weak);
        assert!(matches!(doubted.search, Some(PlaceSearch::ApartFromGnss { plan_m: 400.0, .. })), "{:?}", doubted.search);
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
