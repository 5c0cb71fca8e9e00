/** The pairs of the part `default`: all open ones with truth, of which nothing is known or whose cameras are, and simulated ones of all kinds. */

import { join } from 'node:path';
import { grey_png, interior, Photo, read_exif } from '../../../pkg/node.js';
import { DATA, readJson } from '../../lib/paths.mjs';
import { edgePrecision, poseOf, sampsonShare, share } from '../../score.mjs';
import { calibratedInput } from '../calibrated.mjs';
import { bytesOf, have, photoOf, pinhole, posedPairs, simulated } from '../data.mjs';
import { projected } from '../features.mjs';
import { rightFlights } from '../verdict/right.mjs';
import { seenShare } from '../verdict/seen.mjs';
import { inputOf } from '../verdict/views.mjs';

/**
 * @typedef {import('../../../pkg/node.js').Given<import('../../../pkg/node.js').PairInput>} PairInput
 * @typedef {import('../rivals/posed.mjs').Lens} Lens
 * @typedef {'of EXIF, or unknown' | 'calibrated' | 'simulated'} Set
 * @typedef {{ left: Photo, right: Photo, input: PairInput }} Made
 * @typedef {{ name: string, set: Set, make: () => Made, pose: import('../data.mjs').TruePose | null, share: (matches: Float64Array) => number,
 *   files: [string, string] | null, lenses: (made: Made) => [Lens, Lens] }} Case
 *   pose: null where none is known; share: of right ones among matches; files: null where the images are in no file; lenses: what a rival knows of the cameras
 */

const FLIGHTS = 60;
/** Within this many px of its place by a homography a match is right. */
const ON_PLANE_PX = 3;
/** The focal length by the longer side of the image that COLMAP assumes where nothing is known. */
const GUESSED = 1.2;

/** @returns {Case[]} */
export const allCases = () => [...photographs(), ...plane(), ...otherSimulated(), ...flights()];

/** Every pair of photographs with known pose, without and with its calibrated cameras.  @returns {Case[]} */
function photographs() {
  return posedPairs().flatMap(({ folder, a, b, truth, pose }) => {
    const cameras = /** @type {[ReturnType<typeof pinhole>, ReturnType<typeof pinhole>]} */ ([pinhole(truth, a), pinhole(truth, b)]);
    const pair = {
      name: `${folder} ${a} ${b}`,
      pose,
      share: (/** @type {Float64Array} */ matches) => sampsonShare(matches, ...cameras, pose.rotation, pose.direction).share,
      files: files(folder, a, b),
    };
    const radial = /** @type {[[number, number], [number, number]]} */ (cameras.map(({ k1, k2 }) => [k1, k2]));
    return [
      unknown(folder, a, b, pair),
      {
        ...pair,
        set: /** @type {const} */ ('calibrated'),
        make: () => {
          const [left, right] = [photoOf(folder, a), photoOf(folder, b)];
          return { left, right, input: calibratedInput(cameras, [left, right]) };
        },
        lenses: (/** @type {Made} */ made) => lensesOf(made, radial),
      },
    ];
  });
}

/** The pair of a plane, whose homography is known but no pose.  @returns {Case[]} */
function plane() {
  const folder = 'homography_graf';
  if (!have(folder)) return [];
  return readJson(join(DATA, folder, 'truth.json')).homographies.map((/** @type {{ a: string, b: string, H: number[][] }} */ { a, b, H }) => {
    const isRight = (/** @type {number} */ xl, /** @type {number} */ yl, /** @type {number} */ xr, /** @type {number} */ yr) => {
      const [x = NaN, y = NaN] = projected(H, xl, yl);
      return Math.hypot(x - xr, y - yr) <= ON_PLANE_PX;
    };
    const of = (/** @type {Float64Array} */ matches) => share(matches, isRight).share;
    return unknown(folder, a, b, { name: `${folder} ${a} ${b}`, pose: null, share: of, files: files(folder, a, b) });
  });
}

/** The pair of the paper's geometry that another program simulated.  @returns {Case[]} */
function otherSimulated() {
  const folder = 'simulated-a';
  if (!have(folder)) return [];
  const { left, right, input, truth, map, base_mm } = simulated();
  left.free();
  right.free();
  const [a, b] = ['left.png', 'right.png'];
  const of = (/** @type {Float64Array} */ matches) => edgePrecision(matches, map).share;
  const pair = { name: folder, pose: poseOf({ ...truth, base_mm }), share: of, files: files(folder, a ?? '', b ?? '') };
  const make = () => ({ left: photoOf(folder, a ?? ''), right: photoOf(folder, b ?? ''), input });
  return [unknown(folder, a ?? '', b ?? '', pair), { ...pair, set: 'calibrated', make, lenses: (made) => lensesOf(made) }];
}

/** Flights of all kinds, as evenly of them as 60 can be.  @returns {Case[]} */
function flights() {
  const all = rightFlights();
  const chosen = Array.from({ length: FLIGHTS }, (_, k) => all[Math.floor((k * all.length) / FLIGHTS)]).filter((given) => given !== undefined);
  return chosen.map(({ name, make: simulate }) => {
    /** @type {import('../verdict/views.mjs').Pair | undefined} */
    let made;
    const pair = () => {
      made ??= simulate();
      return made;
    };
    const photo = (/** @type {import('../verdict/views.mjs').View} */ { picture: { width, height, grey } }) => Photo.from_grey(width, height, grey);
    return {
      name,
      set: 'simulated',
      make: () => ({ left: photo(pair().left), right: photo(pair().right), input: inputOf(pair()) }),
      get pose() {
        return pair().pose;
      },
      share: (/** @type {Float64Array} */ matches) => seenShare(pair())(matches),
      files: null,
      lenses: (/** @type {Made} */ made) => lensesOf(made),
    };
  });
}

/** @param {string} folder @param {string} a @param {string} b @returns {[string, string]} */
const files = (folder, a, b) => [join(DATA, folder, a), join(DATA, folder, b)];

/** A pair of which nothing is said: its cameras are those of EXIF, or unknown.  @param {string} folder @param {string} a @param {string} b @param {Pick<Case, 'name' | 'pose' | 'share' | 'files'>} pair @returns {Case} */
function unknown(folder, a, b, pair) {
  const side = (/** @type {string} */ file, /** @type {Photo} */ { width, height }) => {
    const { camera } = read_exif(bytesOf(folder, file), width, height);
    const known = camera?.pixel_mm ? { focal_mm: camera.focal_mm, pixel_mm: camera.pixel_mm } : { focal_mm: GUESSED * Math.max(width, height), pixel_mm: 1 };
    return lensOf(interior(known, { width, height }), known.focal_mm, [0, 0], [0, 0]);
  };
  return {
    ...pair,
    set: 'of EXIF, or unknown',
    make: () => ({ left: photoOf(folder, a), right: photoOf(folder, b), input: {} }),
    lenses: ({ left, right }) => [side(a, left), side(b, right)],
  };
}

/** What is given of the cameras, as a rival takes it.  @param {Made} made @param {[[number, number], [number, number]]} [radial] of each @returns {[Lens, Lens]} */
function lensesOf(
  { left, right, input },
  radial = [
    [0, 0],
    [0, 0],
  ],
) {
  const { camera } = input;
  if (!camera) throw new Error('no camera is given');
  const side = (
    /** @type {Photo} */ { width, height },
    /** @type {PairInput['left']} */ { fiducials = [], origin = null } = {},
    /** @type {[number, number]} */ distortion,
  ) =>
    lensOf(
      interior(/** @type {import('../../../pkg/node.js').CameraMm} */ (camera), { width, height, fiducials, origin }),
      camera.focal_mm ?? NaN,
      camera.principal_point_mm ?? [0, 0],
      distortion,
    );
  return [side(left, input.left, radial[0]), side(right, input.right, radial[1])];
}

/** @param {import('../../../pkg/node.js').Interior} interior @param {number} focal @param {number[]} principal in mm @param {[number, number]} radial @returns {Lens} */
function lensOf({ parameters: [[a, b, c], [d, e, f]] }, focal, [x = 0, y = 0], radial) {
  return {
    affine: [
      [a, b, c - x],
      [-d, -e, y - f],
    ].map((row) => row.map((value) => value / focal)),
    radial,
  };
}

/** The image of a photo as a file.  @param {Photo} photo */
export const pngOf = (photo) => grey_png(photo.width, photo.height, photo.grey());
