//! Pairs that are rejected by hand: what their matches alone support takes no part.

use super::BlockEdit;
use crate::PointSource;
use crate::reconstruction::{ObservedPoint, RayPart};
use std::collections::BTreeSet;

/// Pairs of images by their indices in the block, each in ascending order.
pub(crate) type ImagePairs = BTreeSet<[usize; 2]>;

/// The pairs that are rejected after these edits.
pub(crate) fn rejected_pairs(edits: &[BlockEdit]) -> ImagePairs {
    let mut rejected = ImagePairs::new();
    edits.iter().for_each(|edit| sort_pairs(&mut rejected, edit));
    rejected
}

/// Brings rejected pairs after one more edit.
pub(super) fn sort_pairs(rejected: &mut ImagePairs, edit: &BlockEdit) {
    match edit {
        BlockEdit::RejectPairs { pairs } => rejected.extend(pairs.iter().copied().map(ascending)),
        BlockEdit::RestorePairs { pairs } => {
            let restored: ImagePairs = pairs.iter().copied().map(ascending).collect();
            rejected.retain(|pair| !restored.contains(pair));
        }
        _ => {}
    }
}

/// A pair of images in the order of their indices.
pub(crate) fn ascending([a, b]: [usize; 2]) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

/// Takes out what only matches of rejected pairs support. A block does not keep which single match joined which observations of a tie point, but
/// which pairs of images matches connect: of a tie point that both images of a rejected pair show, the largest part stays whose images other
/// pairs connect; of equal ones that with the first image; none of a single image. Observations of the other images take no part.
///
/// Observations that take no part, and images that `is_out` names, connect nothing. What was measured by hand is no match: it connects nothing and
/// stays as it is.
pub(super) fn take_out(points: &mut [ObservedPoint], connected: &ImagePairs, rejected: &ImagePairs, is_out: impl Fn(usize) -> bool) {
    if rejected.is_empty() {
        return;
    }
    for point in points.iter_mut().filter(|point| matches!(point.source, PointSource::TiePoint(_))) {
        let matched = point.rays.iter().filter(|ray| !ray.source.by_hand);
        let images: BTreeSet<usize> = matched.clone().map(|ray| ray.image).collect();
        if !images.iter().any(|a| images.range(a + 1..).any(|b| rejected.contains(&[*a, *b]))) {
            continue;
        }
        let taking = matched.filter(|ray| ray.part == RayPart::Takes && !is_out(ray.image)).map(|ray| ray.image).collect();
        let kept = largest_part(taking, |pair| connected.contains(&pair) && !rejected.contains(&pair));
        let taking = point.rays.iter_mut().filter(|ray| ray.part == RayPart::Takes && !ray.source.by_hand);
        let lost = taking.filter(|ray| !kept.contains(&ray.image));
        lost.for_each(|ray| ray.part = RayPart::RejectedByHand);
    }
}

/// Of images the largest part that pairs connect; of equal ones that with the first image, and nothing where no two are connected.
fn largest_part(mut images: BTreeSet<usize>, is_connected: impl Fn([usize; 2]) -> bool) -> BTreeSet<usize> {
    let mut largest = BTreeSet::new();
    while let Some(first) = images.pop_first() {
        let (mut part, mut ends) = (BTreeSet::from([first]), vec![first]);
        while let Some(end) = ends.pop() {
            let (next, others) = images.into_iter().partition(|image| is_connected(ascending([end, *image])));
            images = others;
            part.extend(&next);
            ends.extend(next);
        }
        if part.len() > largest.len().max(1) {
            largest = part;
        }
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ObservationSource;
    use crate::reconstruction::{ObservedRay, RayWeight};

    fn ray(image: usize, by_hand: bool, part: RayPart) -> ObservedRay {
        let source = ObservationSource { feature: None, confidence: 1.0, by_hand };
        ObservedRay { image, at_px: [1.0, 2.0], source, weight: RayWeight::Known(1.0), part }
    }

    fn point(source: PointSource, rays: Vec<ObservedRay>) -> ObservedPoint {
        ObservedPoint { source, place: Some([0.0; 3]), is_given: true, rays }
    }

    fn matched(images: &[usize]) -> Vec<ObservedRay> {
        images.iter().map(|image| ray(*image, false, RayPart::Takes)).collect()
    }

    fn pairs(of: &[[usize; 2]]) -> ImagePairs {
        of.iter().copied().collect()
    }

    /// The images whose observations take part after pairs were rejected.
    fn taking(point: ObservedPoint, connected: &[[usize; 2]], rejected: &[[usize; 2]], out: &[usize]) -> Vec<usize> {
        let mut points = [point];
        take_out(&mut points, &pairs(connected), &pairs(rejected), |image| out.contains(&image));
        points[0].rays.iter().filter(|ray| ray.part == RayPart::Takes).map(|ray| ray.image).collect()
    }

    const TIE: PointSource = PointSource::TiePoint(0);
    const ALL: [[usize; 2]; 6] = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];

    #[test]
    fn a_point_that_only_a_rejected_pair_shows_takes_no_part() {
        assert!(taking(point(TIE, matched(&[0, 1])), &ALL, &[[0, 1]], &[]).is_empty());
        assert_eq!(taking(point(TIE, matched(&[0, 2])), &ALL, &[[0, 1]], &[]), [0, 2]);
        // A third image that does not take part shows nothing.
        assert!(taking(point(TIE, matched(&[0, 1, 2])), &ALL, &[[0, 1]], &[2]).is_empty());
        let rejected = ray(2, false, RayPart::RejectedByHand);
        assert!(taking(point(TIE, [matched(&[0, 1]), vec![rejected]].concat()), &ALL, &[[0, 1]], &[]).is_empty());
    }

    #[test]
    fn what_did_not_fit_before_is_not_said_to_be_rejected_by_hand() {
        let mut points = [point(TIE, [matched(&[0, 1, 2]), vec![ray(3, false, RayPart::DoesNotFit(Some(9.0)))]].concat())];
        take_out(&mut points, &pairs(&ALL), &pairs(&[[0, 1]]), |_| false);
        assert_eq!(points[0].rays[3].part, RayPart::DoesNotFit(Some(9.0)));
    }

    #[test]
    fn of_a_point_the_largest_part_stays_that_other_pairs_connect() {
        let of = |connected: &[[usize; 2]], rejected: &[[usize; 2]]| taking(point(TIE, matched(&[0, 1, 2, 3])), connected, rejected, &[]);
        assert_eq!(of(&ALL, &[[0, 1]]), [0, 1, 2, 3]);
        assert_eq!(of(&[[0, 1], [1, 2], [2, 3]], &[[0, 1]]), [1, 2, 3]);
        assert_eq!(of(&[[0, 1], [1, 2], [2, 3]], &[[1, 2]]), [0, 1]);
        assert_eq!(of(&ALL, &[[0, 1], [0, 2], [0, 3]]), [1, 2, 3]);
        assert!(of(&ALL, &ALL).is_empty());
    }

    #[test]
    fn what_was_measured_by_hand_and_what_is_no_tie_point_stays() {
        for source in [PointSource::GroundControl(0), PointSource::Manual(0)] {
            assert_eq!(taking(point(source, matched(&[0, 1])), &ALL, &[[0, 1]], &[]), [0, 1]);
        }
        let by_hand = |image| ray(image, true, RayPart::Takes);
        assert_eq!(taking(point(TIE, [matched(&[0, 1]), vec![by_hand(2)]].concat()), &ALL, &[[0, 1]], &[]), [2]);
        assert_eq!(taking(point(TIE, [matched(&[0]), vec![by_hand(1)]].concat()), &ALL, &[[0, 1]], &[]), [0, 1]);
    }

    #[test]
    fn pairs_are_the_same_either_way_round_and_the_last_edit_counts() {
        let reject = |pair| BlockEdit::RejectPairs { pairs: vec![pair] };
        let restore = |pair| BlockEdit::RestorePairs { pairs: vec![pair] };
        assert_eq!(rejected_pairs(&[reject([3, 1]), reject([1, 3]), reject([0, 1])]), pairs(&[[0, 1], [1, 3]]));
        assert!(rejected_pairs(&[reject([3, 1]), restore([1, 3])]).is_empty());
        assert_eq!(rejected_pairs(&[restore([1, 3]), reject([3, 1])]), pairs(&[[1, 3]]));
    }
}
