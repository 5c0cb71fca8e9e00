//! Puts buildings on lots and trees between them.

use super::super::buckets::{Buckets, Rectangle};
use super::super::flight::Flight;
use super::super::random::{Random, Stream};
use super::axes::Axes;
use super::blocks::{Block, Blocks, Use};
use super::building::Building;
use super::river::River;
use super::solid::Solid;
use super::streets::Streets;
use super::terrain::Terrain;
use super::tree::Tree;
use crate::math;
use nalgebra::Vector3;

/// The ground on which is built.
pub(super) struct Site<'a> {
    pub(super) area: Rectangle,
    pub(super) terrain: &'a Terrain,
    pub(super) streets: &'a Streets,
    pub(super) blocks: &'a Blocks,
    pub(super) river: Option<&'a River>,
}

impl Site<'_> {
    /// As many buildings as the flight wants, or as there are lots, on lots chosen at random.
    pub(super) fn buildings(&self, flight: &Flight) -> Vec<Building> {
        let mut random = Random::new(flight.seed, Stream::Buildings);
        let built = self.blocks.iter().filter(|block| block.kind != Use::Park);
        let mut lots: Vec<_> = built.flat_map(|block| block.lot_middles().map(move |middle| (block, middle))).collect();
        lots.retain(|(_, middle)| inside(&self.area, self.ground(*middle)) && self.is_dry(self.ground(*middle), BUILDING_FROM_BANK_M));
        math::Random::new(random.bits()).shuffle(&mut lots);
        lots.truncate(flight.buildings);
        lots.iter().map(|(block, middle)| self.building(flight, block, *middle, &mut random)).collect()
    }

    /// Whether a place lies at least so far from the river's bank.
    fn is_dry(&self, [x, y]: [f64; 2], bank_distance_m: f64) -> bool {
        self.river.is_none_or(|river| river.bank_distance_m(x, y) >= bank_distance_m)
    }

    fn ground(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        self.streets.axes.to_ground(u, v)
    }

    fn building(&self, flight: &Flight, block: &Block, [u, v]: [f64; 2], random: &mut Random) -> Building {
        let lot = block.lot_m();
        let house = block.kind == Use::Houses;
        let sides = lot.map(|side| if house { (side - 3.0).min(random.between(8.0, 15.0)) } else { side * random.between(0.45, 0.8) });
        let free = [0, 1].map(|axis| 0.5 * (lot[axis] - sides[axis] - 2.0).max(0.0));
        let middle = [u + free[0] * random.between(-1.0, 1.0), v + free[1] * random.between(-1.0, 1.0)];
        let origin = self.ground(middle);
        let base_m = self.terrain.at(origin[0], origin[1]).point.z;
        let eaves_m = base_m + storeys([flight.lowest_building_m, flight.highest_building_m], house, random);
        let (axes, half_m) = along_the_longer_side(self.streets.axes.moved(origin), sides.map(|side| 0.5 * side));
        let gabled = random.chance(if house { 0.8 } else { 0.12 });
        Building {
            axes,
            half_m,
            base_m,
            eaves_m,
            pitch: if gabled { random.between(0.3, 0.6) } else { 0.0 },
            roof_tone: if gabled { random.pick(&GABLE_TONES) } else { random.pick(&FLAT_TONES) } + random.between(-10.0, 10.0),
            wall_tone: random.between(95.0, 190.0),
            seed: random.bits(),
        }
    }

    /// Trees at random places that are neither street nor house.
    pub(super) fn trees(&self, flight: &Flight, buildings: &[Building]) -> Vec<Tree> {
        let mut random = Random::new(flight.seed, Stream::Trees);
        let extents: Vec<Rectangle> = buildings.iter().map(crown_room).collect();
        let built = Buckets::new(self.area, 16.0, &extents);
        let free = |x: f64, y: f64| {
            let clear = |&index: &u32| !inside(&extents[index as usize], [x, y]);
            built.at(x, y).iter().all(clear) && !self.is_street(x, y) && self.is_dry([x, y], TREE_FROM_BANK_M)
        };
        (0..flight.trees)
            .filter_map(|_| {
                let [x0, y0, x1, y1] = self.area;
                let tree = self.tree(random.between(x0, x1), random.between(y0, y1), &mut random);
                free(tree.centre.x, tree.centre.y).then_some(tree)
            })
            .collect()
    }

    fn tree(&self, x: f64, y: f64, random: &mut Random) -> Tree {
        let radius_m = random.between(1.6, 4.2);
        let z = self.terrain.at(x, y).point.z + radius_m * random.between(0.7, 1.3);
        Tree { centre: Vector3::new(x, y, z), radius_m, tone: random.between(45.0, 80.0), seed: random.bits() }
    }

    fn is_street(&self, x: f64, y: f64) -> bool {
        let [u, v] = self.streets.axes.to_local(x, y);
        [(&self.streets.avenues, v), (&self.streets.lanes, u)].iter().any(|(family, across)| {
            let crossing = family.locate(*across);
            crossing.offset_m.abs() < family.street(crossing.street).half_width_m + 0.5
        })
    }
}

/// How far from the river's bank the middle of a building and a trunk stand at least, in m.
const BUILDING_FROM_BANK_M: f64 = 18.0;
const TREE_FROM_BANK_M: f64 = 2.0;

/// Greys of roofs: tiles and slate; bitumen, gravel and metal.
const GABLE_TONES: [f64; 6] = [58.0, 78.0, 100.0, 128.0, 165.0, 205.0];
const FLAT_TONES: [f64; 6] = [45.0, 88.0, 135.0, 175.0, 210.0, 238.0];

/// Height of the eaves above the ground: houses take the lower third of the range, high trade buildings are rare.
fn storeys([lowest, highest]: [f64; 2], house: bool, random: &mut Random) -> f64 {
    let draw = random.uniform();
    lowest + (highest - lowest) * if house { 0.3 * draw } else { 0.15 + 0.85 * draw * draw }
}

/// Turns a ground plan by a right angle where that brings its longer side, and so the ridge, along u.
fn along_the_longer_side(axes: Axes, [half_u, half_v]: [f64; 2]) -> (Axes, [f64; 2]) {
    if half_u >= half_v {
        return (axes, [half_u, half_v]);
    }
    (Axes { cos: -axes.sin, sin: axes.cos, ..axes }, [half_v, half_u])
}

/// Where no trunk may stand: the ground plan and 2 m around.
fn crown_room(building: &Building) -> Rectangle {
    let bounds = building.bounds(building.base_m);
    [bounds.low.x - 2.0, bounds.low.y - 2.0, bounds.high.x + 2.0, bounds.high.y + 2.0]
}

fn inside(area: &Rectangle, [x, y]: [f64; 2]) -> bool {
    x >= area[0] && y >= area[1] && x <= area[2] && y <= area[3]
}

/// Buildings, then trees.
pub(super) fn solids(site: &Site<'_>, flight: &Flight) -> Vec<Solid> {
    let buildings = site.buildings(flight);
    let trees = site.trees(flight, &buildings);
    buildings.into_iter().map(Solid::Building).chain(trees.into_iter().map(Solid::Tree)).collect()
}
