"""OpenCV on a large orthophoto: python3 orthophoto.py ORTHOPHOTO HEIGHTS PHOTO TRUTH

SIFT of the overview and of the photograph, ratio test, then resection by consensus (`solvePnPRansac`, SQPnP) with the true focal length, which it cannot estimate.
Prints one line. Needs opencv-python-headless and rasterio.
"""

import json
import sys
import time

import cv2
import numpy
import rasterio

LONGEST_PX = 2500
FEATURES = (10_000, 40_000)
RATIO = 0.8
REPROJECTION_PX = 8.0


def main(orthophoto, heights, photo, truth):
    cv2.setNumThreads(2)
    with open(truth, encoding="utf8") as file:
        block = json.load(file)["block"]
    name = photo.rsplit("/", 1)[-1]
    image = next(image for image in block["images"] if image["name"] == name)
    camera = block["cameras"][image["camera"]]
    picture = cv2.imread(photo, cv2.IMREAD_GRAYSCALE)
    started = time.perf_counter()
    with rasterio.open(orthophoto) as file:
        factor = max(1, -(-max(file.width, file.height) // LONGEST_PX))
        bands = file.read(out_shape=(file.count, file.height // factor, file.width // factor))
        place = file.transform
    ground = cv2.cvtColor(numpy.moveaxis(bands, 0, 2), cv2.COLOR_RGB2GRAY)
    (own, own_bytes), (other, other_bytes) = (
        cv2.SIFT_create(number).detectAndCompute(of, None) for number, of in zip(FEATURES, (picture, ground))
    )
    pairs = cv2.FlannBasedMatcher(dict(algorithm=1, trees=4), dict(checks=64)).knnMatch(own_bytes, other_bytes, k=2)
    matches = [first for first, second in pairs if first.distance < RATIO * second.distance]
    with rasterio.open(heights) as file:
        model, model_place = file.read(1), ~file.transform
    seen, places = [], []
    for match in matches:
        x, y = place @ (numpy.array(other[match.trainIdx].pt) * factor + 0.5 * factor)
        column, row = (int(v) for v in model_place @ (x, y))
        if 0 <= row < model.shape[0] and 0 <= column < model.shape[1] and numpy.isfinite(model[row, column]):
            seen.append(own[match.queryIdx].pt)
            places.append((x, y, model[row, column]))
    if len(seen) < 6:
        return print(f"OpenCV: not placed, {len(seen)} of {len(matches)} matches on the heights")
    focal = camera["focal_px"]
    cx, cy = camera["principal_point_px"]
    matrix = numpy.array([[focal, 0, cx - 0.5], [0, focal, cy - 0.5], [0, 0, 1]])
    found, turned, shifted, inliers = cv2.solvePnPRansac(
        numpy.array(places), numpy.array(seen), matrix, None, reprojectionError=REPROJECTION_PX, iterationsCount=100_000, flags=cv2.SOLVEPNP_SQPNP
    )
    taken = time.perf_counter() - started
    if not found or inliers is None:
        return print(f"OpenCV: not placed, of {len(matches)} matches, in {taken:.1f} s")
    turn, _ = cv2.Rodrigues(turned)
    error = numpy.linalg.norm((-turn.T @ shifted).ravel() - numpy.array(image["pose"]["position"]))
    print(f"OpenCV (SIFT, two threads, true focal length): {len(inliers)} of {len(matches)} matches agree, projection centre off by {error:.2f} m, in {taken:.1f} s")


main(*sys.argv[1:])
