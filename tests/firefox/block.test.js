/** A block in Firefox: it runs, is kept and edited, and comes out as it does from the command. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { block, photos, status } from '../page/blocks.js';
import { keptEdits, part, partsNamed, saved, until } from '../page/page.js';
import { hostedInFirefox, SKIP } from './firefox.js';

hostedInFirefox('/');

/** The block as a project file.  @param {import('playwright-core').Page} page */
async function project(page) {
  await part(page, 'block-export-kind').selectOption('project');
  return (await saved(page, 'block-export')).toString();
}

test('a block of photographs is oriented and kept; an image is rejected, and that undone after a reload, to the byte', { skip: SKIP }, async () => {
  const { page, complaints, close } = await block();
  await photos(page);
  await part(page, 'block-run').click();
  const line = await status(page, /^(?:Oriented|Weak orientation): /);
  const found = await project(page);
  await until(page, 'it is kept', async () => (await partsNamed(page, 'block/shown')) > 0);
  await page.reload();
  assert.equal(await status(page, /Restored from this browser/), `${line} Restored from this browser: photo_00000.png and 5 more images.`);
  await part(page, 'block-map').focus();
  await page.keyboard.press('n');
  await page.keyboard.press('Delete');
  await status(page, /: 5 of 6 images/);
  await keptEdits(page, 'block/edits', 1, 1);
  await page.reload();
  await status(page, /: 5 of 6 images/);
  await page.keyboard.press('Control+z');
  await status(page, /: 6 of 6 images/);
  assert.equal(await project(page), found);
  assert.deepEqual(complaints, []);
  await close();
});
