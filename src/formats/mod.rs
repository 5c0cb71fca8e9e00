//! Files by which blocks go to other programs and come from them: one format a file.
//!
//! Data flow: [`BlockModel`](crate::BlockModel) → [`check`](crate::BlockModel::check) → one writer a format → [`export_block`]; readers give a
//! [`BlockModel`](crate::BlockModel) or [`GroundControlRow`]s.

mod agisoft;
mod bingo;
mod bundler;
mod cameras;
mod colmap_features;
mod colmap_read;
mod colmap_write;
mod column_names;
mod column_units;
mod columns;
mod control;
mod control_columns;
#[cfg(test)]
mod control_forms;
mod control_order;
mod control_use;
mod csv_tables;
mod error_columns;
mod export;
mod geojson;
mod hemispheres;
mod isat;
mod marks;
mod micmac;
mod nvm;
mod opensfm;
mod patb;
mod position_columns;
#[cfg(test)]
mod position_forms;
mod positions;
mod quaternion;
mod side_columns;
mod sight;
mod system_line;
#[cfg(test)]
mod table_forms;
#[cfg(test)]
mod tests;
mod text;
mod whole_numbers;

pub use cameras::{CameraRule, parse_camera_rules};
pub use colmap_features::{ColmapFeature, colmap_features, colmap_matches};
pub use colmap_read::read_colmap_model;
pub(crate) use columns::{LENGTHS, UnreadColumns};
pub use control::{GroundControlRow, parse_ground_control_points};
pub(crate) use control::{
    StatedUnit, control_system, error_columns, ground_control_table, points_without_coordinates, stated_units, unnamed_errors,
    unread_columns,
};
pub(crate) use csv_tables::{images_table, points_table, rays_table};
pub(crate) use error_columns::ErrorColumns;
pub use export::{ExportFormat, export_block};
pub(crate) use marks::image_measurement_table;
pub(crate) use marks::unread_mark_columns;
pub use marks::{ImageMeasurementRow, parse_image_measurements};
pub use positions::{ImagePositionRow, ImagePositions, parse_image_positions};
pub(crate) use positions::{PositionHead, position_head};
pub(crate) use system_line::SystemLine;
