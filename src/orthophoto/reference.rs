//! An orthophoto as the reference of images.

use super::georeference::Georeference;
use super::geotiff::{GeoTags, refuse_degrees};
use super::heights::{HeightModel, Heights};
use super::rectify::Rectified;
use super::write::{write_geotiff, write_heights};
use crate::error::refuse;
use crate::{DecodeLimits, Error, Feature, FeatureOptions, GreyImage, Refusal, ScalePoint, decode, features, halve};

/// An orthophoto with the heights of its ground.
#[derive(Debug, Clone, PartialEq)]
pub struct Orthophoto {
    pub grey: GreyImage,
    pub georeference: Georeference,
    pub heights: Heights,
    /// The EPSG code of its system, where the file tells one.
    pub epsg: Option<u16>,
    /// 0 where it shows nothing, 255 elsewhere; absent where it shows something everywhere.
    mask: Option<GreyImage>,
}

/// Grey value of pixels that show nothing, where a file does not name another.
const EMPTY: u8 = 0;
/// A pixel shows nothing where all about it so far, in px, have the value of nothing: single black pixels are shadows.
const EMPTY_REACH: usize = 4;
/// Heights are looked up at so many places along each side.
const LOOKED_UP: usize = 32;
/// Points within so many px of where nothing is shown are the edge of the picture.
const EDGE: usize = 8;

impl Orthophoto {
    /// Takes grey values with their place.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a georeference that places nothing.
    pub fn new(grey: GreyImage, georeference: Georeference, heights: Heights) -> Result<Self, Error> {
        let mask = mask_of(&grey, EMPTY);
        Ok(Self { georeference: georeference.checked()?, heights, epsg: None, mask, grey })
    }

    /// Reads a GeoTIFF, or any image with a world file beside it.
    ///
    /// # Errors
    /// As [`decode`]; [`Error::InvalidInput`] for a file that does not say where it lies, or says it in degrees.
    pub fn read(file: &[u8], world_file: Option<&str>, heights: Heights, limits: &DecodeLimits) -> Result<Self, Error> {
        let decoded = decode(file, limits)?;
        let tags = if decoded.format == "TIFF" { GeoTags::read(file)? } else { GeoTags::default() };
        let georeference = match (tags.georeference, world_file) {
            (Some(own), _) => own,
            (None, Some(text)) => Georeference::read_world_file(text)?,
            (None, None) => {
                return refuse(Refusal::PictureWithoutPlace { format: decoded.format.into() });
            }
        };
        if georeference.is_in_degrees([decoded.grey.width(), decoded.grey.height()]) {
            return refuse_degrees();
        }
        let empty = tags.no_data.filter(|v| (0.0..=255.0).contains(v)).map_or(EMPTY, |v| v as u8);
        let mask = mask_of(&decoded.grey, empty);
        Ok(Self { grey: decoded.grey, georeference: georeference.checked()?, heights, epsg: tags.epsg, mask })
    }

    /// As GeoTIFF files: the picture, and the heights of its ground, which are a grid of the same size where they are no model.
    ///
    /// # Errors
    /// As [`write_geotiff`](crate::write_geotiff).
    pub fn files(&self) -> Result<[Vec<u8>; 2], Error> {
        let mask = self.mask.clone().map_or_else(|| GreyImage::from_fn(self.grey.width(), self.grey.height(), |_, _| 255), Ok)?;
        let picture = Rectified { grey: self.grey.clone(), mask, georeference: self.georeference };
        let heights = match &self.heights {
            Heights::Model(model) => write_heights(model, self.epsg),
            Heights::Level(height) => {
                let (width, rows) = (self.grey.width().max(2), self.grey.height().max(2));
                let model = HeightModel::new(width, rows, vec![*height as f32; width * rows], self.georeference)?;
                write_heights(&model, self.epsg)
            }
        };
        Ok([write_geotiff(&picture, self.epsg)?, heights?])
    }

    /// In a system whose origin is that place of this one.
    pub(super) fn about(&self, place: [f64; 2]) -> (Georeference, Heights) {
        (self.georeference.about(place), self.heights.about(place))
    }

    /// The part from a column and row on, halved so many times; 0 beyond the picture.
    pub(super) fn part(&self, first: [usize; 2], size: [usize; 2], halvings: u32) -> Result<GreyImage, Error> {
        part(&self.grey, first, size, halvings)
    }

    /// Features of such a part; positions and scales are those of the picture itself.
    pub(super) fn features(
        &self,
        first: [usize; 2],
        size: [usize; 2],
        halvings: u32,
        options: &FeatureOptions,
    ) -> Result<Vec<Feature>, Error> {
        let grey = self.part(first, size, halvings)?;
        let mask = self.mask.as_ref().map(|mask| part(mask, first, size, halvings)).transpose()?;
        let mut found = features(grey.view(), mask.as_ref().map(GreyImage::view), options)?;
        for point in found.iter_mut().map(|feature| &mut feature.point) {
            enlarge(point, f64::from(1_u32 << halvings));
            (point.x, point.y) = (point.x + first[0] as f64, point.y + first[1] as f64);
        }
        Ok(found)
    }

    /// The share of many places of the picture that have a height.
    pub fn heights_share(&self) -> f64 {
        let size = [self.grey.width(), self.grey.height()].map(|side| side as f64);
        let share = |k: usize| (k as f64 + 0.5) / LOOKED_UP as f64;
        let places = (0..LOOKED_UP * LOOKED_UP).map(|k| [share(k % LOOKED_UP) * size[0], share(k / LOOKED_UP) * size[1]]);
        let number = (LOOKED_UP * LOOKED_UP) as f64;
        places.filter(|at| self.heights.at(self.georeference.ground(*at)).is_some()).count() as f64 / number
    }

    /// Whether the picture shows something at a position in px.
    pub fn shows(&self, [x, y]: [f64; 2]) -> bool {
        let inside = x >= 0.0 && y >= 0.0 && x < self.grey.width() as f64 && y < self.grey.height() as f64;
        inside && self.mask.as_ref().is_none_or(|mask| mask.view().at(x as usize, y as usize) != 0)
    }
}

/// A part of an image, halved so many times.
fn part(image: &GreyImage, [column, row]: [usize; 2], [width, height]: [usize; 2], halvings: u32) -> Result<GreyImage, Error> {
    let view = image.view();
    let grey = |c: usize, r: usize| {
        let (c, r) = (column + c, row + r);
        if c < view.width() && r < view.height() { view.at(c, r) } else { EMPTY }
    };
    let part = GreyImage::from_fn(width, height, grey)?;
    Ok((0..halvings).fold(part, |part, _| halve(part.view())))
}

/// A point of a reduced image as one of the image itself.
pub(super) fn enlarge(point: &mut ScalePoint, factor: f64) {
    (point.x, point.y, point.scale_px) = (factor * point.x, factor * point.y, factor * point.scale_px);
}

/// Where a picture shows something, less its edge.
fn mask_of(grey: &GreyImage, empty: u8) -> Option<GreyImage> {
    let (width, height) = (grey.width(), grey.height());
    let is_empty: Vec<bool> = grey.data().iter().map(|v| *v == empty).collect();
    if !is_empty.contains(&true) {
        return None;
    }
    // Shrunk to the middles of what is empty, and grown again by that and the edge.
    let inner = spread(&is_empty, width, height, EMPTY_REACH, true);
    if !inner.contains(&true) {
        return None;
    }
    let outer = spread(&inner, width, height, EMPTY_REACH + EDGE, false);
    let data = outer.into_iter().map(|nothing| if nothing { 0 } else { 255 }).collect();
    GreyImage::new(width, height, data).ok()
}

/// For each pixel whether all (or any) of the square about it are set; beyond the edges counts as set for all, as not set for any.
fn spread(set: &[bool], width: usize, height: usize, reach: usize, all: bool) -> Vec<bool> {
    let settled = |count: u32| if all { count == 0 } else { count > 0 };
    // How many of the window differ from what decides alone.
    let decides = |set: bool| u32::from(set != all);
    let mut rows = vec![false; set.len()];
    for (row, out) in set.chunks_exact(width).zip(rows.chunks_exact_mut(width)) {
        let mut count: u32 = row.iter().take(reach).map(|set| decides(*set)).sum();
        for k in 0..width {
            count += row.get(k + reach).map_or(0, |set| decides(*set));
            out[k] = settled(count);
            count -= k.checked_sub(reach).map_or(0, |gone| decides(row[gone]));
        }
    }
    // Down the columns all at once: the memory is walked row by row.
    let row_of = |r: usize| &rows[r * width..(r + 1) * width];
    let mut counts = vec![0_u32; width];
    let add = |counts: &mut [u32], r: usize| counts.iter_mut().zip(row_of(r)).for_each(|(count, set)| *count += decides(*set));
    (0..reach.min(height)).for_each(|r| add(&mut counts, r));
    let mut columns = vec![false; set.len()];
    for (r, out) in columns.chunks_exact_mut(width).enumerate() {
        if r + reach < height {
            add(&mut counts, r + reach);
        }
        out.iter_mut().zip(&counts).for_each(|(out, count)| *out = settled(*count));
        if let Some(gone) = r.checked_sub(reach) {
            counts.iter_mut().zip(row_of(gone)).for_each(|(count, set)| *count -= decides(*set));
        }
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_shows_nothing_is_left_out_with_its_edge_and_shadows_are_not() {
        // The left third is empty, and there are single black pixels elsewhere.
        let grey = GreyImage::from_fn(90, 60, |c, r| if c < 30 || (c % 11 == 0 && r % 7 == 0) { 0 } else { 100 }).unwrap();
        let ortho = Orthophoto::new(grey, Georeference::north_up([0.0, 0.0], 1.0), Heights::Level(0.0)).unwrap();
        assert!(!ortho.shows([10.0, 30.0]) && !ortho.shows([36.0, 30.0]) && ortho.shows([40.0, 30.0]) && ortho.shows([55.0, 7.0]));
        assert!(!ortho.shows([-1.0, 5.0]) && !ortho.shows([95.0, 5.0]));
        let full = GreyImage::from_fn(40, 40, |c, _| 1 + c as u8).unwrap();
        let corner = GreyImage::from_fn(60, 50, |c, r| if c < 20 && r >= 30 { 0 } else { 9 }).unwrap();
        let ortho = Orthophoto::new(corner, Georeference::north_up([0.0, 0.0], 1.0), Heights::Level(0.0)).unwrap();
        // Its edge of 8 px is left out with it, to the right and above alike.
        let shows = [[27.5, 40.5], [28.5, 40.5], [5.5, 22.5], [5.5, 21.5]].map(|at| ortho.shows(at));
        assert_eq!(shows, [false, true, false, true]);
        assert_eq!(Orthophoto::new(full, Georeference::north_up([0.0, 0.0], 1.0), Heights::Level(0.0)).unwrap().mask, None);
    }

    #[test]
    fn a_picture_without_a_place_is_refused() {
        let file = crate::write_png(GreyImage::from_fn(20, 20, |c, _| c as u8).unwrap().view(), None);
        let read = |world: Option<&str>| Orthophoto::read(&file, world, Heights::Level(0.0), &DecodeLimits::default());
        assert!(read(None).unwrap_err().to_string().contains("does not say where it lies"));
        assert_eq!(read(Some("2 0 0 -2 101 199")).unwrap().georeference, Georeference::north_up([100.0, 200.0], 2.0));
    }
}
