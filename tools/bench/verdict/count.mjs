/** The count of the verdicts by kind and by part, with what is asked of them. */

import { isOff, isOutside, isWrong } from './judge.mjs';

/** @typedef {import('../verdict.mjs').Outcome} Outcome */

const PARTS = /** @type {const} */ ({ fit: 'sites that chose thresholds', judge: 'sites that judge' });

/** @param {Outcome[]} outcomes */
export function count(outcomes) {
  table('all', outcomes);
  for (const [part, what] of Object.entries(PARTS)) {
    table(
      what,
      outcomes.filter(({ given }) => given.part === part),
    );
  }
  const times = outcomes.map(({ seconds }) => seconds).sort((a, b) => a - b);
  console.log(
    `${times.reduce((sum, s) => sum + s, 0).toFixed(0)} s of matching, median ${times[times.length >> 1]?.toFixed(1)} s, longest ${times.at(-1)?.toFixed(1)} s`,
  );
}

/** @param {string} what @param {Outcome[]} outcomes */
function table(what, outcomes) {
  if (outcomes.length === 0) return;
  const kinds = [...new Set(outcomes.map(({ given }) => given.kind))].sort();
  console.log(`${what}: ${new Set(outcomes.map(({ given }) => given.site)).size} sites`);
  console.log(row(['kind', 'pairs', 'oriented, right', 'oriented, wrong', 'weak, right', 'weak, wrong', 'not oriented']));
  for (const kind of kinds) {
    console.log(row([kind, ...counted(outcomes.filter(({ given }) => given.kind === kind))]));
  }
  console.log(row(['all', ...counted(outcomes)]));
  const [right, hard] = [true, false].map((isRight) => outcomes.filter(({ given }) => given.isRight === isRight));
  const oriented = (/** @type {Outcome[]} */ of) => of.filter(({ verdict }) => verdict === 'oriented');
  const off = (/** @type {(errors: NonNullable<Outcome['errors']>) => boolean} */ test) =>
    oriented(outcomes).filter(({ errors }) => errors && test(errors)).length;
  console.log(
    `${what}: ${oriented(right ?? []).length} of ${right?.length} right pairs called oriented (${share(oriented(right ?? []).length, right?.length ?? 0)}; asked: 95 %), ` +
      `${oriented(outcomes).filter(isWrongOutcome).length} wrong poses called oriented (asked: 0), ${oriented(hard ?? []).length} of ${hard?.length} others called oriented; ` +
      `of those called oriented that have a pose ${off(isOff)} are off by more than 1° (and what their truth may be off by), ${off(isOutside)} by more than their region of 99.9 %`,
  );
}

/** @param {Outcome} outcome */
const isWrongOutcome = ({ verdict, errors }) => verdict !== 'not_oriented' && isWrong(errors);

/** @param {Outcome[]} outcomes */
function counted(outcomes) {
  const of = (/** @type {string} */ verdict, /** @type {boolean} */ wrong) =>
    outcomes.filter((o) => o.verdict === verdict && isWrongOutcome(o) === wrong).length;
  return [outcomes.length, of('oriented', false), of('oriented', true), of('weak', false), of('weak', true), of('not_oriented', false)];
}

/** @param {(string | number)[]} cells */
const row = (cells) => `  ${cells.map((cell, k) => (k === 0 ? `${cell}`.padEnd(26) : `${cell}`.padStart(16))).join('')}`;

/** @param {number} part @param {number} whole */
const share = (part, whole) => `${((100 * part) / Math.max(1, whole)).toFixed(1)} %`;
