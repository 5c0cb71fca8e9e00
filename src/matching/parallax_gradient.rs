//! The limit of the parallax gradient: matches of one surface move together. It tells strangers that lie on the right epipolar line by chance.

use super::neighbours::Neighbours;
use crate::math::median;

/// Neighbours by which a match is judged, and of whom at least half agree with one that stands.
const NEIGHBOURS: usize = 10;
/// Nearer ones are the same corner, detected twice, px.
const LEAST_DISTANCE_PX: f64 = 3.0;
/// Largest difference of the parallaxes of two matches as a share of their mean distance in both images.
const LIMIT: f64 = 1.0;

/// Complex numbers stand for positions and for similarities: turned and enlarged at once.
type Complex = [f64; 2];

fn minus([a, b]: Complex, [c, d]: Complex) -> Complex {
    [a - c, b - d]
}

fn times([a, b]: Complex, [c, d]: Complex) -> Complex {
    [a * c - b * d, a * d + b * c]
}

fn by([a, b]: Complex, [c, d]: Complex) -> Complex {
    let square = c * c + d * d;
    [(a * c + b * d) / square, (b * c - a * d) / square]
}

fn length([a, b]: Complex) -> f64 {
    (a * a + b * b).sqrt()
}

fn middle(values: impl Iterator<Item = Complex> + Clone) -> Option<Complex> {
    let of = |k: usize| median(&mut values.clone().map(|v| v[k]).collect::<Vec<_>>());
    Some([of(0)?, of(1)?])
}

/// Which of matches `[x left, y left, x right, y right]` in px move as at least half of their nearest ones do; those without neighbours
/// are among them.
///
/// How the right image is turned and enlarged against the left one follows from the neighbours' own neighbours, so that one stranger, or a few,
/// change nothing; what is left of the difference of two matches is the difference of their parallaxes.
///
/// # Source
/// Burt & Julesz 1980, A disparity gradient limit for binocular fusion, Science 208; Pollard, Mayhew & Frisby 1985, PMF: a stereo
/// correspondence algorithm using a disparity gradient limit, Perception 14.
pub(crate) fn within_parallax_gradient(matches: &[[f64; 4]]) -> Vec<bool> {
    let [left, right]: [Vec<Complex>; 2] = [0, 2].map(|k| matches.iter().map(|m| [m[k], m[k + 1]]).collect());
    let index = Neighbours::new(&left);
    let nearest: Vec<Vec<usize>> = (0..matches.len())
        .map(|k| {
            let mut near = Vec::new();
            index.nearest(k, NEIGHBOURS, |other| length(minus(left[other], left[k])) >= LEAST_DISTANCE_PX, &mut near);
            near
        })
        .collect();
    let to = |k: usize, other: usize| [&left, &right].map(|side| minus(side[other], side[k]));
    let seen_from = |k: usize| middle(nearest[k].iter().map(|other| to(k, *other)).map(|[l, r]| by(r, l)));
    let own: Vec<Option<Complex>> = (0..matches.len()).map(seen_from).collect();
    let agrees = |similarity: Complex, [l, r]: [Complex; 2]| {
        let expected = times(similarity, l);
        length(minus(r, expected)) <= LIMIT * 0.5 * (length(expected) + length(r))
    };
    let stands = |k: usize| {
        let Some(similarity) = middle(nearest[k].iter().filter_map(|other| own[*other])) else { return true };
        2 * nearest[k].iter().filter(|other| agrees(similarity, to(k, **other))).count() >= nearest[k].len()
    };
    (0..matches.len()).map(stands).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;

    /// Matches over relief, the right image turned by 100° and enlarged by 1.6, with `strangers` along the rows of the left image.
    fn matches(strangers: usize) -> Vec<[f64; 4]> {
        let mut random = Random::new(7);
        let mut uniform = |most: f64| most * random.below(1 << 20) as f64 / f64::from(1 << 20);
        let turn = [1.6 * libm::cos(1.75), 1.6 * libm::sin(1.75)];
        (0..500)
            .map(|k| {
                let (x, y) = (uniform(900.0), uniform(600.0));
                let height = 20.0 * libm::sin(x / 90.0) * libm::cos(y / 70.0);
                let parallax = if k < strangers { 60.0 + uniform(500.0) } else { height };
                let [u, v] = times(turn, [x + parallax, y]);
                [x, y, u + 800.0, v + 30.0]
            })
            .collect()
    }

    #[test]
    fn strangers_on_the_right_line_are_told_from_relief() {
        for strangers in [0, 25, 100] {
            let stands = within_parallax_gradient(&matches(strangers));
            let kept = |range: std::ops::Range<usize>| range.filter(|k| stands[*k]).count();
            assert!(kept(0..strangers) * 20 <= strangers, "{} of {strangers} strangers stand", kept(0..strangers));
            assert!(kept(strangers..500) * 100 >= (500 - strangers) * 97, "{} of {}", kept(strangers..500), 500 - strangers);
        }
    }

    #[test]
    fn a_step_of_the_ground_keeps_both_of_its_sides() {
        let step = |m: &[f64; 4]| [m[0], m[1], m[0] + if m[0] > 450.0 { 90.0 } else { 0.0 }, m[1]];
        let all: Vec<[f64; 4]> = matches(0).iter().map(step).collect();
        let lost: Vec<f64> = all.iter().zip(within_parallax_gradient(&all)).filter(|(_, stands)| !stands).map(|(m, _)| m[0]).collect();
        assert!(lost.len() <= 10 && lost.iter().all(|x| (x - 450.0).abs() < 50.0), "{lost:?}");
    }

    #[test]
    fn few_matches_and_equal_positions_stand() {
        assert_eq!(within_parallax_gradient(&[]), [false; 0]);
        assert_eq!(within_parallax_gradient(&[[1.0, 2.0, 3.0, 4.0]; 30]), [true; 30]);
        assert_eq!(within_parallax_gradient(&[[1.0, 2.0, 3.0, 4.0], [9.0, 2.0, 11.5, 4.0]]), [true; 2]);
    }
}
