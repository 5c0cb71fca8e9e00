//! Photos on film as they were scanned: how a scan lies to the image of an ideal camera (`scan`), what its file may ask for (`scan_file`), that image for a block (`frame`), and what else belongs to
//! a block of them: their camera (`cameras`), and image measurements that were made in the scans (`measurements`).

mod cameras;
mod frame;
mod measurements;
mod scan;
mod scan_file;

pub use cameras::{film_cameras, film_pattern};
pub use frame::{FilmFrame, film_frame, film_pixel_mm};
pub use measurements::{FrameOfScan, FramedMeasurements, measurements_in_frames};
pub use scan::{FilmInput, FilmScan};
pub use scan_file::{SCAN_LIMITS, decode_scan};
