//! The common system of two epipolar images: axes along the base, one focal length, rows that both show.

use super::pair::StereoPair;
use super::system::StereoSystem;
use super::view::StereoView;
use crate::error::refuse;
use crate::math::median;
use crate::{Error, Refusal};
use nalgebra::{Matrix3, Vector3};
use serde::Serialize;

/// Farthest direction from the axis of the epipolar images that they show, as its tangent.
const WIDEST: f64 = 3.0;

/// Median angle below which the rays to the points that both images show are parallel: the direction of the base is that of its errors.
const LEAST_ANGLE_DEG: f64 = 0.05;

/// Positions across an image by which the directions that it shows are given.
const ACROSS: usize = 32;

/// Larger images are made of larger pixels.
const MOST_PIXELS: f64 = 1e8;

/// How two epipolar images lie: cameras without distortion, of one focal length, with the same axes, whose x axis is the base.
///
/// A point of the object is seen at col = c_x + f·U/(-W), row = c_y - f·V/(-W) with (U, V, W) = M·(X - X₀), M being `rotation` and X₀ the
/// projection centre of either image. Both have the same row; its distance from the base in the direction of the axis is
/// -W = f·base / ((col_left - c_x left) - (col_right - c_x right)).
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct EpipolarGeometry {
    /// Of either image.
    pub width_px: usize,
    pub height_px: usize,
    pub focal_px: f64,
    /// Of the left and the right image: they differ in the column, so that the median x-parallax is about 0. The centre of the top-left pixel is (0.5, 0.5).
    pub principal_points_px: [[f64; 2]; 2],
    /// Rows of M, from the object to the photos: x along the base from left to right, y up, z against the view.
    pub rotation: [[f64; 3]; 3],
    /// Projection centres of the left and the right image.
    pub projection_centres: [[f64; 3]; 2],
    /// Distance of the projection centres, in units of the block; of a pair in mm at the scale of the photo coordinates.
    pub base: f64,
    /// Parallaxes of the points that both show; absent where none is known.
    pub parallaxes: Option<Parallaxes>,
}

/// Parallaxes of known points in the epipolar images.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Parallaxes {
    pub points: usize,
    /// Root mean square of the residual y-parallaxes: differences of rows, left minus right.
    pub y_rms_px: f64,
    /// The smallest, the median and the largest difference of columns, left minus right.
    pub x_px: [f64; 3],
}

/// Where directions lie in the epipolar images: x to the right and y up from the principal point, in px.
#[derive(Debug, Clone, Copy)]
struct Extent {
    low: [f64; 2],
    high: [f64; 2],
}

impl EpipolarGeometry {
    /// Lays out the epipolar images of two oriented ones. `points_px`: positions of the same points in the left and the right one; where none
    /// are given, what is very far away has no parallax.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for images without a base, for those that look along it, and where no row or column would show anything of both.
    pub fn new(views: [&StereoView; 2], points_px: &[[[f64; 2]; 2]]) -> Result<Self, Error> {
        let names = || views.map(|view| view.name.clone());
        let [left, right] = views.map(|view| Vector3::from(view.pose.position));
        let base = (right - left).norm();
        if !(base > 0.0 && base.is_finite()) {
            let [left, right] = names();
            return refuse(Refusal::EpipolarBase { left, right });
        }
        let direction = (right - left) / base;
        let rotation = axes(direction, views).filter(|_| !views.iter().any(|view| shows(view, direction) || shows(view, -direction)));
        let Some(rotation) = rotation else {
            let [left, right] = names();
            return refuse(Refusal::EpipolarAlongBase { left, right });
        };
        if intersection_angle_deg(views, points_px).is_some_and(|angle_deg| angle_deg < LEAST_ANGLE_DEG) {
            let [left, right] = names();
            return refuse(Refusal::EpipolarBase { left, right });
        }
        let to_epipolar = views.map(|view| rotation * view.pose.matrix().transpose());
        let mut focal_px = 0.5 * (views[0].focal_px() + views[1].focal_px());
        let [of_left, of_right] = [0, 1].map(|side| extent(views[side], &to_epipolar[side]));
        let placed: Vec<[[f64; 2]; 2]> = points_px.iter().filter_map(|places| both(views, &to_epipolar, places)).collect();
        let middle = median(&mut placed.iter().map(|[a, b]| a[0] - b[0]).collect::<Vec<_>>()).unwrap_or(0.0);
        // In the left image; the right one shows the same columns once the median parallax is taken off.
        let low = [of_left.low[0].max(of_right.low[0] + middle), of_left.low[1].max(of_right.low[1])];
        let high = [of_left.high[0].min(of_right.high[0] + middle), of_left.high[1].min(of_right.high[1])];
        let area = (high[0] - low[0]).max(0.0) * (high[1] - low[1]).max(0.0) * focal_px * focal_px;
        focal_px /= (area / MOST_PIXELS).sqrt().max(1.0);
        let [width_px, height_px] = [0, 1].map(|axis| (focal_px * (high[axis] - low[axis])).floor());
        if !(width_px >= 1.0 && height_px >= 1.0) {
            let [left, right] = names();
            return refuse(Refusal::EpipolarOverlap { left, right });
        }
        // On whole pixels, so that differences of columns change by a whole number.
        let shift_px = (focal_px * middle).round();
        let column = (-focal_px * low[0]).round();
        let row = (focal_px * high[1]).round();
        let made = Self {
            width_px: width_px as usize,
            height_px: height_px as usize,
            focal_px,
            principal_points_px: [[column, row], [column + shift_px, row]],
            rotation: [0, 1, 2].map(|r| [0, 1, 2].map(|c| rotation[(r, c)])),
            projection_centres: views.map(|view| view.pose.position),
            base,
            parallaxes: None,
        };
        Ok(Self { parallaxes: made.parallaxes_of(&placed), ..made })
    }

    /// The parameters as a file of JSON, with the names of the images and their system.
    pub fn file(&self, pair: &StereoPair) -> String {
        #[derive(Serialize)]
        struct File<'a> {
            left: &'a str,
            right: &'a str,
            system: &'a StereoSystem,
            #[serde(flatten)]
            geometry: &'a EpipolarGeometry,
        }
        let [left, right] = pair.views.each_ref().map(|view| view.name.as_str());
        serde_json::to_string_pretty(&File { left, right, system: &pair.system, geometry: self }).expect("numbers and names are written")
            + "\n"
    }

    /// The matrix from the epipolar photo system to that of an image.
    pub(super) fn to_view(&self, view: &StereoView) -> Matrix3<f64> {
        view.pose.matrix() * Matrix3::from_fn(|r, c| self.rotation[r][c]).transpose()
    }

    fn parallaxes_of(&self, placed: &[[[f64; 2]; 2]]) -> Option<Parallaxes> {
        let shift_px = self.principal_points_px[1][0] - self.principal_points_px[0][0];
        let mut x: Vec<f64> = placed.iter().map(|[a, b]| self.focal_px * (a[0] - b[0]) - shift_px).collect();
        let squares: f64 = placed.iter().map(|[a, b]| self.focal_px * (a[1] - b[1])).map(|y| y * y).sum();
        let middle = median(&mut x)?;
        let (low, high) = x.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(*v), high.max(*v)));
        Some(Parallaxes { points: x.len(), y_rms_px: (squares / x.len() as f64).sqrt(), x_px: [low, middle, high] })
    }
}

/// Rows of the matrix from the object to the epipolar images. `None` where the images look along the base, or against each other.
fn axes(x: Vector3<f64>, views: [&StereoView; 2]) -> Option<Matrix3<f64>> {
    let against = views.iter().map(|view| Vector3::from(view.pose.rotation[2])).sum::<Vector3<f64>>();
    let across = against - x * against.dot(&x);
    let length = across.norm();
    if !(length > 1e-6) {
        return None;
    }
    let z = across / length;
    Some(Matrix3::from_rows(&[x.transpose(), z.cross(&x).transpose(), z.transpose()]))
}

/// What an image shows, of focal length 1, as far as the epipolar images show it; nothing where that is none of it.
fn extent(view: &StereoView, to_epipolar: &Matrix3<f64>) -> Extent {
    let mut extent = Extent { low: [f64::INFINITY; 2], high: [f64::NEG_INFINITY; 2] };
    let [width, height] = view.size_px.map(|side| side as f64 / ACROSS as f64);
    let positions = (0..=ACROSS).flat_map(|row| (0..=ACROSS).map(move |column| [column as f64 * width, row as f64 * height]));
    for at in positions.filter_map(|position| placed(to_epipolar, view.direction(position)?)) {
        for (axis, value) in at.into_iter().enumerate() {
            extent.low[axis] = extent.low[axis].min(value.max(-WIDEST));
            extent.high[axis] = extent.high[axis].max(value.min(WIDEST));
        }
    }
    extent
}

/// Whether an image shows what lies in a direction of the object space.
fn shows(view: &StereoView, direction: Vector3<f64>) -> bool {
    let seen = view.pose.matrix() * direction;
    seen.z < 0.0 && view.position([-seen.x / seen.z, -seen.y / seen.z]).is_some_and(|at| view.sees(at))
}

/// The median angle between the rays of points that both images show; `None` without any.
fn intersection_angle_deg(views: [&StereoView; 2], points_px: &[[[f64; 2]; 2]]) -> Option<f64> {
    let ray = |side: usize, position: [f64; 2]| {
        let [x, y] = views[side].direction(position)?;
        Some((views[side].pose.matrix().transpose() * Vector3::new(x, y, -1.0)).normalize())
    };
    let angle = |[left, right]: &[[f64; 2]; 2]| Some(libm::asin(ray(0, *left)?.cross(&ray(1, *right)?).norm().min(1.0)).to_degrees());
    median(&mut points_px.iter().filter_map(angle).collect::<Vec<_>>())
}

/// Where a direction lies in the epipolar images, of focal length 1; `None` behind them.
fn placed(to_epipolar: &Matrix3<f64>, [x, y]: [f64; 2]) -> Option<[f64; 2]> {
    let seen = to_epipolar * Vector3::new(x, y, -1.0);
    (seen.z < 0.0).then(|| [-seen.x / seen.z, -seen.y / seen.z])
}

fn both(views: [&StereoView; 2], to_epipolar: &[Matrix3<f64>; 2], places: &[[f64; 2]; 2]) -> Option<[[f64; 2]; 2]> {
    let at = |side: usize| placed(&to_epipolar[side], views[side].direction(places[side])?);
    Some([at(0)?, at(1)?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::rotation_from_angles;
    use crate::{Camera, Pose};

    fn view(name: &str, angles_deg: [f64; 3], position: [f64; 3], focal_px: f64) -> StereoView {
        let camera = Camera { radial: [-0.05, 0.01, 0.0], ..Camera::without_distortion(1200, 900, focal_px) };
        let [omega, phi, kappa] = angles_deg.map(f64::to_radians);
        StereoView::of_camera(name.into(), &camera, Pose::new(&rotation_from_angles(omega, phi, kappa), position))
    }

    /// Where a view has a point of the object.
    fn seen(view: &StereoView, point: [f64; 3]) -> [f64; 2] {
        let [u, v, w] = view.pose.to_photo(&point);
        view.position([-u / w, -v / w]).unwrap()
    }

    const POINTS: [[f64; 3]; 5] = [[20.0, 10.0, 3.0], [55.0, -20.0, -4.0], [30.0, 25.0, 8.0], [45.0, 0.0, 0.0], [25.0, -15.0, 5.0]];

    #[test]
    fn points_lie_in_the_same_row_and_their_columns_give_their_distance() {
        for (turned, lower) in [(0.0, 0.0), (0.0, 12.0), (90.0, -9.0)] {
            let [left, right] = [
                view("a", [2.0, 5.0, turned + 3.0], [5.0, 2.0, 150.0], 1000.0),
                view("b", [-3.0, -6.0, turned - 4.0], [70.0, -5.0, 150.0 + lower], 1150.0),
            ];
            let points: Vec<[[f64; 2]; 2]> = POINTS.iter().map(|point| [seen(&left, *point), seen(&right, *point)]).collect();
            let made = EpipolarGeometry::new([&left, &right], &points).unwrap();
            assert!((made.base - (65.0_f64 * 65.0 + 49.0 + lower * lower).sqrt()).abs() < 1e-9 && made.focal_px == 1075.0);
            let known = made.parallaxes.unwrap();
            assert!(known.points == 5 && known.y_rms_px < 1e-7 && known.x_px[1].abs() <= 0.5, "{known:?}");
            let mut shown = 0;
            for (point, places) in POINTS.into_iter().zip(&points) {
                let at = |side: usize| {
                    let centre = made.projection_centres[side];
                    let [u, v, w] = made.rotation.map(|row| (0..3).map(|k| row[k] * (point[k] - centre[k])).sum::<f64>());
                    let [cx, cy] = made.principal_points_px[side];
                    ([cx - made.focal_px * u / w, cy + made.focal_px * v / w], -w)
                };
                let ((a, distance), (b, _)) = (at(0), at(1));
                assert!((a[1] - b[1]).abs() < 1e-9, "{a:?} {b:?}");
                let [[left_px, _], [right_px, _]] = made.principal_points_px;
                let told = made.focal_px * made.base / ((a[0] - left_px) - (b[0] - right_px));
                assert!((told - distance).abs() < 1e-9 * distance);
                if left.sees(places[0]) && right.sees(places[1]) {
                    shown += 1;
                    let size = [made.width_px, made.height_px].map(|side| side as f64);
                    assert!([a, b].iter().all(|at| (0..2).all(|k| (0.0..=size[k]).contains(&at[k]))), "{a:?} {b:?} {size:?}");
                }
            }
            assert!(shown >= 2, "{shown}");
        }
    }

    #[test]
    fn images_that_have_no_epipolar_images_are_refused() {
        let first = view("a", [0.0; 3], [0.0, 0.0, 100.0], 1000.0);
        let refused = |other: &StereoView| EpipolarGeometry::new([&first, other], &[]).unwrap_err().to_string();
        assert!(refused(&view("b", [0.0, 0.0, 10.0], [0.0, 0.0, 100.0], 1000.0)).contains("no base (pure rotation)"));
        assert!(refused(&view("b", [0.0; 3], [0.0, 0.0, 90.0], 1000.0)).contains("look along their base"));
        assert!(refused(&view("b", [0.0, 170.0, 0.0], [30.0, 0.0, 100.0], 1000.0)).contains("no rows and columns in common"));
        assert!(refused(&view("b", [60.0, 0.0, 0.0], [30.0, 0.0, 100.0], 1000.0)).contains("no rows and columns in common"));
    }

    #[test]
    fn wide_images_that_converge_show_what_both_have_in_common() {
        let [left, right] =
            [view("a", [0.0, -40.0, 0.0], [0.0, 0.0, 100.0], 700.0), view("b", [0.0, 40.0, 0.0], [160.0, 0.0, 100.0], 700.0)];
        let between = [[60.0, 20.0, 0.0], [80.0, -10.0, 5.0], [100.0, 15.0, -5.0]];
        let points: Vec<[[f64; 2]; 2]> = between.iter().map(|point| [seen(&left, *point), seen(&right, *point)]).collect();
        // The far corners of either lie more than 71° from the common axis.
        let made = EpipolarGeometry::new([&left, &right], &points).unwrap();
        assert!(made.width_px > 1000 && made.height_px > 1000 && made.parallaxes.unwrap().y_rms_px < 1e-7, "{made:?}");
    }

    #[test]
    fn rays_that_are_parallel_give_no_base() {
        let [left, right] = [view("a", [0.0; 3], [0.0, 0.0, 100.0], 1000.0), view("b", [0.0; 3], [0.05, 0.0, 100.0], 1000.0)];
        let points: Vec<[[f64; 2]; 2]> = POINTS.iter().map(|point| [seen(&left, *point), seen(&right, *point)]).collect();
        assert!(EpipolarGeometry::new([&left, &right], &points).unwrap_err().to_string().contains("no base"));
    }

    #[test]
    fn without_points_what_is_far_away_has_no_parallax() {
        let made =
            EpipolarGeometry::new([&view("a", [0.0; 3], [0.0; 3], 1000.0), &view("b", [0.0; 3], [1.0, 0.0, 0.0], 1000.0)], &[]).unwrap();
        assert_eq!((made.parallaxes, made.principal_points_px[0]), (None, made.principal_points_px[1]));
    }
}
