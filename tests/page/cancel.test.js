/** How long it takes to cancel a run of a block, whatever it does. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { block, photos, status } from './blocks.js';
import { hosted, part, SKIP } from './page.js';

hosted();

/** What a user takes for at once, in ms; doubled, as two tests share the machine. */
const AT_ONCE_MS = 2 * 100;

/** Presses Cancel; the time until the page says that the run has ended, in ms.  @param {import('playwright-core').Page} page */
const timed = (page) =>
  page.evaluate(
    () =>
      new Promise((resolve) => {
        const line = document.querySelector('[data-testid="block-status"]');
        const started = performance.now();
        const ended = () => /^Cancelled/.test(line?.textContent ?? '') && resolve(performance.now() - started);
        if (line) new MutationObserver(ended).observe(line, { childList: true, characterData: true, subtree: true });
        /** @type {HTMLButtonElement | null} */ (document.querySelector('[data-testid="block-cancel"]'))?.click();
      }),
  );

test('a block is cancelled at once, whatever its workers do', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await photos(page);
  /** @type {number[]} */
  const times = [];
  // While features are detected, pairs are matched, and anew from what was kept. A busy machine may hold one of them up.
  for (const stage of [
    /^Images: features[1-5] of 6|^Images: features: [1-5] of 6/,
    /^(Images: features|Pairs: matches)/,
    /^(Images|Pairs|Similarity|Tie points|Orientation)/,
  ]) {
    await part(page, 'block-run').click();
    await status(page, stage);
    times.push(Number(await timed(page)));
    await status(page, /^Cancelled/);
  }
  assert.ok(Math.min(...times) < AT_ONCE_MS, `${times.map((time) => time.toFixed(0)).join(', ')} ms`);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  assert.deepEqual(complaints, []);
  await close();
});
