//! Damaged files: an image or a typed error, never a panic, a hang or a part of an image.

use std::panic::catch_unwind;
use std::time::{Duration, Instant};

use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use tiepoint::{Decoded, Error, read_header};

use super::samples::{files, noise};
use super::{decode, jpeg_writer, tiff_writer};

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

/// Start and end of the entropy-coded data of each scan.
fn scans(jpeg: &[u8]) -> Vec<(usize, usize)> {
    let marker = |from: usize, wanted: fn(u8) -> bool| (from..jpeg.len() - 1).find(|&at| jpeg[at] == 0xff && wanted(jpeg[at + 1]));
    let mut scans = Vec::new();
    let mut at = 0;
    while let Some(scan) = marker(at, |code| code == 0xda) {
        let start = scan + 2 + usize::from(u16::from_be_bytes([jpeg[scan + 2], jpeg[scan + 3]]));
        at = marker(start, |code| !matches!(code, 0 | 0xd0..=0xd7 | 0xff)).unwrap();
        scans.push((start, at));
    }
    scans
}

#[test]
fn a_progressive_scan_cut_in_the_middle_does_not_decode_as_good() {
    let coarse = jpeg_writer::Jpeg { progressive: true, ..jpeg_writer::Jpeg::baseline(160, 120, &[(1, 2, 2), (2, 1, 1), (3, 1, 1)]) };
    let means = |restart_interval, interleaved| {
        let jpeg = jpeg_writer::Jpeg { restart_interval, interleaved, ..coarse };
        jpeg.write(|c, x, y| (60 + 31 * c + 7 * x + 13 * y) as u8)
    };
    let fine = include_bytes!("progressive.jpg").to_vec();
    assert_eq!(scans(&fine).len(), 10, "means, two bands of luma, chroma, and the refinements of each");
    for (name, file) in [("ten scans", fine), ("one scan", means(0, true)), ("scans apart", means(0, false)), ("restarts", means(7, true))]
    {
        let whole = decode(&file).unwrap();
        let mut refused = 0;
        for (scan, (start, end)) in scans(&file).into_iter().enumerate() {
            for eighth in 0..8 {
                let cut = start + (end - start) * eighth / 8;
                let mut damaged = [&file[..cut], &file[end..]].concat();
                // A cut never leaves half of a stuffed byte.
                if damaged[cut - 1] == 0xff {
                    damaged.remove(cut - 1);
                }
                match decode_any(&damaged, &format!("{name}, scan {scan} cut at {eighth} eighths")) {
                    Ok(part) => assert_eq!(part.grey, whole.grey, "{name}, scan {scan} of {} bytes cut at {eighth} eighths", end - start),
                    Err(_) => refused += 1,
                }
            }
        }
        assert!(refused >= 8, "{name}: {refused} cuts were noticed");
    }
}

#[test]
fn thousands_of_scans_and_tables_cost_little() {
    let jpeg = jpeg_writer::Jpeg { progressive: true, ..jpeg_writer::Jpeg::baseline(4_000, 4_000, &[(1, 1, 1)]) };
    let file = jpeg.write(|_, x, y| (x + y) as u8);
    let (start, end) = scans(&file)[0];
    let table = file.windows(2).position(|pair| pair == [0xff, 0xc4]).unwrap();
    let header = file.windows(2).position(|pair| pair == [0xff, 0xda]).unwrap();
    // Bands that end at once, for all blocks in runs of 32,767.
    let band = [&[0xff, 0xda, 0, 8, 1, 1, 0, 1, 63, 0][..], &[0x55; 64]].concat();
    let scans = [&file[..end], &band.repeat(5_000), &[0xff, 0xd9]].concat();
    let tables = [&file[..table], &file[table..header].repeat(200_000), &file[header..]].concat();
    for (name, file) in [("scans", &scans), ("tables", &tables)] {
        let begun = Instant::now();
        _ = decode_any(file, name);
        assert!(begun.elapsed() < Duration::from_secs(3), "{name}: {:?}", begun.elapsed());
    }
    assert!(start < end && decode(&scans).unwrap_err().to_string().contains("64 scans"));
}

/// A big TIFF of 16 x 16 px with these entries after those of a grey image in one strip: tag, type, count, value.
fn big_tiff(entries: &[[u64; 4]]) -> Vec<u8> {
    let image = [
        [256, 4, 1, 16],
        [257, 4, 1, 16],
        [258, 3, 1, 8],
        [262, 3, 1, 1],
        [273, 4, 1, 16],
        [277, 3, 1, 1],
        [278, 4, 1, 16],
        [279, 4, 1, 256],
    ];
    let mut file = b"II+\0\x08\0\0\0".to_vec();
    file.extend((16 + 256u64).to_le_bytes());
    file.extend([7; 256]);
    file.extend(((image.len() + entries.len()) as u64).to_le_bytes());
    for [tag, kind, count, value] in image.iter().chain(entries) {
        file.extend((*tag as u16).to_le_bytes());
        file.extend((*kind as u16).to_le_bytes());
        file.extend(count.to_le_bytes());
        file.extend(value.to_le_bytes());
    }
    file.extend([0; 8]);
    file
}

#[test]
fn millions_of_tiff_tags_and_of_their_values_cost_little() {
    assert!(decode(&big_tiff(&[])).is_ok());
    let tags = big_tiff(&vec![[40_000, 3, 1, 0]; 3_000_000]);
    let mut values = big_tiff(&[[338, 3, 20_000_000, 0]]);
    let end = values.len() as u64;
    let place = values.len() - 16;
    values[place..place + 8].copy_from_slice(&end.to_le_bytes());
    values.resize(values.len() + 40_000_000, 0);
    let strips = tiff_writer::write(false, &[0; 8], {
        let mut tags = tiff_writer::one_strip(1, 1_500_000, 8, 1, 1, 8);
        tags.retain(|tag| !matches!(tag, tiff_writer::Tag::Long(273 | 278 | 279, _)));
        tags.extend([
            tiff_writer::Tag::Long(273, vec![8; 1_500_000]),
            tiff_writer::Tag::Long(278, vec![1]),
            tiff_writer::Tag::Long(279, vec![1; 1_500_000]),
        ]);
        tags
    });
    for (name, file) in [("tags", tags), ("values", values), ("strips", strips)] {
        let begun = Instant::now();
        let error = decode_any(&file, name).expect_err(name);
        assert!(begun.elapsed() < Duration::from_millis(500), "{name}: {:?}", begun.elapsed());
        assert!(error.to_string().contains("up to"), "{name}: {error}");
    }
}

#[test]
fn a_padded_header_of_an_anymap_is_refused_at_once() {
    for magic in ["P1", "P2", "P5", "P6", "P7"] {
        for padding in [" ", "\n", "# a comment\n", "0", "WIDTH 9\n"] {
            let file = [magic.as_bytes(), b"\n", padding.repeat(100_000_000 / padding.len()).as_bytes(), b"9 9\n255\n"].concat();
            let begun = Instant::now();
            let error = decode_any(&file, magic).expect_err(magic);
            assert!(begun.elapsed() < Duration::from_millis(100), "{magic} padded with {padding:?}: {:?}", begun.elapsed());
            assert_eq!(error.code(), "unreadable-image");
        }
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
