//! Normalised cross-correlation of grey values.

use super::surface::of_parabola;
use crate::GreyView;

/// Sums over the pixels that two windows share, exact in whole numbers.
#[derive(Default)]
struct Sums {
    n: i64,
    a: i64,
    b: i64,
    aa: i64,
    ab: i64,
    bb: i64,
}

impl Sums {
    fn add_rows(&mut self, a: &[u8], b: &[u8]) {
        let (mut sa, mut sb, mut saa, mut sab, mut sbb) = (0u32, 0u32, 0u32, 0u32, 0u32);
        for (a, b) in a.iter().zip(b) {
            let (a, b) = (u32::from(*a), u32::from(*b));
            (sa, sb, saa, sab, sbb) = (sa + a, sb + b, saa + a * a, sab + a * b, sbb + b * b);
        }
        self.n += a.len() as i64;
        self.a += i64::from(sa);
        self.b += i64::from(sb);
        self.aa += i64::from(saa);
        self.ab += i64::from(sab);
        self.bb += i64::from(sbb);
    }

    /// The correlation coefficient, -1..1; absent where either side is constant.
    fn coefficient(&self) -> Option<f64> {
        let covariance = self.n * self.ab - self.a * self.b;
        let variances = [self.n * self.aa - self.a * self.a, self.n * self.bb - self.b * self.b];
        (variances[0] > 0 && variances[1] > 0).then(|| covariance as f64 / ((variances[0] as f64).sqrt() * (variances[1] as f64).sqrt()))
    }
}

/// The translation of whole pixels (right minus left) at which two small images overlap best.
///
/// The overlap is at least a fifth of the smaller image; the coefficient counts with the square root of the number of common pixels,
/// which is its significance. `[0, 0]` where nothing correlates.
pub(super) fn best_overlap(left: GreyView<'_>, right: GreyView<'_>) -> [i64; 2] {
    let size = |image: GreyView<'_>| (image.width() as i64, image.height() as i64);
    let ((lw, lh), (rw, rh)) = (size(left), size(right));
    let least = (lw * lh).min(rw * rh) / 5;
    let mut best = (0.0, [0, 0]);
    for dy in -(lh - 1)..rh {
        let (top, bottom) = ((-dy).max(0), lh.min(rh - dy));
        for dx in -(lw - 1)..rw {
            let (start, end) = ((-dx).max(0), lw.min(rw - dx));
            if (bottom - top) * (end - start) < least.max(1) {
                continue;
            }
            let mut sums = Sums::default();
            for row in top..bottom {
                let a = &left.row(row as usize)[start as usize..end as usize];
                let b = &right.row((row + dy) as usize)[(start + dx) as usize..(end + dx) as usize];
                sums.add_rows(a, b);
            }
            let score = sums.coefficient().unwrap_or(0.0) * (sums.n as f64).sqrt();
            if score > best.0 {
                best = (score, [dx, dy]);
            }
        }
    }
    best.1
}

/// A square patch of an image.
pub(super) struct Patch<'a> {
    image: GreyView<'a>,
    left: usize,
    top: usize,
    side: usize,
}

impl<'a> Patch<'a> {
    /// The patch reaching `reach` px around a position, moved inside the image; `None` where the image is smaller.
    pub fn around(image: GreyView<'a>, x: f64, y: f64, reach: usize) -> Option<Self> {
        let side = 2 * reach + 1;
        let along = |position: f64, length: usize| Some((position as usize).saturating_sub(reach).min(length.checked_sub(side)?));
        Some(Self { image, left: along(x, image.width())?, top: along(y, image.height())?, side })
    }

    /// The centre's position in px.
    pub fn centre(&self) -> [f64; 2] {
        [self.left, self.top].map(|corner| corner as f64 + self.side as f64 / 2.0)
    }

    /// The offset near the expected one at which the other image correlates best, to a fraction of a pixel, and the coefficient.
    ///
    /// `None` where the patch or the other image is constant there, the search leaves the other image, or the best lies on the edge
    /// of the search.
    pub fn best_in(&self, other: GreyView<'_>, expected: [f64; 2], reach: usize) -> Option<([f64; 2], f64)> {
        let reach = reach as i64;
        let shift = expected.map(|v| v.round() as i64);
        let coefficient = |dx: i64, dy: i64| self.coefficient(other, shift[0] + dx, shift[1] + dy);
        let mut best: Option<(f64, i64, i64)> = None;
        for dy in -reach..=reach {
            for dx in -reach..=reach {
                if let Some(c) = coefficient(dx, dy).filter(|c| best.is_none_or(|b| *c > b.0)) {
                    best = Some((c, dx, dy));
                }
            }
        }
        let (c, dx, dy) = best.filter(|(_, dx, dy)| dx.abs() < reach && dy.abs() < reach)?;
        let x = dx as f64 + of_parabola([coefficient(dx - 1, dy)?, c, coefficient(dx + 1, dy)?]);
        let y = dy as f64 + of_parabola([coefficient(dx, dy - 1)?, c, coefficient(dx, dy + 1)?]);
        Some(([shift[0] as f64 + x, shift[1] as f64 + y], c))
    }

    fn coefficient(&self, other: GreyView<'_>, dx: i64, dy: i64) -> Option<f64> {
        let along = |corner: usize, shift: i64, length: usize| {
            let start = usize::try_from(corner as i64 + shift).ok()?;
            (start + self.side <= length).then_some(start)
        };
        let (left, top) = (along(self.left, dx, other.width())?, along(self.top, dy, other.height())?);
        let mut sums = Sums::default();
        for row in 0..self.side {
            sums.add_rows(&self.image.row(self.top + row)[self.left..][..self.side], &other.row(top + row)[left..][..self.side]);
        }
        sums.coefficient()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::GreyImage;

    fn textured(width: usize, height: usize, dx: usize, dy: usize) -> GreyImage {
        GreyImage::from_fn(width, height, |col, row| {
            (((col + dx) * (col + dx) * 5 + (row + dy) * 37 + (col + dx) * (row + dy) * 3) % 256) as u8
        })
        .unwrap()
    }

    #[test]
    fn gain_and_offset_do_not_matter() {
        let mut sums = Sums::default();
        sums.add_rows(&[1, 5, 9, 2], &[13, 21, 29, 15]);
        assert!((sums.coefficient().unwrap() - 1.0).abs() < 1e-12);
        let mut flat = Sums::default();
        flat.add_rows(&[1, 5, 9, 2], &[7, 7, 7, 7]);
        assert_eq!(flat.coefficient(), None);
    }

    #[test]
    fn the_best_overlap_is_the_true_translation() {
        let (left, right) = (textured(48, 40, 0, 0), textured(44, 42, 13, 5));
        assert_eq!(best_overlap(left.view(), right.view()), [-13, -5]);
    }

    #[test]
    fn a_patch_is_found_again() {
        let (left, right) = (textured(80, 80, 0, 0), textured(80, 80, 4, 3));
        let patch = Patch::around(left.view(), 40.0, 40.0, 10).unwrap();
        let ([dx, dy], c) = patch.best_in(right.view(), [-2.0, -2.0], 4).unwrap();
        assert!(c > 0.999 && (dx + 4.0).abs() < 0.5 && (dy + 3.0).abs() < 0.5, "{dx} {dy} {c}");
        // On the edge of the search it is not believed.
        assert_eq!(patch.best_in(right.view(), [0.0, -3.0], 4), None);
        assert!(Patch::around(left.view(), 0.0, 0.0, 40).is_none());
    }
}
