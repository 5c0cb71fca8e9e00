/** What was found and what was done by hand outlives what is pressed and dropped beside it. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { block, FLIGHT, status } from './blocks.js';
import { hosted, part, says, SKIP, upload } from './page.js';
import { blockPhotos } from './rendered.js';

hosted('/nothing-lost/');

/** Waits until undo would take back this.  @param {import('playwright-core').Page} page @param {string} name */
const undoIs = (page, name) =>
  page.waitForFunction((wanted) => document.querySelector('[data-testid="block-undo"]')?.getAttribute('title') === `Undo: ${wanted} (Ctrl+Z)`, name);

const ALL = /^(Oriented|Weak orientation): 6 of 6 images/;

test('a block of photographs stays under Projects, keeps its edits through a run, and has them back with an image that was taken out', {
  skip: SKIP,
}, async () => {
  const { page, complaints, close } = await block({ options: { viewport: { width: 1366, height: 768 } } });
  const run = async () => {
    await part(page, 'block-files-input').setInputFiles(blockPhotos(FLIGHT).map(({ name, bytes }) => upload(name, bytes, 'image/png')));
    await status(page, /6 images in the block/);
    await part(page, 'block-run').click();
    await status(page, ALL);
  };
  await run();

  // It was not edited: it is kept all the same.
  await part(page, 'block-clear').click();
  await status(page, /The oriented block stays under Projects\./);
  await part(page, 'projects').click();
  await page.locator('[data-testid="project"]:not([aria-current]) .link').first().click();
  await status(page, ALL);
  await part(page, 'block-clear').click();
  await run();

  await part(page, 'tab-block-points').click();
  await page.locator('[data-testid="block-points"] tbody tr:not(.filler)').first().click();
  await page.keyboard.press('Delete');
  await undoIs(page, 'reject 1 point');
  // It is called as the line under the map calls it.
  const chosen = await says(page, 'block-chosen', /rejected by hand/);
  await part(page, 'tab-block-edits').click();
  const [name] = /point [\d,]+/.exec((await part(page, 'block-rejected').textContent()) ?? '') ?? [''];
  assert.ok(name !== '' && chosen.startsWith(name), `${name}: ${chosen}`);

  // What is no cameras changes nothing, and is said.
  const give = (/** @type {string} */ name, /** @type {string} */ text) =>
    part(page, 'block-files-input').setInputFiles([upload(name, Buffer.from(text), 'application/json')]);
  await give('tiepoint-block-settings.json', '{"tiepoint_settings": "block", "changed": {}}');
  await status(page, /tiepoint-block-settings\.json holds settings: load it under Settings\. It is put aside\./);
  await give('other.json', '{"a": 1}');
  await status(page, /^(Oriented|Weak orientation).*other\.json: .* It holds no cameras and is put aside\./);

  // The same block again.
  await part(page, 'block-run').click();
  await status(page, /1 edit by hand was kept\./);
  await undoIs(page, 'reject 1 point');

  await part(page, 'block-map').focus();
  await page.keyboard.press('n');
  await part(page, 'block-remove-image').click();
  await status(page, /: 5 of 5 images/);
  await undoIs(page, 'remove 1 image');
  await page.keyboard.press('Control+z');
  await status(page, ALL);
  await undoIs(page, 'reject 1 point');
  assert.deepEqual(complaints, []);
  await close();
});
