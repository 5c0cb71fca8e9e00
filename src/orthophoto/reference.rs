//! An orthophoto as the reference of images.

use super::ground::Ground;
use super::heights::{HeightModel, Heights};
use super::parts::Parts;
use super::picture::Picture;
use super::rectify::Rectified;
use super::write::{write_geotiff, write_heights};
use crate::Georeference;
use crate::error::refuse;
use crate::georeferenced::{GeoTags, SaidSystem, Sidecars, refuse_degrees};
use crate::image::{TiffRaster, Wanted, is_tiff};
use crate::source::{read_all, unread};
use crate::{
    Bands, DecodeLimits, Document, Error, Feature, FeatureOptions, FileSource, GreyImage, Refusal, ScalePoint, decode, decode_bands,
    features,
};
use std::io;
use std::sync::Arc;

/// An orthophoto with the heights of its ground.
#[derive(Debug, Clone)]
pub struct Orthophoto {
    picture: Picture,
    pub georeference: Georeference,
    pub heights: Heights,
    /// The EPSG code of its system, where the file tells one.
    pub epsg: Option<u16>,
    /// What the file says of its system beside that.
    said: SaidSystem,
}

/// Grey value of pixels that show nothing, where a file does not name another.
const EMPTY: u8 = 0;
/// TIFFs of more pixels are read in parts, where their tiles or strips have at most so many; none has more than can be looked through.
const MOST_WHOLE: u64 = 40_000_000;
const MOST_CHUNK: usize = 16_000_000;
const MOST_IN_PARTS: u64 = 40_000_000_000;
/// What is shown at once, in pixels, at most.
const MOST_SHOWN: usize = 1 << 24;
/// Heights are looked up at so many places along each side.
const LOOKED_UP: usize = 32;

impl Orthophoto {
    /// A picture is halved so often at most, after which nothing is left of any.
    pub const MOST_HALVINGS: u32 = 16;

    /// Takes grey values with their place.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a georeference that places nothing, or the picture mirrored.
    pub fn new(grey: GreyImage, georeference: Georeference, heights: Heights) -> Result<Self, Error> {
        let nothing: Vec<bool> = grey.data().iter().map(|value| *value == EMPTY).collect();
        let picture = Picture::whole(grey, &nothing);
        Ok(Self { georeference: georeference.checked()?.of_picture()?, heights, epsg: None, said: SaidSystem::default(), picture })
    }

    /// Reads a GeoTIFF, or any image with a world file beside it.
    ///
    /// # Errors
    /// As [`open`](Self::open).
    pub fn read(file: &[u8], sidecars: impl Into<Sidecars>, heights: Heights, limits: &DecodeLimits) -> Result<Self, Error> {
        Self::open(Arc::new(file.to_vec()), sidecars, heights, limits)
    }

    /// Opens a GeoTIFF, or any image with a world file beside it, and perhaps one that says its system. A TIFF of more than 40 million pixels in tiles or strips is read where it is needed,
    /// from the overviews that it holds where these are enough; everything else at once, within the limits.
    ///
    /// Nothing is shown where alpha is 0; without alpha where all colours have the value that the file names for no data, or else grey is 0.
    ///
    /// # Errors
    /// As [`decode`]; [`Error::InvalidInput`] for a file that does not say where it lies, or says it in degrees or mirrored, and for heights of another system.
    pub fn open(file: Arc<dyn FileSource>, sidecars: impl Into<Sidecars>, heights: Heights, limits: &DecodeLimits) -> Result<Self, Error> {
        let sidecars = sidecars.into();
        let mut tags = GeoTags::default();
        let mut raster = None;
        if is_tiff(&file) {
            tags = GeoTags::read(Arc::clone(&file))?;
            raster = TiffRaster::open(Arc::clone(&file), tags.no_data, MOST_CHUNK)?;
        }
        let (picture, format) = match raster {
            Some(raster) => (of_raster(raster, &file, tags.no_data, limits)?, "TIFF"),
            None => {
                let bytes = read_all(&*file, Document::Orthophoto)?;
                let decoded = decode(&bytes, limits)?;
                let empty = tags.no_data.filter(|v| (0.0..=255.0).contains(v)).map_or(EMPTY, |v| v as u8);
                let nothing: Vec<bool> = decoded.grey.data().iter().map(|value| *value == empty).collect();
                let (again, limits) = (Arc::clone(&file), *limits);
                let colours = move || decode_bands(&read_all(&*again, Document::Orthophoto)?, &limits);
                (Picture::coloured(decoded.grey, &nothing, colours), decoded.format)
            }
        };
        let georeference = match (tags.georeference, &sidecars.world_file) {
            (Some(own), _) => own,
            (None, Some(text)) => Georeference::read_world_file(text)?,
            (None, None) => return refuse(Refusal::PictureWithoutPlace { format: format.into() }),
        };
        let georeference = georeference.checked()?.of_picture()?;
        if georeference.is_in_degrees(picture.size()) {
            return refuse_degrees();
        }
        let said = sidecars.system(tags.system)?;
        let heights = heights.for_ground(&Ground::said(&said))?;
        Ok(Self { picture, georeference, heights, epsg: said.epsg, said })
    }

    /// Gives its ground other heights.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for a model of another system, and one that has no height under the orthophoto.
    pub fn set_heights(&mut self, heights: Heights) -> Result<(), Error> {
        let heights = heights.for_ground(&Ground::said(&self.said()))?;
        let earlier = std::mem::replace(&mut self.heights, heights);
        if self.heights_share() == 0.0 {
            self.heights = earlier;
            return refuse(Refusal::NoHeightsThere);
        }
        Ok(())
    }

    /// Width and height in px.
    pub fn size(&self) -> [usize; 2] {
        self.picture.size()
    }

    /// Whether its pixels are read where they are needed.
    pub fn is_in_parts(&self) -> bool {
        matches!(self.picture, Picture::Parts(_))
    }

    /// All of its grey values.
    ///
    /// # Errors
    /// [`Error::TooManyPixels`] for more than 100 million where it is read in parts; [`Error::UnreadableImage`] for a damaged file.
    pub fn grey(&self) -> Result<GreyImage, Error> {
        self.picture.part([0, 0], self.size(), 0)
    }

    /// As GeoTIFF files: the picture, and the heights of its ground, which are a grid of the same size where they are no model.
    ///
    /// # Errors
    /// As [`grey`](Self::grey) and [`write_geotiff`](crate::write_geotiff).
    pub fn files(&self) -> Result<[Vec<u8>; 2], Error> {
        let [width, rows] = self.size();
        let patch = self.picture.patch([0, 0], [width, rows], 0)?;
        let mask = patch.mask.map_or_else(|| GreyImage::from_fn(width, rows, |_, _| 255), Ok)?;
        let picture = Rectified { bands: patch.grey.into(), mask, georeference: self.georeference };
        let heights = match &self.heights {
            Heights::Model(model) => write_heights(model, self.epsg),
            Heights::Level(height) => {
                let (width, rows) = (width.max(2), rows.max(2));
                let model = HeightModel::new(width, rows, vec![*height as f32; width * rows], self.georeference)?;
                write_heights(&model, self.epsg)
            }
        };
        Ok([write_geotiff(&picture, self.epsg)?, heights?])
    }

    /// What its system is called where its file describes one without a code; it may have no name.
    pub fn described(&self) -> Option<&str> {
        self.said.described.as_deref().filter(|_| self.epsg.is_none())
    }

    /// What its file says of its system, with the code that it has now.
    pub(super) fn said(&self) -> SaidSystem {
        SaidSystem { epsg: self.epsg, ..self.said.clone() }
    }

    /// In m: an easting and a northing of 1 are so many, heights are metres unless their file says otherwise.
    pub(super) fn in_metres(&self, unit_m: f64) -> Self {
        Self { georeference: self.georeference.enlarged(unit_m), heights: self.heights.in_metres(unit_m), ..self.clone() }
    }

    /// In a system whose origin is that place of this one.
    pub(super) fn about(&self, place: [f64; 2]) -> (Georeference, Heights) {
        (self.georeference.about(place), self.heights.about(place))
    }

    /// A column and row near these, and before them, from which on a part can be halved so many times.
    pub(super) fn aligned(&self, first: [usize; 2], halvings: u32) -> [usize; 2] {
        self.picture.aligned(first, halvings)
    }

    /// The part from such a column and row on, halved so many times; 0 beyond the picture.
    pub(super) fn part(&self, first: [usize; 2], size: [usize; 2], halvings: u32) -> Result<GreyImage, Error> {
        self.picture.part(first, size, halvings)
    }

    /// Features of what a part shows that was halved so many times; positions and scales are those of the picture itself, positions to a pixel of the
    /// halved one.
    pub(super) fn features(
        &self,
        first: [usize; 2],
        size: [usize; 2],
        halvings: u32,
        options: &FeatureOptions,
    ) -> Result<Vec<Feature>, Error> {
        let patch = self.picture.patch(first, size, halvings)?;
        let mut found = features(patch.grey.view(), patch.mask.as_ref().map(GreyImage::view), options)?;
        // A large picture is not read once more for them.
        let is_whole = !self.is_in_parts();
        let shows = |point: &ScalePoint| match &patch.mask {
            Some(mask) if !is_whole => mask.view().at(point.x as usize, point.y as usize) == 255,
            _ => true,
        };
        found.retain(|feature| shows(&feature.point));
        for point in found.iter_mut().map(|feature| &mut feature.point) {
            enlarge(point, f64::from(1_u32 << halvings));
            (point.x, point.y) = (point.x + patch.first[0] as f64, point.y + patch.first[1] as f64);
        }
        found.retain(|feature| !is_whole || self.shows([feature.point.x, feature.point.y]));
        Ok(found)
    }

    /// Grey values of a part of the picture that was halved so many times, `size` from a column and row of the halved picture on: 0 where it shows
    /// nothing, 1 or more elsewhere. After 16 halvings nothing is left of any picture.
    ///
    /// # Errors
    /// [`Error::TooManyPixels`] for more than 16.8 million; [`Error::UnreadableImage`] for a damaged file.
    pub fn shown(&self, first: [usize; 2], size: [usize; 2], halvings: u32) -> Result<Vec<u8>, Error> {
        let number = shown_pixels(size)?;
        if halvings > Self::MOST_HALVINGS { Ok(vec![0; number]) } else { self.picture.shown(first, size, halvings) }
    }

    /// Red, green, blue and alpha of such a part, pixel by pixel; alpha is 0 where it shows nothing, 255 elsewhere. Three equal values where the file has no
    /// colours, or none that can be had.
    ///
    /// # Errors
    /// As [`shown`](Self::shown).
    pub fn colours(&self, first: [usize; 2], size: [usize; 2], halvings: u32) -> Result<Vec<u8>, Error> {
        let number = shown_pixels(size)?;
        if halvings > Self::MOST_HALVINGS { Ok(vec![0; 4 * number]) } else { self.picture.colours(first, size, halvings) }
    }

    /// The share of many places of the picture that have a height.
    pub fn heights_share(&self) -> f64 {
        let size = self.size().map(|side| side as f64);
        let share = |k: usize| (k as f64 + 0.5) / LOOKED_UP as f64;
        let places = (0..LOOKED_UP * LOOKED_UP).map(|k| [share(k % LOOKED_UP) * size[0], share(k / LOOKED_UP) * size[1]]);
        let number = (LOOKED_UP * LOOKED_UP) as f64;
        places.filter(|at| self.heights.at(self.georeference.ground(*at)).is_some()).count() as f64 / number
    }

    /// Whether the picture shows something at a position in px.
    pub fn shows(&self, at: [f64; 2]) -> bool {
        self.picture.shows(at)
    }
}

/// How many pixels a part has that is shown.
fn shown_pixels([width, height]: [usize; 2]) -> Result<usize, Error> {
    let number = width.saturating_mul(height);
    if number > MOST_SHOWN {
        let [megapixels, max_megapixels] = [width as f64 * height as f64, MOST_SHOWN as f64].map(|pixels| pixels / 1e6);
        return Err(Error::TooManyPixels { width: width as u64, height: height as u64, megapixels, max_megapixels });
    }
    Ok(number)
}

/// A picture of a TIFF: whole where it is small.
fn of_raster(
    raster: TiffRaster<Arc<dyn FileSource>>,
    file: &Arc<dyn FileSource>,
    no_data: Option<f64>,
    limits: &DecodeLimits,
) -> Result<Picture, Error> {
    let size = raster.size();
    let [width, height] = size.map(|side| side as u64);
    let pixels = width.saturating_mul(height);
    let most = if pixels > MOST_WHOLE { MOST_IN_PARTS } else { limits.max_pixels };
    if pixels > most {
        let [megapixels, max_megapixels] = [pixels, most].map(|pixels| pixels as f64 / 1e6);
        return Err(Error::TooManyPixels { width, height, megapixels, max_megapixels });
    }
    if pixels > MOST_WHOLE {
        return Ok(Picture::Parts(Arc::new(Parts::new(raster))));
    }
    let pixels = raster.read(0, [0, 0], size, Wanted::Grey)?;
    let grey = Bands::of(size, pixels.bands)?.into_first();
    if raster.bands(Wanted::Colours) == 1 {
        return Ok(Picture::whole(grey, &pixels.nothing));
    }
    let file = Arc::clone(file);
    let colours = move || {
        let raster = TiffRaster::open(Arc::clone(&file), no_data, MOST_CHUNK)?;
        let raster = raster.ok_or_else(|| unread(Document::Orthophoto, &io::ErrorKind::InvalidData.into()))?;
        Bands::of(size, raster.read(0, [0, 0], size, Wanted::Colours)?.bands)
    };
    Ok(Picture::coloured(grey, &pixels.nothing, colours))
}

/// A point of a reduced image as one of the image itself.
pub(super) fn enlarge(point: &mut ScalePoint, factor: f64) {
    (point.x, point.y, point.scale_px) = (factor * point.x, factor * point.y, factor * point.scale_px);
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
        let full = Orthophoto::new(full, Georeference::north_up([0.0, 0.0], 1.0), Heights::Level(0.0)).unwrap();
        assert!(full.picture.patch([0, 0], [40, 40], 0).unwrap().mask.is_none());
    }

    #[test]
    fn a_picture_without_a_place_is_refused() {
        let file = crate::write_png(GreyImage::from_fn(20, 20, |c, _| c as u8).unwrap().view(), None);
        let read = |world: Option<&str>| Orthophoto::read(&file, world, Heights::Level(0.0), &DecodeLimits::default());
        assert!(read(None).unwrap_err().to_string().contains("does not say where it lies"));
        // Rows that go north would show the ground mirrored.
        let told = read(Some("2 0 0 2 101 199")).unwrap_err().to_string();
        assert!(told.contains("A = 2, D = 0, B = 0, E = 2") && told.contains("allowed: rows that go south"), "{told}");
        assert_eq!(read(Some("2 0 0 -2 101 199")).unwrap().georeference, Georeference::north_up([100.0, 200.0], 2.0));
    }

    #[test]
    fn a_geotiff_with_the_identity_lies_where_its_world_file_says() {
        let grey = |value: u8| GreyImage::from_fn(20, 20, |_, _| value).unwrap();
        let identity = Georeference { origin: [0.0; 2], by_column: [1.0, 0.0], by_row: [0.0, 1.0] };
        let file = write_geotiff(&Rectified { bands: grey(9).into(), mask: grey(255), georeference: identity }, None).unwrap();
        let read = |world: Option<&str>| Orthophoto::read(&file, world, Heights::Level(0.0), &DecodeLimits::default());
        assert!(read(None).unwrap_err().to_string().contains("does not say where it lies"));
        assert_eq!(read(Some("2 0 0 -2 101 199")).unwrap().georeference, Georeference::north_up([100.0, 200.0], 2.0));
    }

    #[test]
    fn heights_of_another_system_are_refused_with_both_and_those_without_one_are_taken() {
        let at = Georeference::north_up([500_000.0, 5_000_000.0], 1.0);
        let grey = || GreyImage::from_fn(40, 40, |c, _| 100 + c as u8).unwrap();
        let picture = Rectified { bands: grey().into(), mask: GreyImage::from_fn(40, 40, |_, _| 255).unwrap(), georeference: at };
        let read = |epsg: Option<u16>, heights: Heights| {
            Orthophoto::read(&write_geotiff(&picture, epsg).unwrap(), None, heights, &DecodeLimits::default())
        };
        let model = HeightModel::new(40, 40, vec![7.0; 1600], at).unwrap();
        let of = |epsg: Option<u16>| Heights::Model(HeightModel::read(&write_heights(&model, epsg).unwrap(), None).unwrap());
        let mut orthophoto = read(Some(25_832), Heights::Level(0.0)).unwrap();
        // Another zone, and another datum; a code that is unknown here.
        for other in [25_833, 31_467, 32_632, 1234] {
            let told = orthophoto.set_heights(of(Some(other))).unwrap_err().to_string();
            assert!(told.contains(&format!("EPSG:{other}")) && told.contains("EPSG:25832"), "{told}");
            assert_eq!((orthophoto.heights.clone(), read(Some(25_832), of(Some(other))).is_err()), (Heights::Level(0.0), true));
        }
        // The same plane; with heights of its own (ETRS89 / UTM 32N + DHHN92); heights that say nothing, as an ESRI ASCII grid; an orthophoto that does not.
        let grid = "ncols 2\nnrows 2\nxllcorner 500000\nyllcorner 4999960\ncellsize 20\n1 2\n3 4\n";
        let grid = Heights::Model(HeightModel::read(grid.as_bytes(), None).unwrap());
        for heights in [of(Some(25_832)), of(Some(5555)), of(None), grid] {
            orthophoto.set_heights(heights.clone()).unwrap();
            assert_eq!(orthophoto.heights, heights);
        }
        assert!(read(None, of(Some(25_833))).is_ok());
        // In feet, as their file says: in m, the unit of the orthophoto.
        orthophoto.set_heights(of(Some(25_832))).unwrap();
        assert_eq!(orthophoto.heights.given_in(), None);
        let in_feet = |model: HeightModel| Heights::Model(model.said_in(0.3048));
        orthophoto.set_heights(in_feet(model.clone())).unwrap();
        assert_eq!(orthophoto.heights.given_in().as_deref(), Some("ft"));
        assert!(orthophoto.heights.range().iter().all(|height| (height - 7.0 * 0.3048).abs() < 1e-6), "{:?}", orthophoto.heights.range());
        // Elsewhere.
        let beside = HeightModel::new(40, 40, vec![7.0; 1600], Georeference::north_up([0.0, 0.0], 1.0)).unwrap();
        assert!(orthophoto.set_heights(Heights::Model(beside)).unwrap_err().to_string().contains("none under the orthophoto"));
    }
}
