/** Compares built files with the tracked ones, byte by byte. */

import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join, relative } from 'node:path';

/** @param {string} folder @returns {string[]} all files below it, as relative paths */
function filesBelow(folder) {
  if (!existsSync(folder)) return [];
  return readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => relative(folder, join(entry.parentPath ?? entry.path, entry.name)).replaceAll('\\', '/'))
    .sort();
}

/**
 * @param {string} name of the tracked folder, for the message @param {string} tracked @param {string} rebuilt
 * @param {(file: string) => boolean} [counts] which files are compared: all where it is left out
 * @returns {import('./steps.mjs').Outcome}
 */
export function compareFolders(name, tracked, rebuilt, counts = () => true) {
  const [ours, theirs] = [filesBelow(tracked).filter(counts), filesBelow(rebuilt).filter(counts)];
  const different = [...new Set([...ours, ...theirs])].filter((file) => {
    if (!ours.includes(file) || !theirs.includes(file)) return true;
    return !readFileSync(join(tracked, file)).equals(readFileSync(join(rebuilt, file)));
  });
  if (different.length === 0) return { passed: 1 };
  const note = `${name} is not what its source gives (${different.join(', ')}): run npm run build and commit the result`;
  console.error(note);
  return { failed: 1, note };
}
