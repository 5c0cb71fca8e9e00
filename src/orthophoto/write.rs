//! Pictures of the ground as GeoTIFF.

use super::georeference::Georeference;
use super::geotiff::{KEYS, MODEL_TYPE, NO_DATA, PIXEL_SCALE, PROJECTED, PROJECTED_SYSTEM, RASTER_TYPE, TIE_POINTS, TRANSFORMATION};
use super::heights::HeightModel;
use super::rectify::Rectified;
use crate::{Document, Error};
use std::io::Cursor;
use tiff::TiffResult;
use tiff::encoder::colortype::{ColorType, Gray8, Gray32Float};
use tiff::encoder::{Compression, DeflateLevel, TiffEncoder, TiffValue};
use tiff::tags::Tag;

const PIXEL_IS_AREA: u16 = 1;

/// Writes a picture of the ground as GeoTIFF, 8 bits, Deflate. Where its mask is 0, 0 stands for nothing; what it shows is 1 at least. `epsg`:
/// the code of its system, where that is known.
///
/// # Errors
/// [`Error::NotWritten`] where it would be longer than a TIFF can be.
///
/// # Source
/// OGC 19-008r4, GeoTIFF standard 1.1.
pub fn write_geotiff(rectified: &Rectified, epsg: Option<u16>) -> Result<Vec<u8>, Error> {
    let shown = rectified.grey.data().iter().zip(rectified.mask.data());
    let values: Vec<u8> = shown.map(|(grey, mask)| if *mask == 0 { 0 } else { (*grey).max(1) }).collect();
    encoded::<Gray8>([rectified.grey.width(), rectified.grey.height()], &values, &rectified.georeference, epsg, "0")
}

/// Writes a model of heights as GeoTIFF of floating-point numbers, Deflate; NaN stands for nothing.
///
/// # Errors
/// As [`write_geotiff`].
pub fn write_heights(model: &HeightModel, epsg: Option<u16>) -> Result<Vec<u8>, Error> {
    let (size, values) = model.raster();
    encoded::<Gray32Float>(size, &values, &model.georeference, epsg, "nan")
}

/// Writes numbers of a grid on the ground as GeoTIFF of floating-point numbers, Deflate; NaN stands for nothing. `epsg`: the code of its system.
///
/// # Errors
/// As [`write_geotiff`].
pub(crate) fn write_floats(size: [usize; 2], values: &[f32], georeference: &Georeference, epsg: Option<u16>) -> Result<Vec<u8>, Error> {
    encoded::<Gray32Float>(size, values, georeference, epsg, "nan")
}

fn encoded<C: ColorType>(
    size: [usize; 2],
    values: &[C::Inner],
    georeference: &Georeference,
    epsg: Option<u16>,
    no_data: &str,
) -> Result<Vec<u8>, Error>
where
    [C::Inner]: TiffValue,
{
    let mut file = Cursor::new(Vec::new());
    let written = write::<C>(&mut file, size, values, georeference, epsg, no_data);
    written.map(|()| file.into_inner()).map_err(|_| Error::NotWritten { document: Document::GeoTiff })
}

fn write<C: ColorType>(
    file: &mut Cursor<Vec<u8>>,
    [width, height]: [usize; 2],
    values: &[C::Inner],
    georeference: &Georeference,
    epsg: Option<u16>,
    no_data: &str,
) -> TiffResult<()>
where
    [C::Inner]: TiffValue,
{
    let mut encoder = TiffEncoder::new(file)?.with_compression(Compression::Deflate(DeflateLevel::Balanced));
    let mut image = encoder.new_image::<C>(width as u32, height as u32)?;
    let tags = image.encoder();
    let tag = |code: u64| Tag::from_u16_exhaustive(code as u16);
    let Georeference { origin: [x, y], by_column: [a, d], by_row: [b, e] } = *georeference;
    if b == 0.0 && d == 0.0 && a > 0.0 && e < 0.0 {
        tags.write_tag(tag(PIXEL_SCALE), &[a, -e, 0.0][..])?;
        tags.write_tag(tag(TIE_POINTS), &[0.0, 0.0, 0.0, x, y, 0.0][..])?;
    } else {
        tags.write_tag(tag(TRANSFORMATION), &[a, b, 0.0, x, d, e, 0.0, y, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0][..])?;
    }
    let mut keys: Vec<[u16; 4]> = vec![[MODEL_TYPE, 0, 1, PROJECTED], [RASTER_TYPE, 0, 1, PIXEL_IS_AREA]];
    keys.extend(epsg.map(|code| [PROJECTED_SYSTEM, 0, 1, code]));
    let head = [1, 1, 0, keys.len() as u16];
    tags.write_tag(tag(KEYS), &[&[head], keys.as_slice()].concat().concat()[..])?;
    tags.write_tag(tag(NO_DATA), no_data)?;
    image.write_data(values)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{DecodeLimits, GreyImage, Heights, Orthophoto};

    fn picture(georeference: Georeference) -> Rectified {
        let grey = GreyImage::from_fn(40, 30, |c, r| (5 * c + 2 * r + 1) as u8).unwrap();
        Rectified { mask: GreyImage::from_fn(40, 30, |_, _| 255).unwrap(), grey, georeference }
    }

    #[test]
    fn what_is_written_is_read_again() {
        let turned = Georeference { origin: [355_000.5, 5_800_000.25], by_column: [0.19, 0.06], by_row: [0.06, -0.19] };
        for georeference in [Georeference::north_up([355_000.5, 5_800_000.25], 0.2), turned] {
            let written = picture(georeference);
            let file = write_geotiff(&written, Some(25_833)).unwrap();
            let read = Orthophoto::read(&file, None, Heights::Level(3.0), &DecodeLimits::default()).unwrap();
            assert_eq!((read.georeference, read.epsg, read.grey().unwrap()), (georeference, Some(25_833), written.grey.clone()));
        }
    }

    #[test]
    fn heights_are_read_again_with_their_holes() {
        let values = vec![1.5, f32::NAN, -2.25, 1000.0, 5.0, 6.0];
        let model = HeightModel::new(3, 2, values, Georeference::north_up([10.0, 20.0], 5.0)).unwrap();
        let read = HeightModel::read(&write_heights(&model, None).unwrap(), None).unwrap();
        assert_eq!((read.georeference, read.at([12.5, 17.5]), read.at([17.5, 17.5])), (model.georeference, Some(1.5), None));
    }

    #[test]
    fn a_file_in_degrees_and_a_truncated_one_are_refused() {
        let mut file = write_geotiff(&picture(Georeference::north_up([11.0, 51.0], 1e-5)), None).unwrap();
        let keys = [MODEL_TYPE, 0, 1, PROJECTED].map(u16::to_le_bytes).concat();
        let at = file.windows(8).position(|window| window == keys).unwrap();
        file[at + 6] = 2;
        let read = |file: &[u8]| Orthophoto::read(file, None, Heights::Level(0.0), &DecodeLimits::default()).unwrap_err().to_string();
        assert!(read(&file).contains("degrees"), "{}", read(&file));
        assert!(!read(&file[..file.len() / 2]).is_empty());
    }
}
