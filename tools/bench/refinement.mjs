/** Least squares refinement of a block's rays: residuals, and true errors of rays, points and cameras, beside the same block without it. */

import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { spawnSync } from 'node:child_process';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { BlockScene, FinishedBlock, score_block } from '../../pkg/node.js';
import { DATA, readJson, ROOT } from '../lib/paths.mjs';
import { have } from './data.mjs';

/**
 * @typedef {import('../../pkg/node.js').BlockModel} BlockModel
 * @typedef {BlockModel['points'][number]['rays'][number] & { outcome: string }} ToldRay
 * @typedef {[number, number, number]} Three
 * @typedef {{ file: string, width: number, height: number, reference: { K: [number, number, number, number], R_cw: [Three, Three, Three], C: Three } }} Known
 * @typedef {{ summary: any, model: BlockModel, rays: ToldRay[][], seconds: number }} Run
 */

const METHODS = ['none', 'least-squares'];

/** A ray further than this from where it should be shows another surface: the background of a corner. */
const SAME_SURFACE_PX = 1.5;

/** Simulated flights.  @type {[string, string[]][]} */
const FLIGHTS = [
  ['nadir 3 x 4', ['--strips', '3', '--exposures', '4']],
  ['two heights 3 x 4', ['--view', 'two-heights', '--strips', '3', '--exposures', '4']],
];
const SIZE = ['--width-px', '1000', '--height-px', '750', '--pixel-mm', '0.058', '--workers', '2'];

export function refinementBench() {
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-refinement-'));
  try {
    console.log('Refinement of rays by least squares matching to a reference ray (before: none, after: least-squares)');
    if (have('block_caliterra')) photographs(folder);
    for (const [name, options] of FLIGHTS) simulated(folder, name, options);
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

/** @param {string} folder */
function photographs(folder) {
  const name = 'block_caliterra';
  const truth = referenceOf(readJson(join(DATA, name, 'truth.json')));
  for (const method of METHODS) {
    const run = block(folder, name, method, [join(DATA, name)]);
    const { position_rmse_m: centres, angle_rmse_deg: angles } = score_block(run.model, truth);
    console.log(`${name}, ${method}: ${figures(run)}; against the reference: centres ${listed(centres, 3)} m, angles ${angles?.toFixed(3)} deg`);
  }
}

/** The independent reference as a block; only its poses count.  @param {any} truth @returns {BlockModel} */
function referenceOf({ images }) {
  /** @type {Known[]} */
  const known = images.filter((/** @type {any} */ image) => image.reference);
  /** @param {Known} image @returns {BlockModel['cameras'][number]} */
  const camera = ({
    width,
    height,
    reference: {
      K: [focal, , x, y],
    },
  }) => ({
    width_px: width,
    height_px: height,
    focal_px: focal,
    principal_point_px: [x + 0.5, y + 0.5],
    radial: [0, 0, 0],
    tangential: [0, 0],
    pixel_mm: null,
  });
  // Its cameras look along +z with y down.
  const turned = (/** @type {Three} */ [x, y, z]) => /** @type {Three} */ ([-x, -y, -z]);
  /** @param {Known} image @returns {NonNullable<BlockModel['images'][number]['pose']>} */
  const pose = ({
    reference: {
      R_cw: [right, down, ahead],
      C,
    },
  }) => ({ rotation: [right, turned(down), turned(ahead)], position: C });
  return {
    cameras: known.map(camera),
    images: known.map((image, index) => ({ name: image.file, camera: index, pose: pose(image) })),
    points: [],
    origin: null,
  };
}

/** @param {string} folder @param {string} name @param {string[]} options */
function simulated(folder, name, options) {
  const own = join(folder, name.replaceAll(' ', '-'));
  call('simulate', '--block', '--out', own, ...SIZE, ...options);
  const { flight, block: truth } = readJson(join(own, 'truth.json'));
  // Cameras that are known: what the calibration of a small flat block adds would hide what the rays do.
  const cameras = join(own, 'cameras.json');
  writeFileSync(cameras, JSON.stringify({ cameras: [{ images: '*', focal_px: truth.cameras[0].focal_px, fixed: true }] }));
  const scene = new BlockScene(flight);
  for (const method of METHODS) {
    const run = block(own, name, method, [join(own, 'photos'), '--cameras', cameras, '--truth', join(own, 'truth.json')]);
    const { position_rmse_m: centres, angle_rmse_deg: angles, right_rmse_px: meet, points, right_points: right } = run.summary.score;
    const { ray, count, strangers, place } = trueErrors(scene, truth, run);
    console.log(
      `${name}, ${method}: ${figures(run)}; by the truth: ${right} of ${points} points right, their rays meet within ${meet.toFixed(4)} px; half of the rays are within ${ray.toFixed(4)} px ` +
        `of where the surface at the reference ray is seen (${count} rays, ${strangers} further than ${SAME_SURFACE_PX} px), half of the points, intersected by true orientations, within ${place.toFixed(4)} m of it; centres ${listed(centres, 4)} m, angles ${angles.toFixed(4)} deg`,
    );
  }
  scene.free();
}

/** @param {string} folder @param {string} name @param {string} method @param {string[]} args @returns {Run} */
function block(folder, name, method, args) {
  const out = join(folder, `${name.replaceAll(' ', '-')}-${method}`);
  const began = performance.now();
  call('block', ...args, '--out', out, '--refine', method, '--workers', '2');
  const seconds = (performance.now() - began) / 1000;
  const model = FinishedBlock.open(readFileSync(join(out, 'project.tiepoint'))).model();
  const [header = '', ...lines] = readFileSync(join(out, 'rays.csv'), 'utf8').trimEnd().split('\n');
  const column = header.split(',').indexOf('refinement');
  const outcomes = lines.map((line) => (column < 0 ? '' : (line.split(',')[column] ?? '')));
  let next = 0;
  const rays = model.points.map((point) => point.rays.map((ray) => ({ ...ray, outcome: outcomes[next++] ?? '' })));
  return { summary: readJson(join(out, 'summary.json')), model, rays, seconds };
}

/** @param {string[]} args */
function call(...args) {
  const { status, stderr } = spawnSync(process.execPath, [join(ROOT, 'pkg', 'bin', 'tiepoint.js'), ...args], { encoding: 'utf8', maxBuffer: 1 << 28 });
  if (status !== 0) throw new Error(`tiepoint ${args.join(' ')}: ${stderr}`);
}

/** @param {Run} run */
function figures({ summary: { refinement, orientation, images } }) {
  const [model] = orientation.models ?? [];
  const told = refinement
    ? `${refinement.refined} of ${refinement.rays - refinement.references} rays refined (kept: ${Object.entries(refinement.kept)
        .map(([why, count]) => `${count} ${why}`)
        .join(', ')}); `
    : '';
  return `${told}${orientation.oriented} of ${images.read} oriented, ${orientation.points} points, ${orientation.rays} rays, RMSE ${model.rmse_px.toFixed(4)} px, sigma0 ${model.sigma0_px.toFixed(4)} px`;
}

/** How far rays are from where their surface is seen, and points intersected by true orientations from it.  @param {BlockScene} scene @param {BlockModel} truth @param {Run} run */
function trueErrors(scene, truth, { model, rays }) {
  const known = new Map(truth.images.map((image, index) => [image.name, index]));
  const indices = model.images.map(({ name }) => known.get(name) ?? -1);
  const surfaces = surfacesOf(scene, indices, rays);
  /** @type {number[]} */
  const ofRays = [];
  /** @type {number[]} */
  const ofPoints = [];
  rays.forEach((own, point) => {
    const place = /** @type {number[]} */ (surfaces[point]);
    const reference = referenceRay(own);
    const views = own.map((ray) => ({ image: indices[ray.image] ?? -1, at: [ray.x_px, ray.y_px] }));
    own.forEach((ray, i) => {
      if (ray === reference) return;
      const [x, y] = project(truth, views[i]?.image ?? -1, place);
      ofRays.push(Math.hypot(ray.x_px - x, ray.y_px - y));
    });
    ofPoints.push(Math.hypot(...intersect(truth, views).map((value, axis) => value - (place[axis] ?? 0))));
  });
  return { ray: median(ofRays), count: ofRays.length, strangers: ofRays.filter((error) => error > SAME_SURFACE_PX).length, place: median(ofPoints) };
}

/** @param {number[]} values */
const median = (values) => values.toSorted((a, b) => a - b)[Math.floor(values.length / 2)] ?? NaN;

/** Without a refinement the first ray stands for the reference.  @param {ToldRay[]} rays @returns {ToldRay} */
const referenceRay = (rays) => /** @type {ToldRay} */ (rays.find(({ outcome }) => outcome === 'reference') ?? rays[0]);

/** The surface at the reference ray of each point.  @param {BlockScene} scene @param {number[]} indices @param {ToldRay[][]} rays */
function surfacesOf(scene, indices, rays) {
  /** @type {number[][]} */
  const surfaces = rays.map(() => []);
  indices.forEach((photo, image) => {
    const own = rays.flatMap((of, point) => (referenceRay(of).image === image ? [point] : []));
    const at = own.flatMap((point) => {
      const { x_px: x, y_px: y } = referenceRay(rays[point] ?? []);
      return [x, y];
    });
    const places = scene.surface_at(photo, Float64Array.from(at));
    own.forEach((point, i) => {
      surfaces[point] = Array.from(places.subarray(3 * i, 3 * i + 3));
    });
  });
  return surfaces;
}

/** @param {BlockModel} truth @param {number} index */
function viewOf(truth, index) {
  const image = truth.images[index];
  const camera = truth.cameras[image?.camera ?? -1];
  if (!image?.pose || !camera) throw new Error(`the truth has no image ${index}`);
  return { m: image.pose.rotation, centre: image.pose.position, focal: camera.focal_px, middle: camera.principal_point_px };
}

/** @param {BlockModel} truth @param {number} index @param {number[]} place @returns {[number, number]} */
function project(truth, index, place) {
  const { m, centre, focal, middle } = viewOf(truth, index);
  const from = centre.map((v, axis) => (place[axis] ?? 0) - v);
  const [x, y, z] = m.map((row) => row.reduce((sum, v, axis) => sum + v * (from[axis] ?? 0), 0));
  return [middle[0] - (focal * (x ?? 0)) / (z ?? 1), middle[1] + (focal * (y ?? 0)) / (z ?? 1)];
}

/** The place nearest to all rays, by Cramer's rule.  @param {BlockModel} truth @param {{ image: number, at: number[] }[]} rays @returns {number[]} */
function intersect(truth, rays) {
  const n = [
    [0, 0, 0],
    [0, 0, 0],
    [0, 0, 0],
  ];
  const b = [0, 0, 0];
  for (const {
    image,
    at: [x = 0, y = 0],
  } of rays) {
    const { m, centre, focal, middle } = viewOf(truth, image);
    const photo = [x - middle[0], middle[1] - y, -focal];
    const along = [0, 1, 2].map((axis) => m.reduce((sum, row, r) => sum + (row[axis] ?? 0) * (photo[r] ?? 0), 0));
    const square = along.reduce((sum, v) => sum + v * v, 0);
    for (let i = 0; i < 3; i++) {
      for (let j = 0; j < 3; j++) {
        const across = (i === j ? 1 : 0) - ((along[i] ?? 0) * (along[j] ?? 0)) / square;
        /** @type {number[]} */ (n[i])[j] = (n[i]?.[j] ?? 0) + across;
        b[i] = (b[i] ?? 0) + across * (centre[j] ?? 0);
      }
    }
  }
  const whole = determinant(n);
  return [0, 1, 2].map((column) => determinant(n.map((row, r) => row.map((v, c) => (c === column ? (b[r] ?? 0) : v)))) / whole);
}

/** @param {number[][]} m */
function determinant([[a = 0, b = 0, c = 0] = [], [d = 0, e = 0, f = 0] = [], [g = 0, h = 0, i = 0] = []]) {
  return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
}

/** @param {readonly number[] | null | undefined} values @param {number} digits */
const listed = (values, digits) => values?.map((v) => v.toFixed(digits)).join(' ') ?? '–';
