//! The whole pipeline on the simulated sample pair, natively and under Node: right, oriented, and the same to the last bit.
//!
//! `TIEPOINT_GOLDEN=write cargo test --lib integration::sample::` rewrites the golden file after a change that is meant to change the matches.

mod known;

use std::sync::{Mutex, OnceLock};
use tiepoint::{
    Denominator, DenseTruth, MatchOptions, MatchScore, PairImage, PairResult, PairSettings, PointOptions, Refinement, Strategy, match_pair,
    matches_csv, score_matches,
};
#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test;

/// Matches and orientation as the page and the command must find them too: the file, what it holds, and the strategy that finds it.
macro_rules! golden {
    ($name:literal, $options:expr) => {
        ($name, include_str!(concat!("golden/", $name)), $options)
    };
}

fn goldens() -> [(&'static str, &'static str, MatchOptions); 5] {
    let options = MatchOptions::default;
    [
        golden!("sample.csv", options()),
        golden!("sample-moments.csv", moments()),
        golden!("sample-least-squares.csv", MatchOptions { strategy: Strategy::LeastSquares, ..options() }),
        golden!(
            "sample-correlation.csv",
            MatchOptions { strategy: Strategy::Correlation, refine: Some(Refinement::LeastSquares), epipolar: true, ..options() }
        ),
        golden!("sample-gradient.csv", MatchOptions { strategy: Strategy::Gradient, ..options() }),
    ]
}

fn moments() -> MatchOptions {
    MatchOptions { strategy: Strategy::Moments, ..MatchOptions::default() }
}

/// What these options find: several tests look at the same run.
fn run(matching: MatchOptions) -> &'static PairResult {
    static RUNS: Mutex<Vec<(MatchOptions, &'static OnceLock<PairResult>)>> = Mutex::new(Vec::new());
    let result = {
        let mut runs = RUNS.lock().unwrap();
        let known = runs.iter().find(|(options, _)| *options == matching).map(|(_, result)| *result);
        known.unwrap_or_else(|| {
            let result: &OnceLock<PairResult> = Box::leak(Box::default());
            runs.push((matching.clone(), result));
            result
        })
    };
    result.get_or_init(|| {
        let sample = known::sample();
        let input = known::input(sample);
        let points = PointOptions { fraction: Some(0.148), ..PointOptions::default() };
        let mut settings = PairSettings { points, matching, ..PairSettings::default() };
        settings.orientation.base_mm = Some(sample.base_mm);
        let image = |grey| PairImage { grey, exif: None, mask: None };
        match_pair(image(sample.left.view()), image(sample.right.view()), &input, &settings).unwrap()
    })
}

/// Matches `[x_left, y_left, x_right, y_right, measure]` in px.
fn rows(result: &PairResult) -> Vec<[f64; 5]> {
    let row = |m: &tiepoint::Match| [m.left_px[0], m.left_px[1], m.right_px[0], m.right_px[1], m.measure];
    result.matching.matches.iter().map(row).collect()
}

fn score(result: &PairResult) -> MatchScore {
    let matches: Vec<[f64; 4]> = rows(result).iter().map(|m| [m[0], m[1], m[2], m[3]]).collect();
    let points: Vec<[f64; 2]> = result.left.points.iter().map(|p| [p.x, p.y]).collect();
    let sample = known::sample();
    let truth = DenseTruth {
        right_position: &sample.right_position,
        left_width: sample.left.width(),
        left_height: sample.left.height(),
        right_width: sample.right.width(),
        right_height: sample.right.height(),
    };
    score_matches(&matches, &points, &truth).unwrap()
}

/// What a strategy reaches on the sample.
struct Reached {
    matches: usize,
    right: f64,
    sigma0_px: f64,
    /// Largest errors of the angles in degrees and of the base components in mm.
    errors: [f64; 2],
}

fn reached(matching: MatchOptions) -> Reached {
    let result = run(matching);
    let score = score(result);
    let oriented = result.orientation.as_ref().unwrap();
    let (found, truth) = (oriented.parameters, known::sample().truth);
    let angles = [found.omega_deg - truth.omega_deg, found.phi_deg - truth.phi_deg, found.kappa_deg - truth.kappa_deg];
    let base = [found.by_mm - truth.by_mm, found.bz_mm - truth.bz_mm];
    let largest = |errors: &[f64]| errors.iter().fold(0.0, |most: f64, error| most.max(error.abs()));
    Reached {
        matches: score.rightness.len(),
        right: score.right as f64 / score.rightness.len() as f64,
        sigma0_px: oriented.sigma0_mm.unwrap() / result.interior.as_ref().unwrap().left.pixel_mm(),
        errors: [largest(&angles), largest(&base)],
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn the_sample_is_matched_and_oriented_by_moments() {
    for denominator in [Denominator::Maxabs, Denominator::Floor] {
        let Reached { matches, right, sigma0_px, errors } = reached(MatchOptions { denominator, ..moments() });
        assert!(matches > 1500 && right > 0.89, "{matches} matches, {right} right");
        assert!(sigma0_px < 0.45 && errors[0] < 0.05 && errors[1] < 0.13, "σ0 {sigma0_px} px, errors {errors:?}");
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn grey_values_match_the_sample_to_an_eighth_of_a_pixel() {
    let by = |strategy, refine| MatchOptions { strategy, refine: Some(refine), ..MatchOptions::default() };
    for options in [by(Strategy::LeastSquares, Refinement::None), by(Strategy::Correlation, Refinement::LeastSquares)] {
        let Reached { matches, right, sigma0_px, errors } = reached(options);
        assert!(matches > 2500 && right > 0.97, "{matches} matches, {right} right");
        assert!(sigma0_px < 0.13 && errors[0] < 0.02 && errors[1] < 0.06, "σ0 {sigma0_px} px, errors {errors:?}");
    }
    let Reached { matches, right, sigma0_px, .. } = reached(by(Strategy::Correlation, Refinement::None));
    assert!(matches > 3500 && right > 0.94 && sigma0_px < 0.17, "{matches} matches, {right} right, σ0 {sigma0_px} px");
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn gradients_match_the_sample_without_an_offset() {
    let by = |refine| MatchOptions { strategy: Strategy::Gradient, refine: Some(refine), ..MatchOptions::default() };
    let Reached { matches, right, sigma0_px, errors } = reached(by(Refinement::None));
    assert!(matches > 2500 && right > 0.985, "{matches} matches, {right} right");
    assert!(sigma0_px < 0.17 && errors[0] < 0.02 && errors[1] < 0.06, "σ0 {sigma0_px} px, errors {errors:?}");
    let Reached { matches, right, sigma0_px: refined, .. } = reached(by(Refinement::LeastSquares));
    assert!(matches > 1500 && right > 0.97 && refined < 0.7 * sigma0_px, "{matches} matches, {right} right, σ0 {refined} px");
    // What least squares matching does not confirm stays, with its own weight, and points beside are filled in.
    let all = reached(MatchOptions::default());
    assert!(all.matches > 4500 && all.right > 0.98 && all.sigma0_px < 0.7 * sigma0_px, "{} matches, {} right", all.matches, all.right);
    println!("errors {errors:?}, refined {:?}", all.errors);
    assert!(all.errors[0] < 0.02 && all.errors[1] < 0.06, "{:?}", all.errors);
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn epipolar_lines_narrow_the_search_and_lose_no_right_match() {
    let by = |epipolar| MatchOptions { epipolar, ..moments() };
    let (wide, narrow) = (reached(by(false)), reached(by(true)));
    let right = |r: &Reached| r.right * r.matches as f64;
    assert!(
        narrow.right > wide.right && right(&narrow) > right(&wide),
        "{} of {}, {} of {}",
        narrow.right,
        narrow.matches,
        wide.right,
        wide.matches
    );
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn the_matches_are_the_same_to_the_last_bit() {
    for (name, golden, options) in goldens() {
        let result = run(options);
        let p = result.orientation.as_ref().unwrap().parameters;
        let orientation = [p.omega_deg, p.phi_deg, p.kappa_deg, p.by_mm, p.bz_mm].map(|v| v.to_string()).join(",");
        let text = format!("{}{orientation}\n", matches_csv(&rows(result), Some(&result.orientation.as_ref().unwrap().rejected)));
        #[cfg(not(target_arch = "wasm32"))]
        if std::env::var("TIEPOINT_GOLDEN").is_ok_and(|v| v == "write") {
            std::fs::write(format!("{}/tests/golden/{name}", env!("CARGO_MANIFEST_DIR")), &text).unwrap();
            continue;
        }
        let first = text.lines().zip(golden.lines()).enumerate().find(|(_, (got, expected))| got != expected);
        assert!(text == golden, "{name}: {} lines, golden {}; first difference: {first:?}", text.lines().count(), golden.lines().count());
    }
}

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn every_refused_point_keeps_its_rule() {
    let result = run(moments());
    let c = result.matching.counts;
    let refused = c.no_descriptor + c.no_candidate + c.threshold + c.ambiguous + c.many_to_one + c.parallax;
    assert_eq!(c.matches + refused, result.left.counts.after_suppression);
    assert_eq!(result.matching.verdicts.len(), result.left.points.len());
    assert!([c.threshold, c.ambiguous, c.many_to_one, c.parallax].iter().all(|n| *n > 0), "{c:?}");
}
