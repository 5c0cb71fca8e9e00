//! Where a camera that a file names is known from, and what speaks against it.

use crate::message::messages;
use serde::{Deserialize, Serialize};

messages! {
    /// Where the focal length in px of a file's camera comes from, the most certain first.
    #[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum CameraOrigin as "camera_origin" {
        /// XMP: this camera was calibrated, with its distortion.
        XmpCalibration,
        /// XMP: this camera was calibrated, and the photo is free of its distortion.
        XmpDewarped,
        /// XMP: how the maker designed cameras of the kind.
        XmpDesign,
        /// EXIF: pixels a length of the focal plane.
        #[default]
        ExifFocalPlane,
        /// EXIF: the focal length of the same angle of view on 35 mm film.
        Exif35Mm,
        /// EXIF: the focal length alone; the sensor's size by maker and model.
        SensorTable,
        /// EXIF: the focal length alone, in mm.
        FocalLengthAlone,
        /// XMP: what a panorama shows at its middle.
        Panorama,
    }
}

messages! {
    /// What speaks against the camera that a file names.
    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
    pub enum CameraCaution as "camera_caution" {
        /// The photo was taken with more or fewer pixels, of the same format: its focal length in px is scaled.
        Resized { taken_width_px: u32, taken_height_px: u32, width_px: u32, height_px: u32 },
        /// The photo was taken in another format: how many px its focal length has is not known.
        Cropped { taken_width_px: u32, taken_height_px: u32, width_px: u32, height_px: u32 },
        /// The pixels of the focal plane are not those of a photo of this size, by its 35 mm equivalent or its sensor: how many px its focal length
        /// has is not known.
        FocalPlane { pixel_um: f64, expected_um: f64 },
        /// XMP and EXIF have focal lengths that cannot both be right: that of EXIF is taken.
        Contradiction { xmp_focal_px: f64, exif_focal_px: f64 },
        /// No photograph of a central perspective.
        Panorama { projection: String },
    }
}
