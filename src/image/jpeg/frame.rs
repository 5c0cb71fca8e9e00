//! The frame header: size, components and how they are sampled.

use super::segments::{Segment, cut_off, write_segment};
use crate::image::layout::{FileLayout, Format, damaged};
use crate::{Damage, Error, Unsupported};

/// The frame header.
pub struct Frame {
    marker: u8,
    pub progressive: bool,
    pub width: u16,
    pub height: u16,
    pub components: Vec<Component>,
}

pub struct Component {
    pub id: u8,
    /// Horizontal and vertical sampling factors.
    pub sampling: (u8, u8),
    /// Number of its quantisation table.
    table: u8,
}

impl Frame {
    /// Reads the header and refuses what is not decoded.
    pub fn read(segment: &Segment<'_>) -> Result<Self, Error> {
        let progressive = match segment.marker {
            0xc0 | 0xc1 => false,
            0xc2 => true,
            marker @ 0xc9.. => return Err(Unsupported::JpegArithmetic { frame: marker & 15 }.into_error()),
            marker => return Err(Unsupported::JpegLossless { frame: marker & 15 }.into_error()),
        };
        let [precision, h1, h0, w1, w0, count, rest @ ..] = segment.body else {
            return Err(cut_off());
        };
        if *precision != 8 {
            return Err(Unsupported::JpegBits { bits: *precision }.into_error());
        }
        if !matches!(count, 1 | 3) {
            return Err(Unsupported::JpegComponents { components: *count }.into_error());
        }
        if rest.len() != 3 * usize::from(*count) {
            return Err(damaged(Format::Jpeg, Damage::FrameHeaderLength));
        }
        let components = rest.chunks_exact(3).map(|c| Component { id: c[0], sampling: (c[1] >> 4, c[1] & 15), table: c[2] }).collect();
        let mut frame = Self {
            marker: segment.marker,
            progressive,
            width: u16::from_be_bytes([*w1, *w0]),
            height: u16::from_be_bytes([*h1, *h0]),
            components,
        };
        frame.check_sampling()?;
        Ok(frame)
    }

    /// Refuses sampling factors that the decoder does not handle; a single component needs none.
    fn check_sampling(&mut self) -> Result<(), Error> {
        let allowed = match self.components.as_mut_slice() {
            [grey] => {
                grey.sampling = (1, 1);
                true
            }
            [first, others @ ..] => matches!(first.sampling, (1 | 2 | 4, 1 | 2 | 4)) && others.iter().all(|c| c.sampling == (1, 1)),
            [] => false,
        };
        if !allowed {
            return Err(Unsupported::JpegSampling { sampling: self.components.iter().map(|c| c.sampling).collect() }.into_error());
        }
        Ok(())
    }

    /// What the limits ask for.
    pub fn layout(&self) -> FileLayout {
        let [width, height] = [self.width, self.height].map(u64::from);
        // Each block of the first component takes a code for its mean, and in a sequential scan one for its end.
        let bits = if self.progressive { 1 } else { 2 };
        let least_bytes = width.div_ceil(8) * height.div_ceil(8) * bits / 8;
        // Output and working memory of the decoder: progressive coefficients of all components are held at once.
        let bytes_per_pixel = if self.progressive { 11 } else { 8 };
        FileLayout { format: Format::Jpeg, width, height, bytes_per_pixel, least_bytes }
    }

    /// Minimum coded units of a scan: of all components, or the blocks of one.
    pub fn units(&self, scanned: &[u8]) -> usize {
        let (across, down) = self.components[0].sampling;
        let count = |side: u16, sampled: u8, most: u8| (usize::from(side) * usize::from(sampled)).div_ceil(8 * usize::from(most));
        match self.components.iter().find(|c| scanned == [c.id]) {
            Some(only) => count(self.width, only.sampling.0, across) * count(self.height, only.sampling.1, down),
            None => count(self.width, 1, across) * count(self.height, 1, down),
        }
    }

    /// Blocks of a minimum coded unit of a scan.
    pub fn blocks_of_a_unit(&self, scanned: &[u8]) -> usize {
        let blocks = |c: &Component| usize::from(c.sampling.0) * usize::from(c.sampling.1);
        if scanned.len() == 1 { 1 } else { self.components.iter().filter(|c| scanned.contains(&c.id)).map(blocks).sum() }
    }

    /// How many pixels of the picture a sample of a component is wide and high.
    pub fn pixels_of(&self, component: usize) -> [usize; 2] {
        let (across, down) = if component == 0 { (1, 1) } else { self.components[0].sampling };
        [across, down].map(usize::from)
    }

    /// The grey image of one component, as large as its samples are many.
    pub fn only(&self, component: usize) -> Self {
        let [across, down] = self.pixels_of(component);
        let Component { id, table, .. } = self.components[component];
        Self {
            marker: self.marker,
            progressive: self.progressive,
            width: self.width.div_ceil(across as u16),
            height: self.height.div_ceil(down as u16),
            components: vec![Component { id, sampling: (1, 1), table }],
        }
    }

    /// Leaves the first component alone: a grey image.
    pub fn keep_first(&mut self) {
        self.components.truncate(1);
        self.components[0].sampling = (1, 1);
    }

    /// Appends the header as a segment.
    pub fn write(&self, stream: &mut Vec<u8>) {
        let mut body = vec![8];
        body.extend(self.height.to_be_bytes());
        body.extend(self.width.to_be_bytes());
        body.push(self.components.len() as u8);
        body.extend(self.components.iter().flat_map(|c| [c.id, c.sampling.0 << 4 | c.sampling.1, c.table]));
        write_segment(self.marker, &body, stream);
    }
}
