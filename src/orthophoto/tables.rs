//! Placed images and their links as tables.

use super::outcome::{LinkUse, PlacedImage, PlacingVerdict};
use crate::FiducialOrientation;
use crate::text::{Row, table};

const IMAGES: [&str; 24] = [
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
    "checks",
    "checks_beyond",
    "checks_rmse_px",
];
const LINKS: [&str; 10] = ["name", "x_px", "y_px", "x", "y", "z", "residual_px", "use", "sigma_px", "by_hand"];

/// `placed.csv`: names with what came of them; angles as `images.csv` of a block has them. Of scans of film the interior orientation: σ₀ and the root
/// mean square length of the residuals of the fiducial marks. Of the links that took no part their number, how many of them are gross errors, and the root
/// mean square length of the residuals of the others.
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
        let row = row.known(marks.and_then(|marks| marks.sigma0_mm)).known(marks.map(FiducialOrientation::rmse_mm));
        // Without any that is no gross error there is none.
        let checks = placement.and_then(|p| p.checks);
        let rmse_px = checks.filter(|checks| checks.beyond < checks.number).map(|checks| checks.rmse_px);
        row.known(checks.map(|checks| checks.number)).known(checks.map(|checks| checks.beyond)).known(rmse_px)
    });
    table(&IMAGES, rows)
}

/// `links.csv`: every link of every placed image, with the length of its residual, and the standard error of each of its coordinates in the image.
pub fn links_table(placed: &[(String, PlacedImage)]) -> String {
    let of_image = |(name, image): &(String, PlacedImage)| {
        let links = image.placement.iter().flat_map(|placement| placement.links.clone());
        links.map(|link| (name.clone(), link)).collect::<Vec<_>>()
    };
    let rows = placed.iter().flat_map(of_image).map(|(name, link)| {
        let row = link.at.into_iter().chain(link.place).fold(Row::default().text(&name), Row::number);
        let row = row.known(link.residual_px.map(|[x, y]| libm::hypot(x, y))).number(match link.role {
            LinkUse::Used => "used",
            LinkUse::Rejected => "rejected",
            LinkUse::Check => "check",
        });
        row.known(link.sigma_px).number(u8::from(link.by_hand))
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::orthophoto::{Link, LinkChecks, Placement, Relief};
    use crate::{Camera, Pose};

    fn placed(links: Vec<Link>, checks: Option<LinkChecks>) -> PlacedImage {
        let placement = Placement {
            camera: Camera::without_distortion(800, 600, 1000.0),
            camera_errors: [None; 8],
            pose: Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], position: [1.0, 2.0, 503.0] },
            angles_deg: [0.0; 3],
            angle_errors_deg: None,
            position_errors_m: None,
            above_ground_m: 500.0,
            gsd_m: 0.5,
            footprint: Vec::new(),
            sigma0_px: Some(0.5),
            rmse_px: 0.5,
            degrees_of_freedom: 20,
            coverage: 1.0,
            links,
            checks,
            relief: Relief::default(),
            film: None,
        };
        let verdict = PlacingVerdict::Placed { links: 1, sigma0_px: 0.5, half_width_m: 0.1 };
        PlacedImage { verdict, placement: Some(placement), search: None }
    }

    #[test]
    fn a_link_has_its_standard_error_and_says_whether_it_was_measured_by_hand() {
        let link = Link {
            at: [10.5, 20.5],
            place: [5.0, 6.0, 7.0],
            residual_px: Some([0.3, -0.4]),
            sigma_px: Some(0.25),
            role: LinkUse::Used,
            by_hand: false,
        };
        let unknown = Link { residual_px: None, sigma_px: None, role: LinkUse::Rejected, by_hand: true, ..link };
        let table = links_table(&[("a.png".into(), placed(vec![link, unknown], None))]);
        let expected = "name,x_px,y_px,x,y,z,residual_px,use,sigma_px,by_hand\n\
            a.png,10.5,20.5,5,6,7,0.5,used,0.25,0\na.png,10.5,20.5,5,6,7,,rejected,,1\n";
        assert_eq!(table, expected);
    }

    #[test]
    fn an_image_has_what_its_check_links_say() {
        let of = |checks: Option<LinkChecks>| {
            let table = placed_table(&[("a.png".into(), placed(Vec::new(), checks))]);
            let (head, row) = table.trim().split_once('\n').unwrap();
            assert!(head.ends_with(",checks,checks_beyond,checks_rmse_px") && head.split(',').count() == row.split(',').count(), "{table}");
            row.rsplitn(4, ',').take(3).map(String::from).collect::<Vec<_>>()
        };
        let checks = |number: usize, beyond: usize| LinkChecks { number, beyond, rmse_px: 0.75, rmse_m: 0.3 };
        assert_eq!(of(Some(checks(12, 2))), ["0.75", "2", "12"]);
        // Of gross errors alone there is no root mean square.
        assert_eq!(of(Some(checks(2, 2))), ["", "2", "2"]);
        assert_eq!(of(None), [""; 3]);
    }
}
