//! The best of many models from random minimal samples, whatever is estimated.

use super::Random;
use nalgebra::Matrix3;
use std::ops::Range;

/// Number of observations whose distances are taken at once, and of terms whose product stays within the range of numbers.
pub(crate) const BLOCK: usize = 16;

/// Largest d²/s² that counts: how far off gross errors are must not decide between models. Its 16th power is a number.
const LARGEST_RATIO: f64 = 1e3;

/// An observation agrees with a model within this many standard errors.
const AGREEING: f64 = 3.0;

/// A draft as good as the best so far fails the screening with at most the inverse of this probability.
const SCREENING: f64 = 500.0;

/// What is estimated, and from which observations: in random order, so that a few in a row stand for all.
pub(crate) trait Problem {
    /// The refined model; drafts are matrices.
    type Model: Clone;
    /// Observations in a minimal sample.
    const SAMPLE: usize;

    /// Number of observations.
    fn count(&self) -> usize;
    /// Bound of the indices that samples are drawn from.
    fn drawn_from(&self) -> usize {
        self.count()
    }
    /// Gives every model that fits a minimal sample of these indices.
    fn drafts(&self, sample: &[usize], take: &mut dyn FnMut(Matrix3<f64>));
    /// Squares of the distances of consecutive observations from a draft; `range` has up to [`BLOCK`].
    fn squares(&self, draft: &Matrix3<f64>, range: Range<usize>, squares: &mut [f64; BLOCK]);
    /// The model near a draft that most observations agree with, found at the scale `scale` and with its own, which is not above it.
    /// `None` where there is none.
    fn refined(&self, draft: &Matrix3<f64>, scale: f64) -> Option<Candidate<Self::Model>>;
    /// The matrix of a model.
    fn draft_of(&self, model: &Self::Model) -> Matrix3<f64>;
    /// What counts beside the distances, as much as a gross error of each observation it concerns.
    fn penalty(&self, model: &Self::Model, scale: f64) -> f64;
}

/// A model, and about how well the observations agree with it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Candidate<M> {
    pub model: M,
    /// Standard error of an observation.
    pub scale: f64,
}

/// When the search ends, and what counts as better.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Search {
    pub seed: u32,
    /// Probability of missing a sample of good observations only.
    pub missing: f64,
    pub least_samples: usize,
    pub most_samples: usize,
    /// By how much a cost must be lower to count as better.
    pub margin: f64,
    /// The scale before anything is known.
    pub scale: f64,
}

/// Finds the model by random sampling; `first`, where given, is displaced only by a clearly better one. `None` where no sample gave a model.
///
/// The cost of a model is Σ ln(1 + d²/s²) over all distances d: it grows so slowly that gross errors hardly weigh, and it needs no threshold;
/// the scale s follows the best model so far. Drafts are screened on a few observations first, and given up as soon as they cost more than the best
/// draft; one that does not is refined.
///
/// # Source
/// Fischler & Bolles 1981 (random samples); Chum, Matas & Kittler 2003 (local optimisation); Matas & Chum 2005, Randomized RANSAC with
/// sequential probability ratio test (screening).
pub(crate) fn consensus<P: Problem>(problem: &P, first: Option<Candidate<P::Model>>, search: &Search) -> Option<Candidate<P::Model>> {
    let mut random = Random::new(search.seed);
    let count = problem.drawn_from();
    let mut best = first;
    let mut state = State { problem, screening: Screening::new(), lowest: f64::INFINITY };
    let mut needed = best.as_ref().map_or(search.most_samples, |best| search.needed(problem, best));
    let mut sample = vec![0; P::SAMPLE];
    let mut drafts = Vec::new();
    let mut drawn = 0;
    while drawn < needed && count >= P::SAMPLE {
        drawn += 1;
        random.draw(count, &mut sample);
        drafts.clear();
        problem.drafts(&sample, &mut |draft| drafts.push(draft));
        for draft in &drafts {
            let scale = best.as_ref().map_or(search.scale, |best| best.scale);
            let Some((cost, agreeing)) = state.judge(draft, scale, drawn) else { continue };
            state.lowest = cost;
            state.screening.good = agreeing;
            let Some(candidate) = problem.refined(draft, scale) else { continue };
            if best.as_ref().is_none_or(|best| state.is_better(&candidate, best, search.margin)) {
                // The scale has changed, and the costs with it.
                (state.lowest, state.screening.good) = cost_of(problem, draft, candidate.scale);
                needed = search.needed(problem, &candidate);
                best = Some(candidate);
            }
        }
    }
    best
}

impl Search {
    fn needed<P: Problem>(&self, problem: &P, best: &Candidate<P::Model>) -> usize {
        let (_, share) = cost_of(problem, &problem.draft_of(&best.model), best.scale);
        let all_good = (0..P::SAMPLE).fold(1.0, |product, _| product * share);
        if all_good >= 1.0 {
            return self.least_samples;
        }
        let needed = libm::log(self.missing) / libm::log1p(-all_good);
        (needed.ceil() as usize).clamp(self.least_samples, self.most_samples)
    }
}

/// Where the search stands with drafts.
struct State<'a, P> {
    problem: &'a P,
    screening: Screening,
    /// Cost of the best draft at the scale of the best model.
    lowest: f64,
}

impl<P: Problem> State<'_, P> {
    /// Cost and share of agreeing observations of a draft that costs less than all before it; `None` for the others.
    fn judge(&mut self, draft: &Matrix3<f64>, scale: f64, turn: usize) -> Option<(f64, f64)> {
        let blocks = self.problem.count().div_ceil(BLOCK);
        // Another start each time: no few observations decide on all drafts.
        let start = turn % blocks;
        let mut sum = Sum::new(scale);
        let steps = self.screening.steps();
        let mut ratio = 0.0;
        for block in (start..blocks).chain(0..start) {
            let (tested, agreed) = sum.add(self.problem, draft, block);
            if let Some([agreeing, deviating]) = steps {
                ratio += agreeing * agreed as f64 + deviating * (tested - agreed) as f64;
                if ratio > 1.0 {
                    self.screening.learn(sum.tested, sum.agreeing);
                    return None;
                }
            }
            if sum.cost.is_nan() || sum.cost >= self.lowest {
                self.screening.learn(sum.tested, sum.agreeing);
                return None;
            }
        }
        Some((sum.cost, sum.share()))
    }

    /// Compares at the smaller scale: each at its own, a poor model with a large scale would cost no more than a good one.
    fn is_better(&self, candidate: &Candidate<P::Model>, best: &Candidate<P::Model>, margin: f64) -> bool {
        let scale = candidate.scale.min(best.scale);
        let cost = |model: &P::Model| cost_of(self.problem, &self.problem.draft_of(model), scale).0 + self.problem.penalty(model, scale);
        cost(&candidate.model) < cost(&best.model) - margin
    }
}

/// Cost of a matrix and the share of observations that agree with it.
fn cost_of<P: Problem>(problem: &P, draft: &Matrix3<f64>, scale: f64) -> (f64, f64) {
    let mut sum = Sum::new(scale);
    for block in 0..problem.count().div_ceil(BLOCK) {
        sum.add(problem, draft, block);
    }
    (if sum.cost.is_nan() { f64::INFINITY } else { sum.cost }, sum.share())
}

/// A cost on the way.
struct Sum {
    weight: f64,
    cost: f64,
    tested: usize,
    agreeing: usize,
}

impl Sum {
    fn new(scale: f64) -> Self {
        Self { weight: 1.0 / (scale * scale), cost: 0.0, tested: 0, agreeing: 0 }
    }

    /// Takes a block; gives how many observations it has and how many of them agree.
    fn add<P: Problem>(&mut self, problem: &P, draft: &Matrix3<f64>, block: usize) -> (usize, usize) {
        let first = block * BLOCK;
        let length = BLOCK.min(problem.count() - first);
        let mut squares = [0.0; BLOCK];
        problem.squares(draft, first..first + length, &mut squares);
        let (mut product, mut agreed) = (1.0, 0);
        for square in &squares[..length] {
            let ratio = (square * self.weight).min(LARGEST_RATIO);
            product *= 1.0 + ratio;
            agreed += usize::from(ratio <= AGREEING * AGREEING);
        }
        // The logarithm of the product is the sum of the logarithms, at a sixteenth of the price.
        self.cost += libm::log(product);
        self.tested += length;
        self.agreeing += agreed;
        (length, agreed)
    }

    fn share(&self) -> f64 {
        self.agreeing as f64 / self.tested.max(1) as f64
    }
}

/// Wald's sequential test of whether a draft is as good as the best one or like the many that are none.
struct Screening {
    /// Share of observations that agree with the best draft.
    good: f64,
    /// Observations that drafts were given up on, and how many of these agreed.
    tested: f64,
    agreed: f64,
}

impl Screening {
    fn new() -> Self {
        // As if 10 of 200 had agreed by chance.
        Self { good: 0.0, tested: 200.0, agreed: 10.0 }
    }

    /// What an agreeing and a deviating observation add to the logarithm of the likelihood ratio, in units of the limit; `None` where the two
    /// kinds of drafts are too alike.
    fn steps(&self) -> Option<[f64; 2]> {
        let bad = self.agreed / self.tested;
        let good = self.good.min(0.99);
        let limit = libm::log(SCREENING);
        (good > 1.5 * bad).then(|| [libm::log(bad / good) / limit, libm::log((1.0 - bad) / (1.0 - good)) / limit])
    }

    fn learn(&mut self, tested: usize, agreed: usize) {
        self.tested += tested as f64;
        self.agreed += agreed as f64;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Straight lines through points: a x + b y + c = 0 in the first row of the matrix, the normal of length 1.
    struct Lines(Vec<[f64; 2]>);

    impl Problem for Lines {
        type Model = Matrix3<f64>;
        const SAMPLE: usize = 2;

        fn count(&self) -> usize {
            self.0.len()
        }

        fn drafts(&self, sample: &[usize], take: &mut dyn FnMut(Matrix3<f64>)) {
            let [[x, y], [u, v]] = [self.0[sample[0]], self.0[sample[1]]];
            let length = ((u - x) * (u - x) + (v - y) * (v - y)).sqrt();
            let (a, b) = ((v - y) / length, (x - u) / length);
            take(Matrix3::new(a, b, -a * x - b * y, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0));
        }

        fn squares(&self, draft: &Matrix3<f64>, range: Range<usize>, squares: &mut [f64; BLOCK]) {
            for (square, [x, y]) in squares.iter_mut().zip(&self.0[range]) {
                let distance = draft[(0, 0)] * x + draft[(0, 1)] * y + draft[(0, 2)];
                *square = distance * distance;
            }
        }

        fn refined(&self, draft: &Matrix3<f64>, scale: f64) -> Option<Candidate<Matrix3<f64>>> {
            Some(Candidate { model: *draft, scale })
        }

        fn draft_of(&self, model: &Matrix3<f64>) -> Matrix3<f64> {
            *model
        }

        fn penalty(&self, _: &Matrix3<f64>, _: f64) -> f64 {
            0.0
        }
    }

    const SEARCH: Search = Search { seed: 1, missing: 1e-3, least_samples: 5, most_samples: 5000, margin: 0.0, scale: 0.01 };

    /// Points of y = 0.5 x - 0.2 within 0.01, a share of them anywhere in -1..1.
    fn points(count: usize, strangers: f64) -> Lines {
        let mut random = Random::new(4);
        let mut uniform = || random.below(1 << 20) as f64 / (1 << 19) as f64 - 1.0;
        let mut of_line = |k: usize| {
            let x = uniform();
            [x, if (k as f64) < strangers * count as f64 { uniform() } else { 0.5 * x - 0.2 + 0.01 * uniform() }]
        };
        let mut all: Vec<[f64; 2]> = (0..count).map(&mut of_line).collect();
        Random::new(9).shuffle(&mut all);
        Lines(all)
    }

    #[test]
    fn the_line_of_a_fifth_of_the_points_is_found() {
        for strangers in [0.0, 0.5, 0.8] {
            let problem = points(500, strangers);
            let found = consensus(&problem, None, &SEARCH).unwrap().model;
            let (slope, height) = (-found[(0, 0)] / found[(0, 1)], -found[(0, 2)] / found[(0, 1)]);
            assert!((slope - 0.5).abs() < 0.02 && (height + 0.2).abs() < 0.01, "{strangers}: {slope} {height}");
        }
    }

    #[test]
    fn screening_gives_up_drafts_that_the_whole_cost_would_give_up_too() {
        let problem = points(500, 0.6);
        let drafts: Vec<Matrix3<f64>> = (0..400)
            .map(|k| {
                let mut draft = Matrix3::zeros();
                problem.drafts(&[k, k + 57], &mut |found| draft = found);
                draft
            })
            .collect();
        let mut screened = State { problem: &problem, screening: Screening::new(), lowest: f64::INFINITY };
        let mut lowest = f64::INFINITY;
        let mut missed = 0;
        for (turn, draft) in drafts.iter().enumerate() {
            let judged = screened.judge(draft, 0.01, turn);
            let cost = cost_of(&problem, draft, 0.01).0;
            if let Some((cost, good)) = judged {
                (screened.lowest, screened.screening.good) = (cost, good);
            }
            missed += usize::from(cost < lowest - 1e-9 && judged.is_none());
            lowest = lowest.min(cost);
        }
        assert!(missed <= 1 && (screened.lowest - lowest).abs() < 1e-6 * lowest, "{missed} missed, {} for {lowest}", screened.lowest);
        assert!(screened.screening.tested > 5000.0, "nothing was screened");
    }

    #[test]
    fn too_few_points_give_nothing() {
        assert!(consensus(&Lines(vec![[0.0, 0.0]]), None, &SEARCH).is_none());
        assert!(consensus(&Lines(Vec::new()), None, &SEARCH).is_none());
    }
}
