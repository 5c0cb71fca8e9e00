//! Rasters whose pixels have places: on a map (`georeference`, the tags of GeoTIFF, files beside them: `sidecars`), or at longitudes and latitudes, as the files of
//! geoids have them (`geoid_file`).

mod geoid_file;
mod georeference;
mod geotiff;
mod samples;
mod sidecars;

pub(crate) use geoid_file::{Area, part_of_geoid};
pub use georeference::Georeference;
pub(crate) use geotiff::{
    GeoTags, KEYS, LINEAR_UNIT, MODEL_TYPE, NO_DATA, PIXEL_SCALE, PROJECTED, PROJECTED_SYSTEM, RASTER_TYPE, SaidSystem, TIE_POINTS,
    TRANSFORMATION, name_of, refuse_degrees, unit_code,
};
pub(crate) use samples::{MOST_VALUES, Numbers, range_of, refuse_many};
pub use sidecars::Sidecars;
