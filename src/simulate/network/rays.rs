//! Points of a simulated block and the rays to them.

use super::orientations::spacing;
use crate::simulate::block::{BlockFlight, BlockView};
use crate::simulate::random::{Random, Stream};
use crate::{Block, BlockImage, BlockObservation};

/// Ground points over the block and what its margins show, as many for each image's area as asked.
pub(super) fn points(flight: &BlockFlight, random: &mut Random) -> Vec<[f64; 3]> {
    let (along, across) = spacing(flight);
    let ground = flight.flying_height_m / flight.focal_px();
    let frame = [f64::from(flight.height_px) * ground, f64::from(flight.width_px) * ground];
    // Views at 45° see ground as far outside as they stand high.
    let outside = if flight.view == BlockView::Oblique { 2.0 * flight.flying_height_m } else { 0.0 };
    let extent = [(flight.exposures as f64 - 1.0) * along + frame[0] + outside, (flight.strips as f64 - 1.0) * across + frame[1] + outside];
    let number = (flight.points_per_image * extent[0] * extent[1] / (frame[0] * frame[1])) as usize;
    let phase = [random.uniform(), random.uniform()].map(|u| 2.0 * std::f64::consts::PI * u);
    let scale = 1.3 / frame[0].max(frame[1]) * 2.0 * std::f64::consts::PI;
    let mut point = || {
        let (x, y) = (random.between(-0.5, 0.5) * extent[0], random.between(-0.5, 0.5) * extent[1]);
        let waves = libm::sin(x * scale + phase[0]) + libm::cos(y * scale + phase[1]);
        let z = flight.relief_m * (0.25 * waves + random.between(-0.25, 0.25));
        [x, y, z]
    };
    (0..number).map(|_| point()).collect()
}

/// Adds the rays of all points that two images see; gives the gross errors among them.
pub(super) fn observe(flight: &BlockFlight, truth: &mut Block) -> Vec<usize> {
    let mut random = Random::new(flight.seed, Stream::NetworkNoise);
    let mut gross = Vec::new();
    let reach = Reach::new(flight, truth);
    let mut kept = Vec::new();
    for point in std::mem::take(&mut truth.points) {
        let seen: Vec<(usize, [f64; 2])> =
            reach.images_near(&point).filter_map(|image| Some((image, seen_at(flight, truth, image, &point)?))).collect();
        if seen.len() < 2 {
            continue;
        }
        for (image, at) in seen {
            let mut error = random.normal_pair() * flight.noise_px;
            if random.chance(flight.gross_share) {
                gross.push(truth.rays.len());
                error = nalgebra::Vector2::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0)) * flight.gross_px;
            }
            truth.rays.push(BlockObservation {
                image,
                point: kept.len(),
                x_px: at[0] + error.x,
                y_px: at[1] + error.y,
                weight: 1.0,
                sigma_px: None,
            });
        }
        kept.push(point);
    }
    truth.points = kept;
    gross
}

/// Where an image sees a point, if it does.
fn seen_at(flight: &BlockFlight, truth: &Block, image: usize, point: &[f64; 3]) -> Option<[f64; 2]> {
    let BlockImage { camera, pose, .. } = &truth.images[image];
    let [u, v, w] = pose.to_photo(point);
    let camera = &truth.cameras[*camera];
    let (x, y) = (u / -w, v / w);
    let r2 = x * x + y * y;
    let half = 0.5 * f64::from(flight.width_px.max(flight.height_px)) / camera.focal_px;
    if !(w < 0.0 && r2 < 4.0 * half * half) {
        return None;
    }
    let at = camera.project(x, y);
    (at[0] >= 0.0 && at[1] >= 0.0 && at[0] <= f64::from(flight.width_px) && at[1] <= f64::from(flight.height_px)).then_some(at)
}

/// Images by the cells of the ground that they stand over, so that not every image is asked for every point.
struct Reach {
    cell_m: f64,
    origin: [f64; 2],
    columns: usize,
    cells: Vec<Vec<usize>>,
}

impl Reach {
    fn new(flight: &BlockFlight, truth: &Block) -> Self {
        // Twice the height covers oblique views; a nadir view reaches as far as its corner.
        let diagonal = libm::hypot(f64::from(flight.width_px), f64::from(flight.height_px)) / flight.focal_px();
        let cell_m = flight.flying_height_m * if flight.view == BlockView::Oblique { 4.0 + diagonal } else { 1.0 * diagonal };
        let bound = |k: usize, start: f64, pick: fn(f64, f64) -> f64| truth.images.iter().map(|i| i.pose.position[k]).fold(start, pick);
        let origin = [0, 1].map(|k| bound(k, f64::INFINITY, f64::min));
        let size = [0, 1].map(|k| ((bound(k, f64::NEG_INFINITY, f64::max) - origin[k]) / cell_m) as usize + 1);
        let mut cells = vec![Vec::new(); size[0] * size[1]];
        for (index, image) in truth.images.iter().enumerate() {
            let [c, r] = [0, 1].map(|k| ((image.pose.position[k] - origin[k]) / cell_m) as usize);
            cells[r * size[0] + c].push(index);
        }
        Self { cell_m, origin, columns: size[0], cells }
    }

    /// In ascending order.
    fn images_near(&self, point: &[f64; 3]) -> impl Iterator<Item = usize> {
        let rows = self.cells.len() / self.columns;
        let [c, r] = [0, 1].map(|k| libm::floor((point[k] - self.origin[k]) / self.cell_m) as i64);
        let within = |at: i64, size: usize| (at >= 0 && at < size as i64).then_some(at as usize);
        let mut found: Vec<usize> = (r - 1..=r + 1)
            .flat_map(|r| (c - 1..=c + 1).map(move |c| (r, c)))
            .filter_map(|(r, c)| Some((within(r, rows)?, within(c, self.columns)?)))
            .flat_map(|(r, c)| self.cells[r * self.columns + c].iter().copied())
            .collect();
        found.sort_unstable();
        found.into_iter()
    }
}
