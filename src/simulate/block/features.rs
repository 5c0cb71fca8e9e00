//! What the photos of a block see: features of common ground points, and features that no other photo shows.

use super::exposures::Exposure;
use super::flight::BlockFlight;
use super::ground::Ground;
use crate::simulate::random::{Random, Stream};

/// The features of all photos, and what they show.
pub(super) struct Seen {
    pub features: Vec<Vec<[f32; 2]>>,
    pub owners: Vec<Vec<Option<u32>>>,
    pub ground: Vec<[f64; 3]>,
}

/// The operator finds this share of the ground points that a photo shows.
const FOUND: f64 = 0.7;

pub(super) fn features(flight: &BlockFlight, exposures: &[Exposure]) -> Seen {
    let footprints: Vec<[[f64; 2]; 2]> = exposures.iter().map(|exposure| footprint(flight, exposure)).collect();
    let extreme = |side: usize, axis: usize, pick: fn(f64, f64) -> f64| {
        footprints.iter().map(|f| f[side][axis]).fold(footprints[0][side][axis], pick)
    };
    let low = [extreme(0, 0, f64::min), extreme(0, 1, f64::min)];
    let high = [extreme(1, 0, f64::max), extreme(1, 1, f64::max)];
    // As many points as give the smallest footprint, that of a nadir photo at the lowest height, its number of features.
    let area = |low: [f64; 2], high: [f64; 2]| (high[0] - low[0]) * (high[1] - low[1]);
    let bare = |f: &[[f64; 2]; 2]| area(f[0].map(|v| v + flight.relief_m), f[1].map(|v| v - flight.relief_m));
    let smallest = footprints.iter().map(bare).fold(f64::INFINITY, f64::min).max(1.0);
    let common = flight.features as f64 * (1.0 - flight.clutter);
    let mut random = Random::new(flight.seed, Stream::BlockGround);
    let count = (common / FOUND * area(low, high) / smallest).min(MOST_GROUND) as usize;
    let ground = Ground::new(&mut random, low, high, count, flight.relief_m);
    let mut random = Random::new(flight.seed, Stream::BlockFeatures);
    let (mut features, mut owners) = (Vec::new(), Vec::new());
    for (exposure, [low, high]) in exposures.iter().zip(&footprints) {
        let mut found = see(flight, exposure, ground.near(*low, *high), &ground, &mut random);
        // Photos of a larger footprint find no more features than others.
        random_order(&mut found, &mut random);
        found.truncate(common as usize);
        let clutter = (found.len() as f64 * flight.clutter / (1.0 - flight.clutter)) as usize;
        for _ in 0..clutter {
            let at = [random.between(0.0, f64::from(flight.width_px)), random.between(0.0, f64::from(flight.height_px))];
            found.push((at.map(|v| v as f32), None));
        }
        random_order(&mut found, &mut random);
        features.push(found.iter().map(|f| f.0).collect());
        owners.push(found.iter().map(|f| f.1).collect());
    }
    Seen { features, owners, ground: ground.points }
}

/// More points of ground are not made: they would not fit into memory.
const MOST_GROUND: f64 = 2e7;

fn see(
    flight: &BlockFlight,
    exposure: &Exposure,
    near: impl Iterator<Item = u32>,
    ground: &Ground,
    random: &mut Random,
) -> Vec<([f32; 2], Option<u32>)> {
    let mut found = Vec::new();
    for point in near {
        let Some(at) = exposure.project(ground.points[point as usize], flight.width_px, flight.height_px) else { continue };
        if !random.chance(FOUND) {
            continue;
        }
        let noise = random.normal_pair();
        let measured = [0, 1].map(|axis| {
            let length = f64::from([flight.width_px, flight.height_px][axis]);
            (at[axis] + flight.noise_px * noise[axis]).clamp(0.0, length) as f32
        });
        found.push((measured, Some(point)));
    }
    found
}

fn random_order<T>(values: &mut [T], random: &mut Random) {
    for last in (1..values.len()).rev() {
        values.swap(last, ((random.uniform() * (last + 1) as f64) as usize).min(last));
    }
}

/// The rectangle of ground, from its least to its largest coordinates, that a photo shows, with a margin for the relief.
fn footprint(flight: &BlockFlight, exposure: &Exposure) -> [[f64; 2]; 2] {
    let (width, height) = (f64::from(flight.width_px), f64::from(flight.height_px));
    let corners = [[0.0, 0.0], [width, 0.0], [0.0, height], [width, height]];
    let mut low = [exposure.centre[0], exposure.centre[1]];
    let mut high = low;
    // A tilted photo does not show what is below it: its rectangle is that of the corners alone.
    let met: Vec<[f64; 2]> = corners.iter().filter_map(|at| exposure.on_level_ground(*at, flight.width_px, flight.height_px)).collect();
    if let Some(first) = met.first() {
        (low, high) = (*first, *first);
    }
    for at in &met {
        for axis in 0..2 {
            low[axis] = low[axis].min(at[axis]);
            high[axis] = high[axis].max(at[axis]);
        }
    }
    let margin = flight.relief_m;
    [low.map(|v| v - margin), high.map(|v| v + margin)]
}
