//! Lattice noise: the random texture of surfaces, a pure function of place.

/// Mixes a lattice point and a seed to 32 well-spread bits.
pub(super) fn hash(col: i32, row: i32, seed: u32) -> u32 {
    let mut bits = (col as u32).wrapping_mul(0x9E37_79B1) ^ (row as u32).wrapping_mul(0x85EB_CA77) ^ seed.wrapping_mul(0xC2B2_AE3D);
    bits = (bits ^ (bits >> 15)).wrapping_mul(0x2C1B_3C6D);
    bits = (bits ^ (bits >> 12)).wrapping_mul(0x297A_2D39);
    bits ^ (bits >> 15)
}

/// The hash as a number in [0, 1).
pub(super) fn hash_unit(col: i32, row: i32, seed: u32) -> f64 {
    unit(hash(col, row, seed))
}

/// 32 random bits as a number in [0, 1).
pub(super) fn unit(bits: u32) -> f64 {
    f64::from(bits) / 4_294_967_296.0
}

/// The lattice cell of a coordinate and the place inside it, 0..1.
pub(super) fn cell(x: f64) -> (i32, f64) {
    let floor = x.floor();
    (floor as i32, x - floor)
}

/// Value noise in [-1, 1]: random values at whole coordinates, smoothly interpolated.
///
/// # Source
/// Perlin 1985, with values in place of gradients.
pub(super) fn value(x: f64, y: f64, seed: u32) -> f64 {
    let ((col, u), (row, v)) = (cell(x), cell(y));
    let (s, t) = (u * u * (3.0 - 2.0 * u), v * v * (3.0 - 2.0 * v));
    let (a, b) = (hash_unit(col, row, seed), hash_unit(col.wrapping_add(1), row, seed));
    let (c, d) = (hash_unit(col, row.wrapping_add(1), seed), hash_unit(col.wrapping_add(1), row.wrapping_add(1), seed));
    let (top, bottom) = (a + (b - a) * s, c + (d - c) * s);
    2.0 * (top + (bottom - top) * t) - 1.0
}

/// A sum of value noises in [-1, 1]: spacings fall from `spacing_m` to 0.4 of it from one to the next, amplitudes by `decay`.
pub(super) fn fractal(x_m: f64, y_m: f64, spacing_m: f64, octaves: u32, decay: f64, seed: u32) -> f64 {
    let (mut sum, mut total, mut amplitude, mut scale) = (0.0, 0.0, 1.0, 1.0 / spacing_m);
    for octave in 0..octaves {
        sum += amplitude * value(x_m * scale, y_m * scale, seed.wrapping_add(octave));
        total += amplitude;
        amplitude *= decay;
        scale *= 2.5;
    }
    sum / total
}
