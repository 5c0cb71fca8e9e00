//! What can be said of each observation: its share in the result, its test, the blunders that it may hide.

use super::adjusted::Adjusted;
use super::coplanarity::{Ray, RelativePose};
use super::normals::Matrix5;
use super::precision::derivatives;
use super::rejection::share_of_unknowns;
use super::result::PointStatistics;

/// What the statistics of all points have in common.
pub(super) struct Judgement<'a> {
    pub adjusted: &'a Adjusted,
    /// Standard error of a coordinate of weight 1 in focal lengths: a priori, or estimated; 0 without either.
    pub sigma: f64,
    /// Cofactors of ω φ κ by bz, `b` in mm.
    pub propagated: &'a Matrix5,
    pub base_mm: f64,
    pub focal_mm: f64,
    /// δ₀.
    pub noncentrality: f64,
}

impl Judgement<'_> {
    /// Statistics of an observation of an own weight, which took part with a factor of it (0: rejected).
    ///
    /// # Source
    /// Baarda 1968, A testing procedure for use in geodetic networks; Förstner & Wrobel 2016, Photogrammetric Computer Vision, 4.6.
    pub fn of(&self, ray: &Ray, weight: f64, factor: f64) -> Option<PointStatistics> {
        let pose = &self.adjusted.pose;
        let (at, distance) = pose.project(ray);
        let line = pose.linearise(&pose.tangents(), ray, &at)?;
        let share = weight * if factor > 0.0 { factor } else { 1.0 } * share_of_unknowns(&line, self.adjusted);
        // A new observation has the whole of its own error and what the unknowns are off.
        let redundancy = if factor > 0.0 { (1.0 - share).clamp(0.0, 1.0) } else { 1.0 / (1.0 + share) };
        let spread = if factor > 0.0 { redundancy } else { 1.0 + share };
        let across_right = (line.by_coordinates[2] * line.by_coordinates[2] + line.by_coordinates[3] * line.by_coordinates[3]).sqrt();
        let standard = self.sigma * (spread / weight).sqrt();
        let w = if standard > 0.0 && spread > 1e-6 { distance / standard } else { 0.0 };
        let blunder = self.noncentrality * self.sigma / (redundancy * weight).sqrt();
        // One that is added to the normal equations shares its effect with them.
        let taking_part = if factor > 0.0 { factor } else { 1.0 / (1.0 + share) };
        let change = derivatives(pose, self.base_mm) * (self.adjusted.cofactors * line.by_unknowns) * (weight * taking_part * blunder);
        let in_errors = |k: usize| change[k].abs() / (self.sigma * self.propagated[(k, k)].sqrt());
        let influence = (0..5).map(in_errors).filter(|v| v.is_finite()).fold(0.0, f64::max);
        Some(PointStatistics {
            parallax_mm: distance / across_right * self.focal_mm,
            redundancy,
            w,
            detectable_mm: blunder / across_right * self.focal_mm,
            influence,
            weight: weight * factor,
            model_mm: model_point(pose, &at, self.base_mm),
        })
    }
}

/// Where the adjusted rays meet, in mm at photo scale.
fn model_point(pose: &RelativePose, at: &Ray, base_mm: f64) -> Option<[f64; 3]> {
    let scale = (base_mm / pose.base.x).abs();
    let depth = pose.depth(at)? * scale;
    Some([depth * at[0], depth * at[1], -depth])
}
