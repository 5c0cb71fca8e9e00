//! Photos on film as they were scanned: what is given of a scan (`input`), how it lies to the image of an ideal camera (`scan`), what that shows of it
//! (`shown`), what its file may ask for (`scan_file`), that image for a block (`frame`), and what else belongs to a block of them: their camera
//! (`cameras`), and image measurements that were made in the scans (`measurements`).

mod cameras;
mod frame;
mod input;
#[cfg(test)]
mod known_scan;
mod measurements;
mod scan;
mod scan_file;
mod shown;

pub use cameras::{film_cameras, film_pattern};
pub use frame::{FilmFrame, film_frame, film_pixel_mm, film_warning};
pub use input::FilmInput;
pub use measurements::{FrameOfScan, FramedMeasurements, measurements_in_frames};
pub use scan::FilmScan;
pub use scan_file::{SCAN_LIMITS, decode_scan};
