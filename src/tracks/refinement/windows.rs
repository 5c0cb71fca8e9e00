//! Windows of an image around rays: what is kept of it, so that points are refined without their images.

use super::RefinementOptions;
use crate::error::refuse;
use crate::image::halve;
use crate::{Error, GreyImage, GreyView, Refusal};

/// A ray's windows are cut from the image and from halved ones as long as its scale there is at least this, px.
const LEAST_SCALE_PX: f64 = 1.6;
/// Times that an image is halved at most.
const MOST_HALVINGS: u32 = 6;
/// Largest ratio of scales within one pair of levels, √2, with a corner of the window turned by 45°.
const LARGEST_REACH: f64 = 2.0;
/// Px around the matched window in which it may move, and the spline settles.
const MARGIN: usize = 12;

/// A place at which windows are cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WindowCentre {
    /// Column and row in px, the centre of the top-left pixel at (0.5, 0.5).
    pub position: [f64; 2],
    pub scale_px: f64,
}

impl WindowCentre {
    /// Refuses what is no place.
    pub(super) fn check(&self) -> Result<(), Error> {
        if self.position.iter().all(|v| v.is_finite()) && self.scale_px.is_finite() && self.scale_px > 0.0 {
            return Ok(());
        }
        refuse(Refusal::RayNumbers { position: format!("{:?}", self.position), scale_px: self.scale_px })
    }

    /// Halvings after which the scale is still large enough to be matched by.
    pub(super) fn most_halvings(&self) -> u32 {
        let mut halvings = 0;
        let mut scale = 0.5 * self.scale_px;
        while scale >= LEAST_SCALE_PX && halvings < MOST_HALVINGS {
            (halvings, scale) = (halvings + 1, 0.5 * scale);
        }
        halvings
    }
}

/// A window of an image, or of the image halved a number of times.
#[derive(Clone, Copy)]
pub struct ObservationWindow<'a> {
    pub halvings: u32,
    /// Column and row of its first pixel in the halved image.
    pub first: [u32; 2],
    pub grey: GreyView<'a>,
}

impl ObservationWindow<'_> {
    /// Where a position of the image lies in the window, px.
    pub(super) fn place(&self, position: [f64; 2]) -> [f64; 2] {
        let scale = f64::from(1u32 << self.halvings);
        [0, 1].map(|axis| position[axis] / scale - f64::from(self.first[axis]))
    }

    /// Where a position of the window lies in the image, px.
    pub(super) fn position(&self, place: [f64; 2]) -> [f64; 2] {
        let scale = f64::from(1u32 << self.halvings);
        [0, 1].map(|axis| (place[axis] + f64::from(self.first[axis])) * scale)
    }
}

/// A ray with what it shows.
#[derive(Clone)]
pub struct WindowedObservation<'a> {
    pub place: WindowCentre,
    /// Dominant direction in rad from x towards y.
    pub orientation_rad: f64,
    /// As [`observation_windows`](super::observation_windows) cuts them; none at a level that is too small for one.
    pub windows: Vec<ObservationWindow<'a>>,
}

impl<'a> WindowedObservation<'a> {
    pub(super) fn window(&self, halvings: u32) -> Option<&ObservationWindow<'a>> {
        self.windows.iter().find(|window| window.halvings == halvings)
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        self.place.check()?;
        if self.orientation_rad.is_finite() {
            return Ok(());
        }
        refuse(Refusal::RayDirection { direction_rad: self.orientation_rad })
    }
}

/// The windows of an image's rays, flat.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ObservationWindows {
    /// Side of each window in px.
    pub side: usize,
    /// Of each window: index of its ray, halvings, column and row of its first pixel in the halved image.
    pub places: Vec<[u32; 4]>,
    /// Grey values of the windows one after the other, side x side each, row by row.
    pub grey: Vec<u8>,
}

/// Side of the windows that are cut for matching by these options, px.
pub(super) fn cut_side(options: &RefinementOptions) -> usize {
    2 * (libm::ceil(LARGEST_REACH * (options.window / 2) as f64) as usize + MARGIN) + 1
}

/// Cuts windows around rays from the image and, by the scale of each ray, from the image halved once or more often. Windows are shifted to
/// lie inside; levels that are smaller than a window have none. They are ordered by ray and halvings.
///
/// # Errors
/// [`Error::InvalidOption`]; [`Error::InvalidInput`] for places that are not inside the image or no numbers.
pub fn observation_windows(image: GreyView<'_>, rays: &[WindowCentre], options: &RefinementOptions) -> Result<ObservationWindows, Error> {
    options.check_ranges()?;
    for ray in rays {
        ray.check()?;
        let size = [image.width() as f64, image.height() as f64];
        if !(0..2).all(|axis| (0.0..=size[axis]).contains(&ray.position[axis])) {
            let position = format!("{:?}", ray.position);
            return refuse(Refusal::RayPlace { position, width: image.width(), height: image.height() });
        }
    }
    let most = rays.iter().map(WindowCentre::most_halvings).max().unwrap_or(0);
    let mut halved: Vec<GreyImage> = Vec::new();
    for level in 0..most as usize {
        halved.push(halve(if level == 0 { image } else { halved[level - 1].view() }));
    }
    let mut cut = ObservationWindows { side: cut_side(options), ..ObservationWindows::default() };
    for (index, ray) in rays.iter().enumerate() {
        for halvings in 0..=ray.most_halvings() {
            let level = if halvings == 0 { image } else { halved[halvings as usize - 1].view() };
            cut.add(level, index as u32, halvings, ray.position);
        }
    }
    Ok(cut)
}

impl ObservationWindows {
    /// Windows that were cut by the same options, perhaps of several images.
    ///
    /// # Errors
    /// [`Error::InvalidOption`]; [`Error::InvalidInput`] where places are not ordered by ray and halvings, or there are more or fewer grey
    /// values than they have.
    pub fn new(places: Vec<[u32; 4]>, grey: Vec<u8>, options: &RefinementOptions) -> Result<Self, Error> {
        options.check_ranges()?;
        let side = cut_side(options);
        if grey.len() != places.len() * side * side {
            return refuse(Refusal::WindowValues { values: grey.len(), windows: places.len(), side });
        }
        let ordered = places.windows(2).all(|pair| pair[0][..2] < pair[1][..2]);
        match places.iter().find(|place| place[1] > MOST_HALVINGS) {
            Some(place) => refuse(Refusal::WindowHalvings { halvings: place[1], most: MOST_HALVINGS }),
            None if !ordered => refuse(Refusal::WindowOrder),
            None => Ok(Self { side, places, grey }),
        }
    }

    fn add(&mut self, level: GreyView<'_>, ray: u32, halvings: u32, position: [f64; 2]) {
        let side = self.side;
        if level.width() < side || level.height() < side {
            return;
        }
        let most = [level.width() - side, level.height() - side];
        let scale = f64::from(1u32 << halvings);
        let first = [0, 1].map(|axis| ((position[axis] / scale) as usize).saturating_sub(side / 2).min(most[axis]));
        self.places.push([ray, halvings, first[0] as u32, first[1] as u32]);
        (first[1]..first[1] + side).for_each(|row| self.grey.extend_from_slice(&level.row(row)[first[0]..first[0] + side]));
    }

    /// The windows of a ray.
    ///
    /// # Errors
    /// [`Error::InvalidInput`] where there are more or fewer grey values than windows.
    pub fn of_ray(&self, ray: u32) -> Result<Vec<ObservationWindow<'_>>, Error> {
        let from = self.places.partition_point(|place| place[0] < ray);
        let own = self.places[from..].iter().take_while(|place| place[0] == ray).enumerate();
        own.map(|(k, [_, halvings, col, row])| {
            let area = self.side * self.side;
            let grey = self.grey.get((from + k) * area..(from + k + 1) * area).unwrap_or_default();
            Ok(ObservationWindow { halvings: *halvings, first: [*col, *row], grey: GreyView::new(self.side, self.side, grey)? })
        })
        .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn image() -> GreyImage {
        GreyImage::from_fn(300, 200, |col, row| (col * 7 + row * 13) as u8).unwrap()
    }

    fn at(x: f64, y: f64, scale_px: f64) -> WindowCentre {
        WindowCentre { position: [x, y], scale_px }
    }

    #[test]
    fn windows_lie_about_their_ray_at_each_level_and_inside_the_image() {
        let image = image();
        let options = RefinementOptions::default();
        let rays = [at(150.3, 100.7, 2.0), at(3.0, 199.0, 3.4), at(160.0, 90.0, 40.0)];
        let cut = observation_windows(image.view(), &rays, &options).unwrap();
        assert_eq!((cut.side, cut.grey.len()), (57, cut.places.len() * 57 * 57));
        // The image halved twice has 50 rows: too few for a window.
        let levels: Vec<[u32; 2]> = cut.places.iter().map(|place| [place[0], place[1]]).collect();
        assert_eq!(levels, [[0, 0], [1, 0], [1, 1], [2, 0], [2, 1]]);
        let own = cut.of_ray(0).unwrap()[0];
        assert_eq!((own.first, own.place([150.3, 100.7]).map(f64::floor)), ([122, 72], [28.0, 28.0]));
        assert_eq!((own.grey.at(5, 9), own.grey.width()), (image.view().at(127, 81), 57));
        let border = cut.of_ray(1).unwrap();
        assert_eq!((border[0].first, border[1].first), ([0, 143], [0, 43]));
        assert_eq!(border[1].grey.at(3, 4), halve(image.view()).view().at(3, 47));
        let back = border[1].position(border[1].place([3.0, 199.0]));
        assert!((back[0] - 3.0).abs() < 1e-12 && (back[1] - 199.0).abs() < 1e-12);
    }

    #[test]
    fn places_that_are_none_or_outside_are_refused() {
        let image = image();
        for ray in [
            at(f64::NAN, 5.0, 2.0),
            at(5.0, 5.0, f64::NAN),
            at(5.0, 5.0, 0.0),
            at(5.0, 5.0, -1.0),
            at(5.0, f64::INFINITY, 2.0),
            at(301.0, 5.0, 2.0),
        ] {
            let error = observation_windows(image.view(), &[ray], &RefinementOptions::default()).unwrap_err();
            assert_eq!(error.code(), "invalid-input", "{ray:?}");
        }
        assert!(observation_windows(image.view(), &[], &RefinementOptions::default()).unwrap().places.is_empty());
        let even = RefinementOptions { window: 20, ..RefinementOptions::default() };
        assert!(matches!(observation_windows(image.view(), &[], &even), Err(Error::InvalidOption { field: "refinement.window", .. })));
    }

    #[test]
    fn windows_that_do_not_fit_together_are_refused() {
        let options = RefinementOptions::default();
        let refused =
            |places: &[[u32; 4]], grey: usize| ObservationWindows::new(places.to_vec(), vec![0; grey], &options).unwrap_err().to_string();
        let area = 57 * 57;
        assert!(refused(&[[0, 0, 0, 0]], area - 1).contains("57 x 57"));
        assert!(refused(&[[1, 0, 0, 0], [0, 0, 0, 0]], 2 * area).contains("ordered"));
        assert!(refused(&[[0, 1, 0, 0], [0, 1, 0, 0]], 2 * area).contains("ordered"));
        assert!(refused(&[[0, 40, 0, 0]], area).contains("halvings"));
        assert!(ObservationWindows::new(vec![[0, 0, 0, 0], [0, 1, 0, 0], [3, 0, 5, 5]], vec![0; 3 * area], &options).is_ok());
    }
}
