//! What a pair is worth, as it is told to whoever sets nothing.

use crate::known::input;
use tiepoint::{GreyImage, PairImage, PairInput, PairResult, PairSettings, PairVerdict, SAMPLE_SEED, Warning, match_pair, sample_pair};

fn matched(left: &GreyImage, right: &GreyImage, mask: Option<&GreyImage>, input: &PairInput) -> PairResult {
    let image = |grey, mask| PairImage { grey, exif: None, mask };
    match_pair(image(left.view(), mask.map(GreyImage::view)), image(right.view(), None), input, &PairSettings::default()).unwrap()
}

#[test]
fn a_good_pair_is_oriented_with_nothing_set() {
    let sample = sample_pair(SAMPLE_SEED).unwrap();
    let result = matched(&sample.left, &sample.right, None, &input(&sample));
    let PairVerdict::Oriented { points, sigma0_px, kappa_deg, half_width_deg } = result.verdict() else { panic!("{}", result.verdict()) };
    assert_eq!(points, result.matching.matches.len() - result.orientation.as_ref().unwrap().rejected.len());
    assert!(sigma0_px < 0.15 && (kappa_deg - sample.truth.kappa_deg).abs() < half_width_deg && half_width_deg < 0.02);
    assert!(result.verdict().to_string().starts_with(&format!("Oriented from {points} points, σ0 0.")), "{}", result.verdict());
}

#[test]
fn matches_of_few_places_are_weak() {
    let sample = sample_pair(SAMPLE_SEED).unwrap();
    let (width, height) = (sample.left.width(), sample.left.height());
    let middle = |k: usize| (k % width).abs_diff(width / 2) < 70 && (k / width).abs_diff(height / 2) < 70;
    let mask = GreyImage::new(width, height, (0..width * height).map(|k| if middle(k) { 255 } else { 0 }).collect()).unwrap();
    let result = matched(&sample.left, &sample.right, Some(&mask), &input(&sample));
    let warnings = &result.orientation.as_ref().unwrap().warnings;
    assert!(warnings.iter().any(|w| matches!(w, Warning::FewPlaces { places, least: 16 } if *places < 16)), "{warnings:?}");
    let PairVerdict::Weak { warning, .. } = result.verdict() else { panic!("{}", result.verdict()) };
    assert_eq!(Some(&warning), warnings.iter().find(|w| w.is_weakness()));
}

#[test]
fn photos_of_different_towns_and_one_photo_twice_are_not_oriented() {
    let (one, other) = (sample_pair(SAMPLE_SEED).unwrap(), sample_pair(SAMPLE_SEED + 1).unwrap());
    for right in [&other.right, &one.left] {
        let result = matched(&one.left, right, None, &input(&one));
        assert!(matches!(result.verdict(), PairVerdict::NotOriented { .. }), "{}", result.verdict());
        assert!(result.verdict().to_string().starts_with("Not oriented: "), "{}", result.verdict());
    }
}
