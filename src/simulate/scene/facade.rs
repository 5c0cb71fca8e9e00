//! What buildings look like: roofs with plant, rims, ridges and chimneys; walls with windows.

use super::super::lattice::{cell, hash, hash_unit, unit, value};
use super::building::{Building, Face, ROOF};
use nalgebra::Vector3;

/// Grey of a building's face in full sun at a point of it.
pub(super) fn tone(building: &Building, face: Face, point: Vector3<f64>) -> f64 {
    let [u, v] = building.axes.to_local(point.x, point.y);
    if face >= ROOF {
        let grain = 0.06 * building.roof_tone * value(0.45 * u, 0.45 * v, building.seed);
        grain + if building.pitch > 0.0 { gable(building, u, v) } else { flat_roof(building, u, v) }
    } else {
        let along = if face < 2 { v } else { u };
        wall(building, along, point.z - building.base_m)
    }
}

/// A bright ridge, and a chimney or skylight in some cells of 4 m.
fn gable(building: &Building, u: f64, v: f64) -> f64 {
    if v.abs() < 0.3 {
        return building.roof_tone + 18.0;
    }
    object(building, u, v, 0.22).unwrap_or(building.roof_tone)
}

/// A parapet around, and plant or skylights in some cells of 4 m.
fn flat_roof(building: &Building, u: f64, v: f64) -> f64 {
    let inside = (building.half_m[0] - u.abs()).min(building.half_m[1] - v.abs());
    if inside < 0.7 {
        return if building.seed & 1 == 0 { 0.72 * building.roof_tone } else { (building.roof_tone + 35.0).min(235.0) };
    }
    object(building, u, v, 0.3).unwrap_or(building.roof_tone)
}

/// The grey of a thing on the roof, where there is one.
fn object(building: &Building, u: f64, v: f64, share: f64) -> Option<f64> {
    let ((col, s), (row, t)) = (cell(u / 4.0), cell(v / 4.0));
    let bits = hash(col, row, building.seed);
    if unit(bits) > share {
        return None;
    }
    let part = |shift: u32| f64::from((bits >> shift) & 31) / 31.0;
    let (du, dv) = (4.0 * (s - 0.2 - 0.6 * part(1)), 4.0 * (t - 0.2 - 0.6 * part(6)));
    let (half_u, half_v) = (0.4 + 1.2 * part(11) * part(11), 0.4 + 1.2 * part(16));
    let contrast = if building.roof_tone > 120.0 { 45.0 + 70.0 * part(21) } else { 120.0 + 90.0 * part(21) };
    (du.abs() < half_u && dv.abs() < half_v).then_some(contrast)
}

/// Windows in storeys of 3 m.
fn wall(building: &Building, along_m: f64, up_m: f64) -> f64 {
    let ((col, s), (row, t)) = (cell(along_m / 2.8), cell(up_m / 3.0));
    let window = (s - 0.5).abs() < 0.22 && (t - 0.55).abs() < 0.22;
    if window { 35.0 + 40.0 * hash_unit(col, row, building.seed) } else { building.wall_tone }
}
