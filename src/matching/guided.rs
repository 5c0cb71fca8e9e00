//! Guided matching: once the geometry of two images is known, candidates lie near the epipolar line, or near one place.

use super::blocks::{DESCRIPTOR_BYTES, square_distance};
use super::index::PositionIndex;
use super::nearest::{DescriptorMatch, Nearest, NearestOptions, descriptors};
use crate::catalogue::options;
use crate::error::refuse;
use crate::{Error, Input, Refusal};

/// Where a left point may be seen in the right image; matrices by rows, of homogeneous positions in px.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Guide {
    /// On the line F p: a fundamental matrix, with qᵀ F p = 0.
    Lines([[f64; 3]; 3]),
    /// At H p: a homography.
    Places([[f64; 3]; 3]),
}

impl Guide {
    /// How far a right position lies from where a left one may be seen, in px; no number where that is nowhere.
    pub(crate) fn distance_px(&self, [x, y]: [f64; 2], [u, v]: [f64; 2]) -> f64 {
        let (Self::Lines(m) | Self::Places(m)) = self;
        let [a, b, c] = m.map(|row| row[0] * x + row[1] * y + row[2]);
        match self {
            Self::Lines(_) => (a * u + b * v + c).abs() / libm::hypot(a, b),
            Self::Places(_) => libm::hypot(a / c - u, b / c - v),
        }
    }
}

/// Points with their descriptors.
#[derive(Debug, Clone, Copy)]
pub struct Located<'a> {
    /// x and y in px.
    pub positions: &'a [[f64; 2]],
    /// [`DESCRIPTOR_BYTES`] for each point.
    pub descriptors: &'a [u8],
}

/// The square of the distance of the descriptors of two points.
///
/// # Panics
/// Where one of the points is none.
pub(crate) fn square_distance_of(left: Located<'_>, i: usize, right: Located<'_>, j: usize) -> u32 {
    let (first, second) = (left.descriptors.as_chunks().0, right.descriptors.as_chunks().0);
    square_distance(&first[i], &second[j])
}

options! {
    /// Options of [`guided_matches`].
    pub struct GuidedOptions in "guided" {
        section "Guided matching";

        /// The distance from the epipolar line, or from the place that a plane gives, within which right points are candidates: more finds
        /// points of less exact geometries.
        radius_px: f64 = 3.0, "Distance", in "px", 0..=1000;

        /// The ratio to the second nearest among the candidates, of which there are few: higher keeps more, less certain matches.
        ratio: f64 = 0.85, "Ratio", 0..=1;

        /// The Euclidean distance of two descriptors beyond which they never match: more keeps more, less certain matches.
        largest_distance: Option<f64> = None, "Maximum distance", 0..=3000, absent "any distance";
    }
}

/// Matches descriptors among the right points near the epipolar line (or place) of each left point, mutual ones only.
///
/// The second nearest that the ratio compares with lies more than the radius from the nearest: a corner that was detected twice is no rival
/// of itself. In ascending order of the left points.
///
/// # Errors
/// [`Error::InvalidOption`]; [`Error::InvalidInput`] where positions and descriptors differ in number, positions are no positions in px, or
/// the matrix is not of finite numbers.
pub fn guided_matches(
    left: Located<'_>,
    right: Located<'_>,
    guide: &Guide,
    options: &GuidedOptions,
) -> Result<Vec<DescriptorMatch>, Error> {
    options.check_ranges()?;
    let (left_bytes, right_bytes) = (checked(Input::LeftPoints, left)?, checked(Input::RightPoints, right)?);
    let (Guide::Lines(matrix) | Guide::Places(matrix)) = guide;
    if let Some(&value) = matrix.iter().flatten().find(|v| !v.is_finite()) {
        return refuse(Refusal::GuideMatrix { value });
    }
    let index = PositionIndex::of_squares(right.positions.iter().enumerate().map(|(k, [x, y])| (k, *x, *y)));
    let mut back: Vec<Option<(usize, u32)>> = vec![None; right.positions.len()];
    let mut found: Vec<(usize, Nearest)> = Vec::new();
    let mut candidates: Vec<(u32, usize)> = Vec::new();
    for (k, (position, descriptor)) in left.positions.iter().zip(left_bytes).enumerate() {
        candidates.clear();
        visit_near(&index, guide, *position, options.radius_px, |j| candidates.push((square_distance(descriptor, &right_bytes[j]), j)));
        for (square, j) in &candidates {
            if back[*j].is_none_or(|(_, least)| *square < least) {
                back[*j] = Some((k, *square));
            }
        }
        found.extend(nearest_of_candidates(&candidates, right.positions, options.radius_px).map(|nearest| (k, nearest)));
    }
    let tests = NearestOptions { ratio: options.ratio, mutual: true, largest_distance: options.largest_distance };
    let accepted = found.into_iter().filter(|(k, nearest)| {
        back[nearest.index].is_some_and(|(left, _)| left == *k) && tests.accept(nearest.square, nearest.second_square)
    });
    let as_match = |(k, n): (usize, Nearest)| DescriptorMatch { left: k, right: n.index, square: n.square, second_square: n.second_square };
    Ok(accepted.map(as_match).collect())
}

/// The nearest of squares with their points, the first of equal ones; the second nearest lies apart from it.
fn nearest_of_candidates(candidates: &[(u32, usize)], positions: &[[f64; 2]], apart: f64) -> Option<Nearest> {
    let &(square, index) = candidates.iter().min()?;
    let [x, y] = positions[index];
    let is_apart = |j: usize| (positions[j][0] - x) * (positions[j][0] - x) + (positions[j][1] - y) * (positions[j][1] - y) > apart * apart;
    let second_square = candidates.iter().filter(|(_, j)| is_apart(*j)).map(|(square, _)| *square).min();
    Some(Nearest { index, square, second_square })
}

fn visit_near(index: &PositionIndex, guide: &Guide, [x, y]: [f64; 2], radius: f64, mut visit: impl FnMut(usize)) {
    let times = |m: &[[f64; 3]; 3]| m.map(|row| row[0] * x + row[1] * y + row[2]);
    match guide {
        Guide::Places(homography) => {
            let [u, v, w] = times(homography);
            let (u, v) = (u / w, v / w);
            if u.is_finite() && v.is_finite() {
                index.around([u - radius, v - radius, u + radius, v + radius], |j, px, py| {
                    if (px - u) * (px - u) + (py - v) * (py - v) <= radius * radius {
                        visit(j);
                    }
                });
            }
        }
        Guide::Lines(fundamental) => {
            let [a, b, c] = times(fundamental);
            let length = (a * a + b * b).sqrt();
            let (a, b, c) = (a / length, b / length, c / length);
            if a.is_finite() && b.is_finite() && c.is_finite() {
                visit_line(index, [a, b, c], radius, &mut visit);
            }
        }
    }
}

/// What rounding may move a point over the border of a band, px.
const ROUNDING_PX: f64 = 1e-6;

/// Visits the points within `radius` of a line whose normal `a`, `b` has length 1, along the axis it is nearer to.
fn visit_line(index: &PositionIndex, [a, b, c]: [f64; 3], radius: f64, visit: &mut impl FnMut(usize)) {
    let flat = b.abs() >= a.abs();
    // Along the axis `u`, v = offset + slope u; the band reaches `reach` to either side in v.
    let (across, along) = if flat { (b, a) } else { (a, b) };
    let (slope, offset, reach) = (-along / across, -c / across, radius / across.abs() + ROUNDING_PX);
    let band = |u0: f64, u1: f64| {
        let (v0, v1) = (offset + slope * u0, offset + slope * u1);
        [v0.min(v1) - reach, v0.max(v1) + reach]
    };
    index.across(flat, band, |j, x, y| {
        if (a * x + b * y + c).abs() <= radius {
            visit(j);
        }
    });
}

fn checked<'a>(input: Input, points: Located<'a>) -> Result<&'a [[u8; DESCRIPTOR_BYTES]], Error> {
    let bytes = descriptors(input, points.descriptors)?;
    if bytes.len() != points.positions.len() {
        return refuse(Refusal::DescribedPositions { input, positions: points.positions.len(), descriptors: bytes.len() });
    }
    match points.positions.iter().find(|p| p.iter().any(|v| !(v.abs() <= 1e6))) {
        None => Ok(bytes),
        Some(&[x, y]) => refuse(Refusal::FarPosition { input, x, y }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;

    fn points(count: usize, seed: u32) -> (Vec<[f64; 2]>, Vec<u8>) {
        let mut random = Random::new(seed);
        let positions = (0..count).map(|_| [random.below(90_000) as f64 * 0.01, random.below(60_000) as f64 * 0.01]).collect();
        (positions, (0..count * DESCRIPTOR_BYTES).map(|_| random.below(12) as u8 * 20).collect())
    }

    fn located<'a>((positions, descriptors): &'a (Vec<[f64; 2]>, Vec<u8>)) -> Located<'a> {
        Located { positions, descriptors }
    }

    /// All candidates by the definition.
    fn near_by_definition(right: &[[f64; 2]], guide: &Guide, [x, y]: [f64; 2], radius: f64) -> Vec<usize> {
        let (Guide::Lines(m) | Guide::Places(m)) = guide;
        let [a, b, c] = m.map(|row| row[0] * x + row[1] * y + row[2]);
        let near = |[u, v]: &[f64; 2]| match guide {
            Guide::Lines(_) => (a * u + b * v + c).abs() / (a * a + b * b).sqrt() <= radius,
            Guide::Places(_) => ((u - a / c) * (u - a / c) + (v - b / c) * (v - b / c)).sqrt() <= radius,
        };
        right.iter().enumerate().filter(|(_, q)| near(q)).map(|(j, _)| j).collect()
    }

    #[test]
    fn candidates_are_those_near_the_line_or_the_place() {
        let (right, _) = points(3000, 2);
        let index = PositionIndex::of_squares(right.iter().enumerate().map(|(k, [x, y])| (k, *x, *y)));
        let guides = [
            Guide::Lines([[0.0, 0.0, 0.1], [0.0, 0.0, -1.0], [-0.02, 1.0, 3.0]]),
            Guide::Lines([[0.0, 0.0, -1.0], [0.0, 0.0, 0.3], [1.0, 0.1, 3.0]]),
            Guide::Lines([[0.0, -1e-3, 0.4], [1e-3, 0.0, 0.3], [-0.4, -0.3, 0.0]]),
            Guide::Places([[0.9, 0.1, 5.0], [-0.1, 0.95, 20.0], [1e-5, -2e-5, 1.0]]),
        ];
        for guide in guides {
            let mut most = 0;
            for left in [[10.0, 20.0], [450.0, 300.0], [899.0, 1.0]] {
                let mut found = Vec::new();
                visit_near(&index, &guide, left, 9.5, |j| found.push(j));
                found.sort_unstable();
                most = most.max(found.len());
                assert_eq!(found, near_by_definition(&right, &guide, left, 9.5));
            }
            assert!(most > 0);
        }
    }

    #[test]
    fn what_is_ambiguous_in_the_whole_image_is_found_near_its_line() {
        let left = points(200, 5);
        // Each descriptor is there twice: in its own row, shifted by 25 px, and 100 rows away.
        let shifted = |dx: f64, dy: f64| left.0.iter().map(move |[x, y]| [x + dx, y + dy]).collect::<Vec<_>>();
        let right = ([shifted(25.0, 0.0), shifted(60.0, 100.0)].concat(), [left.1.clone(), left.1.clone()].concat());
        assert!(super::super::nearest_matches(&left.1, &right.1, &NearestOptions::default()).unwrap().is_empty());
        let rows = Guide::Lines([[0.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]);
        let found = guided_matches(located(&left), located(&right), &rows, &GuidedOptions::default()).unwrap();
        assert_eq!(found.len(), 200);
        assert!(found.iter().all(|m| m.left == m.right && m.square == 0));
        let place = Guide::Places([[1.0, 0.0, 59.0], [0.0, 1.0, 101.0], [0.0, 0.0, 1.0]]);
        let found = guided_matches(located(&left), located(&right), &place, &GuidedOptions::default()).unwrap();
        assert_eq!(found.len(), 200);
        assert!(found.iter().all(|m| m.left + 200 == m.right));
    }

    #[test]
    fn a_corner_that_was_detected_twice_is_no_rival_of_itself() {
        let left = points(1, 8);
        let [x, y] = left.0[0];
        let rows = Guide::Lines([[0.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]);
        let count = |apart: f64| {
            let right = (vec![[x + 5.0, y], [x + 5.0 + apart, y]], [left.1.clone(), left.1.clone()].concat());
            guided_matches(located(&left), located(&right), &rows, &GuidedOptions::default()).unwrap().len()
        };
        assert_eq!((count(1.0), count(10.0)), (1, 0));
    }

    #[test]
    fn input_that_does_not_fit_is_refused() {
        let (all, guide) = (points(4, 1), Guide::Lines([[0.0; 3]; 3]));
        let options = GuidedOptions::default();
        let call = |left: Located<'_>, guide: &Guide, options: &GuidedOptions| guided_matches(left, located(&all), guide, options);
        assert!(call(located(&all), &guide, &options).unwrap().is_empty(), "a line that is none has no candidates");
        let fewer = Located { positions: &all.0[1..], descriptors: &all.1 };
        assert!(matches!(
            call(fewer, &guide, &options),
            Err(Error::InvalidInput { refusal: Refusal::DescribedPositions { input: Input::LeftPoints, .. } })
        ));
        let nowhere = Located { positions: &[[0.0, 0.0], [1.0, f64::NAN], [0.0, 0.0], [0.0, 0.0]], descriptors: &all.1 };
        assert!(matches!(
            call(nowhere, &guide, &options),
            Err(Error::InvalidInput { refusal: Refusal::FarPosition { input: Input::LeftPoints, .. } })
        ));
        let wrong = Guide::Places([[f64::INFINITY; 3]; 3]);
        assert!(matches!(call(located(&all), &wrong, &options), Err(Error::InvalidInput { refusal: Refusal::GuideMatrix { .. } })));
        let wrong = GuidedOptions { radius_px: -1.0, ..GuidedOptions::default() };
        assert!(matches!(call(located(&all), &guide, &wrong), Err(Error::InvalidOption { field: "guided.radius_px", .. })));
    }
}
