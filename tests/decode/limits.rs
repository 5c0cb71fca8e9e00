//! Limits: what a header declares is refused before anything is decoded.

use std::time::{Duration, Instant};

use tiepoint::{DecodeLimits, Error, read_header};

use super::headers::headers;
use super::{decode, samples};

#[test]
fn more_pixels_than_allowed_are_refused_from_the_header_at_once() {
    for (width, height) in [(60_000, 60_000), (16_000, 16_000)] {
        for (format, file) in headers(width, height) {
            let header = read_header(&file).unwrap_or_else(|e| panic!("{format}: {e}"));
            assert_eq!((header.format, header.width, header.height), (format, width.into(), height.into()));
            let start = Instant::now();
            let error = decode(&file).expect_err(format);
            assert!(start.elapsed() < Duration::from_millis(100), "{format}: {:?}", start.elapsed());
            let expected = matches!(error, Error::TooManyPixels { width: w, height: h, .. } if (w, h) == (width.into(), height.into()));
            assert!(expected, "{format}: {error}");
            assert!(error.to_string().contains("up to 250.0 MP"), "{error}");
        }
    }
}

#[test]
fn the_largest_sides_do_not_overflow() {
    let number = u64::MAX;
    let pgm = format!("P5 {number} {number} 255\n");
    assert!(matches!(decode(pgm.as_bytes()), Err(Error::TooManyPixels { .. })));
    for (format, file) in headers(0x7fff_ffff, 0x7fff_ffff) {
        if !matches!(format, "JPEG" | "WebP") {
            assert!(matches!(decode(&file), Err(Error::TooManyPixels { .. })), "{format}");
        }
    }
}

#[test]
fn more_memory_than_allowed_is_refused_from_the_header_at_once() {
    let limits = DecodeLimits { max_memory_bytes: 64 << 20, ..DecodeLimits::default() };
    for (format, file) in headers(9_000, 9_000) {
        let start = Instant::now();
        let error = tiepoint::decode(&file, &limits).expect_err(format);
        assert!(start.elapsed() < Duration::from_millis(100), "{format}: {:?}", start.elapsed());
        assert!(matches!(error, Error::TooMuchMemory { width: 9_000, height: 9_000, max_mb: 64, needed_mb: 150.. }), "{format}: {error}");
    }
}

#[test]
fn limits_are_the_callers() {
    let (_, file) = samples::files().swap_remove(0);
    let pixels = u64::from(samples::WIDTH * samples::HEIGHT);
    let with = |max_pixels| tiepoint::decode(&file, &DecodeLimits { max_pixels, ..DecodeLimits::default() });
    assert!(with(pixels).is_ok());
    assert!(matches!(with(pixels - 1), Err(Error::TooManyPixels { .. })));
}

#[test]
fn a_header_within_the_limits_but_without_image_data_is_refused() {
    for (format, file) in headers(3_000, 2_000) {
        let error = decode(&file).expect_err(format);
        assert_eq!(error.code(), "unreadable-image", "{format}: {error}");
    }
}

#[test]
fn a_frame_larger_than_its_canvas_is_refused() {
    let lossy = include_bytes!("lossy.webp");
    let canvas = |side: u8| [b"RIFF\xf0\0\0\0WEBPVP8X\x0a\0\0\0\0\0\0\0".as_slice(), &[side, 0, 0, side, 0, 0], &lossy[12..]].concat();
    assert_eq!(decode(&canvas(9)).unwrap_err().code(), "unreadable-image");
    let animated = [b"RIFF\xf0\0\0\0WEBPVP8X\x0a\0\0\0\x02\0\0\0".as_slice(), &[36, 0, 0, 22, 0, 0], &lossy[12..]].concat();
    assert!(decode(&animated).unwrap_err().to_string().contains("animated"));
}
