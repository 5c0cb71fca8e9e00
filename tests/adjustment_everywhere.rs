//! A block is simulated and adjusted to the same bits natively and as wasm.

use tiepoint::{AdjustmentOptions, AdjustmentResult, Datum, FreeParameters, NetworkFlight, NetworkKind, adjust_block, simulate_network};

/// What all results come to; where the method changes, the failing test prints the new one.
const EXPECTED: u64 = 0xb060_f8cc_481d_db6e;

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn blocks_are_adjusted_to_the_same_bits_on_every_machine() {
    let mut hash = Hash::default();
    for datum in [Datum::Free, Datum::Gnss, Datum::GnssAndControl] {
        let flight = NetworkFlight {
            kind: NetworkKind::TwoHeights,
            strips: 3,
            stations: 4,
            gross_share: 0.03,
            gnss_sigma_m: 0.05,
            control_points: 5,
            radial: [-0.05, 0.02, 0.0],
            ..NetworkFlight::default()
        };
        let mut block = simulate_network(&flight).unwrap().observed;
        block.cameras[0].free = FreeParameters { radial: 2, ..FreeParameters::ALL };
        hash.add_result(&adjust_block(&block, &AdjustmentOptions { datum, ..AdjustmentOptions::default() }).unwrap());
    }
    assert_eq!(hash.0, EXPECTED, "got {:#018x}", hash.0);
}

/// FNV-1a.
struct Hash(u64);

impl Default for Hash {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Hash {
    fn add(&mut self, value: f64) {
        for byte in value.to_bits().to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }

    fn add_all<'a>(&mut self, values: impl IntoIterator<Item = &'a f64>) {
        values.into_iter().for_each(|value| self.add(*value));
    }

    fn add_result(&mut self, result: &AdjustmentResult) {
        for (image, statistics) in result.block.images.iter().zip(&result.images) {
            self.add_all(image.pose.rotation.as_flattened());
            self.add_all(&image.pose.position);
            self.add_all(&statistics.position_errors.unwrap());
            self.add_all(&statistics.angle_errors_deg.unwrap());
        }
        for (point, statistics) in result.block.points.iter().zip(&result.points) {
            self.add_all(point);
            self.add_all(statistics.iter().flat_map(|s| s.errors.as_ref().unwrap()));
        }
        for ray in &result.rays {
            self.add(f64::from(ray.verdict as u8));
            self.add_all(&ray.residual_px);
            self.add_all(ray.w.iter().chain(&ray.redundancy).flatten());
        }
        for camera in &result.cameras {
            self.add_all(camera.standard_errors.iter().flatten());
        }
    }
}
