// @ts-check
/** Which images share a camera, and what is known of it. */

import { camera_rules_of, parse_camera_rules } from '../wasm/tiepoint.js';
import { BlockError } from './errors.js';

/**
 * @typedef {import('./types.js').GroupedCamera} GroupedCamera
 * @typedef {import('./types.js').PairCamera} PairCamera
 * @typedef {import('./types.js').FeatureHead} FeatureHead
 * @typedef {import('../wasm/tiepoint.js').CameraRule} CameraRule
 */

/**
 * Images of one make, model, focal length and size are of one camera, and so are those of one rule and size.
 * @param {readonly { name: string, head: FeatureHead }[]} images @param {string} [rulesText] a file of cameras
 * @returns {{ cameras: GroupedCamera[], of: number[] }} the camera of each image
 */
export function groupCameras(images, rulesText) {
  const rules = rulesText === undefined ? [] : parse_camera_rules(rulesText);
  const ruled = camera_rules_of(rules, images.map(({ name }) => name));
  /** @type {Map<string, number>} */
  const places = new Map();
  /** @type {GroupedCamera[]} */
  const cameras = [];
  const of = images.map(({ head }, index) => {
    const rule = rules[ruled[index] ?? -1];
    const camera = rule ? ofRule(rule, head) : ofExif(head);
    const key = JSON.stringify([ruled[index], camera]);
    const place = places.get(key) ?? cameras.push(camera) - 1;
    places.set(key, place);
    return place;
  });
  return { cameras, of };
}

/**
 * Patterns of a file of cameras that no image's name fits. A file of which all are so is of other images, and refused.
 * @param {readonly string[]} names @param {string} [rulesText] @returns {string[]}
 */
export function strayRules(names, rulesText) {
  const rules = rulesText === undefined ? [] : parse_camera_rules(rulesText);
  const strays = rules.filter((rule) => camera_rules_of([rule], [...names]).every((of) => of < 0)).map(({ images }) => images ?? '*');
  if (strays.length > 0 && strays.length === rules.length) {
    throw new BlockError(`the cameras are of no image here: ${strays.join(', ')}; allowed: patterns that fit names as ${names.slice(0, 2).join(', ')}`);
  }
  return strays;
}

/** Focal lengths in widths of the image, between which those of cameras are. */
const FOCAL_WIDTHS = [0.3, 20];

/** What is said of cameras whose focal length is hardly one in px.  @param {readonly GroupedCamera[]} cameras @returns {import('../wasm/tiepoint.js').Remark[]} */
export function doubtfulCameras(cameras) {
  const [least = 0, most = 0] = FOCAL_WIDTHS;
  return cameras.flatMap(({ label, focal_px, width_px, height_px }) => {
    const widths = focal_px === null ? 1 : focal_px / Math.max(width_px, height_px);
    if (widths >= least && widths <= most) return [];
    return [{ kind: 'doubtful_focal', label, focal_px: focal_px ?? 0, sides: widths, least, most, in_mm: widths < least }];
  });
}

/** @param {FeatureHead} head @returns {GroupedCamera} */
function ofExif({ width, height, exif }) {
  const { make, model, camera } = exif;
  const known = camera !== null && camera.pixel_mm !== null;
  // Models of some makers begin with the make.
  const name = [model?.startsWith(make ?? '') ? null : make, model].filter(Boolean).join(' ');
  return {
    label: [name, camera && `${camera.focal_mm} mm`, `${width} x ${height} px`].filter(Boolean).join(', '),
    ...plain(width, height),
    focal_px: known ? camera.focal_mm / (camera.pixel_mm ?? 1) : null,
    pixel_mm: known ? camera.pixel_mm : null,
  };
}

/** @param {CameraRule} rule @param {FeatureHead} head @returns {GroupedCamera} */
function ofRule({ images, focal_px, principal_point_px, radial, tangential, pixel_mm, fixed }, { width, height, exif }) {
  const camera = plain(width, height);
  return {
    ...camera,
    label: `${images}, ${width} x ${height} px`,
    focal_px,
    principal_point_px: principal_point_px ?? camera.principal_point_px,
    radial: radial ?? camera.radial,
    tangential: tangential ?? camera.tangential,
    pixel_mm: pixel_mm ?? exif.camera?.pixel_mm ?? null,
    fixed: fixed ?? false,
  };
}

/** @param {number} width @param {number} height @returns {Omit<GroupedCamera, 'label' | 'focal_px'>} */
const plain = (width, height) => ({ width_px: width, height_px: height, principal_point_px: [width / 2, height / 2], radial: [0, 0, 0], tangential: [0, 0], pixel_mm: null, fixed: false });

/**
 * What is known of the cameras of a pair: two focal lengths or none.
 * @param {GroupedCamera} left @param {GroupedCamera} right @returns {[PairCamera, PairCamera]}
 */
export function pairCameras(left, right) {
  const both = left.focal_px !== null && right.focal_px !== null;
  /** @param {GroupedCamera} camera @returns {PairCamera} */
  const of = (camera) => {
    const { focal_px, principal_point_px, radial, tangential } = camera;
    const bent = both && [...radial, ...tangential].some((k) => k !== 0);
    return { pinhole: { focal_px: both ? focal_px : null, principal_px: principal_point_px }, lens: bent ? knownCamera(camera) : null };
  };
  return [of(left), of(right)];
}

/** A camera as a block holds it; null where its focal length is not known.  @param {GroupedCamera} camera @returns {import('../wasm/tiepoint.js').Camera | null} */
export function knownCamera({ width_px, height_px, focal_px, principal_point_px, radial, tangential, pixel_mm }) {
  return focal_px === null ? null : { width_px, height_px, focal_px, principal_point_px, radial, tangential, pixel_mm };
}
