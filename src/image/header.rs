//! What the first bytes of an image file declare, read without decoding.

use super::jpeg;
use super::tiff::TiffLayout;
use crate::Error;

/// The formats that are decoded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Format {
    Jpeg,
    Png,
    Tiff,
    Bmp,
    Pnm,
    WebP,
}

impl Format {
    pub const ALL: &'static str = "JPEG, PNG, TIFF, BMP, PNM (PBM, PGM, PPM, PAM), WebP";

    pub fn name(self) -> &'static str {
        match self {
            Format::Jpeg => "JPEG",
            Format::Png => "PNG",
            Format::Tiff => "TIFF",
            Format::Bmp => "BMP",
            Format::Pnm => "PNM",
            Format::WebP => "WebP",
        }
    }

    /// The format that the first bytes name.
    fn of(bytes: &[u8]) -> Result<Self, Error> {
        match bytes {
            [0xff, 0xd8, ..] => Ok(Format::Jpeg),
            [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n', ..] => Ok(Format::Png),
            [b'I', b'I', 42 | 43, 0, ..] | [b'M', b'M', 0, 42 | 43, ..] => Ok(Format::Tiff),
            [b'B', b'M', ..] => Ok(Format::Bmp),
            [b'P', b'1'..=b'7', b' ' | b'\t' | b'\r' | b'\n' | b'#', ..] => Ok(Format::Pnm),
            [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => Ok(Format::WebP),
            [] => Err(Error::UnreadableImage { reason: "the file is empty".into() }),
            _ => Err(Error::UnsupportedImage { what: "this kind of file".into(), allowed: Format::ALL }),
        }
    }
}

/// What a file declares about itself: enough to refuse it before anything is decoded.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FileLayout {
    pub format: Format,
    pub width: u64,
    pub height: u64,
    /// Most bytes a pixel of the decoder's output and of its working memory.
    pub bytes_per_pixel: u64,
}

impl FileLayout {
    /// Reads the layout; sides are at least 1 px.
    pub fn read(bytes: &[u8]) -> Result<Self, Error> {
        let format = Format::of(bytes)?;
        let (width, height, bytes_per_pixel) = match format {
            Format::Jpeg => jpeg::read_header(bytes)?,
            Format::Png => png(bytes).ok_or_else(|| truncated(format))?,
            Format::Tiff => {
                let tiff = TiffLayout::read(bytes)?;
                (tiff.width, tiff.height, tiff.bytes_per_pixel())
            }
            Format::Bmp => bmp(bytes).ok_or_else(|| truncated(format))?,
            Format::Pnm => pnm(bytes)?,
            Format::WebP => webp(bytes)?,
        };
        if width == 0 || height == 0 {
            return Err(damaged(format, format!("it declares {width} x {height} px; a side has at least 1 px")));
        }
        Ok(Self { format, width, height, bytes_per_pixel })
    }
}

/// The error for a file that ends before what it declares.
pub(super) fn truncated(format: Format) -> Error {
    damaged(format, "the file ends before its image does: it is truncated")
}

/// The error for a file that contradicts its format.
pub(super) fn damaged(format: Format, reason: impl std::fmt::Display) -> Error {
    Error::UnreadableImage { reason: format!("{}: {reason}", format.name()) }
}

/// The bytes of a field at a place of the file, where the file reaches that far.
pub(super) fn field<const N: usize>(bytes: &[u8], at: usize) -> Option<[u8; N]> {
    bytes.get(at..)?.first_chunk().copied()
}

/// Width, height and bytes a pixel of the IHDR chunk, which the format puts first.
fn png(bytes: &[u8]) -> Option<(u64, u64, u64)> {
    let [width, height] = [16, 20].map(|at| field(bytes, at).map(u32::from_be_bytes));
    let [depth, colour_type] = field(bytes, 24)?;
    // A tRNS chunk may add alpha to each colour type that has none.
    let channels = if colour_type == 0 { 2 } else { 4 };
    Some((width?.into(), height?.into(), channels * if depth == 16 { 2 } else { 1 }))
}

/// Width, height and bytes a pixel of the core header or of one of the longer ones.
fn bmp(bytes: &[u8]) -> Option<(u64, u64, u64)> {
    let (width, height) = if u32::from_le_bytes(field(bytes, 14)?) == 12 {
        (u16::from_le_bytes(field(bytes, 18)?).into(), u16::from_le_bytes(field(bytes, 20)?).into())
    } else {
        // A negative height declares rows from top to bottom. A negative width is invalid: its magnitude is checked like any.
        let [width, height] = [18, 22].map(|at| field(bytes, at).map(i32::from_le_bytes));
        (width?.unsigned_abs().into(), height?.unsigned_abs().into())
    };
    Some((width, height, 4))
}

/// Width, height and bytes a pixel of a still WebP image.
fn webp(bytes: &[u8]) -> Result<(u64, u64, u64), Error> {
    let cut = || truncated(Format::WebP);
    let canvas = match field(bytes, 12).ok_or_else(cut)? {
        [b'V', b'P', b'8', b'X'] => {
            let [w, h] = [24, 27].map(|at| field(bytes, at).map(|[a, b, c]| 1 + u64::from(u32::from_le_bytes([a, b, c, 0]))));
            Some((w.ok_or_else(cut)?, h.ok_or_else(cut)?))
        }
        _ => None,
    };
    if canvas.is_some() && field(bytes, 20).is_some_and(|[flags]| flags & 2 != 0) {
        return Err(Error::UnsupportedImage { what: "an animated WebP".into(), allowed: "still images" });
    }
    let frame = webp_frame(bytes)?;
    if let (Some(canvas), Some(frame)) = (canvas, frame)
        && canvas != frame
    {
        return Err(damaged(Format::WebP, format!("its canvas of {canvas:?} px holds a frame of {frame:?} px")));
    }
    let (width, height) = canvas.or(frame).ok_or_else(cut)?;
    // Colour and alpha, and as much again for the planes or the lossless pixels they are made from.
    Ok((width, height, 8))
}

/// Width and height of the first frame, if there is one.
fn webp_frame(bytes: &[u8]) -> Result<Option<(u64, u64)>, Error> {
    let mut at = 12;
    while let (Some(name), Some(length)) = (field::<4>(bytes, at), field(bytes, at + 4)) {
        let cut = || truncated(Format::WebP);
        match &name {
            b"VP8 " => {
                let [w, h] = [14, 16].map(|o| field(bytes, at + o).map(|b| u64::from(u16::from_le_bytes(b) & 0x3fff)));
                return Ok(Some((w.ok_or_else(cut)?, h.ok_or_else(cut)?)));
            }
            b"VP8L" => {
                let packed = u32::from_le_bytes(field(bytes, at + 9).ok_or_else(cut)?);
                return Ok(Some((u64::from(packed & 0x3fff) + 1, u64::from((packed >> 14) & 0x3fff) + 1)));
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

/// Width, height and bytes a pixel of a portable anymap.
fn pnm(bytes: &[u8]) -> Result<(u64, u64, u64), Error> {
    let kind = bytes[1];
    if kind == b'7' {
        return pam(bytes);
    }
    let mut words = Words { rest: &bytes[2..] };
    let [width, height] = [words.number()?, words.number()?];
    let max = if matches!(kind, b'1' | b'4') { 1 } else { words.number()? };
    let channels = if matches!(kind, b'3' | b'6') { 3 } else { 1 };
    Ok((width, height, channels * if max > 255 { 2 } else { 1 }))
}

/// The header lines of a portable arbitrary map: WIDTH, HEIGHT, DEPTH and MAXVAL in any order.
fn pam(bytes: &[u8]) -> Result<(u64, u64, u64), Error> {
    let mut words = Words { rest: &bytes[2..] };
    let [mut width, mut height, mut depth, mut max] = [None; 4];
    loop {
        match words.next().ok_or_else(|| truncated(Format::Pnm))? {
            b"WIDTH" => width = Some(words.number()?),
            b"HEIGHT" => height = Some(words.number()?),
            b"DEPTH" => depth = Some(words.number()?),
            b"MAXVAL" => max = Some(words.number()?),
            b"TUPLTYPE" => _ = words.next(),
            b"ENDHDR" => break,
            _ => return Err(damaged(Format::Pnm, "its PAM header has an unknown line")),
        }
    }
    match (width, height, depth, max) {
        (Some(width), Some(height), Some(depth @ 1..=4), Some(max)) => Ok((width, height, depth * if max > 255 { 2 } else { 1 })),
        _ => Err(damaged(Format::Pnm, "its PAM header lacks WIDTH, HEIGHT, MAXVAL or a DEPTH of 1 to 4")),
    }
}

/// The words of a PNM header; comments run from `#` to the end of the line.
struct Words<'a> {
    rest: &'a [u8],
}

impl<'a> Words<'a> {
    fn next(&mut self) -> Option<&'a [u8]> {
        loop {
            self.rest = self.rest.trim_ascii_start();
            if *self.rest.first()? != b'#' {
                break;
            }
            let line = self.rest.iter().position(|&b| b == b'\n')?;
            self.rest = &self.rest[line..];
        }
        let end = self.rest.iter().position(|b| b.is_ascii_whitespace() || *b == b'#').unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        Some(word)
    }

    /// A whole number; one too large for 64 bits counts as the largest.
    fn number(&mut self) -> Result<u64, Error> {
        let word = self.next().ok_or_else(|| truncated(Format::Pnm))?;
        if !word.iter().all(u8::is_ascii_digit) {
            return Err(damaged(
                Format::Pnm,
                format!("its header has '{}' where a number belongs", String::from_utf8_lossy(&word[..word.len().min(16)])),
            ));
        }
        Ok(word.iter().fold(0u64, |n, d| n.saturating_mul(10).saturating_add(u64::from(d - b'0'))))
    }
}
