//! A fingerprint of what a test computes.

/// FNV-1a.
pub struct Fingerprint(pub u64);

impl Default for Fingerprint {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Extend<u8> for Fingerprint {
    fn extend<I: IntoIterator<Item = u8>>(&mut self, bytes: I) {
        self.0 = bytes.into_iter().fold(self.0, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
    }
}

/// Of the bits of numbers.
#[allow(dead_code, reason = "not every test has numbers")]
pub fn of_numbers(values: impl IntoIterator<Item = f64>) -> u64 {
    let mut hash = Fingerprint::default();
    hash.extend(values.into_iter().flat_map(|value| value.to_bits().to_le_bytes()));
    hash.0
}
