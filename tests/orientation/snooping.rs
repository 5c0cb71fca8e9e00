//! Data snooping on clean observations: it rejects the share α₀ of them at any limit and number, and σ₀ does not collapse.

use super::scene::{FOCAL_MM, NADIR, standard_errors};
use tiepoint::orient_relative;

const SIGMA_MM: f64 = 0.02;

/// What many sets of clean observations gave.
struct Clean {
    rejected_share: f64,
    /// For each unknown the mean square of error over standard error.
    squares: [f64; 5],
    least_sigma: f64,
}

fn clean(number: usize, alpha0: f64, sets: u64) -> Clean {
    let (mut rejected, mut refused, mut squares, mut least_sigma) = (0, 0, [0.0; 5], f64::INFINITY);
    for seed in 0..sets {
        let mut options = NADIR.options();
        options.alpha0 = alpha0;
        let Ok(found) = orient_relative(&NADIR.observe(number, SIGMA_MM, 1000 + seed), FOCAL_MM, &options) else {
            refused += 1;
            continue;
        };
        rejected += found.rejected.len();
        least_sigma = f64::min(least_sigma, found.sigma0_mm.unwrap());
        let (errors, standard) = (NADIR.errors(&found), standard_errors(&found));
        (0..5).for_each(|k| squares[k] += (errors[k] / standard[k]) * (errors[k] / standard[k]) / sets as f64);
    }
    assert!(refused as f64 <= alpha0 * sets as f64, "{number}, {alpha0}: {refused} of {sets} clean sets refused");
    Clean { rejected_share: rejected as f64 / (number as u64 * sets) as f64, squares, least_sigma }
}

#[test]
fn clean_observations_are_rejected_as_often_as_alpha0_says() {
    for (number, alpha0, sets) in [
        (20, 0.001, 400),
        (20, 0.01, 400),
        (20, 0.05, 400),
        (40, 0.1, 200),
        (100, 0.05, 100),
        (100, 0.2, 100),
        (400, 0.1, 60),
        (400, 0.001, 60),
    ] {
        let Clean { rejected_share, squares, least_sigma } = clean(number, alpha0, sets);
        let scatter = 4.0 * (alpha0 / (number as u64 * sets) as f64).sqrt();
        println!(
            "{number} observations, α₀ {alpha0}: rejected {rejected_share:.4}, variance {squares:.2?}, least σ₀ {:.2} of the true",
            least_sigma / SIGMA_MM
        );
        assert!((rejected_share - alpha0).abs() < 0.1 * alpha0 + scatter, "{number}, {alpha0}: {rejected_share}");
        assert!(least_sigma > 0.3 * SIGMA_MM, "{number}, {alpha0}: {least_sigma}");
        // With 15 degrees of freedom an error over its standard error has a variance of 15/13.
        let largest = if number <= 40 { 2.5 } else { 1.5 };
        assert!(squares.iter().all(|v| (0.6..largest).contains(v)), "{number}, {alpha0}: {squares:?}");
    }
}
