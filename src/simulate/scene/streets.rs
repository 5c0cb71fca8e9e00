//! The street grid: two families of parallel streets with blocks between them.

use super::super::buckets::Rectangle;
use super::super::random::Random;
use super::axes::Axes;

/// One street, by its centre line.
#[derive(Debug, Clone, Copy)]
pub(super) struct Street {
    /// Place of the centre line across the family's direction, in m.
    pub(super) centre_m: f64,
    /// Half the width of the carriageway in m.
    pub(super) half_width_m: f64,
    /// Grey of the asphalt in full sun.
    pub(super) tone: f64,
}

/// Parallel streets at irregular distances, one in every stretch of `spacing_m`.
pub(super) struct Family {
    start_m: f64,
    spacing_m: f64,
    streets: Vec<Street>,
}

/// Where a place lies in a family.
#[derive(Debug, Clone, Copy)]
pub(super) struct Crossing {
    /// Index of the nearest street that may be under the place.
    pub(super) street: usize,
    /// Signed distance from its centre line in m.
    pub(super) offset_m: f64,
    /// Index of the gap between streets: gap k lies between streets k and k + 1.
    pub(super) gap: usize,
}

impl Family {
    fn new(low_m: f64, high_m: f64, spacing_m: f64, half_widths_m: [f64; 2], random: &mut Random) -> Self {
        let start_m = low_m - 2.0 * spacing_m;
        let count = ((high_m - low_m) / spacing_m).ceil() as usize + 4;
        let streets = (0..count)
            .map(|k| Street {
                centre_m: start_m + (k as f64 + random.between(0.35, 0.65)) * spacing_m,
                half_width_m: random.between(half_widths_m[0], half_widths_m[1]),
                tone: random.between(52.0, 78.0),
            })
            .collect();
        Self { start_m, spacing_m, streets }
    }

    pub(super) fn street(&self, index: usize) -> &Street {
        &self.streets[index]
    }

    /// Number of gaps between streets.
    pub(super) fn gaps(&self) -> usize {
        self.streets.len() - 1
    }

    /// The ends of a gap, kerbs and footways left out, in m.
    pub(super) fn gap_m(&self, gap: usize) -> [f64; 2] {
        let (before, after) = (&self.streets[gap], &self.streets[gap + 1]);
        [before.centre_m + before.half_width_m + FOOTWAY_M, after.centre_m - after.half_width_m - FOOTWAY_M]
    }

    /// Where a coordinate across the streets lies.
    pub(super) fn locate(&self, across_m: f64) -> Crossing {
        let stretch = (across_m - self.start_m) / self.spacing_m;
        let street = (stretch.max(0.0) as usize).min(self.streets.len() - 1);
        let offset_m = across_m - self.streets[street].centre_m;
        let gap = if offset_m < 0.0 { street.saturating_sub(1) } else { street.min(self.gaps() - 1) };
        Crossing { street, offset_m, gap }
    }
}

/// Width of a footway in m.
pub(super) const FOOTWAY_M: f64 = 1.9;

/// The town's streets. `u` runs along the avenues, `v` along the lanes.
pub(super) struct Streets {
    pub(super) axes: Axes,
    /// Wide streets along u, at places in v.
    pub(super) avenues: Family,
    /// Narrower streets along v, at places in u.
    pub(super) lanes: Family,
}

impl Streets {
    /// A grid over `area`, turned by a random angle.
    pub(super) fn new(area: Rectangle, random: &mut Random) -> Self {
        let axes = Axes::new([0.5 * (area[0] + area[2]), 0.5 * (area[1] + area[3])], random.between(0.2, 0.4));
        let (half_x, half_y) = (0.5 * (area[2] - area[0]), 0.5 * (area[3] - area[1]));
        let reach = |c: f64, s: f64| c.abs() * half_x + s.abs() * half_y;
        let (u, v) = (reach(axes.cos, axes.sin), reach(axes.sin, axes.cos));
        Self { axes, avenues: Family::new(-v, v, 62.0, [4.5, 6.5], random), lanes: Family::new(-u, u, 84.0, [3.0, 4.2], random) }
    }
}
