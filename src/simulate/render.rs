//! From rays to an image: nine samples a pixel, then the point spread of lens and pixel.

use super::view::View;

/// Samples along a side of a pixel.
const SIDE: usize = 3;
const SAMPLES: usize = SIDE * SIDE;

/// Renders the light that reaches each pixel, row by row.
///
/// The samples of a pixel lie on a sheared grid, so that each has a column and a row of its own and edges near the pixel
/// grid's directions stay smooth. The point spread is a Gauss function of `psf_px` and the pixel's square, as wide as both.
pub(super) fn render(view: &View<'_>, width: usize, height: usize, psf_px: f64) -> Vec<f64> {
    let weights = weights(psf_px);
    let mut bands: [Vec<[f64; SAMPLES]>; 3] = [0, 1, 2].map(|k| sample_row(view, k as f64 - 1.0, width));
    let mut image = Vec::with_capacity(width * height);
    for row in 0..height {
        image.extend((0..width).map(|col| gather(&bands, col, &weights)));
        bands.rotate_left(1);
        bands[2] = sample_row(view, row as f64 + 2.0, width);
    }
    image
}

/// The samples of a row of pixels, from one column before the patch to one after.
fn sample_row(view: &View<'_>, row: f64, width: usize) -> Vec<[f64; SAMPLES]> {
    let places = places();
    (0..width + 2).map(|col| view.greys(col as f64 - 1.0, row, &places)).collect()
}

fn gather(bands: &[Vec<[f64; SAMPLES]>; 3], col: usize, weights: &[[[f64; SAMPLES]; 3]; 3]) -> f64 {
    let mut sum = 0.0;
    for (band, line) in bands.iter().zip(weights) {
        for (samples, pixel) in band[col..col + 3].iter().zip(line) {
            sum += samples.iter().zip(pixel).map(|(sample, weight)| sample * weight).sum::<f64>();
        }
    }
    sum
}

/// The places of the samples in a pixel.
fn places() -> [[f64; 2]; SAMPLES] {
    let side = SIDE as f64;
    std::array::from_fn(|k| {
        let (i, j) = ((k % SIDE) as f64, (k / SIDE) as f64);
        [(i + (j + 0.5) / side) / side, (j + (i + 0.5) / side) / side]
    })
}

/// The share of each sample of the 3 x 3 pixels around a pixel.
fn weights(psf_px: f64) -> [[[f64; SAMPLES]; 3]; 3] {
    let variance = psf_px * psf_px + 1.0 / 12.0;
    let along = |place: f64, pixel: usize| {
        let distance = place + pixel as f64 - 1.5;
        libm::exp(-distance * distance / (2.0 * variance))
    };
    let mut weights = [0, 1, 2].map(|row| [0, 1, 2].map(|col| places().map(|[x, y]| along(x, col) * along(y, row))));
    let total: f64 = weights.iter().flatten().flatten().sum();
    weights.iter_mut().flatten().flatten().for_each(|weight| *weight /= total);
    weights
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Share, x and y of every sample, from the middle of the pixel.
    fn shares(psf_px: f64) -> Vec<[f64; 3]> {
        let mut all = Vec::new();
        for (row, line) in weights(psf_px).iter().enumerate() {
            for (col, pixel) in line.iter().enumerate() {
                all.extend(pixel.iter().zip(places()).map(|(w, [x, y])| [*w, x + col as f64 - 1.5, y + row as f64 - 1.5]));
            }
        }
        all
    }

    #[test]
    fn a_pixel_gathers_light_from_around_its_middle() {
        for psf_px in [0.0, 0.2, 0.45, 1.0] {
            let moment = |power: fn(f64, f64) -> f64| shares(psf_px).iter().map(|[w, x, y]| w * power(*x, *y)).sum::<f64>();
            assert!((moment(|_, _| 1.0) - 1.0).abs() < 1e-14, "light is lost at {psf_px} px");
            assert!(moment(|x, _| x).abs() < 1e-15 && moment(|_, y| y).abs() < 1e-15, "off centre at {psf_px} px");
        }
    }

    #[test]
    fn the_point_spread_has_its_width() {
        let width = |power: fn(&[f64; 3]) -> f64| shares(0.45).iter().map(power).sum::<f64>().sqrt();
        let wanted = (0.45_f64 * 0.45 + 1.0 / 12.0).sqrt();
        for got in [width(|[w, x, _]| w * x * x), width(|[w, _, y]| w * y * y)] {
            assert!((got / wanted - 1.0).abs() < 0.03, "{got} px, wanted {wanted} px");
        }
    }

    #[test]
    fn each_sample_of_a_pixel_has_a_column_and_a_row_of_its_own() {
        for axis in [0, 1] {
            let mut along = places().map(|place| place[axis]);
            along.sort_by(f64::total_cmp);
            for (k, place) in along.iter().enumerate() {
                assert!((place - (k as f64 + 0.5) / 9.0).abs() < 1e-15);
            }
        }
    }
}
