// @ts-check
/** What is known of a pair beside its images, as options: camera, fiducial marks, offset, and how it is matched and oriented. */

import { camera_of_focal_px, parse_camera, parse_fiducials } from '../node.js';
import { cameraOfBlock, holdsBlock } from './block-camera.js';
import { about, UsageError } from './errors.js';
import { readBytes, readMask, readText } from './files.js';
import { textOf } from '../block/text-of.js';
import { checkTogether, MASK, pair, path, valueOption } from './options.js';

/**
 * @typedef {import('../node.js').Given<import('../node.js').PairInput>} GivenInput
 * @typedef {import('./args.js').Call} Call
 */

export const PAIR_OPTIONS = [
  path(
    'camera',
    'camera.json',
    'Focal length, principal point and, where there are no fiducials, pixel size: {"focal_mm", "principal_point_mm": [x, y], "pixel_mm"}. Or the project.tiepoint of a block, whose calibrated camera is taken.',
  ),
  valueOption('focal_px'),
  path('left-fiducials', 'F.csv', 'Fiducial marks measured in the scan of the left photo: col,row,x_mm,y_mm.'),
  path('right-fiducials', 'F.csv', 'The same of the right photo.'),
  pair('left-origin', 'COL,ROW', "Place of the left image's top-left pixel in the scan whose fiducials were measured."),
  pair('right-origin', 'COL,ROW', 'The same of the right image.'),
  pair('offset', 'DX,DY', 'Position of a point in the right image minus that in the left, in px; estimated when not given.'),
];

export const MASK_OPTIONS = [path('mask-left', 'FILE', `${MASK} in the left photo.`), path('mask-right', 'FILE', 'The same of the right photo.')];

/** The files of the masks that were given.  @param {Call} call @returns {[string | undefined, string | undefined]} */
export function maskPaths({ values }) {
  const of = (/** @type {string} */ name) => {
    const file = values.get(name);
    return typeof file === 'string' ? file : undefined;
  };
  return [of('mask-left'), of('mask-right')];
}

/** The masks that were given.  @param {Call} call @param {import('../node.js').Photo} left @param {import('../node.js').Photo} right @returns {[Uint8Array | undefined, Uint8Array | undefined]} */
export function masksOf(call, left, right) {
  const of = (/** @type {string | undefined} */ path, /** @type {import('../node.js').Photo} */ photo) =>
    path === undefined ? undefined : readMask(path, photo);
  const [ofLeft, ofRight] = maskPaths(call);
  return [of(ofLeft, left), of(ofRight, right)];
}

/** Options that only make sense beside another.  @type {readonly (readonly [string, string])[]} */
const TOGETHER = [
  ['left-fiducials', 'right-fiducials'],
  ['right-fiducials', 'left-fiducials'],
  ['left-origin', 'left-fiducials'],
  ['right-origin', 'right-fiducials'],
];

/** Fiducial marks that were measured in a scan, and where the image lies in it.  @param {string} file @param {import('./options.js').Value | undefined} origin */
export function marksOf(file, origin) {
  const text = readText(file);
  const fiducials = about(file, () => parse_fiducials(text));
  return Array.isArray(origin) ? { fiducials, origin } : { fiducials };
}

/**
 * What the options say of the photos, and the camera of a block, where that is given.
 * @param {Call} call @returns {{ input: GivenInput, ofBlock: import('./block-camera.js').BlockCamera | null }}
 */
export function inputOf(call) {
  const { values } = call;
  checkTogether(values, TOGETHER);
  /** @type {GivenInput} */
  const input = {};
  const camera = values.get('camera');
  let ofBlock = null;
  if (typeof camera === 'string') {
    const bytes = readBytes(camera);
    ofBlock = holdsBlock(bytes) ? cameraOfBlock(camera, bytes, call.positionals) : null;
    input.camera = ofBlock?.camera ?? about(camera, () => parse_camera(textOf(bytes)));
  }
  const focal = values.get('focal-px');
  if (typeof focal === 'number') {
    if (input.camera) throw new UsageError('--camera and --focal-px both give a focal length; give one of them');
    input.camera = camera_of_focal_px(focal);
  }
  for (const side of /** @type {const} */ (['left', 'right'])) {
    const file = values.get(`${side}-fiducials`);
    if (typeof file === 'string') input[side] = marksOf(file, values.get(`${side}-origin`));
  }
  const offset = values.get('offset');
  if (Array.isArray(offset)) input.offset = offset;
  return { input, ofBlock };
}
