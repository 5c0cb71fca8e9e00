//! The known answer: where each left pixel's surface is seen in the right image.

use super::view::View;

/// The right position in px of what the centre of each left pixel shows, row by row; NaN where it is hidden or outside, or under a moving
/// car in either image.
pub(super) fn right_positions(left: &View<'_>, right: &View<'_>, width: usize, height: usize) -> Vec<[f32; 2]> {
    let centre = |index: usize| [(index % width) as f64 + 0.5, (index / width) as f64 + 0.5];
    let seen = |[x, y]: [f64; 2]| {
        let hit = left.hit(x, y);
        right.find(hit.point).filter(|_| !left.is_unsteady(&hit))
    };
    (0..width * height).map(|index| seen(centre(index)).map_or([f32::NAN; 2], |place| place.map(|value| value as f32))).collect()
}
