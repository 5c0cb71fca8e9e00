//! Epipolar images: two oriented images resampled so that what both show lies in the same row of either.
//!
//! A pair or a block → `pair` → two `view`s → `geometry` of the epipolar images → `resample`.

mod geometry;
mod pair;
mod resample;
mod system;
mod view;

pub use geometry::{EpipolarGeometry, Parallaxes};
pub use pair::StereoPair;
pub use resample::{EpipolarImages, write_anaglyph};
pub use system::StereoSystem;
pub use view::StereoView;
