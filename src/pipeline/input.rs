//! What a block is made of, and what can be refused of it before anything is computed.

use super::cameras::CameraRules;
use super::control::ControlTables;
use super::masks::masks_of;
use super::positions::{GivenPosition, PositionTable};
use crate::catalogue::{check_groups, read_options};
use crate::crs::{Geoid, HeightZero};
use crate::error::refuse;
use crate::{BlockSettings, Document, Error, PartlyGiven, Refusal};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::BTreeSet;

/// A block before its run: files by their names, whose bytes come with the jobs that need them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct RunInput {
    /// Names of the images in the order in which they follow each other; no two are the same.
    pub images: Vec<String>,
    /// Names of masks: images that are 0 (black) where no features are wanted, each as large as the image whose name it has.
    pub masks: Vec<String>,
    #[serde(deserialize_with = "read_options")]
    pub settings: BlockSettings,
    /// A file of cameras, which take the place of those of EXIF.
    pub cameras: Option<String>,
    /// Whether GNSS positions of the images choose near images and, without ground control points, georeference the block.
    pub use_gnss: bool,
    pub control: Option<ControlTexts>,
    /// Name of the file of a geoid, from which the heights of the coordinate system count: a GeoTIFF of longitudes and latitudes, GTX, or PGM of
    /// GeographicLib.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub geoid: Option<String>,
    /// GNSS positions of images, which take the place of those that the files of these images record: the text of a table.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub positions: Option<String>,
    /// Whether an orthophoto is to place the block afterwards: then one or two control points, and check points alone, are of use.
    #[serde(skip_serializing_if = "is_false")]
    pub on_orthophoto: bool,
    /// Whether masks that belong to none of the images are refused, in place of listed: an image whose mask has a slip in its name would have none. It
    /// is of the call: a run does not keep it.
    #[serde(skip_serializing_if = "is_false")]
    pub refuse_stray_masks: bool,
}

impl PartlyGiven for RunInput {
    fn check_given(given: &Value, document: &Document) -> Result<(), Error> {
        const FIELD: &str = "settings";
        check_groups(Self::GROUPS, given, document)?;
        given.get(FIELD).map_or(Ok(()), |settings| BlockSettings::check_given(settings, &Document::Named { name: FIELD.into() }))
    }
}

fn is_false(value: &bool) -> bool {
    !value
}

/// Ground control points and their image measurements, as the texts of two files.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify))]
pub struct ControlTexts {
    pub points: String,
    pub marks: String,
}

impl Default for RunInput {
    fn default() -> Self {
        Self {
            images: Vec::new(),
            masks: Vec::new(),
            settings: BlockSettings::default(),
            cameras: None,
            use_gnss: true,
            control: None,
            geoid: None,
            positions: None,
            on_orthophoto: false,
            refuse_stray_masks: false,
        }
    }
}

/// An input that was read and checked.
pub(super) struct Checked {
    pub settings: BlockSettings,
    pub images: Vec<String>,
    pub masks: Vec<String>,
    /// Of each image the index of its mask.
    pub mask_of: Vec<Option<usize>>,
    pub unused_masks: Vec<String>,
    pub rules: CameraRules,
    /// Patterns of cameras that fit no image.
    pub unused_cameras: Vec<String>,
    pub use_gnss: bool,
    pub control: Option<ControlTables>,
    pub positions: Option<PositionTable>,
    /// Of each image the position that the table gives; none where GNSS positions are not used.
    pub given: Vec<Option<GivenPosition>>,
    pub geoid: Option<String>,
    pub on_orthophoto: bool,
    /// Where the heights of the coordinate system count from; not known before the geoid was read, where one is given.
    pub zero: HeightZero,
}

impl RunInput {
    /// Where the heights of the coordinate system count from, by the part of the geoid, where one is given.
    pub(crate) fn zero(&self, geoid: Option<&Geoid>) -> HeightZero {
        HeightZero::of(self.settings.placing.geoid_m, geoid.cloned())
    }

    /// Reads and checks everything but the images. `geoid`: the part of the geoid, where one is given and was read.
    pub(super) fn checked(self, geoid: Option<&Geoid>) -> Result<Checked, Error> {
        self.settings.check()?;
        self.settings.placing.check_geoid(self.geoid.as_deref())?;
        check_names(&self.images)?;
        let (mask_of, unused_masks) = masks_of(&self.images, &self.masks)?;
        if self.refuse_stray_masks && !unused_masks.is_empty() {
            return refuse(Refusal::StrayMasks { masks: unused_masks });
        }
        let rules = CameraRules::read(self.cameras.as_deref())?;
        let unused_cameras = rules.unused(&self.images)?;
        let control = self.control.as_ref().map(|texts| ControlTables::read(&texts.points, &texts.marks)).transpose()?;
        if let Some(control) = &control {
            control.check(&self.images, &self.settings.placing, self.on_orthophoto)?;
        }
        let zero = self.zero(geoid);
        let positions = self.positions.as_deref().map(PositionTable::read).transpose()?;
        let given = positions.as_ref().map(|table| table.of_images(&self.images, &self.settings.placing, &zero)).transpose()?;
        let given = given.filter(|_| self.use_gnss).unwrap_or_else(|| vec![None; self.images.len()]);
        let Self { settings, images, masks, use_gnss, geoid, on_orthophoto, .. } = self;
        Ok(Checked {
            settings,
            images,
            masks,
            mask_of,
            unused_masks,
            rules,
            unused_cameras,
            use_gnss,
            control,
            positions,
            given,
            geoid,
            on_orthophoto,
            zero,
        })
    }
}

/// Refuses names that tables and texts, which have a line for each image, cannot tell apart or hold.
fn check_names(names: &[String]) -> Result<(), Error> {
    let mut seen = BTreeSet::new();
    for name in names {
        if !seen.insert(name) {
            return refuse(Refusal::FileNameAgain { name: name.clone() });
        }
        if name.chars().any(char::is_control) {
            return refuse(Refusal::FileName { name: format!("{name:?}") });
        }
    }
    Ok(())
}
