//! The heights that the tie points of a block give the ground.

use super::block_map::{BlockMap, borders, epsg_of};
use super::heights::{HeightModel, Heights};
use crate::Georeference;
use crate::math::median;
use crate::{BlockModel, BlockRun, Error, Few};

/// Points in a cell, on average.
const POINTS_IN_CELL: f64 = 4.0;
/// Longest side of the grid.
const MOST_CELLS: f64 = 2000.0;

/// The heights of the tie points of a block in the system of its results, as a model that says that system: ground on which further images are placed.
///
/// # Errors
/// As [`heights_of_points`]; [`Error::InvalidInput`] for a coordinate reference system in degrees.
pub fn heights_of_block(run: &BlockRun) -> Result<HeightModel, Error> {
    let map = BlockMap::of(run)?;
    let model = heights_on_map(&run.model, map.as_ref())?;
    Ok(model.in_system(epsg_of(run, map.as_ref()), map.as_ref().map(BlockMap::height_unit_m)))
}

/// The heights of the tie points of a block as a model: their medians in the cells of a grid, holes filled from what is around them.
///
/// # Errors
/// [`Error::TooFew`] below ten intersected points.
pub fn heights_of_points(model: &BlockModel) -> Result<HeightModel, Error> {
    let points = positions(model);
    let shown = borders(model, &middle_of(&points));
    heights_of(&points, &shown)
}

/// The same on the map of the block, where it has one.
///
/// # Errors
/// As [`heights_of_points`], of points within the system.
pub(crate) fn heights_on_map(model: &BlockModel, map: Option<&BlockMap>) -> Result<HeightModel, Error> {
    let Some(map) = map else { return heights_of_points(model) };
    let points = positions(model);
    let middle = middle_of(&points);
    let [level, _] = middle.range();
    let shown = borders(model, &middle).into_iter().filter_map(|[x, y]| map.to_map([x, y, level])).map(|[x, y, _]| [x, y]);
    heights_of(&points.iter().filter_map(|point| map.to_map(*point)).collect::<Vec<_>>(), &shown.collect::<Vec<_>>())
}

fn positions(model: &BlockModel) -> Vec<[f64; 3]> {
    model.points.iter().filter_map(|point| point.position).collect()
}

/// Level ground at their median height.
fn middle_of(points: &[[f64; 3]]) -> Heights {
    Heights::Level(median(&mut points.iter().map(|p| p[2]).collect::<Vec<_>>()).unwrap_or(0.0))
}

/// The medians of these points in the cells of a grid over what images show.
fn heights_of(points: &[[f64; 3]], shown: &[[f64; 2]]) -> Result<HeightModel, Error> {
    if points.len() < 10 {
        return Err(Error::TooFew { few: Few::IntersectedPoints, got: points.len(), needed: 10 });
    }
    // One in fifty at each end may lie far off.
    let within = |axis: usize| {
        let mut values: Vec<f64> = points.iter().map(|p| p[axis]).collect();
        values.sort_by(f64::total_cmp);
        let cut = values.len() / 50;
        [values[cut], values[values.len() - 1 - cut]]
    };
    let reached = |axis: usize| {
        let values = shown.iter().map(|place| place[axis]);
        let [low, high] = within(axis);
        // As far as the points reach once more: images that look to the horizon show ground without any.
        [values.clone().fold(low, f64::min).max(2.0 * low - high), values.fold(high, f64::max).min(2.0 * high - low)]
    };
    let [[x0, x1], [y0, y1]] = [reached(0), reached(1)];
    let [wide, high] = [x1 - x0, y1 - y0].map(|length| length.max(1e-6));
    let cell = (wide * high * POINTS_IN_CELL / points.len() as f64).sqrt().max(wide.max(high) / MOST_CELLS);
    let [columns, rows] = [wide, high].map(|length| (length / cell).ceil().max(2.0) as usize);
    let georeference = Georeference::north_up([x0, y0 + rows as f64 * cell], cell);
    let mut held: Vec<Vec<f64>> = vec![Vec::new(); columns * rows];
    for &[x, y, z] in points {
        let [column, row] = georeference.pixel([x, y]);
        if column >= 0.0 && row >= 0.0 && column < columns as f64 && row < rows as f64 {
            held[row as usize * columns + column as usize].push(z);
        }
    }
    let mut heights: Vec<Option<f64>> = held.iter_mut().map(|cell| median(cell)).collect();
    fill(&mut heights, columns, rows);
    let values = heights.into_iter().map(|height| height.map_or(f32::NAN, |z| z as f32)).collect();
    HeightModel::new(columns, rows, values, georeference)
}

/// Gives holes the mean of the heights around them, from their edges inwards.
fn fill(heights: &mut [Option<f64>], columns: usize, rows: usize) {
    if heights.iter().all(Option::is_none) {
        return;
    }
    while heights.iter().any(Option::is_none) {
        let before = heights.to_vec();
        for k in (0..before.len()).filter(|k| before[*k].is_none()) {
            let (column, row) = (k % columns, k / columns);
            let (left, right) = (column.saturating_sub(1), (column + 1).min(columns - 1));
            let around = (row.saturating_sub(1)..=(row + 1).min(rows - 1)).flat_map(|r| (left..=right).map(move |c| r * columns + c));
            let (sum, number) = around.filter_map(|at| before[at]).fold((0.0, 0.0), |(sum, n), z| (sum + z, n + 1.0));
            heights[k] = (number > 0.0).then(|| sum / number);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_of_points_fill_their_holes() {
        let mut model = crate::model::tiny_block();
        let template = model.points[0].clone();
        model.points = (0..400)
            .map(|k| (f64::from(k % 20) * 5.0, f64::from(k / 20) * 5.0))
            .filter(|(x, y)| (x - 50.0).abs() > 12.0 || (y - 50.0).abs() > 12.0)
            .map(|(x, y)| crate::ObjectPoint { position: Some([x, y, 0.1 * x]), ..template.clone() })
            .collect();
        let heights = heights_of_points(&model).unwrap();
        for (x, y) in [(20.0, 20.0), (50.0, 50.0), (80.0, 30.0)] {
            let z = heights.at([x, y]).unwrap();
            assert!((z - 0.1 * x).abs() < 1.5, "{z} at {x} {y}");
        }
        model.points.truncate(5);
        assert!(heights_of_points(&model).is_err());
    }
}
