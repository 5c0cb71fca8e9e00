//! Seeded random numbers: the same seed gives the same numbers on every machine.

use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// A stream of random numbers.
pub(crate) struct Random(Pcg32);

impl Random {
    /// Any fixed stream serves; the seed chooses the place in it.
    const STREAM: u64 = 0x5f0e_7a3d_91c2_4b67;

    pub(crate) fn new(seed: u32) -> Self {
        Self(Pcg32::new(u64::from(seed), Self::STREAM))
    }

    /// A whole number from 0 to `bound` - 1; `bound` is from 1 to 2³².
    ///
    /// The high word of a product has a bias below `bound`/2³²: far below what sampling could notice.
    pub(crate) fn below(&mut self, bound: usize) -> usize {
        ((u64::from(self.0.next_u32()) * bound as u64) >> 32) as usize
    }

    /// Puts values into a random order.
    pub(crate) fn shuffle<T>(&mut self, values: &mut [T]) {
        for last in (1..values.len()).rev() {
            values.swap(last, self.below(last + 1));
        }
    }

    /// Fills `drawn` with different whole numbers from 0 to `bound` - 1; `bound` is at least as many.
    pub(crate) fn draw(&mut self, bound: usize, drawn: &mut [usize]) {
        for place in 0..drawn.len() {
            let mut candidate = self.below(bound);
            while drawn[..place].contains(&candidate) {
                candidate = self.below(bound);
            }
            drawn[place] = candidate;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_seed_gives_its_numbers_and_another_seed_others() {
        let draw = |seed| {
            std::array::from_fn::<usize, 8, _>({
                let mut random = Random::new(seed);
                move |_| random.below(1000)
            })
        };
        assert_eq!(draw(7), draw(7));
        assert_ne!(draw(7), draw(8));
    }

    #[test]
    fn drawn_numbers_are_different_and_cover_the_range() {
        let mut random = Random::new(1);
        let mut counts = [0; 6];
        for _ in 0..6000 {
            let mut drawn = [0; 5];
            random.draw(6, &mut drawn);
            for (place, value) in drawn.iter().enumerate() {
                assert!(!drawn[..place].contains(value));
                counts[*value] += 1;
            }
        }
        assert!(counts.iter().all(|count| (4800..5200).contains(count)), "{counts:?}");
    }

    #[test]
    fn shuffling_keeps_the_values() {
        let mut values: Vec<usize> = (0..100).collect();
        Random::new(3).shuffle(&mut values);
        assert!(values.iter().enumerate().any(|(place, value)| place != *value));
        values.sort_unstable();
        assert!(values.iter().enumerate().all(|(place, value)| place == *value));
    }
}
