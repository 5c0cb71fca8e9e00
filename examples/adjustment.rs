//! Adjusts a block read as JSON and tells how long that took: what `tools/bench/adjustment.py` compares with other programs.
//!
//! `adjustment simulate FLIGHT.json BLOCK.json TRUTH.json` writes a simulated block; `adjustment adjust BLOCK.json OPTIONS.json RESULT.json` adjusts one
//! and prints a line of JSON.

use std::error::Error;
use std::fs;
use std::time::Instant;
use tiepoint::{AdjustmentOptions, Block, BlockFlight, BlockPreset, adjust_block, simulate_network, with_defaults};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["simulate", flight, block, truth] => {
            let mut fields = serde_json::to_value(BlockPreset::Network.flight())?;
            let given: serde_json::Map<String, serde_json::Value> = serde_json::from_str(&fs::read_to_string(flight)?)?;
            given.into_iter().for_each(|(name, value)| fields[name] = value);
            let flight: BlockFlight = serde_json::from_value(fields)?;
            let simulated = simulate_network(&flight)?;
            fs::write(block, serde_json::to_vec(&simulated.observed)?)?;
            fs::write(truth, serde_json::to_vec(&simulated.truth)?)?;
        }
        ["adjust", block, options, result] => {
            let block: Block = serde_json::from_slice(&fs::read(block)?)?;
            let options: AdjustmentOptions = with_defaults(serde_json::from_str(&fs::read_to_string(options)?)?)?;
            let start = Instant::now();
            let adjusted = adjust_block(&block, &options)?;
            let seconds = start.elapsed().as_secs_f64();
            let figures = serde_json::json!({
                "seconds": seconds,
                "iterations": adjusted.iterations,
                "rounds": adjusted.rounds,
                "rmse_px": adjusted.rmse_px,
                "sigma0_px": adjusted.sigma0_px,
                "cameras": adjusted.cameras,
            });
            println!("{figures}");
            fs::write(result, serde_json::to_vec(&adjusted.block)?)?;
        }
        _ => return Err("usage: adjustment simulate FLIGHT BLOCK TRUTH | adjustment adjust BLOCK OPTIONS RESULT".into()),
    }
    Ok(())
}
