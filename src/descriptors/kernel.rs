//! Raw moments of a grey window, exact in whole numbers.

#[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
#[path = "kernel_simd.rs"]
mod simd;

use super::options::{WindowOptions, WindowShape};
use crate::{Error, GreyView};

/// Pixels that are weighted at once.
const LANES: usize = 16;

/// Powers (i, j) of x and y of the raw moments, in the order of [`RawMoments::sums`].
const POWERS: [(usize, usize); 10] = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2), (3, 0), (2, 1), (1, 2), (0, 3)];

/// Sums over a window, with the origin at its centre pixel, x to the right and y down, in px.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct RawMoments {
    /// Σ x^i y^j I for the powers 00 10 01 20 11 02 30 21 12 03.
    pub sums: [i64; 10],
    pub min: u8,
    pub max: u8,
}

/// A window's outline with the powers of x, laid out for [`Kernel::raw_moments`].
pub(super) struct Kernel {
    side: usize,
    rows: Vec<Vec<Block>>,
    /// Σ x^i y^j over the pixels of the window, in the order of [`RawMoments::sums`].
    pub grid: [i64; 10],
}

/// A part of one row of the window, `LANES` px long.
struct Block {
    /// x^0, x^1, x^2, x^3 of each pixel; 0 outside the outline.
    powers: [[i16; LANES]; 4],
    /// 255 outside the outline, 0 inside.
    outside: [u8; LANES],
}

impl Kernel {
    /// `side` is odd and at most 63, so that cubes fit 16 bits.
    pub fn new(side: usize, shape: WindowShape) -> Self {
        let reach = (side / 2) as i64;
        let inside = |x: i64, y: i64| match shape {
            WindowShape::Square => x.abs() <= reach,
            // Of integers: twice the distance against the side.
            WindowShape::Circle => 4 * (x * x + y * y) <= (side * side) as i64,
        };
        let block = |y: i64, start: usize| {
            let mut block = Block { powers: [[0; LANES]; 4], outside: [255; LANES] };
            for lane in 0..LANES {
                let x = (start + lane) as i64 - reach;
                if start + lane < side && inside(x, y) {
                    block.outside[lane] = 0;
                    (0..4).for_each(|k| block.powers[k][lane] = x.pow(k as u32) as i16);
                }
            }
            block
        };
        let rows = (-reach..=reach).map(|y| (0..side).step_by(LANES).map(|start| block(y, start)).collect()).collect();
        let pixels = || (-reach..=reach).flat_map(|y| (-reach..=reach).map(move |x| (x, y))).filter(|(x, y)| inside(*x, *y));
        let grid = POWERS.map(|(i, j)| pixels().map(|(x, y)| x.pow(i as u32) * y.pow(j as u32)).sum());
        Self { side, rows, grid }
    }

    /// Whether each pixel of the window lies within the outline, row by row.
    pub fn mask(&self) -> Vec<bool> {
        self.rows.iter().flat_map(|row| row.iter().flat_map(|block| block.outside).take(self.side).map(|outside| outside == 0)).collect()
    }

    /// The raw moments of the window centred on a pixel; `None` where it leaves the image.
    pub fn raw_moments(&self, image: GreyView<'_>, col: usize, row: usize) -> Option<RawMoments> {
        let reach = self.side / 2;
        let (left, top) = (col.checked_sub(reach)?, row.checked_sub(reach)?);
        // Compared without adding to what the caller gave, which may be the largest number there is.
        let beyond = |place: usize, length: usize| length.checked_sub(reach).is_none_or(|end| place >= end);
        if beyond(col, image.width()) || beyond(row, image.height()) {
            return None;
        }
        let rows = || self.rows.iter().enumerate().map(|(k, blocks)| (blocks, (top + k) * image.width() + left));
        #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
        if self.side <= simd::WIDEST {
            return Some(simd::raw_moments(image.data(), rows()));
        }
        Some(raw_moments(image.data(), rows()))
    }
}

impl WindowOptions {
    /// Whether each pixel of the window lies within its outline, row by row.
    ///
    /// # Errors
    /// [`Error::InvalidOption`] for the side.
    pub fn mask(&self) -> Result<Vec<bool>, Error> {
        self.check_ranges()?;
        Ok(Kernel::new(self.side, self.shape).mask())
    }
}

/// The raw moments of a window, of which each row is given by its blocks and the place of its first pixel.
fn raw_moments<'k>(data: &[u8], rows: impl ExactSizeIterator<Item = (&'k Vec<Block>, usize)>) -> RawMoments {
    let mut raw = RawMoments { sums: [0; 10], min: 255, max: 0 };
    let reach = (rows.len() / 2) as i64;
    for ((blocks, start), y) in rows.zip(-reach..) {
        let mut sums = [0i32; 4];
        for (block, b) in blocks.iter().zip(0..) {
            let grey = load(data, start + b * LANES);
            for (sum, powers) in sums.iter_mut().zip(&block.powers) {
                *sum += powers.iter().zip(&grey).map(|(p, g)| i32::from(*p) * i32::from(*g)).sum::<i32>();
            }
            raw.min = grey.iter().zip(&block.outside).map(|(g, outside)| g | outside).fold(raw.min, u8::min);
            raw.max = grey.iter().zip(&block.outside).map(|(g, outside)| g & !outside).fold(raw.max, u8::max);
        }
        let s = sums.map(i64::from);
        let of_row = [s[0], s[1], s[0] * y, s[2], s[1] * y, s[0] * y * y, s[3], s[2] * y, s[1] * y * y, s[0] * y * y * y];
        raw.sums.iter_mut().zip(of_row).for_each(|(sum, part)| *sum += part);
    }
    raw
}

/// `LANES` pixels from `start`; zeros after the end of the image, where no outline reaches.
fn load(data: &[u8], start: usize) -> [u8; LANES] {
    match data.get(start..start + LANES) {
        Some(grey) => grey.try_into().expect("the length is LANES"),
        None => std::array::from_fn(|lane| data.get(start + lane).copied().unwrap_or(0)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::GreyImage;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test;

    fn textured(width: usize, height: usize) -> GreyImage {
        GreyImage::from_fn(width, height, |col, row| ((col * col * 5 + row * 37 + col * row * 3) % 256) as u8).unwrap()
    }

    /// Natively this looks at the plain version, as WebAssembly at that of SIMD.
    #[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
    #[cfg_attr(not(target_arch = "wasm32"), test)]
    fn agrees_with_the_definition() {
        let image = textured(70, 66);
        for (side, shape) in [
            (3, WindowShape::Square),
            (11, WindowShape::Square),
            (11, WindowShape::Circle),
            (17, WindowShape::Circle),
            (63, WindowShape::Square),
        ] {
            let kernel = Kernel::new(side, shape);
            let mask = kernel.mask();
            let reach = side as i64 / 2;
            for (col, row) in [(reach as usize, reach as usize), (35, 33), (70 - 1 - reach as usize, 66 - 1 - reach as usize)] {
                let raw = kernel.raw_moments(image.view(), col, row).unwrap();
                let pixels: Vec<_> = (0..side * side)
                    .filter(|k| mask[*k])
                    .map(|k| ((k % side) as i64 - reach, (k / side) as i64 - reach))
                    .map(|(x, y)| (x, y, i64::from(image.view().at((col as i64 + x) as usize, (row as i64 + y) as usize))))
                    .collect();
                let expected = POWERS.map(|(i, j)| pixels.iter().map(|(x, y, g)| x.pow(i as u32) * y.pow(j as u32) * g).sum::<i64>());
                assert_eq!(raw.sums, expected, "side {side}, {shape:?}");
                assert_eq!(i64::from(raw.min), pixels.iter().map(|p| p.2).min().unwrap());
                assert_eq!(i64::from(raw.max), pixels.iter().map(|p| p.2).max().unwrap());
                assert_eq!(kernel.grid[0], pixels.len() as i64);
            }
        }
    }

    #[cfg(all(target_arch = "wasm32", target_feature = "simd128"))]
    #[wasm_bindgen_test]
    fn simd_agrees_with_the_plain_version() {
        // The brightest image at the widest side comes nearest to an overflow.
        for (image, side) in [(textured(70, 66), 11), (GreyImage::from_fn(40, 40, |c, r| 255 - u8::from(c == r)).unwrap(), simd::WIDEST)] {
            for shape in [WindowShape::Square, WindowShape::Circle] {
                let kernel = Kernel::new(side, shape);
                let top = 20 - side / 2;
                let rows = || kernel.rows.iter().enumerate().map(|(k, blocks)| (blocks, (top + k) * image.width() + top));
                assert_eq!(simd::raw_moments(image.data(), rows()), raw_moments(image.data(), rows()));
            }
        }
    }

    #[test]
    fn a_window_that_leaves_the_image_has_none() {
        let image = textured(20, 12);
        let kernel = Kernel::new(11, WindowShape::Square);
        for (col, row) in [(4, 6), (15, 6), (10, 4), (10, 7), (usize::MAX, 6), (10, usize::MAX)] {
            assert_eq!(kernel.raw_moments(image.view(), col, row), None);
        }
        assert!(kernel.raw_moments(image.view(), 5, 5).is_some());
    }

    #[test]
    fn the_circle_holds_the_pixels_within_half_the_side() {
        let mask = Kernel::new(5, WindowShape::Circle).mask();
        let rows: Vec<usize> = mask.chunks(5).map(|row| row.iter().filter(|inside| **inside).count()).collect();
        assert_eq!(rows, [3, 5, 5, 5, 3]);
    }
}
