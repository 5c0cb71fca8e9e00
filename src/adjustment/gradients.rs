//! Solves the reduced normal equations by conjugate gradients, with the factor of nearly the same equations: without a factorisation.

use super::reduced::{Problem, Reduced};
use super::solution::{Factored, Step, dot};
use super::sparse::Pattern;

/// Iterations after which a factorisation is as cheap.
const MOST_ITERATIONS: usize = 20;
/// Square of what is left of the solution's error, by that of the solution, both measured by the equations.
const TOLERANCE: f64 = 1e-12;

/// Images, six numbers a place, and cameras.
#[derive(Clone)]
struct Both {
    images: Vec<f64>,
    cameras: Vec<f64>,
}

impl Both {
    fn dot(&self, other: &Self) -> f64 {
        dot(&self.images, &other.images) + dot(&self.cameras, &other.cameras)
    }

    /// self += factor · other.
    fn add(&mut self, factor: f64, other: &Self) {
        self.images.iter_mut().zip(&other.images).for_each(|(x, y)| *x += factor * y);
        self.cameras.iter_mut().zip(&other.cameras).for_each(|(x, y)| *x += factor * y);
    }
}

impl Step {
    /// The step that the equations give, by the factor of nearby ones of the same pattern and cameras; `None` where that is too far off.
    ///
    /// # Source
    /// Hestenes & Stiefel 1952, Methods of conjugate gradients for solving linear systems; Concus, Golub & O'Leary 1976 (the nearby factor).
    pub fn near(problem: &Problem<'_>, reduced: &Reduced, nearby: &Factored) -> Option<Self> {
        let pattern: &Pattern = &problem.network.pattern;
        let solved = |right: &Both| {
            let mut solution = right.clone();
            nearby.solve(pattern, &mut solution.images, &mut solution.cameras);
            solution
        };
        let mut left = Both { images: reduced.right.clone(), cameras: reduced.corner_right.clone() };
        let mut found = Both { images: vec![0.0; left.images.len()], cameras: vec![0.0; left.cameras.len()] };
        let mut direction = solved(&left);
        let mut rest = left.dot(&direction);
        let least = TOLERANCE * rest;
        for _ in 0..MOST_ITERATIONS {
            if rest <= least {
                return Some(Self::of(problem, reduced, found.images, found.cameras));
            }
            let product = reduced.product(pattern, &direction);
            let curvature = direction.dot(&product);
            if !(curvature > 0.0) {
                return None;
            }
            let length = rest / curvature;
            found.add(length, &direction);
            left.add(-length, &product);
            let mut next = solved(&left);
            let then = left.dot(&next);
            next.add(then / rest, &direction);
            (direction, rest) = (next, then);
        }
        None
    }
}

impl Reduced {
    fn product(&self, pattern: &Pattern, x: &Both) -> Both {
        let q = x.cameras.len();
        let mut images = vec![0.0; x.images.len()];
        self.matrix.add_product(pattern, &x.images, &mut images);
        for (column, value) in self.border.iter().zip(&x.cameras) {
            images.iter_mut().zip(column).for_each(|(y, b)| *y += b * value);
        }
        let cameras = (0..q).map(|k| dot(&self.border[k], &x.images) + dot(&self.corner[k * q..][..q], &x.cameras)).collect();
        Both { images, cameras }
    }
}
