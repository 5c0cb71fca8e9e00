//! Photos of different scale: the matches of the finer one are refined as those of equal photos are.

use super::sampling::cases;
use tiepoint::{Flight, GreyImage, PairImage, PairInput, PairSettings, Sample, match_pair, simulate};

/// The image by means of so many px a side: that of a camera farther away.
fn reduced(image: &GreyImage, by: usize) -> GreyImage {
    let view = image.view();
    GreyImage::from_fn(image.width() / by, image.height() / by, |col, row| {
        let sum: u32 = (0..by * by).map(|k| u32::from(view.at(col * by + k % by, row * by + k / by))).sum();
        (f64::from(sum) / (by * by) as f64 + 0.5) as u8
    })
    .unwrap()
}

struct Refined {
    matches: usize,
    with_fit: usize,
    /// Median distance of those with a fit from the truth, in px of the coarser image.
    error_px: f64,
    /// The share of all within 1.5 px of it.
    right: f64,
}

/// The matches with nothing set where the left and the right photo are reduced by these factors.
fn refined(sample: &Sample, [by_left, by_right]: [usize; 2]) -> Refined {
    let [left, right] = [reduced(&sample.left, by_left), reduced(&sample.right, by_right)];
    let [left, right] = [&left, &right].map(|image| PairImage { grey: image.view(), exif: None, mask: None });
    let result = match_pair(left, right, &PairInput::default(), &PairSettings::default()).unwrap();
    let coarser = by_left.max(by_right) as f64;
    let off = |m: &tiepoint::Match| {
        let at = m.left_px.map(|v| v * by_left as f64);
        let pixel = at.map(|v| (v - 0.5).round());
        let truth = sample.right_position[pixel[1] as usize * sample.left.width() + pixel[0] as usize].map(f64::from);
        let found = [0, 1].map(|k| m.right_px[k] * by_right as f64 - (at[k] - 0.5 - pixel[k]) - truth[k]);
        found[0].hypot(found[1]) / coarser
    };
    let matches = &result.matching.matches;
    // What is hidden has no truth.
    let seen = |d: &f64| d.is_finite();
    let all: Vec<f64> = matches.iter().map(off).filter(seen).collect();
    let mut fitted: Vec<f64> = matches.iter().filter(|m| m.fit.is_some()).map(off).filter(seen).collect();
    fitted.sort_by(f64::total_cmp);
    Refined {
        matches: matches.len(),
        with_fit: matches.iter().filter(|m| m.fit.is_some()).count(),
        error_px: fitted.get(fitted.len() / 2).copied().unwrap_or(f64::INFINITY),
        right: all.iter().filter(|d| **d < 1.5).count() as f64 / all.len().max(1) as f64,
    }
}

#[test]
fn photos_of_one_and_two_and_one_and_three_keep_their_fits() {
    let flight = Flight { pixel_mm: 0.127, width_px: 900, height_px: 1200, ..Flight::default() };
    let sample = simulate(&flight).unwrap();
    for &by in cases(&[[1, 2], [3, 1], [2, 1], [1, 3]], 2) {
        let found = refined(&sample, by);
        let Refined { matches, with_fit, error_px, right } = found;
        println!("{by:?}: {with_fit} of {matches} matches refined, off by {error_px:.3} px of the coarser photo, right {right:.3}");
        assert!(matches > 1000 && with_fit as f64 > 0.85 * matches as f64, "{by:?}: {with_fit} of {matches}");
        assert!(error_px < 0.3 && right > 0.94, "{by:?}: {error_px} px, {right}");
    }
}
