//! The plan of the block: projection centres with their error ellipses, connections by the points in common, ground control points.

use super::plane::Plane;
use super::range::{range, worst};
use super::subject::Subject;
use crate::html::{count, dots, listed, round_below, rounded, significant, strokes};
use crate::outputs::precision::{CoordinateErrors, image_errors};
use crate::{ControlRole, ErrorEllipse, Texts};
use maud::{Markup, PreEscaped, html};

const WIDTH: f64 = 560.0;
const TALLEST: f64 = 560.0;
const MARGIN: f64 = 36.0;
/// Below the plan, for the scale bars.
const FOOT: f64 = 46.0;
/// Lines and ellipses that are drawn: a page holds no more.
const MOST_LINES: usize = 6000;
const MOST_ELLIPSES: usize = 1500;
/// Half the long axis of the median ellipse in the drawing.
const MEDIAN_ELLIPSE: f64 = 9.0;
const WIDTHS: [&str; 4] = ["0.4", "0.9", "1.6", "2.6"];

/// A map of the plane onto the drawing.
struct Map {
    scale: f64,
    from: [f64; 2],
    height: f64,
}

impl Map {
    fn of(places: &[[f64; 2]]) -> Self {
        let reach = |k: usize, of: fn(f64, f64) -> f64, start: f64| places.iter().map(|place| place[k]).fold(start, of);
        let low = [0, 1].map(|k| reach(k, f64::min, f64::INFINITY));
        let high = [0, 1].map(|k| reach(k, f64::max, f64::NEG_INFINITY));
        let spread = [0, 1].map(|k| (high[k] - low[k]).max(0.0));
        let fits = [WIDTH, TALLEST].map(|room| room - 2.0 * MARGIN);
        let scale = (fits[0] / spread[0].max(f64::MIN_POSITIVE)).min(fits[1] / spread[1].max(f64::MIN_POSITIVE));
        // One place alone has no scale.
        let scale = if spread[0].max(spread[1]) > 0.0 { scale } else { 1.0 };
        let height = (scale * spread[1] + 2.0 * MARGIN).max(120.0);
        let middle = [0, 1].map(|k| 0.5 * (low[k] + high[k]));
        Self { scale, from: [middle[0] - 0.5 * WIDTH / scale, middle[1] + 0.5 * height / scale], height }
    }

    fn at(&self, place: [f64; 2]) -> [f64; 2] {
        [(place[0] - self.from[0]) * self.scale, (self.from[1] - place[1]) * self.scale]
    }
}

/// Absent where no image is oriented.
pub(super) fn plan(subject: &Subject<'_>) -> Option<Markup> {
    let (texts, plane) = (subject.texts, Plane::of(subject));
    let images = &subject.run.model.images;
    let centres: Vec<Option<[f64; 2]>> = images.iter().map(|image| image.pose.map(|pose| plane.place(pose.position))).collect();
    let surveyed = subject.model.map_or(&[][..], |model| &model.surveyed);
    let of_control = |role: ControlRole| surveyed.iter().filter(move |point| point.role == role).map(|point| plane.place(point.position));
    let all: Vec<[f64; 2]> =
        centres.iter().flatten().copied().chain(of_control(ControlRole::Control)).chain(of_control(ControlRole::Check)).collect();
    if !centres.iter().any(Option::is_some) {
        return None;
    }
    let map = Map::of(&all);
    let (ellipses, factor, grown) = ellipses(subject, &plane, &map, &centres);
    let without = centres.iter().zip(&ellipses).filter_map(|(centre, ellipse)| centre.filter(|_| ellipse.is_none()));
    let with = centres.iter().zip(&ellipses).filter_map(|(centre, ellipse)| centre.filter(|_| ellipse.is_some()));
    let links = links(subject, &map, &centres);
    let drawn = ellipses.iter().flatten().count();
    let step = drawn.div_ceil(MOST_ELLIPSES).max(1);
    let shown = ellipses.iter().enumerate().filter_map(|(image, ellipse)| Some((image, centres[image]?, (*ellipse)?))).step_by(step);
    let signs = |role, size: f64| {
        let paths = of_control(role).map(|place| map.at(place));
        paths.map(|[x, y]| format!("M{x:.1} {:.1}l{size} {}h{}z", y - size, 1.7 * size, -2.0 * size)).collect::<String>()
    };
    let words = texts.with("report-plan-of", [("centres", count(centres.iter().flatten().count()))]);
    Some(html! {
        figure {
            svg.plan viewBox=(format!("0 0 {WIDTH} {:.0}", map.height + FOOT)) role="img" aria-label=(words) {
                @for (path, width) in links.paths.iter().zip(WIDTHS) { path.link stroke-width=(width) d=(PreEscaped(path)) {} }
                @for (image, centre, ellipse) in shown {
                    @let [x, y] = map.at(centre);
                    @let [major, minor] = [ellipse.semi_major, ellipse.semi_minor].map(|axis| axis * factor * map.scale);
                    ellipse.outline rx=(format!("{major:.1}")) ry=(format!("{minor:.1}")) transform=(format!("translate({x:.1} {y:.1}) rotate({:.0})", -ellipse.bearing_deg)) {
                        title { (subject.name(image)) }
                    }
                }
                path.centre d=(PreEscaped(dots(with.map(|centre| map.at(centre))))) {}
                path.centre.without d=(PreEscaped(dots(without.map(|centre| map.at(centre))))) {}
                path.control d=(PreEscaped(signs(ControlRole::Control, 5.0))) {}
                path.check d=(PreEscaped(signs(ControlRole::Check, 5.0))) {}
                (bars(texts, &map, factor, drawn > 0, &subject.unit()))
            }
            figcaption {
                @if drawn > 0 {
                    @match grown {
                        Some(grown) => (texts.with("report-ellipses-95", [("grown", significant(grown)), ("factor", rounded(factor))])),
                        None => (texts.with("report-ellipses-standard", [("factor", rounded(factor))])),
                    }
                    @if step > 1 { (texts.with("report-one-of", [("step", step.to_string())])) }
                    ". "
                } @else { (texts.say("report-no-standard-errors")) " " }
                (links.words)
                @if !surveyed.is_empty() { " " (texts.say("report-triangles")) }
                @if subject.model.is_some_and(|model| !model.in_system) { " " (texts.say("report-plane-of-images")) }
            }
        }
    })
}

/// The ellipse of each centre that has standard errors, by how much they are enlarged in the drawing, and by how much they are larger than the standard
/// error ellipses.
fn ellipses(
    subject: &Subject<'_>,
    plane: &Plane,
    map: &Map,
    centres: &[Option<[f64; 2]>],
) -> (Vec<Option<ErrorEllipse>>, f64, Option<f64>) {
    let grown = subject.factors_95().map(|factors| factors.ellipse);
    let ellipse =
        |position: CoordinateErrors| plane.ellipse(position.errors, position.correlations.unwrap_or_default()).scaled(grown.unwrap_or(1.0));
    let ellipses: Vec<Option<ErrorEllipse>> =
        image_errors(subject.run).iter().zip(centres).map(|(errors, centre)| centre.and_then(|_| errors.position.map(ellipse))).collect();
    let median = range(ellipses.iter().flatten().map(|ellipse| ellipse.semi_major)).map_or(0.0, |[_, median, _]| median);
    (ellipses, round_below(MEDIAN_ELLIPSE / (median * map.scale)), grown)
}

/// Connections in four classes of strength.
struct Links {
    paths: [String; 4],
    words: String,
}

fn links(subject: &Subject<'_>, map: &Map, centres: &[Option<[f64; 2]>]) -> Links {
    let ends = |images: [u32; 2]| {
        let [a, b] = images.map(|image| centres.get(image as usize).copied().flatten());
        Some([map.at(a?), map.at(b?)])
    };
    let joined = subject
        .pairs
        .iter()
        .filter(|pair| pair.chosen_points > 0 && !pair.rejected_by_hand)
        .filter_map(|pair| Some((pair.chosen_points, ends(pair.images)?)));
    let all = joined.clone().count();
    let mut strongest = worst(joined, MOST_LINES, |(points, _)| Some(f64::from(*points)));
    // The weakest first, so that the strong ones lie on top and make quarters.
    strongest.reverse();
    let quarter = strongest.len().div_ceil(4).max(1);
    let mut classes = strongest.chunks(quarter);
    let mut bounds = Vec::new();
    let paths = std::array::from_fn(|_| {
        let class = classes.next().unwrap_or_default();
        bounds.extend(class.last().map(|(points, _)| points.to_string()));
        strokes(class.iter().map(|(_, [[x, y], [to_x, to_y]])| ([*x, *y], [to_x - x, to_y - y])))
    });
    let texts = subject.texts;
    let mut words =
        if bounds.is_empty() { texts.say("report-no-links") } else { texts.with("report-links", [("bounds", listed(texts, bounds))]) };
    if all > strongest.len() {
        let figures = [("links", count(all)), ("drawn", count(strongest.len()))];
        words = words + " " + &texts.with("report-strongest-links", figures);
    }
    Links { paths, words }
}

/// A bar for the plan, and one for the ellipses.
fn bars(texts: &Texts, map: &Map, factor: f64, with_ellipses: bool, unit: &str) -> Markup {
    let bar = |x: f64, scale: f64, name: &str| {
        let length = round_below(0.3 * WIDTH / scale);
        let y = map.height + 14.0;
        let words = texts.with(name, [("length", rounded(length)), ("unit", unit.into())]);
        html! {
            path.scale d=(format!("M{x} {:.1}v8h{:.1}v-8", y - 8.0, length * scale)) {}
            text x=(x) y=(format!("{:.1}", y + 16.0)) { (words) }
        }
    };
    html! {
        (bar(MARGIN, map.scale, "report-scale-of-plan"))
        @if with_ellipses { (bar(0.5 * WIDTH + 10.0, map.scale * factor, "report-scale-of-ellipses")) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plan_fits_its_drawing_whatever_its_shape() {
        for places in [vec![[5.0, 7.0]], vec![[0.0, 0.0], [1e6, 0.0]], vec![[3.0, -1e5], [3.0, 1e5]], vec![[0.0, 0.0], [1.0, 2.0]]] {
            let map = Map::of(&places);
            for place in places {
                let [x, y] = map.at(place);
                assert!(
                    (MARGIN - 1e-6..=WIDTH - MARGIN + 1e-6).contains(&x) && y >= MARGIN - 1e-6 && y <= map.height - MARGIN + 1e-6,
                    "{x} {y}"
                );
            }
            assert!(map.height <= TALLEST + 1e-6);
        }
    }
}
