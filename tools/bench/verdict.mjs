/**
 * Whether the verdict of a pair keeps its word: more than 500 pairs, most of half of which must not be called oriented, run with nothing set.
 *
 * `--quick` takes every eleventh pair of each kind, `--only=TEXT` those with the text in kind or name; `TIEPOINT_VERDICT_LINES` names a file for one line of JSON a pair.
 */

import { appendFileSync, writeFileSync } from 'node:fs';
import { match_pair } from '../../pkg/node.js';
import { count } from './verdict/count.mjs';
import { figures } from './verdict/figures.mjs';
import { errorsOf } from './verdict/judge.mjs';
import { allPairs } from './verdict/pairs.mjs';
import { photoOf } from './verdict/photographs.mjs';
import { inputOf } from './verdict/views.mjs';

/**
 * @typedef {import('./verdict/pairs.mjs').Given} Given
 * @typedef {import('../../pkg/node.js').PairOutput} PairOutput
 * @typedef {'oriented' | 'weak' | 'not_oriented'} Verdict
 * @typedef {{ given: Given, verdict: Verdict, hasPose: boolean, errors: import('./verdict/judge.mjs').Errors | null, seconds: number }} Outcome
 *   errors: null where nothing is oriented or no pose exists
 */

/** What the caller sets. @type {import('../../pkg/node.js').Given<import('../../pkg/node.js').PairSettings>} */
const SETTINGS = {};
/** With `--quick` one of so many pairs of each kind is run: no divisor of what their variants repeat after. */
const QUICK = 11;

export function verdict() {
  const quick = process.argv.includes('--quick');
  const lines = process.env.TIEPOINT_VERDICT_LINES;
  const only = process.argv.find((word) => word.startsWith('--only='))?.slice('--only='.length) ?? '';
  const wanted = allPairs().filter(({ kind, name }) => `${kind}, ${name}`.includes(only));
  const pairs = chosen(wanted, quick ? QUICK : 1);
  if (lines) writeFileSync(lines, '');
  console.log(`Verdicts of ${pairs.length} pairs${quick ? ', one of eleven of each kind' : ''}, nothing set`);
  const outcomes = pairs.map((given, k) => {
    const { outcome, line } = judged(given);
    if (lines) appendFileSync(lines, `${JSON.stringify(line)}\n`);
    console.log(`  ${k + 1} of ${pairs.length}, ${given.kind}, ${given.name}: ${told(outcome)}`);
    return outcome;
  });
  count(outcomes);
}

/** The first pairs of all kinds come first, then the second ones: what has run at any time shows all kinds.  @param {Given[]} pairs @param {number} every */
function chosen(pairs, every) {
  /** @type {Map<string, number>} */
  const seen = new Map();
  const ranked = pairs.map((pair) => {
    const rank = seen.get(pair.kind) ?? 0;
    seen.set(pair.kind, rank + 1);
    return { pair, rank };
  });
  const share = (/** @type {(typeof ranked)[number]} */ { pair, rank }) => rank / (seen.get(pair.kind) ?? 1);
  return ranked
    .filter(({ rank }) => rank % every === 0)
    .sort((a, b) => share(a) - share(b))
    .map(({ pair }) => pair);
}

/** @param {Given} given */
function judged(given) {
  const pair = given.make();
  const { left, right, pose } = pair;
  const photos = [left, right].map(({ picture }) => photoOf(picture));
  const [first, second] = photos;
  if (!first || !second) throw new Error('a pair has two images');
  const start = performance.now();
  let output = null;
  let refused = null;
  try {
    output = match_pair(first, second, inputOf(pair), SETTINGS);
  } catch (error) {
    // Input that contradicts itself is refused, which is a verdict.
    if (!(error instanceof Error && error.name === 'TiepointError')) throw error;
    refused = error.message;
  }
  const seconds = (performance.now() - start) / 1000;
  for (const photo of photos) photo.free();
  const errors = output?.orientation && pose ? errorsOf(output.orientation, pose) : null;
  /** @type {Outcome} */
  const outcome = { given, verdict: output ? verdictOf(output) : 'not_oriented', hasPose: pose !== null, errors, seconds };
  const { kind, name, site, part, isRight } = given;
  const found = output && figures(output, [left.picture, right.picture]);
  const sizes = [left, right].map(({ picture: { width, height } }) => [width, height]);
  return { outcome, line: { kind, name, site, part, isRight, hasPose: pose !== null, verdict: outcome.verdict, errors, seconds, refused, sizes, ...found } };
}

/** @param {PairOutput} output @returns {Verdict} */
const verdictOf = ({ verdict }) => verdict.kind;

/** @param {Outcome} outcome */
function told({ verdict, hasPose, errors, seconds }) {
  const off = errors ? `, off by ${errors.rotation_deg.toFixed(2)}° and ${errors.direction_deg.toFixed(2)}°, ${errors.inRegion.toFixed(2)} of its region` : '';
  return `${verdict}${off}${!hasPose && verdict !== 'not_oriented' ? ', where there is no pose' : ''}, ${seconds.toFixed(1)} s`;
}
