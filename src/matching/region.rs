//! Where the right point of a left one is looked for: a window about the expected position and, once the pair is oriented, a strip
//! along the epipolar line.

use super::{NearestTable, OffsetField};
use crate::camera::{Interior, rotation_from_angles};
use nalgebra::{Matrix3, Vector3};

/// The epipolar lines of an oriented pair.
#[derive(Debug, Clone, PartialEq)]
pub struct EpipolarLines {
    left: Interior,
    right: Interior,
    focal_mm: f64,
    /// E = M [b]×: the line in the right photo of the left ray q is E·q.
    essential: Matrix3<f64>,
    tolerance_px: f64,
}

impl EpipolarLines {
    /// From a dependent relative orientation: angles in radians, base `[b, by, bz]` in mm. Right points up to `tolerance_px` from their line
    /// are candidates.
    pub fn new([left, right]: [Interior; 2], focal_mm: f64, [omega, phi, kappa]: [f64; 3], base_mm: [f64; 3], tolerance_px: f64) -> Self {
        let essential = rotation_from_angles(omega, phi, kappa) * Vector3::from(base_mm).cross_matrix();
        Self { left, right, focal_mm, essential, tolerance_px }
    }

    /// The line of a left position in px, as it runs near `near` in the right image. `None` at the epipole.
    fn strip(&self, x_px: f64, y_px: f64, near: [f64; 2]) -> Option<Strip> {
        let [x, y] = self.left.photo_mm(x_px, y_px);
        let line = self.essential * Vector3::new(x, y, -self.focal_mm);
        let at = |x_px: f64, y_px: f64| {
            let [x, y] = self.right.photo_mm(x_px, y_px);
            line.dot(&Vector3::new(x, y, -self.focal_mm))
        };
        let here = at(near[0], near[1]);
        // Distortion bends the line by far less than the tolerance over a search window.
        let slope = [at(near[0] + 1.0, near[1]) - here, at(near[0], near[1] + 1.0) - here];
        let length = (slope[0] * slope[0] + slope[1] * slope[1]).sqrt();
        (length > 0.0).then(|| Strip {
            normal: slope.map(|v| v / length),
            distance: (here - slope[0] * near[0] - slope[1] * near[1]) / length,
            tolerance: self.tolerance_px,
        })
    }
}

/// A strip along a line: positions p with |normal · p + distance| up to the tolerance, in px.
#[derive(Debug, Clone, Copy)]
struct Strip {
    normal: [f64; 2],
    distance: f64,
    tolerance: f64,
}

/// What is known of where right points lie.
#[derive(Debug, Clone, Copy)]
pub struct Expectation<'a> {
    pub offset: &'a OffsetField,
    pub lines: Option<&'a EpipolarLines>,
    /// The nearest gradient descriptors of all left points, where they were found before; else they are found.
    pub nearest: Option<&'a NearestTable>,
}

impl<'a> From<&'a OffsetField> for Expectation<'a> {
    fn from(offset: &'a OffsetField) -> Self {
        Self { offset, lines: None, nearest: None }
    }
}

impl Expectation<'_> {
    /// Where the right point of the left position is looked for, up to `reach` px from the expected one in x and y.
    pub(super) fn region(&self, x_px: f64, y_px: f64, reach: usize) -> Region {
        let [dx, dy] = self.offset.at(x_px, y_px);
        let centre = [x_px + dx, y_px + dy];
        Region { centre, reach, strip: self.lines.and_then(|lines| lines.strip(x_px, y_px, centre)) }
    }
}

/// The part of the right image that is searched for one left point.
#[derive(Debug, Clone, Copy)]
pub(super) struct Region {
    /// The expected position in px.
    pub centre: [f64; 2],
    /// Half the side of the window in px.
    pub reach: usize,
    strip: Option<Strip>,
}

impl Region {
    /// Whether a position of the window lies near enough to the epipolar line.
    pub fn allows(&self, x: f64, y: f64) -> bool {
        self.strip.is_none_or(|s| (s.normal[0] * x + s.normal[1] * y + s.distance).abs() <= s.tolerance)
    }

    /// Whether an epipolar line narrows the window.
    pub fn is_strip(&self) -> bool {
        self.strip.is_some()
    }

    /// The same with a strip that is wider by `margin` px to each side.
    pub fn widened(self, margin: f64) -> Self {
        Self { strip: self.strip.map(|strip| Strip { tolerance: strip.tolerance + margin, ..strip }), ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::CameraMm;

    fn interior() -> Interior {
        let camera = CameraMm {
            principal_point_mm: [0.02, -0.05],
            radial_distortion: [1e-8, 0.0, 0.0],
            ..CameraMm::without_distortion(150.0, Some(0.1))
        };
        Interior::from_pixel_size(&camera, 800, 600).unwrap()
    }

    /// The right position of what a left position sees at a depth, by projection.
    fn seen(angles: [f64; 3], base: [f64; 3], x: f64, y: f64, depth: f64) -> [f64; 2] {
        let interior = interior();
        let [x, y] = interior.photo_mm(x, y);
        let point = Vector3::new(x, y, -150.0) * (depth / 150.0);
        let seen = rotation_from_angles(angles[0], angles[1], angles[2]) * (point - Vector3::from(base));
        let wanted = [-150.0 * seen.x / seen.z, -150.0 * seen.y / seen.z];
        // Invert the distortion by iteration.
        let mut p = [400.0, 300.0];
        for _ in 0..50 {
            let [u, v] = interior.photo_mm(p[0], p[1]);
            p = [p[0] + (wanted[0] - u) / 0.1, p[1] - (wanted[1] - v) / 0.1];
        }
        p
    }

    #[test]
    fn what_a_left_point_sees_lies_in_the_strip_at_any_depth() {
        let (angles, base) = ([0.01, -0.02, 0.03], [92.0, -3.0, 1.5]);
        let lines = EpipolarLines::new([interior(), interior()], 150.0, angles, base, 0.5);
        for depth in [900.0, 1000.0, 1100.0] {
            let right = seen(angles, base, 500.0, 250.0, depth);
            let offset = OffsetField::constant(right[0] - 503.0, right[1] - 251.0);
            let region = Expectation { lines: Some(&lines), ..Expectation::from(&offset) }.region(500.0, 250.0, 12);
            assert!(region.allows(right[0], right[1]), "depth {depth}");
            assert!(!region.allows(right[0], right[1] + 0.7) && !region.allows(right[0], right[1] - 0.7));
            assert!(region.widened(0.5).allows(right[0], right[1] + 0.7));
        }
    }

    #[test]
    fn without_lines_the_whole_window_is_searched() {
        let offset = OffsetField::constant(3.0, -1.0);
        let region = Expectation::from(&offset).region(400.0, 300.0, 12);
        assert!(region.allows(0.0, 0.0) && !region.is_strip());
        assert_eq!(region.centre, [403.0, 299.0]);
    }
}
