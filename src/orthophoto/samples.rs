//! What stands in the pixels of files that are written.

/// What stands in a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Samples {
    /// Bytes of one band or of three, side by side; 0 stands for nothing.
    Bytes(usize),
    /// A number of 32 bits, the lowest byte first; NaN stands for nothing.
    Float,
}

impl Samples {
    /// Bytes of a pixel.
    pub fn bytes(self) -> usize {
        match self {
            Self::Bytes(bands) => bands,
            Self::Float => 4,
        }
    }

    /// So many pixels that show nothing.
    pub fn nothing(self, pixels: usize) -> Vec<u8> {
        match self {
            Self::Bytes(bands) => vec![0; pixels * bands],
            Self::Float => f32::NAN.to_le_bytes().repeat(pixels),
        }
    }
}

/// The mean of those of four pixels that show something.
pub(super) fn mean_of_shown(pixels: [&[u8]; 4], into: &mut [u8]) {
    let shown = || pixels.iter().filter(|pixel| pixel.iter().any(|value| *value != 0));
    let number = shown().count() as u32;
    for (band, mean) in into.iter_mut().enumerate().filter(|_| number > 0) {
        let sum: u32 = shown().map(|pixel| u32::from(pixel[band])).sum();
        *mean = ((sum + number / 2) / number) as u8;
    }
}
