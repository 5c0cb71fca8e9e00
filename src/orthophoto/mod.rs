//! Orthophotos as the reference of images.
//!
//! Data flow: an [`Orthophoto`] (`reference`) with its `heights` → its `search_area` → `first_place` (features that agree on a
//! similarity) → an orientation by resection → `confirming` by `links` (the image resampled to the ground by `rectify`, matched to the orthophoto: coarse,
//! then fine) and `adjusting` (the bundle adjustment of one image, its `precision`) → its `placement` → `verdict` → [`PlacedImage`].
//!
//! A photo on film: its scan and fiducial marks → the frame of an ideal camera (`film`) → as any image → back to the scan (`place_film`).
//!
//! A block: `block_links` (images placed by themselves or near where the others of the block have them) → places of the ground that several images
//! show → in the coordinate reference system of the block, where it has one (`into_system`) → [`BlockRun`](crate::BlockRun) adjusted by them → what its positions
//! (`beside_positions`) and the places that check it (`heights_by_checks`) say against the orthophoto.
//!
//! The other way round: an oriented block → its map (`block_map`, `map_nodes`) → `mosaic` → a picture of the ground, which `write` makes a GeoTIFF.

mod adjusting;
mod beside_positions;
mod block_links;
mod block_map;
mod by_hand;
mod camera;
mod chosen;
mod confirming;
mod control_by_hand;
mod elsewhere;
mod emptiness;
mod first_place;
mod footprint;
mod ground;
mod height_values;
mod heights;
mod heights_by_checks;
mod hidden;
mod into_system;
mod links;
mod map_nodes;
mod mosaic;
mod mosaic_tiles;
mod options;
mod other_zero;
mod outcome;
mod own;
mod parts;
mod patch;
mod photograph;
mod picture;
mod place;
mod place_film;
mod placement;
mod point_heights;
mod precision;
mod recorded_height;
mod recorded_place;
mod recorded_position;
mod rectify;
mod reference;
mod relief;
mod samples;
mod search_area;
mod tables;
mod tiff_field;
mod tiled_file;
mod verdict;
mod write;

pub use adjusting::PlacingCamera;
pub use block_links::BlockLinks;
pub(crate) use block_map::{BlockMap, epsg_of};
pub use by_hand::{GivenLink, GivenUse, ground_positions, image_positions, place_by_links};
pub use control_by_hand::control_by_hand;
pub use heights::{HeightModel, Heights};
pub use mosaic::Mosaic;
pub use options::PlacingOptions;
pub use outcome::{Link, LinkChecks, LinkUse, NotPlaced, PlaceSearch, PlacedImage, Placement, PlacingVerdict, PlacingWeakness};
pub use own::rectify_placed;
pub use place::place_image;
pub use place_film::{place_film, place_film_by_links};
pub(crate) use point_heights::heights_on_map;
pub use point_heights::{heights_of_block, heights_of_points};
pub use recorded_place::place_recorded;
pub use recorded_position::RecordedPosition;
pub(crate) use rectify::Seen;
pub use rectify::{Rectified, rectify};
pub use reference::Orthophoto;
pub use relief::{HeightFactor, Relief};
pub use search_area::SearchArea;
pub use tables::{links_table, placed_table};
pub(crate) use write::write_floats;
pub use write::{write_geotiff, write_heights};
