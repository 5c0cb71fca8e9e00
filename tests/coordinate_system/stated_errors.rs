//! Standard errors of tables in another unit than m.

use super::flown::{GEOID_M, UTM, by_gnss, control, flown, in_utm, run_of};
use tiepoint::{BlockRun, BlockWarning, ControlTexts, LengthUnit, Observed, RunInput};

/// What is said of standard errors: of what, the median, and the unit in which they would fit.
fn told(run: &BlockRun) -> Option<(Observed, f64, LengthUnit)> {
    let of = |warning: &BlockWarning| match warning {
        BlockWarning::StatedErrors { observed, columns, stated, unit, .. } => {
            assert_eq!(columns, &["sigma_xy", "sigma_z"]);
            Some((*observed, *stated, *unit))
        }
        _ => None,
    };
    run.reconstruction.as_ref().unwrap().models[0].warnings.iter().find_map(of)
}

#[test]
fn control_points_in_millimetres_without_a_unit_are_told_and_with_one_are_right() {
    let with = |errors: &str, head: &str, use_gnss: bool| {
        let ControlTexts { points, marks } = control(|place| place);
        let points = points.replace(",0.02,0.03,", errors).replace("sigma_xy,sigma_z", head);
        run_of(UTM, None, RunInput { control: Some(ControlTexts { points, marks }), use_gnss, ..RunInput::default() }).unwrap()
    };
    // Some decimetres, which the block of these coarse photos determines.
    let wrong = with(",200,300,", "sigma_xy,sigma_z", false);
    assert_eq!(told(&wrong), Some((Observed::Points, 200.0, LengthUnit::Millimetres)));
    let text = wrong.reconstruction.as_ref().unwrap().models[0].warnings.iter().map(ToString::to_string).find(|text| text.contains("(mm)"));
    let begins = "The columns sigma_xy, sigma_z of the GCPs give standard errors of 200 in the median";
    assert!(text.as_ref().is_some_and(|text| text.starts_with(begins)), "{text:?}");
    // Beside positions that are as wrong as that.
    assert!(told(&with(",20,30,", "sigma_xy,sigma_z", true)).is_some());
    for (errors, head) in [
        (",200,300,", "sigma_xy (mm),sigma_z (mm)"),
        (",20,30,", "sigma_xy (cm),sigma_z (cm)"),
        (",0.02,0.03,", "sigma_xy,sigma_z"),
        (",0.2,0.3,", "sigma_xy,sigma_z"),
    ] {
        assert_eq!(told(&with(errors, head, false)), None, "{errors} {head}");
    }
}

#[test]
fn positions_of_receivers_without_corrections_are_right_however_large_their_standard_errors_are() {
    // Errors of some decimetres, or of some metres, of which most are those of the whole flight.
    let with = |size_m: f64, errors: &str| {
        let truth = flown().scene.truth();
        let rows = truth.images.iter().zip(&by_gnss().images).enumerate().map(|(k, (image, photo))| {
            let [x, y, z] = in_utm(image.pose.unwrap().position);
            let off = [0.7, -1.2, 0.4, 1.1, -0.6, -0.9, 1.3, -0.2];
            let [dx, dy, dz] = [0, 3, 5].map(|shift| size_m * off[(k + shift) % 8]);
            format!("{},{},{},{},{errors}\n", photo.name, x + dx, y + dy, z + dz)
        });
        let positions = Some(format!("image,easting,northing,height,sigma_xy,sigma_z\n{}", rows.collect::<String>()));
        run_of(UTM, Some(GEOID_M), RunInput { positions, ..RunInput::default() }).unwrap()
    };
    for (size_m, errors) in [(0.02, "0.02,0.04"), (0.4, "10,20"), (5.0, "20,30")] {
        assert_eq!(told(&with(size_m, errors)), None, "{size_m} {errors}");
    }
}
