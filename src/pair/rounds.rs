//! Matching and orienting by turns: an orientation narrows the search to the epipolar lines, which gives a better orientation.

use super::frames::CommonFrame;
use super::geometry::PairInterior;
use super::orienting::orient_matches;
use super::settings::PairSettings;
use super::verification::{IdealCameras, guide, verify};
use super::weakness::least_matches;
use crate::matching::{filled_in, refine, verified_set};
use crate::{
    DescriptorMatch, Descriptors, EpipolarLines, Error, Expectation, Located, Match, MatchImage, MatchSet, NoGeometry, RelativeOrientation,
    TwoView, match_images,
};

/// Rounds after which matching ends even if a few points still change sides.
const MAX_ROUNDS: usize = 5;

/// Right points this many standard errors of a y-parallax (√2 σ₀) from their epipolar line are candidates, and those nearer than
/// `LEAST_TOLERANCE_PX`: whole-pixel positions scatter by that.
const TOLERANCE: f64 = 4.0;
const LEAST_TOLERANCE_PX: f64 = 1.5;

/// The matches of a pair.
#[derive(Debug, Clone, PartialEq)]
pub struct PairMatching {
    pub set: MatchSet,
    /// For the strategy that looks for no expected place: what relates the views, by which its matches were verified; its inliers are
    /// indices of the matches. Or why there is nothing.
    pub geometry: Option<Result<TwoView, NoGeometry>>,
}

/// Matches a pair; with `settings.matching.epipolar` and a camera, matches again along the epipolar lines of its orientation until
/// nothing changes, at most 5 times. Matches by gradients are verified by the geometry of the two views, known cameras or not, and matched
/// again along its lines; where there is none, none is left.
///
/// A pair that cannot be oriented keeps the matches it has.
///
/// # Errors
/// As [`match_images`], and [`Error::InvalidOption`] of the geometry and the orientation.
pub fn match_in_rounds<'a>(
    images: [MatchImage<'_>; 2],
    expected: impl Into<Expectation<'a>>,
    interior: Option<&PairInterior>,
    settings: &PairSettings,
) -> Result<PairMatching, Error> {
    let ([left, right], expected) = (images, expected.into());
    let mut set = match_images(left, right, expected, &settings.matching)?;
    if !settings.matching.strategy.needs_offset() {
        return verified(images, &set, interior, settings);
    }
    let Some(interior) = interior.filter(|_| settings.matching.epipolar) else { return Ok(PairMatching { set, geometry: None }) };
    for _ in 0..MAX_ROUNDS {
        let orientation = match orient_matches(&set.matches, interior, &settings.orientation) {
            Ok(orientation) => orientation,
            Err(error) if error.is_usage() => return Err(error),
            Err(_) => break,
        };
        let lines = epipolar_lines(&orientation, interior);
        let next = match_images(left, right, Expectation { lines: Some(&lines), ..expected }, &settings.matching)?;
        let settled = next.matches == set.matches;
        set = next;
        if settled {
            break;
        }
    }
    Ok(PairMatching { set, geometry: None })
}

/// The matches that agree with the geometry of the two views, refined where that is wanted.
fn verified(
    images: [MatchImage<'_>; 2],
    set: &MatchSet,
    interior: Option<&PairInterior>,
    settings: &PairSettings,
) -> Result<PairMatching, Error> {
    let [left, right] = images;
    let sizes = images.map(|image| (image.grey.width(), image.grey.height()));
    let cameras = IdealCameras::new(interior, sizes);
    let positions = [0, 1].map(|side| cameras.ideal(side, images[side].points.iter().map(|p| [p.x, p.y])));
    let located = |side: usize| Located {
        positions: &positions[side],
        descriptors: match images[side].descriptors {
            Descriptors::Gradients(bytes) => bytes,
            _ => &[],
        },
    };
    // Their measures stand in the set.
    let pair = |m: &Match| m.right.map(|right| DescriptorMatch { left: m.left, right, square: 0, second_square: None });
    let first: Vec<DescriptorMatch> = set.matches.iter().filter_map(pair).collect();
    let place = |m: &DescriptorMatch| {
        let (p, q) = (left.points[m.left], right.points[m.right]);
        [p.x, p.y, q.x, q.y]
    };
    let frame = match settings.matching.without_frame {
        true => CommonFrame::find(&first.iter().map(place).collect::<Vec<_>>(), sizes, settings.geometry.seed),
        false => None,
    };
    let in_frame = |m: &DescriptorMatch| frame.is_some_and(|frame| frame.holds(&place(m)));
    let found = verify(located(0), located(1), &first, in_frame, &cameras.options(&settings.geometry))?;
    let framed: Vec<usize> = first.iter().filter(|m| in_frame(m)).map(|m| m.left).collect();
    let all = verified_set(set, &found.matches, &framed, left, right);
    let set = refine(all, left, right, &settings.matching);
    // Few matches may be wrong ones of a repeated pattern, which foretell more of the kind.
    let enough = least_matches(positions.each_ref().map(Vec::len));
    let set = match &found.geometry {
        Ok(geometry) if settings.matching.fills_in() && set.matches.len() >= enough => {
            let guide = guide(geometry);
            let off_px = |k: usize, place: [f64; 2]| {
                let at = cameras.ideal(1, [place].into_iter());
                at.first().map_or(f64::INFINITY, |at| guide.distance_px(positions[0][k], *at))
            };
            filled_in(set, left, right, &settings.matching, off_px, geometry.threshold_px)
        }
        _ => set,
    };
    // Refinement refuses some.
    let geometry = found.geometry.map(|geometry| TwoView { inliers: (0..set.matches.len()).collect(), ..geometry });
    Ok(PairMatching { set, geometry: Some(geometry) })
}

fn epipolar_lines(orientation: &RelativeOrientation, interior: &PairInterior) -> EpipolarLines {
    let p = orientation.parameters;
    let scatter_px = std::f64::consts::SQRT_2 * orientation.sigma0_mm.unwrap_or(0.0) / interior.right.pixel_mm();
    let axes = if orientation.turn_deg == 0.0 { *interior } else { interior.turned() };
    EpipolarLines::new(
        [axes.left, axes.right],
        orientation.focal_mm,
        [p.omega_deg, p.phi_deg, p.kappa_deg].map(f64::to_radians),
        [orientation.base_mm, p.by_mm, p.bz_mm],
        (TOLERANCE * scatter_px).max(LEAST_TOLERANCE_PX),
    )
}
