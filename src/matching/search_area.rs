//! Where a window is searched, and which positions of it lie within the image.

use crate::GreyView;
use std::ops::Range;

/// Where a window is searched: the positions of its centre pixel. Positions whose window leaves the image are left out.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SearchArea<'a> {
    /// Column and row of the middle, which may lie outside the image.
    pub centre: [i64; 2],
    /// Px searched on either side in x and in y.
    pub reach: [usize; 2],
    /// For each row of positions, from the top one of the area (outside the image or not), the columns that are candidates;
    /// without it all of them, as along an epipolar line only some. A row beyond the end of the list has none.
    pub columns: Option<&'a [Range<i64>]>,
}

/// The positions within the image: column and row of the first, and their number.
#[derive(Clone, Copy)]
pub(super) struct Extent {
    pub first: [usize; 2],
    pub number: [usize; 2],
}

/// The positions of an area at which a window lies inside the image; `None` where there are none.
pub(super) fn extent(side: usize, image: GreyView<'_>, area: &SearchArea<'_>) -> Option<Extent> {
    let along = |axis: usize, length: usize| {
        let (first, last) = ((side / 2) as i64, length as i64 - 1 - (side / 2) as i64);
        let reach = i64::try_from(area.reach[axis]).unwrap_or(i64::MAX);
        let (start, end) = (area.centre[axis].saturating_sub(reach).max(first), area.centre[axis].saturating_add(reach).min(last));
        (start <= end).then(|| (start as usize, (end - start) as usize + 1))
    };
    let (x, y) = (along(0, image.width())?, along(1, image.height())?);
    Some(Extent { first: [x.0, y.0], number: [x.1, y.1] })
}

/// For each row of positions inside the image, the columns that are candidates, counted from the first inside the image.
pub(super) fn allowed<'a>(area: &SearchArea<'a>, extent: Extent) -> impl Fn(usize) -> Range<usize> + use<'a> {
    let reach = i64::try_from(area.reach[1]).unwrap_or(i64::MAX);
    let above = (extent.first[1] as i64).saturating_sub(area.centre[1].saturating_sub(reach));
    let columns = area.columns;
    move |y| {
        let Some(columns) = columns else { return 0..extent.number[0] };
        let given = usize::try_from(above).ok().and_then(|above| columns.get(above.saturating_add(y))).cloned().unwrap_or(0..0);
        let within = |column: i64| column.saturating_sub(extent.first[0] as i64).clamp(0, extent.number[0] as i64) as usize;
        let (start, end) = (within(given.start), within(given.end));
        start..end.max(start)
    }
}

/// The rows from the first to the last that allow a column.
pub(super) fn rows_that_allow(column: usize, height: usize, allowed: &impl Fn(usize) -> Range<usize>) -> Range<usize> {
    let allows = |y: &usize| allowed(*y).contains(&column);
    match ((0..height).find(allows), (0..height).rfind(allows)) {
        (Some(first), Some(last)) => first..last + 1,
        _ => 0..0,
    }
}
