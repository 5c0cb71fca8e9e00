//! One scan: whether its data are all there.

use super::frame::Frame;
use crate::image::layout::{Format, damaged};
use crate::{Damage, Error};

/// Bytes of ones into which no code and no bits after one reach so far that another code could be read from them.
const ONES: usize = 4;
/// Encoders hold back up to some 1,000 bits that refine coefficients, which stand behind one code.
const ONES_OF_REFINEMENT: usize = 256;

/// What a scan codes.
pub struct Scan {
    /// Minimum coded units, and those from one restart to the next.
    units: usize,
    interval: usize,
    blocks_of_a_unit: usize,
    coding: Coding,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Coding {
    /// Codes of Huffman's kind.
    Codes,
    /// A bit a block, without codes.
    Bits,
    /// Codes with bits that refine earlier coefficients.
    Refinement,
}

impl Scan {
    /// The scan of a scan header.
    pub fn new(header: &[u8], frame: &Frame, scanned: &[u8], restart_interval: usize) -> Self {
        let units = frame.units(scanned);
        let coding = match *header {
            [.., first, _, precision] if frame.progressive && precision >> 4 > 0 => {
                if first == 0 {
                    Coding::Bits
                } else {
                    Coding::Refinement
                }
            }
            _ => Coding::Codes,
        };
        let interval = if restart_interval == 0 { units } else { restart_interval };
        Self { units, interval, blocks_of_a_unit: frame.blocks_of_a_unit(scanned), coding }
    }

    /// Refuses a scan whose restart markers show that intervals are missing. Some encoders add one restart after the last interval.
    pub fn check_restarts(&self, restarts: &[u8]) -> Result<(), Error> {
        let expected = self.units.div_ceil(self.interval).saturating_sub(1);
        let in_order = restarts.iter().enumerate().all(|(i, &number)| usize::from(number) == i % 8);
        if !in_order || !(expected..=expected + 1).contains(&restarts.len()) {
            return Err(damaged(Format::Jpeg, Damage::RestartMarkers { markers: restarts.len(), expected }));
        }
        Ok(())
    }

    /// Appends the data, and to each interval bits that no code consists of: a decoder that runs out of data meets an error instead of
    /// made-up zeros. Only bits that refine the very last blocks, behind the last code, may be missing without that.
    pub fn write(&self, data: &[u8], stream: &mut Vec<u8>) -> Result<(), Error> {
        let ones = if self.coding == Coding::Refinement { (8 * self.interval).clamp(ONES, ONES_OF_REFINEMENT) } else { ONES };
        let mut rest = data;
        let mut left = self.units;
        loop {
            let restart = rest.windows(2).position(|pair| pair[0] == 0xff && matches!(pair[1], 0xd0..=0xd7));
            let (interval, after) = rest.split_at(restart.unwrap_or(rest.len()));
            let bits = 8 * (interval.len() - interval.windows(2).filter(|pair| *pair == [0xff, 0]).count());
            if self.coding == Coding::Bits && bits < left.min(self.interval) * self.blocks_of_a_unit {
                return Err(damaged(Format::Jpeg, Damage::ShortScan));
            }
            left = left.saturating_sub(self.interval);
            stream.extend(interval);
            stream.extend([0xff, 0x00].repeat(ones));
            if restart.is_none() {
                return Ok(());
            }
            let (marker, after) = after.split_at(2);
            stream.extend(marker);
            rest = after;
        }
    }
}
