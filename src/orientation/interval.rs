//! Intervals by a covariance of several parts, each by a σ₀ of its own.

use super::coplanarity::Unknowns;
use super::normals::Matrix5;
use crate::math::{normal_quantile, student_limit};

/// A part of a covariance whose σ₀ was estimated with so many degrees of freedom.
pub(super) type EstimatedPart = (Matrix5, usize);

/// Degrees of freedom of each variance on the diagonal, by which an interval takes the limit of Student's distribution; `None` where all of the
/// variance is known.
///
/// `parts`: those of `total` that other observations than the own ones estimated, as those of fiducial marks. What is left of it is of `freedom`
/// degrees of freedom; `None`: of a σ₀ that is known.
///
/// # Source
/// Welch 1947, The generalization of "Student's" problem; Satterthwaite 1946, An approximate distribution of estimates of variance components; rounded
/// down, as the Guide to the expression of uncertainty in measurement (JCGM 100:2008, G.4) has it.
pub(super) fn effective_freedom(total: &Matrix5, freedom: Option<usize>, parts: &[EstimatedPart]) -> [Option<usize>; 5] {
    std::array::from_fn(|k| {
        let of_parts = parts.iter().map(|(part, freedom)| (part[(k, k)], Some(*freedom)));
        let own = total[(k, k)] - parts.iter().map(|(part, _)| part[(k, k)]).sum::<f64>();
        let squares: f64 = of_parts.chain([(own, freedom)]).filter_map(|(v, freedom)| Some(v * v / freedom? as f64)).sum();
        let effective = total[(k, k)] * total[(k, k)] / squares;
        effective.is_finite().then(|| libm::floor(effective * (1.0 + ROUNDING)).max(1.0) as usize)
    })
}

/// Half-widths of the intervals of 95 % of ω φ κ (radians), by bz (mm) by their covariance.
pub(super) fn half_widths(covariance: &Matrix5, freedom: &[Option<usize>; 5]) -> Unknowns {
    let limit = |k: usize| freedom[k].map_or_else(|| normal_quantile(0.975), |freedom| student_limit(0.05, freedom));
    Unknowns::from_fn(|k, _| limit(k) * covariance[(k, k)].max(0.0).sqrt())
}

/// Of two numbers of degrees of freedom the smaller one, for a region of both unknowns.
pub(super) fn fewer(one: Option<usize>, other: Option<usize>) -> Option<usize> {
    [one, other].into_iter().flatten().min()
}

/// One part alone has its own degrees of freedom, whatever rounding makes of the quotient.
const ROUNDING: f64 = 1e-9;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_part_alone_has_its_own_degrees_of_freedom() {
        let total = Matrix5::identity() * 0.3;
        assert_eq!(effective_freedom(&total, Some(95), &[]), [Some(95); 5]);
        assert_eq!(effective_freedom(&total, None, &[]), [None; 5]);
        assert_eq!(effective_freedom(&total, Some(95), &[(total, 2)]), [Some(2); 5]);
        assert_eq!(effective_freedom(&Matrix5::zeros(), Some(3), &[]), [None; 5]);
    }

    #[test]
    fn parts_of_the_same_size_add_theirs_and_small_ones_do_not_count() {
        let one = Matrix5::identity();
        assert_eq!(effective_freedom(&(one * 2.0), None, &[(one, 10), (one, 10)]), [Some(20); 5]);
        // 1 of 1.01 by two degrees of freedom, the rest by very many.
        assert_eq!(effective_freedom(&(one * 1.01), Some(10_000), &[(one * 0.01, 2)])[0], Some(6800));
    }
}
