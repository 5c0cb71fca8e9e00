//! Rasters whose pixels have places: on a map (`georeference`, world files, the tags of GeoTIFF), or at longitudes and latitudes, as the files of
//! geoids have them (`geoid_file`).

mod geoid_file;
mod georeference;
mod geotiff;
mod samples;

pub(crate) use geoid_file::{Area, part_of_geoid};
pub use georeference::Georeference;
pub(crate) use geotiff::{
    GeoTags, KEYS, MODEL_TYPE, NO_DATA, PIXEL_SCALE, PROJECTED, PROJECTED_SYSTEM, RASTER_TYPE, SaidSystem, TIE_POINTS, TRANSFORMATION,
    name_of, refuse_degrees,
};
pub(crate) use samples::{MOST_VALUES, numbers_of_tiff};
