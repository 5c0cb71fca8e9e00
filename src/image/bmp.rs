//! The headers of BMP files.

use super::layout::{FileLayout, Format, field};

/// Reads the core header of a BMP or one of the longer ones.
pub(super) fn read_header(bytes: &[u8]) -> Option<FileLayout> {
    let short = |at| field(bytes, at).map(|b| u64::from(u16::from_le_bytes(b)));
    let (width, height, bits, compression) = if u32::from_le_bytes(field(bytes, 14)?) == 12 {
        (short(18)?, short(20)?, short(24)?, 0)
    } else {
        // A negative height declares rows from top to bottom. A negative width is invalid: its magnitude is checked like any.
        let [width, height] = [18, 22].map(|at| field(bytes, at).map(|b| u64::from(i32::from_le_bytes(b).unsigned_abs())));
        (width?, height?, short(28)?, u32::from_le_bytes(field(bytes, 30)?))
    };
    let least_bytes = match compression {
        // Runs of two bytes hold up to 255 px. That more is left out by jumps is allowed, but nobody writes photographs like that.
        1 | 2 => width * height * 2 / 255,
        // Rows fill whole words, the last one perhaps not.
        _ => ((width * bits).div_ceil(32) * 4).saturating_mul(height.saturating_sub(1)),
    };
    Some(FileLayout { format: Format::Bmp, width, height, bytes_per_pixel: 4, least_bytes })
}
