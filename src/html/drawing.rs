//! Marks of drawings as commands of an SVG path.

/// Dots: strokes of no length, which round caps make visible.
pub(crate) fn dots(points: impl IntoIterator<Item = [f64; 2]>) -> String {
    points.into_iter().map(|[x, y]| format!("M{x:.1} {y:.1}h0")).collect()
}

/// Lines from a place by a displacement.
pub(crate) fn strokes(vectors: impl IntoIterator<Item = ([f64; 2], [f64; 2])>) -> String {
    vectors.into_iter().map(|([x, y], [dx, dy])| format!("M{x:.1} {y:.1}l{dx:.1} {dy:.1}")).collect()
}
