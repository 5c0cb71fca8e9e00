//! Placed images and their links as tables.

use super::outcome::{LinkUse, PlacedImage, PlacingVerdict};
use crate::FiducialOrientation;
use crate::text::{Row, table};

const IMAGES: [&str; 21] = [
    "name",
    "verdict",
    "x",
    "y",
    "z",
    "omega_deg",
    "phi_deg",
    "kappa_deg",
    "sigma_x",
    "sigma_y",
    "sigma_z",
    "sigma_omega_deg",
    "sigma_phi_deg",
    "sigma_kappa_deg",
    "focal_px",
    "sigma_focal_px",
    "links",
    "sigma0_px",
    "gsd",
    "marks_sigma0_mm",
    "marks_rmse_mm",
];
const LINKS: [&str; 8] = ["name", "x_px", "y_px", "x", "y", "z", "residual_px", "use"];

/// `placed.csv`: names with what came of them; angles as `images.csv` of a block has them. Of scans of film the interior orientation: σ₀ and the root
/// mean square length of the residuals of the fiducial marks.
pub fn placed_table(placed: &[(String, PlacedImage)]) -> String {
    let rows = placed.iter().map(|(name, image)| {
        let (word, placement) = (verdict(&image.verdict), image.placement.as_ref());
        let row = Row::default().text(name).number(word);
        let three = |row: Row, values: Option<[f64; 3]>| (0..3).fold(row, |row, k| row.known(values.map(|v| v[k])));
        let row = three(row, placement.map(|p| p.pose.position));
        let row = three(row, placement.map(|p| p.angles_deg));
        let row = three(row, placement.and_then(|p| p.position_errors_m));
        let row = three(row, placement.and_then(|p| p.angle_errors_deg));
        let row = row.known(placement.map(|p| p.camera.focal_px)).known(placement.and_then(|p| p.camera_errors[0]));
        let used = placement.map(|p| p.links.iter().filter(|link| link.role == LinkUse::Used).count());
        let row = row.known(used).known(placement.and_then(|p| p.sigma0_px)).known(placement.map(|p| p.gsd_m));
        let marks = placement.and_then(|p| p.film.as_ref()).map(|film| &film.marks);
        row.known(marks.and_then(|marks| marks.sigma0_mm)).known(marks.map(FiducialOrientation::rmse_mm))
    });
    table(&IMAGES, rows)
}

/// `links.csv`: every link of every placed image, with the length of its residual.
pub fn links_table(placed: &[(String, PlacedImage)]) -> String {
    let of_image = |(name, image): &(String, PlacedImage)| {
        let links = image.placement.iter().flat_map(|placement| placement.links.clone());
        links.map(|link| (name.clone(), link)).collect::<Vec<_>>()
    };
    let rows = placed.iter().flat_map(of_image).map(|(name, link)| {
        let row = link.at.into_iter().chain(link.place).fold(Row::default().text(&name), Row::number);
        row.known(link.residual_px.map(|[x, y]| libm::hypot(x, y))).number(match link.role {
            LinkUse::Used => "used",
            LinkUse::Rejected => "rejected",
            LinkUse::Check => "check",
        })
    });
    table(&LINKS, rows)
}

fn verdict(verdict: &PlacingVerdict) -> &'static str {
    match verdict {
        PlacingVerdict::Placed { .. } => "placed",
        PlacingVerdict::Weak { .. } => "weak",
        PlacingVerdict::NotPlaced { .. } => "not_placed",
    }
}
