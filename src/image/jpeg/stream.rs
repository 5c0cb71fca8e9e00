//! The stream for the decoder: checked, and with nothing in it but what decoding needs.

use super::frame::Frame;
use super::scan::Scan;
use super::segments::{Segment, Segments, marker, write_segment};
use crate::image::layout::{Format, damaged};
use crate::{Damage, Error, Unsupported};

/// Each scan of a progressive file is a walk over all blocks, however few bytes it has. Encoders write 10 to 20 scans.
const MOST_SCANS: usize = 64;

/// What the decoder is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Output {
    Luma,
    /// Where luma is sampled twice as often down, but not across, as chroma, the decoder loses count of rows if asked for luma alone.
    LumaAndChroma,
    Rgb,
    /// Of RGB with scans that have not all components: no scan is in the stream.
    RgbApart,
}

/// A checked file: whole, in one frame, with nothing in it but what decoding needs.
pub struct CheckedStream {
    pub bytes: Vec<u8>,
    pub output: Output,
    /// Colours can be had of it.
    pub has_colours: bool,
}

impl CheckedStream {
    /// Reads and checks a file.
    pub fn read(bytes: &[u8]) -> Result<Self, Error> {
        let mut writer = Writer { stream: Vec::with_capacity(bytes.len() + 64), ..Writer::default() };
        writer.stream.extend([0xff, marker::SOI]);
        let mut segments = Segments::of(bytes);
        loop {
            let segment = segments.next()?;
            match segment.marker {
                _ if segment.is_frame() => writer.frame(&segment)?,
                marker::SOS => writer.scan(&segment, segments.entropy_coded()?)?,
                marker::EOI => break,
                _ => writer.tables(&segment)?,
            }
        }
        writer.finish()
    }
}

/// Writes the checked stream.
#[derive(Default)]
struct Writer {
    stream: Vec<u8>,
    frame: Option<Frame>,
    /// The frame header is written, before the first scan that is kept.
    begun: bool,
    /// All that decoding needs is written.
    complete: bool,
    adobe_transform: Option<u8>,
    restart_interval: usize,
    scans: usize,
    /// RGB of a sequential file with scans that have not all components.
    rgb_apart: bool,
}

impl Writer {
    fn frame(&mut self, segment: &Segment<'_>) -> Result<(), Error> {
        if self.frame.is_some() {
            return Err(damaged(Format::Jpeg, Damage::TwoFrameHeaders));
        }
        self.frame = Some(Frame::read(segment)?);
        Ok(())
    }

    /// Segments other than frame and scan: tables are kept, metadata are not.
    fn tables(&mut self, segment: &Segment<'_>) -> Result<(), Error> {
        match segment.marker {
            _ if self.complete => {}
            marker::DRI => {
                let interval = segment.body.first_chunk().ok_or_else(|| damaged(Format::Jpeg, Damage::RestartInterval))?;
                self.restart_interval = usize::from(u16::from_be_bytes(*interval));
                write_segment(marker::DRI, segment.body, &mut self.stream);
            }
            marker::DQT | marker::DHT => write_segment(segment.marker, segment.body, &mut self.stream),
            marker::APP14 if segment.body.starts_with(b"Adobe") => {
                self.adobe_transform = segment.body.get(11).copied();
                write_segment(marker::APP14, segment.body, &mut self.stream);
            }
            marker::APP0..=marker::APP15 | marker::COM => {}
            other => return Err(damaged(Format::Jpeg, Damage::UnexpectedMarker { marker: other })),
        }
        Ok(())
    }

    /// A scan. Of a sequential file, one scan is kept: that of all components, or that of luma alone, which is a grey image.
    fn scan(&mut self, segment: &Segment<'_>, (data, restarts): (&[u8], Vec<u8>)) -> Result<(), Error> {
        if self.complete {
            return Ok(());
        }
        self.scans += 1;
        if self.scans > MOST_SCANS {
            return Err(Unsupported::JpegScans { most: MOST_SCANS }.into_error());
        }
        let stores_rgb = self.stores_rgb();
        let frame = self.frame.as_mut().ok_or_else(|| damaged(Format::Jpeg, Damage::NoFrameHeader))?;
        let scanned: Vec<u8> = segment.body.get(1..).unwrap_or_default().chunks(2).map(|selector| selector[0]).collect();
        let scanned = &scanned[..scanned.len().min(segment.body.first().copied().unwrap_or(0).into())];
        if !frame.progressive {
            let first = frame.components[0].id;
            if scanned.len() < frame.components.len() {
                match scanned {
                    // None of them is the luma.
                    _ if stores_rgb => {
                        (self.rgb_apart, self.complete) = (true, true);
                        return Ok(());
                    }
                    [only] if *only == first => frame.keep_first(),
                    some if some.contains(&first) => return Err(Unsupported::JpegLumaApart.into_error()),
                    _ => return Ok(()),
                }
            }
            self.complete = true;
        }
        let scan = Scan::new(segment.body, frame, scanned, self.restart_interval);
        scan.check_restarts(&restarts)?;
        if !self.begun {
            frame.write(&mut self.stream);
            if frame.progressive {
                // The decoder takes the first scan only with a marker right behind it, without the ones. So it comes twice; a first scan
                // writes coefficients, and writing them again changes nothing.
                write_segment(marker::SOS, segment.body, &mut self.stream);
                self.stream.extend(data);
            }
            self.begun = true;
        }
        write_segment(marker::SOS, segment.body, &mut self.stream);
        scan.write(data, &mut self.stream)
    }

    fn stores_rgb(&self) -> bool {
        let named_rgb = self.frame.as_ref().is_some_and(|frame| frame.components.iter().map(|c| c.id).eq(*b"RGB"));
        let three = self.frame.as_ref().is_some_and(|frame| frame.components.len() == 3);
        named_rgb || three && self.adobe_transform == Some(0)
    }

    fn finish(mut self) -> Result<CheckedStream, Error> {
        self.stream.extend([0xff, marker::EOI]);
        let stores_rgb = self.stores_rgb();
        match self.frame {
            Some(_) if self.rgb_apart => Ok(CheckedStream { bytes: Vec::new(), output: Output::RgbApart, has_colours: true }),
            Some(frame) if self.begun => {
                let output = match frame.components[0].sampling {
                    _ if stores_rgb => Output::Rgb,
                    (1, 2) => Output::LumaAndChroma,
                    _ => Output::Luma,
                };
                Ok(CheckedStream { bytes: self.stream, output, has_colours: frame.components.len() == 3 })
            }
            _ => Err(damaged(Format::Jpeg, Damage::NoImageData)),
        }
    }
}
