//! What the blocks between the streets are used for, and the lots they are cut into.

use super::super::buckets::Rectangle;
use super::super::random::Random;
use super::streets::Streets;

/// The use of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Use {
    /// Small lots with a house each, divided by hedges.
    Houses,
    /// Few large lots with flat-roofed buildings, much of it paved.
    Trade,
    /// Grass and trees.
    Park,
}

/// One block: a rectangle in the street grid.
#[derive(Debug, Clone, Copy)]
pub(super) struct Block {
    pub(super) kind: Use,
    /// `[u_min, v_min, u_max, v_max]` in m, footways left out.
    pub(super) extent: Rectangle,
    /// Lots along u, in each of `rows` rows.
    pub(super) lots: usize,
    pub(super) rows: usize,
    /// Grey of its ground in full sun.
    pub(super) tone: f64,
    /// Size of the ground's mottling in grey values.
    pub(super) contrast: f64,
    pub(super) seed: u32,
}

impl Block {
    fn new(extent: Rectangle, random: &mut Random) -> Self {
        let draw = random.uniform();
        let kind = if draw < 0.66 {
            Use::Houses
        } else if draw < 0.9 {
            Use::Trade
        } else {
            Use::Park
        };
        let (lot_m, rows) = match kind {
            Use::Houses => (random.between(14.0, 20.0), 2),
            Use::Trade => (random.between(24.0, 40.0), if random.chance(0.5) { 1 } else { 2 }),
            Use::Park => (1e9, 1),
        };
        let lots = ((extent[2] - extent[0]) / lot_m).round().max(1.0) as usize;
        let tone = if kind == Use::Trade { random.between(90.0, 165.0) } else { random.between(84.0, 142.0) };
        let contrast = if kind == Use::Trade { random.between(10.0, 22.0) } else { random.between(26.0, 50.0) };
        Self { kind, extent, lots, rows, tone, contrast, seed: random.bits() }
    }

    /// Sides of a lot in m, along u and v.
    pub(super) fn lot_m(&self) -> [f64; 2] {
        let [u0, v0, u1, v1] = self.extent;
        [(u1 - u0) / self.lots as f64, (v1 - v0) / self.rows as f64]
    }

    /// The middles of its lots as `[u, v]`.
    pub(super) fn lot_middles(&self) -> impl Iterator<Item = [f64; 2]> + use<'_> {
        let [width, depth] = self.lot_m();
        let middle =
            move |lot: usize, row: usize| [self.extent[0] + (lot as f64 + 0.5) * width, self.extent[1] + (row as f64 + 0.5) * depth];
        (0..self.rows).flat_map(move |row| (0..self.lots).map(move |lot| middle(lot, row)))
    }
}

/// All blocks of the town, by the gaps of the lanes (fastest) and of the avenues.
pub(super) struct Blocks {
    per_row: usize,
    blocks: Vec<Block>,
}

impl Blocks {
    pub(super) fn new(streets: &Streets, random: &mut Random) -> Self {
        let (cols, rows) = (streets.lanes.gaps(), streets.avenues.gaps());
        let mut blocks = Vec::with_capacity(cols * rows);
        for row in 0..rows {
            for col in 0..cols {
                let ([u0, u1], [v0, v1]) = (streets.lanes.gap_m(col), streets.avenues.gap_m(row));
                blocks.push(Block::new([u0, v0, u1, v1], random));
            }
        }
        Self { per_row: cols, blocks }
    }

    /// The block at a gap of the lanes and a gap of the avenues.
    pub(super) fn at(&self, lane_gap: usize, avenue_gap: usize) -> &Block {
        &self.blocks[avenue_gap * self.per_row + lane_gap]
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = &Block> {
        self.blocks.iter()
    }
}
