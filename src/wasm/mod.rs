//! The only folder that names JavaScript: unpack, call the core, pack.
//!
//! Bulk data crosses as flat typed arrays of a stated stride, options and small results as plain objects. Every result is a copy.

mod about;
mod block;
mod block_files;
mod block_on_orthophoto;
mod block_scene;
mod camera;
mod convert;
mod crs;
mod descriptors;
mod digest;
mod draw;
mod epipolar_images;
mod features;
mod file_in_parts;
mod film;
mod finished;
mod geometry;
mod heights;
mod matching;
mod message;
mod orientation;
mod ortho_mosaic;
mod orthophoto;
mod panics;
mod photo;
mod pipeline;
mod project;
mod report;
mod simulate;
mod tables;
mod verification;
