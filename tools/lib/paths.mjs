/** Where things lie: everything is found from here, never from the working directory. */

import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const ROOT = dirname(dirname(dirname(fileURLToPath(import.meta.url))));
export const TARGET = join(ROOT, 'target');
export const PKG_WASM = join(ROOT, 'pkg', 'wasm');
export const DIST = join(ROOT, 'dist');
/** Programs installed by the set-up, each once. */
export const TOOLS = join(TARGET, 'tools');
/** Test images with truth; not part of the project. */
export const DATA = process.env.TIEPOINT_DATA ?? join(dirname(ROOT), 'shared', 'data');

/** @param {string} path @returns {any} */
export const readJson = (path) => JSON.parse(readFileSync(path, 'utf8'));

/** The version of a package that the lock file pins.  @param {string} name @returns {string} */
export function pinned(name) {
  const lock = readJson(join(ROOT, 'package-lock.json'));
  return lock.packages[`node_modules/${name}`].version;
}
