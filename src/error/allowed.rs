//! What an option allows in place of what was got.

use crate::message::messages;
use serde::{Deserialize, Serialize};

messages! {
    /// What an option allows. `min` and `max` are allowed themselves where the kind does not say otherwise.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
    #[non_exhaustive]
    pub enum Allowed as "allowed" {
        // By the kind of a parameter.
        Integer { min: f64, max: f64, odd: bool },
        Real { min: f64, max: f64 },
        Flag,
        Text,
        /// Options by their names.
        Object,
        /// One of these words, with commas between; or what a project of a former version says in words.
        Words { words: String },
        // Numbers.
        /// Two numbers, of px or of any unit.
        TwoNumbers { min: f64, max: f64, px: bool },
        /// Not `above` itself.
        AboveUpTo { above: f64, max: f64 },
        AtLeast { min: f64 },
        ButZero { min: f64, max: f64 },
        /// Terms of a radial distortion that takes no place farther out to one nearer in, up to so many mm from the principal point.
        Unfolded { reach_mm: f64 },
        /// So many numbers that are finite.
        Finite { numbers: usize },
        // Beside other options.
        /// One of two options, not both.
        OneOfTwo { first: String, second: String },
        OddForForstner,
        WithoutFiducials { min: f64, max: f64 },
        ForPhotoCoordinates { min: f64, max: f64 },
        // Simulated flights.
        /// Rows of a photo of this width.
        PhotoRows { most: f64 },
        /// A tenth of the flying height.
        PhotoRelief { most_m: f64 },
        HeightAboveBuildings { least_m: f64 },
        SmallImagesOfTilted,
        SmallPixels,
        LongFocalLength,
        OrthophotoPixel { above: f64 },
        /// Photos of a pair or of a block.
        HeightOverGround { most_m: f64, longest_m: f64, block: bool },
    }
}
