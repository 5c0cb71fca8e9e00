//! The headers of portable anymaps.

use super::layout::{FileLayout, Format, damaged, truncated};
use crate::{Damage, Error};

/// A header is a few words; one that comments and white space blow up beyond this is no header.
const MOST_HEADER_BYTES: usize = 1 << 16;

/// Reads the layout of a bit, grey, pixel or arbitrary map.
pub(super) fn read_header(bytes: &[u8]) -> Result<FileLayout, Error> {
    let kind = bytes[1];
    let mut words = Words { rest: &bytes[2..bytes.len().min(MOST_HEADER_BYTES)], cut: bytes.len() > MOST_HEADER_BYTES };
    if kind == b'7' {
        return pam(&mut words);
    }
    let [width, height] = [words.number()?, words.number()?];
    let max = if matches!(kind, b'1' | b'4') { 1 } else { words.number()? };
    let channels = if matches!(kind, b'3' | b'6') { 3 } else { 1 };
    let bytes_per_pixel = channels * if max > 255 { 2 } else { 1 };
    let samples = width.saturating_mul(height).saturating_mul(channels);
    let least_bytes = match kind {
        b'1' => samples,
        // A digit and what separates it from the next one.
        b'2' | b'3' => samples.saturating_mul(2).saturating_sub(1),
        b'4' => width.div_ceil(8).saturating_mul(height),
        _ => samples.saturating_mul(if max > 255 { 2 } else { 1 }),
    };
    Ok(FileLayout { format: Format::Pnm, width, height, bytes_per_pixel, least_bytes })
}

/// The header lines of a portable arbitrary map: WIDTH, HEIGHT, DEPTH and MAXVAL in any order.
fn pam(words: &mut Words<'_>) -> Result<FileLayout, Error> {
    let [mut width, mut height, mut depth, mut max] = [None; 4];
    loop {
        match words.next()? {
            b"WIDTH" => width = Some(words.number()?),
            b"HEIGHT" => height = Some(words.number()?),
            b"DEPTH" => depth = Some(words.number()?),
            b"MAXVAL" => max = Some(words.number()?),
            b"TUPLTYPE" => _ = words.next()?,
            b"ENDHDR" => break,
            _ => return Err(damaged(Format::Pnm, Damage::UnknownPamLine)),
        }
    }
    match (width, height, depth, max) {
        (Some(width), Some(height), Some(depth @ 1..=4), Some(max)) => {
            let bytes_per_pixel = depth * if max > 255 { 2 } else { 1 };
            let least_bytes = width.saturating_mul(height).saturating_mul(bytes_per_pixel);
            Ok(FileLayout { format: Format::Pnm, width, height, bytes_per_pixel, least_bytes })
        }
        _ => Err(damaged(Format::Pnm, Damage::IncompletePamHeader)),
    }
}

/// The words of a header; comments run from `#` to the end of the line.
struct Words<'a> {
    rest: &'a [u8],
    /// The file goes on where `rest` ends.
    cut: bool,
}

impl<'a> Words<'a> {
    fn next(&mut self) -> Result<&'a [u8], Error> {
        loop {
            self.rest = self.rest.trim_ascii_start();
            if *self.rest.first().ok_or_else(|| self.ended())? != b'#' {
                break;
            }
            let line = self.rest.iter().position(|&b| b == b'\n').ok_or_else(|| self.ended())?;
            self.rest = &self.rest[line..];
        }
        // Image data follow every word of a header: white space ends it.
        let end = self.rest.iter().position(|b| b.is_ascii_whitespace() || *b == b'#').ok_or_else(|| self.ended())?;
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        Ok(word)
    }

    fn ended(&self) -> Error {
        if self.cut { damaged(Format::Pnm, Damage::LongHeader { most_bytes: MOST_HEADER_BYTES }) } else { truncated(Format::Pnm) }
    }

    /// A whole number; one too large for 64 bits counts as the largest.
    fn number(&mut self) -> Result<u64, Error> {
        let word = self.next()?;
        if !word.iter().all(u8::is_ascii_digit) {
            let word = String::from_utf8_lossy(&word[..word.len().min(16)]).into_owned();
            return Err(damaged(Format::Pnm, Damage::NoNumber { word }));
        }
        Ok(word.iter().fold(0u64, |n, d| n.saturating_mul(10).saturating_add(u64::from(d - b'0'))))
    }
}
