/** The browser's Back between pair and block: each view is one step, with a block and without one. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { photos, status } from './blocks.js';
import { done, hosted, open, pair, part, says, SKIP } from './page.js';

hosted('/going-back/');

/** @typedef {import('playwright-core').Page} Page */

/** Waits until a part of the page is shown.  @param {Page} page @param {'pair' | 'block'} mode */
const shows = (page, mode) => page.waitForFunction((wanted) => document.body.dataset.mode === wanted, mode);

/** Waits until the address begins so.  @param {Page} page @param {string} start */
const at = (page, start) => page.waitForFunction((wanted) => window.location.hash.startsWith(wanted), start);

/** How many pages the browser can go back and on to.  @param {Page} page */
const pages = (page) => page.evaluate(() => window.history.length);

test('Back after pair, block and pair shows the block, then the pair, though no block is there, and leaves from the first', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await part(page, 'status').waitFor();
  const before = await pages(page);
  for (const mode of /** @type {const} */ (['block', 'pair'])) {
    await part(page, `mode-${mode}`).click();
    await shows(page, mode);
    // Once more is no step, nor is the way to the images by the keyboard.
    await part(page, `mode-${mode}`).click();
    await page.locator('.skip').focus();
    await page.keyboard.press('Enter');
    assert.equal(await page.evaluate(() => document.activeElement?.closest('#view, #block-view')?.id), mode === 'pair' ? 'view' : 'block-view');
  }
  assert.equal(await pages(page), before + 2);
  assert.equal(new URL(page.url()).hash, '');
  await page.goBack();
  await shows(page, 'block');
  await page.goBack();
  await shows(page, 'pair');
  await page.goForward();
  await shows(page, 'block');
  // A reload is no step.
  await page.reload();
  await part(page, 'status').waitFor();
  assert.equal(await pages(page), before + 2);
  await page.goBack();
  await page.goBack();
  assert.equal(page.url(), 'about:blank');
  assert.deepEqual(complaints, []);
  await close();
});

test('Back after pair, block and pair shows what was there, over a reload too, and after New nothing that is gone', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  const before = await pages(page);
  await part(page, 'mode-block').click();
  await photos(page);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): /);
  await at(page, '#view=map');
  await part(page, 'block-show-matrix').click();
  await part(page, 'mode-pair').click();
  await shows(page, 'pair');
  assert.equal(await pages(page), before + 3);
  await page.goBack();
  await shows(page, 'block');
  await at(page, '#view=matrix');
  await page.waitForTimeout(1000);
  await page.reload();
  await status(page, /Restored from this browser/);
  await at(page, '#view=matrix');
  assert.equal(await pages(page), before + 3);
  await page.goBack();
  await at(page, '#view=map');
  await page.goBack();
  await shows(page, 'pair');
  await says(page, 'name-left', /^left\.png/);
  // Back twice while a pair is being opened: it is not shown over what was gone to.
  await page.evaluate(() => {
    window.location.hash = '#view=pair&image=photo_00000.png&image=photo_00001.png';
  });
  await says(page, 'name-left', /^photo_00000/);
  await done(page);
  await part(page, 'back-to-block').click();
  await at(page, '#view=map');
  await page.evaluate(() => {
    window.location.hash = '#view=pair&image=photo_00003.png&image=photo_00004.png';
    setTimeout(() => window.history.back(), 20);
  });
  await says(page, 'name-left', /^photo_00003/);
  await shows(page, 'block');
  await at(page, '#view=map');
  await page.goBack();
  await says(page, 'name-left', /^photo_00000/);
  await shows(page, 'pair');
  await at(page, '#view=pair&image=photo_00000.png');

  await part(page, 'anew').click();
  await page.waitForFunction(() => window.location.hash === '');
  await says(page, 'name-left', /^$/);
  await page.goBack();
  await shows(page, 'pair');
  await page.goForward();
  await page.goForward();
  await shows(page, 'block');
  await page.waitForFunction(() => window.location.hash === '');
  assert.equal(await part(page, 'block-welcome').isVisible(), true);
  assert.deepEqual(complaints, []);
  await close();
});
