// @ts-check
/** What is said of files that are skipped. */

import { byReason } from '../block/refused-files.js';
import { listed } from './text.js';

/** Files that are skipped, each reason once with the first names that it holds for.  @param {readonly { name: string, reason: string }[]} skipped @returns {string[]} */
export const skippedTexts = (skipped) =>
  [...byReason(skipped)].map(([reason, names]) =>
    names.length === 1 ? `${listed(names)} is skipped: ${reason}` : `${names.length} files are skipped (${listed(names)}): ${reason}`,
  );
