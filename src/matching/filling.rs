//! Least squares matching of points that found no match, from where the matches around them foretell them.

use super::area::limits;
use super::fit::LeastSquaresOptions;
use super::index::PositionIndex;
use super::local_map::Foretelling;
use super::rules::set_of;
use super::scaled::{Halvings, ScaledMatching};
use super::{MatchImage, MatchOptions, MatchSet, Rule, Verdict};

/// Rounds: the matches of the first foretell points beside them.
const ROUNDS: usize = 2;
/// Px about the foretold place within which a point is sought: so many times the scatter of the neighbours about their map.
const REACH: f64 = 3.0;
const REACH_PX: [f64; 2] = [2.0, 6.0];
/// Places nearer to each other, in px, are one to start from.
const SAME_PX: f64 = 1.0;
/// Correlation at least: no rule compares these matches with others.
const LEAST_CORRELATION: f64 = 0.8;
/// The same once the shift is about right: most points without a match are hidden, or their surface breaks.
const LEAST_PROMISING: f64 = 0.6;
/// Nearer matches are of one corner, which was detected twice.
const TWIN_PX: f64 = 3.0;
/// Step in px below which a position is final: a tenth of what scatters at worst. A smaller one refuses a tenth of the right matches on
/// oblique surfaces, whose corners still move.
const CONVERGENCE_PX: f64 = 0.02;
/// A match that least squares matching does not confirm lies so far at most, in px, from where confirmed ones foretell it, or so many times their scatter. Its
/// window may hold a roof and the ground beside it: in simulated towns those farther off are wrong far more often than the others.
const UNCONFIRMED_PX: f64 = 1.5;
const UNCONFIRMED: f64 = 3.0;
/// Confirmed matches farther away than this, in px, tell nothing of a surface that may break between them and a match.
const CONFIRMING_PX: f64 = 32.0;

/// Adds matches of left points that have none, by least squares matching from the place and with the deformation that the nearest matches
/// foretell. Matches that least squares matching did not confirm are tried so as well, from their own place first; what it still does not confirm is
/// rejected where confirmed ones lead elsewhere.
///
/// `off_px` tells how far a right position lies from where the geometry of the two views has a left point, by its index; `threshold_px` is the
/// most that is allowed. Points that find nothing keep the rule that rejected them.
///
/// # Source
/// Otto & Chau 1989, 'Region-growing' algorithm for matching of terrain images, Image and Vision Computing 7 (2).
pub(crate) fn filled_in(
    set: MatchSet,
    left: MatchImage<'_>,
    right: MatchImage<'_>,
    options: &MatchOptions,
    off_px: impl Fn(usize, [f64; 2]) -> f64,
    threshold_px: f64,
) -> MatchSet {
    let least_correlation = options.min_correlation.max(LEAST_CORRELATION);
    let limits =
        LeastSquaresOptions { least_correlation, convergence_px: CONVERGENCE_PX, least_promising: LEAST_PROMISING, ..limits(options) };
    let mut matching = ScaledMatching::new(options.template, [left.grey, right.grey]);
    let positions: Vec<[f64; 2]> = left.points.iter().map(|p| [p.x, p.y]).collect();
    let earlier = set.verdicts;
    let mut verdicts = earlier.clone();
    let mut tried: Vec<Option<[f64; 2]>> = vec![None; positions.len()];
    for _ in 0..ROUNDS {
        let (from, to) = seen(&positions, &verdicts, |_| true);
        let foretelling = Foretelling::new(&from, &to);
        for (k, position) in positions.iter().enumerate() {
            let verdict = &mut verdicts[k];
            if verdict.rule == Rule::Frame || verdict.fit.is_some() {
                continue;
            }
            let Some(map) = foretelling.about(*position) else { continue };
            if tried[k].is_some_and(|earlier| distance(earlier, map.place) < SAME_PX) {
                continue;
            }
            tried[k] = Some(map.place);
            let halvings = Halvings::of(map.affine);
            // Of the right image as it is compared.
            let px = f64::from(1u32 << halvings.0[1]);
            let farthest_px = (REACH * map.scatter_px / px).clamp(REACH_PX[0], REACH_PX[1]);
            let limits = LeastSquaresOptions { farthest_px, ..limits };
            let mut measured = |start: [f64; 2]| {
                let verdict = (off_px(k, start) <= farthest_px * px)
                    .then(|| matching.verdict(*position, (start, map.affine), halvings, &limits, options));
                verdict.filter(|found| found.matched().is_some_and(|place| off_px(k, place) <= threshold_px))
            };
            let own = verdict.matched();
            if let Some(found) = own.and_then(&mut measured) {
                // The features that were matched stay what they are, and so does how they resemble each other.
                (verdict.position, verdict.fit) = (found.position, found.fit);
            } else if let Some(found) =
                Some(map.place).filter(|place| own.is_none_or(|own| distance(own, *place) >= SAME_PX)).and_then(measured)
            {
                *verdict = found;
            }
        }
        reject_twins(&positions, &earlier, &mut verdicts);
    }
    reject_unconfirmed(&positions, &mut verdicts);
    set_of(left.points, verdicts)
}

fn distance([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> f64 {
    libm::hypot(ax - bx, ay - by)
}

/// The left and right positions of the matches that count.
fn seen(positions: &[[f64; 2]], verdicts: &[Verdict], counts: impl Fn(&Verdict) -> bool) -> (Vec<[f64; 2]>, Vec<[f64; 2]>) {
    let counted = positions.iter().zip(verdicts).filter(|(_, verdict)| counts(verdict));
    counted.filter_map(|(position, verdict)| Some((*position, verdict.matched()?))).unzip()
}

/// Rejects what least squares matching did not confirm and confirmed matches foretell elsewhere.
fn reject_unconfirmed(positions: &[[f64; 2]], verdicts: &mut [Verdict]) {
    let (from, to) = seen(positions, verdicts, |verdict| verdict.fit.is_some());
    let foretelling = Foretelling::new(&from, &to);
    for (position, verdict) in positions.iter().zip(verdicts).filter(|(_, verdict)| verdict.fit.is_none()) {
        let (Some(place), Some(map)) = (verdict.matched(), foretelling.within(*position, CONFIRMING_PX)) else { continue };
        // Features of a coarser image are located in its px.
        let px = f64::from(1u32 << Halvings::of(map.affine).0[1]);
        if distance(place, map.place) > (UNCONFIRMED_PX * px).max(UNCONFIRMED * map.scatter_px) {
            verdict.rule = Rule::NotConverged;
        }
    }
}

/// Gives those that were added the verdict that they had, where another match lies so near in either image that it measured the same corner.
fn reject_twins(positions: &[[f64; 2]], earlier: &[Verdict], verdicts: &mut [Verdict]) {
    for side in 0..2 {
        let at = |k: usize, verdict: &Verdict| verdict.matched().map(|right| if side == 0 { positions[k] } else { right });
        let all: Vec<(usize, [f64; 2])> = verdicts.iter().enumerate().filter_map(|(k, v)| Some((k, at(k, v)?))).collect();
        let index = PositionIndex::of_squares(all.iter().map(|(k, [x, y])| (*k, *x, *y)));
        for (k, [x, y]) in all {
            let mut is_twin = false;
            let was_matched = |k: usize| earlier[k].rule == Rule::Matched;
            index.within(x, y, TWIN_PX, |other| {
                // Of two that were added the first stays.
                is_twin |= other != k && verdicts[other].rule == Rule::Matched && (was_matched(other) || other < k);
            });
            if is_twin && !was_matched(k) {
                verdicts[k] = earlier[k];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::texture::Texture;
    use super::super::{Descriptors, Match};
    use super::*;
    use crate::{GreyImage, InterestPoint};

    const SIZE: usize = 320;

    /// Where the surface of the left image is seen in the right one: two slopes that meet in a ridge.
    fn seen([x, y]: [f64; 2]) -> [f64; 2] {
        let height = 12.0 - 0.12 * (x - 160.0).abs();
        [x + height, y + 0.05 * x]
    }

    /// The left position that is seen there, by repeated substitution.
    fn shown(at: [f64; 2]) -> [f64; 2] {
        (0..60).fold(at, |p, _| {
            let found = seen(p);
            [p[0] + at[0] - found[0], p[1] + at[1] - found[1]]
        })
    }

    fn point([x, y]: [f64; 2]) -> InterestPoint {
        InterestPoint { x, y, value: 1.0 }
    }

    /// A set in which every ninth point is matched.
    fn sparse(points: &[InterestPoint]) -> MatchSet {
        let verdict = |(k, p): (usize, &InterestPoint)| match k % 9 {
            0 => super::super::Verdict { position: Some(seen([p.x, p.y])), best: Some(k), ..super::super::Verdict::none(Rule::Matched) },
            _ => super::super::Verdict::none(Rule::Ambiguous),
        };
        set_of(points, points.iter().enumerate().map(verdict).collect())
    }

    fn filled(off_px: f64) -> (usize, Vec<Match>) {
        let texture = Texture::new(11, 4.0, 40.0);
        let left = texture.plain(SIZE, 1.0, 1);
        let right: GreyImage = texture.image(SIZE, shown, [0.9, 8.0, 1.0], 2);
        let places = (0..400).map(|k| [40.5 + ((k * 37) % 240) as f64, 40.5 + ((k * 101) % 240) as f64]);
        let points: Vec<InterestPoint> = places.map(point).collect();
        let image = |grey| MatchImage { grey, points: &points, descriptors: Descriptors::None, frames: &[] };
        let set = sparse(&points);
        let before = set.matches.len();
        (before, filled_in(set, image(left.view()), image(right.view()), &MatchOptions::default(), |_, _| off_px, 1.0).matches)
    }

    #[test]
    fn points_beside_matches_are_found_where_the_surface_is_seen() {
        let (before, matches) = filled(0.5);
        assert!(matches.len() > 5 * before, "{} of {before}", matches.len());
        let off = |m: &Match| {
            let truth = seen(m.left_px);
            libm::hypot(truth[0] - m.right_px[0], truth[1] - m.right_px[1])
        };
        let wrong = matches.iter().filter(|m| off(m) > 1.0).count();
        assert!(wrong * 100 <= matches.len(), "{wrong} of {}", matches.len());
        assert!(matches.iter().filter(|m| m.right.is_none()).all(|m| m.fit.is_some()), "what was added was measured");
    }

    #[test]
    fn a_corner_that_was_detected_twice_is_matched_once() {
        let (_, matches) = filled(0.5);
        let near = |a: [f64; 2], b: [f64; 2]| libm::hypot(a[0] - b[0], a[1] - b[1]) < TWIN_PX * 0.99;
        let added: Vec<&Match> = matches.iter().filter(|m| m.right.is_none()).collect();
        for m in &added {
            let twins = matches.iter().filter(|other| other.left != m.left && near(other.left_px, m.left_px)).count();
            assert_eq!(twins, 0, "{:?}", m.left_px);
        }
    }

    /// A match by descriptors that is wrong by so much along the rows, among `sparse` ones: its place in the right image at last.
    fn led_astray(by_px: f64) -> Option<Match> {
        let texture = Texture::new(11, 4.0, 40.0);
        let (left, right) = (texture.plain(SIZE, 1.0, 1), texture.image(SIZE, shown, [0.9, 8.0, 1.0], 2));
        let points: Vec<InterestPoint> =
            (0..400).map(|k| point([40.5 + ((k * 37) % 240) as f64, 40.5 + ((k * 101) % 240) as f64])).collect();
        let mut set = sparse(&points);
        let [x, y] = seen([points[180].x, points[180].y]);
        set.verdicts[180].position = Some([x + by_px, y]);
        let image = |grey| MatchImage { grey, points: &points, descriptors: Descriptors::None, frames: &[] };
        let set =
            filled_in(set_of(&points, set.verdicts), image(left.view()), image(right.view()), &MatchOptions::default(), |_, _| 0.5, 1.0);
        set.matches.into_iter().find(|m| m.left == 180)
    }

    #[test]
    fn a_match_that_is_led_astray_is_found_where_those_around_it_foretell_it() {
        for (by_px, is_its_own) in [(0.7, true), (9.0, false), (60.0, false)] {
            let found = led_astray(by_px).unwrap();
            let truth = seen(found.left_px);
            assert!(found.fit.is_some() && distance(found.right_px, truth) < 0.3, "{by_px}: {found:?}");
            assert_eq!(found.right, is_its_own.then_some(180), "{by_px}");
        }
    }

    #[test]
    fn what_is_not_confirmed_stands_where_confirmed_matches_foretell_it() {
        let positions: Vec<[f64; 2]> = (0..200).map(|k| [10.0 * f64::from(k % 20), 10.0 * f64::from(k / 20)]).collect();
        let fit = crate::Fit { correlation: 0.9, covariance: [0.01, 0.0, 0.01], iterations: 5 };
        let off = |k: usize| [0.0, 1.0, 2.0, 9.0][(k / 7) % 4];
        let is_confirmed = |k: usize| !k.is_multiple_of(7);
        let verdict = |(k, [x, y]): (usize, &[f64; 2])| Verdict {
            position: Some([x + 30.0 + if is_confirmed(k) { 0.0 } else { off(k) }, y - 4.0]),
            fit: is_confirmed(k).then_some(fit),
            ..Verdict::none(Rule::Matched)
        };
        let mut verdicts: Vec<Verdict> = positions.iter().enumerate().map(verdict).collect();
        reject_unconfirmed(&positions, &mut verdicts);
        for (k, verdict) in verdicts.iter().enumerate() {
            let stands = is_confirmed(k) || off(k) <= UNCONFIRMED_PX;
            assert_eq!(verdict.rule, if stands { Rule::Matched } else { Rule::NotConverged }, "{k}");
        }
    }

    #[test]
    fn what_the_geometry_refuses_is_not_added() {
        let (before, matches) = filled(1.5);
        assert_eq!(matches.len(), before);
        assert!(matches.iter().all(|m| m.fit.is_none()));
    }
}
