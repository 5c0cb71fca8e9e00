//! Systematic errors of GNSS positions: the lever arm to the antenna, offsets and drifts of strips.
//!
//! What is observed of an image is X₀ + Mᵀl + o + t·d: l is the lever arm in the axes of the camera, o the offset and d the drift of its strip, t the
//! place along the strip. A small turn δ about the photo's axes (M becomes R(δ)·M) moves it by Mᵀ(l × δ). They are unknowns of the adjustment beside
//! the camera parameters, shared by many images: columns in the border of the normal equations that touch images alone, no points.
//!
//! # Source
//! Ackermann 1992, Kinematic GPS control for photogrammetry (offset and drift of each strip); Kraus 2007, Photogrammetry (eccentricity of
//! the antenna).

use super::block::Block;
use super::network::Columns;
use super::similarity::{LEAST_WIDTH, relative_width};
use super::state::State;
use super::strips::{Strip, strips};
use super::systematic_result::{SystematicError, SystematicResult};
use super::weighted::Weighted;
use crate::GnssErrors;
use crate::camera::Pose;
use crate::math::cross;

/// The systematic errors that the positions of a block may have. Each has three values, which [`State::systematic`] holds; those of none are 0.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct SystematicErrors {
    pub errors: Vec<SystematicError>,
    pub strips: Vec<Strip>,
    /// Whether any were to be estimated: a block without strips has none all the same.
    pub is_wanted: bool,
    /// Images in no strip where errors of strips are estimated: theirs is another one that nothing else shows, so that their positions tell nothing.
    /// None where most positions are in no strip, or those in strips lie on one line.
    pub left_out: Vec<usize>,
    /// Of each image; empty where no errors are estimated.
    of_images: Vec<OwnErrors>,
}

/// The errors of the position of an image, by their indices, with its place along its strip.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
struct OwnErrors {
    lever_arm: Option<usize>,
    offset: Option<usize>,
    drift: Option<usize>,
    place: f64,
}

impl SystematicErrors {
    /// Those that may be estimated of the positions of a block, whose images stand in the order in which they were taken.
    pub fn of_block(block: &Block, errors: GnssErrors, lever_arm: bool) -> Self {
        if errors == GnssErrors::None && !lever_arm {
            return Self::default();
        }
        let observed = |image: &super::block::BlockImage| image.gnss.filter(|gnss| gnss.sigma.iter().any(Option::is_some));
        let has_position = |camera: usize| block.images.iter().any(|image| image.camera == camera && observed(image).is_some());
        // By what the images have of their shape: an observed position may be wrong.
        let strips = strips(&block.images.iter().map(|image| image.pose.position).collect::<Vec<_>>());
        let lever_arms = (0..block.cameras.len()).filter(|camera| lever_arm && has_position(*camera));
        let mut all: Vec<SystematicError> = lever_arms.map(|camera| SystematicError::LeverArm { camera }).collect();
        match errors {
            GnssErrors::None => {}
            GnssErrors::Offset => all.push(SystematicError::Offset),
            GnssErrors::StripOffsets => all.extend((0..strips.len()).map(|strip| SystematicError::StripOffset { strip })),
            GnssErrors::StripDrifts => {
                all.extend((0..strips.len()).map(|strip| SystematicError::StripOffset { strip }));
                all.extend((0..strips.len()).map(|strip| SystematicError::StripDrift { strip }));
            }
        }
        let all = Self { is_wanted: true, ..Self::new(block, all, strips) };
        let images = (0..block.images.len()).filter(|image| all.is_of_strips() && observed(&block.images[*image]).is_some());
        let (within, beyond): (Vec<usize>, Vec<usize>) = images.partition(|image| all.of_images[*image].offset.is_some());
        let places: Vec<[f64; 3]> = within.iter().map(|image| block.images[*image].pose.position).collect();
        let are_enough = beyond.len() < within.len() && relative_width(&places) >= LEAST_WIDTH;
        Self { left_out: if are_enough { beyond } else { Vec::new() }, ..all }
    }

    /// Those of a finished adjustment; none where none were to be estimated.
    pub fn of_result(block: &Block, result: Option<&SystematicResult>) -> Self {
        let errors = |result: &SystematicResult| result.errors.iter().map(|statistics| statistics.error).collect();
        result.map_or_else(Self::default, |result| Self::new(block, errors(result), result.strips.clone()))
    }

    /// Given ones of given strips.
    pub fn new(block: &Block, errors: Vec<SystematicError>, strips: Vec<Strip>) -> Self {
        if errors.is_empty() {
            return Self { strips, ..Self::default() };
        }
        let mut of_images = vec![OwnErrors::default(); block.images.len()];
        for (strip, Strip { images, places }) in strips.iter().enumerate() {
            images.iter().zip(places).for_each(|(image, place)| of_images[*image].place = *place);
            for (index, error) in errors.iter().enumerate() {
                match error {
                    SystematicError::StripOffset { strip: own } if *own == strip => {
                        images.iter().for_each(|image| of_images[*image].offset = Some(index));
                    }
                    SystematicError::StripDrift { strip: own } if *own == strip => {
                        images.iter().for_each(|image| of_images[*image].drift = Some(index));
                    }
                    _ => {}
                }
            }
        }
        for (index, error) in errors.iter().enumerate() {
            for (own, image) in of_images.iter_mut().zip(&block.images) {
                match error {
                    SystematicError::LeverArm { camera } if *camera == image.camera => own.lever_arm = Some(index),
                    SystematicError::Offset => own.offset = Some(index),
                    _ => {}
                }
            }
        }
        Self { errors, strips, is_wanted: true, left_out: Vec::new(), of_images }
    }

    pub fn is_empty(&self) -> bool {
        self.errors.is_empty()
    }

    /// Whether any error is that of a strip.
    pub fn is_of_strips(&self) -> bool {
        self.errors.iter().any(|error| matches!(error, SystematicError::StripOffset { .. } | SystematicError::StripDrift { .. }))
    }

    /// Whether any error grows along a strip.
    pub fn is_of_drifts(&self) -> bool {
        self.errors.iter().any(|error| matches!(error, SystematicError::StripDrift { .. }))
    }

    /// Where an observed position has the antenna of an image: the projection centre where no errors are estimated.
    pub fn antenna(&self, state: &State, image: usize) -> [f64; 3] {
        let pose = &state.images[image];
        let Some(own) = self.of_images.get(image) else { return pose.position };
        let value = |error: Option<usize>| error.map_or([0.0; 3], |error| state.systematic[error]);
        let (lever, offset, drift) = (in_object_space(pose, &value(own.lever_arm)), value(own.offset), value(own.drift));
        [0, 1, 2].map(|k| pose.position[k] + lever[k] + offset[k] + own.place * drift[k])
    }

    /// How the antenna of an image moves with the three turns of its image: a row a coordinate.
    pub fn by_turns(&self, state: &State, image: usize) -> [[f64; 3]; 3] {
        let lever = self.of_images.get(image).and_then(|own| own.lever_arm).map_or([0.0; 3], |error| state.systematic[error]);
        let columns =
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|turn| in_object_space(&state.images[image], &cross(&lever, &turn)));
        [0, 1, 2].map(|k| columns.map(|column| column[k]))
    }

    /// How the antenna of an image moves with each column of the border that it has a part in: X, Y, Z.
    pub fn by_columns(&self, columns: &Columns, state: &State, image: usize) -> Vec<(usize, [f64; 3])> {
        let Some(own) = self.of_images.get(image) else { return Vec::new() };
        let unit = |axis: usize, length: f64| [0, 1, 2].map(|k| if k == axis { length } else { 0.0 });
        let of = |error: Option<usize>, axis: usize| error.and_then(|error| columns.of_systematic[error][axis]);
        let mut all = Vec::new();
        for axis in 0..3 {
            let lever = || in_object_space(&state.images[image], &unit(axis, 1.0));
            all.extend(of(own.lever_arm, axis).map(|column| (column, lever())));
            all.extend(of(own.offset, axis).map(|column| (column, unit(axis, 1.0))));
            all.extend(of(own.drift, axis).map(|column| (column, unit(axis, own.place))));
        }
        all
    }

    /// Which values the positions that take part say anything of: a drift takes two positions with the coordinate, an offset one.
    pub fn observed(&self, gnss: &[Option<Weighted>]) -> Vec<[bool; 3]> {
        let mut counts = vec![[0_usize; 3]; self.errors.len()];
        for (own, prior) in self.of_images.iter().zip(gnss).filter_map(|(own, prior)| Some((own, prior.as_ref()?))) {
            for k in (0..3).filter(|k| prior.weight[*k] > 0.0) {
                own.offset.into_iter().chain(own.drift).for_each(|error| counts[error][k] += 1);
                own.lever_arm.into_iter().for_each(|error| counts[error].iter_mut().for_each(|count| *count += 1));
            }
        }
        let least = |error: &SystematicError| if matches!(error, SystematicError::StripDrift { .. }) { 2 } else { 1 };
        self.errors.iter().zip(counts).map(|(error, counts)| counts.map(|count| count >= least(error))).collect()
    }
}

/// Mᵀv.
fn in_object_space(pose: &Pose, v: &[f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| (0..3).map(|row| pose.rotation[row][k] * v[row]).sum())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::adjustment::block::{BlockImage, PositionPrior};
    use crate::adjustment::sparse::N;
    use crate::camera::{Camera, FreeParameters, rotation_from_angles};

    /// Two strips of four images each, flown to and fro.
    fn block() -> Block {
        let camera = Camera {
            width_px: 100,
            height_px: 100,
            focal_px: 100.0,
            principal_point_px: [50.0; 2],
            radial: [0.0; 3],
            tangential: [0.0; 2],
            pixel_mm: None,
            free: FreeParameters::default(),
        };
        let image = |index: usize| {
            let (strip, along) = (index / 4, if index < 4 { index % 4 } else { 3 - index % 4 });
            let position = [20.0 * along as f64, 30.0 * strip as f64, 100.0];
            let pose = Pose::new(&rotation_from_angles(0.05, -0.1, 0.3 + 3.0 * strip as f64), position);
            BlockImage { camera: 0, pose, gnss: Some(PositionPrior { position, sigma: [Some(0.1); 3] }), axis: None }
        };
        Block { cameras: vec![camera], images: (0..8).map(image).collect(), ..Block::default() }
    }

    #[test]
    fn derivatives_are_those_of_differences() {
        let block = block();
        let systematic = SystematicErrors::of_block(&block, GnssErrors::StripDrifts, true);
        assert_eq!(systematic.strips.iter().map(|strip| strip.images[0]).collect::<Vec<_>>(), [0, 4]);
        assert_eq!(systematic.errors.len(), 5);
        let columns = Columns::new(&[[false; 8]]).with_systematic(&[[true; 3]; 5]);
        let mut state = State::of(&block).with_systematic(systematic.errors.len());
        state.systematic.iter_mut().flatten().enumerate().for_each(|(k, value)| *value = 0.3 * k as f64 - 1.0);
        for image in [0, 2, 5] {
            let turns = systematic.by_turns(&state, image);
            let slope = |moved: &dyn Fn(f64) -> State| {
                let (a, b) = (systematic.antenna(&moved(1e-5), image), systematic.antenna(&moved(-1e-5), image));
                [0, 1, 2].map(|k| (a[k] - b[k]) / 2e-5)
            };
            for turn in 0..3 {
                let found = slope(&|h| {
                    let (mut step, mut moved) = ([0.0; N], state.clone());
                    step[turn] = h;
                    moved.images[image] = state.images[image].moved(&step);
                    moved
                });
                assert!((0..3).all(|k| (found[k] - turns[k][turn]).abs() < 1e-6), "{image} {turn}: {found:?} {turns:?}");
            }
            let by_columns = systematic.by_columns(&columns, &state, image);
            for (column, (error, axis)) in columns.systematic.iter().enumerate() {
                let found = slope(&|h| {
                    let mut moved = state.clone();
                    moved.systematic[*error][*axis] += h;
                    moved
                });
                let told = by_columns.iter().find(|(own, _)| *own == column).map_or([0.0; 3], |(_, slope)| *slope);
                assert!((0..3).all(|k| (found[k] - told[k]).abs() < 1e-6), "{image} {error} {axis}: {found:?} {told:?}");
            }
        }
    }

    #[test]
    fn what_no_position_observes_is_known() {
        let block = block();
        let systematic = SystematicErrors::of_block(&block, GnssErrors::StripDrifts, false);
        let prior = |weight| Some(Weighted { position: [0.0; 3], weight });
        let mut gnss = vec![None; 8];
        (gnss[0], gnss[1], gnss[5]) = (prior([1.0, 1.0, 0.0]), prior([1.0, 1.0, 0.0]), prior([1.0; 3]));
        assert_eq!(systematic.observed(&gnss), [[true, true, false], [true; 3], [true, true, false], [false; 3]]);
        assert!(SystematicErrors::of_block(&block, GnssErrors::None, false).is_empty());
    }
}
