/** The test images with truth, as the bench reads them. They are no part of the project; without them their figures are skipped. */

import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { DATA, readJson } from '../lib/paths.mjs';
import { Photo } from '../../pkg/node.js';

/** @typedef {import('../score.mjs').Pinhole} Pinhole */
/**
 * @typedef {{ rotation: number[][], direction: number[], uncertain?: { rotation_deg: number, direction_deg: number } }} TruePose
 *   X_right = R X_left + t, camera x right, y down, z forward; uncertain: by how much the truth itself may be off
 * @typedef {{ folder: string, a: string, b: string, truth: any, pose: TruePose }} PosedPair truth: of all images of the folder
 */

/** What the test images say of references that are themselves reconstructions of flat blocks. */
export const OF_REFERENCE = { rotation_deg: 1, direction_deg: 3 };

/** @param {string} name @returns {boolean} whether a folder of test images is there; says so if not */
export function have(name) {
  if (existsSync(join(DATA, name, 'truth.json'))) return true;
  console.log(`${name}: skipped, its folder is not among the test images (TIEPOINT_DATA names their place)`);
  return false;
}

/** @param {string} name @param {string} file @returns {Buffer} */
export const bytesOf = (name, file) => readFileSync(join(DATA, name, file));

/** @param {string} name @param {string} file @returns {Photo} */
export const photoOf = (name, file) => Photo.decode(bytesOf(name, file));

/** The simulated pair: settings, marks and truth.  Its own convention has pixel centres at whole numbers. */
export function simulated() {
  const name = 'simulated-a';
  const truth = readJson(join(DATA, name, 'truth.json'));
  const geometry = (/** @type {'left' | 'right'} */ side) => ({
    fiducials: truth[side].fiducials_scan_px_measured.map((/** @type {number[]} */ [col = 0, row = 0], /** @type {number} */ i) => {
      const [x_mm, y_mm] = truth[side].fiducials_mm[i];
      return { col: col + 0.5, row: row + 0.5, x_mm, y_mm };
    }),
    origin: truth[side].patch_origin_col_row,
  });
  return {
    left: photoOf(name, 'left.png'),
    right: photoOf(name, 'right.png'),
    camera: { focal_mm: truth.f_mm, principal_point_mm: [0, 0] },
    base_mm: truth.b_mm,
    input: { camera: { focal_mm: truth.f_mm }, left: geometry('left'), right: geometry('right') },
    truth: truth.relative_orientation,
    map: denseMap(name),
  };
}

/** @param {string} name @returns {import('../score.mjs').DenseMap} */
function denseMap(name) {
  const visible = photoOf(name, 'visible.png');
  const { width, height } = visible;
  const seen = visible.grey();
  const raw = bytesOf(name, 'map_row_col.f32');
  const view = new DataView(raw.buffer, raw.byteOffset, raw.byteLength);
  visible.free();
  return {
    width,
    height,
    at(col, row) {
      const i = row * width + col;
      if (!seen[i]) return null;
      return [view.getFloat32(i * 8 + 4, true) + 0.5, view.getFloat32(i * 8, true) + 0.5];
    },
  };
}

/** Every pair of photographs whose pose is known.  @returns {PosedPair[]} */
export function posedPairs() {
  const folders = existsSync(DATA) ? readdirSync(DATA, { withFileTypes: true }).filter((entry) => entry.isDirectory()) : [];
  return folders.flatMap(({ name: folder }) => {
    if (!have(folder)) return [];
    const truth = readJson(join(DATA, folder, 'truth.json'));
    const known = (truth.pairs ?? []).filter((/** @type {any} */ { a, b, R }) => R && pinhole(truth, a) && pinhole(truth, b));
    const uncertain = truth.truth_kind?.includes('reference') ? OF_REFERENCE : undefined;
    return known.map((/** @type {any} */ { a, b, R, t }) => ({ folder, a, b, truth, pose: { rotation: R, direction: t, uncertain } }));
  });
}

/** A pair of digital images with known pose.  @param {string} name @param {string} a @param {string} b */
export function posed(name, a, b) {
  const truth = readJson(join(DATA, name, 'truth.json'));
  const pair = truth.pairs.find((/** @type {{ a: string, b: string }} */ p) => p.a === a && p.b === b);
  return { left: photoOf(name, a), right: photoOf(name, b), cameras: [a, b].map((file) => pinhole(truth, file)), rotation: pair.R, direction: pair.t };
}

/** @param {any} truth @param {string} file @returns {Pinhole} */
export function pinhole(truth, file) {
  const image = truth.images.find((/** @type {{ file: string }} */ i) => i.file === file);
  const {
    K: [f, fy, cx, cy],
    k1 = 0,
    k2 = 0,
  } = image.reference ?? image;
  return { f, fy, cx: cx + 0.5, cy: cy + 0.5, k1, k2 };
}
