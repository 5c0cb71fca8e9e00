//! The place of a photo on film: its scan is resampled to the frame of an ideal camera, and what is found there is given in px of the scan.
//!
//! The scan is resampled once, before anything is matched: then features, resection, adjustment and the rectified picture know one camera, along whose
//! axes the border of the film is cut off. Led along with each position instead, the way from the scan would stand in the equations of all of them. The
//! price is one more convolution, and memory for the frame beside the scan.

use super::by_hand::{GivenLink, GivenUse, place_by_links};
use super::options::PlacingOptions;
use super::outcome::{Link, PlacedImage, Placement};
use super::photograph::Photograph;
use super::place::place_photograph;
use super::recorded_place::sought;
use super::recorded_position::RecordedPosition;
use super::reference::Orthophoto;
use super::search_area::SearchArea;
use crate::error::refuse;
use crate::{Error, FilmInput, FilmScan, GreyView, PlacingCamera, Refusal};

/// Places a scanned photo on film by its interior orientation: as [`place_recorded`](crate::place_recorded), with the calibrated camera and the fiducial marks
/// that were measured in the scan. What the scan shows beside the photograph, as the border of the film and its marks, is not matched. Positions of the
/// result are those of the scan; its camera is that of the frame.
///
/// # Errors
/// As [`FilmScan::new`] and [`place_image`](crate::place_image).
pub fn place_film(
    scan: GreyView<'_>,
    film: &FilmInput,
    position: Option<&RecordedPosition>,
    reference: &Orthophoto,
    area: &SearchArea,
    options: &PlacingOptions,
) -> Result<PlacedImage, Error> {
    options.check_ranges()?;
    let own = FilmScan::new(film, [scan.width(), scan.height()])?;
    let frame = own.frame(&[scan])?.into_first();
    let shows = own.shows(&film.film_marks());
    let photograph = Photograph { grey: frame.view(), shows: &shows };
    let known = camera_of(&own);
    let placed = sought(position, reference, area, options, |area| place_photograph(photograph, &known, reference, area, options))?;
    Ok(in_scan(&own, placed, None))
}

/// Orients a scanned photo on film by links that are given, in px of the scan: as [`place_by_links`].
///
/// # Errors
/// As [`place_by_links`]; [`Error::InvalidInput`] for a link that takes part beside the frame.
pub fn place_film_by_links(
    scan: &FilmScan,
    position: Option<&RecordedPosition>,
    reference: &Orthophoto,
    start: Option<&Placement>,
    links: &[GivenLink],
    options: &PlacingOptions,
) -> Result<PlacedImage, Error> {
    let known = camera_of(scan);
    let in_frame = links.iter().enumerate().map(|(number, link)| {
        let at = scan.in_frame(link.at);
        if link.part == GivenUse::Used && !known.camera.sees(at[0], at[1]) {
            return refuse(Refusal::LinkBesideFrame { position: format!("{:?}", link.at), link: number + 1 });
        }
        Ok(GivenLink { at, ..*link })
    });
    let in_frame = in_frame.collect::<Result<Vec<GivenLink>, Error>>()?;
    place_by_links(&known, position, reference, start, &in_frame, options).map(|placed| in_scan(scan, placed, Some(links)))
}

fn camera_of(scan: &FilmScan) -> PlacingCamera {
    PlacingCamera { camera: scan.camera(), uncertainty: scan.uncertainty(), decentring: scan.decentring() }
}

/// With positions and residuals in px of the scan. `given`: the links that the placement has, in their order, where they were given.
fn in_scan(scan: &FilmScan, placed: PlacedImage, given: Option<&[GivenLink]>) -> PlacedImage {
    let link = |(number, link): (usize, Link)| {
        let at = match given.and_then(|given| given.get(number)) {
            Some(given) => given.at,
            None => scan.in_scan(link.at)?,
        };
        let residual_px = link.residual_px.and_then(|[x, y]| {
            let computed = scan.in_scan([link.at[0] - x, link.at[1] - y])?;
            Some([at[0] - computed[0], at[1] - computed[1]])
        });
        Some(Link { at, residual_px, ..link })
    };
    let placement = placed.placement.map(|placement| {
        let links = placement.links.iter().copied().enumerate().filter_map(link).collect();
        Placement { links, film: Some(scan.clone()), ..placement }
    });
    PlacedImage { placement, ..placed }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::CameraUncertainty;
    use crate::image::Neighbours;
    use crate::math::Random;
    use crate::orthophoto::PlacingVerdict;
    use crate::{
        BlockFlight, BlockScene, Camera, CameraMm, Fiducial, FiducialModel, GreyImage, PhotoInput, PlacingCamera, image_positions,
        place_image, rectify_placed,
    };

    /// A film of 36 x 27 mm with marks in its corners and at its sides, whose principal point is 4 px off their middle.
    const MARKS_MM: [[f64; 2]; 8] =
        [[-17.2, -12.7], [17.2, -12.7], [17.2, 12.7], [-17.2, 12.7], [-17.5, 0.0], [17.5, 0.1], [0.1, 13.0], [0.0, -13.0]];
    const PRINCIPAL_POINT_MM: [f64; 2] = [0.3, -0.24];
    const PHOTO_PX: [usize; 2] = [480, 360];
    const PIXEL_MM: f64 = 0.075;
    const SCAN_PX: [usize; 2] = [570, 470];

    /// Scanned askew, at 7°, by a scanner whose columns and rows differ by 0.6 % and lie 0.003 off a right angle.
    fn in_scan([x_mm, y_mm]: [f64; 2]) -> [f64; 2] {
        let [x, y] = [(x_mm * 1.003 + y_mm * 0.003) / PIXEL_MM, -y_mm * 0.997 / PIXEL_MM];
        let (sine, cosine) = (libm::sin(0.122), libm::cos(0.122));
        [cosine * x - sine * y + 284.3, sine * x + cosine * y + 236.8]
    }

    /// The photo on its film, in mm of the marks, by the position in the scan.
    fn on_film([col, row]: [f64; 2]) -> [f64; 2] {
        let (sine, cosine) = (libm::sin(0.122), libm::cos(0.122));
        let [u, v] = [col - 284.3, row - 236.8];
        let [x, y] = [cosine * u + sine * v, cosine * v - sine * u];
        let y_mm = -y * PIXEL_MM / 0.997;
        [(x * PIXEL_MM - 0.003 * y_mm) / 1.003, y_mm]
    }

    struct Scanned {
        scene: BlockScene,
        reference: Orthophoto,
        area: SearchArea,
        scan: GreyImage,
        film: FilmInput,
    }

    fn options() -> PlacingOptions {
        PlacingOptions { points: 3000, ..PlacingOptions::default() }
    }

    /// A photo of a scene on film, with a black border and marks, on the scene's orthophoto.
    fn scanned() -> Scanned {
        let [width_px, height_px] = PHOTO_PX.map(|side| side as u32);
        let flight = BlockFlight {
            strips: 1,
            exposures: 1,
            width_px,
            height_px,
            pixel_mm: PIXEL_MM,
            relief_m: 40.0,
            seed: 3,
            ..BlockFlight::default()
        };
        let scene = BlockScene::new(&flight).unwrap();
        let photo = scene.photo(0).unwrap();
        let grey = |c: usize, r: usize| {
            let [x_mm, y_mm] = on_film([c as f64 + 0.5, r as f64 + 0.5]);
            let off_mark = |mark: &[f64; 2]| (x_mm - mark[0]).abs().max((y_mm - mark[1]).abs());
            match MARKS_MM.iter().map(off_mark).fold(f64::INFINITY, f64::min) {
                off if off < 0.1 => return 255,
                off if off < 0.35 => return 0,
                _ => {}
            }
            let [x, y] = [x_mm - PRINCIPAL_POINT_MM[0], y_mm - PRINCIPAL_POINT_MM[1]];
            let at = [0.5 * PHOTO_PX[0] as f64 + x / PIXEL_MM, 0.5 * PHOTO_PX[1] as f64 - y / PIXEL_MM];
            let is_photo = (0..2).all(|k| (0.0..=PHOTO_PX[k] as f64).contains(&at[k]));
            if is_photo { Neighbours::about(at, [photo.width(), photo.height()]).mean(photo.view()) } else { 12 }
        };
        let scan = GreyImage::from_fn(SCAN_PX[0], SCAN_PX[1], grey).unwrap();
        // Marks are measured to a twentieth of a pixel.
        let mut random = Random::new(1);
        let mut off = || (random.below(1000) as f64 / 999.0 - 0.5) * 0.17;
        let fiducials = MARKS_MM.map(|[x_mm, y_mm]| {
            let [col, row] = in_scan([x_mm, y_mm]);
            Fiducial { col: col + off(), row: row + off(), x_mm, y_mm }
        });
        let focal_mm = scene.truth().cameras[0].focal_px * PIXEL_MM;
        let camera = CameraMm { principal_point_mm: PRINCIPAL_POINT_MM, ..CameraMm::without_distortion(focal_mm, None) };
        let scan_input = PhotoInput { fiducials: fiducials.to_vec(), ..PhotoInput::default() };
        let reference = scene.orthophoto(0.8).unwrap();
        let area = SearchArea::new(&reference, &options()).unwrap();
        Scanned { scene, reference, area, scan, film: FilmInput { camera: Some(camera), scan: scan_input, marks_mm: Vec::new() } }
    }

    /// Errors of the projection centre in m, and by their standard errors.
    fn errors(scene: &BlockScene, placement: &Placement) -> [(f64, f64); 3] {
        let (truth, sigma) = (scene.truth().images[0].pose.unwrap(), placement.position_errors_m.unwrap());
        [0, 1, 2].map(|k| {
            let off = placement.pose.position[k] - truth.position[k];
            (off, off / sigma[k])
        })
    }

    fn length(errors: &[(f64, f64); 3]) -> f64 {
        errors.iter().map(|(off, _)| off * off).sum::<f64>().sqrt()
    }

    #[test]
    fn a_scan_of_film_is_placed_by_its_marks_and_worse_without_them() {
        let Scanned { scene, reference, area, scan, film } = &scanned();
        let placed = |film: &FilmInput| place_film(scan.view(), film, None, reference, area, &options()).unwrap();
        let found = placed(film);
        assert!(matches!(found.verdict, PlacingVerdict::Placed { .. }), "{}", found.verdict);
        let placement = found.placement.unwrap();
        let with_marks = errors(scene, &placement);
        println!("with marks: {with_marks:.3?}, checks {:?}", placement.checks);

        // The principal point where a camera without film has it, and the same with that of the calibration.
        let [width_px, height_px] = SCAN_PX.map(|side| side as u32);
        let focal_px = scene.truth().cameras[0].focal_px;
        let camera = Camera::without_distortion(width_px, height_px, focal_px);
        let known = PlacingCamera { camera, uncertainty: CameraUncertainty::NONE, decentring: None };
        let without = place_image(scan.view(), &known, reference, area, &options()).unwrap().placement.unwrap();
        let without_marks = errors(scene, &without);
        println!("without: {without_marks:.3?}, checks {:?}", without.checks);
        let similarity = PhotoInput { model: FiducialModel::Similarity, ..film.scan.clone() };
        let by_similarity = placed(&FilmInput { scan: similarity, ..film.clone() }).placement.unwrap();
        println!("similarity: {:.3?}, checks {:?}", errors(scene, &by_similarity), by_similarity.checks);

        assert!(with_marks.iter().all(|(off, ratio)| off.abs() < 1.0 && ratio.abs() < 4.0), "{with_marks:?}");
        assert!(length(&without_marks) > 10.0 * length(&with_marks), "{without_marks:?} {with_marks:?}");
        let rmse_px = |placement: &Placement| placement.checks.unwrap().rmse_px;
        assert!(rmse_px(&by_similarity) > 1.3 * rmse_px(&placement), "{} {}", rmse_px(&by_similarity), rmse_px(&placement));

        // Positions are those of the scan, within its marks; residuals lead to where the image shows the places.
        let seen =
            image_positions(&placement, &reference.heights, &placement.links.iter().map(|l| [l.place[0], l.place[1]]).collect::<Vec<_>>());
        for (link, seen) in placement.links.iter().zip(seen) {
            let ([x, y], residual) = (seen.unwrap(), link.residual_px.unwrap());
            assert!((link.at[0] - x - residual[0]).abs() < 1e-6 && (link.at[1] - y - residual[1]).abs() < 1e-6, "{link:?} {x} {y}");
            let [x_mm, y_mm] = on_film(link.at);
            assert!(x_mm.abs() < 17.2 && y_mm.abs() < 12.7, "{x_mm} {y_mm}");
        }
        let film_scan = placement.film.clone().unwrap();
        assert!(film_scan.marks.sigma0_mm.is_some_and(|sigma0| (0.001..0.01).contains(&sigma0)), "{:?}", film_scan.marks.sigma0_mm);
        let table = crate::placed_table(&[("a.png".into(), PlacedImage { placement: Some(placement.clone()), ..found })]);
        assert!(table.lines().next().unwrap().contains(",gsd,marks_sigma0_mm,marks_rmse_mm,"), "{table}");
        let picture = rectify_placed(&scan.clone().into(), &placement, reference).unwrap();
        assert!(picture.mask.data().iter().filter(|v| **v == 255).count() > 100_000);

        // The links that were found give it again; beside the frame there is none.
        let mut links: Vec<GivenLink> = (placement.links.iter())
            .map(|link| GivenLink { at: link.at, place: [link.place[0], link.place[1]], part: GivenUse::Used, by_hand: false })
            .collect();
        let by_links = |links: &[GivenLink]| place_film_by_links(&film_scan, None, reference, Some(&placement), links, &options());
        let again = by_links(&links).unwrap().placement.unwrap();
        let apart = [0, 1, 2].map(|k| again.pose.position[k] - placement.pose.position[k]);
        assert!(apart.iter().all(|off| off.abs() < 0.5), "{apart:?}");
        links[2].at = [3.0, 3.0];
        assert!(by_links(&links).unwrap_err().to_string().contains("of link 3"));
    }
}
