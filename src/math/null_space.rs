//! The vectors at right angles to a few conditions on nine unknowns: the entries of a 3 x 3 matrix.

/// `M` orthonormal vectors at right angles to `N` conditions, `N + M` = 9, by Householder reflections. `None` where the conditions depend on
/// each other.
pub(crate) fn null_space<const N: usize, const M: usize>(mut columns: [[f64; 9]; N]) -> Option<[[f64; 9]; M]> {
    const { assert!(N + M == 9) }
    let mut reflectors = [[0.0; 9]; N];
    for k in 0..N {
        let whole = norm_from(&columns[k], 0);
        let rest = norm_from(&columns[k], k);
        if rest.is_nan() || rest <= 1e-12 * whole {
            return None;
        }
        let mut reflector = [0.0; 9];
        reflector[k..].copy_from_slice(&columns[k][k..]);
        reflector[k] += if reflector[k] < 0.0 { -rest } else { rest };
        let length = norm_from(&reflector, k);
        reflector.iter_mut().for_each(|v| *v /= length);
        columns[k + 1..].iter_mut().for_each(|column| reflect(column, &reflector));
        reflectors[k] = reflector;
    }
    let mut basis = [[0.0; 9]; M];
    for (index, vector) in basis.iter_mut().enumerate() {
        vector[N + index] = 1.0;
        reflectors.iter().rev().for_each(|reflector| reflect(vector, reflector));
    }
    Some(basis)
}

fn norm_from(vector: &[f64; 9], first: usize) -> f64 {
    vector[first..].iter().map(|v| v * v).sum::<f64>().sqrt()
}

fn reflect(vector: &mut [f64; 9], reflector: &[f64; 9]) {
    let twice = 2.0 * vector.iter().zip(reflector).map(|(a, b)| a * b).sum::<f64>();
    vector.iter_mut().zip(reflector).for_each(|(v, r)| *v -= twice * r);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dot(a: &[f64; 9], b: &[f64; 9]) -> f64 {
        a.iter().zip(b).map(|(a, b)| a * b).sum()
    }

    #[test]
    fn the_vectors_are_orthonormal_and_fulfil_the_conditions() {
        let conditions: [[f64; 9]; 6] =
            std::array::from_fn(|i| std::array::from_fn(|j| ((7 * i * i + 3 * j * i + j * j) % 11) as f64 - 4.0));
        let basis: [[f64; 9]; 3] = null_space(conditions).unwrap();
        for (i, a) in basis.iter().enumerate() {
            assert!(conditions.iter().all(|c| dot(a, c).abs() < 1e-13));
            for (j, b) in basis.iter().enumerate() {
                assert!((dot(a, b) - f64::from(u8::from(i == j))).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn conditions_that_repeat_themselves_have_no_null_space_of_that_size() {
        let mut conditions = [[1.0; 9]; 2];
        assert!(null_space::<2, 7>(conditions).is_none());
        conditions[1][3] = f64::NAN;
        assert!(null_space::<2, 7>(conditions).is_none());
    }
}
