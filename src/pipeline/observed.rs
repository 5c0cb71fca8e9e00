//! GNSS positions of images, as the reconstruction takes them.

use super::positions::GivenPosition;
use super::result::RunImage;
use crate::{ExifPosition, GeoreferencingOptions, ObservedPosition, RtkSolution};

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

/// The position of a table as an observation. Its standard errors count as those of an RTK solution; without that of the height this is less sure by the
/// same factor as without both.
fn given_observation(given: &GivenPosition, placing: &GeoreferencingOptions, has_heights: bool) -> ObservedPosition {
    let ExifPosition { longitude_deg, latitude_deg, height_m, .. } = given.position;
    let [across, up] = given.standard_errors_m.map(|error| error.map(|error| error.max(LEAST_RTK_M)));
    let across = across.unwrap_or(placing.receiver_across_m);
    let up = up.unwrap_or(placing.receiver_up_m * (across / placing.receiver_across_m));
    let height_m = height_m.filter(|_| has_heights);
    ObservedPosition::Geographic { longitude_deg, latitude_deg, height_m, sigma_m: [across, across, up] }
}

/// A GNSS position as an observation. The standard deviations of an RTK solution go first. A receiver that states its error otherwise states that
/// of the place: the height is less sure by the same factor as without it. `has_heights`: whether heights count from where others of the block do.
fn gnss_observation(
    position: &ExifPosition,
    rtk: Option<&RtkSolution>,
    placing: &GeoreferencingOptions,
    has_heights: bool,
) -> ObservedPosition {
    let ExifPosition { longitude_deg, latitude_deg, height_m, error_m } = *position;
    let height_m = height_m.filter(|_| has_heights);
    if let Some(deviations_m) = rtk.filter(|rtk| rtk.flag >= LEAST_RTK_FLAG).and_then(|rtk| rtk.standard_deviations_m) {
        let sigma_m = deviations_m.map(|deviation| deviation.max(LEAST_RTK_M));
        return ObservedPosition::Geographic { longitude_deg, latitude_deg, height_m, sigma_m };
    }
    let across = error_m.filter(|error| *error != 0.0).unwrap_or(placing.receiver_across_m);
    let up = placing.receiver_up_m * (across / placing.receiver_across_m);
    ObservedPosition::Geographic { longitude_deg, latitude_deg, height_m, sigma_m: [across, across, up] }
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
}
