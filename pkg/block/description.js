// @ts-check
/** What is known of a block before its images are oriented: cameras, recorded positions, surveyed points. */

import { parse_image_marks, parse_surveyed_points } from '../wasm/tiepoint.js';
import { BlockError } from './errors.js';

/**
 * @typedef {import('./types.js').BlockImage} BlockImage
 * @typedef {import('./types.js').GroupedCamera} GroupedCamera
 * @typedef {import('./types.js').ControlText} ControlText
 * @typedef {import('../wasm/tiepoint.js').BlockDescription} BlockDescription
 * @typedef {import('../wasm/tiepoint.js').AssemblyControl} AssemblyControl
 * @typedef {import('../wasm/tiepoint.js').ObservedPosition} ObservedPosition
 */

/** Standard errors in m of a position whose receiver states none: across and up. */
const RECEIVER_M = { across: 3, up: 6 };

/** Heights of receivers are less sure than places by this factor. */
const UP_TO_ACROSS = 2;

/** Standard errors in m of surveyed points that state none: across and up. */
const SURVEY_M = /** @type {[number, number]} */ ([0.02, 0.03]);

/** Nothing of a camera is estimated. */
const FIXED = { focal: false, principal_point: false, radial: 0, tangential: false };

/**
 * What is known before the orientation. Recorded positions and surveyed points are of different systems: where there are surveyed points,
 * they alone place the block.
 * @param {BlockImage[]} images @param {GroupedCamera[]} cameras @param {boolean} useGps @param {ControlText} [control] @returns {BlockDescription}
 */
export function describeBlock(images, cameras, useGps, control) {
  const surveyed = control ? controlOf(control, images) : [];
  const placed = useGps && surveyed.length === 0;
  return {
    cameras: cameras.map(({ width_px, height_px, focal_px, principal_point_px, radial, tangential, pixel_mm, fixed }) => (
      { width_px, height_px, focal_px, principal_point_px, radial, tangential, pixel_mm, ...(fixed && { free: FIXED }) }
    )),
    images: images.map(({ name, camera, exif }) => ({ name, camera, position: placed && exif.position ? observed(exif.position) : null })),
    control: surveyed,
  };
}

/** @param {import('../wasm/tiepoint.js').ExifPosition} position @returns {ObservedPosition} */
function observed({ longitude_deg, latitude_deg, height_m, error_m }) {
  const { across, up } = error_m ? { across: error_m, up: UP_TO_ACROSS * error_m } : RECEIVER_M;
  return { system: 'geographic', longitude_deg, latitude_deg, height_m, sigma_m: [across, across, up] };
}

/** @param {ControlText} control @param {BlockImage[]} images @returns {AssemblyControl[]} */
function controlOf({ points, marks }, images) {
  const places = new Map(images.map(({ name }, index) => [name, index]));
  const control = parse_surveyed_points(points).map(({ name, position, standard_errors }) => {
    const [across, up] = standard_errors ?? SURVEY_M;
    return { name, position: /** @type {ObservedPosition} */ ({ system: 'local', position, sigma: [across, across, up] }), rays: /** @type {AssemblyControl['rays']} */ ([]) };
  });
  const byName = new Map(control.map((point) => [point.name, point]));
  for (const { image, point, x_px, y_px } of parse_image_marks(marks)) {
    const of = byName.get(point);
    if (!of) throw new BlockError(`the marks name the point ${point}, which is not among the surveyed points`);
    const place = places.get(image);
    // An image that was left out, or is of another block.
    if (place !== undefined) of.rays.push({ image: place, x_px, y_px });
  }
  return control;
}
