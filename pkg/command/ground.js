// @ts-check
/** The heights of the ground, as commands are given them, and the world files beside pictures. */

import { statSync } from 'node:fs';
import { basename, dirname, extname, join } from 'node:path';
import { UsageError } from './errors.js';
import { filesIn, isFolder, readBytes, readText } from './files.js';
import { path, real } from './options.js';

/** @typedef {{ file: string | undefined, heights: Uint8Array | number, world: string | undefined }} Ground `file`: where the heights come from */

export const GROUND_OPTIONS = [
  path('heights', 'FILE', 'Height model of the ground: a GeoTIFF or an ESRI ASCII grid, in the same system.'),
  real('level', 'heights', 'The height of level ground, where there is no height model.', (n) => Math.abs(n) <= 20_000, '-20000 to 20000'),
];

/** The heights that were given; null where none were.  @param {import('./args.js').Call['values']} values @returns {Ground | null} */
export function groundOf(values) {
  const [file, level] = [values.get('heights'), values.get('level')];
  if (typeof file === 'string' && level !== undefined) throw new UsageError('--heights and --level are both given; allowed: one of them');
  if (typeof file === 'string') return { file, heights: readBytes(file), world: worldOf(file) };
  return level === undefined ? null : { file: undefined, heights: Number(level), world: undefined };
}

/** A world file has six numbers. */
const MOST_BYTES = 4096;

/** The text of the world file beside a picture, where there is one: of `a.tif` a.tfw, a.wld or a.tifw, in capitals or not.  @param {string} picture */
export function worldOf(picture) {
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
