//! Strips of a flight: images one after the other along a line.

use crate::math::{dot3, minus};
use serde::{Deserialize, Serialize};

/// Images that were taken one after the other along a line.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Strip {
    /// By their indices, in the order in which they were taken.
    pub images: Vec<usize>,
    /// The place of each along the line: 0 on average, from the first to the last one 1.
    pub places: Vec<f64>,
}

/// A step to the next image that turns off the line of its strip by more than this ends the strip.
const TURN_DEG: f64 = 45.0;
/// So does one that is this many times as long as most.
const GAP: f64 = 3.0;
/// Below this share of most steps, images are taken at one place, as those of several cameras: between them nothing turns.
const SAME_PLACE: f64 = 0.2;
/// Steps are usually as long as those that end this share of the whole way, the short ones first: neither those of several cameras at one place nor
/// long ways back from strip to strip count as usual.
const SHARE_OF_WAY: f64 = 1.0 / 3.0;
/// Fewer images are no strip: what lies between two strips, or images that follow no line.
const LEAST_IMAGES: usize = 3;

/// The strips of images in the order in which they were taken, by their positions; images between two strips, or on no line, are in none. The unit of
/// length is any.
///
/// A strip goes on as long as the next image lies ahead, seen from its first one, and not too far off.
pub(super) fn strips(positions: &[[f64; 3]]) -> Vec<Strip> {
    let length = |from: &[f64; 3], to: &[f64; 3]| dot3(&minus(to, from), &minus(to, from)).sqrt();
    let usual = usual_step(positions.windows(2).map(|pair| length(&pair[0], &pair[1])).collect());
    let least_cosine = libm::cos(TURN_DEG.to_radians());
    let mut all = Vec::new();
    let mut strip: Vec<(usize, [f64; 3])> = Vec::new();
    for next in positions.iter().copied().enumerate() {
        let Some((last, first)) = strip.last().zip(strip.first()) else {
            strip.push(next);
            continue;
        };
        let (step, line) = (minus(&next.1, &last.1), minus(&last.1, &first.1));
        let (ahead, so_far) = (length(&last.1, &next.1), length(&first.1, &last.1));
        let is_gap = ahead > GAP * usual;
        let has_line = ahead > SAME_PLACE * usual && so_far > SAME_PLACE * usual;
        let turns = has_line && dot3(&step, &line) < least_cosine * ahead * so_far;
        if is_gap || turns {
            // Of two images the second may as well begin the next strip.
            let kept = if turns && strip.len() == 2 { strip.pop() } else { None };
            all.push(std::mem::take(&mut strip));
            strip.extend(kept);
        }
        strip.push(next);
    }
    all.push(strip);
    let strip = |of: Vec<(usize, [f64; 3])>| {
        let (images, positions): (Vec<usize>, Vec<[f64; 3]>) = of.into_iter().unzip();
        Strip { images, places: places_along(&positions) }
    };
    all.into_iter().filter(|of| of.len() >= LEAST_IMAGES).map(strip).collect()
}

/// The length of most steps that lead on; 0 without any.
fn usual_step(mut steps: Vec<f64>) -> f64 {
    steps.sort_by(f64::total_cmp);
    let way = SHARE_OF_WAY * steps.iter().sum::<f64>();
    let mut gone = 0.0;
    let ends = |step: &&f64| {
        gone += **step;
        gone >= way
    };
    steps.iter().find(ends).copied().unwrap_or(0.0)
}

/// The place of each position along the line of its strip: 0 on average, from the first to the last one 1.
fn places_along(strip: &[[f64; 3]]) -> Vec<f64> {
    let (Some(first), Some(last)) = (strip.first(), strip.last()) else { return Vec::new() };
    let line = minus(last, first);
    let square = dot3(&line, &line);
    if !(square > 0.0) {
        return vec![0.0; strip.len()];
    }
    let along: Vec<f64> = strip.iter().map(|at| dot3(&minus(at, first), &line) / square).collect();
    let mean = along.iter().sum::<f64>() / along.len() as f64;
    along.iter().map(|place| place - mean).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Lines flown to and fro, 30 m apart and 20 m from image to image.
    fn to_and_fro(lines: usize, images: usize) -> Vec<[f64; 3]> {
        let at = |line: usize, image: usize| {
            let along = if line.is_multiple_of(2) { image } else { images - 1 - image };
            [20.0 * along as f64 + (image % 3) as f64, 30.0 * line as f64 - (image % 2) as f64, 100.0]
        };
        (0..lines).flat_map(|line| (0..images).map(move |image| at(line, image))).collect()
    }

    /// The first image of each strip, and how many it has.
    fn runs(positions: &[[f64; 3]]) -> Vec<(usize, usize)> {
        let strips = strips(positions);
        assert!(strips.iter().all(|strip| strip.images.windows(2).all(|pair| pair[1] == pair[0] + 1)), "{strips:?}");
        strips.iter().map(|strip| (strip.images[0], strip.images.len())).collect()
    }

    #[test]
    fn a_strip_ends_where_the_line_turns() {
        assert_eq!(runs(&to_and_fro(3, 8)), [(0, 8), (8, 8), (16, 8)]);
        assert_eq!(runs(&to_and_fro(4, 3)), [(0, 3), (3, 3), (6, 3), (9, 3)]);
    }

    #[test]
    fn an_image_of_the_turn_is_in_no_strip() {
        let mut positions = to_and_fro(2, 8);
        positions.insert(8, [150.0, 17.0, 100.0]);
        assert_eq!(runs(&positions), [(0, 8), (9, 8)]);
    }

    #[test]
    fn a_strip_ends_at_a_long_gap() {
        let line = |from: f64| (0..6).map(move |image| [from + 20.0 * f64::from(image), 0.0, 100.0]);
        assert_eq!(runs(&line(0.0).chain(line(200.0)).collect::<Vec<_>>()), [(0, 6), (6, 6)]);
    }

    #[test]
    fn strips_that_all_begin_on_one_side_are_told_apart() {
        let at = |image: usize| [20.0 * (image % 6) as f64, 30.0 * (image / 6) as f64, 100.0];
        assert_eq!(runs(&(0..18).map(at).collect::<Vec<_>>()), [(0, 6), (6, 6), (12, 6)]);
    }

    #[test]
    fn several_cameras_at_one_place_are_in_one_strip() {
        let places = (0..20).map(|image| [20.0 * f64::from(image / 5), 0.1 * f64::from(image % 3), 0.0]);
        assert_eq!(runs(&places.collect::<Vec<_>>()), [(0, 20)]);
    }

    #[test]
    fn what_follows_no_line_is_no_strip() {
        let corners = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
        let positions: Vec<_> = (0..12).map(|image| [corners[image % 4][0], corners[image % 4][1], 0.0]).collect();
        assert!(strips(&positions).is_empty() && strips(&[]).is_empty() && strips(&[[0.0; 3]; 2]).is_empty());
    }

    #[test]
    fn places_are_counted_in_lengths_of_the_strip() {
        let along = places_along(&[[0.0; 3], [30.0, 1.0, 0.0], [60.0, -1.0, 0.0], [100.0, 0.0, 0.0]]);
        assert!((along.iter().sum::<f64>()).abs() < 1e-12 && (along[3] - along[0] - 1.0).abs() < 1e-12);
        assert!((along[1] - along[0] - 0.3).abs() < 1e-12, "{along:?}");
        assert_eq!(places_along(&[[1.0; 3]; 2]), [0.0; 2]);
    }
}
