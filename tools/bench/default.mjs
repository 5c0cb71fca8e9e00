/**
 * What two photographs give whose owner sets nothing: `match_pair` without an option on every open pair with truth, and on simulated pairs of
 * all kinds; beside it two strategies alone, of which `moments` was the default once, and OpenCV. The verdicts are counted as they are given.
 *
 * `--only=TEXT` takes the pairs with the text in their set or name.
 */

import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { match_pair, message } from '../../pkg/node.js';
import { directionError, rotationError } from '../score.mjs';
import { allCases, pngOf } from './default/cases.mjs';
import { textOption } from './options.mjs';
import { byOpenCv, lacksOpenCv } from './rivals/posed.mjs';
import { errorsOf, inRegion, isOff, isWrong, overOf } from './verdict/judge.mjs';

/**
 * @typedef {import('../../pkg/node.js').PairSettings} PairSettings
 * @typedef {import('./default/cases.mjs').Case} Case
 * @typedef {{ verdict: 'oriented' | 'weak' | 'not_oriented' | null, hasPose: boolean, share: number, rotation: number, direction: number, isOff: boolean, isWrong: boolean, inErrors: number, isCovered: boolean | null, isExact: boolean }} Outcome
 *   verdict: null of OpenCV, which gives none; errors: NaN where there is no pose or none is known; isCovered: by the region of 95 %, null where there is none; isExact: the truth is no reconstruction itself
 */

/** @type {[string, import('../../pkg/node.js').Given<PairSettings>][]} */
const WAYS = [
  ['default', {}],
  ['gradient', { matching: { strategy: 'gradient' } }],
  ['moments', { matching: { strategy: 'moments' } }],
];
const OUTSIDE_REGION = 0.05;
const UNJUDGED = { rotation: NaN, direction: NaN, isOff: false, isWrong: false, inErrors: NaN, isCovered: null, isExact: false };

export async function byDefault() {
  console.log('Two photographs, nothing set (share of right matches; rotation and base direction error; rotation error by its total standard error; verdict)');
  const only = textOption('only') ?? '';
  const cases = allCases().filter(({ set, name }) => `${set}, ${name}`.includes(only));
  for (const [way, settings] of WAYS) {
    summaries(
      way,
      cases.map((given) => ({ given, outcome: run(way, given, settings) })),
    );
  }
  const reason = lacksOpenCv();
  if (reason) return console.log(`OpenCV: skipped, ${reason}`);
  const rival = await openCv(cases);
  summaries('OpenCV', rival);
}

/** @param {string} way @param {Case} given @param {import('../../pkg/node.js').Given<PairSettings>} settings @returns {Outcome} */
function run(way, given, settings) {
  const { left, right, input } = given.make();
  const start = performance.now();
  let output = null;
  let why = '';
  try {
    output = match_pair(left, right, input, settings);
    if (output.no_orientation) why = message('no_orientation', output.no_orientation);
  } catch (error) {
    // Input that contradicts itself is refused, which is a verdict.
    if (!(error instanceof Error && error.name === 'TiepointError')) throw error;
    why = error.message;
  }
  const seconds = (performance.now() - start) / 1000;
  left.free();
  right.free();
  const { orientation = null } = output ?? {};
  /** @type {Outcome} */
  const outcome = {
    verdict: output?.verdict.kind ?? 'not_oriented',
    hasPose: orientation !== null,
    share: output ? given.share(output.match.matches) : 0,
    ...(orientation && given.pose ? judged(orientation, given.pose) : UNJUDGED),
  };
  const matches = output?.match.counts.matches ?? 0;
  console.log(`  ${way}, ${told(given, matches, outcome)}; ${outcome.inErrors.toFixed(1)}; ${outcome.verdict}${why && `: ${why}`}, ${seconds.toFixed(1)} s`);
  return outcome;
}

/** @param {import('../../pkg/node.js').RelativeOrientation} orientation @param {import('./data.mjs').TruePose} truth */
function judged(orientation, truth) {
  const errors = errorsOf(orientation, truth);
  const { omega_deg, phi_deg, kappa_deg } = orientation.total_standard_errors ??
    orientation.standard_errors ?? { omega_deg: NaN, phi_deg: NaN, kappa_deg: NaN };
  return {
    rotation: errors.rotation_deg,
    direction: errors.direction_deg,
    isOff: isOff(errors),
    isWrong: isWrong(errors),
    inErrors: errors.rotation_deg / Math.hypot(omega_deg, phi_deg, kappa_deg),
    isCovered: orientation.half_widths_95 ? inRegion(orientation, truth, OUTSIDE_REGION) <= 1 : null,
    isExact: truth.uncertain === undefined,
  };
}

/** @param {Case} given @param {number} matches @param {Outcome} outcome */
const told = ({ set, name }, matches, { share, rotation, direction }) =>
  `${set}, ${name}: ${matches} matches, ${share.toFixed(3)}; ${rotation.toFixed(3)} deg, ${direction.toFixed(2)} deg`;

/** @param {Case[]} cases */
async function openCv(cases) {
  const folder = mkdtempSync(join(tmpdir(), 'tiepoint-default-'));
  try {
    const found = await byOpenCv(cases.map((given, k) => job(given, join(folder, String(k)))));
    return cases.map((given, k) => {
      const { matches = [], rotation = null, direction = null } = found[k]?.[0] ?? {};
      const flat = Float64Array.from(matches.flatMap((match) => [...match, 0]));
      const pose = rotation && direction && given.pose ? { pose: given.pose, rotation, direction } : null;
      const outcome = { ...UNJUDGED, verdict: null, hasPose: rotation !== null, share: given.share(flat), ...(pose && byPose(pose)) };
      console.log(`  OpenCV, ${told(given, matches.length, outcome)}`);
      return { given, outcome };
    });
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** @param {{ pose: import('./data.mjs').TruePose, rotation: number[][], direction: number[] }} found */
function byPose({ pose, ...found }) {
  const [rotation, direction] = [rotationError(found.rotation, pose.rotation), directionError(found.direction, pose.direction)];
  return { rotation, direction, isOff: overOf(rotation, direction, pose) > 0 };
}

/** @param {Case} given @param {string} at where images are written that are in no file @returns {import('./rivals/posed.mjs').Job} */
function job(given, at) {
  const made = given.make();
  const [left, right] = given.files ?? [`${at}-left.png`, `${at}-right.png`];
  if (!given.files) {
    writeFileSync(left, pngOf(made.left));
    writeFileSync(right, pngOf(made.right));
  }
  const cameras = given.lenses(made);
  made.left.free();
  made.right.free();
  return { left, right, cameras: [cameras] };
}

/** @param {string} way @param {{ given: Case, outcome: Outcome }[]} all */
function summaries(way, all) {
  for (const set of new Set(all.map(({ given }) => given.set))) {
    const of = all.filter(({ given }) => given.set === set);
    const outcomes = of.map(({ outcome }) => outcome);
    const judgeable = of.filter(({ given, outcome }) => given.pose && outcome.hasPose).map(({ outcome }) => outcome);
    console.log(`${way}, ${set}: ${counts(outcomes, judgeable)}; ${medians(outcomes, judgeable)}`);
  }
}

/** @param {Outcome[]} outcomes @param {Outcome[]} judgeable those with a pose beside a known one */
function counts(outcomes, judgeable) {
  const off = `${judgeable.filter((o) => o.isOff).length} poses off by more than 1°`;
  if (outcomes.every(({ verdict }) => verdict === null)) return `${outcomes.filter((o) => o.hasPose).length} of ${outcomes.length} have a pose; ${off}`;
  const of = (/** @type {Outcome['verdict']} */ verdict) => outcomes.filter((o) => o.verdict === verdict);
  const wrong = of('oriented').filter((o) => o.isWrong).length;
  return `of ${outcomes.length} ${of('oriented').length} oriented (${wrong} of these wrong), ${of('weak').length} weak, ${of('not_oriented').length} not oriented; ${off}`;
}

/** Of those with a pose, but for the share of those that have matches.  @param {Outcome[]} outcomes @param {Outcome[]} judgeable */
function medians(outcomes, judgeable) {
  const median = (/** @type {number[]} */ values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)] ?? NaN;
  const errors = judgeable.every((o) => o.isCovered === null)
    ? ''
    : `, rotation error by its standard error ${median(judgeable.map((o) => o.inErrors)).toFixed(2)}; the region of 95 % holds ${held(judgeable)}, where the truth is exact ${held(judgeable.filter((o) => o.isExact))}`;
  return (
    `medians: share ${median(outcomes.filter((o) => o.hasPose).map((o) => o.share)).toFixed(3)}, rotation ${median(judgeable.map((o) => o.rotation)).toFixed(3)} deg, ` +
    `base direction ${median(judgeable.map((o) => o.direction)).toFixed(2)} deg${errors}`
  );
}

/** How many regions hold the truth.  @param {Outcome[]} outcomes */
function held(outcomes) {
  const stated = outcomes.filter((o) => o.isCovered !== null);
  return `${stated.filter((o) => o.isCovered).length} of ${stated.length}`;
}
