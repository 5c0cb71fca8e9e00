//! What cannot be adjusted, and why.

use super::block::Block;
use super::network::Network;
use super::options::Datum;
use crate::camera::is_rotation;
use crate::catalogue::check_values;
use crate::error::refuse;
use crate::math::dot3;
use crate::{Cause, Computation, Element, Error, Few, Input, Location, Refusal};

/// Least number of accepted rays of an image: three fix it up to four solutions.
const LEAST_RAYS: usize = 4;

/// Largest coordinate of object space: what a number holds to a hundredth of a millionth beside a unit.
const LARGEST: f64 = 1e8;

/// Refuses indices that point nowhere, values that are none, and an image that sees a point twice.
pub(super) fn check_block(block: &Block, datum: Datum) -> Result<(), Error> {
    // Control alone orients a single image.
    let needed = if datum.uses_control() { 1 } else { 2 };
    if block.images.len() < needed {
        return Err(Error::TooFew { few: Few::ImagesOfBlock, got: block.images.len(), needed });
    }
    block.cameras.iter().enumerate().try_for_each(|(index, camera)| camera.check(|| Location::Camera { camera: index }))?;
    for (index, image) in block.images.iter().enumerate() {
        let place = |element| Location::ElementOfImage { element, image: index };
        check_index(Input::CameraOfImage, image.camera, block.cameras.len(), || place(Element::Camera))?;
        if !is_rotation(&image.pose.rotation) {
            let rotation = format!("{:?}", image.pose.rotation);
            return refuse(Refusal::RotationAs { rotation, location: place(Element::Rotation) });
        }
        check_position(&image.pose.position, || place(Element::Position))?;
        if let Some(axis) = image.axis {
            if !((dot3(&axis.direction, &axis.direction) - 1.0).abs() < 1e-6) {
                let direction = format!("{:?}", axis.direction);
                return refuse(Refusal::AxisDirection { direction, location: place(Element::AxisDirection) });
            }
            check_values(Input::AxisSigma, &[axis.sigma_deg], 1e-6..=1e4, || place(Element::AxisSigma))?;
        }
        if let Some(gnss) = image.gnss {
            for (value, sigma) in gnss.position.iter().zip(gnss.sigma).filter_map(|(value, sigma)| Some((value, sigma?))) {
                check_values(Input::Position, &[*value], -LARGEST..=LARGEST, || place(Element::GnssPosition))?;
                check_values(Input::PositionSigma, &[sigma], 1e-9..=1e9, || place(Element::GnssSigma))?;
            }
        }
    }
    for (index, point) in block.points.iter().enumerate() {
        check_position(point, || Location::Point { point: index })?;
    }
    for (index, ray) in block.rays.iter().enumerate() {
        let place = |element| Location::ElementOfRay { element, ray: index };
        check_index(Input::ImageOfRay, ray.image, block.images.len(), || place(Element::Image))?;
        check_index(Input::PointOfRay, ray.point, block.points.len(), || place(Element::Point))?;
        check_values(Input::ImageCoordinates, &[ray.x_px, ray.y_px], -1e7..=1e7, || place(Element::Coordinates))?;
        check_values(Input::Weight, &[ray.weight], 1e-12..=1e12, || place(Element::Weight))?;
        check_values(Input::RaySigma, ray.sigma_px.as_slice(), 1e-6..=1e6, || place(Element::Sigma))?;
    }
    for (index, prior) in block.camera_priors.iter().enumerate() {
        if block.camera_priors[..index].iter().any(|other| other.camera == prior.camera) {
            return refuse(Refusal::PriorAgain { camera: prior.camera });
        }
        check_index(Input::CameraOfPrior, prior.camera, block.cameras.len(), || Location::CameraOfPrior)?;
        let place = || Location::Prior { camera: prior.camera };
        for (value, sigma) in prior.values.iter().zip(prior.sigma).filter_map(|(value, sigma)| Some((value, sigma?))) {
            check_values(Input::CameraParameter, &[*value], -LARGEST..=LARGEST, place)?;
            check_values(Input::CameraSigma, &[sigma], 1e-12..=1e9, place)?;
        }
    }
    check_control(block)?;
    check_once(block)?;
    if datum.uses_control() && block.control.is_empty() && !datum.uses_gnss() {
        return Err(Error::TooFew { few: Few::ControlPointsForDatum, got: 0, needed: 3 });
    }
    Ok(())
}

fn check_control(block: &Block) -> Result<(), Error> {
    let mut is_control = vec![false; block.points.len()];
    for (index, control) in block.control.iter().enumerate() {
        let place = |element| Location::ElementOfControl { element, control: index };
        check_index(Input::PointOfControl, control.point, block.points.len(), || place(Element::Point))?;
        check_position(&control.position, || place(Element::Position))?;
        check_values(Input::PositionSigma, &control.sigma, 1e-9..=1e9, || place(Element::Sigma))?;
        if std::mem::replace(&mut is_control[control.point], true) {
            return refuse(Refusal::ControlAgain { point: control.point });
        }
    }
    Ok(())
}

/// Refuses a second ray of the same image and point.
fn check_once(block: &Block) -> Result<(), Error> {
    let mut pairs: Vec<(usize, usize)> = block.rays.iter().map(|ray| (ray.point, ray.image)).collect();
    pairs.sort_unstable();
    match pairs.windows(2).find(|w| w[0] == w[1]) {
        Some(w) => refuse(Refusal::RayAgain { image: w[0].1, point: w[0].0 }),
        None => Ok(()),
    }
}

fn check_index(input: Input, index: usize, number: usize, place: impl Fn() -> Location) -> Result<(), Error> {
    match number.checked_sub(1) {
        Some(last) if index <= last => Ok(()),
        Some(last) => refuse(Refusal::IndexAs { input, index, location: place(), last }),
        None => refuse(Refusal::NothingAs { input, index, location: place() }),
    }
}

fn check_position(position: &[f64; 3], place: impl Fn() -> Location) -> Result<(), Error> {
    check_values(Input::Position, position, -LARGEST..=LARGEST, place)
}

/// Refuses images with too few rays, and a block that falls apart where nothing else holds it together.
pub(super) fn check_network(network: &Network, datum: Datum) -> Result<(), Error> {
    for image in 0..network.images() {
        let rays = network.of_image(image).len();
        if rays < LEAST_RAYS {
            let cause = Cause::FewObservations { observations: rays, needed: LEAST_RAYS };
            return Err(Error::UndeterminedImage { computation: Computation::BundleAdjustment, image, cause });
        }
    }
    let parts = parts(network);
    if datum == Datum::Free && parts.len() > 1 {
        let cause = Cause::Parts { parts: parts.len(), first: parts[0], second: parts[1] };
        return Err(Error::Degenerate { computation: Computation::BundleAdjustment, cause });
    }
    Ok(())
}

/// The first image of each part that is connected by points.
fn parts(network: &Network) -> Vec<usize> {
    let mut reached = vec![false; network.images()];
    let mut firsts = Vec::new();
    for first in 0..network.images() {
        if std::mem::replace(&mut reached[first], true) {
            continue;
        }
        firsts.push(first);
        let mut open = vec![first];
        while let Some(image) = open.pop() {
            for sight in network.of_image(image) {
                for other in network.of_point(network.sights[*sight as usize].point as usize) {
                    if !std::mem::replace(&mut reached[other.image as usize], true) {
                        open.push(other.image as usize);
                    }
                }
            }
        }
    }
    firsts
}
