//! What can be said of each observation: its share in the result, its test, the blunders that it may hide.

use super::adjusted::Adjusted;
use super::condition::Condition;
use super::coplanarity::{Linearised, Ray, RelativePose};
use super::normals::{Matrix5, times};
use super::rejection::share_of_unknowns;
use super::result::PointStatistics;

/// What the statistics of all points have in common.
pub(super) struct Judgement<'a> {
    pub adjusted: &'a Adjusted,
    /// N⁻¹, or of unweighted determinants the cofactors of what they estimate.
    pub covariance: &'a Matrix5,
    /// Whether the observations took part with other weights than their own.
    pub unweighted: bool,
    /// Standard error of a coordinate of weight 1 in focal lengths: a priori, or estimated; 0 without either.
    pub sigma: f64,
    /// Derivatives of ω φ κ by bz by the unknowns of the adjustment, `b` in mm, and the cofactors of these five.
    pub derivatives: Matrix5,
    pub propagated: &'a Matrix5,
    pub base_mm: f64,
    pub focal_mm: f64,
    /// δ₀.
    pub noncentrality: f64,
}

impl Judgement<'_> {
    /// Statistics of an observation of an own weight, which took part with a factor of it (0: rejected) and the weight `solved` in the normal
    /// equations, which of unweighted determinants is not its own.
    ///
    /// # Source
    /// Baarda 1968, A testing procedure for use in geodetic networks; Förstner & Wrobel 2016, Photogrammetric Computer Vision, 4.6.
    pub fn of(&self, &Condition { at, distance, line }: &Condition, weight: f64, factor: f64, solved: f64) -> Option<PointStatistics> {
        let line = line?;
        let accepted = factor > 0.0;
        let share = solved * if accepted { factor } else { 1.0 } * share_of_unknowns(&line, self.adjusted);
        // A new observation has the whole of its own error and what the unknowns are off.
        let redundancy = if accepted { (1.0 - share).clamp(0.0, 1.0) } else { 1.0 / (1.0 + share) };
        // Cofactor of the residual times the weight.
        let spread = match (self.unweighted, accepted) {
            (false, true) => redundancy,
            (false, false) => 1.0 + share,
            (true, _) => {
                let of_unknowns = weight * line.by_unknowns.dot(&times(self.covariance, &line.by_unknowns));
                if accepted { (1.0 - 2.0 * share + of_unknowns).max(0.0) } else { 1.0 + of_unknowns }
            }
        };
        let standard = self.sigma * (spread / weight).sqrt();
        let w = if standard > 0.0 && spread > 1e-6 { distance / standard } else { 0.0 };
        // An error shows with the share r in the residual of an accepted observation, wholly in that of a new one.
        let shown = if accepted { redundancy } else { 1.0 };
        // Nothing is detectable without redundancy, of the observation or of the adjustment.
        let blunder = Some(self.noncentrality * standard / shown).filter(|size| !size.is_nan()).unwrap_or(f64::INFINITY);
        // One that is added to the normal equations shares its effect with them.
        let taking_part = if accepted { factor } else { 1.0 / (1.0 + share) };
        let change = times(&self.derivatives, &times(&self.adjusted.cofactors, &line.by_unknowns)) * (solved * taking_part * blunder);
        let in_errors = |k: usize| change[k].abs() / (self.sigma * self.propagated[(k, k)].sqrt());
        let influence = (0..5).map(in_errors).filter(|v| !v.is_nan()).fold(0.0, f64::max);
        Some(PointStatistics {
            parallax_mm: parallax_mm(distance, &line, self.focal_mm),
            redundancy,
            w,
            detectable_mm: parallax_mm(blunder, &line, self.focal_mm),
            influence,
            weight: weight * factor,
            model_mm: model_point(&self.adjusted.pose, &at, self.base_mm),
        })
    }
}

/// How far the right point would lie across its epipolar line, for a distance from the condition in focal lengths.
pub(super) fn parallax_mm(distance: f64, line: &Linearised, focal_mm: f64) -> f64 {
    let [.., x, y] = line.by_coordinates;
    distance / (x * x + y * y).sqrt() * focal_mm
}

/// Where the adjusted rays meet, in mm at photo scale.
pub(super) fn model_point(pose: &RelativePose, at: &Ray, base_mm: f64) -> Option<[f64; 3]> {
    let scale = (base_mm / pose.base.x).abs();
    let depth = pose.depth(at)? * scale;
    Some([depth * at[0], depth * at[1], -depth])
}
