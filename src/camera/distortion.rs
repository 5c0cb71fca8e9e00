//! Directions freed of a lens's distortion.

/// Steps of the iteration, and the change in units of the focal length at which it ends.
pub(crate) const MOST_STEPS: usize = 100;
const SETTLED: f64 = 1e-14;

/// The direction (x, y), y down, that the distortion moves to `measured`: with r² = x² + y², x (1 + k₁r² + k₂r⁴ + k₃r⁶) + 2p₁xy +
/// p₂(r² + 2x²) and y (1 + k₁r² + k₂r⁴ + k₃r⁶) + p₁(r² + 2y²) + 2p₂xy. `None` where the distortion folds the image at that place.
///
/// # Source
/// Brown 1971, Close-range camera calibration, in the direction from object to image; inverted by fixed-point iteration.
pub(crate) fn undistorted(measured: [f64; 2], radial: [f64; 3], tangential: [f64; 2]) -> Option<[f64; 2]> {
    let ([k1, k2, k3], [p1, p2]) = (radial, tangential);
    let [mut x, mut y] = measured;
    if radial == [0.0; 3] && tangential == [0.0; 2] {
        return Some(measured);
    }
    for _ in 0..MOST_STEPS {
        let r2 = x * x + y * y;
        let factor = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3));
        let shift = [2.0 * p1 * x * y + p2 * (r2 + 2.0 * x * x), p1 * (r2 + 2.0 * y * y) + 2.0 * p2 * x * y];
        let next = [(measured[0] - shift[0]) / factor, (measured[1] - shift[1]) / factor];
        let change = (next[0] - x).abs() + (next[1] - y).abs();
        [x, y] = next;
        if !change.is_finite() {
            return None;
        }
        if change < SETTLED {
            return Some([x, y]);
        }
    }
    None
}
