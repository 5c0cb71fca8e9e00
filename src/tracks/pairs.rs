//! Which pairs of images were matched, looked up at once.

use super::BlockMatches;

/// A bit for each pair of images, both ways.
pub(super) struct PairTable {
    images: usize,
    bits: Vec<u64>,
}

impl PairTable {
    pub(super) fn new(matches: &BlockMatches) -> Self {
        let images = matches.images();
        let mut table = Self { images, bits: vec![0; (images * images).div_ceil(64)] };
        for [a, b] in matches.pairs() {
            for place in [a as usize * images + b as usize, b as usize * images + a as usize] {
                table.bits[place / 64] |= 1 << (place % 64);
            }
        }
        table
    }

    pub(super) fn has(&self, a: u32, b: u32) -> bool {
        let place = a as usize * self.images + b as usize;
        self.bits[place / 64] >> (place % 64) & 1 == 1
    }
}
