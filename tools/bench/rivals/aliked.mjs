/** The recorded results of a learned rival, ALIKED with mutual neighbours and USAC_MAGSAC, on the same pairs: its own script measured them once. */

import { existsSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { PEERS } from './opencv.mjs';

/** @typedef {import('./opencv.mjs').Score} Score */

/** A line of the record; names of files are cut to 16 letters. */
const LINE = /^(\S+)\s+(\S+)\s+(\S+)\s+matches\s+(\d+) right\s+(\d+) share (\S+) rot (\S+) dir (\S+)/;

/** The scores, null where the record is not there.  @param {import('./pairs.mjs').Pair[]} pairs @returns {{ scores: Score[], entries: import('./ours.mjs').Entry[] } | null} */
export function recorded(pairs) {
  const file = process.env.TIEPOINT_ALIKED ?? join(dirname(PEERS), 'aliked.txt');
  if (!existsSync(file)) return null;
  const scores = parsed(readFileSync(file, 'utf8')).flatMap((score) => {
    const pair = pairs.find(({ name, a, b }) => name === score.case && a.startsWith(score.a) && b.startsWith(score.b));
    return pair ? [{ ...score, a: pair.a, b: pair.b }] : [];
  });
  return { scores, entries: scores.map(({ case: name, a, b }) => ({ case: name, a, b, matches: [], R: null, t: null, seconds: {} })) };
}

/** @param {string} text @returns {Score[]} */
export function parsed(text) {
  return text.split('\n').flatMap((line) => {
    const found = LINE.exec(line);
    if (!found) return [];
    const [, name = '', a = '', b = '', ...figures] = found;
    const [matches = NaN, right = NaN, share = NaN, rotation = NaN, direction = NaN] = figures.map(Number);
    const errors = Number.isNaN(rotation) ? {} : { rotation_error_deg: rotation, direction_error_deg: direction };
    return [{ case: name, a, b, matches, right, share, ...errors }];
  });
}
