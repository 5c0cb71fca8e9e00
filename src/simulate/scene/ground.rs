//! What the ground looks like: carriageways with marks and cars, footways, lawns, hedges, yards.

use super::super::lattice::{cell, fractal, hash, hash_unit, unit, value};
use super::blocks::{Block, Blocks, Use};
use super::streets::{Crossing, FOOTWAY_M, Family, Streets};

/// Whether a place of the ground is under a car that drives, after any of the given ways.
pub(super) fn is_under_moving_car(streets: &Streets, x: f64, y: f64, driven_m: [f64; 2]) -> bool {
    let [u, v] = streets.axes.to_local(x, y);
    let (avenue, lane) = (streets.avenues.locate(v), streets.lanes.locate(u));
    let half_width = |family: &Family, crossing: &Crossing| family.street(crossing.street).half_width_m;
    let [of_avenue, of_lane] = [half_width(&streets.avenues, &avenue), half_width(&streets.lanes, &lane)];
    let (on_avenue, on_lane) = (avenue.offset_m.abs() < of_avenue, lane.offset_m.abs() < of_lane);
    let (half_width_m, crossing, along_m) = match (on_avenue, on_lane) {
        (true, false) => (of_avenue, avenue, u),
        (false, true) => (of_lane, lane, v),
        _ => return false,
    };
    let drives = half_width_m - crossing.offset_m.abs() >= PARKED_M;
    drives && driven_m.into_iter().any(|driven_m| car_tone(half_width_m, &crossing, along_m, driven_m).is_some())
}

/// Grey of the ground in full sun at a place, cars in the lanes having driven a way.
pub(super) fn tone(streets: &Streets, blocks: &Blocks, x: f64, y: f64, driven_m: f64) -> f64 {
    let [u, v] = streets.axes.to_local(x, y);
    let (avenue, lane) = (streets.avenues.locate(v), streets.lanes.locate(u));
    let beside = |family: &Family, crossing: &Crossing| crossing.offset_m.abs() - family.street(crossing.street).half_width_m;
    let (from_avenue, from_lane) = (beside(&streets.avenues, &avenue), beside(&streets.lanes, &lane));
    if from_avenue < 0.0 {
        carriageway(&streets.avenues, &avenue, u, from_lane < 0.0, driven_m)
    } else if from_lane < 0.0 {
        carriageway(&streets.lanes, &lane, v, false, driven_m)
    } else if from_avenue.min(from_lane) < FOOTWAY_M {
        152.0 + 14.0 * value(0.2 * u, 0.2 * v, 11)
    } else {
        block_tone(blocks.at(lane.gap, avenue.gap), u, v)
    }
}

/// Asphalt, the dashed centre line, and cars; `along_m` runs along the street. Junctions have neither line nor cars.
fn carriageway(family: &Family, crossing: &Crossing, along_m: f64, junction: bool, driven_m: f64) -> f64 {
    let street = family.street(crossing.street);
    let asphalt = street.tone + 7.0 * fractal(along_m, crossing.offset_m, 6.0, 2, 0.9, crossing.street as u32);
    if junction {
        return asphalt;
    }
    if let Some(car) = car_tone(street.half_width_m, crossing, along_m, driven_m) {
        return car;
    }
    let dash = crossing.offset_m.abs() < 0.3 && (along_m / 9.0 - (along_m / 9.0).floor()) < 0.42;
    if dash { 165.0 } else { asphalt }
}

/// Nearer to the kerb than this cars are parked, in m.
const PARKED_M: f64 = 2.2;

/// The grey of a car, where one stands at the kerb or drives in a lane, to the right on either side, a way after the first exposure.
fn car_tone(half_width_m: f64, crossing: &Crossing, along_m: f64, driven_m: f64) -> Option<f64> {
    let side = u32::from(crossing.offset_m > 0.0);
    let from_kerb = half_width_m - crossing.offset_m.abs();
    let parked = from_kerb < PARKED_M;
    let (spacing_m, share, middle) = if parked { (6.5, 0.24, 1.2) } else { (19.0, 0.2, 0.5 * half_width_m + 0.9) };
    let moved_m = if parked { 0.0 } else { driven_m * (1.0 - 2.0 * f64::from(side)) };
    let (slot, place) = cell((along_m + moved_m) / spacing_m);
    let bits = hash(slot, crossing.street as i32, 70 + side + 2 * u32::from(parked));
    if unit(bits) > share || (from_kerb - middle).abs() > 0.95 || (place - 0.5).abs() * spacing_m > 2.2 {
        return None;
    }
    Some(if bits & 1 == 0 { 28.0 + f64::from((bits >> 4) & 31) } else { 110.0 + f64::from((bits >> 4) & 127) })
}

fn block_tone(block: &Block, u: f64, v: f64) -> f64 {
    let mottled = block.tone + block.contrast * fractal(u, v, 16.0, 3, 0.7, block.seed);
    match block.kind {
        Use::Park => shrubs(mottled, u, v, 0.25, block.seed),
        Use::Houses => hedge_or(block, u, v, || shrubs(mottled, u, v, 0.22, block.seed)),
        Use::Trade => parking(block, mottled, u, v),
    }
}

/// Dark round spots of one to three metres, at most one in each cell of 6 m.
fn shrubs(ground: f64, u: f64, v: f64, share: f64, seed: u32) -> f64 {
    let ((col, s), (row, t)) = (cell(u / 6.0), cell(v / 6.0));
    let bits = hash(col, row, seed ^ 0x51);
    if unit(bits) > share {
        return ground;
    }
    let part = |shift: u32| f64::from((bits >> shift) & 63) / 63.0;
    let (du, dv, radius) = (6.0 * (s - 0.3 - 0.4 * part(2)), 6.0 * (t - 0.3 - 0.4 * part(8)), 0.7 + 1.1 * part(14));
    if du * du + dv * dv < radius * radius { 38.0 + 30.0 * part(20) } else { ground }
}

/// A hedge on the borders of the lots, where the neighbours have planted one.
fn hedge_or(block: &Block, u: f64, v: f64, lot: impl Fn() -> f64) -> f64 {
    let [width, depth] = block.lot_m();
    let (along, across) = ((u - block.extent[0]) / width, (v - block.extent[1]) / depth);
    let (border, row) = (along.round(), across.floor());
    let side = (along - border).abs() * width < 0.55 && hash_unit(border as i32, row as i32, block.seed) < 0.55;
    let back = (across - across.round()).abs() * depth < 0.55 && hash_unit(along.floor() as i32, 99, block.seed) < 0.5;
    if side || back { 52.0 + 14.0 * value(0.6 * u, 0.6 * v, block.seed) } else { lot() }
}

/// Marked bays in the part of a trade block that is a car park, some of them taken.
fn parking(block: &Block, ground: f64, u: f64, v: f64) -> f64 {
    let ((bay, s), (row, t)) = (cell(u / 2.7), cell((v - block.extent[1]) / 5.4));
    if row.rem_euclid(3) == 1 || hash_unit(0, row.div_euclid(3), block.seed) > 0.6 {
        return ground;
    }
    let bits = hash(bay, row, block.seed ^ 0x7A);
    if (s - 0.5).abs() < 0.34 && (t - 0.5).abs() < 0.41 && unit(bits) < 0.4 {
        return 30.0 + 1.5 * f64::from((bits >> 3) & 127);
    }
    if (s - 0.5).abs() > 0.45 { ground + 45.0 } else { ground }
}
