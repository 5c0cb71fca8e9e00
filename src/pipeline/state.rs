//! What a run knows, from stage to stage.

use super::cameras::{check_distortion, contradicted, doubtful};
use super::control::LEAST_CONTROL;
use super::control_point::control_point;
use super::input::{Checked, RunInput};
use super::like_scans::cut_by_hand;
use super::observed::observed_position;
use super::system::{check_near, system_of, with_unit};
use super::{BlockRun, ControlTables, GivenPosition, InitialCamera, JoinedPoints, RefinementTable, RunImage, SkippedImage};
use crate::crs::{CoordinateSystem, Geoid, HeightZero};
use crate::error::refuse;
use crate::formats::UnreadColumns;
use crate::{
    BlockDescription, BlockModel, CameraCaution, Connection, ControlRole, Error, ExifPosition, Failure, FeatureMatch, GroundControlRow,
    ImageFeatures, ImpossiblePosition, KnownImage, Reconstruction, Refusal, Remark, TiePoints, TwoView, local_from_geographic,
};
use std::collections::{BTreeMap, BTreeSet};

/// Positions of an image's features in px.
pub(super) type Positions = Vec<[f32; 2]>;

/// What is known of an image once it was read.
pub(super) struct Read {
    pub image: RunImage,
    pub positions: Positions,
    /// Empty where the likeness of images is not asked for.
    pub coarse: Vec<u8>,
}

/// A pair that was matched.
pub(super) struct Matched {
    pub connection: Connection,
    pub geometry: Option<TwoView>,
    pub matches: Vec<FeatureMatch>,
    /// Whether its images have a frame in common.
    pub has_frame: bool,
}

/// What a run knows.
pub(super) struct State {
    pub given: RunInput,
    pub input: Checked,
    pub images: Vec<RunImage>,
    pub skipped: Vec<SkippedImage>,
    pub cameras: Vec<InitialCamera>,
    pub remarks: Vec<Remark>,
    pub unknown_images: Vec<String>,
    pub description: BlockDescription,
    /// Of each image; those of refined observations are moved.
    pub positions: Vec<Positions>,
    /// Descriptors of the coarsest features of each image, as long as the likeness of images is asked for.
    pub coarse: Vec<Vec<u8>>,
    pub pairs: Vec<Matched>,
    /// What is oriented: all points, or those whose observations are refined.
    pub points: TiePoints,
    /// Indices of the points that are chosen.
    pub chosen: Vec<u32>,
    pub joined: Option<JoinedPoints>,
    /// Keys of the windows of each image; empty where none are needed.
    pub windows: Vec<String>,
    pub refinement: Option<RefinementTable>,
    pub reconstruction: Option<Result<Reconstruction, Error>>,
    pub model: BlockModel,
    /// About the block; absent before it was read.
    pub geoid: Option<Geoid>,
}

impl State {
    pub fn new(given: RunInput, input: Checked) -> Self {
        Self {
            given,
            input,
            images: Vec::new(),
            skipped: Vec::new(),
            cameras: Vec::new(),
            remarks: Vec::new(),
            unknown_images: Vec::new(),
            description: BlockDescription::default(),
            positions: Vec::new(),
            coarse: Vec::new(),
            pairs: Vec::new(),
            points: TiePoints::default(),
            chosen: Vec::new(),
            joined: None,
            windows: Vec::new(),
            refinement: None,
            reconstruction: None,
            model: BlockModel::default(),
            geoid: None,
        }
    }

    /// Takes the images that were read.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for fewer than two images.
    pub fn take_images(&mut self, read: Vec<Read>, skipped: Vec<SkippedImage>) -> Result<(), Error> {
        let tried = read.len() + skipped.len();
        if read.len() < 2 {
            let (first, failure) = skipped.into_iter().next().map(|image| (image.name, image.reason)).unzip();
            return refuse(Refusal::FewImages { read: read.len(), given: tried, first, failure });
        }
        for Read { image, positions, coarse } in read {
            self.images.push(image);
            self.positions.push(positions);
            self.coarse.push(coarse);
        }
        self.skipped = skipped;
        let known = self.images.iter().map(|image| (image.name.as_str(), [image.width_px, image.height_px], &image.exif));
        let (cameras, of) = self.input.rules.group(known);
        self.cameras = cameras;
        self.images.iter_mut().zip(of).for_each(|(image, camera)| image.camera = camera);
        self.remarks.extend(self.input.unused_cameras.drain(..).map(|images| Remark::UnusedCamera { images }));
        if let Some(control) = &mut self.input.control {
            let UnreadColumns { unknown, doubled } = std::mem::take(&mut control.unread_columns);
            let (unnamed, of_marks) = (std::mem::take(&mut control.unnamed_errors), std::mem::take(&mut control.unread_mark_columns));
            type Of = fn(Vec<String>) -> Remark;
            let remarks: [(Vec<String>, Of); 7] = [
                (unknown, |columns| Remark::UnknownColumns { columns }),
                (doubled, |columns| Remark::DoubledColumns { columns }),
                (unnamed, |columns| Remark::UnnamedErrors { columns }),
                (of_marks, |columns| Remark::UnknownMarkColumns { columns }),
                (control.without_coordinates.clone(), |points| Remark::PointsWithoutCoordinates { points }),
                (control.unmeasured(), |points| Remark::UnmeasuredPoints { points }),
                (control.unknown_points(), |points| Remark::UnknownPoints { points }),
            ];
            self.remarks.extend(remarks.into_iter().filter(|(listed, _)| !listed.is_empty()).map(|(listed, remark)| remark(listed)));
        }
        self.remarks.extend(self.input.positions.iter().flat_map(|table| table.remarks(&self.input.images)));
        self.remarks.extend(doubtful(&self.cameras));
        let known = self.images.iter().map(|image| (image.name.as_str(), [image.width_px, image.height_px], &image.exif));
        self.remarks.extend(contradicted(&self.input.rules, known));
        self.remarks.extend(self.cautioned_cameras());
        self.remarks.extend(self.impossible_positions());
        Ok(())
    }

    /// What speaks against the cameras of the files whose cameras were not given, each once, with its images.
    fn cautioned_cameras(&self) -> Vec<Remark> {
        let mut found: Vec<(CameraCaution, Vec<String>)> = Vec::new();
        for image in self.images.iter().filter(|image| !self.input.rules.fits(&image.name)) {
            for caution in image.exif.camera.iter().flat_map(|camera| &camera.cautions) {
                match found.iter_mut().find(|(known, _)| known == caution) {
                    Some((_, images)) => images.push(image.name.clone()),
                    None => found.push((caution.clone(), vec![image.name.clone()])),
                }
            }
        }
        found.into_iter().map(|(camera_caution, images)| Remark::CautionedCameras { camera_caution, images }).collect()
    }

    fn impossible_positions(&self) -> Option<Remark> {
        let value = |image: &RunImage| Some(ImpossiblePosition { name: image.name.clone(), value: image.exif.impossible.clone()? });
        let used = self.images.iter().filter(|image| self.input.use_gnss && image.given.is_none());
        let images: Vec<ImpossiblePosition> = used.filter_map(value).collect();
        (!images.is_empty()).then_some(Remark::ImpossiblePositions { images })
    }

    /// Finds what is known of the block before its orientation, once its images, and the geoid where one is given, were read.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] for control points that these images do not show; as [`BlockDescription::check`].
    pub fn describe(&mut self) -> Result<(), Error> {
        self.take_given()?;
        let (description, unknown_images) = describe(&self.input, &self.images, &self.cameras)?;
        (self.description, self.unknown_images) = (description, unknown_images);
        Ok(())
    }

    /// Takes the positions of the table with heights above the ellipsoid, once it is known how high above it their zero lies.
    fn take_given(&mut self) -> Result<(), Error> {
        let Checked { positions, use_gnss, zero, settings, .. } = &self.input;
        let Some(table) = positions.as_ref().filter(|_| *use_gnss) else { return Ok(()) };
        let given = table.of_images(&self.input.images, &settings.placing, zero)?;
        let of: BTreeMap<&String, Option<GivenPosition>> = self.input.images.iter().zip(given).collect();
        for image in &mut self.images {
            image.given = of.get(&image.name).copied().flatten();
        }
        Ok(())
    }

    /// Longitudes and latitudes of the images, and of the ground control points in their system.
    pub fn places(&self) -> [Vec<[f64; 2]>; 2] {
        let given = self.images.iter().filter_map(|image| gnss(&self.input, image));
        let gnss: Vec<[f64; 2]> = given.map(|position| [position.longitude_deg, position.latitude_deg]).collect();
        let control = self.input.control.as_ref().map(ControlTables::plane).unwrap_or_default();
        let system = system_of(&self.input.settings.placing, &HeightZero::Unknown, &control, &gnss).ok().flatten();
        let on_earth = |[x, y]: [f64; 2]| system.as_ref()?.geographic([x, y, 0.0]).map(|[longitude, latitude, _]| [longitude, latitude]);
        let control = control.iter().filter_map(|point| on_earth(*point)).collect();
        [gnss, control]
    }

    /// GNSS positions in m east, north and up of the first of them.
    pub fn local_positions(&self) -> Vec<Option<[f64; 3]>> {
        let place = |image: &RunImage| {
            let position = gnss(&self.input, image)?;
            Some([position.longitude_deg, position.latitude_deg, position.height_m.unwrap_or(0.0)])
        };
        let places: Vec<Option<[f64; 3]>> = self.images.iter().map(place).collect();
        let origin = places.iter().flatten().next().copied();
        places.iter().map(|place| Some(local_from_geographic((*place)?, origin?))).collect()
    }

    pub fn features(&self) -> Vec<ImageFeatures<'_>> {
        let of = self.images.iter().zip(&self.positions);
        of.map(|(image, positions)| ImageFeatures { width_px: image.width_px, height_px: image.height_px, positions }).collect()
    }

    /// Images that have a frame in common with others, or nearly their size, as scans of film do from which no image of an ideal camera was made.
    fn like_scans(&self) -> Option<Remark> {
        let framed: BTreeSet<u32> = self.pairs.iter().filter(|pair| pair.has_frame).flat_map(|pair| pair.connection.images).collect();
        let is_unknown = |image: &RunImage| self.cameras[image.camera].focal_px.is_none();
        let sizes_px = self.images.iter().map(|image| is_unknown(image).then_some([image.width_px, image.height_px]));
        let cut = cut_by_hand(&sizes_px.collect::<Vec<_>>());
        let is_like = |index: usize| cut[index] || framed.contains(&(index as u32));
        let alike = self.images.iter().enumerate().filter(|(index, _)| is_like(*index));
        let images: Vec<String> = alike.map(|(_, image)| image.name.clone()).collect();
        (!images.is_empty()).then_some(Remark::LikeScans { images })
    }

    /// What the run has found, once all of its stages are done.
    pub fn ended(self) -> Option<BlockRun> {
        let like_scans = self.like_scans();
        let (connections, geometries) = self.pairs.into_iter().map(|pair| (pair.connection, pair.geometry)).unzip();
        Some(BlockRun {
            input: self.given,
            images: self.images,
            skipped: self.skipped,
            unused_masks: self.input.unused_masks,
            unknown_images: self.unknown_images,
            remarks: self.remarks.into_iter().chain(like_scans).collect(),
            cameras: self.cameras,
            connections,
            geometries,
            points: Some(self.joined?),
            refinement: self.refinement,
            reconstruction: self.reconstruction?.map_err(|error| Failure::from(&error)),
            model: self.model,
            edited: None,
            orthophoto: None,
            geoid: self.geoid,
        })
    }
}

/// The GNSS position of an image, where a run uses it.
fn gnss<'a>(input: &Checked, image: &'a RunImage) -> Option<&'a ExifPosition> {
    image.gnss().filter(|_| input.use_gnss)
}

/// Whether the GNSS position of an image has a height that counts from where those of control points do.
fn has_height_of(image: &RunImage, zero: &HeightZero) -> bool {
    zero.is_known() || image.given.is_some_and(|given| given.in_crs)
}

/// What is known of a block before its orientation, and the images that measurements name and that are not in it.
///
/// GNSS positions and ground control points without a coordinate reference system are of different systems: these points alone georeference
/// the block then, and the distances between GNSS positions say whether they are in metres. With one both do; heights of GNSS positions only where
/// it is known how high above the ellipsoid the zero of the others is.
pub(super) fn describe(input: &Checked, images: &[RunImage], cameras: &[InitialCamera]) -> Result<(BlockDescription, Vec<String>), Error> {
    describe_with(input, &[], images, cameras)
}

/// The same with further surveyed points behind those that were given, without any image measurements.
pub(super) fn describe_with(
    input: &Checked,
    further: &[GroundControlRow],
    images: &[RunImage],
    cameras: &[InitialCamera],
) -> Result<(BlockDescription, Vec<String>), Error> {
    check_distortion(cameras)?;
    let placing = &input.settings.placing;
    let places: Vec<[f64; 2]> =
        images.iter().filter_map(|image| gnss(input, image)).map(|place| [place.longitude_deg, place.latitude_deg]).collect();
    let mut plane = input.control.as_ref().map(ControlTables::plane).unwrap_or_default();
    plane.extend(further.iter().map(|row| [row.position[0], row.position[1]]));
    let named = |error: Error| with_unit(error, placing, &plane, &places);
    let system = system_of(placing, &input.zero, &plane, &places).map_err(named)?;
    let names: Vec<String> = images.iter().map(|image| image.name.clone()).collect();
    // GNSS positions in the system of the points, and heights that count from where theirs do, place the block by themselves.
    let placing_images =
        |zero: &HeightZero| images.iter().filter(|image| gnss(input, image).is_some() && has_height_of(image, zero)).count();
    let has_places = system.as_ref().is_some_and(|system| placing_images(system.zero()) >= LEAST_CONTROL);
    let least = if has_places || input.on_orthophoto { 0 } else { LEAST_CONTROL };
    let joined = input.control.as_ref().map(|control| control.join(&names, placing, &input.zero, least)).transpose().map_err(named)?;
    let (mut control, unknown_images) = joined.unwrap_or_default();
    let placing_points = control.iter().filter(|point| point.role == ControlRole::Control && point.measurements.len() >= 2).count();
    // Too few to place a block by themselves wait as check points for the orthophoto that does.
    if input.on_orthophoto && !has_places && placing_points < LEAST_CONTROL {
        control.iter_mut().for_each(|point| point.role = ControlRole::Check);
    }
    for row in further {
        control.push(control_point(row, row.role.unwrap_or_default(), placing, system.as_ref()).map_err(named)?);
    }
    system.iter().try_for_each(|system| check_near(&control, &places, system)).map_err(named)?;
    let zero = system.as_ref().map(CoordinateSystem::zero);
    // Heights above an unknown zero are those of the block where control points have them, and where positions of a table do.
    let in_crs = images.iter().any(|image| image.given.is_some_and(|given| given.in_crs && given.position.height_m.is_some()));
    let has_heights = |image: &RunImage| zero.is_none_or(|zero| has_height_of(image, zero)) || (control.is_empty() && !in_crs);
    let known = known_images(input, images, has_heights);
    let cameras = cameras.iter().map(InitialCamera::to_be_calibrated).collect();
    let description = BlockDescription { cameras, images: known, control };
    description.check()?;
    Ok((description, unknown_images))
}

/// What is known of images before their orientation. `has_heights`: whether the height of an image's GNSS position counts from where others of the block do.
pub(super) fn known_images(input: &Checked, images: &[RunImage], has_heights: impl Fn(&RunImage) -> bool) -> Vec<KnownImage> {
    let observed = |image: &RunImage| {
        gnss(input, image)?;
        observed_position(image, &input.settings.placing, has_heights(image))
    };
    let image = |image: &RunImage| KnownImage {
        name: image.name.clone(),
        camera: image.camera,
        position: observed(image),
        view: image.exif.drone.as_ref().and_then(|drone| drone.view()),
    };
    images.iter().map(image).collect()
}

impl BlockRun {
    /// The GNSS positions of its images, where it uses them.
    pub(crate) fn gnss_positions(&self) -> impl Iterator<Item = &ExifPosition> {
        self.images.iter().filter(|_| self.input.use_gnss).filter_map(RunImage::gnss)
    }

    /// Whether GNSS positions place it in the system of its ground control points: in that which was chosen, with heights that count from where theirs do.
    pub(crate) fn has_known_zero(&self) -> bool {
        let has_height = |image: &&RunImage| image.gnss().is_some_and(|position| position.height_m.is_some());
        let placing =
            |system: &CoordinateSystem| self.images.iter().filter(has_height).filter(|image| has_height_of(image, system.zero())).count();
        self.input.use_gnss && self.system().is_some_and(|system| placing(&system) >= LEAST_CONTROL)
    }

    /// The coordinate reference system that was chosen, at the place of the block; absent where none was, and where the block has no place on the earth.
    pub(crate) fn system(&self) -> Option<CoordinateSystem> {
        self.model.origin?;
        let input = &self.input;
        let control = input.control.as_ref().and_then(|texts| ControlTables::read(&texts.points, &texts.marks).ok());
        let mut plane = control.as_ref().map(ControlTables::plane).unwrap_or_default();
        plane.extend(self.added_control().map(|row| [row.position[0], row.position[1]]));
        let gnss: Vec<[f64; 2]> = self.gnss_positions().map(|position| [position.longitude_deg, position.latitude_deg]).collect();
        let zero = input.zero(self.geoid.as_ref());
        system_of(&input.settings.placing, &zero, &plane, &gnss).ok().flatten()
    }
}
