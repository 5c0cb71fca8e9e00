//! What can be said of each ray and each observed position: its share in the result and its test.
//!
//! # Source
//! Baarda 1968, A testing procedure for use in geodetic networks; Förstner & Wrobel 2016, Photogrammetric Computer Vision, 4.6.

use super::collinearity::{Linearised, linearise};
use super::factor3::{backward3, forward3};
use super::precision::{Cofactors, Matrix3, PointCofactors};
use super::result::PriorStatistics;
use super::sparse::{Block6, N};
use super::state::State;
use super::weighted::Weighted;

/// Below this share an observation has no redundancy to judge it by.
pub(super) const LEAST_REDUNDANCY: f64 = 1e-6;

/// Redundancy and test of one coordinate.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Judged {
    pub redundancy: f64,
    /// Residual by √q_vv, in px of weight 1: w times σ.
    pub standardised: f64,
    /// How far its object point moves by an error of the coordinate, in units of the block by px; not a number where that is not known.
    pub moves: f64,
}

impl Judged {
    /// Of a residual v whose observation has a weight, took part with a factor of it (0: not at all), and whose computed value has the
    /// cofactor h: q_vv = 1/w + h (1 - 2 · factor).
    fn new(residual: f64, weight: f64, factor: f64, cofactor: f64) -> Self {
        let spread = 1.0 + weight * cofactor * (1.0 - 2.0 * factor);
        let redundancy = if factor > 0.0 { 1.0 - weight * factor * cofactor } else { 1.0 / (1.0 + weight * cofactor) };
        let standardised = if spread > LEAST_REDUNDANCY { residual * (weight / spread).sqrt() } else { 0.0 };
        Self { redundancy: redundancy.clamp(0.0, 1.0), standardised, moves: f64::NAN }
    }
}

/// What a computed coordinate has in common with what is estimated.
struct Computed {
    /// Its own cofactor.
    cofactor: f64,
    /// Its cofactors with X, Y, Z of its point; absent where they are not known.
    with_point: Option<[f64; 3]>,
}

impl Computed {
    /// Of an observed coordinate of a residual and a weight, which took part with a factor of it or, with 0, did not.
    fn judged(&self, residual: f64, weight: f64, factor: f64) -> Judged {
        let judged = Judged::new(residual, weight, factor, self.cofactor);
        // An error of what took no part would move the point by as much as if it had.
        let gain = if factor > 0.0 { weight * factor } else { weight * judged.redundancy };
        let length = |q: [f64; 3]| q.iter().map(|q| q * q).sum::<f64>().sqrt();
        Judged { moves: self.with_point.map_or(f64::NAN, |q| gain * length(q)), ..judged }
    }
}

/// What judging needs to know of an adjustment.
pub(super) struct Judgement<'a> {
    pub cofactors: &'a Cofactors<'a>,
    pub state: &'a State,
}

impl Judgement<'_> {
    fn line(&self, camera: usize, image: usize, point: usize) -> Linearised {
        linearise(&self.state.cameras[camera], &self.state.images[image], &self.state.points[point])
    }

    /// Column and row of each sight of a point, with the factors that the robust loss left to their weights.
    pub fn of_sights(&self, point: usize, common: &PointCofactors, factors: &[f64]) -> Vec<[Judged; 2]> {
        let network = self.cofactors.problem.network;
        let judge = |(k, sight): (usize, &super::network::Sight)| {
            let (camera, image) = (sight.camera as usize, sight.image as usize);
            let line = self.line(camera, image, point);
            let computed = self.of_computed(&line, camera, image, point, common, Some(&common.of_sights[k]));
            [0, 1].map(|row| computed[row].judged(sight.at[row] - line.at[row], sight.weight, factors[k]))
        };
        network.of_point(point).iter().enumerate().map(judge).collect()
    }

    /// Column and row of a ray that took no part, its point being adjusted without it.
    pub fn of_outsider(&self, ray: &super::block::BlockObservation, camera: usize, common: &PointCofactors) -> [Judged; 2] {
        let line = self.line(camera, ray.image, ray.point);
        let with_point = self.cofactors.of_outsider(ray.point, ray.image);
        let computed = self.of_computed(&line, camera, ray.image, ray.point, common, with_point.as_ref());
        let at = [ray.x_px, ray.y_px];
        [0, 1].map(|row| computed[row].judged(at[row] - line.at[row], ray.weight, 0.0))
    }

    /// A computed column and row. `with_point` is what the image has in common with the images of the point: point and image
    /// carry the datum alike, so that without it only the point's own share can be told, as if orientations were known.
    fn of_computed(
        &self,
        line: &Linearised,
        camera: usize,
        image: usize,
        point: usize,
        common: &PointCofactors,
        with_point: Option<&[f64; 18]>,
    ) -> [Computed; 2] {
        let factor = &self.cofactors.reduced.points[point].factor;
        let f = [0, 1].map(|row| forward3(factor, line.by_point[row]));
        let Some(with_point) = with_point else {
            return f.map(|f| Computed { cofactor: f.iter().map(|v| v * v).sum(), with_point: None });
        };
        let own = self.cofactors.of_images(image, image);
        let columns = &self.cofactors.problem.columns.of_camera[camera];
        [0, 1].map(|row| {
            let mut h = form3(&f[row], &common.middle) + self.of_orientation(line, row, image, columns, &own);
            // The point moves with images and cameras: twice the product of both.
            let with_orientation = [0, 1, 2].map(|c| {
                let t = &with_point[c * N..][..N];
                let with_image: f64 = t.iter().zip(&line.by_image[row]).map(|(t, a)| t * a).sum();
                let with_camera: f64 = columns.iter().map(|(p, column)| line.by_camera[row][*p] * common.of_columns[*column][c]).sum();
                with_image + with_camera
            });
            (0..3).for_each(|c| h -= 2.0 * f[row][c] * with_orientation[c]);
            let halfway = [0, 1, 2].map(|c| (0..3).map(|k| common.middle[c][k] * f[row][k]).sum::<f64>() - with_orientation[c]);
            Computed { cofactor: h, with_point: Some(backward3(factor, halfway)) }
        })
    }

    /// What image and camera add to the cofactor of a computed coordinate.
    fn of_orientation(&self, line: &Linearised, row: usize, image: usize, columns: &[(usize, usize)], own: &Block6) -> f64 {
        let (a, c) = (&line.by_image[row], &line.by_camera[row]);
        let mut h: f64 = (0..N * N).map(|k| a[k % N] * own[k] * a[k / N]).sum();
        let q = self.cofactors.problem.columns.number();
        for (parameter, column) in columns {
            let across: f64 = self.cofactors.across(image, *column).iter().zip(a).map(|(q, a)| q * a).sum();
            h += 2.0 * c[*parameter] * across;
            for (other, second) in columns {
                h += c[*parameter] * c[*other] * self.cofactors.orientations.cameras[column * q + second];
            }
        }
        h
    }
}

/// The standard error of a coordinate of weight 1, and the error that a test detects, in standard errors of a residual.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scale {
    pub sigma: f64,
    pub shift: f64,
}

impl Scale {
    /// Tells tests alone.
    pub fn of_tests(sigma: f64) -> Self {
        Self { sigma, shift: f64::INFINITY }
    }

    /// The error of an observation that its test detects; `None` where nothing checks it.
    pub fn detectable(&self, weight: f64, redundancy: f64) -> Option<f64> {
        let shift = self.shift * self.sigma / (weight * redundancy).sqrt();
        (redundancy > LEAST_REDUNDANCY && shift.is_finite()).then_some(shift)
    }

    /// External reliability: no function of the unknowns changes by more than so many of its standard errors by the error of an observation that its test
    /// just detects; `None` where nothing checks it.
    pub fn influence(&self, redundancy: f64) -> Option<f64> {
        let influence = self.shift * ((1.0 - redundancy) / redundancy).sqrt();
        (redundancy > LEAST_REDUNDANCY && influence.is_finite()).then_some(influence)
    }
}

/// Of an observed position with the cofactors of its adjusted coordinates, which took part or not.
pub(super) fn of_position(prior: &Weighted, at: &[f64; 3], cofactors: Option<[f64; 3]>, scale: Scale, accepted: bool) -> PriorStatistics {
    let sigma = scale.sigma;
    let is_observed = [0, 1, 2].map(|k| prior.weight[k] > 0.0);
    let residual = [0, 1, 2].map(|k| if is_observed[k] { prior.position[k] - at[k] } else { 0.0 });
    let factor = if accepted { 1.0 } else { 0.0 };
    let judge = |k: usize, q: f64| if is_observed[k] { Judged::new(residual[k], prior.weight[k], factor, q) } else { Judged::default() };
    let judged = cofactors.map(|q| [0, 1, 2].map(|k| judge(k, q[k])));
    let observed = |of: &dyn Fn(usize, f64) -> Option<f64>| {
        judged.map_or([None; 3], |j| [0, 1, 2].map(|k| if is_observed[k] { of(k, j[k].redundancy) } else { None }))
    };
    PriorStatistics {
        accepted,
        residual,
        redundancy: judged.map(|j| j.map(|j| j.redundancy)),
        w: judged.map(|j| j.map(|j| if sigma > 0.0 { j.standardised / sigma } else { 0.0 })),
        detectable: observed(&|k, r| scale.detectable(prior.weight[k], r)),
        influence: observed(&|_, r| scale.influence(r)),
        moves: observed(&|k, r| Some((1.0 - r) * scale.detectable(prior.weight[k], r)?)),
        left_out: None,
    }
}

fn form3(a: &[f64; 3], m: &Matrix3) -> f64 {
    (0..9).map(|k| a[k / 3] * m[k / 3][k % 3] * a[k % 3]).sum()
}
