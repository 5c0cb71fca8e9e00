//! The condition of two points at once, each with the bits that it has alone.
//!
//! An orientation linearises the conditions of all points a hundred times, and of what that takes most are divisions and roots.

use super::coplanarity::{LEAST_CHANGE, Linearised, MOST_STEPS, Ray, RelativePose, Unknowns};
use crate::math::Two;
use nalgebra::{Matrix3, Vector3};

/// Gradients of conditions between these are those of points that say something, far from overflow. Others are looked at one by one.
const USUAL: [f64; 2] = [1e-12, 1e6];

/// A vector of each of two points.
#[derive(Clone, Copy)]
struct Vectors {
    x: Two,
    y: Two,
    z: Two,
}

impl Vectors {
    #[inline(always)]
    fn splat(vector: &Vector3<f64>) -> Self {
        Self { x: Two::splat(vector.x), y: Two::splat(vector.y), z: Two::splat(vector.z) }
    }

    #[inline(always)]
    fn cross(&self, other: &Self) -> Self {
        Self { x: self.y * other.z - self.z * other.y, y: self.z * other.x - self.x * other.z, z: self.x * other.y - self.y * other.x }
    }

    #[inline(always)]
    fn dot(&self, other: &Self) -> Two {
        self.x * other.x + self.y * other.y + self.z * other.z
    }
}

/// The coordinates of two points.
type Rays = [Two; 4];

#[inline(always)]
fn together([a, b]: [&Ray; 2]) -> Rays {
    [Two::new([a[0], b[0]]), Two::new([a[1], b[1]]), Two::new([a[2], b[2]]), Two::new([a[3], b[3]])]
}

#[inline(always)]
fn apart(rays: &Rays) -> [Ray; 2] {
    let [[a0, b0], [a1, b1], [a2, b2], [a3, b3]] = [rays[0].to_array(), rays[1].to_array(), rays[2].to_array(), rays[3].to_array()];
    [[a0, a1, a2, a3], [b0, b1, b2, b3]]
}

/// A pose, of which each number stands twice.
pub(super) struct PoseOfTwo<'a> {
    pose: &'a RelativePose,
    single_tangents: [Vector3<f64>; 2],
    /// The rows of M.
    rows: [Vectors; 3],
    base: Vectors,
    tangents: [Vectors; 2],
}

/// As `Gradient` of one point.
struct Gradients {
    by_coordinates: Rays,
    misclosure: Two,
    gradient: Two,
    normal: Vectors,
    across_left: Vectors,
    right_in_model: Vectors,
}

impl<'a> PoseOfTwo<'a> {
    pub fn of(pose: &'a RelativePose) -> Self {
        let m: &Matrix3<f64> = &pose.rotation;
        let row = |k: usize| Vectors::splat(&Vector3::new(m[(k, 0)], m[(k, 1)], m[(k, 2)]));
        let single_tangents = pose.tangents();
        Self {
            pose,
            single_tangents,
            rows: [row(0), row(1), row(2)],
            base: Vectors::splat(&pose.base),
            tangents: [Vectors::splat(&single_tangents[0]), Vectors::splat(&single_tangents[1])],
        }
    }

    /// As [`RelativePose::linearise`] of each point.
    #[inline(always)]
    pub fn linearise(&self, observed: [&Ray; 2], adjusted: [&Ray; 2]) -> [Option<Linearised>; 2] {
        let Some(at) = self.gradients(&together(observed), &together(adjusted)) else {
            return [0, 1].map(|k| self.pose.linearise(&self.single_tangents, observed[k], adjusted[k]));
        };
        let by_rotation = at.right_in_model.cross(&at.across_left);
        let [[a, p], [b, q], [c, r]] = [by_rotation.x, by_rotation.y, by_rotation.z].map(|turn| (turn / at.gradient).to_array());
        let [[d, s], [e, t]] = [0, 1].map(|k| (self.tangents[k].dot(&at.normal) / at.gradient).to_array());
        let [first, second] = apart(&at.by_coordinates);
        let ([m, n], [g, h]) = (at.misclosure.to_array(), at.gradient.to_array());
        [
            Some(Linearised { by_unknowns: Unknowns::new(a, b, c, d, e), by_coordinates: first, misclosure: m, gradient: g }),
            Some(Linearised { by_unknowns: Unknowns::new(p, q, r, s, t), by_coordinates: second, misclosure: n, gradient: h }),
        ]
    }

    /// As [`RelativePose::project`] of each point. What has reached its place is taken when it does; the other one goes on.
    #[inline(always)]
    pub fn project(&self, observed: [&Ray; 2]) -> [(Ray, f64); 2] {
        let rays = together(observed);
        let (mut adjusted, mut distance) = (rays, Two::splat(0.0));
        let (mut first, mut second) = (None, None);
        for _ in 0..MOST_STEPS {
            let Some(at) = self.gradients(&rays, &adjusted) else {
                return [self.pose.project(observed[0]), self.pose.project(observed[1])];
            };
            let along = |k: usize| rays[k] - at.by_coordinates[k] * at.misclosure;
            let next = [along(0), along(1), along(2), along(3)];
            let change = |k: usize| (next[k] - adjusted[k]).abs();
            let [one, other] = change(0).max(change(1)).max(change(2).max(change(3))).to_array();
            (adjusted, distance) = (next, at.misclosure);
            if one <= LEAST_CHANGE && first.is_none() {
                first = Some((apart(&adjusted)[0], distance.to_array()[0]));
            }
            if other <= LEAST_CHANGE && second.is_none() {
                second = Some((apart(&adjusted)[1], distance.to_array()[1]));
            }
            if first.is_some() && second.is_some() {
                break;
            }
        }
        let ([one, other], [near, far]) = (apart(&adjusted), distance.to_array());
        [first.unwrap_or((one, near)), second.unwrap_or((other, far))]
    }

    /// `None` where one of the points has an unusual gradient.
    #[inline(always)]
    fn gradients(&self, observed: &Rays, adjusted: &Rays) -> Option<Gradients> {
        let minus = Two::splat(-1.0);
        let (left, right) = (Vectors { x: adjusted[0], y: adjusted[1], z: minus }, Vectors { x: adjusted[2], y: adjusted[3], z: minus });
        let [first, second, third] = &self.rows;
        let right_in_model = Vectors {
            x: first.x * right.x + second.x * right.y + third.x * right.z,
            y: first.y * right.x + second.y * right.y + third.y * right.z,
            z: first.z * right.x + second.z * right.y + third.z * right.z,
        };
        let normal = left.cross(&right_in_model);
        let across_left = self.base.cross(&left);
        let by_left = right_in_model.cross(&self.base);
        let raw = [by_left.x, by_left.y, first.dot(&across_left), second.dot(&across_left)];
        let gradient = (raw[0] * raw[0] + raw[1] * raw[1] + raw[2] * raw[2] + raw[3] * raw[3]).sqrt();
        let [least, most] = USUAL;
        if !gradient.to_array().iter().all(|size| *size > least && *size < most) {
            return None;
        }
        let by_coordinates = [raw[0] / gradient, raw[1] / gradient, raw[2] / gradient, raw[3] / gradient];
        let shift = |k: usize| by_coordinates[k] * (observed[k] - adjusted[k]);
        let misclosure = self.base.dot(&normal) / gradient + (shift(0) + shift(1) + shift(2) + shift(3));
        Some(Gradients { by_coordinates, misclosure, gradient, normal, across_left, right_in_model })
    }
}

/// The conditions of points linearised at their `adjusted` coordinates, in their order: as [`RelativePose::linearise`] of each.
#[inline(always)]
pub(super) fn linearised(pose: &RelativePose, observed: &[Ray], adjusted: &[Ray], take: impl FnMut(usize, Option<Linearised>)) {
    let of_two = PoseOfTwo::of(pose);
    each(observed.len(), |[a, b]| of_two.linearise([&observed[a], &observed[b]], [&adjusted[a], &adjusted[b]]), take);
}

/// The coordinates nearest to the observed ones that fulfil the condition, with their signed distances: as [`RelativePose::project`] of each.
#[inline(always)]
pub(super) fn projected(pose: &RelativePose, observed: &[Ray]) -> (Vec<Ray>, Vec<f64>) {
    let of_two = PoseOfTwo::of(pose);
    let (mut places, mut distances) = (Vec::with_capacity(observed.len() + 1), Vec::with_capacity(observed.len() + 1));
    for two in observed.chunks(2) {
        // The last of an odd number goes with itself.
        let [(first, near), (second, far)] = of_two.project([&two[0], &two[two.len() - 1]]);
        places.extend_from_slice(&[first, second]);
        distances.extend_from_slice(&[near, far]);
    }
    places.truncate(observed.len());
    distances.truncate(observed.len());
    (places, distances)
}

/// So many are computed before the first of them is used: what has just been written in other pieces than it is read in, processors wait for.
const BLOCK: usize = 16;

/// Gives what `of` makes of two at a time, one after the other. The last of an odd number goes with itself.
#[inline(always)]
fn each<T: Copy>(count: usize, of: impl Fn([usize; 2]) -> [T; 2], mut take: impl FnMut(usize, T)) {
    let mut block = Vec::with_capacity(BLOCK);
    for first in (0..count).step_by(BLOCK) {
        let end = count.min(first + BLOCK);
        block.clear();
        (first..end).step_by(2).for_each(|k| block.extend_from_slice(&of([k, (k + 1).min(count - 1)])));
        block.iter().take(end - first).enumerate().for_each(|(k, value)| take(first + k, *value));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::rotation_from_angles;
    #[cfg(target_arch = "wasm32")]
    use wasm_bindgen_test::wasm_bindgen_test;

    /// Points of all kinds: good and wrong ones, one along the base, one beyond what is usual.
    fn rays(pose: &RelativePose) -> Vec<Ray> {
        let step = |k: usize, of: usize| (k * 7919 % of) as f64 / of as f64 - 0.5;
        let mut rays: Vec<Ray> =
            (0..41).map(|k| [step(k, 97), step(k, 89), step(k, 53) * if k % 5 == 0 { 40.0 } else { 1.0 }, step(k, 101)]).collect();
        let along = |v: Vector3<f64>| [-v.x / v.z, -v.y / v.z];
        let [[xl, yl], [xr, yr]] = [along(pose.base), along(pose.rotation * pose.base)];
        rays.insert(6, [xl, yl, xr, yr]);
        rays.insert(9, [3e8, 1.0, -2e7, 5.0]);
        rays
    }

    #[test]
    #[cfg_attr(target_arch = "wasm32", wasm_bindgen_test)]
    fn two_points_have_the_bits_that_each_has_alone() {
        let pose = RelativePose { rotation: rotation_from_angles(0.1, -0.3, 1.2), base: Vector3::new(0.8, 0.3, -0.2).normalize() };
        let rays = rays(&pose);
        let bits = |line: &Option<Linearised>| {
            line.map(|l| {
                l.by_unknowns.iter().chain(&l.by_coordinates).chain([&l.misclosure, &l.gradient]).map(|v| v.to_bits()).collect::<Vec<_>>()
            })
        };
        let (places, distances) = projected(&pose, &rays);
        for number in [rays.len(), rays.len() - 1, 1, 0] {
            let mut taken = 0;
            linearised(&pose, &rays[..number], &places[..number], |k, line| {
                assert_eq!(bits(&line), bits(&pose.linearise(&pose.tangents(), &rays[k], &places[k])), "{k}");
                assert_eq!(k, taken);
                taken += 1;
            });
            assert_eq!(taken, number);
        }
        for (k, ray) in rays.iter().enumerate() {
            let (place, distance) = pose.project(ray);
            assert_eq!((places[k].map(f64::to_bits), distances[k].to_bits()), (place.map(f64::to_bits), distance.to_bits()), "{k}");
        }
    }
}
