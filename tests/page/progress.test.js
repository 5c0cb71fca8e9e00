/** What the page shows while a block is run. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { block, photos, status } from './blocks.js';
import { hosted, part, SKIP } from './page.js';

hosted();

/** @typedef {{ label: string, said: string, value: number, max: number, isSeen: boolean, canCancel: boolean }} Looked how the bar was */

/** Notes from now on how the bar changes.  @param {import('playwright-core').Page} page */
const note = (page) =>
  page.evaluate(() => {
    const bar = /** @type {HTMLProgressElement} */ (document.querySelector('[data-testid="block-bar"]'));
    const cancel = /** @type {HTMLButtonElement} */ (document.querySelector('[data-testid="block-cancel"]'));
    /** @type {Looked[]} */
    const seen = [];
    Object.assign(window, { looked: seen });
    new MutationObserver(() =>
      seen.push({
        label: bar.getAttribute('aria-label') ?? '',
        said: bar.getAttribute('aria-valuetext') ?? '',
        value: bar.value,
        max: bar.max,
        isSeen: bar.checkVisibility({ visibilityProperty: true }),
        canCancel: cancel.checkVisibility() && !cancel.disabled,
      }),
    ).observe(bar, { attributes: true });
  });

test('a bar beside Cancel shows how many images and pairs of a run are done, and goes away with it', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await photos(page);
  const bar = part(page, 'block-bar');
  assert.equal(await bar.isVisible(), false);
  await note(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  const looked = /** @type {Looked[]} */ (await page.evaluate(() => Object(window).looked)).filter(({ isSeen }) => isSeen);
  for (const [label, most] of /** @type {const} */ ([
    ['Images: features', 6],
    ['Pairs: matches', 15],
  ])) {
    const own = looked.filter((one) => one.label === label);
    assert.ok(own.length > 1, `${label} moves: ${JSON.stringify(looked)}`);
    for (const { max, value, said, canCancel } of own) {
      assert.equal(max, most);
      assert.equal(said, `${value} of ${most}`);
      assert.ok(canCancel);
    }
    assert.ok(own.every(({ value }, i) => value >= (own[i - 1]?.value ?? 0)));
  }
  assert.equal(await bar.isVisible(), false);
  assert.deepEqual(complaints, []);
  await close();
});
