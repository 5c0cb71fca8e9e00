//! The segments of a JPEG file.

use crate::image::layout::{Format, damaged, truncated};
use crate::{Damage, Error};

/// Markers, the second byte after 0xff.
pub mod marker {
    pub const SOI: u8 = 0xd8;
    pub const EOI: u8 = 0xd9;
    pub const SOS: u8 = 0xda;
    pub const DQT: u8 = 0xdb;
    pub const DHT: u8 = 0xc4;
    pub const DRI: u8 = 0xdd;
    /// Reserved for extensions.
    pub const JPG: u8 = 0xc8;
    /// Conditioning of arithmetic coding.
    pub const DAC: u8 = 0xcc;
    pub const APP0: u8 = 0xe0;
    pub const APP14: u8 = 0xee;
    pub const APP15: u8 = 0xef;
    pub const COM: u8 = 0xfe;
}

/// A marker with what follows it up to the next one, entropy-coded data apart.
pub struct Segment<'a> {
    pub marker: u8,
    /// The parameters after the length; empty for a marker that stands alone.
    pub body: &'a [u8],
}

impl Segment<'_> {
    /// A frame header of any process.
    pub fn is_frame(&self) -> bool {
        matches!(self.marker, 0xc0..=0xcf) && !matches!(self.marker, marker::DHT | marker::JPG | marker::DAC)
    }
}

/// Walks the segments of a file.
pub struct Segments<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> Segments<'a> {
    /// Begins after the mark of the file's start.
    pub fn of(file: &'a [u8]) -> Self {
        Self { bytes: file, at: 2 }
    }

    /// The next segment; bytes that belong to none are passed over.
    pub fn next(&mut self) -> Result<Segment<'a>, Error> {
        let code = loop {
            let ff = self.bytes.get(self.at..).and_then(|rest| rest.iter().position(|&b| b == 0xff)).ok_or_else(cut_off)?;
            self.at += ff + 1;
            match self.bytes.get(self.at).ok_or_else(cut_off)? {
                // A stuffed byte, a fill byte, or a marker that stands alone.
                0x00 => self.at += 1,
                0xff => {}
                0x01 | 0xd0..=0xd8 => self.at += 1,
                &code => break code,
            }
        };
        self.at += 1;
        if code == marker::EOI {
            return Ok(Segment { marker: code, body: &[] });
        }
        let length = usize::from(u16::from_be_bytes(*self.bytes.get(self.at..).and_then(|r| r.first_chunk()).ok_or_else(cut_off)?));
        if length < 2 {
            return Err(damaged(Format::Jpeg, Damage::SegmentLength { marker: code, length }));
        }
        let body = self.bytes.get(self.at + 2..self.at + length).ok_or_else(cut_off)?;
        self.at += length;
        Ok(Segment { marker: code, body })
    }

    /// The entropy-coded data up to the next marker other than a restart, and the numbers of the restarts.
    pub fn entropy_coded(&mut self) -> Result<(&'a [u8], Vec<u8>), Error> {
        let (start, mut restarts) = (self.at, Vec::new());
        loop {
            let ff = self.bytes[self.at..].iter().position(|&b| b == 0xff).ok_or_else(cut_off)?;
            self.at += ff;
            match self.bytes.get(self.at + 1).ok_or_else(cut_off)? {
                0x00 => self.at += 2,
                0xff => self.at += 1,
                &restart @ 0xd0..=0xd7 => {
                    restarts.push(restart & 7);
                    self.at += 2;
                }
                _ => return Ok((&self.bytes[start..self.at], restarts)),
            }
        }
    }
}

/// The error for a file that ends early.
pub fn cut_off() -> Error {
    truncated(Format::Jpeg)
}

/// Appends a segment.
pub fn write_segment(marker: u8, body: &[u8], stream: &mut Vec<u8>) {
    stream.extend([0xff, marker]);
    stream.extend((body.len() as u16 + 2).to_be_bytes());
    stream.extend(body);
}
