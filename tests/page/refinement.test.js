/** The refinement of a block's rays, in the page. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { photos } from './blocks.js';
import { enabled, hosted, number, open, part, SKIP } from './page.js';

hosted('/refinement/');

const FLIGHT = { strips: 2, exposures: 2, width_px: 480, height_px: 360, pixel_mm: 0.12 };

test('rays are refined unless it is chosen otherwise, and the page tells how many and why not all', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  const status = (/** @type {string} */ pattern) =>
    page.waitForFunction((source) => new RegExp(source).test(document.querySelector('[data-testid="block-status"]')?.textContent ?? ''), pattern);
  await part(page, 'mode-block').click();
  await enabled(page, 'block-simulate');
  await photos(page, FLIGHT);
  await part(page, 'block-run').click();
  await status('^(Oriented|Weak orientation): .*\\. 4 images');
  const [refined = 0, all = 0] = ((await part(page, 'block-refined').textContent()) ?? '')
    .replaceAll(/[^\d ]/g, '')
    .trim()
    .split(/\s+/)
    .map(Number);
  assert.ok(refined > 0.5 * all && refined <= all, `${refined} of ${all}`);
  assert.match((await part(page, 'stage-windows').textContent()) ?? '', /4 of 4/);
  const after = await number(page, 'block-rmse');

  await part(page, 'tab-block-settings').click();
  await page.locator('select[data-key="refinement.method"]').selectOption('none');
  await part(page, 'block-run').click();
  await page.waitForFunction(() => document.querySelector('[data-testid="block-refined"]') === null);
  await status('^(Oriented|Weak orientation): .*\\. 4 images');
  assert.ok((await number(page, 'block-rmse')) > after);
  assert.deepEqual(complaints, []);
  await close();
});
