//! How high a geoid lies above the ellipsoid, about a block.

use crate::math::turn;
use serde::{Deserialize, Serialize};

/// The part of a geoid about a block: how high it lies above the ellipsoid at the nodes of a grid, between which it is interpolated in both directions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
#[serde(deny_unknown_fields)]
pub struct Geoid {
    /// Of the file that it is from.
    pub name: String,
    /// Longitude and latitude of the first node in degrees.
    pub south_west_deg: [f64; 2],
    /// From a node to the next one east and north of it.
    pub step_deg: [f64; 2],
    /// Of a row: two or more.
    pub columns: usize,
    /// Row by row from the south, each from the west; two rows or more.
    pub heights_m: Vec<f32>,
}

impl Geoid {
    fn rows(&self) -> usize {
        self.heights_m.len() / self.columns.max(1)
    }

    /// Whether its numbers are those of a grid.
    pub(crate) fn is_whole(&self) -> bool {
        let numbers = self.south_west_deg.iter().chain(&self.step_deg);
        let is_grid = self.columns >= 2 && self.rows() >= 2 && self.rows() * self.columns == self.heights_m.len();
        is_grid
            && numbers.clone().all(|v| v.is_finite())
            && self.step_deg.iter().all(|v| *v > 0.0 && *v <= 180.0)
            && self.heights_m.iter().all(|v| v.is_finite())
    }

    /// Its height above the ellipsoid at a longitude and latitude in degrees, in m; beyond its edges that of the edge, since only a place that is
    /// wrong lies there.
    pub(crate) fn above_m(&self, [longitude, latitude]: [f64; 2]) -> f64 {
        // Longitudes count from the middle: 359° east of its edge is 1° west of it.
        let half_width = 0.5 * (self.columns - 1) as f64 * self.step_deg[0];
        let east = turn(longitude - self.south_west_deg[0] - half_width) + half_width;
        let [column, to_east] = between(east / self.step_deg[0], self.columns);
        let [row, to_north] = between((latitude - self.south_west_deg[1]) / self.step_deg[1], self.rows());
        let node = |column: f64, row: f64| f64::from(self.heights_m[row as usize * self.columns + column as usize]);
        let along = |row: f64| node(column, row) + to_east * (node(column + 1.0, row) - node(column, row));
        along(row) + to_north * (along(row + 1.0) - along(row))
    }
}

/// The node before a position that counts in nodes, and how far behind it that is, 0..1.
fn between(position: f64, nodes: usize) -> [f64; 2] {
    let last = (nodes - 1) as f64;
    let position = position.clamp(0.0, last);
    let first = position.floor().min(last - 1.0);
    [first, position - first]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_geoid_is_interpolated_between_its_nodes_and_its_edge_holds_beyond() {
        let geoid = Geoid {
            name: "small.gtx".into(),
            south_west_deg: [179.5, 50.0],
            step_deg: [0.5, 0.25],
            columns: 3,
            heights_m: vec![40.0, 41.0, 42.0, 44.0, 45.0, 46.0],
        };
        assert!(geoid.is_whole());
        for (place, height) in [
            ([179.5, 50.0], 40.0),
            ([180.0, 50.125], 43.0),
            ([-179.75, 50.25], 45.5),
            ([180.25, 50.25], 45.5),
            ([-179.0, 50.0], 42.0),
            ([179.0, 49.0], 40.0),
        ] {
            assert!((geoid.above_m(place) - height).abs() < 1e-9, "{place:?}: {}", geoid.above_m(place));
        }
        for broken in [
            Geoid { columns: 0, ..geoid.clone() },
            Geoid { columns: 6, ..geoid.clone() },
            Geoid { columns: 4, ..geoid.clone() },
            Geoid { step_deg: [0.0, 1.0], ..geoid.clone() },
        ] {
            assert!(!broken.is_whole(), "{broken:?}");
        }
    }
}
