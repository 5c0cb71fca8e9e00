//! Simulated blocks with what is known of them, for tests of their reconstruction.

use tiepoint::{
    BlockDescription, BlockFlight, BlockOptions, Reconstruction, ReconstructionOptions, SelectOptions, SimulatedBlock, TiePoints,
    reconstruct_block, score_block, simulate_block, tie_points,
};

pub struct Scene {
    pub block: SimulatedBlock,
    pub points: TiePoints,
    pub description: BlockDescription,
}

/// A block whose focal lengths are known up to a factor.
pub fn scene(flight: &BlockFlight, focal_factor: f64) -> Scene {
    let block = simulate_block(flight).unwrap();
    let (points, _) = tie_points(&block.matches().unwrap(), &block.image_features(), &BlockOptions::default()).unwrap();
    let description = block.description(Some(focal_factor));
    Scene { block, points, description }
}

impl Scene {
    pub fn reconstruct(&self, options: &ReconstructionOptions) -> Reconstruction {
        reconstruct_block(&self.description, &self.points, &self.block.image_features(), options).unwrap()
    }

    /// Root mean square error of the positions in m after a similarity, and of the rotations in degrees.
    pub fn errors(&self, reconstruction: &Reconstruction, model: usize) -> (f64, f64) {
        let model = reconstruction.block_model(model, &self.description, &self.points).unwrap();
        let score = score_block(&model, &self.block.truth).unwrap();
        let squares = score.position_rmse_m.unwrap().map(|rmse_m| rmse_m * rmse_m);
        (squares.iter().sum::<f64>().sqrt(), score.angle_rmse_deg.unwrap())
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
