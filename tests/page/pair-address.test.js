/** The address of a pair of a block: it is opened, gone back to and loaded again like a view of the block. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { block, photos, status } from './blocks.js';
import { done, hosted, pair, part, says, SKIP } from './page.js';

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
