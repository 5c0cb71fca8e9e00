//! One octave of the scale space: images of the same pixel size, each blurred more than the one before.

use super::cascade::Cascade;
use super::extrema::{Extremum, Search};
use super::level::Level;
use crate::GreyView;

/// Standard deviation of the blur that the camera's own optics and pixels are taken to have, px.
const OWN_BLUR_PX: f64 = 0.5;

/// The blur of the first image of each octave, in its own pixels.
const BASE_SIGMA: f64 = 0.9;

/// The blur of a level, whole or between two, in the pixels of its octave.
pub(crate) fn sigma_of(level: f64, per_octave: usize) -> f64 {
    BASE_SIGMA * libm::exp2(level / per_octave as f64)
}

/// The level of a blur, in the pixels of the first octave.
pub(crate) fn level_of(sigma: f64, per_octave: usize) -> f64 {
    libm::log2(sigma / BASE_SIGMA) * per_octave as f64
}

/// Where an octave begins.
pub(super) enum Source<'a> {
    /// The image itself.
    Image(GreyView<'a>),
    /// An image blurred as the first of an octave, row by row.
    Blurred { width: usize, height: usize, grey: Vec<f32> },
}

/// An octave that was gone through.
pub(super) struct Octave {
    /// The levels 1 to s of s + 2, in which extrema are sought.
    pub levels: Vec<Level>,
    pub extrema: Vec<Extremum>,
    /// What the next octave begins with: level s at every second pixel of every second row.
    pub next: Source<'static>,
}

impl Source<'_> {
    pub fn size(&self) -> (usize, usize) {
        match self {
            Source::Image(image) => (image.width(), image.height()),
            Source::Blurred { width, height, .. } => (*width, *height),
        }
    }

    /// Goes through an octave of `per_octave` levels and two beside them; extrema have at least the response `least`.
    pub fn octave(&self, per_octave: usize, least: f32) -> Octave {
        let (width, height) = self.size();
        let sigmas: Vec<f64> = (0..per_octave + 2).map(|k| sigma_of(k as f64, per_octave)).collect();
        let between = |from: f64, to: f64| libm::sqrt(to * to - from * from);
        let mut blurs: Vec<f64> = sigmas.windows(2).map(|pair| between(pair[0], pair[1])).collect();
        if let Source::Image(_) = self {
            blurs.insert(0, between(OWN_BLUR_PX, sigmas[0]));
        }
        let first = blurs.len() + 1 - sigmas.len();
        let mut cascade = Cascade::new(width, height, &blurs);
        let mut search = Search::new(width, height, sigmas, least);
        let mut levels: Vec<Level> = (0..per_octave).map(|_| Level::new(width, height)).collect();
        let (half_width, half_height) = (width.div_ceil(2), height.div_ceil(2));
        let mut half = Vec::with_capacity(half_width * half_height);
        for row in 0..height {
            let mut read = |row: usize, line: &mut [f32]| self.read(row, line);
            let mut done = |image: usize, row: usize, line: &[f32]| {
                if (1..=per_octave).contains(&(image.saturating_sub(first))) {
                    levels[image - first - 1].set_row(row, line);
                }
                if image == first + per_octave && row.is_multiple_of(2) {
                    half.extend(line[..width].iter().step_by(2));
                }
            };
            cascade.advance(row, &mut read, &mut done);
            if row >= 2 {
                search.push(row - 1, |level, row| cascade.row(first + level, row));
            }
        }
        Octave { levels, extrema: search.found, next: Source::Blurred { width: half_width, height: half_height, grey: half } }
    }

    fn read(&self, row: usize, line: &mut [f32]) {
        match self {
            Source::Image(image) => line.iter_mut().zip(image.row(row)).for_each(|(to, grey)| *to = f32::from(*grey)),
            Source::Blurred { width, grey, .. } => line.copy_from_slice(&grey[row * width..][..*width]),
        }
    }
}
