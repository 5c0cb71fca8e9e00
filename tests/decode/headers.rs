//! Files that are little more than a header.

use super::{jpeg_writer, tiff_writer};

/// Headers of every format that declare these sides, with hardly anything behind them.
pub fn headers(width: u32, height: u32) -> Vec<(&'static str, Vec<u8>)> {
    let png =
        [b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR".as_slice(), &width.to_be_bytes(), &height.to_be_bytes(), &[16, 6, 0, 0, 0], &[0; 40]].concat();
    let info = [40u32.to_le_bytes(), width.to_le_bytes(), height.to_le_bytes()].concat();
    let bmp = [b"BM".as_slice(), &[0; 12], &info, &[1, 0, 24, 0], &[0; 40]].concat();
    let mut jpeg = vec![0xff, 0xd8];
    let [w, h] = [width, height].map(|side| side.min(65_535).to_be_bytes());
    jpeg_writer::segment(&mut jpeg, 0xc0, &[8, h[2], h[3], w[2], w[3], 1, 1, 0x11, 0]);
    let side = |n: u32| (n - 1).to_le_bytes()[..3].to_vec();
    let webp = [b"RIFF\x20\0\0\0WEBPVP8X\x0a\0\0\0\0\0\0\0".as_slice(), &side(width), &side(height), &[0; 8]].concat();
    vec![
        ("PNG", png),
        ("BMP", bmp),
        ("JPEG", jpeg),
        ("WebP", webp),
        ("TIFF", tiff_writer::write(false, &[0; 8], tiff_writer::one_strip(width, height, 16, 3, 2, 8))),
        ("TIFF", tiff_writer::write(true, &[0; 8], tiff_writer::one_strip(width, height, 8, 1, 1, 8))),
        ("PNM", format!("P6 # a comment\n{width} {height}\n65535\n").into_bytes()),
        ("PNM", format!("P7\nWIDTH {width}\nHEIGHT {height}\nDEPTH 4\nMAXVAL 255\nTUPLTYPE RGB_ALPHA\nENDHDR\n").into_bytes()),
    ]
}
