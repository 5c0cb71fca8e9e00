//! Covariances of chosen images, points and cameras of a finished block.

use super::inspection::surveyed;
use super::precision::{written, written_points};
use super::tables::word;
use crate::adjustment::{Part, PartCovariances, Unknown};
use crate::error::refuse;
use crate::text::{Row, guarded, shorten, table};
use crate::{BlockRun, CameraParameter, Error, ReconstructedModel, Refusal};
use serde::Serialize;
use std::collections::BTreeSet;

/// Unknowns that a matrix has at most.
const MOST_UNKNOWNS: usize = 2000;
/// The name of the whole block, where nothing in it is named so.
const ALL: &str = "all";

/// An unknown of the adjustment of a block.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CovarianceUnknown {
    /// Its image, point or camera, as it was named.
    pub of: String,
    /// `omega`, `phi`, `kappa`, `x`, `y`, `z`, or a parameter of a camera as `orientation.json` names it.
    pub name: String,
    /// `deg`, `px`, `m`, `1`, or `unit` for the lengths of a block that no observed position places.
    pub unit: &'static str,
    /// Adjusted.
    pub value: f64,
}

/// Unknowns of a block with their covariances.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Covariances {
    pub unknowns: Vec<CovarianceUnknown>,
    /// Row by row; the unit of each is the product of those of its two unknowns.
    pub rows: Vec<Vec<f64>>,
}

/// The covariances of images, points and cameras of the model that is written, and between all of them: those whose diagonal are the squares of its standard
/// errors. Images and surveyed points go by their names, `point:N` is a point and `camera:N` a camera by its number in `points.csv` and `images.csv`;
/// `all` is the whole block, unless something in it is named so: its images, cameras, surveyed points and tie points, where those whose names are alike
/// have a number behind the name. Systematic errors of GNSS positions are estimated beside them, and have no part in these covariances.
///
/// # Errors
/// [`Error::InvalidInput`] for names that nothing has, or that stand twice, for more than 2,000 unknowns, and for a block whose project does not keep all points
/// by which it was adjusted; [`Error::TooFew`] without redundancy; [`Error::Degenerate`] where the normal equations are singular.
pub fn block_covariances(run: &BlockRun, names: &[String]) -> Result<Covariances, Error> {
    let Some(model) = written(run) else { return refuse(Refusal::CovariancesNotOriented) };
    if model.lacks_support() {
        return refuse(Refusal::CovariancesUnsupported);
    }
    let (names, parts): (Vec<String>, Vec<Part>) = parts(run, model, names)?.into_iter().unzip();
    let unknowns: usize = parts.iter().map(|part| size(model, *part)).sum();
    if !(1..=MOST_UNKNOWNS).contains(&unknowns) {
        return refuse(Refusal::CovarianceUnknowns { unknowns, most: MOST_UNKNOWNS });
    }
    let (block, accepted) = model.with_support();
    let PartCovariances { unknowns, mut rows } = model.adjusted.covariances(&block, &accepted, &parts)?;
    let length = if model.in_system { "m" } else { "unit" };
    let scales: Vec<f64> = unknowns.iter().map(|(_, unknown, _)| scale(*unknown)).collect();
    for (row, of_row) in rows.iter_mut().zip(&scales) {
        row.iter_mut().zip(&scales).for_each(|(value, of_column)| *value *= of_row * of_column);
    }
    let described = unknowns.iter().zip(&scales).map(|((part, unknown, value), scale)| {
        let (name, unit) = described(*unknown, length);
        CovarianceUnknown { of: names[*part].clone(), name, unit, value: value * scale }
    });
    Ok(Covariances { unknowns: described.collect(), rows })
}

/// `covariances.csv`: each row an unknown with its unit, adjusted value and standard error, then its covariances with all of them.
pub fn covariance_table(covariances: &Covariances) -> String {
    let heads: Vec<String> = covariances.unknowns.iter().map(|one| guarded(&format!("{} {} [{}]", one.of, one.name, one.unit))).collect();
    let columns: Vec<&str> =
        ["of", "unknown", "unit", "value", "standard_error"].into_iter().chain(heads.iter().map(|head| &head[..])).collect();
    let rows = covariances.unknowns.iter().zip(&covariances.rows).enumerate().map(|(k, (one, row))| {
        let head = Row::default().text(&one.of).text(&one.name).text(one.unit).number(one.value).number(row[k].max(0.0).sqrt());
        row.iter().fold(head, |line, value| line.number(value))
    });
    table(&columns, rows)
}

/// What the names mean, each by its own name.
fn parts(run: &BlockRun, model: &ReconstructedModel, names: &[String]) -> Result<Vec<(String, Part)>, Error> {
    check_once(names.iter().map(String::as_str).collect())?;
    let mut found: Vec<(String, Part)> = Vec::new();
    for name in names {
        match part(run, model, name) {
            Some(part) => found.push((name.clone(), part)),
            None if name == ALL => found.extend(told_apart(all_parts(run, model))),
            None => return refuse(Refusal::CovarianceName { name: shorten(name) }),
        }
    }
    check_once(found.iter().map(|(name, _)| &name[..]).collect())?;
    Ok(found)
}

fn check_once(mut names: Vec<&str>) -> Result<(), Error> {
    names.sort_unstable();
    match names.windows(2).find(|two| two[0] == two[1]) {
        Some(two) => refuse(Refusal::CovarianceAgain { name: shorten(two[0]) }),
        None => Ok(()),
    }
}

/// The same, where each name that stood before has a number behind it: a surveyed point may be named as an image is, or `point:3`.
fn told_apart(parts: Vec<(String, Part)>) -> Vec<(String, Part)> {
    let mut taken = BTreeSet::new();
    let free = |(name, part): (String, Part)| {
        let numbered = (2..).map(|number| format!("{name} ({number})"));
        let own = std::iter::once(name.clone()).chain(numbered).find(|name| taken.insert(name.clone()));
        (own.unwrap_or(name), part)
    };
    parts.into_iter().map(free).collect()
}

/// Images, cameras, surveyed points, and the other points by their numbers.
fn all_parts(run: &BlockRun, model: &ReconstructedModel) -> Vec<(String, Part)> {
    let images = model.images.iter().enumerate().map(|(place, image)| (run.images[*image].name.clone(), Part::Image(place)));
    let cameras = model.cameras.iter().enumerate().map(|(place, camera)| (format!("camera:{camera}"), Part::Camera(place)));
    let numbers = numbers(run, model);
    let point = |place: usize| numbers[place].map(|number| (place, number));
    let points: Vec<(usize, u32)> = (0..model.points.len()).filter_map(point).collect();
    let named = points.iter().filter_map(|(place, _)| Some((surveyed(model, *place)?.name.clone(), Part::Point(*place))));
    let tie_points = points.iter().filter(|(place, _)| surveyed(model, *place).is_none());
    let numbered = tie_points.map(|(place, number)| (format!("point:{number}"), Part::Point(*place)));
    let estimated = cameras.filter(|(_, camera)| size(model, *camera) > 0);
    images.chain(estimated).chain(named).chain(numbered).collect()
}

/// Of each point of an adjusted block its number; absent without accepted observations.
fn numbers(run: &BlockRun, model: &ReconstructedModel) -> Vec<Option<u32>> {
    let numbers = run.model.point_numbers();
    written_points(model).into_iter().map(|point| point.map(|point| numbers[point])).collect()
}

/// What a name means; absent where nothing has it.
fn part(run: &BlockRun, model: &ReconstructedModel, name: &str) -> Option<Part> {
    let image = run.images.iter().position(|image| image.name == name);
    if let Some(place) = image.and_then(|image| model.images.binary_search(&image).ok()) {
        return Some(Part::Image(place));
    }
    let is_named = |place: &usize| surveyed(model, *place).is_some_and(|point| point.name == name);
    if let Some(place) = (0..model.points.len()).filter(|place| model.adjusted.points[*place].is_some()).find(is_named) {
        return Some(Part::Point(place));
    }
    let numbered = |number: u32| numbers(run, model).iter().position(|point| *point == Some(number));
    let point = name.strip_prefix("point:").and_then(|number| numbered(number.parse().ok()?));
    let camera = name.strip_prefix("camera:").and_then(|number| model.cameras.binary_search(&number.parse().ok()?).ok());
    point.map(Part::Point).or(camera.map(Part::Camera))
}

/// Number of unknowns of a part, of a camera at most.
fn size(model: &ReconstructedModel, part: Part) -> usize {
    match part {
        Part::Image(_) => 6,
        Part::Camera(camera) => model.adjusted.block.cameras[camera].free.flags().iter().filter(|free| **free).count(),
        Part::Point(_) => 3,
    }
}

/// By which a value becomes one in its unit.
fn scale(unknown: Unknown) -> f64 {
    if matches!(unknown, Unknown::Angle(_)) { 1_f64.to_degrees() } else { 1.0 }
}

fn described(unknown: Unknown, length: &'static str) -> (String, &'static str) {
    match unknown {
        Unknown::Angle(angle) => (["omega", "phi", "kappa"][angle].into(), "deg"),
        Unknown::Coordinate(axis) => (["x", "y", "z"][axis].into(), length),
        Unknown::Parameter(parameter) => {
            let is_length = matches!(parameter, CameraParameter::Focal | CameraParameter::PrincipalX | CameraParameter::PrincipalY);
            (word(&parameter), if is_length { "px" } else { "1" })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_of_one_name_are_told_apart() {
        let names = ["a.jpg", "camera:0", "a.jpg", "a.jpg (2)", "camera:0", "a.jpg"];
        let parts = names.iter().enumerate().map(|(place, name)| (name.to_string(), Part::Point(place))).collect();
        let found: Vec<String> = told_apart(parts).into_iter().map(|(name, _)| name).collect();
        assert_eq!(found, ["a.jpg", "camera:0", "a.jpg (2)", "a.jpg (2) (2)", "camera:0 (2)", "a.jpg (3)"]);
    }
}
