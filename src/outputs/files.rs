//! The files of a finished block, one after the other.

use super::given_points::absent_points;
use super::images::image_rows;
use super::in_system::{InSystem, ResultSystem};
use super::inspection::surveyed_numbers;
use super::pairs::pair_rows;
use super::report::block_report;
use super::summary::{ExportOutcome, Summary, summary};
use super::tables::word;
use super::{tables, write_block_project};
use crate::{
    BlockModel, BlockRun, BlockScore, Camera, Document, Error, ExportFormat, Factors95, GeographicOrigin, ModelImage, Pose, Reconstruction,
    Texts, export_block,
};
use serde::Serialize;
use std::collections::BTreeSet;

/// The name of the project file.
const PROJECT: &str = "project.tiepoint";

/// What is written of each block; `surveyed.csv` where control or check points were given.
const FIXED: [&str; 9] =
    [PROJECT, "report.html", "images.csv", "points.csv", "rays.csv", "orientation.json", "surveyed.csv", "pairs.csv", "summary.json"];

/// Takes the path, relative to the folder of the block and with slashes, and the text of a file.
type Emit<'a> = &'a mut dyn FnMut(&str, &str) -> Result<(), Error>;

/// The files of a block in steps of about one file, between which a caller may break off.
pub struct BlockFiles<'t> {
    texts: &'t Texts,
    formats: Vec<ExportFormat>,
    score: Option<BlockScore>,
    outcomes: Vec<ExportOutcome>,
    step: usize,
}

impl<'t> BlockFiles<'t> {
    /// Writes nothing yet. `score`: what the summary holds of a simulated block; `texts`: those of the report.
    pub fn new(formats: &[ExportFormat], score: Option<BlockScore>, texts: &'t Texts) -> Self {
        Self { texts, formats: formats.to_vec(), score, outcomes: Vec::new(), step: 0 }
    }

    /// Writes the next files of the block, which is the same in each step; gives the summary after the last one.
    ///
    /// # Errors
    /// Those of `emit`. A format that the block cannot be written in is named in the summary, and the others are written.
    pub fn step(&mut self, run: &BlockRun, emit: Emit<'_>) -> Result<Option<Summary>, Error> {
        let step = self.step;
        self.step += 1;
        if step == 0 {
            emit(PROJECT, &write_block_project(run)?)?;
        } else if step == 1 {
            write_tables(run, emit)?;
        } else if let Some(format) = self.formats.get(step - 2) {
            let outcome = write_format(run, *format, emit)?;
            self.outcomes.push(outcome);
        } else {
            let (pairs, groups) = pair_rows(run)?;
            let found = summary(run, &pairs, &groups, &self.outcomes, self.score);
            emit("report.html", &block_report(self.texts, run, &found, &pairs))?;
            emit("summary.json", &(json(&found, true)? + "\n"))?;
            return Ok(Some(found));
        }
        Ok(None)
    }
}

/// Writes all files of a block: its project, its tables, its report, its summary, and what other programs read, in a folder for each format. `emit` takes
/// the path, relative to the folder of the block and with slashes, and the text of each file in turn. The report is in English; in another language
/// [`BlockFiles`] writes it.
///
/// # Errors
/// Those of `emit`. A format that the block cannot be written in is named in the summary, and the others are written.
pub fn block_files(run: &BlockRun, formats: &[ExportFormat], score: Option<BlockScore>, emit: Emit<'_>) -> Result<Summary, Error> {
    let mut files = BlockFiles::new(formats, score, Texts::english());
    loop {
        if let Some(summary) = files.step(run, emit)? {
            return Ok(summary);
        }
    }
}

/// `orientation.json`: the adjustment in its own system, which touches the earth at `origin`, and the system of the tables, where that is another.
#[derive(Serialize)]
struct Orientation<'a> {
    #[serde(flatten)]
    assembly: &'a Reconstruction,
    /// Of each model: by what its standard errors grow for intervals, ellipses and ellipsoids of 95 %.
    factors_95: Vec<Option<Factors95>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    crs: Option<ResultSystem>,
}

fn write_tables(run: &BlockRun, emit: Emit<'_>) -> Result<(), Error> {
    let shown = InSystem::of(run);
    emit("images.csv", &tables::images(&shown, &image_rows(run)))?;
    emit("points.csv", &tables::points(&shown))?;
    emit("rays.csv", &tables::rays(run))?;
    if let Ok(assembly) = &run.reconstruction {
        let factors_95 = assembly.models.iter().map(|model| model.adjusted.factors_95()).collect();
        let orientation = Orientation { assembly, factors_95, crs: shown.system() };
        emit("orientation.json", &(json(&orientation, false)? + "\n"))?;
    }
    let surveyed = shown.surveyed();
    let absent = absent_points(run, &surveyed);
    if !surveyed.is_empty() || !absent.is_empty() {
        let by_hand: Option<BTreeSet<String>> = run.edited.as_ref().map(|_| run.added_control().map(|row| row.name).collect());
        emit("surveyed.csv", &tables::control(&surveyed, &surveyed_numbers(run), &absent, by_hand.as_ref()))?;
    }
    emit("pairs.csv", &tables::pairs(run, &pair_rows(run)?.0))
}

/// Writes a finished block in one format, as [`export_block`] does; tables are in the coordinate reference system of the results, as those of [`block_files`].
///
/// # Errors
/// Those of [`export_block`].
pub fn export_run(run: &BlockRun, format: ExportFormat, emit: Emit<'_>) -> Result<(), Error> {
    match format {
        ExportFormat::Csv => export_block(&InSystem::of(run).model(), format, emit),
        _ => export_block(&run.model, format, emit),
    }
}

fn write_format(run: &BlockRun, format: ExportFormat, emit: Emit<'_>) -> Result<ExportOutcome, Error> {
    let folder = word(&format);
    let mut broken = None;
    let written = export_run(run, format, &mut |path, text| {
        emit(&format!("{folder}/{path}"), text).inspect_err(|error| broken = Some(error.clone()))
    });
    match (broken, written) {
        (Some(error), _) => Err(error),
        (None, written) => Ok(ExportOutcome { format, refused: written.err().map(|error| error.to_string()) }),
    }
}

fn json(value: &impl Serialize, indented: bool) -> Result<String, Error> {
    let text = if indented { serde_json::to_string_pretty(value) } else { serde_json::to_string(value) };
    text.map_err(|error| Error::InvalidJson { document: Document::Block, json_fault: error.into() })
}

/// The files that a block of images with these names is written to, but for those of which there is one for each two images: found before
/// anything is computed.
///
/// # Errors
/// [`Error::NotExportable`] where formats cannot hold the names.
pub fn planned_files(names: &[String], formats: &[ExportFormat]) -> Result<Vec<String>, Error> {
    let mut paths: Vec<String> = FIXED.iter().map(ToString::to_string).collect();
    let mut refused: Vec<(String, Error)> = Vec::new();
    let model = bare(names);
    for format in formats {
        let folder = word(format);
        let written = export_block(&model, *format, &mut |path, _| {
            paths.push(format!("{folder}/{path}"));
            Ok(())
        });
        if let Err(error) = written {
            refused.push((folder, error));
        }
    }
    let Some((_, error)) = refused.first() else { return Ok(paths) };
    let formats: Vec<&str> = refused.iter().map(|(format, _)| &format[..]).collect();
    Err(Error::NotExportable { formats: formats.join(", "), error: Box::new(error.clone()) })
}

/// A block of these images that has no points.
fn bare(names: &[String]) -> BlockModel {
    let pose = Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], position: [0.0; 3] };
    BlockModel {
        cameras: vec![Camera { pixel_mm: Some(0.01), ..Camera::without_distortion(100, 100, 100.0) }],
        images: names.iter().map(|name| ModelImage { name: name.clone(), camera: 0, pose: Some(pose) }).collect(),
        points: Vec::new(),
        origin: Some(GeographicOrigin { longitude_deg: 0.0, latitude_deg: 0.0, height_m: 0.0 }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_no_file_can_hold_are_found_before_the_run() {
        let names = |names: &[&str]| names.iter().map(ToString::to_string).collect::<Vec<_>>();
        let paths = planned_files(&names(&["a.jpg", "b.jpg"]), &[ExportFormat::Bundler, ExportFormat::Colmap]).unwrap();
        assert!(paths.starts_with(&FIXED.map(String::from)) && paths.contains(&"colmap/features/a.jpg.txt".into()), "{paths:?}");
        let refused = |name: &str, formats: &[ExportFormat]| planned_files(&names(&["a.jpg", name]), formats).unwrap_err().to_string();
        let formats = [ExportFormat::Csv, ExportFormat::Micmac, ExportFormat::Colmap];
        assert!(refused("b c.jpg", &formats).contains("exported as micmac, colmap ("), "{}", refused("b c.jpg", &formats));
        let long = "x".repeat(252);
        assert!(refused(&long, &formats[2..]).contains("bytes"), "{}", refused(&long, &formats[2..]));
        planned_files(&names(&["a.jpg", &long]), &formats[..1]).unwrap();
    }
}
