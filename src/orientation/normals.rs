//! Normal equations of a few unknowns: five of a relative orientation.

use nalgebra::{SMatrix, SVector};

/// A square matrix over the five unknowns.
pub(super) type Matrix5 = SMatrix<f64, 5, 5>;

/// N and the right-hand side, summed row by row.
#[derive(Debug, Clone)]
pub(crate) struct Normals<const N: usize> {
    matrix: [[f64; N]; N],
    right: [f64; N],
    /// Weighted sum of the squared misclosures before the step.
    pub square_sum: f64,
}

/// The step that the normal equations give.
#[derive(Debug, Clone)]
pub(crate) struct Solution<const N: usize> {
    pub step: SVector<f64, N>,
    /// N⁻¹.
    pub cofactors: SMatrix<f64, N, N>,
    /// √(δᵀNδ / number of unknowns): the step's size in the unit of the misclosures.
    pub size: f64,
}

impl<const N: usize> Normals<N> {
    pub fn new() -> Self {
        Self { matrix: [[0.0; N]; N], right: [0.0; N], square_sum: 0.0 }
    }

    /// Adds an equation `row` · δ + `misclosure` = 0.
    ///
    /// Inlined: a call for each observation takes longer than the sums.
    #[inline(always)]
    pub fn add(&mut self, row: &SVector<f64, N>, misclosure: f64, weight: f64) {
        for i in 0..N {
            let weighted = weight * row[i];
            for j in i..N {
                self.matrix[i][j] += weighted * row[j];
            }
            self.right[i] -= weighted * misclosure;
        }
        self.square_sum += weight * misclosure * misclosure;
    }

    /// Solves for the step. `Err` with the smallest share 1 - R² of an unknown that the others do not explain, where that is nothing but
    /// rounding: the unknowns are not determined.
    pub fn solve(&self) -> Result<Solution<N>, f64> {
        let full = SMatrix::<f64, N, N>::from_fn(|i, j| self.matrix[i.min(j)][i.max(j)]);
        let scale = SVector::<f64, N>::from_fn(|i, _| 1.0 / self.matrix[i][i].sqrt());
        if !scale.iter().all(|s| s.is_finite()) {
            return Err(0.0);
        }
        let scaled = SMatrix::<f64, N, N>::from_fn(|i, j| full[(i, j)] * scale[i] * scale[j]);
        let factor = scaled.cholesky().ok_or(0.0)?;
        let least = (0..N).map(|i| factor.l_dirty()[(i, i)]).fold(f64::INFINITY, f64::min);
        if !(least * least > LEAST_SHARE) {
            return Err(least * least);
        }
        let inverse = factor.inverse();
        let cofactors = SMatrix::<f64, N, N>::from_fn(|i, j| inverse[(i, j)] * scale[i] * scale[j]);
        let step = cofactors * SVector::<f64, N>::from_row_slice(&self.right);
        let size = (step.dot(&(full * step)) / N as f64).max(0.0).sqrt();
        Ok(Solution { step, cofactors, size })
    }
}

#[cfg(test)]
impl<const N: usize> Normals<N> {
    /// The largest difference of two sets of normal equations.
    pub fn difference(&self, other: &Self) -> f64 {
        let coefficients = self.matrix.iter().flatten().zip(other.matrix.iter().flatten());
        coefficients.chain(self.right.iter().zip(&other.right)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }
}

/// A matrix times a vector, written out column by column: of the library's product compilers make calls, several for each observation.
pub(super) fn times(matrix: &Matrix5, vector: &SVector<f64, 5>) -> SVector<f64, 5> {
    let mut product = [0.0; 5];
    for (row, sum) in product.iter_mut().enumerate() {
        *sum = matrix[(row, 0)] * vector[0];
        for column in 1..5 {
            *sum += matrix[(row, column)] * vector[column];
        }
    }
    SVector::from(product)
}

/// Below this share of its own information, what is left of an unknown is rounding.
const LEAST_SHARE: f64 = 1e-13;

/// Correlations of a matrix of cofactors; 0 where a variance is 0.
pub(super) fn correlations(cofactors: &Matrix5) -> [[f64; 5]; 5] {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let product = (cofactors[(i, i)] * cofactors[(j, j)]).sqrt();
            if i == j {
                1.0
            } else if product > 0.0 {
                (cofactors[(i, j)] / product).clamp(-1.0, 1.0)
            } else {
                0.0
            }
        })
    })
}

#[cfg(test)]
mod tests {
    use super::super::coplanarity::Unknowns;
    use super::*;

    /// Rows with some correlation between the unknowns.
    fn rows() -> Vec<Unknowns> {
        (0..12).map(|k| Unknowns::from_fn(|i, _| ((k * k + 3 * i * k + i) as f64 * 0.7).sin() + 0.2)).collect()
    }

    #[test]
    fn the_step_solves_equations_without_contradiction() {
        let wanted = Unknowns::new(0.3, -0.1, 2.0, 0.05, -1.0);
        let mut normals = Normals::new();
        rows().iter().enumerate().for_each(|(k, row)| normals.add(row, -row.dot(&wanted), 1.0 + k as f64));
        let solution = normals.solve().unwrap();
        assert!((solution.step - wanted).amax() < 1e-10);
        assert!((solution.size * solution.size * 5.0 - normals.square_sum).abs() < 1e-9 * normals.square_sum);
    }

    #[test]
    fn dependent_unknowns_are_found() {
        let mut normals = Normals::new();
        for mut row in rows() {
            row[4] = row[0] - 2.0 * row[2];
            normals.add(&row, 1.0, 1.0);
        }
        assert!(normals.solve().is_err());
        assert!(Normals::<5>::new().solve().is_err());
    }
}
