//! Observations that were given more than once: they are one observation, which a second copy does not make more precise.

use super::Observation;
use std::cmp::Ordering;

/// The different ones of some observations, in the order of the first copies.
#[derive(Debug)]
pub(super) struct Different {
    /// How many there are.
    pub number: usize,
    /// For each of all observations its place among the different ones.
    pub place: Vec<usize>,
    /// For each of all observations whether it is the first of its copies.
    pub is_first: Vec<bool>,
}

impl Different {
    /// Coordinates that are the same to the last bit are copies.
    pub fn of(all: &[Observation]) -> Self {
        let coordinates = |k: usize| [all[k].left[0], all[k].left[1], all[k].right[0], all[k].right[1]];
        let compare = |a: usize, b: usize| coordinates(a).partial_cmp(&coordinates(b)).unwrap_or(Ordering::Equal);
        let mut order: Vec<usize> = (0..all.len()).collect();
        order.sort_unstable_by(|a, b| compare(*a, *b).then(a.cmp(b)));
        let mut first: Vec<usize> = (0..all.len()).collect();
        for pair in order.windows(2) {
            if compare(pair[0], pair[1]) == Ordering::Equal {
                first[pair[1]] = first[pair[0]];
            }
        }
        let is_first: Vec<bool> = first.iter().enumerate().map(|(k, first)| k == *first).collect();
        let (mut number, mut place) = (0, vec![0; all.len()]);
        for k in 0..all.len() {
            if is_first[k] {
                place[k] = number;
                number += 1;
            } else {
                place[k] = place[first[k]];
            }
        }
        Self { number, place, is_first }
    }

    /// How many observations are copies of others.
    pub fn copies(&self) -> usize {
        self.place.len() - self.number
    }

    /// The weights of the different ones by those of all: where copies have different weights, the largest.
    pub fn weights(&self, all: impl Iterator<Item = f64>) -> Vec<f64> {
        let mut weights = vec![0.0_f64; self.number];
        all.zip(&self.place).for_each(|(weight, place)| weights[*place] = weights[*place].max(weight));
        weights
    }

    /// For all observations what the different ones have.
    pub fn spread<T: Clone>(&self, values: &[T]) -> Vec<T> {
        self.place.iter().map(|k| values[*k].clone()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn copies_are_found_wherever_they_stand() {
        let one = |x: f64, weight| Observation { left: [x, 1.0], right: [2.0, 3.0], weight };
        let all = [one(5.0, 1.0), one(1.0, 1.0), one(5.0, 4.0), one(0.0, 1.0), one(1.0, 0.5)];
        let different = Different::of(&all);
        assert_eq!(different.place, [0, 1, 0, 2, 1]);
        assert_eq!(different.is_first, [true, true, false, true, false]);
        assert_eq!(different.weights(all.iter().map(|o| o.weight)), [4.0, 1.0, 1.0]);
        assert_eq!((different.copies(), different.spread(&["a", "b", "c"])), (2, vec!["a", "b", "a", "c", "b"]));
    }
}
