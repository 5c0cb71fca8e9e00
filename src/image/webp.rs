//! The headers of WebP files.

use super::layout::{FileLayout, Format, damaged, field, truncated};
use crate::{Damage, Error, Unsupported};

/// Reads the layout of a still image.
pub(super) fn read_header(bytes: &[u8]) -> Result<FileLayout, Error> {
    let cut = || truncated(Format::WebP);
    let canvas = match field(bytes, 12).ok_or_else(cut)? {
        [b'V', b'P', b'8', b'X'] => {
            let [w, h] = [24, 27].map(|at| field(bytes, at).map(|[a, b, c]| 1 + u64::from(u32::from_le_bytes([a, b, c, 0]))));
            Some((w.ok_or_else(cut)?, h.ok_or_else(cut)?))
        }
        _ => None,
    };
    if canvas.is_some() && field(bytes, 20).is_some_and(|[flags]| flags & 2 != 0) {
        return Err(Unsupported::AnimatedWebp.into_error());
    }
    let frame = Frame::first(bytes)?;
    if let (Some(canvas), Some(frame)) = (canvas, &frame)
        && canvas != frame.size
    {
        return Err(damaged(Format::WebP, Damage::OtherCanvas { canvas, frame: frame.size }));
    }
    let (width, height) = canvas.or(frame.as_ref().map(|frame| frame.size)).ok_or_else(cut)?;
    // A macroblock of a lossy frame takes 3.4 bits even where each of its modes is the most probable one. A lossless frame of one colour
    // takes some 30 bytes whatever its size: its length says nothing.
    let lossless = frame.is_some_and(|frame| frame.lossless);
    let least_bytes = if lossless { 0 } else { width.div_ceil(16) * height.div_ceil(16) * 3 / 8 };
    // Colour and alpha, and as much again for the planes or the lossless pixels they are made from.
    Ok(FileLayout { format: Format::WebP, width, height, bytes_per_pixel: 8, least_bytes })
}

struct Frame {
    size: (u64, u64),
    lossless: bool,
}

impl Frame {
    /// The first frame, if there is one.
    fn first(bytes: &[u8]) -> Result<Option<Self>, Error> {
        let mut at = 12;
        while let (Some(name), Some(length)) = (field::<4>(bytes, at), field(bytes, at + 4)) {
            let cut = || truncated(Format::WebP);
            match &name {
                b"VP8 " => {
                    let [w, h] = [14, 16].map(|o| field(bytes, at + o).map(|b| u64::from(u16::from_le_bytes(b) & 0x3fff)));
                    return Ok(Some(Self { size: (w.ok_or_else(cut)?, h.ok_or_else(cut)?), lossless: false }));
                }
                b"VP8L" => {
                    let packed = u32::from_le_bytes(field(bytes, at + 9).ok_or_else(cut)?);
                    let size = (u64::from(packed & 0x3fff) + 1, u64::from((packed >> 14) & 0x3fff) + 1);
                    return Ok(Some(Self { size, lossless: true }));
                }
                _ => {}
            }
            // Chunks are padded to an even length.
            let length = u32::from_le_bytes(length) as usize;
            at = match at.checked_add(8).and_then(|at| at.checked_add(length)?.checked_add(length & 1)) {
                Some(next) => next,
                None => break,
            };
        }
        Ok(None)
    }
}
