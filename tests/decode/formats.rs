//! Decoded values of every format and pixel type.

use image::codecs::pnm::{PnmSubtype, SampleEncoding};
use image::{ExtendedColorType, ImageFormat};

use super::decode;
use super::jpeg_writer::Jpeg;
use super::samples::{HEIGHT, WIDTH, anymap, convert, noise, png, smooth_rgb, tiff};
use super::tiff_writer::{Tag, one_strip, write};

const PIXELS: usize = (WIDTH * HEIGHT) as usize;

/// Luma in the fixed-point arithmetic of OpenCV.
pub fn luma(rgb: &[u8]) -> u8 {
    let [r, g, b] = [rgb[0], rgb[1], rgb[2]].map(u32::from);
    ((r * 4899 + g * 9617 + b * 1868 + 8192) >> 14) as u8
}

fn luma_of(rgb: &[u8], channels: usize) -> Vec<u8> {
    rgb.chunks_exact(channels).map(luma).collect()
}

pub fn grey(file: &[u8]) -> Vec<u8> {
    decode(file).unwrap_or_else(|e| panic!("{e}")).grey.data().to_vec()
}

fn be16(samples: impl IntoIterator<Item = u16>) -> Vec<u8> {
    samples.into_iter().flat_map(u16::to_be_bytes).collect()
}

fn ne16(samples: impl IntoIterator<Item = u16>) -> Vec<u8> {
    samples.into_iter().flat_map(u16::to_ne_bytes).collect()
}

#[test]
fn lossless_colour_comes_out_as_its_luma() {
    let rgb = smooth_rgb();
    let expected = luma_of(&rgb, 3);
    let binary = PnmSubtype::Pixmap(SampleEncoding::Binary);
    let text = PnmSubtype::Pixmap(SampleEncoding::Ascii);
    for (name, file) in [
        ("PNG", png(&rgb, ExtendedColorType::Rgb8)),
        ("TIFF", tiff(&rgb, ExtendedColorType::Rgb8)),
        ("BMP", convert(&rgb, ImageFormat::Bmp)),
        ("WebP", convert(&rgb, ImageFormat::WebP)),
        ("PNM", anymap(&rgb, binary, ExtendedColorType::Rgb8)),
        ("PNM", anymap(&rgb, text, ExtendedColorType::Rgb8)),
    ] {
        let decoded = decode(&file).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!((decoded.format, decoded.bits_per_sample), (name, 8));
        assert_eq!((decoded.grey.width(), decoded.grey.height()), (WIDTH as usize, HEIGHT as usize), "{name}");
        assert_eq!(decoded.grey.data(), expected, "{name}");
        assert_eq!(decoded.camera, None, "{name}");
    }
}

#[test]
fn grey_and_alpha_come_out_as_stored() {
    let values = noise(3, PIXELS);
    let with_alpha: Vec<u8> = values.iter().zip(noise(4, PIXELS)).flat_map(|(&v, a)| [v, a]).collect();
    for file in [
        png(&values, ExtendedColorType::L8),
        tiff(&values, ExtendedColorType::L8),
        anymap(&values, PnmSubtype::Graymap(SampleEncoding::Binary), ExtendedColorType::L8),
        png(&with_alpha, ExtendedColorType::La8),
    ] {
        assert_eq!(grey(&file), values);
    }
    let rgba = noise(5, 4 * PIXELS);
    assert_eq!(grey(&png(&rgba, ExtendedColorType::Rgba8)), luma_of(&rgba, 4));
    assert_eq!(grey(&tiff(&rgba, ExtendedColorType::Rgba8)), luma_of(&rgba, 4));
}

#[test]
fn deep_samples_keep_their_contrast() {
    for depth in [8u32, 10, 12, 14, 16] {
        let white = (1u32 << depth) - 1;
        let mut samples: Vec<u16> = (0..PIXELS as u32).map(|i| (i * 7919 % (white + 1)) as u16).collect();
        samples[5] = white as u16;
        let expected: Vec<u8> = samples.iter().map(|&v| (f64::from(v) * 255.0 / f64::from(white)).round() as u8).collect();
        let native = ne16(samples.iter().copied());
        let little: Vec<u8> = samples.iter().flat_map(|v| v.to_le_bytes()).collect();
        for (name, file) in [
            ("PNG", png(&native, ExtendedColorType::L16)),
            ("TIFF", tiff(&native, ExtendedColorType::L16)),
            ("TIFF big-endian", write(true, &be16(samples.iter().copied()), one_strip(WIDTH, HEIGHT, 16, 1, 1, native.len()))),
            ("TIFF little-endian", write(false, &little, one_strip(WIDTH, HEIGHT, 16, 1, 1, native.len()))),
        ] {
            let decoded = decode(&file).unwrap_or_else(|e| panic!("{name}: {e}"));
            assert_eq!(decoded.bits_per_sample, 16, "{name}");
            assert_eq!(decoded.grey.data(), expected, "{name}, {depth} bits");
        }
    }
}

#[test]
fn an_8_bit_image_times_257_is_the_8_bit_image() {
    for top in [255, 90] {
        let rgb: Vec<u8> = noise(6, 3 * PIXELS).into_iter().map(|v| v % (top + (top < 255) as u8).max(1)).collect();
        let wide = ne16(rgb.iter().map(|&v| u16::from(v) * 257));
        assert_eq!(grey(&png(&wide, ExtendedColorType::Rgb16)), luma_of(&rgb, 3));
        assert_eq!(grey(&tiff(&wide, ExtendedColorType::Rgb16)), luma_of(&rgb, 3));
    }
}

#[test]
fn palettes_and_short_samples_are_resolved() {
    let mut file = Vec::new();
    let mut encoder = png_encoder(&mut file, 5, 2, png::ColorType::Indexed, png::BitDepth::Two);
    encoder.set_palette(vec![0, 0, 0, 255, 0, 0, 0, 255, 0, 9, 9, 200]);
    encoder.write_header().unwrap().write_image_data(&[0b00_01_10_11, 0b00_000000, 0b11_10_01_00, 0b01_000000]).unwrap();
    assert_eq!(grey(&file), [0, 76, 150, 31, 0, 31, 150, 76, 0, 76]);

    let mut file = Vec::new();
    let encoder = png_encoder(&mut file, 8, 1, png::ColorType::Grayscale, png::BitDepth::One);
    encoder.write_header().unwrap().write_image_data(&[0b1010_0110]).unwrap();
    assert_eq!(grey(&file), [255, 0, 255, 0, 0, 255, 255, 0]);

    let map: Vec<u16> = (0..3).flat_map(|c| (0..256).map(move |i| if c == 0 { i * 257 } else { (255 - i) * 257 })).collect();
    let indices = noise(8, 12);
    let mut tags = one_strip(4, 3, 8, 1, 3, 12);
    tags.push(Tag::Short(320, map));
    let expected: Vec<u8> = indices.iter().map(|&i| luma(&[i, 255 - i, 255 - i])).collect();
    assert_eq!(grey(&write(false, &indices, tags)), expected);

    assert_eq!(grey(b"P4\n10 2\n\xaa\x80\x55\x40"), [0, 255, 0, 255, 0, 255, 0, 255, 0, 255, 255, 0, 255, 0, 255, 0, 255, 0, 255, 0]);
    assert_eq!(grey(b"P1\n# bits\n3 1\n1 0 1\n"), [0, 255, 0]);
}

fn png_encoder(
    file: &mut Vec<u8>,
    width: u32,
    height: u32,
    colour: png::ColorType,
    depth: png::BitDepth,
) -> png::Encoder<'_, &mut Vec<u8>> {
    let mut encoder = png::Encoder::new(file, width, height);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    encoder
}

#[test]
fn tiff_planes_and_bands_and_strips() {
    let rgb = smooth_rgb();
    let plane = |c: usize| rgb.iter().skip(c).step_by(3).copied().collect::<Vec<u8>>();
    let expected = luma_of(&rgb, 3);

    let planes = [plane(0), plane(1), plane(2)].concat();
    let mut tags = one_strip(WIDTH, HEIGHT, 8, 3, 2, PIXELS);
    tags.retain(|tag| !matches!(tag, Tag::Long(273 | 279, _)));
    tags.push(Tag::Short(284, vec![2]));
    tags.push(Tag::Long(273, (0..3).map(|c| 8 + c * PIXELS as u32).collect()));
    tags.push(Tag::Long(279, vec![PIXELS as u32; 3]));
    assert_eq!(grey(&write(false, &planes, tags)), expected, "planes");

    let bands: Vec<u8> =
        rgb.chunks_exact(3).zip(noise(9, PIXELS)).flat_map(|(c, near_infrared)| [c[0], c[1], c[2], near_infrared]).collect();
    let mut tags = one_strip(WIDTH, HEIGHT, 8, 4, 2, bands.len());
    tags.push(Tag::Short(338, vec![0]));
    assert_eq!(grey(&write(true, &bands, tags)), expected, "a fourth band");

    let mut tags = one_strip(WIDTH, HEIGHT, 8, 4, 2, bands.len());
    tags.extend([Tag::Short(338, vec![0]), Tag::Short(317, vec![2])]);
    assert_eq!(decode(&write(true, &bands, tags)).unwrap_err().code(), "unsupported-image", "a fourth band with a predictor");

    let grey_bands: Vec<u8> = bands.chunks_exact(4).flat_map(|b| [b[1], b[3]]).collect();
    let mut tags = one_strip(WIDTH, HEIGHT, 8, 2, 1, grey_bands.len());
    tags.push(Tag::Short(338, vec![0]));
    assert_eq!(grey(&write(false, &grey_bands, tags)), plane(1), "two bands");

    let all_rows = |rows| {
        let mut tags = one_strip(WIDTH, HEIGHT, 8, 1, 1, PIXELS);
        tags.retain(|tag| !matches!(tag, Tag::Long(278, _)));
        tags.push(Tag::Long(278, vec![rows]));
        write(false, &plane(0), tags)
    };
    assert_eq!(grey(&all_rows(u32::MAX)), plane(0), "one strip of 'all rows'");

    let inverted = write(false, &plane(0), one_strip(WIDTH, HEIGHT, 8, 1, 0, PIXELS));
    assert_eq!(grey(&inverted), plane(0).iter().map(|v| 255 - v).collect::<Vec<u8>>(), "white is zero");
}

#[test]
fn tiff_tiles() {
    // 40 x 30 px in tiles of 16 x 16: the last column and row of tiles are padded.
    let value = |x: u32, y: u32| (x * 5 + y * 3) as u8;
    let tile = |tx: u32, ty: u32| (0..256).map(move |i| value(tx * 16 + i % 16, ty * 16 + i / 16));
    let data: Vec<u8> = (0..2).flat_map(|ty| (0..3).flat_map(move |tx| tile(tx, ty))).collect();
    let tags = vec![
        Tag::Long(256, vec![40]),
        Tag::Long(257, vec![30]),
        Tag::Short(258, vec![8]),
        Tag::Short(262, vec![1]),
        Tag::Short(322, vec![16]),
        Tag::Short(323, vec![16]),
        Tag::Long(324, (0..6).map(|i| 8 + 256 * i).collect()),
        Tag::Long(325, vec![256; 6]),
    ];
    let expected: Vec<u8> = (0..30).flat_map(|y| (0..40).map(move |x| value(x, y))).collect();
    assert_eq!(grey(&write(false, &data, tags)), expected);
}

#[test]
fn tiff_tiles_of_planes() {
    // 20 x 21 px in tiles of 16 x 16 of red, then of green, then of blue: the lowest are padded.
    let value = |x: u32, y: u32, band: u32| (x * 5 + y * 3 + 40 * band) as u8;
    let tile = |band: u32, k: u32| (0..256).map(move |i| value(k % 2 * 16 + i % 16, k / 2 * 16 + i / 16, band));
    let data: Vec<u8> = (0..3).flat_map(|band| (0..4).flat_map(move |k| tile(band, k))).collect();
    let tags = vec![
        Tag::Long(256, vec![20]),
        Tag::Long(257, vec![21]),
        Tag::Short(258, vec![8; 3]),
        Tag::Short(262, vec![2]),
        Tag::Short(277, vec![3]),
        Tag::Short(284, vec![2]),
        Tag::Short(322, vec![16]),
        Tag::Short(323, vec![16]),
        Tag::Long(324, (0..12).map(|i| 8 + 256 * i).collect()),
        Tag::Long(325, vec![256; 12]),
    ];
    let luma = |x: u32, y: u32| {
        let [r, g, b] = [0, 1, 2].map(|band| u32::from(value(x, y, band)));
        ((r * 4899 + g * 9617 + b * 1868 + (1 << 13)) >> 14) as u8
    };
    let expected: Vec<u8> = (0..21).flat_map(|y| (0..20).map(move |x| luma(x, y))).collect();
    assert_eq!(grey(&write(false, &data, tags)), expected);
}

#[test]
fn tiff_pixel_types_that_are_not_decoded_are_named() {
    let refusal = |change: Tag| {
        let tag = |tag: &Tag| match tag {
            Tag::Short(tag, _) | Tag::Long(tag, _) => *tag,
        };
        let mut tags = one_strip(4, 4, 8, 1, 1, 64);
        tags.retain(|old| tag(old) != tag(&change));
        tags.push(change);
        let error = decode(&write(false, &[0; 64], tags)).unwrap_err();
        assert_eq!(error.code(), "unsupported-image", "{error}");
        error.to_string()
    };
    assert!(refusal(Tag::Short(339, vec![3])).contains("floating-point"));
    assert!(refusal(Tag::Short(339, vec![2])).contains("signed"));
    assert!(refusal(Tag::Short(258, vec![32])).contains("32 bits"));
    assert!(refusal(Tag::Short(259, vec![50_000])).contains("compression 50000"));
    assert!(refusal(Tag::Short(262, vec![5])).contains("photometric interpretation 5"));
    assert!(refusal(Tag::Long(322, vec![1 << 30])).contains("tile side"));
}

#[test]
fn only_the_first_image_of_a_tiff_is_taken() {
    let mut file = std::io::Cursor::new(Vec::new());
    let mut encoder = tiff::encoder::TiffEncoder::new(&mut file).unwrap();
    encoder.write_image::<tiff::encoder::colortype::Gray8>(2, 2, &[1, 2, 3, 4]).unwrap();
    encoder.write_image::<tiff::encoder::colortype::Gray8>(3, 1, &[9, 9, 9]).unwrap();
    assert_eq!(grey(&file.into_inner()), [1, 2, 3, 4]);
}

#[test]
fn one_pixel_images() {
    for (name, file) in [
        ("PNM", b"P5 1 1 255\n\x4d".to_vec()),
        ("TIFF", write(false, &[0x4d], one_strip(1, 1, 8, 1, 1, 1))),
        ("PNG", {
            let mut file = Vec::new();
            let encoder = png_encoder(&mut file, 1, 1, png::ColorType::Grayscale, png::BitDepth::Eight);
            encoder.write_header().unwrap().write_image_data(&[0x4d]).unwrap();
            file
        }),
        ("JPEG", Jpeg::baseline(1, 1, &[(1, 2, 2), (2, 1, 1), (3, 1, 1)]).write(|_, _, _| 0x4d)),
        ("BMP", {
            let mut file = b"BM".to_vec();
            [58u32, 0, 54, 40, 1, 1, 1 | 24 << 16, 0, 4, 0, 0, 0, 0, 0x4d4d4d].iter().for_each(|n| file.extend(n.to_le_bytes()));
            file
        }),
    ] {
        let decoded = decode(&file).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!((decoded.format, decoded.grey.data()), (name, &[0x4d][..]));
    }
}

#[test]
fn unknown_formats_are_named() {
    for file in [b"GIF89a\x01\0\x01\0".as_slice(), b"8BPS\0\x01", b"hello", &[0, 0, 0, 0x20, b'f', b't', b'y', b'p']] {
        let error = decode(file).unwrap_err();
        assert_eq!(error.code(), "unsupported-image");
        assert!(error.to_string().contains("JPEG, PNG, TIFF, BMP, PNM"), "{error}");
    }
}
