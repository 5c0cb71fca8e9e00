//! Interior orientation by fiducial marks.

use crate::error::refuse;
use crate::math::student_limit;
use std::collections::BTreeMap;

use crate::{Cause, Computation, Error, Few, Refusal};
use serde::{Deserialize, Serialize};

/// A fiducial mark: where it was measured and where the calibration has it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Fiducial {
    /// Measured column in px; the centre of the top-left pixel is 0.5.
    pub col: f64,
    /// Measured row in px; the centre of the top-left pixel is 0.5.
    pub row: f64,
    /// Calibrated x in mm, to the right.
    pub x_mm: f64,
    /// Calibrated y in mm, up.
    pub y_mm: f64,
}

/// The transformation from pixels to photo coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum FiducialModel {
    /// Six parameters; at least 3 marks.
    #[default]
    Affine,
    /// Four parameters: shift, rotation, scale, with y turned from down to up; at least 2 marks.
    Similarity,
}

/// The interior orientation that the marks give.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct FiducialOrientation {
    pub model: FiducialModel,
    /// `[[a, b, tx], [d, e, ty]]`: x_mm = a·col + b·row + tx, y_mm = d·col + e·row + ty.
    pub parameters: [[f64; 3]; 2],
    /// Transformed minus calibrated `[x, y]` of each mark in mm.
    pub residuals_mm: Vec<[f64; 2]>,
    /// Standard error of one photo coordinate in mm; absent without redundancy.
    pub sigma0_mm: Option<f64>,
    pub degrees_of_freedom: usize,
    /// Standard errors of `parameters`; absent without redundancy.
    pub standard_errors: Option<[[f64; 3]; 2]>,
    /// Half the widths of their intervals of 95 %, by Student's distribution; absent without redundancy.
    #[serde(default)]
    pub half_widths_95: Option<[[f64; 3]; 2]>,
    /// Covariance of the three parameters of a row, the same for both rows, which are independent; absent without redundancy and for a
    /// similarity, whose rows are not independent.
    pub covariance: Option<[[f64; 3]; 3]>,
}

impl FiducialOrientation {
    /// Root mean square length of the residuals in mm.
    pub fn rmse_mm(&self) -> f64 {
        let squares: f64 = self.residuals_mm.iter().map(|[x, y]| x * x + y * y).sum();
        (squares / self.residuals_mm.len().max(1) as f64).sqrt()
    }
}

impl FiducialModel {
    /// Number of parameters, and the least number of marks.
    fn size(self) -> (usize, usize) {
        match self {
            FiducialModel::Affine => (6, 3),
            FiducialModel::Similarity => (4, 2),
        }
    }
}

/// Finds the transformation from measured to calibrated fiducial marks by least squares: all calibrated coordinates have the same weight.
///
/// Degrees of freedom: 2n - 6 (affine) or 2n - 4 (similarity); without redundancy σ0 and the standard errors are absent. A similarity turns
/// y from down to up, unless the marks fit better without: the scan of a photo that lay face down.
///
/// # Errors
/// [`Error::TooFew`]; [`Error::InvalidInput`] for a coordinate that is no number or absurd and for marks in the same place;
/// [`Error::Degenerate`] for marks on a line.
///
/// # Source
/// Kraus 2007, Photogrammetry: Geometry from Images and Laser Scans, 2nd ed. (interior orientation by fiducial marks).
pub fn orient_fiducials(fiducials: &[Fiducial], model: FiducialModel) -> Result<FiducialOrientation, Error> {
    let (unknowns, needed) = model.size();
    check_marks(fiducials, needed)?;
    let centred = Centred::new(fiducials);
    if model == FiducialModel::Affine {
        check_spread(&centred)?;
    }
    let solution = match model {
        FiducialModel::Affine => centred.affine(),
        FiducialModel::Similarity => centred.best_similarity(),
    };
    let parameters = centred.uncentre(solution.linear);
    let residuals_mm: Vec<_> = centred.marks.iter().map(|mark| mark.residual(&solution.linear)).collect();
    let degrees_of_freedom = 2 * fiducials.len() - unknowns;
    let sum: f64 = residuals_mm.iter().map(|[x, y]| x * x + y * y).sum();
    let sigma0_mm = (degrees_of_freedom > 0).then(|| (sum / degrees_of_freedom as f64).sqrt());
    let cofactors = centred.cofactors(&solution.cofactors);
    let of_row = |sigma: f64| [0, 1, 2].map(|k| sigma * cofactors[k][k].sqrt());
    // In a similarity the second row has the same two coefficients, whose cofactors are equal.
    let standard_errors = sigma0_mm.map(|sigma| [of_row(sigma); 2]);
    let half_widths_95 = standard_errors.map(|rows| rows.map(|row| row.map(|error| error * student_limit(0.05, degrees_of_freedom))));
    let covariance = sigma0_mm.filter(|_| model == FiducialModel::Affine).map(|sigma| cofactors.map(|row| row.map(|q| sigma * sigma * q)));
    Ok(FiducialOrientation { model, parameters, residuals_mm, sigma0_mm, degrees_of_freedom, standard_errors, half_widths_95, covariance })
}

/// A mark relative to the centroids; the centring keeps the normal equations well conditioned and splits off the shifts.
struct CentredMark {
    col: f64,
    row: f64,
    x: f64,
    y: f64,
}

impl CentredMark {
    fn residual(&self, linear: &[[f64; 2]; 2]) -> [f64; 2] {
        let [[a, b], [d, e]] = linear;
        [a * self.col + b * self.row - self.x, d * self.col + e * self.row - self.y]
    }
}

struct Centred {
    marks: Vec<CentredMark>,
    /// Centroid: col, row, x, y.
    centre: [f64; 4],
}

/// The linear part of the transformation, and the cofactors `[q_aa, q_ab, q_bb]` of the two coefficients of a row.
struct Linear {
    linear: [[f64; 2]; 2],
    cofactors: [f64; 3],
}

impl Centred {
    fn new(fiducials: &[Fiducial]) -> Self {
        let n = fiducials.len() as f64;
        let mean = |value: fn(&Fiducial) -> f64| fiducials.iter().map(value).sum::<f64>() / n;
        let centre = [mean(|f| f.col), mean(|f| f.row), mean(|f| f.x_mm), mean(|f| f.y_mm)];
        let [col, row, x, y] = centre;
        let marks = fiducials.iter().map(|f| CentredMark { col: f.col - col, row: f.row - row, x: f.x_mm - x, y: f.y_mm - y }).collect();
        Self { marks, centre }
    }

    fn sum(&self, product: impl Fn(&CentredMark) -> f64) -> f64 {
        self.marks.iter().map(product).sum()
    }

    fn affine(&self) -> Linear {
        let (cc, cr, rr) = (self.sum(|m| m.col * m.col), self.sum(|m| m.col * m.row), self.sum(|m| m.row * m.row));
        let determinant = cc * rr - cr * cr;
        let row_of = |c: f64, r: f64| [(rr * c - cr * r) / determinant, (cc * r - cr * c) / determinant];
        let linear =
            [row_of(self.sum(|m| m.col * m.x), self.sum(|m| m.row * m.x)), row_of(self.sum(|m| m.col * m.y), self.sum(|m| m.row * m.y))];
        Linear { linear, cofactors: [rr / determinant, -cr / determinant, cc / determinant] }
    }

    /// `turn` is -1 where y goes from down to up (the rule), 1 where it does not: x = a·col + b·row, y = turn·(a·row - b·col).
    fn similarity(&self, turn: f64) -> Linear {
        let square = self.sum(|m| m.col * m.col + m.row * m.row);
        let a = self.sum(|m| m.col * m.x + turn * m.row * m.y) / square;
        let b = self.sum(|m| m.row * m.x - turn * m.col * m.y) / square;
        Linear { linear: [[a, b], [-turn * b, turn * a]], cofactors: [1.0 / square, 0.0, 1.0 / square] }
    }

    fn best_similarity(&self) -> Linear {
        let misfit = |solution: &Linear| {
            self.sum(|mark| {
                let [x, y] = mark.residual(&solution.linear);
                x * x + y * y
            })
        };
        let (turned, unturned) = (self.similarity(-1.0), self.similarity(1.0));
        // Two marks fit both ways but for rounding: then y is turned, as in any scan the right way up.
        let rounding = 1e-18 * self.sum(|m| m.x * m.x + m.y * m.y);
        if misfit(&turned) <= misfit(&unturned) + rounding { turned } else { unturned }
    }

    fn uncentre(&self, linear: [[f64; 2]; 2]) -> [[f64; 3]; 2] {
        let [col, row, x, y] = self.centre;
        let [[a, b], [d, e]] = linear;
        [[a, b, x - a * col - b * row], [d, e, y - d * col - e * row]]
    }

    /// Cofactors of the two coefficients and the shift of a row, the shift being that of uncentred coordinates.
    fn cofactors(&self, [aa, ab, bb]: &[f64; 3]) -> [[f64; 3]; 3] {
        let [col, row, ..] = self.centre;
        let (at, bt) = (-aa * col - ab * row, -ab * col - bb * row);
        let tt = 1.0 / self.marks.len() as f64 + aa * col * col + 2.0 * ab * col * row + bb * row * row;
        [[*aa, *ab, at], [*ab, *bb, bt], [at, bt, tt]]
    }
}

fn check_marks(fiducials: &[Fiducial], needed: usize) -> Result<(), Error> {
    if fiducials.len() < needed {
        return Err(Error::TooFew { few: Few::FiducialMarks, got: fiducials.len(), needed });
    }
    for (index, f) in fiducials.iter().enumerate() {
        for (name, value, limit) in [("col", f.col, 1e7), ("row", f.row, 1e7), ("x_mm", f.x_mm, 1e5), ("y_mm", f.y_mm, 1e5)] {
            if value.is_nan() || value.abs() > limit {
                return refuse(Refusal::MarkCoordinate { coordinate: name.into(), value, mark: index + 1, limit });
            }
        }
    }
    let mut measured = BTreeMap::new();
    let mut calibrated = BTreeMap::new();
    for (index, f) in fiducials.iter().enumerate() {
        // Adding 0 makes -0 the same place as 0.
        let place = |x: f64, y: f64| [x, y].map(|v| (v + 0.0).to_bits());
        let earliest_at = |places: &mut BTreeMap<[u64; 2], usize>, place| *places.entry(place).or_insert(index);
        let earlier = earliest_at(&mut measured, place(f.col, f.row)).min(earliest_at(&mut calibrated, place(f.x_mm, f.y_mm)));
        if earlier < index {
            return refuse(Refusal::MarksAgain { first: earlier + 1, second: index + 1 });
        }
    }
    Ok(())
}

/// Least width of the marks across the line through them, as a share of their length: a thousandth is far below any camera's marks and
/// above the errors of measurement.
const LEAST_WIDTH: f64 = 1e-3;

fn check_spread(centred: &Centred) -> Result<(), Error> {
    let width = |uu: f64, uv: f64, vv: f64| {
        let (half_trace, half_difference) = (0.5 * (uu + vv), 0.5 * (uu - vv));
        let root = (half_difference * half_difference + uv * uv).sqrt();
        ((half_trace - root).max(0.0) / (half_trace + root)).sqrt()
    };
    let measured = width(centred.sum(|m| m.col * m.col), centred.sum(|m| m.col * m.row), centred.sum(|m| m.row * m.row));
    let calibrated = width(centred.sum(|m| m.x * m.x), centred.sum(|m| m.x * m.y), centred.sum(|m| m.y * m.y));
    for (calibrated, width) in [(false, measured), (true, calibrated)] {
        if width.is_nan() || width < LEAST_WIDTH {
            let cause = Cause::MarksOnLine { calibrated, width, least: LEAST_WIDTH };
            return Err(Error::Degenerate { computation: Computation::AffineTransformation, cause });
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUE_PARAMETERS: [[f64; 3]; 2] = [[0.254, 0.0002, -115.8], [0.0001, -0.2539, 116.2]];

    fn exact(parameters: [[f64; 3]; 2], places: &[[f64; 2]]) -> Vec<Fiducial> {
        let [[a, b, tx], [d, e, ty]] = parameters;
        places.iter().map(|&[col, row]| Fiducial { col, row, x_mm: a * col + b * row + tx, y_mm: d * col + e * row + ty }).collect()
    }

    fn corners() -> Vec<[f64; 2]> {
        vec![[38.4, 875.6], [873.0, 40.9], [39.1, 40.5], [872.7, 875.9]]
    }

    fn assert_near(got: [[f64; 3]; 2], wanted: [[f64; 3]; 2], tolerance: f64) {
        for (got, wanted) in got.iter().flatten().zip(wanted.iter().flatten()) {
            assert!((got - wanted).abs() < tolerance, "{got} is not {wanted}");
        }
    }

    #[test]
    fn three_marks_give_the_affine_exactly_and_no_sigma() {
        let found = orient_fiducials(&exact(TRUE_PARAMETERS, &corners()[..3]), FiducialModel::Affine).unwrap();
        assert_near(found.parameters, TRUE_PARAMETERS, 1e-10);
        assert_eq!((found.degrees_of_freedom, found.sigma0_mm, found.standard_errors), (0, None, None));
    }

    #[test]
    fn one_shifted_mark_of_four_leaves_a_quarter_of_its_shift() {
        let mut marks = exact(TRUE_PARAMETERS, &[[0.5, 0.5], [100.5, 0.5], [0.5, 100.5], [100.5, 100.5]]);
        marks[0].x_mm += 0.4;
        let found = orient_fiducials(&marks, FiducialModel::Affine).unwrap();
        // The residuals of an affine over a square alternate: ±a quarter of the shift.
        for ([x, y], wanted) in found.residuals_mm.iter().zip([-0.1, 0.1, 0.1, -0.1]) {
            assert!((x - wanted).abs() < 1e-10 && y.abs() < 1e-10, "{x} {y}");
        }
        assert_eq!(found.degrees_of_freedom, 2);
        assert!((found.sigma0_mm.unwrap() - (0.04_f64 / 2.0).sqrt()).abs() < 1e-10);
        // Σ(col - mean)² = 4·50²; the shift refers to pixel (0, 0), 50.5 px off the middle in both directions.
        let sigma = found.sigma0_mm.unwrap();
        let errors = found.standard_errors.unwrap();
        assert!((errors[0][0] - sigma / 100.0).abs() < 1e-12);
        assert!((errors[1][2] - sigma * (0.25 + 2.0 * (50.5_f64 / 100.0).powi(2)).sqrt()).abs() < 1e-12);
    }

    #[test]
    fn a_similarity_finds_whether_y_is_turned() {
        let turned = [[0.2, 0.03, -90.0], [0.03, -0.2, 80.0]];
        let unturned = [[0.2, 0.03, -90.0], [-0.03, 0.2, 80.0]];
        for parameters in [turned, unturned] {
            let found = orient_fiducials(&exact(parameters, &corners()), FiducialModel::Similarity).unwrap();
            assert_near(found.parameters, parameters, 1e-10);
            assert_eq!(found.degrees_of_freedom, 4);
        }
        let two = orient_fiducials(&exact(turned, &corners()[..2]), FiducialModel::Similarity).unwrap();
        assert_near(two.parameters, turned, 1e-10);
    }

    #[test]
    fn marks_that_cannot_serve_are_named() {
        let affine = |marks: &[Fiducial]| orient_fiducials(marks, FiducialModel::Affine).unwrap_err();
        let good = exact(TRUE_PARAMETERS, &corners());
        assert_eq!(affine(&good[..2]), Error::TooFew { few: Few::FiducialMarks, got: 2, needed: 3 });
        let on_a_line = exact(TRUE_PARAMETERS, &[[0.5, 0.5], [100.5, 100.5], [200.5, 200.5], [300.5, 300.6]]);
        assert!(matches!(affine(&on_a_line), Error::Degenerate { .. }));
        let mut twice = good.clone();
        twice[3] = twice[1];
        assert!(affine(&twice).to_string().contains("marks 2 and 4"), "{}", affine(&twice));
        for value in [f64::NAN, f64::INFINITY, 1e300] {
            let mut absurd = good.clone();
            absurd[2].row = value;
            assert!(affine(&absurd).to_string().contains("in mark 3"), "{}", affine(&absurd));
        }
    }
    #[test]
    fn a_hundred_thousand_marks_do_not_take_half_a_minute() {
        let places: Vec<[f64; 2]> = (0..100_000).map(|i| [f64::from(i % 317), f64::from(i / 317)]).collect();
        let mut marks = exact(TRUE_PARAMETERS, &places);
        let begun = std::time::Instant::now();
        assert!(orient_fiducials(&marks, FiducialModel::Affine).is_ok());
        marks[99_999] = marks[70_000];
        let twice = orient_fiducials(&marks, FiducialModel::Affine).unwrap_err().to_string();
        assert!(twice.contains("marks 70001 and 100000"), "{twice}");
        assert!(begun.elapsed().as_secs() < 5, "{:?}", begun.elapsed());
    }
}
