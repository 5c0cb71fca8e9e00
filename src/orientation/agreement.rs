//! The largest set of few observations that agree with each other: none of its subsets agrees so much better that chance does not explain it.

use super::coplanarity::{Linearised, Unknowns};
use super::normals::{Matrix5, Normals};
use super::observed::{Limits, Weighted};
use super::robust_start::{Consensus, least_agreement};
use crate::math::{ln_choices, ln_f_above, student_limit};

/// Which observations agree.
///
/// From those that agree best with the start, a set grows by the observation that fits it best, until it holds all: an order in which gross errors
/// come last. Of these sets the largest is taken that none within it contradicts. A smaller set contradicts a larger one where its residuals
/// are so much smaller that of all subsets of its size none would have such by chance, with the probability that two good observations are
/// rejected by mistake: α₀². All observations that do not contradict each other are one set, however few of them agree well.
///
/// # Source
/// Atkinson & Riani 2000, Robust Diagnostic Regression Analysis (the forward search); the test is the F test of several observations that are
/// shifted (Cook & Weisberg 1982, Residuals and Influence in Regression, 2.2), with Bonferroni's bound over the choices of them.
pub(super) fn agreeing(observed: Weighted<'_>, start: &Consensus, limits: Limits) -> Vec<bool> {
    // What runs along the base says nothing against any pose.
    let mut accepted = vec![true; observed.rays.len()];
    let lines = lines(observed, &accepted, start);
    if let Some(course) = Course::of(&lines) {
        let kept = course.largest_consistent(limits);
        course.order[kept..].iter().for_each(|k| accepted[lines[*k].index] = false);
    }
    accepted
}

/// How many of the accepted observations agree so much better than all of them that chance hardly explains it, though not beyond doubt which
/// are right, and lead to an orientation outside the 95 % intervals of all; `None` where none do.
pub(super) fn contradicting(observed: Weighted<'_>, accepted: &[bool], start: &Consensus, limits: Limits) -> Option<usize> {
    let lines = lines(observed, accepted, start);
    let (course, kept) = (Course::of(&lines)?, lines.len());

    let freedom = kept.checked_sub(5).filter(|freedom| *freedom > 0)?;
    let reach = student_limit(0.05, freedom) * (course.square_sum(kept) / freedom as f64).sqrt();
    let (all, cofactors) = (course.steps[kept - course.first], course.cofactors);
    let lies_outside = |fewer: usize| {
        let moved = course.steps[fewer - course.first] - all;
        (0..5).any(|k| moved[k].abs() > reach * cofactors[(k, k)].sqrt())
    };
    let fewer = (course.first.max(6)..kept - 1).rev();
    fewer.filter(|fewer| course.contradicts(*fewer, kept, libm::log(limits.alpha0), limits)).find(|fewer| lies_outside(*fewer))
}

/// The linear conditions of the accepted observations at the start.
fn lines(observed: Weighted<'_>, accepted: &[bool], start: &Consensus) -> Vec<Line> {
    let tangents = start.model.tangents();
    let at = |ray| start.model.linearise(&tangents, ray, &start.model.project(ray).0);
    let all = observed.rays.iter().zip(observed.weights).zip(accepted).enumerate().filter(|(_, (_, accepted))| **accepted);
    all.filter_map(|(index, ((ray, weight), _))| Some(Line { index, line: at(ray)?, weight: *weight })).collect()
}

/// The linear condition of an observation.
struct Line {
    index: usize,
    line: Linearised,
    weight: f64,
}

impl Line {
    /// The misclosure after a step.
    fn residual(&self, step: &Unknowns) -> f64 {
        self.line.misclosure + self.line.by_unknowns.dot(step)
    }
}

/// The order in which observations come to agree, and the weighted square sums of the residuals on the way.
struct Course {
    order: Vec<usize>,
    first: usize,
    /// Of the first `first`, `first + 1`, … observations.
    square_sums: Vec<f64>,
    /// What these move the start by.
    steps: Vec<Unknowns>,
    /// N⁻¹ of all.
    cofactors: Matrix5,
}

impl Course {
    fn of(lines: &[Line]) -> Option<Self> {
        let first = least_agreement(lines.len());
        if lines.len() <= first {
            return None;
        }
        let mut step = Unknowns::zeros();
        let mut order: Vec<usize> = (0..lines.len()).collect();
        let mut cofactors = Matrix5::zeros();
        // The best agreeing ones of the start, and of the adjustment of these.
        for _ in 0..3 {
            let size = |k: &usize| lines[*k].weight * lines[*k].residual(&step) * lines[*k].residual(&step);
            order.sort_by(|a, b| size(a).total_cmp(&size(b)).then(a.cmp(b)));
            let mut normals = Normals::new();
            order[..first].iter().for_each(|k| normals.add(&lines[*k].line.by_unknowns, lines[*k].line.misclosure, lines[*k].weight));
            let solution = normals.solve().ok()?;
            (step, cofactors) = (solution.step, solution.cofactors);
        }
        let square = |k: &usize, step: &Unknowns| lines[*k].weight * lines[*k].residual(step) * lines[*k].residual(step);
        let mut square_sums = vec![order[..first].iter().map(|k| square(k, &step)).sum::<f64>()];
        let mut steps = vec![step];
        for taken in first..order.len() {
            // The first of those that fit best.
            let mut best = (f64::INFINITY, taken);
            for (place, k) in order.iter().enumerate().skip(taken) {
                let line = &lines[*k];
                let residual = line.residual(&step);
                let cofactor = 1.0 / line.weight + line.line.by_unknowns.dot(&(cofactors * line.line.by_unknowns));
                let square = residual * residual / cofactor;
                if square < best.0 {
                    best = (square, place);
                }
            }
            let (more, place) = best;
            order.swap(taken, place);
            let line = &lines[order[taken]];
            let response = cofactors * line.line.by_unknowns;
            let cofactor = 1.0 / line.weight + line.line.by_unknowns.dot(&response);
            let residual = line.residual(&step);
            step -= response * (residual / cofactor);
            cofactors -= response * response.transpose() / cofactor;
            square_sums.push(square_sums[taken - first] + more);
            steps.push(step);
        }
        Some(Self { order, first, square_sums, steps, cofactors })
    }

    /// How many of the order are one set.
    fn largest_consistent(&self, limits: Limits) -> usize {
        let most = self.order.len();
        let mut contradicting = self.first;
        for kept in (self.first + 1..=most).rev() {
            // What contradicted the last set most likely contradicts this one.
            let contradicts = |fewer: usize| fewer < kept && self.contradicts(fewer, kept, limits.beyond_doubt(), limits);
            if contradicts(contradicting) {
                continue;
            }
            match (self.first.max(6)..kept).rev().find(|fewer| contradicts(*fewer)) {
                Some(fewer) => contradicting = fewer,
                None => return kept,
            }
        }
        self.first
    }

    /// Whether the first `fewer` observations agree better than chance lets any so many of the first `kept` agree.
    fn contradicts(&self, fewer: usize, kept: usize, level: f64, limits: Limits) -> bool {
        is_beyond_chance((self.square_sum(fewer), fewer), (self.square_sum(kept), kept), level, limits)
    }

    fn square_sum(&self, kept: usize) -> f64 {
        self.square_sums[kept - self.first]
    }
}

/// Whether some of all observations, given as weighted square sum of the residuals and number, have so much smaller residuals that none of
/// all choices of so many would by chance, with a probability whose logarithm is `level`.
fn is_beyond_chance((inner, fewer): (f64, usize), (of_all, kept): (f64, usize), level: f64, limits: Limits) -> bool {
    let (left, without) = ((fewer.saturating_sub(5)) as f64, (kept - fewer) as f64);
    let outer = of_all - inner;
    if !(left > 0.0 && outer > 0.0) {
        return false;
    }
    // Below what is known of σ, residuals that are smaller still tell nothing.
    let mean = (inner / left).max(limits.least_square());
    ln_choices(kept, fewer) + ln_f_above(outer / without / mean, without, left) < level
}
