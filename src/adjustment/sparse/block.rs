//! Arithmetic of 6 x 6 blocks, stored column by column.

/// Side of a block: the unknowns of an image.
pub(in crate::adjustment) const N: usize = 6;

/// A block, column by column.
pub(in crate::adjustment) type Block6 = [f64; N * N];

/// c -= a bᵀ.
#[inline]
pub(super) fn subtract_product(c: &mut Block6, a: &Block6, b: &Block6) {
    subtract(c, a, |p, column| b[p * N + column]);
}

/// c -= a b.
#[inline]
pub(super) fn subtract_plain_product(c: &mut Block6, a: &Block6, b: &Block6) {
    subtract(c, a, |p, column| b[column * N + p]);
}

/// c -= a f, two columns at a time: they share what is read of a.
#[inline(always)]
fn subtract(c: &mut Block6, a: &Block6, f: impl Fn(usize, usize) -> f64) {
    for (pair, out) in c.as_chunks_mut::<{ 2 * N }>().0.iter_mut().enumerate() {
        let mut sums = *out;
        for (p, left) in a.as_chunks::<N>().0.iter().enumerate() {
            let (first, second) = (f(p, 2 * pair), f(p, 2 * pair + 1));
            for r in 0..N {
                sums[r] -= left[r] * first;
                sums[N + r] -= left[r] * second;
            }
        }
        *out = sums;
    }
}

/// c -= a bᵀ for a and b of 6 rows and 3 columns, column by column.
#[inline]
pub(in crate::adjustment) fn subtract_product3(c: &mut Block6, a: &[f64; 18], b: &[f64; 18]) {
    let (a0, a1, a2) = (&a[..6], &a[6..12], &a[12..]);
    for (column, out) in c.as_chunks_mut::<N>().0.iter_mut().enumerate() {
        let (b0, b1, b2) = (b[column], b[6 + column], b[12 + column]);
        for r in 0..N {
            out[r] -= a0[r] * b0 + a1[r] * b1 + a2[r] * b2;
        }
    }
}

/// The transposed block.
#[inline]
pub(super) fn transposed(a: &Block6) -> Block6 {
    std::array::from_fn(|k| a[(k % N) * N + k / N])
}

/// Factor L of a = L Lᵀ, its upper part 0. Only the lower part of `a` is read. `Err` with the row whose pivot is not above `least` times
/// its entry of `scale`.
pub(super) fn cholesky(a: &mut Block6, scale: &[f64; N], least: f64) -> Result<(), usize> {
    for k in 0..N {
        let pivot = a[k * N + k];
        if !(pivot > least * scale[k]) {
            return Err(k);
        }
        let root = pivot.sqrt();
        for r in k..N {
            a[k * N + r] /= root;
        }
        for c in k + 1..N {
            let factor = a[k * N + c];
            for r in c..N {
                a[c * N + r] -= a[k * N + r] * factor;
            }
        }
        for c in k + 1..N {
            a[c * N + k] = 0.0;
        }
    }
    Ok(())
}

/// b becomes b L⁻ᵀ.
#[inline]
pub(super) fn divide_by_transposed(b: &mut Block6, l: &Block6) {
    for column in 0..N {
        for p in 0..column {
            let factor = l[p * N + column];
            for r in 0..N {
                b[column * N + r] -= b[p * N + r] * factor;
            }
        }
        let pivot = l[column * N + column];
        for r in 0..N {
            b[column * N + r] /= pivot;
        }
    }
}

/// b becomes b L⁻¹.
pub(super) fn divide_by(b: &mut Block6, l: &Block6) {
    for column in (0..N).rev() {
        for p in column + 1..N {
            let factor = l[column * N + p];
            for r in 0..N {
                b[column * N + r] -= b[p * N + r] * factor;
            }
        }
        let pivot = l[column * N + column];
        for r in 0..N {
            b[column * N + r] /= pivot;
        }
    }
}

/// (L Lᵀ)⁻¹.
pub(super) fn inverse_of_factor(l: &Block6) -> Block6 {
    let mut inverse = [0.0; N * N];
    (0..N).for_each(|k| inverse[k * N + k] = 1.0);
    divide_by_transposed(&mut inverse, l);
    divide_by(&mut inverse, l);
    inverse
}
