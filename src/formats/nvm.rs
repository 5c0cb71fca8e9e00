//! VisualSFM's file of cameras and points, `NVM_V3`.

use super::quaternion::vision_pose;
use super::sight::Sights;
use super::text::{not_written, one_word};
use crate::{BlockModel, Error};
use std::fmt::Write;

/// The oriented images and the intersected points. Positions count from the principal point, y down, and are written as they would be
/// without distortion, since VisualSFM's single coefficient corrects in the other direction.
///
/// # Source
/// Wu 2011, VisualSFM: A visual structure from motion system, description of NVM_V3.
pub(super) fn write_nvm(model: &BlockModel, sights: &Sights) -> Result<String, Error> {
    let oriented: Vec<usize> = (0..model.images.len()).filter(|image| model.images[*image].pose.is_some()).collect();
    let mut number_of = vec![None; model.images.len()];
    oriented.iter().enumerate().for_each(|(number, image)| number_of[*image] = Some(number));
    let mut text = format!("NVM_V3\n\n{}\n", oriented.len());
    for image in &oriented {
        let image = &model.images[*image];
        let Some(pose) = &image.pose else { continue };
        let ([w, x, y, z], _) = vision_pose(pose);
        let [cx, cy, cz] = pose.position;
        let (name, focal) = (one_word("NVM", &image.name)?, model.cameras[image.camera].focal_px);
        writeln!(text, "{name} {focal} {w} {x} {y} {z} {cx} {cy} {cz} 0 0").map_err(not_written)?;
    }
    let intersected = model.points.iter().zip(&sights.numbers).filter_map(|(point, numbers)| Some((point.position?, point, numbers)));
    let intersected: Vec<_> = intersected.collect();
    writeln!(text, "\n{}", intersected.len()).map_err(not_written)?;
    for ([x, y, z], point, numbers) in intersected {
        let [r, g, b] = point.colour;
        let rays: Vec<_> = point.rays.iter().zip(numbers).filter_map(|(ray, number)| Some((number_of[ray.image]?, ray, number))).collect();
        write!(text, "{x} {y} {z} {r} {g} {b} {}", rays.len()).map_err(not_written)?;
        for (image, ray, number) in rays {
            let camera = &model.cameras[model.images[ray.image].camera];
            let [right, down] = camera.direction([ray.x_px, ray.y_px])?.map(|v| v * camera.focal_px);
            write!(text, " {image} {number} {right} {down}").map_err(not_written)?;
        }
        text.push('\n');
    }
    text.push_str("\n0\n");
    Ok(text)
}
