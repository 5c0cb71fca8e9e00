//! Cofactors of the adjusted unknowns: the inverse of the normal equations where it is needed, in the datum that was asked for.

use super::datum::{Freedoms, Seven};
use super::factor3::backward3;
use super::reduced::{Problem, Reduced};
use super::solution::Factored;
use super::sparse::{Block6, Inverse, N, inverse};
use super::state::State;
use crate::camera::Pose;

/// Cofactors of images and cameras: the inverse at the places of the factor, with what the cameras add.
pub(super) struct Orientations {
    images: Inverse,
    /// Cofactors of images (six numbers a place) with each camera column.
    across: Vec<Vec<f64>>,
    /// Of the camera columns, row by row.
    pub cameras: Vec<f64>,
}

/// Cofactors of everything: those of images and cameras, of the same rays or of nearly the same, and what the points follow by.
pub(super) struct Cofactors<'a> {
    pub problem: &'a Problem<'a>,
    pub reduced: &'a Reduced,
    pub orientations: &'a Orientations,
}

/// A symmetric matrix of the coordinates of a point.
pub(super) type Matrix3 = [[f64; 3]; 3];

/// What a point's rays have in common: T = Q Z of its images and cameras, and I + ZᵀQZ.
pub(super) struct PointCofactors {
    /// For each sight T, column by column.
    pub of_sights: Vec<[f64; 18]>,
    /// For each camera column T; zero columns are those of cameras that do not see the point, too.
    pub of_columns: Vec<[f64; 3]>,
    pub middle: Matrix3,
}

impl Orientations {
    pub fn new(problem: &Problem<'_>, factored: &Factored) -> Self {
        let pattern = &problem.network.pattern;
        let mut images = inverse(pattern, &factored.images);
        let cameras = factored.cameras.inverse();
        let q = problem.columns.number();
        // U = S⁻¹ of the border; with the cameras' cofactors Q the images gain U Q Uᵀ and share -U Q with the cameras.
        let mut from = factored.border.clone();
        from.iter_mut().for_each(|column| factored.images.backward(pattern, column));
        let across: Vec<Vec<f64>> = (0..q)
            .map(|k| {
                let mut column = vec![0.0; pattern.size() * N];
                for (l, own) in from.iter().enumerate() {
                    let factor = cameras[l * q + k];
                    column.iter_mut().zip(own).for_each(|(sum, u)| *sum -= u * factor);
                }
                column
            })
            .collect();
        let add = |block: &mut Block6, row: usize, column: usize| {
            for (u, minus_uq) in from.iter().zip(&across) {
                let (left, right) = (&minus_uq[row * N..][..N], &u[column * N..][..N]);
                for c in 0..N {
                    for r in 0..N {
                        block[c * N + r] -= left[r] * right[c];
                    }
                }
            }
        };
        for column in 0..pattern.size() {
            add(&mut images.0.diagonal[column], column, column);
            for at in pattern.start[column]..pattern.start[column + 1] {
                add(&mut images.0.below[at], pattern.rows[at] as usize, column);
            }
        }
        Self { images, across, cameras }
    }
}

impl Cofactors<'_> {
    /// Cofactors of the six unknowns of two images that see a common point, the rows those of the first; zero where they see none.
    pub fn of_images(&self, first: usize, second: usize) -> Block6 {
        self.orientations.images.block(&self.problem.network.pattern, first, second).unwrap_or([0.0; N * N])
    }

    /// Cofactors of the six unknowns of an image with a camera column.
    pub fn across(&self, image: usize, column: usize) -> &[f64] {
        &self.orientations.across[column][self.problem.network.pattern.place[image] as usize * N..][..N]
    }

    /// Cofactors of X, Y, Z of the antenna of an image, of whose six unknowns `own` are those.
    pub fn of_antenna(&self, image: usize, own: &Block6, state: &State) -> [f64; 3] {
        let systematic = self.problem.systematic;
        if systematic.is_empty() {
            return [3, 4, 5].map(|k| own[k * N + k]);
        }
        let (turns, q) = (systematic.by_turns(state, image), self.problem.columns.number());
        let columns = systematic.by_columns(self.problem.columns, state, image);
        [0, 1, 2].map(|k| {
            let mut row = [turns[k][0], turns[k][1], turns[k][2], 0.0, 0.0, 0.0];
            row[3 + k] = 1.0;
            let mut cofactor: f64 = (0..N * N).map(|at| row[at % N] * own[at] * row[at / N]).sum();
            for (column, slope) in &columns {
                cofactor += 2.0 * slope[k] * self.across(image, *column).iter().zip(&row).map(|(q, a)| q * a).sum::<f64>();
                let with = columns.iter().map(|(other, second)| second[k] * self.orientations.cameras[column * q + other]);
                cofactor += slope[k] * with.sum::<f64>();
            }
            cofactor
        })
    }

    /// The camera columns that a point touches, with Z.
    fn camera_shares(&self, point: usize) -> &[(u32, [f64; 3])] {
        &self.reduced.camera_shares[self.reduced.camera_start[point]..self.reduced.camera_start[point + 1]]
    }

    /// `None` for a point without rays, or not determined by them.
    pub fn of_point(&self, point: usize) -> Option<PointCofactors> {
        if self.reduced.points[point].factor[0] == 0.0 {
            return None;
        }
        // No ray sees the columns behind those of cameras.
        let (network, q) = (self.problem.network, self.problem.columns.number());
        let of_cameras = self.problem.columns.parameter.len();
        let first = network.point_start[point];
        let sights = network.of_point(point);
        let shares = &self.reduced.shares[first..first + sights.len()];
        let mut of_sights = vec![[0.0; 18]; sights.len()];
        let mut of_columns = vec![[0.0; 3]; of_cameras];
        for (i, sight) in sights.iter().enumerate() {
            let image = sight.image as usize;
            for (j, other) in sights.iter().enumerate().skip(i) {
                let block = self.of_images(image, other.image as usize);
                add_product(&mut of_sights[i], &block, &shares[j]);
                if j > i {
                    add_transposed_product(&mut of_sights[j], &block, &shares[i]);
                }
            }
            for (column, share) in self.camera_shares(point) {
                let across = self.across(image, *column as usize);
                (0..18).for_each(|k| of_sights[i][k] += across[k % N] * share[k / N]);
            }
            for (column, sum) in of_columns.iter_mut().enumerate() {
                let across = self.across(image, column);
                (0..18).for_each(|k| sum[k / N] += across[k % N] * shares[i][k]);
            }
        }
        for (column, share) in self.camera_shares(point) {
            for (row, sum) in of_columns.iter_mut().enumerate() {
                (0..3).for_each(|k| sum[k] += self.orientations.cameras[row * q + *column as usize] * share[k]);
            }
        }
        let mut middle = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for (share, t) in shares.iter().zip(&of_sights) {
            for k in 0..9 {
                middle[k / 3][k % 3] += (0..N).map(|r| share[(k / 3) * N + r] * t[(k % 3) * N + r]).sum::<f64>();
            }
        }
        for (column, share) in self.camera_shares(point) {
            (0..9).for_each(|k| middle[k / 3][k % 3] += share[k / 3] * of_columns[*column as usize][k % 3]);
        }
        Some(PointCofactors { of_sights, of_columns, middle })
    }

    /// T = Q Z of an image that has no part in a point, with those that have. `None` where the inverse lacks what they have in common.
    pub fn of_outsider(&self, point: usize, image: usize) -> Option<[f64; 18]> {
        let network = self.problem.network;
        let first = network.point_start[point];
        let mut of_image = [0.0; 18];
        for (k, sight) in network.of_point(point).iter().enumerate() {
            let block = self.orientations.images.block(&network.pattern, image, sight.image as usize)?;
            add_product(&mut of_image, &block, &self.reduced.shares[first + k]);
        }
        for (column, share) in self.camera_shares(point) {
            let across = self.across(image, *column as usize);
            (0..18).for_each(|k| of_image[k] += across[k % N] * share[k / N]);
        }
        Some(of_image)
    }

    /// Cofactors of the coordinates of a point: L⁻ᵀ (I + ZᵀQZ) L⁻¹.
    pub fn of_coordinates(&self, point: usize, common: &PointCofactors) -> Matrix3 {
        let factor = &self.reduced.points[point].factor;
        let half = [0, 1, 2].map(|row| backward3(factor, common.middle[row]));
        // Rows of `half` are of the middle, columns already of the coordinates.
        let columns = [0, 1, 2].map(|c| backward3(factor, [half[0][c], half[1][c], half[2][c]]));
        [0, 1, 2].map(|r| [0, 1, 2].map(|c| 0.5 * (columns[c][r] + columns[r][c])))
    }
}

/// t += q z.
fn add_product(t: &mut [f64; 18], q: &Block6, z: &[f64; 18]) {
    for c in 0..3 {
        for p in 0..N {
            let factor = z[c * N + p];
            (0..N).for_each(|r| t[c * N + r] += q[p * N + r] * factor);
        }
    }
}

/// t += qᵀ z.
fn add_transposed_product(t: &mut [f64; 18], q: &Block6, z: &[f64; 18]) {
    for c in 0..3 {
        for r in 0..N {
            t[c * N + r] += (0..N).map(|p| q[r * N + p] * z[c * N + p]).sum::<f64>();
        }
    }
}

/// Takes cofactors into the datum of the inner constraints.
///
/// With S = I - G (GᵀEG)⁻¹ GᵀE, H = Q E G and P = (GᵀEG)⁻¹: S Q Sᵀ = Q - G P Hᵀ - H P Gᵀ + G P GᵀEH P Gᵀ, block by block.
///
/// # Source
/// Baarda 1973, S-transformations and criterion matrices.
pub(super) struct Inner<'a> {
    freedoms: Freedoms,
    /// H of images by places, of camera columns, one of each for a freedom.
    images: Vec<Vec<f64>>,
    cameras: Vec<Vec<f64>>,
    /// P GᵀEH P.
    middle: [Seven; 7],
    problem: &'a Problem<'a>,
    reduced: &'a Reduced,
}

impl<'a> Inner<'a> {
    pub fn new(problem: &'a Problem<'a>, reduced: &'a Reduced, factored: &Factored, freedoms: Freedoms, state: &State) -> Self {
        let pattern = &problem.network.pattern;
        let g: Vec<[Seven; N]> = state.images.iter().map(|pose| freedoms.of_image(pose)).collect();
        let weights = freedoms.weights();
        let (mut images, mut cameras) = (Vec::new(), Vec::new());
        for freedom in 0..7 {
            let mut column = vec![0.0; pattern.size() * N];
            for (rows, place) in g.iter().zip(&pattern.place) {
                (0..N).for_each(|k| column[*place as usize * N + k] = weights[k] * rows[k][freedom]);
            }
            let mut corner = vec![0.0; problem.columns.number()];
            factored.solve(pattern, &mut column, &mut corner);
            images.push(column);
            cameras.push(corner);
        }
        let mut geh = [[0.0; 7]; 7];
        for (rows, place) in g.iter().zip(&pattern.place) {
            for k in 0..N {
                for b in 0..7 {
                    let h = weights[k] * images[b][*place as usize * N + k];
                    (0..7).for_each(|a| geh[a][b] += rows[k][a] * h);
                }
            }
        }
        let p = &freedoms.inverse;
        let middle = times(&times(p, &geh), p);
        Self { freedoms, images, cameras, middle, problem, reduced }
    }

    /// Takes the cofactors of an image into the datum.
    pub fn of_image(&self, image: usize, pose: &Pose, q: &Block6) -> Block6 {
        let place = self.problem.network.pattern.place[image] as usize;
        let h: [Seven; N] = std::array::from_fn(|k| std::array::from_fn(|b| self.images[b][place * N + k]));
        let g = self.freedoms.of_image(pose);
        std::array::from_fn(|k| self.entry(q[k], (&g[k % N], &h[k % N]), (&g[k / N], &h[k / N])))
    }

    /// Takes the cofactors of a point into the datum.
    pub fn of_point(&self, point: usize, at: &[f64; 3], q: &Matrix3) -> Matrix3 {
        let columns: [[f64; 3]; 7] =
            std::array::from_fn(|b| self.reduced.back_substitute(self.problem, point, [0.0; 3], &self.images[b], &self.cameras[b]));
        let h: [Seven; 3] = std::array::from_fn(|k| std::array::from_fn(|b| columns[b][k]));
        let g = self.freedoms.of_point(at);
        [0, 1, 2].map(|r| [0, 1, 2].map(|c| self.entry(q[r][c], (&g[r], &h[r]), (&g[c], &h[c]))))
    }

    fn entry(&self, q: f64, (g, h): (&Seven, &Seven), (other_g, other_h): (&Seven, &Seven)) -> f64 {
        let p = &self.freedoms.inverse;
        q - form(g, p, other_h) - form(h, p, other_g) + form(g, &self.middle, other_g)
    }
}

fn times(a: &[Seven; 7], b: &[Seven; 7]) -> [Seven; 7] {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..7).map(|k| a[i][k] * b[k][j]).sum()))
}

/// aᵀ M b.
fn form(a: &Seven, m: &[Seven; 7], b: &Seven) -> f64 {
    let row = |row: &Seven| row.iter().zip(b).map(|(m, b)| m * b).sum::<f64>();
    a.iter().zip(m).map(|(a, m)| a * row(m)).sum()
}

/// Standard errors of ω, φ, κ in degrees and of the position, for the standard error `sigma` of a ray. The angles are absent at φ = ±90°.
pub(crate) fn image_errors(pose: &Pose, q: &Block6, sigma: f64) -> (Option<[f64; 3]>, [f64; 3]) {
    let turns = nalgebra::Matrix3::from_fn(|r, c| q[c * N + r]);
    let angles = angles_by_turns(pose).map(|by_turns| {
        let angles = by_turns * turns * by_turns.transpose();
        [0, 1, 2].map(|k| (sigma * angles[(k, k)].max(0.0).sqrt()).to_degrees())
    });
    (angles, [3, 4, 5].map(|k| sigma * q[k * N + k].max(0.0).sqrt()))
}

/// How ω, φ, κ follow small turns about the photo's axes; `None` where φ is ±90°.
pub(super) fn angles_by_turns(pose: &Pose) -> Option<nalgebra::Matrix3<f64>> {
    let m = &pose.rotation;
    let cosine = (m[0][0] * m[0][0] + m[1][0] * m[1][0]).sqrt();
    // A small turn is minus Σ of angle · axis, the axes in the photo's system being M e₁, M₃ e₂, e₃.
    let (sin, cos) = (-m[1][0] / cosine, m[0][0] / cosine);
    let axes = nalgebra::Matrix3::new(m[0][0], sin, 0.0, m[1][0], cos, 0.0, m[2][0], 0.0, 1.0);
    (cosine > LEAST_COSINE).then(|| axes.try_inverse()).flatten().map(|inverse| -inverse)
}

/// Least cosine of φ; below it ω and κ turn about the same axis.
const LEAST_COSINE: f64 = 1e-4;
