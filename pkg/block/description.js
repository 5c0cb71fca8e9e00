// @ts-check
/** What is known of a block before its images are oriented: cameras, recorded positions, surveyed points. */

import { check_block_description, parse_image_measurements, parse_ground_control_points } from '../wasm/tiepoint.js';
import { BlockError } from './errors.js';

/**
 * @typedef {import('./types.js').BlockImage} BlockImage
 * @typedef {import('./types.js').GroupedCamera} GroupedCamera
 * @typedef {import('./types.js').ControlText} ControlText
 * @typedef {import('../wasm/tiepoint.js').BlockDescription} BlockDescription
 * @typedef {import('../wasm/tiepoint.js').GroundControlPoint} GroundControlPoint
 * @typedef {import('../wasm/tiepoint.js').GeoreferencingOptions} GeoreferencingOptions
 * @typedef {import('../wasm/tiepoint.js').ObservedPosition} ObservedPosition
 */

/** Surveyed points that two images each show, without which they do not place a block. */
const LEAST_SURVEYED = 3;

/** Nothing of a camera is estimated. */
const FIXED = { focal: false, principal_point: false, radial: 0, tangential: false };

/**
 * What is known before the orientation. Recorded positions and surveyed points are of different systems: where there are surveyed points,
 * they alone place the block, and the distances between recorded positions tell whether they are in metres.
 * @param {BlockImage[]} images @param {GroupedCamera[]} cameras @param {boolean} useGps @param {GeoreferencingOptions} placing @param {ControlText} [control]
 * @returns {{ description: BlockDescription, strayMarks: string[] }} `strayMarks`: images that marks name and that are not in the block
 */
export function describeBlock(images, cameras, useGps, placing, control) {
  const { surveyed, strayMarks } = control ? controlOf(control, images, placing) : { surveyed: [], strayMarks: [] };
  const description = {
    cameras: cameras.map(({ width_px, height_px, focal_px, principal_point_px, radial, tangential, pixel_mm, fixed }) => (
      { width_px, height_px, focal_px, principal_point_px, radial, tangential, pixel_mm, ...(fixed && { free: FIXED }) }
    )),
    images: images.map(({ name, camera, exif }) => ({ name, camera, position: useGps && exif.position ? observed(exif.position, placing) : null })),
    control: surveyed,
  };
  check_block_description(description);
  return { description, strayMarks };
}

/** What is said of recorded positions that cannot be.  @param {readonly BlockImage[]} images @returns {import('../wasm/tiepoint.js').Remark[]} */
export function impossiblePositions(images) {
  const found = images.flatMap(({ name, exif }) => (exif.impossible ? [{ name, value: exif.impossible }] : []));
  return found.length === 0 ? [] : [{ kind: 'impossible_positions', images: found }];
}

/**
 * A receiver that states its error states that of the place: the height is less sure by the same factor as without it.
 * @param {import('../wasm/tiepoint.js').ExifPosition} position @param {GeoreferencingOptions} placing @returns {ObservedPosition}
 */
function observed({ longitude_deg, latitude_deg, height_m, error_m }, { receiver_across_m, receiver_up_m }) {
  const across = error_m || receiver_across_m;
  const up = receiver_up_m * (across / receiver_across_m);
  return { system: 'geographic', longitude_deg, latitude_deg, height_m, sigma_m: [across, across, up] };
}

/**
 * @param {ControlText} control @param {BlockImage[]} images @param {GeoreferencingOptions} placing
 * @returns {{ surveyed: GroundControlPoint[], strayMarks: string[] }}
 */
function controlOf({ points, marks }, images, { surveyed_across_m, surveyed_up_m }) {
  const places = new Map(images.map(({ name }, index) => [name, index]));
  const surveyed = parse_ground_control_points(points).map(({ name, position, standard_errors }) => {
    const [across, up] = standard_errors ?? [surveyed_across_m, surveyed_up_m];
    return { name, position: /** @type {ObservedPosition} */ ({ system: 'local', position, sigma: [across, across, up] }), measurements: /** @type {GroundControlPoint['measurements']} */ ([]) };
  });
  const byName = new Map(surveyed.map((point) => [point.name, point]));
  /** @type {Set<string>} */
  const strays = new Set();
  for (const { image, point, x_px, y_px } of parse_image_measurements(marks)) {
    const of = byName.get(point);
    if (!of) throw new BlockError(`the marks name the point ${point}, which is not among the surveyed points`);
    const place = places.get(image);
    // An image that was left out, or is of another block.
    if (place === undefined) strays.add(image);
    else of.measurements.push({ image: place, x_px, y_px });
  }
  const strayMarks = [...strays].sort();
  const seen = surveyed.filter(({ measurements }) => measurements.length >= 2).length;
  if (seen < LEAST_SURVEYED) {
    const unknown = strayMarks.length > 0 ? `; the marks name ${strayMarks.slice(0, 3).join(', ')}${strayMarks.length > 3 ? ' …' : ''}, which the block has not` : '';
    throw new BlockError(`${seen} of ${surveyed.length} surveyed points are marked in two images or more${unknown}; allowed: ${LEAST_SURVEYED} or more, or none at all`);
  }
  return { surveyed, strayMarks };
}
