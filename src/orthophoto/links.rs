//! Links between an image and an orthophoto: points of both that show one place, sought where the image, resampled to the ground by what is
//! known of its orientation, has them.

use super::footprint::Footprint;
use super::heights::Heights;
use super::hidden::Hidden;
use super::rectify::{Seen, rectify_from};
use super::reference::Orthophoto;
use crate::Georeference;
use crate::matching::{LeastSquares, LeastSquaresOptions};
use crate::{Camera, Error, Feature, FeatureOptions, GreyImage, Guide, GuidedOptions, Located, Pose, features, guided_matches, halve};

/// A point of the image with the place that the orthophoto has for it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Found {
    pub at: [f64; 2],
    pub place: [f64; 3],
    /// By how much heights about the place differ from its own: beside a wall any of them may be meant.
    pub height_spread: f64,
    /// Standard error of its position in the image, in px.
    pub measured_px: f64,
}

/// Standard error of a matched point in the image, in px.
pub(super) const MEASURED_PX: f64 = 0.3;

/// How links are sought.
pub(super) struct Search {
    /// From where a point is expected, in px of the resampled images.
    pub radius_px: f64,
    /// Longest side of these.
    pub longest_px: f64,
    /// Whether least squares matching takes the positions from the images themselves.
    pub refines: bool,
}

/// An image with what is known of its orientation, over an orthophoto in a system about a place near it.
pub(super) struct Over<'a> {
    /// Halved none, one, two times and so on.
    pub image: &'a [GreyImage],
    /// Whether a position in px is of the photograph.
    pub shows: &'a dyn Fn([f64; 2]) -> bool,
    pub camera: Camera,
    pub pose: Pose,
    pub reference: &'a Orthophoto,
    pub georeference: Georeference,
    pub heights: &'a Heights,
}

/// Side of a window of least squares matching.
const WINDOW: usize = 21;
/// Neither picture is halved to less than this, in px.
const LEAST_SIDE: usize = 64;
/// Points nearer than this to where the resampled image ends are its edge, in px.
const EDGE_PX: f64 = 8.0;
/// Where heights about a place are looked up, in px of the resampled image.
const AROUND: [[f64; 2]; 8] = [[-2.0, 0.0], [2.0, 0.0], [0.0, -2.0], [0.0, 2.0], [-1.5, -1.5], [1.5, -1.5], [-1.5, 1.5], [1.5, 1.5]];
/// The orthophoto is halved as long as its pixels stay smaller than this many of the image, and the image likewise.
const AS_FINE: f64 = 1.4;
const IDENTITY: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl Over<'_> {
    /// What it shows of the ground.
    pub fn footprint(&self) -> Footprint<'_> {
        Footprint { camera: &self.camera, pose: &self.pose, heights: self.heights }
    }

    /// The part of the orthophoto under the image: first column and row, number of columns and rows.
    fn part(&self, radius: f64) -> Option<([usize; 2], [usize; 2])> {
        let corners: Vec<[f64; 2]> = self.footprint().border().into_iter().map(|place| self.georeference.pixel(place)).collect();
        let size = self.reference.size().map(|side| side as f64);
        let within = |axis: usize| {
            let values = corners.iter().map(|c| c[axis]);
            let low = values.clone().fold(f64::INFINITY, f64::min) - radius;
            let high = values.fold(f64::NEG_INFINITY, f64::max) + radius;
            [low.max(0.0), high.min(size[axis])]
        };
        let [x, y] = [within(0), within(1)];
        let enough = |[low, high]: [f64; 2]| high - low >= (2 * WINDOW) as f64;
        (enough(x) && enough(y)).then(|| ([x[0] as usize, y[0] as usize], [x, y].map(|[low, high]| (high - low) as usize)))
    }

    /// Seeks links; none where image and orthophoto hardly overlap.
    pub fn links(&self, search: &Search, options: &FeatureOptions) -> Result<Vec<Found>, Error> {
        let gsd = self.footprint().gsd();
        let radius = search.radius_px * self.georeference.gsd().max(gsd) / self.georeference.gsd();
        let Some((first, size)) = self.part(radius) else { return Ok(Vec::new()) };
        let longest = size[0].max(size[1]) as f64;
        let mut halvings = 0;
        // A wrong orientation may see the ground from anywhere.
        while size[0].min(size[1]) >> (halvings + 1) >= LEAST_SIDE
            && (self.georeference.halved(halvings + 1).gsd() <= AS_FINE * gsd || longest / f64::from(1_u32 << halvings) > search.longest_px)
        {
            halvings += 1;
        }
        let first = self.reference.aligned(first, halvings);
        let ground = self.reference.part(first, size, halvings)?;
        let georeference = self.georeference.from(first[0], first[1]).halved(halvings);
        let finest = (0..self.image.len()).take_while(|k| gsd * f64::from(1_u32 << k) <= AS_FINE * georeference.gsd());
        let level = finest.last().unwrap_or(0);
        let camera = reduced(&self.camera, level, &self.image[level]);
        let size = [ground.width(), ground.height()];
        let own = rectify_from(&[self.image[level].view()], &camera, &self.pose, self.heights, &georeference, size, Some)?;
        let [grey] = own.bands.images() else { unreachable!("one band of one") };
        let found = [grey, &ground].map(|picture| features(picture.view(), Some(own.mask.view()), options));
        let [left, right] = [&found[0], &found[1]].map(|found| found.as_deref().map_err(Clone::clone));
        let inner = |feature: &&Feature| {
            let [x, y] = [feature.point.x, feature.point.y];
            let near = [[EDGE_PX, 0.0], [-EDGE_PX, 0.0], [0.0, EDGE_PX], [0.0, -EDGE_PX]];
            let shows = |x: f64, y: f64| {
                x >= 0.0
                    && y >= 0.0
                    && x < own.mask.width() as f64
                    && y < own.mask.height() as f64
                    && own.mask.view().at(x as usize, y as usize) != 0
            };
            near.iter().all(|[dx, dy]| shows(x + dx, y + dy)) && self.reference.shows(self.georeference.pixel(georeference.ground([x, y])))
        };
        let split = |features: &[Feature]| -> (Vec<[f64; 2]>, Vec<u8>) {
            let kept: Vec<&Feature> = features.iter().filter(inner).collect();
            (kept.iter().map(|f| [f.point.x, f.point.y]).collect(), kept.iter().flat_map(|f| f.descriptor).collect())
        };
        let ((own_at, own_bytes), (ground_at, ground_bytes)) = (split(left?), split(right?));
        let guided = GuidedOptions { radius_px: search.radius_px, ..GuidedOptions::default() };
        let of = |positions, descriptors| Located { positions, descriptors };
        let matches = guided_matches(of(&ground_at, &ground_bytes), of(&own_at, &own_bytes), &Guide::Places(IDENTITY), &guided)?;
        let mut windows = LeastSquares::new(WINDOW);
        let hidden = Hidden::new(&self.pose, self.heights, georeference, size);
        let is_seen = |at: [f64; 2]| !hidden.about(at);
        let seen = Seen::new(&self.camera, &self.pose);
        let linked = matches.iter().filter_map(|m| {
            let (from, start) = (ground_at[m.left], own_at[m.right]);
            let to = if search.refines {
                let limits = LeastSquaresOptions::default();
                let unit = [[1.0, 0.0], [0.0, 1.0]];
                windows.fit_part((ground.view(), from), (grey.view(), start), unit, &limits, &is_seen).ok()?.position
            } else {
                start
            };
            let three = |[x, y]: [f64; 2]| self.heights.at([x, y]).map(|z| [x, y, z]);
            let at = seen.at(&three(georeference.ground(to))?).filter(|at| (self.shows)(*at))?;
            let place = three(georeference.ground(from))?;
            let height_spread = height_spread(self.heights, &georeference, from, place[2]);
            Some(Found { at, place, height_spread, measured_px: MEASURED_PX })
        });
        Ok(linked.collect())
    }
}

/// By how much heights about a position of a picture of the ground differ from its own.
pub(super) fn height_spread(heights: &Heights, georeference: &Georeference, [x, y]: [f64; 2], height: f64) -> f64 {
    let about = AROUND.map(|[dx, dy]| heights.at(georeference.ground([x + dx, y + dy])));
    about.into_iter().flatten().map(|z| (z - height).abs()).fold(0.0, f64::max)
}

/// The camera of an image that was halved so many times.
pub(super) fn reduced(camera: &Camera, halvings: usize, image: &GreyImage) -> Camera {
    let share = 1.0 / f64::from(1_u32 << halvings);
    Camera {
        width_px: image.width() as u32,
        height_px: image.height() as u32,
        focal_px: share * camera.focal_px,
        principal_point_px: camera.principal_point_px.map(|v| share * v),
        ..*camera
    }
}

/// The image halved none, one, two times and so on, as long as it has some hundred px.
pub(super) fn halvings(image: &GreyImage) -> Vec<GreyImage> {
    let mut all = vec![image.clone()];
    while let Some(last) = all.last().filter(|last| last.width().min(last.height()) >= 256) {
        all.push(halve(last.view()));
    }
    all
}
