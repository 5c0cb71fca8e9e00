//! Photos on film as they were scanned: how a scan lies to the image of an ideal camera (`scan`), and that image for a block (`frame`).

mod frame;
mod scan;

pub use frame::{FilmFrame, film_frame, film_pixel_mm};
pub use scan::{FilmInput, FilmScan};
