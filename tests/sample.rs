//! The whole pipeline on the simulated sample pair, natively and under Node: right, oriented, and the same to the last bit.
//!
//! `TIEPOINT_GOLDEN=write cargo test --test sample` rewrites the golden file after a change that is meant to change the matches.

use tiepoint::{
    Denominator, MatchOptions, PairImage, PairInput, PairResult, PairSettings, PhotoInput, PointOptions, SAMPLE_SEED, Sample, match_pair,
    matches_csv, sample_pair,
};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test;

/// Matches and orientation as the page and the command must find them too.
const GOLDEN: &str = include_str!("golden/sample.csv");

fn run(sample: &Sample, denominator: Denominator) -> PairResult {
    let photo = |fiducials: &Vec<_>, origin| PhotoInput { fiducials: fiducials.clone(), origin: Some(origin), ..PhotoInput::default() };
    let input = PairInput {
        camera: Some(sample.camera),
        left: photo(&sample.left_fiducials, sample.left_origin),
        right: photo(&sample.right_fiducials, sample.right_origin),
        offset: None,
    };
    let mut settings = PairSettings {
        points: PointOptions { fraction: Some(0.148), ..PointOptions::default() },
        matching: MatchOptions { denominator, ..MatchOptions::default() },
        ..PairSettings::default()
    };
    settings.orientation.base_mm = Some(sample.base_mm);
    let image = |grey| PairImage { grey, exif: None };
    match_pair(image(sample.left.view()), image(sample.right.view()), &input, &settings).unwrap()
}

/// Matches `[x_left, y_left, x_right, y_right, measure]` in px.
fn rows(result: &PairResult) -> Vec<[f64; 5]> {
    let row = |m: &tiepoint::Match| {
        let (l, r) = (result.left.points[m.left], result.right.points[m.right]);
        [l.x, l.y, r.x, r.y, m.measure]
    };
    result.matching.matches.iter().map(row).collect()
}

/// The share of matches whose right point lies within 1.5 px of where the surface at the left pixel, or at one of its 8 neighbours, is seen.
fn edge_precision(sample: &Sample, matches: &[[f64; 5]]) -> f64 {
    let (width, height) = (sample.left.width() as i64, sample.left.height() as i64);
    let right = |m: &&[f64; 5]| {
        (-1..=1).flat_map(|dr| (-1..=1).map(move |dc| (dc, dr))).any(|(dc, dr)| {
            let (col, row) = ((m[0] as i64 + dc).clamp(0, width - 1), (m[1] as i64 + dr).clamp(0, height - 1));
            let [x, y] = sample.right_position[(row * width + col) as usize].map(f64::from);
            // The neighbour's surface, moved back to the left point; NaN where it is hidden is never within.
            let (dx, dy) = (x + m[0] - (col as f64 + 0.5) - m[2], y + m[1] - (row as f64 + 0.5) - m[3]);
            (dx * dx + dy * dy).sqrt() <= 1.5
        })
    };
    matches.iter().filter(right).count() as f64 / matches.len() as f64
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn the_sample_is_matched_and_oriented() {
    let sample = sample_pair(SAMPLE_SEED).unwrap();
    for denominator in [Denominator::Maxabs, Denominator::Floor] {
        let result = run(&sample, denominator);
        let matches = rows(&result);
        let precision = edge_precision(&sample, &matches);
        assert!(matches.len() > 1500 && precision > 0.89, "{} matches, edge precision {precision}", matches.len());
        let oriented = result.orientation.unwrap();
        let sigma0_px = oriented.sigma0_mm.unwrap() / result.interior.unwrap().left.pixel_mm();
        assert!(sigma0_px < 0.45, "σ0 {sigma0_px} px");
        let (found, truth) = (oriented.parameters, sample.truth);
        let angles = [found.omega_deg - truth.omega_deg, found.phi_deg - truth.phi_deg, found.kappa_deg - truth.kappa_deg];
        assert!(angles.iter().all(|error| error.abs() < 0.05), "{angles:?} deg");
        let base = [found.by_mm - truth.by_mm, found.bz_mm - truth.bz_mm];
        assert!(base.iter().all(|error| error.abs() < 0.13), "{base:?} mm");
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn the_matches_are_the_same_to_the_last_bit() {
    let result = run(&sample_pair(SAMPLE_SEED).unwrap(), Denominator::Maxabs);
    let p = result.orientation.as_ref().unwrap().parameters;
    let orientation = [p.omega_deg, p.phi_deg, p.kappa_deg, p.by_mm, p.bz_mm].map(|v| v.to_string()).join(",");
    let text = format!("{}{orientation}\n", matches_csv(&rows(&result)));
    #[cfg(not(target_arch = "wasm32"))]
    if std::env::var("TIEPOINT_GOLDEN").is_ok_and(|v| v == "write") {
        std::fs::write(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden/sample.csv"), &text).unwrap();
        return;
    }
    let first = text.lines().zip(GOLDEN.lines()).enumerate().find(|(_, (got, expected))| got != expected);
    assert!(text == GOLDEN, "{} lines, golden {}; first difference: {first:?}", text.lines().count(), GOLDEN.lines().count());
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn every_refused_point_keeps_its_rule() {
    let result = run(&sample_pair(SAMPLE_SEED).unwrap(), Denominator::Maxabs);
    let c = result.matching.counts;
    let refused = c.no_descriptor + c.no_candidate + c.threshold + c.ambiguous + c.many_to_one + c.parallax;
    assert_eq!(c.matches + refused, result.left.counts.after_suppression);
    assert_eq!(result.matching.verdicts.len(), result.left.points.len());
    assert!([c.threshold, c.ambiguous, c.many_to_one, c.parallax].iter().all(|n| *n > 0), "{c:?}");
}
