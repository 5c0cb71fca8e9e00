"""Reads the exports of examples/export_block.rs with other programs' readers: python3 tools/check_exports.py FOLDER

Needs pycolmap (pip install pycolmap). Each check names what was read; the first that fails ends with status 1.
"""

import csv
import json
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy
import pycolmap

# The simulated features have a standard deviation of 0.3 px in each coordinate: 0.42 px in length. A few wrong rays lie further off.
LARGEST_MEDIAN_ERROR_PX = 0.6


def check(right, message):
    print(("ok: " if right else "wrong: ") + message)
    if not right:
        sys.exit(1)


def model_errors(model):
    """Lengths of the differences between measured and projected positions, by COLMAP's own projection."""
    errors = []
    for image in model.images.values():
        camera = model.cameras[image.camera_id]
        for point in image.points2D:
            if point.has_point3D():
                seen = camera.img_from_cam(image.cam_from_world() * model.points3D[point.point3D_id].xyz)
                errors.append(numpy.linalg.norm(numpy.asarray(seen).ravel() - point.xy))
    return numpy.array(errors)


def check_colmap_model(folder):
    model = pycolmap.Reconstruction(str(folder / "sparse"))
    rays = sum(point.track.length() for point in model.points3D.values())
    check(model.num_images() > 0 and model.num_points3D() > 0, f"COLMAP model: {model.num_images()} images, {model.num_points3D()} points, {rays} rays")
    errors = model_errors(model)
    check(len(errors) == rays, f"COLMAP model: both files name the same {len(errors)} rays")
    median = numpy.median(errors)
    check(median < LARGEST_MEDIAN_ERROR_PX, f"COLMAP model: median reprojection error {median:.3f} px, poses and pixel origins as COLMAP has them")
    again = folder / "again"
    again.mkdir(exist_ok=True)
    model.write_text(str(again))
    check(pycolmap.Reconstruction(str(again)).num_points3D() == model.num_points3D(), "COLMAP model: written and read again")
    return model


def check_colmap_features(folder, model):
    counts = {}
    for image in model.images.values():
        lines = (folder / "features" / f"{image.name}.txt").read_text().splitlines()
        count, length = map(int, lines[0].split())
        table = numpy.loadtxt(lines[1:], ndmin=2)
        check_quietly(length == 128 and table.shape == (count, 132), f"features of {image.name}")
        check_quietly(numpy.allclose(table[:, :2], [point.xy for point in image.points2D]), f"positions in {image.name}")
        counts[image.name] = count
    print(f"ok: COLMAP features: {sum(counts.values())} of {len(counts)} images")
    pairs = 0
    for block in (folder / "matches.txt").read_text().split("\n\n"):
        if block.strip():
            names, *lines = block.strip().splitlines()
            left, right = names.split()
            matches = numpy.loadtxt(lines, dtype=int, ndmin=2)
            check_quietly(matches[:, 0].max() < counts[left] and matches[:, 1].max() < counts[right], f"matches of {names}")
            pairs += 1
    print(f"ok: COLMAP match list: {pairs} pairs")


def check_database(folder, model):
    """COLMAP's own database takes the features and the matches."""
    path = folder / "check.db"
    path.unlink(missing_ok=True)
    with pycolmap.Database.open(str(path)) as database:
        for camera in model.cameras.values():
            database.write_camera(camera, use_camera_id=True)
        for image in model.images.values():
            database.write_image(pycolmap.Image(name=image.name, camera_id=image.camera_id, image_id=image.image_id), use_image_id=True)
            table = numpy.loadtxt(folder / "features" / f"{image.name}.txt", skiprows=1, ndmin=2)
            database.write_keypoints(image.image_id, table[:, :4].astype(numpy.float32))
        ids = {image.name: image.image_id for image in model.images.values()}
        matches = 0
        for block in (folder / "matches.txt").read_text().split("\n\n"):
            if block.strip():
                names, *lines = block.strip().splitlines()
                left, right = names.split()
                table = numpy.loadtxt(lines, dtype=numpy.uint32, ndmin=2)
                database.write_matches(ids[left], ids[right], table)
                matches += len(table)
        check(database.num_matches() == matches, f"COLMAP database: {matches} matches")


def check_quietly(right, message):
    if not right:
        check(False, message)


def check_bundler(folder, model):
    words = iter((folder / "bundle.out").read_text().split("\n", 1)[1].split())
    take = lambda count: numpy.array([float(next(words)) for _ in range(count)])
    images, points = take(2).astype(int)
    cameras = [take(15) for _ in range(images)]
    errors = []
    for _ in range(points):
        xyz = take(6)[:3]
        for _ in range(int(take(1)[0])):
            camera, _, x, y = take(4)
            f, k1, k2 = cameras[int(camera)][:3]
            p = cameras[int(camera)][3:12].reshape(3, 3) @ xyz + cameras[int(camera)][12:]
            p = -p[:2] / p[2]
            r2 = p @ p
            errors.append(numpy.linalg.norm(f * (1 + k1 * r2 + k2 * r2 * r2) * p - [x, y]))
    check(points == model.num_points3D() and numpy.median(errors) < LARGEST_MEDIAN_ERROR_PX, f"Bundler: median error {numpy.median(errors):.3f} px by the manual's formula")


def check_nvm(folder, model):
    lines = (folder / "block.nvm").read_text().splitlines()
    images = int(lines[2])
    cameras = [numpy.array(line.split()[1:], dtype=float) for line in lines[3 : 3 + images]]
    errors = []
    for line in lines[5 + images :]:
        values = line.split()
        if len(values) < 8:
            break
        xyz = numpy.array(values[:3], dtype=float)
        for ray in numpy.array(values[7:], dtype=float).reshape(-1, 4):
            f, w, x, y, z = cameras[int(ray[0])][:5]
            p = pycolmap.Rotation3d([x, y, z, w]).matrix() @ (xyz - cameras[int(ray[0])][5:8])
            errors.append(numpy.linalg.norm(f * p[:2] / p[2] - ray[2:]))
    check(numpy.median(errors) < LARGEST_MEDIAN_ERROR_PX, f"NVM: median error {numpy.median(errors):.3f} px of {len(errors)} rays")


def main():
    folder = Path(sys.argv[1])
    model = check_colmap_model(folder / "colmap")
    check_colmap_features(folder / "colmap", model)
    check_database(folder / "colmap", model)
    check_bundler(folder / "bundler", model)
    check_nvm(folder / "nvm", model)
    rays = sum(point.track.length() for point in model.points3D.values())
    tracks = list(csv.reader(open(folder / "opensfm" / "tracks.csv"), delimiter="\t"))
    check(len(tracks) - 1 == rays and all(len(row) == 11 for row in tracks[1:]), f"OpenSfM tracks: {rays} rays of 11 fields")
    xml = ElementTree.parse(folder / "agisoft" / "markers.xml")
    check(len(xml.findall(".//location")) == rays, "Agisoft markers: well formed, all rays there")
    geojson = json.load(open(folder / "geojson" / "block.geojson"))
    check(len(geojson["features"]) == model.num_images() + model.num_points3D(), "GeoJSON: all images and points there")
    block = json.load(open(folder / "json" / "block.json"))
    check(sum(len(point["rays"]) for point in block["points"]) == rays, "JSON: all rays there")
    table = list(csv.DictReader(open(folder / "csv" / "rays.csv")))
    check(len(table) == rays, "CSV: all rays there")


main()
