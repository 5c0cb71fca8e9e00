//! The y-parallax that matches share, by what they are.

use crate::Match;
use crate::orientation::MODES;

// Standard deviations of the modes 1, x, y, xy, x², y², in standard errors of a coordinate: walls, roofs and the shape of a point's surroundings
// give matches of one part of the image an error of the same sign, and from the middle of the overlap to its corners the two photos see more and
// more different walls. In pixels most are of one size, about 0.06 px: shares differ as standard errors do. Set for each kind by the errors of 160
// flights of the four presets (maximum likelihood), beside those of their fiducial marks.

/// Windows around whole pixels that least squares matching placed.
const OF_WINDOWS: [f64; MODES] = [0.62, 0.34, 0.06, 0.27, 0.17, 0.07];
/// Windows around whole pixels that correlation alone placed. No constant y-parallax shows beside that of the fiducial marks.
const OF_CORRELATION: [f64; MODES] = [0.05, 0.15, 0.01, 0.26, 0.02, 0.08];
/// Features, most of them refined by least squares matching.
const OF_REFINED_FEATURES: [f64; MODES] = [0.61, 0.29, 0.09, 0.19, 0.03, 0.08];
const OF_FEATURES: [f64; MODES] = [0.32, 0.14, 0.04, 0.11, 0.08, 0.07];
/// Interest points at whole pixels in both photos: rounding makes their standard errors larger.
const OF_PIXELS: [f64; MODES] = [0.16, 0.07, 0.01, 0.10, 0.50, 0.08];

/// Standard deviations of the modes of the y-parallax that the matches share, as of [`ErrorModel`](crate::ErrorModel).
pub fn shared_parallax(matches: &[Match]) -> [f64; MODES] {
    let are_most = |is: fn(&Match) -> bool| 2 * matches.iter().filter(|m| is(m)).count() > matches.len();
    match (are_most(|m| is_at_a_pixel(m.left_px)), are_most(|m| is_at_a_pixel(m.right_px)), are_most(|m| m.fit.is_some())) {
        (true, true, false) => OF_PIXELS,
        (true, false, false) => OF_CORRELATION,
        (true, _, true) => OF_WINDOWS,
        (false, _, true) => OF_REFINED_FEATURES,
        (false, _, false) => OF_FEATURES,
    }
}

/// Whether a place is the centre of a pixel.
pub fn is_at_a_pixel(px: [f64; 2]) -> bool {
    px.iter().all(|v| v - libm::floor(*v) == 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Fit;

    #[test]
    fn what_matches_share_follows_from_where_they_lie_and_whether_least_squares_placed_them() {
        let [pixel, place] = [[10.5, 20.5], [10.5, 20.4]];
        let fit = Some(Fit { correlation: 0.9, covariance: [1e-4, 0.0, 1e-4], iterations: 3 });
        let of = |left_px, right_px, fit| Match { left: 0, right: None, left_px, right_px, measure: 0.1, fit };
        for (one, share) in [
            (of(pixel, pixel, None), OF_PIXELS),
            (of(pixel, place, None), OF_CORRELATION),
            (of(pixel, place, fit), OF_WINDOWS),
            (of(place, place, fit), OF_REFINED_FEATURES),
            (of(place, place, None), OF_FEATURES),
        ] {
            // One that a person measured changes nothing.
            let matches = [one, of(place, place, None), one];
            assert_eq!(shared_parallax(&matches), share);
        }
    }
}
