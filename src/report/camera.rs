//! The cameras of both photos: what was known of them and where from, and what the orientation tells.

use super::steps::Report;
use crate::html::{in_unit, plus_minus, said};
use crate::{
    CameraMm, CameraUncertainty, Error, EstimatedCamera, Interior, KnownPhoto, PairCameras, PairInterior, PhotoInput, RelativeOrientation,
    Texts,
};
use maud::{Markup, html};

/// A constant with its standard error, where it has one.
type Constant = (f64, Option<f64>);

/// The constants of a camera in px of its image.
struct Constants {
    focal_px: Constant,
    /// x to the right, y up.
    principal_point_px: [Constant; 2],
    /// k1, k2, k3, p1, p2 of the correction, in units of the focal length.
    distortion: [Constant; 5],
}

impl Constants {
    /// `errors` of the focal length, both coordinates of the principal point, and k1, in the units of the constants.
    fn of(interior: &Interior, focal_mm: f64, errors: Option<[f64; 4]>) -> Self {
        let pixel_mm = interior.pixel_mm();
        let error = |k: usize| errors.map(|errors| errors[k]);
        let [k1, k2, k3] = interior.radial_distortion;
        let [p1, p2] = interior.tangential_distortion;
        let [x, y] = interior.principal_point_mm.map(|v| v / pixel_mm);
        let f2 = focal_mm * focal_mm;
        Self {
            focal_px: (focal_mm / pixel_mm, error(0)),
            principal_point_px: [(x, error(1)), (y, error(2))],
            distortion: [
                (k1 * f2, error(3)),
                (k2 * f2 * f2, None),
                (k3 * f2 * f2 * f2, None),
                (p1 * focal_mm, None),
                (p2 * focal_mm, None),
            ],
        }
    }

    /// As they were known beforehand.
    fn before(interior: &Interior, focal_mm: f64) -> Self {
        let focal_px = focal_mm / interior.pixel_mm();
        let errors = |CameraUncertainty { focal, principal_point, k1 }: CameraUncertainty| {
            [focal * focal_px, principal_point * focal_px, principal_point * focal_px, k1]
        };
        Self::of(interior, focal_mm, interior.uncertainty.map(errors))
    }

    /// As the orientation has estimated them together with its unknowns.
    fn after((interior, focal_mm): &(Interior, f64), camera: &EstimatedCamera, is_turned: bool) -> Self {
        let pixel_mm = interior.pixel_mm();
        let [x, y] = camera.principal_point_standard_errors_mm;
        let [x, y] = if is_turned { [y, x] } else { [x, y] };
        let errors =
            [camera.focal_standard_error_mm / pixel_mm, x / pixel_mm, y / pixel_mm, camera.k1_standard_error_per_mm2 * focal_mm * focal_mm];
        Self::of(interior, *focal_mm, Some(errors))
    }
}

/// A photo in the table: where its camera comes from, the side of its pixels where that is known, and a column or two.
struct Column {
    origin: String,
    pixel_mm: Option<f64>,
    states: Vec<Constants>,
}

/// Both cameras; nothing where none is known or assumed.
pub fn cameras(texts: &Texts, report: &Report) -> Result<Markup, Error> {
    let result = &report.studies[0].result;
    let Some(interior) = &result.interior else { return Ok(html! {}) };
    let photos: [KnownPhoto<'_>; 2] = [(0, &report.input.left), (1, &report.input.right)].map(|(k, photo)| known(report, k, photo));
    let known = PairCameras::of(report.input.camera.as_ref(), photos)?.ok();
    let oriented = result.orientation.as_ref().ok();
    let estimated = oriented.and_then(|oriented| estimated(interior, oriented));
    let column = |side: usize| {
        let own = known.as_ref().map(|known| if side == 0 { &known.left } else { &known.right });
        let side_interior = if side == 0 { &interior.left } else { &interior.right };
        let before = Constants::before(side_interior, interior.focal_mm);
        let pixel_mm =
            own.filter(|camera| photos[side].has_marks || !camera.is_nominal()).map(|camera| camera.focal_mm / before.focal_px.0);
        let after = estimated.as_ref().map(|estimated| {
            let (interiors, cameras, is_turned) = estimated;
            Constants::after(&interiors[side], &cameras[side], *is_turned)
        });
        Column { origin: origin(texts, report, side, own), pixel_mm, states: std::iter::once(before).chain(after).collect() }
    };
    Ok(table(texts, &[column(0), column(1)], estimated.is_some()))
}

fn known<'a>(report: &'a Report, side: usize, photo: &PhotoInput) -> KnownPhoto<'a> {
    let image = &report.images[side];
    KnownPhoto { size: (image.grey.width(), image.grey.height()), exif: image.exif.as_ref(), has_marks: !photo.fiducials.is_empty() }
}

/// What an orientation tells of the cameras beyond what was known of them: interior orientations with their focal lengths, and errors; and whether the
/// latter are in photo axes turned by 90°.
type Estimated = ([(Interior, f64); 2], [EstimatedCamera; 2], bool);

fn estimated(interior: &PairInterior, oriented: &RelativeOrientation) -> Option<Estimated> {
    let cameras = oriented.cameras?;
    let found = interior.estimated(oriented);
    let tells_more = found.iter().any(|(_, focal_mm)| *focal_mm != interior.focal_mm);
    tells_more.then_some((found, cameras, oriented.turn_deg != 0.0))
}

/// Where the camera of a photo comes from.
fn origin(texts: &Texts, report: &Report, side: usize, known: Option<&CameraMm>) -> String {
    let image = &report.images[side];
    match (known, &report.input.camera, &image.exif) {
        (Some(_), Some(_), _) => texts.say("report-camera-given"),
        (Some(_), None, Some(exif)) => {
            let size = [image.grey.width() as u32, image.grey.height() as u32];
            texts.with("report-origin", [("origin", said(texts, &exif.origin)), ("camera", exif.label(size))])
        }
        _ => match &report.studies[0].result.geometry {
            Some(Ok(found)) if found.focal.is_some() => texts.say("report-focal-by-geometry"),
            _ => texts.say("report-camera-assumed"),
        },
    }
}

/// A quantity of the table: its name, and its value and error of a camera with pixels of so many mm.
type Quantity = (String, Box<dyn Fn(&Constants, Option<f64>) -> Option<Constant>>);

fn quantities(texts: &Texts, columns: &[Column; 2]) -> Vec<Quantity> {
    let scaled = |(value, error): Constant, by: f64| (by * value, error.map(|error| by * error));
    let focal_length = texts.say("report-focal-length");
    let mut all: Vec<Quantity> = vec![
        (in_unit(texts, &focal_length, "mm"), Box::new(move |c, pixel| Some(scaled(c.focal_px, pixel?)))),
        (in_unit(texts, &focal_length, "px"), Box::new(|c, _| Some(c.focal_px))),
    ];
    for (k, axis) in ["x", "y"].into_iter().enumerate() {
        let point = texts.with("report-principal-point", [("axis", axis.into())]);
        all.push((in_unit(texts, &point, "mm"), Box::new(move |c, pixel| Some(scaled(c.principal_point_px[k], pixel?)))));
        all.push((in_unit(texts, &point, "px"), Box::new(move |c, _| Some(c.principal_point_px[k]))));
    }
    for (k, name) in ["k1", "k2", "k3", "p1", "p2"].into_iter().enumerate() {
        let is_there = columns.iter().flat_map(|column| &column.states).any(|state| state.distortion[k].0 != 0.0);
        if k == 0 || is_there {
            all.push((texts.with("report-distortion", [("term", name.into())]), Box::new(move |c, _| Some(c.distortion[k]))));
        }
    }
    let is_known = |quantity: &Quantity| columns.iter().any(|column| (quantity.1)(&column.states[0], column.pixel_mm).is_some());
    all.into_iter().filter(is_known).collect()
}

fn table(texts: &Texts, columns: &[Column; 2], is_estimated: bool) -> Markup {
    let per_photo = if is_estimated { 2 } else { 1 };
    html! {
        table tabindex="0" {
            caption { (texts.say("report-cameras")) }
            thead {
                tr { td {} @for name in ["report-left", "report-right"] { th colspan=(per_photo) { (texts.say(name)) } } }
                @if is_estimated { tr { td {} @for _ in columns { th { (texts.say("report-as-known")) } th { (texts.say("report-estimated")) } } } }
            }
            tbody {
                tr { th { (texts.say("report-from")) } @for column in columns { td.words colspan=(per_photo) { (column.origin) } } }
                @for (name, of) in quantities(texts, columns) {
                    tr {
                        th { (name) }
                        @for column in columns { @for state in &column.states { td { (written(of(state, column.pixel_mm))) } } }
                    }
                }
            }
        }
        p.note {
            (texts.say("report-camera-errors")) " "
            @if is_estimated { (texts.say("report-camera-estimated")) " " }
            (texts.say("report-camera-axes"))
            @if columns.iter().any(|column| column.pixel_mm.is_none()) { " " (texts.say("report-pixel-unknown")) }
        }
    }
}

fn written(constant: Option<Constant>) -> String {
    constant.map_or_else(|| "–".into(), |(value, error)| plus_minus(value, error))
}
