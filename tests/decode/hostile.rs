//! Damaged files: an image or a typed error, never a panic, a hang or a part of an image.

use std::panic::catch_unwind;
use std::time::{Duration, Instant};

use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use tiepoint::{Decoded, Error, read_header};

use crate::samples::{files, noise};
use crate::{decode, jpeg_writer, tiff_writer};

/// Decodes what may be anything; fails where that panics, takes long, or gives an error without a message.
fn decode_any(file: &[u8], what: &str) -> Result<Decoded, Error> {
    let start = Instant::now();
    let Ok((header, result)) = catch_unwind(|| (read_header(file), decode(file))) else { panic!("{what}: a panic") };
    assert!(start.elapsed() < Duration::from_secs(20), "{what}: {:?}", start.elapsed());
    match &result {
        Ok(decoded) => {
            let header = header.expect("an image that is decoded has a header");
            assert_eq!((header.width, header.height), (decoded.grey.width() as u64, decoded.grey.height() as u64), "{what}");
            assert_eq!(header.format, decoded.format, "{what}");
        }
        Err(error) => {
            assert!(
                matches!(error.code(), "unreadable-image" | "unsupported-image" | "too-many-pixels" | "too-much-memory"),
                "{what}: {error}"
            );
            assert!(!error.to_string().is_empty() && !error.is_usage(), "{what}: {error}");
        }
    }
    result
}

#[test]
fn truncated_files_are_refused_or_whole() {
    for (name, file) in files() {
        let whole = decode(&file).unwrap_or_else(|e| panic!("{name}: {e}"));
        let step = (file.len() / 400).max(1);
        // A number in text that lost its last digits is a number still.
        let end = if name.contains("text") { file.trim_ascii_end().len() - 3 } else { file.len() };
        let mut refused = 0;
        for length in (0..end).filter(|n| n % step == 0 || *n < 64 || end - n < 64) {
            match decode_any(&file[..length], &format!("{name} cut to {length} of {} bytes", file.len())) {
                // What is missing carried no pixels: padding, an end mark, a checksum.
                Ok(part) => assert_eq!(part.grey, whole.grey, "{name} cut to {length} of {} bytes", file.len()),
                Err(_) => refused += 1,
            }
        }
        assert!(refused > 0, "{name}: no cut was noticed");
    }
}

#[test]
fn truncation_is_named() {
    for (name, file) in files() {
        let error = decode(&file[..file.len() * 2 / 3]).expect_err(name);
        assert_eq!(error.code(), "unreadable-image", "{name}: {error}");
    }
    let (_, jpeg) = files().swap_remove(0);
    assert!(decode(&jpeg[..jpeg.len() - 2]).unwrap_err().to_string().contains("truncated"));
}

#[test]
fn flipped_bits_give_an_image_or_a_typed_error() {
    let mut random = Pcg32::new(7, 0);
    for (name, file) in files() {
        for trial in 0..2_000 {
            let mut damaged = file.clone();
            for _ in 0..=trial % 4 {
                // Half of the flips hit the headers.
                let range = if random.next_u32().is_multiple_of(2) { file.len().min(200) } else { file.len() };
                let at = random.next_u32() as usize % range;
                damaged[at] ^= 1 << (random.next_u32() % 8);
            }
            _ = decode_any(&damaged, &format!("{name}, trial {trial}"));
        }
    }
}

#[test]
fn extreme_bytes_give_an_image_or_a_typed_error() {
    for (name, file) in files() {
        for at in 0..file.len().min(320) {
            for value in [0x00, 0x01, 0x7f, 0x80, 0xff] {
                let mut damaged = file.clone();
                damaged[at] = value;
                _ = decode_any(&damaged, &format!("{name}, byte {at} = {value}"));
            }
        }
    }
}

#[test]
fn random_bytes_are_refused() {
    let signatures: [&[u8]; 9] = [
        b"",
        b"\xff\xd8\xff",
        b"\x89PNG\r\n\x1a\n",
        b"II*\0\x08\0\0\0",
        b"MM\0*\0\0\0\x08",
        b"BM",
        b"P6\n",
        b"RIFF\0\0\0\0WEBPVP8L",
        b"RIFF\0\0\0\0WEBPVP8X",
    ];
    for (i, signature) in signatures.iter().enumerate() {
        for seed in 0..60 {
            let file = [signature, noise(seed, 1 + 37 * seed as usize).as_slice()].concat();
            assert!(decode_any(&file, &format!("signature {i}, seed {seed}")).is_err());
        }
    }
}

#[test]
fn scan_data_that_end_early_are_noticed() {
    // The file is complete up to its end mark, but the scan lacks its last rows.
    let components = [(1, 2, 2), (2, 1, 1), (3, 1, 1)];
    let jpeg = |height, restart_interval| {
        let jpeg = jpeg_writer::Jpeg { restart_interval, ..jpeg_writer::Jpeg::baseline(64, height, &components) };
        jpeg.write(|c, x, y| (50 * c + 9 * x + 5 * y) as u8)
    };
    for restart_interval in [0, 2] {
        let mut short = jpeg(32, restart_interval);
        let tall = jpeg(64, restart_interval);
        let frame = tall.windows(2).position(|w| w == [0xff, 0xc0]).unwrap();
        short[frame + 4..frame + 9].copy_from_slice(&tall[frame + 4..frame + 9]);
        let error = decode(&short).expect_err("half an image");
        assert_eq!(error.code(), "unreadable-image", "{error}");
    }
}

#[test]
fn sides_of_zero_are_refused() {
    let png = |w: u32, h: u32| [b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR".as_slice(), &w.to_be_bytes(), &h.to_be_bytes(), &[8, 0, 0, 0, 0]].concat();
    let bmp = |w: u32, h: u32| {
        [b"BM".as_slice(), &[0; 12], &40u32.to_le_bytes(), &w.to_le_bytes(), &h.to_le_bytes(), &[1, 0, 24, 0], &[0; 24]].concat()
    };
    let tiff = |w, h| tiff_writer::write(false, &[0; 8], tiff_writer::one_strip(w, h, 8, 1, 1, 8));
    let pnm = |w: u32, h: u32| format!("P5\n{w} {h}\n255\n").into_bytes();
    let jpeg = |w: u32, h: u32| {
        let jpeg = jpeg_writer::Jpeg::baseline(8, 8, &[(1, 1, 1)]);
        let mut file = jpeg.write(|_, _, _| 1);
        let frame = file.windows(2).position(|pair| pair == [0xff, 0xc0]).unwrap();
        file[frame + 5..frame + 9].copy_from_slice(&[0, h as u8, 0, w as u8]);
        file
    };
    for (w, h) in [(0, 5), (5, 0), (0, 0)] {
        for file in [png(w, h), bmp(w, h), tiff(w, h), pnm(w, h), jpeg(w, h)] {
            let error = decode_any(&file, "a side of zero").expect_err("a side of zero");
            assert!(error.to_string().contains(&format!("{w} x {h} px")), "{error}");
        }
    }
    assert!(decode_any(b"", "an empty file").unwrap_err().to_string().contains("empty"));
}
