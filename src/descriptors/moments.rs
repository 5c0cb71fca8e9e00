//! Central and normalised moments of a grey window, and their invariants.

use super::kernel::{Kernel, RawMoments};
use super::{Brightness, WindowOptions};
use crate::{Error, GreyView};

/// Central moments of the weights g in a window, about their centroid, x to the right and y down, in px.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WindowMoments {
    /// The centroid, from the centre of the window's centre pixel.
    pub centroid_px: [f64; 2],
    pub mu00: f64,
    pub mu20: f64,
    pub mu11: f64,
    pub mu02: f64,
    pub mu30: f64,
    pub mu21: f64,
    pub mu12: f64,
    pub mu03: f64,
}

/// The moments of the window centred on a pixel (0-based column and row).
///
/// # Errors
/// [`Error::WindowOutside`], [`Error::ConstantWindow`]; [`Error::InvalidOption`] for the window's side.
///
/// # Source
/// Zahran 2007, eqs. 4, 5.
pub fn window_moments(image: GreyView<'_>, col: usize, row: usize, options: &WindowOptions) -> Result<WindowMoments, Error> {
    options.check_ranges()?;
    let kernel = Kernel::new(options.side, options.shape);
    let outside = Error::WindowOutside { side: options.side, col, row, width: image.width(), height: image.height() };
    let raw = kernel.raw_moments(image, col, row).ok_or(outside)?;
    WindowMoments::from_raw(&raw, &kernel, options.brightness).ok_or(Error::ConstantWindow { side: options.side, col, row })
}

impl WindowMoments {
    /// `None` for a constant window.
    pub(super) fn from_raw(raw: &RawMoments, kernel: &Kernel, brightness: Brightness) -> Option<Self> {
        if raw.min == raw.max {
            return None;
        }
        let (offset, scale) = match brightness {
            Brightness::Sum => (i64::from(raw.min), 1.0 / (raw.sums[0] - i64::from(raw.min) * kernel.grid[0]) as f64),
            Brightness::Range => (i64::from(raw.min), 1.0 / f64::from(raw.max - raw.min)),
            Brightness::Unit => (0, 1.0 / 255.0),
        };
        // Whole numbers up to here: the sums are the same in whatever order they were added.
        let [m00, m10, m01, m20, m11, m02, m30, m21, m12, m03] = std::array::from_fn(|k| (raw.sums[k] - offset * kernel.grid[k]) as f64);
        let (x, y) = (m10 / m00, m01 / m00);
        Some(Self {
            centroid_px: [x, y],
            mu00: scale * m00,
            mu20: scale * (m20 - x * m10),
            mu11: scale * (m11 - x * m01),
            mu02: scale * (m02 - y * m01),
            mu30: scale * (m30 - 3.0 * x * m20 + 2.0 * x * x * m10),
            mu21: scale * (m21 - 2.0 * x * m11 - y * m20 + 2.0 * x * x * m01),
            mu12: scale * (m12 - 2.0 * y * m11 - x * m02 + 2.0 * y * y * m10),
            mu03: scale * (m03 - 3.0 * y * m02 + 2.0 * y * y * m01),
        })
    }

    /// The normalised central moments µ'20 µ'11 µ'02 µ'30 µ'21 µ'12 µ'03, with µ'ij = µij / µ00^((i+j)/2 + 1).
    ///
    /// # Source
    /// Zahran 2007, eq. 6, with the exponent as a real number.
    pub fn normalized(&self) -> [f64; 7] {
        let second = self.mu00 * self.mu00;
        let third = second * self.mu00.sqrt();
        [
            self.mu20 / second,
            self.mu11 / second,
            self.mu02 / second,
            self.mu30 / third,
            self.mu21 / third,
            self.mu12 / third,
            self.mu03 / third,
        ]
    }

    /// The invariants I0..I6 of the normalised moments: rotating the grey values leaves them, a reflection changes the sign of I6.
    ///
    /// # Source
    /// Zahran 2007, eqs. 8 to 14; 10 to 14 as in Hu 1962, where the paper's print is not invariant.
    pub fn invariants(&self) -> [f64; 7] {
        invariants(&self.normalized())
    }

    /// Angle θ of the principal axis from the x axis towards the y axis, in radians: ½ atan2(2 µ11, µ20 - µ02).
    ///
    /// # Source
    /// Zahran 2007, eq. 7.
    pub fn axis_angle_rad(&self) -> f64 {
        0.5 * libm::atan2(2.0 * self.mu11, self.mu20 - self.mu02)
    }
}

/// Hu's invariants of µ'20 µ'11 µ'02 µ'30 µ'21 µ'12 µ'03.
pub(super) fn invariants(normalized: &[f64; 7]) -> [f64; 7] {
    let [mu20, mu11, mu02, mu30, mu21, mu12, mu03] = *normalized;
    let (a, b, c, d) = (mu30 + mu12, mu21 + mu03, mu30 - 3.0 * mu12, 3.0 * mu21 - mu03);
    let (along, across) = (a * (a * a - 3.0 * b * b), b * (3.0 * a * a - b * b));
    [
        mu20 + mu02,
        (mu20 - mu02) * (mu20 - mu02) + 4.0 * mu11 * mu11,
        c * c + d * d,
        a * a + b * b,
        c * along + d * across,
        (mu20 - mu02) * (a * a - b * b) + 4.0 * mu11 * a * b,
        d * along - c * across,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{GreyImage, WindowShape};

    fn patch(grey: impl Fn(f64, f64) -> f64, side: usize) -> GreyImage {
        let reach = (side / 2) as f64;
        GreyImage::from_fn(side, side, |col, row| grey(col as f64 - reach, row as f64 - reach).round() as u8).unwrap()
    }

    fn moments(image: &GreyImage, brightness: Brightness) -> WindowMoments {
        let options = WindowOptions { side: image.width(), brightness, shape: WindowShape::Square };
        window_moments(image.view(), image.width() / 2, image.width() / 2, &options).unwrap()
    }

    fn texture(x: f64, y: f64) -> f64 {
        100.0 + 8.0 * x - 5.0 * y + 2.0 * x * y + if x > 1.0 && y < 2.0 { 60.0 } else { 0.0 }
    }

    fn close(a: &[f64], b: &[f64], relative: f64) -> bool {
        a.iter().zip(b).all(|(a, b)| (a - b).abs() <= relative * a.abs().max(b.abs()).max(1e-12))
    }

    /// Central moments straight from the definition, in floating point.
    fn by_definition(image: &GreyImage, i: i32, j: i32) -> f64 {
        let pixels = || (0..image.height()).flat_map(|r| (0..image.width()).map(move |c| (c, r)));
        let g = |(c, r)| f64::from(image.view().at(c, r)) / 255.0;
        let m00: f64 = pixels().map(g).sum();
        let x = pixels().map(|p| p.0 as f64 * g(p)).sum::<f64>() / m00;
        let y = pixels().map(|p| p.1 as f64 * g(p)).sum::<f64>() / m00;
        pixels().map(|p| (p.0 as f64 - x).powi(i) * (p.1 as f64 - y).powi(j) * g(p)).sum()
    }

    #[test]
    fn agrees_with_the_definition() {
        let image = patch(texture, 11);
        let m = moments(&image, Brightness::Unit);
        let got = [m.mu00, m.mu20, m.mu11, m.mu02, m.mu30, m.mu21, m.mu12, m.mu03];
        let expected = [(0, 0), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3)].map(|(i, j)| by_definition(&image, i, j));
        assert!(close(&got, &expected, 1e-9), "{got:?} {expected:?}");
    }

    #[test]
    fn gain_and_offset_do_not_matter() {
        let (plain, bright) = (patch(|x, y| (x * y + 30.0).abs(), 11), patch(|x, y| (x * y + 30.0).abs() * 3.0 + 40.0, 11));
        for brightness in [Brightness::Sum, Brightness::Range] {
            let (a, b) = (moments(&plain, brightness).normalized(), moments(&bright, brightness).normalized());
            assert!(close(&a, &b, 1e-12), "{a:?} {b:?}");
        }
        let (a, b) = (moments(&plain, Brightness::Unit).normalized(), moments(&bright, Brightness::Unit).normalized());
        assert!(!close(&a, &b, 0.1));
    }

    #[test]
    fn invariants_stay_when_the_window_is_turned_and_only_the_last_changes_sign_when_mirrored() {
        let invariants = |image| moments(&image, Brightness::Sum).invariants();
        let upright = invariants(patch(texture, 11));
        let turned = invariants(patch(|x, y| texture(y, -x), 11));
        assert!(close(&upright, &turned, 1e-9), "{upright:?} {turned:?}");
        let mut mirrored = invariants(patch(|x, y| texture(-x, y), 11));
        mirrored[6] = -mirrored[6];
        assert!(close(&upright, &mirrored, 1e-9));
        assert!(upright.iter().all(|v| *v != 0.0));
    }

    #[test]
    fn invariants_of_a_circle_stand_any_rotation() {
        let blob = |x: f64, y: f64| {
            120.0 + 90.0 * libm::exp(-((x - 2.0).powi(2) + y * y) / 9.0) - 80.0 * libm::exp(-((x + 2.0).powi(2) + (y - 3.0).powi(2)) / 6.0)
        };
        let turn = |angle: f64| {
            let (s, c) = (libm::sin(angle), libm::cos(angle));
            let image = patch(|x, y| blob(c * x - s * y, s * x + c * y), 21);
            let options = WindowOptions { side: 21, shape: WindowShape::Circle, brightness: Brightness::Sum };
            window_moments(image.view(), 10, 10, &options).unwrap().invariants()
        };
        let (upright, turned) = (turn(0.0), turn(0.6));
        assert!(close(&upright[..4], &turned[..4], 0.1), "{upright:?} {turned:?}");
    }

    #[test]
    fn the_axis_follows_an_elongated_spot() {
        let spot = patch(|x, y| 200.0 * libm::exp(-((x - y).powi(2) / 2.0 + (x + y).powi(2) / 30.0)), 15);
        assert!((moments(&spot, Brightness::Sum).axis_angle_rad().to_degrees() - 45.0).abs() < 0.1);
    }

    #[test]
    fn constant_and_outside_windows_are_named() {
        let flat = GreyImage::from_fn(30, 30, |_, _| 9).unwrap();
        let options = WindowOptions::default();
        assert_eq!(window_moments(flat.view(), 15, 15, &options), Err(Error::ConstantWindow { side: 11, col: 15, row: 15 }));
        assert!(matches!(window_moments(flat.view(), 4, 15, &options), Err(Error::WindowOutside { .. })));
        let even = WindowOptions { side: 10, ..options };
        assert!(matches!(window_moments(flat.view(), 15, 15, &even), Err(Error::InvalidOption { field: "window.side", .. })));
    }
}
