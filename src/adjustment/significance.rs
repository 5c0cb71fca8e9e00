//! Which of several estimated values differ from zero by more than chance.
//!
//! Values x with cofactors Q and covariances C are tested together: xᵀC⁻¹x of k of them is k times a variable of the F distribution where they are zero
//! indeed, of χ² where σ₀ is known. To fix them at zero changes the others by -Q Q⁻¹x, without a new adjustment. C may hold more than σ₀²Q: errors
//! that observations share.
//!
//! # Source
//! Koch 1999, Parameter estimation and hypothesis testing in linear models, 4.2; Förstner & Wrobel 2016, Photogrammetric Computer Vision, 3.1.

use super::sparse::DenseFactor;

/// Values that are estimated together.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Estimates {
    pub values: Vec<f64>,
    /// Row by row.
    pub cofactors: Vec<f64>,
    pub covariances: Vec<f64>,
}

impl Estimates {
    pub fn standard_error(&self, value: usize) -> f64 {
        self.covariances[value * self.values.len() + value].max(0.0).sqrt()
    }

    /// xᵀC⁻¹x / k of some values; 0 where they have no covariances of their own.
    pub fn test(&self, own: &[usize]) -> f64 {
        let part = self.part(&self.covariances, own);
        let scale: Vec<f64> = (0..own.len()).map(|k| part[k * own.len() + k]).collect();
        let Ok(factor) = DenseFactor::new(part, own.len(), &scale) else { return 0.0 };
        let mut values: Vec<f64> = own.iter().map(|value| self.values[*value]).collect();
        factor.forward(&mut values);
        values.iter().map(|v| v * v).sum::<f64>() / own.len() as f64
    }

    /// What the others are once some are fixed at zero; these become zero with no covariances. `None` where they have no cofactors of their own.
    pub fn without(&self, own: &[usize]) -> Option<Self> {
        let (n, k) = (self.values.len(), own.len());
        let part = self.part(&self.cofactors, own);
        let scale: Vec<f64> = (0..k).map(|at| part[at * k + at]).collect();
        let inverse = DenseFactor::new(part, k, &scale).ok()?.inverse();
        // G = Q Q⁻¹ of the fixed ones: each value loses G times theirs.
        let loses: Vec<f64> =
            (0..n * k).map(|at| (0..k).map(|p| self.cofactors[at / k * n + own[p]] * inverse[p * k + at % k]).sum()).collect();
        let lost = |row: usize, of: &dyn Fn(usize) -> f64| (0..k).map(|p| loses[row * k + p] * of(own[p])).sum::<f64>();
        let changed = |matrix: &[f64]| -> Vec<f64> {
            let half: Vec<f64> = (0..n * n).map(|at| matrix[at] - lost(at / n, &|p| matrix[p * n + at % n])).collect();
            (0..n * n).map(|at| half[at] - lost(at % n, &|p| half[at / n * n + p])).collect()
        };
        let mut values: Vec<f64> = (0..n).map(|row| self.values[row] - lost(row, &|p| self.values[p])).collect();
        own.iter().for_each(|value| values[*value] = 0.0);
        Some(Self { values, cofactors: changed(&self.cofactors), covariances: changed(&self.covariances) })
    }

    fn part(&self, matrix: &[f64], own: &[usize]) -> Vec<f64> {
        let n = self.values.len();
        own.iter().flat_map(|row| own.iter().map(move |column| matrix[row * n + column])).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Four observations of three values, and what least squares gives for them; the second of only the first two values.
    fn estimates(columns: usize) -> Estimates {
        let rows = [[1.0, 0.2, 0.5], [0.3, 1.0, -0.4], [0.5, 0.5, 1.0], [-0.2, 0.7, 0.1]];
        let observed = [1.3, 0.4, 0.9, 0.6];
        let mut normal = vec![0.0; columns * columns];
        let mut right = vec![0.0; columns];
        for (row, value) in rows.iter().zip(observed) {
            for r in 0..columns {
                right[r] += row[r] * value;
                (0..columns).for_each(|c| normal[r * columns + c] += row[r] * row[c]);
            }
        }
        let cofactors = DenseFactor::new(normal, columns, &vec![1.0; columns]).ok().unwrap().inverse();
        let values = (0..columns).map(|r| (0..columns).map(|c| cofactors[r * columns + c] * right[c]).sum()).collect();
        let covariances = cofactors.iter().map(|q| 0.25 * q).collect();
        Estimates { values, cofactors, covariances }
    }

    #[test]
    fn without_a_value_the_others_are_those_of_an_adjustment_without_it() {
        let (reduced, wanted) = (estimates(3).without(&[2]).unwrap(), estimates(2));
        for r in 0..2 {
            assert!((reduced.values[r] - wanted.values[r]).abs() < 1e-12, "{reduced:?} {wanted:?}");
            for c in 0..2 {
                assert!((reduced.cofactors[r * 3 + c] - wanted.cofactors[r * 2 + c]).abs() < 1e-12);
                assert!((reduced.covariances[r * 3 + c] - wanted.covariances[r * 2 + c]).abs() < 1e-12);
            }
        }
        assert!(reduced.values[2] == 0.0 && reduced.standard_error(2) < 1e-7);
    }

    #[test]
    fn a_test_is_a_square_in_standard_errors() {
        let all = estimates(3);
        let one = all.values[1] / all.standard_error(1);
        assert!((all.test(&[1]) - one * one).abs() < 1e-9);
        // A value and its double say what one of them does.
        let twice = Estimates { values: vec![2.0, 4.0], cofactors: vec![1.0, 0.0, 0.0, 4.0], covariances: vec![1.0, 0.0, 0.0, 4.0] };
        assert!((twice.test(&[0, 1]) - 4.0).abs() < 1e-12);
        assert_eq!(Estimates { covariances: vec![0.0; 4], ..twice }.test(&[0]), 0.0);
    }
}
