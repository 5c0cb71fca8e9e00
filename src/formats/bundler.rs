//! Bundler's file of cameras and points, version 0.3, with its list of images.

use super::sight::Sights;
use super::text::one_word;
use crate::{BlockModel, Camera, Error, ImageObservation};
use std::fmt::{self, Write};

/// The files `bundle.out` and `list.txt`.
///
/// Bundler's cameras look along -z, as photos do here: its R is M. Positions count from the principal point, y up. It has k₁ and k₂; of
/// cameras with more, the positions are written as they would be without distortion. Images that are not oriented have a focal length of 0.
///
/// # Source
/// Bundler v0.4 User's Manual, output format.
pub(super) fn write_bundle(model: &BlockModel, sights: &Sights) -> Result<[String; 2], Error> {
    model.images.iter().try_for_each(|image| one_word("Bundler", &image.name).map(drop))?;
    let mut text = String::from("# Bundle file v0.3\n");
    let points: Vec<usize> = (0..model.points.len()).filter(|point| model.points[*point].position.is_some()).collect();
    write_cameras(model, points.len(), &mut text).map_err(super::text::not_written)?;
    for point in points {
        write_point(model, sights, point, &mut text)?;
    }
    let mut list = String::new();
    for image in &model.images {
        list.push_str(&image.name);
        if image.pose.is_some() {
            list.push_str(&format!(" 0 {}", model.cameras[image.camera].focal_px));
        }
        list.push('\n');
    }
    Ok([text, list])
}

fn write_cameras(model: &BlockModel, points: usize, out: &mut String) -> fmt::Result {
    writeln!(out, "{} {points}", model.images.len())?;
    for image in &model.images {
        let Some(pose) = &image.pose else {
            out.push_str(&"0 0 0\n".repeat(5));
            continue;
        };
        let camera = &model.cameras[image.camera];
        let [k1, k2, _] = if has_room(camera) { camera.radial } else { [0.0; 3] };
        writeln!(out, "{} {k1} {k2}", camera.focal_px)?;
        pose.rotation.iter().try_for_each(|[a, b, c]| writeln!(out, "{a} {b} {c}"))?;
        let x = pose.position;
        let [t1, t2, t3] = pose.rotation.map(|row| 0.0 - (row[0] * x[0] + row[1] * x[1] + row[2] * x[2]));
        writeln!(out, "{t1} {t2} {t3}")?;
    }
    Ok(())
}

fn has_room(camera: &Camera) -> bool {
    camera.radial[2] == 0.0 && camera.tangential == [0.0; 2]
}

fn write_point(model: &BlockModel, sights: &Sights, index: usize, out: &mut String) -> Result<(), Error> {
    let point = &model.points[index];
    let [x, y, z] = point.position.unwrap_or_default();
    let [r, g, b] = point.colour;
    let rays: Vec<(&ImageObservation, &usize)> =
        point.rays.iter().zip(&sights.numbers[index]).filter(|(ray, _)| model.images[ray.image].pose.is_some()).collect();
    let mut line = format!("{x} {y} {z}\n{r} {g} {b}\n{}", rays.len());
    for (ray, number) in rays {
        let camera = &model.cameras[model.images[ray.image].camera];
        let [cx, cy] = camera.principal_point_px;
        let [right, down] = if has_room(camera) {
            [ray.x_px - cx, ray.y_px - cy]
        } else {
            camera.direction([ray.x_px, ray.y_px])?.map(|v| v * camera.focal_px)
        };
        line.push_str(&format!(" {} {number} {right} {}", ray.image, 0.0 - down));
    }
    line.push('\n');
    out.push_str(&line);
    Ok(())
}
