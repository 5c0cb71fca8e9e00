//! The same files, sound and damaged, give the same grey values and the same refusals natively and as wasm.

mod fingerprint;
#[path = "decode/jpeg_writer.rs"]
mod jpeg_writer;
#[path = "decode/samples.rs"]
mod samples;

use fingerprint::Fingerprint;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;
use tiepoint::{DecodeLimits, decode};

/// What all files come to; where a decoder crate changes its values, the failing test prints the new one.
const EXPECTED: u64 = 0x06d5_812f_81ab_1735;

const DAMAGED_COPIES: usize = 200;

#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
#[cfg_attr(not(target_arch = "wasm32"), test)]
fn files_decode_to_the_same_values_on_every_machine() {
    // Small enough that no machine refuses what another decodes.
    let limits = DecodeLimits { max_pixels: 1_000_000, max_memory_bytes: 64 << 20 };
    let mut random = Pcg32::new(11, 0);
    let mut hash = Fingerprint::default();
    let (mut images, mut refusals) = (0, 0);
    for (_, file) in samples::files() {
        for copy in 0..=DAMAGED_COPIES {
            let mut file = file.clone();
            for _ in 0..copy.min(3) {
                let at = random.next_u32() as usize % file.len();
                file[at] ^= 1 << (random.next_u32() % 8);
            }
            match decode(&file, &limits) {
                Ok(decoded) => {
                    hash.extend(decoded.grey.data().iter().copied());
                    images += 1;
                }
                Err(error) => {
                    hash.extend(error.code().bytes());
                    refusals += 1;
                }
            }
        }
    }
    assert!(images > 500 && refusals > 500, "{images} images, {refusals} refusals");
    assert_eq!(hash.0, EXPECTED, "now {:#x}", hash.0);
}
