//! Normal equations of a small adjustment, dense, solved by Cholesky's method.

/// N x = n of weighted observations.
pub struct Equations {
    size: usize,
    /// Rows up to the diagonal.
    normal: Vec<Vec<f64>>,
    pub right: Vec<f64>,
}

/// N = L Lᵀ.
pub struct Factor(Vec<Vec<f64>>);

impl Equations {
    pub fn new(size: usize) -> Self {
        Self { size, normal: (0..size).map(|row| vec![0.0; row + 1]).collect(), right: vec![0.0; size] }
    }

    /// An observation: its derivatives by some unknowns, observed minus computed, its weight.
    pub fn add(&mut self, derivatives: &[(usize, f64)], difference: f64, weight: f64) {
        for &(row, a) in derivatives {
            self.right[row] += weight * a * difference;
            for &(column, b) in derivatives.iter().filter(|(column, _)| *column <= row) {
                self.normal[row][column] += weight * a * b;
            }
        }
    }

    pub fn factor(mut self) -> Factor {
        for row in 0..self.size {
            let (above, own) = self.normal.split_at_mut(row);
            let own = &mut own[0];
            for column in 0..row {
                let sum = dot(&own[..column], &above[column][..column]);
                own[column] = (own[column] - sum) / above[column][column];
            }
            let square = own[row] - dot(&own[..row], &own[..row]);
            assert!(square > 0.0, "unknown {row} is not determined");
            own[row] = square.sqrt();
        }
        Factor(self.normal)
    }
}

impl Factor {
    /// N⁻¹ of a right-hand side.
    pub fn solve(&self, right: &[f64]) -> Vec<f64> {
        let mut x = right.to_vec();
        for (row, own) in self.0.iter().enumerate() {
            x[row] = (x[row] - dot(&own[..row], &x[..row])) / own[row];
        }
        for (row, own) in self.0.iter().enumerate().rev() {
            x[row] /= own[row];
            let value = x[row];
            (0..row).for_each(|k| x[k] -= own[k] * value);
        }
        x
    }

    /// The diagonal of N⁻¹.
    pub fn cofactors(&self) -> Vec<f64> {
        let size = self.0.len();
        let mut sums = vec![0.0; size];
        for column in 0..size {
            // The column of L⁻¹.
            let mut x = vec![0.0; size];
            x[column] = 1.0 / self.0[column][column];
            for row in column + 1..size {
                x[row] = -dot(&self.0[row][column..row], &x[column..row]) / self.0[row][row];
            }
            sums[column] = dot(&x, &x);
        }
        sums
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
