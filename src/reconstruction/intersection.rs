//! The places of points by the rays of oriented images: consensus of two rays, then all that agree.

use super::net::{Net, Sight};
use crate::adjustment::linearise;
use crate::math::{dot3, minus};
use nalgebra::{Matrix3, Vector3};

/// Rays of which every two are tried.
const TRIED: usize = 6;
/// Steps of the refinement.
const REFINEMENTS: usize = 4;

impl Net<'_> {
    /// Intersects a point that is not, by the rays of oriented images; tells whether it could be. Half of its rays must agree, two at
    /// least, and make an angle whose cosine is below `most_cosine`.
    pub fn intersect(&mut self, point: usize, most_cosine: f64) -> bool {
        let sights: Vec<Sight> = self.rays.of_point(point).filter_map(|ray| self.sight(ray)).collect();
        if sights.len() < 2 {
            return false;
        }
        let Some(place) = self.best_of_two(&sights, most_cosine) else { return false };
        let place = self.refined(&sights, place).unwrap_or(place);
        let agreeing = self.agreeing(&sights, &place);
        if 2 * agreeing.len() < sights.len() || !is_wide(&agreeing, most_cosine) {
            return false;
        }
        self.points[point] = Some(place);
        agreeing.iter().for_each(|sight| self.accepted[sight.ray] = true);
        true
    }

    /// Judges the rays of a point anew; a point of which half no longer fit, two at least and at an angle, is lost.
    pub fn judge(&mut self, point: usize, most_cosine: f64) {
        if self.points[point].is_none() {
            return;
        }
        let rays = self.rays.of_point(point);
        for ray in rays.clone() {
            self.accepted[ray] = self.residual(ray).is_some_and(|r| r <= self.limit_of(ray));
        }
        let oriented = rays.clone().filter(|ray| self.poses[self.rays.image[*ray] as usize].is_some()).count();
        let agreeing: Vec<Sight> = rays.clone().filter(|ray| self.accepted[*ray]).filter_map(|ray| self.sight(ray)).collect();
        if 2 * agreeing.len() < oriented || !is_wide(&agreeing, most_cosine) {
            self.points[point] = None;
            rays.for_each(|ray| self.accepted[ray] = false);
        }
    }

    /// The place where two rays meet with which most agree; of equal ones the one with the smaller residuals.
    fn best_of_two(&self, sights: &[Sight], most_cosine: f64) -> Option<[f64; 3]> {
        let step = sights.len().div_ceil(TRIED);
        let tried: Vec<&Sight> = sights.iter().step_by(step).collect();
        let mut best: Option<([f64; 3], usize, f64)> = None;
        for (k, a) in tried.iter().enumerate() {
            for b in &tried[k + 1..] {
                if dot3(&a.along, &b.along) >= most_cosine {
                    continue;
                }
                let Some(place) = meeting(a, b) else { continue };
                let (mut count, mut sum) = (0, 0.0);
                for sight in sights {
                    if let Some(r) = self.residual_to(sight.ray, &place).filter(|r| *r <= self.limit_of(sight.ray)) {
                        count += 1;
                        sum += r * r;
                    }
                }
                let better = best.is_none_or(|(_, most, least)| count > most || (count == most && sum < least));
                if count >= 2 && better {
                    best = Some((place, count, sum));
                }
            }
        }
        best.map(|(place, ..)| place)
    }

    fn agreeing(&self, sights: &[Sight], place: &[f64; 3]) -> Vec<Sight> {
        sights.iter().filter(|sight| self.fits(sight.ray, place)).copied().collect()
    }

    /// Least squares of the residuals of the rays that agree.
    fn refined(&self, sights: &[Sight], start: [f64; 3]) -> Option<[f64; 3]> {
        let mut place = start;
        for _ in 0..REFINEMENTS {
            let (mut normal, mut right) = (Matrix3::<f64>::zeros(), Vector3::<f64>::zeros());
            for sight in sights.iter().filter(|sight| self.fits(sight.ray, &place)) {
                let image = self.rays.image[sight.ray] as usize;
                let (pose, at) = (self.poses[image].as_ref()?, self.rays.at[sight.ray]);
                let line = linearise(&self.camera(image).values(), pose, &place);
                for row in 0..2 {
                    let b = Vector3::from(line.by_point[row]);
                    normal += b * b.transpose();
                    right += b * (at[row] - line.at[row]);
                }
            }
            let step = normal.cholesky()?.solve(&right);
            place = [0, 1, 2].map(|k| place[k] + step[k]);
        }
        place.iter().all(|v| v.is_finite()).then_some(place)
    }
}

/// The middle of the shortest connection of two rays. `None` for parallel ones.
fn meeting(a: &Sight, b: &Sight) -> Option<[f64; 3]> {
    let base = minus(&b.from, &a.from);
    let c = dot3(&a.along, &b.along);
    let (on_a, on_b) = (dot3(&a.along, &base), dot3(&b.along, &base));
    let sine2 = 1.0 - c * c;
    if !(sine2 > 1e-12) {
        return None;
    }
    let (s, t) = ((on_a - c * on_b) / sine2, (c * on_a - on_b) / sine2);
    let place = [0, 1, 2].map(|k| 0.5 * (a.from[k] + s * a.along[k] + b.from[k] + t * b.along[k]));
    place.iter().all(|v| v.is_finite()).then_some(place)
}

/// Whether two of the rays make an angle whose cosine is below the limit.
fn is_wide(sights: &[Sight], most_cosine: f64) -> bool {
    sights.iter().enumerate().any(|(k, a)| sights[k + 1..].iter().any(|b| dot3(&a.along, &b.along) < most_cosine))
}
