//! Images as PNG files.

use super::{Bands, GreyView};
use crate::camera::ExifImage;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder};

/// Writes grey values as a PNG file of 8 bits a pixel; `exif` tells of its camera and place.
///
/// # Panics
/// For a side of 2³² px or more, of which no image fits into memory.
pub fn write_png(image: GreyView<'_>, exif: Option<&ExifImage>) -> Vec<u8> {
    written(image.data(), [image.width(), image.height()], ExtendedColorType::L8, exif)
}

/// Writes grey values or colours as a PNG file of 8 bits a band and pixel; `exif` tells of its camera and place.
///
/// # Panics
/// As [`write_png`].
pub fn write_bands(bands: &Bands, exif: Option<&ExifImage>) -> Vec<u8> {
    let [red, green, blue] = bands.images() else { return write_png(bands.images()[0].view(), exif) };
    let colours: Vec<u8> =
        red.data().iter().zip(green.data()).zip(blue.data()).flat_map(|((red, green), blue)| [*red, *green, *blue]).collect();
    written(&colours, [red.width(), red.height()], ExtendedColorType::Rgb8, exif)
}

fn written(samples: &[u8], [width, height]: [usize; 2], colour: ExtendedColorType, exif: Option<&ExifImage>) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = PngEncoder::new(&mut file);
    let told = exif.map_or(Ok(()), |exif| encoder.set_exif_metadata(exif.block()));
    let written = encoder.write_image(samples, width as u32, height as u32, colour);
    told.expect("PNG holds EXIF");
    written.expect("memory takes what is written, and sides are 1 px or more");
    file
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::{ExifCamera, ExifPosition};
    use crate::{DecodeLimits, GreyImage, decode};

    #[test]
    fn a_written_file_is_read_as_it_was() {
        let image = GreyImage::from_fn(37, 21, |col, row| (col * 7 + row * row * 3) as u8).unwrap();
        let decoded = decode(&write_png(image.view(), None), &DecodeLimits::default()).unwrap();
        assert_eq!((decoded.grey, decoded.format, decoded.camera), (image.clone(), "PNG", None));
        let [make, model] = ["Tiepoint", "Simulated 3"].map(|text| Some(text.to_string()));
        let camera =
            ExifCamera { make: make.clone(), model: model.clone(), focal_mm: 85.25, pixel_mm: Some(0.008), ..ExifCamera::default() };
        for (longitude_deg, latitude_deg, height_m) in
            [(8.123_456_789, 50.987_654_321, Some(812.345_67)), (-70.5, -33.25, Some(-12.5)), (0.25, 1.0, None)]
        {
            let position = ExifPosition { longitude_deg, latitude_deg, height_m, error_m: None };
            for camera in [Some(camera.clone()), None] {
                let exif = ExifImage {
                    make: make.clone(),
                    model: model.clone(),
                    camera,
                    orientation: Some(1),
                    position: Some(position),
                    ..ExifImage::default()
                };
                let read = ExifImage::read(&write_png(image.view(), Some(&exif)), 37, 21);
                let own = read.position.unwrap();
                assert!((own.longitude_deg - longitude_deg).abs() < 1e-9 && (own.latitude_deg - latitude_deg).abs() < 1e-9, "{own:?}");
                assert_eq!(own.height_m, height_m);
                assert_eq!(ExifImage { position: Some(position), ..read }, exif);
            }
        }
        let nothing = ExifImage::default();
        assert_eq!(ExifImage::read(&write_png(image.view(), Some(&nothing)), 37, 21), ExifImage { orientation: Some(1), ..nothing });
    }
}
