//! Simulated blocks with what is known of them, for tests of their reconstruction.

use tiepoint::{
    BlockDescription, BlockFlight, BlockOptions, KnownCamera, KnownImage, Reconstruction, ReconstructionOptions, SelectOptions, Similarity,
    SimulatedBlock, TiePoints, reconstruct_block, simulate_block, tie_points,
};

pub struct Scene {
    pub block: SimulatedBlock,
    pub points: TiePoints,
    pub description: BlockDescription,
}

/// A block whose focal lengths are known up to a factor.
pub fn scene(flight: &BlockFlight, focal_factor: f64) -> Scene {
    let block = simulate_block(flight).unwrap();
    let (points, _) = tie_points(&block.matches().unwrap(), &BlockOptions::default()).unwrap();
    let cameras = block.exposures.iter().map(|exposure| exposure.camera as usize + 1).max().unwrap();
    let focal = |camera: usize| block.exposures.iter().find(|e| e.camera as usize == camera).unwrap().focal_px * focal_factor;
    let camera = |camera: usize| KnownCamera::of_size(block.width_px, block.height_px, Some(focal(camera)));
    let image = |(index, e): (usize, &tiepoint::Exposure)| KnownImage {
        name: format!("{index:04}.jpg"),
        camera: e.camera as usize,
        position: None,
    };
    let description = BlockDescription {
        cameras: (0..cameras).map(camera).collect(),
        images: block.exposures.iter().enumerate().map(image).collect(),
        control: Vec::new(),
    };
    Scene { block, points, description }
}

impl Scene {
    pub fn reconstruct(&self, options: &ReconstructionOptions) -> Reconstruction {
        reconstruct_block(&self.description, &self.points, &self.block.image_features(), options).unwrap()
    }

    /// Root mean square error of the positions in m after a similarity, and of the rotations in degrees.
    pub fn errors(&self, reconstruction: &Reconstruction, model: usize) -> (f64, f64) {
        let model = &reconstruction.models[model];
        let images = || model.images.iter().zip(&model.adjusted.block.images);
        let pairs: Vec<_> = images().map(|(k, image)| (image.pose.position, self.block.exposures[*k].centre)).collect();
        let onto = Similarity::between(&pairs).unwrap();
        let (mut square, mut turns) = (0.0, 0.0);
        for (k, image) in images() {
            let (at, exposure) = (onto.point(&image.pose.position), &self.block.exposures[*k]);
            square += (0..3).map(|i| (at[i] - exposure.centre[i]) * (at[i] - exposure.centre[i])).sum::<f64>();
            // The angle of M Rᵀ against the true rotation, by the trace.
            let turned = image.pose.rotation.map(|row| [0, 1, 2].map(|c| (0..3).map(|j| row[j] * onto.rotation[c][j]).sum::<f64>()));
            let trace: f64 = (0..3).flat_map(|r| (0..3).map(move |c| (r, c))).map(|(r, c)| turned[r][c] * exposure.rotation[(r, c)]).sum();
            turns += (0.5 * (trace - 1.0)).clamp(-1.0, 1.0).acos().to_degrees().powi(2);
        }
        let n = model.images.len() as f64;
        ((square / n).sqrt(), (turns / n).sqrt())
    }

    pub fn report(&self, what: &str, reconstruction: &Reconstruction) {
        for (k, model) in reconstruction.models.iter().enumerate() {
            let (position, angle) = self.errors(reconstruction, k);
            println!(
                "{what}, model {k}: {} of {} images, {} points, {} rays, {} left out, RMSE {:.3} px, sigma0 {:?}, positions {position:.3} m, angles {angle:.4} deg, {:?}",
                model.images.len(),
                self.description.images.len(),
                model.points.len(),
                model.rays.len(),
                model.rejected.len(),
                model.adjusted.rmse_px,
                model.adjusted.sigma0_px,
                model.warnings,
            );
        }
        reconstruction
            .unoriented
            .iter()
            .for_each(|image| println!("{what}: {}: {}", self.description.images[image.image].name, image.reason));
    }
}

pub fn selected() -> ReconstructionOptions {
    ReconstructionOptions { selection: Some(SelectOptions::default()), ..ReconstructionOptions::default() }
}
