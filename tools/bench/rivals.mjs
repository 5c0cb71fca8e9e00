/** The multi-scale strategy beside its rivals on pairs with known truth: OpenCV's SIFT natively, and OpenCV.js from npm. */

import { writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { kept, missing, nativeSift, scores } from './rivals/opencv.mjs';
import { byOpenCvJs } from './rivals/opencvjs.mjs';
import { ours } from './rivals/ours.mjs';
import { knownPairs } from './rivals/pairs.mjs';

/** @param {number | null | undefined} value @param {number} digits */
const figure = (value, digits) => (value === null || value === undefined ? '-' : value.toFixed(digits));

/** @param {number[]} values */
function median(values) {
  const sorted = values.toSorted((a, b) => a - b);
  return ((sorted[(sorted.length - 1) >> 1] ?? NaN) + (sorted[sorted.length >> 1] ?? NaN)) / 2;
}

/** @param {string} what @param {import('./rivals/opencv.mjs').Score} score @param {import('./rivals/ours.mjs').Entry} entry */
function tell(what, score, { seconds, points, note }) {
  const times = ['features', 'matching', 'geometry'].map((part) => `${part} ${figure(seconds[part], 3)} s`).join(', ');
  const errors = `rotation ${figure(score.rotation_error_deg, 3)}°, direction ${figure(score.direction_error_deg, 3)}°`;
  console.log(
    `    ${what.padEnd(12)} ${(points ?? []).join(' and ')} points, right ${score.right ?? '-'} of ${score.matches} (${figure(score.share, 3)}), ${errors}; ${times}${note ? `; ${note}` : ''}`,
  );
}

/** @typedef {{ scores: import('./rivals/opencv.mjs').Score[], entries: import('./rivals/ours.mjs').Entry[] }} Rival */

/** The figures of a pair.  @param {Rival} rival @param {import('./rivals/pairs.mjs').Pair} pair */
function of({ scores, entries }, { name, a, b }) {
  const k = entries.findIndex((entry) => entry.case === name && entry.a === a && entry.b === b);
  const [score, entry] = [scores[k], entries[k]];
  return score && entry ? { score, entry } : null;
}

/** What ours is by a rival's, over all pairs.  @param {string} what @param {Rival} own @param {Rival} rival @param {import('./rivals/pairs.mjs').Pair[]} pairs */
function compare(what, own, rival, pairs) {
  const both = pairs.flatMap((pair) => {
    const [mine, theirs] = [of(own, pair), of(rival, pair)];
    return mine && theirs ? [{ mine, theirs }] : [];
  });
  const right = both.map(({ mine, theirs }) => (mine.score.right ?? 0) / Math.max(1, theirs.score.right ?? 0));
  const times = both.map(({ mine, theirs }) => (mine.entry.seconds.features ?? NaN) / (theirs.entry.seconds.features ?? NaN));
  console.log(
    `  ours by ${what}: right matches median ${median(right).toFixed(2)}, least ${Math.min(...right).toFixed(2)}; features' time median ${median(times).toFixed(2)}, most ${Math.max(...times).toFixed(2)}`,
  );
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

/** `--fresh` measures the rivals again; without it what they were is kept in target/bench. */
export async function rivals(fresh = process.argv.includes('--fresh')) {
  const reason = missing();
  const pairs = knownPairs();
  if (reason || pairs.length === 0) return console.log(`rivals: skipped, ${reason ?? 'no pairs with truth are there'}`);
  console.log(
    'Rivals (ours: wasm in Node, warm; SIFT: OpenCV natively; ORB: OpenCV.js, which has neither SIFT nor the essential matrix; one thread each, at most 10,000 points)',
  );
  const rival = (/** @type {string} */ name, /** @type {import('./rivals/ours.mjs').Entry[]} */ entries) => ({ entries, scores: scores(name, entries) });
  const own = rival('ours', pairs.map(ours));
  const sift = rival('sift', await nativeSift(false, fresh));
  const many = rival('sift-many', await nativeSift(true, fresh));
  const script = rival('opencvjs', await kept('opencvjs', fresh, async (file) => writeFileSync(file, JSON.stringify(await byOpenCvJs(pairs)))));
  for (const pair of pairs) {
    console.log(`  ${pair.name} ${pair.a} ${pair.b}`);
    for (const [what, found] of /** @type {const} */ ([
      ['ours', own],
      ['SIFT', sift],
      ['SIFT, low T', many],
      ['ORB (js)', script],
    ])) {
      const figures = of(found, pair);
      if (figures) tell(what, figures.score, figures.entry);
    }
  }
  compare('SIFT', own, sift, pairs);
  compare('SIFT with a threshold of contrast so low that it has as many points', own, many, pairs);
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) await rivals();
