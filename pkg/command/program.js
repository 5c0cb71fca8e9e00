// @ts-check
/** How this program is called again. */

import { basename, relative } from 'node:path';

/**
 * The words that call the program as it was called: by its name, by npx, or by its file.
 * @param {string} file as the system was given it @param {string} folder in which the call is made @returns {string[]}
 */
export function programWords(file, folder) {
  if (basename(file) === 'tiepoint') return /[\\/]node_modules[\\/]/.test(file) ? ['npx', 'tiepoint'] : ['tiepoint'];
  const near = relative(folder, file);
  return ['node', near.startsWith('..') ? file : near];
}
