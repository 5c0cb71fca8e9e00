//! Buildings: upright prisms with a flat or a gabled roof.

use super::super::photo::Ray;
use super::axes::Axes;
use super::span::{Box3, Span};
use nalgebra::Vector3;

/// A face of a building, as the half-spaces of [`Building::span`] number them.
pub(super) type Face = usize;

/// First of the two faces that are the roof; the walls come before.
pub(super) const ROOF: Face = 4;

/// A building. Its local system has the ridge along u and its origin in the middle of the ground plan.
#[derive(Debug, Clone)]
pub(super) struct Building {
    pub(super) axes: Axes,
    /// Half the sides of the ground plan in m, along u and v.
    pub(super) half_m: [f64; 2],
    /// Height of the ground it stands on, in m.
    pub(super) base_m: f64,
    /// Height of the eaves, in m.
    pub(super) eaves_m: f64,
    /// Rise of the roof from the eaves to the ridge per m; 0 makes it flat.
    pub(super) pitch: f64,
    /// Greys of roof and walls in full sun.
    pub(super) roof_tone: f64,
    pub(super) wall_tone: f64,
    pub(super) seed: u32,
}

impl Building {
    pub(super) fn ridge_m(&self) -> f64 {
        self.eaves_m + self.pitch * self.half_m[1]
    }

    /// The part of a ray inside the building, which has no floor: rays come from above or leave upwards.
    pub(super) fn span(&self, ray: &Ray) -> Option<Span> {
        let [ou, ov] = self.axes.to_local(ray.origin.x, ray.origin.y);
        let [du, dv] = self.axes.turn(ray.direction.x, ray.direction.y);
        let (oz, dz, ridge) = (ray.origin.z, ray.direction.z, self.ridge_m());
        let [hu, hv] = self.half_m;
        let half_spaces = [
            (ou - hu, du),
            (-ou - hu, -du),
            (ov - hv, dv),
            (-ov - hv, -dv),
            (oz + self.pitch * ov - ridge, dz + self.pitch * dv),
            (oz - self.pitch * ov - ridge, dz - self.pitch * dv),
        ];
        Span::inside(&half_spaces)
    }

    /// The outward normal of a face.
    pub(super) fn normal(&self, face: Face) -> Vector3<f64> {
        let slope = 1.0 / (1.0 + self.pitch * self.pitch).sqrt();
        let (u, v, z) = match face {
            0 => (1.0, 0.0, 0.0),
            1 => (-1.0, 0.0, 0.0),
            2 => (0.0, 1.0, 0.0),
            3 => (0.0, -1.0, 0.0),
            ROOF => (0.0, self.pitch * slope, slope),
            _ => (0.0, -self.pitch * slope, slope),
        };
        let [x, y] = self.axes.turn_back(u, v);
        Vector3::new(x, y, z)
    }

    /// The box around it, from `floor_m` up.
    pub(super) fn bounds(&self, floor_m: f64) -> Box3 {
        let [hu, hv] = self.half_m;
        let (c, s) = (self.axes.cos.abs(), self.axes.sin.abs());
        let (rx, ry) = (c * hu + s * hv, s * hu + c * hv);
        let [x, y] = self.axes.origin;
        Box3 { low: Vector3::new(x - rx, y - ry, floor_m), high: Vector3::new(x + rx, y + ry, self.ridge_m()) }
    }
}

#[cfg(test)]
impl Building {
    /// Whether a point lies between the walls and below the roof.
    pub(super) fn contains(&self, point: Vector3<f64>) -> bool {
        let [u, v] = self.axes.to_local(point.x, point.y);
        let roof_m = self.eaves_m + self.pitch * (self.half_m[1] - v.abs());
        u.abs() < self.half_m[0] && v.abs() < self.half_m[1] && point.z < roof_m
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn house() -> Building {
        Building {
            axes: Axes::new([10.0, -4.0], 0.3),
            half_m: [6.0, 4.0],
            base_m: 1.0,
            eaves_m: 5.0,
            pitch: 0.5,
            roof_tone: 100.0,
            wall_tone: 150.0,
            seed: 1,
        }
    }

    /// From a point of the local system straight into the face whose outward normal is given.
    fn enter(normal: Vector3<f64>, u: f64, v: f64, z: f64) -> Span {
        let [x, y] = house().axes.to_ground(u, v);
        house().span(&Ray { origin: Vector3::new(x, y, z) + normal * 20.0, direction: -normal }).unwrap()
    }

    #[test]
    fn each_face_is_entered_against_its_normal() {
        let inner = [(6.0, 0.0, 3.0), (-6.0, 0.0, 3.0), (0.0, 4.0, 3.0), (0.0, -4.0, 3.0), (0.0, 2.0, 6.0), (0.0, -2.0, 6.0)];
        for (face, (u, v, z)) in inner.into_iter().enumerate() {
            let normal = house().normal(face);
            let span = enter(normal, u, v, z);
            assert!((normal.norm() - 1.0).abs() < 1e-15);
            assert_eq!(span.face, face);
            assert!((span.enter - 20.0).abs() < 1e-12, "face {face} is met after {}", span.enter);
        }
    }

    #[test]
    fn the_ridge_is_the_highest_line() {
        assert_eq!(house().ridge_m(), 7.0);
        assert!((enter(Vector3::z(), 3.0, 0.0, 7.0).enter - 20.0).abs() < 1e-12);
    }
}
