//! Pictures of the ground as GeoTIFF.

use super::heights::HeightModel;
use super::rectify::Rectified;
use super::samples::Samples;
use super::tiled_file::TiledFile;
use crate::Georeference;
use crate::{Error, GreyImage};
use std::io::Cursor;

/// Writes a picture of the ground as GeoTIFF, grey or in colours of 8 bits, in tiles, Deflate. Where its mask is 0, 0 stands for nothing; what it shows
/// is 1 at least. `epsg`: the code of its system, where that is known.
///
/// # Errors
/// None that memory does not make: files grow in memory alone.
///
/// # Source
/// OGC 19-008r4, GeoTIFF standard 1.1.
pub fn write_geotiff(rectified: &Rectified, epsg: Option<u16>) -> Result<Vec<u8>, Error> {
    let Rectified { bands, mask, georeference } = rectified;
    let bands: Vec<&[u8]> = bands.images().iter().map(GreyImage::data).collect();
    let of_pixel = |k: usize, bytes: &mut [u8]| {
        if mask.data()[k] != 0 {
            bytes.iter_mut().zip(&bands).for_each(|(byte, band)| *byte = band[k].max(1));
        }
    };
    written([mask.width(), mask.height()], Samples::Bytes(bands.len()), georeference, (epsg, None), of_pixel)
}

/// Writes a model of heights as GeoTIFF of floating-point numbers, in tiles, Deflate; NaN stands for nothing.
///
/// # Errors
/// As [`write_geotiff`]; [`Error::InvalidInput`] for a model of more than 100 million heights.
pub fn write_heights(model: &HeightModel, epsg: Option<u16>) -> Result<Vec<u8>, Error> {
    write_floats(model.size(), &model.all()?, &model.georeference, epsg, None)
}

/// Writes numbers of a grid on the ground as GeoTIFF of floating-point numbers, in tiles, Deflate; NaN stands for nothing. `epsg`: the code of its system; `unit_m`: its unit.
///
/// # Errors
/// As [`write_geotiff`].
pub(crate) fn write_floats(
    size: [usize; 2],
    values: &[f32],
    georeference: &Georeference,
    epsg: Option<u16>,
    unit_m: Option<f64>,
) -> Result<Vec<u8>, Error> {
    written(size, Samples::Float, georeference, (epsg, unit_m), |k, bytes| bytes.copy_from_slice(&values[k].to_le_bytes()))
}

/// `of_pixel` puts the samples of a pixel, counted row by row, into bytes that are 0.
fn written(
    size: [usize; 2],
    samples: Samples,
    georeference: &Georeference,
    (epsg, unit_m): (Option<u16>, Option<f64>),
    of_pixel: impl Fn(usize, &mut [u8]),
) -> Result<Vec<u8>, Error> {
    let mut out = Cursor::new(Vec::new());
    let mut file = TiledFile::begin(size, samples, *georeference, epsg, unit_m, &mut out)?;
    let (side, bytes) = (file.side(), samples.bytes());
    for index in 0..file.number() {
        let [left, top] = file.corner(index);
        let mut values = vec![0; side * side * bytes];
        for (k, pixel) in values.chunks_exact_mut(bytes).enumerate() {
            let [column, row] = [left + k % side, top + k / side];
            if column < size[0] && row < size[1] {
                of_pixel(row * size[0] + column, pixel);
            }
        }
        file.write(index, values, &mut out)?;
    }
    file.finish(&mut out)?;
    Ok(out.into_inner())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::georeferenced::{MODEL_TYPE, Numbers, PROJECTED};
    use crate::{Bands, DecodeLimits, Heights, Orthophoto, decode_bands};

    fn picture(georeference: Georeference) -> Rectified {
        let grey = GreyImage::from_fn(40, 30, |c, r| (5 * c + 2 * r + 1) as u8).unwrap();
        Rectified { mask: GreyImage::from_fn(40, 30, |_, _| 255).unwrap(), bands: grey.into(), georeference }
    }

    #[test]
    fn what_is_written_is_read_again() {
        let turned = Georeference { origin: [355_000.5, 5_800_000.25], by_column: [0.19, 0.06], by_row: [0.06, -0.19] };
        for georeference in [Georeference::north_up([355_000.5, 5_800_000.25], 0.2), turned] {
            let written = picture(georeference);
            let file = write_geotiff(&written, Some(25_833)).unwrap();
            let read = Orthophoto::read(&file, None, Heights::Level(3.0), &DecodeLimits::default()).unwrap();
            assert_eq!(
                (read.georeference, read.epsg, read.grey().unwrap()),
                (georeference, Some(25_833), written.bands.images()[0].clone())
            );
        }
    }

    #[test]
    fn colours_are_read_again_and_nothing_is_all_of_them() {
        let georeference = Georeference::north_up([355_000.5, 5_800_000.25], 0.2);
        // More than one tile; a third of it shows nothing, and black is shown.
        let [width, height] = [300, 1500];
        let band = |of: fn(usize, usize) -> u8| GreyImage::from_fn(width, height, of).unwrap();
        let colours = [band(|c, r| (c + r) as u8), band(|c, _| (c / 3) as u8), band(|c, r| if c == r { 0 } else { 200 })];
        let mask = GreyImage::from_fn(width, height, |c, _| if c < 100 { 0 } else { 255 }).unwrap();
        let picture = Rectified { bands: Bands::colours(colours.clone()).unwrap(), mask, georeference };
        let file = write_geotiff(&picture, Some(25_833)).unwrap();
        let read = decode_bands(&file, &DecodeLimits::default()).unwrap();
        for (own, band) in read.images().iter().zip(&colours) {
            for (c, r) in [(0, 0), (99, 700), (100, 100), (150, 150), (299, 1499), (120, 3)] {
                assert_eq!(own.view().at(c, r), if c < 100 { 0 } else { band.view().at(c, r).max(1) }, "{c} {r}");
            }
        }
        let orthophoto = Orthophoto::read(&file, None, Heights::Level(3.0), &DecodeLimits::default()).unwrap();
        assert!(!orthophoto.shows([50.5, 50.5]) && orthophoto.shows([200.5, 200.5]));
        assert_eq!(orthophoto.colours([149, 3], [2, 1], 0).unwrap(), [152, 49, 200, 255, 153, 50, 200, 255]);
        assert_eq!(orthophoto.colours([20, 20], [1, 1], 1).unwrap(), [0; 4]);
    }

    #[test]
    fn heights_are_read_again_with_their_holes() {
        let values = vec![1.5, f32::NAN, -2.25, 1000.0, 5.0, 6.0];
        let model = HeightModel::new(3, 2, values, Georeference::north_up([10.0, 20.0], 5.0)).unwrap();
        let read = HeightModel::read(&write_heights(&model, None).unwrap(), None).unwrap();
        assert_eq!((read.georeference, read.at([12.5, 17.5]), read.at([17.5, 17.5])), (model.georeference, Some(1.5), None));
    }

    #[test]
    fn numbers_of_tiles_are_read_one_by_one_to_the_edges() {
        let [width, height] = [600, 530];
        let values: Vec<f32> = (0..width * height).map(|k| if k % 101 == 0 { f32::NAN } else { k as f32 }).collect();
        let file = write_floats([width, height], &values, &Georeference::north_up([10.0, 20.0], 5.0), None, None).unwrap();
        let numbers = Numbers::open(&file).unwrap();
        for (column, row) in [(0, 0), (599, 0), (255, 255), (256, 256), (511, 529), (512, 529), (599, 529), (3, 528)] {
            let value = numbers.at(column, row).unwrap();
            let own = values[row * width + column];
            assert!(value == own || value.is_nan() && own.is_nan(), "{column} {row}: {value} for {own}");
        }
        let all = numbers.all().unwrap();
        assert!(all.iter().zip(&values).all(|(value, own)| value == own || value.is_nan() && own.is_nan()));
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
