//! Agisoft Metashape's XML of markers: each point is a marker with its projections.

use super::text::not_written;
use crate::{BlockModel, Error};
use std::fmt::{self, Write};

/// Sensors, cameras, markers with their positions where these are known, and the projections; pixel positions as here. Ground control and check points
/// have their names.
///
/// # Source
/// Metashape's own export of markers (document version 1.2.0).
pub(super) fn write_markers(model: &BlockModel) -> Result<String, Error> {
    let mut text = String::new();
    write(model, &mut text).map_err(not_written)?;
    Ok(text)
}

fn write(model: &BlockModel, out: &mut String) -> fmt::Result {
    let escaped: Vec<String> = model.images.iter().map(|image| escape(&image.name)).collect();
    writeln!(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<document version=\"1.2.0\">\n  <chunk>\n    <sensors>")?;
    for (index, camera) in model.cameras.iter().enumerate() {
        writeln!(out, "      <sensor id=\"{index}\" label=\"camera {index}\" type=\"frame\">")?;
        writeln!(out, "        <resolution width=\"{}\" height=\"{}\"/>\n      </sensor>", camera.width_px, camera.height_px)?;
    }
    writeln!(out, "    </sensors>\n    <cameras>")?;
    for (index, (image, label)) in model.images.iter().zip(&escaped).enumerate() {
        writeln!(out, "      <camera id=\"{index}\" label=\"{label}\" sensor_id=\"{}\" enabled=\"1\"/>", image.camera)?;
    }
    writeln!(out, "    </cameras>\n    <markers>")?;
    for (index, (point, number)) in model.points.iter().zip(model.point_numbers()).enumerate() {
        let label = point.name.as_ref().map_or_else(|| format!("point {number}"), |name| escape(name));
        match point.position {
            Some([x, y, z]) => {
                writeln!(out, "      <marker id=\"{index}\" label=\"{label}\">")?;
                writeln!(out, "        <reference x=\"{x}\" y=\"{y}\" z=\"{z}\" enabled=\"0\"/>\n      </marker>")?;
            }
            None => writeln!(out, "      <marker id=\"{index}\" label=\"{label}\"/>")?,
        }
    }
    writeln!(out, "    </markers>\n    <frames next_id=\"1\">\n      <frame id=\"0\">\n        <markers>")?;
    for (index, point) in model.points.iter().enumerate() {
        writeln!(out, "          <marker marker_id=\"{index}\">")?;
        for ray in &point.rays {
            writeln!(out, "            <location camera_id=\"{}\" pinned=\"1\" x=\"{}\" y=\"{}\"/>", ray.image, ray.x_px, ray.y_px)?;
        }
        writeln!(out, "          </marker>")?;
    }
    writeln!(out, "        </markers>\n      </frame>\n    </frames>\n  </chunk>\n</document>")
}

fn escape(name: &str) -> String {
    name.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
