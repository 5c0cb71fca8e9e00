//! The total standard errors: what errors of measured fiducial marks do to an orientation, against many measurements of the marks.

use super::super::sampling::runs;
use super::scene::{Dice, FOCAL_MM, NADIR};
use tiepoint::{
    CameraMm, CameraUncertainty, ErrorModel, Fiducial, FiducialModel, FiveParameters, Interior, Match, OrientationOptions, PairInterior,
    RelativeOrientation, orient_fiducials, orient_matches, orient_relative_with,
};

const PIXEL_MM: f64 = 0.254;
const CENTRE_PX: f64 = 455.0;

fn five(p: FiveParameters) -> [f64; 5] {
    [p.omega_deg, p.phi_deg, p.kappa_deg, p.by_mm, p.bz_mm]
}

/// Marks at the corners and, of eight, at the sides, measured with an error.
fn interior(dice: &mut Dice, sigma_px: f64, marks: usize) -> Interior {
    let places = [[-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.06, 0.0], [1.06, 0.0], [0.0, 1.06], [0.0, -1.06]];
    let mark = |[x, y]: [f64; 2]| {
        let (x_mm, y_mm) = (106.0 * x, 106.0 * y);
        let (col, row) = (CENTRE_PX + x_mm / PIXEL_MM, CENTRE_PX - y_mm / PIXEL_MM);
        Fiducial { col: col - 300.0 + sigma_px * dice.normal(), row: row - 100.0 + sigma_px * dice.normal(), x_mm, y_mm }
    };
    let marks: Vec<_> = places[..marks].iter().copied().map(mark).collect();
    let camera = CameraMm::without_distortion(FOCAL_MM, None);
    // The origin takes the covariance from the scan to the patch.
    Interior::from_fiducials(&camera, &orient_fiducials(&marks, FiducialModel::Affine).unwrap(), [-300.0, -100.0]).unwrap()
}

/// The orientation of so many points of this precision, whose photos have so many measured marks.
fn with_marks(set: u64, marks: usize, (points, sigma_mm): (usize, f64)) -> RelativeOrientation {
    let mut dice = Dice::new(50_000 + set);
    let interior = PairInterior {
        left: interior(&mut dice, 0.12, marks),
        right: interior(&mut dice, 0.12, marks),
        focal_mm: FOCAL_MM,
        doubt: None,
        one_lens: false,
        are_scans: true,
    };
    let px = |[x, y]: [f64; 2]| [CENTRE_PX + x / PIXEL_MM, CENTRE_PX - y / PIXEL_MM];
    let seen = NADIR.observe(points, sigma_mm, 60_000 + set);
    let matched = seen.iter().enumerate().map(|(left, o)| Match {
        left,
        right: None,
        left_px: px(o.left),
        right_px: px(o.right),
        measure: 0.0,
        fit: None,
    });
    let options = OrientationOptions { base_mm: Some(92.0), ..OrientationOptions::default() };
    orient_matches(&matched.collect::<Vec<_>>(), &interior, &options).unwrap()
}

#[test]
fn total_standard_errors_hold_those_of_the_marks() {
    const SETS: u64 = 400;
    let (mut with, mut without) = ([0.0; 5], [0.0; 5]);
    for set in 0..SETS {
        let found = with_marks(set, 8, (300, 0.02));
        let errors = NADIR.errors(&found);
        for (sums, standard) in [(&mut with, found.total_standard_errors.unwrap()), (&mut without, found.standard_errors.unwrap())] {
            sums.iter_mut().zip(errors).zip(five(standard)).for_each(|((sum, error), s)| *sum += (error / s) * (error / s) / SETS as f64);
        }
    }
    println!(
        "variance of error / standard error with measured marks, {SETS} sets: total {with:.3?}, of the observations alone {without:.3?}"
    );
    // The σ of the marks comes from ten degrees of freedom: its square is Student's, which raises the variance by a tenth or two.
    // The errors that matches share, which these do not, lower it where the marks matter least.
    assert!(with.iter().all(|v| (0.7..1.45).contains(v)), "{with:?}");
    assert!(without[2] > 2.0 && without[4] > 1.5, "{without:?}");
}

#[test]
fn intervals_hold_the_truth_where_few_marks_tell_how_well_they_are_measured() {
    let all = runs(6000);
    for marks in [4, 8] {
        let mut covered = [0; 5];
        for set in 0..all {
            let found = with_marks(set, marks, (80, 0.002));
            let errors = NADIR.errors(&found);
            covered
                .iter_mut()
                .zip(errors)
                .zip(five(found.half_widths_95.unwrap()))
                .for_each(|((n, e), half)| *n += u32::from(e.abs() <= half));
        }
        let shares = covered.map(|n| f64::from(n) / all as f64);
        println!("intervals of 95 % that hold the truth, {marks} marks measured in each photo, {all} sets: {shares:.3?}");
        // κ, by and bz are hardly known but for the errors of the marks.
        let scatter = 4.0 * (0.05 * 0.95 / all as f64).sqrt();
        assert!(shares[2..].iter().all(|share| (0.93 - scatter..0.97 + scatter).contains(share)), "{marks}: {shares:?}");
    }
}

#[test]
fn without_redundancy_of_the_marks_nothing_is_claimed_of_them() {
    let exact = Some(CameraUncertainty::NONE);
    let camera = CameraMm { uncertainty: exact, ..CameraMm::without_distortion(FOCAL_MM, Some(PIXEL_MM)) };
    let side = Interior::from_pixel_size(&camera, 910, 910).unwrap();
    let interior = PairInterior { left: side, right: side, focal_mm: FOCAL_MM, doubt: None, one_lens: false, are_scans: true };
    let px = |[x, y]: [f64; 2]| [CENTRE_PX + x / PIXEL_MM, CENTRE_PX - y / PIXEL_MM];
    let matched = NADIR.observe(50, 0.02, 3).into_iter().enumerate();
    let matched = matched.map(|(left, o)| Match { left, right: None, left_px: px(o.left), right_px: px(o.right), measure: 0.0, fit: None });
    let found = orient_matches(&matched.collect::<Vec<_>>(), &interior, &OrientationOptions::default()).unwrap();
    // What neighbours share is all that the total then holds: nothing, for observations that are independent.
    let (own, total) = (found.standard_errors.unwrap(), found.total_standard_errors.unwrap());
    let ratio = total.kappa_deg / own.kappa_deg;
    assert!((0.5..1.6).contains(&ratio), "{ratio}");
}

#[test]
fn neighbours_never_make_an_orientation_more_precise_than_independent_observations() {
    let errors = ErrorModel { neighbourhood_mm: 12.0, ..ErrorModel::default() };
    let mut larger = 0;
    for seed in 0..20 {
        let found = orient_relative_with(&NADIR.observe(400, 0.02, 300 + seed), &errors, FOCAL_MM, &NADIR.options()).unwrap();
        let (alone, total) = (five(found.standard_errors.unwrap()), five(found.total_standard_errors.unwrap()));
        assert!(alone.iter().zip(total).all(|(alone, total)| total >= *alone), "{seed}: {alone:?} {total:?}");
        // Errors that are independent seem to depend on each other by the chance of few groups alone.
        assert!(alone.iter().zip(total).all(|(alone, total)| total < 1.6 * alone), "{seed}: {alone:?} {total:?}");
        larger += usize::from(total[0] > 1.01 * alone[0]);
    }
    assert!(larger > 0);
}

#[test]
fn errors_of_a_shared_parallax_are_scaled_by_the_given_sigma0() {
    let seen = NADIR.observe(40, 0.01, 7);
    let errors = ErrorModel { shared_parallax: [0.4, 0.3, 0.1, 0.25, 0.3, 0.13], ..ErrorModel::default() };
    let total = |sigma0_mm: f64| {
        let options = OrientationOptions { robust: false, sigma0_mm: Some(sigma0_mm), ..NADIR.options() };
        let found = orient_relative_with(&seen, &errors, FOCAL_MM, &options).unwrap();
        assert!(found.global_test.unwrap().passed, "{sigma0_mm}: {:?}", found.global_test);
        assert!(found.total_standard_errors.unwrap().kappa_deg > 1.05 * found.standard_errors.unwrap().kappa_deg);
        let total = found.total_standard_errors.unwrap();
        [total.omega_deg, total.phi_deg, total.kappa_deg, total.by_mm, total.bz_mm]
    };
    let sigma0_mm = orient_relative_with(&seen, &errors, FOCAL_MM, &OrientationOptions { robust: false, ..NADIR.options() }).unwrap();
    let sigma0_mm = sigma0_mm.sigma0_mm.unwrap();
    let (less, more) = (total(0.9 * sigma0_mm), total(1.1 * sigma0_mm));
    for (less, more) in less.into_iter().zip(more) {
        assert!((more / less - 1.1 / 0.9).abs() < 1e-9, "{}", more / less);
    }
}
