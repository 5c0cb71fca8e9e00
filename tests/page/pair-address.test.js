/** The address of a pair of a block: it is opened, gone back to and loaded again like a view of the block. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { block, photos, status } from './blocks.js';
import { done, hosted, keptEdits, pair, part, says, SKIP } from './page.js';

hosted();

const FIRST = '#view=pair&image=photo_00000.png&image=photo_00001.png';
const OTHER = '#view=pair&image=photo_00003.png&image=photo_00004.png';

/** @param {import('playwright-core').Page} page @param {string} address */
const go = (page, address) =>
  page.evaluate((to) => {
    window.location.hash = to;
  }, address);

test('the address names the pair of a block, which it opens, and shows again after a reload; none is named of other photos', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  await go(page, FIRST);
  await says(page, 'name-left', /photo_00000/);
  await done(page);
  await says(page, 'of-block', /^photo_00000\.png – photo_00001\.png: connected/);
  assert.equal(new URL(page.url()).hash, FIRST);
  await part(page, 'back-to-block').click();
  await page.waitForFunction(() => window.location.hash.startsWith('#view=map'));
  await go(page, OTHER);
  await says(page, 'name-right', /photo_00004/);
  await done(page);
  assert.equal(new URL(page.url()).hash, OTHER);

  await page.waitForTimeout(1000);
  await page.reload();
  await says(page, 'of-block', /^photo_00003\.png – photo_00004\.png: connected/);
  await says(page, 'name-left', /photo_00003/);
  assert.ok(await part(page, 'back-to-block').isVisible());
  assert.equal(new URL(page.url()).hash, OTHER);
  // What the block does not have is not opened.
  await part(page, 'back-to-block').click();
  await go(page, '#view=pair&image=photo_00003.png&image=none.png');
  await part(page, 'mode-pair').click();
  await says(page, 'name-left', /photo_00003/);
  await pair(page);
  await says(page, 'name-left', /^left\.png/);
  assert.equal(new URL(page.url()).hash, '');
  assert.deepEqual(complaints, []);
  await close();
});

test('Back and Forward go between the views and pairs of a block, lose nothing, and leave from the first alone', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  const pages = () => page.evaluate(() => window.history.length);
  const before = await pages();
  const at = (/** @type {string} */ address) => page.waitForFunction((start) => window.location.hash.startsWith(start), address);
  const shows = (/** @type {string} */ view) =>
    page.waitForFunction((id) => document.querySelector(`[data-testid="${id}"]`)?.getAttribute('aria-pressed') === 'true', `block-show-${view}`);
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  await at('#view=map');
  // That a block is there is no page of its own; nor is what is chosen.
  await part(page, 'tab-block-images').click();
  const row = (/** @type {number} */ k) => page.locator('[data-testid="block-images"] tbody tr:not(.filler)').nth(k);
  for (const k of [0, 1, 2]) await row(k).click();
  await at('#view=map&image=photo_00002.png');
  assert.equal(await pages(), before);
  await part(page, 'block-show-matrix').click();
  await at('#view=matrix&image=photo_00002.png');
  await row(3).click();
  await part(page, 'block-show-images').click();
  await at('#view=images&image=photo_00003.png');
  assert.equal(await pages(), before + 2);

  await page.goBack();
  await shows('matrix');
  await says(page, 'block-chosen', /^photo_00003\.png/);
  await page.goBack();
  await shows('map');
  await says(page, 'block-chosen', /^photo_00002\.png/);
  await page.goForward();
  await shows('matrix');

  // An edit is no page, and is there on all of them.
  await row(4).click();
  await part(page, 'block-reject').click();
  await status(page, /: 5 of 6 images/);
  await go(page, FIRST);
  await says(page, 'of-block', /^photo_00000\.png – photo_00001\.png: connected/);
  await done(page);
  await part(page, 'back-to-block').click();
  await at('#view=matrix');
  await page.goBack();
  await at(FIRST);
  assert.ok(await part(page, 'back-to-block').isVisible());
  assert.match(await done(page), /matches/);
  await page.goBack();
  await shows('matrix');
  await status(page, /: 5 of 6 images/);
  assert.equal(await part(page, 'block-undo').isEnabled(), true);

  // The pages before are there after a reload, too.
  await keptEdits(page, 'block/edits', 1, 1);
  await page.reload();
  await status(page, /: 5 of 6 images.*Restored from this browser/);
  await shows('matrix');
  await page.goBack();
  await shows('map');
  await status(page, /: 5 of 6 images/);
  // A pair that is none of the block has no address, and is gone back to all the same.
  await part(page, 'mode-pair').click();
  await pair(page);
  await page.waitForFunction(() => window.location.hash === '');
  await page.goBack();
  await at('#view=map');
  assert.ok(await part(page, 'block-status').isVisible());
  await page.goForward();
  await says(page, 'name-left', /^left\.png/);
  assert.ok(await part(page, 'status').isVisible());
  await page.goBack();
  await shows('map');
  // The pair's part, where the page was opened.
  await page.goBack();
  await page.waitForFunction(() => document.body.dataset.mode === 'pair');
  await page.goBack();
  assert.equal(page.url(), 'about:blank');
  assert.deepEqual(complaints, []);
  await close();
});
