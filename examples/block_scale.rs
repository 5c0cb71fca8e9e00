//! Time and memory of multi-ray points and their selection for blocks of 1,000 and 5,000 images:
//! `cargo run --release --example block_scale [IMAGES…]`.

mod memory;

use memory::peak_mb;
use std::time::Instant;
use tiepoint::{BlockFlight, BlockOptions, SelectOptions, select_points, simulate_block, tie_points};

fn main() -> Result<(), tiepoint::Error> {
    let asked: Vec<usize> = std::env::args().skip(1).filter_map(|word| word.parse().ok()).collect();
    println!("images features matches points rays chosen rays_an_image matches_s join_s select_s ns_a_match peak_mb_simulated peak_mb");
    for images in if asked.is_empty() { vec![1000, 5000] } else { asked } {
        let strips = (images as f64 / 2.0).sqrt().round() as usize;
        let flight = BlockFlight { strips, exposures: images / strips, features: 600, wrong: 0.1, ..BlockFlight::default() };
        let block = simulate_block(&flight)?;
        let simulated = peak_mb();
        let start = Instant::now();
        let matches = block.matches()?;
        let gathered = start.elapsed().as_secs_f64();
        let (points, _) = tie_points(&matches, &block.image_features(), &BlockOptions::default())?;
        let joined = start.elapsed().as_secs_f64();
        let chosen = select_points(&points, &block.image_features(), &SelectOptions::default())?;
        let selected = start.elapsed().as_secs_f64();
        let features: usize = block.features.iter().map(Vec::len).sum();
        println!(
            "{} {features} {} {} {} {} {:.1} {gathered:.2} {:.2} {:.2} {:.0} {simulated} {}",
            block.exposures.len(),
            matches.len(),
            points.len(),
            points.ray_count(),
            chosen.points.len(),
            f64::from(chosen.rays_of_images.iter().sum::<u32>()) / block.exposures.len() as f64,
            joined - gathered,
            selected - joined,
            1e9 * selected / matches.len() as f64,
            peak_mb()
        );
    }
    Ok(())
}
