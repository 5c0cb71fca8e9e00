//! Time, memory and errors of the reconstruction of simulated blocks: `cargo run --release --example reconstruction_scale [IMAGES…]`.

mod memory;

use memory::peak_mb;
use std::time::Instant;
use tiepoint::{
    BlockFlight, BlockOptions, ObservedPosition, ReconstructionOptions, SelectOptions, reconstruct_block, score_block, simulate_block,
    tie_points,
};

fn main() -> Result<(), tiepoint::Error> {
    let asked: Vec<usize> = std::env::args().skip(1).filter_map(|word| word.parse().ok()).collect();
    println!(
        "images points rays join_s assemble_s oriented models adjusted_points rmse_px sigma0_px position_m rounds iterations peak_mb_before peak_mb"
    );
    for images in if asked.is_empty() { vec![200, 1000, 5000] } else { asked } {
        let strips = (images as f64 / 2.0).sqrt().round() as usize;
        let flight = BlockFlight { strips, exposures: images / strips, features: 600, wrong: 0.1, ..BlockFlight::default() };
        let block = simulate_block(&flight)?;
        let start = Instant::now();
        let (points, _) = tie_points(&block.matches()?, &block.image_features(), &BlockOptions::default())?;
        let joined = start.elapsed().as_secs_f64();
        let gnss = |centre: [f64; 3]| ObservedPosition::Local { position: centre, sigma: [3.0, 3.0, 5.0] };
        let mut description = block.description(Some(1.02));
        description.images.iter_mut().zip(&block.exposures).for_each(|(image, e)| image.position = Some(gnss(e.centre)));
        let options = ReconstructionOptions { selection: Some(SelectOptions::default()), ..ReconstructionOptions::default() };
        let before = peak_mb();
        let start = Instant::now();
        let reconstruction = reconstruct_block(&description, &points, &block.image_features(), &options)?;
        let seconds = start.elapsed().as_secs_f64();
        let Some(model) = reconstruction.models.first() else { continue };
        let score = score_block(&reconstruction.block_model(0, &description, &points)?, &block.truth)?;
        let position_m = score.position_rmse_m.map_or(f64::NAN, |rmse| rmse.iter().map(|m| m * m).sum::<f64>().sqrt());
        println!(
            "{} {} {} {joined:.1} {seconds:.1} {} {} {} {:.3} {:.3} {position_m:.3} {} {} {before} {}",
            block.exposures.len(),
            points.len(),
            points.ray_count(),
            model.images.len(),
            reconstruction.models.len(),
            model.adjusted.points.iter().flatten().count(),
            model.adjusted.rmse_px,
            model.adjusted.sigma0_px.unwrap_or(f64::NAN),
            model.adjusted.rounds,
            model.adjusted.iterations,
            peak_mb()
        );
    }
    Ok(())
}
