//! What the frame of a scan shows of the photograph: its pixels, and which of them are of it.

use super::scan::{FilmScan, hidden_mm};
use crate::error::refuse;
use crate::image::{Neighbours, each_position};
use crate::{Bands, Error, GreyImage, GreyView, Refusal};

/// So near the edges of the scan nothing is of the photograph: what is matched there would see beyond.
const EDGE_PX: f64 = 8.0;

impl FilmScan {
    /// Whether a position in the frame is of the photograph: within the scan, and beside the marks.
    pub(crate) fn shows<'a>(&'a self, marks_mm: &[[f64; 2]]) -> impl Fn([f64; 2]) -> bool + use<'a> {
        let (marks, hidden) = self.marks_in_frame(marks_mm);
        move |at| {
            let is_hidden = || marks.iter().any(|mark| libm::hypot(at[0] - mark[0], at[1] - mark[1]) < hidden);
            self.in_scan(at).is_some_and(|at| self.is_inner(at)) && !is_hidden()
        }
    }

    /// The same of all pixels of the frame: 255 where it shows the photograph, else 0.
    ///
    /// # Errors
    /// As [`GreyImage::new`].
    pub(crate) fn mask(&self, marks_mm: &[[f64; 2]]) -> Result<GreyImage, Error> {
        let size = self.frame_px.map(|side| side as usize);
        let mut shown = Vec::with_capacity(size[0] * size[1]);
        let position = |[column, row]: [usize; 2]| self.in_scan([column as f64 + 0.5, row as f64 + 0.5]);
        each_position(size, position, |at| shown.push(if at.is_some_and(|at| self.is_inner(at)) { 255 } else { 0 }));
        let (marks, hidden) = self.marks_in_frame(marks_mm);
        for [x, y] in marks {
            let range =
                |at: f64, side: usize| (at - hidden).clamp(0.0, side as f64) as usize..(at + hidden + 1.0).clamp(0.0, side as f64) as usize;
            for (row, column) in range(y, size[1]).flat_map(|row| range(x, size[0]).map(move |column| (row, column))) {
                if libm::hypot(column as f64 + 0.5 - x, row as f64 + 0.5 - y) < hidden {
                    shown[row * size[0] + column] = 0;
                }
            }
        }
        GreyImage::new(size[0], size[1], shown)
    }

    /// A mask of the frame that leaves out, too, what a mask as large as the scan does: where they are 0.
    ///
    /// # Errors
    /// As [`GreyImage::new`].
    pub(crate) fn masked(&self, own: &GreyImage, of_scan: GreyView<'_>) -> Result<GreyImage, Error> {
        let [width, height] = [of_scan.width(), of_scan.height()].map(|side| side as f64);
        let size = self.frame_px.map(|side| side as usize);
        let mut shown = Vec::with_capacity(size[0] * size[1]);
        let position = |[column, row]: [usize; 2]| self.in_scan([column as f64 + 0.5, row as f64 + 0.5]);
        each_position(size, position, |at| {
            let is_wanted = |[x, y]: [f64; 2]| {
                let is_within = x >= 0.0 && y >= 0.0 && x < width && y < height;
                is_within && of_scan.at(x as usize, y as usize) != 0
            };
            let value = own.data()[shown.len()];
            shown.push(if at.is_some_and(is_wanted) { value } else { 0 });
        });
        GreyImage::new(size[0], size[1], shown)
    }

    /// Where marks are in the frame, and what is hidden about each, in px.
    fn marks_in_frame(&self, marks_mm: &[[f64; 2]]) -> (Vec<[f64; 2]>, f64) {
        let scale = self.scale();
        let in_frame = |at: [f64; 2]| [0, 1].map(|k| (at[k] - self.corner_px[k]) / scale);
        (marks_mm.iter().map(|mark| in_frame(self.of_mark(*mark))).collect(), hidden_mm(marks_mm) / self.pixel_mm)
    }

    /// Whether a position in the scan is well within it.
    fn is_inner(&self, [x, y]: [f64; 2]) -> bool {
        let [width, height] = [self.width_px, self.height_px].map(f64::from);
        (EDGE_PX..=width - EDGE_PX).contains(&x) && (EDGE_PX..=height - EDGE_PX).contains(&y)
    }

    /// The bands of the scan resampled to the frame, by bicubic convolution; what the scan does not show is 0.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a scan of another size.
    pub(crate) fn frame(&self, scan: &[GreyView<'_>]) -> Result<Bands, Error> {
        let own = [self.width_px, self.height_px].map(|side| side as usize);
        if let Some(other) = scan.iter().find(|band| [band.width(), band.height()] != own) {
            let [width_px, height_px] = own;
            return refuse(Refusal::CameraSize { width_px, height_px, width: other.width(), height: other.height() });
        }
        let size = self.frame_px.map(|side| side as usize);
        let mut bands: Vec<Vec<u8>> = scan.iter().map(|_| Vec::with_capacity(size[0] * size[1])).collect();
        let position = |[column, row]: [usize; 2]| self.in_scan([column as f64 + 0.5, row as f64 + 0.5]);
        each_position(size, position, |at| {
            let seen = at.filter(|at| (0..2).all(|k| (0.0..=own[k] as f64).contains(&at[k])));
            let neighbours = seen.map(|at| Neighbours::about(at, own));
            bands.iter_mut().zip(scan).for_each(|(band, scan)| band.push(neighbours.as_ref().map_or(0, |n| n.mean(*scan))));
        });
        Bands::of(size, bands)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::known_scan::{SIZE, in_scan, measured};

    #[test]
    fn marks_are_hidden_where_a_camera_without_distortion_sees_them() {
        let mut film = measured(|| 0.0);
        // 7.6 mm at the corners.
        film.camera.as_mut().unwrap().radial_distortion = [2.25e-6, 0.0, 0.0];
        film.marks_mm = vec![[80.0, 0.0]];
        let scan = FilmScan::in_common(&film, SIZE, 0.3).unwrap();
        let shows = scan.shows(&film.film_marks());
        let [there, beside] = [[80.0, 0.0], [76.0, 0.0]].map(|[x, y]| shows(scan.in_frame(in_scan(x, y))));
        assert_eq!([there, beside], [false, true]);
        let mask = scan.mask(&film.film_marks()).unwrap();
        let at = |x: f64| {
            let [column, row] = scan.in_frame(in_scan(x, 0.0));
            mask.view().at(column as usize, row as usize)
        };
        assert_eq!([at(80.0), at(76.0)], [0, 255]);
    }

    #[test]
    fn a_scan_is_resampled_to_what_its_frame_shows() {
        let film = measured(|| 0.0);
        let own = FilmScan::new(&film, SIZE).unwrap();
        let grey = |[x, y]: [f64; 2]| 128.0 + 60.0 * libm::sin(0.05 * x) * libm::cos(0.04 * y);
        let scan = GreyImage::from_fn(SIZE[0], SIZE[1], |c, r| (grey([c as f64 + 0.5, r as f64 + 0.5]) + 0.5) as u8).unwrap();
        let frame = own.frame(&[scan.view()]).unwrap().into_first();
        assert_eq!([frame.width() as u32, frame.height() as u32], own.frame_px);
        for (c, r) in (0..frame.width()).step_by(37).flat_map(|c| (0..frame.height()).step_by(41).map(move |r| (c, r))) {
            let at = own.in_scan([c as f64 + 0.5, r as f64 + 0.5]).unwrap();
            let is_within = (0..2).all(|k| (1.0..SIZE[k] as f64 - 1.0).contains(&at[k]));
            let got = f64::from(frame.view().at(c, r));
            assert!(!is_within || (got - grey(at)).abs() < 1.5, "{got} {}", grey(at));
        }
        let small = GreyImage::from_fn(50, 40, |_, _| 0).unwrap();
        assert!(own.frame(&[small.view()]).unwrap_err().to_string().contains("50"));
    }
}
