//! One point: its reference ray, and the other rays matched to it.

use super::RefinementOptions;
use super::outcome::{RayOutcome, RefinedPoint, RefinedRay};
use super::reference::references;
use super::windows::{RayPlace, RayWindow};
use crate::Error;
use crate::matches::{LeastSquares, LeastSquaresOptions, WindowFit};

/// Rays that are tried as reference, as long as rays are left that are not refined.
const MOST_REFERENCES: usize = 3;
/// Px of the matched level by which a window that is matched back may miss the reference.
const RETURN_PX: f64 = 0.3;

/// A ray with what it shows.
#[derive(Clone)]
pub struct WindowedRay<'a> {
    pub place: RayPlace,
    /// Dominant direction in rad from x towards y.
    pub orientation_rad: f64,
    /// As [`ray_windows`](super::ray_windows) cuts them; none at a level that is too small for one.
    pub windows: Vec<RayWindow<'a>>,
}

impl<'a> WindowedRay<'a> {
    pub(super) fn window(&self, halvings: u32) -> Option<&RayWindow<'a>> {
        self.windows.iter().find(|window| window.halvings == halvings)
    }

    fn check(&self) -> Result<(), Error> {
        self.place.check()?;
        if self.orientation_rad.is_finite() {
            return Ok(());
        }
        Err(Error::InvalidInput { what: "direction of a ray", got: self.orientation_rad.to_string(), allowed: "finite numbers".into() })
    }
}

/// A matrix that takes px from one ray to px from another.
type Affine = [[f64; 2]; 2];

/// Where a window of the reference was found, in px of the image.
#[derive(Clone, Copy)]
struct Found {
    position: [f64; 2],
    affine: Affine,
    standard_error_px: f64,
    correlation: f64,
    /// Of the reference, and of the ray.
    halvings: [u32; 2],
}

/// Refines points one after another; it keeps the tables of the matching.
pub struct PointRefiner {
    matching: LeastSquares,
    options: RefinementOptions,
}

impl PointRefiner {
    /// # Errors
    /// [`Error::InvalidOption`].
    pub fn new(options: &RefinementOptions) -> Result<Self, Error> {
        options.check()?;
        Ok(Self { matching: LeastSquares::new(options.window), options: options.clone() })
    }

    /// Matches the rays of a point to one of them, the reference.
    ///
    /// The reference is a ray of middling scale and high contrast; where rays cannot be matched to it, others are tried, and the one to which
    /// most are matched is taken. A match starts from the similarity of the two features, at the level of the image at which the reference's
    /// scale is small, and goes on level by level to the image itself; of these the one with the smallest standard error holds. A ray that
    /// is not matched keeps its place and says why. The reference keeps its place: its own error moves the point on the ground, and does
    /// not part the rays.
    ///
    /// # Errors
    /// [`Error::TooFew`] for fewer than two rays; [`Error::InvalidInput`] for numbers that are none.
    ///
    /// # Source
    /// Grün 1985, Adaptive least squares correlation; Agouris & Schenk 1996, Automated aerotriangulation using multiple image multipoint
    /// matching (rays of a point matched to one of them).
    pub fn refine(&mut self, rays: &[WindowedRay<'_>]) -> Result<RefinedPoint, Error> {
        if rays.len() < 2 {
            return Err(Error::TooFew { what: "rays of a point", got: rays.len(), needed: 2 });
        }
        rays.iter().try_for_each(WindowedRay::check)?;
        let mut best: Option<(usize, RefinedPoint)> = None;
        for reference in references(rays, self.options.window).into_iter().take(MOST_REFERENCES) {
            let point = self.refine_to(reference, rays);
            let refined = point.rays.iter().filter(|ray| ray.outcome == RayOutcome::Refined).count();
            if best.as_ref().is_none_or(|(most, _)| refined > *most) {
                best = Some((refined, point));
            }
            if refined + 1 == rays.len() {
                break;
            }
        }
        Ok(best.map(|(_, point)| point).expect("a point has rays"))
    }

    fn refine_to(&mut self, reference: usize, rays: &[WindowedRay<'_>]) -> RefinedPoint {
        let refined = |(index, ray): (usize, &WindowedRay<'_>)| {
            let at = |outcome| RefinedRay { outcome, position: ray.place.position, standard_error_px: None, correlation: None };
            if index == reference {
                return at(RayOutcome::Reference);
            }
            match self.matched(&rays[reference], ray) {
                Ok(found) => RefinedRay {
                    outcome: RayOutcome::Refined,
                    position: found.position,
                    standard_error_px: Some(found.standard_error_px),
                    correlation: Some(found.correlation),
                },
                Err(outcome) => at(outcome),
            }
        };
        RefinedPoint { reference, rays: rays.iter().enumerate().map(refined).collect() }
    }

    fn matched(&mut self, reference: &WindowedRay<'_>, ray: &WindowedRay<'_>) -> Result<Found, RayOutcome> {
        let (mut start, mut affine) = (ray.place.position, similarity(reference, ray));
        let mut best: Result<Found, RayOutcome> = Err(RayOutcome::LeftImage);
        for halvings in (0..=reference.place.most_halvings()).rev() {
            match self.matched_at(halvings, reference, ray, (start, affine)) {
                Ok(found) => {
                    (start, affine) = (found.position, found.affine);
                    if best.as_ref().map_or(true, |best| found.standard_error_px < best.standard_error_px) {
                        best = Ok(found);
                    }
                }
                // A smaller window may still lie inside.
                Err(RayOutcome::LeftImage) => {}
                Err(outcome) => {
                    best = best.or(Err(outcome));
                    break;
                }
            }
        }
        let found = best?;
        if self.leads_back(reference, ray, &found) { Ok(found) } else { Err(RayOutcome::Inconsistent) }
    }

    /// Matches at one level of the reference, in the level of the ray that has it about as large.
    fn matched_at(
        &mut self,
        halvings: u32,
        reference: &WindowedRay<'_>,
        ray: &WindowedRay<'_>,
        (start, affine): ([f64; 2], Affine),
    ) -> Result<Found, RayOutcome> {
        let own = level_of(halvings, &affine);
        let (Some(left), Some(right)) = (reference.window(halvings), ray.window(own)) else { return Err(RayOutcome::LeftImage) };
        let px = f64::from(1u32 << own);
        let ratio = f64::from(1u32 << halvings) / px;
        let farthest = self.options.farthest * ray.place.scale_px;
        let options = self.matching_options(farthest / px);
        let fit = self.matching.fit(
            (left.grey, left.place(reference.place.position)),
            (right.grey, right.place(start)),
            scaled(&affine, ratio),
            &options,
        )?;
        let found = Found {
            position: right.position(fit.position),
            affine: scaled(&fit.affine, 1.0 / ratio),
            standard_error_px: standard_error(&fit) * px,
            correlation: fit.correlation,
            halvings: [halvings, own],
        };
        let moved = [0, 1].map(|axis| found.position[axis] - ray.place.position[axis]);
        if moved[0] * moved[0] + moved[1] * moved[1] > farthest * farthest {
            return Err(RayOutcome::MovedTooFar);
        }
        Ok(found)
    }

    /// Whether the window that was found leads back to the reference.
    fn leads_back(&mut self, reference: &WindowedRay<'_>, ray: &WindowedRay<'_>, found: &Found) -> bool {
        let [halvings, own] = found.halvings;
        let (Some(left), Some(right)) = (reference.window(halvings), ray.window(own)) else { return false };
        let ratio = f64::from(1u32 << halvings) / f64::from(1u32 << own);
        let Some(back) = inverse(&scaled(&found.affine, ratio)) else { return false };
        let start = left.place(reference.place.position);
        let options = self.matching_options(1.0);
        let fit = self.matching.fit((right.grey, right.place(found.position)), (left.grey, start), back, &options);
        fit.is_ok_and(|fit| {
            let missed = [0, 1].map(|axis| fit.position[axis] - start[axis]);
            missed[0] * missed[0] + missed[1] * missed[1] <= RETURN_PX * RETURN_PX
        })
    }

    fn matching_options(&self, farthest_px: f64) -> LeastSquaresOptions {
        LeastSquaresOptions { farthest_px, least_correlation: self.options.least_correlation, ..LeastSquaresOptions::default() }
    }
}

/// The halvings at which a ray shows the reference's level about as large as that does.
fn level_of(halvings: u32, affine: &Affine) -> u32 {
    let zoom = determinant(affine).sqrt();
    (f64::from(halvings) + libm::round(libm::log2(zoom))).max(0.0) as u32
}

/// From px about the reference to px about the ray, by the scales and directions of the two features.
fn similarity(reference: &WindowedRay<'_>, ray: &WindowedRay<'_>) -> Affine {
    let zoom = ray.place.scale_px / reference.place.scale_px;
    let turn = ray.orientation_rad - reference.orientation_rad;
    let (sin, cos) = (zoom * libm::sin(turn), zoom * libm::cos(turn));
    [[cos, -sin], [sin, cos]]
}

fn determinant([[a, b], [c, d]]: &Affine) -> f64 {
    a * d - b * c
}

fn inverse(affine: &Affine) -> Option<Affine> {
    let whole = determinant(affine);
    let [[a, b], [c, d]] = *affine;
    (whole > 0.0).then(|| [[d / whole, -b / whole], [-c / whole, a / whole]])
}

fn scaled(affine: &Affine, by: f64) -> Affine {
    affine.map(|row| row.map(|v| v * by))
}

/// In px in the worst direction.
fn standard_error(fit: &WindowFit) -> f64 {
    crate::Fit { correlation: fit.correlation, covariance: fit.covariance, iterations: fit.iterations }.standard_error_px()
}
