//! Tables between commas for spreadsheets and scripts: images, points, rays.

use super::text::not_written;
use crate::{BlockModel, Error};
use std::borrow::Cow;
use std::fmt::{self, Write};

/// The files `images.csv`, `points.csv` and `rays.csv`. Images, points and cameras count from 0, as the lists of the project file do, whereas
/// texts that people read number cameras from 1 and name images; what is not known is empty; angles are those of
/// M = M3(κ)·M2(φ)·M1(ω) in degrees.
pub(super) fn write_tables(model: &BlockModel) -> Result<[String; 3], Error> {
    let [mut images, mut points, mut rays] = [const { String::new() }; 3];
    let done = write_images(model, &mut images).and_then(|()| write_points(model, &mut points)).and_then(|()| write_rays(model, &mut rays));
    done.map_err(not_written).map(|()| [images, points, rays])
}

fn write_images(model: &BlockModel, out: &mut String) -> fmt::Result {
    writeln!(out, "image,name,camera,width_px,height_px,focal_px,x,y,z,omega_deg,phi_deg,kappa_deg")?;
    for (index, image) in model.images.iter().enumerate() {
        let camera = &model.cameras[image.camera];
        write!(out, "{index},{},{},{},{},{}", csv_field(&image.name), image.camera, camera.width_px, camera.height_px, camera.focal_px)?;
        match &image.pose {
            Some(pose) => {
                let [x, y, z] = pose.position;
                // -0 is written as 0.
                let [omega, phi, kappa] = pose.angles().map(|angle| angle.to_degrees() + 0.0);
                writeln!(out, ",{x},{y},{z},{omega},{phi},{kappa}")?;
            }
            None => writeln!(out, ",,,,,,")?,
        }
    }
    Ok(())
}

fn write_points(model: &BlockModel, out: &mut String) -> fmt::Result {
    writeln!(out, "point,x,y,z,red,green,blue,rays,confidence,rmse_px")?;
    for (index, point) in model.points.iter().enumerate() {
        let [x, y, z] = point.position.map_or([const { String::new() }; 3], |position| position.map(|v| v.to_string()));
        let [r, g, b] = point.colour;
        let rmse = point.rmse_px.map_or(String::new(), |v| v.to_string());
        writeln!(out, "{index},{x},{y},{z},{r},{g},{b},{},{},{rmse}", point.rays.len(), point.confidence)?;
    }
    Ok(())
}

fn write_rays(model: &BlockModel, out: &mut String) -> fmt::Result {
    writeln!(out, "point,image,name,x_px,y_px,confidence")?;
    for (index, point) in model.points.iter().enumerate() {
        for ray in &point.rays {
            let name = csv_field(&model.images[ray.image].name);
            writeln!(out, "{index},{},{name},{},{},{}", ray.image, ray.x_px, ray.y_px, ray.confidence)?;
        }
    }
    Ok(())
}

/// A field of a table between commas: one with commas, quotation marks or line breaks stands between quotation marks, which are doubled within.
///
/// # Source
/// RFC 4180.
pub fn csv_field(text: &str) -> Cow<'_, str> {
    if text.contains([',', '"', '\r', '\n']) { format!("\"{}\"", text.replace('"', "\"\"")).into() } else { text.into() }
}

#[cfg(test)]
mod tests {
    use super::csv_field;

    #[test]
    fn only_fields_that_need_it_are_quoted() {
        for (text, field) in
            [("a b;c.jpg", "a b;c.jpg"), ("a,b", "\"a,b\""), ("the \"a\"", "\"the \"\"a\"\"\""), ("a\nb", "\"a\nb\""), ("", "")]
        {
            assert_eq!(csv_field(text), field);
        }
    }
}
