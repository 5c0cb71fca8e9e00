//! The file of a scan.

use crate::{Bands, DecodeLimits, Error, decode_bands};

/// What the file of a scan may ask for: a film of 230 mm with its border, 240 mm, has 294 MP at 14 µm. Its frame, which ends within the marks, has 218 MP.
pub const SCAN_LIMITS: DecodeLimits = DecodeLimits { max_pixels: 300_000_000, max_memory_bytes: 3 << 30 };

/// Decodes the file of a scan.
///
/// # Errors
/// As [`decode_bands`], within [`SCAN_LIMITS`].
pub fn decode_scan(file: &[u8]) -> Result<Bands, Error> {
    decode_bands(file, &SCAN_LIMITS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scans_of_240_mm_at_14_um_are_decoded_and_larger_ones_refused_by_what_they_declare() {
        // A PNG of grey values that ends behind its header.
        let declared = |side: u32| {
            let sides = [side.to_be_bytes(), side.to_be_bytes()].concat();
            let head: &[u8] = b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR";
            decode_scan(&[head, &sides, &[8, 0, 0, 0, 0, 0, 0, 0, 0]].concat()).unwrap_err()
        };
        assert!(matches!(declared(17_321), Error::TooManyPixels { max_megapixels: 300.0, .. }), "{:?}", declared(17_321));
        assert!(matches!(declared(17_143), Error::UnreadableImage { .. }), "{:?}", declared(17_143));
    }
}
