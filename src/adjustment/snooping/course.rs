//! What changes from round to round of an adjustment.

use crate::Error;
use crate::adjustment::block::Block;
use crate::adjustment::check::check_network;
use crate::adjustment::components::Weights;
use crate::adjustment::datum::moved_to_observed;
use crate::adjustment::network::Network;
use crate::adjustment::options::{AdjustmentOptions, Datum, Loss};
use crate::adjustment::precision::Orientations;
use crate::adjustment::result::{FixedParameter, ObservationVerdict};
use crate::adjustment::solution::Factored;
use crate::adjustment::sparse::Pattern;
use crate::adjustment::state::State;
use crate::adjustment::systematic::SystematicErrors;
use crate::adjustment::systematic_result::{SystematicStatistics, SystematicVerdict};
use crate::adjustment::weighted::{Weighted, observed};
use crate::camera::CAMERA_PARAMETERS;
use std::rc::Rc;

/// What changes from round to round.
pub(super) struct Course<'a> {
    /// As it was given, and with the weights and standard errors that hold now.
    pub given: &'a Block,
    pub block: Block,
    pub weights: Weights,
    pub options: &'a AdjustmentOptions,
    pub verdicts: Vec<ObservationVerdict>,
    pub free: Vec<[bool; CAMERA_PARAMETERS]>,
    /// Systematic errors of GNSS positions, which of their values are estimated, and what was last found of each.
    pub systematic: Rc<SystematicErrors>,
    pub estimated: Vec<[bool; 3]>,
    pub judged: Vec<SystematicStatistics>,
    pub fixed: Vec<Vec<FixedParameter>>,
    /// Whether the GNSS position of each image takes part.
    pub placed: Vec<bool>,
    /// Those that agreed at the start, and whether all these are kept: too many were refused since.
    pub agreed: Vec<bool>,
    pub keeps_agreed: bool,
    /// Whether rejected rays were taken back after the first rounds, since weights were made anew last.
    pub is_reconsidered: bool,
    pub start: State,
    /// How many rays were accepted at the start, and how many of which no standard error is stated.
    pub rays_at_start: usize,
    pub unstated_at_start: usize,
    pub state: State,
    /// Standard error of a coordinate as the last round saw it, by which rays are judged; 0 at first.
    pub sigma: f64,
    /// How it changed last, where weights alone changed it.
    pub sigma_change: f64,
    /// σ₀ of the rays once none was left to reject: from then on it weighs what has a stated standard error.
    pub sigma0: Option<f64>,
    /// How often it was found to be another, since anything else changed last.
    pub weighings: usize,
    pub iterations: usize,
    /// What of earlier rounds serves as long as the rays are nearly the same: the pattern of the equations, a factor, the cofactors of
    /// orientations. The cofactors are those of one loss.
    pub pattern: Option<Rc<Pattern>>,
    pub nearby: Option<Factored>,
    pub orientations: Option<(Loss, Orientations)>,
}

impl<'a> Course<'a> {
    /// Before the first round: what its place alone tells of each ray, and the start in the datum.
    pub fn new(block: &'a Block, options: &'a AdjustmentOptions) -> Result<Self, Error> {
        let systematic = match options.datum.uses_gnss() {
            true => SystematicErrors::of_block(block, options.gnss_errors, options.gnss_lever_arm),
            false => SystematicErrors::default(),
        };
        let start = State::of(block).with_systematic(systematic.errors.len());
        let mut course = Self {
            given: block,
            block: block.clone(),
            weights: Weights::default(),
            options,
            verdicts: Vec::new(),
            free: block.cameras.iter().map(|camera| camera.free.flags()).collect(),
            estimated: vec![[true; 3]; systematic.errors.len()],
            judged: systematic.errors.iter().map(|error| SystematicStatistics::none(*error, SystematicVerdict::Kept)).collect(),
            systematic: Rc::new(systematic),
            fixed: vec![Vec::new(); block.cameras.len()],
            placed: vec![true; block.images.len()],
            agreed: vec![true; block.images.len()],
            keeps_agreed: false,
            is_reconsidered: false,
            state: start.clone(),
            start,
            rays_at_start: 0,
            unstated_at_start: 0,
            sigma: 0.0,
            sigma_change: 0.0,
            sigma0: None,
            weighings: 0,
            iterations: 0,
            pattern: None,
            nearby: None,
            orientations: None,
        };
        course.verdicts = (0..block.rays.len()).map(|ray| course.in_front(ray)).collect();
        course.lose_points();
        course.rays_at_start = course.accepted();
        let accepted = block.rays.iter().zip(&course.verdicts).filter(|(_, verdict)| **verdict == ObservationVerdict::Accepted);
        course.unstated_at_start = accepted.filter(|(ray, _)| ray.sigma_px.is_none()).count();
        // A single image has no shape of its own that could be moved: it starts in the system of its control.
        if options.datum != Datum::Free && block.images.len() > 1 {
            let network = course.network()?;
            (course.state, course.placed) = moved_to_observed(block, &network, &course.state, options.datum, &course.systematic)?;
        }
        let left_out = course.systematic.left_out.clone();
        left_out.into_iter().for_each(|image| course.placed[image] = false);
        course.agreed = course.placed.clone();
        Ok(course)
    }

    /// Number of accepted rays.
    pub fn accepted(&self) -> usize {
        self.verdicts.iter().filter(|verdict| **verdict == ObservationVerdict::Accepted).count()
    }

    pub fn network(&mut self) -> Result<Network, Error> {
        let accepted: Vec<bool> = self.verdicts.iter().map(|v| *v == ObservationVerdict::Accepted).collect();
        let network = Network::new(&self.block, &accepted, self.pattern.as_ref());
        if !self.pattern.as_ref().is_some_and(|pattern| Rc::ptr_eq(pattern, &network.pattern)) {
            self.pattern = Some(network.pattern.clone());
            self.forget();
        }
        check_network(&network, self.options.datum)?;
        Ok(network)
    }

    /// Forgets what equations of another pattern or of other cameras left.
    pub fn forget(&mut self) {
        (self.nearby, self.orientations) = (None, None);
    }

    /// The standard error of a ray by which what has a stated one is judged, and weighted where it is known. The median is the one that gross errors hardly raise;
    /// where none are left it is too small, since errors of real matches have longer tails than the normal distribution.
    pub fn ray_error(&self) -> f64 {
        self.options.sigma0_px.or(self.sigma0).unwrap_or(self.sigma)
    }

    /// The same as it weights, where nothing is known of it yet too.
    pub fn weighted_by(&self) -> f64 {
        let found = self.ray_error();
        if found > 0.0 { found } else { 1.0 }
    }

    /// The observed positions of images and points that take part.
    pub fn observed(&self, weighted_by: f64) -> (Vec<Option<Weighted>>, Vec<Option<Weighted>>) {
        let (mut gnss, control) = observed(&self.block, self.options.datum, weighted_by);
        gnss.iter_mut().zip(&self.placed).filter(|(_, placed)| !**placed).for_each(|(prior, _)| *prior = None);
        (gnss, control)
    }
}
