"""How fast and how equal the bundle adjustment is beside Ceres, as pycolmap has it: the same simulated block, one thread each.

    python3 -m venv venv && venv/bin/pip install pycolmap
    cargo build --release --example adjustment
    venv/bin/python tools/bench/adjustment.py [small|medium|large|huge …]

Both start from the same approximate values and minimise the same squares. pycolmap holds two camera centres where a free network has inner
constraints: residuals are compared, and positions after a similarity.
"""

import json
import re
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pycolmap

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = ROOT / 'target/release/examples/adjustment'

BLOCKS = {
    'small': dict(strips=5, stations=6, points_per_image=400),
    'calibrated': dict(strips=5, stations=6, points_per_image=400, kind='two_heights', radial=[-0.05, 0.02, 0.0]),
    'oblique': dict(kind='oblique', strips=6, stations=8, points_per_image=60),
    'medium': dict(strips=10, stations=20, points_per_image=120),
    'large': dict(strips=25, stations=40, points_per_image=60),
    'huge': dict(strips=50, stations=100, points_per_image=40),
}
# Without the focal length: nadir views alone do not determine it, so that it would be fixed here and not there.
CALIBRATED = {'focal': False, 'principal_point': False, 'radial': 2, 'tangential': True}


def ours(block: Path, options: dict, result: Path) -> dict:
    """The figures of our own adjustment."""
    with tempfile.NamedTemporaryFile('w', suffix='.json') as file:
        json.dump(options, file)
        file.flush()
        done = subprocess.run([PROGRAM, 'adjust', block, file.name, result], check=True, capture_output=True, text=True)
    return json.loads(done.stdout)


def reconstruction(block: dict) -> pycolmap.Reconstruction:
    """The block as a COLMAP model; y and z of the photo's system are turned over."""
    model = pycolmap.Reconstruction()
    for index, camera in enumerate(block['cameras']):
        cx, cy = camera['principal_point_px']
        params = [camera['focal_px'], camera['focal_px'], cx, cy, *camera['radial'][:2], *camera['tangential']]
        width, height = 4000, 3000
        model.add_camera_with_trivial_rig(pycolmap.Camera(camera_id=index + 1, model='OPENCV', width=width, height=height, params=params))
    seen = [[] for _ in block['images']]
    for ray in block['rays']:
        seen[ray['image']].append(ray)
    turned = np.diag([1.0, -1.0, -1.0])
    for index, image in enumerate(block['images']):
        rotation = turned @ np.array(image['pose']['rotation'])
        pose = pycolmap.Rigid3d(pycolmap.Rotation3d(rotation), -rotation @ np.array(image['pose']['position']))
        points = [np.array([ray['x_px'], ray['y_px']]) for ray in seen[index]]
        added = pycolmap.Image(name=f'{index}', keypoints=np.array(points).reshape(-1, 2), camera_id=image['camera'] + 1, image_id=index + 1)
        model.add_image_with_trivial_frame(added, pose)
    tracks = [pycolmap.Track() for _ in block['points']]
    for index, rays in enumerate(seen):
        for place, ray in enumerate(rays):
            tracks[ray['point']].add_element(index + 1, place)
    for point, track in zip(block['points'], tracks):
        model.add_point3D(np.array(point), track, np.zeros(3, np.uint8))
    return model


def colmap(block: dict) -> dict:
    """The figures of Ceres on one thread."""
    model = reconstruction(block)
    options = pycolmap.BundleAdjustmentOptions()
    options.refine_focal_length = False
    options.refine_extra_params = any(camera['free']['tangential'] for camera in block['cameras'])
    options.refine_principal_point = False
    options.print_summary = False
    options.ceres.solver_options.num_threads = 1
    options.ceres.solver_options.function_tolerance = 1e-9
    config = pycolmap.BundleAdjustmentConfig()
    for image in range(1, len(block['images']) + 1):
        config.add_image(image)
    config.fix_gauge(pycolmap.BundleAdjustmentGauge.TWO_CAMS_FROM_WORLD)
    adjuster = pycolmap.create_default_bundle_adjuster(options, config, model)
    start = time.perf_counter()
    summary = adjuster.solve()
    seconds = time.perf_counter() - start
    report = summary.ceres_summary.BriefReport() if hasattr(summary, 'ceres_summary') else summary.brief_report()
    iterations = int(re.search(r'Iterations: (\d+)', report)[1])
    end = report.split('Termination: ')[-1]
    return {'seconds': seconds, 'iterations': iterations, 'rmse_px': rmse(model, block), 'end': end, 'model': model}


def rmse(model: pycolmap.Reconstruction, block: dict) -> float:
    """Root mean square length of the residuals of all rays in px."""
    squares = 0.0
    for image in model.images.values():
        for point in image.points2D:
            squares += float(np.sum((image.project_point(model.points3D[point.point3D_id].xyz) - point.xy) ** 2))
    return float(np.sqrt(squares / len(block['rays'])))


def similar(model: pycolmap.Reconstruction, block: dict) -> float:
    """Largest distance in m of the image positions of two models after the best similarity of one onto the other (Umeyama 1991)."""
    theirs = np.array([model.images[k + 1].projection_center() for k in range(len(block['images']))])
    own = np.array([image['pose']['position'] for image in block['images']])
    a, b = theirs - theirs.mean(axis=0), own - own.mean(axis=0)
    u, s, vt = np.linalg.svd(b.T @ a)
    signs = np.array([1.0, 1.0, np.sign(np.linalg.det(u @ vt))])
    rotation = u @ np.diag(signs) @ vt
    scale = float((s * signs).sum() / (a**2).sum())
    return float(np.linalg.norm(scale * a @ rotation.T - b, axis=1).max())


def compare(name: str) -> None:
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        (place / 'flight.json').write_text(json.dumps({**BLOCKS[name], 'approximate_m': 0.5}))
        subprocess.run([PROGRAM, 'simulate', place / 'flight.json', place / 'block.json', place / 'truth.json'], check=True)
        block = json.loads((place / 'block.json').read_text())
        if name == 'calibrated':
            for camera in block['cameras']:
                camera.update(free=CALIBRATED, radial=[0.0, 0.0, 0.0])
            (place / 'block.json').write_text(json.dumps(block))
        images, rays = len(block['images']), len(block['rays'])
        print(f"{name}: {images} images, {len(block['points'])} points, {rays} rays")
        plain = {'loss': 'squares', 'snooping': False, 'statistics': False}
        runs = 1 if images > 500 else 5
        own = best(runs, lambda: ours(place / 'block.json', plain, place / 'result.json'))
        whole = best(runs, lambda: ours(place / 'block.json', {**plain, 'statistics': True}, place / 'result.json'))
        print(
            f"  tiepoint: {own['seconds']:.3f} s in {own['iterations']} iterations, RMSE {own['rmse_px']:.6f} px; "
            f"with all statistics {whole['seconds']:.3f} s"
        )
        if name == 'huge':
            return  # Ceres is not done within five minutes.
        other = best(runs, lambda: colmap(block))
        result = json.loads((place / 'result.json').read_text())
        print(
            f"  Ceres in pycolmap {pycolmap.__version__}: {other['seconds']:.3f} s in {other['iterations']} iterations, "
            f"RMSE {other['rmse_px']:.6f} px, {other['end']}"
        )
        each = own['seconds'] / own['iterations'] / (other['seconds'] / other['iterations'])
        print(f"  tiepoint by Ceres: {own['seconds'] / other['seconds']:.2f} of the time, {each:.2f} of that of an iteration")
        print(f"  image positions differ by {1000 * similar(other['model'], result):.3f} mm at most")


def best(runs: int, action: Callable[[], dict]) -> dict:
    """The quickest of some runs."""
    return min((action() for _ in range(runs)), key=lambda figures: figures['seconds'])


if __name__ == '__main__':
    for name in sys.argv[1:] or ['small', 'calibrated', 'oblique', 'medium', 'large']:
        compare(name)
