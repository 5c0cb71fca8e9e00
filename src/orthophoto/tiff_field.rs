//! The fields of a directory of a TIFF, as bytes.

/// A field of a directory.
pub(super) enum Field {
    Text(&'static str),
    Shorts(Vec<u16>),
    Longs(Vec<u32>),
    Places(Vec<u64>),
    Doubles(Vec<f64>),
}

impl Field {
    /// Its kind, the number of its values, and these.
    pub fn encoded(&self) -> (u16, usize, Vec<u8>) {
        match self {
            Self::Text(text) => (2, text.len() + 1, [text.as_bytes(), b"\0"].concat()),
            Self::Shorts(values) => (3, values.len(), values.iter().flat_map(|value| value.to_le_bytes()).collect()),
            Self::Longs(values) => (4, values.len(), values.iter().flat_map(|value| value.to_le_bytes()).collect()),
            Self::Places(values) => (16, values.len(), values.iter().flat_map(|value| value.to_le_bytes()).collect()),
            Self::Doubles(values) => (12, values.len(), values.iter().flat_map(|value| value.to_le_bytes()).collect()),
        }
    }
}
