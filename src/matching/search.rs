//! The best candidate of each point in its search window, and the rules it must pass.

use super::index::PositionIndex;
use super::positions::check_positions;
use super::rules::judge;
use super::{Denominator, Expectation, MatchOptions, MatchSet, Rule, Verdict};
use crate::error::refuse;
use crate::{Descriptor, Error, Input, InterestPoint, Refusal};

/// A right point in the search window of a left one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Candidate {
    /// Index of the right point.
    pub right: usize,
    /// The dissimilarity; 0 for equal descriptors, at most 14.
    pub measure: f64,
}

/// Points with their descriptors, `None` where a point has none.
pub type Described<'a> = (&'a [InterestPoint], &'a [Option<Descriptor>]);

/// Matches described points.
///
/// For each left point the candidates are the right points with |Δcol| and |Δrow| up to (search - 1) / 2 of its position plus the
/// expected offset. The least measure wins if it is below `max_measure`; it is ambiguous when it exceeds `ambiguity` times the second
/// least; of several left points that win the same right point the least measure keeps it (of equal ones the first); last, matches
/// whose y-parallax deviates from that of their neighbours are refused. Every refused point keeps the rule that refused it.
///
/// # Errors
/// [`Error::InvalidOption`]; [`Error::InvalidInput`] where points and descriptors differ in number or positions are not finite.
///
/// # Source
/// Zahran 2007, section 4 and eqs. 15, 16, with max(|p|, |q|) for the printed denominator, which fails for signed moments.
pub fn match_points<'a>(
    left: Described<'a>,
    right: Described<'a>,
    expected: impl Into<Expectation<'a>>,
    options: &MatchOptions,
) -> Result<MatchSet, Error> {
    let expected = expected.into();
    let search = Search::new(left, right, expected, options)?;
    let verdicts = (0..left.0.len()).map(|k| search.best_of(k)).collect();
    Ok(judge(left.0, verdicts, expected.offset, options))
}

/// All candidates of one left point, the best first; of equal measures the lower index.
///
/// # Errors
/// As [`match_points`]; [`Error::InvalidInput`] where `index` is not that of a left point.
pub fn candidates_of<'a>(
    index: usize,
    left: Described<'a>,
    right: Described<'a>,
    expected: impl Into<Expectation<'a>>,
    options: &MatchOptions,
) -> Result<Vec<Candidate>, Error> {
    let search = Search::new(left, right, expected.into(), options)?;
    if index >= left.0.len() {
        return refuse(Refusal::LeftPoint { index, count: left.0.len() });
    }
    let mut candidates = Vec::new();
    search.for_each_candidate(index, |right, measure| candidates.push(Candidate { right, measure }));
    candidates.sort_by(|a, b| a.measure.total_cmp(&b.measure).then(a.right.cmp(&b.right)));
    Ok(candidates)
}

/// A descriptor with a zero beside it, so that it is compared in pairs.
type Padded = [f64; 8];

/// What stands ready to look candidates up.
struct Search<'a> {
    left: &'a [InterestPoint],
    right: &'a [InterestPoint],
    left_descriptors: Vec<Option<Padded>>,
    right_descriptors: Vec<Padded>,
    right_index: PositionIndex,
    expected: Expectation<'a>,
    least_denominators: Padded,
    options: &'a MatchOptions,
}

impl<'a> Search<'a> {
    fn new(left: Described<'a>, right: Described<'a>, expected: Expectation<'a>, options: &'a MatchOptions) -> Result<Self, Error> {
        options.check_ranges()?;
        check_described(Input::LeftPoints, left)?;
        check_described(Input::RightPoints, right)?;
        let floor = match options.denominator {
            Denominator::Maxabs => [0.0; 7],
            Denominator::Floor => median_magnitudes(left.1.iter().chain(right.1).flatten()),
        };
        let described = right.0.iter().enumerate().filter(|(k, _)| right.1[*k].is_some());
        Ok(Self {
            left: left.0,
            right: right.0,
            left_descriptors: left.1.iter().map(|d| d.as_ref().map(padded)).collect(),
            right_descriptors: right.1.iter().map(|d| d.as_ref().map_or([0.0; 8], padded)).collect(),
            right_index: PositionIndex::new(described.map(|(k, p)| (k, p.x, p.y))),
            expected,
            // Where both moments are 0 their term is 0 / MIN_POSITIVE = 0.
            least_denominators: padded(&floor).map(|f| f.max(f64::MIN_POSITIVE)),
            options,
        })
    }

    fn for_each_candidate(&self, left: usize, mut visit: impl FnMut(usize, f64)) {
        let Some(descriptor) = &self.left_descriptors[left] else { return };
        let point = self.left[left];
        let region = self.expected.region(point.x, point.y, self.options.search / 2);
        self.right_index.within(region.centre[0], region.centre[1], region.reach as f64, |right| {
            if region.allows(self.right[right].x, self.right[right].y) {
                visit(right, dissimilarity(descriptor, &self.right_descriptors[right], &self.least_denominators));
            }
        });
    }

    /// The verdict before the rules that look at other matches.
    fn best_of(&self, left: usize) -> Verdict {
        if self.left_descriptors[left].is_none() {
            return Verdict::none(Rule::NoDescriptor);
        }
        let mut verdict = Verdict::none(Rule::NoCandidate);
        self.for_each_candidate(left, |right, measure| {
            // Of equal measures the lower index wins, in whatever order they are visited.
            if measure < verdict.measure || (measure == verdict.measure && verdict.best.is_some_and(|best| right < best)) {
                (verdict.second, verdict.measure, verdict.best) = (verdict.measure, measure, Some(right));
            } else if measure < verdict.second {
                verdict.second = measure;
            }
        });
        if let Some(best) = verdict.best {
            verdict.position = Some([self.right[best].x, self.right[best].y]);
            verdict.rule = if verdict.measure.partial_cmp(&self.options.max_measure) != Some(std::cmp::Ordering::Less) {
                Rule::Threshold
            } else if self.options.is_ambiguous(verdict.measure, verdict.second) {
                Rule::Ambiguous
            } else {
                Rule::Matched
            };
        }
        verdict
    }
}

/// Σ |p - q| / max(|p|, |q|, least), with 0 for 0 / 0.
fn dissimilarity(p: &Padded, q: &Padded, least: &Padded) -> f64 {
    let larger = |a: f64, b: f64| if a > b { a } else { b };
    let t: Padded = std::array::from_fn(|k| (p[k] - q[k]).abs() / larger(larger(p[k].abs(), q[k].abs()), least[k]));
    ((t[0] + t[2]) + (t[4] + t[6])) + ((t[1] + t[3]) + (t[5] + t[7]))
}

fn padded(descriptor: &Descriptor) -> Padded {
    std::array::from_fn(|k| descriptor.get(k).copied().unwrap_or(0.0))
}

/// The median of |d_k| of each component, 0 without descriptors; of an even number the mean of the middle two.
fn median_magnitudes<'d>(descriptors: impl Iterator<Item = &'d Descriptor> + Clone) -> Descriptor {
    std::array::from_fn(|k| {
        let mut magnitudes: Vec<f64> = descriptors.clone().map(|d| d[k].abs()).collect();
        crate::math::median(&mut magnitudes).unwrap_or(0.0)
    })
}

fn check_described(input: Input, (points, descriptors): Described<'_>) -> Result<(), Error> {
    if points.len() != descriptors.len() {
        return refuse(Refusal::DescribedPoints { input, points: points.len(), descriptors: descriptors.len() });
    }
    check_positions(input, points)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::OffsetField;

    fn point(x: f64, y: f64) -> InterestPoint {
        InterestPoint { x, y, value: 1.0 }
    }

    fn uniform(v: f64) -> Option<Descriptor> {
        Some([v; 7])
    }

    fn options() -> MatchOptions {
        MatchOptions { parallax_neighbours: 0, ..MatchOptions::default() }
    }

    fn rules(left: Described<'_>, right: Described<'_>, options: &MatchOptions) -> Vec<Rule> {
        let set = match_points(left, right, &OffsetField::constant(0.0, 0.0), options).unwrap();
        let c = set.counts;
        assert_eq!(c.matches, set.matches.len());
        let counted = c.matches + c.no_descriptor + c.no_candidate + c.threshold + c.ambiguous + c.many_to_one + c.parallax;
        assert_eq!(counted, left.0.len());
        set.verdicts.iter().map(|v| v.rule).collect()
    }

    #[test]
    fn each_rule_refuses_what_it_should() {
        let left = [
            point(10.5, 10.5),
            point(50.5, 10.5),
            point(90.5, 10.5),
            point(130.5, 10.5),
            point(131.5, 10.5),
            point(170.5, 10.5),
            point(300.5, 10.5),
        ];
        let left_d = [uniform(1.0), uniform(1.0), uniform(1.0), uniform(1.0), uniform(1.05), None, uniform(1.0)];
        let right = [point(12.5, 10.5), point(50.5, 10.5), point(90.5, 10.5), point(91.5, 10.5), point(130.5, 10.5), point(170.5, 10.5)];
        let right_d = [uniform(1.1), uniform(9.0), uniform(1.1), uniform(1.105), uniform(1.06), uniform(1.0)];
        let expected =
            [Rule::Matched, Rule::Threshold, Rule::Ambiguous, Rule::ManyToOne, Rule::Matched, Rule::NoDescriptor, Rule::NoCandidate];
        assert_eq!(rules((&left, &left_d), (&right, &right_d), &options()), expected);
    }

    #[test]
    fn the_search_window_reaches_12_px_and_no_further() {
        let left = [point(50.5, 50.5)];
        for (dx, dy, inside) in [(12.0, -12.0, true), (13.0, 0.0, false), (0.0, 13.0, false)] {
            let right = [point(50.5 + dx, 50.5 + dy)];
            let rule = rules((&left, &[uniform(1.0)]), (&right, &[uniform(1.0)]), &options())[0];
            assert_eq!(rule == Rule::Matched, inside);
        }
    }

    #[test]
    fn a_measure_equal_to_the_threshold_is_refused() {
        // Each of the seven terms is |1 - 2| / 2.
        let (left, right) = ([point(5.5, 5.5)], [point(5.5, 5.5)]);
        let with = |max_measure| rules((&left, &[uniform(1.0)]), (&right, &[uniform(2.0)]), &MatchOptions { max_measure, ..options() })[0];
        assert_eq!((with(3.5), with(3.6)), (Rule::Threshold, Rule::Matched));
    }

    #[test]
    fn signed_and_zero_moments_give_terms_from_0_to_2() {
        let least = [f64::MIN_POSITIVE; 8];
        let p = padded(&[1.0, -1.0, 0.0, 2.0, 0.0, 3.0, 1.0]);
        let q = padded(&[-1.0, -1.0, 0.0, 1.0, 5.0, 3.0, 0.0]);
        assert_eq!(dissimilarity(&p, &q, &least), 2.0 + 0.5 + 1.0 + 1.0);
        assert_eq!(dissimilarity(&p, &p, &least), 0.0);
    }

    #[test]
    fn the_floor_is_the_median_magnitude_over_both_images() {
        let (left, right) = ([point(5.5, 5.5), point(200.5, 5.5)], [point(5.5, 5.5), point(200.5, 5.5)]);
        let (left_d, right_d) = ([uniform(0.1), uniform(-4.0)], [uniform(0.2), uniform(4.0)]);
        let floor = MatchOptions { denominator: Denominator::Floor, ..options() };
        let set = match_points((&left, &left_d), (&right, &right_d), &OffsetField::constant(0.0, 0.0), &floor).unwrap();
        // Magnitudes 0.1 0.2 4 4: median 2.1.
        assert!((set.verdicts[0].measure - 7.0 * 0.1 / 2.1).abs() < 1e-12);
        assert_eq!(set.verdicts[1].measure, 14.0);
    }

    #[test]
    fn candidates_come_best_first_and_agree_with_the_verdict() {
        let left = [point(50.5, 50.5)];
        let right = [point(45.5, 50.5), point(50.5, 55.5), point(52.5, 48.5), point(99.5, 50.5)];
        let right_d = [uniform(1.3), uniform(1.1), uniform(1.2), uniform(1.0)];
        let field = OffsetField::constant(0.0, 0.0);
        let all = candidates_of(0, (&left, &[uniform(1.0)]), (&right, &right_d), &field, &options()).unwrap();
        assert_eq!(all.iter().map(|c| c.right).collect::<Vec<_>>(), [1, 2, 0]);
        let set = match_points((&left, &[uniform(1.0)]), (&right, &right_d), &field, &options()).unwrap();
        assert_eq!((set.verdicts[0].best, set.verdicts[0].measure, set.verdicts[0].second), (Some(1), all[0].measure, all[1].measure));
    }

    #[test]
    fn bad_input_is_named() {
        let field = OffsetField::constant(0.0, 0.0);
        let (far, near) = ([point(f64::NAN, 0.0)], [point(1.5, 1.5)]);
        let d = [uniform(1.0)];
        assert!(matches!(
            match_points((&far, &d), (&near, &d), &field, &options()),
            Err(Error::InvalidInput { refusal: Refusal::FarPosition { input: Input::LeftPoints, .. } })
        ));
        assert!(matches!(
            match_points((&near, &d), (&near, &[]), &field, &options()),
            Err(Error::InvalidInput { refusal: Refusal::DescribedPoints { input: Input::RightPoints, .. } })
        ));
        assert!(matches!(candidates_of(1, (&near, &d), (&near, &d), &field, &options()), Err(Error::InvalidInput { .. })));
        let nan = MatchOptions { max_measure: f64::NAN, ..options() };
        assert!(matches!(
            match_points((&near, &d), (&near, &d), &field, &nan),
            Err(Error::InvalidOption { field: "matching.max_measure", .. })
        ));
    }

    #[test]
    fn nothing_to_match_gives_nothing() {
        let set = match_points((&[], &[]), (&[], &[]), &OffsetField::constant(0.0, 0.0), &options()).unwrap();
        assert_eq!(set.matches, []);
    }
}
