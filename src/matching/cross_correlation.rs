//! Exhaustive normalised cross-correlation of one window over an area of another image.

use super::products::{LANES, products};
use super::search_area::{Extent, SearchArea, allowed, extent, rows_that_allow};
use super::surface::Surface;
use crate::GreyView;
use std::ops::Range;

/// The search for windows of one side; it keeps its tables from window to window.
pub(crate) struct CrossCorrelation {
    side: usize,
    /// The window that is searched, filled up with zeros to a multiple of [`LANES`].
    template: Vec<i16>,
    /// Lines of the searched area, each of them `side` px long and followed by the next.
    strip: Vec<i16>,
    /// Inner products at the positions of one run.
    run: Vec<i32>,
    /// Σab, Σb and Σb² of each position, row by row.
    products: Vec<i32>,
    sums: Vec<i32>,
    squares: Vec<i32>,
    /// Σb and Σb² of each column over the rows of the window.
    of_columns: Vec<[i32; 2]>,
    surface: Surface,
}

impl CrossCorrelation {
    /// `side` of the window is odd, 3..=63.
    ///
    /// # Panics
    /// Where it is not.
    pub fn new(side: usize) -> Self {
        assert!(side % 2 == 1 && (3..=63).contains(&side), "a window of {side} px");
        Self {
            side,
            template: vec![0; (side * side).next_multiple_of(LANES)],
            strip: Vec::new(),
            run: Vec::new(),
            products: Vec::new(),
            sums: Vec::new(),
            squares: Vec::new(),
            of_columns: Vec::new(),
            surface: Surface::default(),
        }
    }

    /// The coefficients ρ = (NΣab - ΣaΣb) / (√(NΣa² - (Σa)²) √(NΣb² - (Σb)²)) of the window of `from` whose centre pixel is `col`,
    /// `row`, at all positions of the area of `to`.
    ///
    /// `None` where that window leaves its image or is constant, or no window of the area lies inside the other image. All sums are
    /// exact. A position where `to` is constant has no coefficient.
    pub fn search(&mut self, from: GreyView<'_>, [col, row]: [usize; 2], to: GreyView<'_>, area: &SearchArea<'_>) -> Option<&Surface> {
        let reach = self.side / 2;
        let corner =
            |place: usize, length: usize| place.checked_sub(reach).filter(|c| length.checked_sub(self.side).is_some_and(|end| *c <= end));
        let window = [corner(col, from.width())?, corner(row, from.height())?];
        let extent = extent(self.side, to, area)?;
        // The run of positions that share a strip goes along the longer side of the area.
        let across = extent.number[0] > extent.number[1];
        let (sum, square) = self.take_template(from, window, across);
        let n = (self.side * self.side) as i64;
        let variance = n * square - sum * sum;
        if variance == 0 {
            return None;
        }
        self.sum_boxes(to, extent);
        self.surface.reset(extent.first, extent.number);
        let allowed = allowed(area, extent);
        self.multiply(to, extent, across, &allowed);
        let (n, sum, scale) = (n as f64, sum as f64, 1.0 / (variance as f64).sqrt());
        let width = extent.number[0];
        for y in 0..extent.number[1] {
            let columns = allowed(y);
            let places = y * width + columns.start..y * width + columns.end;
            let values = self.products[places.clone()].iter().zip(&self.sums[places.clone()]).zip(&self.squares[places]);
            for (coefficient, ((ab, b), bb)) in self.surface.row_mut(y)[columns].iter_mut().zip(values) {
                let (ab, b, bb) = (f64::from(*ab), f64::from(*b), f64::from(*bb));
                // Whole numbers below 2^53: exact.
                let variance = n * bb - b * b;
                let value = (n * ab - sum * b) * scale / variance.sqrt();
                *coefficient = if variance > 0.0 { value } else { Surface::NONE };
            }
        }
        Some(&self.surface)
    }

    /// Whether the way back leads to where a match came from: the window about `found` in `to`, searched in `from` over `reach` px about
    /// `place`, has its peak within `tolerance` px of it in x and in y.
    ///
    /// It costs a search of that area, and replaces the surface of the one before.
    pub fn returns(
        &mut self,
        (from, place): (GreyView<'_>, [usize; 2]),
        (to, found): (GreyView<'_>, [usize; 2]),
        reach: [usize; 2],
        tolerance: usize,
    ) -> bool {
        let area = SearchArea { centre: place.map(|v| i64::try_from(v).unwrap_or(i64::MAX)), reach, columns: None };
        let peak = self.search(to, found, from, &area).and_then(Surface::peak);
        peak.is_some_and(|peak| (0..2).all(|axis| peak.pixel[axis].abs_diff(place[axis]) <= tolerance))
    }

    /// Copies the window, transposed where runs go across; its sum and sum of squares.
    fn take_template(&mut self, from: GreyView<'_>, [left, top]: [usize; 2], across: bool) -> (i64, i64) {
        let side = self.side;
        let (mut sum, mut square) = (0i32, 0i32);
        for r in 0..side {
            for (c, grey) in from.row(top + r)[left..][..side].iter().enumerate() {
                let place = if across { c * side + r } else { r * side + c };
                self.template[place] = i16::from(*grey);
                sum += i32::from(*grey);
                square += i32::from(*grey) * i32::from(*grey);
            }
        }
        (i64::from(sum), i64::from(square))
    }

    /// Σb and Σb² of the window at each position, by adding what enters and taking away what leaves.
    fn sum_boxes(&mut self, to: GreyView<'_>, extent: Extent) {
        let ([left, top], [width, height], side) = (extent.first, extent.number, self.side);
        let (left, top) = (left - side / 2, top - side / 2);
        let row = |y: usize| &to.row(top + y)[left..][..width + side - 1];
        let square = |grey: u8| i32::from(grey) * i32::from(grey);
        self.of_columns.clear();
        self.of_columns.resize(width + side - 1, [0; 2]);
        for y in 0..side - 1 {
            for (sums, b) in self.of_columns.iter_mut().zip(row(y)) {
                *sums = [sums[0] + i32::from(*b), sums[1] + square(*b)];
            }
        }
        self.sums.clear();
        self.squares.clear();
        for y in 0..height {
            for (sums, b) in self.of_columns.iter_mut().zip(row(y + side - 1)) {
                *sums = [sums[0] + i32::from(*b), sums[1] + square(*b)];
            }
            let mut total = self.of_columns[..side - 1].iter().fold([0; 2], |t, s| [t[0] + s[0], t[1] + s[1]]);
            let (leaving, entering) = (&self.of_columns[..width], &self.of_columns[side - 1..]);
            self.sums.extend(leaving.iter().zip(entering).map(|(old, new)| {
                let sum = total[0] + new[0];
                total[0] = sum - old[0];
                sum
            }));
            self.squares.extend(leaving.iter().zip(entering).map(|(old, new)| {
                let sum = total[1] + new[1];
                total[1] = sum - old[1];
                sum
            }));
            for (sums, b) in self.of_columns.iter_mut().zip(row(y)) {
                *sums = [sums[0] - i32::from(*b), sums[1] - square(*b)];
            }
        }
    }

    /// Σab at each allowed position.
    ///
    /// For the positions of one run (those of one column, or of one row where runs go across), the lines of their windows are laid one
    /// after the other into the strip: each window is then one contiguous part of it. From one run to the next every line moves on by one
    /// pixel. In the strip that is done by moving its beginning by one place, and putting the pixel that enters each line where the first
    /// of the next line has just left.
    fn multiply(&mut self, to: GreyView<'_>, extent: Extent, across: bool, allowed: &impl Fn(usize) -> Range<usize>) {
        let ([left, top], [width, height], side) = (extent.first, extent.number, self.side);
        let (left, top) = (left - side / 2, top - side / 2);
        let (runs, length) = if across { (height, width) } else { (width, height) };
        let lines = length + side - 1;
        self.products.resize(width * height, 0);
        self.run.resize(length, 0);
        self.strip.clear();
        self.strip.resize(lines * side + runs + LANES, 0);
        let data = &to.data()[top * to.width() + left..];
        // Distance in the image from a line to the next, and from a pixel of a line to the next.
        let (by_line, by_pixel) = if across { (1, to.width()) } else { (to.width(), 1) };
        for line in 0..lines {
            for (place, pixel) in self.strip[line * side..][..side].iter_mut().zip(data[line * by_line..].iter().step_by(by_pixel)) {
                *place = i16::from(*pixel);
            }
        }
        for run in 0..runs {
            let wanted = if across { allowed(run) } else { rows_that_allow(run, height, allowed) };
            if !wanted.is_empty() {
                let sums = &mut self.run[wanted.clone()];
                products(&self.template, &self.strip[run + wanted.start * side..], side, sums);
                let (first, step) = if across { (run * width + wanted.start, 1) } else { (wanted.start * width + run, width) };
                self.products[first..].iter_mut().step_by(step).zip(sums).for_each(|(place, sum)| *place = *sum);
            }
            if run + 1 < runs {
                let entering = data[(run + side) * by_pixel..].iter().step_by(by_line);
                self.strip[side + run..].iter_mut().step_by(side).zip(entering).take(lines).for_each(|(place, b)| *place = i16::from(*b));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::texture::Texture;
    use super::*;
    use crate::GreyImage;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test;

    fn textured(width: usize, height: usize, dx: usize, dy: usize) -> GreyImage {
        let grey = |x: usize, y: usize| ((x * x * 5 + y * 37 + x * y * 3 + (x / 3) * (y / 4) * 29) % 256) as u8;
        GreyImage::from_fn(width, height, |col, row| grey(col + dx, row + dy)).unwrap()
    }

    /// The coefficient by its definition: covariance by standard deviations.
    fn by_definition(a: &GreyImage, [ac, ar]: [usize; 2], b: &GreyImage, [bc, br]: [usize; 2], side: usize) -> Option<f64> {
        let window = |image: &GreyImage, col: usize, row: usize| -> Option<Vec<f64>> {
            let (left, top) = (col.checked_sub(side / 2)?, row.checked_sub(side / 2)?);
            let inside = left + side <= image.width() && top + side <= image.height();
            inside.then(|| (0..side * side).map(|k| f64::from(image.view().at(left + k % side, top + k / side))).collect())
        };
        let (a, b) = (window(a, ac, ar)?, window(b, bc, br)?);
        let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
        let (ma, mb) = (mean(&a), mean(&b));
        let moment = |x: &[f64], mx: f64, y: &[f64], my: f64| x.iter().zip(y).map(|(x, y)| (x - mx) * (y - my)).sum::<f64>();
        let (aa, bb) = (moment(&a, ma, &a, ma), moment(&b, mb, &b, mb));
        (aa > 1e-9 && bb > 1e-9).then(|| moment(&a, ma, &b, mb) / (aa * bb).sqrt())
    }

    fn compare(left: &GreyImage, right: &GreyImage, side: usize, place: [usize; 2], area: SearchArea<'_>) -> usize {
        let mut search = CrossCorrelation::new(side);
        let surface = search.search(left.view(), place, right.view(), &area);
        let mut number = 0;
        for row in 0..right.height() {
            for col in 0..right.width() {
                let [x, y] = [col as i64 - area.centre[0], row as i64 - area.centre[1]];
                let within = x.unsigned_abs() as usize <= area.reach[0] && y.unsigned_abs() as usize <= area.reach[1];
                let line = (y + area.reach[1] as i64) as usize;
                let searched = within && area.columns.is_none_or(|c| c.get(line).is_some_and(|c| c.contains(&(col as i64))));
                let expected = if searched { by_definition(left, place, right, [col, row], side) } else { None };
                let got = surface.and_then(|s| s.at(col, row));
                assert_eq!(got.is_some(), expected.is_some(), "{side} {place:?} {area:?}: {col}, {row}");
                if let (Some(got), Some(expected)) = (got, expected) {
                    assert!((got - expected).abs() < 1e-12, "{got} {expected}");
                    number += 1;
                }
            }
        }
        number
    }

    /// Natively and as WebAssembly, whose vectors differ.
    #[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
    #[cfg_attr(not(target_arch = "wasm32"), test)]
    fn coefficients_agree_with_the_definition() {
        let (left, right) = (textured(90, 80, 0, 0), textured(84, 88, 4, 3));
        for (side, reach) in [(3, [4, 6]), (11, [6, 4]), (21, [5, 5]), (21, [9, 0]), (21, [0, 9]), (63, [20, 30])] {
            let area = SearchArea { centre: [42, 40], reach, columns: None };
            assert!(compare(&left, &right, side, [44, 41], area) > 0);
        }
        // Beyond the border of the other image.
        for centre in [[3, 4], [82, 86], [-3, 40], [40, 95]] {
            assert!(compare(&left, &right, 7, [44, 41], SearchArea { centre, reach: [9, 12], columns: None }) > 0);
        }
    }

    #[test]
    fn only_allowed_positions_are_searched() {
        let (left, right) = (textured(90, 80, 0, 0), textured(84, 88, 4, 3));
        // A slanting band, of which the first rows have no position, and a list that ends early.
        for (reach, number) in [([12, 8], 15), ([5, 9], 19)] {
            let columns: Vec<_> = (0..number).map(|k| 30 + 2 * k..if k < 2 { 0 } else { 34 + 2 * k }).collect();
            let area = SearchArea { centre: [42, 40], reach, columns: Some(&columns) };
            assert!(compare(&left, &right, 9, [44, 41], area) > 5);
            // Rows above the image count in the list as well.
            compare(&left, &right, 9, [44, 41], SearchArea { centre: [42, 6], ..area });
        }
        let everything = std::array::from_fn::<_, 3, _>(|_| i64::MIN..i64::MAX);
        assert_eq!(compare(&left, &right, 9, [44, 41], SearchArea { centre: [42, 40], reach: [2, 1], columns: Some(&everything) }), 15);
    }

    #[test]
    fn the_tables_of_one_search_do_not_reach_the_next() {
        let (left, right) = (textured(90, 80, 0, 0), textured(84, 88, 4, 3));
        let mut search = CrossCorrelation::new(11);
        let mut peak = |reach| {
            search.search(left.view(), [44, 41], right.view(), &SearchArea { centre: [42, 40], reach, columns: None }).unwrap().peak()
        };
        let small = peak([3, 4]);
        peak([30, 20]);
        assert_eq!(peak([3, 4]), small);
    }

    #[test]
    fn a_shifted_window_is_found() {
        let (left, right) = (textured(90, 80, 0, 0), textured(84, 88, 4, 3));
        let mut search = CrossCorrelation::new(15);
        let area = SearchArea { centre: [44, 41], reach: [8, 8], columns: None };
        let peak = search.search(left.view(), [44, 41], right.view(), &area).unwrap().peak().unwrap();
        assert_eq!((peak.pixel, peak.on_edge), ([40, 38], [false; 2]));
        assert!(peak.coefficient > 1.0 - 1e-12 && peak.coefficient <= 1.0 && peak.second.is_some_and(|s| s < 0.9), "{peak:?}");
    }

    #[test]
    fn the_way_back_leads_to_the_start_of_a_true_match_only() {
        let (left, right) = (textured(90, 80, 0, 0), textured(84, 88, 4, 3));
        let mut search = CrossCorrelation::new(15);
        let mut returns = |place, found, tolerance| search.returns((left.view(), place), (right.view(), found), [8, 8], tolerance);
        assert!(returns([44, 41], [40, 38], 0));
        // The true place is 2 px away from the one that was matched, or outside what is searched.
        assert!(!returns([44, 41], [42, 38], 1) && returns([44, 41], [42, 38], 2));
        assert!(!returns([44, 41], [60, 38], 1));
        assert!(!returns([44, 41], [3, 38], 8) && !returns([usize::MAX, 41], [40, 38], 8));
    }

    #[test]
    fn windows_without_a_coefficient_give_nothing() {
        let (image, flat) = (textured(60, 50, 0, 0), GreyImage::from_fn(60, 50, |_, _| 9).unwrap());
        let area = SearchArea { centre: [30, 25], reach: [3, 3], columns: None };
        let mut search = CrossCorrelation::new(11);
        // The window is constant, leaves its image, or is larger than it.
        assert!(search.search(flat.view(), [30, 25], image.view(), &area).is_none());
        for place in [[4, 25], [55, 25], [30, 4], [30, 45], [usize::MAX, 25]] {
            assert!(search.search(image.view(), place, image.view(), &area).is_none());
        }
        assert!(CrossCorrelation::new(51).search(image.view(), [30, 25], image.view(), &area).is_none());
        // No position lies inside the other image, or all windows there are constant.
        for centre in [[-100, 25], [30, 1000], [i64::MIN, i64::MAX]] {
            assert!(search.search(image.view(), [30, 25], image.view(), &SearchArea { centre, ..area }).is_none());
        }
        assert_eq!(search.search(image.view(), [30, 25], flat.view(), &area).unwrap().peak(), None);
        let far = SearchArea { centre: [0, 0], reach: [usize::MAX; 2], columns: Some(&[]) };
        assert_eq!(search.search(image.view(), [30, 25], image.view(), &far).unwrap().peak(), None);
        let whole = SearchArea { columns: None, ..far };
        assert_eq!(search.search(image.view(), [30, 25], image.view(), &whole).unwrap().peak().unwrap().pixel, [30, 25]);
    }

    /// Root mean square error of the sub-pixel peak in px along one axis, with noise in both images.
    fn error_of_peaks(side: usize, noise: f64) -> f64 {
        let texture = Texture::new(7, 3.0, 30.0);
        let left = texture.plain(150, noise, 1);
        let mut search = CrossCorrelation::new(side);
        let (mut squares, mut number) = (0.0, 0.0);
        for k in 0..8 {
            let shift = [(k as f64 - 3.5) / 8.0, ((3 * k) % 8) as f64 / 8.0 - 0.45];
            let right = texture.image(150, |p| [p[0] - shift[0], p[1] - shift[1]], [0.9, 5.0, noise], 2 + k);
            for place in (0..60).map(|p| [25 + (p * 37) % 100, 25 + (p * 53) % 100]) {
                let area = SearchArea { centre: place.map(|v| v as i64), reach: [4, 4], columns: None };
                let peak = search.search(left.view(), place, right.view(), &area).unwrap().peak().unwrap();
                for axis in 0..2 {
                    let error = peak.position[axis] - place[axis] as f64 - 0.5 - shift[axis];
                    assert!(error.abs() < 0.5, "{place:?} {shift:?} {peak:?}");
                    (squares, number) = (squares + error * error, number + 1.0);
                }
            }
        }
        (squares / number).sqrt()
    }

    #[test]
    fn the_peak_is_found_to_a_fraction_of_a_pixel() {
        // Separate parabolas come to 0.038 and 0.041 px here, the least-squares surface to 0.025 and 0.030 px.
        let errors = [error_of_peaks(21, 0.0), error_of_peaks(21, 3.0), error_of_peaks(11, 3.0)];
        assert!(errors[0] < 0.022 && errors[1] < 0.028 && errors[2] < 0.07, "{errors:?}");
    }
}
