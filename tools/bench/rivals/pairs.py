"""OpenCV on pairs of images: python3 pairs.py JOBS RESULTS

SIFT with as many points as ours at most, ratio test, mutual nearest neighbours, then the essential matrix by USAC_MAGSAC within 1 px, for each of the
pairs of cameras that a job names. JOBS: [{left, right, cameras: [[of left, of right], ...]}, ...]; a camera is {affine, radial}: the affine map from
px (centre of the top-left pixel at (0.5, 0.5)) to the picture at a distance of 1 (x right, y down), and k1, k2 there.
RESULTS: for each job and pair of cameras {matches, rotation, direction}. Needs opencv-python-headless.
"""

import functools
import json
import sys

import cv2
import numpy

FEATURES = 10_000
RATIO = 0.8
WITHIN_PX = 1.0


@functools.cache
def described(path):
    image = cv2.imread(path, cv2.IMREAD_GRAYSCALE | cv2.IMREAD_IGNORE_ORIENTATION)
    points, descriptors = cv2.SIFT_create(FEATURES).detectAndCompute(image, None)
    return numpy.array([point.pt for point in points], float).reshape(-1, 2) + 0.5, descriptors


@functools.cache
def matched(left, right):
    (own, own_bytes), (other, other_bytes) = described(left), described(right)
    if own_bytes is None or other_bytes is None or min(len(own), len(other)) < 2:
        return numpy.empty((0, 4))
    matcher = cv2.BFMatcher(cv2.NORM_L2)
    nearest = [first for first, second in matcher.knnMatch(own_bytes, other_bytes, 2) if first.distance < RATIO * second.distance]
    back = {match.queryIdx: match.trainIdx for match in matcher.match(other_bytes, own_bytes)}
    mutual = [match for match in nearest if back[match.trainIdx] == match.queryIdx]
    return numpy.array([(*own[match.queryIdx], *other[match.trainIdx]) for match in mutual]).reshape(-1, 4)


def ideal(points, camera):
    affine, (k1, k2) = numpy.array(camera["affine"]), camera["radial"]
    distorted = points @ affine[:, :2].T + affine[:, 2]
    found = distorted.copy()
    for _ in range(10):
        square = (found * found).sum(1, keepdims=True)
        found = distorted / (1 + k1 * square + k2 * square * square)
    return found


def oriented(matches, cameras):
    nothing = {"matches": matches.tolist(), "rotation": None, "direction": None}
    if len(matches) < 8:
        return nothing
    left, right = ideal(matches[:, :2], cameras[0]), ideal(matches[:, 2:], cameras[1])
    pixel = abs(numpy.linalg.det(numpy.array(cameras[0]["affine"])[:, :2])) ** 0.5
    essential, mask = cv2.findEssentialMat(left, right, numpy.eye(3), cv2.USAC_MAGSAC, 0.9999, WITHIN_PX * pixel)
    if essential is None or essential.shape != (3, 3):
        return nothing
    kept = mask.ravel() > 0
    _, rotation, direction, _ = cv2.recoverPose(essential, left[kept], right[kept], numpy.eye(3))
    return {"matches": matches[kept].tolist(), "rotation": rotation.tolist(), "direction": direction.ravel().tolist()}


def main(jobs, results):
    cv2.setRNGSeed(1)
    with open(jobs, encoding="utf8") as file:
        wanted = json.load(file)
    found = [[oriented(matched(job["left"], job["right"]), cameras) for cameras in job["cameras"]] for job in wanted]
    with open(results, "w", encoding="utf8") as file:
        json.dump(found, file)


main(*sys.argv[1:])
