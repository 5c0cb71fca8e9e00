// @ts-check
/** Orthophotos and the heights of their ground, as commands are given them, and what stands beside them. */

import { statSync } from 'node:fs';
import { basename, dirname, extname, join } from 'node:path';
import { block_settings, image_position, OrthophotoReference, placing_defaults, positions_of_images, remarks_of_positions } from '../node.js';
import { about, DataError, ofOption, UsageError } from './errors.js';
import { filesIn, inParts, isFile, isFolder, readText } from './files.js';
import { checkTogether, path, settingsOf, valueOption } from './options.js';

/** @typedef {import('../node.js').Given<import('../node.js').Sidecars>} Sidecars */
/** @typedef {{ file: string | undefined, heights: Uint8Array | import('../node.js').FileInParts | number, sidecars: Sidecars }} Ground `file`: where the heights come from */

export const ORTHOPHOTO_HELP =
  'The reference: a GeoTIFF in a projected system, or an image with a world file beside it (.tfw, .jgw, .pgw, .wld) and perhaps its system (.prj);';

/** What is said where no heights are given. */
export const NO_HEIGHTS = 'no heights are given: the ground is taken as level at 0; positions are above it';

export const GROUND_OPTIONS = [
  path(
    'heights',
    'FILE',
    'Heights of the ground, in the same system: a GeoTIFF, an ESRI ASCII grid, or the project.tiepoint of an oriented block, whose tie points give them.',
  ),
  valueOption('heights'),
];

/** The heights that were given; null where none were.  @param {import('./args.js').Call['values']} values @returns {Ground | null} */
export function groundOf(values) {
  const [file, level] = [values.get('heights'), values.get('level')];
  if (typeof file === 'string' && level !== undefined) throw new UsageError('--heights and --level are both given; allowed: one of them');
  if (typeof file === 'string') return { file, heights: inParts(file), sidecars: sidecarsOf(file) };
  return level === undefined ? null : { file: undefined, heights: Number(level), sidecars: {} };
}

/**
 * The settings of placing on an orthophoto.
 * @param {readonly import('./options.js').Option[]} options that stand for them @param {import('./args.js').Call['values']} values
 */
export function placingOf(options, values) {
  checkTogether(values, [
    ['near-x', 'near-y'],
    ['near-y', 'near-x'],
  ]);
  return settingsOf(options, values, placing_defaults());
}

/** Refuses a coordinate system that cannot be read.  @param {import('./args.js').Call['values']} values */
export function checkCrs(values) {
  const crs = values.get('crs');
  if (typeof crs === 'string') ofOption('crs', () => block_settings({ placing: { crs } }));
}

/**
 * Opens an orthophoto, and finds the points among which images are sought.
 * @param {string} file @param {Ground | null} ground @param {import('../node.js').PlacingOptions} placing
 * @returns {OrthophotoReference} which the caller frees
 */
export function openReference(file, ground, placing) {
  const reference = about(file, () => OrthophotoReference.open(inParts(file), sidecarsOf(file)));
  try {
    if (ground) about(ground.file ?? '--level', () => reference.set_heights(ground.heights, ground.sidecars));
    reference.search(placing);
    return reference;
  } catch (error) {
    reference.free();
    throw error;
  }
}

/** Positions that a table gives to images, in their order.  @typedef {readonly (import('../node.js').GivenPosition | null)[]} Given */

/**
 * The positions of a table, and what is to be said of it. Coordinates in a plane are in the system of the code or text, or else in that of the orthophoto.
 * @param {string} file @param {string | undefined} crs @param {readonly string[]} images @param {OrthophotoReference} reference
 * @returns {{ given: Given, remarks: import('../node.js').Remark[] }}
 */
export function positionsIn(file, crs, images, reference) {
  const { epsg } = reference.info();
  const [text, names] = [readText(file), images.map((image) => basename(image))];
  const placing = { crs: crs ?? (epsg === null ? null : `EPSG:${epsg}`) };
  return about(file, () => ({ given: positions_of_images(text, names, placing), remarks: remarks_of_positions(text, names) }));
}

/**
 * What is to be said of images before anything is matched: that none has a GNSS position near the orthophoto. Null where one does, or where nothing says it.
 * @param {OrthophotoReference} reference @param {readonly string[]} images @param {Given} given @returns {import('../node.js').Remark | null}
 */
export function elsewhereOf(reference, images, given) {
  if (!reference.info().on_earth) return null;
  return reference.elsewhere(images.map((image, index) => given[index]?.position ?? positionOf(image)).filter((position) => position !== null));
}

/** What cannot be read is told when it is placed.  @param {string} image */
function positionOf(image) {
  if (!isFile(image)) return null;
  try {
    return image_position(inParts(image));
  } catch (error) {
    if (error instanceof DataError) return null;
    throw error;
  }
}

/** A world file has six numbers, and a system some thousand letters. */
const MOST_BYTES = 65_536;

/**
 * The texts of what stands beside a picture, in capitals or not: of `a.tif` the world file a.tfw, a.wld or a.tifw, and its system in a.prj.
 * @param {string} picture @returns {Sidecars}
 */
function sidecarsOf(picture) {
  const end = extname(picture);
  const [folder, name] = [dirname(picture), basename(picture).toLowerCase()];
  if (end === '' || !isFolder(folder)) return {};
  const stem = name.slice(0, -end.length);
  const files = filesIn(folder);
  const textOf = (/** @type {string[]} */ wanted) => {
    const found = files
      .filter((file) => wanted.includes(file.toLowerCase()))
      .map((file) => join(folder, file))
      .find((file) => statSync(file).size <= MOST_BYTES);
    return found === undefined ? null : readText(found);
  };
  const world_file = textOf([`${stem}${end.slice(0, 2)}${end.slice(-1)}w`.toLowerCase(), `${stem}.wld`, `${name}w`]);
  return { world_file, projection: textOf([`${stem}.prj`]) };
}
