//! Where a picture of the ground shows nothing: beyond what was photographed.

/// A pixel shows nothing where all about it so far, in px, have the value of nothing: single black pixels are shadows.
const REACH: usize = 4;
/// Points within so many px of where nothing is shown are the edge of the picture.
const EDGE: usize = 8;
/// What is asked of a pixel follows from those about it so far.
pub(super) const SEEN_FROM: usize = 2 * REACH + EDGE;

/// Where pixels of nothing are the outside of the picture, with its edge; absent where there is none. Row by row. `halvings` of the picture, with which
/// both lengths are halved.
pub(super) fn outside(nothing: &[bool], width: usize, height: usize, halvings: u32) -> Option<Vec<bool>> {
    if !nothing.contains(&true) {
        return None;
    }
    // Shrunk to the middles of what is empty, and grown again by that and the edge.
    let [reach, edge] = [(REACH >> halvings.min(8)).max(1), EDGE >> halvings.min(8)];
    let inner = spread(nothing, width, height, reach, true);
    inner.contains(&true).then(|| spread(&inner, width, height, reach + edge, false))
}

/// For each pixel whether all (or any) of the square about it are set; beyond the edges counts as set for all, as not set for any.
fn spread(set: &[bool], width: usize, height: usize, reach: usize, all: bool) -> Vec<bool> {
    let settled = |count: u32| if all { count == 0 } else { count > 0 };
    // How many of the window differ from what decides alone.
    let decides = |set: bool| u32::from(set != all);
    let mut rows = vec![false; set.len()];
    for (row, out) in set.chunks_exact(width).zip(rows.chunks_exact_mut(width)) {
        let mut count: u32 = row.iter().take(reach).map(|set| decides(*set)).sum();
        for k in 0..width {
            count += row.get(k + reach).map_or(0, |set| decides(*set));
            out[k] = settled(count);
            count -= k.checked_sub(reach).map_or(0, |gone| decides(row[gone]));
        }
    }
    // Down the columns all at once: the memory is walked row by row.
    let row_of = |r: usize| &rows[r * width..(r + 1) * width];
    let mut counts = vec![0_u32; width];
    let add = |counts: &mut [u32], r: usize| counts.iter_mut().zip(row_of(r)).for_each(|(count, set)| *count += decides(*set));
    (0..reach.min(height)).for_each(|r| add(&mut counts, r));
    let mut columns = vec![false; set.len()];
    for (r, out) in columns.chunks_exact_mut(width).enumerate() {
        if r + reach < height {
            add(&mut counts, r + reach);
        }
        out.iter_mut().zip(&counts).for_each(|(out, count)| *out = settled(*count));
        if let Some(gone) = r.checked_sub(reach) {
            counts.iter_mut().zip(row_of(gone)).for_each(|(count, set)| *count -= decides(*set));
        }
    }
    columns
}
