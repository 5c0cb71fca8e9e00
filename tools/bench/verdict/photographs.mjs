/** Real photographs, halved until they have at most 1024 px, with the camera of their EXIF data or the calibrated one. */

import { grey_png, Photo, read_exif } from '../../../pkg/node.js';
import { cameraOf } from '../accuracy.mjs';
import { corners } from '../calibrated.mjs';
import { bytesOf, pinhole } from '../data.mjs';

/**
 * @typedef {import('./views.mjs').View} View
 * @typedef {import('./views.mjs').Pair} Pair
 * @typedef {import('../data.mjs').PosedPair} PosedPair
 * @typedef {import('../../score.mjs').Pinhole} Pinhole
 */

const MOST_PX = 1024;

/** @type {Map<string, View>} */
const decoded = new Map();

/** The view with its EXIF data.  @param {string} folder @param {string} file @param {number} [most] longest side in px @returns {View} */
export function photograph(folder, file, most = MOST_PX) {
  const key = `${folder}/${file} ${most}`;
  const kept = decoded.get(key);
  if (kept) return kept;
  const bytes = bytesOf(folder, file);
  const photo = Photo.decode(bytes);
  const { width, height, grey, halvings } = photo.reduced(most);
  const exif = read_exif(bytes, photo.width, photo.height);
  photo.free();
  const pixel = exif.camera?.pixel_mm ?? null;
  const camera = exif.camera && { ...exif.camera, pixel_mm: pixel === null ? null : pixel * 2 ** halvings };
  const view = { picture: { width, height, grey, exif: { ...exif, camera } }, fiducials: [] };
  decoded.set(key, view);
  return view;
}

/** @param {View} view @returns {View} the same as a program wrote it that keeps no EXIF data */
export function withoutExif({ picture: { width, height, grey }, fiducials }) {
  return { picture: { width, height, grey }, fiducials };
}

/** As its file is decoded.  @param {import('./pictures.mjs').Picture} picture */
export function photoOf({ width, height, grey, exif }) {
  return exif?.camera ? Photo.decode(grey_png(width, height, grey, exif)) : Photo.from_grey(width, height, grey);
}

/** A pair with known pose by the cameras of its EXIF data.  @param {PosedPair} posed @returns {Pair} */
export const byExif = ({ folder, a, b, pose }) => ({ left: photograph(folder, a), right: photograph(folder, b), camera: null, pose });

/** The same by its calibrated cameras.  @param {PosedPair} posed @returns {Pair} */
export function calibrated({ folder, a, b, truth, pose }) {
  const [left, right] = [a, b].map((file) => withoutExif(photograph(folder, file)));
  const [first, second] = [a, b].map((file, k) => inReduced(pinhole(truth, file), [left, right][k], truth, file));
  if (!left || !right || !first || !second) throw new Error('a pair has two images');
  const camera = cameraOf(first, left.picture.width, left.picture.height);
  if (first.cx === second.cx && first.cy === second.cy) return { left, right, camera, pose };
  // Principal points of one camera at different places of its images: the corners say where.
  const marked = (/** @type {View} */ view, /** @type {Pinhole} */ of) => ({ ...view, fiducials: corners(view.picture, of, camera.focal_mm) });
  return { left: marked(left, first), right: marked(right, second), camera: { ...camera, principal_point_mm: [0, 0] }, pose };
}

/** @param {Pinhole} camera @param {View | undefined} view @param {any} truth @param {string} file @returns {Pinhole} */
function inReduced({ f, fy = f, cx, cy, ...distortion }, view, truth, file) {
  const { width } = truth.images.find((/** @type {{ file: string }} */ image) => image.file === file);
  const by = (view?.picture.width ?? NaN) / width;
  return { f: f * by, fy: fy * by, cx: cx * by, cy: cy * by, ...distortion };
}
