//! Points, match lines and vectors on a canvas.
//!
//! Image positions are in px (centre of the top-left pixel at (0.5, 0.5)); canvas positions are in the units of the context's
//! current transformation. What lies outside the view is left out, and marks of one style share one path, so that many thousand
//! points cost a few calls of `stroke` or `fill`.

use super::convert::{Bytes, Numbers, TextList, thrown};
use crate::Error;
use wasm_bindgen::prelude::*;
use web_sys::CanvasRenderingContext2d;

/// Sub-paths in one `stroke`: renderers slow down on very long paths.
const SUBPATHS: usize = 512;
/// Marks of a half size below this are filled squares: their outline could not be told apart.
const LEAST_OUTLINED: f64 = 2.5;

/// How image positions become canvas positions, and the rectangle of the canvas that shows the image.
#[derive(Debug, Clone, Copy, PartialEq)]
struct View {
    scale: f64,
    shift: [f64; 2],
    low: [f64; 2],
    high: [f64; 2],
}

impl View {
    /// From `[scale, shift x, shift y, left, top, right, bottom]`: canvas = scale · image + shift.
    fn new(what: &'static str, view: &[f64]) -> Result<Self, Error> {
        match *view {
            [scale, x, y, left, top, right, bottom] if view.iter().all(|v| v.is_finite()) && scale > 0.0 => {
                Ok(Self { scale, shift: [x, y], low: [left, top], high: [right, bottom] })
            }
            _ => Err(Error::InvalidArgument {
                what,
                got: format!("{view:?}"),
                wanted: "scale > 0, shift x, shift y, left, top, right, bottom, all finite".into(),
            }),
        }
    }

    fn canvas(&self, x: f64, y: f64) -> [f64; 2] {
        [self.scale * x + self.shift[0], self.scale * y + self.shift[1]]
    }

    /// Whether a mark at this canvas position, reaching `margin` to each side, touches the view.
    fn shows(&self, [x, y]: [f64; 2], margin: f64) -> bool {
        x >= self.low[0] - margin && x <= self.high[0] + margin && y >= self.low[1] - margin && y <= self.high[1] + margin
    }
}

/// Remembers which cells of the view are taken, so that points on top of each other are drawn once.
struct Cells {
    side: f64,
    columns: usize,
    rows: usize,
    taken: Vec<bool>,
}

impl Cells {
    fn new(view: &View, margin: f64, side: f64) -> Self {
        let count = |axis: usize| ((view.high[axis] - view.low[axis] + 2.0 * margin) / side).max(0.0) as usize + 1;
        let (columns, rows) = (count(0), count(1));
        Self { side, columns, rows, taken: vec![false; columns * rows] }
    }

    /// Takes the cell of an offset from the view's top-left corner; false where it was taken before.
    fn take(&mut self, x: f64, y: f64) -> bool {
        let column = ((x / self.side) as usize).min(self.columns - 1);
        let row = ((y / self.side) as usize).min(self.rows - 1);
        !std::mem::replace(&mut self.taken[row * self.columns + column], true)
    }
}

/// The mark of a point. Shapes differ as well as colours.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Shape {
    Dot,
    Circle,
    Plus,
    Cross,
    Square,
    TriangleUp,
    TriangleDown,
    Diamond,
}

impl Shape {
    fn from_code(code: f64) -> Result<Self, Error> {
        const ALL: [Shape; 8] =
            [Shape::Dot, Shape::Circle, Shape::Plus, Shape::Cross, Shape::Square, Shape::TriangleUp, Shape::TriangleDown, Shape::Diamond];
        ALL.into_iter().enumerate().find(|(index, _)| *index as f64 == code).map(|(_, shape)| shape).ok_or_else(|| Error::InvalidArgument {
            what: "shape of a point style",
            got: code.to_string(),
            wanted: "0 dot, 1 circle, 2 plus, 3 cross, 4 square, 5 and 6 triangle up and down, 7 diamond".into(),
        })
    }

    /// Adds the mark's outline of half size `h` around `(x, y)` to the path.
    fn trace(self, path: &CanvasRenderingContext2d, [x, y]: [f64; 2], h: f64) {
        match self {
            Shape::Dot => path.rect(x - h, y - h, 2.0 * h, 2.0 * h),
            Shape::Circle => {
                path.move_to(x + h, y);
                // The radius is positive, the one thing `arc` can refuse.
                let _ = path.arc(x, y, h, 0.0, std::f64::consts::TAU);
            }
            Shape::Plus => trace_lines(path, &[[x - h, y], [x + h, y], [x, y - h], [x, y + h]]),
            Shape::Cross => trace_lines(path, &[[x - h, y - h], [x + h, y + h], [x - h, y + h], [x + h, y - h]]),
            Shape::Square => path.rect(x - h, y - h, 2.0 * h, 2.0 * h),
            Shape::TriangleUp => trace_polygon(path, &[[x, y - h], [x + h, y + 0.8 * h], [x - h, y + 0.8 * h]]),
            Shape::TriangleDown => trace_polygon(path, &[[x, y + h], [x + h, y - 0.8 * h], [x - h, y - 0.8 * h]]),
            Shape::Diamond => trace_polygon(path, &[[x, y - h], [x + h, y], [x, y + h], [x - h, y]]),
        }
    }
}

fn trace_lines(path: &CanvasRenderingContext2d, ends: &[[f64; 2]]) {
    for pair in ends.chunks_exact(2) {
        path.move_to(pair[0][0], pair[0][1]);
        path.line_to(pair[1][0], pair[1][1]);
    }
}

fn trace_polygon(path: &CanvasRenderingContext2d, corners: &[[f64; 2]]) {
    path.move_to(corners[0][0], corners[0][1]);
    for corner in &corners[1..] {
        path.line_to(corner[0], corner[1]);
    }
    path.close_path();
}

/// Strokes or fills what `trace` adds for each item, a few hundred items a path.
fn in_batches<T>(context: &CanvasRenderingContext2d, items: &[T], fill: bool, trace: impl Fn(&T)) {
    for batch in items.chunks(SUBPATHS) {
        context.begin_path();
        batch.iter().for_each(&trace);
        if fill { context.fill() } else { context.stroke() }
    }
}

/// Refuses an array that is not whole rows of `stride`, or not one row for each code.
fn check_rows(what: &'static str, values: &[f64], stride: usize, codes: &[u8]) -> Result<(), Error> {
    if values.len() == codes.len() * stride {
        return Ok(());
    }
    Err(Error::InvalidArgument {
        what,
        got: format!("{} numbers for {} codes", values.len(), codes.len()),
        wanted: format!("{stride} numbers a code"),
    })
}

/// The canvas positions of the visible points of each style, thinned where they crowd.
///
/// Filled squares take cells of twice their side, whatever their style, so that the image shows between them and every style keeps
/// its share; outlined marks leave out others of their own style within half their size.
fn visible_points(points: &[f64], codes: &[u8], half_sizes: &[f64], view: &View) -> Vec<Vec<[f64; 2]>> {
    let margin = half_sizes.iter().copied().fold(0.0, f64::max);
    let squares = margin < LEAST_OUTLINED;
    let side = if squares { (4.0 * margin).max(1.0) } else { margin };
    let mut cells: Vec<Cells> = (0..if squares { 1 } else { half_sizes.len() }).map(|_| Cells::new(view, margin, side)).collect();
    let mut visible = vec![Vec::new(); half_sizes.len()];
    for (point, &code) in points.chunks_exact(3).zip(codes) {
        let (style, at) = (usize::from(code), view.canvas(point[0], point[1]));
        if style >= visible.len() || !view.shows(at, margin) {
            continue;
        }
        let cells = &mut cells[if squares { 0 } else { style }];
        if cells.take(at[0] - view.low[0] + margin, at[1] - view.low[1] + margin) {
            visible[style].push(at);
        }
    }
    visible
}

/// Draws points; returns how many were drawn.
///
/// `points`: stride 3, `x, y, value` in px. `codes`: one a point, the index of its style; a code without a style is not drawn.
/// `styles`: stride 3, `shape, half size, line width` in canvas units (shapes: 0 dot, 1 circle, 2 plus, 3 cross, 4 square,
/// 5 triangle up, 6 triangle down, 7 diamond). `colours`: one CSS colour a style. `view`: scale, shift x, shift y,
/// left, top, right, bottom: a position of the canvas is scale times that of the image plus the shift, and marks are drawn within the last four, in canvas
/// units. Styles are drawn in order,
/// the last on top; where points crowd, some are left out.
#[wasm_bindgen]
pub fn draw_points(
    context: &CanvasRenderingContext2d,
    points: &Numbers,
    codes: &Bytes,
    styles: &Numbers,
    colours: &TextList,
    view: &Numbers,
) -> Result<u32, JsValue> {
    let view = View::new("view of the points", &view.read("view")?).map_err(thrown)?;
    let (points, codes) = (points.read("points")?, codes.read("codes")?);
    let (styles, colours) = (styles.read("styles")?, colours.read("colours")?);
    check_rows("points to draw", &points, 3, &codes).map_err(thrown)?;
    let half_sizes: Vec<f64> = styles.chunks_exact(3).map(|style| style[1]).collect();
    let visible = visible_points(&points, &codes, &half_sizes, &view);
    for ((positions, style), colour) in visible.iter().zip(styles.chunks_exact(3)).zip(&colours) {
        let shape = if style[1] < LEAST_OUTLINED { Shape::Dot } else { Shape::from_code(style[0]).map_err(thrown)? };
        context.set_fill_style_str(colour);
        context.set_stroke_style_str(colour);
        context.set_line_width(style[2]);
        in_batches(context, positions, shape == Shape::Dot, |&at| shape.trace(context, at, style[1]));
    }
    Ok(visible.iter().map(|positions| positions.len() as u32).sum())
}

/// Draws the lines of matches whose two ends are both in view, from the left image's view to the right one's; returns how many.
///
/// `matches`: stride 5, `x left, y left, x right, y right, measure` in px. `codes`: one a match, the index of its style; a code without
/// a style is not drawn. `widths` and `colours`: one a style. Views as of `draw_points`. Where more than `most` are in view, evenly many are drawn.
#[allow(clippy::too_many_arguments)]
#[wasm_bindgen]
pub fn draw_match_lines(
    context: &CanvasRenderingContext2d,
    matches: &Numbers,
    codes: &Bytes,
    widths: &Numbers,
    colours: &TextList,
    left_view: &Numbers,
    right_view: &Numbers,
    most: u32,
) -> Result<u32, JsValue> {
    let left = View::new("view of the left image", &left_view.read("left view")?).map_err(thrown)?;
    let right = View::new("view of the right image", &right_view.read("right view")?).map_err(thrown)?;
    let (matches, codes) = (matches.read("matches")?, codes.read("codes")?);
    let (widths, colours) = (widths.read("widths")?, colours.read("colours")?);
    check_rows("matches to draw", &matches, 5, &codes).map_err(thrown)?;
    let lines = visible_lines(&matches, &codes, widths.len(), &left, &right, most as usize);
    for (code, (width, colour)) in widths.iter().zip(&colours).enumerate() {
        context.set_stroke_style_str(colour);
        context.set_line_width(*width);
        let of_style: Vec<[[f64; 2]; 2]> = lines.iter().filter(|line| line.0 == code).map(|line| line.1).collect();
        in_batches(context, &of_style, false, |ends| trace_lines(context, ends));
    }
    Ok(lines.len() as u32)
}

/// Style and ends of the lines in view, thinned to `most` of them.
fn visible_lines(matches: &[f64], codes: &[u8], styles: usize, left: &View, right: &View, most: usize) -> Vec<(usize, [[f64; 2]; 2])> {
    let lines: Vec<_> = matches
        .chunks_exact(5)
        .zip(codes)
        .map(|(m, &code)| (usize::from(code), [left.canvas(m[0], m[1]), right.canvas(m[2], m[3])]))
        .filter(|(code, ends)| *code < styles && left.shows(ends[0], 0.0) && right.shows(ends[1], 0.0))
        .collect();
    if lines.len() <= most {
        return lines;
    }
    (0..most).map(|i| lines[i * lines.len() / most]).collect()
}

/// Draws vectors as arrows from their points, enlarged `factor` times; returns how many.
///
/// `vectors`: stride 4, `x, y, dx, dy` in px of the image. `codes`: one a vector, the index of its style; a code without a style is not drawn.
/// `widths` and `colours`: one a style. `view`: as of `draw_points`.
#[wasm_bindgen]
pub fn draw_vectors(
    context: &CanvasRenderingContext2d,
    vectors: &Numbers,
    codes: &Bytes,
    widths: &Numbers,
    colours: &TextList,
    factor: f64,
    view: &Numbers,
) -> Result<u32, JsValue> {
    let view = View::new("view of the vectors", &view.read("view")?).map_err(thrown)?;
    let (vectors, codes) = (vectors.read("vectors")?, codes.read("codes")?);
    let (widths, colours) = (widths.read("widths")?, colours.read("colours")?);
    check_rows("vectors to draw", &vectors, 4, &codes).map_err(thrown)?;
    let mut drawn = 0;
    for (code, (width, colour)) in widths.iter().zip(&colours).enumerate() {
        let arrows = visible_arrows(&vectors, &codes, code, factor, &view);
        context.set_stroke_style_str(colour);
        context.set_line_width(*width);
        in_batches(context, &arrows, false, |&[from, to]| trace_arrow(context, from, to));
        drawn += arrows.len() as u32;
    }
    Ok(drawn)
}

fn visible_arrows(vectors: &[f64], codes: &[u8], code: usize, factor: f64, view: &View) -> Vec<[[f64; 2]; 2]> {
    vectors
        .chunks_exact(4)
        .zip(codes)
        .filter(|(v, c)| usize::from(**c) == code && v.iter().all(|value| value.is_finite()))
        .map(|(v, _)| [view.canvas(v[0], v[1]), view.canvas(v[0] + factor * v[2], v[1] + factor * v[3])])
        .filter(|ends| view.shows(ends[0], 0.0))
        .collect()
}

/// A shaft, and a head of a third of its length, at most 6 canvas units.
fn trace_arrow(path: &CanvasRenderingContext2d, from: [f64; 2], to: [f64; 2]) {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let length = (dx * dx + dy * dy).sqrt();
    trace_lines(path, &[from, to]);
    if length < 1.0 {
        return;
    }
    let head = (length / 3.0).min(6.0);
    let (ux, uy) = (head * dx / length, head * dy / length);
    path.move_to(to[0] - ux - 0.5 * uy, to[1] - uy + 0.5 * ux);
    path.line_to(to[0], to[1]);
    path.line_to(to[0] - ux + 0.5 * uy, to[1] - uy - 0.5 * ux);
}

#[cfg(test)]
mod tests {
    use super::*;
    use wasm_bindgen_test::wasm_bindgen_test;

    fn view() -> View {
        View::new("view", &[2.0, 10.0, 20.0, 10.0, 20.0, 110.0, 120.0]).unwrap()
    }

    #[wasm_bindgen_test]
    fn a_view_scales_shifts_and_culls() {
        assert_eq!(view().canvas(0.5, 1.0), [11.0, 22.0]);
        assert!(view().shows(view().canvas(50.0, 50.0), 0.0));
        assert!(!view().shows(view().canvas(50.1, 50.0), 0.0));
        assert!(view().shows(view().canvas(50.1, 50.0), 1.0));
    }

    #[wasm_bindgen_test]
    fn a_view_without_scale_is_refused() {
        assert!(View::new("view", &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0]).is_err());
        assert!(View::new("view", &[1.0, f64::NAN, 0.0, 0.0, 0.0, 1.0, 1.0]).is_err());
        assert!(View::new("view", &[1.0, 0.0]).is_err());
    }

    #[wasm_bindgen_test]
    fn crowded_points_are_thinned() {
        let points = [1.0, 1.0, 0.0, 1.1, 1.0, 0.0, 1.0, 1.0, 0.0, 40.0, 1.0, 0.0, 400.0, 1.0, 0.0, 1.0, 1.0, 0.0];
        let drawn = |half| visible_points(&points, &[0, 0, 1, 0, 0, 9], &[half; 2], &view()).iter().map(Vec::len).collect::<Vec<_>>();
        assert_eq!(drawn(4.0), [2, 1], "an outlined mark hides its own style only");
        assert_eq!(drawn(1.5), [2, 0], "a square hides what lies below it");
    }

    #[wasm_bindgen_test]
    fn lines_are_thinned_evenly_and_need_both_ends() {
        let row = |x: f64| [x, 1.0, x, 1.0, 0.1];
        let matches: Vec<f64> = (0..60).flat_map(|i| row(f64::from(i))).collect();
        let all = visible_lines(&matches, &[0; 60], 1, &view(), &view(), 1000);
        assert_eq!(all.len(), 51);
        let few = visible_lines(&matches, &[0; 60], 1, &view(), &view(), 3);
        assert_eq!(few.iter().map(|line| line.1[0][0]).collect::<Vec<_>>(), [10.0, 44.0, 78.0]);
        assert!(visible_lines(&matches, &[1; 60], 1, &view(), &view(), 3).is_empty());
    }

    #[wasm_bindgen_test]
    fn arrays_of_other_lengths_are_refused() {
        assert!(check_rows("points", &[1.0, 2.0], 3, &[0]).is_err());
        assert!(check_rows("points", &[1.0, 2.0, 3.0], 3, &[0]).is_ok());
    }
}
