//! The normal equations of images and cameras after the points are eliminated.
//!
//! Symbols: A, B, C are the derivatives of a ray by its image, point and camera, w its weight, v observed minus computed; V = Σ w BᵀB = L Lᵀ
//! of a point, F = B L⁻ᵀ, Z = w AᵀF. Eliminating the point takes Z Zᵀ from the equations of the images that see it.
//!
//! # Source
//! Brown 1976, The bundle adjustment: progress and prospects.

use super::axis::WeightedAxis;
use super::block::Block;
use super::datum_part::DatumConstraint;
use super::factor3::{factor3, forward3};
use super::line::Line;
use super::loss::Robust;
use super::network::{Columns, Network, Sight};
use super::sparse::{N, SparseMatrix, subtract_product3};
use super::state::State;
use super::systematic::SystematicErrors;
use super::weighted::Weighted;
use crate::math::dot3;

/// Everything of an adjustment that does not change with the values of the unknowns.
pub(super) struct Problem<'a> {
    pub network: &'a Network,
    pub columns: &'a Columns,
    /// Observed positions of images and of points; none in a free network.
    pub gnss: &'a [Option<Weighted>],
    pub control: &'a [Option<Weighted>],
    /// Known axes of images; none in a free network.
    pub axes: &'a [Option<WeightedAxis>],
    /// The image that is held, and the one that is held along the base: they take the seven freedoms out of a free network.
    pub held: Option<[usize; 2]>,
    /// What is known of the camera columns beforehand; without an entry: nothing.
    pub known: &'a [KnownParameter],
    /// Systematic errors of the observed positions of images, and what keeps them apart from motions of the whole block.
    pub systematic: &'a SystematicErrors,
    pub constraints: &'a [DatumConstraint],
}

/// A camera parameter that is known beforehand, with the weight of that knowledge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct KnownParameter {
    pub value: f64,
    pub weight: f64,
}

impl KnownParameter {
    /// Of each column, for a standard error `sigma0` of a ray of weight 1; none at all where nothing is known of any camera.
    pub fn of_block(block: &Block, columns: &Columns, sigma0: f64) -> Vec<Self> {
        if block.camera_priors.is_empty() {
            return Vec::new();
        }
        let known = |&(camera, parameter): &(usize, usize)| {
            let prior = block.camera_priors.iter().find(|prior| prior.camera == camera);
            let known = prior.and_then(|prior| Some((prior.values[parameter], prior.sigma[parameter]?)));
            known.map_or(Self { value: 0.0, weight: 0.0 }, |(value, sigma)| Self { value, weight: sigma0 / sigma * (sigma0 / sigma) })
        };
        columns.parameter.iter().map(known).collect()
    }
}

/// What elimination leaves of a point.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Eliminated {
    /// l₀₀, l₁₀, l₁₁, l₂₀, l₂₁, l₂₂ of L; 0 for a point without rays or not determined by them.
    pub factor: [f64; 6],
    /// L⁻¹ of its right-hand side.
    pub right: [f64; 3],
}

/// The reduced normal equations. Images stand at their places in the order of elimination.
pub(super) struct Reduced {
    pub matrix: SparseMatrix,
    /// For each column of cameras and systematic errors six numbers a place.
    pub border: Vec<Vec<f64>>,
    /// Row by row.
    pub corner: Vec<f64>,
    pub right: Vec<f64>,
    pub corner_right: Vec<f64>,
    /// The diagonal before the points were eliminated.
    pub scale: Vec<[f64; N]>,
    pub corner_scale: Vec<f64>,
    pub points: Vec<Eliminated>,
    /// Z of each sight, column by column.
    pub shares: Vec<[f64; 18]>,
    /// For each point the camera columns that it touches with wCᵀF; `camera_start` says where each point's begin.
    pub camera_shares: Vec<(u32, [f64; 3])>,
    pub camera_start: Vec<usize>,
}

impl Problem<'_> {
    /// Sums up the normal equations at `state`, every own diagonal raised by the share `damping`.
    pub fn reduce(&self, state: &State, damping: f64, robust: Robust) -> Reduced {
        let mut reduced = self.eliminated(state, damping, robust);
        self.add_positions(state, &mut reduced);
        self.add_axes(state, &mut reduced);
        self.add_known(state, &mut reduced);
        self.add_constraints(state, &mut reduced);
        self.hold(state, &mut reduced);
        self.keep_fixed(&mut reduced);
        for (diagonal, scale) in reduced.matrix.diagonal.iter_mut().zip(&reduced.scale) {
            (0..N).for_each(|k| diagonal[k * N + k] += damping * scale[k]);
        }
        let q = self.columns.number();
        (0..q).for_each(|k| reduced.corner[k * q + k] += damping * reduced.corner_scale[k]);
        self.couple(&mut reduced);
        reduced
    }

    /// The points eliminated, and nothing else: what tells a point's place and cofactors once those of images and cameras are known.
    pub fn eliminated(&self, state: &State, damping: f64, robust: Robust) -> Reduced {
        let mut reduced = self.empty();
        let mut lines = Vec::new();
        for point in 0..self.network.points() {
            self.eliminate(point, state, damping, robust, &mut lines, &mut reduced);
            reduced.camera_start.push(reduced.camera_shares.len());
        }
        reduced
    }

    /// Points that their rays do not determine.
    pub fn undetermined_points(&self, state: &State, robust: Robust) -> Vec<usize> {
        let determined = |point: usize| {
            let (mut own, mut right) = ([0.0; 6], [0.0; 3]);
            let sights = self.network.of_point(point);
            sights.iter().for_each(|sight| Line::new(sight, state, robust).add_to_point(&mut own, &mut right));
            self.add_control(point, state, &mut own, &mut right);
            sights.is_empty() || factor3(&own).is_some()
        };
        (0..self.network.points()).filter(|point| !determined(*point)).collect()
    }

    fn add_control(&self, point: usize, state: &State, own: &mut [f64; 6], right: &mut [f64; 3]) {
        if let Some(Weighted { position, weight }) = &self.control[point] {
            for k in 0..3 {
                own[[0, 2, 5][k]] += weight[k];
                right[k] += weight[k] * (position[k] - state.points[point][k]);
            }
        }
    }

    fn empty(&self) -> Reduced {
        let (images, q, pattern) = (self.network.images(), self.columns.number(), &self.network.pattern);
        Reduced {
            matrix: SparseMatrix::zeros(pattern),
            border: vec![vec![0.0; images * N]; q],
            corner: vec![0.0; q * q],
            right: vec![0.0; images * N],
            corner_right: vec![0.0; q],
            scale: vec![[0.0; N]; images],
            corner_scale: vec![0.0; q],
            points: vec![Eliminated::default(); self.network.points()],
            shares: vec![[0.0; 18]; self.network.sights.len()],
            camera_shares: Vec::new(),
            camera_start: vec![0],
        }
    }

    /// Adds the rays of a point and eliminates it; all but what couples two images.
    fn eliminate(&self, point: usize, state: &State, damping: f64, robust: Robust, lines: &mut Vec<Line>, reduced: &mut Reduced) {
        let sights = self.network.of_point(point);
        if sights.is_empty() {
            return;
        }
        lines.clear();
        lines.extend(sights.iter().map(|sight| Line::new(sight, state, robust)));
        let (mut own, mut right) = ([0.0; 6], [0.0; 3]);
        lines.iter().for_each(|line| line.add_to_point(&mut own, &mut right));
        self.add_control(point, state, &mut own, &mut right);
        [0, 2, 5].into_iter().for_each(|k| own[k] *= 1.0 + damping);
        let Some(factor) = factor3(&own) else {
            return;
        };
        let right = forward3(&factor, right);
        reduced.points[point] = Eliminated { factor, right };
        let first_share = reduced.camera_shares.len();
        let place = &self.network.pattern.place;
        for (k, (line, sight)) in lines.iter().zip(sights).enumerate() {
            let at = place[sight.image as usize] as usize;
            let f = line.by_point().map(|row| forward3(&factor, row));
            let fixed = self.network.fixed[sight.image as usize];
            let share = if fixed { [0.0; 18] } else { line.share(&f) };
            reduced.shares[self.network.point_start[point] + k] = share;
            if !fixed {
                line.add_to_image(
                    &share,
                    &right,
                    &mut reduced.matrix.diagonal[at],
                    &mut reduced.scale[at],
                    &mut reduced.right[at * N..][..N],
                );
            }
            if self.columns.number() > 0 {
                self.add_camera(line, sight, &f, at, first_share, reduced);
            }
        }
        if self.columns.number() > 0 {
            self.take_from_cameras(sights, &right, first_share, reduced);
        }
    }

    /// Adds what a ray says of its camera.
    fn add_camera(&self, line: &Line, sight: &Sight, f: &[[f64; 3]; 2], at: usize, first_share: usize, reduced: &mut Reduced) {
        let q = self.columns.number();
        let columns = &self.columns.of_camera[sight.camera as usize];
        for &(parameter, column) in columns {
            let c = [0, 1].map(|row| line.weight * line.at.by_camera[row][parameter]);
            let unknowns = if self.network.fixed[sight.image as usize] { 0 } else { N };
            for k in 0..unknowns {
                reduced.border[column][at * N + k] += c[0] * line.at.by_image[0][k] + c[1] * line.at.by_image[1][k];
            }
            for &(other, row) in columns {
                reduced.corner[row * q + column] += c[0] * line.at.by_camera[0][other] + c[1] * line.at.by_camera[1][other];
            }
            reduced.corner_scale[column] += c[0] * line.at.by_camera[0][parameter] + c[1] * line.at.by_camera[1][parameter];
            reduced.corner_right[column] += c[0] * line.misclosure[0] + c[1] * line.misclosure[1];
            let change = [0, 1, 2].map(|k| c[0] * f[0][k] + c[1] * f[1][k]);
            match reduced.camera_shares[first_share..].iter_mut().find(|(own, _)| *own == column as u32) {
                Some((_, share)) => (0..3).for_each(|k| share[k] += change[k]),
                None => reduced.camera_shares.push((column as u32, change)),
            }
        }
    }

    /// Takes from the equations of the cameras what the elimination of a point takes.
    fn take_from_cameras(&self, sights: &[Sight], right: &[f64; 3], first_share: usize, reduced: &mut Reduced) {
        let (q, Reduced { camera_shares, shares, border, corner, corner_right, .. }) = (self.columns.number(), reduced);
        let own = &camera_shares[first_share..];
        let first = self.network.point_start[sights[0].point as usize];
        for (column, share) in own {
            let column = *column as usize;
            for (sight, z) in sights.iter().zip(&shares[first..]) {
                let at = self.network.pattern.place[sight.image as usize] as usize;
                for k in 0..N {
                    border[column][at * N + k] -= z[k] * share[0] + z[6 + k] * share[1] + z[12 + k] * share[2];
                }
            }
            for (row, other) in own {
                corner[*row as usize * q + column] -= dot3(share, other);
            }
            corner_right[column] -= dot3(share, right);
        }
    }

    /// Takes Z Zᵀ from the blocks of every two images that see a point, column by column.
    fn couple(&self, reduced: &mut Reduced) {
        let Network { sights, point_start, pattern, .. } = self.network;
        let mut slot = vec![u32::MAX; pattern.size()];
        for column in 0..pattern.size() {
            let own = pattern.start[column]..pattern.start[column + 1];
            own.clone().for_each(|at| slot[pattern.rows[at] as usize] = at as u32);
            let image = pattern.node[column] as usize;
            let sights_of_image = if self.network.fixed[image] { &[] } else { self.network.of_image(image) };
            for &sight in sights_of_image {
                let share = reduced.shares[sight as usize];
                let point = sights[sight as usize].point as usize;
                for other in point_start[point]..point_start[point + 1] {
                    let row = pattern.place[sights[other].image as usize] as usize;
                    if row > column && !self.network.fixed[sights[other].image as usize] {
                        subtract_product3(&mut reduced.matrix.below[slot[row] as usize], &reduced.shares[other], &share);
                    }
                }
            }
        }
    }

    fn add_positions(&self, state: &State, reduced: &mut Reduced) {
        for (image, prior) in self.gnss.iter().enumerate() {
            let Some(Weighted { position, weight }) = prior else { continue };
            let at = self.network.pattern.place[image] as usize;
            let antenna = self.systematic.antenna(state, image);
            let off = [0, 1, 2].map(|k| position[k] - antenna[k]);
            for k in 0..3 {
                reduced.matrix.diagonal[at][(3 + k) * N + 3 + k] += weight[k];
                reduced.scale[at][3 + k] += weight[k];
                reduced.right[at * N + 3 + k] += weight[k] * off[k];
            }
            if !self.systematic.is_empty() {
                self.add_systematic(state, image, weight, &off, reduced);
            }
        }
    }

    fn add_axes(&self, state: &State, reduced: &mut Reduced) {
        for (image, axis) in self.axes.iter().enumerate() {
            let Some(axis) = axis else { continue };
            let at = self.network.pattern.place[image] as usize;
            let right = &mut reduced.right[at * N..][..N];
            axis.add_to_image(&state.images[image], &mut reduced.matrix.diagonal[at], &mut reduced.scale[at], right);
        }
    }

    fn add_known(&self, state: &State, reduced: &mut Reduced) {
        let q = self.columns.number();
        for (column, known) in self.known.iter().enumerate() {
            let (camera, parameter) = self.columns.parameter[column];
            reduced.corner[column * q + column] += known.weight;
            reduced.corner_scale[column] += known.weight;
            reduced.corner_right[column] += known.weight * (known.value - state.cameras[camera][parameter]);
        }
    }

    fn add_constraints(&self, state: &State, reduced: &mut Reduced) {
        let (q, first) = (self.columns.number(), self.columns.parameter.len());
        for constraint in self.constraints {
            let sum = constraint.sum(self.columns, state);
            for (r, row) in constraint.row.iter().enumerate() {
                let weighted = constraint.weight * row;
                constraint.row.iter().enumerate().for_each(|(c, column)| reduced.corner[(first + r) * q + first + c] += weighted * column);
                reduced.corner_right[first + r] -= weighted * sum;
            }
        }
    }

    /// Makes the step of a fixed image zero.
    fn keep_fixed(&self, reduced: &mut Reduced) {
        for image in (0..self.network.images()).filter(|image| self.network.fixed[*image]) {
            let at = self.network.pattern.place[image] as usize;
            reduced.scale[at] = [1.0; N];
            (0..N).for_each(|k| reduced.matrix.diagonal[at][k * N + k] = 1.0);
        }
    }

    /// Holds one image, and another along the line between both: as many conditions as a free network has freedoms, which change
    /// nothing of its shape.
    fn hold(&self, state: &State, reduced: &mut Reduced) {
        let Some([held, far]) = self.held else { return };
        let at = self.network.pattern.place[held] as usize;
        for k in 0..N {
            reduced.matrix.diagonal[at][k * N + k] += reduced.scale[at][k];
        }
        let (from, to) = (state.images[held].position, state.images[far].position);
        let along = [0, 1, 2].map(|k| to[k] - from[k]);
        let length = dot3(&along, &along).sqrt();
        let at = self.network.pattern.place[far] as usize;
        let weight = (reduced.scale[at][3] + reduced.scale[at][4] + reduced.scale[at][5]) / (3.0 * length * length);
        for c in 0..3 {
            for r in 0..3 {
                reduced.matrix.diagonal[at][(3 + c) * N + 3 + r] += weight * along[c] * along[r];
            }
        }
    }
}
