//! Points that are distinct in position and scale, on a pyramid of scales.

mod blur;
mod cascade;
mod distribution;
mod extrema;
mod fine;
mod level;
mod octave;
mod options;
mod quadratic;
mod response;
mod tensor;

pub use options::{MultiscaleOptions, PointPosition};

pub(crate) use level::Level;

use super::mask::Mask;
use crate::{Error, GreyView, ImageOperation};
use distribution::well_distributed;
use extrema::Extremum;
use octave::{Source, level_of, sigma_of};
use tensor::{Tensor, TensorWindow};

/// Fewest pixels a side of an octave.
const LEAST_SIDE: usize = 16;

/// Maxima for each wanted point whose tensors are looked at.
const CHANCES: usize = 3;

/// A position by least squares that is farther from the maximum of the response, in pixels of its octave, is that of another point.
const FARTHEST: f64 = 2.0;

/// A point of interest with its scale. Positions are in px; the centre of the top-left pixel is (0.5, 0.5).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ScalePoint {
    pub x: f64,
    pub y: f64,
    /// Standard deviation of the Gaussian at whose blur the point is most distinct, px.
    pub scale_px: f64,
    /// How distinct it is: the geometric mean of the Hessian's determinant and the Förstner weight det N / tr N, both normalised by the
    /// scale; grey².
    pub weight: f64,
}

/// The blurred images in which points were found, for what describes them.
pub struct ScaleSpace {
    /// By octave: the levels in which extrema were sought.
    octaves: Vec<Vec<Level>>,
    per_octave: usize,
}

/// The level whose blur is nearest to a scale.
pub(crate) struct Nearest<'s> {
    pub level: &'s Level,
    /// Pixels of the image in one of the level.
    pub step_px: f64,
}

impl ScaleSpace {
    /// Width and height of the image.
    pub(crate) fn size(&self) -> (usize, usize) {
        (self.octaves[0][0].width(), self.octaves[0][0].height())
    }

    pub(crate) fn nearest(&self, scale_px: f64) -> Nearest<'_> {
        // The first level that is kept is the one after the first of an octave.
        self.numbered((libm::round(level_of(scale_px, self.per_octave)) - 1.0).max(0.0) as usize)
    }

    /// A level by its number through all octaves; the last for what is beyond.
    fn numbered(&self, number: usize) -> Nearest<'_> {
        let number = number.min(self.per_octave * self.octaves.len() - 1);
        let (octave, level) = (number / self.per_octave, number % self.per_octave);
        Nearest { level: &self.octaves[octave][level], step_px: step_of(octave) }
    }
}

/// Finds points that are distinct in position and scale, with the blurred images they were found in.
///
/// On a pyramid of `options.levels` levels an octave, points are the maxima in position and scale of the determinant of the Hessian,
/// refined by quadratics, the position on grids of half pixels in the two levels between which the scale lies. At each, the Förstner tensor
/// of its level gives the weight w = det N / tr N, the roundness q and the position by least squares. Derivatives are multiplied by the blur's standard deviation, so
/// that levels compare. Of more than `options.number` points, half are chosen equally over the image and half where they are most
/// distinct. They follow by octave, row, level and column; a flat image has none.
///
/// `mask` is as large as the image; points whose pixel is 0 in it are left out.
///
/// # Errors
/// [`Error::ImageTooSmall`] below 16 px a side; [`Error::InvalidOption`], naming the field and its range; [`Error::InvalidInput`] for a
/// mask of another size.
///
/// # Source
/// Förstner & Gülch 1987 (weight, roundness, least squares); Lindeberg 1998 (scale); Brown & Lowe 2002 (quadratic).
pub fn multiscale_points(
    image: GreyView<'_>,
    mask: Option<GreyView<'_>>,
    options: &MultiscaleOptions,
) -> Result<(Vec<ScalePoint>, ScaleSpace), Error> {
    options.check_ranges()?;
    let (width, height) = (image.width(), image.height());
    if width.min(height) < LEAST_SIDE {
        return Err(Error::ImageTooSmall { width, height, image_operation: ImageOperation::PyramidOfScales, min_side: LEAST_SIDE });
    }
    let mask = Mask::new(mask, image)?;
    let mut extrema = Vec::new();
    let mut octaves = Vec::new();
    let mut source = Source::Image(image);
    loop {
        let octave = source.octave(options.levels, (options.contrast * options.contrast) as f32);
        extrema.extend(octave.extrema.into_iter().map(|extremum| Candidate::new(octaves.len(), extremum, options.levels)));
        octaves.push(octave.levels);
        let (width, height) = octave.next.size();
        if width.min(height) < LEAST_SIDE {
            break;
        }
        source = octave.next;
    }
    extrema.retain(|c| mask.allows(c.x, c.y));
    let space = ScaleSpace { octaves, per_octave: options.levels };
    let side = width.max(height) as f64 / options.cells as f64;
    let across = (width as f64 / side) as usize + 1;
    let cell = |x: f64, y: f64| (y.max(0.0) / side) as usize * across + (x.max(0.0) / side) as usize;
    // The tensor of each maximum would take longer than the pyramid: it is looked at where the response, which the weight is of, is large.
    let extrema = well_distributed(&extrema, CHANCES * options.number, |c| (cell(c.x, c.y), c.extremum.response));
    let weighted = weighted(&extrema, &space, options);
    let chosen = well_distributed(&weighted, options.number, |(c, tensor)| (cell(c.x, c.y), c.extremum.response * tensor.weight()));
    let mut points: Vec<ScalePoint> = chosen.iter().map(|(candidate, tensor)| point_of(candidate, tensor, &space, options)).collect();
    // The final position may lie in the next pixel.
    points.retain(|p| mask.allows(p.x, p.y));
    Ok((points, space))
}

/// A maximum with its place in the image.
#[derive(Clone, Copy)]
struct Candidate {
    octave: usize,
    extremum: Extremum,
    x: f64,
    y: f64,
    scale_px: f64,
}

impl Candidate {
    fn new(octave: usize, extremum: Extremum, per_octave: usize) -> Self {
        let [dx, dy, ds] = extremum.offset;
        let scale_px = sigma_of(extremum.level as f64 + ds, per_octave) * step_of(octave);
        let [x, y] = place_of(octave, &extremum, [dx, dy]);
        Self { octave, extremum, x, y, scale_px }
    }
}

/// The position in the image of an extremum at an offset from its pixel; pixels of the levels lie on whole pixels of the image.
fn place_of(octave: usize, extremum: &Extremum, [dx, dy]: [f64; 2]) -> [f64; 2] {
    [(extremum.col, dx), (extremum.row, dy)].map(|(pixel, offset)| (pixel as f64 + offset) * step_of(octave) + 0.5)
}

/// Pixels of the image in one of an octave's.
fn step_of(octave: usize) -> f64 {
    (1u64 << octave) as f64
}

/// The candidates that are round enough, with their tensors.
fn weighted(candidates: &[Candidate], space: &ScaleSpace, options: &MultiscaleOptions) -> Vec<(Candidate, Tensor)> {
    let windows: Vec<TensorWindow> = (1..=options.levels).map(|level| TensorWindow::new(sigma_of(level as f64, options.levels))).collect();
    let tensor = |candidate: &Candidate| {
        let Candidate { octave, extremum, .. } = *candidate;
        let kept = extremum.level - 1;
        let tensor = windows[kept].at(&space.octaves[octave][kept], extremum.col, extremum.row);
        (tensor.roundness() >= options.roundness).then_some((*candidate, tensor))
    };
    candidates.iter().filter_map(tensor).collect()
}

fn point_of(candidate: &Candidate, tensor: &Tensor, space: &ScaleSpace, options: &MultiscaleOptions) -> ScalePoint {
    let Candidate { octave, extremum, scale_px, .. } = *candidate;
    let place = match options.position {
        PointPosition::Quadratic => highest(candidate, space),
        PointPosition::Forstner => {
            let window = TensorWindow::new(sigma_of(extremum.level as f64, options.levels));
            let centre = window.least_squares(tensor, &space.octaves[octave][extremum.level - 1], extremum.col, extremum.row);
            centre.filter(|d| d.iter().all(|d| d.abs() <= FARTHEST)).map(|offset| place_of(octave, &extremum, offset))
        }
    };
    let [x, y] = place.unwrap_or([candidate.x, candidate.y]);
    ScalePoint { x, y, scale_px, weight: libm::sqrt(extremum.response * tensor.weight()) }
}

/// Where in the image the response is highest at the candidate's own scale: between where it is in the levels before and after.
fn highest(candidate: &Candidate, space: &ScaleSpace) -> Option<[f64; 2]> {
    let [_, _, ds] = candidate.extremum.offset;
    let number = ((candidate.octave * space.per_octave + candidate.extremum.level - 1) as f64 + ds).max(0.0);
    let before = libm::floor(number);
    let in_level = |number: usize| {
        let Nearest { level, step_px } = space.numbered(number);
        let start = [candidate.x, candidate.y].map(|p| (p - 0.5) / step_px);
        fine::maximum(level, start).map(|place| place.map(|p| p * step_px + 0.5))
    };
    let share = number - before;
    match (in_level(before as usize), in_level(before as usize + 1)) {
        (Some([x, y]), Some([u, v])) => Some([x + share * (u - x), y + share * (v - y)]),
        (in_one, in_other) => in_one.or(in_other),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::GreyImage;

    /// Spots on a grid of 64 px, each off its cell's middle by less than a pixel, of this standard deviation.
    fn spots(sigma: f64, amplitude: f64) -> (GreyImage, Vec<[f64; 2]>) {
        let places: Vec<[f64; 2]> = (0..16)
            .map(|k| [64.0 * f64::from(k % 4) + 32.0 + 0.06 * f64::from(k), 64.0 * f64::from(k / 4) + 32.7 - 0.05 * f64::from(k)])
            .collect();
        let grey = |col: usize, row: usize| {
            let [x, y] = places[row / 64 * 4 + col / 64];
            let (dx, dy) = (col as f64 + 0.5 - x, row as f64 + 0.5 - y);
            (100.0 + amplitude * libm::exp(-(dx * dx + dy * dy) / (2.0 * sigma * sigma)) + 0.5) as u8
        };
        (GreyImage::from_fn(256, 256, grey).unwrap(), places)
    }

    fn best_near(points: &[ScalePoint], [x, y]: [f64; 2]) -> ScalePoint {
        let near = points.iter().filter(|p| (p.x - x).abs() < 2.0 && (p.y - y).abs() < 2.0);
        *near.max_by(|a, b| a.weight.total_cmp(&b.weight)).expect("the spot is found")
    }

    #[test]
    fn spots_are_found_at_their_place_and_scale() {
        for (sigma, amplitude) in [(1.2, 60.0), (2.0, 60.0), (3.0, -60.0), (4.5, 60.0), (7.0, 100.0)] {
            let (image, places) = spots(sigma, amplitude);
            let (points, _) = multiscale_points(image.view(), None, &MultiscaleOptions::default()).unwrap();
            for place in places {
                let p = best_near(&points, place);
                // A tenth of a pixel of the octave.
                let tolerance = 0.1 * sigma.max(1.0);
                assert!((p.x - place[0]).abs() < tolerance && (p.y - place[1]).abs() < tolerance, "sigma {sigma}: {p:?} for {place:?}");
                assert!((p.scale_px / sigma - 1.0).abs() < 0.12, "sigma {sigma}: {p:?}");
            }
        }
    }

    #[test]
    fn the_position_by_least_squares_is_that_of_the_spot_as_well() {
        let (image, places) = spots(2.5, 80.0);
        let options = MultiscaleOptions { position: PointPosition::Forstner, ..MultiscaleOptions::default() };
        let (centres, _) = multiscale_points(image.view(), None, &options).unwrap();
        let (tops, _) = multiscale_points(image.view(), None, &MultiscaleOptions::default()).unwrap();
        assert_ne!(centres, tops);
        for place in places {
            let p = best_near(&centres, place);
            assert!((p.x - place[0]).abs() < 0.1 && (p.y - place[1]).abs() < 0.1, "{p:?} for {place:?}");
        }
    }

    #[test]
    fn masked_points_are_left_out() {
        let (image, _) = spots(2.0, 60.0);
        let mask = GreyImage::from_fn(256, 256, |col, _| u8::from(col < 128)).unwrap();
        let all = multiscale_points(image.view(), None, &MultiscaleOptions::default()).unwrap().0;
        let left = multiscale_points(image.view(), Some(mask.view()), &MultiscaleOptions::default()).unwrap().0;
        let expected: Vec<ScalePoint> = all.into_iter().filter(|p| p.x < 128.0).collect();
        assert!(!expected.is_empty() && left == expected);
        let small = GreyImage::from_fn(255, 256, |_, _| 1).unwrap();
        let refused = multiscale_points(image.view(), Some(small.view()), &MultiscaleOptions::default());
        assert!(matches!(refused.err(), Some(Error::InvalidInput { refusal: crate::Refusal::MaskSize { .. } })));
    }

    #[test]
    fn the_number_is_kept_and_a_dull_half_has_its_share() {
        let noise = |col: usize, row: usize| {
            let mixed = (col as u64 * 0x9e37_79b9 + row as u64 * 0xc2b2_ae3d).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            ((mixed ^ (mixed >> 29)).wrapping_mul(0x94d0_49bb_1331_11eb) >> 58) as u8
        };
        let grey = |col: usize, row: usize| if col < 128 { 4 * noise(col, row) } else { 100 + noise(col, row) / 4 };
        let image = GreyImage::from_fn(256, 256, grey).unwrap();
        let count = |cells: usize| {
            let options = MultiscaleOptions { number: 260, cells, ..MultiscaleOptions::default() };
            let points = multiscale_points(image.view(), None, &options).unwrap().0;
            assert_eq!(points.len(), 260);
            points.iter().filter(|p| p.x > 144.0).count()
        };
        // Two points in each of at least 3 x 8 cells.
        assert!(count(8) >= 45 && count(1) < 10, "{} of 8 cells, {} of one", count(8), count(1));
    }

    #[test]
    fn bad_options_and_images_are_refused_and_a_flat_image_has_no_points() {
        let image = GreyImage::from_fn(64, 64, |_, _| 90).unwrap();
        let default = MultiscaleOptions::default();
        let refused = [
            MultiscaleOptions { number: 0, ..default.clone() },
            MultiscaleOptions { levels: 0, ..default.clone() },
            MultiscaleOptions { levels: 9, ..default.clone() },
            MultiscaleOptions { contrast: f64::NAN, ..default.clone() },
            MultiscaleOptions { contrast: -1.0, ..default.clone() },
            MultiscaleOptions { roundness: 1.1, ..default.clone() },
            MultiscaleOptions { cells: 0, ..default.clone() },
        ];
        for options in refused {
            assert!(matches!(multiscale_points(image.view(), None, &options).err(), Some(Error::InvalidOption { .. })), "{options:?}");
        }
        assert!(multiscale_points(image.view(), None, &default).unwrap().0.is_empty());
        let without_contrast = MultiscaleOptions { contrast: 0.0, ..default.clone() };
        assert!(multiscale_points(image.view(), None, &without_contrast).is_ok());
        let narrow = GreyImage::from_fn(200, 15, |_, _| 0).unwrap();
        assert!(matches!(multiscale_points(narrow.view(), None, &default).err(), Some(Error::ImageTooSmall { min_side: 16, .. })));
        for (width, height) in [(16, 16), (17, 33), (41, 16)] {
            let tiny = GreyImage::from_fn(width, height, |col, row| ((col * col * 5 + row * 37) % 256) as u8).unwrap();
            for levels in 1..=8 {
                assert!(multiscale_points(tiny.view(), None, &MultiscaleOptions { levels, ..default.clone() }).is_ok());
            }
        }
    }
}
