//! Squares of the distances of many byte descriptors from many others, in blocks that stay in the fast memories.
//!
//! d² = |a|² + |b|² - 2 a·b in whole numbers. Sums start at -|a|² - |b|² and take up 2a·b pair by pair of bytes, so that they end at -d²: the
//! largest is the nearest. Right descriptors lie side by side, one a lane; left ones are spread over all lanes.

use crate::math::{Pairs, Whole};
use std::ops::Range;

/// Bytes of a descriptor.
pub const DESCRIPTOR_BYTES: usize = 128;

/// Pairs of bytes.
const PAIRS: usize = DESCRIPTOR_BYTES / 2;
/// Left descriptors that are worked on at once; with more, engines keep sums in memory instead of in registers.
const ROWS: usize = 4;
/// Right descriptors that are worked on at once: two quads.
const GROUP: usize = 8;
/// Groups that are read again for each block of left descriptors: 128 kB.
const CHUNK: usize = 64;

/// -d² to what fills up a block: further than any two descriptors (128 · 255² < 2²³), and their sum still is a number.
const FILLER: i32 = -(1 << 29);

/// Of one descriptor: the nearest of the others, and how far it and the next are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Top {
    /// -d² of the nearest and of the second nearest.
    pub best: i32,
    pub second: i32,
    pub index: u32,
}

impl Top {
    /// Before anything was looked at; whatever is at most this is no neighbour.
    pub const NONE: Self = Self { best: FILLER / 2, second: FILLER / 2, index: u32::MAX };

    /// Takes note of another one. Indices come in ascending order, so that of equal ones the first stays.
    fn meet(&mut self, value: i32, index: usize) {
        if value > self.best {
            *self = Self { best: value, second: self.best, index: index as u32 };
        } else if value > self.second {
            self.second = value;
        }
    }
}

/// Descriptors as the right side of the search: groups of eight, pair by pair of bytes.
struct Columns {
    /// For each group and pair the two values of the eight descriptors.
    values: Vec<[[i16; 8]; 2]>,
    /// -|b|², eight for each group.
    start: Vec<[[i32; 4]; 2]>,
}

impl Columns {
    fn new(descriptors: &[[u8; DESCRIPTOR_BYTES]]) -> Self {
        let groups = descriptors.len().div_ceil(GROUP);
        let mut values = vec![[[0; 8]; 2]; groups * PAIRS];
        let mut start = vec![[[FILLER; 4]; 2]; groups];
        for (index, descriptor) in descriptors.iter().enumerate() {
            let (group, half, lane) = (index / GROUP, index % GROUP / 4, index % 4);
            for (of_pair, pair) in values[group * PAIRS..][..PAIRS].iter_mut().zip(descriptor.as_chunks::<2>().0) {
                of_pair[half][2 * lane] = i16::from(pair[0]);
                of_pair[half][2 * lane + 1] = i16::from(pair[1]);
            }
            start[group][half][lane] = -square(descriptor);
        }
        Self { values, start }
    }
}

/// Four left descriptors, doubled, and their -|a|².
struct Rows {
    values: [[[i16; 2]; PAIRS]; ROWS],
    start: [i32; ROWS],
}

impl Rows {
    fn new(descriptors: &[[u8; DESCRIPTOR_BYTES]]) -> Self {
        let mut rows = Self { values: [[[0; 2]; PAIRS]; ROWS], start: [FILLER; ROWS] };
        for (row, descriptor) in descriptors.iter().enumerate() {
            for (doubled, pair) in rows.values[row].iter_mut().zip(descriptor.as_chunks::<2>().0) {
                *doubled = [2 * i16::from(pair[0]), 2 * i16::from(pair[1])];
            }
            rows.start[row] = -square(descriptor);
        }
        rows
    }

    /// -d² of the four from the eight of a group.
    #[inline(always)]
    fn sums(&self, columns: &[[[i16; 8]; 2]; PAIRS], start: &[[i32; 4]; 2]) -> [[Whole; 2]; ROWS] {
        let mut sums: [[Whole; 2]; ROWS] = self.start.map(|square| start.map(|group| Whole::load(&group) + Whole::splat(square)));
        for (pair, [low, high]) in columns.iter().enumerate() {
            let (low, high) = (Pairs::load(low), Pairs::load(high));
            for (sum, row) in sums.iter_mut().zip(&self.values) {
                let own = Pairs::splat(&row[pair]);
                sum[0] = sum[0] + own.dot(low);
                sum[1] = sum[1] + own.dot(high);
            }
        }
        sums
    }
}

/// The nearest right descriptors of the left ones in `rows`, and the nearest of these left ones of every right descriptor.
pub(super) fn nearest_in_blocks(
    left: &[[u8; DESCRIPTOR_BYTES]],
    rows: Range<usize>,
    right: &[[u8; DESCRIPTOR_BYTES]],
) -> (Vec<Top>, Vec<Top>) {
    let columns = Columns::new(right);
    let groups = columns.start.len();
    let blocks: Vec<Rows> = left[rows.clone()].chunks(ROWS).map(Rows::new).collect();
    let mut of_left = vec![[Top::NONE; ROWS]; blocks.len()];
    let mut of_right = Reverse { best: vec![[[Top::NONE.best; 4]; 2]; groups], index: vec![[[u32::MAX; 4]; 2]; groups] };
    for chunk in (0..groups).step_by(CHUNK) {
        for (block, (own, tops)) in blocks.iter().zip(&mut of_left).enumerate() {
            for group in chunk..groups.min(chunk + CHUNK) {
                let values = columns.values[group * PAIRS..].first_chunk::<PAIRS>().expect("each group has all pairs");
                let sums = own.sums(values, &columns.start[group]);
                if news(&sums, tops, &of_right.best[group]) {
                    note(&sums, tops, group);
                    of_right.note(&sums, group, rows.start + block * ROWS);
                }
            }
        }
    }
    let left_tops = of_left.into_iter().flatten().take(rows.len()).collect();
    (left_tops, of_right.tops(right.len()))
}

/// Whether any sum changes what is known: after the first few blocks this is rare.
#[inline(always)]
fn news(sums: &[[Whole; 2]; ROWS], tops: &[Top; ROWS], of_right: &[[i32; 4]; 2]) -> bool {
    let for_left = sums.iter().zip(tops).map(|(sum, top)| sum[0].max(sum[1]).exceeds(Whole::splat(top.second)));
    let for_right = of_right.iter().enumerate().map(|(half, best)| {
        let largest = sums[0][half].max(sums[1][half]).max(sums[2][half].max(sums[3][half]));
        largest.exceeds(Whole::load(best))
    });
    for_left.chain(for_right).reduce(Whole::or).is_some_and(Whole::any)
}

fn note(sums: &[[Whole; 2]; ROWS], tops: &mut [Top; ROWS], group: usize) {
    for (sum, top) in sums.iter().zip(tops) {
        for (place, value) in sum.iter().flat_map(|half| half.to_array()).enumerate() {
            top.meet(value, group * GROUP + place);
        }
    }
}

/// The nearest left descriptors of the right ones.
struct Reverse {
    best: Vec<[[i32; 4]; 2]>,
    index: Vec<[[u32; 4]; 2]>,
}

impl Reverse {
    fn note(&mut self, sums: &[[Whole; 2]; ROWS], group: usize, first_row: usize) {
        let (best, index) = (&mut self.best[group], &mut self.index[group]);
        for (row, sum) in sums.iter().enumerate() {
            for (half, values) in sum.iter().map(|half| half.to_array()).enumerate() {
                for lane in 0..4 {
                    // Rows come in ascending order, so that of equal ones the first stays.
                    if values[lane] > best[half][lane] {
                        best[half][lane] = values[lane];
                        index[half][lane] = (first_row + row) as u32;
                    }
                }
            }
        }
    }

    fn tops(self, count: usize) -> Vec<Top> {
        let all = self.best.into_iter().flatten().flatten().zip(self.index.into_iter().flatten().flatten());
        all.take(count).map(|(best, index)| Top { best, second: Top::NONE.second, index }).collect()
    }
}

fn square(descriptor: &[u8; DESCRIPTOR_BYTES]) -> i32 {
    descriptor.iter().map(|v| i32::from(*v) * i32::from(*v)).sum()
}

/// d² of two descriptors.
pub(super) fn square_distance(a: &[u8; DESCRIPTOR_BYTES], b: &[u8; DESCRIPTOR_BYTES]) -> u32 {
    a.iter().zip(b).map(|(a, b)| u32::from(a.abs_diff(*b)) * u32::from(a.abs_diff(*b))).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test;

    /// Few different bytes, so that many distances are equal; every ninth descriptor is the brightest there is.
    fn descriptors(count: usize, seed: u32, values: usize) -> Vec<[u8; DESCRIPTOR_BYTES]> {
        let mut random = Random::new(seed);
        (0..count)
            .map(|k| std::array::from_fn(|_| if k % 9 == 8 { 255 } else { (random.below(values) * 255 / (values - 1)) as u8 }))
            .collect()
    }

    /// The definition: each distance by itself.
    fn plain(one: &[u8; DESCRIPTOR_BYTES], others: &[[u8; DESCRIPTOR_BYTES]]) -> Top {
        let mut top = Top::NONE;
        others.iter().enumerate().for_each(|(index, other)| top.meet(-(square_distance(one, other) as i32), index));
        top
    }

    /// Natively this looks at the plain quads, in WebAssembly at those of SIMD.
    #[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
    #[cfg_attr(not(target_arch = "wasm32"), test)]
    fn blocks_find_what_the_definition_finds() {
        for (left, right, values) in [(1, 1, 2), (3, 7, 256), (4, 8, 2), (37, 61, 3), (90, 600, 256), (0, 5, 2), (5, 0, 2)] {
            let (a, b) = (descriptors(left, 3, values), descriptors(right, 4, values));
            let (of_left, of_right) = nearest_in_blocks(&a, 0..left, &b);
            assert_eq!(of_left, a.iter().map(|one| plain(one, &b)).collect::<Vec<_>>(), "{left} x {right}");
            let reverse: Vec<_> = b.iter().map(|one| plain(one, &a)).map(|top| (top.best, top.index)).collect();
            assert_eq!(of_right.iter().map(|top| (top.best, top.index)).collect::<Vec<_>>(), reverse, "{left} x {right}");
        }
    }
}
