//! A model grows: images are oriented by its points, points intersected by its images, and the whole adjusted now and then.

use super::adjusting::{CALIBRATED, KnownParameters, MANY, adjust};
use super::net::Net;
use super::options::ReconstructionOptions;
use super::resection::resect;
use super::start::StartPair;
use super::warning::UnorientedReason;
use std::collections::BTreeMap;

/// Up to so many images all are adjusted in every round; beyond, all are when there are this many times as many as the last time.
const FEW: usize = 30;
const GROWTH: f64 = 1.4;
const GROWTH_OF_MANY: f64 = 2.0;
/// Images with this share of the points of the best are oriented in one round.
const ALIKE: f64 = 0.5;
/// Oriented images that are adjusted with a new one: those with most points in common.
const NEIGHBOURS: usize = 4;
/// Times that an image may be tried.
const TRIES: u32 = 6;
/// An image is tried again when it has this many times the points of the last time.
const MORE: f64 = 1.3;
/// The limit of a camera that was not calibrated by other images yet, as a multiple of the present one.
const UNCALIBRATED: f64 = 4.0;

/// A growing model.
#[derive(Clone)]
pub(super) struct Growth<'a> {
    pub net: Net<'a>,
    pub options: &'a ReconstructionOptions,
    pub priors: &'a [KnownParameters],
    /// Images of other models.
    pub is_open: Vec<bool>,
    /// Why an image was not oriented, with the points it had then.
    refused: Vec<Option<(UnorientedReason, usize)>>,
    tries: Vec<u32>,
    /// Images at the last adjustment of all.
    adjusted: usize,
}

impl<'a> Growth<'a> {
    pub fn new(net: Net<'a>, options: &'a ReconstructionOptions, priors: &'a [KnownParameters], is_open: Vec<bool>) -> Self {
        let images = net.rays.images();
        Self { net, options, priors, is_open, refused: vec![None; images], tries: vec![0; images], adjusted: 0 }
    }

    pub fn most_cosine(&self) -> f64 {
        libm::cos(self.options.least_angle_deg.to_radians())
    }

    /// Starts from two images.
    pub fn start(&mut self, pair: &StartPair) {
        for (image, pose) in pair.images.into_iter().zip(pair.poses) {
            self.net.poses[image] = Some(pose);
        }
        self.intersect_of(&pair.images);
        self.adjust_all();
    }

    /// Orients images until there are `most`, or none can be oriented any more.
    pub fn grow(&mut self, most: usize) {
        let mut last_chance = false;
        while self.net.oriented() < most {
            let added = self.orient_next(most - self.net.oriented());
            if !added.is_empty() {
                last_chance = false;
                self.settle(&added);
            } else if last_chance || (self.adjusted == self.net.oriented() && !self.is_any_left()) {
                break;
            } else {
                // With better orientations all around, what failed may succeed.
                self.adjust_all();
                self.refused.iter_mut().flatten().for_each(|(_, points)| *points = 0);
                last_chance = true;
            }
        }
    }

    /// Whether an image is left that sees enough intersected points.
    fn is_any_left(&self) -> bool {
        let is_left = |image: usize| self.is_open[image] && self.net.poses[image].is_none();
        (0..self.net.rays.images()).any(|image| is_left(image) && self.net.known_of(image) >= self.options.least_rays)
    }

    /// Orients what is left without any adjustment: for points that were not intersected while the model grew.
    pub fn orient_rest(&mut self) {
        while !self.orient_next(usize::MAX).is_empty() {}
    }

    /// Why an image is not oriented.
    pub fn reason(&self, image: usize) -> UnorientedReason {
        let points = self.net.known_of(image);
        let few = UnorientedReason::TooFewPoints { points, needed: self.options.least_rays };
        self.refused[image].map_or(few, |(reason, _)| reason)
    }

    /// Orients the images with most intersected points, up to `most`.
    fn orient_next(&mut self, most: usize) -> Vec<usize> {
        let mut candidates: Vec<(usize, usize)> = Vec::new();
        for image in (0..self.net.rays.images()).filter(|image| self.is_open[*image] && self.net.poses[*image].is_none()) {
            let known = self.net.known_of(image);
            let again = self.refused[image].is_none_or(|(_, points)| known as f64 >= MORE * points as f64);
            if known >= self.options.least_rays && again && self.tries[image] < TRIES {
                candidates.push((known, image));
            }
        }
        candidates.sort_by(|a, b| b.0.cmp(&a.0).then(a.1.cmp(&b.1)));
        let mut added = Vec::new();
        let mut least = candidates.first().map_or(0.0, |(known, _)| ALIKE * *known as f64);
        for (known, image) in candidates {
            if added.len() >= most || (known as f64) < least {
                break;
            }
            self.tries[image] += 1;
            match self.orient(image) {
                Ok(()) => added.push(image),
                Err(reason) => {
                    self.refused[image] = Some((reason, known));
                    if added.is_empty() {
                        // The best could not be oriented: the next stands for it.
                        least = least.min(ALIKE * known as f64 * ALIKE);
                    }
                }
            }
        }
        added
    }

    fn orient(&mut self, image: usize) -> Result<(), UnorientedReason> {
        let camera = self.net.camera_of[image];
        let is_new = !(0..self.net.poses.len()).any(|other| self.net.camera_of[other] == camera && self.net.poses[other].is_some());
        let present = self.net.limit_px.max(1.5);
        let wide = (UNCALIBRATED * present).max(self.options.largest_residual_px);
        let limits = if is_new || self.net.oriented() < CALIBRATED { vec![present, wide] } else { vec![present] };
        let mut outcome = Err(UnorientedReason::NoPartner);
        for limit in limits {
            outcome = resect(&self.net, image, limit, self.options.least_rays, self.options.seed);
            if let Ok((pose, _)) = outcome {
                self.net.poses[image] = Some(pose);
                self.refused[image] = None;
                for ray in self.net.rays.of_image(image) {
                    let ray = *ray as usize;
                    let limit = if self.net.rays.is_mark(ray) { self.net.mark_limit_px } else { limit };
                    self.net.accepted[ray] = self.net.residual(ray).is_some_and(|r| r <= limit);
                }
                self.intersect_of(&[image]);
                return Ok(());
            }
        }
        outcome.map(|_| ())
    }

    /// Intersects the points of some images that are not intersected yet.
    fn intersect_of(&mut self, images: &[usize]) {
        let most_cosine = self.most_cosine();
        for image in images {
            let rays = self.net.rays;
            for ray in rays.of_image(*image) {
                let point = rays.point[*ray as usize] as usize;
                if self.net.points[point].is_none() {
                    self.net.intersect(point, most_cosine);
                }
            }
        }
    }

    /// Adjusts after new images: them and their neighbours, or all.
    fn settle(&mut self, added: &[usize]) {
        let oriented = self.net.oriented();
        let growth = if oriented > MANY { GROWTH_OF_MANY } else { GROWTH };
        if oriented <= FEW || oriented as f64 >= growth * self.adjusted as f64 {
            self.adjust_all();
            return;
        }
        let mut free = added.to_vec();
        added.iter().for_each(|image| free.extend(self.neighbours(*image)));
        free.sort_unstable();
        free.dedup();
        adjust(&mut self.net, self.priors, &free);
        self.judge_of(&free);
        self.intersect_of(&free);
        self.lose_weak(&free);
    }

    /// Adjusts all images, twice where the rays that fit have changed.
    pub fn adjust_all(&mut self) {
        let all: Vec<usize> = (0..self.net.poses.len()).filter(|image| self.net.poses[*image].is_some()).collect();
        for _ in 0..2 {
            let before = self.net.accepted.clone();
            adjust(&mut self.net, self.priors, &all);
            self.net.tighten(self.options.largest_residual_px);
            self.judge_of(&all);
            self.intersect_of(&all);
            self.lose_weak(&all);
            let changed = before.iter().zip(&self.net.accepted).filter(|(a, b)| a != b).count();
            if all.len() > MANY || changed * 100 < before.iter().filter(|a| **a).count() {
                break;
            }
        }
        self.adjusted = self.net.oriented();
    }

    /// The oriented images with most accepted points in common with one.
    fn neighbours(&self, image: usize) -> Vec<usize> {
        let rays = self.net.rays;
        let mut common: BTreeMap<usize, usize> = BTreeMap::new();
        for ray in rays.of_image(image).iter().filter(|ray| self.net.accepted[**ray as usize]) {
            for other in rays.of_point(rays.point[*ray as usize] as usize).filter(|other| self.net.accepted[*other]) {
                *common.entry(rays.image[other] as usize).or_default() += 1;
            }
        }
        common.remove(&image);
        let mut list: Vec<(usize, usize)> = common.into_iter().map(|(image, points)| (points, image)).collect();
        list.sort_by(|a, b| b.0.cmp(&a.0).then(a.1.cmp(&b.1)));
        list.into_iter().take(NEIGHBOURS).map(|(_, image)| image).collect()
    }

    fn judge_of(&mut self, images: &[usize]) {
        let most_cosine = self.most_cosine();
        let mut points: Vec<u32> =
            images.iter().flat_map(|image| self.net.rays.of_image(*image)).map(|ray| self.net.rays.point[*ray as usize]).collect();
        points.sort_unstable();
        points.dedup();
        points.into_iter().for_each(|point| self.net.judge(point as usize, most_cosine));
    }

    /// Takes out images that lost their rays; points that stood on them are judged with the next adjustment.
    fn lose_weak(&mut self, images: &[usize]) {
        for image in images {
            let rays = self.net.accepted_of(*image);
            if rays < self.options.least_rays.div_ceil(2) {
                self.net.lose(*image);
                self.refused[*image] = Some((UnorientedReason::Lost { rays }, self.net.known_of(*image)));
                self.judge_of(&[*image]);
            }
        }
    }
}
