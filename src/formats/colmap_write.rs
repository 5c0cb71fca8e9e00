//! COLMAP's text model: cameras, images with their rays, points. Numbers of images, cameras and points count from 1.

use super::quaternion::vision_pose;
use super::sight::Sights;
use super::text::one_word;
use crate::{BlockModel, Camera, Error};
use std::fmt::{self, Write};

/// The three files of an oriented block: `cameras.txt`, `images.txt`, `points3D.txt`. Images without a pose are left out, and points
/// without a position.
///
/// # Source
/// COLMAP, `doc/format.rst`: poses are from object to camera, x right, y down, z forward; pixel positions as here.
pub(super) fn write_model(model: &BlockModel, sights: &Sights) -> Result<[String; 3], Error> {
    model.images.iter().try_for_each(|image| one_word("COLMAP model", &image.name).map(drop))?;
    let [mut cameras, mut images, mut points] = [const { String::new() }; 3];
    let done = write_cameras(model, &mut cameras)
        .and_then(|()| write_images(model, sights, &mut images))
        .and_then(|()| write_points(model, sights, &mut points));
    done.map_err(super::text::not_written).map(|()| [cameras, images, points])
}

fn write_cameras(model: &BlockModel, out: &mut String) -> fmt::Result {
    writeln!(out, "# CAMERA_ID MODEL WIDTH HEIGHT PARAMS[]")?;
    for (index, camera) in model.cameras.iter().enumerate() {
        let Camera { width_px, height_px, focal_px: f, principal_point_px: [cx, cy], .. } = camera;
        let ([k1, k2, k3], [p1, p2]) = (camera.radial, camera.tangential);
        write!(out, "{} ", index + 1)?;
        // The smallest of COLMAP's models that holds all parameters.
        if k3 != 0.0 {
            writeln!(out, "FULL_OPENCV {width_px} {height_px} {f} {f} {cx} {cy} {k1} {k2} {p1} {p2} {k3} 0 0 0")?;
        } else if camera.tangential != [0.0; 2] {
            writeln!(out, "OPENCV {width_px} {height_px} {f} {f} {cx} {cy} {k1} {k2} {p1} {p2}")?;
        } else if k2 != 0.0 {
            writeln!(out, "RADIAL {width_px} {height_px} {f} {cx} {cy} {k1} {k2}")?;
        } else if k1 != 0.0 {
            writeln!(out, "SIMPLE_RADIAL {width_px} {height_px} {f} {cx} {cy} {k1}")?;
        } else {
            writeln!(out, "SIMPLE_PINHOLE {width_px} {height_px} {f} {cx} {cy}")?;
        }
    }
    Ok(())
}

fn write_images(model: &BlockModel, sights: &Sights, out: &mut String) -> fmt::Result {
    writeln!(out, "# IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME")?;
    writeln!(out, "# POINTS2D[] as (X Y POINT3D_ID)")?;
    let numbers = model.point_numbers();
    for (index, image) in model.images.iter().enumerate() {
        let Some(pose) = &image.pose else { continue };
        let ([qw, qx, qy, qz], [tx, ty, tz]) = vision_pose(pose);
        writeln!(out, "{} {qw} {qx} {qy} {qz} {tx} {ty} {tz} {} {}", index + 1, image.camera + 1, image.name)?;
        for (place, sighting) in sights.of_images[index].iter().enumerate() {
            let point = if model.points[sighting.point].position.is_some() { i64::from(numbers[sighting.point]) } else { -1 };
            let blank = if place > 0 { " " } else { "" };
            write!(out, "{blank}{} {} {point}", sighting.ray.x_px, sighting.ray.y_px)?;
        }
        writeln!(out)?;
    }
    Ok(())
}

fn write_points(model: &BlockModel, sights: &Sights, out: &mut String) -> fmt::Result {
    writeln!(out, "# POINT3D_ID X Y Z R G B ERROR TRACK[] as (IMAGE_ID POINT2D_IDX)")?;
    for ((point, own), numbers) in model.points.iter().zip(model.point_numbers()).zip(&sights.numbers) {
        let Some([x, y, z]) = point.position else { continue };
        let [r, g, b] = point.colour;
        write!(out, "{} {x} {y} {z} {r} {g} {b} {}", own, point.rmse_px.unwrap_or(-1.0))?;
        for (ray, number) in point.rays.iter().zip(numbers).filter(|(ray, _)| model.images[ray.image].pose.is_some()) {
            write!(out, " {} {number}", ray.image + 1)?;
        }
        writeln!(out)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::tiny_block;

    #[test]
    fn the_tiny_block_has_its_golden_text() {
        let mut model = tiny_block();
        model.cameras[0].radial[0] = -0.125;
        let [cameras, images, points] = write_model(&model, &Sights::new(&model)).unwrap();
        assert_eq!(cameras, "# CAMERA_ID MODEL WIDTH HEIGHT PARAMS[]\n1 SIMPLE_RADIAL 400 300 500 200 150 -0.125\n");
        assert_eq!(
            images,
            "# IMAGE_ID QW QX QY QZ TX TY TZ CAMERA_ID NAME\n# POINTS2D[] as (X Y POINT3D_ID)\n\
             1 0 1 0 0 0 0 100 1 a.jpg\n225 150 1 225 100 2\n\
             2 0 1 0 0 -10 0 100 1 b.jpg\n175 150 1 175 100 2 10 20 -1\n"
        );
        assert_eq!(
            points,
            "# POINT3D_ID X Y Z R G B ERROR TRACK[] as (IMAGE_ID POINT2D_IDX)\n\
             1 5 0 0 10 20 30 0.25 1 0 2 0\n2 5 10 0 10 20 30 0.25 1 1 2 1\n"
        );
    }
}
