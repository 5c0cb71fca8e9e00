//! How probable it is that a ray belongs to its point, by how many of the point's other rays it is matched with.

use super::BlockMatches;
use super::pairs::PairTable;
use super::sets::RaySets;

/// A ray's matches with the other rays of its point, and how many there could be: the images that were matched with its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct Held {
    matched: u8,
    possible: u8,
}

/// Counts beyond this say nothing new.
const MOST: u8 = 31;
const SIDE: usize = MOST as usize + 1;

/// Steps of expectation and maximisation.
const STEPS: usize = 50;

/// Before any ray is seen: the share of rays that belong, and of possible matches that a ray has which does and does not belong; each with
/// the weight of as many rays or matches.
const PRIOR_BELONGS: [f64; 2] = [0.99, 100.0];
const PRIOR_MATCHED: [f64; 2] = [0.7, 20.0];
const PRIOR_BY_CHANCE: [f64; 2] = [0.02, 100.0];

/// Shares by which rays are judged.
#[derive(Debug, Clone, Copy)]
struct Shares {
    belongs: f64,
    matched: f64,
    by_chance: f64,
}

impl Shares {
    /// The match that tied the ray to its point is there in any case: only the others tell.
    fn belongs(&self, held: Held) -> f64 {
        let others = f64::from(held.matched) - 1.0;
        let missing = f64::from(held.possible) - f64::from(held.matched);
        let log_odds = libm::log(self.belongs / (1.0 - self.belongs))
            + others * libm::log(self.matched / self.by_chance)
            + missing * libm::log((1.0 - self.matched) / (1.0 - self.by_chance));
        1.0 / (1.0 + libm::exp(-log_odds))
    }
}

/// For each node the probability that it belongs to its set: a mixture of two binomial distributions, over the nodes of sets of three and
/// more. Of a set of two, of a node alone, and of the sets whose roots are `dropped`, it is that of the most probable match.
pub(super) fn belonging(matches: &BlockMatches, sets: &mut RaySets<'_>, probability: &[f32], joining: &[u32], dropped: &[u32]) -> Vec<f32> {
    let mut best = vec![0.0_f32; matches.nodes()];
    for edge in joining {
        for node in matches.edges()[*edge as usize].nodes {
            best[node as usize] = best[node as usize].max(probability[*edge as usize]);
        }
    }
    let held = held(matches, sets, dropped);
    let shares = estimate(&held);
    held.iter().zip(best).map(|(held, best)| if held.possible < 2 { best } else { shares.belongs(*held) as f32 }).collect()
}

fn held(matches: &BlockMatches, sets: &mut RaySets<'_>, dropped: &[u32]) -> Vec<Held> {
    let pairs = PairTable::new(matches);
    let mut held = vec![Held::default(); matches.nodes()];
    for edge in matches.edges() {
        let [a, b] = edge.nodes;
        if sets.root(a) == sets.root(b) {
            for node in [a, b] {
                held[node as usize].matched = (held[node as usize].matched + 1).min(MOST);
            }
        }
    }
    sets.each(|nodes| {
        if dropped.binary_search(&sets.root_of(nodes[0])).is_err() {
            for node in nodes {
                let image = matches.image_of(*node);
                let possible = nodes.iter().filter(|other| pairs.has(image, matches.image_of(**other))).count();
                held[*node as usize].possible = possible.min(MOST as usize) as u8;
            }
        }
    });
    // A node that is matched twice with one image has more matches than images.
    held.iter_mut().for_each(|held| held.matched = held.matched.min(held.possible).max(1));
    held
}

fn estimate(held: &[Held]) -> Shares {
    let mut table = vec![0_u64; SIDE * SIDE];
    held.iter().filter(|held| held.possible >= 2).for_each(|h| table[h.possible as usize * SIDE + h.matched as usize] += 1);
    let cell = |index: usize| Held { possible: (index / SIDE) as u8, matched: (index % SIDE) as u8 };
    let mut shares = Shares { belongs: PRIOR_BELONGS[0], matched: PRIOR_MATCHED[0], by_chance: PRIOR_BY_CHANCE[0] };
    for _ in 0..STEPS {
        let [mut belongs, mut matched, mut by_chance] =
            [PRIOR_BELONGS, PRIOR_MATCHED, PRIOR_BY_CHANCE].map(|[share, weight]| [share * weight, weight]);
        for (index, count) in table.iter().enumerate().filter(|(_, count)| **count > 0) {
            let (held, count) = (cell(index), *count as f64);
            let p = shares.belongs(held);
            let (others, trials) = (f64::from(held.matched) - 1.0, f64::from(held.possible) - 1.0);
            belongs = [belongs[0] + count * p, belongs[1] + count];
            matched = [matched[0] + count * p * others, matched[1] + count * p * trials];
            by_chance = [by_chance[0] + count * (1.0 - p) * others, by_chance[1] + count * (1.0 - p) * trials];
        }
        let share = |[part, whole]: [f64; 2]| (part / whole).clamp(0.001, 0.999);
        let matched = share(matched);
        shares = Shares { belongs: share(belongs), matched, by_chance: share(by_chance).min(0.5 * matched) };
    }
    shares
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_that_hang_by_one_match_of_many_are_told_from_the_rest() {
        let held = |matched, possible, count| std::iter::repeat_n(Held { matched, possible }, count);
        let rays: Vec<Held> =
            held(8, 9, 800).chain(held(9, 9, 700)).chain(held(6, 9, 300)).chain(held(1, 9, 60)).chain(held(2, 9, 3)).collect();
        let shares = estimate(&rays);
        assert!((shares.belongs - 1800.0 / 1863.0).abs() < 0.005, "{shares:?}");
        assert!(shares.belongs(Held { matched: 6, possible: 9 }) > 0.999);
        assert!(shares.belongs(Held { matched: 2, possible: 9 }) < 0.01);
        assert!(shares.belongs(Held { matched: 2, possible: 2 }) > 0.99);
    }
}
