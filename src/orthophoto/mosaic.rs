//! A quick orthomosaic of an oriented block: each place is taken from the image whose projection centre is nearest in plan.

use super::block_map::{BlockMap, epsg_of};
use super::chosen::chosen;
use super::footprint::Footprint;
use super::ground::Ground;
use super::heights::Heights;
use super::links::reduced;
use super::map_nodes::MapNodes;
use super::mosaic_tiles::{MosaicTiles, Reach, most_waiting, order};
use super::other_zero::{OtherZero, other_zero};
use super::point_heights::{heights_of_points, heights_on_map};
use super::rectify::Seen;
use super::samples::Samples;
use super::tiled_file::TiledFile;
use crate::Georeference;
use crate::camera::Camera;
use crate::error::refuse;
use crate::image::Neighbours;
use crate::math::median;
use crate::{Bands, BlockModel, BlockRun, Datum, Error, GeographicOrigin, ModelImage, Pose, Refusal, Remark, halve};
use std::io::{Seek, Write};

/// Larger mosaics are made of larger pixels.
const MOST_PIXELS: f64 = 4e9;
/// Of a mosaic that is laid under the map of its block, which is read whole where it is halved.
const MOST_UNDER_MAP: f64 = 1e8;
/// Bytes of tiles that wait for images at once: a browser has 4 GB for all.
const MOST_WAITING: f64 = 1.5e9;
/// An image is not halved to less than this, in px.
const LEAST_SIDE: usize = 16;
/// What an image shows of a map may reach so many px farther than its border on coarse ground.
const MARGIN_PX: f64 = 8.0;

/// A mosaic that takes one image after the other and is written as GeoTIFF meanwhile: memory is that of one image, and of the tiles that wait for more.
pub struct Mosaic {
    /// Of each image of the model; absent for one that is not oriented, or not chosen.
    images: Vec<Option<Laid>>,
    heights: Heights,
    /// The way into the system in which images are oriented, where the map is another one.
    nodes: Option<MapNodes>,
    epsg: Option<u16>,
    /// The unit of the map in m.
    unit_m: Option<f64>,
    /// What is to be said of the heights.
    remark: Option<Remark>,
    georeference: Georeference,
    size: [usize; 2],
    /// From the first image on, which says whether it has colours.
    tiles: Option<MosaicTiles>,
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
    /// The columns and rows of the mosaic within which that is.
    reach: Reach,
}

/// What those images of a block show of the ground in the system of their orientation.
fn laid_by(model: &BlockModel, chosen: &[bool], heights: &Heights) -> Vec<Option<Laid>> {
    let laid = |image: &ModelImage| {
        let (camera, pose) = (model.cameras[image.camera], image.pose?);
        let footprint = Footprint { camera: &camera, pose: &pose, heights };
        let is_above = footprint.above_ground() > 0.0;
        let (border, gsd) = if is_above { (footprint.border(), footprint.gsd()) } else { (Vec::new(), 0.0) };
        Some(Laid { camera, pose, centre: [pose.position[0], pose.position[1]], border, gsd, reach: [0..0, 0..0] })
    };
    model.images.iter().zip(chosen).map(|(image, chosen)| if *chosen { laid(image) } else { None }).collect()
}

impl Laid {
    /// The columns and rows of a mosaic that it may show.
    fn reached(&self, georeference: &Georeference, size: [usize; 2], margin_px: f64) -> Reach {
        let corners: Vec<[f64; 2]> = self.border.iter().map(|place| georeference.pixel(*place)).collect();
        [0, 1].map(|axis| {
            let values = corners.iter().map(|corner| corner[axis]);
            let low = (values.clone().fold(f64::INFINITY, f64::min) - margin_px).max(0.0);
            let high = (values.fold(f64::NEG_INFINITY, f64::max) + margin_px).ceil().min(size[axis] as f64);
            low as usize..high.max(low) as usize
        })
    }

    /// The same on a map; absent where its projection centre lies outside the system.
    fn on(self, map: &BlockMap, coarse: &Heights) -> Option<Self> {
        let [x, y, _] = map.to_map(self.pose.position)?;
        let [low, high] = coarse.range();
        let place = |[x, y]: [f64; 2]| map.to_map([x, y, coarse.at([x, y]).unwrap_or(0.5 * (low + high))]).map(|[x, y, _]| [x, y]);
        Some(Self { centre: [x, y], border: self.border.iter().copied().filter_map(place).collect(), gsd: self.gsd / map.unit_m, ..self })
    }
}

/// What is to be said of a block whose mosaic has no coordinate reference system to name.
fn without_system(run: &BlockRun) -> Option<Remark> {
    match run.model.origin {
        Some(GeographicOrigin { latitude_deg, longitude_deg, .. }) => Some(Remark::MosaicWithoutSystem { latitude_deg, longitude_deg }),
        // Surveyed points and orthophotos have a system, whether it has a name or not.
        None => (run.reconstruction.as_ref().ok()?.models.first()?.adjusted.datum == Datum::Free).then_some(Remark::MosaicWithoutPlace),
    }
}

/// What is to be said of heights that count from elsewhere than those of the system of a block.
fn other_heights(run: &BlockRun, heights: &Heights, map: &BlockMap) -> Option<Remark> {
    let zero = map.zero_of(run.input.zero(run.geoid.as_ref()));
    let OtherZero { name, from_ellipsoid, above_m } = other_zero(heights.vertical()?, &zero, || Some(map.place()))?;
    Some(Remark::MosaicHeights { heights: name, from_ellipsoid, crs: map.name(), above_m })
}

impl Mosaic {
    /// Lays out the picture of all ground that the oriented images show, in the system of the model. `gsd`: the side of a pixel; absent: that of the
    /// images, or the least that is allowed.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] where no image is oriented, and for a side of a pixel that is none, makes more than 4000 MP, or has more than 1.5 GB wait in
    /// memory for further images.
    pub fn new(model: &BlockModel, heights: Heights, gsd: Option<f64>) -> Result<Self, Error> {
        let images = laid_by(model, &chosen(model, &[])?, &heights);
        Self::of(images, heights, gsd, MOST_PIXELS, 0.0)
    }

    /// The same of a block, in the system of its results: its coordinate reference system, where it has one. Heights count as the coordinates there do,
    /// in the unit of their own that their file says, or in that of the system; absent: those of the tie points.
    ///
    /// # Errors
    /// As [`new`](Self::new) and [`heights_of_points`]; [`Error::InvalidInput`] for a coordinate reference system in degrees, and for heights of another
    /// system than that of the block.
    pub fn of_block(run: &BlockRun, heights: Option<Heights>, gsd: Option<f64>) -> Result<Self, Error> {
        Self::of_images(run, &[], heights, gsd)
    }

    /// The same of some images of the block, by their names, all where there are none: of one image it is that image resampled to the ground. It reaches as
    /// far as these do.
    ///
    /// # Errors
    /// As [`of_block`](Self::of_block); [`Error::InvalidInput`] for a name of no oriented image.
    pub fn of_images(run: &BlockRun, names: &[String], heights: Option<Heights>, gsd: Option<f64>) -> Result<Self, Error> {
        let chosen = chosen(&run.model, names)?;
        let map = BlockMap::of(run)?;
        let epsg = epsg_of(run, map.as_ref());
        let remark = heights.as_ref().zip(map.as_ref()).and_then(|(heights, map)| other_heights(run, heights, map));
        let heights = match heights {
            Some(heights) => heights.for_ground(&map.as_ref().map_or_else(|| Ground::of_plane(epsg), BlockMap::ground))?,
            None => Heights::Model(heights_on_map(&run.model, map.as_ref())?),
        };
        let Some(map) = map else {
            let images = laid_by(&run.model, &chosen, &heights);
            return Ok(Self { epsg, remark: without_system(run), ..Self::of(images, heights, gsd, MOST_PIXELS, 0.0)? });
        };
        let Some(coarse) = map.coarse(&heights, &run.model) else { return refuse(Refusal::OutsideMap { crs: map.name() }) };
        let images = laid_by(&run.model, &chosen, &coarse).into_iter().map(|image| image?.on(&map, &coarse)).collect();
        // Borders are taken on coarse ground.
        let mosaic = Self::of(images, heights, gsd, MOST_PIXELS, MARGIN_PX)?;
        let nodes = MapNodes::new(&map, mosaic.georeference, mosaic.size, mosaic.heights.range());
        Ok(Self { nodes: Some(nodes), epsg, unit_m: Some(map.unit_m), remark, ..mosaic })
    }

    /// The same of a block in the system of its adjustment, as it is laid under its map: of 100 MP at most.
    ///
    /// # Errors
    /// As [`of_images`](Self::of_images).
    pub fn in_adjustment(run: &BlockRun, names: &[String], heights: Option<Heights>, gsd: Option<f64>) -> Result<Self, Error> {
        let epsg = if run.system().is_some() { None } else { epsg_of(run, None) };
        let heights = match heights {
            Some(heights) => heights.for_ground(&Ground::of_plane(epsg))?,
            None => Heights::Model(heights_of_points(&run.model)?),
        };
        let images = laid_by(&run.model, &chosen(&run.model, names)?, &heights);
        Ok(Self { epsg, ..Self::of(images, heights, gsd, MOST_UNDER_MAP, 0.0)? })
    }

    /// `most`: so many pixels at most; `margin_px`: so many px farther than its border may an image reach.
    fn of(mut images: Vec<Option<Laid>>, heights: Heights, gsd: Option<f64>, most: f64, margin_px: f64) -> Result<Self, Error> {
        let mut sides: Vec<f64> = images.iter().flatten().map(|image| image.gsd).filter(|gsd| *gsd > 0.0).collect();
        let Some(own) = median(&mut sides) else {
            return refuse(Refusal::NothingAboveGround);
        };
        let extent = |axis: usize| {
            let values = images.iter().flatten().flat_map(|image| &image.border).map(|place| place[axis]);
            [values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max)]
        };
        let [[x0, x1], [y0, y1]] = [extent(0), extent(1)];
        let area = (x1 - x0) * (y1 - y0);
        let laid_out = |gsd: f64| {
            let size = [x1 - x0, y1 - y0].map(|length| ((length / gsd).ceil() as usize).max(1));
            let georeference = Georeference::north_up([x0, y1], gsd);
            let reaches = images.iter().map(|image| image.as_ref().map(|image| image.reached(&georeference, size, margin_px)));
            (georeference, size, reaches.collect::<Vec<_>>())
        };
        let mut finest = (area / most).sqrt();
        let wanted = gsd.unwrap_or(own).max(finest);
        if wanted > 0.0 && wanted.is_finite() && finest.is_finite() {
            let (_, size, reaches) = laid_out(wanted);
            let waiting = most_waiting(&reaches, size) as f64;
            if waiting > MOST_WAITING {
                finest = wanted * (waiting / MOST_WAITING).sqrt();
            }
        }
        let gsd = gsd.unwrap_or(own.max(finest));
        if !(gsd >= finest && gsd > 0.0 && gsd.is_finite()) {
            return refuse(Refusal::MosaicPixel { gsd, least: finest, megapixels: (area / (finest * finest) / 1e6).round() });
        }
        let (georeference, size, reaches) = laid_out(gsd);
        images
            .iter_mut()
            .zip(reaches)
            .for_each(|(image, reach)| image.iter_mut().zip(reach).for_each(|(image, reach)| image.reach = reach));
        Ok(Self { images, heights, nodes: None, epsg: None, unit_m: None, remark: None, georeference, size, tiles: None })
    }

    /// The indices of the oriented images, in an order in which few tiles wait: along the longer side of the mosaic.
    pub fn order(&self) -> Vec<usize> {
        let reaches: Vec<Option<Reach>> = self.images.iter().map(|image| image.as_ref().map(|image| image.reach.clone())).collect();
        order(&reaches, self.size)
    }

    /// What is to be said of the heights that were given: that they count from elsewhere than those of the block's coordinate reference system.
    pub fn remark(&self) -> Option<&Remark> {
        self.remark.as_ref()
    }

    /// Width and height in px.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The EPSG code of its system, where that is known.
    pub fn epsg(&self) -> Option<u16> {
        self.epsg
    }

    /// The heights on which it lies.
    pub fn heights(&self) -> &Heights {
        &self.heights
    }

    /// Adds an image of the model, by its index, once; one that is not oriented adds nothing. The mosaic has colours where the first image that is added
    /// has. Tiles that no further image reaches are written to `out`, which is empty before the first image, and the same for all.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for an index that the model does not have, and for an image of another size than its camera; [`Error::NotWritten`].
    pub fn add(&mut self, index: usize, image: &Bands, out: &mut (impl Write + Seek)) -> Result<(), Error> {
        let Some(known) = self.images.get(index) else {
            return refuse(Refusal::MosaicImage { image: index });
        };
        let Some(Laid { camera, pose, centre, gsd, reach, .. }) = known else { return Ok(()) };
        if [image.width(), image.height()] != [camera.width_px, camera.height_px].map(|side| side as usize) {
            let Camera { width_px, height_px, .. } = *camera;
            return refuse(Refusal::MosaicImageSize { width: image.width(), height: image.height(), width_px, height_px });
        }
        let tiles = match &mut self.tiles {
            Some(tiles) => tiles,
            none => {
                let samples = Samples::Bytes(image.images().len());
                let file = TiledFile::begin(self.size, samples, self.georeference, self.epsg, self.unit_m, out)?;
                none.insert(MosaicTiles::new(file, samples, self.images.iter().flatten().map(|image| &image.reach)))
            }
        };
        let mut smaller: Option<Bands> = (image.are_colours() && !tiles.has_colours()).then(|| image.to_grey().into());
        let mut halvings = 0;
        let mut doubled = 2.0 * gsd;
        while let own = smaller.as_ref().unwrap_or(image)
            && doubled <= self.georeference.gsd()
            && own.width().min(own.height()) >= 2 * LEAST_SIDE
        {
            (smaller, halvings, doubled) = (Some(own.map(halve)), halvings + 1, 2.0 * doubled);
        }
        let own = smaller.as_ref().unwrap_or(image);
        let (size, views) = ([own.width(), own.height()], own.views());
        let camera = reduced(camera, halvings, &own.images()[0]);
        let seen = Seen::new(&camera, pose);
        let to_image = |place: [f64; 3]| match &self.nodes {
            Some(nodes) => nodes.at(place),
            None => Some(place),
        };
        for (index, [columns, rows]) in tiles.reached(reach) {
            let (side, [left, top]) = tiles.place(index);
            let tile = tiles.hold(index);
            let bytes = tile.values.len() / tile.distance.len();
            for (column, row) in rows.flat_map(|row| columns.clone().map(move |column| (column, row))) {
                let place = self.georeference.ground([column as f64 + 0.5, row as f64 + 0.5]);
                let [dx, dy] = [place[0] - centre[0], place[1] - centre[1]];
                let (distance, pixel) = ((dx * dx + dy * dy) as f32, (row - top) * side + column - left);
                if distance >= tile.distance[pixel] {
                    continue;
                }
                let Some(at) = seen.ground(place, &self.heights, &to_image) else { continue };
                tile.distance[pixel] = distance;
                let neighbours = Neighbours::about(at, size);
                let own = &mut tile.values[pixel * bytes..][..bytes];
                // The grey value of an image without colours is each of them; 0 stands for nothing.
                own.iter_mut().zip(views.iter().cycle()).for_each(|(byte, band)| *byte = neighbours.mean(*band).max(1));
            }
        }
        self.came(index, out)
    }

    /// An image, by its index, that will not be added: tiles need not wait for it.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for an index that the model does not have; [`Error::NotWritten`].
    pub fn leave_out(&mut self, index: usize, out: &mut impl Write) -> Result<(), Error> {
        if index >= self.images.len() {
            return refuse(Refusal::MosaicImage { image: index });
        }
        self.came(index, out)
    }

    /// Nothing more is shown by an image: it waits for none, and reaches no tile.
    fn came(&mut self, index: usize, out: &mut impl Write) -> Result<(), Error> {
        let Some(image) = &mut self.images[index] else { return Ok(()) };
        let reach = std::mem::take(&mut image.reach);
        self.tiles.as_mut().map_or(Ok(()), |tiles| tiles.came(&reach, out))
    }

    /// Writes what is left, and to the beginning of `out` where in it the rest is found.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] where no image was added, or none showed any of it, whatever was written; [`Error::NotWritten`].
    pub fn finish(self, out: &mut (impl Write + Seek)) -> Result<(), Error> {
        let Some(tiles) = self.tiles else { return refuse(Refusal::MosaicWithoutImages) };
        if tiles.finish(out)? { Ok(()) } else { refuse(Refusal::EmptyMosaic) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BlockFlight, BlockScene, DecodeLimits, GreyImage, Orthophoto, decode_bands};
    use std::io::Cursor;

    #[test]
    fn a_mosaic_to_which_no_image_was_added_says_so() {
        let flight = BlockFlight { strips: 1, exposures: 2, width_px: 64, height_px: 48, pixel_mm: 0.5, ..BlockFlight::default() };
        let mosaic = Mosaic::new(&BlockScene::new(&flight).unwrap().truth(), Heights::Level(0.0), None).unwrap();
        let told = mosaic.finish(&mut Cursor::new(Vec::new())).unwrap_err().to_string();
        assert!(told.starts_with("mosaic: got no oriented image; allowed: images of the block, added one by one"), "{told}");
    }

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
        // The second photo in colours, which are its grey values and their opposite.
        let (grey, mut file) = (scene.photo(1).unwrap(), Cursor::new(Vec::new()));
        let opposite = GreyImage::from_fn(grey.width(), grey.height(), |c, r| 255 - grey.view().at(c, r)).unwrap();
        assert_eq!(mosaic.order().len(), 2);
        assert!(matches!(mosaic.leave_out(2, &mut file), Err(Error::InvalidInput { .. })));
        mosaic.add(1, &Bands::colours([grey.clone(), opposite, grey]).unwrap(), &mut file).unwrap();
        // It comes once.
        mosaic.leave_out(1, &mut file).unwrap();
        mosaic.add(1, &GreyImage::new(300, 240, vec![9; 72_000]).unwrap().into(), &mut file).unwrap();
        mosaic.add(0, &scene.photo(0).unwrap().into(), &mut file).unwrap();
        mosaic.finish(&mut file).unwrap();
        let file = file.into_inner();
        let bands = decode_bands(&file, &DecodeLimits::default()).unwrap();
        let [grey, green, blue] = bands.images() else { panic!("no colours") };
        assert_eq!(grey, blue);
        let shown = || (0..grey.data().len()).map(|k| [grey.data()[k], green.data()[k]]).filter(|values| *values != [0, 0]);
        let [coloured, equal] =
            [shown().filter(|[red, green]| red.abs_diff(255 - green) <= 1).count(), shown().filter(|[red, green]| red == green).count()];
        assert!(coloured.min(equal) > 20_000 && coloured + equal + 100 > shown().count(), "{coloured} and {equal}");
        let made = Orthophoto::read(&file, None, Heights::Level(0.0), &DecodeLimits::default()).unwrap();
        let own = orthophoto.grey().unwrap();
        // Grey values follow each other by one gain and offset.
        let (mut n, mut sums) = (0.0, [0.0; 5]);
        for k in 0..grey.data().len() {
            let (column, row) = (k % grey.width(), k / grey.width());
            let at = orthophoto.georeference.pixel(made.georeference.ground([column as f64 + 0.5, row as f64 + 0.5]));
            if grey.data()[k] > 0 && orthophoto.shows(at) {
                let (a, b) = (f64::from(grey.data()[k]), f64::from(own.view().at(at[0] as usize, at[1] as usize)));
                n += 1.0;
                [a, b, a * a, b * b, a * b].iter().zip(&mut sums).for_each(|(v, sum)| *sum += v);
            }
        }
        let [a, b, aa, bb, ab] = sums.map(|sum| sum / n);
        let correlation = (ab - a * b) / ((aa - a * a) * (bb - b * b)).sqrt();
        assert!(n > 50_000.0 && correlation > 0.85, "{n} px, correlation {correlation}");
    }
}
