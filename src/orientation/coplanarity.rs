//! The condition that two rays and the base lie in a plane, with its derivatives.
//!
//! Symbols: a ray is q = (x/f, y/f, -1) in its photo's system, M turns model space (the left photo's system) into the right photo's system,
//! t is the unit vector along the base. The condition is g = t · (q₁ × Mᵀq₂) = 0, or q₂ᵀ E q₁ = 0 with E = M [t]×.

use nalgebra::{Matrix3, SVector, Vector3};

/// Observed or adjusted coordinates of one point: x and y in the left photo, x and y in the right photo, divided by the focal length.
pub(crate) type Ray = [f64; 4];

/// One number for each unknown: three small turns of the right photo, two small shifts of the base's direction.
pub(super) type Unknowns = SVector<f64, 5>;

/// The relative orientation without its scale.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RelativePose {
    /// M: from model space to the right photo.
    pub rotation: Matrix3<f64>,
    /// t: the direction of the base in model space, of length 1.
    pub base: Vector3<f64>,
}

/// Adjusted coordinates change by no more than this where they fulfil the condition; after so many steps they are left as they are.
pub(super) const LEAST_CHANGE: f64 = 1e-15;
pub(super) const MOST_STEPS: usize = 20;

/// The condition of one point, linearised at its adjusted coordinates and scaled so that a misclosure is a distance.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Linearised {
    /// Derivatives by the unknowns.
    pub by_unknowns: Unknowns,
    /// Derivatives by the four coordinates: a vector of length 1.
    pub by_coordinates: [f64; 4],
    /// Signed distance of the observed coordinates from the condition.
    pub misclosure: f64,
    /// What the derivatives by the coordinates were divided by.
    pub gradient: f64,
}

/// Left and right direction of a point in their own photos.
fn directions(ray: &Ray) -> (Vector3<f64>, Vector3<f64>) {
    (Vector3::new(ray[0], ray[1], -1.0), Vector3::new(ray[2], ray[3], -1.0))
}

/// The coefficients by which the entries of E, row by row, enter q₂ᵀ E q₁.
pub(crate) fn condition(&[xl, yl, xr, yr]: &Ray) -> [f64; 9] {
    [xr * xl, xr * yl, -xr, yr * xl, yr * yl, -yr, -xl, -yl, 1.0]
}

impl RelativePose {
    /// The start of a vertical pair: no rotation, the base along `parallax` (x, y; in a vertical pair left minus right coordinates point
    /// along the base).
    pub fn vertical(parallax: [f64; 2]) -> Self {
        let base = Vector3::new(parallax[0], parallax[1], 0.0).try_normalize(0.0).unwrap_or_else(Vector3::x);
        Self { rotation: Matrix3::identity(), base }
    }

    /// E = M [t]×.
    pub fn essential(&self) -> Matrix3<f64> {
        self.rotation * self.base.cross_matrix()
    }

    /// The four poses of an essential matrix: two rotations, the base in either direction. `None` where the matrix is none.
    ///
    /// # Source
    /// Horn 1990, Recovering baseline and orientation from essential matrix: (t·t) R = cof(E) - [t]×E for E = [t]×R.
    pub fn from_essential(essential: &Matrix3<f64>) -> Option<[Self; 4]> {
        // -Eᵀ = [t]× Mᵀ; t is at right angles to the columns of it.
        let e = -essential.transpose();
        let (a, b, c) = (e.column(0), e.column(1), e.column(2));
        let normals = [a.cross(&b), b.cross(&c), c.cross(&a)];
        let longest = normals.iter().max_by(|u, v| u.norm_squared().total_cmp(&v.norm_squared()))?;
        let base = longest.try_normalize(f64::MIN_POSITIVE)?;
        let e = e * (std::f64::consts::SQRT_2 / e.norm());
        // The columns of the cofactor matrix are the cross products of the columns.
        let scale = 2.0 / essential.norm_squared();
        let cofactors = Matrix3::from_columns(&[normals[1] * scale, normals[2] * scale, normals[0] * scale]);
        let product = base.cross_matrix() * e;
        let first = orthonormal(&(cofactors - product).transpose());
        let second = orthonormal(&(cofactors + product).transpose());
        let pose = |rotation, base| Self { rotation, base };
        Some([pose(first, base), pose(first, -base), pose(second, base), pose(second, -base)])
    }

    /// Two directions at right angles to the base and to each other, in which it is shifted.
    pub fn tangents(&self) -> [Vector3<f64>; 2] {
        let axis = Vector3::ith(self.base.iamin(), 1.0);
        let first = self.base.cross(&axis).normalize();
        [first, self.base.cross(&first)]
    }

    /// The pose after a step of the unknowns.
    pub fn moved(&self, step: &Unknowns) -> Self {
        let [first, second] = self.tangents();
        let base = (self.base + first * step[3] + second * step[4]).normalize();
        let turn = small_turn(&Vector3::new(step[0], step[1], step[2]));
        Self { rotation: orthonormal(&(self.rotation * turn.transpose())), base }
    }

    /// Linearises the condition of a point at its `adjusted` coordinates. `None` where both rays run along the base: such a point says
    /// nothing.
    pub fn linearise(&self, tangents: &[Vector3<f64>; 2], observed: &Ray, adjusted: &Ray) -> Option<Linearised> {
        let Gradient { by_coordinates, misclosure, gradient, normal, across_left, right_in_model } = self.gradient(observed, adjusted)?;
        let by_rotation = right_in_model.cross(&across_left);
        let by_unknowns = Unknowns::new(
            by_rotation.x / gradient,
            by_rotation.y / gradient,
            by_rotation.z / gradient,
            tangents[0].dot(&normal) / gradient,
            tangents[1].dot(&normal) / gradient,
        );
        Some(Linearised { by_unknowns, by_coordinates, misclosure, gradient })
    }

    /// The condition of a point and its derivatives by the coordinates, at the `adjusted` ones.
    ///
    /// Written out, since it is most of what an orientation takes: of products of matrices and maps of arrays compilers make calls.
    #[inline(always)]
    fn gradient(&self, observed: &Ray, adjusted: &Ray) -> Option<Gradient> {
        let (left, right) = directions(adjusted);
        let right_in_model = self.rotation.tr_mul(&right);
        let normal = left.cross(&right_in_model);
        let across_left = self.base.cross(&left);
        let by_left = right_in_model.cross(&self.base);
        let by_right = |row: usize| {
            let m = &self.rotation;
            m[(row, 0)] * across_left.x + m[(row, 1)] * across_left.y + m[(row, 2)] * across_left.z
        };
        let raw = [by_left.x, by_left.y, by_right(0), by_right(1)];
        let gradient = (raw[0] * raw[0] + raw[1] * raw[1] + raw[2] * raw[2] + raw[3] * raw[3]).sqrt();
        if gradient.is_nan() || gradient <= 1e-12 {
            return None;
        }
        let by_coordinates = [raw[0] / gradient, raw[1] / gradient, raw[2] / gradient, raw[3] / gradient];
        let shift = |k: usize| by_coordinates[k] * (observed[k] - adjusted[k]);
        let misclosure = self.base.dot(&normal) / gradient + (shift(0) + shift(1) + shift(2) + shift(3));
        Some(Gradient { by_coordinates, misclosure, gradient, normal, across_left, right_in_model })
    }

    /// The observed coordinates after one step towards those that fulfil the condition: what is left is of the third order of the distance.
    pub fn nearer(&self, observed: &Ray) -> Ray {
        self.gradient(observed, observed).map_or(*observed, |at| corrected(observed, &at.by_coordinates, at.misclosure))
    }

    /// The coordinates nearest to the observed ones that fulfil the condition, and their signed distance.
    pub fn project(&self, observed: &Ray) -> (Ray, f64) {
        let mut adjusted = *observed;
        let mut distance = 0.0;
        for _ in 0..MOST_STEPS {
            let Some(at) = self.gradient(observed, &adjusted) else {
                break;
            };
            let next = corrected(observed, &at.by_coordinates, at.misclosure);
            let change = (0..4).map(|k| (next[k] - adjusted[k]).abs()).fold(0.0, f64::max);
            (adjusted, distance) = (next, at.misclosure);
            if change <= LEAST_CHANGE {
                break;
            }
        }
        (adjusted, distance)
    }

    /// Whether the point lies in front of both cameras. Rays that meet at less than `least_angle` (radians) meet at infinity for all that
    /// the observations tell, which counts as in front.
    pub fn in_front(&self, ray: &Ray, least_angle: f64) -> bool {
        self.in_front_of_either(ray, least_angle)[0]
    }

    /// The same with this base, and with the opposite one.
    #[inline]
    pub fn in_front_of_either(&self, ray: &Ray, least_angle: f64) -> [bool; 2] {
        let (left, right) = directions(ray);
        let right_in_model = self.rotation.tr_mul(&right);
        let normal = left.cross(&right_in_model);
        // λ q₁ = t + µ Mᵀq₂, multiplied by either ray.
        let along_left = normal.dot(&self.base.cross(&right_in_model));
        let along_right = normal.dot(&self.base.cross(&left));
        let square = normal.norm_squared();
        let is_parallel = square <= least_angle * least_angle * left.norm_squared() * right_in_model.norm_squared();
        [is_parallel || (along_left > 0.0 && along_right > 0.0), is_parallel || (along_left < 0.0 && along_right < 0.0)]
    }

    /// Depth of the point where the rays meet, along the left optical axis in units of the base: positive in front. `None` for parallel rays.
    pub fn depth(&self, ray: &Ray) -> Option<f64> {
        let (left, right) = directions(ray);
        let right_in_model = self.rotation.tr_mul(&right);
        let normal = left.cross(&right_in_model);
        let depth = normal.dot(&self.base.cross(&right_in_model)) / normal.norm_squared();
        depth.is_finite().then_some(depth)
    }

    /// Whether the two rays of a point meet at an angle beyond the one of this tangent, which is above 0.
    pub fn meets_beyond(&self, ray: &Ray, tangent: f64) -> bool {
        let (left, right) = directions(ray);
        let right_in_model = self.rotation.tr_mul(&right);
        let along = tangent * left.dot(&right_in_model);
        along <= 0.0 || left.cross(&right_in_model).norm_squared() > along * along
    }

    /// Angle in radians between the two rays of a point.
    pub fn parallactic_angle(&self, ray: &Ray) -> f64 {
        let (left, right) = directions(ray);
        let right_in_model = self.rotation.tr_mul(&right);
        libm::atan2(left.cross(&right_in_model).norm(), left.dot(&right_in_model))
    }
}

impl Linearised {
    /// The observed coordinates, corrected by a distance along the gradient.
    pub fn adjusted(&self, observed: &Ray, distance: f64) -> Ray {
        corrected(observed, &self.by_coordinates, distance)
    }
}

/// Observed coordinates, corrected by a distance along the derivatives of the condition.
fn corrected(observed: &Ray, by_coordinates: &[f64; 4], distance: f64) -> Ray {
    let along = |k: usize| observed[k] - by_coordinates[k] * distance;
    [along(0), along(1), along(2), along(3)]
}

/// The condition of one point and its derivatives by the coordinates, with the vectors that those by the unknowns come from.
struct Gradient {
    by_coordinates: [f64; 4],
    misclosure: f64,
    gradient: f64,
    normal: Vector3<f64>,
    across_left: Vector3<f64>,
    right_in_model: Vector3<f64>,
}

/// The rotation by a small vector of angles, exact to second order and orthonormal for any: that of the quaternion (1, a/2).
fn small_turn(angles: &Vector3<f64>) -> Matrix3<f64> {
    let half = angles * 0.5;
    let cross = half.cross_matrix();
    Matrix3::identity() + (cross + cross * cross) * (2.0 / (1.0 + half.norm_squared()))
}

/// The rows made orthonormal, the third one's direction from the other two.
fn orthonormal(matrix: &Matrix3<f64>) -> Matrix3<f64> {
    let x = Vector3::new(matrix[(0, 0)], matrix[(0, 1)], matrix[(0, 2)]).normalize();
    let y = Vector3::new(matrix[(1, 0)], matrix[(1, 1)], matrix[(1, 2)]);
    let y = (y - x * x.dot(&y)).normalize();
    let z = x.cross(&y);
    Matrix3::new(x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::rotation_from_angles;

    fn pose() -> RelativePose {
        RelativePose { rotation: rotation_from_angles(0.1, -0.3, 1.2), base: Vector3::new(0.8, 0.3, -0.2).normalize() }
    }

    const RAY: Ray = [0.3, -0.2, 0.15, 0.4];

    fn misclosure(pose: &RelativePose, ray: &Ray) -> f64 {
        let (left, right) = directions(ray);
        right.dot(&(pose.essential() * left))
    }

    #[test]
    fn derivatives_are_those_of_small_differences() {
        let pose = pose();
        let line = pose.linearise(&pose.tangents(), &RAY, &RAY).unwrap();
        assert!((line.misclosure * line.gradient - misclosure(&pose, &RAY)).abs() < 1e-15);
        let h = 1e-6;
        for k in 0..5 {
            let step = |sign: f64| pose.moved(&Unknowns::from_fn(|row, _| if row == k { sign * h } else { 0.0 }));
            let numeric = (misclosure(&step(1.0), &RAY) - misclosure(&step(-1.0), &RAY)) / (2.0 * h);
            assert!((line.by_unknowns[k] * line.gradient - numeric).abs() < 1e-9, "unknown {k}: {} {numeric}", line.by_unknowns[k]);
        }
        for k in 0..4 {
            let shifted = |sign: f64| std::array::from_fn(|j| if j == k { RAY[j] + sign * h } else { RAY[j] });
            let numeric = (misclosure(&pose, &shifted(1.0)) - misclosure(&pose, &shifted(-1.0))) / (2.0 * h);
            assert!((line.by_coordinates[k] * line.gradient - numeric).abs() < 1e-9, "coordinate {k}");
        }
    }

    #[test]
    fn projected_coordinates_fulfil_the_condition_and_are_the_nearest() {
        let pose = pose();
        let (adjusted, distance) = pose.project(&RAY);
        assert!(misclosure(&pose, &adjusted).abs() < 1e-15);
        let correction: [f64; 4] = std::array::from_fn(|k| adjusted[k] - RAY[k]);
        let length = correction.iter().map(|v| v * v).sum::<f64>().sqrt();
        assert!((length - distance.abs()).abs() < 1e-14);
        // At the nearest point the correction runs along the gradient.
        let there = pose.linearise(&pose.tangents(), &RAY, &adjusted).unwrap();
        let along: f64 = (0..4).map(|k| correction[k] * there.by_coordinates[k]).sum();
        assert!((along.abs() - length).abs() < 1e-12);
    }

    #[test]
    fn an_essential_matrix_gives_its_pose_among_four() {
        for scale in [1.0, -3.0] {
            let poses = RelativePose::from_essential(&(pose().essential() * scale)).unwrap();
            let distance = |p: &RelativePose| (p.rotation - pose().rotation).amax() + (p.base - pose().base).amax();
            assert_eq!(poses.iter().filter(|p| distance(p) < 1e-12).count(), 1);
            assert!(poses.iter().all(|p| (p.rotation.determinant() - 1.0).abs() < 1e-12));
        }
        assert!(RelativePose::from_essential(&Matrix3::zeros()).is_none());
    }

    #[test]
    fn one_pose_of_four_has_the_point_in_front() {
        let right = pose().rotation * (Vector3::new(0.5, 0.4, -3.0) - pose().base);
        let ray = [0.5 / 3.0, 0.4 / 3.0, -right.x / right.z, -right.y / right.z];
        assert!(right.z < 0.0 && pose().in_front(&ray, 0.0));
        let poses = RelativePose::from_essential(&pose().essential()).unwrap();
        assert_eq!(poses.iter().filter(|p| p.in_front(&ray, 0.0)).count(), 1);
    }
}
