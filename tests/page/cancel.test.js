/** How long it takes to cancel a run of a block, whatever it does. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { block, photos, status } from './blocks.js';
import { hosted, part, SKIP } from './page.js';

hosted();

/** What a user takes for at once, in ms; doubled, as two tests share the machine. */
const AT_ONCE_MS = 2 * 100;

/** No machine is so slow that the page may stand still for longer, in ms. */
const FROZEN_MS = 5_000;

/** How often the page looks at the time while it waits, in ms. */
const TURN_MS = 10;

/**
 * Presses Cancel, and waits until the page says that the run has ended.
 * A machine that others use gives the page its turns late: what the page itself lets pass are the turns that it had.
 * @param {import('playwright-core').Page} page @returns {Promise<{ waited: number, passed: number }>} turns and clock, in ms
 */
const timed = (page) =>
  page.evaluate(
    (turn) =>
      new Promise((resolve) => {
        const line = document.querySelector('[data-testid="block-status"]');
        const started = performance.now();
        let turns = 0;
        const clock = setInterval(() => (turns += 1), turn);
        const ended = () => {
          if (!/^Cancelled/.test(line?.textContent ?? '')) return;
          clearInterval(clock);
          resolve({ waited: turns * turn, passed: performance.now() - started });
        };
        if (line) new MutationObserver(ended).observe(line, { childList: true, characterData: true, subtree: true });
        /** @type {HTMLButtonElement | null} */ (document.querySelector('[data-testid="block-cancel"]'))?.click();
      }),
    TURN_MS,
  );

test('a block is cancelled at once, whatever its workers do', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await photos(page);
  /** @type {{ waited: number, passed: number }[]} */
  const times = [];
  // While features are detected, pairs are matched, and anew from what was kept. A busy machine may hold one of them up.
  for (const stage of [
    /^Images: features[1-5] of 6|^Images: features: [1-5] of 6/,
    /^(Images: features|Pairs: matches)/,
    /^(Images|Pairs|Similarity|Tie points|Orientation)/,
  ]) {
    await part(page, 'block-run').click();
    await status(page, stage);
    times.push(await timed(page));
    await status(page, /^Cancelled/);
  }
  const said = JSON.stringify(times);
  assert.ok(Math.min(...times.map(({ waited }) => waited)) < AT_ONCE_MS, said);
  assert.ok(Math.min(...times.map(({ passed }) => passed)) < FROZEN_MS, said);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  assert.deepEqual(complaints, []);
  await close();
});
