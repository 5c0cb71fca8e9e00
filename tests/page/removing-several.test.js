/** Several images are chosen in their table and taken out of a finished block in one step. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { block, FLIGHT, status } from './blocks.js';
import { hosted, part, says, SKIP, upload } from './page.js';
import { blockPhotos } from './rendered.js';

hosted('/removing-several/');

test('images that are chosen together are removed in one step, which is undone', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block({ options: { viewport: { width: 1366, height: 768 } } });
  await part(page, 'block-files-input').setInputFiles(blockPhotos(FLIGHT).map(({ name, bytes }) => upload(name, bytes, 'image/png')));
  await status(page, /6 images in the block/);
  await part(page, 'block-run').click();
  await status(page, /^(Oriented|Weak orientation): 6 of 6 images/);
  const row = (/** @type {number} */ image) => page.locator('[data-testid="block-images"] tbody tr:not(.filler)').nth(image);
  await row(0).click();
  await says(page, 'block-remove-image', /^Remove image$/);
  await row(5).click({ modifiers: ['Control'] });
  await says(page, 'block-remove-image', /^Remove 2 images$/);
  await says(page, 'block-chosen', /^2 images: /);
  await part(page, 'block-remove-image').click();
  await status(page, /^(Oriented|Weak orientation): 4 of 4 images/);
  await page.waitForFunction(() => document.querySelector('[data-testid="block-undo"]')?.getAttribute('title')?.startsWith('Undo: remove 2 images'));
  await page.keyboard.press('Control+z');
  await status(page, /^(Oriented|Weak orientation): 6 of 6 images/);
  assert.match(await says(page, 'stage-pairs', /15 of 15/), /15 of 15, 15 from an earlier run/);
  assert.deepEqual(complaints, []);
  await close();
});
