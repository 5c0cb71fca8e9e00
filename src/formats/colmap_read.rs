//! Reading COLMAP's text model.

use super::quaternion::pose_of_vision;
use super::text::Line;
use crate::text::shorten;
use crate::{BlockModel, Camera, Error, FileFault, ImageObservation, ModelImage, ObjectPoint};
use std::collections::BTreeMap;

/// Numbers that stand in a file, and the indices they get here.
type Numbers = BTreeMap<u64, usize>;

/// Reads the texts of `cameras.txt`, `images.txt` and `points3D.txt`.
///
/// Rays of no point are passed over, and so are further rays of a point in an image: COLMAP keeps a track that an image sees twice. The models SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL, OPENCV and FULL_OPENCV are read where they
/// have one focal length and no more than three radial coefficients.
///
/// # Errors
/// [`Error::UnreadableFile`], naming file and line, for what is missing, damaged or refers to nothing; as [`BlockModel::check`].
pub fn read_colmap_model(cameras: &str, images: &str, points: &str) -> Result<BlockModel, Error> {
    let (cameras, camera_numbers) = read_cameras(cameras)?;
    let (images, image_numbers, features) = read_images(images, &camera_numbers)?;
    let points = read_points(points, &image_numbers, &features)?;
    let model = BlockModel { cameras, images, points, origin: None };
    model.check().map(|()| model)
}

/// Lines that are no comments; empty ones count where they may be the rays of an image.
fn lines<'a>(what: &'static str, text: &'a str) -> impl Iterator<Item = Line<'a>> {
    let text = text.trim_start_matches('\u{feff}');
    text.lines()
        .enumerate()
        .map(move |(index, text)| Line { what, number: index + 1, text })
        .filter(|line| !line.text.trim_start().starts_with('#'))
}

fn read_cameras(text: &str) -> Result<(Vec<Camera>, Numbers), Error> {
    let (mut cameras, mut numbers) = (Vec::new(), Numbers::new());
    for line in lines("cameras.txt", text).filter(|line| !line.text.trim().is_empty()) {
        let words = &mut line.words();
        let number = line.whole(words, "CAMERA_ID")?;
        let model = line.word(words, "MODEL")?;
        let (width_px, height_px) = (line.whole(words, "WIDTH")?, line.whole(words, "HEIGHT")?);
        let mut of = Vec::new();
        for word in words.by_ref() {
            of.push(line.number(&mut std::iter::once(word), "PARAMS")?);
        }
        let (focal_px, principal_point_px, radial, tangential) = match (model, of.as_slice()) {
            ("SIMPLE_PINHOLE", &[f, cx, cy]) => (f, [cx, cy], [0.0; 3], [0.0; 2]),
            ("PINHOLE", &[fx, fy, cx, cy]) if fx == fy => (fx, [cx, cy], [0.0; 3], [0.0; 2]),
            ("SIMPLE_RADIAL", &[f, cx, cy, k1]) => (f, [cx, cy], [k1, 0.0, 0.0], [0.0; 2]),
            ("RADIAL", &[f, cx, cy, k1, k2]) => (f, [cx, cy], [k1, k2, 0.0], [0.0; 2]),
            ("OPENCV", &[fx, fy, cx, cy, k1, k2, p1, p2]) if fx == fy => (fx, [cx, cy], [k1, k2, 0.0], [p1, p2]),
            ("FULL_OPENCV", &[fx, fy, cx, cy, k1, k2, p1, p2, k3, 0.0, 0.0, 0.0]) if fx == fy => (fx, [cx, cy], [k1, k2, k3], [p1, p2]),
            _ => return Err(line.refused(FileFault::CameraModel { model: shorten(model), parameters: of.len() })),
        };
        if numbers.insert(number, cameras.len()).is_some() {
            return Err(line.refused(FileFault::CameraAgain { camera: number }));
        }
        cameras.push(Camera { principal_point_px, radial, tangential, ..Camera::without_distortion(width_px, height_px, focal_px) });
    }
    Ok((cameras, numbers))
}

type Features = Vec<Vec<[f64; 2]>>;

fn read_images(text: &str, cameras: &Numbers) -> Result<(Vec<ModelImage>, Numbers, Features), Error> {
    let (mut images, mut numbers, mut features) = (Vec::new(), Numbers::new(), Features::new());
    let mut lines = lines("images.txt", text);
    while let Some(line) = lines.next() {
        if line.text.trim().is_empty() {
            continue;
        }
        let words = &mut line.words();
        let number = line.whole(words, "IMAGE_ID")?;
        let mut values = [0.0; 7];
        for (value, name) in values.iter_mut().zip(["QW", "QX", "QY", "QZ", "TX", "TY", "TZ"]) {
            *value = line.number(words, name)?;
        }
        let [qw, qx, qy, qz, tx, ty, tz] = values;
        let pose = pose_of_vision([qw, qx, qy, qz], [tx, ty, tz]).ok_or_else(|| line.refused(FileFault::ZeroQuaternion))?;
        let camera: u64 = line.whole(words, "CAMERA_ID")?;
        let camera = *cameras.get(&camera).ok_or_else(|| line.refused(FileFault::NoCamera { camera }))?;
        let name = line.word(words, "NAME")?.to_string();
        if let Some(word) = words.next() {
            return Err(line.refused(FileFault::AfterName { word: shorten(word) }));
        }
        let rays = lines.next().ok_or_else(|| line.refused(FileFault::NoFeatures))?;
        if numbers.insert(number, images.len()).is_some() {
            return Err(line.refused(FileFault::ImageAgain { image: number }));
        }
        features.push(read_rays(&rays)?);
        images.push(ModelImage { name, camera, pose: Some(pose) });
    }
    Ok((images, numbers, features))
}

/// The points of the rays are those of `points3D.txt`; here only their places are taken.
fn read_rays(line: &Line<'_>) -> Result<Vec<[f64; 2]>, Error> {
    let words = &mut line.words().peekable();
    let mut rays = Vec::new();
    while words.peek().is_some() {
        rays.push([line.number(words, "X")?, line.number(words, "Y")?]);
        line.whole::<i64>(words, "POINT3D_ID")?;
    }
    Ok(rays)
}

fn read_points(text: &str, images: &Numbers, features: &Features) -> Result<Vec<ObjectPoint>, Error> {
    let mut points: BTreeMap<u64, ObjectPoint> = BTreeMap::new();
    for line in lines("points3D.txt", text).filter(|line| !line.text.trim().is_empty()) {
        let words = &mut line.words().peekable();
        let number: u64 = line.whole(words, "POINT3D_ID")?;
        let position = Some([line.number(words, "X")?, line.number(words, "Y")?, line.number(words, "Z")?]);
        let colour = [line.whole(words, "R")?, line.whole(words, "G")?, line.whole(words, "B")?];
        let rmse_px = Some(line.number(words, "ERROR")?).filter(|error| *error >= 0.0);
        let mut rays: Vec<ImageObservation> = Vec::new();
        while words.peek().is_some() {
            let image: u64 = line.whole(words, "IMAGE_ID")?;
            let index: usize = line.whole(words, "POINT2D_IDX")?;
            let image = *images.get(&image).ok_or_else(|| line.refused(FileFault::NoImage { image }))?;
            let place = features[image].get(index).ok_or_else(|| line.refused(FileFault::NoFeature { image, feature: index }))?;
            if rays.iter().all(|ray| ray.image != image) {
                rays.push(ImageObservation { image, x_px: place[0], y_px: place[1], confidence: 1.0 });
            }
        }
        if points
            .insert(
                number,
                ObjectPoint {
                    number: u32::try_from(number).ok(),
                    position,
                    colour,
                    rmse_px,
                    confidence: 1.0,
                    name: None,
                    rays,
                    by_hand: 0,
                },
            )
            .is_some()
        {
            return Err(line.refused(FileFault::PointAgain { point: number }));
        }
    }
    Ok(points.into_values().collect())
}

#[cfg(test)]
mod tests {
    use super::super::colmap_write::write_model;
    use super::super::sight::Sights;
    use super::*;
    use crate::model::tiny_block;

    /// The tiny block without what COLMAP's model has no room for.
    fn oriented(distortion: [f64; 5]) -> BlockModel {
        let mut model = tiny_block();
        let [k1, k2, k3, p1, p2] = distortion;
        model.cameras[0] = Camera { radial: [k1, k2, k3], tangential: [p1, p2], pixel_mm: None, ..model.cameras[0] };
        model.images.pop();
        model.points.pop();
        model.points[0].rays.pop();
        (1..).zip(&mut model.points).for_each(|(number, point)| point.number = Some(number));
        model.origin = None;
        model
    }

    fn texts(model: &BlockModel) -> [String; 3] {
        write_model(model, &Sights::new(model)).unwrap()
    }

    #[test]
    fn a_written_model_reads_back_as_it_was() {
        for distortion in
            [[0.0; 5], [0.1, 0.0, 0.0, 0.0, 0.0], [0.1, -0.2, 0.0, 0.0, 0.0], [0.1, 0.0, 0.0, 1e-3, 0.0], [0.0, 0.0, 0.3, 0.0, 0.0]]
        {
            let model = oriented(distortion);
            let [cameras, images, points] = texts(&model);
            assert_eq!(read_colmap_model(&cameras, &images, &points).unwrap(), model, "{distortion:?}");
        }
    }

    #[test]
    fn a_track_that_an_image_sees_twice_keeps_its_first_ray_there() {
        let model = oriented([0.0; 5]);
        let [cameras, images, points] = texts(&model);
        let again = points.replace("1 0 2 0\n", "1 0 2 0 1 1\n");
        assert_ne!(again, points);
        assert_eq!(read_colmap_model(&cameras, &images, &again).unwrap(), model);
    }

    #[test]
    fn what_is_wrong_is_named_by_file_and_line() {
        let [cameras, images, points] = texts(&oriented([0.0; 5]));
        let message = |cameras: &str, images: &str, points: &str| {
            let error = read_colmap_model(cameras, images, points).unwrap_err();
            assert_eq!(error.code(), "unreadable-file");
            error.to_string()
        };
        let wrong = message(&cameras.replace("SIMPLE_PINHOLE", "FISHEYE"), &images, &points);
        assert!(wrong.contains("cameras.txt cannot be read: line 2: FISHEYE with 3 parameters"), "{wrong}");
        let wrong = message(&cameras, &images.replace("0 1 0 0 -10", "0 0 0 0 -10"), &points);
        assert!(wrong.contains("images.txt cannot be read: line 5: the quaternion is zero"), "{wrong}");
        let wrong = message(&cameras, &images.replace("1 b.jpg", "7 b.jpg"), &points);
        assert!(wrong.contains("camera 7 is not in cameras.txt"), "{wrong}");
        let wrong = message(&cameras, &images, &points.replace("2 0\n", "2 9\n"));
        assert!(wrong.contains("points3D.txt cannot be read: line 2: image 1 has no point 9"), "{wrong}");
        let wrong = message(&cameras, &images, &points.replace("0.25", "NaN"));
        assert!(wrong.contains("ERROR is 'NaN', not a finite number"), "{wrong}");
        let wrong = message(&cameras, &images.replace("225 150 1", "225 150"), &points);
        assert!(wrong.contains("line 4"), "{wrong}");
        let wrong = message(&cameras, images.lines().take(3).collect::<Vec<_>>().join("\n").as_str(), &points);
        assert!(wrong.contains("the line of its points is missing"), "{wrong}");
    }
}
