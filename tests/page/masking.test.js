/** Areas of the pictures that are masked by mouse and by keyboard: they hold no points, and are kept, undone and saved. */

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { Photo } from '../../pkg/node.js';
import { again, done, hosted, open, pair, part, saved, says, SHOTS, SKIP, SMALL } from './page.js';

hosted();

/** @typedef {import('playwright-core').Page} Page */

/** Draws round an area of the left picture; corners as shares of it, from its middle.  @param {Page} page @param {readonly (readonly [number, number])[]} corners */
async function drawRound(page, corners) {
  const box = await part(page, 'pane-left').boundingBox();
  assert.ok(box);
  const at = (/** @type {readonly [number, number]} */ [x, y]) =>
    /** @type {const} */ ([box.x + box.width / 2 + x * box.width, box.y + box.height / 2 + y * box.height]);
  const [first, ...others] = corners;
  assert.ok(first);
  await page.mouse.move(...at(first));
  await page.mouse.down();
  for (const corner of others) await page.mouse.move(...at(corner), { steps: 8 });
  await page.mouse.up();
}

/** What the page knows.  @param {Page} page @returns {Promise<any>} */
const everything = async (page) => JSON.parse((await saved(page, 'export-json')).toString());

/** The mask of the left image, as the button saves it.  @param {Page} page */
async function savedMask(page) {
  const [download] = await Promise.all([page.waitForEvent('download'), part(page, 'mask-save').click()]);
  assert.equal(download.suggestedFilename(), 'left-mask-left.png');
  return Photo.decode(readFileSync(await download.path()));
}

test('an area that is drawn round holds no points; it is kept, saved, unmasked in part and undone', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await pair(page);
  const before = await everything(page);
  await part(page, 'tool-mask').click();
  assert.ok(await part(page, 'mask-area').isDisabled());
  await says(page, 'mask-text', /^Draw round an area/);
  await drawRound(page, [
    [-0.2, -0.2],
    [0, -0.2],
    [0, 0.2],
    [-0.2, 0.2],
  ]);
  await says(page, 'mask-text', /^An area of \d+ corners: mask it/);
  await page.screenshot({ path: join(SHOTS, 'masking.png') });
  await page.keyboard.press('k');
  await part(page, 'unmask-left').waitFor();
  await again(page);
  const mask = await savedMask(page);
  assert.deepEqual([mask.width, mask.height], [SMALL.width_px, SMALL.height_px]);
  const grey = mask.grey();
  const masked = grey.reduce((sum, value) => sum + Number(value === 0), 0);
  assert.ok(masked > 1000 && masked < 0.6 * grey.length, `${masked}`);
  const after = await everything(page);
  assert.equal(after.images.left.mask, 'left-mask-left.png');
  const inside = (/** @type {any} */ { points }) =>
    points.left.filter((/** @type {number[]} */ [x = 0, y = 0]) => grey[Math.floor(y) * mask.width + Math.floor(x)] === 0).length;
  assert.ok(inside(before) > 20, `${inside(before)}`);
  assert.equal(inside(after), 0);
  // A part of it holds points again.
  await drawRound(page, [
    [-0.1, -0.1],
    [0.1, -0.1],
    [0.1, 0.1],
    [-0.1, 0.1],
  ]);
  await part(page, 'unmask-area').click();
  await again(page);
  const smaller = (await savedMask(page)).grey().reduce((sum, value) => sum + Number(value === 0), 0);
  assert.ok(smaller < masked && smaller > 0, `${smaller} of ${masked}`);
  await part(page, 'mask-undo').click();
  await again(page);
  assert.deepEqual((await savedMask(page)).grey(), grey);
  assert.equal(await part(page, 'mask-redo').getAttribute('aria-label'), 'Redo: unmask an area');
  // After a reload it is there as it was.
  await page.reload();
  await done(page);
  assert.equal((await everything(page)).images.left.mask, 'left-mask-left.png');
  assert.deepEqual((await everything(page)).points, after.points);
  assert.deepEqual(complaints, []);
  await close();
});

test('an area is outlined by keys alone, and given up', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true });
  await pair(page);
  await part(page, 'view').focus();
  await page.keyboard.press('w');
  const move = async (/** @type {string[]} */ ...keys) => {
    for (const key of keys) await page.keyboard.press(key);
    await page.keyboard.press('Enter');
  };
  await move();
  await says(page, 'mask-text', /^One corner/);
  await move('ArrowRight', 'ArrowRight');
  assert.ok(await part(page, 'mask-area').isDisabled());
  await move('ArrowDown', 'ArrowDown');
  await move('ArrowLeft');
  await page.keyboard.press('Backspace');
  await says(page, 'mask-text', /^An area of 3 corners/);
  await page.keyboard.press('Escape');
  await says(page, 'mask-text', /^Draw round/);
  await move();
  await move('ArrowRight', 'ArrowRight');
  await move('ArrowDown', 'ArrowDown');
  await page.keyboard.press('k');
  await part(page, 'unmask-left').waitFor();
  await again(page);
  await part(page, 'mask-undo').click();
  await part(page, 'unmask-left').waitFor({ state: 'hidden' });
  await page.keyboard.press('Escape');
  assert.ok(await part(page, 'masking').isHidden());
  assert.deepEqual(complaints, []);
  await close();
});
