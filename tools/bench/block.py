"""A block of photographs beside COLMAP, as pycolmap has it: the same images, two threads each, from the files to the adjusted block.

    python3 -m venv venv && venv/bin/pip install pycolmap
    venv/bin/python tools/bench/block.py [FOLDER] [--threads N] [--runs N] [--json]

FOLDER holds the photographs; by default the block among the test images. Ours is the `tiepoint block` command: its start, the reading and writing
of all files are within its time. COLMAP runs with its own defaults. Where FOLDER has a truth.json with a reference solution, the camera
centres of both are compared with it after a similarity. With --json the last line is one object: seconds, stages and results of both.
"""

import argparse
import json
import re
import resource
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np
import pycolmap

ROOT = Path(__file__).resolve().parents[2]
IMAGES = {'.jpg', '.jpeg', '.png', '.tif', '.tiff'}


def processor(who: int) -> float:
    """Seconds of all processors spent so far."""
    used = resource.getrusage(who)
    return used.ru_utime + used.ru_stime


def ours(photos: list[Path], out: Path, threads: int) -> tuple[float, dict[str, float], dict, dict[str, np.ndarray]]:
    """Seconds, those of each stage, summary and camera centres of our command."""
    started = time.perf_counter()
    command = ['node', str(ROOT / 'pkg/bin/tiepoint.js'), 'block', *map(str, photos), '--out', str(out), '--workers', str(threads)]
    ended = subprocess.run([*command, '--export', 'colmap'], capture_output=True, text=True, check=True)
    seconds = time.perf_counter() - started
    model = pycolmap.Reconstruction(str(next(out.rglob('cameras.txt')).parent))
    stages = {stage: float(took) for stage, took in re.findall(r'^([a-z ]+?)(?:: \d+.*)? in ([\d.]+) s$', ended.stderr, re.M)}
    return seconds, stages, json.loads((out / 'summary.json').read_text()), centres_of(model)


def theirs(photos: list[Path], folder: Path, threads: int) -> tuple[float, pycolmap.Reconstruction]:
    """Seconds and the largest model of COLMAP."""
    images = folder / 'images'
    images.mkdir()
    for photo in photos:
        (images / photo.name).symlink_to(photo)
    database = folder / 'database.db'
    started = time.perf_counter()
    extraction = pycolmap.FeatureExtractionOptions()
    matching = pycolmap.FeatureMatchingOptions()
    mapping = pycolmap.IncrementalPipelineOptions()
    for options in (extraction, matching, mapping):
        options.num_threads = threads
    pycolmap.extract_features(database, images, camera_mode=pycolmap.CameraMode.SINGLE, extraction_options=extraction)
    pycolmap.match_exhaustive(database, matching_options=matching)
    models = pycolmap.incremental_mapping(database, images, folder / 'models', options=mapping)
    seconds = time.perf_counter() - started
    return seconds, max(models.values(), key=lambda model: model.num_reg_images())


def centres_of(model: pycolmap.Reconstruction) -> dict[str, np.ndarray]:
    return {image.name: image.projection_center() for image in model.images.values() if image.has_pose}


def reference_of(folder: Path) -> dict[str, np.ndarray]:
    """Camera centres of the reference solution; empty where there is none."""
    file = folder / 'truth.json'
    if not file.exists():
        return {}
    centres = {}
    for image in json.loads(file.read_text()).get('images', []):
        reference = image.get('reference', image)
        if 'C' in reference:
            centres[image['file']] = np.array(reference['C'], float)
        elif 'R_cw' in reference and 't' in reference:
            centres[image['file']] = -np.array(reference['R_cw']).T @ np.array(reference['t'])
    return centres


def deviation(own: dict[str, np.ndarray], reference: dict[str, np.ndarray]) -> str:
    """Root mean square distance of the centres after a similarity, as a share of the block's extent."""
    names = sorted(set(own) & set(reference))
    if len(names) < 4:
        return 'no reference'
    a, b = (np.array([centres[name] for name in names]) for centres in (own, reference))
    a0, b0 = a - a.mean(0), b - b.mean(0)
    u, s, vt = np.linalg.svd(b0.T @ a0)
    flip = np.diag([1, 1, np.sign(np.linalg.det(u @ vt))])
    turned = a0 @ (u @ flip @ vt).T * ((s * np.diag(flip)).sum() / (a0**2).sum())
    extent = np.sqrt((b0**2).sum(1).mean())
    return f'{100 * np.sqrt(((turned - b0) ** 2).sum(1).mean()) / extent:.2f} % of the extent'


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument('folder', nargs='?', type=Path, default=ROOT / '../shared/data/block_caliterra')
    parser.add_argument('--threads', type=int, default=2)
    parser.add_argument('--runs', type=int, default=3)
    parser.add_argument('--json', action='store_true')
    given = parser.parse_args()
    folder = given.folder.resolve()
    if not folder.is_dir():
        print(f'skipped: {folder} is absent')
        return
    photos = sorted(path for path in folder.iterdir() if path.suffix.lower() in IMAGES)
    reference = reference_of(folder)
    ratios = []
    for _ in range(given.runs):
        with tempfile.TemporaryDirectory() as temporary:
            before = processor(resource.RUSAGE_CHILDREN)
            own_seconds, stages, summary, own = ours(photos, Path(temporary) / 'ours', given.threads)
            own_cpu = processor(resource.RUSAGE_CHILDREN) - before
            before = processor(resource.RUSAGE_SELF)
            their_seconds, model = theirs(photos, Path(temporary), given.threads)
            their_cpu = processor(resource.RUSAGE_SELF) - before
        ratios.append(own_seconds / their_seconds)
        print(f'tiepoint {own_seconds:.1f} s {stages}, COLMAP {their_seconds:.1f} s, ratio {ratios[-1]:.3f}; processor {own_cpu:.1f} s, {their_cpu:.1f} s, ratio {own_cpu / their_cpu:.3f}')
    print(f'median ratio {statistics.median(ratios):.3f} of {given.runs} runs, {len(photos)} images, {given.threads} threads')
    found = summary.get('points', {})
    print(f"tiepoint: {found.get('found')} points, {found.get('rays')} rays; images that show a point: {json.dumps(found.get('with_rays'))}")
    print('tiepoint:', json.dumps(summary.get('orientation', summary)))
    print(f'  centres beside the reference: {deviation(own, reference)}')
    error, rays = model.compute_mean_reprojection_error(), model.compute_num_observations()
    print(f'COLMAP: {model.num_reg_images()} images, {model.num_points3D()} points, {rays} rays, mean residual {error:.3f} px')
    print(f'  centres beside the reference: {deviation(centres_of(model), reference)}')
    if given.json:
        orientation = summary['orientation']
        rmse = orientation['models'][0]['rmse_px'] if orientation.get('models') else float('nan')
        command = {'seconds': own_seconds, 'cpu': own_cpu, 'stages': stages, 'oriented': orientation['oriented'], 'rmsePx': rmse, 'centres': deviation(own, reference)}
        colmap = {'seconds': their_seconds, 'cpu': their_cpu, 'version': pycolmap.__version__, 'oriented': model.num_reg_images(), 'residual_px': error, 'centres': deviation(centres_of(model), reference)}
        print(json.dumps({'command': command, 'colmap': colmap}))


if __name__ == '__main__':
    main()
