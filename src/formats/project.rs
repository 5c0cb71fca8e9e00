//! The block's own file: one line that says what it is, and one of JSON that is checked against it.

use crate::catalogue::read_options;
use crate::json::reason;
use crate::text::shorten;
use crate::{BlockModel, BlockOptions, Connection, Error, SelectOptions};
use serde::{Deserialize, Serialize};

/// The version that is written, and the newest one that is read.
pub const PROJECT_VERSION: u32 = 1;

const FORMAT: &str = "tiepoint-project";
const WHAT: &str = "the project file";

/// A block with what was chosen and found on the way to it.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct Project {
    pub block: BlockModel,
    /// The pairs that were chosen, with their outcomes.
    pub connections: Vec<Connection>,
    #[serde(deserialize_with = "read_options")]
    pub joining: BlockOptions,
    #[serde(deserialize_with = "read_options")]
    pub selection: SelectOptions,
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

/// Writes a project: the same project gives the same text.
///
/// # Errors
/// As [`BlockModel::check`]; [`Error::InvalidInput`] for connections of images that do not exist.
pub fn write_project(project: &Project) -> Result<String, Error> {
    check(project)?;
    let body = serde_json::to_string(project).map_err(|e| Error::InvalidJson { what: WHAT, reason: e.to_string() })? + "\n";
    Ok(header_line(PROJECT_VERSION, &body)? + &body)
}

/// Reads a project. Nothing is passed over: a file that this version does not understand in full is refused whole, so that nothing is lost
/// by writing it again.
///
/// # Errors
/// [`Error::UnreadableFile`] for another kind of file, a newer version, a damaged or shortened file, and what does not belong there; as
/// [`BlockModel::check`].
pub fn read_project(bytes: &[u8]) -> Result<Project, Error> {
    let refused = |place: &str, reason: String| Err(Error::UnreadableFile { what: WHAT, place: place.into(), reason });
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text,
        Err(error) => return refused(&format!("byte {}", error.valid_up_to()), "it is not text (UTF-8)".into()),
    };
    let Some((line, body)) = text.split_once('\n') else {
        return refused("line 1", format!("'{}' is not the first line of a project, or the only one", shorten(text)));
    };
    let header: Header = match serde_json::from_str(line) {
        Ok(header) => header,
        Err(error) => return refused("line 1", format!("'{}' is not the first line of a project ({})", shorten(line), reason(&error))),
    };
    if header.format != FORMAT {
        return refused("line 1", format!("its format is '{}', not '{FORMAT}'", shorten(&header.format)));
    }
    if header.version != PROJECT_VERSION {
        let reason = format!("it is of version {}; this program reads version {PROJECT_VERSION}", header.version);
        return refused("line 1", reason);
    }
    if header.bytes != body.len() {
        return refused(
            "length",
            format!("{} bytes follow the first line, which says {}: the file is cut off or was changed", body.len(), header.bytes),
        );
    }
    if header_line(PROJECT_VERSION, body)?.trim_end() != line {
        return refused("checksum", "what the first line says does not fit the rest: the file is damaged or was changed by hand".into());
    }
    let project: Project = match serde_json::from_str(body) {
        Ok(project) => project,
        Err(error) => return refused("line 2", reason(&error)),
    };
    check(&project).map(|()| project)
}

fn header_line(version: u32, body: &str) -> Result<String, Error> {
    let header = Header { format: FORMAT.into(), version, bytes: body.len(), crc32: format!("{:08x}", crc32fast::hash(body.as_bytes())) };
    Ok(serde_json::to_string(&header).map_err(|e| Error::InvalidJson { what: WHAT, reason: e.to_string() })? + "\n")
}

fn check(project: &Project) -> Result<(), Error> {
    project.block.check()?;
    let images = project.block.images.len();
    match project.connections.iter().find(|c| c.images[0] >= c.images[1] || c.images[1] as usize >= images) {
        Some(connection) => Err(Error::InvalidInput {
            what: "connection of the project",
            got: format!("{:?}", connection.images),
            allowed: format!("two images below {images} in ascending order"),
        }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;
    use crate::model::tiny_block;
    use crate::{Failure, PairOutcome, PairRule};

    fn project() -> Project {
        let connection = |images, outcome| Connection { images, rule: PairRule::Near, outcome };
        Project {
            block: tiny_block(),
            connections: vec![
                connection([0, 1], PairOutcome::Connected { matches: 120 }),
                connection([0, 2], PairOutcome::Failed { failure: Failure::BrokeOff { message: "9 \"of\" 30".into() } }),
            ],
            ..Project::default()
        }
    }

    #[test]
    fn a_project_reads_back_as_it_was_and_gives_the_same_text() {
        let text = write_project(&project()).unwrap();
        assert_eq!(read_project(text.as_bytes()).unwrap(), project());
        assert_eq!(write_project(&read_project(text.as_bytes()).unwrap()).unwrap(), text);
        assert!(text.starts_with("{\"format\":\"tiepoint-project\",\"version\":1,\"bytes\":"));
    }

    #[test]
    fn numbers_keep_every_bit() {
        let mut project = project();
        project.block.points[0].position = Some([1.0 / 3.0, -1e-300, 123_456_789.123_456_78]);
        assert_eq!(read_project(write_project(&project).unwrap().as_bytes()).unwrap(), project);
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
        let text = write_project(&project()).unwrap();
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
    fn text_that_fits_its_checksum_is_still_checked() {
        let message =
            |version: u32, body: &str| read_project((header_line(version, body).unwrap() + body).as_bytes()).unwrap_err().to_string();
        let text = write_project(&project()).unwrap();
        let body = text.split_once('\n').unwrap().1;
        assert!(message(2, body).contains("version 2; this program reads version 1"), "{}", message(2, body));
        assert!(message(1, &body.replacen("\"block\"", "\"extra\":1,\"block\"", 1)).contains("unknown field `extra`"));
        assert!(message(1, &body.replacen("\"connections\"", "\"connexions\"", 1)).contains("connexions"));
        assert!(message(1, &body.replacen("\"images\":[0,1]", "\"images\":[0,7]", 1)).contains("[0, 7]"));
        assert!(message(1, &body.replacen("\"focal_px\":500.0", "\"focal_px\":-1.0", 1)).contains("focal length of a camera: got -1"));
        assert!(message(1, "{}\n").contains("missing field"));
        assert!(read_project(b"").unwrap_err().to_string().contains("first line"));
        assert!(read_project(b"{\"type\":\"FeatureCollection\"}\n").unwrap_err().to_string().contains("missing field"));
    }
}
