//! The similarity on which most positions agree: wrong ones do not take part in it.

use super::similarity::Similarity;
use crate::math::{Random, dot3, median, minus, smallest};

/// A position with the one that was observed for it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pair {
    pub from: [f64; 3],
    pub to: [f64; 3],
    /// Standard error of the length of what is observed.
    pub sigma: f64,
}

/// Up to so many positions every three are tried, of more so many triples.
const FEW: usize = 12;
const TRIPLES: usize = 300;
/// Positions by which a triple is judged, about.
const JUDGES: usize = 500;
/// A position agrees within so many times the median distance, and always within so many of its standard errors: approximate blocks are bent.
pub(super) const MEDIANS: f64 = 10.0;
pub(super) const SIGMAS: f64 = 6.0;

/// The similarity of least squares by the positions that agree, and which do. `None` without extent.
///
/// # Source
/// Rousseeuw 1984, Least median of squares regression.
pub(super) fn robust_similarity(pairs: &[Pair]) -> Option<(Similarity, Vec<bool>)> {
    let mut similarity = best_of_three(pairs)?;
    let mut agree = vec![true; pairs.len()];
    // Of three the errors are in the similarity; of all that agree, they hardly are.
    for _ in 0..2 {
        let distances: Vec<f64> = pairs.iter().map(|pair| distance(&similarity, pair)).collect();
        let middle = median(&mut distances.clone())?;
        agree = distances.iter().zip(pairs).map(|(d, pair)| *d <= (MEDIANS * middle).max(SIGMAS * pair.sigma)).collect();
        let good: Vec<_> = pairs.iter().zip(&agree).filter(|(_, agrees)| **agrees).map(|(pair, _)| (pair.from, pair.to)).collect();
        similarity = Similarity::between(&good)?;
    }
    Some((similarity, agree))
}

/// The similarity of three positions by which the distances of more than half of all are least.
fn best_of_three(pairs: &[Pair]) -> Option<Similarity> {
    let n = pairs.len();
    if n < 3 {
        return None;
    }
    let judges: Vec<&Pair> = pairs.iter().step_by(n.div_ceil(JUDGES).max(1)).collect();
    // Three fit by themselves: that many more have to.
    let rank = ((judges.len() + 4) / 2).min(judges.len()) - 1;
    let mut best: Option<(Similarity, f64)> = None;
    for triple in triples(n) {
        let of_three = triple.map(|k| (pairs[k].from, pairs[k].to));
        let Some(similarity) = Similarity::between(&of_three) else { continue };
        let mut distances: Vec<f64> = judges.iter().map(|pair| distance(&similarity, pair)).collect();
        let reach = smallest(&mut distances, rank);
        if best.as_ref().is_none_or(|(_, least)| reach < *least) {
            best = Some((similarity, reach));
        }
    }
    best.map(|(similarity, _)| similarity)
}

fn triples(n: usize) -> Vec<[usize; 3]> {
    if n <= FEW {
        let from = |a: usize| (a + 1..n).flat_map(move |b| (b + 1..n).map(move |c| [a, b, c]));
        return (0..n).flat_map(from).collect();
    }
    let mut random = Random::new(n as u32);
    let draw = |_| {
        let mut triple = [0; 3];
        random.draw(n, &mut triple);
        triple
    };
    (0..TRIPLES).map(draw).collect()
}

fn distance(similarity: &Similarity, pair: &Pair) -> f64 {
    let d = minus(&pair.to, &similarity.point(&pair.from));
    dot3(&d, &d).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::turn_of;

    #[test]
    fn two_wrong_positions_in_five_do_not_move_the_similarity() {
        let wanted = Similarity { scale: 40.0, rotation: turn_of([0.3, -0.2, 2.0]), from: [0.0; 3], to: [500.0, -900.0, 700.0] };
        for n in [8, 10, 40] {
            let mut pairs: Vec<Pair> = (0..n)
                .map(|k| {
                    let from = [f64::from(k % 6), f64::from(k / 6) * 1.5, 0.1 * f64::from(k * k % 5)];
                    let noise = [0.3, -0.2, 0.4].map(|v| v * f64::from(k * 7 % 5 - 2));
                    let to = wanted.point(&from);
                    Pair { from, to: [0, 1, 2].map(|i| to[i] + noise[i]), sigma: 1.0 }
                })
                .collect();
            let wrong = (2 * n as usize / 5).min(n as usize / 2 - 2);
            for k in 0..wrong {
                pairs[2 * k + 1].to[k % 3] += [5e6, 300.0, -3000.0][k % 3];
            }
            let (found, agree) = robust_similarity(&pairs).unwrap();
            assert_eq!(agree.iter().filter(|agrees| !**agrees).count(), wrong, "{n}");
            assert!((0..wrong).all(|k| !agree[2 * k + 1]));
            let (a, b) = (found.point(&[3.0, 4.0, 0.0]), wanted.point(&[3.0, 4.0, 0.0]));
            assert!((0..3).all(|k| (a[k] - b[k]).abs() < 4.0), "{n}: {a:?} {b:?}");
        }
    }

    #[test]
    fn positions_without_extent_give_none() {
        assert!(robust_similarity(&[Pair { from: [1.0; 3], to: [2.0; 3], sigma: 1.0 }; 3]).is_none());
        assert!(robust_similarity(&[]).is_none());
    }
}
