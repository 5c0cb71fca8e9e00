//! Orthophotos of simulated scenes as they are years later: other light, much that was built, other crops, heights that err together.

use tiepoint::{BlockFlight, BlockScene, GreyImage, HeightModel, Heights, Orthophoto};

/// Side of a pixel of the orthophoto in m.
pub const GSD_M: f64 = 0.5;
/// What was built: squares of so many m a side, of which this share shows another town.
const CHANGES: [(f64, f64); 2] = [(60.0, 0.2), (12.0, 0.1)];
const MORE_CHANGES: [(f64, f64); 2] = [(60.0, 0.35), (12.0, 0.2)];
/// Fields of so many m a side, of which this share shows another crop: what was dark is bright, with a texture of so many px.
const FIELDS: (f64, f64) = (80.0, 0.2);
const TEXTURE_PX: f64 = 6.0;
const TEXTURE_GREY: f64 = 25.0;
/// Standard error of a height, that which is stated without an option, and the usual distance in m within which heights err together.
const HEIGHT_M: f64 = GSD_M;
pub const TOGETHER_M: u32 = 150;
/// Other light, and noise in grey values.
const GAIN: f64 = 0.75;
const OFFSET: f64 = 35.0;
const NOISE: f64 = 4.0;

/// What is wrong with an orthophoto beside what was built and the light.
#[derive(Clone, Copy)]
pub enum Fault {
    None,
    Built,
    Season,
    Heights,
}

pub const FAULTS: [(Fault, &str); 4] = [
    (Fault::None, "heights right"),
    (Fault::Built, "more was built"),
    (Fault::Season, "fields of another season"),
    (Fault::Heights, "heights wrong together"),
];

/// A number from 0 to 1 that is the same for the same numbers.
pub fn chance(seed: u32, column: usize, row: usize, what: u32) -> f64 {
    let mut mixed =
        seed ^ (column as u32).wrapping_mul(0x9E37_79B1) ^ (row as u32).wrapping_mul(0x85EB_CA77) ^ what.wrapping_mul(0xC2B2_AE3D);
    for shift in [15, 13, 16] {
        mixed = (mixed ^ (mixed >> shift)).wrapping_mul(0x2C1B_3C6D);
    }
    f64::from(mixed) / f64::from(u32::MAX)
}

/// Normally distributed, of variance 1, and smooth over so many px.
fn smooth(seed: u32, column: usize, row: usize, side_px: f64, what: u32) -> f64 {
    let normal = |column: usize, row: usize| {
        let [a, b] = [what, what + 1].map(|what| chance(seed, column, row, what));
        (-2.0 * a.max(1e-9).ln()).sqrt() * (std::f64::consts::TAU * b).cos()
    };
    let [x, y] = [column, row].map(|k| k as f64 / side_px);
    let [u, v] = [x.fract(), y.fract()];
    let corners = [([0, 0], (1.0 - u) * (1.0 - v)), ([1, 0], u * (1.0 - v)), ([0, 1], (1.0 - u) * v), ([1, 1], u * v)];
    let sum: f64 = corners.iter().map(|([c, r], weight)| weight * normal(x as usize + c, y as usize + r)).sum();
    sum / corners.iter().map(|(_, weight)| weight * weight).sum::<f64>().sqrt()
}

/// The ground of a scene as it is flown, and that of another town, which is built there later.
pub struct Ground {
    own: Orthophoto,
    before: GreyImage,
    other: GreyImage,
    seed: u32,
}

impl Ground {
    /// Of the scene of a flight.
    pub fn new(scene: &BlockScene, flight: &BlockFlight) -> Self {
        let own = scene.orthophoto(GSD_M).expect("an orthophoto of less than 100 MP");
        let other = BlockScene::new(&BlockFlight { seed: flight.seed + 500, ..flight.clone() }).and_then(|scene| scene.orthophoto(GSD_M));
        let other = other.and_then(|other| other.grey()).expect("the orthophoto of another town");
        let before = own.grey().expect("less than 100 MP");
        Self { own, before, other, seed: flight.seed }
    }

    /// Its orthophoto years later: squares of it show another town, the light is another. `together_m`: the distance within which heights err together.
    pub fn later(&self, fault: Fault, together_m: u32) -> Orthophoto {
        let Self { own, before, other, seed } = self;
        let changes = if matches!(fault, Fault::Built) { MORE_CHANGES } else { CHANGES };
        let is_among = |column: usize, row: usize, what: u32, (side_m, share): (f64, f64)| {
            let [c, r] = [column, row].map(|k| (k as f64 * GSD_M / side_m) as usize);
            chance(*seed, c, r, what) < share
        };
        let grey = |column: usize, row: usize| {
            let is_other = (0..).zip(changes).any(|(what, squares)| is_among(column, row, what, squares));
            let shown =
                if is_other { other.view().at(column % other.width(), row % other.height()) } else { before.view().at(column, row) };
            let is_crop = matches!(fault, Fault::Season) && is_among(column, row, 20, FIELDS);
            let crop = || 0.5 * (255.0 - f64::from(shown)) + 40.0 + TEXTURE_GREY * smooth(*seed, column, row, TEXTURE_PX, 21);
            let value = if is_crop { crop() } else { f64::from(shown) };
            let noise = NOISE * (chance(*seed, column, row, 8) + chance(*seed, column, row, 9) - 1.0) * 2.4;
            (GAIN * value + OFFSET + noise).round().clamp(1.0, 255.0) as u8
        };
        let grey = GreyImage::from_fn(before.width(), before.height(), grey).expect("as large as it was");
        let heights = match fault {
            Fault::Heights => wrong_together(own, *seed, together_m),
            Fault::None | Fault::Built | Fault::Season => own.heights.clone(),
        };
        Orthophoto::new(grey, own.georeference, heights).expect("the place that it had")
    }
}

/// The heights of an orthophoto with errors as large as stated that neighbours share.
fn wrong_together(own: &Orthophoto, seed: u32, together_m: u32) -> Heights {
    let [width, height] = own.size();
    let wrong = |k: usize| {
        let (column, row) = (k % width, k / width);
        let right = own.heights.at(own.georeference.ground([column as f64 + 0.5, row as f64 + 0.5]));
        right.map_or(f32::NAN, |right| (right + HEIGHT_M * smooth(seed, column, row, f64::from(together_m) / GSD_M, 31)) as f32)
    };
    let model = HeightModel::new(width, height, (0..width * height).map(wrong).collect(), own.georeference);
    Heights::Model(model.expect("heights of the earth"))
}
