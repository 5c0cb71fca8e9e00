//! GNSS positions of images, as the reconstruction takes them.

use super::positions::GivenPosition;
use super::result::RunImage;
use crate::{ExifImage, ExifPosition, GeoreferencingOptions, ObservedPosition, RtkSolution};

/// Standard errors in m below which those of an RTK solution are not believed: the exposure and the antenna's place have their own.
const LEAST_RTK_M: f64 = 0.02;

/// The flag of a receiver that has a position at all.
const LEAST_RTK_FLAG: u8 = 16;

/// The GNSS position of an image as an observation: that of a table, else that of its file. `has_heights`: whether its height counts from where others of
/// the block do.
pub(super) fn observed_position(image: &RunImage, placing: &GeoreferencingOptions, has_heights: bool) -> Option<ObservedPosition> {
    let rtk = image.exif.drone.as_ref().and_then(|drone| drone.rtk.as_ref());
    match &image.given {
        Some(given) => Some(given_observation(given, placing, has_heights)),
        None => image.exif.position.as_ref().map(|position| gnss_observation(position, rtk, placing, has_heights)),
    }
}

/// The standard error of the height of an image that is placed by itself, as a block would take it; absent where neither table nor file states one.
pub(crate) fn stated_height_error(given: Option<&GivenPosition>, exif: &ExifImage) -> Option<f64> {
    let placing = GeoreferencingOptions::default();
    let rtk = exif.drone.as_ref().and_then(|drone| drone.rtk.as_ref());
    let stated = match given {
        Some(given) => stated_by_table(given, &placing),
        None => exif.position.as_ref().and_then(|position| stated_by_receiver(position, rtk, &placing)),
    };
    stated.map(|[.., up]| up)
}

/// The position of a table as an observation.
fn given_observation(given: &GivenPosition, placing: &GeoreferencingOptions, has_heights: bool) -> ObservedPosition {
    let sigma_m = stated_by_table(given, placing).unwrap_or(usual(placing));
    observation(&given.position, sigma_m, has_heights)
}

/// A GNSS position as an observation.
fn gnss_observation(
    position: &ExifPosition,
    rtk: Option<&RtkSolution>,
    placing: &GeoreferencingOptions,
    has_heights: bool,
) -> ObservedPosition {
    let sigma_m = stated_by_receiver(position, rtk, placing).unwrap_or(usual(placing));
    observation(position, sigma_m, has_heights)
}

/// `has_heights`: whether its height counts from where others of the block do.
fn observation(position: &ExifPosition, sigma_m: [f64; 3], has_heights: bool) -> ObservedPosition {
    let ExifPosition { longitude_deg, latitude_deg, height_m, .. } = *position;
    ObservedPosition::Geographic { longitude_deg, latitude_deg, height_m: height_m.filter(|_| has_heights), sigma_m }
}

/// Standard errors of a position of which nothing states them.
fn usual(placing: &GeoreferencingOptions) -> [f64; 3] {
    [placing.receiver_across_m, placing.receiver_across_m, placing.receiver_up_m]
}

/// Those of a place that is known to so many metres: the height is less sure by the same factor as without a statement.
fn by_place(across: f64, placing: &GeoreferencingOptions) -> [f64; 3] {
    [across, across, placing.receiver_up_m * (across / placing.receiver_across_m)]
}

/// Standard errors that a table states count as those of an RTK solution.
fn stated_by_table(given: &GivenPosition, placing: &GeoreferencingOptions) -> Option<[f64; 3]> {
    let [across, up] = given.standard_errors_m.map(|error| error.map(|error| error.max(LEAST_RTK_M)));
    across.or(up)?;
    let [x, y, by_place] = by_place(across.unwrap_or(placing.receiver_across_m), placing);
    Some([x, y, up.unwrap_or(by_place)])
}

/// The standard deviations of an RTK solution go first. A receiver that states its error otherwise states that of the place.
fn stated_by_receiver(position: &ExifPosition, rtk: Option<&RtkSolution>, placing: &GeoreferencingOptions) -> Option<[f64; 3]> {
    let deviations_m = rtk.filter(|rtk| rtk.flag >= LEAST_RTK_FLAG).and_then(|rtk| rtk.standard_deviations_m);
    let by_rtk = deviations_m.map(|all| all.map(|deviation| deviation.max(LEAST_RTK_M)));
    by_rtk.or_else(|| position.error_m.filter(|error| *error != 0.0).map(|across| by_place(across, placing)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn standard_errors_of_a_table_count_as_those_of_an_rtk_solution() {
        let position = ExifPosition { longitude_deg: 8.0, latitude_deg: 50.0, height_m: Some(100.0), error_m: None };
        let sigma = |standard_errors_m: [Option<f64>; 2]| {
            let given = GivenPosition { position, standard_errors_m, in_crs: false };
            match given_observation(&given, &GeoreferencingOptions::default(), true) {
                ObservedPosition::Geographic { sigma_m, .. } => sigma_m,
                ObservedPosition::Local { .. } => [f64::NAN; 3],
            }
        };
        assert_eq!(sigma([Some(0.011), Some(0.035)]), [0.02, 0.02, 0.035]);
        assert_eq!(sigma([None; 2]), [3.0, 3.0, 6.0]);
        assert_eq!(sigma([Some(0.5), None]), [0.5, 0.5, 1.0]);
        assert_eq!(sigma([None, Some(0.5)]), [3.0, 3.0, 0.5]);
    }

    #[test]
    fn a_stated_error_counts_for_the_height_too() {
        let position = ExifPosition { longitude_deg: 8.0, latitude_deg: 50.0, height_m: Some(100.0), error_m: Some(1.5) };
        let placing = GeoreferencingOptions::default();
        assert!(matches!(gnss_observation(&position, None, &placing, true), ObservedPosition::Geographic { sigma_m: [1.5, 1.5, 3.0], .. }));
        let silent = ExifPosition { error_m: None, ..position };
        assert!(matches!(gnss_observation(&silent, None, &placing, true), ObservedPosition::Geographic { sigma_m: [3.0, 3.0, 6.0], .. }));
        let fixed = RtkSolution { flag: 50, standard_deviations_m: Some([0.011, 0.012, 0.035]) };
        let by_rtk = gnss_observation(&position, Some(&fixed), &placing, true);
        assert!(matches!(by_rtk, ObservedPosition::Geographic { sigma_m: [0.02, 0.02, 0.035], .. }), "{by_rtk:?}");
        let none = RtkSolution { flag: 0, ..fixed };
        assert_eq!(gnss_observation(&position, Some(&none), &placing, true), gnss_observation(&position, None, &placing, true));
        let unstated = RtkSolution { standard_deviations_m: None, ..fixed };
        assert_eq!(gnss_observation(&position, Some(&unstated), &placing, true), gnss_observation(&position, None, &placing, true));
    }

    #[test]
    fn the_height_of_an_image_by_itself_is_as_precise_as_something_states_it() {
        let position = ExifPosition { longitude_deg: 8.0, latitude_deg: 50.0, height_m: Some(100.0), error_m: None };
        let of_file = |error_m: Option<f64>, deviations: Option<[f64; 3]>| {
            let rtk = deviations.map(|all| RtkSolution { flag: 50, standard_deviations_m: Some(all) });
            let drone = rtk.map(|rtk| Box::new(crate::DroneRecord { rtk: Some(rtk), ..crate::DroneRecord::default() }));
            ExifImage { position: Some(ExifPosition { error_m, ..position }), drone, ..ExifImage::default() }
        };
        let fixed = of_file(None, Some([0.011, 0.012, 0.035]));
        let said = [of_file(None, None), of_file(Some(0.4), None), fixed.clone()].map(|exif| stated_height_error(None, &exif));
        assert_eq!(said, [None, Some(0.8), Some(0.035)]);
        // A table goes before the file.
        let given = |standard_errors_m| GivenPosition { position, standard_errors_m, in_crs: false };
        let said = [[None; 2], [None, Some(0.05)], [Some(0.4), None]].map(|all| stated_height_error(Some(&given(all)), &fixed));
        assert_eq!(said, [None, Some(0.05), Some(0.8)]);
    }
}
