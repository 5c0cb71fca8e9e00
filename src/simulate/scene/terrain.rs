//! The relief of the ground: a smooth surface of known height everywhere.

use super::super::buckets::Rectangle;
use super::super::photo::Ray;
use super::super::random::Random;
use nalgebra::{Matrix3, Vector3};

/// Distance of the surface's control heights in m.
const SPACING_M: f64 = 90.0;

/// Newton's method converges quadratically: after a step of a centimetre less than a micrometre is left.
const LAST_STEP_M: f64 = 1e-2;
const MAX_STEPS: usize = 12;

/// A tensor-product quadratic B-spline: continuous slopes, heights within those of its control points.
pub(super) struct Terrain {
    origin: [f64; 2],
    cols: usize,
    rows: usize,
    /// Of each cell, the polynomial whose coefficient (i, j) belongs to the i-th power of y and the j-th of x.
    cells: Vec<Matrix3<f64>>,
}

/// A point of the ground with its tangent plane.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Ground {
    pub(super) point: Vector3<f64>,
    /// The unit normal, upwards.
    pub(super) normal: Vector3<f64>,
}

impl Ground {
    /// The depth at which a falling ray meets the tangent plane.
    pub(super) fn meet(&self, ray: &Ray) -> f64 {
        self.normal.dot(&(self.point - ray.origin)) / self.normal.dot(&ray.direction)
    }
}

impl Terrain {
    /// Heights within ± half of `relief_m` over `area`.
    pub(super) fn new(area: Rectangle, relief_m: f64, random: &mut Random) -> Self {
        let count = |low: f64, high: f64| ((high - low) / SPACING_M).ceil() as usize;
        let (cols, rows) = (count(area[0], area[2]), count(area[1], area[3]));
        let heights: Vec<f64> = (0..(cols + 2) * (rows + 2)).map(|_| relief_m * (random.uniform() - 0.5)).collect();
        let polynomial = |cell: usize| {
            let corner = (cell / cols) * (cols + 2) + cell % cols;
            SPLINE * Matrix3::from_fn(|i, j| heights[corner + i * (cols + 2) + j]) * SPLINE.transpose()
        };
        Self { origin: [area[0], area[1]], cols, rows, cells: (0..cols * rows).map(polynomial).collect() }
    }

    /// The ground at a place. Outside the area the border's surface is continued.
    pub(super) fn at(&self, x: f64, y: f64) -> Ground {
        let (col, s) = cell((x - self.origin[0]) / SPACING_M, self.cols);
        let (row, t) = cell((y - self.origin[1]) / SPACING_M, self.rows);
        let c = &self.cells[row * self.cols + col];
        let line = |i: usize| c[(i, 0)] + s * (c[(i, 1)] + s * c[(i, 2)]);
        let slope = |i: usize| c[(i, 1)] + 2.0 * s * c[(i, 2)];
        let (linear, square) = (line(1), line(2));
        let height = line(0) + t * (linear + t * square);
        let (along_s, along_t) = (slope(0) + t * (slope(1) + t * slope(2)), linear + 2.0 * t * square);
        Ground { point: Vector3::new(x, y, height), normal: Vector3::new(-along_s, -along_t, SPACING_M).normalize() }
    }

    /// Where a falling ray meets the ground.
    pub(super) fn meet(&self, ray: &Ray) -> Ground {
        let mut t = -ray.origin.z / ray.direction.z;
        for _ in 0..MAX_STEPS {
            let foot = ray.at(t);
            let tangent = self.at(foot.x, foot.y);
            let step = tangent.meet(ray) - t;
            t += step;
            if step.abs() < LAST_STEP_M {
                return Ground { point: ray.at(t), ..tangent };
            }
        }
        let foot = ray.at(t);
        self.at(foot.x, foot.y)
    }
}

/// Powers of the place in a cell (rows) from three control values (columns).
const SPLINE: Matrix3<f64> = Matrix3::new(0.5, 0.5, 0.0, -1.0, 1.0, 0.0, 0.5, -1.0, 0.5);

/// The cell of a coordinate in units of cells, and the place in it.
fn cell(place: f64, count: usize) -> (usize, f64) {
    let index = (place.max(0.0) as usize).min(count - 1);
    (index, place - index as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulate::random::Stream;

    fn hills() -> Terrain {
        Terrain::new([-300.0, -200.0, 300.0, 200.0], 60.0, &mut Random::new(5, Stream::Relief))
    }

    #[test]
    fn a_ray_ends_on_the_ground() {
        for k in 0..500 {
            let direction = Vector3::new(f64::from(k % 21) * 0.06 - 0.6, f64::from(k % 17) * 0.06 - 0.5, -1.0);
            let ray = Ray { origin: Vector3::new(20.0, -10.0, 400.0), direction };
            let end = hills().meet(&ray).point;
            assert!((end.z - hills().at(end.x, end.y).point.z).abs() < 1e-6, "{end} is off the ground");
            assert!((end - ray.origin).cross(&direction).norm() < 1e-9, "{end} is off the ray");
        }
    }

    #[test]
    fn the_surface_is_smooth_and_within_its_range() {
        let terrain = hills();
        let mut range: f64 = 0.0;
        for k in 0..3000 {
            let (x, y, h) = (f64::from(k % 60) * 9.7 - 290.0, f64::from(k / 60) * 7.9 - 195.0, 1e-4);
            let ground = terrain.at(x, y);
            range = range.max(ground.point.z.abs());
            for (dx, dy) in [(h, 0.0), (0.0, h)] {
                let along = terrain.at(x + dx, y + dy).point - terrain.at(x - dx, y - dy).point;
                assert!(along.dot(&ground.normal).abs() < 1e-8, "slope and normal disagree at {x} {y}");
            }
        }
        assert!(range > 10.0 && range <= 30.0, "heights up to {range} m");
    }
}
