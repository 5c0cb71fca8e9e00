//! How probable it is that a match is right, from the triangles around all matches: a mixture of two multinomial distributions.

use super::BlockMatches;
use super::evidence::{Evidence, MOST};
use serde::{Deserialize, Serialize};

/// What the matches of a block say about their own reliability.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct MatchReliability {
    /// Share of right matches among those about which a third image says something.
    pub right: f64,
    /// The same among the others.
    pub right_alone: f64,
    /// Shares of the triangles over a right match that close, that stay open, and that miss a side.
    pub triangles_right: [f64; 3],
    /// The same over a wrong match, which closes them by chance or by repetition.
    pub triangles_wrong: [f64; 3],
    /// Matches about which a third image says something.
    pub observed: usize,
}

/// Steps of expectation and maximisation, and the change of a share below which they end.
const MOST_STEPS: usize = 200;
const SETTLED: f64 = 1e-9;

/// The expected share of right matches counts as much as this many matches.
const PRIOR_MATCHES: f64 = 20.0;

/// How triangles are taken to be before any is seen, and the number of triangles as which that counts.
const PRIOR_RIGHT: [f64; 3] = [0.6, 0.1, 0.3];
const PRIOR_WRONG: [f64; 3] = [0.01, 0.39, 0.6];
const PRIOR_TRIANGLES: f64 = 20.0;

/// No share is taken for certain.
const LEAST_SHARE: f64 = 0.001;

/// Right and wrong matches of the triangles that they have: the table's side.
const SIDE: usize = MOST as usize + 1;

/// The shares of all matches, by expectation and maximisation over the table of how many matches have which triangles.
///
/// `lone`: the share of features without a match. A wrong match joins two features of any kind; so the wrong ones about which no image says
/// anything are to the other wrong ones as the pairs of lone features are to the other pairs.
///
/// # Source
/// Dempster, Laird & Rubin 1977, Maximum likelihood from incomplete data via the EM algorithm; that triangles of matches tell right from
/// wrong: Zach, Klopschitz & Pollefeys 2010, Disambiguating visual relations using loop constraints.
pub(super) fn reliability(evidence: &[Evidence], lone: f64, expected_right: f64) -> MatchReliability {
    let mut table = vec![0_u64; SIDE * SIDE * SIDE];
    evidence.iter().for_each(|e| table[(e.closed as usize * SIDE + e.open as usize) * SIDE + e.missing as usize] += 1);
    let triangles = |cell: usize| [cell / SIDE / SIDE, cell / SIDE % SIDE, cell % SIDE].map(|count| count as f64);
    let cells: Vec<([f64; 3], f64)> =
        (1..table.len()).filter(|cell| table[*cell] > 0).map(|cell| (triangles(cell), table[cell] as f64)).collect();
    let observed = evidence.len() - table[0] as usize;
    let mut shares = MatchReliability {
        right: expected_right,
        right_alone: expected_right,
        triangles_right: PRIOR_RIGHT,
        triangles_wrong: PRIOR_WRONG,
        observed,
    };
    for _ in 0..MOST_STEPS {
        let next = step(&shares, &cells, expected_right);
        let change = (next.right - shares.right).abs() + (next.triangles_right[0] - shares.triangles_right[0]).abs();
        shares = next;
        if change < SETTLED {
            break;
        }
    }
    let wrong = (1.0 - shares.right) * observed as f64;
    shares.right_alone = right_alone(wrong, observed as f64, table[0] as f64, lone, expected_right);
    shares
}

fn step(shares: &MatchReliability, cells: &[([f64; 3], f64)], expected_right: f64) -> MatchReliability {
    let mut right = [expected_right * PRIOR_MATCHES, PRIOR_MATCHES];
    let mut triangles_right = PRIOR_RIGHT.map(|share| share * PRIOR_TRIANGLES);
    let mut triangles_wrong = PRIOR_WRONG.map(|share| share * PRIOR_TRIANGLES);
    for (triangles, count) in cells {
        let p = probability(shares, shares.right, *triangles);
        right = [right[0] + count * p, right[1] + count];
        for kind in 0..3 {
            triangles_right[kind] += count * p * triangles[kind];
            triangles_wrong[kind] += count * (1.0 - p) * triangles[kind];
        }
    }
    let normal = |counts: [f64; 3]| counts.map(|count| count / (counts[0] + counts[1] + counts[2]));
    let triangles_right = normal(triangles_right);
    let mut triangles_wrong = normal(triangles_wrong);
    // A wrong match never closes more often than a right one: that would only exchange the two names.
    if triangles_wrong[0] > 0.5 * triangles_right[0] {
        triangles_wrong[0] = 0.5 * triangles_right[0];
        triangles_wrong = normal(triangles_wrong);
    }
    let right = (right[0] / right[1]).clamp(LEAST_SHARE, 1.0 - LEAST_SHARE);
    MatchReliability { right, triangles_right, triangles_wrong, ..*shares }
}

fn right_alone(wrong: f64, observed: f64, alone: f64, lone: f64, expected_right: f64) -> f64 {
    let both_lone = (lone * lone).min(0.9);
    let told = observed / (observed + PRIOR_MATCHES);
    let wrong_alone = told * wrong * both_lone / (1.0 - both_lone) + (1.0 - told) * (1.0 - expected_right) * alone;
    (1.0 - wrong_alone / alone.max(1.0)).clamp(LEAST_SHARE, 1.0 - LEAST_SHARE)
}

/// The probability of each match, in their order.
pub(super) fn probabilities(matches: &BlockMatches, evidence: &[Evidence], shares: &MatchReliability) -> Vec<f32> {
    let mut found = Vec::with_capacity(evidence.len());
    for range in matches.pair_ranges() {
        let [right, alone] = right_in_pair(&evidence[range.clone()], shares);
        let of = |e: &Evidence| if e.is_none() { alone } else { probability(shares, right, triangles(e)) };
        found.extend(evidence[range].iter().map(|e| of(e) as f32));
    }
    found
}

/// The shares of right matches of one pair, with and without evidence: those of the block count as much as some matches of the pair.
fn right_in_pair(evidence: &[Evidence], shares: &MatchReliability) -> [f64; 2] {
    let told = evidence.iter().filter(|e| !e.is_none());
    let (right, count) = told.fold((0.0, 0.0), |(sum, n), e| (sum + probability(shares, shares.right, triangles(e)), n + 1.0));
    let share = (right + PRIOR_MATCHES * shares.right) / (count + PRIOR_MATCHES);
    let wronger = (1.0 - share) / (1.0 - shares.right);
    [share, 1.0 - (1.0 - shares.right_alone) * wronger].map(|p| p.clamp(LEAST_SHARE, 1.0 - LEAST_SHARE))
}

fn triangles(e: &Evidence) -> [f64; 3] {
    [e.closed, e.open, e.missing].map(f64::from)
}

/// The probability by Bayes's rule that a match with these triangles is right.
fn probability(shares: &MatchReliability, right: f64, triangles: [f64; 3]) -> f64 {
    let told = |kind: usize| triangles[kind] * libm::log(shares.triangles_right[kind] / shares.triangles_wrong[kind]);
    let log_odds = libm::log(right / (1.0 - right)) + told(0) + told(1) + told(2);
    1.0 / (1.0 + libm::exp(-log_odds))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_triangles_the_expected_share_stands() {
        let shares = reliability(&[Evidence::default(); 100], 0.5, 0.95);
        assert!((shares.right - 0.95).abs() < 1e-12 && (shares.right_alone - 0.95).abs() < 1e-12 && shares.observed == 0);
    }

    #[test]
    fn the_shares_of_a_mixture_are_found() {
        // Four triangles each; 600 right matches whose triangles close with 0.36, 400 wrong ones that never close.
        let binomial = [0.1678, 0.3775, 0.3185, 0.1194, 0.0168];
        let mut evidence = vec![Evidence { closed: 0, open: 4, missing: 0 }; 40_000];
        for (closed, share) in binomial.iter().enumerate() {
            let of = Evidence { closed: closed as u8, open: 4 - closed as u8, missing: 0 };
            evidence.extend(std::iter::repeat_n(of, (share * 60_000.0) as usize));
        }
        let shares = reliability(&evidence, 0.0, 0.95);
        assert!((shares.right - 0.6).abs() < 0.01 && (shares.triangles_right[0] - 0.36).abs() < 0.01, "{shares:?}");
        assert!(probability(&shares, shares.right, [1.0, 3.0, 0.0]) > 0.95, "{shares:?}");
        assert!(probability(&shares, shares.right, [0.0, 4.0, 0.0]) < 0.3);
    }

    #[test]
    fn of_wrong_matches_as_many_are_alone_as_join_lone_features() {
        assert!((right_alone(300.0, 1e9, 1000.0, 0.5, 0.95) - 0.9).abs() < 1e-6);
        assert!((right_alone(0.0, 0.0, 1000.0, 0.5, 0.95) - 0.95).abs() < 1e-12);
    }
}
