//! What cannot be adjusted, and why.

use super::block::Block;
use super::network::Network;
use super::options::Datum;
use crate::camera::is_rotation;
use crate::catalogue::check_values;
use crate::math::dot3;
use crate::{Cause, Computation, Error};

/// Least number of accepted rays of an image: three fix it up to four solutions.
const LEAST_RAYS: usize = 4;

/// Largest coordinate of object space: what a number holds to a hundredth of a millionth beside a unit.
const LARGEST: f64 = 1e8;

/// Refuses indices that point nowhere, values that are none, and an image that sees a point twice.
pub(super) fn check_block(block: &Block, datum: Datum) -> Result<(), Error> {
    // Control alone orients a single image.
    let needed = if datum.uses_control() { 1 } else { 2 };
    if block.images.len() < needed {
        return Err(Error::TooFew { what: "images of a block", got: block.images.len(), needed });
    }
    block.cameras.iter().enumerate().try_for_each(|(index, camera)| camera.check(|| format!("camera {index} (counted from 0)")))?;
    for (index, image) in block.images.iter().enumerate() {
        let place = |what: &str| format!("{what} of image {index} (counted from 0)");
        check_index("camera of an image", image.camera, block.cameras.len(), || place("camera"))?;
        if !is_rotation(&image.pose.rotation) {
            let got = format!("{:?} as {}", image.pose.rotation, place("rotation"));
            return Err(Error::InvalidInput {
                what: "rotation of an image",
                got,
                allowed: "rows at right angles, of length 1, right-handed".into(),
            });
        }
        check_position(&image.pose.position, || place("position"))?;
        if let Some(axis) = image.axis {
            if !((dot3(&axis.direction, &axis.direction) - 1.0).abs() < 1e-6) {
                let got = format!("{:?} as {}", axis.direction, place("direction of the axis"));
                return Err(Error::InvalidInput { what: "direction of an axis", got, allowed: "a vector of length 1".into() });
            }
            check_values("sigma of an axis", &[axis.sigma_deg], 1e-6..=1e4, || place("sigma of the axis"))?;
        }
        if let Some(gnss) = image.gnss {
            for (value, sigma) in gnss.position.iter().zip(gnss.sigma).filter_map(|(value, sigma)| Some((value, sigma?))) {
                check_values("position", &[*value], -LARGEST..=LARGEST, || place("GNSS position"))?;
                check_values("sigma of a position", &[sigma], 1e-9..=1e9, || place("GNSS sigma"))?;
            }
        }
    }
    for (index, point) in block.points.iter().enumerate() {
        check_position(point, || format!("point {index} (counted from 0)"))?;
    }
    for (index, ray) in block.rays.iter().enumerate() {
        let place = |what: &str| format!("{what} of ray {index} (counted from 0)");
        check_index("image of a ray", ray.image, block.images.len(), || place("image"))?;
        check_index("point of a ray", ray.point, block.points.len(), || place("point"))?;
        check_values("image coordinates", &[ray.x_px, ray.y_px], -1e7..=1e7, || place("coordinates"))?;
        check_values("weight", &[ray.weight], 1e-12..=1e12, || place("weight"))?;
    }
    for (index, prior) in block.camera_priors.iter().enumerate() {
        if block.camera_priors[..index].iter().any(|other| other.camera == prior.camera) {
            let got = format!("camera {} (counted from 0) twice", prior.camera);
            return Err(Error::InvalidInput { what: "priors of cameras", got, allowed: "each camera once".into() });
        }
        check_index("camera of a prior", prior.camera, block.cameras.len(), || "camera of a prior".into())?;
        let place = || format!("prior of camera {} (counted from 0)", prior.camera);
        for (value, sigma) in prior.values.iter().zip(prior.sigma).filter_map(|(value, sigma)| Some((value, sigma?))) {
            check_values("parameter of a camera", &[*value], -LARGEST..=LARGEST, place)?;
            check_values("sigma of a camera", &[sigma], 1e-12..=1e9, place)?;
        }
    }
    check_control(block)?;
    check_once(block)?;
    if datum.uses_control() && block.control.is_empty() && !datum.uses_gnss() {
        return Err(Error::TooFew { what: "control points, for the datum", got: 0, needed: 3 });
    }
    Ok(())
}

fn check_control(block: &Block) -> Result<(), Error> {
    let mut is_control = vec![false; block.points.len()];
    for (index, control) in block.control.iter().enumerate() {
        let place = |what: &str| format!("{what} of control point {index} (counted from 0)");
        check_index("point of a control point", control.point, block.points.len(), || place("point"))?;
        check_position(&control.position, || place("position"))?;
        check_values("sigma of a position", &control.sigma, 1e-9..=1e9, || place("sigma"))?;
        if std::mem::replace(&mut is_control[control.point], true) {
            let got = format!("point {} (counted from 0) twice", control.point);
            return Err(Error::InvalidInput { what: "control points", got, allowed: "each point once".into() });
        }
    }
    Ok(())
}

/// Refuses a second ray of the same image and point.
fn check_once(block: &Block) -> Result<(), Error> {
    let mut pairs: Vec<(usize, usize)> = block.rays.iter().map(|ray| (ray.point, ray.image)).collect();
    pairs.sort_unstable();
    match pairs.windows(2).find(|w| w[0] == w[1]) {
        Some(w) => {
            let got = format!("two rays of image {} to point {} (counted from 0)", w[0].1, w[0].0);
            Err(Error::InvalidInput { what: "rays", got, allowed: "at most one ray for each image and point".into() })
        }
        None => Ok(()),
    }
}

fn check_index(what: &'static str, index: usize, number: usize, place: impl Fn() -> String) -> Result<(), Error> {
    if index < number {
        return Ok(());
    }
    let allowed = if number == 0 { "none: there are none".into() } else { format!("0 to {}", number - 1) };
    Err(Error::InvalidInput { what, got: format!("{index} as {}", place()), allowed })
}

fn check_position(position: &[f64; 3], place: impl Fn() -> String) -> Result<(), Error> {
    check_values("position", position, -LARGEST..=LARGEST, place)
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
