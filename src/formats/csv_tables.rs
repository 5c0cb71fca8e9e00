//! Tables between commas for spreadsheets and scripts: images, points, observations.
//!
//! Images and cameras count from 0, as the lists of the project file do, whereas texts that people read number cameras from 1 and name images. Points
//! have their numbers. What is not known is empty; angles are those of M = M3(κ)·M2(φ)·M1(ω) in degrees.

use crate::BlockModel;
use crate::text::{Row, table};

const IMAGES: [&str; 12] =
    ["image", "name", "camera", "width_px", "height_px", "focal_px", "x", "y", "z", "omega_deg", "phi_deg", "kappa_deg"];
const POINTS: [&str; 10] = ["point", "x", "y", "z", "red", "green", "blue", "rays", "confidence", "rmse_px"];
const RAYS: [&str; 6] = ["point", "image", "name", "x_px", "y_px", "confidence"];

/// `images.csv`, with further columns that `more` fills for each image.
pub(crate) fn images_table(model: &BlockModel, columns: &[&str], more: impl Fn(usize, Row) -> Row) -> String {
    let rows = model.images.iter().enumerate().map(|(index, image)| {
        let camera = &model.cameras[image.camera];
        let row = Row::default().number(index).text(&image.name).number(image.camera).number(camera.width_px).number(camera.height_px);
        let pose = image.pose.map(|pose| {
            let [x, y, z] = pose.position;
            // -0 is written as 0.
            let [omega, phi, kappa] = pose.angles().map(|angle| angle.to_degrees() + 0.0);
            [x, y, z, omega, phi, kappa]
        });
        more(index, row.number(camera.focal_px).numbers(pose))
    });
    table(&[&IMAGES, columns].concat(), rows)
}

/// `points.csv`, with further columns that `more` fills for each point.
pub(crate) fn points_table(model: &BlockModel, columns: &[&str], more: impl Fn(usize, Row) -> Row) -> String {
    let rows = model.points.iter().zip(model.point_numbers()).enumerate().map(|(index, (point, number))| {
        let coloured = point.colour.iter().fold(Row::default().number(number).numbers(point.position), Row::number);
        more(index, coloured.number(point.rays.len()).number(point.confidence).known(point.rmse_px))
    });
    table(&[&POINTS, columns].concat(), rows)
}

/// `rays.csv`, with further columns that `more` fills for each point and its observations.
pub(crate) fn rays_table(model: &BlockModel, columns: &[&str], more: impl Fn(usize, usize, Row) -> Row) -> String {
    let numbers = model.point_numbers();
    let all = model.points.iter().enumerate().flat_map(|(point, known)| known.rays.iter().enumerate().map(move |(i, ray)| (point, i, ray)));
    let rows = all.map(|(point, index, ray)| {
        let row = Row::default().number(numbers[point]).number(ray.image).text(&model.images[ray.image].name);
        more(point, index, row.number(ray.x_px).number(ray.y_px).number(ray.confidence))
    });
    table(&[&RAYS, columns].concat(), rows)
}
