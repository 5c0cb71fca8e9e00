//! Points without rays: those whose rays meet after all come back.

use super::course::Course;
use crate::adjustment::collinearity::linearise;
use crate::adjustment::factor3::{backward3, factor3, forward3};
use crate::adjustment::result::ObservationVerdict;

/// Steps after which rays that meet do so: a point was adjusted before it was lost, or is where it was given.
const STEPS: usize = 5;

impl Course<'_> {
    /// The rays of lost points that meet within a limit, in px of weight 1, with the orientations as they are now; the points are moved to where
    /// they do. `known`: standard errors of rays that state one are so many times as large.
    ///
    /// A ray that is rejected takes its point with it where that has two. What was wrong with it may have been an orientation, which others that
    /// were rejected had turned: no ray of a lost point is judged any more, since only points that take part have cofactors.
    pub fn regained(&mut self, limit: f64, known: f64) -> Vec<usize> {
        let mut of_point: Vec<Vec<usize>> = vec![Vec::new(); self.block.points.len()];
        let mut is_lost = vec![false; self.block.points.len()];
        for (index, (ray, verdict)) in self.block.rays.iter().zip(&self.verdicts).enumerate() {
            match verdict {
                ObservationVerdict::GrossError | ObservationVerdict::LostPoint => of_point[ray.point].push(index),
                ObservationVerdict::Accepted | ObservationVerdict::Behind => {}
            }
            is_lost[ray.point] |= *verdict == ObservationVerdict::LostPoint;
        }
        let mut regained = Vec::new();
        for (point, rays) in of_point.iter().enumerate().filter(|(point, rays)| is_lost[*point] && rays.len() > 1) {
            let Some(place) = self.intersection(point, rays, limit, known) else { continue };
            let former = std::mem::replace(&mut self.state.points[point], place);
            if rays.iter().all(|ray| self.in_front(*ray) == ObservationVerdict::Accepted) {
                regained.extend(rays);
            } else {
                self.state.points[point] = former;
            }
        }
        regained
    }

    /// Where rays meet: from where the point is, by least squares. `None` where they do not within the limit: their residuals leave fewer degrees of
    /// freedom than they are coordinates, so that each fits.
    fn intersection(&self, point: usize, rays: &[usize], limit: f64, known: f64) -> Option<[f64; 3]> {
        let mut place = self.state.points[point];
        for step in 0..=STEPS {
            let (mut v, mut right, mut square) = ([0.0; 6], [0.0; 3], 0.0);
            for ray in rays.iter().map(|ray| &self.block.rays[*ray]) {
                let weight = if ray.sigma_px.is_some() { ray.weight / (known * known) } else { ray.weight };
                let line = linearise(&self.state.cameras[self.block.images[ray.image].camera], &self.state.images[ray.image], &place);
                for (by, off) in line.by_point.iter().zip([ray.x_px - line.at[0], ray.y_px - line.at[1]]) {
                    square += weight * off * off;
                    (0..3).for_each(|row| right[row] += weight * by[row] * off);
                    [(0, 0), (1, 0), (1, 1), (2, 0), (2, 1), (2, 2)]
                        .iter()
                        .zip(&mut v)
                        .for_each(|((a, b), sum)| *sum += weight * by[*a] * by[*b]);
                }
            }
            if step == STEPS {
                return (square <= limit * limit).then_some(place);
            }
            let factor = factor3(&v)?;
            let change = backward3(&factor, forward3(&factor, right));
            (0..3).for_each(|k| place[k] += change[k]);
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{AdjustmentOptions, BlockFlight, BlockPreset, SimulatedNetwork, simulate_network};

    #[test]
    fn a_lost_point_comes_back_where_its_rays_meet_and_nowhere_else() {
        let flight = BlockFlight { strips: 1, exposures: 3, noise_px: 0.0, ..BlockPreset::Network.flight() };
        let SimulatedNetwork { truth, .. } = simulate_network(&flight).unwrap();
        let options = AdjustmentOptions::default();
        let rays_of = |point: usize| -> Vec<usize> { (0..truth.rays.len()).filter(|ray| truth.rays[*ray].point == point).collect() };
        let point = (0..truth.points.len()).find(|point| rays_of(*point).len() == 2).unwrap();
        let rays = rays_of(point);
        let regained = |off_px: [f64; 2], keeps_one: bool| {
            let mut block = truth.clone();
            block.points[point][2] += 3.0;
            let ray = &mut block.rays[rays[0]];
            ray.x_px += off_px[0];
            ray.y_px += off_px[1];
            let mut course = Course::new(&block, &options).unwrap();
            course.verdicts[rays[0]] = ObservationVerdict::GrossError;
            course.verdicts[rays[1]] = if keeps_one { ObservationVerdict::Accepted } else { ObservationVerdict::LostPoint };
            let before = course.state.points[point];
            let found = course.regained(1.0, 1.0);
            (found, course.state.points[point] != before)
        };
        assert_eq!(regained([0.0, 0.0], false), (rays.clone(), true));
        assert_eq!(regained([0.3, 0.3], false), (rays.clone(), true));
        assert_eq!(regained([6.0, 6.0], false), (Vec::new(), false));
        // One that kept a ray is not lost.
        assert_eq!(regained([0.0, 0.0], true), (Vec::new(), false));
    }
}
