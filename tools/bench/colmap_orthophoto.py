"""An orthophoto that another program made of half of a block: python3 tools/bench/colmap_orthophoto.py PHOTOS OUT

COLMAP (pycolmap) calibrates the camera by all photographs of PHOTOS, and orients every other one with it; the positions of the receiver place the block in
its zone of UTM. The heights of the ground are matched on vertical lines here, from the heights of COLMAP's points on; the photographs are resampled to the
ground by OpenCV; GDAL (rasterio) writes orthophoto.tif and heights.tif. Then COLMAP places the other photographs beside the first ones, which stay where they are: both are in one datum, that of
the orthophoto. Writes truth.json with the camera and the positions of the others. Needs pycolmap, rasterio, opencv-python-headless and scipy.
"""

import json
import sys
from pathlib import Path

import cv2
import numpy
import pycolmap
import rasterio
from rasterio.transform import from_origin
from rasterio.warp import transform
from scipy.interpolate import LinearNDInterpolator, NearestNDInterpolator

SEED = 1
# Heights on vertical lines: cells of so many pixels of the orthophoto, windows of so many cells, steps of so many pixels, as far from COLMAP's points.
CELL_PX = 2
WINDOW_CELLS = 11
STEP_PX = 1
REACH_PX = 30
# Where windows are less alike COLMAP's points alone say how high the ground is.
LEAST_CORRELATION = 0.6
# The photographs whose centres are so many nearest show a place with the least hidden.
NEAREST = 3
# Points of COLMAP of which the rays do not meet better, in px, or which lie so many median deviations off, are no ground.
MOST_ERROR_PX = 1.5
MOST_DEVIATIONS = 6


def features(photos, folder):
    """The database of features and matches of all photographs, one camera."""
    database = folder / "database.db"
    database.unlink(missing_ok=True)
    extraction, matching = pycolmap.FeatureExtractionOptions(), pycolmap.FeatureMatchingOptions()
    extraction.num_threads = matching.num_threads = 2
    pycolmap.set_random_seed(SEED)
    pycolmap.extract_features(database, photos, camera_mode=pycolmap.CameraMode.SINGLE, extraction_options=extraction)
    pycolmap.match_exhaustive(database, matching_options=matching)
    return database


def oriented(database, photos, folder, names=(), start=None):
    """COLMAP's model of photographs, of all without names; with `start` of those that this model lacks, which itself stays."""
    chosen = pycolmap.IncrementalPipelineOptions()
    chosen.num_threads = 2
    chosen.random_seed = SEED
    chosen.min_model_size = 3
    chosen.multiple_models = False
    chosen.image_names = list(names)
    if names or start:
        # The camera is calibrated by then.
        chosen.ba_refine_focal_length = chosen.ba_refine_extra_params = False
        chosen.mapper.abs_pose_refine_focal_length = chosen.mapper.abs_pose_refine_extra_params = False
        chosen.fix_existing_frames = start is not None
    else:
        chosen.ba_refine_principal_point = True
    folder.mkdir(exist_ok=True)
    models = pycolmap.incremental_mapping(database, photos, folder, options=chosen, input_path=start or "")
    if not models:
        raise SystemExit("COLMAP orients none of the photographs")
    return max(models.values(), key=lambda model: model.num_reg_images())


def with_lens(database):
    """Gives the camera of the database Brown's terms, decentring too, and square pixels: without it focal lengths over level ground are off by percents."""
    with pycolmap.Database.open(str(database)) as opened:
        (known,) = opened.read_all_cameras()
        focal = known.mean_focal_length()
        params = [focal, focal, known.width / 2, known.height / 2, 0, 0, 0, 0]
        camera = pycolmap.Camera(camera_id=known.camera_id, model="OPENCV", width=known.width, height=known.height, params=params)
        camera.has_prior_focal_length = known.has_prior_focal_length
        opened.update_camera(camera)


def calibrated(database, photos, folder):
    """Keeps the camera of the database as all photographs calibrate it: that of half of them, over level ground, leaves its focal length uncertain by percents."""
    with_lens(database)
    (camera,) = oriented(database, photos, folder).cameras.values()
    camera.params = [camera.mean_focal_length()] * 2 + list(camera.params[2:])
    camera.has_prior_focal_length = True
    with pycolmap.Database.open(str(database)) as opened:
        opened.update_camera(camera)
    return camera


def receiver(database):
    """Longitude, latitude and height of each photograph, as COLMAP reads them of EXIF."""
    with pycolmap.Database.open(str(database)) as opened:
        names = {image.image_id: image.name for image in opened.read_all_images()}
        priors = opened.read_all_pose_priors()
        return {names[prior.corr_data_id.id]: numpy.ravel(prior.position)[[1, 0, 2]] for prior in priors}


def in_utm(places):
    """The same in the zone of UTM of the first, and its code."""
    longitude, latitude, _ = next(iter(places.values()))
    code = (32600 if latitude >= 0 else 32700) + int((longitude + 180) // 6) + 1
    x, y = transform("EPSG:4326", f"EPSG:{code}", *zip(*((place[0], place[1]) for place in places.values())))
    return code, {name: numpy.array([x[k], y[k], place[2]]) for k, (name, place) in enumerate(places.items())}


def levelled(model, places):
    """Turns, scales and shifts the model: the mean direction of view is vertical, the rest follows from the receiver's positions.

    They cannot say what is level where strips lie near each other.
    """
    images = [image for image in model.images.values() if image.has_pose]
    down = sum(image.viewing_direction() for image in images)
    down /= numpy.linalg.norm(down)
    east = numpy.cross(down, [0.0, 1.0, 0.0] if abs(down[1]) < 0.9 else [1.0, 0.0, 0.0])
    east /= numpy.linalg.norm(east)
    level = numpy.array([east, numpy.cross(east, down), -down])
    own = numpy.array([level @ image.projection_center() for image in images])
    wanted = numpy.array([places[image.name] for image in images])
    # A plane similarity by least squares: one complex number turns and scales.
    plane = lambda points: (points - points.mean(0)) @ numpy.array([1, 1j, 0])
    factor = numpy.vdot(plane(own), plane(wanted)) / numpy.vdot(plane(own), plane(own))
    cosine, sine = factor.real / abs(factor), factor.imag / abs(factor)
    turn = numpy.array([[cosine, -sine, 0], [sine, cosine, 0], [0, 0, 1]]) @ level
    shift = wanted.mean(0) - abs(factor) * turn @ numpy.mean([image.projection_center() for image in images], 0)
    model.transform(pycolmap.Sim3d(abs(factor), pycolmap.Rotation3d(turn), shift))


class View:
    """A photograph as the model has it."""

    def __init__(self, image, camera, photos):
        pose = image.cam_from_world()
        self.turn, self.shift = pose.rotation.matrix(), pose.translation
        self.centre = -self.turn.T @ self.shift
        self.camera = camera
        self.picture = cv2.imread(str(photos / image.name), cv2.IMREAD_GRAYSCALE)

    def pixels(self, x, y, z):
        """Where the photograph shows places of the ground; the middle of the first pixel is (0.5, 0.5), as COLMAP has it."""
        focal, _, cx, cy, k1, k2, p1, p2 = self.camera.params
        u, v, w = (row[0] * x + row[1] * y + row[2] * z + shift for row, shift in zip(self.turn, self.shift))
        u, v = u / w, v / w
        r2, across = u * u + v * v, 2 * u * v
        radial = 1 + r2 * (k1 + k2 * r2)
        x = u * radial + p1 * across + p2 * (r2 + 2 * u * u)
        y = v * radial + p1 * (r2 + 2 * v * v) + p2 * across
        return focal * x + cx, focal * y + cy

    def on_ground(self, x, y, z):
        """Grey values there; 0 where it shows nothing."""
        u, v = self.pixels(x, y, z)
        return cv2.remap(self.picture, (u - 0.5).astype(numpy.float32), (v - 0.5).astype(numpy.float32), cv2.INTER_CUBIC, borderValue=0)


class Ground:
    """Heights of COLMAP's points, between them by triangles; not a number outside of all."""

    def __init__(self, model):
        points = numpy.array([point.xyz for point in model.points3D.values() if point.error < MOST_ERROR_PX])
        off = numpy.abs(points[:, 2] - numpy.median(points[:, 2]))
        self.points = points[off <= MOST_DEVIATIONS * numpy.median(off)]
        self.at = LinearNDInterpolator(self.points[:, :2], self.points[:, 2])


def correlation(one, other):
    """The correlation coefficients of the windows about all cells; not a number where one of both photographs does not show all of it."""
    window = (WINDOW_CELLS, WINDOW_CELLS)
    a, b = one.astype(numpy.float32), other.astype(numpy.float32)
    mean_a, mean_b = cv2.blur(a, window), cv2.blur(b, window)
    spread = numpy.maximum(cv2.blur(a * a, window) - mean_a**2, 1) * numpy.maximum(cv2.blur(b * b, window) - mean_b**2, 1)
    shown = cv2.erode(((one > 0) & (other > 0)).astype(numpy.uint8), numpy.ones(window, numpy.uint8))
    return numpy.where(shown > 0, (cv2.blur(a * b, window) - mean_a * mean_b) / numpy.sqrt(spread), numpy.nan)


def matched_heights(views, x, y, start, gsd):
    """The height on each vertical line at which the photographs that show it are most alike (vertical line locus), and where that is sure."""
    order = numpy.argsort([numpy.hypot(x - view.centre[0], y - view.centre[1]) for view in views], axis=0)[:NEAREST]
    near = [(order == index).any(0) for index in range(len(views))]
    pairs = [(i, j, near[i] & near[j]) for i in range(len(views)) for j in range(i)]
    pairs = [(i, j, both) for i, j, both in pairs if both.any()]
    most, heights = numpy.full(x.shape, -1.0), start.copy()
    for step in numpy.arange(-REACH_PX, REACH_PX + STEP_PX, STEP_PX) * gsd:
        shown = [view.on_ground(x, y, start + step) for view in views]
        sums, numbers = numpy.zeros(x.shape), numpy.zeros(x.shape)
        for i, j, both in pairs:
            found = correlation(shown[i], shown[j])
            counts = both & numpy.isfinite(found)
            sums[counts] += found[counts]
            numbers[counts] += 1
        alike = numpy.where(numbers > 0, sums / numpy.maximum(numbers, 1), -1)
        better = alike > most
        most[better], heights[better] = alike[better], (start + step)[better]
    return heights, most >= LEAST_CORRELATION


def grid(lowest, highest, side):
    """The middles of the cells of a raster: x, y, and how many columns and rows it has."""
    columns, rows = (int(numpy.ceil(length / side)) for length in highest - lowest)
    x, y = numpy.meshgrid(lowest[0] + (numpy.arange(columns) + 0.5) * side, highest[1] - (numpy.arange(rows) + 0.5) * side)
    return x, y


def heights_of(views, ground, lowest, highest, gsd):
    """The height model, of cells: that of the photographs where it is sure, else that of the points."""
    x, y = grid(lowest, highest, CELL_PX * gsd)
    start = ground.at(x, y)
    inside = numpy.isfinite(start)
    filled = numpy.where(inside, start, numpy.median(ground.points[:, 2]))
    found, is_sure = matched_heights(views, x, y, filled, gsd)
    heights = cv2.medianBlur(numpy.where(is_sure, found, filled).astype(numpy.float32), 5)
    return numpy.where(inside, heights, numpy.nan), (is_sure & inside).sum() / inside.sum()


def orthophoto_of(views, heights, lowest, highest, gsd):
    """Each pixel of the photograph whose centre is nearest in plan of those that show it; 0 where none does."""
    x, y = grid(lowest, highest, gsd)
    rows, columns = x.shape
    between = lambda k, length: numpy.clip((k + 0.5) / CELL_PX - 0.5, 0, length - 1).astype(numpy.float32)
    where = numpy.meshgrid(between(numpy.arange(columns), heights.shape[1]), between(numpy.arange(rows), heights.shape[0]))
    z = cv2.remap(heights.astype(numpy.float32), *where, cv2.INTER_LINEAR)
    is_known = numpy.isfinite(z)
    z = numpy.where(is_known, z, 0)
    picture, nearest = numpy.zeros(x.shape, numpy.uint8), numpy.full(x.shape, numpy.inf)
    for view in views:
        away = numpy.hypot(x - view.centre[0], y - view.centre[1])
        shown = view.on_ground(x, y, z)
        chosen = is_known & (shown > 0) & (away < nearest)
        picture[chosen], nearest[chosen] = shown[chosen], away[chosen]
    return picture


def written(path, values, code, corner, side, nodata):
    rows, columns = values.shape
    profile = dict(driver="GTiff", width=columns, height=rows, count=1, dtype=values.dtype, compress="DEFLATE", tiled=True, nodata=nodata)
    with rasterio.open(path, "w", **profile, crs=f"EPSG:{code}", transform=from_origin(*corner, side, side)) as file:
        file.write(values, 1)


def main(photos, out):
    photos, out = Path(photos), Path(out)
    pycolmap.logging.minloglevel = pycolmap.logging.Level.ERROR.value
    cv2.setNumThreads(2)
    names = sorted(path.name for path in photos.iterdir() if path.suffix.lower() in {".jpg", ".jpeg", ".png"})
    out.mkdir(parents=True, exist_ok=True)
    database = features(photos, out)
    camera = calibrated(database, photos, out / "calibration")
    half = oriented(database, photos, out / "half", names[::2])
    code, places = in_utm(receiver(database))
    # Near 0, where single precision holds fractions of a pixel.
    origin = numpy.round(numpy.mean(list(places.values()), 0), -2)
    levelled(half, {name: place - origin for name, place in places.items()})
    views = [View(image, camera, photos) for image in half.images.values() if image.has_pose]
    ground = Ground(half)
    gsd = (numpy.mean([view.centre[2] for view in views]) - numpy.median(ground.points[:, 2])) / camera.params[0]
    lowest, highest = ground.points[:, :2].min(0), ground.points[:, :2].max(0)
    heights, sure = heights_of(views, ground, lowest, highest, gsd)
    picture = orthophoto_of(views, heights, lowest, highest, gsd)
    corner = [origin[0] + lowest[0], origin[1] + highest[1]]
    written(out / "orthophoto.tif", picture, code, corner, gsd, 0)
    written(out / "heights.tif", (heights + origin[2]).astype(numpy.float32), code, corner, CELL_PX * gsd, numpy.nan)
    half.write(str(out / "half"))
    whole = oriented(database, photos, out / "all", start=out / "half")
    if not numpy.allclose(whole.cameras[camera.camera_id].params, camera.params):
        raise SystemExit("COLMAP has changed the camera")
    moved = [
        numpy.linalg.norm(whole.images[image.image_id].projection_center() - image.projection_center()) for image in half.images.values() if image.has_pose
    ]
    focal, _, cx, cy, k1, k2, p1, p2 = camera.params
    truth = {
        "gsd_m": gsd,
        "size_px": picture.shape[::-1],
        "half": sorted(image.name for image in half.images.values() if image.has_pose),
        "share_of_matched_heights": sure,
        "code": code,
        "half_moved_m": max(moved),
        "camera": {"focal_px": focal, "principal_point_px": [cx, cy], "radial": [k1, k2, 0], "tangential": [p1, p2]},
        "others": {
            image.name: {"position": list(image.projection_center() + origin), "rotation": image.cam_from_world().rotation.matrix().tolist()}
            for image in whole.images.values()
            if image.has_pose and image.name not in set(names[::2])
        },
    }
    (out / "truth.json").write_text(json.dumps(truth))


main(*sys.argv[1:])
