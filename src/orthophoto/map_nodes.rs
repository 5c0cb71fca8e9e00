//! Places of the map of a block as those of its adjustment, interpolated between nodes that are converted exactly: a mosaic has up to 4000 million
//! pixels, and each conversion takes microseconds.

use super::block_map::BlockMap;
use crate::Georeference;

/// Radius of the earth in m.
const EARTH_M: f64 = 6.37e6;
/// Interpolated places differ by no more than this share of a pixel, or by as much as conversions are rounded, in m.
const MOST_PX: f64 = 0.005;
const ROUNDING_M: f64 = 2e-4;
/// Nodes are no nearer to each other than this, in px.
const LEAST_STEP_PX: f64 = 4.0;

/// Nodes over the pixels of a picture of the map.
///
/// Between nodes that are L apart, bilinear interpolation leaves out the curvature of the earth, L² / (8 R) along each axis: L = √(4 R · 0.005 px) keeps
/// both together below 0.005 px, 80 m at a pixel of 5 cm. Projections whose scale changes quickly bend the plane as well: where the middles of
/// cells are farther off, L is halved. Along the vertical of the ellipsoid places are linear in their height.
pub(super) struct MapNodes {
    georeference: Georeference,
    step_px: f64,
    columns: usize,
    /// Heights of the map at which each node is converted.
    levels: [f64; 2],
    /// Row by row, at both levels.
    places: Vec<Option<[[f64; 3]; 2]>>,
}

impl MapNodes {
    /// Over a picture of this size on ground between these heights.
    pub fn new(map: &BlockMap, georeference: Georeference, size: [usize; 2], [low, high]: [f64; 2]) -> Self {
        let gsd_m = map.unit_m * georeference.gsd();
        let most_m = (MOST_PX * gsd_m).max(ROUNDING_M);
        let longest = size[0].max(size[1]).max(1) as f64;
        let mut step_px = ((4.0 * EARTH_M * most_m).sqrt() / gsd_m).clamp(LEAST_STEP_PX, longest.max(LEAST_STEP_PX));
        let levels = [low, high.max(low + 1.0)];
        loop {
            let nodes = Self::of_step(map, georeference, size, levels, step_px);
            if nodes.error_m(map) <= most_m || step_px <= LEAST_STEP_PX {
                return nodes;
            }
            step_px = (0.5 * step_px).max(LEAST_STEP_PX);
        }
    }

    fn of_step(map: &BlockMap, georeference: Georeference, size: [usize; 2], levels: [f64; 2], step_px: f64) -> Self {
        let [columns, rows] = size.map(|side| (side as f64 / step_px).ceil().max(1.0) as usize + 1);
        let node = |k: usize| {
            let [x, y] = georeference.ground([(k % columns) as f64 * step_px, (k / columns) as f64 * step_px]);
            Some([map.to_adjustment([x, y, levels[0]])?, map.to_adjustment([x, y, levels[1]])?])
        };
        Self { georeference, step_px, columns, levels, places: (0..columns * rows).map(node).collect() }
    }

    /// Of a place on the picture; absent beside it, and where a node about it is outside the system.
    pub fn at(&self, place: [f64; 3]) -> Option<[f64; 3]> {
        let along = self.georeference.pixel([place[0], place[1]]).map(|v| v / self.step_px);
        let rows = self.places.len() / self.columns;
        let cell = |k: usize, nodes: usize| {
            let first = along[k].max(0.0).min((nodes - 2) as f64) as usize;
            (first, along[k] - first as f64)
        };
        let ((column, s), (row, t)) = (cell(0, self.columns), cell(1, rows));
        let u = (place[2] - self.levels[0]) / (self.levels[1] - self.levels[0]);
        let mut sum = [0.0; 3];
        for (c, r, share) in [(0, 0, (1.0 - s) * (1.0 - t)), (1, 0, s * (1.0 - t)), (0, 1, (1.0 - s) * t), (1, 1, s * t)] {
            let [low, high] = self.places[(row + r) * self.columns + column + c]?;
            (0..3).for_each(|k| sum[k] += share * ((1.0 - u) * low[k] + u * high[k]));
        }
        Some(sum)
    }

    /// How far off the middles of cells are: of those in the corners and in the middle of the picture.
    fn error_m(&self, map: &BlockMap) -> f64 {
        let [columns, rows] = [self.columns - 1, self.places.len() / self.columns - 1];
        let cells = [[0, 0], [columns - 1, 0], [0, rows - 1], [columns - 1, rows - 1], [columns / 2, rows / 2]];
        let off = |cell: &[usize; 2]| {
            let [x, y] = self.georeference.ground(cell.map(|k| (k as f64 + 0.5) * self.step_px));
            let place = [x, y, 0.5 * (self.levels[0] + self.levels[1])];
            let (own, exact) = (self.at(place)?, map.to_adjustment(place)?);
            Some((0..3).map(|k| (own[k] - exact[k]) * (own[k] - exact[k])).sum::<f64>().sqrt())
        };
        cells.iter().filter_map(off).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;

    /// How far interpolated places are off at most, in px, at places all over a picture; `factor`: of the distance of its nodes.
    fn worst_px(crs: &str, origin: [f64; 3], gsd: f64, size: [usize; 2], factor: f64) -> f64 {
        let map = BlockMap::at(crs, origin);
        let [x, y, _] = map.to_map([0.0; 3]).unwrap();
        let georeference = Georeference::north_up([x - 0.5 * gsd * size[0] as f64, y + 0.5 * gsd * size[1] as f64], gsd);
        let range = [200.0, 900.0];
        let mut nodes = MapNodes::new(&map, georeference, size, range);
        if factor > 1.0 {
            nodes = MapNodes::of_step(&map, georeference, size, range, factor * nodes.step_px);
        }
        let mut random = Random::new(5);
        let mut share = || random.below(1 << 20) as f64 / f64::from(1 << 20);
        let mut off = |_: usize| {
            let [x, y] = georeference.ground(size.map(|side| side as f64 * share()));
            let place = [x, y, range[0] + (range[1] - range[0]) * share()];
            let (own, exact) = (nodes.at(place).unwrap(), map.to_adjustment(place).unwrap());
            (0..3).map(|k| (own[k] - exact[k]) * (own[k] - exact[k])).sum::<f64>().sqrt() / (gsd * map.unit_m)
        };
        (0..2000).map(&mut off).fold(0.0, f64::max)
    }

    #[test]
    fn places_between_nodes_are_exact_to_a_hundredth_of_a_pixel() {
        // 20 km of UTM, a mosaic of drone photos, feet of California, a projection whose scale grows quickly to the north, and small pixels, where
        // conversions are rounded to 0.1 mm.
        for (crs, origin, gsd, size, most_px) in [
            ("EPSG:25832", [7.0, 50.5, 240.0], 0.5, [40_000, 40_000], 0.01),
            ("EPSG:25832", [11.5, 48.1, 560.0], 0.05, [12_000, 8_000], 0.01),
            ("EPSG:2227", [-122.0, 37.5, 20.0], 0.5, [30_000, 20_000], 0.01),
            ("EPSG:3857", [15.0, 65.0, 100.0], 1.0, [10_000, 10_000], 0.01),
            ("EPSG:32614", [-99.0, 30.0, 300.0], 0.01, [10_000, 10_000], 0.02),
        ] {
            let worst = worst_px(crs, origin, gsd, size, 1.0);
            assert!(worst <= most_px, "{crs}: {worst} px");
        }
        // Nodes three times as far from each other would not do.
        let sparse = worst_px("EPSG:25832", [7.0, 50.5, 240.0], 0.5, [40_000, 40_000], 3.0);
        assert!(sparse > 0.02, "{sparse}");
    }

    #[test]
    fn places_outside_the_system_are_no_places() {
        let map = BlockMap::at("EPSG:25832", [9.0, 50.0, 0.0]);
        let nodes = MapNodes::of_step(&map, Georeference::north_up([4e7, 5e6], 1.0), [100, 100], [0.0, 1.0], 50.0);
        assert_eq!(nodes.at([4e7 + 10.0, 5e6 - 10.0, 0.0]), None);
    }
}
