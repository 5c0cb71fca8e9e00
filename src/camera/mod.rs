//! Cameras, exterior orientation, and the way from pixels to photo coordinates: interior orientation, EXIF and XMP.

mod distortion;
mod exif;
mod exif_block;
mod fiducials;
mod interior;
mod mm;
mod origin;
mod pose;
mod px;
mod rotation;
mod same;
mod sensors;
mod uncertainty;
mod xmp;

pub(crate) use distortion::{CAMERA_PARAMETERS, CameraValues, distorted, linearised_lens, radial_factor, undistorted};
pub use exif::{ExifCamera, ExifImage, ExifPosition};
pub(crate) use exif::{NOWHERE, camera_label};
pub use fiducials::{Fiducial, FiducialModel, FiducialOrientation, orient_fiducials};
pub use interior::Interior;
pub use mm::CameraMm;
pub use origin::{CameraCaution, CameraOrigin};
pub use pose::Pose;
pub(crate) use pose::{is_rotation, matrix, orthonormal, product, turn_of};
pub use px::{Camera, FreeParameters};
pub(crate) use rotation::nearest_rotation;
pub use rotation::{angles_from_rotation, rotation_from_angles};
pub(crate) use same::{FARTHEST_PRINCIPAL, USUAL_FOCAL, contradict, far_principal, is_near};
pub use uncertainty::CameraUncertainty;
pub(crate) use uncertainty::apart_from_known;
pub use xmp::{Attitude, DroneRecord, RtkSolution};
