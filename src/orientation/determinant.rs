//! The short textbook form: least squares of the coplanarity determinants, unweighted.

use super::adjusted::Adjusted;
use super::adjustment::{move_within_bounds, step_tolerance};
use super::coplanarity::{Linearised, Ray, RelativePose};
use super::normals::{Matrix5, Normals};
use super::refusal::{check_parallax, diverged, undetermined};
use crate::{Cause, Computation, Error};

const MAX_ITERATIONS: usize = 50;

/// Adjusts the pose so that the sum of the squared determinants | b by bz; x₁ y₁ -f; x₂' y₂' z₂' | with b fixed is smallest.
///
/// The determinant of a point is its distance from coplanarity times a gradient that differs little from point to point in a vertical pair;
/// σ of a photo coordinate is σ of the determinants divided by the root mean square of these gradients.
///
/// # Errors
/// [`Error::Degenerate`] where the normal equations are singular or the base has no component along x; [`Error::NotConverged`].
///
/// # Source
/// Wolf, Dewitt & Wilkinson 2014, Elements of Photogrammetry, 4th ed., on analytical relative orientation by coplanarity.
pub(super) fn adjust_determinants(
    rays: &[Ray],
    start: RelativePose,
    bounds: impl Fn(&RelativePose) -> Result<(), Cause>,
) -> Result<Adjusted, Error> {
    let redundancy = rays.len().saturating_sub(5);
    let mut pose = start;
    let (mut last_step, mut last_sigma) = (f64::INFINITY, 0.0);
    for iteration in 1..=MAX_ITERATIONS {
        let (normals, mean_square_gradient) = determinants(&pose, rays)?;
        let solution = normals.solve().map_err(undetermined)?;
        // The decrease that the step brings in the linear model.
        let left = (normals.square_sum - 5.0 * solution.size * solution.size).max(0.0);
        let sigma = if redundancy > 0 { (left / redundancy as f64).sqrt() } else { 0.0 };
        pose = move_within_bounds(&pose, &solution.step);
        let gradient = mean_square_gradient.sqrt();
        last_sigma = sigma / gradient;
        last_step = solution.size / gradient / step_tolerance(last_sigma);
        bounds(&pose).map_err(|cause| diverged(iteration, cause))?;
        if last_step < 1.0 {
            let cofactors = solution.cofactors * mean_square_gradient;
            return Ok(Adjusted {
                pose,
                cofactors,
                precision: cofactors,
                sensitivity: cofactors,
                sigma: sigma / gradient,
                variance_left: 1.0,
                iterations: iteration,
                last_step,
            });
        }
    }
    // Without a base there is no direction of it to settle on.
    check_parallax(&pose, last_sigma, rays)?;
    Err(diverged(MAX_ITERATIONS, Cause::LongSteps { ratio: last_step }))
}

/// Normal equations of the determinants divided by b·f², and the mean square of their gradients.
fn determinants(pose: &RelativePose, rays: &[Ray]) -> Result<(Normals<5>, f64), Error> {
    let tangents = pose.tangents();
    let along_x = pose.base.x;
    if along_x.abs() < 1e-6 {
        return Err(Error::Degenerate { computation: Computation::DeterminantForm, cause: Cause::NoBaseAlongX });
    }
    let mut normals = Normals::new();
    let mut square_gradients = 0.0;
    for line in rays.iter().filter_map(|ray| pose.linearise(&tangents, ray, ray)) {
        // With b fixed the determinant is g / t_x.
        let gradient = line.gradient / along_x;
        let value = line.misclosure * gradient;
        let mut row = line.by_unknowns * gradient;
        row[3] -= value * tangents[0].x / along_x;
        row[4] -= value * tangents[1].x / along_x;
        normals.add(&row, value, 1.0);
        square_gradients += gradient * gradient;
    }
    Ok((normals, square_gradients / rays.len() as f64))
}

/// The weights that observations have in least squares of determinants, whose mean is 1, where distances from coplanarity are observed.
///
/// A determinant is a distance times its gradient, so that its square counts by the square of this.
pub(super) fn implied_weights(pose: &RelativePose, rays: &[Ray], kept: &[bool]) -> Vec<f64> {
    let tangents = pose.tangents();
    let square = |ray: &Ray| pose.linearise(&tangents, ray, &pose.project(ray).0).map_or(0.0, |line| line.gradient * line.gradient);
    let squares: Vec<f64> = rays.iter().map(square).collect();
    let number = kept.iter().filter(|kept| **kept).count().max(1) as f64;
    let mean = squares.iter().zip(kept).filter(|(_, kept)| **kept).map(|(square, _)| square).sum::<f64>() / number;
    squares.into_iter().map(|square| square / mean.max(f64::MIN_POSITIVE)).collect()
}

/// The adjustment with the precision of an estimate that weighs equally precise distances by these weights.
///
/// With H = A N⁻¹ Aᵀ P, the residuals have the cofactors 1 - 2 h_i + a_iᵀ C a_i and the unknowns C = N⁻¹ Aᵀ P² A N⁻¹; σ² is what makes the
/// expectation of the weighted square sum, σ² Σ p_i (1 - h_i), the one that was found.
///
/// # Errors
/// [`Error::Degenerate`] where the normal equations are singular.
pub(super) fn with_precision(adjusted: Adjusted, rays: &[Ray], weights: &[f64]) -> Result<Adjusted, Error> {
    let pose = adjusted.pose;
    let tangents = pose.tangents();
    let lines: Vec<_> = rays.iter().map(|ray| pose.linearise(&tangents, ray, &pose.project(ray).0)).collect();
    let all = || lines.iter().zip(weights).filter_map(|(line, weight)| line.as_ref().map(|line| (line, *weight)));
    let mut normals = Normals::new();
    let mut squared = Matrix5::zeros();
    for (line, weight) in all() {
        normals.add(&line.by_unknowns, line.misclosure, weight);
        squared += line.by_unknowns * line.by_unknowns.transpose() * (weight * weight);
    }
    let cofactors = normals.solve().map_err(undetermined)?.cofactors;
    let share = |line: &Linearised, weight: f64| weight * line.by_unknowns.dot(&(cofactors * line.by_unknowns));
    let expected: f64 = all().map(|(line, weight)| weight * (1.0 - share(line, weight))).sum();
    let sigma = if rays.len() > 5 { (normals.square_sum / expected).sqrt() } else { 0.0 };
    Ok(Adjusted { cofactors, precision: cofactors * squared * cofactors, sensitivity: cofactors, sigma, ..adjusted })
}

#[cfg(test)]
mod tests {
    use super::super::coplanarity::Unknowns;
    use super::*;
    use crate::camera::rotation_from_angles;
    use nalgebra::{Matrix3, Vector3};

    const RAYS: [Ray; 2] = [[0.3, -0.2, 0.15, 0.4], [-0.1, 0.25, -0.4, 0.2]];

    fn value(pose: &RelativePose, [xl, yl, xr, yr]: Ray) -> f64 {
        let right = pose.rotation.transpose() * Vector3::new(xr, yr, -1.0);
        let base = pose.base / pose.base.x;
        Matrix3::new(base.x, base.y, base.z, xl, yl, -1.0, right.x, right.y, right.z).determinant()
    }

    #[test]
    fn the_normal_equations_are_those_of_the_textbook_determinant() {
        let pose = RelativePose { rotation: rotation_from_angles(0.1, -0.2, 0.3), base: Vector3::new(0.9, 0.2, -0.3).normalize() };
        let (normals, _) = determinants(&pose, &RAYS).unwrap();
        let sum: f64 = RAYS.iter().map(|ray| value(&pose, *ray) * value(&pose, *ray)).sum();
        assert!((normals.square_sum - sum).abs() < 1e-14, "{} {sum}", normals.square_sum);
        let h = 1e-6;
        let derivative = |ray: Ray, k: usize| {
            let step = |sign: f64| pose.moved(&Unknowns::from_fn(|row, _| if row == k { sign * h } else { 0.0 }));
            (value(&step(1.0), ray) - value(&step(-1.0), ray)) / (2.0 * h)
        };
        let mut expected = Normals::new();
        for ray in RAYS {
            expected.add(&Unknowns::from_fn(|k, _| derivative(ray, k)), value(&pose, ray), 1.0);
        }
        assert!(normals.difference(&expected) < 1e-8, "{}", normals.difference(&expected));
    }
}
