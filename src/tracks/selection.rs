//! Choosing few of many points: those of many sure rays, spread evenly over each image and overlap, without thinning a connection away.

use super::places::{Cells, check};
use super::shared::{PointsOfImages, count_shared};
use super::{FeatureObservation, ImageFeatures, SelectOptions, SharedPoints, TiePoints};
use crate::Error;

/// The points that were chosen.
#[derive(Debug, Clone, PartialEq)]
pub struct SelectedPoints {
    /// Indices of the points, ascending.
    pub points: Vec<u32>,
    /// Rays of the chosen points in each image.
    pub rays_of_images: Vec<u32>,
    /// How many of the nine von Gruber places of each image hold a chosen point.
    pub places_of_images: Vec<u32>,
}

/// A point is taken if this share of its rays falls where points are wanted: first those that crowd no image, then those that serve more
/// images than they crowd, last those that a single image wants.
const USEFUL_SHARES: [f64; 3] = [1.0, 0.5, 0.0];

/// No image is crowded for the sake of another beyond this multiple of `per_image`; only a connection goes before that.
const MOST_CROWDED: u32 = 2;

/// Chooses points so that each image has about `per_image` rays and each pair of images keeps `per_connection` common points.
///
/// The points stand in line by the sum of their rays' confidences times their own. Each image has an even grid of about `per_image`
/// cells. First every cell gets one point where there is one; then pairs of images with fewer chosen points than `per_connection` and more
/// to choose from get theirs, the weakest pair first, spread over the cells; then cells get second and further points until every image has
/// `per_image` rays or no points are left. Images have more rays where their connections need it. The same points give the same choice.
///
/// # Errors
/// [`Error::InvalidOption`]; [`Error::InvalidInput`] for features that do not exist or lie outside their image.
///
/// # Source
/// That the points of a model belong to six places, nine an image: von Gruber 1924, Einfache und Doppelpunkteinschaltung im Raume.
pub fn select_points(points: &TiePoints, images: &[ImageFeatures<'_>], options: &SelectOptions) -> Result<SelectedPoints, Error> {
    options.check_ranges()?;
    check(points, images)?;
    let mut choice = Choice::new(points, images, options);
    let mut line = in_line(points);
    choice.fill(&mut line, 1);
    choice.connect(images.len(), options.per_connection as u32);
    let mut level = 2;
    while choice.prune(&mut line) {
        choice.fill(&mut line, level);
        level += 1;
    }
    let chosen = (0..points.len() as u32).filter(|point| choice.chosen[*point as usize]).collect();
    let places_of_images = (0..images.len()).map(|image| choice.cells.filled_places(image)).collect();
    Ok(SelectedPoints { points: chosen, rays_of_images: choice.counts, places_of_images })
}

/// All points, the best first.
fn in_line(points: &TiePoints) -> Vec<u32> {
    let worth: Vec<f32> = (0..points.len())
        .map(|point| points.confidence(point) * points.rays(point).iter().map(|ray| ray.confidence).sum::<f32>())
        .collect();
    let mut line: Vec<u32> = (0..points.len() as u32).collect();
    line.sort_unstable_by(|a, b| worth[*b as usize].total_cmp(&worth[*a as usize]).then(a.cmp(b)));
    line
}

struct Choice<'a> {
    points: &'a TiePoints,
    chosen: Vec<bool>,
    cells: Cells<'a>,
    /// Chosen rays of each image.
    counts: Vec<u32>,
    per_image: u32,
}

impl<'a> Choice<'a> {
    fn new(points: &'a TiePoints, images: &'a [ImageFeatures<'a>], options: &SelectOptions) -> Self {
        let cells = Cells::new(images, options.per_image);
        Self { points, chosen: vec![false; points.len()], cells, counts: vec![0; images.len()], per_image: options.per_image as u32 }
    }

    fn take(&mut self, point: u32) {
        self.chosen[point as usize] = true;
        for ray in self.points.rays(point as usize) {
            self.counts[ray.image as usize] += 1;
            self.cells.add(ray);
        }
    }

    fn wants(&self, ray: &FeatureObservation) -> bool {
        self.counts[ray.image as usize] < self.per_image
    }

    /// Brings cells up to `level` points, by the line.
    fn fill(&mut self, line: &mut Vec<u32>, level: u16) {
        for share in USEFUL_SHARES {
            line.retain(|point| {
                let rays = self.points.rays(*point as usize);
                let useful = rays.iter().filter(|ray| self.wants(ray) && self.cells.count(ray) < level).count();
                let crowded = || rays.iter().any(|ray| self.counts[ray.image as usize] >= MOST_CROWDED * self.per_image);
                let take = !self.chosen[*point as usize] && useful > 0 && useful as f64 >= share * rays.len() as f64 && !crowded();
                if take {
                    self.take(*point);
                }
                !take
            });
        }
    }

    /// Takes from the line the points that no image wants any more; tells whether any is left.
    fn prune(&self, line: &mut Vec<u32>) -> bool {
        line.retain(|point| {
            let rays = self.points.rays(*point as usize);
            let crowded = rays.iter().any(|ray| self.counts[ray.image as usize] >= MOST_CROWDED * self.per_image);
            !self.chosen[*point as usize] && !crowded && rays.iter().any(|ray| self.wants(ray))
        });
        !line.is_empty()
    }

    /// Brings each pair of images up to `least` common points, the pair with the fewest to choose from first.
    fn connect(&mut self, images: usize, least: u32) {
        let of_images = PointsOfImages::new(self.points, images);
        let mut pairs = count_shared(&of_images, |point| self.points.rays(point as usize), images);
        pairs.sort_by_key(|pair| (pair.points, pair.images));
        for pair in &pairs {
            self.connect_pair(&of_images, pair, least.min(pair.points));
        }
    }

    fn connect_pair(&mut self, of_images: &PointsOfImages, pair: &SharedPoints, wanted: u32) {
        let [a, b] = pair.images;
        let fewer = if of_images.of(a).len() <= of_images.of(b).len() { a } else { b };
        let both = |point: &&u32| {
            let rays = self.points.rays(**point as usize);
            [a, b].iter().all(|image| rays.binary_search_by_key(image, |ray| ray.image).is_ok())
        };
        let common: Vec<u32> = of_images.of(fewer).iter().filter(both).copied().collect();
        let mut have = common.iter().filter(|point| self.chosen[**point as usize]).count() as u32;
        let mut open: Vec<u32> = common.into_iter().filter(|point| !self.chosen[*point as usize]).collect();
        while have < wanted {
            // The emptiest places first; then the point that serves most images, then the earlier one.
            let rank = |point: &u32| {
                let rays = self.points.rays(*point as usize);
                let filled: u32 =
                    rays.iter().filter(|ray| ray.image == a || ray.image == b).map(|ray| u32::from(self.cells.count(ray))).sum();
                (filled, std::cmp::Reverse(rays.len()), *point)
            };
            let Some(best) = (0..open.len()).min_by_key(|index| rank(&open[*index])) else { break };
            self.take(open.swap_remove(best));
            have += 1;
        }
    }
}
