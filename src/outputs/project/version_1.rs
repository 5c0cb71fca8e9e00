//! The project file of version 1: a block without what its run knew beside it.

use crate::catalogue::read_options;
use crate::{
    BlockModel, BlockOptions, BlockRun, BlockSettings, Camera, Connection, ExifImage, Failure, InitialCamera, KnownCamera, NoGeometry,
    PairOutcome, PairRule, Reconstruction, Remark, RunImage, RunInput, SelectOptions,
};
use serde::Deserialize;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Project {
    pub(super) block: BlockModel,
    pub(super) connections: Vec<OlderConnection>,
    #[serde(deserialize_with = "read_options")]
    pub(super) joining: BlockOptions,
    #[serde(deserialize_with = "read_options")]
    pub(super) selection: SelectOptions,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct OlderConnection {
    pub(super) images: [u32; 2],
    pub(super) rule: PairRule,
    pub(super) outcome: OlderOutcome,
}

/// An outcome whose reason is a sentence.
#[derive(Debug, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub(super) enum OlderOutcome {
    Waiting,
    Connected { matches: u32 },
    TooFewMatches { matches: u32, needed: u32 },
    NotOriented { matches: u32, reason: String },
    Failed { reason: String },
}

impl From<OlderOutcome> for PairOutcome {
    fn from(outcome: OlderOutcome) -> Self {
        match outcome {
            OlderOutcome::Waiting => Self::Waiting,
            OlderOutcome::Connected { matches } => Self::Connected { matches },
            OlderOutcome::TooFewMatches { matches, needed } => Self::TooFewMatches { matches, needed },
            OlderOutcome::NotOriented { matches, reason } => match no_geometry(&reason) {
                Some(no_geometry) => Self::NotOriented { no_geometry },
                None => failed(format!("{matches} matches of no common geometry ({reason})")),
            },
            OlderOutcome::Failed { reason } => failed(reason),
        }
    }
}

fn failed(message: String) -> PairOutcome {
    PairOutcome::Failed { failure: Failure::Refused { code: String::new(), message, usage: false, error: None } }
}

/// The reason of one of the two sentences that version 1 had: `… 4 of 61 matches agree on one …`, `…: 9 given; at least 12 are needed`.
fn no_geometry(sentence: &str) -> Option<NoGeometry> {
    let numbers: Vec<usize> = sentence.split(|c: char| !c.is_ascii_digit()).filter_map(|digits| digits.parse().ok()).collect();
    match numbers[..] {
        [agreeing, matches] if sentence.contains("matches agree on one") => Some(NoGeometry::Chance { agreeing, matches }),
        [matches, needed] if sentence.contains("given; at least") => Some(NoGeometry::TooFewMatches { matches, needed }),
        _ => None,
    }
}

impl From<Project> for BlockRun {
    /// What the older file does not hold is absent.
    fn from(Project { block: model, connections, joining, selection }: Project) -> Self {
        let cameras = model.cameras.iter().map(|camera| {
            let Camera { width_px, height_px, principal_point_px, pixel_mm, .. } = *camera;
            let known =
                KnownCamera { principal_point_px: Some(principal_point_px), pixel_mm, ..KnownCamera::of_size(width_px, height_px, None) };
            InitialCamera::new(format!("{width_px} x {height_px} px"), &known)
        });
        let images = model.images.iter().map(|image| {
            // Indices are judged with the whole project.
            let size = model.cameras.get(image.camera).map_or([0; 2], |camera| [camera.width_px, camera.height_px]);
            RunImage {
                name: image.name.clone(),
                key: String::new(),
                content: String::new(),
                width_px: size[0],
                height_px: size[1],
                features: None,
                masked: false,
                exif: ExifImage::default(),
                given: None,
                camera: image.camera,
            }
        });
        Self {
            input: RunInput {
                images: model.images.iter().map(|image| image.name.clone()).collect(),
                settings: BlockSettings { block: joining, selection, ..BlockSettings::default() },
                ..RunInput::default()
            },
            images: images.collect(),
            skipped: Vec::new(),
            unused_masks: Vec::new(),
            unknown_images: Vec::new(),
            remarks: vec![Remark::OlderProject { version: 1 }],
            cameras: cameras.collect(),
            geometries: vec![None; connections.len()],
            connections: connections
                .into_iter()
                .map(|OlderConnection { images, rule, outcome }| Connection { images, rule, outcome: outcome.into() })
                .collect(),
            points: None,
            refinement: None,
            reconstruction: Ok(Reconstruction { origin: model.origin, ..Reconstruction::default() }),
            model,
            edited: None,
            orthophoto: None,
            geoid: None,
        }
    }
}
