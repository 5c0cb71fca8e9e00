//! A block is simulated and adjusted to the same bits natively and as wasm.

mod fingerprint;

use tiepoint::{
    AdjustmentOptions, AdjustmentResult, BlockFlight, BlockPreset, BlockView, Datum, FreeParameters, adjust_block, simulate_network,
};

/// What all results come to; where the method changes, the failing test prints the new one.
const EXPECTED: u64 = 0xd4c8_c764_6859_166b;

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn blocks_are_adjusted_to_the_same_bits_on_every_machine() {
    let mut numbers = Vec::new();
    for datum in [Datum::Free, Datum::Gnss, Datum::GnssAndControl] {
        let flight = BlockFlight {
            view: BlockView::TwoHeights,
            strips: 3,
            exposures: 4,
            gross_share: 0.03,
            receiver_m: 0.05,
            control_points: 5,
            radial: [-0.05, 0.02, 0.0],
            ..BlockPreset::Network.flight()
        };
        let mut block = simulate_network(&flight).unwrap().observed;
        block.cameras[0].free = FreeParameters { radial: 2, ..FreeParameters::ALL };
        numbers.extend(numbers_of(&adjust_block(&block, &AdjustmentOptions { datum, ..AdjustmentOptions::default() }).unwrap()));
    }
    let found = fingerprint::of_numbers(numbers);
    assert_eq!(found, EXPECTED, "got {found:#018x}");
}

fn numbers_of(result: &AdjustmentResult) -> Vec<f64> {
    let mut numbers = Vec::new();
    for (image, statistics) in result.block.images.iter().zip(&result.images) {
        numbers.extend(image.pose.rotation.as_flattened());
        numbers.extend(image.pose.position);
        numbers.extend(statistics.position_errors.unwrap());
        numbers.extend(statistics.angle_errors_deg.unwrap());
    }
    for (point, statistics) in result.block.points.iter().zip(&result.points) {
        numbers.extend(point);
        numbers.extend(statistics.iter().flat_map(|s| s.errors.unwrap()));
    }
    for ray in &result.rays {
        numbers.push(f64::from(ray.verdict as u8));
        numbers.extend(ray.residual_px);
        numbers.extend(ray.w.iter().chain(&ray.redundancy).flatten());
    }
    numbers.extend(result.cameras.iter().flat_map(|camera| camera.standard_errors.iter().flatten()));
    numbers
}
