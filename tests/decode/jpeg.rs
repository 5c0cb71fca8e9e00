//! JPEG of every sampling and scan structure, with blocks of known values.

use super::decode;
use super::formats::{grey, luma};
use super::jpeg_writer::Jpeg;
use tiepoint::{DecodeLimits, decode_bands};

/// Luma of blocks, different for each of the first 13 columns and 17 rows.
fn block_luma(column: usize, row: usize) -> u8 {
    (20 + 11 * (column % 13) + 5 * (row % 17)) as u8
}

#[test]
fn jpeg_luma_is_exact_for_every_sampling_and_scan_structure() {
    let sizes = [(1, 1), (8, 8), (16, 16), (17, 33), (64, 8), (131, 75), (40, 129)];
    for (h, v) in [(1, 1), (2, 1), (1, 2), (2, 2), (4, 1), (1, 4), (4, 2), (2, 4), (4, 4)] {
        let components = [(1, h, v), (2, 1, 1), (3, 1, 1)];
        for (width, height) in sizes {
            for (progressive, interleaved) in [(false, true), (false, false), (true, true), (true, false)] {
                for restart_interval in [0, 1, 3] {
                    let what = format!(
                        "{h}x{v}, {width} x {height} px, progressive {progressive}, one scan {interleaved}, restarts {restart_interval}"
                    );
                    let jpeg = Jpeg { progressive, interleaved, restart_interval, ..Jpeg::baseline(width, height, &components) };
                    let file = jpeg.write(|c, column, row| if c == 0 { block_luma(column, row) } else { (90 * c + 3 * column) as u8 });
                    let decoded = decode(&file).unwrap_or_else(|e| panic!("{what}: {e}"));
                    let [width, height] = [width, height].map(usize::from);
                    let expected: Vec<u8> = (0..height).flat_map(|y| (0..width).map(move |x| block_luma(x / 8, y / 8))).collect();
                    assert!(decoded.grey.data() == expected, "{what}");
                }
            }
        }
    }
}

#[test]
fn jpeg_colours_are_those_of_jfif_for_every_sampling() {
    // Chroma the same in all blocks, so that it is the same between them too.
    let [cb, cr] = [100.0, 160.0];
    let expected = |luma: u8| {
        let y = f64::from(luma);
        let rgb = [y + 1.402 * (cr - 128.0), y - 0.344_136 * (cb - 128.0) - 0.714_136 * (cr - 128.0), y + 1.772 * (cb - 128.0)];
        rgb.map(|value| value.clamp(0.0, 255.0))
    };
    for (h, v) in [(1, 1), (2, 1), (1, 2), (2, 2), (4, 1), (1, 4), (4, 4)] {
        for (progressive, interleaved) in [(false, true), (false, false), (true, true), (true, false)] {
            let components = [(1, h, v), (2, 1, 1), (3, 1, 1)];
            let jpeg = Jpeg { progressive, interleaved, ..Jpeg::baseline(70, 45, &components) };
            let file = jpeg.write(|c, column, row| [block_luma(column, row), cb as u8, cr as u8][c]);
            let bands = decode_bands(&file, &DecodeLimits::default()).unwrap();
            assert!(bands.are_colours() && [bands.width(), bands.height()] == [70, 45]);
            for (x, y) in (0..45).flat_map(|y| (0..70).map(move |x| (x, y))) {
                for (band, expected) in bands.images().iter().zip(expected(block_luma(x / 8, y / 8))) {
                    let own = f64::from(band.view().at(x, y));
                    assert!((own - expected).abs() <= 2.0, "{h}x{v}, progressive {progressive}: {own} for {expected} at {x} {y}");
                }
            }
        }
    }
}

#[test]
fn jpeg_colours_of_scans_apart_are_those_of_one_scan() {
    // Chroma that differs from block to block, and is enlarged between them; also where the picture ends within a sample of it.
    for (h, v) in [(1, 1), (2, 1), (1, 2), (2, 2), (4, 1), (4, 4)] {
        for (width, height) in [(70, 45), (33, 17), (9, 5), (1, 1)] {
            for restart_interval in [0, 3] {
                let components = [(1, h, v), (2, 1, 1), (3, 1, 1)];
                let of = |interleaved| {
                    let jpeg = Jpeg { interleaved, restart_interval, ..Jpeg::baseline(width, height, &components) };
                    jpeg.write(|c, column, row| if c == 0 { block_luma(column, row) } else { (90 + 20 * c + 9 * column + 5 * row) as u8 })
                };
                let [one, apart] = [true, false].map(|interleaved| decode_bands(&of(interleaved), &DecodeLimits::default()).unwrap());
                assert!(one.are_colours() && apart.are_colours());
                for (own, known) in apart.images().iter().zip(one.images()) {
                    let differs = own.data().iter().zip(known.data()).map(|(a, b)| a.abs_diff(*b)).max().unwrap();
                    // The library repeats samples that stand for four pixels: up to three eighths of the steps of 9 and 5 lie between, 1.772 times.
                    let most = if h.max(v) == 4 { 10 } else { 3 };
                    assert!(differs <= most, "{h}x{v}, {width} x {height} px, restarts {restart_interval}: {differs}");
                }
            }
        }
    }
    // A scan of chroma that is not whole is damage where colours are wanted, and nothing where luma is.
    let file =
        Jpeg { interleaved: false, ..Jpeg::baseline(64, 64, &[(1, 1, 1), (2, 1, 1), (3, 1, 1)]) }.write(|_, column, _| 90 + column as u8);
    let scans: Vec<usize> = (0..file.len() - 1).filter(|at| file[*at..*at + 2] == [0xff, 0xda]).collect();
    let cut = [&file[..scans[2] + 10], &[0xff, 0xd9]].concat();
    assert!(decode(&cut).is_ok() && decode_bands(&cut, &DecodeLimits::default()).is_err());
    // Luma alone is grey.
    let luma = [&file[..scans[1]], &[0xff, 0xd9]].concat();
    assert!(!decode_bands(&luma, &DecodeLimits::default()).unwrap().are_colours());
}

#[test]
fn jpeg_grey_ignores_its_sampling_factors() {
    for (h, v) in [(1, 1), (2, 2), (4, 1), (2, 1)] {
        for progressive in [false, true] {
            let file = Jpeg { progressive, ..Jpeg::baseline(50, 30, &[(1, h, v)]) }.write(|_, column, row| block_luma(column, row));
            let expected: Vec<u8> = (0..30).flat_map(|y| (0..50).map(move |x| block_luma(x / 8, y / 8))).collect();
            assert_eq!(grey(&file), expected, "{h}x{v}, progressive {progressive}");
        }
    }
}

#[test]
fn jpeg_of_stored_rgb_with_a_scan_for_each_component_has_its_colours_and_its_luma() {
    let value = |c: usize, column: usize, row: usize| (30 + 60 * c + 7 * column + 3 * row) as u8;
    let ids = [(b'R', 1, 1), (b'G', 1, 1), (b'B', 1, 1)];
    // Behind the first marker: Adobe, version 100, no transform.
    let adobe = |file: Vec<u8>| [&file[..2], b"\xff\xee\0\x0eAdobe\0\x64\0\0\0\0\0", &file[2..]].concat();
    for restart_interval in [0, 3] {
        let named = Jpeg { interleaved: false, restart_interval, ..Jpeg::baseline(30, 20, &ids) }.write(value);
        let said =
            adobe(Jpeg { interleaved: false, restart_interval, ..Jpeg::baseline(30, 20, &[(1, 1, 1), (2, 1, 1), (3, 1, 1)]) }.write(value));
        for file in [named, said] {
            let bands = decode_bands(&file, &DecodeLimits::default()).unwrap();
            let grey = decode(&file).unwrap().grey;
            assert!(bands.are_colours());
            for (x, y) in (0..20).flat_map(|y| (0..30).map(move |x| (x, y))) {
                let expected: [u8; 3] = std::array::from_fn(|c| value(c, x / 8, y / 8));
                let own: Vec<u8> = bands.images().iter().map(|band| band.view().at(x, y)).collect();
                assert_eq!((own.as_slice(), grey.view().at(x, y)), (expected.as_slice(), luma(&expected)), "{x} {y}");
            }
        }
    }
    // One that lacks a component, or whose scan is cut off, is refused.
    let file = Jpeg { interleaved: false, ..Jpeg::baseline(64, 64, &ids) }.write(value);
    let scans: Vec<usize> = (0..file.len() - 1).filter(|at| file[*at..*at + 2] == [0xff, 0xda]).collect();
    let lacking = decode(&[&file[..scans[2]], &[0xff, 0xd9]].concat()).unwrap_err();
    assert!(lacking.to_string().contains("RGB"), "{lacking}");
    let cut = [&file[..scans[2] + 10], &[0xff, 0xd9]].concat();
    assert!(decode(&cut).is_err() && decode_bands(&cut, &DecodeLimits::default()).is_err());
}

#[test]
fn jpeg_of_stored_rgb_comes_out_as_its_luma() {
    let value = |c, column, row| (30 + 60 * c + 7 * column + 3 * row) as u8;
    let expected: Vec<u8> = (0..20)
        .flat_map(|y| (0..30).map(move |x| luma(&[value(0, x / 8, y / 8), value(1, x / 8, y / 8), value(2, x / 8, y / 8)])))
        .collect();
    let named = Jpeg::baseline(30, 20, &[(b'R', 1, 1), (b'G', 1, 1), (b'B', 1, 1)]);
    assert_eq!(grey(&named.write(value)), expected, "components R, G, B");
    let bands = decode_bands(&named.write(value), &DecodeLimits::default()).unwrap();
    assert!(bands.images().iter().enumerate().all(|(c, band)| band.view().at(21, 12) == value(c, 2, 1)));
    let adobe = Jpeg { adobe_transform: Some(0), ..Jpeg::baseline(30, 20, &[(1, 1, 1), (2, 1, 1), (3, 1, 1)]) };
    assert_eq!(grey(&adobe.write(value)), expected, "Adobe transform 0");
}

#[test]
fn jpeg_kinds_that_are_not_decoded_are_named() {
    let cmyk = Jpeg::baseline(16, 16, &[(1, 1, 1), (2, 1, 1), (3, 1, 1), (4, 1, 1)]).write(|_, _, _| 5);
    let error = decode(&cmyk).unwrap_err();
    assert_eq!(error.code(), "unsupported-image");
    assert!(error.to_string().contains("CMYK"), "{error}");
    let odd = Jpeg::baseline(16, 16, &[(1, 1, 1), (2, 2, 1), (3, 1, 1)]).write(|_, _, _| 5);
    assert!(decode(&odd).unwrap_err().to_string().contains("sampling factors"));
    let mut arithmetic = Jpeg::baseline(16, 16, &[(1, 1, 1)]).write(|_, _, _| 5);
    let frame = arithmetic.windows(2).position(|pair| pair == [0xff, 0xc0]).unwrap();
    arithmetic[frame + 1] = 0xc9;
    assert!(decode(&arithmetic).unwrap_err().to_string().contains("arithmetic"));
}
