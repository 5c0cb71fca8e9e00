//! Small valid files of every format.

use std::io::Cursor;

use image::codecs::{jpeg::JpegEncoder, png::PngEncoder, pnm, tiff::TiffEncoder};
use image::{DynamicImage, ExtendedColorType, ImageEncoder, ImageFormat};
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

use super::jpeg_writer::Jpeg;

pub const WIDTH: u32 = 37;
pub const HEIGHT: u32 = 23;

/// Seeded bytes that a decoder cannot guess.
pub fn noise(seed: u64, length: usize) -> Vec<u8> {
    let mut random = Pcg32::new(seed, 0);
    (0..length).map(|_| (random.next_u32() >> 24) as u8).collect()
}

/// Seeded colours that vary smoothly, so that lossy formats keep them nearly.
pub fn smooth_rgb() -> Vec<u8> {
    let ramp = |x: u32, y: u32, k: u32| (40 + (x * (3 + k) + y * (5 - k)) % 180) as u8;
    (0..HEIGHT).flat_map(|y| (0..WIDTH).flat_map(move |x| [ramp(x, y, 0), ramp(x, y, 1), ramp(x, y, 2)])).collect()
}

/// Name and bytes of valid files: every format, and the variants that take different ways through the decoders.
pub fn files() -> Vec<(&'static str, Vec<u8>)> {
    let rgb = smooth_rgb();
    let pixels = (WIDTH * HEIGHT) as usize;
    let grey16: Vec<u8> = noise(1, 2 * pixels);
    let mut files = vec![
        ("jpeg baseline colour", jpeg(&rgb, ExtendedColorType::Rgb8)),
        ("jpeg baseline grey", jpeg(&rgb[..pixels], ExtendedColorType::L8)),
        ("png rgb", png(&rgb, ExtendedColorType::Rgb8)),
        ("png grey 16", png(&grey16, ExtendedColorType::L16)),
        ("webp lossless", convert(&rgb, ImageFormat::WebP)),
        ("webp lossy", include_bytes!("lossy.webp").to_vec()),
        ("bmp 24", convert(&rgb, ImageFormat::Bmp)),
        ("bmp run-length", run_length_bmp()),
        ("tiff rgb", tiff(&rgb, ExtendedColorType::Rgb8)),
        ("tiff grey 16", tiff(&grey16, ExtendedColorType::L16)),
        ("pgm", anymap(&rgb[..pixels], pnm::PnmSubtype::Graymap(pnm::SampleEncoding::Binary), ExtendedColorType::L8)),
        ("ppm text", anymap(&rgb, pnm::PnmSubtype::Pixmap(pnm::SampleEncoding::Ascii), ExtendedColorType::Rgb8)),
        ("pam", anymap(&rgb, pnm::PnmSubtype::ArbitraryMap, ExtendedColorType::Rgb8)),
    ];
    for (name, progressive, interleaved, restart_interval) in [
        ("jpeg progressive", true, true, 0),
        ("jpeg progressive, scans apart, restarts", true, false, 3),
        ("jpeg scans apart", false, false, 0),
        ("jpeg 4:2:0 with restarts", false, true, 2),
    ] {
        let components = &[(1, 2, 2), (2, 1, 1), (3, 1, 1)];
        let jpeg = Jpeg { progressive, interleaved, restart_interval, ..Jpeg::baseline(WIDTH as u16, HEIGHT as u16, components) };
        files.push((name, jpeg.write(|c, x, y| (60 + 31 * c + 7 * x + 13 * y) as u8)));
    }
    files
}

fn jpeg(data: &[u8], colour: ExtendedColorType) -> Vec<u8> {
    let mut file = Vec::new();
    JpegEncoder::new_with_quality(&mut file, 95).encode(data, WIDTH, HEIGHT, colour).unwrap();
    file
}

pub fn png(data: &[u8], colour: ExtendedColorType) -> Vec<u8> {
    let mut file = Vec::new();
    PngEncoder::new(&mut file).write_image(data, WIDTH, HEIGHT, colour).unwrap();
    file
}

pub fn tiff(data: &[u8], colour: ExtendedColorType) -> Vec<u8> {
    let mut file = Cursor::new(Vec::new());
    TiffEncoder::new(&mut file).write_image(data, WIDTH, HEIGHT, colour).unwrap();
    file.into_inner()
}

pub fn anymap(data: &[u8], subtype: pnm::PnmSubtype, colour: ExtendedColorType) -> Vec<u8> {
    let mut file = Vec::new();
    pnm::PnmEncoder::new(&mut file).with_subtype(subtype).write_image(data, WIDTH, HEIGHT, colour).unwrap();
    file
}

pub fn convert(rgb: &[u8], format: ImageFormat) -> Vec<u8> {
    let image = image::RgbImage::from_raw(WIDTH, HEIGHT, rgb.to_vec()).unwrap();
    let mut file = Cursor::new(Vec::new());
    DynamicImage::ImageRgb8(image).write_to(&mut file, format).unwrap();
    file.into_inner()
}

/// A BMP of 8 x 4 px in runs of one palette index a row.
fn run_length_bmp() -> Vec<u8> {
    let rows: Vec<u8> = (0..4u8).flat_map(|row| [5, row, 3, row + 1, 0, 0]).chain([0, 1]).collect();
    let mut file = b"BM".to_vec();
    let offset = 14 + 40 + 4 * 256;
    for number in [offset + rows.len() as u32, 0, offset, 40, 8, 4, 1 | 8 << 16, 1, rows.len() as u32, 2835, 2835, 0, 0] {
        file.extend(number.to_le_bytes());
    }
    file.extend((0..256u32).flat_map(|i| (i * 0x01_01_01).to_le_bytes()));
    file.extend(rows);
    file
}
