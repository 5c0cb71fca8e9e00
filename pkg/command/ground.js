// @ts-check
/** Orthophotos and the heights of their ground, as commands are given them, and the world files beside pictures. */

import { statSync } from 'node:fs';
import { basename, dirname, extname, join } from 'node:path';
import { OrthophotoReference } from '../node.js';
import { about, UsageError } from './errors.js';
import { filesIn, inParts, isFolder, readBytes, readText } from './files.js';
import { path, valueOption } from './options.js';

/** @typedef {{ file: string | undefined, heights: Uint8Array | number, world: string | undefined }} Ground `file`: where the heights come from */

export const ORTHOPHOTO_HELP = 'The reference: a GeoTIFF in a projected system, or an image with a world file beside it (.tfw, .jgw, .pgw, .wld);';

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
  if (typeof file === 'string') return { file, heights: readBytes(file), world: worldOf(file) };
  return level === undefined ? null : { file: undefined, heights: Number(level), world: undefined };
}

/**
 * Opens an orthophoto, and finds the points among which images are sought.
 * @param {string} file @param {Ground | null} ground @param {import('../node.js').PlacingOptions} placing
 * @returns {OrthophotoReference} which the caller frees
 */
export function openReference(file, ground, placing) {
  const reference = about(file, () => OrthophotoReference.open(inParts(file), worldOf(file)));
  try {
    if (ground) about(ground.file ?? '--level', () => reference.set_heights(ground.heights, ground.world));
    reference.search(placing);
    return reference;
  } catch (error) {
    reference.free();
    throw error;
  }
}

/** A world file has six numbers. */
const MOST_BYTES = 4096;

/** The text of the world file beside a picture, where there is one: of `a.tif` a.tfw, a.wld or a.tifw, in capitals or not.  @param {string} picture */
function worldOf(picture) {
  const end = extname(picture);
  const [folder, name] = [dirname(picture), basename(picture).toLowerCase()];
  if (end === '' || !isFolder(folder)) return undefined;
  const stem = name.slice(0, -end.length);
  const wanted = [`${stem}${end.slice(0, 2)}${end.slice(-1)}w`, `${stem}.wld`, `${name}w`].map((world) => world.toLowerCase());
  const found = filesIn(folder)
    .filter((file) => wanted.includes(file.toLowerCase()))
    .map((file) => join(folder, file))
    .find((file) => statSync(file).size <= MOST_BYTES);
  return found === undefined ? undefined : readText(found);
}
