//! What of the systematic errors of GNSS positions moves, turns or scales the block as a whole: without control nothing tells it from the block itself.
//!
//! A motion of the whole block with parameters m changes the positions by G m and the control points by H m. As far as values of the errors, A e, do the
//! same to the positions, these do not hold the motion: what does is the mean square of what A leaves of G m, and that of H m. Where both are small beside
//! the mean square of G m, the errors may have no part of this motion: (G m)ᵀ A e = 0. So offsets are those beside their mean.
//!
//! # Source
//! Granshaw 1980, Bundle adjustment methods in engineering photogrammetry (inner constraints).

use super::network::Columns;
use super::network::Network;
use super::sparse::DenseFactor;
use super::state::State;
use super::systematic::SystematicErrors;
use super::weighted::Weighted;
use crate::math::{dot3, minus};
use nalgebra::SMatrix;

/// Root mean square of what holds a motion, by that of the motion: below it, nothing does.
const LEAST_SHARE: f64 = 0.05;
/// A constraint on unknowns that others determine, too, weighs so many times as much as the observations of all of them.
const STIFFNESS: f64 = 1e4;
/// Of motions that leave all positions in place, as a turn about their line, errors have no part.
const LEAST_MOTION: f64 = 1e-6;
/// For errors that others hold as well: their equations become regular.
const RIDGE: f64 = 1e-9;

/// A sum of systematic errors that is zero.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct DatumConstraint {
    /// By the systematic columns, of length 1.
    pub row: Vec<f64>,
    pub weight: f64,
}

impl DatumConstraint {
    /// The sum at present.
    pub fn sum(&self, columns: &Columns, state: &State) -> f64 {
        self.row.iter().zip(&columns.systematic).map(|(factor, (error, axis))| factor * state.systematic[*error][*axis]).sum()
    }
}

type Matrix7 = SMatrix<f64, 7, 7>;

/// The constraints that the systematic columns need beside the observed positions and control points of a block.
pub(super) fn datum_constraints(
    network: &Network,
    columns: &Columns,
    systematic: &SystematicErrors,
    state: &State,
    (gnss, control): (&[Option<Weighted>], &[Option<Weighted>]),
) -> Vec<DatumConstraint> {
    let (first, own) = (columns.parameter.len(), columns.systematic.len());
    let observed: Vec<(usize, &Weighted)> = gnss.iter().enumerate().filter_map(|(image, prior)| Some((image, prior.as_ref()?))).collect();
    if own == 0 || observed.is_empty() {
        return Vec::new();
    }
    let motions = Motions::new(observed.iter().map(|(image, _)| state.images[*image].position));
    let (mut of_errors, mut across) = (vec![0.0; own * own], vec![[0.0; 7]; own]);
    let (mut of_positions, mut of_control) = (Matrix7::zeros(), Matrix7::zeros());
    let mut information = 0.0_f64;
    for (image, prior) in &observed {
        let rows = motions.of(&state.images[*image].position);
        let slopes = systematic.by_columns(columns, state, *image);
        for k in (0..3).filter(|k| prior.weight[*k] > 0.0) {
            information += prior.weight[k];
            add_square(&mut of_positions, &rows[k]);
            for (column, slope) in &slopes {
                (0..7).for_each(|m| across[column - first][m] += slope[k] * rows[k][m]);
                slopes.iter().for_each(|(other, second)| of_errors[(other - first) * own + column - first] += slope[k] * second[k]);
            }
        }
    }
    let seen = |point: usize| network.of_point(point).len() >= 2;
    let mut known = 0.0_f64;
    for (point, prior) in control.iter().enumerate().filter_map(|(point, prior)| Some((point, prior.as_ref()?))).filter(|(p, _)| seen(*p)) {
        let rows = motions.of(&state.points[point]);
        (0..3).filter(|k| prior.weight[*k] > 0.0).for_each(|k| add_square(&mut of_control, &rows[k]));
        known += 1.0;
    }
    let number = observed.len() as f64;
    // What the errors leave of the motions: GᵀG - GᵀA (AᵀA)⁻¹ AᵀG.
    let scale: Vec<f64> = (0..own).map(|k| of_errors[k * own + k]).collect();
    (0..own).for_each(|k| of_errors[k * own + k] += RIDGE * (scale[k] + RIDGE));
    let Ok(factor) = DenseFactor::new(of_errors, own, &scale) else { return Vec::new() };
    let mut left = of_positions;
    let forward: Vec<Vec<f64>> = (0..7)
        .map(|m| {
            let mut column: Vec<f64> = across.iter().map(|row| row[m]).collect();
            factor.forward(&mut column);
            column
        })
        .collect();
    for r in 0..7 {
        for c in 0..7 {
            left[(r, c)] -= forward[r].iter().zip(&forward[c]).map(|(a, b)| a * b).sum::<f64>();
        }
    }
    let holding = left / number + of_control / known.max(1.0);
    let moving = of_positions / number + Matrix7::identity() * LEAST_MOTION;
    let Some(root) = moving.cholesky().map(|root| root.l()) else { return Vec::new() };
    let Some(inverse) = root.try_inverse() else { return Vec::new() };
    let eigen = (inverse * holding * inverse.transpose()).symmetric_eigen();
    let free = (0..7).filter(|k| eigen.eigenvalues[*k] < LEAST_SHARE * LEAST_SHARE);
    let constraint = |k: usize| {
        let motion = inverse.transpose() * eigen.eigenvectors.column(k);
        let row: Vec<f64> = across.iter().map(|row| (0..7).map(|m| row[m] * motion[m]).sum::<f64>()).collect();
        let length = row.iter().map(|value| value * value).sum::<f64>().sqrt();
        let is_moved = length > LEAST_SHARE * number.sqrt();
        is_moved.then(|| DatumConstraint { row: row.iter().map(|v| v / length).collect(), weight: STIFFNESS * information })
    };
    free.filter_map(constraint).collect()
}

fn add_square(sum: &mut Matrix7, row: &[f64; 7]) {
    for r in 0..7 {
        (0..7).for_each(|c| sum[(r, c)] += row[r] * row[c]);
    }
}

/// Shifts, turns and the change of scale of a block, each of which moves the positions by about 1.
struct Motions {
    centre: [f64; 3],
    extent: f64,
}

impl Motions {
    fn new(positions: impl Iterator<Item = [f64; 3]> + Clone) -> Self {
        let number = positions.clone().count() as f64;
        let centre = [0, 1, 2].map(|k| positions.clone().map(|at| at[k]).sum::<f64>() / number);
        let square = positions.map(|at| dot3(&minus(&at, &centre), &minus(&at, &centre))).sum::<f64>() / number;
        Self { centre, extent: if square > 0.0 { square.sqrt() } else { 1.0 } }
    }

    fn of(&self, place: &[f64; 3]) -> [[f64; 7]; 3] {
        let [x, y, z] = minus(place, &self.centre).map(|v| v / self.extent);
        [[1.0, 0.0, 0.0, 0.0, z, -y, x], [0.0, 1.0, 0.0, -z, 0.0, x, y], [0.0, 0.0, 1.0, y, -x, 0.0, z]]
    }
}
