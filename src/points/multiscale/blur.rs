//! Blurring rows of grey values by a Gaussian, first down the columns, then along the row.

use crate::math::Lanes;

/// Values that are worked on at once.
pub(super) const LANES: usize = 4;

/// Most taps on each side of the centre.
const WIDEST: usize = 8;

/// A symmetric kernel.
pub(super) struct Kernel {
    taps: [Lanes; WIDEST + 1],
    radius: usize,
    /// The row blurred down the columns, with its border repeated on both sides.
    column: Vec<f32>,
}

impl Kernel {
    /// A Gaussian, cut at 3 times its standard deviation and normalised, for rows of `stride` values.
    pub fn gaussian(sigma_px: f64, stride: usize) -> Self {
        let radius = (libm::ceil(3.0 * sigma_px) as usize).clamp(1, WIDEST);
        let weight = |k: usize| libm::exp(-((k * k) as f64) / (2.0 * sigma_px * sigma_px));
        let sum = weight(0) + 2.0 * (1..=radius).map(weight).sum::<f64>();
        let taps = std::array::from_fn(|k| Lanes::splat(if k <= radius { (weight(k) / sum) as f32 } else { 0.0 }));
        Self { taps, radius, column: vec![0.0; stride + 2 * WIDEST] }
    }

    /// Rows above and below that a row needs.
    pub fn radius(&self) -> usize {
        self.radius
    }

    /// Blurs one row into `out`. `rows(k)` is the row k below (above, where negative) of the image; `width` values of each count.
    pub fn blur<'r>(&mut self, rows: impl Fn(isize) -> &'r [f32], width: usize, out: &mut [f32]) {
        match self.radius {
            1 => self.blur_by::<1>(rows, width, out),
            2 => self.blur_by::<2>(rows, width, out),
            3 => self.blur_by::<3>(rows, width, out),
            4 => self.blur_by::<4>(rows, width, out),
            5 => self.blur_by::<5>(rows, width, out),
            6 => self.blur_by::<6>(rows, width, out),
            7 => self.blur_by::<7>(rows, width, out),
            _ => self.blur_by::<WIDEST>(rows, width, out),
        }
    }

    fn blur_by<'r, const R: usize>(&mut self, rows: impl Fn(isize) -> &'r [f32], width: usize, out: &mut [f32]) {
        let stride = self.column.len() - 2 * WIDEST;
        let here = &rows(0)[..stride];
        let above: [&[f32]; R] = std::array::from_fn(|k| &rows(-(k as isize + 1))[..stride]);
        let below: [&[f32]; R] = std::array::from_fn(|k| &rows(k as isize + 1)[..stride]);
        let column = &mut self.column[WIDEST..][..stride];
        for x in (0..stride).step_by(LANES) {
            let mut sum = Lanes::load(&here[x..]) * self.taps[0];
            for k in 0..R {
                sum = sum + (Lanes::load(&above[k][x..]) + Lanes::load(&below[k][x..])) * self.taps[k + 1];
            }
            sum.store(&mut column[x..]);
        }
        let (first, last) = (self.column[WIDEST], self.column[WIDEST + width - 1]);
        self.column[..WIDEST].fill(first);
        self.column[WIDEST + width..].fill(last);
        for (four, window) in out[..stride].chunks_exact_mut(LANES).zip(self.column.windows(2 * WIDEST + LANES).step_by(LANES)) {
            let mut sum = Lanes::load(&window[WIDEST..]) * self.taps[0];
            for k in 1..=R {
                sum = sum + (Lanes::load(&window[WIDEST - k..]) + Lanes::load(&window[WIDEST + k..])) * self.taps[k];
            }
            sum.store(four);
        }
    }
}
