//! A cascade of blurs over the rows of an image, of which only the rows at work are kept.

use super::blur::Kernel;

/// One image of the cascade: the source, or what a kernel makes of the image before.
struct Stage {
    /// `None` for the source.
    kernel: Option<Kernel>,
    /// Row y lies in slot y mod their number.
    rows: Vec<Vec<f32>>,
    /// How many rows are done.
    done: usize,
}

/// The images of a cascade; each is blurred more than the one before.
pub(super) struct Cascade {
    width: usize,
    height: usize,
    stages: Vec<Stage>,
}

impl Cascade {
    /// `blurs_px` are the standard deviations by which each image after the source is blurred from the one before.
    pub fn new(width: usize, height: usize, blurs_px: &[f64]) -> Self {
        let stride = width.next_multiple_of(8);
        let mut kernels: Vec<Option<Kernel>> = vec![None];
        kernels.extend(blurs_px.iter().map(|sigma| Some(Kernel::gaussian(*sigma, stride))));
        let radius = |kernel: &Option<Kernel>| kernel.as_ref().map_or(0, Kernel::radius);
        // A row and its neighbours are asked for; the images after it run ahead of these by the radii of their kernels.
        let ahead: Vec<usize> = (0..kernels.len()).map(|k| kernels[k + 1..].iter().map(radius).sum()).collect();
        let slots = |k: usize| 3 + ahead[k] + kernels.get(k + 1).map_or(0, radius);
        let counts: Vec<usize> = (0..kernels.len()).map(slots).collect();
        let stages = kernels.into_iter().zip(counts);
        // Reading past the end of a row gives values that nothing depends on.
        let stage = |(kernel, slots)| Stage { kernel, rows: vec![vec![0.0; stride + 8]; slots], done: 0 };
        Self { width, height, stages: stages.map(stage).collect() }
    }

    /// Makes a row of the last image, and of all before it, those that are not done yet.
    ///
    /// `read` fills a row of the source; `done` sees each new row of each image, by its number in the cascade.
    pub fn advance(&mut self, row: usize, read: &mut impl FnMut(usize, &mut [f32]), done: &mut impl FnMut(usize, usize, &[f32])) {
        self.make(self.stages.len() - 1, row, read, done);
    }

    fn make(&mut self, number: usize, row: usize, read: &mut impl FnMut(usize, &mut [f32]), done: &mut impl FnMut(usize, usize, &[f32])) {
        while self.stages[number].done <= row {
            let y = self.stages[number].done;
            let radius = self.stages[number].kernel.as_ref().map_or(0, Kernel::radius);
            if number > 0 {
                self.make(number - 1, (y + radius).min(self.height - 1), read, done);
            }
            let (before, from) = self.stages.split_at_mut(number);
            let stage = &mut from[0];
            let slot = y % stage.rows.len();
            let out = &mut stage.rows[slot];
            match &mut stage.kernel {
                None => read(y, &mut out[..self.width]),
                Some(kernel) => {
                    let source = &before[number - 1].rows;
                    let last = self.height as isize - 1;
                    let at = |k: isize| &source[(y as isize + k).clamp(0, last) as usize % source.len()][..];
                    kernel.blur(at, self.width, out);
                }
            }
            done(number, y, out);
            stage.done += 1;
        }
    }

    /// A row of an image that [`Cascade::advance`] made for this row, the one above or the one below; with what fills it up.
    pub fn row(&self, number: usize, row: usize) -> &[f32] {
        let rows = &self.stages[number].rows;
        &rows[row % rows.len()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The image blurred by one Gaussian, by definition, with its border repeated outwards.
    fn blurred(width: usize, height: usize, sigma: f64, grey: &dyn Fn(usize, usize) -> f64) -> Vec<f64> {
        let reach = (6.0 * sigma) as isize + 1;
        let weight = |d: isize| libm::exp(-((d * d) as f64) / (2.0 * sigma * sigma));
        let near = |place: usize, d: isize, length: usize| (place as isize + d).clamp(0, length as isize - 1) as usize;
        let at = |col: usize, row: usize| {
            let (mut sum, mut weights) = (0.0, 0.0);
            for dy in -reach..=reach {
                for dx in -reach..=reach {
                    let w = weight(dx) * weight(dy);
                    sum += w * grey(near(col, dx, width), near(row, dy, height));
                    weights += w;
                }
            }
            sum / weights
        };
        (0..height).flat_map(|row| (0..width).map(move |col| (col, row))).map(|(col, row)| at(col, row)).collect()
    }

    #[test]
    fn blurs_follow_each_other_as_one() {
        let (width, height) = (37, 29);
        let grey = |col: usize, row: usize| f64::from(((col * col * 5 + row * 37 + col * row * 3) % 256) as u8);
        let mut cascade = Cascade::new(width, height, &[0.8, 1.0, 1.3]);
        let mut images = vec![Vec::new(); 4];
        let mut read = |row: usize, line: &mut [f32]| line.iter_mut().enumerate().for_each(|(col, v)| *v = grey(col, row) as f32);
        for row in 0..height {
            let mut done = |image: usize, y: usize, line: &[f32]| {
                assert_eq!(images[image].len(), y * width, "rows come in order");
                images[image].extend_from_slice(&line[..width]);
            };
            cascade.advance(row, &mut read, &mut done);
            for (number, image) in images.iter().enumerate() {
                for near in row.saturating_sub(2)..=row {
                    assert_eq!(cascade.row(number, near)[..width], image[near * width..][..width], "rows are kept");
                }
            }
        }
        let variances = [0.0, 0.64, 1.64, 3.33];
        for (image, variance) in images.iter().zip(variances).skip(1) {
            let expected = blurred(width, height, libm::sqrt(variance), &grey);
            // Beyond the reach of the border, which is repeated once here and for each blur there.
            for (k, (found, wanted)) in image.iter().zip(&expected).enumerate() {
                let (col, row) = (k % width, k / width);
                if col > 8 && row > 8 && col + 9 < width && row + 9 < height {
                    assert!((f64::from(*found) - wanted).abs() < 0.8, "{found} for {wanted} at {col}, {row}");
                }
            }
        }
    }

    #[test]
    fn a_constant_stays() {
        let mut cascade = Cascade::new(16, 16, &[0.7, 2.6]);
        let mut read = |_: usize, line: &mut [f32]| line.fill(200.0);
        for row in 0..16 {
            cascade.advance(row, &mut read, &mut |_, _, line| assert!(line[..16].iter().all(|v| (v - 200.0).abs() < 1e-3)));
        }
    }
}
