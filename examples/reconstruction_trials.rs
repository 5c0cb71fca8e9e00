//! How well simulated blocks are reconstructed, kind by kind: `cargo run --release --example reconstruction_trials [SEEDS]`.

use std::time::Instant;
use tiepoint::{
    BlockFlight, BlockOptions, BlockView, ReconstructionOptions, SelectOptions, reconstruct_block, score_block, simulate_block, tie_points,
};

/// A kind of block: its name, its flight, and the focal length that is given by the true one; none where it is not known.
type Kind = (&'static str, BlockFlight, Option<f64>);

fn main() -> Result<(), tiepoint::Error> {
    let seeds = std::env::args().nth(1).and_then(|word| word.parse().ok()).unwrap_or(5);
    println!("kind: seed, images oriented of all, models, points, RMSE px, sigma0 px, focal by the true one, positions m, seconds");
    for (name, flight, focal) in kinds() {
        for seed in 1..=seeds {
            let block = simulate_block(&BlockFlight { seed, ..flight.clone() })?;
            let (points, _) = tie_points(&block.matches()?, &block.image_features(), &BlockOptions::default())?;
            let options = ReconstructionOptions { selection: Some(SelectOptions::default()), ..ReconstructionOptions::default() };
            let description = block.description(focal);
            let start = Instant::now();
            let reconstruction = reconstruct_block(&description, &points, &block.image_features(), &options)?;
            let seconds = start.elapsed().as_secs_f64();
            let Some(model) = reconstruction.models.first() else {
                println!("{name}: {seed}, nothing oriented");
                continue;
            };
            let score = score_block(&reconstruction.block_model(0, &description, &points)?, &block.truth)?;
            let position_m = score.position_rmse_m.map_or(f64::NAN, |rmse| rmse.iter().map(|m| m * m).sum::<f64>().sqrt());
            let focal = model.adjusted.block.cameras[0].focal_px / block.exposures[model.images[0]].focal_px;
            println!(
                "{name}: {seed}, {} of {}, {}, {}, {:.3}, {:.3}, {focal:.4}, {position_m:.3}, {seconds:.1}",
                model.images.len(),
                block.exposures.len(),
                reconstruction.models.len(),
                model.adjusted.points.iter().flatten().count(),
                model.adjusted.rmse_px,
                model.adjusted.sigma0_px.unwrap_or(f64::NAN),
            );
            reconstruction.unoriented.iter().take(3).for_each(|image| println!("  {}: {}", image.image, image.reason));
        }
    }
    Ok(())
}

fn kinds() -> Vec<Kind> {
    let nadir = BlockFlight::default();
    let two_heights = BlockFlight { view: BlockView::TwoHeights, ..nadir.clone() };
    // Forward and backward views of a short strip show other ground than the views down: the block is longer than it is high.
    let oblique =
        BlockFlight { view: BlockView::Oblique, exposures: 9, forward_overlap: 0.5, side_overlap: 0.4, features: 1200, ..nadir.clone() };
    vec![
        ("nadir", nadir.clone(), Some(1.0)),
        ("nadir, focal length 4 % too long", nadir.clone(), Some(1.04)),
        ("nadir, focal length not known", nadir.clone(), None),
        ("flat", BlockFlight { relief_m: 0.0, ..nadir.clone() }, Some(1.0)),
        ("flat, focal length 4 % too short", BlockFlight { relief_m: 0.0, ..nadir.clone() }, Some(0.96)),
        ("two heights", two_heights.clone(), Some(1.04)),
        ("two heights, focal length not known", two_heights, None),
        ("40 % of the matches wrong", BlockFlight { wrong: 0.4, ..nadir.clone() }, Some(1.0)),
        ("40 % wrong, half of them repeated", BlockFlight { wrong: 0.4, repeated: 0.5, ..nadir }, Some(1.04)),
        ("oblique, focal lengths 4 % too long", oblique.clone(), Some(1.04)),
        ("oblique, 40 % wrong", BlockFlight { wrong: 0.4, ..oblique }, Some(1.0)),
    ]
}
