//! The adjustment of the pose with the constants of the cameras and the modes that matches share, by their prior information.

use super::constants::{CAMERA, cameras_of, effects, growth, priors, rays, shared_constants, with_constants};
use super::measured::Measured;
use super::result::SelfCalibration;
use crate::orientation::{Extent, MODES, RelativePose};
use crate::pair::geometry::PairInterior;
use nalgebra::{DMatrix, DVector};
use std::collections::BTreeMap;

/// Unknowns of the pose.
const POSE: usize = 5;

/// Steps after which the adjustment ends, and the longest change of an unknown in one of them.
const MOST_STEPS: usize = 50;
const LONGEST_STEP: f64 = 0.2;
/// Prior standard deviations by which a value may differ from what was known before.
const MOST_UNLIKE: f64 = 3.0;
/// Halvings of a step that would make the agreement worse.
const MOST_HALVINGS: usize = 6;
/// A step is settled where it moves no unknown by more of its standard error.
const SETTLED: f64 = 0.01;
/// Standard errors beyond which the weight of a match falls, for an efficiency of 95 % with normal errors (Huber 1981, Robust Statistics).
const HUBER: f64 = 1.345;

/// Estimates what is not known of the cameras together with the pose, from a pose that was found with the cameras as given. `None` where
/// the adjustment does not settle.
pub fn calibrated(given: &PairInterior, measured: &Measured<'_>, start: RelativePose) -> Option<SelfCalibration> {
    let adjustment = Adjustment::new(given, measured);
    let mut state = State { pose: start, values: DVector::zeros(adjustment.priors.len()) };
    let mut best = adjustment.objective(&state);
    for _ in 0..MOST_STEPS {
        let equations = adjustment.equations(&state);
        let cofactors = equations.normal.clone().cholesky()?.inverse();
        let whole = &cofactors * &equations.right;
        (state, best) = adjustment.stepped(&state, &whole, best);
        if (0..whole.len()).all(|k| whole[k].abs() <= SETTLED * measured.sigma * cofactors[(k, k)].max(0.0).sqrt()) {
            return adjustment.outcome(state, &equations, &cofactors);
        }
    }
    None
}

/// The unknowns: the pose, and the constants of the cameras with the modes.
struct State {
    pose: RelativePose,
    values: DVector<f64>,
}

/// The normal equations, and the sums of their right sides over cells of neighbours.
struct Equations {
    normal: DMatrix<f64>,
    right: DVector<f64>,
    cells: BTreeMap<[i64; 2], DVector<f64>>,
}

/// Adds what an observation of the difference of two unknowns adds to a normal matrix.
fn add_difference(matrix: &mut DMatrix<f64>, [k, l]: [usize; 2], weight: f64) {
    for (row, column, sign) in [(k, k, 1.0), (l, l, 1.0), (k, l, -1.0), (l, k, -1.0)] {
        matrix[(row, column)] += sign * weight;
    }
}

/// The adjustment of pose, cameras and modes.
struct Adjustment<'a> {
    given: &'a PairInterior,
    measured: &'a Measured<'a>,
    cameras: usize,
    priors: DVector<f64>,
    /// Pairs of values that are equal, each with the standard deviation of their difference.
    shared: Vec<([usize; 2], f64)>,
    extent: Extent,
}

impl<'a> Adjustment<'a> {
    fn new(given: &'a PairInterior, measured: &'a Measured<'a>) -> Self {
        let cameras = cameras_of(given);
        let extent = Extent::of(&rays(measured.positions, given));
        let mut priors = priors(given, cameras, measured.shared_parallax.map(|deviation| deviation * measured.sigma));
        let shared = shared_constants(given, cameras);
        // Two values that are equal have what is known of them together.
        shared.iter().flat_map(|(pair, _)| pair).for_each(|k| priors[*k] *= std::f64::consts::SQRT_2);
        Self { given, measured, cameras, priors, shared, extent }
    }

    /// What the modes add to the misclosure of a ray.
    fn shift(&self, modes: &[f64; MODES], values: &DVector<f64>) -> f64 {
        modes.iter().enumerate().map(|(k, mode)| mode * values[self.cameras * CAMERA + k]).sum()
    }

    /// What is minimised: Huber's function of the corrections of positions, and the prior information.
    fn objective(&self, State { pose, values }: &State) -> f64 {
        let (growth, tangents) = (growth(values, self.cameras), pose.tangents());
        let rays = rays(self.measured.positions, &with_constants(self.given, values, self.cameras));
        let of_matches = rays.iter().zip(self.measured.weights).filter_map(|(ray, weight)| {
            let line = pose.linearise(&tangents, ray, &pose.project(ray).0)?;
            let misclosure = line.misclosure + self.shift(&self.extent.modes(ray), values);
            let distance = growth * misclosure.abs() * weight.sqrt() / self.measured.sigma;
            Some(if distance < HUBER { distance * distance } else { HUBER * (2.0 * distance - HUBER) })
        });
        let of_priors = values.iter().zip(self.priors.iter()).map(|(value, prior)| (value / prior) * (value / prior)).sum::<f64>();
        let of_shared = self.shared.iter().map(|([k, l], deviation)| ((values[*k] - values[*l]) / deviation).powi(2)).sum::<f64>();
        of_matches.sum::<f64>() + of_priors + of_shared
    }

    fn equations(&self, State { pose, values }: &State) -> Equations {
        let (constants, unknowns) = (self.cameras * CAMERA, POSE + self.priors.len());
        let (growth, tangents) = (growth(values, self.cameras), pose.tangents());
        let (mut normal, mut right) = (DMatrix::zeros(unknowns, unknowns), DVector::zeros(unknowns));
        let mut cells: BTreeMap<[i64; 2], DVector<f64>> = BTreeMap::new();
        let effects = effects(self.measured.positions, self.given, values, self.cameras);
        let rays = rays(self.measured.positions, &with_constants(self.given, values, self.cameras));
        for (index, (ray, weight)) in rays.iter().zip(self.measured.weights).enumerate() {
            let Some(line) = pose.linearise(&tangents, ray, &pose.project(ray).0) else { continue };
            let modes = self.extent.modes(ray);
            let misclosure = line.misclosure + self.shift(&modes, values);
            let mut row = DVector::zeros(unknowns);
            row.rows_mut(0, POSE).copy_from(&line.by_unknowns);
            for (k, effect) in effects.iter().enumerate() {
                row[POSE + k] = (0..4).map(|c| line.by_coordinates[c] * effect[index][c]).sum();
            }
            for camera in 0..self.cameras {
                row[POSE + camera * CAMERA] += misclosure / self.cameras as f64;
            }
            row.rows_mut(POSE + constants, MODES).copy_from_slice(&modes);
            let (row, misclosure) = (row * growth, misclosure * growth);
            let distance = misclosure.abs() * weight.sqrt();
            let weight = weight * (HUBER * self.measured.sigma / distance.max(f64::MIN_POSITIVE)).min(1.0);
            normal.ger(weight, &row, &row, 1.0);
            right.axpy(-weight * misclosure, &row, 1.0);
            let cell = [ray[0], ray[1]].map(|v| libm::floor(v / self.measured.neighbourhood) as i64);
            *cells.entry(cell).or_insert_with(|| DVector::zeros(unknowns)) += row * (weight * misclosure);
        }
        for (k, prior) in self.priors.iter().enumerate() {
            let weight = self.variance() / (prior * prior);
            normal[(POSE + k, POSE + k)] += weight;
            right[POSE + k] -= weight * values[k];
        }
        for ([k, l], deviation) in &self.shared {
            let weight = self.variance() / (deviation * deviation);
            add_difference(&mut normal, [POSE + k, POSE + l], weight);
            right[POSE + k] -= weight * (values[*k] - values[*l]);
            right[POSE + l] += weight * (values[*k] - values[*l]);
        }
        Equations { normal, right, cells }
    }

    fn variance(&self) -> f64 {
        self.measured.sigma * self.measured.sigma
    }

    /// The state after a step, which is halved while the agreement is worse than the `best`, and its agreement.
    fn stepped(&self, state: &State, whole: &DVector<f64>, best: f64) -> (State, f64) {
        let moved = |step: &DVector<f64>| {
            let pose = state.pose.moved(&step.fixed_rows::<POSE>(0).into_owned());
            let next = State { pose, values: &state.values + step.rows(POSE, self.priors.len()) };
            let agreement = self.objective(&next);
            (next, agreement)
        };
        let mut step = whole * (LONGEST_STEP / whole.amax()).min(1.0);
        let mut next = moved(&step);
        for _ in 0..MOST_HALVINGS {
            if next.1 <= best {
                break;
            }
            step *= 0.5;
            next = moved(&step);
        }
        next
    }

    /// The cameras with their covariance. `None` where they are unlike what was known.
    fn outcome(self, State { pose, values }: State, equations: &Equations, cofactors: &DMatrix<f64>) -> Option<SelfCalibration> {
        // A camera as unlike its prior as this explains something else, as gross errors or the shape of the ground.
        if values.iter().zip(self.priors.iter()).any(|(value, prior)| value.abs() > MOST_UNLIKE * prior) {
            return None;
        }
        let interior = with_constants(self.given, &values, self.cameras);
        let covariance = self.covariance(equations, cofactors);
        Some(SelfCalibration { interior, given: *self.given, values, pose, covariance, cameras: self.cameras, extent: self.extent })
    }

    /// Neighbours share errors: what the sums over cells show beside the prior information, where it is more.
    fn covariance(&self, equations: &Equations, cofactors: &DMatrix<f64>) -> DMatrix<f64> {
        let (unknowns, variance) = (cofactors.nrows(), self.variance());
        let mut sums: DMatrix<f64> = equations.cells.values().fold(DMatrix::zeros(unknowns, unknowns), |sum, s| sum + s * s.transpose());
        for (k, prior) in self.priors.iter().enumerate() {
            sums[(POSE + k, POSE + k)] += variance * variance / (prior * prior);
        }
        for ([k, l], deviation) in &self.shared {
            add_difference(&mut sums, [POSE + k, POSE + l], variance * variance / (deviation * deviation));
        }
        let by_cells = cofactors * sums * cofactors;
        let raised = |k: usize| (by_cells[(k, k)] / (variance * cofactors[(k, k)])).max(1.0).sqrt();
        let shared = self.priors.len();
        DMatrix::from_fn(shared, shared, |i, j| variance * cofactors[(POSE + i, POSE + j)] * raised(POSE + i) * raised(POSE + j))
    }
}
