//! How a ray crosses a convex solid, and the box around one.

use nalgebra::Vector3;

/// The part of a ray inside a convex solid.
#[derive(Debug, Clone, Copy)]
pub(super) struct Span {
    pub(super) enter: f64,
    pub(super) exit: f64,
    /// The face through which the ray enters.
    pub(super) face: usize,
}

impl Span {
    /// The part inside all half-spaces `value + t * rate <= 0`, given as `(value, rate)`.
    pub(super) fn inside(half_spaces: &[(f64, f64)]) -> Option<Span> {
        let mut span = Span { enter: f64::NEG_INFINITY, exit: f64::INFINITY, face: 0 };
        for (face, &(value, rate)) in half_spaces.iter().enumerate() {
            if rate == 0.0 {
                if value > 0.0 {
                    return None;
                }
                continue;
            }
            let t = -value / rate;
            if rate > 0.0 {
                span.exit = span.exit.min(t);
            } else if t > span.enter {
                (span.enter, span.face) = (t, face);
            }
        }
        (span.enter < span.exit).then_some(span)
    }
}

/// An axis-parallel box in ground coordinates.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Box3 {
    pub(in super::super) low: Vector3<f64>,
    pub(in super::super) high: Vector3<f64>,
}

impl Box3 {
    pub(in super::super) fn corners(&self) -> [Vector3<f64>; 8] {
        std::array::from_fn(|k| {
            let pick = |bit: usize, axis: usize| if k >> bit & 1 == 0 { self.low[axis] } else { self.high[axis] };
            Vector3::new(pick(0, 0), pick(1, 1), pick(2, 2))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_span_lies_between_the_half_spaces() {
        let span = Span::inside(&[(-5.0, 1.0), (2.0, -1.0), (-1.0, 0.0)]).unwrap();
        assert_eq!((span.enter, span.exit, span.face), (2.0, 5.0, 1));
    }

    #[test]
    fn a_ray_beside_a_solid_has_no_span() {
        assert!(Span::inside(&[(-5.0, 1.0), (6.0, -1.0)]).is_none(), "leaves before it enters");
        assert!(Span::inside(&[(-5.0, 1.0), (2.0, -1.0), (1.0, 0.0)]).is_none(), "runs outside a parallel face");
    }
}
