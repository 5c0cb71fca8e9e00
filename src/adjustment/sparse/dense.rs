//! Cholesky factor of a small dense matrix, row by row: of what cameras and datum add to the sparse one.

/// Below this share of its own diagonal, a pivot is rounding.
const LEAST_SHARE: f64 = 1e-13;

/// L of a matrix L Lᵀ.
pub(in crate::adjustment) struct DenseFactor {
    rows: Vec<f64>,
    side: usize,
}

impl DenseFactor {
    /// Factors a symmetric matrix of `side` rows, of which the lower part counts. `Err` with the row whose pivot is rounding beside its
    /// entry of `scale`.
    pub fn new(mut rows: Vec<f64>, side: usize, scale: &[f64]) -> Result<Self, usize> {
        for k in 0..side {
            for c in 0..=k {
                let (before, own) = rows.split_at_mut(k * side);
                let product: f64 = if c < k {
                    before[c * side..][..c].iter().zip(&own[..c]).map(|(a, b)| a * b).sum()
                } else {
                    own[..c].iter().map(|a| a * a).sum()
                };
                let rest = own[c] - product;
                own[c] = if c < k {
                    rest / before[c * side + c]
                } else if rest > LEAST_SHARE * scale[k] {
                    rest.sqrt()
                } else {
                    return Err(k);
                };
            }
        }
        Ok(Self { rows, side })
    }

    /// Number of rows.
    pub fn side(&self) -> usize {
        self.side
    }

    /// x becomes L⁻¹ x.
    pub fn forward(&self, x: &mut [f64]) {
        for k in 0..self.side {
            let row = &self.rows[k * self.side..][..=k];
            let sum: f64 = row[..k].iter().zip(&x[..k]).map(|(a, b)| a * b).sum();
            x[k] = (x[k] - sum) / row[k];
        }
    }

    /// x becomes L⁻ᵀ x.
    pub fn backward(&self, x: &mut [f64]) {
        for k in (0..self.side).rev() {
            let row = &self.rows[k * self.side..][..=k];
            x[k] /= row[k];
            let own = x[k];
            row[..k].iter().zip(&mut x[..k]).for_each(|(a, b)| *b -= a * own);
        }
    }

    /// The inverse of the matrix, row by row.
    pub fn inverse(&self) -> Vec<f64> {
        let mut inverse = vec![0.0; self.side * self.side];
        for (k, row) in inverse.chunks_exact_mut(self.side.max(1)).enumerate() {
            row[k] = 1.0;
            self.forward(row);
            self.backward(row);
        }
        inverse
    }
}

/// The inverse of a positive definite matrix; `None` where it is singular.
pub(in crate::adjustment) fn inverse_of_dense<const K: usize>(matrix: &[[f64; K]; K]) -> Option<[[f64; K]; K]> {
    let scale: Vec<f64> = (0..K).map(|k| matrix[k][k]).collect();
    let inverse = DenseFactor::new(matrix.iter().flatten().copied().collect(), K, &scale).ok()?.inverse();
    Some(std::array::from_fn(|i| std::array::from_fn(|j| 0.5 * (inverse[i * K + j] + inverse[j * K + i]))))
}
