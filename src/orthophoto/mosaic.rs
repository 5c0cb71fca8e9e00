//! A quick orthomosaic of an oriented block: each place is taken from the image whose projection centre is nearest in plan.

use super::block_map::{BlockMap, borders, epsg_of};
use super::footprint::Footprint;
use super::georeference::Georeference;
use super::ground::Ground;
use super::heights::{HeightModel, Heights};
use super::links::reduced;
use super::map_nodes::MapNodes;
use super::rectify::{Rectified, rectify_from};
use crate::camera::Camera;
use crate::error::refuse;
use crate::math::median;
use crate::{BlockModel, BlockRun, Error, Few, GreyImage, GreyView, ModelImage, Pose, Refusal, halve};

/// Larger mosaics are made of larger pixels.
const MOST_PIXELS: f64 = 1e8;
/// An image is not halved to less than this, in px.
const LEAST_SIDE: usize = 16;
/// Points in a cell of the heights that the tie points give, on average.
const POINTS_IN_CELL: f64 = 4.0;
/// What an image shows of a map may reach so many px farther than its border on coarse ground.
const MARGIN_PX: f64 = 8.0;
/// Longest side of that grid.
const MOST_CELLS: f64 = 2000.0;

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

/// A mosaic that takes one image after the other; memory is that of the mosaic and of one image.
pub struct Mosaic {
    /// Of each image of the model; absent for one that is not oriented.
    images: Vec<Option<Laid>>,
    heights: Heights,
    /// The way into the system in which images are oriented, where the map is another one.
    nodes: Option<MapNodes>,
    epsg: Option<u16>,
    georeference: Georeference,
    size: [usize; 2],
    grey: Vec<u8>,
    /// Square of the distance in plan of the projection centre that each pixel was taken from.
    distance: Vec<f32>,
}

/// An oriented image, and where it lies on the map.
struct Laid {
    camera: Camera,
    pose: Pose,
    /// Its projection centre in plan, and the border of what it shows.
    centre: [f64; 2],
    border: Vec<[f64; 2]>,
    /// Side of its pixels on the map.
    gsd: f64,
}

/// What images of a block show of the ground in the system of their orientation.
fn laid_by(model: &BlockModel, heights: &Heights) -> Vec<Option<Laid>> {
    let laid = |image: &ModelImage| {
        let (camera, pose) = (model.cameras[image.camera], image.pose?);
        let footprint = Footprint { camera: &camera, pose: &pose, heights };
        let is_above = footprint.above_ground() > 0.0;
        let (border, gsd) = if is_above { (footprint.border(), footprint.gsd()) } else { (Vec::new(), 0.0) };
        Some(Laid { camera, pose, centre: [pose.position[0], pose.position[1]], border, gsd })
    };
    model.images.iter().map(laid).collect()
}

impl Laid {
    /// The same on a map; absent where its projection centre lies outside the system.
    fn on(self, map: &BlockMap, coarse: &Heights) -> Option<Self> {
        let [x, y, _] = map.to_map(self.pose.position)?;
        let [low, high] = coarse.range();
        let place = |[x, y]: [f64; 2]| map.to_map([x, y, coarse.at([x, y]).unwrap_or(0.5 * (low + high))]).map(|[x, y, _]| [x, y]);
        Some(Self { centre: [x, y], border: self.border.iter().copied().filter_map(place).collect(), gsd: self.gsd / map.unit_m, ..self })
    }
}

impl Mosaic {
    /// Lays out the picture of all ground that the oriented images show, in the system of the model. `gsd`: the side of a pixel; absent: that of the
    /// images, or what makes 100 MP.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] where no image is oriented, and for a side of a pixel that is none or makes more than 100 MP.
    pub fn new(model: &BlockModel, heights: Heights, gsd: Option<f64>) -> Result<Self, Error> {
        let images = laid_by(model, &heights);
        Self::of(images, heights, gsd)
    }

    /// The same of a block, in the system of its results: its coordinate reference system, where it has one. Heights count as the coordinates there do,
    /// in the unit of their own that their file says, or in that of the system; absent: those of the tie points.
    ///
    /// # Errors
    /// As [`new`](Self::new) and [`heights_of_points`]; [`Error::InvalidInput`] for a coordinate reference system in degrees, and for heights of another
    /// system than that of the block.
    pub fn of_block(run: &BlockRun, heights: Option<Heights>, gsd: Option<f64>) -> Result<Self, Error> {
        let map = BlockMap::of(run)?;
        let epsg = epsg_of(run, map.as_ref());
        let heights = match heights {
            Some(heights) => heights.for_ground(&map.as_ref().map_or_else(|| Ground::of_plane(epsg), BlockMap::ground))?,
            None => Heights::Model(heights_on_map(&run.model, map.as_ref())?),
        };
        let Some(map) = map else { return Ok(Self { epsg, ..Self::new(&run.model, heights, gsd)? }) };
        let Some(coarse) = map.coarse(&heights, &run.model) else { return refuse(Refusal::OutsideMap { crs: map.name() }) };
        let images = laid_by(&run.model, &coarse).into_iter().map(|image| image?.on(&map, &coarse)).collect();
        let mosaic = Self::of(images, heights, gsd)?;
        let nodes = MapNodes::new(&map, mosaic.georeference, mosaic.size, mosaic.heights.range());
        Ok(Self { nodes: Some(nodes), epsg, ..mosaic })
    }

    /// The same of a block in the system of its adjustment.
    ///
    /// # Errors
    /// As [`of_block`](Self::of_block).
    pub fn in_adjustment(run: &BlockRun, heights: Option<Heights>, gsd: Option<f64>) -> Result<Self, Error> {
        let epsg = if run.system().is_some() { None } else { epsg_of(run, None) };
        let heights = match heights {
            Some(heights) => heights.for_ground(&Ground::of_plane(epsg))?,
            None => Heights::Model(heights_of_points(&run.model)?),
        };
        Ok(Self { epsg, ..Self::new(&run.model, heights, gsd)? })
    }

    fn of(images: Vec<Option<Laid>>, heights: Heights, gsd: Option<f64>) -> Result<Self, Error> {
        let mut sides: Vec<f64> = images.iter().flatten().map(|image| image.gsd).filter(|gsd| *gsd > 0.0).collect();
        let Some(own) = median(&mut sides) else {
            return refuse(Refusal::NothingAboveGround);
        };
        let extent = |axis: usize| {
            let values = images.iter().flatten().flat_map(|image| &image.border).map(|place| place[axis]);
            [values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max)]
        };
        let [[x0, x1], [y0, y1]] = [extent(0), extent(1)];
        let finest = ((x1 - x0) * (y1 - y0) / MOST_PIXELS).sqrt();
        let gsd = gsd.unwrap_or(own.max(finest));
        if !(gsd >= finest && gsd > 0.0 && gsd.is_finite()) {
            return refuse(Refusal::MosaicPixel { gsd, least: finest });
        }
        let size = [x1 - x0, y1 - y0].map(|length| ((length / gsd).ceil() as usize).max(1));
        let pixels = size[0] * size[1];
        let georeference = Georeference::north_up([x0, y1], gsd);
        let (grey, distance) = (vec![0; pixels], vec![f32::INFINITY; pixels]);
        Ok(Self { images, heights, nodes: None, epsg: None, georeference, size, grey, distance })
    }

    /// The EPSG code of its system, where that is known.
    pub fn epsg(&self) -> Option<u16> {
        self.epsg
    }

    /// The heights on which it lies.
    pub fn heights(&self) -> &Heights {
        &self.heights
    }

    /// Adds an image of the model, by its index; one that is not oriented adds nothing.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for an index that the model does not have, and for an image of another size than its camera.
    pub fn add(&mut self, index: usize, image: GreyView<'_>) -> Result<(), Error> {
        let Some(known) = self.images.get(index) else {
            return refuse(Refusal::MosaicImage { image: index });
        };
        let Some(Laid { camera, pose, centre, border, gsd }) = known else { return Ok(()) };
        if [image.width(), image.height()] != [camera.width_px, camera.height_px].map(|side| side as usize) {
            let Camera { width_px, height_px, .. } = *camera;
            return refuse(Refusal::MosaicImageSize { width: image.width(), height: image.height(), width_px, height_px });
        }
        let corners: Vec<[f64; 2]> = border.iter().map(|place| self.georeference.pixel(*place)).collect();
        // Borders on a map are taken on coarse ground.
        let margin = if self.nodes.is_some() { MARGIN_PX } else { 0.0 };
        let range = |axis: usize| {
            let values = corners.iter().map(|corner| corner[axis]);
            let low = (values.clone().fold(f64::INFINITY, f64::min) - margin).max(0.0);
            let high = (values.fold(f64::NEG_INFINITY, f64::max) + margin).ceil().min(self.size[axis] as f64);
            (low as usize, high.max(low) as usize)
        };
        let [(left, right), (top, bottom)] = [range(0), range(1)];
        if right <= left || bottom <= top {
            return Ok(());
        }
        let mut own = image.to_image();
        let mut halvings = 0;
        let mut doubled = 2.0 * gsd;
        while doubled <= self.georeference.gsd() && own.width().min(own.height()) >= 2 * LEAST_SIDE {
            (own, halvings, doubled) = (halve(own.view()), halvings + 1, 2.0 * doubled);
        }
        let camera = reduced(camera, halvings, &own);
        let part = self.georeference.from(left, top);
        let to_image = |place: [f64; 3]| match &self.nodes {
            Some(nodes) => nodes.at(place),
            None => Some(place),
        };
        let size = [right - left, bottom - top];
        let Rectified { grey, mask, .. } = rectify_from(own.view(), &camera, pose, &self.heights, &part, size, to_image)?;
        for (row, line) in (top..bottom).enumerate() {
            for (column, at) in (left..right).enumerate() {
                if mask.view().at(column, row) == 0 {
                    continue;
                }
                let [x, y] = self.georeference.ground([at as f64 + 0.5, line as f64 + 0.5]);
                let [dx, dy] = [x - centre[0], y - centre[1]];
                let (distance, pixel) = ((dx * dx + dy * dy) as f32, line * self.size[0] + at);
                if distance < self.distance[pixel] {
                    (self.distance[pixel], self.grey[pixel]) = (distance, grey.view().at(column, row));
                }
            }
        }
        Ok(())
    }

    /// The mosaic of what was added.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] where no image showed any of it.
    pub fn finish(self) -> Result<Rectified, Error> {
        let [width, height] = self.size;
        if self.distance.iter().all(|distance| !distance.is_finite()) {
            return refuse(Refusal::EmptyMosaic);
        }
        let shown = self.distance.iter().map(|distance| if distance.is_finite() { 255 } else { 0 }).collect();
        let (grey, mask) = (GreyImage::new(width, height, self.grey)?, GreyImage::new(width, height, shown)?);
        Ok(Rectified { grey, mask, georeference: self.georeference })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BlockFlight, BlockScene};

    #[test]
    fn a_mosaic_of_true_orientations_is_the_orthophoto() {
        let flight = BlockFlight {
            strips: 1,
            exposures: 2,
            width_px: 300,
            height_px: 240,
            pixel_mm: 0.1,
            buildings: 0.0,
            trees: 0.0,
            ..BlockFlight::default()
        };
        let scene = BlockScene::new(&flight).unwrap();
        let orthophoto = scene.orthophoto(1.0).unwrap();
        let mut mosaic = Mosaic::new(&scene.truth(), orthophoto.heights.clone(), Some(1.0)).unwrap();
        (0..scene.photos()).for_each(|index| mosaic.add(index, scene.photo(index).unwrap().view()).unwrap());
        let made = mosaic.finish().unwrap();
        let own = orthophoto.grey().unwrap();
        // Grey values follow each other by one gain and offset.
        let (mut n, mut sums) = (0.0, [0.0; 5]);
        for k in 0..made.grey.data().len() {
            let (column, row) = (k % made.grey.width(), k / made.grey.width());
            let at = orthophoto.georeference.pixel(made.georeference.ground([column as f64 + 0.5, row as f64 + 0.5]));
            if made.mask.data()[k] == 255 && orthophoto.shows(at) {
                let (a, b) = (f64::from(made.grey.data()[k]), f64::from(own.view().at(at[0] as usize, at[1] as usize)));
                n += 1.0;
                [a, b, a * a, b * b, a * b].iter().zip(&mut sums).for_each(|(v, sum)| *sum += v);
            }
        }
        let [a, b, aa, bb, ab] = sums.map(|sum| sum / n);
        let correlation = (ab - a * b) / ((aa - a * a) * (bb - b * b)).sqrt();
        assert!(n > 50_000.0 && correlation > 0.85, "{n} px, correlation {correlation}");
    }

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
