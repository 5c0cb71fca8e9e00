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
/// Sturm's chain counts the roots of an interval, which is halved until each part holds one. Roots beyond ±1 are the reciprocals of those of
/// the reversed polynomial: no value then exceeds the sum of the coefficients. A polynomial of zeros, or with a coefficient that is no
/// number, has none.
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

/// Halvings of the unit interval: parts are then at the resolution of numbers.
const HALVINGS: u32 = 45;
/// Coefficients of a remainder below this share of those before it are rounding: what is left has multiple roots.
const ROUNDING: f64 = 1e-13;

/// Roots in -1..1, both included, in ascending order.
fn roots_in_unit_interval(polynomial: &Polynomial, degree: usize) -> Roots {
    let chain = Chain::new(polynomial, degree);
    let at = |z: f64| End { z, value: evaluate(&polynomial[..=degree], z).0, changes: chain.changes(z) };
    let mut roots = Roots::default();
    let (low, high) = (at(-1.0), at(1.0));
    if low.value == 0.0 {
        roots.push(low.z);
    }
    // Parts still to look at, the leftmost on top.
    let mut parts = [(low, high, 0); HALVINGS as usize + 2];
    let mut waiting = 1;
    while waiting > 0 {
        waiting -= 1;
        let (low, high, halvings) = parts[waiting];
        let count = low.changes.saturating_sub(high.changes);
        let changes_sign = low.value != 0.0 && high.value != 0.0 && (low.value < 0.0) != (high.value < 0.0);
        if count == 0 {
            continue;
        } else if high.value == 0.0 && count == 1 {
            roots.push(high.z);
        } else if changes_sign && (count == 1 || halvings == HALVINGS) {
            roots.push(root_in_bracket(&polynomial[..=degree], (low.z, low.value), (high.z, high.value), 1e-16));
        } else if halvings < HALVINGS {
            let middle = at(0.5 * (low.z + high.z));
            parts[waiting] = (middle, high, halvings + 1);
            parts[waiting + 1] = (low, middle, halvings + 1);
            waiting += 2;
        }
    }
    roots
}

/// An end of an interval.
#[derive(Clone, Copy)]
struct End {
    z: f64,
    value: f64,
    /// Changes of sign along the chain.
    changes: usize,
}

/// A polynomial, its derivative, and the negative remainders of their divisions: between two places the number of changes of sign falls by
/// the number of different roots.
///
/// # Source
/// Sturm 1835, Mémoire sur la résolution des équations numériques.
struct Chain {
    polynomials: [Polynomial; MAX_DEGREE + 1],
    degrees: [usize; MAX_DEGREE + 1],
    length: usize,
}

impl Chain {
    fn new(polynomial: &Polynomial, degree: usize) -> Self {
        let mut chain = Self { polynomials: [[0.0; MAX_DEGREE + 1]; MAX_DEGREE + 1], degrees: [0; MAX_DEGREE + 1], length: 0 };
        let mut derivative = [0.0; MAX_DEGREE + 1];
        for power in 1..=degree {
            derivative[power - 1] = polynomial[power] * power as f64;
        }
        chain.push(polynomial, degree);
        if degree > 0 {
            chain.push(&derivative, degree - 1);
        }
        while chain.length >= 2 && chain.degrees[chain.length - 1] > 0 {
            let last = chain.length - 1;
            let Some((remainder, degree)) = negative_remainder(
                (&chain.polynomials[last - 1], chain.degrees[last - 1]),
                (&chain.polynomials[last], chain.degrees[last]),
            ) else {
                break;
            };
            chain.push(&remainder, degree);
        }
        chain
    }

    /// Appends a polynomial, its largest coefficient made 1 in magnitude.
    fn push(&mut self, polynomial: &Polynomial, degree: usize) {
        let largest = polynomial[..=degree].iter().fold(0.0f64, |largest, c| largest.max(c.abs()));
        self.polynomials[self.length] = polynomial.map(|c| c / largest);
        self.degrees[self.length] = degree;
        self.length += 1;
    }

    fn changes(&self, z: f64) -> usize {
        let mut last = 0.0;
        let mut changes = 0;
        for (polynomial, degree) in self.polynomials.iter().zip(self.degrees).take(self.length) {
            let value = polynomial[..=degree].iter().rev().fold(0.0, |value, c| value * z + c);
            if value != 0.0 {
                changes += usize::from(last != 0.0 && (value < 0.0) != (last < 0.0));
                last = value;
            }
        }
        changes
    }
}

/// Minus the remainder of a division, and its degree; `None` where nothing but rounding is left.
fn negative_remainder((dividend, from): (&Polynomial, usize), (divisor, to): (&Polynomial, usize)) -> Option<(Polynomial, usize)> {
    let mut rest = *dividend;
    let leading = 1.0 / divisor[to];
    for degree in (to..=from).rev() {
        let factor = rest[degree] * leading;
        for power in 0..=to {
            rest[degree - to + power] -= factor * divisor[power];
        }
        rest[degree] = 0.0;
    }
    let degree = rest[..to].iter().rposition(|c| c.abs() > ROUNDING)?;
    rest[degree + 1..].fill(0.0);
    Some((rest.map(|c| -c), degree))
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
    fn every_root_of_many_polynomials_is_found() {
        let mut random = crate::math::Random::new(5);
        for turn in 0..500 {
            let mut uniform = || random.below(1 << 20) as f64 / (1 << 19) as f64 - 1.0;
            let pairs: Vec<[f64; 2]> = (0..turn % 4).map(|_| [1.5 * uniform(), 0.3 + uniform().abs()]).collect();
            let mut roots: Vec<f64> = Vec::new();
            while roots.len() < 10 - 2 * pairs.len() {
                // Half of them beyond ±1.
                let root = if roots.len().is_multiple_of(2) { uniform() } else { 1.0 / uniform() };
                if roots.iter().all(|other| (root - other).abs() > 0.02 * root.abs().max(0.5)) && root.abs() < 20.0 {
                    roots.push(root);
                }
            }
            roots.sort_by(f64::total_cmp);
            assert_roots(&with_roots(&roots, &pairs), &roots, 1e-5);
        }
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
