/** The states that edits lead through, as the page shows and keeps them: of which one it must come back with after a crash. */

import { journal } from '../../tests/page/page.js';

/** @typedef {import('playwright-core').Page} Page */
/** What the page shows: the names of its edits, those that are undone too, how many hold, and whether an image is masked. @typedef {{ names: string[], held: number, masked: boolean }} State */
/** A state, when it was seen, and the edits that were kept of it, as far as they were looked at. @typedef {{ state: State, key: string, at: number, kept: string | null }} Seen */

/** An edit that has been on the screen for as long is kept, the page promises. */
const KEPT_AFTER_MS = 1000;
/** So often the page is looked at, and its storage every so many times. */
const LOOK_MS = 40;
const STORAGE = 4;

/** Null before the page shows edits.  @param {Page} page @param {string} history @returns {Promise<State | null>} */
export const stateOf = (page, history) =>
  page.evaluate((of) => {
    const entries = [...document.querySelectorAll(`[data-testid="${of}"] [data-testid^="${of}-"]`)];
    const held = entries.find((entry) => entry.hasAttribute('aria-current'));
    if (held === undefined) return null;
    const numberOf = (/** @type {Element} */ entry) => Number(entry.getAttribute('data-testid')?.slice(of.length + 1));
    const masked = document.querySelector('[data-testid="unmask-left"]')?.checkVisibility() === true;
    return { names: entries.slice(1).map(({ textContent }) => textContent), held: numberOf(held), masked };
  }, history);

/** @param {State} state */
const keyOf = (state) => JSON.stringify(state);

/** Sees the states of a page until it crashes.  @param {Page} page @param {string} history @param {string} name of the journal @param {{ isOver: boolean }} ending @param {Seen[]} seen */
export async function watch(page, history, name, ending, seen) {
  for (let look = 0; !ending.isOver; look += 1) {
    const state = await stateOf(page, history);
    if (state !== null && !ending.isOver) {
      const key = keyOf(state);
      if (seen.at(-1)?.key !== key) seen.push({ state, key, at: performance.now(), kept: null });
    }
    if (look % STORAGE === 0) await lookIntoStorage(page, history, name, seen);
    await page.waitForTimeout(LOOK_MS);
  }
}

/** Notes of the latest state that it is kept, where it is. A mask is kept beside the edits.  @param {Page} page @param {string} history @param {string} name @param {Seen[]} seen */
async function lookIntoStorage(page, history, name, seen) {
  const last = seen.at(-1);
  const { edits, done } = await journal(page, name);
  const now = await stateOf(page, history);
  if (last === undefined || now === null || keyOf(now) !== last.key || now.masked !== seen[0]?.state.masked) return;
  if (done === now.held && edits.length === now.names.length) last.kept = JSON.stringify(edits);
}

/** The first state that the page may come back with: the last one that was kept, or was seen long enough before it crashed.  @param {readonly Seen[]} seen @param {number} at when */
export function acknowledged(seen, at) {
  return seen.reduce((first, one, i) => (one.kept !== null || at - one.at > KEPT_AFTER_MS ? i : first), 0);
}

/** How often which kind of step led from one state to the next, by the first words of their names.  @param {readonly Seen[]} seen @param {Map<string, number>} counts */
export function countKinds(seen, counts) {
  seen.slice(1).forEach(({ state }, i) => {
    const before = seen[i]?.state ?? state;
    const isSame = before.names.length === state.names.length && before.names.every((name, k) => name === state.names[k]);
    const made = state.names[state.held - 1]?.split(' ')[0] ?? '';
    const kind = before.masked !== state.masked ? 'mask' : state.held < before.held ? 'undo' : isSame ? 'redo' : made;
    counts.set(kind, (counts.get(kind) ?? 0) + 1);
  });
}

/** What is wrong with the state after a crash; empty where nothing is.  @param {readonly Seen[]} seen @param {number} first @param {State} state @param {string} kept its edits */
export function wrongWith(seen, first, state, kept) {
  const key = keyOf(state);
  const found = seen.slice(first).filter((one) => one.key === key);
  const last = seen.at(-1)?.state;
  if (found.length === 0)
    return last !== undefined && isNext(last, state) ? '' : `${key} in place of ${seen.at(-1)?.key ?? ''} or one since ${seen[first]?.key ?? ''}`;
  const looked = found.flatMap((one) => one.kept ?? []);
  return looked.length === 0 || looked.includes(kept) ? '' : `other edits by the same names: ${kept} in place of ${looked.at(-1) ?? ''}`;
}

/** Whether one step leads from a state to the other: the page crashed before it was seen.  @param {State} last @param {State} next */
function isNext(last, next) {
  const isSame = (/** @type {number} */ count) => last.names.slice(0, count).every((name, i) => name === next.names[i]);
  const isNew = next.names.length === last.held + 1 && next.held === last.held + 1 && isSame(last.held);
  const isGone = next.names.length === last.names.length && isSame(last.names.length) && Math.abs(next.held - last.held) <= 1;
  return isNew || isGone;
}
