//! From pixels to photo coordinates: interior orientation, camera data, EXIF.

mod distortion;
mod exif;
mod fiducials;
mod interior;
mod rotation;

pub(crate) use distortion::{MOST_STEPS, undistorted};
pub use exif::{ExifCamera, ExifImage, ExifPosition};
pub use fiducials::{Fiducial, FiducialModel, FiducialOrientation, orient_fiducials};
pub use interior::{Camera, Interior};
pub use rotation::{angles_from_rotation, rotation_from_angles};
