//! Real roots of polynomials.

/// Highest degree of [`real_roots`].
pub(crate) const MAX_DEGREE: usize = 10;

/// Coefficients, that of zᵏ in place k.
pub(crate) type Polynomial = [f64; MAX_DEGREE + 1];

/// The roots that were found.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Roots {
    values: [f64; MAX_DEGREE],
    count: usize,
}

impl Roots {
    /// Adds a root unless it was the last one: two turning points may fall on it.
    fn push(&mut self, root: f64) {
        if self.count < MAX_DEGREE && self.as_slice().last() != Some(&root) {
            self.values[self.count] = root;
            self.count += 1;
        }
    }

    pub(crate) fn as_slice(&self) -> &[f64] {
        &self.values[..self.count]
    }
}

/// The real roots of odd multiplicity, each once; those of magnitude up to 1 first, each group in ascending order of z or of -1/z.
///
/// Between neighbouring roots of its derivative a polynomial is monotone, so that a change of sign encloses exactly one root; the roots of
/// the derivatives follow in the same way from degree 1 upwards. Roots beyond ±1 are the reciprocals of those of the reversed polynomial:
/// no value then exceeds the sum of the coefficients. A polynomial of zeros, or with a coefficient that is no number, has none.
pub(crate) fn real_roots(polynomial: &Polynomial) -> Roots {
    let mut roots = Roots::default();
    let Some(degree) = polynomial.iter().rposition(|c| *c != 0.0).filter(|_| polynomial.iter().all(|c| c.is_finite())) else {
        return roots;
    };
    for &root in roots_in_unit_interval(polynomial, degree).as_slice() {
        roots.push(root);
    }
    let mut reversed = [0.0; MAX_DEGREE + 1];
    for (place, c) in reversed.iter_mut().zip(polynomial[..=degree].iter().rev()) {
        *place = *c;
    }
    for &root in roots_in_unit_interval(&reversed, degree).as_slice() {
        if root != 0.0 && root.abs() < 1.0 {
            roots.push(1.0 / root);
        }
    }
    roots
}

/// Roots in -1..1, both included, in ascending order.
fn roots_in_unit_interval(polynomial: &Polynomial, degree: usize) -> Roots {
    let chain = derivatives(polynomial, degree);
    let mut turning = Roots::default();
    for level in 1..=degree {
        // The turning points need only separate the roots; the roots themselves are found to the last bits.
        let tolerance = if level == degree { 1e-16 } else { 1e-10 };
        turning = roots_between(&chain[level][..=level], turning.as_slice(), tolerance);
    }
    turning
}

/// In place `k` the derivative of degree `k`, divided by a factorial to keep its coefficients of one size.
fn derivatives(polynomial: &Polynomial, degree: usize) -> [Polynomial; MAX_DEGREE + 1] {
    let mut chain = [[0.0; MAX_DEGREE + 1]; MAX_DEGREE + 1];
    chain[degree] = *polynomial;
    for level in (1..degree).rev() {
        let order = (degree - level) as f64;
        for power in 0..=level {
            chain[level][power] = chain[level + 1][power + 1] * (power + 1) as f64 / order;
        }
    }
    chain
}

fn roots_between(coefficients: &[f64], turning: &[f64], tolerance: f64) -> Roots {
    let mut roots = Roots::default();
    let mut left = (-1.0, evaluate(coefficients, -1.0).0);
    for &end in turning.iter().chain(&[1.0]) {
        let right = (end, evaluate(coefficients, end).0);
        if left.1 == 0.0 {
            roots.push(left.0);
        } else if right.1 != 0.0 && (left.1 < 0.0) != (right.1 < 0.0) {
            roots.push(root_in_bracket(coefficients, left, right, tolerance));
        }
        left = right;
    }
    if left.1 == 0.0 {
        roots.push(left.0);
    }
    roots
}

/// Newton's iteration, halving the bracket where a step would leave it.
fn root_in_bracket(coefficients: &[f64], left: (f64, f64), right: (f64, f64), tolerance: f64) -> f64 {
    let (mut low, mut high) = (left.0, right.0);
    let mut z = low - left.1 * (high - low) / (right.1 - left.1);
    for _ in 0..80 {
        let (value, slope) = evaluate(coefficients, z);
        if value == 0.0 {
            return z;
        }
        if (value < 0.0) == (left.1 < 0.0) {
            low = z;
        } else {
            high = z;
        }
        let newton = z - value / slope;
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        let step = (next - z).abs();
        z = next;
        if step <= tolerance {
            break;
        }
    }
    z
}

/// Value and derivative.
fn evaluate(coefficients: &[f64], z: f64) -> (f64, f64) {
    let (mut value, mut slope) = (0.0, 0.0);
    for c in coefficients.iter().rev() {
        slope = slope * z + value;
        value = value * z + c;
    }
    (value, slope)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_roots(real: &[f64], pairs: &[[f64; 2]]) -> Polynomial {
        let mut product = [0.0; MAX_DEGREE + 1];
        product[0] = 1.0;
        let mut times = |factor: &[f64]| {
            let before = product;
            product = [0.0; MAX_DEGREE + 1];
            for (i, a) in before.iter().enumerate().filter(|(_, a)| **a != 0.0) {
                for (j, b) in factor.iter().enumerate() {
                    product[i + j] += a * b;
                }
            }
        };
        real.iter().for_each(|root| times(&[-root, 1.0]));
        pairs.iter().for_each(|[re, im]| times(&[re * re + im * im, -2.0 * re, 1.0]));
        product
    }

    fn assert_roots(polynomial: &Polynomial, wanted: &[f64], tolerance: f64) {
        let mut found = real_roots(polynomial).as_slice().to_vec();
        found.sort_by(f64::total_cmp);
        assert_eq!(found.len(), wanted.len(), "{found:?}, wanted {wanted:?}");
        for (got, wanted) in found.iter().zip(wanted) {
            assert!((got - wanted).abs() <= tolerance * wanted.abs().max(1.0), "{found:?}, wanted {wanted}");
        }
    }

    #[test]
    fn ten_real_roots_of_all_sizes() {
        let roots = [-250.0, -3.0, -0.9, -0.2, -0.01, 0.05, 0.4, 1.5, 7.0, 1e3];
        assert_roots(&with_roots(&roots, &[]), &roots, 1e-9);
    }

    #[test]
    fn complex_pairs_are_no_real_roots() {
        assert_roots(&with_roots(&[], &[[0.5, 0.1], [-2.0, 1.0]]), &[], 0.0);
        assert_roots(&with_roots(&[-0.5, 4.0], &[[0.3, 0.01], [1.0, 2.0]]), &[-0.5, 4.0], 1e-12);
    }

    #[test]
    fn roots_at_zero_and_at_the_ends_of_the_interval_count_once() {
        assert_roots(&with_roots(&[-1.0, 0.0, 1.0], &[]), &[-1.0, 0.0, 1.0], 1e-15);
        assert_roots(&with_roots(&[1.0, 1.0, 1.0], &[]), &[1.0], 1e-5);
    }

    #[test]
    fn neighbours_are_separated() {
        assert_roots(&with_roots(&[0.5, 0.500_01, -3.0, -3.000_1], &[]), &[-3.000_1, -3.0, 0.5, 0.500_01], 1e-9);
    }

    #[test]
    fn constants_zeros_and_numbers_that_are_none_have_no_roots() {
        let mut polynomial = [0.0; MAX_DEGREE + 1];
        assert_roots(&polynomial, &[], 0.0);
        polynomial[0] = 3.0;
        assert_roots(&polynomial, &[], 0.0);
        polynomial[4] = f64::NAN;
        assert_roots(&polynomial, &[], 0.0);
    }
}
