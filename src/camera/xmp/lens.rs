//! Lenses that XMP describes, each in the maker's terms.

use super::properties::{Namespace, Properties, numbers};

/// What DJI says of a lens, in px of the photo as it was taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DjiLens {
    /// As calibrated in the works, or by its owner; what was designed otherwise.
    pub focal_px: f64,
    pub calibrated: Option<DewarpData>,
    /// As designed.
    pub principal_point_px: Option<[f64; 2]>,
    /// Whether the photo was freed of its distortion before it was written.
    pub is_dewarped: bool,
}

/// A calibration in the terms of Brown, in the direction from object to image.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DewarpData {
    /// Principal point from the middle of the photo, x right, y down.
    pub offset_px: [f64; 2],
    pub radial: [f64; 3],
    pub tangential: [f64; 2],
}

impl DjiLens {
    /// # Source
    /// DJI 2023, Mavic 3M User Manual, Photo File: `DewarpData` is fx, fy (calibrated focal length in px), cx, cy (calibrated optical centre in
    /// px from the centre of the photo), k1, k2, p1, p2, k3; `CalibratedFocalLength` and `CalibratedOpticalCenterX`, `Y` are those of the
    /// design; `DewarpFlag` is 1 where the photo was dewarped. DJI, P4R White Paper: a date goes before fx, the focal length is (fx + fy)/2, and
    /// the principal point is (width/2 + cx, height/2 + cy) from the top left.
    pub(super) fn of(properties: &Properties) -> Option<Self> {
        let number = |name| properties.number(Namespace::Dji, name);
        let data = properties.text(Namespace::Dji, "DewarpData").and_then(|text| {
            let values = text.split_once(';').map_or(text, |(_, values)| values);
            numbers::<9>(values).filter(|[fx, fy, ..]| is_focal_px(*fx) && is_focal_px(*fy))
        });
        let designed = number("CalibratedFocalLength").filter(|f| is_focal_px(*f));
        let calibrated =
            data.map(|[_, _, cx, cy, k1, k2, p1, p2, k3]| DewarpData { offset_px: [cx, cy], radial: [k1, k2, k3], tangential: [p1, p2] });
        Some(Self {
            focal_px: data.map(|[fx, fy, ..]| 0.5 * (fx + fy)).or(designed)?,
            calibrated,
            principal_point_px: number("CalibratedOpticalCenterX").zip(number("CalibratedOpticalCenterY")).map(Into::into),
            is_dewarped: number("DewarpFlag") == Some(1.0),
        })
    }
}

/// What the properties of Pix4D say of a lens, as Parrot, MicaSense and senseFly write them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pix4dLens {
    pub projection: Projection,
    /// From the top left of the sensor, x right, y down.
    pub principal_point_mm: Option<[f64; 2]>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Projection {
    /// In the terms of Brown, in the direction from object to image.
    Perspective { focal_mm: f64, radial: [f64; 3], tangential: [f64; 2] },
    /// A direction at the angle a from the axis is seen at `scale_px` (θ + p₂θ² + p₃θ³) from the principal point, with θ = 2a/π.
    Fisheye { scale_px: f64, polynomial: [f64; 2] },
}

impl Pix4dLens {
    /// # Source
    /// Pix4D, Specifications of XMP Camera Tags: `PerspectiveFocalLength` and `PrincipalPoint` in mm, `PerspectiveDistortion` R1, R2, R3, T1, T2,
    /// `FisheyeAffineMatrix` C, D, E, F in px, `FisheyePolynomial` from the constant on; and How are the Internal and External Camera Parameters
    /// defined, for what they mean. A focal length in px is marked by `PerspectiveFocalLengthUnits`, which is not read.
    pub(super) fn of(properties: &Properties) -> Option<Self> {
        let text = |name| properties.text(Namespace::Camera, name);
        let projection = if text("ModelType").is_some_and(|kind| kind.eq_ignore_ascii_case("fisheye")) {
            let [c, d, e, f] = properties.numbers(Namespace::Camera, "FisheyeAffineMatrix")?;
            let [p0, p1, p2, p3] = properties.numbers(Namespace::Camera, "FisheyePolynomial")?;
            // Anything else is no rotationally symmetric lens.
            if [d, e, p0] != [0.0; 3] || p1 != 1.0 || !is_focal_px(c) || !is_focal_px(f) {
                return None;
            }
            Projection::Fisheye { scale_px: 0.5 * (c + f), polynomial: [p2, p3] }
        } else {
            if text("PerspectiveFocalLengthUnits").is_some_and(|unit| unit != "mm") {
                return None;
            }
            let focal_mm = properties.number(Namespace::Camera, "PerspectiveFocalLength").filter(|f| *f > 0.0 && *f <= 1e4)?;
            let [k1, k2, k3, p1, p2] = properties.numbers(Namespace::Camera, "PerspectiveDistortion").unwrap_or_default();
            Projection::Perspective { focal_mm, radial: [k1, k2, k3], tangential: [p1, p2] }
        };
        Some(Self { projection, principal_point_mm: properties.numbers(Namespace::Camera, "PrincipalPoint") })
    }
}

/// Anything else is a damaged field.
fn is_focal_px(focal: f64) -> bool {
    (10.0..=1e6).contains(&focal)
}
