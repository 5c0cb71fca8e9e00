//! Time, memory and errors of the reconstruction of simulated blocks: `cargo run --release --example reconstruction_scale [IMAGES…]`.

use std::time::Instant;
use tiepoint::{
    BlockDescription, BlockFlight, BlockOptions, KnownCamera, KnownImage, ObservedPosition, ReconstructionOptions, SelectOptions,
    Similarity, reconstruct_block, simulate_block, tie_points,
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
        let (points, _) = tie_points(&block.matches()?, &BlockOptions::default())?;
        let joined = start.elapsed().as_secs_f64();
        let gnss = |centre: [f64; 3]| ObservedPosition::Local { position: centre, sigma: [3.0, 3.0, 5.0] };
        let description = BlockDescription {
            cameras: vec![KnownCamera::of_size(block.width_px, block.height_px, Some(1.02 * block.exposures[0].focal_px))],
            images: (block.exposures.iter().enumerate())
                .map(|(k, e)| KnownImage { name: format!("{k}.jpg"), camera: 0, position: Some(gnss(e.centre)) })
                .collect(),
            control: Vec::new(),
        };
        let options = ReconstructionOptions { selection: Some(SelectOptions::default()), ..ReconstructionOptions::default() };
        let before = peak_mb();
        let start = Instant::now();
        let reconstruction = reconstruct_block(&description, &points, &block.image_features(), &options)?;
        let seconds = start.elapsed().as_secs_f64();
        let Some(model) = reconstruction.models.first() else { continue };
        let positions = model.images.iter().zip(&model.adjusted.block.images);
        let pairs: Vec<_> = positions.map(|(k, image)| (image.pose.position, block.exposures[*k].centre)).collect();
        let onto = Similarity::between(&pairs);
        let square = |(from, to): &([f64; 3], [f64; 3])| {
            let at = onto.map_or(*from, |onto| onto.point(from));
            (0..3).map(|i| (at[i] - to[i]) * (at[i] - to[i])).sum::<f64>()
        };
        println!(
            "{} {} {} {joined:.1} {seconds:.1} {} {} {} {:.3} {:.3} {:.3} {} {} {before} {}",
            block.exposures.len(),
            points.len(),
            points.ray_count(),
            model.images.len(),
            reconstruction.models.len(),
            model.adjusted.points.iter().flatten().count(),
            model.adjusted.rmse_px,
            model.adjusted.sigma0_px.unwrap_or(f64::NAN),
            (pairs.iter().map(square).sum::<f64>() / pairs.len() as f64).sqrt(),
            model.adjusted.rounds,
            model.adjusted.iterations,
            peak_mb()
        );
    }
    Ok(())
}

/// The most memory that the process has had, where the system tells.
fn peak_mb() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|rest| rest.split_whitespace().next()?.parse::<u64>().ok()).unwrap_or(0) / 1024
}
