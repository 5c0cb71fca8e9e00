/** What a reload shows stands in the storage already: nothing is written as long as nothing was done. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { block, photos, status } from './blocks.js';
import { done, hosted, keptEdits, open, pair, part, partsNamed, says, SKIP, until } from './page.js';

hosted('/kept-same/');

/** @typedef {import('playwright-core').Page} Page */

/** From the next load on each part that is written is counted, by its name.  @param {Page} page */
const count = (page) =>
  page.addInitScript(() => {
    /** @type {string[]} */
    const names = [];
    Object.assign(window, { names });
    const put = IDBObjectStore.prototype.put;
    IDBObjectStore.prototype.put = function (/** @type {any[]} */ ...given) {
      if (this.name !== 'projects') names.push(`${given[0]?.part}`);
      return Reflect.apply(put, this, given);
    };
  });

/** The parts that were written since the page was loaded, once it had the time for it.  @param {Page} page @returns {Promise<string[]>} */
async function written(page) {
  await page.waitForTimeout(2500);
  return page.evaluate(() => /** @type {any} */ (window).names);
}

test('a pair that is shown again is not written again', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  await until(page, 'the pair is kept', async () => (await partsNamed(page, 'pair/result')) === 1);
  await count(page);
  for (const time of ['first', 'second']) {
    await page.reload();
    await says(page, 'status', /Restored from this browser/);
    await done(page);
    assert.deepEqual(await written(page), [], time);
  }
  // With an edit too.
  await part(page, 'view').focus();
  await page.keyboard.press('n');
  await page.keyboard.press('Delete');
  await until(page, 'the edit is kept', async () => (await partsNamed(page, 'pair/edits')) > 0);
  await page.reload();
  await says(page, 'status', /Restored from this browser/);
  await done(page);
  assert.deepEqual(await written(page), []);
  assert.deepEqual(complaints, []);
  await close();
});

test('a block that is shown again is not written again, with edits neither', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation)/);
  await until(page, 'the block is kept', async () => (await partsNamed(page, 'block/shown')) === 1);
  await count(page);
  await page.reload();
  await status(page, /Restored from this browser/);
  assert.deepEqual(await written(page), []);
  await part(page, 'block-show-map').click();
  await part(page, 'block-map').focus();
  await page.keyboard.press('n');
  await page.keyboard.press('Delete');
  await keptEdits(page, 'block/edits', 1, 1);
  await page.reload();
  await status(page, /Restored from this browser/);
  assert.deepEqual(await written(page), []);
  assert.deepEqual(complaints, []);
  await close();
});

test('images that were placed on an orthophoto are not written again', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await part(page, 'block-place-first').click();
  await says(page, 'block-status', /^4 of 4 images placed\./);
  await until(page, 'what was placed is kept', async () => (await partsNamed(page, 'block/placed/')) === 4);
  await count(page);
  await page.reload();
  await status(page, /Restored from this browser/);
  assert.deepEqual(await written(page), []);
  assert.deepEqual(complaints, []);
  await close();
});
