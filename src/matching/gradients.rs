//! The strategy that compares gradient descriptors: the nearest one of the whole right image.

use super::rules::{refuse_many_to_one, set_of};
use super::{DescriptorMatch, MatchImage, MatchOptions, MatchSet, Nearest, NearestTable, Rule, Verdict, nearest};
use crate::error::refuse;
use crate::{Error, Input, Refusal};

/// Length of a descriptor before it was rounded to bytes.
const UNIT: f64 = 512.0;

/// Matches left points with the right points of the nearest descriptors.
///
/// The measure is the Euclidean distance of the descriptors as unit vectors, 0 to √2. Nothing is known of where right points lie: what
/// fits no geometry of the two views is still there.
///
/// # Errors
/// [`Error::InvalidInput`] where points and descriptors differ in number, or nearest neighbours that are known are of others.
pub(super) fn match_gradients(
    left: (MatchImage<'_>, &[u8]),
    right: (MatchImage<'_>, &[u8]),
    known: Option<&NearestTable>,
    options: &MatchOptions,
) -> Result<MatchSet, Error> {
    let own;
    let table = match known {
        Some(known) => known,
        None => {
            own = nearest(left.1, right.1)?;
            &own
        }
    };
    check_table(table, left.0.points.len(), right.0.points.len())?;
    let verdict = |(k, found): (usize, &Option<Nearest>)| {
        let Some(found) = found else { return Verdict::none(Rule::NoCandidate) };
        let mut verdict = found_at(found, right.0);
        verdict.rule = if verdict.measure >= options.max_measure {
            Rule::Threshold
        } else if options.is_ambiguous(verdict.measure, verdict.second) {
            Rule::Ambiguous
        } else if options.left_right && table.of_right()[found.index].is_none_or(|(back, _)| back != k) {
            Rule::LeftRight
        } else {
            Rule::Matched
        };
        verdict
    };
    let mut verdicts: Vec<Verdict> = table.of_left().iter().enumerate().map(verdict).collect();
    refuse_many_to_one(&mut verdicts);
    Ok(set_of(left.0.points, verdicts))
}

/// Refuses nearest neighbours of other points.
fn check_table(table: &NearestTable, left: usize, right: usize) -> Result<(), Error> {
    if table.rows() == (0..left) && table.of_right().len() == right {
        return Ok(());
    }
    refuse(Refusal::NeighboursOfOthers { rows: format!("{:?}", table.rows()), among: table.of_right().len(), left, right })
}

/// The matches of a set of [`match_gradients`] that a look at the geometry of the two views left: the others of the set are refused for
/// their parallax, or as parts of the frame where they are among these left points; the ones it does not have are added to it.
pub(crate) fn verified_set(
    set: &MatchSet,
    verified: &[DescriptorMatch],
    framed: &[usize],
    left: MatchImage<'_>,
    right: MatchImage<'_>,
) -> MatchSet {
    let mut verdicts = set.verdicts.clone();
    verdicts.iter_mut().filter(|v| v.rule == Rule::Matched).for_each(|v| v.rule = Rule::Parallax);
    framed.iter().for_each(|left| verdicts[*left].rule = Rule::Frame);
    for found in verified {
        let verdict = &mut verdicts[found.left];
        if verdict.best == Some(found.right) {
            verdict.rule = Rule::Matched;
        } else {
            *verdict = found_at(&Nearest { index: found.right, square: found.square, second_square: found.second_square }, right);
        }
    }
    set_of(left.points, verdicts)
}

fn found_at(found: &Nearest, right: MatchImage<'_>) -> Verdict {
    let point = right.points[found.index];
    let measure = |square: u32| f64::from(square).sqrt() / UNIT;
    Verdict {
        best: Some(found.index),
        position: Some([point.x, point.y]),
        measure: measure(found.square),
        second: found.second_square.map_or(f64::INFINITY, measure),
        ..Verdict::none(Rule::Matched)
    }
}

/// The right points in the order of their descriptors' distances from that of a left one, up to `most`: index and measure.
///
/// # Errors
/// [`Error::InvalidInput`] where there is no such left descriptor, or bytes are left over.
pub fn gradient_candidates(index: usize, left: &[u8], right: &[u8], most: usize) -> Result<Vec<super::Candidate>, Error> {
    let (left, right) =
        (super::nearest::descriptors(Input::LeftDescriptors, left)?, super::nearest::descriptors(Input::RightDescriptors, right)?);
    let own = left.get(index).ok_or_else(|| Refusal::LeftPoint { index, count: left.len() }.into_error())?;
    let mut squares: Vec<(u32, usize)> =
        right.iter().enumerate().map(|(k, other)| (super::blocks::square_distance(own, other), k)).collect();
    let most = most.min(squares.len());
    if most < squares.len() {
        squares.select_nth_unstable(most);
        squares.truncate(most);
    }
    squares.sort_unstable();
    Ok(squares.into_iter().map(|(square, right)| super::Candidate { right, measure: f64::from(square).sqrt() / UNIT }).collect())
}
