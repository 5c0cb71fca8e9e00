//! The project file: one line that says what it is, and one of JSON that is checked against it.

mod version_1;

use crate::crs::Geoid;
use crate::error::refuse;
use crate::json;
use crate::pipeline::check_steps;
use crate::text::shorten;
use crate::{
    BlockModel, BlockRun, Document, Error, FileFault, FilePlace, Input, ObservationVerdict, PairRun, ReconstructedModel, Reconstruction,
    Refusal, SystematicError, SystematicResult,
};
use serde::{Deserialize, Serialize};

/// The newest version that is read. The file of a pair has the oldest version that holds all that is in it. Blocks stay of version 2: a reader that does
/// not know a warning or field of theirs refuses them and names it.
pub const PROJECT_VERSION: u32 = 3;

/// Of blocks, and of pairs whose matches were not edited by hand.
const PLAIN_VERSION: u32 = 2;

const FORMAT: &str = "tiepoint-project";

/// All that is known of what was oriented, what was given for it included: it is shown as it was before it was saved.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Project {
    Block(Box<BlockRun>),
    /// The smallest one.
    Pair(Box<PairRun>),
}

/// What a project file holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub enum ProjectKind {
    Block,
    Pair,
}

/// What a project file holds, as the first of its bytes say: a kilobyte is enough. `None` for what is no project; its reading says why.
pub fn project_kind(start: &[u8]) -> Option<ProjectKind> {
    let body = start.splitn(2, |byte| *byte == b'\n').nth(1)?;
    [(ProjectKind::Block, "{\"block\":"), (ProjectKind::Pair, "{\"pair\":")]
        .into_iter()
        .find_map(|(kind, begins)| body.starts_with(begins.as_bytes()).then_some(kind))
}

/// The first line.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct Header {
    format: String,
    version: u32,
    /// Length of all that follows the first line.
    bytes: usize,
    /// Its CRC-32 (ISO 3309) in hexadecimal digits.
    crc32: String,
}

/// Writes the project of a block: the same block gives the same text.
///
/// # Errors
/// As [`BlockModel::check`](crate::BlockModel::check); [`Error::InvalidInput`] for parts of the block that do not fit together.
pub fn write_block_project(run: &BlockRun) -> Result<String, Error> {
    check(run)?;
    written(PLAIN_VERSION, "block", run)
}

/// Writes the project of a pair: the same pair gives the same text.
///
/// # Errors
/// [`Error::InvalidInput`] for parts of the pair that do not fit together.
pub fn write_pair_project(run: &PairRun) -> Result<String, Error> {
    let run = run.clone().in_order()?;
    written(if run.edited.is_some() { PROJECT_VERSION } else { PLAIN_VERSION }, "pair", &run)
}

/// Reads a project; one of an older version is brought forward. Nothing is passed over: a file that this version does not understand in full is
/// refused whole, so that nothing is lost by writing it again.
///
/// # Errors
/// [`Error::UnreadableFile`] for another kind of file, a newer version, a damaged or shortened file, and what does not belong there; as
/// [`write_block_project`].
pub fn read_project(bytes: &[u8]) -> Result<Project, Error> {
    let refused = |place: FilePlace, file_fault: FileFault| {
        Err(Error::UnreadableFile { document: Document::Project, file_place: Some(place), file_fault })
    };
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text,
        Err(error) => return refused(FilePlace::Byte { byte: error.valid_up_to() }, FileFault::NotText),
    };
    let Some((line, body)) = text.split_once('\n') else {
        return refused(FilePlace::Line { line: 1 }, FileFault::NoProject { line: shorten(text) });
    };
    let header: Header = match json::from_text(line) {
        Ok(header) => header,
        Err(json_fault) => {
            return refused(FilePlace::Line { line: 1 }, FileFault::NoHeader { line: shorten(line), json_fault: Box::new(json_fault) });
        }
    };
    if header.format != FORMAT {
        return refused(FilePlace::Line { line: 1 }, FileFault::OtherFormat { format: shorten(&header.format), wanted: FORMAT.into() });
    }
    if !(1..=PROJECT_VERSION).contains(&header.version) {
        return refused(FilePlace::Line { line: 1 }, FileFault::OtherVersion { version: header.version, newest: PROJECT_VERSION });
    }
    if header.bytes != body.len() {
        return refused(FilePlace::Length, FileFault::OtherLength { bytes: body.len(), declared: header.bytes });
    }
    if header_line(header.version, body)?.trim_end() != line {
        return refused(FilePlace::Checksum, FileFault::OtherChecksum);
    }
    // With the end of the first line, so that places count as in the file.
    let rest = &text[line.len()..];
    let read = match header.version {
        1 => json::from_text(rest).map(|older: version_1::Project| Project::Block(Box::new(older.into()))),
        _ => json::from_text(rest),
    };
    match read {
        Ok(Project::Block(run)) => check(&run).map(|()| Project::Block(Box::new(run.numbered()))),
        Ok(Project::Pair(run)) => run.in_order().map(|run| Project::Pair(Box::new(run))),
        Err(json_fault) => refused(FilePlace::Content, FileFault::Content { json_fault: Box::new(json_fault) }),
    }
}

fn written(version: u32, kind: &str, content: &impl Serialize) -> Result<String, Error> {
    let content =
        serde_json::to_string(content).map_err(|error| Error::InvalidJson { document: Document::Project, json_fault: error.into() })?;
    let body = format!("{{\"{kind}\":{content}}}\n");
    Ok(header_line(version, &body)? + &body)
}

fn header_line(version: u32, body: &str) -> Result<String, Error> {
    let header = Header { format: FORMAT.into(), version, bytes: body.len(), crc32: format!("{:08x}", crc32fast::hash(body.as_bytes())) };
    Ok(serde_json::to_string(&header).map_err(|e| Error::InvalidJson { document: Document::Project, json_fault: e.into() })? + "\n")
}

/// Refuses a block whose parts do not fit together.
fn check(run: &BlockRun) -> Result<(), Error> {
    same(Input::GeometriesOfProject, run.geometries.len(), run.connections.len())?;
    let images = run.images.len();
    if let Some(connection) = run.connections.iter().find(|c| c.images[0] >= c.images[1] || c.images[1] as usize >= images) {
        return refuse(Refusal::ProjectConnection { images: connection.images, count: images });
    }
    if !run.geoid.as_ref().is_none_or(Geoid::is_whole) {
        return refuse(Refusal::ProjectGeoid);
    }
    check_oriented(run, &run.model, run.reconstruction.as_ref().ok())?;
    let Some(found) = &run.edited else { return Ok(()) };
    if !run.reconstruction.as_ref().is_ok_and(|assembly| !assembly.models.is_empty()) || found.reconstruction.models.is_empty() {
        return refuse(Refusal::ProjectEdits);
    }
    if !found.steps.is_empty() {
        check_steps(&found.edits, &found.steps)?;
    }
    check_oriented(run, &found.model, Some(&found.reconstruction))
}

/// Refuses a model and the reconstruction that it comes from where they are not of the block.
fn check_oriented(run: &BlockRun, model: &BlockModel, reconstruction: Option<&Reconstruction>) -> Result<(), Error> {
    model.check()?;
    let (images, cameras) = (run.images.len(), run.cameras.len());
    same(Input::ImagesOfProject, images, model.images.len())?;
    same(Input::CamerasOfProject, cameras, model.cameras.len())?;
    let differs =
        run.images.iter().zip(&model.images).find(|(image, modelled)| (&image.name, image.camera) != (&modelled.name, modelled.camera));
    if let Some((image, modelled)) = differs {
        let (name, camera, other, other_camera) = (image.name.clone(), image.camera, modelled.name.clone(), modelled.camera);
        return refuse(Refusal::ProjectImage { name, camera, other, other_camera });
    }
    for model in reconstruction.iter().flat_map(|assembly| &assembly.models) {
        check_model(model, images, cameras)?;
    }
    reconstruction.and_then(|assembly| assembly.models.first()).map_or(Ok(()), |first| check_written(model, first))
}

/// Refuses a written model that is not the adjusted one: tables go through both at once.
fn check_written(model: &BlockModel, adjusted: &ReconstructedModel) -> Result<(), Error> {
    let mut rays = vec![0; adjusted.points.len()];
    let of_rays = adjusted.adjusted.block.rays.iter().zip(&adjusted.adjusted.rays);
    of_rays.filter(|(_, known)| known.verdict == ObservationVerdict::Accepted).for_each(|(ray, _)| rays[ray.point] += 1);
    let written: Vec<usize> =
        rays.into_iter().zip(&adjusted.adjusted.points).filter(|(_, known)| known.is_some()).map(|(rays, _)| rays).collect();
    same(Input::PointsOfProject, model.points.len(), written.len())?;
    model.points.iter().zip(written).try_for_each(|(point, rays)| same(Input::ObservationsOfPoint, point.rays.len(), rays))
}

/// Refuses a model whose lists do not fit together: what reads it counts on that.
fn check_model(model: &ReconstructedModel, images: usize, cameras: usize) -> Result<(), Error> {
    let block = &model.adjusted.block;
    same(Input::ImagesOfModel, model.adjusted.images.len(), model.images.len())?;
    same(Input::ImagesOfBlock, block.images.len(), model.images.len())?;
    same(Input::CamerasOfBlock, block.cameras.len(), model.cameras.len())?;
    same(Input::PointsOfModel, model.points.len(), block.points.len())?;
    same(Input::PointsOfModel, model.adjusted.points.len(), block.points.len())?;
    same(Input::ObservationsOfModel, model.rays.len(), block.rays.len())?;
    same(Input::ObservationsOfModel, model.adjusted.rays.len(), block.rays.len())?;
    let beyond = |indices: &[usize], end: usize| indices.iter().copied().find(|index| *index >= end);
    if let Some(index) = beyond(&model.images, images).or(beyond(&model.cameras, cameras)) {
        return refuse(Refusal::ProjectIndex { index, images, cameras });
    }
    let camera_of = block.images.iter().map(|image| image.camera).collect::<Vec<usize>>();
    if let Some(camera) = beyond(&camera_of, model.cameras.len()) {
        return refuse(Refusal::ProjectCamera { camera, cameras: model.cameras.len() });
    }
    if !model.images.is_sorted_by(|a, b| a < b) {
        return refuse(Refusal::ProjectOrder);
    }
    let seen = block.rays.iter().map(|ray| (ray.image, ray.point)).chain(model.rejected.iter().map(|ray| (ray.image, ray.point)));
    let supporting = model.supporting.iter().flat_map(|point| &point.rays).map(|ray| (ray.image, 0));
    let (own, points) = (model.images.len(), block.points.len().max(1));
    if let Some((image, point)) = seen.chain(supporting).find(|(image, point)| *image >= own || *point >= points) {
        return refuse(Refusal::ProjectObservation { point, image, images: own, points });
    }
    model.adjusted.systematic.as_ref().map_or(Ok(()), |systematic| check_systematic(systematic, own, model.cameras.len()))
}

/// Refuses errors of positions that are of no camera, strip or image of their model.
fn check_systematic(systematic: &SystematicResult, images: usize, cameras: usize) -> Result<(), Error> {
    let of_strips = systematic.strips.iter().flat_map(|strip| &strip.images);
    if let Some(index) = of_strips.chain(&systematic.left_out).copied().find(|image| *image >= images) {
        return refuse(Refusal::ProjectIndex { index, images, cameras });
    }
    systematic.strips.iter().try_for_each(|strip| same(Input::PlacesOfStrip, strip.places.len(), strip.images.len()))?;
    let strips = systematic.strips.len();
    systematic.errors.iter().try_for_each(|statistics| match statistics.error {
        SystematicError::StripOffset { strip } | SystematicError::StripDrift { strip } if strip >= strips => {
            refuse(Refusal::ProjectStrip { strip, strips })
        }
        SystematicError::LeverArm { camera } if camera >= cameras => refuse(Refusal::ProjectCamera { camera, cameras }),
        _ => Ok(()),
    })
}

fn same(input: Input, got: usize, wanted: usize) -> Result<(), Error> {
    if got == wanted { Ok(()) } else { refuse(Refusal::Count { input, got, wanted }) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;
    use crate::model::tiny_block;
    use crate::{BlockOptions, NoGeometry, PairOutcome, PairRule, SelectOptions, Strip, SystematicStatistics, SystematicVerdict};

    /// A block as version 1 held it.
    fn older() -> version_1::Project {
        let connection = |images, outcome| version_1::OlderConnection { images, rule: PairRule::Near, outcome };
        version_1::Project {
            block: tiny_block(),
            connections: vec![
                connection([0, 1], version_1::OlderOutcome::Connected { matches: 120 }),
                connection([0, 2], version_1::OlderOutcome::NotOriented { matches: 30, reason: "9 inliers \"of\" 30".into() }),
            ],
            joining: BlockOptions::default(),
            selection: SelectOptions::default(),
        }
    }

    fn run() -> BlockRun {
        older().into()
    }

    fn read(text: &str) -> BlockRun {
        match read_project(text.as_bytes()).unwrap() {
            Project::Block(run) => *run,
            Project::Pair(_) => unreachable!("a block was written"),
        }
    }

    #[test]
    fn a_project_reads_back_as_it_was_and_gives_the_same_text() {
        let text = write_block_project(&run()).unwrap();
        assert_eq!(read(&text), run());
        assert_eq!(write_block_project(&read(&text)).unwrap(), text);
        assert!(text.starts_with("{\"format\":\"tiepoint-project\",\"version\":2,\"bytes\":"));
    }

    #[test]
    fn numbers_keep_every_bit() {
        let mut run = run();
        run.model.points[0].position = Some([1.0 / 3.0, -1e-300, 123_456_789.123_456_78]);
        assert_eq!(read(&write_block_project(&run).unwrap()), run);
    }

    #[test]
    fn a_file_of_version_1_is_brought_forward() {
        let text = include_str!("../../../tests/project/version-1.tiepoint");
        let run = read(text);
        let names: Vec<&str> = run.images.iter().map(|image| &image.name[..]).collect();
        assert_eq!(names, ["photo_00000.png", "photo_00001.png", "photo_00002.png", "=other, 1.png"]);
        let oriented: Vec<bool> = run.model.images.iter().map(|image| image.pose.is_some()).collect();
        assert_eq!(oriented, [true, true, true, false]);
        let chance = NoGeometry::Chance { agreeing: 4, matches: 61 };
        assert_eq!(run.connections[2].outcome, PairOutcome::NotOriented { no_geometry: chance });
        assert_eq!((run.model.points.len(), run.connections.len(), run.input.settings.selection.per_image), (12, 6, 9));
        assert_eq!(read(&write_block_project(&run).unwrap()), run);
    }

    /// Bytes of a file, damaged in one of six ways; the same number gives the same damage.
    fn damaged(text: &str, number: u32) -> Vec<u8> {
        let mut random = Random::new(number);
        let mut bytes = text.as_bytes().to_vec();
        let at = random.below(bytes.len());
        let other = |random: &mut Random, byte: u8| byte.wrapping_add(1 + random.below(255) as u8);
        match number % 6 {
            0 => bytes.truncate(at),
            1 => bytes[at] = other(&mut random, bytes[at]),
            2 => drop(bytes.remove(at)),
            3 => bytes.insert(at, random.below(256) as u8),
            4 => {
                let end = (at + 1 + random.below(64)).min(bytes.len());
                bytes[at..end].iter_mut().for_each(|byte| *byte = other(&mut random, *byte));
            }
            _ => {
                let piece = bytes[at..(at + 1 + random.below(64)).min(bytes.len())].to_vec();
                bytes.splice(at..at, piece);
            }
        }
        bytes
    }

    #[test]
    fn two_hundred_damaged_files_each_give_a_clear_error() {
        let text = write_block_project(&run()).unwrap();
        let mut kinds = std::collections::BTreeSet::new();
        for number in 0..200 {
            let bytes = damaged(&text, number);
            assert_ne!(bytes, text.as_bytes(), "{number}");
            let error = read_project(&bytes).expect_err(&format!("damage {number} was not seen"));
            assert!(matches!(error, Error::UnreadableFile { .. }), "{number}: {error}");
            assert!(!error.to_string().contains('\n') && error.to_string().len() < 300, "{number}: {error}");
            kinds.insert(error.to_string().split(':').nth(1).unwrap_or("").to_string());
        }
        assert!(kinds.len() >= 3, "{kinds:?}");
    }

    #[test]
    fn errors_of_positions_are_of_their_model() {
        let strips = vec![Strip { images: vec![0, 1, 2], places: vec![-0.5, 0.0, 0.5] }];
        let error = |error| SystematicStatistics {
            error,
            verdict: SystematicVerdict::Kept,
            estimate: [0.1; 3],
            standard_errors: [Some(0.01); 3],
            test: None,
            limit: None,
        };
        let errors = vec![error(SystematicError::StripOffset { strip: 0 }), error(SystematicError::LeverArm { camera: 0 })];
        let right = SystematicResult { strips, errors, constraints: 0, left_out: vec![3] };
        check_systematic(&right, 4, 1).unwrap();
        let refused = |change: &dyn Fn(&mut SystematicResult), words: &str| {
            let mut wrong = right.clone();
            change(&mut wrong);
            let message = check_systematic(&wrong, 4, 1).unwrap_err().to_string();
            assert!(message.contains(words), "{message}");
        };
        refused(&|wrong| wrong.strips[0].images[1] = 4, "got index 4");
        refused(&|wrong| wrong.left_out[0] = 7, "got index 7");
        refused(&|wrong| wrong.strips[0].places.truncate(2), "places of the images of a strip");
        refused(&|wrong| wrong.errors[0].error = SystematicError::StripDrift { strip: 1 }, "got strip 1");
        refused(&|wrong| wrong.errors[1].error = SystematicError::LeverArm { camera: 1 }, "got camera 1");
    }

    #[test]
    fn text_that_fits_its_checksum_is_still_checked() {
        let message =
            |version: u32, body: &str| read_project((header_line(version, body).unwrap() + body).as_bytes()).unwrap_err().to_string();
        let text = write_block_project(&run()).unwrap();
        let body = text.split_once('\n').unwrap().1;
        let newer = message(PROJECT_VERSION + 1, body);
        assert!(newer.contains("version 4; this program reads versions 1 to 3"), "{newer}");
        assert!(message(0, body).contains("version 0"), "{}", message(0, body));
        assert!(message(2, &body.replacen("\"input\"", "\"extra\":1,\"input\"", 1)).contains("block.extra: unknown field; allowed: "));
        let camera = message(2, &body.replacen("\"fixed\":", "\"extra\":1,\"fixed\":", 1));
        assert!(camera.contains("extra: unknown field"), "{camera}");
        assert!(message(2, &body.replacen("\"connections\"", "\"connexions\"", 1)).contains("connexions"));
        assert!(message(2, &body.replacen("\"images\":[0,1]", "\"images\":[0,7]", 1)).contains("[0, 7]"));
        assert!(message(2, &body.replacen("\"focal_px\":500.0", "\"focal_px\":-1.0", 1)).contains("focal length of a camera: got -1"));
        assert!(message(2, "{\"block\":{}}\n").contains("block.input: missing"));
        assert!(message(2, "{\"picture\":{}}\n").contains("got \"picture\"; allowed: block, pair"));
        assert!(read_project(b"").unwrap_err().to_string().contains("first line"));
        assert!(read_project(b"{\"type\":\"FeatureCollection\"}\n").unwrap_err().to_string().contains("format: missing"));
    }
}
