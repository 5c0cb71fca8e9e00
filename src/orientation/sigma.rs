//! Which σ₀ scales the standard errors: the one that was known before, where the residuals do not contradict it, or else their own.

use super::result::GlobalTest;
use crate::math::chi_square_quantile;

/// σ₀ of an orientation, in focal lengths.
#[derive(Clone, Copy)]
pub struct Sigma {
    /// From the residuals; absent without redundancy.
    pub estimated: Option<f64>,
    /// Known before.
    pub given: Option<f64>,
    /// Of the one against the other.
    pub global_test: Option<GlobalTest>,
}

impl Sigma {
    pub fn of(of_residuals: f64, degrees_of_freedom: usize, given: Option<f64>) -> Self {
        let estimated = (degrees_of_freedom > 0).then_some(of_residuals);
        let global_test = estimated.zip(given).map(|(estimated, given)| global_test(estimated / given, degrees_of_freedom));
        Self { estimated, given, global_test }
    }

    pub fn is_contradicted(&self) -> bool {
        self.global_test.is_some_and(|test| !test.passed)
    }

    /// The given one, where it holds.
    pub fn known(&self) -> Option<f64> {
        self.given.filter(|_| !self.is_contradicted())
    }

    /// The one that scales the standard errors.
    pub fn used(&self) -> Option<f64> {
        self.known().or(self.estimated)
    }
}

/// The two-sided test of σ₀ by σ₀ a priori at 5 %.
fn global_test(ratio: f64, degrees_of_freedom: usize) -> GlobalTest {
    let freedom = degrees_of_freedom as f64;
    let (lower, upper) = (chi_square_quantile(0.025, freedom), chi_square_quantile(0.975, freedom));
    let statistic = freedom * ratio * ratio;
    GlobalTest { statistic, lower, upper, passed: statistic >= lower && statistic <= upper }
}
