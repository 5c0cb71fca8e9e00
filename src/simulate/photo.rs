//! Central projection: from the ground to the photo, from the photo to the pixels of its scan, and back.

use super::flight::{FRAME_MM, Flight};
use super::random::Random;
use crate::camera::{Fiducial, radial_factor, rotation_from_angles, undistorted};
use nalgebra::{Matrix3, Vector2, Vector3};

/// A half-line in ground coordinates. Its direction has length 1 along the optical axis, so that `t` is a depth in m.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ray {
    pub(super) origin: Vector3<f64>,
    pub(super) direction: Vector3<f64>,
}

impl Ray {
    pub(super) fn at(&self, t: f64) -> Vector3<f64> {
        self.origin + self.direction * t
    }
}

/// A photo with exterior orientation and its interior geometry.
#[derive(Debug, Clone)]
pub(super) struct Photo {
    pub(super) centre: Vector3<f64>,
    pub(super) photo_from_ground: Matrix3<f64>,
    pub(super) focal_mm: f64,
    pub(super) principal_point_mm: [f64; 2],
    /// k₁ in mm⁻².
    pub(super) distortion: f64,
    pub(super) scan: Scan,
    /// Column and row of the scan's pixel that is the patch's top-left one.
    pub(super) origin_px: [f64; 2],
}

impl Photo {
    /// Where a ground point is seen: `[x, y]` in px of the patch. The point must lie in front of the camera.
    pub(super) fn project(&self, point: Vector3<f64>) -> [f64; 2] {
        let seen = self.photo_from_ground * (point - self.centre);
        let scale = -self.focal_mm / seen.z;
        let [x0, y0] = self.principal_point_mm;
        let mm = measured(Vector2::new(scale * seen.x, scale * seen.y), self.distortion, self.focal_mm);
        let [col, row] = self.scan.to_px(Vector2::new(x0 + mm.x, y0 + mm.y));
        [col - self.origin_px[0], row - self.origin_px[1]]
    }

    /// Whether a point lies in front of the camera.
    pub(super) fn faces(&self, point: Vector3<f64>) -> bool {
        self.photo_from_ground.row(2).transpose().dot(&(point - self.centre)) < 0.0
    }

    /// The rays of all pixel positions: but for distortion the direction is linear in column and row.
    pub(super) fn rays(&self) -> RayField {
        let to_mm = |col, row| self.scan.to_mm([col + self.origin_px[0], row + self.origin_px[1]]);
        let direction = |mm: Vector2<f64>| {
            let [x0, y0] = self.principal_point_mm;
            self.photo_from_ground.transpose() * Vector3::new(mm.x - x0, mm.y - y0, -self.focal_mm) / self.focal_mm
        };
        let corner = direction(to_mm(0.0, 0.0));
        RayField {
            centre: self.centre,
            corner,
            per_col: direction(to_mm(1.0, 0.0)) - corner,
            per_row: direction(to_mm(0.0, 1.0)) - corner,
            axis: -self.photo_from_ground.row(2).transpose(),
            distortion: self.distortion * self.focal_mm * self.focal_mm,
        }
    }
}

/// Where a lens puts what belongs at ideal photo coordinates in mm: measured ones times 1 + k₁ r² are the ideal ones. Not a number far
/// outside the frame, where a lens that bends so much shows nothing.
fn measured(ideal: Vector2<f64>, k1: f64, focal_mm: f64) -> Vector2<f64> {
    if k1 == 0.0 {
        return ideal;
    }
    let found = undistorted((ideal / focal_mm).into(), [k1 * focal_mm * focal_mm, 0.0, 0.0], [0.0; 2]);
    Vector2::from(found.unwrap_or([f64::NAN; 2])) * focal_mm
}

/// The rays of a photo's patch.
#[derive(Debug, Clone, Copy)]
pub(super) struct RayField {
    centre: Vector3<f64>,
    corner: Vector3<f64>,
    per_col: Vector3<f64>,
    per_row: Vector3<f64>,
    /// The optical axis.
    axis: Vector3<f64>,
    /// k₁ for coordinates in focal lengths.
    distortion: f64,
}

impl RayField {
    /// The ray of a position in px of the patch.
    pub(super) fn ray(&self, x: f64, y: f64) -> Ray {
        let mut direction = self.corner + self.per_col * x + self.per_row * y;
        if self.distortion != 0.0 {
            let across = direction - self.axis;
            direction = self.axis + across * radial_factor([self.distortion, 0.0, 0.0], across.norm_squared());
        }
        Ray { origin: self.centre, direction }
    }
}

/// How film was scanned: the affine transformation from photo coordinates in mm (x right, y up) to px of the scan.
#[derive(Debug, Clone)]
pub(super) struct Scan {
    /// `[[a, b, col of the centre], [d, e, row of the centre]]`.
    px_from_mm: [[f64; 3]; 2],
}

impl Scan {
    /// A scan whose film shrank and lay a little askew: scales within 0.3 %, axes within 0.003 rad.
    pub(super) fn new(pixel_mm: f64, random: &mut Random) -> Self {
        let per_mm = 1.0 / pixel_mm;
        let middle = (0.5 * FRAME_MM + MARGIN_MM) * per_mm;
        let mut skew = |size: f64| random.between(-size, size);
        Self {
            px_from_mm: [
                [per_mm * (1.0 + skew(0.003)), per_mm * skew(0.003), middle],
                [per_mm * skew(0.003), -per_mm * (1.0 + skew(0.003)), middle],
            ],
        }
    }

    /// The raster of a digital camera whose principal point is the middle of its image.
    pub(super) fn digital(pixel_mm: f64, width_px: u32, height_px: u32) -> Self {
        let per_mm = 1.0 / pixel_mm;
        Self { px_from_mm: [[per_mm, 0.0, 0.5 * f64::from(width_px)], [0.0, -per_mm, 0.5 * f64::from(height_px)]] }
    }

    pub(super) fn to_px(&self, mm: Vector2<f64>) -> [f64; 2] {
        self.px_from_mm.map(|[along_x, along_y, shift]| along_x * mm.x + along_y * mm.y + shift)
    }

    pub(super) fn to_mm(&self, px: [f64; 2]) -> Vector2<f64> {
        let [[a, b, col], [d, e, row]] = self.px_from_mm;
        let (u, v, determinant) = (px[0] - col, px[1] - row, a * e - b * d);
        Vector2::new((e * u - b * v) / determinant, (a * v - d * u) / determinant)
    }

    /// The eight marks as a comparator measures them in the scan.
    pub(super) fn measure(&self, noise_px: f64, random: &mut Random) -> Vec<Fiducial> {
        MARKS_MM
            .iter()
            .map(|&[x_mm, y_mm]| {
                let [col, row] = self.to_px(Vector2::new(x_mm, y_mm));
                let noise = random.normal_pair() * noise_px;
                Fiducial { col: col + noise.x, row: row + noise.y, x_mm, y_mm }
            })
            .collect()
    }
}

/// Scanned film beyond the frame, in mm.
const MARGIN_MM: f64 = 1.0;

/// Calibrated fiducial marks of a film camera: four in the corners, four at the sides.
const MARKS_MM: [[f64; 2]; 8] = [
    [-105.987, -106.006],
    [105.998, 106.007],
    [-105.997, 106.006],
    [106.000, -106.002],
    [-112.008, -0.005],
    [112.005, 0.000],
    [-0.005, 112.012],
    [-0.008, -111.992],
];

/// The two photos of a flight, with patches that show the same ground.
pub(super) fn photos(flight: &Flight, scans: [Scan; 2], cut_px: [f64; 2]) -> [Photo; 2] {
    let ground_from_model = rotation([flight.left_omega_deg, flight.left_phi_deg, flight.left_kappa_deg]).transpose();
    let base_mm = Vector3::new(flight.base_mm, flight.by_mm, flight.bz_mm);
    let left_centre = Vector3::new(0.0, 0.0, flight.flying_height_m);
    let right_centre = left_centre + ground_from_model * base_mm * flight.scale_m_per_mm();
    let [left_scan, right_scan] = scans;
    let photo = |centre, photo_from_ground, scan| Photo {
        centre,
        photo_from_ground,
        focal_mm: flight.focal_mm,
        principal_point_mm: [flight.principal_x_mm, flight.principal_y_mm],
        distortion: flight.distortion,
        scan,
        origin_px: [0.0, 0.0],
    };
    let mut left = photo(left_centre, ground_from_model.transpose(), left_scan);
    let mut right =
        photo(right_centre, rotation([flight.omega_deg, flight.phi_deg, flight.kappa_deg]) * ground_from_model.transpose(), right_scan);
    cut(flight, &mut left, &mut right, cut_px);
    [left, right]
}

/// Cuts the left patch from the middle of the overlap and the right one where it shows the same mean ground, `cut_px` aside.
fn cut(flight: &Flight, left: &mut Photo, right: &mut Photo, cut_px: [f64; 2]) {
    let half = [0.5 * flight.width_px as f64, 0.5 * flight.height_px as f64];
    let [x0, y0] = [flight.principal_x_mm, flight.principal_y_mm];
    let middle = left.scan.to_px(Vector2::new(x0 + 0.5 * flight.base_mm, y0));
    left.origin_px = [0, 1].map(|axis| (middle[axis] - half[axis]).round());
    let ray = left.rays().ray(half[0], half[1]);
    let seen = right.project(ray.at(-ray.origin.z / ray.direction.z));
    right.origin_px = [0, 1].map(|axis| (seen[axis] - half[axis] + cut_px[axis]).round());
}

/// The rotation from the ground to a photo of ω, φ, κ in degrees.
fn rotation(degrees: [f64; 3]) -> Matrix3<f64> {
    let [omega, phi, kappa] = degrees.map(|angle| angle * std::f64::consts::PI / 180.0);
    rotation_from_angles(omega, phi, kappa)
}
