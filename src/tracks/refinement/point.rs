//! One point: its reference ray, and the other rays matched to it.

use super::RefinementOptions;
use super::outcome::{ObservationRefinement, RefinedPoint, RefinementOutcome};
use super::reference::references;
use super::windows::WindowedObservation;
use crate::matching::{LeastSquares, LeastSquaresOptions, WindowFit};
use crate::{Error, Few};

/// Rays that are tried as reference, as long as rays are left that are not refined.
const MOST_REFERENCES: usize = 3;
/// Px of the matched level by which a window that is matched back may miss the reference.
const RETURN_PX: f64 = 0.3;

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
        options.check_ranges()?;
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
    /// Grün 1985, Adaptive least squares correlation, South African Journal of Photogrammetry, Remote Sensing and Cartography 14 (3).
    pub fn refine(&mut self, rays: &[WindowedObservation<'_>]) -> Result<RefinedPoint, Error> {
        if rays.len() < 2 {
            return Err(Error::TooFew { few: Few::ObservationsOfPoint, got: rays.len(), needed: 2 });
        }
        rays.iter().try_for_each(WindowedObservation::check)?;
        let mut best: Option<(usize, RefinedPoint)> = None;
        for reference in references(rays, self.options.window).into_iter().take(MOST_REFERENCES) {
            let point = self.refine_to(reference, rays);
            let refined = point.rays.iter().filter(|ray| ray.outcome == RefinementOutcome::Refined).count();
            if best.as_ref().is_none_or(|(most, _)| refined > *most) {
                best = Some((refined, point));
            }
            if refined + 1 == rays.len() {
                break;
            }
        }
        Ok(best.map(|(_, point)| point).expect("a point has rays"))
    }

    fn refine_to(&mut self, reference: usize, rays: &[WindowedObservation<'_>]) -> RefinedPoint {
        let refined = |(index, ray): (usize, &WindowedObservation<'_>)| {
            let at = |outcome| ObservationRefinement { outcome, position: ray.place.position, standard_error_px: None, correlation: None };
            if index == reference {
                return at(RefinementOutcome::Reference);
            }
            match self.matched(&rays[reference], ray) {
                Ok(found) => ObservationRefinement {
                    outcome: RefinementOutcome::Refined,
                    position: found.position,
                    standard_error_px: Some(found.standard_error_px),
                    correlation: Some(found.correlation),
                },
                Err(outcome) => at(outcome),
            }
        };
        RefinedPoint { reference, rays: rays.iter().enumerate().map(refined).collect() }
    }

    fn matched(&mut self, reference: &WindowedObservation<'_>, ray: &WindowedObservation<'_>) -> Result<Found, RefinementOutcome> {
        let (mut start, mut affine) = (ray.place.position, similarity(reference, ray));
        let mut best: Result<Found, RefinementOutcome> = Err(RefinementOutcome::LeftImage);
        for halvings in (0..=reference.place.most_halvings()).rev() {
            match self.matched_at(halvings, reference, ray, (start, affine)) {
                Ok(found) => {
                    (start, affine) = (found.position, found.affine);
                    if best.as_ref().map_or(true, |best| found.standard_error_px < best.standard_error_px) {
                        best = Ok(found);
                    }
                }
                // A smaller window may still lie inside.
                Err(RefinementOutcome::LeftImage) => {}
                Err(outcome) => {
                    best = best.or(Err(outcome));
                    break;
                }
            }
        }
        let found = best?;
        if self.leads_back(reference, ray, &found) { Ok(found) } else { Err(RefinementOutcome::Inconsistent) }
    }

    /// Matches at one level of the reference, in the level of the ray that has it about as large.
    fn matched_at(
        &mut self,
        halvings: u32,
        reference: &WindowedObservation<'_>,
        ray: &WindowedObservation<'_>,
        (start, affine): ([f64; 2], Affine),
    ) -> Result<Found, RefinementOutcome> {
        // Where the ray has no level as coarse, the next finer one serves: it shows the reference up to twice as large.
        let coarsest = ray.windows.last().map_or(0, |window| window.halvings);
        let own = level_of(halvings, &affine).min(coarsest);
        let (Some(left), Some(right)) = (reference.window(halvings), ray.window(own)) else { return Err(RefinementOutcome::LeftImage) };
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
            return Err(RefinementOutcome::MovedTooFar);
        }
        Ok(found)
    }

    /// Whether the window that was found leads back to the reference.
    fn leads_back(&mut self, reference: &WindowedObservation<'_>, ray: &WindowedObservation<'_>, found: &Found) -> bool {
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
fn similarity(reference: &WindowedObservation<'_>, ray: &WindowedObservation<'_>) -> Affine {
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

#[cfg(test)]
mod tests {
    use super::super::{ObservationWindows, WindowCentre, observation_windows};
    use super::*;
    use crate::GreyImage;
    use crate::matching::texture::Texture;

    const SIZE: usize = 200;
    const MIDDLE: f64 = 100.0;
    /// Off the pixels, as features are.
    const SHOWN: [f64; 2] = [101.37, 98.81];

    /// An image of the texture deformed about the middle and shifted, and the ray that shows the place of [`SHOWN`], found off by `error`.
    struct Shot {
        image: GreyImage,
        place: WindowCentre,
        orientation_rad: f64,
        truth: [f64; 2],
        matrix: Affine,
    }

    fn turned(m: &Affine, [x, y]: [f64; 2]) -> [f64; 2] {
        [m[0][0] * x + m[0][1] * y, m[1][0] * x + m[1][1] * y]
    }

    fn shot(texture: &Texture, matrix: Affine, shift: [f64; 2], error: [f64; 2], scale_px: f64, seed: u32) -> Shot {
        let back = inverse(&matrix).unwrap();
        let image = texture.image(
            SIZE,
            |p| turned(&back, [0, 1].map(|axis| p[axis] - MIDDLE - shift[axis])).map(|v| v + MIDDLE),
            [1.0, 0.0, 0.0],
            seed,
        );
        let moved = turned(&matrix, SHOWN.map(|v| v - MIDDLE));
        let truth = [0, 1].map(|axis| MIDDLE + shift[axis] + moved[axis]);
        let zoom = determinant(&matrix).sqrt();
        let place = WindowCentre { position: [0, 1].map(|axis| truth[axis] + error[axis]), scale_px: scale_px * zoom };
        Shot { image, place, orientation_rad: libm::atan2(matrix[1][0] - matrix[0][1], matrix[0][0] + matrix[1][1]), truth, matrix }
    }

    fn windows(shots: &[Shot]) -> Vec<ObservationWindows> {
        shots.iter().map(|shot| observation_windows(shot.image.view(), &[shot.place], &RefinementOptions::default()).unwrap()).collect()
    }

    fn rays<'a>(shots: &[Shot], windows: &'a [ObservationWindows]) -> Vec<WindowedObservation<'a>> {
        let ray = |(shot, own): (&Shot, &'a ObservationWindows)| WindowedObservation {
            place: shot.place,
            orientation_rad: shot.orientation_rad,
            windows: own.of_ray(0).unwrap(),
        };
        shots.iter().zip(windows).map(ray).collect()
    }

    fn refined(shots: &[Shot]) -> RefinedPoint {
        let windows = windows(shots);
        PointRefiner::new(&RefinementOptions::default()).unwrap().refine(&rays(shots, &windows)).unwrap()
    }

    fn turn(angle: f64, zoom: f64) -> Affine {
        let (sin, cos) = (zoom * libm::sin(angle), zoom * libm::cos(angle));
        [[cos, -sin], [sin, cos]]
    }

    const UNIT: Affine = [[1.0, 0.0], [0.0, 1.0]];

    #[test]
    fn rays_are_moved_to_a_fiftieth_of_a_pixel_of_the_reference() {
        for (seed, scale_px) in [(3, 2.0), (4, 2.9), (5, 3.4), (6, 6.0)] {
            let texture = Texture::new(seed, 4.0, 40.0);
            let sheared = [[1.06, -0.05], [0.07, 0.95]];
            let shots = [
                shot(&texture, UNIT, [0.0; 2], [0.0; 2], scale_px, 1),
                shot(&texture, sheared, [3.3, -2.4], [0.5, -0.4], scale_px, 2),
                shot(&texture, turn(2.2, 1.0), [-4.7, 1.2], [-0.3, 0.6], scale_px, 3),
                shot(&texture, turn(-1.1, 1.25), [0.4, 0.6], [0.6, 0.2], scale_px, 4),
            ];
            let point = refined(&shots);
            // The reference keeps its error: what counts is where the others are relative to it.
            let error = |k: usize| [0, 1].map(|axis| point.rays[k].position[axis] - shots[k].truth[axis]);
            let reference = error(point.reference);
            let on_ground = turned(&inverse(&shots[point.reference].matrix).unwrap(), reference);
            for k in (0..4).filter(|k| *k != point.reference) {
                let ray = &point.rays[k];
                assert_eq!(ray.outcome, RefinementOutcome::Refined, "{scale_px} {k}");
                let (own, expected) = (error(k), turned(&shots[k].matrix, on_ground));
                let off = [0, 1].map(|axis| (own[axis] - expected[axis]).abs());
                assert!(off[0] < 0.02 && off[1] < 0.02, "scale {scale_px}, ray {k}: {off:?}");
                assert!(ray.standard_error_px.unwrap() < 0.03 && ray.correlation.unwrap() > 0.98, "{ray:?}");
            }
            assert_eq!(point.rays[point.reference].position, shots[point.reference].place.position);
        }
    }

    #[test]
    fn a_ray_on_other_ground_keeps_its_place_and_says_why() {
        let (texture, other) = (Texture::new(3, 4.0, 40.0), Texture::new(11, 4.0, 40.0));
        let shots = [
            shot(&texture, UNIT, [0.0; 2], [0.0; 2], 2.0, 1),
            shot(&other, UNIT, [0.0; 2], [0.0; 2], 2.0, 2),
            shot(&texture, UNIT, [1.5, 0.5], [0.3, 0.3], 2.0, 3),
        ];
        let point = refined(&shots);
        assert_eq!(point.rays[1].position, shots[1].place.position);
        let refusals = [
            RefinementOutcome::NotConverged,
            RefinementOutcome::MovedTooFar,
            RefinementOutcome::LowCorrelation,
            RefinementOutcome::Inconsistent,
        ];
        assert!(refusals.contains(&point.rays[1].outcome) && point.rays[1].correlation.is_none(), "{:?}", point.rays[1]);
        // Whichever of the other two is the reference, the other one is matched to it.
        let outcomes = [point.rays[0].outcome, point.rays[2].outcome];
        assert!(outcomes.contains(&RefinementOutcome::Reference) && outcomes.contains(&RefinementOutcome::Refined), "{outcomes:?}");
    }

    #[test]
    fn what_is_too_far_or_at_the_border_keeps_its_place() {
        let texture = Texture::new(3, 8.0, 40.0);
        let far = [shot(&texture, UNIT, [0.0; 2], [0.0; 2], 2.0, 1), shot(&texture, UNIT, [0.0; 2], [2.2, 0.0], 2.0, 2)];
        let point = refined(&far);
        let moved = &point.rays[1 - point.reference];
        assert!(matches!(moved.outcome, RefinementOutcome::MovedTooFar | RefinementOutcome::Inconsistent), "{moved:?}");
        let border = [shot(&texture, UNIT, [0.0; 2], [0.0; 2], 2.0, 1), shot(&texture, UNIT, [95.0, 0.0], [0.0; 2], 2.0, 2)];
        let point = refined(&border);
        assert_eq!(point.rays[1 - point.reference].outcome, RefinementOutcome::LeftImage);
        let flat = GreyImage::from_fn(SIZE, SIZE, |_, _| 90).unwrap();
        let even =
            |shot: &Shot| Shot { image: flat.clone(), place: shot.place, orientation_rad: 0.0, truth: shot.truth, matrix: shot.matrix };
        let point = refined(&[even(&border[0]), even(&border[0])]);
        assert_eq!(point.rays[1].outcome, RefinementOutcome::NoTexture);
    }

    #[test]
    fn too_few_rays_and_numbers_that_are_none_are_refused() {
        let texture = Texture::new(3, 4.0, 40.0);
        let shots = [shot(&texture, UNIT, [0.0; 2], [0.0; 2], 2.0, 1), shot(&texture, UNIT, [0.0; 2], [0.0; 2], 2.0, 2)];
        let cut = windows(&shots);
        let good = rays(&shots, &cut);
        let mut refiner = PointRefiner::new(&RefinementOptions::default()).unwrap();
        assert_eq!(refiner.refine(&[]).unwrap_err().code(), "too-few");
        assert_eq!(refiner.refine(&good[..1]).unwrap_err().code(), "too-few");
        let changed = |change: &dyn Fn(&mut WindowedObservation<'_>)| {
            let mut wrong = good.clone();
            change(&mut wrong[1]);
            PointRefiner::new(&RefinementOptions::default()).unwrap().refine(&wrong).unwrap_err().code()
        };
        assert_eq!(changed(&|ray| ray.orientation_rad = f64::NAN), "invalid-input");
        assert_eq!(changed(&|ray| ray.place.scale_px = f64::NAN), "invalid-input");
        assert_eq!(changed(&|ray| ray.place.position[1] = f64::INFINITY), "invalid-input");
        let wrong = RefinementOptions { least_correlation: f64::NAN, ..RefinementOptions::default() };
        assert!(matches!(PointRefiner::new(&wrong), Err(Error::InvalidOption { field: "refinement.least_correlation", .. })));
    }

    #[test]
    fn the_order_of_points_does_not_matter() {
        let texture = Texture::new(3, 4.0, 40.0);
        let points: Vec<[Shot; 2]> = [2.0, 3.4]
            .map(|scale| {
                [shot(&texture, UNIT, [0.0; 2], [0.0; 2], scale, 1), shot(&texture, turn(0.4, 1.1), [1.2, 0.3], [0.4, 0.1], scale, 2)]
            })
            .into();
        let cut: Vec<Vec<ObservationWindows>> = points.iter().map(|shots| windows(shots)).collect();
        let mut one = PointRefiner::new(&RefinementOptions::default()).unwrap();
        let forward: Vec<RefinedPoint> = (0..2).map(|k| one.refine(&rays(&points[k], &cut[k])).unwrap()).collect();
        let mut other = PointRefiner::new(&RefinementOptions::default()).unwrap();
        let backward: Vec<RefinedPoint> = (0..2).rev().map(|k| other.refine(&rays(&points[k], &cut[k])).unwrap()).collect();
        assert_eq!((&forward[0], &forward[1]), (&backward[1], &backward[0]));
    }
}
