//! Which of few control points is wrong: told where the others fit without one of them alone, and otherwise that they contradict each other.

use super::control_course::{Contradicting, ControlTests, Course, LEAST_LEFT, MOST_ALONE, Refused, Tests};
use super::control_test::{ControlTest, fits};
use super::control_tests::{Adjusted, is_placed};
use super::placing::Placing;
use crate::Error;
use crate::adjustment::{AdjustmentResult, Block};

/// What explains a contradiction: one control point, without which all others fit.
struct Explanation {
    control: usize,
    test: Option<ControlTest>,
    /// Image measurements that are rejected without it.
    rejected: usize,
}

impl Course<'_> {
    /// What is told of the control points after the last adjustment. Where several are beyond the limit, a wrong one accuses its neighbours; where few
    /// are left, it may have image measurements rejected in its place. Then each is left out alone.
    pub(super) fn told(
        &mut self,
        (adjusted, placing): Adjusted,
        tests: &Tests,
        adjust: impl Fn(&Block) -> Result<Adjusted, Error>,
    ) -> (AdjustmentResult, Placing, ControlTests) {
        let mut told = self.done(&adjusted, tests);
        let beyond: Vec<f64> = self.beyond(tests).map(|(_, test)| test.size()).collect();
        let hidden = self.unmeasured(&adjusted).filter(|_| self.left(&adjusted) <= LEAST_LEFT);
        let is_open = beyond.len() > 1 || hidden.is_some();
        if !is_open || self.tested() > MOST_ALONE {
            return (adjusted, placing, told);
        }
        let mut w = beyond.iter().copied().fold(0.0, f64::max);
        let mut explanations = Vec::new();
        let taking = self.is_refused.clone();
        for control in (0..taking.len()).filter(|control| !taking[*control] && self.is_tested[*control]) {
            self.is_refused[control] = true;
            let found = adjust(&self.taking()).ok().filter(is_placed);
            if let Some((without, _)) = &found {
                let of_others = self.tests(without);
                let test = of_others.of[control];
                let limit = hidden.as_ref().filter(|hidden| hidden.control == control).map(|hidden| of_others.limit.max(hidden.rival()));
                if let Some(size) = test.map(|test| test.size()).filter(|size| limit.is_some_and(|limit| *size > limit)) {
                    w = w.max(size);
                }
                let mut others = (0..taking.len()).filter(|other| self.is_tested[*other] && !self.is_refused[*other]);
                if others.all(|other| fits(of_others.of[other].as_ref(), of_others.limit)) && !fits(test.as_ref(), of_others.limit) {
                    explanations.push(Explanation { control, test, rejected: self.rejected(without) });
                }
            }
            self.is_refused[control] = false;
        }
        if w > 0.0 {
            told.refused.iter_mut().filter(|refused| refused.is_used).for_each(|refused| refused.is_named = false);
            match the_one(&explanations) {
                Some(one) => {
                    let point = self.block.control[one.control].point;
                    let test = tests.of[one.control].filter(|test| test.size() > tests.limit).or(one.test);
                    told.refused.retain(|refused| !refused.is_used);
                    told.refused.push(Refused { point, test, is_used: true, is_within: false, is_certain: false, is_named: true });
                }
                None => {
                    let refused = beyond.len().max(explanations.len()).max(1);
                    told.contradicting = Some(Contradicting { refused, of: self.tested(), w });
                }
            }
        }
        (adjusted, placing, told)
    }
}

/// The explanation that needs fewer image measurements rejected than any other.
fn the_one(all: &[Explanation]) -> Option<&Explanation> {
    let least = all.iter().map(|of| of.rejected).min()?;
    let mut fewest = all.iter().filter(|of| of.rejected == least);
    fewest.next().filter(|_| fewest.next().is_none())
}

#[cfg(test)]
mod tests {
    use super::{Explanation, the_one};

    #[test]
    fn a_point_is_told_where_no_other_explains_as_much() {
        let of = |control: usize, rejected: usize| Explanation { control, test: None, rejected };
        let found = |all: &[Explanation]| the_one(all).map(|one| one.control);
        assert_eq!(found(&[]), None);
        assert_eq!(found(&[of(2, 0)]), Some(2));
        assert_eq!(found(&[of(0, 1), of(2, 0), of(3, 4)]), Some(2));
        assert_eq!(found(&[of(0, 1), of(2, 0), of(3, 0)]), None);
    }
}
