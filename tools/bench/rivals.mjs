/**
 * Pairs with known truth as the command matches and orients them, by gradients and by its default, beside rivals: OpenCV's SIFT natively, OpenCV.js
 * from npm, and the recorded results of a learned one.
 */

import { writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { median } from './median.mjs';
import { recorded } from './rivals/aliked.mjs';
import { kept, missing, nativeSift, scores } from './rivals/opencv.mjs';
import { byOpenCvJs } from './rivals/opencvjs.mjs';
import { ours } from './rivals/ours.mjs';
import { knownPairs } from './rivals/pairs.mjs';

/** @param {number | null | undefined} value @param {number} digits */
const figure = (value, digits) => (value === null || value === undefined ? '-' : value.toFixed(digits));

const ASKED_SHARE = 0.98;

/** @param {string} what @param {import('./rivals/opencv.mjs').Score} score @param {import('./rivals/ours.mjs').Entry} entry */
function tell(what, score, { seconds, points, note }) {
  const times = Object.entries(seconds)
    .map(([part, time]) => `${part} ${time.toFixed(3)} s`)
    .join(', ');
  const errors = `rotation ${figure(score.rotation_error_deg, 3)}°, direction ${figure(score.direction_error_deg, 3)}°`;
  console.log(
    `    ${what.padEnd(14)} ${points ? `${points.join(' and ')} points, ` : ''}right ${score.right ?? '-'} of ${score.matches} (${figure(score.share, 3)}), ${errors}${times && `; ${times}`}${note ? `; ${note}` : ''}`,
  );
}

/** @typedef {{ scores: import('./rivals/opencv.mjs').Score[], entries: import('./rivals/ours.mjs').Entry[] }} Rival */

/** The figures of a pair.  @param {Rival} rival @param {import('./rivals/pairs.mjs').Pair} pair */
function of({ scores, entries }, { name, a, b }) {
  const k = entries.findIndex((entry) => entry.case === name && entry.a === a && entry.b === b);
  const [score, entry] = [scores[k], entries[k]];
  return score && entry ? { score, entry } : null;
}

/** What ours is by a rival's, over all pairs.  @param {string} who @param {string} what @param {Rival} own @param {Rival} rival @param {import('./rivals/pairs.mjs').Pair[]} pairs */
function compare(who, what, own, rival, pairs) {
  const both = pairs.flatMap((pair) => {
    const [mine, theirs] = [of(own, pair), of(rival, pair)];
    return mine && theirs ? [{ mine, theirs }] : [];
  });
  const right = both.map(({ mine, theirs }) => (mine.score.right ?? 0) / Math.max(1, theirs.score.right ?? 0));
  const times = both.map(({ mine, theirs }) => (mine.entry.seconds.features ?? NaN) / (theirs.entry.seconds.features ?? NaN));
  const ofTime = times.every(Number.isFinite) ? `; features' time median ${median(times).toFixed(2)}, most ${Math.max(...times).toFixed(2)}` : '';
  console.log(`  ${who} by ${what}, ${both.length} pairs: right matches median ${median(right).toFixed(2)}, least ${Math.min(...right).toFixed(2)}${ofTime}`);
  for (const error of /** @type {const} */ (['rotation_error_deg', 'direction_error_deg'])) {
    const ratios = both
      .filter(({ theirs }) => theirs.score[error] !== undefined)
      .map(({ mine, theirs }) => (mine.score[error] ?? Infinity) / (theirs.score[error] ?? NaN));
    if (ratios.length > 0)
      console.log(
        `    ${error.split('_')[0]} error lower on ${ratios.filter((ratio) => ratio < 1).length} of ${ratios.length} pairs, by ${median(ratios).toFixed(2)} in the median, ${Math.max(...ratios).toFixed(2)} at most`,
      );
  }
}

/** On how many pairs the share of right matches is what is asked for, and where it is not.  @param {string} who @param {Rival} own */
function shares(who, { scores }) {
  const less = scores.filter(({ share }) => share !== null && share < ASKED_SHARE);
  const named = less.map(({ case: name, a, b, share }) => `${name} ${a} ${b} ${figure(share, 3)}`).join(', ');
  console.log(
    `  ${who}: the share of right matches is ${ASKED_SHARE} or more on ${scores.length - less.length} of ${scores.length} pairs${named && `; ${named}`}`,
  );
}

/** `--fresh` measures the rivals again; without it what they were is kept in target/bench. */
export async function rivals(fresh = process.argv.includes('--fresh')) {
  const reason = missing();
  const pairs = knownPairs();
  if (reason || pairs.length === 0) return console.log(`rivals: skipped, ${reason ?? 'no pairs with truth are there'}`);
  console.log(
    'Rivals (ours: what the command runs, wasm in Node, warm; SIFT: OpenCV natively; ORB: OpenCV.js, which has neither SIFT nor the essential matrix; one thread each, at most 10,000 points; ALIKED: as recorded)',
  );
  const rival = (/** @type {string} */ name, /** @type {import('./rivals/ours.mjs').Entry[]} */ entries) => ({ entries, scores: scores(name, entries) });
  const own = rival(
    'ours',
    pairs.map((pair) => ours(pair, 'gradient')),
  );
  const auto = rival(
    'auto',
    pairs.map((pair) => ours(pair, 'auto')),
  );
  const sift = rival('sift', await nativeSift(false, fresh));
  const many = rival('sift-many', await nativeSift(true, fresh));
  const script = rival('opencvjs', await kept('opencvjs', fresh, async (file) => writeFileSync(file, JSON.stringify(await byOpenCvJs(pairs)))));
  const learned = recorded(pairs);
  for (const pair of pairs) {
    console.log(`  ${pair.name} ${pair.a} ${pair.b}`);
    for (const [what, found] of /** @type {const} */ ([
      ['ours, gradient', own],
      ['ours, auto', auto],
      ['SIFT', sift],
      ['SIFT, low T', many],
      ['ORB (js)', script],
      ['ALIKED', learned ?? { scores: [], entries: [] }],
    ])) {
      const figures = of(found, pair);
      if (figures) tell(what, figures.score, figures.entry);
    }
  }
  for (const [who, found] of /** @type {const} */ ([
    ['gradient', own],
    ['auto', auto],
  ])) {
    compare(who, 'SIFT', found, sift, pairs);
    compare(who, 'SIFT with a threshold of contrast so low that it has as many points', found, many, pairs);
    if (learned) compare(who, 'ALIKED', found, learned, pairs);
    shares(who, found);
  }
  if (!learned) console.log('  ALIKED: skipped, its recorded results are not there (TIEPOINT_ALIKED names their place)');
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) await rivals();
